"""Contact under a user-defined law, integrated by SciPy in world axes for a right-hander, and the input of a law.

Clubhead and ball obey the Newton-Euler equations, with the momenta of both bodies and the angular momentum of the head
as states.
"""

from __future__ import annotations

import math
import numbers
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.errors import RunError
from clubface.simulation.pose import attitude, circle, face_point

HISTORY_POINTS = 201
"""Number of evenly spaced times of a history from first touch to separation."""


def launch_outputs(bodies: Any, solution: Any) -> NDArray[Any]:
    """Return the outputs of a contact in the order of the core."""
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
    """Return the peak normal force, refined between the neighbours of the largest step."""
    from scipy.optimize import minimize_scalar

    def force(time: float) -> float:
        return bodies.at(solution.sol(time), time).forces[0]

    steps = [bodies.at(state, time).forces[0] for state, time in zip(solution.y.T, solution.t, strict=True)]
    largest = steps.index(max(steps))
    near = solution.t[max(largest - 1, 0)], solution.t[min(largest + 1, len(steps) - 1)]
    best = minimize_scalar(lambda time: -force(time), bounds=near, method="bounded", options={"xatol": 1e-9})
    return max(steps[largest], -float(best.fun))  # pyright: ignore[reportAttributeAccessIssue]


def sample_history(bodies: Any, solution: Any) -> dict[str, NDArray[Any]]:
    """Return the time history of a contact, with the names of :class:`clubface.History`."""
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
"""Maximum duration of a contact [s]; a drive lasts half a millisecond."""
MOST_EVALUATIONS = 50_000
"""Maximum number of evaluations of a law per contact; a drive takes about 300."""


class Touch(NamedTuple):
    """Input of a contact law at one instant.

    Attributes
    ----------
    depth, rate
        Penetration of ball and face [m], 0 or more, and its rate [m/s], positive during compression.
    sliding_y, sliding_z
        Velocity of the ball's surface on the face [m/s], up the face and towards the toe.
    curvature
        Mean curvature of the face at the point of contact [1/m], 0 for a flat one.
    radius
        Radius of the ball [m].
    time
        Time since first touch [s].
    slip_y, slip_z
        Sliding distance of the ball's surface [m], up the face and towards the toe.
    high, toe
        Point of contact relative to the face centre [m], up the face and towards the toe.
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
"""Function of touch, parameters and states, if any. It returns the normal force and the friction on the ball up the
face and towards the toe [N], and the rates of the states."""

BALL, BALL_VELOCITY, BALL_SPIN, CLUB, CLUB_VELOCITY, CLUB_MOMENTUM = (slice(n, n + 3) for n in range(0, 18, 3))
ATTITUDE, WORK, SLIP = slice(18, 22), slice(22, 24), slice(24, 26)
LAW = 26
"""Index of the first state of the law."""


class Instant(NamedTuple):
    """Forces and kinematics at one instant, computed from the state of both bodies, in right-handed world axes."""

    touch: Touch
    forces: tuple[float, float, float]
    force: NDArray[Any]
    arm: NDArray[Any]
    point: NDArray[Any]
    club_spin: NDArray[Any]
    attitude: NDArray[Any]
    rates: Sequence[float]


class TwoBodies:
    """The equations of motion of a club and a ball, given by the inputs of a shot, under a contact law."""

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
        c, s = math.cos(given["static_loft"]), math.sin(given["static_loft"])
        reference = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        xx, yy, zz, xy, xz, yz = (given[name] for name in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz"))
        self.inertia = reference.T @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ reference
        self.inverse_inertia = np.linalg.inv(self.inertia)
        self.lever = reference.T @ np.array([given["cg_x"], given["cg_y"], given["cg_z"]])
        loft, face, lie, static_loft = (given[name] for name in ("loft", "face", "lie", "static_loft"))
        self.attitude = np.array(attitude(math, loft, face * self.hand, lie, static_loft)) @ reference
        self.start = self._start(given)

    def _start(self, given: Mapping[str, float]) -> NDArray[Any]:
        """Return the state at first touch, with the clubhead's CG at the origin."""
        attack, path, speed = given["attack"], given["path"] * self.hand, given["speed"]
        up, sideways = math.sin(attack), math.sin(path)
        point = np.array(face_point(math, given["toe"], given["high"], self.bulge, self.roll))
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

    def nearest(self, place: Sequence[float] | NDArray[Any]) -> tuple[float, NDArray[Any], float]:
        """Return the distance from the face, and normal and mean curvature at the nearest face point, in face axes."""
        x, y, z = place
        across, radial_x, radial_z = circle(math, x, z, self.bulge)
        distance, normal_x, normal_y = circle(math, across, y, self.roll)
        other = normal_x * self.bulge / (1.0 + self.bulge * (across - distance * normal_x))
        normal = np.array([normal_x * radial_x, normal_y, normal_x * radial_z])
        return distance, normal, 0.5 * (self.roll + other)

    def at(self, state: NDArray[Any], time: float) -> Instant:
        """Return the kinematics of a state at a time, with the forces of the law."""
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
        pressed, along_up, along_toe, *rates = evaluate_law(self.law, touch, self.values, own)
        self.has_pushed = self.has_pushed or pressed > 0.0
        pressed = max(pressed, 0.0)
        force = pressed * normal + along_up * up + along_toe * toe
        return Instant(touch, (pressed, along_up, along_toe), force, arm, point, club_spin, attitude, rates)

    def rate(self, time: float, state: NDArray[Any]) -> NDArray[Any]:
        """Return the time derivative of a state."""
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
        """Integrate to separation with a relative tolerance per step; return the solution object of SciPy.

        Raises RunError if the law fails or does not return three finite forces, UnfinishedContactError if ball and club
        do not separate or the law changes too sharply for its energy balance to close.
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
    """The contact could not be computed to its end; the message says why and what to do."""


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
"""Messages by the core's reason for not finishing a contact."""
MOST_ENERGY_ERROR = 1e-2
"""Maximum relative error of the energy balance of a computed contact."""
FORCES = "a law must return three numbers: the normal force, and the friction up the face and towards the toe [N]"


def evaluate_law(law: Law, touch: Touch, values: Mapping[str, float], states: Mapping[str, float]) -> tuple[float, ...]:
    """Return the forces of a law and the rates of its states; raise RunError for anything but finite numbers."""
    try:
        returned = law(touch, values, states) if states else law(touch, values)
    except Exception as error:
        raise RunError(f"the law of contact fails at {touch}: {type(error).__name__}: {error}") from error
    try:
        results = tuple(map(float, flatten_results(returned, states)))
    except (TypeError, ValueError):
        what = "one number" if isinstance(returned, numbers.Real) else "no numbers"
        raise RunError(f"the law of contact returned {what}, {returned!r}; {FORCES}") from None
    names = (*_FORCE_NAMES, *(f"rate of {name}" for name in states))
    for name, result in zip(names, results, strict=True):
        if not math.isfinite(result):
            raise RunError(f"the law of contact returned {result} as the {name} at {touch}; {FORCES}, all finite")
    return results


def flatten_results(returned: Any, states: Mapping[str, Any]) -> Sequence[Any]:
    """Return forces and rates as one sequence."""
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


def _matrix(quaternion: NDArray[Any]) -> NDArray[Any]:
    """Return the rotation matrix of a quaternion w, x, y, z, normalised since an integrator lets its length drift."""
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
