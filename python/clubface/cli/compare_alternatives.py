"""What ``clubface compare`` compares: every combination of what was given more than once, called by what differs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from clubface.cli import option_values
from clubface.cli.failures import say
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import ClubfaceError, InputError
from clubface.support.checks import check_names


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

    heads = _named(
        [(option_values.club_of(which, texts["hand"], texts.get("model")), which) for which in clubs], "CLUB"
    )
    balls = _named([(ball(which), which) for which in texts["ball"] or [None]], "--ball")
    models = option_values.model_names(texts["model"], DEFAULT_MODEL)
    option_values.check_accuracy(models, texts["accuracy"])
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
    option_values.parameter_sets(
        models, head.parameters, texts["parameters"], settings
    )  # refuses what fits none of them
    usual = option_values.parameter_sets([model], head.parameters)[model]
    fitting = [each for each in settings if each.partition("=")[0].strip() in usual.values]
    chosen = []
    for which in texts["parameters"] or ():
        found = option_values.parameter_sets(models, head.parameters, which)[model]
        # One that serves another of the models leaves this one with its own.
        if len(models) == 1 or found != usual:
            chosen.append((option_values.parameter_sets([model], head.parameters, which, fitting)[model], which))
    if not chosen:
        changed = option_values.parameter_sets([model], head.parameters, None, fitting)[model]
        return {"default parameters": changed if fitting else None}
    return _named(chosen, "--parameters")


def _deliveries(
    changes: Sequence[str] | None, file: str | None, units: Mapping[str, str], texts: Mapping[str, Any]
) -> dict[str, dict[str, float]]:
    from clubface.simulation.delivery import DIMENSIONS

    base = option_values.quantities(texts, DIMENSIONS, {})
    if changes and file is not None:
        raise ClubfaceError("--delivery and --deliveries both say what is compared; give one of them")
    if file is not None:
        from clubface.design.comparison.comparison import MOST
        from clubface.design.comparison.rows import read_deliveries

        told = read_deliveries(file, MOST, lambda text: say(f"note: {text}"), units=units)
        found = {name: {**base, **each} for name, each in told.items()}
    else:
        told, found = {}, {}
        for text in changes or [""]:
            pairs = option_values.pairs(text.split(",") if text else (), "--delivery")
            check_names("value of --delivery", pairs, DIMENSIONS)
            told[text] = {
                name: option_values.parsed(f"--{name.replace('_', '-')}", each, DIMENSIONS[name])
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
