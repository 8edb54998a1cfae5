//! Steps of the integrator that fit the rings.
//!
//! A ring takes up friction, and lets it go, like the square root of time. Steps that end where the next ring is about
//! to be touched, or has just been left, meet these kinks at their ends alone, and no ring's history begins within a
//! step but at its start. Compared with equal steps that halves the error of the spin for half the work, and
//! derivatives never see the infinite slope of the square root.

use clubface_math::Scalar;

/// How far short of a ring's mid-radius a step ends, in ring widths: more than steps miss their mark by.
const SHORT: f64 = 0.01;

/// Sizes the steps of one contact.
#[derive(Clone, Copy, Debug)]
pub struct RingSteps<S> {
    /// Number of rings n.
    pub rings: usize,
    /// Steps while the contact grows by one ring.
    pub steps_per_ring: usize,
    /// Penetration at which the contact radius is a_max, m.
    pub largest_depth: S,
    /// Longest step, s.
    pub longest: S,
}

impl<S: Scalar> RingSteps<S> {
    /// Next step (s) from penetration `depth` (m) with its first and second time derivatives.
    #[inline(always)]
    pub fn next(&self, depth: S, rate: S, acceleration: S) -> S {
        let grows = rate.re() > 0.0;
        let target = self.target(depth, grows);
        let squared = rate.squared() - acceleration * (depth - target) * 2.0;
        let distance = target - depth;
        let time = if squared.re() < 0.0 {
            // The contact turns before the next ring: to the turn, but not by ever smaller steps.
            if grows && -rate.re() / acceleration.re() > self.longest.re() * 0.2 {
                -(rate / acceleration)
            } else {
                self.longest * 0.2
            }
        } else if grows {
            distance * 2.0 / (rate + squared.sqrt())
        } else {
            distance * 2.0 / (rate - squared.sqrt())
        };
        let parts = (time.re() / self.longest.re()).ceil().max(1.0);
        if parts.is_finite() { time / parts } else { self.longest }
    }

    /// Penetration at the end of the next step but for its longest duration; a little below zero to separate.
    #[inline(always)]
    fn target(&self, depth: S, grows: bool) -> S {
        let (n, parts) = (self.rings as f64, self.steps_per_ring as f64);
        // Depth in terms of stations, which are `parts` to a ring, one of them just short of every mid-radius.
        let first = 0.5 - SHORT;
        let station = ((depth.re() / self.largest_depth.re()).max(0.0).sqrt() * n - first) * parts;
        let next = if grows { (station + 0.1).floor().max(-1.0) + 1.0 } else { (station - 0.1).ceil() - 1.0 };
        if next < 0.0 {
            return self.largest_depth * -1e-3;
        }
        let radius = (next / parts + first) / n;
        self.largest_depth * (radius * radius)
    }
}
