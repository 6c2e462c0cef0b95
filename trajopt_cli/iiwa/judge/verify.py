"""verify_folder(), verify_joints(): results of `trajopt iiwa`, or anybody's joints of an arm, against their task."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.findings import Finding, Report
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.answer import SIMULATION_HEADS, check_dosing, check_simulation, unjudged
from trajopt_cli.iiwa.judge.joints import check_between, check_follows, check_limits, check_posture
from trajopt_cli.iiwa.judge.law import Controller, read_controller
from trajopt_cli.iiwa.judge.pressing import check_force
from trajopt_cli.iiwa.judge.samples import (
    ANGLES,
    PLACE,
    Poses,
    check_times,
    columns,
    poses_of_joints,
    printed,
    read_table,
    unit,
    worst_row,
)
from trajopt_cli.iiwa.judge.sequence import check_sequence
from trajopt_cli.iiwa.judge.task_order import FramePose, JudgedArm, Order, arm_frame, read_arm, read_order
from trajopt_cli.iiwa.judge.tolerances import EXACT, PERIOD, ROUNDING, START
from trajopt_cli.joint_csv import Resolution, check_reach, read_csv_text
from trajopt_cli.judge.findings import finding
from trajopt_cli.runs import SUMMARY
from trajopt_cli.runs.folder import TASK, ResultsFolder, read_bytes, read_run
from trajopt_cli.runs.record import RunRecord
from trajopt_cli.trajectory import Trajectory

_FED = ("equilibrium.csv", "equilibrium_quaternion.csv")
_LED = ("plan.csv", "plan_quaternion.csv")
"""Where the arm should be, in folders whose equilibrium leads it there."""
JOINTS_FILE, SIMULATION_FILE = "joints.csv", "simulation.csv"
_QUATERNION = ("qw [1]", "qx [1]", "qy [1]", "qz [1]")
_LOCKED = 0.05  # cos beta under which three angles may swing from row to row


class _Record(RunRecord[dict[str, Any]]):
    """run.json of trajopt iiwa, as far as every folder has it."""

    KIND: ClassVar[str] = TASK


@dataclass(frozen=True)
class Judged:
    """The judge's word by file, and what was not checked, one line each."""

    reports: dict[str, Report]
    unchecked: tuple[str, ...]


@of_kind(ErrorKind.RESULTS)
def verify_folder(folder: Path) -> Judged:
    """Judge the sequence of a folder of `trajopt iiwa` against the task in it, its joints against the sequence, and
    what a simulation was fed. Raises InputError for a folder that is none, or cannot be read.
    """
    run = read_run(folder, _Record, (SUMMARY, *_FED), judged=(*_FED, *_LED, JOINTS_FILE, SIMULATION_FILE))
    if run.record.inputs.task is None:
        raise InputError("inputs.task: is missing; make the folder again", file=str(folder / "run.json"))
    sections, program = run.sections(), run.record.inputs.program
    said = _section(sections, "sequence", folder)
    fed = path = _quaternion_file(run, _FED[1])
    way = _FED
    if _LED[0] in run.contents:
        path, way = _quaternion_file(run, _LED[1]), _LED
    first = FramePose(path.p[0], path.q[0])
    place = None if program is None else str(folder / program)
    order = read_order(str(folder / run.record.inputs.task), place, lambda *_: first)
    fed = replace(fed, period=order.h)
    path = replace(path, period=order.h) if way is _LED else fed
    unchecked = list(order.unchecked)
    zero = None if order.start is None else order.start.q
    if said.get("angles") == "absolute":
        zero = np.array([1.0, 0.0, 0.0, 0.0])
    if zero is None:
        unchecked.append(f"{folder / _FED[0]}: its angles, because they count from the program's tool")
    found: dict[str, list[Finding]] = {}
    law = _controller(order, said)
    tables = {name: _table(run, name, (*PLACE, *ANGLES)) for name in {_FED[0], way[0]}}
    u = _equilibrium(tables[_FED[0]], fed, order, said)
    if way is _LED:
        unchecked.append(f"{folder / _FED[0]}: its way and speeds, because it leads the arm along {_LED[0]}")
        kept: Iterator[Finding] = iter(())
        if "dosing" in sections and order.start is not None and not law.beyond:
            kept = check_dosing(order, law, u, fed, path, sections)
            if len(law.shapes) and law.unfelt:
                unchecked.append(f"{folder / _FED[0]}: forces, because of {' and '.join(law.unfelt)}")
        elif "dosing" in sections:
            why = " and ".join(law.beyond) or "the program's tool"
            unchecked.append(f"{folder / _FED[0]}: lag and push, because of {why}")
        found = {
            _FED[0]: [*_angle_file(run, _FED[0], tables, fed, zero), *kept],
            _FED[1]: [*_rows(fed, said.get("rows"), order), *check_force(order, path, fed)],
        }
    found[way[0]] = [*_angle_file(run, way[0], tables, path, zero)]
    of_path = check_sequence(order, path, retimed="dosing" in sections)
    found[way[1]] = [*_rows(path, said.get("rows"), order), *of_path]
    if JOINTS_FILE in run.contents:
        if order.X_FT is None:
            unchecked.append(f"{folder / JOINTS_FILE}: the tool's poses, because the tool is the program's")
        found[JOINTS_FILE] = [*_joint_file(run, order, fed, sections)]
    if SIMULATION_FILE in run.contents:
        ran = _section(sections, "simulation", folder)
        law, table = _controller(order, said, ran.get("integration")), _table(run, SIMULATION_FILE, SIMULATION_HEADS)
        found[SIMULATION_FILE] = [*check_simulation(order, law, table, u, fed, path, ran)]
        unchecked += (f"{folder / SIMULATION_FILE}: {what}" for what in unjudged(order, law, table, ran))
    return Judged({name: Report(tuple(one)) for name, one in found.items()}, tuple(unchecked))


@of_kind(ErrorKind.RESULTS)
def verify_joints(path: Path, task: Path | None, robot: str | None = None) -> Judged:
    """Judge a file of joints that anybody wrote: the limits of its arm, a robot's by name or the task's; with a task
    also way, caps, dwells and posture. Raises InputError for a file that cannot be read or is another robot's.
    """
    rows, resolution = read_csv_text(read_bytes(path).decode("utf-8", "replace"), str(path))
    if task is None:
        arm = read_arm(robot or "iiwa7", "default")
        _check_names(rows, arm, path, resolution)
        return Judged(
            {path.name: Report(tuple(check_limits(arm, rows, resolution)))}, ("no task is given: the tool's way",)
        )

    def first(X_FT: FramePose, arm: JudgedArm) -> FramePose:
        _check_names(rows, arm, path, resolution)
        return X_FT.inside(arm_frame(arm.mechanism, rows.q[0]))

    order = read_order(str(task), first=first)
    _check_names(rows, order.arm, path, resolution)
    found, unchecked = [*check_limits(order.arm, rows, resolution)], list(order.unchecked)
    if order.X_FT is None:
        unchecked.append(f"{path}: the tool's way, because the tool is the program's")
    else:
        tool = poses_of_joints(order.arm, order.X_FT, rows, resolution, order.h)
        found += check_sequence(order, tool, exact=False)
        found += check_posture(order, rows, None, _begins_at_start(order, tool))
    return Judged({path.name: Report(tuple(found))}, tuple(unchecked))


def _check_names(rows: Trajectory, arm: JudgedArm, path: Path, resolution: Resolution) -> None:
    if rows.names != arm.mechanism.names:
        wanted = ", ".join(arm.mechanism.names)
        raise InputError(f"the file's axes are {', '.join(rows.names)}; the robot's are {wanted}", file=str(path))
    any_speed = np.full_like(arm.velocity, np.inf)  # a jump within a row is for the judge to tell
    check_reach(rows, arm.lower, arm.upper, any_speed, str(path), resolution.lines)


def _quaternion_file(run: ResultsFolder[_Record], name: str) -> Poses:
    """The poses of a file; on no grid yet."""
    table = _table(run, name, (*PLACE, *_QUATERNION))
    t = table["t [s]"]
    q = unit(columns(table, _QUATERNION), str(run.folder / name))
    p, share = columns(table, PLACE), printed(run.text(name))
    rounding = np.maximum(share * np.linalg.norm(p, axis=1), ROUNDING)
    return Poses(t, p, q, rounding, np.full(len(t), max(2 * share, ROUNDING)), float("nan"))


def _section(sections: dict[str, Any], name: str, folder: Path) -> dict[str, Any]:
    found = sections.get(name)
    if not isinstance(found, dict):
        raise InputError(f"has no section '{name}'; make the folder again", file=str(folder / SUMMARY))
    return found


def _table(run: ResultsFolder[_Record], name: str, heads: tuple[str, ...]) -> dict[str, Array]:
    return read_table(run.text(name), str(run.folder / name), ("t [s]", *heads))


def _rows(rows: Poses, reported: Any, order: Order) -> Iterator[Finding]:
    """A row every period from 0 on, as many as summary.json says."""
    yield check_times(rows.t, order.h)
    count = float(reported) if isinstance(reported, int) else float("nan")
    same = len(rows.t) == reported
    yield finding("rows", "sequence", len(rows.t), count, "rows", same, bound="summary.json says", words="has")


def _angle_file(
    run: ResultsFolder[_Record], name: str, tables: dict[str, dict[str, Array]], wanted: Poses, zero: Array | None
) -> Iterator[Finding]:
    """The file with angles against the one with quaternions: the same rows; and angles without jumps."""
    table = tables[name]
    t, p, angles = table["t [s]"], columns(table, PLACE), columns(table, ANGLES)
    same = len(t) == len(wanted.t)
    yield finding("rows", "angles", len(t), len(wanted.t), "rows", same, bound="quaternions have", words="have")
    if not same:
        return
    share = printed(run.text(name))
    off_p, off_q = share + float(wanted.off_p.max()), 4 * share + float(wanted.off_q.max())
    if not share and off_p <= ROUNDING:
        off_p = off_q = 0.0
    off = np.abs(p - wanted.p).max(axis=1)
    offs = [("period", np.abs(t - wanted.t), PERIOD, "s"), ("position", off, EXACT + off_p, "m")]
    if zero is not None:
        q = turns.product(turns.from_angles(angles), zero)
        offs.append(("angles", turns.angle_between(q, wanted.q), 10 * EXACT + off_q, "rad"))
    for check, off, limit, kind in offs:
        yield worst_row(check, off, limit, kind, t, f"has another {check} than in quaternions, by")
    # a quarter turn is no step of any sequence; near the lock two angles swing for one small turn
    free = np.minimum(np.abs(np.cos(angles[:-1, 1])), np.abs(np.cos(angles[1:, 1]))) > _LOCKED
    jump = np.where(free, np.abs(np.diff(angles, axis=0)).max(axis=1), 0.0)
    yield worst_row("angle jump", np.r_[0.0, jump], np.pi / 2, "rad", t, "jumps from the row before by")


def _joint_file(
    run: ResultsFolder[_Record], order: Order, wanted: Poses, sections: dict[str, Any]
) -> Iterator[Finding]:
    rows, resolution = read_csv_text(run.text(JOINTS_FILE), str(run.folder / JOINTS_FILE))
    _check_names(rows, order.arm, run.folder / JOINTS_FILE, resolution)
    same = len(rows.t) == len(wanted.t)
    yield finding("rows", "joints", len(rows.t), len(wanted.t), "rows", same, bound="the sequence has", words="have")
    yield from check_limits(order.arm, rows, resolution)
    begins = False
    if same:
        yield worst_row("period", np.abs(rows.t - wanted.t), PERIOD, "s", rows.t, "is off the sequence in time by")
    if order.X_FT is not None:
        tool = poses_of_joints(order.arm, order.X_FT, rows, resolution, order.h)
        begins = _begins_at_start(order, tool)
        if same:
            yield from check_follows(tool, wanted)
        middle = Trajectory(rows.names, (rows.t[:-1] + rows.t[1:]) / 2, (rows.q[:-1] + rows.q[1:]) / 2)
        yield from check_between(poses_of_joints(order.arm, order.X_FT, middle, None, order.h), tool)
    said = _section(sections, "joints", run.folder).get("arm_angle", {})
    reported = (float(said["least_rad"]), float(said["greatest_rad"])) if "least_rad" in said else None
    yield from check_posture(order, rows, reported, begins)


def _begins_at_start(order: Order, tool: Poses) -> bool:
    """Whether the first row's pose is the tool's at the start's joints."""
    if order.start is None or order.driven:
        return False
    turned = float(turns.angle_between(tool.q[0], order.start.q))
    return bool(np.linalg.norm(tool.p[0] - order.start.p) <= START and turned <= START)


def _controller(order: Order, said: dict[str, Any], integration: str | None = None) -> Controller:
    """The task's controller, its changes at the rows at which the sequence arrives at their poses."""
    pieces = said.get("pieces", [])
    rows = {piece["to"]: piece["last"] for piece in pieces if not piece["dwell"]}
    rows |= {piece["from"]: 0 for piece in pieces[:1]}
    return read_controller(order.file, order.h, rows, integration)


def _equilibrium(table: dict[str, Array], fed: Poses, order: Order, said: dict[str, Any]) -> Array:
    """What the controller is fed (n, 6): position and angles from the start."""
    if order.start is None or said.get("angles") == "relative":
        angles = columns(table, ANGLES)[: len(fed.p)]
        return np.column_stack([fed.p, np.pad(angles, ((0, len(fed.p) - len(angles)), (0, 0)), mode="edge")])
    q = turns.product(fed.q, turns.conjugate(order.start.q))
    return np.column_stack([fed.p, np.unwrap(turns.to_angles(q), axis=0)])
