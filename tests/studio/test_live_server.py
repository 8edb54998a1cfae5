"""Live shots in a process of its own: every tab sees them, and a killed server goes on with all of them."""

import json
import socket
import threading
import time
import urllib.request

import pytest

pytest.importorskip("starlette")
pytest.importorskip("uvicorn")
pytest.importorskip("websockets")

from clubface.shots.messages import ObjectStream
from clubface.shots.open_connect import Listener, Sender
from command_line import press_ctrl_c
from studio_pages import Served

LAUNCH = {"ball_speed": 65.0, "launch": 0.2, "azimuth": 0.0, "backspin": 280.0, "sidespin": 10.0}
OPTIONS = ("--live", "live.jsonl", "--open-connect", "0", "--opengolfsim", "0", "--flight-relay", "0")


class Tab:
    """A tab that listens to the events; ``shots`` are the rows that it has seen."""

    def __init__(self, address, after=0):
        self.shots, self.states = [], []
        self._answer = urllib.request.urlopen(f"{address}api/live/events?after={after}", timeout=30)
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self):
        name = ""
        try:
            for raw in self._answer:
                line = raw.decode().rstrip("\n")
                if line.startswith("event: "):
                    name = line[7:]
                elif line.startswith("data: "):
                    data = json.loads(line[6:])
                    if name == "shots":
                        self.shots += data["tables"]["shots"]["rows"]
                    else:
                        self.states.append(data)
        except (OSError, ValueError):
            pass  # the server is gone

    @property
    def remarks(self):
        """What happened last on the connections, as far as the tab has heard."""
        return self.states[-1]["remarks"] if self.states else []

    def numbers(self, count, seconds=60.0):
        """Wait for a number of shots; return the numbers of all."""
        wait_until(lambda: len(self.shots) >= count, seconds)
        return [each["shot"] for each in self.shots]


def known(rows):
    return [{name: value for name, value in row.items() if value is not None} for row in rows]


def wait_until(condition, seconds=60.0):
    ends = time.monotonic() + seconds
    while not condition() and time.monotonic() < ends:
        time.sleep(0.02)
    assert condition()


def asked(address, path, method="GET", body=None):
    request = urllib.request.Request(address + path, data=body, method=method)
    with urllib.request.urlopen(request, timeout=30) as answer:
        return json.loads(answer.read())


def test_every_tab_sees_the_same_shots_of_every_protocol(tmp_path):
    from websockets.sync.client import connect

    with Served(tmp_path, *OPTIONS) as served:
        tabs = [Tab(served.address), Tab(served.address)]
        with Sender(served.ports["open-connect"]) as monitor:
            assert monitor.send(LAUNCH).was_taken
        with socket.create_connection(("127.0.0.1", served.ports["opengolfsim"])) as monitor:
            shot = {
                "ballSpeed": 140,
                "verticalLaunchAngle": 12,
                "horizontalLaunchAngle": 1,
                "spinSpeed": 3000,
                "spinAxis": 2,
            }
            monitor.sendall(json.dumps({"type": "shot", "shot": shot}).encode() + b"\n")
            assert json.loads(monitor.makefile().readline()) == {"status": 200}
        with connect(f"ws://127.0.0.1:{served.ports['flight-relay']}/frp") as device:
            key = {"shot_id": "a", "shot_number": 9}
            device.send(json.dumps({"kind": "init", "version": "0.1.0"}))
            club = {"club_speed": "100mph", "path": 1.0}
            for event in ({"kind": "club_path", "key": key, "club": club}, {"kind": "shot_finished", "key": key}):
                device.send(json.dumps({"device": "radar", "event": event}))
            assert [each.numbers(3) for each in tabs] == [[1, 2, 3]] * 2
        first, second, third = tabs[0].shots
        assert first["ball_speed_mps"] == pytest.approx(65.0, rel=1e-12)
        assert "carry" in first["computed"].split()
        assert "ball_speed" not in second["computed"].split()
        assert {"ball_speed", "carry"} <= set(third["computed"].split())
        # Shots that came together share a table, whose columns are those of all of them.
        assert known(tabs[0].shots) == known(tabs[1].shots)
        late = Tab(served.address, after=2)
        assert late.numbers(1) == [3]
        assert asked(served.address, "api/live")["tables"]["shots"]["rows"][2]["speed_mps"] == pytest.approx(44.704)


def test_a_killed_server_goes_on_with_every_shot_that_it_acknowledged(tmp_path):
    taken = 0
    for round_ in range(3):
        with Served(tmp_path, *OPTIONS) as served:
            tab = Tab(served.address)
            assert tab.numbers(taken) == list(range(1, taken + 1))
            timer = threading.Timer(0.15 + 0.1 * round_, served.kill)
            with Sender(served.ports["open-connect"], timeout=2.0) as monitor:
                timer.start()
                while True:
                    try:
                        # A value that differs, so that no shot counts as one that is sent again.
                        answer = monitor.send(LAUNCH | {"launch": 0.1 + 1e-5 * taken})
                    except (ConnectionError, OSError):
                        break
                    assert answer.was_taken
                    taken += 1
            timer.join()
            # One may be on the disk whose acknowledgement did not arrive.
            kept = len((tmp_path / "live.jsonl").read_bytes().split(b"\n")) - 1
            assert taken <= kept <= taken + 1
            taken = kept
    assert taken > 3
    with Served(tmp_path, *OPTIONS) as served:
        rows = asked(served.address, "api/live")["tables"]["shots"]["rows"]
        assert [each["shot"] for each in rows] == list(range(1, taken + 1))
        assert len({each["launch_deg"] for each in rows}) >= taken - 2


def test_an_interrupt_ends_open_tabs_too_and_says_what_is_kept(tmp_path):
    with Served(tmp_path, *OPTIONS) as served:
        tab = Tab(served.address)
        with Sender(served.ports["open-connect"]) as monitor:
            monitor.send(LAUNCH)
        tab.numbers(1)
        press_ctrl_c(served.process)
        assert served.process.wait(60) == 130
        served.errors.seek(0)
        *_, last = served.errors.read().splitlines()
        assert last == "clubface: interrupted: 1 live shot in live.jsonl"
        served.errors.seek(0)
        assert "Traceback" not in served.errors.read()


def test_the_club_is_chosen_in_a_tab_and_known_in_all_others(tmp_path):
    with Served(tmp_path, *OPTIONS) as served:
        tab = Tab(served.address)
        state = asked(served.address, "api/live/player", "POST", b'{"club": "7-iron", "hand": "left"}')
        assert (state["club"], state["hand"]) == ("7-iron", "left")
        wait_until(lambda: tab.states and tab.states[-1]["club"] == "7-iron")
        with pytest.raises(urllib.error.HTTPError) as refused:
            asked(served.address, "api/live/player", "POST", b'{"club": "spoon"}')
        assert json.loads(refused.value.read())["where"] == "club"
        with Sender(served.ports["open-connect"]) as monitor:
            monitor.send(LAUNCH)
        tab.numbers(1)
        assert tab.shots[0]["club"] == "7-iron"


def test_club_data_comes_in_and_the_ball_goes_out_to_the_simulator(tmp_path):
    import clubface

    received = []
    with Listener(0) as simulator:
        thread = threading.Thread(target=lambda: received.extend(simulator.messages(timeout=90.0)))
        thread.start()
        with Served(tmp_path, *OPTIONS, "--simulator", f"open-connect:{simulator.port}") as served:
            tab = Tab(served.address)
            club = {"Speed": 100.0, "AngleOfAttack": 1.0, "Loft": 13.0, "Path": 0.0, "FaceToTarget": 0.0}
            message = {"DeviceID": "camera", "ShotNumber": 1, "APIversion": "1", "ClubData": club}
            with socket.create_connection(("127.0.0.1", served.ports["open-connect"])) as monitor:
                monitor.sendall(json.dumps(message).encode())
                (answer,) = ObjectStream().feed(monitor.recv(65_536))
                assert answer["Code"] == 200
            wait_until(lambda: any("was sent to the simulator" in each["text"] for each in tab.remarks))
        simulator.stop()
        thread.join()
    launch = clubface.impact("driver", {"speed": "100 mph", "attack": "1 deg", "loft": "13 deg"})
    (shot,) = received
    assert shot.launch["ball_speed"] == pytest.approx(launch.ball_speed, rel=1e-9)
    assert shot.launch["launch"] == pytest.approx(launch.launch, rel=1e-9)
    remark = next(each["text"] for each in tab.remarks if "simulator" in each["text"])
    assert "computed from the club data" in remark


def test_a_port_that_is_taken_costs_its_protocol_alone(tmp_path):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        with Served(
            tmp_path, "--live", "live.jsonl", "--open-connect", port, "--opengolfsim", "0", "--flight-relay", "0"
        ) as served:
            links = {each["protocol"]: each["problem"] for each in asked(served.address, "api/live/state")["links"]}
            assert "cannot be listened on" in links["open-connect"]
            assert links["opengolfsim"] == links["flight-relay"] == ""


def test_a_device_that_has_not_connected_yet_is_shown_as_awaited(tmp_path):
    from websockets.sync.server import serve

    with serve(lambda socket: socket.recv(), "127.0.0.1", 0) as device:
        address = f"ws://127.0.0.1:{device.socket.getsockname()[1]}/frp"
        with Served(tmp_path, *OPTIONS, "--flight-relay", address) as served:
            tab = Tab(served.address)

            def problem():
                return next(each["problem"] for each in tab.states[-1]["links"] if each["protocol"] == "flight-relay")

            wait_until(lambda: tab.states)
            assert problem() == f"{address} is not there yet; trying again"
            threading.Thread(target=device.serve_forever, daemon=True).start()
            wait_until(lambda: problem() == "")
        device.shutdown()


@pytest.mark.parametrize(("options", "words"), [
    (("--studies", "nowhere"), "--studies is 'nowhere'; it must be a folder"),
    (("--simulator", "open-connect:921"), "leave it out without --live"),
    (("--live", "live.csv"), ".jsonl"),
    (("--live", "live.jsonl", "--simulator", "gspro"), "open-connect:921 or opengolfsim:3111"),
    (("--live", "live.jsonl", "--flight-relay", "nowhere"), "an address such as ws://localhost:5880/frp, or a port"),
    (("--port", "70000"), "--port is 70000; it must be a whole number from 0 to 65535"),
    (("--flight-relay", "70000"), "--flight-relay is 70000; it must be a whole number from 0 to 65535"),
    (("--site", "nowhere"), "this folder holds no built studio"),
])  # fmt: skip
def test_mistakes_of_the_command_are_reported(clubface_, tmp_path, monkeypatch, options, words):
    from command_line import assert_mistake
    from studio_pages import made_site

    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("CLUBFACE_STUDIO_SITE", str(made_site(tmp_path / "site")))
    assert_mistake(clubface_("studio", *options), words)
