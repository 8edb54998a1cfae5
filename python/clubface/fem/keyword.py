"""A case as a keyword deck in LS-DYNA's format, which OpenRadioss reads too, so that other solvers can check ours."""

from __future__ import annotations

import math
import os
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from clubface import units
from clubface.clubs import Club
from clubface.delivery import DIMENSIONS
from clubface.errors import InputError
from clubface.fem.balls import Ball
from clubface.fem.cards import Cards, element, node
from clubface.fem.case import PLANE, Case
from clubface.fem.materials import Material
from clubface.fem.run import Settings, strike

if TYPE_CHECKING:
    from numpy.typing import NDArray

BALL_SET, HEAD_PART, HEAD_SECTION = 1, 101, 2
STEEL_DENSITY, STEEL_YOUNGS, STEEL_POISSON = 7850.0, 200e9, 0.3
"""Of the shells that carry the rigid face [kg/m3, Pa]: contact stiffness only; mass and inertia are given."""
SHELL = 1e-3
"""Thickness of these shells [m]."""
FACE_ELEMENT = 2.5e-3
"""Size of these shells [m]."""

HEADER = (
    "Units: kg, m, s (N, Pa, J). Axes: x along the face normal at the point of first touch, y up the face, z to "
    "the toe; the origin is that point. A left-handed club appears as its mirror image.",
    "",
    "What has no exact equivalent here:",
    "- Solids have one point and assumed-strain hourglass control (type 6), close to that of clubface, not the same.",
    "- Plastics are linear in logarithmic strain in clubface, hypoelastic here: alike to some 10% of strain.",
    "- Rubber: the energy of *MAT_HYPERELASTIC_RUBBER is that of clubface; *MAT_MOONEY-RIVLIN_RUBBER uses invariants "
    "with the change of volume in them and another volumetric term, which nearly incompressible rubber hardly "
    "notices.",
    "- Viscous branches relax the stress of the elastic law in clubface, a stress linear in strain here: alike at "
    "moderate strain.",
    "- Friction of clubface sticks by tangential springs; a rigid wall has none.",
    "- Bulk viscosity, which clubface does without, is all but switched off.",
)


def write(case: Case, path: str | os.PathLike[str]) -> Path:
    """Write the deck of a case.

    Parameters
    ----------
    case
        Any case; its ball is meshed as clubface meshes it.
    path
        The file, ``.k`` by custom.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    InputError
        A case that cannot be run, such as a head that moves away from the ball.
    """
    from clubface import _core

    deck = Cards()
    deck.lines.append("*KEYWORD")
    deck.comment(f"clubface: {case.name}. {case.description}", *HEADER)
    deck.keyword("TITLE")
    deck.text(f"{case.name}: ball {case.ball.name}, {case.head}, {_delivered(case)}")
    _control(deck, case.settings, case.head)
    mesh = _core.fem_mesh(case.ball.values())
    nodes = len(mesh["nodes"])
    _ball(deck, case.ball, mesh)
    if case.head == PLANE:
        _plane(deck, case)
    else:
        _head(deck, case, nodes, len(mesh["elements"]))
    deck.lines.append("*END")
    target = Path(path)
    target.write_text(str(deck), encoding="ascii")
    return target


def _delivered(case: Case) -> str:
    return ", ".join(f"{key} {value}" for key, value in case.delivery.items())


def _control(deck: Cards, how: Settings, head: str) -> None:
    deck.keyword("CONTROL_TERMINATION", [how.duration], names="endtim")
    deck.keyword("CONTROL_TIMESTEP", [0.0, how.safety], names="dtinit tssfac")
    deck.keyword("CONTROL_ENERGY", [2, 2, 2, 2], names="hgen rwen slnten rylen")
    deck.keyword("CONTROL_BULK_VISCOSITY", [1e-6, 1e-6, 1], names="q1 q2 type")
    outputs = ("GLSTAT", "MATSUM", "RWFORC") if head == PLANE else ("GLSTAT", "MATSUM", "RCFORC", "RBDOUT")
    for name in outputs:
        deck.keyword(f"DATABASE_{name}", [how.interval], names="dt")
    deck.keyword("DATABASE_BINARY_D3PLOT", [how.duration / max(how.frames - 1, 50)], names="dt")


def _ball(deck: Cards, ball: Ball, mesh: dict[str, Any]) -> None:
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
    deck.keyword("NODE")
    deck.rows(node(number, place) for number, place in enumerate(places.tolist(), start=1))
    deck.keyword("ELEMENT_SOLID")
    of_piece, corners = mesh["piece"].tolist(), (mesh["elements"].astype(int) + 1).tolist()
    deck.rows(
        element(number, piece + 1, each) for number, (piece, each) in enumerate(zip(of_piece, corners, strict=True), 1)
    )


def _material(deck: Cards, number: int, material: Material, density: float) -> None:
    values, branches, ratio = material.constants, material.maxwell, material.poisson
    if material.law == "linear":
        _plastic(deck, number, material, density)
        return
    if material.law not in ("mooney-rivlin", "neo-hookean"):
        raise InputError("law", material.law, "one that a keyword deck has: mooney-rivlin, neo-hookean, linear")
    c10, c01 = (values["c10"], values["c01"]) if material.law == "mooney-rivlin" else (values["shear"] / 2.0, 0.0)
    if material.law == "mooney-rivlin" and not branches:
        deck.keyword("MAT_MOONEY-RIVLIN_RUBBER", [number, density, ratio, c10, c01], [None], names="mid ro pr a b")
        return
    deck.keyword(
        "MAT_HYPERELASTIC_RUBBER", [number, density, ratio, 0, len(branches)], [c10, c01], names="mid ro pr n nv"
    )
    if branches:
        deck.comment("      Gi     BETAi: relative moduli of clubface times its shear modulus, 1 / relaxation time")
    for branch in branches:
        deck.card([branch.modulus * material.shear, 1.0 / branch.time])


def _plastic(deck: Cards, number: int, material: Material, density: float) -> None:
    shear, branches = material.shear, material.maxwell
    if not branches:
        deck.keyword("MAT_ELASTIC", [number, density, material.youngs, material.poisson], names="mid ro e pr")
    elif len(branches) == 1:
        card = [number, density, material.bulk, shear * (1.0 + branches[0].modulus), shear, 1.0 / branches[0].time]
        deck.keyword("MAT_VISCOELASTIC", card, names="mid ro bulk g0 gi beta")
    else:
        deck.keyword("MAT_GENERAL_VISCOELASTIC", [number, density, material.bulk], [None], names="mid ro bulk")
        deck.comment("      Gi     BETAi; the first does not relax")
        deck.card([shear, 0.0])
        for branch in branches:
            deck.card([branch.modulus * shear, 1.0 / branch.time])


def _plane(deck: Cards, case: Case) -> None:
    speed = units.parse(case.delivery["speed"], "speed")
    angle = units.parse(case.delivery.get("angle", 0.0), "angle")
    velocity = [-speed * math.cos(angle), speed * math.sin(angle), 0.0]
    deck.keyword("INITIAL_VELOCITY_GENERATION", [BALL_SET, 1, 0.0, *velocity], [None], names="id styp omega vx vy vz")
    if case.friction >= 1.0:
        deck.comment(f"Friction is {case.friction:g}; a rigid wall takes 1 and more as sticking without limit.")
    deck.keyword("RIGIDWALL_PLANAR", [0], [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, min(float(case.friction), 1.0)], names="nsid")


def _head(deck: Cards, case: Case, nodes: int, elements: int) -> None:
    """Write the rigid head: a mesh of its face for contact, its mass, inertia and motion as numbers."""
    import numpy as np

    club = case.club
    assert club is not None
    hit = _first_touch(case)
    deck.keyword("PART_INERTIA")
    deck.text(f"{club.name}: rigid")
    deck.card([HEAD_PART, HEAD_SECTION, HEAD_PART])
    deck.card([*hit["cg"], club.mass, 0])
    inertia = hit["inertia"]
    deck.card([inertia[i][j] for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))])
    deck.card([*hit["velocity"], *hit["spin"]])
    deck.keyword(
        "MAT_RIGID", [HEAD_PART, STEEL_DENSITY, STEEL_YOUNGS, STEEL_POISSON], [0.0], [None], names="mid ro e pr"
    )
    deck.keyword("SECTION_SHELL", [HEAD_SECTION, 2], [SHELL] * 4, names="secid elform")
    deck.comment("The shells lie half their thickness behind the face, so that contact is on the face itself.")
    places, quads = _face_mesh(club)
    places = (places - hit["point"]) @ np.asarray(hit["axes"]).T
    deck.keyword("NODE")
    deck.rows(node(nodes + number, place) for number, place in enumerate(places.tolist(), start=1))
    deck.keyword("ELEMENT_SHELL")
    deck.rows(
        element(elements + number, HEAD_PART, each) for number, each in enumerate((quads + nodes + 1).tolist(), start=1)
    )
    deck.comment("Penalty by node mass and time step (SOFT = 1), as in clubface.")
    deck.keyword("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE")
    cover = len(case.ball.pieces)
    deck.card([cover, HEAD_PART, 3, 3, 0, 0, 1, 1])
    deck.card([float(case.friction), float(case.friction)])
    deck.card([None])
    deck.card([1])


def _first_touch(case: Case) -> dict[str, Any]:
    """Return the head at first touch, in the axes of the deck, and ``axes`` and ``point`` in those of the face."""
    import numpy as np

    club = case.club
    assert club is not None
    coarse = replace(case.ball, cube=2, pieces=tuple(replace(piece, layers=1) for piece in case.ball.pieces))
    # The core sets the scene; a run of two steps is the least that tells it.
    least = Settings(duration=1e-6, interval=1e-6, threads=1)
    hit = strike(club, case.delivery, which=coarse, friction=case.friction, settings=least)
    axes, attitude = hit.axes, hit.attitude
    turn = _turn(club.loft)
    lever = turn.T @ np.asarray(club.cg)
    delivery = {
        key: units.parse(case.delivery.get(key, 0.0), DIMENSIONS[key])
        for key in ("toe", "high", "closure", "pitch_rate", "lie_rate")
    }
    point, _ = face_point(club, delivery["toe"], delivery["high"])
    world_spin = np.array([-delivery["lie_rate"], delivery["closure"], delivery["pitch_rate"]])
    return {
        "axes": axes,
        "point": point,
        "cg": (-axes @ (lever + point)).tolist(),
        "velocity": hit.frame_velocity.tolist(),
        "spin": (axes @ attitude.T @ world_spin).tolist(),
        "inertia": (axes @ turn.T @ np.asarray(club.inertia) @ turn @ axes.T).tolist(),
    }


def face_point(club: Club, toe: float, high: float) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return the point [m] of the face at offsets in the plane tangent at its centre, and its normal, face axes."""
    import numpy as np

    bulge, roll = 1.0 / club.bulge, 1.0 / club.roll
    sine = roll * high
    back = -(roll * high**2) / (math.sqrt(1.0 - sine**2) + 1.0)
    radial = bulge * back + 1.0
    level = math.sqrt(radial**2 - (bulge * toe) ** 2)
    x = (2.0 * back + bulge * (back**2 - toe**2)) / (level + 1.0)
    cosine = math.sqrt(1.0 - sine**2)
    return np.array([x, high, toe]), np.array([cosine * level / radial, sine, cosine * bulge * toe / radial])


def _face_mesh(club: Club) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return nodes [m] of the middle surface of the face's shells, face axes, and quadrangles, numbered from 0."""
    import numpy as np

    across, up = (max(8, round(size / FACE_ELEMENT)) for size in (club.face_width, club.face_height))
    places = []
    for high in np.linspace(-0.5, 0.5, up + 1) * club.face_height:
        for toe in np.linspace(-0.5, 0.5, across + 1) * club.face_width:
            point, normal = face_point(club, float(toe), float(high))
            places.append(point - 0.5 * SHELL * normal)
    first = (np.arange(up)[:, None] * (across + 1) + np.arange(across)).reshape(-1)
    quads = np.stack([first, first + across + 1, first + across + 2, first + 1], axis=1)
    return np.array(places), quads


def _turn(angle: float) -> NDArray[Any]:
    import numpy as np

    sine, cosine = math.sin(angle), math.cos(angle)
    return np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
