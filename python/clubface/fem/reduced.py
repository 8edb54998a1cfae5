"""A finite element impact in terms of the simple models: equivalent stiffness and damping, and forces."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError, RangeWarning, Told
from clubface.fem.result import Impact
from clubface.simulation.history import history
from clubface.simulation.impact import impact
from clubface.support.warning import without_warnings

LAWS = {"volumetric": ("stiffness", "damping"), "rings": ("shear_modulus", "damping")}
"""Reduced models whose normal force has a stiffness and a damping, and the names of these."""
ROUNDS = 12
ACCURACY = 1e-6


class Equivalent(NamedTuple):
    """A simple model with the stiffness and damping of a finite element impact.

    Attributes
    ----------
    model
        Name of the model.
    parameters
        The two parameters found; the others are the published ones.
    time
        Times at which the forces are compared [s].
    force, reference
        Normal force of the simple model and of the finite elements [N], averaged over a tenth of the contact.
    error
        Root mean square of their difference over the contact, divided by the peak.
    contact_time, reference_contact_time
        Contact times of both [s].
    """

    model: str
    parameters: dict[str, float]
    time: NDArray[Any]
    force: NDArray[Any]
    reference: NDArray[Any]
    error: float
    contact_time: float
    reference_contact_time: float


def equivalent(found: Impact, model: str = "volumetric") -> Equivalent:
    """Return a simple model that has the ball speed and the peak force of a finite element impact.

    These two figures determine stiffness and damping. The course of the force and its duration are then predictions.

    Parameters
    ----------
    found
        A complete impact with a head.
    model
        One of ``LAWS``.

    Raises
    ------
    InputError
        The impact was with a plane or ended early, or the model has no such parameters.
    """
    if model not in LAWS:
        raise InputError("model", model, f"one of {', '.join(LAWS)}")
    if found.equipment is None or found.stopped is not None:
        raise InputError("impact", Told("one with a plane, or one that ended early"), "a complete impact with a head")
    club, ball = found.equipment
    wanted = np.log([found.outcome()["ball_speed"], _peak(found)])
    names = LAWS[model]
    set_ = ParameterSet.builtin(model, club.parameters)
    place = np.log([float(set_.values[name]) for name in names])

    def figures(at: Any) -> Any:
        """Logarithms of ball speed and peak force at three sets of parameters at once."""
        given = {name: np.exp(values) for name, values in zip(names, np.transpose(at), strict=True)}
        with without_warnings(RangeWarning):  # the parameters are made for this impact
            launch = impact(club, found.given, model=model, parameters=given, ball=ball)
        return np.log(np.stack([launch.ball_speed, launch.peak_force], axis=-1))

    for _ in range(ROUNDS):
        shifts = np.array([[0.0, 0.0], [1e-4, 0.0], [0.0, 1e-4]])
        values = figures(place + shifts)
        if abs(values[0] - wanted).max() < ACCURACY:
            break
        slopes = (values[1:] - values[0]).T / 1e-4
        place = place - np.clip(np.linalg.solve(slopes, values[0] - wanted), -0.5, 0.5)
    else:
        raise InputError("impact", found, f"one that {model} can reach with positive stiffness and damping")
    parameters = {name: float(value) for name, value in zip(names, np.exp(place), strict=True)}
    with without_warnings(RangeWarning):
        over = history(club, found.given, model=model, parameters=parameters, ball=ball)
    time, reference = _smooth(found)
    force = np.interp(time, over.time, over.normal_force, right=0.0)
    error = float(np.sqrt(np.mean((force - reference) ** 2)) / reference.max())
    return Equivalent(model, parameters, time, force, reference, error, float(over.time[-1]), float(found.contact_time))


def _smooth(found: Impact) -> tuple[Any, Any]:
    """Return times within the contact and the normal force there, averaged over a tenth of the contact.

    A mesh touches node by node, a reduced model all at once: what differs within the time between two rings of nodes is
    not the law of force.
    """
    time, force = found.contact["time"], found.contact["normal"]
    width = max(3, int(0.1 * found.contact_time / (time[1] - time[0])) | 1)
    within = time <= found.contact_time
    mean = np.convolve(force, np.ones(width) / width, "same")
    return time[within], mean[within]


def _peak(found: Impact) -> float:
    return float(_smooth(found)[1].max())
