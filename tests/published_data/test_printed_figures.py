"""Published figures, typed a second time from their source."""

import pytest

from clubface.fem.paper import LEAST_FACTOR, PUBLISHED, other_solvers
from clubface.inference.evaluation import published
from clubface.units import to_si


def test_the_figures_of_roh_and_lee_are_those_of_their_text():
    # Typed again from the text on Figs. 3 to 7 and Eqs. (9) and (11).
    assert PUBLISHED == {
        "ball_speed_mps": 50.4, "launch_deg": 9.8, "club_speed_after_mps": 24.0, "section_spin_rpm": 2047.0,
        "rolling_spin_rpm": 2298.0, "tangential_first_mps": 7.0, "tangential_least_time_s": 320e-6,
        "tangential_last_mps": 5.15, "peak_force_n": 6600.0, "peak_force_time_s": 280e-6, "reversal_time_s": 320e-6,
        "contraction": 0.23, "contraction_time_s": 300e-6, "f_prime": 0.8379, "f": 0.9476,
    }  # fmt: skip
    # "The minimum compression factor is 0.92", from their conclusions.
    assert LEAST_FACTOR == 0.92


def test_the_figures_of_other_solvers_are_those_of_their_runs():
    # Typed again from the output of the runs: one point, eight points, another program.
    solvers, results = other_solvers()
    assert solvers == ["one-point", "8-point", "2nd code"]
    assert results == {
        "normal_velocity_mps": [32.08, 32.06, 32.31], "tangential_velocity_mps": [5.82, 5.82, 5.75],
        "backspin_rpm": [1216, 1221, 1286],
        "spin_max_rpm": [3735, 3749], "peak_force_n": [8637, 8708, 8925], "contact_time_s": [626e-6, 624e-6, 601e-6],
        "peak_force_time_s": [278e-6, 282e-6, 295e-6], "tangential_max_n": [843, 851, 833],
        "tangential_min_n": [-727, -678, -667], "reversal_time_s": [307e-6, 305e-6, 305e-6],
    }  # fmt: skip


# Caldwell and McPhee (2023), Tables 2 to 5, and Caldwell (2023) for standard; typed again. Rows: ball speed [mph],
# launch and azimuth [deg], backspin and sidespin [rpm], as driver and 7-iron.
ERRORS = {
    "standard": [(1.87, 2.98), (0.71, 1.16), (0.79, 0.96), (224, 632), (158, 493)],
    "adjusted": [(1.51, 2.31), (0.68, 1.12), (0.78, 0.86), (211, 563), (153, 340)],
    "slip": [(1.85, 2.86), (0.71, 1.06), (0.81, 0.94), (219, 583), (149, 352)],
    "volumetric": [(2.12, 2.42), (0.54, 0.77), (1.07, 0.70), (228, 436), (227, 363)],
    "rings": [(2.27, 2.26), (0.52, 1.52), (1.13, 0.73), (385, 653), (298, 358)],
    "area": [(2.29, 3.33), (0.76, 1.63), (1.16, 0.82), (634, 998), (316, 403)],
}
UNITS = ("mph", "deg", "deg", "rpm", "rpm")


def test_the_published_errors_of_the_models_are_those_of_the_tables():
    result = published()
    assert len(result) == 2 * len(ERRORS)
    for model, rows in ERRORS.items():
        for place, club in enumerate(("driver", "7-iron")):
            mae = list(result[model, club].mae.values())
            typed = [to_si(row[place], unit) for row, unit in zip(rows, UNITS, strict=True)]
            assert mae == pytest.approx(typed, rel=1e-12), (model, club)  # a conversion rounds
