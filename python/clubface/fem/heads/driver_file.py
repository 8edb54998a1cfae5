"""The TOML file of a parametric driver."""

from __future__ import annotations

from typing import Any

from clubface import units
from clubface.fem.heads.driver import CENTRE, INERTIA, DriverHead
from clubface.fem.heads.metal import Metal
from clubface.support.strict_toml import quoted


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
