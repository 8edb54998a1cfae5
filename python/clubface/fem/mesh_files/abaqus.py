"""Reader of Abaqus meshes (.inp), flat or with parts and instances: element sets, shell sections and materials."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.errors import shortened
from clubface.fem.mesh_files.mesh import Mesh, MeshBuilder, Wall, read_text

SHELL = re.compile(r"(?:S|STRI|DS|CPS|CPE|CPEG|CAX|M3D|R3D|SFM3D|F3D|DC2D)(?P<nodes>3|4|6|8|9)(?!\d)|STRI65")
"""Types of surface elements; some generators write them as plane elements (CPS4)."""
SOLID = re.compile(r"(?:C3D|DC3D|AC3D|SC|CSS)(\d+)")
LINE = re.compile(r"T2D|T3D|B2|B3|FRAME|PIPE|CONN|SPRING|DASHPOT|MASS|ROTARY|GAP|ELBOW|RB[23]|SAX")
GENERATORS = ("NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM")
"""Keywords that generate or move nodes and elements."""
LARGEST_RANGE = 10_000_000
"""Maximum number of elements in the range of a GENERATE line."""


class _Keyword(NamedTuple):
    """A keyword with its options (keys in capitals) and its data lines."""

    line: int
    name: str
    options: dict[str, str]
    rows: list[tuple[int, list[str]]]


@dataclass
class _Part:
    """Contents of a part, or of the file outside parts."""

    name: str = ""
    nodes: list[tuple[int, int, list[str]]] = field(default_factory=list)
    elements: list[tuple[bool, int, int, list[int]]] = field(default_factory=list)  # is solid, line, number, nodes
    sets: dict[str, list[int | str]] = field(default_factory=dict)
    sections: list[tuple[str, str, float | None, str]] = field(default_factory=list)
    points: list[tuple[int, int, str]] = field(default_factory=list)
    masses: dict[str, float] = field(default_factory=dict)


class AbaqusReader(MeshBuilder):
    """Reads a mesh of Abaqus; sets are its element sets, and its parts by name."""

    def __init__(self, path: str) -> None:
        super().__init__(path)
        self.parts: dict[str, _Part] = {"": _Part()}
        self.instances: list[tuple[str, str, list[tuple[int, list[str]]]]] = []
        self.part = self.parts[""]
        self.assembly_sets: list[tuple[str, str, list[int | str]]] = []
        self.materials: dict[str, Wall] = {}
        self.labels: dict[str, str] = {}

    def read(self) -> Mesh:
        """Read the file and return the mesh."""
        material, in_assembly = Wall(), False
        for keyword in self._keywords():
            name, options = keyword.name, keyword.options
            if name == "INCLUDE" or "INPUT" in options:
                raise self.includes(keyword.line)
            if name in GENERATORS:
                raise self.error(keyword.line, f"*{name} is not supported; write every node and element explicitly")
            if name == "PART":
                part = options.get("NAME", "")
                self.part = self.parts.setdefault(part.upper(), _Part(part))
            elif name in ("END PART", "ASSEMBLY", "END ASSEMBLY"):
                self.part, in_assembly = self.parts[""], name == "ASSEMBLY"
            elif name == "INSTANCE":
                part = options.get("PART", "").upper()
                self.instances.append((options.get("NAME", ""), part, keyword.rows))
                self.part = self.parts.setdefault(part, _Part())
            elif name == "END INSTANCE":
                self.part = self.parts[""]
            elif name == "NODE":
                self._nodes(keyword)
            elif name == "ELEMENT":
                self._elements(keyword)
            elif name == "ELSET":
                self._set(keyword, in_assembly)
            elif name in ("SHELL SECTION", "MEMBRANE SECTION", "SHELL GENERAL SECTION", "SOLID SECTION"):
                self._section(keyword)
            elif name == "MASS" and keyword.rows:
                line, cells = keyword.rows[0]
                self.part.masses[self._label(options.get("ELSET", ""))] = self.value(line, cells[0], "mass")
            elif name == "NONSTRUCTURAL MASS":
                self.left_out["cards of masses spread over walls (*NONSTRUCTURAL MASS)"] += 1
            elif name == "MATERIAL":
                material = self.materials.setdefault(options.get("NAME", "").upper(), Wall())
                material.source = f"*MATERIAL {options.get('NAME', '')}"
            elif name == "ELASTIC" and keyword.rows and options.get("TYPE", "ISOTROPIC").upper() == "ISOTROPIC":
                line, cells = keyword.rows[0]
                material.youngs = self.value(line, cells[0], "Young's modulus")
                if len(cells) > 1 and cells[1]:
                    material.poisson = self.value(line, cells[1], "Poisson's ratio")
            elif name == "DENSITY" and keyword.rows:
                line, cells = keyword.rows[0]
                material.density = self.value(line, cells[0], "density")
        self._place_parts()
        return self.mesh()

    def _label(self, name: str) -> str:
        """Return the name of a set as first written; names ignore case."""
        return self.labels.setdefault(name.upper(), name)

    def _keywords(self) -> Iterator[_Keyword]:
        keyword: _Keyword | None = None
        pending = ""
        for number, text in enumerate(read_text(self.path), 1):
            text = text.strip()
            if text.startswith("**") or not text:
                continue
            if text.startswith("*") or pending:
                pending += text
                if pending.endswith(","):  # options continue on the next line
                    continue
                if keyword is not None:
                    yield keyword
                name, *options = (each.strip() for each in pending[1:].split(","))
                pairs = (each.partition("=") for each in options)
                given = {key.strip().upper(): value.strip().strip('"') for key, _, value in pairs}
                keyword, pending = _Keyword(number, re.sub(r"\s+", " ", name).upper(), given, []), ""
            elif keyword is not None:
                cells = [cell.strip() for cell in text.rstrip(",").split(",")]
                keyword.rows.append((number, cells if not text.endswith(",") else [*cells, ""]))
        if keyword is not None:
            yield keyword

    def _nodes(self, keyword: _Keyword) -> None:
        if keyword.options.get("SYSTEM", "R").upper() != "R":
            raise self.error(keyword.line, "nodes must be in Cartesian coordinates (SYSTEM=R)")
        for line, cells in keyword.rows:
            if len(cells) < 4:
                raise self.error(line, f"this node has {len(cells)} cells; a number and three coordinates are needed")
            number = self.number(line, cells[0])
            self.part.nodes.append((line, number, cells[1:4]))

    def _elements(self, keyword: _Keyword) -> None:
        kind, name = keyword.options.get("TYPE", "").upper(), self._label(keyword.options.get("ELSET", ""))
        shell, solid = SHELL.match(kind), SOLID.match(kind)
        count = int(shell["nodes"] or 6) if shell else int(solid[1]) if solid else 0
        if not shell and not solid and not LINE.match(kind):
            message = f"elements of the type {shortened(kind, 40) or '(none)'} are not supported; write S3, S4 or S4R"
            raise self.error(keyword.line, message)
        row: list[str] = []
        for line, cells in keyword.rows:
            row += [cell for cell in cells if cell]
            if cells[-1] == "" and len(row) < count + 1:
                continue  # the nodes continue on the next line
            if shell or solid:
                numbers = [self.number(line, cell) for cell in row]
                if len(numbers) != count + 1:
                    raise self.error(line, f"this element of type {kind} has {len(numbers) - 1} nodes, not {count}")
                self.part.elements.append((bool(solid), line, numbers[0], numbers[1:]))
                if name:
                    self.part.sets.setdefault(name, []).append(numbers[0])
            elif kind == "MASS" and len(row) > 1 and row[1].isdecimal():
                self.part.points.append((line, self.number(line, row[1]), name))
            elif cells[-1] != "":
                self.left_out[f"of type {kind}"] += 1
            row = [] if shell or solid or cells[-1] != "" else row

    def _set(self, keyword: _Keyword, in_assembly: bool) -> None:
        name, instance = self._label(keyword.options.get("ELSET", "")), keyword.options.get("INSTANCE", "")
        members: list[int | str] = []
        for line, cells in keyword.rows:
            if "GENERATE" in keyword.options:
                first, last, *step = (self.number(line, cell, "an element") for cell in cells if cell)
                by = step[0] if step else 1
                if by < 1 or (last - first) // by > LARGEST_RANGE:
                    raise self.error(line, "this range of elements has no sensible step")
                members += range(first, last + 1, by)
            else:
                members += [int(cell) if cell.isdecimal() and len(cell) < 11 else cell for cell in cells if cell]
        if in_assembly and instance:
            self.assembly_sets.append((name, instance, members))
        else:
            self.part.sets.setdefault(name, []).extend(members)

    def _section(self, keyword: _Keyword) -> None:
        thickness = None
        walled = keyword.name not in ("SHELL GENERAL SECTION", "SOLID SECTION")
        if keyword.rows and walled and "COMPOSITE" not in keyword.options:
            line, cells = keyword.rows[0]
            if cells[0]:
                thickness = self.value(line, cells[0], "thickness")
        material = keyword.options.get("MATERIAL", "").upper()
        if keyword.options.get("OFFSET", "0").upper().strip("0.+- ") not in ("", "MID", "SMID", "MIDDLE"):
            self.offsets["sections"] += 1
        name = self._label(keyword.options.get("ELSET", ""))
        self.part.sections.append((name, material, thickness, f"*{keyword.name}"))

    def _place_parts(self) -> None:
        """Add the parts where their instances are, or all parts as they are if there are no instances."""
        placed = self.instances or [("", name, []) for name in self.parts if name]
        self._add("", self.parts[""], lambda place: place)
        for number, (name, part, rows) in enumerate(placed):
            moved = self._motion(rows) if rows else (lambda place: place)
            self._add(f"{number}:{name}", self.parts.get(part, _Part()), moved, name)
        for name, instance, members in self.assembly_sets:
            keys = [f"{number}:{each}" for number, (each, *_) in enumerate(placed) if each.upper() == instance.upper()]
            self.add_to_set(name, [(key, member) for key in keys for member in members])

    def _add(self, key: str, part: _Part, moved: Callable[[Sequence[float]], Sequence[float]], name: str = "") -> None:
        """Add a part as an instance with this name.

        Sets with the same name in several parts are separate; they also have the name of the instance, as in
        "face-1.Set-1".
        """
        others = [other for other in self.parts.values() if other is not part and (other.nodes or other.elements)]
        elsewhere = {each for other in others for each in other.sets}

        def known_as(of_set: str) -> str:
            return f"{name or part.name}.{of_set}" if of_set in elsewhere else of_set

        for line, number, cells in part.nodes:
            place = [self.coordinate(line, cell) for cell in cells]
            self.add_node(line, (key, number), number, moved(place))
        sets = [each for each in dict.fromkeys((name, part.name)) if each]
        for solid, line, number, nodes in part.elements:
            add = self.add_solid if solid else self.add_shell
            add(line, number, [(key, node) for node in nodes], sets, key=(key, number))
        names = {each.upper(): each for each in part.sets}
        for each in part.sets:
            numbers = _members(each, part, names, frozenset())
            self.add_to_set(known_as(each), ((key, number) for number in numbers))
        for of_set, metal, thickness, what in part.sections:
            known = known_as(of_set)
            material = f"*MATERIAL {metal}" if metal else ""
            self.add_wall(known, f"{what} {known}", thickness, self.materials.get(metal), material)
        for line, node, of_set in part.points:
            if of_set not in part.masses:
                raise self.error(line, f"no *MASS gives the mass of the elements of {of_set or 'no set'}")
            self.add_mass(line, (key, node), part.masses[of_set])

    def _motion(self, rows: list[tuple[int, list[str]]]) -> Callable[[Sequence[float]], Sequence[float]]:
        """Return an instance's motion: a translation, then a rotation about the line between two points."""
        numbers = [[self.value(line, cell or "0", "number") for cell in cells] for line, cells in rows[:2]]
        shift = np.array([*numbers[0], 0.0, 0.0, 0.0][:3])
        if len(numbers) == 1:
            return lambda place: (place + shift).tolist()
        if len(numbers[1]) != 7:
            raise self.error(rows[1][0], "the rotation of an instance needs two points and an angle")
        start, end, (angle,) = np.split(np.array(numbers[1]), [3, 6])
        return lambda place: _rotate(place + shift, start, end, math.radians(angle))


def _members(name: str, part: _Part, names: dict[str, str], seen: frozenset[str]) -> list[int]:
    """Return the element numbers of a set, including those of the sets it names."""
    numbers: list[int] = []
    for member in part.sets[name]:
        if isinstance(member, int):
            numbers.append(member)
        elif (other := names.get(member.upper())) is not None and other not in seen and other != name:
            numbers += _members(other, part, names, seen | {name})
    return numbers


def _rotate(place: NDArray[Any], start: NDArray[Any], end: NDArray[Any], angle: float) -> list[float]:
    """Rotate a point about the line from one point to another by an angle [rad] (Rodrigues)."""
    if (length := math.dist(start, end)) == 0.0:
        return place.tolist()
    axis, arm = (end - start) / length, place - start
    along = (axis @ arm) * axis
    return (start + along + (arm - along) * math.cos(angle) + np.cross(axis, arm) * math.sin(angle)).tolist()
