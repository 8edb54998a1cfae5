"""Result of a finite element impact: figures, histories and energies."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from clubface.fem.balls import Ball
from clubface.fem.fields import ElementFields
from clubface.fem.heads import ShellHead
from clubface.simulation.quantities import inputs
from clubface.support.version import __version__

if TYPE_CHECKING:
    from clubface.equipment.balls import Ball as RigidBall
    from clubface.equipment.clubs import Club
    from clubface.fem.heads import MeshedHead
    from clubface.fem.settings import Settings
    from clubface.simulation.inputs import Shots
    from clubface.simulation.launch import Launch


class Impact:
    """One impact, in SI units.

    Attributes
    ----------
    peak_force, peak_force_time
        Largest normal force [N], and its time [s].
    contact_time
        Time of the last touch [s]. It is NaN if the records end with the ball on the face, and so are ``f_prime`` and
        ``f``. The other figures are then those up to the end of the records.
    tangential_max, tangential_min, reversal_time
        Largest and smallest force along the face [N], positive where it makes backspin, and the time at which it turns
        negative [s].
    spin_max
        Largest backspin during the impact [rad/s].
    contraction, contraction_time
        Greatest loss of the distance from mass centre to face, divided by the radius, and its time [s].
    f_prime, f
        Compression factors of Roh and Lee, equations 9 and 11.
    energy_error
        Largest error of the energy balance in the records of ``energy``, divided by the initial kinetic energy. A run
        that stops because of its energy balance keeps the records before that; ``stopped`` then gives the larger error.
    steps, step, wall
        Number of steps, their length [s], and the time of the computation [s].
    stopped
        Why there is no launch: the run failed, was ``interrupted``, or is ``unfinished`` with the ball still on the
        face. None if there is a launch.
    over_edge
        Whether the ball reached round the edge of a meshed face, where contact ends: crown and sole are not touched.
    contact
        Arrays over the steps: time, normal, tangential, toe [N], area [m2].
    motion
        Arrays over the records: time, velocity and spin along the normal, up the face and towards the toe, and radius
        (from mass centre to face) [m].
    energy
        Arrays over fewer records [J]: kinetic, strain, hourglass, viscous, plastic, contact, friction, damping.
    patch
        Arrays over the nodes of the ball in contact at the records: time, up and toe (from the mass centre, along the
        face of first touch [m]), normal and tangential force [N], and area (the part of the undeformed surface that
        belongs to the node [m2]).
    frame_times, frames
        Times [s] and node positions [m] of the deformed shapes of the ball that were asked for. They are in face axes
        of first touch (those of the plane), with the origin at the clubhead's CG at that time (where the ball first
        touches the plane).
    head_frames
        The same for the nodes of a meshed head.
    fields, head_fields
        Stress and strain in the elements of the ball and of a meshed head, at ``frame_times``, in the axes of
        ``frames`` (:class:`ElementFields`); None unless the settings asked for them.
    axes
        Directions at the point of first touch, one in each row, in face axes: normal, up the face, towards the toe.
    attitude
        Rotation from face axes to world axes.
    frame_velocity
        Velocity of the clubhead at first touch along ``axes`` [m/s]; ``motion`` is relative to it.
    ball, friction, settings, given, head
        The inputs; ``head`` is None unless it is meshed.
    """

    peak_force: float
    peak_force_time: float
    contact_time: float
    tangential_max: float
    tangential_min: float
    reversal_time: float
    spin_max: float
    contraction: float
    contraction_time: float
    f_prime: float
    f: float
    energy_error: float
    steps: int
    step: float
    wall: float

    def __init__(
        self,
        found: dict[str, Any],
        ball: Ball,
        given: dict[str, Any],
        friction: float,
        settings: Settings,
        shots: Shots | None = None,
        head: MeshedHead | None = None,
    ) -> None:
        for name in FIGURES:
            setattr(self, name, found[name])
        self.contact: dict[str, NDArray[Any]] = found["contact"]
        self.motion: dict[str, NDArray[Any]] = {
            # A run without records tells its vectors as an array without columns.
            name: values if values.ndim == 1 else values.reshape(-1, 3)
            for name, values in found["motion"].items()
        }
        self.energy: dict[str, NDArray[Any]] = found["energy"]
        self.patch: dict[str, NDArray[Any]] = found["patch"]
        self.frame_times: NDArray[Any] = found["frame_times"]
        shapes = found["frames"].reshape(*found["frames"].shape[:2], 3)
        self.frames: NDArray[Any] = shapes[:, : found["ball_nodes"]]
        self.head_frames: NDArray[Any] = shapes[:, found["ball_nodes"] :]
        self.fields, self.head_fields = _fields(found["fields"], len(self.frames), settings, ball, head)
        self.stopped: str | None = found["stopped"]
        self.interrupted: bool = found["interrupted"]
        self.unfinished: bool = found["unfinished"]
        self.over_edge: bool = found["over_edge"]
        self.axes: NDArray[Any] = found["axes"]
        self.ball = ball
        self.given = given
        self.friction = friction
        self.settings = settings
        self.head = head
        self._shots = shots
        self._ball_velocity = found["ball_velocity"]
        self._ball_spin = found["ball_spin"]
        self._launch = found.get("launch")
        self.frame_velocity: NDArray[Any] = found["frame_velocity"]
        self.attitude: NDArray[Any] = found["attitude"]

    @property
    def equipment(self) -> tuple[Club, RigidBall] | None:
        """The club and the ball as the simple models see them; None for a plane."""
        return None if self._shots is None else (self._shots.club, self._shots.ball)

    @property
    def last_touch(self) -> float:
        """Time of the last touch in the records [s], even if the ball has not left yet; 0 if there is no touch."""
        return float(self.contact["time"][self.contact["normal"] > 0.0][-1:].sum())

    @property
    def provenance(self) -> dict[str, Any]:
        """The inputs in SI units: ball with its materials and mesh, head or plane, delivery, settings, and the version.

        A density of 0 belongs to a core whose density follows from the mass of the ball; "core_density" is that
        density.
        """
        met: dict[str, Any] = {"name": "plane"} if self._shots is None else {"name": self._shots.club.name}
        if self.head is not None:
            met["elements"] = self.head.elements
        return {
            "model": {"name": "fem"},
            "ball": {"name": self.ball.name, **self.ball.values(), **self.ball.properties()},
            "head": met,
            "friction": self.friction,
            "delivery": self._delivery(),
            "settings": self.settings.values(),
            "clubface_version": __version__,
        }

    def _delivery(self) -> dict[str, float]:
        if self._shots is None:
            return self.given

        named = zip(inputs().values(), self._shots.columns, strict=True)
        return {each.name: float(value) for each, value in named if each.group == "delivery"}

    @property
    def elements(self) -> int:
        """Number of hexahedra and shells."""
        return self.ball.elements + (0 if self.head is None else self.head.elements)

    @property
    def normal_velocity(self) -> float:
        """Velocity of the ball along the face normal of first touch after the impact [m/s]."""
        return float(self.axes[0] @ self._ball_velocity)

    @property
    def tangential_velocity(self) -> float:
        """Velocity of the ball up the face after the impact [m/s]."""
        return float(self.axes[1] @ self._ball_velocity)

    @property
    def backspin(self) -> float:
        """Spin of the ball about the toe direction after the impact [rad/s]."""
        return float(self.axes[2] @ self._ball_spin)

    @cached_property
    def launch(self) -> Launch | None:
        """The launch, as by the other models, NaN if the run ended early; None for a ball thrown at a plane."""
        if self._shots is None:
            return None
        from clubface.equipment.parameters import ParameterSet
        from clubface.simulation.launch import Launch

        parameters = ParameterSet(model="fem", club="any", name="as given", values={"friction": self.friction})
        problems = [(0, "the run", self.stopped)] if self.stopped else []
        return Launch(np.asarray(self._launch).reshape(-1, 1), self._shots, "fem", parameters, problems=problems)

    def outcome(self) -> dict[str, float]:
        """Return the quantities of the launch, or velocities and spin after a throw at a plane, by name [SI]."""
        if self.launch is None:
            names = ("normal_velocity", "tangential_velocity", "backspin")
            return {name: getattr(self, name) for name in names}
        return {name: float(self.launch.get(name)) for name in self.launch.quantities()}

    def flown(self) -> dict[str, float]:
        """Return ``carry``, ``side`` and ``apex`` of the flight in still air [m]; empty where nothing flies off."""
        if self.launch is None or self.stopped is not None:
            return {}
        from clubface.simulation.flight import fly

        flight = fly(self.launch)
        return {name: float(flight.get(name)) for name in ("carry", "side", "apex")}

    def relative_velocity(self) -> NDArray[Any]:
        """Return the velocity of the ball relative to the CG of the head, or to the plane [m/s], shape (records, 3).

        The components are along the normal of first touch, up the face (the tangential velocity of Roh and Lee) and
        towards the toe. The velocity of the clubhead follows from that of the ball, because their momentum is
        conserved.
        """
        velocity = self.motion["velocity"]
        if self.equipment is None:
            return velocity
        club, ball = self.equipment
        return velocity + ball.mass / club.mass * (velocity - velocity[:1])

    def world_club_velocity(self) -> NDArray[Any]:
        """Return the velocity of the clubhead's CG in world axes [m/s], shape (records, 3), from that of the ball."""
        along = self.motion["velocity"] - self.relative_velocity() + self.frame_velocity
        return along @ self.axes @ self.attitude.T

    def world_velocity(self) -> NDArray[Any]:
        """Return the velocity of the ball in world axes [m/s], shape (records, 3)."""
        along = self.motion["velocity"] + self.frame_velocity
        return along @ self.axes @ self.attitude.T

    def world_positions(self, shapes: NDArray[Any] | None = None) -> NDArray[Any]:
        """Return the nodes of deformed shapes, by default of the ball, in world axes [m], shape (shapes, nodes, 3).

        The origin is the clubhead's CG at first touch, or the point of a plane where the ball first touches it. For a
        left-handed club the result is the mirror image of the impact.
        """
        return (self.frames if shapes is None else shapes) @ self.attitude.T

    def __repr__(self) -> str:
        state = f", stopped: {self.stopped}" if self.stopped else ""
        return f"<finite element impact of {self.ball.name}: {self.steps} steps in {self.wall:.2f} s{state}>"


FIGURES = tuple(Impact.__annotations__)


def _fields(
    told: list[dict[str, NDArray[Any]]], frames: int, settings: Settings, ball: Ball, head: MeshedHead | None
) -> tuple[ElementFields | None, ElementFields | None]:
    """Return the fields of ball and head."""
    if not settings.fields or frames == 0:
        return None, None

    of_ball = ElementFields.from_core(told[0], frames, ball.elements, shells=False)
    if head is None:
        return of_ball, None
    shells = isinstance(head, ShellHead)
    return of_ball, ElementFields.from_core(told[1], frames, head.elements, shells=shells)
