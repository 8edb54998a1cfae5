"""Fit the core of the ball `modern-2026` to published plate tests, and tell what they leave open: `make ball-fit`.

Free are the modulus c10 of the core, and the modulus and time of its Maxwell branch; all else is as in the ball's file.
It prints figures next to targets, the standard deviations and correlations of the fit, and the spins that a cover at
the ends of its published range gives, since no plate test determines it. No shot is used.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import least_squares

from clubface import Club, club, fem, units
from clubface.fem.materials import Material, Maxwell
from clubface.schema import Document

NAMES = {"c10 of the core, MPa": 9.0, "modulus of its branch": 0.4, "time of its branch, us": 80.0}
"""What is free, and where the search begins."""
COVER_RANGE, COVER_MIDDLE = (200.0, 450.0), 325.0
"""Young's modulus [MPa] published for ionomers, and what the ball has."""
# With rigid faces: what differs is the ball.
CLUBS = {name: club(name).replace(characteristic_time=0.0) for name in ("driver", "7-iron", "pitching-wedge")}
SHOTS = {
    "driver": {"speed": "113 mph", "attack": "-1.3 deg", "loft": "12.8 deg"},
    "7-iron": {"speed": "82 mph", "attack": "-3 deg", "loft": "25.5 deg"},
    "pitching-wedge": {"speed": "83 mph", "attack": "-5 deg", "loft": "38 deg"},
}
END = fem.Settings(until_separation=True, threads=1)
HEAD = Club(
    name="rigid head of 200 g", kind="iron", mass=0.2, cg_x=0.03, cg_y=0.0, cg_z=0.0, loft=0.0, bulge="flat",
    roll="flat", face_width="90 mm", face_height="70 mm", ixx=0.05, iyy=0.05, izz=0.05, ixy=0.0, ixz=0.0, iyz=0.0,
)  # fmt: skip
DIMENSIONS = {"restitution": units.DIMENSIONLESS, "contact time": "time", "peak force": "force"}


def targets() -> list[dict[str, Any]]:
    """Return the targets, SI."""
    rows = Document.read(Path(__file__).with_suffix(".toml")).data["target"]
    for each in rows:
        each["speed"] = units.parse(each["speed"], "speed")
        for key in ("value", "deviation"):
            each[key] = units.parse(each[key], DIMENSIONS[each["quantity"]])
    return rows


def ball(values: Any, cover: float = COVER_MIDDLE) -> fem.Ball:
    """Return the ball with other values of ``NAMES`` and another Young's modulus of the cover [MPa]."""
    made = fem.ball("modern-2026")
    core, around = made.pieces
    constants = {**core.material.constants, "c10": values[0] * 1e6}
    branch = Maxwell(values[1], values[2] * 1e-6)
    stiff = Material.linear(cover * 1e6, around.material.poisson, around.material.density)
    return replace(
        made,
        pieces=(
            replace(core, material=replace(core.material, constants=constants, maxwell=(branch,))),
            replace(around, material=stiff),
        ),
    )


def run_impact(made: fem.Ball, against: str, speed: float) -> dict[str, float]:
    """Run one normal impact; return its figures, SI."""
    if against == "plate":
        result = fem.throw(made, speed=speed, settings=END)
        rebound = result.normal_velocity
    else:
        result = fem.strike(HEAD, ball=made, speed=speed, settings=END)
        rebound = result.launch.ball_speed - result.launch.club_velocity_x
    return {
        "restitution": float(rebound / speed),
        "contact time": result.contact_time,
        "peak force": result.peak_force,
    }


def figures(made: fem.Ball, wanted: list[dict[str, Any]]) -> list[float]:
    """Return what the ball gives for each target, one run a core at a time."""
    runs = list(dict.fromkeys((each["against"], each["speed"]) for each in wanted))
    with ThreadPoolExecutor() as pool:
        results = dict(zip(runs, pool.map(lambda run: run_impact(made, *run), runs), strict=True))
    return [results[each["against"], each["speed"]][each["quantity"]] for each in wanted]


def main() -> None:
    """Fit, and print."""
    wanted = targets()

    def misfit(logarithms: Any) -> Any:
        fitted = figures(ball(np.exp(logarithms)), wanted)
        return [(value - each["value"]) / each["deviation"] for value, each in zip(fitted, wanted, strict=True)]

    fit = least_squares(misfit, np.log(list(NAMES.values())), diff_step=0.03, max_nfev=6)
    values = np.exp(fit.x)
    print("target                                 wanted            fitted   over deviation")
    for each, residual in zip(wanted, fit.fun, strict=True):
        unit = {"contact time": "us", "peak force": "kN"}.get(each["quantity"], "1")
        value, deviation = (units.from_si(each[key], unit) for key in ("value", "deviation"))
        what = f"{each['quantity']}, {each['against']}, {each['speed']:.1f} m/s"
        print(f"{what:34} {value:8.3f} +- {deviation:6.3f} {value + residual * deviation:9.3f} {residual:8.1f}")
    covariance = np.linalg.inv(fit.jac.T @ fit.jac)
    deviations = np.sqrt(np.diag(covariance))
    print(f"\nsum of squares {2.0 * fit.cost:.1f} with {len(wanted) - len(values)} degrees of freedom")
    for name, value, deviation in zip(NAMES, values, deviations, strict=True):
        low, high = value * np.exp([-1.96 * deviation, 1.96 * deviation])
        doubt = "; hardly determined" if deviation > 0.15 else ""
        print(f"{name:24} {value:8.3f}   95%: {low:.3g} to {high:.3g}{doubt}")
    print("correlations", *np.round((covariance / np.outer(deviations, deviations))[np.triu_indices(3, 1)], 2))
    print("\nwith a cover of, MPa      " + "".join(f"{name:>16}" for name in ("restitution", *SHOTS)))
    for cover in (COVER_RANGE[0], COVER_MIDDLE, COVER_RANGE[1]):
        made = ball(values, cover)
        restitution = run_impact(made, "plate", 38.1)["restitution"]
        spins = [fem.strike(CLUBS[name], shot, ball=made, settings=END).launch.get("backspin", "rpm")
                 for name, shot in SHOTS.items()]  # fmt: skip
        print(f"{cover:18.0f}        {restitution:16.3f}" + "".join(f"{spin:12.0f} rpm" for spin in spins))


if __name__ == "__main__":
    main()
