"""Shots whose launch angle and start direction are as measured: dynamic loft and face angle are solved for each shot.

Loft and face angle of a launch monitor are often computed from the ball by the monitor's own impact model. Spin and
ball speed at the measured launch use neither, so they judge a model by what was measured.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL, models
from clubface.errors import RangeWarning
from clubface.simulation.impact import Parameters, impact, warn_if_outside
from clubface.simulation.inputs import DeliveryLike, as_values
from clubface.simulation.launch import Launch
from clubface.support.arrays import Floats, ValueLike
from clubface.support.checks import without_warnings

LOWEST, STEEPEST = units.to_si(-20.0, "deg"), units.to_si(78.0, "deg")
"""The dynamic lofts [rad] between which one is searched."""
WIDEST = units.to_si(60.0, "deg")
"""The largest face angle [rad] that is tried."""
LIMITS = np.array([[LOWEST, STEEPEST], [-WIDEST, WIDEST]])
LOFT_SHARE, FACE_SHARE = 0.85, 0.75
"""Changes of launch angle with loft and of start direction with face angle, for the first step of the search."""
LONGEST = units.to_si(10.0, "deg")
"""The largest change of an angle in one step [rad]."""
FAR_APART = 1e-3
"""Tries closer together [rad] keep the slopes, which the steps of contact models would spoil."""
TRIES = 16
RESOLUTION, COARSE_RESOLUTION = 1e-10, 1e-5
"""How closely a solution gives launch angle and start direction [rad]: by a reduced model, and by one that takes long.
"""
REACHED = 2e-5
"""What is further off [rad] after all tries is out of reach; the steps of contact models alone make some 1e-6."""
LEAST_DETERMINANT = 1e-3
"""Of the slopes; below it a step means nothing."""

Directions = Callable[[Floats, NDArray[np.intp]], Floats]
"""Launch angles and azimuths [rad], shape (angles, n), of lofts and face angles, the same shape, of shots by place."""


class ConditionedLaunch(NamedTuple):
    """Shots whose launch angle and start direction agree with given ones.

    Attributes
    ----------
    loft, face
        The solved dynamic loft and face angle [rad], of the shape of the shots; NaN where none gives the launch.
    launch
        The launches of the model with them.
    """

    loft: Any
    face: Any
    launch: Launch


def impact_at_launch(
    club: str | os.PathLike[str] | Club,
    delivery: DeliveryLike | None = None,
    *,
    launch: ValueLike,
    azimuth: ValueLike | None = None,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    threads: int | None = None,
    **values: ValueLike | None,
) -> ConditionedLaunch:
    """Compute shots with the dynamic loft and face angle that give their measured launch angle and start direction.

    Parameters
    ----------
    club, delivery, model, parameters, ball, accuracy, threads, **values
        As for :func:`clubface.impact`, but that the loft counts for nothing, and the face angle only without
        ``azimuth``. A shot that cannot be computed is NaN.
    launch
        Launch angle: text with a unit, radians, or arrays, which broadcast with the other values.
    azimuth
        Start direction, positive to the right, likewise. If left out, the face angle is as given, 0 unless given, and
        the loft alone is solved.

    Returns
    -------
    ConditionedLaunch
        Lofts, face angles and launches; NaN where no loft between -20 and 78 degrees, with a face angle within 60
        degrees, gives the launch.
    """
    given = {name: value for name, value in as_values(delivery, values).items() if value is not None}
    wanted = [_angle(launch, "launch")] + ([] if azimuth is None else [_angle(azimuth, "azimuth")])
    attack, path, face = (_angle(given.get(name, 0.0), name) for name in ("attack", "path", "face"))
    loft = attack + (wanted[0] - attack) / LOFT_SHARE
    face = face if azimuth is None else path + (wanted[1] - path) / FACE_SHARE
    last: dict[str, Any] = {}

    def strike(angles: list[Any]) -> Launch:
        with without_warnings(RangeWarning):  # of tries
            last["angles"] = angles
            last["launch"] = impact(
                club, {**given, "loft": angles[0], "face": angles[1]}, model=model, parameters=parameters, ball=ball,
                accuracy=accuracy, threads=threads, on_error="nan",
            )  # fmt: skip
        return last["launch"]

    shape = np.broadcast_shapes(np.shape(strike([loft, face]).launch), *(each.shape for each in wanted))
    size = int(np.prod(shape, dtype=int))
    begin = np.array([np.broadcast_to(each, shape).reshape(size) for each in (loft, face)], dtype=float)
    target = np.array([np.broadcast_to(each, shape).reshape(size) for each in wanted], dtype=float)
    solved = np.array(begin)

    def directions(angles: Floats, places: NDArray[np.intp]) -> Floats:
        solved[: len(angles), places] = angles
        result = strike([_shaped(each, shape) for each in solved])
        out = [result.launch] if azimuth is None else [result.launch, result.azimuth]
        return np.array([np.reshape(each, size)[places] for each in out])

    resolution = RESOLUTION if model in models() else COARSE_RESOLUTION
    begin[: len(target)] = solve_angles(directions, begin[: len(target)], target, resolution)
    begin[:, ~np.isfinite(begin).all(axis=0)] = np.nan
    angles = [_shaped(each, shape) for each in begin]
    same = np.array_equal(np.stack(angles), np.stack(last["angles"]), equal_nan=True)
    result = last["launch"] if same else strike(angles)
    warn_if_outside((result,))
    return ConditionedLaunch(angles[0], angles[1], result)


def solve_angles(directions: Directions, begin: Floats, wanted: Floats, resolution: float = RESOLUTION) -> Floats:
    """Return the lofts, or lofts and face angles, with which shots start as wanted; NaN where none is in reach.

    Every shot goes its own way by Broyden's method, which for the loft alone is that of secants; a shot that has
    arrived is not computed again. The search begins at ``begin`` [rad], shape (1 or 2, shots), and meets the launch
    angles, or launch angles and azimuths, that are ``wanted`` [rad] up to ``resolution``.
    """
    count, shots = begin.shape
    limits = LIMITS[:count, :, None]
    best = np.clip(begin, limits[:, 0], limits[:, 1])
    least = np.full(shots, np.inf)
    slopes = np.tile(np.diag([LOFT_SHARE, FACE_SHARE][:count]), (shots, 1, 1))
    angles, errors = np.array(best), np.zeros_like(best)
    active, step = np.arange(shots), None
    for _ in range(TRIES):
        result = directions(angles[:, active], active) - wanted[:, active]
        if step is not None:
            _update(slopes, active, step, result - errors[:, active])
        errors[:, active] = result
        off = np.max(np.abs(result), axis=0)
        worse = ~(off < least[active])
        better = active[~worse]
        best[:, better], least[better] = angles[:, better], off[~worse]
        # Within reach and no nearer than before: what remains are the steps of a contact model.
        stuck = worse & (least[active] <= REACHED)
        going = np.isfinite(off) & (off > resolution) & ~stuck
        active, result = active[going], result[:, going]
        if not active.size:
            break
        following = np.clip(angles[:, active] + _steps(slopes[active], result), limits[:, 0], limits[:, 1])
        step = following - angles[:, active]
        angles[:, active] = following
        moving = np.any(step != 0.0, axis=0)
        active, step = active[moving], step[:, moving]
        if not active.size:
            break
    return np.where(least <= REACHED, best, np.nan)


def _update(slopes: Floats, active: NDArray[np.intp], step: Floats, change: Floats) -> None:
    """Let the slopes of the shots explain what their last step changed."""
    length = np.sum(step * step, axis=0)
    usable = (length > FAR_APART**2) & np.isfinite(change).all(axis=0)
    step, change, which = step[:, usable], change[:, usable], active[usable]
    missed = change - np.einsum("nij,jn->in", slopes[which], step)
    slopes[which] += np.einsum("in,jn->nij", missed, step / length[usable])


def _steps(slopes: Floats, errors: Floats) -> Floats:
    """Return the steps that take the errors to zero, none longer than ``LONGEST``; none where slopes mean nothing."""
    usable = np.abs(np.linalg.det(slopes)) > LEAST_DETERMINANT
    steps = np.zeros_like(errors)
    steps[:, usable] = -np.linalg.solve(slopes[usable], errors.T[usable][..., None])[..., 0].T
    longest = np.max(np.abs(steps), axis=0)
    return steps * (LONGEST / np.maximum(longest, LONGEST))


def _angle(value: Any, name: str) -> Floats:
    return np.asarray(units.parse_values(value, "angle", name=name), dtype=float)


def _shaped(values: Floats, shape: tuple[int, ...]) -> Any:
    """Return values of flat shots in their shape; a number for a single shot."""
    return values.reshape(shape) if shape else float(values[0])
