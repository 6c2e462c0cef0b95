"""A tiny program and a planner that moves joint 1 by known parabolas, so that commands run in a moment."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run
from trajopt_cli.job import Job
from trajopt_cli.motion import Program, Wait
from trajopt_cli.problem.decision_scope import EVERYTHING, Freedom
from trajopt_cli.problem.editable import Changes
from trajopt_cli.problem.plan import Infeasible, Plan, PlannedMotion, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.progress import Progress
from trajopt_cli.study import comparison
from trajopt_cli.trajectory import Trajectory

TEXT = """MODULE Tiny
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_side:=[[20,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveAbsJ j_side, v1000, fine, tool0;
        WaitTime 0.5;
        MoveAbsJ j_home, v1000, fine, tool0;
    ENDPROC
ENDMODULE
"""
CELL = "robot: irb140\nsettle: 0\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n"
# rad/s2 on joint_1, under its 15; the TCP, 0.51 m off, stays under v1000's 1 m/s
ACCELERATION = {Target.STREAM: 10.0, Target.RAPID: 8.0}


@dataclass
class Planner:
    """Stands in for the optimiser. speed scales time: 1 is legal, 2 is not; freest: of plans that may choose
    the configuration. answer: what to give back instead."""

    speed: float = 1.0
    freest: float = 1.0
    answer: Infeasible | None = None
    asked: list[Target] = field(default_factory=list)

    def __call__(
        self,
        program: Program,
        plant: Plant,
        target: Target,
        freedom: Freedom = EVERYTHING,
        progress: Callable[[Progress], None] = lambda _: None,
        bounded: bool = True,
        changes: Changes | None = None,
        **more: object,
    ) -> Plan | Infeasible:
        self.asked.append(target)
        progress(Progress("search", 2.0, 1.6))
        return self.answer or plan(program, plant, target, self.speed * (self.freest if freedom.configuration else 1.0))


def plan(program: Program, plant: Plant, target: Target, speed: float) -> Plan:
    a = ACCELERATION[target] * speed**2
    goals = [motion.q[0] if not isinstance(motion, Wait) else None for motion in program.motions]
    t_0, now, knots, motions = 0.0, 0.0, [0.0], []
    pieces: list[tuple[float, float, float, float]] = []  # start, half time, from, acceleration
    for i, (motion, goal) in enumerate(zip(program.motions, goals, strict=True)):
        q_0 = np.array([now, *plant.start[1:]])
        if goal is None:
            duration = motion.duration / speed
        else:
            half = np.sqrt(abs(goal - now) / a)
            pieces.append((t_0, half, now, np.sign(goal - now) * a))
            knots.append(t_0 + half)
            duration, now = 2 * half, float(goal)
        q_1 = np.array([now, *plant.start[1:]])
        motions.append(PlannedMotion(i, motion.source, t_0, t_0 + duration, q_0, q_1, "joint_1 acceleration"))
        t_0 += duration
        knots.append(t_0)
    grid = np.arange(0.0, t_0, 4e-3)
    near = np.min(np.abs(grid[:, None] - np.array(knots)), axis=1) < 1e-4
    t = np.union1d(grid[~near], knots)
    q, qd = np.tile(plant.start, (len(t), 1)), np.zeros((len(t), len(plant.start)))
    for start, half, begin, acceleration in pieces:
        u = np.clip(t - start, 0.0, 2 * half)
        down = np.maximum(u - half, 0.0)
        on = t >= start
        q[on, 0] = (begin + acceleration * (u**2 / 2 - down**2))[on]
        qd[on, 0] = (acceleration * (u - 2 * down))[on]
    return Plan(target, Trajectory(plant.robot.axis_names, t, q, qd), tuple(motions), 0.9 * t_0, "closed form")


@pytest.fixture
def planner(monkeypatch: pytest.MonkeyPatch) -> Planner:
    stand_in = Planner()
    monkeypatch.setattr("trajopt_cli.plan.optimize", stand_in)
    monkeypatch.setattr("trajopt_cli.plan.slow_plan", lambda *question: None)
    monkeypatch.setattr("trajopt_cli.plan.lower_bound_of", lambda program, plant, plan, **more: 0.9 * plan.duration)
    for place in ("trajopt_cli.workers.cores", "trajopt_cli.pipeline.optimize.cores"):
        monkeypatch.setattr(place, lambda: 1)  # another process takes longer than such a plan
    return stand_in


@pytest.fixture
def program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """tiny.mod with its cell file in a working directory of its own; the path is relative, as people type it."""
    monkeypatch.chdir(tmp_path)
    Path("tiny.mod").write_text(TEXT)
    Path("tiny.yaml").write_text(CELL)
    return Path("tiny.mod")


_RESULTS: dict[str, bytes] = {}


@pytest.fixture
def results(planner: Planner, program: Path) -> Path:
    """The results of the tiny program, results/tiny: made once, the same bytes for every test."""
    folder = Path("results/tiny")
    if not _RESULTS:
        assert run(["optimize", str(program), "--quiet"]) == 0
        planner.asked.clear()
        _RESULTS.update(
            {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
        )
    else:
        for name, content in _RESULTS.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(content)
    return folder


_COMPARED: dict[tuple[object, ...], comparison.Comparison] = {}


@pytest.fixture
def compared_once(planner: Planner, monkeypatch: pytest.MonkeyPatch) -> None:
    """For tests of what is told of a comparison: that of the tiny program as it is, with one planner, is made once."""
    made = comparison.compare

    def compare(job: Job, listen: object, *rest: object) -> comparison.Comparison:
        key = (planner.speed, planner.freest, *rest[:2])  # whatever the patience
        if key not in _COMPARED:
            _COMPARED[key] = made(job, listen, *rest)  # type: ignore[arg-type]
        return replace(_COMPARED[key], job=job)

    monkeypatch.setattr(comparison, "compare", compare)
