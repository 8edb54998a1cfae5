"""A plugin of pytest: which lines of the package each test runs, and how long each takes."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import coverage
import pytest

FOLDER = Path(os.environ["MUTANTS_RECORDS"])
_RECORDER = coverage.Coverage(
    data_file=str(FOLDER / "lines"), data_suffix=True, source=[os.environ["MUTANTS_PACKAGE"]], config_file=False
)
_TIMES: dict[str, float] = {}
# Before the package is imported: what runs then belongs to no test.
_RECORDER.start()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[Any]:
    """Count what runs until the next test to this one."""
    _RECORDER.switch_context(item.nodeid)
    begun = time.perf_counter()
    result = yield
    _TIMES[item.nodeid] = time.perf_counter() - begun
    return result


def pytest_unconfigure() -> None:
    """Keep what was recorded; there is one such file a process."""
    _RECORDER.stop()
    _RECORDER.save()
    (FOLDER / f"times-{os.getpid()}.json").write_text(json.dumps(_TIMES), encoding="utf-8")
