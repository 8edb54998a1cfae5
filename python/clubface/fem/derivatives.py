"""Exact derivatives of a finite element launch: the same code runs on numbers with derivatives."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple, cast

from numpy.typing import NDArray

from clubface.equipment.clubs import Club
from clubface.errors import InputError, ShotError
from clubface.fem import core
from clubface.fem.balls import Ball, ball as ball_of
from clubface.fem.core import THE_RUN, Progress, core_call
from clubface.fem.heads import MeshedHead, ShellHead
from clubface.fem.run import AnyBall, case, friction_of, inputs_of, one_shot
from clubface.fem.settings import Settings, settings_of
from clubface.simulation.inputs import Delivery
from clubface.simulation.results import outputs
from clubface.support.checks import check_choice, check_names
from clubface.support.renamed import renamed_arguments

__all__ = ["Derivatives", "sensitivity", "variables"]

VARIABLES_A_RUN = 4


class Derivatives(NamedTuple):
    """The launch of one impact and its derivatives.

    Attributes
    ----------
    values
        Launch quantities by name [SI]. Contact time and peak force have no derivatives and are NaN.
    variables
        Names of the variables.
    jacobian
        Derivatives [SI], shape (launch quantities, variables).
    """

    values: dict[str, float]
    variables: tuple[str, ...]
    jacobian: NDArray[Any]

    def by(self, quantity: str, variable: str) -> float:
        """Return the derivative of one quantity by one variable [SI]."""
        names = list(self.values)
        check_choice("quantity", quantity, names)
        check_choice("variable", variable, self.variables)
        return float(self.jacobian[names.index(quantity), self.variables.index(variable)])


@renamed_arguments(which="ball")
def variables(club: str | os.PathLike[str] | Club | ShellHead, *, ball: AnyBall = None) -> list[str]:
    """Return the variables of a launch's derivatives: delivery, club, friction, and constants of the ball.

    A piece of the ball has its outer "radius" (a smaller "core.radius" means a thicker cover), the elastic constants of
    its file (Poisson's ratio stays the same), "poisson" and "bulk" (the elastic constants stay the same), "density",
    and "maxwell.0.modulus", "maxwell.0.time" and so on. A part of a head of shells has its mean "thickness", as in
    "head.face.thickness", and "youngs", "poisson" and "density". The mesh of such a head stays as it is, and its club
    is no variable.
    """
    made, head, rigid = ball_of(ball), *_head_of(club)
    inputs = inputs_of(one_shot(rigid, {"speed": 1.0}, made))
    names = core.fem_variables(case(made, {"head": {"inputs": inputs, "mesh": head}}, 0.0, Settings()))
    for piece in made.pieces:
        names.insert(names.index(f"{piece.name}.bulk"), f"{piece.name}.poisson")
    return names


def _slopes(made: Ball, name: str) -> dict[str, float]:
    """Return what a variable does to those of the core, by name: its constants leave the bulk modulus alone."""
    for piece in made.pieces:
        bulk, key = f"{piece.name}.bulk", name.removeprefix(f"{piece.name}.")
        material = piece.material
        if name == f"{piece.name}.poisson":
            # K = 2 G (1 + nu) / (3 (1 - 2 nu)).
            return {bulk: 2.0 * material.shear / (1.0 - 2.0 * material.poisson) ** 2}
        if name != key and key in material.constants:
            return {name: 1.0, bulk: material.shear_slope(key) * material.bulk / material.shear}
    return {name: 1.0}


def _head_of(club: str | os.PathLike[str] | Club | ShellHead) -> tuple[dict[str, Any] | None, Any]:
    """Return the mesh of a head of shells as the core takes it, and the rigid club."""
    if isinstance(club, MeshedHead) and not isinstance(club, ShellHead):
        raise InputError("club", club.name, "a club, whose head is rigid, or a head of shells")
    return (club.values(), club.club) if isinstance(club, ShellHead) else (None, club)


@renamed_arguments(which="ball")
def sensitivity(
    club: str | os.PathLike[str] | Club | ShellHead,
    delivery: Delivery | Mapping[str, Any] | None = None,
    *,
    by: Iterable[str],
    ball: AnyBall = None,
    friction: Any = None,
    settings: Settings | None = None,
    progress: Progress | None = None,
    **values: Any,
) -> Derivatives:
    """Differentiate the launch of one impact.

    Parameters
    ----------
    club, delivery, **values, ball, friction, settings
        As for :func:`clubface.fem.strike`. If left out, the settings end the run soon after the last touch.
    by
        Names of variables, see :func:`variables`. Every four of them take one run.
    progress
        Called with the number of runs done, in fractions, and the number of runs.
    """
    from clubface.simulation.inputs import as_values

    made = ball_of(ball)
    mu = friction_of(friction, made)
    how = Settings(until_separation=True) if settings is None else settings_of(settings)
    names = (by,) if isinstance(by, str) else tuple(by)
    known = variables(club, ball=made)
    check_names("variable", names, known)
    head, rigid = _head_of(club)
    inputs = inputs_of(one_shot(rigid, dict(as_values(delivery, values)), made))
    slopes = [_slopes(made, name) for name in names]
    directions = [list(slope.items()) for slope in slopes]
    runs = -(-len(directions) // VARIABLES_A_RUN)
    one = case(made, {"head": {"inputs": inputs, "mesh": head}}, mu, replace(how, frames=0))

    def all_runs(watch: Progress) -> Any:
        def step(number: int, time: float, whole: float) -> None:
            watch(number + time / whole, runs)

        return core.fem_sensitivity(one, directions, step)

    def at(safety: float | None) -> tuple[Any, Any]:
        one["run"]["safety"] = safety
        return cast("tuple[Any, Any]", core_call(all_runs, progress=progress))

    launch, jacobian = _first_stable(at, how)
    return Derivatives(dict(zip(outputs(), map(float, launch), strict=True)), names, jacobian)


def _first_stable(run: Callable[[float | None], tuple[Any, Any]], how: Settings) -> tuple[Any, Any]:
    """Return what a run gives with the first safety with which no element fails."""
    *others, last = how.safeties()
    for safety in others:
        try:
            return run(safety)
        except ShotError as error:
            if error.parameter != THE_RUN:
                raise
    return run(last)
