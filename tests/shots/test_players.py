"""Who hit the shots: makers' own columns of the player are read as ``player``, and every command sees them."""

from __future__ import annotations

from pathlib import Path

import pytest

import clubface
from clubface import shots as launch_monitor
from clubface.inference.evaluation.evaluation import evaluate
from clubface.inference.identification.problem import prepared_shots
from clubface.inference.player_report import player_result
from clubface.shots.session_summary import summarize_clubs

DATA = Path(__file__).parents[1] / "data" / "launch_monitors"
# TrackMan and Garmin: headings of public exports (j72jones/stochasticGolf, and the four languages of the Garmin Golf
# app); FlightScope: dmombo/GolfStats; Rapsodo: the title of mmender2/GolfAnalysis; all on GitHub.
COLUMNS = [
    ("trackman", "Player,Club,Club Speed,Ball Speed,Launch Direction,Dyn. Loft", "{},Driver,100,148,1,14"),
    ("trackman", "Club,Player Name,Club Speed,Ball Speed,Launch Direction,Dyn. Loft", "Driver, {} ,100,148,1,14"),
    ("garmin", "Player,Club Type,Club Speed [mph],Ball Speed [mph],Launch Direction,Carry Deviation Distance [yd]",
     "{},Driver,100,148,1,2"),
    ("garmin", "Spieler;Schlägerart;Schl.gsch. [km/h];Abflugrichtung;Carry-Abweichungsdistanz [m]",
     "{};Driver;160,5;1,5;2,5"),
    ("garmin", "Speler,Type club,Clubsnelh. [km/h],Slagrichting,Carry-afwijkingsafstand [m]", "{},Driver,160,1,2"),
    ("garmin", "Jugador,Tipo de palo,Vel. palo [km/h],Dirección de lanzamiento,Distancia de desviación de vuelo [m]",
     "{},Driver,160,1,2"),
    ("flightscope", "Golfer,Club,Ball (mph),Club (mph),Smash,Launch V,Launch H", "{},Driver,148,100,1.48,12,1 R"),
    ("foresight", "Player,Club Name,Ball Speed (mph),Push/Pull (deg L-/R+)", "{},Driver,148,1"),
    ("rapsodo", "Player,Club Type,Club Brand,Club Model,Ball Speed", "{},d,x,y,148"),
]  # fmt: skip


def test_a_title_of_rapsodo_names_the_player_of_the_shots_below_it(write):
    text = (DATA / "rapsodo.csv").read_text(encoding="utf-8")
    count = len(launch_monitor.read(DATA / "rapsodo.csv"))
    joined = text + text.replace("A. Player", "Ben - O'Hara")
    behind_an_empty_column = "".join(f",{line}" if line.strip() else line for line in joined.splitlines(keepends=True))
    for content in (joined, behind_an_empty_column):
        shots = launch_monitor.read(write(content))
        assert shots.players.tolist() == [*["A. Player"] * count, *["Ben - O'Hara"] * count]


@pytest.mark.parametrize(("name", "header", "row"), COLUMNS)
def test_the_player_is_read_by_the_heading_of_each_maker(write, name, header, row):
    shots = launch_monitor.read(write("\n".join([header, *(row.format(who) for who in ("Ann", "Ben", ""))]) + "\n"))
    assert shots.format == name
    assert shots.players is not None
    assert shots.players.tolist() == ["Ann", "Ben", ""]
    labels = shots.groups()
    assert labels is not None
    assert len(set(labels)) == 3  # the shot of no one belongs to none


def test_a_file_without_players_names_none():
    shots = launch_monitor.read(DATA / "foresight-play.csv")
    assert shots.players is None
    assert [who for who, _ in shots.by_player()] == [""]


def test_a_mapping_names_the_column_of_the_player(write):
    mapping = write('player = "Wer"\n[columns.ball_speed]\nheading = "Ball"\nunit = "mph"\n', "own.toml")
    shots = launch_monitor.read(write("Wer,Ball\nAnn,150\nBen,140\n"), mapping=mapping)
    assert shots.players is not None
    assert shots.players.tolist() == ["Ann", "Ben"]


@pytest.fixture
def range_session(write):
    """Drives of Ann at 100 mph and of Ben at 80 mph, and irons of Ann, as TrackMan writes them."""
    lines = ["Player,Club,Club Speed,Attack Angle,Club Path,Dyn. Loft,Face Angle,Ball Speed,Launch Angle,"
             "Launch Direction,Spin Rate,Spin Axis,Swing Direction,Carry Flat - Length"]  # fmt: skip
    for who, club, speed, loft, carry in (
        ("Ann", "Driver", 100, 14, 240), ("Ben", "Driver", 80, 15, 170), ("Ann", "7 Iron", 82, 22, 155),
    ):  # fmt: skip
        for more in range(4):
            name = "driver" if club == "Driver" else "7-iron"
            launched = clubface.impact(name, speed=f"{speed + more} mph", attack="1 deg", loft=f"{loft} deg")
            made = [launched.get(*each) for each in (("ball_speed", "mph"), ("launch", "deg"), ("azimuth", "deg"),
                                                ("total_spin", "rpm"), ("spin_axis", "deg"))]  # fmt: skip
            numbers = ",".join(f"{value:.2f}" for value in made)
            lines.append(f"{who},{club},{speed + more},1,0,{loft},0,{numbers},0,{carry + more}")
    return write("\n".join(lines) + "\n", "range.csv")


def test_a_condition_on_the_player_chooses_his_shots(clubface_, range_session, tmp_path):
    ran = clubface_("monitor", "summary", str(range_session), "--where", "player == 'ben'", "--json")
    assert [(each["club"], each["shots"]) for each in ran.json["tables"]["clubs"]["rows"]] == [("Driver", 4)]
    assert clubface_("monitor", "summary", str(range_session), "--where", "player == 'Eve'").status == 2
    target = tmp_path / "out.csv"
    ran = clubface_(
        "predict", str(range_session), "--club", "driver", "--only", "driver", "--where", "player != 'Ben'",
        "-o", str(target),
    )  # fmt: skip
    assert ran.status == 0
    lines = target.read_text().splitlines()
    assert len(lines) == 5
    assert "player" in lines[0].split(",")
    ran = clubface_("monitor", "summary", str(DATA / "foresight-play.csv"), "--where", "player == 'x'")
    assert "foresight-play.csv have no player" in ran.err


def test_the_drives_of_two_players_are_no_club_of_one(clubface_, range_session, tmp_path):
    first, iron, second = summarize_clubs(launch_monitor.read(range_session))
    assert [(each.player, each.club) for each in (first, iron, second)] == [
        ("Ann", "Driver"), ("Ann", "7 Iron"), ("Ben", "Driver"),
    ]  # fmt: skip
    assert second.places.tolist() == [4, 5, 6, 7]
    assert first.spreads["carry"].mean == pytest.approx(241.5 * 0.9144, rel=1e-14)
    assert first.gap is not None
    assert first.gap.length == pytest.approx(85 * 0.9144, rel=1e-12)
    assert iron.gap is None  # the next shorter club is another player's
    ran = clubface_("monitor", "summary", str(range_session))
    assert [line.split()[:3] for line in ran.out.splitlines() if "Driver" in line] == [
        ["Ann", "Driver", "4"], ["Ben", "Driver", "4"],
    ]  # fmt: skip
    pytest.importorskip("matplotlib")
    picture = tmp_path / "range.svg"
    assert clubface_("monitor", "summary", str(range_session), "--plot", str(picture)).status == 0
    assert "Ben: Driver" in picture.read_text()


def test_a_report_tells_the_players_apart(clubface_, range_session, tmp_path):
    pytest.importorskip("matplotlib")
    shots = launch_monitor.read(range_session)
    result = player_result(shots)
    clubs = {each.title: [one.title for one in each.parts if one.kind == "club"] for each in result.parts[:2]}
    assert clubs == {"Ann": ["Ann: Driver", "Ann: 7 Iron"], "Ben": ["Ben: Driver"]}
    target = tmp_path / "ben.md"
    ran = clubface_("monitor", "report", str(range_session), "-o", str(target), "--where", "player == 'Ben'")
    assert ran.status == 0
    text = target.read_text(encoding="utf-8")
    assert "## Driver" in text
    assert "Ann" not in text


def test_players_are_drawn_together_and_the_shots_of_one_that_was_chosen_are_not(range_session):
    assert evaluate(range_session, club="driver", only="driver", models="standard").groups == 2
    assert evaluate(range_session, club="7-iron", only="7 Iron", models="standard").groups is None
    fixed = clubface.ParameterSet.defaults("standard", "7-iron")
    ready = prepared_shots(range_session, club="7-iron", only="7 Iron", parameters=fixed)
    assert ready.groups.tolist() == [0, 1, 2, 3]
