//! Cost of the kernels of solid elements, by element and law, in nanoseconds per element, next to a sum of what they
//! computed.
//!
//! `cargo bench -p clubface-benches --bench kernels`: the least time of many, on one thread.

#![allow(missing_docs)]

use clubface_benches::least_time;
use clubface_fem::element::{Element, Patch};
use clubface_fem::material::{
    Energy, Hardening, Hencky, Material, Maxwell, MooneyRivlin, OwnFunction, VonMises, law_from_name,
};
use clubface_fem::mesh::{Fineness, SolidMesh, cubed_sphere};
use clubface_math::Row;
use std::sync::Arc;

/// Times that something is done.
const TIMES: usize = 200;

/// The least time of something over all elements, ns each.
fn least(elements: usize, work: impl FnMut()) -> f64 {
    least_time(TIMES, work) * 1e9 / elements as f64
}

/// Mooney-Rivlin as one would write it in C.
unsafe extern "C" fn rivlin(
    count: usize,
    shapes: *const f64,
    constants: *const f64,
    _: f64,
    _: *mut f64,
    results: *mut f64,
) {
    // SAFETY: rows of as many numbers, as the caller has them.
    let (shapes, constants, results) = unsafe {
        (
            std::slice::from_raw_parts(shapes, 6 * count),
            std::slice::from_raw_parts(constants, 2),
            std::slice::from_raw_parts_mut(results, 8 * count),
        )
    };
    let (c10, c01) = (constants[0], constants[1]);
    for i in 0..count {
        let c: [f64; 6] = std::array::from_fn(|row| shapes[row * count + i]);
        let first = c[0] + c[1] + c[2];
        let square =
            c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + 2.0 * (c[3] * c[3] + c[4] * c[4] + c[5] * c[5]);
        for row in 0..6 {
            let one = if row < 3 { 2.0 * (c10 + c01 * first) } else { 0.0 };
            results[row * count + i] = one - 2.0 * c01 * c[row];
        }
        results[6 * count + i] = c10 * (first - 3.0) + c01 * (0.5 * (first * first - square) - 3.0);
    }
}

fn main() {
    let mesh: SolidMesh = cubed_sphere(&[0.02], &Fineness { cube: 8, layers: vec![6] });
    // Elements whose neighbours stand apart make no lattice.
    let mut mixed = mesh.clone();
    let count = mesh.elements.len();
    for (place, element) in mixed.elements.iter_mut().enumerate() {
        *element = mesh.elements[place * 211 % count];
    }
    let bend = |p: &clubface_math::Vec3<f64>| {
        let stretch = 1.0 + 0.03 * (300.0 * p.y).sin();
        Row([p.x * stretch, p.y + 0.05 * p.z, p.z * (1.0 + 3.0 * p.x), 0.0])
    };
    let positions: Vec<Row<f64>> = mesh.nodes.iter().map(bend).collect();
    let still = vec![Row::zero(); positions.len()];
    let rubber = MooneyRivlin { c10: 4e6, c01: 1e6 }.law();
    let ogden = law_from_name("ogden", &[4e6, 3.5, -3e6, -2.0]).expect("the constants are allowed");
    let metal = VonMises { shear: 1e7, hardening: Hardening::linear(2e5, 1e6) }.law();
    let with_law = |law| Material { law, bulk: 5e8, maxwell: vec![], density: 1150.0 };
    let energy = |text: &str, constants: &[f64]| {
        let energy = Arc::new(Energy::new(text).expect("an energy"));
        with_law(energy.law(constants).expect("its constants"))
    };
    let written = energy("c10*(I1-3) + c01*(I2-3)", &[4e6, 1e6]);
    let yeoh = energy("c10*(I1-3) + c20*(I1-3)^2 + c30*(I1-3)^3", &[5e6, 1e5, 1e4]);
    let gent = energy("-mu/2*limit*log(1 - (I1-3)/limit)", &[1e7, 20.0]);
    let demiray = energy("mu/(2*b)*(exp(b*(I1-3)) - 1)", &[1e7, 0.3]);
    // SAFETY: it does what such a function does.
    let function = unsafe { OwnFunction::new("rivlin", vec!["c10".into(), "c01".into()], 0, rivlin) };
    let function = Arc::new(function.expect("two constants"));
    let compiled = function.law(&[4e6, 1e6]).expect("both constants");
    let branch = Maxwell { modulus: 0.3, time: 1e-4 };
    let materials = [
        ("Mooney-Rivlin", with_law(rubber.clone())),
        ("Hencky", with_law(Hencky { shear: 1e7 }.law())),
        ("Mooney-Rivlin, one branch", Material { maxwell: vec![branch], ..with_law(rubber.clone()) }),
        ("Mooney-Rivlin, two branches", Material { maxwell: vec![branch; 2], ..with_law(rubber) }),
        ("Ogden", with_law(ogden)),
        ("von Mises", with_law(metal)),
        ("Mooney-Rivlin as an energy", written.clone()),
        ("Mooney-Rivlin as an energy, one branch", Material { maxwell: vec![branch], ..written }),
        ("Yeoh as an energy", yeoh),
        ("Gent as an energy", gent),
        ("Demiray as an energy", demiray),
        ("Mooney-Rivlin as a function of C", with_law(compiled)),
    ];
    for (name, material) in &materials {
        for (arrangement, element, mesh) in [
            ("lattice", Element::OnePoint, &mesh),
            ("any order", Element::OnePoint, &mixed),
            ("eight points", Element::FullyIntegrated, &mesh),
        ] {
            let mut patches: Vec<Box<dyn Patch<f64>>> = element.patches(mesh, 0..count, material);
            let forces = least(count, || {
                patches.iter_mut().for_each(|patch| patch.assemble(&positions, &still, 1e-6));
            });
            let sum: f64 =
                patches.iter().flat_map(|p| p.forces()).flat_map(|f| &f.0[..3]).map(|f| f.abs()).sum();
            let mut energy = 0.0;
            let energies = least(count, || {
                energy = patches.iter_mut().map(|patch| patch.energy(&positions).total()).sum();
            });
            println!(
                "{name}, {arrangement}: {forces:.1} ns, energies {energies:.1} ns; {sum:.17e} N, {energy:.17e} J"
            );
        }
    }
}
