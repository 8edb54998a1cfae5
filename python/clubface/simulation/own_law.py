"""A law of contact of your own, written in Python or compiled, and used wherever a model is named.

Clubhead and ball are two rigid bodies that move under the law. Launches and their derivatives are integrated by the
core. Histories are integrated here, by SciPy and the equations of Newton and Euler in world axes, with the momentum of
both bodies and the angular momentum of the head as states: another form than that of the core, which checks both.
"""

from __future__ import annotations

import ctypes
import inspect
import marshal
import math
import numbers
import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.backends import MODULES, OWN
from clubface.equipment.models import Model, Parameter, models
from clubface.errors import InputError, RunError
from clubface.simulation import core
from clubface.simulation.dual import Dual, dual_of
from clubface.simulation.impact import Balls, Problems, Request
from clubface.simulation.inputs import forget_parameters
from clubface.simulation.results import inputs, outputs
from clubface.support.checks import check_text

USUAL_TOLERANCE = 1e-7
"""Of a step, where no accuracy is given: the launch is then correct to 1e-5, its peak force to 3e-5."""
HISTORY_POINTS = 201
"""Times of a history, evenly spaced from first touch to separation."""
MOST_STATES = 24
"""States that a law may have."""
DIRECTIONS = 8
"""Derivatives that a law is asked for at a time."""
CHECKED_BY = "standard"
"""The model whose checks of deliveries, clubs and balls are used; they are the same for all."""


def register_law(
    name: str,
    law: Law | Any,
    *,
    parameters: Mapping[str, str | float | Parameter] | None = None,
    states: Mapping[str, str | float] | None = None,
    complex_law: Any = None,
    title: str = "",
    summary: str = "A law of contact of one's own.",
    reference: str = "",
) -> Model:
    """Make a law of contact, written in Python, a model that :func:`impact` and :func:`history` know by ``name``.

    Clubhead and ball are two rigid bodies; the law says what forces act between them. It describes ball and face
    together, so that the characteristic time of the club is not used. It is known in this process alone, and
    registering a name again replaces its law.

    Parameters
    ----------
    name
        A word that no other model has.
    law
        Called as ``law(touch, values)`` with a :class:`Touch` and the values of the parameters by name [SI]; returns
        the normal force on the ball, and the friction on the ball up the face and towards the toe [N]. A negative
        normal force counts as zero. With ``states`` it is called as ``law(touch, values, states)``, with their values
        by name, and returns their rates by name as well. For :func:`sensitivity` it is called with numbers that carry
        derivatives: use functions of NumPy, not of ``math``.

        A compiled law is a function of C, ``void law(const double *touch, const double *values, const double *states,
        double *result)``: a function of ctypes, or whatever has its ``address``, as a ``cfunc`` of Numba. ``touch`` has
        the numbers of a :class:`Touch` in order, ``result`` takes the three forces and the rates of the states.
    parameters
        Default of each parameter by its name: text with a unit, an SI number, or a :class:`Parameter` with meaning,
        bounds and source.
    states
        Variables of the law that change during contact, at most 24, such as the stretch of a spring along the face.
        They begin at zero. Given by name with their natural size, text with a unit or an SI number, by which errors are
        measured.
    complex_law
        Of a compiled law the same function of complex numbers, each a pair of double: derivatives are computed by it.
    title, summary, reference
        As of a :class:`Model`.

    Returns
    -------
    Model
        Its description.

    Raises
    ------
    InputError
        The name is that of a model of the package or of none, the law cannot be called, or a default or a size is no
        number.
    """
    if not (isinstance(name, str) and name.isidentifier()):
        raise InputError("name", name, "a word of letters, digits and underscores")
    if name in models() or name in MODULES or name == "all":
        raise InputError("name", name, "one that no model of the package has")
    address = _address(law)
    if not callable(law) and not address:
        raise InputError("law", law, "a function of a Touch and the values of the parameters")
    for what, text in (("title", title), ("summary", summary), ("reference", reference)):
        check_text(what, text)
    if not isinstance(parameters, Mapping | None):
        raise InputError("parameters", parameters, 'values by name, as in {"stiffness": 3e6, "damping": "0.006 s/m"}')
    if not isinstance(states, Mapping | None):
        raise InputError("states", states, 'natural sizes by name, as in {"stretch": "0.1 mm"}')
    declared = tuple(_parameter(key, value) for key, value in (parameters or {}).items())
    sizes = {key: _parameter(key, value).default for key, value in (states or {}).items()}
    if len(sizes) > MOST_STATES or not all(size > 0.0 for size in sizes.values()):
        raise InputError("states", sizes, f"at most {MOST_STATES} sizes above 0")
    model = Model(
        name=name, title=title or name, kind="contact", summary=summary, reference=reference,
        laws=("momentum", "angular_momentum"), laws_without=None, parameters=declared,
    )  # fmt: skip
    OWN[name] = SimpleNamespace(MODEL=model, BACKEND=OwnLaw(model, law, sizes, address, _address(complex_law)))
    forget_parameters()
    return model


def source_of(model: str) -> list[str]:
    """Return what identifies a law registered under a name: the file it stands in, else its code; [] for other models.

    A store of unfinished work must not mix the results of a law with those of what it was before it was edited.
    """
    if model not in OWN:
        return []
    law = OWN[model].BACKEND.law
    function = law if inspect.isroutine(law) or not callable(law) else type(law).__call__
    with suppress(TypeError, OSError):
        return [Path(inspect.getfile(function)).read_text(encoding="utf-8", errors="replace")]
    code = getattr(function, "__code__", None)
    return [os.urandom(16).hex() if code is None else marshal.dumps(code).hex()]


def _parameter(name: str, given: Any) -> Parameter:
    if not (isinstance(name, str) and name.isidentifier()):
        raise InputError("name of a parameter", name, "a word of letters, digits and underscores")
    if isinstance(given, Parameter):
        return replace(given, name=name)
    dimension = units.dimension_of(given, name=name)
    value, si = units.parse(given, dimension, name=name), units.symbols(dimension)[0]
    return Parameter(name, si, name.replace("_", " "), value, -math.inf, math.inf, "given with the law")


def _address(law: Any) -> int:
    """Return where a compiled function is, 0 for any other."""
    address = getattr(law, "address", None)
    if isinstance(address, int):
        return address
    if isinstance(law, ctypes._CFuncPtr):  # pyright: ignore[reportPrivateUsage, reportAttributeAccessIssue]
        return ctypes.cast(law, ctypes.c_void_p).value or 0
    return 0


class OwnLaw:
    """A shot at a time, each by the core."""

    def __init__(
        self, model: Model, law: Any, sizes: Mapping[str, float], address: int = 0, complex_address: int = 0
    ) -> None:
        self.model, self.states = model, dict(sizes)
        self.has_derivatives = not address or bool(complex_address)
        self.law = law
        sized = [*sizes.values()]
        if address:
            self._compiled = law, complex_address  # kept alive
            self.law = _called_by_pointer(address, [each.name for each in model.parameters], [*sizes])
            self._held = core.HeldLaw.at(address, complex_address, sized)
        else:
            self._held = core.HeldLaw(self._call, self._call_with_derivatives, sized)

    def balls(self, given: Any, accuracy: float | None) -> Balls:
        """Return the ball as it is."""
        return Balls(None, given)

    def _call(self, touch: Any, values: Any, states: Any) -> tuple[float, ...]:
        """Call the law with plain numbers; return forces and rates of the states."""
        if not all(map(math.isfinite, touch)):
            return (math.nan,) * (3 + len(states))
        return checked_law(
            self.law, Touch._make(touch), self._named(values), dict(zip(self.states, states, strict=True))
        )

    def _call_with_derivatives(self, touch: Any, values: Any, states: Any) -> list[float]:
        """Call the law with numbers that carry derivatives, each of them its value and then its derivatives."""
        touch, values, states = (
            [Dual(row[0], row[1:]) for row in np.array(each).reshape(-1, 1 + DIRECTIONS)]
            for each in (touch, values, states)
        )
        if not all(math.isfinite(each.value) for each in touch):
            return [math.nan] * ((3 + len(states)) * (1 + DIRECTIONS))
        now = dict(zip(self.states, states, strict=True))
        try:
            given = (Touch._make(touch), self._named(values), *([now] if now else []))
            returned = _in_a_row(self.law(*given), now)
        except (AttributeError, TypeError) as error:
            raise RunError(
                f"the law of contact has no derivatives: {error}; use functions of NumPy, such as np.sqrt and np.tanh,"
                " which take numbers that carry derivatives"
            ) from error
        except RunError:
            raise
        except Exception as error:
            raise RunError(f"the law of contact fails: {type(error).__name__}: {error}") from error
        results = (dual_of(each, DIRECTIONS) for each in returned)
        return [number for each in results for number in (each.value, *each.tangent.tolist())]

    def _named(self, values: Any) -> dict[str, Any]:
        return {each.name: value for each, value in zip(self.model.parameters, values, strict=True)}

    def launches(self, shots: Request) -> tuple[NDArray[Any], Problems]:
        """Follow one contact after the other; what every model refuses is refused, and a contact without an end."""
        return self._rows(
            shots, len(outputs()), lambda given, values, tolerance: self._held.impact(given, values, tolerance)
        )

    def sensitivities(
        self, shots: Request, chosen: Sequence[int], variables: Sequence[int]
    ) -> tuple[NDArray[Any], Problems]:
        """Return for each chosen output its value and its derivatives by variables, as the core does for its models."""
        if not self.has_derivatives:
            raise InputError("model", self.model.name, "one with derivatives: register the law with a complex_law")

        def differentiated(given: list[float], values: list[float], tolerance: float) -> tuple[Any, str]:
            result, why = self._held.sensitivity(given, values, list(variables), tolerance)
            if result is None:
                return None, why
            launched, jacobian = result
            return np.column_stack([launched, jacobian])[list(chosen)].ravel(), ""

        return self._rows(shots, len(chosen) * (1 + len(variables)), differentiated)

    def _rows(
        self, shots: Request, size: int, compute: Callable[[list[float], list[float], float], tuple[Any, str]]
    ) -> tuple[NDArray[Any], Problems]:
        """Return ``size`` numbers a shot, NaN for those without, and why they have none."""
        usual = [each.default for each in models()[CHECKED_BY].parameters]
        _, problems = core.impact(CHECKED_BY, shots.inputs, usual, shots.size, None, shots.threads, None)
        refused = {row for row, *_ in problems}
        result = np.full((size, shots.size), np.nan)
        for row in range(shots.size):
            if row not in refused:
                given, values = (
                    [float(each if isinstance(each, (int, float)) else each[row]) for each in columns]
                    for columns in (shots.inputs, shots.parameters)
                )
                try:
                    fault = _fault(given)
                    if fault is None:
                        computed, why = compute(given, values, shots.accuracy or USUAL_TOLERANCE)
                        fault = None if not why else ("model", f"{self.model.name}: {UNFINISHED[why]}")
                        result[:, row] = math.nan if fault else computed
                    if fault:
                        problems.append((row, fault[0], fault[1]))
                except RunError as error:
                    if shots.on_error == "raise":
                        raise
                    problems.append((row, "model", str(error)))
            if shots.progress is not None:
                shots.progress(row + 1)
        return result, sorted(problems)

    def forces(self, launch: Any, delivery: Mapping[str, Any]) -> None:
        """Return None: :func:`clubface.history` returns more."""
        return None

    def history(self, model: str, inputs: list[float], parameters: list[float], accuracy: float | None) -> Any:
        """Follow one contact and keep it at evenly spaced times."""
        usual = [each.default for each in models()[CHECKED_BY].parameters]
        _, problems = core.impact(CHECKED_BY, inputs, usual, 1, None, 1, None)
        solved = problems[0][1:] if problems else self._solve(inputs, parameters, accuracy)
        if isinstance(solved[0], str):
            raise ValueError(*solved)
        return {**_history(*solved), "launch": _outputs(*solved)}

    def notes(self) -> tuple[()]:
        """Return no note."""
        return ()

    def _solve(self, given: list[float], values: list[float], accuracy: float | None) -> Any:
        """Return both bodies and the solution, or the name of what is at fault and why."""
        fault = _fault(given)
        if fault is not None:
            return fault
        named = dict(zip(inputs(), given, strict=True))
        bodies = TwoBodies(named, self.law, self._named(values), self.states)
        try:
            return bodies, bodies.run(accuracy or USUAL_TOLERANCE)
        except UnfinishedContactError as error:
            return "model", f"{self.model.name}: {error}"


def _fault(given: Sequence[float]) -> tuple[str, str] | None:
    """Return the input that a law of one's own does not take, and what to do."""
    named = dict(zip(inputs(), given, strict=True))
    if named["characteristic_time"] != named["included_time"]:
        return "characteristic_time", "leave it out: a law of one's own describes ball and face together"
    return None


def _called_by_pointer(address: int, names: Sequence[str], states: Sequence[str]) -> Law:
    """Return a compiled law as a function of Python."""
    pointer = ctypes.POINTER(ctypes.c_double)
    function = ctypes.CFUNCTYPE(None, pointer, pointer, pointer, pointer)(address)

    def law(touch: Touch, values: Mapping[str, float], now: Mapping[str, float] | None = None) -> tuple[Any, ...]:
        result = (ctypes.c_double * (3 + len(states)))()
        given = [touch, [values[name] for name in names], [(now or {})[name] for name in states]]
        function(*((ctypes.c_double * max(len(each), 1))(*each) for each in given), result)
        return (*result[:3], result[3:]) if states else tuple(result)

    return law


def _outputs(bodies: Any, solution: Any) -> NDArray[Any]:
    """Return the outputs of a contact in their order."""
    end = solution.y[:, -1]
    mirror, turned = np.array([1.0, 1.0, bodies.hand]), np.array([bodies.hand, bodies.hand, 1.0])
    v, w = end[BALL_VELOCITY] * mirror, end[BALL_SPIN] * turned
    speed, level = math.hypot(*v), math.hypot(v[0], v[2])
    club = bodies.start[CLUB_VELOCITY]
    backspin = (w[2] * v[0] - w[0] * v[2]) / level if level else w[2]
    return np.array([
        speed, speed / math.hypot(*club), math.atan2(v[1], level), math.atan2(v[2], v[0]), backspin, -w[1],
        math.hypot(*w), math.atan2(-w[1], backspin), *v, *w,
        *(end[CLUB_VELOCITY] * mirror), *(bodies.at(end, solution.t[-1]).club_spin * turned), solution.t[-1],
        _peak(bodies, solution),
    ])  # fmt: skip


def _peak(bodies: Any, solution: Any) -> float:
    """Return the largest normal force: near the largest of all steps, between its neighbours."""
    from scipy.optimize import minimize_scalar

    def force(time: float) -> float:
        return bodies.at(solution.sol(time), time).forces[0]

    steps = [bodies.at(state, time).forces[0] for state, time in zip(solution.y.T, solution.t, strict=True)]
    largest = steps.index(max(steps))
    near = solution.t[max(largest - 1, 0)], solution.t[min(largest + 1, len(steps) - 1)]
    best = minimize_scalar(lambda time: -force(time), bounds=near, method="bounded", options={"xatol": 1e-9})
    return max(steps[largest], -float(best.fun))  # pyright: ignore[reportAttributeAccessIssue]


def _history(bodies: Any, solution: Any) -> dict[str, NDArray[Any]]:
    """Return the course of a contact under the names of :class:`clubface.History`."""
    time = np.linspace(0.0, solution.t[-1], HISTORY_POINTS)
    states = solution.sol(time).T
    states[-1] = solution.y[:, -1]
    instants = [bodies.at(state, when) for state, when in zip(states, time, strict=True)]
    mirror, turned = np.array([1.0, 1.0, bodies.hand]), np.array([bodies.hand, bodies.hand, 1.0])
    forces = np.array([each.forces for each in instants]).T
    touches = np.array([each.touch for each in instants]).T
    turn = states[:, ATTITUDE]
    return {
        "time": time,
        **dict(zip(("normal_force", "force_y", "force_z"), forces, strict=True)),
        "penetration": touches[0],
        "sliding_y": touches[2],
        "sliding_z": touches[3],
        "kinetic_energy": np.array([bodies.kinetic_energy(state) for state in states]),
        **dict(zip(("normal_work", "friction_work"), states[:, WORK].T, strict=True)),
        "ball_position": states[:, BALL] * mirror,
        "ball_velocity": states[:, BALL_VELOCITY] * mirror,
        "ball_spin": states[:, BALL_SPIN] * turned,
        "club_position": states[:, CLUB] * mirror,
        "club_velocity": states[:, CLUB_VELOCITY] * mirror,
        "club_spin": np.array([each.club_spin for each in instants]) * turned,
        "club_attitude": turn / np.linalg.norm(turn, axis=1)[:, None],
    }


LONGEST = 0.01
"""Time after which a contact is given up [s]; a drive lasts half a millisecond."""
MOST_EVALUATIONS = 50_000
"""Evaluations of a law after which a contact is given up; a drive takes some 300."""


class Touch(NamedTuple):
    """What a law of contact receives at one instant.

    Attributes
    ----------
    depth
        Penetration of ball and face [m], 0 or more.
    rate
        Its rate [m/s]: positive while the ball is compressed.
    sliding_y, sliding_z
        Velocity of the ball's surface on the face [m/s], up the face and towards the toe.
    curvature
        Mean curvature of the face at the point of contact [1/m], 0 for a flat one.
    radius
        Of the ball [m].
    time
        Since first touch [s].
    slip_y, slip_z
        Distance that the ball's surface has slid [m], up the face and towards the toe.
    high, toe
        The point of contact from the face centre [m], up the face and towards the toe.
    """

    depth: float
    rate: float
    sliding_y: float
    sliding_z: float
    curvature: float
    radius: float
    time: float
    slip_y: float
    slip_z: float
    high: float
    toe: float


Law = Callable[..., Sequence[Any]]
"""Normal force and the friction on the ball up the face and towards the toe [N], from touch and parameters; from states
their rates as well."""

BALL, BALL_VELOCITY, BALL_SPIN, CLUB, CLUB_VELOCITY, CLUB_MOMENTUM = (slice(n, n + 3) for n in range(0, 18, 3))
ATTITUDE, WORK, SLIP = slice(18, 22), slice(22, 24), slice(24, 26)
LAW = 26
"""Where the states of the law begin."""


class Instant(NamedTuple):
    """Everything that the state of both bodies says of one instant, in world axes of a right-hander."""

    touch: Touch
    forces: tuple[float, float, float]
    force: NDArray[Any]
    arm: NDArray[Any]
    point: NDArray[Any]
    club_spin: NDArray[Any]
    attitude: NDArray[Any]
    rates: Sequence[float]


class TwoBodies:
    """One club, ball and delivery, given as the inputs of a shot by name, and the law between them."""

    def __init__(
        self,
        given: Mapping[str, float],
        law: Law,
        values: Mapping[str, float],
        states: Mapping[str, float] | None = None,
    ) -> None:
        self.law, self.values, self.states = law, values, states or {}
        self.has_pushed = False
        self.hand = given["hand"]
        self.ball_mass, self.ball_inertia = given["ball_mass"], given["ball_inertia"]
        self.radius, self.club_mass = given["ball_radius"], given["club_mass"]
        self.bulge, self.roll = (0.0 if math.isinf(given[name]) else 1.0 / given[name] for name in ("bulge", "roll"))
        reference = _about_z(given["static_loft"])
        xx, yy, zz, xy, xz, yz = (given[name] for name in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz"))
        self.inertia = reference.T @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ reference
        self.inverse_inertia = np.linalg.inv(self.inertia)
        self.lever = reference.T @ np.array([given["cg_x"], given["cg_y"], given["cg_z"]])
        self.attitude = _attitude(given, self.hand)
        self.start = self._start(given)

    def _start(self, given: Mapping[str, float]) -> NDArray[Any]:
        """Return the state at first touch: the clubhead's CG at the origin."""
        attack, path, speed = given["attack"], given["path"] * self.hand, given["speed"]
        up, sideways = math.sin(attack), math.sin(path)
        point = self._face_point(given["toe"], given["high"])
        _, normal, _ = self.nearest(point)
        state = np.zeros(LAW + len(self.states))
        state[BALL] = self.attitude @ (self.lever + point + self.radius * normal)
        sidespin, riflespin = given["ball_sidespin"] * self.hand, given["ball_riflespin"] * self.hand
        state[BALL_SPIN] = riflespin, -sidespin, given["ball_backspin"]
        level = math.cos(attack)
        state[CLUB_VELOCITY] = speed * np.array([level * math.cos(path), up, level * sideways])
        club_spin = np.array([-given["lie_rate"], given["closure"], given["pitch_rate"]])
        state[CLUB_MOMENTUM] = self.attitude @ (self.inertia @ (self.attitude.T @ club_spin))
        state[ATTITUDE] = 1.0, 0.0, 0.0, 0.0
        return state

    def _face_point(self, toe: float, high: float) -> NDArray[Any]:
        """Return the face point at offsets in the plane tangent at the centre, from the centre, in face axes."""
        x = -self.roll * high**2 / (math.sqrt(1.0 - (self.roll * high) ** 2) + 1.0)
        root = math.sqrt((1.0 + self.bulge * x) ** 2 - (self.bulge * toe) ** 2)
        return np.array([(2.0 * x + self.bulge * (x**2 - toe**2)) / (root + 1.0), high, toe])

    def nearest(self, place: Sequence[float] | NDArray[Any]) -> tuple[float, NDArray[Any], float]:
        """Return distance from the face, normal and mean curvature at the nearest point of the face, in face axes."""
        x, y, z = place
        across, radial_x, radial_z = _circle(x, z, self.bulge)
        distance, normal_x, normal_y = _circle(across, y, self.roll)
        other = normal_x * self.bulge / (1.0 + self.bulge * (across - distance * normal_x))
        normal = np.array([normal_x * radial_x, normal_y, normal_x * radial_z])
        return distance, normal, 0.5 * (self.roll + other)

    def at(self, state: NDArray[Any], time: float) -> Instant:
        """Return what a state says at a time, and the forces of the law."""
        attitude = self.attitude @ _matrix(state[ATTITUDE])
        club_spin = attitude @ (self.inverse_inertia @ (state[CLUB_MOMENTUM] @ attitude))
        apart = state[BALL] - state[CLUB]
        place = apart @ attitude - self.lever
        distance, face_normal, curvature = self.nearest(place.tolist())
        normal = attitude @ face_normal
        _, upward, _ = face_normal.tolist()
        up = (attitude[:, 1] - upward * normal) / math.sqrt(1.0 - upward * upward)
        toe = _cross(normal, up)
        arm = -distance * normal
        point = apart + arm
        face_velocity = state[CLUB_VELOCITY] + _cross(club_spin, point)
        leaving = state[BALL_VELOCITY] - face_velocity
        sliding = leaving + _cross(state[BALL_SPIN], arm)
        rate = -float(normal @ leaving)
        depth = max(float(self.radius - distance), 0.0)
        _, high, towards = (place - distance * face_normal).tolist()
        slip_y, slip_z = state[SLIP].tolist()
        touch = Touch(
            depth, rate, float(sliding @ up), float(sliding @ toe), float(curvature), self.radius, float(time), slip_y,
            slip_z, high, towards,
        )  # fmt: skip
        if not all(map(math.isfinite, touch)):
            raise UnfinishedContactError(TOO_STIFF)
        own = dict(zip(self.states, state[LAW:].tolist(), strict=True))
        pressed, along_up, along_toe, *rates = checked_law(self.law, touch, self.values, own)
        self.has_pushed = self.has_pushed or pressed > 0.0
        pressed = max(pressed, 0.0)
        force = pressed * normal + along_up * up + along_toe * toe
        return Instant(touch, (pressed, along_up, along_toe), force, arm, point, club_spin, attitude, rates)

    def rate(self, time: float, state: NDArray[Any]) -> NDArray[Any]:
        """Return the derivative of a state by time."""
        now = self.at(state, time)
        result = np.empty(len(state))
        result[BALL] = state[BALL_VELOCITY]
        result[BALL_VELOCITY] = now.force / self.ball_mass
        result[BALL_SPIN] = _cross(now.arm, now.force) / self.ball_inertia
        result[CLUB] = state[CLUB_VELOCITY]
        result[CLUB_VELOCITY] = -now.force / self.club_mass
        result[CLUB_MOMENTUM] = -_cross(now.point, now.force)
        w, *v = state[ATTITUDE]
        turning, v = now.attitude.T @ now.club_spin, np.array(v)
        result[18] = -0.5 * (v @ turning)
        result[19:22] = 0.5 * (w * turning + _cross(v, turning))
        pressed, up, toe = now.forces
        result[22] = pressed * now.touch.rate
        result[23] = -(up * now.touch.sliding_y + toe * now.touch.sliding_z)
        result[SLIP] = now.touch.sliding_y, now.touch.sliding_z
        result[LAW:] = now.rates
        return result

    def kinetic_energy(self, state: NDArray[Any]) -> float:
        """Return the kinetic energy of both bodies [J]."""
        ball = self.ball_mass * (state[BALL_VELOCITY] @ state[BALL_VELOCITY])
        ball += self.ball_inertia * (state[BALL_SPIN] @ state[BALL_SPIN])
        club = self.club_mass * (state[CLUB_VELOCITY] @ state[CLUB_VELOCITY])
        attitude = self.attitude @ _matrix(state[ATTITUDE])
        momentum = state[CLUB_MOMENTUM] @ attitude
        return 0.5 * float(ball + club + momentum @ self.inverse_inertia @ momentum)

    def run(self, tolerance: float) -> Any:
        """Integrate to separation with a relative tolerance a step; return the solution of scipy.

        Raises
        ------
        RunError
            The law fails, or returns something else than three finite forces.
        UnfinishedContactError
            Ball and club do not part, or the law changes too sharply for its energy to be kept.
        """
        from scipy.integrate import solve_ivp

        approach = self.at(self.start, 0.0).touch.rate
        crossing = self.radius / approach
        turn = approach / self.radius
        sizes = [(BALL, self.radius), (BALL_VELOCITY, approach), (BALL_SPIN, turn), (CLUB, self.radius)]
        sizes += [(CLUB_VELOCITY, approach), (CLUB_MOMENTUM, self.ball_inertia * turn), (ATTITUDE, 1.0)]
        sizes += [(WORK, self.ball_mass * approach**2), (SLIP, 0.1 * self.radius)]
        scale = np.ones(len(self.start))
        for where, size in sizes:
            scale[where] = size
        scale[LAW:] = [*self.states.values()]
        count = 0

        def rate(time: float, state: NDArray[Any]) -> NDArray[Any]:
            nonlocal count
            count += 1
            if count > MOST_EVALUATIONS:
                raise UnfinishedContactError(TOO_STIFF)
            return self.rate(time, state)

        def parted(_time: float, state: NDArray[Any]) -> float:
            place = _matrix(state[ATTITUDE]).T @ (self.attitude.T @ (state[BALL] - state[CLUB]))
            return self.radius - self.nearest(place - self.lever)[0]

        parted.terminal, parted.direction = True, -1.0  # pyright: ignore[reportFunctionMemberAccess]
        result = solve_ivp(
            rate, (0.0, LONGEST), self.start, method="DOP853", rtol=tolerance, atol=tolerance * scale,
            first_step=1e-3 * crossing, max_step=0.1 * crossing, events=parted, dense_output=True,
        )  # fmt: skip
        if result.status == 0:
            raise UnfinishedContactError(STILL_TOUCHING if self.has_pushed else NEVER_PUSHES)
        end = result.y[:, -1]
        energy = self.kinetic_energy(self.start)
        kept = abs(self.kinetic_energy(end) + float(end[WORK].sum()) - energy) < MOST_ENERGY_ERROR * energy
        if result.status < 0 or not kept:
            raise UnfinishedContactError(TOO_STIFF)
        return result


class UnfinishedContactError(Exception):
    """A contact whose end was not computed; the message says why, and what to do."""


NEVER_PUSHES = (
    "its normal force is never above 0, so that nothing drives the ball away; a law must return a normal force above 0"
    " while the ball is compressed"
)
STILL_TOUCHING = (
    f"club and ball did not part within {LONGEST * 1e3:.0f} ms; check the stiffness and damping of the law (a drive"
    " lasts half a millisecond)"
)
TOO_STIFF = (
    "the law is too stiff or changes too sharply to be followed; check its stiffness (a driver's peak force is some"
    " 12 kN), damping and how sharply its friction changes"
)
UNFINISHED = {"never pushes": NEVER_PUSHES, "still touching": STILL_TOUCHING, "too stiff": TOO_STIFF}
"""What to say where the core has no launch."""
MOST_ENERGY_ERROR = 1e-2
"""Part of the energy that a computed contact may gain or lose against the work of its forces."""
FORCES = "a law must return three numbers: the normal force, and the friction up the face and towards the toe [N]"


def checked_law(law: Law, touch: Touch, values: Mapping[str, float], states: Mapping[str, float]) -> tuple[float, ...]:
    """Return the forces of a law and the rates of its states; refuse, each with its own sentence, what is no number."""
    try:
        returned = law(touch, values, states) if states else law(touch, values)
    except Exception as error:
        raise RunError(f"the law of contact fails at {touch}: {type(error).__name__}: {error}") from error
    try:
        results = tuple(map(float, _in_a_row(returned, states)))
    except (TypeError, ValueError):
        what = "one number" if isinstance(returned, numbers.Real) else "no numbers"
        raise RunError(f"the law of contact returned {what}, {returned!r}; {FORCES}") from None
    names = (*_FORCE_NAMES, *(f"rate of {name}" for name in states))
    for name, result in zip(names, results, strict=True):
        if not math.isfinite(result):
            raise RunError(f"the law of contact returned {result} as the {name} at {touch}; {FORCES}, all finite")
    return results


def _in_a_row(returned: Any, states: Mapping[str, Any]) -> Sequence[Any]:
    """Return forces and rates, one after the other."""
    results = tuple(returned)
    if not states:
        if len(results) != len(_FORCE_NAMES):
            raise RunError(f"the law of contact returned {len(results)} numbers, {returned!r}; {FORCES}")
        return results
    wanted = f"a law with states must return four things: three forces, and the rates of {', '.join(states)} by name"
    if len(results) != len(_FORCE_NAMES) + 1:
        raise RunError(f"the law of contact returned {len(results)} things, {returned!r}; {wanted}")
    *forces, rates = results
    if isinstance(rates, Mapping):
        if rates.keys() != states.keys():
            raise RunError(f"the law of contact returned rates of {', '.join(map(str, rates)) or 'nothing'}; {wanted}")
        rates = [rates[name] for name in states]
    if len(rates) != len(states):
        raise RunError(f"the law of contact returned {len(rates)} rates; {wanted}")
    return (*forces, *rates)


_FORCE_NAMES = ("normal force", "friction up the face", "friction towards the toe")


def _attitude(given: Mapping[str, float], hand: float) -> NDArray[Any]:
    """Return the rotation from face axes to world axes: lie, then square, then loft, then face angle."""
    tilted = _about_x(-given["lie"]) @ _about_z(given["static_loft"])
    x, y, z = tilted[:, 0]
    square = _about_y(math.atan2(z, x))
    raised = _about_z(given["loft"] - math.atan2(y, math.hypot(x, z)))
    return _about_y(-given["face"] * hand) @ raised @ square @ tilted


def _about_x(angle: float) -> NDArray[Any]:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])


def _about_y(angle: float) -> NDArray[Any]:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


def _about_z(angle: float) -> NDArray[Any]:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def _matrix(quaternion: NDArray[Any]) -> NDArray[Any]:
    """Return the rotation of a quaternion w, x, y, z of any size, which an integrator does not keep at 1."""
    w, x, y, z = quaternion.tolist()
    n = 2.0 / (w * w + x * x + y * y + z * z)
    return np.array([
        [1.0 - n * (y * y + z * z), n * (x * y - w * z), n * (x * z + w * y)],
        [n * (x * y + w * z), 1.0 - n * (x * x + z * z), n * (y * z - w * x)],
        [n * (x * z - w * y), n * (y * z + w * x), 1.0 - n * (x * x + y * y)],
    ])  # fmt: skip


def _cross(a: NDArray[Any], b: NDArray[Any]) -> NDArray[Any]:
    (p, q, r), (x, y, z) = a.tolist(), b.tolist()
    return np.array([q * z - r * y, r * x - p * z, p * y - q * x])


def _circle(x: float, y: float, k: float) -> tuple[float, float, float]:
    """Return signed distance from a circle of curvature ``k`` through the origin, and the normal there; k may be 0."""
    radial = 1.0 + k * x
    root = math.hypot(radial, k * y)
    return (2.0 * x + k * (x * x + y * y)) / (root + 1.0), radial / root, k * y / root
