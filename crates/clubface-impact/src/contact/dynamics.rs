//! Equations of motion during contact.

use super::state::*;
use super::{ContactLaw, Core};
use crate::face::{tangents, Face};
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

/// The part of the motion that a force at the contact point drives, linearised: friction against sliding velocity.
#[derive(Clone, Copy, Debug)]
pub struct FrictionJacobian<S> {
    touching: Touching<S>,
    /// Derivative of the friction force by the sliding velocity, N s/m.
    slope: Mat3<S>,
    /// Relative acceleration of the surfaces per force at the contact point, 1/kg.
    mobility: Mat3<S>,
}

/// Force that opposes a change of sliding velocity over an implicit step, with the contact point it acts at.
#[derive(Clone, Copy, Debug)]
pub struct FrictionSolver<S> {
    normal: Vec3<S>,
    point: Vec3<S>,
    arm: S,
    gain: Mat3<S>,
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
        Touching::of(&self.face, self.lever, self.radius, y)
    }

    /// Normal force, N: zero when apart.
    #[inline(always)]
    pub fn normal_force(&self, t: &Touching<S>) -> S {
        let apart = t.depth.le(S::zero());
        let depth = S::select(apart, S::zero(), t.depth);
        let force = self.law.normal_force(depth, t.rate, t.curvature, self.radius);
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
        let w = Dual::constant(t.sliding.norm_squared());
        t.sliding * -self.law.drag(normal_force, t.rate, self.radius, w).value
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

/// Friction is the only stiff part (P1's tanh law: some 5e6 1/s). It acts through the three components of the force
/// at the contact point, so the implicit equations reduce to 3 x 3 (Sherman, Morrison and Woodbury).
impl<S: Scalar, L: ContactLaw<S>, const N: usize> StiffSystem<S, N> for Contact<S, L> {
    type Jacobian = FrictionJacobian<S>;
    type Solver = FrictionSolver<S>;

    #[inline(always)]
    fn linearize(&self, y: &[S; N]) -> FrictionJacobian<S> {
        let t = self.touching(y);
        let normal_force = self.normal_force(&t);
        let w = Dual::variable(t.sliding.norm_squared(), 0);
        let drag = self.law.drag(normal_force, t.rate, self.radius, w);
        let n = t.normal;
        let slope = (Mat3::diagonal(S::one()) + Mat3::outer(n, -n)).scale(-drag.value)
            + Mat3::outer(t.sliding, t.sliding * (drag.tangent[0] * -2.0));
        let cross = Mat3::cross(t.point);
        let mobility = Mat3::diagonal(self.inverse_mass + t.arm.squared() / self.surface_inertia)
            + (cross * (self.inverse_inertia * cross)).scale(-S::one());
        FrictionJacobian { touching: t, slope, mobility }
    }

    #[inline(always)]
    fn factor(&self, jacobian: &FrictionJacobian<S>, g: S) -> FrictionSolver<S> {
        let FrictionJacobian { touching, slope, mobility } = *jacobian;
        let implicit = Mat3::diagonal(S::one()) + (mobility * slope).scale(-g);
        FrictionSolver {
            normal: touching.normal,
            point: touching.point,
            arm: touching.arm,
            gain: (slope * implicit.inverse()).scale(g),
        }
    }

    #[inline(always)]
    fn solve(&self, solver: &FrictionSolver<S>, b: &[S; N]) -> [S; N] {
        let FrictionSolver { normal, point, arm, gain } = *solver;
        let sliding = Vec3::of(b, VELOCITY) - Vec3::of(b, CLUB_SPIN).cross(point)
            + normal.cross(Vec3::of(b, BALL_SPIN)) * arm;
        let force = gain * sliding;
        let mut x = *b;
        (Vec3::of(b, VELOCITY) + force * self.inverse_mass).put(&mut x, VELOCITY);
        (Vec3::of(b, CLUB_SPIN) - self.inverse_inertia * point.cross(force)).put(&mut x, CLUB_SPIN);
        let ball_torque = normal.cross(force) * -arm;
        (Vec3::of(b, BALL_SPIN) + ball_torque * self.surface_inertia.recip()).put(&mut x, BALL_SPIN);
        x
    }
}
