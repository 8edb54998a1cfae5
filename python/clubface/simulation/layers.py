"""The spins of cover and core of a two-layer ball, which a history keeps as one: all angular momentum over inertia."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from clubface.errors import InputError
from clubface.simulation.history import History
from clubface.support.arrays import Floats

LAYERED = ("cover_thickness", "layer_stiffness", "layer_damping")
"""The parameters of a model whose ball has two layers."""


class LayerSpins(NamedTuple):
    """Angular velocities in world axes over the steps of a history [rad/s], and at take-off.

    Attributes
    ----------
    cover, core
        Shape (n, 3).
    cover_at_take_off, core_at_take_off
        When the contact ends, which is within the last step of the history; shape (3,).
    """

    cover: Floats
    core: Floats
    cover_at_take_off: Floats
    core_at_take_off: Floats


def layer_spins(of: History) -> LayerSpins:
    """Return how cover and core of a two-layer ball turn.

    The history holds the angular momentum of the whole ball. It drives the core through spring and damper alone, so the
    core is followed from rest, and the cover has what is left. The steps are those of the history, by the implicit
    midpoint rule: with an ``accuracy`` of 1e-10 spins are right to some 1 rpm, with that of plain histories to 15.

    Raises
    ------
    InputError
        The ball of the history's model has no layers.
    """
    values = of.launch.parameters.values
    if any(name not in values for name in LAYERED):
        raise InputError("model", of.launch.model, "volumetric, whose ball has a cover and a core")
    thickness, stiffness, damping = (values[name] for name in LAYERED)
    ball = of.launch.ball
    # Equal densities: inertias go with the fifth power of the radius.
    share = ((ball.radius - thickness) / ball.radius) ** 5
    inertia, whole = share * ball.inertia, 1.0 / (1.0 - share)  # cover less core is `whole` times ball less core
    spin, twist, core = of.ball_spin, np.zeros(3), np.zeros((len(of.time), 3))
    for step, duration in enumerate(np.diff(of.time)):
        half, mean = 0.5 * duration, 0.5 * (spin[step] + spin[step + 1])
        grip = (stiffness * half + damping) * whole
        middle = (core[step] + half / inertia * (stiffness * twist + grip * mean)) / (1.0 + half / inertia * grip)
        twist = twist + duration * whole * (mean - middle)
        core[step + 1] = 2.0 * middle - core[step]
    cover = core + whole * (spin - core)
    end = [
        np.array([np.interp(of.launch.contact_time, of.time, each) for each in of_layer.T])
        for of_layer in (cover, core)
    ]
    return LayerSpins(cover, core, *end)
