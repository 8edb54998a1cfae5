"""``clubface clubs``: the built-in clubs and balls, or one of them in full."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface import units
from clubface.cli import options, output
from clubface.cli.output import print_words
from clubface.support.checks import without_warnings

app = typer.Typer(add_completion=False)

_HEADS = ["club", "loft\ndeg", "mass\ng", "MOI\ng cm2", "CG\nbehind\nface\nmm", "CG\nabove\nnormal\nmm", "what it is"]


@app.command()
def clubs(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME|FILE]", help="Show this club in full.", show_default=False)
    ] = None,
    as_json: options.Json = False,
) -> None:
    """List the built-in clubs by kind, and the balls, or show one club with the source of every value."""
    from clubface.equipment.balls import ball_names
    from clubface.equipment.clubs import CATEGORIES, CLUB_NAMES, TOUR_CLUBS, Ball, club

    if name is not None:
        found = club(name)
        if as_json:
            output.print_json(describe(found))
        else:
            print_club(found)
        return
    heads = sorted(map(club, CLUB_NAMES), key=lambda each: (each.name not in TOUR_CLUBS, each.loft))
    with without_warnings():
        balls = [Ball.builtin(each) for each in ball_names()]
    if as_json:
        output.print_json({"clubs": [describe(each) for each in heads], "balls": [describe(each) for each in balls]})
        return
    rows = []
    for category in CATEGORIES:
        rows.append([category, *[""] * (len(_HEADS) - 1)])
        rows += [
            [
                f"  {each.name}", _cell(each, "loft"), _cell(each, "mass"), _cell(each, "iyy"),
                _millimetres(each.cg_depth), _millimetres(each.cg_height), each.description,
            ]
            for each in heads
            if each.category == category
        ]  # fmt: skip
    print_words(_HEADS, rows, numbers=(1, 2, 3, 4, 5))
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
        "MOI is the moment of inertia about the vertical axis; the normal is that through the face centre. A parametric"
        " club is plausible, not measured; clubface clubs NAME shows the source or the assumption of every value."
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
        found |= {"category": subject.category, "cg_depth": subject.cg_depth, "cg_height": subject.cg_height}
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
    output.print_notes([_place_of_cg(found)])
    for source, index in sources.items():
        print(f"[{index}] {source}")


def _cell(found: Any, key: str) -> str:
    import math

    from clubface.equipment.clubs import CLUB_PROPERTIES

    value = getattr(found, key)
    if key.startswith("cg"):
        return f"{units.from_si(value, 'mm'):.2f}"
    return "flat" if math.isinf(value) else f"{units.from_si(value, CLUB_PROPERTIES[key].unit):.4g}"


def _millimetres(length: float) -> str:
    return f"{round(units.from_si(length, 'mm'), 1) + 0.0:.1f}"


def _place_of_cg(found: Any) -> str:
    depth, height = found.cg_depth, found.cg_height
    behind, above = ("behind" if depth >= 0.0 else "in front of"), ("above" if height >= 0.0 else "below")
    return (
        f"The CG lies {_millimetres(abs(depth))} mm {behind} the face and {_millimetres(abs(height))} mm {above} the"
        " normal through the face centre."
    )
