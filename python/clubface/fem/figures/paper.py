"""Pictures of the case of Roh and Lee: their figures 3, 4, 6, 7 and 8, with their numbers marked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from clubface import units
from clubface.errors import InputError
from clubface.fem.figures.impact import BLUE, GREEN, RED, end_of, name_panel, time_axes
from clubface.fem.paper import LEAST_FACTOR, PUBLISHED, SPEED, section_spin
from clubface.fem.result import Impact
from clubface.plots.style import COLOURS, DASHES, MARKERS, WIDTH, styled

MARK: dict[str, Any] = {"color": "0.25", "marker": "x", "markersize": 5.0, "linestyle": "none", "zorder": 5}
GREY = "0.55"


@styled
def paper_figure(runs: Mapping[str, Impact]) -> Figure:
    """Draw velocities, forces, spin and effective radius over time, as figures 3, 4, 6 and 7 of Roh and Lee.

    Their numbers are marked.

    Parameters
    ----------
    runs
        Runs of their case, or of one like it, by what the legend calls them.
    """
    figure = Figure(figsize=(WIDTH, 4.3), layout="constrained")
    panels = figure.subplots(2, 4, sharex=True)
    speed, launch, force, legend, radius, tangential, sliding, spin = panels.flat
    for (name, found), dash in zip(runs.items(), DASHES, strict=False):
        legend.plot([], [], color="0.2", linestyle=dash, label=name)
        _curves(panels.flat, found, dash)
    found = next(iter(runs.values()))
    end, last = end_of(found), units.from_si(found.last_touch, "us")
    undeformed = units.from_si(0.5 * found.ball.diameter, "mm")

    def when(key: str) -> float:
        return units.from_si(PUBLISHED[key], "us")

    for panel, marks in (
        (speed, ([end, end], [PUBLISHED["ball_speed_mps"], PUBLISHED["club_speed_after_mps"]])),
        (launch, ([end], [PUBLISHED["launch_deg"]])),
        (force, ([when("peak_force_time_s")], [units.from_si(PUBLISHED["peak_force_n"], "kN")])),
        (radius, ([when("contraction_time_s")], [undeformed * (1.0 - PUBLISHED["contraction"])])),
        (tangential, ([when("reversal_time_s")], [0.0])),
        (sliding, ([0.0, last], [PUBLISHED["tangential_first_mps"], PUBLISHED["tangential_last_mps"]])),
        (spin, ([last], [PUBLISHED["section_spin_rpm"]])),
    ):
        panel.plot(*marks, clip_on=False, **MARK)
    sliding.axvline(when("tangential_least_time_s"), color="0.25", linewidth=0.8, linestyle=":")
    for panel, label, where in (
        (speed, "speed (m/s)", "Fig. 3"), (launch, "launch angle (deg)", "Fig. 3"),
        (force, "normal force (kN)", "Fig. 4"), (radius, "mass centre\nto face (mm)", "Fig. 7"),
        (tangential, "force along\nthe face (N)", "Fig. 6"), (sliding, "velocity along\nthe face (m/s)", "Fig. 6"),
        (spin, "backspin (rpm)", "Fig. 6"),
    ):  # fmt: skip
        name_panel(panel, label, where)
    for panel, level in ((tangential, 0.0), (radius, undeformed)):
        panel.axhline(level, color="0.5", linewidth=0.6, zorder=1)
    radius.set_ylim(0.7 * undeformed, 1.05 * undeformed)
    time_axes(panels[1], end)
    legend.plot([], [], color=BLUE, label="ball")
    legend.plot([], [], color=RED, label="clubhead")
    legend.plot([], [], color=GREEN, label="all nodes")
    legend.plot([], [], color=GREY, label="nodes of a section")
    legend.plot([], [], label="Roh and Lee", **MARK)
    legend.set_axis_off()
    legend.legend(loc="center left", borderaxespad=0.0)
    return figure


def _curves(panels: Any, found: Impact, dash: Any) -> None:
    """Draw one run over time."""
    speed, launch, force, _, radius, tangential, sliding, spin = panels
    when = units.from_si(found.motion["time"], "us")
    step = units.from_si(found.contact["time"], "us")
    velocity = found.world_velocity()
    speed.plot(when, np.linalg.norm(velocity, axis=1), color=BLUE, linestyle=dash)
    speed.plot(when, np.linalg.norm(found.world_club_velocity(), axis=1), color=RED, linestyle=dash)
    # At first touch the ball rests and has no direction.
    angle = np.arctan2(velocity[1:, 1], np.hypot(velocity[1:, 0], velocity[1:, 2]))
    launch.plot(when[1:], units.from_si(angle, "deg"), color=BLUE, linestyle=dash)
    force.plot(step, units.from_si(found.contact["normal"], "kN"), color=BLUE, linestyle=dash)
    radius.plot(when, units.from_si(found.motion["radius"], "mm"), color=BLUE, linestyle=dash)
    tangential.plot(step, found.contact["tangential"], color=RED, linestyle=dash)
    sliding.plot(when, found.relative_velocity()[:, 1], color=BLUE, linestyle=dash)
    try:
        times, of_section = section_spin(found)
        spin.plot(units.from_si(times, "us"), units.from_si(of_section, "rpm"), color=GREY, linestyle=dash)
    except InputError:
        pass
    spin.plot(when, units.from_si(found.motion["spin"][:, 2], "rpm"), color=GREEN, linestyle=dash)


@styled
def sweep_figure(rows: Sequence[Mapping[str, Any]], *, published: bool = False) -> Figure:
    """Draw ball speed, launch angle, spin and compression factor over speed and loft, as figure 8 of Roh and Lee.

    Parameters
    ----------
    rows
        The rows of :func:`clubface.fem.sweep.sweep`.
    published
        Whether to mark their numbers: the case of 35 m/s and 11.5 deg, and the least compression factor.
    """
    figure = Figure(figsize=(WIDTH, 4.6), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True)
    shown = (
        ("ball_speed_mps", "ball_speed_mps", "ball speed (m/s)"), ("launch_deg", "launch_deg", "launch angle (deg)"),
        ("spin_rpm", "section_spin_rpm", "backspin (rpm)"), ("f", "f", "compression factor f"),
    )  # fmt: skip
    lofts = sorted({row["loft_deg"] for row in rows})
    for panel, (key, told, label) in zip(panels.flat, shown, strict=True):
        for index, loft in enumerate(lofts):
            points = sorted((row["speed_mps"], row[key]) for row in rows if row["loft_deg"] == loft)
            look = {"color": COLOURS[index % len(COLOURS)], "linestyle": DASHES[index % len(DASHES)]}
            look["marker"] = MARKERS[index % len(MARKERS)]
            panel.plot(*zip(*points, strict=True), markersize=3, label=f"{loft:.4g}°", **look)
        if published:
            panel.plot([SPEED], [PUBLISHED[told]], label="Roh and Lee, 11.5°", **MARK)
        name_panel(panel, label)
    if published:
        panels[1][1].axhline(LEAST_FACTOR, color="0.25", linewidth=0.8, linestyle=":", label="least of Roh and Lee")
        panels[1][1].legend(handles=panels[1][1].lines[-1:], loc="lower left")
    for panel in panels[1]:
        panel.set_xlabel("clubhead speed (m/s)")
    panels[0][0].legend(title="loft", ncols=2, loc="upper left")
    return figure
