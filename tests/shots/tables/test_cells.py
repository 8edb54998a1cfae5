"""How a cell is shown in an error."""

import pytest

from clubface.shots.tables.cells import quoted_cell


@pytest.mark.parametrize("length", [0, 1, 39, 40])
def test_a_cell_of_up_to_forty_characters_is_shown_whole(length):
    assert quoted_cell("x" * length) == repr("x" * length)


@pytest.mark.parametrize("length", [41, 1000])
def test_a_longer_cell_is_shown_in_forty_by_its_beginning_and_its_end(length):
    shown = quoted_cell("a" * 25 + "x" * (length - 35) + "z" * 10)
    assert shown == repr("a" * 25 + " ... " + "z" * 10)
