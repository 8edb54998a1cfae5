"""A fitting for the golfer of a file: with progress, with an end, with the result of the command."""

import json
import threading
import time

import pytest

pytest.importorskip("starlette")
pytest.importorskip("scipy")


from clubface.errors import InputError
from clubface.results.result import Result
from clubface.studio.jobs import StudioJobs
from studio_pages import added, client, session

STUDY = """
title = "Which ball"
golfer = "bogey-driver"
objective = "carry"
shots = 256
model = "standard"
[fit]
clubs = ["driver"]
balls = ["modern", "distance"]
"""


@pytest.fixture
def studio(tmp_path):
    return client(tmp_path)


def events_of(studio, job):
    """The events of a job until its end."""
    events = []
    with studio.stream("GET", f"api/jobs/{job}/events") as stream:
        name = ""
        for line in stream.iter_lines():
            if line.startswith("event: "):
                name = line.removeprefix("event: ")
            elif line.startswith("data: "):
                events.append((name, json.loads(line.removeprefix("data: "))))
    return events


def test_a_fitting_reports_its_progress_and_its_result(studio):
    place = added(studio, session()).headers["location"]
    asked = {"objective": "carry", "balls": ["modern", "distance"], "shots": 256}
    started = studio.post(f"{place}/fittings", json=asked)
    assert (started.status_code, started.json()["state"]) == (202, "running")
    events = events_of(studio, started.json()["job"])
    (end,) = [data for name, data in events if name == "end"]
    assert (end["state"], end["done"], end["whole"]) == ("done", 2, 2)
    assert [data["done"] for name, data in events if name == "progress"] == sorted(
        data["done"] for name, data in events if name == "progress"
    )
    rows = end["result"]["tables"]["combinations"]["rows"]
    assert {each["ball"] for each in rows} == {"modern", "distance"}
    assert studio.get(f"api/jobs/{end['job']}/result").json() == end["result"]
    assert "<script" not in studio.get(f"api/jobs/{end['job']}/report").text


def test_a_study_of_the_command_line_runs_too_and_reads_no_other_file(studio, tmp_path):
    started = studio.post("api/fittings", content=STUDY)
    (end,) = [data for name, data in events_of(studio, started.json()["job"]) if name == "end"]
    assert end["result"]["title"] == "Which ball"
    (tmp_path / "anna.toml").write_text("secret = 1")
    for path in (str(tmp_path / "anna.toml"), "/etc/passwd", "../anna.toml"):
        refused = studio.post("api/fittings", content=STUDY.replace('"bogey-driver"', f'"{path}"'))
        assert refused.status_code == 422
        assert "secret" not in refused.text
        assert "root:" not in refused.text


@pytest.mark.parametrize(("asked", "where"), [
    ({"objective": "joy"}, "objective"), ({"balls": "modern"}, "balls"), ({"balls": ["x.toml"]}, "balls"),
    ({"clubs": ["/etc/passwd"]}, "clubs"), ({"shots": 1}, "shots"), ({"shots": True}, "shots"), ({"loft": "2"}, "loft"),
    ({"loft": ["2 deg"]}, "loft"), ({"club": 5}, "club"), ({"balls": [["modern"]]}, "balls"),
])  # fmt: skip
def test_a_fitting_that_cannot_be_names_what_is_wrong(studio, asked, where):
    place = added(studio, session(20)).headers["location"]
    refused = studio.post(f"{place}/fittings", json=asked)
    assert (refused.status_code, refused.json()["where"]) == (422, where)


@pytest.mark.parametrize("body", [b"", b"[]", b"{", b"\xff", b"[" * 50_000, b'{"a": 1e999}'])
def test_a_body_that_is_no_object_is_refused(studio, body):
    place = added(studio, session(20)).headers["location"]
    answer = studio.post(f"{place}/fittings", content=body)
    if b"1e999" in body:  # what nobody asks for does not matter
        assert answer.status_code == 202
        studio.delete(f"api/jobs/{answer.json()['job']}")
    else:
        assert (answer.status_code, answer.json()["allowed"]) == (422, "a JSON object")
    assert studio.post("api/fittings", content=b"x" * 200_000).status_code == 413


def test_a_fitting_is_cancelled_and_another_may_begin(studio):
    place = added(studio, session()).headers["location"]
    asked = {"clubs": ["3-wood", "5-wood", "hybrid"], "balls": ["modern", "distance", "reference"], "shots": 20_000}
    job = studio.post(f"{place}/fittings", json=asked | {"loft": "2 deg"}).json()["job"]
    refused = studio.post(f"{place}/fittings", json=asked)
    assert refused.json()["what"] == "fitting is running; leave it to finish, or cancel it"
    assert studio.delete(f"api/jobs/{job}").json()["state"] == "cancelled"
    (end,) = [data for name, data in events_of(studio, job) if name == "end"]
    assert (end["state"], end["result"]) == ("cancelled", None)
    assert end["done"] < 12
    again = studio.post(f"{place}/fittings", json={"shots": 256})
    assert again.status_code == 202
    assert studio.get("api/jobs/unknown").status_code == 422


def test_a_cancelled_job_computes_no_further_part_and_stays_cancelled():
    jobs, begun, parts = StudioJobs(), threading.Event(), []

    def compute(job):
        for part in range(1000):
            job.progress(part, 1000)
            parts.append(part)
            begun.set()
            time.sleep(0.01)
        return Result("x", "X")

    job = jobs.start(compute)
    assert begun.wait(10)
    job.cancel()
    time.sleep(0.2)
    count = len(parts)
    time.sleep(0.1)
    assert (len(parts), job.state, job.result) == (count, "cancelled", None)
    assert count < 1000


def test_an_error_in_a_job_says_where_and_what(capsys):
    def refuse(job):
        raise InputError("loft", "2", "an angle")

    def fail(job):
        return 1 / 0

    jobs = StudioJobs()
    for compute, words in ((refuse, "loft is '2'; it must be an angle"), (fail, "this is a bug in clubface")):
        job = jobs.start(compute)
        while job.state == "running":
            time.sleep(0.01)
        events, ended = job.news()
        assert ended
        assert job.state == "failed"
        assert words in events[-1]
    assert "ZeroDivisionError" in capsys.readouterr().err
