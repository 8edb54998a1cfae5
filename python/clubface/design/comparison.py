"""Shots side by side: clubs, balls, models, parameters or deliveries, their differences and what causes them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from clubface import units
from clubface.design.contributions import QUANTITIES, Contributions, contributions, symbol, values
from clubface.equipment.clubs import club as club_of
from clubface.equipment.models import DEFAULT_MODEL, MODULES, model
from clubface.errors import FileError, InputError, RangeWarning, ShotError, Wording
from clubface.quantities import Quantity, quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, text
from clubface.shots.summary_rows import summaries_in
from clubface.shots.tables.headings import check_units, delivery_words, layout, plain_name
from clubface.shots.tables.row_source import open_table
from clubface.simulation.flight import AirLike, Flight, GroundLike, WindLike, fly, trajectory
from clubface.simulation.impact import impact, warn_if_outside
from clubface.simulation.inputs import as_values
from clubface.simulation.launch import Launch, assumptions_of, rigid_faces
from clubface.simulation.provenance import flight_conditions, provenance_of
from clubface.simulation.sensitivity import FEW, OF_THE_BALL
from clubface.simulation.shot_result import flight_views, shape_note
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice, check_count, check_name, check_names, without_warnings
from clubface.units import to_si

if TYPE_CHECKING:
    import pandas

MOST = 24
"""Maximum number of alternatives in one comparison."""
MOST_NODES = 64


@dataclass(frozen=True, kw_only=True)
class Alternative:
    """One of the shots compared, with values as for :func:`clubface.impact` of a single shot."""

    club: Any
    delivery: Any
    model: str = DEFAULT_MODEL
    parameters: Any = None
    ball: Any = None
    accuracy: float | None = None

    def launch(self, **changes: Any) -> Launch:
        """Return its launch, with some fields changed."""
        taken = {each.name: getattr(self, each.name) for each in fields(self)} | changes
        if not isinstance(taken["model"], str) or taken["model"] == "all":
            raise InputError("model", taken["model"], "the name of one model in each alternative")
        launch = impact(taken.pop("club"), taken.pop("delivery"), **taken)
        if launch.shape:
            raise InputError("delivery", Wording(f"a batch of shape {launch.shape}"), "a single shot per alternative")
        return launch


class Compared(Described):
    """Compared shots; differences are from the first of them.

    Attributes
    ----------
    names
        Names of the alternatives; the others are compared with the first.
    launches, flights, contributions
        By name; contributions are what makes each differ from the first, and are empty if not requested.
    conditions
        Air, wind and ground of the flights.
    """

    def __init__(
        self,
        launches: Mapping[str, Launch],
        flights: Mapping[str, Flight],
        split: Mapping[str, Contributions],
        conditions: Mapping[str, Any],
    ) -> None:
        self.names = tuple(launches)
        self.launches, self.flights, self.contributions = dict(launches), dict(flights), dict(split)
        self.conditions = dict(conditions)
        self._levels = {name: values(each, flights[name]) for name, each in launches.items()}

    def value(self, name: str, quantity: str, unit: str | None = None) -> float:
        """Return a quantity of one alternative, in SI or in ``unit``."""
        check_choice("alternative", name, self.names)
        check_choice("quantity", quantity, QUANTITIES)
        value = float(self._levels[name][QUANTITIES.index(quantity)])
        return value if unit is None else float(units.from_si(value, symbol(quantity, unit)))

    def difference(self, name: str, quantity: str, unit: str | None = None) -> float:
        """Return the quantity of one alternative minus that of the first, in SI or in ``unit``."""
        value = self.value(name, quantity) - self.value(self.names[0], quantity)
        return value if unit is None else value / units.size(symbol(quantity, unit))

    def rows(self) -> list[dict[str, Any]]:
        """Return all numbers [SI]: values, differences, contributions and remainders, one row each.

        The first three entries of a row are the ``alternative``, the ``part`` (such as "difference"), and for a
        contribution the ``change`` that causes it.
        """
        rows = [("value", name, "", self._levels[name]) for name in self.names]
        for name in self.names[1:]:
            rows.append(("difference", name, "", self._differences(name)))
            if (made := self.contributions.get(name)) is not None and not made.left_out:
                names = [each.name for each in made.changes]
                rows += [("contribution", name, *each) for each in zip(names, made.si, strict=True)]
                rows.append(("remainder", name, "", made.remainder))
        return [
            {"alternative": name, "part": part, "change": change,
             **dict(zip(QUANTITIES, map(float, numbers), strict=True))}
            for part, name, change, numbers in rows
        ]  # fmt: skip

    def all_figures(self) -> Table:
        """Return :meth:`rows` as a table."""
        rows = self.rows()
        names = [text(key, [row[key] for row in rows]) for key in ("alternative", "part", "change")]
        return Table("figures", (*names, *(column(key, [row[key] for row in rows]) for key in QUANTITIES)))

    def to_pandas(self, name: str | None = None) -> pandas.DataFrame:
        """Return :meth:`rows`, or a table of :meth:`to_result`; ``attrs`` has units and provenance."""
        frame = self.all_figures().to_pandas() if name is None else self.to_result().to_pandas(name)
        frame.attrs["provenance"] = {name: each.provenance for name, each in self.launches.items()}
        return frame

    def to_result(self) -> Result:
        """Return the alternatives, their differences and the contributions as a result."""
        first, *others = self.names
        title = f'"{first}" compared with ' + ", ".join(f'"{name}"' for name in others)
        split = {name: each for name, each in self.contributions.items() if each.changes}
        shapes = [shape_note("comparison-shape", each, name=name) for name, each in self.flights.items()]
        differences = [text("alternative", others), text("compared_with", [first] * len(others), printed=False)]
        differences += _quantity_columns([self._differences(name) for name in others])
        tables = [self._alternatives(), Table("differences", tuple(differences), "differences", layout="transposed")]
        if split:
            tables.append(self._contributions(split))
        return Result(
            kind="comparison", title=title, tables=tuple(tables),
            assumptions=(*assumptions_of(self.launches.values()), *rigid_faces(self.launches)),
            summary=(*shapes, *self._summary()), notes=(*shapes, *self._notes()),
            provenance=provenance_of(self.launches.values(), flight_conditions(**self.conditions)),
            draw=lambda: [comparison_picture(self)],
        )  # fmt: skip

    def _differences(self, name: str) -> Floats:
        return self._levels[name] - self._levels[self.names[0]]

    def _alternatives(self) -> Table:
        launches = self.launches.values()
        named = {
            "club": [each.club.name for each in launches], "ball": [each.ball.name for each in launches],
            "model": [each.model for each in launches], "parameters": [each.parameters.name for each in launches],
        }  # fmt: skip
        delivered = dict.fromkeys(name for each in launches for name in each.delivery)
        columns = [
            text("alternative", self.names),
            *(text(name, each, printed=False) for name, each in named.items()),
            *(column(name, [each.delivery.get(name) for each in launches], printed=False) for name in delivered),
        ]
        columns += _quantity_columns([self._levels[name] for name in self.names], differences=False)
        columns.append(text("shot_shape", [each.shot_shape() or None for each in self.flights.values()], printed=False))
        return Table("alternatives", tuple(columns), layout="transposed")

    def _contributions(self, split: Mapping[str, Contributions]) -> Table:
        parts = ((name, self.launches[name], each, self._differences(name)) for name, each in split.items())
        rows = [row for each in parts for row in _split_rows(*each)]
        alone = len(split) == 1
        whose = f"difference of {next(iter(split))}" if alone else "differences"
        kinds = [each.quantity for each in rows]
        columns = (
            text("alternative", [each.alternative for each in rows], printed=not alone),
            text("part", [each.part for each in rows], printed=False),
            text("change", [each.change for each in rows], printed=False),
            text("change of", [each.label for each in rows], in_files=False),
            Column("from", [each.start for each in rows], kinds, digits=-6),
            Column("to", [each.end for each in rows], kinds, digits=-6),
            *_quantity_columns([each.numbers for each in rows], printed=SPLIT),
        )
        return Table(
            "contributions", columns, f"Contributions to the {whose} from {self.names[0]}", summary=alone,
            shown_rows=[place for place, each in enumerate(rows) if not each.hidden],
        )  # fmt: skip

    def _summary(self) -> Iterator[Note]:
        for name in self.names[1:]:
            changes = {key: self.difference(name, key) for key in ("ball_speed", "backspin", "carry", "side")}
            yield note("comparison-difference", first=self.names[0], name=name, **changes)
            if (made := self.contributions.get(name)) is not None and len(made.changes) > 1:
                key = "side" if abs(changes["side"]) > abs(changes["carry"]) else "carry"
                parts = made.si[:, QUANTITIES.index(key)]
                most = int(np.argmax(np.abs(parts)))
                code = "comparison-main-cause" if key == "carry" else "comparison-main-cause-side"
                if parts[most]:
                    change = made.changes[most].name.replace("_", " ")
                    yield note(code, change=change, **{key: float(parts[most])})

    def _notes(self) -> Iterator[Note]:
        for name, made in self.contributions.items():
            if made.left_out:
                yield note("comparison-not-split", name=name, first=self.names[0], reason=made.left_out)
            elif not made.changes:
                yield note("comparison-same", name=name, first=self.names[0])

    def __repr__(self) -> str:
        shown = {"ball_speed": "mph", "launch": "deg", "backspin": "rpm", "carry": "yd", "side": "yd"}
        lines = [f"{len(self.names)} alternatives, compared with {self.names[0]}"]
        for name in self.names:
            figures = ", ".join(f"{key} {self.value(name, key, unit):.5g} {unit}" for key, unit in shown.items())
            lines.append(f"  {name}: {figures}")
        return "\n".join(lines)


SPLIT = ("ball_speed", "launch", "azimuth", "backspin", "carry", "side", "curve", "total")
"""Quantities whose contributions are printed; files and JSON have them all."""


class _Row(NamedTuple):
    """A row of the contributions table; ``hidden`` marks coefficients of a fit, which are printed as one sum."""

    alternative: str
    part: str
    change: str
    label: str
    numbers: Floats
    quantity: Quantity | None = None
    start: float | None = None
    end: float | None = None
    hidden: bool = False


def _split_rows(name: str, launch: Launch, made: Contributions, difference: Floats) -> Iterator[_Row]:
    parameters = {each.name: each.unit for each in model(launch.model).parameters}
    fitted = {each for each in parameters if len(parameters) > FEW and each not in OF_THE_BALL}
    together = np.zeros(len(QUANTITIES))
    coefficients = 0
    for change, numbers in zip(made.changes, made.si, strict=True):
        kind = quantity(change.name, parameters.get(change.name)) if change.derivative else None
        hidden = change.name in fitted
        if hidden:
            together, coefficients = together + numbers, coefficients + 1
        label = change.name if kind is None else kind.label
        yield _Row(name, "contribution", change.name, label, numbers, kind, change.start, change.end, hidden)
    if coefficients:
        yield _Row(name, "coefficients", "", f"{coefficients} coefficient{'s' * (coefficients > 1)} of {launch.model}",
                   together)  # fmt: skip
    yield _Row(name, "remainder", "", "remainder", made.remainder)
    yield _Row(name, "difference", "", "difference", difference)


def _quantity_columns(
    rows: Sequence[Floats], *, differences: bool = True, printed: Sequence[str] = QUANTITIES
) -> list[Column]:
    """Return a column for each of ``QUANTITIES``; differences get an extra digit."""
    return [
        column(
            name, [float(each[place]) for each in rows], difference=differences, printed=name in printed,
            digits=quantity(name).golf.digits + 1 if differences else None,
        )
        for place, name in enumerate(QUANTITIES)
    ]  # fmt: skip


_DRAWN = ("side", "carry", "ball_speed", "backspin")
"""Quantities whose differences are drawn."""
_MOST_BARS = 9
"""Number of contributions drawn individually, the largest first; the rest share one bar."""


def comparison_picture(compared: Compared) -> Picture:
    """Return the picture of a comparison: the flights, and below them the contributions to each difference."""
    paths = {name: trajectory(each, **compared.conditions).position for name, each in compared.launches.items()}
    shapes = {name: each.shot_shape() for name, each in compared.flights.items()}
    views, heights = flight_views(paths, shapes=shapes, styles={name: place for place, name in enumerate(paths)})
    rows: list[list[Panel | None]] = [[each] for each in views]
    for name, made in compared.contributions.items():
        if len(made.changes) > 1:  # a single one is the difference, which the flights show
            rows.append(_contribution_panels(compared, name, made))
            heights.append(0.9 + 0.19 * (min(len(made.changes), _MOST_BARS + 1) + 2))
    return Picture(
        "comparison", "Flights, and contributions to their differences", rows, heights=heights,
        height=sum(heights) + 0.3 * len(heights) + 0.8, legend=True,
    )  # fmt: skip


def _contribution_panels(compared: Compared, name: str, made: Contributions) -> list[Panel | None]:
    places = [QUANTITIES.index(each) for each in _DRAWN]
    numbers = made.si[:, places]
    # Shares of each quantity's total make speeds, spins and lengths comparable.
    weight = (np.abs(numbers) / np.maximum(np.abs(numbers).sum(axis=0), 1e-300)).max(axis=1)
    order = np.argsort(-weight, kind="stable").tolist()
    labels = [made.changes[place].name.replace("_", " ") for place in order[:_MOST_BARS]]
    bars = [numbers[place] for place in order[:_MOST_BARS]]
    if others := order[_MOST_BARS:]:
        labels.append(f"{len(others)} others")
        bars.append(numbers[others].sum(axis=0))
    labels += ["remainder", "difference"]
    table = np.array([*bars, made.remainder[places], compared._differences(name)[places]])
    panels: list[Panel | None] = []
    ends = {}  # common limits per unit, so that a yard has the same length in every panel
    for place, key in enumerate(_DRAWN):
        low, high = ends.get(quantity(key).golf.unit, (0.0, 0.0))
        ends[quantity(key).golf.unit] = (min(low, table[:, place].min()), max(high, table[:, place].max()))
    for place, key in enumerate(_DRAWN):
        low, high = ends[quantity(key).golf.unit]
        margin = 0.05 * float(high - low)
        limits = (float(low) - margin, float(high) + margin) if margin else (None, None)
        y = axis(label=name, names=labels, reversed=True) if not panels else axis(reversed=True, ticks=False)
        marks = [Mark("bars", table[:, place], np.arange(len(table)), style=-1), Mark("rule", x=0.0, style=-2)]
        panels.append(Panel(marks, axis(key, "change", limits=limits), y, quantity(key).label))
    return panels


def compare(
    alternatives: Mapping[str, Alternative | Mapping[str, Any]],
    *,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    split: bool = True,
    nodes: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Compared:
    """Compute shots side by side and split the differences from the first into contributions.

    Parameters
    ----------
    alternatives
        Two or more, each an :class:`Alternative` or a mapping of its fields, by the name used in tables.
    air, wind, ground
        Conditions of all flights, as for :func:`clubface.fly`.
    split
        Whether to split the differences into contributions. Inputs and parameters with derivatives change along a
        straight line from the first shot to the other (bulge and roll in their curvature), and the exact derivatives of
        launch and flight are integrated along it; these contributions add up to the difference except for a small
        remainder. The model, the hand and, for finite elements, the mesh of ball or head have no derivatives; they are
        changed first, each in one step.
    nodes
        Points on the line at which derivatives are taken, 1 to 64. Default 8, or 1 for finite elements, where each
        point takes one run for every four inputs that differ.
    progress
        Called with the number of points done and the number of all points.

    Raises
    ------
    InputError
        There are fewer than two alternatives or more than 24, or one is not a single shot.
    """
    if not isinstance(alternatives, Mapping) or not 2 <= len(alternatives) <= MOST:
        count = Wording(f"{len(alternatives)} of them") if isinstance(alternatives, Mapping) else alternatives
        raise InputError("alternatives", count, f"a mapping of names to 2 to {MOST} alternatives")
    if nodes is not None:
        nodes = check_count("nodes", nodes, 1, MOST_NODES)
        if not split:
            raise InputError("nodes", nodes, "leave it out unless differences are split into contributions")
    for name in alternatives:
        check_name(name)
    asked = {name: _alternative(each) for name, each in alternatives.items()}
    conditions = {"air": air, "wind": wind, "ground": ground}
    with without_warnings(RangeWarning):
        launches = {name: _launch(name, each) for name, each in asked.items()}
        flights = {name: fly(each, **conditions) for name, each in launches.items()}
        first, *others = asked
        count = progress and (lambda place, done, whole: progress(place * whole + done, len(others) * whole))
        parts = {}
        for place, name in enumerate(others if split else ()):
            parts[name] = contributions(
                _stages(asked[first], asked[name], launches[first], launches[name]), launches[name], conditions,
                ball=asked[name].ball, nodes=nodes, progress=count and partial(count, place),
            )  # fmt: skip
    warn_if_outside(launches.values())
    return Compared(launches, flights, parts, conditions)


def _launch(name: str, alternative: Alternative) -> Launch:
    try:
        return alternative.launch()
    except ShotError as error:
        raise ShotError(f"{error.parameter} of {name}", error.value, error.allowed) from None


def _alternative(given: Alternative | Mapping[str, Any]) -> Alternative:
    if isinstance(given, Mapping):
        check_names("field of an alternative", given, [each.name for each in fields(Alternative)])
        if missing := [name for name in ("club", "delivery") if name not in given]:
            raise InputError(missing[0], None, "give it for each alternative")
        given = Alternative(**given)
    elif not isinstance(given, Alternative):
        raise InputError("an alternative", given, "an Alternative or a mapping of its fields")
    return replace(given, club=club_of(given.club), delivery=dict(as_values(given.delivery, {})))


def _stages(first: Alternative, other: Alternative, launch: Launch, last: Launch) -> list[tuple[str, Launch]]:
    """Return the first shot and the shot after each change that has no derivatives."""
    taken: dict[str, Any] = {
        "club": first.club, "delivery": {**first.delivery, **launch.delivery}, "model": first.model,
        "parameters": first.parameters, "ball": first.ball, "accuracy": other.accuracy,
    }  # fmt: skip
    stages = [("", launch)]

    def change(name: str, **changes: Any) -> None:
        taken.update(changes)
        stages.append((name, other.launch(**taken)))

    if first.model != other.model:
        change("model", model=other.model, parameters=other.parameters)
    if launch.input("hand") != last.input("hand"):
        change("hand", delivery={**taken["delivery"], "hand": last.input("hand")})
    if other.model in MODULES:
        from clubface.fem.heads.meshed import mesh_of

        if _ball_fingerprint(first.ball) != _ball_fingerprint(other.ball):
            change("ball", ball=other.ball)
        if mesh_of(first.club) is not mesh_of(other.club):
            change("head", club=other.club)
    return stages


def _ball_fingerprint(given: Any) -> Any:
    """Return the fingerprint of a finite element ball, given as such or by name."""
    from clubface.fem.balls import ball
    from clubface.jobs.store import fingerprint

    return fingerprint(ball(given).values())


NAMES = ("name", "label", "delivery", "shot")
"""Headings of a column with the names of the rows."""


def read_deliveries(
    path: str | os.PathLike[str],
    most: int,
    note: Callable[[str], object] | None = None,
    *,
    units: Mapping[str, str] | None = None,
) -> dict[str, dict[str, float]]:
    """Read deliveries [SI] by name from a CSV or Parquet file of at most ``most`` rows.

    A column ``name`` (or label, delivery, shot) names the rows; without one, rows are named by line number. ``note`` is
    called with every caveat, such as a column whose name almost matches an input. ``units`` gives the units of columns
    whose headings have none, by quantity or dimension.
    """
    given = check_units(units or {}, delivery_words().dimensions)
    reader = open_table(Path(path))
    try:
        columns = layout(reader.headings, reader.path, reader.header_line, given_units=given)
        naming = [place for place, each in enumerate(columns.headings) if plain_name(each) in NAMES]
        remark = note or (lambda text: None)
        for text in (*reader.notes, *columns.notes):
            remark(str(text))
        result: dict[str, dict[str, float]] = {}
        for chunk in reader.chunks(most + 1, 0):
            for reject in chunk.ragged:
                raise FileError(reader.path, reject.line, reject.reason)
            values = {column.quantity: (column, *chunk.numbers(column)) for column in columns.used}
            summaries = summaries_in(chunk, columns)
            for row, line in enumerate(chunk.lines):
                if row in summaries:
                    remark(f"{reader.counts} {line}: {summaries[row]}")
                    continue
                for _, _, missing in values.values():
                    if row in missing:
                        raise FileError(reader.path, line, missing[row])
                cells = chunk.texts([row])[0]
                name = next((cells[place].strip() for place in naming), "") or f"{reader.counts} {line}"
                if not name.isprintable():
                    raise FileError(reader.path, line, f"the name {name!r} is not printable text")
                if name in result:
                    raise FileError(reader.path, line, f"the name {name!r} is used twice; give each row its own name")
                result[name] = {
                    key: float(to_si(numbers[row], column.unit)) for key, (column, numbers, _) in values.items()
                }
                if len(result) > most:
                    raise FileError(reader.path, line, f"there are more than {most} rows to compare; give fewer")
    finally:
        reader.close()
    if not result:
        raise FileError(reader.path, None, "there is no row with a delivery")
    return result
