"""Names of equipment as people write them, for the pages: the catalogue's own are keys of files and commands."""

from __future__ import annotations

from collections.abc import Mapping

__all__ = ["ball_title", "club_title", "set_title"]

CLUBS = {
    "average-3-wood-2008": "average 3-wood of 2008",
    "average-driver-2000": "average driver of 2000",
    "average-driver-2020": "average driver of 2020",
    "cleveland-zipcore-xl-7-iron": "Cleveland Zipcore XL 7-iron",
    "cobra-transition-s-5-hybrid": "Cobra Transition S 5-hybrid",
    "driver-as-printed": "driver as printed",
    "mcnally-2016-driver": "McNally's driver of 2016",
    "mizuno-pro-241-6-iron": "Mizuno Pro 241 6-iron",
    "ping-g430-6-iron": "PING G430 6-iron",
    "ping-g430-max-10k-driver": "PING G430 Max 10K driver",
    "taylormade-p790-6-iron": "TaylorMade P790 6-iron",
    "titleist-t100-6-iron": "Titleist T100 6-iron",
}
"""Clubs that are called after more than their kind."""

BALLS = {
    "modern-2026": "modern, 2026",
    "paper": "of Roh and Lee",
    "published": "of the published models",
}

SETS = {
    "registry defaults": "usual",
    "three-dimensional-impact-models": "published impact models, corrected",
    "three-dimensional-impact-models/as-printed": "published impact models, as printed",
    "three-dimensional-impact-models/eta-in-thousandths": "published impact models, area damping in thousandths",
    "golf-ball-spin-fem": "Roh and Lee, from their spin",
    "golf-ball-spin-fem/effective-radius": "Roh and Lee, from their effective radius",
    "jorgensen": "Jorgensen",
    "penner": "Penner",
    "tour-averages": "fitted to tour averages",
}


def title(name: str, known: Mapping[str, str]) -> str:
    """Return the title of a name; a number before a word keeps its hyphen, as in "7-iron"."""
    first, *rest = name.split("-")
    return known.get(name, f"{first}-{' '.join(rest)}" if first.isdigit() else " ".join([first, *rest]))


def club_title(name: str) -> str:
    """Return how people write the name of a club: "pitching wedge", "PING G430 6-iron"."""
    return title(name, CLUBS)


def ball_title(name: str) -> str:
    """Return how people write the name of a ball."""
    return title(name, BALLS)


def set_title(name: str) -> str:
    """Return how people write the name of a parameter set."""
    return title(name, SETS)
