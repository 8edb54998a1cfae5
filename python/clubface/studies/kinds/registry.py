"""The list of kinds of studies."""

from __future__ import annotations

from importlib import import_module

from clubface.studies.kinds.kind import Kind
from clubface.support.checks import check_choice

MODULES = {
    "impact": "clubface.studies.kinds.impacts",
    "comparison": "clubface.studies.kinds.comparisons",
    "map": "clubface.studies.kinds.maps",
    "dispersion": "clubface.studies.kinds.dispersions",
    "best-loft": "clubface.studies.kinds.best_lofts",
    "optimise": "clubface.studies.kinds.optimisations",
    "fem": "clubface.studies.kinds.fem_cases",
    "head": "clubface.studies.kinds.fem_heads",
    "capture": "clubface.studies.kinds.captures",
    "empty": "clubface.studies.kinds.empty",
}
"""The module of each kind of study."""


def kind(name: str) -> Kind:
    """Return a kind of study by name."""
    check_choice("kind", name, MODULES)
    return import_module(MODULES[name]).KIND
