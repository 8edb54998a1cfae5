"""A case as a keyword deck in the format of LS-DYNA, which OpenRadioss reads too, to compare with other programs."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from clubface import units
from clubface.fem.balls import Ball
from clubface.fem.cards import BALL_SET, Cards
from clubface.fem.case import MESHED, PLANE, RIGID, Case
from clubface.fem.keyword_head import write_head
from clubface.fem.materials import Material, laws
from clubface.fem.settings import Settings
from clubface.support.whole_file import write_text

USUAL_SAFETY = 0.9
"""Time step over the stable one where the case leaves it open: what other codes take."""

HEADER = (
    "Units: kg, m, s (N, Pa, J). Axes: x along the face normal at the point of first touch, y up the face, z to "
    "the toe; the origin is that point. A left-handed club appears as its mirror image.",
    "",
    "What has no exact equivalent here:",
    "- Solids have one point and assumed-strain hourglass control (type 6), close to that of clubface, not the same.",
    "- Plastics are linear in logarithmic strain in clubface, hypoelastic here: alike to some 10% of strain.",
    "- Rubber: the energy of *MAT_HYPERELASTIC_RUBBER is that of clubface; that of *MAT_OGDEN_RUBBER is but for the "
    "volumetric term, K (J - 1 - ln J) there; *MAT_MOONEY-RIVLIN_RUBBER uses invariants "
    "with the change of volume in them and another volumetric term, which nearly incompressible rubber hardly "
    "notices.",
    "- Viscous branches relax the stress of the elastic law in clubface, a stress linear in strain here: alike at "
    "moderate strain.",
    "- Friction of clubface sticks by tangential springs; a rigid wall has none.",
    "- Shells of clubface have one point in their plane and physical hourglass stiffness; type 2 is near.",
    "- Bulk viscosity is linear, and without a value in the case all but switched off; contact is by penalty.",
)


def write(case: Case, path: str | os.PathLike[str]) -> Path:
    """Write the keyword deck of a case.

    Parameters
    ----------
    case
        Any case; its ball is meshed as clubface meshes it.
    path
        The file, by custom with the ending ``.k``.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    InputError
        The case cannot be run, for example because the head moves away from the ball.
    """
    deck = Cards()
    deck.lines.append("*KEYWORD")
    deck.comment(f"clubface: {case.name}. {case.description}", *HEADER)
    deck.keyword("TITLE")
    deck.text(f"{case.name}: ball {case.ball.name}, {case.head}, {_delivered(case)}")
    _control(deck, case.settings, case.head)
    mesh = case.ball.mesh
    _ball(deck, case.ball, mesh)
    if case.head == PLANE:
        _plane(deck, case)
    else:
        write_head(deck, case, len(mesh["nodes"]), len(mesh["elements"]))
    deck.lines.append("*END")
    return write_text(path, str(deck), encoding="ascii")


def _delivered(case: Case) -> str:
    return ", ".join(f"{key} {value}" for key, value in case.delivery.items())


def _control(deck: Cards, how: Settings, head: str) -> None:
    deck.keyword("CONTROL_TERMINATION", [how.duration], names="endtim")
    deck.keyword("CONTROL_TIMESTEP", [0.0, how.safety or USUAL_SAFETY], names="dtinit tssfac")
    deck.keyword("CONTROL_ENERGY", [2, 2, 2, 2], names="hgen rwen slnten rylen")
    # A zero would mean the default.
    deck.keyword("CONTROL_BULK_VISCOSITY", [1e-6, max(how.bulk_viscosity, 1e-6), 1], names="q1 q2 type")
    of_head = {PLANE: ("RWFORC",), RIGID: ("RCFORC", "RBDOUT"), MESHED: ("RCFORC",)}[head]
    outputs = ("GLSTAT", "MATSUM", *of_head)
    for name in outputs:
        deck.keyword(f"DATABASE_{name}", [how.interval], names="dt")
    deck.keyword("DATABASE_BINARY_D3PLOT", [how.duration / max(how.frames - 1, 50)], names="dt")


def _ball(deck: Cards, ball: Ball, mesh: Mapping[str, Any]) -> None:
    """Write nodes, elements, parts and materials of the ball; it just touches the plane x = 0."""
    count = len(ball.pieces)
    deck.keyword("SECTION_SOLID", [1, 1], names="secid elform")
    deck.keyword("HOURGLASS", [1, 6, 1.0], names="hgid ihq qm")
    for number, piece in enumerate(ball.pieces, start=1):
        deck.keyword("PART")
        deck.text(f"{ball.name}: {piece.name}")
        deck.card([number, 1, number, 0, 1])
        _material(deck, number, piece.material, float(mesh["density"][number - 1]))
    deck.keyword("SET_PART_LIST", [BALL_SET], list(range(1, count + 1)), names="sid")
    places = mesh["nodes"] + [ball.diameter / 2.0, 0.0, 0.0]
    deck.nodes(places)
    deck.elements("SOLID", (mesh["piece"].astype(int) + 1).tolist(), mesh["elements"].astype(int) + 1)


def _material(deck: Cards, number: int, material: Material, density: float) -> None:
    """Write a material by the card that the core tells of its law."""
    branches, count = material.maxwell, len(material.maxwell)
    card = next(card for card in laws()[material.law].cards if card["branches"][0] <= count <= card["branches"][1])
    known = {
        **{"mid": number, "nv": count, "ro": density, "pr": material.poisson, "e": material.youngs},
        **{"bulk": material.bulk, "shear": material.shear, **material.constants},
        "g0": material.shear * (1.0 + sum(branch.modulus for branch in branches)),
        **({"beta": 1.0 / branches[0].time} if branches else {}),
    }
    rows = [_fields(row, known) for row in card["rows"]]
    deck.keyword(card["keyword"], *rows, names=card["names"])
    if branches and card["branch"]:
        deck.comment("      Gi     BETAi: relative moduli of clubface times its shear modulus, 1 / relaxation time")
        for branch in branches:
            of = {"g": branch.modulus * material.shear, "beta": 1.0 / branch.time}
            deck.card(_fields(card["branch"], of))


def _fields(row: str, known: Mapping[str, float]) -> list[float | None]:
    """Return the fields of a row: names, "2*name", "name#" for all names with a number, numbers, "-" for a blank."""
    fields: list[float | None] = []
    for each in row.split():
        factor, _, name = each.rpartition("*")
        scale = float(factor) if factor else 1
        if name == "-":
            fields.append(None)
        elif name.endswith("#"):
            fields += [value for key, value in known.items() if key.rstrip("0123456789") == name[:-1]]
        elif name in known:
            fields.append(scale * known[name])
        else:
            fields.append(int(name) if name.isdigit() else float(name))
    return fields


def _plane(deck: Cards, case: Case) -> None:
    speed = units.parse(case.delivery["speed"], "speed")
    angle = units.parse(case.delivery.get("angle", 0.0), "angle")
    velocity = [-speed * math.cos(angle), speed * math.sin(angle), 0.0]
    deck.keyword("INITIAL_VELOCITY_GENERATION", [BALL_SET, 1, 0.0, *velocity], [None], names="id styp omega vx vy vz")
    if case.friction >= 1.0:
        deck.comment(f"Friction is {case.friction:g}; a rigid wall takes 1 and more as sticking without limit.")
    deck.keyword("RIGIDWALL_PLANAR", [0], [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, min(float(case.friction), 1.0)], names="nsid")
