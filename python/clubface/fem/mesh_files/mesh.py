"""What is taken from a mesh file, and what every reader fills it by: one rule for numbers, nodes and elements."""

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
"""Largest number of a node or an element; numbering is free, and only what is there takes memory."""
FARTHEST = 1e6
"""Largest coordinate, in whatever unit: a head in um has 1e5."""
CORNERS = {3: 3, 6: 3, 7: 3, 4: 4, 8: 4, 9: 4}
"""Corners of a shell, by its number of nodes; corners come first in every format, then nodes on edges and inside."""
SOLID_CORNERS = {4: 4, 10: 4, 5: 5, 13: 5, 14: 5, 6: 6, 15: 6, 18: 6, 8: 8, 20: 8, 27: 8}
"""Corners of a solid element, by its number of nodes."""
SOLIDS = {4: "tetrahedra", 5: "pyramids", 6: "wedges", 8: "hexahedra"}
"""Kinds of solid elements, by their number of corners."""


@dataclass(kw_only=True)
class Wall:
    """What cards of a file say of the elements of one set, in the units of the file; None where they say nothing.

    Attributes
    ----------
    thickness
        Of the wall.
    youngs, poisson, density
        Of its metal.
    source
        The cards, such as "PSHELL 1 and MAT1 7".
    material
        The material that they name, which may be one that is not read or not there, such as "MAT 7".
    """

    thickness: float | None = None
    youngs: float | None = None
    poisson: float | None = None
    density: float | None = None
    source: str = ""
    material: str = ""


@dataclass(kw_only=True)
class Elements:
    """Elements of a mesh file, of surfaces or solid ones.

    Attributes
    ----------
    corners
        Nodes of each element, as rows of the points, shape (m, 4) of surfaces or (m, 8) of solids; -1 fills up.
    ids
        Numbers of the elements in the file, shape (m,).
    sets
        Elements of each set, as rows of ``corners``, by name.
    """

    corners: NDArray[Any]
    ids: NDArray[Any]
    sets: dict[str, NDArray[Any]]


@dataclass(kw_only=True)
class Mesh:
    """The elements of a mesh file: surfaces and solids.

    Attributes
    ----------
    path
        The file.
    points
        Places of the nodes, in the unit of the file, shape (n, 3).
    node_ids
        Their numbers in the file, shape (n,).
    corners
        Nodes of each shell, as rows of ``points``, shape (m, 4); the last of a triangle is -1.
    ids
        Numbers of the elements in the file, shape (m,).
    thickness
        What the file says of the thickness of each element by itself, in its unit; NaN where it says nothing.
    sets
        Elements of each set, as rows of ``corners``, by name.
    aliases
        Other names of sets, such as the number of a physical group.
    walls
        What cards say of the elements of a set, by its name.
    masses
        Point masses: x, y, z and mass, in the units of the file.
    solids
        Its solid elements.
    notes
        What a reader did or left out, in sentences.
    """

    path: str
    points: NDArray[Any]
    node_ids: NDArray[Any]
    corners: NDArray[Any]
    ids: NDArray[Any]
    thickness: NDArray[Any]
    sets: dict[str, NDArray[Any]]
    aliases: dict[str, str]
    walls: dict[str, Wall]
    masses: list[tuple[float, float, float, float]]
    solids: Elements
    notes: list[str]

    def of_solids(self) -> Mesh:
        """Return the mesh with its solid elements in place of those of surfaces."""
        none = Elements(corners=np.zeros((0, 8), np.int64), ids=np.zeros(0, np.int64), sets={})
        solids = self.solids
        return replace(
            self, corners=solids.corners, ids=solids.ids, sets=solids.sets, solids=none,
            thickness=np.full(len(solids.ids), np.nan),
        )  # fmt: skip


@dataclass
class _Rows:
    """Elements as they are read: line, number and nodes of each; and the rows of each set and of each key."""

    elements: list[tuple[int | None, int, tuple[Hashable, ...]]] = field(default_factory=list)
    sets: dict[str, list[int]] = field(default_factory=dict)
    by_key: dict[Hashable, list[int]] = field(default_factory=dict)
    higher: int = 0

    def add(self, line: int | None, number: int, nodes: Sequence[Hashable], corners: int, sets: Iterable[str],
            key: Hashable) -> int:  # fmt: skip
        """Add an element whose corners are its first nodes; return its row."""
        row = len(self.elements)
        self.higher += len(nodes) > corners
        self.elements.append((line, number, tuple(nodes[:corners])))
        self.by_key.setdefault(number if key is None else key, []).append(row)
        for name in sets:
            self.sets.setdefault(name, []).append(row)
        return row


@dataclass
class MeshBuilder:
    """Collects nodes and elements of a file in any order, and checks each where it stands.

    Attributes
    ----------
    path
        The file.
    left_out
        How many elements of a kind that no head has were left out, such as bars.
    """

    path: str
    left_out: Counter[str] = field(default_factory=Counter)
    aliases: dict[str, str] = field(default_factory=dict)
    walls: dict[str, Wall] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    _rows: dict[Hashable, int] = field(default_factory=dict)
    _places: list[tuple[float, float, float]] = field(default_factory=list)
    _numbers: list[int] = field(default_factory=list)
    _shells: _Rows = field(default_factory=_Rows)
    _solids: _Rows = field(default_factory=_Rows)
    _thickness: dict[int, float] = field(default_factory=dict)
    _masses: list[tuple[int | None, Hashable, tuple[float, float, float], float]] = field(default_factory=list)

    def error(self, line: int | None, message: str) -> FileError:
        """Return the error of a line."""
        return FileError(self.path, line, message)

    def includes(self, line: int) -> FileError:
        """Return the error on a line that includes another file."""
        return self.error(line, "this file includes another one, which is not read; write the mesh as one file")

    def number(self, line: int | None, text: str, what: str = "a node") -> int:
        """Return a number of a node or an element."""
        text = text.strip()
        if not (text.isascii() and text.isdigit() and len(text) < 11 and int(text) <= LARGEST_NUMBER):
            message = f"{shortened(text, 40)!r} is no number of {what}, a whole number up to {LARGEST_NUMBER}"
            raise self.error(line, message)
        return int(text)

    def value(self, line: int | None, text: str, what: str) -> float:
        """Return a number of a card, as ``what`` is called."""
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value) or "_" in text:
            raise self.error(line, f"{shortened(text.strip(), 40)!r} is no {what}, a finite number")
        return value

    @property
    def nodes(self) -> int:
        """Number of nodes so far."""
        return len(self._places)

    def add_node(self, line: int | None, key: Hashable, number: int, place: Sequence[str | float]) -> None:
        """Add a node under a key, by which elements name it."""
        x, y, z = (self.coordinate(line, each) for each in place)
        if (row := self._rows.get(key)) is not None:
            if self._places[row] != (x, y, z):
                raise self.error(line, f"node {number} is there already, at another place")
            return
        self._rows[key] = len(self._places)
        self._places.append((x, y, z))
        self._numbers.append(number)

    def coordinate(self, line: int | None, given: str | float) -> float:
        """Return a coordinate of a node."""
        try:
            value = float(given)
        except ValueError:
            value = math.nan
        if not abs(value) <= FARTHEST or (isinstance(given, str) and "_" in given):
            shown = shortened(str(given).strip(), 40)
            message = f"{shown!r} is no coordinate of a head, a number within {FARTHEST:g}"
            raise self.error(line, message)
        return value

    def add_shell(
        self,
        line: int | None,
        number: int,
        nodes: Sequence[Hashable],
        sets: Iterable[str] = (),
        *,
        thickness: float = math.nan,
        key: Hashable = None,
    ) -> None:
        """Add a triangle or quadrilateral of 3, 4, 6, 7, 8 or 9 nodes; ``key`` names it for ``add_to_set``."""
        row = self._shells.add(line, number, nodes, CORNERS[len(nodes)], sets, key)
        if not math.isnan(thickness):
            self._thickness[row] = thickness

    def add_solid(
        self,
        line: int | None,
        number: int,
        nodes: Sequence[Hashable],
        sets: Iterable[str] = (),
        *,
        key: Hashable = None,
    ) -> None:
        """Add a solid element: a tetrahedron, pyramid, wedge or hexahedron, with nodes on its edges or without."""
        if len(nodes) not in SOLID_CORNERS:
            raise self.error(line, f"element {number} is a solid of {len(nodes)} nodes, which no kind of solid has")
        self._solids.add(line, number, nodes, SOLID_CORNERS[len(nodes)], sets, key)

    def add_to_set(self, name: str, keys: Iterable[Hashable]) -> None:
        """Add elements to a set by their keys; bars and the like are left out."""
        chosen = list(keys)
        for elements in (self._shells, self._solids):
            rows = elements.sets.setdefault(name, [])
            for key in chosen:
                rows += elements.by_key.get(key, ())

    def add_wall(
        self, name: str, section: str, thickness: float | None, metal: Wall | None, material: str = ""
    ) -> None:
        """Add what cards say of a set: that of its section, called ``section``, and that of its ``material``."""
        metal = metal or Wall()
        source = " and ".join(filter(None, (section, metal.source)))
        self.walls[name] = replace(metal, thickness=thickness, source=source, material=material)

    def note_offsets(self, count: int, noun: str) -> None:
        """Warn of walls that do not lie at the nodes, if there are any."""
        if count:
            text = f"{count} {noun} have an offset from the nodes, which is not used: nodes are on the middle surface"
            self.notes.append(text)

    def add_mass(
        self, line: int | None, node: Hashable, mass: float, offset: Sequence[float] = (0.0, 0.0, 0.0)
    ) -> None:
        """Add a point mass at a node, or at an offset from it."""
        x, y, z = offset
        self._masses.append((line, node, (x, y, z), mass))

    def mesh(self) -> Mesh:
        """Return the mesh.

        Raises
        ------
        FileError
            An element has a node that does not exist.
        """
        shells, solids = self._arrays(self._shells, 4), self._arrays(self._solids, 8)
        thickness = np.full(len(shells.ids), np.nan)
        for row, value in self._thickness.items():
            thickness[row] = value
        masses = []
        for line, key, offset, mass in self._masses:
            place = self._places[self._row(line, "a point mass", key)]
            masses.append((*(a + b for a, b in zip(place, offset, strict=True)), mass))
        notes = list(self.notes)
        if self._shells.higher:
            count = f"{self._shells.higher} element{'s' * (self._shells.higher != 1)}"
            notes.append(f"{count} with nodes on edges are taken by their corners")
        if self.left_out:
            parts = " and ".join(f"{count} {kind}" for kind, count in self.left_out.items())
            notes.append(f"left out, as a head has no such elements: {parts}")
        return Mesh(
            path=self.path,
            points=np.array(self._places, float).reshape(-1, 3),
            node_ids=np.array(self._numbers, np.int64),
            corners=shells.corners,
            ids=shells.ids,
            thickness=thickness,
            sets=shells.sets,
            aliases=self.aliases,
            walls=self.walls,
            masses=masses,
            solids=solids,
            notes=notes,
        )

    def _arrays(self, rows: _Rows, width: int) -> Elements:
        corners = np.full((len(rows.elements), width), -1, dtype=np.int64)
        for row, (line, number, nodes) in enumerate(rows.elements):
            for corner, key in enumerate(nodes):
                corners[row, corner] = self._row(line, f"element {number}", key)
        return Elements(
            corners=corners,
            ids=np.array([number for _, number, _ in rows.elements], np.int64),
            sets={name: np.unique(np.array(own, np.int64)) for name, own in rows.sets.items()},
        )

    def _row(self, line: int | None, what: str, key: Hashable) -> int:
        if key not in self._rows:
            number = key[-1] if isinstance(key, tuple) else key
            raise self.error(line, f"{what} has the node {number}, which does not exist")
        return self._rows[key]


def read_text(path: str) -> list[str]:
    """Return the lines of a text file of any encoding that has ASCII in it."""
    content = read_input(path)
    for encoding in ("utf-8-sig", "latin-1"):
        try:
            return content.decode(encoding).splitlines()
        except UnicodeDecodeError:
            continue
    raise FileError(path, None, "this is no text")
