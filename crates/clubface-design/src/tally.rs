//! Where shots go, summed up in memory that does not grow with their number: moments, fine histograms, a map of the
//! landings.

#[cfg(feature = "threads")]
use rayon::prelude::*;

/// How a quantity is counted: in bins of one width; what lies beyond is in those at the ends.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// Lower end of the first bin [SI].
    pub least: f64,
    /// Upper end of the last bin [SI].
    pub most: f64,
    /// Number of bins.
    pub bins: usize,
}

impl Scale {
    fn width(&self) -> f64 {
        (self.most - self.least) / self.bins as f64
    }
    fn place(&self, value: f64) -> usize {
        // A negative number and NaN become 0, a large one the largest there is.
        (((value - self.least) / self.width()) as usize).min(self.bins - 1)
    }
}

/// Counts of one quantity.
#[derive(Clone, Debug)]
pub struct Counts {
    scale: Scale,
    /// A value near the mean, about which moments are summed.
    centre: f64,
    bins: Vec<u64>,
    sums: [f64; 2],
}

impl Counts {
    fn add(&mut self, values: &[f64], lost: &[bool]) {
        for (&value, &lost) in values.iter().zip(lost) {
            if !lost {
                self.bins[self.scale.place(value)] += 1;
                let away = value - self.centre;
                self.sums[0] += away;
                self.sums[1] += away * away;
            }
        }
    }
}

/// Side of a square of the map of landings [m].
pub const CELL: f64 = 0.5;
/// Squares of the map, to the target from the tee on.
pub const AHEAD: usize = 1000;
/// Squares across, half of them on either side.
pub const ACROSS: usize = 800;

/// Counts of the landings.
#[derive(Clone, Debug)]
struct Landings {
    /// Quantities of carry and side.
    places: [usize; 2],
    map: Vec<u64>,
    /// Sums of the distance ahead, about the centre of the carry, the distance to the right, and their products.
    sums: [f64; 5],
}

impl Landings {
    fn add(&mut self, centre: f64, carry: &[f64], side: &[f64], lost: &[bool]) {
        let square = |distance: f64, squares: usize| ((distance / CELL) as usize).min(squares - 1);
        for ((&carry, &right), &lost) in carry.iter().zip(side).zip(lost) {
            if !lost {
                let ahead = forward(carry, right);
                let across = right + CELL * (ACROSS / 2) as f64;
                self.map[square(ahead, AHEAD) * ACROSS + square(across, ACROSS)] += 1;
                let x = ahead - centre;
                for (sum, value) in self.sums.iter_mut().zip([x, right, x * x, x * right, right * right]) {
                    *sum += value;
                }
            }
        }
    }
}

/// How far to the target a ball is [m] that is so far from the tee and to the right of the target line.
#[must_use]
pub fn forward(distance: f64, right: f64) -> f64 {
    (distance * distance - right * right).max(0.0).sqrt()
}

/// The ellipse, of the shape of the covariance of the landings, that holds a share of them.
#[derive(Clone, Copy, Debug)]
pub struct Ellipse {
    /// Mean landing [m], ahead and to the right.
    pub centre: [f64; 2],
    /// Half the long and the short axis [m].
    pub half_axes: [f64; 2],
    /// From the target line to the long axis, to the right [rad].
    pub angle: f64,
}

/// Counts of shots; those with NaN are lost, and counted as such.
#[derive(Clone, Debug)]
pub struct Tally {
    /// The number of shots, the lost ones among them.
    pub shots: u64,
    /// The number of shots without a result.
    pub lost: u64,
    counts: Vec<Counts>,
    landings: Option<Landings>,
    /// The quantity that decides whether a shot is lost.
    decisive: usize,
}

impl Tally {
    /// Of quantities with a scale and a value near the mean each; `landing` are the places of carry and side among
    /// them, without which no landings are counted.
    #[must_use]
    pub fn new(quantities: &[(Scale, f64)], landing: Option<[usize; 2]>) -> Self {
        let counts = |&(scale, centre): &(Scale, f64)| Counts {
            scale,
            centre,
            bins: vec![0; scale.bins],
            sums: [0.0; 2],
        };
        Self {
            shots: 0,
            lost: 0,
            counts: quantities.iter().map(counts).collect(),
            landings: landing.map(|places| Landings { places, map: vec![0; AHEAD * ACROSS], sums: [0.0; 5] }),
            decisive: landing.map_or(0, |places| places[0]),
        }
    }

    /// Counts shots: a column a quantity. Sums run in the order of the shots, whatever the number of threads.
    pub fn add(&mut self, columns: &[&[f64]]) {
        let lost: Vec<bool> = columns[self.decisive].iter().map(|value| !value.is_finite()).collect();
        self.shots += lost.len() as u64;
        self.lost += lost.iter().filter(|&&lost| lost).count() as u64;
        let Self { counts, landings, .. } = self;
        let centre = landings.as_ref().map_or(0.0, |landings| counts[landings.places[0]].centre);
        let mut tasks: Vec<Box<dyn FnOnce() + Send + '_>> = Vec::new();
        let lost = &lost[..];
        if let Some(landings) = landings {
            let [carry, side] = landings.places.map(|place| columns[place]);
            tasks.push(Box::new(move || landings.add(centre, carry, side, lost)));
        }
        for (counts, column) in counts.iter_mut().zip(columns) {
            tasks.push(Box::new(move || counts.add(column, lost)));
        }
        #[cfg(feature = "threads")]
        tasks.into_par_iter().for_each(|task| task());
        #[cfg(not(feature = "threads"))]
        tasks.into_iter().for_each(|task| task());
    }

    /// The number of shots with a result.
    #[must_use]
    pub fn counted(&self) -> u64 {
        self.shots - self.lost
    }

    fn divisor(&self) -> f64 {
        self.counted().max(1) as f64
    }

    /// Mean of a quantity.
    #[must_use]
    pub fn mean(&self, quantity: usize) -> f64 {
        let Counts { centre, sums, .. } = &self.counts[quantity];
        centre + sums[0] / self.divisor()
    }

    /// Standard deviation of a quantity.
    #[must_use]
    pub fn spread(&self, quantity: usize) -> f64 {
        let [first, second] = self.counts[quantity].sums.map(|sum| sum / self.divisor());
        (second - first * first).max(0.0).sqrt()
    }

    /// The value below which a share of the shots lies, evenly within a bin.
    #[must_use]
    pub fn quantile(&self, quantity: usize, share: f64) -> f64 {
        let Counts { scale, bins, .. } = &self.counts[quantity];
        let wanted = share * bins.iter().sum::<u64>() as f64;
        let mut before = 0;
        for (place, &count) in bins.iter().enumerate() {
            if (before + count) as f64 >= wanted {
                let part = if count > 0 { (wanted - before as f64) / count as f64 } else { 0.5 };
                return scale.least + (place as f64 + part) * scale.width();
            }
            before += count;
        }
        scale.most
    }

    /// Edges [SI] and counts of bins of about `width`, from the least shot to the greatest.
    #[must_use]
    pub fn histogram(&self, quantity: usize, width: f64) -> (Vec<f64>, Vec<u64>) {
        let Counts { scale, bins, .. } = &self.counts[quantity];
        let together = ((width / scale.width()).round_ties_even() as usize).max(1);
        let first = bins.iter().position(|&count| count > 0).unwrap_or(0);
        let last = bins.iter().rposition(|&count| count > 0).unwrap_or(0);
        let counts: Vec<u64> = bins[first..=last].chunks(together).map(|chunk| chunk.iter().sum()).collect();
        let edge = |place: usize| scale.least + scale.width() * (first + place * together) as f64;
        ((0..=counts.len()).map(edge).collect(), counts)
    }

    /// Mean [m] of the landings, ahead and to the right, and their covariance [m2]: variances and covariance. NaN where
    /// no landings are counted.
    #[must_use]
    pub fn landing(&self) -> ([f64; 2], [f64; 3]) {
        let Some(landings) = &self.landings else { return ([f64::NAN; 2], [f64::NAN; 3]) };
        let [x, y, xx, xy, yy] = landings.sums.map(|sum| sum / self.divisor());
        ([self.counts[landings.places[0]].centre + x, y], [xx - x * x, yy - y * y, xy - x * y])
    }

    /// Middles [m] of the squares with landings, ahead and to the right, and how many lie in each.
    fn cells(&self) -> Vec<([f64; 2], u64)> {
        let Some(landings) = &self.landings else { return Vec::new() };
        let middle = |place: usize| {
            let across = (place % ACROSS) as f64 - (ACROSS / 2) as f64;
            [CELL * ((place / ACROSS) as f64 + 0.5), CELL * (across + 0.5)]
        };
        let filled = landings.map.iter().enumerate().filter(|&(_, &count)| count > 0);
        filled.map(|(place, &count)| (middle(place), count)).collect()
    }

    /// The ellipse that holds a share of the landings; the squares of the map spread evenly within themselves.
    #[must_use]
    pub fn ellipse(&self, share: f64) -> Ellipse {
        let (centre, [xx, yy, xy]) = self.landing();
        let (xx, yy) = (xx + 1e-12, yy + 1e-12);
        let determinant = xx * yy - xy * xy;
        let mut distances: Vec<(f64, f64)> = (self.cells().iter())
            .map(|&([ahead, right], count)| {
                let (x, y) = (ahead - centre[0], right - centre[1]);
                (((yy * x * x - 2.0 * xy * x * y + xx * y * y) / determinant).sqrt(), count as f64)
            })
            .collect();
        distances.sort_by(|a, b| a.0.total_cmp(&b.0));
        let size = crossing(&distances, share);
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy).hypot(2.0 * xy));
        let half_axes = [size * (mean + half).sqrt(), size * (mean - half).max(0.0).sqrt()];
        Ellipse { centre, half_axes, angle: 0.5 * (2.0 * xy).atan2(xx - yy) }
    }
}

/// The distance within which a share of the weights lies: straight lines between the middles of the weights.
fn crossing(distances: &[(f64, f64)], share: f64) -> f64 {
    let wanted = share * distances.iter().map(|each| each.1).sum::<f64>();
    let (mut sum, mut last) = (0.0, None::<(f64, f64)>);
    for &(distance, weight) in distances {
        let reached = sum + 0.5 * weight;
        if reached >= wanted {
            return last.map_or(distance, |(before, at)| {
                at + (distance - at) * (wanted - before) / (reached - before)
            });
        }
        sum += weight;
        last = Some((reached, distance));
    }
    last.map_or(f64::NAN, |(_, at)| at)
}
