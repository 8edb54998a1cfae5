"""Where a posterior lies: its most probable point, and coordinates in which it is nearly a standard normal one.

Few numbers are measured, far more exactly than the prior knows them. The posterior is therefore a thin sheet that bends
through the many dimensions of a delivery: thin along the directions that the measurement knows, broad along the others.
A normal distribution fits it badly. Coordinates that bend with it fit well: those along the sheet are drawn first, and
the others are measured from the place on the sheet beside them, in units of how thin the sheet is there. Two steps of
Broyden's method find both. Whatever they find, the density of such draws is known exactly.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from clubface.support.arrays import Floats

MOST_STEPS, HALVINGS = 50, 12
ENOUGH = 1e-3
"""The search ends where minus twice the logarithm of the posterior falls by less."""
SHARP = 3.0
"""A direction is known by the measurement where it tells more than the prior."""
Residuals = Callable[[Floats], Floats]
"""Seen less measured, in standard deviations of the measurement, at points (n, d): (n, m); NaN where impossible."""
Slopes = Callable[[Floats], tuple[Floats, Floats]]
"""The same at one point (d,), and its derivatives: (m,), (m, d)."""


class Peak(NamedTuple):
    """The most probable point.

    Attributes
    ----------
    point
        The point, in standard deviations of the prior.
    slopes
        Derivatives of the residuals there, shape (m, d).
    misfit
        Squares of point and residuals, added up: chi-squared distributed with m degrees of freedom where the launch is
        linear and the prior is true.
    """

    point: Floats
    slopes: Floats
    misfit: float


def peak(residuals: Residuals, slopes: Slopes, start: Floats) -> Peak | None:
    """Return the most probable point near a ``start`` by the Gauss-Newton method; None if it finds none."""
    point, dimensions = start, start.size
    misfit = _misfit(residuals, point)
    if not np.isfinite(misfit):
        return None
    for _ in range(MOST_STEPS):
        off, table = slopes(point)
        if not (np.isfinite(table).all() and np.isfinite(off).all()):
            return None
        step = -np.linalg.solve(np.eye(dimensions) + table.T @ table, point + table.T @ off)
        for halving in range(HALVINGS):
            following = point + 0.5**halving * step
            reached = _misfit(residuals, following)
            if reached < misfit:
                break
        else:
            return Peak(point, table, misfit)
        point, gained, misfit = following, misfit - reached, reached
        if gained < ENOUGH:
            _, table = slopes(point)
            return Peak(point, table, misfit) if np.isfinite(table).all() else None
    return None


def _misfit(residuals: Residuals, point: Floats) -> float:
    found = float(point @ point + np.sum(residuals(point[None, :]) ** 2))
    return found if np.isfinite(found) else np.inf


class Sheet:
    """Coordinates that bend with a posterior, in which it is about standard normal.

    Parameters
    ----------
    at
        The most probable point.
    residuals
        Of the measurement.
    """

    def __init__(self, at: Peak, residuals: Residuals) -> None:
        _, values, rows = np.linalg.svd(at.slopes, full_matrices=True)
        strength = np.zeros(len(at.point))
        strength[: len(values)] = values
        sharp = strength > SHARP
        self._residuals = residuals
        self._along, self._across = rows[~sharp], rows[sharp]
        self._wide = 1.0 / np.hypot(1.0, strength[~sharp])
        self._centre_along, self._centre_across = self._along @ at.point, self._across @ at.point
        self._slopes = at.slopes @ self._across.T
        self._gain = np.linalg.inv(np.eye(len(self._across)) + self._slopes.T @ self._slopes)

    def points(self, coordinates: Floats) -> tuple[Floats, Floats]:
        """Return points in standard deviations of the prior, shape (n, d), and the logarithm of the volume there.

        That is the volume which a unit of volume of the coordinates takes.
        """
        along, across = np.split(coordinates, [len(self._along)], axis=1)
        base = (self._centre_along + self._wide * along) @ self._along
        beside, root = self._beside(base)
        beside = beside + _solved_transposed(root, across.T).T
        volume = np.log(self._wide).sum() - sum(np.log(root[place][place]) for place in range(len(root)))
        return base + beside @ self._across, np.broadcast_to(volume, len(coordinates))

    def _beside(self, base: Floats) -> tuple[Floats, list[list[Floats]]]:
        """Return the places of the sheet beside ``base``, shape (n, sharp), and the factor of the curvature there.

        The latter is that of minus the logarithm of the posterior, its lower factor by rows. Where the place at which a
        step begins is impossible, nothing is known of the sheet, and that of the peak stands for it.
        """
        start = np.tile(self._centre_across, (len(base), 1))
        off = self._residuals(base + start @ self._across)
        step = -_possible((start + off @ self._slopes) @ self._gain)
        after = self._residuals(base + (start + step) @ self._across)
        # Broyden's update: the slopes that fit what was seen along the step, S + missed step', and I + their square.
        length = np.sum(step**2, axis=1)
        missed = _possible(after - off - step @ self._slopes.T) / np.where(length > 0.0, length, 1.0)[:, None]
        bent, along, square = (missed @ self._slopes).T, step.T, np.sum(missed**2, axis=1)
        straight = np.eye(len(along)) + self._slopes.T @ self._slopes
        columns = [
            [
                straight[i, j] + bent[i] * along[j] + along[i] * bent[j] + square * along[i] * along[j]
                for j in range(i + 1)
            ]
            for i in range(len(along))
        ]
        root = _cholesky(columns)
        downhill = (start + step + after @ self._slopes).T + along * np.sum(missed * after, axis=1)
        last = -_possible(_solved_transposed(root, _solved(root, downhill)).T)
        return start + step + last, root


def _possible(values: Floats) -> Floats:
    """Return rows with zeros for those that are not finite."""
    return np.where(np.isfinite(values).all(axis=1, keepdims=True), values, 0.0)


def _cholesky(matrix: list[list[Floats]]) -> list[list[Floats]]:
    """Return the lower factors of many small matrices at once, which LAPACK would take one by one."""
    root: list[list[Floats]] = [[] for _ in matrix]
    for i, row in enumerate(root):
        for j in range(i):
            row.append((matrix[i][j] - sum(row[k] * root[j][k] for k in range(j))) / root[j][j])
        row.append(np.sqrt(matrix[i][i] - sum(each**2 for each in row)))
    return root


def _solved(root: list[list[Floats]], right: Floats) -> Floats:
    """Return x with root x = right, shape (k, n)."""
    found: list[Floats] = []
    for i, row in enumerate(root):
        found.append((right[i] - sum(row[k] * found[k] for k in range(i))) / row[i])
    return np.array(found)


def _solved_transposed(root: list[list[Floats]], right: Floats) -> Floats:
    """Return x with root' x = right, shape (k, n)."""
    found = np.empty_like(right)
    for i in reversed(range(len(root))):
        later = sum(root[k][i] * found[k] for k in range(i + 1, len(root)))
        found[i] = (right[i] - later) / root[i][i]
    return found
