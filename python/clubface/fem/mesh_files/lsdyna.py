"""Reader of LS-DYNA keyword decks (.k, .key, .dyn), including those written by clubface; sets are the parts."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from clubface.errors import shortened
from clubface.fem.mesh_files.mesh import Mesh, MeshBuilder, Wall, read_text

METALS = ("ELASTIC", "001", "PLASTIC_KINEMATIC", "003", "RIGID", "020", "PIECEWISE_LINEAR_PLASTICITY", "024")
"""Materials whose first card holds number, density, Young's modulus and Poisson's ratio."""


class _Row(NamedTuple):
    """A line of a card."""

    line: int
    text: str

    def fields(self, *widths: int) -> list[str]:
        """Split the line into fields of fixed widths, or at commas."""
        if "," in self.text:
            return [*(each.strip() for each in self.text.split(",")), *[""] * len(widths)][: len(widths)]
        cells, at = [], 0
        for width in widths:
            cells.append(self.text[at : at + width].strip())
            at += width
        return cells


class DeckReader(MeshBuilder):
    """Reads a mesh from a keyword deck."""

    def __init__(self, path: str) -> None:
        super().__init__(path)
        self.elements: list[tuple[int, int, int, list[int], float]] = []
        self.solids: list[tuple[int, int, int, list[int]]] = []
        self.parts: dict[int, tuple[str, int, int]] = {}
        self.sections: dict[int, float] = {}
        self.metals: dict[int, Wall] = {}

    def read(self) -> Mesh:
        """Read the file and return the mesh."""
        for line, keyword, rows in self._keywords():
            name = keyword.removesuffix("_TITLE")
            titled = name != keyword
            if name.startswith(("NODE", "ELEMENT")):
                rows = [row for row in rows if row.text.strip()]
            if name.startswith("INCLUDE"):
                raise self.includes(line)
            if name == "NODE":
                for row in rows:
                    number, *place = row.fields(8, 16, 16, 16)
                    number = self.number(row.line, number)
                    self.add_node(row.line, number, number, [each or "0" for each in place])
            elif name.startswith("ELEMENT_SHELL"):
                self._shells(name, rows)
            elif name.startswith(("ELEMENT_SOLID", "ELEMENT_TSHELL")):
                self._solids(rows)
            elif name == "ELEMENT_MASS":
                for row in rows:
                    _, node, mass = row.fields(8, 8, 16)
                    value = self.value(row.line, mass, "mass")
                    self.add_mass(row.line, self.number(row.line, node), value)
            elif name.startswith("ELEMENT_"):
                self.left_out[f"lines of *{name}"] += len(rows)
            elif name.startswith("PART") and len(rows) > 1 and name not in ("PART_MOVE", "PART_DUPLICATE"):
                self._parts(name, rows)
            elif name.startswith("SECTION_SHELL"):
                self._sections(rows, titled)
            elif name.removeprefix("MAT_") in METALS and name.startswith("MAT_"):
                # Only the laws with a single card allow several materials under one keyword.
                single = name.removeprefix("MAT_") in METALS[:2]
                for row in rows[titled :: 1 + titled] if single else rows[titled : titled + 1]:
                    self._metal(row)
        return self._finish()

    def _keywords(self) -> Iterator[tuple[int, str, list[_Row]]]:
        line, keyword, rows = 0, "", []
        for number, text in enumerate(read_text(self.path), 1):
            if text.startswith("$"):
                continue
            if not text.startswith("*"):
                rows.append(_Row(number, text))
                continue
            yield line, keyword, _without_end(rows)
            words = text[1:].upper().split()
            line, keyword, rows = number, words[0] if words else "", []
            long = any(each in text.upper().replace(" ", "") for each in ("LONG=Y", "I10=Y"))
            if long or keyword.endswith(("%", "+")) or words[1:2] in (["%"], ["+"]):
                raise self.error(number, "decks in the long or i10 format are not supported; write the standard format")
            if keyword == "END":
                return
        yield line, keyword, _without_end(rows)

    def _shells(self, name: str, rows: list[_Row]) -> None:
        options = name.removeprefix("ELEMENT_SHELL")
        more = any(each in options for each in ("THICKNESS", "BETA", "MCID"))
        step = 1 + more + ("OFFSET" in options) + ("DOF" in options)
        for place in range(0, len(rows), step):
            row = rows[place]
            number, part, *nodes = row.fields(*[8] * 10)
            thickness = math.nan
            if "THICKNESS" in options and place + 1 < len(rows):
                after = rows[place + 1]
                own = [self.value(after.line, each, "thickness") for each in after.fields(*[16] * 4) if each]
                thickness = sum(own) / len(own) if own and all(own) else math.nan
            numbers = [self.number(row.line, each) for each in nodes if each and each != "0"]
            if len(numbers) not in (3, 4, 6, 8):
                raise self.error(row.line, f"this element has {len(numbers)} nodes instead of 3, 4, 6 or 8")
            element = self.number(row.line, number, "an element")
            self.elements.append((row.line, element, self.number(row.line, part, "a part"), numbers, thickness))

    def _solids(self, rows: list[_Row]) -> None:
        numbers: tuple[int, int] | None = None
        for row in rows:
            number, part, *nodes = row.fields(*[8] * 10)
            if numbers is None:
                numbers = self.number(row.line, number, "an element"), self.number(row.line, part, "a part")
                # In the two-line format, the first line has number and part only, the second the nodes.
                if not any(nodes) or len(row.text.split()) == 2:
                    continue
            else:
                nodes = [number, part, *nodes]
            own = [self.number(row.line, each) for each in nodes if each and each != "0"]
            # Tetrahedra, wedges and pyramids are written as hexahedra with repeated nodes.
            self.solids.append((row.line, *numbers, list(dict.fromkeys(own))))
            numbers = None

    def _parts(self, name: str, rows: list[_Row]) -> None:
        for place in range(0, len(rows) - 1, 2) if name == "PART" else (0,):
            number, section, metal = rows[place + 1].fields(10, 10, 10)
            number = self.number(rows[place + 1].line, number, "a part")
            numbers = [int(each) if each.isdecimal() and len(each) < 11 else 0 for each in (section, metal)]
            self.parts[number] = (rows[place].text.strip(), numbers[0], numbers[1])

    def _sections(self, rows: list[_Row], titled: bool) -> None:
        at = int(titled)
        while at + 1 < len(rows):
            cards = rows[at : at + 2]
            number, *_, points, _, _, angles, _ = cards[0].fields(*[10] * 8)
            thickness, *_, offset = cards[1].fields(*[10] * 5)
            if offset.strip("0.+- "):
                self.offsets["sections"] += 1
            if thickness:
                value = self.value(cards[1].line, thickness, "thickness")
                self.sections[self.number(cards[0].line, number, "a section")] = value
            # A composite has another card with angles for every eight of its points.
            more = -(-int(points) // 8) if angles == "1" and points.isdecimal() else 0
            at += 2 + min(more, len(rows)) + titled

    def _metal(self, row: _Row) -> None:
        number, *values = row.fields(10, 10, 10, 10)
        density, youngs, poisson = (
            self.value(row.line, each, what) if each else None
            for each, what in zip(values, ("density", "Young's modulus", "Poisson's ratio"), strict=True)
        )
        known = self.number(row.line, number, "a material")
        self.metals[known] = Wall(youngs=youngs, poisson=poisson, density=density, source=f"*MAT {known}")

    def _finish(self) -> Mesh:
        titles = [title for title, *_ in self.parts.values() if title]
        names = {
            number: title if title and titles.count(title) == 1 else str(number)
            for number, (title, *_) in self.parts.items()
        }
        for line, number, part, nodes, thickness in self.elements:
            self.add_shell(line, number, nodes, [names.get(part, str(part))], thickness=thickness)
        for line, number, part, nodes in self.solids:
            self.add_solid(line, number, nodes, [names.get(part, str(part))])
        for number, (_, section, metal) in self.parts.items():
            source = f"*SECTION_SHELL {section}" if section in self.sections else ""
            material = f"*MAT {metal}" if metal else ""
            self.add_wall(names[number], source, self.sections.get(section), self.metals.get(metal), material)
            self.aliases[str(number)] = names[number]
            # In clubface's own decks, titles consist of head and part: "paper: face".
            short = shortened(names[number], 200).rpartition(": ")[2]
            self.aliases.setdefault(short, names[number])
        return self.mesh()


def _without_end(rows: list[_Row]) -> list[_Row]:
    """Drop blank rows at the end of a keyword; elsewhere a blank row is a card or a title."""
    last = max((place for place, row in enumerate(rows) if row.text.strip()), default=-1)
    return rows[: last + 1]
