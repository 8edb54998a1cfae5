"""The last frames before first touch, and the path through them."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from clubface.equipment.clubs import Club
from clubface.errors import FileError
from clubface.motion_capture.estimators import TIME, TURN, Path, estimator
from clubface.motion_capture.impact_frame import Interval
from clubface.motion_capture.reduction import Inputs, deliver, gap
from clubface.motion_capture.rigid_body import pose_information
from clubface.motion_capture.rotations import Array, left_jacobian, logarithm
from clubface.motion_capture.tracking import Track

TOUCHING = 1e-3
"""Metres the face may have moved on after first touch in a frame that is still used: the ball hardly pushes yet."""
SETTLED = 1e-9
"""Seconds by which the instant of impact may still move; the head goes 50 nm in that time."""
MOST_ROUNDS = 20
WIDEST = 12
"""Frames without a pose across which the path is still followed."""


class Approach(NamedTuple):
    """The path of the clubhead to the ball.

    Attributes
    ----------
    path
        The path about the instant of first touch.
    attitude
        Rotation from club axes to the world where the rotation vector of the path is zero, shape (3, 3).
    touch
        Time of first touch [s], on the clock of the frames.
    frames
        The numbers of the frames used, ascending.
    """

    path: Path
    attitude: Array
    touch: float
    frames: Array


def follow(
    times: Array, followed: Track, interval: Interval, ball: Array, club: Club, radius: float,
    *, noise: float, name: str, roughness: float, where: str,
) -> Approach:  # fmt: skip
    """Extend the path of the clubhead to the place where it first touches the ball.

    Parameters
    ----------
    times
        Times of the frames [s].
    followed
        The clubhead in every frame, with its origin at the CG.
    interval
        The frames between which the head meets the ball.
    ball
        Centre of the ball at rest [m].
    club, radius
        The club with its face, and the radius of the ball [m].
    noise
        Standard deviation of a marker along an axis [m].
    name, roughness
        Name of the estimator, and the roughness for the smoother.
    where
        The file, for error messages.

    Raises
    ------
    FileError
        There are too few frames before impact, or the path does not lead to the ball.
    """
    position, rotation = followed.poses.position, followed.poses.rotation
    known = np.flatnonzero(followed.known & (np.arange(len(times)) <= interval.before))
    extend, fewest, most = estimator(name)
    if len(known) < fewest:
        raise FileError(where, None, _too_few(len(known), fewest, name))
    last = known[-4:]
    ahead, _ = gap(position[last], rotation[last], ball, club, radius)
    closing = float(ahead[0] - ahead[-1]) / float(times[last[-1]] - times[last[0]])
    if closing <= 0.0:
        raise FileError(where, None, "the clubhead does not come nearer to the ball in the last frames before impact")
    touch = float(times[known[-1]] + ahead[-1] / closing)

    def extended() -> Approach:
        """Fit the path about ``touch`` and move that to where the path meets the ball."""
        frames = usable(known[-most:], rotation, fewest)
        if len(frames) < fewest:
            raise FileError(where, None, _too_few(len(frames), fewest, name))
        path, attitude = path_through(times[frames] - touch, followed, frames, noise, extend, roughness, where)
        _, time = deliver(Inputs(path.position, path.rate, ball, np.zeros(6)), attitude, club, radius)
        if not abs(float(time)) < TIME:
            raise FileError(where, None, f"the path of the clubhead by {name} does not lead to the ball")
        return Approach(path, attitude, touch + float(time), frames)

    for _ in range(MOST_ROUNDS):
        found = extended()
        settled = abs(found.touch - touch) < SETTLED
        touch = found.touch
        if times[found.frames[-1]] > touch + TOUCHING / closing:
            known = known[:-1]
        elif settled:
            return found
    raise FileError(where, None, f"the path of the clubhead by {name} does not settle on an instant of impact")


def follow_until(
    times: Array, followed: Track, touch: float, *, noise: float, name: str, roughness: float, where: str
) -> Approach:
    """Extend the path of the clubhead to an instant of first touch that is known, such as that of the blow.

    The parameters and errors are those of :func:`follow`.
    """
    extend, fewest, most = estimator(name)
    known = np.flatnonzero(followed.known & (times <= touch))
    frames = usable(known[-most:], followed.poses.rotation, fewest)
    if len(frames) < fewest:
        raise FileError(where, None, _too_few(len(frames), fewest, name))
    path, attitude = path_through(times[frames] - touch, followed, frames, noise, extend, roughness, where)
    return Approach(path, attitude, touch, frames)


def path_through(
    times: Array,
    followed: Track,
    frames: Array,
    noise: float,
    extend: Callable[..., Path],
    roughness: float,
    where: str,
) -> tuple[Path, Array]:
    """Return the path through some frames about time zero, and the attitude from which its rotation vector counts.

    Parameters
    ----------
    times
        Of the frames [s], ascending; counted backwards for a path that is followed back in time.
    followed, frames
        The clubhead, and the numbers of the frames; the last is the nearest to time zero.
    noise
        Standard deviation of a marker along an axis [m].
    extend, roughness
        The estimator's function, and its roughness.
    where
        The file, for error messages.
    """
    coordinates, errors, attitude = coordinates_of(followed, frames, noise)
    try:
        return extend(times, coordinates, errors, roughness=roughness), attitude
    except np.linalg.LinAlgError:
        raise FileError(where, None, "the frames before impact do not determine the path of the clubhead") from None


def coordinates_of(followed: Track, frames: Array, noise: float) -> tuple[Array, Array, Array]:
    """Return position and rotation vector of the frames, their covariances, and the attitude it counts from.

    Coordinates have shape (frames, 6); the attitude is that in the last of the frames.
    """
    position, rotation = followed.poses.position, followed.poses.rotation
    attitude = rotation[frames[-1]]
    turned = logarithm(rotation[frames] @ attitude.T)
    errors = noise**2 * np.linalg.inv(pose_information(followed.shape, rotation[frames], followed.seen[frames]))
    to_vector = np.zeros_like(errors)
    to_vector[:, :3, :3] = np.eye(3)
    to_vector[:, 3:, 3:] = np.linalg.inv(left_jacobian(turned))
    return np.concatenate([position[frames], turned], 1), to_vector @ errors @ np.swapaxes(to_vector, 1, 2), attitude


def usable(recent: Array, rotation: Array, fewest: int) -> Array:
    """Return the last frames that hang together and in which the head turns by no more than ``TURN``.

    Those before a wide gap are used as well where otherwise there were less than ``fewest``.
    """
    if not len(recent):
        return recent
    angle = np.linalg.norm(logarithm(rotation[recent] @ rotation[recent[-1]].T), axis=-1)
    gaps = np.diff(recent, append=recent[-1]) > WIDEST
    gaps[len(recent) - fewest :] = False
    first = np.flatnonzero((angle > TURN) | gaps)
    return recent[first[-1] + 1 :] if len(first) else recent


def _too_few(count: int, fewest: int, name: str) -> str:
    return f"{count} frames before impact show the clubhead; the estimator {name} needs {fewest}"
