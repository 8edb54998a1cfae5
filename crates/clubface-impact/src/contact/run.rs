//! Runs a contact from first touch to launch.

use super::dynamics::Contact;
use super::head_motion::motions;
use super::law::ContactLaw;
use super::recorder::Recorder;
use super::separation::Separation;
use super::state::*;
use crate::first_touch::FirstTouch;
use crate::giving_face::possible;
use crate::impact::{Accuracy, Impact};
use clubface_math::ode::{ChosenMethod, Control, integrate};
use clubface_math::{Mask, Scalar};

/// Steps after which a fast contact is given up; a drive takes about 50.
const FAST_STEPS: usize = 2_000;
/// Steps after which a contact at a stated tolerance is given up; 1e-12 takes about 10 000.
const TIGHT_STEPS: usize = 400_000;

/// Integrates a contact and turns its end into a launch. `N`: [`SOLID`] or [`LAYERED`]; `GIVING`: the same on a face that
/// gives; `RECORDED`: the same recorded, for a recorder that is active.
#[inline(always)]
pub fn run<
    S: Scalar,
    L: ContactLaw<S>,
    R: Recorder<S>,
    const N: usize,
    const GIVING: usize,
    const RECORDED: usize,
>(
    touch: &FirstTouch<S>,
    law: L,
    accuracy: Accuracy,
    recorder: &mut R,
) -> Impact<S> {
    if R::ACTIVE {
        run_in::<S, L, R, RECORDED>(touch, law, accuracy, recorder)
    } else if touch.gives() {
        run_in::<S, L, R, GIVING>(touch, law, accuracy, recorder)
    } else {
        run_in::<S, L, R, N>(touch, law, accuracy, recorder)
    }
}

/// The same in a state of `N` numbers.
#[inline(always)]
fn run_in<S: Scalar, L: ContactLaw<S>, R: Recorder<S>, const N: usize>(
    touch: &FirstTouch<S>,
    law: L,
    accuracy: Accuracy,
    recorder: &mut R,
) -> Impact<S> {
    let contact = Contact::new(touch, law);
    let start = initial::<S, N>(touch);
    if R::ACTIVE {
        recorder.record(&contact, S::zero(), &start);
    }
    // The ball crosses its radius in about the time a contact lasts.
    let crossing = touch.ball.radius / touch.approach();
    let mut control = Control {
        tolerance: L::FAST_TOLERANCE,
        scale: scales::<S, N>(touch),
        first: crossing * 0.02,
        longest: crossing * 0.1,
        max_steps: FAST_STEPS,
    };
    let mut watch = Separation::new(&contact, recorder, start);
    let method = match accuracy {
        Accuracy::Fast => {
            if layered(N) {
                // A cover holds less than half of the ball's inertia, and its spin counts in the launch by that part.
                for i in BALL_SPIN..BALL_SPIN + 3 {
                    control.scale[i] = control.scale[i] * 2.0;
                }
            }
            ChosenMethod::Rosenbrock
        }
        Accuracy::Tolerance(tolerance) => {
            control.tolerance = tolerance;
            control.first = crossing * 1e-3;
            control.max_steps = TIGHT_STEPS;
            ChosenMethod::DormandPrince
        }
    };
    let outcome = integrate(&method, &contact, start, &control, &mut watch);
    let Separation { peak_force, time, last, .. } = watch;
    let (ball, club) = motions(touch, contact.core().map(|core| core.inertia), &last);
    let mut launch = touch.launch(ball, club);
    launch.contact_time = time;
    launch.peak_force = peak_force;
    Impact { launch, separated: outcome.finished.and(possible(touch, peak_force)) }
}
