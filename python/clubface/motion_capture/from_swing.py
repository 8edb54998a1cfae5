"""Calibration from the swing itself: the blow shows where the face looks.

In the blow the head loses what momentum the ball gains. The ball flies off between the face's normal and the path, near
the normal, as the models of impact say. Loft and face angle at impact therefore follow from the direction in which the
head is slowed. The blow says nothing about the lie, which is assumed to be that of the club. This is rough, a few
degrees, but speed, attack angle, path and rates hardly depend on it.
"""

from __future__ import annotations

import numpy as np

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.errors import ClubfaceError, FileError
from clubface.motion_capture.attitude import delivered
from clubface.motion_capture.blow import Blow, find_blow, last_before
from clubface.motion_capture.geometry import Known, usual_place
from clubface.motion_capture.mapping_file import MarkerMap
from clubface.motion_capture.placement import Attitude, placed
from clubface.motion_capture.recording import Recording
from clubface.motion_capture.registration import Registration
from clubface.motion_capture.rigid_body import visible
from clubface.motion_capture.rotations import Array
from clubface.motion_capture.tracking import Track, check_seen, track
from clubface.support.warning import without_warnings

DRAWS = 800
"""Of what is not known, of which some hundred agree with a usual impact: the spread of the angles follows to 7%."""
FEWEST = 30
"""Draws that must agree with a usual impact."""
USUAL_LOFT = {"wood": units.to_si(3.0, "deg"), "hybrid": 0.0, "iron": units.to_si(-7.0, "deg")}
"""By how much more loft than the club's a golfer delivers: drivers are hit upwards, irons with the hands ahead."""
TURNED = units.to_si(8.0, "deg")
"""How far a head is turned from its static attitude when it meets the ball, about each axis."""
ROUNDS = 5
"""Of the search for the face that sends the ball where it went; each leaves a fifth of the error at most."""
STEEP = 1.3
"""Radians; steeper faces are not looked for."""
SHARE = 0.85
"""Of a turn of the face by which the ball turns: 0.75 to 0.9 in published models."""


def from_swing(mapping: MarkerMap, club: Club, ball: Ball, recording: Recording, turn: Array) -> Registration:
    """Return the cluster on the club as the blow shows it; a :class:`FileError` where none can be read.

    Parameters
    ----------
    mapping, club, ball
        Which marker is what, the club and the ball.
    recording
        The swing.
    turn
        Rotation from the laboratory to the world, mirrored for a left-hander, shape (3, 3).
    """
    where = recording.path
    followed = followed_alone(mapping, recording, turn)
    noise = mapping.noise
    if noise is None:
        noise, _ = followed.noise(np.arange(len(followed.known)) <= last_before(recording.times, followed, where))
    mean, spread = _place(mapping, club)
    cg = -mean - np.array(club.cg)
    arm = float(np.linalg.norm(np.hypot(spread, TURNED * np.linalg.norm(cg))) / np.sqrt(3.0))
    cg = delivered(club.loft, 0.0, 0.0, club.loft) @ cg
    blow = find_blow(recording.times, followed, noise=max(noise, 1e-6), arm=arm, where=where, cg=cg)
    attitude = _attitude(blow, mapping, club, ball, where)
    markers = blow.position + followed.shape @ blow.rotation.T
    found = placed(markers, attitude, mapping, club, None)
    deviations = np.sqrt(np.diag(attitude.covariance))
    told = (
        Known.of("loft and face angle at impact, from the blow and what is usual", "assumed", "deg",
                 attitude.values[:2], deviations[:2]),
        Known.of("lie at impact", "assumed", "deg", [0.0], deviations[2:]),
    )  # fmt: skip
    return found._replace(geometry=(*told, *found.geometry))


def followed_alone(mapping: MarkerMap, recording: Recording, turn: Array) -> Track:
    """Return the head through a swing as its markers alone show it, with the mean of the markers as its origin."""
    names = tuple(mapping.cluster)
    seen = recording.markers(names) @ turn.T
    check_seen(seen, names, recording.path)
    whole = np.flatnonzero(np.all(visible(seen), axis=-1))
    if not len(whole):
        counts = visible(seen).sum(0).tolist()
        hidden = ", ".join(name for name, count in zip(names, counts, strict=True) if not count)
        told = f"{hidden} never seen" if hidden else "no frame shows all of them at once"
        raise FileError(recording.path, None, f"markers of the cluster: {told}; take out of [cluster] what is not seen")
    first = seen[whole[len(whole) // 2]]
    return track(first - first.mean(0), seen, names, recording.path)


def _attitude(blow: Blow, mapping: MarkerMap, club: Club, ball: Ball, where: str) -> Attitude:
    """Return loft, face angle and lie at first touch from the direction of the blow, and their covariance."""
    from clubface.simulation.impact import impact

    random = np.random.default_rng(0)
    assumed = mapping.assumed
    mean, spread = _place(mapping, club)
    change = random.multivariate_normal(blow.later - blow.velocity, blow.covariance, DRAWS, method="eigh")
    # From the mean of the markers to the CG, in club axes.
    arm = -(mean + spread * random.normal(size=(DRAWS, 3))) - np.array(club.cg)
    toe, high = (deviation * random.normal(size=DRAWS).clip(-2.0, 2.0) for deviation in (assumed.toe, assumed.high))
    lie = assumed.delivered_lie * random.normal(size=DRAWS)
    aside = assumed.blow * random.normal(size=(2, DRAWS))
    velocity = blow.velocity
    speed = float(np.linalg.norm(velocity))
    given = {
        "speed": speed, "attack": float(np.arcsin(velocity[1] / speed)),
        "path": float(np.arctan2(velocity[2], velocity[0])), "lie": lie, "toe": toe, "high": high,
        "lie_rate": -blow.spin[0], "closure": blow.spin[1], "pitch_rate": blow.spin[2],
    }  # fmt: skip
    loft, face = np.full(DRAWS, club.loft), np.zeros(DRAWS)
    try:
        for _ in range(ROUNDS):
            turned = delivered(float(np.nanmedian(loft)), float(np.nanmedian(face)), 0.0, club.loft)
            pushed = -(change - np.cross(blow.spin, arm @ turned.T))
            launch = np.arctan2(pushed[:, 1], np.hypot(pushed[:, 0], pushed[:, 2]))
            azimuth = np.arctan2(pushed[:, 2], pushed[:, 0])
            with without_warnings():
                made = impact(
                    club.replace(hand="right"), {**given, "loft": loft, "face": face}, ball=ball, on_error="nan"
                )
            loft = (loft + (launch + aside[0] - made.launch) / SHARE).clip(-STEEP, STEEP)
            face = (face + (azimuth + aside[1] - made.azimuth) / SHARE).clip(-STEEP, STEEP)
    except ClubfaceError:
        raise FileError(where, None, _fails(club)) from None
    drawn = np.stack([loft, face, lie])
    drawn = drawn[:, np.isfinite(drawn).all(0)]
    usual = np.array([club.loft + USUAL_LOFT[club.kind], 0.0])[:, None]
    allowed = np.array([assumed.delivered_loft, assumed.delivered_face])[:, None]
    weights = np.exp(-0.5 * (((drawn[:2] - usual) / allowed) ** 2).sum(0))
    if (weights > 0.1).sum() < FEWEST:
        raise FileError(where, None, _fails(club))
    mean = np.average(drawn, axis=1, weights=weights)
    return Attitude(np.array([mean[0], mean[1], 0.0]), np.cov(drawn, aweights=weights))


def _place(mapping: MarkerMap, club: Club) -> tuple[Array, Array]:
    """Return where the mean of the markers lies from the face centre [m], and its standard deviations."""
    given = [place for place in mapping.cluster.values() if place is not None]
    if len(given) < len(mapping.cluster):
        return usual_place(club.kind, mapping.assumed)
    return np.mean(given, 0), np.full(3, mapping.position_deviation / np.sqrt(len(given)))


def _fails(club: Club) -> str:
    return (
        f"the blow drives the ball where no usual impact of {club.name} does: is this the right club, do target and up"
        ' point where they should, and do the cluster\'s positions hold? If so, give by = "address" in place of "swing"'
    )
