"""The bones of a C3D file, looked at before a library reads it.

A file cut short is otherwise read as a shorter recording, and a damaged one can take the whole process with it. The
layout is that of "The C3D File Format User Guide" (Motion Lab Systems): a header of 512 bytes, a section of groups of
parameters, and frames of points and analogue samples.
"""

from __future__ import annotations

import os
import struct
from typing import NamedTuple

from clubface.errors import FileError
from clubface.support.input_files import read_input

BLOCK = 512
MAGIC = 0x50
PROCESSORS = {84: ("<", 15), 85: ("<", 13), 86: (">", 12)}
"""Order of bytes, and which byte of the header has the sign of its scale: of Intel, DEC and MIPS."""
SIZES = {-1: 1, 1: 1, 2: 2, 4: 4}
"""Bytes of an element by the type of a parameter: letter, byte, integer, float."""
TEXT = -1
"""The type of a text."""
NUMBERS = {
    "POINT": ("USED", "SCALE", "RATE", "DATA_START", "FRAMES"),
    "ANALOG": ("USED", "GEN_SCALE", "RATE"),
    "ROTATION": ("USED", "DATA_START", "RATE", "RATIO"),
    "FORCE_PLATFORM": ("USED",),
}
"""Parameters that hold one number, where they are there; libraries take that for granted."""
MOST_POINTS = 10_000
NOT_C3D = "this is not a C3D file"
DAMAGED = "this C3D file is damaged"


class Layout(NamedTuple):
    """What the header says.

    Attributes
    ----------
    points, analogues
        Points and analogue samples in a frame.
    frames
        Frames in the file.
    first_frame
        Number of the first one.
    """

    points: int
    analogues: int
    frames: int
    first_frame: int


def check_layout(path: str | os.PathLike[str]) -> Layout:
    """Return what a C3D file says it holds; one that is empty, cut short or damaged is a :class:`FileError`."""
    name = os.fspath(path)
    content = read_input(path)
    if not content:
        raise FileError(name, None, "the file is empty")
    if len(content) < 2 or content[1] != MAGIC or content[0] < 2:
        raise FileError(name, None, NOT_C3D)
    try:
        return _Reader(content, name).layout()
    except (struct.error, IndexError):
        raise FileError(
            name, None, f"the file is cut short: it ends within its parameters, after {len(content)} bytes"
        ) from None


class _Parameter(NamedTuple):
    """One parameter.

    Attributes
    ----------
    group, label
        The number of its group, and its name.
    kind, dimensions, elements
        Type, number of dimensions, and number of elements.
    value
        The first of whole numbers.
    end
        Where it ends.
    """

    group: int
    label: str
    kind: int
    dimensions: int
    elements: int
    value: int
    end: int


class _Reader:
    """Walks through the bytes of one file."""

    def __init__(self, content: bytes, name: str) -> None:
        self.content, self.name = content, name
        self.start = (content[0] - 1) * BLOCK
        processor = content[self.start + 3]
        if processor not in PROCESSORS:
            raise self.damaged(f"processor type {processor}, not 84, 85 or 86")
        self.order, self.sign = PROCESSORS[processor]
        self.found: dict[str, int] = {}

    def damaged(self, what: str) -> FileError:
        return FileError(self.name, None, f"{DAMAGED}: {what}")

    def integer(self, at: int) -> int:
        return struct.unpack_from(f"{self.order}H", self.content, at)[0]

    def layout(self) -> Layout:
        points, analogues, first, last = (self.integer(at) for at in (2, 4, 6, 8))
        data = (self.integer(16) - 1) * BLOCK
        end = self.start + self.content[self.start + 2] * BLOCK
        self.parameters(min(end, data) if data > self.start else end)
        if not 0 < points <= MOST_POINTS:
            raise FileError(self.name, None, f"the file holds {points} points; it needs those of a clubhead")
        if self.found.get("POINT:USED", points) != points:
            raise self.damaged(f"the header says {points} points, POINT:USED {self.found['POINT:USED']}")
        if data < self.start or last < first:
            raise self.damaged("the header says where data begin and end, and they end first")
        # Letters beyond 65535 frames do not fit the header; POINT:FRAMES has the same limit. The smaller is sure.
        frames = last - first + 1
        frames = min(frames, self.found.get("POINT:FRAMES") or frames)
        word = 4 if self.content[self.sign] & 0x80 else 2  # a negative scale marks floating point
        needed = data + frames * word * (4 * points + analogues)
        if len(self.content) < needed:
            raise FileError(
                self.name,
                None,
                f"the file is cut short: {len(self.content)} bytes of at least {needed} for {frames} frames",
            )
        return Layout(points, analogues, frames, first)

    def parameters(self, end: int) -> None:
        """Walk through groups and parameters; refuse what points outside the section."""
        at, groups = self.start + 4, {}
        named: list[_Parameter] = []
        while at < end:
            length, group = struct.unpack_from("bb", self.content, at)
            length = abs(length)
            if length == 0:
                break
            label = self.content[at + 2 : at + 2 + length].decode("latin-1").upper()
            at += 2 + length
            step = struct.unpack_from(f"{self.order}h", self.content, at)[0]
            if group == 0 or not label.isprintable():
                raise self.damaged(f"a parameter without a name or group at byte {at}")
            if group < 0:
                groups[-group] = label
                used = 3 + self.content[at + 2]
            else:
                named.append(found := self.parameter(at + 2, group, label))
                used = found.end - at
            if step != 0 and (step < used or at + step > end):
                raise self.damaged(f"{label} is said to end at byte {at + step}, outside its section")
            if step == 0:
                break
            at += step
        for each in named:
            if each.group not in groups:
                raise self.damaged(f"{each.label} belongs to group {each.group}, which does not exist")
            self.check(groups[each.group], each)
            self.found[f"{groups[each.group]}:{each.label}"] = each.value

    def check(self, group: str, each: _Parameter) -> None:
        """Refuse a parameter of another kind than libraries take for granted."""
        if group not in NUMBERS:
            return
        if each.label in NUMBERS[group] and (each.kind == TEXT or not each.elements):
            raise self.damaged(f"{group}:{each.label} is not a number")
        if each.kind == TEXT and not each.dimensions:
            raise self.damaged(f"{group}:{each.label} is text without a length")

    def parameter(self, at: int, group: int, label: str) -> _Parameter:
        """Return a parameter that begins with its type."""
        kind, count = struct.unpack_from("bB", self.content, at)
        if kind not in SIZES or count > 7:
            raise self.damaged(f"{label} has type {kind} and {count} dimensions")
        elements = 1
        for each in self.content[at + 2 : at + 2 + count]:
            elements *= each
        at += 2 + count
        size = elements * SIZES[kind]
        described = self.content[at + size]
        value = self.integer(at) if kind == 2 and elements else 0
        return _Parameter(group, label, kind, count, elements, value, at + size + 1 + described)
