//! A face struck everywhere: launch and flight over it, where a quantity is greatest, how large the effective face is,
//! and what scattered impacts cost.
//!
//! Points are towards the toe and up the face, from its centre, in the plane that is tangent there [m].

use crate::outline::{Outline, SLACK};
use crate::shot_batch::ShotBatch;
use crate::slices;
use clubface_impact::columns::{Column, Reject};
use clubface_impact::flight;
use clubface_impact::shot::{DELIVERY_COUNT, INPUT_COUNT, INPUTS};
use clubface_impact::{Accuracy, ImpactError, ImpactModel};
use core::convert::Infallible;
use core::f64::consts::TAU;
use core::ops::Range;

/// What is known of a point of the face, that of the launch first.
pub const QUANTITIES: [&str; 15] = [
    "ball_speed",
    "smash",
    "launch",
    "azimuth",
    "backspin",
    "sidespin",
    "total_spin",
    "spin_axis",
    "carry",
    "side",
    "curve",
    "total",
    "total_side",
    "apex",
    "landing_angle",
];
/// How many of them belong to the launch.
pub const LAUNCHED: usize = 8;
/// The place of the ball speed, of which the sweet spot and the effective face are.
pub const BALL_SPEED: usize = 0;

/// Points along a side of the grid on which the area of a computed face is measured, at least.
pub const FINE: usize = 101;
/// Into which each side of a cell is cut to measure an area, of a grid of [`FINE`] points or fewer.
const PARTS: usize = 8;
/// Times that the neighbourhood of the greatest value is looked at more closely, each time by [`CLOSER`].
const ZOOMS: usize = 4;
const CLOSER: f64 = 5.0;
/// Points along a side of such a neighbourhood.
const AROUND: usize = 11;
/// Points of Gauss's rule across the face, and as many up it.
pub const NODES: usize = 40;
/// Standard deviations to each side that are counted.
pub const REACH: f64 = 6.0;
/// Points that a thread takes at a time.
#[cfg(feature = "threads")]
const CHUNK: usize = 256;

/// `count` numbers from one end to the other, at even distances.
#[must_use]
pub fn evenly(least: f64, greatest: f64, count: usize) -> Vec<f64> {
    let step = (greatest - least) / (count - 1).max(1) as f64;
    let mut values: Vec<f64> = (0..count).map(|i| i as f64 * step + least).collect();
    if let [_, .., last] = &mut values[..] {
        *last = greatest;
    }
    values
}

/// The points of a grid, row by row from the lowest one up.
#[must_use]
pub fn grid_points(toe: &[f64], high: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let rows = high.iter().flat_map(|&up| toe.iter().map(move |&across| (across, up)));
    rows.unzip()
}

/// How a face is struck: everything but where.
#[derive(Clone, Copy, Debug)]
pub struct FaceStrike<'a> {
    /// What computes the impacts, and the values of its parameters.
    pub model: ImpactModel,
    /// Values of the parameters.
    pub parameters: &'a [f64],
    /// Accuracy of contact models.
    pub accuracy: Accuracy,
    /// Inputs of the impact, of which `toe` and `high` are replaced.
    pub inputs: &'a [f64; INPUT_COUNT],
    /// Inputs of the flight, of which the launch is replaced.
    pub flight: &'a [f64; flight::INPUT_COUNT],
}

impl FaceStrike<'_> {
    /// Checks that there are as many parameters as the model has.
    ///
    /// # Errors
    /// Another number of parameters.
    pub fn check(&self) -> Result<(), ImpactError> {
        let wanted = self.model.info().parameters.len();
        if self.parameters.len() == wanted {
            return Ok(());
        }
        Err(ImpactError::new("parameters", format!("{} given, {wanted} needed", self.parameters.len())))
    }

    /// The first `count` of [`QUANTITIES`] at points [m], a column each; NaN where there is no shot. None of the flight is
    /// computed where those of the launch are enough.
    #[must_use]
    pub fn at(&self, toe: &[f64], high: &[f64], count: usize) -> Vec<Vec<f64>> {
        let mut columns = vec![vec![0.0; toe.len()]; count];
        let strike = |rows: Range<usize>, columns: Vec<&mut [f64]>| {
            self.strike(&toe[rows.clone()], &high[rows], columns);
            Vec::<Reject>::new()
        };
        #[cfg(feature = "threads")]
        clubface_impact::parallel::in_parallel(CHUNK, 0..toe.len(), slices(&mut columns), strike);
        #[cfg(not(feature = "threads"))]
        strike(0..toe.len(), slices(&mut columns));
        columns
    }

    /// One of [`QUANTITIES`] at points [m].
    #[must_use]
    pub fn quantity_at(&self, quantity: usize, toe: &[f64], high: &[f64]) -> Vec<f64> {
        let count = if quantity < LAUNCHED { LAUNCHED } else { QUANTITIES.len() };
        self.at(toe, high, count).swap_remove(quantity)
    }

    fn strike(&self, toe: &[f64], high: &[f64], columns: Vec<&mut [f64]>) {
        let mut inputs = self.inputs.map(Column::Constant);
        for (input, described) in inputs.iter_mut().zip(&INPUTS[..DELIVERY_COUNT]) {
            match described.quantity.name {
                "toe" => *input = Column::Values(toe),
                "high" => *input = Column::Values(high),
                _ => {}
            }
        }
        let FaceStrike { model, parameters, accuracy, flight, .. } = *self;
        let names = QUANTITIES[..columns.len()].iter().copied();
        // A point without a shot is NaN in all columns.
        let _ = ShotBatch { model, parameters, accuracy, flight }.run(&inputs, names, columns);
    }
}

/// A point of the face, and a value there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacePoint {
    /// Towards the toe [m].
    pub toe: f64,
    /// Up the face [m].
    pub high: f64,
    /// The value [SI].
    pub value: f64,
}

/// A quantity over the points of a grid.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    /// Places towards the toe [m], rising.
    pub toe: &'a [f64],
    /// Places up the face [m], rising.
    pub high: &'a [f64],
    /// The values, row by row from the lowest one up; NaN where there is none.
    pub values: &'a [f64],
}

impl Field<'_> {
    /// Where the quantity is greatest within an outline; None where it has no value. `at` returns it at further points:
    /// the neighbourhood of the greatest value of the grid is looked at more and more closely.
    ///
    /// # Errors
    /// Those of `at`.
    pub fn greatest<E>(
        &self,
        outline: &Outline,
        mut at: impl FnMut(&[f64], &[f64]) -> Result<Vec<f64>, E>,
    ) -> Result<Option<FacePoint>, E> {
        let (toe, high) = grid_points(self.toe, self.high);
        let mut best = None;
        keep_greatest(&mut best, outline, &toe, &high, self.values);
        let Some(mut best) = best else { return Ok(None) };
        let spacing = |places: &[f64]| (places[places.len() - 1] - places[0]) / (places.len() - 1) as f64;
        if self.toe.len() < 2 || self.high.len() < 2 {
            return Ok(Some(best));
        }
        let mut reach = [spacing(self.toe), spacing(self.high)];
        for _ in 0..ZOOMS {
            let across = evenly(best.toe - reach[0], best.toe + reach[0], AROUND);
            let up = evenly(best.high - reach[1], best.high + reach[1], AROUND);
            let (toe, high) = grid_points(&across, &up);
            let values = at(&toe, &high)?;
            let mut near = Some(best);
            keep_greatest(&mut near, outline, &toe, &high, &values);
            best = near.unwrap_or(best);
            reach = reach.map(|each| each / CLOSER);
        }
        Ok(Some(best))
    }

    /// The area of an outline [m2] within which the quantity is at least so great. `at` returns it at further points, of
    /// which a finer grid is made where this one is coarse.
    ///
    /// # Errors
    /// Those of `at`.
    pub fn area<E>(
        &self,
        outline: &Outline,
        least: f64,
        mut at: impl FnMut(&[f64], &[f64]) -> Result<Vec<f64>, E>,
    ) -> Result<f64, E> {
        if self.toe.len().min(self.high.len()) >= FINE {
            return Ok(self.area_between(outline, least));
        }
        let (from, to) = (outline.least(), outline.greatest());
        let [toe, high] = [0, 1].map(|axis| evenly(from[axis], to[axis], FINE));
        let (across, up) = grid_points(&toe, &high);
        let values = at(&across, &up)?;
        Ok(Field { toe: &toe, high: &high, values: &values }.area_between(outline, least))
    }

    /// The same of the quantity as it is between the points, where it is linear.
    #[must_use]
    pub fn area_between(&self, outline: &Outline, least: f64) -> f64 {
        // Of a fine grid the cells are small enough.
        let parts = (PARTS * FINE / self.toe.len().max(self.high.len())).max(1);
        let shares: Vec<f64> = (0..parts).map(|i| (i as f64 + 0.5) / parts as f64).collect();
        let width = self.toe.len();
        let mut columns = Vec::new();
        for right in 1..width {
            let (left, size) = (self.toe[right - 1], self.toe[right] - self.toe[right - 1]);
            for &share in &shares {
                let toe = left + share * size;
                columns.push((right, share, toe, outline.extent(toe)));
            }
        }
        let mut total = 0.0;
        for top in 1..self.high.len() {
            let row = |row: usize| &self.values[row * width..(row + 1) * width];
            let (below, above) = (row(top - 1), row(top));
            let height = self.high[top] - self.high[top - 1];
            for &share_up in &shares {
                let high = self.high[top - 1] + share_up * height;
                for &(right, share, toe, extent) in &columns {
                    if !outline.holds_within(toe, high, extent, SLACK) {
                        continue;
                    }
                    let between = |row: &[f64]| row[right - 1] * (1.0 - share) + row[right] * share;
                    if between(below) * (1.0 - share_up) + between(above) * share_up >= least {
                        total += height * (self.toe[right] - self.toe[right - 1]);
                    }
                }
            }
        }
        total / (parts * parts) as f64
    }
}

/// Keeps the greatest value of those within an outline, the first of equal ones.
fn keep_greatest(best: &mut Option<FacePoint>, outline: &Outline, toe: &[f64], high: &[f64], values: &[f64]) {
    for ((&toe, &high), &value) in toe.iter().zip(high).zip(values) {
        let is_greater = best.map_or(!value.is_nan(), |best| value > best.value);
        if is_greater && outline.holds(toe, high) {
            *best = Some(FacePoint { toe, high, value });
        }
    }
}

/// Impacts that scatter about a point, normally and towards the toe and upwards independently.
#[derive(Clone, Copy, Debug)]
pub struct Scatter {
    /// The point [m], towards the toe and upwards.
    pub about: [f64; 2],
    /// Standard deviations [m].
    pub deviations: [f64; 2],
}

/// What they cost: values of each quantity, in order.
#[derive(Clone, Debug)]
pub struct Forgiveness {
    /// The share of swings that miss the face, of which nothing else is counted.
    pub missed: f64,
    /// Mean of each quantity.
    pub mean: Vec<f64>,
    /// Standard deviation of each quantity.
    pub deviation: Vec<f64>,
    /// By how much the mean is below the value at the point about which impacts scatter.
    pub loss: Vec<f64>,
}

impl Scatter {
    /// Checks that it is one of a face.
    ///
    /// # Errors
    /// Deviations that are not above 0 or larger than the face, or a point off it.
    pub fn check(&self, outline: &Outline) -> Result<(), ImpactError> {
        let (least, greatest) = (outline.least(), outline.greatest());
        for axis in 0..2 {
            let (size, deviation) = (greatest[axis] - least[axis], self.deviations[axis]);
            if !(deviation > 0.0 && deviation <= size) {
                let message = format!("{deviation} m is not allowed; above 0 and at most {size} m");
                return Err(ImpactError::new("spread", message));
            }
        }
        if outline.holds(self.about[0], self.about[1]) {
            return Ok(());
        }
        Err(ImpactError::new("about", format!("{:?} m is not allowed; a point on the face", self.about)))
    }

    /// Expectations over a face: integrals by Gauss's rule, across it and at each place from its lower to its upper edge.
    /// `at` returns quantities at points, a column each; NaN where there is no shot.
    ///
    /// # Errors
    /// Those of `at`.
    pub fn forgiveness<E>(
        &self,
        outline: &Outline,
        mut at: impl FnMut(&[f64], &[f64]) -> Result<Vec<Vec<f64>>, E>,
    ) -> Result<Forgiveness, E> {
        let (toe, high, mut weights) = self.rule(outline);
        let columns = at(&toe, &high)?;
        for (row, weight) in weights.iter_mut().enumerate() {
            if !columns.iter().all(|column| column[row].is_finite()) {
                *weight = 0.0;
            }
        }
        let on_face: f64 = weights.iter().sum();
        let expected = |column: &[f64], of: &dyn Fn(f64) -> f64| {
            let parts = column.iter().zip(&weights).filter(|&(_, &weight)| weight != 0.0);
            parts.map(|(&value, &weight)| of(value) * weight).sum::<f64>() / on_face
        };
        let mean: Vec<f64> = columns.iter().map(|column| expected(column, &|value| value)).collect();
        let deviation = (columns.iter().zip(&mean))
            .map(|(column, mean)| expected(column, &|value| (value - mean) * (value - mean)).max(0.0).sqrt())
            .collect();
        let middle = at(&[self.about[0]], &[self.about[1]])?;
        let loss = middle.iter().zip(&mean).map(|(column, mean)| column[0] - mean).collect();
        Ok(Forgiveness { missed: (1.0 - on_face).max(0.0), mean, deviation, loss })
    }

    /// Points of the face and their weights, which add up to the share of swings that hit it.
    fn rule(&self, outline: &Outline) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let rule = gauss_legendre(NODES);
        let ends = |axis: usize, (low, top): (f64, f64)| {
            let reach = REACH * self.deviations[axis];
            let low = low.max(self.about[axis] - reach);
            (low, top.min(self.about[axis] + reach).max(low))
        };
        /// Places between two ends, each with its weight by a normal density.
        fn places(
            rule: &[(f64, f64)],
            (low, top): (f64, f64),
            about: f64,
            deviation: f64,
        ) -> impl Iterator<Item = (f64, f64)> {
            rule.iter().map(move |&(place, weight)| {
                let at = low + (top - low) * (0.5 + 0.5 * place);
                (at, weight * 0.5 * (top - low) * density(at, about, deviation))
            })
        }
        let ([toe, high], [across, up]) = (self.about, self.deviations);
        let (mut toes, mut highs, mut weights) = (Vec::new(), Vec::new(), Vec::new());
        for (at, by_toe) in places(&rule, ends(0, (outline.least()[0], outline.greatest()[0])), toe, across) {
            for (above, by_high) in places(&rule, ends(1, outline.extent(at)), high, up) {
                toes.push(at);
                highs.push(above);
                weights.push(by_toe * by_high);
            }
        }
        (toes, highs, weights)
    }
}

fn density(value: f64, middle: f64, deviation: f64) -> f64 {
    let away = (value - middle) / deviation;
    (-0.5 * (away * away)).exp() / (deviation * TAU.sqrt())
}

/// Places and weights of Gauss's rule over -1 to 1, by Newton's method on the Legendre polynomial.
fn gauss_legendre(count: usize) -> Vec<(f64, f64)> {
    let n = count as f64;
    /// The Legendre polynomial and its slope.
    fn legendre(count: usize, x: f64) -> (f64, f64) {
        let (mut before, mut value) = (1.0, x);
        for k in 2..=count {
            let k = k as f64;
            (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
        }
        (value, count as f64 * (before - x * value) / (1.0 - x * x))
    }
    (0..count)
        .map(|i| {
            // F. G. Tricomi's estimate, good to a few digits, and steps that double them.
            let mut x = -(core::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5)).cos();
            for _ in 0..6 {
                let (value, slope) = legendre(count, x);
                x -= value / slope;
            }
            let (_, slope) = legendre(count, x);
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// Launch and flight over the box around a face.
#[derive(Clone, Debug)]
pub struct FaceMap<'a> {
    strike: FaceStrike<'a>,
    outline: &'a Outline,
    /// Places of the grid towards the toe [m].
    pub toe: Vec<f64>,
    /// Places of the grid up the face [m].
    pub high: Vec<f64>,
    /// A column for each of [`QUANTITIES`], row by row from the lowest one up.
    pub columns: Vec<Vec<f64>>,
}

impl<'a> FaceMap<'a> {
    /// Strikes a face at the points of a grid.
    ///
    /// # Errors
    /// Another number of parameters than the model has, or no shot anywhere on the face.
    pub fn new(
        strike: FaceStrike<'a>,
        outline: &'a Outline,
        toe: Vec<f64>,
        high: Vec<f64>,
    ) -> Result<Self, ImpactError> {
        strike.check()?;
        let (across, up) = grid_points(&toe, &high);
        let columns = strike.at(&across, &up, QUANTITIES.len());
        let map = Self { strike, outline, toe, high, columns };
        let mut best = None;
        keep_greatest(&mut best, outline, &across, &up, &map.columns[BALL_SPEED]);
        match best {
            Some(_) => Ok(map),
            None => Err(ImpactError::new("points", "no point of the face has a shot")),
        }
    }

    /// Whether each point is on the face.
    #[must_use]
    pub fn inside(&self) -> Vec<bool> {
        let (toe, high) = grid_points(&self.toe, &self.high);
        toe.iter().zip(&high).map(|(&toe, &high)| self.outline.holds(toe, high)).collect()
    }

    fn field(&self, quantity: usize) -> Field<'_> {
        Field { toe: &self.toe, high: &self.high, values: &self.columns[quantity] }
    }

    /// Where a quantity is greatest on the face; of the ball speed that is the sweet spot.
    #[must_use]
    pub fn greatest(&self, quantity: usize) -> Option<FacePoint> {
        let at = |toe: &[f64], high: &[f64]| Ok(self.strike.quantity_at(quantity, toe, high));
        let Ok::<_, Infallible>(best) = self.field(quantity).greatest(self.outline, at);
        best
    }

    /// The area of the face [m2] on which the ball speed is at least so great.
    #[must_use]
    pub fn area(&self, least: f64) -> f64 {
        let at = |toe: &[f64], high: &[f64]| Ok(self.strike.quantity_at(BALL_SPEED, toe, high));
        let Ok::<_, Infallible>(area) = self.field(BALL_SPEED).area(self.outline, least, at);
        area
    }

    /// What impacts cost that scatter over the face, for each of [`QUANTITIES`].
    ///
    /// # Errors
    /// A scatter that is none of this face.
    pub fn forgiveness(&self, scatter: Scatter) -> Result<Forgiveness, ImpactError> {
        scatter.check(self.outline)?;
        scatter.forgiveness(self.outline, |toe, high| Ok(self.strike.at(toe, high, QUANTITIES.len())))
    }
}
