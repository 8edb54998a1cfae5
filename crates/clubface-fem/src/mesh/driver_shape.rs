//! Shape and wall thickness of a hollow driver head.

/// Part of a head.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Region {
    /// The side that hits the ball.
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

    /// Its name in reports.
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
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(deny_unknown_fields))]
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
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(deny_unknown_fields))]
pub struct DriverThickness {
    /// At the face centre.
    pub face_centre: f64,
    /// At the edge of the face.
    pub face_edge: f64,
    /// Crown.
    pub crown: f64,
    /// Sole.
    pub sole: f64,
    /// Sides and back.
    pub skirt: f64,
}

/// Numbers of elements from heel to toe, from sole to crown, and from face to back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DriverFineness(pub [usize; 3]);

impl Default for DriverFineness {
    /// 3264 elements, as many as Roh and Lee have.
    fn default() -> Self {
        Self([36, 12, 25])
    }
}
