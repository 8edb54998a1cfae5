"""One row a shot: what was measured, the delivery that was found, and what is to be remarked of it."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from clubface import units
from clubface.equipment.clubs import club
from clubface.equipment.described import HANDS
from clubface.errors import InputError, RangeWarning
from clubface.inference.expectation import UnreachableLaunchError, unit_of
from clubface.inference.prior import prior_of
from clubface.inference.run import Inference
from clubface.measured.shots import QUANTITIES
from clubface.recorded.shots import RecordedShots
from clubface.simulation.delivery import OF_CLUB
from clubface.support.warning import without_warnings

REMARK = "remark"
SAMPLES = 400
"""Draws for each shot of a file. Twice as many are effective, so that they tell a mean to 4% of its deviation and the
ends of its interval to about 10%."""


class Rows:
    """The rows of a file of shots.

    Parameters
    ----------
    shots
        Recorded shots with at least one launch quantity. What they hold of the delivery is taken as measured, too.
    **options
        As for :func:`clubface.infer`.
    """

    def __init__(self, shots: RecordedShots, **options: Any) -> None:
        self._shots = shots
        self.launch = [name for name in QUANTITIES if name in shots.launches]
        """The launch quantities that were measured."""
        if not self.launch:
            raise InputError("shots", shots.source, f"shots with a measured launch: {', '.join(QUANTITIES)}")
        self.club = [name for name in OF_CLUB if np.isfinite(shots.deliveries.get(name, np.nan)).any()]
        """The quantities of the delivery that were measured."""
        head = club(options.pop("club"))
        self.options = {"samples": SAMPLES, **options, "club": head, "prior": prior_of(options.get("prior"), head)}
        """With what deliveries are inferred."""
        self._given = {"samples": SAMPLES, **options, "speed_at": shots.speed_at, "face_at": shots.face_at}
        self._head = head
        self._prepared: dict[int, Inference] = {}
        self.names = self.options["prior"].names
        """The quantities that are inferred."""
        self._for(head.hand)  # whose options are wrong is told before any work

    @property
    def headings(self) -> list[str]:
        """The headings: measured quantities of the launch, four of each inferred quantity, and what is to be said."""
        found = ["row", *(_heading(name, QUANTITIES[name]) for name in self.launch)]
        for name in self.names:
            found += [_heading(name, unit_of(name), end) for end in ("", "_std", "_from", "_to")]
        return [*found, "effective", REMARK]

    def of(self, place: int) -> list[Any]:
        """Return the cells of one shot; one that cannot be inferred says why in its last."""
        shots = self._shots
        launch = {name: float(shots.launches[name][place]) for name in self.launch}
        cells: list[Any] = [int(shots.rows[place]), *(_cell(launch[name], QUANTITIES[name]) for name in self.launch)]
        measured = {name: value for name, value in launch.items() if np.isfinite(value)}
        club_data = {name: float(shots.deliveries[name][place]) for name in self.club}
        club_data = {name: value for name, value in club_data.items() if np.isfinite(value)}
        nothing = [""] * (4 * len(self.names) + 1)
        if not measured:
            return [*cells, *nothing, "nothing of the launch was measured"]
        hand = self._head.hand if shots.hand is None else HANDS[shots.hand[place]]
        try:
            with without_warnings(RangeWarning):
                found = self._for(hand).of(measured, club_data)
        except UnreachableLaunchError as error:
            return [*cells, *nothing, str(error)]
        for name in self.names:
            values = (found.mean[name], found.deviation[name], *found.interval(name))
            cells += [_cell(value, unit_of(name)) for value in values]
        remarks = [*found.warnings, *([found.outside] if found.outside else [])]
        return [*cells, round(found.effective), "; ".join(remarks)]

    def _for(self, hand: int) -> Inference:
        """Return what infers the shots of a hand."""
        if hand not in self._prepared:
            self._prepared[hand] = Inference(club=replace(self._head, hand=hand), **self._given)
        return self._prepared[hand]


def _spelled(name: str) -> str:
    return "club_speed" if name == "speed" else name


def _heading(name: str, unit: str, end: str = "") -> str:
    return f"{_spelled(name)}{end}_{unit}" if unit.isalnum() else f"{_spelled(name)}{end} [{unit}]"


def _cell(value: float, unit: str) -> str:
    return "" if math.isnan(value) else f"{float(units.from_si(value, unit)):.6g}"
