//! What golfers and designers ask of impacts and flights: the shots of a golfer, where they go, what they cost; a face
//! struck everywhere; which heads can be built.

pub mod dispersion;
pub mod face_map;
pub mod feasibility;
pub mod golfer;
pub mod normal;
pub mod outline;
pub mod sequence;
mod shot_batch;
pub mod strokes;
pub mod tally;

fn slices(columns: &mut [Vec<f64>]) -> Vec<&mut [f64]> {
    columns.iter_mut().map(Vec::as_mut_slice).collect()
}
