"""Walls and metals of groups: what the head's file gives, and for the rest what cards of the mesh file say."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import FileError, InputError
from clubface.fem.heads.mesh_groups import Group
from clubface.fem.heads.metal import Metal
from clubface.fem.mesh_files import Mesh, Wall


class _System(NamedTuple):
    """A system of units of mesh files: its name, and the sizes of its stress, density and mass in SI."""

    name: str
    stress: float
    density: float
    mass: float


SI = _System("Pa, kg/m3, kg", 1.0, 1.0, 1.0)
SYSTEMS = {
    "mm": (
        _System("MPa, t/mm3, t", 1e6, 1e12, 1e3),
        _System("GPa, kg/mm3, kg", 1e9, 1e9, 1.0),
        _System("MPa, g/mm3, g", 1e6, 1e6, 1e-3),
    ),
    "cm": (_System("Mbar, g/cm3, g", 1e11, 1e3, 1e-3), _System("dyn/cm2, g/cm3, g", 0.1, 1e3, 1e-3)),
    "in": (_System("psi, lbf s2/in4, lbf s2/in", 6894.757, 1.0686897e7, 175.12684),),
    "m": (),
}
"""Systems that go with a unit of length; a file names none, and metals tell which it is."""
YOUNGS, DENSITY = (5e9, 6e11), (1e3, 25e3)
"""What a metal of a head may have [Pa, kg/m3]; a wrong system is off by a thousand."""
MASSES = (2e-4, 0.3)
"""What the point masses of a file may add up to [kg]."""
CLOSE = 0.01
"""Part by which a value of the head's file may differ from that of a card without a word."""
METAL = ("youngs", "poisson", "density")
_UNITS = {"youngs": "GPa", "density": "kg/m3", "poisson": "1"}


def walls(
    mesh: Mesh, groups: Sequence[Group], of_group: NDArray[Any], unit: str, notes: list[str]
) -> tuple[NDArray[Any], list[Metal]]:
    """Return the thickness of each element [m] and the metal of each group.

    What a group gives counts. For the rest the cards of the file do, with the thickness of an element by itself before
    that of its section. Where both say something else, or neither says of what metal a group is, a note tells.

    Raises
    ------
    InputError
        A thickness is given nowhere, or a card has values that no metal has in any system of units.
    """
    size = units.parse(f"1 {unit}", "length")
    card = np.full(len(mesh.corners), np.nan)
    wall_of = np.full(len(mesh.corners), -1)
    cards = list(mesh.walls.items())
    for place, (name, wall) in enumerate(cards):
        rows = mesh.sets.get(name, np.zeros(0, int))
        if wall.thickness is not None:
            card[rows] = wall.thickness
        wall_of[rows] = place
    card = size * np.where(np.isnan(mesh.thickness), card, mesh.thickness)
    thickness, metals, differing, unread = np.zeros(len(card)), [], [], []
    for number, group in enumerate(groups):
        own = of_group == number
        by_cards = card[own]
        if group.thickness is not None:
            thickness[own] = group.thickness
            other = by_cards[np.abs(by_cards / group.thickness - 1.0) > CLOSE]
            if len(other):
                differing.append(f"{group.name} {_range(other)} there, {units.show(group.thickness, 'mm')} here")
        elif np.isnan(by_cards).any():
            message = "give it with its unit; the mesh has no card of a thickness for all elements of the group"
            raise InputError(f"thickness of {group.name}", None, message)
        else:
            thickness[own] = by_cards
        if (by_cards <= 0.0).any():
            differing.append(f"{group.name} 0 mm there")
        own_walls = [cards[each][1] for each in np.unique(wall_of[own]) if each >= 0]
        metals.append(_metal(mesh, group, own_walls, unit, differing, unread, notes))
    if differing:
        notes.append(f"its cards differ from the head's own file, which counts: {'; '.join(differing)}")
    if unread:
        values = " and ".join(f"{key} {units.show(getattr(Metal(), key), _UNITS[key])}" for key in METAL)
        missing = f"metals that are not in the file or of a law that is not read: {'; '.join(unread)}"
        notes.append(f"{missing}; taken as of titanium where the group does not give it: {values}")
    return thickness, metals


def _range(values: NDArray[Any]) -> str:
    least, most = (units.show(float(each), "mm") for each in (values.min(), values.max()))
    return least if least == most else f"{least} to {most}"


def _metal(mesh: Mesh, group: Group, walls: Sequence[Wall], unit: str, differing: list[str], unread: list[str],
           notes: list[str]) -> Metal:  # fmt: skip
    """Return the metal of a group, and note where file and cards differ, and metals that are not read."""
    given = group.metal
    cards = [_in_si(mesh, wall, unit) for wall in walls if wall.youngs is not None or wall.density is not None]
    card = cards[0] if cards else {}
    if any(each != card for each in cards) and not isinstance(given, Metal):
        message = (
            "its sets have different metals in the mesh; make a group of each, or give youngs, poisson and density"
        )
        raise InputError(f"metal of {group.name}", None, message)
    known = {key: getattr(given, key) for key in METAL} if isinstance(given, Metal) else given
    for key in METAL:
        if key in card and key in known:
            value = units.parse(known[key], {"youngs": "pressure", "density": "density"}.get(key, units.DIMENSIONLESS))
            if abs(card[key] - value) > CLOSE * abs(value):
                shown = (units.show(each, _UNITS[key]) for each in (card[key], value))
                differing.append("{} of {} {} there, {} here".format(key, group.name, *shown))
    if isinstance(given, Metal):
        return given
    metal = Metal(**{**card, **given})
    named = sorted({wall.material for wall in walls if wall.material and wall.youngs is None and wall.density is None})
    if named and not set(METAL) <= {*given}:
        unread.append(f"{', '.join(named[:3])} of {group.name}")
    if card and not set(METAL) <= {*card, *given}:
        left = [key for key in METAL if key not in card and key not in given]
        values = " and ".join(f"{key} {units.show(getattr(metal, key), _UNITS[key])}" for key in left)
        notes.append(f"no card gives {' or '.join(left)} of {group.name}; taken as of titanium: {values}")
    return metal


def _in_si(mesh: Mesh, wall: Wall, unit: str) -> dict[str, float]:
    """Return youngs, poisson and density of a card in SI, in the one system in which they are those of a metal."""
    for system in (*SYSTEMS.get(unit, ()), SI):
        youngs = None if wall.youngs is None else wall.youngs * system.stress
        density = None if not wall.density else wall.density * system.density
        if youngs is not None and not YOUNGS[0] <= youngs <= YOUNGS[1]:
            continue
        if density is not None and not DENSITY[0] <= density <= DENSITY[1]:
            continue
        in_si = {"youngs": youngs, "poisson": wall.poisson, "density": density}
        return {key: value for key, value in in_si.items() if value is not None}
    values = " and ".join(
        f"{what} {value:g}" for what, value in (("E", wall.youngs), ("density", wall.density)) if value is not None
    )
    known = "; ".join(system.name for system in (*SYSTEMS.get(unit, ()), SI))
    message = f"{wall.source}: {values} are those of no metal in any usual system of units ({known}); correct the card"
    raise FileError(mesh.path, None, message)


def point_masses(mesh: Mesh, unit: str, notes: list[str]) -> list[tuple[float, float, float, float]]:
    """Return the point masses of a file: places in its unit, masses in kg."""
    masses = [each for each in mesh.masses if each[3]]
    if not masses:
        return []
    whole = sum(each[3] for each in masses)
    sizes = {system.mass for system in (*SYSTEMS.get(unit, ()), SI) if MASSES[0] <= whole * system.mass <= MASSES[1]}
    if len(sizes) != 1:
        message = f"its {len(masses)} point masses add up to {whole:g}, which is no mass of a head in any usual unit"
        raise FileError(mesh.path, None, f"{message}; remove them and give [[masses]]")
    (size,) = sizes
    notes.append(f"its {len(masses)} point masses, {units.show(whole * size, 'g')} in all, are added to the head")
    return [(x, y, z, mass * size) for x, y, z, mass in masses]
