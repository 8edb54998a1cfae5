//! The four-node shell with one point in its plane: velocities to strain rates, stresses to forces.
//!
//! The element of Belytschko and Tsay (Int. J. Numer. Methods Eng. 19, 1983) in a frame that goes with it, taken apart into four modes of the
//! reference square: translation, the two uniform gradients, and the bilinear (hourglass) mode. Three things are better than in the original:
//!
//! * a warped element is the flat one through its middle, to whose corners the nodes are tied by rigid links along its normal (as in
//!   MacNeal's QUAD4), which couples membrane and bending as the corrections of Belytschko, Wong and Chiang (Comput. Methods Appl.
//!   Mech. Eng. 96, 1992) do, and keeps moments in balance;
//! * transverse shear is taken along the edges, as in the element of Bathe and Dvorkin (Int. J. Numer. Methods Eng. 21, 1985): no locking,
//!   and no resistance to pure twist;
//! * the hourglass modes get the stiffness that a rectangle has in them (membrane: in-plane bending; rotations: as the fully integrated
//!   plate; shear: the difference between opposite edges), so there is no coefficient to choose.
//!
//! Membrane strain increments are differences of squared lengths, and the others are exact to the second order in the rotation of a step, so
//! that rigid motion makes no stress.

use crate::material::{cross, dot};
use clubface_math::{Pack, Scalar, Vec3};

/// Nodes of a quadrilateral.
pub const CORNERS: usize = 4;
/// Stabilised modes: the hourglass modes (membrane along both axes, rotation along both, shear along both pairs of edges), and drilling.
pub const HOURGLASS: usize = 7;

/// One quantity at the corners as modes of the reference square: mean, slopes, bilinear part.
#[derive(Clone, Copy)]
struct Modes<T> {
    mean: T,
    xi: T,
    eta: T,
    skew: T,
}

impl<P: Scalar> Modes<Vec3<P>> {
    /// Modes of vectors at the corners (-1,-1), (1,-1), (1,1), (-1,1), four times as large.
    #[inline(always)]
    fn of(x: &[Vec3<P>; CORNERS]) -> Self {
        let (a, b, c, d) = (x[1] + x[0], x[2] + x[3], x[1] - x[0], x[2] - x[3]);
        Self { mean: b + a, eta: b - a, xi: d + c, skew: d - c }
    }
    /// The transpose of [`Modes::of`].
    #[inline(always)]
    fn back(self) -> [Vec3<P>; CORNERS] {
        let (a, b) = (self.mean - self.eta, self.mean + self.eta);
        let (c, d) = (self.xi - self.skew, self.xi + self.skew);
        [a - c, a + c, b + d, b - d]
    }
}

/// A vector in the plane of the element.
type Flat<P> = [P; 2];

#[inline(always)]
fn inner<P: Scalar>(a: Flat<P>, b: Flat<P>) -> P {
    a[0] * b[0] + a[1] * b[1]
}

/// A vector turned by a small angle.
#[inline(always)]
fn turned<P: Scalar>(v: Flat<P>, angle: P) -> Flat<P> {
    [v[0] - angle * v[1], v[1] + angle * v[0]]
}

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

/// What acts across the section or beside its strains.
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
    /// Area of the flat element, m2.
    pub area: P,
}

impl<P: Pack> Quadrilateral<P> {
    /// From the positions of the corners, m, counterclockwise seen from outside.
    #[inline(always)]
    pub fn new(corners: &[Vec3<P>; CORNERS]) -> Self {
        let modes = Modes::of(corners);
        let quarter = P::from_f64(0.25);
        let (xi, eta, skew) = (modes.xi * quarter, modes.eta * quarter, modes.skew * quarter);
        let normal = cross(xi, eta);
        let size = dot(normal, normal).sqrt();
        let square = dot(xi, xi);
        let along = square.sqrt();
        let inverse_along = along.recip();
        let inverse_size = size.recip();
        let first = xi * inverse_along;
        let third = normal * inverse_size;
        let second = cross(third, first);
        Self {
            along,
            across: [dot(eta, first), size * inverse_along],
            skew: [dot(skew, first), dot(skew, second)],
            warp: dot(skew, third),
            inverse_along,
            inverse_across: along * inverse_size,
            area: size * 4.0,
            axes: [first, second, third],
        }
    }

    /// Ratio of the sides, across over along.
    #[inline(always)]
    pub fn aspect(&self) -> (P, P) {
        (self.across[1] * self.inverse_along, self.along * self.inverse_across)
    }

    /// Slopes in the plane from the modes of a component.
    #[inline(always)]
    fn gradient(&self, xi: P, eta: P) -> Flat<P> {
        let x = xi * self.inverse_along;
        [x, (eta - x * self.across[0]) * self.inverse_across]
    }
    /// The transpose of [`Quadrilateral::gradient`].
    #[inline(always)]
    fn spread(&self, x: P, y: P) -> Flat<P> {
        let eta = y * self.inverse_across;
        [(x - eta * self.across[0]) * self.inverse_along, eta]
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
        skew - gradient[0] * self.skew[0] - gradient[1] * self.skew[1]
    }

    /// Velocity of a corner of the flat element, seen through its rigid link.
    #[inline(always)]
    fn link(&self, velocity: P, tilt: P) -> P {
        velocity - self.warp * tilt
    }
    /// Forces on the slopes of a component from a row of resultants and the force of its hourglass mode.
    #[inline(always)]
    fn slope(&self, x: P, y: P, hourglass: P) -> Flat<P> {
        self.spread(x * self.area - hourglass * self.skew[0], y * self.area - hourglass * self.skew[1])
    }

    /// Strain increments from velocities (m/s) and angular velocities (rad/s) of the corners over a step, s.
    #[inline(always)]
    pub fn increment(
        &self,
        velocities: &[Vec3<P>; CORNERS],
        spins: &[Vec3<P>; CORNERS],
        dt: P,
    ) -> Increment<P> {
        let quarter = dt * 0.25;
        let (v, s) = (Modes::of(velocities), Modes::of(spins));
        let tilt = Modes {
            mean: self.tilt(s.mean * quarter),
            xi: self.tilt(s.xi * quarter),
            eta: self.tilt(s.eta * quarter),
            skew: self.tilt(s.skew * quarter),
        };
        let xi = self.local(v.xi * quarter);
        let eta = self.local(v.eta * quarter);
        let skew = self.local(v.skew * quarter);
        // Rigid links: the corner of the flat element is `warp` times the sign of the bilinear mode below the node.
        let ux = self.gradient(self.link(xi[0], tilt.eta[0]), self.link(eta[0], tilt.xi[0]));
        let uy = self.gradient(self.link(xi[1], tilt.eta[1]), self.link(eta[1], tilt.xi[1]));
        let w = self.gradient(xi[2], eta[2]);
        let tx = self.gradient(tilt.xi[0], tilt.eta[0]);
        let ty = self.gradient(tilt.xi[1], tilt.eta[1]);
        // Half the difference of squared lengths: linear part less half the square of the increment.
        let (gx, gy) = (Vec3::new(ux[0], uy[0], w[0]), Vec3::new(ux[1], uy[1], w[1]));
        let membrane = [gx.x - dot(gx, gx) * 0.5, gy.y - dot(gy, gy) * 0.5, gx.y + gy.x - dot(gx, gy)];
        // Tilts are those of the middle of the step, seen from its end: half the spin in the plane lies between.
        let spin = (uy[0] - ux[1]) * 0.25;
        let back = turned(tilt.mean, -spin);
        // Shear along the edges: their mean, and half the difference between opposite ones.
        let m = turned(tilt.mean, spin);
        let along = xi[2] + m[0] * self.along + inner(tilt.eta, self.skew);
        let across = eta[2] + inner(m, self.across) + inner(tilt.xi, self.skew);
        // A warped element that tips over loses height at its corners.
        let twist = skew[2] + inner(m, self.skew) - self.warp * inner(m, m) * 0.5;
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
                twist + tilt.eta[0] * self.along,
                twist + inner(tilt.xi, self.across),
                dot(s.mean * quarter, self.axes[2]) - (uy[0] - ux[1]) * 0.5,
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
        let drill = h[6] / area * 0.5;
        let (fx, fy) = (self.slope(n[0], n[2] + drill, h[0]), self.slope(n[2] - drill, n[1], h[1]));
        let (mx, my) = (self.slope(m[0], m[2], h[2]), self.slope(m[2], m[1], h[3]));
        let q = self.spread(r.across.shear[0] * area, r.across.shear[1] * area);
        let twist = h[4] + h[5];
        let warp = self.warp;
        // Moments conjugate to the tilt, mode by mode: of bending, of shear along the edges, of the rigid links.
        let mean =
            [q[0] * self.along + q[1] * bx + twist * hx - warp * h[0], q[1] * by + twist * hy - warp * h[1]];
        let xi = [mx[0] + q[1] * hx + h[5] * bx - warp * fx[1], my[0] + q[1] * hy + h[5] * by - warp * fy[1]];
        let eta = [mx[1] + q[0] * hx + h[4] * self.along - warp * fx[0], my[1] + q[0] * hy - warp * fy[0]];
        let force = Modes {
            mean: Vec3::zero(),
            xi: self.global(fx[0], fy[0], q[0]),
            eta: self.global(fx[1], fy[1], q[1]),
            skew: self.global(h[0], h[1], twist),
        };
        let moment = Modes {
            mean: self.moment(mean) + self.axes[2] * (h[6] * -0.25),
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
        (a * x + b * y + c * z) * P::from_f64(-0.25)
    }
    /// Minus a quarter of the moment that does the work of a tilt.
    #[inline(always)]
    fn moment(&self, tilt: Flat<P>) -> Vec3<P> {
        (self.axes[1] * tilt[0] - self.axes[0] * tilt[1]) * P::from_f64(-0.25)
    }
}
