"""The model `response` from strikes by finite elements: the strikes, the fit, and what it leaves.

The coefficients of the model `response` from strikes by finite elements: least squares with exact derivatives.

What the fitted model leaves: differences from the finite elements, in figures and as a picture.

The table of strikes: each run by finite elements once, also where the design or an interrupted run goes on later.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.models import model
from clubface.fem.balls import Ball
from clubface.fem.response.design import Part, Strike, strikes
from clubface.fem.run import inputs_of, one_shot, strike
from clubface.fem.settings import Settings
from clubface.fem.sweep import ResumableTable
from clubface.simulation import core
from clubface.simulation.results import inputs, outputs
from clubface.support.checks import without_warnings
from clubface.support.fingerprint import fingerprint

if TYPE_CHECKING:
    from matplotlib.figure import Figure


TARGETS = (
    "velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z", "contact_time", "peak_force",
)  # fmt: skip
"""What the model must give, SI."""
COLUMNS = ("part", "number", *TARGETS, "stopped", "inputs")
"""Of the table: which strike it is (the design tells how it is delivered), its results, and a sum of its inputs, by
which a row is run again where the design gives its number to another strike."""
DIGITS = 9
_SETTINGS = Settings(duration=2.5e-3, interval=2e-5, until_separation=True, threads=1)


class Strikes(NamedTuple):
    """Strikes and their results, one row each.

    Attributes
    ----------
    part
        Number of the part they belong to.
    inputs
        Inputs in the order of the core, shape (strikes, inputs).
    friction
        Coefficients of friction.
    found
        ``TARGETS`` by the finite elements, shape (strikes, targets).
    """

    part: NDArray[Any]
    inputs: NDArray[Any]
    friction: NDArray[Any]
    found: NDArray[Any]

    def where(self, chosen: NDArray[Any]) -> Strikes:
        """Return the chosen rows."""
        return Strikes(*(column[chosen] for column in self))


def run(
    ball: Ball,
    parts: Mapping[str, Part],
    path: str | os.PathLike[str],
    *,
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Strikes:
    """Run the strikes of some parts that the table does not have yet, several at a time, and return all that ended.

    Parameters
    ----------
    ball
        The ball of pieces.
    parts
        The strikes, by what they are.
    path
        The table. It belongs to one ball, and is refused with another. Strikes that have changed are run again.
    workers
        Runs at a time; left out, as many as there are cores.
    progress
        Called with the rows there are and the rows in all.
    """
    planned = strikes(parts)

    with without_warnings():
        shots = {place: inputs_of(one_shot(each.club, each.delivery, ball)) for place, each in planned.items()}
    sums = {place: _sum([*inputs, planned[place].friction]) for place, inputs in shots.items()}

    def one(place: tuple[int, int], keep_going: Any, threads: int) -> dict[str, Any]:
        return {**_row(place, planned[place], ball, keep_going), "inputs": sums[place]}

    places = {place: (float(place[0]), float(place[1])) for place in planned}
    rows = ResumableTable(path, {"ball": ball.values()}, COLUMNS, {"stopped": str, "inputs": str}).fill(
        places, one, what="strikes", workers=workers, progress=progress,
        is_of=lambda place, row: row["inputs"] == sums[place],
    )  # fmt: skip
    pairs = [(place, row) for place, row in zip(planned, rows, strict=True) if not row["stopped"]]
    return Strikes(
        np.array([place[0] for place, _ in pairs]),
        np.array([shots[place] for place, _ in pairs]),
        np.array([planned[place].friction for place, _ in pairs]),
        np.array([[row[name] for name in TARGETS] for _, row in pairs]),
    )


def in_fit(of: Strikes, parts: Mapping[str, Part]) -> NDArray[Any]:
    """Return which strikes the coefficients are fitted to: those that are not held out."""
    return np.isin(of.part, [place for place, part in enumerate(parts.values()) if not part.held_out])


def of_clubs(of: Strikes, parts: Mapping[str, Part]) -> NDArray[Any]:
    """Return which strikes are with built-in clubs."""
    return np.isin(of.part, [place for place, part in enumerate(parts.values()) if part.built_in])


def _sum(values: Iterable[float]) -> str:
    """Return a text that tells inputs apart; another machine may differ in their last digits."""
    return fingerprint([f"{value + 0.0:.{DIGITS}g}" for value in values])[:8]


def _row(place: tuple[int, int], planned: Strike, ball: Ball, keep_going: Any) -> dict[str, Any]:
    club, delivery, friction = planned
    with without_warnings():
        found = strike(club, delivery, which=ball, friction=friction, settings=_SETTINGS, progress=keep_going)
    out = found.outcome()
    results = {name: float(f"{out[name]:.{DIGITS}g}") for name in TARGETS}
    return {"part": float(place[0]), "number": float(place[1]), **results, "stopped": found.stopped or ""}


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


RESIDUAL_SPIN_SHARE, RESIDUAL_SPIN_LEAST = 0.02, 40.0 * math.pi / 30.0
"""A spin is met within this share of itself, or within this much [rad/s]."""
PERCENTILES = (50, 95, 100)
MASSES = (0.0, 0.12, 0.2, math.inf)
"""Ends of the classes of effective mass [kg] by which differences with any heads are told, too."""


def differences(values: Mapping[str, float], strikes: Strikes) -> dict[str, NDArray[Any]]:
    """Return how far the model with some coefficients is from the finite elements, one value a strike.

    ``speed`` [1] of ball speed, ``direction`` [rad] the angle between the launches, ``spin`` [1] the difference of the
    spins' sizes and ``spin_vector`` that of the vectors, over 2% of the spin or 40 rpm, whichever is larger;
    ``contact_time`` and ``peak_force`` [1].
    """
    got, _ = simulated(values, strikes, fitted()[:1])
    want = strikes.found
    size = np.linalg.norm
    speeds, spins = (tuple(size(of[:, part], axis=1) for of in (got, want)) for part in (slice(0, 3), slice(3, 6)))
    cosine = np.einsum("ij,ij->i", got[:, :3], want[:, :3]) / (speeds[0] * speeds[1])
    allowed = np.maximum(RESIDUAL_SPIN_SHARE * spins[1], RESIDUAL_SPIN_LEAST)
    return {
        "speed": np.abs(speeds[0] / speeds[1] - 1.0),
        "direction": np.arccos(np.clip(cosine, -1.0, 1.0)),
        "spin": np.abs(spins[0] - spins[1]) / allowed,
        "spin_vector": size(got[:, 3:6] - want[:, 3:6], axis=1) / allowed,
        "contact_time": np.abs(got[:, 6] / want[:, 6] - 1.0),
        "peak_force": np.abs(got[:, 7] / want[:, 7] - 1.0),
    }


def summary(
    values: Mapping[str, float], strikes: Strikes, parts: Mapping[str, Part]
) -> dict[str, dict[str, list[float]]]:
    """Return the percentiles of the differences by part and quantity, for held-out heads also by effective mass."""
    found = {}
    for place, (name, part) in enumerate(parts.items()):
        of_part = strikes.where(strikes.part == place)
        each, groups = differences(values, of_part), {name: np.arange(len(of_part.friction))}
        if part.held_out and not part.built_in:
            masses = effective_mass(of_part)
            for least, most in pairwise(MASSES):
                groups[f"{name}, {_class(least, most)}"] = np.flatnonzero((masses >= least) & (masses < most))
        for group, chosen in groups.items():
            found[group] = {key: [float(np.percentile(of[chosen], p)) for p in PERCENTILES] for key, of in each.items()}
    return found


def _class(least: float, most: float) -> str:
    if not least:
        return f"below {most:g} kg"
    return f"{least:g} kg and more" if math.isinf(most) else f"{least:g} to {most:g} kg"


def figure(values: Mapping[str, float], strikes: Strikes, parts: Mapping[str, Part]) -> Figure:
    """Draw what share of the held-out strikes is within a difference, for ball speed, direction and spin."""
    from matplotlib.figure import Figure

    from clubface.plots import legend_above

    drawn = Figure(figsize=(9.0, 3.4), layout="constrained")
    panels = drawn.subplots(1, 3, sharey=True)
    told = {
        "speed": ("difference of ball speed, %", 100.0, 0.5),
        "direction": ("angle between launches, degrees", 180.0 / math.pi, 0.2),
        "spin": ("difference of spin over 2% or 40 rpm", 1.0, 1.0),
    }
    for place, (name, part) in enumerate(parts.items()):
        if not part.held_out:
            continue
        found = differences(values, strikes.where(strikes.part == place))
        for panel, (key, (_, size, _)) in zip(panels, told.items(), strict=True):
            ordered = np.sort(found[key]) * size
            panel.plot(ordered, np.arange(1, len(ordered) + 1) / len(ordered), label=name)
    legend_above(drawn, panels[0].get_lines())
    for panel, (text, _, asked) in zip(panels, told.values(), strict=True):
        panel.axvline(asked, color="0.6", linewidth=0.8)
        panel.axhline(0.95, color="0.6", linewidth=0.8)
        panel.set_xlim(0.0, 4.0 * asked)
        panel.set_xlabel(text)
    panels[0].set_ylabel("share of the strikes")
    return drawn
