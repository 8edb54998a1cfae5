"""Export of a swing's golfer and club as a MuJoCo model with the same bodies."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np

from clubface.chain.flexible import held_length, links_of
from clubface.chain.golfer import Body, GolferBody
from clubface.chain.mechanics import GRAVITY
from clubface.equipment.clubs import Club
from clubface.equipment.shafts import Shaft
from clubface.simulation.beam import beam_axes

__all__ = ["mjcf"]

ARMATURE = 1e-6
"""Armature of each shaft joint [kg m2]: slows the torsional vibration of short links enough for explicit steps, and
changes the inertia of the head by at most 1e-4."""
PLACES = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
"""Rows and columns of the elements of an inertia, in MuJoCo's order."""


def mjcf(golfer: GolferBody, club: Club, shaft: Shaft, *, hands: float, damping: float, links: int) -> str:
    """Return a golfer with a club as MuJoCo XML; the shaft bends and twists in ``links`` pieces, or is rigid if 0.

    In the zero pose all bodies have world axes. The golfer's joints come first.
    """
    pieces = links_of(shaft, hands, max(links, 1))
    down = -np.array(shaft.axis)
    length = held_length(shaft, hands)
    head = length * down - np.array(shaft.hosel) - np.array(club.cg)
    # Damping of short links is too stiff for explicit steps; without damping, fourth-order steps are more accurate.
    integrator = "implicitfast" if links and damping else "RK4"
    lines = [
        f"<mujoco model={quoteattr(golfer.segments[-1].name)}>",
        f'  <option gravity="0 {-GRAVITY} 0" integrator="{integrator}" timestep="5e-05"/>',
        '  <compiler angle="radian" inertiafromgeom="false" autolimits="true"/>',
        "  <worldbody>",
    ]
    origin = np.zeros(3)
    depth = 0

    def open_body(name: str, place: Any, body: Body, *joints: str) -> None:
        nonlocal origin, depth
        lines.append(f'{"  " * (depth + 2)}<body name={quoteattr(name)} pos="{_numbers(place - origin)}">')
        mass, cg, inertia = body
        inertial = (
            f'<inertial mass="{float(mass)!r}" pos="{_numbers(cg - place)}"'
            f' fullinertia="{_numbers(inertia[i][j] for i, j in PLACES)}"/>'
        )
        lines.extend("  " * (depth + 3) + each for each in (*joints, *([inertial] if mass > 0.0 else [])))
        origin, depth = place, depth + 1

    for each in golfer.segments:
        joint = f'<joint name={quoteattr(each.name)} axis="{_numbers(each.axis)}"/>'
        open_body(each.name, each.joint, (each.mass, each.cg, each.inertia), joint)
    open_body("grip", np.zeros(3), pieces.grip)
    at = length - pieces.joint
    bending, torsion = (
        np.interp(at, shaft.position, each) * max(links, 1) / length
        for each in (shaft.bending_stiffness, shaft.torsional_stiffness)
    )
    along, one, other = beam_axes(np.array(shaft.axis))
    for link, place in enumerate(pieces.joint):
        springs = ((one, bending[link]), (other, bending[link]), (along, torsion[link]))
        joints = [
            f'<joint axis="{_numbers(axis)}" stiffness="{stiffness!r}" damping="{damping * stiffness!r}"'
            f' armature="{ARMATURE}"/>'
            for axis, stiffness in ((axis, float(stiffness)) for axis, stiffness in springs)
        ]
        open_body(f"shaft{link}", place * down, pieces.bodies[link], *(joints if links else ()))
    open_body("head", head, (club.mass, head, np.array(club.inertia)))
    lines.extend("  " * (each + 2) + "</body>" for each in reversed(range(depth)))
    lines += ["  </worldbody>", "</mujoco>", ""]
    return "\n".join(lines)


def _numbers(values: Iterable[float]) -> str:
    return " ".join(repr(float(each)) for each in values)
