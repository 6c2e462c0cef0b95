"""How far plans of programs with corners stand above their lower bounds, and what the bounds take:
python benchmarks/bench_bound.py [--seeds 0:36] [--target stream|rapid] [--plans FILE].

Every seed is one program on an IRB 140, on a rail or without: lines (in some with joint moves between, in some with
reorientation) through 2 to 8 fly-bys of z10 to z200 at v1000, v5000 or vmax, and home. A line for each: its gap, and
processor seconds of the bound; then median, worst and sum by speed and rail. A bound above its plan ends it with exit
code 1. --plans: cycle times of plans are kept there and read from there, so that bounds alone are found anew.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import process_time

import numpy as np

from trajopt_cli.bound.lower_bound import lower_bound
from trajopt_cli.job import Job, read_job
from trajopt_cli.pipeline.planning import may_change
from trajopt_cli.plan import NoCleanPlan, optimize
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.trajectories.axes import Axes

SPEEDS = ("v1000", "v5000", "vmax")
ZONES = ("z10", "z20", "z50", "z100", "z200")
PATIENCE = 60.0  # s for a plan
BEYOND = 1e-6  # share of a plan that rounding may put its bound above it
CELL = 'robot: irb140\nprofile: default\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\n'
RAIL_CELL = """robot: irb140_rail
profile: default
rail: {eax: a, stroke: [-0.2, 2.2]}
limits:
  rail: {velocity: 1.0, acceleration: 3.0, source: "benchmark"}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""


@dataclass
class Row:
    """A program: what it is, its plan and bound [s], and processor seconds of the bound."""

    seed: int
    speed: str
    rail: bool
    about: str
    plan: float = 0.0
    bound: float = 0.0
    seconds: float = 0.0

    @property
    def gap(self) -> float:
        """In percent."""
        return 100 * (self.plan / self.bound - 1)


def made(seed: int) -> tuple[str, Row]:
    """A program's text and what it is: by its seed in turn every speed, three without a rail and three on one."""
    rng = np.random.default_rng([35, seed])
    speed, rail = SPEEDS[seed % 3], seed // 3 % 2 == 1
    n, mixed, turning = int(rng.integers(2, 9)), rng.random() < 0.25, rng.random() < 0.4
    along = (0.0, 1900.0) if rail else (-320.0, 320.0)
    place = np.array([rng.uniform(400, 560), rng.uniform(*along), rng.uniform(220, 500)])
    targets, body = [], []
    for i in range(n + 2):
        turn = rng.uniform(-0.5, 0.5) if turning else 0.0
        q = f"[0,{np.sin(turn / 2):.7f},{np.cos(turn / 2):.7f},0]"
        eax = f"{place[1]:.1f}" if rail else "9E9"
        x, y, z = place
        targets.append(f"CONST robtarget p{i}:=[[{x:.2f},{y:.2f},{z:.2f}],{q},[0,0,0,0],[{eax},9E9,9E9,9E9,9E9,9E9]];")
        move = "MoveJ" if i == 0 or (mixed and rng.random() < 0.3) else "MoveL"
        zone = "fine" if i in (0, n + 1) else rng.choice(ZONES)
        body.append(f"{move} p{i}, {speed if i else 'v2500'}, {zone}, tool0;")
        for _ in range(100):
            way = rng.normal(size=3) * ([1, 2, 1] if rail else [1, 1, 1])
            there = place + way / np.linalg.norm(way) * rng.uniform(60, 600 if rail else 350)
            if 400 <= there[0] <= 560 and along[0] <= there[1] <= along[1] and 220 <= there[2] <= 500:
                place = there
                break
    home = f"CONST jointtarget home:=[[0,0,0,0,30,0],[{'0' if rail else '9E9'},9E9,9E9,9E9,9E9,9E9]];"
    body.append("MoveAbsJ home, v2500, fine, tool0;")
    text = "\n".join(["MODULE Bench", home, *targets, "PROC main()", *body, "ENDPROC", "ENDMODULE", ""])
    about = f"{n} corners{', joint moves' if mixed else ''}{', turning' if turning else ''}"
    return text, Row(seed, speed, rail, about)


def job_of(text: str, rail: bool) -> Job:
    """The program on its cell."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "bench.mod"
        path.write_text(text)
        path.with_suffix(".yaml").write_text(RAIL_CELL if rail else CELL)
        return read_job(path)


def measured(seed: int, target: Target, known: dict[str, float]) -> Row:
    """Plan and bound of one seed. known: plans by target and seed [s], 0 where there is none; found ones are added."""
    text, row = made(seed)
    job, key = job_of(text, row.rail), f"{target.value} {seed}"
    changes = may_change(job, Loops.KEEP).changes[target]
    if key not in known:
        try:
            plan = optimize(job.program, job.plant, target, bounded=False, changes=changes, patience=Patience(PATIENCE))
        except NoCleanPlan:
            plan = None
        known[key] = plan.duration if isinstance(plan, Plan) else 0.0
    row.plan = known[key]
    if row.plan:
        problem = build_problem(job.program, job.plant, EVERYTHING, target, changes)
        assert isinstance(problem, Problem)
        start = process_time()
        row.bound = lower_bound(Axes.of(job.plant), problem, 1.001 * row.plan)  # above it, so that an error shows
        row.seconds = process_time() - start
    return row


def groups(rows: Sequence[Row]) -> Iterator[tuple[str, list[Row]]]:
    """All, and parts of them by speed and rail."""
    fast = [row for row in rows if row.speed != "v1000"]
    yield "all", [*rows]
    yield "v5000 and vmax", fast
    yield "the same without a rail", [row for row in fast if not row.rail]
    yield "the same on a rail", [row for row in fast if row.rail]
    yield "v1000", [row for row in rows if row.speed == "v1000"]


def main() -> int:
    """Print a line for each seed, and their medians."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", default="0:36")
    parser.add_argument("--target", type=Target, default=Target.STREAM)
    parser.add_argument("--plans", type=Path)
    asked = parser.parse_args()
    known = json.loads(asked.plans.read_text()) if asked.plans and asked.plans.exists() else {}
    rows = []
    for seed in range(*map(int, asked.seeds.split(":"))):
        row = measured(seed, asked.target, known)
        if asked.plans:
            asked.plans.write_text(json.dumps(known))
        said = f"{seed:4d} {row.speed:5} {'rail' if row.rail else '-':4} {row.about:33}"
        if not row.plan:
            print(f"{said} no plan", flush=True)
            continue
        rows.append(row)
        print(
            f"{said} plan {row.plan:.3f} s, bound {row.bound:.3f} s, gap {row.gap:5.1f} %, {row.seconds:.2f} s",
            flush=True,
        )
    for name, some in groups(rows):
        gaps = [row.gap for row in some]
        if gaps:
            seconds = sum(row.seconds for row in some)
            print(
                f"{name:24}{len(some):4d}: median {np.median(gaps):5.1f} %, worst {max(gaps):5.1f} %; {seconds:.1f} s"
            )
    wrong = [row.seed for row in rows if row.bound > row.plan * (1 + BEYOND)]
    print(f"bounds above their plans: {wrong or 'none'}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
