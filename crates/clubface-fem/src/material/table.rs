//! The table of laws: how a law by name becomes one that computes, over every number that laws are compiled for and
//! for all of its packs.

use super::description::Description;
use super::family::{DERIVATIVES, Entry, Family, Law, Origin};
use super::own::{OwnFunction, Points};
use super::stage::{Slot, Stage, StressStage};
use super::step::MaterialStep;
use super::viscous::Branches;
use crate::error::FemError;
#[cfg(any(target_arch = "aarch64", all(target_arch = "wasm32", target_feature = "simd128")))]
use clubface_math::pack::F64x2;
#[cfg(target_arch = "x86_64")]
use clubface_math::pack::{F64x4, F64x8};
use clubface_math::{Computation, Dual, Pack, Real, Scalar};
use std::any::Any;
use std::marker::PhantomData;
use std::sync::Arc;

/// A number that materials are made of.
pub trait Number: Real + Pack<Real = Self> {
    /// The law of a line of a table.
    fn law(entry: &Entry, constants: &[Self]) -> Arc<dyn Law<Self>>;
    /// Fills a slot with the stage of a law, for the type of packs that the slot asks for.
    fn stage(law: &impl Staged<Self>, step: &MaterialStep<Self>, slot: &mut dyn Any);
    /// Calls a function of C for some points.
    fn call(points: &mut Points<Self>, function: &OwnFunction, constants: &[Self], step: f64);
}

/// A law that has a stage for packs of every type.
pub trait Staged<R: Real> {
    /// Its stage in a step.
    fn boxed<P: Pack<Real = R>>(&self, step: &MaterialStep<R>) -> Box<dyn StressStage<P>>;
}

/// The line of a law.
#[must_use]
pub const fn entry<F: Family>() -> Entry {
    Entry {
        description: const { &F::DESCRIPTION },
        plain: build::<F, f64>,
        derived: build::<F, Dual<f64, DERIVATIVES>>,
    }
}

/// A table of laws. Each line names one.
#[macro_export]
macro_rules! materials {
    ($(#[$doc:meta])* $visibility:vis static $table:ident; $($law:ty;)+) => {
        $(#[$doc])*
        $visibility static $table: &[$crate::material::Entry] =
            &[$($crate::material::entry::<$law>()),+];
    };
}

/// The line of a law that takes as many constants.
///
/// # Errors
/// [`FemError::Input`] for an unknown name or a wrong number of constants.
pub fn entry_from_name<'a>(table: &'a [Entry], name: &str, constants: usize) -> Result<&'a Entry, FemError> {
    let named = table.iter().find(|entry| entry.description.name == name);
    let entry = named
        .ok_or_else(|| FemError::unknown("law", name, table.iter().map(|entry| entry.description.name)))?;
    entry.description.check_count(constants)?;
    Ok(entry)
}

/// A law of a table from its name and constants (SI).
///
/// # Errors
/// As [`entry_from_name`], and for constants that are not allowed.
pub fn from_table<R: Number>(
    table: &[Entry],
    name: &str,
    constants: &[R],
) -> Result<Arc<dyn Law<R>>, FemError> {
    let law = R::law(entry_from_name(table, name, constants.len())?, constants);
    law.check(name)?;
    Ok(law)
}

/// A law of a family.
#[derive(Debug)]
struct Built<F, R> {
    constants: Vec<R>,
    family: PhantomData<F>,
}

impl<F: Family, R: Number> Law<R> for Built<F, R> {
    fn origin(&self) -> Origin<'_> {
        Origin::Table(entry::<F>())
    }
    fn description(&self) -> &'static Description {
        const { &F::DESCRIPTION }
    }
    fn constants(&self) -> &[R] {
        &self.constants
    }
    fn shear(&self) -> R {
        F::shear(&self.constants)
    }
    fn check(&self, name: &str) -> Result<(), FemError> {
        let values: Vec<f64> = self.constants.iter().map(|value| value.re()).collect();
        F::check(&values, name)?;
        for (constant, value) in F::DESCRIPTION.constants.iter().zip(values) {
            let (least, most, unit) = (constant.least, constant.most, constant.unit());
            if !(least..=most).contains(&value) {
                let written = |value: f64| format!("{value} {unit}").trim_end().to_owned();
                let allowed = match least {
                    _ if value > most => format!("it must be at most {}", written(most)),
                    0.0 => "it must be zero or above".to_owned(),
                    _ => format!("it must be at least {}", written(least)),
                };
                return Err(FemError::input(format!("{} of {name}", constant.name), written(value), allowed));
            }
        }
        let shear = self.shear().re();
        if !(shear > 0.0 && shear.is_finite()) {
            let allowed = "it must be above zero and finite";
            return Err(FemError::input(format!("shear modulus of {name}"), format!("{shear} Pa"), allowed));
        }
        Ok(())
    }
    fn stage(&self, step: &MaterialStep<R>, slot: &mut dyn Any) {
        R::stage(self, step, slot);
    }
}

/// A law from its constants.
pub fn build<F: Family, R: Number>(constants: &[R]) -> Arc<dyn Law<R>> {
    Arc::new(Built { constants: constants.to_vec(), family: PhantomData::<F> })
}

impl<F: Family, R: Number> Staged<R> for Built<F, R> {
    fn boxed<P: Pack<Real = R>>(&self, step: &MaterialStep<R>) -> Box<dyn StressStage<P>> {
        <P as Scalar>::outline(MakeStage::<F, P> {
            constants: &self.constants,
            branches: &step.branches,
            family: PhantomData,
        })
    }
}

/// Makes the stage of a law for packs of a type, with the features of the CPU that they need.
struct MakeStage<'a, F, P: Pack> {
    constants: &'a [P::Real],
    branches: &'a Branches<'a, P::Real>,
    family: PhantomData<F>,
}

impl<F: Family, P: Pack> Computation for MakeStage<'_, F, P> {
    type Output = Box<dyn StressStage<P>>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let mut constants = Vec::with_capacity(self.constants.len());
        for constant in self.constants {
            constants.push(P::splat(*constant));
        }
        Box::new(Stage::new(F::over(&constants), self.branches))
    }
}

/// The laws over a number, for each type of its packs.
macro_rules! number {
    ($number:ty, $law:ident, $($(#[$where:meta])? $pack:ty),+) => {
        impl Number for $number {
            fn law(entry: &Entry, constants: &[Self]) -> Arc<dyn Law<Self>> {
                (entry.$law)(constants)
            }
            fn stage(law: &impl Staged<Self>, step: &MaterialStep<Self>, slot: &mut dyn Any) {
                $($(#[$where])?
                if let Some(slot) = slot.downcast_mut::<Slot<$pack>>() {
                    *slot = Some(law.boxed::<$pack>(step));
                    return;
                })+
                unreachable!("packs that laws are not compiled for");
            }
            fn call(points: &mut Points<Self>, function: &OwnFunction, constants: &[Self], step: f64) {
                points.call(function, constants, step);
            }
        }
    };
}

number!(
    f64,
    plain,
    f64,
    #[cfg(any(target_arch = "aarch64", all(target_arch = "wasm32", target_feature = "simd128")))]
    F64x2,
    #[cfg(target_arch = "x86_64")]
    F64x4,
    #[cfg(target_arch = "x86_64")]
    F64x8
);
number!(
    Dual<f64, DERIVATIVES>,
    derived,
    Dual<f64, DERIVATIVES>,
    #[cfg(any(target_arch = "aarch64", all(target_arch = "wasm32", target_feature = "simd128")))]
    Dual<F64x2, DERIVATIVES>,
    #[cfg(target_arch = "x86_64")]
    Dual<F64x4, DERIVATIVES>,
    #[cfg(target_arch = "x86_64")]
    Dual<F64x8, DERIVATIVES>
);
