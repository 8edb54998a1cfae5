"""Laws of simple models held against finite elements; writes area-term.svg and displaced-centre.svg."""

import math
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import clubface
from clubface import fem, plots, units
from clubface.equipment.parameters import ParameterSet
from clubface.fem.case import case
from clubface.fem.reduced import AreaTerm, area_term
from clubface.fem.result import Displacement, Impact, displaced_centre
from clubface.present.style import COLOURS, DASHES, MARKERS, WIDTH, legend_above, styled

BALL, FRICTION = "paper", 0.3
END = fem.Settings(until_separation=True)
FRICTIONS = (0.1, 0.2, 0.35)
ANGLES = (11.5, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0)
SPEEDS = tuple(float(speed) for speed in range(25, 56, 5))
SWINGS = (("driver", 8.0, 25.0, 55.0), ("driver", 12.0, 25.0, 55.0), ("7-iron", 22.0, 25.0, 45.0),
          ("7-iron", 28.0, 25.0, 45.0))  # fmt: skip
"""Club, loft [deg], least and largest speed [m/s]."""
HEADS = {"driver": "driver-as-printed", "7-iron": "7-iron"}
"""The heads with which the published displacements were identified."""
MEAN = {"driver": (48.3, 12.0), "7-iron": (39.8, 25.65)}
"""Speed [m/s] and loft [deg] in the middle of the shots on which the published displacements were identified."""


def throw(speed: float, angle: float, friction: float) -> Impact:
    """Throw the ball at a plane; the angle in degrees."""
    return fem.throw(BALL, speed=speed, angle=math.radians(angle), friction=friction, settings=END)


def strike(club: str, speed: float, loft: float) -> Impact:
    """Strike the ball at the face centre with a rigid head; the speed in m/s, the dynamic loft in degrees."""
    rigid = clubface.club(HEADS[club]).replace(characteristic_time=0.0)
    return fem.strike(rigid, speed=speed, loft=math.radians(loft), ball=BALL, friction=FRICTION, settings=END)


@styled
def area_figure(term: AreaTerm, friction: float, radius: float, thrown: dict[float, list[AreaTerm]]) -> Figure:
    """Draw one contact through the law, its area, and the eta of throws over angle and friction."""
    figure = Figure(figsize=(WIDTH, 2.6), layout="constrained")
    force, area, eta = figure.subplots(1, 3)
    time = units.from_si(term.time, "us")
    force.plot(time, term.tangential, color=COLOURS[0], label="finite elements")
    force.plot(time, friction * term.normal, color="0.5", linestyle=DASHES[2], label="friction times normal force")
    law = term.free_friction * (term.normal + term.free_damping * term.rate)
    force.plot(time, law, color=COLOURS[1], linestyle=DASHES[1], label="the law, fitted")
    force.axhline(0.0, color="0.5", linewidth=0.6, zorder=1)
    force.set_ylim(top=1.75 * float(np.max(friction * term.normal)))
    area.plot(time, term.area * 1e6, color=COLOURS[0], label="finite elements")
    area.plot(time, math.pi * radius * term.sinking * 1e6, color=COLOURS[1], linestyle=DASHES[1], label="π R d")
    area.set_ylim(bottom=0.0, top=1.35e6 * float(np.max(term.area)))
    for index, (mu, terms) in enumerate(thrown.items()):
        style = {"color": COLOURS[index], "linestyle": DASHES[index], "marker": MARKERS[index]}
        eta.plot(ANGLES, [term.free_damping for term in terms], label=f"friction {mu:g}", **style)
    force.set_title("force along the face (N)", loc="left")
    area.set_title("contact area (mm²)", loc="left")
    eta.set_title("fitted η (N s/m²)", loc="left")
    for panel in (force, area):
        panel.set_xlabel("time (µs)")
    eta.set_xlabel("angle from the normal (deg)")
    force.legend(loc="upper right", borderaxespad=0.0)
    area.legend(loc="upper left", borderaxespad=0.0)
    eta.legend(loc="upper right", borderaxespad=0.0)
    return figure


def area_terms() -> dict[str, tuple[Impact, AreaTerm]]:
    """Return Arakawa's law held against the case of Roh and Lee and against throws at a plane, by what is struck."""
    runs = {"Roh and Lee": case("paper").run()}
    runs |= {f"{mu:g}, {angle:g}°": throw(35.0, angle, mu) for mu in FRICTIONS for angle in ANGLES}
    runs |= {f"{FRICTION:g}, 11.5°, {speed:g} m/s": throw(speed, 11.5, FRICTION) for speed in (20.0, 50.0)}
    return {name: (impact, area_term(impact)) for name, impact in runs.items()}


def the_area() -> Figure:
    """Draw what :func:`area_terms` returns."""
    terms = area_terms()
    struck, drawn = terms["Roh and Lee"]
    thrown = {mu: [terms[f"{mu:g}, {angle:g}°"][1] for angle in ANGLES] for mu in FRICTIONS}
    return area_figure(drawn, struck.friction, 0.5 * struck.ball.diameter, thrown)


def published(club: str) -> tuple[float, Displacement]:
    """Return the speed [m/s] and the displacement of the published set, its moment from the model's own launch."""
    speed, loft = MEAN[club]
    values = ParameterSet.builtin("adjusted", club).values
    normal, up, toe = (float(values[f"dcg_{axis}"]) for axis in "xyz")
    launch = clubface.impact(HEADS[club], speed=speed, loft=math.radians(loft), model="adjusted")
    tilt = math.radians(loft) - float(launch.launch)
    return speed, Displacement(normal, up, toe, up + normal * math.tan(tilt))


@styled
def displacement_figure(curves: dict[str, dict[float, Displacement]]) -> Figure:
    """Draw the displacement over speed, by club and loft, and the published ones."""
    figure = Figure(figsize=(WIDTH, 2.9), layout="constrained")
    panels: list[Axes] = list(figure.subplots(1, 3))
    shown = (("normal", "along the normal (mm)"), ("up", "up the face (mm)"), ("moment", "both in one (mm)"))
    for panel, (key, label) in zip(panels, shown, strict=True):
        for index, (name, curve) in enumerate(curves.items()):
            values = [units.from_si(getattr(each, key), "mm") for each in curve.values()]
            colour = COLOURS[index // 2] if index < 4 else "0.6"
            style = {"color": colour, "linestyle": DASHES[index % 2], "marker": MARKERS[index], "markersize": 3.0}
            panel.plot(list(curve), values, label=name, **style)
        for index, club in enumerate(MEAN):
            speed, displacement = published(club)
            mark = {"color": COLOURS[index], "marker": "x", "linestyle": "none", "markersize": 6.0}
            panel.plot([speed], [units.from_si(getattr(displacement, key), "mm")], label=f"{club}, published", **mark)
        panel.axhline(0.0, color="0.5", linewidth=0.6, zorder=1)
        panel.set_title(label, loc="left")
        panel.set_xlabel("clubhead speed (m/s)")
    legend_above(figure, panels[0].lines[:-1])
    return figure


def displacements() -> dict[str, dict[float, Displacement]]:
    """Return the displaced mass centre by club and loft and by speed [m/s]."""
    curves: dict[str, dict[float, Displacement]] = {}
    for club, loft, least, largest in SWINGS:
        speeds = [speed for speed in SPEEDS if least <= speed <= largest]
        curves[f"{club}, {loft:g}°"] = {speed: displaced_centre(strike(club, speed, loft)) for speed in speeds}
    curves["plane, 12°"] = {speed: displaced_centre(throw(speed, 12.0, FRICTION)) for speed in SPEEDS}
    return curves


def main() -> None:
    """Compute and draw both."""
    folder = Path(__file__).parent
    for name, draw in (("area-term", the_area), ("displaced-centre", lambda: displacement_figure(displacements()))):
        print("wrote", plots.save(draw(), folder / f"{name}.svg"))


if __name__ == "__main__":
    main()
