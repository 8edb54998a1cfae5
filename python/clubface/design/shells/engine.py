"""What is known of a head of shells: without a run, by a fast model, and by finite elements.

The fast model has the rigid head of a coarse mesh, and a plate for the face: a clamped circular plate of the face's
area (Timoshenko and Woinowsky-Krieger 1959, section 19). Its stiffness under a force in the middle gives the
characteristic time, which the model `response` turns into a launch. The plate is a poor face by itself: the sphere also
moves body and edge. What counts is how it changes with the walls.
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
from clubface.jobs.store import Finished
from clubface.jobs.workers import in_threads
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact
from clubface.support.checks import without_warnings
from clubface.support.fingerprint import fingerprint


def on_face(head: ShellHead) -> NDArray[Any]:
    """Tell which shells are of the face, shape (shells,)."""
    return np.isin(head.part_of_elements(), list(face_parts(head).values()))


def rigid_values(head: ShellHead) -> dict[str, float]:
    """Return mass, mass of the walls, inertia about the vertical, place of the CG, volume and size of a head [SI].

    The nodes lie on the middle of the walls; volume and size are those of the outside, half a wall farther out. An open
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
"""Times at which the stress of the hardest impact is looked at: as often as ``fem head --impact-speed`` does."""

Task = tuple[str, int]


class Engine:
    """Judges designs by finite elements, several runs at a time, and keeps each run that has finished.

    ``runs`` is how many runs the judgements took, those that were found in the store among them.
    """

    def __init__(self, study: ShellStudy, kept: Finished, workers: int | None) -> None:
        self._study, self._kept, self._workers = study, kept, workers
        self.runs = 0

    def __call__(self, designs: Sequence[Head]) -> list[dict[str, float]]:
        """Return the quantities of designs [SI]; all are NaN where a run failed."""
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
        return [_together(head, [values[number, task] for task in tasks]) for number, head in enumerate(heads)]

    def _run(self, head: ShellHead, task: Task, going: Progress, threads: int) -> dict[str, float]:
        """Return what one run finds; empty if it failed."""
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
    """Return the greatest stress of von Mises in the face [Pa], on either side, over the shapes that a run kept."""
    stress, parts = impact.head_fields.von_mises, head.part_of_elements()
    return {name: float(stress[:, parts == number].max()) for name, number in face_parts(head).items()}


def _together(head: ShellHead, runs: list[dict[str, float]]) -> dict[str, float]:
    """Return all quantities: means of the shots, the greatest stress of the hardest impacts."""
    collected: dict[str, list[float]] = {}
    for quantities in runs:
        for name, value in quantities.items():
            collected.setdefault(name, []).append(value)
    values = {name: (max if name.startswith("stress") else fmean)(each) for name, each in collected.items()}
    values |= rigid_values(head)
    return values if all(runs) else dict.fromkeys(values, math.nan)


SHARE = 2.0 * math.acos(0.9)
"""Phase of a half swing that lies outside 5% and 95% of the change of speed [rad]."""
PATCH, CONTACT = 0.012, 450e-6
"""Usual radius of the ball's patch [m] and time of contact [s] in the hardest impact."""
LONGEST = 400e-6
"""Most that a plate's characteristic time is taken for [s]: the launch of slower faces is not known."""


class FastModel:
    """Tells the quantities of designs without finite elements."""

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
    """Return the radius of a circle with the area of the face [m]."""
    areas = np.linalg.norm(area_vectors(head.nodes, head.quads[on_face(head)]), axis=1)
    return math.sqrt(float(areas.sum()) / math.pi)


def plate_time(wall: FaceWall, head: ShellHead) -> float:
    """Return the characteristic time of a plate of the mean thickness of the face under the steel sphere [s]."""
    metal, radius = wall.metal, face_radius(head)
    bending = metal.youngs * wall.mean**3 / (12.0 * (1.0 - metal.poisson**2))
    stiffness = 16.0 * math.pi * bending / radius**2
    sphere = striker().properties()["mass"]
    reduced = sphere * head.club.mass / (sphere + head.club.mass)
    return (math.pi - SHARE) * math.sqrt(reduced / stiffness)


def plate_stress(wall: FaceWall, head: ShellHead, force: float) -> float:
    """Return the bending stress in the middle of a clamped plate under a force spread over the ball's patch [Pa]."""
    ratio = face_radius(head) / PATCH
    moment = force * (1.0 + wall.metal.poisson) / (4.0 * math.pi) * (math.log(ratio) + 0.25 / ratio**2)
    return 6.0 * moment / wall.centre**2
