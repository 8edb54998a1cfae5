"""Conversion of the pose and motion of a clubhead to the values of a delivery, and back, in closed form.

A multibody program describes a head by a rotation, the position of one of its points, a velocity and an angular
velocity. A delivery is the same in golf terms. Both conversions are written in components, with four functions of an
array library (``sin``, ``cos``, ``sqrt``, ``arctan``) and ``stack``, which NumPy, JAX and PyTorch all have; they accept
complex numbers (for complex-step derivatives) and broadcast.

Head axes coincide with world axes while the club stands at its static loft with a square face: x to the target, y up, z
to the right. The mass properties of a club are given in head axes. A left-handed head is the mirror image in z of the
right-handed head with the same numbers; it is mirrored, computed as right-handed and mirrored back.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

Vector = tuple[Any, Any, Any]
Matrix = tuple[Vector, Vector, Vector]
"""Three rows."""

ROUNDS = 6
"""Newton iterations to first touch: the gap is almost linear in time, and from a millisecond away four suffice."""


class Head(NamedTuple):
    """Geometry of club and ball that determines first touch."""

    cg_to_face: Vector  # in the axes of the right-handed head [m]
    static_loft: Any  # [rad]
    bulge: Any  # radius of the face [m], infinite if it is flat
    roll: Any
    ball_radius: Any  # [m]
    hand: Any  # 1 for a right-handed head, -1 for a left-handed one


class Pose(NamedTuple):
    """Pose and motion of a head in world axes: x to the target, y up, z to the right of the target line.

    Attributes
    ----------
    rotation
        Rotation from head axes to world axes, shape (..., 3, 3); the identity while the club stands at its static loft
        with a square face.
    position, velocity
        Position [m] and velocity [m/s] of a point of the head, shape (..., 3).
    angular_velocity
        Angular velocity of the head [rad/s], shape (..., 3).
    """

    rotation: Any
    position: Any
    velocity: Any
    angular_velocity: Any


class Touch(NamedTuple):
    """Values of a delivery by name [SI], and the time of first touch, relative to the pose [s]."""

    values: dict[str, Any]
    time: Any


def repeated(step: Callable[[Any], Any], count: int) -> Any:
    """Apply a step ``count`` times, starting from 0."""
    result = 0.0
    for _ in range(count):
        result = step(result)
    return result


def delivery_of_pose(
    xp: Any,
    pose: Pose,
    ball_position: Any,
    head: Head,
    point: Any,
    repeat: Callable[[Callable[[Any], Any], int], Any] = repeated,
) -> Touch:
    """Return the delivery of a head that moves on with constant velocities to first touch.

    ``xp`` is the array library; ``repeat`` replaces :func:`repeated` for a library that compiles loops. The rotation of
    the pose may be a quaternion of any length, shape (..., 4), real part first. ``ball_position`` is the centre of the
    ball at rest [m]; ``point`` is the point of the head to which the pose refers, from the CG in head axes [m].
    """
    hand = head.hand
    turn = _mirror_matrix(rotation_rows(pose.rotation), hand)
    velocity = _mirror(_components(pose.velocity), hand)
    spin = _mirror_spin(_components(pose.angular_velocity), hand)
    lever = _apply(turn, _mirror(_components(point), hand))
    velocity = _minus(velocity, _cross(spin, lever))
    away = _mirror(_minus(_components(ball_position), _components(pose.position)), hand)
    away = _plus(away, lever)

    def nearer(time: Any) -> Any:
        turned, apart = _product(rotation_by(spin, time), turn), _along(away, velocity, -time)
        gap, normal = _nearest(xp, _ball_in_face(xp, turned, apart, head), head)
        approach = _apply_transposed(turned, _plus(velocity, _cross(spin, apart)))
        return time + (gap - head.ball_radius) / _dot(normal, _to_face(xp, approach, head))

    time = repeat(nearer, ROUNDS)
    turned = _product(rotation_by(spin, time), turn)
    ball = _ball_in_face(xp, turned, _along(away, velocity, -time), head)
    gap, normal = _nearest(xp, ball, head)
    sin_loft, cos_loft = xp.sin(head.static_loft), xp.cos(head.static_loft)
    facing = _apply(turned, (cos_loft, sin_loft, 0.0))
    face = xp.arctan(facing[2] / facing[0])
    sideways = (-xp.sin(face), 0.0, xp.cos(face))
    up, right = _column(turned, 1), _column(turned, 2)
    values = {
        "speed": xp.sqrt(_dot(velocity, velocity)),
        "attack": xp.arctan(velocity[1] / _level(xp, velocity)),
        "path": hand * xp.arctan(velocity[2] / velocity[0]),
        "loft": xp.arctan(facing[1] / _level(xp, facing)),
        "face": hand * face,
        "lie": xp.arctan(-_dot(sideways, up) / _dot(sideways, right)),
        "toe": ball[2] - gap * normal[2],
        "high": ball[1] - gap * normal[1],
        "closure": spin[1],
        "pitch_rate": spin[2],
        "lie_rate": -spin[0],
    }
    return Touch(values, time)


def pose_of_delivery(xp: Any, values: dict[str, Any], ball_position: Any, head: Head, point: Any) -> Pose:
    """Return pose and motion of the head at first touch; the inverse of :func:`delivery_of_pose`."""
    hand = head.hand
    turn = attitude(xp, values["loft"], hand * values["face"], values["lie"], head.static_loft)
    speed, attack, path = values["speed"], values["attack"], hand * values["path"]
    velocity = (speed * xp.cos(attack) * xp.cos(path), speed * xp.sin(attack), speed * xp.cos(attack) * xp.sin(path))
    spin = (-values["lie_rate"], values["closure"], values["pitch_rate"])
    touched = face_point(xp, values["toe"], values["high"], 1.0 / head.bulge, 1.0 / head.roll)
    _, normal = _nearest(xp, touched, head)
    ball = _apply(turn, _plus(head.cg_to_face, _from_face(xp, _along(touched, normal, head.ball_radius), head)))
    lever = _apply(turn, _mirror(_components(point), hand))
    place = _plus(_components(ball_position), _mirror(_minus(lever, ball), hand))
    moving = _mirror(_plus(velocity, _cross(spin, lever)), hand)
    rotation = _stack(xp, [_stack(xp, row) for row in _mirror_matrix(turn, hand)], -2)
    return Pose(rotation, _stack(xp, place), _stack(xp, moving), _stack(xp, _mirror_spin(spin, hand)))


def attitude(xp: Any, loft: Any, face: Any, lie: Any, static_loft: Any) -> Matrix:
    """Return the rotation from head axes to world axes of a right-handed head, built as in the core.

    Tilt by the lie, yaw the normal of the face back to azimuth 0, turn about z until its elevation is the dynamic loft,
    yaw right by the face angle.
    """
    sin_lie, cos_lie = xp.sin(lie), xp.cos(lie)
    along, up, right = xp.cos(static_loft), cos_lie * xp.sin(static_loft), -sin_lie * xp.sin(static_loft)
    level = xp.sqrt(along * along + right * right)
    tilted = ((1.0, 0.0, 0.0), (0.0, cos_lie, sin_lie), (0.0, -sin_lie, cos_lie))
    square = _about_y(right / level, along / level)
    sin_loft, cos_loft = xp.sin(loft), xp.cos(loft)
    sin_raise, cos_raise = sin_loft * level - cos_loft * up, cos_loft * level + sin_loft * up
    raised = ((cos_raise, -sin_raise, 0.0), (sin_raise, cos_raise, 0.0), (0.0, 0.0, 1.0))
    return _product(_about_y(-xp.sin(face), xp.cos(face)), _product(raised, _product(square, tilted)))


def _about_y(sine: Any, cosine: Any) -> Matrix:
    return ((cosine, 0.0, sine), (0.0, 1.0, 0.0), (-sine, 0.0, cosine))


def rotation_by(spin: Vector, time: Any) -> Matrix:
    """Return the rotation exp(time [spin]x) by series, exact to rounding for angles below a radian; no square root."""
    square = time * time * _dot(spin, spin)
    first = 1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0)))
    second = 0.5 - square / 24.0 * (1.0 - square / 30.0 * (1.0 - square / 56.0 * (1.0 - square / 90.0)))
    x, y, z = (time * each for each in spin)
    a, b = first, second
    return (
        (1.0 - b * (y * y + z * z), b * x * y - a * z, b * x * z + a * y),
        (b * x * y + a * z, 1.0 - b * (x * x + z * z), b * y * z - a * x),
        (b * x * z - a * y, b * y * z + a * x, 1.0 - b * (x * x + y * y)),
    )


def circle(xp: Any, x: Any, y: Any, curvature: Any) -> Vector:
    """Return the distance of (x, y) from a circle through the origin, and the unit normal; curvature 0 is a line."""
    radial = curvature * x + 1.0
    root = xp.sqrt(radial * radial + curvature * y * (curvature * y))
    distance = (2.0 * x + curvature * (x * x + y * y)) / (root + 1.0)
    return distance, radial / root, curvature * y / root


def _nearest(xp: Any, ball: Vector, head: Head) -> tuple[Any, Vector]:
    """Return the distance of a point from the face, and the outward normal at the nearest face point."""
    x, along, across = circle(xp, ball[0], ball[2], 1.0 / head.bulge)
    distance, ahead, up = circle(xp, x, ball[1], 1.0 / head.roll)
    return distance, (ahead * along, up, ahead * across)


def face_point(xp: Any, toe: Any, high: Any, bulge: Any, roll: Any) -> Vector:
    """Return the point at offsets from the centre of a face with curvatures ``bulge`` and ``roll``, in face axes."""
    x = -(roll * high * high) / (xp.sqrt(1.0 - roll * high * (roll * high)) + 1.0)
    radial = bulge * x + 1.0
    root = xp.sqrt(radial * radial - bulge * toe * (bulge * toe))
    return (2.0 * x + bulge * (x * x - toe * toe)) / (root + 1.0), high, toe


def _ball_in_face(xp: Any, turn: Matrix, away: Vector, head: Head) -> Vector:
    """Return the centre of the ball from the face centre, in face axes; ``away`` is its vector from the CG."""
    return _to_face(xp, _minus(_apply_transposed(turn, away), head.cg_to_face), head)


def _to_face(xp: Any, v: Vector, head: Head) -> Vector:
    sine, cosine = xp.sin(head.static_loft), xp.cos(head.static_loft)
    return cosine * v[0] + sine * v[1], cosine * v[1] - sine * v[0], v[2]


def _from_face(xp: Any, v: Vector, head: Head) -> Vector:
    sine, cosine = xp.sin(head.static_loft), xp.cos(head.static_loft)
    return cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1], v[2]


def rotation_rows(rotation: Any) -> Matrix:
    """Return the rows of the rotation matrix of a matrix or a quaternion."""
    if rotation.shape[-1] == 3:
        return tuple(_components(rotation[..., row, :]) for row in range(3))  # pyright: ignore[reportReturnType]
    w, x, y, z = (rotation[..., place] for place in range(4))
    s = 2.0 / (w * w + x * x + y * y + z * z)
    return (
        (1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)),
        (s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)),
        (s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)),
    )


def _components(v: Any) -> Vector:
    return v[..., 0], v[..., 1], v[..., 2]


def _stack(xp: Any, parts: Any, axis: int = -1) -> Any:
    broadcast = getattr(xp, "broadcast_arrays", None) or xp.broadcast_tensors
    return xp.stack(list(broadcast(*parts)), axis)


def _mirror(v: Vector, hand: Any) -> Vector:
    return v[0], v[1], hand * v[2]


def _mirror_spin(v: Vector, hand: Any) -> Vector:
    return hand * v[0], hand * v[1], v[2]


def _mirror_matrix(m: Matrix, hand: Any) -> Matrix:
    (a, b, c), (d, e, f), (g, h, i) = m
    return (a, b, hand * c), (d, e, hand * f), (hand * g, hand * h, i)


def _dot(a: Vector, b: Vector) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _plus(a: Vector, b: Vector) -> Vector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def _minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _along(start: Vector, direction: Vector, length: Any) -> Vector:
    return start[0] + length * direction[0], start[1] + length * direction[1], start[2] + length * direction[2]


def _level(xp: Any, v: Vector) -> Any:
    return xp.sqrt(v[0] * v[0] + v[2] * v[2])


def _column(m: Matrix, place: int) -> Vector:
    return m[0][place], m[1][place], m[2][place]


def _apply(m: Matrix, v: Vector) -> Vector:
    return _dot(m[0], v), _dot(m[1], v), _dot(m[2], v)


def _apply_transposed(m: Matrix, v: Vector) -> Vector:
    return _dot(_column(m, 0), v), _dot(_column(m, 1), v), _dot(_column(m, 2), v)


def _product(a: Matrix, b: Matrix) -> Matrix:
    return tuple(tuple(_dot(row, _column(b, place)) for place in range(3)) for row in a)  # pyright: ignore[reportReturnType]
