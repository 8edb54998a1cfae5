"""From delivery to launch: one call for a shot, a batch or several models, by whatever computes the model.

The compiled core computes the reduced models, a module that is registered for it any other. Shots outside what their
model or its parameters were made for are counted and reported in one line.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol, overload

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

if TYPE_CHECKING:
    from numpy.typing import NDArray


Problems = list[tuple[int, str, str]]
"""Row, name of the input at fault, and reason of each shot without a launch."""


class Balls(NamedTuple):
    """A ball as a backend computes it, and as the inputs of a shot describe it."""

    own: Any  # what the backend takes; None where the inputs say everything
    described: Any  # as of :func:`clubface.ball`


class Request(NamedTuple):
    """Shots to compute: a column an input and parameter, each a number or an array of ``size`` numbers.

    With ``on_error`` "nan", what goes wrong with one shot does not stop the others.
    """

    own: Any  # the ball as :meth:`Backend.balls` gave it
    club: Any  # the inputs hold its values, some of which a shot may have changed
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
        """Return the ball that ``given`` means; refuse an accuracy that the backend does not take."""
        ...

    def launches(self, shots: Request) -> tuple[NDArray[Any], Problems]:
        """Return outputs by shots, NaN for those without a launch, and what kept them from having one."""
        ...

    def forces(self, launch: Any, delivery: Mapping[str, Any]) -> Mapping[str, Any] | None:
        """Return the forces of one shot over time as :class:`clubface.History` names them, None without a contact."""
        ...

    def history(self, model: str, inputs: list[float], parameters: list[float], accuracy: float | None) -> Any:
        """Return what :class:`clubface.History` holds, and the "launch"; asked of contact models alone."""
        ...

    def notes(self) -> Sequence[Note]:
        """Return what is noted of every launch of the model, such as what bounds its error."""
        ...


class ReducedCore:
    """The reduced models."""

    def balls(self, given: Any, accuracy: float | None) -> Balls:
        """Return the ball as it is."""
        return Balls(None, given)

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

    def forces(self, launch: Any, delivery: Mapping[str, Any]) -> Mapping[str, Any] | None:
        """Return None: :func:`clubface.history` returns more."""
        return None

    def history(self, model: str, inputs: list[float], parameters: list[float], accuracy: float | None) -> Any:
        """Compute one contact and keep every step."""
        return core.history(model, inputs, parameters, accuracy)

    def notes(self) -> Sequence[Note]:
        """Return no note: caveats of a model stand with its parameters."""
        return ()


REDUCED = ReducedCore()


def backend_of(model: str) -> Backend:
    """Return what computes a model; of an unknown one, its parameters say that there is none."""
    if not isinstance(model, str):
        return REDUCED
    if model in OWN:
        return OWN[model].BACKEND
    return import_module(MODULES[model]).BACKEND if model in MODULES else REDUCED


OFF_CENTRE = "off centre"
"""What stands for a quantity where a ball is struck off the face centre by a model without gear effect."""
OTHER_BALL = "ball"
"""What stands for a quantity where a ball of other pieces has none."""
ROUNDING = 1e-9
"""Part of a range by which a value that is converted from another unit may miss its ends."""


class Tally:
    """Counts launches and those of them that are outside, by model, over any number of batches."""

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
        """Return what is counted, made of what JSON has."""
        return [self._shots, [[*key, *entry] for key, entry in self._outside.items()]]

    def add_counts(self, counts: Sequence[Any]) -> None:
        """Add what another tally counted."""
        shots, outside = counts
        for model, count in shots.items():
            self._shots[model] = self._shots.get(model, 0) + count
        for model, name, ends, count, value in outside:
            before = self._outside.get((model, name), (ends, 0, value))[1]
            self._outside[model, name] = (ends, before + count, value)

    def remark(self, *, counted: bool = True) -> str:
        """Return the warning in one line, "" if no shot is outside.

        One shot is reported with its values, several with their number, or without where they are not ``counted``.
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
        """Warn in one line if shots are outside; the same of the same models only once in a process."""
        if text := self.remark():
            warn_once(text, RangeWarning, key=self.remark(counted=False))

    def _names(self, model: str) -> list[str]:
        """Return the quantities in which shots of a model are outside."""
        return [name for name in QUANTITIES if (model, name) in self._outside]

    def _part(self, models: list[str], name: str, *, counted: bool) -> str:
        """Return the part of the warning on one quantity, for models with the same range."""
        words, unit = QUANTITIES[name]
        ends, _, value = self._outside[models[0], name]
        # The same shots by several models, or else other shots by each.
        numbers = {(self._outside[each, name][1], self._shots[each]) for each in models}
        count, shots = numbers.pop() if len(numbers) == 1 else map(sum, zip(*numbers, strict=True))
        how = f"{units.show(value, unit, 4)} " if shots == 1 else f"in {count} of {shots} shots "
        return f"{words} {how if counted else ''}(valid: {ends})"


def warn_if_outside(launches: Iterable[Launch]) -> None:
    """Warn as a tally of the launches does."""
    if not is_silent(RangeWarning):
        Tally().add_all(launches).warn()


def _outside(launch: Launch) -> dict[str, tuple[int, float]]:
    """Return by quantity how many shots of a launch are outside, and the value of the first of them."""
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
    # The ball is known to differ from that of the coefficients, and has none of its own.
    other = ball.construction is not None and ball.name != described.ball and described.name not in ball.parameters
    if described.ball and launch.parameters.unchosen and other:
        result[OTHER_BALL] = (1, 0.0)
    return result


def _value(launch: Launch, name: str) -> Any:
    """Return a quantity of a range: a number, or an array of the shots, flat."""
    value = launch.input(name) if name in input_columns() else launch.parameters.values.get(name, 0.0)
    if type(value) is float or value.shape == (math.prod(launch.shape),):
        return value
    import numpy as np

    return np.broadcast_to(value, launch.shape).reshape(-1)


def _incidence(launch: Launch, limit: float) -> Any:
    """Return the angle [rad] between path and face normal, or 0 if it is certainly below the ``limit``.

    No side of a triangle on a sphere is longer than the two others together, which saves its cosine nearly always.
    """
    attack, path, loft, face = (launch.input(name) for name in ("attack", "path", "loft", "face"))
    apart, sideways = loft - attack, path - face
    bound = abs(apart) + abs(sideways)
    if (bound if type(bound) is float else bound.max(initial=0.0)) <= limit:
        return 0.0
    import numpy as np

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
        A :class:`Delivery` or a mapping of its values; single values given by name win.
    model
        The name of a model, ``response`` unless given; a list of names, or "all", gives a :class:`Comparison`.
    parameters
        A :class:`ParameterSet`, the name of a published set, the path of a TOML file, or a mapping of names to
        values that changes the published set of the club's family, which is used where nothing is given. For
        several models, a mapping of model names to these.
    ball
        A built-in name, the path of a TOML file, or a :class:`Ball`; left out, ``modern``.
    accuracy
        Relative tolerance of a step of a contact model; left out, the launch is correct to 1e-4.
    hand
        "right" or "left"; left out, that of the club.
    threads
        How many threads compute; all cores if left out. The result does not depend on it.
    progress
        Called with the number of shots done.
    on_error
        What happens to a shot that cannot be computed: "raise" raises an error, "nan" gives NaN and an entry in
        ``Launch.problems``.
    **values
        Values of the delivery (``speed``, ``attack``, ``path``, ``loft``, ``face``, ``lie``, ``toe``, ``high``,
        ``closure``, ``pitch_rate``, ``lie_rate``) and of club and ball (``club_mass``, ``cg_x``, ``ball_mass``,
        ...): text with a unit, SI numbers, or arrays, which broadcast. ``speed`` is required. An angle, an offset or
        a rate that is left out is 0; the loft and all else are then those of club and ball.

    Returns
    -------
    Launch
        Its quantities have the shape to which the inputs broadcast.

    Warns
    -----
    RangeWarning
        Shots are outside what the model or its parameters were made for. It is given once, with their number.

    Raises
    ------
    ShotError
        An input is outside what is allowed; the message names it, its value and what is allowed.
    InputError
        A value is no number, a unit has another dimension, a name is unknown, or memory does not hold the shots.
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
    """Return the names meant by one name, a list of names, or "all"."""
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
