"""A parametric solid or cavity-back iron: a few dimensions make a mesh of hexahedra."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from clubface import units
from clubface.errors import InputError, MeshWarning
from clubface.fem import core
from clubface.fem.balls import ELEMENTS, element_masses
from clubface.fem.core import beside
from clubface.fem.heads.added_mass import Place, note_of, parsed_places, spread
from clubface.fem.heads.meshed import ROUND, SolidHead, parsed
from clubface.fem.heads.metal import Metal
from clubface.support.checks import check_choice, check_name, check_text, is_count, warn_once

LENGTHS = {
    "length": (0.04, 0.12), "heel_height": (0.01, 0.08), "toe_height": (0.015, 0.1), "face": (1e-3, 0.02),
    "sole": (1e-3, 0.04), "top": (1e-3, 0.02), "rounding": (0.0, 0.02),
}  # fmt: skip
"""Dimensions and their limits [m]."""
SHAPE = ("loft", "length", "heel_height", "toe_height", "face", "sole", "top", "rim", "rounding")
"""In the order of the core."""
GROOVES = {"width": (1e-4, 0.02), "depth": (0.0, 2e-3), "pitch": (1e-3, 0.05), "wall": (5e-5, 0.01)}
"""Dimensions of grooves and their limits [m], in the order of the core."""


@dataclass(frozen=True, kw_only=True)
class IronHead:
    """The design of an iron head; each value is text with a unit or an SI number.

    Attributes
    ----------
    name, description
        Name and description for tables.
    shape
        "loft"; "length" of the blade; "heel_height" and "toe_height" of the face; thickness of "face", "sole" and "top"
        line; "rim", the fraction of the blade's height and half length that is as thick, 0.05 to 0.5 (0.5: no cavity);
        "rounding" of the corners of the outline.
    metal
        The metal; if left out, a stainless steel.
    masses
        Added masses, such as that of the hosel, by name: (x, y, z, mass), the place counted from the face centre.
    grooves
        None for a plain face; otherwise "width" of the grooves from edge to edge, "depth" (less than the thickness of
        the blade), "pitch" from the middle of one groove to that of the next, and "wall", the width of each side wall.
        They run from heel to toe, with a land through the face centre. They act in the contact and are no part of the
        mesh.
    elements
        Numbers of elements from heel to toe, from sole to top line, and through the blade.
    element
        "one-point" or "full".
    """

    name: str
    shape: Mapping[str, Any]
    metal: Metal = field(default_factory=lambda: Metal(youngs=193e9, poisson=0.29, density=7800.0))
    masses: Mapping[str, Place] = field(default_factory=dict)
    grooves: Mapping[str, Any] | None = None
    elements: tuple[int, int, int] = (40, 24, 2)
    element: str = "one-point"
    description: str = ""

    def __post_init__(self) -> None:
        check_name(self.name)
        check_text("description", self.description)
        check_choice("element", self.element, ELEMENTS)
        dimensions = {"loft": "angle", "rim": units.DIMENSIONLESS}
        shape = parsed("shape", self.shape, SHAPE, SHAPE, lambda key: dimensions.get(key, "length"))
        for key, (least, most) in LENGTHS.items():
            if not least <= shape[key] <= most:
                raise InputError(f"shape.{key}", units.show(shape[key], "mm"), units.show_range(least, most, "mm"))
        if not 0.0 <= shape["loft"] <= units.parse("70 deg", "angle"):
            raise InputError("shape.loft", units.show(shape["loft"], "deg"), "0 to 70 deg")
        if not 0.05 <= shape["rim"] <= 0.5:
            raise InputError("shape.rim", shape["rim"], "0.05 to 0.5")
        if 2.0 * shape["rounding"] >= shape["heel_height"]:
            raise InputError("shape.rounding", units.show(shape["rounding"], "mm"), "below half of heel_height")
        if not all(is_count(value, least, 400) for value, least in zip(self.elements, (8, 8, 1), strict=True)):
            raise InputError("elements", self.elements, "three whole numbers from 8, 8 and 1 to 400")
        object.__setattr__(self, "grooves", _grooves(self.grooves, shape))
        object.__setattr__(self, "shape", shape)
        object.__setattr__(self, "masses", parsed_places(self.masses, "mass"))
        object.__setattr__(self, "elements", tuple(self.elements))

    def mesh(self) -> SolidHead:
        """Mesh the head."""
        found = beside(core.fem_iron, [self.shape[key] for key in SHAPE], list(self.elements))
        nodes = found["nodes"].reshape(-1, 3)
        hexahedra, face = found["elements"].reshape(-1, 8)[:, ROUND], found["face"].reshape(-1, 4)
        metal = np.zeros(len(nodes))
        np.add.at(metal, hexahedra, element_masses(nodes, hexahedra, self.metal.density)[:, None] / 8.0)
        carried = spread(self.masses, nodes, metal, face)
        if (note := note_of(carried, negligible=1e-2)) is not None:
            warn_once(f"{self.name}: {note}", MeshWarning)
        return SolidHead(
            name=self.name,
            description=self.description,
            nodes=nodes,
            hexahedra=hexahedra,
            face=face,
            metal=self.metal,
            grooves=self.grooves,
            added=carried.added,
            loft=self.shape["loft"],
            element=self.element,
            report={name: place[3] for name, place in self.masses.items()},
        )


def _grooves(given: Mapping[str, Any] | None, shape: Mapping[str, float]) -> dict[str, float] | None:
    """Return the dimensions of grooves in a head of this shape, checked."""
    if given is None:
        return None
    read = parsed("grooves", given, tuple(GROOVES), tuple(GROOVES), lambda _: "length")
    found = {key: read[key] for key in GROOVES}
    shown = {key: units.show(value, "mm") for key, value in found.items()}
    for key, (least, most) in GROOVES.items():
        if not least <= found[key] <= most:
            raise InputError(f"grooves.{key}", shown[key], units.show_range(least, most, "mm"))
    if 2.0 * found["wall"] > found["width"]:
        raise InputError("grooves.wall", shown["wall"], f"at most half of the grooves' width, {shown['width']}")
    if found["width"] >= found["pitch"]:
        raise InputError(
            "grooves.width", shown["width"], f"below the pitch, {shown['pitch']}, so that lands are left between"
        )
    thinnest = min(("face", "sole", "top"), key=lambda key: shape[key])
    if found["depth"] >= shape[thinnest]:
        wall = f"shape.{thinnest} is {units.show(shape[thinnest], 'mm')}"
        raise InputError("grooves.depth", shown["depth"], f"less than the blade is thick: {wall}")
    return found
