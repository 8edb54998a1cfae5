"""Plots of finite element impacts: histories, contact patch, comparison of models, and the case of Roh and Lee."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any

import numpy as np

from clubface.equipment.models import models
from clubface.errors import InputError, Wording
from clubface.fem.paper import LEAST_FACTOR, PUBLISHED, SPEED, section_spin
from clubface.fem.result import Impact
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.simulation.history import History, history
from clubface.units import from_si, to_si

__all__ = [
    "contacts", "impact_picture", "models_picture", "paper_picture", "patch_picture", "sweep_picture", "time_axis",
]  # fmt: skip

EVERY = 120e-6
"""Time between plots of the contact patch [s]."""
ENERGIES = {
    "strain": "elastic", "viscous": "viscous", "plastic": "plastic", "friction": "friction", "damping": "damping",
    "hourglass": "hourglass", "contact": "contact springs",
}  # fmt: skip
FORCE = axis("normal", "normal force", unit="kN")
ALONG = axis("tangential", "force along the face", unit="N")
SLIDING = axis("tangential_velocity", "velocity along the face", unit="m/s")
SPIN = axis("backspin")
LEVEL = Mark("rule", y=0.0, style=-1)


def impact_picture(impact: Impact) -> Picture:
    """Plot force, spin, effective radius and energies of an impact over time."""
    contact, motion, time = impact.contact, impact.motion, time_axis(impact)
    top, low = float(np.max(contact["normal"], initial=0.0)), float(np.min(contact["tangential"], initial=0.0))
    force = Panel(
        [Mark("line", contact["time"], contact["normal"], label="normal"),
         Mark("line", contact["time"], contact["tangential"], style=1, label="along the face"), LEVEL],
        time, axis("normal", "force on the ball", unit="kN",
                   limits=(1.1 * min(low, -0.02 * top), 1.3 * top) if top > 0.0 else (None, None)), legend=True,
    )  # fmt: skip
    spin = Panel([Mark("line", motion["time"], motion["spin"][:, 2], style=2)], time, SPIN)
    least = float(np.min(motion["radius"], initial=0.5 * impact.ball.diameter)) - 0.04 * impact.ball.diameter
    radius = Panel([Mark("line", motion["time"], motion["radius"]), _round(impact)], time, _radius_axis(impact, least))
    energy = impact.energy
    missing = energy["kinetic"][:1] - energy["kinetic"]
    shown = {key: energy[key] for key in ENERGIES if np.max(energy[key], initial=0.0) > 0.0}
    energies = [
        *(Mark("stack", energy["time"], values, style=style, label=ENERGIES[key])
          for (key, values), style in zip(shown.items(), (0, 6, 5, 1, 2, 3, 4), strict=False)),
        Mark("line", energy["time"], missing, style=-2, label="loss of kinetic energy"),
    ]  # fmt: skip
    most = 1.8 * max(float(np.max(missing, initial=0.0)), 1e-12)
    balance = Panel(
        energies, time, axis("kinetic_energy", "where the kinetic energy goes", limits=(0.0, most)), legend=True
    )
    caption = "Force, spin, radius of the ball and energies while ball and face touch"
    return Picture("impact", caption, [[force, spin], [radius, balance]], share_x=True, height=4.3)


def patch_picture(impact: Impact) -> Picture:
    """Plot normal and tangential forces over the contact patch every 0.12 ms, as in figure 5 of Roh and Lee.

    Positive tangential forces create backspin, negative ones reduce it.
    """
    patch = impact.patch
    moments = np.unique(patch["time"])
    wanted = np.arange(EVERY, impact.last_touch - 0.25 * EVERY, EVERY)[:6]
    if not len(wanted):
        wanted = np.array([0.5 * impact.last_touch])
    chosen = list(dict.fromkeys(float(moments[np.argmin(abs(moments - each))]) for each in wanted))
    drawn = np.isin(patch["time"], chosen)
    extent = 1.1 * float(max(abs(patch[key][drawn]).max() for key in ("up", "toe")))
    x, y = (axis(name, like="m", unit="mm", limits=(-extent, extent)) for name in ("to_the_toe", "up_the_face"))
    rows = []
    for key, label in (("normal", "normal force of a node"), ("tangential", "tangential force of a node")):
        high = float(abs(patch[key][drawn]).max())
        colours = axis(key, label, unit="N", limits=(-high if key == "tangential" else 0.0, high))
        row = []
        for moment in chosen:
            at = patch["time"] == moment
            marks = [Mark("points", patch["toe"][at], patch["up"][at], values=patch[key][at], size=8.0)]
            title = f"{from_si(moment, 'us'):.0f} µs"
            row.append(Panel(marks, x, y, title, equal=True, values=colours, diverging=key == "tangential"))
        rows.append(row)
    caption = "Forces of the nodes over the contact patch, seen from the ball's mass centre"
    height = 2.0 * min(6.5 / len(chosen), 1.5) + 1.3
    return Picture("patch", caption, rows, share_x=True, share_y=True, height=height)


def time_axis(impact: Impact) -> Axis:
    """Return a time axis that ends shortly after the last touch, or at the end of the run."""
    last = float(np.max(impact.contact["time"], initial=0.0))
    return axis("time", unit="us", limits=(0.0, max(min(1.25 * impact.last_touch, last) or last, 1e-9)))


def _radius_axis(impact: Impact, least: float | None = None) -> Axis:
    radius = 0.5 * impact.ball.diameter
    return axis("radius", "mass centre to face", limits=(0.7 * radius if least is None else least, 1.05 * radius))


def _round(impact: Impact) -> Mark:
    """Return a line at the radius of the undeformed ball."""
    return Mark("rule", y=0.5 * impact.ball.diameter, style=-1)


def models_picture(impact: Impact) -> Picture:
    """Plot the forces, and the ball's velocity along and distance from the face, for every contact model.

    The contact models use the same ball and the rigid equivalent of the head, which the run must have, with the
    parameters published for its kind of club.
    """
    contact, motion = impact.contact, impact.motion
    curves = {"fem": [
        (contact["time"], contact["normal"]), (contact["time"], contact["tangential"]),
        (motion["time"], impact.relative_velocity()[:, 1]), (motion["time"], motion["radius"]),
    ]}  # fmt: skip
    curves |= {model: _model_curves(impact, each) for model, each in contacts(impact).items()}
    time, panels = time_axis(impact), []
    for place, y in enumerate((FORCE, ALONG, SLIDING, _radius_axis(impact))):
        marks = [
            Mark("line", *shown[place], label=name, style=-1 if name == "fem" else name,
                 size=2.5 if name == "fem" else None)
            for name, shown in curves.items()
        ]  # fmt: skip
        panels.append(Panel([*marks, *[[], [LEVEL], [], [_round(impact)]][place]], time, y))
    caption = "The same impact by the contact models and by finite elements"
    return Picture("models", caption, [panels[:2], panels[2:]], share_x=True, legend=True, height=4.6)


def contacts(impact: Impact) -> dict[str, History]:
    """Compute the same impact with every contact model."""
    if impact.equipment is None:
        raise InputError("impact", Wording("one with a plane"), "one with a head, as the contact models need")
    club, ball = impact.equipment
    named = [name for name, each in models().items() if each.kind == "contact"]
    return {name: history(club, impact.given, model=name, ball=ball) for name in named}


def _model_curves(impact: Impact, contact: History) -> list[tuple[Any, Any]]:
    """Return the curves of a contact model, with directions along the face as at first touch."""
    assert impact.equipment is not None
    sliding = (contact.ball_velocity - contact.club_velocity) @ (impact.attitude @ impact.axes[1])
    distance = impact.equipment[1].radius - contact.penetration
    return [(contact.time, each) for each in (contact.normal_force, np.negative(contact.force_y), sliding, distance)]


def paper_picture(runs: Mapping[str, Impact]) -> Picture:
    """Plot velocities, forces, spin and effective radius over time, as in figures 3, 4, 6 and 7 of Roh and Lee.

    ``runs`` are those of their case or a similar one, by label in the legend. Their values are marked.
    """
    first = next(iter(runs.values()))
    time, last = time_axis(first), first.last_touch
    end, radius = time.limits[1], 0.5 * first.ball.diameter
    published = PUBLISHED
    panels: dict[str, tuple[str, Axis, list[Mark]]] = {
        "speed": ("Fig. 3", axis("speed", "speed", unit="m/s"),
                  [_published([end, end], [published["ball_speed_mps"], published["club_speed_after_mps"]])]),
        "launch": ("Fig. 3", axis("launch"), [_published([end], [to_si(published["launch_deg"], "deg")])]),
        "force": ("Fig. 4", FORCE, [_published([published["peak_force_time_s"]], [published["peak_force_n"]])]),
        "radius": ("Fig. 7", _radius_axis(first), [_round(first), _published(
            [published["contraction_time_s"]], [radius * (1.0 - published["contraction"])])]),
        "along": ("Fig. 6", ALONG, [LEVEL, _published([published["reversal_time_s"]], [0.0])]),
        "sliding": ("Fig. 6", SLIDING, [
            _published([0.0, last], [published["tangential_first_mps"], published["tangential_last_mps"]]),
            Mark("rule", x=published["tangential_least_time_s"], style=-1, dash=2)]),
        "spin": ("Fig. 6", SPIN, [_published([last], [to_si(published["section_spin_rpm"], "rpm")])]),
    }  # fmt: skip
    for dash, (name, impact) in enumerate(runs.items()):
        for key, what, style, x, y in _paper_curves(impact):
            panels[key][2].append(Mark("line", x, y, label=f"{what}, {name}", style=style, dash=dash))
    made = [Panel(marks, time, y, title) for title, y, marks in panels.values()]
    caption = "The case of Roh and Lee over time, with their numbers marked"
    return Picture("paper", caption, [made[:4], [*made[4:], None]], share_x=True, legend=True, height=5.0)


def _published(x: Sequence[Any], y: Sequence[float]) -> Mark:
    return Mark("points", x, y, label="Roh and Lee", style=-2, symbol="x", size=5.0)


def _paper_curves(impact: Impact) -> Iterator[tuple[str, str, int, Any, Any]]:
    """Yield panel, label, style, times and values of each curve of a run."""
    contact, motion, velocity = impact.contact, impact.motion, impact.world_velocity()
    when = motion["time"]
    yield "speed", "ball", 0, when, np.linalg.norm(velocity, axis=1)
    yield "speed", "clubhead", 1, when, np.linalg.norm(impact.world_club_velocity(), axis=1)
    # The ball is at rest at first touch and has no direction.
    yield "launch", "ball", 0, when[1:], np.arctan2(velocity[1:, 1], np.hypot(velocity[1:, 0], velocity[1:, 2]))
    yield "force", "ball", 0, contact["time"], contact["normal"]
    yield "radius", "ball", 0, when, motion["radius"]
    yield "along", "ball", 0, contact["time"], contact["tangential"]
    yield "sliding", "ball", 0, when, impact.relative_velocity()[:, 1]
    with suppress(InputError):  # a run without frames
        yield "spin", "nodes of a section", -1, *section_spin(impact)
    yield "spin", "all nodes", 2, when, motion["spin"][:, 2]


def sweep_picture(rows: Sequence[Mapping[str, Any]], *, published: bool = False) -> Picture:
    """Plot ball speed, launch angle, spin and compression factor over speed and loft, as in figure 8 of Roh and Lee.

    The rows are those of :func:`clubface.fem.sweep.sweep`. ``published`` marks their values: the case of 35 m/s and
    11.5 deg, and the smallest compression factor.
    """
    panels = []
    for key, marked, y in (
        ("ball_speed_mps", "ball_speed_mps", axis("ball_speed", unit="m/s")),
        ("launch_deg", "launch_deg", axis("launch")), ("spin_rpm", "section_spin_rpm", SPIN), ("f", "f", axis("f")),
    ):  # fmt: skip
        marks = []
        for place, loft in enumerate(sorted({row["loft_deg"] for row in rows})):
            points = sorted(
                (row["speed_mps"], to_si(row[key], y.unit_drawn)) for row in rows if row["loft_deg"] == loft
            )
            x, values = zip(*points, strict=True)
            label = f"loft {loft:.4g}°"
            marks += [Mark("line", x, values, style=place, label=label),
                      Mark("points", x, values, style=place, symbol=str(place), size=3.0)]  # fmt: skip
        if published:
            marks.append(_published([SPEED], [to_si(PUBLISHED[marked], y.unit_drawn)]))
            marks += [Mark("rule", y=LEAST_FACTOR, style=-2, dash=2)] * (key == "f")
        panels.append(Panel(marks, axis("speed", unit="m/s"), y))
    caption = "Launch over club speed and loft" + "; the dotted line is the least factor of Roh and Lee" * published
    return Picture("sweep", caption, [panels[:2], panels[2:]], share_x=True, legend=True, height=4.8)
