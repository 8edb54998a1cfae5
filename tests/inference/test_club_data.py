"""Measured club data in the inference: it narrows what it measures, and absurd data is told."""

import re
from dataclasses import replace

import numpy as np
import pytest

import clubface
from clubface import infer, units
from clubface.errors import InputError
from clubface.inference import file as files
from clubface.inference.run import CLUB_NOISE, NOISE, Inference
from clubface.shots import refer
from clubface.shots.measured import QUANTITIES
from clubface.shots.recorded import RecordedShots
from clubface.shots.reference_points import as_seen
from deliveries import table as rows_of

DEG = np.pi / 180
MEASURED = ("speed", "attack", "path", "face")


def truth(prepared, count, seed):
    """Deliveries drawn from the prior, their launches and club data as a monitor shows them."""
    random = np.random.default_rng(seed)
    deliveries = prepared.prior.deliveries(random.standard_normal((count, len(prepared.prior.names))))
    launch = clubface.impact(prepared.club, deliveries, model=prepared.model)
    seen = {name: getattr(launch, name) + NOISE[name] * random.standard_normal(count) for name in QUANTITIES}
    club = {name: deliveries[name] + CLUB_NOISE[name] * random.standard_normal(count) for name in MEASURED}
    return deliveries, seen, club


def shot(columns, place):
    return {name: float(values[place]) for name, values in columns.items()}


@pytest.mark.parametrize(("club", "prior"), [("driver", "elite"), ("pitching-wedge", "wide")])
def test_the_truth_has_any_rank_among_the_draws_with_the_same_probability(club, prior):
    # Simulation-based calibration (Talts and others, 2018), with club data and the default model. The wedge's posterior
    # bends most: its spin hardly changes where the ball slides, and does where it rolls.
    count, draws, bins = 120, 99, 4
    prepared = Inference(club=club, prior=prior, samples=draws)
    deliveries, seen, club_data = truth(prepared, count, seed=4)
    ranks = {name: [] for name in deliveries}
    remarked = 0
    for place in range(count):
        one = prepared.of(shot(seen, place), shot(club_data, place))
        remarked += bool(one.warnings)
        for name in one.names:
            ranks[name].append(int(np.sum(one.deliveries[name] < deliveries[name][place])))
    for name, each in ranks.items():
        counts = np.bincount(np.array(each) // 25, minlength=bins)
        chi2 = float(np.sum((counts - count / bins) ** 2) / (count / bins))
        # 21.1: the 0.9999 quantile of chi-squared for 3 degrees of freedom; eleven quantities and two clubs are tried.
        assert chi2 < 21.1, (name, counts)
    # A remark is made of what one in a thousand shows; some twenty values a shot are looked at. Poisson: more than ten
    # of 2.4 expected have the probability 1e-4.
    assert remarked <= 10


def test_measured_club_data_narrows_what_it_measures():
    launch = {"ball_speed": "159 mph", "launch": "14.5 deg", "backspin": "2900 rpm", "azimuth": "0 deg"}
    alone = infer(launch, club="driver", prior="wide")
    one = infer(launch, club="driver", prior="wide", delivery={"attack": "2 deg"})
    # Independent information adds up: the precisions of launch and prior together, and of the monitor's 1 deg. Of 2000
    # draws, deviations are known to 1.6 %, and the launch is not quite linear.
    known = alone.deviation["attack"]
    both = 1.0 / (1.0 / known**2 + 1.0 / DEG**2)
    assert one.deviation["attack"] == pytest.approx(np.sqrt(both), rel=0.08)
    assert one.mean["attack"] == pytest.approx(both * (alone.mean["attack"] / known**2 + 2 / DEG), abs=0.25 * DEG)
    # Attack and loft are tied by the launch, so that the loft is known better as well.
    assert one.deviation["loft"] < 0.9 * alone.deviation["loft"]
    # A monitor that hardly knows tells nothing: three standard errors of deviations of 2000 draws each.
    vague = infer(
        launch, club="driver", prior="wide", delivery={"attack": "2 deg"}, delivery_noise={"attack": "100 deg"}
    )
    assert vague.deviation["attack"] == pytest.approx(alone.deviation["attack"], rel=0.07)


def test_a_planted_absurd_attack_angle_is_remarked_and_an_ordinary_one_is_not():
    launch = shot(truth(Inference(club="9-iron"), 1, seed=2)[1], 0)
    ordinary = infer(launch, club="9-iron", delivery={"attack": "-4.5 deg"})
    assert ordinary.warnings == []
    absurd = infer(launch, club="9-iron", delivery={"attack": "10 deg"})
    remarks = {each.code: each.data for each in absurd.warnings}
    assert any(each.startswith("attack -4.7 deg") for each in remarks["contradicts-prior"]["expected"])
    assert any(each.startswith("attack 10 deg") for each in remarks["not-reproduced"]["quantities"])


def test_a_delivery_in_the_tail_of_the_prior_is_remarked():
    # Measured so well that the launch and the prior cannot pull it back.
    one = infer(
        {"launch": "19 deg"}, club="9-iron", delivery={"attack": "10 deg"}, delivery_noise={"attack": "0.1 deg"}
    )
    # 14.7 deg from a mean that is known to 1.84 deg.
    (far,) = (each.data["quantities"] for each in one.warnings if each.code == "far-from-prior")
    assert re.match(r"attack 9\.9\d deg is 8\.0 standard", far[0])


def test_inputs_missing_from_the_prior_are_taken_as_measured():
    prior = clubface.Prior(name="mine", mean={"speed": 50.0}, deviation={"speed": 3.0})
    still = infer({"ball_speed": 70.0}, club="driver", prior=prior, samples=100)
    heel = infer({"ball_speed": 70.0}, club="driver", prior=prior, samples=100, delivery={"toe": "-20 mm"})
    assert heel.known == {"toe": pytest.approx(-0.02)}
    # A strike off centre gives less ball speed, so that the same ball speed takes a faster club.
    assert heel.mean["speed"] > still.mean["speed"] + 3 * still.deviation["speed"] / np.sqrt(100)


@pytest.mark.parametrize("hand", [1, -1])
def test_moving_club_data_to_the_impact_point_reverses_refer(hand):
    head = replace(clubface.club("driver"), hand=hand)
    random = np.random.default_rng(0)
    deliveries = clubface.inference.prior.prior_of("elite", head).deliveries(random.standard_normal((20, 11)))
    shown = as_seen(deliveries, head, speed_at="face", face_at="contact")
    # A driver's face centre moves 1 to 3 deg more to the inside than its centre of gravity.
    assert np.abs(shown["path"] - deliveries["path"]).mean() > 1 * DEG
    recorded = RecordedShots(
        deliveries=shown, launches={}, rows=np.arange(20), source="x", format="clubface", speed_at="face",
        face_at="contact",
    )  # fmt: skip
    back = refer(recorded, head)
    for name, values in deliveries.items():
        assert back.deliveries[name] == pytest.approx(values, abs=1e-9), name


def recorded(deliveries, count=1, **points):
    launches = {"ball_speed": np.full(count, 71.0), "launch": np.full(count, 0.25), "azimuth": np.full(count, 0.0)}
    given = {name: np.full(count, value) for name, value in deliveries.items()}
    return RecordedShots(
        deliveries=given, launches=launches, rows=np.arange(2, count + 2), source="x", format="clubface", **points
    )


def inferred(shots, tmp_path, **options):
    files.infer_shots(shots, tmp_path / "out.csv", club="driver", model="slip", **options)
    return rows_of(tmp_path / "out.csv")


def test_a_face_angle_at_the_point_of_contact_is_less_telling_of_the_face_centre(tmp_path):
    """The face of a driver is curved: where it was struck is not known to a few millimetres, so its angle is not."""
    (centre,) = inferred(recorded({"face": 0.0}), tmp_path)
    (contact,) = inferred(recorded({"face": 0.0}, face_at="contact"), tmp_path)
    assert float(contact["face_std_deg"]) > 1.2 * float(centre["face_std_deg"])


def test_shots_of_a_left_hander_are_inferred_as_those_of_a_left_handed_club(tmp_path):
    shots = recorded({"face": 2 * DEG, "path": 2 * DEG}, count=2)
    shots = replace(shots, hand=np.array(["right", "left"], dtype=object))
    right, left = inferred(shots, tmp_path)
    alone = infer(
        {"ball_speed": 71.0, "launch": 0.25, "azimuth": 0.0}, delivery={"face": 2 * DEG, "path": 2 * DEG},
        club=clubface.club("driver").replace(hand="left"), model="slip", samples=400,
    )  # fmt: skip
    # Six digits are written.
    assert float(left["toe_mm"]) == pytest.approx(1e3 * alone.mean["toe"], rel=1e-5)
    assert left["toe_mm"] != right["toe_mm"]


def test_a_row_of_a_file_is_the_shot_alone_with_its_club_data(tmp_path):
    (row,) = inferred(recorded({"attack": 3 * DEG, "toe": np.nan}), tmp_path, samples=60)
    alone = infer(
        {"ball_speed": 71.0, "launch": 0.25, "azimuth": 0.0}, delivery={"attack": "3 deg"}, club="driver",
        model="slip", samples=60,
    )  # fmt: skip
    assert float(row["attack_deg"]) == pytest.approx(units.from_si(alone.mean["attack"], "deg"), rel=1e-5)


def test_the_command_uses_club_data_except_what_ignore_names(clubface_, write, tmp_path):
    source = str(write("club,ball_speed_mph,launch_deg,attack_deg\n9-iron,110,22,10\n9-iron,110,22,-5\n"))
    target = tmp_path / "out.csv"
    ran = clubface_("infer", source, "-o", str(target), "--samples", "100")
    assert "Measured club data counted as well: attack." in ran.out
    absurd, ordinary = rows_of(target)
    assert "attack" in absurd["remark"]
    assert ordinary["remark"] == ""
    ran = clubface_("infer", source, "-o", str(target), "--samples", "100", "--ignore", "attack")
    assert "club data" not in ran.out
    absurd, ordinary = rows_of(target)
    assert absurd["attack_deg"] == ordinary["attack_deg"]


def test_the_command_takes_club_data_of_one_launch(clubface_):
    ran = clubface_(
        "infer", "--club", "driver", "--ball-speed", "159 mph", "--speed", "108 mph", "--samples", "200", "--json",
        "--delivery-noise", "speed=0.5 mph",
    )  # fmt: skip
    measured = {row["quantity"]: row["value"] for row in ran.json["tables"]["measured"]["rows"]}
    assert measured["speed"] == pytest.approx(108 * 0.44704)
    deliveries = {row["quantity"]: row for row in ran.json["tables"]["deliveries"]["rows"]}
    assert deliveries["speed"]["std"] < 0.6 * 0.44704


@pytest.mark.parametrize(
    ("delivery", "noise", "words"),
    [
        ({"attak": 0.1}, {}, "did you mean attack"),
        ({"attack": "3 mm"}, {}, "attack"),
        ({"speed": -1.0}, {}, "positive"),
        ({"attack": 0.1}, {"attack": 0.0}, "delivery_noise attack.*cannot be sampled"),
    ],
)
def test_errors_of_users_name_the_value(delivery, noise, words):
    with pytest.raises(InputError, match=words):
        infer({"ball_speed": 70.0}, club="driver", delivery=delivery, delivery_noise=noise)
