"""What a long run costs: python benchmarks/bench_runs.py [POINTS ...] [--rail], 100 and 1,000 points by default.

A circle of z1 at v100 in steps of 0.6 mm, one run between two stops; with --rail the arm rides one, which is free.
Prints the seconds of processor time to a legal motion, split by phase, per point, and the most memory held so far.
"""

from __future__ import annotations

import resource
import sys
import tempfile
from pathlib import Path
from time import process_time

import numpy as np

from trajopt_cli.graph_search.reach import check_reach
from trajopt_cli.graph_search.search import search
from trajopt_cli.job import read_job
from trajopt_cli.path_timing.path_parameterized_plan import duration, timed
from trajopt_cli.plan.rail_refinement import refine_rail
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes

STEP = 0.6  # mm between points
LARGEST = 96.0  # mm, the circle's radius; longer contours go round again
CELLS = {
    False: "robot: irb140\nprofile: default\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n",
    True: "robot: irb140_rail\nprofile: default\nrail: {eax: a, stroke: [-0.2, 2.2]}\n"
    "limits:\n  rail: {velocity: 1.0, acceleration: 3.0, source: agreed}\n"
    "start: {joints: '[0, 0, 0, 0, 30, 0] deg', rail: 0}\n",
}


def program(points: int, rail: bool) -> str:
    """RAPID of the contour."""
    radius = min(LARGEST, points * STEP / (2 * np.pi))
    axis = "300" if rail else "9E9"
    y = 300 if rail else 0

    def move(word: str, x: float, y: float, z: float, how: str) -> str:
        place = f"[[{x:.3f},{y:.3f},{z:.3f}],[0,0,1,0],[0,0,0,0],[{axis},9E9,9E9,9E9,9E9,9E9]]"
        return f"{word} {place},{how},tool0;"

    lines = [
        "MODULE m",
        "PROC main()",
        "ConfL \\Off;",
        "ConfJ \\Off;",
        move("MoveJ", 450 + radius, y, 450, "v500,fine"),
    ]
    for i in range(points + 1):
        phi = i * STEP / radius
        how = "v100,fine" if i in (0, points) else "v100,z1"
        lines.append(move("MoveL", 450 + radius * np.cos(phi), y + radius * np.sin(phi), 400, how))
    return "\n".join([*lines, "ENDPROC", "ENDMODULE"])


def measure(points: int, rail: bool, folder: Path) -> None:
    """One contour, timed phase by phase."""
    (folder / "contour.mod").write_text(program(points, rail))
    (folder / "contour.yaml").write_text(CELLS[rail])
    seconds: dict[str, float] = {}

    def until(phase: str, start: float) -> float:
        seconds[phase] = process_time() - start
        return process_time()

    at = process_time()
    job = read_job([folder / "contour.mod"])
    at = until("read", at)
    axes, changes = Axes.of(job.plant), everything(job.program, job.plant)
    problem = build_problem(job.program, job.plant, EVERYTHING, Target.RAPID, changes, frozenset())
    assert isinstance(problem, Problem)
    assert check_reach(axes, problem) is None
    at = until("reach", at)
    route = search(axes, problem)
    assert route is not None
    at = until("search", at)
    route = refine_rail(axes, problem, route)
    at = until("rail", at)
    iterate = timed(axes, problem, route)
    until("timing", at)
    total, memory = sum(seconds.values()), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    split = "  ".join(f"{phase} {spent:.2f}" for phase, spent in seconds.items())
    print(
        f"{points:6d} points{', rail' if rail else ''}: {total:.2f} s, {total / points * 1e3:.2f} ms a point; {split}"
    )
    print(f"       motion of {duration(iterate):.4f} s in {len(problem.runs)} runs; {memory:.0f} MiB at most so far")


def main(words: list[str]) -> None:
    """Every number of points asked for."""
    sizes = [int(word) for word in words if word != "--rail"] or [100, 1000]
    with tempfile.TemporaryDirectory() as place:
        for points in sizes:
            measure(points, "--rail" in words, Path(place))


if __name__ == "__main__":
    main(sys.argv[1:])
