//! Equations of motion during contact.

use super::state::*;
use super::{ContactLaw, Core};
use crate::face::{tangents, Face, Nearest};
use crate::first_touch::FirstTouch;
use clubface_math::ode::{StiffSystem, System};
use clubface_math::{Dual, Mat3, Quat, Scalar, Vec3};

/// Club, ball and law of one contact.
#[derive(Clone, Copy, Debug)]
pub struct Contact<S, L> {
    /// The contact law.
    pub law: L,
    face: Face<S>,
    lever: Vec3<S>,
    inertia: Mat3<S>,
    inverse_inertia: Mat3<S>,
    /// 1 / ball mass + 1 / club mass, 1/kg.
    inverse_mass: S,
    radius: S,
    /// Inertia of the ball, or of its cover, kg m2.
    surface_inertia: S,
    core: Option<Core<S>>,
}

/// The contact force on the ball linearised at one state: its derivatives by the velocity and the position of the
/// ball relative to the clubhead, face axes. The spins act through the velocity of the surfaces.
#[derive(Clone, Copy, Debug)]
pub struct ContactJacobian<S> {
    normal: Vec3<S>,
    point: Vec3<S>,
    arm: S,
    by_velocity: Mat3<S>,
    by_position: Mat3<S>,
}

/// Solves with `I - g A` for the linearised contact: Sherman, Morrison and Woodbury reduce it to 3 x 3.
#[derive(Clone, Copy, Debug)]
pub struct ContactSolver<S> {
    g: S,
    jacobian: ContactJacobian<S>,
    /// (I - g by_velocity K - g^2 by_position / m)^-1, K the mobility of the surfaces.
    inverse: Mat3<S>,
    layer: Layer<S>,
}

/// Implicit step of cover and core on their spring and damper: their difference of spin shrinks by `retained`.
#[derive(Clone, Copy, Debug)]
struct Layer<S> {
    /// Torque impulse on the cover per difference of spin, and per twist.
    by_twisting: S,
    by_twist: S,
    /// Spin of the cover per torque impulse on it.
    compliance: S,
}

impl<S: Scalar, L: ContactLaw<S>> Contact<S, L> {
    /// The contact that begins at first touch.
    #[inline(always)]
    pub fn new(touch: &FirstTouch<S>, law: L) -> Self {
        let core = law.core(touch.ball.inertia, touch.ball.radius);
        let surface_inertia = match core {
            Some(core) => touch.ball.inertia - core.inertia,
            None => touch.ball.inertia,
        };
        Self {
            law,
            face: touch.face,
            lever: touch.lever,
            inertia: touch.inertia,
            inverse_inertia: touch.inertia.inverse(),
            inverse_mass: touch.ball.mass.recip() + touch.club_mass.recip(),
            radius: touch.ball.radius,
            surface_inertia,
            core,
        }
    }

    /// The ball's core, if it has one.
    #[inline(always)]
    pub fn core(&self) -> Option<Core<S>> {
        self.core
    }

    /// The contact point in state `y`.
    #[inline(always)]
    pub fn touching(&self, y: &[S]) -> Touching<S> {
        let nearest = self.face.nearest(Vec3::of(y, POSITION) - self.lever);
        Touching::of(&nearest, self.radius, y)
    }

    /// Normal force, N: zero when apart.
    #[inline(always)]
    pub fn normal_force(&self, t: &Touching<S>) -> S {
        let apart = t.depth.le(S::zero());
        let depth = S::select(apart, S::zero(), t.depth);
        let (depth, rate) = (Dual::<S, 0>::constant(depth), Dual::constant(t.rate));
        let force = self.law.normal_force(depth, rate, Dual::constant(t.curvature), self.radius).value;
        S::select(apart, S::zero(), force)
    }

    /// Tangential force on the ball in state `y`, N.
    #[inline(always)]
    pub fn tangential_force(&self, y: &[S], t: &Touching<S>, normal_force: S) -> Vec3<S> {
        if y.len() == SLIDING {
            if let Some(force) = self.law.remembered(t, normal_force, [y[SLIP], y[SLIP + 1]]) {
                return force;
            }
        }
        let (force, rate) = (Dual::<S, 0>::constant(normal_force), Dual::constant(t.rate));
        let w = Dual::constant(t.sliding.norm_squared());
        t.sliding * -self.law.drag(force, rate, self.radius, w).value
    }

    /// Contact area, m2: zero when apart.
    #[inline(always)]
    pub fn area(&self, t: &Touching<S>) -> S {
        let apart = t.depth.le(S::zero());
        S::select(apart, S::zero(), self.law.area(t.depth, t.curvature, self.radius))
    }

    /// Time derivative of state `y` under normal force `normal_force` and friction `friction` on the ball.
    #[inline(always)]
    pub fn motion<const N: usize>(
        &self,
        y: &[S; N],
        t: &Touching<S>,
        normal_force: S,
        friction: Vec3<S>,
    ) -> [S; N] {
        let force = t.normal * normal_force + friction;
        let club_spin = Vec3::of(y, CLUB_SPIN);
        let ball_spin = Vec3::of(y, BALL_SPIN);
        let velocity = Vec3::of(y, VELOCITY);
        let position = Vec3::of(y, POSITION);
        let mut rate = [S::zero(); N];
        (velocity - club_spin.cross(position)).put(&mut rate, POSITION);
        (force * self.inverse_mass - club_spin.cross(velocity)).put(&mut rate, VELOCITY);
        let club_torque = -t.point.cross(force) - club_spin.cross(self.inertia * club_spin);
        (self.inverse_inertia * club_torque).put(&mut rate, CLUB_SPIN);
        let attitude = Quat { w: y[ATTITUDE], v: Vec3::of(y, ATTITUDE + 1) }.rate(club_spin);
        rate[ATTITUDE] = attitude.w;
        attitude.v.put(&mut rate, ATTITUDE + 1);
        rate[WORK] = normal_force * t.rate;
        rate[WORK + 1] = -friction.dot(t.sliding);
        let mut ball_torque = t.normal.cross(friction) * -t.arm;
        if let (true, Some(core)) = (N == LAYERED, self.core) {
            let core_spin = Vec3::of(y, CORE_SPIN);
            let twist = Vec3::of(y, TWIST);
            let twisting = ball_spin - core_spin;
            let torque = twist * core.stiffness + twisting * core.damping;
            ball_torque = ball_torque - torque;
            (torque * core.inertia.recip() - club_spin.cross(core_spin)).put(&mut rate, CORE_SPIN);
            (twisting - club_spin.cross(twist)).put(&mut rate, TWIST);
            rate[LAYER_WORK] = core.damping * twisting.norm_squared();
        }
        if N == SLIDING {
            let (up, toe) = tangents(t.normal);
            rate[SLIP] = t.sliding.dot(up);
            rate[SLIP + 1] = t.sliding.dot(toe);
        }
        (ball_torque * self.surface_inertia.recip() - club_spin.cross(ball_spin)).put(&mut rate, BALL_SPIN);
        rate
    }
}

impl<S: Scalar, L: ContactLaw<S>, const N: usize> System<S, N> for Contact<S, L> {
    #[inline(always)]
    fn rhs(&self, y: &[S; N]) -> [S; N] {
        let t = self.touching(y);
        let normal_force = self.normal_force(&t);
        self.motion(y, &t, normal_force, self.tangential_force(y, &t, normal_force))
    }
}

/// Friction is stiff (P1's tanh law: some 5e6 1/s). The rest of the contact force, the spring and damper of a layered
/// ball and the approach that drives the penetration stand in the approximate Jacobian too, since a Rosenbrock-W
/// method is the more accurate the less is left out; only slow rotations of the axes are.
impl<S: Scalar, L: ContactLaw<S>, const N: usize> StiffSystem<S, N> for Contact<S, L> {
    type Jacobian = ContactJacobian<S>;
    type Solver = ContactSolver<S>;

    #[inline(always)]
    fn linearize(&self, y: &[S; N]) -> ContactJacobian<S> {
        // The contact force once more, on dual numbers in the directions of position and velocity.
        let mut dual = [Dual::<S, 6>::zero(); SEEN];
        for i in 0..SEEN {
            dual[i] = if i < 6 { Dual::variable(y[i], i) } else { Dual::constant(y[i]) };
        }
        let t = Touching::of(&self.nearest_by_position(y), Dual::constant(self.radius), &dual);
        let apart = t.depth.le(Dual::zero());
        let depth = Dual::select(apart, Dual::zero(), t.depth);
        let normal_force = self.law.normal_force(depth, t.rate, t.curvature, self.radius);
        let normal_force = Dual::select(apart, Dual::zero(), normal_force);
        let drag = self.law.drag(normal_force, t.rate, self.radius, t.sliding.norm_squared());
        let force = t.normal * normal_force - t.sliding * drag;
        let [x, y, z] = [force.x.tangent, force.y.tangent, force.z.tangent];
        ContactJacobian {
            normal: Vec3::new(t.normal.x.value, t.normal.y.value, t.normal.z.value),
            point: Vec3::new(t.point.x.value, t.point.y.value, t.point.z.value),
            arm: t.arm.value,
            by_position: Mat3::from_rows(Vec3::of(&x, 0), Vec3::of(&y, 0), Vec3::of(&z, 0)),
            by_velocity: Mat3::from_rows(Vec3::of(&x, 3), Vec3::of(&y, 3), Vec3::of(&z, 3)),
        }
    }

    #[inline(always)]
    fn factor(&self, jacobian: &ContactJacobian<S>, g: S) -> ContactSolver<S> {
        let t = *jacobian;
        let layer = self.layer::<N>(g);
        let cross = Mat3::cross(t.point);
        let arm = t.arm.squared() * layer.compliance;
        let mobility = Mat3::diagonal(self.inverse_mass + arm)
            + Mat3::outer(t.normal, t.normal * -arm)
            + (cross * (self.inverse_inertia * cross)).scale(-S::one());
        let implicit = Mat3::diagonal(S::one())
            + (t.by_velocity * mobility).scale(-g)
            + t.by_position.scale(-(g * g * self.inverse_mass));
        ContactSolver { g, jacobian: *jacobian, inverse: implicit.inverse(), layer }
    }

    #[inline(always)]
    fn solve(&self, solver: &ContactSolver<S>, b: &[S; N]) -> [S; N] {
        let ContactSolver { g, jacobian: t, inverse, layer } = solver;
        let mut x = *b;
        let position = Vec3::of(b, POSITION);
        let velocity = Vec3::of(b, VELOCITY);
        let club_spin = Vec3::of(b, CLUB_SPIN);
        let mut ball_spin = Vec3::of(b, BALL_SPIN);
        let mut layer_torque = Vec3::zero();
        if N == LAYERED {
            let twisting = ball_spin - Vec3::of(b, CORE_SPIN);
            layer_torque = twisting * layer.by_twisting + Vec3::of(b, TWIST) * layer.by_twist;
            ball_spin = ball_spin - layer_torque * self.surface_inertia.recip();
        }
        // Velocity of the surfaces and position as they would be without a change of the contact force.
        let surface = velocity - club_spin.cross(t.point) + t.normal.cross(ball_spin) * t.arm;
        let moved = position + velocity * *g;
        let impulse = *inverse * (t.by_velocity * surface + t.by_position * moved) * *g;
        let velocity = velocity + impulse * self.inverse_mass;
        (position + velocity * *g).put(&mut x, POSITION);
        velocity.put(&mut x, VELOCITY);
        (club_spin - self.inverse_inertia * t.point.cross(impulse)).put(&mut x, CLUB_SPIN);
        let ball_impulse = t.normal.cross(impulse) * -t.arm;
        ball_spin += ball_impulse * layer.compliance;
        ball_spin.put(&mut x, BALL_SPIN);
        if let (true, Some(core)) = (N == LAYERED, self.core) {
            // What the cover gained beyond its own share went through the layer.
            let passed = ball_impulse * (-(self.surface_inertia * layer.compliance) + 1.0);
            let core_spin = Vec3::of(b, CORE_SPIN) + (layer_torque + passed) * core.inertia.recip();
            core_spin.put(&mut x, CORE_SPIN);
            (Vec3::of(b, TWIST) + (ball_spin - core_spin) * *g).put(&mut x, TWIST);
        }
        x
    }
}

impl<S: Scalar, L: ContactLaw<S>> Contact<S, L> {
    /// The face as seen from the ball centre, with derivatives by its position in the first three directions.
    #[inline(always)]
    fn nearest_by_position(&self, y: &[S]) -> Nearest<Dual<S, 6>> {
        let face = Face { bulge: Dual::constant(self.face.bulge), roll: Dual::constant(self.face.roll) };
        let place = Vec3::of(y, POSITION) - self.lever;
        let nearest = face.nearest(Vec3::new(
            Dual::<S, 3>::variable(place.x, 0),
            Dual::variable(place.y, 1),
            Dual::variable(place.z, 2),
        ));
        Nearest {
            distance: nearest.distance.widen(),
            normal: Vec3::new(nearest.normal.x.widen(), nearest.normal.y.widen(), nearest.normal.z.widen()),
            curvature: nearest.curvature.widen(),
        }
    }

    /// Implicit step over `g` of cover and core: with s their difference of spin and p the twist, the torque is
    /// k (p + g s) + c s at the end, and s shrinks by 1 / (1 + g (c + g k) (1/I_cover + 1/I_core)).
    #[inline(always)]
    fn layer<const N: usize>(&self, g: S) -> Layer<S> {
        let own = self.surface_inertia.recip();
        match (N == LAYERED, self.core) {
            (true, Some(core)) => {
                let rate = g * (core.damping + g * core.stiffness);
                let retained = (rate * (own + core.inertia.recip()) + 1.0).recip();
                Layer {
                    by_twisting: rate * retained,
                    by_twist: g * core.stiffness * retained,
                    // The core takes its part of a torque impulse on the cover.
                    compliance: own * (rate * core.inertia.recip() + 1.0) * retained,
                }
            }
            _ => Layer { by_twisting: S::zero(), by_twist: S::zero(), compliance: own },
        }
    }
}
