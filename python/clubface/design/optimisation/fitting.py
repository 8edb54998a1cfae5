"""Fittings: parts and settings to choose from, golfers and objective, and the resulting clubs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import product

from clubface import units
from clubface.design.optimisation.advice import AdvisedStudy
from clubface.design.optimisation.landings import Landings, Objective, own_value
from clubface.design.optimisation.variables import check_bounds
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.errors import InputError, RuleWarning
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings

MOST_COMBINATIONS = 10_000

Samples = list[tuple[dict[str, Floats], float]]
"""Deliveries and weight of every golfer."""


@dataclass(frozen=True, kw_only=True)
class Fitting(AdvisedStudy):
    """Parts to choose from and settings to adjust.

    Attributes
    ----------
    title
        Name in reports.
    golfers
        Golfers with weights; their deliveries are for the first club and carry over to the others.
    objective, worth
        Name of the main objective, and smallest difference worth a change by objective [SI]; default ``WORTH``.
    clubs, balls
        The parts.
    settings
        Named settings of a head: changes of loft, lie, cg_x, cg_y, cg_z [SI].
    bounds
        Range of change of a freely adjustable loft and lie [SI].
    hole, setting, shots, seed
        As for :class:`.DesignStudy`.
    """

    objective: str
    clubs: tuple[Club, ...]
    balls: tuple[Ball | None, ...] = (None,)
    settings: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    bounds: Mapping[str, tuple[float, float]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.judge(self.objective)
        super().__post_init__()
        count = len(self.clubs) * len(self.balls) * max(len(self.settings), 1)
        if not 1 <= count <= MOST_COMBINATIONS:
            raise InputError("combinations of parts", count, f"from 1 to {MOST_COMBINATIONS}")
        for head, setting in product(self.clubs, self.settings or ("",)):
            club = self.set(head, setting)
            try:
                with without_warnings(RuleWarning):
                    adjusted(head, club)
            except InputError as error:
                allowed = f"changes with which {head.name} is a head: {error}"
                raise InputError("fit.setting", setting, allowed) from None
            check_bounds(head, self.free(head, club), "fit")

    @property
    def present(self) -> Club:
        """The first club."""
        return self.clubs[0]

    @property
    def purpose(self) -> str:
        """The objective."""
        return self.objective

    @property
    def judges(self) -> tuple[Objective, ...]:
        """All objectives that can be computed, those in the advice first."""
        names = [each.name for each in self.advised]
        return (*self.advised, *(each for each in self.known() if each.name not in names))

    def set(self, head: Club, setting: str) -> dict[str, float]:
        """Return the head's fields as changed by a setting, and the change of lie [SI]."""
        return changed(head, self.settings[setting] if setting else {})

    def free(self, head: Club, club: Mapping[str, float]) -> dict[str, tuple[float, float]]:
        """Return the range of each freely adjustable field [SI], around a head with the fields ``club``."""
        middle = {name: club.get(name, own_value(head, name)) for name in self.bounds}
        return {name: (middle[name] + low, middle[name] + high) for name, (low, high) in self.bounds.items()}

    def combinations(self) -> list[tuple[Club, Ball | None, str]]:
        """Return all combinations of club, ball and setting."""
        return list(product(self.clubs, self.balls, self.settings or ("",)))

    def landings(self, head: Club, ball: Ball | None, samples: Samples) -> list[tuple[Landings, float]]:
        """Return the shots of the golfers with a head and a ball."""
        own = replace(self.setting, ball=ball)
        result = []
        for sample, weight in samples:
            # Sampled lofts are for the first club; another head changes them by its difference in static loft.
            delivered = sample.get("loft", self.present.loft) + (head.loft - self.present.loft)
            result.append((Landings(head, {**sample, "loft": delivered}, own), weight))
        return result

    def landed(self, place: int, changes: Mapping[str, float]) -> list[Floats]:
        """Return the landings of every golfer's shots [m], each of shape (landings, shots).

        ``place`` is the index of a combination; ``changes`` include its setting.
        """
        head, ball, _ = self.combinations()[place]
        shots = self.landings(head, ball, self.samples(self.shots, self.seed))
        return [each.of(changed(head, changes)) for each, _ in shots]


def changed(head: Club, changes: Mapping[str, float]) -> dict[str, float]:
    """Return the new values of a head's changed fields; the lie remains a change."""
    return {name: change if name == "lie" else getattr(head, name) + change for name, change in changes.items()}


def adjusted(head: Club, fields: Mapping[str, float]) -> Club:
    """Return a head with fields set, except the lie."""
    return head.replace(**{name: value for name, value in fields.items() if name != "lie"})


SETTINGS = ("loft", "lie", "cg_x", "cg_y", "cg_z")
"""Fields that a setting of a head may change."""
WORDS = {
    "loft": ("more loft", "less loft"), "lie": ("more upright", "flatter"),
    "cg_x": ("back", "forward"), "cg_y": ("lower", "higher"),
    "cg_z": ("closer to the heel", "closer to the toe"),
}  # fmt: skip
"""Words for a positive and a negative change; CG coordinates run from the CG to the face centre."""


def describe_changes(changes: Mapping[str, float]) -> str:
    """Return the changes of a setting in words, such as "1.0 deg more loft, CG 3.0 mm forward"; empty for none."""
    return ", ".join("CG " * name.startswith("cg") + words for name, words in change_words(changes).items())


def change_words(changes: Mapping[str, float]) -> dict[str, str]:
    """Return each visible change in words, such as "1.0 deg more loft" or "3.0 mm forward"."""
    parts = {}
    for name, change in changes.items():
        unit = "deg" if name in ("loft", "lie") else "mm"
        size = f"{abs(units.from_si(change, unit)):.1f}"
        if float(size):
            parts[name] = f"{size} {unit} {WORDS[name][change < 0.0]}"
    return parts
