//! Ratios of current to reference volume, which tell whether the laws hold.

use super::patch::RATIOS;
use clubface_math::Pack;

/// Smallest and largest ratio of current to reference volume of some elements.
#[derive(Clone, Copy)]
pub struct Ratios<P> {
    least: P,
    most: P,
}

impl<P: Pack> Ratios<P> {
    /// Of undeformed elements.
    #[inline(always)]
    pub fn new() -> Self {
        Self { least: P::one(), most: P::one() }
    }
    /// With those of a pack.
    #[inline(always)]
    pub fn and(self, ratio: P) -> Self {
        Self { least: self.least.min(ratio), most: self.most.max(ratio) }
    }
    /// Whether the laws hold for all of them.
    #[inline(always)]
    pub fn valid(self) -> bool {
        (0..P::LANES).all(|lane| self.least.lane(lane) >= RATIOS.0 && self.most.lane(lane) <= RATIOS.1)
    }
    /// Both, of all lanes.
    #[inline(always)]
    pub fn range(self) -> (f64, f64) {
        (0..P::LANES).fold((1.0, 1.0), |(least, most): (f64, f64), lane| {
            (least.min(self.least.lane(lane)), most.max(self.most.lane(lane)))
        })
    }
}
