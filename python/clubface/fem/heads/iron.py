"""Parametric blade or cavity-back iron: dimensions define a mesh of hexahedra."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from clubface import units
from clubface.errors import InputError, MeshWarning
from clubface.fem import core
from clubface.fem.balls import ELEMENTS
from clubface.fem.core import in_thread
from clubface.fem.geometry import element_masses, sums_at_nodes
from clubface.fem.heads.added_mass import MASSES, Place, spread, spread_note
from clubface.fem.heads.meshed import ROUND, SolidHead, SolidPart
from clubface.fem.heads.metal import Metal
from clubface.schema import NAME, TEXT, Choice, Items, PhysicalValue, Record, Table, check_values, count, file_key
from clubface.support.checks import warn_once

SHAPES: Mapping[str, PhysicalValue] = {
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
"""In the core's order."""
SHAPE = tuple(SHAPES)
GROOVES: Mapping[str, PhysicalValue] = {
    "width": PhysicalValue("mm", 0.1, 20),
    "depth": PhysicalValue("mm", 0, 2),
    "pitch": PhysicalValue("mm", 1, 50),
    "wall": PhysicalValue("mm", 0.05, 10),
}
"""Dimensions of grooves, in the core's order."""
STEEL = Metal(youngs=193e9, poisson=0.29, density=7800.0)


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
    shape: Mapping[str, float] = file_key(Record(SHAPES, SHAPE), "dimensions")
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
