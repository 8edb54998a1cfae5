//! Meshes of ten-node tetrahedra.

use clubface_math::{Scalar, Vec3};

/// Nodes of a tetrahedron: four corners, then one on each of [`EDGES`].
pub const TET_NODES: usize = 10;
/// Corners at the ends of the edges, in the order of Abaqus, Nastran, LS-DYNA and VTK.
pub const EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
/// Barycentric coordinate of an integration point for its own corner, `(5 + 3 sqrt 5) / 20`, and for the others: the
/// rule of four points is exact for polynomials of second degree (Hammer, Marlowe and Stroud, 1956).
pub const OWN: f64 = 0.585_410_196_624_968_5;
/// See [`OWN`].
pub const OTHER: f64 = 0.138_196_601_125_010_5;
/// Volume of the reference coordinates that each of the four points stands for.
pub const WEIGHT: f64 = 1.0 / 24.0;

/// Place in an element of the node between two corners.
#[must_use]
pub const fn between(i: usize, j: usize) -> usize {
    const PLACES: [[usize; 4]; 4] = [[0, 4, 6, 7], [4, 1, 5, 8], [6, 5, 2, 9], [7, 8, 9, 3]];
    PLACES[i][j]
}

/// Derivatives of the position by the barycentric coordinates at an integration point, each taken as a variable by
/// itself, m. The point lies near the corner of its number.
#[inline(always)]
fn slopes<R: Scalar>(x: &[Vec3<R>; TET_NODES], point: usize) -> [Vec3<R>; 4] {
    let mut slopes = [Vec3::zero(); 4];
    for i in 0..4 {
        let own = if i == point { OWN } else { OTHER };
        let mut sum = x[i] * R::from_f64(own - 0.25);
        for j in (0..4).filter(|&j| j != i) {
            sum += x[between(i, j)] * R::from_f64(if j == point { OWN } else { OTHER });
        }
        slopes[i] = sum * R::from_f64(4.0);
    }
    slopes
}

/// Base vectors along the edges from corner 0 at an integration point, m.
#[inline(always)]
#[must_use]
pub fn tet_base<R: Scalar>(x: &[Vec3<R>; TET_NODES], point: usize) -> [Vec3<R>; 3] {
    let [a, b, c, d] = slopes(x, point);
    [b - a, c - a, d - a]
}

/// Parts of the volume at the four integration points, m3; one that is not positive is of an inverted element.
#[must_use]
pub fn tet_volumes<R: Scalar>(x: &[Vec3<R>; TET_NODES]) -> [R; 4] {
    [0, 1, 2, 3].map(|point| {
        let [u, v, w] = tet_base(x, point);
        u.dot(v.cross(w)) * R::from_f64(WEIGHT)
    })
}

/// Share of the mass of an element that each of its nodes gets: in the ratio of the diagonal of the consistent matrix
/// (Hinton, Rock and Zienkiewicz, Earthquake Eng. Struct. Dyn. 4, 1976), since sums of its rows are negative at
/// corners.
#[must_use]
pub const fn mass_share(node: usize) -> f64 {
    if node < 4 { 1.0 / 36.0 } else { 4.0 / 27.0 }
}
