"""Mesh files, read through meshio: the groups of their elements, and one sentence for what is wrong with a file."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from clubface.errors import FileError, in_a_line, shortened
from clubface.fem.heads.mesh_lines import check_lines
from clubface.support.input_files import as_local_file, input_file
from clubface.support.isolated import IsolatedError, IsolatedProcess

LIBRARY = IsolatedProcess(Path(__file__).with_name("meshio_library.py"))
MEMORY = 200
"""Bytes that the library may take for a byte of the file; it takes some 20."""
SPEED = 1e5
"""Bytes a second, slower than any machine reads them."""


class Mesh(NamedTuple):
    """A mesh as meshio has it, without what no head needs.

    Attributes
    ----------
    points
        Places of the nodes, shape (nodes, 3).
    cells
        Blocks of elements: their kind, and their nodes.
    field_data, cell_data, cell_sets
        Names and numbers of groups.
    """

    points: Any
    cells: Sequence[tuple[str, Any]]
    field_data: Mapping[str, Any]
    cell_data: Mapping[str, Any]
    cell_sets: Mapping[str, Any]


def read_mesh(path: str) -> Mesh:
    """Return the mesh in a file.

    Raises
    ------
    FileError
        There is no such file, or meshio cannot read it. What the readers of meshio print is left out, or part of the
        message. In text files of Gmsh and Abaqus, the line of a damaged node is named.
    """
    if not os.path.exists(path):
        raise FileError(path, None, "there is no such file")
    size = input_file(path).size
    check_lines(path)
    with as_local_file(path) as local:
        try:
            found = LIBRARY.call("contents", local, memory=MEMORY * size, seconds=size / SPEED)
        except IsolatedError as error:
            reason = shortened(str(error).replace(local, path), 200)
            raise FileError(path, None, f"this mesh cannot be read: {reason}") from None
    notes = found.pop("notes")
    if notes.strip():
        print(in_a_line(f"{path}: {shortened(' '.join(notes.split()), 200)}"), file=sys.stderr)
    return Mesh(**found)


def group_names(mesh: Mesh, path: str) -> list[list[str]]:
    """Return the name of the group of each element, by block."""
    names = [[""] * len(data) for _, data in mesh.cells]
    # Physical groups of Gmsh: numbers on the elements, names in the field data.
    tags = {int(value[0]): name for name, value in mesh.field_data.items() if len(value) > 1 and value[1] == 2}
    for key in ("gmsh:physical", "medit:ref", "group", "part"):
        for block, values in enumerate(mesh.cell_data.get(key, [])):
            names[block] = [tags.get(int(value), str(int(value))) for value in values]
    for name, sets in mesh.cell_sets.items():
        for block, members in enumerate(sets):
            for member in () if members is None else members:
                names[block][int(member)] = name
    for (kind, _), each in zip(mesh.cells, names, strict=True):
        if kind == "quad" and "" in each:
            message = f"element {each.index('')} belongs to no group; name physical groups or cell sets in the mesh"
            raise FileError(path, None, message)
    return names
