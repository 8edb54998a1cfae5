"""Explicit finite elements: a meshed ball strikes a rigid plane or a clubhead, from first touch to launch.

A :class:`Ball` is made of pieces, each of a :class:`Material`; :func:`ball` reads one by name or from TOML.
:func:`strike` hits it with a club and :func:`throw` throws it at a rigid plane. Both return an :class:`Impact` with
forces, motion, energies and the figures of Roh and Lee ("Analysis of golf ball spin mechanism at impact by FEM").
"""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

from clubface.fem.balls import Ball, Piece, ball, ball_names
from clubface.fem.heads import (
    Bond,
    DriverHead,
    Hardening,
    IronHead,
    MeshedHead,
    MeshHead,
    Metal,
    ShellHead,
    SolidHead,
    SolidPart,
    head,
    head_names,
)
from clubface.fem.materials import Energy, LawFunction, Material, Maxwell, laws, register_law
from clubface.fem.paper import reference
from clubface.fem.result import ElementFields, Impact
from clubface.fem.run import Derivatives, sensitivity, strike, throw, variables
from clubface.fem.settings import Settings

__all__ = [
    "Ball", "Bond", "Derivatives", "DriverHead", "ElementFields", "Energy", "Hardening", "Impact", "IronHead",
    "LawFunction", "Material", "Maxwell", "MeshHead", "MeshedHead", "Metal", "Piece", "Settings", "ShellHead",
    "SolidHead", "SolidPart", "ball", "ball_names", "head", "head_names", "laws", "reference", "register_law",
    "sensitivity", "strike", "throw", "variables",
]  # fmt: skip

_MODULES = (
    "case", "files", "head_result", "head_tests", "impact_result", "keyword", "paper", "pictures", "reduced",
    "section_picture", "stress", "sweep",
)  # fmt: skip


def __getattr__(name: str) -> ModuleType:
    """Import the less common modules on first use."""
    if name in (*_MODULES, "face_map", "vtu"):  # the last two have moved
        return import_module(f"clubface.fem.{name}")
    raise AttributeError(f"module 'clubface.fem' has no attribute {name!r}")
