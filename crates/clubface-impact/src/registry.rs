//! The models there are. A new model is one file under `models/` and one line here.

use crate::first_touch::FirstTouch;
use crate::history::Recorder;
use crate::model::{Accuracy, Describe, Impact, Model, ModelInfo};
use crate::models;
use clubface_math::{Computation, Scalar};

macro_rules! registry {
    ($($variant:ident => $($path:ident)::+;)+) => {
        /// A model by name, for choices made at run time.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum ModelKind {
            $(#[doc = stringify!($variant)] $variant,)+
        }
        impl ModelKind {
            /// Every model.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];
            /// Its description.
            #[must_use]
            pub const fn info(self) -> &'static ModelInfo {
                match self {
                    $(Self::$variant => &<$($path)::+<()> as Describe>::INFO,)+
                }
            }
            /// Impact by this model with parameter values in the order of its table.
            #[inline(always)]
            pub fn impact<S: Scalar, R: Recorder<S>>(
                self,
                touch: &FirstTouch<S>,
                parameters: &[S],
                accuracy: Accuracy,
                recorder: &mut R,
            ) -> Impact<S> {
                match self {
                    $(Self::$variant => {
                        let model = <$($path)::+<S> as Model<S>>::from_values(parameters);
                        S::outline(Run { model, touch, accuracy, recorder })
                    })+
                }
            }
            /// [`ModelKind::impact`] of lanes that hold different shots, for models whose lanes may (see
            /// [`ModelInfo::lanes`]) and for single shots: the others are not even compiled for packs here.
            #[inline(always)]
            pub fn impacts<S: Scalar, R: Recorder<S>>(
                self,
                touch: &FirstTouch<S>,
                parameters: &[S],
                accuracy: Accuracy,
                recorder: &mut R,
            ) -> Impact<S> {
                match self {
                    $(Self::$variant => {
                        if const { S::LANES == 1 || <$($path)::+<()> as Describe>::INFO.lanes } {
                            let model = <$($path)::+<S> as Model<S>>::from_values(parameters);
                            S::outline(Run { model, touch, accuracy, recorder })
                        } else {
                            unreachable!("this model takes one shot at a time")
                        }
                    })+
                }
            }
        }
    };
}

registry! {
    Standard => models::standard::Standard;
    Adjusted => models::adjusted::Adjusted;
    Slip => models::slip::Slip;
    Jorgensen => models::jorgensen::Jorgensen;
    Volumetric => models::volumetric::Volumetric;
    Rings => models::rings::Rings;
    Area => models::area::Area;
}

struct Run<'a, M, S, R> {
    model: M,
    touch: &'a FirstTouch<S>,
    accuracy: Accuracy,
    recorder: &'a mut R,
}

impl<M: Model<S>, S: Scalar, R: Recorder<S>> Computation for Run<'_, M, S, R> {
    type Output = Impact<S>;
    #[inline(always)]
    fn run(self) -> Impact<S> {
        self.model.impact(self.touch, self.accuracy, self.recorder)
    }
}

impl ModelKind {
    /// The model of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|model| model.info().name == name)
    }
}
