"""Tracking of the clubhead through a recording: its pose in every frame, with swapped and stray markers corrected."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import combinations, permutations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.capture.rotations import FEWEST, Array, Poses, degrees_of_freedom, fit_poses, visible
from clubface.errors import FileError

TIMES_USUAL = 6.0
"""Residual, as a multiple of the usual one, above which a frame fits badly; outside any Gaussian noise."""
LEAST_MISFIT = 1.5e-3
"""Residual below which a frame always counts as good [m]."""
WRONG_SHAPE = 4e-3
"""Usual residual above which the cluster is not the one in the map [m]."""
ENOUGH = 20
"""Minimum number of frames in which the recording locates a marker on the head better than a calibration."""
ALL_ORDERS = 5
"""Maximum number of markers for which all permutations (120) are tried; for more, swaps of two and cycles of three."""


class Track(NamedTuple):
    """Poses of a clubhead in every frame."""

    shape: Array  # marker positions in body axes as seen in this recording [m], shape (markers, 3)
    poses: Poses
    seen: NDArray[np.bool_]  # which markers were used for the pose of each frame, shape (frames, markers)
    exchanged: dict[tuple[str, ...], list[int]]  # frames with swapped labels, by the markers swapped
    stray: dict[str, list[int]]  # frames in which a marker was excluded, by its name
    lost: list[int]  # frames with enough markers that no permutation fits

    @property
    def known(self) -> NDArray[np.bool_]:
        """Which frames have a pose."""
        return self.poses.known

    def noise(self, frames: NDArray[np.bool_]) -> tuple[float, int]:
        """Return the standard deviation of a marker along an axis [m] from residuals, and its degrees of freedom."""
        residuals = self.poses.residuals[frames]
        # The shape comes from the same frames: subtract three per marker, and add back six for its own pose.
        freedom = int(degrees_of_freedom(residuals).sum()) - 3 * int(visible(residuals).any(0).sum()) + 6
        return (float(np.sqrt(np.nansum(residuals**2) / freedom)) if freedom > 0 else float("nan")), freedom

    def step_correlation(self, frames: NDArray[np.bool_]) -> tuple[float, int]:
        """Return the correlation of successive frame-to-frame steps of the residuals, and the number of products.

        It is -0.5 for white noise, even on top of slow drift, such as camera distortion. A low-pass filter removes the
        fast part of the noise: a second-order Butterworth filter run forwards and backwards leaves 0.3 with a cut-off
        at 0.56 of half the frame rate, 0.7 at 0.28 and 0.9 at 0.14.
        """
        residuals = np.where(frames[:, None, None], self.poses.residuals, np.nan)
        steps = np.diff(np.einsum("kij,kmi->kmj", self.poses.rotation, residuals), axis=0)
        products, squares = steps[1:] * steps[:-1], 0.5 * (steps[1:] ** 2 + steps[:-1] ** 2)
        count = int(np.isfinite(products).sum())
        total = float(np.nansum(squares))
        return (float(np.nansum(products)) / total if total > 0.0 else float("nan")), count


def track(shape: Array, observed: Array, names: Sequence[str], path: str) -> Track:
    """Fit the cluster in every frame, with corrections where possible.

    If the markers of a frame do not fit, permuted labels are tried, then leaving out one marker. A frame that still
    does not fit has no pose. The cluster's ``shape`` in body axes [m] is (markers, 3), and the ``observed`` positions
    in laboratory axes are (frames, markers, 3). Raises FileError if every frame has too few markers, the distances are
    in another unit, or the cluster is not that of the map.
    """
    observed = observed.copy()
    check_seen(observed, names, path)
    check_scale(shape, observed, path)
    poses = fit_poses(shape, observed)
    misfit = poses.misfit
    as_recorded = observed.copy()
    usual = float(np.nanmedian(misfit))
    wrong = usual > WRONG_SHAPE
    if wrong and int((misfit < LEAST_MISFIT).sum()) < ENOUGH:
        raise FileError(path, None, _diagnosis(shape, observed, names, usual))
    # If labels were swapped from some frame on, the earlier frames show what fits.
    limit = LEAST_MISFIT if wrong else max(TIMES_USUAL * usual, LEAST_MISFIT)
    exchanged: dict[tuple[str, ...], list[int]] = {}
    stray: dict[str, list[int]] = {}
    lost: list[int] = []
    for frame in np.flatnonzero(misfit > limit).tolist():
        order = _best_order(shape, observed[frame], limit)
        alone = _stray_marker(shape, observed[frame], limit) if order is None else None
        if order is not None:
            observed[frame] = observed[frame, order]
            exchanged.setdefault(_swapped_markers(order, names), []).append(frame)
        elif alone is not None:
            observed[frame, alone] = np.nan
            stray.setdefault(names[alone], []).append(frame)
        else:
            observed[frame] = np.nan
            lost.append(frame)
    if wrong and len(lost) > 0.5 * np.isfinite(misfit).sum():
        raise FileError(path, None, _diagnosis(shape, as_recorded, names, usual))
    shape = as_seen(shape, fit_poses(shape, observed))
    poses = fit_poses(shape, observed)
    return Track(shape, poses, visible(poses.residuals), exchanged, stray, lost)


def as_seen(shape: Array, poses: Poses) -> Array:
    """Return the shape plus the mean residual of each marker, which leaves residuals of pure noise.

    The shape neither shifts nor rotates in the body, because the residuals of a least-squares fit do neither. Markers
    seen in fewer than ``ENOUGH`` frames keep their positions.
    """
    in_body = np.einsum("kij,kmi->kmj", poses.rotation, poses.residuals)
    seen = visible(in_body)
    counts = seen.sum(0)
    mean = np.where(seen[..., None], in_body, 0.0).sum(0) / np.maximum(counts, 1)[:, None]
    return shape + np.where(counts[:, None] >= ENOUGH, mean, 0.0)


def check_seen(observed: Array, names: Iterable[str], path: str) -> None:
    """Raise FileError if no frame allows a pose."""
    seen = visible(observed)
    if not (seen.sum(-1) >= FEWEST).any():
        counts = ", ".join(f"{name} in {count}" for name, count in zip(names, seen.sum(0).tolist(), strict=True))
        raise FileError(
            path, None, f"no frame of {len(seen)} shows {FEWEST} markers of the clubhead at once; frames: {counts}"
        )


def check_scale(shape: Array, observed: Array, path: str) -> None:
    """Raise FileError if markers are much closer together or farther apart than on the club."""
    pairs = list(combinations(range(len(shape)), 2))
    first, second = (list(each) for each in zip(*pairs, strict=True))
    with np.errstate(invalid="ignore"):
        apart = np.linalg.norm(observed[:, first] - observed[:, second], axis=-1)
    ratio = float(np.nanmedian(apart / np.linalg.norm(shape[first] - shape[second], axis=-1)))
    if not 0.5 < ratio < 2.0:
        raise FileError(
            path, None,
            f"the markers of the clubhead are {np.format_float_positional(ratio, 3, fractional=False, trim='-')} times"
            " as far apart as in the mapping or its calibration: a unit of length is wrong. --units sets that of all"
            " files, including the calibration; if only one of them is wrong, export it again in the right unit",
        )  # fmt: skip


def look_alikes(shape: Array, names: Sequence[str], smallest: float) -> list[tuple[str, ...]]:
    """Return the sets of markers whose exchange displaces none by ``smallest`` [m], and so would go unnoticed."""
    orders = _orders(len(shape))[1:]
    misfit = fit_poses(shape, shape[orders]).misfit
    return [_swapped_markers(orders[place], names) for place in np.flatnonzero(misfit < smallest)]


def _orders(count: int) -> NDArray[np.int64]:
    """Return the permutations of markers to try, the original order first."""
    if count <= ALL_ORDERS:
        return np.array(list(permutations(range(count))))
    result = [list(range(count))]
    for size in (2, 3):
        for places in combinations(range(count), size):
            for turned in (places[1:] + places[:1], places[-1:] + places[:-1])[: size - 1]:
                order = list(range(count))
                for place, source in zip(places, turned, strict=True):
                    order[place] = source
                result.append(order)
    return np.array(result)


def _best_order(shape: Array, observed: Array, limit: float) -> NDArray[np.int64] | None:
    """Return the permutation in which the markers of one frame fit best, or None if none fits."""
    orders = _orders(len(shape))
    best = _best_fit(shape, observed, observed[orders], limit)
    return None if best is None else orders[best]


def _stray_marker(shape: Array, observed: Array, limit: float) -> int | None:
    """Return the marker without which the others fit, or None."""
    without = np.repeat(observed[None], len(shape), axis=0)
    without[np.diag_indices(len(shape))] = np.nan
    return _best_fit(shape, observed, without, limit)


def _best_fit(shape: Array, observed: Array, variants: Array, limit: float) -> int | None:
    """Return which variant of the markers observed in one frame fits best, or None if none fits."""
    misfit = fit_poses(shape, variants).misfit
    # Three markers fit any triangle of nearly the same sides, so four are needed.
    if visible(observed).sum() <= FEWEST or np.isnan(misfit).all():
        return None
    best = int(np.nanargmin(misfit))
    return best if misfit[best] < limit else None


def _diagnosis(shape: Array, observed: Array, names: Sequence[str], usual: float) -> str:
    """Describe why a cluster does not fit at all."""
    left = units.fixed(usual, "mm", 1)
    words = f"the markers of the clubhead do not fit the mapping; the residual is {left} in a typical frame"
    whole = np.flatnonzero(np.all(visible(observed), axis=-1))
    frames = whole[:: max(len(whole) // 15, 1)]
    if len(frames):
        if np.median(fit_poses(shape * [1.0, 1.0, -1.0], observed[frames]).misfit) < LEAST_MISFIT:
            return f"{words}; their mirror image fits, so the hand of the club or an axis of the laboratory is wrong"
        orders = [_best_order(shape, observed[frame], LEAST_MISFIT) for frame in frames]
        exchanged = [None if order is None else _swapped_markers(order, names) for order in orders]
        # Frames that fit without a swap say nothing about the others.
        wrong = [each for each in exchanged if each != ()]
        fitting = [each for each in wrong if each is not None]
        if len(fitting) > len(wrong) / 2:
            markers = " and ".join(max(set(fitting), key=fitting.count))
            return f"{words}; they fit with {markers} exchanged, so correct the mapping"
    return f"{words}; check that this is the right club, and that no marker moved since calibration"


def _swapped_markers(order: NDArray[np.int64], names: Sequence[str]) -> tuple[str, ...]:
    """Return the markers that are exchanged."""
    return tuple(names[place] for place, source in enumerate(order) if place != source)
