"""The picture of a comparison: the flights, and what makes the differences."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from clubface import units as units_of
from clubface.design.comparison.comparison import Compared
from clubface.design.comparison.quantities import QUANTITIES
from clubface.plots.style import COLOURS, DASHES, WIDTH, legend_above, styled
from clubface.simulation.trajectory import trajectory

SPLIT = {"ball_speed": "mph", "backspin": "rpm", "carry": "yd", "side": "yd"}
"""Quantities whose differences are drawn, and their units unless others are asked for."""
BARS = 9
"""Contributions that are drawn one by one, the largest; the others are one bar."""


@styled
def comparison_figure(
    found: Compared,
    *,
    air: Any = None,
    wind: Any = None,
    ground: str | Mapping[str, Any] | None = None,
    units: Mapping[str, str] | None = None,
) -> Figure:
    """Draw the flights from the side and from above, and under them the contributions to each difference.

    Parameters
    ----------
    found
        What was compared.
    air, wind, ground
        Those of the flights, as for :func:`clubface.fly`.
    units
        The unit of a quantity, by name; left out, mph, rpm and yd.
    """
    shown = {name: (units or {}).get(name, unit) for name, unit in SPLIT.items()}
    split = {name: each for name, each in found.contributions.items() if not each.left_out and each.changes}
    counts = [min(len(each.changes), BARS + 1) + 1 for each in split.values()]
    heights = [2.5, *(0.75 + 0.19 * count for count in counts)]
    figure = Figure(figsize=(WIDTH, sum(heights) + 0.3 * len(heights)), layout="constrained")
    parts: Any = figure.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0]
    _flights(parts[0], found, {"air": air, "wind": wind, "ground": ground}, shown["carry"])
    for part, name in zip(parts[1:], split, strict=True):
        _bars(part, found, name, shown)
    return figure


def _look(place: int) -> dict[str, Any]:
    return {"color": COLOURS[place % len(COLOURS)], "linestyle": DASHES[place % len(DASHES)]}


def _flights(figure: Any, found: Compared, conditions: Mapping[str, Any], unit: str) -> None:
    side, above = figure.subplots(1, 2, width_ratios=[1.6, 1.0])
    for place, (name, launch) in enumerate(found.launches.items()):
        path = units_of.from_si(trajectory(launch, **conditions).position, unit)
        side.plot(path[:, 0], path[:, 1], label=name, **_look(place))
        above.plot(path[:, 2], path[:, 0], **_look(place))
    side.set(xlabel=f"distance along the target line ({unit})", ylabel=f"height ({unit})", title="from the side")
    side.set_ylim(bottom=0.0)
    side.set_xlim(left=0.0)
    above.set(xlabel=f"right ({unit})", ylabel=f"distance ({unit})", title="from above, stretched sideways")
    above.axvline(0.0, color="0.5", linewidth=0.6, zorder=1)
    above.set_ylim(bottom=0.0)
    reach = max(abs(each) for each in above.get_xlim())
    above.set_xlim(-reach, reach)
    legend_above(figure, [Line2D([], [], label=name, **_look(place)) for place, name in enumerate(found.names)])


def _bars(figure: Any, found: Compared, name: str, shown: Mapping[str, str]) -> None:
    made = found.contributions[name]
    places = [QUANTITIES.index(each) for each in shown]
    sizes = np.array([units_of.size(unit) for unit in shown.values()])
    values = made.si[:, places] / sizes
    rest = made.remainder[places] / sizes
    # The share of a contribution in all of a quantity, so that mph, rpm and yd count alike.
    weight = (np.abs(values) / np.maximum(np.abs(values).sum(axis=0), 1e-300)).max(axis=1)
    order = np.argsort(-weight, kind="stable")
    labels = [made.changes[index].name.replace("_", " ") for index in order[:BARS]]
    bars = [values[index] for index in order[:BARS]]
    if others := order[BARS:].tolist():
        labels.append(f"{len(others)} others")
        bars.append(values[others].sum(axis=0))
    labels.append("remainder")
    bars.append(rest)
    table = np.array(bars)
    panels = figure.subplots(1, len(shown), sharey=True)
    for column, (panel, (quantity, unit)) in enumerate(zip(panels, shown.items(), strict=True)):
        panel.barh(range(len(table)), table[:, column], color="0.5", height=0.7)
        panel.axvline(0.0, color="0.3", linewidth=0.6)
        panel.grid(visible=False, axis="y")
        total = found.difference(name, quantity, unit)
        digits = 0 if unit == "rpm" else 1
        panel.set_title(f"{quantity.replace('_', ' ')} {total:+.{digits}f} {unit}")
        panel.set_xlabel(unit)
    panels[0].invert_yaxis()
    panels[0].set_yticks(range(len(labels)), labels)
    figure.suptitle(f"what makes {name} differ from {found.names[0]}", fontsize=8.5, x=0.01, ha="left")
