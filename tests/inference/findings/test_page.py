"""The page of findings: its results are those the package computes, its sentences those the results say."""

import json
import math
import re
from pathlib import Path

import benchmark_findings as findings
import numpy as np
import pytest
from benchmark_findings import bias_of, bias_of_magnitudes, error_budget

import clubface
from clubface.equipment.balls import published_ball
from clubface.equipment.parameters import ParameterSet
from clubface.inference.evaluation import published
from clubface.shots.measured import QUANTITIES
from clubface.validation import benchmark_data, tour
from clubface.validation.benchmark_data import recipe

pytest.importorskip("pyarrow")

DOCS = Path(__file__).parents[3] / "docs"
FINDINGS = json.loads((DOCS / "findings.json").read_text(encoding="utf-8"))
NUMBER = re.compile(r"(?<![\w.])(-?\d+(\.\d+)?)(?![\d]|\.\d)(?: ?(°|%|rpm|mm|µs|s/m|GN/m³|N m s/rad|degrees)(?!\w))?")
RPM, DEG = math.pi / 30, math.pi / 180


def parameters(club, model):
    return findings._parameters(club, model, FINDINGS["clubs"][club]["fits"][model])


def sections():
    """Every section of the page: of each sentence its numbers, as (value, step of the last digit, unit)."""
    page = re.sub(r"<!--.*?-->", "", (DOCS / "findings.md").read_text(encoding="utf-8"), flags=re.DOTALL)
    for section in page.split("\n#")[1:]:
        title, text = section.lstrip("# ").split("\n", 1)
        sentences = re.split(r"(?<=\.)\s+(?=[A-Z`*])|\n\n", text)
        yield (
            title,
            [
                [
                    (float(number), 10.0 ** -max(len(digits) - 1, 0), unit)
                    for number, digits, unit in NUMBER.findall(" ".join(each.split()))
                ]
                for each in sentences
            ],
        )


SECTIONS = dict(sections())


def stated(section, *figures, slack=0.5):
    """Whether a sentence of a section has these numbers, whatever its words.

    Each figure is (value, unit), in the order of the sentence; the unit is "" where no unit follows the number. The
    number is that value rounded, to `slack` of its last digit.
    """
    return any(_in_order(sentence, figures, slack) for sentence in SECTIONS[section])


def _in_order(sentence, figures, slack):
    rest = iter(sentence)
    return all(
        any(unit == stated_unit and abs(value - number) <= slack * step for number, step, stated_unit in rest)
        for value, unit in figures
    )


@pytest.mark.parametrize("club", benchmark_data.CLUBS)
def test_the_identified_parameters_have_the_errors_stored(club):
    shots, result = benchmark_data.load(club), FINDINGS["clubs"][club]
    for model in FINDINGS["models"]:
        launch = clubface.impact(
            shots.head,
            shots.measured.deliveries,
            model=model,
            parameters=parameters(club, model),
            ball=published_ball(),
        )
        cost = 0.0
        for name in QUANTITIES:
            measured = shots.measured.launches[name]
            mae = np.abs(getattr(launch, name) - measured).mean()
            cost += mae / np.abs(measured).mean()
            # Nine digits are stored, of parameters too; the last one moves the steps through contact by some 1e-5.
            assert result["errors"]["sizes"][name][model]["mae"] == pytest.approx(mae, rel=1e-4), (model, name)
        assert result["errors"]["cost"][model] == pytest.approx(cost, rel=1e-4)
        if result["fits"][model]["shots"] == len(shots):
            assert result["fits"][model]["cost"] == pytest.approx(cost, rel=1e-4)


def test_no_identification_is_worse_than_the_published_set():
    for club in benchmark_data.CLUBS:
        shots = benchmark_data.load(club)
        for model in ("standard", "adjusted", "slip", "volumetric", "area"):
            before = clubface.evaluate(shots.measured, models=model, resamples=100).cost(model)
            assert FINDINGS["clubs"][club]["errors"]["cost"][model] < before


@pytest.mark.parametrize("club", benchmark_data.CLUBS)
def test_models_on_their_own_shots_have_the_cost_stored_and_the_true_values_of_the_recipe(club):
    shots, recipe_used = benchmark_data.load(club), recipe(club)
    for model, result in FINDINGS["clubs"][club]["own"].items():
        own = np.flatnonzero(shots.model == model)
        assert result["shots"] == len(own)
        delivery = {name: values[own] for name, values in shots.measured.deliveries.items()}
        values = findings._parameters(club, model, result)
        launch = clubface.impact(shots.head, delivery, model=model, parameters=values, ball=published_ball())
        measured = {name: shots.measured.launches[name][own] for name in QUANTITIES}
        cost = sum(np.abs(getattr(launch, name) - measured[name]).mean() / np.abs(measured[name]).mean()
                   for name in QUANTITIES)  # fmt: skip
        assert result["cost"] == pytest.approx(cost, rel=1e-4), model
        for name, value in recipe_used.mixture[model].changed.items():
            assert result["true"].get(name, value) == pytest.approx(value, rel=1e-8)


def test_the_error_budget_is_that_of_the_parameters_stored():
    for club, model in (("driver", "adjusted"), ("7-iron", "volumetric")):
        budget = error_budget(benchmark_data.load(club), parameters(club, model))
        for source, each in budget.items():
            assert FINDINGS["clubs"][club]["budget"][model][source] == pytest.approx(each, rel=1e-4)


@pytest.mark.parametrize("model", list(findings.FREE))
def test_one_set_for_all_clubs_has_the_errors_stored(model):
    result = FINDINGS["tour"][model]
    shared = ParameterSet(model=model, club="any", name="x", values=result["parameters"])
    errors, lofts = findings.Bag(tour.averages(findings.SEASON)).errors(shared)
    # Parameters of nine digits; the errors are differences of numbers a hundred times larger. In a contact model the
    # tenth digit can move a step through contact, and its launch is computed to 1e-4: by `area`, whose launch angle
    # hardly changes with some lofts, that moves a solved loft by 3e-5 and a spin by 6e-4 of the largest error.
    contact = clubface.models()[model].kind == "contact"
    assert result["lofts"] == pytest.approx(lofts, abs=5e-5 if contact else 1e-8)
    for name in ("ball_speed", "spin"):
        closely = 1e-3 if contact else 1e-7
        assert result["errors"][name] == pytest.approx(errors[name], abs=closely * np.abs(errors[name]).max())


def test_the_sentences_on_one_set_for_all_clubs_are_those_of_the_fits():
    def mean(model, kind, name):
        return np.mean(np.abs(FINDINGS["tour"][model][kind][name]))

    for name in ("ball_speed", "spin"):
        for kind in ("errors", "left_out"):
            assert min(FINDINGS["tour"], key=lambda model: mean(model, kind, name)) == "rings"
        assert mean("rings", "left_out", name) < 1.2 * mean("rings", "errors", name)
    errors = FINDINGS["tour"]["rings"]["errors"]
    # To the nearest ten.
    assert stated("One set for all clubs", (np.abs(errors["spin"]).max() / RPM, "rpm"), slack=5)
    speeds = dict(zip(FINDINGS["tour"]["rings"]["clubs"], errors["ball_speed"], strict=True))
    assert sorted(speeds, key=lambda club: abs(speeds[club]))[-2:] == ["driver", "pitching-wedge"]
    assert speeds["driver"] < 0.0 < speeds["5-iron"]


def test_the_sentences_on_azimuth_and_sidespin_are_those_of_the_budget():
    budget = FINDINGS["clubs"]["driver"]["budget"]["adjusted"]

    def figures(source):
        return (budget[source]["azimuth"] / DEG, "°"), (budget[source]["sidespin"] / RPM, "rpm")

    assert stated("Where the errors come from", *figures("extrapolation"), *figures("capture"))
    assert stated("Where the errors come from", *figures("all"))
    given = published()["adjusted", "driver"]
    assert budget["all"]["azimuth"] < 0.5 * given.mae["azimuth"]
    assert budget["all"]["sidespin"] / given.mae["sidespin"] == pytest.approx(2 / 3, abs=0.05)
    # A random face error that lifts the mean magnitude to the published one; a degree of face is 0.85 of azimuth.
    missing = math.sqrt(given.mae["azimuth"] ** 2 - budget["all"]["azimuth"] ** 2) * math.sqrt(math.pi / 2) / 0.85
    assert missing / DEG == pytest.approx(1.0, abs=0.1)


def test_the_sentences_on_bias_are_those_of_the_published_figures():
    ratios, biases = [], []
    for given in published().values():
        if given.std:
            pair = (given.mae["azimuth"], given.std["azimuth"])
            ratios.append(pair[0] / pair[1])
            biases += [bias_of(*pair) / DEG, bias_of_magnitudes(*pair) / DEG]
    assert stated("Where the errors come from", (min(ratios), ""), (max(ratios), ""))
    assert stated("Where the errors come from", (min(biases), ""), (max(biases), "degrees"))


def test_the_sentences_on_hold_out_are_those_of_the_costs():
    iron = FINDINGS["clubs"]["7-iron"]
    for model, loss in (("volumetric", 0.01), ("adjusted", 0.005)):
        fit = iron["fits"][model]
        assert fit["cost_holdout"] / fit["cost"] - 1 == pytest.approx(loss, abs=0.003)
    low, high = iron["held_out"]["volumetric"]["interval"]
    reach = 0.5 * (high - low) / iron["fits"]["adjusted"]["cost_holdout"]
    assert stated("Held out", (100 * reach, "%"))
    # It has no lead, by either reading.
    assert iron["held_out"]["volumetric"]["more"] > 0


def test_the_order_of_the_models_is_the_one_stated():
    for result in FINDINGS["clubs"].values():
        costs = result["errors"]["cost"]
        assert min(costs, key=lambda name: costs[name]) == "adjusted"
    costs = FINDINGS["clubs"]["driver"]["errors"]["cost"]
    given = {
        model: sum(each.mae[name] / each.mean[name] for name in QUANTITIES)
        for (model, club), each in published().items()
        if club == "driver"
    }
    assert min(given, key=lambda name: given[name]) == "adjusted"
    for model in ("volumetric", "area"):
        assert costs[model] < costs["slip"]
        assert given[model] > given["slip"]


def test_the_sentences_on_impulse_models_are_those_of_the_fits():
    driver = FINDINGS["clubs"]["driver"]
    slope = recipe("driver").restitution_slope
    assert stated("Impulse models", (slope, "s/m"))
    # Half a unit of the last digit with which the page states it.
    assert driver["fits"]["standard"]["parameters"]["cor_slope"] == pytest.approx(slope, abs=5e-5)
    published_y = ParameterSet.builtin("adjusted", "driver").values["dcg_y"]
    assert stated("Impulse models", (1e3 * published_y, "mm"))
    low, high = driver["fits"]["adjusted"]["intervals"]["dcg_y"]
    assert published_y < low - 10 * (high - low)
    slip, names = driver["own"]["slip"], ("slip_y", "slip_z")
    ends = [slip["intervals"][name] for name in names]
    own, true = ([slip[kind][name] for name in names] for kind in ("parameters", "true"))
    assert stated("Impulse models", *((each, "") for each in (*own, *(high - low for low, high in ends), *true)))
    assert all(not low <= value <= high for value, (low, high) in zip(true, ends, strict=True))


def test_the_true_values_are_held_as_often_as_stated():
    held = [
        low <= own["true"][name] <= high
        for result in FINDINGS["clubs"].values()
        for own in result["own"].values()
        for name, (low, high) in own["intervals"].items()
    ]
    counts = ((len(held), ""), (sum(held), ""), (95, "%"), (round(0.95 * len(held)), ""))
    assert stated("Impulse models", *counts, slack=0)


def test_what_cannot_be_known_is_what_the_identification_says():
    clubs, unit = FINDINGS["clubs"], 1e9
    drives, irons = ([*clubs[club]["own"]["volumetric"]["intervals"]["stiffness"]] for club in benchmark_data.CLUBS)
    assert stated("Contact models", (drives[0] / unit, ""), (drives[1] / unit, "GN/m³"))
    assert stated("Contact models", *((each / unit, "") for each in irons))
    times, forces, known = [], [], []
    for result in clubs.values():
        own, fit = result["own"]["volumetric"], result["fits"]["volumetric"]
        times.append(fit["parameters"]["stiffness"] / own["true"]["stiffness"])
        forces += [each for each in fit["warnings"] if "contact lasts" in each]
        assert fit["identified"]["damping"] == "yes"
        low, high = fit["intervals"]["damping"]
        known.append(50.0 * (high - low) / fit["parameters"]["damping"])
        # In every fit to all shots something of the grip meets a bound.
        assert any(re.match("(layer|cover|transition|friction).* meets its", each) for each in fit["warnings"])
    assert stated("Contact models", *((each, "%") for each in known))
    assert times == pytest.approx([4, 10], rel=0.06)
    drive, iron = (int(re.search(r"(\d+) us on average", each)[1]) for each in forces)
    assert stated("Contact models", (drive, ""), (iron, "µs"), slack=0)
    driver = clubs["driver"]
    fit, own = driver["fits"]["volumetric"], driver["own"]["volumetric"]
    assert own["parameters"]["stiffness"] / own["true"]["stiffness"] == pytest.approx(1.5, abs=0.05)
    likelihood = fit["profile_intervals"]["stiffness"][0]
    assert stated("Contact models", (likelihood / unit, "GN/m³"), (fit["parameters"]["stiffness"] / unit, ""))
    both = [own[kind][name] for kind in ("true", "parameters") for name in ("layer_damping", "friction")]
    assert stated("Contact models", *zip(both, ("N m s/rad", "", "", ""), strict=True))
    for result in clubs.values():
        area = result["fits"]["area"]
        assert any("poisson" in each and "no launch changes" in each for each in area["weak"])
        assert area["parameters"]["area_damping"] > 999
    ratios = [
        result["fits"]["rings"]["parameters"]["shear_modulus"]
        / ParameterSet.builtin("rings", club).values["shear_modulus"]
        for club, result in clubs.items()
    ]
    assert stated("Contact models", (min(ratios), ""), (max(ratios), ""))
