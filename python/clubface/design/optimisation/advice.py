"""Advice: which of several alternatives a golfer should play, by objective, and which differences are worth a change.

Fittings, optimisations and loft fits all ask whether an alternative is better than the present one by at least the
smallest difference worth a change, and present the answer in the same sentences, tables and panel.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from clubface import units
from clubface.design.golfer import Golfer
from clubface.design.optimisation.landings import (
    DEFAULT_SETTING,
    JUDGED,
    Landings,
    Objective,
    Setting,
    objective,
    objectives,
)
from clubface.design.strokes import Hole
from clubface.equipment.clubs import Club
from clubface.errors import InputError
from clubface.quantities import Quantity, Reading
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, axis
from clubface.results.table import Column, Table, row_names, text
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice

WORTH: Mapping[str, float] = {
    "carry": units.parse("2 yd", "length"),
    "total": units.parse("2 yd", "length"),
    "side_spread": units.parse("1 yd", "length"),
    "ellipse": 150.0,
    "strokes": 0.01,
}
"""The smallest difference worth a change, by objective [SI].

A hundredth of a stroke per drive makes 0.14 strokes over the 14 drives of a round, just above the 0.1 to which a
Handicap Index is given (Rules of Handicapping, rule 5.2a). The others are about equivalent in Broadie's strokes: on a
400-yard hole the shipped golfers' drives cost 0.003 to 0.006 strokes per yard of lost distance, and 0.014 to 0.017 per
yard of standard deviation sideways, which makes the ellipse 65 to 207 m2 larger.
"""
ADVISED = ("carry", "total", "side_spread", "strokes")
"""Objectives that advice always compares; strokes only with a hole."""
CERTAIN = 2.0
"""Number of standard errors above which a difference is significant: chance exceeds it in 1 of 20 cases."""
SETS = 16
"""Number of sets of shots; the spread between them gives the standard error of a difference."""
FEWEST = 8
"""Minimum number of shots in a set; with fewer, the sideways spread would be biased low."""
ASSUMED_HOLE = Hole(length=units.parse("400 yd", "length"))
"""Default hole for counting a wood's strokes; assumed."""
DRIVEN = np.radians(20.0)
"""Static loft below which a wood is assumed to be played from the tee of :data:`ASSUMED_HOLE` [rad]."""

DRIVES = 14
"""Drives in a round: the par 4s and par 5s of a par-72 course."""
NEGLIGIBLE = 0.1
"""Share of a difference worth a change below which another alternative adds nothing."""
END = 1e-3
"""Share of the range tried within which a value counts as at its end."""

BETTER, WORSE, ALIKE, OPEN = "better", "worse", "alike", "not certain"


def worth_of(given: Mapping[str, Any] | None) -> dict[str, float]:
    """Return the smallest difference worth a change by objective [SI]: the given values, otherwise ``WORTH``.

    An unknown objective or a value that is not positive raises an ``InputError``.
    """
    result = dict(WORTH)
    for name, value in (given or {}).items():
        check_choice("objective", name, WORTH)
        size = units.parse(value, units.unit(JUDGED[name]).dimension, name=f"worth.{name}")
        if not size > 0.0:
            raise InputError(f"worth.{name}", value, "above 0")
        result[name] = size
    return result


@dataclass(frozen=True, kw_only=True)
class AdvisedStudy:
    """Common attributes of optimisations and fittings, which describe them."""

    title: str
    golfers: tuple[tuple[Golfer, float], ...]
    hole: Hole | None = None
    setting: Setting = DEFAULT_SETTING
    shots: int = 10_000
    seed: int = 1
    worth: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "worth", worth_of(self.worth))

    @property
    def present(self) -> Club:
        """The golfers' present club, with which their deliveries were made."""
        raise NotImplementedError

    @property
    def purpose(self) -> str:
        """Name of the main objective."""
        raise NotImplementedError

    @property
    def counted_hole(self) -> Hole | None:
        """The hole for counting strokes: the given one or, by default, the assumed one for a driver."""
        driven = self.present.parameters == "driver" and self.present.loft < DRIVEN
        return ASSUMED_HOLE if self.hole is None and driven else self.hole

    def judge(self, name: str) -> Objective:
        """Return an objective by name."""
        return objective(name, self.counted_hole)

    def known(self) -> tuple[Objective, ...]:
        """Return all objectives that can be computed."""
        return objectives(self.counted_hole)

    @property
    def advised(self) -> tuple[Objective, ...]:
        """Objectives compared by the advice, the main one first."""
        known = {each.name: each for each in self.known()}
        return tuple(known[name] for name in dict.fromkeys((self.purpose, *ADVISED)) if name in known)

    def samples(self, shots: int, seed: int) -> list[tuple[dict[str, Floats], float]]:
        """Return deliveries with the present club and weight of every golfer."""
        golfers = [(each.for_hand(self.present.hand), weight) for each, weight in self.golfers]
        threads = self.setting.threads or None
        return [(each.sample(shots, seed=seed, threads=threads), weight) for each, weight in golfers]

    def describe_conditions(self, shots: int) -> str:
        """Return a description of the number of shots, the model and the hole."""
        where = f"; hole of {self.hole.describe()}" if self.hole is not None else ""
        return f"{f'{shots} shots' if shots > 1 else 'one delivery'} by the model {self.setting.model}{where}"

    def advice(self, names: Sequence[str], values: Floats, sets: Floats, shots: int, **options: Any) -> Advice:
        """Return the advice on alternatives, the first of which is the present one; see :class:`Advice`."""
        return Advice(
            purpose=self.purpose, golfer=" and ".join(golfer.title or golfer.name for golfer, _ in self.golfers),
            objectives=self.advised, names=tuple(names), values=values, sets=sets, worth=self.worth,
            conditions=self.describe_conditions(shots),
            assumed_hole=self.hole is None and self.counted_hole is not None, **options,
        )  # fmt: skip


def judge_sets(
    judges: Sequence[Objective], golfers: Sequence[tuple[Landings, float, Floats]], sets: int = SETS
) -> Floats:
    """Return objectives in sets of shots, averaged over golfers by weight, shape (sets, objectives).

    ``golfers`` holds shots, weight and landings [m] of each. The number of sets is reduced so that each has at least
    ``FEWEST`` shots.
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
    """Alternatives compared by several objectives on the same shots, and what a golfer should do.

    Attributes
    ----------
    purpose, golfer
        Name of the main objective, and description of the golfer or golfers.
    objectives
        All objectives, the main one first.
    names
        Descriptions of the alternatives; the first is the present one.
    values
        Objectives of the alternatives [SI], shape (alternatives, objectives).
    sets
        The same for separate sets of shots, shape (alternatives, sets, objectives); their spread gives the standard
        errors of differences.
    worth
        The smallest difference worth a change, by objective [SI].
    choices
        Alternatives that may be recommended for the main objective; default all.
    conditions, assumed_hole
        Description of shots, model and hole, and whether the hole is the assumed one.
    at_an_end
        Alternatives at an end of the range tried, so that the true optimum may lie beyond.
    """

    purpose: str
    golfer: str
    objectives: tuple[Objective, ...]
    names: tuple[str, ...]
    values: Floats
    sets: Floats
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
        """Return the gain of an alternative over another by an objective [SI]; negative if it is worse."""
        column = self.place(name)
        sign = -self.objectives[column].sign
        return float(sign * (self.values[alternative, column] - self.values[other, column]))

    def error(self, name: str, alternative: int, other: int = 0) -> float:
        """Return the standard error of :meth:`gain`; NaN with too few shots."""
        if alternative == other:
            return 0.0
        differences = self.sets[alternative, :, self.place(name)] - self.sets[other, :, self.place(name)]
        if len(differences) < 2:
            return float("nan")
        return float(differences.std(ddof=1) / np.sqrt(len(differences)))

    def state(self, name: str, alternative: int, other: int = 0) -> str:
        """Return how an alternative compares with another by an objective.

        "better" and "worse" mean a statistically clear difference that is worth a change, "alike" one that is clearly
        not worth a change, and "not certain" that the shots do not decide.
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

        It is the best of those that beat the present one by a difference worth a change; if there is none, the one with
        the best value, which may be the present one.
        """
        open_to = self._open_to(name)
        better = [place for place in open_to if self.state(name, place) == BETTER]
        return max(better or (0, *open_to), key=lambda place: self.gain(name, place))

    def losses(self, name: str, alternative: int) -> dict[str, float]:
        """Return the losses of an alternative by the other objectives that are worth a change [SI]."""
        states = self.states(alternative)
        return {
            each.name: -self.gain(each.name, alternative)
            for each in self.objectives
            if each.name != name and states[each.name] == WORSE
        }

    def _open_to(self, name: str) -> Sequence[int]:
        """Return the alternatives that may be recommended for an objective."""
        return range(1, len(self.names)) if self.choices is None or name != self.purpose else self.choices

    def recommended(self, name: str | None = None) -> int:
        """Return the alternative to play by an objective (default the main one); 0 for the present one.

        The present one stays unless another is better by a difference worth a change. If several are level with the
        best, it is the one that loses by the fewest other objectives, and the first of these.
        """
        name = name or self.purpose
        best = self.best(name)
        if self.state(name, best) != BETTER:
            return 0
        level = [place for place in self.as_good(name, best) if place in self._open_to(name)]
        return min(level, key=lambda place: list(self.states(place).values()).count(WORSE))

    def as_good(self, name: str, alternative: int) -> list[int]:
        """Return all that are better than the present one and level with an alternative, including the alternative."""
        return [
            place for place in range(1, len(self.names))
            if self.state(name, place) == BETTER and self.state(name, place, alternative) not in (BETTER, WORSE)
        ]  # fmt: skip

    def ranks(self, places: Sequence[int], name: str | None = None) -> dict[int, int]:
        """Return the rank of alternatives by an objective, 1 for the best; ties share a rank.

        The best and all that are not clearly worse than it by a difference worth a change rank first; the best of the
        others and all that are not clearly worse than it come next, and so on.
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
    """Return whether an alternative's ``value`` of an objective [SI] hardly improves on the others."""
    return any(judge.sign * (other - value) < NEGLIGIBLE * worth for other in others)


def is_at_an_end(value: float, limits: tuple[float, float]) -> bool:
    """Return whether a value is at an end of the range tried, so that the optimum may lie beyond."""
    low, high = limits
    return min(value - low, high - value) < END * (high - low)


_SHORT = {
    "carry": "carry", "total": "total distance", "side_spread": "spread to the side", "ellipse": "ellipse",
    "strokes": "strokes",
}  # fmt: skip
_LINE_LENGTH = 36
"""Maximum number of characters per line of an alternative's name in a picture."""
WORTHS = Quantity("worth", "1", Reading("1", 1), Reading("1", 1), "gain over the smallest worthwhile difference")


def short_label(judge: Objective) -> str:
    """Return an objective's name for use in sentences, such as "spread to the side"."""
    return _SHORT[judge.name]


def advice_lead(advice: Advice) -> Iterator[Note]:
    """Yield one sentence on what to do, its purpose, and how it fares by other objectives."""
    yield _recommendation(advice)
    chosen = advice.recommended()
    states = advice.states(chosen)
    yield note("advice-purpose", meaning=advice.objectives[0].meaning, conditions=advice.conditions)
    level = [place for place in advice.as_good(advice.purpose, chosen) if place != chosen]
    if chosen and level:
        judge = advice.objectives[0]
        others = [f"{advice.names[row]} (better by {_amount(judge, advice.gain(judge.name, row))})" for row in level]
        yield note("advice-as-good", label=short_label(judge), others=others)
    if losses := losses_in_words(advice, advice.purpose, chosen):
        yield note("advice-costs", best=advice.names[chosen], losses=losses)
    elif chosen and all(state in (BETTER, ALIKE) for state in states.values()):
        yield note("advice-holds", best=advice.names[chosen], present=advice.names[0], labels=_labels(advice))
    if len({advice.best(each.name) for each in advice.objectives}) > 1:
        yield note("advice-by-objective", wishes=[_best_by_objective(advice, each) for each in advice.objectives])


def _recommendation(advice: Advice) -> Note:
    """Return one sentence on what to do."""
    judge, chosen = advice.objectives[0], advice.recommended()
    best = chosen or advice.best(judge.name)
    gain, error = (judge.show(each) for each in (advice.gain(judge.name, best), advice.error(judge.name, best)))
    common = {"present": advice.names[0], "golfer": advice.golfer, "label": short_label(judge)}
    if chosen:
        before, after = (judge.show(float(advice.values[place, 0])) for place in (0, chosen))
        data = {**common, "best": advice.names[chosen], "gain": gain, "error": error, "before": before, "after": after}
        if judge.name != "strokes":
            return note("advice-change", **data)
        return note("advice-change-strokes", **data, drives=DRIVES, round=DRIVES * advice.gain(judge.name, chosen))
    if best and advice.state(judge.name, best) == OPEN:
        return note("advice-not-certain", **common, best=advice.names[best], gain=gain, error=error)
    others = range(1, len(advice.names))
    if not any(state in (BETTER, OPEN) for place in others for state in advice.states(place).values()):
        return note("advice-keep-all", **common, alternatives=len(others), labels=_labels(advice))
    worth = judge.show(advice.worth[judge.name])
    return note("advice-keep", **common, worth=worth, most=gain)


def _labels(advice: Advice) -> list[str]:
    return [short_label(each) for each in advice.objectives]


def _best_by_objective(advice: Advice, judge: Objective) -> str:
    best = advice.best(judge.name)
    if not best:
        return f"{short_label(judge)}, the {advice.names[0]}"
    gain = _amount(judge, advice.gain(judge.name, best))
    state = advice.state(judge.name, best)
    enough = {BETTER: "worth a change", OPEN: "not certain"}.get(state, "not worth a change")
    price = losses_in_words(advice, judge.name, best)
    if state == BETTER and price:
        enough += f" only if nothing else counts: it costs {', '.join(price)}"
    if best in advice.at_an_end:
        enough += "; at an end of what was tried, and so no optimum"
    return f"{short_label(judge)}, {advice.names[best]} (better by {gain}, {enough})"


def losses_in_words(advice: Advice, name: str, alternative: int) -> list[str]:
    """Return what an alternative costs by the other objectives, in words."""
    judges = {each.name: each for each in advice.objectives}
    losses = advice.losses(name, alternative)
    return [
        _amount(judges[each], loss) + (f" of {short_label(judges[each])}" if each != "strokes" else "")
        for each, loss in losses.items()
    ]


def _amount(judge: Objective, value: float) -> str:
    """Return a value with its unit for use in a sentence, such as "0.0220 strokes"."""
    return judge.show(value) + (" strokes" if judge.name == "strokes" else "")


def advice_notes(advice: Advice) -> Iterator[Note]:
    """Yield the notes below the tables."""
    sizes = [f"{short_label(each)} {each.show(advice.worth[each.name])}" for each in advice.objectives]
    yield note("advice-worth", sizes=sizes)
    varies = advice.sets.std(axis=1).any()
    yield note("advice-errors" if varies else "advice-single-delivery")
    if varies:
        yield note("advice-mishits")
    if advice.assumed_hole:
        yield note("advice-hole-assumed", hole=ASSUMED_HOLE.describe())


def advice_tables(
    advice: Advice, fields: Sequence[Column] = (), shown: Sequence[int] | None = None
) -> tuple[Table, Table, Table]:
    """Return tables of the advice by objective, the alternatives with all objectives, and their differences.

    ``fields`` are extra columns of the alternatives, such as their lofts; ``shown`` are the alternatives printed (None:
    all).
    """
    shown = range(len(advice.names)) if shown is None else shown
    return _objective_table(advice), _alternatives_table(advice, fields, shown), _differences_table(advice, shown)


def _objective_table(advice: Advice) -> Table:
    """Return for each objective its best alternative, the gain, whether that is worth a change, and the price."""
    judges = advice.objectives
    kinds = [each.quantity for each in judges]
    pairs = [(each.name, advice.best(each.name)) for each in judges]
    words = [{BETTER: "change", OPEN: "not certain"}.get(advice.state(*pair), "keep") for pair in pairs]
    prices = [", ".join(losses_in_words(advice, *pair)) for pair in pairs]
    columns = (
        *row_names("objective", [each.name for each in judges], [each.label for each in kinds]),
        text("advice", words),
        Column("present", [float(each) for each in advice.values[0]], kinds),
        Column("gain", [advice.gain(*pair) for pair in pairs], kinds, difference=True),
        Column("error", [advice.error(*pair) for pair in pairs], kinds, "±"),
        Column("worth", [advice.worth[each.name] for each in judges], kinds, "worth a change"),
        text("best", [advice.names[place] for _, place in pairs], label="best alternative"),
        text("price", prices, label="costs", printed=any(prices)),
    )
    return Table("advice", columns, "Best alternative by objective")


def _alternatives_table(advice: Advice, fields: Sequence[Column], shown: Sequence[int]) -> Table:
    every = range(len(advice.names))
    ranks = advice.ranks(every)
    columns = (
        text("alternative", advice.names),
        text("place", [ranks[place] for place in every], label="rank"),
        *fields,
        *(Column(judge.name, [float(each) for each in advice.values[:, column]], judge.quantity)
          for column, judge in enumerate(advice.objectives)),
    )  # fmt: skip
    title = f"Alternatives, ranked by {short_label(advice.objectives[0])}; equal ranks are ties"
    return Table("alternatives", columns, title, shown_rows=shown)


def _differences_table(advice: Advice, shown: Sequence[int]) -> Table:
    every = range(1, len(advice.names))
    columns = [text("alternative", advice.names[1:])]
    for place, judge in enumerate(advice.objectives):
        changes = [float(advice.values[row, place] - advice.values[0, place]) for row in every]
        errors = [advice.error(judge.name, row) for row in every]
        columns += [
            Column(f"{judge.name}_difference", changes, judge.quantity, judge.quantity.label, difference=True),
            Column(f"{judge.name}_error", errors, judge.quantity, "±"),
            text(f"{judge.name}_verdict", [advice.state(judge.name, row) for row in every], printed=False),
        ]
    columns.append(text("verdict", [_verdict(advice, row) for row in every], in_files=False))
    rows = [row - 1 for row in shown if row]
    return Table("differences", tuple(columns), f"Differences from the {advice.names[0]}", shown_rows=rows)


def _verdict(advice: Advice, alternative: int) -> str:
    """Return by which objectives an alternative is better or worse than the present one, in words."""
    states = advice.states(alternative)
    by_state: Mapping[str, list[str]] = {
        state: [short_label(each) for each in advice.objectives if states[each.name] == state]
        for state in (BETTER, WORSE, OPEN)
    }
    parts = [f"{state}: {', '.join(labels)}" for state, labels in by_state.items() if labels]
    return "; ".join(parts) or "no difference worth a change"


def gains_panel(advice: Advice, rows: int) -> Panel:
    """Return the gain of the first alternatives over the present one, in multiples of what is worth a change."""
    places = range(1, min(rows, len(advice.names) - 1) + 1)
    marks = [Mark("shade", x0=-1.0, x1=1.0, style=-1), Mark("rule", x=0.0, style=-1)]
    away = 0.6 * (np.arange(len(advice.objectives)) / max(len(advice.objectives) - 1, 1) - 0.5)
    for style, (judge, below) in enumerate(zip(advice.objectives, away, strict=True)):
        worth = advice.worth[judge.name]
        gains = np.array([advice.gain(judge.name, place) for place in places]) / worth
        errors = CERTAIN * np.nan_to_num([advice.error(judge.name, place) for place in places]) / worth
        marks.append(Mark(
            "intervals", gains, np.array(places) - 1 + below, x0=gains - errors, x1=gains + errors, style=style,
            label=f"{short_label(judge)}, {judge.show(worth)}",
        ))  # fmt: skip
    names = ["\n".join(textwrap.wrap(advice.names[place], _LINE_LENGTH)) for place in places]
    return Panel(
        marks, Axis(WORTHS), axis(names=names, reversed=True, limits=(len(places) - 0.4, -0.6)),
        f"Gain over the {advice.names[0]}; the grey band is not worth a change", legend=True,
    )  # fmt: skip
