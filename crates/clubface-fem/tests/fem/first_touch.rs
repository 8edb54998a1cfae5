//! The delivery of a head of shells, as of a rigid head of its mass and inertia.

use clubface_fem::head::{DeformableHead, ShellHead};
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::shot::INPUTS;

/// First touch of a shot with some inputs; all others are zero.
pub fn touch(values: &[(&str, f64)]) -> FirstTouch<f64> {
    let value = |name: &str| values.iter().find(|value| value.0 == name).map_or(0.0, |value| value.1);
    FirstTouch::from_inputs(&INPUTS.map(|input| value(input.quantity.name)))
}

/// A head delivered at 35 m/s and its loft, `toe` metres from the face centre, turning about the vertical at `closure`
/// (rad/s).
pub fn delivered(head: &ShellHead<f64>, toe: f64, closure: f64) -> FirstTouch<f64> {
    let is = head.mass_properties();
    let ([x, y, z], at) = (is.inertia.rows, is.centre * -1.0);
    touch(&[
        ("speed", 35.0),
        ("loft", head.loft),
        ("toe", toe),
        ("closure", closure),
        ("club_mass", is.mass),
        ("cg_x", at.x),
        ("cg_y", at.y),
        ("cg_z", at.z),
        ("ixx", x.x),
        ("iyy", y.y),
        ("izz", z.z),
        ("ixy", x.y),
        ("ixz", x.z),
        ("iyz", y.z),
        ("static_loft", head.loft),
        ("bulge", 0.305),
        ("roll", 0.305),
        ("hand", 1.0),
    ])
}
