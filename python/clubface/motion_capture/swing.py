"""From the recording of a swing to its delivery."""

from __future__ import annotations

import math
import os
import warnings
from typing import Unpack

import numpy as np

from clubface.equipment.clubs import Club
from clubface.errors import CaptureWarning, FileError
from clubface.motion_capture import checks
from clubface.motion_capture.approach import follow
from clubface.motion_capture.ball_flight import Launched, RestingBall, flight, resting_places
from clubface.motion_capture.captured import CapturedDelivery
from clubface.motion_capture.impact_frame import find_impact
from clubface.motion_capture.mapping_file import MarkerMap
from clubface.motion_capture.recording import Recording, read_c3d
from clubface.motion_capture.reduction import QUANTITIES, with_covariance
from clubface.motion_capture.rigid_body import visible
from clubface.motion_capture.rotations import Array
from clubface.motion_capture.setup import Options, Setup, prepare
from clubface.motion_capture.tracking import LEAST_MISFIT, Track, look_alikes, track
from clubface.simulation.delivery import Delivery

FLOOR = 1e-6
"""Metres; the least noise of a marker, above the rounding of a file in single precision."""
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
    where, head, radius = recording.path, setup.club, setup.ball.radius
    turn, cluster = setup.turn(recording), setup.cluster(recording)
    followed = track(cluster.shape, recording.markers(cluster.names) @ turn.T, cluster.names, where)
    seen_ball, places = _ball(recording, setup, turn)
    position, rotation = followed.poses.position, followed.poses.rotation
    interval, ball = find_impact(position, rotation, seen_ball, places, head, radius, recording.rate, where)
    noise, freedom = _noise(followed, interval.before, setup, where)
    approach = follow(
        recording.times, followed, interval, ball.centre, head, radius,
        noise=noise, name=setup.estimator, roughness=setup.roughness, where=where,
    )  # fmt: skip
    rest = np.eye(3) * (_ball_noise(ball, setup) ** 2 / max(ball.frames, 1))
    found, _, covariance = with_covariance(
        approach.path, ball.centre, approach.attitude, head, radius,
        ball_covariance=rest, club_covariance=cluster.covariance,
    )  # fmt: skip
    values = dict(zip(QUANTITIES, found.tolist(), strict=True))
    if abs(values["path"]) > 0.5 * math.pi:
        raise FileError(where, None, "the clubhead moves away from the target: turn the axis that points to it round")
    deviations = dict(zip(QUANTITIES, np.sqrt(np.diag(covariance)).tolist(), strict=True))
    before = math.floor(approach.touch * recording.rate)
    flown = flight(seen_ball, recording.times, ball, approach.touch)
    notes = [
        *checks.of_track(followed, cluster, recording.first_frame),
        *checks.of_delivery(values, deviations, head),
        *checks.of_launch(values, head.replace(hand="right"), setup.ball, flown, approach.touch),
        *checks.of_fit(approach.path.misfit, before - int(approach.frames[-1]), freedom),
        *interval.notes,
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
        time=approach.touch,
        frames=(before + recording.first_frame, before + recording.first_frame + 1),
        used=len(approach.frames),
        marker_noise=noise,
        marker_noise_freedom=freedom,
        misfit=approach.path.misfit,
        notes=tuple(notes),
        source=where,
    )


def _ball(recording: Recording, setup: Setup, turn: Array) -> tuple[Array, list[RestingBall]]:
    """Return the centre of the ball in every frame and where it rests, in world axes as a right-hander sees them."""
    mapping = setup.mapping
    if mapping.ball is None:
        place = turn @ np.array(mapping.ball_position)
        always = (0, len(recording.positions) - 1)
        return np.full((len(recording.positions), 3), np.nan), [RestingBall(place, mapping.accuracy, 1, always, None)]
    offset = np.array(mapping.ball_offset) * (MIRROR if setup.club.hand < 0 else 1.0)
    seen = recording.marker(mapping.ball) @ turn.T + offset
    found = resting_places(seen, recording.rate)
    if not found:
        lost = "seen at rest" if visible(seen).any() else "seen"
        raise FileError(recording.path, None, f"the ball's marker {mapping.ball} is never {lost}; give its position")
    return seen, found


def _ball_noise(ball: RestingBall, setup: Setup) -> float:
    if setup.mapping.ball is None or setup.mapping.noise is None:
        return max(ball.noise, FLOOR)
    return max(setup.mapping.noise, FLOOR)


def _noise(followed: Track, last: int, setup: Setup, where: str) -> tuple[float, int]:
    """Return the noise of a marker along an axis [m], and the degrees of freedom of its estimate."""
    if setup.mapping.noise is not None:
        return max(setup.mapping.noise, FLOOR), 0
    noise, freedom = followed.noise(np.arange(len(followed.known)) <= last)
    if freedom <= 0:
        raise FileError(where, None, "no frame before impact shows the clubhead's pose")
    return max(noise, FLOOR), freedom


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
