//! Equations of motion during contact.

use super::head_motion::HeadMotion;
use super::law::{ContactLaw, Core, Indentation, Sliding};
use super::state::*;
use crate::face::{Face, tangents};
use crate::first_touch::FirstTouch;
use crate::giving_face::GivingFace;
use crate::head_inertia::{HeadInertia, HeadMobility};
use clubface_math::ode::System;
use clubface_math::{Computation, Dual, Quat, Scalar, Vec3};

/// Club, ball and law of one contact.
#[derive(Clone, Copy, Debug)]
pub struct Contact<S, L> {
    /// The contact law.
    pub law: L,
    pub(super) face: Face<S>,
    pub(super) giving: GivingFace<S>,
    pub(super) lever: Vec3<S>,
    pub(super) bodies: Bodies<S>,
    pub(super) radius: S,
    /// Inertia of the ball, or of its cover, kg m2.
    pub(super) surface_inertia: S,
    pub(super) inverse_surface_inertia: S,
    pub(super) core: Option<Core<S>>,
    /// One over the inertia of the core, 1/(kg m2); zero if there is none.
    pub(super) inverse_core_inertia: S,
}

/// What acts between head and ball at one instant, in axes fixed in the head.
#[derive(Clone, Copy, Debug)]
pub struct Loads<S> {
    /// Force on the ball, N; its opposite acts on the head.
    pub force: Vec3<S>,
    /// Where it acts, from the CG of the head, m.
    pub point: Vec3<S>,
    /// Torque on the ball, or on the cover of a layered one, about its centre, N m.
    pub torque: Vec3<S>,
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
            giving: GivingFace::from_touch(touch),
            lever: touch.lever,
            bodies: Bodies::new(touch),
            radius: touch.ball.radius,
            surface_inertia,
            inverse_surface_inertia: surface_inertia.recip(),
            core,
            inverse_core_inertia: core.map_or(S::zero(), |core| core.inertia.recip()),
        }
    }

    /// The ball's core, if it has one.
    #[inline(always)]
    pub fn core(&self) -> Option<Core<S>> {
        self.core
    }

    /// The contact point in state `y`.
    #[inline(always)]
    pub fn touching(&self, y: &[S]) -> ContactPoint<S> {
        let nearest = self.face.nearest(Vec3::from_slice(y, POSITION) - self.lever);
        ContactPoint::new(&nearest, self.radius, y)
    }

    /// Normal force, N: zero when apart.
    #[inline(always)]
    pub fn normal_force(&self, t: &ContactPoint<S>) -> S {
        let apart = t.depth.le(S::zero());
        let depth = S::select(apart, S::zero(), t.depth);
        let [depth, rate, curvature] = [depth, t.rate, t.curvature].map(Dual::<S, 0>::constant);
        let force = self.law.normal_force(Indentation { depth, rate, curvature, radius: self.radius }).value;
        S::select(apart, S::zero(), force)
    }

    /// Tangential force on the ball in state `y`, N.
    #[inline(always)]
    pub fn tangential_force(&self, y: &[S], t: &ContactPoint<S>, normal_force: S) -> Vec3<S> {
        if sliding(y.len())
            && let Some(force) = self.law.remembered(t, normal_force, [y[SLIP], y[SLIP + 1]])
        {
            return force;
        }
        let [normal_force, rate, w] =
            [normal_force, t.rate, t.sliding.norm_squared()].map(Dual::<S, 0>::constant);
        t.sliding * -self.law.drag(Sliding { normal_force, rate, radius: self.radius, w }).value
    }

    /// Contact area, m2: zero when apart.
    #[inline(always)]
    pub fn area(&self, t: &ContactPoint<S>) -> S {
        let apart = t.depth.le(S::zero());
        S::select(apart, S::zero(), self.law.area(t.depth, t.curvature, self.radius))
    }

    /// Time derivative of state `y` under normal force `normal_force` and friction `friction` on the ball.
    #[inline(always)]
    pub fn motion<const N: usize>(
        &self,
        y: &[S; N],
        t: &ContactPoint<S>,
        normal_force: S,
        friction: Vec3<S>,
    ) -> [S; N] {
        let mut rate = [S::zero(); N];
        let loads = self.loads(y, t, normal_force, friction, &mut rate);
        self.bodies.put_rates(y, &loads, self.inverse_surface_inertia, &mut rate);
        rate
    }

    /// What acts between head and ball in state `y` under these forces, and the rates of the states behind those of the
    /// bodies, which go into `rate`.
    #[inline(always)]
    pub(super) fn loads<const N: usize>(
        &self,
        y: &[S; N],
        t: &ContactPoint<S>,
        normal_force: S,
        friction: Vec3<S>,
        rate: &mut [S; N],
    ) -> Loads<S> {
        let force = t.normal * normal_force + friction;
        let club_spin = Vec3::from_slice(y, CLUB_SPIN);
        let mut torque = t.normal.cross(friction) * -t.arm;
        let mut layer_work = S::zero();
        if let (true, Some(core)) = (layered(N), self.core) {
            let core_spin = Vec3::from_slice(y, CORE_SPIN);
            let twist = Vec3::from_slice(y, TWIST);
            let twisting = Vec3::from_slice(y, BALL_SPIN) - core_spin;
            let between = twist * core.stiffness + twisting * core.damping;
            torque = torque - between;
            (between * self.inverse_core_inertia - club_spin.cross(core_spin)).put(rate, CORE_SPIN);
            (twisting - club_spin.cross(twist)).put(rate, TWIST);
            layer_work = core.damping * twisting.norm_squared();
        }
        if recorded(N) {
            let work = [normal_force * t.rate, -friction.dot(t.sliding), layer_work];
            rate[N - LEDGER..].copy_from_slice(&work);
        }
        if let Some(at) = face(N) {
            let GivingFace { compliance, square_time, .. } = self.giving;
            rate[at] = y[at + 1];
            rate[at + 1] = (compliance * normal_force - y[at]) / square_time;
        }
        if sliding(N) {
            let (up, toe) = tangents(t.normal);
            rate[SLIP] = t.sliding.dot(up);
            rate[SLIP + 1] = t.sliding.dot(toe);
        }
        Loads { force, point: t.point, torque }
    }
}

/// How head and ball respond to what acts between them.
#[derive(Clone, Copy, Debug)]
pub struct Bodies<S> {
    pub(super) head: HeadInertia<S>,
    pub(super) mobility: HeadMobility<S>,
    pub(super) head_motion: HeadMotion<S>,
    pub(super) inverse_ball_mass: S,
}

impl<S: Scalar> Bodies<S> {
    /// The bodies of an impact.
    #[inline(always)]
    pub fn new(touch: &FirstTouch<S>) -> Self {
        Self {
            head: touch.head,
            mobility: touch.head_mobility(),
            head_motion: HeadMotion::new(touch),
            inverse_ball_mass: touch.ball.mass.recip(),
        }
    }

    /// Writes the rates of the first [`SOLID`] states, those of the bodies, in state `y` under these loads.
    #[inline(always)]
    pub fn put_rates(&self, y: &[S], loads: &Loads<S>, inverse_surface_inertia: S, rate: &mut [S]) {
        let Loads { force, point, torque } = *loads;
        let club_spin = Vec3::from_slice(y, CLUB_SPIN);
        let ball_spin = Vec3::from_slice(y, BALL_SPIN);
        let velocity = Vec3::from_slice(y, VELOCITY);
        let position = Vec3::from_slice(y, POSITION);
        (velocity - club_spin.cross(position)).put(rate, POSITION);
        let (club_rate, club_spin_rate) = self.club_rates(y, point, force);
        (force * self.inverse_ball_mass - club_rate - club_spin.cross(velocity)).put(rate, VELOCITY);
        club_spin_rate.put(rate, CLUB_SPIN);
        let attitude = Quat { w: y[ATTITUDE], v: Vec3::from_slice(y, ATTITUDE + 1) }.rate(club_spin);
        rate[ATTITUDE] = attitude.w;
        attitude.v.put(rate, ATTITUDE + 1);
        (torque * inverse_surface_inertia - club_spin.cross(ball_spin)).put(rate, BALL_SPIN);
    }

    /// Acceleration of the clubhead's CG and its angular acceleration in state `y` under `force` on the ball.
    #[inline(always)]
    fn club_rates(&self, y: &[S], point: Vec3<S>, force: Vec3<S>) -> (Vec3<S>, Vec3<S>) {
        let moment = -point.cross(force);
        let spin = Vec3::from_slice(y, CLUB_SPIN);
        if self.head.added.is_none() {
            return self.mobility.response(-force, moment - spin.cross(self.head.inertia * spin));
        }
        S::outline(AttachedRates { bodies: self, y, force, moment, spin })
    }
}

/// Rates of an attached head, a function of its own.
struct AttachedRates<'a, S> {
    bodies: &'a Bodies<S>,
    y: &'a [S],
    force: Vec3<S>,
    moment: Vec3<S>,
    spin: Vec3<S>,
}

impl<S: Scalar> Computation for AttachedRates<'_, S> {
    type Output = (Vec3<S>, Vec3<S>);
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { bodies, y, force, moment, spin } = self;
        let velocity = bodies.head_motion.velocity(&bodies.head, y);
        let (linear, angular) = bodies.head.momenta(velocity, spin);
        let (rate, spin_rate) = bodies
            .mobility
            .response(linear.cross(spin) - force, angular.cross(spin) + linear.cross(velocity) + moment);
        (rate + spin.cross(velocity), spin_rate)
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
