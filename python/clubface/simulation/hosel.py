"""Impulse, moment and energy exchanged between an attached head and its shaft during impact."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

import numpy as np

from clubface.equipment.attachment import ADDED_NAMES, matrix_of
from clubface.equipment.models import model
from clubface.equipment.shafts import Shaft, shaft as shaft_of
from clubface.errors import InputError, Wording
from clubface.results.notes import note
from clubface.results.result import Described, Result
from clubface.results.table import column, table, text
from clubface.simulation.inputs import Delivery
from clubface.simulation.launch import Launch, assumptions_of
from clubface.simulation.pose import rotation_by
from clubface.simulation.provenance import provenance_of

AXES = ("to the target", "up", "towards the toe")
INERTIA = ("ixx", "ixy", "ixz"), ("ixy", "iyy", "iyz"), ("ixz", "iyz", "izz")


@dataclass(frozen=True, eq=False, repr=False)
class HoselReaction(Described):
    """Impulse and moment of the head on its shaft during one impact, and the energy balance.

    Attributes
    ----------
    impulse
        Impulse of the head on the shaft [N s], shape (3,), in the axes of the head at first touch (x to the target, y
        up, z towards the toe while the club stands at its static loft).
    moment
        Angular impulse on the shaft about ``point`` [N m s], in the same axes, shape (3,).
    point
        Reference point, from the CG of the head [m], in the same axes, shape (3,).
    contact_time
        Contact time over which they act [s]; NaN for a model without a time scale.
    head_energy, shaft_energy, ball_energy
        Energy gained by head, shaft and ball [J].
    launch
        The launch of the impact.
    """

    impulse: Any
    moment: Any
    point: Any
    contact_time: float
    head_energy: float
    shaft_energy: float
    ball_energy: float
    launch: Launch

    @property
    def lost_energy(self) -> float:
        """Energy lost to heat, to vibration of the ball or left in the face [J]."""
        return -(self.head_energy + self.shaft_energy + self.ball_energy)

    def to_result(self) -> Result:
        """Return the energy balance, and impulse and moment by axis."""
        ledger = table(
            "energy",
            text("body", ["head", "shaft", "ball", "lost"]),
            column("gain", [self.head_energy, self.shaft_energy, self.ball_energy, self.lost_energy], "J"),
            title="Energy",
        )
        reaction = table(
            "reaction",
            text("axis", list("xyz")),
            text("direction", AXES),
            column("impulse_n_s", self.impulse, "1", digits=3, label="impulse, N s"),
            column("moment_n_m_s", self.moment, "1", digits=4, label="moment, N m s"),
            column("mean_force", self.impulse / self.contact_time, "N"),
            title="Head on shaft, in the axes of the head",
        )
        size = float(np.linalg.norm(self.impulse))
        summary = [note("hosel-energy", gained=self.ball_energy, carried=-self.shaft_energy, lost=self.lost_energy)]
        if self.contact_time > 0.0:
            summary.append(note("hosel-force", force=size / self.contact_time, contact_time=self.contact_time))
        return Result(
            "hosel-reaction", f"{self.launch.club.name}: hosel reaction, by {self.launch.model}", (ledger, reaction),
            summary=tuple(summary), assumptions=assumptions_of([self.launch]), provenance=provenance_of([self.launch]),
        )  # fmt: skip

    def __repr__(self) -> str:
        return str(self.to_result())


def hosel_reaction(launch: Launch, shaft: str | os.PathLike[str] | Shaft | None = None) -> HoselReaction:
    """Compute impulse, moment and energy passed from an attached head to its shaft, from the change of its motion.

    The added inertia moves with the velocity v and angular velocity w of the head: its momenta are A v + B w and B' v +
    D w, in a frame that moves with the velocity of the CG at first touch.

    Parameters
    ----------
    launch
        Launch of a single shot with a club on a shaft, from :func:`clubface.impact`.
    shaft
        The shaft, which locates the hosel. Default: the moment is about the CG.

    Raises
    ------
    InputError
        The head is free, or there are several shots.
    """
    if launch.shape:
        raise InputError("launch", Wording(f"a batch of shape {launch.shape}"), "a single launch")
    values = {name: launch.input(name) for name in ADDED_NAMES}
    if not any(values.values()):
        allowed = 'a club on a shaft, such as clubface.club("driver").on_shaft("graphite")'
        raise InputError("club", Wording(f"{launch.club.name}, a free head"), allowed)
    hand = launch.input("hand")
    # A left-handed head is mirrored in z; angular velocities mirror with the opposite signs.
    mirror = np.array([1.0, 1.0, hand, hand, hand, 1.0])
    added = matrix_of(values) * np.outer(mirror, mirror)
    inertia = np.array([[launch.input(name) for name in row] for row in INERTIA]) * np.outer(mirror[3:], mirror[3:])
    mass = launch.input("club_mass")
    pose = Delivery(**launch.delivery).pose(launch.club, ball=launch.ball, hand=hand)
    club_after, spin_after, ball_velocity, ball_spin = (
        np.array([getattr(launch, f"{name}_{axis}") for axis in "xyz"])
        for name in ("club_velocity", "club_spin", "velocity", "spin")
    )
    contact_time = float(launch.contact_time)
    start = pose.rotation
    # Models in closed form leave the head where it is.
    moving_time = contact_time if model(launch.model).kind != "impulse" else 0.0
    end = np.array(rotation_by(0.5 * (pose.angular_velocity + spin_after), moving_time)) @ start
    before = np.concatenate([np.zeros(3), start.T @ pose.angular_velocity])
    after = np.concatenate([end.T @ (club_after - pose.velocity), end.T @ spin_after])
    first, last = added @ before, added @ after
    # Back to the axes of first touch, in which both are given.
    turn = start.T @ end
    impulse = turn @ last[:3] - first[:3]
    moment = turn @ last[3:] - first[3:]
    point = np.zeros(3) if shaft is None else mirror[:3] * (np.array(launch.club.cg) + shaft_of(shaft).hosel)
    relative = 0.5 * (after @ last - before @ first)
    ball_mass, ball_inertia = launch.input("ball_mass"), launch.input("ball_inertia")
    ball_before = np.array([launch.input(f"ball_{name}") for name in ("backspin", "sidespin", "riflespin")])

    def turning(rotation: Any, spin: Any) -> float:
        own = rotation.T @ spin
        return 0.5 * float(own @ inertia @ own)

    moving = 0.5 * mass * float(club_after @ club_after - pose.velocity @ pose.velocity)
    head_energy = moving + turning(end, spin_after) - turning(start, pose.angular_velocity)
    ball_energy = 0.5 * ball_mass * float(ball_velocity @ ball_velocity)
    ball_energy += 0.5 * ball_inertia * float(ball_spin @ ball_spin - ball_before @ ball_before)
    shaft_energy = float(relative + (start.T @ pose.velocity) @ impulse)
    moment = moment - np.cross(point, impulse)
    return HoselReaction(impulse, moment, point, contact_time, head_energy, shaft_energy, ball_energy, launch)
