//! How a section answers to strain: by its resultants, if it is elastic, or at points through its thickness.

use super::layers::Layers;
use super::material::ShellMaterial;
use super::section::{ElasticSection, Section};
use crate::material::Numbers;
use clubface_math::Pack;

/// The response of the sections of a patch.
pub enum Response<'a, P> {
    /// By stress resultants.
    Elastic,
    /// At points through the thickness.
    Points(Layers<'a, P>),
}

impl<'a, P: Pack> Response<'a, P> {
    /// Response of a material with points through the thickness (places from -1 to 1, weights whose sum is 2), or none.
    #[inline(always)]
    pub fn new(points: &'a [(f64, f64)], material: &ShellMaterial<P::Real>) -> Self {
        if points.is_empty() { Self::Elastic } else { Self::Points(Layers::new(points, material)) }
    }
    /// Plane stress on the outer and the inner side, Pa, and the largest equivalent plastic strain.
    #[inline(always)]
    pub fn sides(&self, section: &Section<P>, state: &Numbers<P::Real>) -> ([[P; 3]; 2], P) {
        match self {
            Self::Elastic => ElasticSection::sides(section, state),
            Self::Points(layers) => layers.sides(state),
        }
    }
    /// Elastic energy of membrane and bending over an area, and the work that plastic flow has turned into heat, J.
    #[inline(always)]
    pub fn energy(&self, section: &Section<P>, area: P, state: &Numbers<P::Real>) -> (P, P) {
        match self {
            Self::Elastic => ElasticSection::energy(section, area, state),
            Self::Points(layers) => layers.energy(section, area, state),
        }
    }
}
