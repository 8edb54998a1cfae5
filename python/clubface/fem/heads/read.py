"""Heads by name or from TOML."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from clubface.equipment import builtin_names, builtin_path, is_path
from clubface.errors import ClubfaceError, FileError, UnknownNameError
from clubface.fem.heads.driver import SHAPE, TARGETS, WALLS, DriverHead
from clubface.fem.heads.metal import Metal
from clubface.fem.heads.shells import ShellHead
from clubface.fem.heads.user_mesh import Group, MeshHead
from clubface.strict_toml import Document

FOLDER = "fem_heads"
DRIVER, MESH = "driver", "mesh"
METAL_KEYS = ("youngs", "poisson", "density")
COMMON = ("name", "description", "kind")
KEYS = {
    DRIVER: (*COMMON, "elements", "scales", "shape", "thickness", "target", "metal", "trims"),
    MESH: (*COMMON, "file", "unit", "loft", "bulge", "roll", "face_centre", "groups", "masses"),
}


def head_names() -> tuple[str, ...]:
    """Return the names of the heads that come with clubface."""
    return builtin_names(FOLDER)


def head(which: str | os.PathLike[str] | ShellHead | DriverHead | MeshHead) -> ShellHead:
    """Return a head of shells: by built-in name, from a TOML file, or from its design, meshed."""
    if isinstance(which, ShellHead):
        return which
    if isinstance(which, DriverHead | MeshHead):
        return which.mesh()
    if is_path(which):
        return from_toml(which).mesh()
    if which not in head_names():
        raise UnknownNameError("head of finite elements", which, head_names())
    return from_toml(builtin_path("fem_head", str(which), head_names())).mesh()


def from_toml(path: str | os.PathLike[str]) -> DriverHead | MeshHead:
    """Read the design of a head from a TOML file; a mesh it names by path is looked for beside it."""
    document = Document.read(path)
    data = dict(document.data)
    kind = data.pop("kind", None)
    if kind not in KEYS:
        raise document.error(f'kind must be "{DRIVER}" or "{MESH}", not {kind!r}', "kind")
    document.check_keys(data, KEYS[kind], ("name",))
    document.check_text(data, ("name", "description", "file", "unit"))
    if kind == DRIVER:
        return _driver(document, data)
    return _mesh(document, data, Path(os.fspath(path)).parent)


def _driver(document: Document, data: dict[str, Any]) -> DriverHead:
    tables = {}
    for key, known in (("shape", SHAPE), ("thickness", WALLS), ("target", TARGETS), ("metal", METAL_KEYS)):
        tables[key] = data.pop(key, {})
        if not isinstance(tables[key], dict):
            raise document.error(f"{key} must be a table: [{key}]", key)
        required = ("mass",) if key == "target" else () if key == "metal" else known
        document.check_keys(tables[key], known, required, key)
    tables["metal"] = _metal(document, tables["metal"], "metal")
    tables["trims"] = _places(document, data.pop("trims", []), "trims", "most")
    for key in ("elements", "scales"):
        if key in data:
            if not isinstance(data[key], list):
                raise document.error(f"{key} must be a list", key)
            data[key] = tuple(data[key])
    try:
        return DriverHead(**data, **tables)
    except (ClubfaceError, TypeError, ValueError) as error:
        if not isinstance(error, ClubfaceError):
            raise document.error(str(error)) from error
        parameter = getattr(error, "parameter", None)
        table = next((key for key in ("shape", "thickness", "target") if parameter in document.data.get(key, {})), "")
        raise document.wrap(error, table) from error


def _mesh(document: Document, data: dict[str, Any], folder: Path) -> MeshHead:
    document.check_keys(data, KEYS[MESH], ("name", "file", "loft", "groups"))
    groups = []
    for number, table in enumerate(_tables(document, data.pop("groups"), "groups")):
        known = ("name", "thickness", "face", *METAL_KEYS)
        document.check_keys(table, known, ("name", "thickness"), "groups", number)
        document.check_text(table, ("name",), "groups", number)
        own = {key: table[key] for key in METAL_KEYS if key in table}
        rest = {key: value for key, value in table.items() if key not in METAL_KEYS}
        try:
            groups.append(Group(metal=_metal(document, own, "groups", number), **rest))
        except FileError:
            raise
        except ClubfaceError as error:
            # "thickness of crown" stands in the line of "thickness".
            key = str(getattr(error, "parameter", "")).partition(" of ")[0]
            raise document.error(str(error), key, "groups", number) from error
    masses = _places(document, data.pop("masses", []), "masses", "mass")
    try:
        return MeshHead(**{**data, "file": folder / data["file"]}, groups=tuple(groups), masses=masses)
    except ClubfaceError as error:
        raise document.wrap(error) from error


def _metal(document: Document, values: dict[str, Any], table: str, occurrence: int = 0) -> Metal:
    try:
        return Metal(**values)
    except ClubfaceError as error:
        raise document.wrap(error, table, occurrence) from error


def _tables(document: Document, values: Any, key: str) -> list[dict[str, Any]]:
    if not (isinstance(values, list) and all(isinstance(each, dict) for each in values)):
        raise document.error(f"{key} must be tables, each under [[{key}]]", key)
    return values


def _places(document: Document, values: Any, key: str, mass: str) -> dict[str, tuple[Any, Any, Any, Any]]:
    """Read places with masses: [[trims]] or [[masses]]."""
    found = {}
    for number, table in enumerate(_tables(document, values, key)):
        keys = ("name", "x", "y", "z", mass)
        document.check_keys(table, keys, keys, key, number)
        document.check_text(table, ("name",), key, number)
        found[table["name"]] = (table["x"], table["y"], table["z"], table[mass])
    return found
