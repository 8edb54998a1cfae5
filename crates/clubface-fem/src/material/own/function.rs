//! The function itself, with the names of its constants, and those that are registered.

use crate::error::FemError;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Arc, PoisonError, RwLock};

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
pub(super) const SHAPES: usize = 6;
/// Rows of stress and energies.
pub(super) const RESULTS: usize = 8;
/// The row of the elastic energy; that of what became heat is the next.
pub(super) const ENERGY: usize = 6;

/// A function with what it is called, over no number in particular.
#[derive(Clone)]
pub struct OwnFunction {
    pub(super) name: String,
    pub(super) constants: Vec<String>,
    /// State variables of a point before any deformation.
    pub(super) states: Vec<f64>,
    pub(super) function: LawFunction,
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
    /// The name of the law.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
    /// Names of its constants.
    #[must_use]
    pub fn constants(&self) -> &[String] {
        &self.constants
    }
    /// Makes it one that is [`registered`] by its name.
    pub fn register(self: &Arc<Self>) {
        let mut all = REGISTERED.write().unwrap_or_else(PoisonError::into_inner);
        all.insert(self.name.clone(), Arc::clone(self));
    }
}

/// Functions by name.
static REGISTERED: RwLock<BTreeMap<String, Arc<OwnFunction>>> = RwLock::new(BTreeMap::new());

/// The function of a name.
#[must_use]
pub fn registered(name: &str) -> Option<Arc<OwnFunction>> {
    REGISTERED.read().unwrap_or_else(PoisonError::into_inner).get(name).map(Arc::clone)
}
