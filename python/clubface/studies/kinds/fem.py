"""Finite element studies: cases as in ``clubface fem run``, and tests of meshed heads over faces and designs."""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

from clubface import units
from clubface.equipment.balls import DEFAULT_BALL, FOLDER as BALLS_FOLDER
from clubface.equipment.clubs import club as club_of
from clubface.errors import InputError, RunError, Wording
from clubface.fem import head_tests
from clubface.fem.balls import PIECES_FILE, Ball, PieceRecord, ball as ball_of, from_document as ball_from_document
from clubface.fem.case import FOLDER as CASES_FOLDER, HEADS, MESHED, PLANE, Case, delivery_keys
from clubface.fem.heads import head as head_of
from clubface.fem.heads.meshed import MeshedHead
from clubface.fem.heads.read import FOLDER, OTHERS, design_from_document
from clubface.fem.heads.user_mesh import MeshHead
from clubface.fem.result import Impact
from clubface.fem.stress import IMPACT_SPEED, PartStress, peak_stress
from clubface.schema import Choice, Document, Items, PhysicalValue, Record, Table, Value
from clubface.schema.document import KeyPath
from clubface.schema.values import Tables
from clubface.simulation.results import inputs, outputs
from clubface.studies.axes import Swept, number
from clubface.studies.kinds.kind import ONE_NAME, OUTPUTS, Column, DescribedStudy, Histories, Kind, OneByOne, resolved
from clubface.support.files import input_file, path_of, resolve_name
from clubface.support.renamed import warn_renamed

PIECES: KeyPath = ("pieces",)
"""The list of tables addressed only by their own names."""
NOT_SWEPT = ("kind", "law")
"""Choices that determine which other keys exist."""


SETTINGS = {"duration": "s", "interval": "s", "safety": "1", "bulk_viscosity": "1"}
"""Units of the numeric settings."""
CONTACT = {
    "peak_force": Column("N", "largest force between ball and face"),
    "peak_force_time": Column("s", "when it is reached"),
    "contact_time": Column("s", "from first to last touch"),
    "tangential_max": Column("N", "largest force along the face"),
    "tangential_min": Column("N", "smallest force along the face"),
    "reversal_time": Column("s", "when the force along the face turns round"),
    "spin_max": Column("rad/s", "largest spin on the way"),
    "contraction": Column("1", "largest contraction of the ball over its diameter"),
    "contraction_time": Column("s", "when it is reached"),
    "energy_error": Column("1", "energy that appeared or vanished over that before"),
    "steps": Column("1", "steps in time"),
}
THROWN = {
    "normal_velocity": Column("m/s", "velocity off the plane"),
    "tangential_velocity": Column("m/s", "velocity along the plane"),
    "backspin": Column("rad/s", "spin about the toe direction"),
}
AXES = ("normal", "up", "toe")
TIME = {"time": Column("s", "since first touch")}
HISTORIES: Histories = {
    "contact": {
        **TIME, "normal": Column("N", "force on the ball along the normal of the face"),
        "tangential": Column("N", "force along the face; making backspin is positive"),
        "toe": Column("N", "force towards the toe"), "area": Column("m2", "area of contact"),
    },
    "motion": {
        **TIME, "radius": Column("m", "distance from the mass centre of the ball to the face"),
        **{f"velocity_{axis}": Column("m/s", f"velocity of the ball, {axis}") for axis in AXES},
        **{f"spin_{axis}": Column("rad/s", f"angular velocity of the ball, {axis}") for axis in AXES},
    },
    "energy": {
        **TIME,
        **{name: Column("J", f"{name} energy") for name in ("kinetic", "contact", "strain", "hourglass")},
        **{name: Column("J", f"energy lost by {name}") for name in ("friction", "damping")},
        "viscous": Column("J", "energy that viscoelastic branches took"),
        "plastic": Column("J", "energy that became heat in metal that yields"),
    },
}  # fmt: skip
"""Histories that a study of cases may keep."""
NAMED = ("ball", "club")
USUAL_OF_CASES = (
    "ball_speed", "launch", "backspin", "sidespin", "normal_velocity", "tangential_velocity", "peak_force",
    "contact_time", "contraction", "energy_error",
)  # fmt: skip


@dataclass(frozen=True)
class FileKey:
    """A sweepable key of a file: its path and schema."""

    path: KeyPath
    kind: Value

    @property
    def swept(self) -> Swept:
        """Description of the key as an input of a study."""
        if isinstance(self.kind, PhysicalValue):
            return Swept(units.SI_UNITS[self.kind.dimension])
        if isinstance(self.kind, Choice):
            return Swept(None, tuple(self.kind.known))
        schema = self.kind.json()
        return Swept("1", limits=(schema.get("minimum", 0), schema.get("maximum", 10**6)))

    def written(self, value: float | str) -> float | int | str:
        """Return a value in the form used in the file, in SI."""
        counted = not isinstance(value, str) and not isinstance(self.kind, PhysicalValue)
        return int(value) if counted else value


@dataclass(frozen=True)
class VariedFile:
    """A file with swept values.

    Keys in tables are named by table and key, as in ``thickness_face_centre`` and ``trims_toe_x``, keys of pieces by
    the piece, as in ``core_c10``, and keys at the top with the prefix ``group``, as in ``ball_cube``.
    """

    document: Document
    table: Table  # schema of its content
    group: str

    @cached_property
    def keys(self) -> Mapping[str, FileKey]:
        """Keys by name: those in the file, and those allowed at its top level and in its tables."""
        return {"_".join(name): key for name, key in _leaves(self.table, self.document.data, (), (self.group,))}

    def with_values(self, values: Mapping[str, float | str]) -> Document:
        """Return the document with some keys changed, by name; numbers are in SI."""
        data = copy.deepcopy(self.document.data)
        for name, value in values.items():
            if name not in self.keys:
                raise InputError(name, value, f"left out: {self.document.path} has no such key")
            *tables, last = self.keys[name].path
            inside: Any = data
            for part in tables:
                inside = inside.setdefault(part, {}) if isinstance(inside, dict) else inside[part]
            inside[last] = self.keys[name].written(value)
        varied = copy.copy(self.document)
        varied.data = data
        return varied


def _leaves(kind: Value, given: Any, path: KeyPath, name: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], FileKey]]:
    if isinstance(kind, Tables):
        for index, each in enumerate(given if isinstance(given, list) else ()):
            label = str(each.get("name", index))
            yield from _leaves(kind.table, each, (*path, index), (label,) if path == PIECES else (*name, label))
    elif isinstance(kind, Table | Record):
        table = given if isinstance(given, Mapping) else {}
        for key, each in _kinds(kind, table).items():
            nested = isinstance(each, Tables | Table | Record)
            # A dataclass table knows its keys without a file; other tables only have the keys present.
            if key in table or isinstance(kind, Table) or (len(path) == 1 and not nested and given is not None):
                inner = (key,) if nested and not path else (*name, key)
                yield from _leaves(each, table.get(key), (*path, key), inner)
    elif name[-1] not in NOT_SWEPT and (
        isinstance(kind, PhysicalValue | Choice) or kind.json().get("type") == "integer"
    ):
        yield name, FileKey(path, kind)


def _kinds(kind: Table | Record, given: Mapping[str, Any]) -> Mapping[str, Value]:
    """Return the schemas of the keys of a table."""
    if isinstance(kind, PieceRecord):
        return kind.key_types(given)
    if isinstance(kind, Record):
        return dict.fromkeys(given, kind.values) if isinstance(kind.values, Value) else kind.keys()
    return {key: each.value for key, each in kind.keys().items()}


def short_names(full: Iterable[str], taken: Iterable[str]) -> dict[str, str]:
    """Return unambiguous shorter names, such as ``cube`` for ``ball_cube``."""
    longer: dict[str, list[str]] = {}
    for name in full:
        parts = name.split("_")
        for start in range(1, len(parts)):
            longer.setdefault("_".join(parts[start:]), []).append(name)
    taken = {*taken}
    return {short: names[0] for short, names in longer.items() if len(names) == 1 and short not in taken}


def _swept_of_runs() -> dict[str, Swept]:
    """Return the sweepable inputs of every case: delivery, friction, settings, and ball and club by name."""
    keys = dict.fromkeys(key for head in HEADS for key in delivery_keys(head))
    delivered = {name: Swept(inputs()[name].unit if name in inputs() else "rad") for name in keys}
    own = {"friction": Swept("1"), **{name: Swept(unit) for name, unit in SETTINGS.items()}}
    return {**delivered, **own, **{name: Swept(None) for name in NAMED}}


def _swept_cases(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    known = _swept_of_runs()
    if not isinstance(table.get("case"), str | Path):
        return known
    files = CaseFiles.read(table["case"])
    balls, heads = (sweep[name] if isinstance(sweep.get(name), list) else [None] for name in NAMED)
    return _with_files(known, [*map(files.ball, balls), *map(files.head, heads)])


def _with_files(known: Mapping[str, Swept], files: Iterable[VariedFile | None]) -> dict[str, Swept]:
    """Return the sweepable inputs extended by keys of files, under full and unambiguous shorter names."""
    own = {name: key.swept for each in files if each is not None for name, key in each.keys.items()}
    short = {name: own[full] for name, full in short_names(own, {*known, *own}).items()}
    return {**short, **own, **known}


@dataclass(frozen=True)
class CaseFiles:
    """The files of a case: its ball, and the design of its head if it is meshed."""

    document: Document
    case: Case

    @classmethod
    def read(cls, source: Any) -> CaseFiles:
        """Return the files of a case, given by name or path."""
        path = path_of("case of finite elements", source, CASES_FOLDER)
        return cls(Document.read(path), Case.from_toml(path))

    def ball(self, name: Any = None) -> VariedFile:
        """Return the file of the ball, or of another ball by name or path."""
        return _ball_file(self._resolved(self.document.data["ball"]) if name is None else name)

    def head(self, name: Any = None) -> VariedFile | None:
        """Return the file of the meshed head, or of another head; None for a plane or a club."""
        head = self.document.data["head"]
        named = head.get("club") if head.get("kind") == MESHED else head.get("meshed")
        if named is None:
            return None
        return _head_file(self._resolved(named) if name is None else name)

    def _resolved(self, name: Any) -> Any:
        return resolve_name(name, Path(self.document.path).parent)


def _ball_file(name: Any) -> VariedFile:
    return VariedFile(
        Document.read(path_of("ball", DEFAULT_BALL if name is None else name, BALLS_FOLDER)), PIECES_FILE, "ball"
    )


def _head_file(name: Any) -> VariedFile:
    document = Document.read(path_of("head of finite elements", name, FOLDER))
    return VariedFile(document, Table(type(design_from_document(document)), OTHERS), "head")


class Variation:
    """The changes of a task in ``files``, by full name; ``known`` are the names of other inputs."""

    def __init__(self, study: DescribedStudy, files: Iterable[VariedFile], known: Collection[str]) -> None:
        keys = {name for each in files for name in each.keys}
        full = {name: name for name in keys} | short_names(keys, {*known, *keys})
        self.names = {each.name: full[each.name] for each in study.design.axes if each.name in {*full} - {*known}}
        twice = [name for name in self.names if name != self.names[name] and self.names[name] in self.names]
        if twice:
            raise InputError(twice[0], Wording(f"swept twice, also as {self.names[twice[0]]}"), "one line of [sweep]")

    def of(
        self, file: VariedFile, task: Mapping[str, Any], others: Iterable[VariedFile]
    ) -> tuple[tuple[str, Any], ...]:
        """Return the changes of a task in a file, without those that belong only to the ``others``."""
        elsewhere = {name for each in others for name in each.keys} - {*file.keys}
        changes = ((full, task[name]) for name, full in self.names.items() if name in task)
        return tuple((full, value) for full, value in changes if full not in elsewhere)


def _case_task(study: DescribedStudy) -> OneByOne:
    if "case" not in study.table:
        raise InputError("case", None, 'a case of finite elements, as in case = "paper"')
    files = CaseFiles.read(resolved(study.table["case"], study.folder))
    base = files.case
    launched = {name: Column(each.unit, each.meaning) for name, each in outputs().items()}
    every = {**(THROWN if base.head == PLANE else launched), **CONTACT}

    swept = {each.name for each in study.design.axes}
    readers: dict[str, Callable[[Any], Any]] = {"ball": ball_of, "club": head_of if base.head == MESHED else club_of}
    parts = {name: study.load(name, read) for name, read in readers.items() if name in swept}
    balls = study.load("ball", _ball_file) if "ball" in swept else {None: files.ball()}
    heads: dict[Any, VariedFile | None] = {None: files.head()}
    if "club" in swept and heads[None] is not None:
        heads = dict(study.load("club", _head_file))
    head_files = [each for each in heads.values() if each is not None]
    variation = Variation(study, [*balls.values(), *head_files], _swept_of_runs())

    @lru_cache(maxsize=1)
    def ball(name: Any, changes: tuple[tuple[str, Any], ...]) -> Ball:
        return ball_from_document(balls[name].with_values(dict(changes)))

    @lru_cache(maxsize=1)
    def head(name: Any, changes: tuple[tuple[str, Any], ...]) -> Any:
        file = heads[name]
        assert file is not None
        made = design_from_document(file.with_values(dict(changes))).mesh()
        return made if base.head == MESHED else made.club

    def compute(task: Mapping[str, Any]) -> dict[str, Any]:
        changed = {name: each for name, each in task.items() if name not in variation.names}
        changed |= {name: each[task[name]] for name, each in parts.items()}
        named_ball, named_head = (task.get(name) for name in NAMED)
        of_ball = variation.of(balls[named_ball], task, head_files)
        if of_ball:
            changed["ball"] = ball(named_ball, of_ball)
        file = heads.get(named_head)
        of_head = () if file is None else variation.of(file, task, balls.values())
        if of_head:
            changed["club"] = head(named_head, of_head)
        impact = _varied(base, changed).run()
        if impact.stopped:
            raise RunError(impact.stopped)
        figures = {**{name: getattr(impact, name) for name in CONTACT}, **impact.outcome()}
        return {**figures, **{name: _history(impact, name) for name in kept}}

    kept = {name: HISTORIES[name] for name in study.table.get("histories", ())}
    columns = study.columns(every, tuple(name for name in USUAL_OF_CASES if name in every))
    return OneByOne(study, columns, compute, elements=True, histories=kept)


def _history(impact: Impact, name: str) -> dict[str, Any]:
    """Return a history of a run, with three columns for each vector."""
    columns: dict[str, Any] = {}
    for known, values in getattr(impact, name).items():
        parts = {f"{known}_{axis}": each for axis, each in zip(AXES, values.T, strict=True)} if values.ndim > 1 else {}
        columns |= parts or {known: values}
    return columns


def _varied(base: Case, task: Mapping[str, Any]) -> Case:
    """Return a case with the swept inputs of a task."""
    changes = {name: each for name, each in task.items() if name not in SETTINGS}
    settings = {"threads": 1, **{name: task[name] for name in SETTINGS if name in task}}
    return base.replace(settings=settings, **changes)


CASE_KEYS = {"case": ONE_NAME, "outputs": OUTPUTS, "histories": Items(Choice(HISTORIES), 1, len(HISTORIES))}
CASES = Kind(name="fem", keys=CASE_KEYS, swept=_swept_cases, task=_case_task)


PLACE = {
    "toe": "m", "high": "m", "speed": "m/s", "striker_speed": "m/s", "impact_speed": "m/s", "friction": "1",
    "safety": "1", "blow": "m/s",
}  # fmt: skip
"""Units of impact point, speeds of ball, striker and club, and other inputs of the tests; ``blow`` is the old name of
``impact_speed``."""
COLUMNS = {
    "restitution": Column("1", "coefficient of restitution of ball and free head"),
    "characteristic_time": Column("s", "time in which the face throws back a small steel sphere"),
    "stress": Column("Pa", "largest stress of a part in an impact, elastic"),
    "margin": Column("1", "least share by which the stress of a part may grow before it yields"),
    "mass": Column("kg", "mass of the head"),
    "cg_x": Column("m", "from the CG to the face centre, towards the target"),
    "cg_y": Column("m", "the same, up"),
    "cg_z": Column("m", "the same, towards the toe"),
    "ixx": Column("kg m2", "moment of inertia about the CG, axis to the target"),
    "iyy": Column("kg m2", "the same, vertical axis"),
    "izz": Column("kg m2", "the same, axis from heel to toe"),
}
USUAL_OF_HEADS = ("restitution", "characteristic_time")


def _swept_heads(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    known = {**{name: Swept(unit) for name, unit in PLACE.items()}, "head": Swept(None), "ball": Swept(None)}
    heads, balls = (
        sweep[name] if isinstance(sweep.get(name), list) else [table.get(name)] for name in ("head", "ball")
    )
    return _with_files(known, [*(_head_file(each) for each in heads if each is not None), *map(_ball_file, balls)])


def _head_task(study: DescribedStudy) -> OneByOne:
    table = study.table
    swept = {each.name for each in study.design.axes}
    if "head" not in {*swept, *table}:
        raise InputError("head", None, 'give it, as in head = "paper"')
    head_files = study.load("head", _head_file)
    for each in head_files.values():
        design = design_from_document(each.document)
        if isinstance(design, MeshHead):
            input_file(design.file)
    ball_files = study.load("ball", _ball_file)
    held = {name: number(name, table[name], unit) for name, unit in PLACE.items() if name in table}
    columns = study.columns(COLUMNS, USUAL_OF_HEADS)
    if "blow" in {*swept, *held}:
        if "impact_speed" in {*swept, *held}:
            raise InputError("blow", Wording("given twice"), "left out: it is the old name of impact_speed")
        warn_renamed("blow of [head]", "impact_speed")
    variation = Variation(study, [*head_files.values(), *ball_files.values()], (*PLACE, "head", "ball"))

    @lru_cache(maxsize=1)
    def meshed(name: str, changes: tuple[tuple[str, Any], ...]) -> MeshedHead:
        return design_from_document(head_files[name].with_values(dict(changes))).mesh()

    @lru_cache(maxsize=1)
    def made_ball(name: str | None, changes: tuple[tuple[str, Any], ...]) -> Ball:
        return ball_from_document(ball_files[name].with_values(dict(changes)))

    def compute(task: Mapping[str, Any]) -> dict[str, Any]:
        how = {**held, **{name: each for name, each in task.items() if name not in variation.names}}
        named_head, named_ball = (task.get(name, table.get(name)) for name in ("head", "ball"))
        head_file, ball_file = head_files[named_head], ball_files[named_ball]
        made = meshed(named_head, variation.of(head_file, task, ball_files.values()))
        ball = made_ball(named_ball, variation.of(ball_file, task, head_files.values()))
        place = {name: how[name] for name in ("toe", "high") if name in how}
        given = {name: how[name] for name in ("friction", "safety") if name in how}
        safety = {name: given[name] for name in ("safety",) if name in given}
        rigid, speed = made.club, how.get("impact_speed", how.get("blow", IMPACT_SPEED))

        @lru_cache
        def stresses() -> list[PartStress]:
            return peak_stress(made, ball=ball, speed=speed, threads=1, **given, **place)

        return {
            "restitution": lambda: head_tests.restitution(
                made, ball=ball, speed=how.get("speed", head_tests.COR_SPEED), threads=1, **given, **place
            ),
            "characteristic_time": lambda: head_tests.characteristic_time(
                made, speed=how.get("striker_speed", head_tests.STRIKER_SPEED), threads=1, **safety, **place
            ),
            "stress": lambda: max(part.stress for part in stresses()),
            "margin": lambda: min(math.nan if part.margin is None else part.margin for part in stresses()),
            **{name: getattr(rigid, name) for name in ("mass", "cg_x", "cg_y", "cg_z", "ixx", "iyy", "izz")},
        }  # fmt: skip

    return OneByOne(study, columns, compute, elements=True)


HEAD_KEYS = {
    "head": ONE_NAME,
    "ball": ONE_NAME,
    **{name: PhysicalValue(unit) for name, unit in PLACE.items()},
    "outputs": OUTPUTS,
}
MESHED_HEADS = Kind(name="head", keys=HEAD_KEYS, swept=_swept_heads, task=_head_task)
