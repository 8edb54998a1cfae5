//! Concentric rings (Caldwell and McPhee, section 2.2.2), after Maw, Barber and Fawcett (1976), with both tangential
//! directions.

use super::hertz;
use crate::contact::{
    CLUB_SPIN, Contact, ContactLaw, ContactPoint, Indentation, RECORDED_SLIDING, Recorder, RingFrame,
    SLIDING, Separation, Sliding, VELOCITY, face, initial, motions, scales,
};
#[cfg(feature = "multibody")]
use crate::contact::{SteppedContact, stepped};
use crate::description::{Law, ModelInfo, ModelKind};
use crate::face::tangents;
use crate::first_touch::FirstTouch;
use crate::giving_face::{GivingFace, possible};
use crate::impact::{Accuracy, Impact};
use crate::model::{Describe, Model};
use crate::parameters;
use crate::rings::{Load, RingContact, RingMaterial, RingSteps};
use clubface_math::ode::{BOGACKI_SHAMPINE, Control, DORMAND_PRINCE, Method, Observer, System, integrate};
use clubface_math::{Dual, Mask, Scalar, Vec3};
use core::cell::RefCell;
use core::f64::consts::PI;

/// Number of rings, as in the original work.
pub const RINGS: usize = 20;
/// Steps while the contact grows by one ring; with this and the next, spin is within 0.5% of that of fine steps.
const STEPS_PER_RING: usize = 1;
/// Longest step in units of greatest penetration over approach speed; an elastic contact lasts 2.943 of them.
const LONGEST_STEP: f64 = 0.15;
/// Steps after which a contact is given up, at the fast setting and at a stated tolerance.
const MOST_STEPS: [usize; 2] = [2_000, 400_000];
/// Room that the rings leave beyond the greatest penetration of the first pass.
const MARGIN: f64 = 1.001;

/// Room for the swing of a face that gives, in units of the greatest penetration.
const SWING: f64 = 1.05;

parameters! {
    /// Parameters of the rings model.
    Rings {
        shear_modulus ["Pa"] = 5.58e7 in 1e6 ..= 1e10, "effective shear modulus G of the normal stiffness",
            "Caldwell and McPhee (2023), Table 9, driver, corrected by 1/100 (as printed a drive lasts 82 us)";
        poisson ["1"] = 0.407 in 0.0 ..= 0.499, "effective Poisson's ratio",
            "Caldwell and McPhee (2023), Table 9, driver";
        damping ["s/m"] = 6.50e-3 in 0.0 ..= 0.03, "Hunt-Crossley damping d",
            "Caldwell and McPhee (2023), Table 9, driver";
        friction ["1"] = 0.360 in 0.0 ..= 2.0, "coefficient of friction mu",
            "Caldwell and McPhee (2023), Table 9, driver";
        ring_modulus ["Pa"] = 5.58e7 in 1e6 ..= 1e10, "shear modulus G_ring of the tangential compliance of the rings",
            "not printed: that of the normal stiffness; half of it would be consistent, but gives far too much spin";
    }
}

impl Describe for Rings<()> {
    type Over<S: Scalar> = Rings<S>;
    const INFO: ModelInfo = ModelInfo {
        name: "rings",
        title: "Concentric rings",
        kind: ModelKind::Contact,
        summary: "Hertz contact cut into rings that stick or slip on their own and displace the surface elastically.",
        reference: "Caldwell and McPhee (2023), section 2.2.2, Eqs. 14-16, after Maw, Barber and Fawcett; parameters of Table 9",
        laws: &[Law::Momentum, Law::AngularMomentum, Law::Energy, Law::FrictionCone],
        laws_without: None,
        face_in: Some("damping"),
        lacks: &[],
        gear_effect: true,
        ball: None,
        valid: &[],
        lanes: false,
        parameters: Rings::PARAMETERS,
    };
}

/// The law of one contact: parameters and the rings with their history.
struct RingLaw<S> {
    parameters: Rings<S>,
    rings: RefCell<RingContact<S>>,
}

impl<S: Scalar> RingLaw<S> {
    /// The rings of the instant last evaluated.
    fn frame(&self) -> Vec<RingFrame> {
        let rings = self.rings.borrow();
        let ring = |j: usize| RingFrame {
            radius: rings.radius(j).re(),
            traction: rings.traction(j).map(Scalar::re),
            slipping: j < rings.contact() && !rings.sticks(j),
            inside: j < rings.contact(),
        };
        (0..rings.rings()).map(ring).collect()
    }
}

impl<S: Scalar> ContactLaw<S> for RingLaw<S> {
    const FAST_TOLERANCE: f64 = 1.5e-5;

    #[inline(always)]
    fn normal_force<const K: usize>(&self, at: Indentation<S, K>) -> Dual<S, K> {
        let Rings { shear_modulus, poisson, damping, .. } = self.parameters;
        let equivalent = hertz::equivalent_radius(Dual::constant(at.radius), at.curvature);
        hertz::force(hertz::stiffness(shear_modulus, poisson, equivalent), damping, at.depth, at.rate)
    }
    #[inline(always)]
    fn drag<const K: usize>(&self, _: Sliding<S, K>) -> Dual<S, K> {
        // All friction is remembered.
        Dual::zero()
    }
    #[inline(always)]
    fn remembered(&self, t: &ContactPoint<S>, normal_force: S, slip: [S; 2]) -> Option<Vec3<S>> {
        let equivalent = hertz::equivalent_radius(t.depth + t.arm, t.curvature);
        let load = Load { force: normal_force, radius: (equivalent * t.depth).safe_sqrt() };
        let [along_up, along_toe] = self.rings.borrow_mut().force(slip, load);
        let (up, toe) = tangents(t.normal);
        Some(up * along_up + toe * along_toe)
    }
    #[inline(always)]
    fn commit(&self) {
        self.rings.borrow_mut().commit();
    }
    fn memory(&self) -> Vec<S> {
        self.rings.borrow().history()
    }
    fn remember(&self, memory: &[S]) {
        self.rings.borrow_mut().set_history(memory);
    }
    #[inline(always)]
    fn area(&self, depth: S, curvature: S, radius: S) -> S {
        hertz::equivalent_radius(radius, curvature) * depth * PI
    }
}

/// Greatest penetration (m) of the normal motion alone: Hertz's force with Hunt-Crossley damping `damping` d on a mass
/// of inverse `inverse_mass` (1/kg) that arrives at `speed` v. Integrating v dv/(1 + d v) = -(k/m) x^1.5 dx,
/// (2/5)(k/m) x^2.5 = (d v - ln(1 + d v))/d^2.
#[inline(always)]
fn deepest<S: Scalar>(stiffness: S, damping: S, inverse_mass: S, speed: S) -> S {
    let z = damping * speed;
    // (z - ln(1 + z))/z^2 by its series where the difference would cancel.
    let ratio = if z.re() > 0.05 {
        (z - (z + 1.0).ln()) / z.squared()
    } else {
        (0..12).rev().fold(S::zero(), |sum, k| -(sum * z) + 1.0 / f64::from(k + 2))
    };
    (ratio * speed.squared() * 2.5 / (stiffness * inverse_mass)).powf(0.4)
}

/// Greatest penetration (m) on a face that gives, where it would be `rigid` without: the ball has the energy
/// (2/5) k x^2.5, the face C (k x^1.5)^2 / 2, which is 5/4 C k x^0.5 of it.
#[inline(always)]
fn deepest_on<S: Scalar>(giving: &GivingFace<S>, stiffness: S, rigid: S) -> S {
    let shared = giving.compliance * stiffness * 1.25;
    (0..4).fold(rigid, |x, _| rigid * (shared * x.sqrt() + 1.0).powf(-0.4))
}

impl<S: Scalar> Model<S> for Rings<S> {
    #[inline(always)]
    fn impact<R: Recorder<S>>(&self, touch: &FirstTouch<S>, accuracy: Accuracy, record: &mut R) -> Impact<S> {
        if R::ACTIVE {
            self.integrate::<R, RECORDED_SLIDING>(touch, accuracy, record)
        } else {
            self.integrate::<R, SLIDING>(touch, accuracy, record)
        }
    }

    #[cfg(feature = "multibody")]
    fn stepped(&self, touch: &FirstTouch<S>) -> Option<Box<dyn SteppedContact<S>>> {
        Some(stepped::<S, _, SLIDING>(touch, self.lay_out(touch).law))
    }
}

/// Rings as an impact needs them.
struct Layout<S> {
    law: RingLaw<S>,
    /// Greatest penetration expected, m.
    deepest: S,
    /// Penetration at which the contact reaches the last ring, m.
    largest_depth: S,
    /// Longest step, s.
    longest: S,
}

impl<S: Scalar> Rings<S> {
    /// Rings that reach as far as the contact will.
    #[inline(always)]
    fn lay_out(&self, touch: &FirstTouch<S>) -> Layout<S> {
        let speed = touch.approach();
        let curvature = touch.face.nearest(touch.contact - touch.lever).curvature;
        let equivalent = hertz::equivalent_radius(touch.ball.radius, curvature);
        let stiffness = Dual::<S, 0>::constant(equivalent);
        let stiffness = hertz::stiffness(self.shear_modulus, self.poisson, stiffness).value;
        let mut deepest = deepest(stiffness, self.damping, touch.normal_mobility(), speed);
        let mut longest = deepest / speed * LONGEST_STEP;
        if touch.gives() {
            let giving = GivingFace::from_touch(touch);
            deepest = deepest_on(&giving, stiffness, deepest);
            // With derivatives by a face that does not give, steps and rings are those without.
            if !giving.compliance.primal().vanishes() {
                deepest = deepest * SWING;
                longest = longest.min(giving.square_time.sqrt());
            }
        }
        let largest_radius = (equivalent * deepest).sqrt() * MARGIN;
        let material =
            RingMaterial { friction: self.friction, poisson: self.poisson, modulus: self.ring_modulus };
        let rings = RefCell::new(RingContact::new(RINGS, material, largest_radius));
        Layout {
            law: RingLaw { parameters: *self, rings },
            deepest,
            largest_depth: largest_radius.squared() / equivalent,
            longest,
        }
    }

    /// From first touch to launch, in `N` states.
    #[inline(always)]
    fn integrate<R: Recorder<S>, const N: usize>(
        &self,
        touch: &FirstTouch<S>,
        accuracy: Accuracy,
        recorder: &mut R,
    ) -> Impact<S> {
        let Layout { law, deepest, largest_depth, longest } = self.lay_out(touch);
        let contact = Contact::new(touch, law);
        let start = initial::<S, N>(touch);
        if R::ACTIVE {
            recorder.record(&contact, S::zero(), &start);
            recorder.record_rings(&contact.law.frame());
        }
        let watch = Separation::new(&contact, recorder, start);
        let mut history = CommitSteps { law: &contact.law, watch };
        let separated = match accuracy {
            Accuracy::Fast => {
                let steps =
                    RingSteps { rings: RINGS, steps_per_ring: STEPS_PER_RING, largest_depth, longest };
                S::Mask::splat(ring_by_ring(&contact, start, &steps, &mut history))
            }
            Accuracy::Tolerance(tolerance) => {
                let control = Control {
                    tolerance,
                    scale: scales::<S, N>(touch),
                    first: deepest / touch.approach() * 1e-3,
                    longest,
                    max_steps: MOST_STEPS[1],
                };
                integrate(&DORMAND_PRINCE, &contact, start, &control, &mut history).finished
            }
        };
        let Separation { peak_force, time, last, .. } = history.watch;
        let (ball, club) = motions(touch, None, &last);
        let mut launch = touch.launch(ball, club);
        launch.contact_time = time;
        launch.peak_force = peak_force;
        Impact { launch, separated: separated.and(possible(touch, peak_force)) }
    }
}

/// Integrates in steps that fit the rings; whether the bodies separated.
#[inline(always)]
fn ring_by_ring<S: Scalar, R: Recorder<S>, const N: usize>(
    contact: &Contact<S, RingLaw<S>>,
    mut y: [S; N],
    steps: &RingSteps<S>,
    history: &mut CommitSteps<'_, S, R, N>,
) -> bool {
    let mut rate = contact.rhs(&y);
    let mut time = S::zero();
    for _ in 0..MOST_STEPS[0] {
        let t = contact.touching(&y);
        // Without the change of the normal's direction, which is too slow to matter to a step's length.
        let surface = Vec3::from_slice(&rate, VELOCITY) - Vec3::from_slice(&rate, CLUB_SPIN).cross(t.point);
        let acceleration = -t.normal.dot(surface) - face(N).map_or(S::zero(), |at| rate[at + 1]);
        let h = steps.next(t.depth, t.rate, acceleration);
        let end = BOGACKI_SHAMPINE.attempt(contact, &y, &rate, h);
        let accepted = S::Mask::splat(true);
        if history.observe(accepted, time, h, (&y, &rate), (&end.y, &end.rate)).all() {
            return true;
        }
        time += h;
        (y, rate) = (end.y, end.rate);
    }
    false
}

/// Commits the rings at every accepted step.
struct CommitSteps<'a, S, R, const N: usize> {
    law: &'a RingLaw<S>,
    watch: Separation<'a, S, RingLaw<S>, R, N>,
}

impl<S: Scalar, R: Recorder<S>, const N: usize> Observer<S, N> for CommitSteps<'_, S, R, N> {
    #[inline(always)]
    fn observe(
        &mut self,
        accepted: S::Mask,
        time: S,
        h: S,
        start: (&[S; N], &[S; N]),
        end: (&[S; N], &[S; N]),
    ) -> S::Mask {
        self.law.commit();
        let separated = self.watch.observe(accepted, time, h, start, end);
        if R::ACTIVE {
            self.watch.recorder.record_rings(&self.law.frame());
        }
        separated
    }
}
