"""``clubface compare``: clubs, balls, models, parameters or deliveries side by side, and causes of the differences.

All combinations of the options given more than once are compared, and named by their differences.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from clubface.cli import options, show
from clubface.cli.failures import print_note
from clubface.cli.output import progress_bar
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import ClubfaceError, InputError
from clubface.support.checks import check_names, is_name


def alternatives_of(
    clubs: Sequence[str],
    changes: Sequence[str] | None,
    file: str | None,
    texts: Mapping[str, Any],
    units: Mapping[str, str] | None = None,
) -> dict[str, dict[str, Any]]:
    """Return every combination of the given alternatives, named by their differences.

    ``units`` are the units of columns of ``file`` without one.
    """
    from clubface.equipment.balls import ball

    heads = _by_name([(options.club_of(each, texts["hand"], texts.get("model")), each) for each in clubs], "CLUB")
    balls = _by_name([(ball(each), each) for each in texts["ball"] or [None]], "--ball")
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
    result = {}
    for names, fields in combined:
        words = [name for name, shown in zip(names, differ, strict=True) if shown]
        result[", ".join(words) or names[0]] = fields
    return result


def _by_name(pairs: Sequence[tuple[Any, Any]], option: str) -> dict[str, Any]:
    """Return objects by name; objects with the same name are named as typed."""
    names = [each.name for each, _ in pairs]
    result = {}
    for name, (each, typed) in zip(names, pairs, strict=True):
        key = name if names.count(name) == 1 else Path(str(typed)).stem
        key = str(typed) if key in result else key
        if key in result:
            raise InputError(option, typed, "given once: it is compared with itself")
        result[key] = each
    return result


def _sets(model: str, models: Sequence[str], head: Any, texts: Mapping[str, Any]) -> dict[str, Any]:
    """Return the parameter sets of a model to compare: the given ones for this model, or its default."""
    settings = texts["setting"] or []
    options.parameter_sets(
        models, head.parameters, texts["parameters"], settings
    )  # raises an error for a set that fits none of them
    usual = options.parameter_sets([model], head.parameters)[model]
    fitting = [each for each in settings if each.partition("=")[0].strip() in usual.values]
    chosen = []
    for name in texts["parameters"] or ():
        result = options.parameter_sets(models, head.parameters, name)[model]
        # A set for another of the models leaves this one with its default.
        if len(models) == 1 or result != usual:
            chosen.append((options.parameter_sets([model], head.parameters, name, fitting)[model], name))
    if not chosen:
        changed = options.parameter_sets([model], head.parameters, None, fitting)[model]
        return {"default parameters": changed if fitting else None}
    return _by_name(chosen, "--parameters")


def _deliveries(
    changes: Sequence[str] | None, file: str | None, units: Mapping[str, str], texts: Mapping[str, Any]
) -> dict[str, dict[str, float]]:
    from clubface.simulation.inputs import DIMENSIONS

    base = options.quantities(texts, DIMENSIONS, {})
    if changes and file is not None:
        raise ClubfaceError("--delivery and --deliveries exclude each other; give one of them")
    if file is not None:
        from clubface.design.comparison import MOST, read_deliveries

        words = read_deliveries(file, MOST, lambda text: print_note(f"note: {text}"), units=units)
        result = {name: {**base, **each} for name, each in words.items()}
    else:
        words, result = {}, {}
        for text in changes or [""]:
            pairs = options.pairs(text.split(",") if text else (), "--delivery")
            check_names("value of --delivery", pairs, DIMENSIONS)
            words[text] = {
                name: options.parsed(f"--{name.replace('_', '-')}", each, DIMENSIONS[name])
                for name, each in pairs.items()
            }
            swing = {**base, **words[text]}
            if swing in result.values():
                raise InputError("--delivery", text, "given once: it is compared with itself")
            result[text] = swing
    for name in base:
        if words and all(name in each for each in words.values()):
            what = f"every row of {file}" if file is not None else "every --delivery"
            raise ClubfaceError(f"--{name.replace('_', '-')} has no effect: {what} has its own; leave it out")
    if any("speed" not in each for each in result.values()):
        raise ClubfaceError('--speed is missing; give it with its unit, as in --speed "113 mph"')
    return result


def labelled(alternatives: Mapping[str, Any], labels: Sequence[str]) -> dict[str, Any]:
    """Return alternatives under names chosen by the user, in order."""
    if len(labels) != len(alternatives):
        named = "; ".join(alternatives)
        raise InputError("--label", ", ".join(labels), f"given {len(alternatives)} times, once for each of: {named}")
    for place, label in enumerate(labels):
        if not is_name(label):
            raise InputError("--label", label, "printable text, not empty")
        if label in labels[:place]:
            raise InputError("--label", label, "given once: every column needs a different name")
    return dict(zip(labels, alternatives.values(), strict=True))


app = typer.Typer(add_completion=False)

_REPEATABLE = "Repeatable: anything given more than once is compared."
COMPARED: options.Group = {
    "hand": options.EQUIPMENT["hand"],
    **options.group("Club and ball",
        ball=(options.Texts, None, "NAME|FILE", f"A ball; default modern. {_REPEATABLE}"),
    ),
    **options.MODELS,
    **options.group("Model",
        parameters=(options.Texts, None, "NAME|FILE", f"A published set or a TOML file. {_REPEATABLE}"),
    ),
    **options.group(None,
        delivery=(options.Texts, None, '"loft=12 deg, toe=8 mm"', f"Values of one delivery. {_REPEATABLE}"),
        deliveries=(str | None, None, "FILE", "CSV or Parquet file with one delivery per row."),
        label=(options.Texts, None, "NAME",
               "Your own name for a column. Give it once for each column, in order."),
        split=(bool, True, None, "Split the differences into contributions."),
        nodes=(int | None, None, "N", "Number of points at which derivatives are taken, 1 to 64."),
        unit=(options.Texts, None, "NAME=UNIT", "Unit of a quantity in tables, carry=m, or of columns of "
              "--deliveries without a unit, speed=mph. Repeatable."),
    ),
}  # fmt: skip


@app.command()
@options.takes(
    options.DELIVERY, COMPARED, options.AIR, options.GROUND,
    show.table_option("Write all figures to this CSV or Parquet file."),
    show.plot_option("flights and contributions"), show.REPORT, show.JSON,
)  # fmt: skip
def compare(
    clubs: Annotated[list[str], options.argument("CLUB...", "Built-in clubs, or TOML files.")], **texts: Any
) -> None:
    """Compare clubs, balls, models, parameters or deliveries, and show what makes the difference."""
    from clubface.design.comparison import MOST, compare as computed
    from clubface.design.contributions import QUANTITIES
    from clubface.present.report import write_table

    deliveries, unit, split, nodes = (texts[name] for name in ("deliveries", "unit", "split", "nodes"))
    file_units = options.pairs(unit or (), "--unit") if deliveries is not None else {}
    file_units = {name: symbol for name, symbol in file_units.items() if name not in QUANTITIES}
    shown_units = [each for each in unit or () if each.partition("=")[0].strip() not in file_units]
    inputs = [*clubs, *(texts["ball"] or ()), *(texts["parameters"] or ()), deliveries]
    output = show.Output.check({**texts, "unit": shown_units}, inputs)
    conditions = options.conditions(texts)
    alternatives = alternatives_of(clubs, texts["delivery"], deliveries, texts, file_units)
    if nodes is not None and not split:
        raise ClubfaceError("--nodes has no effect with --no-split; leave out one of them")
    if not 2 <= len(alternatives) <= MOST:
        allowed = "give two clubs, or another option twice, as in --ball modern --ball distance"
        raise ClubfaceError(
            f"there is nothing to compare: {allowed}" if len(alternatives) < 2
            else f"there are {len(alternatives)} combinations to compare; give at most {MOST}"
        )  # fmt: skip
    if texts["label"]:
        alternatives = labelled(alternatives, texts["label"])
    with progress_bar("points of derivatives") as update:
        compared = computed(alternatives, **conditions, split=split, nodes=nodes, progress=update)
    if output.target is not None:
        write_table(compared.all_figures(), output.target)
    output.show(compared.to_result(), write_table=False)
