"""Tables of what in the publications cannot be as printed, computed when the pages are built."""

from __future__ import annotations

import math

import numpy as np
from core_tables import NBSP, CoreTable, markdown_table
from sphinx.application import Sphinx

import clubface
from clubface import units
from clubface.equipment.balls import published_ball
from clubface.inference.evaluation import contradictions, published
from clubface.inference.evaluation.published_accuracy import wrong_percentages
from clubface.shots.measured import QUANTITIES
from clubface.support.arrays import Floats
from clubface.validation import benchmark_data
from clubface.validation.benchmark_data import HEADS, recipe

MEAN_DELIVERY = ("speed", "attack", "loft")


def mean_delivery(club: str) -> dict[str, float]:
    """Return speed, attack angle and loft of the benchmark's mean delivery, struck in the centre and square."""
    return {name: recipe(club).delivery[name].mean for name in MEAN_DELIVERY}


class Contradictions(CoreTable):
    """``{contradictions}``: pairs of published sets whose mean launches their published errors do not allow."""

    def table(self) -> list[str]:
        """One row a pair and quantity, the clearest first."""
        rows = []
        for each in contradictions():
            unit = QUANTITIES[each.quantity]
            digits = 0 if unit == "rpm" else 2
            apart, allowed = (units.from_si(value, unit) for value in (abs(each.difference), each.allowed))
            pair = (each.first, each.second) if each.difference > 0.0 else (each.second, each.first)
            what = f"{each.club}, {each.quantity.replace('_', ' ')}: `{pair[0]}` above `{pair[1]}`"
            figures = (f"{apart:.{digits}f}", f"{allowed:.{digits}f} {unit}", f"{apart / allowed:.2f}")
            rows.append([what, *(each.replace(" ", NBSP) for each in figures)])
        return markdown_table(["", "apart", "allowed", "ratio"], rows)


class WrongPercentages(CoreTable):
    """``{wrong-percentages}``: printed percentages that do not follow from the printed errors and means."""

    def table(self) -> list[str]:
        """One row a percentage."""
        rows = [
            [each.club, f"`{each.model}`", words] for each in published().values() for words in wrong_percentages(each)
        ]
        return markdown_table(["club", "model", "percentage"], rows)


class LayerSpinTable(CoreTable):
    """``{layer-spins}``: the spins of the two-layer ball at take-off, next to the published mean."""

    def table(self) -> list[str]:
        """One row a reading."""
        columns: dict[str, list[float]] = {}
        for club in benchmark_data.CLUBS:
            history = clubface.history(
                HEADS[club], mean_delivery(club), model="volumetric", accuracy=1e-10, ball=published_ball()
            )
            accuracy = published()["volumetric", club]
            columns[club] = [history.launch.total_spin]
            columns[club] += [float(np.linalg.norm(spin[-1])) for spin in (history.cover_spin, history.core_spin)]
            columns[club] += [accuracy.mean["backspin"], accuracy.mae["backspin"]]
        words = (
            "all angular momentum over the inertia", "the cover alone", "the core alone", "published mean",
            "published mean absolute error",
        )  # fmt: skip
        cells = zip(*([f"{units.from_si(spin, 'rpm'):.0f}" for spin in each] for each in columns.values()), strict=True)
        return markdown_table(["spin, rpm", *columns], ([word, *row] for word, row in zip(words, cells, strict=True)))


READINGS = {
    "rings": (("G / 100 (default)", ""), ("G as printed", "as-printed")),
    "area": (
        ("G / 100, η = 0 (default)", ""), ("G / 100, η / 1000", "eta-in-thousandths"),
        ("G and η as printed", "as-printed"),
    ),
}  # fmt: skip
"""How the parameters of a model can be read, and the variant of the published set, by model."""
READ = {
    "launch, deg": ("launch", "deg", 1), "spin, rpm": ("backspin", "rpm", 0),
    "contact, µs": ("contact_time", "us", 0), "peak, kN": ("peak_force", "kN", 1),
}  # fmt: skip
"""Label, name, unit and digits of what is compared."""


class Readings(CoreTable):
    """``{area-readings}``, ``{rings-readings}``: launches by a contact model as its parameters can be read."""

    def table(self) -> list[str]:
        """One row a club and quantity, one column a reading."""
        name = self.name.removesuffix("-readings")
        columns = []
        for _, variant in READINGS[name]:
            column = []
            parameters = {"parameters": f"three-dimensional-impact-models/{variant}"} if variant else {}
            for club in benchmark_data.CLUBS:
                shot = clubface.impact(
                    HEADS[club], mean_delivery(club), model=name, ball=published_ball(), **parameters
                )
                column += [f"{shot.get(key, unit):.{digits}f}" for key, unit, digits in READ.values()]
            columns.append(column)
        labels = [f"{club}: {what}" for club in benchmark_data.CLUBS for what in READ]
        return markdown_table(["", *(words for words, _ in READINGS[name])], zip(labels, *columns, strict=True))


class DriverCgReadings(CoreTable):
    """``{driver-cg-readings}``: readings of the published places of a driver's CG, in the frame of the club."""

    IN_FRAME_OF_FACE = np.array([42.3, -2.9])
    """From the CG to the face centre, along and up the face [mm]: the vector of Danaei and co-workers reversed."""
    NOMINAL = (np.array([35.0, 4.0]), math.radians(10.0))
    """Vector in the frame of the club [mm] and loft of the nominal driver of McNally and co-workers (2016)."""

    def table(self) -> list[str]:
        """One row a reading."""
        printed = clubface.club("driver-as-printed")
        vector, loft, up = 1e3 * np.array(printed.cg)[:2], printed.loft, self.IN_FRAME_OF_FACE
        down = up * (1.0, -1.0)
        readings = (
            ("Caldwell and McPhee (2023), as printed", vector, loft),
            ("Danaei and co-workers (2020), y up, turned once", turned(up, loft), loft),
            ("the same, turned twice", turned(up, 2.0 * loft), loft),
            ("y down, turned once", turned(down, loft), loft),
            ("y down, turned by 11.7 degrees", turned(down, math.radians(11.7)), loft),
            ("McNally and co-workers (2016), frame of the club", *self.NOMINAL),
        )
        rows = []
        for words, (x, y), angle in readings:
            above = x * math.sin(angle) - y * math.cos(angle)
            rows.append([words, f"({x:.1f}, {y:.1f})", f"{math.hypot(x, y):.2f}", f"{above:+.1f}"])
        return markdown_table(["reading", "CG to face centre, mm", "length, mm", "CG above the normal, mm"], rows)


def turned(vector: Floats, angle: float) -> Floats:
    """Return a vector turned upwards by an angle [rad]."""
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([[cosine, -sine], [sine, cosine]]) @ vector


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("driver-cg-readings", DriverCgReadings)
    app.add_directive("contradictions", Contradictions)
    app.add_directive("layer-spins", LayerSpinTable)
    app.add_directive("wrong-percentages", WrongPercentages)
    for name in READINGS:
        app.add_directive(f"{name}-readings", Readings)
    return {"parallel_read_safe": True}
