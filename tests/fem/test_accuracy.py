"""What bounds the error of a run, and the figures that ``make fem-figures`` keeps for the pages."""

import json
import runpy
from pathlib import Path

import pytest

from clubface import fem
from clubface.fem import paper

ROOT = Path(__file__).parents[2]
STORED = json.loads((ROOT / "docs" / "fem-figures.json").read_text(encoding="utf-8"))


def test_the_mesh_that_runs_quote_is_what_the_code_computes():
    rows = {each["thirds"]: each for each in paper.stored_meshes()["rows"]}
    made = paper.meshes(fem.ball("reference"), [2, 3])
    for thirds, ball in zip((2, 3), made, strict=True):
        row = paper.mesh_row(fem.reference(ball=ball, settings=fem.Settings(until_separation=True)))
        # Six digits are kept; packs of elements agree with single ones to rounding.
        assert {key: row[key] for key in rows[thirds] if key != "thirds"} == pytest.approx(
            {key: value for key, value in rows[thirds].items() if key != "thirds"}, rel=1e-5
        )


def test_the_bounds_of_the_error_follow_from_the_meshes_and_the_other_solvers():
    bounds = paper.error_bounds()
    # The page's own figures: 32.76 and 32.71 m/s, 1263 and 1216 rpm; solvers 32.59 to 32.82 m/s and 1216 to 1286 rpm.
    assert bounds.speed_over_meshes == pytest.approx(1.0 - 32.711 / 32.761, abs=1e-4)
    assert bounds.spin_over_meshes == pytest.approx(1.0 - 1216.0 / 1263.0, abs=1e-3)
    assert bounds.speed_over_solvers == pytest.approx(1.0 - 32.584 / 32.761, abs=2e-4)
    assert bounds.spin_over_solvers == pytest.approx(1.0 - 1216.0 / 1263.0, abs=1e-3)


@pytest.mark.study
@pytest.mark.parametrize("section", STORED)
def test_the_stored_figures_are_what_the_code_computes(section):
    figures = runpy.run_path(str(ROOT / "benchmarks" / "fem_figures.py"))
    computed = figures["compute"](section)
    assert set(computed) == set(STORED[section]["figures"])
    for what, stored in STORED[section]["figures"].items():
        # A figure of a page has four digits at most; differences of two runs are known to 1e-6 of either.
        assert computed[what] == pytest.approx(stored, rel=1e-4, abs=1e-6), what
