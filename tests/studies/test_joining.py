"""One table of all parts, and what it comes to."""

import csv
import hashlib
import math

import numpy as np
import pytest

from clubface import studies
from clubface.errors import InputError
from clubface.studies.study_result import level_text, summary_picture
from clubface.units import from_si
from study_files import shots, squares

pa = pytest.importorskip("pyarrow.parquet")
pytestmark = pytest.mark.usefixtures("in_this_process")


@pytest.fixture
def drives(tmp_path):
    path = shots(tmp_path)
    studies.run(path)
    return path


def test_a_joined_table_has_all_tasks_in_order_with_units_and_provenance(drives, tmp_path):
    joined = studies.join(drives, tmp_path / "all.parquet")
    table = pa.read_table(tmp_path / "all.parquet")
    assert joined.tasks == table.num_rows == 24
    assert table.schema.field("carry").metadata == {b"unit": b"m"}
    assert b'"kind": "impact"' in table.schema.metadata[b"clubface"]
    toe = table.column("toe").to_numpy()
    np.testing.assert_allclose(toe[:6], [-0.01, -0.01, 0, 0, 0.01, 0.01], atol=1e-17)


def test_the_sum_of_a_column_is_that_of_its_values(drives, tmp_path):
    """Computed here by the definition alone: 8 bytes a number, least significant first."""
    joined = studies.join(drives, tmp_path / "all.parquet")
    values = pa.read_table(tmp_path / "all.parquet").column("carry").to_numpy()
    assert joined.sums["carry"] == hashlib.sha256(values.astype("<f8").tobytes()).hexdigest()


def test_a_csv_file_has_practical_units_and_the_same_sums(drives, tmp_path):
    joined = studies.join(drives, tmp_path / "all.csv")
    assert joined.sums == studies.join(drives).sums
    with (tmp_path / "all.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0]) == ["loft_deg", "toe_mm", "attack_deg", "ball_speed_mph", "backspin_rpm", "carry_m", "side_m"]
    assert (rows[0]["loft_deg"], rows[0]["toe_mm"], rows[0]["attack_deg"]) == ("8", "-10", "-3")
    table = studies.join(drives, tmp_path / "all.parquet") and pa.read_table(tmp_path / "all.parquet")
    spins = from_si(table.column("backspin").to_numpy(), "rpm")
    np.testing.assert_allclose([float(row["backspin_rpm"]) for row in rows], spins, rtol=1e-8)  # nine digits


def test_a_study_is_summed_up_as_the_definitions_say(drives, tmp_path):
    studies.join(drives, tmp_path / "all.parquet")
    table = pa.read_table(tmp_path / "all.parquet")
    result = studies.summary(drives, quantities=["carry", "side"])
    carry, loft = (table.column(name).to_numpy() for name in ("carry", "loft"))
    # Sums of 24 numbers differ by rounding alone.
    assert result.overall.mean[0] == pytest.approx(carry.mean(), rel=1e-14)
    assert result.overall.deviation[0] == pytest.approx(carry.std(), rel=1e-12)
    assert (result.overall.least[0], result.overall.most[0]) == (carry.min(), carry.max())
    (along,) = [each for each in result.along if each.name == "loft"]
    assert along.levels == np.unique(loft).tolist()
    for level, figures in zip(along.levels, along.figures, strict=True):
        here = carry[loft == level]
        assert figures.count.tolist() == [6, 6]
        assert figures.mean[0] == pytest.approx(here.mean(), rel=1e-14)
        assert figures.deviation[0] == pytest.approx(here.std(), rel=1e-12)


@pytest.mark.parametrize("quantities", ["carry", 3])
def test_quantities_to_sum_up_are_a_list(drives, quantities):
    with pytest.raises(InputError, match=r'a list of quantities, as in \["carry"\]'):
        studies.summary(drives, quantities=quantities)


def test_many_values_are_put_into_classes(tmp_path):
    path = squares(tmp_path, count=1001, chunk=37)
    studies.run(path)
    result = studies.summary(path)
    # Of x squared over [0, 1]: mean 1/3, deviation sqrt(4/45); the ends count as whole points, 1e-3 each.
    assert result.overall.mean[0] == pytest.approx(1 / 3, abs=1e-3)
    assert result.overall.deviation[0] == pytest.approx(math.sqrt(4 / 45), abs=1e-3)
    (along,) = result.along
    assert len(along.levels) == 10
    assert along.levels[9] == (pytest.approx(0.9), 1.0)
    assert sum(figures.count[0] for figures in along.figures) == 1001
    assert along.figures[3].least[0] == pytest.approx(0.09, abs=1e-3)  # 0.3 itself may fall on either side


def test_a_flat_face_is_no_class_of_numbers(tmp_path):
    """Fifty bulges from 250 mm to 299 mm in ten classes of five, and the flat face by itself."""
    bulges = ", ".join(f'"{millimetres} mm"' for millimetres in range(250, 300))
    text = f"""
[study]
chunk = {{chunk}}
[impact]
club = "driver"
held = {{{{ speed = "105 mph", toe = "10 mm" }}}}
outputs = ["azimuth"]
[sweep]
bulge = [{bulges}, "flat"]
"""
    path = shots(tmp_path, chunk=20, text=text)
    studies.run(path)
    result = studies.summary(path)
    (along,) = result.along
    assert [each.count[0] for each in along.figures] == [5] * 10 + [1]
    assert along.levels[-1] == math.inf
    assert along.levels[9] == (pytest.approx(0.2941), pytest.approx(0.299))
    # The toe of a flat face points where its centre does; each class of curved ones points further to the right.
    assert along.figures[-1].mean[0] < along.figures[9].mean[0] < along.figures[0].mean[0]
    assert level_text(along, -1) == "flat"
    pytest.importorskip("matplotlib")
    from clubface.present.drawing import draw

    draw(summary_picture(result)).canvas.draw()


def test_a_summary_does_not_depend_on_chunks_beyond_rounding(tmp_path):
    small, large = squares(tmp_path, chunk=7), squares(tmp_path, chunk=50, name="large.toml")
    result = []
    for each in (small, large):
        studies.run(each)
        result.append(studies.summary(each).overall)
    assert result[0].mean[0] == pytest.approx(result[1].mean[0], rel=1e-14)
    assert result[0].deviation[0] == pytest.approx(result[1].deviation[0], rel=1e-13)


def test_a_picture_shows_every_quantity_along_every_input(drives):
    pytest.importorskip("matplotlib")
    from clubface.present.drawing import draw

    figure = draw(summary_picture(studies.summary(drives)))
    assert [each.get_xlabel().split(" (")[1] for each in figure.axes[-3:]] == ["deg)", "mm)", "deg)"]
    assert [figure.axes[3 * row].get_ylabel() for row in range(4)] == [
        "ball speed (mph)",
        "backspin (rpm)",
        "carry (yd)",
        "side (yd)",
    ]
    mean = figure.axes[0].get_lines()[0].get_ydata()
    assert len(mean) == 4
