//! The eight-node hexahedron with eight integration points and one pressure, in total Lagrangian form.
//!
//! Changes of shape are taken at the eight points of Gauss, the change of volume on the average over the element,
//! which keeps nearly incompressible rubber from locking (Nagtegaal, Parks and Rice, Comput. Methods Appl. Mech. Eng.
//! 4, 1974; Simo, Taylor and Pister, ibid. 51, 1985). With laws split into shape and volume it is the F-bar element
//! of the mean dilatation, and its forces derive from an energy. It needs no hourglass control and costs several
//! times the one-point element.

use crate::element::point::{POINT, Point, plus, put_point};
use crate::material::{cross, dot};
use crate::mesh::{CORNERS, base_vectors, signs};
use clubface_math::{Mat3, Scalar, Vec3};

/// Points of integration.
pub const POINTS: usize = 8;
/// Constants an element keeps.
pub const CONSTANTS: usize = POINT * POINTS;

/// Reference coordinate of the points, `1/sqrt(3)`.
const AT: f64 = 0.577_350_269_189_625_8;
/// Shares of the near and the far end in the value at a point of a line.
const NEAR: f64 = 0.5 + 0.5 * AT;
const FAR: f64 = 0.5 - 0.5 * AT;

/// Constants of an element from its corners.
pub fn constants<R: Scalar>(corners: &[Vec3<R>; CORNERS]) -> [R; CONSTANTS] {
    let mut c = [R::zero(); CONSTANTS];
    for (point, values) in c.chunks_exact_mut(POINT).enumerate() {
        put_point(base_vectors(corners, signs(point).map(|s| s * AT)), 1.0, values);
    }
    c
}

/// Base vectors along one reference coordinate: four, since they vary with the other two alone.
type Along<P> = [Vec3<P>; 4];

/// Corner at one end of an edge: `edge` holds the bits of the two coordinates that follow `axis`.
#[inline(always)]
const fn corner(axis: usize, edge: usize, end: usize) -> usize {
    end << axis | (edge & 1) << ((axis + 1) % 3) | (edge >> 1) << ((axis + 2) % 3)
}

/// Edge along `axis` whose base vector point `point` has.
#[inline(always)]
const fn edge(axis: usize, point: usize) -> usize {
    point >> ((axis + 1) % 3) & 1 | (point >> ((axis + 2) % 3) & 1) << 1
}

/// From the edges to the points, and back for forces: the map is symmetric.
#[inline(always)]
fn spread<P: Scalar>(v: &mut Along<P>) {
    for (low, high) in [(0, 1), (2, 3), (0, 2), (1, 3)] {
        let (a, b) = (v[low], v[high]);
        v[low] = weighted(a, b);
        v[high] = weighted(b, a);
    }
}

#[inline(always)]
fn weighted<P: Scalar>(near: Vec3<P>, far: Vec3<P>) -> Vec3<P> {
    let (n, f) = (P::from_f64(NEAR), P::from_f64(FAR));
    Vec3::new(near.x.mul_add(n, far.x * f), near.y.mul_add(n, far.y * f), near.z.mul_add(n, far.z * f))
}

/// One element a lane: current base vectors at the points.
pub struct Hexahedron<P> {
    base: [Along<P>; 3],
}

impl<P: Scalar> Hexahedron<P> {
    /// From the positions of the corners.
    #[inline(always)]
    pub fn new(corners: &[Vec3<P>; CORNERS]) -> Self {
        let mut base = [[Vec3::zero(); 4]; 3];
        let half = P::from_f64(0.5);
        for axis in 0..3 {
            for e in 0..4 {
                base[axis][e] = (corners[corner(axis, e, 1)] - corners[corner(axis, e, 0)]) * half;
            }
            spread(&mut base[axis]);
        }
        Self { base }
    }
    /// Base vectors at a point.
    #[inline(always)]
    pub fn base(&self, point: usize) -> [Vec3<P>; 3] {
        let [x, y, z] = &self.base;
        [x[edge(0, point)], y[edge(1, point)], z[edge(2, point)]]
    }
    /// Current volume, m3.
    #[inline(always)]
    pub fn volume(&self) -> P {
        let mut sum = P::zero();
        for point in 0..POINTS {
            let [a, b, c] = self.base(point);
            sum += dot(a, cross(b, c));
        }
        sum
    }
}

/// Sum over the points of what acts on their base vectors.
pub struct Forces<P> {
    base: [Along<P>; 3],
}

impl<P: Scalar> Forces<P> {
    /// None yet.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { base: [[Vec3::zero(); 4]; 3] }
    }
    /// Adds the first Piola-Kirchhoff stress (Pa) at a point.
    #[inline(always)]
    pub fn add_stress(&mut self, point: usize, constants: &Point<P>, stress: &Mat3<P>) {
        let [r, s, t] = stress.rows;
        for axis in 0..3 {
            let direction = constants.gradients[axis] * constants.volume;
            let on = &mut self.base[axis][edge(axis, point)];
            *on = Vec3::new(dot(r, direction) + on.x, dot(s, direction) + on.y, dot(t, direction) + on.z);
        }
    }
    /// Adds a pressure (Pa, positive in tension) that acts on the volume of the element.
    #[inline(always)]
    pub fn add_pressure(&mut self, element: &Hexahedron<P>, pressure: P) {
        for point in 0..POINTS {
            let base = element.base(point);
            for axis in 0..3 {
                let on = &mut self.base[axis][edge(axis, point)];
                *on = plus(*on, pressure, cross(base[(axis + 1) % 3], base[(axis + 2) % 3]));
            }
        }
    }
    /// On the corners, N.
    #[inline(always)]
    pub fn corners(mut self) -> [Vec3<P>; CORNERS] {
        let mut forces = [Vec3::zero(); CORNERS];
        let half = P::from_f64(0.5);
        for axis in 0..3 {
            spread(&mut self.base[axis]);
            for e in 0..4 {
                let force = self.base[axis][e] * half;
                forces[corner(axis, e, 0)] += force;
                forces[corner(axis, e, 1)] = forces[corner(axis, e, 1)] - force;
            }
        }
        forces
    }
}
