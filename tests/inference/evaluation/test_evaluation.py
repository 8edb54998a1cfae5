"""Models beside measured shots: statistics against hand-worked ones, and known answers on shots made for them."""

import csv
import dataclasses
import io
import json
import math
import re
from html.parser import HTMLParser

import numpy as np
import pytest

import clubface
from clubface.errors import InputError, UnknownNameError
from clubface.inference.evaluation import report, tables
from clubface.inference.evaluation.evaluation import evaluate
from clubface.inference.evaluation.model_errors import published
from clubface.inference.evaluation.noise import TO_MEAN_ABSOLUTE
from clubface.inference.evaluation.statistics import best_of, fewest_groups, fewest_resamples
from clubface.shots.measured import QUANTITIES
from clubface.shots.recorded import RecordedShots
from clubface.support.checks import plain
from clubface.validation import benchmark_data

RPM, DEG = math.pi / 30, math.pi / 180


TRUTH = {"slip_y": 0.05}
"""The parameters of slip that made the shots: grip that pure rolling lacks."""


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


def test_the_model_that_made_the_shots_is_found_best_with_no_more_error_than_the_noise(result):
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
    found = evaluate(
        shots, club="driver", models="slip", delivery_noise={"face": "0.5 deg"}, noise={"azimuth": 0.0, "launch": 0.0}
    )
    slope = clubface.sensitivity("driver", speed=50.0, attack=0.02, loft=0.27, model="slip").value("azimuth", "face")
    # 2400 draws know a standard deviation to 1.4 %; three of these.
    assert found.floor["azimuth"] == pytest.approx(TO_MEAN_ABSOLUTE * abs(slope) * 0.5 * DEG, rel=0.045)
    assert found.floor["launch"] < 0.1 * found.floor["azimuth"]


def test_the_same_seed_gives_the_same_report_and_another_one_does_not(result):
    def told(seed):
        found = evaluate(
            made(), club="driver", models=["standard", "slip", "volumetric"], seed=seed, noise={"ball_speed": 0.2}
        )
        document = report.document(found)
        for each in document["models"].values():
            del each["seconds_per_shot"]
        return json.dumps(document, default=str)

    assert told(0) == told(0) != told(1)


def test_a_shot_that_one_model_cannot_compute_is_left_out_for_all():
    shots = made(30)
    shots.deliveries["toe"][4] = 0.2
    found = evaluate(shots, club="driver", models=["standard", "slip"])
    assert len(found.shots) == 29
    (failed,) = found.failed
    assert failed.line == 6
    assert failed.reason.startswith("standard: impact at 200.0 mm is outside the face")
    assert "cannot compute them: 1 shot (" in " ".join(tables.remarks(found))


def test_missing_values_leave_out_no_more_than_they_must():
    shots = made(30)
    shots.launches["backspin"][3:13] = np.nan
    shots.deliveries["speed"][0] = np.nan
    found = evaluate(shots, club="driver", models=["standard"])
    assert found.sizes["backspin"]["standard"].shots == 19
    assert found.sizes["launch"]["standard"].shots == 29
    assert found.shots.dropped == ((2, "speed was not measured"),)


def test_one_shot_and_shots_all_alike_are_reported_without_what_they_cannot_tell():
    one = evaluate(made(1), club="driver", models=["standard", "slip"])
    assert math.isnan(one.sizes["launch"]["slip"].std)
    assert not any(lines for each in one.trends.values() for lines in each.values())
    alike = evaluate(made(1).select([0] * 12), club="driver", models=["standard", "slip"])
    assert not any(lines for each in alike.trends.values() for lines in each.values())
    for each in (one, alike):
        text = report.as_markdown(each)
        assert "nan" not in text.lower().replace("finan", "")
        assert "What the errors go with" not in text
        assert "no intervals" in text
        assert all(best.equals for best in each.best.values())
        assert report.document(each)["notes"]
        json.dumps(plain(report.document(each)), allow_nan=False)


def test_shots_that_look_like_another_clubs_are_told_before_the_tables():
    pytest.importorskip("pyarrow")
    shots = benchmark_data.load("7-iron").measured
    with pytest.raises(InputError, match="the shots name 7-iron, not driver"):
        evaluate(shots, club="driver", models="standard", resamples=100)
    found = evaluate(shots, club="driver", models="standard", resamples=100, mismatch="note")
    text = report.as_markdown(found)
    assert "is this the right club?" in text[: text.index("## ")]


def test_groups_are_one_a_shot_of_the_source():
    shots = made(30)
    shots.deliveries["speed"][0] = np.nan
    players = np.repeat(np.arange(6), 5)
    found = evaluate(shots, club="driver", models="standard", groups=players)
    assert found.sizes["launch"]["standard"].shots == 29
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
    found = evaluate(tmp_path / "shots.csv", club="driver", models=["standard", "slip"])
    assert found.groups == 4  # a shot without a name belongs to nobody
    by_hand = [*["A"] * 19, *["B"] * 19, "C", "D"]
    same = evaluate(read, club="driver", models=["standard", "slip"], groups=by_hand)
    alone = evaluate(read, club="driver", models=["standard", "slip"], groups=range(40))
    assert found.sizes["launch"]["slip"] == same.sizes["launch"]["slip"]
    assert found.sizes["launch"]["slip"].mae_interval != alone.sizes["launch"]["slip"].mae_interval
    assert all(not each.is_worse for best in found.best.values() for each in best.rivals)
    assert "resamples of the 4 groups of shots, such as players" in report.as_markdown(found)
    one = dataclasses.replace(read, players=np.full(40, "Ann", dtype=object))
    assert evaluate(one, club="driver", models="standard").groups is None


def test_as_many_resamples_are_asked_for_as_a_correction_for_many_rivals_needs():
    # 2 / (B + 1) times 7 rivals is below 0.05 from B = 280 on; at 279 it is 0.05 itself.
    with pytest.raises(InputError, match="from 280 on: with fewer, none of 8 models can be called worse"):
        evaluate(made(30), club="driver", resamples=279)
    assert [fewest_resamples(count) for count in (1, 2, 8)] == [0, 40, 280]
    # 2^(1 - G) times 7 rivals: 0.055 for 8 shots, 0.027 for 9; of one rival 0.0625 for 5 and 0.031 for 6.
    assert [fewest_groups(count) for count in (2, 8)] == [6, 9]
    worse = np.linspace(1.0, 2.0, 280)
    for groups, told in ((8, False), (9, True)):
        resampled = {"good": 0.0 * worse, **{f"bad {place}": worse for place in range(7)}}
        best = best_of({name: float(each.mean()) for name, each in resampled.items()}, resampled, groups)
        assert all(each.is_worse is told for each in best.rivals)
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
        ({"resamples": 10}, InputError, "from 100 on"),
        ({"models": "standard", "parameters": {"slip": None}}, InputError, "one of the models evaluated"),
        ({"club": None}, InputError, "the shots name none"),
    ],
)
def test_mistakes_are_told_with_what_is_allowed(options, error, words):
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


def test_tables_of_the_report_have_a_cell_in_every_column(result):
    for section in report.sections(result):
        for table in section.tables:
            assert {len(row) for row in table.rows} == {len(table.heads)}, table.title


def test_the_markdown_shows_the_error_beside_the_published_one(result):
    text = report.as_markdown(result)
    row = next(line for line in text.splitlines() if line.startswith("| volumetric |") and "2.12" in line)
    mae = result.sizes["ball_speed"]["volumetric"].mae / 0.44704
    assert f"| {mae:.2f} |" in row
    assert row.endswith("| 2.12 | 2.91 |")
    # Words stand to the left of their column and numbers to the right.
    lines = text.splitlines()
    rules = {lines[at - 1]: each for at, each in enumerate(lines) if set(each) <= set("|-: ") and "---" in each}
    assert rules
    for head, rule in rules.items():
        below = lines[lines.index(rule, lines.index(head)) + 1]
        for cell, side in zip(below.split(" | "), rule.split(" | "), strict=True):
            if re.fullmatch(r"[|\s]*[-+]?[\d.]+[|\s]*", cell):
                assert side.strip("| ") == "---:", (head, cell)
        assert rule.startswith("| --- |")


def test_the_html_is_one_well_formed_document_with_its_pictures(result):
    class Reader(HTMLParser):
        def __init__(self):
            super().__init__()
            self.open, self.pictures = [], 0

        def handle_starttag(self, tag, attrs):
            self.pictures += tag == "img" and dict(attrs)["src"].startswith("data:image/png;base64,")
            if tag not in ("meta", "img"):
                self.open.append(tag)

        def handle_endtag(self, tag):
            assert self.open.pop() == tag

    reader = Reader()
    reader.feed(report.as_html(result, dict.fromkeys(report.PICTURES, b"png")))
    assert reader.open == []
    assert reader.pictures == 3


def test_the_report_is_written_with_its_pictures(result, tmp_path):
    pytest.importorskip("matplotlib")
    files = {each.name: each for each in result.write(tmp_path / "new" / "out")}
    assert set(files) == {
        "evaluation.md", "evaluation.html", "evaluation.json", "evaluation.csv", "errors.png", "errors.svg",
        "trends.png", "trends.svg", "agreement.png", "agreement.svg",
    }  # fmt: skip
    document = json.loads(files["evaluation.json"].read_text())
    assert document["errors"]["launch"]["slip"]["mae"] == result.sizes["launch"]["slip"].mae
    assert len(files["evaluation.csv"].read_text().splitlines()) == 201
    assert all(each.stat().st_size > 1000 for each in files.values())


def test_pictures_are_drawn_of_few_quantities_and_shots(tmp_path):
    pytest.importorskip("matplotlib")
    shots = made(1)
    for name in ("backspin", "sidespin", "azimuth", "total_spin", "spin_axis"):
        del shots.launches[name]
    assert len(evaluate(shots, club="driver", models="standard").write(tmp_path)) == 10


def test_the_table_of_shots_holds_every_number_in_its_unit_and_nothing_where_there_is_none():
    shots = made(8)
    shots.launches["sidespin"][2] = math.nan
    found = evaluate(shots, club="driver", models=["slip"], parameters={"slip": TRUTH})
    rows = list(csv.DictReader(io.StringIO(report.as_csv(found))))
    sizes = {"ball_speed": 0.44704, "launch": DEG, "azimuth": DEG, "backspin": RPM, "sidespin": RPM}
    units_ = {"ball_speed": "mph", "launch": "deg", "azimuth": "deg", "backspin": "rpm", "sidespin": "rpm"}
    predicted = clubface.impact("driver", shots.deliveries, model="slip", parameters=TRUTH)
    for name, size in sizes.items():
        told = [row[f"slip_{name}_{units_[name]}"] for row in rows]
        # Nine digits are written.
        assert [float(each) for each in told] == pytest.approx(getattr(predicted, name) / size, rel=6e-9)
    measured = [row["sidespin_rpm"] for row in rows]
    assert [each == "" for each in measured] == [place == 2 for place in range(8)]


def test_the_table_of_trends_is_in_the_unit_of_the_error_per_step_of_the_delivery():
    # A model without slip misses by an error that grows with the impact's place: 2 rpm a millimetre are planted.
    shots = made(300, noise=False)
    planted = 2.0 * RPM * shots.deliveries["toe"] / 1e-3
    shots.launches["sidespin"] = np.asarray(shots.launches["sidespin"]) - planted
    found = evaluate(shots, club="driver", models=["slip"], parameters={"slip": TRUTH})
    table = tables.trend_table(found, "sidespin")
    (place,) = (number for number, head in enumerate(table.heads) if "toe" in head)
    assert table.heads[place] == "per mm of toe"
    assert table.rows[0][place].startswith("+2.0")


SIZES = {"ball_speed": 0.44704, "launch": DEG, "azimuth": DEG, "backspin": RPM, "sidespin": RPM}


def test_every_cell_of_the_noise_is_its_number(result):
    """A normal error of standard deviation s has the mean magnitude s sqrt(2 / pi) and the mean square s^2."""
    rows = tables.noise_floor(result).rows
    assert len(rows) == len(QUANTITIES)
    for row, (name, least) in zip(rows, result.floor.items(), strict=True):
        digits = 0 if "spin" in name else 2
        best = result.sizes[name]["slip"]
        deviation = least / math.sqrt(2.0 / math.pi)
        share = min(100.0, 100.0 * deviation**2 / best.rms**2)
        assert row[1:] == [
            f"{result.monitor_noise[name] / SIZES[name]:.{digits}f}", f"{least / SIZES[name]:.{digits}f}",
            f"{best.mae / SIZES[name]:.{digits}f} (slip)", f"{share:.0f}%",
        ]  # fmt: skip
        # The model that made the shots is off by the noise alone: 100 %, of which 200 shots tell 10 % three times over.
        assert share == pytest.approx(100.0, abs=30.0)


def test_the_share_of_noise_in_a_model_that_is_wrong_is_small(result):
    found = evaluate(made(noise=False), club="driver", models=["standard"], noise={"ball_speed": 0.05})
    for row, (name, least) in zip(tables.noise_floor(found).rows, found.floor.items(), strict=True):
        share = 100.0 * (least**2 * math.pi / 2.0) / found.sizes[name]["standard"].rms ** 2
        assert row[-1] == f"{min(share, 100.0):.0f}%"
    perfect = evaluate(made(noise=False), club="driver", models=["slip"], parameters={"slip": TRUTH})
    assert {row[-1] for row in tables.noise_floor(perfect).rows} == {"100%"}


def test_the_best_models_and_the_detail_have_their_numbers(result):
    for row, (name, best) in zip(tables.best_models(result).rows, result.best.items(), strict=True):
        digits = 0 if "spin" in name else 2
        assert row[1:3] == [best.model, f"{result.sizes[name][best.model].mae / SIZES[name]:.{digits}f}"]
        worse = next((each for each in best.rivals if each.is_worse), None)
        if worse is not None:
            low, high = (f"{each / SIZES[name]:.{digits + 1}f}" for each in worse.interval)
            assert row[4:6] == [worse.model, f"{worse.difference / SIZES[name]:.{digits + 1}f} [{low}, {high}]"]
    for name in QUANTITIES:
        digits = 0 if "spin" in name else 2
        for row, (model, size) in zip(tables.detail(result, name).rows, result.sizes[name].items(), strict=True):
            shown = [f"{each / SIZES[name]:.{digits}f}" for each in (size.mae, size.std, size.worst)]
            assert [row[0], row[1], row[4], row[7]] == [model, *shown]
            assert row[3] == f"{100 * size.mae / result.mean[name]:.3g}%"


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(1.0, "1 s"), (12.34, "12.3 s"), (0.999, "999 ms"), (1e-3, "1 ms"), (0.9e-3, "900 us"), (1e-6, "1 us"),
     (5e-7, "500 ns"), (1e-9, "1 ns")],
)  # fmt: skip
def test_times_are_told_in_a_unit_that_suits_them(seconds, words):
    assert tables.duration(seconds) == words


def test_a_probability_is_no_finer_than_the_resamples_tell():
    """Twenty of the resamples, or one in a thousand, is the least that is told."""
    assert tables.probability(0.01, 2000) == "0.01"
    assert tables.probability(0.0099, 2000) == "< 0.01"
    assert tables.probability(0.001, 100_000) == "0.001"
    assert tables.probability(0.00099, 100_000) == "< 0.001"
    assert tables.probability(0.123, 100) == "< 0.2"
    assert tables.probability(0.234, 100) == "0.23"


def test_no_number_of_a_printed_table_is_broken_and_none_is_cut_off(result):
    page = report.as_html(result)
    assert "overflow: visible" in page
    tables = re.findall(r'<table style="--print:([\d.]+)pt">(.*?)</table>', page, re.DOTALL)
    assert len(tables) == page.count("<table")
    for size, body in tables:
        rows = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row) for row in re.findall(r"<tr>(.*?)</tr>", body)]
        # The longest piece of each column that holds digits, in digits 0.64 of their size wide, on A4 with margins.
        pieces = [
            [piece for cell in column for piece in cell.split() if re.search(r"\d", piece)]
            for column in zip(*rows, strict=True)
        ]
        assert sum(max(map(len, each), default=0) for each in pieces) * 0.64 * float(size) < 493.0
