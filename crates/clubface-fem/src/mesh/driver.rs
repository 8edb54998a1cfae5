//! A hollow driver head of quadrilaterals: a closed surface, part of it the face with bulge, roll and loft.
//!
//! Axes as those of the ball at first touch: x towards the target, y up, z to the toe; the origin is the face centre,
//! on the outside. The mesh is that of a box, wrapped round the body and smoothed, so that it has no triangles, no
//! seams, and no corner in one plane with its neighbours.

use super::ShellMesh;
use super::driver_shape::{DriverFineness, DriverShape, DriverThickness, Region};
use super::driver_surface::DriverSurface;
use clubface_math::{Real, Vec3};

/// A meshed driver head.
#[derive(Clone, Debug)]
pub struct DriverMesh<R> {
    /// Middle surface with thickness.
    pub shells: ShellMesh<R>,
    /// Region of each element; elements of a region are consecutive.
    pub regions: Vec<Region>,
}

impl DriverShape {
    /// Meshes the head, its thickness by region.
    #[must_use]
    pub fn mesh<R: Real>(&self, fineness: DriverFineness, thickness: &DriverThickness) -> DriverMesh<R> {
        let (mut nodes, quads) = boxed(fineness.0);
        let surface = DriverSurface::new(self);
        let half = Vec3::new(0.5 * self.depth, 0.5 * (self.crown + self.sole), 0.5 * self.width);
        for p in &mut nodes {
            *p = surface.point(Vec3::new(p.x * half.x, p.y * half.y, p.z * half.z));
        }
        surface.smooth(&mut nodes, &quads);
        let mut shells = ShellMesh { nodes, quads, thickness: Vec::new() };
        let mut order: Vec<_> =
            (0..shells.quads.len()).map(|e| (region(&shells, e, surface.normal), e)).collect();
        order.sort_unstable();
        shells.quads = order.iter().map(|&(_, element)| shells.quads[element]).collect();
        let regions: Vec<Region> = order.into_iter().map(|(region, _)| region).collect();
        for element in 0..shells.quads.len() {
            let middle =
                shells.quads[element].iter().fold(Vec3::zero(), |sum, &n| sum + shells.nodes[n as usize]);
            let t = self.thickness(regions[element], middle * 0.25, surface.up, thickness);
            shells.thickness.push(R::from_f64(t));
        }
        for p in &mut shells.nodes {
            *p += surface.normal * (-0.5 * thickness.face_centre);
        }
        DriverMesh { shells, regions }
    }

    fn thickness(&self, region: Region, p: Vec3<f64>, up: Vec3<f64>, t: &DriverThickness) -> f64 {
        match region {
            Region::Crown => t.crown,
            Region::Sole => t.sole,
            Region::Skirt => t.skirt,
            Region::Face => {
                let (y, z) = (p.dot(up) / (0.5 * (self.crown + self.sole)), p.z / (0.5 * self.width));
                // Full thickness to a third of the way out, then evenly down to the edge.
                let out = (1.5 * (y * y + z * z).sqrt() - 0.5).clamp(0.0, 1.0);
                t.face_centre + (t.face_edge - t.face_centre) * out
            }
        }
    }
}

/// Region of an element of a head whose face has the given normal.
fn region<R: Real>(shells: &ShellMesh<R>, element: usize, normal: Vec3<f64>) -> Region {
    let area = shells.area_vector(element);
    let out = area * (1.0 / area.norm());
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
