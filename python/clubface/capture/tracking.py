"""The clubhead through a recording: its attitude and position in every frame; exchanged and stray markers are found."""

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
"""A frame fits badly beyond this many times the usual residual: beyond all Gaussian noise."""
LEAST_MISFIT = 1.5e-3
"""Metres; a frame that fits so well is good whatever the others do."""
WRONG_SHAPE = 4e-3
"""Metres; the usual residual of a cluster that is not the one in the mapping."""
ENOUGH = 20
"""Frames that show a marker's place on the head better than a calibration does."""
ALL_ORDERS = 5
"""Markers up to which every order is tried, 120; beyond, exchanges of two and of three."""


class Track(NamedTuple):
    """A clubhead in every frame.

    Attributes
    ----------
    shape
        Markers in body axes [m], shape (markers, 3), as the recording itself shows them.
    poses
        Position of the body's origin, rotation and residuals.
    seen
        Which markers the pose of each frame was made of, shape (frames, markers).
    exchanged
        Frames in which labels were exchanged, by the markers exchanged.
    stray
        Frames in which a marker was left out, by its name.
    lost
        Frames with enough markers, but which no order of them fits.
    """

    shape: Array
    poses: Poses
    seen: NDArray[np.bool_]
    exchanged: dict[tuple[str, ...], list[int]]
    stray: dict[str, list[int]]
    lost: list[int]

    @property
    def known(self) -> NDArray[np.bool_]:
        """Which frames have a pose."""
        return np.isfinite(self.poses.position[:, 0])

    def noise(self, frames: NDArray[np.bool_]) -> tuple[float, int]:
        """Return the standard deviation of a marker along an axis [m], from residuals, and its degrees of freedom."""
        residuals = self.poses.residuals[frames]
        # The shape was taken from the same frames: its three coordinates a marker, less the six of its own pose.
        freedom = int(degrees_of_freedom(residuals).sum()) - 3 * int(visible(residuals).any(0).sum()) + 6
        return (float(np.sqrt(np.nansum(residuals**2) / freedom)) if freedom > 0 else float("nan")), freedom

    def step_correlation(self, frames: NDArray[np.bool_]) -> tuple[float, int]:
        """Return the correlation of successive steps of the residuals from frame to frame, and how many entered.

        It is -0.5 for white noise, also if that is added to a slow drift, such as the distortion of a camera. A
        low-pass filter takes the fast part of the noise away: 0.3 is left by a Butterworth filter of second order, run
        to and fro, with a cut-off at 0.56 of half the frame rate, 0.7 at 0.28 and 0.9 at 0.14.
        """
        residuals = np.where(frames[:, None, None], self.poses.residuals, np.nan)
        steps = np.diff(np.einsum("kij,kmi->kmj", self.poses.rotation, residuals), axis=0)
        products, squares = steps[1:] * steps[:-1], 0.5 * (steps[1:] ** 2 + steps[:-1] ** 2)
        count = int(np.isfinite(products).sum())
        total = float(np.nansum(squares))
        return (float(np.nansum(products)) / total if total > 0.0 else float("nan")), count


def track(shape: Array, observed: Array, names: Sequence[str], path: str) -> Track:
    """Fit the cluster in every frame, and correct what can be corrected.

    A frame whose markers do not fit is tried with its labels in other orders, and then without one marker. A frame that
    fits neither way has no attitude and position. The ``shape`` of the cluster in body axes [m] is (markers, 3), and
    the markers ``observed`` in the laboratory have the shape (frames, markers, 3). It is a :class:`FileError` where
    there are too few markers in every frame, the distances are in another unit, or the cluster is not that of the
    mapping.
    """
    observed = observed.copy()
    check_seen(observed, names, path)
    check_scale(shape, observed, path)
    poses = fit_poses(shape, observed)
    misfit = _misfit(poses)
    as_recorded = observed.copy()
    usual = float(np.nanmedian(misfit))
    wrong = usual > WRONG_SHAPE
    if wrong and int((misfit < LEAST_MISFIT).sum()) < ENOUGH:
        raise FileError(path, None, _diagnosis(shape, observed, names, usual))
    # Labels that were exchanged from some frame on: the frames before it show what fits.
    limit = LEAST_MISFIT if wrong else max(TIMES_USUAL * usual, LEAST_MISFIT)
    exchanged: dict[tuple[str, ...], list[int]] = {}
    stray: dict[str, list[int]] = {}
    lost: list[int] = []
    for frame in np.flatnonzero(misfit > limit).tolist():
        order = _order(shape, observed[frame], limit)
        alone = _odd_one(shape, observed[frame], limit) if order is None else None
        if order is not None:
            observed[frame] = observed[frame, order]
            exchanged.setdefault(_exchanged(order, names), []).append(frame)
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
    """Return the shape with the mean residual of each marker added, so that the residuals left are noise alone.

    Where and how the shape sits in the body stays, for the residuals of a least-squares fit neither shift nor turn it.
    A marker seen in fewer than ``ENOUGH`` frames keeps its place.
    """
    in_body = np.einsum("kij,kmi->kmj", poses.rotation, poses.residuals)
    seen = visible(in_body)
    counts = seen.sum(0)
    mean = np.where(seen[..., None], in_body, 0.0).sum(0) / np.maximum(counts, 1)[:, None]
    return shape + np.where(counts[:, None] >= ENOUGH, mean, 0.0)


def check_seen(observed: Array, names: Iterable[str], path: str) -> None:
    """Refuse a recording in which a pose is never possible."""
    seen = visible(observed)
    if not (seen.sum(-1) >= FEWEST).any():
        counts = ", ".join(f"{name} in {count}" for name, count in zip(names, seen.sum(0).tolist(), strict=True))
        raise FileError(
            path, None, f"no frame of {len(seen)} shows {FEWEST} markers of the clubhead at once; frames: {counts}"
        )


def check_scale(shape: Array, observed: Array, path: str) -> None:
    """Refuse markers that are much nearer together or farther apart than they are on the club."""
    pairs = list(combinations(range(len(shape)), 2))
    first, second = (list(each) for each in zip(*pairs, strict=True))
    with np.errstate(invalid="ignore"):
        apart = np.linalg.norm(observed[:, first] - observed[:, second], axis=-1)
    ratio = float(np.nanmedian(apart / np.linalg.norm(shape[first] - shape[second], axis=-1)))
    if not 0.5 < ratio < 2.0:
        raise FileError(
            path, None,
            f"the markers of the clubhead are {np.format_float_positional(ratio, 3, fractional=False, trim='-')} times"
            " as far apart as by the mapping or its calibration: a unit of length is wrong. --units sets that of all"
            " files, the calibration included; if only one of them is wrong, export that file again in the right unit",
        )  # fmt: skip


def look_alikes(shape: Array, names: Sequence[str], smallest: float) -> list[tuple[str, ...]]:
    """Return the markers whose exchange moves none by ``smallest`` [m], so that it would not be noticed."""
    orders = _orders(len(shape))[1:]
    misfit = _misfit(fit_poses(shape, shape[orders]))
    return [_exchanged(orders[place], names) for place in np.flatnonzero(misfit < smallest)]


def _misfit(poses: Poses) -> Array:
    """Return the root mean square of each frame's residuals by its degrees of freedom [m]; NaN without a pose."""
    freedom = degrees_of_freedom(poses.residuals)
    known = np.isfinite(poses.position[:, 0])
    return np.where(known, np.sqrt(np.nansum(poses.residuals**2, axis=(-1, -2)) / np.maximum(freedom, 1)), np.nan)


def _orders(count: int) -> NDArray[np.int64]:
    """Return orders of markers to try, the given one first."""
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


def _order(shape: Array, observed: Array, limit: float) -> NDArray[np.int64] | None:
    """Return the order of labels in which the markers of one frame fit best, or None if none fits."""
    orders = _orders(len(shape))
    misfit = _misfit(fit_poses(shape, observed[orders]))
    if np.isnan(misfit).all():
        return None
    best = int(np.nanargmin(misfit))
    # With three markers to fit, any triangle of nearly the same sides fits: four are needed to be sure.
    return orders[best] if misfit[best] < limit and visible(observed).sum() > FEWEST else None


def _odd_one(shape: Array, observed: Array, limit: float) -> int | None:
    """Return the marker without which the others fit, or None if there is none."""
    without = np.repeat(observed[None], len(shape), axis=0)
    without[np.arange(len(shape)), np.arange(len(shape))] = np.nan
    misfit = np.where(visible(observed), _misfit(fit_poses(shape, without)), np.nan)
    if visible(observed).sum() <= FEWEST or np.isnan(misfit).all():
        return None
    best = int(np.nanargmin(misfit))
    return best if misfit[best] < limit else None


def _diagnosis(shape: Array, observed: Array, names: Sequence[str], usual: float) -> str:
    """Say why a cluster does not fit at all."""
    left = units.fixed(usual, "mm", 1)
    words = f"the markers of the clubhead do not fit the mapping: {left} are left over in the usual frame"
    whole = np.flatnonzero(np.all(visible(observed), axis=-1))
    frames = whole[:: max(len(whole) // 15, 1)]
    if len(frames):
        if np.median(_misfit(fit_poses(shape * [1.0, 1.0, -1.0], observed[frames]))) < LEAST_MISFIT:
            return f"{words}; their mirror image fits: the hand of the club is wrong, or an axis of the laboratory"
        orders = [_order(shape, observed[frame], LEAST_MISFIT) for frame in frames]
        exchanged = [None if order is None else _exchanged(order, names) for order in orders]
        # Frames that fit as they are tell nothing of the others.
        wrong = [each for each in exchanged if each != ()]
        fitting = [each for each in wrong if each is not None]
        if len(fitting) > len(wrong) / 2:
            markers = " and ".join(max(set(fitting), key=fitting.count))
            return f"{words}; they fit with {markers} exchanged: correct the mapping"
    return f"{words}; is this the right club, and were the markers moved since it was calibrated?"


def _exchanged(order: NDArray[np.int64], names: Sequence[str]) -> tuple[str, ...]:
    """Return which markers are exchanged."""
    return tuple(names[place] for place, source in enumerate(order) if place != source)
