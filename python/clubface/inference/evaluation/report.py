"""The report of an evaluation: Markdown, HTML in one file, JSON, CSV and pictures."""

from __future__ import annotations

import base64
import csv
import html
import io
import json
import math
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from clubface import units
from clubface.errors import FileError
from clubface.inference.evaluation import tables
from clubface.inference.evaluation.model_errors import ModelErrors
from clubface.inference.evaluation.tables import Table
from clubface.shots.measured import DELIVERY, LAUNCH, QUANTITIES
from clubface.support.checks import plain
from clubface.support.files import prepared_folder, write_text

PICTURES = {
    "errors": "Mean absolute error of every model with its 95% interval, as published (hollow), and what measurement"
    " alone explains (shaded).",
    "trends": "Error over the delivery: means of equal numbers of shots.",
    "agreement": "Model over measured; on the line they agree.",
}
"""The pictures of a report and what they show."""
TABLE = "evaluation.csv"
"""Every shot with what each model makes of it."""

_STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; max-width: 70em; margin: 2em auto; padding: 0 1em; color: #222; }
table { border-collapse: collapse; margin: .6em 0 1.6em; font-variant-numeric: tabular-nums; font-size: 13px; }
th { text-align: right; border-bottom: 1.5px solid #444; padding: .2em .7em; vertical-align: bottom; }
td { text-align: right; padding: .15em .7em; border-bottom: 1px solid #e4e4e4; }
th.words, td.words { text-align: left; } caption { text-align: left; font-weight: 600; padding: .3em 0; }
img { max-width: 100%; } figure { margin: 1em 0 2em; } figcaption, .note { color: #555; font-size: 13px; }
div.wide { overflow-x: auto; } td { white-space: nowrap; } td.words { white-space: normal; }
@page { margin: 18mm; }
@media print { div.wide { overflow: visible; } table { font-size: var(--print); } th, td { padding: .15em .4em; }
  td { white-space: normal; } }
"""
PRINTED, PAPER = 9.0, 480.0
"""Largest letters of a table in print, and the width of a sheet of A4 between its margins, with some to spare [pt]."""


class Section(NamedTuple):
    """A part of the report.

    Attributes
    ----------
    title
        Its heading.
    tables
        What it shows.
    picture
        A name of ``PICTURES``, or None.
    """

    title: str
    tables: list[Table]
    picture: str | None = None


def sections(of: ModelErrors) -> Iterator[Section]:
    """Yield the parts of the report."""
    yield Section("Errors", tables.in_published_form(of), "errors")
    if published := tables.published_form(of):
        yield Section("As published", published)
    yield Section("Best model", [tables.best_models(of)])
    yield Section("Every quantity", [tables.detail(of, name) for name in of.quantities], "agreement")
    yield Section("Noise", [tables.noise_floor(of)])
    with_trends = [name for name in of.quantities if any(of.trends[name].values())]
    if with_trends:
        yield Section("What the errors go with", [tables.trend_table(of, name) for name in with_trends], "trends")
    yield Section("Parameters", [tables.parameters_table(of)])


def title(of: ModelErrors) -> str:
    """Return the title of the report."""
    return f"Models beside {tables.counted(len(of.shots), 'measured shot')}: {of.shots.club.name}"


def as_markdown(of: ModelErrors, *, pictures: str | None = None) -> str:
    """Return the report as Markdown; ``pictures`` is the ending of the pictures beside it, such as ".png"."""
    lines = [f"# {title(of)}", "", f"Source: `{of.shots.source}`.", ""]
    lines += [*(f"* {note}" for note in tables.remarks(of)), ""] if tables.remarks(of) else []
    for section in sections(of):
        lines += [f"## {section.title}", ""]
        if section.picture and pictures:
            lines += [f"![{PICTURES[section.picture]}]({section.picture}{pictures})", "", PICTURES[section.picture], ""]
        for table in section.tables:
            lines += [f"{table.title}:", "", *_markdown(table), ""]
    lines += ["## Notes", "", *(f"* {note}" for note in tables.notes(of)), ""]
    return "\n".join(lines)


def _markdown(table: Table) -> list[str]:
    def line(cells: list[str]) -> str:
        return "| " + " | ".join(cell.replace("|", "\\|").replace("*", "\\*") for cell in cells) + " |"

    rule = ["---" if place in table.words else "---:" for place in range(len(table.heads))]
    return [line(table.heads), line(rule), *(line(row) for row in table.rows)]


def as_html(of: ModelErrors, pictures: dict[str, bytes] | None = None) -> str:
    """Return the report as one HTML document; ``pictures`` holds PNG files by name, which become part of it."""
    body = [f"<h1>{html.escape(title(of))}</h1>", f"<p>Source: <code>{html.escape(of.shots.source)}</code>.</p>"]
    if tables.remarks(of):
        body.append(_html_notes(tables.remarks(of)))
    for section in sections(of):
        body.append(f"<h2>{html.escape(section.title)}</h2>")
        if section.picture in (pictures or {}):
            data = base64.b64encode((pictures or {})[section.picture]).decode()
            text = html.escape(PICTURES[section.picture])
            body.append(
                f'<figure><img alt="{text}" src="data:image/png;base64,{data}"><figcaption>{text}</figcaption></figure>'
            )
        body += [f'<div class="wide">{_html(table)}</div>' for table in section.tables]
    body += ["<h2>Notes</h2>", _html_notes(tables.notes(of))]
    head = f'<meta charset="utf-8"><title>{html.escape(title(of))}</title><style>{_STYLE}</style>'
    return f'<!doctype html>\n<html lang="en"><head>{head}</head>\n<body>\n' + "\n".join(body) + "\n</body></html>\n"


def _html_notes(notes: list[str]) -> str:
    return "<ul>" + "".join(f'<li class="note">{html.escape(note)}</li>' for note in notes) + "</ul>"


def _html(table: Table) -> str:
    def cells(tag: str, row: list[str]) -> str:
        kinds = [' class="words"' if place in table.words else "" for place in range(len(row))]
        parts = [f"<{tag}{kind}>{html.escape(cell)}</{tag}>" for kind, cell in zip(kinds, row, strict=True)]
        return "<tr>" + "".join(parts) + "</tr>"

    rows = "".join(cells("td", row) for row in table.rows)
    letters = 0.0
    for column in zip(table.heads, *table.rows, strict=True):
        # Cells stand in several lines if they must, as "1.33 (0.8%)", but no number is broken; the widest digits take
        # two thirds of their size.
        letters += 0.8 + 0.66 * min(24, max(len(word) for cell in column for word in cell.split() or [""]))
    size = min(PRINTED, PAPER / max(letters, 1.0))
    caption = f"<caption>{html.escape(table.title)}</caption>"
    return f'<table style="--print:{size:.1f}pt">{caption}{cells("th", table.heads)}{rows}</table>'


def document(of: ModelErrors) -> dict[str, Any]:
    """Return everything as one document for JSON, SI."""
    return {
        "source": of.shots.source,
        "club": of.shots.club.name,
        "shots": len(of.shots),
        "compared_at": LAUNCH if of.shots.start else DELIVERY,
        "loft_origins": [each._asdict() for each in of.shots.loft_origins],
        "left_out": [each._asdict() for each in (*of.shots.dropped, *of.failed)],
        "models": {
            name: {
                "parameters": {"name": each.name, "values": dict(each.values), "units": each.units},
                "cost": of.cost(name),
                "seconds_per_shot": of.seconds[name],
            }
            for name, each in of.parameters.items()
        },
        "units": {name: units.SI_UNITS[units.unit(QUANTITIES[name]).dimension] for name in of.quantities},
        "mean_measured": of.mean,
        "errors": {name: {m: size._asdict() for m, size in each.items()} for name, each in of.sizes.items()},
        "best": {
            name: {
                "model": each.model,
                "not_significantly_worse": list(each.equals),
                "rivals": [rival._asdict() for rival in each.rivals],
            }
            for name, each in of.best.items()
        },
        "trends": {
            name: {m: [line._asdict() for line in lines] for m, lines in each.items()}
            for name, each in of.trends.items()
        },
        "noise": {"monitor": of.monitor_noise, "delivery": of.delivery_noise, "perfect_model_mae": of.floor},
        "published": {
            name: {"source": each.source, "mae": dict(each.mae), "std": dict(each.std), "caveats": list(each.caveats)}
            for name, each in of.published.items()
        },
        "bootstrap": {"resamples": of.resamples, "seed": of.seed, "groups": of.groups},
        "notes": [*tables.remarks(of), *tables.notes(of)],
    }


def as_csv(of: ModelErrors) -> str:
    """Return one line a shot: its row in the source, what was measured, and what every model computes."""
    columns: dict[str, Any] = {"row": of.shots.rows}
    for name in of.quantities:
        unit = QUANTITIES[name]
        columns[f"{name}_{unit}"] = units.from_si(of.shots.launch[name], unit)
        for model in of.models:
            columns[f"{model}_{name}_{unit}"] = units.from_si(of.predicted[model][name], unit)
    text = io.StringIO()
    out = csv.writer(text, lineterminator="\n")
    out.writerow(columns)
    out.writerows([_cell(value) for value in row] for row in zip(*columns.values(), strict=True))
    return text.getvalue()


def _cell(value: Any) -> str:
    number = float(value)
    return "" if math.isnan(number) else f"{number:.9g}"


def refuse_input(folder: str | os.PathLike[str], source: str) -> None:
    """Refuse a folder in which the table of the report would overwrite the file of the shots."""
    table = Path(folder) / TABLE
    if table.exists() and os.path.exists(source) and table.samefile(source):
        raise FileError(source, None, "the report would overwrite this file; give another folder")


def write(of: ModelErrors, folder: str | os.PathLike[str]) -> list[Path]:
    """Write the report and its pictures into ``folder``, which is made if need be; return the files.

    Raises
    ------
    FileError
        One of the files is that of the shots.
    """
    from clubface import plots
    from clubface.inference.evaluation import picture as draw

    target = Path(folder)
    refuse_input(target, of.shots.source)
    prepared_folder(target)
    files, pictures = [], {}
    figures = {"errors": draw.error_figure, "trends": draw.trend_figure, "agreement": draw.agreement_figure}
    for name, figure_of in figures.items():
        figure = figure_of(of)
        files += [plots.save(figure, target / f"{name}{ending}") for ending in (".png", ".svg")]
        pictures[name] = (target / f"{name}.png").read_bytes()
    texts = {
        "evaluation.md": as_markdown(of, pictures=".png"),
        "evaluation.html": as_html(of, pictures),
        "evaluation.json": json.dumps(plain(document(of)), indent=2, allow_nan=False) + "\n",
        TABLE: as_csv(of),
    }
    for name, text in texts.items():
        files.append(write_text(target / name, text))
    return files
