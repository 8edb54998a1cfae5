"""Recorded shots prepared for comparison with models: one club, complete rows, and notes on what was assumed."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.clubs import Club
from clubface.errors import InputError, Told
from clubface.measured.ready import ready_shots
from clubface.recorded.loft_origin import AT_LAUNCH, LoftOrigin, computed, origin_notes
from clubface.recorded.shots import RecordedShots, RejectedRow
from clubface.simulation.delivery import OF_CLUB
from clubface.support.checks import check_choice

QUANTITIES = {"ball_speed": "mph", "launch": "deg", "azimuth": "deg", "backspin": "rpm", "sidespin": "rpm"}
"""The launch quantities on which models are compared, in the order of the published tables, and their usual units."""
DELIVERY, LAUNCH = COMPARED_AT = ("delivery", "launch")
"""Where models are compared with shots: at the measured delivery, or at the measured launch."""
SOLVED = {"launch": "loft", "azimuth": "face"}
"""What is solved, by what of the launch is then met."""


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
    start
        Launch angle and, if it was measured, azimuth [rad], by name, at which models are compared; empty for a
        comparison at the measured delivery. Loft and face angle are then not in ``delivery``.
    loft_origins
        What the shots tell of where their dynamic lofts come from.
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
    start: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    loft_origins: tuple[LoftOrigin, ...] = ()

    def __len__(self) -> int:
        return len(self.rows)

    def select(self, which: NDArray[Any]) -> Self:
        """Return some of the shots, by a mask or indices."""
        return replace(
            self,
            delivery={name: values[which] for name, values in self.delivery.items()},
            launch={name: values[which] for name, values in self.launch.items()},
            start={name: values[which] for name, values in self.start.items()},
            rows=self.rows[which],
            places=self.places[which],
        )


def measured_shots(
    shots: RecordedShots | str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club | None = None,
    only: str | None = None,
    where: str | None = None,
    mismatch: str = "refuse",
    assume: Mapping[str, Any] | None = None,
    quantities: Iterable[str] = tuple(QUANTITIES),
    compared_at: str = DELIVERY,
) -> MeasuredShots:
    """Prepare recorded shots for comparison with models.

    Parameters
    ----------
    shots
        Recorded shots, or a file that :func:`clubface.launch_monitor.read` reads.
    club, only, where, mismatch, assume
        As for :func:`clubface.measured.ready.ready_shots`.
    quantities
        The launch quantities wanted, out of ``QUANTITIES``.
    compared_at
        "delivery", or "launch": models then meet launch angle and, if it was measured, start direction, for which
        dynamic loft and face angle are solved; those of the shots are left out.

    Raises
    ------
    InputError
        There is no usable shot; the shots are of several clubs, or of another club than the one given; or no column
        gives a speed or a launch.
    """
    recorded = ready_shots(shots, club=club, only=only, where=where, mismatch=mismatch, assume=assume)
    head = recorded.club
    places = np.arange(len(recorded)) if recorded is shots else recorded.places
    if "speed" not in recorded.deliveries:
        measured = ", ".join(recorded.deliveries) or "nothing"
        raise InputError(
            "shots",
            recorded.source,
            f"shots with the speed of the clubhead; measured of the deliveries: {measured}",
        )
    check_choice("compared_at", compared_at, COMPARED_AT)
    start = _start(recorded) if compared_at == LAUNCH else {}
    wanted = [name for name in quantities if name in recorded.launches and name not in start]
    if not wanted:
        compared = ", ".join(name for name in quantities if name not in start)
        raise InputError("shots", recorded.source, f"shots with a measured launch: {compared}")
    solved = [SOLVED[name] for name in start]
    delivery = {
        name: values for name, values in recorded.delivery().items() if np.isfinite(values).any() and name not in solved
    }
    if "speed" not in delivery:
        raise InputError("speed", Told("empty in every shot"), "measured in at least one")
    reasons: dict[int, str] = {}
    for name, values in (delivery | start).items():
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
    origins = recorded.loft_origins
    of_lofts = _notes_at_launch(start, origins) if start else origin_notes(origins, AT_LAUNCH)
    assumed = assumptions(head, delivery | dict.fromkeys(SOLVED[name] for name in start))
    return MeasuredShots(
        club=head,
        delivery=delivery,
        launch={name: recorded.launches[name][kept] for name in wanted},
        rows=recorded.rows[kept],
        places=places[kept],
        source=recorded.source,
        dropped=tuple(sorted((*recorded.rejected, *dropped), key=lambda each: each.line or 0)),
        notes=tuple(dict.fromkeys((*of_lofts, *recorded.notes, *assumed))),
        start={name: values[kept] for name, values in start.items()},
        loft_origins=origins,
    )


def _start(recorded: RecordedShots) -> dict[str, NDArray[np.float64]]:
    """Return launch angles and, if they were measured, azimuths [rad]."""
    found = {
        name: recorded.launches[name]
        for name in SOLVED
        if name in recorded.launches and np.isfinite(recorded.launches[name]).any()
    }
    if "launch" not in found:
        measured = ", ".join(recorded.launches) or "nothing"
        raise InputError(
            "compared_at", LAUNCH, f"shots with a measured launch angle; measured of the launch: {measured}"
        )
    return found


def _notes_at_launch(start: Mapping[str, Any], origins: Iterable[LoftOrigin]) -> list[str]:
    met, solved = (" and ".join(each) for each in (start, (SOLVED[name] for name in start)))
    unused = "; those of the file were computed from the ball, and are not used" if computed(origins) else ""
    return [f"compared at the measured {met}: {solved} are solved for each shot and model{unused}"]


def assumptions(head: Club, delivery: Mapping[str, Any]) -> list[str]:
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
