//! Intervals of the contact search: nodes that are too far away to touch are left out for some steps.

/// Closing speed assumed for a node that is left out, over the largest seen so far.
const CAUTION: f64 = 4.0;
/// Most steps for which a node is left out.
const LONGEST: f64 = 100.0;

/// Steps until each node is searched again.
pub struct SearchIntervals {
    remaining: Vec<u32>,
    /// Square of the largest speed seen, m2/s2.
    largest_speed_squared: f64,
}

impl SearchIntervals {
    /// All of `count` nodes are due at once.
    pub fn new(count: usize) -> Self {
        Self { remaining: vec![0; count], largest_speed_squared: 0.0 }
    }
    /// Whether a node is to be searched in this step.
    #[inline(always)]
    pub fn due(&mut self, node: usize) -> bool {
        let remaining = &mut self.remaining[node];
        let due = *remaining == 0;
        *remaining = remaining.saturating_sub(1);
        due
    }
    /// Leaves a node out for as long as it cannot cross a gap (m) in steps of `dt` seconds, given the square of its
    /// speed relative to the other side.
    #[inline(always)]
    pub fn skip_gap(&mut self, node: usize, gap: f64, speed_squared: f64, dt: f64) {
        self.largest_speed_squared = self.largest_speed_squared.max(speed_squared);
        let nearer = CAUTION * self.largest_speed_squared.sqrt() * dt;
        // As long as nothing has moved, nobody knows how fast it will be.
        let steps = if nearer > 0.0 { gap / nearer } else { 0.0 };
        self.remaining[node] = steps.clamp(0.0, LONGEST) as u32;
    }
}
