"""The restitution of a driver by the characteristic time of its face: the constants of equipment/restitution.py.

Prints, for the built-in driver and the ball ``modern``, the restitution at 160 ft/s by finite elements over the
characteristic time, a polynomial in even powers of the time through the rigid face, how well it fits, and the pairs of
the Equipment Rules.
"""

from __future__ import annotations

import numpy as np

import clubface
from clubface.equipment import clubs
from clubface.fem import head_tests
from clubface.support.checks import without_warnings

TIMES = np.arange(0, 401, 25)
"""Characteristic times [us]."""
RULES = {239: 0.822, 257: 0.830}
"""Restitutions that the rules pair with characteristic times [us]."""


def computed(time: float) -> float:
    """Return the restitution by finite elements of the driver with a face of this characteristic time [us]."""
    with without_warnings():
        return head_tests.restitution(clubface.club("driver").replace(characteristic_time=time * 1e-6))


if __name__ == "__main__":
    values = np.array([computed(float(time)) for time in TIMES])
    square = (TIMES * 1e-6 / clubs.UNIT) ** 2
    powers = square[:, None] ** np.arange(1, 1 + len(clubs.GAIN))
    gain, *_ = np.linalg.lstsq(powers[1:], values[1:] - values[0], rcond=None)
    off = values - values[0] - powers @ gain
    for time, value, misfit in zip(TIMES, values, off, strict=True):
        print(f"{time:3d} us: {value:.5f}, off the fit by {misfit:+.5f}")
    print(f"RIGID = {values[0]:.4f}")
    print("GAIN = (" + ", ".join(f"{each:.3e}" for each in gain) + ")", f"to {abs(off).max():.5f}")
    for time, rule in RULES.items():
        print(f"{time} us: {computed(time):.4f}, the rules {rule}")
