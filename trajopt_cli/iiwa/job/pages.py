"""report.html of `trajopt iiwa simulate` and `dose`, made from what the commands found."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.iiwa.controller.lag import deviation, turn_deviation
from trajopt_cli.iiwa.job.feed_scheduling import AS_PROGRAMMED, SCHEDULED, ScheduledJob
from trajopt_cli.iiwa.job.simulation import Simulated, frames_change
from trajopt_cli.iiwa.job.texts import (
    feeds_table,
    force_table,
    law_table,
    link_lines,
    motor_lines,
    where_line,
)
from trajopt_cli.iiwa.report.page import AFTER, AXES, BEFORE, Chart, Curve, TimelineEntry, legs_table, run_page
from trajopt_cli.limits import JointLimits
from trajopt_cli.page.document import Section
from trajopt_cli.page.scene import robot_scene
from trajopt_cli.page.tables import Tile, drawn, points
from trajopt_cli.scene import Cycle, ScenePoint
from trajopt_cli.shapes import Capsule
from trajopt_cli.units import DEG, MM

COMMANDED, PREDICTED = "commanded", "predicted"
_STEP, _ROWS = 4e-3, 10_000  # s between rows of the arm in space, and how many there are at most
_LEGS = 400  # in the table
_MOVES = 1e-6  # m, rad, N, Nm: less is rounding
_SHOWN = (1e-4,) * 3 + (1e-3,) * 3  # m, rad: coordinates that move less have no chart
_NAMES = ("x", "y", "z", "alpha", "beta", "gamma")
_UNITS = ((MM, "mm"),) * 3 + ((DEG, "°"),) * 3

# A run beside others: its name, the run, the style of its curves.
_Named = tuple[str, Simulated, str]


def simulation_page(run: Simulated) -> bytes:
    """What was commanded and how the controller is predicted to follow: in space, lag, forces, contact, joints."""
    commanded = None if frames_change(run.opened.task) else commanded_joints(run)
    against = "its plan" if run.on_plan else "the equilibrium"
    poses = [(COMMANDED, run.t, run.target, BEFORE), (PREDICTED, run.t, run.x, AFTER)]
    charts: dict[str, tuple[str, Sequence[Chart]]] = {
        "Lag": (f"Distance from {against}: {where_line(run.lag)}.", list(_lag_charts([(PREDICTED, run, AFTER)]))),
        "Pose": ("", list(_pose_charts(poses))),
    }
    if forces := list(_force_charts(run)):
        charts["Forces"] = ("World axes, on the tool.", forces)
    shown = [(COMMANDED, run.t, commanded, BEFORE), (PREDICTED, run.t, run.q, AFTER)]
    joints = [(name, t, q, style) for name, t, q, style in shown if q is not None]
    if joints:
        charts["Joints"] = ("", _joint_charts(joints, run.opened.robot.profile(run.opened.task.limits)))
    world = [f"The whole loop was run because of {', '.join(run.why)}."] if run.why else []
    world += ["MuJoCo is not installed: obstacles are springs, and links pass through them."] if run.fallback else []
    world += [*motor_lines(run), *(link_lines(run) if run.contact is not None else [])]
    law = (drawn(law_table(run.axes, run.opened.equilibrium.h)) if run.axes else "") + (
        drawn(force_table(run)) if run.forces else ""
    )
    kind = "the controller's law alone" if run.loop is None else run.loop.world
    return run_page(
        Path(run.opened.task.file).stem,
        f"{run.opened.robot.name}, {kind}, feed {run.feed.value}, {run.opened.task.integration.value} steps",
        list(_tiles(run)),
        [(name, float(run.t[-1])) for name, *_ in joints] or [(PREDICTED, float(run.t[-1]))],
        _scene(run, [(name, t, q) for name, t, q, _ in joints])
        if joints
        else "The arm cannot follow: there is nothing to show in space.",
        charts,
        [
            Section("legs", "Legs", _legs(run), "Where the arm lags most within each."),
            Section("law", "Controller", law + points(world)),
        ],
    )


def feed_page(job: ScheduledJob) -> bytes:
    """The sequence as it was and as it is scheduled: times, lag against its bound, feed, force if blocked, joints."""
    after, allowed = job.run, job.scheduled.allowed
    pair: list[_Named] = [(AS_PROGRAMMED, job.programmed, BEFORE), (SCHEDULED, after, AFTER)]
    pushes = [Curve(who, run.t, np.linalg.norm(run.push, axis=1), style) for who, run, style in pair]
    speeds = [
        Curve(who, run.t[1:], np.linalg.norm(np.diff(run.x[:, :3], axis=0), axis=1) / run.opened.equilibrium.h, style)
        for who, run, style in pair
    ]
    leads = [Curve(who, run.t, deviation(run.x, run.x_e) / MM, style) for who, run, style in pair]
    joints = [(who, run.t, run.q, style) for who, run, style in pair if run.q is not None]
    charts: dict[str, tuple[str, Sequence[Chart]]] = {
        "Lag": ("", list(_lag_charts(pair, allowed.lag, allowed.turn_lag))),
        "Feed": (
            "",
            [
                Chart("speed", "Speed of the tool", "m/s", speeds, zero=True, digits=3),
                Chart("lead", "Distance of the equilibrium from the tool", "mm", leads, zero=True),
            ],
        ),
        "Push": (
            "What the spring would begin to push with.",
            [Chart("push", "Force if blocked", "N", pushes, peak=True, zero=True)],
        ),
        "Pose": ("", list(_pose_charts([(who, run.t, run.x, style) for who, run, style in pair]))),
        "Joints": ("", _joint_charts(joints, after.opened.robot.profile(after.opened.task.limits))),
    }
    return run_page(
        f"{Path(job.before.task.file).stem}, dosed",
        f"lag of at most {allowed.lag / MM:g} mm; {SCHEDULED}",
        list(_feed_tiles(job)),
        [(who, float(run.t[-1])) for who, run, _ in pair],
        _scene(after, [(who, t, q) for who, t, q, _ in joints])
        if len(joints) == 2
        else "The arm cannot follow one of the two runs.",
        charts,
        [
            Section("feeds", "Feeds", drawn(feeds_table("As it was, and scheduled", job)) + points(job.remarks())),
            Section("legs", "Legs", _legs(after), "Of the scheduled sequence."),
        ],
    )


def commanded_joints(run: Simulated) -> Array | None:
    """Joints (n, 7) [rad] of an arm that is where it should be at every row, None where that is out of reach."""
    arm, sequence, shown = run.opened.arm, run.opened.plan or run.opened.equilibrium, _rows(run.t)
    used = np.minimum(shown, len(sequence.pose) - 1)
    q = arm.joints(arm.flange(sequence.rotations(arm.X_start[:3, :3])[used], sequence.pose[used, :3]))
    if np.isnan(q).any():
        return None
    return np.column_stack([np.interp(run.t, run.t[shown], column) for column in q.T])


def _rows(t: Array) -> IndexArray:
    """Rows of times t (n,) that the arm in space is drawn at."""
    step = max(1, round(_STEP / (t[1] - t[0])), -(-len(t) // _ROWS)) if len(t) > 1 else 1
    return np.unique(np.r_[0 : len(t) : step, len(t) - 1])


def _scene(run: Simulated, shown: Sequence[tuple[str, Array, Array]]) -> dict[str, Any]:
    """The arm in space, a cycle for each (name, times, joints)."""
    task, sequence = run.opened.task, run.opened.equilibrium
    tools = ((0.0, task.X_FT), *((change.t, change.X_FT) for change in task.changes if change.X_FT is not None))
    cycles = [Cycle(name, t[_rows(t)], q[_rows(t)], tools, ((0.0, float(t[-1])),)) for name, t, q in shown]
    target = (run.opened.plan or sequence).pose
    named = {sequence.pieces[0].origin: target[0, :3]}
    named |= {piece.goal: target[piece.last, :3] for piece in sequence.pieces[:_LEGS]}
    marks = [ScenePoint(name, (float(p[0]), float(p[1]), float(p[2]))) for name, p in named.items()]
    obstacles, carried = [], []
    if run.contact is not None:
        obstacles = [one.shape for one in run.contact.obstacles]
        carried = [Capsule("tip", task.X_FT[:3, 3], task.X_FT[:3, 3], run.contact.tip)]
    return robot_scene(run.opened.robot, marks, cycles, obstacles, carried)


def _lag_charts(runs: Sequence[_Named], lag: float | None = None, turn: float | None = None) -> Iterator[Chart]:
    for name, title, unit, measure, size, bound in (
        ("lag", "Lag", "mm", deviation, MM, lag),
        ("turn-lag", "Turn lag", "°", turn_deviation, DEG, turn),
    ):
        curves = [Curve(who, run.t, measure(run.x, run.target) / size, style) for who, run, style in runs]
        if name == "lag" or max(float(curve.y.max()) for curve in curves) * size > _MOVES:
            limits = [] if bound is None else [(bound / size, "allowed")]
            yield Chart(name, title, unit, curves, limits, peak=True, zero=True)


def _pose_charts(paths: Sequence[tuple[str, Array, Array, str]]) -> Iterator[Chart]:
    """Name, times (n,), poses (n, 6) and style of each: the coordinates that move."""
    for i, (name, (size, unit)) in enumerate(zip(_NAMES, _UNITS, strict=True)):
        if max(float(np.ptp(x[:, i])) for _, _, x, _ in paths) > _SHOWN[i]:
            yield Chart(
                f"pose-{name}", name, unit, [Curve(who, t, x[:, i] / size, style) for who, t, x, style in paths]
            )


def _force_charts(run: Simulated) -> Iterator[Chart]:
    t, loop = run.t, run.loop
    true = None if loop is None else loop.contact_true
    for name, title, values in (
        ("believed", "as the controller believes", run.force),
        ("true", "of what touches the tool", true),
    ):
        for part, unit, first in (("Force", "N", 0), ("Moment", "Nm", 3)):
            if values is not None and float(np.abs(values[:, first : first + 3]).max()) > _MOVES:
                axes = zip("xyz", AXES, values[:, first : first + 3].T, strict=True)
                curves = [Curve(axis, t, column, style) for axis, style, column in axes]
                yield Chart(f"{name}-{part.lower()}", f"{part}, {title}", unit, curves, peak=True)
    if run.pressed is not None and run.pressing is not None:
        shown = [("wish", run.pressing.wish, BEFORE), ("pressed", run.pressed, AFTER)]
        curves = [Curve(name, t[: len(y)], y[: len(t)], style) for name, y, style in shown]
        yield Chart("pressed", "Force that the tool presses with", "N", curves, zero=True)
    if loop is not None and run.touch is not None:
        depth = Curve("depth", t, loop.depth / MM, AFTER)
        yield Chart("depth", "Depth of the tip", "mm", [depth], peak=True, zero=True)
    push = Curve("push", t, np.linalg.norm(run.push, axis=1), AFTER)
    yield Chart("push", "Force if blocked", "N", [push], peak=True, zero=True)


def _joint_charts(paths: Sequence[tuple[str, Array, Array, str]], limits: JointLimits) -> list[Chart]:
    """Name, times (n,), joints (n, 7) and style of each; every joint between its limits."""
    return [
        Chart(
            f"joint-{j}",
            name.replace("_", " "),
            "°",
            [Curve(who, t, q[:, j] / DEG, style) for who, t, q, style in paths],
            [(float(limits.lower[j]) / DEG, "lower"), (float(limits.upper[j]) / DEG, "upper")],
            digits=1,
        )
        for j, name in enumerate(limits.names)
    ]


def _tiles(run: Simulated) -> Iterator[Tile]:
    lag, touch = run.lag, run.touch
    yield Tile(
        "largest lag", f"{lag.maximum / MM:.2f} mm", f"at {lag.time:.3f} s, {lag.mean / MM:.2f} mm on average", AFTER
    )
    if touch is not None:
        deep = (
            f"at {touch['largest_force_at_s']:.3f} s; tip {touch['deepest_m'] / MM:.3f} mm deep,"
            f" {touch['in_contact_s']:.3f} s in contact"
        )
        yield Tile("largest force on the tool", f"{touch['largest_force_N']:.2f} N", deep, AFTER)
    elif run.contact is not None:
        yield Tile("largest force on the tool", "0 N", "it touches nothing", AFTER)
    else:
        yield Tile("force if blocked", f"{run.most_push:.1f} N", "the most, anywhere on the path", AFTER)
    yield Tile("duration", f"{run.t[-1]:.3f} s", f"the last pose held for {run.settle:.3g} s", BEFORE)
    broken = run.broken
    kept = "joints keep position, speed and acceleration limits" if run.loop is None else "no limit stops the loop"
    name = "joint limits" if run.loop is None else "limits of the loop"
    yield Tile(name, "broken" if broken else "kept", "; ".join(broken) or kept, "")


def _feed_tiles(job: ScheduledJob) -> Iterator[Tile]:
    first, made = job.programmed, job.scheduled
    arrived = "not arrived" if job.arrived is None else f"arrived at {job.arrived:.3f} s"
    lag = f"lag {first.lag.maximum / MM:.2f} mm, {arrived}"
    yield Tile(AS_PROGRAMMED, f"{first.opened.equilibrium.duration:.3f} s", lag, BEFORE)
    arrived = "" if made.arrived is None else f", arrived at {made.arrived:.3f} s"
    yield Tile(SCHEDULED, f"{made.duration:.3f} s", f"lag {made.lag.maximum / MM:.2f} mm{arrived}", AFTER)
    if made.least is not None:
        what = "no sequence fed so and within these bounds is faster"
        yield Tile("lower bound", f"{made.least:.3f} s", what, "bound")
    lead = made.allowed.lead
    yield Tile("force if blocked", f"{made.push:.1f} N", str(lead) if lead is not None else "no bound on it")


def _legs(run: Simulated) -> str:
    t, target = run.t, run.target
    away, turned = deviation(run.x, target), turn_deviation(run.x, target)
    made = []
    for one in run.opened.equilibrium.pieces[:_LEGS]:
        rows = slice(one.first, one.last + 1)
        if one.first >= len(t):
            break
        name = f"dwell at {one.goal}" if one.dwell else f"{one.origin} → {one.goal}"
        more = (f"{away[rows].max() / MM:.2f}", f"{turned[rows].max() / DEG:.2f}")
        made.append(TimelineEntry(name, float(t[one.first]), float(t[min(one.last, len(t) - 1)]), more))
    left = len(run.opened.equilibrium.pieces) - len(made)
    cut = points([f"{left} more legs are not in this table."]) if left > 0 else ""
    return legs_table((">largest lag [mm]", ">largest turn lag [°]"), made) + cut
