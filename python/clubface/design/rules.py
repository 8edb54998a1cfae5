"""Whether a club conforms to the rules of golf."""

from __future__ import annotations

import math
from collections.abc import Sequence

from clubface import units
from clubface.equipment.clubs import Club, club as club_of
from clubface.equipment.listings import club_result
from clubface.equipment.rules import (
    NOT_KNOWN,
    Rule as Rule,
    RuleVerdict as RuleVerdict,
    rules as rules,
    rules_of as rules_of,
)
from clubface.fem.heads.meshed import mesh_of
from clubface.quantities import Quantity, Reading
from clubface.results.notes import Note, note
from clubface.results.result import Result
from clubface.results.table import Column, table, text

__all__ = ["Rule", "RuleVerdict", "check_result", "check_rules", "rules"]

UNMEASURED = "not measured"
"""Verdict on a face whose characteristic time is not given."""
SPRING_ERROR = 0.007
"""Largest difference in restitution between simulated heads and springs with the same characteristic time; a test
checks it against the table in docs/finite-elements/heads.md."""


def check_rules(
    club: str | Club,
    *,
    volume: float | str | None = None,
    size: tuple[float | str, float | str, float | str] | None = None,
) -> list[RuleVerdict]:
    """Return the verdict on every limit that applies to a club.

    A characteristic time of 0 means the face has not been measured, since no face is rigid. ``volume`` of the head and
    its ``size`` from face to back, sole to crown and heel to toe are text with units, or SI numbers; default those of
    the mesh, if the head has one.
    """
    head = club_of(club)
    unknown = {"characteristic_time": UNMEASURED}
    if (mesh := mesh_of(head)) is not None:
        if volume is None and (volume := mesh.volume) is None:
            unknown["volume"] = "not known: the mesh is not closed"
        size = mesh.size if size is None else size
    depth, height, length = (units.parse(each, "length", name="size") for each in size) if size else (math.nan,) * 3
    values = {
        "moment_of_inertia": head.iyy,
        "characteristic_time": head.characteristic_time or math.nan,
        "volume": math.nan if volume is None else units.parse(volume, "volume", name="volume"),
        "heel_to_toe": length,
        "sole_to_crown": height,
    }
    verdicts = [RuleVerdict(rule, values[rule.name], unknown.get(rule.name, NOT_KNOWN)) for rule in rules_of(head)]
    if head.kind != "iron" and size:
        source = rules()["heel_to_toe"].source
        longer = Rule("face_to_back", "face to back, no longer than heel to toe", length, 0.0, "in", source)
        verdicts.append(RuleVerdict(longer, depth))
    return verdicts


def check_result(checked: Club, file: str) -> Result:
    """Return a club's values with their sources, and the verdict on every limit of the rules, as a result."""
    known = [each for each in check_rules(checked) if each.words != NOT_KNOWN]  # a club file needs no volume
    notes = []
    if any(each.words == UNMEASURED for each in known):
        notes.append(note("unmeasured-face" if mesh_of(checked) is None else "unmeasured-mesh", file=file))
    if checked.cor is not None:
        notes.append(note("time-of-cor", restitution=checked.cor, error_restitution=SPRING_ERROR))
    if mesh_of(checked) is not None and len(known) > 1:
        notes.append(note("mesh-dimensions"))
    kinds = [_quantity_of(each.rule) for each in known]
    verdicts = table(
        "rules",
        text("rule", [each.rule.title for each in known]),
        Column("value", [None if each.conforms is None else each.value for each in known], kinds, "club", digits=-4),
        Column("limit", [each.rule.most for each in known], kinds, digits=-4),
        Column("tolerance", [each.rule.tolerance for each in known], kinds, digits=-4),
        text("verdict", [each.words for each in known]),
        title="Rules of golf",
    )
    shown = club_result(checked)
    return shown.replace(tables=(*shown.tables, verdicts), notes=(*shown.notes, *notes), hints=(_summary(known, file),))


def _summary(verdicts: Sequence[RuleVerdict], file: str) -> Note:
    broken = [each.rule.title for each in verdicts if each.conforms is False]
    unknown = [each.rule.title for each in verdicts if each.conforms is None]
    if broken:
        return note("club-does-not-conform", file=file, broken=broken)
    if unknown:
        return note("club-partly-judged", file=file, unknown=unknown)
    return note("club-conforms" if verdicts else "club-possible", file=file)


def _quantity_of(rule: Rule) -> Quantity:
    """Return the quantity of a rule's limit, in the unit of the printed rule."""
    reading = Reading(rule.unit, 4)
    return Quantity(rule.name, units.SI_UNITS[units.unit(rule.unit).dimension], reading, reading, rule.title)
