"""Shots with measured launch angle and start direction, for which dynamic loft and face angle are solved.

Launch monitors often compute loft and face angle from the ball with an impact model of their own. Spin and ball speed
at the measured launch use neither, so they test a model against measured values only.
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
"""Bounds of the dynamic loft [rad]."""
WIDEST = units.to_si(60.0, "deg")
"""Bound of the magnitude of the face angle [rad]."""
LIMITS = np.array([[LOWEST, STEEPEST], [-WIDEST, WIDEST]])
LOFT_SHARE, FACE_SHARE = 0.85, 0.75
"""Initial slopes: change of launch angle per loft, and of start direction per face angle."""
LONGEST = units.to_si(10.0, "deg")
"""Maximum change of an angle per step [rad]."""
FAR_APART = 1e-3
"""Minimum step for updating the slopes [rad]; below it, discretisation errors of contact models would spoil them."""
TRIES = 16
RESOLUTION, COARSE_RESOLUTION = 1e-10, 1e-5
"""Tolerance of launch angle and start direction [rad], for reduced models and for slow models."""
REACHED = 2e-5
"""Maximum error of a solution after all iterations [rad]; contact models alone have errors of about 1e-6."""
LEAST_DETERMINANT = 1e-3
"""Minimum determinant of the slopes; below it no step is taken."""

Directions = Callable[[Floats, NDArray[np.intp]], Floats]
"""Function of lofts and face angles [rad], shape (angles, n), and indices of shots; returns launch angles and
azimuths."""


class ConditionedLaunch(NamedTuple):
    """Shots with given launch angle and start direction.

    Attributes
    ----------
    loft, face
        The solved dynamic loft and face angle [rad], of the shape of the shots; NaN where there is no solution.
    launch
        The launches with this loft and face angle.
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
    """Solve for the dynamic loft and face angle that give measured launch angles and start directions.

    Parameters
    ----------
    club, delivery, model, parameters, ball, accuracy, threads, **values
        As for :func:`clubface.impact`; the loft is ignored, and so is the face angle if ``azimuth`` is given. A shot
        that cannot be computed is NaN.
    launch
        Launch angle: text with a unit, radians, or arrays, which broadcast with the other values.
    azimuth
        Start direction, positive to the right, in the same form. Default: the face angle is kept, and only the loft is
        solved.

    Returns
    -------
    ConditionedLaunch
        Lofts, face angles and launches; NaN where no loft between -20 and 78 degrees with a face angle up to 60 degrees
        gives the launch.
    """
    given = {name: value for name, value in as_values(delivery, values).items() if value is not None}
    wanted = [_angle(launch, "launch")] + ([] if azimuth is None else [_angle(azimuth, "azimuth")])
    attack, path, face = (_angle(given.get(name, 0.0), name) for name in ("attack", "path", "face"))
    loft = attack + (wanted[0] - attack) / LOFT_SHARE
    face = face if azimuth is None else path + (wanted[1] - path) / FACE_SHARE
    last: dict[str, Any] = {}

    def strike(angles: list[Any]) -> Launch:
        with without_warnings(RangeWarning):  # of trial shots
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
        result = strike([_reshape(each, shape) for each in solved])
        out = [result.launch] if azimuth is None else [result.launch, result.azimuth]
        return np.array([np.reshape(each, size)[places] for each in out])

    resolution = RESOLUTION if model in models() else COARSE_RESOLUTION
    begin[: len(target)] = solve_angles(directions, begin[: len(target)], target, resolution)
    begin[:, ~np.isfinite(begin).all(axis=0)] = np.nan
    angles = [_reshape(each, shape) for each in begin]
    same = np.array_equal(np.stack(angles), np.stack(last["angles"]), equal_nan=True)
    result = last["launch"] if same else strike(angles)
    warn_if_outside((result,))
    return ConditionedLaunch(angles[0], angles[1], result)


def solve_angles(directions: Directions, begin: Floats, wanted: Floats, resolution: float = RESOLUTION) -> Floats:
    """Return the lofts, or lofts and face angles, that give the wanted launch; NaN where there is no solution.

    Uses Broyden's method for each shot, which for the loft alone is the secant method; converged shots are not computed
    again. The search starts at ``begin`` [rad], shape (1 or 2, shots), and solves for the ``wanted`` launch angles, or
    launch angles and azimuths [rad], to ``resolution``.
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
        # Close, and no better than before: what remains is the discretisation error of a contact model.
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
    """Update the slopes of the shots by Broyden's formula."""
    length = np.sum(step * step, axis=0)
    usable = (length > FAR_APART**2) & np.isfinite(change).all(axis=0)
    step, change, which = step[:, usable], change[:, usable], active[usable]
    missed = change - np.einsum("nij,jn->in", slopes[which], step)
    slopes[which] += np.einsum("in,jn->nij", missed, step / length[usable])


def _steps(slopes: Floats, errors: Floats) -> Floats:
    """Return Newton steps, none longer than ``LONGEST``; zero where the slopes are singular."""
    usable = np.abs(np.linalg.det(slopes)) > LEAST_DETERMINANT
    steps = np.zeros_like(errors)
    steps[:, usable] = -np.linalg.solve(slopes[usable], errors.T[usable][..., None])[..., 0].T
    longest = np.max(np.abs(steps), axis=0)
    return steps * (LONGEST / np.maximum(longest, LONGEST))


def _angle(value: Any, name: str) -> Floats:
    return np.asarray(units.parse_values(value, "angle", name=name), dtype=float)


def _reshape(values: Floats, shape: tuple[int, ...]) -> Any:
    """Reshape flat values to the shape of the shots; return a number for a single shot."""
    return values.reshape(shape) if shape else float(values[0])
