//! A golfer as the distribution of deliveries, shot by shot.

use crate::normal::deviates;
use crate::sequence::MOST_DIMENSIONS;
use clubface_impact::ImpactError;
use core::ops::Range;

/// Shots drawn at a time.
const BLOCK: usize = 128;

/// The distribution of some values of a delivery: normal, with mishits that spread wider.
#[derive(Clone, Debug)]
pub struct Golfer {
    mean: Vec<f64>,
    /// Lower triangle as a square, row by row, whose product with its transpose is the covariance.
    root: Vec<f64>,
    mirrored: Vec<bool>,
    mishit_share: f64,
    mishit_scale: f64,
}

impl Golfer {
    /// A golfer of `mean` [SI], one a variable, and `covariance` [SI] of shots that are no mishits, row by row.
    /// `mirrored` are variables whose deviations change their sign: the mirror images of the shots of the other hand.
    /// `mishit_share` of the shots are mishits, which spread `mishit_scale` times as wide.
    ///
    /// # Errors
    /// A covariance that no variables can have, another number of values, mishits that cannot be, or too many variables.
    pub fn new(
        mean: Vec<f64>,
        covariance: &[f64],
        mirrored: Vec<bool>,
        mishit_share: f64,
        mishit_scale: f64,
    ) -> Result<Self, ImpactError> {
        let count = mean.len();
        if count == 0 || !mean.iter().all(|value| value.is_finite()) {
            return Err(ImpactError::new("mean", "needs one finite number or more"));
        }
        if covariance.len() != count * count || mirrored.len() != count {
            let message =
                format!("{} covariances and {} signs for {count} means", covariance.len(), mirrored.len());
            return Err(ImpactError::new("covariance", message));
        }
        let Some(root) = root(covariance, count) else {
            let message = "must be symmetric, of correlations that are possible together";
            return Err(ImpactError::new("covariance", message));
        };
        if !(0.0..1.0).contains(&mishit_share) {
            let message = format!("{mishit_share} is not allowed; from 0 to below 1");
            return Err(ImpactError::new("mishit_share", message));
        }
        if !(1.0..f64::INFINITY).contains(&mishit_scale) {
            return Err(ImpactError::new(
                "mishit_scale",
                format!("{mishit_scale} is not allowed; 1 or more"),
            ));
        }
        let golfer = Self { mean, root, mirrored, mishit_share, mishit_scale };
        if golfer.dimensions() > MOST_DIMENSIONS {
            let message = format!("{} variables; at most {MOST_DIMENSIONS}", golfer.dimensions());
            return Err(ImpactError::new("mean", message));
        }
        Ok(golfer)
    }

    /// The golfer whose shots are all the mean one.
    #[must_use]
    pub fn without_spread(&self) -> Self {
        Self { root: vec![0.0; self.root.len()], mishit_share: 0.0, ..self.clone() }
    }

    /// Number of variables.
    #[must_use]
    pub fn variables(&self) -> usize {
        self.mean.len()
    }

    /// Independent random numbers behind a shot: one a variable, and one that decides whether it is a mishit.
    #[must_use]
    pub fn dimensions(&self) -> usize {
        self.mean.len() + usize::from(self.mishit_share > 0.0)
    }

    /// Writes the deliveries that belong to numbers evenly distributed between 0 and 1: a column a dimension in, one a
    /// variable out, all as long.
    pub fn deliveries(&self, uniform: &[&[f64]], columns: &mut [&mut [f64]]) {
        let rows = uniform[0].len();
        let mut standard = vec![[0.0; BLOCK]; self.mean.len()];
        for first in (0..rows).step_by(BLOCK) {
            self.block(uniform, columns, &mut standard, first..rows.min(first + BLOCK));
        }
    }

    /// The same of some rows, at most [`BLOCK`]; `standard` takes their deviates.
    fn block(
        &self,
        uniform: &[&[f64]],
        columns: &mut [&mut [f64]],
        standard: &mut [[f64; BLOCK]],
        rows: Range<usize>,
    ) {
        let (count, size) = (self.mean.len(), rows.len());
        for variable in 0..count {
            let standard = &mut standard[variable][..size];
            deviates(&uniform[variable][rows.clone()], standard);
            if let Some(decides) = uniform.get(count) {
                for (deviate, &decides) in standard.iter_mut().zip(&decides[rows.clone()]) {
                    *deviate *= if decides < self.mishit_share { self.mishit_scale } else { 1.0 };
                }
            }
            if self.mirrored[variable] {
                for deviate in standard {
                    *deviate = -*deviate;
                }
            }
        }
        for variable in 0..count {
            let root = &self.root[variable * count..];
            let column = &mut columns[variable][rows.clone()];
            for (value, deviate) in column.iter_mut().zip(&standard[variable]) {
                *value = root[variable] * deviate;
            }
            for other in 0..variable {
                for (value, deviate) in column.iter_mut().zip(&standard[other]) {
                    *value += root[other] * deviate;
                }
            }
            for value in column {
                *value += self.mean[variable];
            }
        }
    }
}

/// Lower triangle whose product with its transpose is the covariance, by Cholesky; a variable may not vary at all. None
/// if no variables have this covariance.
fn root(covariance: &[f64], count: usize) -> Option<Vec<f64>> {
    let spread: Vec<f64> = (0..count).map(|i| covariance[i * count + i].max(0.0).sqrt()).collect();
    let varies = |i: usize| spread[i] > 0.0;
    let mut root = vec![0.0; count * count];
    for i in 0..count {
        if covariance[i * count + i] < 0.0 {
            return None;
        }
        for j in 0..count {
            let (one, other) = (covariance[i * count + j], covariance[j * count + i]);
            if !(varies(i) && varies(j)) {
                if one != 0.0 {
                    return None;
                }
                continue;
            }
            // Correlations, so that variables of different units count alike.
            let scale = spread[i] * spread[j];
            // Rounding, as of a file with five digits.
            if (one - other).abs() > 1e-12 * scale + 1e-5 * other.abs() || one.is_nan() || other.is_nan() {
                return None;
            }
            if j > i {
                continue;
            }
            let mut left = one / scale;
            for k in 0..j {
                left -= root[i * count + k] * root[j * count + k];
            }
            root[i * count + j] = if i > j {
                left / root[j * count + j]
            } else if left > 0.0 {
                left.sqrt()
            } else {
                return None;
            };
        }
    }
    for i in 0..count {
        for j in 0..=i {
            root[i * count + j] *= spread[i];
        }
    }
    Some(root)
}
