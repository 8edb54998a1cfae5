"""Published and reference cases: Roh and Lee's impacts, and a ball whose every constant is stated.

Roh and Lee: "Analysis of golf ball spin mechanism at impact by FEM".

The reference case also bounds the error of an impact: by finer meshes, and by other solvers. An energy balance only
checks the time steps: it is as good on a mesh that is far too coarse.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError
from clubface.fem.balls import Ball, ball as ball_of
from clubface.fem.case import PLANE, Case, case
from clubface.fem.core import Progress
from clubface.fem.result import Impact
from clubface.fem.run import throw
from clubface.fem.settings import METHODS, Settings
from clubface.results.notes import Note, note
from clubface.schema import Document
from clubface.support.arrays import Floats
from clubface.support.files import DATA
from clubface.support.renamed import renamed_arguments

__all__ = [
    "PUBLISHED", "SPIN_FACTOR", "ErrorBounds", "by_contact", "error_bounds", "error_note", "fitted_spin",
    "mesh_row", "meshes", "paper", "reference", "section_spin", "spin_factor", "stored_meshes", "table",
]  # fmt: skip

_ROH_LEE = Document.read(DATA / "published_impacts.toml").data["roh-lee"]
PUBLISHED: dict[str, float] = _ROH_LEE["figures"]
"""What Roh and Lee computed."""
LEAST_FACTOR: float = _ROH_LEE["least_factor"]
"""The least compression factor they give."""
SPEED, LOFT, RADIUS = (
    units.parse(_ROH_LEE["case"][name], dimension)
    for name, dimension in (("speed", "speed"), ("loft", "angle"), ("ball_radius", "length"))
)
"""Their case [m/s, rad, m]."""
SHAPES = 201
"""Deformed shapes that are kept, one in 5 us, from which the spin of a section is found."""


STORED = DATA / "fem_meshes.json"
"""The reference case on meshes up to three times as fine, as ``make fem-figures`` computes it."""
DEFAULT = 3
"""Elements along an edge of the mesh of a ball's file, in thirds."""


def paper(source: str | os.PathLike[str] | Case = "paper", progress: Progress | None = None) -> Impact:
    """Run the case of Roh and Lee, or a variation of it."""
    chosen = case(source)
    if chosen.head == PLANE:
        raise InputError("case", chosen.name, "a case with a head; for a throw at a plane use clubface fem run")
    return chosen.replace(settings={"frames": max(SHAPES, chosen.settings.frames)}).run(progress)


def by_contact(source: str | os.PathLike[str] | Case = "paper", progress: Progress | None = None) -> dict[str, Impact]:
    """Run the case by every method of contact, that of the case itself first; a run that stops is the last."""
    chosen, runs = case(source), dict[str, Impact]()
    for method in sorted(METHODS, key=lambda method: method != chosen.settings.contact):
        runs[method] = paper(chosen.replace(settings={"contact": method}), progress)
        if runs[method].stopped:
            break
    return runs


def section_spin(impact: Impact) -> tuple[Floats, Floats]:
    """Return times [s] and the spin of Roh and Lee (section 2.3): that of the nodes of one section [rad/s].

    The section holds the mass centre and the directions along the normal and up the face. Its spin is the rotation
    about the toe direction that fits the velocities of its nodes best, every node alike. Velocities are differences of
    the deformed shapes next in time, so the run must keep ``frames`` (every 5 us is enough: the spin of all nodes found
    in this way is that of ``motion`` to 0.35 rad/s).
    """
    if len(impact.frames) < 4:
        raise InputError("frames", len(impact.frames), "4 or more; ask for them in the settings of the run")
    section = abs(impact.ball.mesh["nodes"][:, 2]) < 1e-9
    if not section.any():
        raise InputError("cube", impact.ball.cube, "even, or no nodes lie in the middle of the ball")
    return fitted_spin(impact, np.where(section, 1.0, 0.0))


def fitted_spin(impact: Impact, weights: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return times [s] and the spin about the toe direction that fits the velocities of weighted nodes [rad/s]."""
    chosen = weights > 0.0
    share = weights[chosen] / weights.sum()
    # The shape at the end of a run stands a step or so after the one before it, too near for a difference.
    times = impact.frame_times[:-1]
    shapes = impact.frames[:-1, chosen] @ impact.axes[:2].T
    shapes = shapes - np.einsum("n,tni->ti", share, shapes)[:, None]
    steps = times[2:] - times[:-2]
    speeds = (shapes[2:] - shapes[:-2]) / steps[:, None, None]
    (x, y), (u, v) = np.moveaxis(shapes[1:-1], -1, 0), np.moveaxis(speeds, -1, 0)
    return times[1:-1], ((x * v - y * u) @ share) / ((x * x + y * y) @ share)


def node_average_speed(impact: Impact) -> float:
    """Return the speed [m/s] of the mean of all nodes after the impact, every node alike.

    Roh and Lee define the release velocity so (section 2.3), while that of a launch is the average over the mass. The
    ball vibrates, so the mean position is followed from take-off to the end of the run, for which it must keep
    ``frames``.
    """
    after = impact.frame_times > impact.last_touch
    if after.sum() < 3:
        raise InputError("frames", len(impact.frames), "3 or more after the impact; ask for them in the settings")
    places = impact.world_positions()[after].mean(axis=1)
    return float(np.linalg.norm(np.polyfit(impact.frame_times[after], places, 1)[0]))


def table(impact: Impact) -> dict[str, float]:
    """Return the computed values of Roh and Lee's figures, under the keys of ``PUBLISHED``, and some more.

    ``spin_rpm`` is that of the launch, which is angular momentum over inertia; ``ball_spin_rpm`` and
    ``section_spin_rpm`` fit the nodes of ball and section at take-off, ``node_speed_mps`` is that of the mean of all
    nodes (both are left out of a run without frames), and ``rolling_spin_rpm`` has the ball roll off the face.
    """
    launch = impact.outcome()
    along, when = impact.relative_velocity()[:, 1], impact.motion["time"]
    least = int(along.argmin())
    last = float(np.interp(impact.last_touch, when, along))
    spin = float(np.interp(impact.last_touch, when, impact.motion["spin"][:, 2]))
    try:
        section = {"section_spin_rpm": units.from_si(float(np.interp(impact.last_touch, *section_spin(impact))), "rpm")}
        nodes = {"node_speed_mps": node_average_speed(impact)}
    except InputError:
        section, nodes = {}, {}
    return {
        "ball_speed_mps": launch["ball_speed"],
        **nodes,
        "launch_deg": units.from_si(launch["launch"], "deg"),
        "club_speed_after_mps": sum(launch[f"club_velocity_{axis}"] ** 2 for axis in "xyz") ** 0.5,
        "spin_rpm": units.from_si(launch["backspin"], "rpm"),
        "ball_spin_rpm": units.from_si(spin, "rpm"),
        **section,
        "rolling_spin_rpm": units.from_si(2.0 * last / impact.ball.diameter, "rpm"),
        "tangential_first_mps": float(along[0]),
        "tangential_least_mps": float(along[least]),
        "tangential_least_time_s": float(when[least]),
        "tangential_last_mps": last,
        "peak_force_n": impact.peak_force,
        "peak_force_time_s": impact.peak_force_time,
        "reversal_time_s": impact.reversal_time,
        "contraction": impact.contraction,
        "contraction_time_s": impact.contraction_time,
        "f_prime": impact.f_prime,
        "f": impact.f,
    }


def _rolling_factor(spin: float, radius: float, along: float) -> float:
    """Return the compression factor of Eq. (6): the ball rolls off the face that it met at ``along`` [m/s]."""
    return 7.0 * radius * spin / (5.0 * along)


SPIN_FACTOR = _rolling_factor(units.to_si(PUBLISHED["section_spin_rpm"], "rpm"), RADIUS, SPEED * math.sin(LOFT))
"""The factor of Eq. (6) that their spin means."""


def spin_factor(impact: Impact) -> float:
    """Return the compression factor that follows from the backspin by equation 6 of Roh and Lee.

    In that equation the ball rolls off the face. Roh and Lee derive their f from the forces instead, by equations 9 and
    11. NaN for an impact without velocity along the face.
    """
    approach = sum(impact.relative_velocity()[:1, 1])
    if not approach > 0.0:
        return math.nan
    return float(_rolling_factor(impact.outcome()["backspin"], 0.5 * impact.ball.diameter, approach))


def figures(impact: Impact) -> dict[str, Any]:
    """Return the table of a run, and what it cost."""
    cost = {"elements": impact.elements, "steps": impact.steps, "wall_s": impact.wall}
    return {**table(impact), "energy_error": impact.energy_error, **cost}


REFERENCE_SPEED = "35 m/s"
ANGLE = "11.5 deg"
FRICTION = 0.35


@renamed_arguments(which="ball")
def reference(
    *,
    ball: str | os.PathLike[str] | Ball = "reference",
    friction: float | str = FRICTION,
    refine: int = 1,
    element: str = "one-point",
    settings: Settings | None = None,
    progress: Progress | None = None,
) -> Impact:
    """Throw the ball of Roh and Lee at a rigid plane, at 35 m/s and 11.5 deg from the normal, for 1000 us.

    Parameters
    ----------
    ball
        The ball: a name, a TOML file or a :class:`Ball`.
    friction
        Coefficient of Coulomb friction.
    refine
        How many times finer the mesh is along every edge.
    element
        The kind of elements: "one-point" or "full".
    settings, progress
        As for :func:`throw`.
    """
    made = replace(ball_of(ball).refined(refine), element=element)
    return throw(made, speed=REFERENCE_SPEED, angle=ANGLE, friction=friction, settings=settings, progress=progress)


def other_solvers() -> tuple[list[str], dict[str, list[float]]]:
    """Return the names of independent solvers, and their results, by quantity and unit."""
    published = Document.read(DATA / "published_impacts.toml").data["reference"]
    return published["solvers"], published["figures"]


class ErrorBounds(NamedTuple):
    """Differences of ball speed and backspin from the reference case on the default mesh, as fractions."""

    speed_over_meshes: float  # from the default mesh to the finest one
    spin_over_meshes: float
    speed_over_solvers: float  # the largest from an independent solver
    spin_over_solvers: float
    elements: int  # of the finest mesh


def meshes(ball: Ball, thirds: Sequence[int]) -> list[Ball]:
    """Return a ball on meshes with ``thirds`` / 3 times as many elements along every edge.

    The number of elements is rounded: an even one along the cube, and at least one layer in each piece.
    """
    made = []
    for each in thirds:
        pieces = tuple(replace(piece, layers=max(1, round(piece.layers * each / 3))) for piece in ball.pieces)
        made.append(replace(ball, cube=max(2, 2 * round(ball.cube * each / 6)), pieces=pieces))
    return made


def mesh_row(impact: Impact) -> dict[str, float]:
    """Return elements, speed, backspin, angle from the normal, and peak force of a throw at a plane."""
    normal, along = impact.normal_velocity, impact.tangential_velocity
    return {
        "elements": impact.elements,
        "ball_speed_mps": math.hypot(normal, along),
        "backspin_rpm": float(units.from_si(impact.backspin, "rpm")),
        "angle_deg": math.degrees(math.atan2(along, normal)),
        "peak_force_n": impact.peak_force,
    }


@cache
def stored_meshes() -> dict[str, Any]:
    """Return the reference case on meshes, the coarsest first, and the commit whose code computed it."""
    return json.loads(STORED.read_text(encoding="utf-8"))


@cache
def error_bounds() -> ErrorBounds:
    """Return the differences of the finest mesh and of other solvers from the reference case."""
    rows = stored_meshes()["rows"]
    own = next(each for each in rows if each["thirds"] == DEFAULT)
    finest = max(rows, key=lambda each: each["elements"])
    _, others = other_solvers()
    speeds = map(math.hypot, others["normal_velocity_mps"], others["tangential_velocity_mps"])

    def largest(key: str, values: Sequence[float]) -> float:
        return max(abs(each / own[key] - 1.0) for each in values)

    return ErrorBounds(
        largest("ball_speed_mps", [finest["ball_speed_mps"]]), largest("backspin_rpm", [finest["backspin_rpm"]]),
        largest("ball_speed_mps", list(speeds)), largest("backspin_rpm", others["backspin_rpm"]),
        int(finest["elements"]),
    )  # fmt: skip


def error_note() -> Note:
    """Return the note on what bounds the error of a launch by finite elements."""
    return note("error-bounds", **error_bounds()._asdict())
