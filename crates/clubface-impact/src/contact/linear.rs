//! The contact force linearised at one state, and the implicit step that it makes possible.

use super::dynamics::Contact;
use super::law::{ContactLaw, Indentation, Sliding};
use super::state::*;
use clubface_math::ode::StiffSystem;
use clubface_math::{Dual, Mat3, Scalar, Vec3};

/// The contact force on the ball linearised at one state: its derivatives by the velocity and the position of the
/// ball relative to the clubhead, face axes. The spins act through the velocity of the surfaces.
#[derive(Clone, Copy, Debug)]
pub struct ContactJacobian<S> {
    normal: Vec3<S>,
    point: Vec3<S>,
    arm: S,
    /// By the velocity, N s/m.
    pub by_velocity: Mat3<S>,
    /// By the position, N/m.
    pub by_position: Mat3<S>,
}

/// Solves with `I - g A` for the linearised contact: Sherman, Morrison and Woodbury reduce it to 3 x 3.
#[derive(Clone, Copy, Debug)]
pub struct ContactSolver<S> {
    g: S,
    jacobian: ContactJacobian<S>,
    /// (I - g by_velocity K - g^2 by_position / m)^-1, K the mobility of the surfaces.
    inverse: Mat3<S>,
    layer: Layer<S>,
    give: Give<S>,
}

/// Normal force (N) and drag (N s/m) at one contact point and their derivatives by penetration, by its rate, of the
/// drag also by the normal force and by the squared sliding speed.
#[derive(Clone, Copy, Debug)]
struct Slopes<S> {
    force: S,
    force_by_depth: S,
    force_by_rate: S,
    drag: S,
    drag_by_force: S,
    drag_by_rate: S,
    drag_by_square: S,
}

/// Implicit step of the face, which swings with its own time T: w' at the end is (w' - g w / T^2) `retained` and
/// `by_impulse` times the normal impulse on the ball.
#[derive(Clone, Copy, Debug)]
struct Give<S> {
    retained: S,
    /// g / T^2, 1/s.
    pulled: S,
    /// 1/kg.
    by_impulse: S,
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

/// Friction is stiff (Caldwell and McPhee's tanh law: some 5e6 1/s). The rest of the contact force, the spring and
/// damper of a layered ball and the approach that drives the penetration stand in the approximate Jacobian too, since a
/// Rosenbrock-W method is the more accurate the less is left out; only slow rotations of the axes are.
impl<S: Scalar, L: ContactLaw<S>, const N: usize> StiffSystem<S, N> for Contact<S, L> {
    type Jacobian = ContactJacobian<S>;
    type Solver = ContactSolver<S>;

    /// The slopes of the law come from dual numbers; how penetration and sliding follow from position and velocity is
    /// written out, exact for a plane and a sphere. A torus turns the normal by its mean curvature.
    #[inline(always)]
    fn linearize(&self, y: &[S; N]) -> ContactJacobian<S> {
        let t = self.touching(y);
        let slopes = self.slopes(&t);
        let (normal, sliding) = (t.normal, t.sliding);
        let (club_spin, ball_spin) = (Vec3::from_slice(y, CLUB_SPIN), Vec3::from_slice(y, BALL_SPIN));
        let relative = Vec3::from_slice(y, VELOCITY) - club_spin.cross(t.point);
        let along = Mat3::diagonal(S::one()) + Mat3::outer(normal, -normal);
        // A move of the ball along the face turns the normal by `turn` per length, and takes the contact point along.
        let turn = t.curvature / (t.curvature * t.arm + 1.0);
        let carried = -(turn * t.arm) + 1.0;
        let rate_by_position =
            (relative - normal * normal.dot(relative)) * -turn + normal.cross(club_spin) * carried;
        let surface = relative + normal.cross(ball_spin) * t.arm;
        let turning = club_spin * carried + ball_spin * (turn * t.arm);
        let sliding_by_position = along
            * (Mat3::outer(normal.cross(ball_spin), normal)
                + (Mat3::cross(turning) * along).scale(-S::one()))
            + along.scale(-(turn * normal.dot(surface)))
            + Mat3::outer(normal, sliding * -turn);
        let force_by_position = rate_by_position * slopes.force_by_rate - normal * slopes.force_by_depth;
        let drag_by_position = force_by_position * slopes.drag_by_force
            + rate_by_position * slopes.drag_by_rate
            + sliding_by_position.transpose() * (sliding * (slopes.drag_by_square * 2.0));
        let drag_by_velocity = sliding * (slopes.drag_by_square * 2.0)
            - normal * (slopes.force_by_rate * slopes.drag_by_force + slopes.drag_by_rate);
        ContactJacobian {
            normal,
            point: t.point,
            arm: t.arm,
            by_position: along.scale(turn * slopes.force)
                + Mat3::outer(normal, force_by_position)
                + sliding_by_position.scale(-slopes.drag)
                + Mat3::outer(sliding, -drag_by_position),
            by_velocity: Mat3::outer(normal, normal * -slopes.force_by_rate)
                + along.scale(-slopes.drag)
                + Mat3::outer(sliding, -drag_by_velocity),
        }
    }

    #[inline(always)]
    fn factor(&self, jacobian: &ContactJacobian<S>, g: S) -> ContactSolver<S> {
        let t = *jacobian;
        let layer = self.layer::<N>(g);
        let arm = t.arm.squared() * layer.compliance;
        let mobility = Mat3::diagonal(self.bodies.inverse_ball_mass + arm)
            + Mat3::outer(t.normal, t.normal * -arm)
            + self.bodies.mobility.between(t.point, t.point);
        let by_impulse = t.by_position.scale(self.bodies.inverse_ball_mass)
            + self.bodies.mobility.times_central(t.by_position);
        let mut implicit =
            Mat3::diagonal(S::one()) + (t.by_velocity * mobility).scale(-g) + by_impulse.scale(-(g * g));
        let give = self.give::<N>(g);
        if face(N).is_some() {
            // Face and ball part alike, whichever of them moves along the normal.
            let moved = t.by_velocity * t.normal + t.by_position * t.normal * g;
            implicit = implicit + Mat3::outer(moved, t.normal * -(g * give.by_impulse));
        }
        ContactSolver { g, jacobian: *jacobian, inverse: implicit.inverse(), layer, give }
    }

    #[inline(always)]
    fn solve(&self, solver: &ContactSolver<S>, b: &[S; N]) -> [S; N] {
        let ContactSolver { g, jacobian: t, inverse, layer, give } = solver;
        let mut x = *b;
        let position = Vec3::from_slice(b, POSITION);
        let velocity = Vec3::from_slice(b, VELOCITY);
        let club_spin = Vec3::from_slice(b, CLUB_SPIN);
        let mut ball_spin = Vec3::from_slice(b, BALL_SPIN);
        let mut layer_torque = Vec3::zero();
        if layered(N) {
            let twisting = ball_spin - Vec3::from_slice(b, CORE_SPIN);
            layer_torque = twisting * layer.by_twisting + Vec3::from_slice(b, TWIST) * layer.by_twist;
            ball_spin = ball_spin - layer_torque * self.inverse_surface_inertia;
        }
        // Velocity of the surfaces and position as they would be without a change of the contact force.
        let mut surface = velocity - club_spin.cross(t.point) + t.normal.cross(ball_spin) * t.arm;
        let mut moved = position + velocity * *g;
        let mut swing = S::zero();
        if let Some(at) = face(N) {
            swing = (b[at + 1] - b[at] * give.pulled) * give.retained;
            surface += t.normal * swing;
            moved += t.normal * (b[at] + swing * *g);
        }
        let impulse = *inverse * (t.by_velocity * surface + t.by_position * moved) * *g;
        let (slowed, turned) = self.bodies.mobility.response(impulse, t.point.cross(impulse));
        let velocity = velocity + impulse * self.bodies.inverse_ball_mass + slowed;
        (position + velocity * *g).put(&mut x, POSITION);
        velocity.put(&mut x, VELOCITY);
        (club_spin - turned).put(&mut x, CLUB_SPIN);
        if let Some(at) = face(N) {
            x[at + 1] = swing + t.normal.dot(impulse) * give.by_impulse;
            x[at] = b[at] + x[at + 1] * *g;
        }
        let ball_impulse = t.normal.cross(impulse) * -t.arm;
        ball_spin += ball_impulse * layer.compliance;
        ball_spin.put(&mut x, BALL_SPIN);
        if layered(N) {
            // What the cover gained beyond its own share went through the layer.
            let passed = ball_impulse * (-(self.surface_inertia * layer.compliance) + 1.0);
            let core_spin =
                Vec3::from_slice(b, CORE_SPIN) + (layer_torque + passed) * self.inverse_core_inertia;
            core_spin.put(&mut x, CORE_SPIN);
            (Vec3::from_slice(b, TWIST) + (ball_spin - core_spin) * *g).put(&mut x, TWIST);
        }
        x
    }
}

impl<S: Scalar, L: ContactLaw<S>> Contact<S, L> {
    /// The law at one contact point with its partial derivatives.
    #[inline(always)]
    fn slopes(&self, t: &ContactPoint<S>) -> Slopes<S> {
        let apart = t.depth.le(S::zero());
        let depth = S::select(apart, S::zero(), t.depth);
        let (depth, rate) = (Dual::<S, 2>::variable(depth, 0), Dual::variable(t.rate, 1));
        let (curvature, radius) = (Dual::constant(t.curvature), self.radius);
        let force = self.law.normal_force(Indentation { depth, rate, curvature, radius });
        let force = Dual::select(apart, Dual::zero(), force);
        let w = Dual::<S, 3>::variable(t.sliding.norm_squared(), 2);
        let (normal_force, rate) = (Dual::variable(force.value, 0), Dual::variable(t.rate, 1));
        let drag = self.law.drag(Sliding { normal_force, rate, radius, w });
        Slopes {
            force: force.value,
            force_by_depth: force.tangent[0],
            force_by_rate: force.tangent[1],
            drag: drag.value,
            drag_by_force: drag.tangent[0],
            drag_by_rate: drag.tangent[1],
            drag_by_square: drag.tangent[2],
        }
    }

    /// Implicit step over `g` of the face.
    #[inline(always)]
    fn give<const N: usize>(&self, g: S) -> Give<S> {
        if face(N).is_none() {
            return Give { retained: S::zero(), pulled: S::zero(), by_impulse: S::zero() };
        }
        let pulled = g / self.giving.square_time;
        let retained = (g * pulled + 1.0).recip();
        Give { retained, pulled, by_impulse: self.giving.compliance / self.giving.square_time * retained }
    }

    /// Implicit step over `g` of cover and core: with s their difference of spin and p the twist, the torque is
    /// k (p + g s) + c s at the end, and s shrinks by 1 / (1 + g (c + g k) (1/I_cover + 1/I_core)).
    #[inline(always)]
    fn layer<const N: usize>(&self, g: S) -> Layer<S> {
        let own = self.inverse_surface_inertia;
        match (layered(N), self.core) {
            (true, Some(core)) => {
                let rate = g * (core.damping + g * core.stiffness);
                let retained = (rate * (own + self.inverse_core_inertia) + 1.0).recip();
                Layer {
                    by_twisting: rate * retained,
                    by_twist: g * core.stiffness * retained,
                    // The core takes its part of a torque impulse on the cover.
                    compliance: own * (rate * self.inverse_core_inertia + 1.0) * retained,
                }
            }
            _ => Layer { by_twisting: S::zero(), by_twist: S::zero(), compliance: own },
        }
    }
}
