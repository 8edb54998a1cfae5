"""The comparison with the tour averages in a folder: tables and pictures."""

from __future__ import annotations

from pathlib import Path

from clubface.tour.averages import Tour
from clubface.tour.tables import as_csv, as_json, as_markdown


def write(result: Tour, folder: Path) -> list[Path]:
    """Write tables (CSV, Markdown, JSON) and pictures into ``folder``, which is made if need be; return the files."""
    from clubface.plots import style
    from clubface.tour import figures

    folder.mkdir(parents=True, exist_ok=True)
    files = []
    for name, text in {
        "tour.csv": as_csv(result),
        "tour.md": as_markdown(result),
        "tour.json": as_json(result),
    }.items():
        (folder / name).write_text(text, encoding="utf-8")
        files.append(folder / name)
    for name, draw in {"tour-launch": figures.launch_figure, "tour-errors": figures.error_figure}.items():
        figure = draw(result)
        files += [style.save(figure, folder / f"{name}{ending}") for ending in (".png", ".svg")]
    return files
