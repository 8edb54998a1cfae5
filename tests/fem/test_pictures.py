"""Pictures of finite element impacts: what they show is what was computed, with the published numbers beside it."""

import numpy as np
import pytest

from fem_runs import coarse_drive, coarse_shells, coarse_throw

pytest.importorskip("matplotlib")

from clubface.errors import InputError
from clubface.fem.paper import PUBLISHED
from clubface.fem.pictures import contacts, models_figure, paper_figure, sweep_figure
from clubface.fem.section_picture import section_figure


@pytest.mark.parametrize("run", [coarse_throw, coarse_drive, coarse_shells])
def test_the_nodes_of_the_patch_add_up_to_what_the_contact_tells(run):
    found = run()
    patch, contact = found.patch, found.contact
    # Records tell what the step before them did; the last may fall between steps that touch and that do not.
    times = np.unique(patch["time"])[:-2]
    steps = np.searchsorted(contact["time"], times + 1e-12) - 1
    assert len(times) > 50
    for time, step in zip(times, steps, strict=True):
        at, near = patch["time"] == time, slice(max(step - 1, 0), step + 2)
        # Rounding of a hundred summands.
        assert abs(contact["area"][near] - patch["area"][at].sum()).min() < 1e-12
        assert abs(contact["tangential"][near] - patch["tangential"][at].sum()).min() < 1e-9 * found.peak_force


def test_the_section_shows_pressure_and_shear_of_the_nodes_near_it():
    found = coarse_throw()
    figure = section_figure(found, count=2)
    below = [axes for axes in figure.axes if len(axes.lines) == 3]
    assert below
    _, pressure, shear = below[0].lines
    assert [pressure.get_label(), shear.get_label()] == ["pressure", "shear"]
    patch = found.patch
    times = np.unique(patch["time"])
    shown = found.frame_times[np.argmin(abs(found.frame_times - found.contact_time / 3))]
    near = times[np.argmin(abs(times - shown))]
    middle = (patch["time"] == near) & (abs(patch["toe"]) < 1e-4)
    assert middle.sum() > 2
    for curve, key in ((pressure, "normal"), (shear, "tangential")):
        per_area = patch[key][middle] / patch["area"][middle] * 1e-6
        assert np.isin(np.round(per_area, 9), np.round(curve.get_xdata(), 9)).all()


def test_a_sweep_is_marked_with_what_p2_tells():
    keys = ("ball_speed_mps", "launch_deg", "spin_rpm", "f")
    rows = [{"speed_mps": speed, "loft_deg": 11.5, **dict.fromkeys(keys, speed)} for speed in (30.0, 60.0)]
    marked = [axes.lines[1] for axes in sweep_figure(rows, published=True).axes]
    assert [mark.get_xydata().tolist() for mark in marked] == [
        [[35.0, PUBLISHED["section_spin_rpm" if key == "spin_rpm" else key]]] for key in keys
    ]
    assert all(len(axes.lines) == 1 for axes in sweep_figure(rows).axes)


def test_the_figures_of_the_paper_are_drawn_for_both_methods_of_contact():
    found = coarse_drive()
    figure = paper_figure({"penalty": found, "augmented-lagrange": coarse_shells()})
    panels = {panel.get_title(loc="left").replace("\n", " "): panel for panel in figure.axes}
    ball, club, others_ball, _, mark = panels["speed (m/s)"].lines
    for line, velocity in ((ball, found.world_velocity()), (club, found.world_club_velocity())):
        assert line.get_ydata() == pytest.approx(np.linalg.norm(velocity, axis=1))
    assert ball.get_linestyle() != others_ball.get_linestyle()
    assert mark.get_ydata().tolist() == [50.4, 24.0]
    launch = panels["launch angle (deg)"].lines[0].get_ydata()
    # The velocity of the last record and that of the launch, some steps later, as the ball flies.
    assert launch[-1] == pytest.approx(found.launch.get("launch", "deg"), abs=1e-3)


def test_the_contact_models_strike_as_the_finite_elements_do():
    found = coarse_drive()
    figure = models_figure(found)
    normal, tangential, sliding, radius = figure.axes
    assert [line.get_label() for line in normal.lines] == ["volumetric", "rings", "area", "fem"]
    over = contacts(found)
    for panel in (normal, tangential):
        assert max(panel.lines[3].get_ydata()) > 0.0
    for index, model in enumerate(over.values()):
        assert max(normal.lines[index].get_ydata()) == pytest.approx(model.normal_force.max() / 1e3)
        # All meet with V sin(loft) along the face, and friction at first makes backspin.
        assert sliding.lines[index].get_ydata()[0] == pytest.approx(found.relative_velocity()[0, 1], abs=1e-9)
        assert tangential.lines[index].get_ydata()[3] > 0.0
        launch = model.launch
        apart = [launch.get(f"velocity_{axis}") - launch.get(f"club_velocity_{axis}") for axis in "xyz"]
        up = found.attitude @ found.axes[1]
        assert sliding.lines[index].get_ydata()[-1] == pytest.approx(apart @ up, abs=0.01)
        assert tangential.lines[index].get_ydata() == pytest.approx(-model.force_y)
        assert min(radius.lines[index].get_ydata()) == pytest.approx(21.4 - 1e3 * model.penetration.max(), abs=1e-2)
    with pytest.raises(InputError, match="a plane"):
        contacts(coarse_throw())
