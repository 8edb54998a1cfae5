"""Heads that deform: shells and solids, from a few dimensions or from your own mesh."""

from __future__ import annotations

from clubface.fem.heads.driver import DriverHead
from clubface.fem.heads.hardening import Hardening
from clubface.fem.heads.iron import IronHead
from clubface.fem.heads.meshed import MeshedHead
from clubface.fem.heads.metal import Metal
from clubface.fem.heads.read import head, head_names
from clubface.fem.heads.shells import Part, ShellHead
from clubface.fem.heads.solid import SolidHead
from clubface.fem.heads.user_mesh import Group, MeshHead

__all__ = [
    "DriverHead",
    "Group",
    "Hardening",
    "IronHead",
    "MeshHead",
    "MeshedHead",
    "Metal",
    "Part",
    "ShellHead",
    "SolidHead",
    "head",
    "head_names",
]
