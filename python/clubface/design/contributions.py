"""What makes two shots differ: contributions that add up to the difference, except for a small remainder.

Each is the integral of exact derivatives along the straight line from one shot to the other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from clubface import _core as core, units
from clubface.equipment.models import MODULES, reduced_model
from clubface.errors import ClubfaceError, RunError
from clubface.simulation.flight import BALL, SPIN, VELOCITY, Flight, flight_columns, fly
from clubface.simulation.launch import Launch
from clubface.simulation.results import Variable, flight_inputs, flight_outputs, inputs, outputs
from clubface.simulation.sensitivity import differentiated
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice

CURVED = ("bulge", "roll")
"""Radii that the line interpolates as curvatures, so that a flat face is no special case."""
FACE = {"included_time": "characteristic_time"}
"""Parameters counted together with an input: both say how much more the face flexes than the parameters assume."""
UNMOVED = ("face_width", "face_height")
"""Inputs that only bound the face; no launch depends on them."""
STEP = 1e-8
"""Step [s] of the finite difference with respect to the parameters' face time, which models do not differentiate."""
NODES = {False: 8, True: 1}
"""Default number of points at which a launch is differentiated: a slow model only gets the middle."""

_NAMES, _LAUNCHED = core.face_quantities()
LAUNCHED: tuple[str, ...] = tuple(_NAMES[:_LAUNCHED])
FLOWN: tuple[str, ...] = tuple(_NAMES[_LAUNCHED:])
QUANTITIES: tuple[str, ...] = (*LAUNCHED, *FLOWN)
"""All quantities, in the order used in every table."""

Shot = Mapping[str, float]
"""A shot as its model takes it: inputs and parameters [SI] by name."""


def quantities() -> dict[str, Variable]:
    """Return the quantities by name, with units and meanings."""
    known = {**Flight.quantities(), **outputs()}
    return {name: known[name] for name in QUANTITIES}


def symbol(quantity: str, unit: str) -> str:
    """Return the symbol of a unit given for a quantity; raise an error if its dimension does not match."""
    return units.unit(unit, name=quantity, dimension=quantities()[quantity].dimension).symbol


def values(launch: Launch, flight: Flight) -> Floats:
    """Return ``QUANTITIES`` of a single launch and its flight [SI]."""
    return np.array([float((launch if name in LAUNCHED else flight).get(name)) for name in QUANTITIES])


class Line(NamedTuple):
    """The straight line between two shots of one model, in the inputs and parameters that differ."""

    start: Shot
    end: Shot
    names: tuple[str, ...]

    @classmethod
    def between(cls, start: Launch, end: Launch) -> Line:
        """Return the line between two single launches."""
        first, last = (
            {name: float(each.input(name)) for name in inputs()}
            | {name: float(value) for name, value in each.parameters.values.items()}
            for each in (start, end)
        )
        return cls(first, last, tuple(name for name in first if name not in UNMOVED and first[name] != last[name]))

    def at(self, share: float) -> dict[str, float]:
        """Return the shot at a ``share`` (0 to 1) of the way."""
        return {**self.end, **{name: self._value(name, share) for name in self.names}}

    def rates(self, share: float) -> Floats:
        """Return the derivative of each differing input and parameter with respect to ``share``."""
        rates = []
        for name in self.names:
            first, last = self.start[name], self.end[name]
            is_curved = name in CURVED
            rates.append(-(self._value(name, share) ** 2) * (1.0 / last - 1.0 / first) if is_curved else last - first)
        return np.array(rates)

    def _value(self, name: str, share: float) -> float:
        first, last = self.start[name], self.end[name]
        if name in CURVED:
            first, last = 1.0 / first, 1.0 / last
        value = (1.0 - share) * first + share * last
        return 1.0 / value if name in CURVED else value


def _slopes(line: Line, launch: Launch, shares: Sequence[float], ball: Any) -> Iterable[tuple[Floats, Floats]]:
    """Yield the launch outputs, shape (outputs,), and their slopes [SI], shape (outputs, names), at each share."""
    if launch.model in MODULES:
        return (_finite_element_slopes(line, launch, share, ball) for share in shares)
    reduced_model(launch.model, "one with derivatives")
    return _slopes_by_duals(line, launch, shares)


def _flight_slopes(
    launch_slopes: tuple[Floats, Floats], shot: Shot, names: Sequence[str], base: Mapping[str, float]
) -> Floats:
    """Return the slopes of ``FLOWN`` by the chain rule, shape (quantities, names).

    ``base`` holds the flight inputs; launch and ball are replaced by those of the shot.
    """
    outcome, by_names = launch_slopes
    places = {name: place for place, name in enumerate(outputs())}
    launched = (*VELOCITY, *SPIN)
    moved = {name: float(outcome[places[name]]) for name in launched} | {name: shot[name] for name in BALL}
    _, jacobian = differentiated({**base, **moved})
    at = list(flight_inputs())
    chain = jacobian[:, [at.index(name) for name in launched]] @ by_names[[places[name] for name in launched]]
    for place, name in enumerate(names):
        if name in BALL:
            chain[:, place] += jacobian[:, at.index(name)]
    rows = dict(zip(flight_outputs(), chain, strict=True))
    return np.array([rows[name] for name in FLOWN])


def _slopes_by_duals(line: Line, launch: Launch, shares: Sequence[float]) -> Iterable[tuple[Floats, Floats]]:
    """Return the same as :func:`_slopes` with dual numbers, for all points at once."""
    shots = [line.at(share) for share in shares]
    columns, parameters = (
        [np.array([shot[name] for shot in shots]) for name in names] for names in (inputs(), launch.parameters.values)
    )
    by_duals = [name for name in line.names if name not in FACE]
    order = [*inputs(), *launch.parameters.values]
    rows = list(range(len(outputs())))
    result, problems = core.sensitivities(
        launch.model, columns, parameters, len(shots), rows, [order.index(name) for name in by_duals], launch.accuracy,
        1,
    )  # fmt: skip
    if problems:
        first, last = (each["characteristic_time"] for each in (line.start, line.end))
        if first != last and 0.0 in (first, last):
            time = units.show(max(first, last), "us")
            faces = (f"gives ({time})", "is assumed rigid")
            of_first, of_last = faces if first else faces[::-1]
            raise RunError(
                f"the face of the first club {of_first}, the face of {launch.club.name} {of_last}; give the"
                " characteristic_time of both in their files"
            )
        raise RunError(f"{launch.model} gives no launch between the two shots: {problems[0][2]}")
    table = result.reshape(len(rows), 1 + len(by_duals), len(shots))
    by_names = np.zeros((len(rows), len(line.names), len(shots)))
    for place, name in enumerate(line.names):
        if name in by_duals:
            by_names[:, place] = table[:, 1 + by_duals.index(name)]
            continue
        sides = []  # a central difference
        for side in (1.0, -1.0):
            moved = list(columns)
            moved[order.index(name)] = moved[order.index(name)] + side * STEP
            sides.append(core.impact(launch.model, moved, parameters, len(shots), launch.accuracy, 1)[0])
        by_names[:, place] = (sides[0] - sides[1]) / (2.0 * STEP)
    return [(table[:, 0, number], by_names[:, :, number]) for number in range(len(shots))]


def _finite_element_slopes(line: Line, launch: Launch, share: float, ball: Any) -> tuple[Floats, Floats]:
    """Return the launch and its slopes from one set of finite element runs with dual numbers."""
    from clubface.fem.heads import ShellHead
    from clubface.fem.heads.meshed import mesh_of
    from clubface.fem.run import sensitivity, variables

    shot, head = line.at(share), mesh_of(launch.club)
    if head is not None and not isinstance(head, ShellHead):
        raise RunError("finite elements give derivatives for rigid heads and heads of shells, not of solids")
    club = launch.club if head is None else head
    known = variables(club, ball=ball)
    if unknown := [name for name in line.names if name not in known]:
        raise RunError(f"finite elements of this head give no derivatives by {', '.join(unknown)}")
    given = [name for name, each in inputs().items() if each.group == "delivery" or name in line.names]
    result = sensitivity(
        club, {**{name: shot[name] for name in given}, "hand": shot["hand"]}, by=line.names, ball=ball,
        friction=shot["friction"],
    )  # fmt: skip
    return np.array([result.values[name] for name in outputs()]), result.jacobian


class Change(NamedTuple):
    """One thing that differs between two shots.

    Attributes
    ----------
    name
        An input, a parameter, or "model", "hand", "ball" or "head", which change in one step.
    start, end
        Its values [SI]; None for a change in one step.
    derivative
        Whether its contribution comes from derivatives; otherwise it is the difference made by the step.
    """

    name: str
    start: float | None
    end: float | None
    derivative: bool


class Contributions(NamedTuple):
    """The difference between two shots, split into contributions.

    Attributes
    ----------
    changes, si
        What differs, and its contribution to each of ``QUANTITIES`` [SI], shape (changes, quantities).
    remainder
        Difference that the contributions leave unexplained [SI], shape (quantities,).
    nodes
        Number of points on the line at which the launch was differentiated.
    left_out
        Why there are no contributions, or "".
    """

    changes: tuple[Change, ...]
    si: Floats
    remainder: Floats
    nodes: int
    left_out: str = ""

    def of(self, name: str, quantity: str) -> float:
        """Return the contribution of the change ``name`` to a quantity [SI]."""
        names = [each.name for each in self.changes]
        check_choice("change", name, names)
        check_choice("quantity", quantity, QUANTITIES)
        return float(self.si[names.index(name), QUANTITIES.index(quantity)])


def contributions(
    stages: Sequence[tuple[str, Launch]],
    last: Launch,
    conditions: Mapping[str, Any],
    *,
    ball: Any,
    nodes: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Contributions:
    """Split the difference between the launch ``last`` and the first of the ``stages``.

    Changes without derivatives come first, from stage to stage. From the last stage a straight line in all inputs and
    parameters leads to ``last``; the exact derivatives are integrated along it by Gauss's rule.

    ``stages`` holds the first shot and the shot after each change without derivatives, with the name of the change;
    ``last`` uses the model of the final stage, ``ball`` is its ball as a model takes it, and the launch is
    differentiated at ``nodes`` points (default ``NODES``).
    """
    *levels, end = (values(each, fly(each, **conditions)) for each in (*(launch for _, launch in stages), last))
    changes = [Change(name, None, None, False) for name, _ in stages[1:]]
    parts = [after - before for before, after in pairwise(levels)]
    line = Line.between(stages[-1][1], last)
    count = nodes or NODES[last.model in MODULES]
    if line.names:
        try:
            along = _integrate_slopes(line, last, conditions, count, ball, progress)
        except ClubfaceError as error:
            empty = np.empty((0, len(QUANTITIES)))
            return Contributions((), empty, end - levels[0], count, str(error))
        named = [name for name in line.names if FACE.get(name) not in line.names]
        for name in named:
            same = [place for place, each in enumerate(line.names) if FACE.get(each, each) == FACE.get(name, name)]
            changes.append(Change(name, line.start[name], line.end[name], True))
            parts.append(along[same].sum(axis=0))
    si = np.array(parts).reshape(len(changes), len(QUANTITIES))
    return Contributions(tuple(changes), si, end - levels[0] - si.sum(axis=0), count)


def _integrate_slopes(
    line: Line,
    last: Launch,
    conditions: Mapping[str, Any],
    nodes: int,
    ball: Any,
    progress: Callable[[int, int], object] | None,
) -> Floats:
    """Return the contribution of each name of the line to each quantity, shape (names, quantities)."""
    places, weights = np.polynomial.legendre.leggauss(nodes)
    shares = 0.5 + 0.5 * places
    base, _, _ = flight_columns(last, conditions.get("air"), conditions.get("wind"), conditions.get("ground"))
    launched = [list(outputs()).index(name) for name in LAUNCHED]
    total = np.zeros((len(QUANTITIES), len(line.names)))
    for done, (share, weight, launch_slopes) in enumerate(
        zip(shares.tolist(), weights.tolist(), _slopes(line, last, shares.tolist(), ball), strict=True), 1
    ):
        by_flight = _flight_slopes(launch_slopes, line.at(share), line.names, base)
        total += 0.5 * weight * np.concatenate([launch_slopes[1][launched], by_flight]) * line.rates(share)
        if progress is not None:
            progress(done, nodes)
    return total.T
