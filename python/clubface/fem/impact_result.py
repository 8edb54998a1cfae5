"""Finite element impacts and balls as results: launch and contact, histories, materials and pictures."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from clubface import units
from clubface.equipment.balls import BALL_DIAMETER_LIMIT, BALL_MASS_LIMIT
from clubface.fem.balls import Ball
from clubface.fem.paper import (
    PUBLISHED,
    SPIN_FACTOR,
    error_note,
    mesh_row,
    other_solvers,
    spin_factor,
    table as paper_table,
)
from clubface.fem.result import Impact
from clubface.quantities import quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Picture
from clubface.results.result import Provenance, Result
from clubface.results.table import Column, Table, column, table, text
from clubface.simulation.launch import assumptions_of
from clubface.simulation.provenance import flight_conditions, provenance_of
from clubface.units import SI_UNITS, fixed, to_si

__all__ = ["ball_result", "columns_of", "impact_result", "materials_table", "paper_result", "reference_result"]

PRINTED = ("ball_speed", "launch", "azimuth", "backspin", "sidespin", "spin_axis", "carry", "side", "apex")
"""Quantities of launch and flight that are printed."""
CONTACT = (
    "peak_force", "peak_force_time", "contact_time", "tangential_max", "tangential_min", "reversal_time", "spin_max",
    "contraction", "contraction_time", "f_prime", "f",
)  # fmt: skip
"""Quantities of the contact that are printed."""
_STYLES: dict[str, dict[str, Any]] = {
    "launch": {"digits": 2}, "azimuth": {"digits": 2}, "peak_force": {"unit": "N", "digits": 0},
    "tangential_max": {"unit": "N", "digits": 0}, "tangential_min": {"unit": "N", "digits": 0},
    "tangential_first": {"digits": 2}, "tangential_least": {"digits": 2}, "tangential_last": {"digits": 2},
    "tangential_least_time": {"unit": "us", "digits": 0},
    "contraction": {"unit": "%", "digits": 1}, "f_prime": {"digits": 4}, "f": {"digits": 4},
}  # fmt: skip
"""Print formats that differ from the quantity registry."""
_HISTORIES = {"toe": "toe_force", "strain": "strain_energy", "friction": "friction_energy", "damping": "damping_energy"}
"""Quantities of histories whose key is the name of another quantity."""
ROWS_SHOWN = 12


def impact_result(impact: Impact, name: str = "", description: str = "") -> Result:
    """Return an impact as a result; ``name`` and ``description`` come from its case."""
    out = impact.outcome()
    numbers = {each: getattr(impact, each) for each in (*CONTACT, "energy_error", "steps", "step", "wall")}
    flown = impact.flown()
    printed = (*(each for each in out if impact.launch is None or each in PRINTED), *flown, *CONTACT)
    values = [column_of(each, [value], printed=each in printed) for each, value in (out | flown | numbers).items()]
    given = impact.provenance["delivery"] | {"friction": impact.friction, "duration": impact.settings.duration}
    units_of = {"angle": "rad", "duration": "s"}
    values += [column(each, [value], units_of.get(each), printed=False) for each, value in given.items()]
    elements = {"elements": impact.elements, "head_elements": 0 if impact.head is None else impact.head.elements}
    values += [text(each, [count], printed=False) for each, count in elements.items()]
    values.append(text("stopped", [impact.stopped or ""], printed=False))
    head = "a rigid plane" if impact.equipment is None else impact.equipment[0].name
    inputs = {
        "case": name, "ball": impact.ball.name, "head": head, "friction": f"{impact.friction:g}",
        "elements": str(impact.elements),
    } | {
        each.replace("_", " "): fixed(value, "us", 0) if each in ("duration", "interval") else str(value)
        for each, value in impact.settings.values().items() if value is not None
    }  # fmt: skip
    if impact.launch is None:
        inputs |= {each: str(value) for each, value in impact.given.items()}
    inputs = {each: value for each, value in inputs.items() if value}
    launches = [] if impact.launch is None else [impact.launch]
    return Result(
        kind="impact", title=description or name or f"{impact.ball.name} on {head}", values=tuple(values),
        tables=(_history("contact", impact.contact), _history("motion", impact.motion),
                _history("energy", impact.energy), materials_table(impact.ball)),
        summary=tuple(_summary(impact, head, out | flown)), notes=(cost_note(impact), error_note()),
        assumptions=assumptions_of(launches),
        provenance=provenance_of(launches, inputs | (flight_conditions() if flown else {})) if launches
        else Provenance(inputs),
        draw=(lambda: _pictures(impact)) if len(impact.patch["time"]) else None,
    )  # fmt: skip


def column_of(name: str, values: Any, like: str | None = None, **options: Any) -> Column:
    """Return a column of a finite element quantity, formatted as in tables of impacts."""
    return column(name, values, like, **{**_STYLES.get(name, {}), **options})


_UNITS = {"mps": "m/s", "deg": "deg", "rpm": "rpm", "n": "N", "s": "s", "mm": "mm", "us": "us"}
"""Units of numbers by the suffix of their keys."""


def columns_of(
    rows: Sequence[Mapping[str, Any]],
    keys: Iterable[str],
    *,
    unit: str | None = None,
    labels: Mapping[str, str] | None = None,
) -> list[Column]:
    """Return columns for the ``keys`` of rows, whose suffixes give the units.

    Speeds are printed in ``unit``, default mph; ``labels`` override the headings of some keys.
    """
    columns = []
    for key in keys:
        name, _, ending = key.rpartition("_")
        values, label = [row.get(key) for row in rows], (labels or {}).get(key, "")
        if (own := _UNITS.get(ending)) is None:
            is_text = any(isinstance(each, str) for each in values)
            columns.append(text(key, values) if is_text else column_of(key, values, label=label))
            continue
        values = [None if each is None else to_si(each, own) for each in values]
        options = {"unit": unit} if own == "m/s" and unit else {}
        columns.append(column_of(name, values, SI_UNITS[units.unit(own).dimension], label=label, **options))
    return columns


def cost_note(impact: Impact) -> Note:
    """Return the note on a run's cost and energy balance."""
    data = {"elements": impact.elements, "steps": impact.steps, "safety": impact.settings.safety, "wall": impact.wall,
            "energy_error": impact.energy_error}  # fmt: skip
    if impact.stopped and not impact.unfinished:
        # A failed run keeps the records up to its last good energy balance; its error is from a later time.
        return note("cost-of-failed-run", **data, last_time=float(impact.energy["time"][-1:].sum()))
    return note("cost-of-run", **data)


def _summary(impact: Impact, head: str, out: dict[str, float]) -> Iterator[Note]:
    if impact.stopped:
        yield note("no-launch", reason=impact.stopped)
        return
    ball = impact.ball.name
    if impact.launch is None:
        yield note("rebound", ball=ball, head=head, backspin=out["backspin"])
    else:
        flight = {each: out[each] for each in ("ball_speed", "launch", "azimuth", "backspin")}
        yield note("launch-of-impact", ball=ball, head=head, **flight)
    yield note("contact-of-impact", contact_time=impact.contact_time, peak_force=impact.peak_force)
    if "carry" in out:
        yield note("carry-in-still-air", carry=out["carry"])


def _history(name: str, arrays: dict[str, Any]) -> Table:
    """Return arrays over the same records as a table; vectors become three columns."""
    columns = []
    for each, values in arrays.items():
        known = _HISTORIES.get(each, each)
        if values.ndim == 1:
            columns.append(column(known, values))
        else:
            axes = zip(("normal", "up", "toe"), values.T, strict=True)
            columns += [column(f"{known}_{axis}", along, known) for axis, along in axes]
    shown = range(0, len(columns[0].values), max(len(columns[0].values) // ROWS_SHOWN, 1))
    return table(name, *columns, title=f"{name.capitalize()} over time", printed=False, shown_rows=shown)


def materials_table(ball: Ball) -> Table:
    """Return the materials of a ball as a table, one value of one piece per row."""
    rows: list[tuple[str, str, float, str]] = []
    values = ball.values()
    for piece, core in zip(ball.pieces, values["pieces"], strict=True):
        dimensions = piece.material.constant_dimensions()
        constants = {name: (value, SI_UNITS[dimensions[name]]) for name, value in piece.material.constants.items()}
        known = {
            "radius": (core["radius"], "m"), "layers": (piece.layers, "1"), "density": (core["density"], "kg/m3"),
            "bulk_modulus": (core["bulk"], "Pa"), **constants,
        } | {
            f"branch_{number}_{name}": (value, unit)
            for number, branch in enumerate(piece.material.maxwell, 1)
            for name, value, unit in (("modulus", branch.modulus, "1"), ("time", branch.time, "s"))
        }  # fmt: skip
        rows += [(f"{piece.name} ({piece.material.law})", name, value, unit) for name, (value, unit) in known.items()]
    whole = {"mass": "kg", "inertia": "kg m2", "core_density": "kg/m3", "radius": "m", "nodes": "1", "elements": "1"}
    rows += [("whole ball", name, float(value), whole[name]) for name, value in ball.properties().items()]
    rows.append(("whole ball", "elements along an edge of the cube inside the core", float(ball.cube), "1"))
    pieces, names, numbers, unit = zip(*rows, strict=True)
    quantities = [quantity("value", each)._replace(name=name) for name, each in zip(names, unit, strict=True)]
    return table(
        "materials", text("piece", pieces), text("value of", names), Column("value", numbers, quantities, digits=-5),
        title=f"The ball {ball.name}", printed=False,
    )  # fmt: skip


LABELS = {
    "node_speed_mps": "the same, average over all nodes",
    "spin_rpm": "spin of the launch", "ball_spin_rpm": "spin of all nodes at take-off",
    "section_spin_rpm": "spin of a section's nodes at take-off", "rolling_spin_rpm": "spin if it rolled off",
    "tangential_first_mps": "velocity along the face at first", "tangential_least_mps": "least of it",
    "tangential_least_time_s": "time of the least", "tangential_last_mps": "velocity along the face at take-off",
}  # fmt: skip


def paper_result(runs: Mapping[str, Impact]) -> Result:
    """Return the figures of Roh and Lee, published and computed by each contact method, as a result."""
    rows = [PUBLISHED, *(paper_table(run) for run in runs.values())]
    first = next(iter(runs.values()))
    factors = [SPIN_FACTOR, *(spin_factor(run) for run in runs.values())]
    columns = columns_of(rows, dict.fromkeys(key for each in reversed(rows) for key in each), unit="m/s",
                         labels=LABELS)  # fmt: skip
    figures = Table(
        "paper",
        (text("source", ["Roh and Lee", *runs]), *columns,
         column("spin_factor", factors, "1", label="f that the spin means, Eq. (6)", digits=4)),
        "The case of Roh and Lee, as published and as computed by each method of contact", "transposed",
    )  # fmt: skip
    whole = impact_result(first)

    def draw() -> list[Picture]:
        from clubface.fem.pictures import models_picture, paper_picture

        return [*whole.pictures(), paper_picture(runs), models_picture(first)]

    return whole.replace(
        kind="paper", title=figures.title, tables=(figures, *whole.tables),
        values=tuple(replace(each, printed=False) for each in whole.values),
        notes=(*(cost_note(run) for run in runs.values()), error_note()), draw=whole.draw and draw,
    )  # fmt: skip


def reference_result(impact: Impact, *, published: bool, finer: Sequence[Impact] = ()) -> Result:
    """Return the reference case as a result, with other solvers if ``published``, and finer meshes if given."""
    names, others = other_solvers() if published else ([], {})
    own = {
        "normal_velocity_mps": impact.normal_velocity, "tangential_velocity_mps": impact.tangential_velocity,
        "backspin_rpm": units.from_si(impact.backspin, "rpm"), "spin_max_rpm": units.from_si(impact.spin_max, "rpm"),
        "peak_force_n": impact.peak_force, "peak_force_time_s": impact.peak_force_time,
        "contact_time_s": impact.contact_time, "tangential_max_n": impact.tangential_max,
        "tangential_min_n": impact.tangential_min, "reversal_time_s": impact.reversal_time,
    }  # fmt: skip
    rows = [own, *({key: values[solver] for key, values in others.items() if solver < len(values)}
                   for solver in range(len(names)))]  # fmt: skip
    title = "Reference case, compared with other solvers" if published else "Reference case, varied"
    columns = (text("solver", ["clubface", *names]), *columns_of(rows, own, unit="m/s"))
    tables = [Table("reference", columns, title, "transposed")]
    result = impact_result(impact)
    notes = result.notes
    if finer:
        on_meshes = [mesh_row(run) for run in (impact, *finer)]
        count = text("elements", [each.pop("elements") for each in on_meshes])
        digits = {"ball_speed": 2, "angle": 2}
        made = [replace(each, digits=digits.get(each.name)) for each in columns_of(on_meshes, on_meshes[0], unit="m/s")]
        tables.append(table("meshes", count, *made, title="The same on finer meshes"))
        first, last = on_meshes[0], on_meshes[-1]
        keys = {"speed": "ball_speed_mps", "spin": "backspin_rpm", "force": "peak_force_n"}
        spread = {f"{what}_over_meshes": abs(last[key] / first[key] - 1.0) for what, key in keys.items()}
        notes = (*notes, note("mesh-spread", coarse=count.values[0], fine=count.values[-1], **spread))
    return result.replace(kind="reference", title=title, values=(), tables=tuple(tables), notes=notes)


def ball_result(ball: Ball) -> Result:
    """Return a meshed ball, compared with its specification and the rules, as a result."""
    meshed = ball.properties()
    diameter, solid = 2.0 * meshed["radius"], 0.4 * meshed["mass"] * meshed["radius"] ** 2
    conforms = meshed["mass"] <= BALL_MASS_LIMIT and diameter >= BALL_DIAMETER_LIMIT
    columns = (
        text("row", ["meshed", "asked for", "rule"], label=""),
        column("mass", [meshed["mass"], ball.mass, BALL_MASS_LIMIT], digits=2, label="mass (rule: at most)"),
        column("diameter", [diameter, ball.diameter, BALL_DIAMETER_LIMIT], "m", unit="mm", digits=2,
               label="diameter (rule: at least)"),
        column("inertia", [meshed["inertia"], None, None], "kg m2", digits=2),
        column("inertia_ratio", [meshed["inertia"] / solid, None, None], "1", digits=4,
               label="inertia over homogeneous"),
        column("core_density", [meshed["core_density"], None, None], "density", label="density of the core"),
        *(column(name, [int(meshed[name]), None, None], "1", digits=0) for name in ("elements", "nodes")),
        text("conforms", [conforms, None, None], printed=False),
    )  # fmt: skip
    title = ball.description or ball.name
    table = Table("ball", columns, title, "transposed")
    return Result(
        "ball", title, (table, materials_table(ball)), provenance=Provenance({"ball": ball.name}),
        notes=(note("ball-conforms" if conforms else "ball-does-not-conform"),),
    )  # fmt: skip


def _pictures(impact: Impact) -> list[Picture]:
    from clubface.fem.pictures import impact_picture, patch_picture
    from clubface.fem.section_picture import section_picture

    pictures = [impact_picture(impact), patch_picture(impact)]
    return [*pictures, section_picture(impact)] if len(impact.frames) > 1 else pictures
