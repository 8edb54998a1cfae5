"""``clubface map``: its tables, its JSON, its files and its mistakes."""

import csv

import numpy as np
import pytest

import clubface
from command_line import assert_mistake

SHOT = ["--speed", "105 mph", "--attack", "3 deg", "--loft", "13 deg"]
DRIVE = {"speed": "105 mph", "attack": "3 deg", "loft": "13 deg"}


@pytest.fixture
def stable(tmp_path):
    path = tmp_path / "stable.toml"
    club = clubface.club("driver")
    more = {name: getattr(club, name) * 1.05 for name in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")}
    path.write_text(club.replace(name="stable", **more).to_toml())
    return str(path)


def test_a_map_tells_extremes_sweet_spot_and_what_a_spread_costs(clubface_):
    ran = clubface_("map", "driver", *SHOT, "--spread", "12 mm x 9 mm")
    assert ran.status == 0, ran.err
    result = clubface.map_face("driver", DRIVE)
    tables = clubface_("map", "driver", *SHOT, "--spread", "12 mm x 9 mm", "--json").json["tables"]
    (row,) = (each for each in tables["extremes"]["rows"] if each["quantity"] == "carry")
    carries = result.get("carry")
    assert (row["least"], row["greatest"], row["unit"]) == (np.nanmin(carries), np.nanmax(carries), "m")
    up, across = np.unravel_index(np.nanargmin(carries), carries.shape)
    place = [row["least_toe_mm"], row["least_high_mm"]]
    assert place == pytest.approx([1e3 * result.toe[across], 1e3 * result.high[up]])
    (row,) = tables["best_points"]["rows"]
    best = result.best()
    assert [row["sweet_spot_toe_mm"], row["sweet_spot_high_mm"]] == pytest.approx([1e3 * best.toe, 1e3 * best.high])
    assert row["effective_area_mm2"] == pytest.approx(1e6 * result.area())
    assert row["face_area_mm2"] == pytest.approx(1e6 * result.outline.area())
    assert row["outline"] == "assumed: an ellipse of 105 mm by 55 mm"
    spread = result.forgiveness(("12 mm", "9 mm"))
    assert [each["quantity"] for each in tables["scatter"]["rows"]][5] == "carry"
    row = tables["scatter"]["rows"][5]
    parts = [spread.mean["carry"], spread.deviation["carry"], spread.loss["carry"]]
    assert [row["mean"], row["deviation"], row["loss"]] == pytest.approx(parts)
    line = next(each for each in reversed(ran.out.splitlines()) if each.startswith("carry"))
    assert [float(each) for each in line.split()[2:]] == pytest.approx([each / 0.9144 for each in parts], abs=0.051)


def test_json_has_the_maps_asked_for(clubface_):
    document = clubface_("map", "driver", *SHOT, "--grid", "21x11", "--quantity", "carry,sidespin", "--json").json
    result = clubface.map_face("driver", DRIVE, grid=(21, 11))
    assert {name for name in document["tables"] if name.startswith("map")} == {"map_carry", "map_sidespin"}
    assert document["provenance"]["inputs"]["points of the face"] == "21 towards the toe, 11 upwards"
    rows = document["tables"]["map_carry"]["rows"]
    values = np.array([each["carry_m"] for each in rows], dtype=float).reshape(11, 21)[::-1]
    np.testing.assert_allclose(values, result.get("carry"), rtol=1e-12)
    assert document["tables"]["best_points"]["rows"][0]["effective_area_mm2"] == pytest.approx(1e6 * result.area())


def test_a_difference_is_printed_for_both_clubs(clubface_, stable):
    ran = clubface_("map", stable, "--minus", "driver", *SHOT, "--quantity", "ball_speed", "--spread", "12 mm x 9 mm")
    assert ran.status == 0, ran.err
    assert ran.out.startswith("stable less driver")
    rows = clubface_(
        "map", stable, "--minus", "driver", *SHOT, "--quantity", "ball_speed", "--spread", "12 mm x 9 mm", "--json"
    ).json["tables"]
    assert [each["club"] for each in rows["best_points"]["rows"]] == ["stable", "driver"]
    assert {each["club"] for each in rows["scatter"]["rows"]} == {"stable", "driver"}
    # More inertia is nowhere slower.
    assert rows["extremes"]["rows"][0]["least"] >= 0.0


def test_file_and_picture_are_written(clubface_, stable, tmp_path):
    pytest.importorskip("matplotlib")
    table, picture = tmp_path / "map.csv", tmp_path / "map.svg"
    ran = clubface_(
        "map", "driver", *SHOT, "--grid", "15x9", "-o", str(table), "--plot", str(picture), "--unit", "carry=m"
    )
    assert ran.status == 0, ran.err
    with table.open() as file:
        rows = list(csv.DictReader(file))
    result = clubface.map_face("driver", DRIVE, grid=(15, 9)).columns()
    assert len(rows) == len(result["toe"])
    np.testing.assert_allclose([float(row["carry_m"]) for row in rows], result["carry"], rtol=1e-12)
    np.testing.assert_allclose([float(row["toe_mm"]) for row in rows], 1e3 * result["toe"], atol=1e-9)
    assert picture.read_text().startswith("<?xml")
    assert sorted(each.name for each in tmp_path.iterdir()) == ["map.csv", "map.svg", "stable.toml"]
    other = tmp_path / "map.csv.unfinished"
    other.mkdir()  # of another command
    ran = clubface_(
        "map", "driver", "--minus", stable, *SHOT, "--grid", "15x9", "-o", str(table), "--plot", str(picture)
    )
    assert ran.status == 0, ran.err
    assert other.is_dir()
    with table.open() as file:
        assert "difference_carry_m" in next(csv.reader(file))


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--grid", "101"], ["--grid", "101x101"]),
        (["--grid", "2x2"], ["--grid", "3 to 2001"]),
        (["--spread", "12 mm"], ["--spread", "12 mm x 9 mm"]),
        (["--spread", "12 mm x 9 kg"], ["--spread", "mass"]),
        (["--spread", "0 mm x 9 mm"], ["--spread", "above 0"]),
        (["--toe", "5 mm"], ["--toe", "--spread"]),
        (["--quantity", "cary"], ["did you mean carry"]),
        (["--minus", "drivr"], ["did you mean driver"]),
        (["--plot", "a.doc"], ["--plot", ".png"]),
        (["-o", "a.doc"], ["--output", ".csv"]),
        (["--unit", "carry=rpm"], ["--unit", "rpm"]),
        (["--model", "fem", "--grid", "101x101"], ["at most 1000"]),
        (["--model", "nonsense"], ["model"]),
        (["--grid", "100000x100000"], ["--grid", "3 to 2001"]),
        (["--spread", "12 mm x"], ["--spread", "12 mm x 9 mm"]),
        (["--quantity", ","], ["--quantity", "such as carry"]),
        (["--quantity", "carry", "--unit", "side=m"], ["--unit", "side", "--quantity"]),
        (["--json", "--unit", "carry=m"], ["--unit", "--json"]),
        (["--unit", "carry=m", "--unit", "carry=yd"], ["--unit", "given once"]),
        (["--workers", "2"], ["--workers", "leave it out"]),
        (["--minus", "driver"], ["--minus", "another club"]),
        (["--accuracy", "1e-6"], ["--accuracy", "leave it out", "volumetric"]),
        (["--temperature", "900 degC"], ["--temperature"]),
        (["--humidity", "50"], ["--humidity"]),
    ],
)
def test_a_mistake_is_one_message(clubface_, arguments, words):
    assert_mistake(clubface_("map", "driver", *SHOT, *arguments), *words)
