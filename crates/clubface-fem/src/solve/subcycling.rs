//! The time step of a run, and the pieces of the ball that allow a longer one and are subcycled.

use super::stable_step::rounded;
use super::{Options, Simulation};
use crate::element::damped_step_ratio;
use clubface_math::Real;
use std::collections::HashSet;

/// Time step over the stable step of the undeformed ball, whose elements an impact squeezes: with subcycling, and
/// without.
const BALL_SAFETY: [f64; 2] = [0.75, 0.9];
/// Largest time step over the stable step of the undeformed structure as a whole: heads hardly deform.
const LARGEST_SAFETY: f64 = 0.95;
/// Largest time between the impulses of subcycled patches, over the stable step of the ball. Impulses make a vibration
/// grow when they come as often as it passes through zero: from 1.41 on, half a period of central differences, the
/// fastest vibrations of the cover do. These hardly reach the core through [`LAYERS`]: with 1.6 the energy balance of
/// balls from soft to stiff is as good as without subcycling, but the force ripples by up to a hundredth of its peak;
/// with 1.8 some runs fail.
const RESONANCE: f64 = 1.5;
/// Fewest layers of elements around subcycled ones. A single layer swings as a whole, core included: with 1.3 the
/// energy balance of one run was off by 0.4%.
const LAYERS: usize = 2;
/// Allowance for rounding.
const SLACK: f64 = 1.0 + 1e-9;

/// The time step of a run.
#[derive(Clone)]
pub(crate) struct StepSize {
    /// Time step over the stable one, apart from rounding and bulk viscosity.
    pub safety: f64,
    /// Time step, s.
    pub dt: f64,
    /// Steps after which everything has moved: 2 with subcycling, otherwise 1.
    pub period: usize,
    /// Which patches are subcycled.
    pub subcycled: Vec<bool>,
}

impl<R: Real> Simulation<R> {
    /// Chooses the time step, and the patches to subcycle. Neither depends on derivatives.
    pub(crate) fn choose_step(&mut self, options: &Options) -> StepSize {
        // A rigid head needs no steps of its own. A deformable one is coupled to the ball by the contact alone, which
        // is stable with the ball's step.
        let of_head: Vec<bool> =
            self.parts.iter().enumerate().map(|(patch, _)| !self.is_of_ball(patch)).collect();
        let stable = if of_head.contains(&true) {
            self.structure.stable_step_of(&of_head, 40).min(self.ball_stable_step)
        } else {
            self.ball_stable_step
        };
        let usual = BALL_SAFETY.map(|safety| (self.ball_stable_step / stable * safety).min(LARGEST_SAFETY));
        let factor = damped_step_ratio(options.bulk_viscosity);
        let mut with_safety = |safety: f64| {
            let dt = rounded(stable * safety * factor);
            let subcycled = self.choose_subcycled(dt, safety * factor);
            StepSize { safety, dt, period: if subcycled.contains(&true) { 2 } else { 1 }, subcycled }
        };
        if let Some(safety) = options.safety {
            return with_safety(safety);
        }
        let subcycled = with_safety(usual[0]);
        if subcycled.period > 1 { subcycled } else { with_safety(usual[1]) }
    }

    /// The patches of those pieces of the ball, from the inside, for which the step (s) is short enough to subcycle
    /// them. The outermost piece is never subcycled: the force on the face would come and go with its impulses.
    fn choose_subcycled(&mut self, dt: f64, safety: f64) -> Vec<bool> {
        let duration = 2.0 * dt;
        let parts = &self.parts;
        let mut subcycled = vec![false; parts.len()];
        if duration <= RESONANCE * SLACK * self.ball_stable_step {
            let ball: Vec<usize> = (0..parts.len()).filter(|&patch| self.is_of_ball(patch)).collect();
            let pieces: Vec<&[usize]> = ball.chunk_by(|&a, &b| parts[a] == parts[b]).collect();
            for end in 1..pieces.len() {
                let (inside, outside) = (pieces[..end].concat(), pieces[end..].concat());
                let mut candidates = vec![false; parts.len()];
                inside.iter().for_each(|&patch| candidates[patch] = true);
                if self.structure.stable_step_of(&candidates, 40) * safety < duration {
                    break;
                }
                if self.layers(&inside, &outside) >= LAYERS {
                    subcycled = candidates;
                }
            }
        }
        subcycled
    }

    fn is_of_ball(&self, patch: usize) -> bool {
        (self.structure.patches[patch].nodes()[0] as usize) < self.ball_nodes
    }

    /// Layers of elements in the patches `outside`, which have as many nodes on every surface as on the one that they
    /// share with those `inside`.
    fn layers(&self, inside: &[usize], outside: &[usize]) -> usize {
        let nodes = |list: &[usize]| -> HashSet<u32> {
            list.iter().flat_map(|&patch| self.structure.patches[patch].nodes()).copied().collect()
        };
        let (inside, outside) = (nodes(inside), nodes(outside));
        outside.len() / inside.intersection(&outside).count().max(1) - 1
    }
}
