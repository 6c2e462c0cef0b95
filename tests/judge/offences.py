"""Offences of a wanted size against every promise of the judge, in files of any rate and digits.

A legal motion stays as it is and what is asked of it changes: a limit comes down, a target moves away, a wait gets
longer, until the motion is beyond by a given multiple of the least excess that the judge says it is sure to see in this
very file. How far beyond it is, is known from the motion between its rows, not from the file.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cache

import numpy as np
from heavy_cells import heavy
from legal_motion import (
    HELD_RAILS,
    A,
    Case,
    Piece,
    held_case,
    home,
    joint_move,
    judged,
    move_j,
    nudged,
    plant_with_rail,
    plant_without_rail,
    program,
    quintic,
)
from legal_random import random_case, stations, written
from scipy.ndimage import minimum_filter1d
from table_cell import CELL, PLANT, asked

from trajopt_cli.findings import Finding, Promise, Report
from trajopt_cli.geometry import Array, axis_angle, pose, rotation_about
from trajopt_cli.joint_csv import Resolution, read_csv_text
from trajopt_cli.motion import MoveAbsJ, MoveL, Program, Wait, Zone
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.kinematics import forward_acceleration
from trajopt_cli.shapes import Box, Solid
from trajopt_cli.trajectory import Trajectory

RATES = (0.004, 0.01, 0.02)
SPELLS = ("%.17g", "%.9g", "%.7g", "%.6g", "%.5f")
_FINE = 2.5e-4


@dataclass(frozen=True)
class Paper:
    """How a motion is written down: row spacing [s], spelling of numbers, with speeds or without."""

    step: float
    spell: str
    speeds: bool
    _known: dict[int, tuple[Case, tuple[Trajectory, Resolution]]] = field(default_factory=dict)

    @classmethod
    def random(cls, rng: np.random.Generator) -> Paper:
        return cls(float(rng.choice(RATES)), str(rng.choice(SPELLS)), bool(rng.integers(2)))

    def read(self, case: Case) -> tuple[Trajectory, Resolution]:
        """The file of a motion, written and read once."""
        if id(case) not in self._known:  # which nobody else has as long as the case is kept
            text = written(case.rows(step=self.step, grid_only=True), self.spell, self.speeds)
            self._known[id(case)] = case, read_csv_text(text, "a.csv")
        return self._known[id(case)][1]

    def judged(self, plant: Plant, asked: Program, case: Case) -> Report:
        return judged(asked, plant, *self.read(case), promises=True)


@dataclass(frozen=True)
class Outcome:
    """What the judge made of an offence: excess and least excess promised, and what it found."""

    excess: float
    promise: Promise
    failed: tuple[Finding, ...]
    legal_without: bool

    @property
    def found(self) -> bool:
        """Whether the check says so; where the motion is legal but for the offence, whether any does: a stop that is
        missed may show as a wait that is."""
        own = any(one.check == self.promise.check for one in self.failed)
        return own or (self.legal_without and bool(self.failed))


Change = Callable[[float], tuple[Plant, Program, Case]]  # of an excess


def promise(report: Report, check: str, subject: str, unit: str) -> Promise:
    return next(one for one in report.promises if (one.check, one.subject, one.unit) == (check, subject, unit))


def beyond(paper: Paper, key: tuple[str, str, str], change: Change, times: float) -> Outcome:
    """change, with an excess that is `times` the least one that is promised of the changed file itself."""
    excess, legal = 0.0, None
    for _ in range(8):
        plant, asked, case = change(excess)
        report = judged(asked, plant, *paper.read(case), promises=True)
        legal = report.legal if legal is None else legal
        found = promise(report, *key)
        if times * found.least * (1 - 1e-6) <= excess <= times * found.least * (1 + 1e-3):
            break
        excess = times * found.least
    failed = tuple(one for one in report.findings if not one.passed)
    return Outcome(excess, found, failed, bool(legal))


# --- motions ---------------------------------------------------------------------------------------------------------


def joint_case(rng: np.random.Generator, plant: Plant | None = None) -> tuple[Case, int]:
    """From the start to other axis values, smoothly, and one of the axes."""
    if plant is None:
        plant = plant_with_rail() if rng.integers(2) else plant_without_rail()
    way = rng.uniform(-0.8, 0.8, len(plant.start))
    if plant.robot.has_rail:
        way[0] = rng.uniform(0.2, 1.0)
    T = float(rng.uniform(1.6, 2.4))
    still = np.zeros_like(way)
    q = plant.start + way
    end = replace(home(11, float(q[0]) if plant.robot.has_rail else None), q=q[-6:])
    case = Case(plant, program(end), (quintic(plant.start, still, q, still, T),))
    return case, int(rng.integers(len(way)))


def truth(case: Case) -> Trajectory:
    return case.rows(step=_FINE, grid_only=True)


def throughout(x: Array, lasting: float | None) -> float:
    """The greatest value that x, every _FINE seconds, has throughout a stretch that lasts so long."""
    n = 1 if lasting is None else int(np.ceil(lasting / _FINE)) + 1
    return float(minimum_filter1d(x, n, mode="constant", cval=-np.inf).max()) if n < len(x) else -np.inf


def with_limit(plant: Plant, field: str, j: int, value: float, **more: object) -> Plant:
    values = getattr(plant.limits, field)
    values = np.full(len(plant.limits.names), np.inf) if values is None else np.array(values)
    values[j] = value
    return replace(plant, limits=replace(plant.limits, **{field: values}, **more))


def of_axis(check: str, rng: np.random.Generator, times: float) -> Outcome | None:
    case, j = joint_case(rng)
    name, paper, rows = case.plant.limits.names[j], Paper.random(rng), truth(case)
    unit = "m" if name == "rail" else "rad"
    a = np.gradient(rows.qd[:, j], rows.t)
    field, x, unit = {
        "joint position": ("upper", rows.q[:, j], unit),
        "joint speed": ("velocity", rows.qd[:, j], unit + "/s"),
        "joint acceleration": ("acceleration", a, unit + "/s2"),
        "joint jerk": ("jerk", np.gradient(a, rows.t), unit + "/s3"),
    }[check]
    if field == "upper" and rows.q[-1, j] >= rows.q[:, j].max() - 1e-9:  # a peak between rows, not the end
        case = case_with_peak(case, j, rng)
        rows = truth(case)
        x = rows.q[:, j]
    lasting: list[float | None] = [None]

    def change(excess: float) -> tuple[Plant, Program, Case]:
        most = max(throughout(x, lasting[0]), throughout(-x, lasting[0]) if field != "upper" else -np.inf)
        limit = most - excess if field == "upper" else max(most - excess, 1e-3)
        more = {"jerk_binds": True} if field == "jerk" else {}
        return with_limit(case.plant, field, j, limit, **more), case.program, case

    for _ in range(4):  # how long it must last depends on the limit
        found = beyond(paper, (check, name, unit), change, times)
        if found.promise.lasting == lasting[0] or field == "upper":
            most = max(throughout(x, lasting[0]), throughout(-x, lasting[0]))
            return found if field == "upper" or 0 < found.excess < most - 1e-3 else None
        lasting[0] = found.promise.lasting
        if throughout(np.abs(x), lasting[0]) <= 0:
            return None
    return None


def case_with_peak(case: Case, j: int, rng: np.random.Generator) -> Case:
    """The axis goes up and comes back, at its limit of acceleration around the peak."""
    plant, piece = case.plant, case.pieces[0]
    top, at_peak = float(plant.limits.acceleration[j]), float(rng.uniform(0.3, 0.7)) * piece.T

    def at(t: Array) -> tuple[Array, Array]:
        q, qd = piece.at(t)
        u = np.clip((t - at_peak) / (0.4 * piece.T), -1, 1)
        # cos^2 bump whose curvature at the top is that of the limit
        height = top * (0.8 * piece.T / np.pi) ** 2 / 2 / 4
        q[:, j] = plant.start[j] + height * np.cos(np.pi * u / 2) ** 2
        qd[:, j] = -height * np.pi / 2 * np.sin(np.pi * u) / (0.4 * piece.T) * (np.abs(u) < 1)
        return q, qd

    target = replace(case.program.motions[0])
    assert isinstance(target, MoveAbsJ)
    q_end = at(np.array([piece.T]))[0][0]
    end = replace(home(11, float(q_end[0]) if plant.robot.has_rail else None), q=q_end[-6:])
    return Case(plant, program(end), (Piece(piece.T, at),))


def tool_motion(case: Case, rows: Trajectory) -> tuple[Array, Array, Array]:
    """TCP velocity, acceleration (m, 3) and angular velocity (m, 3)."""
    J = case.plant.robot.jacobian(rows.q)
    V = (J @ rows.qd[..., None])[..., 0]
    qdd = np.gradient(rows.qd, rows.t, axis=0)
    a = forward_acceleration(case.plant.robot, rows.q, rows.qd, qdd)[:, :3]
    return V[:, :3], a, V[:, 3:]


def of_tool(check: str, rng: np.random.Generator, times: float) -> Outcome | None:
    case, _ = joint_case(rng)
    paper, rows = Paper.random(rng), truth(case)
    velocity, acceleration, _ = tool_motion(case, rows)
    lasting: list[float | None] = [None]

    def most() -> float:
        if check == "TCP speed":
            return throughout(np.linalg.norm(velocity, axis=1), lasting[0])
        i = int(np.argmax(np.linalg.norm(acceleration, axis=1)))
        u = acceleration[i] / np.linalg.norm(acceleration[i])
        return throughout(acceleration @ u, lasting[0])

    def change(excess: float) -> tuple[Plant, Program, Case]:
        limit = most() - excess
        caps = replace(case.plant.tcp, **{"speed" if check == "TCP speed" else "acceleration": limit})
        if check == "TCP speed":  # how far chords are from arcs follows from the acceleration that there is
            caps = replace(caps, acceleration=float(np.linalg.norm(acceleration, axis=1).max()))
        return replace(case.plant, tcp=caps), case.program, case

    key = (check, "TCP", "m/s") if check == "TCP speed" else (check, "TCP, one way", "m/s2")
    for _ in range(5):
        if most() <= 0.02:
            return None
        found = beyond(paper, key, change, times)
        if found.promise.lasting == lasting[0]:
            return found
        lasting[0] = found.promise.lasting
    return None


def station(rng: np.random.Generator, rail: bool | None = None) -> Case:
    """One of the random cases with one station that has a wait."""
    while True:
        seed = int(rng.integers(10**6))
        if rail is not None and bool(seed % 2) != rail:
            continue
        if stations(seed) == 1 and len((case := random_case(seed)).pieces) == 5:
            return case


def of_turning(rng: np.random.Generator, times: float) -> Outcome | None:
    """The line of motion 12 turns faster than its v_ori allows, away from its ends."""
    case = station(rng)
    paper, rows = Paper.random(rng), truth(case)
    begin, end = case.starts[1], case.starts[2]
    inside = (rows.t > begin + 3 * paper.step) & (rows.t < end - 3 * paper.step)
    turning = np.linalg.norm(tool_motion(case, rows)[2], axis=1)
    x = np.where(inside, turning, -1.0)
    lasting: list[float | None] = [None]

    def change(excess: float) -> tuple[Plant, Program, Case]:
        limit = throughout(x, lasting[0]) - excess
        motions = list(case.program.motions)
        motions = [replace(one, speed=replace(one.speed, v_ori=limit)) if hasattr(one, "speed") else one
                   for one in motions]  # fmt: skip
        return case.plant, program(*motions), case

    for _ in range(5):
        if throughout(x, lasting[0]) <= 0.05:
            return None
        found = beyond(paper, ("programmed reorientation", "TCP", "rad/s"), change, times)
        if found.excess > 0.9 * throughout(x, lasting[0]):
            return None
        if found.promise.lasting == lasting[0]:
            return found
        lasting[0] = found.promise.lasting
    return None


def of_path(check: str, rng: np.random.Generator, times: float) -> Outcome | None:
    case = station(rng)
    paper, piece = Paper.random(rng), case.pieces[1]
    if 8 * paper.step > piece.T:
        return None
    chord = axis_angle_of(case)
    u = rng.normal(size=3)
    u -= u @ chord[0] * chord[0]
    u /= np.linalg.norm(u)
    twist = np.r_[u, np.zeros(3)] if check == "path deviation" else np.r_[np.zeros(3), u]
    if check == "path rotation":  # about an axis that the slerp does not turn about
        twist = np.r_[np.zeros(3), 1.0, 0.0, 0.0] if rng.integers(2) else np.r_[np.zeros(3), 0.0, 1.0, 0.0]
    share = np.sin(np.pi * (0.5 + min(1.5 * paper.step / piece.T, 0.4))) ** 2

    def change(excess: float) -> tuple[Plant, Program, Case]:
        return case.plant, case.program, case.swap(p1=nudged(case.plant, piece, twist, excess / share * 1.0005))

    unit = "m" if check == "path deviation" else "rad"
    return beyond(paper, (check, "TCP", unit), change, times)


def axis_angle_of(case: Case) -> tuple[Array, Array]:
    """Unit chord of the line of motion 12, and the axis that it turns about."""
    X_0, X_1 = (case.program.motions[k].X_WT for k in (0, 1))
    way = X_1[:3, 3] - X_0[:3, 3]
    return way / np.linalg.norm(way), X_0[:3, :3] @ axis_angle(X_0[:3, :3].T @ X_1[:3, :3])[0]


def of_stop(unit: str, rng: np.random.Generator, times: float) -> Outcome | None:
    """The target of motion 12 is elsewhere: aside of the line that leads there and back."""
    case = station(rng)
    paper, move = Paper.random(rng), case.program.motions[1]
    assert isinstance(move, MoveL)
    chord, _ = axis_angle_of(case)
    u = np.cross(chord, rng.normal(size=3))
    u /= np.linalg.norm(u)

    def change(excess: float) -> tuple[Plant, Program, Case]:
        X = move.X_WT
        if unit == "m":
            X = pose(X[:3, :3], X[:3, 3] + excess * u)
        else:
            X = pose(rotation_about([np.cos(turn), np.sin(turn), 0.0], excess) @ X[:3, :3], X[:3, 3])
        motions = list(case.program.motions)
        motions[1] = replace(move, X_WT=X)
        return case.plant, program(*motions), case

    turn = float(rng.uniform(0, np.pi))
    return beyond(paper, ("stop reached", "TCP" if unit == "m" else "tool", unit), change, times)


def of_rest(rng: np.random.Generator, times: float) -> Outcome | None:
    """A joint move goes through a stop at speed. How fast the tool is there is set by how fast the motion is played."""
    plant = plant_without_rail()
    q_1 = plant.start + rng.uniform(-1, 1, 6) * [0.9, 0.3, 0.3, 0.2, 0.3, 0.3]
    paper, share = Paper.random(rng), float(rng.uniform(0.4, 0.6))
    base = joint_move(plant, plant.start, q_1)
    t_mid = share * base.T
    X_mid = plant.robot.forward(base.at(np.array([t_mid]))[0])[0]
    end = replace(home(12, None), q=q_1)
    asked = program(move_j(11, "p_mid", X_mid), end)
    fine = np.linspace(0, base.T, 4000)
    q, qd = base.at(fine)
    speed = np.linalg.norm((plant.robot.jacobian(q) @ qd[..., None])[..., 0][:, :3], axis=1)

    reached = [False]

    def change(excess: float) -> tuple[Plant, Program, Case]:
        factor = 1.0
        for _ in range(30):  # slower, until the least speed within two spacings of the point is the excess
            near = np.abs(fine - t_mid) <= 2 * paper.step * factor
            least = max(float(speed[near].min()) * factor, 1e-3)
            factor = min(max(factor * max(excess, 0.05) / least, 0.01), 4.0)
        reached.append(least >= excess * (1 - 1e-6))
        T = base.T / factor

        def at(t: Array) -> tuple[Array, Array]:
            q, qd = base.at(np.minimum(t * factor, base.T))
            return q, qd * factor

        return plant, asked, Case(plant, asked, (Piece(T, at),))

    found = beyond(paper, ("stop rest", "TCP", "m/s"), change, times)
    if not reached[-1]:  # no motion of this arm is as fast for so long
        return None
    return replace(found, legal_without=True)  # at rest there, it would be


def of_fly_by(rng: np.random.Generator, times: float) -> Outcome | None:
    """A joint move passes beside a point by more than its zone."""
    plant = plant_without_rail()
    q_1 = plant.start + rng.uniform(-1, 1, 6) * [0.9, 0.3, 0.3, 0.2, 0.3, 0.3]
    paper = Paper.random(rng)
    base = joint_move(plant, plant.start, q_1)
    fine = plant.robot.forward(base.at(np.linspace(0, base.T, 20000))[0])
    k = int(rng.uniform(0.3, 0.7) * 20000)
    tangent = fine[k + 1, :3, 3] - fine[k - 1, :3, 3]
    u = np.cross(tangent, rng.normal(size=3))
    P = fine[k, :3, 3] + u / np.linalg.norm(u) * float(rng.uniform(0.005, 0.02))
    nearest = float(np.linalg.norm(fine[:, :3, 3] - P, axis=1).min())
    end = replace(home(12, None), q=q_1)

    def change(excess: float) -> tuple[Plant, Program, Case]:
        radius = nearest - excess
        zone = Zone("z", False, radius, radius, radius)
        asked = program(replace(move_j(11, "p_mid", pose(fine[k, :3, :3], P)), zone=zone), end)
        return plant, asked, Case(plant, asked, (base,))

    found = beyond(paper, ("fly-by passed", "TCP", "m"), change, times)
    return found if found.excess < nearest else None


def of_rail(rng: np.random.Generator, times: float) -> Outcome | None:
    """The target lies beside all places where the rail is while the tool is near the stop."""
    case = station(rng, rail=True)
    paper, move, rows = Paper.random(rng), case.program.motions[1], truth(case)
    sign = int(rng.choice([-1, 1]))
    fixed = replace(case.plant, rail_fixed=True)
    report = paper.judged(fixed, case.program, case)
    first, last = there(case, 2, promise(report, "stop reached", "TCP", "m").least)
    tau = (promise(report, "rail target", "rail", "m").lasting or 0.0) / 2
    beside = rows.q[(rows.t >= first - tau - _FINE) & (rows.t <= last + tau + _FINE), 0]
    edge = float(beside.max() if sign > 0 else beside.min())

    def change(excess: float) -> tuple[Plant, Program, Case]:
        motions = list(case.program.motions)
        motions[1] = replace(move, extax=((edge + sign * excess) * 1e3, *move.extax[1:]))
        return fixed, program(*motions), case

    return beyond(paper, ("rail target", "rail", "m"), change, times)


def of_held(rng: np.random.Generator, times: float) -> Outcome | None:
    """The rail goes away and comes back in a wait that holds it."""
    paper, T = Paper.random(rng), float(rng.uniform(0.4, 0.7))
    base = held_case()
    motions = list(base.program.motions)
    motions[2] = replace(motions[2], duration=T)
    # the spread is taken over the rows in the middle of the sway
    share = np.sin(np.pi * (0.5 + min(1.5 * paper.step / T, 0.4))) ** 2

    def change(excess: float) -> tuple[Plant, Program, Case]:
        from legal_motion import swayed

        case = base.swap(p2=swayed(base.plant, A, HELD_RAILS[0], T, excess / share * 1.0005))
        return base.plant, program(*motions), case

    return beyond(paper, ("way while held", "rail", "m"), change, times)


def there(case: Case, k: int, within: float) -> tuple[float, float]:
    """From when to when the TCP is so near to where piece k rests, s."""
    rows = truth(case)
    begin = case.starts[k]
    X = case.plant.robot.forward(rows.q)
    P = case.plant.robot.forward(case.pieces[k].at(np.zeros(1))[0])[0]
    far = np.linalg.norm(X[:, :3, 3] - P[:3, 3], axis=1) > within
    i = int(np.searchsorted(rows.t, begin + 0.5 * case.pieces[k].T))
    first = i - int(np.argmax(far[: i + 1][::-1])) if far[: i + 1].any() else 0
    last = i + int(np.argmax(far[i:])) if far[i:].any() else len(far) - 1
    return float(rows.t[first]), float(rows.t[last])


class _OnTable:
    """The motion of CELL, its table's columns among the others."""

    @staticmethod
    @cache
    def rows(**more: object) -> Trajectory:
        return CELL.rows(**more).whole


ON_TABLE = _OnTable()


def of_table(check: str, rng: np.random.Generator, times: float) -> Outcome | None:
    """A limit of eax_b comes down; or it stands elsewhere than the program says while eax_c turns back."""
    paper, unit = Paper.random(rng), {"position": "rad", "speed": "rad/s", "acceleration": "rad/s2"}[check]
    t = np.arange(0.0, CELL.case.starts[-1], _FINE)
    v = CELL.tables(t).qd[:, 0]
    x = {"speed": v, "acceleration": np.gradient(v, t), "position": v}[check]
    lasting: list[float | None] = [None]

    def change(excess: float) -> tuple[Plant, Program, Case]:
        if check == "position":
            start = CELL.program.motions[0].units[0].start
            first = CELL.program.motions[0]
            moved = replace(first, units=(first.units[0]._replace(start=start + excess),))
            return PLANT, program(moved, *CELL.program.motions[1:]), ON_TABLE
        most = max(throughout(x, lasting[0]), throughout(-x, lasting[0]))
        field = "velocity" if check == "speed" else "acceleration"
        return PLANT, asked(**{field: most - excess}), ON_TABLE

    for _ in range(5):
        if max(throughout(x, lasting[0]), throughout(-x, lasting[0])) <= 0.05:
            return None
        found = beyond(paper, (f"positioner {check}", "eax_b", unit), change, times)
        if found.promise.lasting == lasting[0]:
            return found
        lasting[0] = found.promise.lasting
    return None


def waiting(rng: np.random.Generator) -> tuple[Case, Paper]:
    case = station(rng)
    while not (isinstance(case.program.motions[2], Wait) and case.program.motions[2].duration >= 0.2):
        case = station(rng)
    return case, Paper.random(rng)


def of_dwell(rng: np.random.Generator, times: float) -> Outcome | None:
    case, paper = waiting(rng)
    k = 2
    doubt = 0.0

    def change(excess: float) -> tuple[Plant, Program, Case]:
        first, last = there(case, k, 1e-6 + doubt)
        motions = list(case.program.motions)
        motions[2] = replace(motions[2], duration=last - first + excess)
        return case.plant, program(*motions), case

    report = paper.judged(case.plant, case.program, case)
    doubt = promise(report, "path deviation", "TCP", "m").least
    return beyond(paper, ("dwell length", "TCP", "s"), change, times)


def of_duration(rng: np.random.Generator, times: float) -> Outcome | None:
    r"""A line with \T takes longer than that."""
    case, paper = waiting(rng)
    report = paper.judged(case.plant, case.program, case)
    near = promise(report, "stop reached", "TCP", "m").least
    leaves = there(case.swap(), 1, near)[0]
    rows = truth(case)
    X = case.plant.robot.forward(rows.q)
    P = case.program.motions[0].X_WT[:3, 3]
    around = (rows.t > case.starts[1] - 0.1) & (rows.t < case.starts[2])
    at_start = rows.t[around & (np.linalg.norm(X[:, :3, 3] - P, axis=1) <= near)]
    leaves = float(at_start.max())
    arrives = there(case, 2, near)[0]

    def change(excess: float) -> tuple[Plant, Program, Case]:
        motions = list(case.program.motions)
        motions[1] = replace(motions[1], duration=max(arrives - leaves - excess, 1e-3))
        return case.plant, program(*motions), case

    found = beyond(paper, ("duration", "move, positioner", "s"), change, times)
    return found if found.excess < arrives - leaves - 2e-3 else None


def of_clearance(rng: np.random.Generator, times: float) -> Outcome | None:
    case, _ = joint_case(rng)
    paper = Paper.random(rng)
    centre = rng.uniform([-0.6, -0.6, 0.0], [0.6, 0.6, 1.2])
    box = Solid(Box("box", np.full(3, 0.05), pose(np.eye(3), centre)))
    plant = replace(case.plant, obstacles=(box,), clearance=0.0)
    exact = judged(case.program, plant, case.rows())
    nearest = next((one.value for one in exact.findings if one.check == "clearance"), None)
    if nearest is None or nearest < 0.03:
        return None

    def change(excess: float) -> tuple[Plant, Program, Case]:
        return replace(plant, clearance=nearest + excess), case.program, case

    return beyond(paper, ("clearance", "robot", "m"), change, times)


def of_torque(rng: np.random.Generator, times: float) -> Outcome | None:
    case, j = joint_case(rng, heavy())
    name, paper, rows = case.plant.limits.names[j], Paper.random(rng), truth(case)
    from trajopt_cli.judge.mechanism import Forces, mechanism_of

    forces = Forces(mechanism_of(case.plant), case.plant.robot.rotor, [])
    every = slice(None, None, 8)
    a = np.gradient(rows.qd, rows.t, axis=0)
    torque = np.interp(rows.t, rows.t[every], forces.torques(rows.q[every], rows.qd[every], a[every])[:, j])
    lasting = 3 * paper.step
    most = max(throughout(torque, lasting), throughout(-torque, lasting))

    def change(excess: float) -> tuple[Plant, Program, Case]:
        return with_limit(case.plant, "torque", j, max(most - excess, 1e-3), torque_binds=True), case.program, case

    unit = "N" if name == "rail" else "Nm"
    found = beyond(paper, ("joint torque", name, unit), change, times)
    return found if found.excess < most else None


OFFENCES: dict[str, Callable[[np.random.Generator, float], Outcome | None]] = {
    **{
        check: lambda rng, times, check=check: of_axis(check, rng, times)
        for check in ("joint position", "joint speed", "joint acceleration", "joint jerk")
    },
    "joint torque": of_torque,
    "TCP speed": lambda rng, times: of_tool("TCP speed", rng, times),
    "TCP acceleration": lambda rng, times: of_tool("TCP acceleration", rng, times),
    "programmed reorientation": of_turning,
    "path deviation": lambda rng, times: of_path("path deviation", rng, times),
    "path rotation": lambda rng, times: of_path("path rotation", rng, times),
    "stop reached, m": lambda rng, times: of_stop("m", rng, times),
    "stop reached, rad": lambda rng, times: of_stop("rad", rng, times),
    "stop rest": of_rest,
    "fly-by passed": of_fly_by,
    "rail target": of_rail,
    "way while held": of_held,
    "dwell length": of_dwell,
    "duration": of_duration,
    "clearance": of_clearance,
    "positioner position": lambda rng, times: of_table("position", rng, times),
    "positioner speed": lambda rng, times: of_table("speed", rng, times),
    "positioner acceleration": lambda rng, times: of_table("acceleration", rng, times),
}
"""By the promise: an offence of so many times the least excess; None where the motion drawn has no room for it."""
