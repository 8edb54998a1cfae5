"""Fit the ball `modern` to plates, start angles and spins at measured launch: `make ball-shear-fit`.

Normal impacts (`ball_fit.py`) say nothing of the shear of a ball, and an elastic cover gives back too much of it. Here
the cover has a Maxwell branch too, which takes away from what the ball gives back of the shear it stores. Published
spins at one launch differ by more than their noise from source to source, so each source has an unknown error of its
own. It prints figures next to targets, the posterior of Laplace's approximation, and how the spin of an iron
moves without one of the sources, and keeps them in docs/finite-elements/ball-fit.json.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import ball_fit
import numpy as np
from ball_fit import END
from scipy.optimize import least_squares

from clubface import club, fem, impact, units
from clubface.fem.materials import Maxwell
from clubface.schema import Document

FREE = {
    "c10 of the core, MPa": (9.0, 1.0),
    "modulus of its branch": (0.38, 0.4),
    "time of its branch, us": (85.0, 0.35),
    "Young's modulus of the cover, MPa": (325.0, 0.2),
    "modulus of the cover's branch": (0.4, 1.0),
    "time of the cover's branch, us": (45.0, 0.7),
}
"""What is free: where the search begins, and the prior deviation of the logarithm. The modulus of the cover is
published as 200 to 450 MPa for ionomers; the other priors are wide."""
GROUP_DEVIATION = 0.12
"""Deviation of the logarithm of the spins of one source: robots, golfers and tours differ by a quarter at the same
launch and speed."""
SLIP = {"speed": "88 mph", "attack": "-4 deg", "loft": "25 deg"}
"""A 7-iron shot like those of Caldwell and McPhee, whose `slip` parameters give the spin that they measured."""
SLIP_DEVIATION = 0.09
"""The mean absolute error of `slip` in their backspin, as a share."""
WIDTH = units.parse("1.5 deg", "angle")
"""Half of the difference of the two lofts between which the one with the measured launch is interpolated."""


UNITS = {"contact time": "us", "peak force": "kN"}
"""In which figures are printed that have a unit."""
KEPT = Path(__file__).parents[1] / "docs" / "finite-elements" / "ball-fit.json"
"""What the page of the ball quotes."""


def relaxing_ball(values: Any) -> fem.Ball:
    """Return the ball `modern` with other values of ``FREE``."""
    made = ball_fit.ball(values, values[3])
    core, cover = made.pieces
    relaxing = replace(cover.material, maxwell=(Maxwell(values[4], values[5] * 1e-6),))
    return replace(made, pieces=(core, replace(cover, material=relaxing)))


def tangential_restitution(made: fem.Ball, target: Mapping[str, Any]) -> float:
    """Return the tangential restitution of a ball thrown at a plate without spin."""
    speed, angle = units.parse(target["speed"], "speed"), units.parse(target["angle"], "angle")
    rebound = fem.throw(made, speed=speed, angle=angle, friction=target["friction"], settings=END)
    slip = rebound.tangential_velocity - rebound.backspin * 0.5 * made.diameter
    return -slip / (speed * math.sin(angle))


def start_share(made: fem.Ball, target: Mapping[str, Any]) -> float:
    """Return the share of the way from attack angle to dynamic loft at which the ball starts."""
    attack, loft = (units.parse(target[name], "angle") for name in ("attack", "loft"))
    delivery = {name: target[name] for name in ("speed", "attack", "loft")}
    shot = fem.strike(club(target["club"]), delivery, ball=made, settings=END).launch
    return float((shot.launch - attack) / (loft - attack))


class SpinAtLaunch:
    """The spin of a ball at a measured launch; remembers the loft of the last ball, where the next search begins."""

    def __init__(self, target: Mapping[str, Any]) -> None:
        self.target = target
        self.launch = units.parse(target["launch"], "angle")
        attack = units.parse(target["attack"], "angle")
        self.loft = self.launch + 0.28 * (self.launch - attack)
        self.measured = units.parse(target["spin"], "angular rate") / target.get("scatter", 1.0)

    def error(self, made: fem.Ball) -> float:
        """Return the logarithm of computed over measured spin, interpolated between two lofts."""
        delivery = {name: self.target.get(name, 0.0) for name in ("speed", "attack", "high")}
        ends = []
        for loft in (self.loft - WIDTH, self.loft + WIDTH):
            strike = fem.strike(club(self.target["club"]), {**delivery, "loft": loft}, ball=made, settings=END)
            ends.append((float(strike.launch.launch), float(strike.launch.total_spin)))
        (low, least), (high, most) = ends
        share = (self.launch - low) / (high - low)
        self.loft += WIDTH * (2.0 * share - 1.0)
        return math.log((least + share * (most - least)) / self.measured)


class Fit:
    """Targets, and how far a ball is from them."""

    def __init__(self) -> None:
        data = Document.read(Path(__file__).with_suffix(".toml")).data
        self.normal, self.oblique, self.shares = ball_fit.targets(), data["target"], data["share"]
        self.shots = [SpinAtLaunch(each) for each in data["shots"]]
        self.slip = float(impact("7-iron", model="slip", **SLIP).total_spin)
        self.groups = [*(each.target["group"] for each in self.shots), "Caldwell and McPhee"]
        noise = [*(each.target["deviation"] for each in self.shots), SLIP_DEVIATION]
        same = np.array([[one == other for other in self.groups] for one in self.groups])
        self.covariance = np.diag(np.square(noise)) + GROUP_DEVIATION**2 * same
        self.whiten = np.linalg.inv(np.linalg.cholesky(self.covariance))

    def figures(self, logarithms: Any) -> tuple[list[float], list[float], list[float], list[float]]:
        """Return figures of normal and oblique impacts, shares, and errors of spins, one run a core at a time."""
        made = relaxing_ball(np.exp(logarithms))
        with ThreadPoolExecutor() as pool:
            oblique = [pool.submit(tangential_restitution, made, each) for each in self.oblique]
            shares = [pool.submit(start_share, made, each) for each in self.shares]
            spins = [pool.submit(each.error, made) for each in self.shots]
            iron = pool.submit(fem.strike, club("7-iron"), SLIP, ball=made, settings=END)
        errors = [*(job.result() for job in spins), math.log(float(iron.result().launch.total_spin) / self.slip)]
        normal = ball_fit.figures(made, self.normal)
        return normal, [job.result() for job in oblique], [job.result() for job in shares], errors

    def residuals(self, logarithms: Any) -> Any:
        """Return all residuals over their deviations: impacts, shares, whitened spins, priors."""
        normal, oblique, shares, errors = self.figures(logarithms)
        known = [*zip(normal, self.normal, strict=True), *zip(oblique, self.oblique, strict=True)]
        known += zip(shares, self.shares, strict=True)
        prior = [(x - math.log(middle)) / wide for x, (middle, wide) in zip(logarithms, FREE.values(), strict=True)]
        return np.concatenate(
            [[(value - each["value"]) / each["deviation"] for value, each in known], self.whiten @ errors, prior]
        )


def main() -> None:
    """Fit, print, and keep what is printed."""
    problem = Fit()
    start = np.log([middle for middle, _ in FREE.values()])
    fit = least_squares(problem.residuals, start, diff_step=0.02, max_nfev=5)
    normal, oblique, shares, errors = problem.figures(fit.x)
    targets = kept_targets(problem, normal, oblique, shares)
    print_targets(targets)
    covariance = np.linalg.inv(fit.jac.T @ fit.jac)
    spins = kept_spins(problem, errors, fit.jac, covariance)
    for each in spins:
        what = f"spin at measured launch, {each['club']}, {each['group']}"
        print(f"{what:70}{each['error_percent']:+7.1f}% +- {each['deviation_percent']:4.1f}%")
    deviations = np.sqrt(np.diag(covariance))
    print(f"\nsum of squares {2.0 * fit.cost:.1f}")
    constants = {}
    for name, value, deviation in zip(FREE, np.exp(fit.x), deviations, strict=True):
        low, high = value * np.exp([-1.96 * deviation, 1.96 * deviation])
        constants[name] = {"value": digits(value), "low": digits(low), "high": digits(high)}
        print(f"{name:36} {value:8.3f}   95%: {low:.3g} to {high:.3g}")
    print("correlations\n", np.round(covariance / np.outer(deviations, deviations), 2))
    without = moves_without_groups(problem, fit)
    print(f"\nspin of the {problem.shots[0].target['club']}")
    for group, percent in without.items():
        print(f"without {group:40} {percent:+6.1f}%")
    kept = {
        "targets": targets,
        "spins": spins,
        "constants": constants,
        "without_percent": without,
    }
    KEPT.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")


def digits(value: float) -> float:
    """Return a figure with the digits that are kept."""
    return float(f"{value:.5g}")


def kept_targets(problem: Fit, normal: Any, oblique: Any, shares: Any) -> list[dict[str, Any]]:
    """Return what impacts and start angles were fitted to, and what the ball gives, SI."""
    names = [f"{each['quantity']}, {each['against']}, {each['speed']:.1f} m/s" for each in problem.normal]
    names += [f"tangential restitution, {each['speed']}, {each['angle']}" for each in problem.oblique]
    names += [f"share of launch angle, {each['club']}" for each in problem.shares]
    targets, values = [*problem.normal, *problem.oblique, *problem.shares], [*normal, *oblique, *shares]
    return [
        {"of": name, "target": each["value"], "deviation": each["deviation"], "fit": digits(value)}
        for name, each, value in zip(names, targets, values, strict=True)
    ]


def print_targets(targets: list[dict[str, Any]]) -> None:
    """Print every target with its deviation, and what the ball gives."""
    for each in targets:
        unit = units.size(next((unit for what, unit in UNITS.items() if each["of"].startswith(what)), "1"))
        target, deviation, value = (each[key] / unit for key in ("target", "deviation", "fit"))
        print(f"{each['of']:52}{target:9.3f} +- {deviation:7.3f}{value:10.3f}")


def kept_spins(problem: Fit, errors: Any, jac: Any, covariance: Any) -> list[dict[str, Any]]:
    """Return computed less measured spin at each measured launch, and the posterior deviation of the computed one."""
    slopes = np.linalg.solve(problem.whiten, jac[spin_rows(problem)])
    deviations = 100.0 * np.sqrt(np.einsum("ij,jk,ik->i", slopes, covariance, slopes))
    clubs = [*(each.target["club"] for each in problem.shots), "7-iron"]
    return [
        {
            "group": group,
            "club": name,
            "error_percent": digits(100.0 * math.expm1(value)),
            "deviation_percent": digits(deviation),
        }
        for group, name, value, deviation in zip(problem.groups, clubs, errors, deviations, strict=True)
    ]


def moves_without_groups(problem: Fit, fit: Any) -> dict[str, float]:
    """Return by how many per cent the spin of the first shot moves without each group, to first order."""
    rows = spin_rows(problem)
    slopes, errors = (np.linalg.solve(problem.whiten, each[rows]) for each in (fit.jac, fit.fun))
    other_slopes, others = np.delete(fit.jac, rows, axis=0), np.delete(fit.fun, rows)
    moves = {}
    for group in dict.fromkeys(problem.groups):
        kept = [place for place, each in enumerate(problem.groups) if each != group]
        whiten = np.linalg.inv(np.linalg.cholesky(problem.covariance[np.ix_(kept, kept)]))
        jac = np.vstack([other_slopes, whiten @ slopes[kept]])
        step = -np.linalg.lstsq(jac, np.concatenate([others, whiten @ errors[kept]]), rcond=None)[0]
        moves[group] = digits(100.0 * float(slopes[0] @ step))
    return moves


def spin_rows(problem: Fit) -> Any:
    """Return the rows of the residuals that hold the whitened errors of spins."""
    first = len(problem.normal) + len(problem.oblique) + len(problem.shares)
    return np.arange(first, first + len(problem.groups))


if __name__ == "__main__":
    main()
