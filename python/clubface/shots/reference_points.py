"""Club data between the points that monitors look at and those of clubface.

Conversion of club data to the points of clubface: velocities to the CG, face angles to the face centre.

A clubhead turns as it moves, so its parts move differently: at a closure rate of 2500 deg/s the face centre of a
driver, 40 mm in front of the centre of gravity, moves 2 degrees more to the left. The face of a wood is curved: 10 mm
towards the toe it points 1.9 degrees more to the right than at its centre. Monitors measure at different points;
TrackMan's article "Club Data Definitions" says where TrackMan and cameras do.

What a monitor shows of a known delivery where it looks at other points of the head: the reverse of ``refer``.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.described import HANDS
from clubface.errors import UnknownNameError
from clubface.shots.formats import CG, CONTACT, FACE, UNKNOWN
from clubface.shots.recorded import RecordedShots
from clubface.support.arrays import Floats

CLOSE = 1e-14
"""Angle to which the face at its centre is found [rad]."""
MOST_STEPS = 60


def refer(shots: RecordedShots, club: Any) -> RecordedShots:
    """Return the shots with the motion of the club at its centre of gravity and the face angles at the face centre.

    The velocity of the centre of gravity is that of the face centre minus omega x r. Here r is the vector from the
    centre of gravity to the face centre in the delivered attitude, and omega comes from closure, pitch and lie rate. In
    this attitude the face, a torus with the club's bulge and roll, points as measured at the point of contact. A shot
    without the closure rate or the point of contact stays as measured, and a note counts such shots.

    Parameters
    ----------
    shots
        The shots, as measured.
    club
        The club (a :class:`Club`, a name or the path of a file), or a mapping from the names of clubs in the shots to
        clubs. Shots with other clubs stay as measured.

    Returns
    -------
    RecordedShots
        The shots. ``speed_at`` is "cg" and ``face_at`` is "face" if all shots were converted, and "unknown" if only
        some were. What was unknown before stays as measured.
    """
    deliveries = {name: values.copy() for name, values in shots.deliveries.items()}
    notes = list(shots.notes)
    at_face, at_cg = (np.zeros(len(shots), dtype=bool) for _ in range(2))
    for which, rows in _groups(shots, club):
        hand = _hands(shots, which)[rows]
        some = {name: values[rows] for name, values in deliveries.items()}
        if shots.face_at == CONTACT and _measured(some, "loft", "face"):
            found = _at_face_centre(some, which, hand)
            _put(deliveries, rows, found)
            some |= found
            at_face[rows] = known = _known(some, "toe", "high")
            notes.append(
                _told("dynamic loft and face angle referred to the face centre", which, known, "point of contact")
            )
        if shots.speed_at == FACE and _measured(some, "speed"):
            _put(deliveries, rows, _at_cg(some, which, hand))
            at_cg[rows] = known = _known(some, "closure")
            notes.append(_told("the club's motion referred to its centre of gravity", which, known, "closure rate"))
    return replace(
        shots,
        deliveries=deliveries,
        notes=tuple(notes),
        speed_at=_point(shots.speed_at, CG, at_cg),
        face_at=_point(shots.face_at, FACE, at_face),
    )


def _point(was: str, aim: str, referred: NDArray[np.bool_]) -> str:
    """Return where club data is taken now: unknown where only some shots were referred."""
    if not referred.any():
        return was
    return aim if referred.all() else UNKNOWN


def _groups(shots: RecordedShots, club: Any) -> list[tuple[Club, NDArray[np.intp]]]:
    if not isinstance(club, Mapping):
        return [(_club(club), np.arange(len(shots)))]
    names = shots.clubs if shots.clubs is not None else np.full(len(shots), "", dtype=object)
    for name in club:
        if name not in names:
            raise UnknownNameError("club in the file", name, dict.fromkeys(names))
    return [(_club(each), np.flatnonzero(names == name)) for name, each in club.items()]


def _club(which: Any) -> Club:
    return which if isinstance(which, Club) else club_named(which)


def _hands(shots: RecordedShots, which: Club) -> Floats:
    if shots.hand is None:
        return np.full(len(shots), float(which.hand))
    return np.array([float(HANDS[each]) for each in shots.hand])


def _put(deliveries: dict[str, Floats], rows: NDArray[np.intp], found: Mapping[str, Any]) -> None:
    for name, values in found.items():
        deliveries[name][rows] = values


def _measured(some: Mapping[str, Any], *names: str) -> bool:
    """Tell whether one of the quantities was measured in any shot."""
    return any(np.isfinite(some[name]).any() for name in names if name in some)


def _known(some: Mapping[str, Any], *names: str) -> NDArray[np.bool_]:
    """Return which shots have all of the quantities."""
    nothing = np.full(len(next(iter(some.values()))), np.nan)
    return ~np.any([np.isnan(some.get(name, nothing)) for name in names], axis=0)


def _told(what: str, which: Club, known: NDArray[np.bool_], needed: str) -> str:
    lacking = int((~known).sum())
    more = f"; {lacking} of {known.size} shots lack the {needed} and stay as measured" if lacking else ""
    return f"{what} of {which.name}{more}"


def _at_face_centre(some: Mapping[str, Any], which: Club, hand: Floats) -> dict[str, Any]:
    """Return loft and face angle at the face centre where those at the point of contact are given."""
    count = len(hand)
    toe, high = (some.get(name, np.full(count, np.nan)) for name in ("toe", "high"))
    lacking = np.isnan(toe) | np.isnan(high)
    toe, high = (np.where(lacking, 0.0, each) for each in (toe, high))
    measured_loft = _filled(some, "loft", count, which.loft)
    measured_face = hand * _filled(some, "face", count, 0.0)
    lie = _filled(some, "lie", count, 0.0)
    normal = _normal(toe, high, which)
    loft, face = measured_loft.copy(), measured_face.copy()
    for _ in range(MOST_STEPS):
        x, y, z = np.einsum("nij,nj->ni", _turned(loft, face, lie, which.loft) @ _tilted(which.loft, lie), normal).T
        step_loft = measured_loft - np.arcsin(np.clip(y, -1.0, 1.0))
        step_face = measured_face - np.arctan2(z, x)
        loft, face = loft + step_loft, face + step_face
        if max(np.abs(step_loft).max(initial=0.0), np.abs(step_face).max(initial=0.0)) < CLOSE:
            break
    found = {"loft": loft, "face": hand * face}
    return {
        name: np.where(lacking | np.isnan(some[name]), some[name], values)
        for name, values in found.items()
        if name in some
    }


def _normal(toe: Floats, high: Floats, which: Club) -> Floats:
    """Return the outward normal at points of the face in face axes: outward, up the face, to the toe; shape (n, 3).

    The roll arc is revolved about the axis parallel to the face's vertical that lies the bulge behind the face centre.
    """
    sin_up = np.clip(high / which.roll, -1.0, 1.0)
    cos_up = np.sqrt(1.0 - sin_up**2)
    if math.isinf(which.bulge):
        return np.stack([cos_up, sin_up, np.zeros_like(toe)], axis=1)
    behind = 0.0 if math.isinf(which.roll) else which.roll * (1.0 - cos_up)
    sin_out = np.clip(toe / (which.bulge - behind), -1.0, 1.0)
    cos_out = np.sqrt(1.0 - sin_out**2)
    return np.stack([cos_up * cos_out, sin_up, cos_up * sin_out], axis=1)


def _at_cg(some: Mapping[str, Any], which: Club, hand: Floats) -> dict[str, Any]:
    """Return speed, attack angle and path of the centre of gravity where those of the face centre are given."""
    count = len(hand)
    closure = some.get("closure", np.full(count, np.nan))
    attack, path = _filled(some, "attack", count, 0.0), hand * _filled(some, "path", count, 0.0)
    direction = np.stack([np.cos(attack) * np.cos(path), np.sin(attack), np.cos(attack) * np.sin(path)], axis=1)
    rates = (-_filled(some, "lie_rate", count, 0.0), closure, _filled(some, "pitch_rate", count, 0.0))
    loft, face = _filled(some, "loft", count, which.loft), hand * _filled(some, "face", count, 0.0)
    turned = _turned(loft, face, _filled(some, "lie", count, 0.0), which.loft)
    arm = turned @ _about_x(_filled(some, "lie", count, 0.0)) @ np.array([which.cg_x, which.cg_y, which.cg_z])
    velocity = some["speed"][:, None] * direction - np.cross(np.stack(rates, axis=1), arm)
    speed = np.linalg.norm(velocity, axis=1)
    found = {
        "speed": speed,
        "attack": np.arcsin(np.clip(velocity[:, 1] / speed, -1.0, 1.0)),
        "path": hand * np.arctan2(velocity[:, 2], velocity[:, 0]),
    }
    known = ~np.isnan(closure)
    return {
        name: np.where(known & ~np.isnan(some[name]), values, some[name])
        for name, values in found.items()
        if name in some
    }


def _filled(some: Mapping[str, Any], name: str, count: int, default: float) -> Floats:
    values = some.get(name, np.full(count, np.nan))
    return np.where(np.isnan(values), default, values)


def _about_x(lie: Floats) -> Floats:
    """Return the rotation of the reference pose by the lie, toe up; shape (n, 3, 3)."""
    zero, one = np.zeros_like(lie), np.ones_like(lie)
    rows = [[one, zero, zero], [zero, np.cos(lie), np.sin(lie)], [zero, -np.sin(lie), np.cos(lie)]]
    return np.moveaxis(np.array(rows), -1, 0)


def _about_y(angle: Floats) -> Floats:
    """Return the rotation that turns x towards z, to the right; shape (n, 3, 3)."""
    zero, one = np.zeros_like(angle), np.ones_like(angle)
    rows = [[np.cos(angle), zero, -np.sin(angle)], [zero, one, zero], [np.sin(angle), zero, np.cos(angle)]]
    return np.moveaxis(np.array(rows), -1, 0)


def _about_z(angle: Floats) -> Floats:
    """Return the rotation that turns x towards y, up; shape (n, 3, 3)."""
    zero, one = np.zeros_like(angle), np.ones_like(angle)
    rows = [[np.cos(angle), -np.sin(angle), zero], [np.sin(angle), np.cos(angle), zero], [zero, zero, one]]
    return np.moveaxis(np.array(rows), -1, 0)


def _tilted(static_loft: float, lie: Floats) -> Floats:
    """Return the rotation from face axes to the reference pose tilted by the lie; shape (n, 3, 3)."""
    return _about_x(lie) @ _about_z(np.full_like(lie, static_loft))


def _turned(loft: Floats, face: Floats, lie: Floats, static_loft: float) -> Floats:
    """Return the rotation from the tilted reference pose to the delivered attitude; shape (n, 3, 3).

    The face normal is turned back to azimuth 0, about z until its elevation is the loft, and right by the face angle.
    """
    x, y, z = _tilted(static_loft, lie)[:, :, 0].T
    return _about_y(face) @ _about_z(loft - np.arctan2(y, np.hypot(x, z))) @ _about_y(-np.arctan2(z, x))


MOTION = ("speed", "attack", "path")
ATTITUDE = ("loft", "face")


def as_seen(deliveries: Mapping[str, Floats], which: Club, *, speed_at: str, face_at: str) -> dict[str, Floats]:
    """Return the deliveries as a monitor shows them that measures at other points of the head.

    Parameters
    ----------
    deliveries
        Deliveries by quantity, SI, of which ``speed`` is one: motion of the centre of gravity, attitude at the face
        centre. What is left out is zero, and the loft that of the club.
    which
        The club.
    speed_at
        Where speed, attack and path are measured: "face" for the face centre; elsewhere they stay.
    face_at
        Where loft and face angle are measured: "contact" for the point of contact; elsewhere they stay.
    """
    found = dict(deliveries)
    count, hand = len(found["speed"]), float(which.hand)
    loft, face = _filled(found, "loft", count, which.loft), hand * _filled(found, "face", count, 0.0)
    lie = _filled(found, "lie", count, 0.0)
    if speed_at != FACE and face_at != CONTACT:
        return found
    turned = _turned(loft, face, lie, which.loft)
    if speed_at == FACE:
        attack, path = _filled(found, "attack", count, 0.0), hand * _filled(found, "path", count, 0.0)
        direction = np.stack([np.cos(attack) * np.cos(path), np.sin(attack), np.cos(attack) * np.sin(path)], axis=1)
        rates = [_filled(found, name, count, 0.0) for name in ("lie_rate", "closure", "pitch_rate")]
        omega = np.stack([-rates[0], rates[1], rates[2]], axis=1)
        arm = turned @ _about_x(lie) @ np.array([which.cg_x, which.cg_y, which.cg_z])
        velocity = found["speed"][:, None] * direction + np.cross(omega, arm)
        speed = np.linalg.norm(velocity, axis=1)
        found["speed"] = speed
        found["attack"] = np.arcsin(np.clip(velocity[:, 1] / speed, -1.0, 1.0))
        found["path"] = hand * np.arctan2(velocity[:, 2], velocity[:, 0])
    if face_at == CONTACT:
        normal = _normal(_filled(found, "toe", count, 0.0), _filled(found, "high", count, 0.0), which)
        x, y, z = np.einsum("nij,nj->ni", turned @ _tilted(which.loft, lie), normal).T
        found["loft"] = np.arcsin(np.clip(y, -1.0, 1.0))
        found["face"] = hand * np.arctan2(z, x)
    return found
