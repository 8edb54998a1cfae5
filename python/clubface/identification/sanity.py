"""Checks of shots and fit: enough information, bounds, contact times and forces."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from clubface import units
from clubface.errors import InputError
from clubface.identification.free_parameters import FreeParameters
from clubface.identification.identifiability import Identifiability, identifiability
from clubface.identification.profile import Profile, outside
from clubface.identification.result import Deviation
from clubface.identification.simulator import Simulator
from clubface.measured.shots import QUANTITIES
from clubface.simulation.quantities import outputs
from clubface.support.arrays import Floats

AT_BOUND = 1e-4
"""A parameter within this part of its range of a bound meets it."""
WORSE, NOTHING = 0.05, 1e-6
"""Part by which a mean absolute error must grow to be called worse; less is the luck of the shots. A change of the
latter part of the mean size is rounding."""
CONTACT_TIME = (350e-6, 600e-6)
"""Mean contact times [s] outside this are unphysical: measured ones are 400 to 500 us."""
PEAK_FORCE = (8e3, 17e3)
"""Mean peak forces [N] outside this, at 50 m/s, are unphysical: measured drives reach 10 to 14 kN."""
REFERENCE_SPEED, SPEED_POWER = 50.0, 1.2
"""Hertz: the peak force grows with the speed [m/s] to the power 6/5."""


def check_information(simulator: Simulator, point: Floats, noise: Floats) -> list[str]:
    """Refuse shots that cannot determine the free parameters, and return remarks about few shots.

    The message names what the shots leave open. ``point`` is one at which the parameters are tried, such as that of the
    published set.
    """
    shots, free = simulator.shots, simulator.free
    different = shots.different()
    if different < 2:
        what = "the number of shots" if len(shots) == 1 else f"the number of different ones among {len(shots)} shots"
        advice = "at least two, with different deliveries: one shot leaves nothing to judge the fit by"
        open_ = _open(simulator.of(shots.select(np.array([0]))), point, noise)  # copies tell no more than one
        raise InputError(what, different, advice + (f". It does not determine: {open_}" if open_ else ""))
    kinds = int(np.isfinite(shots.launches).any(axis=1).sum())
    distinct = shots.distinct_deliveries()
    values = min(int(np.isfinite(shots.launches).sum()), kinds * distinct)
    notes = []
    if distinct == 1:
        notes.append(f"all {len(shots)} shots have the same delivery: how the launch depends on it is not tested")
    if different < len(shots):
        notes.append(f"only {different} of {len(shots)} shots are different: if the others are copies, take them out")
    if values < len(free):
        same = f", since all {len(shots)} shots have the same delivery" if distinct == 1 else ""
        raise InputError(
            "the number of free parameters", len(free),
            f"at most {values}, as many as there are different measured values{same}. Not determined:"
            f" {_open(simulator, point, noise)}",
        )  # fmt: skip
    if len(shots) < 5 * len(free):
        notes.append(f"{len(shots)} shots are few for {len(free)} parameters: intervals are rough")
    return notes


def _open(simulator: Simulator, point: Floats, noise: Floats) -> str:
    """Name the directions that the shots leave open."""
    told = identifiability(simulator, point, noise)
    return "; ".join(each.words for each in told.directions if each.strength in ("none", "unknown"))


def fit_warnings(simulator: Simulator, point: Floats, told: Identifiability, costs: list[float]) -> list[str]:
    """Return the warnings about a fit: bounds met, unphysical contacts, what is not identified, a doubtful search."""
    free = simulator.free
    found = list(_bounds(free, point)) + _contacts(simulator, point)
    for each in told.directions:
        if each.strength in ("none", "unknown"):
            found.append(f"not identified: {each.words}")
    best = min(costs)
    if len(costs) > 1 and sum(cost <= best * (1.0 + 1e-3) + 1e-12 for cost in costs) == 1:
        second = sorted(costs)[1]
        found.append(
            f"only one of {len(costs)} refinements reached the least cost, {best:.6g} (the next {second:.6g}): another"
            " seed or more generations may find a better fit"
        )
    return found


def apart(intervals: Mapping[str, tuple[float, float]], profiles: Mapping[str, Profile]) -> list[str]:
    """Return a warning if the fit and the least-squares fit, to which the profiles belong, exclude each other."""
    names = [
        name
        for name, each in profiles.items()
        if each.interval[0] > intervals[name][1] or each.interval[1] < intervals[name][0]
    ]
    if not names:
        return []
    return [
        f"the likelihood puts {', '.join(names)} outside the interval: the model does not describe these shots, so that"
        " its parameters depend on what the fit is judged by"
    ]


def at_bound(free: FreeParameters, point: Floats) -> tuple[str, ...]:
    """Return the names of the parameters that meet a bound."""
    return tuple(name for name, place in zip(free.names, point, strict=True) if _meets(place))


def contradicted(
    values: Mapping[str, float], intervals: Mapping[str, tuple[float, float]], profiles: Mapping[str, Profile]
) -> list[str]:
    """Return a warning of parameters [SI] whose interval, or that of their profile, does not hold their value."""
    names = [name for name in intervals if outside(float(values[name]), intervals[name], profiles.get(name))]
    if not names:
        return []
    return [
        f"outside of their own interval: {', '.join(names)}; fits to parts of the shots, or the likelihood, lead"
        " elsewhere, so that neither value nor interval can be trusted"
    ]


def worse(deviations: Mapping[str, Deviation], before: str) -> list[str]:
    """Return a warning of the quantities that the fit makes worse than the set called ``before``."""
    told = []
    for name, each in deviations.items():
        if each.mae > (1.0 + WORSE) * each.mae_before + NOTHING * each.mean:
            unit = QUANTITIES.get(name) or units.display_unit(name, outputs()[name].unit)
            after, then = (units.from_si(value, unit) for value in (each.mae, each.mae_before))
            told.append(f"{name} (MAE {after:.3g} {unit}, {then:.3g} {unit} before)")
    if not told:
        return []
    return [f"the fit makes some quantities worse than {before}, with which it began: {', '.join(told)}"]


def _meets(place: float) -> bool:
    return place < AT_BOUND or place > 1.0 - AT_BOUND


def _bounds(free: FreeParameters, point: Floats) -> list[str]:
    found = []
    for each, place, low, high in zip(free.declared(), point, free.lower, free.upper, strict=True):
        side, bound = ("lower", low) if place < AT_BOUND else ("upper", high)
        if _meets(place):
            shown = units.show(float(bound), units.display_unit(each.name, each.unit), 4)
            found.append(f"{each.name} meets its {side} bound, {shown}: the best value may lie beyond it")
    return found


def _contacts(simulator: Simulator, point: Floats) -> list[str]:
    times, forces = simulator.contact(point)
    if not np.isfinite(times).all():
        return []
    found = []
    time, force = float(np.mean(times)), float(np.mean(forces))
    if not CONTACT_TIME[0] <= time <= CONTACT_TIME[1]:
        found.append(f"contact lasts {units.fixed(time, 'us', 0)} on average; measured contacts last 400 to 500 us")
    scale = (simulator.shots.mean("speed") / REFERENCE_SPEED) ** SPEED_POWER
    low, high = (limit * scale for limit in PEAK_FORCE)
    if not low <= force <= high:
        usual = f"{10 * scale:.0f} to {14 * scale:.0f} kN"
        found.append(
            f"the normal force peaks at {units.fixed(force, 'kN', 1)} on average; measured impacts of this"
            f" speed at {usual}"
        )
    return found
