"""What the rows cost that time a motion themselves: python benchmarks/bench_baselines.py [PROGRAM ...].

Prints the fixed-rail plan they stand on, then each row's cycle time, whether it is legal, and the seconds it took.
"""

from __future__ import annotations

import sys
from pathlib import Path
from time import perf_counter

from trajopt_cli.job import read_job
from trajopt_cli.judge.verify import verify
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import FIXED_RAIL
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.study.cartesian import bang_bang_row
from trajopt_cli.study.case import Attempt, Case
from trajopt_cli.study.ruckig_row import ruckig, ruckig_jerk
from trajopt_cli.study.toppra_row import toppra

PROGRAMS = Path(__file__).parents[1] / "programs"
ROWS = {"bang-bang": bang_bang_row, "ruckig": ruckig, "ruckig jerk": ruckig_jerk, "toppra": toppra}
GOAL = 3.0  # s per row on hinge_cell


def main(names: list[str]) -> None:
    """Solve each program's fixed-rail plan once, then make and judge every row."""
    for name in names:
        job = read_job(PROGRAMS / f"{name}.mod")
        start = perf_counter()
        plan = optimize(job.program, job.plant, Target.STREAM, FIXED_RAIL, bounded=False)
        if isinstance(plan, Infeasible):
            print(f"{name}: {plan}")
            continue
        print(f"{name}: fixed-rail plan {plan.duration:.4f} s, solved in {perf_counter() - start:.2f} s")
        for label, row in ROWS.items():
            start = perf_counter()
            made = row(Case(job.program, job.plant, lambda *_, plan=plan: plan))
            seconds = perf_counter() - start
            if not isinstance(made, Attempt):
                print(f"  {label:12s}{made}")
                continue
            report = verify(made.program, job.plant, made.trajectory, None, made.dropped, Target.STREAM, advice=False)
            word = "legal" if report.legal else "illegal"
            print(f"  {label:12s}{made.trajectory.duration:9.4f} s  {word:8s}{seconds:6.2f} s (goal {GOAL:g} s)")


if __name__ == "__main__":
    main(sys.argv[1:] or ["hinge_cell", "bench_irb140", "hinge_line"])
