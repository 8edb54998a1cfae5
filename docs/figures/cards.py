"""Draw the pictures on the cards of the front page, each for the size at which it is shown; writes card-*.svg."""

import tempfile
from collections.abc import Callable
from pathlib import Path

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np

import clubface
from clubface.capture import read_c3d, synthetic
from clubface.present.style import COLOURS
from clubface.units import from_si, to_si

SIZE = (2.5, 1.5)
"""Inches at 96 dots: the width of a card where three stand in a row."""
SETTINGS = {
    "font.family": "DejaVu Sans",
    "font.size": 8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "lines.linewidth": 1.6,
    "svg.hashsalt": "clubface",
}
BLUE, RED, GREEN = COLOURS[:3]


def shot(axes: plt.Axes) -> None:
    """Draw flights of three clubs from the side."""
    strikes = {
        "driver": ("113 mph", "12.8 deg"),
        "7-iron": ("90 mph", "25 deg"),
        "pitching-wedge": ("83 mph", "40 deg"),
    }
    for (club, (speed, loft)), colour in zip(strikes.items(), (BLUE, RED, GREEN), strict=True):
        path = from_si(clubface.trajectory(clubface.impact(club, speed=speed, loft=loft)).position, "yd")
        axes.plot(path[:, 0], path[:, 1], color=colour, label=club.replace("-", " "))
    axes.set(xlabel="carry (yd)", ylabel="height (yd)", xlim=(0, None), ylim=(0, 62))
    axes.legend(fontsize=7, ncols=3, handlelength=1, columnspacing=0.8, loc="upper center", borderpad=0)


def motion_capture(axes: plt.Axes) -> None:
    """Draw the markers of a synthetic swing about impact, from the side."""
    with tempfile.TemporaryDirectory() as folder:
        synthetic.synthesize(folder, count=1, seed=1)
        recording = read_c3d(Path(folder) / "swing-001.c3d")
    last = 181  # the frame before impact; the target is +y, up is +z
    for label in recording.labels:
        along, up = recording.marker(label)[last - 7 : last + 4, 1:].T * 1000
        axes.plot(along, up, "o-", color=RED if label == "BALL" else BLUE, markersize=2.5, linewidth=0.7)
    axes.set(xlabel="along the target line (mm)", ylabel="up (mm)", xlim=(-620, 60), ylim=(0, 150))


def design(axes: plt.Axes) -> None:
    """Draw ball speed over the face of a driver."""
    face = clubface.map_face("driver", speed="105 mph", attack="2 deg", loft="14 deg")
    speed = face.get("ball_speed", "mph")
    filled = axes.contourf(1e3 * face.toe, 1e3 * face.high, speed, levels=8, cmap="viridis")
    axes.figure.colorbar(filled, ax=axes, label="ball (mph)", ticks=[135, 140, 145, 150])
    axes.set(xlabel="towards the toe (mm)", ylabel="up (mm)", aspect="equal")


def contact(axes: plt.Axes) -> None:
    """Draw the forces of an iron on the ball, the friction turning round."""
    history = clubface.history("7-iron", speed="90 mph", attack="-4 deg", loft="25 deg", model="rings")
    time = history.get("time", "us")
    axes.axhline(0, color="0.6", linewidth=0.8)
    axes.plot(time, history.normal_force / 1e3, color=BLUE, label="normal")
    axes.plot(time, -history.force_y / 1e3, color=RED, label="friction")
    axes.set(xlabel="time (µs)", ylabel="force (kN)", xlim=(0, None))
    axes.legend(fontsize=7, handlelength=1)


def fitting(axes: plt.Axes) -> None:
    """Draw the carry over dynamic loft for three club speeds, the best loft marked."""
    lofts = np.linspace(8.0, 20.0, 49)
    for speed, colour in zip((80, 95, 110), (GREEN, RED, BLUE), strict=True):
        launches = clubface.impact("driver", speed=f"{speed} mph", loft=np.radians(lofts))
        carry = clubface.fly(launches).get("carry", "yd")
        best = int(np.argmax(carry))
        axes.plot(lofts, carry, color=colour)
        axes.plot(lofts[best], carry[best], "o", color=colour, markersize=4)
        axes.text(lofts[-1] + 0.3, carry[-1], f"{speed} mph", color=colour, fontsize=7, va="center")
    axes.set(xlabel="dynamic loft (°)", ylabel="carry (yd)", xlim=(7.5, 25))


def study(axes: plt.Axes) -> None:
    """Draw mean and spread of the carry along loft over many speeds and attack angles."""
    rng = np.random.default_rng(1)
    lofts = np.linspace(8.0, 18.0, 21)[:, None] + np.zeros(400)
    speeds, attacks = rng.normal(100.0, 4.0, lofts.shape), rng.normal(0.0, 2.0, lofts.shape)
    delivery = {"speed": to_si(speeds, "mph"), "attack": np.radians(attacks), "loft": np.radians(lofts)}
    balls = clubface.impact("driver", delivery)
    carry = clubface.fly(balls).get("carry", "yd")
    low, middle, high = np.quantile(carry, (0.05, 0.5, 0.95), axis=1)
    axes.fill_between(lofts[:, 0], low, high, color=BLUE, alpha=0.2, linewidth=0)
    axes.plot(lofts[:, 0], middle, color=BLUE)
    axes.set(xlabel="dynamic loft (°)", ylabel="carry (yd)")


CARDS: dict[str, Callable[[plt.Axes], None]] = {
    "shot": shot,
    "motion-capture": motion_capture,
    "design": design,
    "contact": contact,
    "fitting": fitting,
    "study": study,
}


def main() -> None:
    """Draw every card."""
    for name, draw in CARDS.items():
        with plt.rc_context(SETTINGS):
            figure, axes = plt.subplots(figsize=SIZE, layout="constrained")
            draw(axes)
            target = Path(__file__).with_name(f"card-{name}.svg")
            figure.savefig(target, metadata={"Date": None})
            plt.close(figure)
        print(target)


if __name__ == "__main__":
    main()
