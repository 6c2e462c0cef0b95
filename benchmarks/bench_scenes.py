"""Programs among boxes: python benchmarks/bench_scenes.py [--first 4000] [--count 50] [--folder F] [--seconds S]

Every seed is a small program on an IRB 140 (every second one on a rail), with one to six boxes where it works. The
command optimises it with its boxes and without them. What is written is looked at here: cubic Hermite between the rows,
pin for the links, coal for the distances, looked at so densely that no point of the robot moves more than 0.1 mm (or
than it is away) from one look to the next. A search at random (RRT-connect, Kuffner and LaValle 2000) between the same
points, on branches and rail positions drawn at random, says whether there is a way at all: "none found" is no proof.

Each seed has a file in the folder; one that is there is not done again, so that runs may be cut off, and several may
work side by side. Times are of the processor, but for the time limit that the command is given. Seeds from 9000 on are
for tuning.
"""

from __future__ import annotations

import argparse
import csv
import fcntl
import json
import resource
import signal
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from time import process_time

import coal  # type: ignore[import-untyped]
import numpy as np
import pinocchio as pin

from trajopt_cli.geometry import Array, pose
from trajopt_cli.job import Job, read_job
from trajopt_cli.motion import MoveAbsJ, MoveJ, MoveL, Program
from trajopt_cli.problem.collision_objects import bodies_on
from trajopt_cli.problem.plant import Plant
from trajopt_cli.shapes import Box, Mesh, MeshFile, Polytope, Shape

REPOSITORY = Path(__file__).parents[1]
TOOL = 0.1  # m
CLEARANCE = 0.005  # m that the cell files ask for
SEEN = 1e-4  # m
REACH = 1.1  # m: no point of the arm or its tool is farther from any joint's axis
STEP = 0.02  # rad or m between two looks at a straight way in the joints
LINE = 0.01  # m between two looks at a line
BASE = 0.24  # m beside the rail that its base takes: a box there cuts the rail in two


# ---------------------------------------------------------------------------------------------------------- the world


class World:
    """The robot among its bodies during one motion: distances by coal on pin's poses, the judge's code apart."""

    def __init__(self, plant: Plant, program: Program, index: int):
        robot, bodies = plant.robot, bodies_on(plant, program, index)
        self.model = robot.pin_model
        self.data, self._X_WR = self.model.createData(), np.asarray(robot.X_WR)
        frames = [self.model.getFrameId(name, pin.FrameType.BODY) for name in (*robot.link_names, "tool0")]
        self._frames = dict(zip((*robot.link_names, "tool0"), frames, strict=True))
        self.least, self.limits = plant.clearance, plant.limits
        placed = {name: (name, shape) for name, (shape,) in robot.bodies.items()}
        placed |= {solid.name: ("tool0", _loaded(solid.shape)) for solid in bodies.carried}
        self._of = {name: (self._frames[link], *_coal(shape)) for name, (link, shape) in placed.items()}
        first = robot.link_names[0]
        self._pairs: list[tuple[str, str]] = [pair for pair in plant.self_pairs if set(pair) <= set(placed)]
        self._walls = []
        for solid in bodies.standing:
            geometry, X = _coal(_loaded(solid.shape))
            meets = [n for n in placed if n not in solid.ignore and (n != first or robot.has_rail)]
            self._walls.append((coal.Transform3s(X[:3, :3], X[:3, 3]), geometry, meets))
        self._request = coal.DistanceRequest(False, 0.0, 0.0)
        self._request.enable_signed_distance = True

    def least_distance(self, q: Array) -> tuple[float, float]:
        """Least distance from the boxes, and of the robot from itself."""
        placed = self._placed(q)
        apart, itself = np.inf, np.inf
        for first, second in self._pairs:
            itself = min(itself, self._distance(*placed[first], *placed[second]))
        for at, geometry, meets in self._walls:
            for name in meets:
                apart = min(apart, self._distance(*placed[name], geometry, at))
        return apart, itself

    def _placed(self, q: Array) -> dict[str, tuple[object, object]]:
        pin.forwardKinematics(self.model, self.data, q)
        placed = {}
        for name, (frame, geometry, X) in self._of.items():
            at = self._X_WR @ pin.updateFramePlacement(self.model, self.data, frame).homogeneous @ X
            placed[name] = (geometry, coal.Transform3s(at[:3, :3], at[:3, 3]))
        return placed

    def free(self, q: Array) -> bool:
        """Whether the axes may stand there, a hundredth of a millimetre more than the clearance away."""
        if (q < self.limits.lower).any() or (q > self.limits.upper).any():
            return False
        placed = self._placed(q)
        if any(self._distance(*placed[a], *placed[b]) <= 0 for a, b in self._pairs):
            return False
        return all(self._distance(*placed[name], geometry, at) > self.least + 1e-5
                   for at, geometry, meets in self._walls for name in meets)  # fmt: skip

    def free_way(self, a: Array, b: Array) -> bool:
        """Whether the straight way in the joints is free, looked at every STEP: from the middle out."""
        n = max(int(np.ceil(np.abs(b - a).max() / STEP)), 1)
        order = sorted(range(1, n), key=lambda i: (i & -i, i), reverse=True)
        return all(self.free(a + i / n * (b - a)) for i in order)

    def _distance(self, one: object, at_one: object, two: object, at_two: object) -> float:
        result = coal.DistanceResult()
        return float(coal.distance(one, at_one, two, at_two, self._request, result))


def _loaded(shape: Shape | MeshFile) -> Shape:
    assert not isinstance(shape, MeshFile)
    return shape


def _coal(shape: Shape) -> tuple[object, Array]:
    """coal's geometry and its pose."""
    if isinstance(shape, Box):
        return coal.Box(*map(float, shape.size)), np.asarray(shape.X)
    if isinstance(shape, Polytope):
        points, faces = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
        points.extend([np.array(corner) for corner in shape.vertices])
        faces.extend([coal.Triangle(*corners) for corners in shape.triangles.tolist()])
        return coal.Convex(points, faces), np.asarray(shape.X)
    if isinstance(shape, Mesh):
        raise ValueError(f"{shape.name}: this check knows boxes, capsules and polytopes")
    along = shape.b - shape.a
    length = float(np.linalg.norm(along))
    X = np.eye(4)
    X[:3, 3] = (shape.a + shape.b) / 2
    if length > 1e-9:
        x = np.cross(along, np.eye(3)[int(np.argmin(np.abs(along)))])
        x /= np.linalg.norm(x)
        X[:3, :3] = np.column_stack([x, np.cross(along / length, x), along / length])
    return coal.Capsule(shape.radius, length), X


def check_rows(world: Callable[[float], World], rows: Array) -> tuple[float, float]:
    """Least distances, from obstacles and from itself, of a file's rows (n, 1 + 2k): time, axes, their speeds.

    world: what stands around at a time. Steps are so short that no point moves more than SEEN, or than the least
    distance of the look before.
    """
    k = (rows.shape[1] - 1) // 2
    t, q, qd = rows[:, 0], rows[:, 1 : 1 + k], rows[:, 1 + k :]
    reach = np.r_[[1.0] * (k - 6), [REACH] * 6]
    least = [np.inf, np.inf]
    i, u = 0, 0.0
    while i < len(t) - 1:
        h = t[i + 1] - t[i]
        d, v0, v1 = q[i + 1] - q[i], qd[i] * h, qd[i + 1] * h
        here = q[i] + u * (v0 + u * (3 * d - 2 * v0 - v1 + u * (v0 + v1 - 2 * d)))
        found = world(float(t[i] + u * h)).least_distance(here)
        least = [min(pair) for pair in zip(least, found, strict=True)]
        # a cubic's speed is at most that of its control points: three times their steps
        fastest = np.maximum(np.maximum(np.abs(v0), np.abs(v1)), np.abs(3 * d - v0 - v1))
        way = float(fastest @ reach)
        go = max(min(found), SEEN)
        left = way * (1 - u)
        if left > go:
            u += go / way
            continue
        i, u = i + 1, 0.0  # what is left of these rows is no longer than the way that is free; rows beyond, too
        go -= left
        while i < len(t) - 1:
            h = t[i + 1] - t[i]
            d, v0, v1 = q[i + 1] - q[i], qd[i] * h, qd[i + 1] * h
            more = float(np.maximum(np.maximum(np.abs(v0), np.abs(v1)), np.abs(3 * d - v0 - v1)) @ reach)
            if more > go:
                break
            go, i = go - more, i + 1
    found = world(float(t[-1])).least_distance(q[-1])
    return min(least[0], found[0]), min(least[1], found[1])


# ------------------------------------------------------------------------------------------------------ a way at random


def connect(
    world: World, starts: Sequence[Array], goals: Sequence[Array], rng: np.random.Generator, until: float
) -> tuple[int, int] | None:
    """RRT-connect between any of the starts and any of the goals: which two; None where no way was found by `until`, in
    processor time."""
    roots = [[q for q in ends if world.free(q)] for ends in (starts, goals)]
    if not all(roots):
        return None
    pairs = sorted((float(np.abs(a - b).sum()), i, k) for i, a in enumerate(starts) for k, b in enumerate(goals))
    for _, i, k in pairs[:20]:
        if world.free(starts[i]) and world.free(goals[k]) and world.free_way(starts[i], goals[k]):
            return i, k
    span, lower, upper = world.limits.upper - world.limits.lower, world.limits.lower, world.limits.upper
    some = np.array([*roots[0], *roots[1]])
    near = np.maximum(some.min(axis=0) - 0.5, lower), np.minimum(some.max(axis=0) + 0.5, upper)
    trees = [(list(own), [-1] * len(own)) for own in roots]
    turn = 0
    while process_time() < until:
        tree, other = trees[turn], trees[1 - turn]
        draw = rng.random()
        goal = rng.uniform(*(near if draw < 0.8 else (lower, upper)))
        if draw < 0.1:
            goal = other[0][rng.integers(len(other[0]))]
        new = _extend(world, tree, goal, span, 0.4)
        while new is not None and (met := _extend(world, other, new, span, 0.4)) is not None:
            if np.abs(met - new).max() < 1e-9:
                first, last = (_root(one) for one in trees)
                return _index(starts, first), _index(goals, last)
        turn = 1 - turn
    return None


def _index(places: Sequence[Array], q: Array) -> int:
    return next(i for i, one in enumerate(places) if one is q)


def _extend(world: World, tree: tuple[list[Array], list[int]], goal: Array, span: Array, step: float) -> Array | None:
    """A step from the nearest node of a tree towards a goal, if it is free."""
    nodes, parents = tree
    i = int(np.argmin((((np.array(nodes) - goal) / span) ** 2).sum(axis=1)))
    way = goal - nodes[i]
    far = float(np.abs(way).max())
    new = goal if far <= step else nodes[i] + way * step / far
    if far < 1e-12 or not world.free(new) or not world.free_way(nodes[i], new):
        return None
    nodes.append(new)
    parents.append(i)
    return new


def _root(tree: tuple[list[Array], list[int]]) -> Array:
    """Where the branch to the last node begins."""
    nodes, parents = tree
    i = len(nodes) - 1
    while parents[i] >= 0:
        i = parents[i]
    return nodes[i]


def stretches(program: Program) -> list[list[int]]:
    """The moves' indices: each joint move with the lines that follow it."""
    out: list[list[int]] = []
    for i, motion in enumerate(program.motions):
        if isinstance(motion, MoveJ | MoveAbsJ):
            out.append([i])
        elif isinstance(motion, MoveL):
            out[-1].append(i)
    return out


def candidates(job: Job, moves: Sequence[int], rng: np.random.Generator, most: int) -> list[tuple[Array, Array]]:
    """Axes where a stretch's lines begin and where they end: each on one branch, the rail standing, all on the way
    free."""
    plant, program = job.plant, job.program
    first = program.motions[moves[0]]
    if isinstance(first, MoveAbsJ):
        rail = plant.rail_value(first.extax)
        q = np.r_[[] if rail is None else rail, first.q]
        return [(q, q)]
    assert isinstance(first, MoveJ)
    poses = [program.motions[i].X_WT @ np.linalg.inv(program.motions[i].tool.X_FT) for i in moves]  # type: ignore
    worlds = [World(plant, program, i) for i in moves]
    low, high = (plant.limits.lower[0], plant.limits.upper[0]) if plant.rail_eaxes else (0.0, 0.0)
    out: list[tuple[Array, Array]] = []
    for rail in [None] if not plant.rail_eaxes else rng.uniform(low, high, 40):
        for _, arm in plant.robot.solutions(poses[0], rail, plant.limits):
            q = q_0 = np.r_[[] if rail is None else [rail], arm]
            good = worlds[0].free(q)
            for X_0, X_1, world in zip(poses, poses[1:], worlds[1:], strict=False):
                n = max(int(np.ceil(np.linalg.norm((X_1 - X_0)[:3, 3]) / LINE)), 2)
                for s in np.arange(1, n + 1) / n:
                    X = pose(X_0[:3, :3], (1 - s) * X_0[:3, 3] + s * X_1[:3, 3])  # these lines do not turn
                    near = [a for _, a in plant.robot.solutions(X, rail, plant.limits)]
                    near = [a for a in near if np.abs(a - q[-6:]).max() < 0.4]
                    if not good or not near:
                        good = False
                        break
                    q = np.r_[q[:-6], min(near, key=lambda a: float(np.abs(a - q[-6:]).max()))]
                    good = world.free(q)
            if good:
                out.append((q_0, q))
        if len(out) >= most:
            break
    return out


def way_exists(job: Job, seed: int, seconds: float) -> bool:
    """Whether a route of free ways was found: stretch by stretch, to one or two of the places that can be reached."""
    rng, moves = np.random.default_rng(seed), stretches(job.program)
    ends = [job.plant.start]
    for own in moves:
        world, until = World(job.plant, job.program, own[0]), process_time() + seconds / len(moves)
        there = candidates(job, own, rng, 12)
        reached: list[Array] = []
        while there and len(reached) < 3 and process_time() < until:
            found = connect(world, ends, [q_0 for q_0, _ in there], rng, until)
            if found is None:
                break
            reached.append(there.pop(found[1])[1])
            until = min(until, process_time() + seconds / 20)
        if not reached:
            return False
        ends = reached
    return True


# --------------------------------------------------------------------------------------------------------- the scenes


def program_text(points: Sequence[Array]) -> str:
    """Down to each point and up again, and home; the tool hangs straight down."""
    rows = ["MODULE Scene", "  CONST jointtarget home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];"]
    rows += [f"  PERS tooldata tGrip:=[TRUE,[[0,0,{TOOL * 1e3:g}],[1,0,0,0]],[1,[0,0,40],[1,0,0,0],0,0,0]];"]
    for i, (x, y, z) in enumerate(np.round(np.array(points) * 1e3), 1):
        for name, up in ((f"p{i}_in", 100), (f"p{i}", 0)):
            place = f"[{x:g},{y:g},{z + up:g}],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]"
            rows.append(f"  CONST robtarget {name}:=[{place}];")
    rows += ["  PROC main()", "    ConfJ \\Off;", "    ConfL \\Off;"]
    for i in range(1, len(points) + 1):
        rows += [f"    MoveJ p{i}_in, v1000, fine, tGrip;", f"    MoveL p{i}, v300, fine, tGrip;"]
        rows += ["    WaitTime 0.2;", f"    MoveL p{i}_in, v300, fine, tGrip;"]
    return "\n".join([*rows, "    MoveAbsJ home, v1000, fine, tGrip;", "  ENDPROC", "ENDMODULE", ""])


def cell_text(rail: bool, boxes: Sequence[tuple[Array, Array]]) -> str:
    """The cell of a scene; boxes: centre and size."""
    rows = [f"robot: {'irb140_rail' if rail else 'irb140'}"]
    rows += ["rail: {eax: a, stroke: [-0.2, 2.2]}"] if rail else []
    if rail:
        rows.append('limits: {rail: {velocity: 1, acceleration: 3, source: "a made scene"}}')
    rows.append(f'start: {{joints: "[0, 0, 0, 0, 30, 0] deg"{", rail: 0" if rail else ""}}}')
    if boxes:
        rows += [f"clearance: {CLEARANCE}", "obstacles:"]
    for i, (centre, size) in enumerate(boxes, 1):
        rows.append(
            f"  box{i}: {{box: {{size: {np.round(size, 3).tolist()}, position: {np.round(centre, 3).tolist()}}}}}"
        )
    return "\n".join([*rows, ""])


def make_scene(seed: int, folder: Path) -> list[Path]:
    """The program without boxes and with them. A box that leaves a point no free posture is drawn anew."""
    rng = np.random.default_rng(seed)
    rail = seed % 2 == 1
    while True:
        points = []
        for _ in range(rng.integers(2, 4)):
            far, turn, z = rng.uniform(0.38, 0.58), rng.uniform(-2.0, 2.0), rng.uniform(0.1, 0.45)
            points.append(
                np.array([far, rng.uniform(0, 2), z] if rail else [far * np.cos(turn), far * np.sin(turn), z])
            )
        bare = write(folder / "bare", program_text(points), cell_text(rail, ()))
        job = read_job(bare)
        if all(candidates(job, moves, rng, 1) for moves in stretches(job.program)):
            break
    boxes: list[tuple[Array, Array]] = []
    for _ in range(rng.integers(1, 7)):
        for _ in range(60):
            a, b = (points[i] for i in rng.choice(len(points), 2, replace=False))
            centre = a + rng.uniform(0.1, 0.9) * (b - a) + rng.normal(0, 0.12, 3)
            size = rng.uniform(0.05, 0.35, 3)
            if rail and centre[0] - size[0] / 2 < BASE:
                continue
            boxes.append((centre, size))
            path = write(folder / "boxes", program_text(points), cell_text(rail, boxes))
            job = read_job(path)
            free = World(job.plant, job.program, -1).free(job.plant.start)
            if free and all(candidates(job, moves, rng, 1) for moves in stretches(job.program)):
                break
            boxes.pop()
    return [bare, write(folder / "boxes", program_text(points), cell_text(rail, boxes))]


def write(stem: Path, program: str, cell: str) -> Path:
    stem.parent.mkdir(parents=True, exist_ok=True)
    stem.with_suffix(".mod").write_text(program)
    stem.with_suffix(".yaml").write_text(cell)
    return stem.with_suffix(".mod")


def plan(program: Path, seconds: float) -> dict[str, object]:
    """What the command says of a program, and the processor's seconds it takes."""
    out, most = program.with_suffix(""), int(6 * seconds + 60)
    command = [sys.executable, "-m", "trajopt_cli.cli", "optimize", str(program), "--output", str(out), "--json"]
    command += ["--quiet", "--jobs", "1", "--time-limit", f"{seconds:g}"]
    begun = children()
    done = subprocess.run(
        command,
        capture_output=True,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (most, most + 5)),
    )
    spent = children() - begun
    if done.returncode == -signal.SIGXCPU:
        return {"answer": "too long", "seconds": spent, "why": []}
    said = json.loads(done.stdout) if done.stdout.lstrip().startswith("{") else {}
    answer = "planned" if done.returncode == 0 else str(said.get("answer", f"exit {done.returncode}"))
    cycle = said.get("plans", {}).get("stream", {}).get("cycle_time_s")
    why = [line for line in done.stderr.splitlines() if line.strip()][-1:]
    return {"answer": answer, "seconds": spent, "cycle": cycle, "why": [] if answer == "planned" else why}


def children() -> float:
    """The processor's seconds of all commands so far."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def scene(seed: int, folder: Path, seconds: float, search: float) -> dict[str, object]:
    """One seed: planned with boxes and without, looked at, and searched for at random where there is no plan."""
    bare, boxed = make_scene(seed, folder)
    job = read_job(boxed)
    found: dict[str, object] = {"seed": seed, "boxes": len(job.plant.obstacles)}
    found["bare"], found["boxed"] = plan(bare, seconds), plan(boxed, seconds)
    if found["boxed"]["answer"] == "planned":  # type: ignore[index]
        world = World(job.plant, job.program, 0)
        rows = [np.array(list(csv.reader(path.open()))[1:], dtype=float)
                for path in (boxed.with_suffix("") / f"{one}.csv" for one in ("stream", "rapid"))]  # fmt: skip
        least = [check_rows(lambda _: world, one) for one in rows]
        found["least"] = [list(pair) for pair in least]
        found["clean"] = all(apart >= CLEARANCE - 2 * SEEN and itself >= -2 * SEEN for apart, itself in least)
    else:
        begun = process_time()
        found["way"] = way_exists(job, seed, search)
        found["search"] = process_time() - begun
    return found


def table(rows: Sequence[dict[str, object]]) -> str:
    """A line for each seed, and the sums."""
    out = [
        f"{'seed':>5} {'boxes':>5} {'answer':<12} {'look':<6} {'way':<11} {'s bare':>7} {'s boxed':>7} {'cycle':>14}"
    ]
    for row in rows:
        bare, boxed = row["bare"], row["boxed"]
        assert isinstance(bare, dict)
        assert isinstance(boxed, dict)
        look = {True: "clean", False: "HITS", None: ""}[row.get("clean")]  # type: ignore[index]
        way = {True: "FOUND", False: "none found", None: ""}[row.get("way")]  # type: ignore[index]
        cycles = "  ".join("    –" if one.get("cycle") is None else f"{one['cycle']:.3f}" for one in (bare, boxed))
        out.append(f"{row['seed']:>5} {row['boxes']:>5} {boxed['answer']:<12} {look:<6} {way:<11} "
                   f"{bare['seconds']:7.1f} {boxed['seconds']:7.1f} {cycles:>14}")  # fmt: skip
        out += [f"      {line}" for line in boxed.get("why", [])]
    planned = [row for row in rows if row["boxed"]["answer"] == "planned"]  # type: ignore[index]
    missed = [row for row in rows if row.get("way")]
    both = [row for row in planned if row["bare"]["answer"] == "planned"]  # type: ignore[index]
    ratio = [row["boxed"]["seconds"] / row["bare"]["seconds"] for row in both]  # type: ignore[index]
    median = {key: float(np.median([row[key]["seconds"] for row in rows])) for key in ("bare", "boxed")}  # type: ignore
    hits, none = sum(row.get("clean") is False for row in planned), len(rows) - len(planned) - len(missed)
    told = (
        f"{len(rows)} scenes: {len(planned)} planned, {hits} of them with a hit; {len(missed)} not planned although",
        f"there is a way; {none} where none was found. Medians: {median['bare']:.1f} s without boxes,",
        f"{median['boxed']:.1f} s with them; ratio where both are planned {_median(ratio):.2f}",
    )
    out.append(" ".join(told))
    return "\n".join(out)


def _median(values: Sequence[float]) -> float:
    return float(np.median(values)) if values else float("nan")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--first", type=int, default=4000)
    parser.add_argument("--count", type=int, default=50)
    parser.add_argument("--folder", type=Path, default=Path("results/scenes"))
    parser.add_argument("--seconds", type=float, default=10.0, help="time limit of a plan")
    parser.add_argument("--search", type=float, default=60.0, help="time limit of the search at random")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for seed in range(given.first, given.first + given.count):
        done, mine = given.folder / f"{seed}.json", given.folder / f"{seed}.working"
        if not done.exists():
            with mine.open("w") as lock:
                try:
                    fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                except BlockingIOError:  # somebody else's; one that was cut off is nobody's
                    continue
                found = scene(seed, given.folder / str(seed), given.seconds, given.search)
                part = done.with_suffix(".part")
                part.write_text(json.dumps(found, indent=1))
                part.replace(done)
            mine.unlink()
        rows.append(json.loads(done.read_text()))
        print(rows[-1]["seed"], rows[-1]["boxed"]["answer"], rows[-1].get("clean"), rows[-1].get("way"), flush=True)
    print(table(rows))


if __name__ == "__main__":
    main()
