//! Runge-Kutta and Rosenbrock steppers in which every lane has its own step.
//!
//! A pack of shots advances together, but each lane accepts, rejects and sizes its own steps and is frozen once it
//! has finished, so its result does not depend on its neighbours, bit for bit. Step sizes carry no derivatives.

mod chosen_method;
mod integrate;
mod problem;
mod rate;
mod rosenbrock;
mod runge_kutta;
mod step_size;

pub use chosen_method::ChosenMethod;
pub use integrate::{Observer, Outcome, integrate};
pub use problem::{Attempt, Method, StiffSystem, System};
pub use rosenbrock::Rosenbrock;
pub use runge_kutta::{BOGACKI_SHAMPINE, DORMAND_PRINCE, RK4, RungeKutta};
pub use step_size::Control;
