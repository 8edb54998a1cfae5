//! Pieces of the ball that bear longer steps than the rest, and so rest in every second one.

use super::Impact;
use clubface_math::Real;

/// Largest time between the impulses of what rests, over the stable step of the ball. Impulses make a vibration grow when they come as often as it passes
/// through zero: at `pi / 2` of it.
const RESONANCE: f64 = 1.4;

impl<R: Real> Impact<R> {
    /// Lets pieces of the ball rest in every second step, from the inside, if the steps (s) that the head needs are short enough for them; says
    /// whether there are any.
    pub(super) fn let_rest(&mut self, dt: f64, safety: f64) -> bool {
        let held = 2.0 * dt;
        let parts = &self.parts;
        let mut resting = vec![false; parts.len()];
        if self.ball_limit.is_some_and(|limit| held <= RESONANCE * limit) {
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
