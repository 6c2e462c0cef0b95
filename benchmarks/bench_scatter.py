"""How far a hair moves a cycle: python benchmarks/bench_scatter.py [--cells 20] [--first 6000] [--target stream|rapid]

Each cell is a program of bench_rungs.py with one or two stations, planned as it is and five times with all of its
targets 0.1 mm elsewhere, in directions fixed by the cell's number. A row has the cycle as it is and the scatter: from
the fastest of the six plans to the slowest, as a share of the one in the middle. The best plan would move by some
hundredths of a percent. Besides the plan those of the route that the search found and of the first legal
motion.
"""

from __future__ import annotations

import argparse
import re
import tempfile
from pathlib import Path
from time import process_time

import bench_rungs
import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.job import Job, read_job
from trajopt_cli.pipeline.planning import may_change
from trajopt_cli.plan import optimize
from trajopt_cli.plan.initial_plan import NoCleanPlan, PlanCache
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Plan, Target

SHIFT, SHIFTS, MOST_MOVES = 0.1, 5, 9  # mm


def shifted(text: str, by: np.ndarray) -> str:
    """The program with all targets by so much elsewhere [mm]."""

    def moved(found: re.Match[str]) -> str:
        return "[[" + ",".join(f"{float(x) + d:.4f}" for x, d in zip(found[1].split(","), by, strict=True)) + "],["

    return re.sub(r"\[\[([-\d.]+,[-\d.]+,[-\d.]+)\],\[", moved, text)


def job_of(text: str, cell: str) -> Job:
    """What the command reads of a program and a cell."""
    with tempfile.TemporaryDirectory() as place:
        module = Path(place) / "scatter.mod"
        module.write_text(text)
        module.with_suffix(".yaml").write_text(cell)
        return read_job(module)


def cycle(job: Job, target: Target) -> tuple[float, float, float]:
    """Cycle times [s]: of the search's route, of the first legal motion, of the plan."""
    memory = PlanCache()
    plan = optimize(
        job.program, job.plant, target, bounded=False, changes=may_change(job, Loops.KEEP).changes[target],
        memory=memory,
    )  # fmt: skip
    if not isinstance(plan, Plan):
        return (np.nan,) * 3
    ((name, first),) = [one for one in memory.answers.items() if one[0][0] is target and one[0][1] == _freest(memory)]
    return memory.estimates.get(name, np.nan), first.duration, plan.duration


def _freest(memory: PlanCache) -> object:
    return [*memory.answers][-1][1]


def main() -> None:
    """A row a cell, and the middle of all scatters."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=20)
    parser.add_argument("--first", type=int, default=6000, help="number of the first cell")
    parser.add_argument("--target", type=Target, default=Target.STREAM, choices=[*Target])
    parser.add_argument("--each", action="store_true", help="all six times of each cell, too")
    options = parser.parse_args()
    scatters: list[list[float]] = []
    seed = options.first - 1
    while len(scatters) < options.cells:
        seed += 1
        text, cell, kind = bench_rungs.made(seed)
        if text.count("\nMove") > MOST_MOVES:
            continue
        rng, begin = np.random.default_rng(seed), process_time()
        ways = rng.normal(size=(SHIFTS, 3))
        shifts = [np.zeros(3), *(SHIFT * way / np.linalg.norm(way) for way in ways)]
        try:
            times = np.array([cycle(job_of(shifted(text, by), cell), options.target) for by in shifts])
        except (InputError, NoCleanPlan):
            continue
        if not np.isfinite(times[:, 2]).all():
            continue
        spread = 100 * np.ptp(times, axis=0) / np.median(times, axis=0)
        scatters.append(spread.tolist())
        print(
            f"{seed} {text.count(chr(10) + 'Move'):3d} moves {times[0, 2]:8.3f} s  of route, first motion, plan: "
            + " ".join(f"{one:6.3f}" for one in spread)
            + f" %  {process_time() - begin:5.1f} s  {kind}",
            flush=True,
        )
        if options.each:
            for row in times:
                print("      " + " ".join(f"{one:9.4f}" for one in row), flush=True)
    print("in the middle: " + " ".join(f"{one:.3f}" for one in np.median(scatters, axis=0)) + " %")


if __name__ == "__main__":
    main()
