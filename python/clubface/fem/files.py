"""Files of a run: figures as JSON, histories as CSV, and pictures."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from clubface.fem.result import FIGURES, Impact
from clubface.support.folders import prepared_folder
from clubface.support.plain_json import plain
from clubface.support.whole_file import whole_text, write_text


def document(found: Impact) -> dict[str, Any]:
    """Return figures and launch in the order of the table, and the inputs to which they belong, in SI units."""
    figures = {name: getattr(found, name) for name in FIGURES}
    ran = {"elements": found.elements, "stopped": found.stopped or "", "provenance": found.provenance}
    return {**found.outcome(), **found.flown(), **figures, **ran}


def write_run(found: Impact, folder: str | os.PathLike[str], *, animation: bool = False) -> list[Path]:
    """Write figures, histories and pictures of one impact, even of one that stopped early.

    Parameters
    ----------
    found
        The run.
    folder
        Made if it does not exist.
    animation
        Whether to write the moving section, which needs frames.

    Returns
    -------
    list
        The files.
    """
    path = prepared_folder(folder)
    figures = write_text(path / "figures.json", json.dumps(plain(document(found)), indent=2) + "\n")
    tables = [_columns(path / f"{name}.csv", getattr(found, name)) for name in ("contact", "motion", "energy")]
    if not len(found.patch["time"]):
        return [figures, *tables]
    from clubface import plots
    from clubface.fem.figures import impact as pictures, section as sections

    drawn = [plots.save(pictures.impact_figure(found), path / "impact.png")]
    drawn.append(plots.save(pictures.patch_figure(found), path / "patch.png"))
    if len(found.frames) > 1:
        drawn.append(plots.save(sections.section_figure(found), path / "section.png"))
        if animation:
            drawn.append(sections.animate(found, path / "impact.gif"))
    return [figures, *tables, *drawn]


def write_paper(runs: Mapping[str, Impact], folder: str | os.PathLike[str]) -> list[Path]:
    """Write the first run, figures 3 to 7 of Roh and Lee drawn from all, and the contact models beside the first.

    Parameters
    ----------
    runs
        Runs of their case by the method of contact.
    folder
        Made if it does not exist.
    """
    from clubface import plots
    from clubface.fem.figures import models, paper as pictures

    found = next(iter(runs.values()))
    written = write_run(found, folder)
    if not len(found.patch["time"]):
        return written
    path = prepared_folder(folder)
    drawn = {"paper": pictures.paper_figure(runs), "models": models.models_figure(found)}
    return [*written, *(plots.save(figure, path / f"{name}.png") for name, figure in drawn.items())]


def write_sweep(
    rows: Sequence[Mapping[str, Any]], folder: str | os.PathLike[str], *, published: bool = False
) -> list[Path]:
    """Draw a sweep as figure 8 of Roh and Lee, with or without their numbers."""
    from clubface import plots
    from clubface.fem.figures import paper as pictures

    return [plots.save(pictures.sweep_figure(rows, published=published), prepared_folder(folder) / "sweep.png")]


def draw_face(rows: Sequence[Mapping[str, Any]], path: Path) -> Path:
    """Draw what was measured over a face."""
    from clubface import plots
    from clubface.fem.figures.face import face_figure

    return plots.save(face_figure(rows), path)


def _columns(path: Path, arrays: Mapping[str, Any]) -> Path:
    """Write arrays over the same records as CSV, a vector as three columns; SI."""
    columns: dict[str, list[float]] = {}
    for name, values in arrays.items():
        if values.ndim == 1:
            columns[name] = values.tolist()
        else:
            for index, axis in enumerate(("normal", "up", "toe")):
                columns[f"{name}_{axis}"] = values[:, index].tolist()
    with whole_text(path) as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(zip(*columns.values(), strict=True))
    return path
