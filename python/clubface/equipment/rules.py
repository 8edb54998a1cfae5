"""Rules of golf for clubheads: published limits, and verdicts on values."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from typing import NamedTuple

from clubface import published_data, units
from clubface.equipment.clubs import Club, club as club_of
from clubface.support.checks import Frozen

STEEPEST_PENDULUM_LOFT = units.to_si(35.0, "deg")
"""Maximum loft for the pendulum test of the spring effect; R&A (2016), Spring effect and dynamic properties."""

NOT_KNOWN = "not known"
"""Verdict on an unknown value."""


class Rule(NamedTuple):
    """A limit in the rules.

    Attributes
    ----------
    name
        Limited quantity: ``moment_of_inertia``, ``characteristic_time``, ``volume``, ``heel_to_toe`` or
        ``sole_to_crown``.
    title
        Quantity in words.
    most
        Limit [SI].
    tolerance
        Measurement tolerance above the limit [SI].
    unit
        Unit in the publication.
    source
        Publisher, date and location.
    """

    name: str
    title: str
    most: float
    tolerance: float
    unit: str
    source: str

    @property
    def limit(self) -> float:
        """The limit with its tolerance [SI]."""
        return self.most + self.tolerance


class RuleVerdict(NamedTuple):
    """Verdict on a club for one limit.

    Attributes
    ----------
    rule
        The limit.
    value
        Value for the club [SI]; NaN if unknown.
    unknown
        Verdict if the value is unknown.
    """

    rule: Rule
    value: float
    unknown: str = NOT_KNOWN

    @property
    def conforms(self) -> bool | None:
        """Whether the value is within limit and tolerance, apart from rounding; None if unknown."""
        return None if math.isnan(self.value) else self.value <= self.rule.limit * (1.0 + 1e-9)

    @property
    def within_tolerance(self) -> bool:
        """Whether the value conforms only within the tolerance."""
        return bool(self.conforms) and self.value > self.rule.most

    @property
    def words(self) -> str:
        """Verdict: "conforms", "conforms within the tolerance", "does not conform", or why it is unknown."""
        if self.conforms is None:
            return self.unknown
        if not self.conforms:
            return "does not conform"
        return "conforms within the tolerance" if self.within_tolerance else "conforms"


_LIMITS = {
    "moment_of_inertia": ("moment of inertia, vertical axis", "head-inertia-limit", "inertia_most"),
    "characteristic_time": ("characteristic time of the face", "spring-effect-limit", "characteristic_time_most"),
    "volume": ("volume of the head", "head-volume-limit", "volume_most"),
    "heel_to_toe": ("distance from heel to toe", "head-dimension-limits", "heel_to_toe_most"),
    "sole_to_crown": ("distance from sole to crown", "head-dimension-limits", "sole_to_crown_most"),
}
"""Title of each limit, and its table and column in the published data."""


@cache
def rules() -> Mapping[str, Rule]:
    """Return the limits by name."""
    result = {}
    for name, (title, source, column) in _LIMITS.items():
        published = published_data.table(source)
        margin = float(published["tolerance"][0]) if "tolerance" in published.columns else 0.0
        result[name] = Rule(name, title, float(published[column][0]), margin, published.units[column], published.source)
    return Frozen(result)


def rules_of(club: str | Club) -> tuple[Rule, ...]:
    """Return the limits for a club: size and inertia for woods, characteristic time for lofts up to 35 degrees."""
    head = club_of(club)
    wood = ("moment_of_inertia", "volume", "heel_to_toe", "sole_to_crown") if head.kind != "iron" else ()
    face = ("characteristic_time",) if head.loft <= STEEPEST_PENDULUM_LOFT else ()
    return tuple(rules()[name] for name in (*wood, *face))
