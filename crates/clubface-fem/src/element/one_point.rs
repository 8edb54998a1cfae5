//! The eight-node hexahedron with one integration point, in total Lagrangian form, with physical hourglass control.
//!
//! Positions are taken apart into eight modes by sums and differences: one of translation, three of uniform deformation (the base vectors
//! at the centre), four of bending (hourglass), to which one point is blind (Flanagan and Belytschko, Int. J. Numer. Methods Eng. 17,
//! 1981). The hourglass modes get the stiffness that a rectangular, incompressible block of the element's size has in bending, shear and
//! torsion, without bulk stiffness (after Belytschko and Bindeman, Comput. Methods Appl. Mech. Eng. 105, 1993), as an energy of the
//! products of current base vectors and modes: it knows no rotation, and forces follow as its exact derivative.

use super::BLOCK;
use crate::material::{Isochoric, Kinematics};
use crate::mesh::{base_vectors, signs, CORNERS};
use clubface_math::{Mat3, Pack, Scalar, Vec3};

/// Constants an element keeps.
pub const CONSTANTS: usize = 25;

/// Mode of each uniform deformation, and of each hourglass pattern: bits are the reference coordinates in the product.
const LINEAR: [usize; 3] = [1, 2, 4];
const BENDING: [usize; 3] = [6, 5, 3];
const TWIST: usize = 7;

/// Bending of an incompressible plate over its shear: `2 / (1 - nu)` and `2 (1 + nu) / 3` with nu = 1/2.
const PLATE: f64 = 4.0;
const BEAM: f64 = 1.0;

/// Constants of an element from its corners: `J^-1 / 8` by rows of base vectors (9), hourglass shape in base vectors (12), reciprocal squares of the
/// edges (3), volume (1).
pub fn constants(corners: &[Vec3<f64>; CORNERS]) -> [f64; CONSTANTS] {
    let mut modes = [Vec3::zero(); CORNERS];
    for (mode, sum) in modes.iter_mut().enumerate() {
        for (corner, position) in corners.iter().enumerate() {
            let s = signs(corner);
            let sign: f64 = (0..3).filter(|axis| mode >> axis & 1 == 1).map(|axis| s[axis]).product();
            *sum += *position * sign;
        }
    }
    let linear = LINEAR.map(|mode| modes[mode]);
    let inverse = Mat3::from_columns(linear[0], linear[1], linear[2]).inverse();
    let mut c = [0.0; CONSTANTS];
    for i in 0..3 {
        inverse.rows[i].put(&mut c, 3 * i);
        // Eight corners a sum: a quarter of it is the edge.
        c[21 + i] = 64.0 / linear[i].norm_squared();
    }
    for (pattern, mode) in BENDING.into_iter().chain([TWIST]).enumerate() {
        (inverse * modes[mode]).put(&mut c, 9 + 3 * pattern);
    }
    let at = 1.0 / 3.0_f64.sqrt();
    c[24] = (0..CORNERS)
        .map(|point| {
            let [a, b, d] = base_vectors(corners, signs(point).map(|s| s * at));
            a.dot(b.cross(d))
        })
        .sum();
    c
}

/// Positions as modes; the translation is left out.
#[derive(Clone, Copy)]
pub struct Modes<P> {
    linear: [Vec3<P>; 3],
    patterns: [Vec3<P>; 4],
}

/// Sums and differences along one reference coordinate.
#[inline(always)]
fn butterfly<P: Scalar>(x: &mut [P; CORNERS], bit: usize) {
    for corner in 0..CORNERS {
        if corner & bit == 0 {
            let (low, high) = (x[corner], x[corner | bit]);
            x[corner] = low + high;
            x[corner | bit] = high - low;
        }
    }
}

/// The transpose of [`butterfly`].
#[inline(always)]
fn butterfly_back<P: Scalar>(x: &mut [P; CORNERS], bit: usize) {
    for corner in 0..CORNERS {
        if corner & bit == 0 {
            let (low, high) = (x[corner], x[corner | bit]);
            x[corner] = low - high;
            x[corner | bit] = low + high;
        }
    }
}

#[inline(always)]
fn sums<P: Scalar>(mut x: [P; CORNERS]) -> [P; CORNERS] {
    butterfly(&mut x, 1);
    butterfly(&mut x, 2);
    butterfly(&mut x, 4);
    x
}

/// Vector of one mode from the sums of the three components.
#[inline(always)]
fn mode<P: Scalar>(x: &[P; CORNERS], y: &[P; CORNERS], z: &[P; CORNERS], m: usize) -> Vec3<P> {
    Vec3::new(x[m], y[m], z[m])
}

/// `a + s b` for vectors.
#[inline(always)]
fn plus<P: Scalar>(a: Vec3<P>, s: P, b: Vec3<P>) -> Vec3<P> {
    Vec3::new(b.x.mul_add(s, a.x), b.y.mul_add(s, a.y), b.z.mul_add(s, a.z))
}

#[inline(always)]
fn dot<P: Scalar>(a: Vec3<P>, b: Vec3<P>) -> P {
    a.z.mul_add(b.z, a.y.mul_add(b.y, a.x * b.x))
}

/// One element a lane: constants and current modes.
pub struct Hexahedron<P> {
    inverse: [Vec3<P>; 3],
    skew: [Vec3<P>; 4],
    edges: [P; 3],
    /// Reference volume, m3.
    pub volume: P,
    linear: [Vec3<P>; 3],
    patterns: [Vec3<P>; 4],
}

impl<P: Pack> Hexahedron<P> {
    /// From a block of constants (from lane `first` on) and the positions of the corners.
    #[inline(always)]
    pub fn new(constants: &[P::Real], first: usize, corners: &[Vec3<P>; CORNERS]) -> Self {
        let modes = Modes::of(corners);
        let mut hexahedron = Self {
            inverse: [Vec3::zero(); 3],
            skew: [Vec3::zero(); 4],
            edges: [P::zero(); 3],
            volume: load(constants, first, 24),
            linear: modes.linear,
            patterns: modes.patterns,
        };
        for i in 0..3 {
            hexahedron.inverse[i] = vector(constants, first, 3 * i);
            hexahedron.edges[i] = load(constants, first, 21 + i);
        }
        for i in 0..4 {
            let skew = vector(constants, first, 9 + 3 * i);
            hexahedron.skew[i] = skew;
            let straight = plus(hexahedron.patterns[i], -skew.x, modes.linear[0]);
            let straight = plus(straight, -skew.y, modes.linear[1]);
            hexahedron.patterns[i] = plus(straight, -skew.z, modes.linear[2]);
        }
        hexahedron
    }

    /// Deformation gradient at the centre.
    #[inline(always)]
    pub fn gradient(&self) -> Mat3<P> {
        let (a, b, c) = (self.linear[0], self.linear[1], self.linear[2]);
        let [r, s, t] = self.inverse;
        // F = a r^T + b s^T + c t^T.
        Mat3::from_rows(
            plus(plus(r * a.x, b.x, s), c.x, t),
            plus(plus(r * a.y, b.y, s), c.y, t),
            plus(plus(r * a.z, b.z, s), c.z, t),
        )
    }

    /// Stiffness of hourglass pattern `pattern` along base vector `along`, for a shear modulus.
    #[inline(always)]
    fn stiffness(&self, scale: P, pattern: usize, along: usize) -> P {
        let e = &self.edges;
        let squares = if pattern == 3 {
            e[along] * BEAM
        } else if pattern == along {
            e[(along + 1) % 3] + e[(along + 2) % 3]
        } else {
            e[along] * PLATE
        };
        scale * e[along] * squares
    }

    /// Forces of the hourglass modes along base vectors and patterns, and twice their energy.
    #[inline(always)]
    fn hourglass(&self, shear: P) -> ([Vec3<P>; 3], [Vec3<P>; 4], P) {
        // With edges l and e = 4/l^2: half of mu V/3 (sum of e) times the square of (x.q) / (32 l), and 1/(32 l)^2 = e/4096.
        let scale = shear * self.volume * (1.0 / (3.0 * 4096.0));
        let mut on_linear = [Vec3::zero(); 3];
        let mut on_patterns = [Vec3::zero(); 4];
        let mut energy = P::zero();
        for pattern in 0..4 {
            for along in 0..3 {
                let product = dot(self.linear[along], self.patterns[pattern]);
                let force = self.stiffness(scale, pattern, along) * product;
                energy = force.mul_add(product, energy);
                on_linear[along] = plus(on_linear[along], force, self.patterns[pattern]);
                on_patterns[pattern] = plus(on_patterns[pattern], force, self.linear[along]);
            }
            let skew = self.skew[pattern];
            on_linear[0] = plus(on_linear[0], -skew.x, on_patterns[pattern]);
            on_linear[1] = plus(on_linear[1], -skew.y, on_patterns[pattern]);
            on_linear[2] = plus(on_linear[2], -skew.z, on_patterns[pattern]);
        }
        (on_linear, on_patterns, energy)
    }

    /// Forces on the corners, N, from the first Piola-Kirchhoff stress (Pa) at the centre.
    #[inline(always)]
    pub fn forces(&self, stress: &Mat3<P>, shear: P) -> [Vec3<P>; CORNERS] {
        let (mut linear, patterns, _) = self.hourglass(shear);
        let [r, s, t] = stress.rows;
        for i in 0..3 {
            let direction = self.inverse[i] * self.volume;
            linear[i] = Vec3::new(
                dot(r, direction) + linear[i].x,
                dot(s, direction) + linear[i].y,
                dot(t, direction) + linear[i].z,
            );
        }
        Modes { linear, patterns }.back()
    }

    /// Energy of the hourglass modes, J.
    #[inline(always)]
    pub fn hourglass_energy(&self, shear: P) -> P {
        self.hourglass(shear).2 * 0.5
    }

    /// Strain energy without the hourglass modes, J.
    #[inline(always)]
    pub fn strain_energy<L: Isochoric<P>>(&self, law: L, bulk: P, at: &Kinematics<P>) -> P {
        let dilation = at.volume - 1.0;
        (law.energy(&at.c) + bulk * dilation * dilation * 0.5) * self.volume
    }
}

impl<P: Scalar> Modes<P> {
    #[inline(always)]
    fn of(corners: &[Vec3<P>; CORNERS]) -> Self {
        let mut c = [[P::zero(); CORNERS]; 3];
        for i in 0..CORNERS {
            c[0][i] = corners[i].x;
            c[1][i] = corners[i].y;
            c[2][i] = corners[i].z;
        }
        let (x, y, z) = (sums(c[0]), sums(c[1]), sums(c[2]));
        Self {
            linear: [mode(&x, &y, &z, 1), mode(&x, &y, &z, 2), mode(&x, &y, &z, 4)],
            patterns: [
                mode(&x, &y, &z, BENDING[0]),
                mode(&x, &y, &z, BENDING[1]),
                mode(&x, &y, &z, BENDING[2]),
                mode(&x, &y, &z, TWIST),
            ],
        }
    }
    /// Forces on corners from minus the forces on modes.
    #[inline(always)]
    fn back(&self) -> [Vec3<P>; CORNERS] {
        let mut c = [[P::zero(); CORNERS]; 3];
        for i in 0..3 {
            let (v, p) = (self.linear[i].array(), self.patterns[i].array());
            for axis in 0..3 {
                c[axis][LINEAR[i]] = -v[axis];
                c[axis][BENDING[i]] = -p[axis];
            }
        }
        let twist = self.patterns[3].array();
        for axis in 0..3 {
            c[axis][TWIST] = -twist[axis];
            butterfly_back(&mut c[axis], 4);
            butterfly_back(&mut c[axis], 2);
            butterfly_back(&mut c[axis], 1);
        }
        let mut forces = [Vec3::zero(); CORNERS];
        for i in 0..CORNERS {
            forces[i] = Vec3::new(c[0][i], c[1][i], c[2][i]);
        }
        forces
    }
}

#[inline(always)]
fn load<P: Pack>(constants: &[P::Real], first: usize, which: usize) -> P {
    P::load(&constants[which * BLOCK + first..])
}

#[inline(always)]
fn vector<P: Pack>(constants: &[P::Real], first: usize, which: usize) -> Vec3<P> {
    Vec3::new(load(constants, first, which), load(constants, first, which + 1), load(constants, first, which + 2))
}
