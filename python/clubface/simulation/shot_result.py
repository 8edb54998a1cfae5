"""Results of a shot by one or several models, or of a flight: values, notes, pictures, provenance."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clubface.quantities import format_value, quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Provenance, Result
from clubface.results.table import Column, Table, column, text
from clubface.simulation.flight import (
    AirLike,
    Flight,
    GroundLike,
    Trajectory,
    WindLike,
    fly,
    has_measured_run,
    trajectory,
)
from clubface.simulation.impact import backend_of
from clubface.simulation.inputs import HandLike
from clubface.simulation.launch import Comparison, Launch, assumptions_of, rigid_faces
from clubface.simulation.provenance import flight_conditions, flight_input_words, provenance_of
from clubface.simulation.results import Batch, Series, flight_inputs

if TYPE_CHECKING:
    from clubface.simulation.history import History

QUANTITIES = (
    "ball_speed", "smash", "launch", "azimuth", "backspin", "sidespin", "total_spin", "spin_axis", "carry", "side",
    "curve", "total", "apex", "landing_angle", "contact_time", "peak_force",
)  # fmt: skip
"""Quantities of a shot, in the order of its table."""
OF_FLIGHT = (
    "carry", "side", "curve", "total", "total_side", "apex", "landing_angle", "flight_time", "landing_speed",
    "landing_spin",
)  # fmt: skip
"""Quantities of a flight with known launch, in the order of its table."""
ENDS = ("soft", "firm")
"""Fairways that bound the total where no measured run is published."""
ONE_MODEL_ONLY = ("total_spin", "total", "apex", "landing_angle")
"""Quantities left out of the table of several models, so that it fits a terminal."""
_LEAST_SIDE, _LEAST_HEIGHT = 0.06, 0.08
"""Minimum extent of a view over its length: to either side from above, and upwards from the side."""
_TALLEST = 0.5
"""Maximum height over width of a view of the flight."""
_WIDTH = 6.4
"""Width of the axes of a panel over the whole picture [inches]."""
_MOST_STARTS = 4
"""Maximum number of flights drawn with start lines; more would overlap."""


def shot_result(
    launches: Mapping[str, Launch],
    flights: Mapping[str, Flight],
    *,
    conditions: Mapping[str, Any] | None = None,
    paths: Callable[[], tuple[Mapping[str, Any], Mapping[str, Any]]] | None = None,
) -> Result:
    """Return the result of a shot; launches and flights are keyed by model name.

    ``conditions`` are air, wind and ground, as for :func:`clubface.fly`. ``paths`` computes the data of the picture by
    model: positions of the ball in flight [m], shape [n, 3], and the force histories of models that have one.
    """
    first = next(iter(launches.values()))
    alone = len(launches) == 1
    title = subject(first) + (f", by {first.model}" if alone else "")
    shapes = {name: each.shot_shape() for name, each in flights.items()}
    columns = [
        text("model", list(launches), printed=not alone),
        *(column(name, [getattr(each if name in each.quantities() else flights[model], name)
                        for model, each in launches.items()], printed=alone or name not in ONE_MODEL_ONLY)
          for name in QUANTITIES),
        text("shot_shape", [each or None for each in shapes.values()], printed=False),
    ]  # fmt: skip
    return Result(
        kind="shot", title=title,
        tables=(Table("shots", tuple(columns), layout="list" if alone else "rows", title=title),),
        assumptions=(*assumptions_of(launches.values()), *rigid_faces(launches)),
        summary=tuple(_summary(first, flights[first.model], alone)),
        notes=tuple(_notes(launches, flights)),
        provenance=provenance_of(launches.values(), flight_conditions(**(conditions or {}))),
        draw=None if paths is None else lambda: [shot_picture(*paths(), title=shot_title(first), shapes=shapes)],
    )  # fmt: skip


def flight_result(
    launch: Mapping[str, float],
    *,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    hand: str = "right",
) -> Result:
    """Compute flight, bounces and roll of a ball as a result; for low balls also the totals on soft and firm ground.

    Arguments are single values as for :func:`clubface.fly`, and the hand of the player, for the name of the shot.
    """
    flown = fly(launch, air=air, wind=wind, ground=ground)
    values = [column(name, [getattr(flown, name)]) for name in OF_FLIGHT]
    values.append(text("shot_shape", [flown.shot_shape(hand) or None], printed=False))
    notes: list[Note] = [shape_note("shot-shape", flown, hand)]
    if flown.outside_fit:
        notes.append(note("spin-outside-aerodynamic-data"))
    if ground is None and not has_measured_run(flown.landing_angle, flown.landing_speed):
        soft, firm = (float(fly(launch, air=air, wind=wind, ground=f"{each} fairway").total) for each in ENDS)
        notes.append(note("run-not-measured", soft_total=soft, firm_total=firm))
        values += [
            column("total_soft", [soft], "total", printed=False), column("total_firm", [firm], "total", printed=False),
        ]  # fmt: skip
    inputs = {name.replace("_", " "): format_value(value, quantity(name)) for name, value in launch.items() if value}
    return Result(
        "flight", "Flight", values=tuple(values), notes=tuple(notes),
        provenance=Provenance(inputs=inputs | flight_conditions(air, wind, ground)),
        draw=lambda: [shot_picture({"flight": trajectory(launch, air=air, wind=wind, ground=ground).position},
                                   shapes={"flight": flown.shot_shape(hand)})],
    )  # fmt: skip


_TOO_LOW = {
    "shot-shape": "shot-too-low",
    "shot-shape-by-model": "shot-too-low-by-model",
    "comparison-shape": "comparison-too-low",
}
"""Codes of the notes that replace those on the shape of a shot if the ball does not fly."""


def shape_note(code: str, flight: Flight, hand: HandLike | None = None, **data: Any) -> Note:
    """Return the note on the shape of a shot: start, curve, landing, and the golfer's name for it.

    ``code`` is the code of the note in the catalogue, ``data`` its further data. The flight is of a single ball.
    """
    if not (shape := flight.shot_shape(hand)):
        return note(_TOO_LOW[code], **data)
    numbers = {name: float(getattr(flight, name)) for name in ("curve", "side", "carry")}
    return note(code, azimuth=float(flight.start), **numbers, shape=shape, **data)


def _summary(launch: Launch, flight: Flight, alone: bool) -> list[Note]:
    sentences = [
        note("shot-delivery", club=launch.club.name, ball=launch.ball.name, speed=launch.delivery["speed"],
             loft=launch.delivery["loft"]),
        note("shot-launch", ball_speed=launch.ball_speed, launch=launch.launch, total_spin=launch.total_spin),
        note("shot-carry", carry=flight.carry, apex=flight.apex, landing_angle=flight.landing_angle),
        shape_note("shot-shape", flight),
    ]  # fmt: skip
    return sentences if alone else [*sentences, note("shot-of-first-model", model=launch.model)]


def _notes(launches: Mapping[str, Launch], flights: Mapping[str, Flight]) -> list[Note]:
    first = next(iter(flights))
    alone = len(flights) == 1
    notes = [
        shape_note("shot-shape", flights[first]) if alone
        else shape_note("shot-shape-by-model", flights[first], model=first)
    ]  # fmt: skip
    club = launches[first].club
    if club.added_inertia is not None:
        free = club.replace(added_inertia=None).effective_mass
        source = club.sources.get("added_inertia", "in a mechanism")
        notes.append(note("attached-head", how=source, attached_club_mass=club.effective_mass, free_club_mass=free))
    if held := lie_note(launches[first]):
        notes.append(held)
    if outside := [name for name in launches if flights[name].outside_fit]:
        notes.append(note("outside-aerodynamic-data", models=outside))
    notes += (each for name in launches for each in backend_of(name).notes())
    if doubted := [name for name, each in launches.items() if each.parameters.caveats or each.parameters.value_caveats]:
        notes.append(note("caveats-listed", model=doubted[0] if len(doubted) == 1 else "NAME"))
    return notes


def lie_note(launch: Launch) -> Note | None:
    """Return the note that the lie tilt does not turn the face, or None if the club is not tilted.

    A club tilted toe up about the target line, with nothing else changed, turns its face to the heel side.
    """
    lie, loft, hand = (float(launch.input(name)) for name in ("lie", "loft", "hand"))
    if lie == 0.0:
        return None
    return note("lie-held", lie=lie, turned_face=-hand * math.atan(math.tan(loft) * math.sin(lie)))


def subject(launch: Launch) -> str:
    """Return club and ball in words, with "left-handed" where it applies."""
    left = ", left-handed" if launch.input("hand") < 0.0 else ""
    return f"{launch.club.name}{left}, ball {launch.ball.name}"


def shot_title(launch: Launch) -> str:
    """Return club and delivery in words, with non-breaking spaces between values and units."""
    parts = [
        f"{name.replace('_', ' ')} {format_value(float(value), quantity(name))}"
        for name, value in launch.delivery.items()
        if value
    ]
    if launch.input("hand") < 0.0:
        parts.append("left-handed")
    return f"{launch.club.name}: {', '.join(each.replace(' ', chr(160)) for each in parts)}"


def shot_picture(
    flights: Mapping[str, Any],
    histories: Mapping[str, Any] | None = None,
    *,
    title: str = "",
    shapes: Mapping[str, str] | None = None,
) -> Picture:
    """Return the picture of a shot: forces at the top, the flight from the side and from above underneath.

    ``flights`` are positions of the ball [m], shape [n, 3], by model or other name, ``histories`` a
    :class:`clubface.History`, or its columns by name, for each model that has one, and ``shapes`` the golfer's names of
    the shots.
    """
    histories = histories or {}
    forces = _force_panels(histories)
    views, heights = flight_views(flights, shapes=shapes)
    rows: list[list[Panel | None]] = [*([[*forces]] if forces else []), *([each] for each in views)]
    without = [name for name in flights if name not in histories] if histories else []
    return Picture(
        name="flight", caption="The flight from the side and from above, and the forces where a model has them",
        rows=rows, heights=[*([2.2] if forces else []), *heights], title=title, legend=True,
        height=(2.4 if forces else 0.2) + sum(heights) + 1.7,
        footnote=f"no force history (impulse models): {', '.join(without)}" if without else "",
    )  # fmt: skip


def force_picture(histories: Mapping[str, Any]) -> Picture:
    """Return the picture of the forces on the ball over time; ``histories`` as for :func:`shot_picture`."""
    panels = _force_panels(histories, named=True)
    return Picture("forces", "The force on the ball over time", [panels], height=2.5, legend=True)


_FORCES = {
    "normal_force": ("normal force", 1.0),
    "force_y": ("friction down the face,\nmakes backspin", -1.0),
    "force_z": ("friction to the toe", 1.0),
}
"""Friction columns of a history, up the face and towards the toe, with label and sign of the drawn curve."""
_LEAST_FORCE = 20.0
"""Threshold below which sideways friction counts as noise, and minimum extent of a friction axis [N]."""


def _force_panels(histories: Mapping[str, Any], *, named: bool = False) -> list[Panel]:
    """Return the panels of the forces; sideways friction only if there is some."""
    if not histories:
        return []
    sideways = max(float(np.abs(_values(each, "force_z")).max(initial=0.0)) for each in histories.values())
    panels = []
    for name, (label, sign) in _FORCES.items():
        if name == "force_z" and sideways <= _LEAST_FORCE:
            continue
        marks = [
            Mark("line", _values(each, "time"), sign * _values(each, name), style=model, label=model if named else "")
            for model, each in histories.items()
        ]
        limits = (0.0, None)
        if name != "normal_force":
            noise = max(float(np.abs(mark.y).max(initial=0.0)) for mark in marks) <= _LEAST_FORCE
            limits = (-_LEAST_FORCE, _LEAST_FORCE) if noise else (None, None)
            marks.append(Mark("rule", y=0.0, style=-1))
        force = axis(name, label, like="N", unit="kN", limits=limits)
        panels.append(Panel(marks, axis("time", unit="us", limits=(0.0, None)), force))
    return panels


def flight_views(
    flights: Mapping[str, Any],
    *,
    shapes: Mapping[str, str] | None = None,
    styles: Mapping[str, str | int] | None = None,
    starts: bool = True,
) -> tuple[list[Panel], list[float]]:
    """Return panels of flights from the side and from above, to scale, and their heights [inches].

    ``flights`` are positions of the ball [m], shape [n, 3], by name; ``shapes`` are the golfer's names of the shots,
    for the legend; ``styles`` are line styles. Default: by model. ``starts`` draws the start lines of the balls.
    """
    paths = {name: np.asarray(each, dtype=float) for name, each in flights.items()}
    labels = {name: f"{name}: {shape}" if (shape := (shapes or {}).get(name)) else name for name in paths}
    begun = starts and len(paths) <= _MOST_STARTS
    start_lines = [_start_line(path) for path in paths.values() if len(path) > 1] if begun else []
    positions = np.concatenate(list(paths.values()))
    across_all = np.concatenate([positions[:, 2], *(each.y for each in start_lines)])
    length = 1.03 * max(float(positions[:, 0].max()), 1.0)
    back = min(1.03 * float(positions[:, 0].min()), 0.0)
    least, margin = _LEAST_SIDE * length, 0.06 * float(np.ptp(across_all))
    right = max(float(across_all.max()) + margin, least)
    left = min(float(across_all.min()) - margin, -least)
    highest = max(1.06 * float(positions[:, 1].max()), _LEAST_HEIGHT * length)
    along = axis("carry", "distance along the target line", limits=(back, length))
    panels, heights = [], []
    for title, place, across in (
        ("from the side, to scale", 1, axis("apex", "height", limits=(0.0, highest))),
        ("from above, to scale", 2, axis("side", "right", limits=(left, right), reversed=True)),
    ):
        marks = [
            Mark("line", path[:, 0], path[:, place], style=name if styles is None else styles[name], label=labels[name])
            for name, path in paths.items()
        ]
        if place == 2:
            marks.insert(0, Mark("rule", y=0.0, style=-1))
            marks += start_lines
        low, high = across.limits
        panels.append(Panel(marks, along, across, title=title, equal=True))
        heights.append(_WIDTH * min(((high or 0.0) - (low or 0.0)) / (length - back), _TALLEST))
    return panels, heights


def _start_line(path: NDArray[Any]) -> Mark:
    """Return the start line of a ball, as long as its carry."""
    way = path[1, [0, 2]] - path[0, [0, 2]]
    reach = float(np.hypot(*path[-1, [0, 2]])) / max(float(np.hypot(*way)), 1e-9)
    return Mark("line", [0.0, reach * way[0]], [0.0, reach * way[1]], style=-1, dash=2, size=0.8, label="start line")


def _values(history: Any, name: str) -> Any:
    return np.asarray(history[name] if isinstance(history, Mapping) else getattr(history, name), dtype=float)


def batch_provenance(batch: Batch) -> Provenance:
    """Return the provenance of a batch of launches or flights."""
    if isinstance(batch, Launch):
        return provenance_of([batch])
    assert isinstance(batch, Flight)
    return _flight_provenance(batch.launch, batch.inputs)


def comparison_result(launches: Comparison) -> Result:
    """Return the launches by several models as a result, one row per shot and model."""
    tables = [each.to_result().tables[0] for each in launches.values()]
    first = tables[0]
    models = [name for name, each in zip(launches, tables, strict=True) for _ in range(len(each))]
    columns = [
        Column(each.name, [value for table in tables for value in table[each.name].values], each.quantity)
        for each in first.columns
    ]
    notes = tuple(dict.fromkeys(each for launch in launches.values() for each in launch.to_result().notes))
    return Result(
        "launches", f"{subject(next(iter(launches.values())))}, by {', '.join(launches)}",
        (Table("launches", (text("model", models), *columns)),),
        assumptions=(*assumptions_of(launches.values()), *rigid_faces(launches)), notes=notes,
        provenance=provenance_of(launches.values()),
    )  # fmt: skip


def history_result(history: History) -> Result:
    """Return a contact as a result: its time and peak force, and every step in files."""
    launch = history.launch
    values = (column("contact_time", [launch.contact_time]), column("peak_force", [launch.peak_force]))
    return Result(
        "history", f"{subject(launch)}: contact by {launch.model}", (_series_table("steps", history),), values,
        assumptions=assumptions_of([launch]), provenance=provenance_of([launch]),
    )  # fmt: skip


def trajectory_result(path: Trajectory) -> Result:
    """Return the path of a ball as a result: time and place of its landing, and every point in files."""
    values = (
        column("flight_time", [path.time[-1]]), column("apex", [path.position[:, 1].max()]),
        column("carry", [path.position[-1, 0]]), column("side", [path.position[-1, 2]]),
    )  # fmt: skip
    return Result(
        "trajectory", "Path of a ball", (_series_table("points", path),), values,
        assumptions=() if path.launch is None else assumptions_of([path.launch]),
        provenance=_flight_provenance(path.launch, path.inputs),
    )  # fmt: skip


def _flight_provenance(launch: Launch | None, inputs: Mapping[str, ArrayLike]) -> Provenance:
    """Return the provenance of a flight: the launch or its values, air and ground."""
    known = flight_inputs()
    shown = {name: value for name, value in inputs.items() if launch is None or known[name].group in ("air", "ground")}
    return provenance_of([] if launch is None else [launch], dict(flight_input_words(shown)))


def _series_table(name: str, series: Series) -> Table:
    """Return a table with one row per time, vectors by component; not shown in the terminal."""
    columns = [column(each, values, unit) for each, (values, unit) in series.components().items()]
    return Table(name, tuple(columns), printed=False)
