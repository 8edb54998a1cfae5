//! Whether some body has an inertia.

use crate::error::ImpactError;
use clubface_math::{Mat3, Vec3};

/// Slack of the bounds that a body can meet with equality, up to rounding: a flat plate, a thin shell.
pub(crate) const ROUNDING: f64 = 1.0 + 1e-9;

/// Positive definite, and no principal moment larger than the sum of the other two.
pub(crate) fn check_inertia(inertia: &[f64; 6]) -> Result<(), ImpactError> {
    let [xx, yy, zz, xy, xz, yz] = *inertia;
    if !is_positive_definite(inertia) {
        let allowed = "is not positive definite; check units and signs of the products of inertia";
        return Err(inertia_fault(inertia, allowed));
    }
    // The second moments of mass, trace/2 - I, are positive for any real body, but for a plate, which has one of 0.
    let half = (xx + yy + zz) / 2.0 * ROUNDING;
    if !is_positive_definite(&[half - xx, half - yy, half - zz, -xy, -xz, -yz]) {
        let allowed = "has a principal moment larger than the sum of the other two (triangle inequality): no body \
                       has that";
        return Err(inertia_fault(inertia, allowed));
    }
    Ok(())
}

fn inertia_fault([xx, yy, zz, xy, xz, yz]: &[f64; 6], allowed: &str) -> ImpactError {
    let value =
        format!("[xx {xx:.4e}, yy {yy:.4e}, zz {zz:.4e}, xy {xy:.4e}, xz {xz:.4e}, yz {yz:.4e}] kg m2");
    ImpactError::new("ixx", format!("{value} {allowed}"))
}

fn is_positive_definite(e: &[f64; 6]) -> bool {
    let [a, b, c]: [Vec3<f64>; 3] = Mat3::symmetric(*e).rows;
    a.x > 0.0 && a.x * b.y - a.y * b.x > 0.0 && a.dot(b.cross(c)) > 0.0
}
