//! Units: every symbol a person may write or read, its dimension, and its value in SI units.

/// A unit: SI value = value * numerator / denominator + offset.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Unit {
    /// How it is written.
    pub symbol: &'static str,
    /// Other spellings, separated by commas; blanks, `^`, `*` and raised digits do not count.
    #[cfg_attr(feature = "serde", serde(serialize_with = "split_at_commas"))]
    pub spellings: &'static str,
    /// What it measures.
    pub dimension: &'static str,
    /// SI value of a unit is `numerator / denominator`, two numbers that are exact.
    pub numerator: f64,
    /// See [`Unit::numerator`].
    pub denominator: f64,
    /// SI value of its zero.
    pub offset: f64,
}

/// A unit and how many digits people read behind the point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading {
    /// Symbol of the unit.
    pub unit: &'static str,
    /// Digits behind the point.
    pub digits: usize,
}

/// What a unit measures, and how people read it unless a quantity says otherwise.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Dimension {
    /// Name.
    pub name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// How people read it in metric units.
    pub metric: Reading,
    /// How golfers read it.
    pub golf: Reading,
}

/// Serializes spellings as a list.
#[cfg(feature = "serde")]
fn split_at_commas<S: serde::Serializer>(text: &str, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(text.split_terminator(','))
}

#[cfg(feature = "serde")]
impl serde::Serialize for Reading {
    /// As (unit, digits behind the point).
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (self.unit, self.digits).serialize(serializer)
    }
}

const fn multiple(
    dimension: &'static str,
    symbol: &'static str,
    spellings: &'static str,
    size: (f64, f64),
) -> Unit {
    Unit { symbol, spellings, dimension, numerator: size.0, denominator: size.1, offset: 0.0 }
}

const fn from_zero_at(offset: f64, unit: Unit) -> Unit {
    Unit { offset, ..unit }
}

const PI: f64 = core::f64::consts::PI;

/// All units, the SI unit of a dimension before its others.
#[rustfmt::skip]
pub static UNITS: &[Unit] = &[
    multiple("speed", "m/s", "mps,m_s", (1.0, 1.0)),
    multiple("speed", "mph", "mi/h,MPH", (44704.0, 1e5)),
    multiple("speed", "km/h", "kmh,kph,km_h", (10.0, 36.0)),
    multiple("speed", "ft/s", "fps,ft_s", (3048.0, 1e4)),
    multiple("angle", "rad", "radians", (1.0, 1.0)),
    multiple("angle", "deg", "degrees,degree,°", (PI, 180.0)),
    multiple("length", "m", "metres,meters", (1.0, 1.0)),
    multiple("length", "mm", "", (1.0, 1e3)),
    multiple("length", "cm", "", (1.0, 1e2)),
    multiple("length", "in", "inch,inches", (254.0, 1e4)),
    multiple("length", "yd", "yard,yards,yds", (9144.0, 1e4)),
    multiple("length", "ft", "feet,foot", (3048.0, 1e4)),
    multiple("area", "m2", "", (1.0, 1.0)),
    multiple("area", "cm2", "", (1.0, 1e4)),
    multiple("area", "mm2", "", (1.0, 1e6)),
    multiple("volume", "m3", "", (1.0, 1.0)),
    multiple("volume", "cm3", "cc,ml", (1.0, 1e6)),
    multiple("mass", "kg", "", (1.0, 1.0)),
    multiple("mass", "g", "grams,gram", (1.0, 1e3)),
    multiple("mass", "oz", "", (28_349_523_125.0, 1e12)),
    multiple("inertia", "kg m2", "", (1.0, 1.0)),
    multiple("inertia", "g cm2", "", (1.0, 1e7)),
    multiple("mass moment", "kg m", "", (1.0, 1.0)),
    multiple("mass moment", "g cm", "", (1.0, 1e5)),
    multiple("angular rate", "rad/s", "radps,rad_s", (1.0, 1.0)),
    multiple("angular rate", "deg/s", "degps,deg_s,°/s", (PI, 180.0)),
    multiple("angular rate", "rpm", "rev/min,RPM", (PI, 30.0)),
    multiple("temperature", "K", "kelvin", (1.0, 1.0)),
    from_zero_at(273.15, multiple("temperature", "degC", "C,°C,degc,celsius", (1.0, 1.0))),
    from_zero_at(273.15 - 160.0 / 9.0, multiple("temperature", "degF", "F,°F,degf,fahrenheit", (5.0, 9.0))),
    multiple("pressure", "Pa", "pa", (1.0, 1.0)),
    multiple("pressure", "hPa", "mbar,hpa", (100.0, 1.0)),
    multiple("pressure", "kPa", "kpa", (1e3, 1.0)),
    multiple("pressure", "MPa", "N/mm2", (1e6, 1.0)),
    multiple("pressure", "GPa", "", (1e9, 1.0)),
    multiple("pressure", "inHg", "inhg", (3386.389, 1.0)),
    multiple("time", "s", "seconds,sec", (1.0, 1.0)),
    multiple("time", "ms", "", (1.0, 1e3)),
    multiple("time", "us", "µs,μs", (1.0, 1e6)),
    multiple("force", "N", "n", (1.0, 1.0)),
    multiple("force", "kN", "kn", (1e3, 1.0)),
    multiple("energy", "J", "", (1.0, 1.0)),
    multiple("density", "kg/m3", "kg_m3", (1.0, 1.0)),
    multiple("density", "g/cm3", "g_cm3", (1e3, 1.0)),
    multiple("volumetric stiffness", "N/m3", "", (1.0, 1.0)),
    multiple("inverse speed", "s/m", "", (1.0, 1.0)),
    multiple("inverse speed", "ms/m", "", (1.0, 1e3)),
    multiple("rotary stiffness", "N m/rad", "N m", (1.0, 1.0)),
    multiple("rotary damping", "N m s/rad", "N m s", (1.0, 1.0)),
    multiple("area damping", "N s/m2", "Pa s", (1.0, 1.0)),
    multiple("dimensionless", "1", "-", (1.0, 1.0)),
    multiple("dimensionless", "%", "percent,pct", (1.0, 1e2)),
];

/// The unit called `symbol`; spellings are not looked at.
#[must_use]
pub const fn unit(symbol: &str) -> Option<&'static Unit> {
    let mut i = 0;
    while i < UNITS.len() {
        if same(UNITS[i].symbol, symbol) {
            return Some(&UNITS[i]);
        }
        i += 1;
    }
    None
}

/// Whether two texts are the same, for constants.
pub(crate) const fn same(one: &str, other: &str) -> bool {
    let (one, other) = (one.as_bytes(), other.as_bytes());
    let mut i = 0;
    while i < one.len() && i < other.len() && one[i] == other[i] {
        i += 1;
    }
    i == one.len() && i == other.len()
}

macro_rules! dimensions {
    ($(
        $constant:ident $name:literal [$unit:literal], $metric:literal $metric_digits:literal,
        $golf:literal $golf_digits:literal;
    )+) => {
        $(
            #[doc = concat!("Dimension ", $name, ".")]
            pub const $constant: Dimension = Dimension {
                name: $name,
                unit: $unit,
                metric: Reading { unit: $metric, digits: $metric_digits },
                golf: Reading { unit: $golf, digits: $golf_digits },
            };
        )+
        /// All dimensions.
        pub static DIMENSIONS: &[Dimension] = &[$($constant),+];
    };
}

dimensions! {
    SPEED "speed" ["m/s"], "m/s" 1, "mph" 1;
    ANGLE "angle" ["rad"], "deg" 1, "deg" 1;
    LENGTH "length" ["m"], "m" 1, "m" 1;
    AREA "area" ["m2"], "m2" 2, "m2" 2;
    VOLUME "volume" ["m3"], "cm3" 0, "cm3" 0;
    MASS "mass" ["kg"], "g" 1, "g" 1;
    INERTIA "inertia" ["kg m2"], "g cm2" 0, "g cm2" 0;
    MASS_MOMENT "mass moment" ["kg m"], "g cm" 0, "g cm" 0;
    ANGULAR_RATE "angular rate" ["rad/s"], "rpm" 0, "rpm" 0;
    TEMPERATURE "temperature" ["K"], "degC" 1, "degC" 1;
    PRESSURE "pressure" ["Pa"], "hPa" 1, "hPa" 1;
    TIME "time" ["s"], "s" 2, "s" 2;
    FORCE "force" ["N"], "N" 0, "N" 0;
    ENERGY "energy" ["J"], "J" 2, "J" 2;
    DENSITY "density" ["kg/m3"], "kg/m3" 0, "kg/m3" 0;
    VOLUMETRIC_STIFFNESS "volumetric stiffness" ["N/m3"], "N/m3" 0, "N/m3" 0;
    INVERSE_SPEED "inverse speed" ["s/m"], "s/m" 4, "s/m" 4;
    ROTARY_STIFFNESS "rotary stiffness" ["N m/rad"], "N m/rad" 2, "N m/rad" 2;
    ROTARY_DAMPING "rotary damping" ["N m s/rad"], "N m s/rad" 4, "N m s/rad" 4;
    AREA_DAMPING "area damping" ["N s/m2"], "N s/m2" 0, "N s/m2" 0;
    DIMENSIONLESS "dimensionless" ["1"], "1" 3, "1" 3;
}
