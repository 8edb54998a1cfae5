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
    found = clubface.map_face("driver", DRIVE)
    line = next(each for each in ran.out.splitlines() if each.startswith("carry, yd"))
    cells = [float(each) for each in line.removeprefix("carry, yd").split()]
    carries = found.get("carry", "yd")
    assert cells[1] == pytest.approx(np.nanmin(carries), abs=0.051)
    assert cells[4] == pytest.approx(np.nanmax(carries), abs=0.051)
    up, across = np.unravel_index(np.nanargmin(carries), carries.shape)
    assert cells[2:4] == pytest.approx([1e3 * found.toe[across], 1e3 * found.high[up]], abs=0.51)
    best = found.best()
    assert (
        f"{abs(1e3 * best.toe):.1f} mm towards the heel and {abs(1e3 * best.high):.1f} mm below the centre" in ran.out
    )
    assert f"{1e6 * found.area():.0f} of the {1e6 * found.outline.area():.0f} mm2" in " ".join(ran.out.split())
    spread = found.forgiveness(("12 mm", "9 mm"))
    line = next(each for each in reversed(ran.out.splitlines()) if each.startswith("carry, yd"))
    mean, deviation, loss = (float(each) for each in line.removeprefix("carry, yd").split())
    assert [mean, deviation, loss] == pytest.approx(
        [each / 0.9144 for each in (spread.mean["carry"], spread.deviation["carry"], spread.loss["carry"])], abs=0.051
    )
    assert "assumed: an ellipse of 105 mm by 55 mm" in ran.out


def test_json_has_the_maps_asked_for(clubface_):
    document = clubface_("map", "driver", *SHOT, "--grid", "21x11", "--quantity", "carry,sidespin", "--json").json
    found = clubface.map_face("driver", DRIVE, grid=(21, 11))
    assert set(document["map"]) == {"carry_m", "sidespin_rpm"}
    assert document["grid"] == [21, 11]
    values = np.array(document["map"]["carry_m"], dtype=float)
    np.testing.assert_allclose(values, found.get("carry"), rtol=1e-12)
    assert document["clubs"][0]["area_98_mm2"] == pytest.approx(1e6 * found.area())


def test_a_difference_is_told_for_both_clubs(clubface_, stable):
    ran = clubface_("map", stable, "--minus", "driver", *SHOT, "--quantity", "ball_speed", "--spread", "12 mm x 9 mm")
    assert ran.status == 0, ran.err
    assert ran.out.startswith("stable less driver")
    assert "stable: the sweet spot" in ran.out
    assert "driver: the sweet spot" in ran.out
    # More inertia is nowhere slower.
    line = next(each for each in ran.out.splitlines() if each.startswith("ball speed, mph"))
    assert float(line.removeprefix("ball speed, mph").split()[1]) >= 0.0


def test_file_and_picture_are_written(clubface_, stable, tmp_path):
    pytest.importorskip("matplotlib")
    table, picture = tmp_path / "map.csv", tmp_path / "map.svg"
    ran = clubface_(
        "map", "driver", *SHOT, "--grid", "15x9", "-o", str(table), "--plot", str(picture), "--unit", "carry=m"
    )
    assert ran.status == 0, ran.err
    with table.open() as file:
        rows = list(csv.DictReader(file))
    found = clubface.map_face("driver", DRIVE, grid=(15, 9)).columns()
    assert len(rows) == len(found["toe"])
    np.testing.assert_allclose([float(row["carry_m"]) for row in rows], found["carry"], rtol=1e-12)
    np.testing.assert_allclose([float(row["toe_mm"]) for row in rows], 1e3 * found["toe"], atol=1e-9)
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
