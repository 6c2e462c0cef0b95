"""Small random programs through everything: optimised, judged, exported, read back.

A program has one to three moves of an arm alone or on a rail; some have a wait, a tool, a work object, a corner or a
time. What must hold of each is in `round_trip`; `program(seed, number)` is the same text wherever it is made.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from contextlib import redirect_stdout
from dataclasses import dataclass
from functools import cache
from io import StringIO
from pathlib import Path

import numpy as np
from typer.main import get_command

from trajopt_cli.errors import InputErrorGroup
from trajopt_cli.geometry import Array, inverse_pose, pose, rotation_about
from trajopt_cli.job import Job, read_job
from trajopt_cli.motion import Move, MoveAbsJ, MoveC, MoveJ, MoveL, Program, Wait
from trajopt_cli.pipeline.folder import rapid_export, verify_file, verify_results
from trajopt_cli.pipeline.optimize import OptimizedJob, optimize_job
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.robot.model import RobotModel, load_robot
from trajopt_cli.runs.results import CSV

ARMS = ("irb140",) * 4 + ("irb120",) * 3 + ("irb1200_5_90",) * 2 + ("irb1600_6_120",) * 2 + ("irb140_rail",)
RATES = (250.0, 500.0, 1000.0)  # Hz of the exported joint CSV
PLACE, TURN = 2e-6, 2e-6  # m, rad by which a written target may differ: 1e-3 mm and 1e-6 are written
TIME = 1e-6  # s, and share of a cycle time, that two of them may differ by


@dataclass(frozen=True)
class Small:
    """A program, its cell file, and the rate its plan is exported at."""

    text: str
    cell: str
    rate: float


class _Maker:
    def __init__(self, rng: random.Random):
        self.rng = rng
        name = rng.choice(ARMS)
        self.robot: RobotModel = load_robot(name)
        self.name, self.rail = name, self.robot.has_rail
        self.limits = self.robot.profile()
        self.at = self.axes([0.0, 0.0, 0.0, 0.0, np.radians(rng.choice([30, 45, 60])), 0.0])
        self.X_FT, self.X_WO = np.eye(4), np.eye(4)
        self.lines: list[str] = []
        self.data: list[str] = []

    def axes(self, joints: list[float]) -> Array:
        return np.r_[[0.0] if self.rail else [], joints]

    def pick(self, *things: str) -> str:
        return self.rng.choice(things)

    def numbers(self, values: Array, digits: str) -> str:
        return ",".join(f"{value + 0.0:{digits}}" for value in values)

    def orientation(self, R: Array) -> str:
        w, x, y, z = (
            np.sqrt(max(0.0, one)) / 2
            for one in (
                1 + R[0, 0] + R[1, 1] + R[2, 2],
                1 + R[0, 0] - R[1, 1] - R[2, 2],
                1 - R[0, 0] + R[1, 1] - R[2, 2],
                1 - R[0, 0] - R[1, 1] + R[2, 2],
            )
        )
        q = np.array(
            [
                w,
                np.copysign(x, R[2, 1] - R[1, 2]),
                np.copysign(y, R[0, 2] - R[2, 0]),
                np.copysign(z, R[1, 0] - R[0, 1]),
            ]
        )
        return f"[{self.numbers(q / np.linalg.norm(q), '.9f')}]"

    def frame(self, reach: float, turn: float) -> Array:
        """A random pose: so far away at most, turned so far at most."""
        axis = np.array([self.rng.gauss(0, 1) for _ in range(3)])
        R = rotation_about(axis / np.linalg.norm(axis), self.rng.uniform(-turn, turn))
        return pose(R, np.array([self.rng.uniform(-reach, reach) for _ in range(3)]))

    def eax(self, rail: float) -> str:
        return f"[{f'{1e3 * rail:.3f}' if self.rail else '9E9'},9E9,9E9,9E9,9E9,9E9]"

    def rail_of(self, spread: float) -> float:
        return float(np.clip(self.at[0] + self.rng.uniform(-spread, spread), -0.1, 1.2)) if self.rail else 0.0

    def joints(self, spread: float) -> Array:
        """Axes near where the arm is, inside its limits."""
        arm = slice(-6, None)
        q = self.at.copy()
        low, high = self.limits.lower[arm] + 0.02, self.limits.upper[arm] - 0.02
        q[arm] = np.clip(q[arm] + [self.rng.uniform(-spread, spread) for _ in range(6)], low, high)
        if self.rail:
            q[0] = self.rail_of(2 * spread)
        return q

    def robtarget(self, X_WT: Array, rail: float, arm: Array) -> str:
        X = inverse_pose(self.X_WO) @ X_WT
        conf = self.robot.confdata(arm)
        confdata = f"[{conf.cf1},{conf.cf4},{conf.cf6},{conf.cfx}]"
        place = self.numbers(1e3 * X[:3, 3], ".3f")
        return f"[[{place}],{self.orientation(X[:3, :3])},{confdata},{self.eax(rail)}]"

    def tcp(self) -> Array:
        return self.robot.forward(self.at) @ self.X_FT

    def move(self, kind: str, last: bool) -> None:
        rng = self.rng
        speeds = ("v200", "v500", "v1000", "v2500", "vmax")
        spread = rng.choice([0.02, 0.2, 0.6, 1.2])
        speed = self.pick("v50", *speeds) if spread < 0.5 else self.pick(*speeds)  # v50 over 1.5 m is 30,000 rows
        if kind != "MoveAbsJ" and rng.random() < 0.08:
            speed += f"\\T:={rng.uniform(0.5, 4):.2f}"
        zone = "fine" if last or rng.random() < 0.6 else self.pick("z1", "z10", "z50", "z0")
        tail = f"{speed}, {zone}, tGrip\\WObj:=wobjHere;"
        if kind == "MoveAbsJ":
            self.at = self.joints(spread)
            arm = self.numbers(np.degrees(self.at[-6:]), ".4f")
            self.lines.append(f"MoveAbsJ [[{arm}],{self.eax(self.at[0])}], {tail}")
        elif kind == "MoveJ":
            self.at = self.joints(spread)
            self.lines.append(f"MoveJ {self.robtarget(self.tcp(), self.at[0], self.at[-6:])}, {tail}")
        else:  # along a line or an arc nearby; whether its end can be reached is the optimiser's to say
            step = rng.choice([0.002, 0.02, 0.1, 0.2])
            ways = [self.frame(step, turn) for turn in (rng.choice([0.0, 0.2]), rng.choice([0.0, 0.5]))]
            rail = self.rail_of(step)
            X = self.tcp()
            points = [pose(X[:3, :3] @ one[:3, :3], X[:3, 3] + one[:3, 3]) for one in ways]
            near = self.near(points[-1] @ inverse_pose(self.X_FT), rail)
            texts = [self.robtarget(one, rail, near) for one in points]
            if kind == "MoveL":
                self.lines.append(f"MoveL {texts[-1]}, {tail}")
            else:
                self.lines.append(f"MoveC {texts[0]}, {texts[1]}, {tail}")
            self.at = np.r_[[rail] if self.rail else [], near]

    def near(self, X_WF: Array, rail: float) -> Array:
        """The joints that reach a flange pose nearest to where the arm is; where it is, if none do."""
        found = self.robot.solutions(X_WF, rail if self.rail else None, self.limits)
        here = self.at[-6:]
        return min((arm for _, arm in found), key=lambda arm: float(np.abs(arm - here).max()), default=here)

    def made(self) -> Small:
        rng = self.rng
        start = self.at.copy()
        tool = "PERS tooldata tGrip:=[TRUE,[[0,0,0],[1,0,0,0]],[0.001,[0,0,0.001],[1,0,0,0],0,0,0]];"
        if rng.random() < 0.3:
            self.X_FT = self.frame(0.08, 1.0)
            tool = (
                f"PERS tooldata tGrip:=[TRUE,[[{self.numbers(1e3 * self.X_FT[:3, 3], '.3f')}],"
                f"{self.orientation(self.X_FT[:3, :3])}],[1,[0,0,50],[1,0,0,0],0,0,0]];"
            )
        wobj = 'PERS wobjdata wobjHere:=[FALSE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];'
        if rng.random() < 0.2:
            self.X_WO = self.frame(0.5, 1.0)
            wobj = (
                f'PERS wobjdata wobjHere:=[FALSE,TRUE,"",[[{self.numbers(1e3 * self.X_WO[:3, 3], ".3f")}],'
                f"{self.orientation(self.X_WO[:3, :3])}],[[0,0,0],[1,0,0,0]]];"
            )
        count = rng.choice([1, 1, 1, 2, 2, 3])
        for k in range(count):
            kind = rng.choice(["MoveAbsJ", "MoveJ", "MoveJ", "MoveL", "MoveL", "MoveC"])
            self.move(kind, k == count - 1)
            if rng.random() < 0.1 and ", fine," in self.lines[-1]:
                self.lines.append(f"WaitTime {rng.choice(['0', '0.001', '0.2', '1'])};")
        body = "\n    ".join(self.lines)
        text = f"MODULE Small\n  {tool}\n  {wobj}\n  PROC main()\n    {body}\n  ENDPROC\nENDMODULE\n"
        joints = self.numbers(np.degrees(start[-6:]), ".4f")
        cell = f"robot: {self.name}\nstart: {{joints: '[{joints}] deg'{', rail: 0' if self.rail else ''}}}\n"
        if self.rail:
            grade = 'source: "fuzz"'
            cell += (
                f"rail: {{eax: a, stroke: [-0.2, 1.4]}}\nlimits:\n  rail: {{velocity: 1, acceleration: 3, {grade}}}\n"
            )
        return Small(text, cell, rng.choice(RATES))


def program(seed: int, number: int) -> Small:
    """The small program of a number."""
    return _Maker(random.Random(f"small:{seed}:{number}")).made()


# ------------------------------------------------------------------------------------------------------ what must hold


def round_trip(small: Small, folder: Path) -> str:
    """Optimise, judge, export and read back in an empty folder; how it ended. AssertionError where a promise breaks."""
    module, cell = folder / "small.mod", folder / "small.yaml"
    module.write_text(small.text, encoding="utf-8")
    cell.write_text(small.cell, encoding="utf-8")
    results = folder / "results"
    try:
        job = read_job(module)
    except InputErrorGroup as said:
        if "has no circle" not in str(said):  # all that may be wrong with a program made up here
            raise
        return "refused"
    answer = optimize_job(job, Target.STREAM, results, lambda *_: None, jobs=1)
    if isinstance(answer, Infeasible):
        assert not results.exists(), "an answer no has left a folder"
        assert answer.message, "an answer no does not say why"
        return "infeasible"
    assert isinstance(answer, OptimizedJob), f"no plan: {answer}"
    _check_times(answer)
    judged_job, reports = verify_results(results, advice=False)  # the run itself has asked for that
    assert len(judged_job.program.motions) == len(job.program.motions)
    for name, report in reports.items():
        assert report.legal, f"{name}: {_why(report)}"
    sampled = folder / "joint.csv"
    _export_joint(results, sampled, small.rate)
    report = verify_file(sampled, job)
    assert report.legal, f"joint CSV at {small.rate:g} Hz: {_why(report)}"
    if answer.no_rapid is not None:
        return "no RAPID text"
    back = folder / "back.mod"
    (only,) = rapid_export(results).modules
    back.write_bytes(only.content)
    (folder / "back.yaml").write_text(small.cell, encoding="utf-8")
    again = read_job(back)
    check_same_motions(job, answer.judged[Target.RAPID].plan, again.program)
    report = verify_file(results / CSV[Target.RAPID], again, advice=False)
    assert report.legal, f"rapid.csv against the exported RAPID: {_why(report)}"
    return "planned"


def _why(report: object) -> str:
    findings = [one for one in report.findings if not one.passed]  # type: ignore[attr-defined]
    return findings[0].message or f"{findings[0].check} of {findings[0].subject}"


def _export_joint(results: Path, to: Path, rate: float) -> None:
    asked = ["export", "joint", str(results), "--rate", f"{rate:g}", "--output", str(to)]
    with redirect_stdout(StringIO()) as printed:
        ended = _commands()(asked, standalone_mode=False)
    assert not ended, printed.getvalue()  # an exit code, or None


@cache
def _commands() -> Callable[..., int | None]:
    """The command line, its tree of commands built once."""
    from trajopt_cli.cli import app

    return get_command(app)


def _check_times(answer: OptimizedJob) -> None:
    """Bound <= stream <= RAPID controller <= as written."""
    stream, rapid = (answer.judged[target].plan for target in (Target.STREAM, Target.RAPID))
    for plan in (stream, rapid):
        assert np.isfinite(plan.duration)
        assert plan.duration >= 0
        if plan.lower_bound is not None:
            assert plan.lower_bound <= plan.duration * (1 + TIME) + TIME, (
                f"{plan.target.value}: bound {plan.lower_bound} above {plan.duration}"
            )
    assert stream.duration <= rapid.duration * (1 + TIME) + TIME, f"stream {stream.duration} > rapid {rapid.duration}"
    if isinstance(answer.written, Plan):
        written = answer.written.duration
        assert rapid.duration <= written * (1 + TIME) + TIME, f"rapid {rapid.duration} > as written {written}"


def check_same_motions(job: Job, plan: Plan, again: Program) -> None:
    """The program read back is the plan's: the same instructions in order, less those left out, at the same places."""
    left_out = {motion.index for motion in plan.motions if motion.dropped}
    planned = {motion.index: motion for motion in plan.motions}
    wanted = [(i, motion) for i, motion in enumerate(job.program.motions) if i not in left_out]
    if plan.detours:
        return  # points were added; the writer's own reading is all there is
    assert len(again.motions) == len(wanted), f"{len(wanted)} motions became {len(again.motions)}"
    for (i, ours), theirs in zip(wanted, again.motions, strict=True):
        if isinstance(ours, Wait) and isinstance(theirs, MoveL) and theirs.duration is not None:
            assert abs(ours.duration - theirs.duration) < 1e-6, f"motion {i}: wait"
            continue  # the rail rides meanwhile
        assert type(ours) is type(theirs), f"motion {i}: {type(ours).__name__} became {type(theirs).__name__}"
        if isinstance(ours, Wait):
            assert abs(ours.duration - theirs.duration) < 1e-6, f"motion {i}: wait"
        elif isinstance(ours, MoveJ | MoveL | MoveC):
            _check_pose(ours.X_WT, theirs.X_WT, f"motion {i}")
            if isinstance(ours, MoveC):
                _check_pose(ours.X_WV, theirs.X_WV, f"motion {i}: circle point")
        elif isinstance(ours, MoveAbsJ):
            assert np.abs(np.asarray(ours.q) - np.asarray(theirs.q)).max() < 2e-7, f"motion {i}: joints"
        if isinstance(ours, Move) and job.plant.robot.has_rail and (extax := theirs.extax[0]) is not None:
            end = planned[i].q_1[0]
            assert abs(extax - 1e3 * end) < 1e-2 or abs(extax - end) < 1e-5, f"motion {i}: rail {extax} for {end}"


def _check_pose(X: Array, Y: Array, what: str) -> None:
    assert np.abs(X[:3, 3] - Y[:3, 3]).max() < PLACE, f"{what}: another place"
    assert np.abs(X[:3, :3] - Y[:3, :3]).max() < TURN, f"{what}: another orientation"
