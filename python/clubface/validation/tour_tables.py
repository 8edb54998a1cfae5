"""The comparison with the tour averages as text: CSV, JSON, Markdown, and the rows of tables."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from clubface import units
from clubface.equipment.balls import DEFAULT_BALL
from clubface.equipment.models import DEFAULT_MODEL
from clubface.validation.tour import FLATTENED, QUANTITIES, RIGID, TABLES, Tour, mean_absolute_error

TITLES = {"ball_speed": "Ball speed", "launch": "Launch angle", "spin": "Spin", "carry": "Carry"}
DIGITS = {"ball_speed": 1, "launch": 1, "spin": 0, "carry": 1}
MEAN = "mean |error|"
FITTED = "fitted"
FLIGHT_ONLY = "flight only"
"""The carry from the published launch: the share of the flight model in the errors of carry."""
POSSIBLE = "possible"
"""The lofts that the published launch allows."""
LOFTS = "dynamic loft in degrees, published, possible with the published launch, and with which a model launches so"
RATIOS = "I w / (m R v_t) of the published launch from the delivered loft, and of the model's own launch"


def notes(result: Tour) -> list[str]:
    """Return what a reader of the comparison must know."""
    caveats: dict[str, list[str]] = {}
    for name, launches in result.launches.items():
        for caveat in dict.fromkeys(text for launch in launches for text in launch.parameters.caveats):
            caveats.setdefault(caveat, []).append(name)
    balls = dict.fromkeys(launch.ball.name for launches in result.launches.values() for launch in launches)
    return [
        f"Published: {result.table.title}. {result.table.source}.",
        *([f"In doubt: {result.table.caveat}"] if result.table.caveat else []),
        *([f"Left out, as there is no head for it: {', '.join(result.left_out)}."] if result.left_out else []),
        *([] if list(balls) == [DEFAULT_BALL] else [f"Ball: {', '.join(balls)}."]),
        _notes_on_lofts(result),
        f"I w / (m R v_t) is {RIGID:.0f} for a ball that stays round and {FLATTENED} to 0.95 for one that is flattened;"
        " over the face of first touch, which turns with its head, it is larger."
        f" '{POSSIBLE}' are the lofts with which the published launch has {RIGID:.0f} to {FLATTENED}. With a loft"
        " further outside than the head turns, half a degree for woods and one for irons, its figures cannot belong to"
        " one shot.",
        "Only driver and 7-iron are measured heads (not those of the tour); the other clubs are a plausible parametric"
        " set. Models with published parameters use those of driver or 7-iron for them.",
        "Impact at the face centre, path and face square. Carries of the models are flights of their own launches;"
        f" '{FLIGHT_ONLY}' is the flight from the published launch.",
        *(f"{', '.join(names)}: {text}." for text, names in caveats.items()),
    ]


def _notes_on_lofts(result: Tour) -> str:
    published = [club for club, given in zip(result.clubs, result.loft_is_published, strict=True) if given]
    solved = (
        "each model has the loft with which it launches the ball at the published angle, so that its launch angle is no"
        f" prediction there ('{FITTED}')."
    )
    if not published:
        older = " and ".join(name for name, group in TABLES.items() if group is not None)
        return f"No dynamic loft is published that belongs to these averages (only to {older}): {solved}"
    return f"Dynamic loft is published for {' and '.join(published)} only, and used by every model. Elsewhere {solved}"


def first_model(result: Tour) -> str:
    """Return the model whose answer is shown first: the default one, where it is among them."""
    return DEFAULT_MODEL if DEFAULT_MODEL in result.models else result.models[0]


def answer(result: Tour) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows of the first model: each quantity beside what is published, mean errors last."""
    name = first_model(result)
    heads, columns, means = ["club", "dynamic\nloft\ndeg"], [result.clubs], [MEAN, ""]
    columns.append([f"{loft:.1f}" for loft in units.from_si(result.lofts[name], "deg")])
    mean = result.mean_absolute_error(name)
    for quantity, unit in QUANTITIES.items():
        digits = DIGITS[quantity]
        for values in (result.values[name][quantity], result.published[quantity]):
            columns.append([f"{value:.{digits}f}" for value in units.from_si(values, unit)])
        heads += [f"{TITLES[quantity].lower().replace(' ', chr(10), 1)}\n{unit}", "as pub-\nlished"]
        means += [FITTED if np.isnan(mean[quantity]) else f"{units.from_si(mean[quantity], unit):.{digits}f}", ""]
    return heads, [*(list(row) for row in zip(*columns, strict=True)), means]


def comparison(result: Tour, quantity: str, *, signed: bool) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows of one quantity: club, published, then models; the last row is the mean absolute error.

    Parameters
    ----------
    quantity
        One of ``QUANTITIES``.
    signed
        Whether the cells of the models are errors, model less published, or values.
    """
    unit, digits = QUANTITIES[quantity], DIGITS[quantity]
    columns = {name: result.values[name][quantity] for name in result.models}
    if quantity == "carry":
        columns = {FLIGHT_ONLY: result.carry_of_published, **columns}
    published, fitted = result.published[quantity], result.is_fitted(quantity)
    rows = []
    for index, club in enumerate(result.clubs):
        given = units.from_si(published[index], unit)
        cells = [units.from_si(values[index], unit) for values in columns.values()]
        shown = [
            FITTED if signed and fitted[index] else _signed(cell - given, digits) if signed else f"{cell:.{digits}f}"
            for cell in cells
        ]
        rows.append([club, f"{given:.{digits}f}", *shown])
    errors = [units.from_si(np.abs(each - published)[~fitted], unit) for each in columns.values()]
    rows.append([MEAN, "", *(f"{each.mean():.{digits}f}" if each.size else FITTED for each in errors)])
    return ["club", "published", *columns], rows


def lofts(result: Tour) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows of the dynamic lofts [deg]: published, possible, and as each model needs them."""
    low, high = (units.from_si(each, "deg") for each in result.possible_lofts)
    rows = []
    for index, (club, given) in enumerate(zip(result.clubs, result.loft_is_published, strict=True)):
        published = f"{units.from_si(result.lofts[result.models[0]][index], 'deg'):.1f}" if given else ""
        solved = [f"{units.from_si(result.solved_lofts[name][index], 'deg'):.1f}" for name in result.models]
        rows.append([club, published, f"{low[index]:.1f}–{high[index]:.1f}", *solved])
    return ["club", "published", POSSIBLE, *result.models], rows


def ratios(result: Tour) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows of I w / (m R v_t) by model: of the published launch with its loft, and of its own."""
    pairs = [(result.published_ratios(name), result.own_ratios(name)) for name in result.models]
    rows = [
        [club, *(f"{published[index]:.2f}, {own[index]:.2f}" for published, own in pairs)]
        for index, club in enumerate(result.clubs)
    ]
    return ["club", *result.models], rows


def summary(results: Iterable[Tour]) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows of each model's mean absolute errors over all rows of several tables."""
    results = list(results)
    heads = [f"{TITLES[name].lower()} ({unit})" for name, unit in QUANTITIES.items()]
    rows = []
    for model in results[0].models:
        means = mean_absolute_error(results, model)
        values = {name: units.from_si(mean, QUANTITIES[name]) for name, mean in means.items()}
        rows.append(
            [model, *(FITTED if np.isnan(value) else f"{value:.{DIGITS[name]}f}" for name, value in values.items())]
        )
    return ["model", *heads], rows


def compared(result: Tour) -> dict[str, str]:
    """Return the quantities of which at least one club is a prediction, and their units."""
    return {name: unit for name, unit in QUANTITIES.items() if not result.is_fitted(name).all()}


def _signed(value: float, digits: int) -> str:
    text = f"{value:+.{digits}f}"
    return text if text.strip("+-0.") else text[1:]


def as_markdown(result: Tour) -> str:
    """Return the whole comparison as a Markdown page."""
    lines = [f"# Every model beside the {result.table.title}", "", *(f"* {note}" for note in notes(result)), ""]
    heads, rows = answer(result)
    lines += [f"## By {first_model(result)}, beside what is published", ""]
    lines += _markdown_table([each.replace("-\n", "").replace("\n", " ") for each in heads], rows)
    lines += ["## Deliveries", ""]
    delivered = [
        [
            each.club,
            f"{units.from_si(each.club_speed, 'mph'):.0f}",
            f"{units.from_si(each.attack, 'deg'):.1f}",
        ]
        for each in result.averages
    ]
    lines += _markdown_table(["club", "club speed (mph)", "attack (deg)"], delivered)
    for title, table in ((LOFTS, lofts(result)), (RATIOS, ratios(result))):
        lines += [f"## {title[0].upper()}{title[1:]}", "", *_markdown_table(*table)]
    for quantity, unit in compared(result).items():
        for signed, what in ((False, ""), (True, ", model less published")):
            heads, rows = comparison(result, quantity, signed=signed)
            lines += [f"## {TITLES[quantity]}{what} ({unit})", ""]
            lines += _markdown_table(heads, rows if signed else rows[:-1])
    return "\n".join(lines)


def _markdown_table(heads: list[str], rows: list[list[str]]) -> list[str]:
    def line(cells: list[str]) -> str:
        return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"

    rule = ["---", *(["---:"] * (len(heads) - 1))]
    return [line(heads), line(rule), *(line(row) for row in rows), ""]


def records(result: Tour) -> list[dict[str, Any]]:
    """Return one record a club and model: delivery, published values, the model's and its errors; units in the keys."""
    found = []
    possible = [units.from_si(each, "deg") for each in result.possible_lofts]
    ratios_of = {name: (result.published_ratios(name), result.own_ratios(name)) for name in result.models}
    for index, each in enumerate(result.averages):
        for name in result.models:
            published_ratio, own_ratio = ratios_of[name]
            record: dict[str, Any] = {
                "averages": result.table.name,
                "club": each.club,
                "model": name,
                "club_speed_mph": units.from_si(each.club_speed, "mph"),
                "attack_deg": units.from_si(each.attack, "deg"),
                "loft_deg": units.from_si(result.lofts[name][index], "deg"),
                "solved_loft_deg": units.from_si(result.solved_lofts[name][index], "deg"),
                "loft_source": "published" if result.loft_is_published[index] else f"solved with {name}",
                "possible_loft_least_deg": possible[0][index],
                "possible_loft_most_deg": possible[1][index],
                "published_spin_ratio": published_ratio[index],
                "spin_ratio": own_ratio[index],
            }
            for quantity, unit in QUANTITIES.items():
                given = float(units.from_si(result.published[quantity][index], unit))
                computed = float(units.from_si(result.values[name][quantity][index], unit))
                record[f"published_{quantity}_{unit}"] = given
                record[f"{quantity}_{unit}"] = computed
                record[f"{quantity}_error_{unit}"] = computed - given
            record["carry_from_published_launch_yd"] = units.from_si(result.carry_of_published[index], "yd")
            found.append({key: cell if isinstance(cell, str) else _rounded(cell) for key, cell in record.items()})
    return found


def _rounded(value: float) -> float | None:
    """Return a number to six decimals; JSON has none for NaN."""
    return None if np.isnan(value) else round(float(value), 6)


def as_csv(result: Tour) -> str:
    """Return :func:`records` as CSV."""
    return csv_text(records(result))


def csv_text(rows: Sequence[Mapping[str, Any]]) -> str:
    """Return rows with the same keys as CSV, the keys as its heading."""
    text = io.StringIO()
    writer = csv.DictWriter(text, fieldnames=list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def document(result: Tour) -> dict[str, Any]:
    """Return everything as one document for JSON; a quantity that no club predicts has no mean error."""
    return {
        "averages": result.table.name,
        "notes": notes(result),
        "mean_absolute_error": mean_errors([result]),
        "rows": records(result),
    }


def mean_errors(results: list[Tour]) -> dict[str, dict[str, float | None]]:
    """Return the mean absolute errors over several tables by model, units in the keys."""
    return {
        model: {
            f"{name}_{QUANTITIES[name]}": _rounded(units.from_si(mean, QUANTITIES[name]))
            for name, mean in mean_absolute_error(results, model).items()
        }
        for model in results[0].models
    }


def as_json(result: Tour) -> str:
    """Return :func:`document` as text."""
    return json.dumps(document(result), indent=2, allow_nan=False) + "\n"
