"""A session on your own monitor compared with the model and with the two camps of published iron data.

At the same launch and speed, irons in tour averages spin up to a quarter more than irons hit by robots and by single
golfers on carefully documented monitors. No model matches both, so it matters which camp a monitor resembles. Every set
is compared with one model at its own measured launch, which removes the effects of speed, launch and club and leaves
the ratio of measured to computed spin. Lofts that monitors compute from the ball are not used.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import club as club_named
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError, RangeWarning
from clubface.results.notes import Note, note
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, table, text
from clubface.shots.measured import LAUNCH, measured_shots, ready_shots
from clubface.shots.reading import read
from clubface.shots.recorded import RecordedShots
from clubface.simulation.launch_conditioned import impact_at_launch
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings
from clubface.validation.check import rows
from clubface.validation.launches import DRIVER, HEIGHTS, ROBOT
from clubface.validation.tour import TABLES, averages

__all__ = ["OwnClub", "OwnMonitor", "Share", "own_monitor"]

TOURS, SINGLE = CAMPS = ("tours", "robots and single golfers")
SINGLE_TABLES = ("robot-7-irons-launch-2026", "shots-bliss-2026", "shots-r50-2026")
UNDECIDED, NEITHER = "undecided", "neither"
FEWEST = 5
"""Minimum number of shots with a club for a meaningful interval."""
RESAMPLES, SEED = 2000, 0
LIKELY = 0.95


class Share(NamedTuple):
    """Measured over computed: median over the shots with its 95% interval."""

    middle: float
    low: float
    high: float


class OwnClub(NamedTuple):
    """One club of a session.

    Attributes
    ----------
    club, head
        Name in the file, and the built-in club used for the computation.
    shots
        Number of shots compared.
    launch, spin
        Medians of the measured launch angle [rad] and spin [rad/s].
    spin_index
        Median of spin divided by club speed times the sine of the angle from path to launch [rad/m].
    spin_share, speed_share
        Measured over computed spin and ball speed at the measured launch; the latter None if not measured.
    camps
        Range of the spin share in each camp; empty except for irons in the tour averages.
    resembles
        The camp whose range, widened by half the gap between both, contains the whole interval; else ``UNDECIDED`` or
        ``NEITHER``, or "" without camps.
    """

    club: str
    head: str
    shots: int
    launch: float
    spin: float
    spin_index: float
    spin_share: Share
    speed_share: Share | None
    camps: Mapping[str, tuple[float, float]]
    resembles: str


@dataclass(frozen=True)
class OwnMonitor(Described):
    """A session compared with the model.

    Attributes
    ----------
    source, model, ball
        The file, the model, and the ball as given.
    clubs
        The clubs compared.
    notes
        Clubs left out with reasons, and notes on the shots.
    """

    source: str
    model: str
    ball: Any
    clubs: tuple[OwnClub, ...]
    notes: tuple[Note, ...]

    def to_result(self) -> Result:
        """Return the comparison as a result: one row per club, and the camps."""
        return Result(
            kind="own-monitor", title=f"{self.source} compared with {self.model} at its own measured launch",
            tables=(self._club_table(), camp_table(self.model, self.ball)), notes=tuple(self._notes()),
        )  # fmt: skip

    def _club_table(self) -> Table:
        clubs, speeds = self.clubs, [each.speed_share for each in self.clubs]
        return table(
            "own_monitor", text("club", [each.club for each in clubs]),
            text("head", [each.head for each in clubs], printed=False), text("shots", [each.shots for each in clubs]),
            column("launch", [each.launch for each in clubs]), column("spin", [each.spin for each in clubs]),
            text("index_rpm_per_mph", [_rpm_per_mph(each.spin_index) for each in clubs], label="index, rpm/mph",
                 digits=0),
            *(
                column(f"speed_share{name}", [None if each is None else each[place] for each in speeds], "1", digits=3,
                       label="speed, measured/model", printed=not place)
                for place, name in enumerate(_SHARE_ENDS)
            ),
            *(
                column(f"spin_share{name}", [each.spin_share[place] for each in clubs], "1", digits=2,
                       label="spin, measured/model" if not place else ("95% from", "to")[place - 1])
                for place, name in enumerate(_SHARE_ENDS)
            ),
            *_camp_columns([each.camps for each in clubs]), text("resembles", [each.resembles for each in clubs]),
            title=f"{self.source} compared with {self.model} at its own measured launch",
        )  # fmt: skip

    def _notes(self) -> Iterator[Note]:
        """Yield notes on reading the table, then the notes on the shots."""
        seven = index_of_camps()["7-iron"]
        yield note("own-monitor-share", model=self.model)
        yield note(
            "own-monitor-index",
            **{f"{name}_{end}": _rpm_per_mph(seven[camp][place]) for name, camp, place, end in _CAMP_ENDS},
        )
        irons = [each.resembles for each in self.clubs if each.camps]
        if irons:
            yield note("own-monitor-irons", camps=[f"{irons.count(each)} {each}" for each in dict.fromkeys(irons)])
            yield note("own-monitor-camps")
        yield from self.notes


_SHARE_ENDS = ("", "_low", "_high")
"""Endings of the column names for a :class:`Share`."""


def own_monitor(
    shots: RecordedShots | str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    *,
    model: str = DEFAULT_MODEL,
    ball: str | os.PathLike[str] | Ball | None = None,
) -> OwnMonitor:
    """Compare a session with a model at its own measured launch, and its irons with both camps.

    Parameters
    ----------
    shots
        Recorded shots with club names, or files for :func:`clubface.shots.read`. Club speed, attack angle, launch angle
        and spin must have been measured.
    model, ball
        As for :func:`clubface.impact`; also used for the camps.
    """
    recorded = shots if isinstance(shots, RecordedShots) else read(shots)
    if recorded.clubs is None:
        raise InputError("shots", recorded.source, "shots that name their clubs")
    clubs: dict[str, OwnClub] = {}
    left_out: list[Note] = []
    notes: list[Note] = []
    for name in dict.fromkeys(map(str, recorded.clubs)):
        try:
            club = _own_club(recorded, name, model, ball, notes)
        except InputError as error:
            left_out.append(note("own-monitor-left-out", club=name or "shots without a club", reason=str(error)))
            continue
        clubs.setdefault(club.head, club)  # 7i and 7 Iron are one club
    if not clubs:
        reasons = "; ".join(each.sentence for each in left_out)
        raise InputError("shots", recorded.source, f"shots that can be compared ({reasons})")
    return OwnMonitor(recorded.source, model, ball, tuple(clubs.values()), (*left_out, *notes))


def _own_club(recorded: RecordedShots, name: str, model: str, ball: Any, notes: list[Note]) -> OwnClub:
    ready = ready_shots(recorded, only=name, mismatch="note")
    measured = measured_shots(ready, compared_at=LAUNCH, quantities=("ball_speed", "backspin", "sidespin"))
    kind = "total_spin" if "total_spin" in ready.launches else "backspin"
    for needed, there in (("attack", measured.delivery), (kind, ready.launches)):
        if needed not in there:
            raise InputError(needed, None, "measured, to compare spin at the measured launch")
    notes += measured.notes
    spin = ready.launches[kind][measured.places]
    # Without the path, start direction does not determine the face angle.
    start: dict[str, Any] = {
        each: values for each, values in measured.start.items() if each == "launch" or "path" in measured.delivery
    }
    delivery = dict(measured.delivery)
    if ready.club.name == DRIVER and "high" not in delivery:
        strike = HEIGHTS[len(HEIGHTS) // 2]
        delivery["high"] = np.full(len(measured), strike)
        notes.append(note("own-monitor-strike", high=strike))
    with without_warnings(RangeWarning):
        computed = impact_at_launch(ready.club, delivery, **start, model=model, ball=ball).launch
    share = spin / computed.total_spin
    used = np.isfinite(share)
    if used.sum() < FEWEST:
        raise InputError("shots", int(used.sum()), f"at least {FEWEST} with club speed, attack angle, launch and spin")
    speed = measured.launch.get("ball_speed")
    speeds = None if speed is None else (speed / computed.ball_speed)[used]
    spins = _share(share[used])
    camps = camps_of(ready.club.name, model, ball) if ready.club.kind == "iron" else {}
    index = spin / (measured.delivery["speed"] * np.sin(_launch_angle_from_path(measured.delivery, start)))
    return OwnClub(
        name, ready.club.name, int(used.sum()), float(np.median(start["launch"][used])), float(np.median(spin[used])),
        float(np.median(index[used])), spins,
        None if speeds is None or not np.isfinite(speeds).any() else _share(speeds[np.isfinite(speeds)]),
        camps, resembled(spins, camps) if camps else "",
    )  # fmt: skip


def _launch_angle_from_path(delivery: Mapping[str, Floats], start: Mapping[str, Floats]) -> Floats:
    """Return the angle between the club's path and the launch direction [rad]."""
    attack, launch = delivery["attack"], start["launch"]
    sideways = start["azimuth"] - delivery["path"] if "azimuth" in start else 0.0
    return np.arccos(np.sin(attack) * np.sin(launch) + np.cos(attack) * np.cos(launch) * np.cos(sideways))


def _share(values: Floats) -> Share:
    """Return the median with a bootstrap interval."""
    random = np.random.default_rng(SEED)
    medians = np.median(values[random.integers(values.size, size=(RESAMPLES, values.size))], axis=1)
    low, high = np.quantile(medians, [0.5 * (1.0 - LIKELY), 0.5 * (1.0 + LIKELY)])
    return Share(float(np.median(values)), float(low), float(high))


def resembled(share: Share, camps: Mapping[str, tuple[float, float]]) -> str:
    """Return the camp that contains the interval of a share, after widening both by half the gap between them."""
    gap = max(0.0, camps[TOURS][0] - camps[SINGLE][1])
    wide = {name: (low - 0.5 * gap, high + 0.5 * gap) for name, (low, high) in camps.items()}
    for name, (low, high) in wide.items():
        if low <= share.low and share.high <= high:
            return name
    apart = all(share.high < low or share.low > high for low, high in wide.values())
    return NEITHER if apart else UNDECIDED


def camps_of(head: str, model: str, ball: Any = None) -> dict[str, tuple[float, float]]:
    """Return the range of the spin share in each camp: the tours with this iron, and all other irons.

    Empty for irons without tour averages.
    """
    try:
        shares = _shares(model, ball)
    except TypeError:  # an unhashable ball
        shares = _shares.__wrapped__(model, ball)
    tours = shares.get((TOURS, head))
    if tours is None:
        return {}
    single = [each for (camp, _), values in shares.items() if camp == SINGLE for each in values]
    return {TOURS: (min(tours), max(tours)), SINGLE: (min(single), max(single))}


@cache
def _shares(model: str, ball: Any) -> dict[tuple[str, str], list[float]]:
    """Return the spin shares of all published irons by camp and club."""
    shares: dict[tuple[str, str], list[float]] = {}
    published = list(_published())
    for camp, name in dict.fromkeys((camp, row["club"]) for camp, row in published):
        group = [row for each, row in published if (each, row["club"]) == (camp, name)]
        speed, attack, launch, spin = (
            np.array([row[key] for row in group]) for key in ("club_speed", "attack", "launch", "spin")
        )
        with without_warnings(RangeWarning):
            shot = impact_at_launch(name, speed=speed, attack=attack, launch=launch, model=model, ball=ball)
        shares[camp, name] = (spin / shot.launch.total_spin).tolist()
    return shares


def _published() -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Yield camp, and club, speed, attack angle, launch and spin of every published iron."""
    published = [(TOURS, each._asdict()) for name in TABLES for each in averages(name)]
    published += [(SINGLE, row) for name in SINGLE_TABLES for row in rows(name)]
    for camp, row in published:
        shot = row if "club" in row else {**ROBOT, **row, "club": "7-iron"}
        if club_named(shot["club"]).kind == "iron":
            yield camp, shot


def index_of_camps() -> dict[str, dict[str, tuple[float, float]]]:
    """Return the range of the spin index [rad/m] in published tables, by iron and camp, for irons of the tours."""
    indices: dict[str, dict[str, list[float]]] = {}
    for camp, row in _published():
        index = float(row["spin"] / (row["club_speed"] * np.sin(row["launch"] - row["attack"])))
        indices.setdefault(row["club"], {}).setdefault(camp, []).append(index)
    return {
        club: {camp: (min(values), max(values)) for camp, values in camps.items()}
        for club, camps in indices.items()
        if TOURS in camps
    }


def camp_table(model: str = DEFAULT_MODEL, ball: Any = None) -> Table:
    """Return the table of both camps' ranges of spin index and of measured over computed spin, by iron."""
    indices = index_of_camps()
    shares = {club: camps_of(club, model, ball) for club in indices}
    return table(
        "camps", text("club", list(indices)),
        *(
            text(f"{name}_{end}_index_rpm_per_mph",
                 [_rpm_per_mph(each[camp][place]) if camp in each else None for each in indices.values()],
                 label=f"index, {camp}, {end}", digits=0)
            for name, camp, place, end in _CAMP_ENDS
        ),
        *_camp_columns(list(shares.values())),
        title="Camps of published irons: spin index in rpm/mph, and measured over computed spin", printed=False,
    )  # fmt: skip


_CAMP_ENDS = [
    (name, camp, place, end)
    for name, camp in zip(("tours", "single"), CAMPS, strict=True)
    for place, end in enumerate(("least", "most"))
]


def _camp_columns(camps: Sequence[Mapping[str, tuple[float, float]]]) -> list[Column]:
    """Return columns with the range of the spin share in each camp."""
    return [
        column(f"{name}_{end}_share", [each[camp][place] if each else None for each in camps], "1", digits=2,
               label=f"spin, {camp}, {end}")
        for name, camp, place, end in _CAMP_ENDS
    ]  # fmt: skip


def _rpm_per_mph(index: float) -> float:
    return float(index / units.size("rpm") * units.size("mph"))
