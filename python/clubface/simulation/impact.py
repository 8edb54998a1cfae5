"""From delivery to launch: one call for a shot, a batch or several models, whichever backend computes them.

The compiled core computes the reduced models, registered modules all others. Shots outside the range of validity of
their model or its parameters are counted and reported in one line.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib import import_module
from typing import Any, Literal, NamedTuple, Protocol, overload

import numpy as np
from numpy.typing import NDArray

from clubface import _core as core, units
from clubface.equipment.balls import DEFAULT_BALL, Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL, MODULES, OWN, model as model_named, models
from clubface.equipment.parameters import QUANTITIES, ParameterSet, ends_in_words
from clubface.errors import InputError, RangeWarning
from clubface.results.notes import Note
from clubface.simulation.inputs import (
    DeliveryLike,
    HandLike,
    as_values,
    check_on_error,
    prepare,
    thread_count,
    tolerance,
)
from clubface.simulation.launch import Comparison, Launch
from clubface.simulation.results import first_error, input_columns, outputs
from clubface.support.arrays import ValueLike
from clubface.support.checks import check_names, is_silent, warn_once, without_warnings

Problems = list[tuple[int, str, str]]
"""For each shot without a launch: row, name of the input at fault, reason."""


class Balls(NamedTuple):
    """A ball in the form that a backend computes with, and as described by the inputs of a shot."""

    own: Any  # what the backend computes with; None if the inputs are enough
    described: Any  # the ball as :func:`clubface.ball` returns it


class Request(NamedTuple):
    """Shots to compute: one column per input and parameter, a number or an array of ``size`` numbers.

    With ``on_error`` "nan", a failed shot does not stop the others.
    """

    own: Any  # the ball as :meth:`Backend.balls` returned it
    club: Any  # its values are among the inputs, some possibly changed by a shot
    model: str
    inputs: Sequence[Any]
    parameters: Sequence[Any]
    size: int
    accuracy: float | None
    threads: int
    progress: Callable[[int], object] | None
    on_error: Literal["raise", "nan"] = "raise"


class Backend(Protocol):
    """Computes the launches of a model."""

    def balls(self, given: Any, accuracy: float | None) -> Balls:
        """Return the ball for ``given``; raise InputError for an accuracy that the backend does not support."""
        return Balls(None, given)

    def launches(self, shots: Request) -> tuple[NDArray[Any], Problems]:
        """Return the outputs of all shots, NaN for those without a launch, and the reasons."""
        ...

    def forces(self, launch: Any, delivery: Mapping[str, Any]) -> Mapping[str, Any] | None:
        """Return the force histories of one shot, named as in :class:`clubface.History`; None by default."""
        return None

    def history(self, model: str, given: list[float], parameters: list[float], accuracy: float | None) -> Any:
        """Return the arrays of :class:`clubface.History` and the "launch"; called for contact models only."""
        ...

    def notes(self) -> Sequence[Note]:
        """Return the notes on every launch of the model, such as a bound of its error."""
        return ()


class ReducedCore(Backend):
    """The backend of the reduced models: the compiled core. The caveats of a model belong to its parameters."""

    def launches(self, shots: Request) -> tuple[NDArray[Any], Problems]:
        """Compute all shots at once."""
        return core.impact(
            shots.model, shots.inputs, shots.parameters, shots.size, shots.accuracy, shots.threads, shots.progress
        )

    def sensitivities(
        self, shots: Request, chosen: Sequence[int], variables: Sequence[int]
    ) -> tuple[NDArray[Any], Problems]:
        """Differentiate all shots at once."""
        return core.sensitivities(
            shots.model, shots.inputs, shots.parameters, shots.size, list(chosen), list(variables), shots.accuracy,
            shots.threads, shots.progress,
        )  # fmt: skip

    def history(self, model: str, given: list[float], parameters: list[float], accuracy: float | None) -> Any:
        """Compute the time history of one contact."""
        return core.history(model, given, parameters, accuracy)


REDUCED = ReducedCore()


def backend_of(model: str) -> Backend:
    """Return the backend of a model; an unknown model is reported when its parameters are read."""
    if not isinstance(model, str):
        return REDUCED
    if model in OWN:
        return OWN[model].BACKEND
    return import_module(MODULES[model]).BACKEND if model in MODULES else REDUCED


OFF_CENTRE = "off centre"
"""Key for shots struck off the face centre with a model without gear effect, in place of a quantity."""
OTHER_BALL = "ball"
"""Key for shots with a ball of another construction than that of the coefficients, in place of a quantity."""
ROUNDING = 1e-9
"""Relative tolerance at the ends of a range, for values converted from another unit."""


class Tally:
    """Counts shots, and those outside the range of validity, by model over any number of batches."""

    def __init__(self) -> None:
        self._shots: dict[str, int] = {}
        self._outside: dict[tuple[str, str], tuple[str, int, float]] = {}

    def add(self, launch: Launch) -> None:
        """Count the shots of a launch."""
        outside = []
        for name, (count, value) in _outside(launch).items():
            ends = ends_in_words(name, launch.parameters.range) if name in QUANTITIES else launch.ball.name
            outside.append((launch.model, name, ends, count, value))
        self.add_counts([{launch.model: math.prod(launch.shape)}, outside])

    def add_all(self, launches: Iterable[Launch]) -> Tally:
        """Count the shots of several launches; return the tally itself."""
        for each in launches:
            self.add(each)
        return self

    def counts(self) -> list[Any]:
        """Return the counts in a form that JSON can hold."""
        return [self._shots, [[*key, *entry] for key, entry in self._outside.items()]]

    def add_counts(self, counts: Sequence[Any]) -> None:
        """Add the counts of another tally."""
        shots, outside = counts
        for model, count in shots.items():
            self._shots[model] = self._shots.get(model, 0) + count
        for model, name, ends, count, value in outside:
            before = self._outside.get((model, name), (ends, 0, value))[1]
            self._outside[model, name] = (ends, before + count, value)

    def remark(self, *, counted: bool = True) -> str:
        """Return the warning in one line, or "" if no shot is outside.

        One shot is reported with its values, several with their number unless ``counted`` is False.
        """
        alike: dict[str, list[str]] = {}
        for model in self._shots:
            if words := ", ".join(self._part([model], name, counted=False) for name in self._names(model)):
                alike.setdefault(words, []).append(model)
        parts = []
        for words, alike_models in alike.items():
            names = self._names(alike_models[0])
            words = ", ".join(self._part(alike_models, name, counted=True) for name in names) if counted else words
            parts.append(f"outside the range of {', '.join(alike_models)}: {words}")
        for (model, name), (ball, *_) in self._outside.items():
            if name == OFF_CENTRE:
                parts.append(f"{model} has no gear effect off centre")
            elif name == OTHER_BALL:
                parts.append(f"{model} has no coefficients of the ball {ball} and takes those of {DEFAULT_BALL}")
        return "; ".join(parts)

    def warn(self) -> None:
        """Warn in one line if shots are outside; the same warning of the same models is given once per process."""
        if text := self.remark():
            warn_once(text, RangeWarning, key=self.remark(counted=False))

    def _names(self, model: str) -> list[str]:
        """Return the quantities for which shots of a model are outside."""
        return [name for name in QUANTITIES if (model, name) in self._outside]

    def _part(self, models: list[str], name: str, *, counted: bool) -> str:
        """Return the part of the warning on one quantity, for models with the same range."""
        quantity = QUANTITIES[name]
        ends, _, value = self._outside[models[0], name]
        # The same shots computed by several models, else different shots by each.
        numbers = {(self._outside[each, name][1], self._shots[each]) for each in models}
        count, shots = numbers.pop() if len(numbers) == 1 else map(sum, zip(*numbers, strict=True))
        how = f"{units.show(value, quantity.reading, 4)} " if shots == 1 else f"in {count} of {shots} shots "
        return f"{quantity.label} {how if counted else ''}(valid: {ends})"


def warn_if_outside(launches: Iterable[Launch]) -> None:
    """Warn in one line if shots of the launches are outside the range of validity."""
    if not is_silent(RangeWarning):
        Tally().add_all(launches).warn()


def _outside(launch: Launch) -> dict[str, tuple[int, float]]:
    """Return for each quantity the number of shots of a launch that are outside, and the value of the first."""
    result = {}
    for name, (least, most) in launch.parameters.range.items():
        margin = ROUNDING * (most - least)
        value = _incidence(launch, most) if name == "incidence" else _value(launch, name)
        if type(value) is float:
            if value < least - margin or value > most + margin:
                result[name] = (math.prod(launch.shape), value)
        elif value.size and not (value.min() >= least - margin and value.max() <= most + margin):
            out = (value < least - margin) | (value > most + margin)
            out &= launch.ball_speed.reshape(-1) > 0.0  # a shot that cannot be computed has its own message
            if out.any():
                result[name] = (int(out.sum()), float(value[out][0]))
    described, ball = model_named(launch.model), launch.ball
    if not described.gear_effect:
        place = launch.input("toe"), launch.input("high")
        if any(value != 0.0 if type(value) is float else bool((value != 0.0).any()) for value in place):
            result[OFF_CENTRE] = (1, 0.0)
    # The ball is known to differ from that of the coefficients, and has no coefficients of its own.
    other = ball.construction is not None and ball.name != described.ball and described.name not in ball.parameters
    if described.ball and launch.parameters.unchosen and other:
        result[OTHER_BALL] = (1, 0.0)
    return result


def _value(launch: Launch, name: str) -> Any:
    """Return a quantity that has a range of validity: a number, or a flat array of the shots."""
    value = launch.input(name) if name in input_columns() else launch.parameters.values.get(name, 0.0)
    if type(value) is float or value.shape == (math.prod(launch.shape),):
        return value
    return np.broadcast_to(value, launch.shape).reshape(-1)


def _incidence(launch: Launch, limit: float) -> Any:
    """Return the angle between path and face normal [rad], or 0 if it is certainly below ``limit``.

    The triangle inequality on the sphere decides most cases without computing the cosine.
    """
    attack, path, loft, face = (launch.input(name) for name in ("attack", "path", "loft", "face"))
    apart, sideways = loft - attack, path - face
    bound = abs(apart) + abs(sideways)
    if (bound if type(bound) is float else bound.max(initial=0.0)) <= limit:
        return 0.0
    cosine = np.cos(attack) * np.cos(loft) * np.cos(sideways) + np.sin(attack) * np.sin(loft)
    angle = np.arccos(np.clip(cosine, -1.0, 1.0))
    return angle if np.ndim(angle) else float(angle)


ALL = "all"
ModelNames = str | Iterable[str]
Parameters = ParameterSet | str | os.PathLike[str] | Mapping[str, Any]


@overload
def impact(  # pyright: ignore[reportOverlappingOverload]
    club: str | os.PathLike[str] | Club,
    delivery: DeliveryLike | None = None,
    *,
    model: Literal["all"],
    parameters: Mapping[str, Parameters | None] | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: HandLike | None = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
    **values: ValueLike | None,
) -> Comparison: ...
@overload
def impact(
    club: str | os.PathLike[str] | Club,
    delivery: DeliveryLike | None = None,
    *,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: HandLike | None = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
    **values: ValueLike | None,
) -> Launch: ...
@overload
def impact(
    club: str | os.PathLike[str] | Club,
    delivery: DeliveryLike | None = None,
    *,
    model: Iterable[str],
    parameters: Mapping[str, Parameters | None] | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: HandLike | None = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
    **values: ValueLike | None,
) -> Comparison: ...
def impact(
    club: str | os.PathLike[str] | Club,
    delivery: DeliveryLike | None = None,
    *,
    model: str | Iterable[str] = DEFAULT_MODEL,
    parameters: Parameters | Mapping[str, Parameters | None] | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: HandLike | None = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
    **values: ValueLike | None,
) -> Launch | Comparison:
    """Compute the launch of a ball hit by a club.

    Parameters
    ----------
    club
        A built-in name, the path of a TOML file, or a :class:`Club`.
    delivery
        A :class:`Delivery` or a mapping of its values; values given by keyword take precedence.
    model
        Name of a model. Default: ``response``. A list of names, or "all", gives a :class:`Comparison`.
    parameters
        A :class:`ParameterSet`, the name of a published set, the path of a TOML file, or a mapping of values that
        replace those of the published set. Default: the published set of the club's family. For several models, a
        mapping of model names to any of these.
    ball
        A built-in name, the path of a TOML file, or a :class:`Ball`. Default: ``modern``.
    accuracy
        Relative tolerance per step of a contact model. Default: chosen so that the launch is correct to 1e-4.
    hand
        "right" or "left". Default: the hand of the club.
    threads
        Number of threads. Default: all cores. The result does not depend on it.
    progress
        Function called with the number of shots done.
    on_error
        "raise" raises an error for a shot that cannot be computed, "nan" gives NaN and an entry in ``Launch.problems``.
    **values
        Values of the delivery (``speed``, ``attack``, ``path``, ``loft``, ``face``, ``lie``, ``toe``, ``high``,
        ``closure``, ``pitch_rate``, ``lie_rate``) and of club and ball (``club_mass``, ``cg_x``, ``ball_mass``,
        ...): text with a unit, SI numbers, or arrays, which broadcast. ``speed`` is required. Angles, offsets and rates
        default to 0, the loft and all other values to those of club and ball.

    Returns
    -------
    Launch
        The launches; quantities have the shape to which the inputs broadcast.

    Warns
    -----
    RangeWarning
        Shots are outside the range of validity of the model or its parameters. Given once, with their number.

    Raises
    ------
    ShotError
        An input is out of range; the message gives its name, its value and the allowed range.
    InputError
        A value is not a number, a unit has the wrong dimension, a name is unknown, or the shots do not fit in memory.
    """
    values = dict(as_values(delivery, values))
    if not isinstance(model, str) or model == ALL:
        return _compare(
            model, parameters, club=club, delivery=values, ball=ball, accuracy=accuracy, hand=hand,
            threads=threads, progress=progress, on_error=on_error,
        )  # fmt: skip
    check_on_error(on_error)
    accuracy, cores = tolerance(accuracy), thread_count(threads)
    backend = backend_of(model)
    own, ball = backend.balls(ball, accuracy)
    prepared = prepare(model, club, values, ball, parameters, hand, outputs=len(outputs()))
    laid_out, chosen, columns = prepared
    count = math.prod(laid_out.shape)
    try:
        computed, problems = backend.launches(
            Request(own, laid_out.club, model, laid_out.columns, columns, count, accuracy, cores, progress, on_error)
        )
    except ValueError as error:
        raise prepared.error(error) from None
    if problems and on_error == "raise":
        row, name, _ = problems[0]
        raise first_error(problems, prepared.value_of(name, row), laid_out.shape)
    launch = Launch(computed, laid_out, model, chosen, accuracy, problems)
    warn_if_outside((launch,))
    return launch


def model_names(model: ModelNames) -> tuple[str, ...]:
    """Return the model names for one name, a list of names, or "all"."""
    if isinstance(model, str):
        return tuple(models()) if model == ALL else (model,)
    try:
        names = tuple(model)
    except TypeError:
        names = ()
    if not names or not all(isinstance(each, str) for each in names):
        raise InputError("model", model, '"all" or at least one of ' + ", ".join(models()))
    return names


def _compare(model: ModelNames, parameters: Any, **shot: Any) -> Comparison:
    names = model_names(model)
    if parameters is None:
        parameters = {}
    if not isinstance(parameters, Mapping):
        raise InputError("parameters", parameters, "a mapping of model names to parameters, for several models")
    check_names("model among the parameters", parameters, names)
    with without_warnings(RangeWarning):
        launches = {name: impact(model=name, parameters=parameters.get(name), **shot) for name in names}
    warn_if_outside(launches.values())
    return Comparison(launches)
