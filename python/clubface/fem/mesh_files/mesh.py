"""Contents of a mesh file, and the builder that all readers share, with one set of checks for numbers and elements."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.errors import FileError, shortened
from clubface.support.files import read_input

LARGEST_NUMBER = 999_999_999
"""Largest number of a node or an element; numbers may have gaps, which take no memory."""
FARTHEST = 1e6
"""Largest coordinate, in any unit: a head measures 1e5 um."""
CORNERS = {3: 3, 6: 3, 7: 3, 4: 4, 8: 4, 9: 4}
"""Corners of a shell by its number of nodes; in every format corners come first, then nodes on edges and inside."""
SOLID_CORNERS = {4: 4, 10: 4, 5: 5, 13: 5, 14: 5, 6: 6, 15: 6, 18: 6, 8: 8, 20: 8, 27: 8}
"""Corners of a solid element by its number of nodes."""
SOLIDS = {4: "tetrahedra", 5: "pyramids", 6: "wedges", 8: "hexahedra"}
"""Kinds of solid elements by their number of corners."""


@dataclass(kw_only=True)
class Wall:
    """Data on cards about the elements of one set, in the units of the file; None if missing.

    ``source`` names the cards, such as "PSHELL 1 and MAT1 7", and ``material`` the material they refer to, such as
    "MAT 7", which may be missing or of an unsupported kind.
    """

    thickness: float | None = None
    youngs: float | None = None
    poisson: float | None = None
    density: float | None = None
    source: str = ""
    material: str = ""


@dataclass(kw_only=True)
class Mesh:
    """Elements of a mesh file: either its surface elements or its solids."""

    path: str  # the file
    points: NDArray[Any]  # positions of nodes in the unit of the file, shape (n, 3)
    node_ids: NDArray[Any]  # node numbers in the file, shape (n,)
    corners: NDArray[Any]  # nodes of elements, rows of ``points``, (m, 4) for surfaces or (m, 8) for solids; -1 pads
    ids: NDArray[Any]  # element numbers in the file, shape (m,)
    thickness: NDArray[Any]  # individual thickness of each element in the unit of the file; NaN if not given
    sets: dict[str, NDArray[Any]]  # elements of each set by name, as rows of ``corners``
    aliases: dict[str, str]  # other names of sets, such as physical group numbers
    walls: dict[str, Wall]  # data on cards, by name of the set
    masses: list[tuple[float, float, float, float]]  # point masses: x, y, z and mass, in the units of the file
    notes: list[str]  # sentences about changes and omissions
    solids: Mesh | None = None  # the solid elements of the file; None in the mesh of solids itself

    def error(self, message: str) -> FileError:
        """Return an error about the file."""
        return FileError(self.path, None, message)


@dataclass
class _Rows:
    """Elements as read: line, number and nodes of each; and the rows of each set and key."""

    elements: list[tuple[int | None, int, tuple[Hashable, ...]]] = field(default_factory=list)
    thickness: list[float] = field(default_factory=list)
    sets: dict[str, list[int]] = field(default_factory=dict)
    by_key: dict[Hashable, list[int]] = field(default_factory=dict)
    higher: int = 0

    def add(self, line: int | None, number: int, nodes: Sequence[Hashable], corners: int, sets: Iterable[str],
            key: Hashable, thickness: float = math.nan) -> None:  # fmt: skip
        """Add an element whose first nodes are its corners."""
        row = len(self.elements)
        self.higher += len(nodes) > corners
        self.elements.append((line, number, tuple(nodes[:corners])))
        self.thickness.append(thickness)
        self.by_key.setdefault(number if key is None else key, []).append(row)
        for name in sets:
            self.sets.setdefault(name, []).append(row)


class MeshBuilder:
    """Collects the nodes and elements of a file in any order, and checks each when added."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.aliases: dict[str, str] = {}  # as in :class:`Mesh`, like walls and notes
        self.walls: dict[str, Wall] = {}
        self.notes: list[str] = []
        self.left_out: Counter[str] = Counter()  # elements left out, by unsupported kind, such as bars
        self.offsets: Counter[str] = Counter()  # sections or elements with an offset from their nodes
        self._row_of: dict[Hashable, int] = {}
        self._places: list[tuple[float, float, float]] = []
        self._numbers: list[int] = []
        self._surface_rows, self._solid_rows = _Rows(), _Rows()
        self._point_masses: list[tuple[int | None, Hashable, Sequence[float], float]] = []

    def error(self, line: int | None, message: str) -> FileError:
        """Return an error about a line."""
        return FileError(self.path, line, message)

    def includes(self, line: int) -> FileError:
        """Return the error for a line that includes another file."""
        return self.error(line, "this file includes another one, which is not supported; write the mesh as one file")

    def number(self, line: int | None, text: str, what: str = "a node") -> int:
        """Parse the number of a node, element and so on."""
        text = text.strip()
        if not (text.isascii() and text.isdigit() and len(text) < 11 and int(text) <= LARGEST_NUMBER):
            raise self.error(
                line,
                f"{shortened(text, 40)!r} is not a valid number of {what}; write a whole number up to {LARGEST_NUMBER}",
            )
        return int(text)

    def value(self, line: int | None, text: str, what: str) -> float:
        """Parse a finite number on a card; ``what`` names it in errors."""
        value = _as_float(text)
        if not math.isfinite(value):
            raise self.error(line, f"{shortened(text.strip(), 40)!r} is not a valid {what}; write a finite number")
        return value

    def coordinate(self, line: int | None, given: str | float) -> float:
        """Parse a coordinate of a node."""
        value = _as_float(given)
        if not abs(value) <= FARTHEST:
            shown = shortened(str(given).strip(), 40)
            raise self.error(line, f"{shown!r} is not a valid coordinate of a head; write a number within {FARTHEST:g}")
        return value

    @property
    def nodes(self) -> int:
        """Number of nodes so far."""
        return len(self._places)

    def add_node(self, line: int | None, key: Hashable, number: int, place: Sequence[str | float]) -> None:
        """Add a node under the key by which elements refer to it."""
        x, y, z = (self.coordinate(line, each) for each in place)
        if (row := self._row_of.get(key)) is not None:
            if self._places[row] != (x, y, z):
                raise self.error(line, f"node {number} is already defined, at another place")
            return
        self._row_of[key] = len(self._places)
        self._places.append((x, y, z))
        self._numbers.append(number)

    def add_shell(self, line: int | None, number: int, nodes: Sequence[Hashable], sets: Iterable[str] = (), *,
                  thickness: float = math.nan, key: Hashable = None) -> None:  # fmt: skip
        """Add a triangle or quadrilateral of 3, 4, 6, 7, 8 or 9 nodes; ``add_to_set`` refers to it by ``key``."""
        self._surface_rows.add(line, number, nodes, CORNERS[len(nodes)], sets, key, thickness)

    def add_solid(self, line: int | None, number: int, nodes: Sequence[Hashable], sets: Iterable[str] = (), *,
                  key: Hashable = None) -> None:  # fmt: skip
        """Add a tetrahedron, pyramid, wedge or hexahedron, with or without mid-edge nodes."""
        if len(nodes) not in SOLID_CORNERS:
            raise self.error(line, f"element {number} is a solid with {len(nodes)} nodes, which no supported kind has")
        self._solid_rows.add(line, number, nodes, SOLID_CORNERS[len(nodes)], sets, key)

    def add_to_set(self, name: str, keys: Iterable[Hashable]) -> None:
        """Add elements to a set by their keys; keys of elements left out are ignored."""
        chosen = list(keys)
        for elements in (self._surface_rows, self._solid_rows):
            elements.sets.setdefault(name, []).extend(row for key in chosen for row in elements.by_key.get(key, ()))

    def add_wall(
        self, name: str, section: str, thickness: float | None, metal: Wall | None, material: str = ""
    ) -> None:
        """Add the data of cards about a set: its section's, named ``section``, and its ``material``'s."""
        metal = metal or Wall()
        source = " and ".join(filter(None, (section, metal.source)))
        self.walls[name] = replace(metal, thickness=thickness, source=source, material=material)

    def add_mass(self, line: int | None, node: Hashable, mass: float, offset: Sequence[float] = (0, 0, 0)) -> None:
        """Add a point mass at a node, or at an offset from it."""
        self._point_masses.append((line, node, offset, mass))

    def mesh(self) -> Mesh:
        """Return the mesh of everything added; raise FileError if an element has a node that does not exist."""
        surfaces, solids = self._arrays(self._surface_rows, 4), self._arrays(self._solid_rows, 8)
        masses = []
        for line, key, offset, mass in self._point_masses:
            place = self._places[self._row(line, "a point mass", key)]
            masses.append((*(a + b for a, b in zip(place, offset, strict=True)), mass))
        notes = [*self.notes, *(
            f"{count} {noun} have an offset from the nodes, which is ignored: nodes must be on the middle surface"
            for noun, count in self.offsets.items()
        )]  # fmt: skip
        if higher := self._surface_rows.higher:
            notes.append(f"{higher} element{'s' * (higher != 1)} with mid-edge nodes are reduced to their corners")
        if self.left_out:
            parts = " and ".join(f"{count} {kind}" for kind, count in self.left_out.items())
            notes.append(f"left out, because a head has no such elements: {parts}")
        shared: dict[str, Any] = {
            "path": self.path, "points": np.array(self._places, float).reshape(-1, 3),
            "node_ids": np.array(self._numbers, np.int64), "aliases": self.aliases, "walls": self.walls,
            "masses": masses, "notes": notes,
        }  # fmt: skip
        return Mesh(**shared, **surfaces, solids=Mesh(**shared, **solids))

    def _arrays(self, rows: _Rows, width: int) -> dict[str, Any]:
        corners = np.full((len(rows.elements), width), -1, dtype=np.int64)
        for row, (line, number, nodes) in enumerate(rows.elements):
            for corner, key in enumerate(nodes):
                corners[row, corner] = self._row(line, f"element {number}", key)
        return {
            "corners": corners,
            "ids": np.array([number for _, number, _ in rows.elements], np.int64),
            "thickness": np.array(rows.thickness, float),
            "sets": {name: np.unique(np.array(own, np.int64)) for name, own in rows.sets.items()},
        }

    def _row(self, line: int | None, what: str, key: Hashable) -> int:
        if key not in self._row_of:
            number = key[-1] if isinstance(key, tuple) else key
            raise self.error(line, f"{what} refers to node {number}, which does not exist")
        return self._row_of[key]


def _as_float(given: str | float) -> float:
    """Parse a number, without allowing Python's underscores; NaN if it is not a number."""
    try:
        return math.nan if isinstance(given, str) and "_" in given else float(given)
    except ValueError:
        return math.nan


def read_text(path: str) -> list[str]:
    """Return the lines of a text file in any encoding compatible with ASCII."""
    content = read_input(path)
    try:
        return content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        return content.decode("latin-1").splitlines()
