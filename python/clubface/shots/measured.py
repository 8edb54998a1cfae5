"""Recorded shots prepared for models: one club, complete rows, and notes on what was assumed.

Shots are read and selected, the club is checked by its name in the file and by dynamic loft, stated values replace
missing ones, and club data measured at other points of the club are converted to clubface's reference points.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.clubs import CLUB_NAMES, Club, club as club_named
from clubface.errors import InputError, Wording
from clubface.results.notes import Note, note
from clubface.shots.club_names import club_kind, may_be, same_club
from clubface.shots.conditions import matching_shots
from clubface.shots.loft_origin import LoftOrigin, computed, loft_origins, origin_notes
from clubface.shots.reading import read
from clubface.shots.recorded import RecordedShots, RejectedRow, assume_values
from clubface.shots.reference_points import refer
from clubface.simulation.inputs import OF_CLUB
from clubface.support.arrays import Selection, ValueLike
from clubface.support.checks import check_choice

REFUSE, NOTE = MISMATCH = ("refuse", "note")
"""How to handle shots of another club."""
LOFT_DIFFERENCE = units.to_si(12.0, "deg")
"""A median dynamic loft farther than this [rad] from the static loft most likely belongs to another club."""
LEAST_LOFT = 0.6
"""So does one below this share of the static loft, if that allows a lower loft: players deloft short irons more than
long ones. Launch angles of published tour averages need 0.60 (5-iron) to 0.72 (pitching wedge) of it."""


def check_club(
    club: Club, names: Iterable[object] | None, lofts: NDArray[np.float64], mismatch: str = "refuse"
) -> list[Note]:
    """Raise an error if shots seem to be of a different club than ``club``, or return a note on it.

    ``names`` holds the club name of each shot in the file, or None if there are no names or the choice was deliberate;
    ``lofts`` holds measured dynamic lofts [rad], if any, and ``mismatch`` is "refuse" or "note".
    """
    check_choice("mismatch", mismatch, MISMATCH)
    wanted, result = club_kind(club.name), None
    kinds = {str(name): club_kind(str(name)) for name in ([] if names is None else dict.fromkeys(names))}
    others = [name for name, kind in kinds.items() if kind and wanted and not may_be(kind, wanted)]
    if others:
        result = note("club-may-be-other", names=others, club=club.name)
    elif len(lofts):
        median, least = float(np.median(lofts)), min(club.loft - LOFT_DIFFERENCE, LEAST_LOFT * club.loft)
        if not least <= median <= club.loft + LOFT_DIFFERENCE:
            data = {"delivered_loft": median, "static_loft": club.loft}
            result = note("median-loft-of-other-club", **data, club=club.name)
    if result is not None and mismatch == REFUSE:
        why = result.sentence.rpartition(":")[0]
        advice = f'the club of these shots: {why} (mismatch="note" or --mismatch note takes them all the same)'
        raise InputError("club", club.name, advice)
    return [] if result is None else [result]


WEDGES = ("gap-wedge", "sand-wedge", "lob-wedge")
"""Built-in clubs that shots may name by loft, as in "56"."""


@dataclass(frozen=True, kw_only=True, eq=False)
class ReadyShots(RecordedShots):
    """Recorded shots of one club, converted to its reference points, with attributes besides :class:`RecordedShots`.

    Attributes
    ----------
    club
        The club with which they were hit.
    places
        Index of each shot (from 0) among the shots given or read.
    loft_origins
        Origin of the dynamic lofts of this club in each file.
    """

    club: Club
    places: NDArray[np.int64] = field(default_factory=lambda: np.arange(0))
    loft_origins: tuple[LoftOrigin, ...] = ()

    def select(self, chosen: Selection) -> Self:
        """Return some of the shots, as :meth:`RecordedShots.select` does."""
        return replace(super().select(chosen), places=np.atleast_1d(self.places[chosen]))


def ready_shots(
    given: RecordedShots | str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club | None = None,
    hand: str | None = None,
    only: str | None = None,
    where: str | None = None,
    mismatch: str = "refuse",
    assume: Mapping[str, ValueLike] | None = None,
) -> ReadyShots:
    """Prepare recorded shots of one club for models.

    Parameters
    ----------
    given
        Recorded shots, or a file for :func:`clubface.shots.read`. :class:`ReadyShots` are returned as they are.
    club
        The club with which they were hit; default the club the shots name, if it is built in.
    hand
        "right" or "left": the hand of the club; default its own.
    only
        Take only shots of the club with this name in the file; default all shots, which must be of one club.
    where
        Take only shots that match this condition, see :func:`clubface.shots.match_shots`. It applies to the values as
        measured.
    mismatch
        How to handle shots whose club name or dynamic loft suggests another club: "refuse" or "note".
    assume
        Values for what was not measured, such as ``{"toe": "0 mm"}``; see
        :func:`clubface.shots.recorded.assume_values`.

    Raises
    ------
    InputError
        No shot is left, or the shots are of several clubs or of a different club than the one given.
    """
    if isinstance(given, ReadyShots):
        return given
    recorded = given if isinstance(given, RecordedShots) else read(given)
    origins = loft_origins(recorded)  # from all shots, before lofts are assumed or converted
    recorded, places = (recorded, np.arange(len(recorded))) if where is None else matching_shots(recorded, where)
    takes_all = club is not None and only is None and mismatch == NOTE
    of_club = np.arange(len(recorded)) if takes_all else of_one_club(recorded, only, club is not None)
    recorded, places = recorded.select(of_club), places[of_club]
    head = club_of(recorded, club)
    if hand is not None:
        head = head.replace(hand=hand)
    lofts = recorded.deliveries.get("loft", np.empty(0))
    notes = check_club(head, recorded.clubs if only is None else None, lofts[np.isfinite(lofts)], mismatch)
    result = refer(assume_values(recorded, assume or {}), head)
    stated = {each.name: getattr(result, each.name) for each in fields(RecordedShots)}
    clubs, files = ({""} if each is None else set(map(str, each)) for each in (recorded.clubs, recorded.files))
    return ReadyShots(
        **{**stated, "notes": tuple(dict.fromkeys((*result.notes, *notes)))}, club=head, places=places,
        loft_origins=tuple(each for each in origins if each.club in clubs and each.file in files),
    )  # fmt: skip


def of_one_club(recorded: RecordedShots, only: str | None, club_is_given: bool) -> NDArray[np.int64]:
    """Return the indices of the shots of one club; if there are several clubs, raise an error with advice."""
    if recorded.clubs is None:
        if only is not None:
            raise InputError("only", only, "leave it out: the shots name no club")
        return np.arange(len(recorded))
    counts = {name: int(np.sum(recorded.clubs == name)) for name in dict.fromkeys(recorded.clubs)}
    listed = ", ".join(f"{name or 'without a name'} ({count})" for name, count in counts.items())
    if only is None:
        first = next(iter(counts), "")
        if not all(same_club(name, first) for name in counts):
            others = ', or mismatch="note" (--mismatch note) for all of them as one club' if club_is_given else ""
            raise InputError("only", None, f"give one of the several clubs that were hit: {listed}{others}")
        return np.arange(len(recorded))
    chosen_names = [name for name in counts if same_club(name, only)]
    if not chosen_names:
        raise InputError("only", only, f"one of the clubs that were hit: {listed}")
    return np.flatnonzero(np.isin(recorded.clubs, chosen_names))


def club_of(recorded: RecordedShots, given: str | os.PathLike[str] | Club | None) -> Club:
    """Return the club given, or the built-in one that the shots name."""
    if isinstance(given, Club):
        return given
    if given is not None:
        return club_named(given)
    named = str(recorded.clubs[0]) if recorded.clubs is not None and len(recorded) else ""
    kind = club_kind(named)
    if kind not in CLUB_NAMES:  # a wedge named by loft is the built-in one with that loft
        lofts = {f"{units.from_si(club_named(name).loft, 'deg'):.0f}-wedge": name for name in reversed(WEDGES)}
        kind = lofts.get(kind or "")
    if kind is None:
        stated = f"give it: the shots name {named!r}" if named else "give it: the shots name none"
        raise InputError("club", None, f"{stated}; clubface clubs lists the built-in clubs")
    return club_named(kind)


QUANTITIES = {"ball_speed": "mph", "launch": "deg", "azimuth": "deg", "backspin": "rpm", "sidespin": "rpm"}
"""Launch quantities compared with models, in the order of published tables, and their usual units."""
DELIVERY, LAUNCH = COMPARED_AT = ("delivery", "launch")
"""Where models are compared with shots: at the measured delivery, or at the measured launch."""
SOLVED = {"launch": "loft", "azimuth": "face"}
"""Delivery quantity solved for, by the launch quantity it must reproduce."""


@dataclass(frozen=True, kw_only=True, eq=False)
class MeasuredShots:
    """Shots of one club, each with a complete delivery and at least one measured launch quantity, in SI units.

    Attributes
    ----------
    club
        The club with which they were hit.
    delivery
        Measured delivery quantities, as :func:`impact` takes them; the hand, if known, as +1 or -1.
    launch
        Measured launch quantities by name, in the order of ``QUANTITIES``; NaN where not measured.
    start
        Launch angle and, if it was measured, azimuth [rad], by name, at which models are compared; empty for a
        comparison at the measured delivery. Loft and face angle are then not in ``delivery``.
    loft_origins
        Origin of the dynamic lofts.
    rows, places
        Row of each shot in the source, and its index (from 0) among the recorded shots given.
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
    notes: tuple[Note, ...]
    start: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    loft_origins: tuple[LoftOrigin, ...] = ()

    def __len__(self) -> int:
        return len(self.rows)

    def select(self, chosen: Selection) -> Self:
        """Return some of the shots, by a mask or indices."""
        return replace(
            self,
            delivery={name: values[chosen] for name, values in self.delivery.items()},
            launch={name: values[chosen] for name, values in self.launch.items()},
            start={name: values[chosen] for name, values in self.start.items()},
            rows=self.rows[chosen],
            places=self.places[chosen],
        )


def measured_shots(
    shots: RecordedShots | str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club | None = None,
    only: str | None = None,
    where: str | None = None,
    mismatch: str = "refuse",
    assume: Mapping[str, ValueLike] | None = None,
    quantities: Iterable[str] = tuple(QUANTITIES),
    compared_at: str = DELIVERY,
) -> MeasuredShots:
    """Prepare recorded shots for comparison with models.

    Parameters
    ----------
    shots, club, only, where, mismatch, assume
        The shots or their file, and options as for :func:`clubface.shots.measured.ready_shots`.
    quantities
        The launch quantities wanted, out of ``QUANTITIES``.
    compared_at
        "delivery" or "launch". With "launch", dynamic loft and face angle are solved so that models reproduce the
        launch angle and, if measured, the start direction; measured loft and face angle are ignored.

    Raises
    ------
    InputError
        As for :func:`clubface.shots.measured.ready_shots`, or no column gives a speed or a launch.
    """
    recorded = ready_shots(shots, club=club, only=only, where=where, mismatch=mismatch, assume=assume)
    head = recorded.club
    places = np.arange(len(recorded)) if recorded is shots else recorded.places
    if "speed" not in recorded.deliveries:
        measured = ", ".join(recorded.deliveries) or "nothing"
        advice = f"shots with the speed of the clubhead; measured of the deliveries: {measured}"
        raise InputError("shots", recorded.source, advice)
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
        raise InputError("speed", Wording("empty in every shot"), "measured in at least one")
    reasons: dict[int, str] = {}
    for name, values in (delivery | start).items():
        for row in np.flatnonzero(~np.isfinite(values)):
            reasons.setdefault(int(row), f"{name} was not measured")
    nothing = np.all([~np.isfinite(recorded.launches[name]) for name in wanted], axis=0)
    for row in np.flatnonzero(nothing):
        reasons.setdefault(int(row), "no launch quantity was measured")
    kept = np.array([row not in reasons for row in range(len(recorded))], dtype=bool)
    dropped = [RejectedRow(int(recorded.rows[row]), reason) for row, reason in sorted(reasons.items())]
    if not kept.any():
        stated = "; ".join(f"{each.line}: {each.reason}" for each in dropped[:3])
        advice = f"at least one shot with a complete delivery and a launch ({stated})"
        raise InputError("shots", recorded.source, advice)
    delivery = {name: values[kept] for name, values in delivery.items()}
    origins = recorded.loft_origins
    of_lofts = origin_notes(origins)
    if start:
        of_lofts = [note("compared-at-launch", met=list(start), solved=[SOLVED[name] for name in start]),
                    *([note("file-lofts-not-used")] if computed(origins) else [])]  # fmt: skip
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
    result = {
        name: recorded.launches[name]
        for name in SOLVED
        if name in recorded.launches and np.isfinite(recorded.launches[name]).any()
    }
    if "launch" not in result:
        measured = ", ".join(recorded.launches) or "nothing"
        raise InputError("compared_at", LAUNCH, f"shots with a measured launch angle; measured: {measured}")
    return result


def assumptions(head: Club, delivery: Mapping[str, Any]) -> list[Note]:
    """Return notes on what was not measured and the values assumed instead."""
    zero = [name for name in OF_CLUB if name not in delivery and name != "loft"]
    result = [note("taken-as-zero", quantities=zero)] if zero else []
    if "loft" not in delivery:
        result.append(note("static-loft-stands-in", club=head.name, static_loft=head.loft))
    return result
