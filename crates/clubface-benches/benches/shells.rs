//! Cost of a head of shells (that of Roh and Lee, struck on its face), in nanoseconds per element and step, next to the
//! energies it computes.
//!
//! `cargo bench -p clubface-benches --bench shells`: the least time of a step, nodes included, which is what the machine
//! does when nobody else uses it.

#![allow(missing_docs)]

use clubface_benches::{least_time, thread_pool};
use clubface_fem::contact::Contact;
use clubface_fem::element::{Patch, Rule, ShellMaterial};
use clubface_fem::environment::Environment;
use clubface_fem::head::{DeformableHead, Driver, ShellHead};
use clubface_fem::material::Hardening;
use clubface_fem::solve::Structure;
use clubface_math::{Row, Vec3};

/// Speed at which the middle of the face is struck, m/s.
const SPEED: f64 = 30.0;
const STEPS: usize = 1500;
/// Steps at a time.
const MARCH: usize = 10;

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
    fn nearest(&self, _: &[Row<f64>], _: Vec3<f64>) -> (f64, Vec3<f64>) {
        (0.0, Vec3::zero())
    }
}

/// Roh and Lee's head of a metal, its face moving inwards, fastest in its middle.
fn struck(
    head: &ShellHead<f64>,
    metal: &dyn Fn(&ShellMaterial<f64>) -> ShellMaterial<f64>,
) -> Structure<f64> {
    let mut head = head.clone();
    for part in &mut head.parts {
        part.material = metal(&part.material);
    }
    let masses = head.masses();
    let count = head.nodes().len();
    let patches: Vec<Box<dyn Patch<f64>>> =
        head.patches(head.nodes(), 0).into_iter().map(|(_, patch)| patch).collect();
    let mut rows: Vec<_> = head.nodes().iter().map(|p| Row::from_vec(*p)).collect();
    rows.resize(2 * count, Row::zero());
    let all = masses.translation.into_iter().chain(masses.rotation).collect();
    let mut structure = Structure::new(rows, all, patches, &[], &Environment::native());
    structure.translations = count;
    let axis = Vec3::new(head.loft.cos(), head.loft.sin(), 0.0);
    for (v, p) in structure.velocities.iter_mut().zip(head.nodes()) {
        let in_plane = *p - axis * p.dot(axis);
        let near = p.dot(axis) > -0.01;
        let share = (1.0 - in_plane.norm_squared() / 0.02_f64.powi(2)).max(0.0);
        *v = Row::from_vec(axis * if near { -SPEED * share } else { 0.0 });
    }
    structure
}

fn main() {
    let head = Driver::roh_and_lee().mesh().expect("Roh and Lee's head").head;
    let yields = |gain: f64| {
        move |m: &ShellMaterial<f64>| m.clone().yielding(Hardening::linear(0.8e9, 1e9).saturating(gain, 20.0))
    };
    type Metal<'a> = &'a dyn Fn(&ShellMaterial<f64>) -> ShellMaterial<f64>;
    let metals: [(&str, Metal); 4] = [
        ("elastic, resultants", &|m| m.clone()),
        ("elastic, five points", &|m| ShellMaterial { points: Some(Rule::Gauss(5)), ..m.clone() }),
        ("yields, five points", &|m| m.clone().yielding(Hardening::linear(0.8e9, 1e9))),
        ("saturates, five points", &yields(1e8)),
    ];
    for threads in [1, 2] {
        let pool = thread_pool(threads);
        for (name, metal) in metals {
            let mut structure = struck(&head, metal);
            let step = 0.9 * structure.stable_step(40);
            let least = pool.install(|| {
                least_time(STEPS / MARCH, || {
                    structure.integrate(&mut Free, step, MARCH, &mut |_, _| true);
                })
            });
            let each = least * 1e9 / (MARCH * head.shells.quads.len()) as f64;
            let energy = structure.energy();
            println!(
                "{name}, {threads} threads: {each:.1} ns per element and step; after {:.0} us {:.4} J elastic, {:.4} J plastic, {:.4} J in stabilised modes",
                STEPS as f64 * step * 1e6,
                energy.strain,
                energy.plastic,
                energy.hourglass,
            );
        }
    }
}
