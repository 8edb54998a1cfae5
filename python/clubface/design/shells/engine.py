"""Quantities of a shell head: from its mesh alone, from a fast model, and from finite elements.

The fast model combines the rigid head of a coarse mesh with a clamped circular plate of the face's area (Timoshenko and
Woinowsky-Krieger 1959, section 19). The plate's stiffness under a central force gives the characteristic time, which
the model `response` turns into a launch. The plate alone is a poor face, since the sphere also moves body and edge, but
changes with the walls as a face does.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial
from statistics import fmean
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.design.shells.families import FaceWall, Head, face_parts, mesh_shells
from clubface.design.shells.study import FaceImpact, ShellStudy
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import RunError
from clubface.fem import head_tests
from clubface.fem.core import Progress
from clubface.fem.geometry import area_vectors
from clubface.fem.head_tests import striker
from clubface.fem.heads.meshed import ShellHead
from clubface.fem.run import strike
from clubface.fem.settings import Settings
from clubface.fem.stress import INTERVAL
from clubface.jobs.engine import Job, run as run_job
from clubface.jobs.store import Finished, fingerprint
from clubface.jobs.workers import in_threads
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact
from clubface.support.checks import without_warnings


def on_face(head: ShellHead) -> NDArray[Any]:
    """Return which shells belong to the face, shape (shells,)."""
    return np.isin(head.part_of_elements(), list(face_parts(head).values()))


def rigid_values(head: ShellHead) -> dict[str, float]:
    """Return mass, wall mass, inertia about the vertical, CG position, volume and size of a head [SI].

    Nodes lie on the mid-surface of the walls; volume and size refer to the outside, half a wall farther out. An open
    head has no volume.
    """
    area = np.linalg.norm(area_vectors(head.nodes, head.quads), axis=1)
    wall, club = float(np.average(head.thickness, weights=area)), head.club
    _, lowest, heel = head.nodes.min(axis=0) - 0.5 * wall
    size = np.ptp(head.nodes, axis=0) + wall
    volume = head.volume
    return {
        "mass": club.mass,
        "wall_mass": club.mass - float(head.added.sum()),
        "moment_of_inertia": club.iyy,
        "cg_depth": club.cg_x,
        "cg_height": float(-club.cg_y - lowest),
        "cg_from_heel": float(-club.cg_z - heel),
        **({} if volume is None else {"volume": volume}),
        "heel_to_toe": float(size[2]),
        "sole_to_crown": float(size[1]),
    }


SHAPES = round(Settings.duration / INTERVAL) + 1
"""Number of times at which the stress of the hardest impact is evaluated, as in ``fem head --impact-speed``."""

Task = tuple[str, int]


class Engine:
    """Evaluates designs by finite elements, several runs at a time, and keeps every finished run.

    ``runs`` counts the runs, including those found in the store.
    """

    def __init__(self, study: ShellStudy, kept: Finished, workers: int | None) -> None:
        self._study, self._kept, self._workers = study, kept, workers
        self.runs = 0

    def __call__(self, designs: Sequence[Head]) -> list[dict[str, float]]:
        """Return the quantities of designs [SI]; all are NaN if one of its runs failed."""
        study = self._study
        tasks: list[Task] = [("time", 0), *(("shot", place) for place in range(len(study.delivery.points)))]
        if study.hardest is not None:
            tasks += [("hardest", place) for place in range(len(study.hardest.points))]
        heads = [mesh_shells(design) for design in designs]
        names = [fingerprint(design) for design in designs]
        points = [(number, task) for number in range(len(heads)) for task in tasks]
        self.runs += len(points)

        def compute(point: tuple[int, Task], going: Progress, threads: int) -> dict[str, float]:
            return self._run(heads[point[0]], point[1], going, threads)

        job = Job("runs", points, compute, lambda point: f"{names[point[0]]} {point[1][0]} {point[1][1]}")
        values = run_job(job, partial(in_threads, workers=self._workers), store=self._kept)
        return [_merge_runs(head, [values[number, task] for task in tasks]) for number, head in enumerate(heads)]

    def _run(self, head: ShellHead, task: Task, going: Progress, threads: int) -> dict[str, float]:
        """Return the quantities from one run; empty if it failed."""
        study, (kind, place) = self._study, task
        try:
            if kind == "time":
                return {"characteristic_time": head_tests.characteristic_time(head, threads=threads, progress=going)}
            struck = study.delivery if kind == "shot" else study.hardest
            assert struck is not None
            frames = {"frames": SHAPES, "fields": True} if kind == "hardest" else {}
            settings = Settings(until_separation=True, threads=threads, **frames)
            result = strike(
                head, ball=study.ball, settings=settings, progress=going, **struck.at(struck.points[place])
            )  # fmt: skip
            result.check_complete()
        except RunError:
            return {}
        if kind == "hardest":
            return face_stress(result, head)
        launch = result.launch
        assert launch is not None
        return {"ball_speed": float(launch.get("ball_speed")), "carry": result.flown()["carry"]}


def face_stress(impact: Any, head: ShellHead) -> dict[str, float]:
    """Return the peak von Mises stress in each part of the face [Pa], over both sides and all saved times."""
    stress, parts = impact.head_fields.von_mises, head.part_of_elements()
    return {name: float(stress[:, parts == number].max()) for name, number in face_parts(head).items()}


def _merge_runs(head: ShellHead, runs: list[dict[str, float]]) -> dict[str, float]:
    """Return all quantities: means over the shots, and the greatest stress of the hardest impacts."""
    values = {}
    for name in dict.fromkeys(name for each in runs for name in each):
        values[name] = (max if name.startswith("stress") else fmean)(each[name] for each in runs if name in each)
    values |= rigid_values(head)
    return values if all(runs) else dict.fromkeys(values, math.nan)


SHARE = 2.0 * math.acos(0.9)
"""Phase of a half oscillation outside the range from 5% to 95% of the speed change [rad]."""
PATCH, CONTACT = 0.012, 450e-6
"""Typical contact patch radius [m] and contact time [s] of the hardest impact."""
LONGEST = 400e-6
"""Upper limit on the plate's characteristic time [s], as the launch from slower faces is unknown."""


class FastModel:
    """Evaluates designs without finite elements."""

    def __init__(self, study: ShellStudy) -> None:
        self._study = study

    def __call__(self, design: Head) -> dict[str, float]:
        """Return the quantities of a design [SI]."""
        study = self._study
        with without_warnings():
            head = study.family.coarse(design)
            walls = {name: study.family.face_wall(design, head, head.parts[part].name)
                     for name, part in face_parts(head).items()}  # fmt: skip
            values = rigid_values(head)
            time = min(plate_time(wall, head) for wall in walls.values())
            club = head.club.replace(characteristic_time=min(time, LONGEST))
            launch = _launch(study, club, study.delivery)
            values |= {
                "characteristic_time": time,
                "ball_speed": float(np.mean(launch.get("ball_speed"))),
                "carry": float(np.mean(fly(launch).get("carry"))),
            }
            if study.hardest is not None:
                speed = float(np.max(_launch(study, club, study.hardest).get("ball_speed")))
                force = 0.5 * math.pi * study.ball.properties()["mass"] * speed / CONTACT
                values |= {name: plate_stress(wall, head, force) for name, wall in walls.items()}
        return values


def _launch(study: ShellStudy, club: Club, struck: FaceImpact) -> Any:
    toe, high = (np.array([point[axis] for point in struck.points]) for axis in (0, 1))
    return impact(club, struck.delivery, toe=toe, high=high, model=DEFAULT_MODEL, ball=study.ball.rigid)


def face_radius(head: ShellHead) -> float:
    """Return the radius [m] of the circle with the face's area."""
    areas = np.linalg.norm(area_vectors(head.nodes, head.quads[on_face(head)]), axis=1)
    return math.sqrt(float(areas.sum()) / math.pi)


def plate_time(wall: FaceWall, head: ShellHead) -> float:
    """Return the characteristic time [s] of a plate with the face's mean thickness, struck by the steel sphere."""
    metal, radius = wall.metal, face_radius(head)
    bending = metal.youngs * wall.mean**3 / (12.0 * (1.0 - metal.poisson**2))
    stiffness = 16.0 * math.pi * bending / radius**2
    sphere = striker().properties()["mass"]
    reduced = sphere * head.club.mass / (sphere + head.club.mass)
    return (math.pi - SHARE) * math.sqrt(reduced / stiffness)


def plate_stress(wall: FaceWall, head: ShellHead, force: float) -> float:
    """Return the bending stress [Pa] at the centre of a clamped plate under a force spread over the contact patch."""
    ratio = face_radius(head) / PATCH
    moment = force * (1.0 + wall.metal.poisson) / (4.0 * math.pi) * (math.log(ratio) + 0.25 / ratio**2)
    return 6.0 * moment / wall.centre**2
