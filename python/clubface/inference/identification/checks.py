"""Checks of shots and fits: enough information, bounds, contact times and forces."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from clubface import units
from clubface.errors import InputError
from clubface.inference.identification.intervals import Identifiability, Profile, identifiability, outside
from clubface.inference.identification.problem import FreeParameters
from clubface.inference.identification.result import Deviation
from clubface.inference.identification.simulator import Simulator
from clubface.quantities import display_unit
from clubface.results.notes import Note, note
from clubface.shots.measured import QUANTITIES
from clubface.simulation.results import outputs
from clubface.support.arrays import Floats

AT_BOUND = 1e-4
"""A parameter closer to a bound than this fraction of its range counts as at the bound."""
WORSE, NOTHING = 0.05, 1e-6
"""Relative growth of a mean absolute error above which it counts as worse, smaller changes being chance; and change
relative to the mean value below which it is rounding."""
CONTACT_TIME = (350e-6, 600e-6)
"""Range of physical mean contact times [s]; measured ones are 400 to 500 us."""
PEAK_FORCE = (8e3, 17e3)
"""Range of physical mean peak forces [N] at 50 m/s; measured drives reach 10 to 14 kN."""
REFERENCE_SPEED, SPEED_POWER = 50.0, 1.2
"""Hertz: the peak force grows with the speed [m/s] to the power 6/5."""


def check_information(simulator: Simulator, point: Floats, noise: Floats) -> list[Note]:
    """Raise InputError for shots that cannot determine the free parameters; return notes about few shots.

    The message names the undetermined directions. ``point`` is a trial point of the parameters, such as the published
    set.
    """
    shots, free = simulator.shots, simulator.free
    different = shots.different()
    if different < 2:
        what = "the number of shots" if len(shots) == 1 else f"the number of different ones among {len(shots)} shots"
        advice = "at least two, with different deliveries: a single shot cannot show how good the fit is"
        alone = simulator.of(shots.select(np.array([0])))  # copies add nothing to one
        left = _undetermined_directions(alone, point, noise)
        raise InputError(what, different, advice + (f". It does not determine: {left}" if left else ""))
    kinds = int(np.isfinite(shots.launches).any(axis=1).sum())
    distinct = shots.distinct_deliveries()
    values = min(int(np.isfinite(shots.launches).sum()), kinds * distinct)
    if values < len(free):
        same = f", since all {len(shots)} shots have the same delivery" if distinct == 1 else ""
        raise InputError(
            "the number of free parameters", len(free),
            f"at most {values}, as many as there are different measured values{same}. Not determined:"
            f" {_undetermined_directions(simulator, point, noise)}",
        )  # fmt: skip
    notes = []
    if distinct == 1:
        notes.append(note("fit-same-delivery", shots=len(shots)))
    if different < len(shots):
        notes.append(note("fit-copied-shots", different=different, shots=len(shots)))
    if len(shots) < 5 * len(free):
        notes.append(note("fit-few-shots", shots=len(shots), free=len(free)))
    return notes


def _undetermined_directions(simulator: Simulator, point: Floats, noise: Floats) -> str:
    """Describe the directions in parameter space that the shots do not determine."""
    directions = identifiability(simulator, point, noise).directions
    return "; ".join(each.words for each in directions if each.strength in ("none", "unknown"))


def fit_warnings(
    simulator: Simulator,
    point: Floats,
    information: Identifiability,
    costs: list[float],
    deviations: Mapping[str, Deviation],
    intervals: Mapping[str, tuple[float, float]],
    profiles: Mapping[str, Profile],
) -> tuple[Note, ...]:
    """Return the warnings about a fit: worse quantities, bounds, contacts, open directions, a doubtful search."""
    free = simulator.free
    notes = [*worse(deviations, free.fixed.name), *bounds_met(free, point), *unphysical_contacts(simulator, point)]
    notes += [
        note("fit-not-identified", direction=each.words)
        for each in information.directions
        if each.strength in ("none", "unknown")
    ]
    least, *others = sorted(costs)
    if others and others[0] > least * (1.0 + 1e-3) + 1e-12:
        notes.append(note("fit-one-refinement", refinements=len(costs), least=least, next=others[0]))
    excluded = [
        name
        for name, each in profiles.items()
        if each.interval[0] > intervals[name][1] or each.interval[1] < intervals[name][0]
    ]
    if excluded:
        notes.append(note("fit-likelihood-elsewhere", names=excluded))
    values = dict(zip(free.names, free.values(point).tolist(), strict=True))
    return (*notes, *contradicted(values, intervals, profiles))


def at_bound(free: FreeParameters, point: Floats) -> tuple[str, ...]:
    """Return the names of the parameters at a bound."""
    return tuple(name for name, place in zip(free.names, point, strict=True) if _is_at_bound(place))


def contradicted(
    values: Mapping[str, float], intervals: Mapping[str, tuple[float, float]], profiles: Mapping[str, Profile]
) -> list[Note]:
    """Return a warning about parameters [SI] whose interval or profile interval does not contain their value."""
    names = [name for name in intervals if outside(float(values[name]), intervals[name], profiles.get(name))]
    return [note("fit-contradicted", names=names)] if names else []


def worse(deviations: Mapping[str, Deviation], before: str) -> list[Note]:
    """Return a warning about quantities that the fit predicts worse than the set ``before``."""
    names = []
    for name, each in deviations.items():
        if each.mae > (1.0 + WORSE) * each.mae_before + NOTHING * each.mean:
            unit = QUANTITIES.get(name) or display_unit(name, outputs()[name].unit)
            after, then = (units.from_si(value, unit) for value in (each.mae, each.mae_before))
            names.append(f"{name} (MAE {after:.3g} {unit}, {then:.3g} {unit} before)")
    return [note("fit-worse", before=before, names=names)] if names else []


def _is_at_bound(place: float) -> bool:
    return place < AT_BOUND or place > 1.0 - AT_BOUND


def bounds_met(free: FreeParameters, point: Floats) -> list[Note]:
    """Return a warning for each parameter at a bound of the search."""
    notes = []
    for each, place, low, high in zip(free.declared(), point, free.lower, free.upper, strict=True):
        if _is_at_bound(place):
            side, bound = ("lower", low) if place < AT_BOUND else ("upper", high)
            shown = units.show(float(bound), display_unit(each.name, each.unit), 4)
            notes.append(note("fit-at-bound", parameter=each.name, side=side, bound=shown))
    return notes


def unphysical_contacts(simulator: Simulator, point: Floats) -> list[Note]:
    """Return warnings about contact times and peak forces outside the measured range."""
    times, forces = simulator.contact(point)
    if not np.isfinite(times).all():
        return []
    notes = []
    time, force = float(np.mean(times)), float(np.mean(forces))
    if not CONTACT_TIME[0] <= time <= CONTACT_TIME[1]:
        notes.append(note("fit-contact-time", contact_time=time))
    scale = (simulator.shots.mean("speed") / REFERENCE_SPEED) ** SPEED_POWER
    low, high = (limit * scale for limit in PEAK_FORCE)
    if not low <= force <= high:
        usual = {"least_peak_force": 10e3 * scale, "most_peak_force": 14e3 * scale}
        notes.append(note("fit-peak-force", peak_force=force, **usual))
    return notes
