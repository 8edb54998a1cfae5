"""From a model to a better club: comparisons, face maps, golfers, dispersion and optimisation.

Everything here works with any impact model, including finite elements, and with the flight that follows.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from clubface.support.renamed import warn_renamed

if TYPE_CHECKING:
    from clubface.design.best_loft import (
        BestLoft as BestLoft,
        ChartComparison as ChartComparison,
        best_loft_picture as best_loft_picture,
        compare_with_chart as compare_with_chart,
    )
    from clubface.design.comparison import comparison_picture as comparison_picture, read_deliveries as read_deliveries
    from clubface.design.contributions import Change as Change, Contributions as Contributions
    from clubface.design.dispersion import Ellipse as Ellipse, ImpactSetup as ImpactSetup, shots_file as shots_file
    from clubface.design.dispersion_result import dispersion_picture as dispersion_picture
    from clubface.design.face_map import Best as Best, Forgiveness as Forgiveness
    from clubface.design.face_map_result import face_map_picture as face_map_picture
    from clubface.design.face_surface import Outline as Outline
    from clubface.design.feasibility import (
        Envelope as Envelope,
        Margin as Margin,
        Volume as Volume,
        mass_properties as mass_properties,
        pseudo_inertia as pseudo_inertia,
        refuse_impossible as refuse_impossible,
    )
    from clubface.design.golfer import to_toml as to_toml, uniform as uniform
    from clubface.design.golfer_estimate import (
        Estimate as Estimate,
        SpreadSensitivity as SpreadSensitivity,
        doubts as doubts,
    )
    from clubface.design.golfer_result import doubts_picture as doubts_picture
    from clubface.design.loft_fit import LoftFit as LoftFit, fit_loft as fit_loft, steady_golfer as steady_golfer
    from clubface.design.optimisation.advice import WORTH as WORTH, Advice as Advice
    from clubface.design.optimisation.fitting import Fitting as Fitting
    from clubface.design.optimisation.fitting_run import (
        Combination as Combination,
        Effect as Effect,
        Fitted as Fitted,
        fitting_picture as fitting_picture,
    )
    from clubface.design.optimisation.result import (
        Fresh as Fresh,
        FrontPoint as FrontPoint,
        Optimum as Optimum,
        Verdict as Verdict,
        optimum_picture as optimum_picture,
    )
    from clubface.design.optimisation.study import DesignStudy as DesignStudy, Head as Head, from_text as from_text
    from clubface.design.optimisation.variables import PointMass as PointMass
    from clubface.design.rules import Rule as Rule, RuleVerdict as RuleVerdict, check_rules as check_rules
    from clubface.design.shells.run import Improved as Improved, Search as Search, search_picture as search_picture
    from clubface.design.strokes import expected as expected
    from clubface.design.variance import (
        ByDerivatives as ByDerivatives,
        Indices as Indices,
        by_derivatives as by_derivatives,
        indices as indices,
        indices_by_derivatives as indices_by_derivatives,
        shapley as shapley,
        sobol as sobol,
    )

_NAMES = {
    "best_loft": "BestLoft ChartComparison best_loft_picture compare_with_chart",
    "comparison": "comparison_picture read_deliveries",
    "contributions": "Change Contributions",
    "dispersion": "Ellipse ImpactSetup shots_file",
    "dispersion_result": "dispersion_picture",
    "face_map": "Best Forgiveness",
    "face_map_result": "face_map_picture",
    "face_surface": "Outline",
    "feasibility": "Envelope Margin Volume mass_properties pseudo_inertia refuse_impossible",
    "golfer": "to_toml uniform",
    "golfer_estimate": "Estimate SpreadSensitivity doubts",
    "golfer_result": "doubts_picture",
    "loft_fit": "LoftFit fit_loft steady_golfer",
    "optimisation.advice": "Advice WORTH",
    "optimisation.fitting": "Fitting",
    "optimisation.fitting_run": "Combination Effect Fitted fitting_picture",
    "optimisation.result": "Fresh FrontPoint Optimum Verdict optimum_picture",
    "optimisation.study": "DesignStudy Head from_text",
    "optimisation.variables": "PointMass",
    "rules": "Rule RuleVerdict check_rules",
    "shells.run": "Improved Search search_picture",
    "strokes": "expected",
    "variance": "ByDerivatives Indices by_derivatives indices indices_by_derivatives shapley sobol",
}
_HOME = {name: module for module, names in _NAMES.items() for name in names.split()}

__all__ = [*_HOME]  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name == "Doubts":
        warn_renamed("clubface.design.Doubts", "SpreadSensitivity")
        name = "SpreadSensitivity"
    if name not in _HOME:
        raise AttributeError(f"module 'clubface.design' has no attribute {name!r}")
    return getattr(import_module(f"clubface.design.{_HOME[name]}"), name)
