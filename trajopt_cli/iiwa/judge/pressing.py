"""Whether an equilibrium presses as its task asks: K (x_e - p) along the force against the wish."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.law import DAMPING, INERTIA, STIFFNESS
from trajopt_cli.iiwa.judge.path import legs
from trajopt_cli.iiwa.judge.samples import Poses, worst
from trajopt_cli.iiwa.judge.sequence import visits
from trajopt_cli.iiwa.judge.task_order import Order
from trajopt_cli.iiwa.judge.tolerances import PRESSED
from trajopt_cli.iiwa.judge.written import Written

_NEWTON = {"N": 1.0}


def check_force(order: Order, path: Poses, fed: Poses) -> Iterator[Finding]:
    """Every stop (but along the normal of a path), and every segment between two that press alike. The surface gives
    nothing, or as an obstacle does."""
    task = Written(order.file, "task file")
    if order.stops is None or len(path.t) != len(fed.t) or task.at("K") is None:
        return
    wishes = _wishes(task, order)
    if not any(force for force, _ in wishes):
        return
    found = list(visits(order, legs(order), path))
    K, D, M = (
        np.array(task.numbers(name, task.at(name, [0.0] * 6), units, 6))[:3]
        for name, units in (("K", STIFFNESS), ("D", DAMPING), ("M", INERTIA))
    )
    push = K * (fed.p - path.p)
    if task.at("force.lead"):
        v = np.diff(path.p, axis=0, append=path.p[-1:]) / order.h
        push -= D * v + M * np.diff(v, axis=0, append=v[-1:]) / order.h
    soft = [0.0, *(1 / task.number(f"contact.obstacles.{name}.stiffness", one.get("stiffness"), STIFFNESS)
                   for name, one in task.section("contact.obstacles").items())]  # fmt: skip
    told = task.at("force.by") == "wrench"
    for begin, end in pairwise(found):
        before, (F, along) = (wishes[order.stops.index(one.stop)] for one in (begin, end))
        for name, rows in ((f"{begin.stop.name} -> {end.stop.name}", slice(begin.left, end.arrived + 1)),
                           (end.stop.name, slice(end.left, end.left + 1))):  # fmt: skip
            on_way = rows.start != end.left
            if not F or not end.reached or (before != (F, along) if on_way else along == "normal"):
                continue
            u = _along(along, path.q[rows], path.p[rows])
            wanted = [(0.0 if told else F) + F * give * np.sum(u * K * u, axis=1) for give in soft]
            pressed = np.sum(push[rows] * u, axis=1)
            off = min((np.abs(pressed - one) for one in wanted), key=lambda one: float(one.max()))
            place: dict[str, Any] = {"source": end.stop.place, "words": "presses off its wish by"}
            yield worst("wished force", name, off, PRESSED * F, "N", path.t[rows], **place)


def _wishes(task: Written, order: Order) -> list[tuple[float, str]]:
    """Force [N] and direction at every stop, 0 where nothing is asked, and where it is the first."""
    assert order.stops is not None
    poses, whole = task.at("poses"), task.at("force")
    whole = whole if isinstance(whole, dict) else {"value": whole}
    own = [one.get("force") if isinstance(one, dict) else None for one in poses] if isinstance(poses, list) else []
    said = [one if isinstance(one, dict) else {} if one is None else {"value": one} for one in own]
    both = [{**whole, **one} for one in said] or [whole] * len(order.stops)
    values = [0.0 if one.get("value") is None else task.number("force", one["value"], _NEWTON) for one in both]
    out = [(value, str(one.get("along", "tool"))) for value, one in zip(values, both, strict=True)]
    out = [(0.0, "tool")] * (len(order.stops) - len(out)) + out
    return [(0.0, "tool"), *out[1:]]


def _along(name: str, q: Array, p: Array) -> Array:
    """Unit vectors (n, 3): the axis of a tool at p (n, 3), turned by q (n, 4), what of it is across the way, or an axis
    of the world."""
    z = turns.turned(q, np.array([0.0, 0.0, 1.0]))
    if name == "tool":
        return z
    if name == "normal":
        t = np.gradient(p, axis=0)
        z = z - t * np.sum(z * t, axis=1, keepdims=True) / np.maximum(np.sum(t * t, axis=1, keepdims=True), 1e-300)
        return np.asarray(z / np.linalg.norm(z, axis=1, keepdims=True))
    out = np.zeros((len(q), 3))
    out[:, "xyz".index(name[-1])] = -1.0 if name[0] == "-" else 1.0
    return out
