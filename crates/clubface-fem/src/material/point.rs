//! A material at a single point, driven by its deformation gradient: what tests and other programs ask of it, by the
//! stages that the elements use.

use super::body::Material;
use super::deformation::{Deformation, Kinematics};
use super::stage::{EnergyPoints, PointEnergy, Points};
use super::state_variables::{StateVariables, Update};
use super::symmetric::{Symmetric, times};
use super::table::Number;
use clubface_math::{Mat3, Real};

/// A point of a material.
pub struct MaterialPoint<R: Real> {
    material: Material<R>,
    state: StateVariables<R>,
}

impl<R: Number> MaterialPoint<R> {
    /// Before any deformation.
    pub fn new(material: &Material<R>) -> Self {
        Self { material: material.clone(), state: material.state(1) }
    }
    /// First Piola-Kirchhoff stress (Pa) at a deformation gradient, after a step of `dt` seconds to it.
    pub fn update(&mut self, f: &Mat3<R>, dt: f64) -> Mat3<R> {
        let at = Deformation::new(*f);
        let mut stresses = [Symmetric::diagonal(R::zero())];
        let mut points = Points {
            lane: 0,
            step: 0,
            state: &mut self.state,
            deformations: &[at],
            pressures: &[self.material.bulk * (at.volume - 1.0)],
            weights: &[R::one()],
            stresses: &mut stresses,
        };
        self.material.stage::<R>(Update { dt, add_work: true }).stress(&mut points);
        times(f, &stresses[0])
    }
    /// Energies at a deformation gradient, that of the change of volume among the elastic ones, J/m3.
    pub fn energy(&mut self, f: &Mat3<R>) -> PointEnergy<R> {
        let at = Kinematics::new(*f);
        let mut energies = [PointEnergy::zero()];
        let stage = self.material.stage::<R>(Update { dt: 0.0, add_work: false });
        stage.energy(&mut EnergyPoints {
            lane: 0,
            step: 0,
            state: &mut self.state,
            c: &[at.c],
            volumes: &[at.deformation.volume],
            energies: &mut energies,
        });
        let [mut energy] = energies;
        let dilation = at.deformation.volume - 1.0;
        energy.strain += self.material.bulk * dilation * dilation * 0.5;
        energy
    }
    /// Equivalent plastic strain.
    pub fn plastic_strain(&mut self) -> R {
        let mut strain = R::zero();
        let stage = self.material.stage::<R>(Update { dt: 0.0, add_work: false });
        stage.plastic_strain(&mut self.state, 0, &mut strain);
        strain
    }
}
