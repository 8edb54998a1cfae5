//! A ball met by a head of shells.

use crate::first_touch::delivered;
use crate::support::{bits, momenta, on_threads, piece, step};
use clubface_fem::FemError;
use clubface_fem::ball::BallConstruction;
use clubface_fem::cases::{ball_against_deformable_head, ball_against_plane, ball_against_rigid_head};
use clubface_fem::element::Element;
use clubface_fem::environment::Environment;
use clubface_fem::head::{DeformableHead, Driver, ShellHead};
use clubface_fem::material::{Hencky, Material, Maxwell, NeoHookean};
use clubface_fem::mesh::DriverFineness;
use clubface_fem::solve::{Options, Simulation, SimulationResult};
use clubface_math::Vec3;

/// A rubber ball of few elements.
fn rubber_ball() -> BallConstruction<f64> {
    let rubber =
        Material { law: NeoHookean { shear: 20e6 }.law(), bulk: 400e6, maxwell: vec![], density: 1100.0 };
    BallConstruction {
        pieces: vec![piece("core", 0.0214, 3, rubber)],
        cube: 6,
        element: Element::OnePoint,
        mass: Some(0.046),
    }
}

/// The same in a stiff, thin cover of some layers of elements.
fn covered_ball(layers: usize) -> BallConstruction<f64> {
    let mut ball = rubber_ball();
    let (shear, bulk) = (200e6, 600e6);
    let law = Hencky { shear }.law();
    let plastic = Material { law, bulk, maxwell: vec![Maxwell { modulus: 0.5, time: 2e-5 }], density: 950.0 };
    ball.pieces[0].radius = 0.0202;
    ball.pieces.push(piece("cover", 0.0214, layers, plastic));
    ball
}

/// Roh and Lee's head with some elements.
fn driver(fineness: [usize; 3]) -> ShellHead<f64> {
    let driver = Driver { fineness: DriverFineness(fineness), ..Driver::roh_and_lee() };
    driver.mesh().expect("the head is valid").head
}

/// A ball that such a head meets.
fn met(head: &ShellHead<f64>, ball: &BallConstruction<f64>, toe: f64, closure: f64) -> Simulation<f64> {
    ball_against_deformable_head(head, ball, &delivered(head, toe, closure), 0.3, &Environment::native())
        .expect("the case is valid")
}

/// A case of a coarse head, struck off centre, in which the core of the ball may take its steps two at a time.
fn struck() -> Simulation<f64> {
    met(&driver([18, 8, 12]), &covered_ball(2), 0.01, 30.0)
}

/// A run to its end.
fn run(impact: &mut Simulation<f64>, options: &Options) -> SimulationResult<f64> {
    let result = impact.run(options, &mut |_| true).expect("the options are valid");
    assert!(result.stopped.is_none(), "{:?}", result.stopped);
    result
}

/// The same ball thrown at a plane: its own cover sets the step.
fn thrown(layers: usize) -> Simulation<f64> {
    ball_against_plane(&covered_ball(layers), 35.0, 0.2, 0.3, &Environment::native())
        .expect("the case is valid")
}

#[test]
fn a_core_that_rests_in_every_second_step_changes_nothing() {
    let mut alone = struck();
    // Of one piece, none of the ball is inside.
    alone.parts.fill("ball".into());
    // The last two on both sides of the longest step at which the core may be subcycled.
    let pairs = [[(struck(), 0.75), (alone, 0.75)], [(thrown(2), 0.75), (thrown(2), 0.76)]];
    for pair in pairs {
        let [with, without] = pair.map(|(mut impact, safety)| {
            let options = Options { safety: Some(safety), ..Options::default() };
            let result = run(&mut impact, &options);
            let figures = result.records.summary(impact.radius);
            (result.ball, result.head, figures.peak_force, figures.energy_error)
        });
        assert_ne!(with.0.velocity.x.to_bits(), without.0.velocity.x.to_bits(), "nothing has rested");
        // Both schemes are of the second order, with steps below a hundredth of the time of contact.
        let close = |a: Vec3<f64>, b: Vec3<f64>| (a - b).norm() <= 1e-4 * b.norm();
        assert!(close(with.0.velocity, without.0.velocity) && close(with.1.velocity, without.1.velocity));
        assert!((with.0.spin - without.0.spin).norm() < 1e-3 * without.0.spin.norm(), "{with:?} {without:?}");
        // The force rings as nodes of so coarse a ball arrive, and so its peak differs by half a per cent.
        assert!((with.2 - without.2).abs() < 1e-2 * without.2, "{with:?} {without:?}");
        assert!(with.3 < 2.0 * without.3 + 1e-5, "energies off by {} and {}", with.3, without.3);
    }
}

#[test]
fn a_core_under_one_layer_of_cover_is_not_subcycled() {
    // It would make the layer swing more and more: energies would be off by 1% before the ball leaves. A tenth of that
    // is the error of the steps.
    let options = Options { safety: Some(0.75), ..Options::default() };
    let mut impact = thrown(1);
    let result = run(&mut impact, &options);
    let error = result.records.summary(impact.radius).energy_error;
    assert!(error < 1e-3, "energies off by {error}");
}

#[test]
fn the_force_does_not_come_and_go_with_the_steps() {
    // The head's shells are so small compared with the ball's elements that all of the ball could be subcycled.
    let head = Driver::roh_and_lee().mesh().expect("the head is valid").head;
    let mut impact = met(&head, &rubber_ball(), 0.0, 0.0);
    let options = Options { duration: 200e-6, ..Options::default() };
    let result = impact.run(&options, &mut |_| true).expect("the options are valid");
    let forces: Vec<f64> = result.records.contact.iter().map(|frame| frame.normal).collect();
    let most = forces.iter().copied().fold(0.0, f64::max);
    // What changes its sign from step to step, over some steps: 0.9% as nodes of so coarse a ball arrive, 2.4% with a
    // ball that rests as a whole.
    let zigzags = forces.windows(9).map(|some| {
        let signed = some
            .windows(2)
            .enumerate()
            .map(|(i, pair)| if i % 2 == 0 { pair[1] - pair[0] } else { pair[0] - pair[1] });
        signed.sum::<f64>().abs() / 8.0
    });
    let zigzag = zigzags.fold(0.0, f64::max);
    assert!(zigzag < 0.015 * most, "{zigzag} N in {most} N");
}

#[test]
fn subcycling_keeps_momenta_and_the_bits_of_any_number_of_threads() {
    const STEPS: usize = 400;
    let case = || {
        let mut impact = struck();
        let dt = impact.structure.stable_step(60) * 0.9;
        let core = impact.parts.iter().map(|part| part == "core").collect();
        impact.structure.subcycle(core);
        (impact, dt)
    };
    let (mut alone, dt) = case();
    let before = momenta(&alone.structure);
    for _ in 0..STEPS {
        step(&mut alone.structure, alone.contact.as_mut(), dt);
    }
    let after = momenta(&alone.structure);
    let scale = before[0].norm();
    assert!((after[0] - before[0]).norm() < 1e-10 * scale);
    assert!((after[1] - before[1]).norm() < 1e-10 * scale * 0.04, "{before:?} {after:?}");
    for threads in [1, 2, 3] {
        let (mut impact, dt) = case();
        // In parts, the second of which begins with a step in which the core rests, and the last with nodes that have
        // been settled.
        for count in [STEPS / 4 - 1, STEPS / 4 + 1, STEPS / 2] {
            let Simulation { structure, contact, .. } = &mut impact;
            if count == STEPS / 2 {
                structure.synchronise();
            }
            on_threads(threads, || structure.integrate(contact.as_mut(), dt, count, &mut |_, _| true));
        }
        impact.structure.synchronise();
        assert!(bits(&impact.structure) == bits(&alone.structure), "{threads} threads");
    }
}

#[test]
fn what_is_seen_of_a_run_is_as_its_nodes_are() {
    let mut impact = struck();
    let options = Options { duration: 150e-6, ..Options::default() };
    let (mut frames, mut touched, mut force, mut area) = (0, 0, 0.0, 0.0);
    let result = impact
        .run(&options, &mut |mut snapshot| {
            let (centre, axes) = (snapshot.centre, snapshot.axes());
            let sum = snapshot.contact_forces().fold(Vec3::zero(), |sum, node| sum + node.force);
            let places: Vec<Vec3<f64>> = snapshot.contact_forces().map(|node| node.position).collect();
            // At some frames only: the others see nodes that have been away for more than one.
            if frames % 3 == 2 {
                let whole = snapshot.synchronised();
                let masses = &whole.structure.masses[..whole.ball_nodes];
                let each = whole.structure.positions.iter().zip(masses);
                let first = each.fold(Vec3::zero(), |sum, (row, m)| sum + row.vec() * *m);
                let result = first * masses.iter().sum::<f64>().recip();
                // Rounding of some thousand summands.
                assert!((result - centre).norm() < 1e-14, "{result:?} {centre:?}");
                let surface = &whole.structure.positions;
                assert!(places.iter().all(|place| surface.iter().any(|row| row.vec() == *place)));
                touched += places.len();
                force = -sum.dot(axes[1]);
                area = snapshot.contact_forces().map(|node| node.area).sum::<f64>();
            }
            frames += 1;
            true
        })
        .expect("the options are valid");
    assert!(matches!(result.stopped, Some(FemError::Unfinished { .. })), "{:?}", result.stopped);
    assert!(frames > 25, "{frames} frames");
    assert!(touched > 100, "{touched} touches");
    // The force of the step before the last frame.
    let last =
        result.records.contact.iter().rev().find(|frame| (frame.tangential / force - 1.0).abs() < 1e-9);
    // Rounding of a hundred summands.
    let last = last.unwrap_or_else(|| panic!("{force} N is in no record"));
    assert!((area / last.area - 1.0).abs() < 1e-12, "{area} m2, in the record {}", last.area);
}

#[test]
fn momentum_of_ball_and_head() {
    let mut impact = met(&driver([12, 6, 8]), &rubber_ball(), 0.01, 30.0);
    let dt = impact.structure.stable_step(60) * 0.8;
    let before = momenta(&impact.structure);
    let mut most = 0.0_f64;
    for _ in 0..300 {
        impact.structure.assemble(impact.contact.as_mut(), dt);
        most = most.max(impact.contact.resultant().normal);
        impact.structure.advance(impact.contact.as_ref(), dt);
    }
    assert!(most > 1000.0, "they have met: {most} N");
    let after = momenta(&impact.structure);
    // Rounding, over the momentum of the head and its lever.
    let scale = before[0].norm();
    assert!((after[0] - before[0]).norm() < 1e-10 * scale);
    assert!((after[1] - before[1]).norm() < 1e-10 * scale * 0.04, "{before:?} {after:?}");
}

/// A head too stiff to bend is a rigid one: the launch agrees, off centre and with the head turning.
#[test]
fn a_stiff_head_is_rigid() {
    let mut driver = Driver { fineness: DriverFineness([24, 12, 18]), ..Driver::roh_and_lee() };
    driver.metal.elastic.young *= 50.0;
    let head = driver.mesh().expect("the head is valid").head;
    let options = Options { until_separation: true, ..Options::default() };
    let launch = |mut impact: Simulation<f64>| {
        let result = run(&mut impact, &options);
        [result.ball, result.head]
    };
    let touch = delivered(&head, 0.012, 40.0);
    let rigid = ball_against_rigid_head(&rubber_ball(), &touch, 0.3, &Environment::native());
    let (shells, rigid) =
        (launch(met(&head, &rubber_ball(), 0.012, 40.0)), launch(rigid.expect("the case is valid")));
    // A fiftieth of the give of a titanium face is left, and the face is a polyhedron of 3 mm sides, which is off by 4
    // micrometres and 0.3 degrees; the ball's nodes are 5 mm apart.
    for (a, b) in shells.iter().zip(&rigid) {
        assert!((a.velocity - b.velocity).norm() < 0.01 * b.velocity.norm(), "{a:?} {b:?}");
        assert!((a.spin - b.spin).norm() < 0.05 * b.spin.norm(), "{a:?} {b:?}");
    }
}

#[test]
fn heads_that_cannot_be_are_refused() {
    let head = driver([12, 6, 8]);
    let refused = |change: fn(&mut ShellHead<f64>), expected: &str| {
        let mut other = head.clone();
        change(&mut other);
        let message = other.check().expect_err(expected).to_string();
        assert!(message.contains(expected), "{message}");
    };
    refused(|h| h.shells.thickness[7] = 0.0, "thickness of face");
    refused(|h| h.shells.quads[5].swap(1, 2), "inverted or degenerate");
    refused(|h| h.shells.quads[5].reverse(), "used twice in the same direction");
    refused(|h| h.shells.quads.iter_mut().for_each(|quad| quad.reverse()), "turned away");
    refused(|h| h.shells.nodes.iter_mut().for_each(|p| *p = *p * 1e3), "size of the head");
    refused(|h| h.parts[1].material.elastic.poisson = 0.5, "crown.poisson");
    refused(|h| h.parts[2].material.elastic.young = -1.0, "sole.youngs");
    refused(|h| h.parts.iter_mut().for_each(|p| p.face = false), "face");
    refused(
        |h| {
            // A patch of elements with nodes of its own.
            for quad in 0..3 {
                for corner in 0..4 {
                    let place = h.shells.nodes[h.shells.quads[quad][corner] as usize];
                    h.shells.quads[quad][corner] = h.shells.nodes.len() as u32;
                    h.shells.nodes.push(place);
                }
            }
        },
        "connected to no other part",
    );
}
