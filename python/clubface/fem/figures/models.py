"""A picture of one impact by the contact models and by finite elements, over time."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from clubface import units
from clubface.equipment.models import models
from clubface.errors import InputError, Told
from clubface.fem.figures.impact import end_of, name_panel, time_axes
from clubface.fem.result import Impact
from clubface.plots.style import WIDTH, legend_above, look, styled
from clubface.simulation.history import History, history


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
