"""A shaft between hands and head, reduced to a few shapes of its curvature.

The shaft is cut into links, joined in the middle of each section by rotations that are linear in a few coordinates: the
change of direction over the section in a few shapes of the clamped beam with its head. Rotations of links
follow one another, whatever their size, so that stretch, shortening by bending and stiffening by the pull of the head
need no terms of their own (assumed strains: F. Renda and others, IEEE Robotics and Automation Letters 5, 4006-4013,
2020). The elastic energy is linear in the stiffness of each station.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from clubface.equipment.attachment import spatial_inertia
from clubface.equipment.clubs import Club
from clubface.equipment.shafts import Shaft
from clubface.errors import InputError
from clubface.simulation.beam import Beam, beam_axes, head_on_beam, natural_modes

__all__ = ["FlexibleShaft", "flexible_shaft", "links_of"]

STATIC_SHAPES = 5
POINTS = 50
"""Points by which the mass of a link is integrated."""


class FlexibleShaft(NamedTuple):
    """Links from the hands to the tip, in the reference pose, and how they bend.

    Attributes
    ----------
    turn
        Rotation of each link against the one before, by coordinate, in the axes of the reference pose [rad],
        shape (modes, links, 3).
    bending, torsion
        Elastic stiffness of the coordinates by the stiffness EI and GJ of each station, shape (stations, modes, modes).
    frequency
        Natural angular frequencies of the modes with the hands held still [rad/s], shape (modes,).
    """

    turn: Any
    bending: Any
    torsion: Any
    frequency: Any


class Links(NamedTuple):
    """The links of a shaft: rigid pieces between places at which it bends.

    Attributes
    ----------
    joint
        Distance of the places from the hands [m], shape (links,); the first piece, before them, is not a link.
    mass, cg, inertia
        Of each link [kg]; distance of its CG from the hands [m]; about its CG, across it and along it [kg m2], shape
        (links, 2).
    grip_mass, grip_cg, grip_inertia
        The same of all that is held: the piece below the first place, the shaft above the hands, and the grip.
    """

    joint: Any
    mass: Any
    cg: Any
    inertia: Any
    grip_mass: float
    grip_cg: float
    grip_inertia: Any


def held_length(shaft: Shaft, hands: float) -> float:
    """Return the length of a shaft from its tip to the middle of the hands, which hold it ``hands`` below the butt."""
    length = shaft.length - hands
    if not 0.0 < length <= shaft.length:
        raise InputError("hands", hands, f"from 0 to less than {shaft.length:g} m, the length of the shaft")
    return length


def links_of(shaft: Shaft, hands: float, count: int) -> Links:
    """Return the rigid pieces of a shaft that bends in the middle of each of ``count`` equal sections."""
    length = held_length(shaft, hands)
    joint = (np.arange(count) + 0.5) * length / count
    edges = np.append(joint, length)
    pieces = [_piece(shaft, length, low, high) for low, high in pairwise(edges)]
    mass, cg, inertia = (np.array(each) for each in zip(*pieces, strict=True))
    own = _piece(shaft, length, -hands, edges[0])
    grip = (shaft.grip_mass, -hands, np.zeros(2))
    total = own[0] + grip[0]
    centre = (own[0] * own[1] + grip[0] * grip[1]) / total
    across = sum(each[0] * (each[1] - centre) ** 2 for each in (own, grip))
    return Links(joint, mass, cg, inertia, total, centre, own[2] + np.array([across, 0.0]))


def _piece(shaft: Shaft, length: float, low: float, high: float) -> tuple[float, float, Any]:
    """Return mass, CG and inertia across and along the shaft of what lies between two distances from the hands."""
    points, weights = np.polynomial.legendre.leggauss(POINTS)
    at = low + 0.5 * (high - low) * (points + 1.0)
    from_tip = length - at
    density = np.interp(from_tip, shaft.position, shaft.mass_per_length) * 0.5 * (high - low) * weights
    gyration = np.interp(from_tip, shaft.position, shaft.diameter) ** 2 / 8.0
    mass = float(density.sum())
    cg = float(density @ at) / mass
    return mass, cg, np.array([density @ ((at - cg) ** 2 + gyration), 2.0 * density @ gyration])


def _held_beam(shaft: Shaft, hands: float, **properties: Any) -> Beam:
    """Return the beam from the tip to the hands, clamped there, with some properties by station in their place."""
    length = held_length(shaft, hands)
    whole = replace(shaft.beam(), **properties)
    stations = np.append(whole.position[whole.position < length], length)
    cut = {
        name: np.interp(stations, whole.position, getattr(whole, name))
        for name in ("mass", "bending", "torsion", "axial", "gyration")
    }
    return Beam(stations, **cut, grip="clamped")


def flexible_shaft(shaft: Shaft, club: Club, hands: float, links: int, modes: int) -> FlexibleShaft:
    """Return the shaft of a club reduced to a few shapes, clamped in the hands."""
    inertia = np.array(spatial_inertia(club.mass, club.inertia))
    tip, axis = np.array(club.cg) + np.array(shaft.hosel), np.array(shaft.axis)
    beam = _held_beam(shaft, hands)
    elastic, mass = head_on_beam(beam, inertia, tip, axis)
    turn = beam_axes(axis)
    squares, chosen = _shapes(elastic, mass, tip, turn, modes)
    length = held_length(shaft, hands)
    nodes = beam.nodes(60)
    # Rotations of the head, then of the nodes along the beam, and none in the hands; all in the axes of the head.
    rotations = np.concatenate([
        chosen[None, 3:6],
        np.einsum("ji,njm->nim", turn, chosen[6:].reshape(len(nodes) - 2, 6, modes)[:, 3:]),
        np.zeros((1, 3, modes)),
    ])  # fmt: skip
    edges = length * (1.0 - np.arange(links + 1) / links)
    sampled = np.array([
        [np.interp(edges, nodes, rotations[:, axis, mode]) for axis in range(3)] for mode in range(modes)
    ]).reshape(modes, 3, links + 1)  # fmt: skip
    none = np.zeros(len(shaft.position))

    def stiffness(name: str) -> Any:
        result = []
        for station in range(len(none)):
            unit: dict[str, Any] = dict.fromkeys(("bending", "torsion", "axial"), none)
            unit[name] = np.eye(len(none))[station]
            elastic = head_on_beam(_held_beam(shaft, hands, **unit), inertia, tip, axis)[0]
            result.append(chosen.T @ elastic @ chosen)
        return np.array(result)

    return FlexibleShaft(
        np.diff(sampled, axis=-1).transpose(0, 2, 1),
        stiffness("bending"),
        stiffness("torsion"),
        np.sqrt(squares),
    )


def _shapes(elastic: Any, mass: Any, tip: Any, turn: Any, count: int) -> tuple[Any, Any]:
    """Return squares of angular frequencies, ascending, and shapes of unit modal mass, which combine two kinds.

    First come the static shapes by forces across the tip and moments on it: with these alone the shaft bends and twists
    exactly as the head pulls at it. Natural modes follow, for what vibrates in between.
    """
    across = [np.concatenate([each, np.cross(tip, each)]) for each in turn[1:]]
    moments = [np.concatenate([np.zeros(3), each]) for each in turn]
    loads = np.zeros((len(mass), STATIC_SHAPES))
    loads[:6] = np.transpose([*across, *moments])
    static = np.linalg.solve(elastic, loads)
    natural = natural_modes(elastic, mass)[1][:, : max(0, count - STATIC_SHAPES)]
    basis = np.linalg.qr(np.concatenate([_of_unit_mass(static, mass), natural], axis=1))[0]
    squares, combined = natural_modes(basis.T @ elastic @ basis, basis.T @ mass @ basis)
    return squares[:count], basis @ combined[:, :count]


def _of_unit_mass(shapes: Any, mass: Any) -> Any:
    return shapes / np.sqrt(np.einsum("im,ij,jm->m", shapes, mass, shapes))
