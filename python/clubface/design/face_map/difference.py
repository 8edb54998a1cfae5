"""One face less another: what a change of the club does at each point."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.design.comparison.quantities import QUANTITIES, symbol
from clubface.design.face_map.face_map import FaceMap, on_face
from clubface.errors import InputError, Told
from clubface.support.checks import check_choice


class FaceMapDifference:
    """The map of one face less that of another, over the points they share.

    Attributes
    ----------
    first, second
        The maps; the second is taken from the first.
    toe, high
        The points of the grid [m].
    outline
        That of the first face.
    """

    def __init__(self, first: FaceMap, second: FaceMap) -> None:
        for name, each in (("first", first), ("second", second)):
            if not isinstance(each, FaceMap):
                raise InputError(name, each, "a map, as of clubface.map_face")
        if not (np.array_equal(first.toe, second.toe) and np.array_equal(first.high, second.high)):
            told = Told("maps of other points")
            raise InputError("second", told, "a map of the points of the first: points=(first.toe, first.high)")
        self.first, self.second = first, second
        self.toe, self.high, self.outline = first.toe, first.high, first.outline

    def get(self, name: str, unit: str | None = None) -> NDArray[Any]:
        """Return the difference of a quantity over the grid, in SI or in ``unit``; NaN where either has no shot."""
        found = self.first.get(name) - self.second.get(name)
        return found if unit is None else found / units.size(symbol(name, unit))

    def box(self, name: str) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """Return what :meth:`FaceMap.box` does of the difference; NaN beside a second face of another outline."""
        check_choice("quantity", name, QUANTITIES)
        toe, high, values = self.first.box(name)
        across, up = np.meshgrid(toe, high)
        if self.second.interpolated:
            other = self.second.surface.at(across.reshape(-1), up.reshape(-1))[QUANTITIES.index(name)]
            other = other.reshape(values.shape)
        else:
            other = self.second.box(name)[2]
        found = values - other
        if not np.array_equal(self.outline.corners, self.second.outline.corners):
            found = np.where(self.second.outline.holds(across, up), found, np.nan)
        return toe, high, found

    def columns(self) -> dict[str, NDArray[Any]]:
        """Return a long table [SI]: ``toe``, ``high`` and the difference of every quantity, a row for each point."""
        return on_face(self)
