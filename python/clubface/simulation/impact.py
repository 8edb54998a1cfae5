"""From delivery to launch: one call for a shot, a batch or several models."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Literal, overload

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL, models
from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError, RangeWarning
from clubface.simulation.backends import Request, backend_of
from clubface.simulation.delivery import Delivery
from clubface.simulation.inputs import as_values, broadcast, equipped, shot_error, shots, value_of
from clubface.simulation.launch import Comparison, Launch
from clubface.simulation.outside import warn_if_outside
from clubface.simulation.quantities import outputs
from clubface.simulation.results import first_error
from clubface.simulation.run_options import check_on_error, thread_count, tolerance
from clubface.support.checks import check_names
from clubface.support.warning import without_warnings

ALL = "all"
ModelNames = str | Iterable[str]
Parameters = ParameterSet | str | os.PathLike[str] | Mapping[str, Any]


@overload
def impact(
    club: str | os.PathLike[str] | Club,
    delivery: Delivery | Mapping[str, Any] | None = None,
    *,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: Any = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
    **values: Any,
) -> Launch: ...
@overload
def impact(
    club: str | os.PathLike[str] | Club,
    delivery: Delivery | Mapping[str, Any] | None = None,
    *,
    model: Iterable[str],
    parameters: Mapping[str, Parameters | None] | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: Any = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
    **values: Any,
) -> Comparison: ...
def impact(
    club: str | os.PathLike[str] | Club,
    delivery: Delivery | Mapping[str, Any] | None = None,
    *,
    model: str | Iterable[str] = DEFAULT_MODEL,
    parameters: Any = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: Any = None,
    threads: int | None = None,
    progress: Callable[[int], object] | None = None,
    on_error: Literal["raise", "nan"] = "raise",
    **values: Any,
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
    with_, chosen = equipped(model, club, ball, parameters)
    hit = shots(with_, values, hand=hand)
    names = tuple(chosen.values)
    hit, columns = broadcast(hit, chosen.columns(), names, len(outputs()))
    count = math.prod(hit.shape)
    try:
        computed, problems = backend.launches(
            Request(own, hit.club, model, hit.columns, columns, count, accuracy, cores, progress, on_error)
        )
    except ValueError as error:
        raise shot_error(error, hit.columns, chosen) from None
    if problems and on_error == "raise":
        row, name, _ = problems[0]
        raise first_error(problems, value_of(name, row, hit.columns, names, columns), hit.shape)
    launch = Launch(computed, hit, model, chosen, accuracy, problems)
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
