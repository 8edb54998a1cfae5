"""Impact models declared by the core and by further backends: names, parameters, units, bounds, sources."""

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

DEFAULT_MODEL = "response"
"""Name of the default model."""

MODULES = {"fem": "clubface.fem.backend"}
"""Module of each model that is not one of the reduced models in the compiled core, by model name.

The module declares the model as ``MODEL`` and its :class:`clubface.simulation.impact.Backend` as ``BACKEND``; it is
imported when the model is first used.
"""
OWN: dict[str, SimpleNamespace] = {}
"""``MODEL`` and ``BACKEND`` of each model registered by the user in this process, by model name."""


@dataclass(frozen=True)
class Parameter:
    """A parameter of a model.

    Attributes
    ----------
    name
        Name in files and in ``replace``.
    unit
        SI unit of its value.
    meaning
        One-line meaning.
    default
        Default value [SI].
    lower, upper
        Allowed values, both included [SI].
    source
        Source of the default and the bounds.
    """

    name: str
    unit: str
    meaning: str
    default: float
    lower: float
    upper: float
    source: str


class ValidRange(NamedTuple):
    """Range of one quantity within which a model is valid."""

    name: str  # an input of a shot, a parameter, or "incidence", the angle of clubhead velocity and face normal
    label: str  # common name
    reading: str  # unit in which it is commonly given
    lower: float  # included [SI]
    upper: float  # included [SI]


@dataclass(frozen=True)
class Model:
    """An impact model.

    Attributes
    ----------
    name
        Name by which it is selected.
    title
        Title for headings.
    kind
        "impulse" (launch only) or "contact" (histories as well).
    summary
        One-sentence summary.
    reference
        Publication it follows.
    laws
        Laws it obeys, among "momentum", "angular_momentum", "energy", "friction_cone".
    laws_without
        Name of a parameter, and further laws obeyed if it is zero; or None.
    parameters
        Parameters in the order of the core's columns.
    face_in
        Parameter that holds the restitution, if its default was fitted to a driver and therefore includes the flexible
        face; None if the defaults describe the ball alone.
    lacks
        Outputs that it does not compute.
    gear_effect
        Whether a head that turns in the impact turns the ball.
    ball
        Ball described by the default coefficients; None if no particular ball.
    valid
        Range of strikes for which the defaults are valid.
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
        """Laws it obeys, and those it obeys only if a parameter is zero, in words."""
        always = _list_laws(self.laws)
        if self.laws_without is None:
            return always
        parameter, more = self.laws_without
        return f"{always}; with {parameter} = 0 also {_list_laws(more)}"

    def parameter(self, name: str) -> Parameter:
        """Return the parameter called ``name``."""
        for each in self.parameters:
            if each.name == name:
                return each
        raise UnknownNameError(f"parameter of {self.name}", name, [each.name for each in self.parameters])


def models() -> dict[str, Model]:
    """Return all reduced models by name, in the order of the registry, in a new dictionary."""
    return dict(_registered())


@cache
def _registered() -> Mapping[str, Model]:
    result = {}
    for entry in _core.models():
        without = entry["laws_without"]
        lists = {
            "laws": tuple(entry["laws"]),
            "laws_without": (without[0], tuple(without[1])) if without else None,
            "parameters": tuple(Parameter(**each) for each in entry["parameters"]),
            "lacks": tuple(entry["lacks"]),
            "valid": tuple(ValidRange(**each) for each in entry["valid"]),
        }
        result[entry["name"]] = Model(**(entry | lists))
    return Frozen(result)


def models_with(parameter: str) -> list[str]:
    """Return the names of the reduced models that have this parameter."""
    return [name for name, each in models().items() if any(parameter == one.name for one in each.parameters)]


def _list_laws(laws: tuple[str, ...]) -> str:
    return ", ".join(each.replace("_", " ") for each in laws) or "none"


@cache
def further_models() -> Mapping[str, Model]:
    """Return the models of other backends by name; being slow, they are excluded from "all"."""
    return Frozen({name: import_module(module).MODEL for name, module in MODULES.items()})


def model(name: str) -> Model:
    """Return the model called ``name``; the error for an unknown name suggests the nearest."""
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
    """Return the names of all models, including other backends."""
    return (*_registered(), *MODULES, *OWN)


def differentiable_model(name: str) -> Model:
    """Return the reduced model or user-defined law called ``name``; other models have no derivatives of launches."""
    return OWN[name].MODEL if isinstance(name, str) and name in OWN else reduced_model(name, "one with derivatives")


def reduced_model(name: str, wanted: str) -> Model:
    """Return the reduced model called ``name``; raise InputError, which says what is ``wanted``, for other models."""
    if isinstance(name, str) and (name in MODULES or name in OWN):
        raise InputError("model", name, f"{wanted}: {', '.join(models())}")
    return model(name)
