"""The parts of an identification: points and parameters, exact derivatives, refinement, search, what shots can tell."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.optimize import linprog, minimize

from clubface.equipment.models import models
from clubface.errors import InputError, UnknownNameError
from clubface.inference.identification.intervals import (
    CHI_SQUARE_95,
    Profiler,
    _crossing,
    errors_of_minimum,
    identifiability,
    scatter,
)
from clubface.inference.identification.problem import free_parameters
from clubface.inference.identification.run import Stages
from clubface.inference.identification.search import Population, least_absolute, refine, search
from clubface.inference.identification.simulator import noise_of
from synthetic_shots import fitted, published, recorded

MODELS = tuple(models())


@given(st.sampled_from(MODELS), st.integers(0, 2**32 - 1))
def test_points_of_the_unit_cube_and_parameters_within_bounds_are_two_names_of_the_same(model, seed):
    free = free_parameters(published(model), "all")
    rng = np.random.default_rng(seed)
    points = rng.choice([0.0, 1.0, *rng.uniform(size=3)], (4, len(free)))
    values = free.values(points)
    assert (values >= free.lower).all()
    assert (values <= free.upper).all()
    # Relative rounding of the exponential over at most five decades.
    assert free.points(values) == pytest.approx(points, abs=1e-14)
    assert free.parameters(points[0], name="x").values[free.names[0]] == values[0, 0]


def test_a_positive_parameter_over_more_than_a_decade_is_searched_by_its_logarithm():
    free = free_parameters(published("volumetric"))
    logarithmic = dict(zip(free.names, free.logarithmic, strict=True))
    assert logarithmic["stiffness"]
    assert not logarithmic["damping"]
    middle = free.values(np.full(len(free), 0.5))
    assert middle[free.names.index("stiffness")] == pytest.approx(np.sqrt(1e8 * 1e11))


def test_the_free_parameters_are_those_of_the_publication_unless_chosen():
    assert free_parameters(published("adjusted")).names == ("extra_mass", "dcg_x", "dcg_y", "dcg_z")
    rings = free_parameters(published("rings"))
    assert len(rings) == 4
    assert rings.single(np.full(4, 0.5))[4] == rings.single(np.full(4, 0.5))[0]  # ring_modulus follows shear_modulus
    assert free_parameters(published("standard")).names == ("cor", "cor_slope")
    assert free_parameters(published("volumetric"), ["friction", "damping"]).names == ("damping", "friction")
    for wanted, error, text in (
        ([], InputError, "at least one parameter"),
        (["fricton"], UnknownNameError, "friction"),
    ):
        with pytest.raises(error, match=text):
            free_parameters(published("volumetric"), wanted)
    for options, text in (
        ({"bounds": {"friction": ("0.5", "0.4")}}, "increasing, within 0 to 2"),
        ({"bounds": {"friction": 0.5}}, "a pair"),
        ({"tied": {"damping": "friction"}}, "not free itself"),
        ({"tied": {"damping": "stiffness"}}, "for damping to follow"),
    ):
        with pytest.raises((InputError, UnknownNameError), match=text):
            free_parameters(published("volumetric"), ["friction", "damping"], **options)


# Tolerance of a contact step, step of the differences and what they leave of the size of a launch. Contacts are
# integrated tightly: at the fast setting a launch jumps by some 1e-5 where a contact takes a step more. Their global
# error, some 1e-10, over the step is what is left; the area model is stiff. Rings at the fast setting are smooth but
# for kinks where one begins to slip.
DIFFERENCES = {"volumetric": (1e-13, 1e-4, 2e-5), "area": (1e-13, 1e-4, 5e-4), "rings": (None, 1e-5, 1e-6)}


@pytest.mark.parametrize("model", MODELS)
def test_derivatives_of_all_shots_are_those_of_differences(model):
    accuracy, step, tolerance = DIFFERENCES.get(model, (None, 1e-5, 1e-6))
    shots = recorded(3, model, noise=1.0)
    # The coefficients of response come from finite elements; shots say something of its friction.
    free = {"rings": None, "response": ["friction"]}.get(model, "all")
    simulator, _, point = fitted(shots, model, free=free, accuracy=accuracy)
    point = np.clip(point, 0.1, 0.9)
    launches, derivatives = simulator.derivatives(point)
    assert np.array_equal(launches, simulator.launch(point))
    size = np.abs(launches).max(axis=1)[:, None]
    for place, name in enumerate(simulator.free.names):
        shift = step * (np.arange(len(point)) == place)
        above, below = simulator.launch(point + shift), simulator.launch(point - shift)
        differences = (above - below) / (2.0 * step)
        assert np.all(np.abs(derivatives[:, place] - differences) <= tolerance * size), name


@pytest.mark.parametrize("cost", ["least-squares", "robust", "published"])
def test_the_gradient_of_a_cost_is_that_of_differences(cost):
    simulator, judged, point = fitted(recorded(6, "adjusted", noise=1.0), "adjusted", cost=cost)
    point = np.clip(point + 0.01, 0.0, 1.0)
    launches, derivatives = simulator.derivatives(point)
    deviations = launches - judged.measured
    slopes = {
        "absolute": np.sign(deviations),
        "squares": 2.0 * deviations,
        "huber": 2.0 * np.clip(deviations, -judged.knees[:, None], judged.knees[:, None]),
    }[judged.loss]
    gradient = np.einsum("qs,qfs->f", slopes * judged.weights, derivatives)
    for place in range(len(point)):
        shift = 1e-7 * (np.arange(len(point)) == place)
        difference = judged.value(simulator.launch(point + shift)) - judged.value(simulator.launch(point - shift))
        # Rounding of a cost of order 10 over a step of 2e-7.
        assert gradient[place] == pytest.approx(difference / 2e-7, rel=1e-6, abs=1e-7 * np.abs(gradient).max())


@settings(max_examples=8)
@given(st.integers(0, 2**32 - 1))
def test_a_refinement_ends_no_worse_than_a_bounded_quasi_newton_method(seed):
    """The mean absolute error has kinks; L-BFGS-B with its exact (sub)gradient stops at them."""
    rng = np.random.default_rng(seed)
    simulator, cost, point = fitted(recorded(25, "adjusted", noise=1.0, seed=seed % 1000), "adjusted")
    start = np.clip(point + rng.uniform(-0.05, 0.05, len(point)), 0.0, 1.0)

    def value_and_gradient(at):
        launches, derivatives = simulator.derivatives(at)
        signs = np.sign(launches - cost.measured) * cost.weights
        return cost.value(launches), np.einsum("qs,qfs->f", signs, derivatives)

    ours = refine(simulator, cost, start)
    theirs = minimize(value_and_gradient, start, jac=True, method="L-BFGS-B", bounds=[(0.0, 1.0)] * len(start))
    # Equal where both find the minimum, to the tolerance of the last step.
    assert ours.cost <= theirs.fun * (1.0 + 1e-9)


@settings(max_examples=60)
@given(st.integers(0, 2**32 - 1), st.integers(1, 60), st.integers(1, 7), st.sampled_from(["plain", "twins", "blind"]))
def test_least_absolute_deviations_are_those_of_a_linear_program(seed, count, free, kind):
    """The sum of t with -t <= deviations + rows step <= t, by another program."""
    rng = np.random.default_rng(seed)
    rows = rng.normal(size=(count, free)) * 10.0 ** rng.uniform(-2, 2, free)
    deviations = rng.normal(size=count) * 10.0 ** rng.uniform(-3, 3)
    if kind == "twins":  # equal shots
        rows, deviations = np.repeat(rows, 3, axis=0), np.repeat(deviations, 3)
    if kind == "blind":  # a parameter that changes nothing, and two that change the same
        rows[:, 0] = 0.0
        rows[:, -1] = rows[:, free // 2]
    reach = 10.0 ** rng.uniform(-3, 1) * np.abs(deviations).mean()
    lower, upper = -reach * rng.uniform(0, 1, free), reach * rng.uniform(0, 1, free)
    result = least_absolute(deviations, rows, lower, upper)
    assert (result >= lower).all()
    assert (result <= upper).all()
    bound = np.concatenate([-deviations, deviations])
    identity = np.eye(len(deviations))
    expected = linprog(
        np.concatenate([np.zeros(free), np.ones(len(deviations))]),
        A_ub=np.block([[rows, -identity], [-rows, -identity]]),
        b_ub=bound,
        bounds=[*zip(lower, upper, strict=True), *[(0.0, None)] * len(deviations)],
    )
    # Ties are told apart by 1e-9 of the mean deviation; the program's own tolerance is 1e-7.
    assert np.abs(deviations + rows @ result).sum() <= expected.fun + 1e-6 * np.abs(deviations).sum()


def test_a_refinement_keeps_to_bounds_and_to_what_is_held():
    simulator, cost, point = fitted(
        recorded(20, "slip"), "slip", free=["cor", "slip_y", "slip_z"], bounds={"slip_y": (-0.009, 0.5)}
    )
    result = refine(simulator, cost, np.clip(point + 0.02, 0.0, 1.0))
    # The truth, -0.0103, lies below the bound.
    assert result.point[simulator.free.names.index("slip_y")] == 0.0
    held = np.array([True, False, False])
    start = np.clip(point + 0.02, 0.0, 1.0)
    assert refine(simulator, cost, start, held=held).point[0] == start[0]


def test_a_search_goes_on_from_any_generation_to_the_same_bits():
    def costs_of(points):
        return np.sum((points - 0.3) ** 2, axis=1) + 0.01 * np.abs(np.sin(40.0 * points)).sum(axis=1)

    seen = []
    whole = search(costs_of, 3, population=12, generations=9, seed=5, after_generation=seen.append)
    assert [each.generation for each in seen] == list(range(1, 10))
    for begun in (seen[0], seen[4]):
        again = search(costs_of, 3, population=12, generations=9, seed=5, begun=begun)
        assert np.array_equal(again.points, whole.points)
        assert np.array_equal(again.costs, whole.costs)
    other = search(costs_of, 3, population=12, generations=9, seed=6)
    assert not np.array_equal(other.points, whole.points)
    assert whole.costs.min() < 0.02


def test_the_best_of_a_population_come_first():
    points = np.arange(8.0).reshape(4, 2)
    assert Population(1, points, np.array([3.0, 1.0, np.inf, 2.0])).best(2).tolist() == [[2.0, 3.0], [6.0, 7.0]]


def test_parameters_without_effect_are_proven_and_named():
    """In the area model shear modulus G and Poisson's ratio nu enter as G / (1 - nu) alone (published Eq. 15)."""
    shots = recorded(20, "area")
    simulator, cost, point = fitted(shots, "area", free=["shear_modulus", "poisson", "damping"])
    identified = identifiability(simulator, point, scatter(simulator.launch(point) - cost.measured, np.full(5, 1e-3)))
    assert [each.strength for each in identified.directions] == ["none", "known", "known"]
    assert "poisson up and shear_modulus down together" in identified.directions[0].words
    assert set(identified.unknown) == {"shear_modulus", "poisson"}
    # Along it G / (1 - nu) stays: dG / G = -d nu / (1 - nu), in coordinates ln G / ln 1000 and nu / 0.499.
    step = identified.directions[0].vector / identified.directions[0].vector[1]
    assert step[0] == pytest.approx(-0.499 / (1.0 - 0.398) / np.log(1000.0), rel=1e-6)


def test_the_interval_of_what_is_not_known_holds_the_fit():
    """Profiles are of least squares, samples lead anywhere: both may miss a fit that is as good as any."""
    simulator, cost, point = fitted(recorded(20, "area"), "area", free=["shear_modulus", "poisson", "damping"])
    identified = identifiability(simulator, point, noise_of(simulator.shots.quantities))
    fit = simulator.free.values(point)
    stages: Any = SimpleNamespace(simulator=simulator, cost=cost, settings={"confidence": 0.95})
    samples = np.repeat([1.2 * fit], 20, axis=0)
    profile: Any = SimpleNamespace(interval=(2.0 * fit[0], 3.0 * fit[0]))
    result = Stages._intervals(stages, point, identified, samples, {"shear_modulus": profile})
    assert result["shear_modulus"] == pytest.approx((fit[0], 3.0 * fit[0]), rel=1e-12)
    assert result["poisson"] == pytest.approx((simulator.free.lower[1], simulator.free.upper[1]), abs=1e-12)
    assert result["damping"] == pytest.approx((1.2 * fit[2], 1.2 * fit[2]), rel=1e-12)


def test_standard_errors_are_those_of_linear_least_squares():
    simulator, _, point = fitted(recorded(30, "slip"), "slip")
    noise = np.array([1.0, 0.01, 0.01, 5.0, 5.0])
    identified = identifiability(simulator, point, noise)
    rows = (simulator.derivatives(point)[1] / noise[:, None, None]).transpose(0, 2, 1).reshape(-1, 2)
    covariance = np.linalg.inv(rows.T @ rows)
    assert identified.errors == pytest.approx(np.sqrt(np.diag(covariance)), rel=1e-9)
    expected = covariance[0, 1] / np.sqrt(covariance[0, 0] * covariance[1, 1])
    assert identified.correlations[0, 1] == pytest.approx(expected, abs=1e-9)


def test_the_profile_of_a_nearly_linear_model_is_its_normal_interval():
    simulator, cost, point = fitted(recorded(40, "slip", noise=1.0), "slip", cost="least-squares")
    noise = noise_of(simulator.shots.quantities)
    optimum = refine(simulator, cost, point).point
    identified = identifiability(simulator, optimum, noise)
    profile = Profiler(simulator, noise, identified.errors).profile(0, optimum)
    reach = 1.959964 * identified.errors[0] * np.array([-1.0, 1.0])
    expected = simulator.free.values(optimum + np.array([[1.0, 0.0]]) * reach[:, None])[:, 0]
    # The curvature of the launches over one standard error, 0.2% of the range, changes it by about 1%.
    assert profile.interval == pytest.approx(expected, abs=0.02 * np.ptp(expected))
    assert profile.closed == (True, True)
    assert profile.verdict == "yes"
    assert profile.rise.min() == 0.0


def test_a_profile_that_falls_again_holds_all_that_is_likely():
    """Between two valleys the likelihood may be low; neither of them is excluded by the other."""
    where = np.array([0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    level = CHI_SQUARE_95
    two_valleys = np.array([0.0, 2.0, 1.5, 0.25, 0.5, 1.5, 4.0]) ** 2 * level
    assert _crossing(where, two_valleys, -1) == (0.0, False)
    # The root of the rise goes from 0.5 at 0.4 to 1.5 at 0.5 and so is 1 in the middle.
    assert _crossing(where, two_valleys, 1) == (pytest.approx(0.45, rel=1e-12), True)
    assert _crossing(where, two_valleys[::-1], -1) == (pytest.approx(0.15, rel=1e-12), True)
    assert _crossing(where, two_valleys[::-1], 1) == (0.6, False)


def test_without_a_bootstrap_the_errors_are_those_of_the_cost_that_is_minimised():
    """Of least squares those of the information, of mean absolute errors sqrt(pi / 2) times those."""
    shots = recorded(40, "adjusted", noise=1.0)
    simulator, squares, point = fitted(shots, "adjusted", cost="least-squares")
    identified = identifiability(simulator, point, noise_of(simulator.shots.quantities))
    assert errors_of_minimum(simulator, squares, point, identified) == pytest.approx(identified.errors, rel=1e-9)
    absolute = errors_of_minimum(simulator, squares.absolute(), point, identified)
    assert absolute == pytest.approx(np.sqrt(np.pi / 2.0) * identified.errors, rel=1e-9)
    _, huber, _ = fitted(shots, "adjusted", cost="robust")
    # 95% efficient: P. J. Huber's 1.345.
    assert errors_of_minimum(simulator, huber, point, identified) == pytest.approx(
        identified.errors / np.sqrt(0.95), rel=1e-3
    )
    # The published weights are not those of the noise.
    _, published_, _ = fitted(shots, "adjusted")
    assert np.all(errors_of_minimum(simulator, published_, point, identified) > 1.01 * absolute)


def test_parameters_without_effect_have_no_standard_error():
    simulator, cost, point = fitted(recorded(20, "area"), "area", free=["shear_modulus", "poisson", "damping"])
    identified = identifiability(simulator, point, noise_of(simulator.shots.quantities))
    assert np.isfinite(errors_of_minimum(simulator, cost, point, identified)).tolist() == [False, False, True]
