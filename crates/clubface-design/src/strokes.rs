//! Expected strokes on a straight, level hole.

use clubface_impact::ImpactError;

/// Strokes that a lie takes to hole out, by the distance from the hole.
#[derive(Clone, Debug)]
pub struct StrokesTable {
    distance: Vec<f64>,
    strokes: Vec<f64>,
}

impl StrokesTable {
    /// `strokes` at each `distance` [m]: at least two, the distances rising.
    ///
    /// # Errors
    /// Another number of strokes than of distances, fewer than two, or distances that do not rise.
    pub fn new(distance: Vec<f64>, strokes: Vec<f64>) -> Result<Self, ImpactError> {
        let rising = distance.windows(2).all(|pair| pair[0] < pair[1]);
        if distance.len() < 2 || distance.len() != strokes.len() || !rising {
            let message = "needs two or more distances, which rise, and the strokes at each";
            return Err(ImpactError::new("tables", message));
        }
        Ok(Self { distance, strokes })
    }

    /// Strokes at a distance: on straight lines between those of the table, nearer than the first as at the first, and
    /// farther than the last on the line through the last two.
    #[must_use]
    pub fn at(&self, distance: f64) -> f64 {
        let (places, strokes) = (&self.distance, &self.strokes);
        let above = places.partition_point(|&place| place <= distance).clamp(1, places.len() - 1);
        let slope = (strokes[above] - strokes[above - 1]) / (places[above] - places[above - 1]);
        if distance < places[0] {
            strokes[0]
        } else {
            strokes[above - 1] + slope * (distance - places[above - 1])
        }
    }
}

/// Where balls come to rest, in the order of [`Hole::tables`].
pub const LIES: [&str; 4] = ["green", "fairway", "rough", "recovery"];

/// A straight, level hole, whose line is that from the tee to the target.
#[derive(Clone, Debug)]
pub struct Hole {
    /// From the tee to the hole [m].
    pub length: f64,
    /// Width of the fairway [m].
    pub fairway: f64,
    /// Width of the rough on either side [m]; beyond it a ball needs a recovery shot.
    pub rough: f64,
    /// Radius of the green [m].
    pub green: f64,
    /// Strokes to hole out from each of [`LIES`].
    pub tables: [StrokesTable; 4],
}

impl Hole {
    /// The place among [`LIES`] of a ball at rest, ahead of the tee and to the right of the line [m], and the strokes
    /// that it still takes.
    #[must_use]
    pub fn after(&self, ahead: f64, right: f64) -> (usize, f64) {
        let (left, off) = ((self.length - ahead).hypot(right), right.abs());
        let lie = if left <= self.green {
            0
        } else if off <= 0.5 * self.fairway {
            1
        } else if off <= 0.5 * self.fairway + self.rough {
            2
        } else {
            3
        };
        (lie, self.tables[lie].at(left))
    }
}
