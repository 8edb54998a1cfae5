"""Where and when the clubhead meets the ball, from the ball if seen or given, or from the head's loss of speed."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from clubface.capture.ball_flight import RestingBall, resting_places
from clubface.capture.calibration import Registration
from clubface.capture.geometry import Known, off_face
from clubface.capture.impact_detection import FEWEST, End, detect_impact, impact_at_end, last_before
from clubface.capture.impact_frame import Approach, Extrapolation, find_impact, follow, follow_until
from clubface.capture.recording import Recording
from clubface.capture.reduction import Evidence, series
from clubface.capture.rotations import Array, exponential, mirror, visible
from clubface.capture.setup import Setup
from clubface.capture.tracking import Track
from clubface.errors import FileError
from clubface.results.notes import Note, note

FLOOR = 1e-6
"""Minimum noise of a marker [m], above single-precision rounding in files."""
CG_DEVIATION = 3e-3
"""Standard deviation of the CG given in a club's file [m]."""
SURE = 5e-3
"""Standard deviation up to which a given ball position determines the instant of impact [m]; it is then as accurate as
the loss of speed, 0.1 ms in a drive."""
ANYWHERE = 1.0
"""Standard deviation of an unknown ball position [m]."""
SURPRISING = 2.5
"""Standard deviations above which a warning says that the head is slowed elsewhere than at the given ball."""


class Meeting(NamedTuple):
    """Meeting of clubhead and ball."""

    approach: Approach
    ball: RestingBall
    ball_covariance: Array  # of its centre, shape (3, 3)
    seen_ball: Array  # its centre in every frame, shape (frames, 3); NaN where not seen
    evidence: Evidence | None  # impact detected in the head's path, if used
    noise: float  # of a marker along an axis [m]
    noise_freedom: int  # degrees of freedom of its estimate; 0 if given
    notes: tuple[Note, ...]  # uncertainties of the meeting
    geometry: tuple[Known, ...]  # how the ball's position is known


def meet(recording: Recording, followed: Track, cluster: Registration, setup: Setup, turn: Array) -> Meeting:
    """Find where and when the head, ``followed`` through a recording, meets the ball.

    If the ball is seen, or given to within ``SURE``, the impact is where the face passes it. If it is given less
    accurately or not at all, the impact is where the head loses speed; a contradiction to a given position enters with
    the standard deviations of both. ``turn`` is the rotation from laboratory to world axes, mirrored for a left-hander,
    shape (3, 3).
    """
    mapping = setup.mapping
    if mapping.ball is None and (mapping.ball_position is None or mapping.ball_deviation > SURE):
        try:
            return _meet_by_impact(recording, followed, cluster, setup, turn)
        except FileError as error:
            if mapping.ball_position is None:
                end = impact_at_end(recording.times, followed)
                if end is None:
                    raise
                return _meet_at_end(recording, followed, setup, end)
            met = _meet_by_ball(recording, followed, setup, turn)
            return met._replace(notes=(*met.notes, note("capture-ball-place-alone", reason=error.message)))
    return _meet_by_ball(recording, followed, setup, turn)


def _meet_by_ball(recording: Recording, followed: Track, setup: Setup, turn: Array) -> Meeting:
    where, head, radius, mapping = recording.path, setup.club, setup.ball.radius, setup.mapping
    seen, places = _ball(recording, setup, turn)
    interval, ball = find_impact(recording, followed.poses, seen, places, head, radius)
    noise, freedom = _noise(followed, interval.before, setup, where)
    how = Extrapolation(noise, setup.estimator, setup.roughness, where)
    approach = follow(recording.times, followed, interval, ball.centre, head, radius, how)
    if mapping.ball is not None:
        noise_of_ball = ball.noise if mapping.noise is None else mapping.noise
        way, deviation = "measured", max(noise_of_ball, FLOOR) / np.sqrt(max(ball.frames, 1))
    else:
        way, deviation = "given", max(mapping.ball_deviation, FLOOR)
    parts = Known("centre of the ball", way, "toe", deviations=[deviation])
    return Meeting(approach, ball, np.eye(3) * deviation**2, seen, None, noise, freedom, interval.notes, (parts,))


def _meet_by_impact(recording: Recording, followed: Track, cluster: Registration, setup: Setup, turn: Array) -> Meeting:
    where, mapping, times = recording.path, setup.mapping, recording.times
    noise, freedom = _noise(followed, last_before(times, followed, where), setup, where)
    arm = max(float(np.sqrt(np.max(np.linalg.eigvalsh(cluster.covariance[:3, :3])))), CG_DEVIATION)
    how = Extrapolation(noise, setup.estimator, setup.roughness, where)
    detected = detect_impact(times, followed, how, arm=arm)
    approach = follow_until(times, followed, detected.touch, how)
    if mapping.ball_position is None:
        centre, deviation = _ball_at_face_centre(approach, setup), ANYWHERE
        parts = [Known("ball", "assumed: where the clubhead loses speed")]
    else:
        centre, deviation = turn @ np.array(mapping.ball_position), mapping.ball_deviation
        parts = [Known("centre of the ball", "given", "toe", deviations=[deviation])]
    parts.append(
        Known("instant of first touch, by loss of speed", "measured", "contact_time", deviations=[detected.deviation])
    )
    notes = [note("capture-impact", lost=detected.lost)]
    if detected.again is not None:
        notes.append(note("capture-impact-again", frame=detected.before + 1, again=detected.again + 1))
    return _meeting_at(approach, centre, deviation, detected.deviation, (noise, freedom), setup, times, notes, parts)


def _meet_at_end(recording: Recording, followed: Track, setup: Setup, end: End) -> Meeting:
    """Return the meeting in a recording that ends with the impact."""
    where, times = recording.path, recording.times
    noise, freedom = _noise(followed, end.before - 1, setup, where)
    kept = followed._replace(poses=followed.poses._replace(position=followed.poses.position.copy()))
    kept.poses.position[end.before + 1 :] = np.nan
    approach = follow_until(times, kept, end.touch, Extrapolation(noise, setup.estimator, setup.roughness, where))
    instant = "instant of first touch, from the end of the recording"
    parts = [
        Known("ball", "assumed: where the recording ends"),
        Known(instant, "assumed", "contact_time", deviations=[end.deviation]),
    ]
    code = "capture-ends-after-impact" if end.later else "capture-ends-with-impact"
    remark = note(code, later=end.later, frame=end.before + recording.first_frame, fewest=FEWEST)
    centre = _ball_at_face_centre(approach, setup)
    return _meeting_at(approach, centre, ANYWHERE, end.deviation, (noise, freedom), setup, times, [remark], parts)


def _meeting_at(
    approach: Approach, centre: Array, deviation: float, instant: float, noise: tuple[float, int], setup: Setup,
    times: Array, notes: list[Note], parts: list[Known],
) -> Meeting:  # fmt: skip
    """Return the meeting for standard deviations ``instant`` of first touch [s] and ``deviation`` of the ball [m]."""
    assumed = setup.mapping.assumed
    point = "impact point from the face centre, towards the toe and high"
    parts.append(Known(point, "assumed", "toe", [0.0, 0.0], [assumed.toe, assumed.high]))
    evidence = Evidence(np.zeros(3), np.array([instant, assumed.toe, assumed.high]))
    nowhere, ball = _unseen_ball(centre, deviation, len(times))
    return Meeting(approach, ball, np.eye(3) * deviation**2, nowhere, evidence, *noise, tuple(notes), tuple(parts))


def _unseen_ball(centre: Array, deviation: float, frames: int) -> tuple[Array, RestingBall]:
    """Return the centres, NaN, of a ball that no frame shows, and the ball at rest at ``centre`` in all of them."""
    return np.full((frames, 3), np.nan), RestingBall(centre, deviation, 1, (0, frames - 1), None)


def _ball_at_face_centre(approach: Approach, setup: Setup) -> Array:
    """Return the centre of a ball that touches the face centre at the instant of impact [m]."""
    head, values = setup.club, series(approach.path.position, np.zeros(()))
    attitude = exponential(values[3:]) @ approach.attitude
    return values[:3] + attitude @ (np.array(head.cg) + off_face(head, 0.0, 0.0, setup.ball.radius))


def _ball(recording: Recording, setup: Setup, turn: Array) -> tuple[Array, list[RestingBall]]:
    """Return the ball's centre in every frame and its resting places, in world axes for a right-hander."""
    mapping = setup.mapping
    if mapping.ball is None:
        place = turn @ np.array(mapping.ball_position)
        nowhere, ball = _unseen_ball(place, mapping.ball_deviation, len(recording.positions))
        return nowhere, [ball]
    offset = np.array(mapping.ball_offset) * mirror(setup.club.hand)
    seen = recording.marker(mapping.ball) @ turn.T + offset
    result = resting_places(seen, recording.rate)
    if not result:
        lost = "seen at rest" if visible(seen).any() else "seen"
        raise recording.error(
            f"the ball's marker {mapping.ball} is never {lost}; give its position under [ball], or leave the table out"
        )
    return seen, result


def _noise(followed: Track, last: int, setup: Setup, where: str) -> tuple[float, int]:
    """Return the noise of a marker along an axis [m] and the degrees of freedom of its estimate."""
    if setup.mapping.noise is not None:
        return max(setup.mapping.noise, FLOOR), 0
    noise, freedom = followed.noise(np.arange(len(followed.known)) <= last)
    if freedom <= 0:
        raise FileError(where, None, "no frame before impact shows the clubhead's pose")
    return max(noise, FLOOR), freedom
