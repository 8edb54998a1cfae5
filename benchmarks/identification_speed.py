"""Time of the whole published identification: 200 by 100 sets of parameters on 550 drives, and five refinements.

Prints wall and processor time and memory next to what they bought: cost and parameters.
"""

from __future__ import annotations

import argparse
import resource
import time

import clubface
from clubface.validation import benchmark_data

PUBLISHED_SECONDS = 0.0683
"""CPU time of one volumetric impact in Caldwell and McPhee's Table 3 at 2.3 GHz: 0.683 s for ten."""


def main() -> None:
    """Identify one model of the driver and print the figures."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--model", default="volumetric")
    parser.add_argument("--threads", type=int, default=None)
    chosen = parser.parse_args()
    shots = benchmark_data.load("driver").measured
    began, processor = time.perf_counter(), time.process_time()
    fit = clubface.identify(
        shots, club="driver-as-printed", model=chosen.model, threads=chosen.threads, folds=0, bootstrap=0, profiles=()
    )
    wall, processor = time.perf_counter() - began, time.process_time() - processor
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    print(f"{fit.model}: {fit.shots} drives, {fit.evaluations:,} sets of parameters, {fit.impacts:,} impacts")
    print(f"wall {wall:.1f} s, processor {processor:.1f} s, memory {memory:.0f} MB at most")
    print(f"cost (22) {fit.cost:.6f}; the refinements ended at {', '.join(f'{cost:.6f}' for cost in fit.refined)}")
    for name in fit.free:
        print(f"  {name:<18} {fit.shown(name, float(fit.parameters.values[name]), 5)}")
    if chosen.model == "volumetric":
        days = fit.impacts * PUBLISHED_SECONDS / 86400.0
        print(f"at the published processor time of an impact, {PUBLISHED_SECONDS} s: {days:.1f} days")


if __name__ == "__main__":
    main()
