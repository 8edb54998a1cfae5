"""Every example runs, and what it shows is true."""

import runpy
from pathlib import Path

import numpy as np
import pytest

from clubface.design import shells
from clubface.design.optimisation import study as optimisation_study
from clubface.errors import MeshWarning

EXAMPLES = Path(__file__).parent.parent / "examples"


def run(name, *arguments):
    return runpy.run_path(str(EXAMPLES / f"{name}.py"))["main"](*arguments)


def test_every_example_is_tested():
    tested = {name.removeprefix("test_the_").split("__")[0] for name in globals() if name.startswith("test_the_")}
    assert {path.stem for path in EXAMPLES.glob("*.py")} == tested


def test_the_first_shot__leaves_faster_than_the_club_came(capsys):
    shot = run("first_shot")
    # A driver at the rule limit of restitution gives a smash factor near 1.5; the two-layer ball stays a little below.
    assert 1.35 < shot.smash < 1.5
    assert "mph" in capsys.readouterr().out


def test_the_compare_models__agree_on_ball_speed_and_on_the_time_scale_of_contact():
    launches = run("compare_models")
    speeds = [shot.ball_speed for shot in launches.values()]
    # All sets were fitted to the same 7-iron shots, with mean errors of 2 to 3%: two may differ by twice that.
    assert max(speeds) / min(speeds) < 1.06
    times = [shot.contact_time for name, shot in launches.items() if not np.isnan(shot.contact_time)]
    # Measured impacts of golf balls last 0.4 to 0.5 ms at a driver's speed, a little longer at an iron's.
    assert len(times) == 4
    assert all(0.4e-3 < time < 0.6e-3 for time in times)


def test_the_gear_effect__spins_a_toe_shot_to_the_left_and_bulge_starts_it_to_the_right(tmp_path):
    pytest.importorskip("matplotlib").use("agg")
    shots = run("gear_effect", str(tmp_path / "face.png"))
    spin, toe = shots.sidespin[:, shots.shape[1] // 2], shots.varied["toe"].values[:, 0]
    assert np.all(spin[toe < -5e-3] > 0)
    assert np.all(spin[toe > 5e-3] < 0)
    assert np.all(np.diff(shots.azimuth, axis=0) > 0)
    assert (tmp_path / "face.png").stat().st_size > 0


def test_the_sensitivities__scatter_is_that_of_random_deliveries():
    import clubface

    scatter = run("sensitivities")
    random = np.random.default_rng(1)
    n = 20_000
    loft = np.radians(12.8 + 1.5 * random.normal(size=n))
    attack = np.radians(-1.3 + random.normal(size=n))
    speed = (113 + random.normal(size=n)) * 0.44704
    toe, face = 8e-3 * random.normal(size=n), np.radians(2 * random.normal(size=n))
    shots = clubface.impact("driver", model="volumetric", speed=speed, loft=loft, attack=attack, toe=toe, face=face)
    # Sampling leaves 1/sqrt(2 n) = 0.5%, three times that 1.5%; curvature, which derivatives do not know, the rest.
    assert np.std(shots.get("launch", "deg")) == pytest.approx(scatter["launch"], rel=0.03)
    assert np.std(shots.get("backspin", "rpm")) == pytest.approx(scatter["backspin"], rel=0.03)
    assert np.std(shots.get("sidespin", "rpm")) == pytest.approx(scatter["sidespin"], rel=0.03)


def test_the_left_hander__is_the_mirror_image_to_the_last_bit():
    right, left = run("left_hander")
    for name in ("ball_speed", "launch", "backspin", "velocity_x", "velocity_y", "spin_z"):
        assert getattr(left, name) == getattr(right, name)
    for name in ("azimuth", "sidespin", "spin_axis", "velocity_z", "spin_x", "spin_y"):
        assert getattr(left, name) == -getattr(right, name)


def test_the_flight_in_wind__a_headwind_costs_more_than_a_tailwind_gives():
    flights = run("flight_in_wind")
    still, head, tail = (flights[name].carry for name in ("still", "headwind", "tailwind"))
    assert head < still < tail
    assert still - head > tail - still
    assert flights["from the left"].side > 0
    assert flights["at 1600 m"].carry > still


def test_the_captured_swing__is_as_sure_of_the_launch_as_of_what_made_it(capsys):
    pytest.importorskip("ezc3d")
    launches = run("captured_swing")
    printed = capsys.readouterr().out
    stated = float(next(line for line in printed.splitlines() if line.startswith("club speed, mph")).split()[-1])
    # The ball leaves with about 1.45 times the speed of the head, and so does its uncertainty; loft and impact point,
    # which are uncertain as well, add to it or, hanging together with the speed, take from it.
    assert 0.8 * 1.45 * stated < np.std(launches.get("ball_speed", "mph")) < 1.6 * 1.45 * stated


def test_studies_of_shells_choose_among_their_metals():
    faster_face = shells.read(EXAMPLES / "faster_face.toml")
    assert [metal.name for metal in faster_face.metals] == ["Ti-6Al-4V", "high-strength titanium"]
    with pytest.warns(MeshWarning, match="inertia"):
        own_walls = shells.read(EXAMPLES / "own_walls.toml")
    assert [choice.name for choice in own_walls.choices] == ["face of Ti-6Al-4V", "face of maraging steel"]


def test_a_better_driver_is_sought_over_distributions_of_mass():
    assert optimisation_study.read(EXAMPLES / "better_driver.toml").distributed


@pytest.mark.parametrize(
    ("name", "page", "comment"),
    [
        ("better_driver", "optimisation", 2), ("fitting", "optimisation", 3), ("lofts", "studies", 3),
        ("faster_face", "finite-elements/design", 2), ("own_walls", "finite-elements/design", 2),
    ],
)  # fmt: skip
def test_a_page_shows_the_example_without_its_first_comment(name, page, comment):
    lines = (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8").splitlines(keepends=True)
    assert "".join(lines[comment:]) in (EXAMPLES.parent / "docs" / f"{page}.md").read_text(encoding="utf-8")
