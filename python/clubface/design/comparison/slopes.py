"""Derivatives of a launch and the flight after it at points of a line between two shots, by any model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.design.comparison.line import FACE, Line, Point
from clubface.equipment.backends import MODULES
from clubface.equipment.models import reduced_model
from clubface.errors import RunError
from clubface.simulation import core
from clubface.simulation.flight_derivatives import differentiated
from clubface.simulation.flight_inputs import BALL, SPIN, VELOCITY
from clubface.simulation.launch import Launch
from clubface.simulation.quantities import flight_inputs, inputs, outputs

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
        The launch at the end of the line, which tells model and equipment.
    shares
        Parts of the way.
    ball
        The ball, as a backend takes it.
    """
    if launch.model in MODULES:
        return (_of_elements(line, launch, share, ball) for share in shares)
    reduced_model(launch.model, "one with derivatives")
    return _reduced(line, launch, shares)


def flown(found: tuple[Array, Array], point: Point, names: Sequence[str], base: Mapping[str, float]) -> Array:
    """Return the slopes of the quantities of the flight, shape (quantities, names), by the chain rule.

    Parameters
    ----------
    found
        Outputs of the launch and their slopes.
    point
        The shot.
    names
        What the slopes are by.
    base
        The inputs of the flight; launch and ball are those of the point instead.
    """
    values, by_names = found
    places = {name: place for place, name in enumerate(outputs())}
    launched = (*VELOCITY, *SPIN)
    columns = {
        **base,
        **{name: float(values[places[name]]) for name in launched},
        **{name: point.inputs[name] for name in BALL},
    }
    jacobian = differentiated(columns).jacobian
    at = list(flight_inputs())
    chain = jacobian[:, [at.index(name) for name in launched]] @ by_names[[places[name] for name in launched]]
    for place, name in enumerate(names):
        if name in BALL:
            chain[:, place] += jacobian[:, at.index(name)]
    return chain


def _reduced(line: Line, launch: Launch, shares: Sequence[float]) -> Iterable[tuple[Array, Array]]:
    """Return what :func:`slopes` does, by dual numbers at all points at once."""
    points = [line.at(share) for share in shares]
    columns, parameters = _columns(points, "inputs"), _columns(points, "parameters")
    by_duals = [name for name in line.names if name not in FACE]
    order = [*inputs(), *launch.parameters.values]
    variables = [order.index(name) for name in by_duals]
    rows = list(range(len(outputs())))
    found, problems = core.sensitivities(
        launch.model, columns, parameters, len(points), rows, variables, launch.accuracy, 1
    )
    if problems:
        raise RunError(f"{launch.model} has no launch between the two: {problems[0][2]}")
    table = found.reshape(len(rows), 1 + len(variables), len(points))
    by_names = np.zeros((len(rows), len(line.names), len(points)))
    for place, name in enumerate(line.names):
        if name in by_duals:
            by_names[:, place] = table[:, 1 + by_duals.index(name)]
        else:
            by_names[:, place] = _by_steps(launch, columns, parameters, order.index(name), len(points))
    return [(table[:, 0, which], by_names[:, :, which]) for which in range(len(points))]


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
    known = variables(club, which=ball)
    if unknown := [name for name in line.names if name not in known]:
        raise RunError(f"finite elements of this head give no derivatives by {', '.join(unknown)}")
    delivered = {name: value for name, value in point.inputs.items() if inputs()[name].group == "delivery"}
    moved = {name: point.inputs[name] for name in line.names if name in point.inputs}
    found = sensitivity(
        club, {**delivered, **moved, "hand": point.inputs["hand"]}, by=line.names, which=ball,
        friction=point.parameters["friction"],
    )  # fmt: skip
    return np.array([found.values[name] for name in outputs()]), found.jacobian
