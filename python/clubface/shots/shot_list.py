"""Shots one by one as a result: measured values, computed values for the rest, and flight paths.

Computed values fill in what the monitor did not measure, and are named in each row: launches from club data by the
model, flights from launches in still air.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.clubs import CLUB_NAMES, Club, club as club_named
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError, RangeWarning
from clubface.results.notes import Note, note
from clubface.results.result import Provenance, Result
from clubface.results.table import column, table, text
from clubface.shots.club_names import club_kind
from clubface.shots.recorded import RecordedShots
from clubface.shots.reference_points import refer
from clubface.shots.session_summary import summarize_clubs
from clubface.simulation.flight import fly, trajectory
from clubface.simulation.impact import impact
from clubface.simulation.inputs import OF_CLUB
from clubface.simulation.launch import Launch
from clubface.simulation.provenance import flight_conditions
from clubface.simulation.shot_shape import curve, shot_shape
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings

LAUNCHED = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")
"""Launch quantities needed for a flight."""
SPINS = ("total_spin", "spin_axis")
FLOWN = ("carry", "side", "apex", "landing_angle", "flight_time", "total", "total_side")
"""Flight quantities computed."""
RESTED = ("total", "total_side")
"""Flight quantities that depend on where the ball comes to rest."""
FIRST = (*OF_CLUB, "ball_speed", "smash", "launch", "azimuth", *SPINS, "backspin", "sidespin", *FLOWN)
"""First columns, in order; others follow."""
MOST_PATHS = 1000
"""Maximum number of flight paths computed."""
POINTS = 31
"""Number of points per flight path."""


@dataclass(frozen=True)
class CompletedShots:
    """Shots with measured and computed values."""

    shots: RecordedShots  # as measured
    values: Mapping[str, Floats]  # measured and computed values by quantity [SI]; NaN for neither
    is_computed: Mapping[str, NDArray[np.bool_]]  # whether each value is computed, by quantity
    impossible: int  # number of shots for which the model gives no launch
    launches: Mapping[int, Launch]  # computed launches by shot; their flights use the full spin

    @property
    def flies(self) -> NDArray[np.bool_]:
        """Whether each shot has everything a flight needs."""
        return _known(self.values, LAUNCHED, len(self.shots))

    def computed_at(self, place: int) -> list[str]:
        """Return the names of a shot's computed quantities."""
        return [name for name in _ordered(self.values) if name in self.is_computed and self.is_computed[name][place]]

    def launch(self, place: int) -> dict[str, float]:
        """Return the known launch quantities of a shot [SI]."""
        names = (*LAUNCHED, *SPINS)
        every = {name: float(self.values[name][place]) for name in names if name in self.values}
        return {name: value for name, value in every.items() if value == value}


def completed(shots: RecordedShots) -> CompletedShots:
    """Return shots completed by launches from club data, if the ball was not measured, and by flights."""
    count = len(shots)
    values = {name: each.copy() for name, each in (shots.deliveries | shots.launches).items()}
    is_computed: dict[str, NDArray[np.bool_]] = {}

    def fill(name: str, result: Floats) -> None:
        own = values.setdefault(name, np.full(count, np.nan))
        filled = np.isnan(own) & np.isfinite(result)
        if filled.any():
            own[filled] = result[filled]
            is_computed[name] = is_computed.get(name, np.zeros(count, dtype=bool)) | filled
        elif np.isnan(own).all():
            del values[name]

    launches, impossible = _launches(shots)
    for name in (*LAUNCHED, *SPINS):
        result = np.full(count, np.nan)
        for place, launch in launches.items():
            result[place] = getattr(launch, name)
        fill(name, result)
    flies = _known(values, LAUNCHED, count)
    if flies.any():
        flight = fly({name: values[name][flies] for name in LAUNCHED}, on_error="nan")
        own = {place: fly(launch, on_error="nan") for place, launch in launches.items()}
        measured_carry = np.isfinite(values.get("carry", np.full(count, np.nan)))
        for name in FLOWN:
            result = np.full(count, np.nan)
            result[flies] = getattr(flight, name)
            for place, each in own.items():
                result[place] = getattr(each, name)
            if name in RESTED:  # a computed total must not be combined with a measured carry
                result[measured_carry] = np.nan
            fill(name, result)
    return CompletedShots(shots, values, is_computed, impossible, launches)


def shot_list_result(shots: RecordedShots, *, first: int = 1, title: str = "") -> Result:
    """Return shots one by one, numbered from ``first``, with their flight paths; the title defaults to the source."""
    every = completed(shots)
    numbers = list(range(first, first + len(shots)))
    mishits = {each.place: each.quantity for club in summarize_clubs(shots) for each in reversed(club.mishits)}
    names = _ordered(every.values)
    texts = {heading: getattr(shots, name) for name, heading in
             (("clubs", "club"), ("players", "player"), ("dates", "date"), ("files", "file"))}  # fmt: skip
    rows = table(
        "shots",
        text("shot", numbers),
        text("line", [int(each) for each in shots.rows], label=shots.row_word, printed=False),
        *(None if each is None else text(name, [str(one) for one in each]) for name, each in texts.items()),
        text("kind", _kinds(shots), printed=False),
        text("shape", _shapes(every)),
        text("mishit", [mishits.get(place, "") for place in range(len(shots))], label="far off"),
        *(column(name, every.values[name], name) for name in names),
        text("computed", [" ".join(every.computed_at(place)) for place in range(len(shots))]),
    )
    return Result(
        "shot-list",
        title or f"{shots.source} ({shots.format})",
        (rows, _paths(every, numbers)),
        notes=(*_remarks(every), *shots.notes),
        provenance=Provenance(inputs={"file": shots.source, "read as": shots.format, **flight_conditions()}),
    )


def _ordered(names: Mapping[str, Any]) -> list[str]:
    return [*(name for name in FIRST if name in names), *(name for name in names if name not in FIRST)]


def _known(values: Mapping[str, Floats], names: Sequence[str], count: int) -> NDArray[np.bool_]:
    if not all(name in values for name in names):
        return np.zeros(count, dtype=bool)
    return np.all([np.isfinite(values[name]) for name in names], axis=0)


def _kinds(shots: RecordedShots) -> list[str]:
    """Return the built-in club for each shot, or "" if there is none."""
    if shots.clubs is None:
        return [""] * len(shots)
    return [kind if (kind := club_kind(str(each))) in CLUB_NAMES else "" for each in shots.clubs]


@cache
def _head(kind: str, hand: str) -> Club:
    return club_named(kind).replace(hand=hand)


def _launches(shots: RecordedShots) -> tuple[dict[int, Launch], int]:
    """Return computed launches of shots with club data and a known club but no ball data, and the number refused."""
    count = len(shots)
    result: dict[int, Launch] = {}
    speed = shots.deliveries.get("speed", np.full(count, np.nan))
    alone = np.isfinite(speed) & np.isnan(shots.launches.get("ball_speed", np.full(count, np.nan)))
    kinds, impossible = np.array(_kinds(shots), dtype=object), 0
    hands = shots.hand if shots.hand is not None else np.array(["right"] * count, dtype=object)
    for kind, hand in dict.fromkeys(zip(kinds[alone], hands[alone], strict=True)):
        if not kind:
            continue
        places = np.flatnonzero(alone & (kinds == kind) & (hands == hand))
        chosen = refer(shots.select(places), _head(kind, hand))
        for row, place in enumerate(places):
            measured = {name: float(each[row]) for name, each in chosen.deliveries.items() if name in OF_CLUB}
            delivery = {name: value for name, value in measured.items() if value == value}
            try:
                with without_warnings(RangeWarning):
                    result[int(place)] = impact(_head(kind, hand), delivery, model=DEFAULT_MODEL)
            except InputError:
                impossible += 1
    return result, impossible


def _shapes(every: CompletedShots) -> list[str]:
    """Return the shape of each shot, such as "push fade"; "" if its start, carry or side is unknown."""
    count, values = len(every.shots), every.values
    known = _known(values, ("azimuth", "carry", "side"), count)
    result = np.full(count, "", dtype=object)
    if known.any():
        azimuth, carry, side = (values[name][known] for name in ("azimuth", "carry", "side"))
        hands = np.ones(count) if every.shots.hand is None else np.where(every.shots.hand == "left", -1.0, 1.0)
        result[known] = shot_shape(azimuth, curve(azimuth, carry, side), carry, hand=hands[known])
    return result.tolist()


def _paths(every: CompletedShots, numbers: Sequence[int]) -> Any:
    """Return the table of the points of all flight paths, shot by shot."""
    shot: list[int] = []
    points: list[NDArray[Any]] = []
    for place in np.flatnonzero(every.flies)[:MOST_PATHS]:
        try:
            launch = every.launches.get(int(place)) or {name: float(every.values[name][place]) for name in LAUNCHED}
            position = trajectory(launch).position
        except InputError:
            continue
        chosen = np.unique(np.linspace(0, len(position) - 1, POINTS).round().astype(int))
        points.append(position[chosen])
        shot += [numbers[place]] * len(chosen)
    xyz = np.concatenate(points) if points else np.empty((0, 3))
    return table(
        "paths",
        text("shot", shot),
        column("along", xyz[:, 0], "m", label="distance to the target"),
        column("height", xyz[:, 1], "m", label="height"),
        column("side", xyz[:, 2], "m", label="distance to the right"),
        printed=False,
    )


def _remarks(every: CompletedShots) -> Iterator[Note]:
    count, flies = len(every.shots), int(every.flies.sum())
    if "ball_speed" in every.is_computed:
        made = int(every.is_computed["ball_speed"].sum())
        yield note("launch-from-club-data", made=made, shots=count, model=DEFAULT_MODEL)
    if every.impossible:
        yield note("launch-refused", refused=every.impossible)
    if flies:
        yield note("paths-in-still-air")
    if flies < count:
        yield note("shots-without-path", without=count - flies, shots=count)
    if flies > MOST_PATHS:
        yield note("paths-of-first-shots", drawn=MOST_PATHS, shots=count)
