"""Cases: ball, head, delivery and settings in one TOML file, so that a run can be repeated and varied."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, TypeVar

from clubface.equipment.clubs import Club, club
from clubface.errors import ClubfaceError, FileError, InputError, RangeWarning, UnknownNameError
from clubface.fem.balls import Ball, ball
from clubface.fem.core import Progress
from clubface.fem.heads import MeshedHead, head
from clubface.fem.result import Impact
from clubface.fem.run import friction_of, strike, throw, throw_values
from clubface.fem.settings import Settings
from clubface.simulation.impact import impact
from clubface.simulation.inputs import DIMENSIONS
from clubface.support.checks import check_choice, check_name, check_names, check_text, without_warnings
from clubface.support.files import builtin_names, is_path, path_of
from clubface.support.strict_toml import Document

T = TypeVar("T")
FOLDER = "fem_cases"
PLANE, RIGID, MESHED = "plane", "rigid", "meshed"
HEADS = (PLANE, RIGID, MESHED)
KEYS = ("name", "description", "ball", "friction", "head", "delivery", "run")
HEAD_KEYS = ("kind", "club", "meshed")
PLANE_KEYS = ("speed", "angle")


@dataclass(frozen=True, kw_only=True)
class Case:
    """A case: which ball meets which head, how, and with which settings.

    Attributes
    ----------
    name, description
        Name and description for tables.
    ball
        The ball.
    head
        "plane" (rigid and at rest), "rigid" (the head of ``club``) or "meshed". In a file, a rigid head may name a
        meshed one (``meshed``) instead of a club; it then has the mass, CG, inertia and face of that head.
    club
        For a head: a club, or a meshed head.
    delivery
        Delivery of the head, as for :func:`clubface.impact`; for a plane, ``speed`` and ``angle`` of the ball.
    friction
        Coefficient of Coulomb friction; that of the ball unless given.
    settings
        How to run the case.
    """

    name: str
    ball: Ball
    head: str
    delivery: Mapping[str, Any]
    club: Club | MeshedHead | None = None
    friction: Any = None
    settings: Settings = field(default_factory=Settings)
    description: str = ""

    def __post_init__(self) -> None:
        check_name(self.name)
        check_text("description", self.description)
        check_choice("kind of head", self.head, HEADS)
        known = delivery_keys(self.head)
        check_names("value of the delivery", self.delivery, known)
        for name, value in self.delivery.items():
            if isinstance(value, Sequence) and not isinstance(value, str):
                raise InputError(name, value, "one value; use a sweep for several")
        if "speed" not in self.delivery:
            raise InputError("speed", None, 'give it, as in speed = "35 m/s"')
        object.__setattr__(self, "friction", friction_of(self.friction, self.ball))
        if self.head == PLANE:
            if self.club is not None:
                raise InputError("club", self.club.name, 'leave it out for a plane, or set kind = "rigid" or "meshed"')
            throw_values(self.delivery["speed"], self.delivery.get("angle", 0.0))
            return
        if self.club is None:
            raise InputError("club", None, f"give the club, which a head of kind {self.head} needs")
        if isinstance(self.club, MeshedHead) != (self.head == MESHED):
            raise InputError("club", self.club.name, "a meshed head" if self.head == MESHED else "a club")
        # A reduced model refuses what no model can compute, such as a face that moves away from the ball.
        rigid = self.club.club if isinstance(self.club, MeshedHead) else self.club
        with without_warnings(RangeWarning):
            impact(rigid, self.delivery, ball=self.ball.rigid)

    def replace(self, *, settings: Mapping[str, Any] | None = None, **changes: Any) -> Case:
        """Return the case with values of the delivery, the ball, the friction or the settings changed."""
        fields = {key: changes.pop(key) for key in ("ball", "friction", "club") if key in changes}
        return replace(
            self,
            delivery={**self.delivery, **changes},
            settings=replace(self.settings, **(settings or {})),
            **fields,
        )

    def run(self, progress: Progress | None = None) -> Impact:
        """Run the case."""
        if self.head == PLANE:
            return throw(self.ball, friction=self.friction, settings=self.settings, progress=progress, **self.delivery)
        assert self.club is not None
        return strike(
            self.club, self.delivery, which=self.ball, friction=self.friction, settings=self.settings, progress=progress
        )

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Case:
        """Read a case from a TOML file; balls and clubs that it names by path are looked for beside it."""
        return from_document(Document.read(path), Path(os.fspath(path)).parent)


def delivery_keys(head: str) -> tuple[str, ...]:
    """Return the names of the values of a delivery."""
    return PLANE_KEYS if head == PLANE else tuple(DIMENSIONS)


def case_names() -> tuple[str, ...]:
    """Return the names of the cases that come with clubface."""
    return builtin_names(FOLDER)


def case(which: str | os.PathLike[str] | Case) -> Case:
    """Return a built-in case by name, or read one from a TOML file."""
    if isinstance(which, Case):
        return which
    return Case.from_toml(path_of("case of finite elements", which, FOLDER))


def from_document(document: Document, folder: Path) -> Case:
    """Read the case a TOML document describes."""
    data = dict(document.data)
    document.check_keys(data, KEYS, ("name", "ball", "head", "delivery"))
    document.check_text(data, ("name", "description", "ball"))
    tables = {key: data.get(key, {}) for key in ("head", "delivery", "run")}
    for key, table in tables.items():
        if not isinstance(table, dict):
            raise document.error(f"{key} must be a table: [{key}]", key)
    document.check_keys(tables["head"], HEAD_KEYS, ("kind",), "head")
    document.check_text(tables["head"], HEAD_KEYS, "head")
    document.check_keys(tables["run"], tuple(Settings.__dataclass_fields__), (), "run")
    kind = tables["head"]["kind"]
    if kind not in HEADS:
        raise document.error(str(UnknownNameError("kind of head", kind, HEADS)), "kind", "head")
    document.check_keys(tables["delivery"], delivery_keys(kind), ("speed",), "delivery")
    try:
        settings = Settings(**tables["run"])
    except ClubfaceError as error:
        raise document.wrap(error, "run") from error
    try:
        return Case(
            name=data["name"],
            description=data.get("description", ""),
            ball=_read(document, ball, data["ball"], folder, "ball", ""),
            head=kind,
            club=_head(document, tables["head"], folder),
            delivery=tables["delivery"],
            friction=data.get("friction"),
            settings=settings,
        )
    except FileError:
        raise
    except InputError as error:
        table = {"friction": "", "name": "", "description": "", "club": "head"}.get(error.parameter, "delivery")
        raise document.wrap(error, table) from error


def _head(document: Document, table: Mapping[str, Any], folder: Path) -> Club | MeshedHead | None:
    """Read the club or the meshed head that a case names."""
    if "meshed" not in table:
        return _read(document, head if table["kind"] == MESHED else club, table.get("club"), folder, "club", "head")
    if table["kind"] != RIGID:
        told = f'a head of kind {table["kind"]} has no meshed; leave it out, or set kind = "{RIGID}"'
        raise document.error(told, "meshed", "head")
    if "club" in table:
        raise document.error("give club or meshed, not both", "meshed", "head")
    return _read(document, head, table["meshed"], folder, "meshed", "head").club


def _read(document: Document, reader: Callable[[str], T], name: str | None, folder: Path, key: str, table: str) -> Any:
    """Read the ball or club that a case names; files are looked for beside it."""
    if name is None:
        return None
    try:
        return reader(_beside(name, folder))
    except FileError as error:
        if error.line is not None:
            raise
        raise document.error(str(error), key, table) from error
    except ClubfaceError as error:
        raise document.error(str(error), key, table) from error


def _beside(name: str, folder: Path) -> str:
    return str(folder / name) if is_path(name) else name
