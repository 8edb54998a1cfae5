"""The lines of a mesh as text, looked at before a library reads them, so that a damaged one is named.

A library would take a coordinate that slipped into the place of a node's number for a number, and make room for as many
nodes. Looked at are the nodes of Gmsh (versions 2 and 4, as text) and Abaqus, and the elements of version 2 and Abaqus;
other formats are left to the library.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

from clubface.errors import FileError, shortened
from clubface.support.input_files import read_input

LARGEST_NUMBER = 10_000_000
"""Of a node; a head has thousands."""
FARTHEST = 1e6
"""Largest coordinate, in whatever unit: a head in um has 1e5."""


def check_lines(path: str) -> None:
    """Refuse a text mesh of Gmsh or Abaqus with a damaged node, or an element of nodes that do not exist."""
    ending = Path(path).suffix.lower()
    if ending not in (".msh", ".inp"):
        return
    content = read_input(path)
    if b"\0" in content[:4096] and ending == ".msh":
        return  # binary
    lines = content.decode("latin-1").splitlines()
    nodes = _Nodes(path)
    sections = _of_gmsh(lines) if ending == ".msh" else _of_abaqus(lines)
    for number, section, cells in sections:
        if section == "count":
            nodes.check_count(number, *cells)
        elif section == "node":
            nodes.add(number, cells, exactly=ending == ".msh")
        elif section == "element":
            nodes.check(number, cells)
        else:
            nodes.check_places(number, cells)


class _Nodes:
    """The numbers of the nodes of one file."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._numbers: set[int] = set()

    def check_count(self, line: int, told: str, found: str) -> None:
        """Refuse a section that has more or fewer lines than it says."""
        if told != found:
            message = f"this section says that it has {shortened(told, 40)} lines, and has {found}"
            raise FileError(self._path, line, message)

    def add(self, line: int, cells: list[str], *, exactly: bool) -> None:
        """Take a node: its number and three coordinates, which in Abaqus a direction may follow."""
        if len(cells) < 4 or (exactly and len(cells) > 4):
            message = f"this line of a node has {len(cells)} cells, not a number and three coordinates"
            raise FileError(self._path, line, message)
        self._numbers.add(self._whole(line, cells[0]))
        self.check_places(line, cells[1:4])

    def check_places(self, line: int, cells: list[str]) -> None:
        """Refuse what is no coordinate."""
        for cell in cells:
            try:
                value = float(cell)
            except ValueError:
                value = math.nan
            if not abs(value) <= FARTHEST or "_" in cell:
                message = f"{shortened(cell, 40)!r} is no coordinate of a head, a number within {FARTHEST:g}"
                raise FileError(self._path, line, message)

    def check(self, line: int, cells: list[str]) -> None:
        """Refuse an element with a node that does not exist."""
        for cell in cells:
            if self._whole(line, cell) not in self._numbers:
                raise FileError(self._path, line, f"this element has the node {cell}, which does not exist")

    def _whole(self, line: int, cell: str) -> int:
        if not (cell.isascii() and cell.isdigit() and len(cell) < 10 and int(cell) <= LARGEST_NUMBER):
            message = f"{shortened(cell, 40)!r} is no number of a node, a whole number up to {LARGEST_NUMBER}"
            raise FileError(self._path, line, message)
        return int(cell)


def _of_gmsh(lines: list[str]) -> Iterator[tuple[int, str, list[str]]]:
    """Yield line, kind of content and cells: whole nodes and the nodes of elements, or of version 4 coordinates."""
    section, first, version = "", 0, ""
    for number, text in enumerate(lines, 1):
        cells = text.split()
        if text.startswith("$"):
            if version == "2" and section in ("$Nodes", "$Elements"):
                yield first + 1, "count", [lines[first].strip(), str(max(0, number - first - 2))]
            section, first = text.strip(), number
        elif section == "$MeshFormat" and number == first + 1 and cells:
            version = cells[0][:1]
        elif section == "$Nodes" and number > first + 1 and version == "2":
            yield number, "node", cells
        elif section == "$Nodes" and version == "4":
            yield number, "coordinates", cells
        elif section == "$Elements" and number > first + 1 and version == "2":
            tags = int(cells[2]) if len(cells) > 2 and cells[2].isdecimal() and len(cells[2]) < 3 else 0
            yield number, "element", cells[3 + tags :]


def _of_abaqus(lines: list[str]) -> Iterator[tuple[int, str, list[str]]]:
    """Yield line, kind of content and cells of nodes and elements."""
    section, goes_on = "", False
    for number, text in enumerate(lines, 1):
        if text.startswith("*"):
            section = "" if text.startswith("**") else text[1:].partition(",")[0].strip().upper()
            goes_on = False
            continue
        cells = [cell.strip() for cell in text.strip().rstrip(",").split(",")]
        if section == "NODE" and text.strip():
            yield number, "node", cells
        elif section == "ELEMENT" and text.strip():
            yield number, "element", cells if goes_on else cells[1:]
            goes_on = text.rstrip().endswith(",")
