"""Gaps that the capture program has filled: frames in which a marker was not seen but calculated.

Programs fill gaps with a straight line, with the last place seen, or with a spline. A marker of noise never lies on a
polynomial to the last digit of a file, a calculated one does: its second, fourth or sixth differences vanish, and are
anything but zero where the gap begins and ends. Such frames show nothing of the club. A line across a gap looks like a
impact, and a spline across the impact hides it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from clubface.capture.recording import Recording
from clubface.capture.rotations import Array
from clubface.results.notes import Note, note

LAST_DIGIT = 6e-8
"""Relative rounding of a number in single precision, as files hold them."""
SHARP = 30.0
"""Differences on both sides of a filled gap, where the marker is seen, are at least so many times those that vanish."""
AROUND = 3
"""Differences looked at on each side, over their order: so many that a kink, as by the impact, makes less than half of
them in a motion without noise."""
ORDERS = (2, 4, 6)
"""Orders of the differences that vanish on lines, cubics and quintics."""
FEWEST = 2
"""Differences in a row that vanish: one of a marker with 0.01 mm of noise vanishes in 10,000 frames by chance."""
SLOW = 0.5
"""m/s; a marker that moves less on a line may well be at rest."""
WHOLE = 30.0
"""Times the least change of a coordinate up to which changes are looked at for whole numbers of it."""
JUMP, FAST = 0.01, 3.0
"""Metres and m/s; a marker that was held where it was last seen jumps by more."""


def without_filled(recording: Recording, names: Iterable[str]) -> tuple[Recording, list[Note]]:
    """Return the recording as the cameras saw some of its markers, and notes on what was left out of them."""
    seen, names = recording.markers(names), tuple(names)
    calculated = filled(seen, recording.rate)
    if not calculated.any():
        return recording, []
    positions = recording.positions.copy()
    gaps: dict[tuple[int, ...], list[str]] = {}
    for name, each in zip(names, calculated.T, strict=True):
        if each.any():
            positions[each, recording.place(name)] = np.nan
            frames = tuple((np.flatnonzero(each) + recording.first_frame).tolist())
            gaps.setdefault(frames, []).append(name)
    notes = [note("capture-filled", markers=each, frames=list(frames)) for frames, each in gaps.items()]
    return replace(recording, positions=positions), notes


def filled(positions: Array, rate: float) -> NDArray[np.bool_]:
    """Return in which frames each marker was calculated and not seen, shape (frames, markers).

    ``positions`` of the markers [m] have the shape (frames, markers, 3), NaN where one was not seen, at ``rate`` [Hz].
    """
    return np.stack([_filled(each, rate) for each in np.swapaxes(positions, 0, 1)], 1)


def _filled(path: Array, rate: float) -> NDArray[np.bool_]:
    """Return in which frames one marker was calculated; ``path`` has shape (frames, 3)."""
    out = np.zeros(len(path), dtype=bool)
    if not np.isfinite(path).any():
        return out
    steps = np.abs(np.diff(path, axis=0)).max(-1)  # NaN next to a gap, as all differences
    digit = LAST_DIGIT * float(np.nanmax(np.abs(path)))
    coarse = max(digit, _unit(path, digit))
    for order in ORDERS:
        size = np.abs(np.diff(path, order, axis=0)).max(-1)
        limit = 2.0**order * digit
        for first, last in _runs(size < limit):
            points, pieces = last + order - first, slice(max(first - 1, 0), last + order + 1)
            if last - first + 1 < FEWEST:
                continue
            if order == 2 and not steps[first : first + points].any():
                if np.nanmax(steps[pieces]) > max(JUMP, FAST / rate):
                    out[first : first + points + 1] = True
                continue
            sides = [size[max(first - AROUND * order, 0) : first], size[last + 1 : last + 1 + AROUND * order]]
            seen = [float(np.median(side[np.isfinite(side)])) for side in sides if np.isfinite(side).any()]
            # A straight line may end with the recording; other motions without noise are as smooth as a spline.
            enough = len(seen) == 2 or (order == 2 and len(seen) == 1)
            moves = np.linalg.norm(path[first + points] - path[first]) * rate > SLOW * points
            if enough and min(seen) > SHARP * max(limit, coarse) and moves:
                # A gap lies between frames that were seen, but for one with which the recording begins or ends.
                begins, ends = first == 0, first + points == len(path) - 1
                out[first + (not begins) : first + points + ends] = True
    return out


def _unit(path: Array, digit: float) -> float:
    """Return the unit of which all coordinates are whole numbers [m], as in rounded files; 0 if there is none."""
    changes = np.abs(np.diff(path, axis=0)).ravel()
    changes = changes[changes > 4.0 * digit]
    if not len(changes):
        return 0.0
    parts = changes / changes.min()
    near = parts[parts < WHOLE]
    return float(changes.min()) if np.mean(np.abs(near - np.round(near)) < 0.1) > 0.9 and len(near) > 10 else 0.0


def _runs(where: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the first and last index of each run of true values."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], where, [False]]).astype(np.int8)))
    return [(int(first), int(last) - 1) for first, last in edges.reshape(-1, 2)]
