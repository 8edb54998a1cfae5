"""What bounds the error of a finite element impact: finer meshes, and other solvers, on the reference case.

An energy balance only checks the time steps: it is as good on a mesh that is far too coarse.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

from clubface import units
from clubface.fem.balls import Ball
from clubface.fem.paper import other_solvers
from clubface.fem.result import Impact
from clubface.results.notes import Note, note
from clubface.support.files import DATA

__all__ = ["ErrorBounds", "error_bounds", "error_note", "mesh_row", "meshes", "stored_meshes"]

STORED = DATA / "fem_meshes.json"
"""The reference case on meshes up to three times as fine, as ``make fem-figures`` computes it."""
DEFAULT = 3
"""Elements along an edge of the mesh of a ball's file, in thirds."""


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
