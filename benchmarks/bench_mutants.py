"""Whether a room's own tests notice when its code is wrong: small faults put in at random, one at a time.

python benchmarks/bench_mutants.py --out FOLDER [--count 300] [--seed 17] [--jobs 1] [--rooms judge,path,...]

Needs the coverage package. First every room's tests run once under it, to know which tests run which line, and how long
they take. Then each mutant runs in a process of its own, with the tests that run its line, the room's quickest files
first, until one fails. What no test runs survives. Kept in FOLDER by mutant: a second call goes on where the first one
stopped. At the end a table by room, and every survivor with its place.

What is put in: a comparison turned round; its boundary moved where one side is a whole number or a length; + for -,
* for / and the other way; and for or; a condition taken as true or as false; not left out; a number changed; a
statement left out; a value that is returned replaced by None. Texts, annotations, what a class declares, assertions and
zip's strict, which shows in a program alone that is wrong already, are left alone; so are compiled loops, whose machine
code comes from the files beside them.
"""

from __future__ import annotations

import argparse
import ast
import importlib
import importlib.abc
import importlib.machinery
import importlib.util
import json
import os
import random
import resource
import signal
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

ROOT = Path(__file__).parents[1]
ROOMS = {"judge": "judge", "path": "path", "robot": "robot", "rapid/data": "rapid"}  # package folder: tests' folder
HEAVY = "numpy scipy.optimize scipy.spatial.transform casadi pinocchio coal toppra ruckig pydantic hypothesis pytest"
SWAPS = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.MatMult: ast.Add}
SWAPS |= {ast.FloorDiv: ast.Mult, ast.Mod: ast.Mult, ast.Pow: ast.Mult, ast.And: ast.Or, ast.Or: ast.And}
SWAPS |= {ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd}
TURNED = {ast.Lt: ast.GtE, ast.LtE: ast.Gt, ast.Gt: ast.LtE, ast.GtE: ast.Lt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq}
TURNED |= {ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In}
MOVED = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt}
LONGEST = 600.0  # of one mutant's tests [s]
MEMORY = 6 << 30


@dataclass(frozen=True)
class Mutant:
    """A fault: where, and what it makes of the module's tree."""

    room: str
    file: str
    line: int
    what: str
    tree: ast.Module


def faults_of(room: str, path: Path) -> Iterator[tuple[str, Path, int, int]]:
    """Every fault of a file: its room, the file, the node's number and which of its changes."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    above = parents(tree)
    for number, node in enumerate(ast.walk(tree)):
        for k, _ in enumerate(changes_of(node, above)):
            yield room, path, number, k


def put_in(room: str, path: Path, number: int, k: int) -> Mutant:
    """One of them."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    node = list(ast.walk(tree))[number]
    line, before = getattr(node, "lineno", 0), ast.unparse(node)
    list(changes_of(node, parents(tree)))[k]()
    what = f"{' '.join(before.split())[:90]}  ->  {' '.join(ast.unparse(node).split())[:90]}"
    return Mutant(room, str(path.relative_to(ROOT)), line, what, ast.fix_missing_locations(tree))


def parents(tree: ast.Module) -> dict[ast.AST, ast.AST]:
    """Of each node the one that holds it."""
    return {child: node for node in ast.walk(tree) for child in ast.iter_child_nodes(node)}


def changes_of(node: ast.AST, above: dict[ast.AST, ast.AST]) -> Iterator[Callable[[], None]]:
    """What can be done to a node, in place; nothing outside functions, and nothing to texts."""
    chain = [node]
    while chain[-1] in above:
        chain.append(above[chain[-1]])
    inside = [isinstance(a, ast.FunctionDef | ast.Lambda) for a in chain[1:]]
    if not any(inside) or any(isinstance(a, ast.JoinedStr | ast.Raise | ast.arguments) for a in chain):
        return
    function = chain[1 + inside.index(True)]
    if isinstance(function, ast.FunctionDef) and any(
        a in function.decorator_list or a is function.returns for a in chain
    ):
        return
    if any(isinstance(up, ast.AnnAssign) and low is up.annotation for low, up in pairwise(chain)):
        return
    if any(isinstance(a, ast.Assert) or (isinstance(a, ast.keyword) and a.arg == "strict") for a in chain):
        return
    match node:
        case ast.Compare(ops=ops):
            for i, op in enumerate(ops):
                yield lambda i=i, op=op: ops.__setitem__(i, TURNED[type(op)]())
                sides = [node.left, *node.comparators][i : i + 2]
                if type(op) in MOVED and any(map(whole, sides)):
                    yield lambda i=i, op=op: ops.__setitem__(i, MOVED[type(op)]())
        case ast.BinOp(op=op) if type(op) in SWAPS and not any(map(text, (node.left, node.right))):
            yield lambda: setattr(node, "op", SWAPS[type(op)]())
        case ast.BoolOp(op=op):
            yield lambda: setattr(node, "op", SWAPS[type(op)]())
        case ast.UnaryOp(op=ast.Not() | ast.USub() as op):
            if isinstance(op, ast.Not) or not isinstance(node.operand, ast.Constant):
                yield lambda: become(node, node.operand)
        case ast.If() | ast.IfExp():
            for value in (True, False):
                yield lambda value=value: setattr(node, "test", ast.Constant(value))
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            yield lambda: setattr(node, "value", value + 1 if isinstance(value, int) else value * 2 + 1e-3)
        case ast.Constant(value=bool() as value):
            yield lambda: setattr(node, "value", not value)
        case ast.Return(value=value) if value is not None and not isinstance(value, ast.Constant):
            yield lambda: setattr(node, "value", ast.Constant(None))
        case ast.Expr(value=ast.Call()) | ast.AugAssign():
            yield lambda: replace_statement(above[node], node)


def whole(node: ast.AST) -> bool:
    """Whether an expression is plainly a whole number."""
    return (isinstance(node, ast.Constant) and isinstance(node.value, int)) or (
        isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "len"
    )


def text(node: ast.AST) -> bool:
    """Whether an expression is plainly a text."""
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


def become(node: ast.AST, other: ast.AST) -> None:
    """Make one expression another one, in place."""
    node.__class__ = other.__class__
    node.__dict__.clear()
    node.__dict__.update(other.__dict__)


def replace_statement(above: ast.AST, node: ast.AST) -> None:
    """A statement made a pass."""
    for name in ("body", "orelse", "finalbody"):
        held = getattr(above, name, None)
        if isinstance(held, list) and node in held:
            held[held.index(node)] = ast.copy_location(ast.Pass(), node)
    become(node, ast.copy_location(ast.Pass(), node))


class Wrong(importlib.abc.MetaPathFinder):
    """Gives one module from another tree than its file's."""

    def __init__(self, file: str, tree: ast.Module):
        self.path = ROOT / file
        name = ".".join(Path(file).with_suffix("").parts)
        self.name, self.tree = name.removesuffix(".__init__"), tree

    def find_spec(self, fullname: str, path: object, target: object = None) -> importlib.machinery.ModuleSpec | None:
        """The module's, or None for others."""
        if fullname != self.name:
            return None
        code = compile(self.tree, str(self.path), "exec")

        class Loader(importlib.machinery.SourceFileLoader):
            def get_code(self, fullname: str) -> object:
                return code

        return importlib.util.spec_from_file_location(fullname, self.path, loader=Loader(fullname, str(self.path)))


class Watch:
    """What each test runs of the rooms, and how long it takes."""

    def __init__(self, cover: object):
        self.cover, self.seconds, self.begun = cover, {}, 0.0

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        self.begun = time.process_time()
        self.cover.switch_context(nodeid)

    def pytest_runtest_logfinish(self, nodeid: str) -> None:
        self.seconds[nodeid] = time.process_time() - self.begun


class Chosen:
    """Keeps of a collection the tests that are named."""

    def __init__(self, names: set[str]):
        self.names = names

    def pytest_collection_modifyitems(self, items: list[object]) -> None:
        items[:] = [item for item in items if item.nodeid in self.names]


PLAIN = ["-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-o", "addopts=", "--rootdir", str(ROOT), "--tb=no"]


def in_child(work: Callable[[], int], limit: float) -> tuple[int | None, float]:
    """The exit code of work in a forked process, and its time; None where it took too long."""
    pid = os.fork()
    if pid == 0:
        os.setsid()
        null = os.open(os.devnull, os.O_RDWR)
        for number in (0, 1, 2):
            os.dup2(null, number)
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        code = 3
        try:
            code = work()
        finally:
            os._exit(code)
    begun = time.monotonic()
    while time.monotonic() - begun < limit:
        done, status = os.waitpid(pid, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status), time.monotonic() - begun
        time.sleep(0.02)
    os.killpg(pid, signal.SIGKILL)
    os.waitpid(pid, 0)
    return None, limit


def look(room: str, tests: str, out: Path) -> dict[str, object]:
    """By line the tests that run it, and by test its time, from one run of a room's tests."""
    kept = out / f"lines_{room.replace('/', '_')}.json"
    if not kept.exists():

        def work() -> int:
            import coverage
            import pytest

            cover = coverage.Coverage(data_file=None, include=[f"{ROOT}/trajopt_cli/{room}/*"], config_file=False)
            watch = Watch(cover)
            cover.start()
            code = int(pytest.main([*PLAIN[1:], str(ROOT / "tests" / tests)], plugins=[watch]))
            cover.stop()
            lines: dict[str, dict[int, list[str]]] = {}
            data = cover.get_data()
            for file in data.measured_files():
                lines[str(Path(file).relative_to(ROOT))] = data.contexts_by_lineno(file)
            kept.write_text(json.dumps({"lines": lines, "seconds": watch.seconds}), encoding="utf-8")
            return code

        code, seconds = in_child(work, 3600.0)
        print(f"{room}: its tests took {seconds:.0f} s, exit code {code}", flush=True)
        if code != 0:
            kept.unlink(missing_ok=True)
            sys.exit("the tests have to pass without a fault")
    return json.loads(kept.read_text(encoding="utf-8"))


def tried(mutant: Mutant, seen: dict[str, object], folder: str) -> tuple[str, float, int]:
    """What became of a mutant, how long it took and how many tests run its line."""
    names = set(seen["lines"].get(mutant.file, {}).get(str(mutant.line), []))
    if "" in names:  # run where the module is loaded: any test may notice
        names = set(seen["seconds"])
    names.discard("")
    if not names:
        return "not run", 0.0, 0
    cost: dict[str, float] = defaultdict(float)
    for name in names:
        cost[name.split("::")[0]] += seen["seconds"].get(name, 0.0)
    files = sorted(cost, key=cost.__getitem__)

    def work() -> int:
        import pytest

        sys.meta_path.insert(0, Wrong(mutant.file, mutant.tree))
        return int(pytest.main([*PLAIN, *(str(ROOT / file) for file in files)], plugins=[Chosen(names)]))

    code, seconds = in_child(work, min(LONGEST, 30.0 + 10.0 * sum(cost.values())))
    state = {None: "killed, no end", 0: "survived", 1: "killed"}.get(code, f"killed, code {code}")
    return state, seconds, len(names)


def main() -> None:
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("--out", type=Path, required=True)
    asked.add_argument("--count", type=int, default=300)
    asked.add_argument("--seed", type=int, default=17)
    asked.add_argument("--jobs", type=int, default=1)
    asked.add_argument("--rooms", default=",".join(ROOMS))
    options = asked.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    os.chdir(ROOT)
    sys.path[:0] = [str(ROOT), str(ROOT / "tests")]
    for name in HEAVY.split():
        importlib.import_module(name)
    rooms = options.rooms.split(",")
    files = {room: sorted((ROOT / "trajopt_cli" / room).rglob("*.py")) for room in rooms}
    all_of = [(room, path) for room in rooms for path in files[room] if not path.stem.endswith("_loops")]
    found = [fault for room, path in all_of for fault in faults_of(room, path)]
    chosen = random.Random(options.seed).sample(range(len(found)), min(options.count, len(found)))
    print(f"{len(found)} faults are possible, {len(chosen)} are tried", flush=True)
    seen = {room: look(room, ROOMS[room], options.out) for room in rooms}
    kept = options.out / "mutants.jsonl"
    rows = [json.loads(line) for line in kept.read_text(encoding="utf-8").splitlines()] if kept.exists() else []
    known = {(row["file"], row["line"], row["what"]) for row in rows}

    def one(number: int) -> None:
        mutant = put_in(*found[number])
        if (mutant.file, mutant.line, mutant.what) in known:
            return
        state, seconds, tests = tried(mutant, seen[mutant.room], ROOMS[mutant.room])
        row = {"room": mutant.room, "file": mutant.file, "line": mutant.line, "what": mutant.what, "state": state}
        rows.append(row | {"seconds": round(seconds, 1), "tests": tests})
        with kept.open("a", encoding="utf-8") as sink:
            sink.write(json.dumps(rows[-1]) + "\n")
        print(f"{state:15} {seconds:6.1f} s  {mutant.file}:{mutant.line}  {mutant.what}", flush=True)

    if options.jobs == 1:
        for number in chosen:
            one(number)
    else:
        with ThreadPoolExecutor(options.jobs) as pool:
            list(pool.map(one, chosen))
    print(f"\n{'room':12} mutants  killed  survived  not run  killed [%]")
    for room in [*rooms, "all"]:
        mine = [row["state"] for row in rows if room in (row["room"], "all")]
        killed = sum(state.startswith("killed") for state in mine)
        share = 100.0 * killed / max(1, len(mine))
        print(f"{room:12} {len(mine):7} {killed:7} {mine.count('survived'):9} {mine.count('not run'):8} {share:11.1f}")
    print("\nsurvivors:")
    for row in sorted(rows, key=lambda row: (row["file"], row["line"])):
        if not row["state"].startswith("killed"):
            print(f"  {row['file']}:{row['line']}  {row['what']}  ({row['state']}, {row['tests']} tests)")


if __name__ == "__main__":
    main()
