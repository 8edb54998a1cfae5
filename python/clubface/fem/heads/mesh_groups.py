"""Groups of a head: assigning elements of a mesh file to them, and their walls and metals."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError, UnknownNameError, Wording
from clubface.fem.heads.metal import Metal
from clubface.fem.mesh_files import SOLIDS, Mesh, Wall
from clubface.schema import FLAG, NAME, TEXT, Items, PhysicalValue, Place, Record, entries

OWN = re.compile(r"gmsh:|Surface\d+$|Volume\d+$|_?(?:PickedSet|All)\d*$|Line\d+$", re.IGNORECASE)
"""Sets that programs create on their own."""
SHOWN = 12
"""Maximum number of sets listed in a message."""


GROUP = {
    "name": NAME,
    "thickness": PhysicalValue("mm", 0.2, 20, decimals=4),
    "face": FLAG,
    "sets": Items(TEXT, allowed='a list of names of sets in the mesh, as ["1", "2"]'),
}
"""Types of a group's keys, besides those of its metal."""


@dataclass(frozen=True, kw_only=True)
class Group:
    """The elements of one group of the mesh.

    Attributes
    ----------
    name
        Name in the mesh file: a physical group, a set of elements, a part or a property, or the number of one.
    thickness
        Thickness of its shells [m]; None if the mesh file gives it, and for solid elements.
    metal
        The metal, or only those values, by name, that the mesh file does not give.
    face
        Whether the ball may touch them.
    sets
        Sets of the mesh file that make up the group; default: the set with the group's name.
    """

    name: str
    thickness: Any = None
    metal: Metal | Mapping[str, Any] = field(default_factory=dict)
    face: bool = False
    sets: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        for key, kind in GROUP.items():
            if (value := getattr(self, key)) is not None:
                place = Place(name=key, label="" if key == "name" else self.name)
                object.__setattr__(self, key, kind.read(value, place))
        if not isinstance(self.metal, Metal):
            Metal(**self.metal)  # raises an error for impossible values


def _make_group(values: dict[str, Any], place: Place) -> Group:
    """Return the group of a table [[groups]], whose keys include those of its metal."""
    metal = {each.attribute: values.pop(key) for key, each in entries(Metal).items() if key in values}
    return Group(metal=metal, **values)


GROUP_TABLE = Record(
    {**GROUP, **{key: each.value for key, each in entries(Metal).items()}}, ("name",), make=_make_group
)


def group_values(group: Group) -> dict[str, Any]:
    """Return the table [[groups]] of a group, without values left to the mesh file."""
    given, metal = group.metal, {}
    for key, each in entries(Metal).items():
        value = getattr(given, each.attribute) if isinstance(given, Metal) else given.get(each.attribute)
        if value is not None and (key in METAL or value != each.default):
            metal[key] = each.value.check(value, Place(name=key, label=group.name))
    own = {key: getattr(group, key) for key in GROUP}
    return {key: value for key, value in own.items() if value not in (None, False, ())} | metal


def assign(mesh: Mesh, groups: Sequence[Group]) -> NDArray[Any]:
    """Return the index in ``groups`` of each element's group.

    A group takes the set with its name, or the sets that it lists; other sets are ignored. Further decisions are
    recorded as notes. Raises FileError if an element belongs to no group or to two, or a group has no elements.
    """
    if not len(mesh.corners):
        raise mesh.error("this file contains no surface or solid elements")
    places = np.full(len(mesh.corners), -1)
    if not any(len(rows) for rows in mesh.sets.values()) and len(groups) == 1:
        mesh.notes.append(f"the file has no element sets; all elements go to {groups[0].name!r}")
        return np.zeros(len(mesh.corners), dtype=int)
    names = [_sets_of(mesh, group) for group in groups]
    if not any(names) and (numbered := _by_order(mesh, len(groups))):
        order = ", ".join(f"{one} as {group.name}" for one, group in zip(numbered, groups, strict=True))
        mesh.notes.append(
            f"its sets have numbers instead of names and are taken in the order of [[groups]]: {order};"
            f' to make this explicit, write sets = ["{numbered[0]}"] under the group'
        )
        names = [[each] for each in numbered]
    for place, (group, own) in enumerate(zip(groups, names, strict=True)):
        for name in own:
            rows = mesh.sets[name]
            taken = rows[(places[rows] >= 0) & (places[rows] != place)]
            if len(taken):
                other, element = groups[int(places[taken[0]])].name, mesh.ids[taken[0]]
                raise mesh.error(f"element {element} belongs to two groups, {other!r} and {group.name!r}")
            places[rows] = place
    if (places < 0).any():
        _raise_unassigned(mesh, groups, places)
    counts = np.bincount(places, minlength=len(groups))
    if not counts.all():
        empty = groups[int(np.argmin(counts))].name
        raise mesh.error(f"no element belongs to the group {empty!r}; {_list_sets(mesh)}")
    return places


def _sets_of(mesh: Mesh, group: Group) -> list[str]:
    """Return the sets of a group: by exact name, by another name of the set, or ignoring case if unambiguous."""
    names = []
    for name in group.sets or (group.name,):
        if name not in mesh.sets and name in mesh.aliases:
            name = mesh.aliases[name]
        if name not in mesh.sets:
            known = {**{each: each for each in mesh.sets}, **mesh.aliases}
            like = {known[each] for each in known if _normalise_name(each) == _normalise_name(name)}
            name = like.pop() if len(like) == 1 else name
        if name in mesh.sets:
            names.append(name)
        elif group.sets:
            raise mesh.error(str(UnknownNameError("set of the mesh", name, tuple(mesh.sets))))
    return names


def _normalise_name(name: str) -> str:
    return re.sub(r"[\s_-]+", "_", name.strip()).casefold()


def _by_order(mesh: Mesh, count: int) -> list[str]:
    """Return the numbered sets if their count matches and they cover every element exactly once, else an empty list."""
    names = [name for name, rows in mesh.sets.items() if len(rows)]
    if len(names) != count or not all(name.isdecimal() and name not in mesh.aliases.values() for name in names):
        return []
    whole = np.concatenate([mesh.sets[name] for name in names])
    return sorted(names, key=int) if len(whole) == len(np.unique(whole)) == len(mesh.corners) else []


def _raise_unassigned(mesh: Mesh, groups: Sequence[Group], places: NDArray[Any]) -> None:
    """Raise the error that says which elements belong to no group, and how to assign them."""
    rest = np.flatnonzero(places < 0)
    holders = {name: int(np.isin(rest, rows).sum()) for name, rows in mesh.sets.items() if not OWN.match(name)}
    holders = {name: count for name, count in holders.items() if count}
    if holders:
        most = max(holders, key=lambda name: holders[name])
        message = str(UnknownNameError("group of the mesh", most, tuple(group.name for group in groups)))
        advice = f"its {holders[most]} elements need a group: name it under [[groups]], or list it in sets = [..]"
        raise mesh.error(f"{message}; {advice}; {_list_sets(mesh)}")
    message = f"element {mesh.ids[rest[0]]} belongs to no group"
    if len(rest) > 1:
        message += f", and {len(rest) - 1} more do not"
    raise mesh.error(f"{message}; name physical groups or sets of elements in the mesh; {_list_sets(mesh)}")


def _list_sets(mesh: Mesh) -> str:
    """List the sets of a file, for messages."""
    names = [f"{name} ({len(rows)})" for name, rows in mesh.sets.items() if len(rows) and not OWN.match(name)]
    if not names:
        return "it has none"
    more = f" and {len(names) - SHOWN} more" if len(names) > SHOWN else ""
    return f"its sets, with their numbers of elements, are {', '.join(names[:SHOWN])}{more}"


def names_solids(mesh: Mesh, groups: Sequence[Group]) -> bool:
    """Return whether the groups refer to the solid elements of a mesh; if not, note which solids are left out.

    Raises InputError if a group of solid elements is given a thickness.
    """
    if (solids := mesh.solids) is None or not len(solids.ids):
        return False
    wanted = {_normalise_name(name) for group in groups for name in (group.sets or (group.name,))}
    known = {name: {name} | {alias for alias, real in mesh.aliases.items() if real == name} for name in solids.sets}
    named = any(
        _normalise_name(each) in wanted for name, rows in solids.sets.items() if len(rows) for each in known[name]
    )
    thick = next((group for group in groups if group.thickness is not None), None)
    if len(mesh.corners) and (thick or not named):
        kinds = Counter(SOLIDS[int(count)] for count in (solids.corners >= 0).sum(axis=1))
        left = " and ".join(f"{count} {kind}" for kind, count in kinds.items())
        mesh.notes.append(f"left out, because no group without thickness names them: {left}")
        return False
    if thick is not None:
        allowed = "leave it out; the elements of this mesh are solid and have their drawn thickness"
        raise InputError(f"thickness of {thick.name}", units.show(thick.thickness, "mm"), allowed)
    return True


class _System(NamedTuple):
    """A system of units used in mesh files: its name, and its units of stress, density and mass in SI."""

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
"""Systems for each unit of length. Files do not name their system; it is inferred from the metals."""
YOUNGS, DENSITY = (5e9, 6e11), (1e3, 25e3)
"""Plausible ranges for the metal of a head [Pa, kg/m3]; a wrong system of units is off by a factor of a thousand."""
MASSES = (2e-4, 0.3)
"""Minimum and maximum total point mass in a file [kg]."""
CLOSE = 0.01
"""Relative difference between file and card values above which a note is made."""
METAL = ("youngs", "poisson", "density")
_UNITS = {"youngs": "GPa", "density": "kg/m3", "poisson": "1"}


def walls(mesh: Mesh, groups: Sequence[Group], of_group: NDArray[Any], unit: str) -> tuple[NDArray[Any], list[Metal]]:
    """Return the thickness of each element [m] and the metal of each group.

    Values of a group take precedence. Otherwise they come from the cards of the mesh file, where an element's own
    thickness takes precedence over its section's. Differences, and groups without a metal in either file, are noted.
    Raises InputError if a thickness is missing, or a card's values fit no metal in any system of units.
    """
    size = units.parse(f"1 {unit}", "length")
    card = np.full(len(mesh.corners), np.nan)
    for name, wall in mesh.walls.items():
        if wall.thickness is not None:
            card[mesh.sets.get(name, np.zeros(0, int))] = wall.thickness
    card = size * np.where(np.isnan(mesh.thickness), card, mesh.thickness)
    thickness, differing = np.zeros(len(card)), []
    for number, group in enumerate(groups):
        own = of_group == number
        by_cards = card[own]
        if group.thickness is not None:
            thickness[own] = group.thickness
            other = by_cards[np.abs(by_cards / group.thickness - 1.0) > CLOSE]
            if len(other):
                own_thickness = units.show(group.thickness, "mm")
                differing.append(f"{group.name} {_range(other)} in the mesh, {own_thickness} in the head's file")
        elif np.isnan(by_cards).any():
            message = "give it with its unit; the mesh file has no thickness for some elements of the group"
            raise InputError(f"thickness of {group.name}", None, message)
        else:
            thickness[own] = by_cards
        if (by_cards <= 0.0).any():
            differing.append(f"{group.name} 0 mm in the mesh")
    return thickness, metals_of(mesh, groups, of_group, unit, differing)


def metals_of(
    mesh: Mesh, groups: Sequence[Group], of_group: NDArray[Any], unit: str, differing: Sequence[str] = ()
) -> list[Metal]:
    """Return the metal of each group, as :func:`walls` does; ``differing`` lists differences found so far."""
    cards = list(mesh.walls.items())
    wall_of = np.full(len(mesh.corners), -1)
    for place, (name, _) in enumerate(cards):
        wall_of[mesh.sets.get(name, np.zeros(0, int))] = place
    metals, unread, differing = [], [], list(differing)
    for number, group in enumerate(groups):
        own_walls = [cards[each][1] for each in np.unique(wall_of[of_group == number]) if each >= 0]
        metals.append(_metal(mesh, group, own_walls, unit, differing, unread))
    if differing:
        mesh.notes.append(f"its cards differ from the head's own file, which takes precedence: {'; '.join(differing)}")
    if unread:
        values = " and ".join(f"{key} {units.show(getattr(Metal(), key), _UNITS[key])}" for key in METAL)
        missing = f"metals that are missing in the file or use a law that cannot be read: {'; '.join(unread)}"
        mesh.notes.append(f"{missing}; values not given by the group are those of titanium: {values}")
    return metals


def _range(values: NDArray[Any]) -> str:
    least, most = (units.show(float(each), "mm") for each in (values.min(), values.max()))
    return least if least == most else f"{least} to {most}"


def _metal(
    mesh: Mesh, group: Group, walls: Sequence[Wall], unit: str, differing: list[str], unread: list[str]
) -> Metal:
    """Return the metal of a group; record where file and cards differ, and metals that cannot be read."""
    given = group.metal
    cards = [_in_si(mesh, wall, unit) for wall in walls if wall.youngs is not None or wall.density is not None]
    card = cards[0] if cards else {}
    if any(each != card for each in cards) and not isinstance(given, Metal):
        allowed = "give each set its own group, or give youngs, poisson and density"
        raise InputError(f"metal of {group.name}", Wording("ambiguous: its sets have several metals"), allowed)
    known = {key: getattr(given, key) for key in METAL} if isinstance(given, Metal) else given
    for key in METAL:
        if key in card and key in known:
            value = units.parse(known[key], units.unit(_UNITS[key]).dimension)
            if abs(card[key] - value) > CLOSE * abs(value):
                shown = (units.show(each, _UNITS[key]) for each in (card[key], value))
                differing.append("{} of {}: {} in the mesh, {} in the head's file".format(key, group.name, *shown))
    if isinstance(given, Metal):
        return given
    metal = Metal(**{**card, **given})
    named = sorted({wall.material for wall in walls if wall.material and wall.youngs is None and wall.density is None})
    if named and not set(METAL) <= {*given}:
        unread.append(f"{', '.join(named[:3])} of {group.name}")
    if card and not set(METAL) <= {*card, *given}:
        left = [key for key in METAL if key not in card and key not in given]
        values = " and ".join(f"{key} {units.show(getattr(metal, key), _UNITS[key])}" for key in left)
        mesh.notes.append(f"no card gives {' or '.join(left)} of {group.name}; using titanium's: {values}")
    return metal


def _in_si(mesh: Mesh, wall: Wall, unit: str) -> dict[str, float]:
    """Return youngs, poisson and density of a card in SI, from the first system of units in which they fit a metal."""
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
    raise mesh.error(f"{wall.source}: {values} fit no metal in any usual system of units ({known}); correct the card")


def point_masses(mesh: Mesh, unit: str) -> list[tuple[float, float, float, float]]:
    """Return the point masses of a file: positions in the file's unit, masses in kg."""
    masses = [each for each in mesh.masses if each[3]]
    if not masses:
        return []
    whole = sum(each[3] for each in masses)
    sizes = {system.mass for system in (*SYSTEMS.get(unit, ()), SI) if MASSES[0] <= whole * system.mass <= MASSES[1]}
    if len(sizes) != 1:
        message = f"its {len(masses)} point masses add up to {whole:g}, which is no plausible mass in any usual unit"
        raise mesh.error(f"{message}; remove them and give [[masses]]")
    (size,) = sizes
    mesh.notes.append(f"its {len(masses)} point masses, {units.show(whole * size, 'g')} in all, are added to the head")
    return [(x, y, z, mass * size) for x, y, z, mass in masses]
