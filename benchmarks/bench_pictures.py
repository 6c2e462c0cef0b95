"""All pictures of a program's plan: seconds of one core to draw them, and the largest file.

python benchmarks/bench_pictures.py [PROGRAM]
"""

from __future__ import annotations

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before NumPy starts its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import sys
from pathlib import Path
from time import perf_counter, process_time

sys.path.insert(0, str(Path(__file__).parents[1]))  # run from a checkout without installing

from trajopt_cli.job import read_job
from trajopt_cli.plan import optimize
from trajopt_cli.problem.plan import Infeasible, Target

HINGE_CELL = Path(__file__).parents[1] / "programs" / "hinge_cell.mod"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", nargs="?", type=Path, default=HINGE_CELL)
    options = parser.parse_args()
    job = read_job(options.program)
    plan = optimize(job.program, job.plant, Target.STREAM, bounded=False)
    if isinstance(plan, Infeasible):
        raise SystemExit(str(plan))
    cpu, wall = process_time(), perf_counter()
    from trajopt_cli.report.pictures import draw

    files = draw(job.program, job.plant, plan, options.program.stem)
    cpu, wall = process_time() - cpu, perf_counter() - wall
    largest = max((name for name in files if name.endswith(".svg")), key=lambda name: len(files[name]))
    print(f"{len(files)} files: {cpu:.2f} s of one core, {wall:.2f} s by the clock, import of matplotlib included")
    print(f"load average of the machine: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    print(f"largest SVG: {largest}, {len(files[largest]) / 1000:.0f} kB")


if __name__ == "__main__":
    main()
