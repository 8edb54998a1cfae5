//! One contact with its history: what an integrator of the bodies' motion holds and asks.

use super::friction::{Effort, Friction, Given};
use super::influence::Influence;
use super::load::{Load, RingMaterial};
use clubface_math::{Computation, Scalar};
use core::any::TypeId;
use std::f64::consts::PI;

/// Rings between two bodies, with the displacements they had at the last committed instant.
#[derive(Clone, Debug)]
pub struct RingContact<S> {
    material: RingMaterial<S>,
    largest_radius: S,
    friction: Friction,
    past: Past<S>,
    now: Now<S>,
    /// What the last solve was given, and its values.
    given: Given<S>,
    values: Given<f64>,
}

/// The committed instant.
#[derive(Clone, Debug)]
struct Past<S> {
    /// Sliding distance, m.
    position: [S; 2],
    /// Displacement u of every ring, m.
    displacement: [Vec<S>; 2],
    /// Its last change per change of `squared_radius` while the contact grew, 1/m.
    drift: [Vec<S>; 2],
    /// Squared contact radius, m2, and the number of rings within.
    squared_radius: S,
    contact: usize,
}

/// The instant of the last call of `force`.
#[derive(Clone, Debug)]
struct Now<S> {
    position: [S; 2],
    squared_radius: S,
    /// Tractions in units of `stress`; only those of rings in contact are meant.
    traction: [Vec<S>; 2],
    /// mu p0, Pa.
    stress: S,
    /// (2 - nu)/(8 G) a_max mu p0, m.
    length: S,
}

impl<S: Scalar> RingContact<S> {
    /// `rings` untouched rings up to `largest_radius` (m), which the contact radius should not exceed: tractions beyond
    /// it are left out.
    #[must_use]
    pub fn new(rings: usize, material: RingMaterial<S>, largest_radius: S) -> Self {
        let zero = S::zero();
        let plane = || [vec![zero; rings], vec![zero; rings]];
        Self {
            material,
            largest_radius,
            friction: Friction::new(Influence::shared(rings)),
            past: Past {
                position: [zero; 2],
                displacement: plane(),
                drift: plane(),
                squared_radius: zero,
                contact: 0,
            },
            now: Now {
                position: [zero; 2],
                squared_radius: zero,
                traction: plane(),
                stress: zero,
                length: zero,
            },
            given: Given::new(rings),
            values: Given::new(rings),
        }
    }

    /// Friction force (N) along y' and z' on the first body, after the first body has slid over the second by
    /// `position` (m, from any origin that stays). A function of its arguments and the committed history alone.
    ///
    /// Never beyond mu F_N: the quadrature over rings, which would be by up to 1.6% (20 rings, a > a_max/5) while a new
    /// ring is half loaded, is cut off there.
    #[inline(always)]
    pub fn force(&mut self, position: [S; 2], load: Load<S>) -> [S; 2] {
        S::outline(Force { contact: self, position, load })
    }

    #[inline(always)]
    fn force_of(&mut self, position: [S; 2], load: Load<S>) -> [S; 2] {
        let touches = load.force.re() > 0.0 && load.radius.re() > 0.0;
        self.now.position = position;
        self.now.squared_radius = if touches { load.radius.squared() } else { S::zero() };
        let mut contact = 0;
        if touches && self.material.friction.re() > 0.0 {
            let fraction = load.radius.re() / self.largest_radius.re();
            contact = self.friction.influence().radius().partition_point(|&r| r < fraction);
        }
        if contact == 0 {
            self.friction.lift_off();
            return [S::zero(); 2];
        }
        let limit = self.material.friction * load.force;
        self.now.stress = limit * (1.5 / PI) / self.now.squared_radius;
        let compliance = (-self.material.poisson + 2.0) / (self.material.modulus * 8.0);
        self.now.length = compliance * self.largest_radius * self.now.stress;
        self.solve(contact);
        let unit = self.now.stress * self.largest_radius.squared();
        let mut force = [S::zero(); 2];
        for axis in 0..2 {
            let weights = self.friction.influence().force();
            for (traction, weight) in self.now.traction[axis][..contact].iter().zip(weights) {
                force[axis] += *traction * *weight;
            }
            force[axis] = force[axis] * unit;
        }
        let squared = force[0].squared() + force[1].squared();
        if squared.re() > limit.re() * limit.re() {
            let scale = limit / squared.sqrt();
            return [force[0] * scale, force[1] * scale];
        }
        force
    }

    /// Tractions of the first `contact` rings.
    #[inline(always)]
    fn solve(&mut self, contact: usize) {
        let (past, now, given) = (&self.past, &mut self.now, &mut self.given);
        let radius = &self.friction.influence().radius()[..contact];
        let squared_reach = self.largest_radius.squared();
        let squared_ratio = squared_reach / now.squared_radius;
        let inverse = now.length.recip();
        let slid = [now.position[0] - past.position[0], now.position[1] - past.position[1]];
        for j in 0..contact {
            let squared = radius[j] * radius[j];
            given.bound[j] = (-(squared_ratio * squared) + 1.0).sqrt();
            // What the ring would have slipped by without traction since its history began: at the last commit, or
            // later, when it was touched.
            let (mut share, mut wait) = (S::one(), S::zero());
            if j >= past.contact {
                wait = squared_reach * squared - past.squared_radius;
                share = -(wait / (now.squared_radius - past.squared_radius)) + 1.0;
            }
            for axis in 0..2 {
                let displacement = past.displacement[axis][j] + past.drift[axis][j] * wait;
                given.free[axis][j] = (slid[axis] * share - displacement) * inverse;
            }
        }
        let values = &mut self.values;
        for j in 0..contact {
            values.bound[j] = given.bound[j].re();
            values.free[0][j] = given.free[0][j].re();
            values.free[1][j] = given.free[1][j].re();
        }
        let bound = &values.bound[..contact];
        self.friction.solve(bound, [&values.free[0][..contact], &values.free[1][..contact]]);
        // f64 has no derivatives to carry.
        if TypeId::of::<S>() == TypeId::of::<f64>() {
            for axis in 0..2 {
                for j in 0..contact {
                    now.traction[axis][j] = S::from_f64(self.friction.traction()[axis][j]);
                }
            }
        } else {
            given.keep_changes(contact);
            self.friction.differentiate(given, &mut now.traction);
            for axis in 0..2 {
                for j in 0..contact {
                    now.traction[axis][j] = now.traction[axis][j] + self.friction.traction()[axis][j];
                }
            }
        }
    }

    /// Makes the instant of the last call of [`Self::force`] the history that later slips start from.
    #[inline(always)]
    pub fn commit(&mut self) {
        S::outline(Commit { contact: self });
    }

    #[inline(always)]
    fn commit_now(&mut self) {
        let influence = self.friction.influence();
        let contact = self.friction.contact();
        let growth = self.now.squared_radius - self.past.squared_radius;
        for axis in 0..2 {
            let (displacement, drift) = (&mut self.past.displacement[axis], &mut self.past.drift[axis]);
            // Where the contact grows, `drift` holds the displacement before until its change is known.
            let grows = growth.re() > 0.0;
            if grows {
                drift.copy_from_slice(displacement);
            }
            displacement.fill(S::zero());
            let columns = influence.displacement().chunks_exact(influence.stride());
            for (column, traction) in columns.zip(&self.now.traction[axis][..contact]) {
                let traction = *traction * self.now.length;
                for (entry, factor) in displacement.iter_mut().zip(column) {
                    *entry += traction * *factor;
                }
            }
            if grows {
                let inverse = growth.recip();
                for (drift, displacement) in drift.iter_mut().zip(&*displacement) {
                    *drift = (*displacement - *drift) * inverse;
                }
            }
        }
        self.past.position = self.now.position;
        self.past.squared_radius = self.now.squared_radius;
        self.past.contact = contact;
    }

    /// The history: sliding distance along both axes, squared contact radius, rings in contact, and of every ring its
    /// displacement and the drift of it, each along the first axis and then along the second.
    #[must_use]
    pub fn history(&self) -> Vec<S> {
        let Past { position, displacement, drift, squared_radius, contact } = &self.past;
        let mut values = position.to_vec();
        values.extend([*squared_radius, S::from_f64(*contact as f64)]);
        values.extend(displacement.iter().chain(drift).flatten());
        values
    }

    /// Takes up a history that [`Self::history`] has read from a contact of as many rings.
    pub fn set_history(&mut self, values: &[S]) {
        let rings = self.rings();
        let (head, of_rings) = values.split_at(4);
        self.past.position = [head[0], head[1]];
        self.past.squared_radius = head[2];
        self.past.contact = (head[3].re() as usize).min(rings);
        let all = self.past.displacement.iter_mut().chain(&mut self.past.drift);
        for (own, given) in all.zip(of_rings.chunks_exact(rings)) {
            own.copy_from_slice(given);
        }
    }

    /// Number of rings.
    #[must_use]
    pub fn rings(&self) -> usize {
        self.friction.influence().rings()
    }
    /// Largest contact radius the rings reach to, a_max, m.
    #[must_use]
    pub fn largest_radius(&self) -> S {
        self.largest_radius
    }
    /// Mid-radius of ring `j`, m.
    #[must_use]
    pub fn radius(&self, j: usize) -> S {
        self.largest_radius * self.friction.influence().radius()[j]
    }
    /// Traction (Pa) of ring `j` on the first body at the last call of [`Self::force`].
    #[must_use]
    pub fn traction(&self, j: usize) -> [S; 2] {
        if j >= self.friction.contact() {
            return [S::zero(); 2];
        }
        [0, 1].map(|axis| self.now.traction[axis][j] * self.now.stress)
    }
    /// Slip (m) of ring `j` since the last commit, at the last call of [`Self::force`]: zero where it sticks or does
    /// not touch.
    #[must_use]
    pub fn slip(&self, j: usize) -> [f64; 2] {
        if j >= self.friction.contact() {
            return [0.0; 2];
        }
        [0, 1].map(|axis| self.friction.slip()[axis][j] * self.now.length.re())
    }
    /// Whether ring `j` touched and stuck at the last call of [`Self::force`].
    #[must_use]
    pub fn sticks(&self, j: usize) -> bool {
        j < self.friction.contact() && self.friction.sticks()[j]
    }
    /// Rings in contact at the last call of [`Self::force`]: the innermost ones.
    #[must_use]
    pub fn contact(&self) -> usize {
        self.friction.contact()
    }
    /// Tangential displacement (m) of the first body's surface at ring `j` at the last commit.
    #[must_use]
    pub fn displacement(&self, j: usize) -> [S; 2] {
        [0, 1].map(|axis| self.past.displacement[axis][j])
    }
    /// Work of the last call of [`Self::force`].
    #[must_use]
    pub fn effort(&self) -> Effort {
        self.friction.effort()
    }
}

struct Force<'a, S> {
    contact: &'a mut RingContact<S>,
    position: [S; 2],
    load: Load<S>,
}

impl<S: Scalar> Computation for Force<'_, S> {
    type Output = [S; 2];
    #[inline(always)]
    fn run(self) -> [S; 2] {
        self.contact.force_of(self.position, self.load)
    }
}

struct Commit<'a, S> {
    contact: &'a mut RingContact<S>,
}

impl<S: Scalar> Computation for Commit<'_, S> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        self.contact.commit_now();
    }
}
