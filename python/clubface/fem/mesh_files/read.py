"""The reader of each kind of mesh file, by what stands in it and by the ending of its name."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from clubface.errors import FileError
from clubface.fem.mesh_files import abaqus, gmsh, lsdyna, nastran, other, stl
from clubface.fem.mesh_files.mesh import Mesh
from clubface.support.input_files import read_input

READERS: dict[str, Callable[[str], Mesh]] = {
    **dict.fromkeys((".msh", ".msh2", ".msh4"), gmsh.read),
    ".inp": abaqus.read,
    **dict.fromkeys((".bdf", ".nas", ".fem", ".blk", ".bulk"), nastran.read),
    **dict.fromkeys((".k", ".key", ".dyn", ".dyna"), lsdyna.read),
    ".stl": stl.read,
}
"""By ending."""
CAD = (".step", ".stp", ".iges", ".igs", ".x_t", ".x_b", ".sldprt", ".catpart", ".prt", ".3dm", ".ipt", ".brep")
"""Endings of surfaces and solids that no mesh generator has cut into elements."""
LOOKED_AT = 20_000
"""Bytes at the start of a file in which its kind is looked for."""


def read_mesh(path: str) -> Mesh:
    """Return the shells of a mesh file.

    Raises
    ------
    FileError
        There is no such file, it cannot be read, or it is damaged; the line is named where there are lines.
    """
    if not os.path.exists(path):
        raise FileError(path, None, "there is no such file")
    ending = Path(path).suffix.lower()
    if ending in CAD:
        message = "this is a CAD file without a mesh; mesh its middle surfaces with shells first, with Gmsh for example"
        raise FileError(path, None, message)
    return (_by_content(path) or READERS.get(ending, other.read))(path)


def _by_content(path: str) -> Callable[[str], Mesh] | None:
    """Return the reader of a file that shows what it is, whatever its name."""
    content = read_input(path)[:LOOKED_AT]
    if content.startswith(b"$MeshFormat") or b"\n$MeshFormat" in content:
        return gmsh.read
    words = {line.split(b",")[0].strip().upper() for line in content.split(b"\n") if line.startswith(b"*")}
    if b"*KEYWORD" in words or any(word.startswith((b"*ELEMENT_SHELL", b"*PART_")) for word in words):
        return lsdyna.read
    if words & {b"*HEADING", b"*PART", b"*ELEMENT"} and Path(path).suffix.lower() != ".k":
        return abaqus.read
    lines = content.upper().split(b"\n")
    if any(line.startswith((b"BEGIN BULK", b"GRID ", b"GRID*", b"GRID,", b"GRID\t")) for line in lines):
        return nastran.read
    return None
