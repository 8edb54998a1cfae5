"""The end of a report: what it was computed from, by which versions, after which sources."""

from __future__ import annotations

import platform
from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.reports.blocks import Block, Bullets, Data, Heading, Paragraph, Table
from clubface.simulation.launch import Launch
from clubface.simulation.quantities import inputs
from clubface.support.version import __version__
from clubface.units import display_unit, show, show_range


def origin(
    launches: Iterable[Launch], *, given: Mapping[str, str] | None = None, sources: Iterable[str] = ()
) -> Iterator[Block]:
    """Yield inputs, versions and sources of what was computed from ``launches``.

    ``given`` tells in words what else went in, by name: "air", "golfer"; ``sources`` are those of all but the launches.
    """
    found = list(launches)
    yield Heading(2, "How this was computed")
    rows = [*_deliveries(found), *(given or {}).items()]
    if rows:
        yield Table(("input", "value"), rows, Data("inputs", ("input", "value"), rows))
    yield Paragraph(tuple(_by(found)))
    if told := list(dict.fromkeys((*_sources(found), *sources))):
        yield Heading(3, "Sources")
        yield Bullets(told)
    if caveats := list(dict.fromkeys(_caveats(found))):
        yield Heading(3, "What to keep in mind")
        yield Bullets(caveats)


def _deliveries(launches: Sequence[Launch]) -> Iterator[tuple[str, str]]:
    """Yield the values of deliveries that all launches share, and the range of those that differ."""
    for name in launches[0].delivery if launches else ():
        values = np.concatenate([np.ravel(each.input(name)) for each in launches])
        values = values[np.isfinite(values)]
        if not values.any():
            continue
        unit = "mph" if name == "speed" else display_unit(name, inputs()[name].unit)
        low, high = float(values.min()), float(values.max())
        yield name.replace("_", " "), show(low, unit) if low == high else show_range(low, high, unit)


def _by(launches: Sequence[Launch]) -> Iterator[str]:
    for club, hand, ball, model, parameters in dict.fromkeys(
        (each.club.name, each.club.hand, each.ball.name, each.model, each.parameters.name) for each in launches
    ):
        head = f"{club}, left-handed," if hand < 0 else club
        yield f"Club {head} and ball {ball}, by the model {model} with the parameters {parameters}."
    yield versions()


def versions() -> str:
    """Return a sentence with the versions of what computed a report."""
    return f"Computed by clubface {__version__}, Python {platform.python_version()} and numpy {np.__version__}."


def _sources(launches: Sequence[Launch]) -> Iterator[str]:
    for each in launches:
        made = each.provenance
        for what, told in (("model", made["model"]), ("parameters", made["parameters"])):
            text = " ".join(dict.fromkeys(str(told[key]) for key in ("source", "reference") if told.get(key)))
            if text:
                yield f"{what.capitalize()} {told['name']}: {text}"
        yield from equipment_sources(each.club, each.ball)


def equipment_sources(*things: Club | Ball) -> Iterator[str]:
    """Yield where the values of clubs and balls come from, those of one source together."""
    for thing in things:
        by_source: dict[str, list[str]] = {}
        for name, source in thing.sources.items():
            by_source.setdefault(source, []).append(name.replace("_", " "))
        for source, names in by_source.items():
            yield f"{type(thing).__name__} {thing.name}, {', '.join(names)}: {source}"


def _caveats(launches: Sequence[Launch]) -> Iterator[str]:
    for each in launches:
        yield from (str(text) for text in each.provenance["parameters"]["caveats"])
