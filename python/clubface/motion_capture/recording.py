"""Marker positions over time: read from and written to C3D files by ezc3d."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from clubface import units
from clubface.errors import FileError, InputError, Told, UnknownNameError
from clubface.motion_capture.c3d_layout import check_layout
from clubface.motion_capture.rigid_body import visible
from clubface.motion_capture.rotations import Array
from clubface.support.input_files import as_local_file, input_file
from clubface.support.isolated import IsolatedError, IsolatedProcess
from clubface.support.whole_file import whole_file
from clubface.units import numbers

LIBRARY = IsolatedProcess(Path(__file__).with_name("c3d_library.py"))
MEMORY = 200
"""Bytes that the library may take for a byte of the file; it takes some 30."""
SPEED = 1e6
"""Bytes a second, slower than any machine reads them."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Recording:
    """The markers of one trial.

    Attributes
    ----------
    labels
        Names of the markers.
    positions
        Positions [m] in the axes of the laboratory, shape (frames, markers, 3); NaN, or masked when they are given,
        where a marker was not seen.
    rate
        Frames a second [Hz].
    first_frame
        Number of the first frame, as the file counts.
    path
        The file, or another name of the source.
    """

    labels: tuple[str, ...]
    positions: Array
    rate: float
    first_frame: int = 1
    path: str = "<recording>"

    def __post_init__(self) -> None:
        positions = numbers(self.positions, name="positions")
        if positions.ndim != 3 or positions.shape[1:] != (len(self.labels), 3):
            told = Told(f"an array of shape {positions.shape}")
            raise InputError("positions", told, f"one of shape (frames, {len(self.labels)} markers, 3)")
        object.__setattr__(self, "positions", positions)

    @property
    def times(self) -> Array:
        """Times of the frames [s], counted from the first one."""
        return np.arange(len(self.positions)) / self.rate

    def marker(self, label: str) -> Array:
        """Return the positions of one marker [m], shape (frames, 3)."""
        return self.markers((label,))[:, 0]

    def markers(self, labels: Iterable[str]) -> Array:
        """Return the positions of several markers [m], shape (frames, markers, 3).

        A name is found as it stands in the file, or after the name of its subject: ``HEAD1`` in ``club:HEAD1``.

        Raises
        ------
        FileError
            Some names are not in the file; the message lists those that are.
        """
        wanted = tuple(labels)
        places = [self.place(label) for label in wanted]
        missing = [label for label, place in zip(wanted, places, strict=True) if place is None]
        if missing:
            plural = "markers" if len(missing) > 1 else "marker"
            present = ", ".join(self.labels) or "none"
            raise FileError(self.path, None, f"no {plural} {', '.join(missing)} here; the file has: {present}")
        return self.positions[:, [place for place in places if place is not None]]

    def place(self, label: str) -> int | None:
        """Return which of the markers has a name, as for :meth:`markers`; None if there is none."""
        if label in self.labels:
            return self.labels.index(label)
        ends = [place for place, each in enumerate(self.labels) if each.rpartition(":")[2] == label]
        if len(ends) > 1:
            shared = ", ".join(self.labels[place] for place in ends)
            raise FileError(self.path, None, f"marker {label} may be any of {shared}; write its full name")
        return ends[0] if ends else None


def read_c3d(path: str | os.PathLike[str], *, unit: str | None = None) -> Recording:
    """Read the markers of a C3D file.

    A point that is marked invalid, is not finite, or lies exactly at the origin was not seen, and becomes NaN.

    Parameters
    ----------
    path
        The file.
    unit
        Unit of length, instead of the one the file names; needed if the file names none.

    Raises
    ------
    FileError
        The file is missing, empty, cut short, damaged or without points, or its unit of length is unknown.
    """
    name = os.fspath(path)
    layout = check_layout(name)
    size = input_file(name).size
    with as_local_file(name) as local:
        try:  # a crash of the library is an error of the file
            found = LIBRARY.call("contents", local, memory=MEMORY * size, seconds=size / SPEED)
        except IsolatedError as error:
            reason = str(error).replace(local, name).rstrip(".")
            raise FileError(name, None, f"this C3D file cannot be read: {reason}") from None
    points, rate, texts = found["points"], found["rate"], found["texts"]
    if points.ndim != 3 or not points.shape[1] or not points.shape[2]:
        raise FileError(name, None, "the file holds no points")
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
    """Write the markers of a recording as a C3D file, in mm; markers that were not seen become invalid points."""
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
        # The library does not tell of a full disk: the ninth word of the file says in which block the points begin.
        begin = 512 * (int.from_bytes(out.read(18)[16:], "little") - 1)
        if os.path.getsize(out.name) < begin + points.astype(np.float32).nbytes:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    return target


def _metres(name: str, given: Sequence[str], unit: str | None) -> float:
    """Return the length [m] of the unit of a file."""
    if unit is not None:
        return units.size(units.unit(unit, name="units", dimension="length").symbol)
    symbol = given[0] if given else ""
    if not symbol:
        raise FileError(name, None, "the file does not name its unit of length; give it, as in --units mm")
    try:
        found = units.unit(symbol, dimension="length")
    except (InputError, UnknownNameError):
        allowed = ", ".join(units.symbols("length"))
        raise FileError(
            name, None, f"the unit of length {symbol!r} is unknown; give the right one with --units: {allowed}"
        ) from None
    return units.size(found.symbol)
