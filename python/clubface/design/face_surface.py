"""Launch and flight anywhere on a face: computed on demand, or interpolated for a model that is too slow."""

from __future__ import annotations

import math
import os
import shutil
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import _core as core, units
from clubface.design.contributions import FLOWN, LAUNCHED, QUANTITIES
from clubface.design.dispersion import ImpactSetup
from clubface.equipment.clubs import Club
from clubface.equipment.face import turn_to_sole
from clubface.equipment.models import MODULES
from clubface.errors import RangeWarning, RunError, ShotError
from clubface.jobs.engine import Job, run
from clubface.jobs.store import Finished, store_for, unfinished_folder
from clubface.jobs.workers import in_threads, worker_count
from clubface.simulation.flight import BALL, SPIN, VELOCITY, fly
from clubface.simulation.impact import Tally
from clubface.simulation.results import outputs
from clubface.support.arrays import Floats, ValueLike
from clubface.support.checks import is_silent

CHUNK = 2**16
"""Maximum number of points held in memory."""


class FaceImpacts(NamedTuple):
    """Setup and delivery of the impacts on a face: everything except the impact point."""

    setup: ImpactSetup
    delivery: Mapping[str, Any]

    @property
    def takes_long(self) -> bool:
        """Whether the model is slow (tenths of a second per shot), so that few points can be computed."""
        return self.setup.model in MODULES

    def at(
        self, toe: Floats, high: Floats, *, remark: bool = False, progress: Callable[[int, int], object] | None = None
    ) -> Floats:
        """Return ``QUANTITIES`` [SI] at points [m], shape (quantities, points); NaN where there is no shot.

        ``remark``: warn of shots outside the model's range.
        """
        count = progress and (lambda before, done: progress(before + done, toe.size))
        result, outside = np.empty((len(QUANTITIES), toe.size)), Tally()
        for start in range(0, toe.size, CHUNK):
            some = slice(start, start + CHUNK)
            values = {**self.delivery, "toe": toe[some], "high": high[some]}
            launch, flight = self.setup.strike(values, progress=count and partial(count, start))
            assert flight is not None
            outside.add(launch)
            result[:, some] = [(launch if name in LAUNCHED else flight).get(name) for name in QUANTITIES]
        if remark and not is_silent(RangeWarning):
            outside.warn()
        return result


def run_points(
    struck: FaceImpacts, toe: Floats, high: Floats, *, output: str | os.PathLike[str] | None, workers: int | None,
    progress: Callable[[int, int], object] | None,
) -> Floats:  # fmt: skip
    """Return the same as :meth:`FaceImpacts.at` by finite elements, ``workers`` points at a time (None: one per core).

    Finished points are kept in a folder next to the file ``output``; the same call then resumes.
    """
    from clubface.fem.run import strike
    from clubface.fem.settings import Settings

    worker_count(workers)
    places = list(zip(toe.tolist(), high.tolist(), strict=True))
    setup, friction = struck.setup, struck.setup.parameters.values["friction"]

    def compute(
        place: tuple[float, float], keep_going: Callable[[float, float], object], threads: int
    ) -> list[float | None]:
        try:
            result = strike(
                setup.club, {**struck.delivery, "toe": place[0], "high": place[1]}, ball=setup.ball,
                friction=friction, settings=Settings(until_separation=True, threads=threads), progress=keep_going,
            )  # fmt: skip
            launch = None if result.stopped is not None else result.launch
        except ShotError:
            launch = None
        values = [math.nan if launch is None else float(launch.get(name)) for name in outputs()]
        return [None if math.isnan(each) else each for each in values]

    with _store(output, struck, places) as store:
        job = Job("points", places, compute, lambda place: f"{place[0]!r},{place[1]!r}")
        rows = run(job, partial(in_threads, workers=workers), store=store, progress=progress)
    return _with_flights(setup, np.array([rows[place] for place in places], dtype=float).T)


def finished(output: str | os.PathLike[str] | None) -> None:
    """Remove the store of points once the file is written."""
    if output is not None:
        shutil.rmtree(unfinished_folder(Path(output)), ignore_errors=True)


def _with_flights(setup: ImpactSetup, table: Floats) -> Floats:
    """Return ``QUANTITIES`` from launch outputs, shape (outputs, points)."""
    from clubface.fem.balls import ball

    by_name = dict(zip(outputs(), table, strict=True))
    good = np.isfinite(by_name["velocity_x"])
    result = np.full((len(QUANTITIES), table.shape[1]), np.nan)
    result[: len(LAUNCHED)] = [by_name[name] for name in LAUNCHED]
    if good.any():
        given: dict[str, Any] = {name: by_name[name][good] for name in (*VELOCITY, *SPIN)}
        rigid = ball(setup.ball).rigid.inputs()
        given |= {name: rigid[name] for name in BALL}
        flight = fly(given, air=setup.air, wind=setup.wind, ground=setup.ground, on_error="nan")
        result[len(LAUNCHED) :, good] = [flight.get(name) for name in FLOWN]
    return result


def _store(output: str | os.PathLike[str] | None, struck: FaceImpacts, places: list[tuple[float, float]]) -> Finished:
    from clubface.fem.balls import ball
    from clubface.fem.heads.meshed import mesh_of

    setup = struck.setup
    head = mesh_of(setup.club)
    content = {
        "club": [setup.club.inputs(), None if head is None else head.values()],
        "ball": ball(setup.ball).values(),
        "delivery": dict(struck.delivery),
        "parameters": dict(setup.parameters.values),
        "grid": places,
    }
    folder = None if output is None else unfinished_folder(Path(output))
    return store_for(output, content, remedy=f"finish that with the same command, or remove {folder}")


HEEL_HEIGHT = 30.0 / 54.0
"""Height of an iron's face at the heel over the height at the toe, from the meshed blade ``7-iron``."""
CORNERS = 96
"""Number of corners of the polygon for an ellipse."""
BETWEEN = 20
"""Points along each straight side of a mesh outline, so that it can be clipped anywhere."""


class Outline(NamedTuple):
    """The convex outline of a face, seen along its normal.

    Attributes
    ----------
    corners
        Corners in order, towards the toe and up the face [m], shape (corners, 2).
    origin
        Description of where it comes from.
    """

    corners: Floats
    origin: str

    @property
    def least(self) -> Floats:
        """Lower heel-side corner of the bounding box [m]."""
        return self.corners.min(axis=0)

    @property
    def greatest(self) -> Floats:
        """Upper toe-side corner of the bounding box [m]."""
        return self.corners.max(axis=0)

    def in_core(self) -> core.FaceOutline:
        """Return the outline as the core's type."""
        return core.FaceOutline(self.corners.tolist())

    def holds(self, toe: ValueLike, high: ValueLike, slack: float = 1e-9) -> NDArray[np.bool_]:
        """Return whether points [m] lie inside or on the outline."""
        toe, high = np.broadcast_arrays(np.asarray(toe, float), np.asarray(high, float))
        return self.in_core().holds(toe.reshape(-1), high.reshape(-1), slack).reshape(toe.shape)

    def extent(self, toe: Floats) -> tuple[Floats, Floats]:
        """Return the lowest and the highest point of the face [m] at distances towards the toe [m]."""
        return self.in_core().extent(toe)

    def area(self) -> float:
        """Return the area [m2]."""
        return self.in_core().area()


def outline_of(club: Club) -> Outline:
    """Return the outline of a club's face."""
    size = f"{units.show(club.face_width, 'mm', 4)} by {units.show(club.face_height, 'mm', 4)}"
    if hasattr(club, "head"):
        return _mesh_outline(club)
    width, height = club.face_width / 2.0, club.face_height / 2.0
    if club.kind == "iron":
        heel = -height + 2.0 * height * HEEL_HEIGHT
        # The top line rises from the heel and levels off at the toe, whose upper corner is cut.
        corners = [(-width, -height), (0.9 * width, -height), (width, -0.6 * height), (width, 0.5 * height),
                   (0.7 * width, height), (-width, heel)]  # fmt: skip
        return Outline(np.array(corners), f"assumed: an iron's, {size}")
    angle = np.linspace(0.0, 2.0 * np.pi, CORNERS, endpoint=False)
    corners = np.stack([width * np.cos(angle), height * np.sin(angle)], axis=1)
    return Outline(corners, f"assumed: an ellipse of {size}")


def _mesh_outline(club: Any) -> Outline:
    """Return the convex hull of the face nodes of a meshed club."""
    from scipy.spatial import ConvexHull

    places = club.head.face_places() @ turn_to_sole(club.loft)
    flat = np.stack([places[:, 2], places[:, 1]], axis=1)
    corners = flat[ConvexHull(flat).vertices]
    # The club limits how far from the centre its face can be struck: less if the centre is not in the middle.
    limit = np.array([club.face_width, club.face_height]) / 2.0
    share = np.linspace(0.0, 1.0, BETWEEN, endpoint=False)[None, :, None]
    between = corners[:, None] * (1.0 - share) + np.roll(corners, -1, axis=0)[:, None] * share
    return Outline(np.clip(between.reshape(-1, 2), -limit, limit), "of its mesh")


class Surface(NamedTuple):
    """The quantities at any point of a face, and over a grid that covers its bounding box.

    They extend beyond the outline so that it can be clipped sharply.
    """

    outline: Outline
    at: Callable[[Floats, Floats], Floats]  # quantities [SI] at points [m], shape (quantities, points)
    toe: Floats  # of the grid, towards the toe [m]
    high: Floats  # of the grid, upwards [m]
    table: Floats  # quantities over the grid [SI], shape (quantities, high, toe)
    interpolated: bool = False  # between known points

    def greatest(self, quantity: int) -> tuple[float, float, float]:
        """Return the point [m] where a quantity is greatest, and its value there [SI], from the largest on the grid."""
        best = self.outline.in_core().greatest(
            self.toe.tolist(), self.high.tolist(), self.table[quantity], lambda toe, high: self.at(toe, high)[quantity]
        )
        if best is None:
            raise RunError("no impact point on the face gives a shot")
        return best

    def area(self, quantity: int, least: float) -> float:
        """Return the area [m2] of the face where a quantity is at least ``least``, refining a coarse grid."""
        across, up = self.toe.tolist(), self.high.tolist()
        return self.outline.in_core().area_above(
            across, up, self.table[quantity], least, lambda toe, high: self.at(toe, high)[quantity]
        )


def interpolated_surface(outline: Outline, toe: Floats, high: Floats, table: Floats) -> Surface:
    """Return a surface interpolated between known points by radial basis functions (cubic, about a parabola)."""
    from scipy.interpolate import RBFInterpolator

    across, up = (each.reshape(-1) for each in np.meshgrid(toe, high))
    known = np.isfinite(table).all(axis=0)
    scale = (outline.greatest - outline.least) / 2.0
    places = np.stack([across[known], up[known]], axis=1) / scale
    try:
        through = RBFInterpolator(places, table[:, known].T, kernel="cubic", degree=2)
    except (ValueError, np.linalg.LinAlgError):
        raise RunError(f"only {known.sum()} points on the face give a shot; a map needs a finer grid") from None

    def at(toe: Floats, high: Floats) -> Floats:
        return through(np.stack([toe, high], axis=1) / scale).T

    count = core.face_fine()
    ends = zip(outline.least, outline.greatest, strict=True)
    fine_toe, fine_high = (np.linspace(least, greatest, count) for least, greatest in ends)
    fine = at(*(each.reshape(-1) for each in np.meshgrid(fine_toe, fine_high)))
    return Surface(outline, at, fine_toe, fine_high, fine.reshape(len(QUANTITIES), count, count), interpolated=True)
