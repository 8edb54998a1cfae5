"""A shaft between hands and head, reduced to a few shape functions of its curvature, and its effect at impact.

The shaft is divided into links, joined in the middle of each section by rotations that are linear in a few coordinates:
the change of direction over the section in a few shapes of the clamped beam with its head. The rotations of the links
are composed without approximation, so stretch, shortening by bending and stiffening by the pull of the head need no
extra terms (assumed strains: F. Renda and others, IEEE Robotics and Automation Letters 5, 4006-4013, 2020). The elastic
energy is linear in the stiffness at each station.

At impact the shaft's stiffness adds to the inertia of the head, with exact derivatives.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from clubface.chain.golfer import Body, combined
from clubface.equipment.attachment import CONTACT_TIME, added_inputs, spatial_inertia
from clubface.equipment.clubs import Club
from clubface.equipment.shafts import Shaft
from clubface.errors import InputError
from clubface.simulation.beam import Beam, beam_axes, head_on_beam, natural_modes

__all__ = ["FlexibleShaft", "attached_inputs", "flexible_shaft", "links_of"]

STATIC_SHAPES = 5
POINTS = 50
"""Number of integration points for the mass of a link."""


class FlexibleShaft(NamedTuple):
    """Bending and twisting of the links from the hands to the tip, about the reference pose."""

    # Rotation of each link relative to the one before, per unit of each coordinate, in the axes of the reference pose
    # [rad], shape (modes, links, 3).
    turn: Any
    bending: Any  # stiffness matrices of the coordinates per unit of EI at each station, shape (stations, modes, modes)
    torsion: Any  # the same per unit of GJ
    frequency: Any  # natural angular frequencies of the modes with the hands held fixed [rad/s], shape (modes,)


class Links(NamedTuple):
    """Links of a shaft: rigid pieces between the joints at which it bends, in the axes of the reference pose."""

    joint: Any  # distance of the joints from the hands [m], shape (links,); the piece before the first is not a link
    bodies: list[Body]
    grip: Body  # everything that is held: the piece before the first joint, the shaft above the hands, the grip


def held_length(shaft: Shaft, hands: float) -> float:
    """Return the length from the tip to the middle of the hands, which are ``hands`` below the butt [m]."""
    length = shaft.length - hands
    if not 0.0 < length <= shaft.length:
        raise InputError("hands", hands, f"from 0 to less than {shaft.length:g} m, the length of the shaft")
    return length


def links_of(shaft: Shaft, hands: float, count: int) -> Links:
    """Return the rigid pieces of a shaft with joints in the middle of ``count`` equal sections."""
    length, down = held_length(shaft, hands), -np.array(shaft.axis)
    joint = (np.arange(count) + 0.5) * length / count
    edges = np.append(joint, length)
    bodies = [_piece(shaft, length, low, high) for low, high in pairwise(edges)]
    grip = (shaft.grip_mass, -hands * down, np.zeros((3, 3)))
    return Links(joint, bodies, combined(_piece(shaft, length, -hands, edges[0]), grip))


def _piece(shaft: Shaft, length: float, low: float, high: float) -> Body:
    """Return the part of the shaft between two distances from the hands."""
    points, weights = np.polynomial.legendre.leggauss(POINTS)
    at = low + 0.5 * (high - low) * (points + 1.0)
    from_tip = length - at
    density = np.interp(from_tip, shaft.position, shaft.mass_per_length) * 0.5 * (high - low) * weights
    gyration = np.interp(from_tip, shaft.position, shaft.diameter) ** 2 / 8.0
    mass = float(density.sum())
    cg = float(density @ at) / mass
    onto = np.outer(shaft.axis, shaft.axis)
    inertia = density @ ((at - cg) ** 2 + gyration) * (np.eye(3) - onto) + 2.0 * density @ gyration * onto
    return mass, -cg * np.array(shaft.axis), inertia


def _held_beam(shaft: Shaft, hands: float, **properties: Any) -> Beam:
    """Return the beam from the tip to the hands, where it is clamped; ``properties`` replace values at the stations."""
    length = held_length(shaft, hands)
    whole = replace(shaft.beam(), **properties)
    stations = np.append(whole.position[whole.position < length], length)
    cut = {
        name: np.interp(stations, whole.position, getattr(whole, name))
        for name in ("mass", "bending", "torsion", "axial", "gyration")
    }
    return Beam(stations, **cut, grip="clamped")


def flexible_shaft(shaft: Shaft, club: Club, hands: float, links: int, modes: int) -> FlexibleShaft:
    """Reduce the shaft of a club, clamped at the hands, to a few shapes."""
    inertia = np.array(spatial_inertia(club.mass, club.inertia))
    tip, axis = np.array(club.cg) + np.array(shaft.hosel), np.array(shaft.axis)
    beam = _held_beam(shaft, hands)
    elastic, mass = head_on_beam(beam, inertia, tip, axis)
    turn = beam_axes(axis)
    squares, chosen = _shapes(elastic, mass, tip, turn, modes)
    length = held_length(shaft, hands)
    nodes = beam.nodes(60)
    # Rotations of the head, of the nodes along the beam, and none at the hands, all in the head's axes.
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

    turn = np.diff(sampled, axis=-1).transpose(0, 2, 1)
    return FlexibleShaft(turn, stiffness("bending"), stiffness("torsion"), np.sqrt(squares))


def _shapes(elastic: Any, mass: Any, tip: Any, turn: Any, count: int) -> tuple[Any, Any]:
    """Return squared angular frequencies, ascending, and shapes of unit modal mass, combined from two kinds.

    The first are static shapes for forces across the tip and moments at it, which alone reproduce exactly how the
    shaft bends and twists under the pull of the head. Natural modes are added for vibrations.
    """
    across = [np.concatenate([each, np.cross(tip, each)]) for each in turn[1:]]
    moments = [np.concatenate([np.zeros(3), each]) for each in turn]
    loads = np.zeros((len(mass), STATIC_SHAPES))
    loads[:6] = np.transpose([*across, *moments])
    static = np.linalg.solve(elastic, loads)
    natural = natural_modes(elastic, mass)[1][:, : max(0, count - STATIC_SHAPES)]
    static /= np.sqrt(np.einsum("im,ij,jm->m", static, mass, static))
    basis = np.linalg.qr(np.concatenate([static, natural], axis=1))[0]
    squares, mixed = natural_modes(basis.T @ elastic @ basis, basis.T @ mass @ basis)
    return squares[:count], basis @ mixed[:, :count]


def attached_inputs(club: Club, shaft: Shaft) -> Callable[[Any, Any], dict[str, Any]]:
    """Return a function from a shaft's stiffness to the inputs that the shaft adds to an impact.

    The function takes bending and torsional stiffness at each station [N m2] and returns the result of
    :meth:`clubface.Shaft.added_inertia` for a shaft with these values. For JAX arrays it has first derivatives: those
    of a function of a symmetric matrix, by divided differences of its eigenvalues (Yu. L. Daleckii and S. G. Krein,
    1965), which also hold for coincident eigenvalues, such as those of the free motions.
    """
    names = tuple(added_inputs(((1.0,) * 6,) * 6))
    size = len(shaft.position)

    def values(stiffness: Any) -> Any:
        return np.array(list(added_inputs(_with_stiffness(shaft, np.asarray(stiffness)).added_inertia(club)).values()))

    def values_and_jacobian(stiffness: Any) -> tuple[Any, Any]:
        given = np.asarray(stiffness)
        derivatives = _derivatives(club, _with_stiffness(shaft, given))
        rows = [list(added_inputs(tuple(map(tuple, each))).values()) for each in derivatives]
        return values(given), np.transpose(rows)

    @jax.custom_jvp
    def added(stiffness: Any) -> Any:
        shape = jax.ShapeDtypeStruct((len(names),), stiffness.dtype)
        return jax.pure_callback(values, shape, stiffness, vmap_method="sequential")

    @added.defjvp
    def derivative(primals: Any, tangents: Any) -> Any:
        (stiffness,), (change,) = primals, tangents
        shapes = (
            jax.ShapeDtypeStruct((len(names),), stiffness.dtype),
            jax.ShapeDtypeStruct((len(names), 2 * size), stiffness.dtype),
        )
        result, jacobian = jax.pure_callback(values_and_jacobian, shapes, stiffness, vmap_method="sequential")
        return result, jacobian @ change

    def inputs(bending: Any, torsional: Any) -> dict[str, Any]:
        result = added(jnp.concatenate([bending, torsional]))
        return {name: result[place] for place, name in enumerate(names)}

    return inputs


def _with_stiffness(shaft: Shaft, stiffness: Any) -> Shaft:
    """Return the shaft with other stiffness; EA follows EI unless it was given."""
    bending, torsional = np.split(stiffness, 2)
    return shaft.replace(bending_stiffness=bending.tolist(), torsional_stiffness=torsional.tolist())


def _share(squares: Any) -> tuple[Any, Any]:
    """Return a mode's share of the motion, as in :meth:`clubface.simulation.beam.Modes.mobility`, and its derivative.

    Both are functions of the squared angular frequency: s = cos(pi r / 2)^2 / (1 - r^2) with r = w T / pi.
    """
    scale = (CONTACT_TIME / np.pi) ** 2
    ratio = np.sqrt(scale * squares)
    resonant = np.abs(ratio - 1.0) < 1e-4
    over = np.where(resonant, 1.0, 1.0 - ratio**2)
    pulse = np.cos(0.5 * np.pi * ratio) ** 2
    slope = pulse / over**2 - 0.25 * np.pi**2 * np.sinc(ratio) / over
    return np.where(resonant, 0.0, pulse / over), scale * np.where(resonant, -(np.pi**2) / 16.0, slope)


def _derivatives(club: Club, shaft: Shaft) -> Any:
    """Return derivatives of the added inertia by bending, then torsional stiffness at each station, (2 n, 6, 6)."""
    head = np.array(spatial_inertia(club.mass, club.inertia))
    tip, axis = np.array(club.cg) + np.array(shaft.hosel), np.array(shaft.axis)
    beam = shaft.beam()
    stiffness, mass = head_on_beam(beam, head, tip, axis)
    squares, shapes = natural_modes(stiffness, mass)
    share, slopes = _share(np.maximum(squares, 0.0))
    apart = squares[:, None] - squares[None, :]
    near = np.abs(apart) < 1e-6 * (squares[:, None] + squares[None, :] + 1.0)
    differences = np.where(
        near, 0.5 * (slopes[:, None] + slopes[None, :]), (share[:, None] - share[None, :]) / np.where(near, 1.0, apart)
    )
    mobility = (shapes[:6] * share) @ shapes[:6].T
    inverse = np.linalg.inv(mobility)
    none = np.zeros(len(shaft.position))
    result = []
    for name in ("bending", "torsion"):
        for unit in np.eye(len(none)):
            changed = {"bending": none, "torsion": none, "axial": none, name: unit}
            if name == "bending" and not shaft.axial_stiffness:
                changed["axial"] = unit * beam.axial / beam.bending
            by_station, _ = head_on_beam(replace(beam, **changed, grip_stiffness=0.0), head, tip, axis)
            change = shapes[:6] @ (differences * (shapes.T @ by_station @ shapes)) @ shapes[:6].T
            result.append(-inverse @ change @ inverse)
    return np.array(result)
