//! Grooves of a face: the depth of its surface below its lands.

use crate::error::FemError;
use clubface_math::Real;

/// Straight grooves from heel to toe all over a face, with a land through its centre, m.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(deny_unknown_fields))]
pub struct Grooves {
    /// Width from edge to edge.
    pub width: f64,
    /// Depth below the lands.
    pub depth: f64,
    /// Distance from the middle of one groove to the middle of the next.
    pub pitch: f64,
    /// Width of each side wall, across which the depth grows smoothly.
    pub wall: f64,
}

impl Grooves {
    /// Depth below the lands (m) at a height up the face from its centre, and the depth's slope.
    pub fn relief<R: Real>(&self, height: R) -> (R, R) {
        let number = (height.re() / self.pitch).floor();
        let off = height - self.pitch * (number + 0.5);
        let (away, side) = if off.re() < 0.0 { (-off, 1.0) } else { (off, -1.0) };
        let into = -(away - 0.5 * self.width) * (1.0 / self.wall);
        if into.re() <= 0.0 {
            (R::zero(), R::zero())
        } else if into.re() >= 1.0 {
            (R::from_f64(self.depth), R::zero())
        } else {
            let depth = into * into * (-(into * 2.0) + 3.0) * self.depth;
            let slope = into * (-into + 1.0) * (6.0 * side * self.depth / self.wall);
            (depth, slope)
        }
    }

    /// Checks that the nodes of a ball, at this distance from each other (m), are close enough to resolve the grooves.
    ///
    /// # Errors
    /// [`FemError::Input`] for a mesh that is too coarse.
    pub fn check(&self, apart: f64) -> Result<(), FemError> {
        if apart <= self.width {
            return Ok(());
        }
        let value = format!("{:.2} mm wide", self.width * 1e3);
        let allowed = format!(
            "they must be at least as wide as nodes of the ball are apart, {:.2} mm; make `cube` of the ball {:.1} times as large",
            apart * 1e3,
            apart / self.width
        );
        Err(FemError::input("grooves", value, allowed))
    }
}
