"""Heads by name or from TOML."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

from clubface.errors import ClubfaceError, FileError, InputError
from clubface.fem.heads.added_mass import MASS_KEYS, parsed_places
from clubface.fem.heads.driver import SHAPE, TARGETS, WALLS, DriverHead
from clubface.fem.heads.iron import GROOVES, SHAPE as IRON_SHAPE, IronHead
from clubface.fem.heads.mesh_groups import Group
from clubface.fem.heads.meshed import MeshedClub, MeshedHead
from clubface.fem.heads.metal import Metal
from clubface.fem.heads.user_mesh import MeshHead
from clubface.support.files import builtin_names, path_of
from clubface.support.strict_toml import Document

T = TypeVar("T")
Design = DriverHead | IronHead | MeshHead
FOLDER = "fem_heads"
DRIVER, IRON, MESH = "driver", "iron", "mesh"
SOLID_METAL_KEYS = ("youngs", "poisson", "density", "yield", "hardening")
METAL_KEYS = (*SOLID_METAL_KEYS, "points", "rule")
_FIELDS = {"yield": "yield_stress"}
"""Fields of a metal by their keys: "yield" is a word of Python."""
OF_A_CLUB = ("hand", "parameters", "characteristic_time", "cor")
"""What a file may say of the head as a rigid club, for the models that take it as one."""
COMMON = ("name", "description", "kind", *OF_A_CLUB)
KEYS = {
    DRIVER: (*COMMON, "elements", "scales", "shape", "thickness", "target", "metal", "trims"),
    IRON: (*COMMON, "elements", "element", "shape", "grooves", "metal", "masses"),
    MESH: (*COMMON, "file", "unit", "loft", "bulge", "roll", "face_centre", "groups", "masses"),
}


def head_names() -> tuple[str, ...]:
    """Return the names of the heads that come with clubface."""
    return builtin_names(FOLDER)


def head(which: str | os.PathLike[str] | MeshedHead | MeshedClub | Design) -> MeshedHead:
    """Return a meshed head: by its built-in name, from a TOML file, or from its design."""
    if isinstance(which, MeshedHead | MeshedClub):
        return which if isinstance(which, MeshedHead) else which.head
    if isinstance(which, DriverHead | IronHead | MeshHead):
        return which.mesh()
    return _meshed(path_of("head of finite elements", which, FOLDER))


def design_of(head: str | os.PathLike[str] | MeshedHead | MeshedClub | Design) -> Design | None:
    """Return what a head is made from; None of a head that is a mesh already."""
    if isinstance(head, MeshedHead | MeshedClub):
        return None
    if isinstance(head, DriverHead | IronHead | MeshHead):
        return head
    return from_toml(path_of("head of finite elements", head, FOLDER))


def from_toml(path: str | os.PathLike[str]) -> Design:
    """Read the design of a head from a TOML file; a mesh that it names by path is looked for beside it."""
    return _design(Document.read(path), Path(os.fspath(path)).parent)


def from_text(text: str) -> Design:
    """Read the same from text; a mesh is looked for in the folder of work."""
    return _design(Document(text), Path())


def club_of(document: Document) -> MeshedClub:
    """Return the club of a file of a head: for finite elements its mesh, for every other model what that weighs.

    ``hand``, ``parameters``, and ``characteristic_time`` or ``cor`` of the file are those of a club; without one of the
    last two, the models that take the head as rigid take its face as rigid as well.
    """
    made = _mesh_of(document)
    try:
        return made.as_club(**{key: document.data[key] for key in OF_A_CLUB if key in document.data})
    except ClubfaceError as error:
        raise document.wrap(error) from error


def _meshed(path: str | os.PathLike[str]) -> MeshedHead:
    return _mesh_of(Document.read(path))


def _mesh_of(document: Document) -> MeshedHead:
    """Mesh the head of a file; what is wrong with the mesh is told with the file too."""
    design = _design(document, Path(document.path).parent)
    try:
        made = design.mesh()
        # The core checks a mesh when it weighs it.
        _ = made.club
    except FileError as error:
        raise document.error(str(error), "file") from error
    except ClubfaceError as error:
        if isinstance(design, MeshHead) and getattr(error, "parameter", None) not in KEYS[MESH]:
            raise document.error(f"{os.fspath(design.file)}: {error}", "file") from error
        raise document.wrap(error) from error
    return made


def _design(document: Document, folder: Path) -> Design:
    """Return the design that a document describes."""
    data = dict(document.data)
    kind = data.pop("kind", None)
    if not isinstance(kind, str) or kind not in KEYS:
        given = "" if kind is None else f", not {kind!r}"
        raise document.error(f"kind must be one of {', '.join(KEYS)}{given}", "kind")
    document.check_keys(data, KEYS[kind], ("name",))
    document.check_text(data, ("name", "description", "file", "unit", "element", "hand", "parameters"))
    data = {key: value for key, value in data.items() if key not in OF_A_CLUB}
    if kind == DRIVER:
        return _driver(document, data)
    if kind == IRON:
        return _iron(document, data)
    return _mesh(document, data, folder)


def _driver(document: Document, data: dict[str, Any]) -> DriverHead:
    known = (
        ("shape", SHAPE, SHAPE),
        ("thickness", WALLS, WALLS),
        ("target", TARGETS, ("mass",)),
        ("metal", METAL_KEYS, ()),
    )
    tables = _tables_of(document, data, known)
    data["metal"] = _metal(document, tables.pop("metal"), "metal")
    data["trims"] = _places(document, data.pop("trims", []), "trims", "trim")
    return _made(document, DriverHead, data, tables)


def _tables_of(
    document: Document, data: dict[str, Any], known: Sequence[tuple[str, Sequence[str], Sequence[str]]]
) -> dict[str, Any]:
    """Take the tables out of ``data``: their name, the keys they may have and those they must."""
    tables = {}
    for key, allowed, required in known:
        tables[key] = data.pop(key, {})
        if not isinstance(tables[key], dict):
            raise document.error(f"{key} must be a table: [{key}]", key)
        document.check_keys(tables[key], allowed, required, key)
    return tables


def _made(document: Document, design: Callable[..., T], data: dict[str, Any], tables: Mapping[str, Any]) -> T:
    """Make a design; errors tell the line of the value at fault."""
    for key in ("elements", "scales"):
        if key in data:
            if not isinstance(data[key], list) or len(data[key]) != (3 if key == "elements" else 2):
                wanted = f"a list of {'three' if key == 'elements' else 'two'} numbers"
                raise document.wrap(InputError(key, data[key], wanted))
            data[key] = tuple(data[key])
    try:
        return design(**data, **tables)
    except ClubfaceError as error:
        raise document.wrap(error) from error


def _iron(document: Document, data: dict[str, Any]) -> IronHead:
    known = [("shape", IRON_SHAPE, IRON_SHAPE), ("metal", SOLID_METAL_KEYS, ())]
    if "grooves" in data:
        known.append(("grooves", tuple(GROOVES), tuple(GROOVES)))
    tables = _tables_of(document, data, known)
    if tables["metal"]:
        data["metal"] = _metal(document, tables["metal"], "metal")
    data["masses"] = _places(document, data.pop("masses", []), "masses", "mass")
    del tables["metal"]
    return _made(document, IronHead, data, tables)


def _mesh(document: Document, data: dict[str, Any], folder: Path) -> MeshHead:
    document.check_keys(data, KEYS[MESH], ("name", "file", "loft", "groups"))
    groups = []
    for number, table in enumerate(_tables(document, data.pop("groups"), "groups")):
        known = ("name", "thickness", "face", "sets", *METAL_KEYS)
        document.check_keys(table, known, ("name",), "groups", number)
        document.check_text(table, ("name",), "groups", number)
        own = {key: table[key] for key in METAL_KEYS if key in table}
        rest = {key: value for key, value in table.items() if key not in METAL_KEYS}
        try:
            _metal(document, own, "groups", number)  # an error of it names its line
            groups.append(Group(metal={_FIELDS.get(key, key): value for key, value in own.items()}, **rest))
        except FileError:
            raise
        except ClubfaceError as error:
            raise document.wrap(error, "groups", number) from error
    masses = _places(document, data.pop("masses", []), "masses", "mass")
    try:
        return MeshHead(**{**data, "file": folder / data["file"]}, groups=tuple(groups), masses=masses)
    except ClubfaceError as error:
        raise document.wrap(error) from error


def _metal(document: Document, values: dict[str, Any], table: str, occurrence: int = 0) -> Metal:
    try:
        return Metal(**{_FIELDS.get(key, key): value for key, value in values.items()})
    except ClubfaceError as error:
        raise document.wrap(error, table, occurrence) from error


def _tables(document: Document, values: Any, key: str) -> list[dict[str, Any]]:
    if not (isinstance(values, list) and all(isinstance(each, dict) for each in values)):
        raise document.error(f"{key} must be tables, each under [[{key}]]", key)
    return values


def _places(document: Document, values: Any, key: str, what: str) -> dict[str, tuple[Any, Any, Any, Any]]:
    """Read places with masses: [[trims]] or [[masses]]."""
    found = {}
    mass = MASS_KEYS[what]
    for number, table in enumerate(_tables(document, values, key)):
        keys = ("name", "x", "y", "z", mass)
        document.check_keys(table, keys, keys, key, number)
        document.check_text(table, ("name",), key, number)
        if table["name"] in found:
            raise document.error(f"name: {table['name']!r} is taken; every one needs its own", "name", key, number)
        place = (table["x"], table["y"], table["z"], table[mass])
        try:
            found |= parsed_places({table["name"]: place}, what)
        except InputError as error:
            raise document.wrap(error, key, number) from error
    return found
