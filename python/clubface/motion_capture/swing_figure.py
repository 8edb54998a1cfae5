"""The picture of one read swing: path, face and residuals, by which a reader sees whether to trust the delivery."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Circle

from clubface import units
from clubface.plots.style import COLOURS, WIDTH, save, styled

if TYPE_CHECKING:
    from clubface.motion_capture.captured import CapturedDelivery

BEFORE, AFTER = 0.06, 0.02
"""Seconds about impact that are shown of path and face."""


@styled
def swing_figure(found: CapturedDelivery) -> Figure:
    """Draw path, face and residuals of one swing.

    Two panels show the face centre and the ball from the side and from above, frames before impact filled and later
    ones open. Two show dynamic loft and face angle frame by frame, with the delivery and twice its standard deviation
    at impact. The last shows what is left between the markers and the rigid head in every frame.
    """
    trace = found.trace
    figure = Figure(figsize=(WIDTH, 6.0), layout="constrained")
    side, above, loft, face, left = figure.subplot_mosaic(
        [["side", "above"], ["loft", "face"], ["left", "left"]], height_ratios=[1.0, 1.0, 0.7]
    ).values()
    time = trace.times - found.time
    near = (time > -BEFORE) & (time < AFTER)
    before, after = near & (time <= 0.0), near & (time > 0.0)
    ball = units.from_si(trace.ball, "mm")
    centre = units.from_si(trace.face_centre, "mm") - ball
    for axes, row, label in ((side, 1, "up (mm)"), (above, 2, "to the right (mm)")):
        axes.plot(centre[before, 0], centre[before, row], "o", color=COLOURS[0], label="face centre before impact")
        axes.plot(centre[after, 0], centre[after, row], "o", fillstyle="none", color=COLOURS[0], label="after")
        radius = units.from_si(trace.radius, "mm")
        axes.add_patch(Circle((0.0, 0.0), radius, fill=False, color=COLOURS[1], label="ball"))
        axes.set(xlabel="to the target (mm)", ylabel=label, xlim=(-450.0, 250.0))
        low, high = _span(centre[(centre[:, 0] > -450.0) & (centre[:, 0] < 250.0) & near, row])
        axes.set_ylim(low, high)
    side.set_title("path from the side")
    above.set_title("path from above")
    side.legend(loc="best")
    for axes, values, name, title in (
        (loft, trace.loft, "loft", "dynamic loft (deg)"), (face, trace.face, "face", "face angle (deg)"),
    ):  # fmt: skip
        shown = units.from_si(values, "deg")
        when = units.from_si(time, "ms")
        axes.plot(when[before], shown[before], "o", color=COLOURS[0])
        axes.plot(when[after], shown[after], "o", fillstyle="none", color=COLOURS[0])
        value, deviation = found.get(name, "deg")
        axes.errorbar([0.0], [value], yerr=[2.0 * deviation], fmt="s", color=COLOURS[1], capsize=3.0)
        axes.set(xlabel="time from first touch (ms)", title=title)
        recent = shown[before & (time > -0.5 * BEFORE)]
        low, high = _span(np.array([*recent, value - 2.0 * deviation, value + 2.0 * deviation]))
        axes.set_ylim(low, high)
    left.plot(time, units.from_si(trace.residual, "mm"), color=COLOURS[0], linewidth=0.8)
    left.axhline(units.from_si(found.marker_noise, "mm"), color=COLOURS[1], linewidth=0.8, linestyle=(0, (5, 1.5)))
    left.axvline(0.0, color="0.35", linewidth=0.7)
    left.set(xlabel="time from first touch (s)", ylabel="mm", ylim=(0.0, None))
    left.set_title("residual of the markers in each frame, root mean square; dashed: noise taken for the uncertainty")
    figure.suptitle(f"{Path(found.source).name}: {found.club.name}, {found.estimator}", fontsize=8.5, x=0.01, ha="left")
    return figure


def save_swings(swings: Iterable[CapturedDelivery], path: str | os.PathLike[str]) -> Path:
    """Write one picture, or several swings as the pages of a PDF."""
    target, found = Path(path), list(swings)
    if len(found) == 1:
        return save(swing_figure(found[0]), target)
    from matplotlib.backends.backend_pdf import PdfPages

    with PdfPages(target, metadata={"CreationDate": None}) as pages:
        for each in found:
            pages.savefig(swing_figure(each))
    return target


def _span(values: np.ndarray) -> tuple[float, float]:
    """Return limits about values with some room, whatever few they are."""
    known = values[np.isfinite(values)]
    if not len(known):
        return -1.0, 1.0
    low, high = float(known.min()), float(known.max())
    room = max(0.08 * (high - low), 1.0)
    return low - room, high + room
