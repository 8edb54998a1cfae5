"""A session on one's own monitor compared with the model and with the two camps of published irons.

At the same launch and speed the irons of the tours spin up to a quarter more than irons swung by robots and those of
single golfers before carefully described monitors. No model meets both, so that it matters which of them a monitor
resembles. Every set is compared with one model at its own measured launch, which takes out speed, launch and club; what
is left is the spin measured over the spin computed. Lofts that monitors compute from the ball enter none of it.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import club as club_named
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError, RangeWarning
from clubface.shots.measured import LAUNCH, measured_shots, ready_shots
from clubface.shots.reading import read
from clubface.shots.recorded import RecordedShots
from clubface.simulation.launch_conditioned import impact_at_launch
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings
from clubface.validation.check import rows
from clubface.validation.launches import DRIVER, HEIGHTS, ROBOT
from clubface.validation.tour import TABLES, averages

TOURS, SINGLE = CAMPS = ("tours", "robots and single golfers")
SINGLE_TABLES = ("robot-7-irons-launch-2026", "shots-bliss-2026", "shots-r50-2026")
UNDECIDED, NEITHER = "undecided", "neither"
FEWEST = 5
"""Shots of a club below which no interval means anything."""
RESAMPLES, SEED = 2000, 0
LIKELY = 0.95


class Share(NamedTuple):
    """Measured over computed: the median over the shots, and between which values it lies with 95%."""

    middle: float
    low: float
    high: float


class OwnClub(NamedTuple):
    """One club of a session.

    Attributes
    ----------
    club, head
        Its name in the file, and the built-in club it is computed with.
    shots
        Number of shots compared.
    launch, spin
        Medians of the measured launch angle [rad] and spin [rad/s].
    spin_index
        Median of the spin over club speed times the sine of the angle from path to launch [rad/m].
    spin_share, speed_share
        Measured over computed at the measured launch, of spin and ball speed; the latter None where not measured.
    camps
        The least and the largest share of spin of each camp; empty but for the irons of the tours.
    resembles
        The camp within which the whole interval lies, with half of the gap between both, or ``UNDECIDED`` or
        ``NEITHER``; "" without camps.
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


class OwnMonitor(NamedTuple):
    """A session compared with the model.

    Attributes
    ----------
    source, model
        The file and the model.
    clubs
        What was compared.
    notes
        What was left out and why, and what the shots say of themselves.
    """

    source: str
    model: str
    clubs: tuple[OwnClub, ...]
    notes: tuple[str, ...]


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
        Recorded shots that name their clubs, or files that :func:`clubface.shots.read` reads. Club speed,
        attack angle, launch angle and spin must have been measured.
    model, ball
        As for :func:`clubface.impact`; the camps are computed with the same.
    """
    recorded = shots if isinstance(shots, RecordedShots) else read(shots)
    if recorded.clubs is None:
        raise InputError("shots", recorded.source, "shots that name their clubs")
    clubs: list[OwnClub] = []
    left_out: list[str] = []
    notes: list[str] = []
    for name in dict.fromkeys(map(str, recorded.clubs)):
        try:
            found = _own_club(recorded, name, model, ball, notes)
        except InputError as error:
            left_out.append(f"{name or 'shots without a club'}: left out ({error})")
            continue
        if all(found.head != each.head for each in clubs):  # 7i and 7 Iron are one club
            clubs.append(found)
    if not clubs:
        raise InputError("shots", recorded.source, f"shots that can be compared ({'; '.join(left_out)})")
    return OwnMonitor(recorded.source, model, tuple(clubs), tuple(dict.fromkeys([*left_out, *notes])))


def _own_club(recorded: RecordedShots, name: str, model: str, ball: Any, notes: list[str]) -> OwnClub:
    ready = ready_shots(recorded, only=name, mismatch="note")
    measured = measured_shots(ready, compared_at=LAUNCH, quantities=("ball_speed", "backspin", "sidespin"))
    kind = "total_spin" if "total_spin" in ready.launches else "backspin"
    for needed, there in (("attack", measured.delivery), (kind, ready.launches)):
        if needed not in there:
            raise InputError(needed, None, "measured, to compare spin at the measured launch")
    notes += measured.notes
    spin = ready.launches[kind][measured.places]
    # Without the path, the start direction says nothing of the face angle.
    start: dict[str, Any] = {
        each: values for each, values in measured.start.items() if each == "launch" or "path" in measured.delivery
    }
    delivery = dict(measured.delivery)
    if ready.club.name == DRIVER and "high" not in delivery:
        strike = HEIGHTS[len(HEIGHTS) // 2]
        delivery["high"] = np.full(len(measured), strike)
        notes.append(f"drives are taken to be struck {units.show(strike, 'mm', 2)} above the face centre")
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
    index = spin / (measured.delivery["speed"] * np.sin(_turned(measured.delivery, start)))
    return OwnClub(
        name, ready.club.name, int(used.sum()), float(np.median(start["launch"][used])), float(np.median(spin[used])),
        float(np.median(index[used])), spins,
        None if speeds is None or not np.isfinite(speeds).any() else _share(speeds[np.isfinite(speeds)]),
        camps, resembled(spins, camps) if camps else "",
    )  # fmt: skip


def _turned(delivery: Mapping[str, Floats], start: Mapping[str, Floats]) -> Floats:
    """Return the angle from the path of the club to the launch [rad]."""
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
    """Return the camp in which the interval of a share lies, each camp being wider by half of the gap between both."""
    gap = max(0.0, camps[TOURS][0] - camps[SINGLE][1])
    wide = {name: (low - 0.5 * gap, high + 0.5 * gap) for name, (low, high) in camps.items()}
    for name, (low, high) in wide.items():
        if low <= share.low and share.high <= high:
            return name
    apart = all(share.high < low or share.low > high for low, high in wide.values())
    return NEITHER if apart else UNDECIDED


def camps_of(head: str, model: str, ball: Any = None) -> dict[str, tuple[float, float]]:
    """Return the least and the largest share of spin of each camp: the tours with this iron, and all other irons.

    Empty for irons that no tour publishes.
    """
    try:
        shares = _shares(model, ball)
    except TypeError:  # a ball that is not hashable
        shares = _shares.__wrapped__(model, ball)
    tours = shares.get((TOURS, head))
    if tours is None:
        return {}
    single = [each for (camp, _), values in shares.items() if camp == SINGLE for each in values]
    return {TOURS: (min(tours), max(tours)), SINGLE: (min(single), max(single))}


@cache
def _shares(model: str, ball: Any) -> dict[tuple[str, str], list[float]]:
    """Return the shares of spin of all published irons by camp and club."""
    found: dict[tuple[str, str], list[float]] = {}
    published = list(_published())
    for camp, name in dict.fromkeys((camp, row["club"]) for camp, row in published):
        group = [row for each, row in published if (each, row["club"]) == (camp, name)]
        speed, attack, launch, spin = (
            np.array([row[key] for row in group]) for key in ("club_speed", "attack", "launch", "spin")
        )
        with without_warnings(RangeWarning):
            shot = impact_at_launch(name, speed=speed, attack=attack, launch=launch, model=model, ball=ball)
        found[camp, name] = (spin / shot.launch.total_spin).tolist()
    return found


def _published() -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Yield camp, and club, speed, attack angle, launch and spin of every published iron."""
    published = [(TOURS, each._asdict()) for table in TABLES for each in averages(table)]
    published += [(SINGLE, row) for table in SINGLE_TABLES for row in rows(table)]
    for camp, row in published:
        shot = row if "club" in row else {**ROBOT, **row, "club": "7-iron"}
        if club_named(shot["club"]).kind == "iron":
            yield camp, shot


def index_of_camps() -> dict[str, dict[str, tuple[float, float]]]:
    """Return the least and the largest spin index [rad/m] of the published tables, by iron of the tours and camp."""
    found: dict[str, dict[str, list[float]]] = {}
    for camp, row in _published():
        index = float(row["spin"] / (row["club_speed"] * np.sin(row["launch"] - row["attack"])))
        found.setdefault(row["club"], {}).setdefault(camp, []).append(index)
    return {
        club: {camp: (min(values), max(values)) for camp, values in camps.items()}
        for club, camps in found.items()
        if TOURS in camps
    }


def index_in_rpm_per_mph(index: float) -> float:
    """Express an index in rpm per mph."""
    return float(index / units.size("rpm") * units.size("mph"))


HEADS = [
    "club", "shots", "launch\ndeg", "spin\nrpm", "index\nrpm/mph", "speed,\nmeas./model", "spin,\nmeas./model", "\n95%",
    "spin,\ntours", "spin, robots,\nsingle golfers", "resembles",
]  # fmt: skip


def table_rows(result: OwnMonitor) -> list[list[str]]:
    """Return one row a club, under ``HEADS``."""
    found = []
    for each in result.clubs:
        camps = [f"{low:.2f} to {high:.2f}" for low, high in each.camps.values()] or ["", ""]
        speed = "" if each.speed_share is None else f"{each.speed_share.middle:.3f}"
        found.append([
            each.club, str(each.shots), f"{units.from_si(each.launch, 'deg'):.1f}",
            f"{units.from_si(each.spin, 'rpm'):.0f}",
            f"{index_in_rpm_per_mph(each.spin_index):.0f}", speed, f"{each.spin_share.middle:.2f}",
            f"{each.spin_share.low:.2f} to {each.spin_share.high:.2f}", *camps, each.resembles,
        ])  # fmt: skip
    return found


def remarks(result: OwnMonitor) -> list[str]:
    """Return how the table is to be read, then the notes."""
    seven = index_of_camps()["7-iron"]
    ends = {name: " to ".join(f"{index_in_rpm_per_mph(each):.0f}" for each in pair) for name, pair in seven.items()}
    found = [
        f"measured/model: at the measured launch, with loft and face angle solved, by {result.model}; the interval is"
        " that of shots drawn again. A head or ball of your own may be some percent away from those computed with.",
        f"index: spin over club speed times the sine of the angle from path to launch; of 7-irons {ends[TOURS]} in the"
        f" averages of tours, {ends[SINGLE]} with robots and single golfers.",
    ]
    irons = [each.resembles for each in result.clubs if each.camps]
    if irons:
        counts = ", ".join(f"{irons.count(each)} {each}" for each in dict.fromkeys(irons))
        found.append(f"irons resemble: {counts}")
        found.append(
            "resembles: the camp of published irons in which the whole interval lies, each camp being wider by half of"
            " the gap between both; undecided if it crosses a border."
        )
    return [*found, *result.notes]


def document(result: OwnMonitor) -> dict[str, Any]:
    """Return everything as plain values for JSON, SI."""
    clubs = [
        each._asdict() | {
            "spin_share": each.spin_share._asdict(),
            "speed_share": None if each.speed_share is None else each.speed_share._asdict(),
            "camps": {name: list(pair) for name, pair in each.camps.items()},
        }
        for each in result.clubs
    ]  # fmt: skip
    return {
        "source": result.source, "model": result.model, "clubs": clubs,
        "index_of_camps": index_of_camps(), "notes": list(result.notes),
    }  # fmt: skip
