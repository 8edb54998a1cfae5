"""How sure the numbers of a shot are: the comparisons of the package with published figures, by model and kind of club.

They are those of ``clubface validate``, computed here with the ball ``modern``, the published errors of models on
measured shots, and the flight from published launches.
"""

from __future__ import annotations

import json
import math
import warnings
from collections import defaultdict
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from clubface import _core, published_data
from clubface.equipment.clubs import Club, club
from clubface.errors import RangeWarning
from clubface.inference.evaluation.published_accuracy import published
from clubface.published_data import PublishedTable
from clubface.simulation.flight import fly
from clubface.validation.check import CERTAINTIES, Check, Figure, reading
from clubface.validation.run import CHECKS, CheckSummary, summary, validate
from clubface.validation.tour import TABLES

KINDS = ("driver", "wood", "iron")
"""Kinds of clubs of which there are published figures of their own."""
LARGEST_DRIVER_LOFT = math.radians(13.0)

OUTPUTS = {
    "ball speed": ("ball_speed", "smash"),
    "ball speed, share": ("ball_speed", "smash"),
    "spin": ("total_spin", "backspin"),
    "change of spin": ("total_spin", "backspin"),
    "share of launch angle (PING)": ("launch",),
    "share of launch angle (TrackMan)": ("launch",),
    "change of launch angle": ("launch",),
    "rise of launch angle": ("launch",),
    "share of start direction (PING)": ("azimuth",),
    "curve": ("curve", "side"),
    "offline": ("side",),
    "spin axis": ("spin_axis", "sidespin"),
    "contact time": ("contact_time",),
    "attack angle steeper by": ("club_velocity_y",),
}
"""The outputs of the core that a quantity of a check bears on."""
OPTIMA = ("longest-drives", "longest-drives-ping")
"""Checks of the launch with which a drive is longest, which say nothing of the launch of a shot."""
DRIVES = ("tour-driver", "amateur-drives", "drives-at-launch")
WOODS = ("tour-woods",)
FLOWN = ("carry", "apex", "landing_angle", "landing_speed", "flight_time")
FLIGHTS = (
    ("Averages of the tours: the flight from the launch alone", tuple(TABLES)),
    ("Flights that a TrackMan saw to their end, in unknown wind: the flight from the launch alone",
     ("flights-tracked-trackman",)),
)  # fmt: skip
"""Published launches with the flights that followed, measured or averages of measured ones: titles and tables."""


def kind_of(each: Club) -> str:
    """Return the kind of a club, one of ``KINDS``."""
    if each.kind == "iron":
        return "iron"
    return "driver" if each.kind == "wood" and each.loft < LARGEST_DRIVER_LOFT else "wood"


def kind_of_figure(check: Check, figure: Figure) -> str:
    """Return the kind of club of a published figure."""
    if check.name in DRIVES:
        return "driver"
    if check.name in WOODS:
        return "wood"
    return "driver" if "driver" in figure.case else "iron"


def rounded(value: float) -> float | None:
    """Return a value to five digits, and None for none."""
    return None if math.isnan(value) else float(f"{value:.5g}")


def row(
    title: str, quantity: str, reads_as: str, certainty: str, sources: Iterable[str], errors: dict[str, Any]
) -> dict[str, Any]:
    """Return what a comparison comes to: errors [SI], the quantity as which they are read, and where they come from.

    An error that is read as ``share`` is one of the published value.
    """
    return {
        "title": title, "quantity": quantity, "reads_as": reads_as, "certainty": certainty,
        "sources": list(dict.fromkeys(sources)), **errors,
    }  # fmt: skip


def of_summary(each: CheckSummary) -> dict[str, Any]:
    """Return the errors of a quantity of a check."""
    return {
        "figures": each.figures, "within": each.within, "size": rounded(each.mean), "bias": rounded(each.bias),
        "worst": rounded(each.worst), "tolerance": rounded(each.tolerances[1]),
    }  # fmt: skip


Rows = dict[str, dict[str, list[dict[str, Any]]]]
"""Rows by kind of club and output."""


def checked(model: str, figures: dict[str, list[Figure]]) -> Rows:
    """Return what the checks say of a model."""
    rows: Rows = {kind: defaultdict(list) for kind in KINDS}
    for check in CHECKS:
        if check.name in OPTIMA:
            continue
        for kind in KINDS:
            own = [each for each in figures[check.name] if kind_of_figure(check, each) == kind]
            for each in summary(own):
                if not each.known:
                    continue
                sources = (table.source for table in check.tables)
                entry = row(
                    check.title, each.quantity, reading(each.unit).name, check.certainty, sources, of_summary(each)
                )
                for output in OUTPUTS.get(each.quantity, ()):
                    rows[kind][output].append(entry)
    for (name, club_name), accuracy in published().items():
        if name != model:
            continue
        for quantity, error in accuracy.mae.items():
            entry = row(
                "Measured shots of golfers, errors as published with the model", quantity.replace("_", " "),
                quantity, "fair", [accuracy.source],
                {"figures": accuracy.shots, "within": None, "size": rounded(error), "bias": None, "worst": None,
                 "tolerance": None},
            )  # fmt: skip
            rows[kind_of(club(club_name))][quantity].append(entry)
    return rows


def flown() -> Rows:
    """Return how far the flight from published launches comes from the published flights, of any model of impact."""
    rows: Rows = {kind: defaultdict(list) for kind in KINDS}
    for title, names in FLIGHTS:
        tables = [published_data.table(name) for name in names]
        for output in FLOWN:
            errors: dict[str, list[float]] = defaultdict(list)
            for table in tables:
                for kind, error in _flight_errors(table, output):
                    errors[kind].append(error)
            for kind, values in errors.items():
                words, sources = output.replace("_", " "), [table.source for table in tables]
                rows[kind][output].append(row(title, words, output, "fair", sources, _errors(values)))
    return rows


def _flight_errors(table: PublishedTable, output: str) -> Iterator[tuple[str, float]]:
    """Yield the kind of club of each published launch, and the error of the flight from it [SI]."""
    if output not in table.columns:
        return
    launch = {"ball_speed": table["ball_speed"], "launch": table["launch"], "backspin": table["spin"], "sidespin": 0.0}
    errors = np.asarray(fly(launch).get(output) - table[output])
    names = table["club"].tolist() if "club" in table.columns else ["driver"] * len(errors)
    for name, error in zip(names, errors.tolist(), strict=True):
        if math.isfinite(error):
            yield "iron" if name.endswith(("iron", "wedge")) else "driver" if name == "driver" else "wood", error


def _errors(errors: list[float]) -> dict[str, Any]:
    values = np.array(errors)
    worst = float(values[np.abs(values).argmax()])
    return {
        "figures": len(values), "within": None, "size": rounded(float(np.abs(values).mean())),
        "bias": rounded(float(values.mean())), "worst": rounded(worst), "tolerance": None,
    }  # fmt: skip


class Numbered(dict[Any, int]):
    """Values in the order of their first appearance, each with its place."""

    def place(self, value: Any) -> int:
        """Return the place of a value, a new one for a new value."""
        return self.setdefault(value, len(self))


def certainty_data() -> dict[str, Any]:
    """Return the comparisons by model, kind of club and output; each is listed once, and so is each source."""
    entries, sources = Numbered(), Numbered()

    def place(entry: dict[str, Any]) -> int:
        return entries.place(json.dumps({**entry, "sources": [sources.place(each) for each in entry["sources"]]}))

    def placed(rows: Rows) -> dict[str, dict[str, list[int]]]:
        return {kind: {name: [*map(place, each)] for name, each in outputs.items()} for kind, outputs in rows.items()}

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RangeWarning)
        models = [entry["name"] for entry in _core.models()]
        compared = validate(models)
        by_model = {model: placed(checked(model, compared.figures[model])) for model in models}
        flights = placed(flown())
    return {
        "certainties": CERTAINTIES, "models": by_model, "flights": flights,
        "rows": [json.loads(each) for each in entries], "sources": list(sources),
    }  # fmt: skip
