"""The coefficients of the model ``response`` for a ball, fitted to strikes by finite elements.

``python studies/response_fit.py BALL FOLDER`` strikes a built-in ball, or that of a file, with heads of all kinds and
with the built-in clubs, and fits the coefficients by least squares with exact derivatives. FOLDER gets the table of
strikes (an interrupted run goes on after it), the ball's file with the section of the model, the differences that are
left, and their picture.
"""

from __future__ import annotations

import json
import math
import os
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation
from scipy.stats import qmc

from clubface import _core as core
from clubface.equipment.balls import ball as rigid_ball
from clubface.equipment.clubs import Club, club
from clubface.equipment.face import face_point, nearest, turn_to_sole
from clubface.equipment.models import model
from clubface.equipment.parameters import RANGES
from clubface.errors import ClubfaceError
from clubface.fem.balls import Ball, ball
from clubface.fem.run import inputs_of, one_shot, strike
from clubface.fem.settings import Settings
from clubface.jobs import Job
from clubface.jobs.engine import Place, Row, run_table
from clubface.jobs.store import fingerprint
from clubface.present.style import legend_above, save
from clubface.simulation.results import inputs, outputs
from clubface.support.checks import without_warnings
from clubface.support.files import write_text
from clubface.units import parse

RANGE = RANGES["response"]
SPINS = ("ball_backspin", "ball_sidespin", "ball_riflespin")
CLUBS = (
    "driver", "3-wood", "5-wood", "hybrid", "3-iron", "5-iron", "6-iron", "7-iron", "8-iron", "9-iron",
    "pitching-wedge",
)  # fmt: skip


class Strike(NamedTuple):
    """A head, how it is delivered (SI, as for :func:`clubface.impact`), and the coefficient of friction."""

    club: Club
    delivery: dict[str, float]
    friction: float


@dataclass(frozen=True)
class Part:
    """Some of the strikes.

    Attributes
    ----------
    make
        Returns strikes for a number and a seed.
    count, seed
        How many, and the seed of their sequence.
    held_out
        Whether the coefficients are not fitted to them.
    built_in
        Whether the heads are those of the built-in clubs.
    """

    make: Callable[[int, int], list[Strike]]
    count: int
    seed: int
    held_out: bool
    built_in: bool = False


def heads(count: int, seed: int) -> list[Strike]:
    """Return strikes with free heads of all kinds, evenly over the range of the model.

    Speed, angle between path and normal, friction and mass are those of the model's range, most masses up to 450 g;
    radii of gyration of 13.5 to 55 mm; CG and impact point anywhere on a clubface; half of them flat, some turning, and
    with rigid faces or characteristic times from 100 us to the end of the range.
    """
    return _heads(_sequence(24, count, seed))


def spinning_heads(count: int, seed: int) -> list[Strike]:
    """Return strikes as those of heads of all kinds, with balls that spin about any axis before impact."""
    points = _sequence(27, count, seed)
    return _spinning(_heads(points), points[:, 24:])


def spinning_clubs(count: int, seed: int) -> list[Strike]:
    """Return strikes as those with the built-in clubs, with balls that spin about any axis before impact."""
    points = _sequence(13, count, seed)
    return _spinning(_clubs(points), points[:, 10:])


def _spinning(strikes: list[Strike], shares: NDArray[Any]) -> list[Strike]:
    """Return strikes with a spin of the ball, given as shares of its range about the three axes."""
    spinning = []
    for each, u in zip(strikes, shares, strict=True):
        spin = {name: float(_between(name, share)) for name, share in zip(SPINS, u, strict=True)}
        spinning.append(each._replace(delivery={**each.delivery, **spin}))
    return spinning


def _heads(points: NDArray[Any]) -> list[Strike]:
    """Return strikes with free heads from points of the unit cube."""
    made = []
    slowest, fastest = RANGE["speed"]
    lightest, heaviest = RANGE["club_mass"]
    softest = RANGE["characteristic_time"][1]
    for u in points:
        mass = heaviest if u[4] < 0.04 else lightest * (0.45 / lightest) ** u[3]
        gyration = np.array([0.0135 * (0.035 / 0.0135) ** u[6], *(0.024 * (0.055 / 0.024) ** u[7:9])])
        moments = mass * gyration**2
        # No moment of a body exceeds the sum of the others.
        largest = moments.argmax()
        moments[largest] = min(moments[largest], 0.97 * (moments.sum() - moments[largest]))
        # The least moment of irons is about the line from heel to toe, that of others about the vertical.
        moments = moments[[2, 1, 0]] if u[21] < 0.7 else moments[[1, 0, 2]]
        turn = Rotation.from_rotvec((u[14:17] - 0.5) * math.pi / 3.0).as_matrix()
        inertia = turn @ np.diag(moments) @ turn.T
        curvature = max(u[5] - 0.5, 0.0) * 2.0 / 0.23
        radius = 1.0 / curvature if curvature else math.inf
        head = Club(
            name="head", kind="wood", mass=mass, cg_x=0.045 * u[22], cg_y=(u[17] - 0.5) * 0.016,
            cg_z=(u[18] - 0.5) * 0.012, loft=0.0, bulge=radius, roll=radius, face_width=0.076, face_height=0.052,
            ixx=inertia[0, 0], iyy=inertia[1, 1], izz=inertia[2, 2], ixy=inertia[0, 1], ixz=inertia[0, 2],
            iyz=inertia[1, 2], characteristic_time=0.0 if u[19] < 0.3 else 100e-6 + (softest - 100e-6) * u[20],
        )  # fmt: skip
        incidence = _between("incidence", u[1])
        loft = min(incidence, math.radians(60.0))
        delivery = {
            "speed": slowest * (fastest / slowest) ** u[0],
            "loft": loft,
            "attack": loft - incidence,
            "static_loft": 0.0,
            "toe": (u[9] - 0.5) * 0.044,
            "high": (u[10] - 0.5) * 0.026,
            "face": (u[11] - 0.5) * math.radians(20.0) if u[12] < 0.5 else 0.0,
            "closure": (u[13] - 0.5) * 110.0 if u[12] > 0.4 else 0.0,
        }
        made.append(
            Strike(head, {key: float(value) for key, value in delivery.items()}, float(_between("friction", u[2])))
        )
    return made


def _between(name: str, share: float) -> float:
    """Return a value within the range of the model, at a share of its width."""
    least, most = RANGE[name]
    return least + (most - least) * share


def clubs(count: int, seed: int) -> list[Strike]:
    """Return strikes with the built-in clubs as golfers deliver them, good and bad, with faces of several kinds."""
    return _clubs(_sequence(10, count, seed))


def _clubs(points: NDArray[Any]) -> list[Strike]:
    """Return strikes with the built-in clubs, one after the other, from points of the unit cube."""
    made = []
    for number, u in enumerate(points):
        head = club(CLUBS[number % len(CLUBS)])
        wood = head.kind == "wood"
        rigid, least, more = (0.2, 200e-6, 80e-6) if wood else (0.4, 100e-6, 120e-6)
        head = head.replace(characteristic_time=0.0 if u[8] < rigid else float(least + more * u[9]))
        delivery = {
            "speed": parse(f"{60.0 + (60.0 if wood else 40.0) * u[0]} mph", "speed"),
            "attack": math.radians(-4.0 + 8.0 * u[1] if wood else -7.0 + 7.0 * u[1]),
            "loft": float(head.loft) + math.radians(-6.0 + 8.0 * u[2]),
            "toe": (u[4] - 0.5) * 0.036,
            "high": (u[5] - 0.5) * 0.020,
            "face": math.radians(8.0 * (u[6] - 0.5)),
            "closure": math.radians(3000.0 * u[7]),
        }
        made.append(Strike(head, {key: float(value) for key, value in delivery.items()}, float(0.15 + 0.35 * u[3])))
    return made


def _sequence(dimensions: int, count: int, seed: int) -> NDArray[Any]:
    """Return the first points of a Sobol sequence, which is even where the number is a power of two."""
    sequence = qmc.Sobol(dimensions, seed=seed)  # pyright: ignore[reportCallIssue]
    return sequence.random_base2((count - 1).bit_length())[:count]


PARTS: dict[str, Part] = {
    "heads": Part(heads, 1024, 101, held_out=False),
    "clubs": Part(clubs, 440, 102, held_out=False, built_in=True),
    "more heads": Part(heads, 1024, 105, held_out=False),
    "heads, held out": Part(heads, 512, 103, held_out=True),
    "clubs, held out": Part(clubs, 220, 104, held_out=True, built_in=True),
    "spinning balls, heads": Part(spinning_heads, 256, 106, held_out=False),
    "spinning balls, clubs": Part(spinning_clubs, 132, 107, held_out=False, built_in=True),
    "spinning balls, heads, held out": Part(spinning_heads, 128, 108, held_out=True),
    "spinning balls, clubs, held out": Part(spinning_clubs, 66, 109, held_out=True, built_in=True),
}
"""The strikes of the coefficients, and those that they were not fitted to, by what they are."""


def strikes(parts: Mapping[str, Part]) -> dict[tuple[int, int], Strike]:
    """Return the strikes of some parts by the numbers of part and strike."""
    with without_warnings():
        return {
            (place, number): strike
            for place, part in enumerate(parts.values())
            for number, strike in enumerate(part.make(part.count, part.seed))
        }


TARGETS = (
    "velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z", "contact_time", "peak_force",
)  # fmt: skip
"""What the model must give, SI."""
COLUMNS = ("part", "number", *TARGETS, "stopped", "inputs")
"""Columns of the table: the strike (the design gives its delivery), its results, and a checksum of its inputs: the row
is run again where the design gives its number to another strike."""
FREE = sum(each.group != "attachment" for each in inputs().values())
"""Number of inputs of a free head, which come first: all strikes of the tables are of one."""
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
    results
        ``TARGETS`` by the finite elements, shape (strikes, targets).
    """

    part: NDArray[Any]
    inputs: NDArray[Any]
    friction: NDArray[Any]
    results: NDArray[Any]

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
    sums = {place: _sum([*inputs[:FREE], planned[place].friction]) for place, inputs in shots.items()}

    def one(place: Place, keep_going: Any, threads: int) -> Row:
        strike_of = int(place[0]), int(place[1])
        return {**_row(strike_of, planned[strike_of], ball, keep_going), "inputs": sums[strike_of]}

    job = Job(
        "strikes", [(float(part), float(number)) for part, number in planned], one,
        accepts=lambda place, row: row["inputs"] == sums[int(place[0]), int(place[1])],
    )  # fmt: skip
    columns = {**dict.fromkeys(COLUMNS, float), "stopped": str, "inputs": str}
    rows = run_table(job, path, {"ball": ball.values()}, columns, workers=workers, progress=progress)
    pairs = [(place, row) for place, row in zip(planned, rows, strict=True) if not row["stopped"]]
    return Strikes(
        np.array([place[0] for place, _ in pairs]),
        np.array([shots[place] for place, _ in pairs]),
        np.array([planned[place].friction for place, _ in pairs]),
        np.array([[row[name] for name in TARGETS] for _, row in pairs]),
    )


def in_fit(strikes: Strikes, parts: Mapping[str, Part]) -> NDArray[Any]:
    """Return which strikes the coefficients are fitted to: those that are not held out."""
    return np.isin(strikes.part, [place for place, part in enumerate(parts.values()) if not part.held_out])


def of_clubs(strikes: Strikes, parts: Mapping[str, Part]) -> NDArray[Any]:
    """Return which strikes are with built-in clubs."""
    return np.isin(strikes.part, [place for place, part in enumerate(parts.values()) if part.built_in])


def _sum(values: Iterable[float]) -> str:
    """Return a text that tells inputs apart; another machine may differ in their last digits."""
    return fingerprint([f"{value + 0.0:.{DIGITS}g}" for value in values])[:8]


def _row(place: tuple[int, int], planned: Strike, ball: Ball, keep_going: Any) -> dict[str, Any]:
    club, delivery, friction = planned
    with without_warnings():
        impact = strike(club, delivery, ball=ball, friction=friction, settings=_SETTINGS, progress=keep_going)
    out = impact.outcome()
    results = {name: float(f"{out[name]:.{DIGITS}g}") for name in TARGETS}
    return {"part": float(place[0]), "number": float(place[1]), **results, "stopped": impact.stopped or ""}


MODEL = "response"
GIVEN = "friction"
"""The parameter that each strike has a value of its own for."""
SPEED_SHARE, SPIN_SHARE, SPIN_LEAST, TIME_SHARE, FORCE_SHARE = 0.003, 0.01, 2.0, 0.05, 0.03
"""Deviations that count alike: of velocity and spin as shares of their size, with a least one of spin [rad/s]."""
RIDGE = 0.02
"""Residual of a coefficient of one, in these deviations: keeps those that no strike determines near zero."""
CLUB_WEIGHT = 2.5
"""Weight of a strike with a built-in club; that of one with any head is 1."""
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
    results = strikes.results
    speed, spin = (np.linalg.norm(results[:, part], axis=1) for part in (slice(0, 3), slice(3, 6)))
    spin = np.maximum(SPIN_SHARE * spin, SPIN_LEAST)
    each = [SPEED_SHARE * speed] * 3 + [spin] * 3 + [TIME_SHARE * results[:, 6], FORCE_SHARE * results[:, 7]]
    return np.stack(each, axis=1)


def weights(strikes: Strikes, of_clubs: NDArray[Any]) -> NDArray[Any]:
    """Return the weights of the strikes, given which are with built-in clubs."""
    return np.where(of_clubs, CLUB_WEIGHT, np.clip(effective_mass(strikes) / LIGHT, 0.2, 1.0))


def effective_mass(strikes: Strikes) -> NDArray[Any]:
    """Return the masses [kg] as which the heads resist the ball, from the impulse that the ball took at a flat face."""
    names = list(inputs())
    masses = []
    for row in strikes.inputs:
        head = dict(zip(names, row, strict=True))
        turn = turn_to_sole(head["static_loft"])
        inertia = np.array(
            [
                [head["ixx"], head["ixy"], head["ixz"]],
                [head["ixy"], head["iyy"], head["iyz"]],
                [head["ixz"], head["iyz"], head["izz"]],
            ]
        )
        inertia = turn.T @ inertia @ turn
        lever = turn.T @ np.array([head["cg_x"], head["cg_y"], head["cg_z"]])
        point = face_point(head["toe"], head["high"], head["bulge"], head["roll"])
        arm = np.cross(lever + point, nearest(point, head["bulge"], head["roll"])[1])
        masses.append(1.0 / (1.0 / head["club_mass"] + arm @ np.linalg.solve(inertia, arm)))
    return np.array(masses)


def fit(
    strikes: Strikes, weight: NDArray[Any], *, progress: Callable[[float], object] | None = None
) -> dict[str, float]:
    """Return the coefficients that fit the strikes best.

    The search begins with those of the registry, which stay where no others fit better.
    """
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
            residual = np.concatenate([((values - strikes.results) / scale).ravel(), RIDGE * x[terms]])
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
    chosen = best.x if cost(best.fun) < (1.0 - CONVERGED) * first else start
    return dict(zip(names, map(float, chosen), strict=True))


RESIDUAL_SPIN_SHARE, RESIDUAL_SPIN_LEAST = 0.02, 40.0 * math.pi / 30.0
"""A spin is met within this share of itself, or within this much [rad/s]."""
PERCENTILES = (50, 95, 100)
MASSES = (0.0, 0.12, 0.2, math.inf)
"""Ends of the classes of effective mass [kg] by which differences with any heads are listed, too."""


def differences(values: Mapping[str, float], strikes: Strikes) -> dict[str, NDArray[Any]]:
    """Return how far the model with some coefficients is from the finite elements, one value a strike.

    ``speed`` [1] of ball speed, ``direction`` [rad] the angle between the launches, ``spin`` [1] the difference of the
    spins' sizes and ``spin_vector`` that of the vectors, over 2% of the spin or 40 rpm, whichever is larger;
    ``contact_time`` and ``peak_force`` [1].
    """
    got, _ = simulated(values, strikes, fitted()[:1])
    want = strikes.results
    size = np.linalg.norm
    speeds, spins = (tuple(size(each[:, part], axis=1) for each in (got, want)) for part in (slice(0, 3), slice(3, 6)))
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
    percentiles = {}
    for place, (name, part) in enumerate(parts.items()):
        of_part = strikes.where(strikes.part == place)
        each, groups = differences(values, of_part), {name: np.arange(len(of_part.friction))}
        if part.held_out and not part.built_in:
            masses = effective_mass(of_part)
            for least, most in pairwise(MASSES):
                groups[f"{name}, {_class(least, most)}"] = np.flatnonzero((masses >= least) & (masses < most))
        for group, chosen in groups.items():
            percentiles[group] = {
                key: [float(np.percentile(column[chosen], p)) for p in PERCENTILES] for key, column in each.items()
            }
    return percentiles


def _class(least: float, most: float) -> str:
    if not least:
        return f"below {most:g} kg"
    return f"{least:g} kg and more" if math.isinf(most) else f"{least:g} to {most:g} kg"


def figure(values: Mapping[str, float], strikes: Strikes, parts: Mapping[str, Part]) -> Figure:
    """Draw what share of the held-out strikes is within a difference, for ball speed, direction and spin."""
    drawn = Figure(figsize=(8.0, 3.4), layout="constrained")
    panels = drawn.subplots(1, 3, sharey=True)
    quantities = {
        "speed": ("difference of ball speed, %", 100.0, 0.5),
        "direction": ("angle between launches, degrees", 180.0 / math.pi, 0.2),
        "spin": ("difference of spin over 2% or 40 rpm", 1.0, 1.0),
    }
    for place, (name, part) in enumerate(parts.items()):
        if not part.held_out:
            continue
        off = differences(values, strikes.where(strikes.part == place))
        for panel, (key, (_, size, _)) in zip(panels, quantities.items(), strict=True):
            ordered = np.sort(off[key]) * size
            panel.plot(ordered, np.arange(1, len(ordered) + 1) / len(ordered), label=name)
    legend_above(drawn, panels[0].get_lines())
    for panel, (text, _, asked) in zip(panels, quantities.values(), strict=True):
        panel.axvline(asked, color="0.6", linewidth=0.8)
        panel.axhline(0.95, color="0.6", linewidth=0.8)
        panel.set_xlim(0.0, 4.0 * asked)
        panel.xaxis.set_major_locator(MaxNLocator(4))
        panel.set_xlabel(text)
    panels[0].set_ylabel("share of the strikes")
    return drawn


def main(arguments: list[str]) -> int:
    """Run, fit and write; return the exit status."""
    if len(arguments) != 2:
        print("usage: python studies/response_fit.py BALL FOLDER", file=sys.stderr)
        return 2
    name, folder = arguments[0], Path(arguments[1])

    def tell(done: int, whole: int) -> None:
        if done % 100 == 0 or done == whole:
            print(f"{done} of {whole} strikes", file=sys.stderr, flush=True)

    try:
        meshed, described = ball(name), rigid_ball(name)
        strikes = run(meshed, PARTS, folder / f"{meshed.name}.csv", progress=tell)
        used = strikes.where(in_fit(strikes, PARTS))
        values = fit(used, weights(used, of_clubs(used, PARTS)))
        values = {name: float(f"{value:.6g}") for name, value in values.items()}
        left = summary(values, strikes, PARTS)
        own = {**described.parameters, MODEL: {**described.parameters.get(MODEL, {}), **values}}
        write_text(folder / f"{meshed.name}.toml", replace(described, parameters=own).to_toml())
        write_text(folder / f"{meshed.name}.json", json.dumps(left, indent=1) + "\n")
        save(figure(values, strikes, PARTS), folder / f"{meshed.name}.svg")
    except KeyboardInterrupt as stopped:
        print(f"interrupted: {stopped}", file=sys.stderr)
        return 130
    except (ClubfaceError, OSError) as error:
        print(f"response_fit: {error}", file=sys.stderr)
        return 2
    for part, quantities in left.items():
        text = "  ".join(f"{name} {'/'.join(f'{each:.4f}' for each in row)}" for name, row in quantities.items())
        print(f"{part}, percentiles {PERCENTILES}: {text}")
    print(folder / f"{meshed.name}.toml")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
