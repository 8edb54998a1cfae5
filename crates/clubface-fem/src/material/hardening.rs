//! How a metal hardens: its yield stress by the equivalent plastic strain p,
//! `Y + sum of h max(0, p - at) + Q (1 - exp(-b p))`.
//!
//! The straight lines hold linear hardening and curves given as tables, the last part is Voce's saturation (J. Inst.
//! Metals 74, 1948).

use crate::error::FemError;
use clubface_math::{Pack, Real, Scalar};

/// Most points of a table.
pub const HARDENING_POINTS: usize = 8;

/// A change of slope.
#[derive(Clone, Copy, Debug)]
struct Bend<S> {
    /// Plastic strain from which on it counts.
    at: S,
    /// By how much, Pa.
    slope: S,
}

/// Yield stress in tension by equivalent plastic strain.
#[derive(Clone, Copy, Debug)]
pub struct Hardening<S> {
    yield_stress: S,
    bends: [Bend<S>; HARDENING_POINTS],
    count: usize,
    gain: S,
    rate: S,
    saturates: bool,
}

impl<R: Real> Hardening<R> {
    /// A metal that yields at a stress (Pa) and does not harden.
    pub fn perfect(yield_stress: R) -> Self {
        let none = Bend { at: R::zero(), slope: R::zero() };
        let bends = [none; HARDENING_POINTS];
        Self { yield_stress, bends, count: 0, gain: R::zero(), rate: R::zero(), saturates: false }
    }
    /// A metal that never yields.
    pub fn elastic() -> Self {
        // The square of it is a number too.
        Self::perfect(R::from_f64(1e150))
    }
    /// Linear hardening: `modulus` (Pa) times the plastic strain.
    pub fn linear(yield_stress: R, modulus: R) -> Self {
        let mut law = Self::perfect(yield_stress);
        law.bends[0].slope = modulus;
        law.count = 1;
        law
    }
    /// The same with a `gain` (Pa) that saturates, to 63% within a plastic strain of 1 / `rate`.
    #[must_use]
    pub fn saturating(mut self, gain: R, rate: R) -> Self {
        (self.gain, self.rate, self.saturates) = (gain, rate, true);
        self
    }
    /// Straight lines between points: plastic strain, the first zero, and yield stress (Pa), constant behind the last.
    ///
    /// # Errors
    /// [`FemError::Input`] for none or too many points, or strains that do not increase from zero; `name` is that of
    /// the metal.
    pub fn table(points: &[(R, R)], name: &str) -> Result<Self, FemError> {
        let subject = format!("{name}.hardening");
        if !(1..=HARDENING_POINTS).contains(&points.len()) {
            let allowed = format!("it must have 1 to {HARDENING_POINTS} points");
            return Err(FemError::input(subject, format!("{} points", points.len()), allowed));
        }
        if points[0].0.re() != 0.0 || points.windows(2).any(|pair| pair[0].0.re() >= pair[1].0.re()) {
            let strains: Vec<_> = points.iter().map(|point| point.0.re().to_string()).collect();
            let allowed = "plastic strains must begin at 0 and increase";
            return Err(FemError::input(subject, strains.join(", "), allowed));
        }
        let mut law = Self::perfect(points[0].1);
        let mut before = R::zero();
        for (i, point) in points.iter().enumerate() {
            let slope = points.get(i + 1).map_or(R::zero(), |next| (next.1 - point.1) / (next.0 - point.0));
            law.bends[i] = Bend { at: point.0, slope: slope - before };
            before = slope;
        }
        law.count = points.len();
        Ok(law)
    }
    /// The same metal in other numbers, each made from its name and value.
    pub fn map<T: Real>(&self, subject: &mut dyn FnMut(&str, R) -> T) -> Hardening<T> {
        let mut law = Hardening::perfect(subject("yield", self.yield_stress));
        for (i, bend) in self.bends[..self.count].iter().enumerate() {
            let at = T::from_f64(bend.at.re());
            law.bends[i] = Bend { at, slope: subject(&format!("hardening.{i}"), bend.slope) };
        }
        law.count = self.count;
        if self.saturates {
            law = law.saturating(subject("gain", self.gain), subject("rate", self.rate));
        }
        law
    }
    /// Checks the constants; messages call the metal `name`.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first value that is not allowed.
    pub fn check(&self, name: &str) -> Result<(), FemError> {
        let yields = self.yield_stress.re();
        if !(yields > 0.0 && yields.is_finite()) {
            let allowed = "it must be above zero and finite";
            return Err(FemError::input(format!("{name}.yield"), format!("{yields} Pa"), allowed));
        }
        let mut slope = 0.0;
        let slopes = self.bends[..self.count].iter().map(|bend| {
            slope += bend.slope.re();
            slope
        });
        // A difference of slopes leaves rounding behind.
        let least = slopes.fold(0.0, f64::min) + 1e-9 * self.bends[0].slope.re().abs();
        for value in [least, self.gain.re(), self.rate.re()] {
            if !(value >= 0.0 && value.is_finite()) {
                let allowed = "the yield stress must not fall with plastic strain, since a metal that softens would fail where it yields first";
                return Err(FemError::input(format!("{name}.hardening"), value, allowed));
            }
        }
        Ok(())
    }
    /// The same in every lane.
    #[inline(always)]
    pub fn splat<P: Pack<Real = R>>(&self) -> Hardening<P> {
        let mut law = Hardening {
            yield_stress: P::splat(self.yield_stress),
            bends: [Bend { at: P::zero(), slope: P::zero() }; HARDENING_POINTS],
            count: self.count,
            gain: P::splat(self.gain),
            rate: P::splat(self.rate),
            saturates: self.saturates,
        };
        for i in 0..self.count {
            law.bends[i] = Bend { at: P::splat(self.bends[i].at), slope: P::splat(self.bends[i].slope) };
        }
        law
    }
    /// Its constants: yield stress, gain, rate, then strain and change of slope of each bend.
    pub(super) fn constants(&self) -> Vec<R> {
        let mut constants = vec![self.yield_stress, self.gain, self.rate];
        constants.extend(self.bends[..self.count].iter().flat_map(|bend| [bend.at, bend.slope]));
        constants
    }
}

impl<S: Scalar> Hardening<S> {
    /// From [`Hardening::constants`].
    #[inline(always)]
    pub(super) fn from_slice(constants: &[S]) -> Self {
        let count = (constants.len() - 3) / 2;
        let mut bends = [Bend { at: S::zero(), slope: S::zero() }; HARDENING_POINTS];
        for i in 0..count {
            bends[i] = Bend { at: constants[3 + 2 * i], slope: constants[4 + 2 * i] };
        }
        let (gain, rate) = (constants[1], constants[2]);
        Self { yield_stress: constants[0], bends, count, gain, rate, saturates: gain.re() != 0.0 }
    }
    /// Yield stress at the start, Pa.
    #[inline(always)]
    pub fn initial(&self) -> S {
        self.yield_stress
    }
    /// Yield stress (Pa) at an equivalent plastic strain, and its slope (Pa).
    #[inline(always)]
    pub fn at(&self, strain: S) -> (S, S) {
        let (mut stress, mut slope) = (self.yield_stress, S::zero());
        for bend in &self.bends[..self.count] {
            let beyond = strain - bend.at;
            let counts = beyond.ge(S::zero());
            stress += bend.slope * S::select(counts, beyond, S::zero());
            slope += S::select(counts, bend.slope, S::zero());
        }
        if self.saturates {
            let left = self.gain * (-(self.rate * strain)).exp();
            stress += self.gain - left;
            slope += self.rate * left;
        }
        (stress, slope)
    }
}
