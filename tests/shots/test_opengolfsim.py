"""OpenGolfSim's Developer API: messages of monitors, and launches sent to the simulator."""

import contextlib
import json
import math
import socket
import threading

import pytest
from hypothesis import given, strategies as st

from clubface.errors import InputError, LinkError
from clubface.shots.messages import Message, MessageError, ObjectStream
from clubface.shots.open_connect import Listener
from clubface.shots.opengolfsim import OPENGOLFSIM, OpenGolfSimSender, from_json, to_json

DEG, RPM = math.pi / 180, math.pi / 30
SHOT = {"type": "shot", "shot": {"ballSpeed": 101.2, "verticalLaunchAngle": 15.4, "horizontalLaunchAngle": -2.1}}
SHOT["shot"] |= {"spinSpeed": 3021, "spinAxis": -0.5}


def changed(**values):
    return SHOT | {"shot": SHOT["shot"] | values}


def test_a_message_is_a_shot_in_si():
    shot = from_json(SHOT)
    expected = {"ball_speed": 101.2 * 0.44704, "launch": 15.4 * DEG, "azimuth": -2.1 * DEG, "total_spin": 3021 * RPM}
    expected |= {"spin_axis": -0.5 * DEG, "backspin": 3021 * RPM * math.cos(0.5 * DEG)}
    assert shot.launch == pytest.approx(expected | {"sidespin": -3021 * RPM * math.sin(0.5 * DEG)}, rel=1e-12)
    assert (shot.kind, shot.delivery, shot.shot_number) == ("shot", {}, 0)
    assert from_json(SHOT | {"unit": "metric"}).launch["ball_speed"] == 101.2
    assert from_json(SHOT | {"unit": "imperial"}).launch == shot.launch


def test_zero_spin_means_not_measured():
    assert set(from_json(changed(spinSpeed=0, spinAxis=0)).launch) == {"ball_speed", "launch", "azimuth"}
    lacking = {name: value for name, value in SHOT["shot"].items() if not name.startswith("spin")}
    assert set(from_json({"type": "shot", "shot": lacking}).launch) == {"ball_speed", "launch", "azimuth"}


@pytest.mark.parametrize(
    ("message", "words"),
    [
        ({}, "type must be shot or device"),
        ({"type": "player"}, "type must be shot or device"),
        ({"type": "device", "status": "asleep"}, "status must be ready or busy"),
        ({"type": "shot"}, "shot is missing"),
        ({"type": "shot", "shot": [1]}, "shot must be an object"),
        (SHOT | {"unit": "yards"}, "unit must be imperial or metric"),
        (SHOT | {"unit": []}, "unit must be imperial or metric"),
        (changed(ballSpeed=None), "shot.ballSpeed is missing"),
        (changed(ballSpeed=0), "shot.ballSpeed must be above 0"),
        (changed(verticalLaunchAngle="up"), "shot.verticalLaunchAngle must be a number"),
    ],
)
def test_an_invalid_message_names_the_field(message, words):
    with pytest.raises(MessageError, match=words):
        from_json(message)


def test_a_speed_that_no_ball_can_have_is_not_measured():
    shot = from_json(changed(ballSpeed=1e6))
    assert "ball_speed" in shot.impossible
    assert "ball_speed" not in shot.launch


def test_a_device_says_whether_it_is_ready():
    assert [from_json({"type": "device", "status": each}).is_ready for each in ("ready", "busy")] == [True, False]


VALUE = st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=5) | st.lists(st.none(), max_size=1)


@given(
    st.dictionaries(st.sampled_from(["type", "unit", "status"]), VALUE | st.sampled_from(["shot", "device", "metric"])),
    st.dictionaries(st.sampled_from([*SHOT["shot"]]), VALUE),
)
def test_whatever_comes_becomes_a_shot_of_finite_values_or_a_sentence(rest, values):
    with contextlib.suppress(MessageError):
        message = from_json(SHOT | {"shot": SHOT["shot"] | values} | rest)
        assert isinstance(message, Message)
        assert all(map(math.isfinite, message.launch.values()))


@given(st.lists(st.sampled_from([json.dumps(SHOT), "\n", "{", "}", '"', "\\", "x", "[1]", "\x00"]), max_size=12),
       st.integers(1, 9))  # fmt: skip
def test_the_stream_may_be_cut_anywhere(pieces, size):
    data = "".join(pieces).encode()
    stream, whole = ObjectStream(), ObjectStream().feed(data)
    parts = [each for place in range(0, len(data), size) for each in stream.feed(data[place : place + size])]
    assert parts == whole


def asked(port, data):
    """What is answered to bytes, up to the end of a line or of the connection."""
    with socket.create_connection(("127.0.0.1", port), 5) as monitor:
        monitor.sendall(data)
        return monitor.makefile("rb").readline()


def test_a_monitor_is_answered_and_a_web_page_is_not():
    kept, problems = [], []
    with Listener(0, dialect=OPENGOLFSIM, keep=kept.append, on_problem=problems.append) as listener:
        thread = threading.Thread(target=lambda: list(listener.messages()))
        thread.start()
        try:
            assert json.loads(asked(listener.port, b'{"type": "device", "status": "ready"}\n')) == {"status": 200}
            assert json.loads(asked(listener.port, json.dumps(SHOT).encode())) == {"status": 200}
            refused = json.loads(asked(listener.port, b'{"type": "shot"}\n'))
            assert refused == {"status": 400, "error": "shot is missing"}
            page = b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 200\r\n\r\n" + json.dumps(SHOT).encode()
            assert asked(listener.port, page) == b""
        finally:
            listener.stop()
            thread.join()
    assert len(kept) == 1
    assert any("is a web page and no monitor" in each for each in problems)


def test_a_simulator_that_was_closed_is_noticed_before_the_next_launch_is_sent():
    with socket.create_server(("127.0.0.1", 0)) as simulator:
        sender = OpenGolfSimSender(simulator.getsockname()[1])
        simulator.accept()[0].close()
    with pytest.raises(LinkError, match=r"closed the connection|was lost"):
        sender.send(from_json(SHOT).launch)
    sender.close()


def test_a_launch_that_is_sent_arrives_as_it_was():
    kept = []
    with Listener(0, dialect=OPENGOLFSIM, keep=kept.append) as listener:
        thread = threading.Thread(target=lambda: list(listener.messages()))
        thread.start()
        sender = OpenGolfSimSender(listener.port)
        launch = from_json(SHOT).launch
        sender.send(launch)
        sender.close()
        while not kept:
            thread.join(0.02)
        listener.stop()
        thread.join()
    assert kept[0].launch == pytest.approx(launch, rel=1e-12)
    with pytest.raises(LinkError, match="cannot be reached"):
        OpenGolfSimSender(listener.port)
    spin = {name: launch[name] for name in ("backspin", "sidespin")}
    rest = {name: launch[name] for name in ("ball_speed", "launch", "azimuth")}
    assert from_json(to_json(rest | spin)).launch == pytest.approx(launch, rel=1e-12)
    with pytest.raises(InputError, match="launch is missing"):
        to_json({"ball_speed": 50.0})
