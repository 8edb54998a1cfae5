"""A finite element impact as a result: launch and contact, histories, the materials of the ball, and pictures."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface.fem.balls import Ball
from clubface.quantities import quantity
from clubface.results.notes import Note, note
from clubface.results.provenance import Provenance
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, table, text
from clubface.simulation.provenance import flight_conditions, provenance_of
from clubface.units import SI_UNITS, fixed

if TYPE_CHECKING:
    from clubface.fem.result import Impact
    from clubface.results.pictures import Picture

__all__ = ["cost_note", "impact_result", "materials_table"]

PRINTED = ("ball_speed", "launch", "azimuth", "backspin", "sidespin", "spin_axis", "carry", "side", "apex")
"""What is printed of launch and flight."""
CONTACT = (
    "peak_force", "peak_force_time", "contact_time", "tangential_max", "tangential_min", "reversal_time", "spin_max",
    "contraction", "contraction_time", "f_prime", "f", "energy_error",
)  # fmt: skip
"""What is printed of the contact."""
_STYLES: dict[str, dict[str, Any]] = {
    "launch": {"digits": 2}, "azimuth": {"digits": 2}, "peak_force": {"unit": "N", "digits": 0},
    "tangential_max": {"unit": "N", "digits": 0}, "tangential_min": {"unit": "N", "digits": 0},
    "contraction": {"unit": "%", "digits": 1}, "f_prime": {"digits": 4}, "f": {"digits": 4},
}  # fmt: skip
"""How quantities are printed where that is not how the registry has them."""
_HISTORIES = {"toe": "toe_force", "strain": "strain_energy", "friction": "friction_energy", "damping": "damping_energy"}
"""Quantities of histories whose names are those of another."""
ROWS_SHOWN = 12


def impact_result(impact: Impact, name: str = "", description: str = "") -> Result:
    """Return an impact as a result; ``name`` and ``description`` are those of its case."""
    out = impact.outcome()
    flown, numbers = impact.flown(), {each: getattr(impact, each) for each in (*CONTACT, "steps", "step", "wall")}
    printed = (*(each for each in out if impact.launch is None or each in PRINTED), *flown, *CONTACT)
    values = [column_of(each, [value], printed=each in printed) for each, value in (out | flown | numbers).items()]
    values += [text("elements", [impact.elements]), text("stopped", [impact.stopped or ""], printed=False)]
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
        summary=tuple(_summary(impact, head, out | flown)), notes=(cost_note(impact),),
        provenance=provenance_of(launches, inputs | (flight_conditions() if flown else {})) if launches
        else Provenance(inputs),
        draw=(lambda: _pictures(impact)) if len(impact.patch["time"]) else None,
    )  # fmt: skip


def column_of(name: str, values: Any, **options: Any) -> Column:
    """Return a column of a quantity of the finite elements, printed as tables of impacts do."""
    return column(name, values, **{**_STYLES.get(name, {}), **options})


def cost_note(impact: Impact) -> Note:
    """Return what a run took, and how well its energies balance."""
    data = {"elements": impact.elements, "steps": impact.steps, "safety": impact.settings.safety, "wall": impact.wall,
            "energy_error": impact.energy_error}  # fmt: skip
    if impact.stopped and not impact.unfinished:
        # A run that failed keeps what it had until energies were last in balance; its error is that of a later time.
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
    yield note("energy-balance", energy_error=impact.energy_error)


def _history(name: str, arrays: dict[str, Any]) -> Table:
    """Return arrays over the same records as a table, a vector as three columns."""
    columns = []
    for each, values in arrays.items():
        of = _HISTORIES.get(each, each)
        if values.ndim == 1:
            columns.append(column(of, values))
        else:
            axes = zip(("normal", "up", "toe"), values.T, strict=True)
            columns += [column(f"{of}_{axis}", along, of) for axis, along in axes]
    shown = range(0, len(columns[0].values), max(len(columns[0].values) // ROWS_SHOWN, 1))
    return table(name, *columns, title=f"{name.capitalize()} over time", printed=False, shown_rows=shown)


def materials_table(ball: Ball) -> Table:
    """Return what a ball is made of, a value of a piece a row."""
    rows: list[tuple[str, str, float, str]] = []
    values = ball.values()
    for piece, core in zip(ball.pieces, values["pieces"], strict=True):
        constants = {name: (value, piece.material.unit_of(name)) for name, value in piece.material.constants.items()}
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
    of = [quantity("value", each)._replace(name=name) for name, each in zip(names, unit, strict=True)]
    return table(
        "materials", text("piece", pieces), text("value of", names), Column("value", numbers, of, digits=-5),
        title=f"The ball {ball.name}", printed=False,
    )  # fmt: skip


def _pictures(impact: Impact) -> list[Picture]:
    from clubface.fem.pictures import impact_picture, patch_picture
    from clubface.fem.section_picture import section_picture

    pictures = [impact_picture(impact), patch_picture(impact)]
    return [*pictures, section_picture(impact)] if len(impact.frames) > 1 else pictures
