"""The reader of each kind of mesh file, by what stands in it and by its ending; STL, and others by meshlane."""

from __future__ import annotations

import os
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

from clubface.errors import FileError, shortened
from clubface.fem.mesh_files import abaqus, gmsh, lsdyna, nastran
from clubface.fem.mesh_files.mesh import SOLID_CORNERS, Mesh, MeshBuilder
from clubface.support.files import as_local_file, input_file, read_input
from clubface.support.processes import IsolatedError, IsolatedProcess

LIBRARY = IsolatedProcess(Path(__file__).with_name("meshlane_library.py"))
MEMORY = 200
"""Bytes that the library may take for a byte of the file; it takes some 20."""
SPEED = 1e5
"""Bytes a second, slower than any machine reads them."""
NUMBERS = ("gmsh:physical", "medit:ref", "nastran:ref", "group", "part", "PartId", "GROUP_ID")
"""Data of elements that number their groups."""
SHELLS = ("triangle", "quad", "triangle6", "triangle7", "quad8", "quad9")
LINES = ("vertex", "line", "line3")


def read_other(path: str) -> Mesh:
    """Read a mesh through meshlane; elements have no numbers in such files and are counted from 1."""
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
    _add_contents(builder, contents)
    return builder.mesh()


def _add_contents(builder: MeshBuilder, contents: dict[str, Any]) -> None:
    for number, place in enumerate(contents["points"].tolist()):
        builder.add_node(None, number, number + 1, [*place, 0.0, 0.0][:3])
    tags = {
        int(value[0]): name for name, value in contents["field_data"].items() if len(value) > 1 and value[1] in (2, 3)
    }
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
            elif kind not in LINES and len(corners) in SOLID_CORNERS:
                builder.add_solid(None, element, corners, own)
            elif kind not in LINES:
                builder.left_out[f"of type {kind}"] += 1


HEADER, FACET = 84, 50
"""Bytes of the header with the count, and of a triangle."""


def read_stl(path: str) -> Mesh:
    """Read triangles, numbered from 1 as they stand; sets are the solids of a text file, if it has several."""
    builder = MeshBuilder(path)
    content = read_input(path)
    builder.notes.append(
        "STL has neither groups nor thicknesses, metals or numbers of elements: triangles are counted from 1"
    )
    count = struct.unpack_from("<I", content, HEADER - 4)[0] if len(content) >= HEADER else -1
    if len(content) == HEADER + FACET * count:
        for number in range(count):
            corners = struct.unpack_from("<9f", content, HEADER + FACET * number + 12)
            _add_triangle(builder, None, number + 1, [corners[:3], corners[3:6], corners[6:]], ())
    elif content.lstrip()[:5].lower() == b"solid":
        _text(builder, content)
    else:
        stated = (
            f"it says that it has {count} triangles, which are {HEADER + FACET * count} bytes, and has {len(content)}"
        )
        raise FileError(path, None, f"this mesh cannot be read: {stated if count >= 0 else 'it is no STL'}")
    return builder.mesh()


def _text(builder: MeshBuilder, content: bytes) -> None:
    lines = content.decode("utf-8", "replace").splitlines()
    solids = sum(text.split()[:1] in (["solid"], ["SOLID"]) for text in lines)
    corners: list[list[str]] = []
    name, number = "", 0
    for line, text in enumerate(lines, 1):
        word, *cells = text.split() or [""]
        word = word.lower()
        if word == "solid":
            name = " ".join(cells)
        elif word == "vertex":
            if len(cells) != 3:
                raise builder.error(line, f"this corner has {len(cells)} coordinates, not three")
            corners.append(cells)
        elif word == "endfacet":
            if len(corners) != 3:
                raise builder.error(line, f"this facet has {len(corners)} corners, not three")
            number += 1
            _add_triangle(builder, line, number, corners, [name] if solids > 1 and name else ())
            corners = []
    if corners:
        raise builder.error(len(lines), "the file ends in the middle of a facet")


def _add_triangle(builder: MeshBuilder, line: int | None, number: int, corners: object, sets: object) -> None:
    places = [tuple(builder.coordinate(line, each) for each in corner) for corner in corners]  # pyright: ignore
    for place in places:
        builder.add_node(line, place, builder.nodes + 1, place)
    builder.add_shell(line, number, places, sets, key=number)  # pyright: ignore


READERS: dict[str, Callable[[str], Mesh]] = {
    **dict.fromkeys((".msh", ".msh2", ".msh4"), gmsh.read),
    ".inp": abaqus.read,
    **dict.fromkeys((".bdf", ".nas", ".fem", ".blk", ".bulk"), nastran.read),
    **dict.fromkeys((".k", ".key", ".dyn", ".dyna"), lsdyna.read),
    ".stl": read_stl,
}
"""By ending."""
CAD = (".step", ".stp", ".iges", ".igs", ".x_t", ".x_b", ".sldprt", ".catpart", ".prt", ".3dm", ".ipt", ".brep")
"""Endings of surfaces and solids that no mesh generator has cut into elements."""
LOOKED_AT = 20_000
"""Bytes at the start of a file in which its kind is looked for."""


def read_mesh(path: str) -> Mesh:
    """Return the elements of a mesh file.

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
    return (_by_content(path) or READERS.get(ending, read_other))(path)


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
