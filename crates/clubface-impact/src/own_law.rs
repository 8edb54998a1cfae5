//! Laws of contact that someone writes outside this crate: forces from what a contact is at one instant, with states of
//! their own.

use crate::contact::{
    BALL_SPIN, Bodies, CLUB_SPIN, ContactPoint, Loads, POSITION, SOLID, hermite_root, initial, motions,
    parabola_peak, scales,
};
use crate::error::ImpactError;
use crate::face::{Face, tangents};
use crate::first_touch::FirstTouch;
use crate::launch::Launch;
use clubface_math::ode::{Control, DORMAND_PRINCE, Method, Observer, System, integrate};
use clubface_math::{Mask, Scalar, Vec3};

/// What a law receives: penetration (m), its rate (m/s), sliding velocity up the face and towards the toe (m/s), mean
/// curvature of the face (1/m), radius of the ball (m), time since first touch (s), distance slid up the face and towards
/// the toe (m), and the point of contact from the face centre, up the face and towards the toe (m).
pub const TOUCH: usize = 11;
/// Largest number of states that a law may have.
pub const MOST_STATES: usize = 24;
/// Forces that a law returns, N: the normal force on the ball, friction on it up the face and towards the toe. The rates of
/// its states follow.
pub const FORCES: usize = 3;

/// A law of contact.
pub trait OwnLaw<S: Scalar> {
    /// Forces and rates of the states into `out`; NaN where there are none, which ends the contact.
    fn evaluate(&self, touch: &[S; TOUCH], states: &[S], out: &mut [S]);
}

// States behind those of the bodies: time, distance slid, work taken by the normal force and by friction, and then those of
// the law.
const TIME: usize = SOLID;
const SLID: usize = SOLID + 1;
const WORK: usize = SOLID + 3;
const OWN: usize = SOLID + 5;
/// States of bodies and contact.
const N: usize = OWN + MOST_STATES;

/// Time after which a contact is given up, s; a drive lasts half a millisecond.
const LONGEST: f64 = 0.01;
/// Steps after which a contact is given up; a drive takes some 60.
const MOST_STEPS: usize = 8_000;
/// Part of the energy that a contact may gain or lose against the work of its forces.
const MOST_ENERGY_ERROR: f64 = 1e-2;

/// Why a contact by someone's own law has no launch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfinished {
    /// Nothing drove the ball away.
    NeverPushes,
    /// Ball and club did not part within 10 ms.
    StillTouching,
    /// The law is too stiff or changes too sharply to be followed.
    TooStiff,
}

/// Bodies that move under a law.
struct Moving<'a, S, L> {
    law: &'a L,
    states: usize,
    face: Face<S>,
    lever: Vec3<S>,
    radius: S,
    bodies: Bodies<S>,
    inverse_ball_inertia: S,
}

/// A contact at one instant.
struct Instant<S> {
    loads: Loads<S>,
    normal_force: S,
    depth: S,
    rate: S,
}

impl<S: Scalar, L: OwnLaw<S>> Moving<'_, S, L> {
    /// The contact in state `y`; the rates of the states behind those of the bodies go into `rates`.
    fn instant(&self, y: &[S; N], rates: &mut [S; N]) -> Instant<S> {
        let position = Vec3::from_slice(y, POSITION);
        let t = ContactPoint::new(&self.face.nearest(position - self.lever), self.radius, &y[..SOLID]);
        let (up, toe) = tangents(t.normal);
        let depth = S::select(t.depth.le(S::zero()), S::zero(), t.depth);
        let sliding = [t.sliding.dot(up), t.sliding.dot(toe)];
        let place = t.point - self.lever;
        let given = [
            depth,
            t.rate,
            sliding[0],
            sliding[1],
            t.curvature,
            self.radius,
            y[TIME],
            y[SLID],
            y[SLID + 1],
            place.y,
            place.z,
        ];
        let mut out = [S::zero(); FORCES + MOST_STATES];
        let end = OWN + self.states;
        self.law.evaluate(&given, &y[OWN..end], &mut out[..FORCES + self.states]);
        let normal_force = out[0].max(S::zero());
        let friction = up * out[1] + toe * out[2];
        rates[TIME] = S::one();
        rates[SLID..WORK].copy_from_slice(&sliding);
        rates[WORK] = normal_force * t.rate;
        rates[WORK + 1] = -friction.dot(t.sliding);
        rates[OWN..end].copy_from_slice(&out[FORCES..FORCES + self.states]);
        let force = t.normal * normal_force + friction;
        let loads = Loads { force, point: t.point, torque: t.normal.cross(friction) * -t.arm };
        Instant { loads, normal_force, depth: t.depth, rate: t.rate }
    }
}

impl<S: Scalar, L: OwnLaw<S>> System<S, N> for Moving<'_, S, L> {
    fn rhs(&self, y: &[S; N]) -> [S; N] {
        let mut rates = [S::zero(); N];
        let loads = self.instant(y, &mut rates).loads;
        self.bodies.put_rates(y, &loads, self.inverse_ball_inertia, &mut rates);
        rates
    }
}

/// Watches for the peak of the force and the end.
struct Parting<'a, S, L> {
    moving: &'a Moving<'a, S, L>,
    before: Instant<S>,
    peak_force: S,
    time: S,
    last: [S; N],
    overdue: bool,
}

impl<S: Scalar, L: OwnLaw<S>> Observer<S, N> for Parting<'_, S, L> {
    fn observe(
        &mut self,
        accepted: S::Mask,
        time: S,
        h: S,
        (y0, f0): (&[S; N], &[S; N]),
        (y1, f1): (&[S; N], &[S; N]),
    ) -> S::Mask {
        let mut unused = [S::zero(); N];
        let end = self.moving.instant(y1, &mut unused);
        let mut middle = *y0;
        for i in 0..N {
            middle[i] = (y0[i] + y1[i]) * 0.5 + (f0[i] - f1[i]) * (h * 0.125);
        }
        let halfway = self.moving.instant(&middle, &mut unused).normal_force;
        let peak = parabola_peak(self.before.normal_force, halfway, end.normal_force);
        self.peak_force = S::select(accepted, self.peak_force.max(peak), self.peak_force);
        let parted = accepted.and(end.depth.le(S::zero())).and(end.rate.lt(S::zero()));
        if parted.any() {
            // A step that ends where the cubic through depth and rate has them part, and one that mends what it misses.
            let x = hermite_root(self.before.depth, self.before.rate * h, end.depth, end.rate * h);
            let mut passed = h * x;
            for _ in 0..2 {
                self.last = DORMAND_PRINCE.attempt(self.moving, y0, f0, passed).y;
                let there = self.moving.instant(&self.last, &mut unused);
                passed -= there.depth / there.rate;
            }
            self.time = time + passed;
        }
        self.before = end;
        self.overdue = time.re() > LONGEST;
        if self.overdue { S::Mask::splat(true) } else { parted }
    }
}

/// From first touch to launch by someone's own law, with a relative tolerance a step. The law has as many states as `sizes`,
/// their natural sizes, which errors are measured against; they begin at zero.
///
/// # Errors
/// More than [`MOST_STATES`] states.
pub fn run<S: Scalar, L: OwnLaw<S>>(
    touch: &FirstTouch<S>,
    law: &L,
    sizes: &[f64],
    tolerance: f64,
) -> Result<Result<Launch<S>, Unfinished>, ImpactError> {
    let states = sizes.len();
    if states > MOST_STATES {
        return Err(ImpactError::new("states", format!("{states} given; allowed: at most {MOST_STATES}")));
    }
    let inverse_ball_inertia = touch.ball.inertia.recip();
    let (face, lever, radius) = (touch.face, touch.lever, touch.ball.radius);
    let bodies = Bodies::new(touch);
    let moving = Moving { law, states, face, lever, radius, bodies, inverse_ball_inertia };
    let mut start = [S::zero(); N];
    start[..SOLID].copy_from_slice(&initial::<S, SOLID>(touch));
    let crossing = touch.ball.radius / touch.approach();
    let mut scale = [S::one(); N];
    scale[..SOLID].copy_from_slice(&scales::<S, SOLID>(touch));
    scale[TIME] = crossing;
    scale[SLID..WORK].fill(touch.ball.radius * 0.1);
    scale[WORK..OWN].fill(touch.ball.mass * touch.approach().squared());
    for (own, &size) in scale[OWN..].iter_mut().zip(sizes) {
        *own = S::from_f64(size);
    }
    let control =
        Control { tolerance, scale, first: crossing * 1e-3, longest: crossing * 0.1, max_steps: MOST_STEPS };
    let before = moving.instant(&start, &mut [S::zero(); N]);
    let mut parting = Parting {
        moving: &moving,
        before,
        peak_force: S::zero(),
        time: S::zero(),
        last: start,
        overdue: false,
    };
    let outcome = integrate(&DORMAND_PRINCE, &moving, start, &control, &mut parting);
    let Parting { peak_force, time, last, overdue, .. } = parting;
    if overdue {
        let pushed = peak_force.re() > 0.0;
        return Ok(Err(if pushed { Unfinished::StillTouching } else { Unfinished::NeverPushes }));
    }
    if !outcome.finished.all() || !keeps_energy(touch, &start, &last) {
        return Ok(Err(Unfinished::TooStiff));
    }
    let (ball, club) = motions(touch, None, &last);
    let mut launch = touch.launch(ball, club);
    launch.contact_time = time;
    launch.peak_force = peak_force;
    Ok(Ok(launch))
}

/// Whether what both bodies lose is what the forces take; of an attached head it is not asked.
fn keeps_energy<S: Scalar>(touch: &FirstTouch<S>, start: &[S; N], end: &[S; N]) -> bool {
    if touch.head.added.is_some() {
        return true;
    }
    let energy = |y: &[S; N]| {
        let (ball, club) = motions(touch, None, y);
        let (spin, surface) = (Vec3::from_slice(y, CLUB_SPIN), Vec3::from_slice(y, BALL_SPIN));
        let turning = touch.ball.inertia * surface.norm_squared() + spin.dot(touch.head.inertia * spin);
        let moving =
            touch.ball.mass * ball.velocity.norm_squared() + touch.head.mass * club.velocity.norm_squared();
        (turning + moving).re() * 0.5
    };
    let (before, after) = (energy(start), energy(end));
    let work = (end[WORK] + end[WORK + 1]).re();
    (after + work - before).abs() <= MOST_ENERGY_ERROR * before
}
