//! Meshes of hexahedra.

use clubface_math::{Scalar, Vec3};

/// Number of corners of a hexahedron. They are in binary order: bit 0 of a corner's number is the sign of its first
/// reference coordinate, bit 1 of the second, bit 2 of the third. The usual order (round the bottom, then round the
/// top) exchanges corners 2 and 3, and 6 and 7.
pub const CORNERS: usize = 8;

/// Hexahedra, each belonging to a layer (the piece of the ball it is made of).
#[derive(Clone, Debug)]
pub struct SolidMesh<R = f64> {
    /// Node positions, m.
    pub nodes: Vec<Vec3<R>>,
    /// Corner nodes of each element, in binary order.
    pub elements: Vec<[u32; CORNERS]>,
    /// Layer of each element, 0 innermost; elements of a layer are consecutive.
    pub layer: Vec<u32>,
}

impl<R: Scalar> SolidMesh<R> {
    /// Corner positions of an element, m.
    #[must_use]
    pub fn corners(&self, element: usize) -> [Vec3<R>; CORNERS] {
        self.elements[element].map(|n| self.nodes[n as usize])
    }
    /// Volume of an element by its eight-point quadrature, m3.
    #[must_use]
    pub fn volume(&self, element: usize) -> R {
        let corners = self.corners(element);
        let at = 1.0 / 3.0_f64.sqrt();
        (0..CORNERS).fold(R::zero(), |sum, point| sum + jacobian(&corners, signs(point).map(|s| s * at)))
    }
    /// Quadrilaterals that belong to one element only, seen from outside in counterclockwise order.
    #[must_use]
    pub fn surface(&self) -> Vec<[u32; 4]> {
        // Sides of the reference cube, each counterclockwise from outside.
        const SIDES: [[usize; 4]; 6] =
            [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        let mut sides = std::collections::HashMap::new();
        for (e, element) in self.elements.iter().enumerate() {
            for (s, side) in SIDES.iter().enumerate() {
                let quad = side.map(|corner| element[corner]);
                let mut key = quad;
                key.sort_unstable();
                sides.entry(key).and_modify(|entry: &mut (usize, [u32; 4], u32)| entry.2 += 1).or_insert((
                    e * 6 + s,
                    quad,
                    1,
                ));
            }
        }
        let mut outer: Vec<_> = sides.into_values().filter(|entry| entry.2 == 1).collect();
        outer.sort_unstable_by_key(|entry| entry.0);
        outer.into_iter().map(|entry| entry.1).collect()
    }
}

/// Signs of a corner's reference coordinates.
#[must_use]
pub fn signs(corner: usize) -> [f64; 3] {
    [0, 1, 2].map(|axis| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 })
}

/// Base vectors of the trilinear map at a reference point, m.
#[must_use]
pub fn base_vectors<R: Scalar>(corners: &[Vec3<R>; CORNERS], at: [f64; 3]) -> [Vec3<R>; 3] {
    let mut base = [Vec3::zero(); 3];
    for (corner, position) in corners.iter().enumerate() {
        let s = signs(corner);
        for axis in 0..3 {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            let slope = s[axis] * (1.0 + s[j] * at[j]) * (1.0 + s[k] * at[k]) / 8.0;
            base[axis] += *position * R::from_f64(slope);
        }
    }
    base
}

/// Determinant of the trilinear map at a reference point, m3.
#[must_use]
pub fn jacobian<R: Scalar>(corners: &[Vec3<R>; CORNERS], at: [f64; 3]) -> R {
    let [a, b, c] = base_vectors(corners, at);
    a.dot(b.cross(c))
}
