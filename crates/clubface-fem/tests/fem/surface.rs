//! The search for the point of a meshed face under a node of the ball.

use clubface_fem::contact::{Beyond, Normals, Projection, Surface};
use clubface_math::{Dual, Real, Row, Vec3};

/// Side of most elements, m.
const SIDE: f64 = 3e-3;

/// Numbers from -1 to 1 in no order.
struct Scatter(u64);

impl Scatter {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
    fn vector(&mut self, size: f64) -> Vec3<f64> {
        Vec3::new(self.next(), self.next(), self.next()) * size
    }
}

/// Nodes and quadrilaterals of a piece of a face, normals towards +x.
struct Mesh {
    name: &'static str,
    nodes: Vec<Vec3<f64>>,
    quads: Vec<[u32; 4]>,
    /// At the nodes: the sum of the area vectors round each, to unit length.
    normals: Vec<Vec3<f64>>,
}

/// A grid of squares that a shape bends and random numbers distort, by a share of their side.
fn grid(name: &'static str, shape: &dyn Fn(f64, f64) -> Vec3<f64>, distortion: f64) -> Mesh {
    const COUNT: usize = 6;
    let mut scatter = Scatter(7);
    let (mut nodes, mut quads) = (Vec::new(), Vec::new());
    let node = |i: usize, j: usize| (i * (COUNT + 1) + j) as u32;
    for i in 0..=COUNT {
        for j in 0..=COUNT {
            let [y, z] = [i, j].map(|n| SIDE * (n as f64 - 0.5 * COUNT as f64));
            let off = |c: f64, s: f64| c + if c == 0.0 { 0.0 } else { distortion * SIDE * s };
            nodes.push(shape(off(y, scatter.next()), off(z, scatter.next())));
            if i < COUNT && j < COUNT {
                // Seen from +x: y up, z to the left.
                quads.push([node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]);
            }
        }
    }
    Mesh::new(name, nodes, quads)
}

/// Some quadrilaterals round one corner, bent towards the middle by a cone.
fn fan(name: &'static str, count: usize, slope: f64) -> Mesh {
    let mut nodes = vec![Vec3::zero()];
    let mut quads = Vec::new();
    for k in 0..2 * count {
        let (s, c) = (std::f64::consts::PI * k as f64 / count as f64).sin_cos();
        let radius = SIDE * if k % 2 == 0 { 1.0 } else { 1.3 };
        nodes.push(Vec3::new(-slope * radius, c * radius, s * radius));
    }
    for k in 0..count {
        let at = |n: usize| (1 + n % (2 * count)) as u32;
        quads.push([0, at(2 * k), at(2 * k + 1), at(2 * k + 2)]);
    }
    Mesh::new(name, nodes, quads)
}

/// Triangles, each by itself, for quadrilaterals in turn along one diagonal and the other; every third stays whole.
fn triangulated(name: &'static str, mesh: &Mesh) -> Mesh {
    let mut faces = Vec::new();
    for (number, &[a, b, c, d]) in mesh.quads.iter().enumerate() {
        match number % 3 {
            0 => faces.extend([[a, b, c, c], [a, c, d, d]]),
            1 => faces.extend([[b, c, d, d], [b, d, a, a]]),
            _ => faces.push([a, b, c, d]),
        }
    }
    Mesh::new(name, mesh.nodes.clone(), faces)
}

/// Flat, curved as a driver's face, distorted, folded outwards and inwards by 60 degrees, and corners of three, five and
/// eight quadrilaterals; and some of them with triangles.
fn meshes() -> Vec<Mesh> {
    let flat = |y: f64, z: f64| Vec3::new(0.0, y, z);
    let bulged = |y: f64, z: f64| Vec3::new(-(y * y + z * z) / 0.6, y, z);
    let folded = |angle: f64| move |y: f64, z: f64| Vec3::new(-(angle.tan() * y.max(0.0)), y, z);
    vec![
        triangulated("flat, with triangles", &grid("flat", &flat, 0.0)),
        triangulated("bulged and distorted, with triangles", &grid("", &bulged, 0.3)),
        triangulated("folded outwards, with triangles", &grid("", &folded(1.0), 0.1)),
        grid("flat", &flat, 0.0),
        grid("distorted", &flat, 0.3),
        grid("bulged", &bulged, 0.0),
        grid("bulged and distorted", &bulged, 0.3),
        grid("folded outwards", &folded(1.0), 0.1),
        grid("folded inwards", &folded(-1.0), 0.1),
        fan("a corner of three", 3, 0.7),
        fan("a corner of five", 5, 0.1),
        fan("a corner of eight", 8, 0.0),
    ]
}

/// Weights of the corners of a face at a point of the square from -1 to 1; one of its sides is a corner of a triangle.
fn corner_weights(face: [u32; 4], [xi, eta]: [f64; 2]) -> [f64; 4] {
    if face[2] == face[3] {
        let [u, v] = [xi, eta].map(|c| 0.5 * (1.0 + c));
        return [1.0 - u, u * (1.0 - v), u * v, 0.0];
    }
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[s, t]| 0.25 * (1.0 + s * xi) * (1.0 + t * eta))
}

impl Mesh {
    fn new(name: &'static str, nodes: Vec<Vec3<f64>>, quads: Vec<[u32; 4]>) -> Self {
        let mut normals = vec![Vec3::zero(); nodes.len()];
        for quad in &quads {
            let [a, b, c, d] = quad.map(|n| nodes[n as usize]);
            let corners = if quad[2] == quad[3] { 3 } else { 4 };
            for &node in &quad[..corners] {
                normals[node as usize] += (c - a).cross(d - b);
            }
        }
        let normals = normals.into_iter().map(|n| n * (1.0 / n.norm())).collect();
        Self { name, nodes, quads, normals }
    }
    fn surface<R: Real>(&self, thickness: f64) -> (Surface<R>, Vec<Row<R>>) {
        let nodes = (0..self.nodes.len() as u32).collect();
        let thickness = vec![R::from_f64(thickness); self.quads.len()];
        let rows = self.nodes.iter().map(|p| Row::from_vec(Vec3::from_f64([p.x, p.y, p.z]))).collect();
        (Surface::new(self.quads.clone(), &thickness, nodes), rows)
    }
    /// Place and normal, not of unit length, at reference coordinates of a quadrilateral.
    fn at(&self, quad: usize, at: [f64; 2]) -> (Vec3<f64>, Vec3<f64>) {
        let (mut place, mut mean) = (Vec3::zero(), Vec3::zero());
        for (&node, weight) in self.quads[quad].iter().zip(corner_weights(self.quads[quad], at)) {
            place += self.nodes[node as usize] * weight;
            mean += self.normals[node as usize] * weight;
        }
        (place, mean)
    }
    /// Quadrilaterals and reference coordinates of their middles, of places on their edges and corners and a
    /// micrometre to either side of them, and of others.
    fn places(&self) -> Vec<(usize, [f64; 2])> {
        let mut scatter = Scatter(3);
        let near = 2.0 * 1e-6 / SIDE;
        let lines = [-1.0, -1.0 + near, 0.0, 1.0 - near, 1.0];
        let mut places = Vec::new();
        for quad in 0..self.quads.len() {
            for xi in lines {
                places.extend(lines.map(|eta| (quad, [xi, eta])));
            }
            for side in [-1.0, 1.0] {
                places.push((quad, [side, scatter.next()]));
                places.push((quad, [scatter.next(), side]));
            }
            places.push((quad, [scatter.next(), scatter.next()]));
        }
        places
    }
}

/// Place of the foot of a projection.
fn foot(mesh: &Mesh, projection: &Projection<f64>) -> Vec3<f64> {
    let corners = mesh.quads[projection.quad as usize].iter().zip(projection.weights);
    corners.fold(Vec3::zero(), |sum, (&node, weight)| sum + mesh.nodes[node as usize] * weight)
}

/// Neighbours agree: wherever a node of the ball stands over a face or has sunk into it, between its elements too, the
/// search arrives at the one point whose normal leads to it, from every element of the face.
#[test]
fn no_node_falls_between_elements() {
    for mesh in meshes() {
        let (surface, rows) = mesh.surface::<f64>(2e-3);
        let mut normals = Normals::new(mesh.nodes.len());
        normals.begin_step();
        for (quad, at) in mesh.places() {
            let (place, mean) = mesh.at(quad, at);
            let normal = mean * (1.0 / mean.norm());
            for gap in [-1e-4, 0.0, 1e-3] {
                // Half the thickness from the middle surface to the outer side.
                let point = place + normal * (gap + 1e-3);
                for start in (0..mesh.quads.len()).step_by(1 + mesh.quads.len() / 3) {
                    let result = surface.projection(&mut normals, &rows, point, start as u32, [0.0; 2]);
                    let lost = |beyond: Beyond| {
                        panic!("{}: {at:?} of {quad} is lost from {start}: {beyond:?}", mesh.name)
                    };
                    let result = result.unwrap_or_else(lost);
                    // 1e-12 of an element's side, and its slope.
                    let errors = [
                        result.gap - gap,
                        (result.normal - normal).norm() * SIDE,
                        (foot(&mesh, &result) - place).norm(),
                    ];
                    assert!(
                        errors.iter().all(|e| e.abs() < 2e-12 * SIDE),
                        "{}: {at:?} of {quad} at {gap} m from {start}: {errors:?} m",
                        mesh.name
                    );
                    assert!(result.weights.iter().all(|weight| *weight > -1e-8));
                }
            }
        }
    }
}

/// A search in all elements of a mesh, by steepest descent of the distance from the line along the normal, from many
/// starts: slow, and with nothing in common with the one under test.
fn exhaustive(mesh: &Mesh, point: Vec3<f64>) -> Vec<Vec3<f64>> {
    let miss = |quad: usize, at: [f64; 2]| {
        let (place, mean) = mesh.at(quad, at);
        (point - place).reject(mean * (1.0 / mean.norm())).norm()
    };
    let mut feet = Vec::new();
    for quad in 0..mesh.quads.len() {
        let (mut at, mut step) = ([0.0; 2], 0.5);
        // A pattern search that halves its step where no direction leads nearer.
        while step > 1e-11 {
            let here = miss(quad, at);
            let tries = [
                [1.0, 0.0],
                [-1.0, 0.0],
                [0.0, 1.0],
                [0.0, -1.0],
                [1.0, 1.0],
                [1.0, -1.0],
                [-1.0, 1.0],
                [-1.0, -1.0],
            ]
            .map(|[s, t]: [f64; 2]| {
                [(at[0] + s * step).clamp(-1.0, 1.0), (at[1] + t * step).clamp(-1.0, 1.0)]
            });
            match tries.into_iter().find(|other| miss(quad, *other) < here) {
                Some(other) => at = other,
                None => step *= 0.5,
            }
        }
        if miss(quad, at) < 1e-9 * SIDE {
            feet.push(mesh.at(quad, at).0);
        }
    }
    feet
}

#[test]
fn the_search_agrees_with_one_through_all_elements() {
    for mesh in meshes() {
        let (surface, rows) = mesh.surface::<f64>(0.0);
        let mut scatter = Scatter(11);
        let mut compared = 0;
        for _ in 0..12 {
            let (quad, at) =
                (scatter.next().abs() * mesh.quads.len() as f64, [scatter.next(), scatter.next()]);
            let point = mesh.at(quad as usize, at).0 + scatter.vector(0.3 * SIDE);
            let start = surface.closest(&rows, point);
            let all = exhaustive(&mesh, point);
            match surface.projection_from(&rows, point, start) {
                Some(result) => {
                    let foot = foot(&mesh, &result);
                    assert!(
                        all.iter().any(|other| (*other - foot).norm() < 1e-6 * SIDE),
                        "{}: {all:?}",
                        mesh.name
                    );
                    compared += 1;
                }
                None => assert!(all.is_empty(), "{}: {point:?} stands over {all:?}", mesh.name),
            }
        }
        assert!(compared > 3, "{}: {compared} compared", mesh.name);
    }
}

#[test]
fn distance_and_normal_are_continuous_across_lines_and_corners() {
    for mesh in meshes() {
        let (surface, rows) = mesh.surface::<f64>(2e-3);
        let mut normals = Normals::new(mesh.nodes.len());
        normals.begin_step();
        // Through the middle node and along lines of the mesh, a step in each direction.
        for direction in [Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, 0.6, 0.8)] {
            let step = 1e-9;
            let mut last: Option<Projection<f64>> = None;
            for i in -20..=20 {
                let point = Vec3::new(5e-4, 0.0, 0.0) + direction * (step * f64::from(i));
                let start = last.map_or(0, |p| p.quad);
                let next = surface.projection(&mut normals, &rows, point, start, [0.0; 2]).expect(mesh.name);
                if let Some(last) = last {
                    let jump = (next.gap - last.gap).abs().max((next.normal - last.normal).norm() * SIDE);
                    // No steeper than 3 mm a side in 2 mm of height.
                    assert!(jump < 4.0 * step, "{}: jumps by {jump} m", mesh.name);
                }
                last = Some(next);
            }
        }
    }
}

#[test]
fn a_mirrored_face_has_mirrored_contacts() {
    let mirror = |v: Vec3<f64>| Vec3::new(v.x, v.y, -v.z);
    for mesh in meshes() {
        let nodes = mesh.nodes.iter().map(|p| mirror(*p)).collect();
        let turned = |&[a, b, c, d]: &[u32; 4]| if c == d { [a, c, b, b] } else { [a, d, c, b] };
        let other = Mesh::new(mesh.name, nodes, mesh.quads.iter().map(turned).collect());
        let [(one, rows), (two, others)] = [mesh.surface::<f64>(2e-3), other.surface::<f64>(2e-3)];
        for (quad, at) in mesh.places() {
            let (place, mean) = mesh.at(quad, at);
            let point = place + mean * 5e-4;
            let first = one.projection_from(&rows, point, 0).expect(mesh.name);
            let second =
                two.projection_from(&others, mirror(point), mesh.quads.len() as u32 - 1).expect(mesh.name);
            assert!((first.gap - second.gap).abs() < 2e-12 * SIDE, "{}", mesh.name);
            assert!((first.normal - mirror(second.normal)).norm() < 1e-11, "{}", mesh.name);
        }
    }
}

#[test]
fn a_node_beside_a_face_is_as_far_from_it_as_its_edge() {
    let mesh = grid("flat", &|y, z| Vec3::new(0.0, y, z), 0.0);
    let (surface, rows) = mesh.surface::<f64>(0.0);
    let mut normals = Normals::new(mesh.nodes.len());
    normals.begin_step();
    let edge = 3.0 * SIDE;
    for (point, expected) in [
        (Vec3::new(0.0, edge + 1e-6, 0.0), 1e-6),
        (Vec3::new(0.003, edge + 0.004, 0.2 * SIDE), 0.005),
        (Vec3::new(0.0, edge + 0.03, -edge - 0.04), 0.05),
        (Vec3::new(-0.012, 0.0, -edge - 0.009), 0.015),
    ] {
        for start in 0..mesh.quads.len() as u32 {
            let beyond = surface.projection(&mut normals, &rows, point, start, [0.0; 2]);
            let beyond = beyond.expect_err("beyond the edge");
            assert!((beyond.distance - expected).abs() < 1e-12, "{point:?} from {start}: {beyond:?}");
        }
    }
    // A micrometre inside.
    let point = Vec3::new(1e-3, edge - 1e-6, edge - 1e-6);
    assert!(surface.projection(&mut normals, &rows, point, 0, [0.0; 2]).is_ok());
}

/// An outline with a corner that points inwards: the face of an iron where it meets the hosel.
#[test]
fn a_search_goes_round_a_corner_of_the_outline() {
    let mut mesh = grid("L", &|y, z| Vec3::new(0.0, y, z), 0.2);
    let quads = std::mem::take(&mut mesh.quads);
    let kept = |quad: &[u32; 4]| {
        let middle = quad.iter().fold(Vec3::zero(), |sum, n| sum + mesh.nodes[*n as usize]) * 0.25;
        middle.y < 0.0 || middle.z < 0.0
    };
    let mesh = Mesh::new("L", mesh.nodes.clone(), quads.into_iter().filter(kept).collect());
    let (surface, rows) = mesh.surface::<f64>(0.0);
    for (quad, at) in mesh.places() {
        let point = mesh.at(quad, at).0 + Vec3::new(2e-4, 0.0, 0.0);
        let neighbours: Vec<usize> = (0..mesh.quads.len())
            .filter(|other| mesh.quads[*other].iter().any(|n| mesh.quads[quad].contains(n)))
            .collect();
        for start in neighbours {
            let result = surface.projection_from(&rows, point, start as u32);
            assert!(result.is_some(), "{at:?} of {quad} is lost from {start}");
        }
    }
}

/// Derivatives by the place of a node are those of the distance, on lines of the mesh as elsewhere.
#[test]
fn derivatives_of_the_distance_are_exact() {
    type D = Dual<f64, 4>;
    let mesh = grid("bulged and distorted", &|y, z| Vec3::new(-(y * y + z * z) / 0.3, y, z), 0.3);
    let (dual, dual_rows) = mesh.surface::<D>(2e-3);
    let (plain, rows) = mesh.surface::<f64>(2e-3);
    let gap = |point: Vec3<f64>, quad| plain.projection_from(&rows, point, quad).expect("over the face").gap;
    for (quad, at) in mesh.places().into_iter().step_by(7) {
        // The derivative jumps where the curvature does: on a line it is that of either side.
        let inside = at.map(|c| c.clamp(-0.999, 0.999));
        let (place, mean) = mesh.at(quad, inside);
        let point = place + mean * 9e-4;
        let variables = Vec3::new(D::variable(point.x, 0), D::variable(point.y, 1), D::variable(point.z, 2));
        let result = dual.projection_from(&dual_rows, variables, quad as u32).expect("over the face").gap;
        assert_eq!(result.value.to_bits(), gap(point, quad as u32).to_bits(), "the same without derivatives");
        for (k, step) in [Vec3::new(1e-7, 0.0, 0.0), Vec3::new(0.0, 1e-7, 0.0), Vec3::new(0.0, 0.0, 1e-7)]
            .into_iter()
            .enumerate()
        {
            let difference = (gap(point + step, quad as u32) - gap(point - step, quad as u32)) / 2e-7;
            // Rounding of 1e-17 m over the step.
            assert!(
                (result.tangent[k] - difference).abs() < 1e-8,
                "{at:?} of {quad}: {} {difference}",
                result.tangent[k]
            );
        }
    }
}
