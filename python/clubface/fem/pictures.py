"""Pictures of finite element impacts: histories, models side by side, faces, and the case of Roh and Lee.

Pictures of any finite element impact: histories, and forces over the patch.

A picture of one impact by the contact models and by finite elements, over time.

Pictures of restitution and characteristic time over a face.

Pictures of the case of Roh and Lee: their figures 3, 4, 6, 7 and 8, with their numbers marked.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from clubface import units
from clubface.equipment.models import models
from clubface.errors import InputError, Told
from clubface.fem.paper import LEAST_FACTOR, PUBLISHED, SPEED, section_spin
from clubface.fem.result import Impact
from clubface.plots import COLOURS, DASHES, MARKERS, WIDTH, legend_above, look, styled
from clubface.simulation.history import History, history

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


@styled
def models_figure(found: Impact) -> Figure:
    """Draw forces, the velocity of the ball along the face and its distance from the face, by every contact model.

    The contact models strike the same ball with the same head as a rigid body, and have the parameters published for
    its kind of club.

    Parameters
    ----------
    found
        A run with a head.
    """
    curves = {model: _of_model(found, contact) for model, contact in contacts(found).items()}
    figure = Figure(figsize=(WIDTH, 4.3), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True)
    labels = (
        "normal force (kN)",
        "force along the face (N)",
        "velocity along the face (m/s)",
        "mass centre to face, R (mm)",
    )
    for model, shown in {**curves, "fem": _of_elements(found)}.items():
        style = look(model) if model in curves else {"color": "0.6", "linewidth": 2.5, "zorder": 1.5}
        for panel, (times, values) in zip(panels.flat, shown, strict=True):
            panel.plot(units.from_si(times, "us"), values, label=model, **style)
    for panel, label in zip(panels.flat, labels, strict=True):
        name_panel(panel, label)
    panels[0][1].axhline(0.0, color="0.5", linewidth=0.6, zorder=1)
    radius = units.from_si(0.5 * found.ball.diameter, "mm")
    panels[1][1].axhline(radius, color="0.5", linewidth=0.6, zorder=1)
    panels[1][1].set_ylim(0.7 * radius, 1.05 * radius)
    time_axes(panels[1], end_of(found))
    legend_above(figure, panels[0][0].lines)
    return figure


def contacts(found: Impact) -> dict[str, History]:
    """Return the same impact by every contact model."""
    if found.equipment is None:
        raise InputError(
            "impact", Told("one with a plane"), "one with a head, which the contact models can strike with"
        )
    club, ball = found.equipment
    named = [name for name, each in models().items() if each.kind == "contact"]
    return {name: history(club, found.given, model=name, ball=ball) for name in named}


def _of_elements(found: Impact) -> list[tuple[Any, Any]]:
    contact, motion = found.contact, found.motion
    return [
        (contact["time"], units.from_si(contact["normal"], "kN")),
        (contact["time"], contact["tangential"]),
        (motion["time"], found.relative_velocity()[:, 1]),
        (motion["time"], units.from_si(motion["radius"], "mm")),
    ]


def _of_model(found: Impact, contact: History) -> list[tuple[Any, Any]]:
    """Return the curves of a contact model; directions along the face are those of first touch."""
    up = found.attitude @ found.axes[1]
    assert found.equipment is not None
    radius = found.equipment[1].radius
    along = (contact.ball_velocity - contact.club_velocity) @ up
    shown = (
        units.from_si(contact.normal_force, "kN"),
        np.negative(contact.force_y),
        along,
        units.from_si(radius - contact.penetration, "mm"),
    )
    return [(contact.time, values) for values in shown]


SHOWN = (("restitution", "restitution", "{:.3f}"), ("characteristic_time_us", "characteristic time (µs)", "{:.0f}"))


@styled
def face_figure(rows: Sequence[Mapping[str, Any]]) -> Figure:
    """Draw restitution and characteristic time over the face, seen from in front: the toe is on the right.

    Parameters
    ----------
    rows
        The rows of :func:`clubface.fem.head_tests.face_map`, over a grid.
    """
    toes, highs = (sorted({row[key] for row in rows}) for key in ("toe_mm", "high_mm"))
    figure = Figure(figsize=(WIDTH, 1.5 + 0.3 * len(highs)), layout="constrained")
    for panel, (key, label, text) in zip(figure.subplots(1, 2, sharey=True), SHOWN, strict=True):
        values = np.full((len(highs), len(toes)), np.nan)
        for row in rows:
            values[highs.index(row["high_mm"]), toes.index(row["toe_mm"])] = row[key]
        image = panel.imshow(values, origin="lower", aspect="auto", cmap="viridis")
        for (up, across), value in np.ndenumerate(values):
            # Black on the light end of the colours, white on the dark.
            light = not np.isfinite(value) or image.norm(value) > 0.6
            told = text.format(value) if np.isfinite(value) else "-"
            panel.text(across, up, told, ha="center", va="center", fontsize=7, color="black" if light else "white")
        panel.set_xticks(range(len(toes)), [f"{toe:g}" for toe in toes])
        panel.set_yticks(range(len(highs)), [f"{high:g}" for high in highs])
        panel.grid(visible=False)
        panel.set_title(label)
        panel.set_xlabel("towards the toe (mm)")
    figure.axes[0].set_ylabel("above the centre (mm)")
    return figure


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
