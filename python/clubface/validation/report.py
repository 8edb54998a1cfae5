"""A validation in a folder: tables and a picture."""

from __future__ import annotations

from pathlib import Path

from clubface.support.folders import prepared_folder
from clubface.support.whole_file import write_text
from clubface.validation.run import Validation
from clubface.validation.tables import as_csv, as_json, as_markdown


def write(result: Validation, folder: Path) -> list[Path]:
    """Write tables (CSV, Markdown, JSON) and a picture into ``folder``, which is made if need be; return the files."""
    from clubface.plots import style
    from clubface.validation.figures import validation_figure

    prepared_folder(folder)
    files = []
    for ending, text in {"csv": as_csv(result), "md": as_markdown(result), "json": as_json(result)}.items():
        files.append(write_text(folder / f"validation.{ending}", text))
    figure = validation_figure(result)
    return files + [style.save(figure, folder / f"validation{ending}") for ending in (".png", ".svg")]
