"""Zones larger than half the way: python benchmarks/bench_zones.py [--seeds 0:200] [--jobs N] [--plan] [--keep FOLDER]

Every seed is a program of short ways, 2 to 25 mm and now and then a long one, with reorientation: lines, arcs, joint
moves and turns in place, one tool or two, on a robot without a rail or with one, at v50 to v1000. Its zones reach
beyond the middle of the ways. Driven as written it must take at most 0.5 % longer with these than with the SMALLEST
zone at all these points; where stops at all of them are faster, that is told, too. --plan: both targets are planned as
well, as far as the first legal plan, and the judge reads them. Prints a line for every program that falls short, the
worst, and the counts; exit code 1 where a program falls short.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

sys.path[:0] = [str(Path(__file__).parents[1])]  # run from a checkout without installing

from trajopt_cli.errors import InputError  # noqa: E402
from trajopt_cli.geometry import Array, rotation_about, wxyz_from_rotation  # noqa: E402
from trajopt_cli.job import Job, read_job  # noqa: E402
from trajopt_cli.judge.verify import verify  # noqa: E402
from trajopt_cli.pipeline.planning import may_change  # noqa: E402
from trajopt_cli.plan import NoCleanPlan, optimize  # noqa: E402
from trajopt_cli.problem.editable import Loops  # noqa: E402
from trajopt_cli.problem.plan import Plan, Target  # noqa: E402
from trajopt_cli.problem.stop_condition import Patience  # noqa: E402
from trajopt_cli.robot.model import load_robot  # noqa: E402
from trajopt_cli.study.estimate import estimate  # noqa: E402

ROBOTS = ("irb140", "irb140_rail", "irb1200_5_90", "irb2600_12_165", "irb4600_40_255", "irb6700_200_260")
LARGE = ("z10", "z15", "z20", "z50", "z100", "[FALSE,12,40,40,0.5,40,5]", "[FALSE,20,20,20,60,20,60]")
SMALLEST = "z0"
ENOUGH = 1.005  # times what the smallest zone takes
DRAWS = 8  # programs of a seed, the first of which with stops at all points can be driven
KINDS = ("MoveL", "MoveL", "MoveL", "MoveC", "MoveJ", "turn")


@dataclass(frozen=True)
class Made:
    """A program with %s where its zones stand, and its cell."""

    text: str
    cell: str


class _Writer:
    """One program in the making: points beside each other, from a posture with room around it."""

    def __init__(self, seed: int):
        self.rng = rng = np.random.default_rng(seed)
        self.robot = str(rng.choice(ROBOTS))
        self.rail = self.robot.endswith("_rail")
        signs = rng.choice([-1, 1], 2)
        self.q = np.array([rng.uniform(-50, 50), rng.uniform(-5, 25), rng.uniform(-10, 20), 0.0, 0.0, 0.0])
        self.q[3:] = signs[0] * rng.uniform(0, 60), signs[1] * rng.uniform(40, 85), rng.uniform(-60, 60)
        self.tools = [self.tool() for _ in range(2 if rng.random() < 0.3 else 1)]
        self.tool_now = 0
        self.d = 300.0  # mm, the rail
        q = np.radians(self.q) if not self.rail else np.r_[self.d / 1e3, np.radians(self.q)]
        X = load_robot(self.robot).forward(q)
        self.p, self.R = 1e3 * X[:3, 3], X[:3, :3]  # of the flange
        self.way = rng.normal(size=3)
        self.bend = rng.choice([0.1, 0.5, 1.5])  # rad by which the way turns from point to point, about
        self.even = float(rng.uniform(2, 25)) if rng.random() < 0.5 else None  # mm, all ways alike but for rounding
        self.per_mm = float(rng.choice([0.001, 0.004, 0.01]))  # rad of reorientation
        self.axis = rng.normal(size=3)
        self.digits = int(rng.choice([2, 3, 6]))

    def tool(self) -> tuple[Array, Array]:
        """A centre point [mm] and its orientation, from the flange."""
        return np.r_[self.rng.uniform(-80, 80, 2), self.rng.uniform(50, 300)], rotation_about(
            [0, 1, 0], float(self.rng.uniform(-1, 1))
        )

    def target(self, p: Array, R: Array) -> str:
        """Of the tool now in use, whose centre point stands at p [mm]."""
        place = ",".join(f"{x:.{self.digits}f}" for x in p)
        turn = ",".join(f"{x:.9f}" for x in wxyz_from_rotation(R))
        return f"[[{place}],[{turn}],[0,0,0,0],[{f'{self.d:.3f}' if self.rail else '9E9'},9E9,9E9,9E9,9E9,9E9]]"

    def standing(self) -> tuple[Array, Array]:
        """Where the centre point of the tool now in use stands [mm], and its orientation."""
        p, R = self.tools[self.tool_now]
        return self.p + self.R @ p, self.R @ R

    def step(self, far: float) -> tuple[Array, Array]:
        """The next point, so many mm on, some way to the side."""
        rng, (p, R) = self.rng, self.standing()
        self.way = self.way / np.linalg.norm(self.way) + self.bend * rng.normal(size=3) / np.sqrt(3)
        self.axis = self.axis / np.linalg.norm(self.axis) + 0.5 * rng.normal(size=3)
        return self.go(p + far * self.way / np.linalg.norm(self.way), rotation_about(self.axis, self.per_mm * far) @ R)

    def go(self, p: Array, R: Array) -> tuple[Array, Array]:
        p_F, R_F = self.tools[self.tool_now]
        self.R = R @ R_F.T
        self.p = p - self.R @ p_F
        return p, R

    def made(self) -> Made:
        """The program."""
        rng = self.rng
        lines = []
        count = int(rng.integers(3, 9))
        v = rng.choice([50, 100, 200, 300, 500, 1000])
        ori = rng.choice(["9999999", "500"])
        for k in range(count):
            if len(self.tools) > 1 and rng.random() < 0.3:
                self.tool_now = 1 - self.tool_now
            kind = str(rng.choice(KINDS))
            far = self.even or float(rng.uniform(2, 25) if rng.random() < 0.85 else rng.uniform(60, 150))
            self.d += float(rng.uniform(-0.5, 0.5)) * far if self.rail else 0.0
            zone = "fine" if k == count - 1 else "%s"
            if kind == "turn":
                p, R = self.standing()
                move = "MoveL " + self.target(*self.go(p, rotation_about(self.axis, float(rng.uniform(0.02, 0.2))) @ R))
            elif kind == "MoveC":
                bend, self.bend = self.bend, 0.3
                move = "MoveC " + ", ".join(self.target(*self.step(far / 2)) for _ in range(2))
                self.bend = bend
            else:
                move = f"{kind} " + self.target(*self.step(far))
            lines.append(f"    {move}, vv, {zone}, t{self.tool_now};")
        eax = f"{300.0 if self.rail else '9E9'},9E9,9E9,9E9,9E9,9E9"
        tools = [
            f"  PERS tooldata t{i}:=[TRUE,[[{','.join(f'{x:.3f}' for x in p)}],"
            f"[{','.join(f'{x:.9f}' for x in wxyz_from_rotation(R))}]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n"
            for i, (p, R) in enumerate(self.tools)
        ]
        start = ",".join(f"{x:.4f}" for x in self.q)
        text = (
            f"MODULE Zones\n{''.join(tools)}  CONST speeddata vv:=[{v},{ori},1000,1000];\n  PROC main()\n"
            f"    ConfJ \\Off;\n    ConfL \\Off;\n    MoveAbsJ [[{start}],[{eax}]], v1000, fine, t0;\n"
            + "\n".join(lines)
            + "\n  ENDPROC\nENDMODULE\n"
        )
        rail = "rail: {eax: a, stroke: [-1, 2]}\n" if self.rail else ""
        at = ", rail: 0.3" if self.rail else ""
        away = ", ".join(f"{x:.4f}" for x in self.q + np.array([5, 0, 0, 0, 0, 5]))
        return Made(text, f'robot: {self.robot}\n{rail}start: {{joints: "[{away}] deg"{at}}}\n')


def job_of(made: Made, zone: str, folder: Path) -> Job:
    """The program with this zone at all points that are passed."""
    module = folder / "zones.mod"
    module.write_text(made.text.replace("%s", zone))
    module.with_suffix(".yaml").write_text(made.cell)
    return read_job([module], None)


def driven(made: Made, zone: str, folder: Path) -> float | str:
    """How long the controller takes with this zone, or why it does not drive it."""
    try:
        found = estimate(job_of(made, zone, folder))
    except InputError as no:
        return f"refused: {no}"
    return found if isinstance(found, str) else found.plan.duration


def planned(made: Made, zone: str, folder: Path) -> str:
    """What is wrong with the first legal plans of both targets; nothing where they are legal."""
    job = job_of(made, zone, folder)
    agreed = may_change(job, Loops.KEEP)
    if agreed.infeasible is not None:
        return f"plan: {agreed.infeasible}"
    for target in Target:
        try:
            plan = optimize(
                job.program, job.plant, target, changes=agreed.changes[target], patience=Patience(0.0), bounded=False
            )
        except NoCleanPlan as no:
            return f"{target.value}: {no}"
        if not isinstance(plan, Plan):
            return f"{target.value}: {plan}"
        report = verify(job.program, job.plant, plan.trajectory, None, None, target, advice=False)
        if not report.legal:
            return f"{target.value}: {report.worst.message}"
    return ""


def tried(seed: int, plan: bool, keep: str | None) -> tuple[int, str, float, str]:
    """A seed, what came of it in a word, its time over that of the smallest zone, and more about it."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for draw in range(DRAWS):  # the first in reach
            writer = _Writer(1000 * draw + seed)
            made, zone = writer.made(), str(writer.rng.choice(LARGE))
            if isinstance(stops := driven(made, "fine", folder), float):
                break
        small, large = (driven(made, one, folder) for one in (SMALLEST, zone))
        wrong = planned(made, zone, folder) if plan and isinstance(large, float) else ""
        if keep is not None:
            to = Path(keep) / f"zones{seed}"
            to.mkdir(parents=True, exist_ok=True)
            (to / "zones.mod").write_text(made.text.replace("%s", zone))
            (to / "zones.yaml").write_text(made.cell)
    if isinstance(stops, str):
        return seed, "out of reach", 0.0, stops.replace(place, "")
    if isinstance(large, str):
        return seed, "NOT DRIVEN", np.inf, f"{zone}: {large}; {SMALLEST}: {small}".replace(place, "")
    least = min(one for one in (small, stops) if isinstance(one, float))
    ratio = large / (small if isinstance(small, float) else stops)
    more = f"{zone}: {large:.4f} s, {SMALLEST}: {small}, fine: {stops:.4f} s; {wrong}".replace(place, "")
    word = (
        "PLAN" if wrong else "SLOWER" if ratio > ENOUGH else "slower than stops" if large > ENOUGH * least else "driven"
    )
    return seed, word, ratio, more


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", default="0:200", help="first and behind the last, or a list with commas")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--plan", action="store_true")
    parser.add_argument("--keep", metavar="FOLDER", help="where the programs are left")
    options = parser.parse_args()
    first, _, last = options.seeds.partition(":")
    seeds = range(int(first), int(last)) if last else [int(one) for one in first.split(",")]
    counts, worst = dict[str, int](), (0.0, -1)
    one = partial(tried, plan=options.plan, keep=options.keep)
    with ProcessPoolExecutor(options.jobs) as pool:
        for seed, word, ratio, more in pool.map(one, seeds):
            counts[word] = counts.get(word, 0) + 1
            if word != "driven":
                print(f"{seed} {word}: {more}", flush=True)
            else:
                worst = max(worst, (ratio, seed))
    print(", ".join(f"{count} {word}" for word, count in sorted(counts.items())))
    print(f"slowest that is driven: seed {worst[1]}, {100 * (worst[0] - 1):+.2f} % of the smallest zone's time")
    return 1 if any(word.isupper() for word in counts) else 0


if __name__ == "__main__":
    sys.exit(main())
