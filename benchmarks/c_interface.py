"""What a launch and its derivatives cost in C, CasADi and Octave, one shot and a thousand.

``python benchmarks/c_interface.py PREFIX [FILE]`` compiles programs against the libclubface installed in PREFIX (``make
libclubface PREFIX=...``), prints the shortest of several times on the clock and the result of each computation, which
must agree from row to row, and puts both into FILE; docs/c-interface.md reads docs/c-interface-costs.json. The shots
are those of ``array_libraries.py``. What is not installed is left out, and keeps its entries in the file.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from array_libraries import DRIVE, LOFT, ONE, THOUSAND, WORK, Cost, cost, numpy_calls, tabulate

from clubface.export import casadi_source, inputs_csv

HERE = Path(__file__).parent
MATLAB = HERE.parent / "crates" / "clubface-c" / "examples" / "matlab"
OCTAVE = """
addpath('{matlab}');
[shot, parameters, names] = read_shot('shot.csv');
[~, outputs] = ismember({{{variables}}}, names);
for rows = [1 1000]
    shots = repmat(shot, rows, 1);
    if rows > 1
        shots(:, outputs) = shots(:, outputs) .* linspace(0.98, 1.02, rows)';
    end
    shortest = [Inf Inf];
    for work = 1:2
        begin = tic;
        run = 0;
        while run < 6 || toc(begin) < 0.5
            start = tic;
            if work == 1
                values = clubface_launch('{model}', shots, parameters, {{{wanted}}});
            else
                [~, jacobian] = clubface_launch('{model}', shots, parameters, {{{wanted}}}, {{{variables}}});
            end
            if run > 0
                shortest(work) = min(shortest(work), toc(start));
            end
            run = run + 1;
        end
    end
    printf('%.9g %.9g %.9g %.9g\\n', 1e3 * shortest, mean(values(:, 1)), mean(jacobian(:, 5, {loft})));
end
"""


def run(*command: object, folder: Path) -> str:
    """Return what a program prints."""
    words = [str(each) for each in command]
    return subprocess.run(words, cwd=folder, stdout=subprocess.PIPE, text=True, check=True).stdout


def costs(model: str, prefix: Path, folder: Path) -> Iterator[Cost]:
    """Yield the cost of a launch and of its derivatives in every interface."""
    environment = {**os.environ, "PKG_CONFIG_PATH": str(prefix / "lib" / "pkgconfig")}
    printed = subprocess.check_output(["pkg-config", "--cflags", "--libs", "clubface"], env=environment, text=True)
    flags = [*printed.split(), f"-Wl,-rpath,{prefix / 'lib'}"]
    calls = numpy_calls(model)
    for rows in (ONE, THOUSAND):
        for work in WORK[:2]:
            yield cost("Python", work, calls[work], rows)

    (folder / "shot.csv").write_text(inputs_csv("driver", DRIVE, model=model))
    run("cc", "-O2", HERE / "c_interface_cost.c", *flags, "-o", "cost", folder=folder)
    for shots in (1, 1000):
        yield from _read("C", shots, run("./cost", model, "shot.csv", shots, folder=folder))

    if find_spec("casadi"):
        import casadi

        (folder / "impact.c").write_text(casadi_source("driver", model=model, variables=list(DRIVE)))
        library = folder / f"{model}.so"
        run("cc", "-O2", "-shared", "-fPIC", "impact.c", *flags, "-o", library, folder=folder)
        one = casadi.external("impact", str(library))
        slopes = one.jacobian()
        for rows, launch, jacobian in ((ONE, one, slopes), (THOUSAND, one.map(1000), slopes.map(1000))):
            columns = np.ascontiguousarray(np.atleast_2d(rows).T)
            unused = launch(columns)
            speed = cost("CasADi", WORK[0], lambda _, f=launch, x=columns: np.array(f(x))[0], rows)
            slope = cost(
                "CasADi", WORK[1],
                lambda _, f=jacobian, x=columns, y=unused: np.array(f(x, y))[4, LOFT :: len(DRIVE)], rows,
            )  # fmt: skip
            yield from (speed, slope)

    if shutil.which("octave-cli") and shutil.which("mkoctfile"):
        run("mkoctfile", "--mex", MATLAB / "clubface_launch.c", *flags, folder=folder)
        from clubface.equipment.models import model as described
        from clubface.simulation.results import outputs

        lacks = described(model).lacks
        script = OCTAVE.format(
            matlab=MATLAB, model=model, variables=", ".join(f"'{name}'" for name in DRIVE), loft=LOFT + 1,
            wanted=", ".join(f"'{name}'" for name in outputs() if name not in lacks),
        )  # fmt: skip
        (folder / "measure.m").write_text(script)
        lines = run("octave-cli", "-q", "--no-history", "measure.m", folder=folder).splitlines()
        for shots, line in zip((1, 1000), lines, strict=True):
            yield from _read("Octave", shots, line)


def _read(interface: str, shots: int, line: str) -> Iterator[Cost]:
    """Yield the two costs of a line: times [ms] of both works, results of both."""
    first, second, speed, slope = map(float, line.split())
    yield Cost(interface, WORK[0], shots, first * 1e-3, speed)
    yield Cost(interface, WORK[1], shots, second * 1e-3, slope)


def main(prefix: str, file: str | None = None) -> None:
    """Print what everything costs, and put it into a file."""

    def in_a_folder(model: str) -> Iterator[Cost]:
        # Of its own: a library that has been loaded from a path is not loaded from it again.
        with tempfile.TemporaryDirectory() as folder:
            yield from costs(model, Path(prefix).resolve(), Path(folder))

    tabulate(in_a_folder, file)


if __name__ == "__main__":
    main(*sys.argv[1:])
