"""Averages, deviations and the like are no shots, whatever they are called and in whichever column it stands."""

import pytest

from clubface import shots as launch_monitor

MEANS = """Average|AVG|Avg.|Mean|Averages|Durchschnitt|Mittelwert|Moyenne|Promedio|Media|Gemiddelde|Medelvärde|Snitt
|Gennemsnit|Gjennomsnitt|Média|平均|平均値|平均值|평균|Ø|Durchschn.|Medelv.|Keskiarvo|Średnia
|Average (3 shots)|Driver Average|Avg Driver|Session Average"""
DEVIATIONS = """Std Dev|St. Dev.|StdDev|Std. Deviation|Standard Deviation|Deviation|Consistency|Standardabweichung
|Écart-type|Desviación estándar|Deviazione standard|Standaardafwijking|Standardavvikelse|Desvio padrão
|標準偏差|标准差|표준편차|Standardabw.|Std. Abw.|Stdabw|Standardavv.|Odchylenie std."""
SPEEDS = (100.0, 98.0, 103.0)
ROWS = {"mean": (100.33, 147.0), "deviation": (2.52, 3.61), "max": (103.0, 151.0), "min": (98.0, 144.0)}


def names(text):
    return [each.strip() for each in text.replace("\n", "").split("|")]


def session(label, kind, place, heads=("Date", "Club", "Player", "Shot No", "Note")):
    """Return three drives and a row that sums them up, which says so in the column at ``place``."""
    shots = [
        ["2026-05-01", "Driver", "Ann", str(number + 1), "", str(speed), str(ball)]
        for number, (speed, ball) in enumerate(zip(SPEEDS, (146.0, 144.0, 151.0), strict=True))
    ]
    summary = ["2026-05-01", "Driver", "Ann", "", "", *map(str, ROWS[kind])]
    summary[place] = label
    rows = [[*heads, "Club Speed (mph)", "Ball Speed (mph)"], *shots, summary]
    return "\n".join(",".join(row) for row in rows) + "\n"


def assert_left_out(shots, count=1):
    assert len(shots) == 3
    assert ("summary-rows", {"rows": count}) in shots.notes


@pytest.mark.parametrize(
    ("kind", "label"), [("mean", each) for each in names(MEANS)] + [("deviation", each) for each in names(DEVIATIONS)]
)
def test_a_row_of_averages_or_deviations_is_no_shot_in_any_language(write, kind, label):
    for place in (1, 3):
        assert_left_out(launch_monitor.read(write(session(label, kind, place))))


@pytest.mark.parametrize("label", ["Max", "Maximum", "Best", "Total", "Median", "Average", "Std Dev"])
@pytest.mark.parametrize("place", range(5))
def test_a_row_that_sums_up_says_so_in_any_column_of_text(write, label, place):
    kind = {"Median": "mean", "Average": "mean", "Total": "mean", "Std Dev": "deviation"}.get(label, "max")
    assert_left_out(launch_monitor.read(write(session(label, kind, place))))


@pytest.mark.parametrize(
    "rows",
    [
        ["Driver,Max,100,146", "Max,Max,98,144", "7 Iron,Min,85,112", "G430 Max,Dev,101,147", "Driver,Media,99,140"],
        ["Driver,Average Joe,100,146", "Driver,Ann,98,144", "Driver,Mean Gene,99,145"],
        ["Driver,Mini,100,146", "Driver,Mini,98,144", "Driver,Mini,103,151"],
    ],
    ids=["players and clubs called Max", "Average Joe", "what most rows say"],
)
def test_names_of_players_and_clubs_are_no_summaries(write, rows):
    shots = launch_monitor.read(write("\n".join(["Club,Player,Club Speed (mph),Ball Speed (mph)", *rows]) + "\n"))
    assert shots.players.tolist() == [each.split(",")[1] for each in rows]
    assert "summary-rows" not in {each.code for each in shots.notes}


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (
            "Club,Player,Club Speed (mph),Ball Speed (mph)\nDriver,Ann,100,146\nDriver,Ann,103,150\n"
            "Driver,Best,103,150\n7i,Ann,80,106\n7i,Ann,78,104\n7i,Best,80,106\n",
            [2, 3, 5, 6],
        ),
        (
            "Type,Club,Player,Club Speed (mph),Ball Speed (mph)\n"
            "x,Driver,Ann,100,146\nx,Driver,Ann,103,150\nx,Driver Average,Ann,95,139\n",
            [2, 3],
        ),
        (
            "Total (yd),Club Speed (mph),Ball Speed (mph)\n250,100,146\n248,98,144\n262,103,151\nAverage,100.3,147\n",
            [2, 3, 4],
        ),
        (
            "Club,Club Speed,Ball Speed,Launch Direction,Dyn. Loft\n,[mph],[mph],[deg],[deg]\nDriver,100,147,0.1,13\n"
            "Driver Average,100,147,0.1,13\n7 Iron,85,112,0.1,23\n7 Iron Average,85,112,0.1,23\n",
            [3, 5],
        ),
        (
            "Club,Quality,Club Speed (mph),Ball Speed (mph),Launch Angle (deg)\n"
            "Driver,Good,100,146,12\nDriver,Average,95,133,15\nDriver,Best,104,153,11\nDriver,Average,97,139,9\n",
            [2, 3, 4, 5],
        ),
    ],
    ids=["best of each club", "average of shots that are not all there", "in a column of numbers", "TrackMan",
         "how good a shot was"],
)  # fmt: skip
def test_only_the_shots_of_a_table_are_read(write, text, lines):
    assert launch_monitor.read(write(text)).rows.tolist() == lines


@pytest.mark.parametrize(
    ("label", "kind"), [("Max", "max"), ("Best", "max"), ("Worst", "min"), ("Total", "mean"), ("SD", "deviation")]
)
@pytest.mark.parametrize("place", [0, 1])
def test_where_nothing_numbers_the_shots_the_numbers_tell_a_summary_from_a_name(write, label, kind, place):
    rows = [["Driver", "Ann", str(speed), str(ball)] for speed, ball in zip(SPEEDS, (146.0, 144.0, 151.0), strict=True)]
    rows.append(["Driver", "Ann", *map(str, ROWS[kind])])
    rows[-1][place] = label
    head = "Club,Player,Club Speed (mph),Ball Speed (mph)\n"
    assert_left_out(launch_monitor.read(write(head + "\n".join(map(",".join, rows)) + "\n")))
    rows[-1][2] = "101.2"  # the ball speed alone may be so by chance
    assert len(launch_monitor.read(write(head + "\n".join(map(",".join, rows)) + "\n"))) == 4


@pytest.mark.parametrize("label", ["", "Trung bình", "ค่าเฉลี่ย", "Mittelding", "my numbers"])
def test_a_row_whose_numbers_are_averages_is_no_shot_whatever_it_is_called(write, label):
    head = "Club,Club Speed (mph),Ball Speed (mph),Launch Angle (deg),Spin (rpm),Carry (yd)\n"
    rows = ["Driver,100,146,12,2500,230", "Driver,98,143,13,2700,226", "Driver,102,150,11,2900,234"]
    mean = f"{label},100,146.3,12,2700,230"
    for at in (0, 2, 3):
        shots = launch_monitor.read(write(head + "\n".join([*rows[:at], mean, *rows[at:]]) + "\n"))
        assert_left_out(shots)
    shot = f"{label},101,148,11.2,2600,231"
    assert len(launch_monitor.read(write(head + "\n".join([*rows, shot]) + "\n"))) == 4


def test_a_summary_in_a_column_of_remarks_is_seen_though_some_shots_have_no_remark(write):
    speeds, remarks = (90.0, 91.0, 105.0, 92.0, 106.0, 93.0, 107.0), ("windy", "low", "", "high", "", "windy", "")
    rows = [f"Driver,{speed},{each},{1.47 * speed:.1f}" for speed, each in zip(speeds, remarks, strict=True)]
    rows.append(f",{sum(speeds) / 7:.2f},Average,{1.47 * sum(speeds) / 7:.1f}")
    shots = launch_monitor.read(write("\n".join(["Club,Club Speed (mph),Remark,Ball Speed (mph)", *rows]) + "\n"))
    assert len(shots) == 7
