"""The file of a study: what is computed, what is swept, and in which design.

::

    [study]
    name = "driver-loft"
    kind = "impact"                # unless given
    design = "grid"                # grid (unless given), latin-hypercube, sobol or table
    samples = 4096                 # of a Latin hypercube or a Sobol sequence
    seed = 1                       # of the same
    chunk = 5000                   # tasks computed and kept together; or
    seconds = 2                    # the time that a chunk should take, from which the size follows
    units = { speed = "mph" }      # of columns of the table that name none, by input or dimension

    [impact]                       # the table of the kind
    club = "driver"
    held = { speed = "113 mph" }

    [sweep]
    loft = { from = "8 deg", to = "14 deg", count = 13 }
    toe = ["-10 mm", "0 mm", "10 mm"]
    table = "deliveries.csv"       # of the design "table"
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from clubface import units
from clubface.errors import ClubfaceError, FileError, InputError, Told, UnknownNameError
from clubface.studies.axes import Axis, Swept, axis, inputs_named
from clubface.studies.designs import (
    DESIGNS,
    GRID,
    HYPERCUBE,
    SOBOL,
    TABLE,
    Design,
    Remembered,
    Rows,
    design,
    table_columns,
)
from clubface.studies.kinds.kind import Column, Computed, DescribedStudy, Kind, Task, kind
from clubface.support.checks import check_choice, check_name, is_count
from clubface.support.files import InputRecord, absolute
from clubface.support.strict_toml import Document

KEYS = ("name", "kind", "design", "samples", "seed", "chunk", "seconds", "units")
SAMPLED = (HYPERCUBE, SOBOL)
MOST_ROWS = 500_000
"""Tasks of a chunk."""
SECONDS = 2.0
"""A chunk takes about that time [s] where nothing is said."""


@dataclass(frozen=True, kw_only=True, eq=False)
class StudyFile:
    """A study as its file describes it.

    Attributes
    ----------
    path
        The file.
    name
        What it is called; the file's name without ending unless given.
    kind
        What computes it.
    table, sweep
        The table of the kind and [sweep], as in the file.
    method, seed
        Name of the design, and the seed of a sampled one.
    design
        Which inputs each task has.
    chunk
        Tasks of a chunk, or None where ``seconds`` tell how long one should take [s].
    inputs
        The files that the study reads, as they were when they were read: the study itself, those that it names, and
        those that these name in turn, such as a mesh.
    units
        Units of columns of the table that name none.
    """

    path: Path
    name: str
    kind: Kind
    table: Mapping[str, Any]
    sweep: Mapping[str, Any]
    method: str
    seed: int
    design: Design
    chunk: int | None
    seconds: float
    document: Document
    inputs: InputRecord
    units: Mapping[str, str] = field(default_factory=dict)

    @property
    def folder(self) -> Path:
        """The folder in which relative names of files begin."""
        return self.path.parent

    def content(self) -> dict[str, Any]:
        """Return what the results depend on besides the version, by what a person calls it."""
        return {
            "kind": self.kind.name,
            f"[{self.kind.name}]": self.table,
            "[sweep]": [list(self.sweep.items())],
            "design": [self.method, self.design.count],
            **({"units": [sorted(self.units.items())]} if self.units else {}),
            **{f"file {name}": sum_ for name, sum_ in self.files().items()},
            **({"seed or version of SciPy": [self.seed, *_generators()]} if self.method in SAMPLED else {}),
            **({} if self.chunk is None else {"chunk": self.chunk}),
        }

    @cached_property
    def task(self) -> Task:
        """What is computed; all files are read with it, and none later.

        Raises
        ------
        FileError
            Something is wrong with the study or with a file that it names.
        """
        with self.inputs.active():
            task = self.kind.prepare(DescribedStudy(self.table, self.sweep, self.design, self.folder, self.wrap))
        self.inputs.close()
        return Loaded(task, self.inputs)

    def files(self) -> dict[str, str]:
        """Return fingerprints of the files that the study reads, by their names from its folder."""
        _ = self.task
        folder, own = os.path.join(absolute(self.folder), ""), absolute(self.path)
        found = {path: each.sha256 for path, each in self.inputs.by_path().items() if path != own}
        return {path.removeprefix(folder): sum_ for path, sum_ in sorted(found.items())}

    def wrap(self, error: ClubfaceError) -> FileError:
        """Return an error about a value of the kind's table with file and line."""
        return error if isinstance(error, FileError) else self.document.wrap(error, self.kind.name)


class Loaded:
    """A task whose files are read. See :class:`clubface.studies.kinds.kind.Task`."""

    columns: Mapping[str, Column]
    depends_on: Mapping[str, str]

    def __init__(self, task: Task, inputs: InputRecord) -> None:
        self.task, self.inputs = task, inputs
        self.columns, self.depends_on = task.columns, task.depends_on

    def run(self, indices: range) -> Computed:
        """Compute consecutive indices from the files as they were read."""
        with self.inputs.active():
            return self.task.run(indices)


def read_study(path: str | os.PathLike[str], inputs: InputRecord | None = None) -> StudyFile:
    """Read a study from its file; what is wrong in it is a :class:`FileError` with the line.

    ``inputs`` are its files, where another process has read them.
    """
    record = InputRecord() if inputs is None else inputs
    with record.active():
        return _read(path, record)


def _read(path: str | os.PathLike[str], inputs: InputRecord) -> StudyFile:
    document = Document.read(path)
    data = document.data
    head = _table(document, "study")
    document.check_keys(head, KEYS, (), "study")
    try:
        chosen = kind(head.get("kind", "impact"))
        check_choice("design", method := head.get("design", GRID), DESIGNS)
        check_name(name := head.get("name", Path(path).stem))
        if not is_count(seed := head.get("seed", 0), 0, 2**63 - 1):
            raise InputError("seed", seed, "a whole number from 0")
        chunk, seconds = _chunk(head)
        table_units = _units(head, method)
        for key in ("samples", "seed"):
            if key in head and method not in SAMPLED:
                raise InputError(key, head[key], f"leave it out of the design {method}, which is not sampled")
    except ClubfaceError as error:
        raise document.wrap(error, "study") from None
    document.check_keys(data, ("study", chosen.name, "sweep"), ("sweep",))
    table, sweep = _table(document, chosen.name), _table(document, "sweep")
    document.check_keys(table, chosen.keys, (), chosen.name)
    try:
        known = chosen.swept(table, sweep)
        sweep = _flat(sweep, known)
    except ClubfaceError as error:
        raise document.wrap(error, chosen.name) from None
    try:
        made = _design(document, known, sweep, (method, head.get("samples"), seed), table_units)
        _check_held(document, chosen, table, {each.name: known[each.name] for each in made.axes})
    except InputError as error:
        if error.parameter == "samples" or (error.parameter or "").startswith("the unit of"):
            raise document.wrap(error, "study") from None
        raise document.error(str(error), error.parameter.rpartition(" ")[2], "sweep") from None
    return StudyFile(
        path=Path(path), name=name, kind=chosen, table=table, sweep=sweep, method=method, seed=seed,
        design=Remembered(made), chunk=chunk, seconds=seconds, document=document, units=table_units,
        inputs=inputs,
    )  # fmt: skip


def _units(head: Mapping[str, Any], method: str) -> Mapping[str, str]:
    """Return the units of columns of the table that name none."""
    given = head.get("units", {})
    if not isinstance(given, dict) or not all(isinstance(each, str) for each in given.values()):
        raise InputError("units", given, 'a table of units, as in { speed = "mph", angle = "deg" }')
    if given and method != TABLE:
        raise InputError("units", given, f"leave it out of the design {method}, which reads no table")
    return given


def _table(document: Document, name: str) -> dict[str, Any]:
    found = document.data.get(name, {})
    if not isinstance(found, dict):
        raise document.error(f"{name} must be a table, [{name}]", name)
    return found


def _flat(sweep: Mapping[str, Any], known: Mapping[str, Swept]) -> dict[str, Any]:
    """Return [sweep] with inputs named by group and name, as in ``air.temperature``, under the one name they have."""
    found: dict[str, Any] = {}
    for name, _, given in inputs_named(sweep, known):
        if name in found:
            raise InputError(name, Told("swept twice"), "one line of [sweep]")
        found[name] = given
    return found


def _check_held(document: Document, kind: Kind, table: Mapping[str, Any], swept: Mapping[str, Swept]) -> None:
    """Refuse what the table of a kind holds although it is swept, or is a column of the table that is swept."""
    shared = {key: value for key, value in table.items() if key not in kind.apart}
    for name, place, _ in inputs_named(shared, swept):
        if name in swept:
            inside, _, key = place.rpartition(".")
            line = document.line(key, f"{kind.name}.{inside}" if inside else kind.name)
            where = f"as {place} of [{kind.name}]{'' if line is None else f' in line {line}'}"
            raise InputError(name, Told(f"held and swept, {where} and in [sweep]"), "given in one of both places alone")


def _chunk(head: Mapping[str, Any]) -> tuple[int | None, float]:
    """Return the tasks of a chunk, if they are given, and the time that it should take [s]."""
    if "chunk" in head:
        if "seconds" in head:
            raise InputError("seconds", head["seconds"], "leave it out, since the chunk is given")
        if not is_count(head["chunk"], 1, MOST_ROWS):
            raise InputError("chunk", head["chunk"], f"a whole number of tasks from 1 to {MOST_ROWS}")
        return head["chunk"], SECONDS
    seconds = units.parse(head.get("seconds", SECONDS), "time", name="seconds")
    if not 0.01 <= seconds <= 600.0:
        raise InputError("seconds", head["seconds"], "from 0.01 to 600 s; 1 to 10 s are usual")
    return None, seconds


def _design(
    document: Document,
    known: Mapping[str, Swept],
    sweep: Mapping[str, Any],
    how: tuple[str, Any, int],
    table_units: Mapping[str, str],
) -> Design:
    """Return the design of a study from what may be swept, its method, samples and seed, and units of its table."""
    method, samples, seed = how
    axes: list[Axis] = []
    for name, given in sweep.items():
        if name == TABLE:
            continue
        if name not in known:
            raise document.error(str(UnknownNameError("input", name, known)), name, "sweep")
        axes.append(axis(name, given, known[name]))
    if method != TABLE:
        if TABLE in sweep:
            raise InputError(TABLE, sweep[TABLE], 'leave it out, or write design = "table" under [study]')
        return design(method, axes, samples, seed)
    if not isinstance(sweep.get(TABLE), str):
        raise InputError(TABLE, sweep.get(TABLE), 'the name of a file of the design "table", as in "deliveries.csv"')
    columns = table_columns(Path(document.path).parent / sweep[TABLE], known, table_units)
    for each in axes:
        if each.name in columns:
            raise InputError(each.name, Told("given twice"), "in the table or in [sweep], not in both")
    return Rows(columns, axes)


def _generators() -> tuple[str, str]:
    """Return the versions of what draws samples: another may draw others."""
    from importlib.metadata import version

    return version("numpy"), version("scipy")
