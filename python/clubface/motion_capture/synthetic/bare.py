"""Recordings as most archives hold them: three markers on the head, no ball, the address and the swing in one file.

What nobody measures is drawn at random, as widely as a reader has to assume it: how square the face is at address, how
the shaft leans there, where the markers sit on the head.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from clubface.equipment.clubs import Club
from clubface.motion_capture.attitude import delivered
from clubface.motion_capture.geometry import Assumed, usual_place
from clubface.motion_capture.laboratory import axis
from clubface.motion_capture.mapping_file import MarkerMap
from clubface.motion_capture.markers import Point
from clubface.motion_capture.recording import Recording
from clubface.motion_capture.rotations import Array, exponential, logarithm
from clubface.motion_capture.synthetic.laboratory import CLUSTERS, Cameras, kind_of
from clubface.motion_capture.synthetic.synthetic_swing import SyntheticSwing

MARKERS: Mapping[str, tuple[str, ...]] = {"wood": ("HEAD1", "HEAD3", "HEAD4"), "iron": ("HEAD1", "HEAD2", "HEAD3")}
"""Three of the usual markers that make a triangle of unequal sides."""
REST, BACKSWING = 0.6, 0.9
"""Seconds at address and of the way from there to where a synthetic swing begins, behind the player."""
TOP = 0.8
"""Metres by which that way rises over the straight line."""
GAP = (0.015, 0.005)
"""Metres between face and ball at address, mean and standard deviation."""
ASIDE = 0.008
"""Metres; standard deviation of where on the face the ball is addressed."""
FARTHEST = 2.0
"""Standard deviations to which impact points are cut, so that every impact is on the face."""


@dataclass(frozen=True, kw_only=True, eq=False)
class BareSwing:
    """One such recording and what its reader does not know.

    Attributes
    ----------
    recording
        Three markers of the head, from address to follow-through.
    cluster
        Where they sit: from the face centre [m], club axes.
    angles
        Loft, face angle and lie at address [rad], as for a right-hander.
    first
        Time of the first frame [s], if first touch is at zero.
    """

    recording: Recording
    cluster: Mapping[str, Point]
    angles: Array
    first: float


def record_bare(
    swing: SyntheticSwing,
    cameras: Cameras,
    seed: int | np.random.Generator,
    *,
    assumed: Assumed | None = None,
) -> BareSwing:
    """Record a swing with its address by three markers on the head.

    Parameters
    ----------
    swing
        The swing.
    cameras
        Their rate, noise, axes and gaps.
    seed
        The same seed gives the same recording.
    assumed
        How widely what is not measured is drawn.
    """
    random, spread = np.random.default_rng(seed), assumed or Assumed()
    cluster = _cluster(swing.club, random, spread)
    loft, face, lie = np.array([swing.club.loft, 0.0, 0.0]) + random.normal(size=3) * [
        spread.loft, spread.face, spread.lie,
    ]  # fmt: skip
    first = -np.ceil(cameras.before * cameras.rate) - random.uniform()
    early = int((REST + BACKSWING) * cameras.rate)
    times = (first - early + np.arange(early + int((cameras.before + cameras.after) * cameras.rate) + 2)) / cameras.rate
    position, attitude = swing.head(times)
    begin = first / cameras.rate
    cg, held = _address(swing, np.array([loft, face, lie]), random, spread)
    part = np.clip((times[:early] - begin) / BACKSWING + 1.0, 0.0, 1.0)
    part = part**3 * (10.0 - 15.0 * part + 6.0 * part**2)
    whole, turned = swing.head(np.array([begin]))
    position[:early] = cg + part[:, None] * (whole[0] - cg) + np.outer(4.0 * TOP * part * (1.0 - part), [0.0, 1.0, 0.0])
    attitude[:early] = exponential(part[:, None] * logarithm(turned[0] @ held.T)) @ held
    local = np.array(list(cluster.values())) + np.array(swing.club.cg)
    seen = (position[:, None] + np.einsum("kij,mj->kmi", attitude, local)) * swing.mirror
    recording = Recording(
        labels=tuple(cluster), positions=cameras.measured(seen, random), rate=cameras.rate, path="<synthetic>"
    )
    return BareSwing(recording=recording, cluster=cluster, angles=np.array([loft, face, lie]), first=float(times[0]))


def asked_at_random(seed: int | np.random.Generator) -> dict[str, float]:
    """Return face angle, lie and impact point of a swing, as widely scattered as a reader has to assume [SI]."""
    random, spread = np.random.default_rng(seed), Assumed()
    deviations = {
        "face": spread.delivered_face, "lie": spread.delivered_lie, "toe": spread.toe, "high": spread.high,
    }  # fmt: skip
    return {
        name: deviation * float(np.clip(random.normal(), -FARTHEST, FARTHEST)) for name, deviation in deviations.items()
    }


def bare_map(
    club: Club, cameras: Cameras, by: str = "address", cluster: Mapping[str, Point] | None = None
) -> MarkerMap:
    """Return the mapping with which such recordings are read.

    Parameters
    ----------
    club, cameras
        The club, and the laboratory.
    by
        "address" or "swing".
    cluster
        Positions of the markers, where a reader has measured them; none unless given.
    """
    names = MARKERS[kind_of(club)]
    return MarkerMap(
        cluster=cluster or dict.fromkeys(names),
        by=by,
        ground=float(axis(cameras.up) @ np.array(cameras.origin)) if by == "address" else None,
        target=cameras.target, up=cameras.up, club=club.name,
    )  # fmt: skip


def _cluster(club: Club, random: np.random.Generator, assumed: Assumed) -> dict[str, Point]:
    """Return three markers about a place as far from the usual one as a reader has to allow for."""
    kind = kind_of(club)
    names, usual = MARKERS[kind], [CLUSTERS[kind][name] for name in MARKERS[kind]]
    mean, spread = usual_place(club.kind, assumed)
    places = np.array(usual) - np.mean(usual, 0) + mean + spread * random.normal(size=3)
    return {name: (float(x), float(y), float(z)) for name, (x, y, z) in zip(names, places, strict=True)}


def _address(
    swing: SyntheticSwing, angles: Array, random: np.random.Generator, assumed: Assumed
) -> tuple[Array, Array]:
    """Return CG and attitude of the head at rest behind the ball, as for a right-hander."""
    club = swing.club
    attitude = delivered(angles[0], angles[1], angles[2], club.loft)
    height = 0.5 * club.face_height * np.cos(club.loft) + assumed.sole * random.normal()
    back = swing.ball.radius + abs(GAP[0] + GAP[1] * random.normal())
    centre = np.array([swing.rest[0] - back, height, swing.rest[2] + ASIDE * random.normal()])
    return centre - attitude @ np.array(club.cg), attitude
