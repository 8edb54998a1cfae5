"""Launches, flights, and what is followed in time, as results."""

from __future__ import annotations

from collections.abc import Mapping

from numpy.typing import ArrayLike

from clubface.results.provenance import Provenance
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, text
from clubface.simulation.flight import Flight, Trajectory
from clubface.simulation.history import History
from clubface.simulation.launch import Comparison, Launch, assumptions_of, rigid_faces
from clubface.simulation.provenance import flight_input_words, provenance_of
from clubface.simulation.results import Batch, Series, flight_inputs
from clubface.simulation.shot_result import subject


def batch_provenance(batch: Batch) -> Provenance:
    """Return what a batch of launches or flights was computed from."""
    if isinstance(batch, Launch):
        return provenance_of([batch])
    assert isinstance(batch, Flight)
    return _flight_provenance(batch.launch, batch.inputs)


def comparison_result(launches: Comparison) -> Result:
    """Return the launches by several models: one row a shot and model."""
    tables = [each.to_result().tables[0] for each in launches.values()]
    first = tables[0]
    models = [name for name, each in zip(launches, tables, strict=True) for _ in range(len(each))]
    columns = [
        Column(each.name, [value for table in tables for value in table[each.name].values], each.quantity)
        for each in first.columns
    ]
    notes = tuple(dict.fromkeys(each for launch in launches.values() for each in launch.to_result().notes))
    return Result(
        "launches", f"{subject(next(iter(launches.values())))}, by {', '.join(launches)}",
        (Table("launches", (text("model", models), *columns)),),
        assumptions=(*assumptions_of(launches.values()), *rigid_faces(launches)), notes=notes,
        provenance=provenance_of(launches.values()),
    )  # fmt: skip


def history_result(history: History) -> Result:
    """Return a contact: its time and peak force, and every step in files."""
    launch = history.launch
    values = (column("contact_time", [launch.contact_time]), column("peak_force", [launch.peak_force]))
    return Result(
        "history", f"{subject(launch)}: contact by {launch.model}", (_series_table("steps", history),), values,
        assumptions=assumptions_of([launch]), provenance=provenance_of([launch]),
    )  # fmt: skip


def trajectory_result(path: Trajectory) -> Result:
    """Return the path of a ball: time and place of its landing, and every point in files."""
    values = (
        column("flight_time", [path.time[-1]]), column("apex", [path.position[:, 1].max()]),
        column("carry", [path.position[-1, 0]]), column("side", [path.position[-1, 2]]),
    )  # fmt: skip
    return Result(
        "trajectory", "Path of a ball", (_series_table("points", path),), values,
        assumptions=() if path.launch is None else assumptions_of([path.launch]),
        provenance=_flight_provenance(path.launch, path.inputs),
    )  # fmt: skip


def _flight_provenance(launch: Launch | None, inputs: Mapping[str, ArrayLike]) -> Provenance:
    """Return what a flight was computed from: the launch if there is one, else its values, and air and ground."""
    known = flight_inputs()
    shown = {name: value for name, value in inputs.items() if launch is None or known[name].group in ("air", "ground")}
    return provenance_of([] if launch is None else [launch], dict(flight_input_words(shown)))


def _series_table(name: str, series: Series) -> Table:
    """Return a row a time, vectors as columns by component; the terminal leaves it out."""
    columns = [column(each, values, unit) for each, (values, unit) in series.components().items()]
    return Table(name, tuple(columns), printed=False)
