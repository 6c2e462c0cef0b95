"""Programs nobody tuned for: python tests/benchmarks/bench_cells.py [--seeds 1-12] [--json FILE] [--against FILE].

Each seed is one program of one kind on a cell of its own: stations at random places along a rail (or around a robot
without one), served in random order. Every program is optimised as a user would, both targets, and one line is printed
for each, failures included; --json keeps the numbers, --against prints how two checkouts differ.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter

import numpy as np

REPOSITORY = Path(__file__).parents[2]
KINDS = ("literal", "offs", "loop", "call", "bench")  # bench: no rail
PATIENCE = 400.0  # s of wall clock for one program
HOME = "[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]]"

CELL = """robot: irb140_rail
profile: default
rail: {eax: a, stroke: [-0.2, 2.2]}
limits:
  rail: {velocity: 1.0, acceleration: 3.0, source: "benchmark"}
tcp: {speed: 2.5, acceleration: 20, source: "benchmark"}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""
BENCH = 'robot: irb140\nprofile: default\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\n'


def program(seed: int) -> tuple[str, str, str]:
    """Kind, RAPID text and cell file of one seed."""
    rng = np.random.default_rng(seed)
    kind = KINDS[(seed - 1) % len(KINDS)]
    n, rail = int(rng.integers(2, 6)), kind != "bench"
    lift = int(rng.integers(60, 141))
    fast, slow = rng.choice(["v1000", "v2500"]), rng.choice(["v200", "v500", "v800"])
    targets, waits = [], [f"{rng.choice([0.15, 0.3, 0.5, 0.8]):g}" for _ in range(n)]
    for _ in range(n):
        x = rng.uniform(430, 560)
        y = rng.uniform(0, 1900) if rail else rng.uniform(-280, 280)
        z, turn = rng.uniform(200, 400), rng.uniform(-np.pi / 4, np.pi / 4)
        eax = f"{y:.1f}" if rail else "9E9"
        quaternion = f"[0,{np.sin(turn / 2):.7f},{np.cos(turn / 2):.7f},0]"
        targets.append(f"[[{x:.1f},{y:.1f},%s],{quaternion},[0,0,0,0],[{eax},9E9,9E9,9E9,9E9,9E9]]|{z:.1f}")
    at = [t.split("|")[0] % t.split("|")[1] for t in targets]
    above = [t.split("|")[0] % f"{float(t.split('|')[1]) + lift:.1f}" for t in targets]
    head = ["MODULE Cell", f"CONST jointtarget home:={HOME if rail else HOME.replace('[0,9E9', '[9E9,9E9')};"]
    serve = f"MoveJ Offs(p,0,0,{lift}), {fast}, fine, tool0;\nMoveL p, {slow}, fine, tool0;\nWaitTime %s;\n"
    serve += f"MoveL Offs(p,0,0,{lift}), {slow}, fine, tool0;\n"
    body = ""
    for i in range(n):
        head.append(f"CONST robtarget p{i}:={at[i]};")
        if kind in ("literal", "bench"):
            head.append(f"CONST robtarget a{i}:={above[i]};")
            move = f"a{i}, %s, fine, tool0;\n"
            body += f"MoveJ {move % fast}MoveL p{i}, {slow}, fine, tool0;\nWaitTime {waits[i]};\nMoveL {move % slow}"
        elif kind == "offs":
            body += (serve % waits[i]).replace("Offs(p,", f"Offs(p{i},").replace("MoveL p,", f"MoveL p{i},")
        elif kind == "call":
            body += f"serve p{i};\n"
    tail = ""
    if kind == "loop":
        head.append(f"CONST robtarget p{{{n}}}:=[{','.join(at)}];")
        body = f"FOR i FROM 1 TO {n} DO\n{(serve % waits[0]).replace('(p,', '(p{i},').replace(' p,', ' p{i},')}ENDFOR\n"
    elif kind == "call":
        tail = f"PROC serve(robtarget p)\n{serve % waits[0]}ENDPROC\n"
    text = "\n".join(head) + f"\nPROC main()\n{body}MoveAbsJ home, {fast}, fine, tool0;\nENDPROC\n{tail}ENDMODULE\n"
    return kind, text, CELL if rail else BENCH


def run(seed: int, folder: Path) -> dict[str, object]:
    """One program optimised as a user would; what came of it."""
    kind, text, cell = program(seed)
    module = folder / f"cell{seed}.mod"
    module.write_text(text)
    module.with_suffix(".yaml").write_text(cell)
    command = [sys.executable, "-m", "trajopt_cli.cli", "optimize", str(module), "--output", str(folder / f"out{seed}")]
    start = perf_counter()
    out: dict[str, object] = {"seed": seed, "kind": kind, "moves": text.count("Move"), "says": ""}
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, check=False, cwd=REPOSITORY)
        if done.returncode:
            out["says"] = f"exit {done.returncode}: {done.stderr.strip().splitlines()[-1][:120]}"
        else:
            targets = json.loads((folder / f"out{seed}" / "summary.json").read_text())["plans"]
            for name, one in targets.items():
                out[name], out[f"{name} bound"] = one["cycle_time_s"], one["lower_bound_s"]
    except subprocess.TimeoutExpired:
        out["says"] = f"nothing after {PATIENCE:g} s"
    out["seconds"] = round(perf_counter() - start, 1)
    return out


def main() -> None:
    """Run every seed and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", default="1-10")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--against", type=Path)
    options = parser.parse_args()
    first, _, last = options.seeds.partition("-")
    before = {row["seed"]: row for row in json.loads(options.against.read_text())} if options.against else {}
    rows = []
    print(f"{'seed':>4} {'kind':8} {'stream':>8} {'rapid':>8} {'gaps':>12} {'time':>7}  says")
    with tempfile.TemporaryDirectory() as place:
        for seed in range(int(first), int(last or first) + 1):
            row = run(seed, Path(place))
            rows.append(row)
            gaps = [
                f"{100 * (float(str(row[t])) / float(str(row[f'{t} bound'])) - 1):.1f} %" if t in row else "-"
                for t in ("stream", "rapid")
            ]
            times = [f"{row[t]:8.3f}" if t in row else f"{'-':>8}" for t in ("stream", "rapid")]
            change = ""
            if (old := before.get(seed)) is not None:
                for t in ("stream", "rapid"):
                    if t in row and t in old:
                        change += f" {t} {100 * (float(str(row[t])) / float(str(old[t])) - 1):+.2f} %"
                    elif (t in row) != (t in old):
                        change += f" {t} {'new' if t in row else 'LOST'}"
            print(
                f"{seed:4d} {row['kind']:8} {' '.join(times)} {' / '.join(gaps):>12} {row['seconds']:6} s "
                f" {row['says']}{change}",
                flush=True,
            )
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1))


if __name__ == "__main__":
    main()
