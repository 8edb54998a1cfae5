"""Launches and flights as functions of a row of numbers, with first and second derivatives, for array libraries.

JAX and PyTorch differentiate a function of arrays by a rule that its author gives. The functions here provide what such
a rule needs: values alone; values with exact derivatives, from one run of the core on dual numbers; and second
derivatives, which the core does not have and which are symmetrised five-point differences of the exact first
derivatives.
"""

from __future__ import annotations

import math
import os
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from clubface import _core as core
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import reduced_model
from clubface.errors import InputError, Wording
from clubface.simulation.inputs import HandLike, check_on_error, equipped, shots, thread_count, tolerance
from clubface.simulation.results import (
    Variable,
    first_error,
    flight_inputs,
    flight_outputs,
    inputs,
    outputs as launch_outputs,
)
from clubface.simulation.sensitivity import known_variables
from clubface.support.arrays import flat
from clubface.support.checks import check_names

if TYPE_CHECKING:
    from numpy.typing import NDArray

STEP = 2e-3
"""Step of the differences for second derivatives, relative to the size of a variable. Rounding and the truncation error
of the fourth-order difference are then both about 1e-11 for models in closed form, 1e-7 for flights."""
CONTACT_STEP, CONTACT_ACCURACY = 2e-2, 1e-10
"""Step of the differences for models that integrate the contact, and the accuracy that they need. Their first
derivatives are slightly rough, since the time steps change with the inputs; second derivatives are good to 1e-3."""
SMOOTH = ("volumetric",)
"""Contact models whose first derivatives are smooth enough to be differentiated again."""
ROUGH = ("total", "total_side", "outside_fit")
"""Flight quantities that have no second derivatives: the number of bounces changes with the inputs."""
SIZES = {"speed": 10.0, "angle": 0.2, "length": 0.02, "angular rate": 50.0, "inertia": 1e-4}
"""Minimum size of a variable by its dimension [SI], for variables that may be zero."""
STENCIL = ((-2.0, 1.0 / 12.0), (-1.0, -8.0 / 12.0), (1.0, 8.0 / 12.0), (2.0, -1.0 / 12.0))
"""Offsets and weights of the central difference of fourth order."""


class Differentiable(ABC):
    """A differentiable function of some variables, which are the last axis of its input.

    ``variables`` and ``outputs`` name what it takes and returns, in the order of the last axis; ``places`` and ``rows``
    are their indices among the columns and the outputs of the core. Entries of ``columns`` at variables are
    placeholders. Differences for second derivatives take steps of ``step`` times the variable or its minimum size,
    whichever is greater. If there are no second derivatives, ``once`` says what to do instead.
    """

    _names: tuple[str, ...]  # names of the columns

    def __init__(
        self,
        variables: Mapping[str, tuple[int, Variable]],
        outputs: Mapping[str, int],
        columns: Sequence[Any],
        threads: int,
        on_error: Literal["raise", "nan"],
        step: float = STEP,
        once: str = "",
    ) -> None:
        self.step, self.once = step, once
        self.variables = tuple(variables)
        self.outputs = tuple(outputs)
        self.places = [place for place, _ in variables.values()]
        self.sizes = np.array([SIZES.get(each.dimension, 0.0) for _, each in variables.values()])
        self.rows = list(outputs.values())
        self.columns = list(columns)
        self._threads = threads
        self._on_error = on_error
        self.shape = np.broadcast_shapes(*(np.shape(each) for each in columns))
        """Shape to which the inputs other than the variables broadcast."""

    def values(self, x: NDArray[Any]) -> NDArray[Any]:
        """Return the outputs [SI], shape (..., outputs), for variables [SI], shape (..., variables)."""
        columns, shape = self._core_columns(x)
        computed, problems = self._compute(columns, math.prod(shape))
        self._check(problems, columns, shape, self._on_error)
        return np.moveaxis(computed[self.rows].reshape(-1, *shape), 0, -1)

    def values_and_jacobian(self, x: NDArray[Any], *, on_error: str = "") -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the outputs and their derivatives, shape (..., outputs, variables)."""
        columns, shape = self._core_columns(x)
        computed, problems = self._differentiate(columns, math.prod(shape))
        self._check(problems, columns, shape, on_error or self._on_error)
        table = computed.reshape(len(self.rows), 1 + len(self.places), *shape)
        table = np.ascontiguousarray(np.moveaxis(table, (0, 1), (-2, -1)))
        return table[..., 0], table[..., 1:]

    def hessian(self, x: NDArray[Any]) -> NDArray[Any]:
        """Return the second derivatives, shape (..., outputs, variables, variables).

        They are NaN where one of the nearby shots of the difference, a few thousandths away, cannot be computed.
        """
        self.check_twice()
        x = np.asarray(x, dtype=np.float64)
        size = np.maximum(np.abs(x), self.sizes)
        step = self.step * np.where(np.isfinite(size) & (size > 0.0), size, 1.0)
        width = len(self.variables)
        shifts = np.array([place for place, _ in STENCIL])[:, None, None] * np.eye(width)
        axes = (1,) * (x.ndim - 1)
        moved = x + shifts.reshape(len(STENCIL), width, *axes, width) * step
        _, jacobian = self.values_and_jacobian(moved, on_error="nan")
        weights = np.array([weight for _, weight in STENCIL])
        differences = np.moveaxis(np.tensordot(weights, jacobian, 1), 0, -1) / step[..., None, None, :]
        return 0.5 * (differences + np.swapaxes(differences, -1, -2))

    def _core_columns(self, x: NDArray[Any]) -> tuple[list[Any], tuple[int, ...]]:
        """Return the columns for the core, flat arrays or single numbers, and the shape of the batch."""
        x = np.asarray(x, dtype=np.float64)
        shape = np.broadcast_shapes(x.shape[:-1], self.shape)
        columns = [flat(each, shape) for each in self.columns]
        for place, column in zip(self.places, np.moveaxis(x, -1, 0), strict=True):
            columns[place] = flat(column, shape)
        if math.prod(shape) == 1:  # an array of one element is slower, and deprecated where a number is expected
            columns = [float(each if isinstance(each, float) else each[0]) for each in columns]
        return columns, shape

    def check_twice(self) -> None:
        """Raise InputError if the first derivatives are not smooth enough for second ones."""
        if self.once:
            raise InputError("order of derivatives", 2, self.once)

    def _check(self, problems: Any, columns: Sequence[Any], shape: tuple[int, ...], on_error: str) -> None:
        if problems and on_error == "raise":
            row, name, _ = problems[0]
            value = columns[self._names.index(name)] if name in self._names else None
            raise first_error(problems, value if isinstance(value, float | None) else float(value[row]), shape)

    @abstractmethod
    def _compute(self, columns: Sequence[Any], count: int) -> tuple[NDArray[Any], Any]:
        """Return all outputs, shape (outputs, shots), and the problems."""

    @abstractmethod
    def _differentiate(self, columns: Sequence[Any], count: int) -> tuple[NDArray[Any], Any]:
        """Return value and derivatives of each chosen output for all shots, and the problems."""


class LaunchFunction(Differentiable):
    """The launch by a reduced model as a differentiable function; parameters as for :func:`clubface.impact`."""

    def __init__(
        self,
        club: str | os.PathLike[str] | Club,
        values: Mapping[str, Any],
        variables: Iterable[str],
        *,
        model: str,
        parameters: Any = None,
        ball: str | os.PathLike[str] | Ball | None = None,
        accuracy: float | None = None,
        hand: HandLike | None = None,
        outputs: Iterable[str] | None = None,
        threads: int | None = None,
        on_error: Literal["raise", "nan"] = "raise",
    ) -> None:
        check_on_error(on_error)
        described = reduced_model(model, "one with derivatives")
        self._model, self.accuracy = model, tolerance(accuracy)
        known = known_variables(model)
        variables = tuple(variables)
        for name in variables:
            if name in inputs() and name not in known:
                allowed = "a plain number; derivatives with respect to it are not available"
                raise InputError(name, Wording("a variable"), allowed)
        check_names("variable", variables, known)
        setup, chosen = equipped(model, club, ball, parameters)
        self.club, self.ball = setup.club, setup.ball
        # Variables are placeholders here; they enter their columns when the function is called.
        given = {**values, **{name: 1.0 for name in variables if name in inputs()}}
        fixed = [*shots(setup, given, hand=hand).columns, *chosen.columns()]
        self._width = len(inputs())
        self._names = (*inputs(), *chosen.values)
        rows = {name: row for row, name in enumerate(launch_outputs()) if name not in described.lacks}
        step, once = STEP, ""
        if described.kind == "contact":
            step = CONTACT_STEP
            if model not in SMOOTH:
                once = f"use a model in closed form, such as response: first derivatives of {model} are not smooth"
            elif self.accuracy is None or self.accuracy > CONTACT_ACCURACY:
                once = f"give accuracy={CONTACT_ACCURACY:g} or less, which second derivatives of {model} need"
        super().__init__(
            {name: known[name] for name in variables}, _rows_of(outputs, rows), fixed, thread_count(threads), on_error,
            step, once,
        )  # fmt: skip

    def _compute(self, columns: Sequence[Any], count: int) -> tuple[NDArray[Any], Any]:
        own, parameters = columns[: self._width], columns[self._width :]
        return core.impact(self._model, own, parameters, count, self.accuracy, self._threads, None)

    def _differentiate(self, columns: Sequence[Any], count: int) -> tuple[NDArray[Any], Any]:
        return core.sensitivities(
            self._model, columns[: self._width], columns[self._width :], count, self.rows, self.places,
            self.accuracy, self._threads, None,
        )  # fmt: skip


class FlightFunction(Differentiable):
    """Flight, bounces and roll of a ball as a differentiable function."""

    def __init__(
        self,
        values: Mapping[str, Any],
        variables: Iterable[str],
        *,
        outputs: Iterable[str] | None = None,
        threads: int | None = None,
        on_error: Literal["raise", "nan"] = "raise",
    ) -> None:
        check_on_error(on_error)
        known = {name: (place, each) for place, (name, each) in enumerate(flight_inputs().items())}
        self._names = tuple(known)
        variables = tuple(variables)
        check_names("variable", variables, known)
        wanted = _rows_of(outputs, {name: row for row, name in enumerate(flight_outputs())})
        rough = [name for name in wanted if name in ROUGH]
        once = f"leave {', '.join(rough)} out of the outputs: bounces make steps in them" if rough else ""
        super().__init__(
            {name: known[name] for name in variables}, wanted, [values[name] for name in known], thread_count(threads),
            on_error, STEP, once,
        )  # fmt: skip

    def _compute(self, columns: Sequence[Any], count: int) -> tuple[NDArray[Any], Any]:
        return core.fly(columns, count, self._threads, None)

    def _differentiate(self, columns: Sequence[Any], count: int) -> tuple[NDArray[Any], Any]:
        return core.fly_sensitivities(columns, count, self.rows, self.places, self._threads, None)


def _rows_of(names: Iterable[str] | None, known: Mapping[str, int]) -> dict[str, int]:
    names = list(known) if names is None else [names] if isinstance(names, str) else list(names)
    check_names("output", names, known)
    return {name: known[name] for name in names}
