"""Published and reference cases: Roh and Lee's impact, and a throw of a ball whose constants are all published.

Roh and Lee: "Analysis of golf ball spin mechanism at impact by FEM".

The reference case also bounds the error of an impact, through finer meshes and other solvers. An energy balance checks
the time steps alone: it is as good on a mesh that is far too coarse.
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
"""Figures computed by Roh and Lee."""
LEAST_FACTOR: float = _ROH_LEE["least_factor"]
"""The smallest compression factor in their paper."""
SPEED, LOFT, RADIUS = (
    units.parse(_ROH_LEE["case"][name], dimension)
    for name, dimension in (("speed", "speed"), ("loft", "angle"), ("ball_radius", "length"))
)
"""Speed [m/s], loft [rad] and ball radius [m] of their case."""
SHAPES = 201
"""Number of recorded shapes, one every 5 us, from which the spin of a section is computed."""


STORED = DATA / "fem_meshes.json"
"""The reference case on meshes up to three times finer, as computed by ``make fem-figures``."""
DEFAULT = 3
"""Refinement of the default mesh, in thirds of the element count along an edge."""


def paper(source: str | os.PathLike[str] | Case = "paper", progress: Progress | None = None) -> Impact:
    """Run the case of Roh and Lee, or a variation of it."""
    chosen = case(source)
    if chosen.head == PLANE:
        raise InputError("case", chosen.name, "a case with a head; run throws at a plane with clubface fem run")
    return chosen.replace(settings={"frames": max(SHAPES, chosen.settings.frames)}).run(progress)


def by_contact(source: str | os.PathLike[str] | Case = "paper", progress: Progress | None = None) -> dict[str, Impact]:
    """Run the case with every contact method, the case's own first; stop after a run that fails."""
    chosen, runs = case(source), dict[str, Impact]()
    for method in sorted(METHODS, key=lambda method: method != chosen.settings.contact):
        runs[method] = paper(chosen.replace(settings={"contact": method}), progress)
        if runs[method].stopped:
            break
    return runs


def section_spin(impact: Impact) -> tuple[Floats, Floats]:
    """Return times [s] and spin [rad/s] as Roh and Lee define it (section 2.3), from the nodes of one section.

    The section contains the mass centre, the normal and the direction up the face. Its spin is the rotation about the
    toe direction that best fits the velocities of its nodes, equally weighted. Velocities are differences of
    neighbouring recorded shapes, so the run must record ``frames``; one every 5 us is enough: the spin of all nodes
    computed in this way agrees with ``motion`` to 0.35 rad/s.
    """
    if len(impact.frames) < 4:
        raise InputError("frames", len(impact.frames), "4 or more; set frames in the settings of the run")
    section = abs(impact.ball.mesh["nodes"][:, 2]) < 1e-9
    if not section.any():
        raise InputError("cube", impact.ball.cube, "even, so that nodes lie in the middle of the ball")
    return fitted_spin(impact, np.where(section, 1.0, 0.0))


def fitted_spin(impact: Impact, weights: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return times [s] and the spin about the toe direction that best fits the velocities of weighted nodes [rad/s]."""
    chosen = weights > 0.0
    share = weights[chosen] / weights.sum()
    # The last shape of a run follows the one before by only a step or so, too close for a difference.
    times = impact.frame_times[:-1]
    shapes = impact.frames[:-1, chosen] @ impact.axes[:2].T
    shapes = shapes - np.einsum("n,tni->ti", share, shapes)[:, None]
    steps = times[2:] - times[:-2]
    speeds = (shapes[2:] - shapes[:-2]) / steps[:, None, None]
    (x, y), (u, v) = np.moveaxis(shapes[1:-1], -1, 0), np.moveaxis(speeds, -1, 0)
    return times[1:-1], ((x * v - y * u) @ share) / ((x * x + y * y) @ share)


def node_average_speed(impact: Impact) -> float:
    """Return the speed after the impact [m/s] of the unweighted mean of all nodes.

    This is Roh and Lee's definition of release velocity (section 2.3); a launch uses the mass-weighted mean. Because
    the ball vibrates, the mean position is tracked from take-off to the end of the run, which must record ``frames``.
    """
    after = impact.frame_times > impact.last_touch
    if after.sum() < 3:
        raise InputError("frames", len(impact.frames), "3 or more after the impact; set frames in the settings")
    places = impact.world_positions()[after].mean(axis=1)
    return float(np.linalg.norm(np.polyfit(impact.frame_times[after], places, 1)[0]))


def table(impact: Impact) -> dict[str, float]:
    """Return Roh and Lee's figures as computed, under the keys of ``PUBLISHED``, and some more.

    ``spin_rpm`` is the launch spin, angular momentum over inertia. ``ball_spin_rpm`` and ``section_spin_rpm`` fit the
    nodes of ball and section at take-off, and ``node_speed_mps`` is the speed of the mean of all nodes; section and
    node values are left out without frames. ``rolling_spin_rpm`` is the spin if the ball rolls off the face.
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
    """Return the compression factor of Eq. (6): the ball rolls off a face it met with the speed ``along`` [m/s]."""
    return 7.0 * radius * spin / (5.0 * along)


SPIN_FACTOR = _rolling_factor(units.to_si(PUBLISHED["section_spin_rpm"], "rpm"), RADIUS, SPEED * math.sin(LOFT))
"""Compression factor that follows from their spin by Eq. (6)."""


def spin_factor(impact: Impact) -> float:
    """Return the compression factor that follows from the backspin by equation 6 of Roh and Lee.

    In this equation the ball rolls off the face; Roh and Lee obtain their f from forces instead, by equations 9 and 11.
    NaN if the impact has no velocity along the face.
    """
    approach = sum(impact.relative_velocity()[:1, 1])
    if not approach > 0.0:
        return math.nan
    return float(_rolling_factor(impact.outcome()["backspin"], 0.5 * impact.ball.diameter, approach))


def figures(impact: Impact) -> dict[str, Any]:
    """Return the table of a run, and its cost."""
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
    ball, friction, settings, progress
        As for :func:`throw`.
    refine
        Factor by which the mesh is refined along every edge.
    element
        Kind of elements: "one-point" or "full".
    """
    made = replace(ball_of(ball).refined(refine), element=element)
    return throw(made, speed=REFERENCE_SPEED, angle=ANGLE, friction=friction, settings=settings, progress=progress)


def other_solvers() -> tuple[list[str], dict[str, list[float]]]:
    """Return the names of independent solvers, and their results by quantity and unit."""
    published = Document.read(DATA / "published_impacts.toml").data["reference"]
    return published["solvers"], published["figures"]


class ErrorBounds(NamedTuple):
    """Relative differences of ball speed and backspin from the reference case on the default mesh."""

    speed_over_meshes: float  # between the default mesh and the finest one
    spin_over_meshes: float
    speed_over_solvers: float  # largest difference from an independent solver
    spin_over_solvers: float
    elements: int  # of the finest mesh


def meshes(ball: Ball, thirds: Sequence[int]) -> list[Ball]:
    """Return a ball on meshes with ``thirds`` / 3 times as many elements along every edge.

    Numbers of elements are rounded: an even number along the cube, and at least one layer per piece.
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
    """Return the stored results of the reference case, coarsest mesh first, and the commit that computed them."""
    return json.loads(STORED.read_text(encoding="utf-8"))


@cache
def error_bounds() -> ErrorBounds:
    """Return the differences between the reference case on the default mesh, the finest mesh and other solvers."""
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
    """Return the note on the error of a finite element launch."""
    return note("error-bounds", **error_bounds()._asdict())
