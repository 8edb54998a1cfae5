"""The blow in the path of the clubhead: when the head loses speed, and which way it is pushed.

The path before and the path after are each extended to the instant at which they meet. The head keeps its place in the
blow and loses part of its velocity, so both paths cross in the middle of the contact. How well the instant is known
follows from how well the paths are, divided by the velocity that is lost.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from clubface.errors import FileError
from clubface.motion_capture.approach import coordinates_of, path_through, usable
from clubface.motion_capture.estimators import ROUGHNESS, TIME, Path, fit, smoother, wandering
from clubface.motion_capture.reduction import series
from clubface.motion_capture.rotations import Array, exponential, left_jacobian
from clubface.motion_capture.tracking import Track

CONTACT = 0.45e-3
"""Seconds; measured impacts of golf balls last 0.4 to 0.5 ms."""
CONTACT_DEVIATION = 0.05e-3
"""Of half of it: force rises and falls unevenly, and soft balls stay longer."""
LOST = 0.08
"""Part of its speed that a head loses at least by a blow: a driver 0.3, a putter 0.2. In a free swing it loses 0.03
over the same frames."""
FAST = 0.5
"""Part of the greatest speed that a head has at least when it meets the ball."""
WIDEST = 8
"""Frames without a pose across which a blow is looked for."""
FEWEST = 5
"""Frames needed on each side, for the quartic of the smoother."""
MOST = 40
LONGEST = 0.05
"""Seconds after the blow that are used."""
EARLY = 0.3e-3
"""Seconds that first touch may seem to come before the last frame before it: a few standard deviations."""
SHARE = 10.0
"""Weight of the misfit of a path: it counts a freedom, and a frame on the wrong side of the blow spoils few of them."""
ROUNDS = 6
ODD = 4.0
"""Times the expected square of the distance at which the paths pass each other, beyond which the instant is taken to be
less certain."""


class Blow(NamedTuple):
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
        Velocity of the origin of the head before the blow, and of its CG after it [m/s], shape (3,).
    covariance
        Of the difference of both, shape (3, 3).
    spin
        Angular velocity before the blow [rad/s], shape (3,).
    position, rotation
        Of the origin of the head at first touch [m], shape (3,), and from body axes to the world, shape (3, 3).
    score
        How badly both paths fit their frames and cross: a sum of squares in standard deviations.
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


def find_blow(
    times: Array, followed: Track, *, noise: float, arm: float, where: str, roughness: float = ROUGHNESS
) -> Blow:
    """Find the blow in a recording; refuse one that has none with a :class:`FileError`.

    Parameters
    ----------
    times
        Of the frames [s].
    followed
        The clubhead in every frame.
    noise
        Standard deviation of a marker along an axis [m].
    arm
        Standard deviation along each axis of where the CG is from the origin of the head [m]: after a blow off centre
        the head spins fast about its CG, and other points of it do not go smoothly.
    where
        The file, for errors.
    roughness
        Of the smoother.
    """
    before, after, lost = _frames(times, followed, where)
    known = np.flatnonzero(followed.known)
    place = int(np.searchsorted(known, before))
    tried = []
    for first in range(max(place - 1, 0), min(place + 2, len(known) - 1)):
        found = _cross(times, followed, int(known[first]), int(known[first + 1]), noise, arm, roughness, where)
        if found is not None and times[found.before] <= found.touch + EARLY and found.touch <= times[found.after]:
            tried.append(found)
    if not tried:
        raise FileError(
            where, None,
            f"no impact can be read: the clubhead loses speed between frames {before + 1} and {after + 1}, but its"
            f" paths before and after do not meet there, or less than {FEWEST} frames show it on either side",
        )  # fmt: skip
    return min(tried, key=lambda each: each.score)._replace(lost=lost)


def last_before(times: Array, followed: Track, where: str) -> int:
    """Return the last frame before the head loses speed, to a frame or two."""
    return _frames(times, followed, where)[0] - 1


def _frames(times: Array, followed: Track, where: str) -> tuple[int, int, float]:
    """Return the frames between which speed is lost, and which part of it."""
    position = followed.poses.position
    known = np.flatnonzero(followed.known)
    reason = "too few frames show the clubhead"
    if len(known) >= 2 * FEWEST:
        step = np.diff(position[known], axis=0) / np.diff(times[known])[:, None]
        # Velocity over two steps before each step and over two after it: the step itself may hold the blow.
        earlier = np.linalg.norm(0.5 * (step[:-4] + step[1:-3]), axis=-1)
        later = np.linalg.norm(0.5 * (step[3:-1] + step[4:]), axis=-1)
        wide = np.diff(known)[2:-2] > WIDEST
        lost = 1.0 - later / np.maximum(earlier, 1e-9)
        lost[(earlier < FAST * earlier.max()) | wide] = -np.inf
        # Frame place + 2 is the last before; enough of them are needed on both sides.
        lost[: max(FEWEST - 3, 0)] = lost[len(known) - 2 - FEWEST :] = -np.inf
        place = int(np.argmax(lost))
        if lost[place] > LOST:
            return int(known[place + 2]), int(known[place + 3]), float(lost[place])
        most = f" (at most {100.0 * max(float(lost[place]), 0.0):.0f}% within a few frames)"
        reason = f"the clubhead nowhere loses speed as in a blow{most}"
    raise FileError(
        where, None,
        f"no impact: {reason}. This is a swing without a ball, or the file ends less than {FEWEST} frames after impact;"
        " if there was a ball, give its marker or its position under [ball]",
    )  # fmt: skip


def _cross(
    times: Array, followed: Track, before: int, after: int, noise: float, arm: float, roughness: float, where: str
) -> Blow | None:
    """Return the blow between two frames from where the paths on either side cross; None with too few frames."""
    known = np.flatnonzero(followed.known)
    rotation = followed.poses.rotation
    earlier = usable(known[known <= before][-MOST:], rotation)
    later = known[(known >= after) & (times[known] < times[after] + LONGEST)][::-1]
    if len(earlier) < FEWEST or len(later) < FEWEST:
        return None
    start = 0.5 * (times[before] + times[after])
    coordinates, errors, _ = coordinates_of(followed, earlier, noise)
    ahead, attitude = path_through(times[earlier] - start, followed, earlier, noise, smoother, roughness, where)
    density = wandering(times[earlier], coordinates, roughness)[:3]
    held = exponential(_at(ahead, 0.0)[0][3:]) @ attitude
    # The CG goes smoothly; the origin, an unknown arm from it, does what the head's turn since the blow adds to that.
    errors = coordinates_of(followed, later, noise)[1][:, :3, :3]
    back = fit(start - times[later], followed.poses.position[later], errors, 4, density, arm * (rotation[later] - held))
    time, lost, weight = 0.0, np.zeros(3), np.eye(3)
    for _ in range(ROUNDS):
        one, two = _at(ahead, time), _at(back, -time)
        apart, lost = two[0] - one[0][:3], -two[1] - one[1][:3]
        weight = np.linalg.inv(one[2][:3, :3] + two[2])
        time = time - float(lost @ weight @ apart) / float(lost @ weight @ lost)
    one, two = _at(ahead, time), _at(back, -time)
    apart = two[0] - one[0][:3]
    across = float(apart @ weight @ apart)
    early = time - 0.5 * CONTACT
    values, *_ = _at(ahead, early)
    return Blow(
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
