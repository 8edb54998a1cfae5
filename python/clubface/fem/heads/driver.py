"""Parametric hollow driver head: dimensions, walls and targets define a shell mesh; and its file format."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from clubface import units
from clubface.errors import InputError, TargetWarning
from clubface.fem import core
from clubface.fem.core import in_thread
from clubface.fem.heads.added_mass import TRIMS, Place
from clubface.fem.heads.meshed import Part, ShellHead
from clubface.fem.heads.metal import Metal
from clubface.schema import NAME, TEXT, Items, PhysicalValue, Record, Table, check_values, count, file_key
from clubface.support.checks import warn_once

CENTRE, INERTIA = ("cg_x", "cg_y", "cg_z"), ("ixx", "iyy", "izz")
SHAPES: Mapping[str, PhysicalValue] = {
    "loft": PhysicalValue("deg", 0, 40, decimals=4),
    "bulge": PhysicalValue("mm", 100, 10000, decimals=4),
    "roll": PhysicalValue("mm", 100, 10000, decimals=4),
    "width": PhysicalValue("mm", 50, 150, decimals=4),
    "depth": PhysicalValue("mm", 30, 150, decimals=4),
    "crown": PhysicalValue("mm", 8, 60, decimals=4),
    "sole": PhysicalValue("mm", 8, 60, decimals=4),
    "rounding": PhysicalValue("mm", 1, 20, decimals=4),
}
"""In the core's order."""
SHAPE = tuple(SHAPES)
WALLS = ("face_centre", "face_edge", "crown", "sole", "skirt")
TARGETS: Mapping[str, PhysicalValue] = {
    "mass": PhysicalValue("g", 50, 500, decimals=4),
    **dict.fromkeys((*CENTRE, "cg_above"), PhysicalValue("mm", decimals=4)),
    **dict.fromkeys(INERTIA, PhysicalValue("g cm2", decimals=4)),
}
CLOSE = {"mass": ("g", 1e-4), "length": ("mm", 1e-4), "inertia": ("g cm2", 1e-6)}
"""For each dimension, the unit in which a target is shown and the tolerance [SI] within which it counts as met."""


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
    shape: Mapping[str, float] = file_key(Record(SHAPES, SHAPE), "dimensions")
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
