//! Numbers in and out of packs.

use clubface_math::{Dual, Pack, PackKernel, Part, Real, Row, Scalar, with_lanes};

type Number = Dual<f64, 2>;

/// Numbers that are all different.
fn number(i: usize) -> Number {
    let value = i as f64;
    Dual { value, tangent: [100.0 + value, 1000.0 - value] }
}
fn plain(numbers: &[Number]) -> Vec<[f64; 3]> {
    numbers.iter().map(|n| [n.value, n.tangent[0], n.tangent[1]]).collect()
}

/// Every way in and out of packs, over sixteen numbers and as many rows.
struct Through;
impl PackKernel<Number> for Through {
    type Output = (usize, Vec<[f64; 3]>);
    fn run<P: Pack<Real = Number>>(self) -> Self::Output {
        let given: Vec<Number> = (0..16).map(number).collect();
        let rows: Vec<Row<Number>> =
            (0..16).map(|i| Row::new([number(i), number(20 + i), number(40 + i), number(60)])).collect();
        let (mut copied, mut moved) = (vec![Number::zero(); 16], vec![Number::zero(); 16]);
        let (mut put, mut added) = (vec![Row::zero(); 16], vec![Row::zero(); 16]);
        let backwards: Vec<u32> = (0..16).rev().collect();
        let mut before = P::splat(number(99));
        for first in (0..16).step_by(P::LANES) {
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
        let rows = put.iter().chain(&added).flat_map(|row| row.vec().array());
        let all: Vec<Number> = copied.into_iter().chain(moved).chain(rows).collect();
        (P::LANES, plain(&all))
    }
}

#[test]
fn packs_hold_the_numbers_and_their_derivatives_in_their_places() {
    let (wide, result) = Number::dispatch(Through);
    let (narrow, single) = with_lanes(1, || Number::dispatch(Through));
    assert_eq!((narrow, result.len()), (1, 16 + 16 + 48 + 48));
    // Sums and products of whole numbers are exact, fused or not.
    assert_eq!(result, single, "{wide} lanes");
    let first: Vec<Number> = (0..16).map(|i| number(i) + number(7)).collect();
    assert_eq!(single[..16], plain(&first));
    let moved: Vec<Number> = (0..16).map(|i| number(if i == 0 { 99 } else { i - 1 })).collect();
    assert_eq!(single[16..32], plain(&moved));
    assert_eq!(single[32..35], plain(&[number(15), number(35), number(55)]));
}

/// Reads quads that stand apart, and returns the lanes of the whole and of each of its quads.
struct Apart;
impl PackKernel<f64> for Apart {
    type Output = (Vec<f64>, Vec<f64>);
    fn run<P: Pack<Real = f64>>(self) -> Self::Output {
        let values: Vec<f64> = (0..24).map(f64::from).collect();
        let quad = P::Quad::LANES;
        // SAFETY: each place is followed by as many numbers as a pack has.
        let pack = unsafe { P::read_quads([&raw const values[3], &raw const values[13]], 0) };
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

/// Numbers an array of parts has room for.
const ROOM: usize = 24;

/// Numbers in an array that keeps their parts apart, read whole and as quads that stand apart, and written one further.
struct InParts;
impl PackKernel<Number> for InParts {
    type Output = Vec<[f64; 3]>;
    fn run<P: Pack<Real = Number>>(self) -> Self::Output {
        let (mut from, mut to) = (vec![0.0; 3 * ROOM], vec![0.0; 3 * ROOM]);
        // SAFETY of all: there is room for as many numbers in three parts.
        for i in 0..ROOM {
            unsafe { number(i).put_parts(from.as_mut_ptr().add(i), ROOM) };
        }
        let quad = P::Quad::LANES;
        let mut result = Vec::new();
        for first in (0..8).step_by(P::LANES) {
            let (pack, apart) = unsafe {
                let at = from.as_ptr().add(first);
                (P::read_parts(at, ROOM), P::read_quads([at.add(3), at.add(3 + quad)], ROOM))
            };
            unsafe { pack.write_parts(to.as_mut_ptr().add(first + 1), ROOM) };
            result.extend((0..P::LANES).map(|lane| apart.quad(lane / quad).real(lane % quad)));
        }
        result.extend((0..9).map(|i| unsafe { Number::from_parts(to.as_ptr().add(i), ROOM) }));
        plain(&result)
    }
}

#[test]
fn parts_of_numbers_stand_apart_in_their_places() {
    for width in [1, 4, 8] {
        let result = with_lanes(width, || Number::dispatch(InParts));
        let apart: Vec<Number> = (3..11).map(number).collect();
        assert_eq!(result[..8], plain(&apart), "{width} lanes");
        let written: Vec<Number> = (0..8).map(number).collect();
        assert_eq!((result[8], &result[9..]), ([0.0; 3], &plain(&written)[..]), "{width} lanes");
    }
}

/// A linear map in passes and by the rules of products, with a plain coefficient and with one that has derivatives.
struct InPasses;
impl PackKernel<Number> for InPasses {
    type Output = [[Vec<[f64; 3]>; 2]; 2];
    fn run<P: Pack<Real = Number>>(self) -> Self::Output {
        /// One pass.
        fn mapped<P: Pack, G: Part<P>>(pack: &P, factor: &[[f64; 8]; 3], pass: usize) -> P::Value {
            // SAFETY: no pack has more lanes.
            let factor = unsafe { G::coefficient(factor[0].as_ptr(), factor[pass].as_ptr()) };
            let result = (G::from_pack(pack, pass) * factor).into_value();
            G::from_value(result).into_value()
        }
        let pack = P::load(&(0..8).map(number).collect::<Vec<_>>());
        let factor = [[3.0; 8], [0.5; 8], [-2.0; 8]];
        let (mut plain_factor, mut whole) = (P::zero(), P::zero());
        for pass in 0..Number::PARTS {
            plain_factor.set_part(pass, mapped::<P, P::Value>(&pack, &factor, pass));
            let part = match pass {
                0 => mapped::<P, P::Value>(&pack, &factor, pass),
                _ => mapped::<P, P::Pair>(&pack, &factor, pass),
            };
            whole.set_part(pass, part);
        }
        let lanes = |pack: P| plain(&(0..P::LANES).map(|lane| pack.real(lane)).collect::<Vec<_>>());
        let varying = P::splat(Number { value: 3.0, tangent: [0.5, -2.0] });
        [[lanes(plain_factor), lanes(pack * 3.0)], [lanes(whole), lanes(pack * varying)]]
    }
}

#[test]
fn linear_maps_act_on_every_part_in_a_pass() {
    for width in [1, 4, 8] {
        for [passes, product] in with_lanes(width, || Number::dispatch(InPasses)) {
            assert_eq!(passes, product, "{width} lanes");
        }
    }
}
