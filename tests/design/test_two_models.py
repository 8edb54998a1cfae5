"""Two models managed together: known optima of closed forms, ways back within limits, and laws of the search."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from clubface.design.shells.trust_region import Goal, trust_region_search as search
from clubface.errors import RunError

pytest.importorskip("scipy")

INF = math.inf
LIGHTEST = Goal(objective="mass", largest=False, limits={"strength": (1.0, INF)})


def exact_as(model):
    return lambda places: [model(place) for place in places]


def walls(powers=(1.0, 2.0), factor=1.0):
    """Two walls from 0.5 to 2.5: a mass x + 2 y, and a strength that is a product of powers."""

    def model(place):
        x, y = 0.5 + 2.0 * np.asarray(place)
        return {"mass": float(x + 2.0 * y), "strength": float(factor * x ** powers[0] * y ** powers[1])}

    return model


LEAST_MASS = 3.0
"""Of walls with x y^2 >= 1: by Lagrange 1 = l y^2 and 2 = 2 l x y, so that x = y = 1."""


def test_one_proposal_is_enough_where_the_fast_model_is_exact():
    model = walls()
    result = search(model, exact_as(model), np.array([0.7, 0.7]), LIGHTEST, radius=1.0, neighbours=False)
    assert [step.kind for step in result.steps] == ["start", "proposal"]
    assert result.ended == "no proposal promised a gain"
    # A proposal aims 0.05% inside of the limit, which costs a third of that.
    assert result.steps[1].values["mass"] == pytest.approx(LEAST_MASS, rel=5e-4)
    assert result.steps[1].promised == pytest.approx(result.steps[1].values, rel=1e-12)


def test_a_factor_with_slopes_is_learnt_from_neighbours():
    # What is wrong with the fast model is a factor exp(linear): the neighbours of the start tell all of it.
    fast = walls()

    def exact(place):
        values = fast(place)
        return {**values, "strength": values["strength"] * math.exp(0.2 - 0.5 * place[0] + 0.3 * place[1])}

    result = search(fast, exact_as(exact), np.array([0.6, 0.6]), LIGHTEST, radius=1.0)
    # The second round of neighbours confirms what the first proposal found.
    assert [step.kind for step in result.steps] == ["start", *["neighbour"] * 2, "proposal", *["neighbour"] * 2]
    best = result.steps[3]
    assert result.best == 3
    assert best.promised == pytest.approx(best.values, rel=1e-6)
    assert best.values["strength"] == pytest.approx(1.0, rel=1e-3)


def test_a_poor_fast_model_costs_runs_and_not_the_optimum():
    result = search(walls((0.5, 1.2), 0.6), exact_as(walls()), np.array([0.9, 0.6]), LIGHTEST, most=40)
    # The search ends where 0.01% are promised; the optimum is flat along the limit.
    assert result.steps[result.best].values["mass"] == pytest.approx(LEAST_MASS, rel=1e-3)
    assert result.steps[result.best].values["strength"] >= 1.0


def test_a_start_beyond_the_limits_finds_its_way_back():
    result = search(walls((0.5, 1.2)), exact_as(walls()), np.array([0.02, 0.02]), LIGHTEST, most=40)
    assert LIGHTEST.violation(result.steps[0].values) > 0.5
    assert result.steps[result.best].values["mass"] == pytest.approx(LEAST_MASS, rel=1e-3)
    assert LIGHTEST.violation(result.steps[result.best].values) == 0.0


def test_a_design_that_fails_is_refused_and_the_region_shrinks():
    model = walls()

    def exact(places):
        # Walls below 1.2 cannot be run.
        return [model(place) if place[0] >= 0.35 else dict.fromkeys(model(place), math.nan) for place in places]

    result = search(model, exact, np.array([0.8, 0.8]), LIGHTEST, radius=1.0, neighbours=False, most=12)
    failed = [step for step in result.steps if math.isnan(step.values["mass"])]
    assert failed
    assert not any(step.accepted for step in failed)
    assert result.steps[result.best].place[0] >= 0.35
    later = result.steps[result.steps.index(failed[0]) + 1]
    assert later.radius < 1.0
    assert result.steps[result.best].values["mass"] < model(np.array([0.8, 0.8]))["mass"]


def test_a_failing_start_is_reported():
    with pytest.raises(RunError, match="the starting design fails"):
        search(walls(), lambda places: [dict.fromkeys(("mass", "strength"), math.nan)], np.array([0.5, 0.5]), LIGHTEST)


@settings(max_examples=25)
@given(
    powers=st.tuples(st.floats(0.3, 2.5), st.floats(0.3, 2.5)),
    start=st.tuples(st.floats(0.0, 1.0), st.floats(0.0, 1.0)),
    most=st.integers(2, 12),
)
def test_the_best_is_the_best_of_all_that_were_judged(powers, start, most):
    result = search(walls(), exact_as(walls(powers)), np.array(start), LIGHTEST, most=most, neighbours=most > 3)
    best = result.steps[result.best].values
    assert len(result.steps) <= most
    assert all(0.0 <= share <= 1.0 for step in result.steps for share in step.place)
    assert not any(LIGHTEST.better(step.values, best) for step in result.steps)
    for before, step in zip(result.steps, result.steps[1:], strict=False):
        if step.kind == "proposal":
            assert step.radius <= max(1.0, 2.0 * before.radius)
