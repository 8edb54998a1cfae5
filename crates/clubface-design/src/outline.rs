//! The outline of a face, seen along its normal.

use clubface_impact::ImpactError;

/// Distance by which a point may miss the outline and still count as on it [m].
pub const SLACK: f64 = 1e-9;

/// A polygon that bulges outwards everywhere: towards the toe and up the face [m].
#[derive(Clone, Debug)]
pub struct Outline {
    corners: Vec<[f64; 2]>,
    /// The corners from the heel-side end to the toe-side end, by both ways round.
    sides: [Vec<[f64; 2]>; 2],
    least: [f64; 2],
    greatest: [f64; 2],
}

impl Outline {
    /// Of corners, all the way round.
    ///
    /// # Errors
    /// Fewer than three corners, or one that is not finite.
    pub fn new(corners: Vec<[f64; 2]>) -> Result<Self, ImpactError> {
        if corners.len() < 3 || !corners.iter().flatten().all(|value| value.is_finite()) {
            return Err(ImpactError::new("outline", "needs three or more corners of finite numbers"));
        }
        let over = |axis: usize| corners.iter().map(move |corner| corner[axis]);
        let least = [0, 1].map(|axis| over(axis).fold(f64::INFINITY, f64::min));
        let greatest = [0, 1].map(|axis| over(axis).fold(f64::NEG_INFINITY, f64::max));
        let first = over(0).position(|toe| toe == least[0]).unwrap_or(0);
        let mut turned = corners.clone();
        turned.rotate_left(first);
        let last = turned.iter().position(|corner| corner[0] == greatest[0]).unwrap_or(0);
        let one = turned[..=last].to_vec();
        let other = turned[last..].iter().chain(&turned[..1]).rev().copied().collect();
        Ok(Self { corners, sides: [one, other], least, greatest })
    }

    /// The lower and heel-side corner of the box around it [m].
    #[must_use]
    pub fn least(&self) -> [f64; 2] {
        self.least
    }

    /// The upper and toe-side corner of the box around it [m].
    #[must_use]
    pub fn greatest(&self) -> [f64; 2] {
        self.greatest
    }

    /// The least and the greatest height of the face [m] at a place towards the toe [m]; beyond its ends, those there.
    #[must_use]
    pub fn extent(&self, toe: f64) -> (f64, f64) {
        let toe = toe.clamp(self.least[0], self.greatest[0]);
        if toe == self.least[0] || toe == self.greatest[0] {
            // A side may be upright there.
            let heights = self.corners.iter().filter(|corner| corner[0] == toe).map(|corner| corner[1]);
            return heights
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, top), each| (low.min(each), top.max(each)));
        }
        let [one, other] = [&self.sides[0], &self.sides[1]].map(|side| height(side, toe));
        (one.min(other), one.max(other))
    }

    /// Whether a point [m] is inside or on it.
    #[must_use]
    pub fn holds(&self, toe: f64, high: f64) -> bool {
        self.holds_about(toe, high, SLACK)
    }

    /// Whether a point [m] is inside, on it or less than `slack` [m] off it.
    #[must_use]
    pub fn holds_about(&self, toe: f64, high: f64, slack: f64) -> bool {
        self.holds_within(toe, high, self.extent(toe), slack)
    }

    /// The same with the extent at the place towards the toe.
    pub(crate) fn holds_within(&self, toe: f64, high: f64, (low, top): (f64, f64), slack: f64) -> bool {
        toe >= self.least[0] - slack
            && toe <= self.greatest[0] + slack
            && high >= low - slack
            && high <= top + slack
    }

    /// Its area [m2].
    #[must_use]
    pub fn area(&self) -> f64 {
        let next = self.corners.iter().cycle().skip(1);
        let twice: f64 = self.corners.iter().zip(next).map(|([x, y], [u, v])| x * v - y * u).sum();
        0.5 * twice.abs()
    }
}

/// The height of a side, whose corners rise towards the toe, at a place; beyond its ends that of the end.
fn height(side: &[[f64; 2]], toe: f64) -> f64 {
    let above = side.partition_point(|corner| corner[0] <= toe);
    match (above.checked_sub(1).map(|below| side[below]), side.get(above)) {
        (None, Some(first)) => first[1],
        (Some(last), None) => last[1],
        (Some([x, y]), Some([u, v])) => (v - y) / (u - x) * (toe - x) + y,
        (None, None) => f64::NAN,
    }
}
