"""Flight Relay: events put together to shots, over a WebSocket in both directions of connecting."""

import json
import math
import time

import pytest
from hypothesis import given, strategies as st

from clubface.errors import InputError
from clubface.shots.flight_relay import MOST_OPEN, UNFINISHED, ShotCollector, text_to_object
from clubface.shots.messages import Message, MessageError

DEG, RPM = math.pi / 180, math.pi / 30
BALL = {"launch_speed": "150.3mph", "launch_azimuth": -1.3, "launch_elevation": 14.2, "carry_distance": "197.4yd"}
BALL |= {"total_distance": "195.0m", "max_height": "2830cm", "flight_time": 6.2, "backspin_rpm": 3200}
BALL |= {"sidespin_rpm": -450, "roll_distance": "14.5m"}
CLUB = {"club_speed": "42.1mps", "path": -2.1, "attack_angle": -3.5, "face_angle": 1.2, "dynamic_loft": 18.4}
CLUB |= {"smash_factor": 1.5, "club_offset": "0.47in", "club_speed_post": "38.6mps", "swing_plane_vertical": 58.1}
IMPACT = {"lateral": "0.31in", "vertical": "-4mm"}


def event(kind, shot="550e8400", number=42, **parts):
    return {
        "device": "EagleOne-X4K2",
        "event": {"kind": kind, "key": {"shot_id": shot, "shot_number": number}, **parts},
    }


WHOLE = [event("shot_trigger"), event("ball_flight", ball=BALL), event("club_path", club=CLUB),
         event("face_impact", impact=IMPACT), event("shot_finished")]  # fmt: skip


def fed(messages, collector=None):
    collector = collector or ShotCollector()
    return [each for message in messages for each in collector.feed(message)]


@pytest.mark.parametrize("order", [WHOLE, [WHOLE[3], WHOLE[2], WHOLE[1], WHOLE[4]]])
def test_the_events_of_a_shot_are_one_shot_in_si(order):
    (shot,) = fed(order)
    assert (shot.kind, shot.device, shot.shot_number, shot.identity) == ("shot", "EagleOne-X4K2", 42, "550e8400")
    spin = math.hypot(3200, 450) * RPM
    expected = {"ball_speed": 150.3 * 0.44704, "azimuth": -1.3 * DEG, "launch": 14.2 * DEG, "carry": 197.4 * 0.9144}
    expected |= {"total": 195.0, "apex": 28.3, "flight_time": 6.2, "smash": 1.5, "backspin": 3200 * RPM}
    expected |= {"sidespin": -450 * RPM, "total_spin": spin, "spin_axis": -math.atan2(450, 3200)}
    assert shot.launch == pytest.approx(expected, rel=1e-14)
    expected = {"speed": 42.1, "path": -2.1 * DEG, "attack": -3.5 * DEG, "face": 1.2 * DEG, "loft": 18.4 * DEG}
    assert shot.delivery == pytest.approx(expected | {"toe": 0.31 * 0.0254, "high": -0.004}, rel=1e-14)
    assert shot.notes == ()


def test_shots_may_overlap_and_lack_any_part():
    one, other = (
        [
            event("shot_trigger", each),
            event("ball_flight", each, ball={"launch_speed": speed}),
            event("shot_finished", each),
        ]
        for each, speed in (("a", "50mps"), ("b", "60mps"))
    )  # fmt: skip
    shots = fed([one[0], other[0], other[1], one[1], one[2], other[2]])
    assert [(each.identity, each.launch["ball_speed"]) for each in shots] == [("a", 50.0), ("b", 60.0)]
    assert fed([event("shot_trigger"), event("shot_finished")]) == []
    (club_alone,) = fed([event("club_path", club=CLUB), event("shot_finished")])
    assert (set(club_alone.launch), "speed" in club_alone.delivery) == ({"smash"}, True)


def test_a_shot_that_is_not_finished_is_not_lost():
    collector = ShotCollector()
    assert fed(WHOLE[:2], collector) == []
    assert collector.overdue() == []
    (late,) = collector.overdue(time.monotonic() + UNFINISHED + 1.0)
    assert late.launch["flight_time"] == 6.2
    assert collector.overdue(time.monotonic() + 100.0) == []
    fed(WHOLE[:2], collector)
    assert [each.shot_number for each in collector.rest()] == [42]
    many = [event("ball_flight", str(number), number, ball=BALL) for number in range(MOST_OPEN + 3)]
    assert [each.shot_number for each in fed(many)] == [0, 1, 2]


@pytest.mark.parametrize("text", ["67.2", "67.2 mps", "67,2mps", "mps", "1e400mps", "67.2MPS", "67.2kn", "12m", 67.2,
                                  True, [], {}, "nanmps", "infmps", "1_0mps", "6" * 50 + "mps"])  # fmt: skip
def test_a_text_without_its_unit_is_dropped_and_noted(text):
    (shot,) = fed([event("ball_flight", ball=BALL | {"launch_speed": text}), event("shot_finished")])
    assert "ball_speed" not in shot.launch
    assert shot.launch["launch"] == 14.2 * DEG
    assert [(each.code, each.data["field"]) for each in shot.notes] == [("message-field-no-unit", "ball.launch_speed")]


@pytest.mark.parametrize(
    ("message", "words"),
    [
        ({"device": "x", "event": {"kind": "ball_flight", "ball": BALL}}, "key.shot_id must be a text"),
        (event("ball_flight", shot=""), "key.shot_id must be a text"),
        (event("ball_flight", shot=5), "key.shot_id must be a text"),
        (event("ball_flight"), "ball must be an object"),
        (event("club_path", club=[1]), "club must be an object"),
        ({"kind": "alert", "severity": "critical", "message": "no power"}, "a monitor says: no power"),
        ({"device": "x", "event": {"kind": "alert", "message": "tilted"}}, "x says: tilted"),
    ],
)
def test_an_unusable_message_is_reported(message, words):
    (error,) = fed([message])
    assert isinstance(error, MessageError)
    assert words in str(error)


@pytest.mark.parametrize("message", [{}, {"kind": "news"}, {"event": 5}, {"device": "x", "event": {"kind": "dance"}},
                                     {"kind": "init", "version": "0.1.0"}])  # fmt: skip
def test_unknown_kinds_are_passed_over_as_the_protocol_has_it(message):
    assert fed([message]) == []


def test_a_device_says_whether_it_is_ready():
    telemetry = {"device": "x", "event": {"kind": "device_telemetry", "telemetry": {"ready": "false"}}}
    assert [(each.kind, each.is_ready) for each in fed([telemetry])] == [("status", False)]
    assert fed([{"device": "x", "event": {"kind": "device_telemetry", "telemetry": 3}}])[0].is_ready is None


JSON = st.recursive(
    st.none() | st.booleans() | st.floats() | st.integers() | st.text(max_size=9) | st.sampled_from(["3mps", "2in"]),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(
        st.sampled_from([*BALL, *CLUB, *IMPACT, "kind", "key", "shot_id", "ball", "club", "impact"]), inner, max_size=4
    ),
    max_leaves=12,
)  # fmt: skip


@given(st.lists(st.one_of(
    st.fixed_dictionaries({"device": JSON, "event": JSON}),
    st.builds(lambda kind, body: event(kind, ball=body, club=body, impact=body),
              st.sampled_from(["ball_flight", "club_path", "face_impact", "shot_finished"]), JSON),
), max_size=5))  # fmt: skip
def test_whatever_comes_becomes_shots_of_finite_values_or_a_sentence(messages):
    collector = ShotCollector()
    for each in [*fed(messages, collector), *collector.rest()]:
        if isinstance(each, Message):
            assert all(map(math.isfinite, (each.launch | each.delivery).values()))
            assert each.kind != "shot" or each.launch or each.delivery
            assert all(map(str, each.notes))
        else:
            assert str(each)


@given(st.text(max_size=50) | st.binary(max_size=50) | JSON.map(json.dumps))
def test_a_frame_is_an_object_or_nothing(text):
    assert isinstance(text_to_object(text), dict | None)


def converse(socket):
    """Send a shot as a device does."""
    assert json.loads(socket.recv())["kind"] == "start"
    for each in [{"kind": "init", "version": "0.1.0"}, *WHOLE]:
        socket.send(json.dumps(each))


def wait_for(items, seconds=10.0):
    ends = time.monotonic() + seconds
    while not items and time.monotonic() < ends:
        time.sleep(0.02)
    return items


def test_a_device_connects_and_a_web_page_may_not():
    pytest.importorskip("websockets")
    from websockets.exceptions import InvalidStatus
    from websockets.sync.client import connect

    from clubface.shots.flight_relay import FlightRelayListener

    shots, problems = [], []
    listener = FlightRelayListener(0, shots.append, problems.append)
    try:
        with connect(f"ws://127.0.0.1:{listener.port}/frp") as device:
            converse(device)
            assert [each.shot_number for each in wait_for(shots)] == [42]
        with pytest.raises(InvalidStatus), connect(f"ws://127.0.0.1:{listener.port}/frp", origin="http://evil.example"):
            pass
    finally:
        listener.close()


def test_a_device_that_listens_is_found_whenever_it_comes():
    pytest.importorskip("websockets")
    import threading

    from websockets.sync.server import serve

    from clubface.shots import flight_relay

    shots, problems = [], []
    with serve(converse, "127.0.0.1", 0) as device:
        port = device.socket.getsockname()[1]
        client = flight_relay.FlightRelayClient(f"ws://localhost:{port}", shots.append, problems.append)
        threading.Thread(target=device.serve_forever, daemon=True).start()
        try:
            assert client.address == f"ws://localhost:{port}/frp"
            assert [each.identity for each in wait_for(shots)] == ["550e8400"]
            assert any("connected to" in each for each in problems)
        finally:
            client.close()
            device.shutdown()


@pytest.mark.parametrize("address", [
    "", "5880x", "http://localhost:1/frp", "ws://", "localhost:5880", "ws://localhost:70000/frp", "ws://localhost:x",
    "ws://[", "ws://localhost/frp#now", "ws://name@localhost/frp", f"ws://{'a' * 64}/frp",
])  # fmt: skip
def test_an_invalid_address_is_refused(address):
    pytest.importorskip("websockets")
    from clubface.shots.flight_relay import FlightRelayClient

    with pytest.raises(InputError, match="an address such as ws://localhost:5880/frp, or a port"):
        FlightRelayClient(address, print, print)
