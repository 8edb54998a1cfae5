//! Meshes of heads.

use clubface_fem::mesh::{IronFineness, IronShape};

#[test]
fn elements_stand_upright_and_the_face_looks_forwards() {
    let shape = IronShape {
        loft: 0.5,
        length: 0.078,
        heel_height: 0.03,
        toe_height: 0.055,
        face: 2.5e-3,
        sole: 0.018,
        top: 6e-3,
        rim: 0.2,
        rounding: 8e-3,
    };
    let mesh = shape.mesh(IronFineness([40, 24, 2]));
    for element in 0..mesh.solid.elements.len() {
        assert!(mesh.solid.volume(element) > 0.0, "element {element}");
    }
    let (s, c) = shape.loft.sin_cos();
    for quad in &mesh.face {
        let [a, b, c4, d] = quad.map(|n| mesh.solid.nodes[n as usize]);
        let area = (c4 - a).cross(d - b);
        assert!((area.x * c + area.y * s) > 0.999 * area.norm());
        // The face is a plane through the origin.
        assert!((a.x * c + a.y * s).abs() < 1e-12);
    }
}
