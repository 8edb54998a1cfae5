"""Published figures stand twice: a cell that is mistyped, swapped or lost afterwards no longer matches its digest.

A digest is of the numbers alone, with the place of each, so that words may be changed freely. Who corrects a figure,
with the source in hand, writes the new digest beside the file's name; the message tells it.
"""

import hashlib
import tomllib

import pytest

from clubface import published_data
from clubface.fem.paper import LEAST_FACTOR, PUBLISHED, other_solvers
from clubface.inference.evaluation import published
from clubface.support.files import DATA
from clubface.units import to_si

DIGESTS = {
    "clubs/7-iron.toml": "6f7b1534",
    "clubs/driver-as-printed.toml": "1a90914c",
    "clubs/driver.toml": "2f2c36ea",
    "measurements/averages.toml": "c5c8c525",
    "measurements/ball.toml": "b4afb422",
    "measurements/club-heads.toml": "96a8adfe",
    "measurements/flights.toml": "28367149",
    "measurements/heads-irons-2022-2026.csv": "b249cd9c",
    "measurements/launches.toml": "e353da1b",
    "measurements/lpga-2019.csv": "acc1d46c",
    "measurements/lpga-2023.csv": "462ad632",
    "measurements/optimum-launch.toml": "e3b0c442",
    "measurements/optimum-ping-2019.csv": "27d93e3f",
    "measurements/optimum-trackman-2010.csv": "8ec7d3d0",
    "measurements/pga-2019.csv": "126b2737",
    "measurements/pga-2023.csv": "7bcfc8a0",
    "measurements/robot-7-irons-2026.csv": "cd650c15",
    "measurements/robots.toml": "1f382243",
    "measurements/rules.toml": "190723cf",
    "measurements/strikes.toml": "292b65c4",
    "measurements/strokes-gained.toml": "3b1afdee",
    "measurements/strokes-to-hole-out.csv": "6729e1a6",
    "parameters/golf-ball-spin-fem.toml": "4da5f32d",
    "parameters/jorgensen.toml": "719cbe4c",
    "parameters/penner.toml": "86373a41",
    "parameters/three-dimensional-impact-models.toml": "2e67d411",
    "parameters/tour-averages.toml": "ae18e921",
    "published_accuracy.toml": "b5cfb46f",
    "published_impacts.toml": "589075ec",
}


def numbers(value, place=""):
    """Yield the place and the number of every number in a document, and of every text that begins with one."""
    if isinstance(value, dict):
        for key, each in value.items():
            yield from numbers(each, f"{place}.{key}")
    elif isinstance(value, list):
        for index, each in enumerate(value):
            yield from numbers(each, f"{place}[{index}]")
    elif isinstance(value, bool):
        yield place, value
    elif isinstance(value, int | float):
        yield place, float(value)
    elif isinstance(value, str) and value[:1] in "+-.0123456789" and value:
        yield place, value


def digest(path):
    """Return eight digits that change with any number of a file; columns of numbers in CSV are such texts."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".csv":
        document = {str(row): line.split(",") for row, line in enumerate(text.splitlines())}
    else:
        document = tomllib.loads(text)
    told = "\n".join(f"{place} {number!r}" for place, number in numbers(document))
    return hashlib.sha256(told.encode()).hexdigest()[:8]


PUBLICATIONS = sorted(
    str(path.relative_to(DATA))
    for pattern in (
        "measurements/*.*",
        "published_*.toml",
        "parameters/*.toml",
        "clubs/driver*.toml",
        "clubs/7-iron.toml",
    )
    for path in DATA.glob(pattern)
)


def test_every_file_of_published_figures_has_a_digest():
    assert list(DIGESTS) == PUBLICATIONS


@pytest.mark.parametrize("name", PUBLICATIONS)
def test_no_number_has_changed_since_it_was_compared_with_its_source(name):
    assert digest(DATA / name) == DIGESTS[name], f"{name}: compare its figures with their source"


def test_a_digit_a_swap_and_a_lost_cell_change_a_digest(tmp_path):
    path = tmp_path / "x.toml"
    found = set()
    for rows in ('[["x", 90], ["y", 80]]', '[["x", 91], ["y", 80]]', '[["x", 80], ["y", 90]]', '[["x", 90]]'):
        path.write_text(f"rows = {rows}\n")
        found.add(digest(path))
    assert len(found) == 4


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
    solvers, told = other_solvers()
    assert solvers == ["one-point", "8-point", "2nd code"]
    assert told == {
        "normal_mps": [32.08, 32.06, 32.31], "tangential_mps": [5.82, 5.82, 5.75], "spin_rpm": [1216, 1221, 1286],
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
    found = published()
    assert len(found) == 2 * len(ERRORS)
    for model, rows in ERRORS.items():
        for place, club in enumerate(("driver", "7-iron")):
            mae = list(found[model, club].mae.values())
            typed = [to_si(row[place], unit) for row, unit in zip(rows, UNITS, strict=True)]
            assert mae == pytest.approx(typed, rel=1e-12), (model, club)  # a conversion rounds


def test_the_sums_of_measurements_are_read_from_the_files_that_have_digests():
    assert {f"measurements/{name}.toml" for name in published_data.subjects()} <= set(DIGESTS)
