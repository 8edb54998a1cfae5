"""The characteristic time of a face that goes with a coefficient of restitution."""

from __future__ import annotations

from clubface.errors import InputError

RIGID = 0.7762
"""Coefficient of restitution of the built-in driver with a rigid face, struck in front of its CG by the ball ``modern``
at 160 ft/s (48.8 m/s), by finite elements."""
GAIN = (8.355e-3, 3.975e-6, -2.081e-5, 5.893e-7)
"""Gain of the same head with a face that gives: coefficients of even powers of the characteristic time in units of 100
us, from the second on. They fit finite elements up to 400 us to 0.0003 (``python studies/face_restitution.py``)."""
UNIT = 100e-6
RANGE = (0.778, 0.86)
"""Restitutions that a face may be given: those of 46 to 377 us."""


def restitution(characteristic_time: float) -> float:
    """Return the coefficient of restitution at 160 ft/s that goes with a characteristic time [s] of up to 400 us."""
    square = (characteristic_time / UNIT) ** 2
    gain = 0.0
    for coefficient in reversed(GAIN):
        gain = (gain + coefficient) * square
    return RIGID + gain


def characteristic_time_of(cor: float) -> float:
    """Return the characteristic time [s] that goes with a coefficient of restitution at 160 ft/s, by bisection."""
    least, most = RANGE
    if not least <= cor <= most:
        rigid = f"a rigid face has {RIGID:.3f} with the ball modern: leave it out for that"
        raise InputError("cor", cor, f"from {least} to {most} at 160 ft/s; {rigid}")
    low, high = 0.0, 400e-6
    while (middle := 0.5 * (low + high)) not in (low, high):
        low, high = (middle, high) if restitution(middle) < cor else (low, middle)
    return high
