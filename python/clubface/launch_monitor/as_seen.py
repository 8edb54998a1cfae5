"""What a monitor shows of a known delivery where it looks at other points of the head: the reverse of ``refer``."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from clubface.equipment.clubs import Club
from clubface.launch_monitor.formats import CONTACT, FACE
from clubface.launch_monitor.reference_points import _about_x, _filled, _normal, _tilted, _turned
from clubface.support.arrays import Floats

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
