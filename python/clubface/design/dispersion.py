"""Where a golfer's shots go: deliveries taken through impact and flight, tallied, and written to files.

Memory does not grow with the number of shots: only moments, fine histograms and a map of the landings are kept.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import _core as core
from clubface.design.golfer import Golfer, golfer as golfer_named, own_club
from clubface.design.strokes import AT_REST, Hole
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError, RangeWarning, ShotError, Wording
from clubface.quantities import quantity
from clubface.results.result import Described, Result
from clubface.shots.tables.headings import heading_of, shot_words
from clubface.shots.tables.writer import columns_file
from clubface.simulation.flight import AirLike, Flight, GroundLike, WindLike, fly
from clubface.simulation.impact import Parameters, Tally as RangeTally, impact
from clubface.simulation.inputs import DeliveryLike, thread_count
from clubface.simulation.launch import Launch
from clubface.support.arrays import Floats
from clubface.support.checks import MOST_SEED, check_choice, check_count, check_share, warn_once, without_warnings
from clubface.units import SI_UNITS, from_si

Sink = Callable[[Mapping[str, Floats], Mapping[str, Floats]], None]
"""Takes the deliveries of a chunk and the results."""


@contextmanager
def shots_file(path: str | os.PathLike[str], *, seed: int = 0) -> Iterator[Sink]:
    """Open a file for shots; it appears under its name, complete, only when the block ends without an error.

    Columns carry their units. A shot without a result has empty cells (nulls in Parquet). Successive quasi-random shots
    differ more than random ones, so rows are shuffled within each chunk by ``seed``; statistics that depend on their
    order, such as drift, then look like those of a real session.
    """
    random, dimensions = np.random.default_rng(seed), shot_words().dimensions
    with columns_file(Path(path)) as write:

        def take(deliveries: Mapping[str, Floats], values: Mapping[str, Floats]) -> None:
            columns, order = {}, random.permutation(len(next(iter(deliveries.values()))))
            for name, numbers in {**deliveries, **values}.items():
                heading, unit = heading_of(name, SI_UNITS[dimensions[name]])
                columns[heading] = from_si(np.asarray(numbers), unit)[order]
            write(columns)

        yield take


Counts = NDArray[np.int64]


class Scale(NamedTuple):
    """Histogram of a quantity: range [SI] and number of bins. Values beyond the range go into the end bins."""

    least: float
    most: float
    bins: int


_QUANTITIES, _LAUNCHED = core.dispersion_quantities()
SCALES = {name: Scale(least, most, bins) for name, least, most, bins in _QUANTITIES}
LAUNCHED, FLOWN = dict([*SCALES.items()][:_LAUNCHED]), dict([*SCALES.items()][_LAUNCHED:])
"""Quantities counted for launches (bins of 0.005 m/s, 0.005 degrees, 0.1 rad/s or 1 rpm) and flights (2 cm)."""
LANDING = ("carry", "side")
"""The quantities that make a landing; a shot without a carry is lost."""


class ShotTally:
    """Counts of shots; a shot with NaN counts as lost.

    ``scales`` sets the bins of each quantity; ``centre`` gives a value near each mean, about which moments are summed.
    The counts do not depend on the number of ``threads`` (None: one per core).
    """

    def __init__(self, scales: Mapping[str, Scale], centre: Mapping[str, float], threads: int | None = None) -> None:
        self.scales = scales
        self._threads = thread_count(threads)
        names = list(scales)
        landing = [names.index(each) for each in LANDING] if "carry" in scales else None
        self._counts = core.ShotTally(
            [(each.least, each.most, each.bins, centre[name]) for name, each in scales.items()], landing
        )

    @property
    def shots(self) -> int:
        """Number of shots, including lost ones."""
        return self._counts.shots

    @property
    def lost(self) -> int:
        """Number of shots without a result."""
        return self._counts.lost

    @property
    def counted(self) -> int:
        """Number of shots with a result."""
        return self.shots - self.lost

    def add(self, values: Mapping[str, Floats]) -> None:
        """Count shots; each quantity has the shape (n,)."""
        self._counts.add([np.ascontiguousarray(values[name]) for name in self.scales], self._threads)

    def mean(self, name: str) -> float:
        """Return the mean of a quantity."""
        return self._counts.mean(self._place(name))

    def spread(self, name: str) -> float:
        """Return the standard deviation of a quantity."""
        return self._counts.spread(self._place(name))

    def quantile(self, name: str, share: float) -> float:
        """Return the value below which the ``share`` of the shots lies, interpolated within a bin."""
        check_share(share)
        return self._counts.quantile(self._place(name), share)

    def histogram(self, name: str, width: float) -> tuple[Floats, Counts]:
        """Return edges [SI] and counts of bins about ``width`` wide, from the smallest value to the largest."""
        edges, counts = self._counts.histogram(self._place(name), width)
        return edges, counts.astype(np.int64)

    def ellipse(self, share: float) -> Ellipse:
        """Return the ellipse that contains a share of the landings."""
        check_share(share)
        centre, half_axes, angle = self._counts.ellipse(share)
        return Ellipse(share, np.array(centre), np.array(half_axes), angle)

    def _place(self, name: str) -> int:
        check_choice("quantity", name, self.scales)
        return list(self.scales).index(name)


def forward(distance: Floats, side: Floats) -> Floats:
    """Return the distance along the target line [m] from the distance to the tee and the offset from the line."""
    return np.sqrt(np.maximum(distance**2 - side**2, 0.0))


class ImpactSetup(NamedTuple):
    """Equipment, model and conditions of shots; called with deliveries, it returns the quantities by name.

    Each has the shape (n,), with NaN for a lost shot.
    """

    club: Club
    model: str
    parameters: Any = None
    ball: Any = None
    air: AirLike | None = None
    wind: WindLike | None = None
    ground: GroundLike | None = None
    flight: bool = True
    threads: int | None = None
    accuracy: float | None = None

    def mean(self, golfer: Golfer) -> tuple[Launch, dict[str, float]]:
        """Return launch and quantities [SI] of the mean delivery; an error with the reason if it has no result."""
        try:
            launch, flight = self.strike(golfer.delivery(), "raise")
        except ShotError as error:
            if error.parameter not in golfer.variables:
                raise
            # On its own the name would look like an option, such as the lie from which a shot is played.
            raise InputError("golfer", golfer.name, f"one whose mean shot can be computed: {error}") from None
        return launch, {name: float(value) for name, value in _values(launch, flight).items()}

    def __call__(
        self,
        deliveries: Mapping[str, Floats],
        reasons: dict[str, str] | None = None,
        outside: RangeTally | None = None,
    ) -> dict[str, Floats]:
        """Hit shots; ``reasons`` collects why some have no result, ``outside`` those outside the model's range."""
        launch, flight = self.strike(deliveries)
        if outside is not None:
            outside.add(launch)
        if reasons is not None and not reasons:
            for problem in (launch if flight is None else flight).problems:
                reasons.setdefault(problem.parameter, problem.reason)
        return _values(launch, flight)

    def strike(
        self,
        deliveries: DeliveryLike,
        on_error: Literal["raise", "nan"] = "nan",
        progress: Callable[[int], object] | None = None,
    ) -> tuple[Launch, Flight | None]:
        """Return launches and, if the balls fly, flights, without range warnings."""
        with without_warnings(RangeWarning):  # the caller warns once for all shots
            launch = impact(
                self.club, deliveries, model=self.model, parameters=self.parameters, ball=self.ball,
                threads=self.threads, accuracy=self.accuracy, on_error=on_error, progress=progress,
            )  # fmt: skip
        conditions = {"air": self.air, "wind": self.wind, "ground": self.ground}
        return launch, fly(launch, **conditions, threads=self.threads, on_error=on_error) if self.flight else None


def _values(launch: Launch, flight: Flight | None) -> dict[str, Floats]:
    values = {name: getattr(launch, name) for name in LAUNCHED}
    return values if flight is None else values | {name: getattr(flight, name) for name in FLOWN}


CHUNK = 2**16
"""Maximum number of shots held in memory."""
DRAWN = 2**11
"""Number of landings kept for pictures, from the first shots."""
MOST = 2**32
COUNT = 2**14
SHARES = (0.5, 0.9)
"""Default shares of the shots inside the landing ellipses."""


class Ellipse(NamedTuple):
    """The ellipse, shaped like the covariance of the landings, that contains a share of them.

    Attributes
    ----------
    share
        The share of the landings inside.
    centre, half_axes
        Mean landing, ahead and to the right, and half the long and the short axis [m], each of shape (2,).
    angle
        Angle from the target line to the long axis, positive to the right [rad].
    """

    share: float
    centre: Floats
    half_axes: Floats
    angle: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Dispersion(Described):
    """Where a golfer's shots go, in SI units and radians.

    Attributes
    ----------
    golfer, club, ball, model, seed
        Golfer, equipment, impact model, and seed of the quasi-random numbers.
    tally
        Means, spreads and quantiles of launch and flight, over the shots with a result.
    mean_shot
        Quantities of the mean delivery, by name [SI].
    hole, strokes
        The hole on which strokes are counted, or None; mean strokes expected after the shot, NaN without a hole.
    lies
        Share of the shots that come to rest on the green, on the fairway, in the rough and as recovery; empty without a
        hole.
    points
        The first landings [m], ahead and to the right, shape (n, 2), for pictures.
    reasons
        Why shots have no result: one reason per input at fault, from the first such shots.
    mean_launch
        The launch of the mean delivery.
    conditions
        Air, wind and ground of the flights.
    """

    golfer: Golfer
    club: Club
    ball: Ball
    model: str
    seed: int
    tally: ShotTally
    mean_shot: Mapping[str, float]
    hole: Hole | None
    strokes: float
    lies: Mapping[str, float]
    points: Floats
    reasons: Mapping[str, str]
    mean_launch: Launch
    conditions: Mapping[str, Any]

    def __repr__(self) -> str:
        lost = f", {self.lost} without a result" * bool(self.lost)
        lines = [f"{self.count} shots of {self.golfer.name} with {self.club.name} by {self.model}{lost}"]
        for name in self.quantities:
            unit, digits = quantity(name).golf
            values = (f"{from_si(each, unit):.{digits}f}" for each in (self.mean(name), self.spread(name)))
            lines.append(f"  {name:<12} {' ± '.join(values)} {unit}")
        if self.hole is not None:
            lines.append(f"  {'strokes':<12} {self.strokes:.3f} after the shot")
        return "\n".join(lines)

    @property
    def quantities(self) -> tuple[str, ...]:
        """Names of the quantities counted."""
        return tuple(self.tally.scales)

    @property
    def count(self) -> int:
        """Number of shots, including those without a result."""
        return self.tally.shots

    @property
    def lost(self) -> int:
        """Number of shots without a result, such as those that miss the face."""
        return self.tally.lost

    def mean(self, name: str) -> float:
        """Return the mean of a quantity."""
        return self.tally.mean(name)

    def spread(self, name: str) -> float:
        """Return the standard deviation of a quantity."""
        return self.tally.spread(name)

    def quantile(self, name: str, share: float) -> float:
        """Return the value below which a ``share`` of the shots lies."""
        return self.tally.quantile(name, share)

    @property
    def gained(self) -> float:
        """Strokes gained on the PGA Tour average: expected before the shot, minus expected after it, minus 1."""
        return self.hole.before() - self.strokes - 1.0 if self.hole is not None else float("nan")

    def to_result(self) -> Result:
        """Return the dispersion as a result; :func:`dispersion_result` can add the causes of the spread."""
        from clubface.design.dispersion_result import dispersion_result

        return dispersion_result(self)

    def ellipse(self, share: float) -> Ellipse:
        """Return the ellipse that contains a share of the landings."""
        if not self.points.size:
            raise InputError("share", share, "left out, because the balls do not fly")
        return self.tally.ellipse(share)


def dispersion(
    golfer: str | os.PathLike[str] | Golfer,
    club: str | os.PathLike[str] | Club | None = None,
    *,
    count: int = COUNT,
    seed: int = 0,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    flight: bool = True,
    hole: Hole | None = None,
    threads: int | None = None,
    accuracy: float | None = None,
    each: Callable[[Mapping[str, Floats], Mapping[str, Floats]], object] | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Dispersion:
    """Hit a golfer's shots and summarise where they go.

    Memory does not grow with the number of shots, and a seed gives the same first shots whatever the count.

    Parameters
    ----------
    golfer
        A shipped golfer's name, the path of a TOML file, or a :class:`Golfer`. The golfer is mirrored for a club of the
        other hand.
    club
        As for :func:`impact`; default the golfer's own club, for the golfer's hand.
    count, seed
        Number of shots (powers of two cover the distribution most evenly), and seed of their quasi-random numbers.
    model, parameters, ball, accuracy, threads, air, wind, ground
        As for :func:`impact` and :func:`fly`.
    flight
        Whether the balls fly; otherwise only launches are counted.
    hole
        A :class:`Hole` on which strokes are counted, or None.
    each
        Called for every chunk with its deliveries and results, by name in SI units.
    progress
        Called with the number of shots done and the total.
    """
    count, seed = check_count("count", count, 1, MOST), check_count("seed", seed, 0, MOST_SEED)
    player = golfer_named(golfer)
    club_used = own_club(player) if club is None else club_named(club)
    player = player.for_hand(club_used.hand)
    if hole is not None and not isinstance(hole, Hole):
        raise InputError("hole", hole, 'a Hole, as in Hole(length="430 yd")')
    for name, value in (("hole", hole), ("air", air), ("wind", wind), ("ground", ground)):
        if not flight and value is not None and not (isinstance(value, Mapping) and not value):
            raise InputError(name, Wording("given"), "left out if the balls do not fly")
    setup = ImpactSetup(club_used, model, parameters, ball, air, wind, ground, flight, threads, accuracy)
    launch, mean_shot = setup.mean(player)
    tally = ShotTally({**LAUNCHED, **(FLOWN if flight else {})}, mean_shot, threads)
    strokes, lies, points, reasons = 0.0, dict.fromkeys(AT_REST, 0), [], {}
    outside = RangeTally()
    for start in range(0, count, CHUNK):
        some = min(CHUNK, count - start)
        deliveries = player.sample(some, seed=seed, start=start, threads=threads)
        values = setup(deliveries, reasons, outside)
        tally.add(values)
        if each is not None:
            each(deliveries, values)
        if flight:
            if start < DRAWN:
                carry, side = (values[name][: DRAWN - start] for name in LANDING)
                landings = np.stack([forward(carry, side), side], axis=1)
                points.append(landings[np.isfinite(landings).all(axis=1)])
            if hole is not None:
                kept = np.isfinite(values["carry"])
                total, right = values["total"][kept], values["total_side"][kept]
                names, expected = hole.at_rest(forward(total, right), right)
                strokes += float(expected.sum())
                lies = {name: number + int((names == name).sum()) for name, number in lies.items()}
        if progress is not None:
            progress(start + some, count)
    if tally.counted == 0:
        raise InputError("golfer", player.name, f"one whose shots can be computed: {next(iter(reasons.values()))}")
    if remark := outside.remark():
        warn_once(remark, RangeWarning)
    return Dispersion(
        golfer=player, club=club_used, ball=launch.ball, model=model, seed=seed, tally=tally, mean_shot=mean_shot,
        hole=hole, strokes=strokes / tally.counted if hole is not None else float("nan"),
        lies={name: number / tally.counted for name, number in lies.items()} if hole is not None else {},
        points=np.concatenate(points) if points else np.empty((0, 2)), reasons=reasons, mean_launch=launch,
        conditions={"air": air, "wind": wind, "ground": ground},
    )  # fmt: skip
