//! The eight-node hexahedron with one integration point, in total Lagrangian form, with physical hourglass control.
//!
//! Positions are taken apart into eight modes by sums and differences: one of translation, three of uniform deformation
//! (the base vectors at the centre), four of bending (hourglass), to which one point is blind (Flanagan and Belytschko,
//! Int. J. Numer. Methods Eng. 17, 1981). What the base vectors leave of these, the patterns, are held by springs of
//! one stiffness each, whatever the direction: their energy does not depend on rotation. The stiffness is made of those
//! that a rectangular, incompressible block of the element's size has in bending, shear and torsion, without bulk
//! stiffness (after Belytschko and Bindeman, Comput. Methods Appl. Mech. Eng. 105, 1993).
//!
//! The materials are isotropic, so each element may look at its undeformed shape from a frame of its own: one in
//! which the first base vector lies along x and the second in the xy plane. Its Jacobian is then triangular (six
//! numbers instead of nine), and elements that differ by a rotation share their constants.
//!
//! The maps between positions, modes, gradients and forces are linear, with coefficients that follow from the shape.
//! Numbers with derivatives go through them part by part, in as many passes (see [`Part`]): on plain numbers, but for
//! derivatives by variables that the shape depends on.

use super::constants::{Constants, Shape};
use super::passes::{from_values, in_passes, into_values, part, set_part};
use crate::material::Symmetric;
use clubface_math::{Mat3, Pack, Part, Real, Scalar, Vec3};

/// Four corners of one side along the third reference coordinate, a number each, as sums and differences: sum, along
/// the first coordinate, along the second, along both.
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

/// Sum of three products.
#[inline(always)]
fn dot<P: Scalar>(a: [P; 3], b: [P; 3]) -> P {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0].product(b[0])))
}

/// One component of the modes of a pack of elements, or of the forces on them.
#[derive(Clone, Copy)]
pub struct Component<P> {
    /// Eight times the base vectors: means over the element, as is the deformation gradient.
    bases: [P; 3],
    /// Hourglass patterns: modes without the part that belongs to the element's shape.
    patterns: [P; 4],
}

impl<G: Pack> Component<G> {
    /// From the positions of the sides.
    #[inline(always)]
    pub fn new<P: Pack>(shape: &Shape<P, G>, low: &Sums<G>, high: &Sums<G>) -> Self
    where
        G: Part<P>,
    {
        let mut bases = [low[1] + high[1], low[2] + high[2], high[0] - low[0]];
        let mut patterns = [high[2] - low[2], high[1] - low[1], low[3] + high[3], high[3] - low[3]];
        for mode in 0..4 {
            for i in 0..3 {
                patterns[mode] = shape.skew(mode, i).mul_add(bases[i], patterns[mode]);
            }
        }
        for mode in 0..3 {
            for i in 0..3 {
                bases[i] = shape.mean(mode, i).mul_add(patterns[mode], bases[i]);
            }
        }
        Self { bases, patterns }
    }

    /// Forces, N, on the sides below (added to those given) and above, from those on the modes.
    #[inline(always)]
    pub fn forces<P: Pack>(&self, shape: &Shape<P, G>, below: &Sums<G>) -> (Sums<G>, Sums<G>)
    where
        G: Part<P>,
    {
        // Below the next term of each sum in turn: what the CPU waits for is the longest chain of operations.
        let (mut on_bases, mut on_patterns) = (self.bases, self.patterns);
        // What acts on base vectors acts on the patterns in their means, and what acts on patterns on the base
        // vectors they were freed of.
        for i in 0..3 {
            for mode in 0..3 {
                on_patterns[mode] = shape.mean(mode, i).mul_add(on_bases[i], on_patterns[mode]);
            }
        }
        for mode in [3, 0, 1, 2] {
            for i in 0..3 {
                on_bases[i] = shape.skew(mode, i).mul_add(on_patterns[mode], on_bases[i]);
            }
        }
        let ([first, second, third], [yz, xz, xy, twist]) = (on_bases, on_patterns);
        let low =
            [below[0] - third, (below[1] - xz) + first, (below[2] - yz) + second, (below[3] - twist) + xy];
        (low, [third, first + xz, second + yz, xy + twist])
    }
}

impl<P: Pack> Component<P> {
    /// None.
    #[inline(always)]
    fn zero() -> Self {
        Self { bases: [P::zero(); 3], patterns: [P::zero(); 4] }
    }

    /// What acts on the base vectors under a stress as in [`super::stress::on_bases`], and on the hourglass patterns,
    /// N.
    #[inline(always)]
    pub fn loads<const SLOPES: bool>(
        &self,
        constants: &Constants<P::Real, SLOPES>,
        stress: &Symmetric<P>,
    ) -> Self {
        let [aa, bb, cc, ab, ac, bc] = stress.0;
        let bases = self.bases;
        let mut patterns = self.patterns;
        for mode in 0..4 {
            patterns[mode] = self.patterns[mode].product(constants.stiffness(mode));
        }
        let bases = [dot(bases, [aa, ab, ac]), dot(bases, [ab, bb, bc]), dot(bases, [ac, bc, cc])];
        Self { bases, patterns }
    }

    /// Sets the modes of one pass from the positions of the sides.
    #[inline(always)]
    fn set_modes<G: Part<P>, const SLOPES: bool>(
        &mut self,
        constants: &Constants<P::Real, SLOPES>,
        pass: usize,
        low: &Sums<P>,
        high: &Sums<P>,
    ) {
        let (low, high) = (part(low, pass), part(high, pass));
        self.set_part(pass, &Component::<G>::new(&constants.shape(pass), &low, &high));
    }

    /// One pass of the forces, N, as in [`Component::forces`], from what acts on the modes.
    #[inline(always)]
    pub fn part_of_forces<G: Part<P>, const SLOPES: bool>(
        &self,
        constants: &Constants<P::Real, SLOPES>,
        pass: usize,
        below: &Sums<P::Value>,
    ) -> (Sums<P::Value>, Sums<P::Value>) {
        let shape = constants.shape::<P, G>(pass);
        let (low, high) = self.part::<G>(pass).forces(&shape, &from_values::<P, G, 4>(below));
        (into_values::<P, G, 4>(&low), into_values::<P, G, 4>(&high))
    }

    /// What a pass of a linear map acts on.
    #[inline(always)]
    pub fn part<G: Part<P>>(&self, pass: usize) -> Component<G> {
        Component { bases: part(&self.bases, pass), patterns: part(&self.patterns, pass) }
    }

    /// Stores the result of a pass.
    #[inline(always)]
    pub fn set_part<G: Part<P>>(&mut self, pass: usize, part: &Component<G>) {
        set_part(&mut self.bases, pass, &part.bases);
        set_part(&mut self.patterns, pass, &part.patterns);
    }
}

/// One element a lane.
#[derive(Clone, Copy)]
pub struct Hexahedron<P> {
    /// Its modes by component.
    pub components: [Component<P>; 3],
}

impl<P: Pack> Hexahedron<P> {
    /// With every corner at the origin.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { components: [Component::zero(); 3] }
    }

    /// From the positions of its sides.
    #[inline(always)]
    pub fn new<const SLOPES: bool>(
        constants: &Constants<P::Real, SLOPES>,
        low: &Face<P>,
        high: &Face<P>,
    ) -> Self {
        let mut element = Self::zero();
        for axis in 0..3 {
            for pass in 0..P::Real::PARTS {
                let component = &mut element.components[axis];
                if constants.pattern_varies(pass) {
                    component.set_modes::<P::Pair, SLOPES>(constants, pass, &low[axis], &high[axis]);
                } else {
                    component.set_modes::<P::Value, SLOPES>(constants, pass, &low[axis], &high[axis]);
                }
            }
        }
        element
    }

    /// Mean deformation gradient, seen from the element's own frame; the identity where there is no element.
    #[inline(always)]
    pub fn gradient<const SLOPES: bool>(&self, constants: &Constants<P::Real, SLOPES>) -> Mat3<P> {
        let mut rows = [Vec3::zero(); 3];
        for i in 0..3 {
            let mut row = [P::zero(); 3];
            in_passes!(P::Real, |pass| if constants.size_varies(pass) {
                self.part_of_row::<P::Pair>(&constants.shape(pass), pass, i, &mut row);
            } else {
                self.part_of_row::<P::Value>(&constants.shape(pass), pass, i, &mut row);
            });
            let [x, y, z] = row;
            rows[i] = Vec3::new(x, y, z);
        }
        Mat3 { rows }
    }

    /// One pass of a row of it.
    #[inline(always)]
    fn part_of_row<G: Part<P>>(&self, shape: &Shape<P, G>, pass: usize, i: usize, row: &mut [P; 3]) {
        // F = a r^T + b s^T + c t^T.
        let (r, s, t) = shape.inverse();
        let [a, b, c] = part::<P, G, 3>(&self.components[i].bases, pass);
        let mut one = [a.product(r[0]), a.product(r[1]), a.product(r[2])];
        if pass == 0 {
            let unit = G::select(shape.volume().gt(G::zero()), G::zero(), G::one());
            one[i] = a.mul_add(r[i], unit);
        }
        set_part(row, pass, &[one[0], b.mul_add(s[0], one[1]), c.mul_add(t, b.mul_add(s[1], one[2]))]);
    }

    /// Forces, N, on the sides below and above.
    #[inline(always)]
    pub fn forces<const SLOPES: bool>(
        &self,
        constants: &Constants<P::Real, SLOPES>,
        stress: &Symmetric<P>,
    ) -> (Face<P>, Face<P>) {
        let (mut low, mut high) = (empty(), empty());
        for axis in 0..3 {
            let loads = self.components[axis].loads(constants, stress);
            for pass in 0..P::Real::PARTS {
                let nothing = [P::Value::zero(); 4];
                let (below, above) = if constants.pattern_varies(pass) {
                    loads.part_of_forces::<P::Pair, SLOPES>(constants, pass, &nothing)
                } else {
                    loads.part_of_forces::<P::Value, SLOPES>(constants, pass, &nothing)
                };
                set_part(&mut low[axis], pass, &below);
                set_part(&mut high[axis], pass, &above);
            }
        }
        (low, high)
    }

    /// Energy of the hourglass patterns, J.
    #[inline(always)]
    pub fn hourglass_energy<const SLOPES: bool>(&self, constants: &Constants<P::Real, SLOPES>) -> P {
        let mut sum = P::zero();
        for mode in 0..4 {
            let pattern = self.components.map(|component| component.patterns[mode]);
            sum += constants.stiffness::<P>(mode) * dot(pattern, pattern);
        }
        sum * -0.5
    }
}

/// A visitor of elements.
pub trait Visitor<P: Pack> {
    /// Visits a pack, which begins with a lane, counted over all blocks. What visitors find has no derivatives.
    fn visit(&mut self, lane: usize, constants: &Constants<P::Real, false>, element: &Hexahedron<P>);
    /// Ends a run of at most [`super::stress::RUN`] packs, each `step` lanes further than the one before.
    fn end_run(&mut self, _step: usize) {}
}
