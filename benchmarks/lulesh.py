"""What LULESH costs on this machine, an element and step, next to which docs/benchmarks.md puts the finite elements.

``python benchmarks/lulesh.py FOLDER``, with a checkout of https://github.com/LLNL/LULESH, compiles it in a folder of
its own by ``g++ -O3 -march=native``, runs the Sedov blast of 30 x 30 x 30 elements on one thread and on two, and adds
the section ``lulesh`` to docs/benchmarks.json. LULESH computes something else: a gas on hexahedra with one point and
Flanagan and Belytschko's hourglass control, by an equation of state that is iterated, without contact.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import tempfile
from pathlib import Path

from measure import THREADS, machine, store

COMPILER = ["g++", "-O3", "-march=native", "-fopenmp", "-DUSE_MPI=0"]
EDGE, STEPS, RUNS = 30, 200, 3
RESULTS = re.compile(r"Final Origin Energy\s*=\s*(\S+).*?Grind time \(us/z/c\)\s*=\s*(\S+)", re.DOTALL)


def main() -> None:
    """Compile LULESH, run it, and store what it costs."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("folder", type=Path, help="checkout of LULESH")
    folder = parser.parse_args().folder.resolve()
    sources = sorted(folder.glob("lulesh*.cc"))
    if not sources:
        parser.error(f"folder: {folder} has no lulesh*.cc; give a checkout of https://github.com/LLNL/LULESH")
    on = machine()
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        program = Path(scratch) / "lulesh"
        subprocess.run([*COMPILER, *sources, "-o", program], check=True)
        for threads in THREADS:
            environment = {**os.environ, "OMP_NUM_THREADS": str(threads)}
            words = [program, "-s", str(EDGE), "-i", str(STEPS)]
            printed = [
                subprocess.run(words, check=True, capture_output=True, text=True, env=environment).stdout
                for _ in range(RUNS)
            ]
            matches = [RESULTS.search(each) for each in printed]
            results = [(float(each[2]) * 1e-6, float(each[1])) for each in matches if each]
            if len(results) < RUNS:
                raise SystemExit(f"LULESH printed no grind time:\n{printed[0]}")
            grind, energy = min(results)
            rows.append({"threads": threads, "element_step": grind, "origin_energy": energy})
    version = subprocess.run(["git", "-C", folder, "rev-parse", "HEAD"], capture_output=True, text=True, check=False)
    compiler = subprocess.run(["g++", "-dumpfullversion"], capture_output=True, text=True, check=True).stdout.strip()
    store("lulesh", {
        "runs": rows, "elements": EDGE**3, "steps": STEPS, "compiler": compiler, "commit": version.stdout.strip()[:7],
    }, on)  # fmt: skip


if __name__ == "__main__":
    main()
