"""Calibration from the address: the head rests on the ground behind the ball, with the loft and lie it was made with.

No marker on the face is needed. That the player aims the face at the target, and holds the shaft as the maker meant it,
is an assumption. Its standard deviations go into every delivery read with it.
"""

from __future__ import annotations

import numpy as np

from clubface import units
from clubface.equipment.clubs import Club
from clubface.errors import FileError
from clubface.motion_capture.geometry import Known
from clubface.motion_capture.mapping_file import MarkerMap
from clubface.motion_capture.placement import Attitude, placed
from clubface.motion_capture.recording import Recording
from clubface.motion_capture.registration import Registration
from clubface.motion_capture.rigid_body import FEWEST, fit_poses, visible
from clubface.motion_capture.rotations import Array

STILL = 0.08
"""m/s; a head that rests does not move faster over ``WINDOW``. Waggles reach ten times that."""
WINDOW = 0.05
"""Seconds over which speed is taken, so that the noise of a marker, 1 mm, makes 0.03 m/s."""
SHORTEST = 0.1
"""Seconds of rest that make an address: longer than the head pauses at the top of the swing."""
LOW = 0.15
"""Metres above its lowest place at which a head may rest: not on the shoulder."""


def from_address(mapping: MarkerMap, club: Club, recording: Recording, turn: Array) -> Registration:
    """Return the cluster on the club as the address shows it.

    Parameters
    ----------
    mapping, club
        Which marker is what, and the club.
    recording
        Shows the head at rest: a trial of its own, or the swing.
    turn
        Rotation from the laboratory to the world, mirrored for a left-hander, shape (3, 3).

    Raises
    ------
    FileError
        The head never rests, or a marker is not seen then.
    """
    assumed = mapping.assumed
    seen = recording.markers(mapping.cluster) @ turn.T
    first, last = _frames(mapping, recording, seen)
    markers = _mean(seen[first : last + 1], tuple(mapping.cluster), recording, first)
    attitude = Attitude(np.array([club.loft, 0.0, 0.0]), np.diag([assumed.loft, assumed.face, assumed.lie]) ** 2)
    found = placed(markers, attitude, mapping, club, mapping.ground)
    told = (
        Known.of("loft at address", "assumed", "deg", [club.loft], [assumed.loft]),
        Known.of("face angle at address", "assumed", "deg", [0.0], [assumed.face]),
        Known.of("lie at address", "assumed", "deg", [0.0], [assumed.lie]),
    )
    frames = f"address taken from frames {first + recording.first_frame} to {last + recording.first_frame}"
    where = f" of {recording.path}" if mapping.calibration is not None else ""
    return found._replace(geometry=(*told, *found.geometry), notes=(f"{frames}{where}", *found.notes))


def _frames(mapping: MarkerMap, recording: Recording, seen: Array) -> tuple[int, int]:
    """Return the first and the last frame of the address, from 0."""
    count = len(seen)
    if mapping.frames is not None:
        first, last = (each - recording.first_frame for each in mapping.frames)
        if first < 0 or last >= count:
            told = f"{recording.first_frame} to {recording.first_frame + count - 1}"
            raise FileError(
                recording.path, None,
                f"frames of the address are {list(mapping.frames)}; the file has frames {told}: correct frames under"
                f" [calibration] of {mapping.path}",
            )  # fmt: skip
        return first, last
    middle = np.where(visible(seen)[..., None], seen, np.nan).mean(1)  # NaN where a marker is hidden
    step = max(round(WINDOW * recording.rate), 1)
    speed = np.full(count, np.nan)
    if count > step:
        speed[: count - step] = np.linalg.norm(middle[step:] - middle[:-step], axis=-1) * recording.rate / step
    low = middle[:, 1] < np.nanmin(middle[:, 1], initial=np.inf) + LOW
    with np.errstate(invalid="ignore"):
        still = np.concatenate([[False], (speed < STILL) & low, [False]])
    edges = np.flatnonzero(np.diff(still.astype(np.int8)))
    runs = [
        (int(first), int(last) - 1 + step)
        for first, last in edges.reshape(-1, 2)
        if last - 1 + step - first >= SHORTEST * recording.rate
    ]
    if not runs:
        slowest = "" if np.isnan(speed).all() else f"; it is never slower than {np.nanmin(speed):.2f} m/s"
        raise FileError(
            recording.path, None,
            f"no address: the clubhead nowhere rests near the ground for {units.fixed(SHORTEST, 'ms', 0)}{slowest}."
            f' Name the frames of the address under [calibration] of {mapping.path}, or a file that shows it; or give'
            ' by = "swing"',
        )  # fmt: skip
    return runs[-1]


def _mean(seen: Array, names: tuple[str, ...], recording: Recording, first: int) -> Array:
    """Return the mean places of the markers over the frames that show all of them, after a fit of their poses."""
    whole = seen[np.all(visible(seen), axis=-1)]
    if len(whole) < 1 or len(names) < FEWEST:
        hidden = [name for name, each in zip(names, np.any(visible(seen), axis=0).tolist(), strict=True) if not each]
        words = f"{', '.join(hidden)} not seen" if hidden else "no frame shows all markers of the cluster"
        raise FileError(
            recording.path, None,
            f"address from frame {first + recording.first_frame}: {words}; take the marker out of [cluster], or name"
            " other frames under [calibration]",
        )  # fmt: skip
    mean = whole.mean(0)
    if not np.isfinite(fit_poses(mean - mean.mean(0), mean[None]).position).all():
        raise FileError(recording.path, None, f"the markers of the cluster lie on a line: {', '.join(names)}")
    return mean
