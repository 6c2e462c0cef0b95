"""Processes killed at random moments: python benchmarks/bench_kills.py [--kills 1000] [--folder F] [--only WORD].

Every command that writes is run on small inputs and ended by SIGKILL from outside: half of the times at a moment drawn
over the whole run, half at one drawn over the time from the first change of a folder that it writes to until its end.
The process that is killed is the one that writes: a fork of this one, which has all modules imported and nothing read,
so that a run takes as long as its work does. What stands there then is looked at:

  old, new   every result is byte for byte what it was, or whole: a results folder with the hashes of its run.json, a
             file with the bytes of a run that was let alone, files that belong together all of them (after what the
             next run does first, putting back)
  torn       anything else
  strays     names that the next run of the same command leaves and an undisturbed one does not; of commands that take
             long, the next run is let through after every fifth kill, and finds what five of them left
  left       processes that live on

F keeps the inputs and the answers of undisturbed runs, so that a second call begins at once.
"""

from __future__ import annotations

import argparse
import hashlib
import importlib
import json
import os
import pkgutil
import shutil
import signal
import sys
import tempfile
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from time import monotonic, sleep

import numpy as np

import trajopt_cli
from trajopt_cli.runs.transaction import put_back

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))  # measured.simulated_log

Tree = dict[str, bytes]

MODULE = """MODULE Tiny
    CONST jointtarget j_home:=[[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_in:=[[560,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p_in, v1000, fine, tool0;
        MoveAbsJ j_home, v1000, fine, tool0;
    ENDPROC
ENDMODULE
"""
CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 90, 0] deg'}\n"
PARTS = {
    "main": "MODULE Main\n PROC main()\n  one;\n  two;\n ENDPROC\nENDMODULE\n",
    **{
        name: f"MODULE M{name}\n CONST jointtarget j_{name}:=[[{q},0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        f" PROC {name}()\n  MoveAbsJ j_{name}, v1000, fine, tool0;\n ENDPROC\nENDMODULE\n"
        for name, q in (("one", 20), ("two", 0))
    },
}
TURNS = (
    "MODULE Turns\n"
    + "".join(
        f" CONST jointtarget j{i}:=[[{q},0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        f" PROC T{i}()\n  MoveAbsJ j{i}, vmax, fine, tool0;\n  WaitTime 0.1;\n ENDPROC\n"
        for i, q in ((0, 0), (1, -28), (2, 28), (3, -22))
    )
    + " PROC main()\n  T1;\n  T2;\n  T3;\n  MoveAbsJ j0, vmax, fine, tool0;\n ENDPROC\nENDMODULE\n"
)
TURNS_CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\norder: {turns: [T1, T2, T3]}\n"
TASK = """start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
profile: trapezoid
poses:
  - {name: start, at: start}
  - {name: side, by: [0, 0.05, 0, 0, 0, 5 deg]}
v_max: 0.2
omega_max: 1
a_max: 1
epsilon_max: 5
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""


@dataclass(frozen=True)
class Scenario:
    """A command line, what it writes, and how often it is killed. folders: results folders; files: groups of globs, of
    files that change together; logs: files whose rows differ from run to run. first: commands before it, whose results
    are the old state; rerun: after how many kills the command is let through. bak: files that stay as NAME.bak."""

    name: str
    line: str
    share: int
    folders: tuple[str, ...] = ()
    files: tuple[tuple[str, ...], ...] = ()
    logs: tuple[str, ...] = ()
    first: tuple[str, ...] = ()
    rerun: int = 1
    bak: bool = False
    recover: str = ""
    prepare: Callable[[Path], None] | None = None


@dataclass
class Found:
    """What came of the kills of one scenario."""

    counts: Counter[str] = field(default_factory=Counter)
    says: list[str] = field(default_factory=list)


def edited_results(work: Path) -> None:
    """As if the plan had changed a line of each module, so that all of them are written."""
    folder = work / "results/parts"
    record = json.loads((folder / "run.json").read_text())
    for one in record["inputs"]["files"]:
        if one["module"]:
            content = (folder / one["rapid"]).read_bytes() + b"! as planned\n"
            (folder / one["rapid"]).write_bytes(content)
            record["files"][one["rapid"]] = hashlib.sha256(content).hexdigest()
    (folder / "run.json").write_text(json.dumps(record))


def older(*names: str) -> Callable[[Path], None]:
    """Files that are there before, with another content."""

    def make(work: Path) -> None:
        for name in names:
            (work / name).parent.mkdir(parents=True, exist_ok=True)
            (work / name).write_bytes(b"old\n" * 1000)

    return make


TINY = "optimize tiny.mod --jobs 1 --time-limit 0 --quiet"
ALL = "main.mod one.mod two.mod --cell parts.yaml"
PARTS_RUN = f"optimize {ALL} --output results/parts --jobs 1 --time-limit 0 --quiet"
SEGMENTS = "iiwa segments task.yaml --quiet"
PLACE = "place tiny.mod --what base --range x=0..60mm --points 4 --jobs 1 --time-limit 2 --quiet"
PARTS_FILES = ("main.mod", "one.mod", "two.mod")


def exports() -> list[Scenario]:
    ends = {"joint": "csv", "ros2": "yaml", "mcap": "mcap", "parquet": "parquet", "egm": "egm", "gltf": "glb"}
    out = [
        Scenario(
            f"export {kind}", f"export {kind} results/tiny --output out.{end} --quiet", 55,
            files=((f"out.{end}",),), first=(TINY,), prepare=older(f"out.{end}"),
        )
        for kind, end in ends.items()
    ]  # fmt: skip
    return out


SCENARIOS = [
    Scenario("optimize", TINY, 50, ("results/tiny",), first=(TINY,), rerun=5),
    Scenario("optimize, nothing there", TINY, 30, ("results/tiny",), rerun=5),
    Scenario(
        "compare runs --report", "compare runs results/tiny results/tiny --report runs.html --quiet", 60,
        files=(("runs.html",),), first=(TINY,), prepare=older("runs.html"),
    ),
    Scenario("order", "order turns.mod --jobs 1 --quiet", 20, ("results/turns_order",),
             first=("order turns.mod --jobs 1 --quiet",), rerun=5),
    Scenario("order --apply", "order turns.mod --apply --jobs 1 --quiet", 20, ("results/turns_order",),
             (("turns.mod",),), first=("order turns.mod --jobs 1 --quiet",), bak=True),
    *exports(),
    Scenario("export fri", "export fri results/task --output out.csv --quiet", 60, files=(("out.csv",),),
             first=(SEGMENTS, "iiwa joints results/task --quiet"), prepare=older("out.csv")),
    Scenario("export rapid --output FILE", "export rapid results/tiny --output out.mod --quiet", 50,
             files=(("out.mod",),), first=(TINY,), prepare=older("out.mod")),
    Scenario("export rapid --output FOLDER", "export rapid results/parts --output out --quiet", 60,
             files=(tuple(f"out/{one}" for one in PARTS_FILES),), first=(PARTS_RUN,),
             prepare=older(*(f"out/{one}" for one in PARTS_FILES))),
    Scenario("export rapid --in-place", "export rapid results/parts --in-place --quiet", 110, files=(PARTS_FILES,),
             first=(PARTS_RUN,), prepare=edited_results, bak=True, recover=f"parse {ALL} --quiet"),
    Scenario("iiwa segments", SEGMENTS, 40, ("results/task",), first=(SEGMENTS,)),
    Scenario("new", "new fresh --quiet", 60, files=(("fresh.mod", "fresh.yaml"),)),
    Scenario("robot add --rail --force", "robot add arm.urdf --name arm2 --rail --force --quiet", 40,
             files=(("arm2.urdf", "arm2.yaml", "arm2_rail.urdf", "arm2_rail.yaml"),), bak=True,
             prepare=older("arm2.urdf", "arm2.yaml", "arm2_rail.urdf", "arm2_rail.yaml")),
    Scenario("identify --output", "identify log.csv --robot irb140_rail --output limits.yaml --quiet", 15,
             files=(("limits.yaml",),), prepare=older("limits.yaml"), rerun=5),
    Scenario("play egm --log", "play egm results/tiny --echo --to 127.0.0.1:0 --log back.csv --quiet", 5,
             logs=("back.csv",), first=(TINY,), rerun=5),
    Scenario("iiwa joints --plots", "iiwa joints results/task --plots drawn --quiet", 10, ("results/task",),
             (("drawn/*",),), first=(SEGMENTS,), rerun=5),
    Scenario("iiwa simulate --plots", "iiwa simulate results/task --engine spring --plots drawn --quiet", 8,
             ("results/task",), (("drawn/*",),), first=(SEGMENTS,), rerun=5),
    Scenario("iiwa dose --plots", "iiwa dose results/task --max-lag 5mm --plots drawn --quiet", 6,
             ("results/task-dosed",), (("drawn/*",),), first=(SEGMENTS, "iiwa dose results/task --max-lag 6mm --quiet"),
             rerun=5),
    Scenario(
        "sensitivity", "sensitivity results/tiny --target stream --output results/levers --jobs 1 --quiet", 8,
        ("results/levers",), first=(TINY, "sensitivity results/tiny --target stream --output results/levers --quiet"),
        rerun=5,
    ),
    Scenario("place", PLACE, 10, ("results/tiny_place",), first=(PLACE,), rerun=5),
    Scenario(
        "compare baseline", "compare baseline tiny.mod --csv rows.csv --quiet", 8,
        ("results/tiny_comparison",), (("rows.csv",),),
        first=("compare baseline tiny.mod --quiet",), rerun=5, prepare=older("rows.csv"),
    ),
    Scenario("iiwa experiments", "iiwa experiments --engine spring --quiet", 2, ("results/iiwa_experiments",),
             rerun=10),
]  # fmt: skip


# ----------------------------------------------------------------------------------------------------------- processes


def import_all() -> None:
    """Every module of the package and what it needs, so that no run spends its time on that."""
    for one in pkgutil.walk_packages(trajopt_cli.__path__, "trajopt_cli."):
        if not one.name.endswith("__main__"):
            importlib.import_module(one.name)
    for name in ("matplotlib.pyplot", "mcap.writer", "pyarrow.parquet"):
        importlib.import_module(name)


def start(line: str, work: Path, said: Path) -> int:
    """The command in a process of its own: a fork of this one, in a group of its own."""
    pid = os.fork()
    if pid:
        return pid
    code = 99
    try:
        os.setpgid(0, 0)
        os.chdir(work)
        with open(said, "wb") as out:
            os.dup2(out.fileno(), 1)
            os.dup2(out.fileno(), 2)
        from trajopt_cli.cli import run

        code = run(line.split())
        sys.stdout.flush()
    finally:
        os._exit(code)


def let_run(line: str, work: Path, said: Path) -> int:
    """The same to its end; its exit code."""
    return os.waitstatus_to_exitcode(os.waitpid(start(line, work, said), 0)[1])


def alive(group: int) -> bool:
    """Whether a process of the group still runs 5 s after it should have ended; it is ended then."""
    until = monotonic() + 5
    while monotonic() < until:
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return False
        sleep(0.002)
    os.killpg(group, signal.SIGKILL)
    return True


def changes(folders: list[Path]) -> tuple[int, ...]:
    return tuple(one.stat().st_mtime_ns if one.exists() else 0 for one in folders)


# -------------------------------------------------------------------------------------------------------------- states


def tree(folder: Path) -> Tree:
    return {one.relative_to(folder).as_posix(): one.read_bytes() for one in folder.rglob("*") if one.is_file()}


def within(found: Tree, folder: str) -> Tree:
    return {name: content for name, content in found.items() if name.startswith(folder + "/")}


def group_of(found: Tree, globs: tuple[str, ...]) -> Tree:
    out = {}
    for name, content in found.items():
        for glob in globs:
            if name == glob or (glob.endswith("/*") and name.startswith(glob[:-1]) and "/." not in name):
                out[name] = content
    return out


def whole(folder: Tree, name: str) -> bool:
    """Whether a results folder holds what its run.json lists, and nothing else."""
    if f"{name}/run.json" not in folder:
        return False
    listed = json.loads(folder[f"{name}/run.json"])["files"]
    held = {one.removeprefix(f"{name}/"): hashlib.sha256(content).hexdigest() for one, content in folder.items()}
    held.pop("run.json")
    return bool(listed == held)


def whole_rows(text: bytes) -> bool:
    """Whether every row has as many fields as the first, and the last one its end."""
    return text.endswith(b"\n") and len({row.count(b",") for row in text.splitlines()}) == 1


def states(one: Scenario, found: Tree, before: Tree, after: Tree) -> list[str]:
    """Old, new or torn: of every result of the command."""
    out = []
    for folder in one.folders:
        now = within(found, folder)
        out.append("old" if now == within(before, folder) else "new" if whole(now, folder) else f"torn {folder}")
    for globs in one.files:
        now, old, new = (group_of(which, globs) for which in (found, before, after))
        out.append("new" if now == new else "old" if now == old else f"torn {', '.join(globs)}")
    for name in one.logs:
        now_, old_ = found.get(name), before.get(name)
        out.append("old" if now_ == old_ else "new" if now_ and whole_rows(now_) else f"torn {name}")
    return out


class Bench:
    """Inputs, answers of undisturbed runs, and kills."""

    def __init__(self, folder: Path, seed: int):
        self.folder, self.rng = folder, np.random.default_rng(seed)
        self.said = folder / "said"

    def made(self, one: Scenario) -> tuple[Path, Tree, Tree, float, float]:
        """The state before, as a folder and as a tree, the one after an undisturbed run, how long that takes, and how
        long from its first change on."""
        place = self.folder / "".join(sign if sign.isalnum() else "_" for sign in one.name)
        before, after, times = place / "before", place / "after", place / "times"
        if not times.exists():
            shutil.rmtree(place, ignore_errors=True)
            before.mkdir(parents=True)
            self.inputs(before)
            for line in one.first:
                assert let_run(line, before, self.said) in (0, 1), self.said.read_text()
            (before / "results").mkdir(exist_ok=True)
            if one.prepare:
                one.prepare(before)
            for _ in range(2):  # the second one finds the caches full
                shutil.rmtree(after, ignore_errors=True)
                shutil.copytree(before, after)
                watched = self.watched(one, after)
                at, began, first = changes(watched), monotonic(), None
                pid = start(one.line, after, self.said)
                while not (ended := os.waitpid(pid, os.WNOHANG))[0]:
                    if first is None and changes(watched) != at:
                        first = monotonic()
                    sleep(0.0005)
                end, code = monotonic(), os.waitstatus_to_exitcode(ended[1])
                assert code in (0, 1), (one.name, code, self.said.read_text())
            times.write_text(json.dumps([end - began, end - (first or end)]))
        took, writing = json.loads(times.read_text())
        return before, tree(before), tree(after), took, writing

    def inputs(self, work: Path) -> None:
        texts = {"tiny.mod": MODULE, "tiny.yaml": CELL, "turns.mod": TURNS, "turns.yaml": TURNS_CELL, "task.yaml": TASK}
        texts |= {f"{name}.mod": text for name, text in PARTS.items()} | {"parts.yaml": CELL}
        for name, text in texts.items():
            (work / name).write_text(text)
        root = Path(__file__).parents[1]
        (work / "arm.urdf").write_bytes((root / "robots/irb140.urdf").read_bytes())
        from measured.simulated_log import NAMES, Recorder, drive, identification_moves, random_robot, record

        rng = np.random.default_rng(77)
        robot = random_robot(rng, jerk=False)
        first, moves = identification_moves(rng, [])
        t, q, _ = drive(robot, first, moves)
        t, q = record(robot, t, q, Recorder(0.024, 0.0, True, 1e-4, 1e-4, 2e-5, 2e-5, 0.0), rng)
        heads = ["t [s]", "rail [m]", *(f"{name} [rad]" for name in NAMES[1:])]
        rows = [",".join(heads), *(",".join(f"{x:.6f}" for x in row) for row in np.column_stack([t, q]))]
        (work / "log.csv").write_text("\n".join(rows) + "\n")

    @staticmethod
    def watched(one: Scenario, work: Path) -> list[Path]:
        names = (*one.folders, *one.logs, *(name for group in one.files for name in group))
        return sorted({(work / name).parent for name in names})

    def kill(self, one: Scenario, kills: int, found: Found) -> None:
        """Kill it so many times."""
        before, old, new, took, writing = self.made(one)
        work = self.folder / "work"
        names = {*old, *new}
        unclean = n = 0
        while found.counts["kills"] < kills and n < 4 * kills:
            if not unclean:
                shutil.rmtree(work, ignore_errors=True)
                shutil.copytree(before, work)
            watched = self.watched(one, work)
            at, start_state = changes(watched), tree(work)
            while_writing = n % 2 == 1
            wait = self.rng.uniform(0, writing if while_writing else took)
            n += 1
            pid = start(one.line, work, self.said)
            forked = began = monotonic()
            ended, waiting = (0, 0), while_writing
            while not ended[0] and (waiting or monotonic() - began < wait):
                if waiting and changes(watched) != at:
                    waiting, began = False, monotonic()
                sleep(0.0003)
                ended = os.waitpid(pid, os.WNOHANG)
            if not ended[0]:
                os.kill(pid, signal.SIGKILL)
                ended = os.waitpid(pid, 0)
            killed = os.waitstatus_to_exitcode(ended[1]) == -signal.SIGKILL
            if not killed:  # it was faster than the one that was let alone: the machine is busy at times
                took = min(took, monotonic() - forked)
                writing = min(writing, monotonic() - began)
            found.counts["kills" if killed else "too late"] += 1
            if alive(pid):
                found.counts["left"] += 1
            if one.recover:
                let_run(one.recover, work, self.said)
                if "killed half-way" in self.said.read_text():
                    found.counts["put back"] += 1
            else:
                lines = put_back(work / name for group in one.files for name in {*group, *group_of(new, group)})
                found.counts["put back"] += bool(lines)
            now = tree(work)
            for state in states(one, now, start_state, new):
                found.counts[state.split()[0]] += 1
                if state.startswith("torn"):
                    found.says.append(f"{one.name}: kill {n}: {state}")
            unclean += 1
            if unclean < one.rerun and found.counts["kills"] < kills:
                continue
            was_new = "old" not in states(one, now, old, new)
            let_run(one.line, work, self.said)
            unclean, now = 0, tree(work)
            strays = {name for name in now if name not in names}
            if one.bak and was_new:
                strays = {name for name in strays if not name.rpartition(".")[2].startswith("bak")}
            empty = [folder for folder in work.rglob("*") if folder.is_dir() and folder.name.startswith(".")]
            strays |= {folder.relative_to(work).as_posix() for folder in empty}
            found.counts["strays"] += len(strays)
            found.says += [f"{one.name}: kill {n}: stray {name}" for name in sorted(strays)[:5]]


COLUMNS = ("kills", "too late", "old", "new", "torn", "put back", "strays", "left")


def main() -> None:
    """Kill, and print a line by command and the sums."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kills", type=int, default=1000)
    parser.add_argument("--folder", type=Path)
    parser.add_argument("--only", default="", help="scenarios with this word in their name")
    parser.add_argument("--but", default="\0", help="not those with this word in it")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    import_all()
    with tempfile.TemporaryDirectory() as place:
        folder = (options.folder or Path(place)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        os.environ["XDG_CACHE_HOME"] = str(folder / "cache")
        bench, total = Bench(folder, options.seed), Counter[str]()
        chosen = [one for one in SCENARIOS if options.only in one.name and options.but not in one.name]
        shares, says = sum(one.share for one in chosen), []
        print(f"{'':32}" + "".join(f"{name:>10}" for name in COLUMNS), flush=True)
        left = options.kills
        for i, one in enumerate(chosen):
            kills = left if i + 1 == len(chosen) else round(options.kills * one.share / shares)
            left -= kills
            found = Found()
            bench.kill(one, kills, found)
            total += found.counts
            says += found.says
            print(f"{one.name:32}" + "".join(f"{found.counts[name]:>10}" for name in COLUMNS), flush=True)
            for line in found.says[:10]:
                print(f"    {line}", flush=True)
        print(f"{'all':32}" + "".join(f"{total[name]:>10}" for name in COLUMNS))
        parts = [one.name for one in (folder / "cache").rglob("*.part")]
        print(f"cache: {len(parts)} strays")
    sys.exit(1 if says else 0)


if __name__ == "__main__":
    main()
