"""What a shaft adds to the inertia of a head at impact, as a function of its stiffness, with exact derivatives."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from clubface.equipment.attachment import CONTACT_TIME, added_inputs, spatial_inertia
from clubface.equipment.clubs import Club
from clubface.equipment.shafts import Shaft
from clubface.simulation.beam import head_on_beam, natural_modes

__all__ = ["attached_inputs"]


def attached_inputs(club: Club, shaft: Shaft) -> Callable[[Any, Any], dict[str, Any]]:
    """Return the inputs of an impact that a shaft adds, as a function of its stiffness.

    The function takes bending and torsional stiffness of each station [N m2] and returns what
    :meth:`clubface.Shaft.added_inertia` gives for a shaft with these. If they are arrays of JAX, it has first
    derivatives: those of a function of a symmetric matrix, by divided differences of its eigenvalues (Yu. L. Daleckii
    and S. G. Krein, 1965), which also holds where eigenvalues coincide, as those of the free motions do.
    """
    names = tuple(added_inputs(((1.0,) * 6,) * 6))
    size = len(shaft.position)

    def values(stiffness: Any) -> Any:
        return np.array(list(added_inputs(_stiffened(shaft, np.asarray(stiffness)).added_inertia(club)).values()))

    def values_and_jacobian(stiffness: Any) -> tuple[Any, Any]:
        given = np.asarray(stiffness)
        derivatives = _derivatives(club, _stiffened(shaft, given))
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


def _stiffened(shaft: Shaft, stiffness: Any) -> Shaft:
    """Return a shaft with another stiffness; EA follows EI unless it was given."""
    bending, torsional = np.split(stiffness, 2)
    return shaft.replace(bending_stiffness=bending.tolist(), torsional_stiffness=torsional.tolist())


def _share(squares: Any) -> tuple[Any, Any]:
    """Return the share of a mode in the motion, as :meth:`clubface.simulation.beam.Modes.mobility`, and its slope.

    Both are functions of the square of the angular frequency, s = cos(pi r / 2)^2 / (1 - r^2) with r = w T / pi.
    """
    scale = (CONTACT_TIME / np.pi) ** 2
    ratio = np.sqrt(scale * squares)
    resonant = np.abs(ratio - 1.0) < 1e-4
    over = np.where(resonant, 1.0, 1.0 - ratio**2)
    pulse = np.cos(0.5 * np.pi * ratio) ** 2
    slope = pulse / over**2 - 0.25 * np.pi**2 * np.sinc(ratio) / over
    return np.where(resonant, 0.0, pulse / over), scale * np.where(resonant, -(np.pi**2) / 16.0, slope)


def _derivatives(club: Club, shaft: Shaft) -> Any:
    """Return derivatives of the added inertia by bending, then torsional stiffness of each station, (2 n, 6, 6)."""
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
