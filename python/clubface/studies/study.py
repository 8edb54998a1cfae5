"""The study file: what is computed, which inputs are swept, and in which design.

::

    [study]
    name = "driver-loft"
    kind = "impact"                # the default
    design = "grid"                # grid (the default), latin-hypercube, sobol or table
    samples = 4096                 # for a Latin hypercube or a Sobol sequence
    seed = 1                       # for the same
    chunk = 5000                   # tasks computed and stored together; or
    seconds = 2                    # time per chunk, from which its size follows
    units = { speed = "mph" }      # of table columns without a unit, by input or dimension

    [impact]                       # the table of the kind
    club = "driver"
    held = { speed = "113 mph" }

    [sweep]
    loft = { from = "8 deg", to = "14 deg", count = 13 }
    toe = ["-10 mm", "0 mm", "10 mm"]
    table = "deliveries.csv"       # for the design "table"
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from importlib import import_module
from importlib.metadata import version
from pathlib import Path
from typing import Any

from clubface.errors import ClubfaceError, FileError, InputError, UnknownNameError, Wording
from clubface.schema import (
    NAME,
    TEXT,
    Choice,
    Document,
    PhysicalValue,
    Place,
    Record,
    Simple,
    Table,
    Value,
    count,
    file_key,
)
from clubface.studies.axes import SweepAxis, Swept, axis, inputs_named
from clubface.studies.designs import (
    DESIGNS,
    GRID,
    HYPERCUBE,
    SOBOL,
    TABLE,
    CachedDesign,
    Design,
    DesignRows,
    design,
    table_columns,
)
from clubface.studies.kinds.kind import Computed, DescribedStudy, Kind, Task, resolved
from clubface.support.checks import MOST_SEED, check_choice
from clubface.support.files import InputRecord, absolute

SAMPLED = (HYPERCUBE, SOBOL)
MOST_ROWS = 500_000
"""Maximum number of tasks per chunk."""
SECONDS = 2.0
"""Default time per chunk, approximately [s]."""
KINDS = {
    "impact": "impacts.IMPACTS",
    "comparison": "impacts.COMPARISONS",
    "map": "impacts.MAPS",
    "dispersion": "golfers.DISPERSIONS",
    "best-loft": "impacts.BEST_LOFTS",
    "optimise": "golfers.OPTIMISATIONS",
    "fem": "fem.CASES",
    "head": "fem.MESHED_HEADS",
    "capture": "captures.CAPTURES",
    "empty": "impacts.EMPTY",
}
"""Module and name of each kind of study; some modules take a second to import."""


def kind(name: str) -> Kind:
    """Return a kind of study by name, importing its module."""
    check_choice("kind", name, KINDS)
    module, _, attribute = KINDS[name].partition(".")
    return getattr(import_module(f"clubface.studies.kinds.{module}"), attribute)


@dataclass(frozen=True, kw_only=True, eq=False)
class StudyFile:
    """A study as described by its file.

    Attributes
    ----------
    name
        Name of the study; default the file's name without ending.
    table, sweep
        The kind's table and [sweep], as in the file.
    method, seed
        Name of the design, and seed for sampling.
    design
        The inputs of each task.
    chunk
        Tasks per chunk, or None if ``seconds`` gives the time per chunk [s].
    inputs
        All files read by the study, as they were when read: the study itself, files it names, and files named in these,
        such as a mesh.
    units
        Units of table columns without one.
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
        """The folder to which file names are relative."""
        return self.path.parent

    def content(self) -> dict[str, Any]:
        """Return everything the results depend on besides the version, by readable names."""
        libraries = map(version, ("numpy", "scipy"))  # samples may depend on them
        return {
            "kind": self.kind.name,
            f"[{self.kind.name}]": self.table,
            "[sweep]": [list(self.sweep.items())],
            "design": [self.method, self.design.count],
            **({"units": [sorted(self.units.items())]} if self.units else {}),
            **{f"file {name}": sum_ for name, sum_ in self.files().items()},
            **({"seed or version of SciPy": [self.seed, *libraries]} if self.method in SAMPLED else {}),
            **({} if self.chunk is None else {"chunk": self.chunk}),
        }

    @cached_property
    def task(self) -> Task:
        """The computation of the tasks; all files are read now, and none later.

        Raises
        ------
        FileError
            The study, or a file that it names, has an error.
        """
        with self.inputs.active():
            task = self.kind.prepare(DescribedStudy(self.table, self.sweep, self.design, self.folder, self.wrap))
        self.inputs.close()
        return Loaded(task, self.inputs)

    def files(self) -> dict[str, str]:
        """Return fingerprints of the files the study reads, by their names relative to its folder."""
        _ = self.task
        folder, own = os.path.join(absolute(self.folder), ""), absolute(self.path)
        checksums = {path: each.sha256 for path, each in self.inputs.by_path().items() if path != own}
        # With the same signs between folders on every system, since shares of one study may run on several.
        return {path.removeprefix(folder).replace(os.sep, "/"): sum_ for path, sum_ in sorted(checksums.items())}

    def wrap(self, error: ClubfaceError) -> FileError:
        """Return an error about a value of the kind's table with file and line."""
        return error if isinstance(error, FileError) else Place(self.document, (self.kind.name,)).wrap(error)


class Loaded(Task):
    """A task whose files have been read."""

    def __init__(self, task: Task, inputs: InputRecord) -> None:
        self.task, self.inputs = task, inputs
        self.columns, self.histories, self.depends_on = task.columns, task.histories, task.depends_on

    def run(self, indices: range) -> Computed:
        """Compute consecutive indices, using the files as read before."""
        with self.inputs.active():
            return self.task.run(indices)


def read_study(path: str | os.PathLike[str], inputs: InputRecord | None = None) -> StudyFile:
    """Read a study from its file; raise a :class:`FileError` with the line of an error.

    ``inputs`` are its files, if another process has read them.
    """
    record = InputRecord() if inputs is None else inputs
    with record.active():
        return _read(path, record)


@dataclass(frozen=True, kw_only=True)
class StudyTable:
    """The table [study]: how tasks are chosen and divided into chunks."""

    name: str | None = file_key(NAME, "name; default: the name of the file", default=None)
    kind: str = file_key(Choice(tuple(KINDS)), "what is computed", default="impact")
    design: str = file_key(Choice(tuple(DESIGNS)), "how the tasks are chosen", default=GRID)
    samples: Any = file_key(
        Simple("a whole number"),
        "number of samples of a Latin hypercube (McKay et al. 1979; a million at most) or a Sobol sequence",
        default=None,
    )
    seed: int | None = file_key(count(0, MOST_SEED), "seed of the samples", default=None)
    chunk: int | None = file_key(count(1, MOST_ROWS), "tasks per chunk", default=None)
    seconds: float | None = file_key(
        PhysicalValue("s", 0.01, 600, allowed="from 0.01 to 600 s; 1 to 10 s are usual"),
        "instead: time per chunk on one processor; default 2 s",
        default=None,
    )
    units: Mapping[str, str] = file_key(
        Record(TEXT, example='{ speed = "mph", angle = "deg" }'),
        "units of columns of the design `table` that have none", default_factory=dict,
    )  # fmt: skip

    def __post_init__(self) -> None:
        if self.chunk is not None and self.seconds is not None:
            raise InputError("seconds", self.seconds, "leave it out, since the chunk is given")
        for key in ("samples", "seed"):
            if getattr(self, key) is not None and self.design not in SAMPLED:
                allowed = f"leave it out of the design {self.design}, which is not sampled"
                raise InputError(key, getattr(self, key), allowed)
        if self.units and self.design != TABLE:
            raise InputError("units", self.units, f"leave it out of the design {self.design}, which reads no table")


def _study_file() -> dict[str, Value]:
    """Return the keys of a study file, including the tables of all kinds."""
    tables = {name: Record(kind(name).keys) for name in KINDS}
    return {"study": Table(StudyTable), **tables, "sweep": Record(Simple("a list, or from, to and count or step"))}


STUDY_FILE = Record(_study_file, ("sweep",))


def _read(path: str | os.PathLike[str], inputs: InputRecord) -> StudyFile:
    document = Document.read(path)
    data, place = document.data, Place(document)
    head: StudyTable = Table(StudyTable).read(data.get("study", {}), place.key("study"))
    chosen = kind(head.kind)
    kinds = {"study": Simple(), chosen.name: Record(chosen.keys), "sweep": Record(Simple())}
    Record(kinds, ("sweep",)).read(data, place)
    table = data.get(chosen.name, {})
    with Place(document, (chosen.name,)).errors():
        folder = Path(path).parent
        known = chosen.swept(_with_paths(table, folder), _with_paths(data["sweep"], folder))
        sweep = _flatten_sweep(data["sweep"], known)
    try:
        made = _design(document, known, sweep, head)
        _check_held(document, chosen, table, {each.name: known[each.name] for each in made.axes})
    except InputError as error:
        of_study = error.parameter == "samples" or error.parameter.startswith("the unit of")
        raise Place(document, ("study" if of_study else "sweep",)).wrap(error) from None
    return StudyFile(
        path=Path(path), name=head.name or Path(path).stem, kind=chosen, table=table, sweep=sweep, method=head.design,
        seed=head.seed or 0, design=CachedDesign(made), chunk=head.chunk, seconds=head.seconds or SECONDS,
        document=document, units=head.units, inputs=inputs,
    )  # fmt: skip


def _with_paths(table: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """Return a table with file names, including those in lists, replaced by paths."""
    return {
        key: [resolved(each, folder) for each in value] if isinstance(value, list) else resolved(value, folder)
        for key, value in table.items()
    }


def _flatten_sweep(sweep: Mapping[str, Any], known: Mapping[str, Swept]) -> dict[str, Any]:
    """Return [sweep] with grouped inputs, as in ``air.temperature``, under their own names."""
    flat: dict[str, Any] = {}
    for name, _, given in inputs_named(sweep, known):
        if name in flat:
            raise InputError(name, Wording("swept twice"), "one line of [sweep]")
        flat[name] = given
    return flat


def _check_held(document: Document, kind: Kind, table: Mapping[str, Any], swept: Mapping[str, Swept]) -> None:
    """Raise an error for an input that is both fixed in the kind's table and swept."""
    shared = {key: value for key, value in table.items() if key not in kind.apart}
    for name, place, _ in inputs_named(shared, swept):
        if name in swept:
            line = document.line_of((kind.name, *place.split(".")))
            where = f"as {place} of [{kind.name}]{'' if line is None else f' in line {line}'} and in [sweep]"
            raise InputError(name, Wording(f"held and swept, {where}"), "given in only one of the two places")


def _design(document: Document, known: Mapping[str, Swept], sweep: Mapping[str, Any], head: StudyTable) -> Design:
    """Return the design of a study."""
    axes: list[SweepAxis] = []
    for name, given in sweep.items():
        if name == TABLE:
            continue
        if name not in known:
            raise UnknownNameError("input", name, known)
        axes.append(axis(name, given, known[name]))
    if head.design != TABLE:
        if TABLE in sweep:
            raise InputError(TABLE, sweep[TABLE], 'leave it out, or write design = "table" under [study]')
        return design(head.design, axes, head.samples, head.seed or 0)
    if not isinstance(sweep.get(TABLE), str):
        raise InputError(TABLE, sweep.get(TABLE), 'the name of a file of the design "table", as in "deliveries.csv"')
    columns = table_columns(Path(document.path).parent / sweep[TABLE], known, head.units)
    for each in axes:
        if each.name in columns:
            raise InputError(each.name, Wording("given twice"), "in the table or in [sweep], not in both")
    return DesignRows(columns, axes)
