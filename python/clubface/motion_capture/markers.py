"""The markers of a laboratory, checked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from clubface.errors import InputError, Told
from clubface.motion_capture.geometry import GIVEN, GUESSED, Assumed
from clubface.motion_capture.rigid_body import FEWEST
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
