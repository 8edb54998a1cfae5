"""The end of a report: what it was computed from, by which versions, after which sources."""

from __future__ import annotations

import platform
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from clubface.equipment.backends import MODULES
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.reports.blocks import Block, Bullets, Data, Heading, Paragraph, Table
from clubface.simulation.launch import Launch
from clubface.simulation.quantities import inputs
from clubface.support.version import __version__
from clubface.units import display_unit, show, show_range

WORKS = {
    "Caldwell and McPhee|Three-dimensional golf clubhead": "Caldwell and McPhee (2023): Three-dimensional golf "
    "clubhead-ball impact models for drivers and irons, and the thesis it grew out of, A. W. Caldwell, Development and "
    "comparison of 3D dynamic models of golf clubhead-ball impacts, MASc thesis, University of Waterloo, 2023",
    "Roh and Lee": "Roh and Lee: W.-J. Roh and C.-W. Lee, Analysis of golf ball spin mechanism at impact by FEM, Center"
    " for Noise and Vibration Control, KAIST, Daejeon",
    r"Penner \(2002\)": "Penner (2002): A. R. Penner, The run of a golf ball, Canadian Journal of Physics 80, 931-940",
    "Broadie and Ko": "Broadie and Ko (2009): A simulation model to analyze the impact of distance and direction on "
    "golf scores, Proceedings of the Winter Simulation Conference",
    "TrackMan Combine": "TrackMan (2024): averages of the TrackMan Combine by handicap",
}
"""Works that other sources name in short, in full, by a pattern of the short name."""


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
    told = list(dict.fromkeys((*_sources(found), *sources)))
    named = " ".join([*told, *(given or {}).values()])
    if told := told + [work for short, work in WORKS.items() if re.search(short, named)]:
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
        # A club that keeps a mesh has it as its head; reduced models know the rigid club alone.
        if hasattr(each.club, "head") and not each.club.characteristic_time and each.model not in MODULES:
            yield (
                f"The face of {each.club.name} is taken as rigid by the model {each.model}: finite elements alone"
                " strike its mesh, and its file gives no characteristic time."
            )
        yield from (str(text) for text in each.provenance["parameters"]["caveats"])
