"""The ball in a recording: its resting place, its departure, and its flight."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from clubface.capture.rotations import Array, visible

REST = 0.25
"""Time before departure over which the ball's position is averaged [s]."""
SHORTEST = 5
"""Minimum number of consecutive frames for a resting place."""
LEAST_SPEED = 1.0
"""Speed below which a ball counts as at rest [m/s]."""
TIMES_USUAL = 6.0
"""A ball counts as hit if it moves in one frame by this multiple of the lower quartile of its steps; for Gaussian noise
this is 6.6 standard deviations."""
FREE = 0.6e-3
"""Time after first touch from which the ball flies freely [s]; measured impacts last 0.4 to 0.5 ms."""
LONGEST = 0.03
"""Length of flight that is used [s]; drag then reduces the speed by less than 1%."""
GRAVITY = 9.80665


class RestingBall(NamedTuple):
    """A ball at rest before impact."""

    centre: Array  # [m], shape (3,)
    noise: float  # standard deviation of a single frame along an axis [m]
    frames: int  # number averaged
    span: tuple[int, int]  # first and last frame in which it is seen at rest there
    departure: int | None  # first frame in which it has moved; None if it is not seen to move


class Launched(NamedTuple):
    """A ball after impact, in world axes."""

    velocity: Array  # extrapolated back to first touch [m/s], shape (3,)
    covariance: Array  # of the velocity, shape (3, 3)
    start: float  # time at which it would have left at once with this velocity [s]: near the middle of the contact
    frames: int  # number that show the flight


def resting_places(seen: Array, rate: float) -> list[RestingBall]:
    """Return the places where the ball lies still, last place first; it may be moved before it is hit.

    ``seen`` is its centre in every frame [m], shape (frames, 3), NaN where not seen; ``rate`` is in frames per second.
    """
    known = np.flatnonzero(visible(seen))
    if not len(known):
        return []
    steps = np.linalg.norm(np.diff(seen[known], axis=0), axis=-1) / np.diff(known) * rate
    # The lower quartile of the distance of two points of unit noise in three dimensions is 1.101 sqrt(2).
    usual = float(np.quantile(steps, 0.25)) if len(steps) else 0.0
    noise = usual / (1.101 * math.sqrt(2.0)) / rate
    ends = np.append(np.flatnonzero(steps > max(LEAST_SPEED, TIMES_USUAL * usual)), len(known) - 1)
    starts = np.append(0, ends[:-1] + 1)
    places = []
    for start, end in zip(starts.tolist(), ends.tolist(), strict=True):
        run = known[start : end + 1]
        recent = run[run >= run[-1] - REST * rate]
        if end - start + 1 >= SHORTEST or len(known) < SHORTEST:
            departure = int(known[end + 1]) if end + 1 < len(known) else None
            places.append(RestingBall(seen[recent].mean(0), noise, len(recent), (int(run[0]), int(run[-1])), departure))
    return places[::-1]


def flight(seen: Array, times: Array, ball: RestingBall, touch: float) -> Launched | None:
    """Fit a straight line with gravity to the first frames of the flight; None if there are fewer than two.

    ``seen`` is the ball's centre in every frame in world axes [m]; ``touch`` is the time of first touch [s].
    """
    t = times - touch
    chosen = np.flatnonzero(visible(seen) & (t > FREE) & (t < LONGEST))[:20]
    if len(chosen) < 2:
        return None
    t = t[chosen]
    fallen = seen[chosen] + np.array([0.0, 0.5 * GRAVITY, 0.0]) * t[:, None] ** 2
    design = np.stack([np.ones(len(t)), t], 1)
    inverse = np.linalg.inv(design.T @ design)
    place, velocity = inverse @ design.T @ fallen
    square = float(velocity @ velocity)
    start = touch + float(velocity @ (ball.centre - place)) / square if square > 0.0 else math.nan
    return Launched(velocity, np.eye(3) * (ball.noise**2 * inverse[1, 1]), start, len(chosen))
