//! Density and viscosity of air, and pressure at altitude.
//!
//! Density is the CIPM-2007 equation of state (A. Picard, R. S. Davis, M. Glaeser and K. Fujii, Metrologia 45, 2008,
//! 149-155) for 400 ppm of CO2. Its authors vouch for 22 ppm between 600 and 1100 hPa and 15 and 27 C; beyond that it
//! remains a real-gas law with saturation over liquid water, far better than golf needs.
//!
//! The defaults are 25 C (77 F) and sea level, to which TrackMan normalises by default (its blog,
//! "Normalization feature explained", 2014), and so the conditions to compare published carries in. It states no
//! humidity; 50 % is assumed here, and the whole range from dry to saturated changes the density by only 1.2 %.

use clubface_math::Scalar;

/// Temperature to which launch monitors normalise by default, 25 C in K.
pub const DEFAULT_TEMPERATURE: f64 = 298.15;
/// Standard pressure at sea level, Pa.
pub const DEFAULT_PRESSURE: f64 = 101_325.0;
/// Relative humidity taken where none is given, 0 to 1.
pub const DEFAULT_HUMIDITY: f64 = 0.5;

const ICE_POINT: f64 = 273.15;

/// Density of moist air, kg/m3.
///
/// `temperature` in K, `pressure` in Pa, `humidity` relative to saturation over water, 0 to 1.
///
/// rho = (p Ma / (Z R T)) (1 - x_v (1 - Mv/Ma)), with x_v = h f(p, t) p_sv(T) / p.
#[inline(always)]
pub fn density<S: Scalar>(temperature: S, pressure: S, humidity: S) -> S {
    let t = temperature - ICE_POINT;
    let enhancement = pressure * 3.14e-8 + t.squared() * 5.6e-7 + 1.000_62;
    let vapour = humidity * enhancement * saturation_pressure(temperature) / pressure;
    let ratio = pressure / temperature;
    let first = t * (t * 1.1043e-10 - 2.9331e-8)
        + 1.581_23e-6
        + (t * -2.051e-8 + 5.707e-6) * vapour
        + (t * -2.376e-6 + 1.9898e-4) * vapour.squared();
    let second = vapour.squared() * -0.765e-8 + 1.83e-11;
    let compressibility = -(ratio * first) + ratio.squared() * second + 1.0;
    // 3.483740e-3 kg K/J is Ma/R, and 0.3780 is 1 - Mv/Ma.
    ratio * 3.483_740e-3 / compressibility * (-(vapour * 0.3780) + 1.0)
}

/// Saturation pressure of water vapour over liquid water, Pa; temperature in K (CIPM-2007).
#[inline(always)]
pub fn saturation_pressure<S: Scalar>(temperature: S) -> S {
    (temperature.squared() * 1.237_884_7e-5 - temperature * 1.912_131_6e-2 + 33.937_110_47
        - temperature.recip() * 6.343_164_5e3)
        .exp()
}

/// Dynamic viscosity of dry air by Sutherland's formula with the constants of the standard atmosphere (ISO 2533), Pa s.
///
/// Vapour makes air less viscous, saturation at 25 C by 1 %, which a drag coefficient does not notice.
#[inline(always)]
pub fn viscosity<S: Scalar>(temperature: S) -> S {
    temperature * temperature.sqrt() * 1.458e-6 / (temperature + 110.4)
}

/// Pressure of the standard atmosphere (ISO 2533, troposphere) at a geopotential altitude in m, Pa.
///
/// It supplies the pressure alone: temperature stays an input of its own.
#[must_use]
pub fn pressure_at_altitude(altitude: f64) -> f64 {
    // 0.0065 K/m over 288.15 K; the exponent is g M / (R L).
    DEFAULT_PRESSURE * (1.0 - altitude * 0.0065 / 288.15).powf(5.255_88)
}
