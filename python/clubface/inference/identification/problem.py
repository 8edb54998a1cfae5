"""The identification problem: free parameters scaled to a unit cube, and shots as inputs of the core."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import Parameter, model as model_named
from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError, RangeWarning, UnknownNameError
from clubface.inference.evaluation.statistics import group_labels
from clubface.results.notes import Note, note
from clubface.results.result import Provenance
from clubface.schema import Document
from clubface.shots.loft_origin import LoftOrigin
from clubface.shots.measured import DELIVERY, QUANTITIES, SOLVED, measured_shots
from clubface.shots.reading import read
from clubface.shots.recorded import RecordedShots, RejectedRow
from clubface.simulation.impact import impact
from clubface.simulation.launch_conditioned import impact_at_launch
from clubface.simulation.provenance import provenance_of
from clubface.simulation.results import input_columns, inputs, outputs
from clubface.support.arrays import Floats
from clubface.support.checks import Frozen, check_choice, check_names, without_warnings
from clubface.support.files import DATA

ALL = "all"
"""Selects every parameter of the model."""

DECADE = 10.0
"""A positive parameter whose bounds differ by more than this factor is searched on a logarithmic scale."""


@dataclass(frozen=True, kw_only=True, eq=False)
class FreeParameters:
    """The parameters to identify; the others keep the values of a parameter set.

    A point of the search has one coordinate per free parameter, from 0 at the lower to 1 at the upper bound, linear in
    the value or, if the bounds span more than a decade, in its logarithm.
    """

    fixed: ParameterSet  # with the values of all other parameters
    names: tuple[str, ...]  # in the order of the registry
    lower: Floats  # bounds [SI], shape (free,)
    upper: Floats
    logarithmic: NDArray[np.bool_]  # whether each is searched on a logarithmic scale, shape (free,)
    tied: Mapping[str, str]  # parameters that follow a free one, by name

    def __len__(self) -> int:
        return len(self.names)

    def values(self, points: Floats) -> Floats:
        """Return the parameter values [SI] at points of the unit cube, both of shape (..., free)."""
        low, high = self._scaled(self.lower), self._scaled(self.upper)
        scaled = low + points * (high - low)
        values = np.where(self.logarithmic, np.exp(np.where(self.logarithmic, scaled, 0.0)), scaled)
        return np.clip(values, self.lower, self.upper)

    def points(self, values: Floats) -> Floats:
        """Return the points of the unit cube at parameter values [SI], both of shape (..., free)."""
        low, high = self._scaled(self.lower), self._scaled(self.upper)
        return np.clip((self._scaled(values) - low) / (high - low), 0.0, 1.0)

    def slopes(self, points: Floats) -> Floats:
        """Return the derivatives of the values with respect to the coordinates, shape (..., free)."""
        ranges = self._scaled(self.upper) - self._scaled(self.lower)
        return np.where(self.logarithmic, self.values(points), 1.0) * ranges

    def columns(self, points: Floats, shots: int) -> list[Any]:
        """Return the core's parameter columns for points of shape (n, free), each repeated for all shots."""
        values = self.values(points)
        return [value if place is None else np.repeat(values[:, place], shots) for place, value in self._places()]

    def single(self, point: Floats) -> list[float]:
        """Return the value of every parameter at one point, in the order of the core."""
        values = self.values(point)
        return [value if place is None else float(values[place]) for place, value in self._places()]

    def driven(self) -> list[list[int]]:
        """Return, for each free parameter, the registry indices of itself and its followers."""
        places = [place for place, _ in self._places()]
        return [[index for index, place in enumerate(places) if place == free] for free in range(len(self))]

    def parameters(self, point: Floats, **labels: Any) -> ParameterSet:
        """Return the parameter set at one point; ``labels`` are its name, source and the like."""
        values = dict(zip(self.fixed.values, self.single(point), strict=True))
        kept = {name: getattr(self.fixed, name) for name in ("model", "club", "includes_face", "characteristic_time")}
        return ParameterSet(values=values, **kept, **labels)

    def declared(self) -> list[Parameter]:
        """Return the registry entries of the free parameters."""
        return [model_named(self.fixed.model).parameter(name) for name in self.names]

    def _places(self) -> list[tuple[int | None, float]]:
        """Return the place among the free parameters that gives each parameter, if one does, and its fixed value."""
        place_of = {name: place for place, name in enumerate(self.names)}
        return [(place_of.get(self.tied.get(name, name)), value) for name, value in self.fixed.values.items()]

    def _scaled(self, values: Floats) -> Floats:
        """Return the logarithms of values searched on a logarithmic scale, the others as they are."""
        return np.where(self.logarithmic, np.log(np.where(self.logarithmic, values, 1.0)), values)


def free_parameters(
    fixed: ParameterSet,
    names: str | Iterable[str] | None = None,
    *,
    bounds: Mapping[str, Any] | None = None,
    tied: Mapping[str, str] | None = None,
) -> FreeParameters:
    """Choose the free parameters of a model; ``fixed`` holds the values of the others.

    ``names`` are the free parameters, or "all". Default: those identified in the publication, with its ``tied``
    parameters, which follow a free one. ``bounds`` are pairs of values by name, text with a unit or SI. Default: those
    of ``identification.toml``, else of the model.
    """
    declared = model_named(fixed.model)
    everything = [each.name for each in declared.parameters]
    default = published_choice(fixed.model)
    if names is None:
        names = default[0] or everything
        tied = default[1] if tied is None else tied
    elif names == ALL:
        names = everything
    asked = [names] if isinstance(names, str) else list(names)
    for name in asked:
        declared.parameter(name)
    if not asked:
        raise InputError("free", asked, "at least one parameter of " + ", ".join(everything))
    tied = dict(tied or {})
    for follower, leader in tied.items():
        declared.parameter(follower)
        check_choice(f"free parameter for {follower} to follow", leader, asked)
        if follower in asked:
            raise InputError(f"tied {follower}", leader, "a parameter that is not free itself")
    chosen = [each for each in declared.parameters if each.name in asked]
    check_names("free parameter with bounds", bounds or {}, asked)
    given = {**default[2], **(bounds or {})}
    pairs = np.array([_bounds(each, given.get(each.name), tied, fixed.model) for each in chosen])
    lower, upper = pairs[:, 0], pairs[:, 1]
    return FreeParameters(
        fixed=fixed, names=tuple(each.name for each in chosen), lower=lower, upper=upper,
        logarithmic=(lower > 0.0) & (upper > DECADE * lower), tied=Frozen(tied),
    )  # fmt: skip


@cache
def published_choice(model: str) -> tuple[tuple[str, ...], Mapping[str, str], Mapping[str, list[str]]]:
    """Return the parameters identified in the publication of a model (empty: all), its ties, and bounds."""
    document = Document.read(DATA / "identification.toml")
    entry = document.data.get(model, {})
    tied, bounds = (Frozen(entry.get(key, {})) for key in ("tied", "bounds"))
    return tuple(entry.get("free", ())), tied, bounds


def _bounds(parameter: Parameter, given: Any, tied: Mapping[str, str], model: str) -> tuple[float, float]:
    """Return the bounds of one parameter: the given ones, within the registry's bounds for it and its followers."""
    followers = [model_named(model).parameter(name) for name, leader in tied.items() if leader == parameter.name]
    low = max(each.lower for each in (parameter, *followers))
    high = min(each.upper for each in (parameter, *followers))
    if given is None:
        return low, high
    dimension = units.unit(parameter.unit, name=parameter.name).dimension
    try:
        first, second = given
    except (TypeError, ValueError):
        raise InputError(f"bounds of {parameter.name}", given, "a pair of bounds, the lower one first") from None
    pair = tuple(units.parse(each, dimension, name=f"bound of {parameter.name}") for each in (first, second))
    if not low <= pair[0] < pair[1] <= high:
        allowed = f"increasing, within {units.show(low, parameter.unit)} to {units.show(high, parameter.unit)}"
        raise InputError(f"bounds of {parameter.name}", given, allowed)
    return pair[0], pair[1]


@dataclass(frozen=True, kw_only=True, eq=False)
class PreparedShots:
    """Measured deliveries and launches of one club and ball, as inputs of the core.

    ``start`` holds the launch angles, or launch angles and azimuths [rad], that every parameter set meets, shape (1 or
    2, shots). Loft and face angle in the columns are then those with which the initial parameters meet them. For a
    comparison at the measured delivery its shape is (0, shots).
    """

    club: Club
    ball: Ball
    columns: list[Any]  # one per input of the core: a number, or an array of shape (shots,)
    quantities: tuple[str, ...]  # names of the launch quantities
    launches: Floats  # measured values [SI], shape (quantities, shots); NaN where not measured
    start: Floats
    rows: NDArray[np.int64]  # row of each shot in its source
    groups: NDArray[np.int64]  # group number of each shot, from 0; a group is held out and resampled together
    source: str
    dropped: tuple[RejectedRow, ...] = ()
    notes: tuple[Note, ...] = ()  # on assumptions about the shots
    loft_origins: tuple[LoftOrigin, ...] = ()
    provenance: Provenance = field(default_factory=Provenance)  # of the launches with the initial parameters

    def __len__(self) -> int:
        return self.launches.shape[1]

    def select(self, chosen: NDArray[Any]) -> Self:
        """Return some of the shots, by mask or indices."""
        columns = [each if isinstance(each, float) else np.ascontiguousarray(each[chosen]) for each in self.columns]
        launches, start = (np.ascontiguousarray(each[:, chosen]) for each in (self.launches, self.start))
        rows, groups = self.rows[chosen], self.groups[chosen]
        return replace(self, columns=columns, launches=launches, start=start, rows=rows, groups=groups)

    def output_places(self) -> list[int]:
        """Return the indices of the quantities and of the met values among the core's outputs."""
        order = list(outputs())
        return [order.index(name) for name in (*self.quantities, *self.met)]

    @property
    def met(self) -> list[str]:
        """Names of the launch values that every parameter set meets exactly."""
        return list(SOLVED)[: len(self.start)]

    def solved_columns(self) -> list[int]:
        """Return the columns of the inputs that are solved for to meet these values."""
        return [input_columns()[SOLVED[name]] for name in self.met]

    def distinct_deliveries(self) -> int:
        """Return the number of shots with different inputs."""
        varied = [each for each in self.columns if not isinstance(each, float)]
        return len(np.unique(np.array(varied), axis=1).T) if varied else 1

    def different(self) -> int:
        """Return the number of shots that differ in any measured value."""
        varied = [each for each in self.columns if not isinstance(each, float)]
        return len(np.unique(np.array([*varied, *np.nan_to_num(self.launches)]), axis=1).T)

    def mean(self, name: str) -> float:
        """Return the mean of an input over the shots [SI]."""
        return float(np.mean(self.columns[input_columns()[name]]))


def prepared_shots(
    given: RecordedShots | str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club,
    ball: str | os.PathLike[str] | Ball | None = None,
    only: str | None = None,
    mismatch: str = "refuse",
    quantities: Iterable[str] | None = None,
    groups: Any = None,
    parameters: ParameterSet,
    compared_at: str = DELIVERY,
) -> PreparedShots:
    """Prepare recorded shots for the core, excluding those that the model cannot compute with ``parameters``.

    Other arguments are as for :func:`clubface.identify`; without labels, every shot is a group of its own.
    """
    recorded = given if isinstance(given, RecordedShots) else read(given)
    labels = None if groups is None else group_labels(groups, len(recorded))
    compared = tuple(name for name in QUANTITIES if compared_at == DELIVERY or name not in SOLVED)
    asked = compared if quantities is None else _check_quantities(quantities)
    if met := set(asked) & set(SOLVED) - set(compared):
        allowed = f"quantities other than those met at the launch: {', '.join(compared)}"
        raise InputError("quantities", min(met), allowed)
    measured = measured_shots(
        recorded, club=club, only=only, mismatch=mismatch, quantities=asked, compared_at=compared_at
    )
    there = tuple(name for name, values in measured.launch.items() if np.isfinite(values).any())
    missing = [name for name in asked if name not in there]
    if missing and quantities is not None:
        allowed = f"measured quantities; those of {measured.source} are {', '.join(there)}"
        raise InputError("quantities", ", ".join(missing), allowed)
    notes = [note("not-in-the-cost", names=missing)] if missing else []
    launches = np.array([measured.launch[name] for name in there])
    how: dict[str, Any] = {"model": parameters.model, "parameters": parameters, "ball": ball}
    problems: dict[int, str] = {}
    with without_warnings(RangeWarning):  # from the initial parameters
        if measured.start:
            solved = impact_at_launch(measured.club, measured.delivery, **measured.start, **how)
            launch = solved.launch
            for row in np.flatnonzero(np.isnan(solved.loft)):
                problems[int(row)] = "no loft gives the measured launch"
        else:
            launch = impact(measured.club, measured.delivery, **how, on_error="nan")
    for each in launch.problems:
        problems.setdefault(each.row[0] if each.row else 0, f"{each.parameter}: {each.reason}")
    infinite = np.flatnonzero(np.isinf(launches).any(axis=0))
    problems.update({int(row): "a launch quantity is infinite" for row in infinite})
    kept = np.array([row for row in range(len(measured)) if row not in problems], dtype=np.intp)
    dropped = [RejectedRow(int(measured.rows[row]), reason) for row, reason in sorted(problems.items())]
    if not len(kept):
        reasons = "; ".join(f"{each.line}: {each.reason}" for each in dropped[:3])
        raise InputError("shots", measured.source, f"shots with at least one launch that can be computed ({reasons})")
    taken = measured.places[kept]
    labels = recorded.select(taken).groups() if labels is None else labels[taken]
    columns = [launch.input(name) for name in inputs()]
    columns = [each if isinstance(each, float) else np.ascontiguousarray(each[kept]) for each in columns]
    return PreparedShots(
        club=launch.club, ball=launch.ball, columns=columns, quantities=there,
        launches=np.ascontiguousarray(launches[:, kept]),
        start=np.array(list(measured.start.values())).reshape(len(measured.start), len(measured))[:, kept],
        rows=measured.rows[kept],
        groups=np.unique(np.arange(len(kept)) if labels is None else labels, return_inverse=True)[1],
        source=measured.source,
        dropped=(*measured.dropped, *dropped), notes=(*measured.notes, *notes),
        loft_origins=measured.loft_origins, provenance=provenance_of([launch]).with_files(),
    )  # fmt: skip


def _check_quantities(quantities: Iterable[str]) -> tuple[str, ...]:
    asked = (quantities,) if isinstance(quantities, str) else tuple(dict.fromkeys(quantities))
    if not asked:
        raise InputError("quantities", asked, "at least one of " + ", ".join(QUANTITIES))
    for name in asked:
        if name not in outputs():
            raise UnknownNameError("launch quantity", name, QUANTITIES)
    return asked
