"""Random swings of the size of elite golfers' swings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from clubface import units
from clubface.equipment.clubs import Club, club as club_of
from clubface.equipment.models import DEFAULT_MODEL
from clubface.motion_capture.synthetic.path import Chain, Turn
from clubface.motion_capture.synthetic.synthetic_swing import SyntheticSwing, swing

DELIVERIES: Mapping[str, Mapping[str, tuple[float, float]]] = {
    "wood": {
        "speed": (49.2, 1.8), "attack": (1.0, 2.5), "path": (1.0, 3.0), "loft": (13.0, 1.7), "face": (0.5, 2.0),
        "lie": (1.0, 1.5), "toe": (2.0, 8.0), "high": (2.0, 5.0),
    },
    "iron": {
        "speed": (40.0, 1.5), "attack": (-4.0, 1.5), "path": (0.5, 2.5), "loft": (23.0, 2.0), "face": (0.5, 2.0),
        "lie": (0.0, 1.5), "toe": (2.0, 6.0), "high": (0.0, 4.0),
    },
}  # fmt: skip
"""Mean and standard deviation of deliveries [m/s, deg, mm]: of the size of elite golfers' swings (those of Caldwell and
McPhee (2023) hit drives at 101 to 118 mph). Chosen and not measured: no test of an estimator depends on them."""

_TO_SI = {"speed": 1.0, "toe": 1e-3, "high": 1e-3}
FARTHEST = 2.5
"""Standard deviations to which draws are cut, so that every impact is on the face."""


def random_swing(
    seed: int | np.random.Generator,
    *,
    club: str | Club = "driver",
    hand: str | None = None,
    model: str = DEFAULT_MODEL,
    **wanted: float,
) -> SyntheticSwing:
    """Return a random swing of the size of an elite golfer's.

    Its face closes by 3 to 4 degrees a frame at 720 Hz, as Caldwell and McPhee (2023) report.

    Parameters
    ----------
    seed
        The same seed gives the same swing.
    club
        The club.
    hand
        "right" or "left"; that of the club if left out.
    model
        The model of the impact, with its published parameters.
    **wanted
        Values to use instead of random ones [SI]: ``speed``, ``attack``, ``path``, ``loft``, ``face``, ``lie``,
        ``toe``, ``high``; path and face as for a right-hander.
    """
    random = np.random.default_rng(seed)
    head = club_of(club) if hand is None else club_of(club).replace(hand=hand)
    iron = head.kind == "iron"
    asked = {}
    for name, (mean, deviation) in DELIVERIES["iron" if iron else "wood"].items():
        drawn = mean + deviation * float(np.clip(random.normal(), -FARTHEST, FARTHEST))
        asked[name] = wanted.get(name, drawn * _TO_SI.get(name, units.size("deg")))
    return swing(head, random_chain(random, iron=iron), asked, model)


def random_chain(random: np.random.Generator, *, iron: bool) -> Chain:
    """Return a chain with the lengths, rates and vibrations of a golfer."""

    def between(low: float, high: float, size: int | None = None) -> Any:
        return random.uniform(low, high, size)

    def vibrating(amplitude: float, slow: float, fast: float) -> dict[str, float]:
        return {"amplitude": between(0.0, amplitude), "frequency": between(slow, fast), "phase": between(0.0, 6.28)}

    return Chain(
        plane=units.to_si(between(54.0, 60.0) if iron else between(45.0, 51.0), "deg"),
        arm=Turn(rate=between(15.0, 18.0), width=between(0.10, 0.14), peak=between(-0.06, -0.03)),
        club=Turn(
            rate=between(36.0, 40.0), width=between(0.060, 0.085), peak=between(-0.010, 0.008),
            **vibrating(0.01, 8.0, 14.0),
        ),
        roll=Turn(
            rate=between(18.0, 32.0), width=between(0.04, 0.06), peak=between(-0.01, 0.02),
            **vibrating(0.01, 10.0, 18.0),
        ),
        arm_length=between(0.60, 0.70),
        club_length=between(0.80, 0.86) if iron else between(1.00, 1.08),
        arm_start=between(0.0, 0.25),
        hub=between(0.01, 0.03, 3),
        hub_frequency=between(1.0, 2.5, 3),
        hub_phase=between(0.0, 6.28, 3),
        bend=between(0.001, 0.004, 3),
        bend_frequency=between(10.0, 18.0, 3),
        bend_phase=between(0.0, 6.28, 3),
        cg=np.array([0.015, -0.02, 0.02]) if iron else np.array([0.0, -0.02, 0.04]),
    )  # fmt: skip
