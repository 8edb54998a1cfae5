"""Results of a finite element impact: key figures, histories, energies, and fields of stress and strain.

In a hexahedron, stress is most accurate at the centre (it is superconvergent there). A wall in bending, however, has
its largest stress at its surface, half an element away: two layers of elements capture half of it at their centres,
three layers two thirds. Patch recovery (Zienkiewicz and Zhu, 1992) therefore fits each stress component in the elements
around an interior node by a linear function of position; a surface node takes the value extrapolated from the nearest
interior node.
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
    from clubface._core import FemImpact
    from clubface.equipment.balls import Ball as RigidBall
    from clubface.equipment.clubs import Club
    from clubface.fem.heads import MeshedHead
    from clubface.fem.settings import Settings
    from clubface.simulation.inputs import Shots
    from clubface.simulation.launch import Launch

__all__ = ["Displacement", "ElementFields", "Impact", "SurfaceRecovery", "displaced_centre", "von_mises"]

COMPONENTS = ("xx", "yy", "zz", "xy", "xz", "yz")
"""Order of tensor components."""


@dataclass(frozen=True)
class ElementFields:
    """Stress and strain in the elements of a body.

    One-point hexahedra give the values at their centre; fully integrated hexahedra and tetrahedra give the average over
    their points. Tetrahedra follow hexahedra. Shells give the values at their surfaces (at the outermost points if they
    have points through the thickness), without transverse shear. Values have single precision.

    Attributes
    ----------
    stress
        Cauchy stress [Pa] in the axes of the frames, shape (frames, elements, components) with :data:`COMPONENTS`; for
        shells (frames, elements, sides, components), the outer side first.
    strain
        Logarithmic strain in the same shape (tensor shear, not doubled); for shells only the elastic part.
    plastic_strain
        Equivalent plastic strain, shape (frames, elements); for shells the largest through the thickness.
    """

    stress: Floats
    strain: Floats
    plastic_strain: Floats

    @classmethod
    def from_core(cls, arrays: Sequence[Floats], frames: int, elements: int, *, shells: bool) -> ElementFields:
        """Return the fields of a body from the core's stress, strain and plastic strain, which hold two sides each."""
        shape = (frames, elements, 2, len(COMPONENTS))
        stress, strain = (each.reshape(shape) if shells else each.reshape(shape)[:, :, 0] for each in arrays[:2])
        return cls(stress, strain, arrays[2].reshape(frames, elements))

    @property
    def pressure(self) -> Floats:
        """Pressure, the negative mean stress [Pa]; positive in compression."""
        return -self.stress[..., :3].mean(axis=-1)

    @property
    def von_mises(self) -> Floats:
        """Von Mises stress [Pa]."""
        return von_mises(self.stress)


def von_mises(stress: NDArray[Any]) -> Floats:
    """Return the von Mises stress of tensors, components last."""
    xx, yy, zz, xy, xz, yz = np.moveaxis(stress, -1, 0)
    differences = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.sqrt(0.5 * differences + 3.0 * (xy**2 + xz**2 + yz**2))


def turned(tensors: NDArray[Any], rotation: NDArray[Any]) -> Floats:
    """Rotate symmetric tensors (components last) from the axes that are the columns of ``rotation``."""
    whole = tensors[..., [[0, 3, 4], [3, 1, 5], [4, 5, 2]]]
    return (rotation @ whole @ rotation.T)[..., [0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]


class Impact(Described):
    """The result of one impact, in SI units.

    Attributes
    ----------
    peak_force, peak_force_time
        Largest normal force [N] and its time [s].
    contact_time
        Time of the last touch [s]. NaN, like ``f_prime`` and ``f``, if the records end with the ball on the face; the
        other figures then cover the time up to the end of the records.
    tangential_max, tangential_min, reversal_time
        Largest and smallest force along the face [N], positive where it creates backspin, and the time at which it
        turns negative [s], NaN if it does not do so before the last touch.
    spin_max
        Largest backspin during the impact [rad/s]: the larger of the greatest value in ``motion``, whose spin is the
        rotation that best fits the velocities of all nodes, and the final ``backspin``, which is angular momentum over
        the moment of inertia of the undeformed ball.
    contraction, contraction_time
        Largest decrease of the distance from mass centre to face, relative to the radius, and its time [s].
    f_prime, f
        Compression factors of Roh and Lee, equations 9 and 11.
    energy_error
        Largest error of the energy balance in ``energy``, relative to the initial kinetic energy. A run that stops
        because of its energy balance keeps the records before that; ``stopped`` then gives the larger error.
    steps, step, wall
        Number of steps, their length [s], and the computing time [s].
    stopped
        Why there is no launch: the run failed, was ``interrupted``, or is ``unfinished`` with the ball still on the
        face. None if there is a launch.
    over_edge
        Whether the ball reached beyond the edge of a meshed face, where contact ends: crown and sole are never touched.
    contact
        Arrays over time steps: time, normal, tangential, toe [N], area [m2].
    motion
        Arrays over records: time; velocity and spin along the normal, up the face and towards the toe; radius (from
        mass centre to face) [m].
    energy
        Arrays over fewer records [J]: kinetic, strain, hourglass, viscous, plastic, contact, friction, damping.
    patch
        Arrays over the ball's nodes in contact at each record: time; up and toe, the position relative to the mass
        centre along the face of first touch [m]; normal and tangential force [N]; area, the node's share of the
        undeformed surface [m2].
    frame_times, frames
        Times [s] and node positions [m] of the recorded shapes of the ball, in face axes of first touch (the plane's
        axes). The origin is the clubhead's CG at that time (the point where the ball first touches the plane).
    head_frames
        The same for the nodes of a meshed head.
    fields, head_fields
        Stress and strain in the elements of the ball and of a meshed head (:class:`ElementFields`), at
        ``frame_times``, in the axes of ``frames``; None unless requested in the settings.
    axes
        Directions at the point of first touch in face axes, one per row: normal, up the face, towards the toe.
    attitude
        Rotation matrix from face axes to world axes.
    frame_velocity
        Velocity of the clubhead at first touch along ``axes`` [m/s]; ``motion`` is relative to it.
    ball, friction, settings, given, head
        The inputs; ``head`` is None unless meshed.
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
        """The rigid club and ball of the other models; None for a plane."""
        return None if self._shots is None else (self._shots.club, self._shots.ball)

    @property
    def last_touch(self) -> float:
        """Time of the last touch in the records [s], even if the ball is still in contact; 0 if there is none."""
        return float(self.contact["time"][self.contact["normal"] > 0.0][-1:].sum())

    @property
    def provenance(self) -> dict[str, Any]:
        """The inputs in SI units: ball with materials and mesh, head or plane, delivery, settings, and the version.

        A density of 0 marks a core whose density follows from the mass of the ball; "core_density" is that density.
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
        """Total number of elements."""
        return self.ball.elements + (0 if self.head is None else self.head.elements)

    @property
    def normal_velocity(self) -> float:
        """Velocity of the ball after the impact along the face normal of first touch [m/s]."""
        return float(self.axes[0] @ self._ball_velocity)

    @property
    def tangential_velocity(self) -> float:
        """Velocity of the ball after the impact up the face [m/s]."""
        return float(self.axes[1] @ self._ball_velocity)

    @property
    def backspin(self) -> float:
        """Spin of the ball after the impact about the toe direction [rad/s]."""
        return float(self.axes[2] @ self._ball_spin)

    @cached_property
    def launch(self) -> Launch | None:
        """The launch, as from the other models; NaN if the run ended early, None for a ball thrown at a plane."""
        if self._shots is None:
            return None
        from clubface.equipment.parameters import ParameterSet
        from clubface.simulation.launch import Launch

        parameters = ParameterSet(model="fem", club="any", name="as given", values={"friction": self.friction})
        problems = [(0, "the run", self.stopped)] if self.stopped else []
        return Launch(np.asarray(self._launch).reshape(-1, 1), self._shots, "fem", parameters, problems=problems)

    def outcome(self) -> dict[str, float]:
        """Return the launch quantities, or velocities and spin after a throw at a plane, by name [SI]."""
        if self.launch is None:
            names = ("normal_velocity", "tangential_velocity", "backspin")
            return {name: getattr(self, name) for name in names}
        return {name: float(self.launch.get(name)) for name in self.launch.quantities()}

    def flown(self) -> dict[str, float]:
        """Return ``carry``, ``side`` and ``apex`` of the flight in still air [m]; empty if there is no launch."""
        if self.launch is None or self.stopped is not None:
            return {}
        from clubface.simulation.flight import fly

        flight = fly(self.launch)
        return {name: float(flight.get(name)) for name in ("carry", "side", "apex")}

    def check_complete(self) -> None:
        """Raise KeyboardInterrupt if the run was interrupted, RunError if it ended early for another reason."""
        if self.interrupted:
            raise KeyboardInterrupt
        if self.stopped:
            raise RunError(self.stopped)

    def to_result(self) -> Result:
        """Return launch, contact, histories and pictures as a result."""
        from clubface.fem.impact_result import impact_result

        return impact_result(self)

    def relative_velocity(self) -> Floats:
        """Return the ball's velocity relative to the head's CG, or to the plane [m/s], shape (records, 3).

        The components are along the normal of first touch, up the face (Roh and Lee's tangential velocity) and towards
        the toe. The clubhead's velocity follows from the ball's by conservation of momentum.
        """
        velocity = self.motion["velocity"]
        if self.equipment is None:
            return velocity
        club, ball = self.equipment
        return velocity + ball.mass / club.mass * (velocity - velocity[:1])

    def world_club_velocity(self) -> Floats:
        """Return the velocity of the clubhead's CG in world axes [m/s], shape (records, 3), from the ball's."""
        along = self.motion["velocity"] - self.relative_velocity() + self.frame_velocity
        return along @ self.axes @ self.attitude.T

    def world_velocity(self) -> Floats:
        """Return the velocity of the ball in world axes [m/s], shape (records, 3)."""
        along = self.motion["velocity"] + self.frame_velocity
        return along @ self.axes @ self.attitude.T

    def world_positions(self, shapes: Floats | None = None) -> Floats:
        """Return the nodes of deformed shapes, by default the ball's, in world axes [m], shape (shapes, nodes, 3).

        The origin is the clubhead's CG at first touch, or the point where the ball first touches a plane. For a
        left-handed club the result is the mirror image of the impact.
        """
        return (self.frames if shapes is None else shapes) @ self.attitude.T

    def __repr__(self) -> str:
        state = f", stopped: {self.stopped}" if self.stopped else ""
        return f"<finite element impact of {self.ball.name}: {self.steps} steps in {self.wall:.2f} s{state}>"


FEWEST = 10
"""Minimum number of tetrahedra around a surface node for a fit of its own, which has four coefficients."""
FLAT = 1e-3
"""Singular values below this fraction of the largest mean that a patch has no extent in a direction."""


@dataclass(frozen=True)
class SurfaceRecovery:
    """Recovery of stress at surface nodes from stress at element centres.

    ``nodes`` are the surface nodes in ascending order, shape (n,), and ``quads`` the quadrilaterals between them, shape
    (m, 4); a triangle repeats its last corner. ``elements`` are the elements whose stress determines each node's, and
    ``weights`` their weights, shape (n, most), padded with 0. ``extrapolated`` says whether each node has an interior
    node to extrapolate from; the others, such as in a wall of one layer, take the mean of the elements around them,
    which misses how the wall bends.
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
        # The two ends of the edge on which each mid-edge node lies.
        ends_of = {int(row[4 + at]): (int(row[i]), int(row[j])) for each in elements if each.shape[1] == 10
                   for row in each for at, (i, j) in enumerate(EDGES)}  # fmt: skip

        def nodes_round(patch: NDArray[Any]) -> NDArray[Any]:
            return np.unique(np.concatenate([nodes_of[each] for each in patch]))

        def from_inside(node: int) -> Patch:
            """Return the patch of the nearest interior node."""
            corners, own = nodes_round(around[node]), around[node]
            near = corners[~on_surface[corners]]
            if near.size == 0:
                return own, np.full(len(own), 1.0 / len(own)), False
            middle = near[((nodes[near] - nodes[node]) ** 2).sum(axis=1).argmin()]
            return around[middle], _fit_weights(nodes[node], nodes[middle], centres[around[middle]]), True

        @cache
        def at_corner(node: int) -> tuple[NDArray[Any], NDArray[Any]]:
            """Return the tetrahedra around a corner, which lie at several depths, and their neighbours if few."""
            patch = around[node]
            if len(patch) < FEWEST:
                patch = np.unique(np.concatenate([around[each] for each in nodes_round(patch)]))
            return patch, _fit_weights(nodes[node], nodes[node], centres[patch])

        def of_tetrahedra(node: int) -> Patch:
            """Return the patch of a corner; a mid-edge node averages those of the edge's ends."""
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
        """Interpolate values given per element, shape (..., elements, components), to the surface nodes."""
        return np.einsum("np,...npc->...nc", self.weights, np.asarray(values, float)[..., self.elements, :])


Patch = tuple[NDArray[Any], NDArray[Any], bool]
"""Elements, their weights for a surface node, and whether they extrapolate from inside."""


def _fit_weights(place: NDArray[Any], middle: NDArray[Any], centres: NDArray[Any]) -> NDArray[Any]:
    """Return the weights of elements in a linear fit about ``middle``, evaluated at ``place``."""
    away, there = centres - middle, place - middle
    size = abs(away).max()
    terms = np.column_stack([np.ones(len(away)), away / size])
    return np.array([1.0, *there / size]) @ np.linalg.pinv(terms, rcond=FLAT)


class Displacement(NamedTuple):
    """Displacement of the mass centre of a deformed ball, as seen by an impulse at one point.

    The impulse acts at distance R from the centre of an undeformed ball. If the mass centre is displaced by
    (``normal``, ``up``, ``toe``), it has the same moments as the contact forces had about the ball's mass centre.

    Attributes
    ----------
    normal
        Displacement away from the face [m], averaged with the force along the face; negative means nearer the face.
    up, toe
        Displacement up the face and towards the toe from the centre of pressure [m], averaged with the normal force.
    moment
        Moment about the toe direction divided by the normal impulse, minus the value for a ball that stays round [m]:
        the displacement up the face that has the same effect on its own. Positive adds backspin.
    """

    normal: float
    up: float
    toe: float
    moment: float


def displaced_centre(impact: Impact) -> Displacement:
    """Return the mass centre displacement (dCG of the model ``adjusted``) of a complete impact.

    The directions are those of first touch, as in the model. With a head, ``up`` and ``toe`` therefore include the
    head's rotation and the curvature of the face while the ball is in contact.
    """
    if impact.stopped is not None:
        raise InputError("impact", impact, "a complete impact")
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
