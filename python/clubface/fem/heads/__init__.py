"""Heads that deform: shells, from a few dimensions or from one's own mesh."""

from __future__ import annotations

from clubface.fem.heads.driver import DriverHead
from clubface.fem.heads.metal import Metal
from clubface.fem.heads.read import head, head_names
from clubface.fem.heads.shells import Part, ShellHead
from clubface.fem.heads.user_mesh import Group, MeshHead

__all__ = ["DriverHead", "Group", "MeshHead", "Metal", "Part", "ShellHead", "head", "head_names"]
