"""The inputs of an impact: from club, ball, delivery and parameters as given by the user to the columns of the core.

A single shot must cost little more than its physics: the columns of clubs, balls and parameters are cached, and plain
numbers go straight into their columns.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clubface import units
from clubface.equipment.balls import Ball, ball
from clubface.equipment.clubs import Club, club
from clubface.equipment.described import FLAT, HANDS
from clubface.equipment.models import model
from clubface.equipment.parameters import ParameterSet, builtin_sets
from clubface.errors import InputError, ShotError, UnknownNameError, Wording
from clubface.schema import Choice, Items, PhysicalValue, file_key
from clubface.simulation.results import input_columns, input_dimensions, inputs, translate_core_error
from clubface.support.arrays import NumberOrArray, ValueLike, flat
from clubface.support.checks import check_choice, check_names, whole
from clubface.support.files import is_path
from clubface.support.processes import FAILED, check_request
from clubface.units import parse_values

if TYPE_CHECKING:
    from clubface.simulation.pose import Head, Pose
else:  # the same, short enough to read in the documentation
    ValueLike = float | str | Sequence[float] | Sequence[str]


@dataclass(frozen=True, kw_only=True)
class Delivery:
    """A delivery of the clubhead. A value is text with a unit (``"113 mph"``), an SI number, or an array of either.

    Velocity and angular velocity are those of the clubhead's CG at first touch. For a left-handed club, path and face
    angle remain relative to the world, everything else to the club.

    Attributes
    ----------
    speed
        Clubhead speed [m/s]; required.
    attack
        Attack angle [rad], upward is positive.
    path
        Club path [rad], to the right of the target is positive.
    loft
        Dynamic loft [rad]: elevation of the face normal at the face centre. Default: the club's static loft.
    face
        Face angle [rad], to the right of the target is positive.
    lie
        Lie tilt [rad], toe up is positive.
    toe, high
        Impact point relative to the face centre [m], positive towards the toe and towards the crown.
    closure
        Closure rate of the face about the vertical [rad/s].
    pitch_rate, lie_rate
        Rates of increase of the loft, and of the lie tilt, toe rising [rad/s].
    ball_backspin, ball_sidespin, ball_riflespin
        Spin of the ball before impact [rad/s], about the horizontal to the right of the target, the downward vertical
        and the horizontal to the target; zero for a ball at rest.
    """

    speed: Any
    attack: Any = 0.0
    path: Any = 0.0
    loft: Any = None
    face: Any = 0.0
    lie: Any = 0.0
    toe: Any = 0.0
    high: Any = 0.0
    closure: Any = 0.0
    pitch_rate: Any = 0.0
    lie_rate: Any = 0.0
    ball_backspin: Any = 0.0
    ball_sidespin: Any = 0.0
    ball_riflespin: Any = 0.0

    def __post_init__(self) -> None:
        for name, dimension in DIMENSIONS.items():
            value = getattr(self, name)
            if not (name == "loft" and value is None):
                object.__setattr__(self, name, units.parse_values(value, dimension, name=name))

    def values(self) -> dict[str, NumberOrArray]:
        """Return the given values by name [SI]."""
        given = {name: getattr(self, name) for name in DIMENSIONS}
        return {name: value for name, value in given.items() if value is not None}

    def replace(self, **changes: Any) -> Self:
        """Return a copy of the delivery with some values changed."""
        check_names("delivery value", changes, [each.name for each in fields(self)])
        return replace(self, **changes)

    @classmethod
    def from_pose(
        cls,
        rotation: ArrayLike,
        position: ArrayLike,
        velocity: ArrayLike,
        angular_velocity: ArrayLike,
        *,
        club: str | os.PathLike[str] | Club,
        ball: str | os.PathLike[str] | Ball | None = None,
        ball_position: ArrayLike = (0.0, 0.0, 0.0),
        ball_angular_velocity: ArrayLike = (0.0, 0.0, 0.0),
        point: str | ArrayLike = "cg",
        hand: HandLike | None = None,
    ) -> Self:
        """Return the delivery of a head with known pose and motion, such as from a multibody program.

        World axes: x to the target, y up, z to the right of the target line, also for a left-hander. The head is moved
        on (or back) with constant velocity and angular velocity to first touch, which must be within a millisecond.
        Leading axes broadcast.

        Parameters
        ----------
        rotation
            Rotation from head axes to world axes, a matrix, shape (..., 3, 3), or a quaternion, real part first, shape
            (..., 4). Head axes coincide with world axes while the club stands at its static loft with a square face;
            the CG and the inertia of a club are given in them.
        position, velocity
            Position [m] and velocity [m/s] of a point of the head, shape (..., 3).
        angular_velocity, ball_angular_velocity
            Angular velocities of head and ball, in world axes [rad/s], shape (..., 3).
        club, ball, hand
            As for :func:`impact`.
        ball_position
            Centre of the ball at rest [m], shape (..., 3).
        point
            Point of the head to which position and velocity refer: "cg", "face_centre", or the vector to it from the CG
            in head axes [m].

        Raises
        ------
        InputError
            The rotation is not a rotation, an array has the wrong shape, or the head does not touch the ball within a
            millisecond.

        See Also
        --------
        Delivery.pose : the inverse.
        """
        from clubface.simulation.pose import Pose, delivery_of_pose

        turn = _rotation(rotation)
        given = {
            "position": (position, "length"), "velocity": (velocity, "speed"),
            "angular_velocity": (angular_velocity, "angular rate"), "ball_position": (ball_position, "length"),
            "ball_angular_velocity": (ball_angular_velocity, "angular rate"),
        }  # fmt: skip
        vectors = {name: _vector(value, name, dimension) for name, (value, dimension) in given.items()}
        common_shape(
            {name: each[..., 0] for name, each in vectors.items()}
            | {"rotation": turn[..., 0] if turn.shape[-1] == 4 else turn[..., 0, 0]}
        )
        head = head_of(equipment(club, ball), hand)
        ball_spin, place = vectors.pop("ball_angular_velocity"), vectors.pop("ball_position")
        with np.errstate(all="ignore"):
            touch = delivery_of_pose(np, Pose(turn, **vectors), place, head, point_of(head, point))
        off = ~(np.abs(touch.time) <= LONGEST_ADVANCE)
        if off.any():
            first = f"{np.ravel(touch.time)[np.argmax(np.ravel(off))] * 1e3:.3g} ms"
            allowed = "within 1 ms of first touch at the given velocities, with the head moving towards the ball"
            raise InputError("position", Wording(f"a pose {first} from first touch"), allowed)
        spins = dict(zip(BALL_SPINS, (ball_spin[..., 2], -ball_spin[..., 1], ball_spin[..., 0]), strict=True))
        values = {**touch.values, **(spins if ball_spin.any() else {})}
        return cls(**{name: value if np.ndim(value) else float(value) for name, value in values.items()})

    def pose(
        self,
        club: str | os.PathLike[str] | Club,
        *,
        ball: str | os.PathLike[str] | Ball | None = None,
        ball_position: ArrayLike = (0.0, 0.0, 0.0),
        point: str | ArrayLike = "cg",
        hand: HandLike | None = None,
    ) -> Pose:
        """Return the pose and motion of the head at first touch; the inverse of :meth:`from_pose`.

        Parameters and axes are those of :meth:`from_pose`.
        """
        from clubface.simulation.pose import pose_of_delivery

        setup = equipment(club, ball)
        head = head_of(setup, hand)
        values = {name: np.asarray(value) for name, value in self.values().items()}
        values.setdefault(_LOFT, np.asarray(head.static_loft))
        place, offset = _vector(ball_position, "ball_position", "length"), point_of(head, point)
        common_shape(values | {"ball_position": place[..., 0], "point": offset[..., 0]})
        values = dict(zip(values, np.broadcast_arrays(*values.values()), strict=True))
        return pose_of_delivery(np, values, place, head, offset)


DeliveryLike = Delivery | Mapping[str, ValueLike | None]
"""A delivery, or its values by name."""
HandLike = ValueLike
"""The hand of a club: "right" or 1, "left" or -1, or an array of these numbers."""


DIMENSIONS = {name: each.dimension for name, each in inputs().items() if each.group == "delivery"}
"""Dimension of each value of a delivery, in the order of the core."""
BALL_SPINS = ("ball_backspin", "ball_sidespin", "ball_riflespin")
OF_CLUB = {name: dimension for name, dimension in DIMENSIONS.items() if name not in BALL_SPINS}
"""Dimension of each value of a delivery that describes the club rather than the ball."""
UNITS = {"speed": "mph", "angle": "deg", "length": "mm", "angular rate": "deg/s"}
"""Unit for reading and writing each dimension of a delivery."""
DELIVERY_QUANTITIES = {name: PhysicalValue(UNITS[dimension]) for name, dimension in DIMENSIONS.items()}
"""Schema of each value of a delivery in a file."""
LONGEST_ADVANCE = 1e-3
"""Maximum time from a pose to first touch [s]; in a millisecond a head moves 45 mm, nearly straight."""
NOT_ORTHOGONAL = 1e-6
"""Maximum deviation of R^T R from the identity for a rotation matrix R."""
CG, FACE_CENTRE = "cg", "face_centre"
"""Points of a head that can be given by name."""


@dataclass(frozen=True, kw_only=True)
class Correlation:
    """A correlation between two values of a delivery."""

    pair: tuple[str, str] = file_key(
        Items(Choice(tuple(OF_CLUB)), 2, 2, 'two values of a delivery, as in ["loft", "attack"]'), "the two values",
        name="of",
    )  # fmt: skip
    value: float = file_key(
        PhysicalValue("1", above=-1, below=1, allowed="a number between -1 and 1"), "the correlation"
    )


_LOFT, _HAND = "loft", "hand"


class Equipment(NamedTuple):
    """A club and a ball."""

    club: Club
    ball: Ball
    columns: tuple[float, ...]  # inputs of a shot at the static loft whose other delivery values are 0


def head_of(setup: Equipment, hand: HandLike | None = None) -> Head:
    """Return the geometry of head and ball that determines first touch."""
    from clubface.simulation.pose import Head

    values = dict(zip(inputs(), setup.columns, strict=True))
    cg = values["cg_x"], values["cg_y"], values["cg_z"]
    hand = values[_HAND] if hand is None else hand_value(hand)
    return Head(cg, values["static_loft"], values["bulge"], values["roll"], values["ball_radius"], hand)


def point_of(head: Head, point: Any) -> NDArray[Any]:
    """Return the vector from the CG of a head to one of its points, in head axes [m], shape (..., 3)."""
    if isinstance(point, str):
        check_choice("point", point, (CG, FACE_CENTRE))
        x, y, z = head.cg_to_face
        return np.zeros(3) if point == CG else np.stack(np.broadcast_arrays(x, y, head.hand * z), axis=-1)
    return _vector(point, "point", "length")


def _vector(value: Any, name: str, dimension: str) -> NDArray[Any]:
    """Convert vectors to an array of shape (..., 3)."""
    array = np.asarray(parse_values(value, dimension, name=name))
    if array.shape[-1:] != (3,):
        raise InputError(name, Wording(f"of shape {array.shape}"), "of shape (..., 3)")
    return array


def _rotation(value: Any) -> NDArray[Any]:
    """Convert and check rotation matrices, shape (..., 3, 3), or quaternions, shape (..., 4)."""
    array = np.asarray(parse_values(value, units.DIMENSIONLESS, name="rotation"))
    if array.ndim and array.shape[-1] == 4:
        if not (np.sum(array * array, axis=-1) > 0.0).all():
            raise InputError("rotation", Wording("a quaternion of length 0"), "one of any other length")
        return array
    if array.shape[-2:] != (3, 3):
        raise InputError("rotation", Wording(f"of shape {array.shape}"), "of shape (..., 3, 3), or (..., 4)")
    if not (
        np.abs(array @ np.swapaxes(array, -1, -2) - np.eye(3)).max() < NOT_ORTHOGONAL
        and np.linalg.det(array).min() > 0.0
    ):
        raise InputError("rotation", Wording("a matrix"), "orthogonal to 1e-6, with determinant 1")
    return array


class Shots(NamedTuple):
    """Inputs of shots in the form that the core takes."""

    club: Club
    ball: Ball
    columns: list[Any]  # one per input: a number, or a flat array of the shots
    shape: tuple[int, ...]  # shape to which the inputs broadcast; () for a single shot
    varied: dict[str, NDArray[Any]]  # the inputs and parameters given as arrays, by name, not broadcast
    loft_assumed: bool = False  # whether the static loft replaces a dynamic loft that was not given


class Prepared(NamedTuple):
    """Shots, equipment and parameters, ready for a model to compute."""

    shots: Shots  # the inputs, broadcast
    chosen: ParameterSet
    parameters: list[Any]  # one per parameter of the model: a number, or a flat array of the shots

    def error(self, error: ValueError) -> ShotError:
        """Turn the core's ``ValueError(name, message)`` about one shot into an error of the package."""
        return translate_core_error(error, lambda name: self.value_of(name, 0))

    def value_of(self, name: str, row: int) -> Any:
        """Return the value of an input or parameter in one row [SI]; None for any other name."""
        if name in input_columns():
            value = self.shots.columns[input_columns()[name]]
        elif name in self.chosen.values:
            value = self.parameters[list(self.chosen.values).index(name)]
        else:
            return None
        return value if isinstance(value, float) else float(value[row])


def prepare(
    model_name: str,
    club: str | os.PathLike[str] | Club,
    values: Mapping[str, Any],
    ball: str | os.PathLike[str] | Ball | None,
    parameters: Any,
    hand: HandLike | None = None,
    *,
    outputs: int | None = None,
    single: str = "",
) -> Prepared:
    """Prepare shots for a model; arguments as for :func:`clubface.impact`.

    ``outputs`` is the number of values computed per shot, which must fit in memory. ``single`` names a computation that
    takes a single shot only; arrays then raise InputError.
    """
    setup, chosen = equipped(model_name, club, ball, parameters)
    laid_out = shots(setup, values, hand=hand)
    if single:
        arrays = [*laid_out.varied, *(name for name, each in chosen.values.items() if not isinstance(each, float))]
        if arrays:
            raise InputError(arrays[0], Wording("an array"), f"a single number: {single} takes a single shot")
    laid_out, columns = broadcast(laid_out, chosen.columns(), tuple(chosen.values), outputs or 0)
    return Prepared(laid_out, chosen, columns)


def equipment(
    club_or_name: str | os.PathLike[str] | Club, ball_or_name: str | os.PathLike[str] | Ball | None
) -> Equipment:
    """Return club and ball; built-in names and objects are cached, files are read again."""
    ball_or_name = getattr(ball_or_name, "rigid", ball_or_name)
    if is_path(club_or_name) or is_path(ball_or_name):
        return _equip(club_or_name, ball_or_name)
    try:
        return _kept(club_or_name, ball_or_name)
    except TypeError:
        raise InputError("club", club_or_name, "a name, the path of a TOML file or a Club") from None


def _equip(club_or_name: Any, ball_or_name: Any) -> Equipment:
    made, made_ball = club(club_or_name), ball(ball_or_name)
    values = {**made.inputs(), **made_ball.inputs(), _LOFT: made.loft}
    return Equipment(made, made_ball, tuple(values.get(name, 0.0) for name in inputs()))


_kept = lru_cache(maxsize=256)(_equip)


def equipped(
    model_name: str,
    club_or_name: str | os.PathLike[str] | Club,
    ball_or_name: str | os.PathLike[str] | Ball | None,
    given: Any,
) -> tuple[Equipment, ParameterSet]:
    """Return club and ball as a model takes them, and its parameters; ``given`` as for :func:`parameter_set`."""
    if given is None and not (is_path(club_or_name) or is_path(ball_or_name)):
        try:
            return _usual(model_name, club_or_name, ball_or_name, None)
        except TypeError:
            pass  # not hashable, hence neither a club nor a ball: reported below
    return _find_equipment(model_name, club_or_name, ball_or_name, given)


def _find_equipment(model_name: str, name: Any, ball_or_name: Any, given: Any) -> tuple[Equipment, ParameterSet]:
    setup = equipment(name, ball_or_name)
    chosen = parameter_set(model_name, setup.club, given, setup.ball)
    if chosen.includes_face:
        columns = chosen.with_included_face(dict(zip(inputs(), setup.columns, strict=True)))
        setup = setup._replace(columns=tuple(columns.values()))
    return setup, chosen


_usual = lru_cache(maxsize=256)(_find_equipment)


def shots(setup: Equipment, values: Mapping[str, Any], *, hand: HandLike | None = None) -> Shots:
    """Lay out shots whose inputs differ from ``setup`` by ``values``: text with a unit, SI numbers, or arrays.

    None counts as not given. The loft defaults to the club's static loft; the speed is required.
    """
    columns: list[Any] = list(setup.columns)
    column_of = input_columns()
    varied: dict[str, NDArray[Any]] = {}
    for name, value in values.items():
        if value is None:
            continue
        column = column_of.get(name)
        if column is None:
            raise UnknownNameError("input", name, column_of)
        if type(value) is not float:
            value = _parse_input(value, name)
            if type(value) is not float:
                varied[name] = value
        columns[column] = value
    if hand is not None:
        columns[column_of[_HAND]] = side = hand_value(hand)
        if type(side) is not float:
            varied[_HAND] = side
    if values.get("speed") is None:
        raise InputError("speed", None, 'give it, as in speed="113 mph": it is the one value without a default')
    assumed = values.get(_LOFT) is None
    if assumed and values.get("static_loft") is not None:
        columns[column_of[_LOFT]] = columns[column_of["static_loft"]]
    return Shots(setup.club, setup.ball, columns, (), varied, assumed)


def hand_value(hand: Any) -> Any:
    """Return +1.0 for "right" or 1 and -1.0 for "left" or -1, likewise for arrays."""
    if isinstance(hand, str):
        check_choice(_HAND, hand, HANDS)
        return float(HANDS[hand])
    return _parse_input(hand, _HAND)


def _parse_input(value: Any, name: str) -> Any:
    """Convert a value to a float or a float64 array [SI]; text is converted from its unit."""
    if isinstance(value, str):
        return _parse_text(value, name)
    value = parse_values(value, input_dimensions()[name], name=name)
    return value if isinstance(value, float) or value.ndim else float(value)


@lru_cache(maxsize=1024)
def _parse_text(value: str, name: str) -> float:
    flat = value == FLAT and name in ("bulge", "roll")
    return math.inf if flat else float(parse_values(value, input_dimensions()[name], name=name))


def broadcast(shots: Shots, parameters: list[Any], names: tuple[str, ...], outputs: int) -> tuple[Shots, list[Any]]:
    """Broadcast array inputs and parameters (called ``names``) to flat arrays; check the memory for ``outputs``."""
    if not shots.varied and set(map(type, parameters)) <= {float}:
        return shots, parameters
    varied = dict(shots.varied)
    for name, value in zip(names, parameters, strict=True):
        if not isinstance(value, float):
            varied[name] = value
    shape = common_shape(varied)
    copies = sum(each.shape != shape for each in shots.columns if not isinstance(each, float))
    check_request(math.prod(shape), 8 * (outputs + copies) + FAILED)
    columns, parameters = ([flat(each, shape) for each in every] for every in (shots.columns, parameters))
    return shots._replace(columns=columns, shape=shape, varied=varied), parameters


def common_shape(arrays: Mapping[str, Any]) -> tuple[int, ...]:
    """Return the shape to which named arrays broadcast."""
    try:
        return np.broadcast_shapes(*(each.shape for each in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {each.shape}" for name, each in arrays.items())
        raise InputError("the shapes of the inputs", shapes, "shapes that broadcast") from None


def parameter_set(model_name: str, of_club: Club, given: Any, of_ball: Ball | None = None) -> ParameterSet:
    """Return the parameters to use: ``given``, or the published set of the club's family with the ball's values.

    ``given`` may be a :class:`ParameterSet`, the name of a published set, the path of a TOML file, or a mapping of
    values that replace those of the published set.
    """
    chosen = _given_set(model_name, of_club.parameters, given)
    if of_ball is None:
        return chosen
    # Values that belong to the ball: its own for the model, and its friction unless fitted to shots.
    takes_friction = "friction" in chosen.values and not chosen.includes_face and of_ball.friction is not None
    friction: Any = {"friction": of_ball.friction} if takes_friction else {}
    return chosen.of_ball(of_ball.name, {**friction, **of_ball.parameters.get(model_name, {})})


def forget_parameters() -> None:
    """Clear the caches of parameters after those of a model have changed."""
    _published_set.cache_clear()
    _usual.cache_clear()


def _given_set(model_name: str, family: str, given: Any) -> ParameterSet:
    if given is None:
        return _published_set(model_name, family)
    if isinstance(given, ParameterSet):
        if given.model != model_name:
            raise InputError("parameters", Wording(f"a set of {given.model}"), f"a set of {model_name}")
        return given
    if isinstance(given, Mapping):
        for name in given:
            model(model_name).parameter(name)
        return _published_set(model_name, family).replace(**given)
    if is_path(given) and given not in {each.name for each in builtin_sets(model_name)}:
        return ParameterSet.from_toml(given, model=model_name, club=family)
    if isinstance(given, str):
        return ParameterSet.builtin(model_name, family, given)
    raise InputError("parameters", given, "a ParameterSet, a name, the path of a TOML file or a mapping of values")


@lru_cache(maxsize=64)
def _published_set(model_name: str, family: str) -> ParameterSet:
    model(model_name)
    return ParameterSet.builtin(model_name, family)


def as_values(delivery: DeliveryLike | None, values: Mapping[str, Any]) -> Mapping[str, Any]:
    """Merge a delivery and single values, which take precedence."""
    if delivery is None:
        return values
    given = delivery.values() if isinstance(delivery, Delivery) else delivery
    if not isinstance(given, Mapping):
        allowed = 'a Delivery or a mapping; give single values by name, as in speed="113 mph"'
        raise InputError("delivery", delivery, allowed)
    return {**given, **values}


MOST_THREADS = 1024
"""Maximum number of threads, so that a typing error does not start a million."""
FINEST, COARSEST = 1e-13, 1e-2
"""Smallest and largest relative tolerance per step that the core accepts."""


def check_on_error(on_error: object) -> None:
    """Raise InputError unless ``on_error`` is "raise" or "nan"."""
    check_choice("on_error", on_error, ("raise", "nan"))


def thread_count(threads: object) -> int:
    """Return the number of threads for the core, 0 for all cores."""
    if threads is None:
        return 0
    count = whole(threads)
    if count is None or not 1 <= count <= MOST_THREADS:
        raise InputError("threads", threads, f"a whole number from 1 to {MOST_THREADS}, or None for all cores")
    return count


def tolerance(accuracy: object) -> float | None:
    """Return the relative tolerance per step, None for the fast setting."""
    if accuracy is None:
        return None
    result = units.parse(accuracy, units.DIMENSIONLESS, name="accuracy")
    if not FINEST <= result <= COARSEST:
        raise InputError("accuracy", accuracy, "from 1e-13 to 1e-2; leave it out for the fast setting")
    return result
