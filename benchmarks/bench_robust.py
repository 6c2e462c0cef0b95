"""Programs nobody tuned for: python benchmarks/bench_robust.py [--seeds 1000:1300] [--jobs N] [--timeout S]
                              [--starts N] [--json FILE] [--keep FOLDER]

Every seed is one program with a cell of its own: with a rail or without, 1 to 8 stations on both sides of it, and some
of the ODDITIES. It is optimised by the command, in a process of its own, and what is written is judged by the command.
An answer that it cannot be done is held against a check of its own: an inverse kinematics written here, tested against
pin, on rail positions, branches and turns finer than the planner's, along all lines and arcs of a station; a time that
is too short against what the tool alone takes. --starts N:
each program that has a plan is planned N times more in cells that are narrowed at random; what is faster there is legal
in the whole cell, too, and was missed. --timeout: seconds of processor, all processes of a program together.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from threading import Event
from time import monotonic, sleep

import numpy as np
import pinocchio

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.job import Job, read_job
from trajopt_cli.motion import MoveAbsJ, MoveC, MoveJ, MoveL
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.pipeline.planning import may_change
from trajopt_cli.plan import optimize
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Plan, Target

REPOSITORY = Path(__file__).parents[1]
ODDITIES = (
    "tilted", "singular", "boundary", "limits", "corners", "arcs", "timed", "waits", "zero length", "repeated", "1 mm",
    "turning", "through singularity", "slow", "vmax",
)  # fmt: skip
DIGIT = "%.4f"
SLOW = 10.0  # times the median of all seconds per move is worth a look
RAIL_STEP, PLACES = 0.01, 61  # of the check of an answer no: the rail's positions [m], places on a line or an arc
SHIFTS = 0.6  # m by which the rail may move along one line there
CLOCK = 10.0  # seconds of the clock per second of processor that a program may take: on a busy machine, or asleep
Placed = MoveJ | MoveL | MoveC  # moves that end in a pose
STOPPED = Event()  # Ctrl-C or SIGTERM: what runs is killed, what waits is not begun
BEYOND = 1e-9  # rad an axis may stand outside its range
SINGULAR = 1e-3  # sine of joint 5 and cosine of joint 3's angle to the stretched arm that a line stays away from


# -------------------------------------------------------------------------------------------------------- programs


@dataclass(frozen=True)
class Made:
    """A program: its text, its cell and what is odd about it."""

    text: str
    cell: str
    odd: tuple[str, ...]


class _Writer:
    """One program in the making."""

    def __init__(self, seed: int):
        self.rng = np.random.default_rng(seed)
        self.rail = bool(self.rng.random() < 0.7)
        count = int(self.rng.integers(1, 5))
        self.odd = tuple(str(one) for one in self.rng.choice(ODDITIES, count, replace=False))
        self.lines: list[str] = []
        self.stroke = float(self.rng.choice([1.2, 2.4, 4.0]))

    def has(self, odd: str) -> bool:
        return odd in self.odd

    def speed(self, joint: bool) -> str:
        if self.has("slow"):
            return str(self.rng.choice(["v10", "v20", "v50"]))
        if self.has("vmax"):
            return "vmax"
        return str(self.rng.choice(["v1000", "v2500"] if joint else ["v100", "v300", "v800"]))

    def zone(self) -> str:
        passed = self.has("corners") and self.rng.random() < 0.7
        return str(self.rng.choice(["z1", "z5", "z20", "z100"])) if passed else "fine"

    def pose(self) -> tuple[Array, Array, float]:
        """A place [mm], an orientation and the rail [mm]."""
        rng = self.rng
        side = rng.choice([-1, 1]) if self.rail else 1
        reach = rng.uniform(700, 800) if self.has("boundary") else rng.uniform(430, 560)
        y = rng.uniform(0, 1e3 * self.stroke) if self.rail else rng.uniform(-280, 280)
        p = np.array([side * reach, y, rng.uniform(200, 450)])
        tilt = np.radians(rng.uniform(0, 60)) if self.has("tilted") else 0.0
        tilt = np.pi / 2 - rng.uniform(0, 0.05) if self.has("singular") else tilt  # the tool along the forearm
        about, turn = rng.uniform(-np.pi, np.pi), rng.uniform(-np.pi / 4, np.pi / 4)
        if self.has("singular"):
            about = np.arctan2(p[1] - y, p[0]) + np.pi / 2
        q = _times(_axis(np.array([np.cos(about), np.sin(about), 0.0]), -tilt), np.array([0.0, 1.0, 0.0, 0.0]))
        return p, _times(q, _axis(np.array([0.0, 0.0, 1.0]), turn)), y

    def target(self, p: Array, q: Array, rail: float) -> str:
        place, turn = (",".join(format % x for x in v) for v, format in ((p, DIGIT), (q, "%.8f")))
        eax = DIGIT % rail if self.rail else "9E9"
        return f"[[{place}],[{turn}],[0,0,0,0],[{eax},9E9,9E9,9E9,9E9,9E9]]"

    def move(self, name: str, target: str, joint: bool = False, stop: bool = False, via: str = "") -> None:
        zone, speed = "fine" if stop else self.zone(), self.speed(joint)
        if self.has("timed") and not joint and self.rng.random() < 0.5:
            speed += f"\\T:={self.rng.choice([0.05, 0.5, 2, 20]):g}"
        self.lines.append(f"{name} {via}{target}, {speed}, {zone}, tool0;")

    def station(self) -> None:
        rng, (p, q, rail) = self.rng, self.pose()
        up = np.array([0.0, 0.0, rng.uniform(50, 140)])
        here = self.target(p, q, rail)
        self.move("MoveJ", self.target(p + up, q, rail), joint=True)
        self.move("MoveL", here, stop=True)
        if self.has("waits"):
            self.lines.append(f"WaitTime {rng.choice(['0.000001', '0.001', '0.3', '30', '1000', '86400'])};")
        if self.has("zero length"):
            self.move("MoveL", here, stop=True)
        if self.has("1 mm"):
            for step in (1.0, 1.5):
                self.move("MoveL", self.target(p + step * rng.choice([-1, 1]) * np.eye(3)[rng.integers(3)], q, rail))
        if self.has("turning"):
            self.move("MoveL", self.target(p, _times(q, _axis(np.eye(3)[2], rng.uniform(-1.2, 1.2))), rail))
        if self.has("arcs"):
            way, r = rng.uniform(-np.pi, np.pi), rng.uniform(5, 60)
            e, f = np.array([np.cos(way), np.sin(way), 0]), np.array([-np.sin(way), np.cos(way), 0])
            half = self.target(p + r * (e + f), q, rail) + ", "
            self.move("MoveC", self.target(p + 2 * r * e, q, rail), via=half)
        self.move("MoveL", self.target(p + up, q, rail), stop=True)
        if self.has("repeated"):
            for _ in range(3):
                self.move("MoveJ", self.target(p + up, q, rail), joint=True, stop=True)

    def made(self) -> Made:
        n = int(self.rng.choice([1, 1, 2, 2, 3, 4, 5, 8]))
        eax = "0" if self.rail else "9E9"
        head = f"CONST jointtarget home:=[[0,0,0,0,30,0],[{eax},9E9,9E9,9E9,9E9,9E9]];\n"
        for i in range(n):
            self.station()
            if self.has("through singularity"):
                joints = f"[{self.rng.uniform(-60, 60):.3f},0,0,{90 * (i % 2)},{30 * (-1) ** (i + 1)},0]"
                self.lines.append(f"MoveAbsJ [{joints},[{eax},9E9,9E9,9E9,9E9,9E9]], v1000, fine, tool0;")
        self.lines.append("MoveAbsJ home, v1000, fine, tool0;")
        text = f"MODULE Robust\n{head}PROC main()\n" + "\n".join(self.lines) + "\nENDPROC\nENDMODULE\n"
        return Made(text, self.cell(), self.odd)

    def cell(self) -> str:
        scale = 10.0 ** self.rng.uniform(-1, 1) if self.has("limits") else 1.0
        joint = zip((3.49, 3.49, 4.54, 6.28, 6.28, 7.85), (15.0, 15.0, 20.0, 40.0, 40.0, 50.0), strict=True)
        tail = 'source: "benchmark"}\n'
        limits = "limits:\n" + "".join(
            f"  joint_{i}: {{velocity: {v * scale:.4f}, acceleration: {a * scale:.4f}, {tail}"
            for i, (v, a) in enumerate(joint, 1)
        )
        start = 'start: {joints: "[0, 0, 0, 0, 30, 0] deg"'
        if not self.rail:
            return f"robot: irb140\nprofile: default\n{limits}{start}}}\n"
        rail = f"  rail: {{velocity: {scale:.4f}, acceleration: {3 * scale:.4f}, {tail}"
        stroke = f"rail: {{eax: a, stroke: [-0.2, {self.stroke - 0.2:g}]}}\n"
        return f"robot: irb140_rail\nprofile: default\n{stroke}{limits}{rail}{start}, rail: 0}}\n"


def _axis(axis: Array, angle: float) -> Array:
    return np.r_[np.cos(angle / 2), np.sin(angle / 2) * axis]


def _times(a: Array, b: Array) -> Array:
    v, w = a[1:], b[1:]
    return np.r_[a[0] * b[0] - v @ w, a[0] * w + b[0] * v + np.cross(v, w)]


# ---------------------------------------------------------------------------------------- the check of an answer no

FOOT, HEIGHT, UPPER, FORE, HAND = 0.07, 0.352, 0.36, 0.38, 0.065  # m, of the IRB 140
BRANCHES = tuple((front, elbow, wrist) for front in (1, -1) for elbow in (1, -1) for wrist in (1, -1))


def arm(X: Array, branch: tuple[int, int, int]) -> Array:
    """Joints (..., 6) that put the flange at X (..., 4, 4) from the arm's foot, within half a turn; NaN where none."""
    front, elbow, wrist = branch
    R, z = X[..., :3, :3], X[..., :3, 2]
    x, y, h = np.moveaxis(X[..., :3, 3] - HAND * z, -1, 0)
    q1 = np.arctan2(front * y, front * x)
    u, w = front * np.hypot(x, y) - FOOT, h - HEIGHT
    with np.errstate(invalid="ignore"):
        q3 = np.arcsin((UPPER**2 + FORE**2 - u * u - w * w) / (2 * UPPER * FORE))
    q3 = np.where(elbow > 0, q3, np.pi - q3)
    a, b = UPPER - FORE * np.sin(q3), FORE * np.cos(q3)
    q2 = np.arctan2(a * u - b * w, b * u + a * w)
    c, s, C, S = np.cos(q1), np.sin(q1), np.cos(q2 + q3), np.sin(q2 + q3)
    zero = np.zeros_like(c)
    rows = [[c * C, -s, c * S], [s * C, c, s * S], [-S, zero, C]]  # of Rz(q1) Ry(q2 + q3)
    R_03 = np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)
    M = np.swapaxes(R_03, -1, -2) @ R @ np.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]])  # Rx(q4) Ry(q5) Rx(q6)
    q5 = wrist * np.arccos(np.clip(M[..., 0, 0], -1, 1))
    q4 = np.arctan2(wrist * M[..., 1, 0], -wrist * M[..., 2, 0])
    q6 = np.arctan2(wrist * M[..., 0, 1], wrist * M[..., 0, 2])
    q3 = np.arctan2(np.sin(q3), np.cos(q3))
    return np.stack([q1, np.arctan2(np.sin(q2), np.cos(q2)), q3, q4, q5, q6], axis=-1)


def arm_is_pins() -> None:
    """Every random posture is found again on one of the branches, and all of them lead to its flange."""
    model = pinocchio.buildModelFromUrdf(str(REPOSITORY / "robots" / "irb140.urdf"))
    data, rng = model.createData(), np.random.default_rng(1)
    frame = model.getFrameId("flange")
    for q in rng.uniform(model.lowerPositionLimit, model.upperPositionLimit, (200, 6)):
        pinocchio.framesForwardKinematics(model, data, q)
        X = data.oMf[frame].homogeneous
        found = np.array([arm(X, branch) for branch in BRANCHES])
        found = found[~np.isnan(found).any(axis=1)]
        assert np.abs(np.exp(1j * found) - np.exp(1j * q)).max(axis=1).min() < 1e-6, q
        for one in found:
            pinocchio.framesForwardKinematics(model, data, one)
            assert np.abs(data.oMf[frame].homogeneous - X).max() < 1e-9, one


@dataclass(frozen=True, eq=False)
class Stretch:
    """What one configuration serves: flange ways (m, 4, 4) between stops from joint move to joint move; where it begins
    in given joints, these; rails (low, high) at its points."""

    ways: list[Array]
    joints: Array | None
    rails: list[tuple[float, float]]
    place: str


def stretches(job: Job) -> Iterator[Stretch]:
    """The stations of a program, corners driven through their points."""
    plant = job.plant
    has_rail = plant.robot.has_rail
    low, high = (float(plant.limits.lower[0]), float(plant.limits.upper[0])) if has_rail else (0.0, 0.0)
    rail = float(plant.start[0]) if has_rail else 0.0
    X_WT, ways, rails, place = None, list[Array](), [(rail, rail)], "start"
    joints: Array | None = np.asarray(plant.start[-6:])
    for motion in job.program.motions:
        if isinstance(motion, MoveL | MoveC) and X_WT is not None:
            way = segment_of(motion, X_WT)
            ways.append(way.pose(np.linspace(0, 1, PLACES)) @ inverse_pose(motion.tool.X_FT))
            rails.append((low, high))
            X_WT = motion.X_WT
        elif hasattr(motion, "target"):
            if len(ways):
                yield Stretch(ways, joints, rails, place)
            place, ways, joints = str(motion.source), [], None
            if isinstance(motion, MoveAbsJ):
                rail = rail if motion.extax[0] is None else motion.extax[0] / 1e3
                joints = motion.q
                q = np.r_[[rail] if has_rail else [], joints]
                X_WT, rails = plant.robot.forward(q) @ motion.tool.X_FT, [(rail, rail)]
            else:
                X_WT, rails = motion.X_WT, [(low, high)]
                ways = [np.tile(X_WT @ inverse_pose(motion.tool.X_FT), (2, 1, 1))]  # to be there is a way, too
                rails.append((low, high))
    if len(ways):
        yield Stretch(ways, joints, rails, place)


def no_way(job: Job) -> str:
    """Whether every station can be done by some rail positions, branch and turns: the first that cannot, or none."""
    for stretch in stretches(job):
        if not any(_served(job, stretch, branch) for branch in BRANCHES):
            return f"confirmed from {stretch.place} on"
    return "CONTRADICTED: every station can be done"


def too_short(job: Job, said: str) -> str:
    """Whether the tool alone, at its speed and acceleration from rest to rest, takes longer over the line or arc that
    was refused than it is given."""
    tcp, before = job.plant.tcp, None
    for motion in job.program.motions:
        if not hasattr(motion, "target"):
            continue
        stops = all(one is None or one.zone.stop for one in (before, motion))
        if f"{motion.source}:" in said and isinstance(motion, MoveL | MoveC) and isinstance(before, Placed) and stops:
            way = segment_of(motion, before.X_WT).length
            ramp = tcp.speed**2 / tcp.acceleration  # m of run-up and run-out together at the greatest speed
            least = 2 * np.sqrt(way / tcp.acceleration) if way < ramp else (way + ramp) / tcp.speed
            if motion.duration is not None and least > motion.duration:
                return f"confirmed by the tool's way, {least:.3f} s"
            break
        before = motion
    return "time: not checked"


def _served(job: Job, stretch: Stretch, branch: tuple[int, int, int]) -> bool:
    """Along the stretch, every way with the rail in proportion, from any of the states at its begin."""
    limits = job.plant.limits
    low, high = np.asarray(limits.lower[-6:]) - BEYOND, np.asarray(limits.upper[-6:]) + BEYOND
    at: dict[tuple[int, int, int, int], None] | None = None  # rail number, turns of joints 1, 4, 6
    for k, way in enumerate(stretch.ways):
        d_0, d_1 = (np.unique(np.r_[np.arange(a, b, RAIL_STEP), b]) for a, b in stretch.rails[k : k + 2])
        after = dict[tuple[int, int, int, int], None]()
        standing = bool(np.abs(way - way[:1]).max() < 1e-9) and stretch.rails[k] == stretch.rails[k + 1]
        s = np.linspace(0, 1, len(way))[:, None]
        for number, begin in enumerate(d_0):
            ends = np.flatnonzero(np.abs(d_1 - begin) <= (1e-12 if standing else SHIFTS))
            states = None if at is None else [turns for n, *turns in at if n == number]
            if not len(ends) or states == []:
                continue
            X = np.repeat(way[:, None], len(ends), axis=1)
            if job.plant.robot.has_rail:
                X[..., 1, 3] -= begin + s * (d_1[ends] - begin)
            q = np.unwrap(arm(X, branch), axis=0)
            clear = (np.abs(np.sin(q[..., 4])) > SINGULAR) & (np.abs(np.cos(q[..., 2])) > SINGULAR)
            good = clear.all(axis=0) & (np.abs(np.diff(q, axis=0)).max(axis=(0, 2)) < 0.6)  # NaN is not
            q_0 = q[0, 0]
            if states is None:
                states = [list(turns) for turns in np.ndindex(3, 3, 5)]
                states = [[a - 1, b - 1, c - 2] for a, b, c in states]
                if stretch.joints is not None:
                    off = (stretch.joints - q_0) / (2 * np.pi)
                    near = np.abs(off - np.round(off)).max() < 1e-6
                    states = [[round(off[i]) for i in (0, 3, 5)]] if near else []
            for turns in states:
                more = np.zeros(6)
                more[[0, 3, 5]] = 2 * np.pi * np.array(turns)
                kept = good & ((q + more >= low) & (q + more <= high)).all(axis=(0, 2))
                for i in np.flatnonzero(kept):
                    new = np.round((q[-1, i] + more - _half(q[-1, i])) / (2 * np.pi))[[0, 3, 5]].astype(int)
                    after[(int(ends[i]), *new.tolist())] = None
        at = after
        if not at:
            return False
    return True


def _half(q: Array) -> Array:
    return np.asarray(np.arctan2(np.sin(q), np.cos(q)))


# -------------------------------------------------------------------------------------------------------------- runs


def command(arguments: list[str], patience: float, checkout: Path = REPOSITORY) -> tuple[int | None, str, float]:
    """Exit code (None: killed after so many seconds of processor), the last line on stderr, seconds of processor, of
    the program's command as a checkout has it."""
    with tempfile.TemporaryFile("w+") as said:
        line = [sys.executable, "-m", "trajopt_cli.cli", *arguments]
        process = subprocess.Popen(
            line, stdout=subprocess.DEVNULL, stderr=said, cwd=checkout, start_new_session=True
        )  # fmt: skip
        until, code, seconds = monotonic() + CLOCK * patience, None, 0.0
        while True:
            pid, status, used = os.wait4(process.pid, os.WNOHANG)
            if pid:
                process.returncode = code = os.waitstatus_to_exitcode(status)
                seconds = used.ru_utime + used.ru_stime
                break
            seconds = _seconds(process.pid)
            if seconds > patience or monotonic() > until or STOPPED.is_set():
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                break
            sleep(0.2)
        said.seek(0)
        lines = [one for one in said.read().splitlines() if one.strip()]
        crash = any(one.startswith("Traceback") for one in lines)
        return code, ("Traceback: " if crash else "") + (lines[-1] if lines else ""), seconds


def _seconds(group: int) -> float:
    """Seconds of processor of a process and its children so far, those that run and those that it has waited for."""
    ticks = 0
    for place in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = place.read_text().rpartition(")")[2].split()  # from the state, the third field, on
        except OSError:  # it has ended meanwhile
            continue
        ticks += sum(map(int, fields[11:15])) if int(fields[2]) == group else 0
    return ticks / os.sysconf("SC_CLK_TCK")


def run(seed: int, folder: Path, patience: float, starts: int) -> dict[str, object] | None:
    """One program as a user would do it; what came of it, None where nobody waits for that any more."""
    made = _Writer(seed).made()
    module, out = folder / f"robust{seed}.mod", folder / f"out{seed}"
    module.write_text(made.text)
    module.with_suffix(".yaml").write_text(made.cell)
    moves = made.text.count("\nMove")
    code, said, seconds = command(["optimize", str(module), "--output", str(out)], patience)
    if STOPPED.is_set():
        return None
    row: dict[str, object] = {"seed": seed, "odd": ", ".join(made.odd), "moves": moves, "seconds": round(seconds, 1)}
    row["rail"], row["says"] = "robot: irb140_rail" in made.cell, said.replace(str(folder), "") if code else ""
    if code is None:
        row["kind"], row["says"] = "no answer", f"nothing after {patience:g} s of processor"
    elif code == 0:
        summary = json.loads((out / "summary.json").read_text())
        missed = [note for note in summary["notes"] if " failed to converge" in note or "nothing faster" in note]
        for name, one in summary["plans"].items():
            row[name], row[f"{name} bound"] = one["cycle_time_s"], one["lower_bound_s"]
        judged, word, _ = command(["verify", str(out)], patience)
        row["kind"] = "legal" if judged == 0 else "ILLEGAL"
        row["says"] = "; ".join(missed) if judged == 0 else word
        if starts:
            row["says"] = others(read_job(module), {t: float(str(row[t.value])) for t in Target}, starts, seed)
    elif code == 1 and said.startswith(str(folder)):
        row["kind"] = "infeasible"
        row["says"] = f"{row['says']} [{checked(module, said)}]"
    elif code == 2:
        row["kind"] = "refused"
    elif code == 1 and " collides." in said:
        row["kind"] = "collides"
    else:
        row["kind"] = "no plan" if code == 1 and not said.startswith("Traceback") else "crash"
    return row


def checked(module: Path, said: str) -> str:
    """What the check says of an answer no."""
    try:
        job = read_job(module)
        return too_short(job, said) if " takes " in said and " as fast as " in said else no_way(job)
    except InputError as error:
        return f"not checked: {error}"


def check_is_sound() -> None:
    """The command's answer no to a line that leaves the reach of every rail position is confirmed, with a rail and
    without; an answer no to the same line left out would be contradicted."""
    for name, eax in (("irb140_rail", "0"), ("irb140", "9E9")):
        with tempfile.TemporaryDirectory() as place:
            module = Path(place) / "no.mod"
            rail = "rail: {eax: a, stroke: [-0.2, 2.2]}\n" if name == "irb140_rail" else ""
            start = 'start: {joints: "[0, 0, 0, 0, 30, 0] deg"' + (", rail: 0}" if rail else "}")
            module.with_suffix(".yaml").write_text(f"robot: {name}\nprofile: default\n{rail}{start}\n")
            near, far = (
                f"[[{x},0,300],[0,0,1,0],[0,0,0,0],[{eax},9E9,9E9,9E9,9E9,9E9]], v300, fine, tool0;\n"
                for x in (450, 950)
            )
            said = []
            for moves in (f"MoveJ {near}MoveL {far}", f"MoveJ {near}"):
                module.write_text(f"MODULE No\nPROC main()\n{moves}ENDPROC\nENDMODULE\n")
                code, last, _ = command(["optimize", str(module), "--output", str(Path(place) / "out")], 60.0)
                said.append((code, checked(module, last)))
            assert said[0][0] == 1, said
            assert said[0][1].startswith("confirmed from"), said
            assert said[1][0] == 0, said
            assert said[1][1].startswith("CONTRADICTED"), said


def others(job: Job, found: dict[Target, float], starts: int, seed: int) -> str:
    """The best of as many narrowed cells, by target, as a difference to the plan."""
    rng, best = np.random.default_rng(seed), dict(found)
    limits, start = job.plant.limits, job.plant.start
    fixed = [np.r_[m.extax[0] / 1e3 if job.plant.robot.has_rail else [], m.q] for m in job.program.motions
             if isinstance(m, MoveAbsJ)]  # fmt: skip
    need = np.array([start, *fixed])
    for _ in range(starts):
        cut = rng.uniform(0, 1, (2, len(start))) * (rng.random(len(start)) < 0.4)
        lower = limits.lower + cut[0] * (need.min(axis=0) - limits.lower)
        upper = limits.upper - cut[1] * (limits.upper - need.max(axis=0))
        plant = replace(job.plant, limits=replace(limits, lower=lower, upper=upper))
        for target in Target:
            changes = may_change(job, Loops.KEEP).changes[target]
            try:
                plan = optimize(job.program, plant, target, bounded=False, changes=changes)
            except RuntimeError:
                continue
            if isinstance(plan, Plan):
                best[target] = min(best[target], plan.duration)
    return ", ".join(f"{t.value} {100 * (best[t] / found[t] - 1):+.2f} %" for t in Target)


def line(row: dict[str, object]) -> str:
    """A row of the table."""
    times = " ".join(f"{row[t]:10.3f}" if t in row else f"{'-':>10}" for t in ("stream", "rapid"))
    each = float(str(row["seconds"])) / max(int(str(row["moves"])), 1)
    where = "rail" if row["rail"] else "-"
    return (
        f"{row['seed']:>5} {row['kind']:10} {where:4} {row['moves']:>3} {times} {row['seconds']:>7} s {each:6.1f} "
        f" {row['odd']}  {row['says']}"
    )


def main() -> None:
    """Run the seeds; print every program, and the summary in any case: also after Ctrl-C or SIGTERM."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", default="1000:1300", help="first and behind the last, or a list with commas")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--timeout", type=float, default=300.0)
    parser.add_argument("--starts", type=int, default=0)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()
    arm_is_pins()
    check_is_sound()
    first, _, last = options.seeds.partition(":")
    seeds = range(int(first), int(last)) if last else [int(one) for one in first.split(",")]
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    rows: list[dict[str, object]] = []
    for one in (signal.SIGINT, signal.SIGTERM):
        signal.signal(one, lambda *_: STOPPED.set())
    print(f" seed kind       cell moves {'stream':>9} {'rapid':>10} {'seconds':>9} /move  odd, says")
    with tempfile.TemporaryDirectory() as place:
        folder = options.keep or Path(place)
        folder.mkdir(parents=True, exist_ok=True)
        with ThreadPoolExecutor(options.jobs) as pool:
            work = partial(run, folder=folder, patience=options.timeout, starts=options.starts)
            for row in pool.map(work, seeds):
                if row is None:
                    continue
                rows.append(row)
                print(line(row), flush=True)
                if options.json:
                    options.json.write_text(json.dumps(rows, indent=1))
    print("\n".join(summary(rows)))
    if len(rows) < len(seeds):
        sys.exit(f"stopped after {len(rows)} of {len(seeds)} programs")


def summary(rows: list[dict[str, object]]) -> Iterator[str]:
    """How many of each kind there are, and what is slow."""
    counts = Counter(str(row["kind"]) for row in rows)
    no = Counter(
        str(row["says"]).rpartition("[")[2].split()[0].rstrip("]:") for row in rows if row["kind"] == "infeasible"
    )
    yield f"{', '.join(f'{n} {kind}' for kind, n in counts.most_common()) or 'none'} of {len(rows)}"
    yield f"infeasible: {', '.join(f'{n} {word}' for word, n in no.most_common()) or 'none'}"
    if rows:
        each = {row["seed"]: float(str(row["seconds"])) / max(int(str(row["moves"])), 1) for row in rows}
        middle = float(np.median([*each.values()]))
        slow = sorted((seed for seed in each if each[seed] > SLOW * middle), key=lambda seed: -each[seed])
        yield f"seconds of processor per move: {middle:.2f} in the middle; over {SLOW:g} times that: {slow or 'none'}"


if __name__ == "__main__":
    main()
