use clubface_fem::contact::{Contact, Plane, RigidContact};
use clubface_fem::element::{Patch, SolidPatch, PATCH};
use clubface_fem::material::{Hencky, Material, MooneyRivlin, Shape};
use clubface_fem::mesh::{cubed_sphere, Fineness};
use clubface_fem::solve::Structure;
use clubface_math::Row;

fn main() {
    let args: Vec<f64> = std::env::args().skip(1).map(|a| a.parse().unwrap()).collect();
    let refine = args.first().copied().unwrap_or(1.0) as usize;
    let safety = args.get(1).copied().unwrap_or(0.8);
    let mesh = cubed_sphere(&[0.0196, 0.0214], &Fineness { cube: 12 * refine, layers: vec![6 * refine, 3 * refine] });
    let core_n = mesh.layer.iter().filter(|l| **l == 0).count();
    let v: Vec<f64> = (0..mesh.elements.len()).map(|e| mesh.volume(e)).collect();
    let vc: f64 = v[..core_n].iter().sum();
    let vo: f64 = v[core_n..].iter().sum();
    let rho_core = (0.046 - 950.0 * vo) / vc;
    println!("min volume {:.3e}", v.iter().fold(f64::MAX, |a, b| a.min(*b)));
    println!("elements {} nodes {} core density {rho_core}", mesh.elements.len(), mesh.nodes.len());
    let k = |mu: f64, nu: f64| 2.0 * mu * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
    let core = Material { shape: Shape::MooneyRivlin(MooneyRivlin { c10: 4e6, c01: 1e6 }), bulk: k(10e6, 0.49), maxwell: vec![], density: rho_core };
    let mu = 350e6 / 2.0 / 1.4;
    let cover = Material { shape: Shape::Hencky(Hencky { shear: mu }), bulk: k(mu, 0.4), maxwell: vec![], density: 950.0 };
    let mut masses = vec![0.0; mesh.nodes.len()];
    for (e, el) in mesh.elements.iter().enumerate() {
        let rho = if e < core_n { rho_core } else { 950.0 };
        for n in el {
            masses[*n as usize] += v[e] * rho / 8.0;
        }
    }
    let mut patches: Vec<Box<dyn Patch<f64>>> = vec![];
    let mut s = 0;
    while s < mesh.elements.len() {
        let end = if s < core_n { core_n } else { mesh.elements.len() };
        let e = (s + PATCH).min(end);
        patches.push(Box::new(SolidPatch::new(&mesh, s..e, if s < core_n { core.clone() } else { cover.clone() })));
        s = e;
    }
    let mut areas = vec![0.0; mesh.nodes.len()];
    let mut surf: Vec<u32> = vec![];
    for q in mesh.surface() {
        let p = q.map(|n| mesh.nodes[n as usize]);
        let a = (p[2] - p[0]).cross(p[3] - p[1]).norm() * 0.5;
        for n in q {
            areas[n as usize] += a / 4.0;
            surf.push(n);
        }
    }
    surf.sort_unstable();
    surf.dedup();
    let r = 0.0214;
    let x: Vec<Row<f64>> = mesh.nodes.iter().map(|p| Row([p.x + r, p.y, p.z, 0.0])).collect();
    let mut contact = RigidContact::new(Plane, 0.35, surf.clone(), &masses, &areas);
    let mut st = Structure::new(x, masses, patches, &surf);
    let (v0, a) = (35.0, 11.5_f64.to_radians());
    let t0 = std::time::Instant::now();
    let stable = st.stable_step(60);
    if stable < 1e-8 {
        println!("{stable:e}");
        st.step(&mut contact, 0.0);
        return;
    }
    println!("stable {:.4} us in {:?}", stable * 1e6, t0.elapsed());
    for v in &mut st.velocities {
        *v = Row([-v0 * a.cos(), v0 * a.sin(), 0.0, 0.0]);
    }
    let dt = stable * safety;
    let steps = (1e-3 / dt).ceil() as usize;
    let n = st.positions.len();
    let e0 = st.kinetic_energy();
    let t0 = std::time::Instant::now();
    let (mut peak, mut tp, mut tc, mut tmax, mut tmin, mut rev, mut smax) = (0.0, 0.0, 0.0, 0.0_f64, 0.0_f64, 0.0, 0.0_f64);
    let mut last = 0.0;
    for i in 0..steps {
        st.step(&mut contact, dt);
        let res = contact.resultant();
        let t = i as f64 * dt * 1e6;
        if res.normal > peak {
            peak = res.normal;
            tp = t;
        }
        if res.normal > 0.0 {
            tc = t;
        }
        let ft = -res.force.y;
        if last > 0.0 && ft <= 0.0 && t > 100.0 && rev == 0.0 {
            rev = t;
        }
        last = ft;
        tmax = tmax.max(ft);
        tmin = tmin.min(ft);
        if i % 20 == 0 {
            let kin = st.kinetics(0..n);
            smax = smax.max(-kin.spin.z * 60.0 / 6.283185307);
            if i % 200 == 0 && args.len() > 2 {
                let e = st.energy();
                let c = contact.energy();
                println!("{t:.1} {:.3} {:?} {:?}", (st.kinetic_energy() + e.total() + c.stored + c.friction) / e0, e, c);
            }
        }
    }
    let wall = t0.elapsed().as_secs_f64();
    let kin = st.kinetics(0..n);
    println!("normal {:.3} tang {:.3} spin {:.1} (max {smax:.0}) peak {peak:.0} at {tp:.1} contact {tc:.1} ft {tmax:.0}/{tmin:.0} rev {rev:.1}", kin.velocity.x, kin.velocity.y, -kin.spin.z * 60.0 / 6.283185307);
    println!("steps {steps} wall {wall:.3} s, {:.1} ns/element/step", wall * 1e9 / steps as f64 / mesh.elements.len() as f64);
}
