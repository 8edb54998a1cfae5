"""Where a golfer's shots go: the distribution of deliveries carried through impact and flight by sampling."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from clubface.design.dispersion.hitting import Hitting
from clubface.design.dispersion.tally import FLOWN, LAUNCHED, Tally, forward
from clubface.design.golfer.golfer import Golfer
from clubface.design.golfer.golfers import club_of, golfer as golfer_named
from clubface.design.strokes import AT_REST, Hole
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError, RangeWarning, Told
from clubface.reports.quantity_units import SHOWN
from clubface.simulation.impact import Parameters
from clubface.simulation.outside import Tally as RangeTally
from clubface.support.arrays import Floats
from clubface.support.checks import MOST_SEED, check_count, check_share
from clubface.support.warning import warn_once
from clubface.units import from_si

CHUNK = 2**16
"""Shots in memory at a time."""
DRAWN = 2**11
"""Shots whose landings are kept for pictures: the first."""
MOST = 2**32
COUNT = 2**14
SHARES = (0.5, 0.9)
"""What the landing ellipses hold of the shots unless told otherwise."""


class Ellipse(NamedTuple):
    """The ellipse, of the shape of the covariance of the landings, that holds a share of them.

    Attributes
    ----------
    share
        The share of the landings inside.
    centre
        Mean landing [m], ahead and to the right, shape (2,).
    half_axes
        Half the long and the short axis [m], shape (2,).
    angle
        From the target line to the long axis, to the right [rad].
    """

    share: float
    centre: Floats
    half_axes: Floats
    angle: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Dispersion:
    """Where the shots of a golfer go, SI and radians.

    Attributes
    ----------
    golfer, club, ball, model
        Who hits what, and what computed it.
    seed
        Of the quasi-random numbers.
    tally
        Means, spreads and quantiles of what launches and flights give, over the shots with a result.
    mean_shot
        What the mean delivery gives, by quantity [SI].
    hole
        The hole that strokes are counted on, or None.
    strokes
        Strokes expected after the shot, on average over the shots; NaN without a hole.
    lies
        Share of the shots that come to rest on green, fairway, rough and as recovery; empty without a hole.
    points
        The first landings [m], ahead and to the right, shape (n, 2), for pictures.
    reasons
        Why shots have no result, by the input at fault: one reason each, from the first shots that have none.
    """

    golfer: Golfer
    club: Club
    ball: Ball
    model: str
    seed: int
    tally: Tally
    mean_shot: Mapping[str, float]
    hole: Hole | None
    strokes: float
    lies: Mapping[str, float]
    points: Floats
    reasons: Mapping[str, str]

    def __repr__(self) -> str:
        lost = f", {self.lost} without a result" * bool(self.lost)
        lines = [f"{self.count} shots of {self.golfer.name} with {self.club.name} by {self.model}{lost}"]
        for name in self.quantities:
            unit, digits = SHOWN[name]
            values = (f"{from_si(each, unit):.{digits}f}" for each in (self.mean(name), self.spread(name)))
            lines.append(f"  {name:<12} {' ± '.join(values)} {unit}")
        if self.hole is not None:
            lines.append(f"  {'strokes':<12} {self.strokes:.3f} after the shot")
        return "\n".join(lines)

    @property
    def quantities(self) -> tuple[str, ...]:
        """The quantities counted."""
        return tuple(self.tally.scales)

    @property
    def count(self) -> int:
        """The number of shots, those without a result among them."""
        return self.tally.shots

    @property
    def lost(self) -> int:
        """The number of shots without a result, such as those that miss the face."""
        return self.tally.lost

    def mean(self, name: str) -> float:
        """Return the mean of a quantity."""
        return self.tally.mean(name)

    def spread(self, name: str) -> float:
        """Return the standard deviation of a quantity."""
        return self.tally.spread(name)

    def quantile(self, name: str, share: float) -> float:
        """Return the value below which a share of the shots lies."""
        return self.tally.quantile(name, share)

    @property
    def gained(self) -> float:
        """Strokes gained by the shot on the PGA Tour's average: expected before, less expected after and the shot."""
        return self.hole.before() - self.strokes - 1.0 if self.hole is not None else float("nan")

    def ellipse(self, share: float) -> Ellipse:
        """Return the ellipse of the landings that holds a share of them."""
        check_share(share)
        if not self.points.size:
            raise InputError("share", share, "asked of shots that fly and come down")
        centre, covariance = self.tally.landing()
        # The squares of the map spread evenly within themselves.
        covariance = covariance + 1e-12 * np.eye(2)
        middles, counts = self.tally.cells()
        away = middles - centre
        distance = np.sqrt(np.einsum("ni,ij,nj->n", away, np.linalg.inv(covariance), away))
        order = np.argsort(distance, kind="stable")
        reached = np.cumsum(counts[order]) - 0.5 * counts[order]
        size = float(np.interp(share * counts.sum(), reached, distance[order]))
        values, vectors = np.linalg.eigh(covariance)
        long = vectors[:, 1] * (1.0 if vectors[0, 1] >= 0.0 else -1.0)
        return Ellipse(share, centre, size * np.sqrt(values[::-1]), float(np.arctan2(long[1], long[0])))


def dispersion(
    golfer: str | os.PathLike[str] | Golfer,
    club: str | os.PathLike[str] | Club | None = None,
    *,
    count: int = COUNT,
    seed: int = 0,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    air: Any = None,
    wind: Any = None,
    ground: str | Mapping[str, Any] | None = None,
    flight: bool = True,
    hole: Hole | None = None,
    threads: int | None = None,
    accuracy: float | None = None,
    each: Callable[[Mapping[str, Floats], Mapping[str, Floats]], object] | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Dispersion:
    """Hit a golfer's shots and sum up where they go.

    Memory does not grow with the number of shots, and the same seed gives the same shots whatever their number.

    Parameters
    ----------
    golfer
        A shipped golfer's name, the path of a TOML file, or a :class:`Golfer`. For a club of the other hand the golfer
        is mirrored.
    club
        As for :func:`impact`; left out, that of the golfer, of the golfer's hand.
    count
        How many shots; powers of two cover the distribution most evenly.
    seed
        Another seed gives other shots.
    model, parameters, ball, accuracy, threads
        As for :func:`impact`.
    air, wind, ground
        As for :func:`fly`.
    flight
        Whether the balls fly; without, launches alone are counted.
    hole
        A :class:`Hole` on which strokes are counted, or None.
    each
        Called with the deliveries of some shots and what came of them, by name in SI units, chunk after chunk.
    progress
        Called with the number of shots done and that of all.
    """
    count, seed = check_count("count", count, 1, MOST), check_count("seed", seed, 0, MOST_SEED)
    of_golfer = golfer_named(golfer)
    of_club = club_named(club_of(of_golfer)).replace(hand=of_golfer.hand) if club is None else club_named(club)
    of_golfer = of_golfer.for_hand(of_club.hand)
    if hole is not None and not isinstance(hole, Hole):
        raise InputError("hole", hole, 'a Hole, as in Hole(length="430 yd")')
    for name, value in (("hole", hole), ("air", air), ("wind", wind), ("ground", ground)):
        if not flight and value is not None and not (isinstance(value, Mapping) and not value):
            raise InputError(name, Told("given"), "left out where the balls do not fly")
    hit = Hitting(of_club, model, parameters, ball, air, wind, ground, flight, threads, accuracy)
    launch, mean_shot = hit.mean(of_golfer)
    tally = Tally({**LAUNCHED, **(FLOWN if flight else {})}, mean_shot)
    strokes, points, reasons = 0.0, [], {}
    lies: dict[str, int] = dict.fromkeys(AT_REST, 0)
    outside = RangeTally()
    for start in range(0, count, CHUNK):
        some = min(CHUNK, count - start)
        deliveries = of_golfer.sample(some, seed=seed, start=start)
        values = hit(deliveries, reasons, outside)
        tally.add(values)
        if each is not None:
            each(deliveries, values)
        if flight:
            if start < DRAWN:
                points.append(_landings(values["carry"][: DRAWN - start], values["side"][: DRAWN - start]))
            if hole is not None:
                strokes += _count_strokes(hole, values, lies)
        if progress is not None:
            progress(start + some, count)
    if tally.counted == 0:
        raise InputError("golfer", of_golfer.name, f"one whose shots have a result: {next(iter(reasons.values()))}")
    if remark := outside.remark():
        warn_once(remark, RangeWarning)
    return Dispersion(
        golfer=of_golfer, club=of_club, ball=launch.ball, model=model, seed=seed, tally=tally, mean_shot=mean_shot,
        hole=hole, strokes=strokes / tally.counted if hole is not None else float("nan"),
        lies={name: number / tally.counted for name, number in lies.items()} if hole is not None else {},
        points=np.concatenate(points) if points else np.empty((0, 2)), reasons=reasons,
    )  # fmt: skip


def _landings(carry: Floats, side: Floats) -> Floats:
    found = np.stack([forward(carry, side), side], axis=1)
    return found[np.isfinite(found).all(axis=1)]


def _count_strokes(hole: Hole, values: Mapping[str, Floats], lies: dict[str, int]) -> float:
    """Return the sum of the strokes expected after the shots with a result, and count their lies."""
    kept = np.isfinite(values["carry"])
    ahead, aside = forward(values["total"][kept], values["total_side"][kept]), values["total_side"][kept]
    names, counts = np.unique(hole.lies(ahead, aside), return_counts=True)
    for name, number in zip(names, counts, strict=True):
        lies[str(name)] += int(number)
    return float(hole.after(ahead, aside).sum())
