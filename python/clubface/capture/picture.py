"""Pictures of read swings and of the errors of the estimators.

The picture of one read swing: path, face and residuals, by which a reader sees whether to trust the delivery.

Pictures of the errors of the estimators of motion capture.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle

from clubface import units
from clubface.capture.reduction import QUANTITIES
from clubface.capture.rotations import Array
from clubface.present.style import COLOURS, WIDTH, legend_above, save, styled
from clubface.support.files import whole_file

if TYPE_CHECKING:
    from clubface.capture.captured import CapturedDelivery
    from clubface.capture.study import Study


BEFORE, AFTER = 0.06, 0.02
"""Seconds about impact that are shown of path and face."""
ALONG = (-480.0, 240.0)
"""Millimetres along the target line that are shown of the path: three frames of 360 Hz before impact."""


@styled
def swing_figure(found: CapturedDelivery) -> Figure:
    """Draw path, face and residuals of one swing.

    Two panels show the face centre and the ball from the side and from above, frames before impact filled and later
    ones open; a line has the direction of the head at first touch. Two show dynamic loft and face angle frame by frame,
    with the delivery and twice its standard deviation. The last shows what is left between the markers and the rigid
    head in every frame.
    """
    trace = found.trace
    figure = Figure(figsize=(WIDTH, 7.2), layout="constrained")
    panels = figure.subplot_mosaic(
        [["side", "side"], ["above", "above"], ["loft", "face"], ["left", "left"]], height_ratios=[1.0, 1.0, 1.2, 0.8]
    )
    time = trace.times - found.time
    near = (time > -BEFORE) & (time < AFTER)
    before, after = near & (time <= 0.0), near & (time > 0.0)
    centre = units.from_si(trace.face_centre - trace.ball, "mm")
    radius = units.from_si(trace.radius, "mm")
    for name, row, angle, label, title in (
        ("side", 1, "attack", "up (mm)", "from the side"), ("above", 2, "path", "right (mm)", "from above"),
    ):  # fmt: skip
        axes = panels[name]
        axes.plot(centre[before, 0], centre[before, row], "o", color=COLOURS[0], label="face centre before impact")
        axes.plot(centre[after, 0], centre[after, row], "o", fillstyle="none", color=COLOURS[0], label="after")
        axes.add_patch(Circle((0.0, 0.0), radius, fill=False, color=COLOURS[1], label="ball"))
        slope, (shown, deviation) = np.tan(getattr(found.delivery, angle)), found.get(angle, "deg")
        axes.axline((0.0, 0.0), slope=slope, color=COLOURS[1], linewidth=0.8, linestyle=(0, (5, 1.5)))
        axes.set(xlabel="to the target (mm)", ylabel=label, xlim=ALONG, aspect="equal")
        axes.set_ylim(*_span(np.array([*centre[near & _inside(centre[:, 0]), row], -2.0 * radius, 2.0 * radius])))
        axes.set_title(f"{title}; dashed: {angle} of {shown:.1f} ± {deviation:.1f} deg")
    panels["side"].legend(loc="upper left", ncols=3)
    when = units.from_si(time, "ms")
    for name, values, title in (("loft", trace.loft, "dynamic loft (deg)"), ("face", trace.face, "face angle (deg)")):
        axes, degrees = panels[name], units.from_si(values, "deg")
        axes.plot(when[before], degrees[before], "o", color=COLOURS[0])
        axes.plot(when[after], degrees[after], "o", fillstyle="none", color=COLOURS[0])
        value, deviation = found.get(name, "deg")
        axes.errorbar([0.0], [value], yerr=[2.0 * deviation], fmt="s", color=COLOURS[1], capsize=3.0)
        axes.set(xlabel="time from first touch (ms)", title=f"{title}: {value:.1f} ± {deviation:.1f}")
        recent = degrees[before & (time > -0.5 * BEFORE)]
        axes.set_ylim(*_span(np.array([*recent, value - 2.0 * deviation, value + 2.0 * deviation])))
    left = panels["left"]
    left.plot(time, units.from_si(trace.residual, "mm"), color=COLOURS[0], linewidth=0.8)
    left.axhline(units.from_si(found.marker_noise, "mm"), color=COLOURS[1], linewidth=0.8, linestyle=(0, (5, 1.5)))
    left.axvline(0.0, color="0.35", linewidth=0.7)
    left.set(xlabel="time from first touch (s)", ylabel="mm", ylim=(0.0, None))
    left.set_title("residual of the markers in each frame; dashed: the noise that the deviations are made of")
    figure.suptitle(f"{Path(found.source).name}: {found.club.name}, {found.estimator}", fontsize=8.5, x=0.01, ha="left")
    return figure


def save_swings(swings: Iterable[CapturedDelivery], path: str | os.PathLike[str]) -> Path:
    """Write one picture, or several swings as the pages of a PDF."""
    target, found = Path(path), list(swings)
    if len(found) == 1:
        return save(swing_figure(found[0]), target)
    from matplotlib.backends.backend_pdf import PdfPages

    with whole_file(target) as file, PdfPages(file, metadata={"CreationDate": None}) as pages:
        for each in found:
            pages.savefig(swing_figure(each))
    return target


def _inside(along: Array) -> Array:
    return (along > ALONG[0]) & (along < ALONG[1])


def _span(values: Array) -> tuple[float, float]:
    """Return limits about values with some room, whatever few they are."""
    known = values[np.isfinite(values)]
    if not len(known):
        return -1.0, 1.0
    low, high = float(known.min()), float(known.max())
    room = max(0.08 * (high - low), 1.0)
    return low - room, high + room


SHOWN = {
    "speed": "speed", "attack": "attack angle", "path": "path", "loft": "dynamic loft", "face": "face angle",
    "toe": "towards the toe", "high": "high", "closure": "closure rate",
}  # fmt: skip


@styled
def study_figure(studies: Mapping[str, Study]) -> Figure:
    """Draw bias and spread of every estimator: one panel a quantity, one group of lines a study.

    Parameters
    ----------
    studies
        The studies by the text written beside each group, such as "no noise".
    """
    from clubface.capture.study import UNITS

    figure = Figure(figsize=(WIDTH, 4.0), layout="constrained")
    panels = figure.subplots(2, 4, sharey=True).ravel()
    names = list(next(iter(studies.values())).errors)
    for axes, (quantity, label) in zip(panels, SHOWN.items(), strict=True):
        column = QUANTITIES.index(quantity)
        axes.axvline(0.0, color="0.35", linewidth=0.7, zorder=1)
        for group, found in enumerate(studies.values()):
            for place, name in enumerate(names):
                error = units.from_si(found.errors[name][:, column], UNITS[quantity])
                low, first, last, high = np.quantile(error, [0.025, 0.25, 0.75, 0.975])
                y = group * (len(names) + 1.2) + place
                colour = COLOURS[place % len(COLOURS)]
                axes.plot([low, high], [y, y], color=colour, linewidth=1.0)
                axes.plot([first, last], [y, y], color=colour, linewidth=3.6, solid_capstyle="butt")
                axes.plot(error.mean(), y, marker="o", color="white", markeredgecolor=colour, markersize=3.6)
        axes.set_title(f"{label} ({UNITS[quantity]})")
        axes.grid(visible=False, axis="y")
    middle = [group * (len(names) + 1.2) + 0.5 * (len(names) - 1) for group in range(len(studies))]
    for axes in panels:
        axes.set_yticks(middle, list(studies))
        axes.tick_params(axis="y", length=0)
    panels[0].invert_yaxis()
    lines = [
        Line2D([], [], color=COLOURS[place % len(COLOURS)], linewidth=3.0, label=each)
        for place, each in enumerate(names)
    ]
    how = "captured less true: mean, middle half and 95% of the swings"
    legend_above(figure, lines, title=how)
    return figure
