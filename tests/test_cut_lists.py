"""A list that a message cuts is said to go on, and one that is whole is not: one entry less, just as many, one more."""

from types import SimpleNamespace

import pytest

from clubface.errors import InputError
from clubface.evaluation import tables
from clubface.motion_capture.checks import _frames
from clubface.player_report.words import doubt
from clubface.tables.headings import listed


def rows_left_out(count, kind):
    of = SimpleNamespace(shots=SimpleNamespace(notes=(), dropped=(), source="shots.csv"), failed=())
    rows = tuple(SimpleNamespace(line=2 + each, reason="why") for each in range(count))
    if kind == "dropped":
        of.shots.dropped = rows
    else:
        of.failed = rows
    (told,) = tables.remarks(of)
    return told


@pytest.mark.parametrize("kind", ["dropped", "failed"])
@pytest.mark.parametrize("count", [4, 5, 6, 7])
def test_rows_that_an_evaluation_leaves_out(kind, count):
    told = rows_left_out(count, kind)
    assert told.count(": why") == min(count, 5)
    assert told.endswith("; ...)" if count > 5 else ": why)")
    assert f"{count} {'rows' if kind == 'dropped' else 'shots'} (2: why; 3: why" in told


@pytest.mark.parametrize("count", [11, 12, 13, 14])
def test_the_columns_of_a_table(count):
    names = [f"c{each}" for each in range(count)]
    assert listed(names) == f"there are: {', '.join(names[:12])}" + (", ..." if count > 12 else "")


@pytest.mark.parametrize("count", [3, 4, 5, 6])
def test_frames_without_a_marker(count):
    """Every second frame, so that each is a run of its own."""
    told = _frames([2 * each for each in range(count)], 1)
    first = ", ".join(str(1 + 2 * each) for each in range(min(count, 4)))
    assert told == f"frames {first}" + (f" and {count - 4} more" if count > 4 else "")


def test_frames_in_a_row_are_one_entry():
    assert _frames([4, 5, 6, 9], 10) == "frames 14-16, 19"
    assert _frames([4], 0) == "frame 4"


@pytest.mark.parametrize("length", [77, 78, 79, 100])
def test_values_too_long_for_a_line(length):
    """Quotes count, so that 78 letters are 80 characters."""
    told = str(InputError("name", "x" * length, "short"))
    assert ("..." in told) == (length > 78)
    assert f"name is {'x' * 10}" in told.replace("'", "")
    assert told.count("x") == (length if length <= 78 else 76)


@pytest.mark.parametrize("count", [9, 10, 11, 12])
def test_rows_whose_figures_hardly_go_together(count):
    of = SimpleNamespace(
        shots=range(40), measured={}, club=SimpleNamespace(name="driver"),
        inferred=SimpleNamespace(remarked=tuple(range(2, 2 + count)), refused=0),
    )  # fmt: skip
    (told,) = (each for each in doubt(of) if "hardly go together" in each)
    first = ", ".join(str(2 + each) for each in range(min(count, 10)))
    assert told.endswith(f"may be wrong: {first}" + (f" and {count - 10} more." if count > 10 else "."))
