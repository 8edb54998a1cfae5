"""clubface: how a golf club meets a ball in half a millisecond, and what the ball does next.

Every public name is loaded when it is first used, so that ``import clubface`` costs next to nothing.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from clubface import benchmark_data as benchmark_data
    from clubface import errors as errors
    from clubface import fem as fem
    from clubface import launch_monitor as launch_monitor
    from clubface import units as units
    from clubface.balls import Ball as Ball
    from clubface.balls import ball as ball
    from clubface.clubs import Club as Club
    from clubface.clubs import club as club
    from clubface.errors import ClubfaceError as ClubfaceError
    from clubface.models import Model as Model
    from clubface.models import models as models
    from clubface.parameters import ParameterSet as ParameterSet

__version__ = "0.1.0"

_HOME = {
    "Air": "air",
    "Ball": "balls",
    "Club": "clubs",
    "ClubfaceError": "errors",
    "Comparison": "launch",
    "Delivery": "delivery",
    "Flight": "flight",
    "History": "history",
    "Identification": "identify",
    "Launch": "launch",
    "Model": "models",
    "ParameterSet": "parameters",
    "PredictReport": "predict",
    "RecordedShots": "recorded",
    "Sensitivity": "sensitivity",
    "Trajectory": "trajectory",
    "Evaluation": "evaluation.evaluate",
    "Posterior": "inference.infer",
    "Prior": "inference.prior",
    "ball": "balls",
    "club": "clubs",
    "evaluate": "evaluation.evaluate",
    "fly": "flight",
    "history": "history",
    "identify": "identify",
    "impact": "impact",
    "infer": "inference.infer",
    "models": "models",
    "predict": "predict",
    "read_shots": "recorded",
    "sensitivity": "sensitivity",
    "trajectory": "trajectory",
}
"""The module in which each public name is defined."""

_MODULES = ("benchmark_data", "errors", "fem", "launch_monitor", "motion_capture", "units")

__all__ = [*_HOME, *_MODULES]  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        found = getattr(import_module(f"clubface.{_HOME[name]}"), name)
        globals()[name] = found
        return found
    if name in _MODULES:
        return import_module(f"clubface.{name}")
    raise AttributeError(f"module 'clubface' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])


class _Package(ModuleType):
    """Keeps ``clubface.impact`` the function although a module of that name exists.

    Importing a submodule sets it as an attribute of its package; here a public name wins.
    """

    def __setattr__(self, name: str, value: object) -> None:
        if not (name in _HOME and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package
