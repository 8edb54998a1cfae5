"""Which inputs a task has: known values, and the same ones in whatever chunks they are asked for."""

import math
import re

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from clubface.errors import FileError, InputError
from clubface.studies import designs
from clubface.studies.axes import SweepAxis, Swept, axis
from clubface.studies.designs import CachedDesign, DesignRows, Grid, Samples, design, table_columns
from clubface.units import to_si

SPEED = Swept("m/s")
X = SweepAxis(name="x", unit="1", ends=(0.0, 1.0), count=3)
Y = SweepAxis(name="y", unit="1", values=(5.0, 7.0), count=2)
CLUB = SweepAxis(name="club", unit=None, choices=("driver", "3-wood"), count=2)
BETWEEN = (SweepAxis(name="x", unit="1", ends=(2.0, 4.0)), SweepAxis(name="y", unit="1", ends=(-1.0, 1.0)), CLUB)


def joined(points, size):
    parts = [points.values(range(first, min(first + size, points.count))) for first in range(0, points.count, size)]
    return {name: np.concatenate([each[name] for each in parts]) for name in parts[0]}


def test_evenly_spaced_values_begin_and_end_where_the_file_says():
    result = axis("speed", {"from": "90 mph", "to": "120 mph", "count": 31}, SPEED).at(np.arange(31))
    assert result[0] == to_si(90.0, "mph")
    assert result[-1] == to_si(120.0, "mph")
    np.testing.assert_allclose(np.diff(result), to_si(1.0, "mph"), rtol=1e-12)  # rounding of values of 50 m/s


@settings(max_examples=60)
@given(
    st.decimals(-200, 200, places=2), st.decimals("0.01", 7, places=2), st.integers(1, 400), st.sampled_from((1, -1)),
    st.sampled_from(["mph", "m/s", "km/h"]), st.booleans(),
)  # fmt: skip
def test_evenly_spaced_values_are_those_of_a_list_to_the_last_bit(first, step, count, sign, unit, by_count):
    """Each value is what is read where it is written: 0.1 in steps of 0.1 ends with 0.3, not 0.30000000000000004."""
    written = [f"{first + sign * step * place} {unit}" for place in range(count + 1)]
    how = {"count": count + 1} if by_count else {"step": f"{sign * step} {unit}"}
    made = axis("speed", {"from": written[0], "to": written[-1], **how}, SPEED)
    assert made.count == count + 1
    assert made.at(np.arange(count + 1)).tolist() == list(axis("speed", written, SPEED).values)


@pytest.mark.parametrize(
    "how", [{"from": 0, "to": 199, "step": 1}, {"from": 199, "to": 0, "step": -1}, {"from": 0, "to": 199, "count": 200}]
)
def test_whole_numbers_are_whole_at_every_step(how):
    made = axis("swing", how, Swept("1", limits=(0, 10**9)))
    assert sorted(made.at(np.arange(200)).tolist()) == list(range(200))
    made = axis("swing", how, Swept("1"))
    assert sorted(made.at(np.arange(200)).tolist()) == list(range(200))


@pytest.mark.parametrize("how", [{"from": 0, "to": 10, "count": 4}, {"from": 0, "to": 1, "step": 0.5}])
def test_a_number_of_things_is_not_swept_in_parts(how):
    with pytest.raises(InputError, match="whole numbers at every step"):
        axis("swing", how, Swept("1", limits=(0, 10**9)))


@pytest.mark.parametrize(
    ("how", "values"),
    [
        (
            {"from": "0.12345678901234567890 m/s", "to": "1 m/s", "count": 3},
            [0.12345678901234568, 0.5617283945061728, 1.0],
        ),
        ({"from": "90 mph", "to": "90 mph", "step": "1 mph"}, [to_si(90.0, "mph")]),
        *(
            ({"from": "90 mph", "to": f"{last} mph", "step": "0.1 mph"},
             to_si(np.linspace(90.0, last, 10 * (last - 90) + 1), "mph"))
            for last in (100, 113, 120)
        ),
    ],
    ids=["more digits than a float", "one value", "to 100 mph", "to 113 mph", "to 120 mph"],
)  # fmt: skip
def test_an_axis_holds_both_ends_in_spite_of_rounding(how, values):
    made = axis("speed", how, SPEED)
    assert made.count == len(values)
    np.testing.assert_allclose(made.at(np.arange(made.count)), values, rtol=1e-14)


@pytest.mark.parametrize("method", ["sobol", "latin-hypercube"])
def test_samples_of_whole_numbers_are_whole_and_each_as_frequent(method):
    pytest.importorskip("scipy")
    made = axis("swing", {"from": 3, "to": 10}, Swept("1", limits=(0, 10**9)))
    result = Samples([made], 64, method, 1).values(range(64))["swing"]
    assert np.bincount(result.astype(int)).tolist() == [0] * 3 + [8] * 8
    assert (result == np.floor(result)).all()


@pytest.mark.parametrize(
    ("how", "unit", "degrees"),
    [
        ({"from": "0 degC", "to": "35 degC", "step": "5 degC"}, "degC", [0, 5, 10, 15, 20, 25, 30, 35]),
        ({"from": "35 degC", "to": "0 degC", "step": "-5 degC"}, "degC", [35, 30, 25, 20, 15, 10, 5, 0]),
        ({"from": "50 degF", "to": "77 degF", "step": "9 degF"}, "degF", [50, 59, 68, 77]),
        ({"from": "10 degC", "to": "25 degC", "step": "9 degF"}, "degC", [10, 15, 20, 25]),
        ({"from": "50 degF", "to": "25 degC", "step": 5}, "degC", [10, 15, 20, 25]),
        ({"from": "50 degF", "to": "25 degC", "count": 4}, "degC", [10, 15, 20, 25]),
        ({"from": "-40 degC", "to": "-40 degF", "count": 1}, "degF", [-40]),
    ],
)
def test_a_step_of_a_temperature_is_a_difference(how, unit, degrees):
    made = axis("temperature", how, Swept("K"))
    assert made.count == len(degrees)
    np.testing.assert_allclose(made.at(np.arange(made.count)), to_si(np.array(degrees, dtype=float), unit), atol=1e-10)


def test_units_are_mixed_between_the_ends_and_the_step():
    made = axis("speed", {"from": "90 mph", "to": "53.6448 m/s", "step": "0.44704 m/s"}, SPEED)
    np.testing.assert_allclose(made.at(np.arange(made.count)), to_si(np.arange(90.0, 121.0), "mph"), rtol=1e-12)
    assert made.at(np.array([0, 30])).tolist() == [to_si(90.0, "mph"), 53.6448]


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ({"from": "90 mph", "to": "100 mph", "step": "0 mph"}, "step of speed is '0 mph'"),
        ({"from": "90 mph", "to": "90 mph", "step": "0 mph"}, "step of speed is '0 mph'"),
        ({"from": "100 mph", "to": "90 mph", "step": "1 mph"}, "from the first value, 100 mph, to the last, 90 mph"),
        ({"from": "90 mph", "to": "100 mph", "step": "3 mph"}, "in whole steps, not 3.33333"),
        ({"from": "90 mph", "to": "50 m/s", "step": "3 mph"}, "in whole steps, not 7.28"),
        ({"from": "90 mph", "to": "100 mph", "step": "5 deg"}, "not an angle"),
        ({"from": "90 mph", "to": "100 mph", "step": True}, "step of speed is True"),
        ({"from": "90 mph", "to": "100 mph", "count": 1}, "count of speed is 1; it must be at least 2"),
        ({"from": "90 mph", "to": "1e400 mph", "count": 3}, "finite"),
        ({"from": "90 mph", "to": "100 mph", "step": "1e-999999999 mph"}, "step of speed"),
    ],
)
def test_a_step_that_does_not_end_at_the_last_value_is_refused(how, words):
    with pytest.raises(InputError, match=words):
        axis("speed", how, SPEED)


def test_a_grid_changes_its_last_input_first():
    result = Grid([CLUB, X, Y]).values(range(12))
    assert result["y"].tolist() == [5.0, 7.0] * 6
    assert result["x"].tolist() == [0.0, 0.0, 0.5, 0.5, 1.0, 1.0] * 2
    assert result["club"].tolist() == [0] * 6 + [1] * 6


def test_a_grid_of_a_billion_tasks_is_made_where_it_is_asked_for():
    axes = [SweepAxis(name=name, unit="1", ends=(0.0, 999.0), count=1000) for name in "abc"]
    result = Grid(axes).values(range(123_456_789, 123_456_791))
    assert [result[name].tolist() for name in "abc"] == [[123.0, 123.0], [456.0, 456.0], [789.0, 790.0]]


@settings(max_examples=10)
@given(size=st.integers(1, 70), method=st.sampled_from(["sobol", "latin-hypercube"]))
def test_samples_are_the_same_in_chunks_of_any_size(size, method):
    pytest.importorskip("scipy")
    whole = Samples(BETWEEN, 64, method, 3).values(range(64))
    for name, each in joined(Samples(BETWEEN, 64, method, 3), size).items():
        assert np.array_equal(each, whole[name])


@pytest.mark.parametrize("method", ["sobol", "latin-hypercube"])
def test_samples_do_not_depend_on_which_were_asked_for_before(method):
    pytest.importorskip("scipy")
    made = Samples(BETWEEN, 64, method, 3)
    late, early = made.values(range(40, 50)), made.values(range(10, 20))
    whole = made.values(range(64))
    assert np.array_equal(late["x"], whole["x"][40:50])
    assert np.array_equal(early["x"], whole["x"][10:20])
    remembered = CachedDesign(made)
    for first in (3, 3, 9, 3):
        assert np.array_equal(remembered.values(range(first, 20))["x"], whole["x"][first:20])
    assert not np.array_equal(Samples(BETWEEN, 64, method, 4).values(range(64))["x"], whole["x"])


def test_a_sobol_sequence_is_scipys_wherever_it_is_entered(monkeypatch):
    """Drawn by SciPy from the beginning in one piece, and entered after states that are kept on the way."""
    qmc = pytest.importorskip("scipy.stats").qmc
    monkeypatch.setattr(designs, "STRIDE", 16)
    whole = qmc.Sobol(3, scramble=True, bits=32, rng=3).random(128)
    made = Samples(BETWEEN, 128, "sobol", 3)
    for first in (100, 37, 16, 0, 96, 127):
        np.testing.assert_array_equal(made.values(range(first, 128))["x"], 2.0 + 2.0 * whole[first:, 0])


@pytest.mark.parametrize("method", ["sobol", "latin-hypercube"])
def test_samples_have_one_value_in_each_of_as_many_equal_parts(method):
    """What defines a Latin hypercube, and holds for every coordinate of a scrambled Sobol sequence of 2**m points."""
    pytest.importorskip("scipy")
    result = Samples(BETWEEN, 64, method, 1).values(range(64))
    assert sorted(np.floor((result["x"] - 2.0) / 2.0 * 64).astype(int)) == list(range(64))
    assert np.bincount(result["club"]).tolist() == [32, 32]


def test_the_rows_of_a_table_are_computed_for_every_name(write):
    path = write("club_speed_mph,attack_deg,note\n90,-1,a\n100,2,b\n")
    columns = table_columns(path, {"speed": SPEED, "attack": Swept("rad")})
    result = DesignRows(columns, [CLUB]).values(range(4))
    assert result["club"].tolist() == [0, 0, 1, 1]
    np.testing.assert_allclose(result["speed"], to_si(np.array([90.0, 100.0, 90.0, 100.0]), "mph"))
    assert result["attack"][1] == math.radians(2.0)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("club_speed_mph\n90\nfast\n", ":3: club_speed_mph: 'fast' is not a number"),
        ("club_speed_mph\n", "no row"),
        ("weather\nfine\n", "no column"),
        ("club_speed_mph,attack_deg\n90\n", "1 cell where there are 2 columns"),
        ("club_speed_mph,Model\n90,area\n", "this column is not read; sweep it next to the table, as in model"),
    ],
)
def test_a_table_with_a_row_that_cannot_be_used_is_refused(write, text, words):
    with pytest.raises(FileError, match=words):
        table_columns(write(text), {"speed": SPEED, "attack": Swept("rad"), "model": Swept(None)})


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ([], "at least one"),
        ("90 mph", "a list, or a table"),
        ({"from": "90 mph"}, "given as"),
        ({"from": "90 mph", "to": "100 mph", "count": 0}, "whole number from 1"),
        ({"from": "90 mph", "to": "100 mph", "count": 3, "step": "1 mph"}, "given as"),
        ({"from": "90 mph", "to": "100 mph", "step": "-1 mph"}, "leads from the first"),
        ({"from": "90 mph", "to": "100 mph", "step": "20 mph"}, "leads from the first"),
        ({"from": "90 mph", "to": "100 mph", "steps": 3}, "did you mean step"),
        ({"from": "100 mph", "to": "90 mph"}, "above its start"),
        (["90 deg"], "not an angle"),
    ],
)
def test_an_unusable_axis_is_reported(given, words):
    with pytest.raises(InputError, match=words):
        axis("speed", given, SPEED)


@pytest.mark.parametrize("rest", [{}, {"count": 3}, {"step": "1 mm"}])
def test_a_flat_face_is_no_end_of_an_interval(rest):
    assert axis("bulge", ["flat", "305 mm"], Swept("m")).values == (math.inf, 0.305)
    for ends in (("flat", "305 mm"), ("305 mm", "flat")):
        with pytest.raises(InputError, match='"flat" is for a list'):
            axis("bulge", {"from": ends[0], "to": ends[1], **rest}, Swept("m"))


def test_designs_and_axes_that_do_not_fit_are_reported():
    with pytest.raises(InputError, match=r'sweep is empty; .* as in speed = \["90 mph"'):
        design("grid", [], None, 0)
    with pytest.raises(InputError, match="an interval is for samples"):
        design("grid", [BETWEEN[0]], None, 0)
    with pytest.raises(InputError, match="for the design sobol"):
        design("sobol", [X], 8, 0)
    with pytest.raises(InputError, match="sobol takes more"):
        design("latin-hypercube", BETWEEN, 2_000_000, 0)
    with pytest.raises(InputError, match="samples is missing"):
        design("sobol", BETWEEN, None, 0)
    with pytest.raises(InputError, match="at most"):
        Grid([SweepAxis(name=name, unit="1", ends=(0.0, 1.0), count=10**7) for name in "ab"])


def test_a_table_without_units_is_refused_until_the_study_gives_them(tmp_path):
    from clubface.studies.study import read_study

    (tmp_path / "swings.csv").write_text("club_speed,attack\n113,2\n105,-1\n")
    study = '[study]\ndesign = "table"\n{}[impact]\nclub = "driver"\n[sweep]\ntable = "swings.csv"\n'
    path = tmp_path / "study.toml"
    path.write_text(study.format(""))
    with pytest.raises(FileError, match="'club_speed', 'attack' name no unit") as refused:
        read_study(path)
    line = re.search(r"units = \{.*?\}", str(refused.value))
    assert line is not None
    path.write_text(study.format(line[0] + "\n"))
    columns = read_study(path).design.values(range(2))
    np.testing.assert_allclose(columns["speed"], [113 * 0.44704, 105 * 0.44704])
    path.write_text(study.format('units = { speed = "deg", angle = "deg" }\n'))
    with pytest.raises(FileError, match="the unit of speed is 'deg'"):
        read_study(path)
