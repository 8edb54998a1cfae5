//! Expressions as a graph: equal parts stand there once, operands before what uses them, and derivatives are further
//! parts of the same graph.

use clubface_math::{Mask, Scalar};
use std::collections::HashMap;

/// A part of an expression, by its place in the [`Graph`].
pub type Id = usize;

/// Most parts of a graph: far more than the energy of any rubber needs, and few enough to be computed at every point.
pub const MOST_PARTS: usize = 4096;

/// The largest whole exponent that is taken by multiplications.
const WHOLE_POWER: f64 = 64.0;

/// Below zero by no more than rounding: an invariant less its value at rest, such as `I1 - 3`.
const ROUNDING: f64 = -1e-9;

/// What stands in an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// A number, by its bits, so that equal ones are found.
    Number(u64),
    /// A constant of the material.
    Constant(usize),
    /// An invariant: 0 for the first, 1 for the second.
    Invariant(usize),
    /// `-a`.
    Negative(Id),
    /// `a + b`.
    Sum(Id, Id),
    /// `a - b`.
    Difference(Id, Id),
    /// `a b`.
    Product(Id, Id),
    /// `a / b`.
    Quotient(Id, Id),
    /// `a^b`, neither a whole exponent nor a half one: these become products and roots.
    Power(Id, Id),
    /// `exp(a)`.
    Exponential(Id),
    /// `log(a)`, the natural logarithm.
    Logarithm(Id),
    /// `sqrt(a)`.
    Root(Id),
}

impl Part {
    /// Its operands.
    pub fn operands(self) -> impl Iterator<Item = Id> {
        let both = match self {
            Self::Number(_) | Self::Constant(_) | Self::Invariant(_) => [None, None],
            Self::Negative(a) | Self::Exponential(a) | Self::Logarithm(a) | Self::Root(a) => [Some(a), None],
            Self::Sum(a, b)
            | Self::Difference(a, b)
            | Self::Product(a, b)
            | Self::Quotient(a, b)
            | Self::Power(a, b) => [Some(a), Some(b)],
        };
        both.into_iter().flatten()
    }
}

/// The root of a number: zero where rounding alone has put it below zero.
#[inline(always)]
pub fn root<S: Scalar>(a: S) -> S {
    let below = S::select(a.ge(S::from_f64(ROUNDING)), S::zero(), S::from_f64(f64::NAN));
    S::select(a.gt(S::zero()), a.sqrt(), below)
}

/// `exp(a)`, which keeps what is no number.
#[inline(always)]
pub fn exponential<S: Scalar>(a: S) -> S {
    S::select(a.le(a), a.exp(), a)
}

/// The natural logarithm: of no number below zero.
#[inline(always)]
pub fn logarithm<S: Scalar>(a: S) -> S {
    S::select(a.gt(S::zero()), a.ln(), S::from_f64(f64::NAN))
}

/// `a^b`: zero where rounding alone has put `a` below zero.
#[inline(always)]
pub fn power<S: Scalar>(a: S, b: S) -> S {
    let defined = a.ge(S::from_f64(ROUNDING)).and(b.gt(S::zero()));
    let below = S::select(defined, S::zero(), S::from_f64(f64::NAN));
    S::select(a.gt(S::zero()), exponential(a.ln() * b), below)
}

/// Some expressions with all their parts.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    parts: Vec<Part>,
    /// Whether a part depends on an invariant.
    varies: Vec<bool>,
    places: HashMap<Part, Id>,
    full: bool,
}

impl Graph {
    /// All parts, operands first.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }
    /// Whether a part depends on an invariant.
    pub fn varies(&self, a: Id) -> bool {
        self.varies[a]
    }
    /// Whether parts were left out since there were too many.
    pub fn full(&self) -> bool {
        self.full
    }

    fn add(&mut self, part: Part) -> Id {
        if let Some(&place) = self.places.get(&part) {
            return place;
        }
        if self.parts.len() >= MOST_PARTS {
            self.full = true;
            return 0;
        }
        let varies = matches!(part, Part::Invariant(_)) || part.operands().any(|a| self.varies[a]);
        self.parts.push(part);
        self.varies.push(varies);
        self.places.insert(part, self.parts.len() - 1);
        self.parts.len() - 1
    }

    /// The value of a part that is a number.
    fn value(&self, a: Id) -> Option<f64> {
        match self.parts[a] {
            Part::Number(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }
    /// Whether a part is a certain number.
    pub fn is(&self, a: Id, number: f64) -> bool {
        self.value(a) == Some(number)
    }

    /// A number.
    pub fn number(&mut self, value: f64) -> Id {
        // One zero: they are different bits.
        self.add(Part::Number((value + 0.0).to_bits()))
    }
    /// A constant of the material.
    pub fn constant(&mut self, index: usize) -> Id {
        self.add(Part::Constant(index))
    }
    /// An invariant.
    pub fn invariant(&mut self, index: usize) -> Id {
        self.add(Part::Invariant(index))
    }

    /// The number that an operation of two numbers gives, if it is one.
    fn folded(&mut self, a: Id, b: Id, operation: impl Fn(f64, f64) -> f64) -> Option<Id> {
        let value = operation(self.value(a)?, self.value(b)?);
        value.is_finite().then(|| self.number(value))
    }

    /// `-a`.
    pub fn negative(&mut self, a: Id) -> Id {
        match self.parts[a] {
            Part::Number(bits) => self.number(-f64::from_bits(bits)),
            Part::Negative(b) => b,
            Part::Difference(b, c) => self.difference(c, b),
            _ => self.add(Part::Negative(a)),
        }
    }
    /// `a + b`.
    pub fn sum(&mut self, a: Id, b: Id) -> Id {
        if let Some(number) = self.folded(a, b, |a, b| a + b) {
            return number;
        }
        if self.is(a, 0.0) {
            return b;
        }
        if self.is(b, 0.0) {
            return a;
        }
        if let Part::Negative(b) = self.parts[b] {
            return self.difference(a, b);
        }
        if let Part::Negative(a) = self.parts[a] {
            return self.difference(b, a);
        }
        if let Some(alike) = self.alike(a, b, Self::sum) {
            return alike;
        }
        self.add(Part::Sum(a.min(b), a.max(b)))
    }
    /// `k x` and `l x` as one term, `(k + l) x` or `(k - l) x`, if these are what `a` and `b` are.
    fn alike(&mut self, a: Id, b: Id, operation: fn(&mut Self, Id, Id) -> Id) -> Option<Id> {
        let (k, x) = self.factor(a);
        let (l, y) = self.factor(b);
        if x != y || !self.varies[x] {
            return None;
        }
        let one = self.number(1.0);
        let factor = operation(self, k.unwrap_or(one), l.unwrap_or(one));
        Some(self.product(factor, x))
    }
    /// A part as a factor that does not vary, if there is one, times what is left.
    fn factor(&self, a: Id) -> (Option<Id>, Id) {
        match self.parts[a] {
            Part::Product(k, x) if !self.varies[k] => (Some(k), x),
            _ => (None, a),
        }
    }
    /// `a - b`.
    pub fn difference(&mut self, a: Id, b: Id) -> Id {
        if let Some(number) = self.folded(a, b, |a, b| a - b) {
            return number;
        }
        if self.is(b, 0.0) {
            return a;
        }
        if self.is(a, 0.0) {
            return self.negative(b);
        }
        if a == b {
            return self.number(0.0);
        }
        if let Part::Negative(b) = self.parts[b] {
            return self.sum(a, b);
        }
        // One kind of part for `I1 - 3` and `-3 + I1`.
        if let Some(value) = self.value(b) {
            let number = self.number(-value);
            return self.sum(a, number);
        }
        if let Some(alike) = self.alike(a, b, Self::difference) {
            return alike;
        }
        self.add(Part::Difference(a, b))
    }
    /// `a b`: what does not vary is gathered in front, since it is computed once and not at every point.
    pub fn product(&mut self, a: Id, b: Id) -> Id {
        if let Some(number) = self.folded(a, b, |a, b| a * b) {
            return number;
        }
        let (a, b) = if self.varies[a] && !self.varies[b] { (b, a) } else { (a, b) };
        for (one, other) in [(a, b), (b, a)] {
            if self.is(one, 0.0) {
                return one;
            }
            if self.is(one, 1.0) {
                return other;
            }
            if self.is(one, -1.0) {
                return self.negative(other);
            }
            if let Part::Negative(one) = self.parts[one] {
                let product = self.product(one, other);
                return self.negative(product);
            }
        }
        if self.varies[b] {
            // a (c d) = (a c) d for an `a` and a `c` that do not vary, and b (c d) = c (b d).
            if let Part::Product(c, d) = self.parts[b]
                && !self.varies[c]
            {
                let (front, back) =
                    if self.varies[a] { (c, self.product(a, d)) } else { (self.product(a, c), d) };
                return self.product_of(front, back);
            }
            if self.varies[a]
                && let Part::Product(c, d) = self.parts[a]
                && !self.varies[c]
            {
                let back = self.product(d, b);
                return self.product_of(c, back);
            }
            // a (c + d e) = a c + (a d) e: as many operations at a point, or fewer.
            if !self.varies[a]
                && let Part::Sum(c, d) = self.parts[b]
                && (self.scaled(c) && self.scaled(d))
            {
                let (c, d) = (self.product(a, c), self.product(a, d));
                return self.sum(c, d);
            }
            if !self.varies[a]
                && let Part::Difference(c, d) = self.parts[b]
                && (self.scaled(c) && self.scaled(d))
            {
                let (c, d) = (self.product(a, c), self.product(a, d));
                return self.difference(c, d);
            }
        }
        self.product_of(a, b)
    }
    /// A product in which nothing is left to simplify but the numbers that gathering has made.
    fn product_of(&mut self, a: Id, b: Id) -> Id {
        if self.is(a, 0.0) || self.is(b, 1.0) {
            return a;
        }
        if self.is(a, 1.0) {
            return b;
        }
        let (a, b) = if self.varies[a] == self.varies[b] { (a.min(b), a.max(b)) } else { (a, b) };
        self.add(Part::Product(a, b))
    }
    /// Whether another factor that does not vary costs nothing.
    fn scaled(&self, a: Id) -> bool {
        match self.parts[a] {
            _ if !self.varies[a] => true,
            Part::Product(c, _) => !self.varies[c],
            Part::Sum(c, d) | Part::Difference(c, d) => self.scaled(c) && self.scaled(d),
            _ => false,
        }
    }
    /// `a / b`.
    pub fn quotient(&mut self, a: Id, b: Id) -> Id {
        if let Some(number) = self.folded(a, b, |a, b| a / b) {
            return number;
        }
        if self.is(a, 0.0) || self.is(b, 1.0) {
            return a;
        }
        if !self.varies[b] {
            let one = self.number(1.0);
            if self.varies[a] {
                let inverse = self.quotient(one, b);
                return self.product(inverse, a);
            }
        }
        self.add(Part::Quotient(a, b))
    }
    /// `a^b`.
    pub fn power(&mut self, a: Id, b: Id) -> Id {
        if let Some(number) = self.folded(a, b, f64::powf) {
            return number;
        }
        let Some(exponent) = self.value(b) else {
            return self.add(Part::Power(a, b));
        };
        if exponent.abs() > WHOLE_POWER || (2.0 * exponent).fract() != 0.0 {
            return self.add(Part::Power(a, b));
        }
        let size = exponent.abs();
        let mut product = self.number(1.0);
        if size.fract() != 0.0 {
            product = self.root(a);
        }
        let (mut square, mut left) = (a, size as u32);
        while left > 0 {
            if left % 2 == 1 {
                product = self.product(product, square);
            }
            left /= 2;
            if left > 0 {
                square = self.product(square, square);
            }
        }
        if exponent < 0.0 {
            let one = self.number(1.0);
            product = self.quotient(one, product);
        }
        product
    }
    /// `exp(a)`.
    pub fn exponential(&mut self, a: Id) -> Id {
        if self.is(a, 0.0) { self.number(1.0) } else { self.add(Part::Exponential(a)) }
    }
    /// `log(a)`.
    pub fn logarithm(&mut self, a: Id) -> Id {
        if self.is(a, 1.0) { self.number(0.0) } else { self.add(Part::Logarithm(a)) }
    }
    /// `sqrt(a)`.
    pub fn root(&mut self, a: Id) -> Id {
        self.add(Part::Root(a))
    }

    /// The derivative of an expression by an invariant.
    pub fn derivative(&mut self, of: Id, by: usize) -> Id {
        let zero = self.number(0.0);
        // Parts that derivatives add stand behind and are not differentiated.
        let mut slopes: Vec<Id> = Vec::with_capacity(of + 1);
        for part in 0..=of {
            let slope = if self.varies[part] { self.slope(part, by, &slopes) } else { zero };
            slopes.push(slope);
        }
        slopes[of]
    }
    fn slope(&mut self, part: Id, by: usize, slopes: &[Id]) -> Id {
        match self.parts[part] {
            Part::Number(_) | Part::Constant(_) => self.number(0.0),
            Part::Invariant(index) => self.number(f64::from(u8::from(index == by))),
            Part::Negative(a) => self.negative(slopes[a]),
            Part::Sum(a, b) => self.sum(slopes[a], slopes[b]),
            Part::Difference(a, b) => self.difference(slopes[a], slopes[b]),
            Part::Product(a, b) => {
                let (one, other) = (self.product(slopes[a], b), self.product(a, slopes[b]));
                self.sum(one, other)
            }
            Part::Quotient(a, b) => {
                // (a' - (a / b) b') / b.
                let behind = self.product(part, slopes[b]);
                let above = self.difference(slopes[a], behind);
                self.quotient(above, b)
            }
            Part::Power(a, b) => {
                // b a^(b - 1) a' + a^b log(a) b'.
                let one = self.number(1.0);
                let less = self.difference(b, one);
                let lower = self.power(a, less);
                let factor = self.product(b, lower);
                let first = self.product(factor, slopes[a]);
                if self.is(slopes[b], 0.0) {
                    return first;
                }
                let logarithm = self.logarithm(a);
                let factor = self.product(part, logarithm);
                let second = self.product(factor, slopes[b]);
                self.sum(first, second)
            }
            Part::Exponential(a) => self.product(part, slopes[a]),
            Part::Logarithm(a) => self.quotient(slopes[a], a),
            Part::Root(a) => {
                let half = self.number(0.5);
                let above = self.product(half, slopes[a]);
                self.quotient(above, part)
            }
        }
    }

    /// The values of all parts up to the last of interest.
    pub fn values<S: Scalar>(&self, last: Id, constants: &[S], invariants: [S; 2]) -> Vec<S> {
        let mut values: Vec<S> = Vec::with_capacity(last + 1);
        for part in &self.parts[..=last] {
            let value = match *part {
                Part::Number(bits) => S::from_f64(f64::from_bits(bits)),
                Part::Constant(index) => constants[index],
                Part::Invariant(index) => invariants[index],
                Part::Negative(a) => -values[a],
                Part::Sum(a, b) => values[a] + values[b],
                Part::Difference(a, b) => values[a] - values[b],
                Part::Product(a, b) => values[a] * values[b],
                Part::Quotient(a, b) => values[a] / values[b],
                Part::Power(a, b) => power(values[a], values[b]),
                Part::Exponential(a) => exponential(values[a]),
                Part::Logarithm(a) => logarithm(values[a]),
                Part::Root(a) => root(values[a]),
            };
            values.push(value);
        }
        values
    }
}
