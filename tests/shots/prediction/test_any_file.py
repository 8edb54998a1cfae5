"""Whatever a file of deliveries holds, every row is accounted for."""

import pytest
from hypothesis import example, given, settings, strategies as st

from clubface.errors import ClubfaceError
from clubface.shots.prediction import predict
from clubface.shots.tables import row_source

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

cells = st.one_of(
    st.sampled_from(["113", "-1", "0", "nan", "1e400", "", " 50", "1_0", "abc", "9" * 400, "٣", "\x00", '"', "a\nb"]),
    st.text(max_size=6),
)
lines = st.lists(cells, max_size=5).map(",".join)
texts = st.lists(lines, max_size=6).map("\n".join)
heads = st.sampled_from(["speed", "speed,toe_mm", "speed;toe_mm", "club_speed_mph,x,x", "speed [", "speed(mph),", ""])


@settings(max_examples=50)
@given(
    content=st.one_of(
        st.binary(max_size=80),
        st.tuples(heads, texts).map(lambda parts: "\n".join(parts).encode("utf-8", "surrogatepass")),
    )
)
@example(content=b"speed\n" + b'"' + b"1," * 200_000)
def test_every_row_of_any_file_is_accounted_for_or_the_file_is_refused(tmp_path, content):
    """Fuzz: only a ClubfaceError comes out, and each row read is either written or rejected."""
    path = tmp_path / "fuzz.csv"
    path.write_bytes(content)
    try:
        report = predict(path, club="driver", output=tmp_path / "out.csv", carry=False, chunk_rows=2)
    except ClubfaceError:
        return
    assert report.written + report.rejected == report.rows > 0
    rejects = row_source.CsvReader(tmp_path / "out.rejects.csv") if report.rejects else None
    if rejects is not None:
        kept = sum(len(chunk.lines) + len(chunk.ragged) for chunk in rejects.chunks(100, 0))
        rejects.close()
        assert kept == report.rejected
