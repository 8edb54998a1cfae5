"""Causes of differences between models and published off-centre strikes: closure, inertia and CG depth.

Each published figure is computed again with one change. Radar reports the path of the head's geometric centre, near its
CG, while cameras report the path of the face centre. A closing face rotates about the CG behind it and so moves left at
the ball; for a driver the two paths differ by 2 to 3 degrees.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from clubface import units
from clubface.equipment.clubs import Club, club
from clubface.equipment.models import DEFAULT_MODEL
from clubface.results.table import Column, Table, table, text
from clubface.simulation.launch import Launch
from clubface.validation.check import ModelUnderTest, reading
from clubface.validation.run import published_columns

CLOSURE = units.parse("2500 deg/s", "angular rate")
"""Closure rate, between 1800 and 3600 deg/s for drives (S. MacKenzie, golf.com)."""
LOFTING = units.parse("1000 deg/s", "angular rate")
"""Pitch rate at which a driver's face centre moves about 1 degree farther up than its CG, as stated by TrackMan."""
SMALL_INERTIA = units.parse("4500 g cm2", "inertia")
"""Inertia about the vertical of a driver from the years of the published tests (McNally and co-workers, 2016)."""
DEEPER = units.parse("10 mm", "length")


def deeper(head: Club) -> Club:
    """Return a head whose CG is ``DEEPER`` farther behind the face, along the face normal."""
    return head.replace(
        cg_x=head.cg_x + DEEPER * math.cos(head.loft), cg_y=head.cg_y + DEEPER * math.sin(head.loft)
    )  # fmt: skip


def less_inertia(head: Club) -> Club:
    """Return a wood with less inertia about the vertical; other clubs are unchanged."""
    return head.replace(iyy=SMALL_INERTIA) if head.kind == "wood" else head


def closing(head: Club, speed: float) -> dict[str, float]:
    """Return a delivery with closure, whose path is the CG's."""
    return {"closure": CLOSURE}


def closing_on_path(head: Club, speed: float) -> dict[str, float]:
    """Return a delivery with closure and the CG moving right, so that the face centre has a path of 0."""
    return {"closure": CLOSURE, "path": math.atan(CLOSURE * head.cg_depth / speed)}


def lofting(head: Club, speed: float) -> dict[str, float]:
    """Return a delivery with increasing loft."""
    return {"pitch_rate": LOFTING}


@dataclass(frozen=True)
class HeadVariation:
    """One change: its name, the changed head, and additions to the delivery for a head and speed."""

    name: str
    head: Callable[[Club], Club] = lambda head: head
    delivery: Callable[[Club, float], dict[str, float]] = lambda head, speed: {}


CHANGES = (
    HeadVariation("as judged"),
    HeadVariation("closing, path of the CG 0", delivery=closing),
    HeadVariation("closing, path of the face 0", delivery=closing_on_path),
    HeadVariation("loft increasing", delivery=lofting),
    HeadVariation("less inertia", less_inertia),
    HeadVariation("CG 10 mm deeper", deeper),
)


class Changed(ModelUnderTest):
    """A model under test with a change of the built-in heads and of every delivery."""

    def __init__(self, change: HeadVariation, model: str, ball: Any = None) -> None:
        super().__init__(model, ball)
        self.change = change

    def strike(self, club: str | Club, *, parameters: dict[str, float] | None = None, **delivery: Any) -> Launch:
        """Return the launch of one shot."""
        head, delivery = self._changed(club, delivery)
        return super().strike(head, parameters=parameters, **delivery)

    def at_launch(self, club: str | Club, launch: Any, **delivery: Any) -> Launch:
        """Return shots at their launch angle."""
        head, delivery = self._changed(club, delivery)
        return super().at_launch(head, launch, **delivery)

    def _changed(self, struck: str | Club, delivery: dict[str, Any]) -> tuple[Club, dict[str, Any]]:
        head = self.change.head(club(struck))
        return head, self.change.delivery(head, delivery["speed"]) | delivery


def causes(models: Sequence[str] = (DEFAULT_MODEL,), ball: str | os.PathLike[str] | None = None) -> Table:
    """Return a table with a row per off-centre figure and model, and a column of values for each change."""
    from clubface.validation.catalogue import check_named

    checks = [check_named(name) for name in ("toe-hits", "strike-height", "gear-effect", "best-strike")]
    by_change = [
        [each for model in models for check in checks for each in check.figures(Changed(change, model, ball))]
        for change in CHANGES
    ]
    first = by_change[0]
    quantities = [reading(each.unit) for each in first]
    names = [model for model in models for _ in range(len(first) // len(models))]
    return table(
        "off_centre", text("model", names, printed=len(models) > 1),
        text("figure", [f"{each.case}: {each.quantity}" for each in first]), *published_columns(first),
        text("certainty", [each.certainty for each in first]),
        *(
            Column(re.sub(r"\W+", "_", change.name).lower(), [each.computed for each in figures], quantities,
                   label=change.name)
            for change, figures in zip(CHANGES, by_change, strict=True)
        ),
        title=f"Strikes off the centre with one thing changed, by {', '.join(models)}",
    )  # fmt: skip
