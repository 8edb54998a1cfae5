"""What tests of studies need."""

import pytest


@pytest.fixture
def in_this_process(monkeypatch):
    """Let chunks be computed here, by what a worker calls, which starts in no time."""
    from clubface.jobs.workers import in_sequence
    from clubface.studies import running

    monkeypatch.setattr(running, "in_processes", lambda parts, compute, workers: in_sequence(parts, compute))
