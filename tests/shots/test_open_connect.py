"""GSPro Open Connect: messages, and both sides of the socket on the loopback."""

import contextlib
import json
import math
import socket
import threading
import time
from contextlib import ExitStack, contextmanager

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import clubface
from attached_notes import codes, noted
from clubface.errors import InputError, LinkError, UnknownNameError
from clubface.shots import open_connect
from clubface.shots.messages import LARGEST, Broken, ObjectStream
from clubface.shots.open_connect import Listener, MessageError, Sender, from_json, recorded, to_json
from clubface.simulation.spin import SPINS

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

MPH, DEG, RPM = 0.44704, math.pi / 180, math.pi / 30
SHOT = {
    "DeviceID": "radar",
    "Units": "Yards",
    "ShotNumber": 13,
    "APIversion": "1",
    "BallData": {"Speed": 147.5, "SpinAxis": -13.2, "TotalSpin": 3250.0, "BackSpin": 1.0, "SideSpin": 2.0, "HLA": 2.3}
    | {"VLA": 14.3, "CarryDistance": 256.5},
    "ClubData": {"Speed": 100.0, "AngleOfAttack": -1.5, "FaceToTarget": 1.25, "Lie": 0.5, "Loft": 14.0, "Path": -2.5}
    | {"SpeedAtImpact": 101.0, "VerticalFaceImpact": 4.0, "HorizontalFaceImpact": -8.0, "ClosureRate": 2500.0},
    "ShotDataOptions": {"ContainsBallData": True, "ContainsClubData": True, "LaunchMonitorIsReady": True}
    | {"LaunchMonitorBallDetected": False, "IsHeartBeat": False},
}
HEARTBEAT = SHOT | {"ShotNumber": 0, "ShotDataOptions": {"IsHeartBeat": True, "LaunchMonitorIsReady": True}}


def changed(message=SHOT, **parts):
    return message | {name: message[name] | part if isinstance(part, dict) else part for name, part in parts.items()}


def test_a_message_is_a_shot_in_si():
    result = from_json(SHOT)
    assert (result.kind, result.device, result.shot_number, result.is_ready, result.sees_ball) == (
        "shot", "radar", 13, True, False
    )  # fmt: skip
    expected = {"ball_speed": 147.5 * MPH, "launch": 14.3 * DEG, "azimuth": 2.3 * DEG, "carry": 256.5 * 0.9144}
    expected |= {"spin_axis": -13.2 * DEG, "total_spin": 3250 * RPM}
    # Total spin and axis are what the protocol requires; backspin and sidespin, here of another ball, follow from them.
    expected |= {"backspin": 3250 * RPM * math.cos(13.2 * DEG), "sidespin": -3250 * RPM * math.sin(13.2 * DEG)}
    assert result.notes[0].code == "spins-contradict"
    assert result.launch == pytest.approx(expected, rel=1e-14)
    assert result.delivery == pytest.approx(
        {"speed": 100 * MPH, "attack": -1.5 * DEG, "face": 1.25 * DEG, "lie": 0.5 * DEG, "loft": 14 * DEG}
        | {"path": -2.5 * DEG, "high": 0.004, "toe": -0.008, "closure": 2500 * DEG},
        rel=1e-14,
    )
    metres = from_json(SHOT | {"Units": "Meters"})
    assert metres.launch["carry"] == 256.5


def test_spin_may_come_as_its_parts_and_zeros_mean_not_measured():
    ball = {"Speed": "147.5", "HLA": 0, "VLA": 14, "BackSpin": 2500, "SideSpin": -800, "CarryDistance": 0}
    club = dict.fromkeys(SHOT["ClubData"], 0.0)
    result = from_json(SHOT | {"BallData": ball, "ClubData": club})
    assert set(result.launch) == {"ball_speed", "azimuth", "launch", "backspin", "sidespin", "total_spin", "spin_axis"}
    assert result.delivery == {}
    result = from_json(SHOT | {"BallData": ball, "ClubData": club | {"Path": 2.0}})
    assert set(result.delivery) == {"attack", "face", "lie", "path"}
    shots = recorded([result, from_json(HEARTBEAT)], hand="left")
    assert (len(shots), shots.format, shots.hand.tolist()) == (1, "open-connect", ["left"])
    assert shots.launches["spin_axis"][0] == pytest.approx(-math.atan2(800, 2500), rel=1e-14)


@pytest.mark.parametrize(
    ("message", "words"),
    [
        ({}, "ShotDataOptions is missing"),
        (SHOT | {"ShotDataOptions": [1]}, "ShotDataOptions must be an object"),
        (changed(ShotDataOptions={"IsHeartBeat": 1}), "IsHeartBeat must be true or false"),
        (SHOT | {"DeviceID": 5}, "DeviceID must be a text"),
        (SHOT | {"APIversion": "2"}, "APIversion is '2'; it must be '1'"),
        (SHOT | {"ShotNumber": None}, "ShotNumber is missing"),
        (SHOT | {"ShotNumber": -1}, "ShotNumber must be 0 or more"),
        (SHOT | {"BallData": None, "ClubData": {}}, "BallData is missing"),
        (SHOT | {"ClubData": [1]}, "ClubData must be an object"),
        (changed(BallData={"VLA": None}), "BallData.VLA is missing"),
        (changed(BallData={"VLA": "high"}), "BallData.VLA must be a number"),
        (changed(BallData={"VLA": True}), "BallData.VLA must be a number"),
        (changed(BallData={"VLA": 1e300}), "BallData.VLA must be a number"),
        (changed(BallData={"Speed": 0}), "BallData.Speed must be above 0"),
        (
            changed(ShotDataOptions={"ContainsBallData": False}, ClubData=dict.fromkeys(SHOT["ClubData"], 0)),
            "but zeros",
        ),
    ],
)
def test_an_invalid_message_names_the_field(message, words):
    with pytest.raises(MessageError, match=words):
        from_json(message)


@pytest.mark.parametrize("value", ["", " ", "n/a", "12,3", "1_000", [], {}, True, math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("name", ["Speed", "Lie", "ClosureRate"])
def test_a_club_field_without_a_number_is_dropped_and_the_shot_kept(name, value):
    whole, result = from_json(SHOT), from_json(changed(ClubData={name: value}))
    quantity = {"Speed": "speed", "Lie": "lie", "ClosureRate": "closure"}[name]
    assert result.launch == whole.launch
    assert result.delivery == {each: number for each, number in whole.delivery.items() if each != quantity}
    (field,) = (each for each in result.notes if each.code == "message-field-no-number")
    assert field.data["field"] == f"ClubData.{name}"
    assert field.of(in_shots=1, of_shots=2) in recorded([whole, result]).notes


@pytest.mark.parametrize("value", [-1, -999, 16777215, 65535, 9999, 3.4e38, "65535"])
def test_a_placeholder_value_is_dropped_and_noted(value):
    result = from_json(changed(ClubData={"Speed": value, "VerticalFaceImpact": value if value != -1 else 9999}))
    assert not {"speed", "high"} & set(result.delivery)
    assert "high" in result.impossible
    assert "speed" in result.impossible or noted(result, "message-speed-negative") == [{"value": value}]
    assert result.delivery["path"] == from_json(SHOT).delivery["path"]


def test_numbers_as_texts_are_numbers():
    texts = changed(BallData={"Speed": "147.5", "SpinAxis": "-13.2"}, ClubData={"Lie": "0.5", "Path": " -2.5"})
    assert (from_json(texts).launch, from_json(texts).delivery) == (from_json(SHOT).launch, from_json(SHOT).delivery)


@pytest.mark.parametrize("name", ["BallData", "ClubData"])
@pytest.mark.parametrize("missing", [{}, None])
def test_missing_ball_or_club_data_leave_the_other_part(name, missing):
    message = {each: part for each, part in SHOT.items() if each != name} | ({name: None} if missing is None else {})
    result, whole = from_json(message), from_json(SHOT)
    kept = "delivery" if name == "BallData" else "launch"
    assert getattr(result, kept) == getattr(whole, kept)
    assert result.launch == {} or result.delivery == {}
    assert ("message-part-missing", {"part": name}) in result.notes


def test_without_options_a_message_is_a_shot_of_what_it_holds():
    bare = {name: part for name, part in SHOT.items() if name != "ShotDataOptions"}
    assert from_json(bare).launch == from_json(SHOT).launch
    assert from_json(bare | {"ShotDataOptions": None, "ClubData": None}).delivery == {}
    with pytest.raises(MessageError, match="ShotDataOptions"):
        from_json(bare | {"BallData": None, "ClubData": None})


def test_a_carry_in_an_unknown_unit_is_ignored():
    assert from_json(SHOT | {"Units": None}).launch["carry"] == from_json(SHOT).launch["carry"]
    for units in ("Feet", "", 3, ["Yards"]):
        result = from_json(SHOT | {"Units": units})
        assert "carry" not in result.launch
        assert "message-units" in codes(result)


@pytest.mark.parametrize(
    ("spin", "expected"),
    [
        ({"BackSpin": 2650, "SpinAxis": 40}, {"total_spin": 3459 * RPM, "sidespin": 2224 * RPM}),
        ({"TotalSpin": 3000, "SpinAxis": 352.5}, {"spin_axis": -7.5 * DEG, "sidespin": -391.6 * RPM}),
        ({"TotalSpin": 0, "SpinAxis": 0, "BackSpin": 2500, "SideSpin": -800}, {"spin_axis": -math.atan2(800, 2500)}),
        ({"TotalSpin": 2600, "SpinAxis": 5, "BackSpin": 0, "SideSpin": 0}, {"backspin": 2590 * RPM}),
        ({"TotalSpin": 2600}, {"sidespin": None, "backspin": None}),
        ({"TotalSpin": 2600, "BackSpin": 2500}, {"sidespin": None, "backspin": 2500 * RPM}),
        ({"TotalSpin": 2400, "BackSpin": 2500}, {"total_spin": None, "backspin": None}),
        ({"TotalSpin": 2400, "SpinAxis": ""}, {"spin_axis": None, "total_spin": 2400 * RPM}),
        ({}, dict.fromkeys(SPINS)),
    ],
)  # fmt: skip
def test_the_spins_of_a_message_are_one_consistent_vector(spin, expected):
    ball = {name: value for name, value in SHOT["BallData"].items() if "Spin" not in name}
    result = from_json(SHOT | {"BallData": ball | spin})
    for name, value in expected.items():
        # The rounded numbers are those of a screen; others follow to rounding.
        assert result.launch.get(name) == (value if value is None else pytest.approx(value, rel=2e-4)), name
    assert result.launch["ball_speed"] == 147.5 * MPH


def test_a_field_without_a_number_is_reported_once_over_the_socket():
    spoiled = json.dumps(changed(BallData={"BackSpin": None}, ClubData={"Lie": math.nan, "Loft": ""})).encode()
    assert b"NaN" in spoiled
    with listening() as (listener, heard, messages), raw(listener.port) as (client, answers):
        client.sendall(spoiled + spoiled)
        assert [each["Code"] for each in answers(2)] == [200, 200]
        wait_for(lambda: len(heard) == 2)
    assert all("lie" not in each.delivery and each.launch["ball_speed"] for each in heard)
    for name in ("Lie", "Loft"):
        assert sum(f"ClubData.{name}" in each for each in messages) == 1


def test_impossible_values_are_dropped_when_the_shot_arrives():
    polar = {"BackSpin": None, "SideSpin": None}
    result = from_json(
        changed(BallData=polar | {"TotalSpin": -21474836480, "CarryDistance": 900}, ClubData={"Speed": 500})
    )
    assert set(result.impossible) == {"total_spin", "carry", "speed"}
    assert set(result.launch) == {"ball_speed", "launch", "azimuth", "spin_axis"}
    assert "speed" not in result.delivery
    assert result.delivery["path"] == pytest.approx(-2.5 * DEG, rel=1e-14)
    # The limits are those of files: a table of the same numbers loses the same values.
    shots = recorded([result, *(from_json(changed(BallData=polar, ClubData=club)) for club in ({}, {"Speed": 300}))])
    examples = {"speed": (2, 500 * MPH), "total_spin": (1, -21474836480 * RPM), "carry": (1, 900 * 0.9144)}
    for each, (name, (wrong, value)) in zip(noted(shots, "impossible-values"), examples.items(), strict=True):
        assert each == {"example": {name: pytest.approx(value)}, "wrong": wrong, "shots": 3}
    assert np.isnan(shots.launches["total_spin"][0])
    nothing = {"Speed": 999, "HLA": 170, "VLA": 95, "TotalSpin": 0, "SpinAxis": 999, "CarryDistance": 900}
    alone = changed(BallData=polar | nothing, ShotDataOptions={"ContainsClubData": False})
    with pytest.raises(MessageError, match="no shot can have such values: ball_speed, spin_axis, total_spin, azimuth"):
        from_json(alone)
    still = {"Speed": 147.5, "HLA": 0, "VLA": 14, "BackSpin": 0, "SideSpin": 0}
    assert set(from_json(SHOT | {"BallData": still}).impossible) == {"backspin", "sidespin"}


def test_a_launch_becomes_a_message_and_comes_back():
    launch = clubface.impact("driver", speed="108 mph", attack="2 deg", loft="13 deg", face="1 deg", toe="8 mm")
    result = from_json(json.loads(json.dumps(to_json(launch, shot_number=3))))
    assert result.shot_number == 3
    for name, value in result.launch.items():
        # The protocol has no spin about the direction of launch: its total is that of backspin and sidespin.
        expected = math.hypot(launch.backspin, launch.sidespin) if name == "total_spin" else getattr(launch, name)
        assert value == pytest.approx(expected, rel=1e-13), name
    for name, value in result.delivery.items():
        assert value == pytest.approx(launch.delivery[name], rel=1e-13), name
    assert {"ball_speed", "launch", "azimuth", *SPINS} == set(result.launch)
    given = from_json(to_json({"ball_speed": "150 mph", "launch": "12 deg"}, shot_number=1))
    assert given.launch == pytest.approx({"ball_speed": 150 * MPH, "launch": 12 * DEG, "azimuth": 0})
    assert given.impossible == {"total_spin": 0.0}  # the message must have a number, and no ball leaves without spin
    parts = {"backspin": 300.0, "sidespin": -40.0}
    given = from_json(to_json({"ball_speed": 60.0, "launch": 0.2, **parts}, shot_number=1))
    assert given.launch["spin_axis"] == pytest.approx(-math.atan(40 / 300), rel=1e-13)
    assert given.launch["total_spin"] == pytest.approx(math.hypot(300, 40), rel=1e-13)
    for launch, name in (
        ({"launch": 0.2}, "ball_speed"),
        ({"ball_speed": 60.0}, "launch"),
        ({"ball_speed": "x"}, "ball"),
    ):
        with pytest.raises(InputError, match=name):
            to_json(launch, shot_number=1)


def test_the_spin_is_sent_both_as_parts_and_as_total_with_axis():
    # A drive off the toe: it starts right and turns left, so the axis is tilted to the left, which is negative.
    launch = clubface.impact("driver", speed="108 mph", attack="2 deg", loft="13 deg", toe="12 mm")
    assert launch.sidespin < 0.0 < launch.azimuth
    ball = to_json(launch, shot_number=1)["BallData"]
    assert ball == pytest.approx(
        {
            "Speed": launch.ball_speed / MPH, "VLA": launch.launch / DEG, "HLA": launch.azimuth / DEG,
            "BackSpin": launch.backspin / RPM, "SideSpin": launch.sidespin / RPM,
            "TotalSpin": math.hypot(launch.backspin, launch.sidespin) / RPM, "SpinAxis": launch.spin_axis / DEG,
        },
        rel=1e-12,  # conversions round two or three times
    )  # fmt: skip
    # 3000 rpm at 30 deg to the right: back 3000 cos 30, side 3000 sin 30; 4000 and -3000: 5000 at -36.87 deg.
    start = {"ball_speed": 60.0, "launch": 0.2}
    ball = to_json(start | {"total_spin": "3000 rpm", "spin_axis": "30 deg"}, shot_number=1)["BallData"]
    assert (ball["BackSpin"], ball["SideSpin"]) == pytest.approx((2598.0762113533, 1500.0), rel=1e-12)
    ball = to_json(start | {"backspin": "4000 rpm", "sidespin": "-3000 rpm"}, shot_number=1)["BallData"]
    assert (ball["TotalSpin"], ball["SpinAxis"]) == pytest.approx((5000.0, -36.869897645844), rel=1e-12)


def test_the_delivery_is_sent_in_the_units_of_the_protocol():
    given = {
        "speed": 50.0, "attack": 0.02, "face": -0.03, "lie": 0.01, "loft": 0.2, "path": 0.04, "high": 0.005,
        "toe": -0.008, "closure": 40.0,
    }  # fmt: skip
    club = to_json({"ball_speed": 60.0, "launch": 0.2}, given, shot_number=1)["ClubData"]
    assert club == pytest.approx(
        {
            "Speed": 50.0 / MPH, "AngleOfAttack": 0.02 / DEG, "FaceToTarget": -0.03 / DEG, "Lie": 0.01 / DEG,
            "Loft": 0.2 / DEG, "Path": 0.04 / DEG, "VerticalFaceImpact": 5.0, "HorizontalFaceImpact": -8.0,
            "ClosureRate": 40.0 / DEG, "SpeedAtImpact": 0.0,
        },
        rel=1e-12,
    )  # fmt: skip


def test_objects_are_found_wherever_the_bytes_are_cut():
    texts = [json.dumps(SHOT), '{"a": "}{\\"", "b": {"c": []}}', json.dumps(HEARTBEAT, indent=2)]
    data = (texts[0] + texts[1] + "\r\n\x00 " + texts[2]).encode()
    expected = [json.loads(text) for text in texts]
    for size in (1, 2, 7, 100, len(data)):
        stream = ObjectStream()
        result = [each for start in range(0, len(data), size) for each in stream.feed(data[start : start + size])]
        assert result == expected
        assert not stream.is_partial
    for cut in range(1, len(data), 13):
        stream = ObjectStream()
        assert stream.feed(data[:cut]) + stream.feed(data[cut:]) == expected


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"GET / HTTP/1.1\r\n\r\n", "no JSON object begins with 'G'"),
        (b'{"a": }', "not JSON"),
        (b'{"a": "\xff"}', "not UTF-8"),
        (b"{" * 40, "deeper than 16"),
        (b'{"a": "' + b"x" * LARGEST, "longer than 65536"),
    ],
)
def test_garbage_is_reported_once_and_the_next_message_is_read(data, message):
    stream = ObjectStream()
    result = stream.feed(data) + stream.feed(b' "}}]]]]' + json.dumps(HEARTBEAT).encode())
    assert isinstance(result[0], Broken)
    assert message in result[0].reason
    stream.drop()
    assert stream.feed(json.dumps(SHOT).encode()) == [SHOT]


@settings(max_examples=50)
@given(
    st.lists(
        st.one_of(st.binary(max_size=30), st.sampled_from([b"{", b"}", b'"', b"\\", b'{"a":1}', b"[[["])), max_size=8
    )
)
def test_the_stream_survives_any_bytes(pieces):
    stream = ObjectStream()
    for piece in pieces:
        for result in stream.feed(piece):
            assert isinstance(result, Broken | dict)
            if isinstance(result, dict):
                with contextlib.suppress(MessageError):
                    from_json(result)
    stream.drop()
    assert stream.feed(b' {"a": 1}') == [{"a": 1}]


@contextmanager
def listening(**options):
    """A listener in a thread of its own, and what it has heard and told."""
    heard, messages = [], []
    listener = Listener(0, on_problem=messages.append, **options)
    thread = threading.Thread(target=lambda: heard.extend(listener.messages()))
    thread.start()
    try:
        yield listener, heard, messages
    finally:
        listener.stop()
        thread.join(5)
        listener.close()
        assert not thread.is_alive()


@contextmanager
def raw(port):
    """A client that sends bytes as it likes, and reads the answers."""
    with socket.create_connection(("127.0.0.1", port), 5) as connection:
        stream = ObjectStream()

        def answers(count):
            result = []
            while len(result) < count:
                data = connection.recv(4096)
                assert data, "closed"
                result += stream.feed(data)
            return result

        yield connection, answers


def wait_for(condition):
    ends = time.monotonic() + 5
    while not condition():
        assert time.monotonic() < ends, "in vain"
        time.sleep(0.01)


def test_shots_go_over_the_socket_and_are_answered():
    launch = clubface.impact("7-iron", speed="82 mph", attack="-4 deg", loft="24 deg")
    with listening(hand="left", club="I7") as (listener, heard, messages):
        with Sender(listener.port, device="test") as sender:
            sender.heartbeat()
            assert tuple(sender.send(launch)) == (200, "Shot received successfully")
            assert sender.send({"ball_speed": 50.0, "launch": 0.3, "backspin": 500.0}).was_taken
            assert sender.player == {"Handed": "LH", "Club": "I7"}
        wait_for(lambda: len(messages) == 2)
    assert [each.kind for each in heard] == ["heartbeat", "shot", "shot"]
    shots = recorded(heard)
    assert shots.rows.tolist() == [1, 2]
    assert shots.launches["ball_speed"] == pytest.approx([launch.ball_speed, 50.0], rel=1e-13)
    assert shots.deliveries["loft"][0] == pytest.approx(24 * DEG, rel=1e-13)
    assert [each.rpartition(" ")[2] for each in messages] == ["connected", "left"]


def test_pieces_several_at_once_garbage_and_several_monitors(monkeypatch):
    text = json.dumps(SHOT).encode()
    with (
        listening() as (listener, heard, messages),
        raw(listener.port) as (first, answers),
        raw(listener.port) as other,
    ):
        first.sendall(text[:100])
        other[0].sendall(text + text + json.dumps(HEARTBEAT).encode() + text[:50])
        assert [each["Code"] for each in other[1](2)] == [200, 200]
        first.sendall(text[100:] + b"nonsense")
        assert [each["Code"] for each in answers(2)] == [200, 501]
        other[0].sendall(text[50:] + json.dumps(SHOT | {"BallData": {}}).encode())
        assert other[1](2)[1] == {"Code": 501, "Message": "BallData.Speed is missing"}
        first.sendall(text)
        assert answers(1)[0]["Code"] == 200
    assert [each.kind for each in heard].count("shot") == 5
    assert sum("no JSON object begins with 'n'" in each for each in messages) == 1


def test_a_message_that_does_not_end_is_given_up_and_the_next_is_read(monkeypatch):
    monkeypatch.setattr(open_connect, "PARTIAL", 0.2)
    with listening() as (listener, heard, messages), raw(listener.port) as (client, answers):
        client.sendall(json.dumps(SHOT).encode()[:-1])
        assert answers(1)[0] == {"Code": 501, "Message": "the message did not end"}
        client.sendall(json.dumps(SHOT).encode())
        assert answers(1)[0]["Code"] == 200
        client.sendall(b'{"DeviceID"')
        client.close()
        wait_for(lambda: any("left in the middle of a message" in each for each in messages))
    assert len(heard) == 1


def test_the_iteration_ends_when_nothing_comes_and_a_monitor_too_many_is_turned_away(monkeypatch):
    monkeypatch.setattr(open_connect, "MOST_CLIENTS", 1)
    messages = []
    with Listener(0, on_problem=messages.append) as listener, raw(listener.port), raw(listener.port) as (second, _):
        assert list(listener.messages(timeout=0.2)) == []
        assert second.recv(10) == b""
    assert "turned away" in messages[-1]
    assert list(listener.messages()) == []


def test_silent_connections_do_not_lock_out_a_monitor(monkeypatch):
    monkeypatch.setattr(open_connect, "SILENT", 0.3)
    with listening() as (listener, heard, messages), ExitStack() as idle:
        connections = [idle.enter_context(raw(listener.port))[0] for _ in range(open_connect.MOST_CLIENTS)]
        wait_for(lambda: len(messages) == len(connections))
        wait_for(lambda: sum("silent for too long" in each for each in messages) == len(connections))
        assert all(connection.recv(10) == b"" for connection in connections)
        with Sender(listener.port) as ninth:
            assert ninth.send({"ball_speed": 70.0, "launch": 0.2, "backspin": 250.0, "sidespin": 0.0}).was_taken
    assert len(heard) == 1


def test_the_longest_silent_monitor_is_dropped_and_active_ones_stay(monkeypatch):
    monkeypatch.setattr(open_connect, "SILENT", 0.3)
    monkeypatch.setattr(open_connect, "MOST_CLIENTS", 2)
    with listening() as (listener, heard, messages), Sender(listener.port) as quiet, Sender(listener.port) as busy:
        for each in (quiet, busy):
            each.heartbeat()
        wait_for(lambda: len(heard) == 2)
        time.sleep(0.4)  # longer than SILENT; monitors that have spoken are not closed for it alone
        busy.heartbeat()
        wait_for(lambda: len(heard) == 3)
        with Sender(listener.port) as third:
            third.heartbeat()
            wait_for(lambda: len(heard) == 4)
        busy.heartbeat()
        wait_for(lambda: len(heard) == 5)
        assert sum("makes room" in each for each in messages) == 1
        with pytest.raises(LinkError):
            quiet.send({"ball_speed": 70.0, "launch": 0.2, "backspin": 250.0, "sidespin": 0.0})


def test_a_port_in_use_or_without_a_listener_is_reported():
    with Listener(0) as listener:
        with pytest.raises(LinkError, match=rf"127.0.0.1:{listener.port} cannot be listened on"):
            Listener(listener.port)
        free = listener.port
    with pytest.raises(LinkError, match="cannot be reached"):
        Sender(free, timeout=1)
    for make, port in ((Sender, 70_000), (Sender, 0), (Listener, -1), (Listener, "921")):
        with pytest.raises(InputError, match="to 65535"):
            make(port)
    with pytest.raises(UnknownNameError, match="right, left"):
        Listener(0, hand="both")
    with pytest.raises(InputError, match="above 0 s"):
        Sender(free, timeout=0)


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        (None, "did not answer shot 1 within 0.3 s"),
        (b"", "closed the connection"),
        (b"what?", "sent an invalid answer"),
        (b'{"Message": "fine"}', "answered without a code"),
    ],
)
def test_a_simulator_that_does_not_answer_is_reported(answer, message):
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve():
            connection, _ = server.accept()
            with connection:
                connection.recv(10_000)
                if answer is None:
                    time.sleep(0.6)
                else:
                    connection.sendall(answer)

        thread = threading.Thread(target=serve)
        thread.start()
        with Sender(server.getsockname()[1], timeout=0.3) as sender, pytest.raises(LinkError, match=message):
            sender.send({"ball_speed": 50.0, "launch": 0.3})
        thread.join(5)


def test_the_answer_to_a_refused_shot_is_not_mistaken_for_an_earlier_one():
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve():
            connection, _ = server.accept()
            with connection:
                connection.sendall(b'{"Code": 200, "Message": "stale"}{"Code": 201, "Player": {"Handed": "RH"}}')
                connection.recv(10_000)
                connection.sendall(b'{"Code": 201, "Player": {"Handed": "LH"}}{"Code": 501, "Mess')
                time.sleep(0.05)
                connection.sendall(b'age": "no"}')
                connection.recv(10)

        thread = threading.Thread(target=serve)
        thread.start()
        with Sender(server.getsockname()[1], timeout=5) as sender:
            time.sleep(0.1)
            reply = sender.send({"ball_speed": 50.0, "launch": 0.3})
        thread.join(5)
    assert (reply.code, reply.message, reply.was_taken) == (501, "no", False)
    assert sender.player == {"Handed": "LH"}


def test_a_shot_is_acknowledged_only_once_it_is_kept():
    order = []
    listener = Listener(0, keep=lambda message: order.append("kept"))
    thread = threading.Thread(target=lambda: next(iter(listener.messages(timeout=10))), daemon=True)
    thread.start()
    answer = listener._answer
    listener._answer = lambda *messages: (order.append("answered"), answer(*messages))
    with Sender(listener.port, timeout=10) as sender:
        assert sender.send({"ball_speed": 60.0, "launch": 0.2}).was_taken
    thread.join(10)
    listener.close()
    assert order == ["kept", "answered"]


def test_a_shot_that_cannot_be_kept_is_not_acknowledged_and_the_error_ends_listening():
    class FullError(Exception):
        pass

    def full(message):
        raise FullError

    ended = []

    def serve():
        try:
            list(listener.messages(timeout=10))
        except FullError:
            ended.append(True)

    listener = Listener(0, keep=full)
    thread = threading.Thread(target=serve, daemon=True)
    thread.start()
    with Sender(listener.port, timeout=10) as sender:
        answer = sender.send({"ball_speed": 60.0, "launch": 0.2})
    thread.join(10)
    listener.close()
    assert (answer.code, answer.message, ended) == (501, "the shot could not be kept", [True])
