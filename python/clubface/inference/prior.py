"""Priors of deliveries, and the measurements that they predict.

A prior gives means, spreads and correlations of a delivery before its launch is known.

A file may give any quantity of a delivery; the others are taken as known, zero or the static loft::

    title = "Members of our club"

    [spread]
    speed = ["95 mph", "8 mph"]          # mean, standard deviation
    attack = ["-1 deg", "3 deg"]
    loft = ["15 deg", "3 deg"]
    face = ["0 deg", "3 deg"]

    [[correlation]]
    of = ["loft", "attack"]
    value = 0.4

The expectation of a prior tells how surprising a measured shot is, and whether it is out of reach.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Self

import numpy as np

from clubface import units
from clubface.equipment.clubs import TOUR_CLUBS, Club, club as club_named
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError, UnknownNameError
from clubface.quantities import display_unit
from clubface.schema import TEXT, Document, Items, Place, Record, Table, Tables, decode, file_key
from clubface.shots.club_names import club_kind
from clubface.shots.measured import QUANTITIES
from clubface.simulation.inputs import DELIVERY_QUANTITIES, OF_CLUB, Correlation
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice, check_names
from clubface.support.files import is_path

NAMED = ("elite", "tour", "wide")
"""The built-in priors."""
WIDE = {
    "speed": "10 mph", "attack": "3.5 deg", "path": "4.5 deg", "loft": "4 deg", "face": "4 deg", "lie": "3 deg",
    "toe": "9 mm", "high": "7 mm", "closure": "600 deg/s", "pitch_rate": "400 deg/s", "lie_rate": "300 deg/s",
}  # fmt: skip
"""Standard deviations of the prior "wide" [SI]; assumed, about twice those of elite golfers, four times for speed."""
MIRRORED = ("path", "face")
"""Quantities that change sign for a left-handed club."""
TOUR = "pga-2019"
"""Tour averages of the prior "tour", the latest published with dynamic lofts."""
SLOWER = 0.87
"""Mean speed of the prior "wide" relative to the tour average; assumed."""


_EXAMPLE = 'a mean and a standard deviation, as in ["1 deg", "2 deg"]'


@dataclass(frozen=True, kw_only=True)
class PriorFile:
    """Schema of a prior file."""

    title: str = file_key(TEXT, "its name in reports")
    spread: Mapping[str, tuple[float, float]] = file_key(
        Record({name: Items(DELIVERY_QUANTITIES[name], 2, 2, _EXAMPLE) for name in OF_CLUB}, ("speed",)),
        "mean and standard deviation of what is uncertain",
    )
    correlation: tuple[Correlation, ...] = file_key(
        Tables(Table(Correlation)), "correlations of pairs; all others are independent", default=()
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class Prior:
    """A normal distribution of deliveries, in SI units; impacts outside the face are impossible.

    Attributes
    ----------
    name
        Name in reports.
    mean, deviation
        Mean and standard deviation of each quantity.
    correlations
        Correlations of pairs of quantities; all other pairs are independent.
    """

    name: str
    mean: Mapping[str, float]
    deviation: Mapping[str, float]
    correlations: Mapping[tuple[str, str], float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if list(self.mean) != list(self.deviation):
            allowed = f"given for the same quantities as the mean: {', '.join(self.mean)}"
            raise InputError("deviation", list(self.deviation), allowed)
        for name in self.mean:
            check_choice("quantity of a delivery", name, OF_CLUB)
        for part in ("mean", "deviation"):
            values = {name: units.parse(each, OF_CLUB[name], name=name) for name, each in getattr(self, part).items()}
            object.__setattr__(self, part, values)
        for name in self.mean:
            if not (np.isfinite(self.mean[name]) and self.deviation[name] > 0.0):
                raise InputError(name, self.deviation[name], "positive; leave out quantities that are known exactly")
        if "speed" not in self.mean:
            raise InputError("speed", None, "give it: it must be among the quantities of the prior")
        for pair, value in self.correlations.items():
            check_names("quantity of a correlation", pair, self.mean)
            value = units.parse(value, units.DIMENSIONLESS, name=f"correlation of {' and '.join(pair)}")
            if len(set(pair)) != 2 or not -1.0 < value < 1.0:
                raise InputError(f"correlation of {' and '.join(pair)}", value, "of two quantities, between -1 and 1")
        try:
            np.linalg.cholesky(self._matrix())
        except np.linalg.LinAlgError:
            given = ", ".join(f"{' and '.join(pair)} {value}" for pair, value in self.correlations.items())
            allowed = "consistent with each other, as in a positive definite matrix"
            raise InputError("correlations", given, allowed) from None

    @property
    def names(self) -> tuple[str, ...]:
        """The quantities that are uncertain."""
        return tuple(self.mean)

    def _matrix(self) -> Floats:
        places = {name: place for place, name in enumerate(self.mean)}
        matrix = np.eye(len(places))
        for (one, other), value in self.correlations.items():
            matrix[places[one], places[other]] = matrix[places[other], places[one]] = value
        return matrix

    def deliveries(self, standard: Floats) -> dict[str, Floats]:
        """Return the deliveries for standard normal deviates, shape (n, quantities)."""
        root = np.linalg.cholesky(self._matrix())
        scaled = standard @ root.T
        return {name: self.mean[name] + self.deviation[name] * scaled[:, place] for place, name in enumerate(self.mean)}

    def for_hand(self, hand: float) -> Self:
        """Return the prior for a club of the given hand, from this one for right-handers."""
        if hand > 0:
            return self
        return replace(self, mean={name: -each if name in MIRRORED else each for name, each in self.mean.items()})

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Self:
        """Read a prior from a TOML file."""
        document = Document.read(path)
        file = decode(PriorFile, document)
        with Place(document).errors():
            return cls(
                name=file.title,
                mean={name: each[0] for name, each in file.spread.items()},
                deviation={name: each[1] for name, each in file.spread.items()},
                correlations={each.pair: each.value for each in file.correlation},
            )


def prior_of(given: Prior | str | os.PathLike[str] | None, head: Club) -> Prior:
    """Return the prior given by name, file or object. Default: "elite" if it exists for the club, else "tour".

    Built-in priors are mirrored for a left-handed club, others are used as they are.
    """
    if isinstance(given, Prior):
        return given
    if given is None or given in NAMED:
        return _named_prior(given, head).for_hand(head.hand)
    if is_path(given):
        return Prior.from_toml(given)
    raise UnknownNameError("prior", given, (*NAMED, "the path of a TOML file"))


def _named_prior(given: Any, head: Club) -> Prior:
    from clubface.validation.benchmark_data import HEADS

    of_elite = {name: club for club, built_in in HEADS.items() for name in (club, built_in)}
    if given is None:
        given = "elite" if head.name in of_elite else "wide" if _is_without_averages(head.name) else "tour"
    if given == "elite":
        if head.name not in of_elite:
            allowed = f'"tour", "wide" or a file for {head.name}: "elite" exists only for {" and ".join(HEADS)}'
            raise InputError("prior", "elite", allowed)
        return elite(of_elite[head.name])
    return tour(head) if given == "tour" else wide(head)


def elite(club_name: str) -> Prior:
    """Return the prior from the benchmark shots of elite golfers, with driver or 7-iron."""
    from clubface.validation.benchmark_data import recipe

    golfers = recipe(club_name)
    return Prior(
        name=f"elite golfers, {club_name}",
        mean={name: each.mean for name, each in golfers.delivery.items()},
        deviation={name: float(np.hypot(each.between, each.within)) for name, each in golfers.delivery.items()},
        correlations={(name, leader): value for name, (leader, value) in golfers.follows.items()},
    )


def tour(head: Club) -> Prior:
    """Return the prior with published tour averages of a built-in club and the spreads of elite golfers.

    Speed, attack and dynamic loft are those published for 2019. For clubs without a published loft, it is the loft for
    which the default model gives the published launch angle. All other means and the spreads are those of the benchmark
    shots: of the driver for woods, of the 7-iron for other clubs.

    A club that is not in the tour averages but of a similar kind by its name uses that club's averages, with the
    dynamic loft increased by the difference of the static lofts.
    """
    name = _tour_club(head.name)
    if name is None or _is_without_averages(head.name):
        allowed = f'{_OTHERS[name]} for {head.name}: "tour" exists only for {", ".join(TOUR_CLUBS)}'
        raise InputError("prior", "tour", allowed)
    return _delivered_as(name, head)


def _delivered_as(name: str, head: Club) -> Prior:
    """Return the prior of a club of the tour averages, its loft shifted by the difference of static lofts."""
    from clubface.validation.tour import averages, published_lofts, solve_loft

    (average,) = (each for each in averages(TOUR) if each.club == name)
    base = elite("driver" if head.parameters == "driver" else "7-iron")
    loft = published_lofts(TOUR).get(name)
    if loft is None:
        loft = solve_loft(name, average.club_speed, average.attack, average.launch, model=DEFAULT_MODEL)
    loft += head.loft - club_named(name).loft
    published = {"speed": average.club_speed, "attack": average.attack, "loft": loft}
    return Prior(
        name=f"tour averages, {name}",
        mean={**base.mean, **published},
        deviation=base.deviation,
        correlations=base.correlations,
    )


WEDGE = "pitching-wedge"
"""Club whose averages the prior "wide" uses for wedges of more loft, for which none are published; assumed."""
_OTHERS = {None: "a file", WEDGE: '"wide" or a file'}


def _tour_club(name: str) -> str | None:
    """Return the club of the tour averages to use for a club of this name, or None if there is none."""
    kind = name if name in TOUR_CLUBS else club_kind(name)
    family = (kind or "").rpartition("-")[2]
    club = WEDGE if family == "wedge" else "hybrid" if family == "hybrid" else kind
    return club if club in TOUR_CLUBS else None


def _is_without_averages(name: str) -> bool:
    return _tour_club(name) == WEDGE and club_kind(name) != WEDGE


def wide(head: Club) -> Prior:
    """Return the prior of golfers of any skill: slower than the tour, with about twice the spreads."""
    name = _tour_club(head.name)
    base = tour(head) if name is None else _delivered_as(name, head)
    return Prior(
        name=base.name.replace("tour averages", "golfers of any skill"),
        mean={**base.mean, "speed": SLOWER * base.mean["speed"]},
        deviation={name: units.parse(WIDE[name], OF_CLUB[name]) for name in base.mean},
        correlations=base.correlations,
    )


DRAWS = 4000
"""Number of deliveries drawn from a prior to compute its expectation."""
FAR = 3.29
"""Number of standard deviations exceeded by one in a thousand normally distributed values."""


class UnreachableLaunchError(InputError):
    """The launch is too far from those of the prior to infer a delivery."""


class Expectation:
    """Expected distribution of measured quantities under a prior, with normally distributed noise.

    ``seen`` maps points of a standard normal prior, shape (n, dimensions), to measured quantities, shape (n,
    quantities), NaN where they cannot be computed. ``scale`` holds the standard deviations of the measurement [SI].
    """

    def __init__(
        self, seen: Callable[[Floats], Floats], names: Sequence[str], scale: Floats, dimensions: int, seed: int
    ) -> None:
        values = seen(np.random.default_rng([seed, 1]).standard_normal((DRAWS, dimensions)))
        values = values[np.isfinite(values).all(axis=1)]
        self.names = tuple(names)
        self.mean = values.mean(axis=0)
        """Mean of each quantity."""
        self.spread = values.std(axis=0)
        """Standard deviation of each quantity, without noise."""
        self._scale = scale
        self._covariance = np.atleast_2d(np.cov(values.T)) + np.diag(scale**2)
        noise = scale * np.random.default_rng([seed, 2]).standard_normal(values.shape)
        away = values + noise - self.mean
        self._distances = np.sort(np.sum(away * np.linalg.solve(self._covariance, away.T).T, axis=1))

    def surprise(self, measured: Floats) -> float:
        """Return the probability of a shot that deviates more from the expected mean than ``measured``.

        Uses the Mahalanobis distance with the expected covariance, noise included, whose square is chi-squared
        distributed for normally distributed values.
        """
        away = measured - self.mean
        nearer = np.searchsorted(self._distances, float(away @ np.linalg.solve(self._covariance, away)))
        return float((1.0 + self._distances.size - nearer) / (1.0 + self._distances.size))

    def far(self, measured: Floats) -> list[str]:
        """Return the quantities that deviate from their expectation by more than one in a thousand would."""
        away = np.abs(measured - self.mean) > FAR * np.hypot(self.spread, self._scale)
        return [name for name, each in zip(self.names, away, strict=True) if each]

    def words(self, names: Sequence[str]) -> list[str]:
        """Return expected value and spread of the given quantities in words."""
        places = [self.names.index(name) for name in names]
        return [
            f"{self.names[place]} {shown(self.names[place], float(self.mean[place]), 3)} +-"
            f" {shown(self.names[place], float(self.spread[place]), 2)}"
            for place in places
        ]


def shown(name: str, value: float, digits: int) -> str:
    """Format a value of a launch or delivery [SI] with its display unit."""
    return units.show(value, unit_of(name), digits)


def unit_of(name: str) -> str:
    """Return the display unit of a quantity of a launch or a delivery."""
    if name in QUANTITIES:
        return QUANTITIES[name]
    return "mph" if name == "speed" else display_unit(name, units.SI_UNITS[OF_CLUB[name]])


def unreachable(measured: Mapping[str, float], expected: Expectation, who: str) -> UnreachableLaunchError:
    """Return the error for a shot out of reach of the prior described by ``who``."""
    given = ", ".join(f"{name} {shown(name, value, 4)}" for name, value in measured.items())
    advice = (
        f"within reach of {who} expects {', '.join(expected.words(expected.names))}: if units and club are right, give"
        " a prior that suits the golfer"
    )
    return UnreachableLaunchError("launch", given, advice)
