"""A result in a folder: a page, JSON, the tables and the pictures, each as a file."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from clubface.present.files import write_json, write_table
from clubface.present.report import write_report
from clubface.results.result import Result
from clubface.support.files import prepared_folder

__all__ = ["write_folder"]


def write_folder(
    result: Result, folder: str | os.PathLike[str], *, units: Mapping[str, str] | None = None, command: str = ""
) -> list[Path]:
    """Write a result into a folder, which is made if need be; return the files.

    The page (Markdown), JSON and the main table (CSV) are called as the kind of the result, the other tables and the
    pictures (PNG and SVG) by their names.

    Parameters
    ----------
    units
        Units for people, by quantity.
    command
        What computes the result again.
    """
    from clubface.plots import save
    from clubface.present.drawing import draw

    target = prepared_folder(folder)
    page = write_report(result.replace(draw=None), target / f"{result.kind}.md", units=units, command=command)
    files = [write_table(result.table(), target / f"{result.kind}.csv")]
    files += [write_table(each, target / f"{each.name.replace('_', '-')}.csv") for each in result.tables[1:]]
    files += [page, write_json(result, target / f"{result.kind}.json")]
    for each in result.pictures():
        figure = draw(each, units)
        files += [save(figure, target / f"{each.name}{ending}") for ending in (".png", ".svg")]
    return files
