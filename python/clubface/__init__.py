"""clubface: how a golf club meets a ball in half a millisecond, and what the ball does next.

Every public name is loaded when it is first used, so that ``import clubface`` costs next to nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from clubface.equipment.backends import CLUB_FILES, MODULES
from clubface.support.version import __version__ as __version__

if TYPE_CHECKING:
    from clubface import (
        benchmark_data as benchmark_data,
        errors as errors,
        fem as fem,
        launch_monitor as launch_monitor,
        measurements as measurements,
        studies as studies,
        units as units,
    )
    from clubface.equipment.balls import Ball as Ball, ball as ball
    from clubface.equipment.clubs import Club as Club, club as club
    from clubface.equipment.models import Model as Model, models as models
    from clubface.equipment.parameters import ParameterSet as ParameterSet
    from clubface.errors import ClubfaceError as ClubfaceError


_HOME = {
    "Air": "simulation.air",
    "Alternative": "design.comparison.comparison",
    "Ball": "equipment.balls",
    "Club": "equipment.clubs",
    "ClubfaceError": "errors",
    "Compared": "design.comparison.comparison",
    "Comparison": "simulation.launch",
    "ConditionedLaunch": "simulation.launch_conditioned",
    "Delivery": "simulation.delivery",
    "Dispersion": "design.dispersion.sampling",
    "FaceMap": "design.face_map.face_map",
    "FaceMapDifference": "design.face_map.difference",
    "Evaluation": "evaluation.evaluation",
    "Flight": "simulation.flight",
    "Golfer": "design.golfer.golfer",
    "History": "simulation.history",
    "Hole": "design.strokes",
    "Identification": "identification.result",
    "Launch": "simulation.launch",
    "Model": "equipment.models",
    "ParameterSet": "equipment.parameters",
    "Posterior": "inference.posterior",
    "PredictReport": "prediction.predict",
    "Prior": "inference.prior",
    "RecordedShots": "recorded.shots",
    "Sensitivity": "simulation.sensitivity",
    "Touch": "simulation.contact_motion",
    "Trajectory": "simulation.trajectory",
    "ball": "equipment.balls",
    "best_loft": "design.best_loft",
    "club": "equipment.clubs",
    "compare": "design.comparison.comparison",
    "dispersion": "design.dispersion.sampling",
    "estimate_golfer": "design.golfer.estimate",
    "evaluate": "evaluation.evaluation",
    "fit": "design.optimisation.fitting_run",
    "fly": "simulation.flight",
    "golfer": "design.golfer.golfers",
    "golfers": "design.golfer.golfers",
    "history": "simulation.history",
    "identify": "identification.run",
    "impact": "simulation.impact",
    "impact_at_launch": "simulation.launch_conditioned",
    "infer": "inference.run",
    "map_face": "design.face_map.face_map",
    "models": "equipment.models",
    "optimise": "design.optimisation.run",
    "predict": "prediction.predict",
    "read_shots": "launch_monitor.reading",
    "register_law": "simulation.own_law",
    "sensitivity": "simulation.sensitivity",
    "trajectory": "simulation.trajectory",
}
"""The module in which each public name is defined."""

_MODULES = ("benchmark_data", "errors", "fem", "launch_monitor", "measurements", "motion_capture", "studies", "units")

MODULES["fem"] = "clubface.fem.backend"
CLUB_FILES["shape"] = CLUB_FILES["groups"] = "clubface.fem.heads.read"

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
