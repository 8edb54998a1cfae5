"""Impacts and flights as external functions of CasADi, with exact Jacobians: C source over ``libclubface``.

CasADi loads a shared library with a function ``impact``, its sizes (``impact_n_in``, ``impact_sparsity_in``, ...) and
its Jacobian ``jac_impact``, in the form of the C code that CasADi itself generates (J. A. E. Andersson and others,
CasADi: a software framework for nonlinear optimization and optimal control, *Mathematical Programming Computation* 11,
2019; its manual, "Using external functions"). Programs that accept such functions, such as bioptim and acados, accept
these.
"""

from __future__ import annotations

import importlib.resources
import math
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from string import Template
from typing import Any

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL, reduced_model
from clubface.errors import InputError, Wording
from clubface.simulation.differentiable import ROUGH, Differentiable, FlightFunction, LaunchFunction
from clubface.simulation.flight import BALL, AirLike, GroundLike, WindLike, conditions
from clubface.simulation.impact import Parameters
from clubface.simulation.inputs import OF_CLUB, HandLike
from clubface.simulation.results import flight_inputs, flight_outputs, inputs, outputs
from clubface.support.arrays import ValueLike
from clubface.support.version import __version__

LAUNCHED = ("velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z")
"""The launch quantities that a flight depends on."""


def casadi_source(
    club: str | os.PathLike[str] | Club,
    delivery: Mapping[str, ValueLike] | None = None,
    *,
    variables: Iterable[str] | None = None,
    quantities: Iterable[str] | None = None,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: HandLike | None = None,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
) -> str:
    """Return C source of the functions ``impact`` and ``flight`` for ``casadi.external``, with exact Jacobians.

    ``impact`` takes a vector of the variables and returns a vector of the launch quantities; ``flight`` takes velocity
    and spin of the ball (world axes) and returns the flight quantities; all SI and radians. Quantities that jump with
    the number of bounces, such as the total, are left out. Second derivatives, if the model has them (see
    :mod:`clubface.jax`), are differences of the exact first ones. Both functions are thread-safe. A shot that cannot be
    computed makes the call fail, with the reason on the error stream. The source is compiled with ``libclubface``; its
    first comment says how.

    Parameters
    ----------
    club, model, parameters, ball, accuracy, hand
        As for :func:`clubface.impact`.
    delivery
        Fixed values by name, SI or text with a unit.
    variables
        Names of the inputs and parameters that the function takes, in order. Default: the delivery of the club, except
        for the values fixed by ``delivery``.
    quantities
        Names of the launch quantities returned, in order. Default: all that the model computes.
    air, wind, ground
        As for :func:`clubface.fly`.

    Raises
    ------
    InputError
        A name or value is unknown or not allowed, or derivatives with respect to a variable do not exist.
    """
    fixed = dict(delivery or {})
    names = tuple(name for name in OF_CLUB if name not in fixed) if variables is None else tuple(variables)
    if not names:
        raise InputError("variables", Wording("empty"), "one or more inputs or parameters")
    for name in names:
        if name in fixed or names.count(name) > 1:
            both = "both given and a variable" if name in fixed else "a variable twice"
            raise InputError(name, Wording(both), "either a fixed value or one variable")
    described = reduced_model(model, "one with derivatives")
    impact = LaunchFunction(
        club, fixed, names, model=model, parameters=parameters, ball=ball, accuracy=accuracy, hand=hand,
        outputs=quantities,
    )  # fmt: skip
    if impact.shape:
        raise InputError("delivery", Wording("an array"), "single numbers; name what varies in variables")
    parameter_names = tuple(each.name for each in described.parameters)
    known = {**inputs(), **{each.name: each for each in described.parameters}}
    numbers = {
        name: 0.0 if name in impact.variables else value for name, value in zip(known, impact.columns, strict=True)
    }
    flown = {name: each.default for name, each in flight_inputs().items()}
    flown |= {name: numbers[name] for name in BALL} | conditions(air, wind, ground) | dict.fromkeys(LAUNCHED, 0.0)
    flight = FlightFunction(
        flown, [*LAUNCHED, *(name for name in BALL if name in impact.variables)],
        outputs=[name for name in flight_outputs() if name not in ROUGH],
    )  # fmt: skip
    vectors = {
        "delivery": [known[name] for name in impact.variables],
        "launch": [outputs()[name] for name in impact.outputs],
        "velocity and spin": [flight_inputs()[name] for name in flight.variables],
        "flight": [flight_outputs()[name] for name in flight.outputs],
    }
    head = _template(
        "head",
        title=f"{impact.club.name} and {impact.ball.name} by the model {model}".replace("*/", ""),
        version=__version__, model=model, tolerance=repr(impact.accuracy or 0.0),
        tables="\n".join(line for title, each in vectors.items() for line in _list_elements(title, each)),
        inputs=len(inputs()), outputs=len(outputs()), flight_inputs=len(flown), flight_outputs=len(flight_outputs()),
        parameters=len(parameter_names), fixed=_values({name: numbers[name] for name in inputs()}),
        parameter_values=_values({name: numbers[name] for name in parameter_names}), flight_fixed=_values(flown),
    )  # fmt: skip
    parts = [
        head,
        *_function("impact", impact, argument="delivery", result="launch"),
        *_function("flight", flight, argument="launch", result="flight"),
    ]
    return "\n".join(parts)


def _template(part: str, /, **values: Any) -> str:
    """Return a part of the source with its values filled in."""
    text = importlib.resources.files("clubface").joinpath("data", "casadi", f"{part}.c").read_text(encoding="utf-8")
    return Template(text).substitute(values)


def _function(name: str, function: Differentiable, *, argument: str, result: str) -> Iterator[str]:
    """Yield the source of a function and of its derivatives."""
    yield _template(
        "tables", name=name, width=len(function.places), height=len(function.rows),
        variables=", ".join(map(str, function.places)), rows=", ".join(map(str, function.rows)),
    )  # fmt: skip
    yield _template(name)
    yield _template("function", name=name, argument=argument, result=result)
    if not function.once:
        yield _template("second", name=name, sizes=", ".join(map(_number, function.sizes)), step=repr(function.step))


def _list_elements(title: str, variables: Sequence[Any]) -> list[str]:
    """Return comment lines that list the elements of a vector."""
    return [
        f" * {title}:",
        *(f" *   {i:2} {each.name} [{each.unit}]: {each.meaning}" for i, each in enumerate(variables)),
    ]


def _values(values: Mapping[str, float]) -> str:
    """Return the elements of a C array, each with its name."""
    return "\n".join(f"  {_number(value)}, /* {name} */" for name, value in values.items())


def _number(value: float) -> str:
    value = float(value)
    return repr(value) if math.isfinite(value) else "INFINITY" if value > 0.0 else "-INFINITY"
