"""The pictures of the paper that the documentation does not have: the CG of a driver, and errors of some checks."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle
from text_numbers import cg_readings, validation

from clubface import plots
from clubface.equipment.balls import published_ball
from clubface.equipment.models import DEFAULT_MODEL
from clubface.present.drawing import draw
from clubface.present.style import COLOURS, styled
from clubface.validation.run import validation_picture

COLUMN = 3.35
"""Inches of a column."""
CHECKS = (
    "tour-driver", "tour-woods", "tour-irons", "irons-at-launch", "drives-at-launch", "robot-irons", "launch-shares",
    "plates", "gear-effect",
)  # fmt: skip
MODELS = (DEFAULT_MODEL, "slip", "rings", "fem")


def draw_all(folder: Path) -> None:
    """Write the pictures into a folder."""
    plots.save(driver_cg(), folder / "driver-cg.svg")
    plots.save(errors(), folder / "errors.svg")


def errors() -> Figure:
    """Errors over their tolerances in some checks, by four models."""
    every = validation()
    chosen = tuple(each for each in every.checks if each.name in CHECKS)
    shown = replace(every, checks=chosen, figures={name: every.figures[name] for name in MODELS})
    picture = validation_picture(shown)
    return draw(replace(picture, height=0.8 * (picture.height or 0.0)))


@styled
def driver_cg() -> Figure:
    """The CG of the driver from its face centre, as printed, and as another paper has it, turned once and twice."""
    reading = cg_readings()
    figure = Figure(figsize=(COLUMN, 1.5))
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    normal = np.array([math.cos(reading.loft), math.sin(reading.loft)])
    draw_face(axes, normal, 1e3 * published_ball().radius)
    axes.plot(*zip(-58.0 * normal, 30.0 * normal, strict=True), color="0.5", linewidth=0.7, linestyle=(0, (6, 2, 1, 2)))
    axes.text(29.5, 7.0, "normal", color="0.35", fontsize=7, ha="right")
    angle = math.atan2(reading.face[1], reading.face[0])
    for vector, name, colour, lower in (
        (reading.face, "frame of\nthe face", COLOURS[8], 0.0), (reading.once, "turned once", COLOURS[0], 0.0),
        (reading.twice, "turned twice,\nas printed (×)", COLOURS[1], 4.0),
    ):  # fmt: skip
        axes.plot([-vector[0], 0.0], [-vector[1], 0.0], color=colour, linewidth=0.9)
        axes.plot(-vector[0], -vector[1], "o", color=colour, markersize=4.5)
        axes.text(-vector[0] - 2.2, -vector[1] - lower, name, ha="right", va="center", fontsize=7, color=colour,
                  linespacing=0.9)  # fmt: skip
    axes.plot(*-reading.printed, "x", color="black", markersize=7, markeredgewidth=1.1)
    for start in (angle, angle + reading.loft):
        draw_turn(axes, 33.0, start, reading.loft)
    axes.set(aspect="equal", xlim=(-73, 30), ylim=(-23, 23))
    axes.axis("off")
    return figure


def draw_face(axes: Axes, normal: np.ndarray, radius: float) -> None:
    """Draw the face, its centre at the origin, and the ball on it [mm]."""
    along = np.array([-normal[1], normal[0]])
    axes.plot(*zip(-18.0 * along, 18.0 * along, strict=True), color="0.3", linewidth=2.0, solid_capstyle="round")
    axes.add_patch(Circle(tuple(radius * normal), radius, facecolor="0.93", edgecolor="0.6", linewidth=0.6))
    axes.plot(0, 0, "o", color="0.1", markersize=2.5)


def draw_turn(axes: Axes, radius: float, start: float, angle: float) -> None:
    """Draw an angle of the vector and write its size; the vector points to the CG, opposite to ``start``."""
    degrees = 180.0 + math.degrees(start)
    ends = {"theta1": degrees, "theta2": degrees + math.degrees(angle)}
    axes.add_patch(Arc((0, 0), 2 * radius, 2 * radius, linewidth=0.7, **ends))
    middle = start + 0.5 * angle
    place = -(radius - 5.0) * np.array([math.cos(middle), math.sin(middle)])
    axes.text(place[0], place[1], f"{math.degrees(angle):.1f}°", ha="center", va="center", fontsize=7)
