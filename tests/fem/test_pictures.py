"""Pictures of finite element impacts: what they show is what was computed, with the published numbers beside it."""

import numpy as np
import pytest

from clubface.errors import InputError
from clubface.fem.paper import PUBLISHED
from clubface.fem.pictures import contacts, models_picture, paper_picture, sweep_picture
from clubface.fem.section_picture import moving_section, section_picture
from fem_runs import coarse_drive, coarse_shells, coarse_throw


def lines(panel, label=""):
    return [mark for mark in panel.marks if mark.kind == "line" and mark.label.startswith(label)]


@pytest.mark.parametrize("run", [coarse_throw, coarse_drive, coarse_shells])
def test_the_nodes_of_the_patch_add_up_to_the_contact(run):
    result = run()
    patch, contact = result.patch, result.contact
    # Records tell what the step before them did; the last may fall between steps that touch and that do not.
    times = np.unique(patch["time"])[:-2]
    steps = np.searchsorted(contact["time"], times + 1e-12) - 1
    assert len(times) > 50
    for time, step in zip(times, steps, strict=True):
        at, near = patch["time"] == time, slice(max(step - 1, 0), step + 2)
        # Rounding of a hundred summands.
        assert abs(contact["area"][near] - patch["area"][at].sum()).min() < 1e-12
        assert abs(contact["tangential"][near] - patch["tangential"][at].sum()).min() < 1e-9 * result.peak_force


def test_the_section_shows_pressure_and_shear_of_the_nodes_near_it():
    result = coarse_throw()
    below = section_picture(result, count=2).rows[1][0]
    patch = result.patch
    times = np.unique(patch["time"])
    shown = result.frame_times[np.argmin(abs(result.frame_times - result.contact_time / 3))]
    near = times[np.argmin(abs(times - shown))]
    middle = (patch["time"] == near) & (abs(patch["toe"]) < 1e-4)
    assert middle.sum() > 2
    for label, key in (("pressure", "normal"), ("shear", "tangential")):
        (curve,) = (mark for mark in below.marks if mark.label == label)
        assert np.isin(patch[key][middle] / patch["area"][middle], curve.x).all()


def test_a_moving_section_has_the_forces_up_to_each_moment():
    result = coarse_shells()
    moving = moving_section(result)
    assert len(moving) == len(result.frame_times)
    for picture, time in zip(moving, result.frame_times, strict=True):
        assert max(lines(picture.rows[0][1], "normal")[0].x, default=0.0) <= time


def test_a_sweep_is_marked_with_the_published_numbers():
    keys = ("ball_speed_mps", "launch_deg", "spin_rpm", "f")
    rows = [{"speed_mps": speed, "loft_deg": 11.5, **dict.fromkeys(keys, speed)} for speed in (30.0, 60.0)]
    sizes = {"ball_speed_mps": 1.0, "launch_deg": np.pi / 180.0, "spin_rpm": np.pi / 30.0, "f": 1.0}
    panels = sweep_picture(rows, published=True).panels()
    for panel, key in zip(panels, keys, strict=True):
        (mark,) = (each for each in panel.marks if each.label == "Roh and Lee")
        published = PUBLISHED["section_spin_rpm" if key == "spin_rpm" else key]
        assert (mark.x, mark.y) == ([35.0], pytest.approx([published * sizes[key]]))
        assert lines(panel)[0].y == pytest.approx([30.0 * sizes[key], 60.0 * sizes[key]])
    assert not [mark for panel in sweep_picture(rows).panels() for mark in panel.marks if mark.label == "Roh and Lee"]


def test_the_figures_of_the_paper_are_drawn_for_both_methods_of_contact():
    result = coarse_drive()
    speed, launch, *_ = paper_picture({"penalty": result, "augmented-lagrange": coarse_shells()}).panels()
    for what, velocity in (("ball", result.world_velocity()), ("clubhead", result.world_club_velocity())):
        one, other = lines(speed, what)
        assert one.y == pytest.approx(np.linalg.norm(velocity, axis=1))
        assert one.dash != other.dash
    (mark,) = (each for each in speed.marks if each.kind == "points")
    assert mark.y == [50.4, 24.0]
    # The velocity of the last record and that of the launch, some steps later, as the ball flies.
    assert lines(launch)[0].y[-1] == pytest.approx(result.launch.launch, abs=2e-5)


def test_the_contact_models_strike_as_the_finite_elements_do():
    result = coarse_drive()
    normal, tangential, sliding, radius = models_picture(result).panels()
    assert [line.label for line in lines(normal)] == ["fem", "volumetric", "rings", "area"]
    for panel in (normal, tangential):
        assert max(lines(panel)[0].y) > 0.0
    for name, model in contacts(result).items():
        force, along, slip, distance = (lines(panel, name)[0].y for panel in (normal, tangential, sliding, radius))
        assert max(force) == pytest.approx(model.normal_force.max())
        # All meet with V sin(loft) along the face, and friction at first makes backspin.
        assert slip[0] == pytest.approx(result.relative_velocity()[0, 1], abs=1e-9)
        assert along[3] > 0.0
        launch = model.launch
        apart = [launch.get(f"velocity_{axis}") - launch.get(f"club_velocity_{axis}") for axis in "xyz"]
        assert slip[-1] == pytest.approx(apart @ (result.attitude @ result.axes[1]), abs=0.01)
        assert along == pytest.approx(-model.force_y)
        assert min(distance) == pytest.approx(21.4e-3 - model.penetration.max(), abs=1e-5)
    with pytest.raises(InputError, match="a plane"):
        contacts(coarse_throw())
