"""Other formats, such as VTK and PLY, read through meshio."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from clubface.errors import FileError, shortened
from clubface.fem.mesh_files.mesh import Mesh, MeshBuilder
from clubface.support.input_files import as_local_file, input_file
from clubface.support.isolated import IsolatedError, IsolatedProcess

LIBRARY = IsolatedProcess(Path(__file__).with_name("meshio_library.py"))
MEMORY = 200
"""Bytes that the library may take for a byte of the file; it takes some 20."""
SPEED = 1e5
"""Bytes a second, slower than any machine reads them."""
NUMBERS = ("gmsh:physical", "medit:ref", "nastran:ref", "group", "part", "PartId", "GROUP_ID")
"""Data of elements that number their groups."""
SHELLS = ("triangle", "quad", "triangle6", "triangle7", "quad8", "quad9")
LINES = ("vertex", "line", "line3")


def read(path: str) -> Mesh:
    """Read a mesh through meshio; elements have no numbers in such files and are counted from 1."""
    size = input_file(path).size
    with as_local_file(path) as local:
        try:
            contents = LIBRARY.call("contents", local, memory=MEMORY * size, seconds=size / SPEED)
        except IsolatedError as error:
            reason = shortened(str(error).replace(local, path), 200)
            raise FileError(path, None, f"this mesh cannot be read: {reason}") from None
    builder = MeshBuilder(path)
    if notes := " ".join(contents["notes"].split()):
        builder.notes.append(shortened(notes, 200))
    _add(builder, contents)
    return builder.mesh()


def _add(builder: MeshBuilder, contents: dict[str, Any]) -> None:
    for number, place in enumerate(contents["points"].tolist()):
        builder.add_node(None, number, number + 1, [*place, 0.0, 0.0][:3])
    tags = {int(value[0]): name for name, value in contents["field_data"].items() if len(value) > 1 and value[1] == 2}
    builder.aliases = {str(number): name for number, name in tags.items()}
    element = 0
    for block, (kind, nodes) in enumerate(contents["cells"]):
        names: list[list[str]] = [[] for _ in nodes]
        for key in NUMBERS:
            for each, value in zip(
                names, contents["cell_data"][key][block] if key in contents["cell_data"] else (), strict=False
            ):
                each.append(tags.get(int(value), str(int(value))))
        for name, sets in contents["cell_sets"].items():
            for member in sets[block] if block < len(sets) and sets[block] is not None else ():
                if 0 <= int(member) < len(names):
                    names[int(member)].append(name)
        for corners, own in zip(nodes.tolist(), names, strict=True):
            element += 1
            if kind in SHELLS:
                builder.add_shell(None, element, corners, own)
            elif kind not in LINES:
                builder.add_solid(kind, own[0] if own else "")
