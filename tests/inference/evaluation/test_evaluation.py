"""Models beside measured shots: statistics against hand-worked ones, and known answers on shots made for them."""

import dataclasses
import hashlib
import json
import math

import numpy as np
import pytest

import clubface
from clubface.errors import InputError, UnknownNameError
from clubface.inference.evaluation import evaluate, published
from clubface.inference.evaluation.statistics import TO_MEAN_ABSOLUTE, best_of, fewest_groups, fewest_resamples
from clubface.shots.measured import QUANTITIES
from clubface.shots.recorded import RecordedShots

RPM, DEG = math.pi / 30, math.pi / 180


TRUTH = {"slip_y": 0.05}
"""The parameters of slip that made the shots: grip that pure rolling lacks."""


def codes(evaluation):
    """Data of the notes by code, the last of each."""
    return {each.code: each.data for each in evaluation.to_result().notes}


def rows_of(evaluation, table):
    return evaluation.to_result().to_dict()["tables"][table]["rows"]


def made(n=200, *, model="slip", noise=True, seed=3, **changes):
    """Shots whose launches are those of a model, measured with the noise of the default monitor."""
    random = np.random.default_rng(seed)
    delivery = {
        "speed": random.normal(50, 1.5, n), "attack": random.normal(0.02, 0.03, n), "path": random.normal(0, 0.04, n),
        "loft": random.normal(0.27, 0.03, n), "face": random.normal(0, 0.04, n), "toe": random.normal(0, 5e-3, n),
        "high": random.normal(2e-3, 4e-3, n),
    }  # fmt: skip
    delivery.update({name: np.full(n, float(each)) for name, each in changes.items()})
    launch = clubface.impact("driver", delivery, model=model, parameters=TRUTH)
    deviation = {"ball_speed": 0.2, "launch": 0.25 * DEG, "azimuth": 0.25 * DEG, "backspin": 6.6, "sidespin": 6.6}
    measured = {
        name: np.array(getattr(launch, name)) + noise * deviation[name] * random.standard_normal(n)
        for name in QUANTITIES
    }
    return RecordedShots(
        deliveries=delivery, launches=measured, rows=np.arange(2, n + 2), source="made", format="clubface"
    )


@pytest.fixture(scope="module")
def result():
    return evaluate(
        made(),
        club="driver",
        models=["standard", "slip", "volumetric"],
        parameters={"slip": TRUTH},
        noise={"ball_speed": 0.2},
    )


def test_the_model_that_made_the_shots_is_best_with_no_more_error_than_the_noise(result):
    for name in QUANTITIES:
        size = result.sizes[name]["slip"]
        # Four standard errors of mean and mean magnitude of 200 normal deviates.
        assert abs(size.bias) < 4 * size.std / math.sqrt(200)
        assert size.mae == pytest.approx(result.floor[name], rel=4 * 0.76 / math.sqrt(200)), name
    best = result.best["backspin"]
    assert best.model == "slip"
    assert {each.model for each in best.rivals if each.is_worse} == {"standard", "volumetric"}
    assert result.cost("slip") == pytest.approx(
        sum(result.sizes[name]["slip"].mae / np.abs(result.shots.launch[name]).mean() for name in QUANTITIES)
    )


def test_the_published_noise_of_the_monitor_is_the_floor(result):
    assert result.floor["launch"] == pytest.approx(0.2 * DEG, rel=1e-12)
    assert result.floor["sidespin"] == pytest.approx(50 * RPM, rel=1e-12)
    assert result.floor["ball_speed"] == pytest.approx(0.2 * TO_MEAN_ABSOLUTE, rel=1e-12)
    assert "ball_speed" not in evaluate(made(20), club="driver", models="standard").floor


def test_noise_of_the_delivery_reaches_the_launch_by_its_sensitivity():
    shots = made(300, face=0.0, path=0.0, toe=0.0, high=0.0, attack=0.02, loft=0.27, speed=50.0)
    computed = evaluate(
        shots, club="driver", models="slip", delivery_noise={"face": "0.5 deg"}, noise={"azimuth": 0.0, "launch": 0.0}
    )
    slope = clubface.sensitivity("driver", speed=50.0, attack=0.02, loft=0.27, model="slip").value("azimuth", "face")
    # 2400 draws know a standard deviation to 1.4 %; three of these.
    assert computed.floor["azimuth"] == pytest.approx(TO_MEAN_ABSOLUTE * abs(slope) * 0.5 * DEG, rel=0.045)
    assert computed.floor["launch"] < 0.1 * computed.floor["azimuth"]


def test_a_shot_that_one_model_cannot_compute_is_left_out_for_all():
    shots = made(30)
    shots.deliveries["toe"][4] = 0.2
    computed = evaluate(shots, club="driver", models=["standard", "slip"])
    assert len(computed.shots) == 29
    (failed,) = computed.failed
    assert failed.line == 6
    assert failed.reason.startswith("standard: impact at 200.0 mm is outside the face")
    assert codes(computed)["shots-not-computed"]["shots"] == 1


def test_missing_values_leave_out_no_more_than_they_must():
    shots = made(30)
    shots.launches["backspin"][3:13] = np.nan
    shots.deliveries["speed"][0] = np.nan
    computed = evaluate(shots, club="driver", models=["standard"])
    assert computed.sizes["backspin"]["standard"].shots == 19
    assert computed.sizes["launch"]["standard"].shots == 29
    assert computed.shots.dropped == ((2, "speed was not measured"),)


def test_groups_are_one_a_shot_of_the_source():
    shots = made(30)
    shots.deliveries["speed"][0] = np.nan
    players = np.repeat(np.arange(6), 5)
    computed = evaluate(shots, club="driver", models="standard", groups=players)
    assert computed.sizes["launch"]["standard"].shots == 29
    with pytest.raises(InputError, match=r"one for each shot: \(30,\)"):
        evaluate(shots, club="driver", models="standard", groups=players[:5])


def test_shots_of_a_file_belong_together_by_their_player(tmp_path):
    """Forty shots of two players are no forty independent ones."""
    shots = made(40)
    players = np.repeat(["Ann", "Ben", ""], [19, 19, 2]).astype(object)
    named = dataclasses.replace(shots, players=players)
    named.write(tmp_path / "shots.csv")
    read = clubface.read_shots(tmp_path / "shots.csv")
    assert read.players is not None
    assert read.players.tolist() == players.tolist()
    computed = evaluate(tmp_path / "shots.csv", club="driver", models=["standard", "slip"])
    assert computed.groups == 4  # a shot without a name belongs to nobody
    by_hand = [*["A"] * 19, *["B"] * 19, "C", "D"]
    same = evaluate(read, club="driver", models=["standard", "slip"], groups=by_hand)
    alone = evaluate(read, club="driver", models=["standard", "slip"], groups=range(40))
    assert computed.sizes["launch"]["slip"] == same.sizes["launch"]["slip"]
    assert computed.sizes["launch"]["slip"].mae_interval != alone.sizes["launch"]["slip"].mae_interval
    assert all(not each.is_worse for best in computed.best.values() for each in best.rivals)
    assert codes(computed)["evaluation-intervals"]["drawn"] == "4 groups of shots, such as players"
    one = dataclasses.replace(read, players=np.full(40, "Ann", dtype=object))
    assert evaluate(one, club="driver", models="standard").groups is None


def test_as_many_resamples_are_asked_for_as_a_correction_for_many_rivals_needs():
    # 2 / (B + 1) times 7 rivals is below 0.05 from B = 280 on; at 279 it is 0.05 itself.
    with pytest.raises(InputError, match="at least 280"):
        evaluate(made(30), club="driver", resamples=279)
    assert [fewest_resamples(count) for count in (1, 2, 8)] == [0, 40, 280]
    # 2^(1 - G) times 7 rivals: 0.055 for 8 shots, 0.027 for 9; of one rival 0.0625 for 5 and 0.031 for 6.
    assert [fewest_groups(count) for count in (2, 8)] == [6, 9]
    worse = np.linspace(1.0, 2.0, 280)
    for groups, is_worse in ((8, False), (9, True)):
        resampled = {"good": 0.0 * worse, **{f"bad {place}": worse for place in range(7)}}
        best = best_of({name: float(each.mean()) for name, each in resampled.items()}, resampled, groups)
        assert all(each.is_worse is is_worse for each in best.rivals)
    fewer = {name: each[:278] for name, each in resampled.items()}
    best = best_of({name: float(each.mean()) for name, each in fewer.items()}, fewer, 9)
    assert not any(each.is_worse for each in best.rivals)


@pytest.mark.parametrize(
    ("options", "error", "words"),
    [
        ({"models": "standart"}, UnknownNameError, "did you mean standard"),
        ({"noise": {"carry": 1.0}}, UnknownNameError, "quantity of noise"),
        ({"noise": {"launch": -1.0}}, InputError, "not negative"),
        ({"noise": {"launch": "3 mph"}}, InputError, "noise launch"),
        ({"delivery_noise": {"speed": "1 deg"}}, InputError, "delivery_noise speed"),
        ({"resamples": 10}, InputError, "at least 100"),
        ({"models": "standard", "parameters": {"slip": None}}, InputError, "a model that is evaluated"),
        ({"club": None}, InputError, "the shots name none"),
    ],
)
def test_errors_of_users_name_what_is_allowed(options, error, words):
    with pytest.raises(error, match=words):
        evaluate(made(5), **{"club": "driver", "models": "standard", **options})


def test_published_errors_are_those_of_the_paper():
    known = published()
    assert len(known) == 12
    adjusted, rings = known["adjusted", "driver"], known["rings", "7-iron"]
    assert adjusted.mae["ball_speed"] == pytest.approx(1.51 * 0.44704, rel=1e-12)
    assert adjusted.std["sidespin"] == pytest.approx(188 * RPM, rel=1e-12)
    assert (adjusted.cpu, known["adjusted", "7-iron"].cost) == (5.52e-3, 1.05)
    assert rings.mae["launch"] == pytest.approx(1.52 * DEG, rel=1e-12)
    assert rings.mae_percent["sidespin"] == 52.6
    assert known["standard", "7-iron"].mae["backspin"] == pytest.approx(632 * RPM, rel=1e-12)
    assert known["standard", "driver"].std == {}


def test_wrong_percentages_of_the_paper_are_flagged_and_right_ones_are_not():
    known = published()
    assert "MAE of launch: printed 5.12 %, the printed numbers give 5.61 %" in known["slip", "7-iron"].caveats
    assert any("repeat those of volumetric" in each for each in known["rings", "driver"].caveats)
    assert known["area", "driver"].caveats == ()
    assert known["area", "7-iron"].caveats == ()


def test_pictures_are_drawn_of_few_quantities_and_shots(tmp_path):
    pytest.importorskip("matplotlib")
    shots = made(1)
    for name in ("backspin", "sidespin", "azimuth", "total_spin", "spin_axis"):
        del shots.launches[name]
    written = evaluate(shots, club="driver", models="standard").write(tmp_path)
    assert {each.suffix for each in written} == {".md", ".html", ".json", ".csv", ".png", ".svg"}


def test_the_same_seed_gives_the_same_result_and_another_one_does_not():
    def document(seed):
        computed = evaluate(
            made(), club="driver", models=["standard", "slip", "volumetric"], seed=seed, noise={"ball_speed": 0.2}
        )
        document = computed.to_dict()
        for each in document["tables"]["models"]["rows"]:
            del each["processor_time_s"]
        return json.dumps(document)

    assert document(0) == document(0) != document(1)


def test_one_shot_and_shots_all_alike_leave_empty_what_they_cannot_show():
    one = evaluate(made(1), club="driver", models=["standard", "slip"])
    assert math.isnan(one.sizes["launch"]["slip"].std)
    alike = evaluate(made(1).select([0] * 12), club="driver", models=["standard", "slip"])
    for each in (one, alike):
        assert not any(lines for models in each.trends.values() for lines in models.values())
        assert all(best.equals for best in each.best.values())
        assert "evaluation-no-intervals" in codes(each)
        assert {row["mae_low"] for row in rows_of(each, "errors")} == {None}
        assert "nan" not in str(each.to_result()).lower()
        json.dumps(each.to_dict(), allow_nan=False)


def test_a_report_is_written_with_pictures_and_fingerprints_of_its_files(tmp_path):
    pytest.importorskip("matplotlib")
    made(40).write(tmp_path / "shots.csv")
    computed = evaluate(tmp_path / "shots.csv", club="driver", models=["standard", "slip"])
    files = {each.name: each for each in computed.write(tmp_path / "new" / "out")}
    assert set(files) >= {
        "evaluation.md", "evaluation.html", "evaluation.json", "evaluation.csv", "errors.png", "errors.svg",
        "trends.png", "trends.svg", "agreement.png", "agreement.svg", "errors.csv", "trends.csv",
    }  # fmt: skip
    document = json.loads(files["evaluation.json"].read_text())
    (row,) = (
        each for each in document["tables"]["errors"]["rows"] if (each["model"], each["quantity"]) == ("slip", "launch")
    )
    assert row["mae"] == pytest.approx(computed.sizes["launch"]["slip"].mae / DEG, rel=1e-14)
    (used,) = document["provenance"]["files"]
    assert used["sha256"] == hashlib.sha256((tmp_path / "shots.csv").read_bytes()).hexdigest()
    assert used["sha256"] in files["evaluation.html"].read_text()
    assert len(files["evaluation.csv"].read_text().splitlines()) == 41
    assert all(each.stat().st_size > 1000 for name, each in files.items() if not name.endswith(".csv"))


def test_the_table_of_shots_has_every_number_and_nothing_where_there_is_none():
    shots = made(8)
    shots.launches["sidespin"][2] = math.nan
    table = evaluate(shots, club="driver", models=["slip"], parameters={"slip": TRUTH}).shots_table()
    predicted = clubface.impact("driver", shots.deliveries, model="slip", parameters=TRUTH)
    for name in QUANTITIES:
        assert table[f"slip_{name}"].values == getattr(predicted, name).tolist()
    assert [row["sidespin_rpm"] is None for row in table.records()] == [place == 2 for place in range(8)]


def test_slopes_are_in_the_unit_of_the_error_per_step_of_the_delivery():
    # A model without slip misses by an error that grows with the impact's place: 2 rpm a millimetre are planted.
    shots = made(300, noise=False)
    planted = 2.0 * RPM * shots.deliveries["toe"] / 1e-3
    shots.launches["sidespin"] = np.asarray(shots.launches["sidespin"]) - planted
    rows = rows_of(evaluate(shots, club="driver", models=["slip"], parameters={"slip": TRUTH}), "trends")
    (row,) = (each for each in rows if (each["quantity"], each["covariate"]) == ("sidespin", "toe"))
    assert row["unit"] == "rpm per mm"
    assert row["slope"] == pytest.approx(2.0, rel=1e-9)


def test_the_noise_explains_all_of_a_perfect_model_and_little_of_a_wrong_one(result):
    """A normal error of standard deviation s has the mean magnitude s sqrt(2 / pi) and the mean square s^2."""
    # The model that made the shots is off by the noise alone: 100 %, of which 200 shots tell 10 % three times over.
    assert [row["share"] for row in rows_of(result, "noise")] == pytest.approx([1.0] * len(QUANTITIES), abs=0.3)
    computed = evaluate(made(noise=False), club="driver", models=["standard"], noise={"ball_speed": 0.05})
    for row, (name, least) in zip(rows_of(computed, "noise"), computed.floor.items(), strict=True):
        assert row["share"] == pytest.approx(
            min(1.0, least**2 * math.pi / 2 / computed.sizes[name]["standard"].rms ** 2)
        )
    perfect = evaluate(made(noise=False), club="driver", models=["slip"], parameters={"slip": TRUTH})
    assert {row["share"] for row in rows_of(perfect, "noise")} == {1.0}


def test_published_errors_are_in_the_table_of_errors(result):
    rows = {(row["quantity"], row["model"]): row for row in rows_of(result, "errors")}
    row = rows["ball_speed", "volumetric"]
    # Table 2 of Caldwell and McPhee (2023): 2.12 mph, with a standard deviation of 2.91 mph.
    assert (row["published_mae"], row["published_std"]) == pytest.approx((2.12 * 0.44704, 2.91 * 0.44704))
    assert row["behind"] == pytest.approx(row["mae"] - rows["ball_speed", result.best["ball_speed"].model]["mae"])
