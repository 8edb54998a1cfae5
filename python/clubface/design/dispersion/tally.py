"""What any number of shots comes to in memory that does not grow: moments, fine histograms, a map of the landings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.support.arrays import Floats
from clubface.support.checks import check_choice, check_share

Counts = NDArray[np.int64]


class Scale(NamedTuple):
    """How a quantity is counted: from where to where [SI], in how many bins. What lies beyond is in the end bins."""

    least: float
    most: float
    bins: int


LAUNCHED = {
    "ball_speed": Scale(0.0, 125.0, 25_000),
    "launch": Scale(-np.pi / 2, np.pi / 2, 36_000),
    "azimuth": Scale(-np.pi / 2, np.pi / 2, 36_000),
    "backspin": Scale(-1500.0, 1500.0, 30_000),
    "sidespin": Scale(-1500.0, 1500.0, 30_000),
}
"""What is counted of launches: to 0.005 m/s, 0.005 degrees and 0.1 rad/s (1 rpm)."""
FLOWN = {
    "carry": Scale(0.0, 500.0, 25_000),
    "side": Scale(-250.0, 250.0, 25_000),
    "total": Scale(0.0, 500.0, 25_000),
    "total_side": Scale(-250.0, 250.0, 25_000),
}
"""What is counted of flights: to 2 cm."""
CELL = 0.5
"""Side of a square of the map of landings [m]."""
AHEAD, ASIDE = 1000, 800
"""Squares of the map, to the target from the tee on, and across, half of them on either side."""


@dataclass
class Tally:
    """Counts of shots; a shot with NaN is lost and counted as such.

    Attributes
    ----------
    scales
        How each quantity is counted.
    centre
        A value of each quantity near its mean, about which moments are summed.
    """

    scales: Mapping[str, Scale]
    centre: Mapping[str, float]

    def __post_init__(self) -> None:
        self.shots = 0
        self.lost = 0
        self._bins: dict[str, Counts] = {name: np.zeros(of.bins, dtype=np.int64) for name, of in self.scales.items()}
        self._sums = {name: np.zeros(2) for name in self.scales}
        self._map: Counts = np.zeros(AHEAD * ASIDE if "carry" in self.scales else 0, dtype=np.int64)
        self._landing = np.zeros(5)

    @property
    def counted(self) -> int:
        """The number of shots with a result."""
        return self.shots - self.lost

    def add(self, values: Mapping[str, Floats]) -> None:
        """Count shots, each quantity of shape (n,)."""
        first = next(iter(self.scales))
        last = "carry" if "carry" in self.scales else first
        found = np.isfinite(values[last])
        self.shots += len(found)
        self.lost += len(found) - int(found.sum())
        kept = {name: values[name] if found.all() else values[name][found] for name in self.scales}
        for name, of in self.scales.items():
            self._bins[name] += _counted(kept[name], of)
            away = kept[name] - self.centre[name]
            # No dot product: its sum may run in an order that threads decide.
            self._sums[name] += away.sum(), (away * away).sum()
        if "carry" in self.scales:
            ahead, aside = forward(kept["carry"], kept["side"]), kept["side"]
            row = np.clip(ahead / CELL, 0, AHEAD - 1).astype(np.int64)
            column = np.clip(aside / CELL + ASIDE // 2, 0, ASIDE - 1).astype(np.int64)
            self._map += np.bincount(row * ASIDE + column, minlength=AHEAD * ASIDE)
            x, y = ahead - self.centre["carry"], aside
            self._landing += x.sum(), y.sum(), (x * x).sum(), (x * y).sum(), (y * y).sum()

    def mean(self, name: str) -> float:
        """Return the mean of a quantity."""
        check_choice("quantity", name, self.scales)
        return self.centre[name] + float(self._sums[name][0]) / max(self.counted, 1)

    def spread(self, name: str) -> float:
        """Return the standard deviation of a quantity."""
        check_choice("quantity", name, self.scales)
        first, second = self._sums[name] / max(self.counted, 1)
        return float(np.sqrt(max(second - first**2, 0.0)))

    def quantile(self, name: str, share: float) -> float:
        """Return the value below which the ``share`` of the shots lies, to a part of a bin."""
        check_choice("quantity", name, self.scales)
        check_share(share)
        of = self.scales[name]
        return of.least + _crossing(self._bins[name], share) * (of.most - of.least) / of.bins

    def landing(self) -> tuple[Floats, Floats]:
        """Return mean [m], shape (2,), and covariance [m2], shape (2, 2), of the landings: ahead and to the right."""
        ahead, aside, xx, xy, yy = self._landing / max(self.counted, 1)
        covariance = np.array([[xx - ahead**2, xy - ahead * aside], [xy - ahead * aside, yy - aside**2]])
        return np.array([self.centre["carry"] + ahead, aside]), covariance

    def cells(self) -> tuple[Floats, Counts]:
        """Return the middles of the squares with landings [m], shape (n, 2), and how many lie in each, shape (n,)."""
        places = np.flatnonzero(self._map)
        middles = np.stack([places // ASIDE + 0.5, places % ASIDE - ASIDE // 2 + 0.5], axis=1)
        return np.multiply(CELL, middles, dtype=np.float64), self._map[places]

    def histogram(self, name: str, width: float) -> tuple[Floats, Counts]:
        """Return edges [SI] and counts of bins about ``width`` wide, from the least shot to the greatest."""
        of, counts = self.scales[name], self._bins[name]
        step = (of.most - of.least) / of.bins
        together = max(1, round(width / step))
        filled = np.flatnonzero(counts)
        first, last = (filled[0], filled[-1]) if len(filled) else (0, 0)
        starts = np.arange(first, last + 1, together)
        edges = np.append(starts, starts[-1] + together).astype(np.float64)
        return of.least + step * edges, np.add.reduceat(counts, starts).astype(np.int64)


def forward(distance: Floats, side: Floats) -> Floats:
    """Return how far to the target a ball is [m] that is so far from the tee and from the target line."""
    return np.sqrt(np.maximum(distance**2 - side**2, 0.0))


def _counted(values: Floats, of: Scale) -> Counts:
    place = np.clip((values - of.least) * (of.bins / (of.most - of.least)), 0, of.bins - 1).astype(np.int64)
    return np.bincount(place, minlength=of.bins)


def _crossing(counts: Counts, share: float) -> float:
    """Return where, in bins from the first, the sum of the counts reaches the share, evenly within a bin."""
    reached = np.cumsum(counts)
    wanted = share * reached[-1]
    place = int(np.searchsorted(reached, wanted))
    place = min(place, len(counts) - 1)
    before = reached[place] - counts[place]
    return place + (float((wanted - before) / counts[place]) if counts[place] else 0.5)
