"""The comparison with the tour averages in a folder: tables and pictures."""

from __future__ import annotations

from pathlib import Path

from clubface.support.folders import prepared_folder
from clubface.support.whole_file import write_text
from clubface.tour.tables import as_csv, as_json, as_markdown
from clubface.tour.tour import Tour


def write(result: Tour, folder: Path) -> list[Path]:
    """Write tables (CSV, Markdown, JSON) and pictures into ``folder``, which is made if need be; return the files."""
    from clubface.plots import style
    from clubface.tour import figures

    prepared_folder(folder)
    files = []
    for name, text in {
        "tour.csv": as_csv(result),
        "tour.md": as_markdown(result),
        "tour.json": as_json(result),
    }.items():
        files.append(write_text(folder / name, text))
    for name, draw in {"tour-launch": figures.launch_figure, "tour-errors": figures.error_figure}.items():
        figure = draw(result)
        files += [style.save(figure, folder / f"{name}{ending}") for ending in (".png", ".svg")]
    return files
