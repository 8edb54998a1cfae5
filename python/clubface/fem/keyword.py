"""Export of a case as an LS-DYNA keyword deck, which OpenRadioss also reads, for comparison with other programs."""

from __future__ import annotations

import math
import os
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import repeat
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import _core as core, units
from clubface.equipment.clubs import Club
from clubface.equipment.face import face_point, nearest, turn_to_sole
from clubface.errors import InputError
from clubface.fem.balls import Ball
from clubface.fem.case import MESHED, PLANE, RIGID, Case
from clubface.fem.heads import MeshedHead, Metal, ShellHead
from clubface.fem.materials import REGISTERED, Material
from clubface.fem.run import strike
from clubface.fem.settings import Settings
from clubface.simulation.inputs import DIMENSIONS
from clubface.support.files import write_text

__all__ = ["write"]

WIDTH = 10
"""Characters in a field, except for nodes and elements."""
LONGEST = 80
"""Maximum characters in a line."""
BALL_SET = 1
"""Number of the part set that holds the ball."""


class Cards:
    """A deck under construction: keywords, comments and cards, in order."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def comment(self, *paragraphs: str) -> None:
        """Add comments, wrapped; an empty one gives a bare line."""
        for text in paragraphs:
            self.lines += [f"$ {line}" for line in textwrap.wrap(ascii_text(text), LONGEST - 2)] or ["$"]

    def keyword(self, name: str, *cards: Sequence[Any], names: str = "") -> None:
        """Add a keyword with its cards; ``names`` label the fields of the first card in a comment."""
        self.lines.append(f"*{name}")
        if names:
            self.lines.append(("$#" + "".join(f"{each:>{WIDTH}}" for each in names.split())[2:])[:LONGEST])
        for card in cards:
            self.card(card)

    def card(self, fields: Sequence[Any]) -> None:
        """Add a line of numeric fields; None leaves a field blank."""
        self.lines.append("".join(field(value) for value in fields).rstrip() or " " * WIDTH)

    def titled(self, name: str, title: str, *cards: Sequence[Any]) -> None:
        """Add a keyword with a title and its cards."""
        self.lines += [f"*{name}", ascii_text(title)[:LONGEST]]
        for card in cards:
            self.card(card)

    def nodes(self, places: Any, first: int = 1) -> None:
        """Add nodes (n, 3), numbered from ``first``: I8, then three coordinates of 16 characters."""
        self.keyword("NODE")
        for number, place in enumerate(places.tolist(), first):
            self.lines.append(eights(number) + "".join(f"{each:16.8e}" for each in place))

    def elements(self, kind: str, parts: Iterable[int], corners: Any, first: int = 1) -> int:
        """Add elements, numbered from ``first``, with the part and nodes (n, k) of each; return the last number."""
        self.keyword(f"ELEMENT_{kind}")
        for number, (part, nodes) in enumerate(zip(parts, corners.tolist(), strict=True), first):
            self.lines.append(eights(number, part, *nodes))
        return first + len(corners) - 1

    def __str__(self) -> str:
        return "\n".join(self.lines) + "\n"


def field(value: float | None, width: int = WIDTH) -> str:
    """Format a number right-aligned in ``width`` characters; floats keep as many digits as fit, at most nine."""
    if value is None:
        return " " * width
    if not math.isfinite(value):
        raise ValueError(f"{value} cannot be written to a deck")
    texts = iter([str(value)]) if isinstance(value, int) else _spellings(value)
    text = next((each for each in texts if len(each) <= width), str(value))
    if len(text) > width:
        raise ValueError(f"{text} does not fit into {width} characters")
    return text.rjust(width)


def _spellings(value: float) -> Iterator[str]:
    """Yield spellings of a float with nine digits and fewer, plain and with an exponent."""
    for digits in range(9, 0, -1):
        text = f"{value:.{digits}g}"
        yield text if "e" in text or "." in text else text + ".0"
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        yield f"{mantissa}e{int(exponent)}"


def ascii_text(text: str) -> str:
    """Return ``text`` in ASCII, which every deck reader accepts."""
    return text.encode("ascii", "replace").decode()


def eights(*numbers: int) -> str:
    """Return integers in fields of eight characters, as in cards of nodes and elements."""
    return "".join(f"{each:8d}" for each in numbers)


MOTION = "id styp omega vx vy vz"
HEAD_PART, HEAD_SECTION, HEAD_HOURGLASS = 101, 2, 2
TEN_NODES = 16
"""LS-DYNA element formulation of ten-node tetrahedra."""
USUAL_POINTS = 5
"""Points through the thickness of a shell, unless its metal sets the number."""
STEEL_DENSITY, STEEL_YOUNGS, STEEL_POISSON = 7850.0, 200e9, 0.3
"""Material of the shells that form the rigid face [kg/m3, Pa]; used for contact stiffness only."""
SHELL = 1e-3
"""Thickness of the rigid face's shells [m]."""
FACE_ELEMENT = 2.5e-3
"""Size of the rigid face's shells [m]."""
OF_DECK = (
    "toe", "high", "closure", "pitch_rate", "lie_rate", "ball_backspin", "ball_sidespin", "ball_riflespin",
)  # fmt: skip
"""Delivery values that determine rotations in the deck; the velocity comes from the core."""


def write_head(deck: Cards, case: Case, nodes: int, elements: int) -> None:
    """Write the head and its contact with the ball, numbered after the ball's ``nodes`` and ``elements``."""
    assert case.club is not None
    club = case.club.club if isinstance(case.club, MeshedHead) else case.club
    touch = _first_touch(case, club)
    if spin := math.hypot(*touch["ball_spin"]):  # rotation of the ball about its centre
        axis = [case.ball.diameter / 2.0, 0.0, 0.0, *(each / spin for each in touch["ball_spin"])]
        deck.keyword("INITIAL_VELOCITY_GENERATION", [BALL_SET, 1, spin, 0.0, 0.0, 0.0], axis, names=MOTION)
    if isinstance(case.club, MeshedHead):
        head, write_elements = case.club, _shells if isinstance(case.club, ShellHead) else _solid
        faces, last = write_elements(deck, head, touch, nodes, elements)
        deck.keyword("ELEMENT_MASS")
        added = [(place, mass) for place, mass in enumerate(head.added.tolist(), start=nodes + 1) if mass]
        deck.lines += [f"{eights(number, place)}{mass:16.8e}" for number, (place, mass) in enumerate(added, last + 1)]
        arms = _places(head, touch) - np.asarray(touch["cg"])
        deck.keyword("INITIAL_VELOCITY_NODE", names="nid vx vy vz vxr vyr vzr")
        velocities = np.asarray(touch["velocity"]) + np.cross(touch["spin"], arms)
        for number, velocity in enumerate(velocities.tolist(), start=nodes + 1):
            deck.card([number, *velocity, *touch["spin"]])
    else:
        _rigid(deck, club, touch, nodes, elements)
        faces = [HEAD_PART]
    deck.comment("Penalty by node mass and time step (SOFT = 1), as in clubface.")
    for part in faces:
        cards = [len(case.ball.pieces), part, 3, 3, 0, 0, 1, 1], [float(case.friction)] * 2, [None], [1]
        deck.keyword("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", *cards)


def _shells(deck: Cards, head: Any, touch: dict[str, Any], nodes: int, elements: int) -> tuple[list[int], int]:
    """Write mesh and parts of a shell head; return the part numbers of its face and the last element number."""
    deck.keyword("HOURGLASS", [HEAD_HOURGLASS, 4, 0.05], names="hgid ihq qm")
    for number, part in enumerate(head.parts):
        section = HEAD_SECTION + number
        _section(deck, section, part.metal)
        _part(deck, HEAD_PART + number, f"{head.name}: {part.name}", part.metal, section, HEAD_HOURGLASS)
    deck.nodes(_places(head, touch), nodes + 1)
    deck.keyword("ELEMENT_SHELL_THICKNESS")
    corners = (head.quads.astype(int) + nodes + 1).tolist()
    walls = zip(head.part_of_elements().tolist(), corners, head.thickness.tolist(), strict=True)
    for number, (part, each, thickness) in enumerate(walls, start=elements + 1):
        deck.lines += [eights(number, HEAD_PART + part, *each), f"{thickness:16.8e}" * 4]
    return [HEAD_PART + number for number, part in enumerate(head.parts) if part.face], elements + len(corners)


def _solid(deck: Cards, head: Any, touch: dict[str, Any], nodes: int, elements: int) -> tuple[list[int], int]:
    """Write mesh, parts and bonds of a solid head; return the part numbers of its face and the last element number."""
    if head.grooves is not None:
        deck.comment("in clubface, grooves act in the contact only; this deck has a plain face")
    blocks = [(part, corners) for part in head.parts for corners in (part.hexahedra, part.tetrahedra) if len(corners)]
    if any(len(part.tetrahedra) for part in head.parts):
        deck.keyword("SECTION_SOLID", [HEAD_SECTION, TEN_NODES], names="secid elform")
    for number, (part, corners) in enumerate(blocks, HEAD_PART):
        # Hexahedra share section and hourglass control with the ball.
        section, hourglass = (1, 1) if corners.shape[1] == 8 else (HEAD_SECTION, 0)
        name = head.name if len(blocks) == 1 else f"{head.name}: {part.name}"
        _part(deck, number, name, part.metal, section, hourglass)
    deck.nodes(_places(head, touch), nodes + 1)
    last, faces = elements, []
    for number, (_, corners) in enumerate(blocks, HEAD_PART):
        rows = corners.astype(int) + nodes + 1
        if corners.shape[1] == 8:
            last = deck.elements("SOLID", repeat(number, len(rows)), rows, last + 1)
        else:
            deck.keyword("ELEMENT_SOLID")
            for own in rows.tolist():
                last += 1
                deck.lines += [eights(last, number), eights(*own)]
        if np.isin(head.face, corners).all(axis=1).any():
            faces.append(number)
    for bond in head.bonds:
        first, second = (
            [place for place, (part, _) in enumerate(blocks, HEAD_PART) if part.name == name]
            for name in (bond.part, bond.to)
        )
        deck.comment(f"bond of {bond.part} to {bond.to}: surfaces within {units.show(bond.within, 'mm')}")
        for one in first:
            for other in second:
                cards = [one, other, 3, 3], [None], [None, None, -bond.within, -bond.within]
                deck.keyword("CONTACT_TIED_SURFACE_TO_SURFACE", *cards)
    return faces, last


def _section(deck: Cards, number: int, metal: Metal) -> None:
    """Write the section of a shell part, with integration points as its metal needs; elastic shells can use any."""
    count, rule = metal.points or USUAL_POINTS, 0
    if metal.points is not None or (metal.yield_stress is not None and metal.rule != "gauss"):
        deck.keyword("INTEGRATION_SHELL", [number, count, 0], names="irid nip esop")
        for place, weight in core.fem_thickness_points(count, metal.rule):
            deck.card([place, 0.5 * weight])
        rule = -number
    names = "secid elform shrf nip propt qr"
    deck.keyword("SECTION_SHELL", [number, 2, 5.0 / 6.0, count, 0, rule], [1e-3] * 4, names=names)


def _part(deck: Cards, number: int, title: str, metal: Metal, section: int, hourglass: int) -> None:
    deck.titled("PART", title, [number, section, number, 0, hourglass])
    elastic = [number, metal.density, metal.youngs, metal.poisson]
    if metal.yield_stress is None:
        deck.keyword("MAT_ELASTIC", elastic, names="mid ro e pr")
        return
    # The load curve below replaces the tangent modulus.
    deck.keyword("MAT_PIECEWISE_LINEAR_PLASTICITY", [*elastic, metal.yield_stress], [None], names="mid ro e pr sigy")
    for each in zip(*metal.curve(), strict=True):  # strains, then stresses
        deck.card(each)


def _places(head: Any, touch: dict[str, Any]) -> NDArray[Any]:
    """Return the nodes of a head [m] in the deck's axes."""
    return (head.nodes @ turn_to_sole(head.loft) - touch["point"]) @ np.asarray(touch["axes"]).T


def _rigid(deck: Cards, club: Club, touch: dict[str, Any], nodes: int, elements: int) -> None:
    """Write a rigid head: a mesh of its face for contact, and mass, inertia and motion as numbers."""
    if club.characteristic_time:
        deck.comment("in clubface, the face of this club gives like a spring; this deck has a rigid face")
    inertia = [touch["inertia"][i][j] for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))]
    cards = [HEAD_PART, HEAD_SECTION, HEAD_PART], [*touch["cg"], club.mass, 0], inertia
    deck.titled("PART_INERTIA", f"{club.name}: rigid", *cards, [*touch["velocity"], *touch["spin"]])
    deck.keyword(
        "MAT_RIGID", [HEAD_PART, STEEL_DENSITY, STEEL_YOUNGS, STEEL_POISSON], [0.0], [None], names="mid ro e pr"
    )
    deck.keyword("SECTION_SHELL", [HEAD_SECTION, 2], [SHELL] * 4, names="secid elform")
    deck.comment("The shells lie half their thickness behind the face, so that contact occurs on the face itself.")
    places, quads = _face_mesh(club)
    deck.nodes((places - touch["point"]) @ np.asarray(touch["axes"]).T, nodes + 1)
    deck.elements("SHELL", repeat(HEAD_PART, len(quads)), quads + nodes + 1, elements + 1)


def _first_touch(case: Case, club: Club) -> dict[str, Any]:
    """Return the head at first touch in deck axes, and these ``axes`` and their ``point`` in face axes."""
    coarse = replace(case.ball, cube=2, pieces=tuple(replace(piece, layers=1) for piece in case.ball.pieces))
    # The core positions ball and head; the shortest possible run returns this.
    least = Settings(duration=1e-6, interval=1e-6, threads=1)
    touch = strike(club, case.delivery, ball=coarse, friction=case.friction, settings=least)
    axes, attitude = touch.axes, touch.attitude
    turn = turn_to_sole(club.loft)
    lever = turn.T @ np.asarray(club.cg)
    delivery = {key: units.parse(case.delivery.get(key, 0.0), DIMENSIONS[key]) for key in OF_DECK}
    point = face_point(delivery["toe"], delivery["high"], club.bulge, club.roll)
    world_spin = np.array([-delivery["lie_rate"], delivery["closure"], delivery["pitch_rate"]])
    mirror = np.array([club.hand, club.hand, 1.0])
    ball_spin = mirror * [delivery["ball_riflespin"], -delivery["ball_sidespin"], delivery["ball_backspin"]]
    return {
        "axes": axes,
        "point": point,
        "cg": (-axes @ (lever + point)).tolist(),
        "velocity": touch.frame_velocity.tolist(),
        "spin": (axes @ attitude.T @ world_spin).tolist(),
        "ball_spin": (axes @ attitude.T @ ball_spin).tolist(),
        "inertia": (axes @ turn.T @ np.asarray(club.inertia) @ turn @ axes.T).tolist(),
    }


def _face_mesh(club: Club) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return nodes [m] of the face shells' middle surface, in face axes, and quadrilaterals numbered from 0."""
    across, up = (max(8, round(size / FACE_ELEMENT)) for size in (club.face_width, club.face_height))
    toes, highs = (np.linspace(-0.5, 0.5, count + 1) for count in (across, up))
    points = face_point(toes * club.face_width, highs[:, None] * club.face_height, club.bulge, club.roll).reshape(-1, 3)
    first = (np.arange(up)[:, None] * (across + 1) + np.arange(across)).reshape(-1)
    quads = np.stack([first, first + across + 1, first + across + 2, first + 1], axis=1)
    return points - 0.5 * SHELL * nearest(points, club.bulge, club.roll)[1], quads


USUAL_SAFETY = 0.9
"""Time step over the stable one if the case leaves it open: the usual value in other codes."""

HEADER = (
    "Units: kg, m, s (N, Pa, J). Axes: x along the face normal at the point of first touch, y up the face, z to "
    "the toe; the origin is that point. A left-handed club appears as its mirror image.",
    "",
    "Differences from clubface:",
    "- Solids have one point and assumed-strain hourglass control (type 6), close to clubface's but not identical.",
    "- Plastics are linear in logarithmic strain in clubface, hypoelastic here: similar up to about 10% strain.",
    "- Rubber: *MAT_HYPERELASTIC_RUBBER has the same energy as clubface; *MAT_OGDEN_RUBBER differs in the volumetric "
    "term, K (J - 1 - ln J); *MAT_MOONEY-RIVLIN_RUBBER uses invariants that include the change of volume, and another "
    "volumetric term; for nearly incompressible rubber the difference is small.",
    "- Viscous branches relax the stress of the elastic law in clubface, a stress linear in strain here: similar at "
    "moderate strain.",
    "- In clubface, friction sticks through tangential springs; a rigid wall has none.",
    "- Shells in clubface have one point in their plane and physical hourglass stiffness; type 2 is close.",
    "- Bulk viscosity is linear, and nearly switched off unless the case gives a value; contact uses penalties.",
)


def write(case: Case, path: str | os.PathLike[str]) -> Path:
    """Write a case, with the same meshes as in clubface, as a keyword deck; return the file.

    The name of the file conventionally ends in ``.k``. Raises InputError if the case cannot be run, for example because
    the head moves away from the ball.
    """
    deck = Cards()
    deck.lines.append("*KEYWORD")
    deck.comment(f"clubface: {case.name}. {case.description}", *HEADER)
    delivered = ", ".join(f"{key} {value}" for key, value in case.delivery.items())
    deck.titled("TITLE", f"{case.name}: ball {case.ball.name}, {case.head}, {delivered}")
    _control(deck, case.settings, case.head)
    _ball(deck, case.ball)
    if case.head == PLANE:
        _plane(deck, case)
    else:
        write_head(deck, case, len(case.ball.mesh["nodes"]), case.ball.elements)
    deck.lines.append("*END")
    return write_text(path, str(deck), encoding="ascii")


def _control(deck: Cards, how: Settings, head: str) -> None:
    deck.keyword("CONTROL_TERMINATION", [how.duration], names="endtim")
    deck.keyword("CONTROL_TIMESTEP", [0.0, how.safety or USUAL_SAFETY], names="dtinit tssfac")
    deck.keyword("CONTROL_ENERGY", [2, 2, 2, 2], names="hgen rwen slnten rylen")
    # Zero would select the default.
    deck.keyword("CONTROL_BULK_VISCOSITY", [1e-6, max(how.bulk_viscosity, 1e-6), 1], names="q1 q2 type")
    head_outputs = {PLANE: ("RWFORC",), RIGID: ("RCFORC", "RBDOUT"), MESHED: ("RCFORC",)}[head]
    for name in ("GLSTAT", "MATSUM", *head_outputs):
        deck.keyword(f"DATABASE_{name}", [how.interval], names="dt")
    deck.keyword("DATABASE_BINARY_D3PLOT", [how.duration / max(how.frames - 1, 50)], names="dt")


def _ball(deck: Cards, ball: Ball) -> None:
    """Write nodes, elements, parts and materials of the ball, which just touches the plane x = 0."""
    mesh = ball.mesh
    deck.keyword("SECTION_SOLID", [1, 1], names="secid elform")
    deck.keyword("HOURGLASS", [1, 6, 1.0], names="hgid ihq qm")
    for number, piece in enumerate(ball.pieces, start=1):
        deck.titled("PART", f"{ball.name}: {piece.name}", [number, 1, number, 0, 1])
        _material(deck, number, piece.material, float(mesh["density"][number - 1]))
    deck.keyword("SET_PART_LIST", [BALL_SET], list(range(1, len(ball.pieces) + 1)), names="sid")
    deck.nodes(mesh["nodes"] + [ball.diameter / 2.0, 0.0, 0.0])
    deck.elements("SOLID", (mesh["piece"].astype(int) + 1).tolist(), mesh["elements"].astype(int) + 1)


def _material(deck: Cards, number: int, material: Material, density: float) -> None:
    """Write a material on the card that fits its law and, if it has any, its viscoelastic branches."""
    branches, constants, shear = material.maxwell, material.constants, material.shear
    prony = [[branch.modulus * shear, 1.0 / branch.time] for branch in branches]
    start, rubber = [number, density, material.poisson], [number, density, material.poisson, 0, len(branches)]
    if material.volumetric is not None:
        raise InputError("volumetric", material.volumetric, "left out; LS-DYNA has its own volumetric terms")
    if material.energy is not None or material.law in REGISTERED:
        name = "law" if material.energy is None else "energy"
        raise InputError(name, getattr(material, name), "a law with an LS-DYNA card, such as ogden")
    if material.law == "ogden":
        terms = [[value for name, value in constants.items() if name.startswith(kind)] for kind in ("mu", "alpha")]
        deck.keyword("MAT_OGDEN_RUBBER", rubber, *terms, names="mid ro pr n nv")
    elif material.law == "neo-hookean":
        deck.keyword("MAT_HYPERELASTIC_RUBBER", rubber, [0.5 * constants["shear"], 0.0], names="mid ro pr n nv")
    elif material.law == "mooney-rivlin" and not branches:
        deck.keyword("MAT_MOONEY-RIVLIN_RUBBER", [*start, constants["c10"], constants["c01"]], [None],
                     names="mid ro pr a b")  # fmt: skip
    elif material.law == "mooney-rivlin":
        deck.keyword("MAT_HYPERELASTIC_RUBBER", rubber, [constants["c10"], constants["c01"]], names="mid ro pr n nv")
    elif not branches:
        deck.keyword("MAT_ELASTIC", [number, density, material.youngs, material.poisson], names="mid ro e pr")
    elif len(branches) == 1:
        fast = shear * (1.0 + branches[0].modulus)
        deck.keyword("MAT_VISCOELASTIC", [number, density, material.bulk, fast, shear, prony.pop()[1]],
                     names="mid ro bulk g0 gi beta")  # fmt: skip
    else:
        deck.keyword("MAT_GENERAL_VISCOELASTIC", [number, density, material.bulk], [None], [shear, 0.0],
                     names="mid ro bulk")  # fmt: skip
    if prony:
        deck.comment("      Gi     BETAi: relative moduli of clubface times its shear modulus, 1 / relaxation time")
        for each in prony:
            deck.card(each)


def _plane(deck: Cards, case: Case) -> None:
    speed = units.parse(case.delivery["speed"], "speed")
    angle = units.parse(case.delivery.get("angle", 0.0), "angle")
    velocity = [-speed * math.cos(angle), speed * math.sin(angle), 0.0]
    deck.keyword("INITIAL_VELOCITY_GENERATION", [BALL_SET, 1, 0.0, *velocity], [None], names=MOTION)
    if case.friction >= 1.0:
        deck.comment(f"Friction is {case.friction:g}; a rigid wall treats 1 or more as unlimited sticking.")
    deck.keyword("RIGIDWALL_PLANAR", [0], [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, min(float(case.friction), 1.0)], names="nsid")
