"""Advice: which of several alternatives a golfer should play, by what counts, and which differences are worth a change.

Every command that advises a golfer, a fitting, an optimisation and the best loft, asks the same question of the same
numbers: is an alternative better than the present one by at least the smallest difference that is worth a change?
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.design.golfer import Golfer
from clubface.design.optimisation.landings import Landings, Objective, Setting, objective, objectives
from clubface.design.strokes import Hole
from clubface.equipment.clubs import Club
from clubface.errors import InputError
from clubface.support.checks import check_choice

WORTH: Mapping[str, float] = {
    "carry": units.parse("2 yd", "length"),
    "total": units.parse("2 yd", "length"),
    "side_spread": units.parse("1 yd", "length"),
    "ellipse": 150.0,
    "strokes": 0.01,
}
"""The smallest difference worth a change, by objective [SI].

A hundredth of a stroke a drive makes 0.14 strokes over the 14 drives of a round, just more than the 0.1 to which a
Handicap Index is given (Rules of Handicapping, rule 5.2a). The others are about as much by Broadie's strokes: on a hole
of 400 yards the drives of the shipped golfers cost 0.003 to 0.006 strokes for each yard that they are shorter, and
0.014 to 0.017 for each yard that the standard deviation of the side is greater, which makes the ellipse 65 to 207 m2
larger.
"""
ADVISED = ("carry", "total", "side_spread", "strokes")
"""The objectives that advice compares, whatever was asked; strokes where there is a hole."""
CERTAIN = 2.0
"""Standard errors beyond which a difference is called one: it is due to chance in 1 of 20 cases."""
SETS = 16
"""Sets into which the shots are divided; the spread of their differences gives the standard error of a difference."""
FEWEST = 8
"""Fewest shots of a set: of fewer the spread to the side would be too small."""
ASSUMED_HOLE = Hole(length=units.parse("400 yd", "length"))
"""The hole on which the strokes of a wood are counted where none is given; assumed."""
DRIVEN = np.radians(20.0)
"""Static loft of a wood below which the club is taken to be played from the tee of :data:`ASSUMED_HOLE`."""

DRIVES = 14
"""Drives of a round: the holes of a course of par 72 that are no par 3."""
NEGLIGIBLE = 0.1
"""Part of what is worth a change below which a further alternative adds nothing to those there are."""
END = 1e-3
"""Part of the range of what is tried within which a value stands at its end."""

BETTER, WORSE, ALIKE, OPEN = "better", "worse", "alike", "not certain"


def worth_of(given: Mapping[str, Any] | None) -> dict[str, float]:
    """Return the smallest difference worth a change of every objective [SI]: those given, :data:`WORTH` for the others.

    Raises
    ------
    InputError
        A name is none of an objective, or a value is not above 0.
    """
    result = dict(WORTH)
    for name, value in (given or {}).items():
        check_choice("objective", name, WORTH)
        size = units.parse(value, units.unit(judged_unit(name)).dimension, name=f"worth.{name}")
        if not size > 0.0:
            raise InputError(f"worth.{name}", value, "above 0")
        result[name] = size
    return result


def judged_unit(name: str) -> str:
    """Return the unit in which an objective is read."""
    return "1" if name == "strokes" else objective(name).unit


def hole_for(club: Club, hole: Hole | None) -> Hole | None:
    """Return the hole on which strokes are counted: the one given, the assumed one for a wood, None for an iron."""
    driven = club.parameters == "driver" and club.loft < DRIVEN
    return hole if hole is not None or not driven else ASSUMED_HOLE


def advised(asked: str, hole: Hole | None) -> tuple[Objective, ...]:
    """Return the objectives that advice compares: what was asked first, then the others that can be computed."""
    known = {each.name: each for each in objectives(hole)}
    return tuple(known[name] for name in dict.fromkeys((asked, *ADVISED)) if name in known)


def judge_sets(
    judges: Sequence[Objective], golfers: Sequence[tuple[Landings, float, NDArray[Any]]], sets: int = SETS
) -> NDArray[Any]:
    """Return objectives in sets of shots, the weighted mean of golfers, shape (sets, objectives).

    Parameters
    ----------
    judges
        The objectives.
    golfers
        Their shots, how much each golfer counts, and the landings [m].
    sets
        How many sets, as long as each has ``FEWEST`` shots.
    """
    fewest = min(shots.count + shots.missed for shots, _, _ in golfers)
    sets = max(1, min(sets, fewest // FEWEST))
    weights = np.array([weight for _, weight, _ in golfers])
    values = np.full((len(golfers), sets, len(judges)), np.nan)
    for place, (shots, _, landed) in enumerate(golfers):
        for row, part in enumerate(shots.split(landed, sets)):
            if part.shape[1]:
                values[place, row] = [each.judge(part)[0] for each in judges]
    return np.average(values, axis=0, weights=weights)


@dataclass(frozen=True, kw_only=True, eq=False)
class Advice:
    """Alternatives judged by several objectives on the same shots, and what a golfer should do.

    Attributes
    ----------
    purpose
        The name of the objective that was asked for.
    golfer
        Whom it is for, in words.
    objectives
        All objectives; the one asked for first.
    names
        What the alternatives are, in words; the first is the present one.
    values
        What they are judged by [SI], shape (alternatives, objectives).
    sets
        The same of separate sets of shots, shape (alternatives, sets, objectives), for the standard errors of
        differences.
    worth
        The smallest difference worth a change, by objective [SI].
    choices
        Which alternatives may be recommended for the objective asked for; all unless given.
    conditions
        In words: shots, model, hole.
    assumed_hole
        Whether the hole is the assumed one.
    at_an_end
        Which alternatives stand at an end of what was tried, where the best is no optimum.
    """

    purpose: str
    golfer: str
    objectives: tuple[Objective, ...]
    names: tuple[str, ...]
    values: NDArray[Any]
    sets: NDArray[Any]
    worth: Mapping[str, float]
    choices: tuple[int, ...] | None = None
    conditions: str = ""
    assumed_hole: bool = False
    at_an_end: tuple[int, ...] = ()

    def place(self, name: str) -> int:
        """Return the index of an objective."""
        known = [each.name for each in self.objectives]
        check_choice("objective", name, known)
        return known.index(name)

    def gain(self, name: str, alternative: int, other: int = 0) -> float:
        """Return by how much an alternative is better than another by an objective [SI]; worse is negative."""
        column = self.place(name)
        sign = -self.objectives[column].sign
        return float(sign * (self.values[alternative, column] - self.values[other, column]))

    def error(self, name: str, alternative: int, other: int = 0) -> float:
        """Return the standard error of :meth:`gain`, NaN where there are too few shots to know it."""
        if alternative == other:
            return 0.0
        differences = self.sets[alternative, :, self.place(name)] - self.sets[other, :, self.place(name)]
        if len(differences) < 2:
            return float("nan")
        return float(differences.std(ddof=1) / np.sqrt(len(differences)))

    def state(self, name: str, alternative: int, other: int = 0) -> str:
        """Return how an alternative compares with another by an objective.

        "better" and "worse" are differences that are worth a change and statistically clear, "alike" those that are
        clearly not worth a change, and "not certain" what the shots do not tell.
        """
        gain, worth = self.gain(name, alternative, other), self.worth[name]
        margin = CERTAIN * self.error(name, alternative, other)
        if abs(gain) >= worth and abs(gain) > margin:
            return BETTER if gain > 0.0 else WORSE
        return ALIKE if abs(gain) + margin < worth else OPEN

    def states(self, alternative: int) -> dict[str, str]:
        """Return how an alternative compares with the present one, by objective."""
        return {each.name: self.state(each.name, alternative) for each in self.objectives}

    def best(self, name: str) -> int:
        """Return the alternative that an objective alone would choose.

        It is the best of those that are better than the present one by a difference worth a change; where there is
        none, the one with the best value, which may be the present one.
        """
        open_to = self._open_to(name)
        better = [place for place in open_to if self.state(name, place) == BETTER]
        return max(better or (0, *open_to), key=lambda place: self.gain(name, place))

    def losses(self, name: str, alternative: int) -> dict[str, float]:
        """Return by how much an alternative is worse by the other objectives where that is worth a change [SI]."""
        states = self.states(alternative)
        return {
            each.name: -self.gain(each.name, alternative)
            for each in self.objectives
            if each.name != name and states[each.name] == WORSE
        }

    def _open_to(self, name: str) -> Sequence[int]:
        """Return which alternatives may be recommended for an objective."""
        return range(1, len(self.names)) if self.choices is None or name != self.purpose else self.choices

    def recommended(self, name: str | None = None) -> int:
        """Return the alternative to play by an objective, the one asked for unless named; 0 for the present one.

        The present one stays unless another is better by a difference worth a change. Of several that do not differ
        from the best, it is the one that is worse in the fewest other objectives, and of these the first.
        """
        name = name or self.purpose
        best = self.best(name)
        if self.state(name, best) != BETTER:
            return 0
        level = [place for place in self.as_good(name, best) if place in self._open_to(name)]
        return min(level, key=lambda place: list(self.states(place).values()).count(WORSE))

    def as_good(self, name: str, alternative: int) -> list[int]:
        """Return all that are better than the present one and do not differ from an alternative, itself among them."""
        return [
            place for place in range(1, len(self.names))
            if self.state(name, place) == BETTER and self.state(name, place, alternative) not in (BETTER, WORSE)
        ]  # fmt: skip

    def ranks(self, places: Sequence[int], name: str | None = None) -> dict[int, int]:
        """Return the rank of alternatives by an objective, 1 for the best; those that do not differ share one.

        The best and all that are not worse than it by a clear difference worth a change are first; of the others the
        best and all that are not worse than it are next, and so on.
        """
        name = name or self.purpose
        left = sorted(places, key=lambda place: -self.gain(name, place))
        ranks: dict[int, int] = {}
        while left:
            level = [place for place in left if self.state(name, place, left[0]) != WORSE]
            ranks |= dict.fromkeys(level, len(ranks) + 1)
            left = [place for place in left if place not in ranks]
        return ranks


def adds_nothing(judge: Objective, worth: float, value: float, others: Sequence[float]) -> bool:
    """Return whether one of other alternatives is as good by an objective [SI] as a further one, or nearly."""
    return any(judge.sign * (other - value) < NEGLIGIBLE * worth for other in others)


def is_at_an_end(value: float, limits: tuple[float, float]) -> bool:
    """Return whether a value is the least or the greatest that was tried, so that the best may lie beyond it."""
    low, high = limits
    return min(value - low, high - value) < END * (high - low)


def describe_conditions(setting: Setting, hole: Hole | None, shots: int) -> str:
    """Return in words how many shots are judged, by which model, on which hole."""
    where = f"; hole of {hole.describe()}" if hole is not None else ""
    return f"{f'{shots} shots' if shots > 1 else 'one delivery'} by the model {setting.model}{where}"


def describe_golfers(golfers: Sequence[tuple[Golfer, float]]) -> str:
    """Return whom advice is for, in words."""
    return " and ".join(golfer.title or golfer.name for golfer, _ in golfers)
