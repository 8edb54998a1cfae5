"""Comparison of models with measured shots, from a file to the full report in one call."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from time import process_time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.errors import InputError, RangeWarning, Wording
from clubface.inference.evaluation.result import Evaluation
from clubface.inference.evaluation.statistics import (
    Resamples,
    error_floor,
    error_sizes,
    fewest_resamples,
    group_labels,
    monitor_noise,
    standard_deviations,
    trends,
)
from clubface.shots.measured import DELIVERY, QUANTITIES, measured_shots
from clubface.shots.reading import read
from clubface.shots.recorded import RecordedShots, RejectedRow
from clubface.simulation.impact import Parameters, impact, model_names, warn_if_outside
from clubface.simulation.inputs import OF_CLUB, parameter_set
from clubface.simulation.launch import Launch
from clubface.simulation.launch_conditioned import impact_at_launch
from clubface.simulation.provenance import provenance_of
from clubface.support.arrays import Floats, ValueLike
from clubface.support.checks import MOST_SEED, check_count, is_count, without_warnings
from clubface.support.files import recorded

FEWEST_RESAMPLES = 100
"""Smallest number of resamples for an interval; several models need more, see ``fewest_resamples``."""
SHORTEST = 0.02
"""Computations shorter than this [s] are timed over several runs."""


@recorded
def evaluate(
    shots: RecordedShots | str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club | None = None,
    only: str | None = None,
    mismatch: str = "refuse",
    models: str | Iterable[str] = "all",
    parameters: Mapping[str, Parameters] | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    noise: Mapping[str, ValueLike] | None = None,
    delivery_noise: Mapping[str, ValueLike] | None = None,
    compared_at: str = DELIVERY,
    groups: Sequence[object] | NDArray[np.generic] | None = None,
    resamples: int = 2000,
    seed: int = 0,
    threads: int | None = None,
    progress: Callable[[str], object] | None = None,
) -> Evaluation:
    """Compare models with measured shots: how large their errors are, what these depend on, and which model is best.

    Parameters
    ----------
    shots
        Recorded shots, or a file that :func:`clubface.shots.read` reads.
    club, only
        Club of the shots, and its name in a file with several clubs; see
        :func:`clubface.shots.measured.measured_shots`.
    mismatch
        What to do if the names or dynamic lofts of the shots indicate another club: "refuse" or "note".
    models
        Name of a model, a list of names, or "all".
    parameters
        Mapping of model names to the ``parameters`` of :func:`impact`. Default: the published sets.
    ball, accuracy, threads
        As for :func:`impact`.
    noise
        Standard deviations of the measured launch quantities, by name. Default: those that Caldwell and McPhee (2023)
        quote for their monitor (mean errors of 0.2 degrees and 50 rpm).
    delivery_noise
        Standard deviations of the measured delivery quantities, by name; they enter the noise floor.
    compared_at
        "delivery" or "launch". At "launch", dynamic loft and face angle are solved for each model so that it meets the
        measured launch angle and, if measured, the start direction; ball speed and spin are compared there. Lofts that
        a monitor computed from the ball are then not used.
    groups
        One label per shot of ``shots``, such as the player, for shots that belong together; resamples draw whole
        groups. Default: the players, if the shots name several; otherwise every shot is a group of its own.
    resamples
        Number of bootstrap resamples.
    seed
        Seed of the random numbers; the same seed gives the same report, apart from the times.
    progress
        Function called with the name of each model before it is computed.

    Raises
    ------
    InputError
        There is no usable shot, the shots belong to several clubs or to another club, a speed is missing, or a name is
        unknown.
    """
    names = model_names(models)
    enough = fewest_resamples(len(names))
    seed = check_count("seed", seed, 0, MOST_SEED)
    if not is_count(resamples, max(enough, FEWEST_RESAMPLES), MOST_SEED):
        why = f"; with fewer, none of {len(names)} models can be found significantly worse" * (
            enough > FEWEST_RESAMPLES
        )
        raise InputError("resamples", resamples, f"a whole number of at least {max(enough, FEWEST_RESAMPLES)}{why}")
    monitor, disturbance = monitor_noise(noise), standard_deviations(delivery_noise, OF_CLUB, "delivery_noise")
    source = shots if isinstance(shots, RecordedShots) else read(shots)
    if groups is not None and source is not shots:
        advice = "give RecordedShots instead of a file, with one group label per shot"
        raise InputError("groups", Wording("given for a file"), advice)
    taken = measured_shots(source, club=club, only=only, mismatch=mismatch, compared_at=compared_at)
    # Only players among the shots used count: shots of a single player form no groups.
    labels = source.select(taken.places).groups() if groups is None else group_labels(groups, len(source))[taken.places]
    given = parameters or {}
    for name in given:
        if name not in names:
            raise InputError("parameters", name, f"the name of a model that is evaluated: {', '.join(names)}")
    sets = {name: parameter_set(name, taken.club, given.get(name)) for name in names}

    def predict(name: str, given: Mapping[str, Floats]) -> dict[str, Floats]:
        """Return the launches of deliveries, or launches with the measured launch angles and azimuths."""
        delivery = {each: values for each, values in given.items() if each not in taken.start}
        start = {each: values for each, values in given.items() if each in taken.start}
        how: dict[str, Any] = {
            "model": name, "parameters": sets[name], "ball": ball, "accuracy": accuracy, "threads": threads,
        }  # fmt: skip
        with without_warnings(RangeWarning):
            if start:
                loft, _, launch = impact_at_launch(taken.club, delivery, **start, **how)
                for row in np.flatnonzero(np.isnan(loft)):
                    failures.setdefault(int(row), f"{name}: no loft gives the measured launch")
            else:
                launch = impact(taken.club, delivery, **how, on_error="nan")
        launches[name] = launch
        for each in launch.problems:
            failures.setdefault(each.row[0], f"{name}: {each.reason}")
        return {quantity: np.asarray(getattr(launch, quantity)) for quantity in QUANTITIES}

    given_of = {**taken.delivery, **taken.start}
    failures: dict[int, str] = {}
    launches: dict[str, Launch] = {}
    predicted, seconds = {}, {}
    for name in names:
        if progress is not None:
            progress(name)
        predicted[name], seconds[name] = _time_per_shot(lambda model=name: predict(model, given_of), len(taken))
    warn_if_outside(launches.values())
    kept = np.array([row not in failures for row in range(len(taken))], dtype=bool)
    failed = tuple(RejectedRow(int(taken.rows[row]), reason) for row, reason in sorted(failures.items()))
    if not kept.any():
        raise InputError("shots", taken.source, f"at least one shot that every model can compute ({failed[0].reason})")
    taken = taken.select(kept)
    labels = None if labels is None else labels[kept]
    predicted = {name: {key: values[kept] for key, values in each.items()} for name, each in predicted.items()}
    sizes, best, lines = {}, {}, {}
    for quantity, measured in taken.launch.items():
        there = np.isfinite(measured)
        drawn = Resamples(resamples, int(there.sum()), seed, None if labels is None else labels[there])
        errors = {name: (predicted[name][quantity] - measured)[there] for name in names}
        sizes[quantity], best[quantity] = error_sizes(errors, drawn)
        delivery = {name: values[there] for name, values in taken.delivery.items()}
        lines[quantity] = trends(errors, delivery, drawn)
    standing = best[next(iter(best))].model
    # Launch values that are met are noisy as well; noise in solved values has no effect.
    disturbed = disturbance | {name: monitor[name] for name in taken.start if name in monitor}
    least = error_floor(
        lambda delivery: predict(standing, delivery), {**taken.delivery, **taken.start}, monitor, disturbed, seed
    )
    return Evaluation(
        shots=taken, parameters=sets, predicted=predicted, sizes=sizes, best=best, trends=lines,
        floor={name: least[name] for name in sizes if name in least}, monitor_noise=monitor,
        delivery_noise=disturbance, seconds=seconds, failed=failed, resamples=resamples, seed=seed,
        groups=None if labels is None else len(set(labels.tolist())),
        provenance=provenance_of(launches.values()).with_files(),
    )  # fmt: skip


def _time_per_shot(compute: Callable[[], dict[str, Floats]], shots: int) -> tuple[dict[str, Floats], float]:
    """Return a result and the processor time per shot; short computations are repeated."""
    began = process_time()
    result = compute()
    spent = process_time() - began
    if spent < SHORTEST:
        runs = 5
        began = process_time()
        for _ in range(runs):
            compute()
        spent = (process_time() - began) / runs
    return result, spent / shots
