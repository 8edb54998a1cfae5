"""The impact models, as the core and further backends declare them: names, parameters, units, bounds, sources."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from types import SimpleNamespace
from typing import NamedTuple

from clubface import _core
from clubface.errors import InputError, UnknownNameError
from clubface.support.checks import Frozen

PARAMETER_KEYS = ("name", "unit", "meaning", "default", "lower", "upper", "source")
DEFAULT_MODEL = "response"
"""The model where none is named."""

MODEL_KEYS = ("name", "title", "kind", "summary", "reference")


MODULES = {"fem": "clubface.fem.backend"}
"""The module of each model that something else than the compiled core of reduced models computes, by its name.

It declares its model as ``MODEL`` and what computes it, a :class:`clubface.simulation.impact.Backend`, as ``BACKEND``,
and is imported when the model is named.
"""
OWN: dict[str, SimpleNamespace] = {}
"""``MODEL`` and ``BACKEND`` of each model that a user registered in this process, by the name of the model."""


@dataclass(frozen=True)
class Parameter:
    """One parameter of a model.

    Attributes
    ----------
    name
        As in files and in ``replace``.
    unit
        The SI unit its value is held in.
    meaning
        One line.
    default
        The value used if none is given [SI].
    lower, upper
        The values allowed, both included [SI].
    source
        Where the default and the bounds come from.
    """

    name: str
    unit: str
    meaning: str
    default: float
    lower: float
    upper: float
    source: str


class ValidRange(NamedTuple):
    """Bounds of one quantity within which a model is valid.

    Attributes
    ----------
    name
        An input of a shot, a parameter, or ``incidence``, the angle between the velocity of the clubhead and the normal
        at the face centre.
    label
        What people call it.
    reading
        The unit in which they read it.
    lower, upper
        Its bounds [SI], both included.
    """

    name: str
    label: str
    reading: str
    lower: float
    upper: float


@dataclass(frozen=True)
class Model:
    """One impact model.

    Attributes
    ----------
    name
        By which it is selected.
    title
        The name for headings.
    kind
        "impulse" (launch only) or "contact" (histories as well).
    summary
        One sentence.
    reference
        The publication it follows.
    laws
        The laws it obeys, of "momentum", "angular_momentum", "energy", "friction_cone".
    laws_without
        The name of a parameter, and laws obeyed while it is zero; or None.
    parameters
        In the order of the core's columns.
    face_in
        The parameter that holds the restitution, if its default was fitted to a driver and so includes the driver's
        face; None if the defaults describe the ball alone.
    lacks
        The outputs that it does not compute.
    gear_effect
        Whether a head that turns back turns the ball.
    ball
        The ball whose coefficients the defaults are; None if they are of no ball in particular.
    valid
        The strikes for which the defaults are valid.
    """

    name: str
    title: str
    kind: str
    summary: str
    reference: str
    laws: tuple[str, ...]
    laws_without: tuple[str, tuple[str, ...]] | None
    parameters: tuple[Parameter, ...]
    face_in: str | None = None
    lacks: tuple[str, ...] = ()
    gear_effect: bool = True
    ball: str | None = None
    valid: tuple[ValidRange, ...] = ()

    @property
    def laws_in_words(self) -> str:
        """The laws it obeys, and those it obeys only while a parameter is zero."""
        always = _listed(self.laws)
        if self.laws_without is None:
            return always
        parameter, more = self.laws_without
        return f"{always}; with {parameter} = 0 also {_listed(more)}"

    def parameter(self, name: str) -> Parameter:
        """Return the parameter called ``name``."""
        for each in self.parameters:
            if each.name == name:
                return each
        raise UnknownNameError(f"parameter of {self.name}", name, [each.name for each in self.parameters])


def models() -> dict[str, Model]:
    """Return all models by name, in the order of the registry; the dictionary is the caller's own."""
    return dict(_registered())


@cache
def _registered() -> Mapping[str, Model]:
    result = {}
    for entry in _core.models():
        parameters = tuple(Parameter(**{key: each[key] for key in PARAMETER_KEYS}) for each in entry["parameters"])
        plain = {key: entry[key] for key in MODEL_KEYS}
        without = entry.get("laws_without")
        result[entry["name"]] = Model(
            **plain,
            laws=tuple(entry["laws"]),
            laws_without=(without[0], tuple(without[1])) if without else None,
            parameters=parameters,
            face_in=entry["face_in"],
            lacks=tuple(entry["lacks"]),
            gear_effect=entry["gear_effect"],
            ball=entry["ball"],
            valid=tuple(ValidRange(**each) for each in entry["valid"]),
        )
    return Frozen(result)


def models_with(parameter: str) -> list[str]:
    """Return the names of the models that have this parameter."""
    return [name for name, each in models().items() if any(parameter == one.name for one in each.parameters)]


def _listed(laws: tuple[str, ...]) -> str:
    return ", ".join(each.replace("_", " ") for each in laws) or "none"


@cache
def further_models() -> Mapping[str, Model]:
    """Return the models of the registered backends by name; they take long, so that "all" does not mean them."""
    return Frozen({name: import_module(module).MODEL for name, module in MODULES.items()})


def model(name: str) -> Model:
    """Return the model called ``name``; an unknown one is an error that names the nearest."""
    if not isinstance(name, str):
        raise InputError("model", name, "one of " + ", ".join(models()))
    if name in _registered():
        return _registered()[name]
    if name in OWN:
        return OWN[name].MODEL
    if name not in MODULES:
        raise UnknownNameError("model", name, model_names())
    return further_models()[name]


def model_names() -> tuple[str, ...]:
    """Return the names of all models, those of further backends included."""
    return (*_registered(), *MODULES, *OWN)


def differentiable_model(name: str) -> Model:
    """Return the reduced model or user-defined law called ``name``; other models have no derivatives of launches."""
    return OWN[name].MODEL if isinstance(name, str) and name in OWN else reduced_model(name, "one with derivatives")


def reduced_model(name: str, wanted: str) -> Model:
    """Return the reduced model called ``name``; for a model of another backend the error says what was ``wanted``."""
    if isinstance(name, str) and (name in MODULES or name in OWN):
        raise InputError("model", name, f"{wanted}: {', '.join(models())}")
    return model(name)
