"""Golfers: the distribution of their club deliveries from shot to shot.

The files in ``data/golfers`` show their format, :class:`GolferFile` every key.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Self

import numpy as np

from clubface import _core as core, units
from clubface.equipment.clubs import CLUB_NAMES, Club, club as club_named
from clubface.equipment.described import HANDS
from clubface.errors import InputError, Wording
from clubface.schema.document import Document, Place, quoted
from clubface.schema.tables import Table, decode, encode, file_key
from clubface.schema.values import TEXT, Choice, PhysicalValue, Record, Reference, Tables
from clubface.shots.plausibility import can_be
from clubface.simulation.inputs import OF_CLUB, UNITS, Correlation, Delivery, thread_count
from clubface.support.arrays import Floats
from clubface.support.checks import MOST_SEED, Frozen, check_choice, check_count, check_name, check_text, is_number
from clubface.support.files import builtin_names, is_path, path_of
from clubface.support.processes import check_request

MOST_SHOTS = 2**32


def uniform(dimensions: int, count: int, *, seed: int = 0, start: int = 0, threads: int | None = None) -> Floats:
    """Return points ``start`` to ``start + count`` of a scrambled Sobol sequence, shape (count, dimensions).

    Numbers lie strictly between 0 and 1. Each depends only on dimension, seed and index, not on the number of
    ``threads`` (None: one per core). Direction numbers are from Joe and Kuo (2008), with Owen scrambling (1995) by the
    hash of Burley (2020).
    """
    count = check_count("count", count, 1, MOST_SHOTS)
    start = check_count("start", start, 0, MOST_SHOTS - count)
    seed = check_count("seed", seed, 0, MOST_SEED)
    check_request(count, 4 * 8 * dimensions)  # the points and what is computed from them
    return core.quasi_random(dimensions, count, seed, start, thread_count(threads)).T


ASSUMED = "assumed"
"""Source of a figure for which none is given."""
MIRRORED = ("path", "face")
"""Variables that change sign for a left-handed golfer."""
WIDEST = 20.0
"""Largest ``mishit_scale``."""
WORDS = {
    "attack": "attack angle", "path": "club path", "loft": "dynamic loft", "face": "face angle",
    "toe": "strike, heel to toe", "high": "strike, low to high",
}  # fmt: skip
"""Common names of delivery variables."""


def variable_label(variable: str) -> str:
    """Return the common name of a delivery variable."""
    return WORDS.get(variable, variable.replace("_", " "))


@dataclass(frozen=True, kw_only=True, eq=False)
class Golfer:
    """The joint distribution of deliveries at the moment of impact, in SI units.

    Shots are normally distributed. With probability ``mishit_share`` a shot is a mishit, with deviations from the mean
    ``mishit_scale`` times as large. The impact point is part of the delivery. ``loft`` and ``face`` refer to the face
    centre, so that the curvature of the face is not counted twice.

    Attributes
    ----------
    name, title
        Name in reports, and description in one line.
    club
        The club delivered: a built-in name, or the owner's name for it.
    hand
        +1 for a right-handed golfer, -1 for a left-handed one; path and face angle do not change sign with it.
    variables
        Names of the delivery values the golfer sets, as in :class:`clubface.Delivery`, shape (k,). All others keep
        their defaults; the default loft is the club's static loft.
    mean, covariance
        Their means, shape (k,), and covariance of the shots that are not mishits, shape (k, k) [SI].
    mishit_share, mishit_scale
        Share of the shots that are mishits, from 0 to below 1, and factor on their deviations, 1 to 20.
    sources
        Source of each figure by name: ``mean of speed``, ``spread of face``, ``correlation of face and path``,
        ``mishits``. A figure that is not listed is assumed.
    """

    name: str
    title: str = ""
    club: str = "driver"
    hand: int = 1
    variables: tuple[str, ...]
    mean: Floats
    covariance: Floats
    mishit_share: float = 0.0
    mishit_scale: float = 1.0
    sources: Mapping[str, str] = field(default_factory=dict)

    def __repr__(self) -> str:
        lines = [f"{self.name}: {self.title or 'golfer'}, with {self.club}{', left-handed' * (self.hand < 0)}"]
        for name, mean, spread in zip(self.variables, self.mean, self.spread, strict=True):
            unit = UNITS[OF_CLUB[name]]
            numbers = (f"{units.from_si(float(each), unit):.4g}" for each in (mean, spread))
            lines.append(f"  {name:<12} {' ± '.join(numbers)} {unit}")
        if self.mishit_share > 0.0:
            lines.append(f"  {self.mishit_share:.0%} mishits, {self.mishit_scale:.3g} times as far off")
        return "\n".join(lines)

    def __post_init__(self) -> None:
        check_name(self.name)
        check_text("title", self.title)
        if not self.title.isprintable():
            raise InputError("title", self.title, "printable text on one line")
        check_text("club", self.club)
        if self.hand not in (-1, 1):
            raise InputError("hand", self.hand, "1 for a right-handed golfer or -1 for a left-handed one")
        if not isinstance(self.variables, (tuple, list)):
            raise InputError("variables", self.variables, "names of delivery values")
        variables = tuple(self.variables)
        for place, variable in enumerate(variables):
            check_choice("variable of a golfer", variable, OF_CLUB)
            if variable in variables[:place]:
                raise InputError("variables", variables, "a list without repetitions")
        if "speed" not in variables:
            raise InputError("variables", variables, "a list that includes speed")
        object.__setattr__(self, "variables", variables)
        object.__setattr__(self, "mean", _array("mean", self.mean, (len(variables),)))
        if (speed := float(self.mean[variables.index("speed")])) <= 0.0:
            raise InputError("mean of speed", speed, "above 0 m/s")
        object.__setattr__(self, "covariance", _array("covariance", self.covariance, (len(variables),) * 2))
        if not (is_number(self.mishit_share) and 0.0 <= self.mishit_share < 1.0):
            raise InputError("mishit_share", self.mishit_share, "from 0 to below 1")
        if not (is_number(self.mishit_scale) and 1.0 <= self.mishit_scale <= WIDEST):
            raise InputError("mishit_scale", self.mishit_scale, f"from 1 to {WIDEST:g}")
        try:
            self._deliveries([])
        except ValueError as error:
            what, allowed = error.args
            raise InputError(what, Wording("the matrix given"), allowed.removeprefix("must be ")) from None
        if not isinstance(self.sources, Mapping):
            raise InputError("sources", self.sources, "a mapping of figures to text")
        object.__setattr__(self, "sources", Frozen(self.sources))

    @property
    def dimensions(self) -> int:
        """Number of independent random numbers per shot."""
        return len(self.variables) + (self.mishit_share > 0.0)

    @cached_property
    def spread(self) -> Floats:
        """Standard deviation of each variable without mishits [SI], shape (k,)."""
        return np.sqrt(np.diag(self.covariance))

    @cached_property
    def total_covariance(self) -> Floats:
        """Covariance of all shots, including mishits [SI], shape (k, k)."""
        return self.covariance * (1.0 + self.mishit_share * (self.mishit_scale**2 - 1.0))

    @cached_property
    def correlation(self) -> Floats:
        """Correlations without mishits, shape (k, k); 0 for a variable that does not vary."""
        scale = np.where(self.spread > 0.0, self.spread, 1.0)
        return self.covariance / np.outer(scale, scale)

    def source(self, figure: str) -> str:
        """Return the source of a figure such as "spread of face", or "assumed"."""
        return self.sources.get(figure, ASSUMED)

    def figures(self) -> list[str]:
        """Return the names of all figures, as :meth:`source` takes them."""
        names = [f"{part} of {name}" for part in ("mean", "spread") for name in self.variables]
        correlated = int((self.correlation != 0.0).sum()) > len(self.variables)
        return names + ["correlation"] * correlated + ["mishits"] * (self.mishit_share > 0.0)

    def figures_by_source(self) -> dict[str, list[str]]:
        """Return readable names of all figures, grouped by source."""
        result: dict[str, list[str]] = {}
        for figure in self.figures():
            result.setdefault(self.source(figure), []).append(figure.replace("_", " "))
        return result

    def delivery(self) -> Delivery:
        """Return the mean delivery."""
        return Delivery(**dict(zip(self.variables, map(float, self.mean), strict=True)))

    def sample(self, count: int, *, seed: int = 0, start: int = 0, threads: int | None = None) -> dict[str, Floats]:
        """Return deliveries spread evenly over the distribution: values [SI] by variable, each of shape (count,).

        Shot ``i`` depends only on the seed and on ``i``: chunks joined are, bit for bit, the shots made at once. They
        come from a scrambled Sobol sequence, so powers of two are best.

        Parameters
        ----------
        count, start
            Number of shots, and index of the first.
        seed
            Seed of the scrambling; different seeds give independent shots.
        threads
            Number of threads (None: one per core); the shots do not depend on it.
        """
        numbers = uniform(self.dimensions, count, seed=seed, start=start, threads=threads)
        return self.deliveries(numbers, threads=threads)

    def deliveries(self, uniform: Floats, *, threads: int | None = None) -> dict[str, Floats]:
        """Return the deliveries for uniform random numbers between 0 and 1.

        ``uniform`` has the shape (n, :attr:`dimensions`); with mishits, the last column decides which shots are
        mishits. The mirrored golfer gives the mirror images of the same shots. ``threads`` are as for :meth:`sample`.
        """
        given = units.numbers(uniform, name="uniform")
        if given.ndim != 2 or given.shape[1] != self.dimensions:
            raise InputError("uniform", given.shape, f"of shape (n, {self.dimensions})")
        if not ((given > 0.0) & (given < 1.0)).all():
            raise InputError("uniform", Wording("not between 0 and 1"), "numbers between 0 and 1")
        values = self._deliveries([np.ascontiguousarray(column) for column in given.T], thread_count(threads))
        return dict(zip(self.variables, values, strict=True))

    def _deliveries(self, columns: list[Floats], threads: int = 0) -> Floats:
        """Return deliveries, shape (k, n), from columns of uniform numbers between 0 and 1."""
        mirrored = [self.hand < 0 and name in MIRRORED for name in self.variables]
        share, scale = float(self.mishit_share), float(self.mishit_scale)
        return core.golfer_deliveries(
            self.mean.tolist(), self.covariance.ravel().tolist(), mirrored, share, scale, columns, threads
        )

    def for_hand(self, hand: float) -> Self:
        """Return the golfer, mirrored if ``hand`` is not the golfer's own."""
        if hand not in (-1, 1):
            raise InputError("hand", hand, "1 or -1")
        if (hand > 0) == (self.hand > 0):
            return self
        sign = np.array([-1.0 if name in MIRRORED else 1.0 for name in self.variables])
        both = np.outer(sign, sign)
        return replace(self, hand=-self.hand, mean=self.mean * sign, covariance=self.covariance * both)

    def content(self) -> list[Any]:
        """Return everything the shots depend on, for a fingerprint."""
        return [
            self.name, self.variables, self.mean, self.covariance, self.mishit_share, self.mishit_scale, self.hand
        ]  # fmt: skip

    def replace(self, **changes: Any) -> Self:
        """Return the golfer with some attributes changed."""
        return replace(self, **changes)


def _array(name: str, given: Any, shape: tuple[int, ...]) -> Floats:
    try:
        result = units.numbers(given, name=name).copy()
    except InputError:
        raise InputError(name, given, f"numbers of shape {shape}") from None
    if result.shape != shape:
        raise InputError(name, Wording(f"numbers of shape {result.shape}"), f"numbers of shape {shape}")
    if not np.isfinite(result).all():
        raise InputError(name, Wording("not all finite"), "finite numbers")
    result.setflags(write=False)
    return result


@dataclass(repr=False, eq=False, kw_only=True)
class DeliveryFigure(PhysicalValue):
    """Schema of the mean or the spread of one delivery value."""

    name: str
    is_spread: bool = False

    def read(self, given: Any, place: Place) -> float:
        """Return the value [SI]; refuse one that no shot can have."""
        value = super().read(given, place)
        if self.is_spread and value < 0.0:
            raise place.invalid(given, "a standard deviation, which must not be negative")
        # A spread so wide that twice as much is impossible, such as 0.9 rad, was probably meant in another unit.
        if value and not can_be(self.name, 2.0 * value if self.is_spread else value):
            raise place.invalid(given, f"a plausible value, as text with its unit, such as {UNITS[OF_CLUB[self.name]]}")
        return value

    def write(self, value: float) -> str:
        """Return text."""
        return quoted(written(value, self.name))


@dataclass(frozen=True, kw_only=True)
class Mishit:
    """Share and size of mishits."""

    share: float = file_key(PhysicalValue("1", lower=0, below=1), "share of the shots that are mishits")
    scale: float = file_key(PhysicalValue("1", 1, WIDEST), "factor on the deviations of mishits")


TEXTS = Record(dict.fromkeys(OF_CLUB, TEXT))


@dataclass(frozen=True, kw_only=True)
class GolferFile:
    """A golfer file."""

    title: str = file_key(TEXT, "description of the golfer, in one line")
    club: str = file_key(Reference(os.fspath), "the club that is delivered", default="driver")
    hand: int = file_key(Choice(HANDS), "the hand of the golfer", default=1)
    mean: Mapping[str, float] = file_key(
        Record({name: DeliveryFigure(UNITS[each], name=name) for name, each in OF_CLUB.items()}, ("speed",)),
        "means of the delivery",
    )
    spread: Mapping[str, float] = file_key(
        Record({name: DeliveryFigure(UNITS[each], name=name, is_spread=True) for name, each in OF_CLUB.items()}),
        "standard deviations from shot to shot",
    )
    correlation: tuple[Correlation, ...] = file_key(
        Tables(Table(Correlation)), "correlations of pairs; all others are independent", default=()
    )
    mishit: Mishit | None = file_key(Table(Mishit), "shots with larger deviations", default=None)
    sources: Mapping[str, Any] = file_key(
        Record({"correlation": TEXT, "mishits": TEXT, "mean": TEXTS, "spread": TEXTS}),
        "source of the figures; default `assumed`", default_factory=dict,
    )  # fmt: skip


def from_document(document: Document, name: str) -> Golfer:
    """Return the golfer described by a document, under the name ``name``."""
    file = decode(GolferFile, document)
    variables = tuple(each for each in OF_CLUB if each in file.mean or each in file.spread)
    mean, spread = (np.array([part.get(each, 0.0) for each in variables]) for part in (file.mean, file.spread))
    with Place(document).errors():
        if "loft" in variables and "loft" not in file.mean:
            raise InputError("spread.loft", document.data["spread"]["loft"], "leave it out, or give mean.loft as well")
        correlation = _correlations(Place(document).key("correlation"), file.correlation, variables, spread)
        with np.errstate(over="ignore"):  # infinite values are refused below
            covariance = correlation * np.outer(spread, spread)
        mishit = file.mishit or Mishit(share=0.0, scale=1.0)
        parts = {f"{part} of {one}": text for part in ("mean", "spread")
                 for one, text in file.sources.get(part, {}).items()}  # fmt: skip
        return Golfer(
            name=name, title=file.title, club=file.club, hand=file.hand, variables=variables, mean=mean,
            covariance=covariance, mishit_share=mishit.share, mishit_scale=mishit.scale,
            sources=parts | {part: text for part, text in file.sources.items() if isinstance(text, str)},
        )  # fmt: skip


def _correlations(place: Place, given: Iterable[Correlation], variables: tuple[str, ...], spread: Floats) -> Floats:
    matrix = np.eye(len(variables))
    seen: set[frozenset[str]] = set()
    for index, each in enumerate(given):
        with (at := place.item(index).key("of")).errors():
            pair = each.pair
            if pair[0] == pair[1] or not set(pair) <= set(variables):
                raise at.invalid(list(pair), f"two variables of this golfer: {', '.join(variables)}")
            one, other = (variables.index(name) for name in pair)
            if each.value and not spread[one] * spread[other]:
                still = pair[0] if not spread[one] else pair[1]
                raise at.invalid(list(pair), f"two variables with a spread; {still} does not vary")
            if frozenset(pair) in seen:
                raise at.invalid(list(pair), "given only once; this pair has a correlation already")
        seen.add(frozenset(pair))
        matrix[one, other] = matrix[other, one] = each.value
    return matrix


def to_toml(golfer: Golfer) -> str:
    """Return a golfer as TOML text, which reads back identically to 12 digits."""
    pairs = [(one, other) for one in range(len(golfer.variables)) for other in range(one)]
    sources: dict[str, Any] = {}
    for figure, text in golfer.sources.items():
        part, _, name = figure.partition(" of ")
        if part in ("mean", "spread"):
            sources.setdefault(part, {})[name] = text
        elif figure in ("correlation", "mishits"):
            sources[figure] = text
    file = GolferFile(
        title=golfer.title,
        club=golfer.club,
        hand=golfer.hand,
        mean=dict(zip(golfer.variables, map(float, golfer.mean), strict=True)),
        spread=dict(zip(golfer.variables, map(float, golfer.spread), strict=True)),
        correlation=tuple(
            Correlation(pair=(golfer.variables[one], golfer.variables[other]), value=float(f"{value:.12g}"))
            for one, other in pairs
            if (value := float(golfer.correlation[one, other]))
        ),
        mishit=Mishit(share=float(f"{golfer.mishit_share:.12g}"), scale=float(f"{golfer.mishit_scale:.12g}"))
        if golfer.mishit_share > 0.0
        else None,
        sources=sources,
    )
    return encode(file)


def written(value: float, name: str) -> str:
    """Return a delivery value [SI] as text with its usual unit."""
    unit = UNITS[OF_CLUB[name]]
    number = units.from_si(value, unit)
    return f"{0.0 if math.isclose(number, 0.0, abs_tol=1e-14) else number:.12g} {unit}"


def is_assumed(golfer: Golfer, figure: str) -> bool:
    """Return whether a golfer's figure has no published or measured source."""
    return golfer.source(figure).startswith(ASSUMED)


def golfer_sources(golfer: Golfer) -> list[str]:
    """Return the sources of a golfer's figures, one line per source."""
    sources = golfer.figures_by_source().items()
    return [f"Golfer {golfer.title or golfer.name}, {', '.join(figures)}: {source}" for source, figures in sources]


def golfers() -> tuple[str, ...]:
    """Return the names of the golfers that come with the package."""
    return builtin_names("golfers")


def club_of(player: Golfer) -> str:
    """Return a golfer's club, a built-in name or a file's path; raise an error if only the owner's name is known."""
    if player.club in CLUB_NAMES or is_path(player.club):
        return player.club
    raise InputError("club", None, f"give the file of {player.club!r}, the club that {player.name} delivers")


def own_club(player: Golfer) -> Club:
    """Return a golfer's club, for the golfer's hand."""
    return club_named(club_of(player)).replace(hand=player.hand)


def golfer(name: str | os.PathLike[str] | Golfer) -> Golfer:
    """Return the shipped golfer of this name or the one in a TOML file; a :class:`Golfer` is returned as is."""
    if isinstance(name, Golfer):
        return name
    path = path_of("golfer", name, "golfers")
    return from_document(Document.read(path), Path(path).stem)
