"""Shafts: built in, from TOML or from code, and the inertia they add to a head during impact."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Protocol

import numpy as np

from clubface import units
from clubface.equipment.attachment import CONTACT_TIME, spatial_inertia
from clubface.equipment.described import EquipmentItem, set_si, sources_of, to_toml
from clubface.errors import InputError
from clubface.schema import NAME, TEXT, Choice, Items, PhysicalValue, Place, file_key, quoted, template
from clubface.simulation.beam import GRIPS, MATCHINGS, Beam, Modes, added_inertia, modes
from clubface.support.checks import check_choice, check_name
from clubface.support.files import builtin_names, builtin_path, is_path

FOLDER = "shafts"
MILLIMETRES = PhysicalValue("mm")
CONTACT_TIMES = PhysicalValue("us", 50, 2000, allowed="from 50 to 2000 us")
FEWEST, MOST = 2, 200
STATIONS = f"a list of {FEWEST} to {MOST} values, one for each station"


def _list(item: PhysicalValue) -> Items:
    return Items(item, FEWEST, MOST, STATIONS)


POSITIVE = _list(PhysicalValue("1", above=0))


class Head(Protocol):
    """Club properties needed by a shaft."""

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        ...

    @property
    def cg(self) -> tuple[float, float, float]:
        """Vector from the CG to the face centre [m]."""
        ...

    @property
    def inertia(self) -> tuple[tuple[float, float, float], ...]:
        """Inertia about the CG [kg m2]."""
        ...


@dataclass(frozen=True, kw_only=True, repr=False)
class Shaft(EquipmentItem):
    """A shaft as a beam on a right-handed club, in SI units and the axes of :class:`clubface.Club`.

    Each list has one value per station, from the tip, where the shaft leaves the hosel, to the butt; values are linear
    between stations. The ``position`` of a station is its distance from the tip [m], 0 for the first. The mass per
    length is in kg/m; bending and torsional stiffness are EI and GJ [N m2]. The mean diameter of the wall [m]
    determines rotary inertia, and by default axial stiffness, EA = 8 EI / diameter² [N], as in a tube of one material.

    The vector from the face centre to the tip is ``hosel`` [m]. At address the shaft has the angle ``lie`` to the
    ground [rad] and leans away from the toe. The hands hold the butt "free", "pinned" with the rotational
    ``grip_stiffness`` [N m/rad], or "clamped"; ``grip_mass`` is that of grip and hands [kg]. ``sources`` gives the
    source of each value, by field.
    """

    SOURCE_GROUPS: ClassVar = {"hosel": ("hosel_x", "hosel_y", "hosel_z")}
    LISTS: ClassVar = (
        "position", "mass_per_length", "bending_stiffness", "torsional_stiffness", "diameter", "axial_stiffness",
    )  # fmt: skip

    name: str = file_key(NAME, "name shown in tables")
    description: str = file_key(TEXT, "one sentence for lists", default="")
    position: tuple[float, ...] = file_key(
        _list(MILLIMETRES), "stations from the tip to the butt", example='["0 mm", "525 mm", "1050 mm"]'
    )
    mass_per_length: tuple[float, ...] = file_key(
        POSITIVE, "kg/m; each list has one value per station", example="[0.064, 0.059, 0.054]"
    )
    bending_stiffness: tuple[float, ...] = file_key(POSITIVE, "EI, N m2", example="[22.0, 43.5, 65.0]")
    torsional_stiffness: tuple[float, ...] = file_key(POSITIVE, "GJ, N m2", example="[10.0, 22.0, 34.0]")
    diameter: tuple[float, ...] = file_key(
        _list(PhysicalValue("mm", above=0)), "mean diameter of the wall", example='["7 mm", "10.6 mm", "14.2 mm"]'
    )
    axial_stiffness: tuple[float, ...] = file_key(
        Items(PhysicalValue("1", above=0), 0, MOST, STATIONS), "EA, N; default: a tube of one material",
        default=(),
    )  # fmt: skip
    hosel_x: float = file_key(MILLIMETRES, "from the face centre to the tip, towards the target", example="-15 mm")
    hosel_y: float = file_key(MILLIMETRES, "from the face centre to the tip, upwards", example="30 mm")
    hosel_z: float = file_key(MILLIMETRES, "from the face centre to the tip, towards the toe", example="-57 mm")
    lie: float = file_key(PhysicalValue("deg", 0, 90), "angle between shaft and ground at address", example="58 deg")
    grip: str = file_key(Choice(GRIPS), "how the hands hold the butt", default="free")
    grip_stiffness: float = file_key(
        PhysicalValue("1", lower=0), "rotational stiffness of a pinned butt, N m/rad", example="0.0", default=0.0
    )
    grip_mass: float = file_key(PhysicalValue("g", lower=0), "mass of grip and hands", example="50 g", default=0.0)
    sources: Mapping[str, str] = file_key(
        sources_of(lambda: Shaft, *LISTS), "source of each value", default_factory=dict, hash=False
    )

    def __post_init__(self) -> None:
        set_si(self)
        if self.position[0] != 0.0 or any(np.diff(self.position) <= 0.0):
            shown = ", ".join(units.show(each, "mm") for each in self.position)
            raise InputError("position", shown, "0 mm at the tip, then increasing")
        for name in self.LISTS[1:]:
            count = len(getattr(self, name))
            if count != len(self.position) and not (name == "axial_stiffness" and not count):
                raise InputError(name, f"{count} values", f"{len(self.position)}, one for each station in position")
        if self.grip_stiffness and self.grip != "pinned":
            raise InputError("grip_stiffness", self.grip_stiffness, 'left out, unless grip = "pinned"')

    @property
    def length(self) -> float:
        """Length from the hosel to the butt [m]."""
        return self.position[-1]

    @property
    def mass(self) -> float:
        """Mass without the grip [kg]."""
        each = np.array(self.mass_per_length)
        return float(0.5 * (each[1:] + each[:-1]) @ np.diff(self.position))

    @property
    def hosel(self) -> tuple[float, float, float]:
        """Vector from the face centre to the tip [m]."""
        return self.hosel_x, self.hosel_y, self.hosel_z

    @property
    def axis(self) -> tuple[float, float, float]:
        """Unit vector from tip to butt."""
        return 0.0, math.sin(self.lie), -math.cos(self.lie)

    def beam(self) -> Beam:
        """Return the shaft as a beam."""
        place, mass, bending, torsion, diameter, axial = (np.array(getattr(self, name)) for name in self.LISTS)
        return Beam(
            place, mass, bending, torsion, axial if len(axial) else 8.0 * bending / diameter**2,
            diameter / math.sqrt(8.0), self.grip, self.grip_stiffness, self.grip_mass,
        )  # fmt: skip

    def modes(self, club: Head) -> Modes:
        """Return the vibration modes of a head on the shaft, in the axes of the club."""
        tip = np.array(club.cg) + np.array(self.hosel)
        return modes(self.beam(), _inertia(club), tip, np.array(self.axis))

    def added_inertia(
        self, club: Head, *, contact_time: float | str = CONTACT_TIME, matching: str = MATCHINGS[0]
    ) -> tuple[tuple[float, ...], ...]:
        """Return the inertia that the shaft adds to a head during impact, for :class:`clubface.Club`.

        Parameters
        ----------
        club
            The head.
        contact_time
            Length of the half-sine force that represents the contact [s], or text with a unit.
        matching
            "motion": the head moves as on the shaft when the force ends. "work": the force does the same work. No
            matrix does both, since the shaft goes on vibrating.

        Returns
        -------
        tuple
            Symmetric positive semidefinite matrix, shape (6, 6) [kg, kg m, kg m2].

        Raises
        ------
        InputError
            The contact time is outside 50 us to 2 ms, or so long that waves return from the hands and no matrix
            reproduces the head's motion.
        """
        check_choice("matching", matching, MATCHINGS)
        time = CONTACT_TIMES.read(contact_time, Place(name="contact_time"))
        try:
            added = added_inertia(np.linalg.inv(self.modes(club).mobility(time, matching)), _inertia(club))
        except ValueError:
            allowed = 'shorter, since waves return from the butt by then, or matching = "work"'
            raise InputError("contact_time", units.show(time, "us"), allowed) from None
        return tuple(tuple(float(each) for each in row) for row in added)

    def to_toml(self) -> str:
        """Return the shaft as TOML text that :meth:`from_text` reads back exactly."""
        return to_toml(self)

    @classmethod
    def builtin(cls, name: str) -> Shaft:
        """Return a built-in shaft: ``"graphite"`` (driver) or ``"steel"`` (iron)."""
        return cls.from_toml(builtin_path("shaft", name, FOLDER))

    @staticmethod
    def template(name: str = "my-shaft") -> str:
        """Return a commented TOML template for your own shaft."""
        check_name(name)
        head = [
            "# A shaft on a right-handed club. Axes: x to the target, y up, z towards the toe.",
            "# Values are text with a unit, or SI numbers (kg/m, N m2, N).",
        ]
        return "\n".join([*head, *template(Shaft, {"name": quoted(name), "description": '""'}), ""])


def _inertia(club: Head) -> Any:
    return np.array(spatial_inertia(club.mass, club.inertia))


def shaft(shaft_or_name: str | os.PathLike[str] | Shaft) -> Shaft:
    """Return a shaft: a built-in one by name, one from a TOML file, or ``shaft_or_name`` itself."""
    if isinstance(shaft_or_name, Shaft):
        return shaft_or_name
    return Shaft.from_toml(shaft_or_name) if is_path(shaft_or_name) else Shaft.builtin(str(shaft_or_name))


def shaft_names() -> tuple[str, ...]:
    """Return the names of the built-in shafts."""
    return builtin_names(FOLDER)
