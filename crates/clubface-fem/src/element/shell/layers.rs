//! The section of a shell as points through its thickness, each in plane stress.

use super::material::ShellMaterial;
use super::quadrilateral::Increment;
use super::section::{ACROSS, Section, SectionResponse};
use crate::material::{Hardening, Numbers, PlaneState, PlaneStress};
use clubface_math::{Pack, Real};

/// Where the work that became heat stands, J, and where the points begin.
const HEAT: usize = ACROSS;
const POINTS: usize = HEAT + 1;
/// Numbers a point takes: stress, equivalent plastic strain, yield stress.
const POINT: usize = 5;

/// Points through the thickness.
pub struct Layers<'a, P> {
    points: &'a [(f64, f64)],
    metal: PlaneStress<P>,
}

impl<R: Real> Layers<'_, R> {
    /// Numbers of state of an element at rest.
    pub fn start(points: usize, hardening: Option<&Hardening<R>>) -> Vec<R> {
        let mut numbers = vec![R::zero(); POINTS];
        let yields = hardening.map_or_else(|| Hardening::elastic().initial(), Hardening::initial);
        for _ in 0..points {
            let [stress, none] = [R::zero(); 2];
            numbers.extend([stress, stress, stress, none, yields]);
        }
        numbers
    }
}

impl<'a, P: Pack> Layers<'a, P> {
    /// Points (places from -1 to 1, weights whose sum is 2) of a metal.
    #[inline(always)]
    pub fn new(points: &'a [(f64, f64)], material: &ShellMaterial<P::Real>) -> Self {
        let elastic = material.elastic.splat::<P>();
        let hardening = material.hardening.unwrap_or_else(Hardening::elastic).splat();
        Self { points, metal: PlaneStress::new(elastic.young, elastic.poisson, hardening) }
    }
}

#[inline(always)]
fn at_point<P: Pack>(state: &Numbers<P::Real>, point: usize) -> PlaneState<P> {
    let [x, y, xy, plastic_strain, yield_stress] = state.load(POINTS + POINT * point);
    PlaneState { stress: [x, y, xy], plastic_strain, yield_stress }
}

impl<P: Pack> SectionResponse<P> for Layers<'_, P> {
    #[inline(always)]
    fn respond(
        &self,
        section: &Section<P>,
        increment: &Increment<P>,
        area: P,
        state: &mut Numbers<P::Real>,
    ) -> [[P; 3]; 2] {
        let half = section.thickness * 0.5;
        let (mut membrane, mut bending) = ([P::zero(); 3], [P::zero(); 3]);
        let mut heat = P::zero();
        for (point, &(place, weight)) in self.points.iter().enumerate() {
            let (z, share) = (half * place, half * weight);
            let mut strain = increment.membrane;
            for i in 0..3 {
                strain[i] = z.mul_add(increment.curvature[i], strain[i]);
            }
            let mut at = at_point(state, point);
            heat += share * self.metal.advance(&strain, &mut at);
            for i in 0..3 {
                let force = share.product(at.stress[i]);
                membrane[i] += force;
                bending[i] = z.mul_add(force, bending[i]);
            }
            let [x, y, xy] = at.stress;
            state.store(POINTS + POINT * point, [x, y, xy, at.plastic_strain, at.yield_stress]);
        }
        let [before]: [P; 1] = state.load(HEAT);
        state.store(HEAT, [before + heat * area]);
        [membrane, bending]
    }
}

impl<P: Pack> Layers<'_, P> {
    /// See [`super::response::Response::sides`].
    #[inline(always)]
    pub fn sides(&self, state: &Numbers<P::Real>) -> ([[P; 3]; 2], P) {
        // Points go from the inner side to the outer.
        let mut plastic = P::zero();
        for point in 0..self.points.len() {
            plastic = plastic.max(at_point(state, point).plastic_strain);
        }
        let [outer, inner] = [self.points.len() - 1, 0].map(|point| at_point(state, point).stress);
        ([outer, inner], plastic)
    }

    /// See [`super::response::Response::energy`].
    #[inline(always)]
    pub fn energy(&self, section: &Section<P>, area: P, state: &Numbers<P::Real>) -> (P, P) {
        let mut density = P::zero();
        for (point, &(_, weight)) in self.points.iter().enumerate() {
            density += section.energy(&at_point(state, point).stress) * P::from_f64(0.5 * weight);
        }
        let [plastic] = state.load(HEAT);
        (density * section.thickness * area, plastic)
    }
}
