"""Runs side by side: all of them, on all cores, until one fails or Ctrl-C."""

import threading

import pytest

from clubface.fem.run import side_by_side


@pytest.mark.parametrize(
    ("points", "workers", "threads"),
    [
        (4, 2, [1, 1, 1, 1]),
        (5, 2, [1, 1, 1, 1, 2]),
        (1, 8, [8]),
        (3, 8, [2, 2, 2]),
        (3, 1, [1, 1, 1]),
        (0, 2, []),
        # More workers than cores get no more threads than there are.
        (1, 100, [8]),
        (20, 100, [1] * 20),
    ],
)
def test_no_core_is_left_without_work_at_the_end(points, workers, threads, monkeypatch):
    monkeypatch.setattr("clubface.fem.run.processors", lambda: 8)
    given, ended = {}, []

    def run(point, keep_going, count):
        keep_going(0.0, 1.0)
        given[point] = count
        return -point

    side_by_side(range(points), run, lambda point, found: ended.append((point, found)), workers=workers)
    assert [given[point] for point in range(points)] == threads
    assert sorted(ended) == [(point, -point) for point in range(points)]


def test_a_failure_ends_the_others_and_is_told():
    others, stopped = threading.Event(), threading.Event()

    def run(point, keep_going, _):
        if point == 0:
            assert others.wait(10.0)
            raise ValueError("no such run")
        others.set()
        while not stopped.wait(0.01):
            try:
                keep_going(0.0, 1.0)
            except KeyboardInterrupt:
                stopped.set()
        raise KeyboardInterrupt

    with pytest.raises(ValueError, match="no such run"):
        side_by_side(range(2), run, pytest.fail, workers=2)
    assert stopped.is_set()
