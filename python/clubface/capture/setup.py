"""Setup of a session, shared by all its swings: marker map, club, ball, calibration, and laboratory axes.

World axes: x to the target, y up, z to the right of the target line.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from typing import Any, TypedDict

import numpy as np

from clubface import units
from clubface.capture.calibration import Registration, calibrated, from_address, from_swing, given_positions
from clubface.capture.estimators import ROUGHNESS, check_roughness, estimator as estimator_of
from clubface.capture.geometry import LENGTH
from clubface.capture.markers import MarkerMap, marker_map
from clubface.capture.recording import Recording, read_c3d
from clubface.capture.rotations import Array, mirror, visible
from clubface.equipment.balls import Ball, ball as ball_of
from clubface.equipment.clubs import Club, club as club_of
from clubface.equipment.described import HANDS
from clubface.errors import InputError
from clubface.schema import Place
from clubface.support.checks import check_choice

STEEP = 0.5
"""Sine of the steepest slope between two markers that define the target line."""


def axis(name: str) -> Array:
    """Return the unit vector for "+x", "-x" and so on in laboratory axes."""
    vector = np.zeros(3)
    vector["xyz".index(name[1])] = -1.0 if name[0] == "-" else 1.0
    return vector


def to_world(mapping: MarkerMap, recording: Recording) -> Array:
    """Return the rotation from laboratory to world axes, shape (3, 3).

    The target is the axis named in the map, or the horizontal direction between the two markers of the target line at
    their mean positions in ``recording``. Raises FileError if these are missing, never seen, coincident, or above each
    other.
    """
    up = axis(mapping.up)
    if isinstance(mapping.target, str):
        target = axis(mapping.target)
    else:
        line = recording.markers(mapping.target)
        for name, seen in zip(mapping.target, visible(line).T, strict=True):
            if not seen.any():
                raise recording.error(f"marker {name} of the target line is never seen")
        near, far = np.nanmean(line, axis=0)
        length = float(np.linalg.norm(far - near))
        target = (far - near) / length if length > 0.0 else up
        if abs(float(target @ up)) > STEEP:
            names = " and ".join(mapping.target)
            apart = f"they are {units.fixed(length, 'mm', 0)} apart, and {mapping.up} is up"
            raise recording.error(f"{names} define no target line; {apart}")
        target = target - (target @ up) * up
        target = target / np.linalg.norm(target)
    return axes(target, up)


def axes(target: Array, up: Array) -> Array:
    """Return the rotation to axes towards the target, up, and to the right, shape (3, 3)."""
    return np.stack([target, up, np.cross(target, up)])


@dataclass(frozen=True, kw_only=True, eq=False)
class Setup:
    """Everything needed to read the swings of a session."""

    mapping: MarkerMap  # with options applied
    club: Club
    ball: Ball
    estimator: str  # of the path from the last frames to impact
    roughness: float
    registration: Registration | None  # None if each swing contains its own calibration

    def turn(self, recording: Recording) -> Array:
        """Return the matrix from laboratory axes to the world for a right-hander, shape (3, 3)."""
        return mirror(self.club.hand)[:, None] * to_world(self.mapping, recording)

    def cluster(self, recording: Recording) -> Registration:
        """Return the registration of the cluster on the club, from ``recording`` if no other file gives it."""
        if self.registration is not None:
            return self.registration
        turn = self.turn(recording)
        if self.mapping.way == "swing":
            return from_swing(self.mapping, self.club, self.ball, recording, turn)
        if self.mapping.way == "address":
            return from_address(self.mapping, self.club, recording, turn)
        return calibrated(self.mapping, self.club, recording, turn)


class Options(TypedDict, total=False):
    """Keyword options of :func:`clubface.capture.read_swing`, which describes them, and of ``read_swings``."""

    estimator: str
    roughness: float
    ball: str | os.PathLike[str] | Ball | None
    hand: str | None
    target: str | None
    up: str | None
    unit: str | None
    noise: Any


def prepare(
    mapping: str | os.PathLike[str] | MarkerMap,
    club: str | os.PathLike[str] | Club,
    *,
    estimator: str = "smoother",
    roughness: float = ROUGHNESS,
    ball: str | os.PathLike[str] | Ball | None = None,
    hand: str | None = None,
    target: str | None = None,
    up: str | None = None,
    unit: str | None = None,
    noise: Any = None,
) -> Setup:
    """Prepare the setup of a session, which includes reading the calibration file.

    Parameters and errors are those of :func:`clubface.capture.read_swing`.
    """
    estimator_of(estimator)
    words: dict[str, Any] = {key: value for key, value in (("target", target), ("up", up)) if value is not None}
    if unit is not None:
        words["unit"] = units.unit(unit, name="units", dimension="length").symbol
    if noise is not None:
        words["noise"] = LENGTH.read(noise, Place(name="noise"))
    meant = replace(marker_map(mapping), **words)
    head = club_of(club)
    if hand is not None:
        check_choice("hand", hand, HANDS)
        head = head.replace(hand=hand)
    if meant.club is not None and meant.club != head.name:
        raise InputError("club", head.name, f"{meant.club}, the club of {meant.path}")
    result = Setup(
        mapping=meant, club=head, ball=ball_of(ball), estimator=estimator,
        roughness=check_roughness(roughness), registration=None,
    )  # fmt: skip
    if meant.way == "positions":
        return replace(result, registration=given_positions(meant, head))
    if meant.calibration_path is None:
        return result
    return replace(result, registration=result.cluster(read_c3d(meant.calibration_path, unit=meant.unit)))
