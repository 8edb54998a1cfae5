"""Club and player stand above the shots, in a column of any heading, or nowhere; they are never mixed in silence."""

import pytest

from clubface import shots as launch_monitor

HEAD = "Club Speed (mph),Ball Speed (mph),Launch Angle (deg)\n"
DRIVES, IRONS = "100,147,12\n99,145,12.5\n", "85,112,18\n84,111,18.5\n"
BOTH = ["Driver", "Driver", "7 Iron", "7 Iron"]


@pytest.mark.parametrize("title", ["Club: {}\n", "Club,{},\n", "{}\n", "{},,\n", "Schläger: {}\n", "クラブ：{}\n"])
def test_a_line_that_names_a_club_holds_for_the_shots_below_it(write, title):
    for text in (
        title.format("Driver") + HEAD + DRIVES + title.format("7 Iron") + HEAD + IRONS,
        title.format("Driver") + HEAD + DRIVES + title.format("7 Iron") + IRONS,
    ):
        shots = launch_monitor.read(write(text))
        assert shots.clubs.tolist() == BOTH
        assert not shots.rejected


def test_a_report_that_names_player_club_and_date_above_its_table_gives_them_to_its_shots(write):
    for top in ("Player,Ann\nDate,2024-05-01\nClub,7 Iron\n\n", "Player,Club,Date\nAnn,7 Iron,2024-05-01\n"):
        shots = launch_monitor.read(write(top + HEAD + IRONS))
        assert (*shots.clubs, *shots.players, *shots.dates) == ("7 Iron",) * 2 + ("Ann",) * 2 + ("2024-05-01",) * 2


def test_the_place_of_a_session_is_no_club(write):
    assert launch_monitor.read(write("Sand Hills Golf Club\n" + HEAD + DRIVES)).clubs is None


def test_a_shot_of_which_nothing_was_measured_is_no_title_where_a_column_names_the_club(write):
    shots = launch_monitor.read(write("Club," + HEAD + "Driver,100,147,12\n7 Iron,,,\nDriver,99,146,12\n"))
    assert shots.clubs.tolist() == ["Driver", "Driver"]
    assert [each.line for each in shots.rejected] == [3]


@pytest.mark.parametrize("heading", ["Klubba", "クラブ", "클럽", "What I hit", ""])
def test_a_column_of_clubs_is_known_by_its_cells_whatever_it_is_called(write, heading):
    text = f"{heading},Tag,{HEAD}Driver,a,100,147,12\nJärn 7,b,85,112,18\n"
    assert launch_monitor.read(write(text)).clubs.tolist() == ["Driver", "Järn 7"]


@pytest.mark.parametrize("column", [["A", "B"], ["56", "58"], ["Range", "Course"], ["L", "R"]])
def test_letters_numbers_and_places_are_no_clubs(write, column):
    text = f"Grade,{HEAD}{column[0]},100,147,12\n{column[1]},85,112,18\n"
    assert launch_monitor.read(write(text)).clubs is None
