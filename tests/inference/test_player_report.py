"""The report for a player: every number is one of the file or of a model, sides and doubts are in words, one file."""

import base64
import dataclasses
import re
from html.parser import HTMLParser

import numpy as np
import pytest

import clubface
from clubface.errors import InputError
from clubface.inference import player_report, player_sentences, player_statistics
from clubface.inference.player_report import player_result, result_of_clubs, statistics_by_club
from clubface.inference.player_statistics import club_statistics, statistic
from clubface.present.document import as_markdown
from clubface.present.report import report_blocks, write_report
from clubface.shots.recorded import RecordedShots

pytest.importorskip("matplotlib")

DEG, MPH, RPM, YD = np.pi / 180, 0.44704, np.pi / 30, 0.9144


def shots(count=12, *, club="Driver", drop=(), **columns):
    """Drives by the default model, struck 8 mm towards the toe with a face that is open to the path."""
    random = np.random.default_rng(1)
    delivery = {
        "speed": 45.0 + random.normal(0, 0.7, count), "attack": 2 * DEG + random.normal(0, 0.01, count),
        "path": -2 * DEG + random.normal(0, 0.005, count), "face": 3 * DEG + random.normal(0, 0.005, count),
        "loft": 15 * DEG + random.normal(0, 0.01, count), "toe": np.full(count, 8e-3), "high": np.zeros(count),
    }  # fmt: skip
    launch = clubface.impact("driver", delivery)
    launches = {name: np.array(getattr(launch, name)) for name in ("ball_speed", "launch", "azimuth", "total_spin",
                                                                   "spin_axis")}  # fmt: skip
    launches |= {name: np.full(count, value) for name, value in columns.items()}
    return RecordedShots(
        deliveries={name: values for name, values in delivery.items() if name not in drop},
        launches={name: values for name, values in launches.items() if name not in drop},
        clubs=np.full(count, club, dtype=object), rows=np.arange(2, count + 2), source="range.csv", format="clubface",
    )  # fmt: skip


def test_the_typical_shot_is_the_mean_of_the_file():
    given = shots(carry=230 * YD, side=-12 * YD)
    text = " ".join(player_sentences.measured(club_statistics(given, "Driver")))
    assert "We measured 12 shots" in text
    speed = given.launches["ball_speed"].mean() / MPH
    assert f"ball speed {speed:.0f} mph" in text
    assert f"spin {given.launches['total_spin'].mean() / RPM:.0f} rpm" in text
    assert "It carries 230 yards;" in text
    assert "finishes 12 yards to the left" in text
    assert "did not give us" not in text


def test_a_carry_that_was_not_measured_is_computed_and_said_so():
    result = club_statistics(shots(), "Driver")
    flight = clubface.fly({name: shots().launches[name] for name in ("ball_speed", "launch", "azimuth", "total_spin",
                                                                     "spin_axis")})  # fmt: skip
    text = " ".join(player_sentences.measured(result))
    assert f"It carries {np.mean(flight.carry) / YD:.0f} yards (computed" in text
    assert "carry" not in text[: text.index(".")]


def test_sides_are_in_words():
    text = " ".join(player_sentences.line(club_statistics(shots(), "Driver")))
    start = np.degrees(shots().launches["azimuth"].mean())
    assert f"Your ball starts {start:.1f}° to the right and bends to the right" in text
    assert re.search(r"As measured, your club face points [23]\.\d° to the right", text)
    assert re.search(r"your club moves [12]\.\d° to the left", text)
    assert re.search(r"The face looks [45]\.\d° further right than the club moves", text)
    for value, name, words_ in (
        (-2 * DEG, "face", "2.0° to the left"), (0.1 * DEG, "path", "straight"), (4e-3, "toe", "4 mm towards the toe"),
        (-4e-3, "toe", "4 mm towards the heel"), (-5e-3, "high", "5 mm low"), (3 * DEG, "attack", "3.0° upwards"),
        (YD, "side", "1 yard to the right"),
    ):  # fmt: skip
        assert player_sentences.sided(value, name) == words_


def test_a_closing_face_is_told_with_what_it_does_to_start_and_bend():
    """A face that closes on the way moves to the left, which is a face open to that path: left start, bend right."""
    result = club_statistics(shots(), "Driver")
    assert result.inferred is not None
    base = result.inferred.mean
    without = clubface.impact("driver", {**base, "closure": 0.0})
    moved = clubface.impact("driver", base).azimuth - without.azimuth
    # To the first order: what the second adds over all of the rate is some per cent of it.
    assert result.closing["azimuth"] == pytest.approx(moved, rel=0.1)
    text = " ".join(player_sentences.line(result))
    assert "usual for golfers of your speed, and so moves to the left" in text
    assert (
        f"starts the ball {abs(np.degrees(result.closing['azimuth'])):.1f}° further left and bends it to the right"
        in text
    )
    measured = shots()
    measured.deliveries["closure"] = np.full(12, 2500 * DEG)
    assert "usual for golfers" not in " ".join(player_sentences.line(club_statistics(measured, "Driver")))


def test_the_only_player_of_a_file_is_named():
    given = shots()
    assert " by " not in result_of_clubs([], given).summary[0].sentence
    named = dataclasses.replace(given, players=np.full(12, "Maria", dtype=object))
    assert "12 shots by Maria of range.csv" in result_of_clubs([], named).summary[0].sentence


def test_a_mile_per_hour_more_is_told_to_a_tenth_of_ball_speed():
    result = club_statistics(shots(), "Driver")
    faster = next(each for each in result.changes if each.name == "speed")
    phrase = f"ball speed {faster.launch['ball_speed'] / MPH:+.1f} mph"
    assert any(each.startswith("If you swing 1 mph faster: " + phrase) for each in player_sentences.what_if(result))


def test_a_strike_that_was_measured_is_told_and_one_that_was_not_is_estimated_with_its_doubt():
    assert "the face 8 mm towards the toe and at the middle height" in " ".join(
        player_sentences.strike(club_statistics(shots(), "Driver"))
    )
    result = club_statistics(shots(drop=("toe", "high")), "Driver")
    text = " ".join(player_sentences.strike(result))
    assert result.inferred is not None
    low, high = (1e3 * (result.inferred.mean["toe"] + sign * 2.0 * result.inferred.doubt["toe"]) for sign in (-1, 1))
    # Face and path were measured, so that gear effect and start line betray the strike; the truth is inside.
    assert low < 8.0 < high
    assert f"to {high:.0f} mm towards the toe (19 times out of 20)" in text
    assert "Your monitor does not see where the ball meets the face" in text


def test_the_what_if_is_that_of_the_model():
    result = club_statistics(shots(), "Driver")
    assert result.inferred is not None
    base = result.inferred.mean
    face = next(each for each in result.changes if each.name == "face")
    moved = clubface.impact("driver", {**base, "face": base["face"] + DEG})
    still = clubface.impact("driver", base)
    # A derivative over one degree: the launch bends by less than a tenth of the change.
    assert face.launch["azimuth"] == pytest.approx(moved.azimuth - still.azimuth, rel=0.1)
    away = clubface.fly(moved).side - clubface.fly(still).side
    assert face.side == pytest.approx(away, rel=0.1)
    assert any(
        "turn the face 1° more to the right: " in each
        and f"finishing {face.side / YD:.0f} yards more to the right" in each
        for each in player_sentences.what_if(result)
    )


def test_a_change_of_spin_says_whether_there_is_more_or_less_of_it():
    result = club_statistics(shots(), "Driver")
    texts = list(player_sentences.what_if(result))
    assert len(texts) == len(result.changes)
    signs = set()
    for change, text in zip(result.changes, texts, strict=True):
        rpm = change.launch["backspin"] / RPM
        (printed,) = re.findall(r"backspin ([+-]?[\d,]+) rpm", text)
        assert float(printed.replace(",", "")) == pytest.approx(rpm, abs=0.5)
        signs.add(printed[0])
    assert {"+", "-"} <= signs


def test_what_is_not_known_is_said():
    text = " ".join(
        player_sentences.doubt(club_statistics(shots(3, carry=np.array([220.0, 230.0, 240.0]) * YD), "Driver"))
    )
    # Student's t of 2 degrees of freedom, 4.303, times 10 yards over the root of 3.
    assert "to about 25 yards either way" in text
    assert "3 shots are few" in text
    putter = club_statistics(shots(club="Chipper"), "Chipper")
    assert putter.club is None
    assert putter.changes == ()
    assert "no model of Chipper" in " ".join(player_sentences.doubt(putter))


def test_shots_whose_figures_do_not_go_together_are_named():
    given = shots()
    given.deliveries["attack"][4] = 15 * DEG
    text = " ".join(player_sentences.doubt(club_statistics(given, "Driver")))
    assert "hardly go together, so that one of them may be wrong: 6." in text
    assert "hardly go together" not in " ".join(player_sentences.doubt(club_statistics(shots(), "Driver")))


def test_two_of_three_shots_lie_between_what_is_told():
    result = statistic(np.arange(13.0))
    assert result is not None
    assert (result.low, result.high, result.count) == (2.0, 10.0, 13)
    assert statistic(np.array([np.nan])) is None


class Reader(HTMLParser):
    """Collects what the page shows, and what it would load."""

    def __init__(self):
        super().__init__()
        self.shown, self.loaded, self.saved, self.files = [], [], [], {}

    def handle_starttag(self, tag, attrs):
        self.loaded += [value for name, value in attrs if name == "src"]
        given = dict(attrs)
        self.saved += [given["href"]] if "href" in given else []
        if given.get("href", "").startswith("data:text/csv;base64,"):
            self.files[given["download"]] = base64.b64decode(given["href"].partition(",")[2])

    def handle_data(self, data):
        self.shown.append(data)


def test_the_page_is_one_file_with_its_pictures(tmp_path):
    given = shots()
    clubs = np.array(["Driver"] * 7 + ["<b>7 Iron</b>"] * 5, dtype=object)
    given = clubface.RecordedShots(**{**vars(given), "clubs": clubs})
    page = Reader()
    page.feed(write_report(player_result(given), tmp_path / "report.html").read_text())
    assert "This report is about 12 shots of range.csv: Driver (7), <b>7 Iron</b> (5)." in page.shown
    assert len(page.loaded) == 2
    for each in page.loaded:
        kind, _, data = each.partition(",")
        assert kind == "data:image/svg+xml;base64"
        assert b"<svg" in base64.b64decode(data)
    # A picture and its points, the figures and the shots of each club; then the changes, and addresses of sources.
    assert any(each.startswith("https://") for each in page.saved)
    assert [each for each in page.saved if each.startswith("data:image")] == page.loaded
    counts = []
    for number, (name, club) in enumerate({"driver": "Driver", "b-7-iron-b": "<b>7 Iron</b>"}.items()):
        (tmp_path / f"{number}.csv").write_bytes(page.files[f"{name}-shots.csv"])
        again = clubface.read_shots(tmp_path / f"{number}.csv")
        mine = given.select(given.clubs == club)
        assert set(again.clubs) == {club}
        np.testing.assert_allclose(again.launches["backspin"], mine.launches["backspin"], rtol=1e-12)
        counts.append(len(again))
    assert counts == [7, 5]
    markdown = write_report(player_result(given), tmp_path / "report.md").read_text()
    assert markdown.count("](data:image/svg+xml;base64,") == 2
    assert "<b>" not in markdown
    with pytest.raises(InputError, match=r"ends in \.html or \.md"):
        write_report(player_result(given), tmp_path / "report.pdf")


def test_the_document_has_the_clubs_as_parts_with_their_numbers():
    given = shots(carry=230 * YD)
    document = player_result(given).to_dict()
    (club,) = (each for each in document["parts"] if each["kind"] == "club")
    (carry,) = (row for row in club["tables"]["statistics"]["rows"] if row["quantity"] == "carry")
    assert (carry["shots"], carry["unit"], carry["mean"]) == (12, "m", pytest.approx(230 * YD))
    (changes,) = (each for each in club["parts"] if each["kind"] == "changes")
    faster = next(row for row in changes["tables"]["changes"]["rows"] if row["change"] == "speed")
    assert faster["ball_speed_mps"] == pytest.approx(1.46 * MPH, rel=0.05)  # the smash factor of this driver


def test_a_report_on_very_many_players_says_what_it_leaves_out(monkeypatch):
    """A picture takes a fifth of a second, and so do the deliveries of twenty shots."""
    monkeypatch.setattr(player_report, "MOST_PICTURES", 2)
    monkeypatch.setattr(player_statistics, "IN_ALL", 15)
    given = shots(18)
    given = dataclasses.replace(given, players=np.array(["Ann", "Bob", "Cid"] * 6, dtype=object))
    clubs = statistics_by_club(given)
    assert [each.inferred.shots for each in clubs] == [5, 5, 5]
    result = result_of_clubs(clubs, given)
    assert sum(len(each.pictures()) for each in result.parts) == 2
    text = as_markdown(list(report_blocks(result)))
    assert "Pictures are drawn for the first 2 of 3 clubs" in text
    assert text.count("was computed for 5 of the shots") == 3
    assert club_statistics(shots(18), "Driver").inferred.shots == 15


def test_processes_give_the_statistics_of_this_one_to_the_last_bit(monkeypatch):
    four = dataclasses.replace(shots(12), players=np.repeat(["Ann", "Bo", "Cy", "Di"], 3).astype(object))
    monkeypatch.setattr(player_report, "processors", lambda: 2)
    here = statistics_by_club(four)
    monkeypatch.setattr(player_report, "FEWEST_FOR_PROCESSES", 1)
    monkeypatch.setattr(player_report, "in_sequence", None)
    for one, other in zip(statistics_by_club(four), here, strict=True):
        assert one.player == other.player
        for name in ("measured", "inferred", "changes", "start", "closing"):
            assert getattr(one, name) == getattr(other, name), name


def test_the_command_writes_the_report_of_a_monitors_file(clubface_, tmp_path, write):
    source = write(
        "ball_speed_mph,launch_deg,azimuth_deg,backspin_rpm,sidespin_rpm\n150,13,1,2600,100\n151,13,2,2500,80\n"
    )
    target = tmp_path / "report.md"
    ran = clubface_("monitor", "report", str(source), "-o", str(target), "--club", "driver")
    assert ran.err == f"clubface: wrote {target}\n"
    text = target.read_text()
    assert "Your typical shot: ball speed 150 mph" in text  # 150.5, to even
    assert "the face angle to about" in text
    nothing = write("ball_speed_mph,carry_yd\n110,150\n", "carry.csv")
    clubface_("monitor", "report", str(nothing), "-o", str(target))
    assert "It carries 150 yards." in target.read_text()


@pytest.mark.parametrize("count", [4, 5, 6, 9, 10, 11])
def test_how_many_shots_more_would_tell_twice_as_well(count):
    """The error of a mean falls with the square root of the number of shots."""
    text = " ".join(player_sentences.doubt(club_statistics(shots(count), "Driver")))
    sentence = re.search(r"With (\d+) more shots we would know the averages about twice", text)
    if not 5 <= count < 10:
        assert sentence is None
        assert ("are few" in text) == (count < 5)
    else:
        assert np.sqrt((count + int(sentence[1])) / count) == 2.0
