"""Live shots: on the disk before anyone sees them, whatever ends the process; computed values marked."""

import json
import math
import socket
import time
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, strategies as st

import clubface
from clubface.errors import FileError, UnknownNameError
from clubface.shots.live import LiveShots, Player, live_result
from clubface.shots.live_links import LiveLinks
from clubface.shots.messages import Message, shot_message
from clubface.shots.shot_list import shot_list_result

LAUNCH = {"ball_speed": 65.0, "launch": 0.22, "azimuth": 0.01, "backspin": 280.0, "sidespin": -30.0}
DELIVERY = {"speed": 45.0, "attack": -0.02, "path": 0.03, "loft": 0.22}


def message(number=1, launch=LAUNCH, delivery=DELIVERY, device="radar", identity=""):
    raw = Message(kind="shot", device=device, shot_number=number, delivery=delivery, launch=launch, identity=identity)
    return shot_message(raw)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "live.jsonl"


def opened(path):
    return LiveShots(path)


def test_shots_are_there_again_after_the_end_of_the_process(path):
    live = opened(path)
    live.keep(message(1), "open-connect")
    live.choose("7-iron", "left")
    live.keep(message(2, launch={}), "flight-relay")
    before = live.shots
    live.close()
    again = opened(path)
    assert again.shots == before
    assert [(each.number, each.protocol, each.player) for each in again.shots] == [
        (1, "open-connect", Player()), (2, "flight-relay", Player("7-iron", "left"))
    ]  # fmt: skip
    assert again.player == Player("7-iron", "left")
    assert again.keep(message(3), "open-connect").number == 3
    again.close()


def test_a_shot_is_on_the_disk_before_it_is_shown(path):
    live = opened(path)
    seen = []
    live.subscribe(lambda: seen.append((len(live.shots), len(path.read_bytes().splitlines()))))
    live.keep(message(1), "open-connect")
    live.keep(message(2), "open-connect")
    assert seen == [(1, 1), (2, 2)]
    live.close()


def test_a_shot_that_cannot_be_written_is_not_shown(path, monkeypatch):
    live = opened(path)
    live.keep(message(1), "open-connect")

    def full(handle):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("clubface.shots.live.os.fsync", full)
    with pytest.raises(FileError, match="No space left"):
        live.keep(message(2), "open-connect")
    monkeypatch.undo()
    assert len(live.shots) == 1
    assert live.keep(message(2), "open-connect").number == 2
    live.close()
    assert [json.loads(line)["shot_number"] for line in path.read_text().splitlines()] == [1, 2]


@given(cut=st.integers(1, 300))
def test_only_a_truncated_last_line_is_removed(tmp_path, cut):
    path = tmp_path / "cut.jsonl"
    path.unlink(missing_ok=True)
    live = opened(path)
    live.keep(message(1), "open-connect")
    whole = path.read_bytes()
    live.keep(message(2), "open-connect")
    live.close()
    content = path.read_bytes()
    path.write_bytes(content[: max(len(content) - cut, len(whole))])
    again = opened(path)
    assert [each.message.shot_number for each in again.shots] == [1]
    assert path.read_bytes() == whole
    again.keep(message(3), "open-connect")
    again.close()
    assert [json.loads(line)["shot_number"] for line in path.read_text().splitlines()] == [1, 3]


@pytest.mark.parametrize("line", ["{}", "[1]", "x", '{"club": "spoon", "hand": "right"}', '"text"', "null", "1e999"])
def test_a_damaged_line_is_skipped_and_kept_in_the_file(path, line):
    live = opened(path)
    live.keep(message(1), "open-connect")
    live.close()
    path.write_text(path.read_text() + line + "\n" + path.read_text().replace('"shot_number": 1', '"shot_number": 2'))
    again = opened(path)
    assert [each.message.shot_number for each in again.shots] == [1, 2]
    assert again.damaged == [2]
    again.close()
    assert line in path.read_text()


def test_a_line_with_an_unknown_quantity_is_damaged(path):
    live = opened(path)
    live.keep(message(1), "open-connect")
    live.keep(message(2), "open-connect")
    live.close()
    path.write_text(path.read_text().replace('"ball_speed"', '"ball_sped"', 1))
    again = opened(path)
    assert ([each.message.shot_number for each in again.shots], again.damaged) == ([2], [1])
    again.close()


@pytest.mark.parametrize("content", [b"club,ball\n1,2\n", b"\x00\x01\n", b"PK\x03\x04", b"x"])
def test_a_file_of_something_else_is_left_as_it_is(path, content):
    path.write_bytes(content)
    with pytest.raises(FileError, match="not a file of live shots"):
        opened(path)
    assert path.read_bytes() == content


def test_two_processes_do_not_write_one_file(path):
    live = opened(path)
    with pytest.raises(FileError, match="is writing this"):
        opened(path)
    live.close()
    opened(path).close()


def test_a_shot_that_is_sent_again_is_one_shot(path):
    live = opened(path)
    assert live.keep(message(7), "open-connect").number == 1
    assert live.keep(message(7), "open-connect") is None
    assert live.keep(message(7, LAUNCH | {"launch": 0.2}), "open-connect").number == 2
    assert live.keep(message(7, device="other"), "open-connect").number == 3
    assert live.keep(message(0), "opengolfsim").number == 4
    assert live.keep(message(0), "opengolfsim").number == 5  # without numbers, two alike are two
    assert live.keep(message(1, identity="a"), "flight-relay").number == 6
    assert live.keep(message(2, identity="a"), "flight-relay") is None
    live.close()
    again = opened(path)
    assert again.keep(message(3, identity="a"), "flight-relay") is None
    again.close()


def test_another_club_must_be_one(path):
    live = opened(path)
    with pytest.raises(UnknownNameError, match="did you mean driver"):
        live.choose("drivr", "right")
    with pytest.raises(UnknownNameError, match="hand"):
        live.choose("driver", "both")
    assert path.read_bytes() == b""
    live.close()


def rows_of(result):
    return result.to_dict()["tables"]["shots"]["rows"]


def test_computed_values_are_marked_and_measured_ones_kept(path):
    live = opened(path)
    live.keep(message(1, LAUNCH | {"carry": 200.0}), "open-connect")
    live.choose("driver", "right")
    live.keep(message(2, launch={}), "flight-relay")
    measured, computed = rows_of(live_result(live.shots))
    assert measured["carry_m"] == 200.0
    assert measured["computed"] == "side apex landing_angle flight_time"
    assert measured["ball_speed_mps"] == 65.0
    launch = clubface.impact("driver", DELIVERY)
    assert computed["ball_speed_mps"] == pytest.approx(launch.ball_speed, rel=1e-12)
    assert computed["computed"].split()[:3] == ["ball_speed", "launch", "azimuth"]
    assert {"carry", "total"} <= set(computed["computed"].split())
    assert computed["carry_m"] == pytest.approx(clubface.fly(launch).carry, rel=1e-12)
    assert not {"speed", "path"} & set(computed["computed"].split())
    assert (measured["shot"], computed["shot"]) == (1, 2)
    live.close()


def test_flight_paths_lead_from_the_ball_to_the_landing(path):
    live = opened(path)
    live.keep(message(1), "open-connect")
    points = live_result(live.shots).to_dict()["tables"]["paths"]["rows"]
    flight = clubface.fly(LAUNCH)
    assert points[0] == {"shot": 1, "along_m": 0.0, "height_m": 0.0, "side_m": 0.0}
    # The path has more and shorter steps: the carry of a drive is within 0.1 mm of the limit of both.
    assert math.hypot(points[-1]["along_m"], points[-1]["side_m"]) == pytest.approx(flight.carry, abs=1e-4)
    assert points[-1]["side_m"] == pytest.approx(flight.side, abs=1e-4)
    # 31 points miss the top by at most the fall in half a step of a sixtieth of the flight.
    drop = 0.5 * 9.81 * (flight.flight_time / 60) ** 2
    assert flight.apex - drop < max(each["height_m"] for each in points) <= flight.apex + 1e-4
    live.close()


def test_shots_that_miss_something_of_the_launch_have_no_flight_path(path):
    live = opened(path)
    live.keep(message(1, {"ball_speed": 60.0, "launch": 0.2}, {}), "open-connect")
    live.keep(message(2), "open-connect")
    result = live_result(live.shots).to_dict()
    assert {each["shot"] for each in result["tables"]["paths"]["rows"]} == {2}
    (lacking,) = [each for each in result["notes"] if each["code"] == "shots-without-path"]
    assert lacking["data"] == {"without": 1, "shots": 2}
    live.close()


def test_club_data_of_an_unknown_club_gives_no_launch(path):
    live = opened(path)
    live.keep(message(1, launch={}), "open-connect")
    from clubface.shots.live import live_shots

    shots = replace(live_shots(live.shots), clubs=np.array(["my own club"], dtype=object))
    (row,) = rows_of(shot_list_result(shots))
    assert "ball_speed_mps" not in row
    assert row["computed"] == ""
    live.close()


def test_dropped_fields_are_remarked_once_over_every_protocol(path):
    pytest.importorskip("websockets")
    from websockets.sync.client import connect

    live = opened(path)
    links = LiveLinks(live, listen={"open-connect": 0}, flight_relay=0)
    try:
        open_connect, relay = (int(each.address.rpartition(":")[2]) for each in links.states)
        ball = {"Speed": 120, "HLA": 0, "VLA": 12, "TotalSpin": 99_999_999, "SpinAxis": 1, "CarryDistance": 100}
        sent = {"DeviceID": "radar", "Units": "furlongs", "BallData": ball}
        with socket.create_connection(("127.0.0.1", open_connect), 5) as monitor:
            for number in (1, 2):
                monitor.sendall(json.dumps(sent | {"ShotNumber": number}).encode())
                assert json.loads(monitor.recv(4096))["Code"] == 200
        with connect(f"ws://127.0.0.1:{relay}/frp") as device:
            for number in (3, 4):
                key = {"shot_id": str(number), "shot_number": number}
                ball = {"launch_speed": "50mps", "max_height": "3", "backspin_rpm": 99_999_999}
                for event in ({"kind": "ball_flight", "key": key, "ball": ball}, {"kind": "shot_finished", "key": key}):
                    device.send(json.dumps({"device": "camera", "event": event}))
            ends = time.monotonic() + 10.0
            while len(live.shots) < 4 and time.monotonic() < ends:
                time.sleep(0.01)
    finally:
        links.close()
        live.close()
    texts = [each.text for each in links.remarks if each.text.startswith("shot ")]
    words = ["shot 1: no shot can have total_spin", "shot 1: Units", "shot 3: no shot can have backspin"]
    assert len(texts) == 4
    for text, start in zip(texts, [*words, "shot 3: ball.max_height"], strict=True):
        assert text.startswith(start)
