"""Results of a finite element impact: figures, histories, energies, and fields of stress and strain.

The stress at the centre of an element is the most exact one that a hexahedron has (it is superconvergent), but a wall
under bending has its largest stress at its surface, half an element away: two layers of elements see half of it at
their centres, three layers two thirds. Patch recovery (Zienkiewicz and Zhu, 1992) fits each component of the stress in
the elements round a node inside the body by a linear function of the place. A node of the surface takes the value of
the function of the nearest node inside, extrapolated.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.errors import InputError, RunError
from clubface.fem.balls import Ball
from clubface.fem.geometry import EDGES, outer_quads
from clubface.fem.heads import ShellHead
from clubface.results.result import Described, Result
from clubface.simulation.results import inputs
from clubface.support.arrays import Floats
from clubface.support.version import __version__

if TYPE_CHECKING:
    from clubface.equipment.balls import Ball as RigidBall
    from clubface.equipment.clubs import Club
    from clubface.fem.core import FemImpact
    from clubface.fem.heads import MeshedHead
    from clubface.fem.settings import Settings
    from clubface.simulation.inputs import Shots
    from clubface.simulation.launch import Launch

__all__ = ["Displacement", "ElementFields", "Impact", "SurfaceRecovery", "displaced_centre", "von_mises"]

COMPONENTS = ("xx", "yy", "zz", "xy", "xz", "yz")
"""Order of the components of tensors."""


@dataclass(frozen=True)
class ElementFields:
    """Stress and strain in the elements of a body.

    Attributes
    ----------
    stress
        Cauchy stress [Pa], shape (frames, elements, components) with :data:`COMPONENTS`; for shells (frames, elements,
        sides, components), the outer side first. In the axes of the frames.
    strain
        Logarithmic strain in the same shape (shear is not doubled); for shells only the elastic part.
    plastic_strain
        Equivalent plastic strain, shape (frames, elements); for shells the largest one through the thickness.

    Notes
    -----
    One-point hexahedra give the values at their centre, fully integrated ones and tetrahedra the average of their
    points; tetrahedra follow hexahedra. Shells
    give the values of their surfaces, or of the outermost points if they have points through the thickness, without
    transverse shear. The numbers have single precision.
    """

    stress: Floats
    strain: Floats
    plastic_strain: Floats

    @classmethod
    def from_core(cls, arrays: Sequence[Floats], frames: int, elements: int, *, shells: bool) -> ElementFields:
        """Return the fields of a body from the core's stress, strain and plastic strain, both sides of elements."""
        shape = (frames, elements, 2, len(COMPONENTS))
        stress, strain = (each.reshape(shape) if shells else each.reshape(shape)[:, :, 0] for each in arrays[:2])
        return cls(stress, strain, arrays[2].reshape(frames, elements))

    @property
    def pressure(self) -> Floats:
        """Minus the mean stress [Pa]; positive in compression."""
        return -self.stress[..., :3].mean(axis=-1)

    @property
    def von_mises(self) -> Floats:
        """Equivalent stress of von Mises [Pa]."""
        return von_mises(self.stress)


def von_mises(stress: NDArray[Any]) -> Floats:
    """Return the equivalent stress of von Mises of tensors, components last."""
    xx, yy, zz, xy, xz, yz = np.moveaxis(stress, -1, 0)
    differences = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.sqrt(0.5 * differences + 3.0 * (xy**2 + xz**2 + yz**2))


def turned(tensors: NDArray[Any], rotation: NDArray[Any]) -> Floats:
    """Return symmetric tensors (components last) in axes in which the old ones are the columns of ``rotation``."""
    xx, yy, zz, xy, xz, yz = np.moveaxis(tensors, -1, 0)
    whole = np.stack([np.stack(row, axis=-1) for row in ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))], axis=-2)
    seen = rotation @ whole @ rotation.T
    return np.stack([seen[..., i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))], axis=-1)


class Impact(Described):
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
        negative [s]; that time is NaN if it does not before the last touch.
    spin_max
        Largest backspin during the impact [rad/s]. On the way it is the rotation that fits the velocities of all nodes
        best, as in ``motion``; the final one, ``backspin``, is the angular momentum over the moment of inertia of the
        undeformed ball. The larger counts, so that it is never less than ``backspin``.
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
    stopped: str | None
    interrupted: bool
    unfinished: bool
    over_edge: bool

    contact: dict[str, NDArray[Any]]
    motion: dict[str, NDArray[Any]]
    energy: dict[str, NDArray[Any]]
    patch: dict[str, NDArray[Any]]
    frame_times: NDArray[Any]
    axes: NDArray[Any]
    attitude: NDArray[Any]
    frame_velocity: NDArray[Any]

    def __init__(
        self,
        record: FemImpact,
        ball: Ball,
        given: dict[str, Any],
        friction: float,
        settings: Settings,
        shots: Shots | None = None,
        head: MeshedHead | None = None,
    ) -> None:
        for name in Impact.__annotations__:
            setattr(self, name, getattr(record, name))
        frames = record.frames
        self.frames: NDArray[Any] = frames[:, : record.ball_nodes]
        self.head_frames: NDArray[Any] = frames[:, record.ball_nodes :]
        self.fields: ElementFields | None = None
        self.head_fields: ElementFields | None = None
        if settings.fields and len(frames):
            of_ball, of_head = record.fields
            self.fields = ElementFields.from_core(of_ball, len(frames), ball.elements, shells=False)
            if head is not None:
                shells = isinstance(head, ShellHead)
                self.head_fields = ElementFields.from_core(of_head, len(frames), head.elements, shells=shells)
        self.ball = ball
        self.given = given
        self.friction = friction
        self.settings = settings
        self.head = head
        self._shots = shots
        self._ball_velocity, self._ball_spin = record.ball_velocity, record.ball_spin
        self._launch = record.launch

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
        delivery, head = self.given, {"name": "plane"}
        if self._shots is not None:
            named = zip(inputs().values(), self._shots.columns, strict=True)
            delivery = {each.name: float(value) for each, value in named if each.group == "delivery"}
            head = {"name": self._shots.club.name} | ({} if self.head is None else {"elements": self.head.elements})
        return {
            "model": {"name": "fem"},
            "ball": {"name": self.ball.name, **self.ball.values(), **self.ball.properties()},
            "head": head,
            "friction": self.friction,
            "delivery": delivery,
            "settings": self.settings.values(),
            "clubface_version": __version__,
        }

    @property
    def elements(self) -> int:
        """Number of elements."""
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

    def check_complete(self) -> None:
        """Raise KeyboardInterrupt for a run that was interrupted, and RunError for one that ended early otherwise."""
        if self.interrupted:
            raise KeyboardInterrupt
        if self.stopped:
            raise RunError(self.stopped)

    def to_result(self) -> Result:
        """Return launch, contact, histories and pictures as a result."""
        from clubface.fem.impact_result import impact_result

        return impact_result(self)

    def relative_velocity(self) -> Floats:
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

    def world_club_velocity(self) -> Floats:
        """Return the velocity of the clubhead's CG in world axes [m/s], shape (records, 3), from that of the ball."""
        along = self.motion["velocity"] - self.relative_velocity() + self.frame_velocity
        return along @ self.axes @ self.attitude.T

    def world_velocity(self) -> Floats:
        """Return the velocity of the ball in world axes [m/s], shape (records, 3)."""
        along = self.motion["velocity"] + self.frame_velocity
        return along @ self.axes @ self.attitude.T

    def world_positions(self, shapes: Floats | None = None) -> Floats:
        """Return the nodes of deformed shapes, by default of the ball, in world axes [m], shape (shapes, nodes, 3).

        The origin is the clubhead's CG at first touch, or the point of a plane where the ball first touches it. For a
        left-handed club the result is the mirror image of the impact.
        """
        return (self.frames if shapes is None else shapes) @ self.attitude.T

    def __repr__(self) -> str:
        state = f", stopped: {self.stopped}" if self.stopped else ""
        return f"<finite element impact of {self.ball.name}: {self.steps} steps in {self.wall:.2f} s{state}>"


FEWEST = 10
"""Tetrahedra round a node of the surface for a fit by themselves: it has four coefficients."""
FLAT = 1e-3
"""Singular values below this share of the largest say that a patch has no extent in a direction."""


@dataclass(frozen=True)
class SurfaceRecovery:
    """How stress at the nodes of a surface follows from that at the centres of elements.

    ``nodes`` are those of the surface, in ascending order, shape (n,), and ``quads`` the quadrilaterals between them,
    shape (m, 4); a triangle has its last corner twice. ``elements`` are those whose stress makes that of each node, and
    ``weights`` their shares, shape (n, most); shares of 0 fill up. ``extrapolated`` says whether each node has a node
    inside to extrapolate from: others, such as those of a wall of one layer, take the mean of the elements round them,
    which do not see how the wall bends.
    """

    nodes: NDArray[Any]
    quads: NDArray[Any]
    elements: NDArray[Any]
    weights: NDArray[Any]
    extrapolated: NDArray[Any]

    @classmethod
    def of_mesh(cls, nodes: NDArray[Any], *elements: NDArray[Any]) -> SurfaceRecovery:
        """Prepare the recovery for a mesh of ``nodes`` [m], shape (k, 3).

        ``elements`` are the nodes of hexahedra, shape (l, 8), of ten-node tetrahedra, shape (l, 10), or of both in this
        order.
        """
        quads = outer_quads(*elements)
        surface = np.unique(quads)
        on_surface = np.isin(np.arange(len(nodes)), surface)
        centres = np.concatenate([nodes[each].mean(axis=1) for each in elements])
        nodes_of = [row for each in elements for row in each]
        owners, members = np.repeat(np.arange(len(nodes_of)), [*map(len, nodes_of)]), np.concatenate(nodes_of)
        order = np.argsort(members, kind="stable")
        around = np.split(owners[order], np.searchsorted(members[order], np.arange(1, len(nodes))))
        # The two ends of the edge in whose middle a node of tetrahedra is.
        ends_of = {int(row[4 + at]): (int(row[i]), int(row[j])) for each in elements if each.shape[1] == 10
                   for row in each for at, (i, j) in enumerate(EDGES)}  # fmt: skip

        def nodes_round(patch: NDArray[Any]) -> NDArray[Any]:
            return np.unique(np.concatenate([nodes_of[each] for each in patch]))

        def from_inside(node: int) -> Patch:
            """Return the patch of the nearest node inside."""
            corners, own = nodes_round(around[node]), around[node]
            near = corners[~on_surface[corners]]
            if near.size == 0:
                return own, np.full(len(own), 1.0 / len(own)), False
            middle = near[((nodes[near] - nodes[node]) ** 2).sum(axis=1).argmin()]
            return around[middle], _shares_at(nodes[node], nodes[middle], centres[around[middle]]), True

        @cache
        def at_corner(node: int) -> tuple[NDArray[Any], NDArray[Any]]:
            """Return the tetrahedra round a corner, which lie at several depths, and the neighbours of few."""
            patch = around[node]
            if len(patch) < FEWEST:
                patch = np.unique(np.concatenate([around[each] for each in nodes_round(patch)]))
            return patch, _shares_at(nodes[node], nodes[node], centres[patch])

        def of_tetrahedra(node: int) -> Patch:
            """Return the patch of a corner; a node in the middle of an edge takes the mean of its ends."""
            ends = ends_of.get(node, (node,))
            patch, shares = (np.concatenate(each) for each in zip(*map(at_corner, ends), strict=True))
            return patch, shares / len(ends), True

        patches = [of_tetrahedra(node) if ends_of else from_inside(node) for node in surface.tolist()]
        most = max(len(shares) for _, shares, _ in patches)
        chosen, weights = np.zeros((len(surface), most), int), np.zeros((len(surface), most))
        for row, (patch, shares, _) in enumerate(patches):
            chosen[row, : len(patch)], weights[row, : len(patch)] = patch, shares
        return cls(surface, quads, chosen, weights, np.array([inside for *_, inside in patches]))

    def at_nodes(self, values: NDArray[Any]) -> Floats:
        """Return at the nodes of the surface what is given at elements, shape (..., elements, components)."""
        return np.einsum("np,...npc->...nc", self.weights, np.asarray(values, float)[..., self.elements, :])


Patch = tuple[NDArray[Any], NDArray[Any], bool]
"""Elements, their shares in a node of the surface, and whether these extrapolate from inside."""


def _shares_at(place: NDArray[Any], middle: NDArray[Any], centres: NDArray[Any]) -> NDArray[Any]:
    """Return the shares of elements in the value at a place of a linear function through theirs about ``middle``."""
    away, there = centres - middle, place - middle
    size = abs(away).max()
    terms = np.column_stack([np.ones(len(away)), away / size])
    return np.array([1.0, *there / size]) @ np.linalg.pinv(terms, rcond=FLAT)


class Displacement(NamedTuple):
    """Where the mass centre of a deformed ball is, as an impulse at one point sees it.

    The impulse acts at the distance R from an undeformed ball's centre. With a mass centre displaced by (``normal``,
    ``up``, ``toe``) it has the moments that the forces of the contact had about the ball's mass centre.

    Attributes
    ----------
    normal
        Displacement away from the face [m], averaged with the force along the face; negative is nearer the face.
    up, toe
        Displacement up the face and towards the toe from the centre of pressure [m], averaged with the normal force.
    moment
        The moment about the toe direction over the normal impulse, less that of a ball that stays round [m]: the
        displacement up the face that would do all by itself. Positive adds backspin.
    """

    normal: float
    up: float
    toe: float
    moment: float


def displaced_centre(impact: Impact) -> Displacement:
    """Return the displacement of the mass centre that the model ``adjusted`` calls dCG, from a finished impact.

    The directions are those of first touch, as in the model. With a head, ``up`` and ``toe`` thus include what the head
    turns and the face curves while the ball is on it.
    """
    if impact.stopped is not None:
        raise InputError("impact", impact, "a complete one")
    patch, motion = impact.patch, impact.motion
    times, record = np.unique(patch["time"], return_inverse=True)
    keys = ("normal", "tangential")
    normal, tangential = (np.bincount(record, weights=patch[key]) for key in keys)
    up, toe = (np.bincount(record, weights=patch["normal"] * patch[key]) for key in ("up", "toe"))
    lever = np.interp(times, motion["time"], motion["radius"])
    along, across = np.trapezoid(tangential, times), np.trapezoid(normal, times)
    nearer = np.trapezoid(tangential * lever, times) / along - 0.5 * impact.ball.diameter
    shift_up, shift_toe = (-np.trapezoid(each, times) / across for each in (up, toe))
    return Displacement(float(nearer), float(shift_up), float(shift_toe), float(shift_up + nearer * along / across))
