"""Golf balls: from TOML, from code or built in, checked.

The ball called ``published`` is that of "Three-dimensional golf clubhead-ball impact models for drivers and
irons", Table 1; ``conforming`` is at the limits of the rules.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar, Self

from clubface import units
from clubface.equipment.core import check_body
from clubface.equipment.described import Described, Property, set_si, template_lines, to_toml
from clubface.errors import RuleWarning
from clubface.support.checks import check_name, check_text
from clubface.support.shipped import builtin_names, builtin_path, is_path
from clubface.support.strict_toml import quoted
from clubface.support.warning import warn_once, without_warnings

DEFAULT_BALL = "published"
"""The ball of the published models and their parameters."""
BALL_MASS_LIMIT = 45.93e-3
"""kg, at most (1.620 oz); The Equipment Rules."""
BALL_DIAMETER_LIMIT = 42.67e-3
"""m, at least (1.680 in); The Equipment Rules."""

BALL_PROPERTIES = {
    "mass": Property("mass", "g", "mass", "45.93 g"),
    "radius": Property("length", "mm", "radius", "21.335 mm"),
    "inertia": Property("inertia", "g cm2", "moment of inertia about the centre", "83.6 g cm2"),
}


@dataclass(frozen=True, kw_only=True)
class Ball(Described):
    """A golf ball, SI.

    Attributes
    ----------
    name
        What it is called in tables.
    mass
        [kg].
    radius
        [m].
    inertia
        Moment of inertia about the centre [kg m2].
    description
        A sentence for lists.
    sources
        Where each value comes from, by field name.
    """

    name: str
    mass: float
    radius: float
    inertia: float
    description: str = ""
    sources: Mapping[str, str] = field(default_factory=dict, hash=False)
    properties: ClassVar = BALL_PROPERTIES

    def __post_init__(self) -> None:
        set_si(self, BALL_PROPERTIES)
        check_name(self.name)
        check_text("description", self.description)
        check_body("ball", self.inputs())
        if self.mass > BALL_MASS_LIMIT * (1.0 + 1e-9):
            warn_once(
                f"{self.name}: ball mass {units.fixed(self.mass, 'g', 2)} is above the rule limit of 45.93 g",
                RuleWarning,
            )
        if 2.0 * self.radius < BALL_DIAMETER_LIMIT * (1.0 - 1e-9):
            warn_once(
                f"{self.name}: ball diameter {self.radius * 2e3:.2f} mm is below the rule limit of 42.67 mm",
                RuleWarning,
            )

    def inputs(self) -> dict[str, float]:
        """Return the values the models take, SI, under the core's names and in its order."""
        return {f"ball_{key}": getattr(self, key) for key in BALL_PROPERTIES}

    def to_toml(self) -> str:
        """Write the ball as TOML text, which :meth:`from_text` reads back exactly."""
        return to_toml(self, BALL_PROPERTIES, {})

    @classmethod
    def builtin(cls, name: str) -> Self:
        """Return a ball that comes with the package, such as ``"conforming"``."""
        return cls.from_toml(builtin_path("ball", name, "balls"))

    @staticmethod
    def template(name: str = "my-ball") -> str:
        """Return TOML text to start one's own ball from, every key explained."""
        check_name(name)
        head = [
            "# A ball. A value is text with a unit; a bare number is SI (kg, m, kg m2).",
            f"name = {quoted(name)}",
            'description = ""',
            "",
        ]
        return "\n".join(head + template_lines(BALL_PROPERTIES))


def ball(which: str | os.PathLike[str] | Ball | None = None) -> Ball:
    """Return the ball meant by a built-in name, the path of a TOML file, or a :class:`Ball` itself.

    Without a name it is that of the published models. Its diameter is 0.07 mm below the limit of the rules, which is
    said when it is asked for by name.
    """
    if which is None:
        with without_warnings():
            return Ball.builtin(DEFAULT_BALL)
    if isinstance(which, Ball):
        return which
    return Ball.from_toml(which) if is_path(which) else Ball.builtin(str(which))


def ball_names() -> tuple[str, ...]:
    """List the built-in balls."""
    return builtin_names("balls")
