"""Pictures of any finite element impact: histories, and forces over the patch."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from clubface import units
from clubface.fem.result import Impact
from clubface.plots.style import COLOURS, DASHES, WIDTH, styled

BLUE, RED, GREEN = COLOURS[0], COLOURS[1], COLOURS[2]
EVERY = 120e-6
"""From one picture of the contact patch to the next [s]."""

ENERGIES = {
    "strain": "elastic", "viscous": "viscous", "plastic": "plastic", "friction": "friction", "damping": "damping",
    "hourglass": "hourglass", "contact": "contact springs",
}  # fmt: skip


@styled
def impact_figure(found: Impact) -> Figure:
    """Draw force, spin, effective radius and energies of any impact over time."""
    figure = Figure(figsize=(WIDTH, 4.3), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True)
    force, spin, radius, energy = panels.flat
    _forces(force, found)
    name_panel(force, "force on the ball (kN)")
    when = units.from_si(found.motion["time"], "us")
    spin.plot(when, units.from_si(found.motion["spin"][:, 2], "rpm"), color=GREEN)
    name_panel(spin, "backspin (rpm)")
    _radius(radius, found)
    name_panel(radius, "mass centre to face (mm)")
    _energies(energy, found)
    name_panel(energy, "where the kinetic energy goes (J)")
    time_axes(panels[1], end_of(found))
    force.legend(loc="upper right")
    return figure


@styled
def patch_figure(found: Impact) -> Figure:
    """Draw normal and tangential forces over the contact patch, as figure 5 of Roh and Lee.

    The moments are 0.12 ms apart. Positive tangential forces make backspin, negative ones take it away.
    """
    patch = found.patch
    moments = np.unique(patch["time"])
    wanted = np.arange(EVERY, found.last_touch - 0.25 * EVERY, EVERY)[:6]
    if not len(wanted):
        wanted = np.array([0.5 * found.last_touch])
    chosen = list(dict.fromkeys(float(moments[np.argmin(abs(moments - each))]) for each in wanted))
    count = len(chosen)
    size = min((WIDTH - 1.5) / count, 1.5)
    figure = Figure(figsize=(WIDTH, 2.0 * size + 1.05), layout="constrained")
    panels = figure.subplots(2, count, sharex=True, sharey=True, squeeze=False)
    drawn = np.isin(patch["time"], chosen)
    extent = units.from_si(1.1 * max(abs(patch[key][drawn]).max() for key in ("up", "toe")), "mm")
    dots = (size * 72.0 * 0.055) ** 2
    for row, (key, map_, label) in enumerate(
        (
            ("normal", "viridis", "normal force\nof a node (N)"),
            ("tangential", "RdBu_r", "tangential force\nof a node (N)"),
        )
    ):
        high = abs(patch[key][drawn]).max()
        low = -high if key == "tangential" else 0.0
        for panel, moment in zip(panels[row], chosen, strict=True):
            at = patch["time"] == moment
            points = units.from_si(patch["toe"][at], "mm"), units.from_si(patch["up"][at], "mm")
            panel.scatter(*points, c=patch[key][at], s=dots, cmap=map_, vmin=low, vmax=high, linewidths=0)
            panel.set(aspect="equal", xlim=(-extent, extent), ylim=(-extent, extent))
            if row == 0:
                panel.set_title(f"{units.from_si(moment, 'us'):.0f} µs")
        figure.colorbar(panels[row][0].collections[0], ax=list(panels[row]), label=label, fraction=0.05, pad=0.01)
        panels[row][0].set_ylabel("up the face (mm)")
    figure.supxlabel("towards the toe (mm); both from the ball's mass centre", fontsize=8)
    return figure


def end_of(found: Impact) -> float:
    """Return where the axis of time ends [us]: some time after the last touch, or with the run."""
    times = found.contact["time"]
    last = float(times[-1]) if len(times) else 0.0
    return units.from_si(max(min(1.25 * found.last_touch, last) or last, 1e-9), "us")


def time_axes(panels: Any, end: float) -> None:
    """Let the axes of time of panels go from 0 to an end [us]."""
    for panel in panels:
        panel.set_xlabel("time (µs)")
        panel.set_xlim(0.0, end)


def _forces(panel: Axes, found: Impact) -> None:
    time = units.from_si(found.contact["time"], "us")
    panel.plot(time, units.from_si(found.contact["normal"], "kN"), color=BLUE, label="normal")
    panel.plot(
        time, units.from_si(found.contact["tangential"], "kN"), color=RED, linestyle=DASHES[1], label="along the face"
    )
    panel.axhline(0.0, color="0.5", linewidth=0.6, zorder=1)
    top = units.from_si(float(np.max(found.contact["normal"], initial=0.0)), "kN")
    low = units.from_si(float(np.min(found.contact["tangential"], initial=0.0)), "kN")
    if top > 0.0:
        panel.set_ylim(1.1 * min(low, -0.02 * top), 1.3 * top)


def _energies(panel: Axes, found: Impact) -> None:
    """Stack the energies other than kinetic; a line shows how much kinetic energy is missing, which they must fill."""
    energy = found.energy
    shown = {key: energy[key] for key in ENERGIES if np.max(energy[key], initial=0.0) > 0.0}
    if not shown:
        return
    times = units.from_si(energy["time"], "us")
    colours = [COLOURS[index % len(COLOURS)] for index in (0, 6, 5, 1, 2, 3)]
    panel.stackplot(times, *shown.values(), labels=[ENERGIES[key] for key in shown], colors=colours, alpha=0.75)
    missing = energy["kinetic"][0] - energy["kinetic"]
    panel.plot(times, missing, color="k", linewidth=0.9, label="kinetic, given up")
    panel.set_ylim(0.0, 1.4 * max(float(np.max(missing)), 1e-12))
    panel.legend(ncols=3, loc="upper center", columnspacing=1.0, handlelength=1.2)


def _radius(panel: Axes, found: Impact) -> None:
    radius = units.from_si(0.5 * found.ball.diameter, "mm")
    from_face = units.from_si(found.motion["radius"], "mm")
    panel.plot(units.from_si(found.motion["time"], "us"), from_face, color=BLUE)
    panel.axhline(radius, color="0.5", linewidth=0.6, zorder=1)
    panel.set_ylim(float(np.min(from_face, initial=radius)) - 0.08 * radius, radius * 1.05)


def name_panel(panel: Axes, label: str, where: str = "") -> None:
    """Write what a panel shows above it, and on the right where it is found."""
    panel.set_title(label, loc="left")
    if where:
        panel.set_title(where, loc="right", fontsize=7.0, color="0.4")
