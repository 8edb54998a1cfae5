//! What a single one-point element resists with in the patterns that its point does not see: the bending of a block.

use crate::support::{block, elastic, forces, patches, rows};
use clubface_fem::element::Element;
use clubface_math::Vec3;

const YOUNG: f64 = 30e6;
const POISSON: f64 = 0.49;
const SHEAR: f64 = YOUNG / (2.0 * (1.0 + POISSON));
/// Amplitude over an edge; energies are quadratic to its square.
const SMALL: f64 = 1e-5;

/// Twice the energy of a block of edges `l` (m) displaced by one metre times a product of reference coordinates (whose
/// axes are `pattern`) along `axis`, J/m2: by the energy of the patterns, and by the work of the forces.
fn stiffness(l: [f64; 3], pattern: &[usize], axis: usize) -> [f64; 2] {
    let mesh = block([1; 3], l);
    let mut patches = patches(Element::OnePoint, &mesh, &elastic(YOUNG, POISSON, 1000.0));
    let amplitude = SMALL * l[axis];
    let displacements: Vec<Vec3<f64>> = mesh
        .nodes
        .iter()
        .map(|x| {
            let shape: f64 = pattern.iter().map(|&i| 2.0 * x.array()[i] / l[i] - 1.0).product();
            let mut moved = [0.0; 3];
            moved[axis] = amplitude * shape;
            Vec3::from_f64(moved)
        })
        .collect();
    let moved: Vec<_> = mesh.nodes.iter().zip(&displacements).map(|(x, u)| *x + *u).collect();
    let sum = forces(&mut patches, &rows(&moved), 0.0);
    let work: f64 = sum.iter().zip(&displacements).map(|(f, u)| -f.dot(*u)).sum();
    let stored: f64 = patches.iter_mut().map(|patch| patch.energy(&rows(&moved)).hourglass).sum();
    [2.0 * stored, work].map(|energy| energy / (amplitude * amplitude))
}

#[test]
fn a_bent_element_has_the_mean_period_of_a_block_that_bends_and_shears() {
    // A pattern across the edges a and b. Along a it bends the block, which is incompressible and free of shear, in
    // plane strain: the modulus E / (1 - nu^2) is 4 mu, the strain 4 c y / (a b), and twice the energy
    // 4 mu (4 c / (a b))^2 V b^2 / 12 = 16/3 mu V c^2 / a^2. Along the third edge it is sheared both ways:
    // 4/3 mu V c^2 (1/a^2 + 1/b^2). The element has one stiffness for all three, of which the period is the mean.
    for l in [[0.01, 0.01, 0.01], [0.01, 0.013, 0.007]] {
        let volume: f64 = l.iter().product();
        for third in 0..3 {
            let (a, b) = ((third + 1) % 3, (third + 2) % 3);
            let bends = |edge: f64| 16.0 / 3.0 * SHEAR * volume / (edge * edge);
            let shears = 4.0 / 3.0 * SHEAR * volume * (l[a].powi(-2) + l[b].powi(-2));
            let period =
                [bends(l[a]), bends(l[b]), shears].map(|k| k.sqrt().recip()).iter().sum::<f64>() / 3.0;
            for axis in 0..3 {
                for result in stiffness(l, &[a, b], axis) {
                    // The square of the amplitude relative to the work of 1e-10 J.
                    let error = result * period * period - 1.0;
                    assert!(error.abs() < 1e-4, "{l:?} {third} {axis}: {error}");
                }
            }
        }
    }
}

#[test]
fn a_twisted_element_resists_by_the_square_of_its_gradient() {
    // u = c xi eta zeta along any axis of a cube of edge l: the mean square of each of three slopes is (2 c / l)^2 / 9,
    // and mu times their sum over the volume 4/3 mu V c^2 / l^2.
    let l = 0.01;
    for axis in 0..3 {
        for result in stiffness([l; 3], &[0, 1, 2], axis) {
            let error = result / (4.0 / 3.0 * SHEAR * l) - 1.0;
            assert!(error.abs() < 1e-4, "{axis}: {error}");
        }
    }
}
