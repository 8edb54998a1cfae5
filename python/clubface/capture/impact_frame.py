"""The frames between which the face meets the ball, and the path through the last frames before first touch."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from clubface import units
from clubface.capture.ball_flight import RestingBall
from clubface.capture.estimators import TIME, TURN, Path, estimator
from clubface.capture.recording import Recording
from clubface.capture.reduction import Inputs, deliver, gap
from clubface.capture.rotations import Array, Poses, left_jacobian, logarithm, pose_information, visible
from clubface.capture.tracking import Track
from clubface.equipment.clubs import Club
from clubface.errors import FileError
from clubface.results.notes import Note, note

APPROACH = 1.0
"""Approach speed below which a face is being set down behind the ball [m/s]."""
SIDEWAYS = 0.15
"""Distance from the face centre above which the head passes by the ball [m]."""
WIDEST = 8
"""Maximum number of frames without a pose across which an impact is accepted."""
SLOWED = 0.95
"""Maximum fraction of its speed that a head keeps at impact; a putter keeps 0.8, a driver 0.7."""
STILL = 3e-3
"""Displacement below which a ball has not been hit [m]."""


class FrameInterval(NamedTuple):
    """Two frames between which the face meets the ball."""

    before: int  # the last frame with a pose before first touch
    after: int  # first frame after the impact has begun
    notes: tuple[Note, ...] = ()  # uncertainties of the interval


def find_impact(
    recording: Recording, poses: Poses, seen_ball: Array, places: Sequence[RestingBall], club: Club, radius: float
) -> tuple[FrameInterval, RestingBall]:
    """Return the frames between which the face passes a resting ball, and that ball; verify that it was hit.

    The ``poses`` are those of a head with its origin at the CG. ``seen_ball`` is the ball's centre [m], NaN where not
    seen, and ``radius`` its radius [m]. The first of its resting ``places`` that the face meets is used.

    Raises FileError if there is no impact: the face never passes the ball, the ball stays, or the head is not slowed.
    """
    position, rotation, _ = poses
    for ball in places:
        ahead, local = gap(position, rotation, ball.centre, club, radius)
        result = _find_pass(ahead, np.hypot(local[..., 1], local[..., 2]), ball, recording.rate)
        if result is not None:
            notes = _verify_impact(recording, position, seen_ball, ball, result)
            return result._replace(notes=result.notes + notes), ball
    hidden = _hidden_frames(position, places[0])
    if hidden is not None:
        raise recording.error(
            f"no impact can be read: the clubhead is not seen in frames {hidden[0] + 1} to {hidden[1] + 1}, just"
            " before the ball leaves; that is too many to extrapolate across"
        )
    away = np.linalg.norm(gap(position, rotation, places[0].centre, club, radius)[1], axis=-1)
    nearest = int(np.nanargmin(away))
    stays = "the ball stays"
    if places[0].departure is not None:
        stays = (
            "the ball leaves: the cause may be trajectories filtered across the impact (export raw ones), or a wrong"
            " mapping, calibration or club"
        )
    raise recording.error(
        f"no impact: the face does not pass the ball; its centre comes no nearer than"
        f" {units.fixed(away[nearest], 'mm', 0)} (frame {nearest + 1} of {len(away)}), and {stays}"
    )


def _hidden_frames(position: Array, ball: RestingBall) -> tuple[int, int] | None:
    """Return the first and last frame in which the head is hidden before the ball leaves; None if it is not hidden.

    Gaps short enough to extrapolate across do not count.
    """
    if ball.departure is None:
        return None
    seen = np.flatnonzero(np.isfinite(position[: ball.departure, 0]))
    first = int(seen[-1]) + 1 if len(seen) else 0
    return (first, ball.departure - 1) if ball.departure - first >= WIDEST - 1 else None


def _find_pass(ahead: Array, sideways: Array, ball: RestingBall, rate: float) -> FrameInterval | None:
    """Return the frames between which the face passes a ball at rest; None if it does not."""
    known = np.flatnonzero(np.isfinite(ahead))
    first, second = known[:-1], known[1:]
    closing = (ahead[first] - ahead[second]) / (second - first) * rate
    passes = (ahead[first] > 0.0) & (ahead[second] <= 0.0) & (closing > APPROACH) & (second - first <= WIDEST)
    passes &= np.minimum(sideways[first], sideways[second]) < SIDEWAYS
    passes &= (second >= ball.span[0]) & (first <= ball.span[1] + WIDEST)
    places = np.flatnonzero(passes)
    if not len(places):
        return _last_seen(ahead, known, ball, sideways)
    # Choose the pass at which the ball leaves; failing that, the fastest: a practice swing is slower, or misses.
    key = closing[places] if ball.departure is None else -np.abs(second[places] - ball.departure)
    chosen = places[int(np.argmax(key))]
    return FrameInterval(int(first[chosen]), int(second[chosen]))


def _last_seen(ahead: Array, known: Array, ball: RestingBall, sideways: Array) -> FrameInterval | None:
    """Return the interval of a head that was last seen just before the ball leaves or is last seen itself."""
    gone = ball.span[1] + 1 if ball.departure is None else ball.departure
    earlier = known[known < gone]
    if gone >= len(ahead) or len(earlier) < 2 or gone - earlier[-1] > WIDEST or sideways[earlier[-1]] > SIDEWAYS:
        return None
    if not ahead[earlier[-2]] > ahead[earlier[-1]] > 0.0:
        return None
    return FrameInterval(int(earlier[-1]), gone, (note("capture-head-lost"),))


def _verify_impact(
    recording: Recording, position: Array, seen_ball: Array, ball: RestingBall, result: FrameInterval
) -> tuple[Note, ...]:
    """Raise FileError if neither ball nor head reacted to a pass; return notes on what could not be verified."""
    frames = f"frames {result.before + 1} and {result.after + 1}"
    later = seen_ball[result.after + 1 : result.after + 12]
    later = later[visible(later)]
    if len(later):
        moved = float(np.linalg.norm(later - ball.centre, axis=-1).max())
        if moved < max(STILL, 6.0 * ball.noise):
            raise recording.error(
                f"no impact: the face passes the ball's position between {frames}, but the ball stays there"
                f" (it moves {units.fixed(moved, 'mm', 1)}); this is a swing without a ball, or the mapping is wrong"
            )
        return ()
    near = slice(result.before - 5, result.before + 1), slice(result.after + 1, result.after + 7)
    speeds = [_speed(position[each], recording.rate) for each in near]
    if not np.isfinite(speeds).all():
        return (note("capture-nothing-seen-after-impact"),)
    if speeds[1] > SLOWED * speeds[0]:
        raise recording.error(
            f"no impact: the face passes the ball's position between {frames}, but the head keeps its speed"
            f" ({speeds[0]:.1f} m/s before, {speeds[1]:.1f} m/s after); this is a swing without a ball, or the mapping"
            " is wrong"
        )
    return (note("capture-ball-not-seen"),)


def _speed(position: Array, rate: float) -> float:
    """Return the speed over a few frames [m/s]; NaN with fewer than two poses."""
    known = np.flatnonzero(np.isfinite(position[:, 0]))
    if len(known) < 2:
        return float("nan")
    return float(np.linalg.norm(position[known[-1]] - position[known[0]]) / (known[-1] - known[0]) * rate)


TOUCHING = 1e-3
"""Advance of the face after first touch up to which a frame is used [m]; the ball hardly pushes yet."""
SETTLED = 1e-9
"""Convergence tolerance for the instant of impact [s]; the head moves 50 nm in that time."""
MOST_ROUNDS = 20
WIDEST_APPROACH = 12
"""Maximum number of frames without a pose across which the path is followed."""


class Approach(NamedTuple):
    """The path of the clubhead to the ball."""

    path: Path  # path about the instant of first touch
    attitude: Array  # rotation from club to world axes where the path's rotation vector is zero, shape (3, 3)
    touch: float  # time of first touch on the clock of the frames [s]
    frames: Array  # numbers of those used, ascending


class Extrapolation(NamedTuple):
    """How a path is extrapolated."""

    noise: float  # standard deviation of a marker along an axis [m]
    name: str  # of the estimator
    roughness: float  # for the smoother
    where: str  # file name for errors

    def error(self, message: str) -> FileError:
        """Return an error of the file."""
        return FileError(self.where, None, message)

    def check_count(self, frames: Array) -> None:
        """Raise FileError if the estimator needs more frames."""
        if len(frames) < (fewest := estimator(self.name).fewest):
            words = f"{len(frames)} frames before impact show the clubhead; the estimator {self.name} needs {fewest}"
            raise self.error(words)


def follow(
    times: Array, followed: Track, interval: FrameInterval, ball: Array, club: Club, radius: float, how: Extrapolation
) -> Approach:
    """Extrapolate the path of a clubhead, ``followed`` with its origin at the CG, to its first touch of the ball.

    ``times`` are those of the frames [s], ``interval`` the frames between which the head meets the ball, and ``ball``
    and ``radius`` the ball's centre at rest and radius [m]. Raises FileError if there are too few frames before impact,
    or the path does not lead to the ball.
    """
    position, rotation = followed.poses.position, followed.poses.rotation
    known = np.flatnonzero(followed.known & (np.arange(len(times)) <= interval.before))
    how.check_count(known)
    last = known[-4:]
    ahead, _ = gap(position[last], rotation[last], ball, club, radius)
    closing = float(ahead[0] - ahead[-1]) / float(times[last[-1]] - times[last[0]])
    if closing <= 0.0:
        raise how.error("the clubhead does not come nearer to the ball in the last frames before impact")
    touch = float(times[known[-1]] + ahead[-1] / closing)
    for _ in range(MOST_ROUNDS):
        result = _approach(times, followed, known, touch, how)
        _, time = deliver(
            Inputs(result.path.position, result.path.rate, ball, np.zeros(6)), result.attitude, club, radius
        )
        if not abs(float(time)) < TIME:
            raise how.error(f"the path of the clubhead by {how.name} does not lead to the ball")
        touch += float(time)
        if times[result.frames[-1]] > touch + TOUCHING / closing:
            known = known[:-1]
        elif abs(float(time)) < SETTLED:
            return result._replace(touch=touch)
    raise how.error(f"the path of the clubhead by {how.name} does not settle on an instant of impact")


def follow_until(times: Array, followed: Track, touch: float, how: Extrapolation) -> Approach:
    """Extrapolate the clubhead's path to a known instant of first touch, such as a detected impact."""
    return _approach(times, followed, np.flatnonzero(followed.known & (times <= touch)), touch, how)


def _approach(times: Array, followed: Track, known: Array, touch: float, how: Extrapolation) -> Approach:
    """Return the path about ``touch`` through the last of the ``known`` frames."""
    _, fewest, most = estimator(how.name)
    frames = usable(known[-most:], followed.poses.rotation, fewest)
    how.check_count(frames)
    return Approach(*path_through(times[frames] - touch, followed, frames, how), touch, frames)


def path_through(times: Array, followed: Track, frames: Array, how: Extrapolation) -> tuple[Path, Array]:
    """Return the path through frames about time zero, and the attitude relative to which its rotation vector is given.

    The ``times`` of these frames [s] ascend; they count backwards for a path followed back in time. The last of
    ``frames`` is nearest to time zero.
    """
    coordinates, errors, attitude = coordinates_of(followed, frames, how.noise)
    try:
        return estimator(how.name).extend(times, coordinates, errors, roughness=how.roughness), attitude
    except np.linalg.LinAlgError:
        raise how.error("the frames before impact do not determine the path of the clubhead") from None


def coordinates_of(followed: Track, frames: Array, noise: float) -> tuple[Array, Array, Array]:
    """Return coordinates (position, rotation vector) of the frames, their covariances, and the reference attitude.

    Coordinates have shape (frames, 6); the reference attitude is that of the last frame.
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
    """Return the last frames without wide gaps between which the head turns by at most ``TURN``.

    Frames before a wide gap are kept if there would otherwise be fewer than ``fewest``.
    """
    if not len(recent):
        return recent
    angle = np.linalg.norm(logarithm(rotation[recent] @ rotation[recent[-1]].T), axis=-1)
    gaps = np.diff(recent, append=recent[-1]) > WIDEST_APPROACH
    gaps[len(recent) - fewest :] = False
    first = np.flatnonzero((angle > TURN) | gaps)
    return recent[first[-1] + 1 :] if len(first) else recent
