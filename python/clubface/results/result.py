"""The result of a computation in the form that all outputs use, and its provenance.

The outputs are terminal, JSON, CSV, report, notebook and browser.
"""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from clubface.errors import UnknownNameError
from clubface.quantities import Quantity
from clubface.results.notes import Note
from clubface.results.table import Column, Table
from clubface.support.files import InputFile, recorded_files, short_names
from clubface.support.version import __version__

if TYPE_CHECKING:
    import pandas
    import xarray

    from clubface.results.pictures import Picture
Placement = Literal["here", "page", "appendix"]
TITLE_LINE = 0.16
"""Height of a line of the title of a picture [inches]."""
SCHEMA = "clubface-result-1"
"""Name and version of the layout of :meth:`Result.to_dict`; ``data/schemas/result-1.json`` describes it."""


class FileUsed(NamedTuple):
    """A file that a result depends on: its fingerprint, and its name, without the folder if that is unambiguous."""

    name: str
    bytes: int
    sha256: str
    text: str | None = None


class Computation(NamedTuple):
    """The equipment, model and settings that launches were computed with."""

    club: str
    ball: str
    model: str
    parameters: str
    hand: str = "right"


@dataclass(frozen=True)
class Provenance:
    """The inputs, equipment, models and sources that a result was computed from.

    Attributes
    ----------
    inputs
        Input values in words, by name.
    computations
        Clubs, balls, models and parameter sets.
    sources
        Sources of the values, one per work or file.
    caveats
        Caveats stated by the sources.
    files
        The files that were read, except those of the package.
    descriptions
        Texts of the input files needed to compute the result again, by name.
    """

    inputs: Mapping[str, str] = field(default_factory=dict)
    computations: tuple[Computation, ...] = ()
    sources: tuple[str, ...] = ()
    caveats: tuple[str, ...] = ()
    files: tuple[FileUsed, ...] = ()
    descriptions: Mapping[str, str] = field(default_factory=dict)
    versions: Mapping[str, str] = field(default_factory=lambda: versions())

    def with_files(self) -> Provenance:
        """Return the provenance with the files that the running computation has read so far."""
        return replace(self, files=used_files())

    def __add__(self, other: Provenance) -> Provenance:
        return Provenance(
            {**self.inputs, **other.inputs},
            _once(self.computations + other.computations),
            _once(self.sources + other.sources),
            _once(self.caveats + other.caveats),
            _once(self.files + other.files),
            {**self.descriptions, **other.descriptions},
        )

    def to_dict(self) -> dict[str, Any]:
        """Return the provenance as JSON types."""
        return {
            "versions": dict(self.versions),
            "inputs": dict(self.inputs),
            "computed_with": [each._asdict() for each in self.computations],
            "sources": list(self.sources),
            "caveats": list(self.caveats),
            "files": [{"name": each.name, "bytes": each.bytes, "sha256": each.sha256} for each in self.files],
        }


MOST_BYTES = 2**17
"""Maximum size of a stored description [bytes]; larger ones, like tables, are stored as a fingerprint only."""


def used_files(read: Iterable[InputFile] | None = None) -> tuple[FileUsed, ...]:
    """Return the files that the running computation has read, with the text of TOML descriptions."""
    own = [each for each in (recorded_files() if read is None else read) if not each.shipped]
    used = []
    for name, each in zip(short_names([file.path for file in own]), own, strict=True):
        kept = each.content is not None and each.size <= MOST_BYTES and name.lower().endswith(".toml")
        content = each.content.decode("utf-8-sig", errors="replace") if kept and each.content is not None else None
        used.append(FileUsed(name, each.size, each.sha256, content))
    return tuple(used)


def versions() -> dict[str, str]:
    """Return the versions of clubface and of the libraries it computes with."""
    import numpy as np

    return {"clubface": __version__, "python": platform.python_version(), "numpy": np.__version__}


def _once(items: tuple[Any, ...]) -> tuple[Any, ...]:
    return tuple(dict.fromkeys(items))


@dataclass(frozen=True)
class Result:
    """The result of a computation.

    Attributes
    ----------
    kind
        Kind of result, such as "shot" or "face-map"; results of a kind have the same tables.
    title
        Title in words.
    tables
        Tables of numbers; the first is the main table.
    values
        Single values as columns of one row, by name.
    assumptions
        Assumptions about inputs that were not given; shown first in every output, and in the titles of pictures.
    lead
        Advice, in sentences that every output shows first; files have them before the summary.
    summary
        Summary in sentences for a reader who does not know the options.
    notes
        Notes on the tables.
    hints
        Further options of the command; shown in the terminal only.
    parts
        Results that it consists of, such as the clubs of a player; included in reports and JSON.
    placement
        Position as a part of a report: in place, on a new page when printed, or in the collapsed section of technical
        details at the end.
    draw
        Function that makes the pictures, which takes time; None if there are none.
    """

    kind: str
    title: str
    tables: tuple[Table, ...] = ()
    values: tuple[Column, ...] = ()
    assumptions: tuple[Note, ...] = ()
    lead: tuple[Note, ...] = ()
    summary: tuple[Note, ...] = ()
    notes: tuple[Note, ...] = ()
    hints: tuple[Note, ...] = ()
    provenance: Provenance = field(default_factory=Provenance)
    parts: tuple[Result, ...] = ()
    placement: Placement = "here"
    draw: Callable[[], Sequence[Picture]] | None = field(default=None, repr=False, compare=False)

    def table(self, name: str | None = None) -> Table:
        """Return a table by name, or the main one; without tables, the single values form a table of one row."""
        if self.values and not self.tables and name in (None, self.kind):
            return Table(self.kind, self.values, self.title)
        for each in self.tables:
            if name in (None, each.name):
                return each
        raise UnknownNameError("table", name, [each.name for each in self.tables])

    def pictures(self) -> list[Picture]:
        """Return the pictures, with the assumptions in their titles."""
        pictures = [] if self.draw is None else list(self.draw())
        assumed = [each.sentence for each in self.assumptions]
        return [
            replace(
                each, title="\n".join(filter(None, [*assumed, each.title])),
                height=each.height and each.height + TITLE_LINE * len(assumed),
            )
            for each in pictures
        ]  # fmt: skip

    def replace(self, **fields: Any) -> Result:
        """Return the result with some fields changed."""
        return replace(self, **fields)

    def to_dict(self) -> dict[str, Any]:
        """Return the result as JSON types: full digits, metric units, each with its name.

        The layout is that of the schema ``clubface-result-1``.
        """
        return {
            "schema": SCHEMA,
            "kind": self.kind,
            "title": self.title,
            "assumptions": [each.to_dict() for each in self.assumptions],
            "values": {each.key: each.exact(0) for each in self.values},
            "tables": {each.name: {"columns": each.describe(), "rows": each.records()} for each in self.tables},
            "summary": [each.to_dict() for each in (*self.lead, *self.summary)],
            "notes": [each.to_dict() for each in self.notes],
            "provenance": self.provenance.to_dict(),
        } | ({"parts": [each.to_dict() for each in self.parts]} if self.parts else {})

    def to_pandas(self, name: str | None = None) -> pandas.DataFrame:
        """Return a table (default: the main one) with SI values; ``attrs`` has units and provenance."""
        frame = self.table(name).to_pandas()
        frame.attrs["provenance"] = self.provenance.to_dict()
        return frame

    def to_xarray(self, name: str | None = None) -> xarray.Dataset:
        """Return a table (default: the main one) as a dataset over its rows, SI.

        Variables carry their units, the dataset its provenance as JSON.
        """
        import xarray

        chosen = self.table(name)
        variables = {
            each.name: ("row", list(each.values), _attributes(each)) for each in chosen.columns if each.in_files
        }
        provenance = json.dumps(self.provenance.to_dict())
        return xarray.Dataset(variables, attrs={"title": self.title, "kind": self.kind, "provenance": provenance})

    def write(self, folder: str | os.PathLike[str], tables: Mapping[str, Table] | None = None) -> list[Path]:
        """Write pages (HTML and Markdown), JSON, tables and pictures into a folder; return the files.

        ``tables`` are additional tables, or replacements, by file name.
        """
        from clubface.present.report import write_folder

        return write_folder(self, folder, pages=(".html", ".md"), tables=tables)

    def _repr_html_(self) -> str:
        from clubface.present.report import as_fragment

        return as_fragment(self)

    def __str__(self) -> str:
        from clubface.present.terminal import as_text

        return as_text(self)


class Presentable:
    """Mixin that adds the outputs of :class:`Result` that do not depend on its tables."""

    def to_result(self) -> Result:
        """Return a :class:`Result`."""
        raise NotImplementedError

    def to_dict(self) -> Mapping[str, Any]:
        """Return the result as JSON types; see :meth:`Result.to_dict`."""
        return self.to_result().to_dict()

    def _repr_html_(self) -> str:
        return self.to_result()._repr_html_()


class Described(Presentable):
    """Mixin that adds all outputs of :class:`Result`; classes with tables of their own override some."""

    def to_pandas(self, name: str | None = None) -> pandas.DataFrame:
        """Return a table of the result (default: the main one); see :meth:`Result.to_pandas`."""
        return self.to_result().to_pandas(name)

    def to_xarray(self, name: str | None = None) -> xarray.Dataset:
        """Return a table of the result (default: the main one); see :meth:`Result.to_xarray`."""
        return self.to_result().to_xarray(name)


def _attributes(column: Column) -> dict[str, str]:
    if not isinstance(column.quantity, Quantity):
        return {}
    return {"units": column.quantity.unit, "long_name": column.quantity.meaning or column.quantity.label}
