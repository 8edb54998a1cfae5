//! Every lane steps on its own: what it computes does not depend on the other lanes.

use super::problems::Until;
use clubface_math::ode::{
    BOGACKI_SHAMPINE, Control, DORMAND_PRINCE, RK4, Rosenbrock, StiffSystem, System, integrate,
};
use clubface_math::{Kernel, Lanes, Mask, Scalar, dispatch};
use proptest::prelude::*;

/// State (t, x, v): a pendulum of natural frequency `pace` in a medium of strong friction `drag`, both 1/s.
struct Pendulum<S> {
    pace: S,
    drag: S,
}

impl<S: Scalar> System<S, 3> for Pendulum<S> {
    fn rhs(&self, [_, x, v]: &[S; 3]) -> [S; 3] {
        [S::one(), self.pace * *v, -(self.pace * x.sin_cos().0) - self.drag * *v]
    }
}

impl<S: Scalar> StiffSystem<S, 3> for Pendulum<S> {
    type Jacobian = ();
    type Solver = S;
    fn linearize(&self, _: &[S; 3]) {}
    fn factor(&self, (): &(), g: S) -> S {
        (g * self.drag + 1.0).recip()
    }
    fn solve(&self, inverse: &S, b: &[S; 3]) -> [S; 3] {
        [b[0], b[1], b[2] * *inverse]
    }
}

#[derive(Clone, Copy, Debug)]
enum Stepper {
    DormandPrince,
    BogackiShampine,
    ClassicalRungeKutta,
    Rosenbrock,
}

const STEPPERS: [Stepper; 4] =
    [Stepper::DormandPrince, Stepper::BogackiShampine, Stepper::ClassicalRungeKutta, Stepper::Rosenbrock];

/// Pace, drag, start and length of one motion.
#[derive(Clone, Copy, Debug)]
struct Motion {
    pace: f64,
    drag: f64,
    start: f64,
    end: f64,
}

/// How one motion ended.
#[derive(Clone, Copy, Debug, PartialEq)]
struct End {
    finished: bool,
    steps: usize,
    bits: [u64; 4],
}

#[derive(Clone, Copy)]
struct Motions<'a> {
    stepper: Stepper,
    motions: &'a [Motion],
}

const MOST_STEPS: usize = 2500;

impl Kernel for Motions<'_> {
    type Output = Vec<End>;
    fn run<S: Lanes>(self) -> Vec<End> {
        let mut ends = Vec::new();
        for pack in self.motions.chunks(S::LANES) {
            let gather =
                |value: fn(&Motion) -> f64| S::from_fn(|lane| value(&pack[lane.min(pack.len() - 1)]));
            let problem = Pendulum { pace: gather(|m| m.pace), drag: gather(|m| m.drag) };
            let start = [S::zero(), gather(|m| m.start), S::zero()];
            let control = Control {
                tolerance: 1e-6,
                scale: [S::one(); 3],
                first: gather(|m| 0.02 / m.pace),
                longest: S::from_f64(1.0),
                max_steps: MOST_STEPS,
            };
            let mut watch = Until::new(gather(|m| m.end), start);
            let outcome = match self.stepper {
                Stepper::DormandPrince => integrate(&DORMAND_PRINCE, &problem, start, &control, &mut watch),
                Stepper::BogackiShampine => {
                    integrate(&BOGACKI_SHAMPINE, &problem, start, &control, &mut watch)
                }
                Stepper::ClassicalRungeKutta => integrate(&RK4, &problem, start, &control, &mut watch),
                Stepper::Rosenbrock => integrate(&Rosenbrock, &problem, start, &control, &mut watch),
            };
            assert!(outcome.steps <= MOST_STEPS);
            for lane in 0..pack.len() {
                let [t, x, v] = watch.last.map(|component| component.lane(lane).to_bits());
                ends.push(End {
                    finished: outcome.finished.lane(lane),
                    steps: watch.count(lane),
                    bits: [watch.time.lane(lane).to_bits(), t, x, v],
                });
            }
        }
        ends
    }
}

fn motion() -> impl Strategy<Value = Motion> {
    (0.5..20.0f64, 0.0..200.0f64, -3.0..3.0f64, 0.5..2.0f64).prop_map(|(pace, drag, start, end)| Motion {
        pace,
        drag,
        start,
        end,
    })
}

fn alone(stepper: Stepper, motion: Motion) -> End {
    Motions { stepper, motions: &[motion] }.run::<f64>()[0]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn a_lane_ends_with_the_bits_it_would_have_alone(motions in prop::collection::vec(motion(), 1..9)) {
        for stepper in STEPPERS {
            for (&motion, end) in motions.iter().zip(dispatch(Motions { stepper, motions: &motions })) {
                prop_assert_eq!(end, alone(stepper, motion), "{:?} {:?}", stepper, motion);
            }
        }
    }

    /// The NaN lane is given up after the steps allowed; the others do not notice.
    #[test]
    fn a_lane_that_is_not_a_number_leaves_its_neighbours_alone(
        mut motions in prop::collection::vec(motion(), 8),
        bad in 0..8usize,
        index in 0..4usize,
    ) {
        match index {
            0 => motions[bad].pace = f64::NAN,
            1 => motions[bad].drag = f64::NAN,
            2 => motions[bad].start = f64::NAN,
            _ => motions[bad].start = f64::INFINITY,
        }
        for stepper in STEPPERS {
            let ends = dispatch(Motions { stepper, motions: &motions });
            for (lane, (&motion, end)) in motions.iter().zip(ends).enumerate() {
                if lane != bad {
                    prop_assert!(end.finished);
                    prop_assert_eq!(end, alone(stepper, motion), "{:?}", stepper);
                }
            }
        }
    }
}

/// A number that is not finite is never accepted by a method that controls its error, so the lane never finishes.
#[test]
fn a_motion_that_is_not_a_number_is_given_up_and_not_returned() {
    let motion = Motion { pace: 1.0, drag: f64::NAN, start: 1.0, end: 1.0 };
    for stepper in [Stepper::DormandPrince, Stepper::BogackiShampine, Stepper::Rosenbrock] {
        let end = alone(stepper, motion);
        assert!(!end.finished && end.steps == 0, "{stepper:?}: {end:?}");
    }
}
