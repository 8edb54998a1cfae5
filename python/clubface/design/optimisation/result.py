"""The result of an optimisation: the club, its objectives on fresh shots, every limit; tables and pictures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from clubface import units
from clubface.design import feasibility
from clubface.design.golfer import golfer_sources
from clubface.design.optimisation import advice as advising
from clubface.design.optimisation.advice import CERTAIN, Advice, AdvisedStudy
from clubface.design.optimisation.fitting import change_words
from clubface.design.optimisation.landings import FREE, SHARE, own_value
from clubface.design.optimisation.study import UNITS, DesignStudy, field_quantity, shown_quantity
from clubface.design.optimisation.variables import PointMass, placement
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.rules import RuleVerdict
from clubface.errors import RuleWarning
from clubface.quantities import Quantity, Reading
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis, ellipse_about
from clubface.results.result import Described, Provenance, Result
from clubface.results.table import Column, Table, column, row_names, text
from clubface.simulation.impact import impact
from clubface.simulation.provenance import flight_conditions, provenance_of
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings

MOST_NAMED_FIELDS = 2
"""Maximum number of fields in a club's name."""
ACTIVE = 1e-4
"""Relative margin below which a limit counts as active."""
CLUBS = ("start", "nominal", "optimum")
"""Clubs compared by every optimisation."""
MERGE_DISTANCE = 2e-4
"""Distance [m] within which point masses are merged in the table."""
LEAST_PRINTED_MASS = 5e-5
"""Smallest point mass printed [kg]."""
DRAWN_POINTS = 400
"""Maximum number of shots drawn per club."""


@dataclass(frozen=True)
class Fresh:
    """Clubs evaluated on shots that were not used in the optimisation.

    Attributes
    ----------
    shots, objectives
        Number of shots, and names of the objectives.
    clubs
        "start", "nominal" and "optimum", then the name of every objective with a best club of its own.
    sets
        Values for independent sets of shots [SI], shape (sets, clubs, objectives).
    """

    shots: int
    clubs: tuple[str, ...]
    objectives: tuple[str, ...]
    sets: Floats

    @property
    def values(self) -> Floats:
        """Mean values over all sets [SI], shape (clubs, objectives)."""
        return self.sets.mean(axis=0)

    def value(self, club: str, objective: str) -> float:
        """Return a club's value of an objective [SI]."""
        return float(self.values[self.clubs.index(club), self.objectives.index(objective)])

    def error(self, club: str, objective: str) -> float:
        """Return the standard error of a club's difference from the optimum [SI]."""
        column = self.sets[:, :, self.objectives.index(objective)]
        differences = column[:, self.clubs.index(club)] - column[:, self.clubs.index("optimum")]
        return float(differences.std(ddof=1) / np.sqrt(len(differences)))


@dataclass(frozen=True)
class FrontPoint:
    """A club on the Pareto front between two objectives: its changed fields, and the objectives' values [SI]."""

    club: Mapping[str, float]
    values: Mapping[str, float]


@dataclass(frozen=True)
class Verdict:
    """How the optimum meets one limit.

    Attributes
    ----------
    limit, quantity
        Description of the limit, and the limited quantity.
    value, least, most
        The optimum's value and the allowed range [SI]; infinite for no limit, NaN for an unknown value.
    margin
        Margin relative to the limit or the range; negative if the limit is broken, NaN if unknown.
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
        The study.
    club, nominal
        The changed fields, and the same fields of the club that is best for the mean delivery [SI].
    starts, alike, steps
        Number of solver starts, how many end as good as the best, and solver steps on all shots.
    shots, missed
        Number of shots computed, and of shots that missed the face.
    judged
        The objective, and limited objectives, on the shots used in the optimisation [SI].
    fresh
        Start, nominal optimum and optimum evaluated on fresh shots.
    rivals
        Fields of the best clubs for other objectives within the same limits, by objective [SI].
    front
        The Pareto front between two objectives; empty for one.
    message
        The solver's final message.
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
        """The optimum as a club; the lie is left out, since club files have none."""
        start, title = self.study.club, self.study.title
        own = {name: value for name, value in self.club.items() if name != "lie"}
        with without_warnings(RuleWarning):
            made = start.replace(**own, name=f"{start.name}-optimum", description=f"{title}: the optimum")
            return made.replace(sources={**made.sources, **dict.fromkeys(own, f"optimised from {start.name}: {title}")})

    @cached_property
    def compared(self) -> dict[str, str]:
        """Names in :attr:`fresh` of the clubs in the advice, by their descriptions; the start comes first."""
        study = self.study
        clubs = {f"present {study.club.name}": "start", self._describe("optimum"): "optimum"}
        for name in self.rivals:
            known = [self.fresh.value(club, name) for club in clubs.values()]
            if not advising.adds_nothing(study.objective(name), study.worth[name], self.fresh.value(name, name), known):
                clubs[self._describe(name)] = name
        if self.nominal and not study.limits_shots:
            clubs.setdefault(self._describe("nominal"), "nominal")
        return clubs

    @cached_property
    def advice(self) -> Advice:
        """Advice on the starting club, the optimum, and the best clubs for other objectives."""
        study = self.study
        rows = [self.fresh.clubs.index(name) for name in self.compared.values()]
        columns = [self.fresh.objectives.index(each.name) for each in study.advised]
        return study.advice(
            tuple(self.compared), self.fresh.values[np.ix_(rows, columns)],
            self.fresh.sets[:, rows][:, :, columns].swapaxes(0, 1), self.fresh.shots, choices=(1,),
        )  # fmt: skip

    def fields(self, club: str) -> Mapping[str, float]:
        """Return the fields [SI] of a club named in :attr:`fresh`."""
        own = {name: own_value(self.study.club, name) for name in self.club}
        return {"start": own, "nominal": self.nominal, "optimum": self.club, **self.rivals}[club]

    def _describe(self, club: str) -> str:
        fields = self.fields(club)
        if len(fields) <= MOST_NAMED_FIELDS:
            return ", ".join(f"{name} {units.show(value, UNITS[name], 3)}" for name, value in fields.items())
        purpose = {"optimum": self.study.objectives[0], "nominal": "the mean delivery"}.get(club, club)
        return f"the best club for {purpose.replace('_', ' ')}"

    def to_result(self) -> Result:
        """Return the optimum as a result."""
        advice = self.advice
        tables = [_club_table(self), *advising.advice_tables(advice), _fresh_table(self), _limits_table(self)]
        if masses := self.placed():
            tables.append(placement_table(masses))
        if self.front:
            tables.append(_front_table(self))
        counts = {
            "starts": self.starts, "starts_alike": self.alike, "steps": self.steps, "shots": self.shots,
            "missed": self.missed, "fresh_shots": self.fresh.shots,
        }  # fmt: skip
        provenance = study_provenance(self.study, [self.study.club, self.built])
        return Result(
            kind="optimum", title=self.study.title, tables=tuple(tables),
            values=tuple(text(name, [value], printed=False) for name, value in counts.items()),
            lead=tuple(advising.advice_lead(advice)), summary=tuple(_summary(self)),
            notes=(*_notes(self), *advising.advice_notes(advice)),
            provenance=provenance + Provenance(descriptions={"the-best-club.toml": self.built.to_toml()}),
            draw=lambda: [optimum_picture(self)],
        )  # fmt: skip

    def placed(self) -> list[PointMass]:
        """Return one way to place the discretionary mass as point masses; empty if no mass moves."""
        envelope = self.study.variables.envelope
        if envelope is None:
            return []
        return placement(envelope, feasibility.pseudo_inertia(feasibility.of_club(self.built)))

    def verdicts(self) -> list[Verdict]:
        """Return the verdict on every limit: rules, feasibility of the head, bounds, and limits on the shots."""
        study = self.study
        with without_warnings(RuleWarning):
            result = [_rule_verdict(each, study.tolerance) for each in study.rule_values(self.built)]
        envelope = study.variables.envelope
        if envelope is not None:
            pseudo = feasibility.pseudo_inertia(feasibility.of_club(self.built))
            margins = envelope.margins(pseudo)
            if "mass" not in study.bounds:
                margins.pop()  # with a fixed mass the budget is no limit
            result += _margin_verdicts(margins)
        for name, (low, high) in (*study.bounds.items(), *study.limits.items()):
            if name in FREE:
                result.append(_range_verdict(name, self.club[name], low, high, field_quantity(name)))
            else:
                judge = study.objective(name)
                result.append(_range_verdict(judge.meaning, self.judged[name], low, high, judge.quantity))
        return result


def _rule_verdict(each: RuleVerdict, tolerance: bool) -> Verdict:
    limit = each.rule.limit if tolerance else each.rule.most
    quantity = shown_quantity(each.rule.name, each.rule.unit)
    return Verdict(f"rules: {each.rule.title}", quantity, each.value, -math.inf, limit, (limit - each.value) / limit)


def _margin_verdicts(margins: list[feasibility.Margin]) -> list[Verdict]:
    """Return one verdict for each feasibility condition, by its smallest margin."""
    least: dict[str, float] = {}
    for each in margins:
        least[each.name] = min(least.get(each.name, math.inf), each.value)
    margin = Quantity("margin", "1", Reading("1", 4), Reading("1", 4))
    return [Verdict(name, margin, value, 0.0, math.inf, value) for name, value in least.items()]


def _range_verdict(name: str, value: float, low: float, high: float, quantity: Quantity) -> Verdict:
    sides = [abs(each) for each in (low, high) if math.isfinite(each)]
    size = high - low if len(sides) == 2 else max([*sides, 1e-12])
    margin = min(value - low, high - value) / size
    return Verdict(name, quantity, value, low, high, float(np.round(margin, 12)))


def study_provenance(study: AdvisedStudy, clubs: Sequence[Club], balls: Sequence[Ball | None] = (None,)) -> Provenance:
    """Return the golfers, shots, equipment and conditions of a study."""
    golfers = ", ".join(
        (golfer.title or golfer.name) + (f" (weight {weight:g})" if len(study.golfers) > 1 else "")
        for golfer, weight in study.golfers
    )
    inputs = {"golfers": golfers, "shots": str(study.shots), "seed": str(study.seed)}
    if study.hole is not None:
        inputs["hole"] = study.hole.describe()
    setting = study.setting
    launches = [
        impact(
            club, golfer.for_hand(club.hand).delivery(), model=setting.model, parameters=setting.parameters,
            ball=setting.ball if ball is None else ball,
        )
        for club in clubs for ball in balls for golfer, _ in study.golfers
    ]  # fmt: skip
    sources = [each for golfer, _ in study.golfers for each in golfer_sources(golfer)]
    return provenance_of(
        launches, inputs | flight_conditions(air=setting.air, wind=setting.wind, ground=setting.ground), sources
    )


def _club_table(optimum: Optimum) -> Table:
    """Return the changed fields of the start, the nominal optimum and the optimum, and their bounds."""
    kinds = [field_quantity(name) for name in optimum.club]
    bounds = [optimum.study.bounds.get(name, (None, None)) for name in optimum.club]
    labels = {"nominal": "best for the mean delivery"}
    labels |= {name: f"best for {name.replace('_', ' ')}" for name in optimum.rivals}
    columns = (
        text("field", list(optimum.club)),
        *(Column(club if club in ("start", "nominal", "optimum") else f"best_for_{club}",
                 [optimum.fields(club).get(name) for name in optimum.club], kinds, labels.get(club, ""), digits=-4)
          for club in optimum.fresh.clubs),
        Column("least", [low for low, _ in bounds], kinds, "lower bound", digits=-4),
        Column("most", [high for _, high in bounds], kinds, "upper bound", digits=-4),
    )  # fmt: skip
    return Table("club", columns)


def _fresh_table(optimum: Optimum) -> Table:
    """Return the clubs' objectives on fresh shots, and the optimum's gain on each."""
    judges = optimum.study.known()
    kinds = [each.quantity for each in judges]
    values = {club: [optimum.fresh.value(club, each.name) for each in judges] for club in CLUBS}
    labels = {"start": "start", "nominal": "best for the mean delivery", "optimum": "optimum"}
    columns = [
        *row_names("objective", [each.name for each in judges], [each.label for each in kinds]),
        *(Column(club, each, kinds, labels[club]) for club, each in values.items()),
    ]
    for club in CLUBS[:2]:
        gains = [best - other for best, other in zip(values["optimum"], values[club], strict=True)]
        errors = [optimum.fresh.error(club, each.name) for each in judges]
        columns += [
            Column(f"gain_on_{club}", gains, kinds, f"change from {labels[club]}", difference=True),
            Column(f"error_of_gain_on_{club}", errors, kinds, "±"),
        ]
    solved = [optimum.judged.get(each.name) for each in judges]
    return Table(
        "fresh",
        (*columns, Column("on_solved_shots", solved, kinds, printed=False)),
        "Objectives on fresh shots",
        printed=False,
    )


def _limits_table(optimum: Optimum) -> Table:
    verdicts = optimum.verdicts()
    kinds = [each.quantity for each in verdicts]
    ends = [[end if math.isfinite(end) else None for end in (each.least, each.most)] for each in verdicts]
    columns = (
        text("limit", [each.limit.removeprefix("the ") for each in verdicts]),
        Column("optimum", [each.value for each in verdicts], kinds, digits=-5),
        Column("least", [low for low, _ in ends], kinds, digits=-4),
        Column("most", [high for _, high in ends], kinds, digits=-4),
        text("margin", [each.margin for each in verdicts], printed=False),
        text("verdict", [each.state for each in verdicts]),
    )
    return Table("limits", columns, "Limits")


def placement_table(masses: Sequence[Any]) -> Table:
    """Return the table of point masses for the discretionary mass; masses at one place are merged."""
    grouped: list[tuple[tuple[float, ...], list[float]]] = []
    for each in masses:  # the heaviest first
        near = [group for place, group in grouped if math.dist(place, each.place) < MERGE_DISTANCE]
        if near:
            near[0].append(each.mass)
        else:
            grouped.append((each.place, [each.mass]))
    grouped.sort(key=lambda group: -sum(group[1]))
    sums = [sum(group) for _, group in grouped]
    columns = (
        column("mass", sums, digits=1),
        *(
            column(f"{name}", [place[row] for place, _ in grouped], "m", label=label, unit="mm", digits=1)
            for row, (name, label) in enumerate((("x", "x, to the target"), ("y", "y, up"), ("z", "z, to the toe")))
        ),
    )
    return Table(
        "placement", columns, "One placement of the discretionary mass, relative to the face centre",
        shown_rows=[place for place, each in enumerate(sums) if each >= LEAST_PRINTED_MASS],
    )  # fmt: skip


def _front_table(optimum: Optimum) -> Table:
    judges = [optimum.study.objective(name) for name in optimum.study.objectives]
    columns = [Column(each.name, [one.values[each.name] for one in optimum.front], each.quantity) for each in judges]
    columns += [Column(name, [point.club[name] for point in optimum.front], field_quantity(name), digits=-4)
                for name in optimum.club]  # fmt: skip
    return Table("front", tuple(columns), "Pareto front")


def _summary(optimum: Optimum) -> Iterator[Note]:
    yield note("optimum-on-fresh-shots")
    for judge in optimum.study.known():
        before, after = (judge.show(optimum.fresh.value(club, judge.name)) for club in ("start", "optimum"))
        yield note("optimum-change", meaning=judge.meaning, before=before, after=after)
    moved = {
        name: optimum.club[name] - own_value(optimum.study.club, name)
        for name in ("cg_x", "cg_y", "cg_z")
        if name in optimum.club
    }  # fmt: skip
    words = change_words(moved)
    if "cg_x" in words:
        words["cg_x"] = words["cg_x"].replace("mm ", "mm farther ")
    if words:
        yield note("optimum-cg-moved", moved=list(words.values()))
    for name, meaning in (("iyy", "moment of inertia about the vertical axis"), ("bulge", "bulge"), ("roll", "roll")):
        if name in optimum.club:
            ends = own_value(optimum.study.club, name), optimum.club[name]
            before, after = (units.show(each, UNITS[name], 4) for each in ends)
            if before != after:
                yield note("optimum-change", meaning=meaning, before=before, after=after)
    if angles := [name for name in ("loft", "lie") if name in optimum.club and name in optimum.study.bounds]:
        words = [f"a {name} of {units.fixed(optimum.club[name], 'deg', 1)}" for name in angles]
        yield note("optimum-angles", angles=words)


def _notes(optimum: Optimum) -> Iterator[Note]:
    study = optimum.study
    meaning = study.objective(study.purpose).meaning
    yield note("optimum-starts", alike=optimum.alike, starts=optimum.starts, meaning=meaning)
    yield note("optimum-shots", shots=optimum.shots, fresh=optimum.fresh.shots)
    if optimum.missed:
        yield note("optimum-missed", missed=optimum.missed)
    yield _against_nominal(optimum)
    if stopping := [each.limit for each in optimum.verdicts() if each.state == "kept, at the limit"]:
        yield note("optimum-stopped-by", limits=stopping)
    beyond = [each for each in study.rule_values(optimum.built) if each.conforms and each.value > each.rule.most]
    if study.conform and beyond:
        rules = [
            f"{each.rule.title} {units.show(each.value, each.rule.unit, 4)}, limit "
            f"{units.show(each.rule.most, each.rule.unit, 4)}"
            for each in beyond
        ]
        yield note("optimum-tolerances", rules=rules)
    envelope = study.variables.envelope
    if envelope is not None and envelope.volume is not envelope.whole:
        room = envelope.volume
        size, centre = ([f"{1e3 * each:.0f}" for each in values] for values in (room.size, room.centre))
        yield note("optimum-ellipsoid", club=study.club.name, size=size, centre=centre)
    if study.moves_mass and not optimum.placed():
        yield note("optimum-not-placed")
    if "lie" in optimum.club:
        yield note("optimum-lie")
    if "mass" in study.bounds:
        yield note("optimum-speed", exponent=study.setting.speed_exponent)
    if "loft" in optimum.club:
        yield note("optimum-loft")


def _against_nominal(optimum: Optimum) -> Note:
    """Return how the optimum compares with the best club for the mean delivery alone."""
    name = optimum.study.objectives[0]
    if optimum.study.limits_shots:
        return note("optimum-limits-of-shots")
    robust, nominal = (optimum.fresh.value(club, name) for club in ("optimum", "nominal"))
    gain, error = optimum.study.objective(name).sign * (nominal - robust), optimum.fresh.error("nominal", name)
    if abs(gain) <= CERTAIN * error:
        return note("optimum-nominal-like")
    return note("optimum-nominal-worse" if gain > 0.0 else "optimum-nominal-better")


def optimum_picture(optimum: Optimum) -> Picture:
    """Return the landings with start and optimum, and the Pareto front or the fields within their bounds."""
    golfers = optimum.study.landings(optimum.study.shots, seed=optimum.study.seed + 1)
    clubs: dict[str, Any] = {"start": {}, "optimum": optimum.club}
    landed = {name: np.concatenate([each.of(club) for each, _ in golfers], axis=1) for name, club in clubs.items()}
    panels: list[Panel | None] = [landings_panel(landed)]
    if optimum.front:
        panels.append(_front_panel(optimum))
    elif any(name in optimum.study.bounds for name in optimum.club):
        panels.append(_bounds_panel(optimum))
    return Picture(
        "optimum", "Landings with the starting club and with the optimum, and the changes", [panels],
        widths=[1.0, 1.2][: len(panels)], height=3.4,
    )  # fmt: skip


def landings_panel(landed: Mapping[str, Floats]) -> Panel:
    """Return the panel of landings [m] by club, of shape (landings, shots), and ellipses with ``SHARE`` of them."""
    marks, ellipses = [], []
    for style, (name, values) in enumerate(landed.items()):
        side, down = values[1], np.sqrt(np.maximum(values[0] ** 2 - values[1] ** 2, 0.0))
        marks.append(Mark("points", side[:DRAWN_POINTS], down[:DRAWN_POINTS], style=style, symbol="", size=2.5))
        ellipses.append(ellipse_about(np.array([side, down]), math.sqrt(-2.0 * math.log1p(-SHARE))))
        marks.append(Mark("line", *ellipses[-1], style=style, label=name))
    # The ellipses set the axis limits: a topped ball far behind would stretch the axes.
    drawn = np.hstack(ellipses)
    middle, half = 0.5 * (drawn.min(axis=1) + drawn.max(axis=1)), 0.55 * np.ptp(drawn, axis=1).max()
    (left, low), (right, high) = middle - half, middle + half
    return Panel(
        marks, axis("side", "side, right is positive", limits=(float(left), float(right))),
        axis("carry", "distance down the line", limits=(float(low), float(high))),
        f"Landings, with {SHARE:.0%} ellipses", equal=True, legend=True,
    )  # fmt: skip


def _front_panel(optimum: Optimum) -> Panel:
    one, other = (optimum.study.objective(name) for name in optimum.study.objectives)
    x, y = ([point.values[each.name] for point in optimum.front] for each in (one, other))
    # The start is evaluated on fresh shots, the front on the shots it was solved on.
    start = [[optimum.fresh.value("start", each.name)] for each in (one, other)]
    marks = [
        Mark("line", x, y, style=1, dash=0), Mark("points", x, y, style=1, label="front"),
        Mark("points", x=start[0], y=start[1], symbol="s", label="start, on fresh shots"),
    ]  # fmt: skip
    x_axis, y_axis = (Axis(each.quantity, each.meaning) for each in (one, other))
    return Panel(marks, x_axis, y_axis, "Pareto front", legend=True)


def _bounds_panel(optimum: Optimum) -> Panel:
    bounds = optimum.study.bounds
    names = [name for name in optimum.club if name in bounds]
    marks = [Mark("line", [0.0, 1.0], [row, row], style=-1, size=3.0) for row in range(len(names))]
    for style, (label, symbol, away) in enumerate((("start", "s", 0.3), ("optimum", "o", -0.3))):
        values = [own_value(optimum.study.club, name) if label == "start" else optimum.club[name] for name in names]
        shares = [(value - bounds[name][0]) / (bounds[name][1] - bounds[name][0])
                  for name, value in zip(names, values, strict=True)]  # fmt: skip
        texts = [f"{units.from_si(value, UNITS[name]):.4g}" for name, value in zip(names, values, strict=True)]
        rows = np.arange(len(names))
        marks += [
            Mark("points", shares, rows, style=style, symbol=symbol, label=label),
            Mark("text", shares, rows + away, texts=texts, style=style),
        ]
    labels = [f"{name}\n{units.show_range(*bounds[name], UNITS[name])}" for name in names]
    y = axis(names=labels, reversed=True, limits=(len(names) - 0.4, -0.6))
    title = "Position within the bounds"
    return Panel(marks, axis(ticks=False), y, title, legend=True, grid=False)
