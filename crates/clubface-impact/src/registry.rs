//! The models there are. A new model is one file under `models/` and one line here.

use crate::error::ImpactError;
use crate::impact_model::ImpactModel;
use crate::models;

/// Declares a constant for each model, and `ALL` of them: `NAME => path::to::Model;` for a model that implements
/// [`Describe`](crate::model::Describe) as `Model<()>`. Its kernels are compiled in the crate of the registry.
#[macro_export]
macro_rules! registry {
    ($($constant:ident => $($path:ident)::+;)+) => {
        $(
            #[doc = concat!("[`", stringify!($($path)::+), "`].")]
            pub const $constant: $crate::ImpactModel = {
                static KERNELS: $crate::impact_model::Kernels =
                    $crate::impact_model::Kernels::for_model::<$($path)::+<()>>();
                $crate::ImpactModel::new(&KERNELS)
            };
        )+
        /// Every model of this registry.
        pub static ALL: &[$crate::ImpactModel] = &[$($constant),+];
    };
}

registry! {
    RESPONSE => models::response::Response;
    STANDARD => models::standard::Standard;
    ADJUSTED => models::adjusted::Adjusted;
    SLIP => models::slip::Slip;
    JORGENSEN => models::jorgensen::Jorgensen;
    VOLUMETRIC => models::volumetric::Volumetric;
    RINGS => models::rings::Rings;
    AREA => models::area::Area;
}

/// The model of this name.
///
/// # Errors
/// A name that no model has.
pub fn named(name: &str) -> Result<ImpactModel, ImpactError> {
    ALL.iter().copied().find(|model| model.info().name == name).ok_or_else(|| {
        let names: Vec<_> = ALL.iter().map(|model| model.info().name).collect();
        ImpactError::new("model", format!("'{name}' is unknown; known: {}", names.join(", ")))
    })
}
