"""The ball in a recording: where it lies, when it leaves, and how it flies off."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from clubface.capture.rotations import Array, visible

REST = 0.25
"""Seconds before it leaves over which the place of the ball is averaged."""
SHORTEST = 5
"""Frames in a row that make a resting place."""
LEAST_SPEED = 1.0
"""Speed below which a ball lies still [m/s]."""
TIMES_USUAL = 6.0
"""How many times the lower quartile of its steps a ball must move in a frame to have been hit: 6.6 standard deviations
of Gaussian noise."""
FREE = 0.6e-3
"""Time after first touch from which it flies freely [s]; measured impacts last 0.4 to 0.5 ms."""
LONGEST = 0.03
"""Seconds of flight that are used: drag takes less than 1% of the speed."""
GRAVITY = 9.80665


class RestingBall(NamedTuple):
    """A ball before impact.

    Attributes
    ----------
    centre
        [m], shape (3,).
    noise
        Standard deviation of one frame along an axis [m].
    frames
        Frames averaged.
    span
        The first and the last frame in which it is seen to lie there.
    departure
        The first frame in which it has moved, or None where it is not seen to.
    """

    centre: Array
    noise: float
    frames: int
    span: tuple[int, int]
    departure: int | None


class Launched(NamedTuple):
    """A ball after impact, in world axes.

    Attributes
    ----------
    velocity
        At first touch, had it flown from there [m/s], shape (3,).
    covariance
        Of the velocity, shape (3, 3).
    start
        When a ball of that velocity would have left its place at once [s]; a real one gathers speed over the contact,
        so this is near the middle of it.
    frames
        Frames that show the flight.
    """

    velocity: Array
    covariance: Array
    start: float
    frames: int


def resting_places(seen: Array, rate: float) -> list[RestingBall]:
    """Return where the ball lies still, the last place first: it may be carried about before it is hit.

    ``seen`` is its centre in every frame [m], shape (frames, 3), NaN where it is not seen, at ``rate`` frames a second.
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
    """Fit the first frames of the flight with a straight line under gravity; None with fewer than two of them.

    ``seen`` is the centre of the ball in every frame [m], in world axes, and ``touch`` the time of first touch [s].
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
