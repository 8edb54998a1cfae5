"""The whole study: every model identified on the benchmark shots of both clubs, and what follows from it.

Each part is kept when it is finished, so that an interrupted study goes on where it was.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.benchmark_data import CLUBS, BenchmarkShots, load
from clubface.benchmark_data.impacts import true_parameters
from clubface.benchmark_data.recipe import recipe
from clubface.equipment.balls import published_ball
from clubface.equipment.parameters import ParameterSet
from clubface.evaluation import Evaluation
from clubface.evaluation.evaluation import evaluate
from clubface.evaluation.statistics import Resamples, interval
from clubface.findings.effects import effect_sizes
from clubface.findings.error_budget import error_budget
from clubface.findings.tour_fit import FREE, fit
from clubface.identification import Identification, identify
from clubface.measured.shots import QUANTITIES
from clubface.support.folders import prepared_folder
from clubface.support.plain_json import plain
from clubface.support.resuming import Store

MODELS = ("standard", "adjusted", "slip", "jorgensen", "volumetric", "area", "rings")
EVERY = {"driver-rings": 10, "7-iron-rings": 3}
"""Models identified on a part of the shots, every so-manieth, for the time they take; they are evaluated on all."""
OWN = ("adjusted", "slip", "volumetric")
"""Models identified also on the shots that they made themselves; `rings` made shots too, but takes too long."""
BOOTSTRAP = {"rings": 50}
RESAMPLES = 4000
DIGITS = 9
"""Significant digits kept."""

Progress = Callable[[str, float], object]
"""What is being done, and how much of it is, 0 to 1."""


def run(folder: Path, *, threads: int | None = None, progress: Progress | None = None) -> dict[str, Any]:
    """Run what is not in ``folder`` yet, and return all findings, made of what JSON has."""
    prepared_folder(folder.parent)
    of = {club: load(club) for club in CLUBS}
    content = {
        "set of shots": of, "every": EVERY, "bootstrap": BOOTSTRAP, "resamples": RESAMPLES,
    }  # fmt: skip
    with Store(folder, content, otherwise="give a new folder") as store:
        tour = {model: store.once(f"tour-{model}", lambda model=model: plain(_tour(model))) for model in FREE}
        # The quick models of both clubs before the slow ones of either.
        fits = {club: {} for club in CLUBS}
        for model in MODELS:
            for club, shots in of.items():
                fits[club][model] = fitted(shots, model, store, threads=threads, progress=progress)
        own = {
            club: {
                model: store.once(f"{club}-{model}-own", partial(_own, shots, model, store, threads, progress))
                for model in MODELS
                if model in OWN
            }
            for club, shots in of.items()
        }
        clubs = {club: _of_club(shots, fits[club], store, threads) | {"own": own[club]} for club, shots in of.items()}
    return rounded(plain({"models": list(MODELS), "clubs": clubs, "tour": tour}))


def _of_club(shots: BenchmarkShots, fits: dict[str, Any], store: Store, threads: int | None) -> dict[str, Any]:
    """Return what is found with one club."""
    sets = {model: _parameters(shots.club, model, each) for model, each in fits.items()}
    return {
        "fits": {model: {key: each[key] for key in each if key != "held_out"} for model, each in fits.items()},
        "held_out": _leads(shots, fits),
        "errors": store.once(f"{shots.club}-errors", lambda: plain(_errors(shots, sets, threads))),
        "effects": effect_sizes(shots),
        "budget": {model: error_budget(shots, sets[model]) for model in MODELS},
    }


def fitted(
    shots: BenchmarkShots, model: str, store: Store, *, threads: int | None = None, progress: Progress | None = None
) -> dict[str, Any]:
    """Return one model as identified on the shots of one club, from ``store`` if it is there."""
    which = np.arange(0, len(shots), EVERY.get(f"{shots.club}-{model}", 1))
    part = f"{shots.club}-{model}"
    return store.once(
        part, lambda: plain(_told(_identified(shots, model, which, store.file(part), threads, progress), shots, which))
    )


def _own(
    shots: BenchmarkShots, model: str, store: Store, threads: int | None, progress: Progress | None
) -> dict[str, Any]:
    """Return one model as identified on the shots that it made, and the parameters it made them with, on average."""
    which = np.flatnonzero(shots.model == model)
    found = _identified(shots, model, which, store.file(f"{shots.club}-{model}-own"), threads, progress)
    delivery = {name: values[which] for name, values in shots.truth.deliveries.items()}
    true = true_parameters(recipe(shots.club), model, delivery, shots.restitution_offset[which]).values
    kept = {name: each for name, each in _told(found, shots, which).items() if name != "held_out"}
    return plain(kept | {"true": {name: float(np.mean(true[name])) for name in kept["free"]}})


def _identified(
    shots: BenchmarkShots, model: str, which: NDArray[np.int64], part: Path, threads: int | None,
    progress: Progress | None,
) -> Identification:  # fmt: skip
    """Identify one model on some of the shots of one club."""

    def tell(stage: str, done: int, of: int, best: float) -> None:
        if progress is not None:
            progress(f"{part.name}: {stage}, cost {best:.4f}", done / of)

    return identify(
        shots.measured.select(which), club=shots.head, model=model, groups=shots.player[which], ball=published_ball(),
        bootstrap=BOOTSTRAP.get(model, 200), threads=threads, checkpoint=part.with_suffix(".checkpoint"),
        resume=True, progress=tell,
    )  # fmt: skip


def _told(of: Identification, shots: BenchmarkShots, which: NDArray[np.int64]) -> dict[str, Any]:
    """Return what is kept of an identification, and what each shot adds to the cost when it is held out."""
    assert of.held_out is not None
    measured = np.array([shots.measured.launches[name][which] for name in QUANTITIES])
    losses = np.abs(of.held_out - measured) / np.abs(measured).mean(axis=1, keepdims=True)
    told = of.to_dict()
    kept = (
        "parameters", "intervals", "cost", "cost_holdout", "evaluations", "impacts", "wall_s", "free", "shots",
        "deviations", "identified", "warnings", "settings",
    )  # fmt: skip
    weak = [each["words"] for each in told["identifiability"]["directions"] if each["strength"] != "known"]
    profiles = {name: each["interval"] for name, each in told["profiles"].items()}
    held = {"places": which, "losses": losses.sum(axis=0)}
    return {name: told[name] for name in kept} | {"weak": weak, "profile_intervals": profiles, "held_out": held}


def _leads(shots: BenchmarkShots, fits: dict[str, Any]) -> dict[str, Any]:
    """Return by how much each model's held-out cost exceeds the least, and its interval, players drawn together.

    Models identified on a part of the shots are compared on that part.
    """
    found = {}
    whole = {name: each for name, each in fits.items() if len(each["held_out"]["places"]) == len(shots)}
    best = min(whole, key=lambda name: whole[name]["cost_holdout"])
    for name, each in fits.items():
        places = np.array(each["held_out"]["places"])
        lead = np.array(each["held_out"]["losses"]) - np.array(fits[best]["held_out"]["losses"])[places]
        resamples = Resamples(RESAMPLES, len(places), 0, shots.player[places])
        means = resamples.means(lead[None])[:, 0]
        found[name] = {"than": best, "more": lead.mean(), "interval": interval(means, resamples.groups)}
    return found


def _parameters(club: str, model: str, told: dict[str, Any]) -> ParameterSet:
    values = told["parameters"]
    return ParameterSet(model=model, club=club, name="identified on the benchmark shots", values=values)


def _errors(shots: BenchmarkShots, sets: dict[str, ParameterSet], threads: int | None) -> dict[str, Any]:
    """Return errors of all models on all shots of a club, with players drawn together, and the best ones."""
    found = evaluate(
        shots.measured, club=shots.head, models=list(MODELS), parameters=sets, groups=shots.player,
        resamples=RESAMPLES, threads=threads, ball=published_ball(),
    )  # fmt: skip
    return _evaluated(found)


def _evaluated(of: Evaluation) -> dict[str, Any]:
    return {
        "mean": of.mean,
        "sizes": {name: {m: size._asdict() for m, size in each.items()} for name, each in of.sizes.items()},
        "best": {
            name: {"model": each.model, "rivals": [rival._asdict() for rival in each.rivals]}
            for name, each in of.best.items()
        },
        "cost": {model: of.cost(model) for model in of.models},
        "seconds": of.seconds,
        "floor": of.floor,
    }


def _tour(model: str) -> dict[str, Any]:
    of = fit(model)
    return {
        "parameters": dict(of.parameters.values),
        "free": list(of.free),
        "clubs": list(of.clubs),
        "lofts": of.lofts,
        "errors": of.errors,
        "left_out": of.left_out,
        "carry": of.carry,
    }


def rounded(value: Any) -> Any:
    """Return ``value`` with all numbers cut to ``DIGITS`` significant digits."""
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}")
    if isinstance(value, dict):
        return {key: rounded(each) for key, each in value.items()}
    return [rounded(each) for each in value] if isinstance(value, list) else value
