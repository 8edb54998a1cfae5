//! Whether some body has an inertia, and some mechanism what it adds to one.

use crate::club::Club;
use crate::error::ImpactError;
use crate::head_inertia::SpatialMatrix;
use clubface_math::{Mat3, Vec3};

/// Slack of the bounds that a body can meet with equality, up to rounding: a flat plate, a thin shell.
pub(crate) const ROUNDING: f64 = 1.0 + 1e-9;

/// Positive definite, and no principal moment larger than the sum of the other two.
pub(crate) fn check_inertia(inertia: &[f64; 6]) -> Result<(), ImpactError> {
    let [xx, yy, zz, xy, xz, yz] = *inertia;
    if !is_positive_definite(symmetric(inertia)) {
        let allowed = "is not positive definite; check units and signs of the products of inertia";
        return Err(inertia_fault(inertia, allowed));
    }
    // The second moments of mass, trace/2 - I, are positive for any real body, but for a plate, which has one of 0.
    let half = (xx + yy + zz) / 2.0 * ROUNDING;
    if !is_positive_definite(symmetric(&[half - xx, half - yy, half - zz, -xy, -xz, -yz])) {
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

fn symmetric(elements: &[f64; 6]) -> [[f64; 3]; 3] {
    Mat3::symmetric(*elements).rows.map(Vec3::array)
}

/// What shaft and hands add to the inertia of a head: positive semidefinite, since no motion of it may take energy.
pub(crate) fn check_added_inertia(club: &Club<f64>) -> Result<(), ImpactError> {
    if club.added.iter().all(|&value| value == 0.0) {
        return Ok(());
    }
    let Some(added) = SpatialMatrix::from_values(&club.added) else {
        let message = "must be 0, as of a free head: this build has no heads on shafts";
        return Err(ImpactError::new("added_mass_xx", message));
    };
    // Angular velocities times a length of the head, so that all elements are masses; and room for rounding, and for
    // mechanisms that add nothing in some direction.
    let mut matrix = added.rows();
    let length = (club.inertia[..3].iter().sum::<f64>() / club.mass).sqrt();
    let scale = |i: usize| if i < 3 { 1.0 } else { length.recip() };
    for i in 0..6 {
        for j in 0..6 {
            matrix[i][j] *= scale(i) * scale(j);
        }
    }
    let largest = (0..6).map(|i| matrix[i][i]).fold(club.mass, f64::max);
    for i in 0..6 {
        matrix[i][i] += (ROUNDING - 1.0) * largest;
    }
    if is_positive_definite(matrix) {
        return Ok(());
    }
    let message = "what shaft and hands add to the inertia of the head must be positive semidefinite, and is not: \
                   there is a motion in which they would push the head along; check units, axes and signs of its \
                   6 x 6 matrix";
    Err(ImpactError::new("added_mass_xx", message))
}

/// Whether all pivots of a symmetric matrix are positive.
fn is_positive_definite<const N: usize>(mut matrix: [[f64; N]; N]) -> bool {
    for i in 0..N {
        if matrix[i][i].is_nan() || matrix[i][i] <= 0.0 {
            return false;
        }
        for j in i + 1..N {
            let factor = matrix[j][i] / matrix[i][i];
            for k in i + 1..N {
                matrix[j][k] -= factor * matrix[i][k];
            }
        }
    }
    true
}
