"""A tool that is free about its axis against one as taught: ten programs of drilling and dispensing, by seed.

    python benchmarks/bench_turn.py [--seeds 0 1 2] [--write FOLDER]

Even seeds drill, odd ones dispense; of five in a row the last two have a rail. Heads are bent by 0, 45 or 90 degrees,
work pieces are a table or a dome. As taught the tool has one angle about its axis in the whole program (as from CAM),
or another one at every hole (as by hand): the first of the seed's own that can be done. --write leaves programs and
cells.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

import numpy as np

from trajopt_cli.geometry import Array, rotation_about, wxyz_from_rotation
from trajopt_cli.job import Job, read_job
from trajopt_cli.motion import ConfData, PoseMove
from trajopt_cli.pipeline.planning import changes_of, judge
from trajopt_cli.plan import NoCleanPlan, optimize
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, Freedom
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.robot.inverse import confdata
from trajopt_cli.runs.rows import RowsFile

SEEDS = range(10)
HOLES, POINTS = 10, 16
TAUGHT = replace(EVERYTHING, turn=False)
TRIES = 40


def program_of(seed: int, attempt: int, confs: Mapping[str, ConfData] | None = None) -> tuple[str, str]:
    """The program's text and its cell file's; attempt: which of the seed's taught angles. confs: of its targets by
    name; None: confdata is off."""
    rng = np.random.default_rng(seed)
    drills, rail, dome = seed % 2 == 0, seed % 5 > 2, bool(rng.integers(2))
    bend = float(rng.choice([0.0, 45.0, 90.0])) if seed else 90.0
    by_hand = drills and bool(rng.integers(2))
    centre = np.array([0.5, rng.uniform(-0.1, 0.1) + (0.6 if rail else 0.0), 0.25])
    size = np.array([0.12, 0.5 if rail else 0.2])
    spots = np.column_stack([rng.uniform(-1, 1, (HOLES, 2)) * size, np.zeros(HOLES)]) if drills else _bead(rng, size)
    taught = np.random.default_rng([seed, attempt])
    spin = taught.uniform(-np.pi, np.pi) + (taught.uniform(-0.7, 0.7, len(spots)) if by_hand else np.zeros(len(spots)))
    places = [(centre, spot, size, angle, dome) for spot, angle in zip(spots, spin, strict=True)]
    head = wxyz_from_rotation(rotation_about([0, 1, 0], np.radians(bend)))
    x, z = 0.11 * np.sin(np.radians(bend)), 0.06 + 0.08 * np.cos(np.radians(bend))
    home, *external = (f"[{d if rail else '9E9'},9E9,9E9,9E9,9E9,9E9]" for d in [0, *_beside(centre, spots)])
    lines = [
        "MODULE Turn",
        f"PERS tooldata tHead:=[TRUE,[[{x * 1e3:.3f},0,{z * 1e3:.3f}],[{_text(head)}]],[1,[0,0,50],[1,0,0,0],0,0,0]];",
        f"CONST jointtarget j_home:=[[0,0,0,0,30,0],{home}];",
        *(
            f"CONST robtarget {name}{i}:=[{_target(*place, lift)},{_conf(confs, f'{name}{i}')},{external[i]}];"
            for i, place in enumerate(places)
            for name, lift in (("p", 0.0), ("above", 0.04))
        ),
        "PROC main()",
        *([r"ConfJ\Off;", r"ConfL\Off;"] if confs is None else []),
        *(_drilling(len(places)) if drills else _dispensing(len(places))),
        r"MoveAbsJ j_home\NoEOffs,v1000,fine,tHead;",
        "ENDPROC",
        "ENDMODULE",
    ]
    cell = [
        f"robot: irb140{'_rail' if rail else ''}",
        *(["rail: {eax: a, stroke: [-0.3, 1.5]}"] if rail else []),
        f"start: {{joints: '[0, 0, 0, 0, 30, 0] deg'{', rail: 0' if rail else ''}}}",
        "tool_radius: 0",
        "settle: 0",
        "free: {axis: z}",
    ]
    return "\n".join(lines) + "\n", "\n".join(cell) + "\n"


def _beside(centre: Array, spots: Array) -> list[str]:
    """Where a rail along y stands beside each spot [mm]."""
    return [f"{y * 1e3:.0f}" for y in centre[1] + spots[:, 1]]


def _bead(rng: np.random.Generator, size: Array) -> Array:
    """A closed bead (POINTS + 1, 3) around the middle [m]."""
    phi = np.linspace(0, 2 * np.pi, POINTS + 1)
    shares = rng.uniform(0.55, 1.0, POINTS)
    radius = np.r_[shares, shares[:1]]
    return np.column_stack([radius * np.cos(phi) * size[0], radius * np.sin(phi) * size[1], 0 * phi])


def _target(centre: Array, spot: Array, size: Array, angle: float, dome: bool, lift: float) -> str:
    """trans and rot of a spot on a table or a dome, the tool against its normal, turned by an angle, and lifted [m]."""
    tilt = spot[:2] / size * np.radians(25.0) if dome else np.zeros(2)
    R = rotation_about([0, 1, 0], tilt[0]) @ rotation_about([1, 0, 0], -tilt[1]) @ rotation_about([0, 1, 0], np.pi)
    p = centre + spot + [0, 0, -0.12 * float((tilt**2).sum())] - lift * R[:, 2]
    return (
        f"[{','.join(f'{v * 1e3:.3f}' for v in p)}],[{_text(wxyz_from_rotation(R @ rotation_about([0, 0, 1], angle)))}]"
    )


def _conf(confs: Mapping[str, ConfData] | None, name: str) -> str:
    return "[0,0,0,0]" if confs is None or name not in confs else f"[{','.join(map(str, confs[name].numbers))}]"


def _text(wxyz: Array) -> str:
    return ",".join(f"{value:.9f}" for value in wxyz)


def _drilling(count: int) -> Iterator[str]:
    for i in range(count):
        yield f"MoveJ above{i},v1000,fine,tHead;"
        yield f"MoveL p{i},v50,fine,tHead;"
        yield "WaitTime 0.1;"
        yield f"MoveL above{i},v200,fine,tHead;"


def _dispensing(count: int) -> Iterator[str]:
    yield "MoveJ above0,v1000,fine,tHead;"
    yield "MoveL p0,v100,fine,tHead;"
    for i in range(1, count):
        yield f"MoveL p{i},v300,{'z5' if i < count - 1 else 'fine'},tHead;"
    yield f"MoveL above{count - 1},v200,fine,tHead;"


def job_of(seed: int, folder: Path) -> Job | None:
    """The seed's program with the first of its taught angles that can be done as written; None for none."""
    for attempt in range(TRIES):
        try:
            job = _read(folder, seed, program_of(seed, attempt))
            plan = _planned(job, Target.RAPID, AS_WRITTEN)
            ends = [(job.program.motions[one.index], one.q_1[-6:]) for one in plan.motions]
            confs = {one.target: confdata(job.plant.robot, arm) for one, arm in ends if isinstance(one, PoseMove)}
            job = _read(folder, seed, program_of(seed, attempt, confs))
            for freedom in (AS_WRITTEN, TAUGHT):
                _planned(job, Target.RAPID, freedom)
        except NoCleanPlan:
            continue
        return job
    return None


def _read(folder: Path, seed: int, texts: tuple[str, str]) -> Job:
    program, cell = folder / f"turn_{seed}.mod", folder / f"turn_{seed}.yaml"
    for path, text in zip((program, cell), texts, strict=True):
        path.write_text(text, encoding="utf-8")
    return read_job(program, cell)


def _planned(job: Job, target: Target, freedom: Freedom) -> Plan:
    plan = optimize(job.program, job.plant, target, freedom, bounded=False, changes=changes_of(job, target))
    if not isinstance(plan, Plan):
        raise NoCleanPlan(str(plan))
    return plan


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, nargs="*", default=[*SEEDS])
    parser.add_argument("--write", type=Path)
    given = parser.parse_args()
    print("seed work      rail written |  rapid taught   free   saved |  stream taught   free   saved | cpu  legal")
    with TemporaryDirectory() as folder:
        for seed in given.seeds:
            job = job_of(seed, given.write or Path(folder))
            if job is None:
                print(f"{seed:4d} no taught angle of {TRIES} can be done")
                continue
            work = "dispensing" if seed % 2 else "drilling"
            row = f"{seed:4d} {work:10s}{'yes' if job.plant.robot.has_rail else 'no':4s}"
            row += f"{_planned(job, Target.RAPID, AS_WRITTEN).duration:8.3f} |"
            legal, spent = True, [0.0, 0.0]
            for target in (Target.RAPID, Target.STREAM):
                times = []
                for i, freedom in enumerate((TAUGHT, EVERYTHING)):
                    start = process_time()
                    plan = _planned(job, target, freedom)
                    spent[i] += process_time() - start
                    rows = RowsFile()
                    rows.keep(plan)
                    legal &= judge(job.plant, job.program, rows.text, target.value, None, target, advice=False).legal
                    times.append(plan.duration)
                row += f"{times[0]:14.3f} {times[1]:7.3f} {1 - times[1] / times[0]:7.1%} |"
            print(f"{row} {spent[1] / spent[0]:4.1f}x {legal}")
            sys.stdout.flush()


if __name__ == "__main__":
    main()
