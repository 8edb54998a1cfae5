"""A parametric hollow driver head: a few dimensions, walls and targets make a mesh of shells.

The TOML file of a parametric driver.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from clubface import units
from clubface.errors import InputError, TargetWarning
from clubface.fem import core
from clubface.fem.core import beside
from clubface.fem.heads.added_mass import Place, parsed_places
from clubface.fem.heads.meshed import Part, ShellHead, parsed
from clubface.fem.heads.metal import Metal
from clubface.support.checks import check_name, check_text, is_count, warn_once
from clubface.support.strict_toml import quoted

SHAPE = ("loft", "bulge", "roll", "width", "depth", "crown", "sole", "rounding")
WALLS = ("face_centre", "face_edge", "crown", "sole", "skirt")
CENTRE, INERTIA = ("cg_x", "cg_y", "cg_z"), ("ixx", "iyy", "izz")
TARGETS = ("mass", *CENTRE, "cg_above", *INERTIA)
CLOSE = {"mass": ("g", 1e-4), "length": ("mm", 1e-4), "inertia": ("g cm2", 1e-6)}
"""The unit in which a target is told, and how near [SI] it counts as met."""
_LIMITS = {
    "width": (0.05, 0.15), "depth": (0.03, 0.15), "crown": (0.008, 0.06), "sole": (0.008, 0.06),
    "rounding": (1e-3, 0.02), "bulge": (0.1, 10.0), "roll": (0.1, 10.0),
}  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class DriverHead:
    """The design of a driver head; each value is text with a unit or an SI number.

    Attributes
    ----------
    name, description
        Name and description for tables.
    shape
        "loft"; "bulge" and "roll", the radii of the face; "width" from heel to toe, "depth" from face to back, "crown"
        above and "sole" below the face centre; "rounding" between face and body.
    thickness
        "face_centre", "face_edge", "crown", "sole", "skirt".
    target
        "mass", and where wanted "cg_x", "cg_y", "cg_z" (from the CG to the face centre), "cg_above" (height of the CG
        above the face normal at the face centre), and "ixx", "iyy", "izz" about the CG.
    metal
        The metal of all parts.
    trims
        Places where mass may be added, by name: (x, y, z, most).
    scales
        Limits of the factor on the thickness of crown, sole and skirt by which the mass is met; the face stays as it
        is.
    elements
        Numbers of elements from heel to toe, from sole to crown, and from face to back.
    """

    name: str
    shape: Mapping[str, Any]
    thickness: Mapping[str, Any]
    target: Mapping[str, Any]
    metal: Metal = field(default_factory=Metal)
    trims: Mapping[str, Place] = field(default_factory=dict)
    scales: tuple[float, float] = (0.5, 2.0)
    elements: tuple[int, int, int] = (36, 12, 25)
    description: str = ""

    def __post_init__(self) -> None:
        check_name(self.name)
        check_text("description", self.description)
        shape = parsed("shape", self.shape, SHAPE, SHAPE, lambda key: "angle" if key == "loft" else "length")
        for key, (least, most) in _LIMITS.items():
            if not least <= shape[key] <= most:
                raise InputError(f"shape.{key}", units.show(shape[key], "mm"), units.show_range(least, most, "mm"))
        if not 0.0 <= shape["loft"] <= units.parse("40 deg", "angle"):
            raise InputError("shape.loft", units.show(shape["loft"], "deg"), "0 to 40 deg")
        thickness = parsed("thickness", self.thickness, WALLS, WALLS, lambda _: "length")
        target = parsed("target", self.target, TARGETS, ("mass",), _target_dimension)
        if not 0.05 <= target["mass"] <= 0.5:
            raise InputError("target.mass", units.show(target["mass"], "g"), "50 to 500 g")
        trims = parsed_places(self.trims, "trim")
        low, high = self.scales
        if not 0.1 <= low <= 1.0 <= high <= 10.0:
            raise InputError("scales", self.scales, "0.1 to 1 and 1 to 10")
        if not all(is_count(value, 4, 400) for value in self.elements):
            raise InputError("elements", self.elements, "three whole numbers from 4 to 400")
        changed = {"shape": shape, "thickness": thickness, "target": target, "trims": trims}
        for key, value in {**changed, "elements": tuple(self.elements)}.items():
            object.__setattr__(self, key, value)

    def mesh(self) -> ShellHead:
        """Return the meshed head, brought as near to its targets as walls and trim masses allow."""
        target = self.target
        values = {
            "shape": [self.shape[key] for key in SHAPE],
            "elements": list(self.elements),
            "thickness": [self.thickness[key] for key in WALLS],
            "metal": [self.metal.youngs, self.metal.poisson, self.metal.density],
            "scales": self.scales,
            "trims": [(name, list(place[:3]), place[3]) for name, place in self.trims.items()],
            "mass": target["mass"],
            # The target is from the CG to the face centre, the core's from the face centre to the CG.
            "centre": [None if key not in target else -target[key] for key in CENTRE],
            "above": target.get("cg_above"),
            "inertia": [target.get(key) for key in INERTIA],
        }
        found = beside(core.fem_driver, values)
        report = {"scale": found["scale"], **dict(zip(self.trims, found["trims"], strict=True))}
        made = ShellHead(
            name=self.name,
            description=self.description,
            nodes=found["nodes"].reshape(-1, 3),
            quads=found["quads"].reshape(-1, 4),
            thickness=found["thickness"],
            added=found["added"],
            parts=tuple(Part(name, count, self.metal, name == "face") for name, count in found["parts"]),
            loft=self.shape["loft"],
            bulge=self.shape["bulge"],
            roll=self.shape["roll"],
            report=report,
            asked=target,
        )
        self._tell_missed(made)
        return made

    def _tell_missed(self, made: ShellHead) -> None:
        """Warn of targets that walls and trim masses do not allow."""
        reached = made.reached
        missed = [
            f"{name} {units.from_si(reached[name], unit):.5g} {unit} instead of {units.from_si(asked, unit):.5g} {unit}"
            for name, asked in self.target.items()
            for unit, near in [CLOSE[_target_dimension(name)]]
            if abs(reached[name] - asked) > near
        ]
        if missed:
            room = "wider `scales` of the walls, or more or larger trims, help"
            warn_once(f"{self.name}: {', '.join(missed)}; {room}", TargetWarning)


def _target_dimension(key: str) -> str:
    return "inertia" if key in INERTIA else "mass" if key == "mass" else "length"


def text(head: DriverHead, *, characteristic_time: float | None = None) -> str:
    """Return a file of a driver, which :func:`.read.from_toml` reads; lengths to 0.1 um.

    A ``characteristic_time`` [s] tells the models that take the head as rigid how its face gives.
    """
    lines = [f"name = {quoted(head.name)}"]
    if head.description:
        lines.append(f"description = {quoted(head.description)}")
    lines += [
        'kind = "driver"',
        f"elements = {list(head.elements)}",
        f"scales = {[float(each) for each in head.scales]}",
    ]
    if characteristic_time is not None:
        lines.append(f"characteristic_time = {_told(characteristic_time, 'us', 1)}")
    lines += ["", "[shape]"]
    lines += [f"{key} = {_told(value, 'deg' if key == 'loft' else 'mm')}" for key, value in head.shape.items()]
    lines += ["", "[thickness]", *(f"{key} = {_told(value, 'mm')}" for key, value in head.thickness.items())]
    lines += ["", "[target]", *(f"{key} = {_target(key, value)}" for key, value in head.target.items())]
    lines += ["", "[metal]", *_metal(head.metal)]
    for name, place in head.trims.items():
        lines += ["", "[[trims]]", f"name = {quoted(name)}"]
        lines += [f"{axis} = {_told(value, 'mm')}" for axis, value in zip("xyz", place[:3], strict=True)]
        lines.append(f"most = {_told(place[3], 'g')}")
    return "\n".join(lines) + "\n"


def _told(value: Any, unit: str, digits: int = 4) -> str:
    return quoted(f"{round(units.from_si(float(value), unit), digits):.10g} {unit}")


def _target(key: str, value: float) -> str:
    return _told(value, "g cm2" if key in INERTIA else "mm" if key in (*CENTRE, "cg_above") else "g")


def _metal(metal: Metal) -> list[str]:
    lines = [f"youngs = {_told(metal.youngs, 'GPa')}", f"poisson = {metal.poisson!r}",
             f"density = {_told(metal.density, 'kg/m3')}"]  # fmt: skip
    if metal.yield_stress is None:
        return lines
    lines.append(f"yield = {_told(metal.yield_stress, 'MPa')}")
    hardening = metal.hardening
    if hardening is not None and hardening.table:
        points = ", ".join(f"[{strain!r}, {_told(stress, 'MPa')}]" for strain, stress in hardening.table)
        lines.append(f"hardening = [{points}]")
    elif hardening is not None:
        lines.append(
            f"hardening = {{modulus = {_told(hardening.modulus, 'MPa')}, gain = {_told(hardening.gain, 'MPa')}, "
            f"rate = {hardening.rate!r}}}"
        )
    if metal.points is not None:
        lines.append(f"points = {metal.points}")
    return [*lines, f"rule = {quoted(metal.rule)}"]
