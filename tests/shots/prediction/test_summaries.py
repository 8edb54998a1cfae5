"""Tables of deliveries of no maker: rows that sum up others are no deliveries, whoever reads the table."""

import pytest

from clubface.design.comparison import read_deliveries
from clubface.errors import FileError
from clubface.shots.prediction import predict
from clubface.studies.study import read_study

pytestmark = pytest.mark.filterwarnings("ignore")
HEAD = "shot,club_speed_mph,attack_deg\n1,100,1\n2,101,2\n"
SUMMED_UP = {
    "in the column of shots": HEAD + "Average,100.5,1.5\nStd Dev,0.7,0.7\n",
    "in a column of remarks": (
        "club_speed_mph,attack_deg,remark\n100,1,first\n101,2,second\n100.5,1.5,Mean of all\n0.7,0.7,SD\n"
    ),
    "in German": (
        "id;club_speed_mph;attack_deg\n1;100;1\n2;101;2\nDurchschnitt;100,5;1,5\nStandardabweichung;0,7;0,7\n"
    ),
    "of extremes": HEAD + "Max,101,2\nMin,100,1\n",
}


@pytest.mark.parametrize("text", SUMMED_UP.values(), ids=SUMMED_UP)
def test_no_launch_is_computed_for_an_average(text, write, tmp_path):
    report = predict(write(text), club="driver", output=tmp_path / "out.csv", carry=False)
    assert (report.rows, report.written, report.rejected) == (4, 2, 2)
    assert [line for line, reason in report.first_rejects if "sums up" in reason] == [4, 5]


@pytest.mark.parametrize("text", SUMMED_UP.values(), ids=SUMMED_UP)
def test_an_average_is_refused_in_a_study(text, write, tmp_path):
    path = write(text)
    (tmp_path / "study.toml").write_text(
        f'[study]\ndesign = "table"\n[impact]\nclub = "driver"\n[sweep]\ntable = "{path.name}"\n'
    )
    with pytest.raises(FileError, match=r":4:.* sums up"):
        read_study(tmp_path / "study.toml")


def test_an_average_is_not_compared(write):
    notes = []
    result = read_deliveries(write(SUMMED_UP["in the column of shots"]), 10, notes.append)
    assert list(result) == ["1", "2"]
    assert [each[:6] for each in notes if "sums up" in each] == ["line 4", "line 5"]


def test_a_player_called_max_keeps_his_deliveries(write, tmp_path):
    text = "player,club_speed_mph\nAnna,100\nMax,104\nMax,98\nAnna,101\n"
    assert predict(write(text), club="driver", output=tmp_path / "out.csv", carry=False).written == 4


def test_averages_in_parquet_are_no_deliveries(tmp_path):
    arrow = pytest.importorskip("pyarrow")
    from pyarrow.parquet import write_table

    write_table(
        arrow.table({"shot": ["1", "2", "Average"], "club_speed_mph": [100.0, 101.0, 100.5]}), tmp_path / "in.parquet"
    )
    assert predict(tmp_path / "in.parquet", club="driver", output=tmp_path / "out.csv", carry=False).written == 2
