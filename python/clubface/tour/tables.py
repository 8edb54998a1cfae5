"""The comparison with the tour averages as text: CSV, JSON, Markdown, and the rows of tables."""

from __future__ import annotations

import csv
import io
import json
from typing import Any

import numpy as np

from clubface import units
from clubface.equipment.balls import DEFAULT_BALL
from clubface.tour.averages import LOFT_MODEL, QUANTITIES, SOURCE, Tour

TITLES = {"ball_speed": "Ball speed", "launch": "Launch angle", "spin": "Spin", "carry": "Carry"}
DIGITS = {"ball_speed": 1, "launch": 1, "spin": 0, "carry": 1}
MEAN = "mean |error|"
FITTED = "fitted"
FLIGHT_ONLY = "flight only"
"""The carry from the published launch: the share of the flight model in the errors of carry."""


def notes(result: Tour) -> list[str]:
    """Return what a reader of the comparison must know."""
    published = [club for club, given in zip(result.clubs, result.loft_is_published, strict=True) if given]
    caveats: dict[str, list[str]] = {}
    for name, launches in result.launches.items():
        for caveat in dict.fromkeys(text for launch in launches for text in launch.parameters.caveats):
            caveats.setdefault(caveat, []).append(name)
    balls = dict.fromkeys(launch.ball.name for launches in result.launches.values() for launch in launches)
    return [
        f"Published: {SOURCE}.",
        *([] if list(balls) == [DEFAULT_BALL] else [f"Ball: {', '.join(balls)}."]),
        f"Dynamic loft is published for {' and '.join(published)} only, in older tables. For every other club it is"
        f" solved from the published launch angle with the {LOFT_MODEL} model and used by every model, so that there"
        f" the launch angle of {LOFT_MODEL} is no prediction ('{FITTED}').",
        "Only driver and 7-iron are measured heads (not those of the tour); the other clubs are a plausible parametric"
        " set, and each uses the published parameters of driver or 7-iron.",
        "Impact at the face centre, path and face square. Carries of the models are flights of their own launches;"
        f" '{FLIGHT_ONLY}' is the flight from the published launch.",
        *(f"{', '.join(names)}: {text}." for text, names in caveats.items()),
    ]


def is_fitted(result: Tour, index: int, model_name: str, quantity: str) -> bool:
    """Tell whether a value is no prediction: the launch angle from which the loft of this club was solved."""
    return quantity == "launch" and model_name == LOFT_MODEL and not result.loft_is_published[index]


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
    published = result.published[quantity]
    rows = []
    for index, club in enumerate(result.clubs):
        given = units.from_si(published[index], unit)
        cells = {name: units.from_si(values[index], unit) for name, values in columns.items()}
        shown = [
            FITTED if signed and is_fitted(result, index, name, quantity)
            else _signed(cell - given, digits) if signed
            else f"{cell:.{digits}f}"
            for name, cell in cells.items()
        ]  # fmt: skip
        rows.append([club, f"{given:.{digits}f}", *shown])
    means = {name: units.from_si(float(np.abs(each - published).mean()), unit) for name, each in columns.items()}
    fitted = [name for name in columns if any(is_fitted(result, i, name, quantity) for i in range(len(result.clubs)))]
    rows.append([MEAN, "", *(FITTED if name in fitted else f"{mean:.{digits}f}" for name, mean in means.items())])
    return ["club", "published", *columns], rows


def _signed(value: float, digits: int) -> str:
    text = f"{value:+.{digits}f}"
    return text if text.strip("+-0.") else text[1:]


def as_markdown(result: Tour) -> str:
    """Return the whole comparison as a Markdown page."""
    lines = ["# Every model beside the published tour averages", "", *(f"* {note}" for note in notes(result)), ""]
    lines += ["## Deliveries", ""]
    lofts = [
        [
            each.club,
            f"{units.from_si(each.club_speed, 'mph'):.0f}",
            f"{units.from_si(each.attack, 'deg'):.1f}",
            f"{units.from_si(loft, 'deg'):.2f}",
            "published" if given else f"solved with {LOFT_MODEL}",
        ]
        for each, loft, given in zip(result.averages, result.lofts, result.loft_is_published, strict=True)
    ]
    lines += _markdown_table(["club", "club speed (mph)", "attack (deg)", "dynamic loft (deg)", "loft is"], lofts)
    for quantity, unit in QUANTITIES.items():
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
    for index, each in enumerate(result.averages):
        for name in result.models:
            record: dict[str, Any] = {
                "club": each.club,
                "model": name,
                "club_speed_mph": units.from_si(each.club_speed, "mph"),
                "attack_deg": units.from_si(each.attack, "deg"),
                "loft_deg": units.from_si(result.lofts[index], "deg"),
                "loft_source": "published" if result.loft_is_published[index] else f"solved with {LOFT_MODEL}",
            }
            for quantity, unit in QUANTITIES.items():
                given = float(units.from_si(result.published[quantity][index], unit))
                computed = float(units.from_si(result.values[name][quantity][index], unit))
                record[f"published_{quantity}_{unit}"] = given
                record[f"{quantity}_{unit}"] = computed
                record[f"{quantity}_error_{unit}"] = computed - given
            record["carry_from_published_launch_yd"] = float(units.from_si(result.carry_of_published[index], "yd"))
            found.append({key: round(cell, 6) if isinstance(cell, float) else cell for key, cell in record.items()})
    return found


def as_csv(result: Tour) -> str:
    """Return :func:`records` as CSV."""
    rows = records(result)
    text = io.StringIO()
    writer = csv.DictWriter(text, fieldnames=list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def document(result: Tour) -> dict[str, Any]:
    """Return everything as one document for JSON."""
    return {
        "notes": notes(result),
        "mean_absolute_error": {
            name: {
                f"{quantity}_{QUANTITIES[quantity]}": round(float(units.from_si(mean, QUANTITIES[quantity])), 6)
                for quantity, mean in result.mean_absolute_error(name).items()
            }
            for name in result.models
        },
        "rows": records(result),
    }


def as_json(result: Tour) -> str:
    """Return :func:`document` as text."""
    return json.dumps(document(result), indent=2, allow_nan=False) + "\n"
