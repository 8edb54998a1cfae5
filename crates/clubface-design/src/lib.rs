//! What golfers and designers ask of impacts and flights: the shots of a golfer, where they go, what they cost.

pub mod dispersion;
pub mod golfer;
pub mod normal;
pub mod sequence;
pub mod strokes;
pub mod tally;
