"""The straight line from one shot to another, through everything a launch can be differentiated by."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from clubface.simulation.launch import Launch
from clubface.simulation.quantities import inputs

CURVED = ("bulge", "roll")
"""The line goes along their curvature, so that a flat face is one like any other."""
FACE = {"included_time": "characteristic_time"}
"""What is told under another name: both say how much more the face gives than the one that the parameters include."""
UNMOVED = ("face_width", "face_height")
"""They bound the face; no launch depends on them."""


class Point(NamedTuple):
    """One shot as its model takes it.

    Attributes
    ----------
    inputs, parameters
        The values [SI] by name.
    """

    inputs: dict[str, float]
    parameters: dict[str, float]

    @classmethod
    def of(cls, launch: Launch) -> Point:
        """Return the shot of a single launch."""
        given = {name: float(launch.input(name)) for name in inputs()}
        return cls(given, {name: float(value) for name, value in launch.parameters.values.items()})

    def value(self, name: str) -> float:
        """Return the value of an input or a parameter [SI]."""
        return self.inputs[name] if name in self.inputs else self.parameters[name]


class Line(NamedTuple):
    """The line between two shots by the same model.

    Attributes
    ----------
    start, end
        The shots.
    names
        The inputs and parameters that differ.
    """

    start: Point
    end: Point
    names: tuple[str, ...]

    @classmethod
    def between(cls, start: Point, end: Point) -> Line:
        """Return the line from one shot to another."""
        names = [name for name in (*start.inputs, *start.parameters) if name not in UNMOVED]
        return cls(start, end, tuple(name for name in names if start.value(name) != end.value(name)))

    def at(self, share: float) -> Point:
        """Return the shot at a ``share`` of the way."""
        moved = {name: self._value(name, share) for name in self.names}
        return Point(
            {name: moved.get(name, value) for name, value in self.end.inputs.items()},
            {name: moved.get(name, value) for name, value in self.end.parameters.items()},
        )

    def rates(self, share: float) -> Mapping[str, float]:
        """Return how fast each input and parameter that differs changes along the way, at a ``share`` of it."""
        found = {}
        for name in self.names:
            first, last = self.start.value(name), self.end.value(name)
            rate = last - first
            if name in CURVED:
                rate = -(self._value(name, share) ** 2) * (1.0 / last - 1.0 / first)
            found[name] = rate
        return found

    def _value(self, name: str, share: float) -> float:
        first, last = self.start.value(name), self.end.value(name)
        if name in CURVED:
            first, last = 1.0 / first, 1.0 / last
        value = (1.0 - share) * first + share * last
        return 1.0 / value if name in CURVED else value
