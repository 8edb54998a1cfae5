"""From the axes of a laboratory to the world: x to the target, y up, z to the right of the target line."""

from __future__ import annotations

import numpy as np

from clubface import units
from clubface.errors import FileError
from clubface.motion_capture.mapping_file import MarkerMap
from clubface.motion_capture.recording import Recording
from clubface.motion_capture.rigid_body import visible
from clubface.motion_capture.rotations import Array

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
