"""``clubface compare``: clubs, balls, models, parameters or deliveries side by side, and what makes the difference.

What ``clubface compare`` compares: every combination of what was given more than once, called by what differs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from clubface import units
from clubface.cli import options, output, reporting
from clubface.cli.failures import say, say_written
from clubface.cli.output import KEYS, VALUES, Shown, label, print_numbers, progress_bar, shown_units
from clubface.equipment.models import DEFAULT_MODEL, model as model_named
from clubface.errors import ClubfaceError, InputError
from clubface.support.checks import check_names
from clubface.units import from_si


def alternatives_of(
    clubs: Sequence[str],
    changes: Sequence[str] | None,
    file: str | None,
    texts: Mapping[str, Any],
    units: Mapping[str, str] | None = None,
) -> dict[str, dict[str, Any]]:
    """Return every combination of what was given, called by what differs.

    ``units`` are those of columns of ``file`` that name none.
    """
    from clubface.equipment.balls import ball

    heads = _named([(options.club_of(which, texts["hand"], texts.get("model")), which) for which in clubs], "CLUB")
    balls = _named([(ball(which), which) for which in texts["ball"] or [None]], "--ball")
    models = options.model_names(texts["model"], DEFAULT_MODEL)
    options.check_accuracy(models, texts["accuracy"])
    swings = _deliveries(changes, file, units or {}, texts)
    combined = []
    for head_name, head in heads.items():
        for ball_name, made in balls.items():
            for model in models:
                for set_name, chosen in _sets(model, models, head, texts).items():
                    for swing_name, swing in swings.items():
                        names = (head_name, ball_name, model, set_name, swing_name)
                        fields = {"club": head, "ball": made, "model": model, "parameters": chosen, "delivery": swing,
                                  "accuracy": texts["accuracy"]}  # fmt: skip
                        combined.append((names, fields))
    differ = [len(set(column)) > 1 for column in zip(*(names for names, _ in combined), strict=True)]
    found = {}
    for names, fields in combined:
        told = [name for name, shown in zip(names, differ, strict=True) if shown]
        found[", ".join(told) or names[0]] = fields
    return found


def _named(pairs: Sequence[tuple[Any, Any]], option: str) -> dict[str, Any]:
    """Return things by their names; those of the same name are called as they were typed."""
    names = [each.name for each, _ in pairs]
    found = {}
    for name, (each, typed) in zip(names, pairs, strict=True):
        key = name if names.count(name) == 1 else Path(str(typed)).stem
        key = str(typed) if key in found else key
        if key in found:
            raise InputError(option, typed, "given once: it is compared with itself")
        found[key] = each
    return found


def _sets(model: str, models: Sequence[str], head: Any, texts: Mapping[str, Any]) -> dict[str, Any]:
    """Return the parameter sets of a model to compare: those given that fit it, or that by default."""
    settings = texts["setting"] or []
    options.parameter_sets(models, head.parameters, texts["parameters"], settings)  # refuses what fits none of them
    usual = options.parameter_sets([model], head.parameters)[model]
    fitting = [each for each in settings if each.partition("=")[0].strip() in usual.values]
    chosen = []
    for which in texts["parameters"] or ():
        found = options.parameter_sets(models, head.parameters, which)[model]
        # One that serves another of the models leaves this one with its own.
        if len(models) == 1 or found != usual:
            chosen.append((options.parameter_sets([model], head.parameters, which, fitting)[model], which))
    if not chosen:
        changed = options.parameter_sets([model], head.parameters, None, fitting)[model]
        return {"default parameters": changed if fitting else None}
    return _named(chosen, "--parameters")


def _deliveries(
    changes: Sequence[str] | None, file: str | None, units: Mapping[str, str], texts: Mapping[str, Any]
) -> dict[str, dict[str, float]]:
    from clubface.simulation.inputs import DIMENSIONS

    base = options.quantities(texts, DIMENSIONS, {})
    if changes and file is not None:
        raise ClubfaceError("--delivery and --deliveries both say what is compared; give one of them")
    if file is not None:
        from clubface.design.comparison import MOST, read_deliveries

        told = read_deliveries(file, MOST, lambda text: say(f"note: {text}"), units=units)
        found = {name: {**base, **each} for name, each in told.items()}
    else:
        told, found = {}, {}
        for text in changes or [""]:
            pairs = options.pairs(text.split(",") if text else (), "--delivery")
            check_names("value of --delivery", pairs, DIMENSIONS)
            told[text] = {
                name: options.parsed(f"--{name.replace('_', '-')}", each, DIMENSIONS[name])
                for name, each in pairs.items()
            }
            swing = {**base, **told[text]}
            if swing in found.values():
                raise InputError("--delivery", text, "given once: it is compared with itself")
            found[text] = swing
    for name in base:
        if told and all(name in each for each in told.values()):
            what = f"every row of {file}" if file is not None else "every --delivery"
            raise ClubfaceError(f"--{name.replace('_', '-')} has no effect: {what} has its own; leave it out")
    if any("speed" not in each for each in found.values()):
        raise ClubfaceError('--speed is missing; give it with its unit, as in --speed "113 mph"')
    return found


app = typer.Typer(add_completion=False)

SPLIT = ("ball_speed", "launch", "azimuth", "backspin", "sidespin", "carry", "side", "total")
"""What is split into contributions in the table; --json and --output have all."""
_SIDES = "Repeatable: what is given more than once is compared."
COMPARED: options.Group = {
    "hand": options.EQUIPMENT["hand"],
    "ball": (
        Annotated[
            list[str] | None,
            options.option(
                "--ball", panel="Club and ball", metavar="NAME|FILE", text=f"A ball; modern unless given. {_SIDES}"
            ),
        ],
        None,
    ),
    **options.MODELS,
    "parameters": (
        Annotated[
            list[str] | None,
            options.option(
                "--parameters", panel="Model", metavar="NAME|FILE", text=f"A published set or a TOML file. {_SIDES}"
            ),
        ],
        None,
    ),
}


@app.command()
@options.takes(options.DELIVERY, COMPARED, options.AIR, options.GROUND)
def compare(
    clubs: Annotated[list[str], typer.Argument(metavar="CLUB...", help="Built-in clubs, or TOML files.")],
    delivery: Annotated[
        list[str] | None,
        options.option("--delivery", metavar='"loft=12 deg, toe=8 mm"', text=f"What a delivery changes. {_SIDES}"),
    ] = None,
    deliveries: Annotated[
        str | None,
        options.option("--deliveries", metavar="FILE", text="CSV or Parquet file of deliveries, a row each."),
    ] = None,
    split: Annotated[bool, typer.Option("--split/--no-split", help="Tell what makes the differences.")] = True,
    nodes: Annotated[
        int | None, options.option("--nodes", metavar="N", text="Points at which derivatives are taken, 1 to 64.")
    ] = None,
    unit: Annotated[
        list[str] | None,
        options.option(
            "--unit",
            metavar="NAME=UNIT",
            text="Unit of a quantity for people, carry=m, or of columns of --deliveries that name none, speed=mph. "
            "Repeatable.",
        ),
    ] = None,
    target: Annotated[str | None, options.output("FILE", "Write all figures, CSV or Parquet by its ending.")] = None,
    plot: Annotated[str | None, options.picture("flights and contributions")] = None,
    report: options.Report = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Compare clubs, balls, models, parameters or deliveries, and tell what makes the difference."""
    if as_json and unit and deliveries is None and plot is None and report is None:
        raise ClubfaceError("--unit is for tables and pictures; JSON names its units: leave out --unit or --json")
    inputs = [*clubs, *(texts["ball"] or ()), *(texts["parameters"] or ()), deliveries]
    output.check_target("--output", target, (".csv", ".tsv", ".parquet"), inputs)
    output.check_picture(plot, inputs)
    output.check_report(report, inputs)
    conditions = options.conditions(texts)
    file_units = options.pairs(unit or (), "--unit") if deliveries is not None else {}
    file_units = {name: symbol for name, symbol in file_units.items() if name not in VALUES}
    shown = shown_units(each for each in unit or () if each.partition("=")[0].strip() not in file_units)

    from clubface.design.comparison import MOST, compare as computed

    alternatives = alternatives_of(clubs, delivery, deliveries, texts, file_units)
    if nodes is not None and not split:
        raise ClubfaceError("--nodes has no effect with --no-split; leave out one of them")
    if not 2 <= len(alternatives) <= MOST:
        allowed = "give two clubs, or something else twice, as in --ball modern --ball distance"
        raise ClubfaceError(
            f"there is nothing to compare: {allowed}" if len(alternatives) < 2
            else f"there are {len(alternatives)} combinations to compare; give at most {MOST}"
        )  # fmt: skip
    with progress_bar("points of derivatives") as update:
        found = computed(alternatives, **conditions, split=split, nodes=nodes, progress=update)
    if plot is not None or report is not None:
        from clubface import plots
        from clubface.design.pictures import comparison_figure

        figure = comparison_figure(found, **conditions, units={key: told for key, (told, _) in shown.items()})
        if plot is not None:
            plots.save(figure, plot)
        if report is not None:
            reporting.write(
                report, title=f"{' and '.join(found.names)} compared", words=_words(found),
                picture=("Flights, and what makes the differences", figure), columns=_columns(found),
                show=lambda: _print(found, shown), launches=found.launches.values(),
                given=_given(deliveries), conditions=conditions,
            )  # fmt: skip
    if target is not None:
        _write(found, target)
    if as_json:
        output.print_json(_document(found, alternatives))
    else:
        _print(found, shown)
        struck = [(found.launches[name].club, each["delivery"]) for name, each in alternatives.items()]
        if told := options.own_lofts(struck):
            print()
            output.print_paragraph(told)
    say_written([each for each in (target, plot, report) if each is not None])


def _given(deliveries: str | None) -> dict[str, str]:
    return {} if deliveries is None else {"deliveries": Path(deliveries).name}


def _words(found: Any) -> Iterator[str]:
    """Say what the differences are, and what makes most of that in carry, in sentences."""
    first = found.names[0]
    for name in found.names[1:]:
        carry, speed = found.difference(name, "carry", "yd"), found.difference(name, "ball_speed", "mph")
        spin = found.difference(name, "backspin", "rpm")
        faster = reporting.more_or_less(speed, "mph", ("faster", "slower"))
        more = reporting.more_or_less(spin, "rpm", ("more", "less"), 0)
        farther = reporting.more_or_less(carry, "yd", ("farther", "less far"))
        yield f"Beside {first}, with {name} the ball leaves {faster}, spins {more} and carries {farther}."
        if (made := found.contributions.get(name)) is None or made.left_out or not made.changes:
            continue
        parts = [(_by_name(part)["carry"], change.name) for change, part in zip(made.changes, made.si, strict=True)]
        most, which = max(parts, key=lambda part: abs(part[0]))
        if most:
            told = reporting.more_or_less(from_si(most, "yd"), "yd", ("of carry more", "of carry less"))
            yield f"What changes the carry most is {which.replace('_', ' ')}: {told}."


def _print(found: Any, shown: Shown) -> None:
    first, *others = found.names
    heads = ["", _head(first)]
    for name in others:
        heads += [_head(name), "difference"]
    rows = []
    for quantity, (unit, digits) in shown.items():
        row = [label(quantity, unit), output.number(found.value(first, quantity, unit), digits)]
        for name in others:
            row += [
                output.number(found.value(name, quantity, unit), digits),
                output.number(found.difference(name, quantity, unit), digits + 1),
            ]
        rows.append(row)
    print_numbers(heads, rows)
    for name in others:
        if name in found.contributions:
            print()
            _print_split(found, name, shown)


def _print_split(found: Any, name: str, shown: Shown) -> None:
    made = found.contributions[name]
    title = f"What makes {name} differ from {found.names[0]}"
    if made.left_out:
        output.print_notes([f"{title} cannot be told: {made.left_out}"])
        return
    if not made.changes:
        output.print_notes([f"{name} is like {found.names[0]} in everything that this shot depends on"])
        return
    heads = ["", "from", "to", *(f"{each.replace('_', chr(10))}\n{shown[each][0]}" for each in SPLIT)]

    def cells(part: Any) -> list[str]:
        by_name = _by_name(part)
        return [output.number(by_name[each] / units.size(shown[each][0]), shown[each][1] + 1) for each in SPLIT]

    rows = [[*told, *cells(part)] for told, part in _told(found.launches[name], made)]
    rows.append(["remainder", "", "", *cells(made.remainder)])
    total = [found.difference(name, each) for each in _by_name(made.remainder)]
    print_numbers(heads, [*rows, ["difference", "", "", *cells(total)]], title=title, summary=True)


def _told(launch: Any, made: Any) -> list[tuple[list[str], Any]]:
    """Return name and values of each change with its contribution; the coefficients of a fit are taken together."""
    from clubface.simulation.results import inputs
    from clubface.simulation.sensitivity import FEW, OF_THE_BALL

    parameters = {each.name: each.unit for each in model_named(launch.model).parameters}
    fitted = {name for name in parameters if len(parameters) > FEW and name not in OF_THE_BALL}
    rows, hidden = [], []
    for change, part in zip(made.changes, made.si, strict=True):
        if change.name in fitted:
            hidden.append(part)
        elif not change.derivative:
            rows.append(([change.name, "", ""], part))
        else:
            name = change.name
            si = inputs()[name].unit if name in inputs() else parameters[name]
            unit = units.display_unit(name, "m/s" if name == "speed" else si)
            unit = "mph" if name == "speed" else unit
            values = [f"{units.from_si(each, unit):.6g}".replace("inf", "flat") for each in (change.start, change.end)]
            rows.append(([label(name, unit), *values], part))
    if hidden:
        rows.append(([f"{output.counted(len(hidden), 'coefficient')} of {launch.model}", "", ""], sum(hidden)))
    return rows


def _head(name: str) -> str:
    import textwrap

    return "\n".join(textwrap.wrap(name, 18, break_long_words=False))


def _by_name(part: Any) -> dict[str, float]:
    """Return differences or contributions [SI] by quantity."""
    from clubface.design.contributions import QUANTITIES

    return dict(zip(QUANTITIES, map(float, part), strict=True))


def _cells(part: Any) -> dict[str, float]:
    """Return differences or contributions [SI] in the units of ``KEYS``."""
    by_name = _by_name(part)
    return {key: by_name[name] / units.size(unit) for key, (name, unit) in KEYS.items()}


def _document(found: Any, alternatives: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    first = found.names[0]
    told = []
    for name in found.names:
        launch = found.launches[name]
        entry: dict[str, Any] = {
            "name": name, "club": launch.club.name, "ball": launch.ball.name, "model": launch.model,
            "parameters": launch.parameters.name, "delivery": alternatives[name]["delivery"],
            **{key: found.value(name, *of) for key, of in KEYS.items()},
        }  # fmt: skip
        if name != first:
            entry["difference"] = {key: found.difference(name, *of) for key, of in KEYS.items()}
            if (made := found.contributions.get(name)) is not None:
                entry["contributions"] = [
                    {"change": change.name, "from": change.start, "to": change.end, "derivative": change.derivative,
                     **_cells(part)}
                    for change, part in zip(made.changes, made.si, strict=True)
                ]  # fmt: skip
                entry["remainder"] = _cells(made.remainder)
                entry["left_out"] = made.left_out
        told.append(entry)
    return {"compared_with": first, "alternatives": told}


def _write(found: Any, target: str) -> None:
    from clubface.shots.tables.writer import write_columns

    write_columns(_columns(found), Path(target))


def _columns(found: Any) -> dict[str, list[Any]]:
    """Return all figures as a long table, in the units of its headings."""
    rows = found.rows()
    columns: dict[str, list[Any]] = {key: [row[key] for row in rows] for key in ("alternative", "part", "change")}
    parts = [{key: row[name] / units.size(unit) for key, (name, unit) in KEYS.items()} for row in rows]
    columns |= {key: [part[key] for part in parts] for key in KEYS}
    return columns
