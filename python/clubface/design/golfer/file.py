"""Golfers as TOML files: means and spreads of the delivery, correlations, mishits, and where each figure comes from.

::

    title = "Member of our club, driver"
    club = "driver"
    hand = "right"

    [mean]
    speed = "95 mph"
    loft = "14 deg"

    [spread]                       # standard deviation from shot to shot
    speed = "1.2 mph"
    face = "1.8 deg"

    [[correlation]]
    of = ["face", "path"]
    value = 0.4

    [mishit]
    share = 0.1                    # of the shots,
    scale = 2                      # whose deviations are so many times as wide

    [sources]
    mean.speed = "measured"
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from clubface import units
from clubface.design.golfer.golfer import UNIT, Golfer
from clubface.equipment.described import HANDS
from clubface.errors import ClubfaceError, InputError
from clubface.recorded.possible import can_be
from clubface.simulation.delivery import OF_CLUB
from clubface.support.checks import check_choice
from clubface.support.shipped import beside, path_of
from clubface.support.strict_toml import Document, quoted
from clubface.units import SI_UNITS

KEYS = ("title", "club", "hand", "mean", "spread", "correlation", "mishit", "sources")
PARTS = ("mean", "spread", "correlation", "mishits")
"""What sources may be told of."""


def read(which: str | os.PathLike[str]) -> Golfer:
    """Read a golfer: a shipped one by its name, or the TOML file at a path."""
    path = path_of("golfer", which, "golfers")
    return from_document(Document.read(path), Path(path).stem)


def from_document(document: Document, name: str) -> Golfer:
    """Return the golfer a document describes; ``name`` is what it is called."""
    data = document.data
    document.check_keys(data, KEYS, ("title", "mean", "spread"))
    document.check_text(data, ("title", "club", "hand"))
    for table in ("mean", "spread", "mishit", "sources"):
        if not isinstance(data.get(table, {}), dict):
            raise document.error(f"[{table}] must be a table", table)
    document.check_keys(data["mean"], OF_CLUB, ("speed",), "mean")
    document.check_keys(data["spread"], OF_CLUB, (), "spread")
    mishit = data.get("mishit", {})
    document.check_keys(mishit, ("share", "scale"), ("share", "scale") if mishit else (), "mishit")
    for key, value in mishit.items():
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise document.error(f"{key} must be a number, not {value!r:.60}", key, "mishit")
    variables = tuple(each for each in OF_CLUB if each in data["mean"] or each in data["spread"])
    mean, spread = (np.array(_values(document, part, variables)) for part in ("mean", "spread"))
    if not (spread >= 0.0).all():
        at = variables[int(np.argmin(spread))]
        raise document.error(f"{at} is a standard deviation: it must not be negative", at, "spread")
    if "loft" in variables and "loft" not in data["mean"]:
        raise document.error("loft has a spread but no mean; give it under [mean]", "loft", "spread")
    correlation = _correlations(document, variables, spread)
    with np.errstate(over="ignore"):  # what is too large is refused
        covariance = correlation * np.outer(spread, spread)
    try:
        check_choice("hand", data.get("hand", "right"), HANDS)
        return Golfer(
            name=name,
            title=data["title"],
            club=os.fspath(beside(data.get("club", "driver"), Path(document.path).parent)),
            hand=HANDS[data.get("hand", "right")],
            variables=variables,
            mean=mean,
            covariance=covariance,
            mishit_share=float(mishit.get("share", 0.0)),
            mishit_scale=float(mishit.get("scale", 1.0)),
            sources=_sources(document),
        )
    except InputError as error:
        raise document.wrap(_as_written(error)) from error


def _as_written(error: InputError) -> InputError:
    """Return the error with the name of the key as it stands in a file."""
    return InputError(error.parameter.replace("mishit_", "mishit."), error.value, error.allowed)


def _values(document: Document, part: str, variables: tuple[str, ...]) -> list[float]:
    found = []
    for name in variables:
        try:
            value = units.parse(given := document.data[part].get(name, 0.0), OF_CLUB[name], name=name)
            # A spread so wide that two of them are no shot, such as 0.9 rad, was meant in another unit, too.
            if value and not can_be(name, value if part == "mean" else 2.0 * abs(value)):
                raise InputError(
                    name, given, f"what shots can have, as text with its unit, such as {UNIT[OF_CLUB[name]]}"
                )
            found.append(value)
        except ClubfaceError as error:
            raise document.wrap(error, part) from error
    return found


def _correlations(document: Document, variables: tuple[str, ...], spread: Any) -> Any:
    entries = document.data.get("correlation", [])
    if not (isinstance(entries, list) and all(isinstance(each, dict) for each in entries)):
        raise document.error("correlation must be tables, each under [[correlation]]", "correlation")
    found = np.eye(len(variables))
    told: set[frozenset[str]] = set()
    for index, entry in enumerate(entries):
        document.check_keys(entry, ("of", "value"), ("of", "value"), "correlation", index)
        pair, value = entry["of"], entry["value"]
        names = isinstance(pair, list) and len(pair) == 2 and all(each in variables for each in pair)
        if not names or pair[0] == pair[1]:
            raise document.error(
                f"of must name two variables of this golfer: {', '.join(variables)}", "of", "correlation", index
            )
        if isinstance(value, bool) or not isinstance(value, int | float) or not -1.0 < value < 1.0:
            raise document.error("value must be a number between -1 and 1", "value", "correlation", index)
        still = [each for each in pair if spread[variables.index(each)] == 0.0]
        if still and value:
            raise document.error(f"{still[0]} does not vary; give it a spread", "of", "correlation", index)
        if frozenset(pair) in told:
            raise document.error(f"{' and '.join(pair)} have a correlation already", "of", "correlation", index)
        told.add(frozenset(pair))
        one, other = (variables.index(each) for each in pair)
        found[one, other] = found[other, one] = value
    return found


def _sources(document: Document) -> dict[str, str]:
    given = document.data.get("sources", {})
    document.check_keys(given, PARTS, (), "sources")
    found = {}
    for part, told in given.items():
        if part in ("mean", "spread"):
            if not isinstance(told, dict):
                raise document.error(f"sources of the {part} are a table of texts", part, "sources")
            document.check_keys(told, OF_CLUB, (), f"sources.{part}")
            document.check_text(told, told, f"sources.{part}")
            found |= {f"{part} of {name}": text for name, text in told.items()}
        else:
            document.check_text(given, (part,), "sources")
            found[part] = told
    return found


def to_toml(of: Golfer) -> str:
    """Write a golfer as TOML text, which reads back as the same to 12 digits."""
    hand = "right" if of.hand > 0 else "left"
    lines = [f"{key} = {quoted(text)}" for key, text in {"title": of.title, "club": of.club, "hand": hand}.items()]
    for part, values in (("mean", of.mean), ("spread", of.spread)):
        lines += ["", f"[{part}]"]
        lines += [
            f"{name} = {quoted(written(value, name))}"
            for name, value in zip(of.variables, map(float, values), strict=True)
        ]
    for one, name in enumerate(of.variables):
        for other in range(one):
            if value := float(of.correlation[one, other]):
                lines += ["", "[[correlation]]", f'of = ["{name}", "{of.variables[other]}"]', f"value = {value:.12g}"]
    if of.mishit_share > 0.0:
        lines += ["", "[mishit]", f"share = {of.mishit_share:.12g}", f"scale = {of.mishit_scale:.12g}"]
    return "\n".join([*lines, *_source_lines(of.sources)]) + "\n"


def written(value: float, name: str) -> str:
    """Write a value of a delivery [SI] with the unit that people use for it."""
    dimension = OF_CLUB[name]
    unit = UNIT.get(dimension, SI_UNITS[dimension])
    number = units.from_si(value, unit)
    return f"{0.0 if math.isclose(number, 0.0, abs_tol=1e-14) else number:.12g} {unit}"


def _source_lines(sources: Mapping[str, str]) -> list[str]:
    if not sources:
        return []
    lines = ["", "[sources]"]
    lines += [f"{part} = {quoted(sources[part])}" for part in ("correlation", "mishits") if part in sources]
    for part in ("mean", "spread"):
        told = {name: sources[f"{part} of {name}"] for name in OF_CLUB if f"{part} of {name}" in sources}
        if told:
            lines += ["", f"[sources.{part}]", *(f"{name} = {quoted(text)}" for name, text in told.items())]
    return lines
