"""``clubface monitor``: files to one table, layouts, and shots over a socket."""

import csv
import json
import os
import re
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from clubface import shots as launch_monitor
from clubface.jobs.lock import Lock
from clubface.shots.open_connect import Listener, Sender
from clubface.shots.reading import read_shots
from command_line import MAIN, assert_mistake, interruptible, press_ctrl_c

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

DATA = Path(__file__).parents[1] / "data" / "launch_monitors"
MPH = 0.44704


def test_a_file_becomes_one_table_and_its_rejected_rows_are_reported(clubface_, tmp_path):
    out, rejects = tmp_path / "shots.csv", tmp_path / "rejects.csv"
    ran = clubface_("monitor", "read", str(DATA / "trackman.csv"), "-o", str(out), "--rejects", str(rejects))
    assert ran.status == 0
    for message in ("1 Driver, 2 7 Iron", "3 rows rejected", "7     Club Path: 'x' is not a number"):
        assert message in ran.out
    assert f"wrote {rejects}, {out}" in ran.err
    assert read_shots(out).launches["ball_speed"][0] == pytest.approx(147.5 * MPH, rel=1e-14)
    with open(rejects, newline="") as file:
        assert [row["line"] for row in csv.DictReader(file)] == ["7", "8", "9"]


def test_the_document_says_what_was_read(clubface_):
    ran = clubface_("monitor", "read", str(DATA / "rapsodo.csv"), "--unit", "speed=m/s", "--hand", "left", "--json")
    tables = {name: each["rows"] for name, each in ran.json["tables"].items()}
    (session,) = tables["session"]
    assert (session["format"], session["shots"]) == ("rapsodo", 3)
    assert tables["clubs"] == [{"club": "d", "shots": 2}, {"club": "7i", "shots": 1}]
    (ball_speed,) = (each for each in tables["quantities"] if each["quantity"] == "ball_speed")
    assert (ball_speed["unit"], ball_speed["shots"]) == ("m/s", 3)
    assert ball_speed["mean"] == pytest.approx((142.4 + 141 + 111.5) / 3)
    assert tables["rejected"] == [{"line": 11, "reason": "7 cells where there are 18 columns"}]


def test_club_data_is_referred_to_the_clubs_that_are_named(clubface_, tmp_path):
    measured = clubface_("monitor", "read", str(DATA / "foresight-play.csv"), "--json").json
    path = str(tmp_path / "shots.csv")
    ran = clubface_(
        "monitor", "read", str(DATA / "foresight-play.csv"), "--club", "Driver=driver", "-o", path, "--json"
    )
    assert [each["club"] for each in ran.notes("referred-motion")] == ["driver"]
    before, after = (
        next(row["mean"] for row in each["tables"]["quantities"]["rows"] if row["quantity"] == "path")
        for each in (measured, ran.json)
    )
    # One of the two is a driver: closing at 2600 deg/s its face centre moves some 2 deg more to the left.
    assert after - before == pytest.approx(0.5 * np.degrees(np.radians(2600) * 0.0408 / (102.5 * MPH)), abs=0.1)
    both = clubface_("monitor", "read", str(DATA / "foresight-play.csv"), "--club", "driver", "--club", "7-iron")
    assert_mistake(both, "--club is '7-iron'", "NAME=CLUB")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("read", "missing.csv"), ("missing.csv", "cannot be read")),
        (("read", str(DATA / "trackman.csv"), "--format", "garmins"), ("did you mean garmin",)),
        (("read", str(DATA / "trackman.csv"), "--unit", "speed"), ("--unit is 'speed'", "name=value")),
        (("read", str(DATA / "trackman.csv"), "-o", str(DATA / "trackman.csv")), ("a file other than the inputs",)),
        (
            ("read", str(DATA / "trackman.csv"), "--rejects", str(DATA / "trackman.csv")),
            ("a file other than the inputs",),
        ),
        (("read", str(DATA / "trackman.csv"), "-o", "x.csv", "--rejects", "./x.csv"), ("than the output",)),
        (("formats", "garmins"), ("did you mean garmin",)),
        (("listen", "--port", "70000"), ("from 0 to 65535",)),
        (("listen", "--timeout", "5 mph"), ("timeout", "not a speed")),
        (("listen", "-o", str(DATA / "trackman.csv")), ("exists already",)),
        (("send", str(DATA / "rapsodo.csv"), "--shot", "2:9"), ("--shot is '2:9'", "from 1 to 3")),
        (("send", str(DATA / "rapsodo.csv"), "--port", "1"), ("127.0.0.1:1 cannot be reached",)),
    ],
)
def test_a_mistake_is_one_message(clubface_, arguments, words):
    assert_mistake(clubface_("monitor", *arguments), *words)


def test_layouts_are_listed_and_shown(clubface_):
    listed = clubface_("monitor", "formats", "--json").json["tables"]["formats"]["rows"]
    names = [each["name"] for each in listed]
    assert names == ["trackman", "foresight", "foresight-2020", "garmin", "rapsodo", "flightscope", "gspro", "square"]
    text = clubface_("monitor", "formats").out
    assert all(name in text for name in names)
    shown = clubface_("monitor", "formats", "garmin")
    assert "Schwungbahn" in shown.out
    columns = clubface_("monitor", "formats", "garmin", "--json").json["tables"]["columns"]["rows"]
    assert [each["positive"] for each in columns if each["quantity"] == "sidespin"] == ["left"]


def test_shots_of_a_table_are_sent_and_refusals_are_reported(clubface_):
    heard = []
    with Listener(0) as listener:
        thread = threading.Thread(target=lambda: heard.extend(listener.messages()))
        thread.start()
        try:
            ran = clubface_("monitor", "send", str(DATA / "foresight-play.csv"), "--port", str(listener.port))
            one = clubface_("monitor", "send", str(DATA / "rapsodo.csv"), "--port", str(listener.port), "--shot", "3")
        finally:
            listener.stop()
            thread.join(5)
    assert (ran.status, one.status) == (2, 0)
    assert ran.out.count(": 200 Shot received successfully") == 3
    assert "shot 4 has no ball speed or launch angle: not sent" in ran.err
    assert "1 of 4 shots were not accepted" in ran.err
    assert [each.shot_number for each in heard] == [1, 2, 3, 1]
    assert heard[0].delivery["toe"] == pytest.approx(0.0085, rel=1e-12)
    assert heard[3].launch["ball_speed"] == pytest.approx(111.5 * MPH, rel=1e-12)


def test_a_backspin_and_its_axis_are_sent_as_the_whole_vector(clubface_, tmp_path, monkeypatch):
    """2650 rpm at 40 degrees are 3459 rpm in all, 2224 rpm to the right."""
    monkeypatch.setattr("clubface.support.checks._given", {})
    (tmp_path / "shots.csv").write_text(
        "club,ball_speed_mph,launch_deg,azimuth_deg,backspin_rpm,spin_axis_deg\ndriver,143.1,13.4,1.9,2650,40\n"
        "driver,143.1,13.4,1.9,2650,\ndriver,143.1,13.4,1.9,,40\ndriver,143.1,13.4,1.9,2650,0\n"
    )
    heard = []
    with Listener(0) as listener:
        thread = threading.Thread(target=lambda: heard.extend(listener.messages()))
        thread.start()
        try:
            ran = clubface_("monitor", "send", str(tmp_path / "shots.csv"), "--port", str(listener.port))
        finally:
            listener.stop()
            thread.join(5)
    assert (ran.status, len(heard)) == (2, 3)
    assert "shot 3: spin_axis is 40 deg" in ran.err  # which says nothing of how much the ball spins
    spins = {name: value * 30 / np.pi for name, value in heard[0].launch.items() if name.endswith("spin")}
    assert spins == pytest.approx({"total_spin": 3459.3, "sidespin": 2223.6, "backspin": 2650.0}, abs=0.1)
    assert "sidespin is unknown" in ran.err  # of the second shot: the message must hold a number for it


def test_a_listening_process_keeps_every_shot_and_ends_on_an_interrupt(tmp_path):
    path = tmp_path / "live.csv"
    child = interruptible(
        [sys.executable, "-c", MAIN, "monitor", "listen", "--port", "0", "-o", str(path), "--json", "--hand", "left"]
    )
    try:
        port = int(re.search(r":(\d+);", child.stderr.readline())[1])
        with Sender(port, timeout=10) as sender:
            for speed in (60.0, 70.0):
                assert sender.send({"ball_speed": speed, "launch": 0.2, "backspin": 250.0}, {"speed": 45.0}).was_taken
                assert json.loads(child.stdout.readline())["ball_speed"] == pytest.approx(speed, rel=1e-12)
            wrong = {"ball_speed": 65.0, "launch": 0.2, "backspin": 95_000 * np.pi / 30}
            for _ in range(2):
                assert sender.send(wrong, {"speed": 45.0}).was_taken
                assert "total_spin" not in json.loads(child.stdout.readline())
            assert sender.player["Handed"] == "LH"
        shots = read_shots(path)
        press_ctrl_c(child)
        _, message = child.communicate(timeout=20)
    finally:
        child.kill()
    assert shots.launches["ball_speed"] == pytest.approx([60, 70, 65, 65], rel=1e-12)
    assert np.isnan(shots.launches["total_spin"]).tolist() == [False, False, True, True]
    assert shots.hand.tolist() == ["left"] * 4
    assert child.returncode == 130
    assert "clubface: shot 3: no shot can have total_spin of 95000 rpm" in message
    assert message.count(": no shot can have") == 1  # the next shot has the same value, which is not told again
    assert "total spin 95000 rpm in 2 of 4 shots" in message
    assert f"clubface: interrupted: 4 shots in {path}" in message


def test_listening_ends_after_so_many_shots_or_so_long(clubface_):
    assert "0 shots" in clubface_("monitor", "listen", "--port", "0", "--timeout", "0.1 s").err


@pytest.mark.parametrize("ending", ["csv", "parquet"])
def test_a_file_named_like_an_unfinished_output_is_read_and_not_touched(clubface_, tmp_path, ending):
    path, target = tmp_path / f"range.part.{ending}", tmp_path / f"range.{ending}"
    launch_monitor.read(DATA / "rapsodo.csv").write(path)
    before = path.read_bytes()
    assert clubface_("monitor", "read", str(path), "-o", str(target)).status == 0
    assert path.read_bytes() == before
    assert len(read_shots(target)) == len(read_shots(path))


def test_a_listener_finds_a_missing_folder_and_another_listener_at_the_start(clubface_, tmp_path):
    listen = ("monitor", "listen", "--port", "0", "--timeout", "0.1 s", "-o")
    missing = clubface_(*listen, str(tmp_path / "none" / "live.csv"))
    assert_mistake(missing, "--output")
    assert "a file in a folder that exists" in missing.err
    path = tmp_path / "live.csv"
    lock = Lock(tmp_path / "live.csv.lock", path)
    ran = clubface_(*listen, str(path))
    assert_mistake(ran)
    assert f"live.csv: process {os.getpid()} is writing this" in ran.err
    lock.close()
    assert clubface_(*listen, str(path)).status == 0
    assert list(tmp_path.iterdir()) == []


def test_a_shot_that_a_full_disk_does_not_take_is_not_acknowledged(tmp_path, monkeypatch, capsys):
    from clubface.cli.app import run

    def full(handle):
        raise OSError(28, os.strerror(28))

    monkeypatch.setattr(os, "fsync", full)
    path, ended = tmp_path / "live.csv", []
    ports = []
    init = Listener.__init__

    def recorded_call(self, *arguments, **options):
        init(self, *arguments, **options)
        ports.append(self.port)

    monkeypatch.setattr(Listener, "__init__", recorded_call)
    listen = ["monitor", "listen", "--port", "0", "--timeout", "10 s", "-o", str(path)]
    thread = threading.Thread(target=lambda: ended.append(run(listen)))
    thread.start()
    while not ports:
        time.sleep(0.01)
    with Sender(ports[0], timeout=10) as sender:
        answer = sender.send({"ball_speed": 60.0, "launch": 0.2})
    thread.join(10)
    assert not answer.was_taken
    assert ended == [2]
    assert "live.csv: cannot be written: No space left on device" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
