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


_PLACES = {
    "moment_of_inertia": ("head-inertia-limit", "inertia_most", "tolerance"),
    "characteristic_time": ("spring-effect-limit", "characteristic_time_most", "tolerance"),
    "volume": ("head-volume-limit", "volume_most", "tolerance"),
    "heel_to_toe": ("head-dimension-limits", "heel_to_toe_most", None),
    "sole_to_crown": ("head-dimension-limits", "sole_to_crown_most", None),
}
"""Table, column and tolerance column of each limit in the published data."""

_TITLES = {
    "moment_of_inertia": "moment of inertia, vertical axis",
    "characteristic_time": "characteristic time of the face",
    "volume": "volume of the head",
    "heel_to_toe": "distance from heel to toe",
    "sole_to_crown": "distance from sole to crown",
}


@cache
def rules() -> Mapping[str, Rule]:
    """Return the limits by name."""
    result = {}
    for name, (source, column, tolerance) in _PLACES.items():
        published = published_data.table(source)
        margin = 0.0 if tolerance is None else float(published[tolerance][0])
        result[name] = Rule(
            name, _TITLES[name], float(published[column][0]), margin, published.units[column], published.source
        )
    return Frozen(result)


def rules_of(club: str | Club) -> tuple[Rule, ...]:
    """Return the limits for a club: size and inertia for woods, characteristic time for lofts up to 35 degrees."""
    head = club_of(club)
    wood = ("moment_of_inertia", "volume", "heel_to_toe", "sole_to_crown") if head.kind != "iron" else ()
    face = ("characteristic_time",) if head.loft <= STEEPEST_PENDULUM_LOFT else ()
    return tuple(rules()[name] for name in (*wood, *face))
