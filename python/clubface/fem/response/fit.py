"""The coefficients of the model `response` from strikes by finite elements: least squares with exact derivatives."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.models import model
from clubface.fem.response.runs import TARGETS, Strikes
from clubface.simulation import core
from clubface.simulation.quantities import inputs, outputs

MODEL = "response"
GIVEN = "friction"
"""The parameter that each strike has a value of its own for."""
SPEED_SHARE, SPIN_SHARE, SPIN_LEAST, TIME_SHARE, FORCE_SHARE = 0.003, 0.01, 2.0, 0.05, 0.03
"""Deviations that count alike: of velocity and spin as shares of their size, with a least one of spin [rad/s]."""
RIDGE = 0.02
"""What a coefficient of one costs, in these deviations: keeps those that no strike determines near zero."""
CLUB_WEIGHT = 2.5
"""Of a strike with a built-in club, beside one with any head."""
CONVERGED = 1e-7
"""Share of the cost by which a search must lower it at least: one that repeats another gives the same coefficients."""
LIGHT = 0.12
"""Effective mass [kg] of a head at the impact point below which its strikes count less, since no club is so light."""


def fitted() -> list[str]:
    """Return the names of the coefficients."""
    return [each.name for each in model(MODEL).parameters if each.name != GIVEN]


def simulated(values: Mapping[str, float], strikes: Strikes, variables: list[str]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return the targets by the model, shape (strikes, targets), and their derivatives, with a last axis more."""
    count, all_outputs = len(strikes.friction), list(outputs())
    parameters = [
        np.ascontiguousarray(strikes.friction) if each.name == GIVEN else values[each.name]
        for each in model(MODEL).parameters
    ]
    names = [each.name for each in model(MODEL).parameters]
    columns = [np.ascontiguousarray(column) for column in strikes.inputs.T]
    table, _ = core.sensitivities(
        MODEL, columns, parameters, count, [all_outputs.index(name) for name in TARGETS],
        [len(inputs()) + names.index(name) for name in variables], None, 0,
    )  # fmt: skip
    table = table.reshape(len(TARGETS), 1 + len(variables), count)
    return table[:, 0].T, np.moveaxis(table[:, 1:], 2, 0)


def scales(strikes: Strikes) -> NDArray[Any]:
    """Return the deviations that count alike, shape (strikes, targets)."""
    found = strikes.found
    speed, spin = (np.linalg.norm(found[:, part], axis=1) for part in (slice(0, 3), slice(3, 6)))
    spin = np.maximum(SPIN_SHARE * spin, SPIN_LEAST)
    each = [SPEED_SHARE * speed] * 3 + [spin] * 3 + [TIME_SHARE * found[:, 6], FORCE_SHARE * found[:, 7]]
    return np.stack(each, axis=1)


def weights(strikes: Strikes, of_clubs: NDArray[Any]) -> NDArray[Any]:
    """Return the weights of the strikes, given which are with built-in clubs."""
    return np.where(of_clubs, CLUB_WEIGHT, np.clip(effective_mass(strikes) / LIGHT, 0.2, 1.0))


def effective_mass(strikes: Strikes) -> NDArray[Any]:
    """Return the masses [kg] as which the heads resist the ball, from the impulse that the ball took at a flat face."""
    from clubface.equipment.face import face_point, nearest, turn_to_sole

    names = list(inputs())
    found = []
    for row in strikes.inputs:
        of = dict(zip(names, row, strict=True))
        turn = turn_to_sole(of["static_loft"])
        inertia = np.array(
            [
                [of["ixx"], of["ixy"], of["ixz"]],
                [of["ixy"], of["iyy"], of["iyz"]],
                [of["ixz"], of["iyz"], of["izz"]],
            ]
        )
        inertia = turn.T @ inertia @ turn
        lever = turn.T @ np.array([of["cg_x"], of["cg_y"], of["cg_z"]])
        point = face_point(of["toe"], of["high"], of["bulge"], of["roll"])
        arm = np.cross(lever + point, nearest(point, of["bulge"], of["roll"])[1])
        found.append(1.0 / (1.0 / of["club_mass"] + arm @ np.linalg.solve(inertia, arm)))
    return np.array(found)


def fit(
    strikes: Strikes, weight: NDArray[Any], *, progress: Callable[[float], object] | None = None
) -> dict[str, float]:
    """Return the coefficients that fit the strikes best.

    The search begins with those of the registry, which stay where no others fit better.
    """
    from scipy.optimize import least_squares

    names = fitted()
    bounds = {each.name: each for each in model(MODEL).parameters}
    start = np.array([bounds[name].default for name in names])
    scale = scales(strikes) / weight[:, None]
    terms = np.array([bounds[name].meaning.startswith("term ") for name in names])
    kept: dict[bytes, tuple[Any, Any]] = {}

    def cost(residual: NDArray[Any]) -> float:
        return float(np.sum(np.sqrt(1.0 + residual**2) - 1.0))

    def at(x: NDArray[Any]) -> tuple[Any, Any]:
        if x.tobytes() not in kept:
            kept.clear()
            values, slopes = simulated(dict(zip(names, map(float, x), strict=True)), strikes, names)
            residual = np.concatenate([((values - strikes.found) / scale).ravel(), RIDGE * x[terms]])
            slope = (slopes / scale[:, :, None]).reshape(-1, len(names))
            kept[x.tobytes()] = residual, np.concatenate([slope, RIDGE * np.eye(len(names))[terms]])
            if progress is not None:
                progress(cost(residual))
        return kept[x.tobytes()]

    size = np.maximum(np.abs(start), 0.05)
    size[names.index("time")] = start[names.index("time")]
    lower, upper = (np.array([getattr(bounds[name], end) for name in names]) for end in ("lower", "upper"))
    best = least_squares(
        lambda x: at(x)[0],
        start,
        lambda x: at(x)[1],  # pyright: ignore[reportArgumentType] -- its stubs know names of methods alone
        bounds=(lower, upper), x_scale=size, loss="soft_l1", max_nfev=60,
    )  # fmt: skip
    first = cost(at(start)[0])
    found = best.x if cost(best.fun) < (1.0 - CONVERGED) * first else start
    return dict(zip(names, map(float, found), strict=True))
