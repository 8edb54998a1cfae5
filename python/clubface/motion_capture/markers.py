"""The markers of a laboratory, checked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from clubface.errors import InputError, Told
from clubface.motion_capture.rigid_body import FEWEST

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
        axes at the static loft (x towards the target, y up, z towards the toe), or None if a calibration of the face
        gives it.
    face
        Calibration points on the face, by marker; empty if the positions of the cluster are given.
    calibration
        The C3D file in which cluster and face points are seen together. None means the swing itself.
    accuracy
        Standard deviation along each axis [m] of a given position: of a cluster marker, a face point, or the ball.
    ball
        The marker whose centre is that of the ball, or None.
    ball_offset
        From that marker to the centre of the ball [m], in world axes (x towards the target, y up, z to the right).
    ball_position
        Position of the ball [m] in the axes of the laboratory, instead of a marker.
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
    calibration: str | None = None
    accuracy: float = 0.0
    ball: str | None = None
    ball_offset: Point = (0.0, 0.0, 0.0)
    ball_position: Point | None = None
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
        if placed and len(placed) < len(self.cluster):
            without = ", ".join(name for name in self.cluster if name not in placed)
            raise InputError(
                "cluster", Told(f"without the position of {without}"), "give the positions of all markers, or of none"
            )
        if bool(placed) == bool(self.face):
            if placed:
                advice = "keep either the positions or the points of the face"
                raise InputError("cluster", Told("given positions, and [face] names points of the face"), advice)
            advice = "give the position of each marker, or name points of the face under [face]"
            raise InputError("cluster", Told("without positions"), advice)
        if self.calibration is not None and not self.face:
            raise InputError("calibration", self.calibration, "leave it out, since [face] names no points of the face")
        if self.face and len(self.face) < FEWEST:
            raise InputError("face", f"{len(self.face)} points", f"at least {FEWEST} points, not on a line")
        if (self.ball is None) == (self.ball_position is None):
            raise InputError(
                "ball", Told("given twice" if self.ball else "not described"), "give either its marker or its position"
            )
        _check_axes(self.target, self.up)

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
