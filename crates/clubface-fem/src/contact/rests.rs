//! Nodes that need not be looked at for some steps, since they are too far away to touch.

/// Closing speed assumed when a node is left alone for some steps, over the largest seen so far.
const CAUTION: f64 = 4.0;
/// Most steps a node is left alone.
const MOST: f64 = 100.0;

/// Steps for which each node is left alone.
pub struct Rests {
    left: Vec<u32>,
    /// Square of the largest speed seen, m2/s2.
    fastest: f64,
}

impl Rests {
    /// None of `count` nodes rests.
    pub fn new(count: usize) -> Self {
        Self { left: vec![0; count], fastest: 0.0 }
    }
    /// Whether a node is to be looked at in this step.
    #[inline(always)]
    pub fn due(&mut self, node: usize) -> bool {
        let left = &mut self.left[node];
        let due = *left == 0;
        *left = left.saturating_sub(1);
        due
    }
    /// Leaves a node alone for some steps.
    pub fn pause(&mut self, node: usize, steps: u32) {
        self.left[node] = steps;
    }
    /// Leaves a node alone as long as it cannot have come over a gap (m) in steps of `dt` seconds; `square` is that of its speed past the other side.
    #[inline(always)]
    pub fn apart(&mut self, node: usize, gap: f64, square: f64, dt: f64) {
        self.fastest = self.fastest.max(square);
        let nearer = CAUTION * self.fastest.sqrt() * dt;
        // From rest, nobody knows how fast it will be.
        let steps = if nearer > 0.0 { gap / nearer } else { 0.0 };
        self.left[node] = steps.clamp(0.0, MOST) as u32;
    }
}

#[cfg(test)]
mod tests {
    use super::Rests;

    #[test]
    fn a_node_is_seen_before_it_can_have_come() {
        let mut rests = Rests::new(2);
        rests.apart(0, 1e-3, 50.0 * 50.0, 1e-6);
        // 20 steps at 50 m/s: seen within a quarter of them, though this one is slow.
        rests.apart(1, 1e-3, 1.0, 1e-6);
        let seen = |rests: &mut Rests, node| (0..).find(|_| rests.due(node)).expect("seen");
        assert_eq!([seen(&mut rests, 0), seen(&mut rests, 1)], [5, 5]);
        rests.apart(0, f64::INFINITY, 0.0, 1e-6);
        assert_eq!(seen(&mut rests, 0), 100);
        assert!(rests.due(0), "in every step from then on");
        let mut rests = Rests::new(1);
        rests.apart(0, 1e-3, 0.0, 1e-6);
        assert!(rests.due(0), "whatever has not moved yet may");
    }
}
