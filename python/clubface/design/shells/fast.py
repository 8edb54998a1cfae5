"""What is quickly known of a design: the rigid head of a coarse mesh, and a plate for the face.

The face is a clamped circular plate of the face's area (Timoshenko and Woinowsky-Krieger 1959, section 19). Its
stiffness under a force in the middle gives the characteristic time, which the model `response` turns into a launch. The
plate is a poor face by itself: the sphere also moves body and edge. What counts is how it changes with the walls.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from clubface.design.shells.rigid import normals, on_face, rigid_values
from clubface.design.shells.study import ShellStudy
from clubface.equipment.models import DEFAULT_MODEL
from clubface.fem.head_tests import striker
from clubface.fem.heads.driver import DriverHead
from clubface.fem.heads.shells import ShellHead
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact
from clubface.support.warning import without_warnings

ELEMENTS = (12, 6, 8)
"""Of the coarse mesh, at most: it weighs the head within 0.1%, and takes a third of the time of the usual one."""
SHARE = 2.0 * math.acos(0.9)
"""Of a half swing, the phase that lies outside 5% and 95% of the change of speed [rad]."""
PATCH, CONTACT = 0.012, 450e-6
"""Usual radius of the ball's patch [m] and time of contact [s] in the hardest blow."""
LONGEST = 400e-6
"""Most that a plate's characteristic time is taken for [s]: the launch of slower faces is not known."""


class FastModel:
    """Tells the quantities of designs without finite elements."""

    def __init__(self, study: ShellStudy) -> None:
        self._study = study

    def __call__(self, design: DriverHead) -> dict[str, float]:
        """Return the quantities of a design [SI]."""
        study = self._study
        elements = tuple(min(own, coarse) for own, coarse in zip(design.elements, ELEMENTS, strict=True))
        with without_warnings():
            head = replace(design, elements=elements).mesh()
            values = rigid_values(head)
            time = plate_time(design, head)
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
                values["stress"] = plate_stress(design, head, force)
        return values


def _launch(study: ShellStudy, club: Any, blow: Any) -> Any:
    toe, high = (np.array([point[axis] for point in blow.points]) for axis in (0, 1))
    return impact(club, blow.delivery, toe=toe, high=high, model=DEFAULT_MODEL, ball=study.ball.rigid)


def face_radius(head: ShellHead) -> float:
    """Return the radius of a circle with the area of the face [m]."""
    areas = np.linalg.norm(normals(head)[on_face(head)], axis=1)
    return math.sqrt(float(areas.sum()) / math.pi)


def plate_time(design: DriverHead, head: ShellHead) -> float:
    """Return the characteristic time of a plate of the mean thickness of the face under the steel sphere [s]."""
    metal, radius = design.metal, face_radius(head)
    thickness = 0.5 * (design.thickness["face_centre"] + design.thickness["face_edge"])
    bending = metal.youngs * thickness**3 / (12.0 * (1.0 - metal.poisson**2))
    stiffness = 16.0 * math.pi * bending / radius**2
    sphere = striker().properties()["mass"]
    reduced = sphere * head.club.mass / (sphere + head.club.mass)
    return (math.pi - SHARE) * math.sqrt(reduced / stiffness)


def plate_stress(design: DriverHead, head: ShellHead, force: float) -> float:
    """Return the bending stress in the middle of a clamped plate under a force spread over the ball's patch [Pa]."""
    ratio = face_radius(head) / PATCH
    moment = force * (1.0 + design.metal.poisson) / (4.0 * math.pi) * (math.log(ratio) + 0.25 / ratio**2)
    return 6.0 * moment / design.thickness["face_centre"] ** 2
