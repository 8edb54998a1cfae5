"""Draw the first picture of the documentation, a driver's impact in sections over the force.

Writes impact.png, and impact-narrow.png for phones.
"""

from pathlib import Path

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from clubface import fem
from clubface.fem.result import Impact
from clubface.fem.section_picture import Section
from clubface.units import from_si

SETTINGS = {"font.family": "DejaVu Sans"}
BALL, FORCE, SPIN = "YlOrRd", "#0072B2", "#D55E00"


def struck() -> Impact:
    """Return the published head of shells striking a modern ball at 105 mph, its shapes kept."""
    settings = fem.Settings(frames=121)
    return fem.strike(fem.head("paper"), speed="105 mph", ball="modern", friction=0.35, settings=settings)


def draw_section(panel: plt.Axes, section: Section, frame: int) -> None:
    """Draw ball and head at one moment, coloured by compression up to 40%."""
    corners, squeezed = section.at(frame)
    panel.add_collection(
        PolyCollection(list(1e3 * corners), array=squeezed, cmap=BALL, clim=(0, 0.4), edgecolors="0.4", linewidths=0.2)
    )
    walls, thickness = section.head_at(frame)
    panel.add_collection(LineCollection(list(1e3 * walls), linewidths=1.1e3 * thickness, colors="0.45"))
    panel.set(aspect="equal", xlim=(-17, 46), ylim=(-30, 33), title=f"{section.times[frame] * 1e6:.0f} µs")
    panel.axis("off")


def draw_force(force: plt.Axes, impact: Impact) -> None:
    """Draw force and backspin over time."""
    time = impact.contact["time"] * 1e6
    force.fill_between(time, impact.contact["normal"] / 1e3, color=FORCE, alpha=0.15, linewidth=0)
    force.plot(time, impact.contact["normal"] / 1e3, color=FORCE)
    force.set(xlabel="time (µs)", xlim=(0, impact.last_touch * 1e6), ylim=(0, None))
    force.set_ylabel("force on the ball (kN)", color=FORCE)
    spin = force.twinx()
    spin.plot(impact.motion["time"] * 1e6, from_si(impact.motion["spin"][:, 2], "rpm"), color=SPIN)
    spin.set_ylim(0, None)
    spin.set_ylabel("backspin (rpm)", color=SPIN)
    for axes in (force, spin):
        axes.spines["top"].set_visible(False)


def draw_page(impact: Impact, name: str, size: tuple[float, float], letters: float, moments: int) -> Path:
    """Draw sections at some moments, evenly spaced over the contact, above the force; return the file."""
    section = Section(impact)
    with plt.rc_context({**SETTINGS, "font.size": letters}):
        figure = plt.figure(figsize=size, layout="constrained")
        grid = figure.add_gridspec(2, moments, height_ratios=[1.5, 1] if moments == 5 else [1, 1.4])
        for column, moment in enumerate(np.linspace(0.02, 0.98, moments) * impact.last_touch):
            frame = int(np.argmin(abs(section.times - moment)))
            draw_section(figure.add_subplot(grid[0, column]), section, frame)
        draw_force(figure.add_subplot(grid[1, :]), impact)
        target = Path(__file__).with_name(name)
        figure.savefig(target, dpi=170)
    return target


def main() -> None:
    """Run the impact and draw it."""
    impact = struck()
    target = draw_page(impact, "impact.png", (10, 4.3), 11.5, 5)
    draw_page(impact, "impact-narrow.png", (4.2, 3.6), 9.5, 3)
    figures = {
        "mph": impact.launch.get("ball_speed", "mph"),
        "kN": impact.peak_force / 1e3,
        "rpm": from_si(impact.backspin, "rpm"),
        "rpm at most": from_si(impact.spin_max, "rpm"),
        "% of the radius": 100 * impact.contraction,
        "s": impact.wall,
    }
    print(target, *(f"{value:.1f} {unit}" for unit, value in figures.items()), sep=", ")


if __name__ == "__main__":
    main()
