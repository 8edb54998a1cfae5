"""Reading heads by name or from TOML, and writing them."""

from __future__ import annotations

import os
from collections.abc import Mapping

from clubface.equipment.clubs import Club
from clubface.errors import ClubfaceError, FileError
from clubface.fem.heads.meshed import MeshedClub, MeshedHead
from clubface.fem.heads.parametric import DriverHead, IronHead
from clubface.fem.heads.user_mesh import MeshHead
from clubface.schema import Choice, Document, PhysicalValue, Place, Table, Value, encode, entries
from clubface.support.files import builtin_names, path_of

Design = DriverHead | IronHead | MeshHead
FOLDER = "fem_heads"
DESIGNS: Mapping[str, type[Design]] = {"driver": DriverHead, "iron": IronHead, "mesh": MeshHead}
"""Design of each kind of head."""
OF_A_CLUB = ("hand", "parameters", "characteristic_time", "cor")
"""Keys that describe the head as a rigid club, for models with a rigid head."""
OTHERS: Mapping[str, Value] = {"kind": Choice(DESIGNS), **{key: entries(Club)[key].value for key in OF_A_CLUB}}
"""Keys of a file that do not belong to the design."""


DRIVER_FILE, IRON_FILE, MESH_FILE = (Table(each, OTHERS) for each in DESIGNS.values())
"""File formats of the three kinds of head."""


def head_names() -> tuple[str, ...]:
    """Return the names of the built-in heads."""
    return builtin_names(FOLDER)


def head(source: str | os.PathLike[str] | MeshedHead | MeshedClub | Design) -> MeshedHead:
    """Return a meshed head, from a built-in name, a TOML file, a design, or a head that is meshed already."""
    if isinstance(source, MeshedHead | MeshedClub):
        return source if isinstance(source, MeshedHead) else source.head
    if isinstance(source, DriverHead | IronHead | MeshHead):
        return source.mesh()
    return _mesh_of(Document.read(path_of("head of finite elements", source, FOLDER)))


def design_of(head: str | os.PathLike[str] | MeshedHead | MeshedClub | Design) -> Design | None:
    """Return the design of a head; None if the head is a mesh already."""
    if isinstance(head, MeshedHead | MeshedClub):
        return None
    if isinstance(head, DriverHead | IronHead | MeshHead):
        return head
    return from_toml(path_of("head of finite elements", head, FOLDER))


def from_toml(path: str | os.PathLike[str]) -> Design:
    """Read the design of a head from a TOML file; the path of a mesh in it is relative to the file."""
    return design_from_document(Document.read(path))


def from_text(text: str) -> Design:
    """Read the design of a head from TOML text; the path of a mesh is relative to the working directory."""
    return design_from_document(Document(text))


def head_text(
    design: Design, *, characteristic_time: float | None = None, folder: str | os.PathLike[str] | None = None
) -> str:
    """Write a head as TOML that :func:`from_toml` can read; lengths to 0.1 um.

    The characteristic time [s] is for the models that treat the head as rigid. The path of a mesh is made relative to
    the ``folder`` of the file; default: as it is in the head.
    """
    head = f'kind = "{next(kind for kind, each in DESIGNS.items() if isinstance(design, each))}"\n'
    if characteristic_time is not None:
        head += f"characteristic_time = {PhysicalValue('us', decimals=1).write(characteristic_time)}\n"
    return head + encode(design, **(design.in_folder(folder) if isinstance(design, MeshHead) else {}))


def club_of(document: Document) -> MeshedClub:
    """Return the club of a head's file: the mesh for finite elements, its mass properties for every other model.

    ``hand``, ``parameters``, and ``characteristic_time`` or ``cor`` in the file are those of a club. Without
    ``characteristic_time`` or ``cor``, models that treat the head as rigid also treat its face as rigid.
    """
    made = _mesh_of(document)
    with Place(document).errors():
        return made.as_club(**{key: document.data[key] for key in OF_A_CLUB if key in document.data})


def _mesh_of(document: Document) -> MeshedHead:
    """Mesh the head of a file; errors of the mesh also name the head's file."""
    design = design_from_document(document)
    with Place(document).errors():
        try:
            made = design.mesh()
            # Computing the mass properties makes the core check the mesh.
            _ = made.club
        except FileError as error:
            raise FileError(document.path, document.line_of(("file",)), str(error), "file") from error
        except ClubfaceError as error:
            if isinstance(design, MeshHead) and getattr(error, "parameter", None) not in entries(MeshHead):
                message = f"{os.fspath(design.file)}: {error}"
                raise FileError(document.path, document.line_of(("file",)), message, "file") from error
            raise
    return made


def design_from_document(document: Document) -> Design:
    """Return the design described by a document."""
    place = Place(document)
    place.require_keys(document.data, ("kind",))
    with (at := place.key("kind")).errors():
        design = Choice(DESIGNS).read(document.data["kind"], at)
    return Table(design, OTHERS).read(document.data, Place(document))
