"""From the terms of a launch monitor to the vectors a flight begins with."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from clubface import units
from clubface.errors import AssumptionWarning, InputError
from clubface.simulation.inputs import common_shape
from clubface.simulation.quantities import flight_inputs, outputs
from clubface.simulation.spin import SPINS, parts
from clubface.support.checks import check_names
from clubface.support.memory import check_request
from clubface.support.warning import warn_once

MONITOR = ("ball_speed", "launch", "azimuth", *SPINS)
"""What a launch monitor tells, under the names and with the signs of a launch."""


def vectors(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the inputs of a flight for a launch given as vectors or in the terms of a launch monitor.

    Velocity is v (cos(launch) cos(azimuth), sin(launch), cos(launch) sin(azimuth)). Backspin turns about the
    horizontal axis to the right of the launch direction, (-sin(azimuth), 0, cos(azimuth)), sidespin about the
    vertical pointing down; a launch monitor sees no spin about the launch direction, and there is none. Any two spins
    that settle the others will do (:mod:`clubface.simulation.spin`); a warning says what is assumed where none do.
    """
    inputs = flight_inputs()
    known = [*MONITOR, *(name for name, each in inputs.items() if each.group in ("launch", "ball"))]
    check_names("launch value", values, known)
    given = {name: value for name, value in values.items() if name in inputs}
    terms = {
        name: units.parse_values(value, outputs()[name].dimension, name=name)
        for name, value in values.items()
        if name in MONITOR
    }
    mixed = [name for name in given if inputs[name].group == "launch"]
    if terms and mixed:
        raise InputError(mixed[0], values[mixed[0]], "leave it out, since the launch is given as " + ", ".join(terms))
    if not terms:
        for axis in "xyz":
            if f"velocity_{axis}" not in given:
                raise InputError(f"velocity_{axis}", None, "give it, or the launch as ball_speed, launch and so on")
            given.setdefault(f"spin_{axis}", 0.0)
        return given
    return {**given, **_from_terms(terms)}


def _from_terms(terms: dict[str, Any]) -> dict[str, Any]:
    shape = common_shape({name: value for name, value in terms.items() if not isinstance(value, float)})
    check_request(math.prod(shape), 8 * (len(MONITOR) + 6))
    for name in ("ball_speed", "launch"):
        if name not in terms:
            raise InputError(name, None, "give it: a flight cannot start without")
    speed, launch, azimuth = terms["ball_speed"], terms["launch"], terms.get("azimuth", 0.0)
    backspin, sidespin, assumed = parts({name: terms[name] for name in SPINS if name in terms})
    if assumed:
        warn_once(assumed, AssumptionWarning)
    found = {
        "velocity_x": speed * np.cos(launch) * np.cos(azimuth),
        "velocity_y": speed * np.sin(launch),
        "velocity_z": speed * np.cos(launch) * np.sin(azimuth),
        "spin_x": -backspin * np.sin(azimuth),
        "spin_y": -sidespin,
        "spin_z": backspin * np.cos(azimuth),
    }
    return {name: value if getattr(value, "ndim", 0) else float(value) for name, value in found.items()}
