"""A posterior in tables and words: what is known, which quantities are tied, and what the launch leaves open."""

from __future__ import annotations

from typing import Any

import numpy as np

from clubface import units
from clubface.inference.expectation import shown as with_unit
from clubface.inference.posterior import Posterior, shown, unit_of
from clubface.simulation.delivery import OF_CLUB

CLOSE = 0.5
"""Correlation from which two quantities are said to go together."""
NOT_LEARNED = 0.05
"""Narrowing below which a launch is said to tell nothing of a quantity."""


def summary(of: Posterior) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows: mean, standard deviation and 95% interval of each quantity, and what was believed."""
    heads = ["", "mean", "STD", "95%", "before", "narrower by"]
    mean, deviation, learned = of.mean, of.deviation, of.learned
    rows = []
    for name in of.names:
        low, high = of.interval(name)
        rows.append(
            [
                f"{name} ({unit_of(name)})",
                shown(mean[name], name),
                shown(deviation[name], name),
                f"[{shown(low, name)}, {shown(high, name)}]",
                f"{shown(of.prior.mean[name], name)} +- {shown(of.prior.deviation[name], name)}",
                f"{100.0 * learned[name]:.0f}%",
            ]
        )
    return heads, rows


def ambiguities(of: Posterior) -> list[str]:
    """Return a sentence about each pair of quantities that are tied together, the closest first."""
    correlation, names, same = of.correlation, of.names, not_learned(of)
    pairs = [
        (abs(correlation[i, j]), i, j)
        for i in range(len(names))
        for j in range(i)
        if names[i] not in same or names[j] not in same
    ]
    found = []
    for size, i, j in sorted(pairs, reverse=True):
        if size < CLOSE:
            break
        one, other = sorted((names[i], names[j]), key=lambda name: -of.deviation[name] / of.prior.deviation[name])
        slope = float(correlation[i, j]) * of.deviation[other] / of.deviation[one]
        step = units.parse(f"1 {unit_of(one)}", OF_CLUB[one])
        change = float(units.from_si(slope * step, unit_of(other)))
        word = "more" if change > 0 else "less"
        found.append(
            f"{one} and {other} are tied (correlation {correlation[i, j]:+.2f}): 1 {unit_of(one)} more {one} with"
            f" {abs(change):.2g} {unit_of(other)} {word} {other} makes about the same launch"
        )
    return found


def not_learned(of: Posterior) -> list[str]:
    """Return the quantities that are as uncertain as before."""
    return [name for name, part in of.learned.items() if part < NOT_LEARNED]


def notes(of: Posterior) -> list[str]:
    """Return what a reader of the tables must know."""
    given = ", ".join(
        f"{name} {with_unit(name, value, 5)} +- {with_unit(name, of.noise[name], 2)}"
        for name, value in {**of.launch, **of.delivery}.items()
    )
    found = [*of.warnings]
    found.append(f"Measured: {given}. Before: {of.prior.name}.")
    if of.known:
        told = ", ".join(f"{name} {with_unit(name, value, 4)}" for name, value in of.known.items())
        found.append(f"Measured, and taken as exact since the prior leaves it out: {told}.")
    found += [f"{text}." for text in ambiguities(of)]
    unknown = not_learned(of)
    if unknown:
        what = "The launch tells" if not of.delivery else "What was measured tells"
        found.append(f"{what} nothing of {', '.join(unknown)}: there the prior is seen again.")
    found.append(
        f"{of.model} with {of.parameters.name} is taken as exact; its errors belong into the noise. {len(of)} draws"
        f" from {of.sample.draws} weighted ones, of which {of.effective:.0f} are effective;"
        f" {of.sample.evaluations} impacts, seed {of.seed}."
    )
    return found


def document(of: Posterior) -> dict[str, Any]:
    """Return everything but the draws as one document for JSON, SI."""
    return {
        "club": of.club.name,
        "model": of.model,
        "parameters": {"name": of.parameters.name, "values": dict(of.parameters.values)},
        "launch": of.launch,
        "delivery": {**of.delivery, **of.known},
        "noise": of.noise,
        "prior": {
            "name": of.prior.name,
            "mean": dict(of.prior.mean),
            "deviation": dict(of.prior.deviation),
            "correlations": [[*pair, value] for pair, value in of.prior.correlations.items()],
        },
        "units": {name: units.SI_UNITS[OF_CLUB[name]] for name in of.names},
        "mean": of.mean,
        "deviation": of.deviation,
        "interval_95": {name: list(of.interval(name)) for name in of.names},
        "learned": of.learned,
        "names": list(of.names),
        "correlation": np.round(of.correlation, 6),
        "ambiguities": ambiguities(of),
        "not_learned": not_learned(of),
        "diagnostics": {
            "samples": len(of),
            "effective": of.effective,
            "draws": of.sample.draws,
            "impacts": of.sample.evaluations,
            "stages": of.sample.stages,
            "largest_weight": of.sample.largest_weight,
            "log_evidence": of.sample.log_evidence,
            "surprise": of.surprise,
            "reproduced": of.reproduced,
            "seed": of.seed,
        },
        "warnings": of.warnings,
    }
