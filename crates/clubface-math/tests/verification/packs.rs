//! Numbers in and out of packs.

use clubface_math::{with_lanes, Dual, Pack, PackKernel, Real, Row, Scalar};

type Number = Dual<f64, 2>;

/// Numbers that are all different.
fn number(i: usize) -> Number {
    let value = i as f64;
    Dual { value, tangent: [100.0 + value, 1000.0 - value] }
}
fn plain(numbers: &[Number]) -> Vec<[f64; 3]> {
    numbers.iter().map(|n| [n.value, n.tangent[0], n.tangent[1]]).collect()
}

/// Every way in and out of packs, over twelve numbers and as many rows.
struct Through;
impl PackKernel<Number> for Through {
    type Output = (usize, Vec<[f64; 3]>);
    fn run<P: Pack<Real = Number>>(self) -> Self::Output {
        let given: Vec<Number> = (0..12).map(number).collect();
        let rows: Vec<Row<Number>> =
            (0..12).map(|i| Row([number(i), number(20 + i), number(40 + i), number(60)])).collect();
        let (mut copied, mut moved) = (vec![Number::zero(); 12], vec![Number::zero(); 12]);
        let (mut put, mut added) = (vec![Row::zero(); 12], vec![Row::zero(); 12]);
        let backwards: Vec<u32> = (0..12).rev().collect();
        let mut before = P::splat(number(99));
        for first in (0..12).step_by(P::LANES) {
            let pack = P::load(&given[first..]);
            (pack + P::splat(number(7))).store(&mut copied[first..]);
            // SAFETY: there are as many numbers and rows, and every index is one of a row.
            unsafe {
                pack.after(before).write(moved.as_mut_ptr().add(first));
                let vectors = P::gather(&rows, &backwards[first..]);
                P::put_rows(&mut put[first..], vectors);
                P::scatter_add(&mut added, &backwards[first..], vectors * pack);
            }
            before = pack;
        }
        let rows = put.iter().chain(&added).flat_map(|row| &row.0[..3]).copied();
        let all: Vec<Number> = copied.into_iter().chain(moved).chain(rows).collect();
        (P::LANES, plain(&all))
    }
}

#[test]
fn packs_hold_the_numbers_and_their_derivatives_in_their_places() {
    let (wide, found) = Number::dispatch(Through);
    let (narrow, single) = with_lanes(1, || Number::dispatch(Through));
    assert_eq!((narrow, found.len()), (1, 12 + 12 + 36 + 36));
    // Sums and products of whole numbers are exact, fused or not.
    assert_eq!(found, single, "{wide} lanes");
    let first: Vec<Number> = (0..12).map(|i| number(i) + number(7)).collect();
    assert_eq!(single[..12], plain(&first));
    let moved: Vec<Number> = (0..12).map(|i| number(if i == 0 { 99 } else { i - 1 })).collect();
    assert_eq!(single[12..24], plain(&moved));
    assert_eq!(single[24..27], plain(&[number(11), number(31), number(51)]));
}

/// Reads quads that stand apart, and returns the lanes of the whole and of each of its quads.
struct Apart;
impl PackKernel<f64> for Apart {
    type Output = (Vec<f64>, Vec<f64>);
    fn run<P: Pack<Real = f64>>(self) -> Self::Output {
        let values: Vec<f64> = (0..24).map(f64::from).collect();
        let quad = P::Quad::LANES;
        // SAFETY: each place is followed by as many numbers as a pack has.
        let pack = unsafe { P::read_quads([&raw const values[3], &raw const values[13]]) };
        let lanes = (0..P::LANES).map(|lane| pack.real(lane)).collect();
        let quads = (0..P::LANES).map(|lane| pack.quad(lane / quad).real(lane % quad)).collect();
        (lanes, quads)
    }
}

#[test]
fn quads_of_a_pack_stand_where_they_are_read() {
    for width in [1, 4, 8] {
        let (lanes, quads) = with_lanes(width, || f64::dispatch(Apart));
        let places = [3.0, 4.0, 5.0, 6.0, 13.0, 14.0, 15.0, 16.0];
        assert_eq!(lanes, places[..lanes.len()]);
        assert_eq!(quads, lanes);
    }
}
