"""Pictures: what they show, in which units, and that nothing covers anything."""

import numpy as np
import pytest

import clubface
from clubface.errors import InputError

pytest.importorskip("matplotlib")

from clubface import plots
from clubface.present.drawing import draw
from clubface.present.style import look, marker
from clubface.simulation.flight import trajectory
from clubface.validation import tour
from clubface.validation.tour import error_picture, launch_picture
from synthetic_shots import recorded

SHOT = {"speed": "113 mph", "attack": "-1.3 deg", "loft": "12.8 deg", "toe": "8 mm"}


@pytest.fixture(scope="module")
def flights():
    models = ("standard", "volumetric", "area")
    return {name: trajectory(clubface.impact("driver", SHOT, model=name)).position for name in models}


@pytest.fixture(scope="module")
def histories():
    return {name: clubface.history("driver", SHOT, model=name) for name in ("volumetric", "area")}


@pytest.fixture(scope="module")
def averages():
    return tour.tour(["standard", "area"], table="pga-2019")


@pytest.fixture(scope="module")
def identified():
    pytest.importorskip("pymoo")
    # Five free parameters, of which two are not identified alone: a row and a part of one.
    return clubface.identify(
        recorded(20, "area", noise=1.0), club="driver", model="area", population=8, generations=2, refined=1, folds=0,
        bootstrap=8, bounds={"area_damping": (0.0, 10.0)}, profiles=["damping", "friction", "poisson"],
    )  # fmt: skip


def laid_out(figure):
    """Panels and legend of a drawn figure as boxes in pixels."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return [axes.get_tightbbox() for axes in figure.axes], figure.legends[0].get_window_extent()


def assert_nothing_overlaps(figure):
    boxes, legend = laid_out(figure)
    for box in boxes:
        assert not box.overlaps(legend)
        assert figure.bbox.padded(1.0).containsx(box.x0)
        assert figure.bbox.padded(1.0).containsx(box.x1)
    for index, box in enumerate(boxes):
        # A pixel of touching is rounding.
        assert not any(box.padded(-1.0).overlaps(other.padded(-1.0)) for other in boxes[:index])


def lines(axes):
    """The curves of a panel, without the lines that mark zero."""
    return [line for line in axes.lines if len(line.get_xdata()) > 2]


def test_a_shot_shows_forces_and_both_views(flights, histories):
    figure = plots.shot_figure(flights, histories, title="driver")
    assert [len(lines(axes)) for axes in figure.axes] == [2, 2, 2, 3, 3]
    assert_nothing_overlaps(figure)


def test_forces_are_in_kilonewtons_over_microseconds(histories):
    figure = plots.force_histories(histories)
    normal, along_y, along_z = figure.axes
    curve, history = lines(normal)[0], histories["volumetric"]
    assert max(curve.get_ydata()) == pytest.approx(history.normal_force.max() / 1e3, rel=1e-12)
    assert curve.get_xdata()[-1] == pytest.approx(history.time[-1] * 1e6, rel=1e-12)
    # Friction down the face is drawn upwards: it makes backspin.
    assert lines(along_y)[0].get_ydata()[10] == pytest.approx(-history.force_y[10] / 1e3, rel=1e-12)
    assert history.force_y[10] < 0.0 < history.launch.backspin
    assert lines(along_z)[0].get_ydata()[10] == pytest.approx(history.force_z[10] / 1e3, rel=1e-12)
    assert "(kN)" in normal.get_ylabel()
    assert "(µs)" in normal.get_xlabel()


def test_friction_to_the_side_is_drawn_where_there_is_some(histories):
    noise = {name: {"time": each.time, "normal_force": each.normal_force, "force_y": each.force_y,
                    "force_z": np.full(len(each.time), 5.0)} for name, each in histories.items()}  # fmt: skip
    assert len(plots.force_histories(histories).axes) == 3
    assert len(plots.force_histories(noise).axes) == 2


def test_models_without_a_history_are_left_out_of_the_forces_and_named(flights, histories):
    figure = plots.shot_figure(flights, histories)
    texts = [text.get_text() for text in figure.texts]
    assert any("standard" in text and "volumetric" not in text for text in texts)
    assert len(plots.shot_figure(flights).axes) == 2


def test_right_of_the_target_is_drawn_downwards_from_above(flights):
    above = plots.trajectories(flights).axes[-1]
    lower, upper = above.get_ylim()
    assert lower > upper
    assert lower >= max(position[:, 2].max() for position in flights.values())


def test_flights_are_drawn_to_scale_and_a_straight_shot_is_straight(flights):
    straight = {"standard": np.stack([np.linspace(0.0, 200.0, 9), 0.0 * np.arange(9), 0.3 * np.arange(9)], axis=1)}
    for axes in [*plots.trajectories(flights).axes, *plots.trajectories(straight).axes]:
        assert axes.get_aspect() == 1.0
    low, high = axes.get_ylim()  # from above, the straight shot: it ends 2.4 m right after 200 m
    assert abs(low - high) > 5.0 * 2.4


@pytest.mark.parametrize("height", [0.0, 0.3, 30.0, 300.0])
def test_flat_and_steep_flights_are_drawn(height):
    x = np.linspace(0.0, 100.0, 20)
    path = np.stack([x, height * (x / 50.0) * (2.0 - x / 50.0), 0.0 * x], axis=1)
    figure = plots.trajectories({"standard": path})
    assert_nothing_overlaps(figure)


def test_each_model_has_its_own_colour_and_dash_whatever_else_is_drawn(histories):
    alone = lines(plots.force_histories({"area": histories["area"]}).axes[0])[0]
    labelled = lines(plots.force_histories(histories).axes[0])[1]
    assert alone.get_color() == labelled.get_color()
    looks = [str(look(name)) for name in clubface.models()]
    assert len(set(looks)) == len(looks)


def test_finite_elements_look_like_no_other_model():
    """A drive by the default model and by finite elements, drawn together, had one colour and one dash."""
    from clubface.equipment.models import models

    names = [*models(), "fem"]
    for line in (look, marker):
        assert len({line(name)["color"] for name in names}) == len(names)
    assert len({str(marker(name)["marker"]) for name in names}) == len(names)
    for name in models():
        assert str(look(name)["linestyle"]) != str(look("fem")["linestyle"])


def test_errors_of_every_model_and_club_are_drawn_with_their_sign(averages):
    figure = draw(error_picture(averages))
    spin = figure.axes[4]
    drawn = sorted(value for line in spin.lines if line.get_marker() not in ("None", "") for value in line.get_ydata())
    expected = [error for name in averages.models for error in averages.errors(name)["spin"] * 30.0 / np.pi]
    assert drawn == pytest.approx(sorted(expected), rel=1e-12)
    assert_nothing_overlaps(figure)


def test_launches_stand_beside_what_was_published(averages):
    figure = draw(launch_picture(averages))
    published = figure.axes[0].lines[0]
    assert published.get_ydata()[0] == pytest.approx(167.0, rel=1e-12)
    assert_nothing_overlaps(figure)


def test_lofts_are_drawn_from_the_launch_angle_up(averages):
    possible, *solved, published = launch_picture(averages).rows[1][1].marks
    low, high = averages.possible_lofts
    launch = averages.published["launch"]
    assert possible.y0 == pytest.approx(low - launch)
    assert possible.y1 == pytest.approx(high - launch)
    for name, drawn in zip(averages.models, solved, strict=True):
        assert drawn.y == pytest.approx(averages.solved_lofts[name] - launch)
    assert np.degrees(published.y) == pytest.approx([12.8 - 10.9, 20.2 - 14.1])


def test_without_a_published_loft_there_is_no_row_of_launch_angles():
    assert len(draw(error_picture(tour.tour(["standard"]))).axes) == 6


def test_each_identified_parameter_has_its_interval_samples_and_profile(identified):
    (picture,) = identified.to_result().pictures()
    drawn = picture.panels()
    assert len(drawn) == len(identified.free) == 5
    assert drawn[0].x.heading == "shear modulus (MPa)"
    for panel, name in zip(drawn, identified.free, strict=True):
        marks = {mark.label: mark for mark in panel.marks}
        low, high = marks["95% interval"].x
        assert (low, high) == identified.intervals[name]
        assert marks["fit"].x[0] == identified.parameters.values[name]
        assert np.count_nonzero(marks["bootstrap"].y) <= len(identified.samples)
        left, right = panel.x.limits
        assert left < low
        assert right > high
    assert_nothing_overlaps(draw(picture))


def test_a_profile_passes_the_level_of_95_percent_where_its_interval_ends(identified):
    profile = identified.profiles["damping"]
    assert profile.closed == (True, True)
    panel = identified.to_result().pictures()[0].panels()[identified.free.index("damping")]
    (curve,) = (mark for mark in panel.marks if mark.label == "profile")
    rises = np.interp(profile.interval, curve.x, curve.y)
    # Straight pieces of a parabola between places: a sixteenth of a step squared.
    assert rises == pytest.approx(3.84146, rel=2e-3)


@pytest.mark.parametrize(("ending", "magic"), [(".png", b"\x89PNG"), (".pdf", b"%PDF"), (".svg", b"<?xml")])
def test_the_ending_decides_the_format_and_the_same_shot_gives_the_same_bytes(flights, tmp_path, ending, magic):
    first = plots.save(plots.trajectories(flights), tmp_path / f"a{ending}").read_bytes()
    second = plots.save(plots.trajectories(flights), tmp_path / f"b{ending}").read_bytes()
    assert first.startswith(magic)
    assert first == second


def test_another_ending_is_refused(flights, tmp_path):
    with pytest.raises(InputError, match=r"\.png, \.svg, \.pdf"):
        plots.save(plots.trajectories(flights), tmp_path / "a.doc")


def test_the_callers_settings_are_left_alone(flights):
    import matplotlib as mpl

    with mpl.rc_context({"font.size": 31.0}):
        plots.trajectories(flights)
        assert mpl.rcParams["font.size"] == 31.0
