//! Quasi-random numbers that are a function of seed, dimension and index alone: a scrambled Sobol sequence.
//!
//! Direction numbers are those of S. Joe and F. Y. Kuo (SIAM J. Sci. Comput. 30, 2008, 2635-2654; the set
//! new-joe-kuo-6.21201). Digits are scrambled as A. B. Owen (1995) has it, by the hash of S. Laine and T. Karras (2011)
//! in the form of B. Burley (Practical hash-based Owen scrambling, J. Comput. Graph. Tech. 9(4), 2020, 1-20): whatever
//! the seed, each interval of a power of two holds its share of every aligned block of points.

use std::sync::LazyLock;

/// Largest number of dimensions.
pub const MOST_DIMENSIONS: usize = 32;
/// Binary digits of a number, and of an index.
const BITS: usize = 32;

/// Primitive polynomial, as a number of its coefficients, and the first direction numbers, of each dimension but the
/// first, whose sequence is van der Corput's.
const POLYNOMIALS: [(u32, &[u32]); MOST_DIMENSIONS - 1] = [
    (3, &[1]),
    (7, &[1, 3]),
    (11, &[1, 3, 1]),
    (13, &[1, 1, 1]),
    (19, &[1, 1, 3, 3]),
    (25, &[1, 3, 5, 13]),
    (37, &[1, 1, 5, 5, 17]),
    (41, &[1, 1, 5, 5, 5]),
    (47, &[1, 1, 7, 11, 19]),
    (55, &[1, 1, 5, 1, 1]),
    (59, &[1, 1, 1, 3, 11]),
    (61, &[1, 3, 5, 5, 31]),
    (67, &[1, 3, 3, 9, 7, 49]),
    (91, &[1, 1, 1, 15, 21, 21]),
    (97, &[1, 3, 1, 13, 27, 49]),
    (103, &[1, 1, 1, 15, 7, 5]),
    (109, &[1, 3, 1, 15, 13, 25]),
    (115, &[1, 1, 5, 5, 19, 61]),
    (131, &[1, 3, 7, 11, 23, 15, 103]),
    (137, &[1, 3, 7, 13, 13, 15, 69]),
    (143, &[1, 1, 3, 13, 7, 35, 63]),
    (145, &[1, 3, 5, 9, 1, 25, 53]),
    (157, &[1, 3, 1, 13, 9, 35, 107]),
    (167, &[1, 3, 1, 5, 27, 61, 31]),
    (171, &[1, 1, 5, 11, 19, 41, 61]),
    (185, &[1, 3, 5, 3, 3, 13, 69]),
    (191, &[1, 1, 7, 13, 1, 19, 1]),
    (193, &[1, 3, 7, 5, 13, 19, 59]),
    (203, &[1, 1, 3, 9, 25, 29, 41]),
    (211, &[1, 3, 5, 13, 23, 1, 55]),
    (213, &[1, 3, 7, 3, 13, 59, 17]),
];

static DIRECTIONS: LazyLock<[[u32; BITS]; MOST_DIMENSIONS]> = LazyLock::new(|| {
    core::array::from_fn(|dimension| {
        let mut directions = [0; BITS];
        let Some(&(polynomial, first)) = dimension.checked_sub(1).and_then(|place| POLYNOMIALS.get(place))
        else {
            return core::array::from_fn(|bit| 1 << (BITS - 1 - bit));
        };
        let degree = first.len();
        for bit in 0..BITS {
            directions[bit] = if bit < degree {
                first[bit] << (BITS - 1 - bit)
            } else {
                let mut direction = directions[bit - degree] ^ (directions[bit - degree] >> degree);
                for term in 1..degree {
                    if (polynomial >> (degree - term)) & 1 == 1 {
                        direction ^= directions[bit - term];
                    }
                }
                direction
            };
        }
        directions
    })
});

/// One dimension of a scrambled sequence.
#[derive(Clone, Copy, Debug)]
pub struct Sequence {
    directions: &'static [u32; BITS],
    /// What changes where an index ends in so many zeros: the sum of the directions up to there.
    steps: [u32; BITS],
    scramble: u32,
}

impl Sequence {
    /// The sequence of a dimension below [`MOST_DIMENSIONS`]; seeds differ in all dimensions.
    #[must_use]
    pub fn new(dimension: usize, seed: u64) -> Self {
        let directions = &DIRECTIONS[dimension];
        let mut sum = 0;
        let steps = directions.map(|direction| {
            sum ^= direction;
            sum
        });
        Self { directions, steps, scramble: mixed(seed, dimension as u64) }
    }

    /// Writes its numbers from index `first` on, strictly between 0 and 1: the middle of the cell that 32 digits name,
    /// since a corner may be 0, whose normal deviate is infinite.
    pub fn fill(&self, first: u32, numbers: &mut [f64]) {
        let mut index = first;
        let mut plain = self.plain(index);
        for number in numbers {
            *number = (f64::from(scrambled(plain, self.scramble)) + 0.5) * 2f64.powi(-(BITS as i32));
            // From one index to the next, digits change up to the lowest 0: a sum of directions for each such place.
            index = index.wrapping_add(1);
            plain ^= self.steps[index.trailing_zeros() as usize & (BITS - 1)];
        }
    }

    /// Digits before they are scrambled.
    fn plain(&self, index: u32) -> u32 {
        let (mut digits, mut left) = (0, index);
        while left != 0 {
            digits ^= self.directions[left.trailing_zeros() as usize];
            left &= left - 1;
        }
        digits
    }
}

/// Owen's scramble: each digit is flipped or not as the digits before it decide.
fn scrambled(digits: u32, scramble: u32) -> u32 {
    // A product carries from low to high digits alone, so that in reverse each depends on those before it.
    let mut x = digits.reverse_bits().wrapping_add(scramble);
    for factor in [0x6c50_b47c, 0xb82f_1e52, 0xc7af_e638, 0x8d22_f6e6_u32] {
        x ^= x.wrapping_mul(factor);
    }
    x.reverse_bits()
}

/// A number of a seed and a dimension: SplitMix64 (G. L. Steele, D. Lea and C. H. Flood, OOPSLA 2014).
fn mixed(seed: u64, dimension: u64) -> u32 {
    let mut x = seed;
    for step in [dimension, 0] {
        x = x.wrapping_add(step).wrapping_add(0x9e37_79b9_7f4a_7c15);
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^= x >> 31;
    }
    (x >> 32) as u32
}
