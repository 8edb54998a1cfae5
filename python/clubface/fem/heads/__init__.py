"""Heads that deform: shells and solids, from a few dimensions or from your own mesh."""

from __future__ import annotations

from clubface.fem.heads.driver import DriverHead as DriverHead
from clubface.fem.heads.iron import IronHead as IronHead
from clubface.fem.heads.mesh_groups import Group as Group
from clubface.fem.heads.meshed import (
    MeshedClub as MeshedClub,
    MeshedHead as MeshedHead,
    Part as Part,
    ShellHead as ShellHead,
    SolidHead as SolidHead,
    mesh_of as mesh_of,
)
from clubface.fem.heads.metal import Hardening as Hardening, Metal as Metal
from clubface.fem.heads.read import head as head, head_names as head_names
from clubface.fem.heads.user_mesh import MeshHead as MeshHead
