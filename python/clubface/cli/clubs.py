"""``clubface clubs``: the built-in clubs and balls, or one of them in full."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface import units
from clubface.cli import options, output
from clubface.cli.tables import print_numbers, print_words
from clubface.support.warning import without_warnings

app = typer.Typer(add_completion=False)

_COLUMNS = {
    "mass": "mass\ng", "loft": "loft\ndeg", "iyy": "MOI\ng cm2", "cg_x": "CG to face\nx, mm", "cg_y": "\ny, mm",
    "cg_z": "\nz, mm", "bulge": "bulge\nmm", "roll": "roll\nmm",
}  # fmt: skip


@app.command()
def clubs(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME|FILE]", help="Show this club in full.", show_default=False)
    ] = None,
    as_json: options.Json = False,
) -> None:
    """List the built-in clubs and balls, or show one club with the source of every value."""
    from clubface.equipment.balls import ball_names
    from clubface.equipment.clubs import CLUB_NAMES, Ball, club

    if name is not None:
        found = club(name)
        if as_json:
            output.print_json(describe(found))
        else:
            print_club(found)
        return
    heads = [club(each) for each in CLUB_NAMES]
    with without_warnings():
        balls = [Ball.builtin(each) for each in ball_names()]
    if as_json:
        output.print_json({"clubs": [describe(each) for each in heads], "balls": [describe(each) for each in balls]})
        return
    rows = [[each.name, *(_cell(each, key) for key in _COLUMNS), each.parameters, _origin(each)] for each in heads]
    print_numbers(["club", *_COLUMNS.values(), "para-\nmeters\nof", "origin"], rows)
    print()
    weights = [
        [
            each.name,
            *(
                f"{units.from_si(value, unit):.2f}"
                for value, unit in ((each.mass, "g"), (2.0 * each.radius, "mm"), (each.inertia, "g cm2"))
            ),
            each.description,
        ]
        for each in balls
    ]
    print_words(["ball", "mass\ng", "dia-\nmeter\nmm", "inertia\ng cm2", "what it is"], weights, numbers=(1, 2, 3))
    notes = [
        "MOI is the moment of inertia about the vertical axis. Clubs marked scaled are a plausible parametric set, not"
        " measured; clubface clubs NAME shows the source or rule of every value."
    ]
    if any(2.0 * each.radius < 42.67e-3 for each in balls):
        notes.append(
            "The published models were identified with a ball of 42.60 mm, a little below the 42.67 mm of the rules."
        )
    output.print_notes(notes)


def describe(subject: Any) -> dict[str, Any]:
    """Return a club or ball as a document: its values in SI with the unit of each, and their sources."""
    from clubface.equipment.balls import BALL_PROPERTIES
    from clubface.equipment.clubs import CLUB_PROPERTIES, Club

    is_club = isinstance(subject, Club)
    quantities = CLUB_PROPERTIES if is_club else BALL_PROPERTIES
    found: dict[str, Any] = {"name": subject.name, "description": subject.description}
    if is_club:
        found |= {"kind": subject.kind, "hand": subject.hand, "parameters": subject.parameters}
    found["values"] = {key: getattr(subject, key) for key in quantities}
    found["units"] = {key: units.SI_UNITS[each.dimension] for key, each in quantities.items()}
    found["sources"] = dict(subject.sources)
    return found


def print_club(found: Any) -> None:
    """Print one club with the meaning and source of every value."""
    from clubface.equipment.clubs import CLUB_PROPERTIES

    hand = "" if found.hand > 0 else ", left-handed"
    print(f"{found.name}: {found.description or found.kind}{hand}; parameters of {found.parameters}")
    sources: dict[str, int] = {}
    rows = []
    for key, quantity in CLUB_PROPERTIES.items():
        if getattr(found, key) is None or (key == "characteristic_time" and hasattr(found, "head") and not found.cor
                                           and not found.characteristic_time):  # fmt: skip
            continue  # the mesh gives, by how much nobody has measured
        source = found.sources.get(key, "")
        mark = f"[{sources.setdefault(source, len(sources) + 1)}]" if source else ""
        rows.append([key, _cell(found, key), quantity.unit.replace("1", ""), mark, quantity.meaning])
    print_words(["field", "value", "unit", "source", "meaning"], rows, numbers=(1,))
    print()
    for source, index in sources.items():
        print(f"[{index}] {source}")


def _cell(found: Any, key: str) -> str:
    import math

    from clubface.equipment.clubs import CLUB_PROPERTIES

    value = getattr(found, key)
    if key.startswith("cg"):
        return f"{units.from_si(value, 'mm'):.2f}"
    return "flat" if math.isinf(value) else f"{units.from_si(value, CLUB_PROPERTIES[key].unit):.4g}"


def _origin(found: Any) -> str:
    source = found.sources.get("mass", "")
    return "paper" if source.startswith("Table") else "scaled"
