"""The markers of a laboratory, and the mapping files that say which is what.

The markers of a laboratory, checked.

Mapping files: the mapping of markers as a small TOML file, with strict checks.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple, Self

from clubface import units
from clubface.capture.geometry import DIMENSIONS, GIVEN, GUESSED, Assumed
from clubface.capture.rotations import FEWEST
from clubface.errors import ClubfaceError, InputError, Told
from clubface.support.checks import check_choice
from clubface.support.strict_toml import Document, quoted

WAYS = ("positions", "face", "address", "swing")
AXES = ("+x", "-x", "+y", "-y", "+z", "-z")
Point = tuple[float, float, float]


class FacePoint(NamedTuple):
    """A calibration point on the clubface.

    Attributes
    ----------
    toe, high
        Its distances from the face centre [m] towards the toe and upwards, in the plane that touches the face there.
    standoff
        How far the centre of its marker stands in front of the face [m].
    """

    toe: float
    high: float
    standoff: float


@dataclass(frozen=True, kw_only=True)
class Markers:
    """What the markers of a laboratory are.

    Attributes
    ----------
    cluster
        The markers on the clubhead by name. The value is the position of the marker from the face centre [m], in club
        axes at the static loft (x towards the target, y up, z towards the toe), or None if a calibration gives it.
    by
        What places the cluster on the club: its given "positions"; points of the "face" that are seen with it; the
        "address", in which the head rests on the ground with a square face; or the "swing", whose blow shows where the
        face looks. None is "positions" if they are given, and else "face".
    face
        Calibration points on the face, by marker; empty if the positions of the cluster are given.
    calibration
        The C3D file that shows the points of the face, or the address. None means the swing itself.
    frames
        First and last frame of the address, as the file counts. None: the last time that the head rests near the
        ground.
    ground
        Height of the ground along the axis that points up [m], in laboratory axes. None: not known, and the sole says
        nothing about where the markers sit.
    accuracy
        Standard deviation along each axis [m] of a given position, of a cluster marker or a face point. None: not told;
        1 mm is taken.
    assumed
        Standard deviations of what is assumed.
    ball
        The marker whose centre is that of the ball, or None. Without marker and position the ball is looked for where
        the head loses speed.
    ball_offset
        From that marker to the centre of the ball [m], in world axes (x towards the target, y up, z to the right).
    ball_position
        Position of the ball [m] in the axes of the laboratory, instead of a marker.
    ball_accuracy
        Standard deviation of that position along each axis [m]. None: not told; that of the other positions if it is
        told, else 10 mm.
    target
        Axis of the laboratory that points to the target, such as "+y"; or two markers, where the second lies in the
        direction of the target from the first.
    up
        Axis of the laboratory that points up.
    unit
        Unit of length of the files, where they name none or a wrong one.
    noise
        Standard deviation of a marker along each axis [m]; None to estimate it from the residuals.
    club
        Name of the club for which the mapping was made, or None.
    path
        The file, or another name of the source.
    """

    cluster: Mapping[str, Point | None]
    face: Mapping[str, FacePoint] = field(default_factory=dict)
    by: str | None = None
    calibration: str | None = None
    frames: tuple[int, int] | None = None
    ground: float | None = None
    accuracy: float | None = None
    assumed: Assumed = field(default_factory=Assumed)
    ball: str | None = None
    ball_offset: Point = (0.0, 0.0, 0.0)
    ball_position: Point | None = None
    ball_accuracy: float | None = None
    target: str | tuple[str, str] = "+x"
    up: str = "+z"
    unit: str | None = None
    noise: float | None = None
    club: str | None = None
    path: str = "<mapping>"

    def __post_init__(self) -> None:
        if len(self.cluster) < FEWEST:
            raise InputError("cluster", f"{len(self.cluster)} markers", f"at least {FEWEST} markers, not on a line")
        placed = [name for name, position in self.cluster.items() if position is not None]
        check_choice("by", self.way, WAYS)
        self._check_way(self.way, placed)
        if self.face and len(self.face) < FEWEST:
            raise InputError("face", f"{len(self.face)} points", f"at least {FEWEST} points, not on a line")
        if self.ball is not None and self.ball_position is not None:
            raise InputError("ball", Told("given twice"), "keep either its marker or its position")
        if self.frames is not None and not 0 <= self.frames[0] < self.frames[1]:
            raise InputError(
                "frames", list(self.frames), "the first and the last frame of the address, such as [1, 90]"
            )
        _check_axes(self.target, self.up)

    def _check_way(self, way: str, placed: list[str]) -> None:
        """Refuse a mapping that lacks what its way of calibration needs, or gives what that does not use."""
        if way == "positions" and len(placed) < len(self.cluster):
            without = ", ".join(name for name in self.cluster if name not in placed)
            raise InputError(
                "cluster", Told(f"without the position of {without}"), "give the positions of all markers, or of none"
            )
        if way == "face" and not self.face:
            raise InputError(
                "cluster",
                Told("not placed on the club"),
                "give one of these: positions of its markers under [cluster]; points of the face under [face]; or,"
                ' under [calibration], by = "address" (the head at rest behind the ball) or by'
                ' = "swing" (nothing else needed)',
            )
        if way == "face" and placed:
            raise InputError(
                "cluster",
                Told("placed twice, by its positions and by [face]"),
                'keep one, or write "seen" for positions',
            )
        if way != "face" and self.face:
            raise InputError("by", way, 'leave out the table [face], or give by = "face"')
        for name, ways in (("calibration", ("face", "address")), ("frames", ("address",)), ("ground", ("address",))):
            if getattr(self, name) is not None and way not in ways:
                shown = "file" if name == "calibration" else name
                meant = " or ".join(f'by = "{each}"' for each in ways)
                raise InputError(
                    shown, getattr(self, name), f'leave it out, or give {meant}: by = "{way}" does not use it'
                )

    @property
    def way(self) -> str:
        """What places the cluster on the club: one of ``WAYS``."""
        if self.by is not None:
            return self.by
        return "positions" if any(place is not None for place in self.cluster.values()) and not self.face else "face"

    @property
    def position_deviation(self) -> float:
        """Standard deviation of a given position along each axis [m]."""
        return GIVEN if self.accuracy is None else self.accuracy

    @property
    def ball_deviation(self) -> float:
        """Standard deviation of the given position of the ball along each axis [m]."""
        return next((each for each in (self.ball_accuracy, self.accuracy) if each is not None), GUESSED)

    @property
    def calibration_path(self) -> Path | None:
        """The calibration file, found from the folder of the mapping file."""
        return None if self.calibration is None else Path(self.path).parent / self.calibration


def _check_axes(target: str | tuple[str, str], up: str) -> None:
    allowed = f"one of {', '.join(AXES)}"
    if up not in AXES:
        raise InputError("up", up, allowed)
    if isinstance(target, str):
        if target not in AXES:
            raise InputError("target", target, f"{allowed}, or a list of two markers")
        if target[1] == up[1]:
            raise InputError("target", target, f"across the axis that points up, {up}")


TABLES = {
    "cluster": None,
    "face": None,
    "calibration": ("by", "file", "frames", "ground", "accuracy"),
    "assumed": tuple(DIMENSIONS),
    "ball": ("marker", "offset", "position", "accuracy"),
    "laboratory": ("target", "up", "unit"),
    "noise": ("marker",),
}
"""The keys of each table; None: the names of markers."""
SEEN = "seen"
"""Stands for the position of a marker that the calibration places."""


class MarkerMap(Markers):
    """The markers of a laboratory; its attributes are those of :class:`Markers`."""

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Self:
        """Read a mapping file; ``template`` shows its form. Every error names file and line."""
        return cls._from(Document.read(path))

    @classmethod
    def from_text(cls, text: str, path: str = "<mapping>") -> Self:
        """Read the text of a mapping file; ``path`` names it in errors."""
        return cls._from(Document(text, path))

    @classmethod
    def _from(cls, document: Document) -> Self:
        given = _given(document)
        try:
            return cls(**given)
        except ClubfaceError as error:
            name = getattr(error, "parameter", "")
            raise document.wrap(error, "laboratory" if name in ("target", "up") else "") from None

    def to_toml(self) -> str:
        """Return the text of a mapping file that reads back as this mapping, lengths to 1 nm."""
        return _to_toml(self)


def marker_map(which: str | os.PathLike[str] | MarkerMap) -> MarkerMap:
    """Return the mapping that is given as the path of its file, or as a :class:`MarkerMap` itself."""
    return which if isinstance(which, MarkerMap) else MarkerMap.read(which)


def _given(document: Document) -> dict[str, Any]:
    """Return the values that a TOML document gives."""
    data = document.data
    document.check_keys(data, [*TABLES, "club"], ["cluster"])
    document.check_text(data, ["club"])
    for table, known in TABLES.items():
        if not isinstance(data.get(table, {}), dict):
            raise document.error(f"{table} must be a table: [{table}]", table)
        if known is not None:
            document.check_keys(data.get(table, {}), known, (), table)
    part = {table: dict(data.get(table, {})) for table in TABLES}
    read = _Reader(document)
    given: dict[str, Any] = {
        "cluster": {name: read.position(value, name, "cluster") for name, value in part["cluster"].items()},
        "face": {name: read.face_point(value, name) for name, value in part["face"].items()},
        "club": data.get("club"),
        "path": document.path,
    }
    document.check_text(part["calibration"], ["by", "file"], "calibration")
    document.check_text(part["laboratory"], ["up", "unit"], "laboratory")
    document.check_text(part["ball"], ["marker"], "ball")
    calibration, ball, laboratory, noise = (part[name] for name in ("calibration", "ball", "laboratory", "noise"))
    given["by"], given["calibration"], given["ball"] = (
        calibration.get("by"),
        calibration.get("file"),
        ball.get("marker"),
    )
    if "ball" in data and "marker" not in ball and "position" not in ball:
        raise document.error(
            "[ball] names neither a marker nor a position; give one, or leave the whole table out: then the ball is"
            " where the clubhead loses speed", "", "ball",
        )  # fmt: skip
    if "frames" in calibration:
        given["frames"] = read.frames(calibration["frames"])
    if "ground" in calibration:
        given["ground"] = read.length(calibration["ground"], "ground", "calibration")
    if part["assumed"]:
        given["assumed"] = read.assumed(part["assumed"])
    if "accuracy" in ball:
        given["ball_accuracy"] = read.length(ball["accuracy"], "accuracy", "ball", above=-1e-300)
    if "accuracy" in calibration:
        given["accuracy"] = read.length(calibration["accuracy"], "accuracy", "calibration", above=-1e-300)
    if "offset" in ball:
        given["ball_offset"] = read.vector(ball["offset"], "offset", "ball")
    if "position" in ball:
        given["ball_position"] = read.vector(ball["position"], "position", "ball")
    if "marker" in noise:
        given["noise"] = read.length(noise["marker"], "marker", "noise", above=0.0)
    given.update({key: laboratory[key] for key in ("up", "unit") if key in laboratory})
    if "unit" in laboratory:
        read.unit(laboratory["unit"])
    if "target" in laboratory:
        given["target"] = read.target(laboratory["target"])
    return given


class _Reader:
    """Turns values of the document into SI, with errors that carry its lines."""

    def __init__(self, document: Document) -> None:
        self.document = document

    def length(self, value: Any, key: str, table: str, *, above: float | None = None) -> float:
        try:
            found = units.parse(value, "length", name=key)
            if above is not None and found <= above:
                raise InputError(key, value, f"above {max(above, 0.0):g} m" if above >= 0.0 else "0 m or more")
        except InputError as error:
            raise self.document.error(str(error), key, table) from None
        return found

    def vector(self, value: Any, key: str, table: str) -> Point:
        if not isinstance(value, list) or len(value) != 3:
            raise self.document.error(f"{key} must be three lengths in a list, not {value!r:.60}", key, table)
        x, y, z = (self.length(each, key, table) for each in value)
        return x, y, z

    def position(self, value: Any, key: str, table: str) -> Point | None:
        """Read the position of a marker, ``"seen"`` for one that the calibration places."""
        if isinstance(value, dict):
            rest = next(iter(value), "")
            message = f"a name with a point needs quotes: {quoted(f'{key}.{rest}')} = ..."
            raise self.document.error(message, rest, f"{table}.{key}")
        return None if value == SEEN else self.vector(value, key, table)

    def face_point(self, value: Any, key: str) -> FacePoint:
        if not isinstance(value, dict):
            raise self.document.error(f'{key} must be a table as in {{ toe = "30 mm", high = "0 mm" }}', key, "face")
        for name in value:
            if name not in FacePoint._fields:
                raise self.document.error(f"{key} has {name}; it takes {', '.join(FacePoint._fields)}", key, "face")
        missing = [name for name in ("toe", "high") if name not in value]
        if missing:
            raise self.document.error(f"{key} lacks {' and '.join(missing)}", key, "face")
        lengths = (self.length(value.get(name, 0.0), key, "face") for name in FacePoint._fields)
        return FacePoint(*lengths)

    def frames(self, value: Any) -> tuple[int, int]:
        if isinstance(value, list) and len(value) == 2 and all(type(each) is int for each in value):
            return value[0], value[1]
        raise self.document.error("frames must be the first and the last, as in [1, 90]", "frames", "calibration")

    def assumed(self, values: dict[str, Any]) -> Assumed:
        found = {}
        for key, value in values.items():
            try:
                found[key] = units.parse(value, DIMENSIONS[key], name=key)
                if not found[key] > 0.0:
                    raise InputError(key, value, "above 0")
            except InputError as error:
                raise self.document.error(str(error), key, "assumed") from None
        return Assumed(**found)

    def target(self, value: Any) -> str | tuple[str, str]:
        if isinstance(value, list) and len(value) == 2 and all(isinstance(each, str) for each in value):
            return value[0], value[1]
        if isinstance(value, str):
            return value
        raise self.document.error("target must be an axis in quotes or a list of two markers", "target", "laboratory")

    def unit(self, symbol: str) -> None:
        try:
            units.unit(symbol, name="unit", dimension="length")
        except InputError as error:
            raise self.document.error(str(error), "unit", "laboratory") from None


TEMPLATE = """\
# Which marker is what. A length is text with its unit. Put names with a colon or a blank into quotes: "Subject:CLUB1".
club = "driver"               # optional: refuses swings said to be of another club

[cluster]                     # markers on the clubhead and no others, three or more, not on a line
{cluster}
# "seen": placed by the calibration below. Or its position from the face centre, in the axes of the club at its static
# loft: to the target, up, towards the toe, as in "Subject:CLUB1" = ["-25 mm", "32 mm", "-20 mm"]

[calibration]
by = "face"                   # "face": by points of the face, below; "positions": by those under [cluster];
                              # "address": by the head at rest behind the ball; "swing": by the blow, roughly
file = "calibration.c3d"      # for "face" and "address": where that is seen; left out, the file of the swing
accuracy = "0.3 mm"           # how well the positions given here are known, a standard deviation; 1 mm if left out
# frames = [1, 90]            # for "address": its first and last frame; found if left out
# ground = "0 mm"             # for "address": height of the ground, on which the sole rests

[face]                        # points on the face, from its centre in the plane that touches it there
FACE_CENTRE = {{ toe = "0 mm", high = "0 mm", standoff = "2 mm" }}   # standoff: of the marker's centre
FACE_TOE = {{ toe = "30 mm", high = "0 mm", standoff = "2 mm" }}
FACE_TOP = {{ toe = "0 mm", high = "18 mm", standoff = "2 mm" }}

[ball]                        # leave the table out if nothing shows the ball: it is then where the head loses speed
marker = "BALL"               # its centre is that of the ball; or: position = ["0 mm", "1200 mm", "51 mm"]
# offset = ["0 mm", "0 mm", "0 mm"]   # from the marker to the ball's centre: to the target, up, right
# accuracy = "10 mm"          # of a position, a standard deviation

[laboratory]
target = "+y"                 # axis to the target, or two markers on the target line: ["NEAR", "FAR"]
up = "+z"
# unit = "mm"                 # of the files, where they name none or a wrong one

# [assumed]                   # standard deviations of what is not measured, here as they are unless given
# face = "2 deg"              # at address: of the face angle, about square
# loft = "2 deg"              # and of loft and lie, about those of the club
# lie = "2 deg"
# sole = "5 mm"               # of the height of the face centre over the ground
# place = "15 mm"             # of the markers on the head, where none is given its position
# toe = "12 mm"               # of the impact point, where the ball is not measured
# high = "10 mm"

# [noise]
# marker = "0.3 mm"           # standard deviation along each axis; estimated from the residuals unless given
"""


def template(markers: Sequence[str] = ("HEAD1", "HEAD2", "HEAD3", "HEAD4")) -> str:
    """Return the TOML text of a mapping file to start from, with every key explained.

    Parameters
    ----------
    markers
        Names for the table of the cluster; those that TOML does not take as they are stand in quotes.
    """
    return TEMPLATE.format(cluster="\n".join(f"{_key(name)} = {quoted(SEEN)}" for name in markers))


def _to_toml(mapping: MarkerMap) -> str:
    def length(value: float) -> str:
        return quoted(f"{round(units.from_si(value, 'mm'), 6):.10g} mm")

    def vector(value: Point) -> str:
        return f"[{', '.join(length(each) for each in value)}]"

    lines = [f"club = {quoted(mapping.club)}", ""] if mapping.club is not None else []
    lines.append("[cluster]")
    for name, place in mapping.cluster.items():
        lines.append(f"{_key(name)} = {quoted(SEEN) if place is None else vector(place)}")
    told = [f"by = {quoted(mapping.by)}"] if mapping.by is not None else []
    told += [f"file = {quoted(mapping.calibration)}"] if mapping.calibration is not None else []
    told += [f"frames = {list(mapping.frames)}"] if mapping.frames is not None else []
    told += [f"ground = {length(mapping.ground)}"] if mapping.ground is not None else []
    told += [f"accuracy = {length(mapping.accuracy)}"] if mapping.accuracy is not None else []
    lines += ["", "[calibration]", *told] if told else []
    if mapping.face:
        lines += ["", "[face]"]
    for name, point in mapping.face.items():
        values = ", ".join(f"{key} = {length(value)}" for key, value in point._asdict().items())
        lines.append(f"{_key(name)} = {{ {values} }}")
    lines += ["", "[ball]"] if mapping.ball is not None or mapping.ball_position is not None else []
    if mapping.ball is not None:
        lines.append(f"marker = {quoted(mapping.ball)}")
    if any(mapping.ball_offset):
        lines.append(f"offset = {vector(mapping.ball_offset)}")
    if mapping.ball_position is not None:
        lines.append(f"position = {vector(mapping.ball_position)}")
    if mapping.ball_accuracy is not None:
        lines.append(f"accuracy = {length(mapping.ball_accuracy)}")
    target = mapping.target if isinstance(mapping.target, str) else None
    line = quoted(target) if target else f"[{', '.join(quoted(each) for each in mapping.target)}]"
    lines += ["", "[laboratory]", f"target = {line}", f"up = {quoted(mapping.up)}"]
    lines += [f"unit = {quoted(mapping.unit)}"] if mapping.unit is not None else []
    lines += ["", "[noise]", f"marker = {length(mapping.noise)}"] if mapping.noise is not None else []
    told = mapping.assumed.told()
    lines += ["", "[assumed]"] if told else []
    for name, value in told.items():
        shown = length(value) if DIMENSIONS[name] == "length" else quoted(f"{units.from_si(value, 'deg'):.10g} deg")
        lines.append(f"{name} = {shown}")
    return "\n".join(lines) + "\n"


def _key(name: str) -> str:
    """Return a key as TOML takes it: bare where it can be."""
    return name if name and all(each.isascii() and (each.isalnum() or each in "-_") for each in name) else quoted(name)
