"""How a golfer's shots are hit: club, model, ball and conditions, and what comes of deliveries with them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, NamedTuple

from clubface.design.dispersion.tally import FLOWN, LAUNCHED
from clubface.design.golfer.golfer import Golfer
from clubface.equipment.clubs import Club
from clubface.errors import InputError, RangeWarning, ShotError
from clubface.simulation.flight import Flight, fly
from clubface.simulation.impact import impact
from clubface.simulation.launch import Launch
from clubface.simulation.outside import Tally
from clubface.support.arrays import Floats
from clubface.support.warning import without_warnings


class Hitting(NamedTuple):
    """How shots are hit; called with deliveries it gives the quantities by name, shape (n,), NaN for a lost shot."""

    club: Club
    model: str
    parameters: Any = None
    ball: Any = None
    air: Any = None
    wind: Any = None
    ground: Any = None
    flight: bool = True
    threads: int | None = None
    accuracy: float | None = None

    def mean(self, of: Golfer) -> tuple[Launch, dict[str, float]]:
        """Return what the mean delivery gives; if nothing, it is an error that says why."""
        try:
            launch, flight = self._hit(of.delivery(), "raise")
        except ShotError as error:
            if error.parameter not in of.variables:
                raise
            # By itself it would be taken for an option of the same name, such as the lie that a shot is played from.
            raise InputError("golfer", of.name, f"one whose mean shot has a result: {error}") from None
        found = {name: float(getattr(launch, name)) for name in LAUNCHED}
        if flight is not None:
            found |= {name: float(getattr(flight, name)) for name in FLOWN}
        return launch, found

    def __call__(
        self, deliveries: Mapping[str, Floats], reasons: dict[str, str] | None = None, outside: Tally | None = None
    ) -> dict[str, Floats]:
        """Hit shots; ``reasons`` takes why some have no result, ``outside`` those outside the range of the model."""
        launch, flight = self._hit(deliveries, "nan")
        if outside is not None:
            outside.add(launch)
        found = {name: getattr(launch, name) for name in LAUNCHED}
        if flight is not None:
            found |= {name: getattr(flight, name) for name in FLOWN}
        if reasons is not None and not reasons:
            for problem in (launch if flight is None else flight).problems:
                reasons.setdefault(problem.parameter, problem.reason)
        return found

    def _hit(self, deliveries: Any, on_error: Literal["raise", "nan"]) -> tuple[Launch, Flight | None]:
        """Return launches and, if the balls fly, flights."""
        with without_warnings(RangeWarning):  # it is told of all shots together
            launch = impact(
                self.club, deliveries, model=self.model, parameters=self.parameters, ball=self.ball,
                threads=self.threads, accuracy=self.accuracy, on_error=on_error,
            )  # fmt: skip
        if not self.flight:
            return launch, None
        flight = fly(
            launch, air=self.air, wind=self.wind, ground=self.ground, threads=self.threads, on_error=on_error
        )  # fmt: skip
        return launch, flight
