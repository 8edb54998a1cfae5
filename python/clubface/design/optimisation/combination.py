"""One club as it can be put together in a fitting, and how it is told."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from clubface import units

SETTINGS = ("loft", "lie", "cg_x", "cg_y", "cg_z")
"""What a setting of a head may change."""
WORDS = {
    "loft": ("more loft", "less loft"), "lie": ("more upright", "flatter"),
    "cg_x": ("back", "forward"), "cg_y": ("lower", "higher"),
    "cg_z": ("closer to the heel", "closer to the toe"),
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
    """Write a combination in words: "driver with the ball modern, the setting "back" and 1.0 deg more loft"."""
    parts = [f"{each.club} with the ball {each.ball}", *([f'the setting "{each.setting}"'] if each.setting else [])]
    changed = told(each.changes)
    return ", ".join([*parts, changed] if changed else parts)


def told(changes: Mapping[str, float]) -> str:
    """Write the changes of a setting: "1.0 deg more loft, CG 3.0 mm forward"; nothing where none changes."""
    return ", ".join("CG " * name.startswith("cg") + words for name, words in in_words(changes).items())


def in_words(changes: Mapping[str, float]) -> dict[str, str]:
    """Return each change that counts in words: "1.0 deg more loft" and "3.0 mm forward"."""
    parts = {}
    for name, change in changes.items():
        unit = "deg" if name in ("loft", "lie") else "mm"
        size = f"{abs(units.from_si(change, unit)):.1f}"
        if float(size):
            parts[name] = f"{size} {unit} {WORDS[name][change < 0.0]}"
    return parts
