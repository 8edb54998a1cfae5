"""The tests of the Rust crates as another machine runs them."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import time
from typing import Any

from targets import ROOT, Runner, Target

EVERYTHING = ("--no-fail-fast",)
EMULATED = (
    # Packs and what runs in them, against the same numbers and shots one by one.
    "--test verification -- dual elementary lanes ode packs rotations batches flight batch_derivatives",
    # Elements in packs of every width, patches that must take up constant strain, a team of threads.
    "--test fem -- elements tetrahedra patches derived_forces worker_pool",
    # Shots, flights, maps, golfers and impacts by finite elements against the numbers that x86 computed.
    "--test golden",
)
"""What runs in packs and what compares with another machine: all tests would take hours."""
RESULT = re.compile(r"^test result: .*?(\d+) passed; (\d+) failed; (\d+) ignored;")


def run_tests(target: Target, runner: Runner) -> dict[str, Any]:
    """Run the tests of a target and return what is recorded: which ran, counts, seconds."""
    counts: dict[str, int] = dict.fromkeys(("passed", "failed", "skipped"), 0)
    began = time.monotonic()
    for arguments in EMULATED if runner.emulated else EVERYTHING:
        command = [*cargo(target), *arguments.split()]
        print("+", shlex.join(command), flush=True)
        status = _run(command, environment(target, runner), counts)
        if status and not counts["failed"]:
            counts["failed"] = 1  # did not compile, or a program stopped without a word
    return {"tests": "a selection" if runner.emulated else "all", **counts, "seconds": round(time.monotonic() - began)}


def cargo(target: Target) -> list[str]:
    """Return the command that compiles tests for a target and runs them."""
    # One selection of packages, whatever runs: the features of what they share depend on it, and with them what is
    # compiled anew.
    options = ["test", "--release", "--locked", "--workspace"]
    options += ["--exclude", "clubface-python", "--exclude", "clubface-benches"]
    if target.native and target.c_library != "musl":
        return ["cargo", *options]
    return ["scripts/with-zig.sh", target.triple, "cargo-zigbuild", *options, "--target", target.triple]


def environment(target: Target, runner: Runner) -> dict[str, str]:
    """Return the variables by which cargo finds the runner."""
    name = f"CARGO_TARGET_{target.triple.upper().replace('-', '_')}_RUNNER"
    return {**os.environ, **runner.variables, **({name: shlex.join(runner.command)} if runner.command else {})}


def _run(command: list[str], variables: dict[str, str], counts: dict[str, int]) -> int:
    with subprocess.Popen(
        command, cwd=ROOT, env=variables, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            print(line, end="", flush=True)
            if result := RESULT.match(line):
                passed, failed, ignored = map(int, result.groups())
                counts["passed"] += passed
                counts["failed"] += failed
                counts["skipped"] += ignored
    return process.returncode
