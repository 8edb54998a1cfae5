"""A law of contact of one's own, written in Python and used wherever a model is named."""

from __future__ import annotations

import inspect
import marshal
import math
import os
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.backends import MODULES, OWN
from clubface.equipment.models import Model, Parameter, models
from clubface.errors import InputError, RunError
from clubface.simulation import core
from clubface.simulation.backends import Balls, Problems, Request
from clubface.simulation.inputs import forget_parameters
from clubface.simulation.quantities import inputs, outputs
from clubface.support.checks import check_text

if TYPE_CHECKING:
    from clubface.simulation.contact_motion import Law

USUAL_TOLERANCE = 1e-7
"""Of a step, where no accuracy is given: the launch is then correct to 1e-5 or better."""
HISTORY_POINTS = 201
"""Times of a history, evenly spaced from first touch to separation."""
CHECKED_BY = "standard"
"""The model whose checks of deliveries, clubs and balls are used; they are the same for all."""


def register_law(
    name: str,
    law: Law,
    *,
    parameters: Mapping[str, str | float | Parameter] | None = None,
    title: str = "",
    summary: str = "A law of contact of one's own.",
    reference: str = "",
) -> Model:
    """Make a law of contact, written in Python, a model that :func:`impact` and :func:`history` know by ``name``.

    Clubhead and ball are two free rigid bodies; the law says what forces act between them, and scipy's ``solve_ivp``
    follows the motion until they part. The law describes ball and face together, so that the characteristic time of
    the club is not used. It is known in this process alone, and registering a name again replaces its law. It takes
    10 to 25 ms a shot and has no exact derivatives: a model for every day is a file in Rust.

    Parameters
    ----------
    name
        A word that no other model has.
    law
        Called as ``law(touch, values)`` with a :class:`Touch` and the values of the parameters by name [SI]; returns
        the normal force on the ball, and the friction on the ball up the face and towards the toe [N]. A negative
        normal force counts as zero.
    parameters
        Default of each parameter by its name: text with a unit, an SI number, or a :class:`Parameter` with meaning,
        bounds and source.
    title, summary, reference
        As of a :class:`Model`.

    Returns
    -------
    Model
        Its description.

    Raises
    ------
    InputError
        The name is that of a model of the package or of none, the law cannot be called, or a default is no number.
    """
    if not (isinstance(name, str) and name.isidentifier()):
        raise InputError("name", name, "a word of letters, digits and underscores")
    if name in models() or name in MODULES or name == "all":
        raise InputError("name", name, "one that no model of the package has")
    if not callable(law):
        raise InputError("law", law, "a function of a Touch and the values of the parameters")
    for what, text in (("title", title), ("summary", summary), ("reference", reference)):
        check_text(what, text)
    if not isinstance(parameters, Mapping | None):
        raise InputError("parameters", parameters, 'values by name, as in {"stiffness": "3e6 N/m"}')
    declared = tuple(_parameter(key, value) for key, value in (parameters or {}).items())
    model = Model(
        name=name, title=title or name, kind="contact", summary=summary, reference=reference,
        laws=("momentum", "angular_momentum"), laws_without=None, parameters=declared,
    )  # fmt: skip
    OWN[name] = SimpleNamespace(MODEL=model, BACKEND=OwnLaw(model, law))
    forget_parameters()
    return model


def source_of(model: str) -> list[str]:
    """Return what tells one's own law from another of its name: the file it stands in, else its code; of others [].

    A store of unfinished work must not mix the results of a law with those of what it was before it was edited.
    """
    if model not in OWN:
        return []
    law = OWN[model].BACKEND.law
    function = law if inspect.isroutine(law) else type(law).__call__
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


class OwnLaw:
    """A shot at a time, each by scipy."""

    def __init__(self, model: Model, law: Law) -> None:
        self.model, self.law = model, law

    def balls(self, given: Any, accuracy: float | None) -> Balls:
        """Return the ball as it is."""
        return Balls(None, given)

    def launches(self, shots: Request) -> tuple[NDArray[Any], Problems]:
        """Follow one contact after the other; what every model refuses is refused, and a contact without an end."""
        usual = [each.default for each in models()[CHECKED_BY].parameters]
        _, problems = core.impact(CHECKED_BY, shots.inputs, usual, shots.size, None, shots.threads, None)
        refused = {row for row, *_ in problems}
        found = np.full((len(outputs()), shots.size), np.nan)
        for row in range(shots.size):
            if row not in refused:
                given, values = (
                    [float(each if isinstance(each, (int, float)) else each[row]) for each in columns]
                    for columns in (shots.inputs, shots.parameters)
                )
                try:
                    solved = self._solve(given, values, shots.accuracy)
                    if isinstance(solved[0], str):
                        problems.append((row, *solved))
                    else:
                        found[:, row] = _outputs(*solved)
                except RunError as error:
                    if shots.on_error == "raise":
                        raise
                    problems.append((row, "model", str(error)))
            if shots.progress is not None:
                shots.progress(row + 1)
        return found, sorted(problems)

    def forces(self, launch: Any, delivery: Mapping[str, Any]) -> None:
        """Return None: :func:`clubface.history` tells more."""
        return None

    def history(self, model: str, inputs: list[float], parameters: list[float], accuracy: float | None) -> Any:
        """Follow one contact and keep it at evenly spaced times."""
        usual = [each.default for each in models()[CHECKED_BY].parameters]
        _, problems = core.impact(CHECKED_BY, inputs, usual, 1, None, 1, None)
        solved = problems[0][1:] if problems else self._solve(inputs, parameters, accuracy)
        if isinstance(solved[0], str):
            raise ValueError(*solved)
        return {**_history(*solved), "launch": _outputs(*solved)}

    def _solve(self, given: list[float], values: list[float], accuracy: float | None) -> Any:
        """Return both bodies and the solution, or the name of what is at fault and why."""
        from clubface.simulation.contact_motion import LONGEST, MOST_EVALUATIONS, TwoBodies

        named = dict(zip(inputs(), given, strict=True))
        if named["characteristic_time"] != named["included_time"]:
            return "characteristic_time", "leave it out: a law of one's own describes ball and face together"
        names = (each.name for each in self.model.parameters)
        bodies = TwoBodies(named, self.law, dict(zip(names, values, strict=True)))
        solution = bodies.run(accuracy or USUAL_TOLERANCE)
        if solution is None:
            return "model", (
                f"{self.model.name}: club and ball did not part within {LONGEST * 1e3:.0f} ms or {MOST_EVALUATIONS}"
                " evaluations of the law; check its stiffness, damping and how sharply its friction changes"
            )
        return bodies, solution


def _outputs(bodies: Any, solution: Any) -> NDArray[Any]:
    """Return the outputs of a contact in their order."""
    from clubface.simulation.contact_motion import BALL_SPIN, BALL_VELOCITY, CLUB_VELOCITY

    end = solution.y[:, -1]
    mirror, turned = np.array([1.0, 1.0, bodies.hand]), np.array([bodies.hand, bodies.hand, 1.0])
    v, w = end[BALL_VELOCITY] * mirror, end[BALL_SPIN] * turned
    speed, level = math.hypot(*v), math.hypot(v[0], v[2])
    club = bodies.start[CLUB_VELOCITY]
    backspin = (w[2] * v[0] - w[0] * v[2]) / level if level else w[2]
    return np.array([
        speed, speed / math.hypot(*club), math.atan2(v[1], level), math.atan2(v[2], v[0]), backspin, -w[1],
        math.hypot(*w), math.atan2(-w[1], backspin), *v, *w,
        *(end[CLUB_VELOCITY] * mirror), *(bodies.at(end).club_spin * turned), solution.t[-1], _peak(bodies, solution),
    ])  # fmt: skip


def _peak(bodies: Any, solution: Any) -> float:
    """Return the largest normal force: near the largest of all steps, between its neighbours."""
    from scipy.optimize import minimize_scalar

    def force(time: float) -> float:
        return bodies.at(solution.sol(time)).forces[0]

    steps = [bodies.at(state).forces[0] for state in solution.y.T]
    largest = steps.index(max(steps))
    near = solution.t[max(largest - 1, 0)], solution.t[min(largest + 1, len(steps) - 1)]
    best = minimize_scalar(lambda time: -force(time), bounds=near, method="bounded", options={"xatol": 1e-9})
    return max(steps[largest], -float(best.fun))  # pyright: ignore[reportAttributeAccessIssue]


def _history(bodies: Any, solution: Any) -> dict[str, NDArray[Any]]:
    """Return the course of a contact under the names of :class:`clubface.History`."""
    from clubface.simulation.contact_motion import (
        ATTITUDE,
        BALL,
        BALL_SPIN,
        BALL_VELOCITY,
        CLUB,
        CLUB_VELOCITY,
        WORK,
    )  # fmt: skip

    time = np.linspace(0.0, solution.t[-1], HISTORY_POINTS)
    states = solution.sol(time).T
    states[-1] = solution.y[:, -1]
    instants = [bodies.at(state) for state in states]
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
