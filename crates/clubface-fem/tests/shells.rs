//! Shells: rigid motion, patch tests, a plate's frequency, momentum in the impact of a ball on a head of shells.

use clubface_fem::ball::{Ball, Piece};
use clubface_fem::cases::against_head;
use clubface_fem::contact::{Contact, ContactEnergy, Resultant};
use clubface_fem::element::{Element, Isotropic, Patch, ShellMaterial, ShellPatch, ShellRows};
use clubface_fem::head::{against_ball, DeformableHead, Driver, ShellHead};
use clubface_fem::material::{Material, NeoHookean, Shape};
use clubface_fem::mesh::{DriverFineness, ShellMesh};
use clubface_fem::solve::{Impact, Options, Structure};
use clubface_impact::first_touch::{FirstTouch, Motion};
use clubface_impact::shot::{Shot, INPUTS};
use clubface_math::{Mat3, Row, Vec3};

const YOUNG: f64 = 114e9;
const POISSON: f64 = 0.34;
const DENSITY: f64 = 4430.0;

fn titanium() -> ShellMaterial<f64> {
    ShellMaterial { elastic: Isotropic { young: YOUNG, poisson: POISSON }, density: DENSITY }
}

/// A square plate of `n` by `n` elements in the plane of x and y, its inner nodes moved off the grid by up to `skew` of an element.
fn plate(n: usize, side: f64, thickness: f64, skew: f64) -> ShellMesh<f64> {
    let step = side / n as f64;
    let mut nodes = Vec::new();
    for j in 0..=n {
        for i in 0..=n {
            let inner = (1..n).contains(&i) && (1..n).contains(&j);
            let off = if inner { skew * step } else { 0.0 };
            let (a, b) = ((3 * i + 5 * j) as f64, (7 * i + 2 * j) as f64);
            nodes.push(Vec3::new(i as f64 * step + off * a.sin(), j as f64 * step + off * b.cos(), 0.0));
        }
    }
    let at = |i: usize, j: usize| (j * (n + 1) + i) as u32;
    let quads: Vec<_> = (0..n * n)
        .map(|e| (e % n, e / n))
        .map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
        .collect();
    ShellMesh { thickness: vec![thickness; quads.len()], nodes, quads }
}

fn patch(mesh: &ShellMesh<f64>) -> ShellPatch<f64> {
    let rows = ShellRows { positions: 0, rotations: mesh.nodes.len() as u32 };
    ShellPatch::new(mesh, 0..mesh.quads.len(), titanium(), rows)
}

/// Largest force and moment on the given nodes.
fn largest(patch: &ShellPatch<f64>, nodes: usize, chosen: impl Fn(usize) -> bool) -> (f64, f64) {
    let mut most = (0.0_f64, 0.0_f64);
    for (&row, force) in patch.nodes().iter().zip(patch.forces()) {
        let row = row as usize;
        if chosen(row % nodes) {
            let size = force.vec().norm();
            if row < nodes {
                most.0 = most.0.max(size);
            } else {
                most.1 = most.1.max(size);
            }
        }
    }
    most
}

fn rows(nodes: &[Vec3<f64>]) -> Vec<Row<f64>> {
    let zeros = vec![Row::zero(); nodes.len()];
    nodes.iter().map(|p| Row::from_vec(*p)).chain(zeros).collect()
}

#[test]
fn rigid_motion_makes_no_force() {
    let mut mesh = plate(4, 0.02, 2e-3, 0.2);
    for (i, node) in mesh.nodes.iter_mut().enumerate() {
        // Warped elements.
        node.z = 1e-3 * (i as f64 * 1.7).sin();
    }
    let count = mesh.nodes.len();
    let mut patch = patch(&mesh);
    let (dt, angle, steps) = (4e-7, 2e-5, 500);
    let axis = Vec3::new(2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0);
    let turned = |k: usize| -> Vec<Vec3<f64>> {
        let (s, c) = (angle * k as f64).sin_cos();
        let turn = Mat3::diagonal(c) + Mat3::cross(axis).scale(s) + Mat3::outer(axis, axis).scale(1.0 - c);
        let shift = Vec3::new(35.0, -3.0, 2.0) * (dt * k as f64);
        mesh.nodes.iter().map(|p| turn * *p + shift).collect()
    };
    let mut before = turned(0);
    for k in 1..=steps {
        let now = turned(k);
        let mut velocities =
            rows(&now.iter().zip(&before).map(|(a, b)| (*a - *b) * (1.0 / dt)).collect::<Vec<_>>());
        velocities[count..].fill(Row::from_vec(axis * (angle / dt)));
        patch.assemble(&rows(&now), &velocities, dt);
        before = now;
    }
    // Over the force of strain one. A rotation by `angle` a step leaves shear of angle^3 / 6, in 500 steps 7e-13; rounding of the
    // velocities adds as much.
    let (force, moment) = largest(&patch, count, |_| true);
    let scale = YOUNG * 2e-3 * 5e-3;
    assert!(force < 1e-10 * scale && moment < 1e-10 * scale * 5e-3, "{force} N, {moment} N m");
}

/// Forces on inner nodes over those on the edge, for a displacement (and rotation) given by position, and the strain energy.
fn patch_test(field: impl Fn(Vec3<f64>) -> (Vec3<f64>, Vec3<f64>)) -> (f64, f64, f64) {
    let (n, mesh) = (5, plate(5, 0.02, 1.5e-3, 0.25));
    let count = mesh.nodes.len();
    let mut displacements = rows(&mesh.nodes);
    for (i, p) in mesh.nodes.iter().enumerate() {
        let (u, r) = field(*p);
        displacements[i] = Row::from_vec(u);
        displacements[count + i] = Row::from_vec(r);
    }
    let positions = rows(&mesh.nodes);
    let mut patch = patch(&mesh);
    patch.assemble(&positions, &displacements, 1.0);
    let inner = |i: usize| (1..n).contains(&(i % (n + 1))) && (1..n).contains(&(i / (n + 1)));
    let (a, b) = (largest(&patch, count, inner), largest(&patch, count, |i| !inner(i)));
    let energy = patch.energy(&positions);
    assert!(energy.hourglass < 1e-12 * energy.strain, "{energy:?}");
    (a.0 / b.0.max(b.1 / 4e-3), a.1 / b.1.max(b.0 * 4e-3), energy.strain)
}

#[test]
fn membrane_patch_test() {
    let [xx, yy, xy] = [1e-9, -0.4e-9, 0.7e-9];
    let (force, moment, energy) =
        patch_test(|p| (Vec3::new(xx * p.x + xy * p.y, yy * p.y + xy * p.x, 0.0), Vec3::zero()));
    // Rounding alone.
    assert!(force < 1e-10 && moment < 1e-10, "{force} {moment}");
    let plane = YOUNG / (1.0 - POISSON * POISSON);
    let density =
        0.5 * plane * (xx * xx + yy * yy + 2.0 * POISSON * xx * yy) + YOUNG / (1.0 + POISSON) * xy * xy;
    let exact = density * 1.5e-3 * 4e-4;
    // The square of the displacement gradient, 1e-9 of the strain.
    assert!((energy / exact - 1.0).abs() < 1e-8, "{energy} {exact}");
}

#[test]
fn bending_patch_test() {
    let [xx, yy, xy] = [1e-12, 0.6e-12, -0.8e-12];
    let (force, moment, energy) = patch_test(|p| {
        let w = -0.5 * (xx * p.x * p.x + yy * p.y * p.y) - xy * p.x * p.y;
        let (wx, wy) = (-(xx * p.x + xy * p.y), -(yy * p.y + xy * p.x));
        (Vec3::new(0.0, 0.0, w), Vec3::new(wy, -wx, 0.0))
    });
    // Membrane forces of the second order in the slopes of 1e-14; rounding is less.
    assert!(force < 1e-10 && moment < 1e-10, "{force} {moment}");
    let rigidity = YOUNG * 1.5e-3_f64.powi(3) / 12.0 / (1.0 - POISSON * POISSON);
    let density =
        0.5 * rigidity * (xx * xx + yy * yy + 2.0 * POISSON * xx * yy + 2.0 * (1.0 - POISSON) * xy * xy);
    assert!((energy / (density * 4e-4) - 1.0).abs() < 1e-8, "{energy}");
}

/// Nothing to touch.
struct Free;

impl Contact<f64> for Free {
    fn nodes(&self) -> &[u32] {
        &[]
    }
    fn assemble(&mut self, _: &[Row<f64>], _: &[Row<f64>], _: f64) {}
    fn forces(&self) -> &[Row<f64>] {
        &[]
    }
    fn resultant(&self) -> Resultant<f64> {
        Resultant { force: Vec3::zero(), normal: 0.0, area: 0.0 }
    }
    fn energy(&self) -> ContactEnergy {
        ContactEnergy::default()
    }
    fn nearest(&self, _: Vec3<f64>) -> (f64, Vec3<f64>) {
        (0.0, Vec3::zero())
    }
    fn head(&self) -> Option<Motion<f64>> {
        None
    }
}

#[test]
fn frequency_of_a_simply_supported_plate() {
    let (n, side, thickness) = (20, 0.1, 1e-3);
    let mesh = plate(n, side, thickness, 0.0);
    let count = mesh.nodes.len();
    let mut masses = mesh.masses(std::iter::once((0..mesh.quads.len(), DENSITY)));
    for (i, mass) in masses.translation.iter_mut().enumerate() {
        let (a, b) = (i % (n + 1), i / (n + 1));
        if a == 0 || a == n || b == 0 || b == n {
            // So heavy that it stays where it is.
            *mass *= 1e12;
        }
    }
    let all = masses.translation.into_iter().chain(masses.rotation).collect();
    let mut structure = Structure::new(rows(&mesh.nodes), all, vec![Box::new(patch(&mesh))], &[]);
    let k = std::f64::consts::PI / side;
    for (i, p) in mesh.nodes.iter().enumerate() {
        let ((sx, cx), (sy, cy)) = ((k * p.x).sin_cos(), (k * p.y).sin_cos());
        structure.velocities[i] = Row::from_vec(Vec3::new(0.0, 0.0, 1e-3 * sx * sy));
        structure.velocities[count + i] = Row::from_vec(Vec3::new(sx * cy, -cx * sy, 0.0) * (1e-3 * k));
    }
    let dt = 0.8 * structure.stable_step(60);
    let middle = (n / 2) * (n + 1) + n / 2;
    let (mut step, mut last) = (0, 0.0);
    let half = loop {
        structure.assemble(&mut Free, dt);
        structure.advance(&Free, dt);
        step += 1;
        let w = structure.positions[middle].0[2];
        if w < 0.0 {
            break dt * (step as f64 - w / (w - last));
        }
        last = w;
        assert!(step < 100_000, "the plate does not swing");
    };
    let rigidity = YOUNG * thickness.powi(3) / 12.0 / (1.0 - POISSON * POISSON);
    // Navier: omega = 2 (pi / a)^2 sqrt(D / (rho t)).
    let exact = 2.0 * k * k * (rigidity / (DENSITY * thickness)).sqrt();
    let ratio = std::f64::consts::PI / half / exact;
    // The issue asks for 1%; shear and rotary inertia take 0.1%, the mesh (pi/20)^2/12 of a curvature's half.
    assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
}

/// Momentum, and angular momentum about the origin with the spins of the shells' nodes.
fn momenta(s: &Structure<f64>) -> (Vec3<f64>, Vec3<f64>) {
    let (mut linear, mut angular) = (Vec3::zero(), Vec3::zero());
    for (i, (v, &m)) in s.velocities.iter().zip(&s.masses).enumerate() {
        let p = v.vec() * m;
        if i < s.translations {
            linear += p;
            angular += s.positions[i].vec().cross(p);
        } else {
            angular += p;
        }
    }
    (linear, angular)
}

/// A rubber ball of few elements.
fn rubber_ball() -> Ball<f64> {
    let rubber = Material {
        shape: Shape::NeoHookean(NeoHookean { shear: 20e6 }),
        bulk: 400e6,
        maxwell: vec![],
        density: 1100.0,
    };
    Ball {
        pieces: vec![Piece { name: "core".into(), radius: 0.0214, layers: 3, material: rubber }],
        cube: 6,
        element: Element::OnePoint,
        mass: Some(0.046),
    }
}

/// A head delivered at 35 m/s and its loft, `toe` metres from the face centre, turning about the vertical at `closure` (rad/s).
fn delivered(head: &ShellHead<f64>, toe: f64, closure: f64) -> FirstTouch<f64> {
    let is = head.mass_properties();
    let at = is.centre * -1.0;
    let [x, y, z] = is.inertia.rows;
    let values = [
        ("speed", 35.0),
        ("loft", head.loft),
        ("toe", toe),
        ("closure", closure),
        ("club_mass", is.mass),
        ("cg_x", at.x),
        ("cg_y", at.y),
        ("cg_z", at.z),
        ("ixx", x.x),
        ("iyy", y.y),
        ("izz", z.z),
        ("ixy", x.y),
        ("ixz", x.z),
        ("iyz", y.z),
        ("static_loft", head.loft),
        ("bulge", 0.305),
        ("roll", 0.305),
        ("hand", 1.0),
    ];
    let inputs = INPUTS.map(|input| values.iter().find(|v| v.0 == input.name).map_or(0.0, |v| v.1));
    FirstTouch::of(&Shot::from_inputs(&inputs))
}

#[test]
fn momentum_of_ball_and_head() {
    let driver = Driver { fineness: DriverFineness([12, 6, 8]), ..Driver::p2() };
    let head = driver.mesh().expect("the head is valid").head;
    let mut impact =
        against_ball(&head, &rubber_ball(), &delivered(&head, 0.01, 30.0), 0.3).expect("the case is valid");
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
    let scale = before.0.norm();
    assert!((after.0 - before.0).norm() < 1e-10 * scale);
    assert!((after.1 - before.1).norm() < 1e-10 * scale * 0.04, "{:?} {:?}", before.1, after.1);
}

/// A head too stiff to bend is a rigid one: the launch agrees, off centre and with the head turning.
#[test]
fn a_stiff_head_is_rigid() {
    let mut driver = Driver { fineness: DriverFineness([24, 12, 18]), ..Driver::p2() };
    driver.metal.elastic.young *= 50.0;
    let head = driver.mesh().expect("the head is valid").head;
    let (ball, touch) = (rubber_ball(), delivered(&head, 0.012, 40.0));
    let options = Options { until_separation: true, ..Options::default() };
    let launch = |mut impact: Impact<f64>| {
        let found = impact.run(&options, &mut |_, _| true).expect("the options are valid");
        assert!(found.stopped.is_none(), "{:?}", found.stopped);
        (found.ball, found.head)
    };
    let shells = launch(against_ball(&head, &ball, &touch, 0.3).expect("the case is valid"));
    let rigid = launch(against_head(&ball, &touch, 0.3).expect("the case is valid"));
    let apart = |a: Vec3<f64>, b: Vec3<f64>| (a - b).norm();
    // A fiftieth of the give of a titanium face is left, and the face is a polyhedron of 3 mm sides, which is off by 4 micrometres and
    // 0.3 degrees; the ball's nodes are 5 mm apart.
    assert!(
        apart(shells.0.velocity, rigid.0.velocity) < 0.01 * rigid.0.velocity.norm(),
        "{shells:?} {rigid:?}"
    );
    assert!(apart(shells.0.spin, rigid.0.spin) < 0.05 * rigid.0.spin.norm(), "{shells:?} {rigid:?}");
    assert!(
        apart(shells.1.velocity, rigid.1.velocity) < 0.01 * rigid.1.velocity.norm(),
        "{shells:?} {rigid:?}"
    );
    assert!(apart(shells.1.spin, rigid.1.spin) < 0.05 * rigid.1.spin.norm(), "{shells:?} {rigid:?}");
}

#[test]
fn heads_that_cannot_be_are_refused() {
    let driver = Driver { fineness: DriverFineness([12, 6, 8]), ..Driver::p2() };
    let head = driver.mesh().expect("the head is valid").head;
    let refused = |change: fn(&mut ShellHead<f64>), expected: &str| {
        let mut other = head.clone();
        change(&mut other);
        let told = other.check().expect_err(expected).to_string();
        assert!(told.contains(expected), "{told}");
    };
    refused(|h| h.shells.thickness[7] = 0.0, "thickness of face");
    refused(|h| h.shells.quads[5].swap(1, 2), "inverted or degenerate");
    refused(|h| h.shells.quads[5].reverse(), "side of two elements");
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
        "hangs on no other part",
    );
}
