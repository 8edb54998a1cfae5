"""Tables of what in the publications cannot be as printed, computed when the pages are built."""

from __future__ import annotations

from typing import Any

import numpy as np
from core_tables import CoreTable, markdown_table
from sphinx.application import Sphinx

import clubface
from clubface import benchmark_data, units
from clubface.benchmark_data.recipe import recipe
from clubface.equipment.balls import published_ball
from clubface.evaluation.contradictions import contradictions
from clubface.evaluation.published_accuracy import published
from clubface.measured.shots import QUANTITIES
from clubface.simulation.layers import layer_spins

MEAN_DELIVERY = ("speed", "attack", "loft")
PRINTED_AREA = {"driver": (5.40e9, 1.32e5), "7-iron": (5.24e9, 2.06e5)}
"""G [Pa] and eta as printed in Table 10 of Caldwell and McPhee (2023)."""
SCALE = 1e-3
"""What masses, inertias and forces are multiplied by to bring these into the bounds; the motion stays the same."""


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
            history = clubface.history(
                club, mean_delivery(club), model="volumetric", accuracy=1e-10, ball=published_ball()
            )
            spins = layer_spins(history)
            of = published()["volumetric", club]
            columns[club] = [history.launch.total_spin]
            columns[club] += [float(np.linalg.norm(each)) for each in (spins.cover_at_take_off, spins.core_at_take_off)]
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
            ("G and η as printed", as_printed),
        ):
            row = [words]
            for club in benchmark_data.CLUBS:
                shot = clubface.impact(club, mean_delivery(club), model="area", ball=published_ball(), **of(club))
                row += [
                    f"{shot.get('launch', 'deg'):.1f}", f"{shot.get('backspin', 'rpm'):.0f}",
                    f"{shot.get('contact_time', 'us'):.0f}",
                ]  # fmt: skip
            rows.append(row)
        heads = [
            f"{club}: {what}" for club in benchmark_data.CLUBS for what in ("launch, deg", "spin, rpm", "contact, µs")
        ]
        return markdown_table(["parameters", *heads], rows)


def as_printed(club: str) -> dict[str, Any]:
    """Return what makes :func:`clubface.impact` compute the printed values of a club, in scaled masses."""
    shear_modulus, area_damping = PRINTED_AREA[club]
    held = {**clubface.club(club).inputs(), **published_ball().inputs()}
    masses = {
        name: SCALE * value
        for name, value in held.items()
        if "mass" in name or name.startswith("i") or "inertia" in name
    }
    return {**masses, "parameters": {"shear_modulus": SCALE * shear_modulus, "area_damping": SCALE * area_damping}}


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("contradictions", Contradictions)
    app.add_directive("layer-spins", LayerSpinTable)
    app.add_directive("area-readings", AreaReadings)
    return {"parallel_read_safe": True}
