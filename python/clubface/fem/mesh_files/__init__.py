"""Readers of mesh files: Gmsh, Abaqus, Nastran, LS-DYNA and STL; other formats through meshlane."""

from __future__ import annotations

from clubface.fem.mesh_files.mesh import SOLIDS, Mesh, Wall
from clubface.fem.mesh_files.read import read_mesh

__all__ = ["SOLIDS", "Mesh", "Wall", "read_mesh"]
