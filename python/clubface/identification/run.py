"""Identification of model parameters from measured shots: the search, then how well the parameters are known."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import reduced_model
from clubface.errors import InputError
from clubface.identification import search as genetic
from clubface.identification.checkpoint import Checkpoint
from clubface.identification.cost import cost_of, noise_of
from clubface.identification.free_parameters import free_parameters
from clubface.identification.prepared import prepared_shots
from clubface.identification.resampling import BOOTSTRAP, FOLDS
from clubface.identification.result import Identification
from clubface.identification.sanity import check_information
from clubface.identification.simulator import Effort, Simulator
from clubface.identification.stages import Progress, Stages
from clubface.measured.shots import DELIVERY
from clubface.recorded.shots import RecordedShots
from clubface.simulation.impact import Parameters
from clubface.simulation.inputs import equipped
from clubface.simulation.run_options import thread_count, tolerance
from clubface.support.checks import MOST_SEED, is_count


def identify(
    shots: RecordedShots | str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club,
    model: str,
    parameters: Parameters | None = None,
    free: str | Iterable[str] | None = None,
    bounds: Mapping[str, Any] | None = None,
    tied: Mapping[str, str] | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    only: str | None = None,
    mismatch: str = "refuse",
    quantities: Iterable[str] | None = None,
    compared_at: str = DELIVERY,
    groups: Any = None,
    cost: str = "published",
    normaliser: str = "absolute",
    noise: Mapping[str, Any] | None = None,
    population: int = genetic.POPULATION,
    generations: int = genetic.GENERATIONS,
    refined: int = genetic.REFINED,
    folds: int = FOLDS,
    bootstrap: int = BOOTSTRAP,
    profiles: Iterable[str] | None = None,
    confidence: float = 0.95,
    seed: int = 1,
    accuracy: float | None = None,
    threads: int | None = None,
    checkpoint: str | os.PathLike[str] | None = None,
    resume: bool = False,
    progress: Progress | None = None,
) -> Identification:
    """Identify the parameters of a model from recorded shots, and say how well the shots determine them.

    The method is that of Caldwell and McPhee (2023), section 2.3. A genetic algorithm searches the whole range of the
    parameters, its best points are refined with exact derivatives, and the best result is kept. The fit is then
    repeated on parts of the shots (hold-out) and on shots drawn with replacement (bootstrap), and profile likelihoods
    are computed.

    Parameters
    ----------
    shots
        Recorded shots, or a file that :func:`clubface.launch_monitor.read` reads.
    club, ball
        As for :func:`impact`.
    model
        Name of a model.
    parameters
        The values of the parameters that are not free, as for :func:`impact`.
    free
        Names of the parameters to identify, or "all". If left out: those that the publication of the model identified.
    bounds
        Pairs of values by name, as text with a unit or as SI numbers, within the bounds of the model. If left out, the
        bounds of the model hold.
    tied
        Parameters that follow a free one, by name: ``{"ring_modulus": "shear_modulus"}``.
    only
        Take only the shots of the club that the file calls so.
    mismatch
        What to do with shots that look like those of another club: "refuse" or "note".
    quantities
        Launch quantities to compare. If left out: those of ball speed, launch angle, azimuth, backspin and sidespin
        that were measured.
    compared_at
        "delivery", or "launch": launch angle and, if it was measured, start direction are then met for every set of
        parameters, for which dynamic loft and face angle are solved, and ball speed and spin are compared there. The
        derivatives hold what the solution changes. Lofts that a monitor computed from the ball do not count then; with
        "delivery" they carry the monitor's own model into the fit.
    groups
        One label for each shot. The shots of a group are held out and drawn together. If left out: the players, if the
        shots name several; otherwise the shots are taken as independent.
    cost
        "published" is equation 22 of Caldwell and McPhee; "least-squares" is weighted by the noise; "robust" is the
        same with Huber's loss.
    normaliser
        For "published": "absolute" or "signed", see :func:`clubface.identification.cost.cost_of`.
    noise
        Standard deviation of the measurement by quantity, as text with a unit or as SI numbers.
    population, generations, refined
        Size of the population, number of generations, and number of points that are refined. The defaults, 200, 100 and
        5, are those of Caldwell and McPhee.
    folds
        Number of folds of the hold-out; 0 for none.
    bootstrap
        Number of bootstrap samples. With 0, the intervals are those of normally distributed deviations of independent
        shots.
    profiles
        Parameters for which to compute profile likelihoods; if left out, all free ones.
    confidence
        Confidence level of the intervals.
    seed
        Seed of all random numbers. The same seed gives the same result, bit for bit, on any number of threads.
    accuracy, threads
        As for :func:`impact`.
    checkpoint
        A folder that keeps what is finished. It is removed when everything is finished.
    resume
        Refuse a checkpoint of other shots or settings, instead of beginning anew in its place.
    progress
        Called with the name of the stage, how much of it is done, of how much, and the least cost so far.

    Returns
    -------
    Identification
        Parameters, intervals, costs and warnings.

    Raises
    ------
    InputError
        The shots cannot be used, belong to another club, or hold less information than there are free parameters; or an
        option is out of range.
    FileError
        A file cannot be read, or a checkpoint belongs to other shots or settings, and is to be resumed or is still
        worked on.
    """
    reduced_model(model, "one with derivatives")
    counts = {
        "population": (population, 4, 100_000), "generations": (generations, 1, 100_000),
        "refined": (refined, 1, population), "folds": (folds, 0, 1000), "bootstrap": (bootstrap, 0, 100_000),
        "seed": (seed, 0, MOST_SEED),
    }  # fmt: skip
    for name, (count, least, most) in counts.items():
        if not is_count(count, least, most) or (name == "folds" and count == 1):
            but = ", but 1" if name == "folds" else ""
            raise InputError(name, count, f"a whole number from {least} to {most}{but}")
    if not 0.5 <= confidence < 1.0:
        raise InputError("confidence", confidence, "from 0.5 to below 1")
    with_, given = equipped(model, club, ball, parameters)
    # What is found from shots includes the face they were hit with.
    head = with_.club
    fixed = replace(given, includes_face=True, characteristic_time=head.characteristic_time or None)
    for name, value in fixed.values.items():
        if not isinstance(value, float):
            raise InputError(name, value, "a single number: one set of parameters is identified from all shots")
    chosen = free_parameters(fixed, free, bounds=bounds, tied=tied)
    profiled = chosen.names if profiles is None else tuple(profiles)
    for name in profiled:
        if name not in chosen.names:
            raise InputError("profiles", name, "free parameters: " + ", ".join(chosen.names))
    prepared = prepared_shots(
        shots, club=head, ball=ball, only=only, mismatch=mismatch, quantities=quantities, groups=groups,
        parameters=fixed, compared_at=compared_at,
    )  # fmt: skip
    notes = list(prepared.notes)
    deviations = noise_of(prepared.quantities, noise)
    cores, tight = thread_count(threads), tolerance(accuracy)
    effort = Effort()
    simulator = Simulator(prepared, chosen, accuracy=tight, threads=cores, effort=effort)
    start = chosen.points(np.array([fixed.values[name] for name in chosen.names], dtype=float))
    notes += check_information(simulator, start, deviations)
    judged = cost_of(cost, prepared.launches, prepared.quantities, noise=noise, normaliser=normaliser)
    settings = {
        "model": model, "cost": cost, "normaliser": normaliser, "population": population, "generations": generations,
        "refined": refined, "folds": min(folds, int(prepared.groups.max()) + 1), "bootstrap": bootstrap,
        "profiles": list(profiled),
        "confidence": confidence, "seed": seed, "accuracy": tight, "quantities": list(prepared.quantities),
        "compared_at": compared_at,
        "noise": deviations.tolist(), "bounds": {
            name: [float(low), float(high)]
            for name, low, high in zip(chosen.names, chosen.lower, chosen.upper, strict=True)
        },
        "tied": dict(chosen.tied),
    }  # fmt: skip
    content = {
        "set of shots": [prepared.columns, prepared.launches, prepared.start, prepared.groups],
        "parameter": fixed.values,
        **settings,
    }
    kept = Checkpoint(checkpoint, content, effort, resume=resume)
    stages = Stages(simulator, judged, deviations, settings, kept, progress)
    try:
        found = stages.result(tuple(notes))
        kept.remove()
    except KeyboardInterrupt:
        if checkpoint is None or not kept.parts:
            raise
        message = f"interrupted: what is finished is kept in {os.fspath(checkpoint)}; the same command goes on after it"
        raise KeyboardInterrupt(message) from None
    finally:
        kept.close()
    return found
