"""Tables of flights and runs compared with published ones, computed when the pages are built."""

from __future__ import annotations

import numpy as np
from core_tables import CoreTable, markdown_table
from sphinx.application import Sphinx

import clubface
from clubface import published_data, units
from clubface.simulation.flight import Flight

SETS = {
    "pga-2023": "PGA Tour 2023, fitted", "lpga-2023": "LPGA Tour 2023, fitted",
    "flights-computed-trackman": "computed by a TrackMan, fitted", "pga-2019": "PGA Tour 2019",
    "lpga-2019": "LPGA Tour 2019", "flights-computed-garmin-r50": "computed by a Garmin R50",
    "optimum-trackman-2010": "TrackMan's chart of 2010", "flights-tracked-trackman": "seen to their end outdoors",
}  # fmt: skip
"""Published tables of launches with their flights, and what they are called."""
QUANTITIES = {"carry": "yd", "apex": "yd", "landing_angle": "deg"}
"""What is compared, with its unit."""


def flown(name: str, **conditions: str) -> Flight:
    """Return the flights of the launches of a published table."""
    table = published_data.table(name).columns
    launch = {"ball_speed": table["ball_speed"], "launch": table["launch"], "backspin": table["spin"], "sidespin": 0.0}
    return clubface.fly(launch, **conditions)


def signed(value: float) -> str:
    """Return a difference with its sign, but for one that rounds to 0.0."""
    text = f"{value:+.1f}"
    return text[1:] if float(text) == 0 else text


def deviation(flight: Flight, name: str, quantity: str) -> np.ndarray | None:
    """Return what was computed less what is published, or None where it is not published."""
    table = published_data.table(name).columns
    if quantity not in table:
        return None
    unit = QUANTITIES[quantity]
    return flight.get(quantity, unit) - units.from_si(table[quantity], unit)


class FlightSets(CoreTable):
    """``{flight-sets}``: mean and root mean square deviations over every published set."""

    def table(self) -> list[str]:
        """One row a set."""
        rows = []
        for name, words in SETS.items():
            flight, cells = flown(name), []
            for quantity in QUANTITIES:
                missed = deviation(flight, name, quantity)
                cells.append("" if missed is None else f"{signed(missed.mean())} ({np.sqrt((missed**2).mean()):.1f})")
            rows.append([words, *cells])
        return markdown_table(["launches", "carry, yd", "height, yd", "descent, °"], rows)


class FlightClubs(CoreTable):
    """``{flight-clubs} pga-2023``: published carry, height and descent, and what is computed less that."""

    required_arguments = 1

    def table(self) -> list[str]:
        """One row a club."""
        name = self.arguments[0]
        flight, table = flown(name), published_data.table(name)
        rows = []
        for index, club in enumerate(table["club"]):
            cells = []
            for quantity, unit in QUANTITIES.items():
                missed = deviation(flight, name, quantity)
                assert missed is not None
                cells.append(f"{table.get(quantity, unit)[index]:.0f} ({signed(missed[index])})")
            rows.append([club.replace("-", " "), *cells])
        return markdown_table(["club", "carry, yd", "height, yd", "descent, °"], rows)


class Runs(CoreTable):
    """``{published-runs}``: published runs, and those on a soft, an average and a firm fairway."""

    def table(self) -> list[str]:
        """One row a drive or a set."""
        chart = published_data.table("optimum-trackman-2010")["optimum_of"]
        computed = published_data.table("flights-computed-trackman")["landing_angle"]
        low = computed < np.radians(25.0)
        cases = [
            ("PGA Tour, average drive", "pga-2023", slice(0, 1), "22 (2007), 15 (2017), 25 (2023)"),
            ("LPGA Tour, average drive", "lpga-2023", slice(0, 1), "37 (2021)"),
            ("TrackMan's chart of 2010, longest carry", "optimum-trackman-2010", chart == "carry", None),
            ("TrackMan's chart of 2010, longest total", "optimum-trackman-2010", chart == "total", None),
            ("computed by a TrackMan, down at 25° or more", "flights-computed-trackman", ~low, None),
            ("computed by a TrackMan, down at less", "flights-computed-trackman", low, None),
            ("low drive, total", "low-drive", slice(0, 1), "244"),
        ]
        rows = []
        for words, name, chosen, published in cases:
            table, cells = published_data.table(name), []
            for firmness in ("soft fairway", "fairway", "firm fairway"):
                flight = flown(name, ground=firmness)
                carry = 0.0 if "total" in words.split(", ")[-1:] else flight.get("carry", "yd")
                cells.append(f"{np.mean((flight.get('total', 'yd') - carry)[chosen]):.0f}")
            if published is None:
                published = f"{np.mean((table.get('total', 'yd') - table.get('carry', 'yd'))[chosen]):.0f}"
            rows.append([words, published, *cells])
        return markdown_table(["run, yd", "published", "soft", "fairway", "firm"], rows)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("flight-sets", FlightSets)
    app.add_directive("flight-clubs", FlightClubs)
    app.add_directive("published-runs", Runs)
    return {"parallel_read_safe": True}
