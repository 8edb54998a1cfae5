"""Deformable heads of shells or solid elements, from a few dimensions or from your own mesh."""

from __future__ import annotations

from clubface.fem.heads.mesh_groups import Group
from clubface.fem.heads.meshed import Bond, MeshedClub, MeshedHead, Part, ShellHead, SolidHead, SolidPart, mesh_of
from clubface.fem.heads.metal import Hardening, Metal
from clubface.fem.heads.parametric import DriverHead, IronHead
from clubface.fem.heads.read import head, head_names, head_text
from clubface.fem.heads.user_mesh import MeshHead

__all__ = [
    "Bond", "DriverHead", "Group", "Hardening", "IronHead", "MeshHead", "MeshedClub", "MeshedHead", "Metal", "Part",
    "ShellHead", "SolidHead", "SolidPart", "head", "head_names", "head_text", "mesh_of",
]  # fmt: skip
