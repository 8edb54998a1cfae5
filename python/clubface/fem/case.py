"""Finite element cases: ball, head, delivery and settings in one TOML file, for repeatable and varied runs."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from clubface.equipment.balls import COVER_FRICTION
from clubface.equipment.clubs import Club, club
from clubface.errors import InputError, RangeWarning
from clubface.fem.balls import Ball, ball, friction_of
from clubface.fem.core import Progress
from clubface.fem.heads import MeshedHead, head
from clubface.fem.result import Impact
from clubface.fem.run import strike, throw, throw_values
from clubface.fem.settings import Settings
from clubface.schema.document import Document, Place
from clubface.schema.tables import Table, decode, file_key
from clubface.schema.values import NAME, TEXT, Choice, PhysicalValue, Record, Reference, Unread
from clubface.simulation.impact import impact
from clubface.simulation.inputs import DELIVERY_QUANTITIES, DIMENSIONS
from clubface.support.checks import check_choice, check_name, check_names, check_text, without_warnings
from clubface.support.files import builtin_names, path_of

__all__ = ["Case", "case", "case_names"]

FOLDER = "fem_cases"
PLANE, RIGID, MESHED = "plane", "rigid", "meshed"
HEADS = (PLANE, RIGID, MESHED)
PLANE_KEYS = ("speed", "angle")
DELIVERED = DELIVERY_QUANTITIES | {"angle": PhysicalValue("deg")}


@dataclass(frozen=True, kw_only=True)
class Case:
    """A finite element case: ball, head, delivery and settings.

    Attributes
    ----------
    name, description
        Name and description shown in tables.
    ball
        The ball.
    head
        "plane" (rigid, at rest), "rigid" (the head of ``club``) or "meshed". In a file, a rigid head may name a meshed
        head (``meshed``) in place of a club; it then has that head's mass, CG, inertia and face.
    club
        A club for a rigid head, a meshed head for a meshed one, None for a plane.
    delivery
        Delivery of the head, as for :func:`clubface.impact`; for a plane, ``speed`` and ``angle`` of the ball.
    friction
        Coefficient of Coulomb friction; default: the ball's.
    settings
        Settings of the run.
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
            raise InputError("club", None, f"give the club; a {self.head} head needs one")
        if isinstance(self.club, MeshedHead) != (self.head == MESHED):
            raise InputError("club", self.club.name, "a meshed head" if self.head == MESHED else "a club")
        # The rigid-body model rejects deliveries that no model can compute, such as a face moving away from the ball.
        rigid = self.club.club if isinstance(self.club, MeshedHead) else self.club
        with without_warnings(RangeWarning):
            impact(rigid, self.delivery, ball=self.ball.rigid)

    def replace(self, *, settings: Mapping[str, Any] | None = None, **changes: Any) -> Case:
        """Return a copy with changed delivery, ball, club, friction or settings."""
        fields = {key: changes.pop(key) for key in ("ball", "friction", "club") if key in changes}
        return replace(
            self, delivery={**self.delivery, **changes}, settings=replace(self.settings, **(settings or {})), **fields
        )

    def run(self, progress: Progress | None = None) -> Impact:
        """Run the case and return the impact."""
        if self.head == PLANE:
            return throw(self.ball, friction=self.friction, settings=self.settings, progress=progress, **self.delivery)
        assert self.club is not None
        return strike(
            self.club, self.delivery, ball=self.ball, friction=self.friction, settings=self.settings, progress=progress
        )

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Case:
        """Read a case from a TOML file; paths of balls and clubs in it are relative to the file."""
        return from_document(Document.read(path))


def delivery_keys(head: str) -> tuple[str, ...]:
    """Return the names of the delivery values for a kind of head."""
    return PLANE_KEYS if head == PLANE else tuple(DIMENSIONS)


def case_names() -> tuple[str, ...]:
    """Return the names of the built-in cases."""
    return builtin_names(FOLDER)


def case(source: str | os.PathLike[str] | Case) -> Case:
    """Return a case: a built-in one by name, one from a TOML file, or ``source`` if it is a case already."""
    if isinstance(source, Case):
        return source
    return Case.from_toml(path_of("case of finite elements", source, FOLDER))


def _make_head(values: dict[str, str], place: Place) -> tuple[str, Club | MeshedHead | None]:
    """Return the kind of head, and the club or meshed head that the file names."""
    kind, key = values["kind"], "meshed" if "meshed" in values else "club"
    with (at := place.key(key)).errors():
        if key == "club":
            read = Reference(head if kind == MESHED else club).read
            return kind, read(values["club"], at) if "club" in values else None
        if kind != RIGID:
            allowed = f'leave it out of a head of kind {kind}, or set kind = "{RIGID}"'
            raise InputError("meshed", values["meshed"], allowed)
        if "club" in values:
            raise InputError("meshed", values["meshed"], "left out; give club or meshed, not both")
        return kind, Reference(head).read(values["meshed"], at).club


_HEAD = Record({"kind": Choice(HEADS, "kind of head"), "club": TEXT, "meshed": TEXT}, ("kind",), make=_make_head)


@dataclass(frozen=True, kw_only=True)
class CaseFile:
    """Keys of a case file."""

    name: str = file_key(NAME, "name shown in tables")
    description: str = file_key(TEXT, "one sentence", default="")
    ball: Ball = file_key(Reference(ball), "ball made of pieces")
    friction: float = file_key(
        Unread(COVER_FRICTION), "coefficient of Coulomb friction; default: the ball's", default=None
    )
    head: tuple[str, Any] = file_key(_HEAD, 'what the ball strikes: "plane", "rigid" (the head of `club`) or "meshed"')
    delivery: Mapping[str, Any] = file_key(
        Record({key: Unread(each) for key, each in DELIVERED.items()}, ("speed",)),
        "delivery of the head; for a plane `speed` and `angle` of the ball",
    )
    run: Settings = file_key(Table(Settings), "settings of the run", default_factory=Settings)


def from_document(document: Document) -> Case:
    """Read the case described by a TOML document."""
    file = decode(CaseFile, document)
    kind, chosen = file.head
    with Place(document).errors():
        return Case(
            name=file.name, description=file.description, ball=file.ball, head=kind, club=chosen,
            delivery=file.delivery, friction=file.friction, settings=file.run,
        )  # fmt: skip
