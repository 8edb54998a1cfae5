"""Try what was built for another machine on this one, by qemu-user or Wine where the processor or system is another.

``python scripts/foreign tests TARGET`` runs the tests of the Rust crates, ``python scripts/foreign wheel TARGET
WHEEL`` uses a wheel in that machine's Python; targets have the names of Rust. C library and Python of another Linux are
unpacked from Debian's packages into out/foreign, Python for Windows from an archive of Maven Central, and nothing is
installed: of a program that is missing, a message says what to install. ``--record`` puts the results into
docs/tested-machines.json, which docs/versions.md shows. The last line is "N passed, N failed".
"""

from __future__ import annotations

import argparse
import shlex
import sys
from pathlib import Path

from record import record
from rust_tests import run_tests
from targets import TARGETS, runner
from wheel_trial import PACKAGES, try_wheel
from windows_python import ARCHIVES


def main() -> int:
    """Run what the command line asks for and return how many tests failed."""
    parser = argparse.ArgumentParser(description="Try what was built for another machine on this one.")
    what = parser.add_subparsers(dest="what", required=True)
    for name, words in (
        ("tests", "run the tests of the Rust crates"),
        ("wheel", "use a wheel in that machine's Python"),
    ):
        each = what.add_parser(name, help=words)
        each.add_argument("target", choices=TARGETS)
        each.add_argument("--record", action="store_true", help="put the results into docs/tested-machines.json")
    each.add_argument("wheel", type=Path)
    each.add_argument(
        "--python", default="", help="its command, if it is not Debian's, such as that of a Python for musl"
    )
    each.add_argument("--version", choices=ARCHIVES, default="3.11", help="that of a Python for Windows")
    each.add_argument("--pytest", default="", help="what to run in place of the usual tests")
    options = parser.parse_args()
    target = TARGETS[options.target]
    if options.what == "tests":
        how = runner(target)
        results = run_tests(target, how)
    else:
        how = runner(target, PACKAGES)
        program, pytest = shlex.split(options.python), shlex.split(options.pytest)
        if not program and target.c_library != "glibc" and target.system != "Windows":
            parser.error(f"Debian has no Python for {target.triple}: name one by --python")
        results = try_wheel(target, how, options.wheel.resolve(), program, pytest, options.version)
    if options.record:
        record(target, options.what, how.how, results)
    print(f"{results['passed']} passed, {results['failed']} failed")
    return results["failed"]


if __name__ == "__main__":
    sys.exit(main() > 0)
