//! The friction of the rings at one instant: what it was given and what was found.

use super::factors::Factors;
use super::planes::Plane;
use crate::rings::influence::Influence;
use std::sync::Arc;

/// Friction of the rings at one instant; keeps the last solution as the start of the next.
#[derive(Clone, Debug)]
pub struct Friction {
    pub(super) influence: Arc<Influence>,
    /// Rings in contact at the last solve. Rows are padded to blocks of eight: a ring of the last block that is not in
    /// contact slips without traction.
    pub(super) contact: usize,
    /// Bounds b and free slips g.
    pub(super) bound: Vec<f64>,
    pub(super) free: Plane,
    /// Sticking rings.
    pub(super) sticks: Vec<bool>,
    /// Direction of the traction of every slipping ring, a unit vector.
    pub(super) direction: Plane,
    /// Tractions y.
    pub(super) traction: Plane,
    /// Slips s.
    pub(super) slip: Plane,
    /// What the exchanged matrix is applied to, and its result.
    pub(super) known: Plane,
    pub(super) unknown: Plane,
    /// Number of innermost rings, all sticking, whose cached matrix is in use, or none if `matrix` is.
    pub(super) innermost: Option<usize>,
    pub(super) matrix: Vec<f64>,
    /// Slipping rings, and the factors of the Jacobian of their slip directions.
    pub(super) slipping: Vec<usize>,
    pub(super) factors: Factors,
    pub(super) angle: Vec<f64>,
    /// Work of the last solve.
    pub(super) effort: Effort,
}

/// Work of one solve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Products with an exchanged matrix.
    pub products: usize,
    /// Linear solves for the slip directions.
    pub directions: usize,
    /// Gauss-Seidel sweeps.
    pub sweeps: usize,
}

impl Friction {
    /// Friction of rings that have not touched yet.
    #[must_use]
    pub fn new(influence: Arc<Influence>) -> Self {
        let (n, stride) = (influence.rings(), influence.stride());
        let plane = || [vec![0.0; stride], vec![0.0; stride]];
        Self {
            influence,
            contact: 0,
            bound: vec![1.0; stride],
            free: plane(),
            sticks: vec![true; stride],
            direction: [vec![1.0; stride], vec![0.0; stride]],
            traction: plane(),
            slip: plane(),
            known: plane(),
            unknown: plane(),
            innermost: Some(0),
            matrix: Vec::new(),
            slipping: Vec::with_capacity(n),
            factors: Factors::new(n, stride),
            angle: vec![0.0; stride],
            effort: Effort::default(),
        }
    }

    /// Tractions, in units of mu p0, two components of `n` numbers and padding; zero outside the contact.
    #[must_use]
    pub fn traction(&self) -> &Plane {
        &self.traction
    }
    /// Slips of the rings in contact; only theirs are meant.
    #[must_use]
    pub fn slip(&self) -> &Plane {
        &self.slip
    }
    /// Sticking rings; only those in contact count.
    #[must_use]
    pub fn sticks(&self) -> &[bool] {
        &self.sticks
    }
    /// Rings in contact at the last solve.
    #[must_use]
    pub fn contact(&self) -> usize {
        self.contact
    }

    /// The matrices of these rings.
    #[must_use]
    pub fn influence(&self) -> &Influence {
        &self.influence
    }

    /// No ring touches any more.
    pub fn lift_off(&mut self) {
        self.start(0);
        self.effort = Effort::default();
    }

    /// Work of the last solve.
    #[must_use]
    pub fn effort(&self) -> Effort {
        self.effort
    }

    /// Rings that have just come into contact do at first what their neighbour does.
    pub(super) fn start(&mut self, contact: usize) {
        if contact == self.contact {
            return;
        }
        for j in self.contact..contact {
            self.sticks[j] = j == 0 || self.sticks[j - 1];
            for axis in 0..2 {
                let neighbour = if j == 0 { [1.0, 0.0][axis] } else { self.direction[axis][j - 1] };
                self.direction[axis][j] = neighbour;
            }
        }
        self.contact = contact;
        self.sticks[contact..].fill(false);
        self.bound[contact..].fill(1.0);
        for axis in 0..2 {
            for row in [&mut self.direction, &mut self.free, &mut self.traction, &mut self.slip] {
                row[axis][contact..].fill(0.0);
            }
        }
    }
}
