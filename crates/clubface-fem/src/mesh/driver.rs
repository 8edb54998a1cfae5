//! A hollow driver head of quadrilaterals: a closed surface, part of it the face with bulge, roll and loft.
//!
//! Axes as those of the ball at first touch: x towards the target, y up, z to the toe; the origin is the face centre, on the outside. The
//! mesh is that of a box, wrapped round the body and smoothed, so it has no triangles, no seams, and no corner that lies in one plane with
//! its neighbours.

use super::{convexity, ShellMesh};
use clubface_math::{Real, Vec3};

/// Part of a head.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Region {
    /// Struck side.
    Face,
    /// Top.
    Crown,
    /// Bottom.
    Sole,
    /// Sides and back.
    Skirt,
}

impl Region {
    /// All regions, in the order of their elements in a mesh.
    pub const ALL: [Self; 4] = [Self::Face, Self::Crown, Self::Sole, Self::Skirt];

    /// Name, as in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Face => "face",
            Self::Crown => "crown",
            Self::Sole => "sole",
            Self::Skirt => "skirt",
        }
    }
}

/// Shape of a driver head, m and rad.
#[derive(Clone, Copy, Debug)]
pub struct DriverShape {
    /// Elevation of the face normal.
    pub loft: f64,
    /// Radius of the face from heel to toe.
    pub bulge: f64,
    /// Radius of the face from sole to crown.
    pub roll: f64,
    /// Heel to toe.
    pub width: f64,
    /// Face to back.
    pub depth: f64,
    /// Crown above the face centre.
    pub crown: f64,
    /// Sole below the face centre.
    pub sole: f64,
    /// Rounding between face and body.
    pub rounding: f64,
}

/// Thickness by region, m.
#[derive(Clone, Copy, Debug)]
pub struct DriverThickness {
    /// At the face centre.
    pub face_centre: f64,
    /// At the edge of the face.
    pub face_edge: f64,
    /// Of the crown.
    pub crown: f64,
    /// Of the sole.
    pub sole: f64,
    /// Of sides and back.
    pub skirt: f64,
}

/// Elements from heel to toe, from sole to crown, from face to back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DriverFineness(pub [usize; 3]);

impl Default for DriverFineness {
    /// 3264 elements, as P2.
    fn default() -> Self {
        Self([36, 12, 25])
    }
}

/// A driver head as meshed.
#[derive(Clone, Debug)]
pub struct DriverMesh<R> {
    /// Middle surface with thickness.
    pub shells: ShellMesh<R>,
    /// Region of each element; elements of a region follow each other.
    pub regions: Vec<Region>,
}

/// Share of the depth that lies in front of the widest section.
const WIDEST: f64 = 0.42;
/// Exponents of the outline from above, and of the sections up and down.
const OUTLINE: f64 = 2.5;
const SECTION: f64 = 2.3;
/// Share of the sum of pulls by which a node moves in a round of smoothing.
const RELAXATION: f64 = 0.15;
/// Convexity below which smoothing leaves a node where it is, unless it helps: well above the 0.02 below which a head is refused.
const FOLDED: f64 = 0.15;
/// Rounds of smoothing.
const SMOOTHING: usize = 150;

impl DriverShape {
    /// Unit normal of the face at its centre, and its up direction.
    fn face_axes(&self) -> (Vec3<f64>, Vec3<f64>) {
        let (s, c) = self.loft.sin_cos();
        (Vec3::new(c, s, 0.0), Vec3::new(-s, c, 0.0))
    }
    /// Point inside from which the whole surface is seen.
    fn centre(&self) -> Vec3<f64> {
        Vec3::new(-self.depth * WIDEST, 0.0, 0.0)
    }
    /// Distance of the body without a face from the centre along a unit direction.
    fn body(&self, d: Vec3<f64>) -> f64 {
        let back = self.depth * (1.0 - WIDEST);
        let height = if d.y > 0.0 { self.crown } else { self.sole };
        let outline = (d.x / back).abs().powf(OUTLINE) + (d.z / (0.5 * self.width)).abs().powf(OUTLINE);
        (outline.powf(SECTION / OUTLINE) + (d.y / height).abs().powf(SECTION)).powf(-1.0 / SECTION)
    }
    /// How far a point is in front of the face, along its normal at the centre: a torus, the roll arc revolved about an axis `bulge` behind.
    fn in_front(&self, p: Vec3<f64>) -> f64 {
        let (normal, up) = self.face_axes();
        let height = p.dot(up);
        let radius = self.bulge - self.roll + (self.roll * self.roll - height * height).max(0.0).sqrt();
        p.dot(normal) + self.bulge - (radius * radius - p.z * p.z).max(0.0).sqrt()
    }
    /// Distance of the face from the centre along a unit direction, or `far` if that is less.
    fn face(&self, d: Vec3<f64>, far: f64) -> f64 {
        let (normal, _) = self.face_axes();
        let slope = d.dot(normal);
        if slope * far < self.in_front(self.centre()).abs() * 0.5 {
            return far;
        }
        let mut t = far;
        for _ in 0..8 {
            // The face is nearly flat: the slope at its centre will do.
            t = (t - self.in_front(self.centre() + d * t) / slope).clamp(0.0, far);
        }
        t
    }
    /// Point of the surface in a direction from the centre.
    fn point(&self, direction: Vec3<f64>) -> Vec3<f64> {
        let d = direction * (1.0 / direction.norm());
        let body = self.body(d);
        let face = self.face(d, body + self.rounding);
        let near = (1.0 - (body - face).abs() / self.rounding).max(0.0);
        let t = body.min(face) - 0.25 * self.rounding * near * near;
        self.centre() + d * t
    }

    /// Meshes the head, its thickness by region.
    #[must_use]
    pub fn mesh<R: Real>(&self, fineness: DriverFineness, thickness: &DriverThickness) -> DriverMesh<R> {
        let (mut nodes, quads) = boxed(fineness.0);
        let half = Vec3::new(0.5 * self.depth, 0.5 * (self.crown + self.sole), 0.5 * self.width);
        for p in &mut nodes {
            *p = self.point(Vec3::new(p.x * half.x, p.y * half.y, p.z * half.z));
        }
        self.smooth(&mut nodes, &quads);
        let (normal, _) = self.face_axes();
        let mut shells = ShellMesh { nodes, quads, thickness: Vec::new() };
        let mut order: Vec<_> = (0..shells.quads.len()).map(|e| (self.region(&shells, e), e)).collect();
        order.sort_unstable();
        shells.quads = order.iter().map(|&(_, element)| shells.quads[element]).collect();
        let regions: Vec<Region> = order.into_iter().map(|(region, _)| region).collect();
        for element in 0..shells.quads.len() {
            let middle =
                shells.quads[element].iter().fold(Vec3::zero(), |sum, &n| sum + shells.nodes[n as usize]);
            let t = self.thickness(regions[element], middle * 0.25, thickness);
            shells.thickness.push(R::from_f64(t));
        }
        for p in &mut shells.nodes {
            *p += normal * (-0.5 * thickness.face_centre);
        }
        DriverMesh { shells, regions }
    }

    /// Pulls sides and diagonals of all elements to one length each, as springs would, the nodes staying on the surface: the smallest
    /// element governs the time step.
    fn smooth(&self, nodes: &mut [Vec3<f64>], quads: &[[u32; 4]]) {
        let mut partners = vec![Vec::new(); nodes.len()];
        let mut around = vec![Vec::new(); nodes.len()];
        for quad in quads {
            for k in 0..4 {
                around[quad[k] as usize].push(*quad);
                // Every side is met twice, once from either end.
                partners[quad[k] as usize].push((quad[(k + 1) % 4] as usize, 1.0));
                partners[quad[k] as usize].push((quad[(k + 2) % 4] as usize, std::f64::consts::SQRT_2));
            }
        }
        let area = |quad: &[u32; 4]| {
            let [a, b, c, d] = quad.map(|n| nodes[n as usize]);
            (c - a).cross(d - b).norm() * 0.5
        };
        let length = (quads.iter().map(area).sum::<f64>() / quads.len() as f64).sqrt();
        let centre = self.centre();
        for _ in 0..SMOOTHING {
            for node in 0..nodes.len() {
                let here = nodes[node];
                let pull = partners[node].iter().fold(Vec3::zero(), |sum, &(other, ratio)| {
                    let away = nodes[other] - here;
                    sum + away * (1.0 - ratio * length / away.norm())
                });
                let worst = |nodes: &[Vec3<f64>]| {
                    let each = around[node].iter().map(|&quad| convexity(quad.map(|n| nodes[n as usize])));
                    each.fold(f64::INFINITY, f64::min)
                };
                nodes[node] = self.point(here + pull * RELAXATION - centre);
                // Springs would fold small elements at the edges of the box.
                let now = worst(nodes);
                if now < FOLDED {
                    let there = std::mem::replace(&mut nodes[node], here);
                    if now > worst(nodes) {
                        nodes[node] = there;
                    }
                }
            }
        }
    }

    fn region<R: Real>(&self, shells: &ShellMesh<R>, element: usize) -> Region {
        let area = shells.area_vector(element);
        let out = area * (1.0 / area.norm());
        let (normal, _) = self.face_axes();
        if out.dot(normal) > 0.85 {
            Region::Face
        } else if out.y > 0.5 {
            Region::Crown
        } else if out.y < -0.5 {
            Region::Sole
        } else {
            Region::Skirt
        }
    }

    fn thickness(&self, region: Region, p: Vec3<f64>, t: &DriverThickness) -> f64 {
        match region {
            Region::Crown => t.crown,
            Region::Sole => t.sole,
            Region::Skirt => t.skirt,
            Region::Face => {
                let (_, up) = self.face_axes();
                let (y, z) = (p.dot(up) / (0.5 * (self.crown + self.sole)), p.z / (0.5 * self.width));
                // Full thickness to a third of the way out, then evenly down to the edge.
                let out = (1.5 * (y * y + z * z).sqrt() - 0.5).clamp(0.0, 1.0);
                t.face_centre + (t.face_edge - t.face_centre) * out
            }
        }
    }
}

/// Surface of the box [-1, 1]^3 divided along z, y, x: nodes, and quadrilaterals counterclockwise from outside.
fn boxed([along_z, along_y, along_x]: [usize; 3]) -> (Vec<Vec3<f64>>, Vec<[u32; 4]>) {
    let counts = [along_x, along_y, along_z];
    let mut nodes = Vec::new();
    let mut index = std::collections::HashMap::new();
    let mut quads = Vec::new();
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for high in [false, true] {
            for j in 0..counts[v] {
                for i in 0..counts[u] {
                    let corner = |[a, b]: [usize; 2]| {
                        let mut at = [0; 3];
                        at[axis] = if high { counts[axis] } else { 0 };
                        at[u] = i + a;
                        at[v] = j + b;
                        at
                    };
                    let mut quad = [[0, 0], [1, 0], [1, 1], [0, 1]].map(corner);
                    if !high {
                        quad.reverse();
                    }
                    quads.push(quad.map(|at| {
                        *index.entry(at).or_insert_with(|| {
                            let place = |c: usize| 2.0 * at[c] as f64 / counts[c] as f64 - 1.0;
                            nodes.push(Vec3::new(place(0), place(1), place(2)));
                            nodes.len() as u32 - 1
                        })
                    }));
                }
            }
        }
    }
    (nodes, quads)
}
