"""``clubface golfer``, ``dispersion`` and ``best-loft``: their tables, their JSON, their files and their mistakes."""

import numpy as np
import pytest

from clubface.design.dispersion import dispersion
from clubface.design.golfer import golfer, golfers
from command_line import assert_mistake

FEW = ("--count", "256", "--no-shares")


def of_quantity(document, name):
    """The row of a quantity in the main table."""
    return next(each for each in document["tables"]["quantities"]["rows"] if each["quantity"] == name)


def test_the_golfers_are_listed_and_shown_with_their_sources(clubface_):
    assert [each["name"] for each in clubface_("golfer", "list", "--json").json["tables"]["golfers"]["rows"]] == list(
        golfers()
    )
    assert "bogey-driver" in clubface_("golfer", "list").out
    shown = " ".join(clubface_("golfer", "show", "bogey-driver").out.split())
    for words in ("face angle deg -0.50 2.90", "Broadie and Ko (2009)", "TrackMan (2024)"):
        assert words in shown
    document = clubface_("golfer", "show", "bogey-driver", "--json").json
    row = document["tables"]["delivery"]["rows"][0]
    assert (row["variable"], row["mean"], row["unit"]) == ("speed", pytest.approx(92 * 0.44704), "m/s")
    (mishits,) = (each["data"] for each in document["notes"] if each["code"] == "golfer-mishits")
    assert mishits == {"percent": 15.0, "scale": 2.0}


def test_a_golfer_that_was_written_is_one_to_start_from(clubface_, tmp_path):
    file = tmp_path / "mine.toml"
    assert clubface_("golfer", "show", "tour-driver", "-o", str(file)).status == 0
    one, other = (clubface_("dispersion", each, *FEW, "--json").json for each in (str(file), "tour-driver"))
    assert of_quantity(one, "carry")["mean"] == pytest.approx(of_quantity(other, "carry")["mean"], rel=1e-9)
    assert_mistake(clubface_("golfer", "show", "tour-driver", "-o", str(file)), "exists already")


def test_a_dispersion_is_that_of_python(clubface_):
    result = clubface_("dispersion", "tour-driver", *FEW, "--seed", "3", "--hole", "430 yd", "--json").json
    known = dispersion("tour-driver", count=256, seed=3)
    carry = of_quantity(result, "carry")
    assert (carry["mean"], carry["unit"]) == (known.mean("carry"), "m")
    assert of_quantity(result, "side")["quantile_0.5"] == known.quantile("side", 0.5)
    ellipse = result["tables"]["ellipses"]["rows"][1]
    assert [ellipse["long_axis_m"], ellipse["short_axis_m"]] == (2.0 * known.ellipse(0.9).half_axes).tolist()
    assert carry["mean_by_derivatives"] == pytest.approx(known.mean("carry"), abs=0.5)
    (hole,) = result["tables"]["strokes"]["rows"]
    assert hole["strokes_gained"] == pytest.approx(hole["strokes_before"] - hole["strokes_after"] - 1.0)


def test_the_table_tells_percentiles_ellipses_strokes_and_shares(clubface_):
    out = clubface_("dispersion", "handicap-10-driver", "--count", "1024", "--hole", "400 yd").out
    for words in ("by derivatives", "Landing ellipses", "gained", "Shapley effects", "face angle", "have no result"):
        assert words in out
    assert "carry" not in clubface_("dispersion", "tour-driver", "--count", "64", "--no-flight").out


def test_a_mismatched_club_and_an_exceeded_range_are_noted_once(clubface_):
    ran = clubface_("dispersion", "women-15-driver", "--club", "7-iron", *FEW)
    assert ran.err.count("delivers a driver, not a 7-iron") == 1
    assert clubface_("dispersion", "women-15-driver", "--model", "adjusted", *FEW).err.count("outside the range") == 1


def test_shots_and_pictures_are_written(clubface_, tmp_path):
    table, picture = tmp_path / "shots.csv", tmp_path / "spread.svg"
    ran = clubface_("dispersion", "tour-driver", *FEW, "-o", str(table), "--plot", str(picture))
    assert ran.status == 0
    assert len(table.read_text().splitlines()) == 257
    assert picture.stat().st_size > 10_000


def test_a_golfer_is_estimated_from_a_file_and_can_be_hit_with(clubface_, tmp_path):
    drawn = golfer("handicap-5-driver").deliveries(np.random.default_rng(1).random((60, 12)))
    columns = {
        "club_speed_mph": ("speed", 0.44704),
        "face_deg": ("face", np.pi / 180),
        "path_deg": ("path", np.pi / 180),
    }
    rows = zip(*(drawn[name] / size for name, size in columns.values()), strict=True)
    file, mine = tmp_path / "session.csv", tmp_path / "mine.toml"
    file.write_text(",".join(columns) + "\n" + "\n".join(",".join(f"{each:.4f}" for each in row) for row in rows))
    ran = clubface_("golfer", "estimate", str(file), "--club", "driver", "-o", str(mine))
    assert ran.status == 0
    assert "60 shots" in ran.out
    result = golfer(mine)
    face = result.variables.index("face")
    assert result.spread[face] == pytest.approx(golfer("handicap-5-driver").spread[face], rel=0.4)
    assert clubface_("dispersion", str(mine), *FEW).status == 0
    estimate = ("golfer", "estimate", str(file), "--club", "driver")
    assert_mistake(clubface_(*estimate, "--like", str(mine), "-o", str(mine)), "--output", "file other than")
    assert_mistake(clubface_(*estimate, "--ball", "distance"), "--ball")
    written = clubface_("golfer", "show", str(mine), "-o", str(tmp_path / "other.toml"), "--json")
    assert written.json["values"]["name"] == "mine"


def test_a_club_of_other_loft_is_noted_as_hit_with_the_golfers_delivered_loft(clubface_, tmp_path):
    head = tmp_path / "head.toml"
    assert clubface_("club", "new", "head", "--like", "driver", "-o", str(head)).status == 0
    assert "dynamic loft" not in clubface_("dispersion", "tour-driver", "--club", str(head), *FEW).err
    head.write_text(head.read_text().replace('loft = "9.8 deg"', 'loft = "10.3 deg"'))
    message = " ".join(clubface_("dispersion", "tour-driver", "--club", str(head), *FEW).err.split())
    assert "head has 0.5 deg more loft than driver" in message
    assert "with the dynamic loft of driver" in message


def test_ball_data_alone_make_no_golfer(clubface_, tmp_path):
    file = tmp_path / "ball.csv"
    file.write_text("ball_speed_mph,launch_deg\n" + "".join(f"{130 + one},12\n" for one in range(20)))
    ran = clubface_("golfer", "estimate", str(file), "--club", "driver")
    assert_mistake(ran, "session is without club speed", "golfer list")


def test_a_golfer_with_a_custom_club_hits_that_club(clubface_, tmp_path):
    shots, head, mine = (tmp_path / name for name in ("shots.csv", "head.toml", "mine.toml"))
    assert clubface_("club", "new", "-o", str(head)).status == 0
    steps = np.random.default_rng(1).standard_normal((30, 2))
    shots.write_text("club_speed_mph,face_deg\n" + "".join(f"{95 + one:.4f},{two:.4f}\n" for one, two in steps))
    message = clubface_("golfer", "estimate", str(shots), "--club", str(head), "-o", str(mine)).err
    assert f"clubface dispersion {mine} --club {head}" in message
    assert clubface_("dispersion", str(mine), "--club", str(head), *FEW).status == 0
    assert_mistake(clubface_("dispersion", str(mine), *FEW), "--club is missing", "my-club", "mine")


@pytest.mark.parametrize(
    ("mean", "words"),
    [
        ('lie = "120 deg"', "120 deg"),
        ('speed = "95 m"', "robot.toml:3"),
        ('toe = "9 cm"', "toe: impact at 90.0"),
    ],
)
def test_an_impossible_mean_is_blamed_on_the_golfer_and_not_on_an_option(clubface_, tmp_path, mean, words):
    file = tmp_path / "robot.toml"
    speed = "" if mean.startswith("speed") else 'speed = "95 mph"\n'
    file.write_text(f'title = "robot"\n[mean]\n{mean}\n{speed}[spread]\n')
    ran = clubface_("dispersion", str(file), *FEW)
    assert_mistake(ran, "robot", words)
    assert "--" not in ran.err


def test_the_report_says_what_spreads_the_shots_most(clubface_, tmp_path):
    """The face angle makes the side, as the table of shares has it."""
    pytest.importorskip("matplotlib")
    report = tmp_path / "shots.md"
    ran = clubface_("dispersion", "handicap-10-driver", "--count", "256", "--report", str(report), "--json")
    (face,) = (each["side_share"] for each in ran.json["tables"]["shares"]["rows"] if each["variable"] == "face")
    assert face == max(each["side_share"] for each in ran.json["tables"]["shares"]["rows"])
    causes = {each["code"]: each for each in ran.json["summary"]}
    assert causes["dispersion-side-cause"]["data"] == {"variable": "face angle", "share": face}
    assert causes["dispersion-side-cause"]["text"] in report.read_text()
    assert "dispersion-carry-cause" in causes


@pytest.mark.parametrize(("spread", "shares"), [("", False), ('face = "2 deg"', True)])
def test_a_golfer_in_whom_little_varies_is_hit_with(clubface_, tmp_path, spread, shares):
    file = tmp_path / "robot.toml"
    file.write_text(f'title = "robot"\n[mean]\nspeed = "95 mph"\nloft = "14 deg"\n[spread]\n{spread}\n')
    out = clubface_("dispersion", str(file), "--count", "64", "--hole", "400 yd").out
    assert ("Sources of the spread" in out) == shares


def test_the_best_loft_is_given_by_speed_and_beside_a_chart(clubface_):
    tables = clubface_("best-loft", "--speed", "100 mph", "--attack", "0 deg", "--json").json["tables"]
    assert tables["best_lofts"]["rows"][0]["loft_deg"] == pytest.approx(14.3, abs=1.5)
    tables = clubface_("best-loft", "--chart", "trackman", "--json").json["tables"]
    away = [each["loft_deg"] - each["published_loft_deg"] for each in tables["best_lofts"]["rows"]]
    loft = tables["differences"]["rows"][0]
    means = [loft["mean"], loft["least"], loft["greatest"]]
    assert means == pytest.approx([np.mean(away), min(away), max(away)])
    assert len(clubface_("best-loft", "--chart", "ping", "--json").json["tables"]["best_lofts"]["rows"]) == 121


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("dispersion", "tour-drver"), ("tour-driver",)),
        (("dispersion", "nowhere.toml"), ("nowhere.toml",)),
        (("dispersion", "tour-driver", "--count", "0"), ("count", "from 1")),
        (("dispersion", "tour-driver", "--seed", "-1"), ("seed",)),
        (("dispersion", "tour-driver", "--fairway", "30 yd"), ("--hole",)),
        (("dispersion", "tour-driver", "--hole", "30 deg"), ("--hole", "deg")),
        (("dispersion", "tour-driver", "--hole", "400 yd", "--lie", "grass"), ("lie", "fairway")),
        (("dispersion", "tour-driver", "--hole", "400 yd", "--no-flight"), ("hole",)),
        (("dispersion", "tour-driver", "-o", "x.txt"), ("--output", ".csv")),
        (("dispersion", "tour-driver", "--plot", "x.txt"), ("--plot", ".png")),
        (("dispersion", "tour-driver", "--model", "fem"), ("--count", "fem")),
        (("best-loft",), ("--speed",)),
        (("best-loft", "--chart", "ping", "--speed", "100 mph"), ("--chart",)),
        (("best-loft", "--chart", "pong"), ("ping",)),
        (("best-loft", "--speed", ""), ("--speed", "mph")),
        (("best-loft", "--speed", "90 mph", "--attack", ","), ("--attack", "deg")),
        (("best-loft", "--speed", "90 mph,900 mph"), ("--speed", "150 m/s")),
        (("best-loft", "--speed", "90 mph", "--model", "volumetric", "--accuracy", "5"), ("--accuracy",)),
        (("best-loft", "--speed", "90 mph", "--temperature", "900 degC"), ("--temperature",)),
        (("dispersion", "tour-driver", "--no-flight", "--wind", "5 m/s"), ("--wind", "--no-flight")),
        (("dispersion", "tour-driver", "--club", ""), ("club", "driver")),
        (("dispersion", "tour-driver", "--hole", "0 yd"), ("--hole", "above 0")),
        (("dispersion", "tour-driver", "--hole", "430"), ('--hole "430 yd"',)),
        (("golfer", "show", "nobody"), ("nobody",)),
        (("golfer", "estimate", "nowhere.csv", "--club", "driver"), ("nowhere.csv",)),
    ],
)
def test_a_mistake_is_reported_in_one_line(clubface_, arguments, words):
    assert_mistake(clubface_(*arguments), *words)
