//! A sphere on a rigid plane: the case the rings were published for (Maw, Barber and Fawcett 1976), kept as their
//! verification and as the smallest example of how to use them.

use super::contact::RingContact;
use super::load::{Load, RingMaterial};
use super::steps::RingSteps;
use clubface_math::Scalar;
use clubface_math::ode::{BOGACKI_SHAMPINE, Method, System};
use core::cell::RefCell;

/// An elastic sphere that hits a rigid plane.
///
/// Normal force k x^1.5 with Hertz's k = 8 G sqrt(R)/(3 (1 - nu)), contact radius sqrt(R x), lever of friction R.
#[derive(Clone, Copy, Debug)]
pub struct Sphere<S> {
    /// Mass m, kg.
    pub mass: S,
    /// Radius R, m.
    pub radius: S,
    /// Moment of inertia about a diameter, in units of m R^2.
    pub inertia_ratio: S,
    /// Elasticity and friction.
    pub material: RingMaterial<S>,
}

/// How finely to integrate.
#[derive(Clone, Copy, Debug)]
pub struct Resolution {
    /// Number of rings.
    pub rings: usize,
    /// Steps while the contact grows by one ring.
    pub steps_per_ring: usize,
    /// Longest step as a fraction of the duration of contact.
    pub longest_step: f64,
}

/// The sphere after impact.
#[derive(Clone, Debug)]
pub struct Rebound<S> {
    /// Tangential velocity of the surface at the contact point, m/s.
    pub surface_velocity: [S; 2],
    /// Speed away from the plane, m/s.
    pub speed: S,
    /// Calls of [`RingContact::force`].
    pub solves: usize,
}

/// Penetration, its rate, sliding distance along y' and z', and sliding velocity.
type State<S> = [S; 6];

struct Motion<'a, S> {
    sphere: &'a Sphere<S>,
    /// Hertz stiffness, N/m^1.5.
    stiffness: S,
    rings: RefCell<RingContact<S>>,
    solves: RefCell<usize>,
}

impl<S: Scalar> System<S, 6> for Motion<'_, S> {
    fn rhs(&self, y: &State<S>) -> State<S> {
        let depth = y[0].max(S::zero());
        let normal = self.stiffness * depth.pow_three_halves();
        let load = Load { force: normal, radius: (self.sphere.radius * depth).safe_sqrt() };
        let friction = self.rings.borrow_mut().force([y[2], y[3]], load);
        *self.solves.borrow_mut() += 1;
        let inverse_mass = self.sphere.mass.recip();
        let mobility = (self.sphere.inertia_ratio.recip() + 1.0) * inverse_mass;
        [y[1], -(normal * inverse_mass), y[4], y[5], friction[0] * mobility, friction[1] * mobility]
    }
}

impl<S: Scalar> Sphere<S> {
    /// The non-dimensional speed of Maw, Barber and Fawcett, psi = 2 (1 - nu) Vx/(mu (2 - nu) Vz), per Vx at
    /// normal speed Vz `speed`, s/m.
    pub fn psi_per_velocity(&self, speed: S) -> S {
        let RingMaterial { friction, poisson, .. } = self.material;
        (-poisson + 1.0) * 2.0 / (friction * (-poisson + 2.0) * speed)
    }

    /// Impact at normal speed `speed` with tangential velocity `surface_velocity` of the surface, m/s.
    pub fn bounce(&self, speed: S, surface_velocity: [S; 2], resolution: Resolution) -> Rebound<S> {
        let stiffness =
            self.material.modulus * self.radius.sqrt() * (8.0 / 3.0) / (-self.material.poisson + 1.0);
        // The first pass, in closed form: all of the normal energy is in the spring.
        let deepest = (self.mass * speed.squared() * 1.25 / stiffness).powf(0.4);
        let largest_radius = (self.radius * deepest).sqrt() * 1.001;
        let motion = Motion {
            sphere: self,
            stiffness,
            rings: RefCell::new(RingContact::new(resolution.rings, self.material, largest_radius)),
            solves: RefCell::new(0),
        };
        let steps = RingSteps {
            rings: resolution.rings,
            steps_per_ring: resolution.steps_per_ring,
            largest_depth: largest_radius.squared() / self.radius,
            longest: deepest / speed * (2.943 * resolution.longest_step),
        };
        let zero = S::zero();
        let mut y = [zero, speed, zero, zero, surface_velocity[0], surface_velocity[1]];
        let mut rate = motion.rhs(&y);
        motion.rings.borrow_mut().commit();
        while y[0].re() > 0.0 || y[1].re() > 0.0 {
            let h = steps.next(y[0], y[1], rate[1]);
            let step = BOGACKI_SHAMPINE.attempt(&motion, &y, &rate, h);
            motion.rings.borrow_mut().commit();
            (y, rate) = (step.y, step.rate);
        }
        Rebound { surface_velocity: [y[4], y[5]], speed: -y[1], solves: motion.solves.into_inner() }
    }
}
