"""From recordings of swings to deliveries and tables of shots, joined with launches from a launch monitor.

A camera system and a launch monitor each miss some shots, so rows cannot be paired by number. Both keep the order of
the shots, and both measure some of the same quantities: ball speed, launch angle, clubhead speed. Shots are paired by
the alignment of the two series with the smallest deviation, found by dynamic programming (S. B. Needleman and C. D.
Wunsch, Journal of Molecular Biology 48 (1970) 443-453).
"""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Unpack

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.capture import remarks
from clubface.capture.ball_flight import Launched, flight
from clubface.capture.captured import LAUNCHES, CapturedDelivery, Trace, captured_result, notes_by_file
from clubface.capture.markers import AXES, MarkerMap
from clubface.capture.meeting import SURPRISING, meet
from clubface.capture.recording import Recording, read_c3d, without_filled
from clubface.capture.reduction import QUANTITIES, Inputs, with_covariance
from clubface.capture.rotations import angles, exponential, mirror
from clubface.capture.setup import Options, Setup, prepare
from clubface.capture.tracking import LEAST_MISFIT, Track, look_alikes, track
from clubface.equipment.clubs import Club
from clubface.errors import CaptureWarning, FileError, InputError
from clubface.results.notes import Note, note
from clubface.results.result import Described, Result
from clubface.shots.recorded import RecordedShots, RejectedRow
from clubface.simulation.inputs import Delivery
from clubface.support.arrays import Floats


def read_swing(
    path: str | os.PathLike[str],
    mapping: str | os.PathLike[str] | MarkerMap,
    club: str | os.PathLike[str] | Club,
    **options: Unpack[Options],
) -> CapturedDelivery:
    """Read the delivery of one swing from a C3D file.

    Parameters
    ----------
    path
        The file.
    mapping
        Marker map: the path of a TOML file (see ``template``), or a :class:`MarkerMap`.
    club
        A built-in name, the path of a TOML file, or a :class:`Club`.
    **options
        ``estimator``: "smoother", "polynomial", or "linear" (the straight lines of Caldwell and McPhee, 2023).
        ``roughness``: for the smoother, how far the path may depart from a quartic. ``ball``: the ball, for its radius.
        ``hand``: "right" or "left"; default: the club's. ``target`` and ``up``: laboratory axes such as "+y",
        overriding those of the map. ``unit``: the unit of length, overriding the file's. ``noise``: the standard
        deviation of a marker along an axis, such as "0.3 mm"; default: the map's, or an estimate from residuals.

    Raises
    ------
    FileError
        The file cannot be read, markers are missing or do not fit, or the swing has no impact.
    InputError
        An option is invalid, or the club is not that of the map.

    Warns
    -----
    CaptureWarning
        For every correction or doubt; they are also in the ``notes`` of the result.
    """
    prepared = prepare(mapping, club, **options)
    outcome = capture(read_c3d(path, unit=prepared.mapping.unit), prepared)
    for each in outcome.notes:
        warnings.warn(f"{outcome.source}: {each}", CaptureWarning, stacklevel=2)
    return outcome


def capture(recording: Recording, setup: Setup) -> CapturedDelivery:
    """Return the delivery of one recording; raises the errors of :func:`read_swing`."""
    outcome = _read_delivery(recording, setup)
    if abs(outcome.delivery.path) > 0.5 * math.pi:
        raise FileError(recording.path, None, _describe_direction(outcome, recording, setup))
    return outcome


def _read_delivery(recording: Recording, setup: Setup) -> CapturedDelivery:
    """Return the delivery of one recording, whatever the direction of the head."""
    where, head, radius = recording.path, setup.club, setup.ball.radius
    recording, left_out = without_filled(recording, setup.mapping.cluster)
    turn, cluster = setup.turn(recording), setup.cluster(recording)
    followed = track(cluster.shape, recording.markers(cluster.names) @ turn.T, cluster.names, where)
    met = meet(recording, followed, cluster, setup, turn)
    approach, noise, freedom = met.approach, met.noise, met.noise_freedom
    reduced = with_covariance(
        approach.path, met.ball.centre, approach.attitude, head, radius,
        ball_covariance=met.ball_covariance, club_covariance=cluster.covariance, evidence=met.evidence,
    )  # fmt: skip
    covariance, touch = reduced.covariance, approach.touch + (reduced.time if met.evidence is not None else 0.0)
    values = dict(zip(QUANTITIES, reduced.values.tolist(), strict=True))
    if not (np.isfinite(reduced.values).all() and np.isfinite(covariance).all() and math.isfinite(touch)):
        raise FileError(where, None, "the path of the clubhead does not lead to the ball")
    deviations = dict(zip(QUANTITIES, np.sqrt(np.diag(covariance)).tolist(), strict=True))
    before = math.floor(touch * recording.rate)
    flown = flight(met.seen_ball, recording.times, met.ball, touch)
    notes = [
        *remarks.implausible(values, deviations, head),
        *left_out,
        *remarks.filter_notes(followed, before),
        *remarks.track_notes(followed, cluster, recording.first_frame),
        *remarks.delivery_notes(values, deviations, head, assumed=float(np.sqrt(cluster.covariance[5, 5]))),
        *remarks.launch_notes(values, head.replace(hand="right"), setup.ball, flown, touch),
        *remarks.fit_notes(approach.path.misfit, before - int(approach.frames[-1]), freedom),
        *met.notes,
        *([note("capture-contradicts-ball", surprise=reduced.surprise)] if reduced.surprise > SURPRISING else []),
        *cluster.notes,
        *(
            note("capture-markers-look-alike", markers=list(markers))
            for markers in look_alikes(cluster.shape, cluster.names, LEAST_MISFIT)
        ),
    ]
    flip = np.array([head.hand if name in ("path", "face") else 1.0 for name in QUANTITIES])
    launch, launch_uncertainty = _launch(flown, head.hand)
    return CapturedDelivery(
        delivery=Delivery(
            **{name: value * sign for (name, value), sign in zip(values.items(), flip.tolist(), strict=True)}
        ),
        uncertainty=deviations,
        covariance=covariance * np.outer(flip, flip),
        launch=launch,
        launch_uncertainty=launch_uncertainty,
        club=head,
        estimator=setup.estimator,
        time=touch,
        frames=(before + recording.first_frame, before + recording.first_frame + 1),
        used=len(approach.frames),
        marker_noise=noise,
        marker_noise_freedom=freedom,
        misfit=approach.path.misfit,
        notes=tuple(notes),
        geometry=(*cluster.geometry, *met.geometry),
        trace=_trace(recording, followed, reduced.inputs, setup),
        source=where,
    )


def _describe_direction(result: CapturedDelivery, recording: Recording, setup: Setup) -> str:
    """Describe a head that moves away from the target, and suggest another target axis if that helps."""
    away = "the clubhead moves away from the target"
    mapping, given = setup.mapping, setup.mapping.target
    if isinstance(given, str) and (setup.registration is None or mapping.way in ("positions", "face")):
        for axis in (each for each in AXES if each[1] != mapping.up[1] and each != given):
            try:
                plausible = _read_delivery(recording, replace(setup, mapping=replace(mapping, target=axis))).plausible
            except FileError:
                continue
            if plausible:
                return (
                    f"{away}; {axis} as the target axis gives a plausible delivery (target under [laboratory], or"
                    f" --target={axis})"
                )
    address = "".join(f" ({each})" for each in result.notes if each.code.startswith("capture-address"))
    return f"{away} in frame {result.frames[0]}, where impact was detected. {result.notes[0]}{address}"


def _trace(recording: Recording, followed: Track, inputs: Inputs, setup: Setup) -> Trace:
    """Return the head's motion through the recording, with the club located on its markers."""
    head, rotation = setup.club, followed.poses.rotation
    arm, turned = inputs.club[:3], rotation @ exponential(inputs.club[3:])
    centre = followed.poses.position + rotation @ arm + turned @ np.array(head.cg)
    loft, face, _ = angles(turned, head.loft)
    to_hand, misfit = mirror(head.hand), followed.poses.misfit
    return Trace(
        recording.times, centre * to_hand, loft, face * head.hand, misfit, inputs.ball * to_hand, setup.ball.radius
    )


def _launch(flown: Launched | None, hand: int) -> tuple[dict[str, float], dict[str, float]]:
    """Return ball speed, launch angle and azimuth, and their standard deviations."""
    if flown is None:
        return {}, {}
    speed, launch, azimuth = remarks.directions(flown.velocity)
    deviation = math.sqrt(float(flown.covariance[0, 0]))
    return (
        {"ball_speed": speed, "launch": launch, "azimuth": azimuth * hand},
        {"ball_speed": deviation, "launch": deviation / speed, "azimuth": deviation / (speed * math.cos(launch))},
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class CapturedSwings(Described):
    """Deliveries of many recordings.

    Attributes
    ----------
    captured
        Deliveries that were read, in the order of the files.
    places
        Position of each among the files, counted from 1.
    rejected
        Files without a delivery: their positions and the reasons.
    interrupted
        Whether Ctrl-C stopped the reading before the last file.
    """

    captured: tuple[CapturedDelivery, ...]
    places: tuple[int, ...]
    rejected: tuple[RejectedRow, ...]
    interrupted: bool = False

    def __len__(self) -> int:
        return len(self.captured)

    def to_result(self) -> Result:
        """Return the deliveries, and the files without one, as a result."""
        return captured_result(self.captured, self.rejected)

    @property
    def shots(self) -> RecordedShots:
        """Table of deliveries and launches."""
        values = [{name: getattr(each.delivery, name) for name in QUANTITIES} for each in self.captured]
        return self._table("c3d", values, [each.launch for each in self.captured])

    @property
    def uncertainty(self) -> RecordedShots:
        """Table of the standard deviations of ``shots``."""
        deviations = [each.uncertainty for each in self.captured]
        return self._table("c3d standard deviations", deviations, [each.launch_uncertainty for each in self.captured])

    def write(self, path: str | os.PathLike[str]) -> list[Path]:
        """Write the shots to a CSV or Parquet file, and their standard deviations to another: ``shots.sd.csv``."""
        target = Path(path)
        sibling_file = target.with_name(f"{target.stem}.sd{target.suffix}")
        self.shots.write(target)
        self.uncertainty.write(sibling_file)
        return [target, sibling_file]

    def _table(self, kind: str, deliveries: list[dict[str, float]], launches: list[dict[str, float]]) -> RecordedShots:
        if not self.captured:
            raise InputError("swings", "none", "at least one swing that could be read")
        seen = [name for name in LAUNCHES if any(name in each for each in launches)]
        return RecordedShots(
            deliveries={name: np.array([each[name] for each in deliveries]) for name in QUANTITIES},
            launches={name: np.array([each.get(name, np.nan) for each in launches]) for name in seen},
            clubs=np.array([each.club.name for each in self.captured], dtype=object),
            hand=np.array(["left" if each.club.hand < 0 else "right" for each in self.captured], dtype=object),
            rows=np.array(self.places, dtype=np.int64),
            source=os.path.commonpath([Path(each.source).parent for each in self.captured]) or ".",
            format=kind,
            speed_at="cg",
            face_at="face",
            rejected=self.rejected,
            notes=notes_by_file(self.captured),
        )


def read_swings(
    paths: Iterable[str | os.PathLike[str]],
    mapping: str | os.PathLike[str] | MarkerMap,
    club: str | os.PathLike[str] | Club,
    *,
    progress: Callable[[int, int], object] | None = None,
    **options: Unpack[Options],
) -> CapturedSwings:
    """Read the deliveries of many C3D files of one session: same club, markers and calibration.

    Files that cannot be used are listed with the reason, and the others are still read. Ctrl-C stops the reading and
    keeps the deliveries so far.

    Parameters
    ----------
    paths
        The files.
    mapping, club, **options
        As for :func:`read_swing`.
    progress
        Called with the number of files done and the total.
    """
    files = [os.fspath(path) for path in paths]
    setup = prepare(mapping, club, **options)
    captured: list[CapturedDelivery] = []
    places: list[int] = []
    rejected: list[RejectedRow] = []
    interrupted = False
    try:
        for place, path in enumerate(files, 1):
            try:
                captured.append(capture(read_c3d(path, unit=setup.mapping.unit), setup))
                places.append(place)
            except FileError as error:
                rejected.append(RejectedRow(place, str(error)))
            if progress is not None:
                progress(place, len(files))
    except KeyboardInterrupt:
        interrupted = True
    return CapturedSwings(
        captured=tuple(captured[: len(places)]), places=tuple(places), rejected=tuple(rejected), interrupted=interrupted
    )


SAME = {"ball_speed": 1.5, "launch": units.to_si(2.0, "deg"), "speed": 2.5}
"""Differences [SI] above which two measurements belong to different shots.

Azimuth is excluded, since the target lines may differ.
"""
ALONE = 0.25
"""Cost of a row without a partner; two of them cost as much as a pair at 0.7 of the allowed difference."""


def join(captured: RecordedShots, measured: RecordedShots) -> RecordedShots:
    """Join two tables of the same shots: deliveries from one, launches from the other.

    Parameters
    ----------
    captured
        Table that provides the deliveries.
    measured
        Table that provides launches and club names. Both tables must be in the order of the shots. Launch quantities
        missing here, such as the azimuth, are taken from ``captured``, with a note.

    Returns
    -------
    RecordedShots
        The shots contained in both tables, with the rows of ``captured``. Rows without a partner are in ``rejected``.

    Raises
    ------
    InputError
        The tables have no common quantity to match shots and differ in length, or no pair was found.
    """
    for what, shots, values in (("captured", captured, captured.deliveries), ("measured", measured, measured.launches)):
        if not len(shots) or not values:
            kind = "deliveries" if shots is captured else "launches"
            raise InputError(what, shots.source, f"shots with {kind}")
    differences = _differences(captured, measured)
    if differences:
        pairs = _aligned(_costs(differences))
        summary = note("paired-by-values", quantities=list(differences))
    elif len(captured) == len(measured):
        pairs = np.repeat(np.arange(len(captured))[:, None], 2, axis=1)
        summary = note("paired-by-order")
    else:
        raise InputError(
            "measured", f"{len(measured)} shots", f"as many as captured, {len(captured)}, since the tables have none of"
            f" {', '.join(SAME)} in common to tell which are the same",
        )  # fmt: skip
    if not len(pairs):
        raise InputError("measured", measured.source, f"of the same shots as {captured.source}; not one pair is alike")
    one, other = captured.select(pairs[:, 0]), measured.select(pairs[:, 1])
    left = [*_unpaired_rows(captured, pairs[:, 0], measured), *_unpaired_rows(measured, pairs[:, 1], captured)]
    measured_by_other = {name for name, values in other.launches.items() if np.isfinite(values).any()}
    carried = {
        name: values
        for name, values in one.launches.items()
        if name not in measured_by_other and np.isfinite(values).any()
    }
    carried_note = [note("launches-of-captured", quantities=list(carried), captured=captured.source)] if carried else []
    return RecordedShots(
        deliveries=one.deliveries, launches={**other.launches, **carried}, rows=one.rows,
        clubs=one.clubs if other.clubs is None else other.clubs, hand=other.hand if one.hand is None else one.hand,
        source=f"{captured.source} and {measured.source}", format="joined",
        rejected=tuple(left),
        notes=(*captured.notes, *measured.notes, summary, *carried_note, *_target_line_notes(one, other)),
        speed_at=captured.speed_at, face_at=captured.face_at,
    )  # fmt: skip


def _differences(captured: RecordedShots, measured: RecordedShots) -> dict[str, Floats]:
    """Return the difference between every pair of shots, relative to the allowed difference, by quantity."""
    first, second = ({**each.deliveries, **each.launches} for each in (captured, measured))
    outcome = {}
    for name, allowed in SAME.items():
        if name in first and name in second:
            difference = (first[name][:, None] - second[name][None, :]) / allowed
            if np.isfinite(difference).any():
                outcome[name] = difference
    return outcome


def _costs(differences: dict[str, Floats]) -> Floats:
    """Return the cost of each pair, 0 to 1: the mean square of its differences; infinite if one is too large."""
    every = np.array(list(differences.values()))
    there = np.isfinite(every)
    squares = np.where(there, every, 0.0) ** 2
    count = there.sum(axis=0)
    # A pair without common values is paired rather than left out, unless a better pair competes.
    costs = np.where(count > 0, squares.sum(axis=0) / np.maximum(count, 1), ALONE)
    return np.where((squares > 1.0).any(axis=0), np.inf, costs)


def _aligned(costs: Floats) -> NDArray[np.int64]:
    """Return the pairs, in order, that minimise the total cost including unpaired rows; shape (pairs, 2)."""
    rows, columns = costs.shape
    total = np.empty((rows + 1, columns + 1))
    total[0], total[:, 0] = ALONE * np.arange(columns + 1), ALONE * np.arange(rows + 1)
    for row in range(rows):
        # An unpaired column adds one cost per place: a running minimum after subtracting that cost.
        best = np.minimum(total[row, 1:] + ALONE, total[row, :-1] + costs[row])
        passed = ALONE * np.arange(columns + 1)
        total[row + 1] = np.minimum.accumulate(np.concatenate([[total[row + 1, 0]], best]) - passed) + passed
    pairs = []
    row, column = rows, columns
    while row and column:
        if np.isclose(total[row, column], total[row - 1, column - 1] + costs[row - 1, column - 1], rtol=0, atol=1e-9):
            row, column = row - 1, column - 1
            pairs.append((row, column))
        elif np.isclose(total[row, column], total[row - 1, column] + ALONE, rtol=0, atol=1e-9):
            row -= 1
        else:
            column -= 1
    return np.array(pairs[::-1], dtype=np.int64).reshape(-1, 2)


def _unpaired_rows(shots: RecordedShots, paired: NDArray[np.int64], other: RecordedShots) -> list[RejectedRow]:
    """Return the rejected rows of a table, and the rows that the other table does not have."""
    alone = np.setdiff1d(np.arange(len(shots)), paired)
    outcome = [*shots.rejected, *(RejectedRow(int(shots.rows[each]), f"not in {other.source}") for each in alone)]
    outcome.sort(key=lambda each: each.line or 0)
    return [each._replace(reason=f"{shots.source}: {each.reason}") for each in outcome]


def _target_line_notes(one: RecordedShots, other: RecordedShots) -> list[Note]:
    """Return a note on the angle between the target lines, if both tables have the ball's azimuth."""
    if not ("azimuth" in one.launches and "azimuth" in other.launches):
        return []
    difference = other.launches["azimuth"] - one.launches["azimuth"]
    if not np.isfinite(difference).any():
        return []
    median = float(np.nanmedian(difference))
    return [note("target-lines-differ", measured=other.source, captured=one.source, azimuth=median)]
