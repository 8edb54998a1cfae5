"""``clubface best-loft``: the dynamic loft of the longest carry, beside the charts that fitters use."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import given, options, output
from clubface.cli.progress import progress_bar
from clubface.cli.tables import print_numbers
from clubface.errors import ClubfaceError

if TYPE_CHECKING:
    from clubface.design.best_loft import Beside, BestLoft

app = typer.Typer(add_completion=False)

SHOWN = {
    "loft": ("deg", 1), "ball_speed": ("mph", 1), "launch": ("deg", 1), "spin": ("rpm", 0), "carry": ("yd", 1),
}  # fmt: skip
CHARTS = {"trackman": ("dynamic_loft", "launch", "spin", "carry"), "ping": ("launch", "spin")}
"""The published charts, and the columns that are shown beside what is found."""


@app.command("best-loft")
@options.takes(options.EQUIPMENT, options.ONE_MODEL, options.AIR)
def best_loft(
    club: Annotated[
        str, typer.Option("--club", metavar="CLUB", help="Name or TOML file; driver unless given.", show_default=False)
    ] = "driver",
    speed: Annotated[
        list[str] | None,
        options.option("--speed", metavar='"100 mph"', text="Club speed; several with commas or repeated."),
    ] = None,
    attack: Annotated[
        list[str] | None,
        options.option("--attack", metavar='"0 deg"', text="Attack angle; -5, 0 and 5 deg unless given."),
    ] = None,
    chart: Annotated[
        str | None,
        options.option("--chart", metavar="NAME", text="Take speeds and attack angles of a chart: trackman or ping."),
    ] = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Find the dynamic loft of the longest carry; by club speed, or beside a published chart."""
    from clubface.design import best_loft as job
    from clubface.support.checks import check_choice

    head = given.club_of(club, texts["hand"])
    hit = {
        "club": head, "model": texts["model"], "parameters": given.one_set(head, texts), "ball": texts["ball"],
        "accuracy": texts["accuracy"], **given.conditions(texts),
    }  # fmt: skip
    if chart is not None:
        check_choice("--chart", chart, CHARTS)
        if speed is not None or attack is not None:
            raise ClubfaceError("--chart has its own speeds and attack angles; leave out --speed and --attack")
        beside_chart = job.beside_trackman if chart == "trackman" else job.beside_ping
        with progress_bar("shots") as update:
            beside = beside_chart(**hit, progress=update)
        _tell_of_chart(beside, chart, head.name, texts["model"], as_json)
        return
    if speed is None:
        raise ClubfaceError('--speed is missing; give it, as in --speed "100 mph", or a chart, as in --chart trackman')
    attack = ["-5 deg,0 deg,5 deg"] if attack is None else attack
    speeds = [given.parsed("--speed", text, "speed") for text in given.names(speed) or [""]]
    attacks = [given.parsed("--attack", text, "angle") for text in given.names(attack) or [""]]
    import numpy as np

    each, other = (values.reshape(-1) for values in np.meshgrid(speeds, attacks, indexing="ij"))
    with progress_bar("shots") as update:
        found = job.best_loft(each, other, **hit, progress=update)
    if as_json:
        output.print_json({"club": head.name, "model": texts["model"], "rows": _rows_of(found)})
        return
    rows = [_cells(found, place) for place in range(len(found.loft))]
    print_numbers(_heads(), rows, title=f"Best dynamic loft for carry: {head.name}, {texts['model']}")
    output.print_notes(["a yard of carry is lost with so much less, and with so much more, loft"])


def _heads() -> list[str]:
    return [
        "speed\nmph",
        "attack\ndeg",
        *(f"{name.replace('_', ' ')}\n{unit}" for name, (unit, _) in SHOWN.items()),
        "a yard\ndeg",
    ]


def _cells(of: BestLoft, place: int) -> list[str]:
    from clubface.units import from_si

    cells = [
        output.number(float(from_si(of.speed[place], "mph"))),
        output.number(float(from_si(of.attack[place], "deg"))),
    ]
    cells += [
        output.number(float(from_si(getattr(of, name)[place], unit)), digits) for name, (unit, digits) in SHOWN.items()
    ]
    return [
        *cells,
        " ".join(f"{sign}{from_si(each, 'deg'):.1f}" for sign, each in zip("-+", of.within[place], strict=True)),
    ]


def _rows_of(of: BestLoft) -> list[dict[str, Any]]:
    names = ("speed", "attack", "loft", "ball_speed", "launch", "spin", "carry", "total")
    return [
        {**{name: float(getattr(of, name)[place]) for name in names}, "within": of.within[place].tolist()}
        for place in range(len(of.loft))
    ]


def _tell_of_chart(beside: Beside, chart: str, club: str, model: str, as_json: bool) -> None:
    from clubface.units import from_si, size

    found, published = beside.found, beside.published
    if as_json:
        rows = _rows_of(found)
        for place, row in enumerate(rows):
            row["published"] = {name: float(values[place]) for name, values in published.items()}
        output.print_json({"club": club, "model": model, "chart": chart, "rows": rows})
        return
    heads, rows = _heads()[:2], [_cells(found, place)[:2] for place in range(len(found.loft))]
    for name in CHARTS[chart]:
        own = "loft" if name == "dynamic_loft" else name
        unit, digits = SHOWN[own]
        heads += [f"{own}\n{unit}", f"\n{chart}"]
        for place, row in enumerate(rows):
            row += [
                output.number(float(from_si(values[place], unit)), digits)
                for values in (getattr(found, own), published[name])
            ]
    print_numbers(heads, rows, title=f"Best dynamic loft for carry beside the chart of {chart}: {club}, {model}")
    notes = []
    for name in CHARTS[chart]:
        own = "loft" if name == "dynamic_loft" else name
        unit, digits = SHOWN[own]
        away = (getattr(found, own) - published[name]) / size(unit)
        notes.append(
            f"{own} less published: {away.mean():+.{digits}f} {unit} on average, from {away.min():+.{digits}f}"
            f" to {away.max():+.{digits}f}"
        )
    output.print_notes(notes)
