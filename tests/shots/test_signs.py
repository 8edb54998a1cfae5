"""A column whose sign is turned is suspected; one that is right is not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from attached_notes import codes
from clubface import shots as launch_monitor
from clubface.shots.recorded import RecordedShots
from clubface.shots.signs import FEWEST, suspected_signs
from clubface.validation.benchmark_data import load

DEG = np.pi / 180


def some(club, shots=30, seed=1):
    """Some of the benchmark shots, which have the scatter of golfers and the noise of a monitor."""
    pytest.importorskip("pyarrow")
    every = load(club).measured
    return every.select(np.random.default_rng(seed).permutation(len(every))[:shots])


def turned(shots, *names):
    return replace(
        shots,
        deliveries={name: -each if name in names else each for name, each in shots.deliveries.items()},
        launches={name: -each if name in names else each for name, each in shots.launches.items()},
    )


@pytest.mark.parametrize("club", ["driver", "7-iron"])
@pytest.mark.parametrize("seed", range(5))
def test_shots_with_the_right_signs_are_not_suspected(club, seed):
    assert suspected_signs(some(club, 120, seed)) == ()
    assert suspected_signs(some(club, 15, seed)) == ()


@pytest.mark.parametrize("club", ["driver", "7-iron"])
@pytest.mark.parametrize("name", ["attack", "loft", "face", "path"])
def test_a_delivery_column_of_the_wrong_sign_is_reported(club, name):
    notes = suspected_signs(turned(some(club), name))
    assert [each.data["quantity"] for each in notes] == [name]


def test_a_launch_column_of_the_wrong_sign_is_reported_if_all_others_contradict_it():
    turned_azimuth = suspected_signs(turned(some("7-iron"), "azimuth"))
    assert turned_azimuth == (("sign-turned", {"quantity": "azimuth", "others": ["face", "path"]}),)
    # Thirty drives do not tell it of the toe, so that face and path are suspected as much as the axis.
    notes = suspected_signs(turned(some("driver", 30), "sidespin", "spin_axis"))
    assert notes
    assert all(each.code == "sign-one-turned" and each.data["others"] == ["spin_axis"] for each in notes)


def test_a_left_hander_is_the_mirror_image():
    shots = some("7-iron", 120)  # so many that the gear effect shows, which tells left from right
    mirrored = turned(shots, "path", "face", "azimuth", "sidespin", "spin_axis")
    left = replace(mirrored, hand=np.array(["left"] * len(shots), dtype=object))
    assert suspected_signs(left) == ()
    assert suspected_signs(turned(left, "face"))[0].data["quantity"] == "face"


def test_clubs_are_compared_within_themselves():
    """Of a bag, wedges are hit further down and fly higher, which says nothing of the sign."""
    parts = {club: some(club, 20) for club in ("driver", "7-iron")}
    names = ("attack", "loft")
    bag = RecordedShots(
        deliveries={name: np.concatenate([each.deliveries[name] for each in parts.values()]) for name in names},
        launches={"launch": np.concatenate([each.launches["launch"] for each in parts.values()])},
        clubs=np.repeat(np.array(["Dr", "7i"], dtype=object), 20),
        rows=np.arange(40),
        source="bag.csv",
        format="clubface",
    )
    attack_alone = replace(bag, deliveries={"attack": bag.deliveries["attack"]})
    assert suspected_signs(bag) == suspected_signs(attack_alone) == ()
    assert np.corrcoef(bag.deliveries["attack"], bag.launches["launch"])[0, 1] < 0.0  # across the bag, that is


def test_few_shots_and_columns_that_never_change_say_nothing():
    shots = turned(some("driver", FEWEST), "attack")
    assert suspected_signs(shots) == ()
    still = turned(some("driver"), "attack")
    still.deliveries["attack"][:] = 0.02
    assert suspected_signs(still) == ()
    assert suspected_signs(replace(still, deliveries={}, launches={"launch": still.launches["launch"]})) == ()


def test_even_a_few_irons_hit_upwards_are_reported(write):
    """Five shots are too few for slopes."""
    rows = "".join(f"{club},85,{attack}\n" for club, attack in zip(["7i"] * 5, (4, 4.5, 3, 5, 4), strict=True))
    shots = launch_monitor.read(write("club,club_speed_mph,attack_deg\n" + rows))
    assert shots.notes[-1] == ("irons-hit-upwards", {"attack": pytest.approx(np.radians(4.0))})
    down = launch_monitor.read(write("club,club_speed_mph,attack_deg\n" + rows.replace(",85,", ",85,-")))
    driver = launch_monitor.read(write("club,club_speed_mph,attack_deg\n" + rows.replace("7i", "Dr")))
    assert "irons-hit-upwards" not in codes(down) | codes(driver)
