"""What a study of a head of shells found: tables, notes and a document."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from clubface.design.shells.run import number
from clubface.design.shells.study import QUANTITIES

if TYPE_CHECKING:
    from clubface.design.shells.management import Step
    from clubface.design.shells.run import Improved, Search


SHORT = {"us": "µs"}
"""Units that are printed in another way than they are read."""

Table = tuple[tuple[str, ...], list[list[str]]]


def design_table(found: Improved) -> Table:
    """Return variables and quantities of the head to start from and of the best one."""
    study, search = found.study, found.chosen
    rows = [
        [
            f"{_variable(name)}, {_unit_of(name)}",
            *(number(values[name], _unit_of(name)) for values in _variables(found)),
        ]
        for name in study.bounds
    ]
    for name, (words, _, unit) in QUANTITIES.items():
        if name in search.best.values:
            told = (number(step.values[name], unit) for step in (search.start, search.best))
            rows.append([f"{words}, {SHORT.get(unit, unit)}", *told])
    return ("", "start", "best"), rows


def limits_table(search: Search) -> Table:
    """Return every limit with what start and best have of it, and the verdict."""
    rows = []
    for name, (least, most) in search.goal.limits.items():
        words, _, unit = QUANTITIES[name]
        values = [step.values[name] for step in (search.start, search.best)]
        low = "" if least == 0.0 else number(least, unit)
        high = "" if most == math.inf else number(most, unit)
        rows.append(
            [f"{words}, {SHORT.get(unit, unit)}", low, high, *(number(value, unit) for value in values),
             verdict(values[1], least, most)]
        )  # fmt: skip
    return ("", "least", "most", "start", "best", ""), rows


def verdict(value: float, least: float, most: float) -> str:
    """Return "broken", "kept" or, within half a percent of the limit, "binds"."""
    if not least <= value <= most:
        return "broken"
    return "binds" if value >= 0.995 * most or value <= 1.005 * least else "kept"


def metals_table(found: Improved) -> Table:
    """Return the best head of every metal."""
    study = found.study
    _, _, unit = QUANTITIES[study.objective]
    rows = []
    for each in found.searches:
        yield_ = each.metal.metal.yield_stress
        rows.append([
            each.metal.name, "" if yield_ is None else number(yield_, "MPa"),
            number(each.best.values[study.objective], unit), "yes" if each.within else "no",
            str(len(each.found.steps)), each.metal.source,
        ])  # fmt: skip
    heads = ("metal", "yield\nMPa", f"{study.objective.replace('_', ' ')}\n{SHORT.get(unit, unit)}", "within\nlimits",
             "designs", "source")  # fmt: skip
    return heads, rows


def steps_table(search: Search, objective: str) -> Table:
    """Return every design that the engine judged: what was promised, what was found, and what became of it."""
    _, _, unit = QUANTITIES[objective]
    rows = []
    for place, step in enumerate(search.found.steps, 1):
        violation = search.goal.violation(step.values)
        rows.append([
            str(place), step.kind, "" if step.promised is None else number(step.promised[objective], unit),
            "failed" if violation == math.inf else number(step.values[objective], unit),
            "" if violation == 0.0 else "" if violation == math.inf else f"{100.0 * violation:.2f}",
            "accepted" if step.accepted else "refused" if step.kind == "proposal" else "",
        ])  # fmt: skip
    shown = SHORT.get(unit, unit)
    return ("", "", f"promised\n{shown}", f"found\n{shown}", "beyond\nlimits, %", ""), rows


def gains(found: Improved) -> list[str]:
    """Return what the best head is worth beside the one to start from, in sentences."""
    search = found.chosen
    told = []
    for name in dict.fromkeys((found.study.objective, "characteristic_time", "stress", "mass")):
        if name in search.best.values:
            words, _, unit = QUANTITIES[name]
            before, after = (number(step.values[name], unit) for step in (search.start, search.best))
            shown = SHORT.get(unit, unit)
            if before != after:
                told.append(f"The {words} of the best head is {after} {shown} instead of {before} {shown}.")
    return told


def notes(found: Improved) -> list[str]:
    """Return what else there is to know."""
    designs = sum(len(each.found.steps) for each in found.searches)
    told = [
        f"{designs} designs were judged by {found.runs} runs of finite elements; the search for the best head ended "
        f"because {found.chosen.found.ended}."
    ]
    if ends := [_variable(name) for name in found.study.bounds if _at_an_end(found, name)]:
        told.append(f"At an end of what may vary: {', '.join(ends)}. Wider bounds may give a better head.")
    if found.study.hardest is not None:
        told.append(
            "The stress is that of von Mises on either side of the face, of a metal that stays elastic, on the mesh of "
            "the head: a finer mesh finds more. It tells of yield under one blow and nothing of fatigue."
        )
    return told


def document(found: Improved) -> dict[str, Any]:
    """Return all that was found, in SI units."""
    start, best = _variables(found)
    return {
        "title": found.study.title,
        "objective": found.study.objective,
        "metal": found.chosen.metal.name,
        "variables": {name: {"start": start[name], "best": best[name]} for name in best},
        "start": found.chosen.start.values,
        "best": found.chosen.best.values,
        "runs": found.runs,
        "searches": [
            {
                "metal": each.metal.name,
                "within": each.within,
                "ended": each.found.ended,
                "best": each.found.best,
                "limits": {
                    name: {
                        "least": least or None,
                        "most": None if most == math.inf else most,
                        "best": each.best.values[name],
                        "verdict": verdict(each.best.values[name], least, most),
                    }
                    for name, (least, most) in each.goal.limits.items()
                },
                "designs": [_step(step) for step in each.found.steps],
            }
            for each in found.searches
        ],
    }


def _step(step: Step) -> dict[str, Any]:
    return {
        "kind": step.kind, "place": list(step.place), "radius": step.radius, "accepted": step.accepted,
        "found": step.values, "promised": step.promised,
    }  # fmt: skip


def _variables(found: Improved) -> tuple[dict[str, float], dict[str, float]]:
    """Return the variables of start and best [SI], those of the best as its file has them."""
    best = {}
    for name in found.study.bounds:
        table, key = name.split(".")
        best[name] = getattr(found.head, table)[key]
    return {name: found.study.start_value(name) for name in found.study.bounds}, best


def _at_an_end(found: Improved, name: str) -> bool:
    """Return whether the best head has the least or the greatest value of a variable."""
    low, high = found.study.bounds[name]
    value = _variables(found)[1][name]
    return min(value - low, high - value) < 1e-3 * (high - low)


def _variable(name: str) -> str:
    table, key = name.split(".")
    return f"{key.replace('_', ' ')}{' wall' if table == 'thickness' and 'face' not in key else ''}"


def _unit_of(name: str) -> str:
    return "deg" if name == "shape.loft" else "mm"
