"""The table of captured swings: whose hand, which club, which file, and where speed and face were measured."""

from types import SimpleNamespace

import numpy as np
import pytest

from clubface import club
from clubface.capture.reduction import QUANTITIES
from clubface.capture.swing import CapturedSwings
from clubface.errors import InputError
from clubface.results.notes import note


def swing(hand, source, **launch):
    values = {name: float(place) for place, name in enumerate(QUANTITIES)}
    return SimpleNamespace(
        club=club("driver").replace(hand=hand), source=source, notes=(note("text", text=f"of {hand}"),), launch=launch,
        launch_uncertainty=dict.fromkeys(launch, 0.25), delivery=SimpleNamespace(**values),
        uncertainty=dict.fromkeys(QUANTITIES, 0.5),
    )  # fmt: skip


@pytest.fixture
def swings(tmp_path):
    captured = (swing(1, tmp_path / "a.c3d", ball_speed=60.0), swing(-1, tmp_path / "b.c3d"))
    return CapturedSwings(captured=captured, places=(1, 3), rejected=())


def test_each_swing_keeps_its_hand_club_and_place(swings, tmp_path):
    table = swings.shots
    assert list(table.hand) == ["right", "left"]
    assert list(table.clubs) == ["driver", "driver"]
    assert list(table.rows) == [1, 3]
    assert len(swings) == 2
    assert (table.speed_at, table.face_at, table.source) == ("cg", "face", str(tmp_path))
    assert [str(each) for each in table.notes] == ["a.c3d: of 1", "b.c3d: of -1"]
    assert not swings.interrupted


def test_missing_quantities_are_nan_beside_their_deviations(swings):
    np.testing.assert_array_equal(swings.shots.launches["ball_speed"], [60.0, np.nan])
    assert list(swings.shots.launches) == ["ball_speed"]
    np.testing.assert_array_equal(swings.uncertainty.launches["ball_speed"], [0.25, np.nan])
    for place, name in enumerate(QUANTITIES):
        np.testing.assert_array_equal(swings.shots.deliveries[name], [place, place])
        np.testing.assert_array_equal(swings.uncertainty.deliveries[name], [0.5, 0.5])


def test_a_table_of_no_swing_is_refused():
    with pytest.raises(InputError, match="at least one swing"):
        _ = CapturedSwings(captured=(), places=(), rejected=()).shots
