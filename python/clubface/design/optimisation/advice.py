"""Advice: which of several alternatives a golfer should play, by what counts, and which differences are worth a change.

Every command that advises a golfer, a fitting, an optimisation and the best loft, asks the same question of the same
numbers: is an alternative better than the present one by at least the smallest difference that is worth a change? All
of them present the answer in the same sentences, tables and panel.
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
from clubface.results.table import Column, Table, text
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
    """Return the smallest difference worth a change of every objective [SI]: those given, ``WORTH`` for the others.

    A name that is none of an objective, or a value that is not above 0, is an ``InputError``.
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
    """What optimisations and fittings have in common; their attributes are described there."""

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
        """The club with which the golfers deliver as they do."""
        raise NotImplementedError

    @property
    def purpose(self) -> str:
        """The name of the objective that was asked for first."""
        raise NotImplementedError

    @property
    def counted_hole(self) -> Hole | None:
        """The hole on which strokes are counted: the one given, the assumed one for a wood, None for an iron."""
        driven = self.present.parameters == "driver" and self.present.loft < DRIVEN
        return ASSUMED_HOLE if self.hole is None and driven else self.hole

    def judge(self, name: str) -> Objective:
        """Return an objective by its name."""
        return objective(name, self.counted_hole)

    def known(self) -> tuple[Objective, ...]:
        """Return all objectives that can be computed."""
        return objectives(self.counted_hole)

    @property
    def advised(self) -> tuple[Objective, ...]:
        """The objectives that the advice compares, the one asked for first."""
        known = {each.name: each for each in self.known()}
        return tuple(known[name] for name in dict.fromkeys((self.purpose, *ADVISED)) if name in known)

    def samples(self, shots: int, seed: int) -> list[tuple[dict[str, Floats], float]]:
        """Return the deliveries of every golfer with the present club, and how much he counts."""
        hand, threads = self.present.hand, self.setting.threads or None
        return [
            (each.for_hand(hand).sample(shots, seed=seed, threads=threads), weight) for each, weight in self.golfers
        ]

    def describe_conditions(self, shots: int) -> str:
        """Return in words how many shots are judged, by which model, on which hole."""
        where = f"; hole of {self.hole.describe()}" if self.hole is not None else ""
        return f"{f'{shots} shots' if shots > 1 else 'one delivery'} by the model {self.setting.model}{where}"

    def advice(self, names: Sequence[str], values: Floats, sets: Floats, shots: int, **options: Any) -> Advice:
        """Return the advice on alternatives, of which the first is the present one; see :class:`Advice`."""
        return Advice(
            purpose=self.purpose, golfer=" and ".join(golfer.title or golfer.name for golfer, _ in self.golfers),
            objectives=self.advised, names=tuple(names), values=values, sets=sets, worth=self.worth,
            conditions=self.describe_conditions(shots),
            assumed_hole=self.hole is None and self.counted_hole is not None, **options,
        )  # fmt: skip


def judge_sets(
    judges: Sequence[Objective], golfers: Sequence[tuple[Landings, float, Floats]], sets: int = SETS
) -> Floats:
    """Return objectives in sets of shots, the weighted mean of golfers, shape (sets, objectives).

    ``golfers`` are their shots, how much each counts, and the landings [m]. There are as many sets, at most, as have
    ``FEWEST`` shots each.
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


_SHORT = {
    "carry": "carry", "total": "total distance", "side_spread": "spread to the side", "ellipse": "ellipse",
    "strokes": "strokes",
}  # fmt: skip
_LETTERS = 36
"""Most letters in a line of the name of an alternative in a picture."""
WORTHS = Quantity("worth", "1", Reading("1", 1), Reading("1", 1), "gain, in differences worth a change")


def short_label(judge: Objective) -> str:
    """Return what an objective counts, in sentences: "spread to the side"."""
    return _SHORT[judge.name]


def advice_lead(advice: Advice) -> Iterator[Note]:
    """Yield what to do in one sentence, what it is for, and what holds under other objectives."""
    yield _opening(advice)
    chosen = advice.recommended()
    states = advice.states(chosen)
    yield note("advice-purpose", meaning=advice.objectives[0].meaning, conditions=advice.conditions)
    level = [place for place in advice.as_good(advice.purpose, chosen) if place != chosen]
    if chosen and level:
        judge = advice.objectives[0]
        others = [
            f"{advice.names[place]} (better by {_amount(judge, advice.gain(judge.name, place))})" for place in level
        ]
        yield note("advice-as-good", label=short_label(judge), others=others)
    if losses := losses_in_words(advice, advice.purpose, chosen):
        yield note("advice-costs", best=advice.names[chosen], losses=losses)
    elif chosen and all(state in (BETTER, ALIKE) for state in states.values()):
        yield note("advice-holds", best=advice.names[chosen], present=advice.names[0], labels=_labels(advice))
    if len({advice.best(each.name) for each in advice.objectives}) > 1:
        yield note("advice-by-objective", wishes=[_wish(advice, each) for each in advice.objectives])


def _opening(advice: Advice) -> Note:
    """Return what to do, in one sentence."""
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


def _wish(advice: Advice, judge: Objective) -> str:
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
    """Return in words what an alternative costs by the other objectives."""
    judges = {each.name: each for each in advice.objectives}
    losses = advice.losses(name, alternative)
    return [
        _amount(judges[each], loss) + (f" of {short_label(judges[each])}" if each != "strokes" else "")
        for each, loss in losses.items()
    ]


def _amount(judge: Objective, value: float) -> str:
    """Return a value with its unit in a sentence: "0.0220 strokes"."""
    return judge.show(value) + (" strokes" if judge.name == "strokes" else "")


def advice_notes(advice: Advice) -> Iterator[Note]:
    """Yield what is to be known about the tables."""
    sizes = [f"{short_label(each)} {each.show(advice.worth[each.name])}" for each in advice.objectives]
    yield note("advice-worth", sizes=sizes)
    yield note("advice-errors" if advice.sets.std(axis=1).any() else "advice-single-delivery")
    if advice.sets.std(axis=1).any():
        yield note("advice-mishits")
    if advice.assumed_hole:
        yield note("advice-hole-assumed", hole=ASSUMED_HOLE.describe())


def advice_tables(
    advice: Advice, fields: Sequence[Column] = (), shown: Sequence[int] | None = None
) -> tuple[Table, Table, Table]:
    """Return what to do by objective, the alternatives with all objectives, and what separates them.

    ``fields`` are further columns of the alternatives, such as their lofts; ``shown`` are those that people see, None
    for all.
    """
    shown = range(len(advice.names)) if shown is None else shown
    return _by_objective(advice), _alternatives(advice, fields, shown), _differences(advice, shown)


def _by_objective(advice: Advice) -> Table:
    """Return for each objective which alternative is best by it, by how much, if that is worth a change, and its price.

    They are those of the sentence on what each objective alone would choose.
    """
    judges = advice.objectives
    kinds = [each.quantity for each in judges]
    pairs = [(each.name, advice.best(each.name)) for each in judges]
    words = [{BETTER: "change", OPEN: "not certain"}.get(advice.state(*pair), "keep") for pair in pairs]
    prices = [", ".join(losses_in_words(advice, *pair)) for pair in pairs]
    columns = (
        text("objective", [each.name for each in judges], printed=False),
        text("what counts", [each.label for each in kinds], in_files=False),
        text("advice", words, label="alone"),
        Column("present", [float(each) for each in advice.values[0]], kinds),
        Column("gain", [advice.gain(*pair) for pair in pairs], kinds, "to gain", difference=True),
        Column("error", [advice.error(*pair) for pair in pairs], kinds, "±"),
        Column("worth", [advice.worth[each.name] for each in judges], kinds, "worth a change"),
        text("best", [advice.names[place] for _, place in pairs], label="with"),
        text("price", prices, label="at the price of", printed=any(prices)),
    )
    return Table("advice", columns, "What each objective alone would choose")


def _alternatives(advice: Advice, fields: Sequence[Column], shown: Sequence[int]) -> Table:
    every = range(len(advice.names))
    ranks = advice.ranks(every)
    columns = (
        text("alternative", advice.names),
        text("place", [ranks[place] for place in every]),
        *fields,
        *(Column(judge.name, [float(each) for each in advice.values[:, column]], judge.quantity)
          for column, judge in enumerate(advice.objectives)),
    )  # fmt: skip
    title = f"Alternatives; those of one place do not differ in {short_label(advice.objectives[0])}"
    return Table("alternatives", columns, title, shown_rows=shown)


def _differences(advice: Advice, shown: Sequence[int]) -> Table:
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
    """Return in words by which objectives an alternative is better or worse than the present one."""
    states = advice.states(alternative)
    by_state: Mapping[str, list[str]] = {
        state: [short_label(each) for each in advice.objectives if states[each.name] == state]
        for state in (BETTER, WORSE, OPEN)
    }
    parts = [f"{state}: {', '.join(labels)}" for state, labels in by_state.items() if labels]
    return "; ".join(parts) or "no difference worth a change"


def gains_panel(advice: Advice, rows: int) -> Panel:
    """Return what the first alternatives gain on the present one by each objective, in differences worth a change."""
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
    names = ["\n".join(textwrap.wrap(advice.names[place], _LETTERS)) for place in places]
    return Panel(
        marks, Axis(WORTHS), axis(names=names, reversed=True, limits=(len(places) - 0.4, -0.6)),
        f"Gain on the {advice.names[0]}; within the grey it is not worth a change", legend=True,
    )  # fmt: skip
