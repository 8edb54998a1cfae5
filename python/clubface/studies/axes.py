"""One swept input of a study: a list of values, evenly spaced values, or an interval to sample."""

from __future__ import annotations

import math
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.described import FLAT
from clubface.errors import InputError
from clubface.support.checks import check_choice, check_count, check_names, is_count

if TYPE_CHECKING:
    from fractions import Fraction


MOST = 10**12
"""Maximum number of tasks in a study, more than any cluster computes."""
EXACT = 2**53
"""Largest integer up to which floats are exact."""
FORMS = '["90 mph", "100 mph"], {from = "90 mph", to = "120 mph", count = 31}, or step = "1 mph" in place of the count'
FORM = ("from", "to", "count", "step")
"""Keys of an axis table."""
INTERVAL = 'an interval such as {from = "90 mph", to = "120 mph"}, or a list'


class Swept(NamedTuple):
    """Description of an input that may be swept."""

    unit: str | None  # SI unit; None for an input with names, such as a club
    choices: tuple[str, ...] = ()  # allowed names; empty for any text, or for numbers
    group: str = ""  # prefix allowed in column names of a table, as in air_temperature
    limits: tuple[int, int] | None = None  # smallest and largest value of a count; None for any number


@dataclass(frozen=True, kw_only=True)
class SweepAxis:
    """One swept input."""

    name: str
    unit: str | None  # SI unit; None for names
    choices: tuple[str, ...] = ()  # the names, whose indices are then the values
    values: tuple[float, ...] = ()  # of a list [SI]
    ends: tuple[float, float] = (0.0, 0.0)  # first and last of evenly spaced values, or of an interval [SI]
    count: int | None = None  # None for an interval
    spacing: tuple[int, int, int, str] | None = None
    """For evenly spaced values that integers can represent: first value and step, common denominator, and unit."""
    whole: bool = False  # whether an interval contains only whole numbers

    def at(self, places: NDArray[Any]) -> NDArray[Any]:
        """Return the values at indices from 0; evenly spaced values equal those written out as a list."""
        if self.choices:
            return places
        if self.values:
            return np.array(self.values)[places]
        assert self.count is not None
        if self.spacing is not None:
            start, step, denominator, unit = self.spacing
            return units.to_si((start + step * places) / denominator, unit)
        first, last = self.ends
        shares = places / max(self.count - 1, 1)
        return np.where(places == self.count - 1, last if self.count > 1 else first, first + (last - first) * shares)

    def drawn(self, shares: NDArray[Any]) -> NDArray[Any]:
        """Return the values for shares in [0, 1): along an interval, or with equal parts for each value of a list."""
        if self.count is None:
            first, last = self.ends
            return np.floor(first + (last - first + 1.0) * shares) if self.whole else first + (last - first) * shares
        return self.at(np.minimum((shares * self.count).astype(np.int64), self.count - 1))


def axis(name: str, given: Any, swept: Swept) -> SweepAxis:
    """Return the axis for a list in the table [sweep], or a table of ``from``, ``to`` and ``count`` or ``step``."""
    if isinstance(given, list):
        return _list(name, given, swept)
    if not isinstance(given, Mapping):
        raise InputError(name, given, f"a list, or a table, as in {FORMS}")
    if swept.unit is None:
        raise InputError(name, dict(given), 'a list of names, as in ["driver", "3-wood"]')
    check_names(f"key of {name}", given, FORM)
    if not ("from" in given and "to" in given) or ("count" in given and "step" in given):
        raise InputError(name, dict(given), f"given as {FORMS}")
    if FLAT in (given["from"], given["to"]):
        raise InputError(name, dict(given), f'an interval with finite ends; "{FLAT}" is for a list')
    ends = [_check_whole(name, number(name, given[key], swept.unit), swept) for key in ("from", "to")]
    if not math.isfinite(ends[1] - ends[0]):
        raise InputError(name, dict(given), "an interval with finite ends")
    made = SweepAxis(name=name, unit=swept.unit, ends=(ends[0], ends[1]), whole=swept.limits is not None)
    if "count" in given:
        if not is_count(given["count"], 1, MOST):
            raise InputError(f"count of {name}", given["count"], f"a whole number from 1 to {MOST}")
        if given["count"] == 1 and ends[0] != ends[1]:
            raise InputError(f"count of {name}", 1, f"at least 2 for values from {given['from']} to {given['to']}")
        return _spaced(made, given, given["count"], swept)
    if "step" in given:
        return _spaced(made, given, _steps(name, given, swept.unit) + 1, swept)
    if not ends[1] > ends[0]:
        raise InputError(name, dict(given), "an interval that ends above its start")
    return made


def _written(name: str, given: Mapping[str, Any], unit: str, *keys: str) -> tuple[list[Fraction], units.Unit] | None:
    """Return numbers exactly as written, and their unit; None if units differ."""
    dimension = units.unit(unit).dimension
    pairs = [units.parse_exactly(given[key], dimension, name=name) for key in keys]
    return ([number for number, _ in pairs], pairs[0][1]) if len({each for _, each in pairs}) == 1 else None


def _steps(name: str, given: Mapping[str, Any], unit: str) -> int:
    """Return the number of steps from the first value to the last; a step is a difference, even in degrees Celsius."""
    dimension = units.unit(unit).dimension
    step, step_unit = units.parse_exactly(given["step"], dimension, name=f"step of {name}")
    first, last = (units.parse(given[key], dimension, name=name) for key in ("from", "to"))
    alike = _written(name, given, unit, "from", "to", "step")
    if alike is not None:
        exact = (alike[0][1] - alike[0][0]) / step if step else None
    else:
        size = float(step) * units.size(step_unit.symbol)
        # Tolerate rounding of the unit conversion.
        exact = (last - first) / size if size else None
        if exact is not None and math.isfinite(exact) and abs(exact - round(exact)) <= 1e-9 * max(abs(exact), 1.0):
            exact = round(exact)
    if first == last and step:
        return 0
    wanted = f"a step that leads from the first value, {given['from']}, to the last, {given['to']}"
    if exact is None or not 0 < exact < MOST:
        raise InputError(f"step of {name}", given["step"], wanted)
    if exact != int(exact):
        near = ", or count in its place"
        raise InputError(f"step of {name}", given["step"], f"{wanted}, in whole steps, not {float(exact):.6g}{near}")
    return int(exact)


def _spaced(made: SweepAxis, given: Mapping[str, Any], count: int, swept: Swept) -> SweepAxis:
    """Return ``count`` evenly spaced values, computed from the digits as written if possible."""
    made = replace(made, count=count)
    alike = _written(made.name, given, swept.unit or "1", "from", "to")
    if alike is None:
        if swept.limits is not None:
            raise InputError(made.name, dict(given), "given in one unit, since it is a count")
        return made
    (first, last), unit = alike
    step = (last - first) / max(count - 1, 1)
    common = math.lcm(first.denominator, step.denominator)
    if swept.limits is not None and (common != 1 or unit.symbol != "1"):
        raise InputError(made.name, dict(given), "whole numbers at every step")
    start, by = int(first * common), int(step * common)
    if max(abs(start), abs(start + by * (count - 1)), common) > EXACT:
        return made
    return replace(made, spacing=(start, by, common, unit.symbol))


def _list(name: str, given: Sequence[Any], swept: Swept) -> SweepAxis:
    if not given:
        raise InputError(name, given, "a list of at least one value")
    if swept.unit is not None:
        values = tuple(_check_whole(name, number(name, each, swept.unit), swept) for each in given)
        return SweepAxis(name=name, unit=swept.unit, values=values, count=len(values))
    for each in given:
        if not isinstance(each, str):
            raise InputError(name, each, "a name in quotes")
        if swept.choices:
            check_choice(name, each, swept.choices)
    if len(set(given)) < len(given):
        raise InputError(name, given, "a list without repeated names")
    return SweepAxis(name=name, unit=None, choices=tuple(given), count=len(given))


def number(name: str, value: Any, unit: str) -> float:
    """Return an input's value in SI; bulge and roll may be "flat"."""
    if value == FLAT and name in ("bulge", "roll"):
        return float("inf")
    return units.parse(value, units.unit(unit).dimension, name=name)


def held_number(name: str, value: Any, swept: Swept) -> float:
    """Return the fixed value of a sweepable input; counts are ints."""
    if swept.limits is not None:
        return check_count(name, value, *swept.limits)
    return number(name, value, swept.unit or "1")


def _check_whole(name: str, value: float, swept: Swept) -> float:
    if flaw := whole_flaw(value, swept):
        raise InputError(name, int(value) if value.is_integer() else value, flaw)
    return value


def whole_flaw(value: float, swept: Swept) -> str:
    """Return what a swept count must be if ``value`` is invalid, else ""."""
    if swept.limits is None:
        return ""
    least, most = swept.limits[0], min(swept.limits[1], EXACT)
    return "" if value.is_integer() and least <= value <= most else f"a whole number from {least} to {most}"


def inputs_named(table: Mapping[str, Any], known: Container[str]) -> Iterator[tuple[str, str, Any]]:
    """Yield name, path and value of each entry of a table and its subtables.

    An input has one name whatever its group: ``air.temperature`` is the known ``temperature``.
    """

    def walk(parts: tuple[str, ...], given: Any) -> Iterator[tuple[str, str, Any]]:
        names = ["_".join(parts[place:]) for place in range(len(parts))]
        name = next((each for each in names if each in known), names[-1])
        table = isinstance(given, Mapping) and not given.keys() <= set(FORM)
        # "ball" is an input, but also the group of "ball_cube".
        if table and (name not in known or any(f"{name}_{each}" in known for each in given)):
            for each, inner in given.items():
                yield from walk((*parts, each), inner)
        else:
            yield name, ".".join(parts), given

    for key, given in table.items():
        yield from walk((key,), given)
