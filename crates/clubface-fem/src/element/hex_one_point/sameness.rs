//! Which constants are the same to rounding: those of elements that a variable moves, or that differ by a rotation.

use super::numbers::{Block, Lines, SHAPE, SKEW, STIFFNESSES, VOLUME};
use crate::block::BLOCK;
use crate::mesh::CORNERS;
use clubface_math::{Real, Vec3};

/// How far constants may differ that are the same but for the rounding of positions: those of a ball half a metre
/// from the origin have lost 5e-17 m, of edges of a tenth of a millimetre, and differences of differences lose a
/// hundred times that.
const ROUNDING: f64 = 1e-10;

/// Whether no distance between corners depends on a variable: an element that a variable moves and turns keeps its
/// shape to rounding, and so its constants.
pub fn keeps_shape<R: Real>(corners: &[Vec3<R>; CORNERS], variable: usize) -> bool {
    let slopes = |v: &Vec3<R>| {
        let [x, y, z] = v.array().map(|number| number.derivatives()[variable]);
        x.abs().max(y.abs()).max(z.abs())
    };
    let most = corners.iter().map(slopes).fold(0.0, f64::max);
    (1..CORNERS).all(|a| {
        (0..a).all(|b| {
            let distance = (corners[a] - corners[b]).norm();
            distance.derivatives()[variable].abs() <= ROUNDING * most
        })
    })
}

/// Whether shapes with these derivatives grow alike in all directions: their patterns, which are relative to the
/// edges, stay as they are to rounding.
pub fn similar<R: Real>(blocks: &[Block<R>], slopes: &[Lines]) -> bool {
    blocks.iter().zip(slopes).all(|(block, slopes)| {
        (0..BLOCK).filter(|&lane| block.shape[VOLUME].get(lane) > 0.0).all(|lane| {
            let growth = slopes[VOLUME].get(lane) / block.shape[VOLUME].get(lane);
            slopes[SKEW..VOLUME].iter().all(|slope| slope.get(lane).abs() <= ROUNDING * growth.abs())
        })
    })
}

/// Whether constants are the same to rounding, given as shapes and the stiffnesses behind them, which have as many
/// parts as given.
pub fn alike<T>(a: &[T], b: &[T], parts: usize) -> bool {
    // Relative to the largest of its kind: values and derivatives of a stiffness are kinds of their own. Those of the
    // inverse Jacobian are of one kind.
    let count = SHAPE + STIFFNESSES * parts;
    assert_eq!(size_of::<T>(), count * size_of::<[f64; BLOCK]>());
    /// All numbers of a block: those of a constant for eight elements, then each of its derivatives.
    fn lines<T>(block: &T) -> &[[f64; BLOCK]] {
        let count = size_of::<T>() / size_of::<[f64; BLOCK]>();
        // SAFETY: constants are as many lines of eight numbers, and nothing else.
        unsafe { std::slice::from_raw_parts(std::ptr::from_ref(block).cast(), count) }
    }
    let kind = |line: usize| if line < SKEW { 0 } else { line };
    let mut largest = vec![0.0_f64; count];
    for block in a {
        for (line, numbers) in lines(block).iter().enumerate() {
            let largest = &mut largest[kind(line)];
            *largest = numbers.iter().fold(*largest, |largest, number| largest.max(number.abs()));
        }
    }
    let allowed = |line: usize| {
        // Shapes of hourglass patterns are relative to the edges; they may all be zero but for rounding.
        let least = if (SKEW..VOLUME).contains(&line) { 1.0 } else { 0.0 };
        ROUNDING * largest[kind(line)].max(least)
    };
    let allowed: Vec<f64> = (0..count).map(allowed).collect();
    a.len() == b.len()
        && a.iter().zip(b).all(|(a, b)| {
            let mut lines = lines(a).iter().zip(lines(b)).zip(&allowed);
            lines.all(|((a, b), allowed)| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= *allowed))
        })
}
