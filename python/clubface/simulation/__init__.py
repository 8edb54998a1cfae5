"""One impact and one flight: deliveries in, launches, histories, derivatives and trajectories out.

The functions themselves are in :mod:`clubface`; this package holds the classes that they return, and the plots.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from clubface.simulation.explanation import WhatIf as WhatIf, explanation_picture as explanation_picture
    from clubface.simulation.multibody import (
        BallMotion as BallMotion,
        StepLoads as StepLoads,
        Wrench as Wrench,
        WrenchDerivatives as WrenchDerivatives,
    )
    from clubface.simulation.pose import Pose as Pose
    from clubface.simulation.sensitivity import (
        FlightDerivatives as FlightDerivatives,
        flight_derivatives as flight_derivatives,
    )
    from clubface.simulation.shot_shape import curve as curve

_NAMES = {
    "explanation": "WhatIf explanation_picture",
    "multibody": "BallMotion StepLoads Wrench WrenchDerivatives",
    "pose": "Pose",
    "sensitivity": "FlightDerivatives flight_derivatives",
    "shot_shape": "curve",
}
_HOME = {name: module for module, names in _NAMES.items() for name in names.split()}

__all__ = [*_HOME]  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'clubface.simulation' has no attribute {name!r}")
    return getattr(import_module(f"clubface.simulation.{_HOME[name]}"), name)
