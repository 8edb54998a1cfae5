"""A meshed head as a result: mass properties, how targets were met, simulated tests, and strength."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from clubface.equipment.rules import RuleVerdict, rules, rules_of
from clubface.fem.heads import MeshedHead, ShellHead
from clubface.fem.stress import ImpactStress, stress_picture
from clubface.results.notes import Note, note
from clubface.results.result import Provenance, Result
from clubface.results.table import Column, Table, column, text

__all__ = ["head_result"]

OVER_MESHES = {"mesh_restitution": 0.002, "mesh_characteristic_time": 24e-6}
"""Largest differences of the simulated tests between meshes of one driver: restitution, and time [s]. They come from
the table of triangles and quadrilaterals in docs/finite-elements/heads.md; a test compares the two."""
SHOWN = ("mass", "cg_x", "cg_y", "cg_z", "cg_above", "ixx", "iyy", "izz")


def head_result(
    head: MeshedHead,
    *,
    tests: Mapping[str, float] | None = None,
    stress: ImpactStress | None = None,
    inputs: Mapping[str, str] | None = None,
) -> Result:
    """Return a head as a result, with simulated tests and the stress in an impact if given.

    ``tests`` are restitution and characteristic time [s], by name; ``inputs`` are those of the tests and the impact as
    text: "impact_speed", "toe", "ball".
    """
    asked = dict(head.asked) if isinstance(head, ShellHead) else {}
    measured, inputs = dict(tests or {}), dict(inputs or {})
    rows = ["meshed", "asked for"] if asked else ["meshed"]
    values = {name: getattr(head if name == "cg_above" else head.club, name) for name in SHOWN}

    def value_column(name: str, value: Any, like: str | None = None, **options: Any) -> Column:
        return column(name, [value, asked.get(name)][: len(rows)], like, **options)

    columns = [value_column(name, value, digits=2 if values[name] is not None and name[:2] in ("cg", "ma") else None)
               for name, value in values.items()]  # fmt: skip
    columns += [value_column(name, getattr(head.club, name), printed=False) for name in ("ixy", "ixz", "iyz")]
    if "scale" in head.report:
        columns.append(value_column("wall_scale", head.report["scale"], "1", label="walls over design"))
    columns += [value_column(f"added_mass_{name}", mass, "mass", label=f"added mass {name}")
                for name, mass in head.report.items() if name != "scale"]  # fmt: skip
    columns.append(value_column("elements", head.elements, "1", digits=0))
    columns += [value_column(name, value) for name, value in measured.items()]
    title = head.description or head.name
    notes = [note("held-as-delivered")] if any(each.startswith("cg_") for each in asked) else []
    return Result(
        kind="head", title=title,
        tables=(Table("head", (text("row", rows, label=""), *columns), title, "transposed"),
                *(() if stress is None else _stress_tables(stress, inputs))),
        summary=tuple(_summary(head, measured, stress, inputs)),
        notes=(*_verdict(head, measured, inputs), *(stress.notes() if stress is not None else ()), *notes),
        provenance=Provenance({"head": head.name, "elements": str(head.elements), **inputs}),
        draw=None if stress is None else lambda: [stress_picture(stress, head.loft)],
    )  # fmt: skip


def _stress_tables(stress: ImpactStress, inputs: Mapping[str, str]) -> Iterator[Table]:
    parts = stress.parts
    places = (("x", "to the target"), ("y", "above centre"), ("z", "to the toe"))
    yield Table(
        "stress",
        (
            text("part", [part.part for part in parts]),
            column("stress", [part.stress for part in parts], label="largest stress", digits=0),
            column("yield_stress", [part.yield_stress for part in parts], label="yields at", digits=0),
            column("margin", [part.margin for part in parts], label="margin"),
            column("time", [part.time for part in parts], label="after", unit="us", digits=0),
            *(column(f"place_{name}", [part.place[axis] for part in parts], "m", label=label, unit="mm", digits=1,
                     printed=axis > 0) for axis, (name, label) in enumerate(places)),
            *([column("spread", [part.spread for part in parts], "1", label="spread by mesh", unit="%", digits=0)]
              if parts[0].spread is not None else []),
        ),
        f"An impact at {inputs.get('impact_speed', 'the club')}",
    )  # fmt: skip
    meshes = [(part.part, elements, stress) for part in parts for elements, stress in part.by_mesh]
    names, elements, stresses = zip(*meshes, strict=True)
    yield Table(
        "meshes",
        (text("part", names), text("elements", elements), column("stress", stresses, digits=0)),
        "Largest stress (MPa) by number of elements", "pivot", printed=parts[0].spread is not None,
    )  # fmt: skip


def _summary(
    head: MeshedHead, measured: Mapping[str, float], stress: ImpactStress | None, inputs: Mapping[str, str]
) -> Iterator[Note]:
    yield note("head-mass", mass=head.club.mass, iyy=head.club.iyy)
    if head.club.kind == "wood":
        yield note("inertia-limit", limit_iyy=rules()["moment_of_inertia"].most)
    if measured:
        yield note("face-gives", **measured)
    if stress is None:
        return
    named = {"blow": inputs.get("impact_speed", "the club")}
    known = [part for part in stress.parts if part.margin is not None]
    for part in known:
        if part.margin is not None and part.margin < 0.0:
            yield note(
                "part-yields", part=part.part, stress=part.stress, yield_stress=part.yield_stress,
                bearable_speed=stress.speed * (1.0 + part.margin), **named,
            )  # fmt: skip
    weakest = min(known, key=lambda part: part.margin or 0.0, default=None)
    if weakest is not None and weakest.margin is not None and weakest.margin >= 0.0:
        yield note("no-part-yields", part=weakest.part, margin=weakest.margin, **named)
    if others := [part.part for part in stress.parts if part.margin is None]:
        yield note("no-yield-stress", parts=others)
    peak = max(stress.parts, key=lambda part: part.stress)
    places = dict(zip(("forward", "high", "toe"), peak.place, strict=True))
    yield note("largest-stress", part=peak.part, stress=peak.stress, **places)
    if peak.spread is not None:
        counts = [str(elements) for elements, _ in peak.by_mesh[1:]]
        yield note("mesh-dependence", counts=counts, spread=peak.spread)
    yield note("strength-not-counted")


def _verdict(head: MeshedHead, measured: Mapping[str, float], inputs: Mapping[str, str]) -> Iterator[Note]:
    """Yield the ruling on a simulated characteristic time, and the line that gives this time in a file."""
    if (time := measured.get("characteristic_time")) is None:
        return
    limit = rules()["characteristic_time"]
    if limit in rules_of(head.club):
        verdict = RuleVerdict(limit, time)
        conforming = "face-conforms-within-tolerance" if verdict.within_tolerance else "face-conforms"
        code = conforming if verdict.conforms else "face-does-not-conform"
        yield note(code, limit_characteristic_time=limit.most, most_characteristic_time=limit.limit)
    yield note("face-test-error", **OVER_MESHES)
    if not {"toe", "high"} & inputs.keys() and not head.club.characteristic_time:
        yield note("face-line", characteristic_time=time)
