"""``clubface map``: launch and flight over the face of a club, or what another club changes there."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from clubface.cli import option_values, options, output, reporting
from clubface.cli.failures import say_written
from clubface.cli.map_document import columns, document
from clubface.cli.map_tables import DEFAULT, print_map
from clubface.cli.progress import progress_bar
from clubface.cli.quantity_units import VALUES, Units, shown_units
from clubface.errors import ClubfaceError, InputError
from clubface.support.checks import check_names
from clubface.units import fixed, from_si

app = typer.Typer(add_completion=False)

STRUCK = 0.02
"""How far beside the centre a strike is that a report tells of [m]."""


@app.command()
@options.takes(options.DELIVERY, options.EQUIPMENT, options.ONE_MODEL, options.AIR, options.GROUND)
def map_(
    club: options.ClubArgument,
    minus: Annotated[
        str | None, options.option("--minus", metavar="CLUB", text="Map the first club less this one.")
    ] = None,
    quantity: Annotated[
        list[str] | None,
        options.option(
            "--quantity", metavar="NAME", text="A quantity, such as carry. Several with commas or repeated."
        ),
    ] = None,
    grid: Annotated[
        str | None, options.option("--grid", metavar="101x101", text="Points towards the toe and upwards.")
    ] = None,
    spread: Annotated[
        str | None,
        options.option(
            "--spread",
            metavar='"12 mm x 9 mm"',
            text="Standard deviations of impacts towards the toe and upwards, about --toe and --high: what they cost.",
        ),
    ] = None,
    workers: Annotated[
        int | None, options.option("--workers", metavar="N", text="With fem: points at a time; all cores unless given.")
    ] = None,
    unit: Units = None,
    target: Annotated[str | None, options.output("FILE", "Write the map, a row a point, CSV or Parquet.")] = None,
    plot: Annotated[str | None, options.picture("contours on the face")] = None,
    report: options.Report = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Map ball speed, launch, spin and carry over the face, with its sweet spot and what bad strikes cost."""
    inputs = [club, minus, texts["ball"], texts["parameters"]]
    if as_json and unit and plot is None and report is None:
        raise ClubfaceError("--unit is for tables and pictures; JSON names its units: leave out --unit or --json")
    output.check_target("--output", target, (".csv", ".tsv", ".parquet"), inputs)
    output.check_picture(plot, inputs)
    output.check_report(report, inputs)
    delivery = option_values.delivery(texts)
    about = {name: delivery.pop(name) for name in ("toe", "high") if name in delivery}
    deviations = None if spread is None else _spread(spread)
    if about and deviations is None:
        raise ClubfaceError("--toe and --high say about which point impacts scatter; give --spread too")
    shown = shown_units(unit)
    names = _quantities(quantity)
    listed = {*(names or DEFAULT), "ball_speed", "carry"}  # of the last two the best points are told
    if hidden := [name for name in option_values.pairs(unit or (), "--unit") if name not in listed]:
        raise InputError("--unit", hidden[0], "a quantity that is listed; name it with --quantity")
    counts = None if grid is None else _grid(grid)
    conditions = option_values.conditions(texts)
    heads = [
        option_values.club_of(each, texts["hand"], texts.get("model")) for each in (club, minus) if each is not None
    ]
    if len(heads) == 2 and heads[0] == heads[1]:
        raise InputError("--minus", minus, "another club than the first")
    sets = [option_values.one_set(head, texts) for head in heads]

    from clubface.design.face_map.difference import FaceMapDifference
    from clubface.design.face_map.face_map import map_face
    from clubface.design.face_map.shots import finished

    maps = []
    for place, (head, chosen) in enumerate(zip(heads, sets, strict=True)):
        kept = target if place == 0 or target is None else _second(target)
        with progress_bar("points") as update:
            maps.append(
                map_face(
                    head, delivery, model=chosen.model, parameters=chosen, ball=texts["ball"],
                    accuracy=texts["accuracy"], grid=counts if not maps else None,
                    points=None if not maps else (maps[0].toe, maps[0].high), output=kept, workers=workers,
                    progress=update, **conditions,
                )
            )  # fmt: skip
    spreads = [] if deviations is None else [each.forgiveness(deviations, **about) for each in maps]
    found = maps[0] if len(maps) == 1 else FaceMapDifference(*maps)
    if plot is not None or report is not None:
        from clubface import plots
        from clubface.design.face_map.figures import face_map_figure

        figure = face_map_figure(found, units={name: shown[name][0] for name in names or DEFAULT})
        if plot is not None:
            plots.save(figure, plot)
        if report is not None:
            told = " less ".join(each.centre.club.name for each in maps)
            reporting.write(
                report, title=f"Launch and flight over the face: {told}", words=_words(maps),
                picture=("Contours on the outline of the face", figure), columns=columns(found),
                show=lambda: print_map(found, maps, spreads, names, shown), launches=[each.centre for each in maps],
                given=_given(found, spread, about), conditions=conditions,
            )  # fmt: skip
    if target is not None:
        from clubface.tables.writer import write_columns

        write_columns(columns(found), Path(target))
        for each, of in zip((target, _second(target)), maps, strict=False):
            if of.interpolated:  # else nothing was kept, and a folder of that name is of something else
                finished(each)
    if as_json:
        output.print_json(document(found, maps, spreads, names))
    else:
        print_map(found, maps, spreads, names, shown)
        if told := option_values.own_lofts([(each.centre.club, delivery) for each in maps]):
            output.print_paragraph(told)
    say_written([each for each in (target, plot, report) if each is not None])


def _given(found: Any, spread: str | None, about: Mapping[str, float]) -> dict[str, str]:
    """Return what else went into maps, in words."""
    told = {"points of the face": f"{len(found.toe)} towards the toe, {len(found.high)} upwards"}
    if spread is not None:
        told["impacts that scatter"] = spread
    return told | {f"about {name}": fixed(value, "mm", 1) for name, value in about.items()}


def _words(maps: Sequence[Any]) -> Iterator[str]:
    """Say what a strike beside the centre costs, in sentences."""
    for each in maps:
        middle = each.at(0.0, 0.0)
        yield (
            f"Struck at the centre of the face, {each.centre.club.name} sends the ball off at "
            f"{fixed(float(middle['ball_speed']), 'mph', 1)} and carries it {fixed(float(middle['carry']), 'yd', 0)}."
        )
        for toe, place in ((STRUCK, "towards the toe"), (-STRUCK, "towards the heel")):
            if not each.outline.holds(toe, 0.0):
                continue
            there = each.at(toe, 0.0)
            lost = from_si(float(middle["carry"] - there["carry"]), "yd")
            yield (
                f"Struck {fixed(STRUCK, 'mm', 0)} {place}, it carries "
                f"{reporting.more_or_less(-lost, 'yd', ('farther', 'less far'))} and lands "
                f"{reporting.more_or_less(from_si(float(there['side']), 'yd'), 'yd', ('right', 'left'))} of the line."
            )


def _second(target: str) -> str:
    """Return the name under which points of the second club are kept until the file is written."""
    path = Path(target)
    return str(path.with_name(f"{path.stem}.minus{path.suffix}"))


def _quantities(texts: Sequence[str] | None) -> list[str]:
    names = option_values.names(texts)
    if texts and not names:
        raise InputError("--quantity", ",".join(texts), f"a quantity, such as carry: one of {', '.join(VALUES)}")
    check_names("quantity", names, VALUES)
    return names


def _grid(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"\s*(\d{1,12})\s*[x×]\s*(\d{1,12})\s*", text)
    if found is None:
        raise InputError("--grid", text, "two whole numbers, as in 101x101")
    return int(found[1]), int(found[2])


def _spread(text: str) -> tuple[float, float]:
    parts = re.split(r"[x×,]", text)
    if len(parts) != 2 or not all(part.strip() for part in parts):
        raise InputError("--spread", text, 'two standard deviations, towards the toe and upwards, as in "12 mm x 9 mm"')
    across, up = (option_values.parsed("--spread", part, "length") for part in parts)
    return across, up
