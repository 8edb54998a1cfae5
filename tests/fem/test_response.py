"""The coefficients of ``response``: their strikes, their fit, and what they leave."""

import shutil
import tomllib
from pathlib import Path

import numpy as np
import pytest
import response_fit
from response_fit import (
    COLUMNS,
    LIGHT,
    PARTS,
    TARGETS,
    effective_mass,
    figure,
    fit,
    fitted,
    in_fit,
    run,
    scales,
    simulated,
    summary,
    weights,
)

import clubface
from clubface import fem

STUDY = Path(__file__).parents[2] / "studies" / "response"
DEFAULTS = {each.name: each.default for each in clubface.models()["response"].parameters}


def file_of(ball):
    return tomllib.loads((STUDY / f"{ball}.toml").read_text(encoding="utf-8"))["parameters"]["response"]


@pytest.fixture(scope="module", autouse=True)
def planned():
    """The strikes of the study, whose design takes seconds, designed once for all tests."""
    made = response_fit.strikes(PARTS)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(response_fit, "strikes", lambda _: made)
        yield made


@pytest.fixture(scope="module")
def table():
    """The strikes as they are kept: no run is needed."""
    return run(fem.ball("modern"), PARTS, STUDY / "modern.csv")


def test_the_values_of_the_registry_and_of_the_balls_are_those_of_the_study():
    assert {name: DEFAULTS[name] for name in fitted()} == file_of("modern")
    assert dict(clubface.ball("distance").parameters["response"]) == file_of("distance")


def test_rows_that_are_gone_or_of_another_strike_are_run_again_and_no_others(tmp_path):
    """To the nine digits of the table, so that its rows are what the finite elements give. A sum of the inputs tells
    the row of another strike."""
    lines = (STUDY / "modern.csv").read_text(encoding="utf-8").splitlines()
    gone, moved = [lines[5], lines[1500]], lines[7]
    of_another = ",".join([*moved.split(",")[:2], *lines[8].split(",")[2:]])
    copy = tmp_path / "modern.csv"
    kept = [of_another if line == moved else line for line in lines if line not in gone]
    copy.write_text("\n".join(kept) + "\n", encoding="utf-8")
    done = []
    run(fem.ball("modern"), PARTS, copy, progress=lambda rows, whole: done.append((rows, whole)))
    whole = len(lines) - 2
    assert done == [(rows, whole) for rows in range(whole - 3, whole + 1)]
    for old, new in zip([*gone, moved], rows_of(copy, [*gone, moved]), strict=True):
        assert numbers(new) == pytest.approx(numbers(old), rel=2e-8)
    unchanged = [line for line in lines[2:] if line not in (*gone, moved)]
    assert rows_of(copy, unchanged) == unchanged


def rows_of(path, lines):
    """The lines of a table that are of the same strikes as some lines of another."""
    result = {tuple(line.split(",")[:2]): line for line in path.read_text(encoding="utf-8").splitlines()}
    return [result[tuple(line.split(",")[:2])] for line in lines]


def numbers(line):
    return [float(each) for each in line.split(",")[:-2]]


def test_another_ball_is_refused_by_the_table(tmp_path):
    shutil.copy(STUDY / "modern.csv", tmp_path / "modern.csv")
    with pytest.raises(clubface.errors.FileError, match="not the table of this case"):
        run(fem.ball("distance"), PARTS, tmp_path / "modern.csv")


def test_held_out_strikes_are_met_as_the_page_says(table):
    """The percentiles that docs/models/response.md gives, rounded up in their last digit."""
    result = summary(DEFAULTS, table, PARTS)
    asked = {
        "clubs, held out": {
            "speed": 0.0026, "direction": np.radians(0.18),
            "spin": 1.1, "spin_vector": 1.3,
        },
        "heads, held out": {
            "speed": 0.0064, "direction": np.radians(0.39),
            "spin": 2.2, "spin_vector": 2.8,
        },
        "heads, held out, 0.2 kg and more": {
            "speed": 0.0048, "direction": np.radians(0.32),
            "spin": 1.9, "spin_vector": 2.3,
        },
        "spinning balls, clubs, held out": {
            "speed": 0.0029, "direction": np.radians(0.29),
            "spin": 2.0, "spin_vector": 5.2,
        },
        "spinning balls, heads, held out": {
            "speed": 0.0083, "direction": np.radians(0.82),
            "spin": 2.7, "spin_vector": 6.7,
        },
    }  # fmt: skip
    for part, limits in asked.items():
        for quantity, limit in limits.items():
            assert 0.5 * limit < result[part][quantity][1] < limit, (part, quantity)


def test_spins_before_impact_are_within_the_range_and_about_all_axes(planned):
    """Evenly over a cube, so that each component has a mean of nothing and a deviation of its end over the root of 3:
    within three times what that of as many random ones would be from it."""
    names = ("ball_backspin", "ball_sidespin", "ball_riflespin")
    for place in (place for place, name in enumerate(PARTS) if "spinning" in name):
        made = [each for (part, _), each in planned.items() if part == place]
        spins = np.array([[each.delivery[name] for name in names] for each in made]) / (100.0 * np.pi)
        assert np.abs(spins).max() <= 1.0
        assert np.abs(spins.mean(axis=0)).max() < 3.0 / np.sqrt(3.0 * len(spins))
        assert spins.std(axis=0) == pytest.approx(np.full(3, np.sqrt(1.0 / 3.0)), abs=0.07)
        assert np.abs(np.corrcoef(spins.T) - np.eye(3)).max() < 3.0 / np.sqrt(len(spins))


def test_the_fit_finds_the_coefficients_from_strikes_by_the_model(table):
    """Targets computed by the model itself with other values, so that the fit must find these: 1e-4 of their size."""
    few = table.where(in_fit(table, PARTS) & (effective_mass(table) > LIGHT))
    few = few.where(np.arange(len(few.friction)) % 4 == 0)
    shift = np.random.default_rng(1).normal(size=len(fitted()))
    truth = {
        **DEFAULTS,
        **{name: DEFAULTS[name] * (1.0 + 0.02 * each) for name, each in zip(fitted(), shift, strict=True)},
    }
    made, _ = simulated(truth, few, fitted()[:1])
    result = fit(few._replace(results=made), np.ones(len(made)))
    got, _ = simulated(result, few, fitted()[:1])
    # The ridge on the coefficients leaves a hundredth of what counts as one.
    assert np.sqrt(np.mean(((got - made) / scales(few._replace(results=made))) ** 2)) < 0.02


def test_derivatives_by_the_coefficients_are_those_of_differences(table):
    some = table.where(np.arange(len(table.friction)) % 200 == 0)
    names = ["restitution_middle", "time", "half_slip", "lever_middle", "twist_arm"]
    values, slopes = simulated(DEFAULTS, some, names)
    for place, name in enumerate(names):
        step = 1e-6 * abs(DEFAULTS[name])
        above, _ = simulated({**DEFAULTS, name: DEFAULTS[name] + step}, some, names)
        below, _ = simulated({**DEFAULTS, name: DEFAULTS[name] - step}, some, names)
        size = np.abs(slopes[..., place]).max(axis=0) + 1e-12 * np.abs(values).max(axis=0) / step
        assert np.all(np.abs(slopes[..., place] - (above - below) / (2.0 * step)) < 1e-4 * size), name


def test_the_design_covers_the_range_that_the_page_names(planned):
    planned = [each for (part, _), each in planned.items() if part == 0]
    speeds, frictions = ([of(each) for each in planned] for of in (lambda s: s.delivery["speed"], lambda s: s.friction))
    incidence = [np.degrees(each.delivery["loft"] - each.delivery["attack"]) for each in planned]
    assert min(speeds) < 10.1
    assert 64.0 < max(speeds) <= 65.0
    assert min(frictions) < 0.06
    assert 0.59 < max(frictions) <= 0.6
    assert min(incidence) < 1.0
    assert 71.0 < max(incidence) <= 72.0
    times = {each.club.characteristic_time for each in planned}
    assert 0.0 in times
    assert min(times - {0.0}) > 100e-6
    assert max(times) < 350e-6


def test_weights_are_less_for_heads_that_no_club_is(table):
    some = table.where(table.part == 0)
    light = effective_mass(some) < 0.5 * LIGHT
    given = weights(some, np.zeros(len(light), bool))
    assert light.any()
    assert given[light].max() < given[~light].max() == 1.0


def test_the_differences_are_drawn_and_the_table_has_its_columns(table, tmp_path):
    pytest.importorskip("matplotlib")
    figure(DEFAULTS, table, PARTS).savefig(tmp_path / "left.svg")
    assert (STUDY / "modern.csv").read_text(encoding="utf-8").splitlines()[1] == ",".join(COLUMNS)
    assert table.results.shape[1] == len(TARGETS)
