"""What tests of studies need."""

import contextlib
import json

import pytest


@pytest.fixture
def in_this_process(monkeypatch):
    """Let chunks be computed here, by what a worker calls, which starts in no time."""
    from clubface.studies import chunks, running

    class Here(contextlib.nullcontext):
        def __init__(self, command, workers):
            super().__init__(self)

        def work(self, numbers, done, *, first):
            for number in numbers:
                done(number, chunks.ensure(*json.loads(first), number))

    monkeypatch.setattr(running, "Pool", Here)
