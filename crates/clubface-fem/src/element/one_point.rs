//! The eight-node hexahedron with one integration point, in total Lagrangian form, with physical hourglass control.
//!
//! Positions are taken apart into eight modes by sums and differences: one of translation, three of uniform deformation (the base vectors
//! at the centre), four of bending (hourglass), to which one point is blind (Flanagan and Belytschko, Int. J. Numer. Methods Eng. 17,
//! 1981). The hourglass modes get the stiffness that a rectangular, incompressible block of the element's size has in bending, shear and
//! torsion, without bulk stiffness (after Belytschko and Bindeman, Comput. Methods Appl. Mech. Eng. 105, 1993), as an energy of the
//! products of current base vectors and modes: it knows no rotation, and forces follow as its exact derivative.
//!
//! The materials are isotropic, so each element may look at its undeformed shape from a frame of its own: one in which the first base
//! vector lies along x and the second in the xy plane. Its Jacobian is then triangular (six numbers instead of nine), and elements that
//! differ by a rotation share their constants.

use super::BLOCK;
use crate::material::{Isochoric, Kinematics};
use crate::mesh::{base_vectors, signs, CORNERS};
use clubface_math::{Mat3, Pack, Scalar, Vec3};

/// Constants an element keeps.
pub const CONSTANTS: usize = 22;

/// Where they stand: `J^-1 / 8` (rows of base vectors, upper triangle), the negative of each hourglass shape in base vectors, reciprocal
/// squares of the edges, volume.
const SKEW: usize = 6;
const EDGES: usize = 18;
pub const VOLUME: usize = 21;

/// Mode of each uniform deformation, and of each hourglass pattern: bits are the reference coordinates in the product.
const LINEAR: [usize; 3] = [1, 2, 4];
const PATTERNS: [usize; 4] = [6, 5, 3, 7];

/// Bending of an incompressible plate, `2 / (1 - nu)`, over the shear or twist of a block, both for nu = 1/2.
const PLATE: f64 = 4.0;

/// Constants of an element from its corners.
pub fn constants<R: Scalar>(corners: &[Vec3<R>; CORNERS]) -> [R; CONSTANTS] {
    let mut modes = [Vec3::zero(); CORNERS];
    for (mode, sum) in modes.iter_mut().enumerate() {
        for (corner, position) in corners.iter().enumerate() {
            let s = signs(corner);
            let sign: f64 = (0..3).filter(|axis| mode >> axis & 1 == 1).map(|axis| s[axis]).product();
            *sum += *position * R::from_f64(sign);
        }
    }
    let [a, b, c] = LINEAR.map(|mode| modes[mode]);
    let inverse = Mat3::from_columns(a, b, c).inverse();
    let mut stored = [R::zero(); CONSTANTS];
    // The element's own frame: x along a, y in the plane of a and b.
    let x = a * a.norm().recip();
    let z = a.cross(b) * a.cross(b).norm().recip();
    let y = z.cross(x);
    let [r, s, t] = inverse.rows;
    stored[..SKEW].copy_from_slice(&[r.dot(x), r.dot(y), r.dot(z), s.dot(y), s.dot(z), t.dot(z)]);
    for (pattern, mode) in PATTERNS.into_iter().enumerate() {
        (-(inverse * modes[mode])).put(&mut stored, SKEW + 3 * pattern);
    }
    for (i, base) in [a, b, c].into_iter().enumerate() {
        // Eight corners a sum: a quarter of it is the edge.
        stored[EDGES + i] = base.norm_squared().recip() * 64.0;
    }
    let at = 1.0 / 3.0_f64.sqrt();
    for point in 0..CORNERS {
        let [a, b, d] = base_vectors(corners, signs(point).map(|s| s * at));
        stored[VOLUME] += a.dot(b.cross(d));
    }
    stored
}

/// Four corners of one side along the third reference coordinate, a number each, as sums and differences: sum, along the first coordinate,
/// along the second, along both.
pub type Sums<P> = [P; 4];

/// Positions of such a side, or forces on it, by component. Neighbours across the side share it.
pub type Face<P> = [Sums<P>; 3];

/// The side whose corners stand at zero, or which no force acts on.
#[inline(always)]
pub fn empty<P: Scalar>() -> Face<P> {
    [[P::zero(); 4]; 3]
}

/// Sums and differences of the corners of a side.
#[inline(always)]
pub fn sums<P: Scalar>(corners: [P; 4]) -> Sums<P> {
    let (low, high) = (corners[0] + corners[1], corners[2] + corners[3]);
    let (low_slope, high_slope) = (corners[1] - corners[0], corners[3] - corners[2]);
    [low + high, low_slope + high_slope, high - low, high_slope - low_slope]
}

/// Forces on the corners of a side from forces on sums and differences: the transpose of [`sums`].
#[inline(always)]
pub fn spread<P: Scalar>(forces: Sums<P>) -> [P; 4] {
    let [sum, first, second, both] = forces;
    let (low, high) = (sum - second, sum + second);
    let (low_slope, high_slope) = (first - both, first + both);
    [low - low_slope, low + low_slope, high - high_slope, high + high_slope]
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

/// One element a lane, between its two sides.
pub struct Hexahedron<'a, P: Pack> {
    constants: &'a [P::Real; CONSTANTS * BLOCK],
    first: usize,
    low: &'a Face<P>,
    high: &'a Face<P>,
    linear: [Vec3<P>; 3],
    /// Reference volume, m3; 0 for a lane that holds no element.
    pub volume: P,
}

/// Forces of the hourglass modes along base vectors and patterns, and minus twice their energy.
pub struct Hourglass<P> {
    linear: [Vec3<P>; 3],
    patterns: [Vec3<P>; 4],
    energy: P,
}

impl<'a, P: Pack> Hexahedron<'a, P> {
    /// From a block of constants (from lane `first` on) and the positions of its sides.
    #[inline(always)]
    pub fn new(
        constants: &'a [P::Real; CONSTANTS * BLOCK],
        first: usize,
        low: &'a Face<P>,
        high: &'a Face<P>,
    ) -> Self {
        assert!(first + P::LANES <= BLOCK);
        let mut linear = [[P::zero(); 3]; 3];
        for axis in 0..3 {
            let (l, h) = (&low[axis], &high[axis]);
            linear[0][axis] = l[1] + h[1];
            linear[1][axis] = l[2] + h[2];
            linear[2][axis] = h[0] - l[0];
        }
        let linear = [vector(linear[0]), vector(linear[1]), vector(linear[2])];
        let mut hexahedron = Self { constants, first, low, high, linear, volume: P::zero() };
        hexahedron.volume = hexahedron.load(VOLUME);
        hexahedron
    }

    #[inline(always)]
    fn load(&self, which: usize) -> P {
        debug_assert!(which < CONSTANTS);
        // SAFETY: `which` is a constant below CONSTANTS wherever this is called, and `new` has checked the lanes.
        unsafe { P::read(self.constants.as_ptr().add(which * BLOCK + self.first)) }
    }

    /// Deformation gradient at the centre, seen from the element's own frame; the identity where there is no element.
    #[inline(always)]
    pub fn gradient(&self) -> Mat3<P> {
        let (a, b, c) = (self.linear[0], self.linear[1], self.linear[2]);
        let unit = P::select(self.volume.gt(P::zero()), P::zero(), P::one());
        // F = a r^T + b s^T + c t^T.
        let r = [self.load(0), self.load(1), self.load(2)];
        let s = [self.load(3), self.load(4)];
        let t = self.load(5);
        Mat3::from_rows(
            Vec3::new(
                a.x.mul_add(r[0], unit),
                b.x.mul_add(s[0], a.x * r[1]),
                c.x.mul_add(t, b.x.mul_add(s[1], a.x * r[2])),
            ),
            Vec3::new(
                a.y * r[0],
                b.y.mul_add(s[0], a.y.mul_add(r[1], unit)),
                c.y.mul_add(t, b.y.mul_add(s[1], a.y * r[2])),
            ),
            Vec3::new(
                a.z * r[0],
                b.z.mul_add(s[0], a.z * r[1]),
                c.z.mul_add(t, b.z.mul_add(s[1], a.z.mul_add(r[2], unit))),
            ),
        )
    }

    /// Hourglass pattern `which` as a vector: its mode without the part that belongs to the element's shape.
    #[inline(always)]
    fn pattern(&self, which: usize, skew: Vec3<P>) -> Vec3<P> {
        let mut mode = [P::zero(); 3];
        for axis in 0..3 {
            let (l, h) = (&self.low[axis], &self.high[axis]);
            mode[axis] = match which {
                0 => h[2] - l[2],
                1 => h[1] - l[1],
                2 => l[3] + h[3],
                _ => h[3] - l[3],
            };
        }
        let [a, b, c] = self.linear;
        plus(plus(plus(vector(mode), skew.x, a), skew.y, b), skew.z, c)
    }

    /// Minus the stiffness of each hourglass pattern along each base vector, for a shear modulus.
    #[inline(always)]
    fn stiffness(&self, shear: P) -> [[P; 3]; 4] {
        // With edges l and e = 4/l^2: half of mu V/3 (sum of e) times the square of (x.q) / (32 l), and 1/(32 l)^2 = e/4096.
        let scale = shear * self.volume * (-1.0 / (3.0 * 4096.0));
        let e = [self.load(EDGES), self.load(EDGES + 1), self.load(EDGES + 2)];
        let mut k = [[P::zero(); 3]; 4];
        for along in 0..3 {
            let scaled = scale * e[along];
            let twist = scaled * e[along];
            let plate = twist * PLATE;
            let shear = scaled * (e[(along + 1) % 3] + e[(along + 2) % 3]);
            for pattern in 0..3 {
                k[pattern][along] = if pattern == along { shear } else { plate };
            }
            k[3][along] = twist;
        }
        k
    }

    /// Forces of the hourglass modes, for a shear modulus.
    #[inline(always)]
    pub fn hourglass(&self, shear: P) -> Hourglass<P> {
        let stiffness = self.stiffness(shear);
        let mut on_linear = [Vec3::zero(); 3];
        let mut on_patterns = [Vec3::zero(); 4];
        let mut energy = P::zero();
        for which in 0..4 {
            let at = SKEW + 3 * which;
            let skew = Vec3::new(self.load(at), self.load(at + 1), self.load(at + 2));
            let pattern = self.pattern(which, skew);
            let mut force = Vec3::zero();
            for along in 0..3 {
                let product = dot(self.linear[along], pattern);
                let size = stiffness[which][along] * product;
                energy = size.mul_add(product, energy);
                on_linear[along] = plus(on_linear[along], size, pattern);
                force = plus(force, size, self.linear[along]);
            }
            on_linear[0] = plus(on_linear[0], skew.x, force);
            on_linear[1] = plus(on_linear[1], skew.y, force);
            on_linear[2] = plus(on_linear[2], skew.z, force);
            on_patterns[which] = force;
        }
        Hourglass { linear: on_linear, patterns: on_patterns, energy }
    }

    /// Adds the forces, N, to those on the side below, and returns those on the side above. `stress` is minus the first Piola-Kirchhoff
    /// stress (Pa) at the centre, times the volume.
    #[inline(always)]
    pub fn forces(&self, stress: &Mat3<P>, hourglass: &Hourglass<P>, below: &Face<P>) -> (Face<P>, Face<P>) {
        let patterns = &hourglass.patterns;
        let patterns = [patterns[0].array(), patterns[1].array(), patterns[2].array(), patterns[3].array()];
        let linear = &hourglass.linear;
        let hourglass = [linear[0].array(), linear[1].array(), linear[2].array()];
        let r = [self.load(0), self.load(1), self.load(2)];
        let s = [self.load(3), self.load(4)];
        let t = self.load(5);
        let rows = [stress.rows[0], stress.rows[1], stress.rows[2]];
        let (mut low, mut high) = (*below, empty());
        for axis in 0..3 {
            let p = rows[axis];
            let first = p.z.mul_add(r[2], p.y.mul_add(r[1], p.x.mul_add(r[0], hourglass[0][axis])));
            let second = p.z.mul_add(s[1], p.y.mul_add(s[0], hourglass[1][axis]));
            let third = p.z.mul_add(t, hourglass[2][axis]);
            let [yz, xz, xy, twist] =
                [patterns[0][axis], patterns[1][axis], patterns[2][axis], patterns[3][axis]];
            low[axis][0] -= third;
            low[axis][1] += first - xz;
            low[axis][2] += second - yz;
            low[axis][3] += xy - twist;
            high[axis] = [third, first + xz, second + yz, xy + twist];
        }
        (low, high)
    }

    /// Energy of the hourglass modes, J.
    #[inline(always)]
    pub fn hourglass_energy(&self, shear: P) -> P {
        self.hourglass(shear).energy * -0.5
    }

    /// Strain energy without the hourglass modes, J.
    #[inline(always)]
    pub fn strain_energy<L: Isochoric<P>>(&self, law: L, bulk: P, at: &Kinematics<P>) -> P {
        let dilation = at.volume - 1.0;
        (law.energy(&at.c) + bulk * dilation * dilation * 0.5) * self.volume
    }
}

#[inline(always)]
fn vector<P: Scalar>(v: [P; 3]) -> Vec3<P> {
    Vec3::new(v[0], v[1], v[2])
}
