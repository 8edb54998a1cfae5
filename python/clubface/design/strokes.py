"""Expected strokes to hole out from where a ball lies, by Broadie's PGA Tour averages.

M. Broadie (2012) gives averages by distance and lie, M. Broadie (2011) averages for putts. They are interpolated
linearly between the distances of a table, constant below the first, and extrapolated from the last two.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import _core as core, published_data, units
from clubface.errors import InputError, Wording
from clubface.schema import Choice, PhysicalValue, check_values, file_key
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice

LIES = ("tee", "fairway", "rough", "sand", "recovery")
GREEN = "green"
AT_REST = (GREEN, "fairway", "rough", "recovery")
"""Lies in which a ball comes to rest; holes here have no bunkers."""
FAIRWAY_WIDTH = units.parse("32 yd", "length")
"""Default width of a fairway; assumed, about as on tour courses."""
ROUGH_WIDTH = units.parse("20 yd", "length")
"""Default width of the rough on either side; assumed. A ball beyond it lies among trees: "recovery"."""
LONGEST = 2000.0
"""Largest length or width of a hole [m]."""
GREEN_RADIUS = units.parse("12 yd", "length")
"""Default radius of a green around the hole; assumed: a circle of about 420 m2."""


WIDTH = PhysicalValue("m", 0, LONGEST)


@dataclass(frozen=True, kw_only=True)
class Hole:
    """A straight, level hole; values are text with a unit or SI numbers."""

    length: float = file_key(PhysicalValue("m", above=0, upper=LONGEST), "distance from the tee to the hole")
    fairway: float = file_key(WIDTH, "width of the fairway", default=FAIRWAY_WIDTH)
    rough: float = file_key(
        WIDTH, "width of the rough on either side; a ball beyond it is a recovery shot", default=ROUGH_WIDTH
    )
    green: float = file_key(WIDTH, "radius of the green about the hole", default=GREEN_RADIUS)
    lie: str = file_key(Choice(LIES), "lie of the shot", default="tee")

    def __post_init__(self) -> None:
        check_values(self)

    def describe(self) -> str:
        """Return the hole in words."""
        length, fairway, rough, green = (
            f"{units.from_si(each, 'yd'):g} yd" for each in (self.length, self.fairway, self.rough, self.green)
        )
        return (
            f"{length} from the {self.lie}, straight and level; fairway {fairway} wide, {rough} of rough on either"
            f" side, green of {green} radius"
        )

    def before(self) -> float:
        """Return the strokes expected before the shot."""
        return float(expected(self.lie, np.array([self.length]))[0])

    def after(self, ahead: Floats, right: Floats) -> Floats:
        """Return the strokes expected from where balls have come to rest.

        ``ahead`` and ``right`` are positions from the tee, towards the hole and right of the line [m], shape (n,).
        """
        return self.at_rest(ahead, right)[1]

    def lies(self, ahead: Floats, right: Floats) -> NDArray[np.str_]:
        """Return the lie of balls at rest: "green", "fairway", "rough" or "recovery", shape (n,)."""
        return self.at_rest(ahead, right)[0]

    def at_rest(self, ahead: Floats, right: Floats) -> tuple[NDArray[np.str_], Floats]:
        """Return lies and expected strokes of balls at rest, as :meth:`lies` and :meth:`after`."""
        ahead, right = _places(ahead, right)
        tables = [as_lists(lie) for lie in AT_REST]
        hole = (self.length, self.fairway, self.rough, self.green)
        lies, strokes = core.hole_strokes(np.ravel(ahead), np.ravel(right), hole, tables)
        return np.array(AT_REST)[lies].reshape(ahead.shape), strokes.reshape(ahead.shape)


def expected(lie: str, distance: Floats) -> Floats:
    """Return the mean number of strokes PGA Tour players take to hole out.

    ``lie`` is one of ``LIES``, or "green", and ``distance`` is measured from the hole [m].
    """
    distance = np.asarray(units.parse_values(distance, "length", name="distance"))
    return core.strokes_at(*as_lists(lie), np.ravel(distance)).reshape(distance.shape)


def _places(ahead: Any, right: Any) -> tuple[Floats, Floats]:
    given = {"ahead": ahead, "right": right}
    places = [np.asarray(units.parse_values(each, "length", name=name)) for name, each in given.items()]
    if places[0].shape != places[1].shape:
        shapes = Wording(" and ".join(f"of shape {each.shape}" for each in places))
        raise InputError("ahead and right", shapes, "of the same shape")
    return places[0], places[1]


@cache
def as_lists(lie: str) -> tuple[list[float], list[float]]:
    """Return the table of a lie: distances [m] and strokes."""
    check_choice("lie", lie, (*LIES, GREEN))
    table = published_data.table("putts-to-hole-out" if lie == GREEN else "strokes-to-hole-out")
    strokes = table["putts" if lie == GREEN else lie]
    printed = np.isfinite(strokes)
    return table["distance"][printed].tolist(), strokes[printed].tolist()
