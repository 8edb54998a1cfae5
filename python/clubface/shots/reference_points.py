"""Conversion of club data between monitors' reference points and clubface's: the CG and the face centre.

A clubhead rotates, so its points move differently: at a closure rate of 2500 deg/s a driver's face centre, 40 mm in
front of the centre of gravity, moves 2 degrees farther left. The face of a wood is curved: 10 mm towards the toe it
points 1.9 degrees farther right than at the centre. Monitors measure at different points; TrackMan's article "Club Data
Definitions" explains where TrackMan and cameras do.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.described import HANDS
from clubface.errors import UnknownNameError
from clubface.results.notes import Note, note
from clubface.shots.formats import CG, CONTACT, FACE, UNKNOWN
from clubface.shots.recorded import RecordedShots
from clubface.support.arrays import Floats

CLOSE = 1e-14
"""Convergence tolerance of the face angles at the centre [rad]."""
MOST_STEPS = 60


ClubByName = str | os.PathLike[str] | Club | Mapping[str, str | os.PathLike[str] | Club]
"""A club, its name or its file; or a mapping from club names in the shots to clubs."""


def refer(shots: RecordedShots, club: ClubByName) -> RecordedShots:
    """Return the shots with club motion at the centre of gravity and face angles at the face centre.

    The velocity of the centre of gravity is the velocity of the face centre minus omega x r, where r is the vector from
    the centre of gravity to the face centre in the delivered attitude, and omega follows from closure, pitch and lie
    rate. The attitude is such that the face, a torus with the club's bulge and roll, points as measured at the impact
    point. Shots without closure rate or impact point stay as measured; a note counts them.

    ``club`` is a :class:`Club`, a name or a path, or a mapping from club names in the shots to clubs; shots with other
    clubs stay as measured, as do data from unknown points. ``speed_at`` of the result is "cg" and ``face_at`` is "face"
    if all shots were converted, "unknown" if only some were.
    """
    deliveries = {name: values.copy() for name, values in shots.deliveries.items()}
    notes: list[Note] = []
    at_face, at_cg = (np.zeros(len(shots), dtype=bool) for _ in range(2))
    groups: list[tuple[Any, NDArray[np.intp]]] = [(club, np.arange(len(shots)))]
    if isinstance(club, Mapping):
        names = shots.clubs if shots.clubs is not None else np.full(len(shots), "", dtype=object)
        if unknown := [name for name in club if name not in names]:
            raise UnknownNameError("club in the file", unknown[0], dict.fromkeys(names))
        groups = [(each, np.flatnonzero(names == name)) for name, each in club.items()]
    for given, rows in groups:
        head = given if isinstance(given, Club) else club_named(given)
        hand = np.full(len(rows), float(head.hand))
        if shots.hand is not None:
            hand = np.array([float(HANDS[each]) for each in shots.hand[rows]])
        some = {name: values[rows] for name, values in deliveries.items()}
        for code, is_there, refer_these, referred, needed in (
            ("contact-face", shots.face_at == CONTACT and _measured(some, "loft", "face"), _at_face_centre, at_face,
             ("toe", "high")),
            ("motion", shots.speed_at == FACE and _measured(some, "speed"), _at_cg, at_cg, ("closure",)),
        ):  # fmt: skip
            if is_there:
                some |= refer_these(some, head, hand)
                referred[rows] = known = _known(some, *needed)
                notes.append(note(f"referred-{code}", club=head.name, referred=int(known.sum()), shots=known.size))
                if not known.all():
                    notes.append(note(f"not-referred-{code}", lacking=int((~known).sum()), shots=known.size))
        for name, values in some.items():
            deliveries[name][rows] = values
    speed_at, face_at = (
        was if not referred.any() else aim if referred.all() else UNKNOWN
        for was, aim, referred in ((shots.speed_at, CG, at_cg), (shots.face_at, FACE, at_face))
    )
    notes = [*shots.notes, *notes]
    return replace(shots, deliveries=deliveries, notes=tuple(notes), speed_at=speed_at, face_at=face_at)


def _measured(some: Mapping[str, Any], *names: str) -> bool:
    """Return whether any of the quantities was measured in any shot."""
    return any(np.isfinite(some[name]).any() for name in names if name in some)


def _known(some: Mapping[str, Any], *names: str) -> NDArray[np.bool_]:
    """Return which shots have all of these quantities."""
    nothing = np.full(len(next(iter(some.values()))), np.nan)
    return ~np.any([np.isnan(some.get(name, nothing)) for name in names], axis=0)


def _at_face_centre(some: Mapping[str, Any], head: Club, hand: Floats) -> dict[str, Any]:
    """Return loft and face angle at the face centre from those at the impact point."""
    count = len(hand)
    toe, high = (some.get(name, np.full(count, np.nan)) for name in ("toe", "high"))
    lacking = np.isnan(toe) | np.isnan(high)
    toe, high = (np.where(lacking, 0.0, each) for each in (toe, high))
    measured_loft = _with_default(some, "loft", count, head.loft)
    measured_face = hand * _with_default(some, "face", count, 0.0)
    lie = _with_default(some, "lie", count, 0.0)
    normal = _normal(toe, high, head)
    loft, face = measured_loft.copy(), measured_face.copy()
    for _ in range(MOST_STEPS):
        seen_loft, seen_face = _attitude_at(normal, loft, face, lie, head)
        step_loft, step_face = measured_loft - seen_loft, measured_face - seen_face
        loft, face = loft + step_loft, face + step_face
        if max(np.abs(step_loft).max(initial=0.0), np.abs(step_face).max(initial=0.0)) < CLOSE:
            break
    referred = {"loft": loft, "face": hand * face}
    return {
        name: np.where(lacking | np.isnan(some[name]), some[name], values)
        for name, values in referred.items()
        if name in some
    }


def _attitude_at(normal: Floats, loft: Floats, face: Floats, lie: Floats, head: Club) -> tuple[Floats, Floats]:
    """Return loft and face angle for a face normal, given those at the face centre."""
    turned = _attitude_rotation(loft, face, lie, head.loft) @ _tilt_rotation(head.loft, lie)
    x, y, z = np.einsum("nij,nj->ni", turned, normal).T
    return np.arcsin(np.clip(y, -1.0, 1.0)), np.arctan2(z, x)


def _normal(toe: Floats, high: Floats, head: Club) -> Floats:
    """Return the outward normal at points of the face in face axes: outward, up the face, to the toe; shape (n, 3).

    The roll arc is revolved about the axis parallel to the face's vertical that lies the bulge behind the face centre.
    """
    sin_up = np.clip(high / head.roll, -1.0, 1.0)
    cos_up = np.sqrt(1.0 - sin_up**2)
    if math.isinf(head.bulge):
        return np.stack([cos_up, sin_up, np.zeros_like(toe)], axis=1)
    behind = 0.0 if math.isinf(head.roll) else head.roll * (1.0 - cos_up)
    sin_out = np.clip(toe / (head.bulge - behind), -1.0, 1.0)
    cos_out = np.sqrt(1.0 - sin_out**2)
    return np.stack([cos_up * cos_out, sin_up, cos_up * sin_out], axis=1)


def _at_cg(some: Mapping[str, Any], head: Club, hand: Floats) -> dict[str, Any]:
    """Return speed, attack angle and path of the centre of gravity from those of the face centre."""
    known = _known(some, "closure")
    return {
        name: np.where(known & ~np.isnan(some[name]), values, some[name])
        for name, values in _shift_motion(some, head, hand, -1.0).items()
        if name in some
    }


def _shift_motion(some: Mapping[str, Any], head: Club, hand: Floats | float, sign: float) -> dict[str, Any]:
    """Return speed, attack angle and path of the face centre from those of the CG (``sign`` 1), or back (-1)."""
    count = len(some["speed"])
    attack, path, lie, face = (_with_default(some, name, count, 0.0) for name in ("attack", "path", "lie", "face"))
    path, face = hand * path, hand * face
    direction = np.stack([np.cos(attack) * np.cos(path), np.sin(attack), np.cos(attack) * np.sin(path)], axis=1)
    rates = [_with_default(some, each, count, 0.0) for each in ("lie_rate", "closure", "pitch_rate")]
    turned = _attitude_rotation(_with_default(some, "loft", count, head.loft), face, lie, head.loft)
    arm = turned @ _rotation("zy", lie) @ np.array([head.cg_x, head.cg_y, head.cg_z])
    omega = np.stack(rates, axis=1) * [-1.0, 1.0, 1.0]
    velocity = some["speed"][:, None] * direction + sign * np.cross(omega, arm)
    speed = np.linalg.norm(velocity, axis=1)
    return {
        "speed": speed,
        "attack": np.arcsin(np.clip(velocity[:, 1] / speed, -1.0, 1.0)),
        "path": hand * np.arctan2(velocity[:, 2], velocity[:, 0]),
    }


def _with_default(some: Mapping[str, Any], name: str, count: int, default: float) -> Floats:
    values = some.get(name, np.full(count, np.nan))
    return np.where(np.isnan(values), default, values)


def _rotation(axes: str, angle: Floats) -> Floats:
    """Return the rotation that turns the first of two axes, such as "xz", towards the second; shape (n, 3, 3)."""
    first, second = map("xyz".index, axes)
    turned = np.broadcast_to(np.eye(3), (len(angle), 3, 3)).copy()
    turned[:, first, first] = turned[:, second, second] = np.cos(angle)
    turned[:, second, first] = np.sin(angle)
    turned[:, first, second] = -np.sin(angle)
    return turned


def _tilt_rotation(static_loft: float, lie: Floats) -> Floats:
    """Return the rotation from face axes to the reference pose tilted by the lie; shape (n, 3, 3)."""
    return _rotation("zy", lie) @ _rotation("xy", np.full_like(lie, static_loft))


def _attitude_rotation(loft: Floats, face: Floats, lie: Floats, static_loft: float) -> Floats:
    """Return the rotation from the tilted reference pose to the delivered attitude; shape (n, 3, 3).

    The face normal is turned back to azimuth 0, about z until its elevation is the loft, and right by the face angle.
    """
    x, y, z = _tilt_rotation(static_loft, lie)[:, :, 0].T
    upright = _rotation("xy", loft - np.arctan2(y, np.hypot(x, z)))
    return _rotation("xz", face) @ upright @ _rotation("xz", -np.arctan2(z, x))


MOTION = ("speed", "attack", "path")
ATTITUDE = ("loft", "face")


def as_seen(deliveries: Mapping[str, Floats], head: Club, *, speed_at: str, face_at: str) -> dict[str, Floats]:
    """Return deliveries as reported by a monitor that measures at other points of the head.

    ``deliveries`` holds SI values by quantity, including ``speed``: motion of the centre of gravity and attitude at the
    face centre. Missing values are zero, a missing loft is the club's. If ``speed_at`` is "face", speed, attack and
    path are converted to the face centre; if ``face_at`` is "contact", loft and face angle to the impact point.
    """
    seen, hand = dict(deliveries), float(head.hand)
    if speed_at == FACE:
        seen |= _shift_motion(deliveries, head, hand, 1.0)
    if face_at == CONTACT:
        count = len(seen["speed"])
        toe, high, lie, face = (_with_default(deliveries, name, count, 0.0) for name in ("toe", "high", "lie", "face"))
        loft = _with_default(deliveries, "loft", count, head.loft)
        seen["loft"], seen_face = _attitude_at(_normal(toe, high, head), loft, hand * face, lie, head)
        seen["face"] = hand * seen_face
    return seen
