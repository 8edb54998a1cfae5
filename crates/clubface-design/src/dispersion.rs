//! Where the shots of a golfer go: deliveries, impacts and flights, tallied.

use crate::golfer::Golfer;
use crate::sequence::Sequence;
use crate::shot_batch::ShotBatch;
use crate::slices;
use crate::strokes::{Hole, LIES};
use crate::tally::{Scale, Tally, forward};
use clubface_impact::columns::{Column, Reject};
use clubface_impact::flight;
use clubface_impact::shot::{DELIVERY_COUNT, INPUT_COUNT, INPUTS};
use clubface_impact::{Accuracy, ImpactError, ImpactModel};
use core::f64::consts::FRAC_PI_2;
use core::ops::Range;

/// What is counted of a shot: quantities with their scales, those of the launch first.
pub const QUANTITIES: [(&str, Scale); 9] = [
    ("ball_speed", Scale { least: 0.0, most: 125.0, bins: 25_000 }),
    ("launch", Scale { least: -FRAC_PI_2, most: FRAC_PI_2, bins: 36_000 }),
    ("azimuth", Scale { least: -FRAC_PI_2, most: FRAC_PI_2, bins: 36_000 }),
    ("backspin", Scale { least: -1500.0, most: 1500.0, bins: 30_000 }),
    ("sidespin", Scale { least: -1500.0, most: 1500.0, bins: 30_000 }),
    ("carry", Scale { least: 0.0, most: 500.0, bins: 25_000 }),
    ("side", Scale { least: -250.0, most: 250.0, bins: 25_000 }),
    ("total", Scale { least: 0.0, most: 500.0, bins: 25_000 }),
    ("total_side", Scale { least: -250.0, most: 250.0, bins: 25_000 }),
];
/// How many of them belong to the launch.
pub const LAUNCHED: usize = 5;
/// Places of the carry and of the side.
pub const LANDING: [usize; 2] = [5, 6];
/// Places of the total and of its side.
const REST: [usize; 2] = [7, 8];
/// Shots that a thread takes at a time.
#[cfg(feature = "threads")]
const CHUNK: usize = 1024;
/// Shots in memory at a time.
const PIECE: usize = 1 << 16;

/// Shots of a golfer: the distribution, and everything that does not vary from shot to shot.
#[derive(Clone, Debug)]
pub struct Shots<'a> {
    /// The golfer.
    pub golfer: &'a Golfer,
    /// Places of the golfer's variables among the inputs of an impact.
    pub variables: Vec<usize>,
    /// What computes the impacts, and the values of its parameters.
    pub model: ImpactModel,
    /// Values of the parameters.
    pub parameters: &'a [f64],
    /// Accuracy of contact models.
    pub accuracy: Accuracy,
    /// Inputs of the impact, of which the variables are replaced.
    pub inputs: [f64; INPUT_COUNT],
    /// Inputs of the flight, of which the launch is replaced.
    pub flight: [f64; flight::INPUT_COUNT],
    /// The hole that strokes are counted on.
    pub hole: Option<&'a Hole>,
    /// Seed of the quasi-random numbers.
    pub seed: u64,
}

/// Where the shots went.
#[derive(Clone, Debug)]
pub struct Dispersion {
    /// Counts of [`QUANTITIES`].
    pub tally: Tally,
    /// Strokes expected after the shot, on average over the shots with a result; NaN without a hole.
    pub strokes: f64,
    /// Shares of the shots with a result that come to rest on each of [`LIES`]; NaN without a hole.
    pub lies: [f64; LIES.len()],
    /// The first landings [m], ahead and to the right.
    pub landings: Vec<[f64; 2]>,
}

impl Shots<'_> {
    /// Places of variables among the inputs of an impact, by their names.
    ///
    /// # Errors
    /// A name that is none of a delivery.
    pub fn places(names: &[String]) -> Result<Vec<usize>, ImpactError> {
        let place = |name: &String| {
            let found =
                INPUTS[..DELIVERY_COUNT].iter().position(|input| input.quantity.name == name.as_str());
            found.ok_or_else(|| ImpactError::new("variables", format!("{name} is no value of a delivery")))
        };
        names.iter().map(place).collect()
    }

    /// Hits `count` shots and sums up where they go; `landings` of the first are kept.
    ///
    /// # Errors
    /// A golfer, model or mean shot that cannot be computed.
    pub fn dispersion(&self, count: u32, landings: usize) -> Result<Dispersion, ImpactError> {
        if self.variables.len() != self.golfer.variables() {
            return Err(ImpactError::new("variables", "as many as there are means are needed"));
        }
        let centre = self.mean_shot()?;
        let quantities: Vec<(Scale, f64)> = QUANTITIES.iter().map(|each| each.1).zip(centre).collect();
        let mut tally = Tally::new(&quantities, Some(LANDING));
        let (mut strokes, mut lies, mut kept) = (0.0, [0u64; LIES.len()], Vec::new());
        for first in (0..count).step_by(PIECE) {
            let rows = PIECE.min((count - first) as usize);
            let mut columns = vec![vec![0.0; rows]; QUANTITIES.len()];
            self.hit_in_parallel(first, columns.iter_mut().map(Vec::as_mut_slice).collect());
            let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
            tally.add(&columns);
            let place = |[distance, side]: [usize; 2], row: usize| {
                [forward(columns[distance][row], columns[side][row]), columns[side][row]]
            };
            for row in (0..rows).filter(|&row| columns[LANDING[0]][row].is_finite()) {
                if kept.len() < landings {
                    kept.push(place(LANDING, row));
                }
                if let Some(hole) = self.hole {
                    let [ahead, right] = place(REST, row);
                    let (lie, after) = hole.after(ahead, right);
                    lies[lie] += 1;
                    strokes += after;
                }
            }
        }
        let counted = tally.counted() as f64;
        let share = |sum: f64| if self.hole.is_some() { sum / counted } else { f64::NAN };
        Ok(Dispersion {
            strokes: share(strokes),
            lies: lies.map(|each| share(each as f64)),
            landings: kept,
            tally,
        })
    }

    /// Quantities of the mean delivery.
    fn mean_shot(&self) -> Result<[f64; QUANTITIES.len()], ImpactError> {
        let still = self.golfer.without_spread();
        let mut values = [[0.0]; QUANTITIES.len()];
        let problem = Shots { golfer: &still, ..self.clone() }
            .hit(0, values.iter_mut().map(|value| &mut value[..]).collect());
        match problem {
            Some(error) => Err(error),
            None => Ok(values.map(|[value]| value)),
        }
    }

    /// Hits shots from index `first` on, on all threads of the current pool.
    fn hit_in_parallel(&self, first: u32, columns: Vec<&mut [f64]>) {
        let rows = columns[0].len();
        let hit = |rows: Range<usize>, columns: Vec<&mut [f64]>| {
            self.hit(first + rows.start as u32, columns);
            Vec::<Reject>::new()
        };
        #[cfg(feature = "threads")]
        clubface_impact::parallel::in_parallel(CHUNK, 0..rows, columns, hit);
        #[cfg(not(feature = "threads"))]
        hit(0..rows, columns);
    }

    /// Hits shots from index `first` on, a column a quantity; those without a result are NaN. Returns what is wrong with
    /// the first of them.
    fn hit(&self, first: u32, columns: Vec<&mut [f64]>) -> Option<ImpactError> {
        let rows = columns[0].len();
        let room = |count: usize| vec![vec![0.0; rows]; count];
        let (mut uniform, mut deliveries) = (room(self.golfer.dimensions()), room(self.variables.len()));
        for (dimension, numbers) in uniform.iter_mut().enumerate() {
            Sequence::new(dimension, self.seed).fill(first, numbers);
        }
        let numbers: Vec<&[f64]> = uniform.iter().map(Vec::as_slice).collect();
        self.golfer.deliveries(&numbers, &mut slices(&mut deliveries));

        let mut inputs = self.inputs.map(Column::Constant);
        for (&place, delivery) in self.variables.iter().zip(&deliveries) {
            inputs[place] = Column::Values(delivery);
        }
        let Self { model, parameters, accuracy, ref flight, .. } = *self;
        let names = QUANTITIES.iter().map(|each| each.0);
        let rejects = ShotBatch { model, parameters, accuracy, flight }.run(&inputs, names, columns);
        rejects.into_iter().next().map(|reject| reject.error)
    }
}
