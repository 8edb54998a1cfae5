"""The command line gives the golden numbers, which the core in Rust and the studio must give as well."""

import json
from pathlib import Path

import pytest

from clubface import _core, units

FOLDER = Path(__file__).parents[1] / "golden"


def stored(name):
    return json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))


SAME, SCALES = stored("tolerance").values()


def cases(*names):
    every = [case for name in names for case in stored(name)["cases"]]
    return pytest.mark.parametrize("case", every, ids=lambda case: " ".join(case["link"].values()))


def options_of(link, *settings, conditions=None):
    """The options that the keys of a link stand for, without settings of a page.

    The command line takes the components of a wind, which are those of the ``conditions``, a link where it comes from.
    """
    left_out = ("club", "wind", "wind_from", *settings)
    options = [f"--{name.replace('_', '-')}={text}" for name, text in link.items() if name not in left_out]
    if "wind" in link:
        options.append(f"--wind={conditions['wind_x']!r} m/s, {conditions['wind_z']!r} m/s")
    return options


def si(value, unit):
    return units.parse(f"{value!r} {unit}", units.unit(unit).dimension)


def row_si(table):
    """The quantities of the first row of a table in SI."""
    values = table["rows"][0]
    return {
        column["quantity"]: si(values[name], column["unit"])
        for name, column in table["columns"].items()
        if "quantity" in column and values[name] is not None
    }


def assert_same(numbers, expected, least):
    """Numbers by name are those stored, and at least so many are both printed and stored."""
    common = numbers.keys() & expected.keys()
    assert len(common) >= least
    for name in common:
        scale = SCALES.get(name.split()[0], 0.0)
        assert numbers[name] == pytest.approx(expected[name], rel=SAME, abs=SAME * scale), name


@cases("shots", "flights")
def test_shots_and_flights(case, clubface_):
    options = options_of(case["link"], conditions=case.get("conditions"))
    ran = clubface_("shot", case["link"]["club"], *options, "--json")
    assert_same(row_si(ran.json["tables"]["shots"]), case["numbers"], 13)


@cases("maps")
def test_maps(case, clubface_):
    link = case["link"]
    spread, wanted = f"{link['strikes_toe']} x {link['strikes_high']}", link["map"]
    options = options_of(link, "map", "map_minus", "strikes_toe", "strikes_high")
    options += [f"--minus={link['map_minus']}"] if "map_minus" in link else []
    ran = clubface_(
        "map", link["club"], *options, f"--quantity={wanted}", "--grid=41x41", f"--spread={spread}", "--json"
    )
    tables = ran.json["tables"]

    table = tables[f"map_{wanted}"]
    (value,) = (name for name in table["columns"] if name.startswith((wanted, "difference_")))
    unit = table["columns"][value]["unit"]
    rows = {(round(row["toe_mm"], 3), round(row["high_mm"], 3)): row[value] for row in table["rows"]}
    numbers, expected = {}, {}
    for high, stored_row in zip(case["high"], case["values"], strict=True):
        for toe, stored_value in zip(case["toe"], stored_row, strict=True):
            printed = rows.get((round(1e3 * toe, 3), round(1e3 * high, 3)))
            assert (printed is None) == (stored_value is None)
            if printed is not None:
                name = f"{wanted} {toe} {high}"
                numbers[name], expected[name] = printed * units.size(unit), stored_value
    assert_same(numbers, expected, 20)

    for place, face in enumerate(case["faces"]):
        best = tables["best_points"]["rows"][place]
        numbers = {"effective_area": 1e-6 * best["effective_area_mm2"], "face_area": 1e-6 * best["face_area_mm2"]}
        for what, name in (("sweet_spot", "ball_speed"), ("longest", "carry")):
            numbers |= {f"{axis} {name}": 1e-3 * best[f"{what}_{axis}_mm"] for axis in ("toe", "high")}
        for row in tables["scatter"]["rows"]:
            if row["club"] == best["club"]:
                kinds = ("mean", "deviation", "loss")
                numbers |= {f"{row['quantity']} {kind}": row[kind] * units.size(row["unit"]) for kind in kinds}
                numbers["missed"] = row["missed"]
        assert_same(numbers, face["numbers"], 31)


@cases("dispersions")
def test_dispersions(case, clubface_):
    names = [entry["name"] for entry in _core.flight_inputs()]
    conditions = dict(zip(names, case["setup"]["flight"], strict=True))
    options = options_of(case["link"], "golfer", conditions=conditions)
    ran = clubface_("dispersion", case["link"]["golfer"], *options, f"--count={case['count']}", "--no-shares", "--json")
    tables = ran.json["tables"]
    numbers = dict(ran.values)
    for row in tables["quantities"]["rows"]:
        for name, value in row.items():
            if name in ("mean", "spread") or name.startswith("quantile_"):
                numbers[f"{row['quantity']} {name.removeprefix('quantile_')}"] = value * units.size(row["unit"])
    for row in tables["ellipses"]["rows"]:
        share = row["share"]
        numbers |= {f"carry centre {share}": row["centre_ahead_m"], f"side centre {share}": row["centre_right_m"]}
        numbers |= {f"carry long {share}": 0.5 * row["long_axis_m"], f"carry short {share}": 0.5 * row["short_axis_m"]}
        numbers[f"azimuth ellipse {share}"] = si(row["angle_deg"], "deg")
    (on_hole,) = tables["strokes"]["rows"]
    numbers["strokes"] = on_hole["strokes_after"]
    numbers |= {f"share {lie}": on_hole[f"share_{lie}"] for lie in ("green", "fairway", "rough", "recovery")}
    assert_same(numbers, case["numbers"], len(case["numbers"]))


def test_the_reference_case_and_a_drive_by_finite_elements(clubface_):
    case, drive = stored("elements")["cases"]
    reference = clubface_("fem", "reference", "--json").json["tables"]["reference"]
    assert_same(row_si(reference), case["numbers"], 10)
    options = options_of(drive["link"], "against", "follow")
    shot = clubface_("shot", drive["link"]["club"], "--model=fem", *options, "--json").json["tables"]["shots"]
    assert_same(row_si(shot), drive["numbers"], 10)
