//! Sampling against what a sequence must fulfil, deviates against published quantiles, tallies against closed forms.

use clubface_design::dispersion::{LANDING, QUANTITIES, Shots};
use clubface_design::golfer::Golfer;
use clubface_design::normal::{deviate, deviates};
use clubface_design::sequence::{MOST_DIMENSIONS, Sequence};
use clubface_design::strokes::{Hole, LIES, StrokesTable};
use clubface_design::tally::{Scale, Tally, forward};
use clubface_impact::Accuracy;
use clubface_impact::flight::trajectory::TOLERANCE;
use clubface_impact::flight::{FlightShot, default_inputs, fly};
use clubface_impact::registry::named;
use clubface_impact::sensitivity::sensitivity_to_all;
use clubface_impact::shot::INPUT_COUNT;
use proptest::prelude::*;

fn numbers(dimension: usize, seed: u64, first: u32, count: usize) -> Vec<f64> {
    let mut numbers = vec![0.0; count];
    Sequence::new(dimension, seed).fill(first, &mut numbers);
    numbers
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// Whatever the scramble, each of 2^k equal intervals holds one of an aligned block of 2^k points.
    #[test]
    fn a_block_of_points_is_stratified_in_every_dimension(
        seed: u64, block in 0u32..1000, digits in 0u32..12, dimension in 0..MOST_DIMENSIONS
    ) {
        let count = 1usize << digits;
        let mut filled = vec![false; count];
        for number in numbers(dimension, seed, block << digits, count) {
            prop_assert!(0.0 < number && number < 1.0);
            filled[(number * count as f64) as usize] = true;
        }
        prop_assert!(filled.iter().all(|&filled| filled));
    }

    /// The first two dimensions are a net: each box of 2^-k by 2^-l holds one of an aligned block of 2^(k + l) points.
    #[test]
    fn the_first_two_dimensions_fill_boxes_of_every_shape(seed: u64, block in 0u32..100, k in 0u32..6, l in 0u32..6) {
        let count = 1usize << (k + l);
        let mut filled = vec![false; count];
        let [a, b] = [0, 1].map(|dimension| numbers(dimension, seed, block << (k + l), count));
        for (a, b) in a.iter().zip(&b) {
            let (a, b) = ((a * f64::from(1 << k)) as usize, (b * f64::from(1 << l)) as usize);
            filled[(a << l) + b] = true;
        }
        prop_assert!(filled.iter().all(|&filled| filled));
    }

    #[test]
    fn a_point_depends_on_its_index_alone(seed: u64, first in 0u32..100_000, dimension in 0..MOST_DIMENSIONS) {
        let all = numbers(dimension, seed, first, 40);
        prop_assert_eq!(&all[7..], &numbers(dimension, seed, first + 7, 33)[..]);
    }
}

/// The mean of a smooth function of eight numbers misses its integral by less than points by chance would, whose
/// standard deviation is 1.5 / sqrt(4096) = 0.023; over 20 seeds the root mean square is some 2e-3. Dimensions that
/// depended on each other would show here.
#[test]
fn points_integrate_a_function_of_many_numbers() {
    for dimensions in [0..8, 8..16, 16..24, 24..32] {
        let mut squares = 0.0;
        for seed in 0..20 {
            let columns: Vec<Vec<f64>> =
                dimensions.clone().map(|dimension| numbers(dimension, seed, 0, 4096)).collect();
            let product = |row: usize| columns.iter().map(|column| 0.5 + column[row]).product::<f64>();
            let mean = (0..4096).map(product).sum::<f64>() / 4096.0;
            squares += (mean - 1.0f64).powi(2);
        }
        let error = (squares / 20.0).sqrt();
        assert!(error < 4e-3, "dimensions {dimensions:?}: {error:e}");
    }
}

/// Seeds are independent scrambles: their means scatter about the truth, and do not share an error.
#[test]
fn seeds_are_independent() {
    let mean = |seed: u64| numbers(3, seed, 0, 3).iter().sum::<f64>() / 3.0 - 0.5;
    let together: f64 = (0..10_000u64).map(|seed| mean(seed) * mean(seed + 1)).sum::<f64>() / 10_000.0;
    let alone: f64 = (0..10_000u64).map(|seed| mean(seed).powi(2)).sum::<f64>() / 10_000.0;
    // The correlation of 10,000 pairs has a standard deviation of 0.01.
    assert!((together / alone).abs() < 0.04, "correlation {}", together / alone);
}

/// Quantiles of tables (Abramowitz and Stegun, 26.2 and 26.5; tails by 1 - Phi(x) in 30 digits).
#[test]
fn deviates_are_those_of_tables() {
    for (share, expected) in [
        (0.5, 0.0),
        (0.75, 0.674_489_750_196_081_7),
        (0.975, 1.959_963_984_540_054),
        (0.999, 3.090_232_306_167_813_5),
        (1e-10, -6.361_340_902_404_056),
        (1e-20, -9.262_340_089_798_408),
    ] {
        assert!(
            (deviate(share) - expected).abs() <= 4e-15 * expected.abs().max(0.1),
            "{share}: {}",
            deviate(share)
        );
    }
    for share in [0.01, 0.1, 0.3] {
        assert!((deviate(share) + deviate(1.0 - share)).abs() < 1e-14);
    }
}

/// In packs of any width, tails among the middle and rows that fill no pack included.
#[test]
fn deviates_side_by_side_are_those_alone_bit_for_bit() {
    let shares: Vec<f64> = (0..1003).map(|i| (f64::from(i) + 0.5) / 1003.0).chain([1e-300, 0.5]).collect();
    let expected: Vec<u64> = shares.iter().map(|&share| deviate(share).to_bits()).collect();
    for lanes in [1, 4, 8] {
        let mut values = vec![f64::NAN; shares.len()];
        clubface_math::with_lanes(lanes, || deviates(&shares, &mut values));
        assert!(values.iter().map(|value| value.to_bits()).eq(expected.iter().copied()), "{lanes} lanes");
    }
}

/// Landings of a normal cloud far from the tee, whose ellipse for a share has the half axes sqrt(-2 ln(1 - share))
/// standard deviations. Half-metre squares and 65,536 quasi-random points: 1%.
#[test]
fn the_ellipse_of_a_normal_cloud_is_that_of_its_covariance() {
    let (count, long, short, turned) = (65_536, 12.0, 4.0, 0.3f64);
    let [a, b] = [0, 1].map(|dimension| numbers(dimension, 7, 0, count));
    let (mut carry, mut side) = (Vec::new(), Vec::new());
    for (a, b) in a.iter().zip(&b) {
        let (u, v) = (long * deviate(*a), short * deviate(*b));
        let (ahead, right) =
            (200.0 + u * turned.cos() - v * turned.sin(), 60.0 + u * turned.sin() + v * turned.cos());
        carry.push(f64::hypot(ahead, right));
        side.push(right);
        assert!((forward(carry[carry.len() - 1], right) - ahead).abs() < 1e-9);
    }
    let scale = Scale { least: -250.0, most: 500.0, bins: 7500 };
    let mut tally = Tally::new(&[(scale, 200.0), (scale, 0.0)], Some([0, 1]));
    for part in 0..4 {
        let rows = part * count / 4..(part + 1) * count / 4;
        tally.add(&[&carry[rows.clone()], &side[rows]]);
    }
    tally.add(&[&[f64::NAN], &[0.0]]);
    assert_eq!((tally.shots, tally.lost, tally.counted()), (count as u64 + 1, 1, count as u64));
    for share in [0.5, 0.9] {
        let ellipse = tally.ellipse(share);
        let size = (-2.0 * f64::ln(1.0 - share)).sqrt();
        assert!((ellipse.half_axes[0] / (size * long) - 1.0).abs() < 0.01, "{ellipse:?}");
        assert!((ellipse.half_axes[1] / (size * short) - 1.0).abs() < 0.01, "{ellipse:?}");
        assert!((ellipse.angle - turned).abs() < 0.01, "{ellipse:?}");
        assert!(
            (ellipse.centre[0] - 200.0).abs() < 0.01 && (ellipse.centre[1] - 60.0).abs() < 0.01,
            "{ellipse:?}"
        );
    }
    assert!((tally.mean(0) - carry.iter().sum::<f64>() / count as f64).abs() < 1e-9);
    let inside = carry.iter().filter(|&&value| value < tally.quantile(0, 0.25)).count() as f64 / count as f64;
    // Within a bin of 0.1 m lie some 0.3% of the shots.
    assert!((inside - 0.25).abs() < 3e-3);
}

/// Broadie's layout: straight lines between the distances, and beyond the last on that through the last two.
#[test]
fn strokes_lie_on_straight_lines_and_each_lie_has_its_own() {
    let table =
        |more: f64| StrokesTable::new(vec![10.0, 20.0, 40.0], vec![1.0 + more, 2.0 + more, 3.0 + more]);
    let tables = [0.0, 10.0, 20.0, 30.0].map(|more| table(more).expect("a table"));
    for (distance, strokes) in [(0.0, 1.0), (10.0, 1.0), (15.0, 1.5), (30.0, 2.5), (60.0, 4.0)] {
        assert!((tables[0].at(distance) - strokes).abs() < 1e-12, "{distance}");
    }
    let hole = Hole { length: 100.0, fairway: 30.0, rough: 20.0, green: 12.0, tables };
    for (ahead, right, lie, strokes) in [
        (100.0, -11.0, 0, 1.1),
        (70.0, 0.0, 1, 12.5),
        (70.0, 16.0, 2, 20.0 + 2.0 + (34.0 - 20.0) / 20.0),
        (124.0, -36.0, 3, 30.0 + 3.0 + (f64::hypot(24.0, 36.0) - 40.0) / 20.0),
    ] {
        let result = hole.after(ahead, right);
        assert_eq!(result.0, lie);
        assert!((result.1 - strokes).abs() < 1e-12, "{result:?}");
    }
    assert!(hole.after(f64::NAN, 0.0).1.is_nan());
    assert!(StrokesTable::new(vec![1.0, 1.0], vec![1.0, 2.0]).is_err());
}

fn golfer(mishit_share: f64) -> Golfer {
    // Speed, path, face and toe: 1 m/s, 2 and 3 degrees with a correlation of 0.5, and 8 mm.
    let (path, face) = (2f64.to_radians(), 3f64.to_radians());
    #[rustfmt::skip]
    let covariance = [
        1.0, 0.0, 0.0, 0.0,
        0.0, path * path, 0.5 * path * face, 0.0,
        0.0, 0.5 * path * face, face * face, 0.0,
        0.0, 0.0, 0.0, 6.4e-5,
    ];
    Golfer::new(vec![45.0, 0.0, 0.01, 0.0], &covariance, vec![false; 4], mishit_share, 3.0).expect("a golfer")
}

fn shots(golfer: &Golfer) -> Shots<'_> {
    let mut inputs = [0.0; INPUT_COUNT];
    inputs[3] = 0.24;
    inputs[14..18].copy_from_slice(&[0.204, 40.8e-3, 11.4e-3, 1e-3]);
    inputs[18..24].copy_from_slice(&[2843e-7, 5679e-7, 4085e-7, -733e-7, 530.2e-7, 0.5e-7]);
    inputs[24..31].copy_from_slice(&[0.17, 0.305, 0.305, 0.12, 0.06, 0.0, 1.0]);
    inputs[31..34].copy_from_slice(&[0.0459, 0.0213, 83.36e-7]);
    let names = ["speed", "path", "face", "toe"].map(str::to_owned);
    Shots {
        golfer,
        variables: Shots::places(&names).expect("values of a delivery"),
        model: named("standard").expect("a model"),
        parameters: &[],
        accuracy: Accuracy::Fast,
        inputs,
        flight: default_inputs(),
        hole: None,
        seed: 5,
    }
}

/// Each shot alone, through impact and flight by hand, gives the means of the dispersion.
#[test]
fn a_dispersion_is_that_of_its_shots_one_by_one() {
    // More than a thread takes at a time.
    let (golfer, count) = (golfer(0.1), 2500);
    let parameters = named("standard").expect("a model").info().defaults();
    let tables = [0.0, 0.1, 0.2, 0.5]
        .map(|more| StrokesTable::new(vec![0.0, 400.0], vec![1.0 + more, 4.0 + more]).expect("a table"));
    let hole = Hole { length: 390.0, fairway: 30.0, rough: 20.0, green: 12.0, tables };
    let shots = Shots { parameters: &parameters, hole: Some(&hole), ..shots(&golfer) };
    let done = shots.dispersion(count, 20).expect("a dispersion");
    let uniform: Vec<Vec<f64>> =
        (0..golfer.dimensions()).map(|dimension| numbers(dimension, 5, 0, count as usize)).collect();
    let mut deliveries = vec![vec![0.0; count as usize]; 4];
    golfer.deliveries(
        &uniform.iter().map(Vec::as_slice).collect::<Vec<_>>(),
        &mut deliveries.iter_mut().map(Vec::as_mut_slice).collect::<Vec<_>>(),
    );
    let (mut carry, mut side, mut lost, mut landings) = (0.0, 0.0, 0, Vec::new());
    let (mut strokes, mut lies) = (0.0, [0.0; LIES.len()]);
    for row in 0..count as usize {
        let mut inputs = shots.inputs;
        for (&place, column) in shots.variables.iter().zip(&deliveries) {
            inputs[place] = column[row];
        }
        // Wide mishits miss the face.
        let Ok(impact) = sensitivity_to_all(shots.model, &inputs, &parameters, Accuracy::Fast) else {
            lost += 1;
            continue;
        };
        let mut air = default_inputs();
        air[3..9].copy_from_slice(&impact.values[8..14]);
        let flown = fly(&FlightShot::from_inputs(&air), TOLERANCE).outputs();
        carry += flown[0];
        side += flown[1];
        landings.push([forward(flown[0], flown[1]), flown[1]]);
        let (lie, after) = hole.after(forward(flown[7], flown[8]), flown[8]);
        lies[lie] += 1.0;
        strokes += after;
    }
    assert!(lost > 0 && done.tally.lost == lost);
    let (carry, side) = (carry / landings.len() as f64, side / landings.len() as f64);
    // Derivatives of the launch are computed with it, which may round its last digit otherwise.
    assert!(
        (done.tally.mean(LANDING[0]) - carry).abs() < 1e-6
            && (done.tally.mean(LANDING[1]) - side).abs() < 1e-6
    );
    for (kept, landing) in done.landings.iter().zip(&landings) {
        assert!((kept[0] - landing[0]).abs() < 1e-6 && (kept[1] - landing[1]).abs() < 1e-6);
    }
    assert_eq!(done.landings.len(), 20);
    assert!((done.strokes - strokes / landings.len() as f64).abs() < 1e-9);
    assert_eq!(done.lies, lies.map(|count| count / landings.len() as f64));
}

#[test]
fn the_number_of_threads_does_not_change_a_bit() {
    let golfer = golfer(0.0);
    let parameters = named("standard").expect("a model").info().defaults();
    let shots = Shots { parameters: &parameters, ..shots(&golfer) };
    let [one, three] = [1, 3].map(|threads| {
        let pool = clubface_impact::parallel::thread_pool(threads).expect("threads");
        let done = pool.install(|| shots.dispersion(70_000, 0)).expect("a dispersion");
        (0..QUANTITIES.len())
            .map(|place| [done.tally.mean(place), done.tally.spread(place)])
            .collect::<Vec<_>>()
    });
    assert_eq!(one, three);
}

/// 2^14 quasi-random shots have the covariance asked for to 2%, a tenth of them mishits three times as wide.
#[test]
fn deliveries_have_the_covariance_of_the_golfer() {
    let (golfer, count) = (golfer(0.1), 1 << 14);
    let uniform: Vec<Vec<f64>> =
        (0..golfer.dimensions()).map(|dimension| numbers(dimension, 3, 0, count)).collect();
    let mut columns = vec![vec![0.0; count]; golfer.variables()];
    golfer.deliveries(
        &uniform.iter().map(Vec::as_slice).collect::<Vec<_>>(),
        &mut columns.iter_mut().map(Vec::as_mut_slice).collect::<Vec<_>>(),
    );
    let mean = |column: &[f64]| column.iter().sum::<f64>() / count as f64;
    let covariance = |a: &[f64], b: &[f64]| {
        a.iter().zip(b).map(|(x, y)| (x - mean(a)) * (y - mean(b))).sum::<f64>() / count as f64
    };
    let wider = 1.0 + 0.1 * (9.0 - 1.0);
    let (path, face) = (2f64.to_radians(), 3f64.to_radians());
    for (a, b, expected) in [(0, 0, 1.0), (1, 1, path * path), (2, 2, face * face), (1, 2, 0.5 * path * face)]
    {
        let found = covariance(&columns[a], &columns[b]) / (wider * expected);
        assert!((found - 1.0).abs() < 0.02, "{a} and {b}: {found}");
    }
    assert!((mean(&columns[0]) - 45.0).abs() < 1e-3);
}

#[test]
fn a_covariance_that_no_variables_have_is_refused() {
    for covariance in
        [[1.0, 2.0, 2.0, 1.0], [1.0, 0.5, 0.4, 1.0], [0.0, 0.1, 0.1, 1.0], [-1.0, 0.0, 0.0, 1.0]]
    {
        assert!(
            Golfer::new(vec![45.0, 0.0], &covariance, vec![false; 2], 0.0, 1.0).is_err(),
            "{covariance:?}"
        );
    }
    let alone = |mean: f64, share, scale| Golfer::new(vec![mean], &[1.0], vec![false], share, scale);
    assert!(alone(45.0, 0.1, 3.0).is_ok());
    for refused in [(f64::NAN, 0.1, 3.0), (45.0, 1.0, 3.0), (45.0, f64::NAN, 3.0), (45.0, 0.1, 0.5)] {
        assert!(alone(refused.0, refused.1, refused.2).is_err(), "{refused:?}");
    }
}
