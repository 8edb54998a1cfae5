"""STL, text and binary: triangles and nothing else."""

from __future__ import annotations

import struct

from clubface.errors import FileError
from clubface.fem.mesh_files.mesh import Mesh, MeshBuilder
from clubface.support.input_files import read_input

HEADER, FACET = 84, 50
"""Bytes of the header with the count, and of a triangle."""


def read(path: str) -> Mesh:
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
            _add(builder, None, number + 1, [corners[:3], corners[3:6], corners[6:]], ())
    elif content.lstrip()[:5].lower() == b"solid":
        _text(builder, content)
    else:
        told = (
            f"it says that it has {count} triangles, which are {HEADER + FACET * count} bytes, and has {len(content)}"
        )
        raise FileError(path, None, f"this mesh cannot be read: {told if count >= 0 else 'it is no STL'}")
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
            _add(builder, line, number, corners, [name] if solids > 1 and name else ())
            corners = []
    if corners:
        raise builder.error(len(lines), "the file ends in the middle of a facet")


def _add(builder: MeshBuilder, line: int | None, number: int, corners: object, sets: object) -> None:
    places = [tuple(builder.coordinate(line, each) for each in corner) for corner in corners]  # pyright: ignore
    for place in places:
        builder.add_node(line, place, builder.nodes + 1, place)
    builder.add_shell(line, number, places, sets, key=number)  # pyright: ignore
