"""Programs from motions, without text: each motion stands on a line of its own, counted from 1."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.geometry import Array
from trajopt_cli.motion import (
    NO_EXTERNAL_AXES,
    ConfData,
    Motion,
    MoveAbsJ,
    MoveC,
    MoveExtJ,
    MoveJ,
    MoveL,
    Program,
    Source,
    Span,
    Speed,
    Tool,
    Wait,
    Written,
    Zone,
)
from trajopt_cli.problem.plant import Plant, build_plant

BENCH = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n"
RAIL = """robot: irb140_rail
rail: {eax: b, stroke: [-0.2, 2.2]}
limits: {rail: {acceleration: 1, source: "a test"}}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""
TOOL = Tool("tool0", np.eye(4))
SPEED = Speed("v100", 0.1, np.radians(500), 5.0, np.radians(1000))
FINE = Zone("fine", stop=True)
WRITTEN = Written(Span("m.mod", 0, 1))


def plant(text: str = BENCH) -> Plant:
    return build_plant(parse_cell(text, "cell.yaml"))


def program(*motions: Motion) -> Program:
    placed = [replace(motion, source=Source("m.mod", line, 5)) for line, motion in enumerate(motions, 1)]
    return Program("m", tuple(placed), {})


def _common(target: str, more: dict[str, Any]) -> dict[str, Any]:
    base = {"source": Source("m.mod", 1, 1), "written": WRITTEN, "target": target, "speed": SPEED, "zone": FINE}
    return base | {"extax": NO_EXTERNAL_AXES} | more


def _pose(X_WT: Array | None, target: str, more: dict[str, Any]) -> dict[str, Any]:
    X = np.eye(4) if X_WT is None else X_WT
    return {"X_WT": X, "conf": ConfData(0, 0, 0, 0), "tool": TOOL} | _common(target, more)


def move_j(X_WT: Array | None = None, target: str = "p", **more: Any) -> MoveJ:
    return MoveJ(**_pose(X_WT, target, more))


def move_l(X_WT: Array | None = None, target: str = "p", **more: Any) -> MoveL:
    return MoveL(**_pose(X_WT, target, more))


def move_c(X_WT: Array | None = None, target: str = "p", **more: Any) -> MoveC:
    """An arc from where the other motions end by default."""
    via, end = np.eye(4), np.eye(4)
    via[:3, 3], end[0, 3] = (0.05, 0.05, 0), 0.1
    return MoveC(X_WV=via, **_pose(end if X_WT is None else X_WT, target, more))


def move_abs_j(q: Array | None = None, target: str = "j", **more: Any) -> MoveAbsJ:
    return MoveAbsJ(q=np.zeros(6) if q is None else q, tool=TOOL, **_common(target, more))


def move_ext_j(target: str = "j", **more: Any) -> MoveExtJ:
    return MoveExtJ(**_common(target, more))


def wait(duration: float = 1.0) -> Wait:
    return Wait(source=Source("m.mod", 1, 1), written=WRITTEN, duration=duration)
