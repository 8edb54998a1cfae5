//! Numbers of eight elements side by side, as packs read them.

/// Elements a block holds, whatever the width of the packs that read it.
pub const BLOCK: usize = 8;

/// Numbers that stand on a boundary of the cache's lines, so that no pack straddles two.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Aligned<A>(pub A);
