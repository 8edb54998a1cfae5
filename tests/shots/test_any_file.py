"""Whatever a launch monitor's file holds, a shot is read whole, told with its line, or the file is refused."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st

from clubface import shots as launch_monitor
from clubface.errors import ClubfaceError

DATA = Path(__file__).parents[1] / "data" / "launch_monitors"
FILES = {path.name: path.read_bytes() for path in sorted(DATA.glob("*.csv"))}

JUNK = """
|-|nan|1e400|3.4e38|1_0|L|5 L|-5 L|L5|1,5|1.234,5|"|[mph]|Club Speed|Average|٣|\x00|1;2|Ball Speed (mph)|
Push/Pull (deg L-/R+)|sep=;|−3|5°|0"""
junk = st.one_of(st.sampled_from(JUNK.replace("\n", "").split("|")), st.text(max_size=5))


def read_or_refused(path, **options):
    try:
        return launch_monitor.read(path, **options)
    except ClubfaceError:
        return None


def assert_whole(shots):
    lines = shots.rows.tolist()
    assert len(set(lines)) == len(lines) > 0
    assert not set(lines) & {each.line for each in shots.rejected}
    for values in (shots.deliveries | shots.launches).values():
        assert not np.isinf(values).any()
    assert all(each.reason for each in shots.rejected)


@settings(max_examples=50)
@given(content=st.one_of(st.binary(max_size=80), st.lists(st.lists(junk, max_size=4).map(",".join)).map("\n".join)))
@example(content=b"sep=,\n")
@example(content=b"Push/Pull (deg L-/R+)\n[]\n")
@example(content=b"Ball,Smash,Lateral\n" + b'"' * 5)
@example(content="Swing Plane,Swing Direction,Spin Rate\n,,1.000.000\n")
def test_any_bytes_are_read_or_refused(tmp_path, content):
    path = tmp_path / "fuzz.csv"
    path.write_bytes(content.encode("utf-8", "surrogatepass") if isinstance(content, str) else content)
    for options in ({}, {"format": "trackman"}, {"mapping": DATA / "other.toml"}):
        if (shots := read_or_refused(path, **options)) is not None:
            assert_whole(shots)


@settings(max_examples=60)
@given(
    name=st.sampled_from(sorted(FILES)),
    changes=st.lists(st.tuples(st.integers(0, 400), junk), min_size=1, max_size=4),
    drop=st.lists(st.integers(0, 12), max_size=2),
    twice=st.lists(st.integers(0, 12), max_size=2),
    hand=st.sampled_from([None, "left"]),
)
def test_files_with_changed_cells_and_missing_or_repeated_lines_are_read_or_refused(
    tmp_path, name, changes, drop, twice, hand
):
    text = FILES[name].decode("cp1252" if name == "other.csv" else "utf-8")
    delimiter = ";" if ";" in text else ","
    lines = text.splitlines()
    cells = [(row, column) for row, line in enumerate(lines) for column in range(line.count(delimiter) + 1)]
    table = [line.split(delimiter) for line in lines]
    for place, value in changes:
        row, column = cells[place % len(cells)]
        table[row][column] = value
    kept = [line for row, line in enumerate(table) for _ in range(1 + (row in twice)) if row not in drop]
    path = tmp_path / "fuzz.csv"
    path.write_bytes("\n".join(map(delimiter.join, kept)).encode("utf-8", "surrogatepass"))
    options = {"mapping": DATA / "other.toml"} if name == "other.csv" else {}
    if (shots := read_or_refused(path, hand=hand, **options)) is not None:
        assert_whole(shots)


@pytest.mark.parametrize("name", ["trackman.csv", "garmin-de.csv", "rapsodo.csv"])
def test_a_truncated_file_keeps_the_values_of_its_whole_lines(tmp_path, name):
    content = FILES[name]
    whole = launch_monitor.read(DATA / name)
    values = whole.deliveries | whole.launches
    path = tmp_path / "cut.csv"
    ends = [place + 1 for place, byte in enumerate(content) if byte == ord("\n")]
    for size in range(0, len(content), 13):
        path.write_bytes(content[:size])
        shots = read_or_refused(path)
        if shots is None:
            continue
        complete = sum(end <= size for end in ends)  # lines
        for place, line in enumerate(shots.rows):
            assert line <= complete + 1
            if line <= complete:
                same = int(np.flatnonzero(whole.rows == line)[0])
                for quantity, column in (shots.deliveries | shots.launches).items():
                    np.testing.assert_equal(column[place], values[quantity][same])
