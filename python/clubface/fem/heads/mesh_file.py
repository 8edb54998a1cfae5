"""Mesh files, read through meshio: the groups of their elements, and one sentence for what is wrong with a file."""

from __future__ import annotations

import os
import sys
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from typing import Any

from clubface.errors import FileError


def read_mesh(path: str) -> Any:
    """Return the mesh in a file, as meshio's ``Mesh``.

    Raises
    ------
    FileError
        There is no such file, or meshio cannot read it. What the readers of meshio print is left out, or part of the
        message.
    """
    import meshio

    if not os.path.isfile(path):
        raise FileError(path, None, "there is no such file")
    out, notes = StringIO(), StringIO()
    try:
        with redirect_stdout(out), redirect_stderr(notes):
            mesh = meshio.read(path)
    except SystemExit:
        # All readers for this kind of name have tried, and printed why they gave up.
        tried = " ".join(out.getvalue().split()) or f"it does not hold what files of this name ({_ending(path)}) hold"
        raise FileError(path, None, f"this mesh cannot be read: {tried}") from None
    # Readers raise whatever a broken file makes them stumble over.
    except Exception as error:
        reason = " ".join(str(error).split()) or type(error).__name__
        raise FileError(path, None, f"this mesh cannot be read: {reason}") from None
    sys.stderr.write(notes.getvalue())
    return mesh


def _ending(path: str) -> str:
    return os.path.splitext(path)[1]


def group_names(mesh: Any, path: str) -> list[list[str]]:
    """Return the name of the group of each element, by block."""
    names = [[""] * len(block.data) for block in mesh.cells]
    # Physical groups of Gmsh: numbers on the elements, names in the field data.
    tags = {int(value[0]): name for name, value in mesh.field_data.items() if len(value) > 1 and value[1] == 2}
    for key in ("gmsh:physical", "medit:ref", "group", "part"):
        for block, values in enumerate(mesh.cell_data.get(key, [])):
            names[block] = [tags.get(int(value), str(int(value))) for value in values]
    for name, sets in mesh.cell_sets.items():
        for block, members in enumerate(sets):
            for member in () if members is None else members:
                names[block][int(member)] = name
    for block, each in zip(mesh.cells, names, strict=True):
        if block.type == "quad" and "" in each:
            message = f"element {each.index('')} belongs to no group; name physical groups or cell sets in the mesh"
            raise FileError(path, None, message)
    return names
