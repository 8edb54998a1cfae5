"""Recorded shots prepared for comparison with models: one club, complete rows, and notes on what was assumed."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.clubs import Club, club
from clubface.errors import InputError, Told
from clubface.launch_monitor import read, refer
from clubface.measured.other_club import check_club
from clubface.recorded.shots import RecordedShots, RejectedRow
from clubface.simulation.delivery import OF_CLUB

QUANTITIES = {"ball_speed": "mph", "launch": "deg", "azimuth": "deg", "backspin": "rpm", "sidespin": "rpm"}
"""The launch quantities on which models are compared, in the order of the published tables, and their usual units."""


@dataclass(frozen=True, kw_only=True, eq=False)
class MeasuredShots:
    """Shots of one club, each with a complete delivery and at least one measured launch quantity, in SI units.

    Attributes
    ----------
    club
        The club with which they were hit.
    delivery
        The measured part of each delivery, as :func:`impact` takes it; the hand, where it is known, as +1 or -1.
    launch
        The measured part of each launch, by name, in the order of ``QUANTITIES``; NaN where it was not measured.
    rows
        Row of each shot in the source.
    places
        Place of each shot (from 0) among the recorded shots given.
    source
        The file, or another name.
    dropped
        The shots left out and the reasons, including the rejected rows of the file.
    notes
        What was assumed.
    """

    club: Club
    delivery: dict[str, NDArray[np.float64]]
    launch: dict[str, NDArray[np.float64]]
    rows: NDArray[np.int64]
    places: NDArray[np.int64]
    source: str
    dropped: tuple[RejectedRow, ...]
    notes: tuple[str, ...]

    def __len__(self) -> int:
        return len(self.rows)

    def select(self, which: NDArray[Any]) -> Self:
        """Return some of the shots, by a mask or indices."""
        return replace(
            self,
            delivery={name: values[which] for name, values in self.delivery.items()},
            launch={name: values[which] for name, values in self.launch.items()},
            rows=self.rows[which],
            places=self.places[which],
        )


def measured_shots(
    shots: RecordedShots | str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club | None = None,
    only: str | None = None,
    mismatch: str = "refuse",
    quantities: Iterable[str] = tuple(QUANTITIES),
) -> MeasuredShots:
    """Prepare recorded shots for comparison with models.

    Parameters
    ----------
    shots
        Recorded shots, or a file that :func:`clubface.launch_monitor.read` reads.
    club
        The club with which they were hit. If left out: the club that the shots name, if that is a built-in one.
        Velocities and face angles that were measured elsewhere on the club are converted to its reference points, see
        :func:`clubface.launch_monitor.refer`.
    only
        Take only the shots of the club that the file calls so. If left out: all shots, which must then be of one club.
    mismatch
        What to do with shots that by their names or their dynamic loft look like those of another club: "refuse" or
        "note".
    quantities
        The launch quantities wanted, out of ``QUANTITIES``.

    Raises
    ------
    InputError
        There is no usable shot; the shots are of several clubs, or of another club than the one given; or no column
        gives a speed or a launch.
    """
    recorded = shots if isinstance(shots, RecordedShots) else read(shots)
    places = of_one_club(recorded, only)
    recorded = recorded.select(places)
    head = club_of(recorded, club)
    recorded = refer(recorded, head)
    if "speed" not in recorded.deliveries:
        measured = ", ".join(recorded.deliveries) or "nothing"
        raise InputError(
            "shots",
            recorded.source,
            f"shots with the speed of the clubhead; measured of the deliveries: {measured}",
        )
    wanted = [name for name in quantities if name in recorded.launches]
    if not wanted:
        raise InputError("shots", recorded.source, f"shots with a measured launch: {', '.join(quantities)}")
    delivery = {name: values for name, values in recorded.delivery().items() if np.isfinite(values).any()}
    if "speed" not in delivery:
        raise InputError("speed", Told("empty in every shot"), "measured in at least one")
    reasons: dict[int, str] = {}
    for name, values in delivery.items():
        for row in np.flatnonzero(~np.isfinite(values)):
            reasons.setdefault(int(row), f"{name} was not measured")
    nothing = np.all([~np.isfinite(recorded.launches[name]) for name in wanted], axis=0)
    for row in np.flatnonzero(nothing):
        reasons.setdefault(int(row), "nothing of the launch was measured")
    kept = np.array([row not in reasons for row in range(len(recorded))], dtype=bool)
    dropped = [RejectedRow(int(recorded.rows[row]), reason) for row, reason in sorted(reasons.items())]
    if not kept.any():
        told = "; ".join(f"{each.line}: {each.reason}" for each in dropped[:3])
        raise InputError("shots", recorded.source, f"at least one shot with a complete delivery and a launch ({told})")
    delivery = {name: values[kept] for name, values in delivery.items()}
    names = recorded.clubs if only is None else None
    notes = check_club(head, names, delivery.get("loft"), mismatch)
    return MeasuredShots(
        club=head,
        delivery=delivery,
        launch={name: recorded.launches[name][kept] for name in wanted},
        rows=recorded.rows[kept],
        places=places[kept],
        source=recorded.source,
        dropped=tuple(sorted((*recorded.rejected, *dropped), key=lambda each: each.line or 0)),
        notes=tuple(dict.fromkeys((*recorded.notes, *_assumptions(head, delivery), *notes))),
    )


def of_one_club(recorded: RecordedShots, only: str | None) -> NDArray[np.int64]:
    """Return the places of the shots of the one club wanted."""
    if recorded.clubs is None:
        if only is not None:
            raise InputError("only", only, "leave it out: the shots name no club")
        return np.arange(len(recorded))
    counts = {name: int(np.sum(recorded.clubs == name)) for name in dict.fromkeys(recorded.clubs)}
    listed = ", ".join(f"{name or 'without a name'} ({count})" for name, count in counts.items())
    if only is None:
        if len(counts) > 1:
            raise InputError("only", None, f"give one of the several clubs that were hit: {listed}")
        return np.arange(len(recorded))
    chosen = [name for name in counts if name.strip().casefold() == only.strip().casefold()]
    if not chosen:
        raise InputError("only", only, f"one of the clubs that were hit: {listed}")
    return np.flatnonzero(np.isin(recorded.clubs, chosen))


def club_of(recorded: RecordedShots, given: str | os.PathLike[str] | Club | None) -> Club:
    """Return the club given, or the built-in one that the shots name."""
    if isinstance(given, Club):
        return given
    if given is not None:
        return club(given)
    from clubface.equipment.clubs import CLUB_NAMES

    named = str(recorded.clubs[0]) if recorded.clubs is not None and len(recorded) else ""
    plain = "-".join(named.casefold().split())
    if plain not in CLUB_NAMES:
        told = f"give it: the shots name {named!r}" if named else "give it: the shots name none"
        raise InputError("club", None, f"{told}, and the built-in clubs are {', '.join(CLUB_NAMES)}")
    return club(plain)


def _assumptions(head: Club, delivery: dict[str, Any]) -> list[str]:
    """Return what was not measured and how it is taken."""
    found = []
    missing = [name for name in OF_CLUB if name not in delivery]
    zero = [name for name in missing if name != "loft"]
    if zero:
        found.append(f"not measured and taken as zero: {', '.join(zero)}")
    if "loft" in missing:
        loft = units.show(head.loft, "deg", 3)
        found.append(
            f"dynamic loft was not measured; the static loft of {head.name}, {loft}, stands for it in every shot"
        )
    return found
