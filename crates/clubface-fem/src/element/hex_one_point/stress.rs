//! Stress at the integration points of packs of elements, however the elements find their nodes: the pressure here,
//! the change of shape by the stage of the material.

use super::constants::{Constants, Shape};
use super::passes::{in_passes, part, set_part};
use crate::element::bulk_viscosity::Drag;
use crate::element::patch::Ratios;
use crate::material::{Deformation, Points, StateVariables, StressStage, Symmetric};
use clubface_math::{Mat3, Pack, Part};

/// Most packs of a run.
pub const RUN: usize = 3;

/// What the stress of elements follows from.
pub struct Stress<'a, P: Pack> {
    /// Stage of the material in this step.
    pub stage: &'a dyn StressStage<P>,
    /// Bulk modulus, Pa.
    pub bulk: P,
    /// State variables of all blocks.
    pub state: &'a mut StateVariables<P::Real>,
    /// Bulk viscosity, if there is any.
    pub drag: Option<Drag<'a, P::Real>>,
    /// Smallest and largest ratio of volumes so far.
    pub ratios: Ratios<P>,
}

/// Packs one after the other: up through the layers of a lattice, or as they stand in their blocks.
pub struct Run<P> {
    deformations: [Deformation<P>; RUN],
    weights: [P; RUN],
    pressures: [P; RUN],
    /// Second Piola-Kirchhoff stresses (Pa) times minus the reference volumes (m3).
    pub stresses: [Symmetric<P>; RUN],
}

impl<P: Pack> Run<P> {
    /// Nothing yet.
    #[inline(always)]
    pub fn new() -> Self {
        Self {
            deformations: [Deformation::new(Mat3::diagonal(P::one())); RUN],
            weights: [P::zero(); RUN],
            pressures: [P::zero(); RUN],
            stresses: [Symmetric::diagonal(P::zero()); RUN],
        }
    }
}

impl<P: Pack> Stress<'_, P> {
    /// Sets the gradient and the reference volume (m3) of a pack, whose lanes begin with one counted over all blocks.
    #[inline(always)]
    pub fn set(&mut self, run: &mut Run<P>, index: usize, lane: usize, gradient: Mat3<P>, volume: P) {
        let deformation = Deformation::new(gradient);
        let ratio = deformation.volume;
        self.ratios = self.ratios.and(ratio);
        let mut pressure = self.bulk * (ratio - 1.0);
        if let Some(drag) = &mut self.drag {
            pressure += drag.pressure(lane, ratio);
        }
        run.deformations[index] = deformation;
        run.pressures[index] = pressure;
        run.weights[index] = -volume;
    }

    /// Stresses of the first `count` packs of a run, which begins with a lane, counted over all blocks; the next packs
    /// begin `step` lanes further. State variables move on by a step.
    #[inline(always)]
    pub fn compute(&mut self, run: &mut Run<P>, count: usize, lane: usize, step: usize) {
        self.stage.stress(&mut Points {
            lane,
            step,
            state: self.state,
            deformations: &run.deformations[..count],
            pressures: &run.pressures[..count],
            weights: &run.weights[..count],
            stresses: &mut run.stresses[..count],
        });
    }
}

/// A second Piola-Kirchhoff stress (Pa, times minus the volume) seen from the base vectors, `G^T S G` where the
/// gradient is their matrix times `G^T`: the force on each is the sum of all with these factors, N/m.
#[inline(always)]
pub fn on_bases<P: Pack, const SLOPES: bool>(
    constants: &Constants<P::Real, SLOPES>,
    second: &Symmetric<P>,
) -> Symmetric<P> {
    let mut seen = *second;
    in_passes!(P::Real, |pass| if constants.size_varies(pass) {
        let parts = part_on_bases::<P, P::Pair>(&constants.shape(pass), part(&second.0, pass));
        set_part(&mut seen.0, pass, &parts);
    } else {
        let parts = part_on_bases::<P, P::Value>(&constants.shape(pass), part(&second.0, pass));
        set_part(&mut seen.0, pass, &parts);
    });
    seen
}

/// One pass of it.
#[inline(always)]
fn part_on_bases<P: Pack, G: Part<P>>(shape: &Shape<P, G>, second: [G; 6]) -> [G; 6] {
    let ([rx, ry, rz], [sy, sz], tz) = shape.inverse();
    let [xx, yy, zz, xy, xz, yz] = second;
    let [ax, ay, az] = [
        xz.mul_add(rz, xy.mul_add(ry, xx.product(rx))),
        yz.mul_add(rz, yy.mul_add(ry, xy.product(rx))),
        zz.mul_add(rz, yz.mul_add(ry, xz.product(rx))),
    ];
    let (by, bz) = (yz.mul_add(sz, yy.product(sy)), zz.mul_add(sz, yz.product(sy)));
    [
        az.mul_add(rz, ay.mul_add(ry, ax.product(rx))),
        bz.mul_add(sz, by.product(sy)),
        zz.product(tz).product(tz),
        az.mul_add(sz, ay.product(sy)),
        az.product(tz),
        bz.product(tz),
    ]
}
