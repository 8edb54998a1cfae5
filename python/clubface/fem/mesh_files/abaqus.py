"""Meshes of Abaqus (.inp): flat, or as parts with instances; element sets, shell sections and materials."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from clubface.errors import shortened
from clubface.fem.mesh_files.mesh import UNNAMED, Mesh, MeshBuilder, Wall, read_text

SHELL = re.compile(r"(?:S|STRI|DS|CPS|CPE|CPEG|CAX|M3D|R3D|SFM3D|F3D|DC2D)(?P<nodes>3|4|6|8|9)(?!\d)|STRI65")
"""Names of surface elements; generators that know no structure write plane ones (CPS4) for them."""
SOLID = re.compile(r"(?:C3D|DC3D|AC3D|SC|CSS)(\d+)")
SOLID_KINDS = {4: "tetrahedra", 10: "tetrahedra", 5: "pyramids", 6: "wedges", 15: "wedges", 8: "hexahedra",
               20: "hexahedra", 27: "hexahedra"}  # fmt: skip
LINE = re.compile(r"T2D|T3D|B2|B3|FRAME|PIPE|CONN|SPRING|DASHPOT|MASS|ROTARY|GAP|ELBOW|RB[23]|SAX")
LARGEST_RANGE = 10_000_000
"""Elements that a GENERATE line may span."""


class _Keyword(NamedTuple):
    """A keyword with its options in capitals, and its lines of data."""

    line: int
    name: str
    options: dict[str, str]
    rows: list[tuple[int, list[str]]]


@dataclass
class _Part:
    """What stands in a part, or outside of all parts."""

    nodes: list[tuple[int, int, list[str]]] = field(default_factory=list)
    elements: list[tuple[int, int, tuple[int, ...]]] = field(default_factory=list)
    sets: dict[str, list[int | str]] = field(default_factory=dict)


def read(path: str) -> Mesh:
    """Read a mesh of Abaqus; sets are its element sets, and parts under their names."""
    return _File(path).read()


class _File:
    def __init__(self, path: str) -> None:
        self.builder = MeshBuilder(path)
        self.parts: dict[str, _Part] = {"": _Part()}
        self.instances: list[tuple[str, str, list[tuple[int, list[str]]]]] = []
        self.part = self.parts[""]
        self.assembly_sets: list[tuple[str, str, list[int | str]]] = []
        self.materials: dict[str, Wall] = {}
        self.sections: list[tuple[str, str, float | None, str]] = []

    def read(self) -> Mesh:
        material = Wall()
        in_assembly = False
        instance = ""
        for keyword in self._keywords():
            name, options = keyword.name, keyword.options
            if name == "INCLUDE":
                raise self.builder.includes(keyword.line)
            if name == "PART":
                self.part = self.parts.setdefault(options.get("NAME", "").upper(), _Part())
            elif name in ("END PART", "ASSEMBLY", "END ASSEMBLY"):
                self.part, in_assembly = self.parts[""], name == "ASSEMBLY"
            elif name == "INSTANCE":
                instance = options.get("NAME", "")
                self.instances.append((instance, options.get("PART", "").upper(), keyword.rows))
                self.part = self.parts.setdefault(options.get("PART", "").upper(), _Part())
            elif name == "END INSTANCE":
                self.part = self.parts[""]
            elif name == "NODE":
                self._nodes(keyword)
            elif name == "ELEMENT":
                self._elements(keyword)
            elif name == "ELSET":
                self._set(keyword, in_assembly)
            elif name in ("SHELL SECTION", "MEMBRANE SECTION", "SHELL GENERAL SECTION"):
                self._section(keyword)
            elif name == "MATERIAL":
                material = self.materials.setdefault(options.get("NAME", "").upper(), Wall())
                material.source = f"*MATERIAL {options.get('NAME', '')}"
            elif name == "ELASTIC" and keyword.rows and options.get("TYPE", "ISOTROPIC").upper() == "ISOTROPIC":
                line, cells = keyword.rows[0]
                material.youngs = self.builder.value(line, cells[0], "Young's modulus")
                if len(cells) > 1 and cells[1]:
                    material.poisson = self.builder.value(line, cells[1], "Poisson's ratio")
            elif name == "DENSITY" and keyword.rows:
                line, cells = keyword.rows[0]
                material.density = self.builder.value(line, cells[0], "density")
        self._place_parts()
        for name, metal, thickness, what in self.sections:
            self.builder.add_wall(name, f"{what} {name}", thickness, self.materials.get(metal))
        return self.builder.mesh()

    def _keywords(self) -> Iterator[_Keyword]:
        keyword: _Keyword | None = None
        pending = ""
        for number, text in enumerate(read_text(self.builder.path), 1):
            text = text.strip()
            if text.startswith("**") or not text:
                continue
            if text.startswith("*") or pending:
                pending += text
                if pending.endswith(","):  # options go on in the next line
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
            raise self.builder.error(keyword.line, "nodes are read in Cartesian coordinates alone (SYSTEM=R)")
        for line, cells in keyword.rows:
            if len(cells) < 4:
                raise self.builder.error(line, f"this node has {len(cells)} cells, not a number and three coordinates")
            number = self.builder.number(line, cells[0])
            self.part.nodes.append((line, number, cells[1:4]))

    def _elements(self, keyword: _Keyword) -> None:
        kind, name = keyword.options.get("TYPE", "").upper(), keyword.options.get("ELSET", "")
        shell = SHELL.match(kind)
        count = int(shell["nodes"] or 6) if shell else 0
        if not shell and not SOLID.match(kind) and not LINE.match(kind):
            message = f"elements of the type {shortened(kind, 40) or '(none)'} are not read; write S3, S4 or S4R"
            raise self.builder.error(keyword.line, message)
        row: list[str] = []
        for line, cells in keyword.rows:
            row += [cell for cell in cells if cell]
            if cells[-1] == "" and len(row) < count + 1:
                continue  # the nodes go on in the next line
            if shell:
                numbers = [self.builder.number(line, cell) for cell in row]
                if len(numbers) != count + 1:
                    message = f"this element of type {kind} has {len(numbers) - 1} nodes, not {count}"
                    raise self.builder.error(line, message)
                self.part.elements.append((line, numbers[0], tuple(numbers[1:])))
                if name:
                    self.part.sets.setdefault(name, []).append(numbers[0])
            elif cells[-1] != "":
                self._other(kind, name)
            row = [] if shell or cells[-1] != "" else row

    def _other(self, kind: str, name: str) -> None:
        solid = SOLID.match(kind)
        if solid:
            self.builder.add_solid(SOLID_KINDS.get(int(solid[1]), "solids"), name or UNNAMED)
        else:
            self.builder.left_out[f"of type {kind}"] += 1

    def _set(self, keyword: _Keyword, in_assembly: bool) -> None:
        name, instance = keyword.options.get("ELSET", ""), keyword.options.get("INSTANCE", "")
        members: list[int | str] = []
        for line, cells in keyword.rows:
            if "GENERATE" in keyword.options:
                first, last, *step = (self.builder.number(line, cell, "an element") for cell in cells if cell)
                by = step[0] if step else 1
                if by < 1 or (last - first) // by > LARGEST_RANGE:
                    raise self.builder.error(line, "this range of elements has no sensible step")
                members += range(first, last + 1, by)
            else:
                members += [int(cell) if cell.isdecimal() and len(cell) < 11 else cell for cell in cells if cell]
        if in_assembly and instance:
            self.assembly_sets.append((name, instance, members))
        else:
            self.part.sets.setdefault(name, []).extend(members)

    def _section(self, keyword: _Keyword) -> None:
        thickness = None
        if keyword.rows and keyword.name != "SHELL GENERAL SECTION" and "COMPOSITE" not in keyword.options:
            line, cells = keyword.rows[0]
            if cells[0]:
                thickness = self.builder.value(line, cells[0], "thickness")
        material = keyword.options.get("MATERIAL", "").upper()
        self.sections.append((keyword.options.get("ELSET", ""), material, thickness, f"*{keyword.name}"))

    def _place_parts(self) -> None:
        """Add the parts where their instances stand, or all of them where there are no instances."""
        placed = self.instances or [("", name, []) for name in self.parts if name]
        self._add("", self.parts[""], lambda place: place)
        for number, (name, part, rows) in enumerate(placed):
            moved = self._motion(rows) if rows else (lambda place: place)
            self._add(f"{number}:{name}", self.parts.get(part, _Part()), moved, part if not self.instances else name)
        for name, instance, members in self.assembly_sets:
            keys = [f"{number}:{each}" for number, (each, *_) in enumerate(placed) if each.upper() == instance.upper()]
            self.builder.add_to_set(name, [(key, member) for key in keys for member in members])

    def _add(self, key: str, part: _Part, moved: Callable[[Sequence[float]], Sequence[float]], name: str = "") -> None:
        for line, number, cells in part.nodes:
            place = [self.builder.coordinate(line, cell) for cell in cells]
            self.builder.add_node(line, (key, number), number, moved(place))
        for line, number, nodes in part.elements:
            corners = [(key, node) for node in nodes]
            self.builder.add_shell(line, number, corners, [name] if name else (), key=(key, number))
        names = {each.upper(): each for each in part.sets}
        for each in part.sets:
            numbers = _members(each, part, names, frozenset())
            self.builder.add_to_set(each, ((key, number) for number in numbers))

    def _motion(self, rows: list[tuple[int, list[str]]]) -> Callable[[Sequence[float]], Sequence[float]]:
        """Return how an instance moves its part: a translation, then a turn about the line from a point to another."""
        numbers = [[self.builder.value(line, cell or "0", "number") for cell in cells] for line, cells in rows[:2]]
        shift = [*numbers[0], 0.0, 0.0, 0.0][:3]
        turn = numbers[1] if len(numbers) > 1 else []
        if turn and len(turn) != 7:
            raise self.builder.error(rows[1][0], "a turn of an instance is two points and an angle")

        def moved(place: Sequence[float]) -> Sequence[float]:
            place = [a + b for a, b in zip(place, shift, strict=True)]
            return place if not turn else _turned(place, turn[:3], turn[3:6], math.radians(turn[6]))

        return moved


def _members(name: str, part: _Part, names: dict[str, str], seen: frozenset[str]) -> list[int]:
    """Return the numbers of a set, with those of sets that it names."""
    found: list[int] = []
    for member in part.sets[name]:
        if isinstance(member, int):
            found.append(member)
        elif (other := names.get(member.upper())) is not None and other not in seen and other != name:
            found += _members(other, part, names, seen | {name})
    return found


def _turned(place: Sequence[float], start: Sequence[float], end: Sequence[float], angle: float) -> list[float]:
    """Turn a place about the line from one point to another (Rodrigues)."""
    length = math.dist(start, end)
    if length == 0.0:
        return list(place)
    axis = [(b - a) / length for a, b in zip(start, end, strict=True)]
    arm = [p - a for p, a in zip(place, start, strict=True)]
    across = [axis[i - 2] * arm[i - 1] - axis[i - 1] * arm[i - 2] for i in range(3)]
    along = sum(a * b for a, b in zip(axis, arm, strict=True))
    cosine, sine = math.cos(angle), math.sin(angle)
    return [start[i] + arm[i] * cosine + across[i] * sine + axis[i] * along * (1.0 - cosine) for i in range(3)]
