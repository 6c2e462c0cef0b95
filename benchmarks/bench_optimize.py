"""What `trajopt optimize` takes, command to files: python benchmarks/bench_optimize.py [CASE ...] [--json FILE].

Cases: shipped programs by name; stations:N (N stations on the hinge cell's rail, a wait at each); pallet:N (N moves
over the places of a pallet, no two alike); repeats:N (N passes of one pick and place); contour:N (N points of z1 along
a path longer than the reach, the rail free); far:N (pallet:N on a rail of 40 m). Both targets, in a fresh process. A
line for each: wall and processor seconds, peak memory with children, seconds to the first legal plan, cycle times with
their bounds, and ms per move; below it the seconds of every phase, stream and rapid.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
from collections import defaultdict
from itertools import count
from pathlib import Path
from time import perf_counter

import numpy as np

REPOSITORY = Path(__file__).parents[1]
PROGRAMS = REPOSITORY / "programs"
SMALL = ("hinge_cell", "stations:10", "pallet:25", "pallet:50", "repeats:20", "contour:100", "far:25")
GOALS = {
    "hinge_cell": "first legal plan within 1.5 s, 4 s in all (7 s with an empty cache)",
    "stations": "10 stations within 10 s",
    "pallet": "60 ms per move, 2 GB at 10,000",
    "repeats": "little more than one pass",
    "contour": "5 ms per point",
    "far": "as on the short rail",
}
SEED = 7
FAR = 40.0  # m
HOME = "CONST jointtarget home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];"
DOWN = "[0,0,1,0],[0,0,0,0]"


def target(x: float, y: float, z: float, rail: float, turn: float = 0.0) -> str:
    """A robtarget [mm], the tool down and turned about the vertical [rad]."""
    quaternion = f"[0,{np.sin(turn / 2):.7f},{np.cos(turn / 2):.7f},0]"
    return f"[[{x:.2f},{y:.2f},{z:.2f}],{quaternion},[0,0,0,0],[{rail:.1f},9E9,9E9,9E9,9E9,9E9]]"


def module(targets: list[str], body: list[str]) -> str:
    """A module of robtargets p1, p2, ... and the body of main, home at its end."""
    data = [f"CONST robtarget p{i}:={text};" for i, text in enumerate(targets, start=1)]
    moves = [*body, "MoveAbsJ home, v2500, fine, tool0;"]
    return "\n".join(["MODULE Bench", HOME, *data, "PROC main()", *moves, "ENDPROC", "ENDMODULE", ""])


def stations(n: int) -> str:
    """n stations, served one after the other: approach, down, wait, up."""
    rng, targets, body = np.random.default_rng(SEED), list[str](), list[str]()
    for i in range(n):
        x, y, z = rng.uniform(430, 560), rng.uniform(0, 1900), rng.uniform(200, 400)
        turn, lift = rng.uniform(-np.pi / 4, np.pi / 4), rng.uniform(60, 140)
        targets += [target(x, y, z + lift, y, turn), target(x, y, z, y, turn)]
        above, at = (f"p{2 * i + k}" for k in (1, 2))
        body += [f"MoveJ {above}, v2500, fine, tool0;", f"MoveL {at}, v500, fine, tool0;"]
        body += [f"WaitTime {rng.choice([0.15, 0.3, 0.5, 0.8])};", f"MoveL {above}, v500, fine, tool0;"]
    return module(targets, body)


def pallet(n: int, stroke: float = 2.0) -> str:
    """n moves: boxes from a belt to the places of pallets along the rail, layer by layer; no two places alike."""
    rng, targets, body = np.random.default_rng(SEED), list[str](), list[str]()
    for i in range(max(1, round((n - 1) / 3))):
        if i % 2 == 0:
            x, y, z = 450.0, 0.0, 250.0
        else:
            row, column = divmod(i // 2 % 40, 10)
            x, y, z = 400.0 + 40 * row, 200.0 + (1000 * stroke - 400) * column / 9, 180.0 + 10 * (i // 80 % 12)
        x, y, z = np.array([x, y, z]) + rng.uniform(-15, 15, 3)
        turn = rng.uniform(-0.3, 0.3)
        targets += [target(x, y, z + 100, y, turn), target(x, y, z, y, turn)]
        above, at = (f"p{2 * i + k}" for k in (1, 2))
        body += [f"MoveJ {above}, v2500, fine, tool0;"]
        body += [f"MoveL {at}, v500, fine, tool0;", f"MoveL {above}, v500, fine, tool0;"]
    return module(targets, body)


def repeats(n: int) -> str:
    """n passes of one pick and place."""
    targets = [target(450, y, z, y) for y in (200, 1350) for z in (450, 330)]
    serve = [
        line
        for above, at in (("p1", "p2"), ("p3", "p4"))
        for line in (
            f"MoveJ {above}, v2500, fine, tool0;",
            f"MoveL {at}, v500, fine, tool0;",
            "WaitTime 0.3;",
            f"MoveL {above}, v500, fine, tool0;",
        )
    ]
    return module(targets, [f"FOR i FROM 1 TO {n} DO", *serve, "ENDFOR"])


def contour(n: int) -> str:
    """n points, 3 mm apart and rounded, of a wavy path to and fro along the rail."""
    body = ["MoveJ Offs(p1,0,0,50), v1000, fine, tool0;", "MoveL p1, v200, fine, tool0;", f"FOR i FROM 1 TO {n} DO"]
    body += ["y:=900-900*Cos(0.18*i);", "x:=40*Sin(2.5*i);"]
    body += ["MoveL Offs(p1,x,y,0), v200, z1, tool0;", "ENDFOR", "MoveL Offs(p1,x,y,50), v200, fine, tool0;"]
    text = module([target(480, 100, 300, 100)], body)
    return text.replace("PROC main()", "VAR num x;\nVAR num y;\nPROC main()")


def cell(stroke: float) -> str:
    """The hinge cell's robot on a rail of some length [m]."""
    text = (PROGRAMS / "hinge_cell.yaml").read_text()
    return text.replace("stroke: [-0.2, 2.2]", f"stroke: [-0.2, {stroke - 0.2:g}]")


def job(case: str, folder: Path) -> Path:
    """The program of a case, with its cell beside it."""
    kind, _, size = case.partition(":")
    if not size:
        return PROGRAMS / f"{kind}.mod"
    n, path = int(size), folder / f"{kind}{size}.mod"
    text = pallet(n, FAR) if kind == "far" else {f.__name__: f for f in (stations, pallet, repeats, contour)}[kind](n)
    path.write_text(text)
    path.with_suffix(".yaml").write_text(cell(FAR if kind == "far" else 2.4))
    return path


def memory(pid: int) -> int:
    """What a process and its children hold [bytes], pages that they share counted once."""
    total, left = 0, [pid]
    while left:
        place = Path("/proc") / str(left.pop())
        try:
            rows = dict(line.split(":", 1) for line in (place / "smaps_rollup").read_text().splitlines()[1:])
            total += 1024 * int(rows["Pss"].split()[0])
            left += [int(one) for task in (place / "task").iterdir() for one in (task / "children").read_text().split()]
        except (OSError, ProcessLookupError):
            continue
    return total


def run(case: str, folder: Path, patience: float) -> dict[str, object]:
    """One command as a user gives it; what it took and what came of it."""
    program, out, said = job(case, folder), folder / "results", folder / "said.txt"
    command = [sys.executable, "-u", "-m", "trajopt_cli.cli", "optimize", str(program), "--output", str(out)]
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start, peak, first, looks = perf_counter(), 0, None, count()
    with said.open("w") as stream:
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=stream, cwd=REPOSITORY, env=environment)
        while process.poll() is None:
            try:
                process.wait(0.1)
            except subprocess.TimeoutExpired:
                if next(looks) % 5 == 0:  # counting pages takes time of its own
                    peak = max(peak, memory(process.pid))
                if first is None and "best" in said.read_text():
                    first = perf_counter() - start
                if perf_counter() - start > patience:
                    process.terminate()
    wall, after = perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    row: dict[str, object] = {"case": case, "wall": wall, "cpu": cpu, "peak": peak / 1e6, "first": first}
    if process.returncode:
        return row | {"says": f"exit {process.returncode}: {said.read_text().strip().splitlines()[-1:]}"}
    summary = json.loads((out / "summary.json").read_text())
    for name, one in summary["plans"].items():
        row |= {name: one["cycle_time_s"], f"{name} bound": one["lower_bound_s"]}
    row |= {"moves": sum(len(one["motions"]) for one in summary["plans"].values()) // len(summary["plans"])}
    return row | {"seconds": json.loads((out / "run.json").read_text())["seconds"]}


def show(row: dict[str, object]) -> None:
    """One case in two or three lines."""
    first = "-" if row["first"] is None else f"{row['first']:.1f}"
    line = f"{row['case']:14} {row['wall']:8.1f} {row['cpu']:8.1f} {row['peak']:7.0f} {first:>6}"
    if "says" in row:
        print(f"{line}  {row['says']}")
        return
    for name in ("stream", "rapid"):
        line += "".join(
            f" {x:9.3f}" if isinstance(x, float) else f" {'-':>9}" for x in (row[name], row[f"{name} bound"])
        )
    print(f"{line} {1e3 * float(str(row['wall'])) / max(1, int(str(row['moves']))):9.1f}")
    split: dict[str, dict[str, float]] = defaultdict(dict)
    seconds = row["seconds"]
    assert isinstance(seconds, dict)
    for name, spent in seconds.items():
        label, _, phase = name.rpartition(": ")
        split[phase][label] = spent
    phases = (
        f"{phase} {' '.join(f'{x:.2f}' for x in by_label.values())}"
        for phase, by_label in split.items()
        if max(by_label.values()) >= 0.01
    )
    print("  " + ", ".join(phases))
    bound = sum(spent for name, spent in seconds.items() if name.endswith(": bound"))
    plans = sum(spent for name, spent in seconds.items() if name.endswith((": plan", ": bound", ": judge")))
    print(
        f"  bound {bound / plans:.0%} of planning and judging; asked: {GOALS.get(str(row['case']).split(':')[0], '-')}"
    )


def main() -> None:
    """Run the cases and print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", default=SMALL)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--patience", type=float, default=1200.0, help="seconds for one case")
    options = parser.parse_args()
    print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    heads = ["case", "wall [s]", "cpu [s]", "MB", "first", "stream", "bound", "rapid", "bound", "ms/move"]
    print("{:14} {:>8} {:>8} {:>7} {:>6} {:>9} {:>9} {:>9} {:>9} {:>9}".format(*heads))
    rows = []
    for case in options.cases:
        with tempfile.TemporaryDirectory() as place:
            rows.append(run(case, Path(place), options.patience))
        show(rows[-1])
        if options.json:
            options.json.write_text(json.dumps(rows, indent=1))


if __name__ == "__main__":
    main()
