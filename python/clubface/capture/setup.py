"""What all swings of a session share, and the axes of their laboratory.

What all swings of a session share: which marker is what, the club, the ball, and the calibration.

From the axes of a laboratory to the world: x to the target, y up, z to the right of the target line.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from typing import Any, TypedDict

import numpy as np

from clubface import units
from clubface.capture.calibration import Registration, calibrated, from_address, from_swing, given_positions
from clubface.capture.estimators import ROUGHNESS, check_roughness, estimator as estimator_of
from clubface.capture.markers import MarkerMap, marker_map
from clubface.capture.recording import Recording, read_c3d
from clubface.capture.rotations import Array, mirror, visible
from clubface.equipment.balls import Ball, ball as ball_of
from clubface.equipment.clubs import Club, club as club_of
from clubface.equipment.described import HANDS
from clubface.errors import FileError, InputError
from clubface.support.checks import check_choice

STEEP = 0.5
"""Sine of the steepest target line: beyond, the two markers are no target line."""


def axis(name: str) -> Array:
    """Return the unit vector called "+x", "-x", ... in the laboratory."""
    vector = np.zeros(3)
    vector["xyz".index(name[1])] = -1.0 if name[0] == "-" else 1.0
    return vector


def to_world(mapping: MarkerMap, recording: Recording) -> Array:
    """Return the rotation from laboratory to world axes, shape (3, 3).

    The target is the axis named by the mapping, or the level direction from the one marker to the other of the target
    line, at the mean of their positions in ``recording``.

    Raises
    ------
    FileError
        Markers of the target line that are not in the file, never seen, in one place or above each other.
    """
    up = axis(mapping.up)
    if isinstance(mapping.target, str):
        target = axis(mapping.target)
    else:
        line = recording.markers(mapping.target)
        for name, seen in zip(mapping.target, visible(line).T, strict=True):
            if not seen.any():
                raise FileError(recording.path, None, f"marker {name} of the target line is never seen")
        near, far = np.nanmean(line, axis=0)
        length = float(np.linalg.norm(far - near))
        target = (far - near) / length if length > 0.0 else up
        if abs(float(target @ up)) > STEEP:
            names = " and ".join(mapping.target)
            raise FileError(
                recording.path,
                None,
                f"{names} give no target line: {units.fixed(length, 'mm', 0)} apart, {mapping.up} is up",
            )
        target = target - (target @ up) * up
        target = target / np.linalg.norm(target)
    return np.stack([target, up, np.cross(target, up)])


@dataclass(frozen=True, kw_only=True, eq=False)
class Setup:
    """A laboratory ready to read swings.

    Attributes
    ----------
    mapping
        Which marker is what, options applied.
    club, ball
        What meets what.
    estimator, roughness
        How the last frames are extended to impact.
    registration
        The cluster on the club, or None where each swing holds its own calibration.
    """

    mapping: MarkerMap
    club: Club
    ball: Ball
    estimator: str
    roughness: float
    registration: Registration | None

    def turn(self, recording: Recording) -> Array:
        """Return the matrix from the laboratory to the world as a right-hander sees it, shape (3, 3)."""
        turn = to_world(self.mapping, recording)
        return mirror(self.club.hand)[:, None] * turn

    def cluster(self, recording: Recording) -> Registration:
        """Return the cluster on the club, calibrated from ``recording`` where no other file is."""
        if self.registration is not None:
            return self.registration
        turn = self.turn(recording)
        if self.mapping.way == "swing":
            return from_swing(self.mapping, self.club, self.ball, recording, turn)
        if self.mapping.way == "address":
            return from_address(self.mapping, self.club, recording, turn)
        return calibrated(self.mapping, self.club, recording, turn)


class Options(TypedDict, total=False):
    """What :func:`read_swing` and :func:`read_swings` take by name; the same as :func:`prepare`."""

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
    """Return the set-up of a session; this reads the calibration file.

    Parameters
    ----------
    mapping
        Which marker is what: the path of a TOML file (see ``template``), or a :class:`MarkerMap`.
    club
        A built-in name, the path of a TOML file, or a :class:`Club`.
    estimator
        "smoother", "polynomial", or "linear", the straight lines of Caldwell and McPhee (2023).
    roughness
        For the smoother: how much the path may depart from a quartic.
    ball
        The ball, whose radius is used; `modern` if left out.
    hand
        "right" or "left"; that of the club if left out.
    target, up
        Axes of the laboratory such as "+y", instead of those of the mapping.
    unit
        Unit of length of the files, instead of the one they name.
    noise
        Standard deviation of a marker along an axis, such as "0.3 mm". If left out: that of the mapping, or an estimate
        from the residuals.

    Raises
    ------
    FileError
        A mapping or calibration file cannot be used.
    InputError
        An option cannot be used, or the club is not that of the mapping.
    """
    estimator_of(estimator)
    words: dict[str, Any] = {key: value for key, value in (("target", target), ("up", up)) if value is not None}
    if unit is not None:
        words["unit"] = units.unit(unit, name="units", dimension="length").symbol
    if noise is not None:
        words["noise"] = units.parse(noise, "length", name="noise")
        if not words["noise"] > 0.0:
            raise InputError("noise", noise, "above 0 m")
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
