"""Whole numbers are taken in whatever type they come, and nothing else is."""

import numpy as np
import pytest

import clubface
from clubface.errors import InputError
from clubface.support.checks import check_count, is_count

SWINGS = {name: {"club": name, "delivery": {"speed": "100 mph"}} for name in ("driver", "3-wood")}


@pytest.mark.parametrize("nine", [9, np.int8(9), np.int64(9), np.uint64(9), np.array(9)], ids=repr)
def test_a_whole_number_of_any_type_becomes_an_int(nine):
    assert is_count(nine, 1, 9)
    assert type(check_count("count", nine, 1, 9)) is int


@pytest.mark.parametrize("other", [9.0, np.float32(9), True, np.True_, "9", None, np.array([9, 9]), 0, 10], ids=repr)
def test_only_whole_numbers_within_limits_are_accepted(other):
    assert not is_count(other, 1, 9)
    with pytest.raises(InputError, match=r"count is .*1 to 9"):
        check_count("count", other, 1, 9)


def test_counts_of_numpy_do_what_those_of_python_do():
    whole = clubface.map_face("driver", speed="100 mph", grid=np.array([9, 7], dtype=np.int8))
    assert whole.get("carry").shape == (7, 9)
    few = clubface.dispersion("bogey-driver", count=np.int64(64), seed=np.uint8(3))
    assert few.mean("carry") == clubface.dispersion("bogey-driver", count=64, seed=3).mean("carry")
    split = clubface.compare(SWINGS, nodes=np.int8(2)).contributions["3-wood"]
    assert split.changes == clubface.compare(SWINGS, nodes=2).contributions["3-wood"].changes
