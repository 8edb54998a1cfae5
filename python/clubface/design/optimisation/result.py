"""What an optimisation found: the club, its verdicts, tables and sentences.

What an optimisation found: the club, what it is judged by on fresh shots, and the verdict of every limit.

Numbers of optima and fittings as tables and sentences have them.

An optimum in tables and sentences.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.design import feasibility
from clubface.design.optimisation.fitting import in_words as combination_in_words
from clubface.design.optimisation.landings import FREE, Objective, own_value
from clubface.design.optimisation.limits import in_words
from clubface.design.optimisation.study import DIMENSIONS, UNITS, DesignStudy
from clubface.design.optimisation.variables import PointMass, placement
from clubface.equipment.clubs import Club
from clubface.errors import RuleWarning
from clubface.support.checks import without_warnings

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
        "start", "nominal" and "optimum".
    objectives
        Names of what they are judged by.
    values
        Shape (clubs, objectives) [SI].
    errors
        Standard errors of the differences from the optimum, of the same shape.
    """

    shots: int
    clubs: tuple[str, ...]
    objectives: tuple[str, ...]
    values: NDArray[Any]
    errors: NDArray[Any]

    def value(self, club: str, objective: str) -> float:
        """Return what a club is judged by."""
        return float(self.values[self.clubs.index(club), self.objectives.index(objective)])

    def error(self, club: str, objective: str) -> float:
        """Return the standard error of its difference from the optimum."""
        return float(self.errors[self.clubs.index(club), self.objectives.index(objective)])


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
    value, allowed
        In words with units.
    margin
        What is left, as a part of the limit; below 0 it is broken; NaN where it is not known.
    """

    limit: str
    value: str
    allowed: str
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
class Optimum:
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
            found = [_of_rule(each, study.tolerance) for each in study.rule_values(self.built)]
        envelope = study.variables.envelope
        if envelope is not None:
            pseudo = feasibility.pseudo_inertia(feasibility.of_club(self.built))
            margins = envelope.margins(pseudo)
            if "mass" not in study.bounds:
                margins.pop()  # the budget limits nothing where the mass is given
            found += _of_margins(margins)
        for name, (low, high) in (*study.bounds.items(), *study.limits.items()):
            if name in FREE:
                found.append(_of_range(name, self.club[name], low, high, UNITS[name]))
            else:
                judge = study.objective(name)
                found.append(_of_range(judge.meaning, self.judged[name], low, high, judge.unit))
        return found


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
    allowed = f"at most {units.show(limit, each.rule.unit, 4)}"
    value = "not known" if math.isnan(each.value) else units.show(each.value, each.rule.unit, 4)
    return Verdict(f"rules: {each.rule.title}", value, allowed, (limit - each.value) / limit)


def _of_margins(margins: list[feasibility.Margin]) -> list[Verdict]:
    """Return one verdict for each thing that must hold of a body, by its smallest margin."""
    least: dict[str, float] = {}
    for each in margins:
        least[each.name] = min(least.get(each.name, math.inf), each.value)
    return [Verdict(name, f"{value:.4f}", "at least 0", value) for name, value in least.items()]


def _of_range(name: str, value: float, low: float, high: float, unit: str) -> Verdict:
    sides = [abs(each) for each in (low, high) if math.isfinite(each)]
    size = high - low if len(sides) == 2 else max([*sides, 1e-12])
    margin = min(value - low, high - value) / size
    return Verdict(name, *in_words(value, low, high, unit), float(np.round(margin, 12)))


HEADS = {"side_spread": "side ±", "ellipse": "90% ellipse"}
"""What stands over columns of objectives whose names are no words."""
CERTAIN = 2.0
"""Standard errors beyond which a difference is called one."""


def number(value: float | None, unit: str) -> str:
    """Return a number of a unit, nothing for None."""
    return "" if value is None else f"{units.from_si(value, unit):.4g}"


def at_an_end(value: float | None, limits: tuple[float, float]) -> bool:
    """Return whether a value is at an end of its limits."""
    low, high = limits
    return value is not None and min(value - low, high - value) < 1e-3 * (high - low)


def short(allowed: str) -> str:
    """Return what a limit allows, such that the table fits a terminal: "≤ 20 yd", "8 to 14 deg"."""
    text = allowed.replace("at most", "≤").replace("at least", "≥")
    return re.sub(r"(\S+) (\S+) to (\S+ \2)$", r"\1 to \3", text)


def heading(judge: Objective) -> str:
    """Return what stands over a column of an objective."""
    name = HEADS.get(judge.name, judge.name)
    return name if judge.unit == "1" else f"{name}\n({judge.unit})"


def written(value: float, judge: Objective) -> str:
    """Return what an objective says, in its unit."""
    digits = 4 if judge.unit == "1" else 0 if judge.unit == "m2" else 2
    return f"{units.from_si(value, judge.unit):.{digits}f}"


def written_error(value: float, judge: Objective) -> str:
    """Return the error of that; ? where it is not known."""
    return "?" if math.isnan(value) else written(value, judge)


def signed(value: float, judge: Objective) -> str:
    """Return a difference with its sign."""
    text = written(value, judge)
    return text if text.startswith("-") else f"+{text}"


ONE_PLACE = 2e-4
"""Distance [m] within which point masses are shown as one."""


def design_table(found: Optimum) -> tuple[list[str], list[list[str]]]:
    """Return every field that changed: at the start, for the mean delivery, at the optimum, and its bounds."""
    study = found.study
    rows = []
    for name, value in found.club.items():
        unit = UNITS[name]
        start = own_value(study.club, name)
        nominal = found.nominal.get(name)
        low_high = study.bounds.get(name)
        allowed = "follows" if low_high is None else units.show_range(*low_high, unit)
        rows.append([f"{name} ({unit})", *(number(each, unit) for each in (start, nominal, value)), allowed])
    return ["", "start", "best for the\nmean delivery", "optimum", "allowed"], rows


def shots_table(found: Optimum) -> tuple[list[str], list[list[str]]]:
    """Return what the clubs are judged by on fresh shots, and what the optimum gains on either."""
    rows = []
    for judge in found.study.known():
        values = [found.fresh.value(club, judge.name) for club in found.fresh.clubs]
        cells = [written(each, judge) for each in values]
        gains = [
            f"{signed(values[2] - values[place], judge)} ± {written(found.fresh.error(club, judge.name), judge)}"
            for place, club in enumerate(found.fresh.clubs[:2])
        ]
        unit = "" if judge.unit == "1" else f" ({judge.unit})"
        rows.append([f"{judge.name}{unit}", *cells, *gains])
    heads = [
        "",
        "start",
        "best for the\nmean delivery",
        "optimum",
        "optimum\nagainst start",
        "optimum against\nmean delivery",
    ]
    return heads, rows


def limits_table(found: Optimum) -> tuple[list[str], list[list[str]]]:
    """Return the verdict of every limit."""
    rows = [
        [each.limit.removeprefix("the "), each.value, short(each.allowed), each.state.removeprefix("kept, ")]
        for each in found.verdicts()
    ]
    return ["limit", "optimum", "allowed", "verdict"], rows


def placement_table(found: Optimum) -> tuple[list[str], list[list[str]]]:
    """Return point masses that are one way to place the discretionary mass."""
    grouped: list[tuple[tuple[float, ...], list[float]]] = []
    for each in found.placed():  # the heaviest first; what lies beside one that is there is part of it
        near = [masses for place, masses in grouped if math.dist(place, each.place) < ONE_PLACE]
        if near:
            near[0].append(each.mass)
        else:
            grouped.append((each.place, [each.mass]))
    grouped.sort(key=lambda group: -sum(group[1]))
    rows = [
        [str(number), _tenths(units.from_si(sum(masses), "g")), *(_tenths(units.from_si(x, "mm")) for x in place)]
        for number, (place, masses) in enumerate(grouped, 1)
        if _tenths(units.from_si(sum(masses), "g")) != "0.0"
    ]
    return ["mass", "g", "x (mm)\nto the target", "y (mm)\nup", "z (mm)\nto the toe"], rows


def _tenths(value: float) -> str:
    text = f"{value:.1f}"
    return "0.0" if text == "-0.0" else text


def front_table(found: Optimum) -> tuple[list[str], list[list[str]]]:
    """Return the clubs between two objectives."""
    judges = [found.study.objective(name) for name in found.study.objectives]
    fields = list(found.club)
    heads = [*(f"{each.name}\n({each.unit})" for each in judges), *(f"{name}\n({UNITS[name]})" for name in fields)]
    rows = [
        [
            *(written(point.values[each.name], each) for each in judges),
            *(number(point.club[f], UNITS[f]) for f in fields),
        ]
        for point in found.front
    ]
    return heads, rows


def notes(found: Optimum) -> list[str]:
    """Return what a reader should know about an optimum."""
    study, name = found.study, found.study.objectives[0]
    judge = study.objective(name)
    said = [
        f"{found.alike} of {found.starts} starts found this optimum of the {judge.meaning} (to 1 part in 10,000).",
        f"Solved on {found.shots} shots; the table is of {found.fresh.shots} fresh ones, which no solver has seen."
        " After ± stands the standard error of a difference.",
    ]
    if found.missed:
        said.append(f"{found.missed} shots miss the face of the club and are left out.")
    said.append(_against_nominal(found))
    stopping = [each.limit for each in found.verdicts() if each.state == "kept, at the limit"]
    if stopping:
        said.append(f"What stops the optimum: {', '.join(stopping)}.")
    beyond = [each for each in study.rule_values(found.built) if each.conforms and each.value > each.rule.most]
    if study.conform and beyond:
        which = ", ".join(
            f"{each.rule.title} {units.show(each.value, each.rule.unit, 4)}, limit"
            f" {units.show(each.rule.most, each.rule.unit, 4)}" for each in beyond
        )  # fmt: skip
        said.append(
            f"It makes use of tolerances of the rules, which are there for what a measurement may be off: {which}."
            " tolerance = false under [rules] keeps to the limits."
        )
    envelope = study.variables.envelope
    if envelope is not None and envelope.volume is not envelope.whole:
        size, centre = (
            ", ".join(units.fixed(each, "mm", 0).removesuffix(" mm") for each in values)
            for values in (envelope.volume.size, envelope.volume.centre)
        )
        said.append(
            f"Mass is placed inside the mesh of {study.club.name}: in the largest ellipsoid there, {size} mm from face"
            f" to back, sole to crown and heel to toe, about ({centre}) mm from the face centre."
        )
    if study.moves_mass and not found.placed():
        said.append(
            "No point masses in the volume were found that have the moments of the discretionary mass: a box refuses no"
            " head that can be built, but not every other one. Try a smaller box, an ellipsoid, or a limit of the CG."
        )
    if "lie" in found.club:
        said.append("The lie is that at impact; a club file has none, so set it when the club is fitted.")
    if "mass" in found.study.bounds:
        said.append(
            f"Clubhead speed is taken to fall as mass to the power {study.setting.speed_exponent:g}"
            " (MacKenzie, Ryan and Rice, 2015)."
        )
    if "loft" in found.club:
        said.append("One degree more static loft is taken to be one degree more at impact.")
    return said


def gains(found: Optimum) -> list[str]:
    """Return what the optimum is worth beside the start, in sentences for a reader who knows no solver."""
    said = ["This is what the best club does on shots that no solver has seen."]
    for judge in found.study.known():
        before, after = (found.fresh.value(club, judge.name) for club in ("start", "optimum"))
        unit = "" if judge.unit == "1" else f" {judge.unit}"
        said.append(f"The {judge.meaning} is {written(after, judge)}{unit} instead of "
                    f"{written(before, judge)}{unit}.")  # fmt: skip
    if moved := _moved(found):
        said.append(f"Beside the club at the start, its CG lies {moved}.")
    for name, words in (("iyy", "moment of inertia about the vertical axis"), ("bulge", "bulge"), ("roll", "roll")):
        if name in found.club:
            before, after = (units.show(each, UNITS[name], 4) for each in (own_value(found.study.club, name),
                                                                            found.club[name]))  # fmt: skip
            if before != after:
                said.append(f"The {words} is {after} instead of {before}.")
    if lie_or_loft := [name for name in ("loft", "lie") if name in found.club and name in found.study.bounds]:
        angles = [f"a {name} of {units.fixed(found.club[name], 'deg', 1)}" for name in lie_or_loft]
        said.append(f"The club has {' and '.join(angles)}.")
    return said


def _moved(found: Optimum) -> str:
    """Say where the CG went: "9.8 mm farther back and 2.4 mm higher"; nothing where it stayed."""
    moved = [name for name in ("cg_x", "cg_y", "cg_z") if name in found.club]
    parts = combination_in_words({name: found.club[name] - own_value(found.study.club, name) for name in moved})
    if "cg_x" in parts:
        parts["cg_x"] = parts["cg_x"].replace("mm ", "mm farther ")
    *others, last = parts.values() or ("",)
    return f"{', '.join(others)} and {last}" if others else last


def _against_nominal(found: Optimum) -> str:
    """Say whether the optimum is better than the club that is best for the mean delivery alone."""
    name = found.study.objectives[0]
    robust, nominal = (found.fresh.value(club, name) for club in ("optimum", "nominal"))
    gain, error = found.study.objective(name).sign * (nominal - robust), found.fresh.error("nominal", name)
    if any(each not in FREE for each in found.study.limits):
        return (
            "The club that is best for the mean delivery does not know the limits of the shots; the optimum keeps them"
            " on the shots it was solved on."
        )
    if gain > CERTAIN * error:
        return "On fresh shots the optimum is better than the club that is best for the mean delivery."
    if gain < -CERTAIN * error:
        return "On fresh shots the club that is best for the mean delivery is better; the shots are too few."
    return "On fresh shots the optimum and the club that is best for the mean delivery do not differ clearly."


def document(found: Optimum) -> dict[str, Any]:
    """Return an optimum as JSON has it, in SI units."""
    fresh = found.fresh
    return {
        "title": found.study.title,
        "objectives": list(found.study.objectives),
        "start": {name: own_value(found.study.club, name) for name in found.club},
        "nominal": dict(found.nominal),
        "optimum": dict(found.club),
        "starts": found.starts,
        "starts_alike": found.alike,
        "shots": found.shots,
        "missed": found.missed,
        "judged": dict(found.judged),
        "fresh": {
            "shots": fresh.shots,
            "values": _by_club(fresh.clubs, fresh.objectives, fresh.values),
            "error_of_difference_from_optimum": _by_club(fresh.clubs, fresh.objectives, fresh.errors),
        },
        "limits": [{**asdict(each), "verdict": each.state} for each in found.verdicts()],
        "placement": [each._asdict() for each in found.placed()],
        "front": [{"club": dict(each.club), "values": dict(each.values)} for each in found.front],
        "notes": notes(found),
    }


def _by_club(clubs: tuple[str, ...], names: tuple[str, ...], table: Any) -> dict[str, dict[str, float]]:
    return {
        club: dict(zip(names, map(float, row), strict=True)) for club, row in zip(clubs, table, strict=True)
    }  # fmt: skip
