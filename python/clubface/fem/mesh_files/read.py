"""Choice of a reader for a mesh file by content and name; readers of STL, and of other formats through meshlane."""

from __future__ import annotations

import os
import struct
from collections.abc import Sequence
from pathlib import Path

from clubface.errors import FileError, shortened
from clubface.fem.mesh_files.abaqus import AbaqusReader
from clubface.fem.mesh_files.gmsh import GmshReader
from clubface.fem.mesh_files.lsdyna import DeckReader
from clubface.fem.mesh_files.mesh import SOLID_CORNERS, Mesh, MeshBuilder
from clubface.fem.mesh_files.nastran import NastranReader
from clubface.support.files import as_local_file, input_file, read_input
from clubface.support.processes import IsolatedError, IsolatedProcess

LIBRARY = IsolatedProcess(Path(__file__).with_name("meshlane_library.py"))
MEMORY = 200
"""Memory limit for the library in bytes per byte of the file; it needs about 20."""
SPEED = 1e5
"""Assumed reading speed for the time limit [bytes/s], slower than any machine."""
NUMBERS = ("gmsh:physical", "medit:ref", "nastran:ref", "group", "part", "PartId", "GROUP_ID")
"""Names of element data that hold group numbers."""
SHELLS = ("triangle", "quad", "triangle6", "triangle7", "quad8", "quad9")
LINES = ("vertex", "line", "line3")


class OtherReader(MeshBuilder):
    """Reads a mesh through meshlane; such files have no element numbers, so elements are numbered from 1."""

    def read(self) -> Mesh:
        """Read the file and return the mesh."""
        size = input_file(self.path).size
        with as_local_file(self.path) as local:
            try:
                contents = LIBRARY.call("contents", local, memory=MEMORY * size, seconds=size / SPEED)
            except IsolatedError as error:
                reason = shortened(str(error).replace(local, self.path), 200)
                raise self.error(None, f"this mesh cannot be read: {reason}") from None
        if notes := " ".join(contents["notes"].split()):
            self.notes.append(shortened(notes, 200))
        for number, place in enumerate(contents["points"].tolist()):
            self.add_node(None, number, number + 1, [*place, 0.0, 0.0][:3])
        fields, data = contents["field_data"].items(), contents["cell_data"]
        tags = {int(value[0]): name for name, value in fields if len(value) > 1 and value[1] in (2, 3)}
        self.aliases = {str(number): name for number, name in tags.items()}
        element = 0
        for block, (kind, nodes) in enumerate(contents["cells"]):
            names: list[list[str]] = [[] for _ in nodes]
            for key in NUMBERS:
                for each, value in zip(names, data[key][block] if key in data else (), strict=False):
                    each.append(tags.get(int(value), str(int(value))))
            for name, sets in contents["cell_sets"].items():
                for member in sets[block] if block < len(sets) and sets[block] is not None else ():
                    if 0 <= int(member) < len(names):
                        names[int(member)].append(name)
            for corners, own in zip(nodes.tolist(), names, strict=True):
                element += 1
                if kind in SHELLS:
                    self.add_shell(None, element, corners, own)
                elif kind not in LINES and len(corners) in SOLID_CORNERS:
                    self.add_solid(None, element, corners, own)
                elif kind not in LINES:
                    self.left_out[f"of type {kind}"] += 1
        return self.mesh()


HEADER, FACET = 84, 50
"""Bytes of the header including the count, and of a triangle."""


class StlReader(MeshBuilder):
    """Reads STL triangles, numbered from 1 in order; sets are the solids of a text file that has several."""

    def read(self) -> Mesh:
        """Read the file and return the mesh."""
        self.notes.append("STL has no groups, thicknesses, metals or element numbers: triangles are numbered from 1")
        content = read_input(self.path)
        count = struct.unpack_from("<I", content, HEADER - 4)[0] if len(content) >= HEADER else -1
        size = HEADER + FACET * count
        if len(content) == size:
            for number in range(count):
                corners = struct.unpack_from("<9f", content, HEADER + FACET * number + 12)
                self._triangle(None, number + 1, [corners[:3], corners[3:6], corners[6:]], ())
        elif content.lstrip()[:5].lower() == b"solid":
            self._text(content.decode("utf-8", "replace").splitlines())
        else:
            stated = f"{count} triangles are declared, which need {size} bytes, but it has {len(content)}"
            raise self.error(None, f"this mesh cannot be read: {stated if count >= 0 else 'it is not STL'}")
        return self.mesh()

    def _text(self, lines: list[str]) -> None:
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
                    raise self.error(line, f"this corner has {len(cells)} coordinates instead of three")
                corners.append(cells)
            elif word == "endfacet":
                if len(corners) != 3:
                    raise self.error(line, f"this facet has {len(corners)} corners instead of three")
                number += 1
                self._triangle(line, number, corners, [name] if solids > 1 and name else ())
                corners = []
        if corners:
            raise self.error(len(lines), "the file ends in the middle of a facet")

    def _triangle(
        self, line: int | None, number: int, corners: Sequence[Sequence[str | float]], sets: Sequence[str]
    ) -> None:
        places = [tuple(self.coordinate(line, each) for each in corner) for corner in corners]
        for place in places:
            self.add_node(line, place, self.nodes + 1, place)
        self.add_shell(line, number, places, sets, key=number)


Reader = type[GmshReader | AbaqusReader | NastranReader | DeckReader | StlReader | OtherReader]
READERS: dict[str, Reader] = {
    **dict.fromkeys((".msh", ".msh2", ".msh4"), GmshReader), ".inp": AbaqusReader,
    **dict.fromkeys((".bdf", ".nas", ".fem", ".blk", ".bulk"), NastranReader),
    **dict.fromkeys((".k", ".key", ".dyn", ".dyna"), DeckReader), ".stl": StlReader,
}  # fmt: skip
"""Reader by file name extension."""
CAD = (".step", ".stp", ".iges", ".igs", ".x_t", ".x_b", ".sldprt", ".catpart", ".prt", ".3dm", ".ipt", ".brep")
"""Extensions of CAD files, which have no mesh."""
LOOKED_AT = 20_000
"""Number of bytes at the start of a file from which its kind is detected."""


def read_mesh(path: str) -> Mesh:
    """Read the elements of a mesh file; errors name the line in a text file."""
    if not os.path.exists(path):
        raise FileError(path, None, "there is no such file")
    ending = Path(path).suffix.lower()
    if ending in CAD:
        message = "this is a CAD file without a mesh; mesh its middle surfaces with shells first, with Gmsh for example"
        raise FileError(path, None, message)
    return (_by_content(path) or READERS.get(ending, OtherReader))(path).read()


def _by_content(path: str) -> Reader | None:
    """Return the reader for a file whose content identifies its kind, whatever its name; otherwise None."""
    content = read_input(path)[:LOOKED_AT]
    if content.startswith(b"$MeshFormat") or b"\n$MeshFormat" in content:
        return GmshReader
    words = {line.split(b",")[0].strip().upper() for line in content.split(b"\n") if line.startswith(b"*")}
    if b"*KEYWORD" in words or any(word.startswith((b"*ELEMENT_SHELL", b"*PART_")) for word in words):
        return DeckReader
    if words & {b"*HEADING", b"*PART", b"*ELEMENT"} and Path(path).suffix.lower() != ".k":
        return AbaqusReader
    lines = content.upper().split(b"\n")
    if any(line.startswith((b"BEGIN BULK", b"GRID ", b"GRID*", b"GRID,", b"GRID\t")) for line in lines):
        return NastranReader
    return None
