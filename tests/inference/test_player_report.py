"""The report for a player: every number is one of the file or of a model, sides and doubts are in words, one file."""

import base64
import dataclasses
from html.parser import HTMLParser
from itertools import pairwise

import numpy as np
import pytest

import clubface
from clubface import published_data
from clubface.design.golfer_estimate import estimate_golfer
from clubface.design.loft_fit import fit_loft, player_loft_notes
from clubface.design.optimisation.advice import WORTH
from clubface.errors import InputError
from clubface.inference import player_page, player_report, player_statistics
from clubface.inference.player_report import player_result, result_of_clubs, statistics_by_club
from clubface.inference.player_statistics import club_statistics
from clubface.present.document import Appendix, Listing, TextTable
from clubface.present.report import report_blocks, write_report
from clubface.results.notes import note
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


def data(notes):
    """Return the data of notes by code."""
    return {each.code: each.data for each in notes}


def test_the_typical_shot_is_the_median_of_the_file():
    given = shots(carry=230 * YD, side=-12 * YD)
    notes = data(player_page.typical_notes(club_statistics(given, "Driver")))
    typical = notes["player-typical-shot"]
    assert typical["shots"] == 12
    for name, value in typical["figures"].items():
        assert value == np.median((given.deliveries | given.launches)[name]), name
    assert list(typical["figures"]) == ["speed", "ball_speed", "launch", "total_spin"]
    assert notes["player-carry"]["carry"] == pytest.approx(230 * YD, rel=1e-14)
    assert notes["player-side"]["side"] == pytest.approx(-12 * YD, rel=1e-14)


def test_an_unmeasured_carry_is_computed_and_noted():
    result = club_statistics(shots(), "Driver")
    flight = clubface.fly({name: shots().launches[name] for name in ("ball_speed", "launch", "azimuth", "total_spin",
                                                                     "spin_axis")})  # fmt: skip
    assert result.computed
    assert result.measured["carry"].median == pytest.approx(np.median(flight.carry), rel=1e-12)
    page = player_result(shots())
    assert "player-carry-computed" in page_codes(page)
    assert "player-carry-computed" not in page_codes(player_result(shots(carry=230 * YD)))
    assert "carry" not in result.shots.launches  # so that the data of the report have only what was measured


def page_codes(result):
    """Return the codes of the notes of the first page."""
    parts = [each for each in result.parts if each.kind in ("findings", "practice", "purchases", "confidence")]
    assert [each.kind for each in parts] == ["findings", "practice", "purchases", "confidence"]
    return {note.code for part in parts for note in part.notes}


def test_start_face_and_path_are_those_measured():
    given = shots()
    notes = data(player_page.line_notes(club_statistics(given, "Driver")))
    start = notes["player-start-and-curve"]
    assert start["azimuth"] == np.median(given.launches["azimuth"])
    flight = clubface.fly(given.launches)
    assert start["curve"] == pytest.approx(np.median(flight.curve), rel=1e-12)
    assert start["shape"] == "push slice"  # as the face is open, and more so to the path
    assert club_statistics(dataclasses.replace(given, hand=["left"] * 12), "Driver").shot_shape == "pull hook"
    axis = data(player_page.line_notes(club_statistics(shots(drop=("total_spin",)), "Driver")))
    assert axis["player-start-and-spin-axis"]["spin_axis"] == np.median(given.launches["spin_axis"])
    measured = notes["player-face-and-path"]
    assert (measured["face"], measured["path"]) == tuple(np.median(given.deliveries[name]) for name in ("face", "path"))
    # The face is open to the path by five degrees, whose medians are known to a tenth.
    assert notes["player-face-to-path"]["face"] == pytest.approx(5 * DEG, abs=0.4 * DEG)
    at_contact = club_statistics(dataclasses.replace(given, face_at="contact"), "Driver")
    assert "player-face-and-path" in data(player_page.line_notes(at_contact))  # converted to the face centre
    unknown = data(player_page.line_notes(club_statistics(shots(drop=("face",)), "Driver")))
    assert list(unknown["player-face-and-path-estimated"]["margins"]) == ["face"]


@pytest.mark.parametrize(
    ("code", "values", "words"),
    [
        ("player-start", {"azimuth": -2 * DEG}, "2.0 deg to the left"),
        ("player-start", {"azimuth": 0.04 * DEG}, "straight"),
        ("player-strike-toe", {"toe": 4e-3}, "4 mm towards the toe"),
        ("player-strike-toe", {"toe": -4e-3}, "4 mm towards the heel"),
        ("player-strike-high", {"high": -5e-3}, "5 mm low"),
        ("player-side-alone", {"side": -1.2 * YD}, "1 yd to the left"),
        ("player-side-alone", {"side": -0.3 * YD}, "on the line"),
    ],
)
def test_sides_are_in_words_and_what_rounds_to_nothing_has_none(code, values, words):
    assert note(code, **values).sentence.endswith(f" {words}.")


def test_a_closing_face_is_named_with_what_it_does_to_start_and_bend():
    """A face that closes on the way moves to the left, which is a face open to that path: left start, bend right."""
    result = club_statistics(shots(), "Driver")
    assert result.inferred is not None
    base = result.inferred.mean
    without = clubface.impact("driver", {**base, "closure": 0.0})
    moved = clubface.impact("driver", base).azimuth - without.azimuth
    # To the first order: what the second adds over all of the rate is some per cent of it.
    assert result.closing["azimuth"] == pytest.approx(moved, rel=0.1)
    closing = data(player_page.line_notes(result))["player-closing-usual"]
    assert closing["azimuth"] < 0.0 < closing["sidespin"]
    measured = shots()
    measured.deliveries["closure"] = np.full(12, 2500 * DEG)
    assert "player-closing" in data(player_page.line_notes(club_statistics(measured, "Driver")))


def test_the_only_player_of_a_file_is_named():
    given = shots()
    (summary,) = result_of_clubs([], given).summary
    assert summary.code == "player-report-of"
    named = dataclasses.replace(given, players=np.full(12, "Maria", dtype=object))
    (summary,) = result_of_clubs([], named).summary
    assert (summary.code, summary.data["player"], summary.data["shots"]) == ("player-report-by", "Maria", 12)


def test_a_strike_that_was_measured_is_given_and_one_that_was_not_is_estimated_only_where_the_flight_shows_it():
    measured = data(player_page.strike_notes(club_statistics(shots(), "Driver")))["player-strike"]
    assert (measured["toe"], measured["high"]) == (8e-3, 0.0)
    result = club_statistics(shots(drop=("toe", "high")), "Driver")
    estimated = data(player_page.strike_notes(result))["player-strike-estimated"]
    # Face and path were measured, so that gear effect and start line betray the strike; the truth is inside.
    assert estimated["low_toe"] < 8e-3 < estimated["high_toe"]
    nothing = club_statistics(shots(drop=("toe", "high", "face", "path", "loft", "attack", "speed")), "Driver")
    assert list(player_page.strike_notes(nothing)) == []


def test_the_what_if_is_that_of_the_model():
    result = club_statistics(shots(), "Driver")
    assert result.inferred is not None
    base = result.inferred.mean
    still = clubface.impact("driver", base)
    notes = data(player_page.what_if_notes(result))
    assert len(notes) == len(result.changes) == 7
    for name, step, quantity in (("face", DEG, "azimuth"), ("high", 5e-3, "launch"), ("high", 5e-3, "backspin")):
        change = next(each for each in result.changes if each.name == name)
        assert change.step == step
        moved = clubface.impact("driver", {**base, name: base[name] + step})
        # A derivative over one step: the launch bends by less than a tenth of the change.
        expected = getattr(moved, quantity) - getattr(still, quantity)
        assert change.launch[quantity] == pytest.approx(expected, rel=0.1), (name, quantity)
        effects = notes[f"player-change-{name}"]["effects"]
        assert effects["backspin"] == change.launch["backspin"]
        if name == "face":
            assert change.side == pytest.approx(clubface.fly(moved).side - clubface.fly(still).side, rel=0.1)
            assert notes["player-change-face"]["side"] == change.side
    # A drive struck higher starts higher and spins less.
    high = next(each for each in result.changes if each.name == "high").launch
    assert high["launch"] > 0.0 > high["backspin"]


def test_a_change_of_spin_has_its_sign_and_one_too_small_to_print_is_left_out():
    effects = {"ball_speed": 0.01 * MPH, "backspin": -150 * RPM, "carry": 2 * YD}
    sentence = note("player-change-speed", step_speed=MPH, effects=effects, side=0.0).sentence
    assert "ball speed" not in sentence
    assert "backspin -150 rpm" in sentence
    assert "carry +2.0 yd" in sentence


def test_missing_knowledge_is_noted():
    three = club_statistics(shots(3, carry=np.array([220.0, 230.0, 240.0]) * YD), "Driver")
    notes = data(player_page.doubt_notes(three))
    # Student's t of 2 degrees of freedom, 4.303, times the error of the median, sqrt(pi / 2) times 10 yards over the
    # root of 3.
    expected = 4.302653 * np.sqrt(np.pi / 2 / 3) * 10 * YD
    assert notes["player-carry-margin"]["margin_carry"] == pytest.approx(expected, rel=1e-6)
    assert notes["player-few-shots"]["shots"] == 3
    chipper = club_statistics(shots(club="Chipper"), "Chipper")
    assert chipper.club is None
    assert chipper.changes == ()
    assert data(player_page.doubt_notes(chipper))["player-no-model"]["club"] == "Chipper"


def test_shots_whose_figures_are_inconsistent_are_named():
    given = shots()
    given.deliveries["attack"][4] = 15 * DEG
    assert data(player_page.doubt_notes(club_statistics(given, "Driver")))["player-inconsistent-rows"]["rows"] == [6]
    assert "player-inconsistent-rows" not in data(player_page.doubt_notes(club_statistics(shots(), "Driver")))


def with_topped_drive(count=10):
    """Drives of which the fifth is topped: slow, low and short."""
    given = shots(count, carry=np.linspace(225.0, 235.0, count) * YD, side=np.linspace(-12.0, 20.0, count) * YD)
    given.launches["ball_speed"][4], given.launches["launch"][4], given.launches["carry"][4] = 30.0, 0.5 * DEG, 30 * YD
    return given


def test_one_topped_drive_in_ten_is_named_and_moves_nothing_else():
    """Of the file without it, the medians, spreads, deliveries and what-if are the same to the last bit."""
    given = with_topped_drive()
    kept = np.arange(10) != 4
    topped, clean = club_statistics(given, "Driver"), club_statistics(given.select(kept), "Driver")
    (named,) = player_page.mishit_notes(topped)
    assert (named.code, named.data["row"]) == ("player-mishit", 6)
    assert {"ball_speed", "carry"} <= set(named.data["figures"])
    assert named.data["figures"]["carry"] == pytest.approx(30 * YD, rel=1e-14)
    assert {name: each[:5] for name, each in topped.measured.items()} == {
        name: each[:5] for name, each in clean.measured.items()
    }
    assert topped.inferred == clean.inferred
    assert topped.changes == clean.changes
    assert list(player_page.typical_notes(topped)) == list(player_page.typical_notes(clean))
    assert list(player_page.mishit_notes(clean)) == []
    page = player_result(given)
    (club,) = (each for each in page.parts if each.kind == "club")
    (panel, _) = club.pictures()[0].panels()
    (grey,) = (mark for mark in panel.marks if mark.kind == "points" and mark.style == -1)
    np.testing.assert_allclose(grey.y, [30 * YD], rtol=1e-14)


def bag(*clubs, count=8, **more):
    """Shots of clubs with given carries and sides [yd] about their means, with a face that scatters."""
    parts = []
    random = np.random.default_rng(7)
    for name, carry, side in clubs:
        around = np.linspace(-1.0, 1.0, count)
        parts.append(
            {"carry": (carry + 3 * around) * YD, "side": (side + 4 * random.permutation(around)) * YD,
             "clubs": [name] * count, "face": 0.5 * DEG * random.standard_normal(count)}
        )  # fmt: skip

    def joined(name):
        return np.concatenate([each[name] for each in parts])

    total = count * len(parts)
    return RecordedShots(
        deliveries={"face": joined("face")} | more,
        launches={"carry": joined("carry"), "side": joined("side"), "ball_speed": 0.3 * joined("carry") + 5.0},
        clubs=joined("clubs").astype(object), rows=np.arange(2, total + 2), source="bag.csv", format="clubface",
    )  # fmt: skip


def test_the_first_page_names_the_widest_gap_and_two_clubs_that_do_the_work_of_one():
    given = bag(("Driver", 250, 0), ("5 Iron", 205, 1), ("6 Iron", 195, 0), ("7 Iron", 184, 0), ("8 Iron", 181, 0))
    result = player_result(given)
    (findings,) = (each for each in result.parts if each.kind == "findings")
    notes = data(findings.notes)
    wide, narrow = notes["player-finding-gap-wide"], notes["player-finding-gap-overlap"]
    assert (wide["longer"], wide["shorter"]) == ("Driver", "5 Iron")
    assert wide["gap_carry"] == pytest.approx(45 * YD, rel=1e-12)
    assert wide["usual_carry"] == pytest.approx(10.5 * YD, rel=1e-12)  # the median of 45, 10, 11 and 3 yards
    assert (narrow["longer"], narrow["shorter"]) == ("7 Iron", "8 Iron")
    assert narrow["gap_carry"] == pytest.approx(3 * YD, rel=1e-12)
    (purchases,) = (each for each in result.parts if each.kind == "purchases")
    bought = data(purchases.notes)
    assert bought["player-buy-gap"]["carry"] == pytest.approx(227.5 * YD, rel=1e-12)
    assert "player-buy-one-of-two" in bought
    (picture,) = result.pictures()
    assert list(picture.panels()[-1].x.names) == ["Driver", "5 Iron", "6 Iron", "7 Iron", "8 Iron"]


def test_an_even_bag_has_no_gap_to_fill_and_a_side_that_is_clear_is_a_finding():
    given = bag(("Driver", 240, 18), ("5 Iron", 228, 0), ("6 Iron", 216, 0), ("7 Iron", 204, 1))
    result = player_result(given)
    parts = {each.kind: data(each.notes) for each in result.parts if each.kind != "club"}
    assert parts["findings"]["player-finding-side"]["side"] == pytest.approx(18 * YD, rel=1e-12)
    assert not any("gap" in code for code in parts["findings"])
    assert "player-buy-nothing" in parts["purchases"]
    assert len(parts["findings"]) <= 3


def test_gaps_of_few_shots_are_no_finding():
    given = bag(("Driver", 250, 0), ("5 Iron", 205, 1), ("6 Iron", 203, 0), ("7 Iron", 184, 0), count=3)
    assert not any("gap" in code or "buy-one" in code for code in page_codes(player_result(given)))


def test_of_the_gaps_of_the_tours_only_those_of_a_hybrid_or_the_wood_in_its_place_are_narrow():
    """As the docstring of the limit says of the averages of 2019 and 2023: 3 to 5 yd, and 8 and more elsewhere."""
    narrow, others = [], []
    for table in map(published_data.table, ("pga-2019", "lpga-2019", "pga-2023", "lpga-2023")):
        bag = sorted(zip(table["carry"] / YD, table["club"], strict=True), reverse=True)
        for (carry, longer), (less, shorter) in pairwise(bag):
            (narrow if carry - less < player_page.NARROW / YD else others).append((carry - less, longer, shorter))
    assert {longer if longer in ("hybrid", "7-wood") else shorter for _, longer, shorter in narrow} == {
        "hybrid",
        "7-wood",
    }
    assert [min(narrow)[0], max(narrow)[0], min(others)[0]] == pytest.approx([3.0, 5.0, 8.0])


def test_the_margin_of_a_carry_counts_the_shots_of_its_own_club():
    """A single drive has no margin; that of the irons rests on the eight irons."""
    given = bag(("Driver", 250, 0), ("7 Iron", 160, 0)).select(np.r_[0, 8:16])
    (confidence,) = (each for each in player_result(given).parts if each.kind == "confidence")
    assert data(confidence.notes)["player-carry-margin"]["shots"] == 8


def test_what_is_worth_practising_is_the_measured_part_that_spreads_the_shots_most():
    """The face is what makes drives go left and right: its spread times the derivative is that of the side."""
    given = with_topped_drive(12)
    result = player_result(given)
    (practice,) = (each for each in result.parts if each.kind == "practice")
    club = club_statistics(given, "Driver")
    parts = {
        each.name: abs(each.side / each.step) * club.measured[each.name].spread
        for each in club.changes if each.name in club.measured
    }  # fmt: skip
    side = data(practice.notes).get("player-practise-side")
    if side is None:  # the made-up sides scatter more than the swing explains
        assert max(parts.values()) <= 0.4 * club.measured["side"].spread
    else:
        assert list(side["spread"]) == [max(parts, key=parts.__getitem__)]
    assert data(practice.notes)["player-practise-mishits"]["mishits"] == 1


def test_the_face_that_spreads_the_drives_is_worth_practising():
    random = np.random.default_rng(5)
    given = shots(20)
    given.deliveries["face"][:] = 3 * DEG * random.standard_normal(20)
    launch = clubface.impact("driver", given.deliveries)
    made = {name: np.array(getattr(launch, name)) for name in ("ball_speed", "launch", "azimuth", "backspin",
                                                               "sidespin")}  # fmt: skip
    result = player_result(dataclasses.replace(given, launches=made, derived={}))
    (practice,) = (each for each in result.parts if each.kind == "practice")
    side = data(practice.notes)["player-practise-side"]
    assert list(side["spread"]) == ["face"]
    # All other parts of the swing are nearly still, so that the face alone explains the spread, to the first order.
    assert side["part_side"] == pytest.approx(side["spread_side"], rel=0.15)


def test_the_first_page_has_nothing_of_what_was_not_measured():
    """Without club data no part of the swing is named, though the models estimate a delivery."""
    given = shots(drop=("speed", "attack", "path", "face", "loft", "toe", "high"))
    result = player_result(given)
    parts = {each.kind: data(each.notes) for each in result.parts if each.kind != "club"}
    assert "player-practise-unknown" in parts["practice"]
    assert not any("quantity" in each for each in parts["practice"].values())
    absent = parts["confidence"]["player-not-measured"]["quantities"]
    assert {"face angle", "club path", "impact height"} <= set(absent)
    assert not any("strike" in code for code in parts["findings"])


def test_all_clubs_of_a_player_are_drawn_in_one_scale():
    given = bag(("Driver", 250, 15), ("7 Iron", 150, -3))
    clubs = [each for each in player_result(given).parts if each.kind == "club"]
    panels = [each.pictures()[0].panels() for each in clubs]
    for place in (0, 1):
        assert len({(row[place].x.limits, row[place].y.limits) for row in panels}) == 1
    low, high = panels[0][0].y.limits
    assert low < 147 * YD
    assert high > 253 * YD


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
    assert "<b>7 Iron</b>" in page.shown  # a heading, in which the name of a file's club is no HTML
    assert len(page.loaded) == 3  # the bag and each club
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
    assert markdown.count("](data:image/svg+xml;base64,") == 3
    assert "<b>" not in markdown
    with pytest.raises(InputError, match=r"ends in \.html or \.md"):
        write_report(player_result(given), tmp_path / "report.pdf")


def test_the_document_has_the_clubs_as_parts_with_their_numbers():
    given = shots(carry=230 * YD)
    document = player_result(given).to_dict()
    (club,) = (each for each in document["parts"] if each["kind"] == "club")
    (figures,) = (each for each in club["parts"] if each["kind"] == "figures")
    (carry,) = (row for row in figures["tables"]["statistics"]["rows"] if row["quantity"] == "carry")
    assert (carry["shots"], carry["unit"], carry["median"]) == (12, "m", pytest.approx(230 * YD))
    faster = next(row for row in figures["tables"]["changes"]["rows"] if row["change"] == "speed")
    assert faster["ball_speed_mps"] == pytest.approx(1.46 * MPH, rel=0.05)  # the smash factor of this driver


def test_tables_and_fingerprints_stand_in_one_closed_section(tmp_path):
    result = player_result(with_topped_drive())
    blocks = list(report_blocks(result, command="clubface monitor report range.csv -o player.html"))
    assert not any(isinstance(each, (TextTable, Listing)) for each in blocks)
    (appendix,) = (each for each in blocks if isinstance(each, Appendix))
    assert blocks[-1] is appendix
    assert sum(isinstance(each, TextTable) for each in appendix.blocks) >= 4
    assert any(isinstance(each, Listing) for each in appendix.blocks)
    text = write_report(result, tmp_path / "player.html").read_text()
    assert text.count("<details>") == 1
    assert text.index("<details>") < text.index("<table")
    assert text.count('<div class="page">') == 1  # before the only club


def test_lofts_are_judged_for_the_players_of_a_lesson_but_not_for_those_of_a_season(monkeypatch):
    """A judgement of a loft takes seconds, so that many players go without, and a note says so."""
    monkeypatch.setattr(player_report, "MOST_LOFTS", 2)
    judged = []

    def judge(club):
        judged.append(club.player)
        yield note("player-loft-best", club=club.name)

    for players in (["Ann", "Bob"], ["Ann", "Bob", "Cid"]):
        judged.clear()
        names = np.array(players * (24 // len(players)), dtype=object)
        result = player_result(dataclasses.replace(shots(24), players=names), loft_notes=judge)
        many = len(players) > 2
        assert judged == ([] if many else players)
        assert ("player-lofts-not-judged" in [each.code for each in result.summary]) == many


def test_a_report_on_very_many_players_notes_what_it_leaves_out(monkeypatch):
    """A picture takes a fifth of a second, and so do the deliveries of twenty shots."""
    monkeypatch.setattr(player_report, "MOST_PICTURES", 5)
    monkeypatch.setattr(player_statistics, "IN_ALL", 15)
    given = shots(18)
    given = dataclasses.replace(given, players=np.array(["Ann", "Bob", "Cid"] * 6, dtype=object))
    clubs = statistics_by_club(given)
    assert [each.inferred.shots for each in clubs] == [5, 5, 5]
    assert [data(player_page.doubt_notes(each))["player-delivery-of-some"]["shots"] for each in clubs] == [5, 5, 5]
    result = result_of_clubs(clubs, given)
    players = [each for each in result.parts if each.kind == "player"]
    assert [each.title for each in players] == ["Ann", "Bob", "Cid"]
    drawn = [sum(len(each.pictures()) for each in (player, *player.parts)) for player in players]
    assert drawn == [2, 2, 0]  # page and club of the first two players
    assert data(result.summary)["player-pictures-of-some"] == {"drawn": 2, "clubs": 3}
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
    assert "## Driver" in text
    assert "## Technical details" in text
    nothing = write("ball_speed_mph,carry_yd\n110,150\n", "carry.csv")
    assert clubface_("monitor", "report", str(nothing), "-o", str(target)).status == 0
    assert "150 yd" in target.read_text()


@pytest.mark.parametrize("count", [4, 5, 6, 9, 10, 11])
def test_how_many_shots_more_would_tell_twice_as_well(count):
    """The error of a mean falls with the square root of the number of shots."""
    notes = data(player_page.doubt_notes(club_statistics(shots(count), "Driver")))
    if 5 <= count < 10:
        assert np.sqrt((count + notes["player-more-shots"]["more"]) / count) == 2.0
    else:
        assert "player-more-shots" not in notes
        assert ("player-few-shots" in notes) == (count < 5)


def test_the_loft_on_the_first_page_is_judged_as_best_loft_does():
    """Gain and change of loft are those of fit_loft for the golfer of the shots; without it nothing is said of loft."""
    given = shots(carry=230 * YD)
    club = club_statistics(given, "Driver")
    fitted = fit_loft(estimate_golfer(club.shots, club=club.club).golfer, club=club.club)
    notes = data(player_loft_notes(club))
    best = fitted.advice.recommended() or fitted.advice.best("carry")
    judged = notes.get("player-loft-change") or notes.get("player-loft-keep") or notes["player-loft-best"]
    assert ("player-loft-change" in notes) == bool(fitted.advice.recommended())
    assert judged["gain_carry"] == pytest.approx(fitted.advice.gain("carry", best), abs=1e-9)
    assert judged["gain_carry"] >= 0.0
    assert judged["change_loft"] == pytest.approx(fitted.best("carry") - fitted.present, abs=1e-9)
    assert judged["worth_carry"] == WORTH["carry"]
    page = player_result(given)
    assert "player-heads-not-judged" in page_codes(page)
    assert not any("loft" in code for code in page_codes(page))
    seen = page_codes(player_result(given, loft_notes=lambda club: [note("player-buy-nothing", club=club.name)]))
    assert "player-buy-nothing" in seen


def test_what_mishits_cost_is_the_difference_of_two_means():
    """Nine carries of mean 9 / 10 of the even ladder's and one of 30 yd: mean without less mean with."""
    given = with_topped_drive()
    (practice,) = (each for each in player_result(given).parts if each.kind == "practice")
    carries = given.launches["carry"]
    expected = np.delete(carries, 4).mean() - carries.mean()
    assert data(practice.notes)["player-practise-mishits"]["lost_carry"] == pytest.approx(expected, rel=1e-12)
