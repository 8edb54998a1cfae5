"""Draw the axes, angles and signs of the conventions page.

Writes conventions.svg, and conventions-narrow.svg for phones, next to this file.
"""

from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon

CLUB, BALL, AXIS, ANGLE = "#7d8aa0", "#ffffff", "#222222", "#b3372f"
SETTINGS = {"svg.hashsalt": "clubface", "svg.fonttype": "path", "font.family": "DejaVu Sans", "font.size": 9.5}


def arrow(
    ax: Axes, start: tuple[float, float], end: tuple[float, float], color: str = AXIS, width: float = 1.4
) -> None:
    """Draw a straight arrow."""
    ax.annotate(
        "", end, start, arrowprops={"arrowstyle": "-|>", "color": color, "lw": width, "shrinkA": 0, "shrinkB": 0}
    )


def turn(ax: Axes, centre: tuple[float, float], radius: float, first: float, last: float, color: str = ANGLE) -> None:
    """Draw an arc with an arrow head at its end; angles in degrees, counterclockwise."""
    angles = np.radians(np.linspace(first, last, 60))
    x, y = centre[0] + radius * np.cos(angles), centre[1] + radius * np.sin(angles)
    ax.plot(x, y, color=color, lw=1.3)
    arrow(ax, (x[-3], y[-3]), (x[-1], y[-1]), color, 1.3)


def ray(centre: tuple[float, float], degrees: float, length: float) -> tuple[float, float]:
    """Return the point at a distance from the centre, at an angle above the page's horizontal."""
    return centre[0] + length * np.cos(np.radians(degrees)), centre[1] + length * np.sin(np.radians(degrees))


def dashed(ax: Axes, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Draw a reference line."""
    ax.plot(*zip(start, end, strict=True), color="#999999", lw=0.9, ls=(0, (5, 4)))


def axes_mark(
    ax: Axes, at: tuple[float, float], across: tuple[str, float], upright: tuple[str, float], out: str
) -> None:
    """Draw a small triad: two axes in the page, each a label and a signed length, and one pointing at the reader."""
    x, y = at
    arrow(ax, at, (x + across[1], y))
    arrow(ax, at, (x, y + upright[1]))
    ax.add_patch(Circle(at, 0.07, fc="white", ec=AXIS, lw=1.2, zorder=3))
    ax.add_patch(Circle(at, 0.02, fc=AXIS, zorder=4))
    ax.text(x + 1.1 * across[1], y, across[0], va="center", ha="left" if across[1] > 0 else "right")
    ax.text(x, y + 1.12 * upright[1], upright[0], ha="center", va="bottom" if upright[1] > 0 else "top")
    ax.text(x - 0.34 * across[1], y - 0.34 * upright[1], out, ha="center", va="center")


def panel(ax: Axes, title: str, width: tuple[float, float], height: tuple[float, float]) -> None:
    """Prepare one view."""
    ax.set_aspect("equal")
    ax.set_xlim(*width)
    ax.set_ylim(*height)
    ax.axis("off")
    ax.set_title(title, fontsize=10.5, fontweight="bold", loc="left")


def side_view(ax: Axes) -> None:
    """Seen by someone who faces a right-handed player: the target is to the right."""
    panel(ax, "From the side", (-3.3, 3.6), (-1.75, 2.5))
    touch, loft, attack, launch = (0.0, 0.0), 36.0, 8.0, 24.0
    ball = ray(touch, loft, 0.62)
    base, tip = ray(touch, loft - 90, 0.72), ray(touch, loft + 90, 0.78)
    ax.add_patch(Polygon([base, tip, (-1.35, 0.72), (-2.05, -0.05), (-1.65, -0.64)], fc=CLUB, ec="none", alpha=0.75))
    ax.add_patch(Circle(ball, 0.62, fc=BALL, ec=AXIS, lw=1.3))
    cg = (-1.1, -0.05)
    ax.plot(*cg, marker="o", color=AXIS, ms=4)
    ax.text(cg[0] - 0.1, cg[1] - 0.1, "CG", va="top", ha="right")
    dashed(ax, cg, (-2.95, -0.05))
    arrow(ax, ray(cg, 180 + attack, 1.85), cg, ANGLE, 2)
    ax.text(-3.2, -0.5, "attack angle +", color=ANGLE, va="top")
    turn(ax, cg, 1.6, 180, 180 + attack)
    dashed(ax, touch, (2.6, 0))
    arrow(ax, touch, ray(touch, loft, 2.7))
    ax.text(*ray(touch, loft, 2.78), "x' face normal", va="center")
    arrow(ax, touch, ray(touch, loft + 90, 1.45))
    ax.text(*ray(touch, loft + 91, 1.52), "y'", ha="center", va="bottom")
    turn(ax, touch, 1.35, 0, loft)
    ax.text(1.42, 0.2, "dynamic loft +", color=ANGLE, va="center")
    dashed(ax, ball, (3.2, ball[1]))
    arrow(ax, ball, ray(ball, launch, 2.1), AXIS, 2)
    turn(ax, ball, 1.85, 0, launch)
    ax.text(2.68, 0.72, "launch +", ha="left", va="center")
    turn(ax, ball, 0.42, 60, 330)
    ax.text(0.72, -0.42, "backspin +\n(about +z, lifts)", color=ANGLE, va="top")
    axes_mark(ax, (-2.7, 1.35), ("x target", 0.55), ("y up", 0.55), "z")


def top_view(ax: Axes) -> None:
    """Seen from above: the target is to the right, right of the target is down the page."""
    panel(ax, "From above, right-handed", (-3.3, 3.6), (-2.15, 2.1))
    touch, path, face, azimuth = (0.0, 0.0), -9.0, -32.0, -22.0
    ball = ray(touch, face, 0.62)
    heel, toe = ray(touch, face + 90, 0.9), ray(touch, face - 90, 0.95)
    ax.add_patch(Polygon([heel, toe, (-1.5, -1.0), (-1.95, -0.2), (-1.25, 0.72)], fc=CLUB, ec="none", alpha=0.75))
    ax.add_patch(Circle(ball, 0.62, fc=BALL, ec=AXIS, lw=1.3))
    ax.text(toe[0] - 0.15, toe[1] - 0.1, "toe", ha="right", va="top")
    ax.text(heel[0], heel[1] + 0.08, "heel", ha="center", va="bottom")
    cg = (-1.0, -0.1)
    ax.plot(*cg, marker="o", color=AXIS, ms=4)
    dashed(ax, cg, (-2.95, -0.1))
    arrow(ax, ray(cg, 180 + path, 1.85), cg, ANGLE, 2)
    turn(ax, cg, 1.6, 180, 180 + path)
    ax.text(-3.1, 0.3, "path +", color=ANGLE, va="bottom")
    dashed(ax, touch, (2.9, 0))
    ax.text(2.95, 0, "target", va="center")
    arrow(ax, touch, ray(touch, face, 2.7))
    ax.text(*ray(touch, face, 2.78), "x' face normal", va="center")
    turn(ax, touch, 1.35, 0, face)
    ax.text(1.42, -0.2, "face angle +", color=ANGLE, va="center")
    dashed(ax, ball, (3.2, ball[1]))
    arrow(ax, ball, ray(ball, azimuth, 2.1), AXIS, 2)
    turn(ax, ball, 1.85, 0, azimuth)
    ax.text(2.62, -0.72, "azimuth +", va="center")
    turn(ax, ball, 0.42, 60, -150)
    ax.text(0.25, -1.05, "sidespin +\n(curves right)", color=ANGLE, va="top")
    turn(ax, cg, 0.62, 35, 118)
    ax.text(-0.62, 1.25, "closure +", color=ANGLE, ha="center")
    axes_mark(ax, (-2.8, -1.15), ("x target", 0.55), ("z right", -0.55), "y")


def face_view(ax: Axes) -> None:
    """Look at the face from the target: the toe of a right-handed club is on the left."""
    panel(ax, "The face, seen from the ball", (-2.7, 2.5), (-1.75, 2.5))
    t = np.linspace(0, 2 * np.pi, 200)
    ax.fill(1.75 * np.cos(t), 1.0 * np.sin(t) * (1 + 0.08 * np.cos(t)), fc=CLUB, ec="none", alpha=0.75)
    ax.plot([1.35, 1.95], [0.65, 2.35], color=CLUB, lw=6, alpha=0.75, solid_capstyle="butt")
    ax.text(2.02, 2.25, "shaft", va="center")
    ax.text(-1.95, 0.0, "toe", ha="center", va="center")
    ax.text(2.05, 0.0, "heel", ha="center", va="center")
    ax.plot(0, 0, marker="+", color=AXIS, ms=9)
    ax.text(0.08, -0.08, "face centre", va="top")
    impact_point = (-0.95, 0.42)
    ax.plot(*impact_point, marker="o", color=ANGLE, ms=6)
    ax.plot([0, impact_point[0]], [0, 0], color=ANGLE, lw=1.2)
    arrow(ax, (0, 0), (impact_point[0], 0), ANGLE)
    arrow(ax, (impact_point[0], 0), impact_point, ANGLE)
    ax.text(-0.48, -0.1, "toe +", color=ANGLE, ha="center", va="top")
    ax.text(-1.03, 0.2, "high +", color=ANGLE, ha="right", va="center")
    arrow(ax, impact_point, (impact_point[0], 1.55))
    ax.text(impact_point[0], 1.6, "y'", ha="center", va="bottom")
    arrow(ax, impact_point, (-2.1, 0.42))
    ax.text(-2.15, 0.42, "z'", ha="right", va="center")
    turn(ax, (0.0, -0.2), 1.15, 250, 215)
    ax.text(-0.75, -1.32, "lie +, lie rate + (toe up)", color=ANGLE, va="top", ha="center")
    axes_mark(ax, (1.9, -1.45), ("z right", -0.55), ("y up", 0.55), "x")


def main() -> None:
    """Write the pictures; the same bytes on every run."""
    with plt.rc_context(SETTINGS):
        figure, ((side, face), (top, rest)) = plt.subplots(
            2, 2, figsize=(10.4, 7.0), width_ratios=(6.9, 5.2), layout="constrained"
        )
        side_view(side)
        face_view(face)
        top_view(top)
        rest.axis("off")
        rest.text(
            0.0,
            0.92,
            "World axes: x to the target, y up, z = x × y.\n\n"
            "Local frame at the impact point: x' outward\n"
            "normal, y' the face's up direction projected on\n"
            "the tangent plane, z' = x' × y'.\n\n"
            "A left-handed club is the mirror image in z: toe,\n"
            "closure and z' follow the club; path, face angle,\n"
            "azimuth and sidespin keep to the world.\n\n"
            "Pitch rate + increases the loft (about +z).",
            va="top",
            transform=rest.transAxes,
            linespacing=1.35,
        )
        figure.savefig(Path(__file__).with_name("conventions.svg"), metadata={"Date": None})
        figure, panels = plt.subplots(3, figsize=(4.9, 10.2), layout="constrained")
        for ax, view in zip(panels, (side_view, top_view, face_view), strict=True):
            view(ax)
        figure.savefig(Path(__file__).with_name("conventions-narrow.svg"), metadata={"Date": None})


if __name__ == "__main__":
    main()
