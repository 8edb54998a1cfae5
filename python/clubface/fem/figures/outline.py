"""The section of a head of shells through the plane of the picture."""

from __future__ import annotations

from typing import Any

import numpy as np

from clubface.fem.heads import ShellHead


class Outline:
    """Where the plane z = 0 cuts the shells of a head, in the axes of first touch.

    The cut is found in the shape of first touch and goes through the same material at all times.
    """

    def __init__(self, head: ShellHead, places: Any) -> None:
        quads = head.quads.astype(int)
        starts, ends = quads, np.roll(quads, -1, axis=1)
        low, high = places[starts, 2], places[ends, 2]
        # A node on the plane belongs to the side below, so that every cut has two ends.
        crossed = (low > 0.0) != (high > 0.0)
        cut = crossed.sum(axis=1) == 2
        sides = np.argsort(~crossed[cut], axis=1, kind="stable")[:, :2]
        self._ends = tuple(np.take_along_axis(each[cut], sides, axis=1) for each in (starts, ends))
        low, high = (np.take_along_axis(each[cut], sides, axis=1) for each in (low, high))
        self._share = (low / (low - high))[..., None]
        self.thickness = head.thickness[cut]

    def at(self, places: Any) -> Any:
        """Return the cuts as segments, (n, 2, 3) [m], for the places of the nodes."""
        first, second = (places[each] for each in self._ends)
        return first + self._share * (second - first)
