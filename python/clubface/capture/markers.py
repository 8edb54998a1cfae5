"""The markers of a laboratory, and the strictly checked TOML files that say which is what."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple, Self

from clubface import units
from clubface.capture.geometry import GIVEN, GUESSED, Assumed
from clubface.capture.rotations import FEWEST
from clubface.errors import InputError, Wording
from clubface.schema.document import Document, Place, quoted
from clubface.schema.tables import Table, decode, encode, file_key, written_key
from clubface.schema.values import TEXT, Choice, Either, Items, PhysicalValue, Record, Simple, count
from clubface.support.checks import check_choice

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
        "address", in which the head rests on the ground with a square face; or the "swing", in which impact shows where
        the face looks. None is "positions" if they are given, and else "face".
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
        Standard deviation along each axis [m] of a given position, of a cluster marker or a face point. None: not
        given; 1 mm is taken.
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
        Standard deviation of that position along each axis [m]. None: not given; that of the other positions if it is
        given, else 10 mm.
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
            raise InputError("ball", Wording("given twice"), "keep either its marker or its position")
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
                "cluster",
                Wording(f"without the position of {without}"),
                "give the positions of all markers, or of none",
            )
        if way == "face" and not self.face:
            raise InputError(
                "cluster",
                Wording("not placed on the club"),
                "give one of these: positions of its markers under [cluster]; points of the face under [face]; or,"
                ' under [calibration], by = "address" (the head at rest behind the ball) or by'
                ' = "swing" (nothing else needed)',
            )
        if way == "face" and placed:
            raise InputError(
                "cluster",
                Wording("placed twice, by its positions and by [face]"),
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


SEEN = "seen"
"""Stands for the position of a marker that the calibration places."""
LENGTH, DEVIATION = PhysicalValue("mm", decimals=6), PhysicalValue("mm", lower=0, decimals=6)
VECTOR = Items(LENGTH, 3, 3, "three lengths in a list")
POSITION = Either(
    {
        str: Choice({SEEN: None}),
        list: VECTOR,
        dict: Simple('in quotes where the name has a point, as in "club.HEAD1" = ...', lambda given: False),
    },
    f'"{SEEN}", or three lengths in a list',
)
FACE_POINT = Record(
    dict.fromkeys(FacePoint._fields, LENGTH), ("toe", "high"), '{ toe = "30 mm", high = "0 mm" }',
    lambda values, place: FacePoint(**{"standoff": 0.0, **values}),
)  # fmt: skip
TARGET = Either({str: TEXT, list: Items(TEXT, 2, 2)}, "an axis in quotes or a list of two markers")


@dataclass(frozen=True, kw_only=True)
class CalibrationTable:
    """What places the markers on the head."""

    by: str | None = file_key(Choice(WAYS), "what it goes by", default=None)
    file: str | None = file_key(
        TEXT, "the C3D file that shows the face or the address; default: the swing", default=None
    )
    frames: tuple[int, int] | None = file_key(
        Items(count(0, 2**31), 2, 2, "the first and the last, as in [1, 90]"), "of the address", default=None
    )
    ground: float | None = file_key(LENGTH, "height of the ground, on which the sole rests", default=None)
    accuracy: float | None = file_key(DEVIATION, "standard deviation of positions that are given", default=None)


@dataclass(frozen=True, kw_only=True)
class BallTable:
    """Where the ball lies."""

    marker: str | None = file_key(TEXT, "the marker whose centre is that of the ball", default=None)
    offset: Point = file_key(VECTOR, "from the marker to the centre of the ball", default=(0.0, 0.0, 0.0))
    position: Point | None = file_key(VECTOR, "of the ball, instead of a marker", default=None)
    accuracy: float | None = file_key(DEVIATION, "standard deviation of the position", default=None)

    def __post_init__(self) -> None:
        if self.marker is None and self.position is None:
            raise InputError(
                "ball", Wording("without a marker and a position"),
                "give one, or leave the whole table out: then the ball is where the clubhead loses speed",
            )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class LaboratoryTable:
    """The axes and units of the laboratory."""

    target: str | tuple[str, str] = file_key(TARGET, "axis to the target, or two markers", default="+x")
    up: str = file_key(TEXT, "axis that points up", default="+z")
    unit: str | None = file_key(TEXT, "unit of the files, if they give none or a wrong one", default=None)

    def __post_init__(self) -> None:
        if self.unit is not None:
            units.unit(self.unit, name="unit", dimension="length")


@dataclass(frozen=True, kw_only=True)
class MarkerFile:
    """A mapping file of markers."""

    club: str | None = file_key(TEXT, "name of the club; swings of another are refused", default=None)
    cluster: Mapping[str, Point | None] = file_key(Record(POSITION), "the markers on the head, with their places")
    calibration: CalibrationTable = file_key(
        Table(CalibrationTable), "what places them", default_factory=CalibrationTable
    )
    face: Mapping[str, FacePoint] = file_key(Record(FACE_POINT), "points on the face, by marker", default_factory=dict)
    ball: BallTable | None = file_key(Table(BallTable), "where the ball lies", default=None)
    laboratory: LaboratoryTable = file_key(
        Table(LaboratoryTable), "axes and units of the files", default_factory=LaboratoryTable
    )
    noise: Mapping[str, float] = file_key(
        Record({"marker": PhysicalValue("mm", above=0, decimals=6)}),
        "standard deviation of a `marker`",
        default_factory=dict,
    )
    assumed: Any = file_key(Table(Assumed), "standard deviations of what is not measured", default_factory=Assumed)

    @classmethod
    def from_markers(cls, markers: Markers) -> Self:
        """Return the file of a mapping."""
        ball = None
        if markers.ball is not None or markers.ball_position is not None:
            offset: Any = markers.ball_offset if any(markers.ball_offset) else ()
            ball = BallTable(
                marker=markers.ball, offset=offset, position=markers.ball_position, accuracy=markers.ball_accuracy
            )
        return cls(
            club=markers.club, cluster=markers.cluster, face=markers.face, ball=ball,
            calibration=CalibrationTable(
                by=markers.by, file=markers.calibration, frames=markers.frames, ground=markers.ground,
                accuracy=markers.accuracy,
            ),
            laboratory=LaboratoryTable(target=markers.target, up=markers.up, unit=markers.unit),
            noise={} if markers.noise is None else {"marker": markers.noise}, assumed=markers.assumed.stated(),
        )  # fmt: skip

    def values(self) -> dict[str, Any]:
        """Return the arguments of :class:`Markers`."""
        calibration, ball, laboratory = self.calibration, self.ball, self.laboratory
        arguments = {
            "club": self.club, "cluster": self.cluster, "face": self.face, "by": calibration.by,
            "calibration": calibration.file, "frames": calibration.frames, "ground": calibration.ground,
            "accuracy": calibration.accuracy, "target": laboratory.target, "up": laboratory.up,
            "unit": laboratory.unit, "noise": self.noise.get("marker"), "assumed": self.assumed,
        }  # fmt: skip
        if ball is None:
            return arguments
        return arguments | {"ball": ball.marker, "ball_offset": ball.offset, "ball_position": ball.position,
                        "ball_accuracy": ball.accuracy}  # fmt: skip


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
        file = decode(MarkerFile, document)
        with Place(document).errors():
            return cls(**file.values(), path=document.path)

    def to_toml(self) -> str:
        """Return the text of a mapping file that reads back as this mapping, lengths to 1 nm."""
        return encode(MarkerFile.from_markers(self))


def marker_map(name: str | os.PathLike[str] | MarkerMap) -> MarkerMap:
    """Return the mapping that is given as the path of its file, or as a :class:`MarkerMap` itself."""
    return name if isinstance(name, MarkerMap) else MarkerMap.read(name)


TEMPLATE = """\
# Which marker is what. A length is text with its unit. Put names with a colon or a blank into quotes: "Subject:CLUB1".
club = "driver"               # optional: refuses swings recorded for another club

[cluster]                     # markers on the clubhead and no others, three or more, not on a line
{cluster}
# "seen": placed by the calibration below. Or its position from the face centre, in the axes of the club at its static
# loft: to the target, up, towards the toe, as in "Subject:CLUB1" = ["-25 mm", "32 mm", "-20 mm"]

[calibration]
by = "face"                   # "face": by points of the face, below; "positions": by those under [cluster];
                              # "address": by the head at rest behind the ball; "swing": by how impact slows it, roughly
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
    return TEMPLATE.format(cluster="\n".join(f"{written_key(name)} = {quoted(SEEN)}" for name in markers))
