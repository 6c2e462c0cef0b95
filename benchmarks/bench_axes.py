"""One, two and three linear axes under the base: cycle and processor time, against a plain search timed by toppra.

    python benchmarks/bench_axes.py [--seeds 0 1 2] [--axes 1 2 3]

Every seed is a program of three to six stations under an IRB 140 that hangs from one axis along the world's x, from
that and one along y, or from these and one along z: MoveJ above, MoveL down, a wait, MoveL up, and home at the end. All
points are in reach with the first axis alone, and are stops, so that the plain search's motion is one of RAPID, too:
PLACES on every axis' stroke and the programmed ones, all branches and turns of the arm there, the route that takes
least by dynamic programming; joint moves straight in the joints, lines with the axes in proportion, timed by the
package toppra. It looks at no body and at no cap on the tool but the lines' speed, which makes it no slower.
"""

from __future__ import annotations

import argparse
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

import numpy as np
from scipy.interpolate import CubicSpline

from trajopt_cli.geometry import Array, IndexArray, pose
from trajopt_cli.job import Job, read_job
from trajopt_cli.judge.libraries import shortest_time
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import MoveAbsJ, MoveJ, MoveL
from trajopt_cli.plan import optimize
from trajopt_cli.problem.plan import Plan, Target

STROKES, PLACES = ("[0, 3]", "[-0.6, 0.6]", "[-0.3, 0.3]"), (31, 5, 3)
WAIT, LINE = 0.2, 0.5  # s, m/s
POINTS = 31  # of a line


def write(seed: int, r: int, folder: Path) -> Job:
    """The seed's program on so many axes."""
    rng = np.random.default_rng(seed)
    spots = rng.uniform([200, -350, 250], [2800, 350, 450], (rng.integers(3, 7), 3))
    turns = rng.uniform(-np.pi, np.pi, len(spots))  # of the tool, which points down
    home, body = ",".join(["0"] * r + ["9E9"] * (6 - r)), [r"ConfJ\Off;", r"ConfL\Off;"]
    for (x, y, z), turn in zip(spots, turns, strict=True):
        eax = ",".join([f"{x:.1f}", "0", "0"][:r] + ["9E9"] * (6 - r))
        rot = f"[0,{np.cos(turn / 2):.9f},{np.sin(turn / 2):.9f},0],[0,0,0,0],[{eax}]"
        above, down = (f"[[{x:.1f},{y:.1f},{z + up:.1f}],{rot}]" for up in (100, 0))
        body += [f"MoveJ {above},vmax,fine,tool0;", f"MoveL {down},v500,fine,tool0;"]
        body += [f"WaitTime {WAIT};", f"MoveL {above},v500,fine,tool0;"]
    body += [f"MoveAbsJ [[0,0,0,0,30,0],[{home}]],vmax,fine,tool0;"]
    cell = ["robot: irb140", 'base: {position: [0, 0, 1.25], rpy: ["180 deg", 0, 0]}', "tool_radius: 0", "settle: 0"]
    cell += ["tcp: {speed: 10, acceleration: 100, source: a made gantry}", "axes:"]
    for i in range(r):
        way = f"axis: {np.eye(3, dtype=int)[i].tolist()}, stroke: {STROKES[i]}"
        cell.append(f"  eax_{'abc'[i]}: {{{way}, velocity: 1.5, acceleration: 3, source: a made gantry}}")
    cell.append(f'start: {{joints: "[0, 0, 0, 0, 30, 0] deg", rail: {"0" if r == 1 else [0] * r}}}')
    program = folder / f"axes_{seed}_{r}.mod"
    program.write_text("\n".join(["MODULE Axes", "PROC main()", *body, "ENDPROC", "ENDMODULE", ""]))
    program.with_suffix(".yaml").write_text("\n".join(cell) + "\n")
    return read_job(program)


def nodes(job: Job, X_WF: Array, written: Array) -> tuple[Array, IndexArray]:
    """Axes (n, k) that reach a pose and their branches (n,): PLACES on every axis, and written."""
    robot, limits, r = job.plant.robot, job.plant.limits, job.plant.layout.r
    grid = [np.linspace(limits.lower[i], limits.upper[i], PLACES[i]) for i in range(r)]
    places = np.array([*product(*grid), tuple(written)])
    arms = robot.branches(np.tile(X_WF, (len(places), 1, 1)), places if r > 1 else places[:, 0])
    every = arms[:, :, None] + robot.turns
    q = np.concatenate([np.broadcast_to(places[:, None, None], (*every.shape[:3], r)), every], axis=-1)
    inside = ((q >= limits.lower) & (q <= limits.upper)).all(axis=-1)  # not so for NaN
    return q[inside], np.broadcast_to(np.arange(8)[:, None], every.shape[:3])[inside]


def edges(a: tuple[Array, IndexArray], b: tuple[Array, IndexArray], job: Job, line: float | None) -> Array:
    """What a straight way in the joints takes (n, m) [s]; of a line about that, and infinity between branches."""
    top, ramp, k = *(np.full((len(a[0]), len(b[0])), 1e-9) for _ in range(2)), a[0].shape[1]
    for i, v, acc in zip(range(k), job.plant.limits.velocity, job.plant.limits.acceleration, strict=True):
        d = np.abs(a[0][:, None, i] - b[0][None, :, i])
        if line is not None and i >= k - 6:
            top[d > 1] = np.inf  # another turn
        top, ramp = np.maximum(top, d / v), np.maximum(ramp, d / acc)
    if line is not None:
        top = np.where(a[1][:, None] == b[1][None], np.maximum(top, line / LINE), np.inf)
    return np.asarray(np.where(top**2 >= ramp, top + ramp / top, 2 * np.sqrt(ramp)))


def line_time(job: Job, X: tuple[Array, Array], q: tuple[Array, Array], cfx: int) -> float:
    """What a line takes with the axes in proportion, by toppra [s]; infinity where the arm cannot follow."""
    limits, r, u = job.plant.limits, job.plant.layout.r, np.linspace(0, 1, POINTS)
    rail = q[0][:r] + u[:, None] * (q[1] - q[0])[:r]
    at = np.array([pose(X[0][:3, :3], p) for p in X[0][:3, 3] + u[:, None] * (X[1] - X[0])[:3, 3]])  # they do not turn
    arm = np.unwrap(job.plant.robot.branch(at, rail if r > 1 else rail[:, 0], cfx), axis=0)
    every = np.column_stack([rail, arm + q[0][r:] - arm[0], u * np.linalg.norm((X[1] - X[0])[:3, 3])])
    inside = (every[:, :-1] >= limits.lower - 1e-9) & (every[:, :-1] <= limits.upper + 1e-9)  # not so for NaN
    if not inside.all() or np.abs(every[-1, :-1] - q[1]).max() > 1e-6 or np.abs(np.diff(arm, axis=0)).max() > 0.5:
        return np.inf
    caps, s = (np.r_[limits.velocity, LINE], np.r_[limits.acceleration, 100.0]), every[:, -1]
    return shortest_time(s, every, CubicSpline(s, every)(s, 1), *caps, 0.0, 0.0) or np.inf


def plain(job: Job) -> float:
    """Cycle time [s] of the plain search's motion."""
    r, moves = job.plant.layout.r, [one for one in job.program.motions if isinstance(one, MoveJ | MoveL | MoveAbsJ)]
    poses, layers = [np.eye(4)], [(job.plant.start[None], np.zeros(1, dtype=np.intp))]
    for one in moves:
        written = np.array([value / 1e3 for value in one.extax[:r] if value is not None])
        if isinstance(one, MoveAbsJ):
            poses.append(np.eye(4))
            layers.append((np.r_[written, one.q][None], np.zeros(1, dtype=np.intp)))
        else:
            poses.append(one.X_WT)
            layers.append(nodes(job, one.X_WT, written))
    lines = [float(np.linalg.norm((b - a)[:3, 3])) if isinstance(one, MoveL) else None
             for one, a, b in zip(moves, poses, poses[1:], strict=False)]  # fmt: skip
    between = [edges(a, b, job, line) for a, b, line in zip(layers, layers[1:], lines, strict=False)]
    timed: set[tuple[int, int, int]] = set()
    while True:  # until the best route's lines take what the search took them to take
        cost, back = np.zeros(1), list[IndexArray]()
        for edge in between:
            back.append((cost[:, None] + edge).argmin(axis=0))
            cost = (cost[:, None] + edge).min(axis=0)
        route = [int(cost.argmin())]
        for came in reversed(back):
            route.insert(0, int(came[route[0]]))
        asked = {(k, route[k], route[k + 1]) for k, line in enumerate(lines) if line is not None} - timed
        if not asked:
            return float(cost.min()) + WAIT * sum(line is None for line in lines[:-1])
        for k, i, j in asked:
            ends = layers[k][0][i], layers[k + 1][0][j]
            between[k][i, j] = line_time(job, (poses[k], poses[k + 1]), ends, int(layers[k][1][i]))
        timed |= asked


def ours(job: Job, target: Target) -> float:
    """Cycle time [s] of the plan. Raises ValueError for one that is not legal."""
    plan = optimize(job.program, job.plant, target)
    if not isinstance(plan, Plan) or not verify(job.program, job.plant, plan.trajectory, target=target).legal:
        raise ValueError(f"{target.value}: {plan}")
    return plan.duration


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--seeds", type=int, nargs="*", default=[*range(8)])
    parser.add_argument("--axes", type=int, nargs="*", default=[1, 2, 3])
    given = parser.parse_args()
    print("seed axes |  plain   rapid  saved  stream  saved | s plain  s ours  of one axis", flush=True)
    first = np.nan
    with TemporaryDirectory() as folder:
        for seed, r in product(given.seeds, given.axes):
            job, times = write(seed, r, Path(folder)), [process_time()]
            base = plain(job)
            times.append(process_time())
            found = [ours(job, target) for target in (Target.RAPID, Target.STREAM)]
            searched, spent = np.diff([*times, process_time()])
            first = spent if r == given.axes[0] else first
            saved = " ".join(f"{x:7.3f} {1 - x / base:6.1%}" for x in found)
            row = f"{seed:4d} {r:4d} | {base:6.3f} {saved} | {searched:7.1f} {spent:7.1f} {spent / first:8.2f}"
            print(row, flush=True)


if __name__ == "__main__":
    main()
