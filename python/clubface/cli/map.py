"""``clubface map``: launch and flight over the face of a club, or what another club changes there.

What ``clubface map`` found as JSON has it, and as a table of a file.

The tables that ``clubface map`` prints.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from clubface.cli import options, output, reporting
from clubface.cli.failures import say_written
from clubface.cli.output import KEYS, VALUES, Shown, Units, label, print_numbers, progress_bar, shown_units
from clubface.errors import ClubfaceError, InputError
from clubface.support.checks import check_names
from clubface.units import fixed, from_si, size


def document(found: Any, maps: Sequence[Any], spreads: Sequence[Any], names: Sequence[str]) -> dict[str, Any]:
    """Return maps, what scattered impacts cost on them, and the values of ``names`` over the grid, as JSON has them."""
    told = []
    for place, each in enumerate(maps):
        best, carry = each.best(), each.best("carry")
        entry = {
            "club": each.centre.club.name, "ball": each.centre.ball.name, "model": each.centre.model,
            "parameters": each.centre.parameters.name, "outline": each.outline.told, "interpolated": each.interpolated,
            "face_area_mm2": from_si(each.outline.area(), "mm2"), "area_98_mm2": from_si(each.area(), "mm2"),
            "sweet_spot": {"toe_mm": 1e3 * best.toe, "high_mm": 1e3 * best.high, "ball_speed_mps": best.value},
            "longest_carry": {"toe_mm": 1e3 * carry.toe, "high_mm": 1e3 * carry.high, "carry_m": carry.value},
        }  # fmt: skip
        if spreads:
            entry["spread"] = _spread_document(spreads[place])
        told.append(entry)
    whole: dict[str, Any] = {
        "clubs": told, "grid": [len(found.toe), len(found.high)],
        "toe_mm": (1e3 * found.toe).tolist(), "high_mm": (1e3 * found.high).tolist(),
    }  # fmt: skip
    kind = "map" if len(maps) == 1 else "difference"
    wanted = {key: of for key, of in KEYS.items() if of[0] in names}
    whole[kind] = {key: (found.get(name) / size(unit)).tolist() for key, (name, unit) in wanted.items()}
    return whole


def _spread_document(spread: Any) -> dict[str, Any]:
    def cells(part: Mapping[str, float]) -> dict[str, float]:
        return {key: part[name] / size(unit) for key, (name, unit) in KEYS.items()}

    return {
        "toe_mm": 1e3 * spread.toe, "high_mm": 1e3 * spread.high, "toe_deviation_mm": 1e3 * spread.toe_deviation,
        "high_deviation_mm": 1e3 * spread.high_deviation, "missed": spread.missed, "mean": cells(spread.mean),
        "deviation": cells(spread.deviation), "loss": cells(spread.loss),
    }  # fmt: skip


def columns(found: Any) -> dict[str, Any]:
    """Return the map as a long table, in the units of its headings."""
    table = found.columns()
    told = {f"{name}_mm": from_si(table[name], "mm") for name in ("toe", "high")}
    told |= {key: table[name] / size(unit) for key, (name, unit) in KEYS.items()}
    if hasattr(found, "second"):
        told = {key if key in ("toe_mm", "high_mm") else f"difference_{key}": each for key, each in told.items()}
    return told


DEFAULT = ("ball_speed", "launch", "backspin", "sidespin", "azimuth", "carry", "side", "total")
"""What is listed and drawn unless something else is asked for."""
LEAST_MISSED = 5e-5
"""Share of swings beside the face that is told."""
TABLE = (9, 7)
"""Points of a printed table towards the toe and upwards."""


def print_map(found: Any, maps: Sequence[Any], spreads: Sequence[Any], names: Sequence[str], shown: Shown) -> None:
    """Print a map, or the difference of two: extremes, values over the face, best points, and what scatter costs."""
    _print_extremes(found, maps, names or DEFAULT, shown)
    for name in names:
        _print_values(found, name, shown[name])
    print()
    for each in maps:
        _print_best(each, shown)
    if spreads:
        _print_spreads(maps, spreads, names or DEFAULT, shown)
    else:
        output.print_paragraph('Give --spread "12 mm x 9 mm" to learn what impacts that scatter so much cost.')
    notes = [f"{each.centre.club.name}: outline {each.outline.told}" for each in maps]
    if maps[0].interpolated:
        notes.append("between the points of the grid, values, best points and areas are interpolated")
    output.print_notes(notes)


def _print_extremes(found: Any, maps: Sequence[Any], names: Sequence[str], shown: Shown) -> None:
    import numpy as np

    first = maps[0]
    rows = []
    middles = [each.at(0.0, 0.0) for each in maps]
    for name in names:
        unit, digits = shown[name]
        values = found.get(name) / size(unit)
        middle = float(middles[0][name] - (middles[1][name] if len(maps) == 2 else 0.0)) / size(unit)
        digits += len(maps) - 1
        row = [label(name, unit), output.number(middle, digits)]
        for pick in (np.nanargmin, np.nanargmax):
            if not np.isfinite(values).any():
                row += ["", "", ""]
                continue
            up, across = np.unravel_index(pick(values), values.shape)
            row += [output.number(float(values[up, across]), digits), output.number(1e3 * found.toe[across], 0),
                    output.number(1e3 * found.high[up], 0)]  # fmt: skip
        rows.append(row)
    heads = ["", "at the\ncentre", "least", "toe\nmm", "high\nmm", "greatest", "toe\nmm", "high\nmm"]
    clubs = " less ".join(each.centre.club.name for each in maps)
    told = f"{clubs}, ball {first.centre.ball.name}, by {first.centre.model}"
    print_numbers(heads, rows, title=f"{told}: {len(first.toe)} by {len(first.high)} points of the face")


def _print_values(found: Any, name: str, of: tuple[str, int]) -> None:
    import numpy as np

    unit, digits = of
    across, up = (
        np.unique(np.round(np.linspace(0, len(each) - 1, min(count, len(each)))).astype(int))
        for each, count in zip((found.toe, found.high), TABLE, strict=True)
    )
    values = found.get(name) / size(unit)
    heads = ["high, mm", *(f"{1e3 * found.toe[place]:.0f} mm" for place in across)]
    rows = [
        [f"{1e3 * found.high[row]:.1f}", *(output.number(float(values[row, place]), digits) for place in across)]
        for row in up[::-1]
    ]
    print()
    print_numbers(heads, rows, title=f"{label(name, unit)}, over places towards the toe")


def _print_best(found: Any, shown: Shown) -> None:
    best, carry = found.best(), found.best("carry")
    area, whole = from_si(found.area(), "mm2"), from_si(found.outline.area(), "mm2")
    name = found.centre.club.name
    unit, digits = shown["ball_speed"]
    far, far_digits = shown["carry"]
    output.print_paragraph(
        f"{name}: the sweet spot lies {_place(best)}, with a ball speed of {fixed(best.value, unit, digits)}; within"
        f" 2 % of it are {area:.0f} of the {whole:.0f} mm2 of the face. The longest carry,"
        f" {fixed(carry.value, far, far_digits)}, comes from {_place(carry)}."
    )


def _place(best: Any) -> str:
    """Return a point of the face in words."""
    toe, high = (from_si(each, "mm") for each in (best.toe, best.high))
    sides = (f"{abs(toe):.1f} mm towards the {'toe' if toe > 0 else 'heel'}",
             f"{abs(high):.1f} mm {'above' if high > 0 else 'below'} the centre")  # fmt: skip
    return " and ".join(sides)


def _about(spread: Any) -> str:
    """Return the point about which impacts scatter in words."""
    if not (spread.toe or spread.high):
        return "the face centre"
    return ", ".join(f"{name} {fixed(each, 'mm', 1)}" for name, each in (("toe", spread.toe), ("high", spread.high)))


def _print_spreads(maps: Sequence[Any], spreads: Sequence[Any], names: Sequence[str], shown: Shown) -> None:
    first = spreads[0]
    deviations = " by ".join(fixed(each, "mm", 1) for each in (first.toe_deviation, first.high_deviation))
    heads = [""]
    for each in maps:
        heads += [f"{each.centre.club.name}\nmean", "standard\ndeviation", "lost by\nscatter"]
    rows = []
    for name in names:
        unit, digits = shown[name]
        row = [label(name, unit)]
        for each in spreads:
            row += [output.number(part[name] / size(unit), digits + more) for part, more in
                    ((each.mean, 0), (each.deviation, 1), (each.loss, 1))]  # fmt: skip
        rows.append(row)
    print()
    print_numbers(heads, rows, title=f"Impacts that scatter by {deviations} about {_about(first)}")
    for found, each in zip(maps, spreads, strict=True):
        if each.missed < LEAST_MISSED:
            continue
        output.print_paragraph(
            f"{found.centre.club.name}: {each.missed:.2%} of them miss the face and are not counted."
        )


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
    delivery = options.delivery(texts)
    about = {name: delivery.pop(name) for name in ("toe", "high") if name in delivery}
    deviations = None if spread is None else _spread(spread)
    if about and deviations is None:
        raise ClubfaceError("--toe and --high say about which point impacts scatter; give --spread too")
    shown = shown_units(unit)
    names = _quantities(quantity)
    listed = {*(names or DEFAULT), "ball_speed", "carry"}  # of the last two the best points are told
    if hidden := [name for name in options.pairs(unit or (), "--unit") if name not in listed]:
        raise InputError("--unit", hidden[0], "a quantity that is listed; name it with --quantity")
    counts = None if grid is None else _grid(grid)
    conditions = options.conditions(texts)
    heads = [options.club_of(each, texts["hand"], texts.get("model")) for each in (club, minus) if each is not None]
    if len(heads) == 2 and heads[0] == heads[1]:
        raise InputError("--minus", minus, "another club than the first")
    sets = [options.one_set(head, texts) for head in heads]

    from clubface.design.face_map import FaceMapDifference, map_face
    from clubface.design.face_surface import finished

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
        from clubface.design.pictures import face_map_figure

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
        from clubface.shots.tables.writer import write_columns

        write_columns(columns(found), Path(target))
        for each, of in zip((target, _second(target)), maps, strict=False):
            if of.interpolated:  # else nothing was kept, and a folder of that name is of something else
                finished(each)
    if as_json:
        output.print_json(document(found, maps, spreads, names))
    else:
        print_map(found, maps, spreads, names, shown)
        if told := options.own_lofts([(each.centre.club, delivery) for each in maps]):
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
    names = options.names(texts)
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
    across, up = (options.parsed("--spread", part, "length") for part in parts)
    return across, up
