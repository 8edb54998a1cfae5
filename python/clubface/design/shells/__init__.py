"""Design of shell heads: a fast model proposes, finite elements decide."""

from __future__ import annotations

from typing import TYPE_CHECKING

from clubface.design.shells.families import MetalChoice, NamedMetal
from clubface.design.shells.run import improve
from clubface.design.shells.study import FaceImpact, ShellStudy, read
from clubface.design.shells.trust_region import Goal, SearchResult, Step, trust_region_search
from clubface.support.renamed import renamed_names

__all__ = [
    "FaceImpact", "Goal", "MetalChoice", "NamedMetal", "SearchResult", "ShellStudy", "Step", "improve", "read",
    "trust_region_search",
]  # fmt: skip

if not TYPE_CHECKING:
    __getattr__ = renamed_names(__name__, Blow="FaceImpact")
