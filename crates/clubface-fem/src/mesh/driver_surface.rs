//! The surface of a hollow driver head, and nodes that spread over it.

use super::driver_shape::DriverShape;
use super::shell_mesh::convexity;
use clubface_math::Vec3;

/// Part of the depth in front of the widest section.
const WIDEST: f64 = 0.42;
/// Exponents of the outline from above, of which [`outlined`] is the power, and of the sections up and down.
const OUTLINE: f64 = 2.5;
const SECTION: f64 = 2.3;
/// Fraction of the sum of pulls by which a node moves in a round of smoothing.
const RELAXATION: f64 = 0.15;
/// Convexity below which smoothing leaves a node where it is, unless it helps: well above the 0.02 below which a head
/// is refused.
const FOLDED: f64 = 0.15;
/// Rounds of smoothing.
const SMOOTHING: usize = 150;

/// The outside of a head.
pub(super) struct DriverSurface<'a> {
    shape: &'a DriverShape,
    /// Unit normal of the face at its centre.
    pub normal: Vec3<f64>,
    /// Its up direction.
    pub up: Vec3<f64>,
    /// Point inside from which the whole surface is seen, and half its distance from the face.
    centre: Vec3<f64>,
    near: f64,
}

impl<'a> DriverSurface<'a> {
    pub fn new(shape: &'a DriverShape) -> Self {
        let (s, c) = shape.loft.sin_cos();
        let (normal, up) = (Vec3::new(c, s, 0.0), Vec3::new(-s, c, 0.0));
        let centre = Vec3::new(-shape.depth * WIDEST, 0.0, 0.0);
        let mut surface = Self { shape, normal, up, centre, near: 0.0 };
        surface.near = surface.in_front(centre).abs() * 0.5;
        surface
    }

    /// Distance of the body without a face from the centre along a unit direction.
    fn body(&self, d: Vec3<f64>) -> f64 {
        let shape = self.shape;
        let back = shape.depth * (1.0 - WIDEST);
        let height = if d.y > 0.0 { shape.crown } else { shape.sole };
        let outline = outlined(d.x / back) + outlined(d.z / (0.5 * shape.width));
        (outline.powf(SECTION / OUTLINE) + (d.y / height).abs().powf(SECTION)).powf(-1.0 / SECTION)
    }
    /// How far a point is in front of the face, along its normal at the centre: a torus, the roll arc revolved about an
    /// axis `bulge` behind.
    fn in_front(&self, p: Vec3<f64>) -> f64 {
        let DriverShape { bulge, roll, .. } = *self.shape;
        let height = p.dot(self.up);
        let radius = bulge - roll + (roll * roll - height * height).max(0.0).sqrt();
        p.dot(self.normal) + bulge - (radius * radius - p.z * p.z).max(0.0).sqrt()
    }
    /// Distance of the face from the centre along a unit direction, or `far` if that is less.
    fn face(&self, d: Vec3<f64>, far: f64) -> f64 {
        let slope = d.dot(self.normal);
        if slope * far < self.near {
            return far;
        }
        let mut t = far;
        for _ in 0..8 {
            // The face is nearly flat: the slope at its centre will do. With its own slope at every place this would be
            // quicker, but run away where the face is as curved as the limits of shapes allow.
            let next = (t - self.in_front(self.centre + d * t) / slope).clamp(0.0, far);
            if next == t {
                break;
            }
            t = next;
        }
        t
    }
    /// Point of the surface in a direction from the centre.
    pub fn point(&self, direction: Vec3<f64>) -> Vec3<f64> {
        let d = direction * (1.0 / direction.norm());
        let rounding = self.shape.rounding;
        let body = self.body(d);
        let face = self.face(d, body + rounding);
        let near = (1.0 - (body - face).abs() / rounding).max(0.0);
        let t = body.min(face) - 0.25 * rounding * near * near;
        self.centre + d * t
    }

    /// Pulls sides and diagonals of all elements to one length each, as springs would, the nodes staying on the
    /// surface: the smallest element governs the time step.
    pub fn smooth(&self, nodes: &mut [Vec3<f64>], quads: &[[u32; 4]]) {
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
                nodes[node] = self.point(here + pull * RELAXATION - self.centre);
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
}

/// A number's size to the power [`OUTLINE`].
fn outlined(x: f64) -> f64 {
    x * x * x.abs().sqrt()
}
