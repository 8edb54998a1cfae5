//! A golfer as the distribution of deliveries, shot by shot.

use crate::normal::deviate;
use crate::sequence::MOST_DIMENSIONS;
use clubface_impact::ImpactError;

/// The distribution of some values of a delivery: normal, with mishits that spread wider.
#[derive(Clone, Debug)]
pub struct Golfer {
    /// Means [SI], one a variable.
    pub mean: Vec<f64>,
    /// Lower triangle, row by row as a square, whose product with its transpose is the covariance of shots that are no
    /// mishits.
    pub root: Vec<f64>,
    /// Variables whose deviates change their sign: the mirror images of the shots of the other hand.
    pub mirrored: Vec<bool>,
    /// Share of the shots that are mishits, below 1.
    pub mishit_share: f64,
    /// How many times as wide mishits spread.
    pub mishit_scale: f64,
}

impl Golfer {
    /// Independent random numbers behind a shot: one a variable, and one that decides whether it is a mishit.
    #[must_use]
    pub fn dimensions(&self) -> usize {
        self.mean.len() + usize::from(self.mishit_share > 0.0)
    }

    /// Checks that it is complete.
    ///
    /// # Errors
    /// What does not fit.
    pub fn validate(&self) -> Result<(), ImpactError> {
        let count = self.mean.len();
        if self.root.len() != count * count || self.mirrored.len() != count {
            let message = format!(
                "{} numbers of the root and {} signs for {count} means",
                self.root.len(),
                self.mirrored.len()
            );
            return Err(ImpactError::new("golfer", message));
        }
        if self.dimensions() > MOST_DIMENSIONS {
            let message = format!("{} variables; at most {}", self.dimensions(), MOST_DIMENSIONS);
            return Err(ImpactError::new("golfer", message));
        }
        Ok(())
    }

    /// Checks that there is a column for each dimension, all as long.
    ///
    /// # Errors
    /// What does not fit.
    pub fn validate_columns(&self, uniform: &[&[f64]]) -> Result<(), ImpactError> {
        if uniform.len() == self.dimensions() && uniform.iter().all(|column| column.len() == uniform[0].len())
        {
            return Ok(());
        }
        let message = format!("{} columns; {} of one length needed", uniform.len(), self.dimensions());
        Err(ImpactError::new("uniform", message))
    }

    /// Writes the deliveries that belong to numbers evenly distributed between 0 and 1: a column a dimension in, one a
    /// variable out, all as long.
    pub fn deliveries(&self, uniform: &[&[f64]], columns: &mut [&mut [f64]]) {
        let count = self.mean.len();
        let mut standard = [0.0; MOST_DIMENSIONS];
        for row in 0..uniform[0].len() {
            let wider = match uniform.get(count) {
                Some(decides) if decides[row] < self.mishit_share => self.mishit_scale,
                _ => 1.0,
            };
            for variable in 0..count {
                let deviate = deviate(uniform[variable][row]) * wider;
                standard[variable] = if self.mirrored[variable] { -deviate } else { deviate };
            }
            for variable in 0..count {
                let root = &self.root[variable * count..];
                let mut value = root[variable] * standard[variable];
                for other in 0..variable {
                    value += root[other] * standard[other];
                }
                columns[variable][row] = value + self.mean[variable];
            }
        }
    }
}
