"""Poses and deliveries as arrays of any library that differentiates, unchecked: what JAX and PyTorch share."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from clubface.simulation.inputs import OF_CLUB, Delivery, as_values, equipment, head_of, point_of
from clubface.simulation.pose import Head, Pose, delivery_of_pose, pose_of_delivery, repeated
from clubface.support.checks import check_names


def array_delivery(
    xp: Any,
    asarray: Callable[[Any], Any],
    pose: Pose,
    ball_position: Any,
    club: Any,
    ball: Any,
    point: Any,
    hand: Any,
    repeat: Callable[[Callable[[Any], Any], int], Any] = repeated,
) -> dict[str, Any]:
    """Return the values of a delivery by name; the parameters are those of :meth:`Delivery.from_pose`."""
    head, offset = _geometry(asarray, club, ball, point, hand)
    given = Pose(*(asarray(each) for each in pose))
    return delivery_of_pose(xp, given, asarray(ball_position), head, offset, repeat).values


def array_pose(
    xp: Any,
    asarray: Callable[[Any], Any],
    delivery: Delivery | Mapping[str, Any],
    ball_position: Any,
    club: Any,
    ball: Any,
    point: Any,
    hand: Any,
) -> Pose:
    """Return the pose of a delivery; the parameters are those of :meth:`Delivery.pose`."""
    head, offset = _geometry(asarray, club, ball, point, hand)
    given = as_values(delivery, {})
    check_names("delivery value", given, Delivery.__dataclass_fields__)
    values = {name: given.get(name, head.static_loft if name == "loft" else 0.0) for name in OF_CLUB}
    return pose_of_delivery(
        xp, {name: asarray(value) for name, value in values.items()}, asarray(ball_position), head, offset
    )


def _geometry(asarray: Callable[[Any], Any], club: Any, ball: Any, point: Any, hand: Any) -> tuple[Head, Any]:
    head = head_of(equipment(club, ball), hand)
    offset = asarray(point_of(head, point) if isinstance(point, str) else point)
    x, y, z = head.cg_to_face
    return Head((asarray(x), asarray(y), asarray(z)), *(asarray(each) for each in head[1:])), offset
