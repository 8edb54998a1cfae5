"""Quantities anywhere on a face: computed there, or interpolated where a model takes too long for that."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from clubface.design.comparison.quantities import QUANTITIES
from clubface.design.face_map.outline import Outline
from clubface.design.face_map.shots import Struck
from clubface.errors import RunError

ZOOMS = 4
"""Times that the neighbourhood of the greatest value is looked at more closely, each time by ``CLOSER``."""
CLOSER = 5.0
AROUND = 11
"""Points along a side of such a neighbourhood."""
PARTS = 8
"""Into which each side of a cell is cut to measure an area, of a grid of ``FINE`` points or fewer."""
FINE = 101
"""Points along a side of the grid on which an area is measured, at least."""


class Surface(Protocol):
    """What is known of a face beyond the points of a grid.

    Attributes
    ----------
    interpolated
        Whether it is interpolated between the points of the grid.
    outline
        The outline of the face.
    """

    interpolated: bool
    outline: Outline

    def at(self, toe: NDArray[Any], high: NDArray[Any]) -> NDArray[Any]:
        """Return the quantities [SI] at points of the face [m], shape (quantities, points)."""
        ...

    def greatest(self, quantity: int) -> tuple[float, float, float]:
        """Return the point [m] where a quantity is greatest, and its value there [SI].

        The neighbourhood of the greatest value of the box is looked at more and more closely.
        """
        toe, high, table = self.box()
        values = np.where(self.outline.holds(*np.meshgrid(toe, high)), table[quantity], np.nan)
        return _greatest(self, quantity, self.outline, toe, high, values)

    def area(self, quantity: int, least: float) -> float:
        """Return the area [m2] of the face on which a quantity is at least so great."""
        ...

    def box(self) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """Return places towards the toe and upwards [m], and the quantities over the whole box around the face.

        The last have the shape (quantities, high, toe) and reach beyond the outline, so that it can be cut sharply.
        """
        ...


class Computed(Surface):
    """A face on which every point can be computed at once."""

    interpolated = False

    def __init__(
        self, struck: Struck, outline: Outline, toe: NDArray[Any], high: NDArray[Any], table: NDArray[Any]
    ) -> None:
        self._struck, self.outline, self._toe, self._high = struck, outline, toe, high
        self._table = table.reshape(len(QUANTITIES), len(high), len(toe))

    def at(self, toe: NDArray[Any], high: NDArray[Any]) -> NDArray[Any]:
        """Return the quantities at points of the face."""
        return self._struck.at(toe, high)

    def area(self, quantity: int, least: float) -> float:
        """Measure it between the points of the grid, or of a finer one where that is coarse."""
        if min(len(self._toe), len(self._high)) >= FINE:
            return _area(self.outline, self._toe, self._high, self._table[quantity], least)
        toe, high = _fine(self.outline)
        values = self.at(*(each.reshape(-1) for each in np.meshgrid(toe, high)))[quantity]
        return _area(self.outline, toe, high, values.reshape(len(high), len(toe)), least)

    def box(self) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """Return the grid."""
        return self._toe, self._high, self._table


class Interpolated(Surface):
    """A face of which some points are known: radial basis functions through them (cubic, about a parabola)."""

    interpolated = True

    def __init__(self, outline: Outline, toe: NDArray[Any], high: NDArray[Any], table: NDArray[Any]) -> None:
        from scipy.interpolate import RBFInterpolator

        self.outline = outline
        across, up = (each.reshape(-1) for each in np.meshgrid(toe, high))
        known = np.isfinite(table).all(axis=0)
        self._scale = (outline.greatest - outline.least) / 2.0
        places = np.stack([across[known], up[known]], axis=1) / self._scale
        try:
            self._through = RBFInterpolator(places, table[:, known].T, kernel="cubic", degree=2)
        except (ValueError, np.linalg.LinAlgError):
            told = f"{known.sum()} points of the face with a shot are too few to draw a map through them"
            raise RunError(f"{told}; give a finer grid") from None
        self._toe, self._high = _fine(outline)
        fine = [each.reshape(-1) for each in np.meshgrid(self._toe, self._high)]
        self._fine = self.at(*fine).reshape(len(QUANTITIES), FINE, FINE)

    def at(self, toe: NDArray[Any], high: NDArray[Any]) -> NDArray[Any]:
        """Return the quantities at points of the face."""
        return self._through(np.stack([toe, high], axis=1) / self._scale).T

    def area(self, quantity: int, least: float) -> float:
        """Measure it on a fine grid."""
        toe, high, table = self.box()
        return _area(self.outline, toe, high, table[quantity], least)

    def box(self) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """Return a fine grid."""
        return self._toe, self._high, self._fine


def surface_of(
    struck: Struck, outline: Outline, toe: NDArray[Any], high: NDArray[Any], table: NDArray[Any]
) -> Computed | Interpolated:
    """Return the surface of which ``table``, shape (quantities, points of the grid), is known."""
    if struck.takes_long:
        return Interpolated(outline, toe, high, table)
    return Computed(struck, outline, toe, high, table)


def _fine(outline: Outline) -> list[NDArray[Any]]:
    """Return places towards the toe and upwards [m] over the box around a face."""
    return [np.linspace(*ends, FINE) for ends in zip(outline.least, outline.greatest, strict=True)]


def _greatest(
    surface: Surface, quantity: int, outline: Outline, toe: NDArray[Any], high: NDArray[Any], values: NDArray[Any]
) -> tuple[float, float, float]:
    if not np.isfinite(values).any():
        raise RunError("no point of the face has a shot")
    up, across = np.unravel_index(np.nanargmax(values), values.shape)
    point, best = (float(toe[across]), float(high[up])), float(values[up, across])
    reach = (
        np.array([np.ptp(toe) / (len(toe) - 1), np.ptp(high) / (len(high) - 1)])
        if len(toe) > 1 < len(high)
        else np.zeros(2)
    )
    for _ in range(ZOOMS):
        near = [np.linspace(middle - width, middle + width, AROUND) for middle, width in zip(point, reach, strict=True)]
        across, up = (each.reshape(-1) for each in np.meshgrid(*near))
        inside = outline.holds(across, up)
        found = np.where(inside, surface.at(across, up)[quantity], np.nan) if inside.any() else np.array([np.nan])
        if np.isfinite(found).any() and np.nanmax(found) > best:
            place = int(np.nanargmax(found))
            point, best = (float(across[place]), float(up[place])), float(found[place])
        reach = reach / CLOSER
    return (*point, best)


def _area(outline: Outline, toe: NDArray[Any], high: NDArray[Any], values: NDArray[Any], least: float) -> float:
    """Return the area on which values over a grid, linear in between, are at least so great."""
    if len(toe) < 2 or len(high) < 2:
        return 0.0
    # Of a fine grid the cells are small enough, and their parts would take a lot of memory.
    parts = max(1, PARTS * FINE // max(values.shape))
    share = (np.arange(parts) + 0.5) / parts
    fine_toe = (toe[:-1, None] + share * np.diff(toe)[:, None]).reshape(-1)
    fine_high = (high[:-1, None] + share * np.diff(high)[:, None]).reshape(-1)
    between = values[:, :-1, None] * (1.0 - share) + values[:, 1:, None] * share
    between = between.reshape(len(high), -1)
    whole = between[:-1, None] * (1.0 - share[:, None]) + between[1:, None] * share[:, None]
    whole = whole.reshape(-1, between.shape[1])
    cells = np.outer(np.repeat(np.diff(high), parts), np.repeat(np.diff(toe), parts)) / parts**2
    inside = outline.holds(fine_toe[None, :], fine_high[:, None])
    return float(cells[inside & (whole >= least)].sum())
