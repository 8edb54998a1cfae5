//! The ten-node tetrahedron with four integration points, in total Lagrangian form (Zienkiewicz and Taylor, The Finite
//! Element Method, volume 1). Its strain is linear, so that one of them bends as a wall does, and four points leave it
//! no mode without energy. Straight edges are not assumed.

use crate::element::point::{POINT, Point, put_point};
use crate::mesh::{EDGES, OTHER, OWN, TET_NODES, WEIGHT, between, tet_base};
use clubface_math::{Mat3, Pack, Scalar, Vec3};

/// Points of integration.
pub const POINTS: usize = 4;
/// Constants an element keeps.
pub const CONSTANTS: usize = POINT * POINTS;

/// Constants of an element from its nodes.
pub fn constants<R: Scalar>(nodes: &[Vec3<R>; TET_NODES]) -> [R; CONSTANTS] {
    let mut c = [R::zero(); CONSTANTS];
    for (point, values) in c.chunks_exact_mut(POINT).enumerate() {
        put_point(tet_base(nodes, point), WEIGHT, values);
    }
    c
}

/// Base vectors at all points, one element a lane.
#[inline(always)]
pub fn base_at_points<P: Scalar>(nodes: &[Vec3<P>; TET_NODES]) -> [[Vec3<P>; 3]; POINTS] {
    let mut base = [[Vec3::zero(); 3]; POINTS];
    for point in 0..POINTS {
        base[point] = tet_base(nodes, point);
    }
    base
}

/// Sum over the points of what acts on the derivatives by the barycentric coordinates.
pub struct Forces<P> {
    on: [Vec3<P>; TET_NODES],
}

impl<P: Pack> Forces<P> {
    /// None yet.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { on: [Vec3::zero(); TET_NODES] }
    }
    /// Adds the first Piola-Kirchhoff stress times the share of the volume at a point, J.
    #[inline(always)]
    pub fn add_stress(&mut self, point: usize, constants: &Point<P>, stress: &Mat3<P>) {
        let [s1, s2, s3] = constants.gradients.map(|g| *stress * g);
        let slopes = [-(s1 + s2 + s3), s1, s2, s3];
        for i in 0..4 {
            let own = if i == point { OWN } else { OTHER };
            self.on[i] += slopes[i] * P::from_f64(4.0 * own - 1.0);
        }
        for [i, j] in EDGES {
            let at = |corner: usize| P::from_f64(4.0 * if corner == point { OWN } else { OTHER });
            self.on[between(i, j)] += slopes[i] * at(j) + slopes[j] * at(i);
        }
    }
    /// On the nodes, N.
    #[inline(always)]
    pub fn nodes(&self) -> [Vec3<P>; TET_NODES] {
        self.on.map(|force| -force)
    }
}
