//! Pieces of the ball that bear longer steps than the rest, and so rest in every second one.

use super::Impact;
use clubface_math::Real;

/// Largest time between the impulses of what rests, over the stable step of the ball. Impulses make a vibration grow when they come as often as it passes
/// through zero. The fastest ones, for which that is 1.41 (half a period of central differences), are in the thickness of the cover and hardly feel the
/// core: with 1.6 the energies of balls from soft to stiff close as well as without rest, at 35 and 55 m/s; with 1.7 some are off by more, with 1.8 some
/// runs fail.
const RESONANCE: f64 = 1.6;
/// For rounding.
const SLACK: f64 = 1.0 + 1e-9;

impl<R: Real> Impact<R> {
    /// Lets pieces of the ball rest in every second step, from the inside, if the steps (s) that the head needs are short enough for them; says
    /// whether there are any.
    pub(super) fn let_rest(&mut self, dt: f64, safety: f64) -> bool {
        let held = 2.0 * dt;
        let parts = &self.parts;
        let mut resting = vec![false; parts.len()];
        if held <= RESONANCE * SLACK * self.ball_limit {
            let first = |patch: usize| self.structure.patches[patch].nodes()[0] as usize;
            let ball: Vec<usize> = (0..parts.len()).filter(|&patch| first(patch) < self.ball_nodes).collect();
            for piece in ball.chunk_by(|&a, &b| parts[a] == parts[b]) {
                let mut more = resting.clone();
                piece.iter().for_each(|&patch| more[patch] = true);
                if self.structure.stable_step_of(&more, 40) * safety >= held {
                    resting = more;
                }
            }
        }
        let any = resting.contains(&true);
        self.structure.rest(resting);
        any
    }
}
