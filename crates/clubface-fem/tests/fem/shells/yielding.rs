//! Shells that yield, against closed forms of plasticity.

use super::support::{Body, DENSITY, YOUNG, patch_of, plate, rows, titanium};
use crate::support::{Loads, Random};
use clubface_fem::element::{Isotropic, Patch, Rule, ShellMaterial};
use clubface_fem::material::{Hardening, PlaneState, PlaneStress, Symmetric};
use clubface_math::{Row, Vec3};

const YIELD: f64 = 800e6;
const THICKNESS: f64 = 2e-3;
const SIDE: f64 = 0.01;

/// An incompressible metal: its strains across are half of those along it, elastic or not, so that a strip in uniform
/// curvature is free of stress across in every layer.
fn incompressible(hardening: Hardening<f64>) -> ShellMaterial<f64> {
    ShellMaterial::elastic(Isotropic { young: YOUNG, poisson: 0.5 }, DENSITY).yielding(hardening)
}

/// A square element whose strain and curvature are given.
struct Strip {
    patch: Box<dyn Patch<f64>>,
    sides: [f64; 2],
    /// Work done on it, J.
    work: f64,
    /// Force and moment along x over the width, N/m and N.
    now: [f64; 2],
}

impl Strip {
    fn new(material: ShellMaterial<f64>) -> Self {
        let patch = patch_of(&plate(1, SIDE, THICKNESS, 0.0), material);
        Self { patch, sides: [SIDE; 2], work: 0.0, now: [0.0; 2] }
    }
    /// A step of logarithmic strain and of curvature (1/m), both along x, and half of them against it across.
    fn step(&mut self, strain: f64, curvature: f64) {
        let (before, [a, b]) = (self.now, self.sides);
        self.sides = [a * strain.exp(), b * (-0.5 * strain).exp()];
        let places = |[a, b]: [f64; 2]| {
            [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|[i, j]| Vec3::new(a * i, b * j, 0.0))
        };
        let (old, new) = (places([a, b]), places(self.sides));
        let mut velocities = rows(&[0, 1, 2, 3].map(|i| new[i] - old[i]));
        for i in 0..4 {
            let (x, y) = (new[i].x - 0.5 * self.sides[0], new[i].y - 0.5 * self.sides[1]);
            velocities[4 + i] = Row::from_vec(Vec3::new(0.5 * curvature * y, curvature * x, 0.0));
        }
        self.patch.assemble(&rows(&new), &velocities, 1.0);
        // Nodes at x > 0 are held by minus the forces on them.
        let mut now = [0.0; 2];
        for (&row, force) in self.patch.nodes().iter().zip(self.patch.forces()) {
            if row % 4 % 2 == 1 {
                let index = usize::from(row >= 4);
                now[index] -= force.0[index] / self.sides[1];
            }
        }
        let area = self.sides[0] * self.sides[1];
        self.work += 0.5 * area * ((before[0] + now[0]) * strain + (before[1] + now[1]) * curvature);
        self.now = now;
    }
    /// Stress over the wall, Pa.
    fn stress(&self) -> f64 {
        self.now[0] / THICKNESS
    }
    fn energy(&mut self) -> clubface_fem::element::Energy {
        let [a, b] = self.sides;
        let corners = [[0.0, 0.0], [a, 0.0], [0.0, b], [a, b]].map(|[x, y]| Vec3::new(x, y, 0.0));
        self.patch.energy(&rows(&corners))
    }
}

#[test]
fn stress_of_the_surfaces_and_its_axes() {
    // Uniaxial stress E (strain +- half the thickness times the curvature); with the corners turned the tensors turn
    // along. Lobatto's outermost points are on the surfaces.
    let elastic = ShellMaterial::elastic(Isotropic { young: YOUNG, poisson: 0.5 }, DENSITY);
    let (sine, cosine) = 0.7_f64.sin_cos();
    let turn =
        clubface_math::Mat3::rotation_z((sine, cosine)) * clubface_math::Mat3::rotation_x((cosine, sine));
    for points in [None, Some(Rule::Lobatto(3))] {
        let mut strip = Strip::new(ShellMaterial { points, ..elastic.clone() });
        strip.step(1e-4, 0.05);
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        let corners = corners.map(|[i, j]| turn * Vec3::new(strip.sides[0] * i, strip.sides[1] * j, 0.0));
        let mut outputs = Vec::new();
        strip.patch.element_output(&rows(&corners), &mut |number, output| outputs.push((number, *output)));
        let [(0, output)] = outputs[..] else { panic!("{outputs:?}") };
        for (side, bent) in [(0, 0.5 * THICKNESS * 0.05), (1, -0.5 * THICKNESS * 0.05)] {
            let strain = 1e-4 + bent;
            let along = |v: [f64; 3]| Symmetric([v[0], v[1], v[2], 0.0, 0.0, 0.0]).seen_through(&turn).0;
            let close = |result: [f64; 6], exact: [f64; 6], size: f64| {
                // A strain increment is the change of squared lengths over the last one, off by a share of its own
                // size.
                let most = result.iter().zip(exact).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
                assert!(most < 3e-4 * size, "{result:?} {exact:?}");
            };
            close(output.stress[side], along([YOUNG * strain, 0.0, 0.0]), YOUNG * 1e-4);
            close(output.strain[side], along([strain, -0.5 * strain, -0.5 * strain]), 1e-4);
        }
        assert_eq!(output.plastic_strain, 0.0);
    }
}

#[test]
fn tension_loading_unloading_and_back() {
    // Linear hardening: a bilinear curve, E and E H / (E + H); after unloading it yields where it left off, and as far
    // on the other side.
    let modulus = 10e9;
    let mut strip = Strip::new(incompressible(Hardening::linear(YIELD, modulus)));
    let tangent = YOUNG * modulus / (YOUNG + modulus);
    let first = YIELD / YOUNG;
    let mut strain = 0.0;
    let mut go = |strip: &mut Strip, to: f64| {
        let steps = 200;
        let step = (to - strain) / f64::from(steps);
        (0..steps).for_each(|_| strip.step(step, 0.0));
        strain = to;
        strip.stress()
    };
    // A strain increment is the change of squared lengths over the last one, off by a share of its own size, 1e-4.
    let close = |result: f64, exact: f64| assert!((result - exact).abs() < 2e-4 * YIELD, "{result} {exact}");
    close(go(&mut strip, 0.9 * first), 0.9 * YIELD);
    let top = YIELD + tangent * (0.02 - first);
    close(go(&mut strip, 0.02), top);
    close(go(&mut strip, 0.02 - top / YOUNG), 0.0);
    close(go(&mut strip, 0.02), top);
    // Down to yield on the other side, and a hundredth beyond.
    let other = 0.02 - 2.0 * top / YOUNG;
    close(go(&mut strip, other), -top);
    close(go(&mut strip, other - 0.01), -top - tangent * 0.01);
    // What became heat: the yield stress times the plastic strain.
    let energy = strip.energy();
    let share = 0.01 * YOUNG / (YOUNG + modulus);
    let before = (0.02 - first) * YOUNG / (YOUNG + modulus);
    let heat = YIELD * (before + share) + 0.5 * modulus * (before + share).powi(2);
    let volume = SIDE * SIDE * THICKNESS;
    // The area grows by half of the strain, 1%, on the way, while shells leave their thickness as it is.
    assert!((energy.plastic / (heat * volume) - 1.0).abs() < 0.01, "{energy:?} {}", heat * volume);
}

#[test]
fn bending_moment_of_a_strip_that_yields() {
    // Perfectly plastic: M = M_y (3/2 - (k_y/k)^2 / 2) beyond the curvature k_y of first yield (Lubliner, Plasticity
    // Theory, 1990, section 4.4).
    let (moment, curvature) = (YIELD * THICKNESS * THICKNESS / 6.0, 2.0 * YIELD / (YOUNG * THICKNESS));
    let errors = [(Rule::Gauss(5), 0.06), (Rule::Lobatto(5), 0.09), (Rule::Gauss(31), 2e-3)];
    for (rule, allowed) in errors {
        let material = ShellMaterial { points: Some(rule), ..incompressible(Hardening::perfect(YIELD)) };
        let mut strip = Strip::new(material);
        let steps = 100;
        for step in 1..=10 * steps {
            strip.step(0.0, curvature / f64::from(steps));
            let k = f64::from(step) / f64::from(steps);
            let exact = if k < 1.0 { k } else { 1.5 - 0.5 / (k * k) };
            let result = strip.now[1] / moment;
            // Linear until the first point yields, which lies below the surface in Gauss' rule.
            assert!(
                (result / exact - 1.0).abs() < if k < 1.0 { 1e-9 } else { allowed },
                "{rule:?} {k}: {result}"
            );
            // A sum over points is all there is to it.
            let points = rule.points();
            let sum: f64 = points.iter().map(|(z, w)| 1.5 * w * z * (z * k).clamp(-1.0, 1.0)).sum();
            assert!((result - sum).abs() < 1e-6, "{rule:?} {k}: {result} {sum}");
        }
        // Springback is elastic: the moment falls to nothing over the curvature M / (E I) of an elastic strip.
        let last = strip.now[1];
        for _ in 0..steps {
            strip.step(0.0, -last / moment * curvature / f64::from(steps));
        }
        assert!(strip.now[1].abs() < 1e-6 * last, "{rule:?}: {}", strip.now[1]);
        // All work is accounted for, to rounding.
        let (work, energy) = (strip.work, strip.energy());
        assert!((energy.total() / work - 1.0).abs() < 1e-9, "{energy:?} {work}");
        assert!(energy.plastic > 0.8 * work, "{energy:?}");
    }
}

#[test]
fn any_path_of_plane_strains_obeys_the_laws() {
    let mut random = Random(3);
    let table = [(0.0, YIELD), (0.01, 900e6), (0.05, 950e6)];
    let laws = [
        Hardening::perfect(YIELD),
        Hardening::linear(YIELD, 2e9).saturating(200e6, 15.0),
        Hardening::table(&table, "metal").expect("it is valid"),
    ];
    for hardening in laws {
        for poisson in [0.0, 0.34, 0.49] {
            let metal = PlaneStress::new(YOUNG, poisson, hardening);
            let mut at =
                PlaneState { stress: [0.0; 3], plastic_strain: 0.0, yield_stress: hardening.initial() };
            // Elastic energy by Hooke's law.
            let elastic = |s: &[f64; 3]| {
                let cross = s[0] * s[1] * poisson;
                (0.5 * (s[0] * s[0] + s[1] * s[1]) - cross + (1.0 + poisson) * s[2] * s[2]) / YOUNG
            };
            for size in [1e-4, 1e-3, 1e-2, 0.1].repeat(100) {
                let before = at;
                let increment = (random.vector() * size).array();
                let heat = metal.advance(&increment, &mut at);
                let [x, y, xy] = at.stress;
                let mises = (x * x - x * y + y * y + 3.0 * xy * xy).sqrt();
                let flow = at.plastic_strain - before.plastic_strain;
                // Newton's method ends at rounding.
                assert!(mises < at.yield_stress * (1.0 + 1e-9), "{mises} {}", at.yield_stress);
                assert!(flow >= 0.0 && heat >= 0.0, "{flow} {heat}");
                if flow > 0.0 {
                    assert!((mises / at.yield_stress - 1.0).abs() < 1e-9, "{mises} {}", at.yield_stress);
                    assert!((hardening.at(at.plastic_strain).0 / at.yield_stress - 1.0).abs() < 1e-12);
                }
                let mean: f64 = (0..3).map(|i| 0.5 * (before.stress[i] + at.stress[i]) * increment[i]).sum();
                let stored = elastic(&at.stress) - elastic(&before.stress);
                let scale = YIELD * size;
                assert!((stored + heat - mean).abs() < 1e-9 * scale, "{stored} + {heat} is not {mean}");
            }
            assert!(at.plastic_strain > 0.1);
        }
    }
}

/// A clamped square plate whose middle is struck at 100 m/s; positions after 200 us, energies at first and then.
fn struck(material: &ShellMaterial<f64>, steps: usize) -> (Vec<Row<f64>>, [f64; 2], f64) {
    let n = 10;
    let mesh = plate(n, 0.05, 2e-3, 0.0);
    let on_edge = |i: &usize| [i % (n + 1), i / (n + 1)].iter().any(|&k| k == 0 || k == n);
    let held = (0..mesh.nodes.len()).filter(on_edge).flat_map(|i| (0..6).map(move |f| (i, f)));
    let mut body = Body::new(&mesh, material, held, Loads::none());
    for (i, p) in mesh.nodes.iter().enumerate() {
        let (a, b) = (p.x / 0.05, p.y / 0.05);
        let shape = (16.0 * a * b * (1.0 - a) * (1.0 - b)).powi(2);
        body.structure.velocities[i] = Row::from_vec(Vec3::new(0.0, 0.0, 100.0 * shape));
    }
    let mut sums = [0.0; 2];
    let mut plastic = 0.0;
    for step in 0..=steps {
        let before = body.structure.velocities.clone();
        let measured = step == 0 || step == steps;
        body.step(0.0);
        if measured {
            // Elements are as of the positions before the step.
            let energy = body.structure.energy();
            sums[usize::from(step > 0)] = body.structure.kinetic_energy(&before) + energy.total();
            plastic = energy.plastic;
        }
    }
    (body.structure.positions, sums, plastic)
}

#[test]
fn energy_of_a_struck_plate_closes() {
    let (_, [first, last], plastic) = struck(&titanium().yielding(Hardening::linear(YIELD, 1e9)), 400);
    // Stresses turn with the elements, whose areas change by strains of 1%: as much of the elastic energy is not
    // accounted for.
    assert!((last / first - 1.0).abs() < 5e-3, "{first} J, then {last} J");
    assert!(plastic > 0.1 * first, "{plastic} J of {first} J");
}

#[test]
fn points_and_resultants_agree_in_elastic_metal() {
    let plain = struck(&titanium(), 100).0;
    for points in [Rule::Gauss(2), Rule::Gauss(5), Rule::Lobatto(3), Rule::Lobatto(5)] {
        let result = struck(&ShellMaterial { points: Some(points), ..titanium() }, 100).0;
        for (a, b) in plain.iter().zip(&result) {
            // Rounding, over displacements of millimetres.
            assert!((a.vec() - b.vec()).norm() < 1e-12, "{points:?}: {a:?} {b:?}");
        }
    }
}
