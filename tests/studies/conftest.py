"""What tests of studies need."""

import pytest


@pytest.fixture
def in_this_process(monkeypatch):
    """Let chunks be computed here, by what a worker calls, which starts in no time."""
    from clubface.studies import chunks, running

    def work(command, numbers, *, workers, done):
        for number in numbers:
            done(number, chunks.ensure(*command[-3:], number))

    monkeypatch.setattr(running, "work", work)
