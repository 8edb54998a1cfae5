"""Fittings: parts and settings to choose from, for whom, what is judged, and the clubs they make."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from importlib import import_module
from itertools import product
from typing import TYPE_CHECKING, Any, NamedTuple

from clubface import units
from clubface.design.optimisation.advice import Advice, advised, hole_for, worth_of
from clubface.design.optimisation.landings import (
    DEFAULT_SETTING,
    Landings,
    Objective,
    Setting,
    objective,
    objectives,
    own_value,
)
from clubface.design.optimisation.variables import check_bounds
from clubface.design.strokes import Hole
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.errors import InputError, RuleWarning
from clubface.results.result import Described, Result
from clubface.support.checks import without_warnings

if TYPE_CHECKING:
    from clubface.design.golfer import Golfer


MOST_COMBINATIONS = 10_000


@dataclass(frozen=True, kw_only=True)
class Fitting:
    """Parts to choose from and settings to adjust.

    Attributes
    ----------
    title
        Its name in reports.
    golfers
        Each with how much he counts; all deliver as with the first club, and hold every club so.
    objective
        What is judged.
    clubs, balls
        The parts.
    settings
        Named settings of a head: changes of loft, lie, cg_x, cg_y, cg_z [SI].
    bounds
        Least and greatest change of the loft and the lie that can be set freely [SI].
    hole, setting, shots, seed
        As of a study.
    worth
        The smallest difference worth a change, by objective [SI]; that of ``WORTH`` for those left out.
    """

    title: str
    golfers: tuple[tuple[Golfer, float], ...]
    objective: str
    clubs: tuple[Club, ...]
    balls: tuple[Ball | None, ...] = (None,)
    settings: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    bounds: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    hole: Hole | None = None
    setting: Setting = DEFAULT_SETTING
    shots: int = 10_000
    seed: int = 1
    worth: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.judge(self.objective)
        object.__setattr__(self, "worth", worth_of(self.worth))
        count = len(self.clubs) * len(self.balls) * max(len(self.settings), 1)
        if not 1 <= count <= MOST_COMBINATIONS:
            raise InputError("combinations of parts", count, f"from 1 to {MOST_COMBINATIONS}")
        for head, setting in product(self.clubs, self.settings or ("",)):
            self._check_setting(head, setting)
            check_bounds(head, self.free(head, self.set(head, setting)), "fit")

    def _check_setting(self, head: Club, setting: str) -> None:
        """Refuse a setting with which a head is none that can be."""
        try:
            with without_warnings(RuleWarning):
                head.replace(**{name: value for name, value in self.set(head, setting).items() if name != "lie"})
        except InputError as error:
            raise InputError("fit.setting", setting, f"changes with which {head.name} is a head: {error}") from None

    @property
    def counted_hole(self) -> Hole | None:
        """The hole on which strokes are counted: the one given, the assumed one for a wood, None for an iron."""
        return hole_for(self.clubs[0], self.hole)

    def judge(self, name: str) -> Objective:
        """Return an objective by its name."""
        return objective(name, self.counted_hole)

    @property
    def judges(self) -> tuple[Objective, ...]:
        """All objectives that can be computed, those of the advice first."""
        names = [each.name for each in self.advised]
        return (*self.advised, *(each for each in objectives(self.counted_hole) if each.name not in names))

    @property
    def advised(self) -> tuple[Objective, ...]:
        """The objectives that the advice compares, the one asked for first."""
        return advised(self.objective, self.counted_hole)

    def set(self, head: Club, setting: str) -> dict[str, float]:
        """Return the fields of a head that a setting changes, and its lie [SI]."""
        return changed(head, self.settings[setting] if setting else {})

    def free(self, head: Club, club: Mapping[str, float]) -> dict[str, tuple[float, float]]:
        """Return least and greatest value of what can be set freely [SI], about a head with fields set."""
        middle = {name: club.get(name, own_value(head, name)) for name in self.bounds}
        return {name: (middle[name] + low, middle[name] + high) for name, (low, high) in self.bounds.items()}

    def samples(self) -> list[tuple[Mapping[str, Any], float]]:
        """Return the shots of every golfer as he delivers with the first club, and how much he counts."""
        hand, drawn = self.clubs[0].hand, {"seed": self.seed, "threads": self.setting.threads or None}
        return [(each.for_hand(hand).sample(self.shots, **drawn), weight) for each, weight in self.golfers]

    def names(self) -> list[tuple[Club, Ball | None, str]]:
        """Return all combinations of club, ball and setting."""
        return list(product(self.clubs, self.balls, self.settings or ("",)))


def changed(head: Club, changes: Mapping[str, float]) -> dict[str, float]:
    """Return the fields of a head that its changes set, the lie as a change."""
    return {name: change if name == "lie" else getattr(head, name) + change for name, change in changes.items()}


def landings(fitting: Fitting, combination: Combination) -> list[Any]:
    """Return where the shots of every golfer land with a combination [m], each of shape (landings, shots)."""
    head, ball, _ = fitting.names()[combination.place]
    club = changed(head, combination.changes)
    return [each.of(club) for each, _ in golfer_landings(fitting, head, ball, fitting.samples())]


def present_landings(fitting: Fitting) -> list[Any]:
    """Return where the shots of every golfer land with the first club and ball as they are, like :func:`landings`."""
    return [each.of({}) for each, _ in golfer_landings(fitting, *fitting.names()[0][:2], fitting.samples())]


def golfer_landings(fitting: Fitting, head: Club, ball: Ball | None, samples: Any) -> list[tuple[Landings, float]]:
    """Return the shots of the golfers with a head and a ball."""
    own, base_loft = replace(fitting.setting, ball=ball), fitting.clubs[0].loft
    result = []
    for sample, weight in samples:
        # The golfer delivers his loft with the first club; another head delivers as much more as it has more of it.
        delivered = {**sample, "loft": sample.get("loft", base_loft) + (head.loft - base_loft)}
        result.append((Landings(head, delivered, own), weight))
    return result


SETTINGS = ("loft", "lie", "cg_x", "cg_y", "cg_z")
"""What a setting of a head may change."""
WORDS = {
    "loft": ("more loft", "less loft"), "lie": ("more upright", "flatter"),
    "cg_x": ("back", "forward"), "cg_y": ("lower", "higher"),
    "cg_z": ("closer to the heel", "closer to the toe"),
}  # fmt: skip
"""What a positive and a negative change of a setting mean; the CG is given by the way from it to the face centre."""


class Combination(NamedTuple):
    """One club as it can be put together.

    Attributes
    ----------
    club
        Its name.
    ball
        The name of the ball.
    setting
        The name of the setting of the head, "" where there are none.
    changes
        What loft, lie and CG are changed by [SI]; adjusted values among them.
    value
        What it is judged by [SI].
    others
        The other numbers of the shots, by name [SI].
    error
        Standard error of the difference from the best [SI], 0 for the best itself.
    place
        Index of the combination in :meth:`Fitting.names`.
    rank
        1 for the best; those that do not differ by what is worth a change share one.
    """

    club: str
    ball: str
    setting: str
    changes: Mapping[str, float]
    value: float
    others: Mapping[str, float]
    error: float
    place: int
    rank: int = 1


class Effect(NamedTuple):
    """How much one kind of part matters: the most that it changes an objective, all else being equal.

    Attributes
    ----------
    part
        "club", "ball" or "setting".
    objective
        The name of an objective.
    difference, error
        The greatest difference between two of the parts, and its standard error [SI].
    matters
        Whether the difference is worth a change and statistically clear.
    """

    part: str
    objective: str
    difference: float
    error: float
    matters: bool


class Fitted(list[Combination], Described):
    """The combinations of a fitting, those that share the best rank first.

    Attributes
    ----------
    fitting
        What was chosen among.
    advice
        The present club, all combinations, and those that are best by other objectives.
    effects
        How much clubs, balls and settings matter, by objective.
    alternatives
        The clubs of the advice after the present one, in its order.
    others
        How many of the last alternatives of the advice were set for other objectives.
    """

    def __init__(
        self,
        combinations: list[Combination],
        fitting: Fitting,
        advice: Advice,
        effects: tuple[Effect, ...],
        alternatives: tuple[Combination, ...],
        others: int,
    ) -> None:
        super().__init__(combinations)
        self.fitting, self.advice, self.effects = fitting, advice, effects
        self.alternatives, self.others = alternatives, others

    @property
    def leading(self) -> Combination | None:
        """The club that the advice opens with: to change to, or to consider where none is; None for the present one."""
        place = self.advice.recommended() or self.advice.best(self.advice.purpose)
        return self.alternatives[place - 1] if place else None

    def to_result(self) -> Result:
        """Return the combinations and the advice as a result."""
        return import_module("clubface.design.optimisation.fitting_result").fitting_result(self)


def describe(each: Combination, *, with_ball: bool = True) -> str:
    """Write a combination in words: "driver with the ball modern, the setting "back", 1.0 deg more loft"."""
    parts = [f"{each.club} with the ball {each.ball}" if with_ball else each.club]
    parts += [f'the setting "{each.setting}"'] if each.setting else []
    changed = describe_changes(each.changes)
    return ", ".join([*parts, changed] if changed else parts)


def describe_changes(changes: Mapping[str, float]) -> str:
    """Write the changes of a setting: "1.0 deg more loft, CG 3.0 mm forward"; nothing where none changes."""
    return ", ".join("CG " * name.startswith("cg") + words for name, words in change_words(changes).items())


def change_words(changes: Mapping[str, float]) -> dict[str, str]:
    """Return each change that counts in words: "1.0 deg more loft" and "3.0 mm forward"."""
    parts = {}
    for name, change in changes.items():
        unit = "deg" if name in ("loft", "lie") else "mm"
        size = f"{abs(units.from_si(change, unit)):.1f}"
        if float(size):
            parts[name] = f"{size} {unit} {WORDS[name][change < 0.0]}"
    return parts
