"""Which masses and inertia tensors a rigid body can have; pure Python, so that no check loads numpy."""

from __future__ import annotations

import math

from clubface import units
from clubface.errors import InputError

Tensor = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]

ROUNDING = 1e-9
"""Relative slack of the triangle inequality: a flat plate meets it with equality, up to rounding."""


def principal_moments(tensor: Tensor) -> tuple[float, float, float]:
    """Return the eigenvalues [kg m2] of a symmetric tensor, ascending (Jacobi rotations, error about 1e-15)."""
    a = [list(row) for row in tensor]
    for _ in range(30):
        off = max(abs(a[0][1]), abs(a[0][2]), abs(a[1][2]))
        if off <= 1e-17 * max(abs(a[0][0]), abs(a[1][1]), abs(a[2][2]), 1e-300):
            break
        for p, q in ((0, 1), (0, 2), (1, 2)):
            if a[p][q] == 0.0:
                continue
            half = 0.5 * math.atan2(2.0 * a[p][q], a[q][q] - a[p][p])
            cosine, sine = math.cos(half), math.sin(half)
            for k in range(3):
                a[k][p], a[k][q] = cosine * a[k][p] - sine * a[k][q], sine * a[k][p] + cosine * a[k][q]
            for k in range(3):
                a[p][k], a[q][k] = cosine * a[p][k] - sine * a[q][k], sine * a[p][k] + cosine * a[q][k]
    low, middle, high = sorted((a[0][0], a[1][1], a[2][2]))
    return low, middle, high


def check_positive(parameter: str, value: float, unit: str) -> None:
    """Refuse a value [SI, named by ``unit``] that is not finite and above zero."""
    if not (math.isfinite(value) and value > 0.0):
        raise InputError(parameter, value, f"above 0 {unit}")


def check_inertia(tensor: Tensor) -> None:
    """Refuse an inertia tensor [kg m2] no rigid body has.

    Its principal moments must be positive, and each at most the sum of the other two: no mass is negative.
    """
    moments = principal_moments(tensor)
    shown = ", ".join(f"{units.from_si(moment, 'g cm2'):.5g}" for moment in moments)
    if moments[0] <= 0.0:
        raise InputError(
            "inertia", f"principal moments {shown} g cm2", "positive definite: every principal moment above 0"
        )
    if moments[2] > (moments[0] + moments[1]) * (1.0 + ROUNDING):
        raise InputError(
            "inertia",
            f"principal moments {shown} g cm2",
            "one whose largest principal moment is at most the sum of the others (triangle inequality)",
        )
