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
    inverse_surface_inertia: S,
    core: Option<Core<S>>,
    /// Of the core; zero if there is none.
    inverse_core_inertia: S,
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

/// Normal force (N) and drag (N s/m) at one contact point and their derivatives by penetration, by its rate, of the drag
/// also by the normal force and by the squared sliding speed.
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
        if sliding(y.len()) {
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
        let mut ball_torque = t.normal.cross(friction) * -t.arm;
        let mut layer_work = S::zero();
        if let (true, Some(core)) = (layered(N), self.core) {
            let core_spin = Vec3::of(y, CORE_SPIN);
            let twist = Vec3::of(y, TWIST);
            let twisting = ball_spin - core_spin;
            let torque = twist * core.stiffness + twisting * core.damping;
            ball_torque = ball_torque - torque;
            (torque * self.inverse_core_inertia - club_spin.cross(core_spin)).put(&mut rate, CORE_SPIN);
            (twisting - club_spin.cross(twist)).put(&mut rate, TWIST);
            layer_work = core.damping * twisting.norm_squared();
        }
        if recorded(N) {
            let work = [normal_force * t.rate, -friction.dot(t.sliding), layer_work];
            rate[N - LEDGER..].copy_from_slice(&work);
        }
        if sliding(N) {
            let (up, toe) = tangents(t.normal);
            rate[SLIP] = t.sliding.dot(up);
            rate[SLIP + 1] = t.sliding.dot(toe);
        }
        (ball_torque * self.inverse_surface_inertia - club_spin.cross(ball_spin)).put(&mut rate, BALL_SPIN);
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

    /// The slopes of the law come from dual numbers; how penetration and sliding follow from position and velocity is
    /// written out, exact for a plane and a sphere. A torus turns the normal by its mean curvature.
    #[inline(always)]
    fn linearize(&self, y: &[S; N]) -> ContactJacobian<S> {
        let t = self.touching(y);
        let slopes = self.slopes(&t);
        let (normal, sliding) = (t.normal, t.sliding);
        let (club_spin, ball_spin) = (Vec3::of(y, CLUB_SPIN), Vec3::of(y, BALL_SPIN));
        let relative = Vec3::of(y, VELOCITY) - club_spin.cross(t.point);
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
        if layered(N) {
            let twisting = ball_spin - Vec3::of(b, CORE_SPIN);
            layer_torque = twisting * layer.by_twisting + Vec3::of(b, TWIST) * layer.by_twist;
            ball_spin = ball_spin - layer_torque * self.inverse_surface_inertia;
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
        if layered(N) {
            // What the cover gained beyond its own share went through the layer.
            let passed = ball_impulse * (-(self.surface_inertia * layer.compliance) + 1.0);
            let core_spin = Vec3::of(b, CORE_SPIN) + (layer_torque + passed) * self.inverse_core_inertia;
            core_spin.put(&mut x, CORE_SPIN);
            (Vec3::of(b, TWIST) + (ball_spin - core_spin) * *g).put(&mut x, TWIST);
        }
        x
    }
}

impl<S: Scalar, L: ContactLaw<S>> Contact<S, L> {
    /// The law at one contact point with its partial derivatives.
    #[inline(always)]
    fn slopes(&self, t: &Touching<S>) -> Slopes<S> {
        let apart = t.depth.le(S::zero());
        let depth = S::select(apart, S::zero(), t.depth);
        let (depth, rate) = (Dual::<S, 2>::variable(depth, 0), Dual::variable(t.rate, 1));
        let force = self.law.normal_force(depth, rate, Dual::constant(t.curvature), self.radius);
        let force = Dual::select(apart, Dual::zero(), force);
        let square = Dual::<S, 3>::variable(t.sliding.norm_squared(), 2);
        let (load, rate) = (Dual::variable(force.value, 0), Dual::variable(t.rate, 1));
        let drag = self.law.drag(load, rate, self.radius, square);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{initial, SOLID};
    use crate::model::Model;
    use crate::models::area::Area;
    use crate::models::volumetric::Volumetric;
    use crate::shot::INPUT_COUNT;

    /// A drive on a face of equal bulge and roll, 1 / `curvature`.
    fn drive(curvature: f64) -> FirstTouch<f64> {
        let mut inputs = [0.0; INPUT_COUNT];
        inputs[..8].copy_from_slice(&[48.0, 0.03, 0.04, 0.22, -0.02, 0.0, 0.012, -0.007]);
        inputs[11..15].copy_from_slice(&[0.204, 40.8e-3, 11.4e-3, 1e-3]);
        inputs[15..21].copy_from_slice(&[2843e-7, 5679e-7, 4085e-7, -733e-7, 530.2e-7, 0.5e-7]);
        inputs[21..27].copy_from_slice(&[0.17, 1.0 / curvature, 1.0 / curvature, 0.12, 0.06, 1.0]);
        inputs[27..].copy_from_slice(&[0.0459, 0.0213, 83.36e-7]);
        FirstTouch::of_inputs(&inputs)
    }

    /// Contact force on the ball in state `y`, from the acceleration.
    fn force<L: ContactLaw<f64>>(contact: &Contact<f64, L>, y: &[f64; SOLID]) -> Vec3<f64> {
        let acceleration = Vec3::of(&contact.rhs(y), VELOCITY);
        let turned = Vec3::of(y, CLUB_SPIN).cross(Vec3::of(y, VELOCITY));
        (acceleration + turned) * contact.inverse_mass.recip()
    }

    /// Against central differences. A third of the speed and a spin near rolling, so that the ball slides at some m/s.
    fn assert_linearized<L: ContactLaw<f64>>(law: L, curvature: f64, tolerance: f64) {
        let touch = drive(curvature);
        let contact = Contact::new(&touch, law);
        let mut y = initial::<f64, SOLID>(&touch);
        let within = (touch.normal * -0.003).array();
        for i in 0..3 {
            y[POSITION + i] += within[i];
            y[VELOCITY + i] *= 0.3;
            y[CLUB_SPIN + i] += [30.0, -50.0, 20.0][i];
            y[BALL_SPIN + i] += [60.0, -90.0, 120.0][i];
        }
        let found = contact.linearize(&y);
        let bodies = [(POSITION, found.by_position, 1e-8), (VELOCITY, found.by_velocity, 1e-5)];
        for (start, jacobian, h) in bodies {
            let columns = jacobian.transpose().rows;
            let largest = columns.iter().map(|column| column.norm()).fold(0.0, f64::max);
            for i in 0..3 {
                let at = |shift: f64| {
                    let mut moved = y;
                    moved[start + i] += shift;
                    force(&contact, &moved)
                };
                let difference = (at(h) - at(-h)) * (0.5 / h);
                let error = (columns[i] - difference).norm() / largest;
                assert!(
                    error < tolerance,
                    "state {}: {:?}, differences {difference:?}",
                    start + i,
                    columns[i]
                );
            }
        }
    }

    /// Rounding of a force of 10 kN over the change that a step of the differences makes: below 1e-6.
    #[test]
    fn the_linearized_force_is_that_of_differences() {
        let defaults = |parameters: &[crate::model::Parameter]| -> Vec<f64> {
            parameters.iter().map(|parameter| parameter.default).collect()
        };
        let volumetric = Volumetric::from_values(&defaults(Volumetric::PARAMETERS));
        let mut area = Area::from_values(&defaults(Area::PARAMETERS));
        area.area_damping = 20.0;
        for curvature in [1e-9, 1.0 / 0.305, 5.0] {
            assert_linearized(volumetric, curvature, 1e-6);
            assert_linearized(area, curvature, 1e-6);
        }
    }
}
