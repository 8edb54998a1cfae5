"""Marker maps: the markers of a laboratory, and the strictly checked TOML files that describe them."""

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
        Distances from the face centre [m], towards the toe and upwards, in the plane tangent to the face there.
    standoff
        Distance of the marker's centre from the face [m].
    """

    toe: float
    high: float
    standoff: float


@dataclass(frozen=True, kw_only=True)
class MarkerMap:
    """Markers and axes of a laboratory, usually read from a file.

    Attributes
    ----------
    cluster
        Markers on the clubhead by name, each with its position from the face centre [m] in club axes at static loft (x
        towards the target, y up, z towards the toe), or None if a calibration determines it.
    by
        How the cluster is located on the club: by its given "positions"; by points of the "face" seen with it; by the
        "address", at which the head rests on the ground with a square face; or by the "swing", in which impact reveals
        the direction of the face. None means "positions" if they are given, else "face".
    face
        Face points for calibration, by marker; empty if positions are given.
    calibration
        C3D file that shows the face points or the address. None means the swing itself.
    frames
        First and last frame of the address, as numbered in the file. None means the last rest of the head near the
        ground.
    ground
        Height of the ground along the up axis [m], in laboratory axes. None if unknown; the sole then gives no
        information on the marker positions.
    accuracy
        Standard deviation along each axis of given positions of cluster markers and face points [m]; default 1 mm.
    assumed
        Standard deviations of assumptions.
    ball
        Marker at the centre of the ball, or None. Without marker and position, the ball is taken to be where the head
        loses speed.
    ball_offset
        Vector from this marker to the ball's centre [m], in world axes (x towards the target, y up, z to the right).
    ball_position
        Position of the ball [m] in laboratory axes, in place of a marker.
    ball_accuracy
        Standard deviation of this position along each axis [m]; default ``accuracy`` if given, else 10 mm.
    target
        Laboratory axis that points to the target, such as "+y"; or two markers, the second in the direction of the
        target from the first.
    up
        Laboratory axis that points up.
    unit
        Unit of length of the files, if they name none or a wrong one.
    noise
        Standard deviation of a marker along each axis [m]; None to estimate it from residuals.
    club
        Name of the club for which the map was made, or None.
    path
        File name or another name of the source.
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
        check_choice("by", self.way, WAYS)
        self._check_way(self.way)
        if self.face and len(self.face) < FEWEST:
            raise InputError("face", f"{len(self.face)} points", f"at least {FEWEST} points, not on a line")
        if self.ball is not None and self.ball_position is not None:
            raise InputError("ball", Wording("given twice"), "keep either its marker or its position")
        if self.frames is not None and not 0 <= self.frames[0] < self.frames[1]:
            allowed = "the first and the last frame of the address, such as [1, 90]"
            raise InputError("frames", list(self.frames), allowed)
        allowed = f"one of {', '.join(AXES)}"
        if self.up not in AXES:
            raise InputError("up", self.up, allowed)
        if isinstance(self.target, str):
            if self.target not in AXES:
                raise InputError("target", self.target, f"{allowed}, or a list of two markers")
            if self.target[1] == self.up[1]:
                raise InputError("target", self.target, f"perpendicular to the up axis, {self.up}")

    def _check_way(self, way: str) -> None:
        """Raise InputError if the chosen calibration lacks an input, or an input is given that it does not use."""
        seen = [name for name, position in self.cluster.items() if position is None]
        if way == "positions" and seen:
            shown = Wording(f"without the position of {', '.join(seen)}")
            raise InputError("cluster", shown, "give the positions of all markers, or of none")
        if way == "face" and not self.face:
            raise InputError(
                "cluster", Wording("not placed on the club"),
                "give one of these: positions of its markers under [cluster]; points of the face under [face]; or,"
                ' under [calibration], by = "address" (the head at rest behind the ball) or by'
                ' = "swing" (nothing else needed)',
            )  # fmt: skip
        if way == "face" and len(seen) < len(self.cluster):
            shown = Wording("placed twice, by its positions and by [face]")
            raise InputError("cluster", shown, 'keep one, or write "seen" for positions')
        if way != "face" and self.face:
            raise InputError("by", way, 'leave out the table [face], or give by = "face"')
        for name, ways in (("calibration", ("face", "address")), ("frames", ("address",)), ("ground", ("address",))):
            if getattr(self, name) is not None and way not in ways:
                shown = "file" if name == "calibration" else name
                meant = " or ".join(f'by = "{each}"' for each in ways)
                allowed = f'leave it out, or give {meant}; by = "{way}" does not use it'
                raise InputError(shown, getattr(self, name), allowed)

    @property
    def way(self) -> str:
        """How the cluster is located on the club: one of ``WAYS``."""
        if self.by is not None:
            return self.by
        return "positions" if any(place is not None for place in self.cluster.values()) and not self.face else "face"

    @property
    def position_deviation(self) -> float:
        """Standard deviation of a given position along each axis [m]."""
        return GIVEN if self.accuracy is None else self.accuracy

    @property
    def ball_deviation(self) -> float:
        """Standard deviation of the given ball position along each axis [m]."""
        return next((each for each in (self.ball_accuracy, self.accuracy) if each is not None), GUESSED)

    @property
    def calibration_path(self) -> Path | None:
        """Path of the calibration file, relative to the folder of the mapping file."""
        return None if self.calibration is None else Path(self.path).parent / self.calibration

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Self:
        """Read a mapping file; ``template`` shows its format. Errors name file and line."""
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
        """Write the map as TOML, with lengths to 1 nm."""
        return encode(MarkerFile.from_markers(self))


SEEN = "seen"
"""Written in place of the position of a marker that the calibration locates."""
LENGTH, DEVIATION = PhysicalValue("mm", decimals=6), PhysicalValue("mm", lower=0, decimals=6)
VECTOR = Items(LENGTH, 3, 3, "three lengths in a list")
POSITION = Either(
    {
        str: Choice({SEEN: None}),
        list: VECTOR,
        dict: Simple('in quotes if the name contains a point, as in "club.HEAD1" = ...', lambda given: False),
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
    """How the markers are located on the head."""

    by: str | None = file_key(Choice(WAYS), "method of locating the markers", default=None)
    file: str | None = file_key(
        TEXT, "C3D file that shows the face or the address; default: the swing itself", default=None
    )
    frames: tuple[int, int] | None = file_key(
        Items(count(0, 2**31), 2, 2, "the first and the last, as in [1, 90]"), "frames of the address", default=None
    )
    ground: float | None = file_key(LENGTH, "height of the ground under the sole", default=None)
    accuracy: float | None = file_key(DEVIATION, "standard deviation of given positions", default=None)


@dataclass(frozen=True, kw_only=True)
class BallTable:
    """Position of the ball."""

    marker: str | None = file_key(TEXT, "marker at the centre of the ball", default=None)
    offset: Point = file_key(VECTOR, "vector from the marker to the centre of the ball", default=(0.0, 0.0, 0.0))
    position: Point | None = file_key(VECTOR, "position of the ball, in place of a marker", default=None)
    accuracy: float | None = file_key(DEVIATION, "standard deviation of the position", default=None)

    def __post_init__(self) -> None:
        if self.marker is None and self.position is None:
            raise InputError(
                "ball", Wording("without marker and position"),
                "give one, or leave the table out; the ball is then taken to be where the clubhead loses speed",
            )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class LaboratoryTable:
    """Axes and units of a laboratory."""

    target: str | tuple[str, str] = file_key(
        TARGET, "axis to the target, or two markers on the target line", default="+x"
    )
    up: str = file_key(TEXT, "axis that points up", default="+z")
    unit: str | None = file_key(TEXT, "length unit of the files, if they name none or a wrong one", default=None)

    def __post_init__(self) -> None:
        if self.unit is not None:
            units.unit(self.unit, name="unit", dimension="length")


@dataclass(frozen=True, kw_only=True)
class MarkerFile:
    """Keys of a mapping file of markers."""

    club: str | None = file_key(TEXT, "name of the club; swings of other clubs are rejected", default=None)
    cluster: Mapping[str, Point | None] = file_key(Record(POSITION), "markers on the head with their positions")
    calibration: CalibrationTable = file_key(
        Table(CalibrationTable), "how they are located", default_factory=CalibrationTable
    )
    face: Mapping[str, FacePoint] = file_key(Record(FACE_POINT), "face points, by marker", default_factory=dict)
    ball: BallTable | None = file_key(Table(BallTable), "position of the ball", default=None)
    laboratory: LaboratoryTable = file_key(
        Table(LaboratoryTable), "axes and units of the files", default_factory=LaboratoryTable
    )
    noise: Mapping[str, float] = file_key(
        Record({"marker": PhysicalValue("mm", above=0, decimals=6)}),
        "standard deviation of a `marker`",
        default_factory=dict,
    )
    assumed: Any = file_key(
        Table(Assumed), "standard deviations of assumptions that replace measurements", default_factory=Assumed
    )

    @classmethod
    def from_markers(cls, markers: MarkerMap) -> Self:
        """Return the file contents of a marker map."""
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
        """Return the arguments of :class:`MarkerMap`."""
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


def marker_map(name: str | os.PathLike[str] | MarkerMap) -> MarkerMap:
    """Return a marker map: from the path of its file, or as given."""
    return name if isinstance(name, MarkerMap) else MarkerMap.read(name)


TEMPLATE = """\
# The markers of a laboratory. Lengths are text with a unit. Quote names with a colon or a space: "Subject:CLUB1".
club = "driver"               # optional: rejects swings recorded for another club

[cluster]                     # markers on the clubhead and no others; three or more, not on a line
{cluster}
# "seen": located by the calibration below. Or its position from the face centre, in club axes at static loft: to the
# target, up, towards the toe, as in "Subject:CLUB1" = ["-25 mm", "32 mm", "-20 mm"]

[calibration]
by = "face"                   # "face": by the face points below; "positions": by those under [cluster];
                              # "address": by the head at rest behind the ball; "swing": by its impact, roughly
file = "calibration.c3d"      # for "face" and "address": the file that shows it; default: the file of the swing
accuracy = "0.3 mm"           # standard deviation of the positions given here; default 1 mm
# frames = [1, 90]            # for "address": its first and last frame; detected by default
# ground = "0 mm"             # for "address": height of the ground under the sole

[face]                        # points on the face, from its centre, in the plane tangent to the face there
FACE_CENTRE = {{ toe = "0 mm", high = "0 mm", standoff = "2 mm" }}   # standoff: distance of the marker's centre
FACE_TOE = {{ toe = "30 mm", high = "0 mm", standoff = "2 mm" }}
FACE_TOP = {{ toe = "0 mm", high = "18 mm", standoff = "2 mm" }}

[ball]                        # leave this table out if nothing shows the ball; it is then where the head loses speed
marker = "BALL"               # marker at the ball's centre; or: position = ["0 mm", "1200 mm", "51 mm"]
# offset = ["0 mm", "0 mm", "0 mm"]   # from the marker to the ball's centre: to the target, up, right
# accuracy = "10 mm"          # standard deviation of a position

[laboratory]
target = "+y"                 # axis to the target, or two markers on the target line: ["NEAR", "FAR"]
up = "+z"
# unit = "mm"                 # length unit of the files, if they name none or a wrong one

# [assumed]                   # standard deviations of assumptions that replace measurements, with their defaults
# face = "2 deg"              # at address: face angle, about square
# loft = "2 deg"              # loft and lie, about the club's
# lie = "2 deg"
# sole = "5 mm"               # height of the face centre above the ground
# place = "15 mm"             # markers on the head, if no positions are given
# toe = "12 mm"               # impact point, if the ball is not measured
# high = "10 mm"

# [noise]
# marker = "0.3 mm"           # standard deviation along each axis; default: estimated from residuals
"""


def template(markers: Sequence[str] = ("HEAD1", "HEAD2", "HEAD3", "HEAD4")) -> str:
    """Return the TOML text of a commented mapping file to start from.

    ``markers`` are the names for the table of the cluster; names that TOML does not accept are put in quotes.
    """
    return TEMPLATE.format(cluster="\n".join(f"{written_key(name)} = {quoted(SEEN)}" for name in markers))
