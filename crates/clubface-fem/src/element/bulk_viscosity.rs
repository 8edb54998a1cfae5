//! Linear bulk viscosity: a pressure against fast changes of volume, which damps what rings from element to element
//! (Landshoff's of 1955, as described by Benson, Comput. Methods Appl. Mech. Eng. 99, 1992).

use crate::block::BLOCK;
use crate::material::Material;
use clubface_math::{Pack, Real};

/// What the elements of a patch need for it.
pub struct BulkViscosity<R> {
    /// Pressure for a ratio of volumes that grows by one in a second, Pa s.
    drag: R,
    /// Ratios of current to reference volume in the last step, and work done since then, J/m3, by block and lane.
    ratios: Vec<R>,
    work: Vec<R>,
}

impl<R: Real> BulkViscosity<R> {
    /// For blocks of undeformed elements of a material, whose mean `size` (m) a wave crosses: `coefficient` times
    /// density, speed of waves and size.
    pub fn new(coefficient: f64, material: &Material<R>, size: f64, blocks: usize) -> Self {
        let stiffness = material.bulk + material.instantaneous_shear() * (4.0 / 3.0);
        let drag = (stiffness * material.density).sqrt() * (coefficient * size);
        Self { drag, ratios: vec![R::one(); blocks * BLOCK], work: vec![R::zero(); blocks * BLOCK] }
    }

    /// The pressure (Pa, positive in tension) for the ratios of volumes of a pack from a lane on, over all blocks; a step of `dt`
    /// seconds has passed.
    #[inline(always)]
    pub fn pressure<P: Pack<Real = R>>(&mut self, at: usize, ratio: P, dt: f64) -> P {
        let growth = ratio - P::load(&self.ratios[at..]);
        let pressure = P::splat(self.drag) * growth * (1.0 / dt);
        (P::load(&self.work[at..]) + pressure * growth).store(&mut self.work[at..]);
        ratio.store(&mut self.ratios[at..]);
        pressure
    }

    /// Work done in a pack from a lane on, J/m3.
    #[inline(always)]
    pub fn work<P: Pack<Real = R>>(&self, at: usize) -> P {
        P::load(&self.work[at..])
    }
}

/// It in a step of some seconds.
pub struct Drag<'a, R> {
    /// What the patch has.
    pub viscosity: &'a mut BulkViscosity<R>,
    /// The step, s.
    pub dt: f64,
}

impl<R: Real> Drag<'_, R> {
    /// As [`BulkViscosity::pressure`].
    #[inline(always)]
    pub fn pressure<P: Pack<Real = R>>(&mut self, at: usize, ratio: P) -> P {
        self.viscosity.pressure(at, ratio, self.dt)
    }
}

/// The stable step of damped elements over that of free ones: `sqrt(1 + x^2) - x` for the share x of critical damping
/// in their fastest vibration. In that of cubes, which breathe in turns, it is the square root of three times the
/// coefficient.
#[must_use]
pub fn damped_step_ratio(coefficient: f64) -> f64 {
    let share = coefficient * 3.0_f64.sqrt();
    share.hypot(1.0) - share
}
