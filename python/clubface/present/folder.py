"""Writes a result to a folder: a page, JSON, the tables and the pictures, each as a file."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path

from clubface.present.files import write_json, write_table
from clubface.present.report import write_report
from clubface.results.result import Result
from clubface.results.table import Table
from clubface.support.files import prepared_folder

__all__ = ["write_folder"]


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

    The page (Markdown), JSON and the main table (CSV) are called as the kind of the result, the other tables and the
    pictures (PNG and SVG) by their names.

    Parameters
    ----------
    units
        Units for people, by quantity.
    command
        What computes the result again.
    pages
        Endings of its pages; one in HTML has the pictures inside.
    tables
        Further tables by the name of their file, or what stands there in place of a table of the result.
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
