"""Explicit finite elements: a meshed ball against a rigid plane or a clubhead, from first touch to launch.

A :class:`Ball` is made of pieces, each of a :class:`Material`; :func:`ball` reads one by name or from TOML.
:func:`strike` hits it with a club and :func:`throw` throws it at a rigid plane. Both return an :class:`Impact` with
forces, motion, energies and the figures of Roh and Lee ("Analysis of golf ball spin mechanism at impact by FEM").
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

from clubface.fem.balls import Ball as Ball, Piece as Piece, ball as ball, ball_names as ball_names
from clubface.fem.derivatives import Derivatives as Derivatives, sensitivity as sensitivity, variables as variables
from clubface.fem.heads import (
    DriverHead as DriverHead,
    Hardening as Hardening,
    IronHead as IronHead,
    MeshedHead as MeshedHead,
    MeshHead as MeshHead,
    Metal as Metal,
    ShellHead as ShellHead,
    SolidHead as SolidHead,
    head as head,
    head_names as head_names,
)
from clubface.fem.materials import Material as Material, Maxwell as Maxwell, laws as laws
from clubface.fem.paper import reference as reference
from clubface.fem.result import ElementFields as ElementFields, Impact as Impact
from clubface.fem.run import strike as strike, throw as throw
from clubface.fem.settings import Settings as Settings

_MODULES = ("case", "files", "head_tests", "keyword", "paper", "reduced", "stress", "sweep")


def __getattr__(name: str) -> Any:
    """Import the modules that not every user needs when they are first named."""
    if name in (*_MODULES, "face_map", "vtu"):  # the last two have moved
        return import_module(f"clubface.fem.{name}")
    raise AttributeError(f"module 'clubface.fem' has no attribute {name!r}")
