"""Clubheads: built in, from TOML or from code, checked so that only physically possible bodies reach the core.

The built-in driver and 7-iron are those of Table 1 in "Three-dimensional golf clubhead-ball impact models for drivers
and irons".
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any, ClassVar, Self

from clubface import units
from clubface.equipment.attachment import (
    ADDED_INERTIA,
    CONTACT_TIME,
    added_inputs,
    on_mechanism,
    spatial_inertia,
    symmetric_rows,
)
from clubface.equipment.described import (
    FLAT,
    HANDS,
    EquipmentItem,
    changed,
    check_body,
    set_si,
    sources_of,
    template_lines,
    to_toml,
)
from clubface.errors import ImplausibleWarning, InputError, RuleWarning
from clubface.schema import NAME, TEXT, Choice, Document, PhysicalValue, file_key, quantities, quoted
from clubface.support.checks import check_name, warn_once
from clubface.support.files import builtin_names, builtin_path, is_path

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from clubface.equipment.shafts import Shaft

RIGID = 0.7762
"""Coefficient of restitution of the built-in driver with a rigid face at 160 ft/s (48.8 m/s), struck in front of its CG
by the ball ``modern``, from finite elements."""
GAIN = (8.355e-3, 3.975e-6, -2.081e-5, 5.893e-7)
"""Coefficients for the gain in restitution with a flexible face, of even powers (from the second) of the characteristic
time in units of 100 us. They fit finite elements up to 400 us to 0.0003 (``python studies/face_restitution.py``)."""
UNIT = 100e-6
RANGE = (0.778, 0.86)
"""Allowed restitution of a face, corresponding to 46 to 377 us."""
CLUB_FILES = dict.fromkeys(("shape", "groups"), "clubface.fem.heads.read")
"""Modules that read other formats of club files, by a key that only these formats have.

The module's function ``club_of`` makes a club from a document."""


def restitution(characteristic_time: float) -> float:
    """Return the coefficient of restitution at 160 ft/s for a characteristic time [s] of up to 400 us."""
    square = (characteristic_time / UNIT) ** 2
    gain = 0.0
    for coefficient in reversed(GAIN):
        gain = (gain + coefficient) * square
    return RIGID + gain


def characteristic_time_of(cor: float) -> float:
    """Return the characteristic time [s] for a coefficient of restitution at 160 ft/s, by bisection."""
    least, most = RANGE
    if not least <= cor <= most:
        rigid = f"leave it out for a rigid face, which has {RIGID:.3f} with the ball modern"
        raise InputError("cor", cor, f"from {least} to {most} at 160 ft/s; {rigid}")
    low, high = 0.0, 400e-6
    while (middle := 0.5 * (low + high)) not in (low, high):
        low, high = (middle, high) if restitution(middle) < cor else (low, middle)
    return high


KINDS = ("wood", "hybrid", "iron")
FAMILIES = ("driver", "7-iron")
CATEGORIES = ("drivers", "fairway woods", "hybrids", "irons", "wedges")
"""Categories in lists; the minimum lofts of fairway woods and wedges are ``FAIRWAY_LOFT`` and ``WEDGE_LOFT``."""
FAIRWAY_LOFT, WEDGE_LOFT = units.to_si(13.0, "deg"), units.to_si(42.0, "deg")
TOUR_CLUBS = (
    "driver", "3-wood", "5-wood", "hybrid", "3-iron", "4-iron", "5-iron", "6-iron", "7-iron", "8-iron",
    "9-iron", "pitching-wedge",
)  # fmt: skip
"""Built-in clubs of the tour averages, one per row, in that order."""
CLUB_NAMES = (*TOUR_CLUBS, *(name for name in builtin_names("clubs") if name not in TOUR_CLUBS))
"""All built-in clubs: those of the tours, then the others in alphabetical order. Each club is a file in the folder."""

MOI_LIMIT = 5900e-7
"""Limit [kg m2] about the vertical axis for woods, plus ``MOI_TOLERANCE``; USGA notice on clubhead inertia."""
MOI_TOLERANCE = 100e-7
COR_LIMIT = 0.83
"""Limit for the coefficient of restitution; The Equipment Rules."""
TIME_LIMIT = 239e-6
"""Limit for the characteristic time [s], plus ``TIME_TOLERANCE``; The Equipment Rules."""
TIME_TOLERANCE = 18e-6

MILLIMETRES, MOMENT = PhysicalValue("mm"), PhysicalValue("g cm2")
RADIUS = PhysicalValue("mm", special={FLAT: math.inf})


@dataclass(frozen=True, kw_only=True, repr=False)
class Club(EquipmentItem):
    """A clubhead in SI units, described as a right-handed club (``hand = -1`` marks its mirror image).

    Axes at the static loft: x to the target, y up, z to the right of the target line, which is the toe side.

    Inertia is about the CG. A radius of ``math.inf`` means a flat face. ``hand`` is +1 for right, -1 for left. If left
    out, the characteristic time follows from ``cor``, or is 0 for a rigid face; a flexible face has 20 to 600 us.
    ``sources`` gives the source of each value, by field name.

    ``added_inertia`` is what shaft and hands add to the spatial inertia of the head about its CG during impact, shape
    (6, 6): from velocity and angular velocity to impulse and its moment [kg, kg m, kg m2], in the same axes. Without it
    the head is free. :meth:`on_shaft` computes it for a shaft, :meth:`on_mechanism` for a multibody program.
    """

    SOURCE_GROUPS: ClassVar = {"cg": ("cg_x", "cg_y", "cg_z"), "inertia": ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")}

    name: str = file_key(NAME, "name shown in tables")
    kind: str = file_key(Choice(KINDS), "kind of head", example='"wood"')
    hand: int = file_key(Choice(HANDS), "right or left; all values describe the right-handed club", default=1)
    parameters: str = file_key(Choice(FAMILIES), "published parameter sets to use", default="")
    description: str = file_key(TEXT, "one sentence for lists", default="")
    mass: float = file_key(PhysicalValue("g"), "mass of the clubhead", example="204 g")
    cg_x: float = file_key(MILLIMETRES, "from the CG to the face centre, towards the target", example="42.18 mm")
    cg_y: float = file_key(MILLIMETRES, "from the CG to the face centre, upwards", example="4.34 mm")
    cg_z: float = file_key(MILLIMETRES, "from the CG to the face centre, towards the toe", example="1.0 mm")
    ixx: float = file_key(MOMENT, "moment of inertia about the CG, same axes, at the static loft", example="2843 g cm2")
    iyy: float = file_key(MOMENT, "about the vertical axis: the MOI that the rules limit", example="5679 g cm2")
    izz: float = file_key(MOMENT, "about the heel-toe axis", example="4085 g cm2")
    ixy: float = file_key(MOMENT, "element of the tensor (minus the integral of x y dm)", example="-733 g cm2")
    ixz: float = file_key(MOMENT, "element of the tensor", example="530.2 g cm2")
    iyz: float = file_key(MOMENT, "element of the tensor", example="0.5 g cm2")
    loft: float = file_key(PhysicalValue("deg", 0, 75), "static loft, 0 to 75 deg", example="9.8 deg")
    bulge: float = file_key(RADIUS, 'radius of the face from heel to toe, or "flat"', example="305 mm")
    roll: float = file_key(RADIUS, 'radius of the face from sole to crown, or "flat"', example="305 mm")
    face_width: float = file_key(MILLIMETRES, "width of the face, heel to toe", example="105 mm")
    face_height: float = file_key(MILLIMETRES, "height of the face, along the face", example="55 mm")
    characteristic_time: float = file_key(
        PhysicalValue("us"), "pendulum test of the face; 0 is rigid", example="250 us", default=None
    )
    cor: float | None = file_key(
        PhysicalValue("1"), "alternative: coefficient of restitution at 160 ft/s", example="0.826", default=None
    )
    added_inertia: tuple[tuple[float, ...], ...] | None = file_key(
        ADDED_INERTIA, "inertia that shaft and hands add, about the CG, SI", default=None
    )
    sources: Mapping[str, str] = file_key(
        sources_of(lambda: Club, "added_inertia"), "source of each value", default_factory=dict, hash=False
    )

    def __post_init__(self) -> None:
        if not self.parameters:
            object.__setattr__(self, "parameters", "7-iron" if self.kind == "iron" else "driver")
        if self.added_inertia is not None:
            object.__setattr__(self, "added_inertia", symmetric_rows(self.added_inertia))
        set_si(self)
        self._set_face()
        check_body("club", self.inputs())
        self._warn()

    def _set_face(self) -> None:
        """Set the characteristic time from the restitution if needed; a copied club gives both."""
        given, of_cor = self.characteristic_time, 0.0 if self.cor is None else characteristic_time_of(self.cor)
        if given is not None and self.cor is not None and given != of_cor:
            allowed = f"given without cor = {self.cor}, which describes the same property; leave one of them out"
            raise InputError("characteristic_time", units.show(given, "us"), allowed)
        object.__setattr__(self, "characteristic_time", of_cor if given is None else given)

    def replace(self, **changes: Any) -> Self:
        """Return a copy with fields changed; values are text with a unit or SI numbers: ``mass="200 g"``.

        Changing the characteristic time removes the restitution, and vice versa.
        """
        for one, other in (("characteristic_time", "cor"), ("cor", "characteristic_time")):
            if one in changes:
                changes = {other: None, **changes}
        return changed(self, changes)

    def _warn(self) -> None:
        above = "is above the rule limit of"
        if self.kind != "iron" and self.iyy > MOI_LIMIT + MOI_TOLERANCE:
            shown = f"moment of inertia about the vertical axis {units.fixed(self.iyy, 'g cm2', 0)}"
            warn_once(f"{self.name}: {shown} {above} 5900 g cm2 (tolerance 100)", RuleWarning)
        if self.cor is not None and self.cor > COR_LIMIT:
            warn_once(f"{self.name}: COR {self.cor:.3f} {above} 0.83", RuleWarning)
        elif self.cor is None and self.characteristic_time > (TIME_LIMIT + TIME_TOLERANCE) * (1.0 + 1e-9):
            shown = f"characteristic time {units.fixed(self.characteristic_time, 'us', 0)}"
            warn_once(f"{self.name}: {shown} {above} 239 us (tolerance 18)", RuleWarning)
        if self.mass > 1.0:
            warn_once(f"{self.name}: clubhead mass {self.mass:g} kg; plain numbers are in kg", ImplausibleWarning)

    @property
    def cg(self) -> tuple[float, float, float]:
        """Vector from the CG to the face centre [m], in axes x, y, z."""
        return self.cg_x, self.cg_y, self.cg_z

    @property
    def cg_depth(self) -> float:
        """Distance of the CG behind the plane tangent to the face at its centre [m]; negative in front of it."""
        return self.cg_x * math.cos(self.loft) + self.cg_y * math.sin(self.loft)

    @property
    def cg_height(self) -> float:
        """Height of the CG above the normal through the face centre, along the face [m]; negative below it."""
        return self.cg_x * math.sin(self.loft) - self.cg_y * math.cos(self.loft)

    @property
    def effective_mass(self) -> float:
        """Mass that resists a push along the normal at the face centre, including added inertia [kg]."""
        import numpy as np

        normal = np.array([math.cos(self.loft), math.sin(self.loft), 0.0])
        push = np.concatenate([normal, np.cross(self.cg, normal)])
        return float(1.0 / (push @ np.linalg.solve(np.array(self.spatial_inertia), push)))

    @property
    def category(self) -> str:
        """One of ``CATEGORIES``, by kind and loft."""
        if self.kind == "hybrid":
            return "hybrids"
        if self.kind == "wood":
            return "drivers" if self.loft < FAIRWAY_LOFT else "fairway woods"
        return "irons" if self.loft < WEDGE_LOFT else "wedges"

    @property
    def inertia(self) -> tuple[tuple[float, float, float], ...]:
        """Inertia tensor about the CG [kg m2], shape (3, 3)."""
        return (
            (self.ixx, self.ixy, self.ixz),
            (self.ixy, self.iyy, self.iyz),
            (self.ixz, self.iyz, self.izz),
        )

    def inputs(self) -> dict[str, float]:
        """Return the values [SI] used by the models, under the core's names and in its order."""
        renamed = {"mass": "club_mass", "loft": "static_loft"}
        values = {renamed.get(key, key): getattr(self, key) for key in CLUB_PROPERTIES if key != "cor"}
        return {**values, "hand": float(self.hand), **added_inputs(self.added_inertia)}

    def on_mechanism(self, operational_inertia: ArrayLike) -> Self:
        """Return the club attached to the mechanism of a multibody program.

        ``operational_inertia`` is the spatial inertia of the head as attached, shape (6, 6) [kg, kg m, kg m2]: the
        inverse of J M^-1 J^T, with J the Jacobian of velocity and angular velocity of the head's CG in the head's axes,
        and M the mass matrix of the whole mechanism (O. Khatib, IEEE J. Robot. Autom. 3, 1987, 43-53). Raises
        InputError if it is less than that of the free head in some motion.
        """
        return self.replace(added_inertia=on_mechanism(self.mass, self.inertia, operational_inertia))

    def on_shaft(
        self,
        shaft: str | os.PathLike[str] | Shaft,
        *,
        contact_time: float | str = CONTACT_TIME,
        matching: str = "motion",
    ) -> Self:
        """Return the club on a shaft: a built-in name, the path of a TOML file, or a :class:`clubface.Shaft`.

        ``contact_time`` [s] and ``matching`` are as for :meth:`clubface.Shaft.added_inertia`.
        """
        from clubface.equipment.shafts import shaft as shaft_of

        chosen = shaft_of(shaft)
        added = chosen.added_inertia(self, contact_time=contact_time, matching=matching)
        return self.replace(
            added_inertia=added, sources={**self.sources, "added_inertia": f"on the shaft {chosen.name}"}
        )

    @property
    def spatial_inertia(self) -> tuple[tuple[float, ...], ...]:
        """Spatial inertia about the CG including added inertia, shape (6, 6) [kg, kg m, kg m2]."""
        return spatial_inertia(self.mass, self.inertia, self.added_inertia)

    def to_toml(self) -> str:
        """Return the club as TOML text that :meth:`from_text` reads back exactly."""
        return to_toml(self, () if self.cor is None else ("characteristic_time",))

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Club:
        """Read a club from a TOML file; see :meth:`template` for its format.

        The file may also describe a meshed head, as for :func:`clubface.fem.head`; the club then has the mass, CG,
        inertia and face of the mesh.
        """
        document = Document.read(path)
        for key, module in CLUB_FILES.items():
            if key in document.data:
                return import_module(module).club_of(document)
        return cls.from_document(document)

    @classmethod
    def builtin(cls, name: str) -> Club:
        """Return a built-in club, such as ``"driver"``."""
        return cls.from_toml(builtin_path("club", name, "clubs", CLUB_NAMES))

    @staticmethod
    def template(name: str = "my-club") -> str:
        """Return a commented TOML template for your own club: the built-in driver."""
        check_name(name)
        head = [
            "# A clubhead, described as a right-handed club at its static loft.",
            "# Axes: x to the target, y up, z to the right of the target line (the toe side).",
            "# Values are text with a unit, or SI numbers (kg, m, kg m2, rad).",
        ]
        values = {"name": quoted(name), "hand": '"right"', "parameters": '"driver"', "description": '""',
                  "characteristic_time": "250 us"}  # fmt: skip
        return "\n".join(head + template_lines(Club, values))


CLUB_PROPERTIES = quantities(Club)
"""Numeric properties of a club, by field."""


def club(club_or_name: str | os.PathLike[str] | Club) -> Club:
    """Return a club: a built-in one by name, one from a TOML file, or ``club_or_name`` itself."""
    if isinstance(club_or_name, Club):
        return club_or_name
    return Club.from_toml(club_or_name) if is_path(club_or_name) else Club.builtin(str(club_or_name))
