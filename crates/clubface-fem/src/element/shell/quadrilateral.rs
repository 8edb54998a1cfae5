//! The four-node shell with one point in its plane: velocities to strain rates, stresses to forces.
//!
//! The element of Belytschko and Tsay (Int. J. Numer. Methods Eng. 19, 1983) in a frame that goes with it, taken
//! apart into four modes of the reference square: translation, the two uniform gradients, and the bilinear
//! (hourglass) mode. Three things are better than in the original:
//!
//! * a warped element is the flat one through its middle, to whose corners the nodes are tied by rigid links along
//!   its normal (as in MacNeal's QUAD4), which couples membrane and bending as the corrections of Belytschko, Wong
//!   and Chiang (Comput. Methods Appl. Mech. Eng. 96, 1992) do, and keeps moments in balance;
//! * transverse shear is taken along the edges, as in the element of Bathe and Dvorkin (Int. J. Numer. Methods Eng.
//!   21, 1985): no locking, and no resistance to pure twist;
//! * the hourglass modes get the stiffness that a rectangle has in them (membrane: in-plane bending; rotations: as
//!   the fully integrated plate; shear: the difference between opposite edges), so there is no coefficient to choose.
//!
//! Membrane strain increments are differences of squared lengths, and the others are exact to the second order in the
//! rotation of a step, so that rigid motion makes no stress.

use super::modes::{CORNERS, Flat, Modes, inner, less, less_f64, plus, times, times_f64, turned};
use crate::material::{Symmetric, cross, dot};
use clubface_math::{Mat3, Pack, Vec3};

/// Stabilised modes: the hourglass modes (membrane along both axes, rotation along both, shear along both pairs of
/// edges), and drilling.
pub const HOURGLASS: usize = 7;

/// Strain increments of a step.
#[derive(Clone, Copy)]
pub struct Increment<P> {
    /// Membrane strain: xx, yy, twice xy.
    pub membrane: [P; 3],
    /// Curvature, 1/m: xx, yy, twice xy; positive where the outer side stretches.
    pub curvature: [P; 3],
    /// Transverse shear angles: xz, yz.
    pub shear: [P; 2],
    /// Amplitudes of the stabilised modes.
    pub hourglass: [P; HOURGLASS],
}

/// Stress resultants per length of section.
#[derive(Clone, Copy)]
pub struct Resultants<P> {
    /// Membrane forces, N/m: xx, yy, xy.
    pub membrane: [P; 3],
    /// Bending moments, N: xx, yy, xy.
    pub bending: [P; 3],
    /// The rest.
    pub across: Across<P>,
}

/// What acts on the section in addition to its strains.
#[derive(Clone, Copy)]
pub struct Across<P> {
    /// Transverse shear forces, N/m: xz, yz.
    pub shear: [P; 2],
    /// Forces of the stabilised modes.
    pub hourglass: [P; HOURGLASS],
}

/// Geometry of one element a lane.
pub struct Quadrilateral<P> {
    axes: [Vec3<P>; 3],
    /// Slope of the position along xi: the first axis has its direction, m.
    along: P,
    /// Slope of the position along eta, m.
    across: Flat<P>,
    /// Bilinear part of the position in the plane and out of it, m.
    skew: Flat<P>,
    warp: P,
    inverse_along: P,
    inverse_across: P,
    /// Four over the area, 1/m2.
    inverse_size: P,
    /// Area of the flat element, m2.
    pub area: P,
}

impl<P: Pack> Quadrilateral<P> {
    /// From the positions of the corners, m, counterclockwise seen from outside.
    #[inline(always)]
    pub fn new(corners: &[Vec3<P>; CORNERS]) -> Self {
        let modes = Modes::from_corners(corners);
        let (xi, eta, skew) =
            (times_f64(modes.xi, 0.25), times_f64(modes.eta, 0.25), times_f64(modes.skew, 0.25));
        let normal = cross(xi, eta);
        let size = dot(normal, normal).sqrt();
        let square = dot(xi, xi);
        let along = square.sqrt();
        // One division for both reciprocals.
        let both = along.product(size).recip();
        let (inverse_along, inverse_size) = (both.product(size), both.product(along));
        let first = times(xi, inverse_along);
        let third = times(normal, inverse_size);
        let second = cross(third, first);
        Self {
            along,
            across: [dot(eta, first), size.product(inverse_along)],
            skew: [dot(skew, first), dot(skew, second)],
            warp: dot(skew, third),
            inverse_along,
            inverse_across: along.product(inverse_size),
            inverse_size,
            area: size * 4.0,
            axes: [first, second, third],
        }
    }

    /// A tensor from the axes of the element (xx, yy, xy, zz) to those of the corners.
    #[inline(always)]
    pub fn turned_out(&self, [xx, yy, xy, zz]: [P; 4]) -> Symmetric<P> {
        let axes = Mat3::from_columns(self.axes[0], self.axes[1], self.axes[2]);
        Symmetric([xx, yy, zz, xy, P::zero(), P::zero()]).seen_through(&axes)
    }

    /// Ratio of the sides, across over along.
    #[inline(always)]
    pub fn aspect(&self) -> (P, P) {
        (self.across[1].product(self.inverse_along), self.along.product(self.inverse_across))
    }

    /// Slopes in the plane from the modes of a component.
    #[inline(always)]
    fn gradient(&self, xi: P, eta: P) -> Flat<P> {
        let x = xi.product(self.inverse_along);
        [x, less(eta, x, self.across[0]).product(self.inverse_across)]
    }
    /// The transpose of [`Quadrilateral::gradient`].
    #[inline(always)]
    fn spread(&self, x: P, y: P) -> Flat<P> {
        let eta = y.product(self.inverse_across);
        [less(x, eta, self.across[0]).product(self.inverse_along), eta]
    }
    /// Components along the axes of the element.
    #[inline(always)]
    fn local(&self, v: Vec3<P>) -> [P; 3] {
        [dot(v, self.axes[0]), dot(v, self.axes[1]), dot(v, self.axes[2])]
    }
    /// Rotation of the normal by an angular velocity: the slope of the velocity along the thickness.
    #[inline(always)]
    fn tilt(&self, spin: Vec3<P>) -> Flat<P> {
        [dot(spin, self.axes[1]), -dot(spin, self.axes[0])]
    }
    /// Bilinear part of a component without what a linear field makes of a skewed element.
    #[inline(always)]
    fn stabilised(&self, skew: P, gradient: Flat<P>) -> P {
        less(less(skew, gradient[0], self.skew[0]), gradient[1], self.skew[1])
    }

    /// Velocity of a corner of the flat element, seen through its rigid link.
    #[inline(always)]
    fn link(&self, velocity: P, tilt: P) -> P {
        less(velocity, self.warp, tilt)
    }
    /// Forces on the slopes of a component from a row of resultants and the force of its hourglass mode.
    #[inline(always)]
    fn slope(&self, x: P, y: P, hourglass: P) -> Flat<P> {
        self.spread(
            less(x.product(self.area), hourglass, self.skew[0]),
            less(y.product(self.area), hourglass, self.skew[1]),
        )
    }

    /// Strain increments from velocities (m/s) and angular velocities (rad/s) of the corners over a step, s.
    #[inline(always)]
    pub fn increment(
        &self,
        velocities: &[Vec3<P>; CORNERS],
        spins: &[Vec3<P>; CORNERS],
        dt: f64,
    ) -> Increment<P> {
        let quarter = dt * 0.25;
        let (v, s) = (Modes::from_corners(velocities), Modes::from_corners(spins));
        let tilt = Modes {
            mean: self.tilt(times_f64(s.mean, quarter)),
            xi: self.tilt(times_f64(s.xi, quarter)),
            eta: self.tilt(times_f64(s.eta, quarter)),
            skew: self.tilt(times_f64(s.skew, quarter)),
        };
        let xi = self.local(times_f64(v.xi, quarter));
        let eta = self.local(times_f64(v.eta, quarter));
        let skew = self.local(times_f64(v.skew, quarter));
        // Rigid links: the corner of the flat element is `warp` times the sign of the bilinear mode below the node.
        let ux = self.gradient(self.link(xi[0], tilt.eta[0]), self.link(eta[0], tilt.xi[0]));
        let uy = self.gradient(self.link(xi[1], tilt.eta[1]), self.link(eta[1], tilt.xi[1]));
        let w = self.gradient(xi[2], eta[2]);
        let tx = self.gradient(tilt.xi[0], tilt.eta[0]);
        let ty = self.gradient(tilt.xi[1], tilt.eta[1]);
        // Half the difference of squared lengths: linear part less half the square of the increment.
        let (gx, gy) = (Vec3::new(ux[0], uy[0], w[0]), Vec3::new(ux[1], uy[1], w[1]));
        let membrane =
            [less_f64(gx.x, dot(gx, gx), 0.5), less_f64(gy.y, dot(gy, gy), 0.5), gx.y + gy.x - dot(gx, gy)];
        // Tilts are those of the middle of the step, seen from its end: half the spin in the plane lies between.
        let spin = (uy[0] - ux[1]) * 0.25;
        let back = turned(tilt.mean, -spin);
        // Shear along the edges: their mean, and half the difference between opposite ones.
        let m = turned(tilt.mean, spin);
        let along = m[0].mul_add(self.along, xi[2] + inner(tilt.eta, self.skew));
        let across = eta[2] + inner(m, self.across) + inner(tilt.xi, self.skew);
        // A warped element that tips over loses height at its corners.
        let twist = less(skew[2] + inner(m, self.skew), self.warp * 0.5, inner(m, m));
        let shear = self.gradient(along, across);
        Increment {
            membrane,
            curvature: [tx[0], ty[1], tx[1] + ty[0]],
            shear,
            hourglass: [
                self.stabilised(self.link(skew[0], back[0]), ux),
                self.stabilised(self.link(skew[1], back[1]), uy),
                self.stabilised(tilt.skew[0], tx),
                self.stabilised(tilt.skew[1], ty),
                tilt.eta[0].mul_add(self.along, twist),
                twist + inner(tilt.xi, self.across),
                less_f64(dot(times_f64(s.mean, quarter), self.axes[2]), uy[0] - ux[1], 0.5),
            ],
        }
    }

    /// Forces (N) and moments (N m) on the corners.
    #[inline(always)]
    pub fn forces(&self, r: &Resultants<P>) -> ([Vec3<P>; CORNERS], [Vec3<P>; CORNERS]) {
        let area = self.area;
        let [hx, hy] = self.skew;
        let [bx, by] = self.across;
        let (n, m, h) = (&r.membrane, &r.bending, &r.across.hourglass);
        // Drilling makes the shear forces differ.
        let drill = h[6].product(self.inverse_size) * 0.125;
        let (fx, fy) = (self.slope(n[0], n[2] + drill, h[0]), self.slope(n[2] - drill, n[1], h[1]));
        let (mx, my) = (self.slope(m[0], m[2], h[2]), self.slope(m[2], m[1], h[3]));
        let q = self.spread(r.across.shear[0].product(area), r.across.shear[1].product(area));
        let twist = h[4] + h[5];
        let warp = self.warp;
        // Moments conjugate to the tilt, mode by mode: of bending, of shear along the edges, of the rigid links.
        let mean = [
            less(q[0].mul_add(self.along, q[1].mul_add(bx, twist.product(hx))), warp, h[0]),
            less(q[1].mul_add(by, twist.product(hy)), warp, h[1]),
        ];
        let xi = [
            less(q[1].mul_add(hx, h[5].mul_add(bx, mx[0])), warp, fx[1]),
            less(q[1].mul_add(hy, h[5].mul_add(by, my[0])), warp, fy[1]),
        ];
        let eta = [
            less(q[0].mul_add(hx, h[4].mul_add(self.along, mx[1])), warp, fx[0]),
            less(q[0].mul_add(hy, my[1]), warp, fy[0]),
        ];
        let force = Modes {
            mean: Vec3::zero(),
            xi: self.global(fx[0], fy[0], q[0]),
            eta: self.global(fx[1], fy[1], q[1]),
            skew: self.global(h[0], h[1], twist),
        };
        let moment = Modes {
            mean: plus(self.moment(mean), self.axes[2], h[6] * -0.25),
            xi: self.moment(xi),
            eta: self.moment(eta),
            skew: self.moment([h[2], h[3]]),
        };
        (force.back(), moment.back())
    }
    /// Minus a quarter of a vector given along the axes of the element.
    #[inline(always)]
    fn global(&self, x: P, y: P, z: P) -> Vec3<P> {
        let [a, b, c] = self.axes;
        plus(plus(times(a, x * -0.25), b, y * -0.25), c, z * -0.25)
    }
    /// Minus a quarter of the moment that does the work of a tilt.
    #[inline(always)]
    fn moment(&self, tilt: Flat<P>) -> Vec3<P> {
        plus(times(self.axes[0], tilt[1] * 0.25), self.axes[1], tilt[0] * -0.25)
    }
}
