//! Quantities: what every number that is computed, measured or drawn is called, and how people read it.
//!
//! Stated here once for all languages: the tables of inputs and outputs, Python, WebAssembly and C take names, units
//! and words from [`QUANTITIES`]. A new quantity is one entry of its table.

mod table;

use crate::unit::{Dimension, Reading, same};
pub use table::QUANTITIES;

/// One quantity.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Quantity {
    /// Name, as in the Python API and in files.
    pub name: &'static str,
    /// Symbol in formulas, with Greek letters by name and `_` before a subscript.
    pub symbol: &'static str,
    /// SI unit, in which it is held.
    pub unit: &'static str,
    /// How people read it in metric units.
    pub metric: Reading,
    /// How golfers read it.
    pub golf: Reading,
    /// What people call it, for tables and axes.
    pub label: &'static str,
    /// What it is, in one line without its sign.
    pub meaning: &'static str,
    /// What positive means; empty for a magnitude.
    pub sign: &'static str,
    /// Words for the sides of negative and positive values, such as left and right, if it has sides.
    pub sides: Option<(&'static str, &'static str)>,
    /// Other names in tables and in the files of launch monitors, in lower case, joined by `_`.
    pub synonyms: &'static [&'static str],
}

impl Quantity {
    /// A magnitude without synonyms that is read as its dimension is.
    const fn new(
        name: &'static str,
        symbol: &'static str,
        dimension: Dimension,
        label: &'static str,
        meaning: &'static str,
    ) -> Self {
        let Dimension { unit, metric, golf, .. } = dimension;
        Self { name, symbol, unit, metric, golf, label, meaning, sign: "", sides: None, synonyms: &[] }
    }

    /// Read in one unit by everybody.
    const fn read(self, unit: &'static str, digits: usize) -> Self {
        Self { metric: Reading { unit, digits }, golf: Reading { unit, digits }, ..self }
    }

    /// Read in metres by some and in yards by golfers.
    const fn in_yards(self) -> Self {
        Self { metric: Reading { unit: "m", digits: 1 }, golf: Reading { unit: "yd", digits: 1 }, ..self }
    }

    /// Read by golfers in another unit.
    const fn for_golfers(self, unit: &'static str, digits: usize) -> Self {
        Self { golf: Reading { unit, digits }, ..self }
    }

    /// With digits behind the point as given, in the units it has.
    const fn digits(self, digits: usize) -> Self {
        let (metric, golf) = (self.metric.unit, self.golf.unit);
        Self { metric: Reading { unit: metric, digits }, golf: Reading { unit: golf, digits }, ..self }
    }

    /// With a sign.
    const fn sign(self, sign: &'static str) -> Self {
        Self { sign, ..self }
    }

    /// With words for negative and positive values.
    const fn sides(self, negative: &'static str, positive: &'static str) -> Self {
        Self { sides: Some((negative, positive)), ..self }
    }

    /// With other names in files.
    const fn synonyms(self, synonyms: &'static [&'static str]) -> Self {
        Self { synonyms, ..self }
    }

    /// Meaning and sign in one line.
    #[must_use]
    pub fn description(&self) -> String {
        match self.sign {
            "" => self.meaning.to_owned(),
            sign => format!("{}: {sign}", self.meaning),
        }
    }
}

/// The quantity called `name`, at compile time: a table that names one that is not there does not compile.
#[must_use]
pub(crate) const fn known(name: &str) -> &'static Quantity {
    match quantity(name) {
        Some(quantity) => quantity,
        None => panic!("this quantity is missing in the table of quantities"),
    }
}

/// Quantities by name, in order, for tables of outputs.
macro_rules! quantities {
    ($($name:ident)+) => { [$($crate::quantity::known(stringify!($name))),+] };
}
pub(crate) use quantities;

/// The quantity called `name`.
#[must_use]
pub const fn quantity(name: &str) -> Option<&'static Quantity> {
    let mut i = 0;
    while i < QUANTITIES.len() {
        if same(QUANTITIES[i].name, name) {
            return Some(&QUANTITIES[i]);
        }
        i += 1;
    }
    None
}
