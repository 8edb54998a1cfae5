"""One input that a study sweeps: a list of values, evenly spaced values, or an interval to draw from."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from clubface import units
from clubface.equipment.described import FLAT
from clubface.errors import InputError
from clubface.support.checks import check_choice, check_count, check_names, is_count

if TYPE_CHECKING:
    from numpy.typing import NDArray

MOST = 10**12
"""Tasks of a study; what is more, no cluster computes."""
FORMS = '["90 mph", "100 mph"], {from = "90 mph", to = "120 mph", count = 31}, or step = "1 mph" in place of the count'
FORM = ("from", "to", "count", "step")
"""The keys of such a table."""
INTERVAL = 'an interval such as {from = "90 mph", to = "120 mph"}, or a list'


class Swept(NamedTuple):
    """What an input is that may be swept.

    Attributes
    ----------
    unit
        Its SI unit, or None for one that holds names, such as that of a club.
    choices
        The names there are; empty where any text is one, or where it holds numbers.
    group
        What a column of a table may name before it, as in ``air_temperature``.
    """

    unit: str | None
    choices: tuple[str, ...] = ()
    group: str = ""


@dataclass(frozen=True, kw_only=True)
class Axis:
    """One swept input.

    Attributes
    ----------
    name
        The input.
    unit
        Its SI unit; None where it holds names, whose places in ``choices`` are then its values.
    choices
        The names.
    values
        The values [SI] of a list.
    ends
        First and last value [SI] of evenly spaced values or of an interval.
    count
        How many values there are; None for an interval.
    """

    name: str
    unit: str | None
    choices: tuple[str, ...] = ()
    values: tuple[float, ...] = ()
    ends: tuple[float, float] = (0.0, 0.0)
    count: int | None = None

    def at(self, places: NDArray[Any]) -> NDArray[Any]:
        """Return the values at places from 0 on; the last of evenly spaced values is the end itself."""
        import numpy as np

        if self.choices:
            return places
        if self.values:
            return np.array(self.values)[places]
        assert self.count is not None
        first, last = self.ends
        shares = places / max(self.count - 1, 1)
        return np.where(places == self.count - 1, last if self.count > 1 else first, first + (last - first) * shares)

    def drawn(self, shares: NDArray[Any]) -> NDArray[Any]:
        """Return the values for shares of 1 in [0, 1): along an interval, or in equal parts for each of a list."""
        import numpy as np

        if self.count is None:
            first, last = self.ends
            return first + (last - first) * shares
        return self.at(np.minimum((shares * self.count).astype(np.int64), self.count - 1))


def axis(name: str, given: Any, swept: Swept) -> Axis:
    """Return the axis that a value of the table [sweep] means.

    Raises
    ------
    InputError
        It is no list and no table of ``from``, ``to`` and ``count`` or ``step``, or a value in it cannot be used.
    """
    if isinstance(given, list):
        return _list(name, given, swept)
    if not isinstance(given, Mapping):
        raise InputError(name, given, f"a list, or a table, as in {FORMS}")
    if swept.unit is None:
        raise InputError(name, dict(given), 'a list of names, as in ["driver", "3-wood"]')
    check_names(f"key of {name}", given, FORM)
    if not ("from" in given and "to" in given) or ("count" in given and "step" in given):
        raise InputError(name, dict(given), f"given as {FORMS}")
    first, last = (number(name, given[key], swept.unit) for key in ("from", "to"))
    if not math.isfinite(last - first):
        raise InputError(name, dict(given), f'finite from end to end; "{FLAT}" is for a list')
    if "count" in given:
        if not is_count(given["count"], 1, MOST):
            raise InputError(f"count of {name}", given["count"], f"a whole number from 1 to {MOST}")
        return Axis(name=name, unit=swept.unit, ends=(first, last), count=given["count"])
    if "step" not in given:
        if not last > first:
            raise InputError(name, dict(given), "an interval whose end is above its beginning")
        return Axis(name=name, unit=swept.unit, ends=(first, last))
    step = number(name, given["step"], swept.unit)
    steps = (last - first) / step if step else -1.0
    if not (steps == 0.0 if first == last else 1.0 - 1e-9 <= steps < MOST):
        raise InputError(f"step of {name}", given["step"], "a step that leads from the first value to the last")
    # What a unit's conversion rounds off does not cost the last value.
    whole = int(steps + 1e-9)
    return Axis(name=name, unit=swept.unit, ends=(first, first + whole * step), count=whole + 1)


def _list(name: str, given: Sequence[Any], swept: Swept) -> Axis:
    if not given:
        raise InputError(name, given, "a list of at least one value")
    if swept.unit is not None:
        values = tuple(number(name, each, swept.unit) for each in given)
        return Axis(name=name, unit=swept.unit, values=values, count=len(values))
    for each in given:
        if not isinstance(each, str):
            raise InputError(name, each, "a name in quotes")
        if swept.choices:
            check_choice(name, each, swept.choices)
    if len(set(given)) < len(given):
        raise InputError(name, given, "a list in which every name stands once")
    return Axis(name=name, unit=None, choices=tuple(given), count=len(given))


def number(name: str, value: Any, unit: str) -> float:
    """Return a value of an input in SI; the bulge and the roll of a face may be "flat"."""
    if value == FLAT and name in ("bulge", "roll"):
        return float("inf")
    return units.parse(value, units.unit(unit).dimension, name=name)


def whole_number(name: str, value: Any, least: int, most: int) -> int:
    """Return a value that counts something; swept, it comes as a float."""
    return check_count(name, int(value) if isinstance(value, float) and value.is_integer() else value, least, most)
