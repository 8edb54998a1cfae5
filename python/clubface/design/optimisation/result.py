"""What an optimisation found: the club, what it is judged by on fresh shots, and the verdict of every limit."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.design import feasibility
from clubface.design.optimisation.advice import Advice, adds_nothing, describe_conditions, describe_golfers
from clubface.design.optimisation.landings import FREE, own_value
from clubface.design.optimisation.study import DIMENSIONS, UNITS, DesignStudy, field_quantity, shown_quantity
from clubface.design.optimisation.variables import PointMass, placement
from clubface.equipment.clubs import Club
from clubface.errors import RuleWarning
from clubface.quantities import Quantity, Reading
from clubface.results.result import Described, Result
from clubface.support.checks import without_warnings

FEW_FIELDS = 2
"""Most fields by whose values a club is named."""
ACTIVE = 1e-4
"""A margin, as a part of the limit or of the range, below which a limit is what stops the optimum."""


@dataclass(frozen=True)
class Fresh:
    """Clubs judged on shots that no solver has seen.

    Attributes
    ----------
    shots
        How many.
    clubs
        "start", "nominal" and "optimum", then the name of every objective for which there is a best club of its own.
    objectives
        Names of what they are judged by.
    sets
        Values of independent sets of shots [SI], shape (sets, clubs, objectives).
    """

    shots: int
    clubs: tuple[str, ...]
    objectives: tuple[str, ...]
    sets: NDArray[Any]

    @property
    def values(self) -> NDArray[Any]:
        """Values over all sets [SI], shape (clubs, objectives)."""
        return self.sets.mean(axis=0)

    def value(self, club: str, objective: str) -> float:
        """Return what a club is judged by."""
        return float(self.values[self.clubs.index(club), self.objectives.index(objective)])

    def error(self, club: str, objective: str) -> float:
        """Return the standard error of its difference from the optimum."""
        column = self.sets[:, :, self.objectives.index(objective)]
        differences = column[:, self.clubs.index(club)] - column[:, self.clubs.index("optimum")]
        return float(differences.std(ddof=1) / np.sqrt(len(differences)))


@dataclass(frozen=True)
class FrontPoint:
    """A club on the front between two objectives.

    Attributes
    ----------
    club
        The fields that change [SI].
    values
        The objectives [SI].
    """

    club: Mapping[str, float]
    values: Mapping[str, float]


@dataclass(frozen=True)
class Verdict:
    """What the optimum has of a limit.

    Attributes
    ----------
    limit
        The limit in words.
    quantity
        What is limited.
    value, least, most
        The optimum and what is allowed [SI]; infinite where there is no limit, NaN where the value is not known.
    margin
        What is left, as a part of the limit; below 0 it is broken; NaN where it is not known.
    """

    limit: str
    quantity: Quantity
    value: float
    least: float
    most: float
    margin: float

    @property
    def state(self) -> str:
        """The verdict: "kept", "kept, at the limit", "broken" or "not known"."""
        if math.isnan(self.margin):
            return "not known"
        if self.margin < -feasibility.ROUNDING:
            return "broken"
        return "kept, at the limit" if self.margin < ACTIVE else "kept"


@dataclass(frozen=True)
class Optimum(Described):
    """The best club of a study.

    Attributes
    ----------
    study
        What was asked.
    club
        The fields that changed [SI].
    nominal
        Those of the club that is best for the mean delivery.
    starts, alike
        Starts of the solver, and how many of them are as good as the best.
    steps
        Steps of the solver on all shots.
    shots, missed
        Shots that were computed, and those that missed the face.
    judged
        The objective, and others that limit it, on the shots that were solved on [SI].
    fresh
        What start, nominal optimum and optimum are judged by on fresh shots.
    rivals
        The fields of the clubs that are best for other objectives, within the same limits, by objective [SI].
    front
        Clubs between two objectives; empty for one.
    message
        What the solver said at its end.
    """

    study: DesignStudy
    club: Mapping[str, float]
    nominal: Mapping[str, float]
    starts: int
    alike: int
    steps: int
    shots: int
    missed: int
    judged: Mapping[str, float]
    fresh: Fresh
    rivals: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    front: tuple[FrontPoint, ...] = ()
    message: str = ""

    def __repr__(self) -> str:
        changed = [f"{name} {units.show(value, UNITS[name], 4)}" for name, value in self.club.items()]
        judged = [
            f"{each.name} {units.show(self.fresh.value('start', each.name), each.unit, 4)} to"
            f" {units.show(self.fresh.value('optimum', each.name), each.unit, 4)}"
            for each in map(self.study.objective, self.study.objectives)
        ]
        return f"optimum of {self.study.title!r}: {', '.join(changed)}; on fresh shots {', '.join(judged)}"

    @cached_property
    def built(self) -> Club:
        """The optimum as a club."""
        return club_of(self.study, self.club)

    @cached_property
    def compared(self) -> dict[str, str]:
        """The clubs of the advice, as :attr:`fresh` names them, by what they are in words; the start comes first."""
        study = self.study
        clubs = {f"present {study.club.name}": "start", self._words("optimum"): "optimum"}
        for name in self.rivals:
            known = [self.fresh.value(club, name) for club in clubs.values()]
            if not adds_nothing(study.objective(name), study.worth[name], self.fresh.value(name, name), known):
                clubs[self._words(name)] = name
        if self.nominal and not study.limits_shots:
            clubs.setdefault(self._words("nominal"), "nominal")
        return clubs

    @cached_property
    def advice(self) -> Advice:
        """The club at the start, the optimum, and the clubs that are best for other objectives."""
        study = self.study
        rows = [self.fresh.clubs.index(name) for name in self.compared.values()]
        columns = [self.fresh.objectives.index(each.name) for each in study.advised]
        return Advice(
            purpose=study.objectives[0], golfer=describe_golfers(study.golfers), objectives=study.advised,
            names=tuple(self.compared), values=self.fresh.values[np.ix_(rows, columns)],
            sets=self.fresh.sets[:, rows][:, :, columns].swapaxes(0, 1), worth=study.worth, choices=(1,),
            conditions=describe_conditions(study.setting, study.hole, self.fresh.shots),
            assumed_hole=study.hole is None and study.counted_hole is not None,
        )  # fmt: skip

    def fields(self, club: str) -> Mapping[str, float]:
        """Return the fields [SI] of a club that :attr:`fresh` judges."""
        own = {name: own_value(self.study.club, name) for name in self.club}
        return {"start": own, "nominal": self.nominal, "optimum": self.club, **self.rivals}[club]

    def _words(self, club: str) -> str:
        fields = self.fields(club)
        if len(fields) <= FEW_FIELDS:
            return ", ".join(f"{name} {units.show(value, UNITS[name], 3)}" for name, value in fields.items())
        purpose = {"optimum": self.study.objectives[0], "nominal": "the mean delivery"}.get(club, club)
        return f"the best club for {purpose.replace('_', ' ')}"

    def to_result(self) -> Result:
        """Return the optimum as a result."""
        from clubface.design.optimisation.optimum_result import optimum_result

        return optimum_result(self)

    def placed(self) -> list[PointMass]:
        """Return point masses that are one way to place the discretionary mass; empty where no mass moves."""
        envelope = self.study.variables.envelope
        if envelope is None:
            return []
        return placement(envelope, feasibility.pseudo_inertia(feasibility.of_club(self.built)))

    def verdicts(self) -> list[Verdict]:
        """Return what the optimum has of every limit: rules, what can be built, bounds, and limits of the shots."""
        study = self.study
        with without_warnings(RuleWarning):
            result = [_of_rule(each, study.tolerance) for each in study.rule_values(self.built)]
        envelope = study.variables.envelope
        if envelope is not None:
            pseudo = feasibility.pseudo_inertia(feasibility.of_club(self.built))
            margins = envelope.margins(pseudo)
            if "mass" not in study.bounds:
                margins.pop()  # the budget limits nothing where the mass is given
            result += _of_margins(margins)
        for name, (low, high) in (*study.bounds.items(), *study.limits.items()):
            if name in FREE:
                result.append(_of_range(name, self.club[name], low, high, field_quantity(name)))
            else:
                judge = study.objective(name)
                result.append(_of_range(judge.meaning, self.judged[name], low, high, judge.quantity))
        return result


def club_of(study: DesignStudy, changes: Mapping[str, float], name: str | None = None) -> Club:
    """Return the club of a study with fields changed; its lie, which no club file has, is left out."""
    own = {field: value for field, value in changes.items() if field in DIMENSIONS and field != "lie"}
    called = name or f"{study.club.name}-optimum"
    source = f"optimised from {study.club.name}: {study.title}"
    with without_warnings(RuleWarning):
        made = study.club.replace(**own, name=called, description=f"{study.title}: the optimum")
        return made.replace(sources={**made.sources, **dict.fromkeys(own, source)})


def _of_rule(each: Any, tolerance: bool) -> Verdict:
    limit = each.rule.limit if tolerance else each.rule.most
    quantity = shown_quantity(each.rule.name, each.rule.unit)
    return Verdict(f"rules: {each.rule.title}", quantity, each.value, -math.inf, limit, (limit - each.value) / limit)


def _of_margins(margins: list[feasibility.Margin]) -> list[Verdict]:
    """Return one verdict for each thing that must hold of a body, by its smallest margin."""
    least: dict[str, float] = {}
    for each in margins:
        least[each.name] = min(least.get(each.name, math.inf), each.value)
    margin = Quantity("margin", "1", Reading("1", 4), Reading("1", 4))
    return [Verdict(name, margin, value, 0.0, math.inf, value) for name, value in least.items()]


def _of_range(name: str, value: float, low: float, high: float, quantity: Quantity) -> Verdict:
    sides = [abs(each) for each in (low, high) if math.isfinite(each)]
    size = high - low if len(sides) == 2 else max([*sides, 1e-12])
    margin = min(value - low, high - value) / size
    return Verdict(name, quantity, value, low, high, float(np.round(margin, 12)))
