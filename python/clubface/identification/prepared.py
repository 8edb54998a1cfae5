"""The shots of an identification: the inputs as the core takes them, and the measured launches."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError, RangeWarning, Told, UnknownNameError
from clubface.launch_monitor import read
from clubface.measured.shots import DELIVERY, QUANTITIES, SOLVED, measured_shots
from clubface.recorded.loft_origin import LoftOrigin
from clubface.recorded.shots import RecordedShots, RejectedRow
from clubface.simulation.impact import impact
from clubface.simulation.launch_conditioned import impact_at_launch
from clubface.simulation.quantities import input_columns, inputs, outputs
from clubface.support.warning import without_warnings


@dataclass(frozen=True, kw_only=True, eq=False)
class PreparedShots:
    """Deliveries and launches measured together, of one club and ball.

    Attributes
    ----------
    club, ball
        What they were hit with.
    columns
        One an input of the core: a number, or an array of shape (shots,).
    quantities
        Names of the launch quantities.
    launches
        Their measured values [SI], shape (quantities, shots); NaN where one was not measured.
    start
        Launch angles, or launch angles and azimuths [rad], that every set of parameters meets, shape (1 or 2, shots);
        of shape (0, shots) for a comparison at the measured delivery. Loft and face angle among the columns are then
        those with which the parameters given meet them.
    loft_origins
        What the shots tell of where their dynamic lofts come from.
    rows
        Where each shot stands in its source.
    groups
        Number of the group of each shot, such as its player, from 0; shots of a group are left out and drawn together.
    source
        The file, or another name.
    dropped
        Rows that cannot be used.
    notes
        What a reader of the result must know of the data.
    """

    club: Club
    ball: Ball
    columns: list[Any]
    quantities: tuple[str, ...]
    launches: NDArray[np.float64]
    start: NDArray[np.float64]
    rows: NDArray[np.int64]
    groups: NDArray[np.int64]
    source: str
    dropped: tuple[RejectedRow, ...] = ()
    notes: tuple[str, ...] = ()
    loft_origins: tuple[LoftOrigin, ...] = ()

    def __len__(self) -> int:
        return self.launches.shape[1]

    def select(self, which: NDArray[Any]) -> Self:
        """Return some of the shots, by mask or indices."""
        columns = [each if isinstance(each, float) else np.ascontiguousarray(each[which]) for each in self.columns]
        launches, start = (np.ascontiguousarray(each[:, which]) for each in (self.launches, self.start))
        rows, groups = self.rows[which], self.groups[which]
        return replace(self, columns=columns, launches=launches, start=start, rows=rows, groups=groups)

    def output_places(self) -> list[int]:
        """Return where the quantities, and then what is met, stand among the outputs of the core."""
        order = list(outputs())
        return [order.index(name) for name in (*self.quantities, *self.met)]

    @property
    def met(self) -> list[str]:
        """Names of what every set of parameters meets."""
        return list(SOLVED)[: len(self.start)]

    def solved_columns(self) -> list[int]:
        """Return the columns of the inputs that are solved for it."""
        return [input_columns()[SOLVED[name]] for name in self.met]

    def distinct_deliveries(self) -> int:
        """Return the number of shots that differ in what went into them."""
        varied = [each for each in self.columns if not isinstance(each, float)]
        return len(np.unique(np.array(varied), axis=1).T) if varied else 1

    def different(self) -> int:
        """Return the number of shots that differ in anything that was measured."""
        varied = [each for each in self.columns if not isinstance(each, float)]
        return len(np.unique(np.array([*varied, *np.nan_to_num(self.launches)]), axis=1).T)

    def mean(self, name: str) -> float:
        """Return the mean of one input over the shots [SI]."""
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
    """Lay out recorded shots for the core, without those for which the model gives no launch with ``parameters``.

    Parameters
    ----------
    given, club, only, mismatch, compared_at
        As for :func:`measured_shots`.
    ball
        As for :func:`impact`.
    quantities
        The launch quantities to compare, which must have been measured. If left out: those of ball speed, launch angle,
        azimuth, backspin and sidespin that were measured.
    groups
        One label for each shot of ``given``. If left out: the players, if the shots name several; otherwise every shot
        is a group of its own.
    parameters
        A parameter set of the model.
    """
    recorded = given if isinstance(given, RecordedShots) else read(given)
    labels = None if groups is None else _groups(groups, len(recorded))
    compared = tuple(name for name in QUANTITIES if compared_at == DELIVERY or name not in SOLVED)
    asked = compared if quantities is None else _asked(quantities)
    if met := set(asked) & set(SOLVED) - set(compared):
        raise InputError("quantities", min(met), f"quantities that are not met at the launch: {', '.join(compared)}")
    measured = measured_shots(
        recorded, club=club, only=only, mismatch=mismatch, quantities=asked, compared_at=compared_at
    )
    there = tuple(name for name, values in measured.launch.items() if np.isfinite(values).any())
    missing = [name for name in asked if name not in there]
    if missing and quantities is not None:
        raise InputError(
            "quantities", ", ".join(missing), f"measured quantities; those of {measured.source} are {', '.join(there)}"
        )
    notes = [f"not measured, so not in the cost: {', '.join(missing)}"] if missing else []
    launches = np.array([measured.launch[name] for name in there])
    how: dict[str, Any] = {"model": parameters.model, "parameters": parameters, "ball": ball}
    problems: dict[int, str] = {}
    with without_warnings(RangeWarning):  # of the parameters with which the search begins
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
        told = "; ".join(f"{each.line}: {each.reason}" for each in dropped[:3])
        raise InputError("shots", measured.source, f"shots of which some have a launch that can be computed ({told})")
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
        loft_origins=measured.loft_origins,
    )  # fmt: skip


def _groups(given: Any, shots: int) -> NDArray[Any]:
    labels = np.asarray(given)
    if labels.shape != (shots,):
        raise InputError("groups", Told(f"of shape {labels.shape}"), f"one label for each shot: ({shots},)")
    return labels


def _asked(quantities: Iterable[str]) -> tuple[str, ...]:
    asked = (quantities,) if isinstance(quantities, str) else tuple(dict.fromkeys(quantities))
    if not asked:
        raise InputError("quantities", asked, "at least one of " + ", ".join(QUANTITIES))
    for name in asked:
        if name not in outputs():
            raise UnknownNameError("launch quantity", name, QUANTITIES)
    return asked
