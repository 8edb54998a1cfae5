"""Where the shots of a golfer land with a club that changes, with exact derivatives by what changes.

Launch and flight are differentiated by dual numbers in the core, all shots at once, and joined by the chain rule. The
shots are the same for every club, so that a difference between two clubs is one between clubs and not between samples.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from clubface.design.feasibility import MASS_PROPERTIES
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError
from clubface.simulation import core
from clubface.simulation.flight_inputs import BALL, SPIN, VELOCITY, conditions
from clubface.simulation.inputs import broadcast, equipped, shots
from clubface.simulation.quantities import flight_inputs, flight_outputs, input_columns, outputs

if TYPE_CHECKING:
    from clubface.equipment.balls import Ball
    from clubface.equipment.clubs import Club

SPEED_EXPONENT = 0.18
"""Clubhead speed falls as mass to this power: 26 g more, from 174 to 200 g, cost golfers of some 110 mph about 2.7 mph
(MacKenzie, Ryan and Rice, 2015)."""
FACE = ("loft", "bulge", "roll", "characteristic_time")
FREE = (*MASS_PROPERTIES, *FACE, "lie")
"""What may change: fields of a club, and its lie as a change of the lie at impact."""
LANDING = ("carry", "side", "total", "total_side")
"""What is known of a shot: where it comes down, and where it comes to rest; the rows of all landings."""
LAUNCH = (*VELOCITY, *SPIN)


@dataclass(frozen=True, kw_only=True)
class Setting:
    """What is the same for all clubs: model, ball, air, ground, threads.

    Attributes
    ----------
    model, parameters, ball
        As for :func:`clubface.impact`.
    air, wind, ground
        As for :func:`clubface.fly`.
    speed_exponent
        Clubhead speed is proportional to the mass of the head to minus this power.
    threads
        Of the core; 0 for all cores.
    """

    model: str
    parameters: Any = None
    ball: str | Ball | None = None
    air: Any = None
    wind: Any = None
    ground: Any = None
    speed_exponent: float = SPEED_EXPONENT
    threads: int = 0


DEFAULT_SETTING = Setting(model=DEFAULT_MODEL)


def own_value(club: Club, field: str) -> float:
    """Return what a club has of a field that may change [SI]; its lie is a change, and 0."""
    return 0.0 if field == "lie" else getattr(club, field)


class Slopes:
    """Derivatives of the landings, kept in the two factors of the chain rule.

    Attributes
    ----------
    variables
        What the club was differentiated by, fields of ``FREE``.
    """

    def __init__(self, variables: tuple[str, ...], flight: NDArray[Any], launch: NDArray[Any]) -> None:
        self.variables = variables
        self._flight, self._launch = flight, launch

    def gradient(self, weights: NDArray[Any]) -> NDArray[Any]:
        """Return the derivatives of the sum of weights times landings, shape (variables,).

        Parameters
        ----------
        weights
            Of what is known of every shot, shape (landings, shots).
        """
        by_launch = np.einsum("on,oin->in", weights, self._flight)
        return np.einsum("in,ijn->j", by_launch, self._launch)

    def each(self) -> NDArray[Any]:
        """Return the derivatives of every landing, shape (landings, variables, shots)."""
        return np.einsum("oin,ijn->ojn", self._flight, self._launch)


class Landings:
    """The shots of one golfer with clubs that differ from a base in some fields.

    Parameters
    ----------
    base
        The club with which the golfer delivers as sampled.
    deliveries
        Values of the deliveries by name [SI], each of shape (shots,); without a loft it is the club's.
    setting
        Model, ball and air.

    Attributes
    ----------
    count
        The number of shots that are computed.
    missed
        The number of shots that miss the face of the base club; they are left out.
    """

    def __init__(self, base: Club, deliveries: Mapping[str, Any], setting: Setting) -> None:
        self.base, self.setting = base, setting
        with_, self._parameters = equipped(setting.model, base, setting.ball, setting.parameters)
        values = {"loft": base.loft, "lie": 0.0, **deliveries}
        hit, parameters = broadcast(
            shots(with_, values), self._parameters.columns(), tuple(self._parameters.values), len(outputs())
        )
        (number,) = hit.shape or (1,)
        found, problems = core.impact(setting.model, hit.columns, parameters, number, None, setting.threads)
        good = ~np.isnan(found[0])
        self.missed = int(number - good.sum())
        if not good.any():
            name, message = problems[0][1:]
            raise InputError("golfer", name, f"one whose shots can be computed: {message}")
        self._columns = [each if isinstance(each, float) else np.ascontiguousarray(each[good]) for each in hit.columns]
        self._own = parameters
        self.count = int(good.sum())
        self.ball = with_.ball

    def _inputs(self, club: Mapping[str, float]) -> list[Any]:
        """Return the columns of the impacts with a club that differs from the base by the fields given."""
        columns, place = list(self._columns), input_columns()
        for name, value in club.items():
            if name == "loft":
                columns[place["static_loft"]] = value
                columns[place["loft"]] = columns[place["loft"]] + (value - self.base.loft)
            elif name == "lie":
                columns[place["lie"]] = columns[place["lie"]] + value
            elif name == "mass":
                columns[place["club_mass"]] = value
                columns[place["speed"]] = columns[place["speed"]] * self._slower(value)
            else:
                columns[place[name]] = value
        return columns

    def _slower(self, mass: float) -> float:
        return (mass / self.base.mass) ** -self.setting.speed_exponent

    def _flights(self, launches: NDArray[Any], columns: list[Any]) -> list[Any]:
        """Return the columns of the flights of launches, rows in the order of ``LAUNCH``."""
        place = input_columns()
        given: dict[str, Any] = {name: each.default for name, each in flight_inputs().items()}
        given |= {name: columns[place[name]] for name in BALL}
        given |= conditions(self.setting.air, self.setting.wind, self.setting.ground)
        given |= dict(zip(LAUNCH, launches, strict=True))
        return list(given.values())

    def of(self, club: Mapping[str, float]) -> NDArray[Any]:
        """Return the landings [m] with a club that differs by the fields given, shape (landings, shots).

        All are NaN if there is no such club.
        """
        columns = self._inputs(club)
        found, _ = core.impact(self.setting.model, columns, self._own, self.count, None, self.setting.threads)
        names = list(outputs())
        launches = found[[names.index(name) for name in LAUNCH]]
        if np.isnan(launches).any():
            return np.full((len(LANDING), self.count), np.nan)
        flown, _ = core.fly(self._flights(launches, columns), self.count, self.setting.threads)
        return flown[[list(flight_outputs()).index(name) for name in LANDING]]

    def differentiated(self, club: Mapping[str, float], variables: tuple[str, ...]) -> tuple[NDArray[Any], Slopes]:
        """Return the same with the derivatives by fields of the club."""
        columns, place = self._inputs(club), input_columns()
        wanted: dict[str, list[tuple[int, Any]]] = {}
        for name in variables:
            wanted[name] = [(place[each], factor) for each, factor in self._driven(name, club, columns)]
        flat = [column for each in wanted.values() for column, _ in each]
        names = list(outputs())
        found, _ = core.sensitivities(
            self.setting.model, columns, self._own, self.count, [names.index(name) for name in LAUNCH], flat, None,
            self.setting.threads,
        )  # fmt: skip
        table = found.reshape(len(LAUNCH), 1 + len(flat), self.count)
        launch = np.empty((len(LAUNCH), len(variables), self.count))
        start = 1
        for index, each in enumerate(wanted.values()):
            launch[:, index] = sum(table[:, start + i] * factor for i, (_, factor) in enumerate(each))
            start += len(each)
        known, flights = list(flight_outputs()), list(flight_inputs())
        flown, _ = core.fly_sensitivities(
            self._flights(np.ascontiguousarray(table[:, 0]), columns), self.count,
            [known.index(name) for name in LANDING], [flights.index(name) for name in LAUNCH], self.setting.threads,
        )  # fmt: skip
        flown = flown.reshape(len(LANDING), 1 + len(LAUNCH), self.count)
        return flown[:, 0], Slopes(variables, flown[:, 1:], launch)

    def _driven(self, name: str, club: Mapping[str, float], columns: list[Any]) -> list[tuple[str, Any]]:
        """Return the inputs of an impact that a field of the club changes, each with its derivative."""
        if name == "loft":
            return [("loft", 1.0), ("static_loft", 1.0)]
        if name == "mass":
            speed = columns[input_columns()["speed"]]
            slower = -self.setting.speed_exponent * speed / club.get("mass", self.base.mass)
            return [("club_mass", 1.0), ("speed", slower)]
        return [(name, 1.0)]
