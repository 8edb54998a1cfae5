"""Mesh files as mesh generators write them: Gmsh, Abaqus, Nastran, LS-DYNA and STL; other formats through meshlane."""

from __future__ import annotations

from clubface.fem.mesh_files.mesh import Mesh as Mesh, Wall as Wall
from clubface.fem.mesh_files.read import read_mesh as read_mesh
