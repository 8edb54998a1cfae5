"""Pictures of finite element impacts: P2's Figs. 3 to 8 redrawn, with P2's numbers marked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from clubface import units
from clubface.fem.paper import PUBLISHED
from clubface.fem.result import Impact
from clubface.plots.style import COLOURS, WIDTH, styled

BLUE, RED, GREEN = COLOURS[0], COLOURS[1], COLOURS[2]
MARK: dict[str, Any] = {"color": "0.35", "marker": "x", "linestyle": "none", "label": "P2"}
RPM = units.from_si(1.0, "rpm")


@styled
def paper_figure(found: Impact, *, title: str | None = None) -> Figure:
    """Draw velocities, forces, spin and effective radius over time (P2, Figs. 3, 4, 6, 7)."""
    figure, panels = plt.subplots(2, 3, figsize=(WIDTH, 4.2), layout="constrained", sharex=True)
    speed, force, radius, tangential, sliding, spin = panels.flat
    time, motion = found.contact["time"] * 1e6, found.motion
    when = motion["time"] * 1e6
    world = found.world_velocity()
    speed.plot(when, np.linalg.norm(world, axis=1), color=BLUE)
    _mark(speed, when[-1], PUBLISHED["ball_speed_mps"])
    _name(speed, "ball speed (m/s)", "Fig. 3")
    force.plot(time, found.contact["normal"] / 1e3, color=BLUE)
    force.plot(time, found.contact["tangential"] / 1e3, color=RED)
    _mark(force, PUBLISHED["peak_force_time_s"] * 1e6, PUBLISHED["peak_force_n"] / 1e3)
    _name(force, "normal, tangential force (kN)", "Fig. 4")
    radius.plot(when, motion["radius"] * 1e3, color=BLUE)
    least = found.ball.diameter * 500.0 * (1.0 - PUBLISHED["contraction"])
    _mark(radius, PUBLISHED["contraction_time_s"] * 1e6, least)
    last = found.contact_time * 1e6
    inside = when <= last
    radius.set_ylim(0.97 * min(least, motion["radius"].min() * 1e3), 1.02 * motion["radius"][inside].max() * 1e3)
    _name(radius, "mass centre to face (mm)", "Fig. 7")
    tangential.plot(time, found.contact["tangential"], color=RED)
    tangential.axhline(0.0, color="0.6", linewidth=0.6)
    _mark(tangential, PUBLISHED["reversal_time_s"] * 1e6, 0.0)
    _name(tangential, "tangential force (N)", "Fig. 6, top")
    sliding.plot(when, motion["velocity"][:, 1], color=GREEN)
    _mark(sliding, 0.0, 7.0)
    _mark(sliding, last, 5.15)
    _name(sliding, "velocity along the face (m/s)", "Fig. 6, middle")
    spin.plot(when, motion["spin"][:, 2] * RPM, color=GREEN)
    _mark(spin, last, PUBLISHED["spin_rpm"])
    _name(spin, "backspin (rpm)", "Fig. 6, bottom")
    for panel in panels[1]:
        panel.set_xlabel("time (µs)")
    force.legend(loc="upper right")
    if title:
        figure.suptitle(title, fontsize=8.5, x=0.01, ha="left")
    return figure


@styled
def patch_figure(found: Impact, *, every: float = 120e-6) -> Figure:
    """Draw normal and tangential forces over the contact patch at times ``every`` [s] apart (P2, Fig. 5)."""
    patch = found.patch
    moments = np.unique(patch["time"])
    chosen = [moments[np.argmin(abs(moments - t))] for t in np.arange(every / 2, found.contact_time, every / 2)][:8]
    chosen = list(dict.fromkeys(chosen))
    figure, panels = plt.subplots(
        2, len(chosen), figsize=(WIDTH, 3.4), layout="constrained", sharex=True, sharey=True, squeeze=False
    )
    extent = 1e3 * max(abs(patch["up"]).max(), abs(patch["toe"]).max()) * 1.1
    for row, (key, map_) in enumerate((("normal", "viridis"), ("tangential", "RdBu_r"))):
        high = abs(patch[key]).max()
        low = -high if key == "tangential" else 0.0
        for panel, moment in zip(panels[row], chosen, strict=True):
            at = patch["time"] == moment
            points = patch["toe"][at] * 1e3, patch["up"][at] * 1e3
            panel.scatter(*points, c=patch[key][at], s=9, cmap=map_, vmin=low, vmax=high)
            panel.set(aspect="equal", xlim=(-extent, extent), ylim=(-extent, extent))
            if row == 0:
                panel.set_title(f"{moment * 1e6:.0f} µs")
        figure.colorbar(panels[row][0].collections[0], ax=panels[row], label=f"{key} force of a node (N)", shrink=0.8)
        panels[row][0].set_ylabel("up the face (mm)")
    figure.supxlabel("to the toe (mm)", fontsize=8)
    return figure


@styled
def sweep_figure(rows: Sequence[Mapping[str, Any]]) -> Figure:
    """Draw ball speed, launch angle, spin and compression factor over speed and loft (P2, Fig. 8)."""
    figure, panels = plt.subplots(2, 2, figsize=(WIDTH, 4.6), layout="constrained", sharex=True)
    shown = (
        ("ball_speed_mps", "ball speed (m/s)"), ("launch_deg", "launch angle (deg)"),
        ("spin_rpm", "backspin (rpm)"), ("f", "compression factor f"),
    )  # fmt: skip
    lofts = sorted({row["loft_deg"] for row in rows})
    for panel, (key, label) in zip(panels.flat, shown, strict=True):
        for index, loft in enumerate(lofts):
            points = sorted((row["speed_mps"], row[key]) for row in rows if row["loft_deg"] == loft)
            colour = COLOURS[index % len(COLOURS)]
            panel.plot(*zip(*points, strict=True), color=colour, marker="o", markersize=3, label=f"{loft:g} deg")
        panel.set_title(label)
    for panel in panels[1]:
        panel.set_xlabel("clubhead speed (m/s)")
    panels[0][0].legend(title="loft", ncols=2)
    return figure


def _mark(panel: Any, x: float, y: float) -> None:
    panel.plot([x], [y], **MARK)


def _name(panel: Any, label: str, where: str) -> None:
    panel.set_title(f"{label}   P2 {where}")
