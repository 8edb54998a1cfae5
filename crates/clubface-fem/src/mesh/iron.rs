//! A solid iron head of hexahedra: a blade behind a flat face, thick at the sole and the top line, thin in a cavity
//! between.
//!
//! Axes as those of all heads: x towards the target, y up, z to the toe; the origin is the face centre.

use super::{CORNERS, SolidMesh};
use clubface_math::Vec3;

/// Shape of an iron head, m and rad.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(deny_unknown_fields))]
pub struct IronShape {
    /// Elevation of the face normal.
    pub loft: f64,
    /// Heel to toe.
    pub length: f64,
    /// Height of the face at the heel, along the face.
    pub heel_height: f64,
    /// The same at the toe.
    pub toe_height: f64,
    /// Thickness of the face in the cavity; of the whole blade if there is none.
    pub face: f64,
    /// Thickness of the sole, from the face back.
    pub sole: f64,
    /// Thickness of the top line.
    pub top: f64,
    /// Height of the sole's and width of the top line's part of the blade, and of its ends, over the size of the blade:
    /// 0.5 leaves no cavity.
    pub rim: f64,
    /// Radius of the corners of the outline.
    pub rounding: f64,
}

/// Numbers of elements from heel to toe, from sole to top line, and through the blade.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IronFineness(pub [usize; 3]);

/// A meshed iron head.
#[derive(Clone, Debug)]
pub struct IronMesh {
    /// The hexahedra, through the blade from its back.
    pub solid: SolidMesh,
    /// Quadrilaterals of the face, counterclockwise seen from outside.
    pub face: Vec<[u32; 4]>,
}

impl IronShape {
    /// Unit normal of the face, and the direction up it.
    fn axes(&self) -> [Vec3<f64>; 2] {
        let (s, c) = self.loft.sin_cos();
        [Vec3::new(c, s, 0.0), Vec3::new(-s, c, 0.0)]
    }

    /// Place on the face for -1 to 1 from heel to toe and from sole to top line: along the face from its centre, up and
    /// to the toe.
    fn outline(&self, along: f64, across: f64) -> (f64, f64) {
        let height = |at: f64| self.heel_height + 0.5 * (at + 1.0) * (self.toe_height - self.heel_height);
        // Corners are rounded by drawing in the ends of the rows near sole and top line.
        let near = (0.5 * height(along) * (across.abs() - 1.0) + self.rounding).max(0.0);
        let drawn = self.rounding - (self.rounding * self.rounding - near * near).max(0.0).sqrt();
        let toe = along * (0.5 * self.length - drawn);
        let bottom = -0.25 * (self.heel_height + self.toe_height);
        (bottom + 0.5 * height(2.0 * toe / self.length) * (across + 1.0), toe)
    }

    /// Thickness of the blade at the same coordinates.
    fn thickness(&self, along: f64, across: f64) -> f64 {
        let rim = 2.0 * self.rim;
        // From 1 at an edge to 0 at the end of the rim.
        let fraction = |at: f64| smooth(1.0 - (1.0 - at) / rim);
        let top = self.face + (self.top - self.face) * fraction(across).max(fraction(along.abs()));
        let sole = fraction(-across);
        top + (self.sole - top) * sole
    }

    /// Meshes the head.
    #[must_use]
    pub fn mesh(&self, IronFineness(counts): IronFineness) -> IronMesh {
        let [along, across, through] = counts;
        let [normal, up] = self.axes();
        let place = |i: usize, count: usize| 2.0 * i as f64 / count as f64 - 1.0;
        let mut nodes = Vec::new();
        for k in 0..=through {
            for j in 0..=across {
                for i in 0..=along {
                    let (u, v) = (place(i, along), place(j, across));
                    let (y, z) = self.outline(u, v);
                    let behind = self.thickness(u, v) * (1.0 - k as f64 / through as f64);
                    nodes.push(up * y + normal * -behind + Vec3::new(0.0, 0.0, z));
                }
            }
        }
        let index = |i: usize, j: usize, k: usize| (i + (along + 1) * (j + (across + 1) * k)) as u32;
        let mut solid = SolidMesh { nodes, elements: Vec::new(), layer: Vec::new() };
        let mut face = Vec::new();
        for k in 0..through {
            for j in 0..across {
                for i in 0..along {
                    let mut element = [0; CORNERS];
                    for (corner, node) in element.iter_mut().enumerate() {
                        // To the toe, down the blade, forwards: a right-handed system.
                        *node = index(i + (corner & 1), j + 1 - (corner >> 1 & 1), k + (corner >> 2 & 1));
                    }
                    solid.elements.push(element);
                    solid.layer.push(0);
                    if k + 1 == through {
                        face.push(
                            [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
                                .map(|(i, j)| index(i, j, through)),
                        );
                    }
                }
            }
        }
        IronMesh { solid, face }
    }
}

/// From 0 to 1 with level ends.
fn smooth(fraction: f64) -> f64 {
    let s = fraction.clamp(0.0, 1.0);
    s * s * (3.0 - 2.0 * s)
}
