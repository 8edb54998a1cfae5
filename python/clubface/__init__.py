"""clubface: how a golf club meets a ball in half a millisecond, and what the ball does next.

Every public name is loaded when it is first used, so that ``import clubface`` costs next to nothing.
"""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import TYPE_CHECKING, Any

from clubface.support.version import __version__ as __version__

if TYPE_CHECKING:
    from clubface import (
        capture as capture,
        design as design,
        errors as errors,
        export as export,
        fem as fem,
        inference as inference,
        plots as plots,
        present as present,
        published_data as published_data,
        schema as schema,
        shots as shots,
        simulation as simulation,
        studies as studies,
        units as units,
        validation as validation,
    )
    from clubface.design.best_loft import best_loft as best_loft
    from clubface.design.comparison import Alternative as Alternative, Compared as Compared, compare as compare
    from clubface.design.dispersion import Dispersion as Dispersion, dispersion as dispersion
    from clubface.design.face_map import (
        FaceMap as FaceMap,
        FaceMapDifference as FaceMapDifference,
        map_face as map_face,
    )
    from clubface.design.golfer import Golfer as Golfer, golfer as golfer, golfers as golfers
    from clubface.design.golfer_estimate import estimate_golfer as estimate_golfer
    from clubface.design.optimisation.fitting_run import fit as fit
    from clubface.design.optimisation.run import optimise as optimise
    from clubface.design.strokes import Hole as Hole
    from clubface.equipment.balls import Ball as Ball, ball as ball
    from clubface.equipment.clubs import Club as Club, club as club
    from clubface.equipment.models import Model as Model, Parameter as Parameter, models as models
    from clubface.equipment.parameters import ParameterSet as ParameterSet
    from clubface.equipment.shafts import Shaft as Shaft
    from clubface.errors import ClubfaceError as ClubfaceError
    from clubface.inference.evaluation.evaluation import evaluate as evaluate
    from clubface.inference.evaluation.result import Evaluation as Evaluation
    from clubface.inference.identification.result import Identification as Identification
    from clubface.inference.identification.run import identify as identify
    from clubface.inference.posterior import Posterior as Posterior
    from clubface.inference.prior import Prior as Prior
    from clubface.inference.run import infer as infer
    from clubface.shots.prediction import PredictReport as PredictReport, predict as predict
    from clubface.shots.reading import read_shots as read_shots
    from clubface.shots.recorded import RecordedShots as RecordedShots
    from clubface.simulation.explanation import Explanation as Explanation, explain as explain
    from clubface.simulation.flight import (
        Air as Air,
        Flight as Flight,
        Trajectory as Trajectory,
        fly as fly,
        trajectory as trajectory,
    )
    from clubface.simulation.history import History as History, history as history
    from clubface.simulation.hosel import HoselReaction as HoselReaction, hosel_reaction as hosel_reaction
    from clubface.simulation.impact import impact as impact
    from clubface.simulation.inputs import Delivery as Delivery
    from clubface.simulation.launch import Comparison as Comparison, Launch as Launch
    from clubface.simulation.launch_conditioned import (
        ConditionedLaunch as ConditionedLaunch,
        impact_at_launch as impact_at_launch,
    )
    from clubface.simulation.multibody import SteppedContact as SteppedContact, StruckBall as StruckBall
    from clubface.simulation.own_law import register_law as register_law
    from clubface.simulation.sensitivity import Sensitivity as Sensitivity, sensitivity as sensitivity
    from clubface.simulation.two_bodies import Touch as Touch


_NAMES = {
    "design.best_loft": "best_loft",
    "design.comparison": "Alternative Compared compare",
    "design.dispersion": "Dispersion dispersion",
    "design.face_map": "FaceMap FaceMapDifference map_face",
    "design.golfer": "Golfer golfer golfers",
    "design.golfer_estimate": "estimate_golfer",
    "design.optimisation.fitting_run": "fit",
    "design.optimisation.run": "optimise",
    "design.strokes": "Hole",
    "equipment.balls": "Ball ball",
    "equipment.clubs": "Club club",
    "equipment.models": "Model Parameter models",
    "equipment.parameters": "ParameterSet",
    "equipment.shafts": "Shaft",
    "errors": "ClubfaceError",
    "inference.evaluation.evaluation": "evaluate",
    "inference.evaluation.result": "Evaluation",
    "inference.identification.result": "Identification",
    "inference.identification.run": "identify",
    "inference.posterior": "Posterior",
    "inference.prior": "Prior",
    "inference.run": "infer",
    "shots.prediction": "PredictReport predict",
    "shots.reading": "read_shots",
    "shots.recorded": "RecordedShots",
    "simulation.explanation": "Explanation explain",
    "simulation.flight": "Air Flight Trajectory fly trajectory",
    "simulation.history": "History history",
    "simulation.hosel": "HoselReaction hosel_reaction",
    "simulation.impact": "impact",
    "simulation.inputs": "Delivery",
    "simulation.launch": "Comparison Launch",
    "simulation.launch_conditioned": "ConditionedLaunch impact_at_launch",
    "simulation.multibody": "SteppedContact StruckBall",
    "simulation.own_law": "register_law",
    "simulation.sensitivity": "Sensitivity sensitivity",
    "simulation.two_bodies": "Touch",
}
_HOME = {name: module for module, names in _NAMES.items() for name in names.split()}
"""The module in which each public name is defined."""

_MODULES = (
    "capture", "design", "errors", "export", "fem", "inference", "plots", "present", "published_data", "schema",
    "shots", "simulation", "studies", "units", "validation",
)  # fmt: skip

_ARRAY_LIBRARIES = ("chain", "jax", "torch")
"""Modules for libraries that come with extras; ``from clubface import *`` leaves them out."""

_MOVED = {
    "benchmark_data": "validation.benchmark_data",
    "evaluation": "inference.evaluation",
    "fem.face_map": "fem.head_tests",
    "fem.vtu": "fem.files",
    "identification": "inference.identification",
    "launch_monitor": "shots",
    "measured_shots": "shots.measured",
    "measurements": "published_data",
    "motion_capture": "capture",
}
"""The new name of each renamed public module; the old names still work, with a warning."""

__all__ = [*_HOME, *_MODULES]  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        value = getattr(import_module(f"clubface.{_HOME[name]}"), name)
        globals()[name] = value
        return value
    if name in (*_MODULES, *_ARRAY_LIBRARIES, *_MOVED):
        return import_module(f"clubface.{name}")
    raise AttributeError(f"module 'clubface' has no attribute {name!r}")


class _MovedModules:
    """Imports modules under their old names, with a warning that gives the new name."""

    def __init__(self, name: str = "") -> None:
        self.name = name

    @classmethod
    def find_spec(cls, name: str, path: Any = None, target: Any = None) -> ModuleSpec | None:
        """Return the spec of a renamed module, or of a module in a renamed package."""
        for old, new in _MOVED.items():
            if f"{name}.".startswith(f"clubface.{old}."):
                home = name.replace(f"clubface.{old}", f"clubface.{new}", 1)
                return ModuleSpec(name, cls(home))  # pyright: ignore[reportArgumentType]
        return None

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Return the module under its new name."""
        from clubface.support.renamed import warn_renamed

        warn_renamed(spec.name, self.name)
        module = import_module(self.name)
        self.spec = module.__spec__
        return module

    def exec_module(self, module: ModuleType) -> None:
        """Leave the module as it is."""
        module.__spec__ = self.spec


sys.meta_path.insert(0, _MovedModules)


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])
