//! Natural frequencies of a free elastic sphere (Lamb, Proc. London Math. Soc. 13, 1882).

use crate::support::{ELEMENTS, elastic, period, root, structure};
use clubface_fem::element::Element;
use clubface_fem::mesh::{Fineness, cubed_sphere};
use clubface_math::Vec3;

const RADIUS: f64 = 0.02;
const DENSITY: f64 = 1000.0;
const YOUNG: f64 = 30e6;

/// Spherical Bessel functions j_1 and j_2, and the derivative of j_2; x not below 0.
fn bessel(x: f64) -> [f64; 3] {
    if x < 0.1 {
        // Series: the closed forms cancel here. The first term left out is below 1e-9.
        let z = x * x;
        return [
            x / 3.0 * (1.0 - z / 10.0 + z * z / 280.0),
            z / 15.0 * (1.0 - z / 14.0 + z * z / 504.0),
            2.0 * x / 15.0 * (1.0 - z / 7.0 + z * z / 168.0),
        ];
    }
    let (s, c) = x.sin_cos();
    let first = s / (x * x) - c / x;
    let second = (3.0 / (x * x * x) - 1.0 / x) * s - 3.0 * c / (x * x);
    [first, second, first - 3.0 / x * second]
}

/// Squares of the speeds of pressure and shear waves, m2/s2.
fn speeds(poisson: f64) -> (f64, f64) {
    let material = elastic(YOUNG, poisson, DENSITY);
    let shear = material.shear();
    ((material.bulk + 4.0 / 3.0 * shear) / DENSITY, shear / DENSITY)
}

/// Elements to look at: the fully integrated one where material is nearly incompressible, since it takes its time.
fn at(poisson: f64) -> &'static [Element] {
    if poisson > 0.44 { &ELEMENTS } else { &ELEMENTS[..1] }
}

/// Period in the mesh and in theory, s, of a mode with circular frequency `w` and velocities `mode`.
fn compare(
    element: Element,
    cube: usize,
    poisson: f64,
    w: f64,
    mode: impl Fn(Vec3<f64>) -> Vec3<f64>,
) -> f64 {
    let mesh = cubed_sphere(&[RADIUS], &Fineness { cube, layers: vec![cube / 2] });
    let mut ball = structure(element, &mesh, &elastic(YOUNG, poisson, DENSITY), &[]);
    let velocities: Vec<_> = mesh.nodes.iter().map(|x| mode(*x)).collect();
    let size = crate::support::largest(&velocities);
    // A thousandth of the speed of sound at most: strains stay small.
    let velocities: Vec<_> = velocities.iter().map(|v| *v * (0.1 / size)).collect();
    let expected = std::f64::consts::TAU / w;
    period(&mut ball, &velocities, expected) / expected - 1.0
}

/// Periods converge with the square of the element size (0.36 from 6 to 10 elements), to 1% and better.
fn converges(elements: &[Element], name: &str, poisson: f64, w: f64, mode: impl Fn(Vec3<f64>) -> Vec3<f64>) {
    for &element in elements {
        let [coarse, fine] = [6, 10].map(|cube| compare(element, cube, poisson, w, &mode));
        let converges = fine.abs() < 0.01 && fine.abs() < (0.5 * coarse.abs()).max(1e-3);
        assert!(converges, "{name}, nu {poisson}: {coarse} {fine}");
    }
}

#[test]
fn twisting_mode() {
    // Toroidal, two halves turning against each other: free of stress where (l - 1) j_l(ka) = ka j_(l+1)(ka), l = 2.
    let free = |x: f64| x * bessel(x)[2] - bessel(x)[1];
    let ka = root(free, 2.0, 3.0);
    assert!((ka - 2.501).abs() < 1e-3, "Lamb's value: {ka}");
    let k = ka / RADIUS;
    for poisson in [0.3, 0.49] {
        converges(at(poisson), "toroidal", poisson, k * speeds(poisson).1.sqrt(), |x| {
            let r = x.norm().max(1e-9);
            Vec3::new(-x.y, x.x, 0.0) * (x.z * bessel(k * r)[1] / (r * r))
        });
    }
}

/// Displacement along the radius and along it across, and their derivatives by r, of a pressure or a shear wave of
/// order 2.
fn waves(k: f64, r: f64) -> [[f64; 4]; 2] {
    let x = k * r;
    let [_, j, slope] = bessel(x);
    let curve = -2.0 / x * slope - (1.0 - 6.0 / (x * x)) * j;
    let (d, dd) = (k * slope, k * k * curve);
    let ratio = d / r - j / (r * r);
    [[d, j / r, dd, ratio], [6.0 * j / r, j / r + d, 6.0 * ratio, ratio + dd]]
}

#[test]
fn oblate_prolate_mode() {
    // Spheroidal of order 2: no pressure and no shear on the surface.
    for poisson in [0.25, 0.4, 0.49] {
        let (pressure, shear) = speeds(poisson);
        let both = |w: f64, r: f64| (waves(w / pressure.sqrt(), r)[0], waves(w / shear.sqrt(), r)[1]);
        let lambda = pressure - 2.0 * shear;
        let surface = |w: f64| {
            let (p, s) = both(w, RADIUS);
            let h = w / pressure.sqrt();
            let normal = [-lambda * h * h * bessel(h * RADIUS)[1] + 2.0 * shear * p[2], 2.0 * shear * s[2]];
            let along = [p, s].map(|u| u[3] + (u[0] - u[1]) / RADIUS);
            (normal, along)
        };
        let determinant = |w: f64| {
            let (n, a) = surface(w);
            n[0] * a[1] - n[1] * a[0]
        };
        let unit = shear.sqrt() / RADIUS;
        let w = root(determinant, 2.3 * unit, 3.0 * unit);
        if poisson == 0.25 {
            assert!((w / unit - 2.640).abs() < 1e-3, "Lamb's value: {}", w / unit);
        }
        let (n, _) = surface(w);
        let share = -n[0] / n[1];
        converges(at(poisson), "spheroidal", poisson, w, |x| {
            let r = x.norm().max(1e-6);
            let (p, s) = both(w, r);
            let radial = x * (1.0 / r);
            let c = radial.z;
            let across = Vec3::new(0.0, 0.0, 1.0) + radial * -c;
            radial * ((p[0] + share * s[0]) * (1.5 * c * c - 0.5))
                + across * ((p[1] + share * s[1]) * 3.0 * c)
        });
    }
}

#[test]
fn breathing_mode() {
    // Radial: (lambda + 2 mu) u' + 2 lambda u / r = 0 on the surface for u = j_1.
    for poisson in [0.3, 0.45] {
        let (pressure, shear) = speeds(poisson);
        let lambda = pressure - 2.0 * shear;
        let free = |x: f64| {
            let [j, second, _] = bessel(x);
            pressure * (j - x * second) + 2.0 * lambda * j
        };
        let h = root(free, 1.5, 3.1) / RADIUS;
        converges(at(poisson), "breathing", poisson, h * pressure.sqrt(), |x| {
            x * (bessel(h * x.norm())[0] / x.norm().max(1e-9))
        });
    }
}
