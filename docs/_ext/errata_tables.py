"""Tables of what in the publications cannot be as printed, computed when the pages are built."""

from __future__ import annotations

import numpy as np
from core_tables import CoreTable, markdown_table
from sphinx.application import Sphinx

import clubface
from clubface import benchmark_data, units
from clubface.benchmark_data.recipe import recipe
from clubface.evaluation.contradictions import contradictions
from clubface.evaluation.published_accuracy import published
from clubface.measured.shots import QUANTITIES

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
            figures = (f"{apart:.{digits}f} {unit}", f"{allowed:.{digits}f} {unit}", f"{apart / allowed:.2f}")
            rows.append([each.club, each.quantity.replace("_", " "), f"`{pair[0]}` above `{pair[1]}`", *figures])
        return markdown_table(["club", "quantity", "models", "apart", "allowed", "ratio"], rows)


class LayerSpinTable(CoreTable):
    """``{layer-spins}``: the spins of the two-layer ball at take-off, beside the published mean."""

    def table(self) -> list[str]:
        """One row a reading."""
        columns: dict[str, list[float]] = {}
        for club in benchmark_data.CLUBS:
            history = clubface.history(club, mean_delivery(club), model="volumetric", accuracy=1e-10)
            of = published()["volumetric", club]
            columns[club] = [history.launch.total_spin]
            columns[club] += [float(np.linalg.norm(spin[-1])) for spin in (history.cover_spin, history.core_spin)]
            columns[club] += [of.mean["backspin"], of.mae["backspin"]]
        words = (
            "all angular momentum over the inertia", "the cover alone", "the core alone", "published mean",
            "published mean absolute error",
        )  # fmt: skip
        cells = zip(*([f"{units.from_si(spin, 'rpm'):.0f}" for spin in each] for each in columns.values()), strict=True)
        return markdown_table(["spin, rpm", *columns], ([word, *row] for word, row in zip(words, cells, strict=True)))


class AreaReadings(CoreTable):
    """``{area-readings}``: launches by the contact-area model as its parameters can be read."""

    def table(self) -> list[str]:
        """One row a reading."""
        rows = []
        for words, of in (
            ("G / 100, η = 0 (default)", lambda club: {}),
            ("G / 100, η / 1000", lambda club: {"parameters": "three-dimensional-impact-models/eta-in-thousandths"}),
            ("G and η as printed", lambda club: {"parameters": "three-dimensional-impact-models/as-printed"}),
        ):
            row = [words]
            for club in benchmark_data.CLUBS:
                shot = clubface.impact(club, mean_delivery(club), model="area", **of(club))
                row += [
                    f"{shot.get('launch', 'deg'):.1f}", f"{shot.get('backspin', 'rpm'):.0f}",
                    f"{shot.get('contact_time', 'us'):.0f}",
                ]  # fmt: skip
            rows.append(row)
        heads = [
            f"{club}: {what}" for club in benchmark_data.CLUBS for what in ("launch, deg", "spin, rpm", "contact, µs")
        ]
        return markdown_table(["parameters", *heads], rows)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("contradictions", Contradictions)
    app.add_directive("layer-spins", LayerSpinTable)
    app.add_directive("area-readings", AreaReadings)
    return {"parallel_read_safe": True}
