"""What a controller makes of a sequence: what dosing promises of it, and what a simulation says of it, replayed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.law import Answer, Controller, held
from trajopt_cli.iiwa.judge.samples import ANGLES, PLACE, Poses, check_times, columns, poses_of_joints, worst, worst_row
from trajopt_cli.iiwa.judge.task_order import Order
from trajopt_cli.iiwa.judge.tolerances import (
    ARM_CAP,
    ARRIVED,
    FELT,
    FELT_SHARE,
    PERIOD,
    PROMISED,
    PUSH_KEPT,
    SIMULATED,
    SIMULATED_JOINTS,
)
from trajopt_cli.judge.findings import finding
from trajopt_cli.trajectory import Trajectory

_FORCES = ("fx [N]", "fy [N]", "fz [N]", "mx [Nm]", "my [Nm]", "mz [Nm]")
_BELIEVED, _TRUE = (tuple(f"{kind} {force}" for force in _FORCES) for kind in ("believed", "true"))
_FED = tuple(head.replace(" ", "_e ") for head in (*PLACE, *ANGLES))
SIMULATION_HEADS = (*_FED, *PLACE, *ANGLES, "deviation [m]", *_BELIEVED)
"""What every simulation has."""
_SPRINGS = (None, "spring wall", "ideal arm")
"""Worlds whose arm is an ideal one, and what it touches springs."""
_LEVEL = 0.99  # cosine between normals of one surface


def check_dosing(
    order: Order, law: Controller, u: Array, fed: Poses, plan: Poses, sections: Mapping[str, Any]
) -> Iterator[Finding]:
    """Lag, push and arrival of the arm where nothing is touched; where the task has something, forces, and the lag
    again but for where the tool touches, or has just done so. u (n, 6): the equilibrium, its angles from the start."""
    assert order.start is not None
    said, h, n, rest = sections["dosing"], order.h, len(u), law.rest
    rows, start = (held(u, rest), held(fed.q, rest)), (order.start.p, order.start.q)
    p, q = held(plan.p, rest), held(plan.q, rest)
    t = np.asarray(np.arange(n + rest) * h, dtype=np.float64)
    arm = law.answer(*rows, start, np.zeros((n + rest, 6)))
    yield from _lags(arm, p, q, t, said, np.ones(len(t)), "")
    turned = turns.logarithm(turns.product(rows[1], turns.conjugate(arm.q)))
    behind = rows[0] - arm.x
    behind[:, 3:] = turned if law.slerp else behind[:, 3:]
    K = law.stiffness(len(t))
    for key, part, stretched in (("max_lead", slice(0, 3), "m"), ("max_turn_lead", slice(3, 6), "rad")):
        if said.get(key):
            most, unit = said[key]["most"], said[key]["unit"]
            push = (behind * np.where(K > 0, 1.0 if unit == stretched else K, 0.0))[:, part]
            words = "would begin to push, if it were held, with"
            yield worst("push", "arm", np.linalg.norm(push, axis=1), most * (1 + PROMISED), unit, t, words=words)
    far = np.flatnonzero(
        (np.linalg.norm(arm.x[:, :3] - plan.p[-1], axis=1) > ARRIVED[0])
        | (turns.angle_between(arm.q, plan.q[-1]) > ARRIVED[1])
    )
    arrived = (int(far[-1]) + 1) * h if len(far) else 0.0
    told = said["feeds"][said["feed"]]["arrived_s"]
    told = float("inf") if told is None else told
    passed = abs(arrived - told) <= 1.5 * h or (told == float("inf") and arrived > t[-1])
    yield finding("arrival", "arm", arrived, told, "s", passed, bound="summary.json says", words="arrives at")
    speeds = order.caps.get("v_max")
    if speeds:
        speed = np.linalg.norm(np.diff(arm.x[:, :3], axis=0), axis=1) / h
        yield worst("arm speed", "arm", speed, max(speeds) * (1 + ARM_CAP), "m/s", t[1:], words="moves at")
    if len(law.shapes) and not law.unfelt:
        touching = law.answer(*rows, start)
        last = np.maximum.accumulate(np.where(touching.depth > 0, np.arange(len(t)), -rest - 1))
        yield from _lags(
            touching, p, q, t, said, np.where(np.arange(len(t)) - last > rest, 1.0, 0.0), " off what it touches"
        )
        yield from _forces(law, touching, plan, said.get("contact"), sections["sequence"]["pieces"], t)


def _lags(
    arm: Answer, p: Array, q: Array, t: Array, said: Mapping[str, Any], free: Array, where: str
) -> Iterator[Finding]:
    """How far the arm is from its plan p, q on free rows (n,)."""
    off = np.linalg.norm(arm.x[:, :3] - p, axis=1) * free
    most = said["max_lag_m"] * (1 + PROMISED)
    yield worst(f"lag{where}", "arm", off, most, "m", t, words="is away from the plan by")
    if said.get("max_turn_lag_rad"):
        most = said["max_turn_lag_rad"] * (1 + PROMISED)
        off = turns.angle_between(arm.q, q) * free
        yield worst(f"turn lag{where}", "arm", off, most, "rad", t, words="is turned away from the plan by")


def _forces(
    law: Controller, arm: Answer, plan: Poses, told: Mapping[str, Any] | None, pieces: list[Mapping[str, Any]], t: Array
) -> Iterator[Finding]:
    """The greatest force on the tool against the programmed one, and the mean push on legs that lie in one surface
    against what the springs press with at rest there."""
    force = np.linalg.norm(arm.force[:, :3], axis=1)
    most = (1 + PUSH_KEPT) * (told or {}).get("programmed_N", 0.0) * (1 + ARM_CAP)
    yield worst("force", "tool", force, most, "N", t, FELT, words="is pushed with")
    rest = law.at_rest(plan.p)
    for piece in pieces:
        rows = slice(piece["first"], piece["last"] + 1)
        depth, normal, wanted = rest[rows, 0], rest[rows, 1:4], float(rest[rows, 4].mean())
        if depth.min() > 0 and (normal @ normal[0]).min() > _LEVEL:
            off = abs(float(np.mean(np.sum(arm.force[rows, :3] * normal, axis=1))) - wanted)
            name, limit = f"{piece['from']} -> {piece['to']}", PUSH_KEPT * wanted + FELT
            words = "is pressed with a force that differs from that at rest by"
            yield finding("pressing", name, off, limit, "N", off <= limit, time=float(t[rows.start]), words=words)


def check_simulation(
    order: Order,
    law: Controller,
    table: Mapping[str, Array],
    u: Array,
    fed: Poses,
    path: Poses,
    said: Mapping[str, Any],
) -> Iterator[Finding]:
    """The rows of a simulation: that it was fed the sequence, its last pose held; its deviation, from what it was fed,
    or from the path that this leads it along; where the law leads with the forces that they say it felt, what is felt
    of shapes that are springs, and joints that put the tool there. u (n, 6): as of check_dosing."""
    t, n = table["t [s]"], len(table["t [s]"])
    k = np.minimum(np.arange(n), len(fed.t) - 1)
    p, p_e = columns(table, PLACE), columns(table, _FED[:3])
    yield check_times(t, order.h)
    zero = None if order.reframed or order.start is None else order.start.q
    if zero is not None:
        off = np.linalg.norm(p_e - fed.p[k], axis=1)
        yield worst_row("position fed", off, SIMULATED, "m", t, "was fed another position, by")
        off = turns.angle_between(turns.product(turns.from_angles(columns(table, _FED[3:])), zero), fed.q[k])
        yield worst_row("orientation fed", off, SIMULATED, "rad", t, "was fed another turn, by")
    target = p_e if path is fed or order.reframed else path.p[np.minimum(k, len(path.t) - 1)]
    off = np.abs(np.linalg.norm(p - target, axis=1) - table["deviation [m]"])
    yield worst_row("deviation", off, SIMULATED, "m", t, "has another deviation, by")
    if zero is None or order.start is None:
        return
    last = abs(float(t[-1]) - float(said["duration_s"]))
    yield finding("duration", "simulation", last, PERIOD, "s", last <= PERIOD, words="ends beside what is said, by")
    if not law.laws:
        return
    q, felt = turns.product(turns.from_angles(columns(table, ANGLES)), zero), columns(table, _BELIEVED)
    if not law.beyond:
        more, speed = max(0, n - len(u)), said.get("feed") == "velocity"
        arm = law.answer(held(u, more)[:n], held(fed.q, more)[:n], (order.start.p, order.start.q), felt, speed)
        off = np.linalg.norm(arm.x[:, :3] - p, axis=1)
        yield worst("law", "position", off, SIMULATED, "m", t, words="is not where the law leads, by")
        off = turns.angle_between(arm.q, q)
        yield worst("law", "orientation", off, SIMULATED, "rad", t, words="is not turned as the law has it, by")
    names, springs = order.arm.mechanism.names, said.get("world") in _SPRINGS
    for kind in (" command", "") if springs else (" command",):
        heads = tuple(f"{name}{kind} [rad]" for name in names)
        if order.X_FT is not None and all(head in table for head in heads):
            tool = poses_of_joints(order.arm, order.X_FT, Trajectory(names, t, columns(table, heads)), None, order.h)
            off = np.linalg.norm(tool.p - p, axis=1) + turns.angle_between(tool.q, q)
            words = "is not where the joints put it, by"
            yield worst("joints", "tool", off, SIMULATED_JOINTS, "m, rad", t, words=words)
    if not springs or law.unfelt or not _own_contact(said):
        return
    force, depth = law.touched(p, q)
    doubt = FELT_SHARE * np.linalg.norm(force, axis=1)
    if said.get("world") is None:
        force = 0 * force
    else:
        off = np.linalg.norm(columns(table, _TRUE) - force, axis=1)
        yield worst("true force", "tool", off, FELT, "N, Nm", t, doubt, words="is not what it touches, by")
        off = np.abs(table["depth [m]"] - depth)
        yield worst("depth", "tool", off, SIMULATED, "m", t, words="is not as deep as told, by")
    off = np.linalg.norm(felt - law.felt(force, t), axis=1)
    yield worst("believed force", "controller", off, FELT, "N, Nm", t, doubt, words="is not what it feels, by")


def unjudged(order: Order, law: Controller, table: Mapping[str, Array], said: Mapping[str, Any]) -> Iterator[str]:
    """What of a simulation check_simulation does not judge, and why."""
    if order.reframed or order.start is None:
        why = "the task changes frames during the run" if order.reframed else "the tool is the program's"
        yield f"what was fed, and what the controller does, because {why}"
        return
    yield from (f"where the controller goes, because of {one}" for one in law.beyond)
    unknown = [*law.unfelt, *([] if _own_contact(said) else ["a contact that is not the task's"])]
    unknown += [] if said.get("world") in _SPRINGS else [f"its world, {said['world']}"]
    yield from (f"forces and depths, because of {one}" for one in unknown)
    if rest := [head for head in table if head.startswith("manipulability")]:
        yield ", ".join(rest)


def _own_contact(said: Mapping[str, Any]) -> bool:
    """Whether a simulation ran into what the task itself has."""
    return said.get("contact_file", "") is None
