"""Reader of Nastran and OptiStruct meshes (.bdf, .nas, .dat, .fem) in small, large and free fields.

Sets are the properties, by number and by the names that pre-processors leave in comments.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from clubface.errors import shortened
from clubface.fem.mesh_files.mesh import LARGEST_NUMBER, Mesh, MeshBuilder, Wall, read_text

SHELLS = {"CQUAD4": 4, "CQUADR": 4, "CQUAD8": 4, "CTRIA3": 3, "CTRIAR": 3, "CTRIA6": 3, "CSHEAR": 4}
"""Number of corners of surface elements."""
THICKNESS = {"CQUAD4": 11, "CQUADR": 11, "CTRIA3": 11, "CTRIAR": 11}
"""Index of the first corner thickness among the fields, counting the name as 0."""
SOLIDS = {"CTETRA": 4, "CHEXA": 8, "CPENTA": 6, "CPYRAM": 5, "CPYRA": 5}
"""Number of corners of solid elements."""
BARS = ("CBAR", "CBEAM", "CROD", "CONROD", "CBUSH", "CELAS1", "CELAS2", "CONM1", "CTUBE", "RBE2", "RBE3", "RBAR")
COMPONENT = re.compile(r'\$HMNAME\s+COMPS?\s+(?P<number>\d{1,10})\s*"(?P<name>[^"]*)"\s*(?P<property>\d{1,10})?')
"""A component of HyperMesh, sometimes with the property of its elements. Numbers of components and properties differ,
except in files that name no properties."""
MEMBERS = re.compile(r"\$HMMOVE\s+(?P<number>\d{1,10})\s*$")
"""Start of a list of the elements of a component, in fields of 8 characters."""
NAMES = (
    re.compile(r'\$HMNAME\s+PROPS?\s+(?P<number>\d{1,10})\s*"(?P<name>[^"]*)"'),  # HyperMesh
    re.compile(r"\$ANSA_NAME(?:_COMMENT)?;(?P<number>\d{1,10});PSHELL;~?(?P<name>[^;]*)"),
    re.compile(r"\$.*\bproperty\s+(?P<number>\d{1,10})\s*[:=]\s*(?P<name>.+)", re.IGNORECASE),  # Femap
)
"""Comments that name a property."""
BEFORE = re.compile(r"\$\*?.*?\b(?:property|region|pshell|physical property|set)\b[^:]*:\s*(?P<name>.+)", re.IGNORECASE)
"""A comment that names the property of the next PSHELL card, as written by Patran and NX."""


class _Card:
    """A card, with its name and fields as text."""

    def __init__(self, line: int, fields: list[str], comment: str) -> None:
        self.line, self.fields, self.comment = line, fields, comment
        self.name = fields[0].rstrip("*").upper()

    def __getitem__(self, place: int) -> str:
        return self.fields[place] if place < len(self.fields) else ""


class NastranReader(MeshBuilder):
    """Reads a mesh of Nastran."""

    def __init__(self, path: str) -> None:
        super().__init__(path)
        self.names: dict[int, str] = {}
        self.components: dict[int, tuple[str, int | None]] = {}
        self.members: dict[int, list[str]] = {}
        self.taking: int | None = None
        self.unnamed: int | None = None
        self.properties: dict[int, tuple[str, int, float | None]] = {}
        self.metals: dict[int, Wall] = {}

    def read(self) -> Mesh:
        """Read the file and return the mesh."""
        for card in self._cards():
            if card.name == "GRID":
                self._grid(card)
            elif card.name in SHELLS:
                self._shell(card)
            elif card.name in SOLIDS:
                count = SOLIDS[card.name]
                nodes = [self.number(card.line, card[3 + corner]) for corner in range(count)]
                number = self.number(card.line, card[1], "an element")
                self.add_solid(card.line, number, nodes, [card[2] or card[1]])
            elif card.name in ("PSHELL", "PSOLID"):
                self._property(card)
            elif card.name == "MAT1":
                self._metal(card)
            elif card.name == "CONM2":
                self._mass(card)
            elif card.name in BARS:
                self.left_out[f"cards {card.name}"] += 1
            elif card.name in ("INCLUDE", "IMPORT") or card.name.startswith("INCLUDE"):
                raise self.includes(card.line)
            elif card.name == "GRDSET" and card[2] not in ("", "0"):
                raise self.error(
                    card.line,
                    f"nodes are in coordinate system {shortened(card[2], 20)}; write all nodes in the basic system",
                )
        self._name_components()
        self.aliases |= {name: str(number) for number, name in self.names.items()}
        for number, (kind, metal, thickness) in self.properties.items():
            material = f"MAT {metal}" if metal else ""
            self.add_wall(str(number), f"{kind} {number}", thickness, self.metals.get(metal), material)
        return self.mesh()

    def _cards(self) -> Iterator[_Card]:
        card: _Card | None = None
        comment = ""
        for number, text in enumerate(read_text(self.path), 1):
            if text.startswith("$"):
                self._comment(text)
                comment = text
                continue
            text = text.partition("$")[0].rstrip()
            if not text.strip():
                continue
            fields = _fields(text)
            if text[0] in " +*\t," and card is not None:
                card.fields += fields[1:]
                continue
            if card is not None:
                yield card
            card, comment = _Card(number, fields, comment), ""
        if card is not None:
            yield card

    def _comment(self, text: str) -> None:
        if self.unnamed is not None:  # ANSA puts a long name on the next line
            self.names.setdefault(self.unnamed, text[1:].strip())
            self.unnamed = None
        if matched := COMPONENT.match(text):
            own = matched["property"]
            self.components[int(matched["number"])] = matched["name"].strip(), None if own is None else int(own)
        if matched := MEMBERS.match(text):
            self.taking = int(matched["number"])
        elif self.taking is not None:
            fields = [text[at : at + 8].strip() for at in range(8, len(text), 8)]
            words = [word for each in fields for word in re.findall(r"\d+|THRU", each)]
            self.members.setdefault(self.taking, []).extend(words)
            self.taking = self.taking if words else None
        for pattern in NAMES:
            if matched := pattern.match(text):
                name = matched["name"].strip()
                if name:
                    self.names.setdefault(int(matched["number"]), name)
                elif "ANSA" in text:
                    self.unnamed = int(matched["number"])

    def _name_components(self) -> None:
        """Make components sets of their elements, or use their names for their properties."""
        named = bool(self.names)
        for number, (name, own) in self.components.items():
            if number in self.members:
                self.add_to_set(name, _numbers(self.members[number]))
            elif own is not None:
                self.aliases[name] = str(own)
            elif not named:
                self.names.setdefault(number, name)

    def _grid(self, card: _Card) -> None:
        number = self.number(card.line, card[1])
        if card[2] not in ("", "0"):
            system = f"coordinate system {shortened(card[2], 20)}"
            raise self.error(card.line, f"node {number} is in {system}; write all nodes in the basic system")
        self.add_node(card.line, number, number, [_number(card[place] or "0") for place in (3, 4, 5)])

    def _shell(self, card: _Card) -> None:
        number = self.number(card.line, card[1], "an element")
        group = card[2] or card[1]  # the default property has the element's number
        count = SHELLS[card.name]
        nodes = [self.number(card.line, card[3 + corner]) for corner in range(count)]
        higher = card.name[-1] in "68"
        middle = [each for each in card.fields[3 + count : 3 + 2 * count] if each] if higher else []
        first = THICKNESS.get(card.name)
        own = [] if first is None else card.fields[first : first + count]
        if first is not None and _number(card[4 + count]).strip("0.+- "):
            self.offsets["elements"] += 1
        if first is not None and card[10] == "1":
            message = f"the corner thicknesses of element {number} are relative to its property (TFLAG = 1), which is"
            raise self.error(card.line, f"{message} not supported; write them with TFLAG = 0")
        values = [self.value(card.line, _number(each), "thickness") for each in own if each]
        self.add_shell(
            card.line, number, nodes if not middle else [*nodes, *nodes], [group],
            thickness=sum(values) / len(values) if len(values) == count else float("nan"),
        )  # fmt: skip

    def _property(self, card: _Card) -> None:
        number = self.number(card.line, card[1], "a property")
        shell = card.name == "PSHELL"
        thickness = self.value(card.line, _number(card[3]), "thickness") if shell and card[3] else None
        if shell and _number(card[8]).strip("0.+- "):
            self.left_out["properties with a mass spread over the wall (NSM of PSHELL)"] += 1
        metal = int(card[2]) if card[2].isdecimal() and len(card[2]) < 11 else 0
        self.properties[number] = card.name, metal, thickness
        if (matched := BEFORE.match(card.comment)) is not None and matched["name"].strip():
            self.names.setdefault(number, matched["name"].strip())

    def _metal(self, card: _Card) -> None:
        number = self.number(card.line, card[1], "a material")

        def value(place: int, what: str) -> float | None:
            return self.value(card.line, _number(card[place]), what) if card[place] else None

        youngs, shear, poisson = value(2, "Young's modulus"), value(3, "shear modulus"), value(4, "Poisson's ratio")
        if poisson is None and youngs and shear:
            poisson = youngs / (2.0 * shear) - 1.0
        if youngs is None and shear and poisson is not None:
            youngs = 2.0 * shear * (1.0 + poisson)
        metal = Wall(youngs=youngs, poisson=poisson, density=value(5, "density"), source=f"MAT1 {number}")
        self.metals[number] = metal

    def _mass(self, card: _Card) -> None:
        number = self.number(card.line, card[2])
        if card[3] not in ("", "0"):
            raise self.error(card.line, f"CONM2 {card[1]} is not in the basic coordinate system, as it must be")
        mass = self.value(card.line, _number(card[4]), "mass")
        offset = [self.value(card.line, _number(card[place] or "0"), "offset") for place in (5, 6, 7)]
        self.add_mass(card.line, number, mass, offset)


def _numbers(words: list[str]) -> Iterator[int]:
    """Yield the numbers of a list with ranges, such as 1 THRU 10 12."""
    last = None
    for place, word in enumerate(words):
        if word == "THRU":
            after = int(words[place + 1]) if place + 1 < len(words) and words[place + 1].isdecimal() else 0
            yield from range((last or after) + 1, min(after, LARGEST_NUMBER))
        else:
            last = int(word)
            yield last


def _fields(text: str) -> list[str]:
    """Split a line into its name and its eight (or four large) data fields."""
    if "," in text:
        return [*(each.strip() for each in text.split(",")), *[""] * 8][:9]
    text = text.expandtabs(8)
    width, count = (16, 4) if "*" in text[:8] else (8, 8)
    return [text[:8].strip(), *(text[8 + width * place : 8 + width * (place + 1)].strip() for place in range(count))]


def _number(text: str) -> str:
    """Convert a Nastran number to common notation: 4.43-9 to 4.43e-9, 1.D3 to 1e3."""
    text = text.strip().replace("D", "e").replace("d", "e")
    return re.sub(r"(?<=[\d.])([+-]\d+)$", r"e\1", text)
