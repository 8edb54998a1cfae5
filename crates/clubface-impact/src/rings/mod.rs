//! Concentric rings: tangential contact with sticking and slipping regions (Maw, Barber and Fawcett, Wear 38, 1976,
//! 101-114), in both directions of the plane of contact.
//!
//! The contact disc is cut into n rings. Each sticks or slips, and every traction displaces the surface under all
//! rings, so the force along the face depends on what has happened since first touch and reverses as the stored
//! displacement springs back.
//!
//! * [`influence`]: the constant matrices between tractions and displacements of n rings.
//! * [`friction`]: Coulomb's law for all rings at one instant, exact to 1e-11 with exact derivatives.
//! * [`contact`]: the history. [`RingContact`] knows no bodies, only how far one surface has slid over the other and
//!   what presses them together.
//! * [`steps`]: steps of the integrator that fit the rings.
//! * [`plane`]: a sphere on a rigid plane.
//!
//! # How an integrator uses them
//!
//! The state of the bodies includes the sliding distance (the integral of the sliding velocity along y' and z').
//! [`RingContact::force`] gives the friction of any trial state reached from the last accepted one; when a step is
//! accepted whose last evaluation was at its end (true of methods with the first same as last),
//! [`RingContact::commit`] makes that evaluation the new history. Rejected trials leave no trace.
//!
//! ```
//! use clubface_impact::rings::{Load, RingContact, RingMaterial};
//! let material = RingMaterial { friction: 0.36, poisson: 0.4, modulus: 5.6e7 };
//! let mut rings = RingContact::new(20, material, 0.01);
//! let load = Load { force: 8000.0, radius: 0.009 };
//! let [along_y, along_z] = rings.force([20e-6, 0.0], load);
//! assert!(along_y < 0.0 && along_z == 0.0 && rings.sticks(0));
//! rings.commit();
//! // Sliding back by as much leaves a force the other way, because the outer rings slipped on the way there.
//! assert!(rings.force([0.0, 0.0], load)[0] > 0.0);
//! ```

pub mod contact;
pub mod friction;
pub mod influence;
mod load;
pub mod plane;
pub mod steps;

pub use contact::RingContact;
pub use load::{Load, RingMaterial};
pub use steps::RingSteps;
