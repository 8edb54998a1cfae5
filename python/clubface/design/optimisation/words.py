"""An optimum in tables and sentences."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

from clubface import units
from clubface.design.optimisation.combination import in_words
from clubface.design.optimisation.formatting import CERTAIN, number, short, signed, written
from clubface.design.optimisation.landings import FREE, own_value
from clubface.design.optimisation.result import Optimum
from clubface.design.optimisation.study import UNITS

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
    parts = in_words({name: found.club[name] - own_value(found.study.club, name) for name in moved})
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
