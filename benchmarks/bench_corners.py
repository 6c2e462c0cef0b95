"""Programs full of corners: python benchmarks/bench_corners.py [--seeds 4000:4050] [--jobs N] [--json FILE]
                                 [--against REVISION|FILE] [--no-fine] [--keep FOLDER] [--timeout S]

Every seed is a program of one kind, all three in turn: `pick` serves stations with a wait at each, z10 above them;
`approach` goes from one to the next by joint moves and lines of z50, some of them over a joint move between; `contour`
is lines of z10 and z50, with arcs in some, turning tools in some, and both. Three of four stand on the hinge cell's
rail, the others on a bench without one. The command plans each with both targets and the bound, and judges what it has
written; then it plans the same program with every zone `fine`. --against: beside every stream the one of an earlier
revision, which is run here as well, or of an earlier --json. Seconds are those of the processor, for both targets and
the bound.
"""

from __future__ import annotations

import argparse
import io
import json
import os
import re
import subprocess
import tarfile
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import numpy as np
from bench_robust import REPOSITORY, command

from trajopt_cli.geometry import Array

KINDS = ("pick", "approach", "contour")
BENCH = 4  # one program of so many stands on the bench
RAIL_CELL = (REPOSITORY / "programs" / "hinge_cell.yaml").read_text()
BENCH_CELL = (REPOSITORY / "programs" / "corners.yaml").read_text()
AGAINST = {"rapid": ("now", "rapid"), "fine": ("fine", "stream"), "before": ("before", "stream")}
Row = dict[str, object]
LATER = 5e-4  # relative, from which one answer is later than another


class Writer:
    """One program in the making."""

    def __init__(self, seed: int):
        self.rng = np.random.default_rng(seed)
        self.kind, self.rail = KINDS[seed % len(KINDS)], seed // len(KINDS) % BENCH != BENCH - 1
        self.eax = "0" if self.rail else "9E9"
        self.lines = list[str]()

    def place(self, low: float, high: float) -> Array:
        """A point [mm] that can be served, at a height within the bounds."""
        rng = self.rng
        y = rng.uniform(100, 1900) if self.rail else rng.uniform(-260, 260)
        return np.array([rng.uniform(430, 550), y, rng.uniform(low, high)])

    def target(self, p: Array, turn: float = 0.0, tilt: float = 0.0) -> str:
        """A robtarget: the tool down, turned about the vertical and tilted [rad]."""
        a, b = np.array([0.0, np.sin(turn / 2), np.cos(turn / 2), 0.0]), np.array([np.cos(tilt / 2), np.sin(tilt / 2)])
        q = np.r_[a[0] * b[0] - a[1] * b[1], a[1] * b[0] + a[0] * b[1], a[2] * b[0], -a[2] * b[1]]
        eax = f"{p[1]:.1f}" if self.rail else "9E9"
        place, turned = ",".join(f"{x:.1f}" for x in p), ",".join(f"{x:.8f}" for x in q)
        return f"[[{place}],[{turned}],[0,0,0,0],[{eax},9E9,9E9,9E9,9E9,9E9]]"

    def move(self, name: str, target: str, speed: str, zone: str) -> None:
        self.lines.append(f"{name} {target}, {speed}, {zone}, tool0;")

    def pick(self) -> None:
        rng, slow = self.rng, str(self.rng.choice(["v300", "v500", "v800"]))
        for _ in range(int(rng.integers(2, 6))):
            p, turn, lift = self.place(200, 390), rng.uniform(-0.7, 0.7), np.array([0, 0, rng.uniform(60, 140)])
            above = self.target(p + lift, turn)
            self.move("MoveJ", above, "v2500", "z10")
            self.move("MoveL", self.target(p, turn), slow, "fine")
            self.lines.append(f"WaitTime {rng.choice([0.15, 0.2, 0.5]):g};")
            self.move("MoveL", above, slow, "z10")

    def approach(self) -> None:
        rng = self.rng
        for _ in range(int(rng.integers(2, 5))):
            p, turn, lift = self.place(200, 320), rng.uniform(-0.7, 0.7), np.array([0, 0, rng.uniform(110, 160)])
            above = self.target(p + lift, turn)
            if rng.random() < 0.3:
                self.move("MoveJ", self.target(self.place(380, 480), turn / 2), "v2500", "z50")
            self.move("MoveJ", above, "v2500", "z50")
            self.move("MoveL", self.target(p, turn), "v1000", "fine")
            self.move("MoveL", above, "v1000", "z50")

    def contour(self) -> None:
        rng = self.rng
        arcs, turning = rng.random() < 0.4, rng.random() < 0.5
        speed = str(rng.choice(["v300", "v500", "v1000"]))
        p, way = self.place(260, 420), float(rng.choice([-1, 1]))
        low, high = (100, 1900) if self.rail else (-260, 260)
        n, turn, tilt = int(rng.integers(5, 10)), 0.0, 0.0
        self.move("MoveJ", self.target(p), "v2500", "fine")
        for i in range(n):
            if not low + 100 < p[1] + 250 * way < high - 100:
                way = -way
            along = rng.uniform(60, 350) if self.rail else rng.uniform(40, 160)
            to = np.array([rng.uniform(430, 560), np.clip(p[1] + along * way, low, high), rng.uniform(260, 420)])
            if turning:
                turn, tilt = rng.uniform(-0.6, 0.6), rng.uniform(-0.3, 0.3)
            zone = "fine" if i == n - 1 else str(rng.choice(["z10", "z50"]))
            here = self.target(to, turn, tilt)
            if arcs and rng.random() < 0.5:
                e = to - p
                bulge = np.cross(e, rng.normal(size=3))
                via = (p + to) / 2 + rng.uniform(0.1, 0.3) * np.linalg.norm(e) * bulge / np.linalg.norm(bulge)
                self.move("MoveC", f"{self.target(via, turn, tilt)}, {here}", speed, zone)
            else:
                self.move("MoveL", here, speed, zone)
            p = to

    def text(self) -> str:
        """The module."""
        {"pick": self.pick, "approach": self.approach, "contour": self.contour}[self.kind]()
        home = f"CONST jointtarget home:=[[0,0,0,0,30,0],[{self.eax},9E9,9E9,9E9,9E9,9E9]];"
        body = "\n".join([*self.lines, "MoveAbsJ home, v2500, fine, tool0;"])
        return f"MODULE Corners\n{home}\nPROC main()\n{body}\nENDPROC\nENDMODULE\n"

    @property
    def cell(self) -> str:
        """Its cell file."""
        return RAIL_CELL if self.rail else BENCH_CELL


def planned(module: Path, code: Path, patience: float) -> Row:
    """What the command of some checkout makes of a module: cycle times by target, bound, seconds, the judge's word."""
    out = module.with_suffix("")
    status, said, seconds = command(["optimize", str(module), "--output", str(out), "--jobs", "1"], patience, code)
    row: Row = {"seconds": round(seconds, 2), "says": ""}
    if status:
        return row | {"says": said.replace(f"{module.parent}/", "")}
    if status is None:
        return row | {"says": f"nothing after {patience:g} s of processor"}
    summary = json.loads((out / "summary.json").read_text())
    for name, one in summary["plans"].items():
        row |= {name: one["cycle_time_s"], f"{name} bound": one["lower_bound_s"]}
    judged, word, _ = command(["verify", str(out)], patience)
    return row if judged == 0 else row | {"says": f"ILLEGAL: {word}"}


def run(seed: int, folder: Path, code: dict[str, Path], patience: float, fine: bool) -> Row:
    """One program with its own zones by every checkout, and with `fine` by this one."""
    writer = Writer(seed)
    text = writer.text()
    row: Row = {"seed": seed, "kind": writer.kind, "rail": writer.rail, "moves": text.count("\nMove")}
    for name, place in code.items():
        module = written(folder / f"{name}{seed}.mod", text, writer.cell)
        row[name] = planned(module, place, patience)
    if fine:
        module = written(folder / f"fine{seed}.mod", re.sub(r"\bz\d+\b", "fine", text), writer.cell)
        row["fine"] = planned(module, code["now"], patience)
    return row


def written(module: Path, text: str, cell: str) -> Path:
    """A module with its cell beside it."""
    module.write_text(text)
    module.with_suffix(".yaml").write_text(cell)
    return module


def checkout(revision: str, folder: Path) -> Path:
    """The files of a revision, in a new folder."""
    packed = subprocess.run(["git", "archive", revision], cwd=REPOSITORY, capture_output=True, check=True).stdout
    with tarfile.open(fileobj=io.BytesIO(packed)) as files:
        files.extractall(folder / "before", filter="data")
    return folder / "before"


# ------------------------------------------------------------------------------------------------------------- table


def answer(row: Row, run: str, name: str) -> float | None:
    """A time of the run `now`, `before` or `fine` of a row; None where it has none, or the judge says no."""
    one = row.get(run, {})
    assert isinstance(one, dict)
    return None if one.get("says") else one.get(name)


def change(row: Row, run: str, name: str = "stream") -> float | None:
    """The stream's cycle time now against another, relative."""
    now, other = answer(row, "now", "stream"), answer(row, run, name)
    return None if now is None or other is None else now / other - 1


def line(row: Row) -> str:
    """A row of the table."""
    now = row["now"]
    assert isinstance(now, dict)
    times = [now.get("stream"), now.get("rapid"), answer(row, "fine", "stream"), now.get("stream bound")]
    times.append(answer(row, "before", "stream"))
    text = f"{row['seed']:>5} {row['kind']:8} {'rail' if row['rail'] else '-':4} {row['moves']:>3}"
    text += "".join(f" {'-':>8}" if t is None else f" {t:8.3f}" for t in times)
    for asked in AGAINST.values():
        share = change(row, *asked)
        text += f" {'-':>8}" if share is None else f" {100 * share:+6.2f} %"
    says = [f"{name}: {one['says']}" for name in ("now", "fine", "before")
            if isinstance(one := row.get(name), dict) and one["says"]]  # fmt: skip
    return f"{text} {now['seconds']:8.1f}  {'; '.join(says) or 'legal'}"


def summary(rows: list[Row]) -> Iterator[str]:
    """By kind of program: the stream against RAPID, `fine` and before; on how many programs it is later."""
    for kind in (*KINDS, "all"):
        some = [row for row in rows if kind in (row["kind"], "all")]
        legal = [row for row in some if answer(row, "now", "stream") is not None]
        text = f"{kind:8} {len(legal):>3} of {len(some)} legal"
        for word, asked in (
            ("rapid", ("now", "rapid")),
            ("fine", ("fine", "stream")),
            ("before", ("before", "stream")),
        ):
            shares = [share for row in some if (share := change(row, *asked)) is not None]
            if shares:
                later = sum(share > LATER for share in shares)
                middle, worst = 100 * float(np.median(shares)), 100 * max(shares)
                text += f"; against {word} {middle:+.2f} % in the middle, {worst:+.2f} % at most, later on {later}"
        seconds = [float(row["now"]["seconds"]) / int(str(row["moves"])) for row in some]  # type: ignore[index]
        yield text + (f"; {np.median(seconds):.2f} s a move" if seconds else "")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", default="4000:4050", help="first and behind the last, or a list with commas")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--timeout", type=float, default=400.0, help="s of processor for one command")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--against")
    parser.add_argument("--no-fine", action="store_true", help="as in the file to compare with, if that has it")
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()
    first, _, last = options.seeds.partition(":")
    seeds = range(int(first), int(last)) if last else [int(one) for one in first.split(",")]
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    rows: list[Row] = []
    head = "".join(
        f" {name:>8}" for name in ("stream", "rapid", "fine", "bound", "before", "/rapid", "/fine", "/before")
    )
    print(f" seed kind     cell  mv{head} {'s':>8}", flush=True)
    with tempfile.TemporaryDirectory() as place:
        folder, code, known = options.keep or Path(place), {"now": REPOSITORY}, dict[object, Row]()
        folder.mkdir(parents=True, exist_ok=True)
        if options.against and Path(options.against).is_file():
            known = {row["seed"]: row for row in json.loads(Path(options.against).read_text())}
        elif options.against:
            code["before"] = checkout(options.against, Path(place))
        work = partial(run, folder=folder, code=code, patience=options.timeout, fine=not options.no_fine)
        with ThreadPoolExecutor(options.jobs) as pool:
            for row in pool.map(work, seeds):
                if (old := known.get(row["seed"])) is not None:
                    row = {**{name: old[name] for name in ("fine",) if name in old}, **row, "before": old["now"]}
                rows.append(row)
                print(line(row), flush=True)
                if options.json:
                    options.json.write_text(json.dumps(rows, indent=1))
    print("\n".join(summary(rows)))


if __name__ == "__main__":
    main()
