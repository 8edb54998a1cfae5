"""Impact detected in the path of the clubhead: when the head loses speed, and which way it is pushed.

The path before and the path after are each extended to the instant at which they meet. The head keeps its place
during contact and loses part of its velocity, so both paths cross in the middle of the contact. How well the instant
is known follows from how well the paths are, divided by the velocity that is lost.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from clubface.capture.estimators import ROUGHNESS, TIME, Path, fit, smoother, wandering
from clubface.capture.impact_frame import coordinates_of, path_through, usable
from clubface.capture.reduction import series
from clubface.capture.rotations import Array, exponential, left_jacobian
from clubface.capture.tracking import Track
from clubface.errors import FileError

CONTACT = 0.45e-3
"""Seconds; measured impacts of golf balls last 0.4 to 0.5 ms."""
CONTACT_DEVIATION = 0.05e-3
"""Standard deviation of half of it: force rises and falls unevenly, and soft balls stay longer."""
LOST = 0.08
"""Least part of its speed that a head loses at impact: a driver 0.3, a putter 0.2. In a free swing it loses 0.03
over the same frames."""
BEGUN = 0.01
"""Part of its speed that a head loses at least from one frame to the next if impact begins between them, but for the
last twentieth of that time."""
FAST = 0.5
"""Part of the greatest speed that a head has at least when it meets the ball."""
WIDEST = 8
"""Frames without a pose across which an impact is looked for."""
FEWEST = 5
"""Frames needed on each side, for the quartic of the smoother."""
WINDOW, STEPS = 0.02, 12
"""Seconds on either side through whose speeds a line goes, and how many speeds these are at most."""
LEVEL = 0.05
"""Seconds for which speed must stay down after an impact, and must have come near to what it was before it."""
SUDDEN, TOP = 0.5, 1.25
"""Parts of the speed right before an impact that the speeds of ``LEVEL`` before it reach at least, and at most."""
CLEAR, TIMES_USUAL = 0.3, 3.0
"""Mean distance of the speeds from lines before and after impact, at most: part of the speed lost, or times the usual
one, which is that of the noise."""
ALIKE = 0.5
"""Part of the greatest loss of speed that steps near the impact seem to have as well."""
NEARLY, LOW = 0.9, 0.15
"""Part of the greatest speed, and metres above its lowest place, with which a head meets the ball at the end of a
recording."""
APART = 0.1
"""Seconds between two impacts."""
IMPOSSIBLE = 100.0
"""m/s; faster than any clubhead."""
MOST = 40
LONGEST = 0.05
"""Seconds after the impact that are used."""
EARLY = 0.3e-3
"""Seconds that first touch may seem to come before the last frame before it: a few standard deviations."""
SHARE = 10.0
"""Weight of the misfit of a path: it counts a freedom, and a frame on the wrong side of impact spoils few of them."""
ROUNDS = 6
ODD = 4.0
"""Times the expected square of the distance at which the paths pass each other, beyond which the instant is taken to be
less certain."""


class DetectedImpact(NamedTuple):
    """Where and when a head loses speed.

    Attributes
    ----------
    before, after
        The frames between which it begins.
    touch
        First touch [s], half a contact before both paths cross.
    deviation
        Standard deviation of that [s].
    lost
        Part of the speed that is lost.
    velocity, later
        Velocity of the origin of the head before the impact, and of its CG after it [m/s], shape (3,).
    covariance
        Of the difference of both, shape (3, 3).
    spin
        Angular velocity before the impact [rad/s], shape (3,).
    position, rotation
        Of the origin of the head at first touch [m], shape (3,), and from body axes to the world, shape (3, 3).
    score
        How badly both paths fit their frames and cross: a sum of squares in standard deviations.
    again
        The frame of another drop of the speed, which is not taken; None without.
    """

    before: int
    after: int
    touch: float
    deviation: float
    lost: float
    velocity: Array
    later: Array
    covariance: Array
    spin: Array
    position: Array
    rotation: Array
    score: float
    again: int | None = None


def detect_impact(
    times: Array,
    followed: Track,
    *,
    noise: float,
    arm: float,
    where: str,
    roughness: float = ROUGHNESS,
    cg: Array | None = None,
) -> DetectedImpact:
    """Find the impact in a recording; refuse one that has none with a :class:`FileError`.

    Parameters
    ----------
    times
        Of the frames [s].
    followed
        The clubhead in every frame.
    noise
        Standard deviation of a marker along an axis [m].
    arm
        Standard deviation along each axis of where the CG is from the origin of the head [m]: after an impact off
        centre the head spins fast about its CG, and other points of it do not go smoothly.
    where
        The file, for errors.
    roughness
        Of the smoother.
    cg
        Where the CG is from the origin of the head, in the axes of the world at impact [m], shape (3,); there unless
        given.
    """
    before, after, lost, again = _frames(times, followed, where)
    cg = np.zeros(3) if cg is None else cg
    known = np.flatnonzero(followed.known)
    place = int(np.searchsorted(known, before))
    tried = []
    for first in range(max(place - 1, 0), min(place + 2, len(known) - 1)):
        frames = int(known[first]), int(known[first + 1])
        result = _cross(times, followed, frames, noise, arm, cg, roughness, where)
        if result is not None and times[result.before] <= result.touch + EARLY and result.touch <= times[result.after]:
            tried.append(result)
    if not tried:
        raise FileError(
            where, None,
            f"no impact can be read: the clubhead loses speed between frames {before + 1} and {after + 1}, but its"
            f" paths before and after do not meet there, or less than {FEWEST} frames show it on either side",
        )  # fmt: skip
    return min(tried, key=lambda each: each.score)._replace(lost=lost, again=again)


def last_before(times: Array, followed: Track, where: str) -> int:
    """Return the last frame before the head loses speed, to a frame or two."""
    return _frames(times, followed, where).before - 1


class End(NamedTuple):
    """An impact with which a recording ends, or all but ends.

    Attributes
    ----------
    before
        The last frame before it.
    touch, deviation
        First touch and its standard deviation [s]: where between two frames is not known.
    later
        How many frames follow.
    """

    before: int
    touch: float
    deviation: float
    later: int


def impact_at_end(times: Array, followed: Track) -> End | None:
    """Return the impact with which a recording ends; None where it does not seem to end with one.

    Up to four frames may follow, in which the head is slower. Without any the head must be fast and near the ground.
    """
    known = np.flatnonzero(followed.known)
    if len(known) < 3 * FEWEST or (np.diff(known[-2 * FEWEST :]) > 1).any():
        return None
    middle = (followed.poses.position + followed.poses.rotation @ followed.shape.mean(0))[known]
    frame = float(np.median(np.diff(times)))
    speeds = np.linalg.norm(np.diff(middle, axis=0), axis=-1) / np.diff(times[known])
    top = float(np.quantile(speeds[speeds < IMPOSSIBLE], 0.99))
    for later in range(FEWEST - 1, -1, -1):
        end = len(speeds) - later  # the step in which the impact lies, if any frame follows
        some = np.arange(max(end - STEPS, 0), end)
        level, off = _extended((some - end)[None].astype(np.float64), speeds[some][None])
        if off[0] > 0.5 * LOST * level[0] or level[0] < NEARLY * top:
            continue
        if later == 0:
            low = middle[-1, 1] - float(np.min(middle[:, 1])) < LOW
            return End(int(known[-1]), float(times[known[-1]]) + 0.5 * frame, frame, 0) if low else None
        begun = later == 1 or speeds[end] < (1.0 - BEGUN) * (2.0 * speeds[end - 1] - speeds[end - 2])
        if begun and (speeds[end + (later > 1) :] < (1.0 - LOST) * level[0]).all():
            before = int(known[end])
            return End(before, float(times[before]) + 0.5 * frame, frame / math.sqrt(12.0), later)
    return None


class Drop(NamedTuple):
    """Two frames between which speed is lost.

    Attributes
    ----------
    before, after
        The frames.
    lost
        Part of the speed that is lost, and stays lost.
    again
        The frame before another drop of the speed by half as much or more, at another time; None without.
    """

    before: int
    after: int
    lost: float
    again: int | None = None


def _frames(times: Array, followed: Track, where: str) -> Drop:
    """Return the frames between which the head loses speed for good."""
    known = np.flatnonzero(followed.known)
    # The markers are on the head wherever a calibration has its origin.
    middle = (followed.poses.position + followed.poses.rotation @ followed.shape.mean(0))[known]
    reason = "too few frames show the clubhead"
    if len(known) >= 2 * FEWEST:
        lost, speed, misfit = _losses(times[known], middle, known)
        # Next to a spike speeds are on no line, however far apart the lines are.
        usual = float(np.median(misfit[np.isfinite(misfit)])) if np.isfinite(misfit).any() else 0.0
        with np.errstate(invalid="ignore"):  # where there is no loss
            clear = misfit < np.fmax(CLEAR * lost * speed, TIMES_USUAL * usual)
        lost = np.where(clear, lost, -np.inf)
        best = int(np.argmax(lost))
        size = np.zeros(len(lost))
        np.multiply(lost, speed, out=size, where=lost > LOST)
        if size.any():
            best = int(np.argmax(size))
            away = np.abs(times[known[:-1]] - times[known[best]])
            again = int(np.argmax(np.where(away > APART, size, 0.0)))
            another = int(known[again]) if away[again] > APART and size[again] > 0.5 * size[best] else None
            best = int(np.argmin(np.where((away < WINDOW) & (size > ALIKE * size[best]), misfit, np.inf)))
            return Drop(int(known[best]), int(known[best + 1]), float(lost[best]), another)
        most = 100.0 * max(float(lost[best]), 0.0)
        reason = f"the clubhead nowhere loses speed as at impact (at most {most:.0f}% within a few frames)"
        reason += _hidden(times[known], middle, known)
    raise FileError(
        where, None,
        f"no impact: {reason}. This is a swing without a ball, or the file ends less than {FEWEST} frames after impact;"
        " if there was a ball, give its marker or its position under [ball]",
    )  # fmt: skip


def _losses(times: Array, position: Array, frames: Array) -> tuple[Array, Array, Array]:
    """Return which part of its speed the head loses for good in each step from frame to frame.

    Straight lines through the speeds before and after, that hold whatever a few of them do (Theil, 1950; Sen, 1968),
    are extended to the middle of the step. A step that is no impact has -inf: across a gap, from a speed that came at
    once or is back soon, as in a spike, or where the head turns round. The second result is the speed before [m/s], and
    the third how far the speeds are from both lines [m/s]: least where the impact lies in the step itself.
    """
    count, frame = len(times), float(np.median(np.diff(times)))
    every, place = max(1, round(WINDOW / STEPS / frame)), np.arange(len(times) - 1)
    near, far = (max(span, (FEWEST + 0.5) * frame) for span in (WINDOW, LEVEL))
    middle = 0.5 * (times[:-1] + times[1:])
    levels, speeds, apart, enough = [], [], [], []
    for start, way in ((place, -1), (place + 1, 1)):
        index = start[:, None] + way * every * np.arange(int(far / every / frame) + 2)
        inside = (index[:, 1:] >= 0) & (index[:, 1:] < count)
        index = index.clip(0, count - 1)
        when = 0.5 * (times[index[:, 1:]] + times[index[:, :-1]]) - middle[:, None]
        # Behind a gap the speed may be another.
        together = inside & (np.abs(np.diff(frames[index], axis=1)) <= max(WIDEST, every))
        since = np.abs(times[index[:, 1:]] - times[start][:, None])
        seen = np.logical_and.accumulate(together, axis=1) & (since <= far)
        with np.errstate(divide="ignore", invalid="ignore"):
            speed = np.linalg.norm(np.diff(position[index], axis=1), axis=-1) / np.abs(np.diff(times[index], axis=1))
        speed = np.where(seen & (speed < IMPOSSIBLE), speed, np.nan)
        close = np.where(since <= near, speed, np.nan)[:, : max(STEPS, FEWEST)]
        level, off = _extended(when[:, : close.shape[1]], close)
        if way < 0:
            # A line through a longer time is not led by a rise right before the step.
            level = np.fmin(level, _extended(when[:, ::2], speed[:, ::2])[0])
        levels.append(level)
        speeds.append(speed)
        apart.append(off)
        enough.append(np.isfinite(close).sum(1) >= FEWEST - 1)
    (before, after), (earlier, later) = levels, speeds
    with np.errstate(invalid="ignore", divide="ignore"):
        lost = 1.0 - after / before
        # Speeds next to a spike are off for some frames, those of a longer time before and after are not.
        stays = _quantile(later, 0.75) < (1.0 - 0.5 * LOST) * np.minimum(before, _quantile(earlier, 0.75))
        came = (_quantile(earlier, 0.5) > SUDDEN * before) & (_quantile(earlier, 0.75) < TOP * before)
        top = np.max(before, initial=0.0, where=came & np.isfinite(before))
        ahead = position[place] - position[np.maximum(place - 2, 0)]
        follows = position[np.minimum(place + 3, count - 1)] - position[place + 1]
        onward = (ahead * follows).sum(-1) > 0.0
        fine = (np.diff(frames) <= WIDEST) & stays & came & onward & (before >= FAST * top) & np.isfinite(lost)
    return np.where(fine & enough[0] & enough[1], lost, -np.inf), before, apart[0] + apart[1]


def _extended(when: Array, speeds: Array) -> tuple[Array, Array]:
    """Return robust lines through speeds, shape (lines, points) with NaN for none, at time zero, and their misfit."""
    one, two = np.triu_indices(when.shape[1], 1)
    slope = _quantile((speeds[:, two] - speeds[:, one]) / (when[:, two] - when[:, one]), 0.5)[:, None]
    level = _quantile(speeds - slope * when, 0.5)
    off = np.abs(speeds - level[:, None] - slope * when)
    return level, np.nansum(off, axis=1) / np.maximum(np.isfinite(off).sum(1), 1)


def _quantile(values: Array, share: float) -> Array:
    """Return a quantile of each row, NaN left out; NaN of a row without a number."""
    order = np.sort(values, axis=1)
    place = share * (np.isfinite(order).sum(1) - 1).clip(0)
    low, high = (np.take_along_axis(order, round(place).astype(int)[:, None], 1)[:, 0] for round in (np.floor, np.ceil))
    return 0.5 * (low + high)


def _hidden(times: Array, position: Array, frames: Array) -> str:
    """Say which gap hides the impact, if the head is slower after it by as much; else nothing."""
    speeds = np.linalg.norm(np.diff(position, axis=0), axis=-1) / np.diff(times)
    for place in np.flatnonzero(np.diff(frames) > 1):
        if FEWEST <= place < len(speeds) - FEWEST:
            before, after = np.median(speeds[place - 3 : place]), np.median(speeds[place + 1 : place + 4])
            if before > FAST * np.quantile(speeds, 0.98) and after < (1.0 - LOST) * before:
                return (
                    f"; it is not seen in frames {frames[place] + 2} to {frames[place + 1]}, and is slower after them"
                    f" ({before:.1f} and {after:.1f} m/s): the impact may lie there"
                )
    return ""


def _cross(
    times: Array,
    followed: Track,
    frames: tuple[int, int],
    noise: float,
    arm: float,
    cg: Array,
    roughness: float,
    where: str,
) -> DetectedImpact | None:
    """Return the impact between two frames from where the paths on either side cross; None with too few frames."""
    before, after = frames
    known = np.flatnonzero(followed.known)
    rotation = followed.poses.rotation
    earlier = usable(known[known <= before][-MOST:], rotation, FEWEST)
    later = known[(known >= after) & (times[known] < times[after] + LONGEST)][::-1]
    if len(earlier) < FEWEST or len(later) < FEWEST:
        return None
    start = 0.5 * (times[before] + times[after])
    coordinates, errors, _ = coordinates_of(followed, earlier, noise)
    ahead, attitude = path_through(times[earlier] - start, followed, earlier, noise, smoother, roughness, where)
    density = wandering(times[earlier], coordinates, roughness)[:3]
    errors = coordinates_of(followed, later, noise)[1][:, :3, :3]

    def left(time: float) -> Path:
        """Return the path of the CG after an impact at ``time``, moved to where the origin is then."""
        held = exponential(_at(ahead, time)[0][3:]) @ attitude
        # The CG goes smoothly; the origin, an arm from it that is known to ``arm``, does what the head's turn since the
        # impact adds to that.
        turned = rotation[later] @ held.T - np.eye(3)
        return fit(start - times[later], followed.poses.position[later] + turned @ cg, errors, 4, density, arm * turned)

    time, lost, weight = 0.0, np.zeros(3), np.eye(3)
    for _ in range(ROUNDS):
        one, two = _at(ahead, time), _at(left(time), -time)
        apart, lost = two[0] - one[0][:3], -two[1] - one[1][:3]
        weight = np.linalg.inv(one[2][:3, :3] + two[2])
        time = time - float(lost @ weight @ apart) / float(lost @ weight @ lost)
    back = left(time)
    one, two = _at(ahead, time), _at(back, -time)
    apart = two[0] - one[0][:3]
    across = float(apart @ weight @ apart)
    early = time - 0.5 * CONTACT
    values, *_ = _at(ahead, early)
    return DetectedImpact(
        before=before, after=after, touch=start + early,
        deviation=math.sqrt(max(1.0, 0.5 * across / ODD) / float(lost @ weight @ lost) + CONTACT_DEVIATION**2),
        lost=0.0, velocity=one[1][:3], later=-two[1],
        covariance=(one[3][:3, :3] + two[3]) * max(1.0, 0.5 * across / ODD),
        spin=left_jacobian(one[0][3:]) @ one[1][3:],
        position=values[:3], rotation=exponential(values[3:]) @ attitude,
        score=across + sum(SHARE * each.misfit for each in (ahead, back) if math.isfinite(each.misfit)),
    )  # fmt: skip


def _at(path: Path, time: float) -> tuple[Array, Array, Array, Array]:
    """Return coordinates and rates [1/s] of a path at ``time``, and their covariances with what does not fit."""
    when = np.array(time)
    values, rates = series(path.position, when), series(path.rate, when) / TIME
    count, width = path.position.shape
    powers = np.array([(time / TIME) ** j / math.factorial(j) for j in range(count)])
    at = np.kron(powers, np.eye(width))
    slope = np.kron(powers[:-1], np.eye(width)) / TIME
    size = count * width
    factor = max(1.0, path.misfit) if math.isfinite(path.misfit) else 1.0
    place, rate = path.covariance[:size, :size] * factor, path.covariance[size:, size:] * factor
    return values, rates, at @ place @ at.T, slope @ rate @ slope.T
