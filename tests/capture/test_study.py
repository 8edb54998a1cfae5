"""The study of the estimators: what it counts, and in full what the page on motion capture claims."""

import numpy as np
import pytest

pytest.importorskip("ezc3d")

from clubface.capture.reduction import QUANTITIES
from clubface.capture.study import DRAWN, UNITS, study, study_picture
from clubface.capture.synthetic.laboratory import Cameras
from clubface.errors import FileError, InputError, UnknownNameError


def test_a_study_counts_what_it_says():
    result = study(6, cameras=Cameras(noise=3e-4), estimators=("smoother", "linear"))
    assert len(result) == 6
    errors = result.errors["smoother"]
    column = QUANTITIES.index("loft")
    assert result.bias("smoother")["loft"] == pytest.approx(np.degrees(errors[:, column].mean()))
    assert result.spread("smoother")["toe"] == pytest.approx(1e3 * errors[:, QUANTITIES.index("toe")].std(ddof=1))
    inside = np.abs(errors[:, column]) < 1.959964 * result.deviations["smoother"][:, column]
    assert result.coverage("smoother")["loft"] == inside.mean()
    # A head of 50 m/s with a path known to 0.3 mm meets the ball within some 10 us of the truth.
    assert np.abs(result.touches["smoother"]).max() < 40e-6
    again = study(6, cameras=Cameras(noise=3e-4), estimators=("smoother",))
    assert np.array_equal(again.errors["smoother"], errors)
    assert UNITS["speed"] == "m/s"


def test_a_study_refuses_what_it_cannot_do():
    with pytest.raises(UnknownNameError, match="estimator"):
        study(2, estimators=("spline",))
    with pytest.raises(InputError, match="count"):
        study(0)


def test_the_picture_shows_every_estimator_of_every_study():
    result = study(4, cameras=Cameras(noise=3e-4))
    panels = study_picture({"noise": result, "again": result}).panels()
    assert len(panels) == len(DRAWN)
    marks = [mark for mark in panels[0].marks if mark.kind == "points"]
    assert len(marks) == 2 * len(result.errors)
    assert marks[0].x[0] == pytest.approx(result.bias("smoother")["speed"])


def test_errors_of_a_delivery_become_those_of_its_launch():
    import clubface

    result = study(3, cameras=Cameras(noise=3e-4), estimators=("linear",))
    off = result.launch_errors("linear", model="slip")
    for row in range(3):
        true, seen = (
            clubface.impact("driver", dict(zip(QUANTITIES, values[row], strict=True)), model="slip")
            for values in (result.truth, result.truth + result.errors["linear"])
        )
        assert off["sidespin"][row] == pytest.approx(float(seen.sidespin - true.sidespin), rel=1e-12)


@pytest.mark.study
@pytest.mark.parametrize("club", ["driver", "7-iron"])
def test_without_noise_no_swing_of_two_hundred_is_off(club):
    result = study(200, club=club, cameras=Cameras(), estimators=("smoother", "linear"))
    worst = result.worst("smoother")
    assert worst["speed"] < 5e-4 * 40.0
    for name in ("attack", "path", "loft", "face", "lie"):
        assert worst[name] < 0.05
    assert max(worst["toe"], worst["high"]) < 0.3
    # The published extrapolation is ten times as far off in what matters.
    assert result.worst("linear")["speed"] > 10 * worst["speed"]
    assert result.worst("linear")["high"] > 10 * worst["high"]


@pytest.mark.study
@pytest.mark.parametrize(("club", "hand"), [("driver", "right"), ("7-iron", "left")])
def test_intervals_of_95_percent_cover_the_truth_at_that_rate(club, hand):
    # Other swings than those by which the roughness was chosen, which had seed 1. 400 intervals scatter by 1.1%.
    result = study(400, club=club, hand=hand, cameras=Cameras(noise=3e-4), estimators=("smoother",), seed=2)
    for name, rate in result.coverage("smoother").items():
        assert 0.915 <= rate <= 0.98, name


def test_an_interrupted_study_goes_on_to_the_same_figures(tmp_path):
    folder, options = tmp_path / "kept", {"cameras": Cameras(noise=3e-4), "estimators": ["linear"]}

    def stop(done, whole):
        if done == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt, match=r"2 of 4 swings are (read|done); they are in .*kept"):
        study(4, checkpoint=folder, progress=stop, **options)
    with pytest.raises(FileError, match="begun with another seed"):
        study(4, checkpoint=folder, seed=2, **options)
    result = study(4, checkpoint=folder, **options)
    assert result.to_result().to_dict() == study(4, **options).to_result().to_dict()
    assert not folder.exists()
