"""What the fitted model leaves: differences from the finite elements, in figures and as a picture."""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from clubface.fem.response.design import Part
from clubface.fem.response.fit import effective_mass, fitted, simulated
from clubface.fem.response.runs import Strikes

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SPIN_SHARE, SPIN_LEAST = 0.02, 40.0 * math.pi / 30.0
"""A spin is met within this share of itself, or within this much [rad/s]."""
PERCENTILES = (50, 95, 100)
MASSES = (0.0, 0.12, 0.2, math.inf)
"""Ends of the classes of effective mass [kg] by which differences with any heads are told, too."""


def differences(values: Mapping[str, float], strikes: Strikes) -> dict[str, NDArray[Any]]:
    """Return how far the model with some coefficients is from the finite elements, one value a strike.

    ``speed`` [1] of ball speed, ``direction`` [rad] the angle between the launches, ``spin`` [1] the difference of the
    spins' sizes and ``spin_vector`` that of the vectors, over 2% of the spin or 40 rpm, whichever is larger;
    ``contact_time`` and ``peak_force`` [1].
    """
    got, _ = simulated(values, strikes, fitted()[:1])
    want = strikes.found
    size = np.linalg.norm
    speeds, spins = (tuple(size(of[:, part], axis=1) for of in (got, want)) for part in (slice(0, 3), slice(3, 6)))
    cosine = np.einsum("ij,ij->i", got[:, :3], want[:, :3]) / (speeds[0] * speeds[1])
    allowed = np.maximum(SPIN_SHARE * spins[1], SPIN_LEAST)
    return {
        "speed": np.abs(speeds[0] / speeds[1] - 1.0),
        "direction": np.arccos(np.clip(cosine, -1.0, 1.0)),
        "spin": np.abs(spins[0] - spins[1]) / allowed,
        "spin_vector": size(got[:, 3:6] - want[:, 3:6], axis=1) / allowed,
        "contact_time": np.abs(got[:, 6] / want[:, 6] - 1.0),
        "peak_force": np.abs(got[:, 7] / want[:, 7] - 1.0),
    }


def summary(
    values: Mapping[str, float], strikes: Strikes, parts: Mapping[str, Part]
) -> dict[str, dict[str, list[float]]]:
    """Return the percentiles of the differences by part and quantity, for held-out heads also by effective mass."""
    found = {}
    for place, (name, part) in enumerate(parts.items()):
        of_part = strikes.where(strikes.part == place)
        each, groups = differences(values, of_part), {name: np.arange(len(of_part.friction))}
        if part.held_out and not part.built_in:
            masses = effective_mass(of_part)
            for least, most in pairwise(MASSES):
                groups[f"{name}, {_class(least, most)}"] = np.flatnonzero((masses >= least) & (masses < most))
        for group, chosen in groups.items():
            found[group] = {key: [float(np.percentile(of[chosen], p)) for p in PERCENTILES] for key, of in each.items()}
    return found


def _class(least: float, most: float) -> str:
    if not least:
        return f"below {most:g} kg"
    return f"{least:g} kg and more" if math.isinf(most) else f"{least:g} to {most:g} kg"


def figure(values: Mapping[str, float], strikes: Strikes, parts: Mapping[str, Part]) -> Figure:
    """Draw what share of the held-out strikes is within a difference, for ball speed, direction and spin."""
    from matplotlib.figure import Figure

    from clubface.plots.style import legend_above

    drawn = Figure(figsize=(9.0, 3.4), layout="constrained")
    panels = drawn.subplots(1, 3, sharey=True)
    told = {
        "speed": ("difference of ball speed, %", 100.0, 0.5),
        "direction": ("angle between launches, degrees", 180.0 / math.pi, 0.2),
        "spin": ("difference of spin over 2% or 40 rpm", 1.0, 1.0),
    }
    for place, (name, part) in enumerate(parts.items()):
        if not part.held_out:
            continue
        found = differences(values, strikes.where(strikes.part == place))
        for panel, (key, (_, size, _)) in zip(panels, told.items(), strict=True):
            ordered = np.sort(found[key]) * size
            panel.plot(ordered, np.arange(1, len(ordered) + 1) / len(ordered), label=name)
    legend_above(drawn, panels[0].get_lines())
    for panel, (text, _, asked) in zip(panels, told.values(), strict=True):
        panel.axvline(asked, color="0.6", linewidth=0.8)
        panel.axhline(0.95, color="0.6", linewidth=0.8)
        panel.set_xlim(0.0, 4.0 * asked)
        panel.set_xlabel(text)
    panels[0].set_ylabel("share of the strikes")
    return drawn
