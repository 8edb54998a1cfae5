"""Parametric heads: a few dimensions define a hollow driver of shells, or a blade or cavity-back iron of hexahedra."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from clubface import _core as core, units
from clubface.errors import InputError, MeshWarning, TargetWarning
from clubface.fem.balls import ELEMENTS
from clubface.fem.core import in_thread
from clubface.fem.geometry import element_masses, sums_at_nodes
from clubface.fem.heads.added_mass import MASSES, TRIMS, Place, spread, spread_note
from clubface.fem.heads.meshed import ROUND, Part, ShellHead, SolidHead, SolidPart
from clubface.fem.heads.metal import Metal
from clubface.schema import NAME, TEXT, Choice, Items, PhysicalValue, Record, Table, check_values, count, file_key
from clubface.support.checks import warn_once

CENTRE, INERTIA = ("cg_x", "cg_y", "cg_z"), ("ixx", "iyy", "izz")
DRIVER_SHAPES: Mapping[str, PhysicalValue] = {
    "loft": PhysicalValue("deg", 0, 40, decimals=4),
    "bulge": PhysicalValue("mm", 100, 10000, decimals=4),
    "roll": PhysicalValue("mm", 100, 10000, decimals=4),
    "width": PhysicalValue("mm", 50, 150, decimals=4),
    "depth": PhysicalValue("mm", 30, 150, decimals=4),
    "crown": PhysicalValue("mm", 8, 60, decimals=4),
    "sole": PhysicalValue("mm", 8, 60, decimals=4),
    "rounding": PhysicalValue("mm", 1, 20, decimals=4),
}
"""Dimensions of a driver, in the core's order."""
WALLS = ("face_centre", "face_edge", "crown", "sole", "skirt")
TARGETS: Mapping[str, PhysicalValue] = {
    "mass": PhysicalValue("g", 50, 500, decimals=4),
    **dict.fromkeys((*CENTRE, "cg_above"), PhysicalValue("mm", decimals=4)),
    **dict.fromkeys(INERTIA, PhysicalValue("g cm2", decimals=4)),
}
CLOSE = {"mass": ("g", 1e-4), "length": ("mm", 1e-4), "inertia": ("g cm2", 1e-6)}
"""For each dimension, the unit in which a target is shown and the tolerance [SI] within which it counts as met."""
IRON_SHAPES: Mapping[str, PhysicalValue] = {
    "loft": PhysicalValue("deg", 0, 70),
    "length": PhysicalValue("mm", 40, 120),
    "heel_height": PhysicalValue("mm", 10, 80),
    "toe_height": PhysicalValue("mm", 15, 100),
    "face": PhysicalValue("mm", 1, 20),
    "sole": PhysicalValue("mm", 1, 40),
    "top": PhysicalValue("mm", 1, 20),
    "rim": PhysicalValue("1", 0.05, 0.5),
    "rounding": PhysicalValue("mm", 0, 20),
}
"""Dimensions of an iron, in the core's order."""
GROOVES: Mapping[str, PhysicalValue] = {
    "width": PhysicalValue("mm", 0.1, 20),
    "depth": PhysicalValue("mm", 0, 2),
    "pitch": PhysicalValue("mm", 1, 50),
    "wall": PhysicalValue("mm", 0.05, 10),
}
"""Dimensions of grooves, in the core's order."""
STEEL = Metal(youngs=193e9, poisson=0.29, density=7800.0)


@dataclass(frozen=True, kw_only=True)
class DriverHead:
    """Design of a driver head; values are text with a unit or SI numbers.

    Attributes
    ----------
    shape
        "loft"; "bulge" and "roll", the radii of the face; "width" from heel to toe, "depth" from face to back, "crown"
        height above and "sole" depth below the face centre; "rounding" between face and body.
    target
        "mass" and, optionally, "cg_x", "cg_y", "cg_z" (from the CG to the face centre), "cg_above" (height of the CG
        above the face normal at the face centre), and "ixx", "iyy", "izz" about the CG.
    scales
        Limits of the factor by which the thickness of crown, sole and skirt is scaled to meet the mass; the face is not
        scaled.
    """

    name: str = file_key(NAME, "name shown in tables")
    description: str = file_key(TEXT, "one sentence", default="")
    elements: tuple[int, int, int] = file_key(
        Items(count(4, 400), 3, 3, "a list of three numbers"),
        "numbers of elements from heel to toe, from sole to crown, and from face to back",
        default=(36, 12, 25),
    )
    scales: tuple[float, float] = file_key(
        Items(PhysicalValue("1", 0.1, 10, allowed="0.1 to 1 and 1 to 10"), 2, 2, "a list of two numbers"),
        "limits of the thickness factor on crown, sole and skirt that adjusts the mass", default=(0.5, 2.0),
    )  # fmt: skip
    shape: Mapping[str, float] = file_key(Record(DRIVER_SHAPES, DRIVER_SHAPES), "dimensions")
    thickness: Mapping[str, float] = file_key(
        Record(dict.fromkeys(WALLS, PhysicalValue("mm", decimals=4)), WALLS), "thickness of walls"
    )
    target: Mapping[str, float] = file_key(Record(TARGETS, ("mass",)), "target mass properties")
    metal: Metal = file_key(Table(Metal), "the metal of all parts", default_factory=Metal)
    trims: Mapping[str, Place] = file_key(TRIMS, "places where mass may be added", default_factory=dict)

    def __post_init__(self) -> None:
        check_values(self)
        low, high = self.scales
        if not low <= 1.0 <= high:
            raise InputError("scales", self.scales, "0.1 to 1 and 1 to 10")

    def values(self) -> dict[str, Any]:
        """Return the design in the core's format."""
        target = self.target
        # The target points from the CG to the face centre, the core's vector from the face centre to the CG.
        centre = [None if key not in target else -target[key] for key in CENTRE]
        return {
            "shape": dict(self.shape), "elements": list(self.elements),
            "thickness": {key: self.thickness[key] for key in WALLS},
            "metal": (self.metal.youngs, self.metal.poisson, self.metal.density), "scales": self.scales,
            "trims": [(name, list(place[:3]), place[3]) for name, place in self.trims.items()],
            "target": {"mass": target["mass"], "centre": centre, "above": target.get("cg_above"),
                       "inertia": [target.get(key) for key in INERTIA]},
        }  # fmt: skip

    def mesh(self) -> ShellHead:
        """Mesh the head, as close to its targets as walls and trim masses allow; warn about targets missed."""
        meshed = in_thread(core.fem_driver, self.values())
        report = {"scale": meshed["scale"], **dict(zip(self.trims, meshed["trims"], strict=True))}
        made = ShellHead(
            name=self.name, description=self.description, nodes=meshed["nodes"].reshape(-1, 3),
            quads=meshed["quads"].reshape(-1, 4), thickness=meshed["thickness"], added=meshed["added"],
            parts=tuple(Part(name, count, self.metal, name == "face") for name, count in meshed["parts"]),
            report=report, asked=self.target, **{name: self.shape[name] for name in ("loft", "bulge", "roll")},
        )  # fmt: skip
        # Report targets that walls and trim masses cannot meet.
        reached = made.reached
        missed = [
            f"{name} {units.from_si(reached[name], unit):.5g} {unit} instead of {units.from_si(asked, unit):.5g} {unit}"
            for name, asked in self.target.items()
            for unit, near in [CLOSE[TARGETS[name].dimension]]
            if abs(reached[name] - asked) > near
        ]
        if missed:
            room = "widen the `scales` of the walls, or give more or larger trims"
            warn_once(f"{self.name}: {', '.join(missed)}; {room}", TargetWarning)
        return made


@dataclass(frozen=True, kw_only=True)
class IronHead:
    """Design of an iron head; values are text with a unit or SI numbers.

    Attributes
    ----------
    shape
        "loft"; "length" of the blade; "heel_height" and "toe_height" of the face; thickness of "face", "sole" and "top"
        line; "rim", the fraction of the blade's height and half length with full thickness, 0.05 to 0.5 (0.5: no
        cavity); "rounding" of the outline's corners.
    grooves
        None for a plain face; otherwise "width" of the grooves from edge to edge, "depth" (less than the blade's
        thickness), "pitch" between the centres of neighbouring grooves, and "wall", the width of each side wall. They
        run from heel to toe, with a land through the face centre. They act in the contact only and are not meshed.
    """

    name: str = file_key(NAME, "name shown in tables")
    description: str = file_key(TEXT, "one sentence", default="")
    elements: tuple[int, int, int] = file_key(
        Items(count(1, 400), 3, 3, "a list of three numbers"),
        "numbers of elements from heel to toe, from sole to top line, and through the blade", default=(40, 24, 2),
    )  # fmt: skip
    element: str = file_key(Choice(ELEMENTS), "kind of elements", default="one-point")
    shape: Mapping[str, float] = file_key(Record(IRON_SHAPES, IRON_SHAPES), "dimensions")
    grooves: Mapping[str, float] | None = file_key(Record(GROOVES, GROOVES), "dimensions of grooves", default=None)
    metal: Metal = file_key(
        Table(Metal, without=("points", "rule")), "the metal; default: a stainless steel", default=STEEL
    )
    masses: Mapping[str, Place] = file_key(
        MASSES, "added masses, such as the hosel's, at places relative to the face centre", default_factory=dict
    )

    def __post_init__(self) -> None:
        check_values(self)
        shape = self.shape
        if 2.0 * shape["rounding"] >= shape["heel_height"]:
            raise InputError("shape.rounding", units.show(shape["rounding"], "mm"), "below half of heel_height")
        if min(self.elements[:2]) < 8:
            raise InputError("elements", self.elements, "three whole numbers from 8, 8 and 1 to 400")
        if self.grooves is not None:
            _check_grooves(self.grooves, shape)

    def mesh(self) -> SolidHead:
        """Mesh the head."""
        meshed = in_thread(core.fem_iron, dict(self.shape), list(self.elements))
        nodes = meshed["nodes"].reshape(-1, 3)
        hexahedra, face = meshed["elements"].reshape(-1, 8)[:, ROUND], meshed["face"].reshape(-1, 4)
        masses = element_masses(nodes, hexahedra, self.metal.density)
        metal = sums_at_nodes(hexahedra, masses / 8.0, len(nodes))
        carried = spread(self.masses, nodes, metal, face)
        if (note := spread_note(carried, negligible=1e-2)) is not None:
            warn_once(f"{self.name}: {note}", MeshWarning)
        return SolidHead(
            name=self.name, description=self.description, nodes=nodes, face=face, grooves=self.grooves,
            parts=(SolidPart(name="head", metal=self.metal, hexahedra=hexahedra),), added=carried.added,
            loft=self.shape["loft"], element=self.element,
            report={name: place[3] for name, place in self.masses.items()},
        )  # fmt: skip


def _check_grooves(grooves: Mapping[str, float], shape: Mapping[str, float]) -> None:
    """Raise InputError for grooves that do not fit each other or the head."""
    shown = {key: units.show(value, "mm") for key, value in grooves.items()}
    if 2.0 * grooves["wall"] > grooves["width"]:
        raise InputError("grooves.wall", shown["wall"], f"at most half of the grooves' width, {shown['width']}")
    if grooves["width"] >= grooves["pitch"]:
        raise InputError("grooves.width", shown["width"], f"below the pitch, {shown['pitch']}, to leave lands between")
    thinnest = min(("face", "sole", "top"), key=lambda key: shape[key])
    if grooves["depth"] >= shape[thinnest]:
        wall = f"shape.{thinnest} is {units.show(shape[thinnest], 'mm')}"
        raise InputError("grooves.depth", shown["depth"], f"less than the blade's thickness; {wall}")
