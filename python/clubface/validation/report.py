"""A validation in a folder: tables and a picture."""

from __future__ import annotations

from pathlib import Path

from clubface.support.files import prepared_folder, write_text
from clubface.validation.run import Validation
from clubface.validation.tables import as_csv, as_json, as_markdown


def write(result: Validation, folder: Path) -> list[Path]:
    """Write tables (CSV, Markdown, JSON) and a picture into ``folder``, which is made if need be; return the files."""
    from clubface import plots
    from clubface.validation.pictures import validation_figure

    prepared_folder(folder)
    files = []
    for ending, text in {"csv": as_csv(result), "md": as_markdown(result), "json": as_json(result)}.items():
        files.append(write_text(folder / f"validation.{ending}", text))
    figure = validation_figure(result)
    return files + [plots.save(figure, folder / f"validation{ending}") for ending in (".png", ".svg")]
