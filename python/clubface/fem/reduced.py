"""A finite element impact compared with the simple models and with Arakawa's law of friction by contact area."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError, RangeWarning, Wording
from clubface.fem.result import Impact
from clubface.simulation.history import history
from clubface.simulation.impact import impact
from clubface.support.checks import without_warnings

__all__ = ["AreaTerm", "Equivalent", "area_term", "equivalent"]

LAWS = {"volumetric": ("stiffness", "damping"), "rings": ("shear_modulus", "damping")}
"""Simple models whose normal force has a stiffness and a damping, with the names of these two parameters."""
ROUNDS = 12
"""Maximum number of Newton steps."""
ACCURACY = 1e-6
"""Relative tolerance for ball speed and peak force."""


class Equivalent(NamedTuple):
    """A simple model with stiffness and damping fitted to a finite element impact.

    Attributes
    ----------
    model
        Name of the simple model.
    parameters
        The two fitted parameters; the others keep their published values.
    time
        Times at which forces are compared [s].
    force, reference
        Normal force of the simple model and of the finite elements [N], smoothed over a tenth of the contact.
    error
        Root mean square difference of the two forces over the contact, relative to the peak.
    contact_time, reference_contact_time
        Contact times of the simple model and of the finite elements [s].
    """

    model: str
    parameters: dict[str, float]
    time: NDArray[Any]
    force: NDArray[Any]
    reference: NDArray[Any]
    error: float
    contact_time: float
    reference_contact_time: float


def equivalent(run: Impact, model: str = "volumetric") -> Equivalent:
    """Fit a simple model to the ball speed and peak force of a finite element impact.

    These two figures determine stiffness and damping; the shape and duration of the force are then predictions. Raises
    InputError if the impact was with a plane or ended early, or the model is not one of ``LAWS``.
    """
    if model not in LAWS:
        raise InputError("model", model, f"one of {', '.join(LAWS)}")
    if run.equipment is None or run.stopped is not None:
        shown = Wording("one with a plane, or one that ended early")
        raise InputError("impact", shown, "a complete impact with a head")
    club, ball = run.equipment
    wanted = np.log([run.outcome()["ball_speed"], _normal_force(run)[1].max()])
    names = LAWS[model]
    set_ = ParameterSet.builtin(model, club.parameters)
    place = np.log([float(set_.values[name]) for name in names])

    def figures(at: Any) -> Any:
        """Return the logarithms of ball speed and peak force at three sets of parameters."""
        given = {name: np.exp(values) for name, values in zip(names, np.transpose(at), strict=True)}
        with without_warnings(RangeWarning):  # parameters fitted to this impact may leave the model's range
            launch = impact(club, run.given, model=model, parameters=given, ball=ball)
        return np.log(np.stack([launch.ball_speed, launch.peak_force], axis=-1))

    for _ in range(ROUNDS):
        shifts = np.array([[0.0, 0.0], [1e-4, 0.0], [0.0, 1e-4]])
        values = figures(place + shifts)
        if abs(values[0] - wanted).max() < ACCURACY:
            break
        slopes = (values[1:] - values[0]).T / 1e-4
        place = place - np.clip(np.linalg.solve(slopes, values[0] - wanted), -0.5, 0.5)
    else:
        raise InputError("impact", run, f"one that {model} can reproduce with positive stiffness and damping")
    parameters = {name: float(value) for name, value in zip(names, np.exp(place), strict=True)}
    with without_warnings(RangeWarning):
        over = history(club, run.given, model=model, parameters=parameters, ball=ball)
    time, reference = _normal_force(run)
    force = np.interp(time, over.time, over.normal_force, right=0.0)
    error = float(np.sqrt(np.mean((force - reference) ** 2)) / reference.max())
    return Equivalent(model, parameters, time, force, reference, error, float(over.time[-1]), float(run.contact_time))


def _smooth(run: Impact, values: NDArray[Any]) -> NDArray[Any]:
    """Smooth a history of the contact with a moving average over a tenth of the contact.

    A mesh makes contact node by node, a simple model all at once: differences within the time between two rings of
    nodes say nothing about the force law.
    """
    time = run.contact["time"]
    width = max(3, int(0.1 * run.contact_time / (time[1] - time[0])) | 1)
    return np.convolve(values, np.ones(width) / width, "same")


def _normal_force(run: Impact) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return the times within the contact and the smoothed normal force."""
    within = run.contact["time"] <= run.contact_time
    return run.contact["time"][within], _smooth(run, run.contact["normal"])[within]


SLIDES = 0.1
"""Surface speed along the face above which the ball counts as sliding [m/s]; the law's tanh is then 1."""
WITHIN = (0.05, 0.95)
"""Fraction of the contact used in the fit: at either end only a few nodes make up the area."""
LEAST = 20
"""Minimum number of sliding steps for a fit."""


class AreaTerm(NamedTuple):
    """How well the law F = mu F_N + mu eta dA/dt describes a finite element run.

    Attributes
    ----------
    sliding
        Fraction of the contact in which the ball slides.
    damping
        Best fit of eta [N s/m2] to F - mu F_N while sliding, with the run's friction as mu; NaN if the ball hardly
        slides.
    explained
        Fraction of the sum of squares of F - mu F_N that the area term then explains.
    free_friction, free_damping, free_explained
        Best fits of mu and eta to F over the whole contact, and the fraction of its sum of squares that they explain.
    time, normal, tangential, area, rate
        Times within the contact [s], normal and tangential force [N], area [m2] and its rate [m2/s], smoothed over a
        tenth of the contact.
    sinking
        Decrease of the distance from mass centre to face at these times [m], d in A = pi R d.
    """

    sliding: float
    damping: float
    explained: float
    free_friction: float
    free_damping: float
    free_explained: float
    time: NDArray[Any]
    normal: NDArray[Any]
    tangential: NDArray[Any]
    area: NDArray[Any]
    rate: NDArray[Any]
    sinking: NDArray[Any]


def area_term(run: Impact) -> AreaTerm:
    """Fit Arakawa's law, in the form of the model ``area``, to a complete impact.

    Finite elements have Coulomb friction at every node and no area term, so the fit shows how elastic grip appears in
    terms of this law.
    """
    if run.stopped is not None or not run.contact_time > 0.0:
        raise InputError("impact", run, "a complete impact")
    over = run.contact["time"]
    last, motion = run.contact_time, run.motion
    area = _smooth(run, run.contact["area"])
    within = (over > WITHIN[0] * last) & (over < WITHIN[1] * last)
    rate = _smooth(run, np.gradient(area, over[1] - over[0]))
    curves = (_smooth(run, run.contact["normal"]), _smooth(run, run.contact["tangential"]), area, rate)
    normal, tangential, area, rate = (each[within] for each in curves)
    time = over[within]
    slip = run.relative_velocity()[:, 1] - motion["spin"][:, 2] * motion["radius"]
    slides = np.interp(time, motion["time"], slip) > SLIDES
    sinking = 0.5 * run.ball.diameter - np.interp(time, motion["time"], motion["radius"])

    mu = run.friction
    damping, explained = float("nan"), float("nan")
    if slides.sum() >= LEAST and mu > 0.0:
        (damping,), explained = _fit(mu * rate[slides, None], (tangential - mu * normal)[slides])
    (free, slope), free_explained = _fit(np.stack([normal, rate], axis=1), tangential)
    return AreaTerm(
        float(slides.mean()), damping, explained, free, slope / free, free_explained,
        time, normal, tangential, area, rate, sinking,
    )  # fmt: skip


def _fit(columns: Any, wanted: Any) -> tuple[list[float], float]:
    """Return the least-squares coefficients of the columns, and the fraction of the sum of squares they explain."""
    factors = np.linalg.lstsq(columns, wanted, rcond=None)[0]
    left = wanted - columns @ factors
    return factors.tolist(), float(1.0 - (left @ left) / (wanted @ wanted))
