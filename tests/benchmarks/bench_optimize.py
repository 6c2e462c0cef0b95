"""Where the time of `trajopt optimize programs/hinge_cell.mod` goes: python tests/benchmarks/bench_optimize.py [RUNS].

Prints the seconds from command to files (a fresh process, start of Python included) and the split of each run: read,
search, build, solve, check, bound, judge, write.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path
from time import perf_counter

REPOSITORY = Path(__file__).parents[2]
PROGRAM = REPOSITORY / "programs" / "hinge_cell.mod"
GOAL = 15.0  # s from command to files on 2 cores, both targets


def run_once(folder: Path) -> tuple[float, dict[str, float]]:
    """Seconds of one whole command, and its own split by phase."""
    command = [sys.executable, "-m", "trajopt_cli.cli", "optimize", str(PROGRAM), "--output", str(folder)]
    start = perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=REPOSITORY)
    total = perf_counter() - start
    return total, json.loads((folder / "run.json").read_text())["seconds"]


def main(runs: int) -> None:
    """Run, then print the median run's split, phases of both targets side by side."""
    with tempfile.TemporaryDirectory() as place:
        results = sorted((run_once(Path(place) / "results") for _ in range(runs)), key=lambda result: result[0])
    total, seconds = results[len(results) // 2]
    used = os.times()
    cpu = (used.children_user + used.children_system) / runs
    goal = f"goal {GOAL:g} s on 2 cores; here {os.cpu_count()}, {cpu:.1f} s of processor time"
    print(f"{PROGRAM.name}: {total:.2f} s from command to files, median of {runs} ({goal})")
    split: dict[str, dict[str, float]] = defaultdict(dict)
    for name, spent in seconds.items():
        label, _, phase = name.rpartition(": ")
        split[phase][label or "both"] = spent
    slower = max(split["plan"][label] + split["judge"][label] for label in split["plan"])
    rest = total - split["read"]["both"] - split["export"]["both"] - slower
    for phase, by_target in split.items():
        print(f"  {phase:12s}" + "  ".join(f"{label} {spent:6.2f} s" for label, spent in by_target.items()))
    print(f"  {'write':12s}both {rest:6.2f} s (start of Python, table and files)")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 3)
