//! A law that is a function of C, compiled by whoever wrote it: from the change of shape at some points to stress and
//! energy, with state variables of its own if it has any.
//!
//! The function is handed `C̄ = J^(-2/3) F^T F` and gives `2 dW/dC̄`, so that its stress turns with the body whatever
//! it computes. It must be isotropic, since elements see the undeformed body in axes of their own. It is called for all
//! points of some packs at once.

mod check;
mod number;
mod stage;

use super::description::Description;
use super::family::{Law, Origin};
use super::step::MaterialStep;
use super::table::Number;

use crate::error::FemError;
use clubface_math::Scalar;
use std::any::Any;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Arc, PoisonError, RwLock};

pub(super) use number::Points;

/// A law of the change of shape, called for `count` points at once and by several threads at a time.
///
/// What it reads and writes stands in rows of `count` numbers, one of each point:
/// * `shapes`: `C̄ = J^(-2/3) F^T F`, whose determinant is one, six rows: xx, yy, zz, xy, xz, yz,
/// * `constants`: those of the material, SI,
/// * `step`: time since the last call for these points, s; 0 where nothing may move on,
/// * `states`: the state variables, a row each, zero before any deformation; the function moves them on,
/// * `results`: `2 dW/dC̄` (Pa), six rows as those of `shapes`, but for any multiple of `C̄^-1`; the elastic energy
///   W (J/m3); the energy that became heat so far (J/m3), which is zero unless it is written.
pub type LawFunction = unsafe extern "C" fn(
    count: usize,
    shapes: *const f64,
    constants: *const f64,
    step: f64,
    states: *mut f64,
    results: *mut f64,
);

/// Most constants that it may have, and most state variables.
pub const OWN_NUMBERS: usize = 64;
/// Rows of `C̄`.
const SHAPES: usize = 6;
/// Rows of stress and energies.
const RESULTS: usize = 8;
/// The row of the elastic energy; that of what became heat is the next.
const ENERGY: usize = 6;

/// What stands in the place of the description of a law of the table.
const DESCRIPTION: Description = Description {
    name: "own",
    summary: "a function of C",
    source: "whoever registered it",
    constants: &[],
    needed: 0,
    group: 1,
    listed: false,
    state: &[],
    cost: 40,
    example: &[],
};

/// A function with what it is called, over no number in particular.
#[derive(Clone)]
pub struct OwnFunction {
    name: String,
    constants: Vec<String>,
    /// State variables of a point before any deformation.
    states: Vec<f64>,
    function: LawFunction,
}

impl fmt::Debug for OwnFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OwnFunction").field("name", &self.name).finish_non_exhaustive()
    }
}

impl OwnFunction {
    /// A function with the names of its constants and the number of its state variables.
    ///
    /// # Errors
    /// [`FemError::Input`] for more constants or state variables than there may be.
    ///
    /// # Safety
    /// The function does what [`LawFunction`] says, for as long as this program runs.
    pub unsafe fn new(
        name: &str,
        constants: Vec<String>,
        states: usize,
        function: LawFunction,
    ) -> Result<Self, FemError> {
        for (what, count) in [("number of constants", constants.len()), ("number of state variables", states)]
        {
            if count > OWN_NUMBERS {
                let allowed = format!("it must be at most {OWN_NUMBERS}");
                return Err(FemError::input(format!("{what} of {name}"), count, allowed));
            }
        }
        Ok(Self { name: name.to_owned(), constants, states: vec![0.0; states], function })
    }
    /// Names of its constants.
    #[must_use]
    pub fn constants(&self) -> &[String] {
        &self.constants
    }
    /// As a law of materials, with its constants (SI).
    ///
    /// # Errors
    /// [`FemError::Input`] for another number of constants.
    pub fn law<R: Number>(self: &Arc<Self>, constants: &[R]) -> Result<Arc<dyn Law<R>>, FemError> {
        if constants.len() != self.constants.len() {
            let names = if self.constants.is_empty() { "none".to_owned() } else { self.constants.join(", ") };
            let (name, allowed) = (&self.name, format!("it needs {names}"));
            return Err(FemError::input(format!("constants of {name}"), constants.len(), allowed));
        }
        Ok(Arc::new(OwnLaw { function: Arc::clone(self), constants: constants.into() }))
    }
}

/// Functions by name.
static REGISTERED: RwLock<BTreeMap<String, Arc<OwnFunction>>> = RwLock::new(BTreeMap::new());

/// Makes a function a law that materials name; one of the same name is replaced, but for the materials that have it.
/// Returns its shear modulus of small strains, Pa.
///
/// # Errors
/// [`FemError::Input`] for the name of a law of the package, and for what [`Law::check`] refuses with these constants.
pub fn register_law(function: OwnFunction, constants: &[f64]) -> Result<f64, FemError> {
    let name = function.name.clone();
    let taken = super::LAWS.iter().any(|entry| entry.description.name == name) || name == "energy";
    if name.is_empty() || taken {
        return Err(FemError::input("name", format!("{name:?}"), "it must be one that no other law has"));
    }
    let function = Arc::new(function);
    let law = function.law(constants)?;
    law.check(&name)?;
    REGISTERED.write().unwrap_or_else(PoisonError::into_inner).insert(name, function);
    Ok(law.shear())
}

/// The function of a name.
#[must_use]
pub fn registered(name: &str) -> Option<Arc<OwnFunction>> {
    REGISTERED.read().unwrap_or_else(PoisonError::into_inner).get(name).map(Arc::clone)
}

/// A function with its constants.
#[derive(Clone, Debug)]
pub(super) struct OwnLaw<R> {
    function: Arc<OwnFunction>,
    constants: Arc<[R]>,
}

impl<R: Number> Law<R> for OwnLaw<R> {
    fn origin(&self) -> Origin<'_> {
        Origin::Own(&self.function)
    }
    fn description(&self) -> &'static Description {
        const { &DESCRIPTION }
    }
    fn state(&self) -> &[f64] {
        &self.function.states
    }
    fn constants(&self) -> &[R] {
        &self.constants
    }
    fn shear(&self) -> R {
        let mut moduli = self.shear_moduli().into_iter();
        // The largest: the stable step follows from it.
        moduli.next().map_or(R::zero(), |first| moduli.fold(first, Scalar::max))
    }
    fn check(&self, name: &str) -> Result<(), FemError> {
        self.check_values(name)
    }
    fn stage(&self, step: &MaterialStep<R>, slot: &mut dyn Any) {
        R::stage(self, step, slot);
    }
}
