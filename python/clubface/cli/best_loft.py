"""``clubface best-loft``: the dynamic loft of the longest carry, beside the charts that fitters use."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output, reporting
from clubface.cli.failures import say_written
from clubface.cli.output import print_numbers, progress_bar
from clubface.errors import ClubfaceError
from clubface.support.checks import check_choice
from clubface.units import from_si, size

if TYPE_CHECKING:
    from clubface.design.best_loft import Beside, BestLoft


app = typer.Typer(add_completion=False)

SHOWN = {
    "loft": ("deg", 1), "ball_speed": ("mph", 1), "launch": ("deg", 1), "spin": ("rpm", 0), "carry": ("yd", 1),
}  # fmt: skip
CHARTS = {"trackman": ("dynamic_loft", "launch", "spin", "carry"), "ping": ("launch", "spin")}
"""The published charts, and the columns that are shown beside what is found."""
WHOSE = {"trackman": "TrackMan", "ping": "PING"}


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
    plot: Annotated[
        str | None, options.picture("best lofts and carries, or those found over those of the chart")
    ] = None,
    report: options.Report = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Find the dynamic loft of the longest carry; by club speed, or beside a published chart."""
    from clubface.design import best_loft as job

    output.check_picture(plot, (club,))
    output.check_report(report, (club,))
    head = options.club_of(club, texts["hand"], texts.get("model"))
    conditions = options.conditions(texts)
    hit = {
        "club": head, "model": texts["model"], "parameters": options.one_set(head, texts), "ball": texts["ball"],
        "accuracy": texts["accuracy"], **conditions,
    }  # fmt: skip
    if chart is not None:
        check_choice("--chart", chart, CHARTS)
        if speed is not None or attack is not None:
            raise ClubfaceError("--chart has its own speeds and attack angles; leave out --speed and --attack")
        beside_chart = job.beside_trackman if chart == "trackman" else job.beside_ping
        with progress_bar("shots") as update:
            beside = beside_chart(**hit, progress=update)
        show, document = _of_chart(beside, chart, head.name, texts["model"])
        _write(plot, report, beside.found, beside, chart, head, hit, conditions, show)
        _finish(show, document, as_json, [plot, report])
        return
    if speed is None:
        raise ClubfaceError('--speed is missing; give it, as in --speed "100 mph", or a chart, as in --chart trackman')
    attack = ["-5 deg,0 deg,5 deg"] if attack is None else attack
    speeds = [options.parsed("--speed", text, "speed") for text in options.names(speed) or [""]]
    attacks = [options.parsed("--attack", text, "angle") for text in options.names(attack) or [""]]
    import numpy as np

    each, other = (values.reshape(-1) for values in np.meshgrid(speeds, attacks, indexing="ij"))
    with progress_bar("shots") as update:
        found = job.best_loft(each, other, **hit, progress=update)

    def show() -> None:
        rows = [_cells(found, place) for place in range(len(found.loft))]
        print_numbers(_heads(), rows, title=f"Best dynamic loft for carry: {head.name}, {texts['model']}")
        output.print_notes(["for 1 yd: with so much less or more loft a yard of carry is lost"])

    _write(plot, report, found, None, "", head, hit, conditions, show)
    document = {"club": head.name, "model": texts["model"], "rows": _rows_of(found)}
    _finish(show, document, as_json, [plot, report])


def _finish(show: Callable[[], None], document: Mapping[str, Any], as_json: bool, files: list[str | None]) -> None:
    if as_json:
        output.print_json(document)
    else:
        show()
    say_written([each for each in files if each is not None])


def _write(
    plot: str | None,
    report: str | None,
    found: BestLoft,
    beside: Beside | None,
    chart: str,
    head: Any,
    hit: Mapping[str, Any],
    conditions: Mapping[str, Any],
    show: Callable[[], None],
) -> None:
    """Draw and report what was found, ``beside`` a chart if there is one."""
    if plot is None and report is None:
        return
    from clubface import plots
    from clubface.design.pictures import best_loft_figure, chart_figure

    if beside is None:
        shows, figure = "Best loft and its carry over the club speed", best_loft_figure(found)
    else:
        shown = {own: (name, own, SHOWN[own][0]) for name, own in _shown(chart).items()}
        shows, figure = (
            f"What was found here over what the chart of {WHOSE[chart]} has",
            chart_figure(beside, shown, WHOSE[chart]),
        )
    if plot is not None:
        plots.save(figure, plot)
    if report is None:
        return
    from clubface import published_data
    from clubface.design.best_loft import CHARTS as TABLES
    from clubface.simulation.impact import impact

    launch = impact(
        head, {"speed": found.speed, "attack": found.attack, "loft": found.loft}, model=hit["model"],
        parameters=hit["parameters"], ball=hit["ball"], accuracy=hit["accuracy"],
    )  # fmt: skip
    sources = [] if beside is None else [f"Chart of {WHOSE[chart]}: {published_data.table(TABLES[chart]).source}"]
    reporting.write(
        report, title=f"The loft that carries the ball farthest: {head.name}", words=_words(found, beside, chart),
        picture=(shows, figure), columns=_columns(found, beside, chart), show=show, launches=[launch], given={},
        conditions=conditions, sources=sources,
    )  # fmt: skip


def _words(found: BestLoft, beside: Beside | None, chart: str) -> Iterator[str]:
    """Say which loft is best and how much it matters, in sentences."""
    level = abs(found.attack) == abs(found.attack).min()
    for speed in sorted({float(found.speed[level].min()), float(found.speed[level].max())}):
        place = int((level & (found.speed == speed)).argmax())
        attack = from_si(found.attack[place], "deg")
        less, more = (from_si(each, "deg") for each in found.within[place])
        way = "level" if abs(attack) < 0.05 else f"{abs(attack):.1f} degrees {'up' if attack > 0 else 'down'}wards"
        yield (
            f"With a club that moves {way} at {from_si(speed, 'mph'):.0f} mph, the ball carries farthest with "
            f"{from_si(found.loft[place], 'deg'):.1f} degrees of loft at impact: "
            f"{from_si(found.carry[place], 'yd'):.0f} yd. Up to {less:.1f} degrees less or {more:.1f} more cost "
            "less than a yard."
        )
    yield "This is the loft that the face has when it meets the ball, not the one that is stamped on the club."
    if beside is not None:
        own = "loft" if chart == "trackman" else "launch"
        away = float(from_si(getattr(found, own) - beside.published[CHARTS[chart][0]], "deg").mean())
        told = reporting.more_or_less(away, "degrees", ("higher", "lower"))
        yield f"The best {own} here is {told} than in the chart of {WHOSE[chart]} on average."


def _columns(found: BestLoft, beside: Beside | None, chart: str) -> dict[str, list[float]]:
    told = {"speed": "mph", "attack": "deg", **{name: unit for name, (unit, _) in SHOWN.items()}, "total": "yd"}
    columns = {f"{name.replace('_', ' ')} ({unit})": getattr(found, name) for name, unit in told.items()}
    columns = {head: from_si(values, head.split("(")[1][:-1]) for head, values in columns.items()}
    for place, side in enumerate(("less", "more")):
        columns[f"a yard is lost with so much {side} (deg)"] = from_si(found.within[:, place], "deg")
    if beside is not None:
        for name, own in _shown(chart).items():
            unit = SHOWN[own][0]
            columns[f"{own} of the chart ({unit})"] = from_si(beside.published[name], unit)
    return {head: [float(each) for each in values] for head, values in columns.items()}


def _shown(chart: str) -> dict[str, str]:
    """Return what is found here by the columns of a chart beside which it is shown."""
    return {name: "loft" if name == "dynamic_loft" else name for name in CHARTS[chart]}


def _heads() -> list[str]:
    return [
        "speed\nmph",
        "attack\ndeg",
        *(f"{name.replace('_', ' ')}\n{unit}" for name, (unit, _) in SHOWN.items()),
        "for 1 yd\ndeg",
    ]


def _cells(of: BestLoft, place: int) -> list[str]:
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


def _of_chart(beside: Beside, chart: str, club: str, model: str) -> tuple[Callable[[], None], dict[str, Any]]:
    """Return what prints the lofts beside a chart, and the same as JSON has it."""
    found, published = beside.found, beside.published
    document = _rows_of(found)
    for place, row in enumerate(document):
        row["published"] = {name: float(values[place]) for name, values in published.items()}
    heads, rows = _heads()[:2], [_cells(found, place)[:2] for place in range(len(found.loft))]
    notes = []
    for name, own in _shown(chart).items():
        unit, digits = SHOWN[own]
        heads += [f"{own}\n{unit}", f"\n{chart}"]
        for place, row in enumerate(rows):
            row += [
                output.number(float(from_si(values[place], unit)), digits)
                for values in (getattr(found, own), published[name])
            ]
        away = (getattr(found, own) - published[name]) / size(unit)
        notes.append(
            f"{own} less published: {away.mean():+.{digits}f} {unit} on average, from {away.min():+.{digits}f}"
            f" to {away.max():+.{digits}f}"
        )

    def show() -> None:
        print_numbers(heads, rows, title=f"Best dynamic loft for carry beside the chart of {chart}: {club}, {model}")
        output.print_notes(notes)

    return show, {"club": club, "model": model, "chart": chart, "rows": document}
