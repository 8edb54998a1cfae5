"""Recordings: marker positions over time, read from and written to C3D files with ezc3d.

The layout of a file is checked before the library reads it, because the library would read a truncated file as a
shorter recording, and a damaged one could crash the process. The layout is that of "The C3D File Format User Guide"
(Motion Lab Systems): a header of 512 bytes, a section of parameter groups, and frames of points and analogue samples.

The capture program may have filled gaps, frames in which a marker was not seen, with a straight line, with the last
position, or with a spline. A noisy marker never lies on a polynomial to the last digit of a file, but an interpolated
one does: its second, fourth or sixth differences vanish inside the gap, and clearly do not at its ends. Such frames
contain no information on the club: a line across a gap looks like an impact, and a spline across impact hides it.
"""

from __future__ import annotations

import errno
import os
import struct
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.capture.rotations import Array, visible
from clubface.errors import FileError, InputError, UnknownNameError, Wording
from clubface.results.notes import Note, note
from clubface.results.result import Described, Result
from clubface.results.table import Table, column, text
from clubface.support.files import as_local_file, input_file, read_input, whole_file
from clubface.support.processes import IsolatedError, IsolatedProcess
from clubface.units import numbers

BLOCK = 512
MAGIC = 0x50
PROCESSORS = {84: ("<", 15), 85: ("<", 13), 86: (">", 12)}
"""Byte order, and the header byte that holds the sign of the scale, for Intel, DEC and MIPS."""
SIZES = {-1: 1, 1: 1, 2: 2, 4: 4}
"""Bytes per element by parameter type: character, byte, integer, float."""
TEXT = -1
"""Type of text parameters."""
NUMBERS = {
    "POINT": ("USED", "SCALE", "RATE", "DATA_START", "FRAMES"),
    "ANALOG": ("USED", "GEN_SCALE", "RATE"),
    "ROTATION": ("USED", "DATA_START", "RATE", "RATIO"),
    "FORCE_PLATFORM": ("USED",),
}
"""Parameters that must hold numbers if they exist; libraries rely on this."""
MOST_POINTS = 10_000
NOT_C3D = "this is not a C3D file"
DAMAGED = "this C3D file is damaged"


LAST_DIGIT = 6e-8
"""Relative rounding error of single precision, as used in files."""
SHARP = 30.0
"""Minimum ratio of the differences on both sides of a filled gap to those that vanish inside."""
AROUND = 3
"""Number of differences examined on each side, per order: enough for a kink, as at impact, to affect fewer than half of
them in a noise-free motion."""
ORDERS = (2, 4, 6)
"""Orders of the differences that vanish for lines, cubics and quintics."""
FEWEST = 2
"""Minimum number of consecutive vanishing differences; with 0.01 mm of noise, one in 10,000 does by chance."""
SLOW = 0.5
"""Speed below which a marker on a line may simply be at rest [m/s]."""
WHOLE = 30.0
"""Changes of a coordinate up to this multiple of the smallest change are tested for being whole multiples of it."""
JUMP, FAST = 0.01, 3.0
"""Minimum jump [m] and speed [m/s] after a gap that was filled with the last position."""


class RecordingHeader(NamedTuple):
    """Contents of the header: points and analogue samples per frame, frames, and number of the first frame."""

    points: int
    analogues: int
    frames: int
    first_frame: int


def check_layout(path: str | os.PathLike[str]) -> RecordingHeader:
    """Return the header of a C3D file; raise FileError if the file is empty, truncated or damaged."""
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
    """A parameter of a C3D file."""

    group: int  # number of its group
    label: str
    kind: int  # a key of ``SIZES``
    dimensions: int  # number of them
    elements: int  # number of them
    value: int  # first value of an integer parameter, otherwise 0
    end: int  # offset of its end


class _Reader:
    """Decodes the layout of a C3D file."""

    def __init__(self, content: bytes, name: str) -> None:
        self.content, self.name = content, name
        self.start = (content[0] - 1) * BLOCK
        processor = content[self.start + 3]
        if processor not in PROCESSORS:
            raise self.damaged(f"processor type {processor}, not 84, 85 or 86")
        self.order, self.sign = PROCESSORS[processor]
        self.outcome: dict[str, int] = {}

    def damaged(self, what: str) -> FileError:
        return FileError(self.name, None, f"{DAMAGED}: {what}")

    def integer(self, at: int) -> int:
        return struct.unpack_from(f"{self.order}H", self.content, at)[0]

    def layout(self) -> RecordingHeader:
        points, analogues, first, last = (self.integer(at) for at in (2, 4, 6, 8))
        data = (self.integer(16) - 1) * BLOCK
        end = self.start + self.content[self.start + 2] * BLOCK
        self.parameters(min(end, data) if data > self.start else end)
        if not 0 < points <= MOST_POINTS:
            raise FileError(self.name, None, f"the file contains {points} points; it must contain those of a clubhead")
        if self.outcome.get("POINT:USED", points) != points:
            raise self.damaged(f"the header has {points} points, POINT:USED {self.outcome['POINT:USED']}")
        if data < self.start or last < first:
            raise self.damaged("in the header, the data end before they begin")
        # The header overflows beyond 65535 frames, as does POINT:FRAMES; the smaller number is safe.
        frames = last - first + 1
        frames = min(frames, self.outcome.get("POINT:FRAMES") or frames)
        word = 4 if self.content[self.sign] & 0x80 else 2  # a negative scale marks floating point
        needed = data + frames * word * (4 * points + analogues)
        if len(self.content) < needed:
            short = f"{len(self.content)} bytes of at least {needed} for {frames} frames"
            raise FileError(self.name, None, f"the file is cut short: {short}")
        return RecordingHeader(points, analogues, frames, first)

    def parameters(self, end: int) -> None:
        """Decode groups and parameters; raise FileError for offsets outside the section."""
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
                named.append(outcome := self.parameter(at + 2, group, label))
                used = outcome.end - at
            if step != 0 and (step < used or at + step > end):
                raise self.damaged(f"{label} is declared to end at byte {at + step}, outside its section")
            if step == 0:
                break
            at += step
        for each in named:
            if each.group not in groups:
                raise self.damaged(f"{each.label} belongs to group {each.group}, which does not exist")
            self.check(groups[each.group], each)
            self.outcome[f"{groups[each.group]}:{each.label}"] = each.value

    def check(self, group: str, each: _Parameter) -> None:
        """Raise FileError if a parameter has a different type from what libraries rely on."""
        if group not in NUMBERS:
            return
        if each.label in NUMBERS[group] and (each.kind == TEXT or not each.elements):
            raise self.damaged(f"{group}:{each.label} is not a number")
        if each.kind == TEXT and not each.dimensions:
            raise self.damaged(f"{group}:{each.label} is text without a length")

    def parameter(self, at: int, group: int, label: str) -> _Parameter:
        """Decode a parameter from its type on."""
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


LIBRARY = IsolatedProcess(Path(__file__).with_name("c3d_library.py"))
MEMORY = 200
"""Memory limit for the library in bytes per byte of the file; it needs about 30."""
SPEED = 1e6
"""Assumed reading speed for the time limit [bytes/s], slower than any machine."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Recording(Described):
    """Markers of one trial.

    Attributes
    ----------
    labels
        Names of the markers.
    positions
        Positions [m] in laboratory axes, shape (frames, markers, 3); NaN (or masked in the argument) where a marker was
        not seen.
    rate
        Frames per second [Hz].
    first_frame
        Number of the first frame in the file.
    path
        File name or another name of the source.
    """

    labels: tuple[str, ...]
    positions: Array
    rate: float
    first_frame: int = 1
    path: str = "<recording>"

    def __post_init__(self) -> None:
        positions = numbers(self.positions, name="positions")
        if positions.ndim != 3 or positions.shape[1:] != (len(self.labels), 3):
            words = Wording(f"an array of shape {positions.shape}")
            raise InputError("positions", words, f"one of shape (frames, {len(self.labels)} markers, 3)")
        object.__setattr__(self, "positions", positions)

    def error(self, message: str) -> FileError:
        """Return an error of the file."""
        return FileError(self.path, None, message)

    @property
    def times(self) -> Array:
        """Times of the frames from the first one [s]."""
        return np.arange(len(self.positions)) / self.rate

    def to_result(self) -> Result:
        """Return a table of the markers: number of frames seen, first position, and greatest speed."""
        known = visible(self.positions)
        speeds = np.linalg.norm(np.diff(self.positions, axis=0), axis=-1) * self.rate
        fastest = np.where(np.isfinite(speeds), speeds, -1.0).max(0, initial=-1.0)
        first = np.where(known.any(0), known.argmax(0), 0)
        places = self.positions[first, np.arange(len(self.labels))]
        markers = Table(
            "markers",
            (
                text("marker", self.labels), text("frames", known.sum(0), label="frames seen"),
                *(column(f"first_{name}", place, "m", unit="mm", digits=1, label=f"first {name}")
                  for name, place in zip("xyz", places.T, strict=True)),
                column("fastest_speed", np.where(fastest < 0.0, np.nan, fastest), "m/s", unit="m/s", label="fastest"),
            ),
        )  # fmt: skip
        title = f"{self.path}: {len(self.positions)} frames at {self.rate:g} Hz"
        counts = text("rate_hz", [self.rate], printed=False), text("frames", [len(self.positions)], printed=False)
        return Result("markers", title, (markers,), counts)

    def marker(self, label: str) -> Array:
        """Return the positions of one marker [m], shape (frames, 3)."""
        return self.markers((label,))[:, 0]

    def markers(self, labels: Iterable[str]) -> Array:
        """Return the positions of several markers [m], shape (frames, markers, 3).

        A name matches as written in the file, or without its subject: ``HEAD1`` matches ``club:HEAD1``. Raises
        FileError, which lists the names in the file, if some are not among them.
        """
        wanted = tuple(labels)
        places = [self.place(label) for label in wanted]
        missing = [label for label, place in zip(wanted, places, strict=True) if place is None]
        if missing:
            plural = "markers" if len(missing) > 1 else "marker"
            present = ", ".join(self.labels) or "none"
            raise self.error(f"the file has no {plural} {', '.join(missing)}; it has: {present}")
        return self.positions[:, [place for place in places if place is not None]]

    def place(self, label: str) -> int | None:
        """Return the index of a marker by name, as for :meth:`markers`; None if there is none."""
        if label in self.labels:
            return self.labels.index(label)
        ends = [place for place, each in enumerate(self.labels) if each.rpartition(":")[2] == label]
        if len(ends) > 1:
            shared = ", ".join(self.labels[place] for place in ends)
            raise self.error(f"marker {label} may be any of {shared}; write its full name")
        return ends[0] if ends else None


def read_c3d(path: str | os.PathLike[str], *, unit: str | None = None) -> Recording:
    """Read the markers of a C3D file.

    A point that is marked invalid, is not finite, or lies exactly at the origin counts as not seen, and becomes NaN.

    Parameters
    ----------
    path
        The file.
    unit
        Unit of length, overriding that of the file; needed if the file names none.

    Raises
    ------
    FileError
        The file is missing, empty, truncated, damaged or without points, or its unit of length is unknown.
    """
    name = os.fspath(path)
    layout = check_layout(name)
    size = input_file(name).size
    with as_local_file(name) as local:
        try:  # a crash of the library is an error of the file
            outcome = LIBRARY.call("contents", local, memory=MEMORY * size, seconds=size / SPEED)
        except IsolatedError as error:
            reason = str(error).replace(local, name).rstrip(".")
            raise FileError(name, None, f"this C3D file cannot be read: {reason}") from None
    points, rate, texts = outcome["points"], outcome["rate"], outcome["texts"]
    if points.ndim != 3 or not points.shape[1] or not points.shape[2]:
        raise FileError(name, None, "the file contains no points")
    if points.shape[2] < layout.frames:
        raise FileError(name, None, f"the file is cut short: {points.shape[2]} of {layout.frames} frames")
    if not (np.isfinite(rate) and rate > 0.0):
        raise FileError(name, None, f"the frame rate is {rate:g} Hz")
    positions = np.moveaxis(points[:3], 0, -1).swapaxes(0, 1) * _metres(name, texts["UNITS"], unit)
    unseen = ~visible(positions) | np.all(positions == 0.0, axis=-1)
    labels = texts["LABELS"] + texts["LABELS2"] + texts["LABELS3"]
    labels += [f"*{place + 1}" for place in range(len(labels), points.shape[1])]
    return Recording(
        labels=tuple(labels[: points.shape[1]]),
        positions=np.where(unseen[..., None], np.nan, positions),
        rate=rate,
        first_frame=layout.first_frame,
        path=name,
    )


def write_c3d(recording: Recording, path: str | os.PathLike[str]) -> Path:
    """Write the markers of a recording as a C3D file in mm; markers that were not seen become invalid points."""
    import ezc3d

    target = Path(path)
    file = ezc3d.c3d()
    point: Any = file["parameters"]["POINT"]
    point["RATE"]["value"] = [recording.rate]
    point["LABELS"]["value"] = recording.labels
    point["UNITS"]["value"] = ("mm",)
    points = np.ones((4, len(recording.labels), len(recording.positions)))
    points[:3] = np.moveaxis(units.from_si(recording.positions, "mm"), -1, 0).swapaxes(1, 2)
    file["data"]["points"] = points
    with whole_file(target) as out:
        try:
            file.write(out.name)
        except RuntimeError as error:
            raise FileError(os.fspath(target), None, f"cannot be written: {error}") from None
        # The library does not report a full disk, so check the size; the header's ninth word is the points' block.
        begin = 512 * (int.from_bytes(out.read(18)[16:], "little") - 1)
        if os.path.getsize(out.name) < begin + points.astype(np.float32).nbytes:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    return target


def _metres(name: str, given: Sequence[str], unit: str | None) -> float:
    """Return the length of a file's unit [m]."""
    if unit is not None:
        return units.size(units.unit(unit, name="units", dimension="length").symbol)
    symbol = given[0] if given else ""
    if not symbol:
        raise FileError(name, None, "the file does not name its unit of length; give it, as in --units mm")
    try:
        outcome = units.unit(symbol, dimension="length")
    except (InputError, UnknownNameError):
        allowed = ", ".join(units.symbols("length"))
        raise FileError(
            name, None, f"the unit of length {symbol!r} is unknown; give the right one with --units: {allowed}"
        ) from None
    return units.size(outcome.symbol)


def without_filled(recording: Recording, names: Iterable[str]) -> tuple[Recording, list[Note]]:
    """Remove interpolated positions of some markers from a recording; return it with notes on what was removed."""
    seen, names = recording.markers(names), tuple(names)
    calculated = filled(seen, recording.rate)
    if not calculated.any():
        return recording, []
    positions = recording.positions.copy()
    gaps: dict[tuple[int, ...], list[str]] = {}
    for name, each in zip(names, calculated.T, strict=True):
        if each.any():
            positions[each, recording.place(name)] = np.nan
            frames = tuple((np.flatnonzero(each) + recording.first_frame).tolist())
            gaps.setdefault(frames, []).append(name)
    notes = [note("capture-filled", markers=each, frames=list(frames)) for frames, each in gaps.items()]
    return replace(recording, positions=positions), notes


def filled(positions: Array, rate: float) -> NDArray[np.bool_]:
    """Return in which frames each marker was interpolated rather than seen, shape (frames, markers).

    ``positions`` [m] has shape (frames, markers, 3), NaN where not seen, at ``rate`` [Hz].
    """
    return np.stack([_interpolated_frames(each, rate) for each in np.swapaxes(positions, 0, 1)], 1)


def _interpolated_frames(path: Array, rate: float) -> NDArray[np.bool_]:
    """Return in which frames one marker was interpolated; ``path`` has shape (frames, 3)."""
    out = np.zeros(len(path), dtype=bool)
    if not np.isfinite(path).any():
        return out
    steps = np.abs(np.diff(path, axis=0)).max(-1)  # NaN next to a gap, like all differences
    digit = LAST_DIGIT * float(np.nanmax(np.abs(path)))
    coarse = max(digit, _rounding_unit(path, digit))
    for order in ORDERS:
        size = np.abs(np.diff(path, order, axis=0)).max(-1)
        limit = 2.0**order * digit
        for first, last in runs(size < limit):
            points, pieces = last + order - first, slice(max(first - 1, 0), last + order + 1)
            if last - first + 1 < FEWEST:
                continue
            if order == 2 and not steps[first : first + points].any():
                if np.nanmax(steps[pieces]) > max(JUMP, FAST / rate):
                    out[first : first + points + 1] = True
                continue
            sides = [size[max(first - AROUND * order, 0) : first], size[last + 1 : last + 1 + AROUND * order]]
            seen = [float(np.median(side[np.isfinite(side)])) for side in sides if np.isfinite(side).any()]
            # A straight line may end the recording; other noise-free motions are as smooth as a spline.
            enough = len(seen) == 2 or (order == 2 and len(seen) == 1)
            moves = np.linalg.norm(path[first + points] - path[first]) * rate > SLOW * points
            if enough and min(seen) > SHARP * max(limit, coarse) and moves:
                # Both ends of a gap were seen, unless it begins or ends the recording.
                begins, ends = first == 0, first + points == len(path) - 1
                out[first + (not begins) : first + points + ends] = True
    return out


def _rounding_unit(path: Array, digit: float) -> float:
    """Return the unit of which all coordinates are multiples [m], as in rounded files; 0 if there is none."""
    changes = np.abs(np.diff(path, axis=0)).ravel()
    changes = changes[changes > 4.0 * digit]
    if not len(changes):
        return 0.0
    parts = changes / changes.min()
    near = parts[parts < WHOLE]
    return float(changes.min()) if np.mean(np.abs(near - np.round(near)) < 0.1) > 0.9 and len(near) > 10 else 0.0


def runs(where: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the first and last index of each run of true values."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], where, [False]]).astype(np.int8)))
    return [(int(first), int(last) - 1) for first, last in edges.reshape(-1, 2)]
