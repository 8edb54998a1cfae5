"""Shots side by side: alternatives, one or many from the rows of a file, and their differences.

Shots side by side: clubs, balls, models, parameters or deliveries, their differences and what makes them.

Deliveries to compare, one from each row of a file.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

from clubface import units
from clubface.design.contributions import QUANTITIES, Contributions, Stage, contributions, quantities, symbol, values
from clubface.equipment.backends import MODULES
from clubface.equipment.clubs import club as club_of
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import FileError, InputError, RangeWarning, ShotError, Told
from clubface.shots.summary_rows import summaries_in
from clubface.shots.tables.headings import check_units, delivery_words, layout, plain_name
from clubface.shots.tables.reader import open_table
from clubface.simulation.flight import Flight, fly
from clubface.simulation.impact import impact, warn_if_outside
from clubface.simulation.inputs import as_values
from clubface.simulation.launch import Launch
from clubface.support.checks import check_choice, check_count, check_name, check_names, without_warnings
from clubface.units import to_si

MOST = 24
"""Alternatives that are compared at a time."""
MOST_NODES = 64


@dataclass(frozen=True, kw_only=True)
class Alternative:
    """One of the shots that are compared.

    Attributes
    ----------
    club, delivery, model, parameters, ball, accuracy
        As for :func:`clubface.impact`, for a single shot.
    """

    club: Any
    delivery: Any
    model: str = DEFAULT_MODEL
    parameters: Any = None
    ball: Any = None
    accuracy: float | None = None

    def launch(self, **changes: Any) -> Launch:
        """Return the launch of it, some of its fields changed."""
        taken = {each.name: getattr(self, each.name) for each in fields(self)} | changes
        if not isinstance(taken["model"], str) or taken["model"] == "all":
            raise InputError("model", taken["model"], "the name of one model in each alternative")
        found = impact(taken.pop("club"), taken.pop("delivery"), **taken)
        if found.shape:
            raise InputError("delivery", Told(f"a batch of shape {found.shape}"), "a single shot in each alternative")
        return found


class Compared:
    """Shots that were compared; differences are from the first of them.

    Attributes
    ----------
    names
        What the alternatives are called; the first is what the others are compared with.
    launches, flights
        By name.
    contributions
        What makes the difference of each from the first, by name; empty where it was not asked for.
    """

    def __init__(
        self,
        launches: Mapping[str, Launch],
        flights: Mapping[str, Flight],
        found: Mapping[str, Contributions],
        levels: Mapping[str, Any],
    ) -> None:
        self.names = tuple(launches)
        self.launches, self.flights, self.contributions = dict(launches), dict(flights), dict(found)
        self._levels = levels

    def value(self, name: str, quantity: str, unit: str | None = None) -> float:
        """Return a quantity of one alternative: in SI, or in ``unit``."""
        check_choice("alternative", name, self.names)
        check_choice("quantity", quantity, QUANTITIES)
        found = float(self._levels[name][QUANTITIES.index(quantity)])
        return found if unit is None else float(units.from_si(found, symbol(quantity, unit)))

    def difference(self, name: str, quantity: str, unit: str | None = None) -> float:
        """Return by how much a quantity of one alternative exceeds that of the first: in SI, or in ``unit``."""
        found = self.value(name, quantity) - self.value(self.names[0], quantity)
        return found if unit is None else found / units.size(symbol(quantity, unit))

    def rows(self) -> list[dict[str, Any]]:
        """Return a long table [SI]: values, differences, contributions and remainders, one row each.

        The first three entries of a row say of which ``alternative``, which ``part``, and for a contribution by which
        ``change``.
        """
        found = []
        for name in self.names:
            found.append(_row(name, "value", "", self._levels[name]))
        for name in self.names[1:]:
            found.append(_row(name, "difference", "", self._levels[name] - self._levels[self.names[0]]))
            if (made := self.contributions.get(name)) is None or made.left_out:
                continue
            for change, part in zip(made.changes, made.si, strict=True):
                found.append(_row(name, "contribution", change.name, part))
            found.append(_row(name, "remainder", "", made.remainder))
        return found

    def to_pandas(self) -> Any:
        """Return :meth:`rows` as a table; ``attrs`` holds the units and what each alternative was computed with."""
        import pandas

        frame = pandas.DataFrame(self.rows())
        frame.attrs = {
            "units": {name: each.unit for name, each in quantities().items()},
            "provenance": {name: each.provenance for name, each in self.launches.items()},
        }
        return frame

    def __repr__(self) -> str:
        shown = {"ball_speed": "mph", "launch": "deg", "backspin": "rpm", "carry": "yd", "side": "yd"}
        lines = [f"{len(self.names)} alternatives, compared with {self.names[0]}"]
        for name in self.names:
            told = ", ".join(f"{key} {self.value(name, key, unit):.5g} {unit}" for key, unit in shown.items())
            lines.append(f"  {name}: {told}")
        return "\n".join(lines)


def compare(
    alternatives: Mapping[str, Alternative | Mapping[str, Any]],
    *,
    air: Any = None,
    wind: Any = None,
    ground: str | Mapping[str, Any] | None = None,
    split: bool = True,
    nodes: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Compared:
    """Compute shots side by side, and what makes the others differ from the first.

    Parameters
    ----------
    alternatives
        Each an :class:`Alternative` or a mapping of its fields, by a name for tables. Two at least.
    air, wind, ground
        Of all flights, as for :func:`clubface.fly`.
    split
        Whether to split the differences into contributions. What can be differentiated changes along a straight line
        from the first shot to the other, bulge and roll by their curvature, and the exact derivatives of launch and
        flight are integrated along it; the contributions so found add up to the difference but for a small remainder.
        What has no derivatives (the model, the hand, and the mesh of ball or head for finite elements) is changed first
        and as a whole.
    nodes
        Points of the line at which derivatives are taken, 1 to 64; left out, 8, or 1 for finite elements, of which
        each point takes a run for every four things that differ.
    progress
        Called with the number of points done and the number of all points.

    Returns
    -------
    Compared
        Values, differences and contributions.

    Raises
    ------
    InputError
        There are fewer than two alternatives or more than 24, or one is no single shot.
    """
    if not isinstance(alternatives, Mapping) or not 2 <= len(alternatives) <= MOST:
        count = Told(f"{len(alternatives)} of them") if isinstance(alternatives, Mapping) else alternatives
        raise InputError("alternatives", count, f"a mapping of names to 2 to {MOST} alternatives")
    if nodes is not None:
        nodes = check_count("nodes", nodes, 1, MOST_NODES)
        if not split:
            raise InputError("nodes", nodes, "leave it out where nothing is split into contributions")
    for name in alternatives:
        check_name(name)
    asked = {name: _alternative(each) for name, each in alternatives.items()}
    conditions = {"air": air, "wind": wind, "ground": ground}
    with without_warnings(RangeWarning):
        launches = {name: _launch(name, each) for name, each in asked.items()}
        flights = {name: fly(each, **conditions) for name, each in launches.items()}
        levels = {name: values(each, flights[name]) for name, each in launches.items()}
        found = {}
        first, *others = asked
        for place, name in enumerate(others if split else ()):
            told = progress and _counted(progress, place, len(others))
            found[name] = contributions(
                _stages(asked[first], asked[name], launches[first], launches[name]), launches[name], conditions,
                ball=asked[name].ball, nodes=nodes, progress=told,
            )  # fmt: skip
    warn_if_outside(launches.values())
    return Compared(launches, flights, found, levels)


def _launch(name: str, alternative: Alternative) -> Launch:
    try:
        return alternative.launch()
    except ShotError as error:
        raise ShotError(f"{error.parameter} of {name}", error.value, error.allowed) from None


def _counted(progress: Callable[[int, int], object], place: int, count: int) -> Callable[[int, int], object]:
    return lambda done, whole: progress(place * whole + done, count * whole)


def _alternative(given: Alternative | Mapping[str, Any]) -> Alternative:
    if isinstance(given, Alternative):
        found = given
    elif isinstance(given, Mapping):
        check_names("field of an alternative", given, [each.name for each in fields(Alternative)])
        for name in ("club", "delivery"):
            if name not in given:
                raise InputError(name, None, "give it for each alternative")
        found = Alternative(**given)
    else:
        raise InputError("an alternative", given, "an Alternative or a mapping of its fields")
    return replace(found, club=club_of(found.club), delivery=dict(as_values(found.delivery, {})))


def _stages(first: Alternative, other: Alternative, launch: Launch, last: Launch) -> list[Stage]:
    """Return the first shot, and the shots after each change as a whole that has no derivatives."""
    taken: dict[str, Any] = {
        "club": first.club, "delivery": {**first.delivery, **launch.delivery}, "model": first.model,
        "parameters": first.parameters, "ball": first.ball, "accuracy": other.accuracy,
    }  # fmt: skip
    stages = [Stage("", launch)]

    def change(name: str, **changes: Any) -> None:
        taken.update(changes)
        stages.append(Stage(name, other.launch(**taken)))

    if first.model != other.model:
        change("model", model=other.model, parameters=other.parameters)
    if launch.input("hand") != last.input("hand"):
        change("hand", delivery={**taken["delivery"], "hand": last.input("hand")})
    if other.model in MODULES:
        from clubface.fem.heads.meshed import mesh_of

        if _meshed(first.ball) != _meshed(other.ball):
            change("ball", ball=other.ball)
        if mesh_of(first.club) is not mesh_of(other.club):
            change("head", club=other.club)
    return stages


def _meshed(which: Any) -> Any:
    """Return what tells one ball of finite elements from another."""
    from clubface.fem.balls import ball
    from clubface.support.fingerprint import fingerprint

    return fingerprint(ball(which).values())


def _row(name: str, part: str, change: str, numbers: Any) -> dict[str, Any]:
    return {
        "alternative": name,
        "part": part,
        "change": change,
        **dict(zip(QUANTITIES, map(float, numbers), strict=True)),
    }


NAMES = ("name", "label", "delivery", "shot")
"""Headings of a column that names the rows."""


def read_deliveries(
    path: str | os.PathLike[str],
    most: int,
    note: Callable[[str], object] | None = None,
    *,
    units: Mapping[str, str] | None = None,
) -> dict[str, dict[str, float]]:
    """Read deliveries [SI] from a CSV or Parquet file of at most so many rows, by what its rows are called.

    A column ``name`` (or label, delivery, shot) names the rows; without one they are called after their lines. ``note``
    is called with what a reader of the result should know, such as a column whose name is nearly that of an input.
    ``units`` are those of columns that name none, by quantity or dimension.
    """
    given = check_units(units or {}, delivery_words().dimensions)
    reader = open_table(Path(path))
    try:
        columns = layout(reader.headings, reader.path, reader.header_line, given_units=given)
        naming = [place for place, each in enumerate(columns.headings) if plain_name(each) in NAMES]
        if note is not None:
            for text in (*reader.notes, *columns.notes):
                note(text)
        found: dict[str, dict[str, float]] = {}
        for chunk in reader.chunks(most + 1, 0):
            for reject in chunk.ragged:
                raise FileError(reader.path, reject.line, reject.reason)
            values = {column.quantity: (column, *chunk.numbers(column)) for column in columns.used}
            summaries = summaries_in(chunk, columns)
            for row, line in enumerate(chunk.lines):
                if row in summaries:
                    if note is not None:
                        note(f"{reader.counts} {line}: {summaries[row]}")
                    continue
                for _, _, missing in values.values():
                    if row in missing:
                        raise FileError(reader.path, line, missing[row])
                cells = chunk.texts([row])[0]
                name = next((cells[place].strip() for place in naming), "") or f"{reader.counts} {line}"
                if not name.isprintable():
                    raise FileError(reader.path, line, f"the name {name!r} is no printable text")
                if name in found:
                    raise FileError(reader.path, line, f"a row is called {name!r} already; give each another name")
                found[name] = {
                    key: float(to_si(numbers[row], column.unit)) for key, (column, numbers, _) in values.items()
                }
                if len(found) > most:
                    raise FileError(reader.path, line, f"there are more than {most} rows to compare; give fewer")
    finally:
        reader.close()
    if not found:
        raise FileError(reader.path, None, "there is no row with a delivery")
    return found
