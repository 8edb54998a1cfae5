"""A mesh of one's own and the file of its head, for the tests of such heads, in every format that is read."""

import struct
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from clubface.fem.heads import Group
from fem_runs import coarse_head

HEAD = """\
name = "own head"
kind = "mesh"
file = "head.msh"
unit = "mm"
loft = "11.5 deg"
bulge = "305 mm"
roll = "305 mm"

[[groups]]
name = "face"
thickness = "2.8 mm"
face = true

[[groups]]
name = "crown"
thickness = "1.3 mm"

[[groups]]
name = "sole"
thickness = "1.6 mm"
youngs = "110 GPa"

[[groups]]
name = "skirt"
thickness = "1.4 mm"

[[masses]]
name = "weight"
x = "-40 mm"
y = "-22 mm"
z = "0 mm"
mass = "60 g"
"""

WHOLE = HEAD.partition("[[groups]]")[0] + '[[groups]]\nname = "shell"\nthickness = "2 mm"\nface = true\n'
"""A head of one group, for files without any."""

FACE = {"loft": "11.5 deg", "bulge": "305 mm", "roll": "305 mm"}
PARTS = ("face", "crown", "sole", "skirt")
GROUPS = (
    Group(name="face", thickness="2.8 mm", face=True),
    *(Group(name=each, thickness="1.4 mm") for each in PARTS[1:]),
)


class Walls(NamedTuple):
    """A mesh before it is written: nodes in mm, elements of 3, 4, 6 or 8 nodes by part, and cards of each part."""

    nodes: Any
    parts: dict[str, list[list[int]]]
    cards: Mapping[str, tuple[float, float, float, float]] = MappingProxyType({})
    """Thickness [mm], Young's modulus [MPa], Poisson's ratio, density [t/mm3]."""

    @property
    def elements(self):
        """Part and nodes of each, in order."""
        return [(name, each) for name, elements in self.parts.items() for each in elements]

    def change(self, each):
        """Return it with every element replaced by a list of elements."""
        return self._replace(
            parts={name: [new for one in rows for new in each(one)] for name, rows in self.parts.items()}
        )

    def triangles(self):
        return self.change(lambda row: [row] if len(row) == 3 else [row[:3], [row[0], *row[2:]]])

    def reversed(self, name):
        return self._replace(parts={**self.parts, name: [each[::-1] for each in self.parts[name]]})

    def with_edge_nodes(self):
        """Return it with a node in the middle of every edge of an element."""
        nodes, made = list(map(tuple, self.nodes)), {}

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in made:
                made[key] = len(nodes)
                nodes.append(tuple(0.5 * (np.array(nodes[a]) + nodes[b])))
            return made[key]

        def grown(quad):
            return [[*quad, *(between(a, b) for a, b in zip(quad, quad[1:] + quad[:1], strict=True))]]

        changed = self.change(grown)
        return changed._replace(nodes=np.array(nodes))

    def apart(self, shift=0.0):
        """Return it with nodes of their own for each part, moved a little, as parts that are meshed one by one have."""
        nodes, parts = [], {}
        for place, (name, rows) in enumerate(self.parts.items()):
            used = sorted({each for row in rows for each in row})
            to = {each: len(nodes) + number for number, each in enumerate(used)}
            nodes += [tuple(self.nodes[each] + shift * (place % 2)) for each in used]
            parts[name] = [[to[each] for each in row] for row in rows]
        return self._replace(nodes=np.array(nodes), parts=parts)


def coarse_walls():
    """Return the coarse head of the paper with its four parts."""
    head, start, parts = coarse_head(), 0, {}
    for part in head.parts:
        parts[part.name] = head.quads[start : start + part.elements].astype(int).tolist()
        start += part.elements
    return Walls(head.nodes * 1e3, parts)


def _nodes(walls, form):
    return [form.format(number, *map(float, place)) for number, place in enumerate(walls.nodes, 1)]


def gmsh_2(walls):
    kinds = {3: 2, 4: 3, 6: 9, 8: 16}
    names = list(walls.parts)
    elements = [
        f"{number} {kinds[len(row)]} 2 {names.index(name) + 1} 1 {' '.join(str(each + 1) for each in row)}"
        for number, (name, row) in enumerate(walls.elements, 1)
    ]
    named = [f'2 {number} "{name}"' for number, name in enumerate(names, 1)]
    nodes = _nodes(walls, "{} {} {} {}")
    sections = {
        "MeshFormat": ["2.2 0 8"], "PhysicalNames": [str(len(named)), *named], "Nodes": [str(len(nodes)), *nodes],
        "Elements": [str(len(elements)), *elements],
    }  # fmt: skip
    return "".join(f"${name}\n" + "\n".join(rows) + f"\n$End{name}\n" for name, rows in sections.items())


def gmsh_4(walls, binary=False):
    """Write version 4.1 as Gmsh does: every part an entity with its physical group, its nodes in blocks."""
    names = list(walls.parts)
    size, whole = (lambda *v: struct.pack(f"<{len(v)}q", *v)), (lambda *v: struct.pack(f"<{len(v)}i", *v))
    real = lambda *v: struct.pack(f"<{len(v)}d", *v)  # noqa: E731
    if not binary:
        size = whole = real = lambda *v: (" ".join(map(str, v)) + " ").encode()
    end = b"" if binary else b"\n"
    box = (-200.0, -200.0, -200.0, 200.0, 200.0, 200.0)
    entities = size(0, 0, len(names), 0) + end
    for place in range(1, len(names) + 1):
        entities += whole(place) + real(*box) + size(1) + whole(place) + size(0) + end
    count = len(walls.nodes)
    nodes = size(1, count, 1, count) + end + whole(2, 1, 0) + size(count) + end
    nodes += b"".join(size(number) + end for number in range(1, count + 1))
    nodes += b"".join(real(*map(float, place)) + end for place in walls.nodes)
    kinds, blocks, number = {3: 2, 4: 3, 6: 9, 8: 16}, [], 0
    for place, rows in enumerate(walls.parts.values(), 1):
        for corners, kind in kinds.items():
            some = [row for row in rows if len(row) == corners]
            block = whole(2, place, kind) + size(len(some)) + end
            for row in some:
                number += 1
                block += size(number, *(each + 1 for each in row)) + end
            blocks += [block] if some else []
    elements = size(len(blocks), number, 1, number) + end + b"".join(blocks)
    named = "\n".join(f'2 {place} "{name}"' for place, name in enumerate(names, 1))
    head = b"4.1 1 8\n" + struct.pack("<i", 1) + b"\n" if binary else b"4.1 0 8\n"
    sections = {"MeshFormat": head, "PhysicalNames": f"{len(names)}\n{named}\n".encode(), "Entities": entities,
                "Nodes": nodes, "Elements": elements}  # fmt: skip
    return b"".join(
        b"$" + name.encode() + b"\n" + content + (b"\n" if binary and len(content) > 99 else b"")
        + b"$End" + name.encode() + b"\n" for name, content in sections.items()
    )  # fmt: skip


def abaqus(walls):
    kinds = {3: "S3", 4: "S4R", 6: "STRI65", 8: "S8R"}
    lines, number = ["*HEADING", " head", "*NODE, NSET=ALLNODES", *_nodes(walls, "{}, {:.9g}, {:.9g}, {:.9g}")], 0
    for name, rows in walls.parts.items():
        for count in sorted({len(row) for row in rows}):
            lines.append(f"*ELEMENT, TYPE={kinds[count]}, ELSET={name}")
            for row in rows:
                number += len(row) == count
                if len(row) == count:
                    lines.append(", ".join(map(str, (number, *(each + 1 for each in row)))))
    lines += ["*ELSET, ELSET=Surface1, GENERATE", f"1, {number}, 1", "*ELSET, ELSET=nothing"]
    for name, (thickness, youngs, poisson, density) in walls.cards.items():
        lines += [f"*SHELL SECTION, ELSET={name}, MATERIAL=M-{name}", f" {thickness}, 5"]
        lines += [f"*MATERIAL, NAME=M-{name}", "*DENSITY", f" {density},", "*ELASTIC", f" {youngs}, {poisson}"]
    return "\n".join(lines) + "\n"


def nastran(walls, width=","):
    """Write small (8), large (16) or free (",") fields."""

    def card(*fields):
        texts = [_nastran(each, 14 if width == 16 else 7) for each in fields]
        if width == ",":
            rows = [texts[place : place + 9] for place in range(0, len(texts), 8)]
            return ",".join(texts[:9]) + "".join("\n," + ",".join(texts[at : at + 8]) for at in range(9, len(texts), 8))
        count = 8 if width == 8 else 4
        rows = [texts[1:][place : place + count] for place in range(0, len(texts) - 1, count)]
        first = f"{texts[0] + ('*' if width == 16 else ''):<8}"
        after = "*" + " " * 7 if width == 16 else "+" + " " * 7
        return "\n".join((after if number else first) + "".join(f"{each:<{width}}" for each in row)
                         for number, row in enumerate(rows))  # fmt: skip

    kinds = {3: "CTRIA3", 4: "CQUAD4", 6: "CTRIA6", 8: "CQUAD8"}
    names = list(walls.parts)
    lines = ["SOL 101", "CEND", "BEGIN BULK", *(f'$HMNAME PROP  {names.index(each) + 1}"{each}" 4' for each in names)]
    lines += [card("GRID", number, None, *map(float, place)) for number, place in enumerate(walls.nodes, 1)]
    for number, (name, row) in enumerate(walls.elements, 1):
        lines.append(card(kinds[len(row)], number, names.index(name) + 1, *(each + 1 for each in row)))
    for name, (thickness, youngs, poisson, density) in walls.cards.items():
        number = names.index(name) + 1
        lines += [card("PSHELL", number, number, thickness, number)]
        lines += [card("MAT1", number, youngs, None, poisson, density)]
    return "\n".join([*lines, "ENDDATA"]) + "\n"


def _nastran(value, digits):
    if value is None or isinstance(value, int | str):
        return "" if value is None else str(value)
    for places in range(digits, 0, -1):
        plain = f"{value:.{places}g}"
        text = plain if "e" not in plain else plain.replace("e", "").replace("-0", "-")
        text = text if "." in text else (text + "." if "e" not in plain else text[:1] + "." + text[1:])
        if len(text) <= digits + 1:
            return text
    raise AssertionError(value)


def stl_text(walls):
    lines = []
    for name, rows in walls.triangles().parts.items():
        lines.append(f"solid {name}")
        for row in rows:
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex {:.7g} {:.7g} {:.7g}".format(*walls.nodes[each]) for each in row]
            lines += ["endloop", "endfacet"]
        lines.append(f"endsolid {name}")
    return "\n".join(lines) + "\n"


def stl_binary(walls):
    rows = [row for _, row in walls.triangles().elements]
    facets = [struct.pack("<12fH", 0, 0, 0, *(float(x) for each in row for x in walls.nodes[each]), 0) for row in rows]
    return bytes(80) + struct.pack("<I", len(rows)) + b"".join(facets)


def lsdyna(walls):
    names = list(walls.parts)
    lines = ["*KEYWORD", "*NODE", *_nodes(walls, "{:8d}{:16.8e}{:16.8e}{:16.8e}"), "*ELEMENT_SHELL"]
    for number, (name, row) in enumerate(walls.elements, 1):
        corners = [each + 1 for each in (*row, *row[-1:])][:4] if len(row) < 5 else [each + 1 for each in row]
        lines.append("".join(f"{each:8d}" for each in (number, names.index(name) + 1, *corners)))
    for number, name in enumerate(names, 1):
        lines += ["*PART", name, "".join(f"{number:10d}" for _ in range(3))]
        if name in walls.cards:
            thickness, youngs, poisson, density = walls.cards[name]
            lines += ["*SECTION_SHELL", f"{number:10d}{2:10d}", f"{thickness:10.4f}" * 4]
            lines += ["*MAT_ELASTIC", f"{number:10d}{density:10.3e}{youngs:10.1f}{poisson:10.3f}"]
    return "\n".join([*lines, "*END"]) + "\n"


def by_meshlane(walls, form, **options):
    """Return what meshlane writes, which is another program than the readers."""
    import tempfile
    from pathlib import Path

    import meshlane

    cells, tags = [], []
    for place, rows in enumerate(walls.parts.values(), 1):
        for count, kind in ((3, "triangle"), (4, "quad")):
            if some := [row for row in rows if len(row) == count]:
                cells.append((kind, np.array(some)))
                tags.append(np.full(len(some), place))
    data = {"gmsh:physical": tags, "gmsh:geometrical": tags} if form.startswith("gmsh") else {"group": tags}
    fields = {name: np.array([place, 2]) for place, name in enumerate(walls.parts, 1)}
    mesh = meshlane.Mesh(walls.nodes, cells, cell_data=data, field_data=fields if form.startswith("gmsh") else {})
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "mesh"
        meshlane.write(path, mesh, form, **options)
        return path.read_bytes()


FORMATS = {
    "gmsh2.msh": gmsh_2,
    "gmsh2-binary.msh": lambda walls: by_meshlane(walls, "gmsh22", binary=True),
    "gmsh4.msh": gmsh_4,
    "gmsh4-binary.msh": lambda walls: gmsh_4(walls, binary=True),
    "abaqus.inp": abaqus,
    "free.bdf": nastran,
    "small.nas": lambda walls: nastran(walls, 8),
    "large.fem": lambda walls: nastran(walls, 16),
    "text.stl": stl_text,
    "dyna.k": lsdyna,
    "unstructured.vtk": lambda walls: by_meshlane(walls, "vtk"),
}
"""Writers by the name of a file."""


def write_walls(folder, walls, name="abaqus.inp"):
    """Write a mesh in the format of the name of its file; return its path."""
    content = FORMATS[name](walls)
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def write_mesh(folder, name="head.msh", scale=1.0, change=lambda quad: quad):
    """Write the coarse head of the paper, its quadrilaterals of the face changed; return the path."""
    walls = coarse_walls()
    parts = {**walls.parts, "face": [change(quad) for quad in walls.parts["face"]]}
    nodes = np.vstack([scale * walls.nodes, [[0.0, 0.0, 0.0]]])  # and a point that no element uses
    walls = walls._replace(nodes=nodes, parts=parts)
    path = folder / name
    path.write_text((gmsh_2 if name.endswith(".msh") else abaqus)(walls))
    return path
