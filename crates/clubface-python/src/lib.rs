//! `clubface._core`: arrays in, arrays out. All values SI and radians.

mod columns;
mod describe;
mod design;
mod face_map;
mod fem;
mod flight;
mod impact;
mod multibody;
mod own_law;

use pyo3::prelude::*;

/// The compiled core of clubface. It needs no global lock of Python: what threads share is constant or has a lock of its
/// own, and whoever waits for one of these waits detached from Python.
#[pymodule(gil_used = false)]
mod _core {
    #[pymodule_export]
    use crate::describe::{
        dimensions, flight_inputs, flight_outputs, inputs, models, outputs, pressure_at_altitude, quantities,
        shot_shapes, units,
    };
    #[pymodule_export]
    use crate::design::{
        ShotTally, dispersion_quantities, golfer_deliveries, head_margins, hole_strokes, pseudo_inertia,
        quasi_random, strokes_at, volume_forms,
    };
    #[pymodule_export]
    use crate::face_map::{FaceOutline, face_fine, face_quantities};
    #[pymodule_export]
    use crate::fem::{
        FemImpact, fem_ball, fem_check_law, fem_driver, fem_energy, fem_energy_instability,
        fem_energy_values, fem_head_properties, fem_impact, fem_iron, fem_laws, fem_mesh, fem_register_law,
        fem_sensitivity, fem_shear, fem_thickness_points, fem_variables, fem_volumetric, fem_yield_stress,
    };
    #[pymodule_export]
    use crate::flight::{curves, fly, fly_sensitivities, fly_sensitivity, shot_shape_names, trajectory};
    #[pymodule_export]
    use crate::impact::{check, history, impact, sensitivities, sensitivity};
    #[pymodule_export]
    use crate::multibody::{BallHandle, ContactHandle};
    #[pymodule_export]
    use crate::own_law::LawHandle;
}
