"""Detection of impact from the clubhead's path: when the head loses speed, and in which direction it is pushed.

The paths before and after impact are each extrapolated to the instant at which they meet. During contact the head
hardly moves but loses part of its velocity, so the paths cross in the middle of the contact. The uncertainty of this
instant is the uncertainty of the paths divided by the loss of velocity.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from clubface.capture.estimators import TIME, Path, fit, wandering
from clubface.capture.impact_frame import Extrapolation, coordinates_of, path_through, usable
from clubface.capture.reduction import series
from clubface.capture.rotations import Array, exponential, left_jacobian
from clubface.capture.tracking import Track
from clubface.errors import FileError

CONTACT = 0.45e-3
"""Duration of contact [s]; measured impacts of golf balls last 0.4 to 0.5 ms."""
CONTACT_DEVIATION = 0.05e-3
"""Standard deviation of half the contact [s]: force rises and falls asymmetrically, and soft balls stay longer."""
LOST = 0.08
"""Minimum fraction of its speed that a head loses at impact; a driver loses 0.3, a putter 0.2. In a free swing it loses
0.03 over the same number of frames."""
BEGUN = 0.01
"""Minimum fraction of speed lost between two frames if impact begins between them, unless it begins in the last
twentieth of that interval."""
FAST = 0.5
"""Minimum speed at impact, as a fraction of the head's maximum speed."""
WIDEST = 8
"""Maximum number of frames without a pose across which an impact is searched."""
FEWEST = 5
"""Minimum number of frames on each side, for the smoother's quartic."""
WINDOW, STEPS = 0.02, 12
"""Time on either side over which a line is fitted to the speeds [s], and the maximum number of speeds."""
LEVEL = 0.05
"""Time [s] for which speed must stay low after impact, and must have been near its final value before impact."""
SUDDEN, TOP = 0.5, 1.25
"""Range of speeds within ``LEVEL`` before an impact, relative to the speed just before it."""
CLEAR, TIMES_USUAL = 0.3, 3.0
"""Maximum mean distance of the speeds from the lines before and after impact: relative to the speed lost, or to the
usual distance, which is due to noise."""
ALIKE = 0.5
"""Steps near the impact whose apparent loss exceeds this fraction of the largest loss are candidates too."""
NEARLY, LOW = 0.9, 0.15
"""Minimum fraction of maximum speed, and maximum height above the lowest position [m], at an impact that ends a
recording."""
APART = 0.1
"""Minimum time between two impacts [s]."""
IMPOSSIBLE = 100.0
"""Speed that no clubhead reaches [m/s]."""
MOST = 40
LONGEST = 0.05
"""Time after impact that is used [s]."""
EARLY = 0.3e-3
"""Time by which first touch may appear to precede the last frame before it [s]: a few standard deviations."""
SHARE = 10.0
"""Weight of the path misfits: they are per degree of freedom, and a frame on the wrong side of impact affects few."""
ROUNDS = 6
ODD = 4.0
"""Ratio of the squared distance between the paths to its expectation above which the uncertainty of the instant is
increased."""


class DetectedImpact(NamedTuple):
    """Time and place at which a head loses speed."""

    before: int  # last frame before the loss begins
    after: int  # first frame after that
    touch: float  # time of first touch [s], half a contact before the paths cross
    deviation: float  # its standard deviation [s]
    lost: float  # fraction of speed lost
    velocity: Array  # of the head's origin before impact [m/s], shape (3,)
    later: Array  # velocity of its CG after impact [m/s], shape (3,)
    covariance: Array  # of the difference of the two velocities, shape (3, 3)
    spin: Array  # angular velocity before impact [rad/s], shape (3,)
    position: Array  # of the head's origin at first touch [m], shape (3,)
    rotation: Array  # from body to world axes, shape (3, 3)
    score: float  # sum of squares in standard deviations of the paths' misfits and of the distance at their crossing
    again: int | None = None  # frame of another loss of speed that was not chosen, or None


def detect_impact(
    times: Array, followed: Track, how: Extrapolation, *, arm: float, cg: Array | None = None
) -> DetectedImpact:
    """Find the impact in a recording by the smoother, whatever the estimator; raise FileError if there is none.

    ``times`` are those of the frames [s], and ``cg`` is the position of the CG relative to the head's origin, in world
    axes at impact [m], shape (3,); default: there. ``arm`` is the standard deviation of this position along each axis
    [m]: after an off-centre impact the head spins fast about its CG, and its other points do not move smoothly.
    """
    before, after, lost, again = _impact_frames(times, followed, how.where)
    cg, how = np.zeros(3) if cg is None else cg, how._replace(name="smoother")
    known = np.flatnonzero(followed.known)
    place = int(np.searchsorted(known, before))
    tried = []
    for first in range(max(place - 1, 0), min(place + 2, len(known) - 1)):
        frames = int(known[first]), int(known[first + 1])
        result = _crossing(times, followed, frames, how, arm, cg)
        if result is not None and times[result.before] <= result.touch + EARLY and result.touch <= times[result.after]:
            tried.append(result)
    if not tried:
        raise how.error(
            f"no impact can be read: the clubhead loses speed between frames {before + 1} and {after + 1}, but its"
            f" paths before and after do not meet there, or fewer than {FEWEST} frames show it on either side"
        )
    return min(tried, key=lambda each: each.score)._replace(lost=lost, again=again)


def last_before(times: Array, followed: Track, where: str) -> int:
    """Return the last frame before the head loses speed, to within a frame or two."""
    return _impact_frames(times, followed, where).before - 1


class End(NamedTuple):
    """An impact at or near the end of a recording."""

    before: int  # the last frame before it
    touch: float  # time of first touch [s]; its position between two frames is unknown
    deviation: float  # its standard deviation [s]
    later: int  # number of frames that follow


def impact_at_end(times: Array, followed: Track) -> End | None:
    """Return the impact at the end of a recording; None if there seems to be none.

    Up to four frames with lower speed may follow. If none follow, the head must be fast and near the ground.
    """
    known = np.flatnonzero(followed.known)
    if len(known) < 3 * FEWEST or (np.diff(known[-2 * FEWEST :]) > 1).any():
        return None
    middle = (followed.poses.position + followed.poses.rotation @ followed.shape.mean(0))[known]
    frame = float(np.median(np.diff(times)))
    speeds = np.linalg.norm(np.diff(middle, axis=0), axis=-1) / np.diff(times[known])
    top = float(np.quantile(speeds[speeds < IMPOSSIBLE], 0.99))
    for later in range(FEWEST - 1, -1, -1):
        end = len(speeds) - later  # the step containing the impact, if any frame follows
        some = np.arange(max(end - STEPS, 0), end)
        level, off = _fit_lines((some - end)[None].astype(np.float64), speeds[some][None])
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
    """A loss of speed between two frames."""

    before: int
    after: int
    lost: float  # fraction of speed lost permanently
    again: int | None = None  # frame before another loss of at least half the size, at another time, or None


def _impact_frames(times: Array, followed: Track, where: str) -> Drop:
    """Return the frames between which the head permanently loses speed."""
    known = np.flatnonzero(followed.known)
    # The markers are on the head wherever the calibration puts the origin.
    middle = (followed.poses.position + followed.poses.rotation @ followed.shape.mean(0))[known]
    reason = "too few frames show the clubhead"
    if len(known) >= 2 * FEWEST:
        lost, speed, misfit = _losses(times[known], middle, known)
        # Next to a spike, speeds lie on no line, however far apart the lines are.
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
        reason += _describe_gap(times[known], middle, known)
    raise FileError(
        where, None,
        f"no impact: {reason}. This is a swing without a ball, or the file ends fewer than {FEWEST} frames after"
        " impact; if there was a ball, give its marker or its position under [ball]",
    )  # fmt: skip


def _losses(times: Array, position: Array, frames: Array) -> tuple[Array, Array, Array]:
    """Return the fraction of speed that the head permanently loses in each step between frames.

    Robust lines (Theil, 1950; Sen, 1968) through the speeds before and after are extrapolated to the middle of the
    step. Steps that cannot be an impact get -inf: across a gap, with a speed that rose suddenly or recovers soon, as
    in a spike, or where the head reverses. The second result is the speed before [m/s], the third the distance of the
    speeds from both lines [m/s], which is smallest for the step that contains the impact.
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
        # Speed may change across a gap.
        together = inside & (np.abs(np.diff(frames[index], axis=1)) <= max(WIDEST, every))
        since = np.abs(times[index[:, 1:]] - times[start][:, None])
        seen = np.logical_and.accumulate(together, axis=1) & (since <= far)
        with np.errstate(divide="ignore", invalid="ignore"):
            speed = np.linalg.norm(np.diff(position[index], axis=1), axis=-1) / np.abs(np.diff(times[index], axis=1))
        speed = np.where(seen & (speed < IMPOSSIBLE), speed, np.nan)
        close = np.where(since <= near, speed, np.nan)[:, : max(STEPS, FEWEST)]
        level, off = _fit_lines(when[:, : close.shape[1]], close)
        if way < 0:
            # A line over a longer time is not affected by a rise just before the step.
            level = np.fmin(level, _fit_lines(when[:, ::2], speed[:, ::2])[0])
        levels.append(level)
        speeds.append(speed)
        apart.append(off)
        enough.append(np.isfinite(close).sum(1) >= FEWEST - 1)
    (before, after), (earlier, later) = levels, speeds
    with np.errstate(invalid="ignore", divide="ignore"):
        lost = 1.0 - after / before
        # Speeds next to a spike are off for a few frames, those over a longer time are not.
        stays = _quantile(later, 0.75) < (1.0 - 0.5 * LOST) * np.minimum(before, _quantile(earlier, 0.75))
        came = (_quantile(earlier, 0.5) > SUDDEN * before) & (_quantile(earlier, 0.75) < TOP * before)
        top = np.max(before, initial=0.0, where=came & np.isfinite(before))
        ahead = position[place] - position[np.maximum(place - 2, 0)]
        follows = position[np.minimum(place + 3, count - 1)] - position[place + 1]
        onward = (ahead * follows).sum(-1) > 0.0
        fine = (np.diff(frames) <= WIDEST) & stays & came & onward & (before >= FAST * top) & np.isfinite(lost)
    return np.where(fine & enough[0] & enough[1], lost, -np.inf), before, apart[0] + apart[1]


def _fit_lines(when: Array, speeds: Array) -> tuple[Array, Array]:
    """Fit robust lines to speeds, shape (lines, points) with NaN for missing ones; return value at zero and misfit."""
    one, two = np.triu_indices(when.shape[1], 1)
    slope = _quantile((speeds[:, two] - speeds[:, one]) / (when[:, two] - when[:, one]), 0.5)[:, None]
    level = _quantile(speeds - slope * when, 0.5)
    off = np.abs(speeds - level[:, None] - slope * when)
    return level, np.nansum(off, axis=1) / np.maximum(np.isfinite(off).sum(1), 1)


def _quantile(values: Array, share: float) -> Array:
    """Return a quantile of each row, ignoring NaN; NaN for a row of NaN."""
    order = np.sort(values, axis=1)
    place = share * (np.isfinite(order).sum(1) - 1).clip(0)
    low, high = (np.take_along_axis(order, round(place).astype(int)[:, None], 1)[:, 0] for round in (np.floor, np.ceil))
    return 0.5 * (low + high)


def _describe_gap(times: Array, position: Array, frames: Array) -> str:
    """Describe a gap that may hide the impact, if the head is slower after it; else return an empty string."""
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


def _crossing(
    times: Array, followed: Track, frames: tuple[int, int], how: Extrapolation, arm: float, cg: Array
) -> DetectedImpact | None:
    """Return the impact between two frames, where the paths on either side cross; None if there are too few frames."""
    before, after = frames
    known = np.flatnonzero(followed.known)
    rotation = followed.poses.rotation
    earlier = usable(known[known <= before][-MOST:], rotation, FEWEST)
    later = known[(known >= after) & (times[known] < times[after] + LONGEST)][::-1]
    if len(earlier) < FEWEST or len(later) < FEWEST:
        return None
    start = 0.5 * (times[before] + times[after])
    ahead, attitude = path_through(times[earlier] - start, followed, earlier, how)
    density = wandering(times[earlier], coordinates_of(followed, earlier, how.noise)[0], how.roughness)[:3]
    errors = coordinates_of(followed, later, how.noise)[1][:, :3, :3]

    def left(time: float) -> Path:
        """Return the CG's path after an impact at ``time``, shifted to the origin's position at that time."""
        held = exponential(_evaluate(ahead, time)[0][3:]) @ attitude
        # The CG moves smoothly. The origin, at an arm known to ``arm``, also follows the head's rotation since
        # impact.
        turned = rotation[later] @ held.T - np.eye(3)
        return fit(start - times[later], followed.poses.position[later] + turned @ cg, errors, 4, density, arm * turned)

    time, lost, weight = 0.0, np.zeros(3), np.eye(3)
    for _ in range(ROUNDS):
        one, two = _evaluate(ahead, time), _evaluate(left(time), -time)
        apart, lost = two[0] - one[0][:3], -two[1] - one[1][:3]
        weight = np.linalg.inv(one[2][:3, :3] + two[2])
        time = time - float(lost @ weight @ apart) / float(lost @ weight @ lost)
    back = left(time)
    one, two = _evaluate(ahead, time), _evaluate(back, -time)
    apart = two[0] - one[0][:3]
    across = float(apart @ weight @ apart)
    early = time - 0.5 * CONTACT
    values, *_ = _evaluate(ahead, early)
    return DetectedImpact(
        before=before, after=after, touch=start + early,
        deviation=math.sqrt(max(1.0, 0.5 * across / ODD) / float(lost @ weight @ lost) + CONTACT_DEVIATION**2),
        lost=0.0, velocity=one[1][:3], later=-two[1],
        covariance=(one[3][:3, :3] + two[3]) * max(1.0, 0.5 * across / ODD),
        spin=left_jacobian(one[0][3:]) @ one[1][3:],
        position=values[:3], rotation=exponential(values[3:]) @ attitude,
        score=across + sum(SHARE * each.misfit for each in (ahead, back) if math.isfinite(each.misfit)),
    )  # fmt: skip


def _evaluate(path: Path, time: float) -> tuple[Array, Array, Array, Array]:
    """Return coordinates and rates [1/s] of a path at ``time``, and their covariances, including misfit."""
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
