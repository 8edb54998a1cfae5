"""What makes the difference of two shots: contributions that add up to it, and what remains.

They are integrals of exact derivatives along the straight line from one shot to the other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.design.core import face_quantities
from clubface.equipment.backends import MODULES
from clubface.equipment.models import reduced_model
from clubface.errors import ClubfaceError, RunError
from clubface.simulation import core
from clubface.simulation.flight import BALL, SPIN, VELOCITY, Flight, flight_columns, fly
from clubface.simulation.launch import Launch
from clubface.simulation.results import Variable, flight_inputs, flight_outputs, inputs, outputs
from clubface.simulation.sensitivity import differentiated
from clubface.support.checks import check_choice

CURVED = ("bulge", "roll")
"""The line goes along their curvature, so that a flat face is one like any other."""
FACE = {"included_time": "characteristic_time"}
"""What has another name: both say how much more the face gives than the one that the parameters include."""
UNMOVED = ("face_width", "face_height")
"""They bound the face; no launch depends on them."""


class Point(NamedTuple):
    """One shot as its model takes it.

    Attributes
    ----------
    inputs, parameters
        The values [SI] by name.
    """

    inputs: dict[str, float]
    parameters: dict[str, float]

    @classmethod
    def of(cls, launch: Launch) -> Point:
        """Return the shot of a single launch."""
        given = {name: float(launch.input(name)) for name in inputs()}
        return cls(given, {name: float(value) for name, value in launch.parameters.values.items()})

    def value(self, name: str) -> float:
        """Return the value of an input or a parameter [SI]."""
        return self.inputs[name] if name in self.inputs else self.parameters[name]


class Line(NamedTuple):
    """The line between two shots by the same model.

    Attributes
    ----------
    start, end
        The shots.
    names
        The inputs and parameters that differ.
    """

    start: Point
    end: Point
    names: tuple[str, ...]

    @classmethod
    def between(cls, start: Point, end: Point) -> Line:
        """Return the line from one shot to another."""
        names = [name for name in (*start.inputs, *start.parameters) if name not in UNMOVED]
        return cls(start, end, tuple(name for name in names if start.value(name) != end.value(name)))

    def at(self, share: float) -> Point:
        """Return the shot at a ``share`` of the way."""
        moved = {name: self._value(name, share) for name in self.names}
        return Point(
            {name: moved.get(name, value) for name, value in self.end.inputs.items()},
            {name: moved.get(name, value) for name, value in self.end.parameters.items()},
        )

    def rates(self, share: float) -> Mapping[str, float]:
        """Return how fast each input and parameter that differs changes along the way, at a ``share`` of it."""
        rates = {}
        for name in self.names:
            first, last = self.start.value(name), self.end.value(name)
            rate = last - first
            if name in CURVED:
                rate = -(self._value(name, share) ** 2) * (1.0 / last - 1.0 / first)
            rates[name] = rate
        return rates

    def _value(self, name: str, share: float) -> float:
        first, last = self.start.value(name), self.end.value(name)
        if name in CURVED:
            first, last = 1.0 / first, 1.0 / last
        value = (1.0 - share) * first + share * last
        return 1.0 / value if name in CURVED else value


Array = NDArray[Any]
STEP = 1e-8
"""s by which the time of the face in the parameters is moved to find the slope by it, which models do not give."""


def slopes(line: Line, launch: Launch, shares: Sequence[float], ball: Any) -> Iterable[tuple[Array, Array]]:
    """Yield outputs of the launch, shape (outputs,), and their slopes, shape (outputs, names), at each of ``shares``.

    Parameters
    ----------
    line
        Where to go along; the slopes are by its names, in SI.
    launch
        The launch at the end of the line, which has model and equipment.
    shares
        Parts of the way.
    ball
        The ball, as a backend takes it.
    """
    if launch.model in MODULES:
        return (_of_elements(line, launch, share, ball) for share in shares)
    reduced_model(launch.model, "one with derivatives")
    return _reduced(line, launch, shares)


def flown(launch_slopes: tuple[Array, Array], point: Point, names: Sequence[str], base: Mapping[str, float]) -> Array:
    """Return the slopes of ``FLOWN``, the quantities of the flight, shape (quantities, names), by the chain rule.

    Parameters
    ----------
    launch_slopes
        Outputs of the launch and their slopes.
    point
        The shot.
    names
        What the slopes are by.
    base
        The inputs of the flight; launch and ball are those of the point instead.
    """
    values, by_names = launch_slopes
    places = {name: place for place, name in enumerate(outputs())}
    launched = (*VELOCITY, *SPIN)
    columns = {
        **base,
        **{name: float(values[places[name]]) for name in launched},
        **{name: point.inputs[name] for name in BALL},
    }
    _, jacobian = differentiated(columns)
    at = list(flight_inputs())
    chain = jacobian[:, [at.index(name) for name in launched]] @ by_names[[places[name] for name in launched]]
    for place, name in enumerate(names):
        if name in BALL:
            chain[:, place] += jacobian[:, at.index(name)]
    rows = dict(zip(flight_outputs(), chain, strict=True))
    return np.array([rows[name] for name in FLOWN])


def _reduced(line: Line, launch: Launch, shares: Sequence[float]) -> Iterable[tuple[Array, Array]]:
    """Return what :func:`slopes` does, by dual numbers at all points at once."""
    points = [line.at(share) for share in shares]
    columns, parameters = _columns(points, "inputs"), _columns(points, "parameters")
    by_duals = [name for name in line.names if name not in FACE]
    order = [*inputs(), *launch.parameters.values]
    variables = [order.index(name) for name in by_duals]
    rows = list(range(len(outputs())))
    result, problems = core.sensitivities(
        launch.model, columns, parameters, len(points), rows, variables, launch.accuracy, 1
    )
    if problems:
        first, last = (each.value("characteristic_time") for each in (line.start, line.end))
        if first != last and 0.0 in (first, last):
            time = units.show(max(first, last), "us")
            faces = (f"gives ({time})", "is taken as rigid")
            of_first, of_last = faces if first else faces[::-1]
            raise RunError(
                f"the face of the first {of_first}, that of {launch.club.name} {of_last}; state the"
                " characteristic_time of both in their files"
            )
        raise RunError(f"{launch.model} has no launch between the two: {problems[0][2]}")
    table = result.reshape(len(rows), 1 + len(variables), len(points))
    by_names = np.zeros((len(rows), len(line.names), len(points)))
    for place, name in enumerate(line.names):
        if name in by_duals:
            by_names[:, place] = table[:, 1 + by_duals.index(name)]
        else:
            by_names[:, place] = _by_steps(launch, columns, parameters, order.index(name), len(points))
    return [(table[:, 0, number], by_names[:, :, number]) for number in range(len(points))]


def _by_steps(launch: Launch, columns: list[Array], parameters: list[Array], place: int, count: int) -> Array:
    """Return the slope of every output by one input, by a central difference."""
    sides = []
    for side in (1.0, -1.0):
        moved = [each + side * STEP if index == place else each for index, each in enumerate(columns)]
        sides.append(core.impact(launch.model, moved, parameters, count, launch.accuracy, 1)[0])
    return (sides[0] - sides[1]) / (2.0 * STEP)


def _columns(points: Sequence[Point], group: str) -> list[Array]:
    return [np.array([getattr(point, group)[name] for point in points]) for name in getattr(points[0], group)]


def _of_elements(line: Line, launch: Launch, share: float, ball: Any) -> tuple[Array, Array]:
    """Return the launch and its slopes by one set of runs with dual numbers."""
    from clubface.fem.derivatives import sensitivity, variables
    from clubface.fem.heads import ShellHead
    from clubface.fem.heads.meshed import mesh_of

    point, head = line.at(share), mesh_of(launch.club)
    if head is not None and not isinstance(head, ShellHead):
        raise RunError("finite elements give derivatives for rigid heads and heads of shells, not of solids")
    club = launch.club if head is None else head
    known = variables(club, ball=ball)
    if unknown := [name for name in line.names if name not in known]:
        raise RunError(f"finite elements of this head give no derivatives by {', '.join(unknown)}")
    delivered = {name: value for name, value in point.inputs.items() if inputs()[name].group == "delivery"}
    moved = {name: point.inputs[name] for name in line.names if name in point.inputs}
    result = sensitivity(
        club, {**delivered, **moved, "hand": point.inputs["hand"]}, by=line.names, ball=ball,
        friction=point.parameters["friction"],
    )  # fmt: skip
    return np.array([result.values[name] for name in outputs()]), result.jacobian


_NAMES, _LAUNCHED = face_quantities()
LAUNCHED: tuple[str, ...] = tuple(_NAMES[:_LAUNCHED])
FLOWN: tuple[str, ...] = tuple(_NAMES[_LAUNCHED:])
QUANTITIES: tuple[str, ...] = (*LAUNCHED, *FLOWN)
"""In the order of all tables."""


def quantities() -> dict[str, Variable]:
    """Return the quantities by name, with units and meanings."""
    known = {**Flight.quantities(), **outputs()}
    return {name: known[name] for name in QUANTITIES}


def symbol(quantity: str, unit: str) -> str:
    """Return the symbol of a unit that a person names for a quantity; one of another dimension is an error."""
    return units.unit(unit, name=quantity, dimension=quantities()[quantity].dimension).symbol


def values(launch: Launch, flight: Flight) -> NDArray[Any]:
    """Return ``QUANTITIES`` of a single launch and its flight [SI]."""
    return np.array([float((launch if name in LAUNCHED else flight).get(name)) for name in QUANTITIES])


NODES = {False: 8, True: 1}
"""Points of the line at which a launch is differentiated, unless given: of a model that takes long the middle alone."""


class Change(NamedTuple):
    """One thing that differs between two shots.

    Attributes
    ----------
    name
        An input, a parameter, or what is changed as a whole: "model", "hand", "ball" or "head".
    start, end
        Its values [SI]; None for what is changed as a whole.
    derivative
        Whether its contribution comes from derivatives; otherwise it is the difference that the whole change makes.
    """

    name: str
    start: float | None
    end: float | None
    derivative: bool


class Contributions(NamedTuple):
    """The difference between two shots, split.

    Attributes
    ----------
    changes
        What differs.
    si
        What each of the ``changes`` contributes to each of ``QUANTITIES`` [SI], shape (changes, quantities).
    remainder
        What remains of the difference [SI], shape (quantities,).
    nodes
        Points of the line at which the launch was differentiated.
    left_out
        Why there are no contributions, or "".
    """

    changes: tuple[Change, ...]
    si: NDArray[Any]
    remainder: NDArray[Any]
    nodes: int
    left_out: str = ""

    def of(self, name: str, quantity: str) -> float:
        """Return what the change called ``name`` contributes to a quantity [SI]."""
        names = [each.name for each in self.changes]
        check_choice("change", name, names)
        check_choice("quantity", quantity, QUANTITIES)
        return float(self.si[names.index(name), QUANTITIES.index(quantity)])


class Stage(NamedTuple):
    """A shot on the way from one to the other.

    Attributes
    ----------
    name
        What has been changed as a whole since the stage before.
    launch
        The launch then.
    """

    name: str
    launch: Launch


def contributions(
    stages: list[Stage],
    last: Launch,
    conditions: Mapping[str, Any],
    *,
    ball: Any,
    nodes: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Contributions:
    """Split the difference between the launch ``last`` and the first of the ``stages``.

    What has no derivatives is changed first, from stage to stage. From the last stage a straight line leads to ``last``
    through all inputs and parameters, and along it the exact derivatives are integrated by Gauss's rule.

    Parameters
    ----------
    stages
        The first shot, and every shot after something was changed as a whole.
    last
        The other shot, by the model of the last stage.
    conditions
        Air, wind and ground, as for :func:`clubface.fly`.
    ball
        The ball of ``last``, as a model takes it.
    nodes
        Points at which the launch is differentiated; left out, 8, or 1 for a model that takes long.
    progress
        Called with the points that are done and all points.
    """
    *levels, end = (values(each, fly(each, **conditions)) for each in (*(stage.launch for stage in stages), last))
    changes = [Change(each.name, None, None, False) for each in stages[1:]]
    parts = [after - before for before, after in pairwise(levels)]
    line = Line.between(Point.of(stages[-1].launch), Point.of(last))
    count = nodes or NODES[last.model in MODULES]
    if line.names:
        try:
            along = _integrated(line, last, conditions, count, ball, progress)
        except ClubfaceError as error:
            empty = np.empty((0, len(QUANTITIES)))
            return Contributions((), empty, end - levels[0], count, str(error))
        named = [name for name in line.names if FACE.get(name) not in line.names]
        for name in named:
            same = [place for place, each in enumerate(line.names) if FACE.get(each, each) == FACE.get(name, name)]
            changes.append(Change(name, line.start.value(name), line.end.value(name), True))
            parts.append(along[same].sum(axis=0))
    si = np.array(parts).reshape(len(changes), len(QUANTITIES))
    return Contributions(tuple(changes), si, end - levels[0] - si.sum(axis=0), count)


def _integrated(
    line: Line,
    last: Launch,
    conditions: Mapping[str, Any],
    nodes: int,
    ball: Any,
    progress: Callable[[int, int], object] | None,
) -> NDArray[Any]:
    """Return what each name of the line contributes to each quantity, shape (names, quantities)."""
    places, weights = np.polynomial.legendre.leggauss(nodes)
    shares = 0.5 + 0.5 * places
    base, _, _ = flight_columns(last, conditions.get("air"), conditions.get("wind"), conditions.get("ground"))
    launched = [list(outputs()).index(name) for name in LAUNCHED]
    total = np.zeros((len(QUANTITIES), len(line.names)))
    for done, (share, weight, launch_slopes) in enumerate(
        zip(shares.tolist(), weights.tolist(), slopes(line, last, shares.tolist(), ball), strict=True), 1
    ):
        rates = np.array(list(line.rates(share).values()))
        by_flight = flown(launch_slopes, line.at(share), line.names, base)
        total += 0.5 * weight * np.concatenate([launch_slopes[1][launched], by_flight]) * rates
        if progress is not None:
            progress(done, nodes)
    return total.T
