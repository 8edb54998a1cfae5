//! Errors of values, as messages tell them.

use crate::error::ImpactError;

/// Digits of a value in a message.
const DIGITS: i32 = 6;

/// A value as messages tell it: six digits, with a power of ten where it is very large or very small.
#[must_use]
pub fn shown(value: f64) -> String {
    let scientific = format!("{value:.*e}", decimals(0));
    let Some((digits, Ok(power))) =
        scientific.split_once('e').map(|(digits, power)| (digits, power.parse::<i32>()))
    else {
        return scientific; // an infinity, or no number
    };
    if (-4..=DIGITS).contains(&power) {
        without_zeros(&format!("{value:.*}", decimals(power))).to_owned()
    } else {
        format!("{}e{power}", without_zeros(digits))
    }
}

/// Decimals with which a value of a power of ten has its digits.
fn decimals(power: i32) -> usize {
    usize::try_from(DIGITS - 1 - power).unwrap_or(0)
}

fn without_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// An input with its value, and what is allowed.
pub(crate) fn fault(name: &'static str, value: f64, allowed: &str) -> ImpactError {
    ImpactError::new(name, format!("{} {allowed}", shown(value)))
}

/// The same for an angle, in degrees.
pub(crate) fn angle_fault(name: &'static str, value: f64, allowed: &str) -> ImpactError {
    ImpactError::new(name, format!("{} deg {allowed}", shown(value.to_degrees())))
}

#[cfg(test)]
mod tests {
    use super::shown;

    #[test]
    fn values_have_six_digits() {
        for (value, text) in [
            (45.6, "45.6"),
            (-26.850_000_000_000_023, "-26.85"),
            (0.0, "0"),
            (-0.0, "-0"),
            (150.0, "150"),
            (1e300, "1e300"),
            (9_999_999.6, "1e7"),
            (4.470_4e-300, "4.4704e-300"),
            (0.000_25, "0.00025"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(shown(value), text);
        }
    }
}
