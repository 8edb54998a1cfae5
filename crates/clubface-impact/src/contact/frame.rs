//! One instant of a contact in the terms a reader wants.

use super::dynamics::Contact;
use super::head_motion::motions;
use super::law::ContactLaw;
use super::state::*;
use crate::face::tangents;
use crate::first_touch::FirstTouch;
use clubface_math::Vec3;

/// One instant of a contact. Forces act on the ball; y' is up the face and z' towards the toe at the contact point;
/// vectors of the bodies are in world axes (a left-hander's mirrored), positions relative to the clubhead CG at first
/// touch.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Time since first touch, s.
    pub time: f64,
    /// Normal force, N.
    pub normal_force: f64,
    /// Tangential force on the ball along y', N.
    pub force_y: f64,
    /// Tangential force on the ball along z', N.
    pub force_z: f64,
    /// Penetration, m.
    pub penetration: f64,
    /// Sliding velocity of the ball's surface on the face along y', m/s.
    pub sliding_y: f64,
    /// Sliding velocity along z', m/s.
    pub sliding_z: f64,
    /// Contact area, m2.
    pub contact_area: f64,
    /// Ball centre, m.
    pub ball_position: [f64; 3],
    /// Ball velocity, m/s.
    pub ball_velocity: [f64; 3],
    /// Ball angular velocity (all its angular momentum over its inertia), rad/s.
    pub ball_spin: [f64; 3],
    /// Angular velocity of the cover of a layered ball, else of the ball, rad/s.
    pub cover_spin: [f64; 3],
    /// Angular velocity of the core of a layered ball, else of the ball, rad/s.
    pub core_spin: [f64; 3],
    /// Clubhead CG, m.
    pub club_position: [f64; 3],
    /// Clubhead velocity, m/s.
    pub club_velocity: [f64; 3],
    /// Clubhead angular velocity, rad/s.
    pub club_spin: [f64; 3],
    /// Clubhead attitude relative to first touch in face axes of first touch: quaternion w, x, y, z.
    pub club_attitude: [f64; 4],
    /// Kinetic energy of both bodies, and of what an attached head carries along, J.
    pub kinetic_energy: f64,
    /// How far the face has moved inwards in the head, m, beyond the face that the parameters include.
    pub face_depth: f64,
    /// Energy that the face holds by that, J.
    pub face_energy: f64,
    /// Energy stored between cover and core, J.
    pub layer_energy: f64,
    /// Work taken so far by the normal force (stored and dissipated), J.
    pub normal_work: f64,
    /// Work taken so far by friction, J.
    pub friction_work: f64,
    /// Work taken so far by the damper between cover and core, J.
    pub layer_work: f64,
}

impl Frame {
    /// Reads the state `y` of a contact; `before` is the frame before, None at first touch.
    pub fn record<L: ContactLaw<f64>, const N: usize>(
        touch: &FirstTouch<f64>,
        contact: &Contact<f64, L>,
        time: f64,
        y: &[f64; N],
        before: Option<&Self>,
    ) -> Self {
        let t = contact.touching(y);
        let normal_force = contact.normal_force(&t);
        let friction = contact.tangential_force(y, &t, normal_force);
        let (up, toe) = tangents(t.normal);
        let core = contact.core();
        let (ball, club) = motions(touch, core.map(|core| core.inertia), y);
        let turn = Vec3::from_slice(y, ATTITUDE + 1);
        let attitude = clubface_math::Quat { w: y[ATTITUDE], v: turn };
        let relative = attitude.matrix() * Vec3::from_slice(y, POSITION);
        let club_velocity = touch.world_velocity(club.velocity);
        let club_position = match (&touch.head.added, before) {
            // From the uniform motion of the common centre of mass of club and ball.
            (None, _) | (_, None) => {
                let share = touch.ball.mass / (touch.ball.mass + touch.head.mass);
                let start = touch.contact + touch.normal * touch.ball.radius;
                let common = start * share + touch.club_velocity * ((1.0 - share) * time);
                touch.world_velocity(common - relative * share)
            }
            // Steps are short enough for the mean of the velocities at their ends.
            (Some(_), Some(before)) => {
                let mean = (Vec3::from_f64(before.club_velocity) + club_velocity) * 0.5;
                Vec3::from_f64(before.club_position) + mean * (time - before.time)
            }
        };
        let club_spin = Vec3::from_slice(y, CLUB_SPIN);
        let surface_spin = Vec3::from_slice(y, BALL_SPIN);
        let mut spin_energy = 0.5 * touch.ball.inertia * surface_spin.norm_squared();
        let mut layer_energy = 0.0;
        let mut core_spin = surface_spin;
        if let (true, Some(core)) = (layered(N), core) {
            let cover = touch.ball.inertia - core.inertia;
            core_spin = Vec3::from_slice(y, CORE_SPIN);
            spin_energy =
                0.5 * cover * surface_spin.norm_squared() + 0.5 * core.inertia * core_spin.norm_squared();
            layer_energy = 0.5 * core.stiffness * Vec3::from_slice(y, TWIST).norm_squared();
        }
        let mut work = [0.0; LEDGER];
        if recorded(N) {
            work.copy_from_slice(&y[N - LEDGER..]);
        }
        let [face_depth, face_rate] = face(N).map_or([0.0; 2], |at| [y[at], y[at + 1]]);
        let mut added_energy = 0.0;
        if let Some(added) = &touch.head.added {
            // Of a mechanism that moves as the head did at first touch, which has no part in its motion then.
            let change = contact.bodies.head_motion.velocity(&touch.head, y);
            let (linear, angular) = added.multiply(change, club_spin);
            added_energy = touch.club_velocity.dot(attitude.matrix() * linear)
                + 0.5 * (change.dot(linear) + club_spin.dot(angular));
        }
        let kinetic_energy = spin_energy
            + added_energy
            + 0.5 * touch.ball.mass * ball.velocity.norm_squared()
            + 0.5 * touch.head.mass * club.velocity.norm_squared()
            + 0.5 * club_spin.dot(touch.head.inertia * club_spin);
        Self {
            time,
            normal_force,
            force_y: friction.dot(up),
            force_z: friction.dot(toe),
            penetration: t.depth,
            sliding_y: t.sliding.dot(up),
            sliding_z: t.sliding.dot(toe),
            contact_area: contact.area(&t),
            ball_position: (club_position + touch.world_velocity(relative)).array(),
            ball_velocity: touch.world_velocity(ball.velocity).array(),
            ball_spin: touch.world_spin(ball.spin).array(),
            cover_spin: touch.world_spin(attitude.matrix() * surface_spin).array(),
            core_spin: touch.world_spin(attitude.matrix() * core_spin).array(),
            club_position: club_position.array(),
            club_velocity: club_velocity.array(),
            club_spin: touch.world_spin(club.spin).array(),
            club_attitude: [attitude.w, turn.x, turn.y, turn.z],
            kinetic_energy,
            face_depth,
            face_energy: contact.giving.energy(face_depth, face_rate),
            layer_energy,
            normal_work: work[0],
            friction_work: work[1],
            layer_work: work[2],
        }
    }
}
