"""Findings on the benchmark shots and on the published averages of the tours: the study and its parts.

Every model is identified on the benchmark shots of both clubs. The truth of the benchmark is known, so that each source
of error can be left alone: the model on true deliveries against true launches; the same model on measured and on true
deliveries; true deliveries extrapolated without any noise. Each part is kept when it is finished.

A published mean absolute error together with a standard deviation implies a bias. For a normal error of bias b and
deviation s the mean magnitude is s sqrt(2/pi) exp(-b^2/(2 s^2)) + b erf(b/(s sqrt 2)). Without a bias it is 0.8 of the
deviation; where it is more, the rest is bias. If the published deviation is one of magnitudes, its square and that of
their mean add up to b^2 + s^2 instead.

One parameter set is fitted to all twelve clubs of the published tour averages. They are those of 2019, with which the
dynamic loft of two clubs is published. For the others it is, for every candidate set anew, the loft with which the
model gives the published launch angle: their launch angle is then no prediction, but ball speed and spin are, and the
loft carries no other model's errors.

``python studies/benchmark_findings.py FOLDER [RESULTS]``: run the study, resumed in FOLDER; write RESULTS.
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.balls import published_ball
from clubface.equipment.clubs import club
from clubface.equipment.models import model as model_named
from clubface.equipment.parameters import ParameterSet
from clubface.errors import ClubfaceError
from clubface.inference.evaluation.evaluation import evaluate
from clubface.inference.evaluation.statistics import Resamples, interval
from clubface.inference.identification.result import Identification
from clubface.inference.identification.run import identify
from clubface.jobs import Store
from clubface.shots.measured import QUANTITIES
from clubface.simulation.flight import fly
from clubface.simulation.impact import impact
from clubface.simulation.launch import Launch
from clubface.simulation.results import input_dimensions, outputs
from clubface.support.arrays import Floats
from clubface.support.checks import plain
from clubface.support.files import prepared_folder, write_text
from clubface.validation.benchmark_data import CLUBS, BenchmarkShots, load, recipe
from clubface.validation.benchmark_recipe import LAUNCH, captured, launches, restitution_offsets, true_parameters
from clubface.validation.tour import Average, averages, published_lofts

EFFECTS = ("ball", "face", "shaft", "all")
"""Restitution scatters from ball to ball; it falls off the centre of the face; the tip of the shaft; all three."""


def effect_sizes(shots: BenchmarkShots) -> dict[str, dict[str, float]]:
    """Return the mean absolute change of the launch by effect of ``EFFECTS`` and quantity, SI.

    Each is left out of the model that made the shot, with the true delivery and all else as it was.
    """
    made_by = recipe(shots.club)
    delivery = shots.truth.deliveries
    off_centre = restitution_offsets(made_by, delivery, 0.0)
    without = {
        "ball": (made_by, off_centre),
        "face": (made_by, shots.restitution_offset - off_centre),
        "shaft": (made_by._replace(shaft_mass=0.0), shots.restitution_offset),
        "all": (made_by._replace(shaft_mass=0.0), np.zeros(len(shots))),
    }
    sizes = {}
    for effect, (part, offsets) in without.items():
        launch = {name: np.empty(len(shots)) for name in LAUNCH}
        for model in part.mixture:
            own = shots.model == model
            those = {name: values[own] for name, values in delivery.items()}
            for name, values in launches(part, model, those, offsets[own]).items():
                launch[name][own] = values
        sizes[effect] = {name: float(np.abs(launch[name] - shots.truth.launches[name]).mean()) for name in LAUNCH}
    return sizes


SOURCES = {
    "all": "as measured",
    "model": "model alone: true delivery, true launch",
    "capture": "motion capture alone",
    "extrapolation": "of it, straight lines through noise-free frames",
    "monitor": "launch monitor alone",
}
"""Parts of the error budget, and in words."""


def error_budget(shots: BenchmarkShots, parameters: ParameterSet) -> dict[str, dict[str, float]]:
    """Return the mean absolute error that each of ``SOURCES`` makes alone, by source and launch quantity, SI."""

    def launch(delivery: Mapping[str, Floats]) -> dict[str, Floats]:
        launches_of_model = impact(
            shots.head, delivery, model=parameters.model, parameters=parameters, ball=published_ball(), on_error="nan"
        )
        return {name: np.asarray(getattr(launches_of_model, name)) for name in QUANTITIES}

    truth, measured = shots.truth, shots.measured
    from_truth, from_measured = launch(truth.deliveries), launch(measured.deliveries)
    from_lines = launch(extrapolated(shots))
    differences = {
        "all": (from_measured, measured.launches),
        "model": (from_truth, truth.launches),
        "capture": (from_measured, from_truth),
        "extrapolation": (from_lines, from_truth),
        "monitor": (measured.launches, truth.launches),
    }
    return {
        source: {name: float(np.nanmean(np.abs(one[name] - other[name]))) for name in QUANTITIES}
        for source, (one, other) in differences.items()
    }


def extrapolated(shots: BenchmarkShots) -> dict[str, Floats]:
    """Return the true deliveries as straight lines through frames without noise give them."""
    quiet = recipe(shots.club)._replace(position_noise=0.0, attitude_noise=0.0, time_noise=0.0)
    return captured(quiet, shots.truth.deliveries, np.random.default_rng(quiet.seed))


def mean_magnitude(bias: float, deviation: float) -> float:
    """Return the mean magnitude of a normal error."""
    ratio = bias / (deviation * math.sqrt(2.0))
    return deviation * math.sqrt(2.0 / math.pi) * math.exp(-(ratio**2)) + bias * math.erf(ratio)


def bias_of(mae: float, deviation: float) -> float:
    """Return the bias, not negative, of a normal error with mean magnitude ``mae`` and standard ``deviation``.

    Zero where the magnitude is no more than an error without bias has; then its tails are heavier than normal.
    """
    if mae <= mean_magnitude(0.0, deviation):
        return 0.0
    return _root(lambda bias: mean_magnitude(bias, deviation) - mae, 0.0, mae)


def bias_of_magnitudes(mae: float, deviation: float) -> float:
    """Return the bias where ``deviation`` is that of the magnitudes of the error; zero as for :func:`bias_of`."""
    total = math.hypot(mae, deviation)

    def short(bias: float) -> float:
        return mean_magnitude(bias, math.sqrt(max(total**2 - bias**2, 1e-30))) - mae

    return 0.0 if short(0.0) >= 0.0 else _root(short, 0.0, total)


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    """Return where a rising ``function`` is zero, by bisection."""
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < 0.0 else (low, middle)
    return 0.5 * (low + high)


SEASON = "pga-2019"
"""The averages, the latest with which dynamic lofts are published."""
FREE = {
    "standard": ("cor",),
    "adjusted": ("cor", "extra_mass", "dcg_y"),
    "slip": ("cor", "slip_y"),
    "jorgensen": ("cor", "compression_factor"),
    "volumetric": ("damping", "friction", "layer_stiffness", "layer_damping", "transition_speed"),
    "rings": ("damping", "friction", "ring_modulus"),
    "area": ("damping", "friction", "area_damping"),
}
"""The parameters solved for. What shows only off the centre or in time stays as published, and restitution without a
slope: woods, the faster clubs, have the livelier faces, so that a free slope ends at its bound, zero."""
SCALES = {
    "ball_speed": units.parse("1 mph", "speed"), "spin": units.parse("150 rpm", "angular rate"),
    "launch": units.parse("0.5 deg", "angle"),
}  # fmt: skip
"""Errors of one in the fit, by quantity: roundings and spreads of averages; assumed."""
SLOPE = 0.85
"""Change of the launch angle with the loft, for the steps by which the loft is solved."""
STEPS = 8
FAR = 1e3
"""The residual of a shot that cannot be computed."""
FAMILIES = ("driver", "7-iron")
"""Clubs whose published sets the search starts from."""


class TourFit(NamedTuple):
    """One model with one parameter set for every club.

    Attributes
    ----------
    parameters
        The set.
    free
        The parameters that were solved for.
    clubs
        Names of the clubs.
    lofts
        Dynamic loft of each club [rad], published or solved with this set.
    errors
        Model less published by quantity, one a club, SI; the launch angle only where the loft is published, else NaN.
    left_out
        The same with parameters solved without the club in question.
    carry
        Carry [m] of the flights of the model's launches less published, which nothing was fitted to.
    """

    parameters: ParameterSet
    free: tuple[str, ...]
    clubs: tuple[str, ...]
    lofts: Floats
    errors: dict[str, Floats]
    left_out: dict[str, Floats]
    carry: Floats

    def to_dict(self) -> dict[str, Any]:
        """Return all numbers by name."""
        return {**self._asdict(), "parameters": dict(self.parameters.values)}

    def mean_absolute_error(self, quantity: str, *, left_out: bool = False) -> float:
        """Return the mean over the clubs of the absolute error, SI."""
        return float(np.nanmean(np.abs((self.left_out if left_out else self.errors)[quantity])))


class Bag:
    """All clubs of the averages as one batch."""

    def __init__(self, rows: Sequence[Average]) -> None:
        self.rows = tuple(rows)
        heads = [club(each.club) for each in rows]
        self.inputs = {
            name: np.array([head.inputs()[name] for head in heads], dtype=np.float64)
            for name in heads[0].inputs()
            if name in input_dimensions()
        }
        self.speed = np.array([each.club_speed for each in rows])
        self.attack = np.array([each.attack for each in rows])
        self.launch = np.array([each.launch for each in rows])
        lofts = published_lofts(SEASON)
        self.loft = np.array([lofts.get(each.club, np.nan) for each in rows])

    def errors(self, parameters: ParameterSet) -> tuple[dict[str, Floats], Floats]:
        """Return model less published, and the lofts; the launch angle is NaN where the loft was solved."""
        solved = np.isnan(self.loft)
        loft = np.where(solved, self.launch, self.loft)
        for _ in range(STEPS):
            launch = self.strike(loft, parameters)
            loft = np.where(solved, loft + (self.launch - launch.launch) / SLOPE, loft)
        launch = self.strike(loft, parameters)
        published = {name: np.array([getattr(each, name) for each in self.rows]) for name in ("ball_speed", "spin")}
        return {
            "ball_speed": launch.ball_speed - published["ball_speed"],
            "spin": launch.total_spin - published["spin"],
            "launch": np.where(solved, np.nan, launch.launch - self.launch),
        }, loft

    def residuals(self, parameters: ParameterSet) -> Floats:
        """Return the errors in units of ``SCALES``, those of solved lofts left out; an impossible shot is far off."""
        errors, _ = self.errors(parameters)
        known = ~np.isnan(self.loft)
        parts = [errors["ball_speed"], errors["spin"], errors["launch"][known]]
        scaled = [part / SCALES[name] for part, name in zip(parts, ("ball_speed", "spin", "launch"), strict=True)]
        return np.nan_to_num(np.concatenate(scaled), nan=FAR)

    def misfit(self, parameters: ParameterSet) -> float:
        """Return the sum of squared residuals."""
        return float(np.sum(self.residuals(parameters) ** 2))

    def strike(self, loft: Floats, parameters: ParameterSet) -> Launch:
        """Return the launches of all clubs, delivered at their published speeds and attack angles."""
        return impact(
            "driver",
            {**parameters.with_included_face(self.inputs), "speed": self.speed, "attack": self.attack, "loft": loft},
            model=parameters.model, parameters=parameters, ball=published_ball(), on_error="nan",
        )  # fmt: skip


def fit(model: str) -> TourFit:
    """Solve for the parameters of ``FREE`` that all clubs agree with best, and again without each club."""
    rows, names = averages(SEASON), FREE[model]
    every = Bag(rows)
    starts = [
        ParameterSet(model=model, club="any", name="tour-averages", values=ParameterSet.builtin(model, family).values)
        for family in FAMILIES
    ]
    best = min((_solved(every, start, names) for start in starts), key=every.misfit)
    errors, lofts = every.errors(best)
    left_out = {name: np.full(len(rows), np.nan) for name in errors}
    for place in range(len(rows)):
        others = [each for index, each in enumerate(rows) if index != place]
        without = _solved(Bag(others), best, names)
        errors_without, _ = Bag([rows[place]]).errors(without)
        for name, values in errors_without.items():
            left_out[name][place] = values[0]
    carry = fly(every.strike(lofts, best)).carry - np.array([each.carry for each in rows])
    return TourFit(best, names, tuple(each.club for each in rows), lofts, errors, left_out, carry)


def _solved(bag: Bag, start: ParameterSet, names: Sequence[str]) -> ParameterSet:
    """Return the set with the least sum of squared errors, in units of ``SCALES``, by bounded least squares."""
    from scipy.optimize import least_squares

    declared = [model_named(start.model).parameter(name) for name in names]
    sizes = np.array([max(abs(float(start.values[each.name])), 0.01 * (each.upper - each.lower)) for each in declared])
    lower, upper = (np.array([getattr(each, end) for each in declared]) / sizes for end in ("lower", "upper"))

    def at(point: Floats) -> ParameterSet:
        values = {name: float(value) for name, value in zip(names, np.clip(point, lower, upper) * sizes, strict=True)}
        return ParameterSet(model=start.model, club="any", name=start.name, values={**start.values, **values})

    def residuals(point: Floats) -> Floats:
        return bag.residuals(at(point))

    first = np.clip(np.array([float(start.values[name]) for name in names]) / sizes, lower + 1e-6, upper - 1e-6)
    solution = least_squares(residuals, first, bounds=(lower, upper), diff_step=1e-4, xtol=1e-8, ftol=1e-8)
    return at(solution.x)


MODELS = ("standard", "adjusted", "slip", "jorgensen", "volumetric", "area", "rings")
EVERY = {"driver-rings": 10, "7-iron-rings": 3}
"""Models identified on every n-th shot only, for the time they take; they are evaluated on all."""
OWN = ("adjusted", "slip", "volumetric")
"""Models identified also on the shots that they made themselves; `rings` made shots too, but takes too long."""
BOOTSTRAP = {"rings": 50}
RESAMPLES = 4000
DIGITS = 9
"""Significant digits kept."""

Progress = Callable[[str, float], object]
"""Called with the name of the part under way, and its completed fraction, 0 to 1."""


def run(folder: Path, *, threads: int | None = None, progress: Progress | None = None) -> dict[str, Any]:
    """Run what is not in ``folder`` yet, and return all findings, made of what JSON has."""
    prepared_folder(folder.parent)
    by_club = {club: load(club) for club in CLUBS}
    content = {
        "set of shots": by_club, "every": EVERY, "bootstrap": BOOTSTRAP, "resamples": RESAMPLES,
    }  # fmt: skip
    with Store(folder, content, remedy="give a new folder") as store:
        tour = {model: store.once(f"tour-{model}", lambda model=model: plain(fit(model).to_dict())) for model in FREE}
        # The quick models of both clubs before the slow ones of either.
        fits = {club: {} for club in CLUBS}
        for model in MODELS:
            for club, shots in by_club.items():
                fits[club][model] = fitted(shots, model, store, threads=threads, progress=progress)
        own = {
            club: {
                model: store.once(f"{club}-{model}-own", partial(_own, shots, model, store, threads, progress))
                for model in MODELS
                if model in OWN
            }
            for club, shots in by_club.items()
        }
        clubs = {
            club: _of_club(shots, fits[club], store, threads) | {"own": own[club]} for club, shots in by_club.items()
        }
    return rounded(plain({"models": list(MODELS), "clubs": clubs, "tour": tour}))


def _of_club(shots: BenchmarkShots, fits: dict[str, Any], store: Store, threads: int | None) -> dict[str, Any]:
    """Return the findings with one club."""
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
    chosen = np.arange(0, len(shots), EVERY.get(f"{shots.club}-{model}", 1))
    part = f"{shots.club}-{model}"
    return store.once(
        part,
        lambda: plain(_summary(_identified(shots, model, chosen, store.file(part), threads, progress), shots, chosen)),
    )


def _own(
    shots: BenchmarkShots, model: str, store: Store, threads: int | None, progress: Progress | None
) -> dict[str, Any]:
    """Return one model as identified on the shots that it made, and the parameters it made them with, on average."""
    chosen = np.flatnonzero(shots.model == model)
    identification = _identified(shots, model, chosen, store.file(f"{shots.club}-{model}-own"), threads, progress)
    delivery = {name: values[chosen] for name, values in shots.truth.deliveries.items()}
    true = true_parameters(recipe(shots.club), model, delivery, shots.restitution_offset[chosen]).values
    kept = {name: each for name, each in _summary(identification, shots, chosen).items() if name != "held_out"}
    return plain(kept | {"true": {name: float(np.mean(true[name])) for name in kept["free"]}})


def _identified(
    shots: BenchmarkShots, model: str, chosen: NDArray[np.int64], part: Path, threads: int | None,
    progress: Progress | None,
) -> Identification:  # fmt: skip
    """Identify one model on some of the shots of one club."""

    def tell(stage: str, done: int, subject: int, best: float) -> None:
        if progress is not None:
            progress(f"{part.name}: {stage}, cost {best:.4f}", done / subject)

    return identify(
        shots.measured.select(chosen), club=shots.head, model=model, groups=shots.player[chosen], ball=published_ball(),
        bootstrap=BOOTSTRAP.get(model, 200), threads=threads, checkpoint=part.with_suffix(".checkpoint"),
        resume=True, progress=tell,
    )  # fmt: skip


def _summary(identification: Identification, shots: BenchmarkShots, chosen: NDArray[np.int64]) -> dict[str, Any]:
    """Return what is kept of an identification, and what each shot adds to the cost when it is held out."""
    assert identification.held_out is not None
    measured = np.array([shots.measured.launches[name][chosen] for name in QUANTITIES])
    losses = np.abs(identification.held_out - measured) / np.abs(measured).mean(axis=1, keepdims=True)
    return {
        "parameters": dict(identification.parameters.values),
        "intervals": {name: list(pair) for name, pair in identification.intervals.items()},
        **{
            name: getattr(identification, name) for name in ("cost", "cost_holdout", "evaluations", "impacts", "wall_s")
        },
        "free": list(identification.free),
        "shots": identification.shots,
        "deviations": {
            name: {"unit": outputs()[name].unit, **vars(each)} for name, each in identification.deviations.items()
        },
        "identified": {name: identification.identified(name) for name in identification.free},
        "warnings": [each.sentence for each in identification.warnings],
        "settings": dict(identification.settings),
        "weak": [each.words for each in identification.identifiability.directions if each.strength != "known"],
        "profile_intervals": {name: list(each.interval) for name, each in identification.profiles.items()},
        "held_out": {"places": chosen, "losses": losses.sum(axis=0)},
    }


def _leads(shots: BenchmarkShots, fits: dict[str, Any]) -> dict[str, Any]:
    """Return by how much each model's held-out cost exceeds the least, and its interval, players drawn together.

    Models identified on a part of the shots are compared on that part.
    """
    leads = {}
    whole = {name: each for name, each in fits.items() if len(each["held_out"]["places"]) == len(shots)}
    best = min(whole, key=lambda name: whole[name]["cost_holdout"])
    for name, each in fits.items():
        places = np.array(each["held_out"]["places"])
        lead = np.array(each["held_out"]["losses"]) - np.array(fits[best]["held_out"]["losses"])[places]
        resamples = Resamples(RESAMPLES, len(places), 0, shots.player[places])
        means = resamples.means(lead[None])[:, 0]
        leads[name] = {"than": best, "more": lead.mean(), "interval": interval(means, resamples.groups)}
    return leads


def _parameters(club: str, model: str, fit: dict[str, Any]) -> ParameterSet:
    values = fit["parameters"]
    return ParameterSet(model=model, club=club, name="identified on the benchmark shots", values=values)


def _errors(shots: BenchmarkShots, sets: dict[str, ParameterSet], threads: int | None) -> dict[str, Any]:
    """Return errors of all models on all shots of a club, with players drawn together, and the best ones."""
    evaluation = evaluate(
        shots.measured, club=shots.head, models=list(MODELS), parameters=sets, groups=shots.player,
        resamples=RESAMPLES, threads=threads, ball=published_ball(),
    )  # fmt: skip
    return {
        "mean": evaluation.mean,
        "sizes": {name: {m: size._asdict() for m, size in each.items()} for name, each in evaluation.sizes.items()},
        "best": {
            name: {"model": each.model, "rivals": [rival._asdict() for rival in each.rivals]}
            for name, each in evaluation.best.items()
        },
        "cost": {model: evaluation.cost(model) for model in evaluation.models},
        "seconds": evaluation.seconds,
        "floor": evaluation.floor,
    }


def rounded(value: Any) -> Any:
    """Return ``value`` with all numbers cut to ``DIGITS`` significant digits."""
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}")
    if isinstance(value, dict):
        return {key: rounded(each) for key, each in value.items()}
    return [rounded(each) for each in value] if isinstance(value, list) else value


def main(arguments: list[str]) -> int:
    """Run the study; return the exit status."""
    if not 1 <= len(arguments) <= 2:
        print("usage: python studies/benchmark_findings.py FOLDER [RESULTS]", file=sys.stderr)
        return 2
    folder = Path(arguments[0])
    target = Path(arguments[1]) if len(arguments) == 2 else folder / "findings.json"
    announced = ""

    def report(what: str, part: float) -> None:
        nonlocal announced
        line = f"{what}: {part:.0%}"
        if sys.stderr.isatty():
            print(f"\r{line:<79}", end="", file=sys.stderr, flush=True)
        elif what.partition(",")[0] != announced:
            announced = what.partition(",")[0]
            print(line, file=sys.stderr, flush=True)

    try:
        findings = run(folder, progress=report)
        write_text(target, json.dumps(findings, indent=1, allow_nan=False) + "\n")
    except KeyboardInterrupt:
        print(f"\ninterrupted; what is finished is in {folder}, and the next run goes on after it", file=sys.stderr)
        return 130
    except ClubfaceError as error:
        print(f"benchmark_findings: {error}", file=sys.stderr)
        return 2
    print(target)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
