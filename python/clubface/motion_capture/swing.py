"""From the recording of a swing to its delivery."""

from __future__ import annotations

import math
import os
import warnings
from dataclasses import replace
from typing import Unpack

import numpy as np

from clubface.equipment.clubs import Club
from clubface.errors import CaptureWarning, FileError
from clubface.motion_capture import checks
from clubface.motion_capture.attitude import angles
from clubface.motion_capture.ball_flight import Launched, flight
from clubface.motion_capture.captured import NOT_PLAUSIBLE, CapturedDelivery, Trace
from clubface.motion_capture.filled import without_filled
from clubface.motion_capture.mapping_file import MarkerMap
from clubface.motion_capture.markers import AXES
from clubface.motion_capture.meeting import meet
from clubface.motion_capture.recording import Recording, read_c3d
from clubface.motion_capture.reduction import QUANTITIES, Inputs, with_covariance
from clubface.motion_capture.rigid_body import degrees_of_freedom
from clubface.motion_capture.rotations import exponential
from clubface.motion_capture.setup import Options, Setup, prepare
from clubface.motion_capture.tracking import LEAST_MISFIT, Track, look_alikes, track
from clubface.simulation.delivery import Delivery

ADVICE = (
    "Do not use these figures: see which markers hide or stray in which frames (capture markers, --plot), cut the"
    " recording to the frames of the swing, and check frames under [calibration], target and up under [laboratory], and"
    " the club"
)
MIRROR = np.array([1.0, 1.0, -1.0])


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
        Which marker is what: the path of a TOML file (see ``template``), or a :class:`MarkerMap`.
    club
        A built-in name, the path of a TOML file, or a :class:`Club`.
    **options
        ``estimator``: "smoother", "polynomial", or "linear", the straight lines of Caldwell and McPhee (2023).
        ``roughness``: for the smoother, how much the path may depart from a quartic. ``ball``: its radius is used.
        ``hand``: "right" or "left"; that of the club if left out. ``target`` and ``up``: axes of the laboratory such as
        "+y", instead of those of the mapping. ``unit``: the unit of length, instead of the one the file names.
        ``noise``: the standard deviation of a marker along an axis, such as "0.3 mm"; if left out, that of the mapping,
        or an estimate from the residuals.

    Raises
    ------
    FileError
        The file cannot be read, markers are missing or do not fit, or the swing has no impact.
    InputError
        An option cannot be used, or the club is not that of the mapping.

    Warns
    -----
    CaptureWarning
        For each thing that was corrected or is doubtful; ``notes`` of the result holds them as well.
    """
    prepared = prepare(mapping, club, **options)
    found = capture(read_c3d(path, unit=prepared.mapping.unit), prepared)
    for note in found.notes:
        warnings.warn(f"{found.source}: {note}", CaptureWarning, stacklevel=2)
    return found


def capture(recording: Recording, setup: Setup) -> CapturedDelivery:
    """Return the delivery of one recording; the errors are those of :func:`read_swing`."""
    found = _captured(recording, setup)
    if abs(found.delivery.path) > 0.5 * math.pi:
        raise FileError(recording.path, None, _away(found, recording, setup))
    return found


def _captured(recording: Recording, setup: Setup) -> CapturedDelivery:
    """Return the delivery of one recording, wherever the head goes."""
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
    bad = checks.implausible(values, deviations, head)
    flown = flight(met.seen_ball, recording.times, met.ball, touch)
    notes = [
        *([f"{NOT_PLAUSIBLE}: {', '.join(bad)}. {ADVICE}"] if bad else []),
        *left_out,
        *checks.of_track(followed, cluster, recording.first_frame),
        *checks.of_delivery(values, deviations, head, assumed=float(np.sqrt(cluster.covariance[5, 5]))),
        *checks.of_launch(values, head.replace(hand="right"), setup.ball, flown, touch),
        *checks.of_fit(approach.path.misfit, before - int(approach.frames[-1]), freedom),
        *met.notes(reduced.surprise),
        *cluster.notes,
        *(
            f"the cluster looks the same with {words}: that could not be noticed"
            for words in look_alikes(cluster.shape, cluster.names, LEAST_MISFIT)
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


def _away(result: CapturedDelivery, recording: Recording, setup: Setup) -> str:
    """Say what to do about a head that moves away from the target: turn the axis if that helps, and else not."""
    away = "the clubhead moves away from the target"
    mapping, given = setup.mapping, setup.mapping.target
    if isinstance(given, str) and (setup.registration is None or mapping.way in ("positions", "face")):
        for axis in (each for each in AXES if each[1] != mapping.up[1] and each != given):
            try:
                plausible = _captured(recording, replace(setup, mapping=replace(mapping, target=axis))).plausible
            except FileError:
                continue
            if plausible:
                return (
                    f"{away}: turn the axis that points to it; {axis} gives a plausible delivery (target under"
                    f" [laboratory], or --target={axis})"
                )
    address = "".join(f" ({note})" for note in result.notes if note.startswith("address taken"))
    return f"{away} in frame {result.frames[0]}, where the impact seems to be. {result.notes[0]}{address}"


def _trace(recording: Recording, followed: Track, inputs: Inputs, setup: Setup) -> Trace:
    """Return the head through the recording, the club where it was found to stand on its markers."""
    head, rotation = setup.club, followed.poses.rotation
    arm, turned = inputs.club[:3], rotation @ exponential(inputs.club[3:])
    centre = followed.poses.position + rotation @ arm + turned @ np.array(head.cg)
    loft, face, _ = angles(turned, head.loft)
    squares = followed.poses.residuals**2
    freedom = np.maximum(degrees_of_freedom(followed.poses.residuals), 1)
    residual = np.where(followed.known, np.sqrt(np.nansum(squares, axis=(-1, -2)) / freedom), np.nan)
    mirror = MIRROR if head.hand < 0 else np.ones(3)
    return Trace(
        recording.times, centre * mirror, loft, face * head.hand, residual, inputs.ball * mirror, setup.ball.radius
    )


def _launch(flown: Launched | None, hand: int) -> tuple[dict[str, float], dict[str, float]]:
    """Return speed, launch angle and azimuth of the ball, and their standard deviations."""
    if flown is None:
        return {}, {}
    speed, launch, azimuth = checks.directions(flown.velocity)
    deviation = math.sqrt(float(flown.covariance[0, 0]))
    return (
        {"ball_speed": speed, "launch": launch, "azimuth": azimuth * hand},
        {"ball_speed": deviation, "launch": deviation / speed, "azimuth": deviation / (speed * math.cos(launch))},
    )
