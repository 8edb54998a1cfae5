"""Fitting: the best of parts and settings, found among those of which the answer is known."""

import math

import numpy as np
import pytest

import clubface
from clubface import club, fly, impact
from clubface.design.golfer import golfer
from clubface.design.optimisation import fitting_run
from clubface.design.optimisation.fitting_run import fit
from clubface.design.optimisation.study import from_text
from clubface.errors import FileError, InputError

BEGIN = 'title = "t"\ngolfer = "bogey-driver"\nobjective = "carry"\nshots = 64\n'


def test_a_combination_is_judged_as_its_shots_are_one_by_one():
    """A head of 2 degrees less loft, weight back by 2 mm: the delivery follows the loft, and the CG the setting."""
    result = fit(from_text(
        BEGIN + '[fit]\nclubs = ["driver"]\nballs = ["distance"]\n'
        '[[fit.setting]]\nname = "back"\nloft = "-2 deg"\nlie = "1 deg"\ncg_x = "2 mm"\n'
    ))  # fmt: skip
    (one,) = result
    shots = golfer("bogey-driver").sample(64, seed=1)
    shots["loft"] = shots["loft"] - math.radians(2.0)
    shots["lie"] = shots["lie"] + math.radians(1.0)
    head = club("driver")
    head = head.replace(loft=head.loft - math.radians(2.0), cg_x=head.cg_x + 0.002)
    carry = fly(impact(head, shots, ball="distance", on_error="nan"), on_error="nan").carry
    assert one.value == pytest.approx(np.nanmean(carry), rel=1e-12)
    assert (one.club, one.ball, one.setting) == ("driver", "distance", "back")


def test_a_head_of_more_loft_is_delivered_with_as_much_more_of_it():
    """The golfer delivers as with the first head; the second's shots one by one, with the difference of the lofts."""
    result = fit(from_text(BEGIN + '[fit]\nclubs = ["driver", "3-wood"]\n'))
    (wood,) = [each for each in result if each.club == "3-wood"]
    shots = golfer("bogey-driver").sample(64, seed=1)
    shots["loft"] = shots["loft"] + club("3-wood").loft - club("driver").loft
    carry = fly(impact("3-wood", shots, on_error="nan"), on_error="nan").carry
    assert wood.value == pytest.approx(np.nanmean(carry), rel=1e-12)


def test_all_combinations_are_ordered_from_the_best():
    text = BEGIN + '[fit]\nclubs = ["driver", "3-wood"]\nballs = ["modern", "distance"]\n'
    text += '[[fit.setting]]\nname = "up"\nloft = "1 deg"\n[[fit.setting]]\nname = "down"\nloft = "-1 deg"\n'
    result = fit(from_text(text))
    assert len({(each.club, each.ball, each.setting) for each in result}) == len(result) == 8
    worth = result.advice.worth["carry"]
    best = max(each.value for each in result)
    assert [each.rank for each in result] == sorted(each.rank for each in result)
    assert all(each.value > best - worth or each.error > 0.0 for each in result if each.rank == 1)
    assert min(each.error for each in result) == 0.0
    # Of one rank they stand in the order of the parts, and each rank starts where those before it end.
    for rank in {each.rank for each in result}:
        places = [each.place for each in result if each.rank == rank]
        assert places == sorted(places)
        assert rank == 1 + sum(each.rank < rank for each in result)
    # Only what is worse by more than is worth a change is ranked behind.
    assert all(each.value < best - worth for each in result if each.rank > 1)


def test_free_settings_are_as_good_as_those_of_a_fine_grid():
    """Loft of a head between -4 and +6 degrees in steps of half a degree: none carries farther than the optimum."""
    (free,) = fit(from_text(BEGIN + '[fit]\nclubs = ["driver"]\nloft = ["-4 deg", "6 deg"]\n'))
    lines = [f'[[fit.setting]]\nname = "{step}"\nloft = "{step} deg"\n' for step in np.arange(-4.0, 6.01, 0.5)]
    grid = fit(from_text(BEGIN + '[fit]\nclubs = ["driver"]\n' + "".join(lines)))
    best = max(grid, key=lambda each: each.value)
    assert free.value >= best.value
    assert free.changes["loft"] == pytest.approx(best.changes["loft"], abs=math.radians(0.5))
    # Half a step from the best of a parabola 10 degrees wide loses 0.25% of its height, a few centimetres.
    assert free.value - best.value < 0.1


def test_a_setting_and_what_is_free_add_up():
    text = (
        BEGIN + '[fit]\nclubs = ["driver"]\nloft = ["0.5 deg", "1 deg"]\n[[fit.setting]]\nname = "a"\nloft = "1 deg"\n'
    )
    (result,) = fit(from_text(text))
    assert math.radians(1.5) - 1e-9 <= result.changes["loft"] <= math.radians(2.0) + 1e-9


def test_the_picture_shows_the_club_that_the_advice_opens_with():
    result = fit(
        from_text(BEGIN + '[fit]\nclubs = ["driver"]\nballs = ["modern", "distance"]\nloft = ["-4 deg", "6 deg"]\n')
    )
    advice = result.advice
    place = advice.recommended() or advice.best("carry")
    assert place > 0
    assert result.leading.value == pytest.approx(advice.values[place, 0], rel=1e-12)
    assert advice.names[place] == result.leading.describe()


def test_a_free_value_at_a_bound_is_noted_whatever_the_setting_adds():
    """The best loft is 0.9 degrees more: within 3 to 9 degrees of a setting of -5, beyond 0.5 without one."""
    for line, limits, ended in (("-5 deg", (3, 9), False), ("0 deg", (-1, 0.5), True)):
        text = f'[fit]\nclubs = ["driver"]\nloft = ["{limits[0]} deg", "{limits[1]} deg"]\n'
        result = fit(from_text(BEGIN + text + f'[[fit.setting]]\nname = "a"\nloft = "{line}"\n'))
        codes = [each.code for each in result.to_result().notes]
        assert ("fitting-at-an-end" in codes) == ended, result.leading


@pytest.mark.parametrize("free", ["", 'loft = ["-1 deg", "1 deg"]\n'])
def test_a_setting_without_any_computable_shot_is_reported(free):
    text = f'[fit]\nclubs = ["driver"]\n{free}[[fit.setting]]\nname = "over"\nlie = "90 deg"\n'
    with pytest.raises(ValueError, match="impossible for driver with the setting over"):
        fit(from_text(BEGIN + text))


@pytest.mark.parametrize("free", ["", 'loft = ["-1 deg", "1 deg"]\n'])
@pytest.mark.parametrize("change", ['cg_x = "3 m"', 'loft = "90 deg"'])
def test_a_setting_that_leaves_no_possible_head_is_named(free, change):
    text = f'[fit]\nclubs = ["driver"]\n{free}[[fit.setting]]\nname = "far back"\n{change}\n'
    with pytest.raises(ValueError, match=r"fit\.setting is 'far back'"):
        fit(from_text(BEGIN + text))


TWO = (
    BEGIN + 'wind = ["-3 m/s", "0 m/s", "1 m/s"]\n[fit]\nclubs = ["driver", "3-wood"]\nballs = ["modern", "distance"]\n'
)


def test_a_fitting_that_was_stopped_goes_on_with_what_was_judged(tmp_path, monkeypatch):
    """Stopped before the third of four: the second run judges two, and the file is that of a run without a stop."""
    judged = []
    compute = fitting_run._evaluate

    def counted(fitting, head, ball, *rest):
        if len(judged) == 2:
            raise KeyboardInterrupt
        judged.append((head.name, ball.name))
        return compute(fitting, head, ball, *rest)

    monkeypatch.setattr(fitting_run, "_evaluate", counted)
    target, whole = tmp_path / "parts.csv", tmp_path / "whole.csv"
    with pytest.raises(KeyboardInterrupt):
        fit(from_text(TWO), output=target)
    first = judged.copy()
    judged.clear()
    monkeypatch.setattr(
        fitting_run, "_evaluate", lambda *given: (judged.append((given[1].name, given[2].name)), compute(*given))[1]
    )
    result = fit(from_text(TWO), output=target, resume=True)
    assert [*first, *judged] == [(c, b) for c in ("driver", "3-wood") for b in ("modern", "distance")]
    again = fit(from_text(TWO), output=whole)
    assert [repr(each) for each in again] == [repr(each) for each in result]  # NaN is not equal to itself
    assert target.read_bytes() == whole.read_bytes()
    assert sorted(each.name for each in tmp_path.iterdir()) == ["parts.csv", "whole.csv"]


def test_a_fitting_of_other_parts_does_not_go_on_with_these(tmp_path, monkeypatch):
    monkeypatch.setattr(fitting_run, "combinations_table", lambda *_: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        fit(from_text(TWO), output=tmp_path / "parts.csv")
    with pytest.raises(FileError, match="another study"):
        fit(from_text(TWO.replace("-3 m/s", "-4 m/s")), output=tmp_path / "parts.csv", resume=True)


def test_wind_blows_as_over_a_single_shot():
    (one,) = fit(from_text(BEGIN + 'wind = ["-3 m/s", "0 m/s", "1 m/s"]\n[fit]\nclubs = ["driver"]\n'))
    launch = impact("driver", golfer("bogey-driver").sample(64, seed=1), on_error="nan")
    assert one.value == pytest.approx(np.nanmean(fly(launch, wind=(-3.0, 0.0, 1.0), on_error="nan").carry), rel=1e-12)


def test_the_ground_is_that_of_a_single_shot():
    fitting = from_text(BEGIN + 'ground = "soft fairway"\n[fit]\nclubs = ["driver"]\n')
    launch = impact("driver", golfer("bogey-driver").sample(64, seed=1), on_error="nan")
    expected = np.nanmean(fly(launch, ground="soft fairway", on_error="nan").total)
    (one,) = fit(fitting)
    assert fitting.landed(one.place, one.changes)[0][2].mean() == pytest.approx(expected, rel=1e-12)
    with pytest.raises(FileError, match="unknown ground 'soft'"):
        from_text(BEGIN + 'ground = "soft"\n[fit]\nclubs = ["driver"]\n')


def test_the_landings_of_a_combination_are_those_that_it_was_judged_by():
    fitting = from_text(BEGIN + '[fit]\nclubs = ["driver", "3-wood"]\nloft = ["-2 deg", "2 deg"]\n')
    for each in fit(fitting):
        assert float(fitting.landed(each.place, each.changes)[0][0].mean()) == pytest.approx(each.value, rel=1e-12)


def test_python_takes_files_and_each_function_names_the_other_for_the_other_kind(tmp_path):
    fits, studies = tmp_path / "fit.toml", tmp_path / "study.toml"
    fits.write_text(BEGIN + '[fit]\nclubs = ["driver"]\n')
    studies.write_text(BEGIN + 'starts = 1\nclub = "driver"\n[variables]\nloft = ["8 deg", "16 deg"]\n')
    assert clubface.fit(fits) == fit(from_text(fits.read_text()))
    result = clubface.optimise(str(studies), output=tmp_path / "best.toml")
    assert f"carry {result.fresh.value('start', 'carry') / 0.9144:.4g} yd to" in repr(result)
    assert club(tmp_path / "best.toml").loft == pytest.approx(result.club["loft"], rel=1e-9)
    with pytest.raises(InputError, match="fit takes a fitting"):
        clubface.optimise(fits)
    with pytest.raises(InputError, match="optimise takes a study"):
        clubface.fit(studies)
