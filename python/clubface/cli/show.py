"""How every command outputs its result: printed, or written as JSON, tables, pictures and a report."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

import typer

from clubface.cli import app, options, output
from clubface.cli.failures import print_written
from clubface.errors import ClubfaceError
from clubface.quantities import quantities
from clubface.results.result import Result
from clubface.support.checks import check_choice
from clubface.units import unit as unit_named

JSON: options.Group = {
    "as_json": (Annotated[bool, typer.Option("--json", help="Print one JSON document instead.")], False)
}
_REPORT = "Write a report with text, pictures and sources: .html or .md."
REPORT = options.group(None, report=(options.Text, None, "FILE", _REPORT))
FOLDER: options.Group = {
    "folder": (Annotated[options.Text, options.output("FOLDER", "Write tables and pictures to this folder.")], None)
}
_UNITS = 'Unit of a quantity in tables and pictures: "carry=m". Repeatable.'
UNITS = options.group(None, unit=(options.Texts, None, "NAME=UNIT", _UNITS))
"""Option groups for the destinations of a result; :class:`Output` takes their values."""


def plot_option(words: str) -> options.Group:
    """Return the option for a picture, described by ``words``."""
    return options.group(None, plot=(options.Text, None, "FILE", f"Draw {words}: .png, .svg or .pdf."))


def table_option(words: str) -> options.Group:
    """Return the option for the file of the main table; ``words`` are its help."""
    return {"target": (Annotated[options.Text, options.output("FILE", words)], None)}


TABLE = table_option("Write the main table to this CSV or Parquet file.")


@dataclass(frozen=True)
class Output:
    """The destinations of a result."""

    as_json: bool = False  # whether JSON is printed instead of tables
    target: str | None = None  # file of the main table
    plot: str | None = None  # file of the picture
    report: str | None = None
    folder: str | None = None  # of tables and pictures
    units: Mapping[str, str] = field(default_factory=dict)  # for display, by quantity

    @classmethod
    def check(
        cls, texts: Mapping[str, Any], inputs: Iterable[str | None] = (), kinds: Sequence[str] | None = None
    ) -> Output:
        """Return the destinations of a result from the options of a command; errors are raised before any work.

        ``inputs`` are the input files, ``kinds`` the extensions allowed for the file of the table.
        """
        from clubface.present.report import TABLES

        given = list(inputs)
        result = cls(
            bool(texts.get("as_json")), texts.get("target"), texts.get("plot"), texts.get("report"),
            texts.get("folder"), _units(texts.get("unit")),
        )  # fmt: skip
        if result.as_json and result.units and result.plot is None and result.report is None:
            raise ClubfaceError("--unit is for tables and pictures; JSON has fixed units: leave out --unit or --json")
        output.check_target("--output", result.target, TABLES if kinds is None else kinds, given)
        output.check_picture(result.plot, given)
        output.check_report(result.report, given)
        output.prepare_folder(result.folder)
        return result

    def show(
        self,
        result: Result,
        *,
        write_table: bool = True,
        more: Sequence[object] = (),
        parts: Mapping[str, Result] | None = None,
    ) -> None:
        """Print a result, write the requested files, and print their names.

        ``write_table`` is False if the command has written the target itself. ``more`` are further files written by the
        command. ``parts`` are written to subfolders in place of the whole.
        """
        result = result.replace(provenance=result.provenance.with_files())
        try:
            more = [*more, *self._write(result, write_table, {"": result} if parts is None else parts)]
        finally:  # show long computations even if the disk is full
            if self.as_json:
                from clubface.present.report import json_text

                print(json_text(result.to_dict()))
            else:
                from clubface.present.terminal import print_result

                print_result(result, self.units)
        print_written([*more, *(each for each in (self.target, self.plot, self.report) if each is not None)])

    def _write(self, result: Result, write_table: bool, parts: Mapping[str, Result]) -> list[Path]:
        """Write the requested files and return the files in the folder."""
        if self.target is not None and write_table:
            from clubface.present import report

            report.write_table(result.table(), self.target)
        if self.plot is not None:
            save_picture(result, self.plot, self.units)
        if self.report is not None:
            from clubface.present.report import write_report

            write_report(result, self.report, units=self.units, command=app.command())
        if self.folder is None:
            return []
        from clubface.present.report import write_folder

        written = []
        for name, each in parts.items():
            written += write_folder(each, Path(self.folder, name), units=self.units, command=app.command())
        return written


def save_picture(result: Result, path: str | Path, units: Mapping[str, str] | None = None) -> Path:
    """Write the first picture of a result to a file and return the file."""
    from clubface.present.drawing import draw
    from clubface.present.style import save

    return save(draw(result.pictures()[0], units), path)


def _units(texts: Iterable[str] | None) -> dict[str, str]:
    """Return the requested units, by quantity."""
    known = quantities()
    chosen = {}
    for name, symbol in options.pairs(texts or (), "--unit").items():
        check_choice("quantity of --unit", name, known)
        chosen[name] = unit_named(symbol, name="--unit", dimension=known[name].dimension).symbol
    return chosen
