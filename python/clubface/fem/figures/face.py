"""Pictures of restitution and characteristic time over a face."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from clubface.plots.style import WIDTH, styled

SHOWN = (("restitution", "restitution", "{:.3f}"), ("characteristic_time_us", "characteristic time (µs)", "{:.0f}"))


@styled
def face_figure(rows: Sequence[Mapping[str, Any]]) -> Figure:
    """Draw restitution and characteristic time over the face, seen from in front: the toe is on the right.

    Parameters
    ----------
    rows
        The rows of :func:`clubface.fem.face_map.face_map`, over a grid.
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
