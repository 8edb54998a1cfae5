"""Between which frames the face meets the ball."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.clubs import Club
from clubface.errors import FileError
from clubface.motion_capture.ball_flight import RestingBall
from clubface.motion_capture.reduction import gap
from clubface.motion_capture.rigid_body import visible
from clubface.motion_capture.rotations import Array

APPROACH = 1.0
"""m/s; a face that comes nearer more slowly is being set down behind the ball."""
ASIDE = 0.15
"""Metres from the face centre beyond which the head passes the ball instead of meeting it."""
WIDEST = 8
"""Frames without a pose across which a meeting is still believed."""
SLOWED = 0.95
"""Part of its speed a head keeps at most that has hit a ball: a putter keeps 0.8, a driver 0.7."""
STILL = 3e-3
"""Metres a ball moves at most that has not been hit."""


class Interval(NamedTuple):
    """Two frames between which the face meets the ball.

    Attributes
    ----------
    before
        The last frame with a pose before first touch.
    after
        The first frame that shows the impact has begun.
    notes
        What is not certain about it.
    """

    before: int
    after: int
    notes: tuple[str, ...] = ()


def find_impact(
    position: Array, rotation: Array, seen_ball: Array, places: Sequence[RestingBall], club: Club, radius: float,
    rate: float, where: str,
) -> tuple[Interval, RestingBall]:  # fmt: skip
    """Find the frames between which the face passes where the ball lies, and make sure that it hit the ball.

    Parameters
    ----------
    position, rotation
        Of the CG [m] and from club axes to the world; NaN in frames without a pose.
    seen_ball
        Centre of the ball in every frame [m]; NaN where it is not seen.
    places
        Where the ball lay, the last place first; the first at which it is met counts.
    club, radius
        The face, and the radius of the ball [m].
    rate
        Frames a second.
    where
        The file, for errors.

    Returns
    -------
    tuple
        The frames, and the ball where it was met.

    Raises
    ------
    FileError
        No impact: the face never passes the ball, or the ball stays, or the head is not slowed.
    """
    for ball in places:
        ahead, local = gap(position, rotation, ball.centre, club, radius)
        found = _pass(ahead, np.hypot(local[..., 1], local[..., 2]), ball, rate)
        if found is not None:
            notes = _make_sure(position, seen_ball, ball, found, rate, where)
            return found._replace(notes=found.notes + notes), ball
    hidden = _hidden(position, places[0])
    if hidden is not None:
        raise FileError(
            where, None,
            f"no impact can be read: the clubhead is not seen in frames {hidden[0] + 1} to {hidden[1] + 1}, right"
            " before the ball leaves: too many to go on from where it was last",
        )  # fmt: skip
    away = np.linalg.norm(gap(position, rotation, places[0].centre, club, radius)[1], axis=-1)
    nearest = int(np.nanargmin(away))
    stays = "the ball stays" if places[0].departure is None else "the ball leaves"
    raise FileError(
        where, None,
        f"no impact: the face does not pass the ball; its centre comes no nearer than"
        f" {units.fixed(away[nearest], 'mm', 0)}"
        f" (frame {nearest + 1} of {len(away)}), and {stays}",
    )  # fmt: skip


def _hidden(position: Array, ball: RestingBall) -> tuple[int, int] | None:
    """Return the first and last frame in which the head is lost from sight before the ball leaves, None if it is not.

    Frames across which its way can be extended do not count.
    """
    if ball.departure is None:
        return None
    seen = np.flatnonzero(np.isfinite(position[: ball.departure, 0]))
    first = int(seen[-1]) + 1 if len(seen) else 0
    return (first, ball.departure - 1) if ball.departure - first >= WIDEST - 1 else None


def _pass(ahead: Array, aside: Array, ball: RestingBall, rate: float) -> Interval | None:
    """Return the frames between which the face passes a ball while it lies there, None if it does not."""
    known = np.flatnonzero(np.isfinite(ahead))
    first, second = known[:-1], known[1:]
    closing = (ahead[first] - ahead[second]) / (second - first) * rate
    passes = (ahead[first] > 0.0) & (ahead[second] <= 0.0) & (closing > APPROACH) & (second - first <= WIDEST)
    passes &= np.minimum(aside[first], aside[second]) < ASIDE
    passes &= (second >= ball.span[0]) & (first <= ball.span[1] + WIDEST)
    places = np.flatnonzero(passes)
    if not len(places):
        return _last_seen(ahead, known, ball, aside)
    # The one at which the ball leaves; without that, the fastest: a practice swing is slower, or misses.
    key = closing[places] if ball.departure is None else -np.abs(second[places] - ball.departure)
    chosen = places[int(np.argmax(key))]
    return Interval(int(first[chosen]), int(second[chosen]))


def _last_seen(ahead: Array, known: Array, ball: RestingBall, aside: Array) -> Interval | None:
    """Return the interval of a head that is lost from sight before the ball leaves, or is lost from sight as well."""
    gone = ball.span[1] + 1 if ball.departure is None else ball.departure
    earlier = known[known < gone]
    if gone >= len(ahead) or len(earlier) < 2 or gone - earlier[-1] > WIDEST or aside[earlier[-1]] > ASIDE:
        return None
    if not ahead[earlier[-2]] > ahead[earlier[-1]] > 0.0:
        return None
    return Interval(int(earlier[-1]), gone, ("the clubhead is lost from sight before it meets the ball",))


def _make_sure(
    position: Array, seen_ball: Array, ball: RestingBall, found: Interval, rate: float, where: str
) -> tuple[str, ...]:
    """Refuse a pass that moved neither ball nor head; return what could not be made sure."""
    frames = f"frames {found.before + 1} and {found.after + 1}"
    later = seen_ball[found.after + 1 : found.after + 12]
    later = later[visible(later)]
    if len(later):
        moved = float(np.linalg.norm(later - ball.centre, axis=-1).max())
        if moved < max(STILL, 6.0 * ball.noise):
            raise FileError(
                where, None,
                f"no impact: the face passes the place of the ball between {frames}, but the ball stays there"
                f" (it moves {units.fixed(moved, 'mm', 1)}): a swing without a ball, or a wrong mapping",
            )  # fmt: skip
        return ()
    speeds = [
        _speed(position[found.before - 5 : found.before + 1], rate),
        _speed(position[found.after + 1 : found.after + 7], rate),
    ]
    if not np.isfinite(speeds).all():
        return ("neither ball nor clubhead is seen after impact: that they met is taken from where they were before",)
    if speeds[1] > SLOWED * speeds[0]:
        raise FileError(
            where, None,
            f"no impact: the face passes the place of the ball between {frames}, but the head keeps its speed"
            f" ({speeds[0]:.1f} m/s before, {speeds[1]:.1f} m/s after): a swing without a ball, or a wrong mapping",
        )  # fmt: skip
    return ("the ball is not seen after impact; the loss of the head's speed shows that they met",)


def _speed(position: Array, rate: float) -> float:
    """Return the speed over a few frames [m/s], NaN with fewer than two poses."""
    known = np.flatnonzero(np.isfinite(position[:, 0]))
    if len(known) < 2:
        return float("nan")
    return float(np.linalg.norm(position[known[-1]] - position[known[0]]) / (known[-1] - known[0]) * rate)
