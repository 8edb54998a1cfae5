"""The picture of a session: where the shots of each club land, and how far the clubs carry."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse

from clubface.errors import InputError, Told
from clubface.plots import COLOURS, MARKERS, WIDTH, styled
from clubface.shots.recorded import RecordedShots
from clubface.shots.session_summary import ClubSummary
from clubface.units import from_si

FEWEST = 3
"""Shots from which an ellipse is drawn."""


@styled
def session_figure(shots: RecordedShots, clubs: Sequence[ClubSummary]) -> Figure:
    """Draw carry against side with an ellipse of one standard deviation for each club, beside carries and gaps [yd]."""
    drawn = [each for each in clubs if "carry" in each.spreads]
    if not drawn:
        raise InputError("picture", Told("of carries"), "leave it out: the file has no carry")
    with_side = [each for each in drawn if "side" in each.spreads]
    figure = Figure(figsize=(WIDTH, 4.4), layout="constrained")
    panels = figure.subplots(1, 2 if with_side else 1, squeeze=False, sharey=True)[0]
    for place, each in enumerate(drawn):
        look: dict[str, Any] = {
            "color": COLOURS[place % len(COLOURS)],
            "marker": MARKERS[place // len(COLOURS) % len(MARKERS)],
        }
        if each in with_side:
            _landings(panels[0], shots, each, look)
        _carry(panels[-1], place, each, look)
    if with_side:
        panels[0].set(xlabel="side, to the right (yd)", ylabel="carry (yd)", title="landings, one standard deviation")
        panels[0].axvline(0.0, color="0.6", linewidth=0.8)
        panels[0].margins(0.12)
    panels[-1].set_xticks(range(len(drawn)), [_named(each) for each in drawn], rotation=35, ha="right")
    panels[-1].set(
        title="carry, standard deviation, and gap to the next club (yd)", ylabel="" if with_side else "carry (yd)"
    )
    panels[-1].margins(x=0.12)
    return figure


def _landings(axes: Axes, shots: RecordedShots, of: ClubSummary, look: dict[str, Any]) -> None:
    points = np.array([from_si(shots.launches[name][of.places], "yd") for name in ("side", "carry")])
    points = points[:, np.isfinite(points).all(axis=0)]
    axes.plot(*points, linestyle="none", alpha=0.55, markersize=3.0, **look)
    if points.shape[1] >= FEWEST:
        sizes, directions = np.linalg.eigh(np.cov(points))
        width, height = 2.0 * np.sqrt(np.maximum(sizes, 0.0))
        angle = float(np.degrees(np.arctan2(directions[1, 0], directions[0, 0])))
        middle = (float(points[0].mean()), float(points[1].mean()))
        axes.add_patch(Ellipse(middle, width, height, angle=angle, fill=False, color=look["color"], linewidth=1.2))


def _carry(axes: Axes, place: int, of: ClubSummary, look: dict[str, Any]) -> None:
    carry = of.spreads["carry"]
    mean, deviation = (float(from_si(each, "yd")) for each in (carry.mean, carry.deviation))
    axes.errorbar(place, mean, yerr=None if carry.shots < 2 else deviation, capsize=3.0, markersize=5.0, **look)
    note = f"{mean:.0f}" + (f"\ngap {from_si(of.gap.length, 'yd'):.0f}" if of.gap else "")
    axes.annotate(note, (place, mean), xytext=(7.0, 0.0), textcoords="offset points", va="center", fontsize=7.0)


def _named(of: ClubSummary) -> str:
    club = of.club or "without a name"
    return f"{of.player}: {club}" if of.player else club
