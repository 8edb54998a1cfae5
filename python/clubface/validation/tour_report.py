"""The comparison with the tour averages in a folder: tables and pictures."""

from __future__ import annotations

from pathlib import Path

from clubface.support.files import prepared_folder, write_text
from clubface.validation.tour import Tour
from clubface.validation.tour_tables import as_csv, as_json, as_markdown


def write(result: Tour, folder: Path) -> list[Path]:
    """Write tables (CSV, Markdown, JSON) and pictures into ``folder``, which is made if need be; return the files."""
    from clubface import plots
    from clubface.validation import pictures

    prepared_folder(folder)
    files = []
    for name, text in {
        "tour.csv": as_csv(result),
        "tour.md": as_markdown(result),
        "tour.json": as_json(result),
    }.items():
        files.append(write_text(folder / name, text))
    for name, draw in {"tour-launch": pictures.launch_figure, "tour-errors": pictures.error_figure}.items():
        figure = draw(result)
        files += [plots.save(figure, folder / f"{name}{ending}") for ending in (".png", ".svg")]
    return files
