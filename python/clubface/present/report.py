"""Writes results with all digits: JSON and tables, reports, folders with all of these, and HTML for notebooks.

A report is a summary in words, pictures, tables with their data, and provenance.
"""

from __future__ import annotations

import csv
import html
import io
import json
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from clubface.errors import LINES, FileError, legible
from clubface.present.document import (
    Appendix,
    Block,
    Bullets,
    Data,
    DocumentPicture,
    Heading,
    Listing,
    PageBreak,
    Paragraph,
    TextTable,
    file_name,
    write_document,
)
from clubface.present.terminal import headings_and_rows, values_of
from clubface.results.pictures import Picture
from clubface.results.result import Provenance, Result
from clubface.results.table import Table
from clubface.support.checks import plain
from clubface.support.files import prepared_folder, whole_file, write_text

TABLES = (".csv", ".tsv", ".parquet", ".pq")
"""Endings of table files."""
WORKS = {
    "Caldwell and McPhee|Three-dimensional golf clubhead": "Caldwell and McPhee (2023): Three-dimensional golf "
    "clubhead-ball impact models for drivers and irons, and the thesis it grew out of, A. W. Caldwell, Development and "
    "comparison of 3D dynamic models of golf clubhead-ball impacts, MASc thesis, University of Waterloo, 2023",
    "Roh and Lee": "Roh and Lee: W.-J. Roh and C.-W. Lee, Analysis of golf ball spin mechanism at impact by FEM, Center"
    " for Noise and Vibration Control, KAIST, Daejeon",
    r"Penner \(2002\)": "Penner (2002): A. R. Penner, The run of a golf ball, Canadian Journal of Physics 80, 931-940",
    "Broadie and Ko": "Broadie and Ko (2009): A simulation model to analyze the impact of distance and direction on "
    "golf scores, Proceedings of the Winter Simulation Conference",
    "TrackMan Combine": "TrackMan (2024): averages of the TrackMan Combine by handicap",
}
"""Full references of works that are cited briefly, by a pattern of the short form."""
MOST_ROWS = 60
"""Maximum number of table rows in a notebook."""


def json_text(document: Any, *, indent: int | None = 2) -> str:
    """Return JSON text; NaN and infinities become null, and control characters are escaped."""
    text = json.dumps(plain(document), indent=indent, allow_nan=False, ensure_ascii=False)
    return "".join(each if each.isprintable() or each == "\n" else json.dumps(each)[1:-1] for each in text)


def csv_text(table: Table, delimiter: str = ",") -> str:
    """Return a table as CSV text; numbers keep all their digits."""
    kept = io.StringIO()
    csv.writer(kept, delimiter=delimiter, lineterminator="\n").writerows(table.csv_rows())
    return legible(kept.getvalue(), LINES)


def write_table(table: Table, path: str | os.PathLike[str]) -> Path:
    """Write a table to a CSV or Parquet file, by its ending."""
    target = Path(path)
    ending = target.suffix.lower()
    if ending not in TABLES:
        raise FileError(str(target), None, f"the name must end in {' or '.join(TABLES)}")
    if ending in (".csv", ".tsv"):
        return write_text(target, csv_text(table, "\t" if ending == ".tsv" else ","))
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        raise FileError(str(target), None, 'a Parquet file needs pyarrow: pip install "clubface[tables]"') from None
    columns = {each.key: [each.exact(row) for row in range(len(table))] for each in table.file_columns}
    with whole_file(target) as file:
        pyarrow.parquet.write_table(pyarrow.table(columns), file)
    return target


def write_json(result: Result, path: str | os.PathLike[str]) -> Path:
    """Write a result to a JSON file."""
    return write_text(path, json_text(result.to_dict()) + "\n")


def write_report(
    result: Result, path: str | os.PathLike[str], *, units: Mapping[str, str] | None = None, command: str = ""
) -> Path:
    """Write a result as one file, HTML or Markdown by its ending; ``command`` is the command that computes it again."""
    return write_document(list(report_blocks(result, units=units, command=command)), path)


def report_blocks(result: Result, *, units: Mapping[str, str] | None = None, command: str = "") -> Iterator[Block]:
    """Yield the blocks of the report on a result.

    If some of its parts belong in the appendix, its provenance stands there too.
    """
    yield from _result_blocks(result, units, 1)
    origin = [*provenance_blocks(result.provenance), *_repeat_blocks(result.provenance, command)]
    details = [block for each in _appendices(result) for block in _result_blocks(each, units, 2)]
    if not details:
        yield from origin
        return
    inside = [each._replace(level=each.level + 1) if isinstance(each, Heading) else each for each in details + origin]
    yield Appendix("Technical details", inside)


def _appendices(result: Result) -> Iterator[Result]:
    """Yield the parts of a result, at any depth, that belong in the appendix."""
    for each in result.parts:
        if each.placement == "appendix":
            yield each
        else:
            yield from _appendices(each)


def _result_blocks(result: Result, units: Mapping[str, str] | None, level: int) -> Iterator[Block]:
    """Yield the blocks of a result and of its parts; the headings of parts are one level deeper."""
    yield Heading(level, result.title)
    if result.assumptions:
        yield Paragraph(tuple(each.sentence for each in result.assumptions))
    if result.lead:  # the advice, then a list of its reasons
        first, *others = (each.sentence for each in result.lead)
        yield Paragraph((first,))
        if others:
            yield Bullets(others)
    if result.summary:
        yield Paragraph(tuple(each.sentence for each in result.summary))
    yield from picture_blocks(result, units)
    if level == 1 and (result.tables or result.values or result.notes):
        yield Heading(2, "All figures")
    yield from table_blocks(result, units, "" if level == 1 else f"{result.title} ")
    above = {each.sentence for each in result.summary}
    if notes := [each.sentence for each in result.notes if each.sentence not in above]:
        yield Bullets(list(dict.fromkeys(notes)))
    for each in result.parts:
        if each.placement == "appendix":
            continue
        if each.placement == "page":
            yield PageBreak()
        yield from _result_blocks(each, units, level + 1)


def picture_blocks(result: Result, units: Mapping[str, str] | None = None) -> Iterator[Block]:
    """Yield the pictures of a result, each with the numbers behind it."""
    pictures = result.pictures()
    if not pictures:
        return
    from clubface.present.drawing import draw, draw_narrow, picture_data
    from clubface.present.style import svg

    for each in pictures:
        headings, rows = picture_data(each)
        data = Data(each.name, headings, rows)

        def narrow(picture: Picture = each) -> str:
            return svg(draw_narrow(picture, units))

        yield DocumentPicture(each.caption, svg(draw(each, units)), data, narrow)


def table_blocks(result: Result, units: Mapping[str, str] | None = None, prefix: str = "") -> Iterator[Block]:
    """Yield the values and tables of a result as shown to people, each with its numbers as CSV.

    The names of the CSV files begin with the ``prefix``.
    """
    if result.values:
        table = Table(f"{result.kind}-values", result.values)
        rows = values_of(result.values, units) or values_of(
            [replace(each, printed=True) for each in result.values], units
        )
        yield TextTable(("quantity", "value", "unit"), rows, _data(table, prefix))
    for each in result.tables:
        if not len(each):
            continue
        if each.title:
            yield Heading(3, each.title)
        if each.layout == "list":
            rows = values_of(each.columns, units)
            yield TextTable(("quantity", "value", "unit"), rows, _data(each, prefix))
            continue
        heads, cells = headings_and_rows(each, units)
        yield TextTable([f"{words} ({unit})" if unit else words for words, unit in heads], cells, _data(each, prefix))


def provenance_blocks(provenance: Provenance) -> Iterator[Block]:
    """Yield inputs, versions, sources and caveats."""
    yield Heading(2, "How this was computed")
    if provenance.inputs:
        rows = list(provenance.inputs.items())
        yield TextTable(("input", "value"), rows, Data("inputs", ("input", "value"), rows))
    yield Paragraph(tuple(_computation_sentences(provenance)))
    named = " ".join([*provenance.sources, *provenance.inputs.values()])
    if sources := [*provenance.sources, *(work for short, work in WORKS.items() if re.search(short, named))]:
        yield Heading(3, "Sources")
        yield Bullets(sources)
    if provenance.caveats:
        yield Heading(3, "What to keep in mind")
        yield Bullets(provenance.caveats)


def _computation_sentences(provenance: Provenance) -> Iterator[str]:
    for each in provenance.computations:
        head = f"{each.club}, left-handed," if each.hand == "left" else each.club
        yield (f"Club {head} and ball {each.ball}, by the model {each.model} with the parameters {each.parameters}.")
    versions = [f"{'Python' if name == 'python' else name} {version}" for name, version in provenance.versions.items()]
    yield f"Computed by {', '.join(versions[:-1])} and {versions[-1]}."


def _repeat_blocks(provenance: Provenance, command: str) -> Iterator[Block]:
    """Yield the end of a report: the command, the files it read, and their texts."""
    if not (command or provenance.files or provenance.descriptions):
        return
    yield Heading(2, "To compute it again")
    if command:
        yield Listing("The command", command)
    if provenance.files:
        yield Paragraph(("It reads these files.",))
        yield TextTable(
            ("file", "bytes", "SHA-256"), [(each.name, str(each.bytes), each.sha256) for each in provenance.files]
        )
    texts = {**provenance.descriptions, **{each.name: each.text for each in provenance.files if each.text is not None}}
    for name, content in texts.items():
        yield Listing(name, content)


def _data(table: Table, prefix: str = "") -> Data:
    rows: Sequence[Sequence[Any]] = list(table.csv_rows())
    return Data(file_name(prefix + table.name), rows[0], rows[1:])


def write_folder(
    result: Result,
    folder: str | os.PathLike[str],
    *,
    units: Mapping[str, str] | None = None,
    command: str = "",
    pages: Sequence[str] = (".md",),
    tables: Mapping[str, Table] | None = None,
) -> list[Path]:
    """Write a result to a folder, creating it if needed; return the files.

    The page (Markdown), JSON and the main table (CSV) are named after the kind of the result, the other tables and the
    pictures (PNG and SVG) after themselves. ``units`` are display units by quantity, ``command`` computes the result
    again, ``pages`` are the file extensions of its pages, of which HTML contains the pictures, and ``tables`` are
    additional tables or replacements by file name.
    """
    from clubface.present.drawing import draw
    from clubface.present.style import save

    target = prepared_folder(folder)
    files = []
    for ending in pages:
        shown = result if ending == ".html" else result.replace(draw=None)
        files.append(write_report(shown, target / f"{result.kind}{ending}", units=units, command=command))
    main, *others = result.tables
    named = {f"{result.kind}.csv": main} | {f"{each.name.replace('_', '-')}.csv": each for each in others}
    files += [write_table(each, target / name) for name, each in (named | dict(tables or {})).items()]
    files.append(write_json(result, target / f"{result.kind}.json"))
    for each in result.pictures():
        figure = draw(each, units)
        files += [save(figure, target / f"{each.name}{ending}") for ending in (".png", ".svg")]
    return files


def as_fragment(result: Result) -> str:
    """Return a result as HTML for a notebook."""
    parts = [f"<p>{html.escape(each.sentence)}</p>" for each in result.assumptions]
    parts.append(f"<strong>{html.escape(result.title)}</strong>")
    if rows := values_of(result.values):
        parts.append(_table(["", "", ""], [list(each) for each in rows]))
    for each in result.tables:
        if not each.printed or not len(each):
            continue
        if each.title and each.title != result.title:
            parts.append(f"<p>{html.escape(each.title)}</p>")
        if each.layout == "list":
            parts.append(_table(["", "", ""], [list(row) for row in values_of(each.columns)]))
            continue
        heads, rows = headings_and_rows(each)
        parts.append(_table([f"{words} ({unit})" if unit else words for words, unit in heads], rows))
    sentences = dict.fromkeys(each.sentence for each in (*result.summary, *result.notes))
    if sentences:
        parts.append("<ul>" + "".join(f"<li>{html.escape(each)}</li>" for each in sentences) + "</ul>")
    return "\n".join([*parts, *map(as_fragment, result.parts)])


def _table(heads: list[str], rows: list[list[str]]) -> str:
    def line(cells: list[str], tag: str) -> str:
        return f"<tr>{''.join(f'<{tag}>{html.escape(each)}</{tag}>' for each in cells)}</tr>"

    body = "".join(line(each, "td") for each in rows[:MOST_ROWS])
    more = len(rows) - MOST_ROWS
    rest = f"<tr><td colspan={len(heads)}>and {more} more rows</td></tr>" if more > 0 else ""
    return f"<table><thead>{line(heads, 'th')}</thead><tbody>{body}{rest}</tbody></table>"
