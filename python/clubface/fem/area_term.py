"""Arakawa's law of friction, with its term of the contact area, held against finite elements."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.errors import InputError
from clubface.fem.result import Impact

SLIDES = 0.1
"""The ball slides where its surface moves faster than this along the face [m/s]; the law's tanh is then 1."""
WITHIN = (0.05, 0.95)
"""Share of the contact that is looked at: at both ends a few nodes make the area."""
LEAST = 20


class AreaTerm(NamedTuple):
    """The law F = mu F_N + mu eta dA/dt as far as a run of finite elements follows it.

    Attributes
    ----------
    sliding
        Share of the contact in which the ball slides.
    damping
        eta [N s/m2] that fits F - mu F_N best while it slides, with the friction of the run for mu; NaN if it hardly
        slides.
    explained
        Share of the squares of F - mu F_N that the term explains there.
    free_friction, free_damping, free_explained
        mu and eta that fit F best over the whole contact, and the share of its squares that they explain.
    time, normal, tangential, area, rate
        Times within the contact [s], both forces [N], area [m2] and its rate [m2/s], averaged over a tenth of the
        contact.
    sinking
        The loss of the distance from mass centre to face at these times, the d of A = pi R d [m].
    """

    sliding: float
    damping: float
    explained: float
    free_friction: float
    free_damping: float
    free_explained: float
    time: NDArray[Any]
    normal: NDArray[Any]
    tangential: NDArray[Any]
    area: NDArray[Any]
    rate: NDArray[Any]
    sinking: NDArray[Any]


def area_term(found: Impact) -> AreaTerm:
    """Return how Arakawa's law, as the model ``area`` has it, describes a finished impact.

    Finite elements have Coulomb's friction at every node and no term of the area, so what comes out is what elastic
    grip looks like through this law.
    """
    if found.stopped is not None or not found.contact_time > 0.0:
        raise InputError("impact", found, "a complete one")
    over = found.contact["time"]
    step, last, motion = over[1] - over[0], found.contact_time, found.motion
    # Nodes come and go ring by ring: what happens within the time between two rings is not the law of area.
    width = max(3, int(0.1 * last / step) | 1)

    def smooth(values: Any) -> Any:
        return np.convolve(values, np.ones(width) / width, "same")

    area = smooth(found.contact["area"])
    within = (over > WITHIN[0] * last) & (over < WITHIN[1] * last)
    curves = (smooth(found.contact["normal"]), smooth(found.contact["tangential"]), area)
    rate = smooth(np.gradient(area, step))
    normal, tangential, area, rate = (each[within] for each in (*curves, rate))
    time = over[within]
    slip = found.relative_velocity()[:, 1] - motion["spin"][:, 2] * motion["radius"]
    slides = np.interp(time, motion["time"], slip) > SLIDES
    sinking = 0.5 * found.ball.diameter - np.interp(time, motion["time"], motion["radius"])

    mu = found.friction
    damping, explained = float("nan"), float("nan")
    if slides.sum() >= LEAST and mu > 0.0:
        (damping,), explained = _fit(mu * rate[slides, None], (tangential - mu * normal)[slides])
    (free, slope), free_explained = _fit(np.stack([normal, rate], axis=1), tangential)
    return AreaTerm(
        float(slides.mean()), damping, explained, free, slope / free, free_explained,
        time, normal, tangential, area, rate, sinking,
    )  # fmt: skip


def _fit(columns: Any, wanted: Any) -> tuple[list[float], float]:
    """Return the factors of columns that fit best, and the share of the squares that they explain."""
    factors = np.linalg.lstsq(columns, wanted, rcond=None)[0]
    left = wanted - columns @ factors
    return factors.tolist(), float(1.0 - (left @ left) / (wanted @ wanted))
