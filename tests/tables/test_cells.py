"""How a cell is shown in an error."""

import pytest

from clubface.tables.cells import shortened


@pytest.mark.parametrize("length", [0, 1, 39, 40])
def test_a_cell_of_up_to_forty_characters_is_shown_whole(length):
    assert shortened("x" * length) == repr("x" * length)


@pytest.mark.parametrize("length", [41, 1000])
def test_a_longer_cell_is_shown_in_forty(length):
    assert shortened("x" * length) == repr("x" * 37 + "...")
