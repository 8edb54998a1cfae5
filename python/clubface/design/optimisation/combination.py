"""One club as it can be put together in a fitting, and how it is told."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from clubface import units

SETTINGS = ("loft", "lie", "cg_x", "cg_y", "cg_z")
"""What a setting of a head may change."""
WORDS = {
    "loft": ("more loft", "less loft"), "lie": ("more upright", "flatter"),
    "cg_x": ("of CG farther back", "of CG farther forward"), "cg_y": ("of CG lower", "of CG higher"),
    "cg_z": ("of CG closer to the heel", "of CG closer to the toe"),
}  # fmt: skip
"""What a positive and a negative change of a setting mean; the CG is told by where the face centre is from it."""


class Combination(NamedTuple):
    """One club as it can be put together.

    Attributes
    ----------
    club
        Its name.
    ball
        The name of the ball.
    setting
        The name of the setting of the head, "" where there are none.
    changes
        What loft, lie and CG are changed by [SI]; adjusted values among them.
    value
        What it is judged by [SI].
    others
        The other numbers of the shots, by name [SI].
    error
        Standard error of the difference from the best [SI], 0 for the best itself.
    place
        Which of :meth:`Fitting.names` it is.
    """

    club: str
    ball: str
    setting: str
    changes: Mapping[str, float]
    value: float
    others: Mapping[str, float]
    error: float
    place: int


def named(each: Combination) -> str:
    """Write a combination in words: "driver with the ball modern, the setting back, 1.0 degrees more loft"."""
    parts = [f"{each.club} with the ball {each.ball}", *([f"the setting {each.setting}"] if each.setting else [])]
    for name, change in each.changes.items():
        unit = "degrees" if name in ("loft", "lie") else "mm"
        size = f"{abs(units.from_si(change, unit.replace('degrees', 'deg'))):.1f}"
        if float(size):
            parts.append(f"{size} {unit} {WORDS[name][change < 0.0]}")
    return ", ".join(parts)


def told(changes: Mapping[str, float]) -> str:
    """Write the changes of a setting: "loft +1 deg, cg_x -3 mm"."""
    parts = []
    for name, change in changes.items():
        unit = "deg" if name in ("loft", "lie") else "mm"
        parts.append(f"{name} {units.from_si(change, unit):+.2f} {unit}")
    return ", ".join(parts)
