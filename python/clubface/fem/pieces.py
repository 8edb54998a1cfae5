"""The pieces of a ball, core and layers: from TOML or from code, with checks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.fem.materials import Material, Maxwell, laws
from clubface.support.checks import check_choice, check_count, check_name
from clubface.support.strict_toml import Document

MATERIAL_KEYS = ("law", "youngs", "poisson", "density", "maxwell")


@dataclass(frozen=True, kw_only=True)
class Piece:
    """The core of a ball, or one layer around it.

    Attributes
    ----------
    name
        Its name in tables and messages.
    material
        Its material.
    layers
        Number of element layers through it; for the core, between the inner cube and the surface of the core.
    thickness
        Thickness [m]; None for the core, which fills what the layers leave.
    """

    name: str
    material: Material
    layers: int
    thickness: float | None = None

    def __post_init__(self) -> None:
        check_name(self.name)
        if not isinstance(self.material, Material):
            raise InputError(f"material of {self.name}", self.material, "a Material")
        check_count(f"layers of {self.name}", self.layers, 1, 48)
        if self.thickness is not None:
            value = units.parse(self.thickness, "length", name=f"thickness of {self.name}")
            object.__setattr__(self, "thickness", value)
            if not 1e-5 <= value <= 0.02:
                raise InputError(f"thickness of {self.name}", units.show(value, "mm"), "0.01 to 20 mm")


def read_piece(document: Document, table: dict[str, Any], number: int, branches: int) -> Piece:
    """Read one of [[pieces]]; ``branches`` is how many of [[pieces.maxwell]] stand above it."""
    constants = {name for law in laws().values() for name in law.constants}
    known = ("name", "layers", "thickness", *MATERIAL_KEYS, *sorted(constants))
    document.check_keys(table, known, ("name", "law", "layers", "poisson"), "pieces", number)
    try:
        check_choice("law", table["law"], laws())
        common = {"density": table.get("density"), "maxwell": _branches(document, table, branches)}
        if "youngs" in table:
            if table["law"] != "linear":
                raise InputError("youngs", table["youngs"], f"leave it out: {table['law']} has constants of its own")
            also = [name for name in table if name in constants]
            if also:
                raise InputError(also[0], table[also[0]], "leave it out, since youngs is given")
            material = Material.linear(table["youngs"], table["poisson"], **common)
        else:
            given = {name: table[name] for name in table if name in constants}
            material = Material(law=table["law"], constants=given, poisson=table["poisson"], **common)
        return Piece(name=table["name"], material=material, layers=table["layers"], thickness=table.get("thickness"))
    except InputError as error:
        if " of " not in error.parameter:
            error.parameter += f" of {table['name']}"
        raise document.wrap(error, "pieces", number) from error


def _branches(document: Document, table: dict[str, Any], above: int) -> tuple[Maxwell, ...]:
    tables = table.get("maxwell", [])
    if not (isinstance(tables, list) and all(isinstance(each, dict) for each in tables)):
        raise InputError("maxwell", tables, "tables, each under [[pieces.maxwell]]")
    found = []
    for number, each in enumerate(tables, above):
        document.check_keys(each, ("modulus", "time"), ("modulus", "time"), "pieces.maxwell", number)
        try:
            found.append(Maxwell(**each))
        except InputError as error:
            raise document.wrap(error, "pieces.maxwell", number) from error
    return tuple(found)
