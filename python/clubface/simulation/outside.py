"""Shots outside what their model or its parameters were made for: found, counted, and told in one line."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from clubface import units
from clubface.equipment.balls import DEFAULT_BALL, Ball
from clubface.equipment.ranges import QUANTITIES, ends_in_words
from clubface.errors import RangeWarning
from clubface.simulation.quantities import input_columns
from clubface.support.warning import is_silent, warn_once

if TYPE_CHECKING:
    from clubface.simulation.launch import Launch

WITHOUT_GEAR_EFFECT = ("jorgensen",)
"""The models in which a head that turns back does not turn the ball."""
OFF_CENTRE = "off centre"
"""What stands for a quantity where a ball is struck beside the face centre by a model without gear effect."""
FITTED_TO_A_BALL = ("response",)
"""The models whose parameters are coefficients for the ball ``DEFAULT_BALL``, unless another ball has its own."""
OTHER_BALL = "ball"
"""What stands for a quantity where a ball of other pieces has none."""
ROUNDING = 1e-9
"""Part of a range by which a value that is converted from another unit may miss its ends."""


class Tally:
    """Counts launches and those of them that are outside, by model, over any number of batches."""

    def __init__(self) -> None:
        self._shots: dict[str, int] = {}
        self._found: dict[tuple[str, str], tuple[str, int, float]] = {}

    def add(self, launch: Launch) -> None:
        """Count the shots of a launch."""
        model = launch.model
        self._shots[model] = self._shots.get(model, 0) + math.prod(launch.shape)
        for name, (count, value) in _outside(launch).items():
            ends = ends_in_words(name, launch.parameters.range) if name in QUANTITIES else launch.ball.name
            before = self._found.get((model, name), (ends, 0, value))[1]
            self._found[model, name] = (ends, before + count, value)

    def add_all(self, launches: Iterable[Launch]) -> Tally:
        """Count the shots of several launches; return the tally itself."""
        for each in launches:
            self.add(each)
        return self

    def counts(self) -> list[Any]:
        """Return what is counted, made of what JSON has."""
        return [self._shots, [[*key, *found] for key, found in self._found.items()]]

    def add_counts(self, counts: Sequence[Any]) -> None:
        """Add what another tally counted."""
        shots, found = counts
        for model, count in shots.items():
            self._shots[model] = self._shots.get(model, 0) + count
        for model, name, ends, count, value in found:
            before = self._found.get((model, name), (ends, 0, value))[1]
            self._found[model, name] = (ends, before + count, value)

    def remark(self, *, counted: bool = True) -> str:
        """Return what a reader must know in one line, "" if no shot is outside.

        One shot is told with its values, several with their number, or without where they are not ``counted``.
        """
        alike: dict[str, list[str]] = {}
        for model in self._shots:
            if told := ", ".join(self._part([model], name, counted=False) for name in self._names(model)):
                alike.setdefault(told, []).append(model)
        parts = []
        for told, models in alike.items():
            names = self._names(models[0])
            told = ", ".join(self._part(models, name, counted=True) for name in names) if counted else told
            parts.append(f"outside the range of {', '.join(models)}: {told}")
        for (model, name), (ball, *_) in self._found.items():
            if name == OFF_CENTRE:
                parts.append(f"{model} has no gear effect off centre")
            elif name == OTHER_BALL:
                parts.append(f"{model} has no coefficients of the ball {ball} and takes those of {DEFAULT_BALL}")
        return "; ".join(parts)

    def warn(self) -> None:
        """Warn in one line if shots are outside; the same of the same models only once in a process."""
        if text := self.remark():
            warn_once(text, RangeWarning, key=self.remark(counted=False))

    def _names(self, model: str) -> list[str]:
        """Return the quantities in which shots of a model are outside."""
        return [name for name in QUANTITIES if (model, name) in self._found]

    def _part(self, models: list[str], name: str, *, counted: bool) -> str:
        """Return what is to be said of one quantity of models with the same range."""
        words, unit = QUANTITIES[name]
        ends, _, value = self._found[models[0], name]
        # The same shots by several models, or else other shots by each.
        numbers = {(self._found[each, name][1], self._shots[each]) for each in models}
        count, shots = numbers.pop() if len(numbers) == 1 else map(sum, zip(*numbers, strict=True))
        how = f"{units.show(value, unit, 4)} " if shots == 1 else f"in {count} of {shots} shots "
        return f"{words} {how if counted else ''}({ends})"


def warn_if_outside(launches: Iterable[Launch]) -> None:
    """Warn as a tally of the launches does."""
    if is_silent(RangeWarning):
        return
    Tally().add_all(launches).warn()


def _outside(launch: Launch) -> dict[str, tuple[int, float]]:
    """Return by quantity how many shots of a launch are outside, and the value of the first of them."""
    found = {}
    for name, (least, most) in launch.parameters.range.items():
        margin = ROUNDING * (most - least)
        value = _incidence(launch, most) if name == "incidence" else _value(launch, name)
        if type(value) is float:
            if value < least - margin or value > most + margin:
                found[name] = (math.prod(launch.shape), value)
        elif value.size and not (value.min() >= least - margin and value.max() <= most + margin):
            out = (value < least - margin) | (value > most + margin)
            out &= launch.ball_speed.reshape(-1) > 0.0  # a shot that cannot be computed is told otherwise
            if out.any():
                found[name] = (int(out.sum()), float(value[out][0]))
    if launch.model in WITHOUT_GEAR_EFFECT and _any(launch.input("toe"), launch.input("high")):
        found[OFF_CENTRE] = (1, 0.0)
    if launch.model in FITTED_TO_A_BALL and launch.parameters.unchosen and _is_of_other_pieces(launch.ball):
        found[OTHER_BALL] = (1, 0.0)
    return found


def _is_of_other_pieces(ball: Ball) -> bool:
    """Return whether a ball is known to differ from that of the coefficients, and has none of its own."""
    return ball.construction is not None and ball.name != DEFAULT_BALL and not ball.parameters.keys() & FITTED_TO_A_BALL


def _value(launch: Launch, name: str) -> Any:
    """Return a quantity of a range: a number, or an array of the shots, flat."""
    value = launch.input(name) if name in input_columns() else launch.parameters.values.get(name, 0.0)
    if type(value) is float or value.shape == (math.prod(launch.shape),):
        return value
    import numpy as np

    return np.broadcast_to(value, launch.shape).reshape(-1)


def _incidence(launch: Launch, limit: float) -> Any:
    """Return the angle [rad] between path and face normal, or 0 if it is certainly below the ``limit``.

    No side of a triangle on a sphere is longer than the two others together, which saves its cosine nearly always.
    """
    attack, path, loft, face = (launch.input(name) for name in ("attack", "path", "loft", "face"))
    apart, aside = loft - attack, path - face
    bound = abs(apart) + abs(aside)
    if (bound if type(bound) is float else bound.max(initial=0.0)) <= limit:
        return 0.0
    import numpy as np

    cosine = np.cos(attack) * np.cos(loft) * np.cos(aside) + np.sin(attack) * np.sin(loft)
    angle = np.arccos(np.clip(cosine, -1.0, 1.0))
    return angle if np.ndim(angle) else float(angle)


def _any(*values: Any) -> bool:
    return any(value != 0.0 if type(value) is float else bool((value != 0.0).any()) for value in values)
