//! The time step, and pieces of the ball that bear a longer one and so rest in every second step.

use super::stable_step::rounded;
use super::{Impact, Options};
use crate::element::stable_share;
use clubface_math::Real;
use std::collections::HashSet;

/// Time step over the stable one of the undeformed ball, whose elements an impact squeezes: where some rest, and where none can.
const BALL: [f64; 2] = [0.75, 0.9];
/// The same of everything: heads hardly deform.
const ALL: f64 = 0.95;
/// Largest time between the impulses of what rests, over the stable step of the ball. Impulses make a vibration grow when they come as often as it passes
/// through zero: from 1.41 on the fastest ones of the cover do, half a period of central differences. Those hardly reach the core through [`LAYERS`]:
/// with 1.6 the energies of balls from soft to stiff still close as well as without rest, but the force ripples, up to a hundredth of its peak; with
/// 1.8 some runs fail.
const RESONANCE: f64 = 1.5;
/// Fewest layers of elements around what rests, if anything is. One layer swings as a whole, core and all: with 1.3 energies are off by 0.4% in a run.
const LAYERS: usize = 2;
/// For rounding.
const SLACK: f64 = 1.0 + 1e-9;

/// How a run steps.
pub(super) struct Pace {
    /// Time step over the stable one, but for rounding and bulk viscosity.
    pub safety: f64,
    /// Time step, s.
    pub dt: f64,
    /// Steps after which everything has moved.
    pub stride: usize,
}

impl<R: Real> Impact<R> {
    /// Chooses the step, and what rests.
    pub(super) fn pace(&mut self, options: &Options) -> Pace {
        // A rigid head needs no steps of its own; one that deforms hangs on the ball by the contact alone, which bears the ball's.
        let of_head: Vec<bool> =
            self.parts.iter().enumerate().map(|(patch, _)| !self.of_ball(patch)).collect();
        let limit = if of_head.contains(&true) {
            self.structure.stable_step_of(&of_head, 40).min(self.ball_limit)
        } else {
            self.ball_limit
        };
        let usual = BALL.map(|share| (self.ball_limit / limit * share).min(ALL));
        let share = stable_share(options.bulk_viscosity);
        let mut pace = |safety: f64| {
            let dt = rounded(limit * safety * share);
            let stride = if self.let_rest(dt, safety * share) { 2 } else { 1 };
            Pace { safety, dt, stride }
        };
        if let Some(safety) = options.safety {
            return pace(safety);
        }
        let resting = pace(usual[0]);
        if resting.stride > 1 {
            resting
        } else {
            pace(usual[1])
        }
    }

    /// Lets pieces of the ball rest in every second step, from the inside, if the steps (s) are short enough for them; says whether there are any. The
    /// outermost never rests: the force on the face would come and go with its impulses.
    fn let_rest(&mut self, dt: f64, safety: f64) -> bool {
        let held = 2.0 * dt;
        let parts = &self.parts;
        let mut resting = vec![false; parts.len()];
        if held <= RESONANCE * SLACK * self.ball_limit {
            let ball: Vec<usize> = (0..parts.len()).filter(|&patch| self.of_ball(patch)).collect();
            let pieces: Vec<&[usize]> = ball.chunk_by(|&a, &b| parts[a] == parts[b]).collect();
            for end in 1..pieces.len() {
                let (inside, outside) = (pieces[..end].concat(), pieces[end..].concat());
                let mut more = vec![false; parts.len()];
                inside.iter().for_each(|&patch| more[patch] = true);
                if self.structure.stable_step_of(&more, 40) * safety < held {
                    break;
                }
                if self.layers(&inside, &outside) >= LAYERS {
                    resting = more;
                }
            }
        }
        let any = resting.contains(&true);
        self.structure.rest(resting);
        any
    }

    fn of_ball(&self, patch: usize) -> bool {
        (self.structure.patches[patch].nodes()[0] as usize) < self.ball_nodes
    }

    /// Layers of elements of the outer ones of two lists of patches: they have as many nodes on every surface as where the lists meet.
    fn layers(&self, inside: &[usize], outside: &[usize]) -> usize {
        let nodes = |list: &[usize]| -> HashSet<u32> {
            list.iter().flat_map(|&patch| self.structure.patches[patch].nodes()).copied().collect()
        };
        let (inside, outside) = (nodes(inside), nodes(outside));
        outside.len() / inside.intersection(&outside).count().max(1) - 1
    }
}
