"""The command line gives the golden shots, which the core in Rust and the studio must give as well."""

import json
from pathlib import Path

import pytest

from clubface import units
from clubface.cli.app import run

GOLDEN = json.loads((Path(__file__).parents[1] / "golden/shots.json").read_text(encoding="utf-8"))
SAME = 1e-12
"""Relative difference: the last bits of logarithms and powers, which come from the machine's library, and of the
conversion to printed units and back."""
SCALES = {"side": 100.0, "total_side": 100.0, "curve": 100.0, "azimuth": 1.0, "sidespin": 100.0, "spin_axis": 1.0}
"""What is a difference of large numbers is compared on their scale [SI]."""


@pytest.mark.parametrize("shot", GOLDEN["shots"], ids=lambda shot: " ".join(shot["link"].values()))
def test_the_command_line_gives_it(shot, capsys):
    options = [f"--{key.replace('_', '-')}={text}" for key, text in shot["link"].items() if key != "club"]
    assert run(["shot", shot["link"]["club"], *options, "--json"]) == 0
    table = json.loads(capsys.readouterr().out)["tables"]["shots"]
    compared = 0
    for name, column in table["columns"].items():
        printed, expected = table["rows"][0][name], shot["numbers"].get(column.get("quantity"))
        if printed is None or expected is None:
            continue
        value = units.parse(f"{printed!r} {column['unit']}", units.unit(column["unit"]).dimension)
        assert value == pytest.approx(expected, rel=SAME, abs=SAME * SCALES.get(column["quantity"], 0.0)), name
        compared += 1
    assert compared > 12
