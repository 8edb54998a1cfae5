"""Where a golfer's shots go: sampling against single shots, chunks, intervals and fresh shots."""

from unittest import mock

import numpy as np
import pytest

import clubface
from clubface import _core as core
from clubface.design import dispersion as module
from clubface.design.dispersion import FLOWN, LAUNCHED, ImpactSetup, Scale, ShotTally, dispersion, forward, shots_file
from clubface.design.golfer import golfer
from clubface.design.strokes import Hole
from clubface.equipment.clubs import club
from clubface.errors import InputError

COUNT = 2**12


@pytest.fixture(scope="module")
def drives():
    return dispersion("handicap-10-driver", count=COUNT, hole=Hole(length="400 yd"))


def test_moments_and_quantiles_are_those_of_the_shots_one_by_one(drives):
    """The histogram's bins are 2 cm, so that a quantile is right to a bin where shots lie close enough."""
    shots = golfer("handicap-10-driver").sample(COUNT)
    flight = clubface.fly(clubface.impact("driver", shots, on_error="nan"), on_error="nan")
    carry = flight.carry[np.isfinite(flight.carry)]
    assert drives.lost == COUNT - carry.size > 0
    assert drives.mean("carry") == pytest.approx(carry.mean(), rel=1e-12)
    assert drives.spread("carry") == pytest.approx(carry.std(), rel=1e-10)
    for share in (0.1, 0.5, 0.9):
        assert drives.quantile("carry", share) == pytest.approx(np.quantile(carry, share), abs=0.06)
    side = flight.side[np.isfinite(flight.carry)]
    ellipse = drives.tally.ellipse(0.5)
    assert ellipse.centre == pytest.approx([forward(carry, side).mean(), side.mean()], rel=1e-10)
    # An ellipse with half axes h turned by R has the shape of the covariance if R diag(h^2) R' is a multiple of it.
    cosine, sine = np.cos(ellipse.angle), np.sin(ellipse.angle)
    turned = np.array([[cosine, -sine], [sine, cosine]]) * ellipse.half_axes
    covariance, shape = np.cov([forward(carry, side), side], bias=True), turned @ turned.T
    assert shape / shape[0, 0] == pytest.approx(covariance / covariance[0, 0], rel=1e-8)


def test_the_shots_too_are_made_by_as_many_threads_as_are_given():
    """A worker of a study has one core of its own."""
    with (
        mock.patch.object(core, "quasi_random", wraps=core.quasi_random) as numbers,
        mock.patch.object(core, "golfer_deliveries", wraps=core.golfer_deliveries) as deliveries,
    ):
        dispersion("handicap-10-driver", count=64, threads=1)
    assert (numbers.call_args.args[-1], deliveries.call_args.args[-1]) == (1, 1)


def test_chunks_and_threads_change_no_count_and_no_strokes(drives, monkeypatch):
    monkeypatch.setattr(module, "CHUNK", 1000)
    again = dispersion("handicap-10-driver", count=COUNT, hole=Hole(length="400 yd"), threads=1)
    for name in drives.quantities:
        assert again.quantile(name, 0.3) == drives.quantile(name, 0.3)
        # Sums of chunks are sums in another order.
        assert again.mean(name) == pytest.approx(drives.mean(name), rel=1e-11)
    assert again.lies == drives.lies
    assert np.array_equal(again.points, drives.points)
    assert again.ellipse(0.9).half_axes == pytest.approx(drives.ellipse(0.9).half_axes, rel=1e-9)


@pytest.mark.parametrize("share", [0.5, 0.9])
def test_an_ellipse_and_an_interval_hold_their_share_of_fresh_shots(drives, share):
    """Of 4096 fresh shots; three standard errors of a share among independent ones are 0.023 and 0.014."""
    player = golfer("handicap-10-driver")
    fresh = ImpactSetup(club("driver"), drives.model)(player.sample(COUNT, seed=99))
    result = np.isfinite(fresh["carry"])
    carry, side = fresh["carry"][result], fresh["side"][result]
    least, most = (drives.quantile("carry", 0.5 + half * share) for half in (-0.5, 0.5))
    error = 3.0 * np.sqrt(share * (1.0 - share) / result.sum())
    assert np.mean((carry > least) & (carry < most)) == pytest.approx(share, abs=error)
    ellipse = drives.ellipse(share)
    away = np.stack([forward(carry, side), side], axis=1) - ellipse.centre
    turn = np.array([[np.cos(ellipse.angle), -np.sin(ellipse.angle)], [np.sin(ellipse.angle), np.cos(ellipse.angle)]])
    inside = (((away @ turn) / ellipse.half_axes) ** 2).sum(axis=1) < 1.0
    assert inside.mean() == pytest.approx(share, abs=error)


def test_the_ellipse_of_normal_landings_is_the_one_of_chi_square():
    """Half the axes are sigma sqrt(-2 ln(1 - share)), and the long one lies where it was laid."""
    scales = {name: FLOWN[name] for name in ("carry", "side")}
    tally = ShotTally(scales, {"carry": 200.0, "side": 0.0})
    draw = np.random.default_rng(3).standard_normal((2, 200_000)) * [[15.0], [6.0]]
    angle = 0.4
    ahead = 200.0 + np.cos(angle) * draw[0] - np.sin(angle) * draw[1]
    side = np.sin(angle) * draw[0] + np.cos(angle) * draw[1]
    tally.add({"carry": np.hypot(ahead, side), "side": side})
    made = dispersion("tour-driver", count=64)
    normal = module.Dispersion(**{**made.__dict__, "tally": tally})
    for share in (0.5, 0.9):
        result = normal.ellipse(share)
        # 200,000 shots give a spread to 0.16 %; twice that, and the share's own error.
        assert result.half_axes == pytest.approx(np.array([15.0, 6.0]) * np.sqrt(-2.0 * np.log1p(-share)), rel=0.01)
        assert result.angle == pytest.approx(angle, abs=0.005)


def test_quantiles_lie_evenly_within_a_bin():
    tally = ShotTally({"side": Scale(0.0, 10.0, 10)}, {"side": 0.0})
    tally.add({"side": np.array([2.5, 2.5, 2.5, 7.5])})
    assert tally.quantile("side", 0.375) == pytest.approx(2.5)
    assert tally.quantile("side", 0.75) == pytest.approx(3.0)
    edges, counts = tally.histogram("side", 1.0)
    assert counts.tolist() == [3, 0, 0, 0, 0, 1]
    assert edges[0] == 2.0


def test_a_left_hander_spreads_as_the_mirror_image():
    right = dispersion("tour-driver", count=512)
    left = dispersion("tour-driver", club("driver").replace(hand="left"), count=512)
    # Shot by shot, but for the rounding of the flight's integration.
    assert left.mean("carry") == pytest.approx(right.mean("carry"), rel=1e-9)
    assert left.mean("side") == pytest.approx(-right.mean("side"), abs=1e-6)
    assert left.golfer.hand == -1


def test_without_flight_launches_alone_are_counted():
    result = dispersion("tour-driver", count=256, flight=False)
    assert set(result.quantities) == set(LAUNCHED)
    with pytest.raises(InputError, match="share is"):
        result.ellipse(0.5)
    with pytest.raises(InputError, match="do not fly"):
        dispersion("tour-driver", flight=False, hole=Hole(length="400 yd"))
    with pytest.raises(InputError, match="do not fly"):
        dispersion("tour-driver", flight=False, wind=(5.0, 0.0, 0.0))


@pytest.mark.parametrize("share", ["x", 0.0, 1.0, np.nan, [0.1, 0.5]])
def test_an_invalid_share_is_refused(share):
    result = dispersion("tour-driver", count=64)
    for ask in (result.ellipse, lambda each: result.quantile("carry", each)):
        with pytest.raises(InputError, match="share"):
            ask(share)


def test_a_length_alone_is_no_hole():
    with pytest.raises(InputError, match="Hole"):
        dispersion("tour-driver", count=64, hole="430 yd")  # pyright: ignore[reportArgumentType]


def test_any_model_and_any_air_will_do():
    thick = dispersion("tour-7-iron", count=128, model="standard", air={"temperature": "5 degC"})
    thin = dispersion("tour-7-iron", count=128, model="standard", air={"temperature": "35 degC"})
    assert thin.mean("carry") > thick.mean("carry")


def test_every_shot_is_written_with_its_units(tmp_path):
    pandas = pytest.importorskip("pandas")
    for name in ("shots.csv", "shots.parquet"):
        with shots_file(tmp_path / name) as each:
            result = dispersion("handicap-10-driver", count=300, each=each)
        table = pandas.read_csv(tmp_path / name) if name.endswith("csv") else pandas.read_parquet(tmp_path / name)
        assert len(table) == 300
        assert table["carry_m"].isna().sum() == result.lost
        assert table["carry_m"].mean() == pytest.approx(result.mean("carry"), rel=1e-8)
        assert table["club_speed_mph"].mean() == pytest.approx(95.0, rel=1e-2)


def test_a_file_is_not_there_if_the_work_fails(tmp_path):
    def fail():
        with shots_file(tmp_path / "shots.csv") as each:
            each({"speed": np.ones(3)}, {})
            raise RuntimeError

    with pytest.raises(RuntimeError):
        fail()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.study
def test_a_million_shots_need_no_more_memory_than_a_hundred_thousand():
    import subprocess
    import sys

    code = (
        "import resource, sys; from clubface.design.dispersion import dispersion;"
        "dispersion('bogey-driver', count=int(sys.argv[1]));"
        "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)"
    )
    used = [
        int(subprocess.run([sys.executable, "-W", "ignore", "-c", code, count], capture_output=True, check=True).stdout)
        for count in ("131072", "1048576")
    ]
    assert used[1] < used[0] + 20_000  # kB


DEGREE, RPM = np.pi / 180.0, np.pi / 30.0
COUNTED = {
    # From where, to where, the width of a bin: a fifteenth of what monitors tell of speed and angles, 1 rpm, 2 cm.
    "ball_speed": (0.0, 125.0, 0.005), "launch": (-90 * DEGREE, 90 * DEGREE, 0.005 * DEGREE),
    "azimuth": (-90 * DEGREE, 90 * DEGREE, 0.005 * DEGREE), "backspin": (-1500.0, 1500.0, 0.1),
    "sidespin": (-1500.0, 1500.0, 0.1), "carry": (0.0, 500.0, 0.02), "side": (-250.0, 250.0, 0.02),
    "total": (0.0, 500.0, 0.02), "total_side": (-250.0, 250.0, 0.02),
}  # fmt: skip


def test_histograms_have_the_stated_resolution_and_reach_beyond_every_shot():
    scales = {**LAUNCHED, **FLOWN}
    assert set(scales) == set(COUNTED)
    for name, (least, most, width) in COUNTED.items():
        assert (scales[name].least, scales[name].most) == pytest.approx((least, most), rel=1e-15)
        assert (most - least) / scales[name].bins == pytest.approx(width, rel=1e-12)
    # No ball that was ever measured left with 220 mph, flew 500 yards or spun with 12,000 rpm.
    assert LAUNCHED["ball_speed"].most > 220 * 0.44704
    assert FLOWN["carry"].most > 500 * 0.9144
    assert LAUNCHED["backspin"].most > 12_000 * RPM


@pytest.mark.parametrize("name", [name for name in COUNTED if name != "carry"])  # which is never without a side
def test_a_shot_is_counted_where_it_is_and_beyond_the_ends_in_the_last_bin(name):
    player = {**LAUNCHED, **FLOWN}[name]
    least, most, width = COUNTED[name]
    tally = ShotTally({name: player}, {name: 0.5 * (least + most)})
    values = np.array([least + 1.5 * width, least + 1.5 * width, most - 0.5 * width])
    tally.add({name: values})
    edges, counts = tally.histogram(name, width)
    assert edges[0] == pytest.approx(least + width, rel=1e-9, abs=1e-9)
    assert counts[0] == 2
    assert counts[-1] == 1
    assert tally.quantile(name, 1.0 / 3.0) == pytest.approx(least + 1.5 * width, abs=1e-9)
    assert tally.mean(name) == pytest.approx(values.mean(), abs=1e-9)
    assert tally.spread(name) == pytest.approx(values.std(), rel=1e-12)
    beyond = ShotTally({name: player}, {name: 0.0})
    beyond.add({name: np.array([least - 1.0, most + 1.0, np.nan])})
    edges, counts = beyond.histogram(name, width)
    assert (counts[0], counts[-1], counts.sum()) == (1, 1, 2)
    assert (edges[0], edges[-1]) == pytest.approx((least, most))
    assert (beyond.shots, beyond.lost) == (3, 1)
