"""Deliveries from Parquet and launches to Parquet: types, provenance, damaged files."""

import json
import math

import pytest

import clubface
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import FileError
from clubface.shots.prediction import predict
from deliveries import GOOD, table

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")


def test_parquet_in_and_out_keeps_types_and_says_where_it_comes_from(write, tmp_path):
    pyarrow = pytest.importorskip("pyarrow")
    import pyarrow.parquet as files

    source = pyarrow.table(
        {
            "when": pyarrow.array([1, 2, 3, 4], pyarrow.timestamp("ms")),
            "club_speed [mph]": [113.0, None, math.nan, 100.0],
            "toe_mm": pyarrow.array([5, 5, 5, 80], pyarrow.int8()),
            "attack_deg": ["-1.3", "1", "1", "1"],
        }
    )
    files.write_table(source, tmp_path / "in.parquet")
    report = predict(tmp_path / "in.parquet", club="driver", output=tmp_path / "out.parquet", chunk_rows=3)
    assert (report.rows, report.written) == (4, 1)
    assert [line for line, _ in report.first_rejects] == [2, 3, 4]
    assert [row["row"] for row in table(report.rejects)] == ["2", "3", "4"]
    for message, (_, reason) in zip(("empty", "nan is not", "80.0 mm"), report.first_rejects, strict=True):
        assert message in reason
    result = files.read_table(tmp_path / "out.parquet")
    assert result.schema.field("when").type == pyarrow.timestamp("ms")
    assert result["ball_speed_mps"][0].as_py() == pytest.approx(
        clubface.impact("driver", speed="113 mph", toe="5 mm", attack="-1.3 deg").ball_speed, rel=1e-14
    )
    assert json.loads(result.schema.metadata[b"clubface"])["model"]["name"] == DEFAULT_MODEL
    predict(tmp_path / "in.parquet", club="driver", output=tmp_path / "out.csv")
    assert table(tmp_path / "out.csv")[0]["when"] == "1970-01-01 00:00:00.001000"
    for content in (b"PAR1nonsensePAR1", b"", b"a,b\n"):
        with pytest.raises(FileError, match="Parquet"):
            predict(write(content, "bad.parquet"), club="driver", output=tmp_path / "out.csv")


def test_parquet_without_pyarrow_says_what_to_install(write, tmp_path, monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(FileError, match="pip install"):
        predict(write(GOOD), club="driver", output=tmp_path / "out.parquet")


def test_the_part_that_is_done_grows_from_nothing_to_all(write, tmp_path):
    predict(write(GOOD), club="driver", output=tmp_path / "in.parquet", carry=False)
    parts = []
    predict(
        tmp_path / "in.parquet", club="driver", output=tmp_path / "out.csv", chunk_rows=1,
        progress=lambda part, rows: parts.append((part, rows)),
    )  # fmt: skip
    assert parts == [(0.5, 1), (1.0, 2)]
