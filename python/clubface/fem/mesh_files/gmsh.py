"""Reader of Gmsh meshes, versions 2 and 4, in text and binary.

Both forms of file provide their rows through the same interface, so that the contents of a section are decoded in one
place.
"""

from __future__ import annotations

import shlex
import struct
from collections.abc import Callable

from clubface.errors import FileError, shortened
from clubface.fem.mesh_files.mesh import Mesh, MeshBuilder
from clubface.support.files import read_input

SHELLS = {2: 3, 3: 4, 9: 6, 10: 9, 16: 8}
"""Numbers of nodes of the supported surface elements, by type."""
SOLIDS = {4: 4, 5: 8, 6: 6, 7: 5, 11: 10, 12: 27, 13: 18, 14: 14, 17: 20, 18: 15, 19: 13}
"""Numbers of nodes of solid elements, by type."""
NODES = {1: 2, 8: 3, 15: 1, **SHELLS, **SOLIDS}
"""Numbers of nodes of every type of element that a head's file may contain."""
MOST_TAGS = 99
"""Maximum number of tags of an element: physical and geometrical group, and partitions."""


class _TextRows:
    """Rows of a section in a text file; ``line`` is the current line number."""

    def __init__(self, builder: MeshBuilder, lines: list[str], first: int, last: int) -> None:
        self._builder, self._lines, self._next, self._last = builder, lines, first, last
        self._cells: list[str] = []
        self._place = 0
        self.line: int | None = first

    def values(self, kinds: str) -> tuple[float, ...]:
        """Return the next values of a row: "i" for an integer, "n" for an 8-byte count or tag, "d" for a real."""
        while not self._cells:
            if self._next >= self._last:
                raise self._builder.error(self._next, "the section ends here, but is declared to have more rows")
            self._cells, self._next = self._lines[self._next].split(), self._next + 1
            self.line = self._next
        cells = self._cells[self._place : self._place + len(kinds)]
        if len(cells) < len(kinds):
            missing = "a number and three coordinates" if kinds == "nddd" else "as many as its kind needs"
            raise self._builder.error(self.line, f"this row has {len(self._cells)} cells; it needs {missing}")
        self._place += len(kinds)
        number, coordinate = self._builder.number, self._builder.coordinate
        return tuple(
            coordinate(self.line, cell) if kind == "d" else number(self.line, cell.removeprefix("-"))
            for kind, cell in zip(kinds, cells, strict=True)
        )

    def end_row(self) -> None:
        """Raise an error if the row has more values."""
        if self._place < len(self._cells):
            raise self._builder.error(self.line, f"this row has {len(self._cells)} cells instead of {self._place}")
        self._cells, self._place = [], 0


class _ByteRows:
    """Rows of a section in a binary file, from an offset on."""

    line = None

    def __init__(self, builder: MeshBuilder, content: bytes, at: int, order: str) -> None:
        self._builder, self._content, self.at, self._order = builder, content, at, order

    def values(self, kinds: str) -> tuple[float, ...]:
        form = self._order + kinds.replace("n", "q")
        size = struct.calcsize(form)
        if size > len(self._content) - self.at:
            raise self._builder.error(None, "the file ends in the middle of a section")
        values = struct.unpack_from(form, self._content, self.at)
        self.at += size
        return values

    def end_row(self) -> None:
        pass


_Rows = _TextRows | _ByteRows


class GmshReader(MeshBuilder):
    """Reads a mesh of Gmsh; sets are its physical groups, by name and by number."""

    def __init__(self, path: str) -> None:
        super().__init__(path)
        self.version = 0.0
        self.names: dict[tuple[int, int], str] = {}
        self.physical: dict[int, list[int]] = {}

    def read(self) -> Mesh:
        """Read the file and return the mesh."""
        content = read_input(self.path)
        start = content.find(b"$MeshFormat")
        header = content[start : start + 80].split(b"\n")[1].split() if start >= 0 and b"\n" in content[start:] else []
        try:
            self.version, binary = float(header[0]), header[1] == b"1"
        except (IndexError, ValueError):
            raise FileError(self.path, None, "this mesh cannot be read: $MeshFormat is missing") from None
        if not 2.0 <= self.version < 3.0 and not 4.0 <= self.version < 5.0:
            message = f"version {self.version:g} of Gmsh's format is not supported; write version 2 or 4"
            raise FileError(self.path, 2, message)
        self._binary(content) if binary else self._text(content)
        # If a surface and a volume have the same number, it refers to the surface.
        groups = sorted(self.names.items(), reverse=True)
        self.aliases = {str(number): name for (dimension, number), name in groups if dimension in (2, 3)}
        return self.mesh()

    def _text(self, content: bytes) -> None:
        lines = content.decode("utf-8", "replace").splitlines()
        start = None
        for number, text in enumerate(lines):
            if text.startswith("$End"):
                if start is not None and "$End" + lines[start].strip()[1:] == text.strip():
                    self._section(lines[start].strip(), lines, start, number)
                start = None
            elif text.startswith("$"):
                start = number
        if start is not None:
            message = f"the section {shortened(lines[start], 40)} that begins in line {start + 1} has no end"
            raise FileError(self.path, None, f"this mesh cannot be read: {message}")

    def _section(self, name: str, lines: list[str], start: int, end: int) -> None:
        if name == "$PhysicalNames":
            self._physical_names(lines[start + 2 : end])
        elif (reader := self._reader(name)) is not None:
            if self.version < 3.0 and lines[start + 1].strip() != str(end - start - 2):
                stated, has = shortened(lines[start + 1].strip(), 40), max(0, end - start - 2)
                raise FileError(self.path, start + 2, f"this section is declared to have {stated} lines, but has {has}")
            reader(_TextRows(self, lines, start + 1, end))

    def _reader(self, name: str) -> Callable[[_Rows], None] | None:
        nodes, elements = (self._nodes_2, self._elements_2) if self.version < 3.0 else (self._nodes_4, self._elements_4)
        return {"$Nodes": nodes, "$Elements": elements, "$Entities": self._entities}.get(name)

    def _binary(self, content: bytes) -> None:
        at = content.find(b"$EndMeshFormat")
        one = content[at - 5 : at - 1]
        order = ">" if one == b"\0\0\0\1" else "<"
        while (at := content.find(b"\n$", at)) >= 0:
            end_of_name = content.find(b"\n", at + 1)
            name = content[at + 1 : end_of_name].strip().decode("latin-1")
            at = end_of_name
            if end_of_name < 0 or name.startswith("$End"):
                continue
            if name == "$PhysicalNames":
                end = content.find(b"$End", at)
                self._physical_names(content[at:end].decode("utf-8", "replace").splitlines()[2:])
            elif (reader := self._reader(name)) is not None:
                rows = _ByteRows(self, content, at + 1, order)
                reader(rows)
                at = rows.at - 1
            else:
                at = content.find(b"\n$End" + name[1:].encode("latin-1"), at)
                if at < 0:
                    return

    def _physical_names(self, lines: list[str]) -> None:
        for text in lines:
            try:
                dimension, number, *name = shlex.split(text)
            except ValueError:
                continue
            if name and dimension in ("2", "3") and number.isdecimal() and len(number) < 11:
                self.names[int(dimension), int(number)] = name[0]

    def _count(self, rows: _Rows) -> int:
        """Return the count at the start of a version 2 section, which is text even in a binary file."""
        if isinstance(rows, _ByteRows):
            end = rows._content.find(b"\n", rows.at)
            text = rows._content[rows.at : end].decode("latin-1")
            rows.at = end + 1
            return self.number(None, text, "rows")
        (count,) = rows.values("n")
        rows.end_row()
        return int(count)

    def _nodes_2(self, rows: _Rows) -> None:
        kinds = "iddd" if isinstance(rows, _ByteRows) else "nddd"
        for _ in range(self._count(rows)):
            number, *place = rows.values(kinds)
            rows.end_row()
            self.add_node(rows.line, int(number), int(number), place)

    def _elements_2(self, rows: _Rows) -> None:
        count = self._count(rows)
        done = 0
        while done < count:
            if isinstance(rows, _ByteRows):
                kind, several, tags = map(int, rows.values("iii"))
                self._check_kind(rows, kind)
                if several < 1:
                    raise self.error(None, "a block of elements is empty")
            else:
                several, tags, kind = 1, 0, 0
            for _ in range(several):
                if isinstance(rows, _ByteRows):
                    (number,) = rows.values("i")
                else:
                    number, kind, tags = map(int, rows.values("nnn"))
                    self._check_kind(rows, kind)
                if not 0 <= tags <= MOST_TAGS:
                    raise self.error(rows.line, f"this element is declared to have {tags} tags")
                taken = rows.values("i" * tags) if tags else ()
                nodes = rows.values("i" * NODES[kind])
                rows.end_row()
                self._add(rows.line, kind, int(number), nodes, [int(each) for each in taken[:1] if each])
            done += several

    def _entities(self, rows: _Rows) -> None:
        counts = [int(each) for each in rows.values("nnnn")]
        rows.end_row()
        for dimension, count in enumerate(counts):
            for _ in range(count):
                (tag,) = rows.values("i")
                rows.values("ddd" if dimension == 0 and self.version > 4.05 else "dddddd")
                groups = self._some(rows)
                if dimension:
                    self._some(rows)
                rows.end_row()
                if dimension >= 2:
                    self.physical[dimension * 2**40 + int(tag)] = [abs(each) for each in groups]

    @staticmethod
    def _some(rows: _Rows) -> list[int]:
        """Return the tags that follow their count."""
        (count,) = rows.values("n")
        return [int(rows.values("i")[0]) for _ in range(int(count))]

    def _blocks(self, rows: _Rows) -> int:
        blocks = int(rows.values("nnnn" if self.version > 4.05 else "nn")[0])
        rows.end_row()
        return blocks

    def _nodes_4(self, rows: _Rows) -> None:
        for _ in range(self._blocks(rows)):
            dimension, _, parametric, count = map(int, rows.values("iiin"))
            if self.version < 4.05:  # tag and dimension are in the opposite order
                dimension = 0
            rows.end_row()
            more = "d" * (dimension if parametric and self.version > 4.05 else 0)
            if self.version < 4.05:
                for _ in range(count):
                    number, *place = rows.values("iddd")
                    rows.end_row()
                    self.add_node(rows.line, int(number), int(number), place)
                continue
            numbers = []
            for _ in range(count):
                numbers.append(int(rows.values("n")[0]))
                rows.end_row()
            for number in numbers:
                place = rows.values("ddd" + more)
                rows.end_row()
                self.add_node(rows.line, number, number, place[:3])

    def _elements_4(self, rows: _Rows) -> None:
        for _ in range(self._blocks(rows)):
            dimension, entity, kind, count = map(int, rows.values("iiin"))
            if self.version < 4.05:
                dimension, entity = entity, dimension
            rows.end_row()
            self._check_kind(rows, kind)
            whole = "n" if self.version > 4.05 else "i"
            groups = self.physical.get(dimension * 2**40 + entity, [])
            for _ in range(count):
                number, *nodes = rows.values(whole * (1 + NODES[kind]))
                rows.end_row()
                self._add(rows.line, kind, int(number), nodes, groups)

    def _check_kind(self, rows: _Rows, kind: int) -> None:
        if kind not in NODES:
            write = "write triangles and quadrilaterals of order 1 or 2"
            raise self.error(rows.line, f"Gmsh elements of type {kind} are not supported; {write}")

    def _add(self, line: int | None, kind: int, number: int, nodes: tuple[float, ...] | list[float],
             groups: list[int]) -> None:  # fmt: skip
        names = [self.names.get((2 if kind in SHELLS else 3, each), str(each)) for each in groups]
        if kind in SHELLS:
            self.add_shell(line, number, [int(each) for each in nodes], names)
        elif kind in SOLIDS:
            self.add_solid(line, number, [int(each) for each in nodes], names)
