"""What falls back on what: python benchmarks/bench_rungs.py [--seeds 5000:5500] [--jobs N] [--timeout S] [--json FILE]

Every seed is a program with a cell of its own: two in three are of the kinds of bench_robust.py, with fewer stations;
one in three has stations with waits of a fixed time in which a rail is free. Both targets are planned as the command
plans them. Each row has the cycle time of each target, how much later it is than the best motion that was told
on the way or that a rung below has, and what fell back, by kind:

wait, timed: a route was not driven, as a wait or a line has less time than it takes; singular, range: as it passes a
singularity, or leaves what the search looked at; rows: a motion's rows pass a limit, and are mended; judge: it goes
slower where the judge refused it; first: the plan is the first legal motion; below: that of the rung below; slow: the
one that stops everywhere; windows: some did not converge; NO PLAN, ILLEGAL: nothing legal.
"""

from __future__ import annotations

import argparse
import json
import signal
import tempfile
from collections import Counter
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from time import process_time
from typing import Any

import bench_robust
import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.job import read_job
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven
from trajopt_cli.pipeline.planning import Clock, may_change, plan_all
from trajopt_cli.plan import repair
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.objective import LEAST_TIME
from trajopt_cli.problem.plan import Infeasible, NoPlan, Plan, Target
from trajopt_cli.problem.problem import LegKind
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.runs.rows import RowsFile

LATER = 1e-3  # share of a cycle time behind the best legal motion from which a plan counts as late
STATIONS = (1, 1, 2, 2, 3)
WAITS, WAYS, RAILS = (0.2, 0.35, 0.6, 1.0, 1.5), (150.0, 1200.0), (0.3, 1.5)  # s; mm; m/s of a rail


def made(seed: int) -> tuple[str, str, str]:
    """Text, cell and kind of a program."""
    writer = bench_robust._Writer(seed)
    if seed % 3:
        rng = writer.rng
        for _ in range(int(rng.choice(STATIONS))):
            writer.station()
        home = "[[0,0,0,0,30,0],[%s,9E9,9E9,9E9,9E9,9E9]]" % ("0" if writer.rail else "9E9")
        lines = [*writer.lines, f"MoveAbsJ {home}, v1000, fine, tool0;"]
        return _module(lines), writer.cell(), "+".join(writer.odd)
    rng = np.random.default_rng(seed)
    lines, d, corners, jerk = [], 0.0, rng.random() < 0.5, rng.random() < 0.3
    for _ in range(int(rng.integers(2, 5))):
        d = float(np.clip(d + rng.choice([-1, 1]) * rng.uniform(*WAYS), 0.0, 2000.0))
        p = np.array([rng.choice([-1, 1]) * rng.uniform(400, 600), d, rng.uniform(200, 450)])
        turn = bench_robust._axis(np.eye(3)[2], rng.uniform(-0.7, 0.7))
        q = bench_robust._times(np.array([0.0, 0, 1, 0]), turn)
        up = np.array([0.0, 0.0, rng.uniform(40, 120)])
        above, here = (_target(one, q, d) for one in (p + up, p))
        zones = rng.choice(["z5", "z10", "z50"], 2) if corners else ("fine", "fine")
        lines += [
            f"MoveJ {above}, v2500, {zones[0]}, tool0;",
            f"MoveL {here}, {rng.choice(['v300', 'v800'])}, fine, tool0;",
        ]
        lines += [f"WaitTime {rng.choice(WAITS)};"]
        if rng.random() < 0.4:
            lines += [f"MoveL {_target(p + 30 * np.eye(3)[rng.integers(2)], q, d)}, v100, fine, tool0;"]
            lines += [f"WaitTime {rng.choice(WAITS)};"]
        lines += [f"MoveL {above}, v800, {zones[1]}, tool0;"]
    lines += ["MoveAbsJ [[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]], v2500, fine, tool0;"]
    speed, scales, source = rng.uniform(*RAILS), 10 ** rng.uniform(-1, 0, 6), 'source: "benchmark"'
    arm = zip((3.49, 3.49, 4.54, 6.28, 6.28, 7.85), (15.0, 15.0, 20.0, 40.0, 40.0, 50.0), strict=True)
    joints = "".join(
        f"  joint_{i}: {{velocity: {v * scale:.4f}, acceleration: {a * scale:.4f}, {source}}}\n"
        for i, ((v, a), scale) in enumerate(zip(arm, scales, strict=True), 1)
    )
    cell = (
        "robot: irb140_rail\nprofile: default\nrail: {eax: a, stroke: [-0.3, 2.3]}\n"
        + f"jerk_limits: {str(bool(jerk)).lower()}\nwaits: {{rail: free}}\nlimits:\n"
        f"{joints}"
        f"  rail: {{velocity: {speed:.4f}, acceleration: {speed * rng.uniform(1.5, 5):.4f}, {source}}}\n"
        'start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}\n'
    )
    return _module(lines), cell, "rail in waits" + ", corners" * corners + ", jerk" * jerk


def _module(lines: list[str]) -> str:
    return "MODULE Rungs\nPROC main()\n" + "\n".join(lines) + "\nENDPROC\nENDMODULE\n"


def _target(p: Any, q: Any, rail: float) -> str:
    place, turn = (",".join(form % x for x in v) for v, form in ((p, "%.4f"), (q, "%.8f")))
    return f"[[{place}],[{turn}],[0,0,0,0],[{rail:.4f},9E9,9E9,9E9,9E9,9E9]]"


class OutOfTime(Exception):
    """A program took more than its seconds of processor."""


def run(seed: int, timeout: float, keep: Path | None) -> dict[str, Any]:
    """One program: its plans and what fell back."""
    fell: Counter[str] = Counter()
    watch(fell)
    text, cell, kind = made(seed)
    row: dict[str, Any] = {"seed": seed, "kind": kind, "moves": text.count("\nMove")}

    def over(*_: object) -> None:
        raise OutOfTime

    signal.signal(signal.SIGPROF, over)
    signal.setitimer(signal.ITIMER_PROF, timeout)
    best: dict[str, float] = {}

    def listen(label: str, progress: Any) -> None:
        if progress.incumbent is not None:
            best[label] = min(best.get(label, np.inf), progress.incumbent)

    with tempfile.TemporaryDirectory() as place:
        module = (keep or Path(place)) / f"rungs{seed}.mod"
        module.write_text(text)
        module.with_suffix(".yaml").write_text(cell)
        try:
            job = read_job(module)
            asked = {target: LEAST_TIME for target in Target}
            kept = {target: RowsFile() for target in Target}
            answers, written, _ = plan_all(
                job, listen, Clock(), may_change(job, Loops.KEEP).changes, Patience(), 1, asked, kept
            )
        except OutOfTime:
            return row | {"no": f"no answer in {timeout:g} s of processor", "fell": dict(fell)}
        except InputError as error:
            return row | {"no": f"refused: {error}", "fell": {}}
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
    legal = [written.duration] if isinstance(written, Plan) else []
    for target in (Target.RAPID, Target.STREAM):
        answer = answers.get(target)
        if answer is None or isinstance(answer, Infeasible | NoPlan):
            row["no"] = f"{target}: {answer}" if isinstance(answer, Infeasible) else f"{target}: NO PLAN {answer}"
            fell["NO PLAN"] += isinstance(answer, NoPlan)
            continue
        plan, name = answer.plan, target.value
        fell["ILLEGAL"] += not answer.report.legal
        for note in plan.notes:
            first = "is the first legal one" in note
            fell["below"] += note.startswith("the plan is the") and not first
            fell["first"] += first
            fell["judge"] += "slower there" in note and "as it was found the plan" in note
            fell["slow"] += "stops at every point" in note
            fell["windows"] += "failed to converge" in note
        row[f"{name} notes"] = list(plan.notes)
        least = min([*legal, best.get(name, np.inf)])
        row[name], row[f"{name} late"] = plan.duration, plan.duration / least - 1
        legal.append(plan.duration)
    return row | {"written": legal[0] if legal else None, "fell": {k: n for k, n in fell.items() if n},
                  "seconds": process_time()}  # fmt: skip


def watch(fell: Counter[str]) -> None:
    """Count what falls back from now on."""
    timed, rows = repair.timed_clear, repair.rows_of

    def timed_clear(axes: Any, problem: Any, *more: Any) -> Any:
        try:
            return timed(axes, problem, *more)
        except NotDriven as said:
            leg = problem.legs[said.run[0]]
            short = "wait" if leg.kind is LegKind.DWELL else "timed"
            fell[short if said.least is not None else "singular" if said.singular is not None else "range"] += 1
            raise

    def rows_of(*asked: Any) -> Any:
        found = rows(*asked)
        fell["rows"] += len(found[2]) > 0
        return found

    repair.timed_clear, repair.rows_of = timed_clear, rows_of  # type: ignore[assignment]


def main() -> None:
    """Run the seeds, print a line each and what fell back in all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", default="5000:5500", help="first and behind the last, or a list with commas")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--timeout", type=float, default=300.0, help="seconds of processor for one program")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--keep", type=Path, help="folder for the programs")
    options = parser.parse_args()
    first, _, last = options.seeds.partition(":")
    seeds = range(int(first), int(last)) if last else [int(one) for one in first.split(",")]
    if options.keep:
        options.keep.mkdir(parents=True, exist_ok=True)
    rows: list[dict[str, Any]] = []
    print(f" seed moves {'written':>9} {'rapid':>9} {'late %':>7} {'stream':>9} {'late %':>7}  fell back; kind")
    with get_context("spawn").Pool(options.jobs, maxtasksperchild=1) as pool:
        for row in pool.imap(partial(run, timeout=options.timeout, keep=options.keep), seeds):
            rows.append(row)
            print(line(row), flush=True)
            if options.json:
                options.json.write_text(json.dumps(rows, indent=1))
    total: Counter[str] = Counter()
    programs: Counter[str] = Counter()
    for row in rows:
        total.update(row["fell"])
        programs.update(row["fell"].keys())
    print("fell back: " + (", ".join(f"{k} {n} in {programs[k]}" for k, n in total.most_common()) or "nothing"))
    late = [row["seed"] for row in rows if any(row.get(f"{one.value} late", 0) > LATER for one in Target)]
    print(f"later than the best legal motion by more than {100 * LATER:g} %: {late or 'none'} of {len(rows)}")


def line(row: dict[str, Any]) -> str:
    """A row of the table."""

    def number(name: str, form: str, times: float = 1.0) -> str:
        return format(times * row[name], form) if row.get(name) is not None else f"{'-':>{int(form.split('.')[0])}}"

    parts = [number("written", "9.3f")]
    for name in ("rapid", "stream"):
        parts += [number(name, "9.3f"), number(f"{name} late", "7.2f", 100.0)]
    fell = ", ".join(f"{k} {n}" for k, n in row["fell"].items()) or "-"
    return f"{row['seed']:>5} {row['moves']:>5} {' '.join(parts)}  {fell}; {row['kind']}  {row.get('no', '')}"


if __name__ == "__main__":
    main()
