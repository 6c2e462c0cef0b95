"""report.html of `trajopt iiwa simulate` and `dose`, made from what the commands found."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, IndexArray, inverse_pose, pose
from trajopt_cli.iiwa.controller.lag import deviation, turn_deviation
from trajopt_cli.iiwa.job.feed_scheduling import DOSED, DosedJob
from trajopt_cli.iiwa.job.simulation import Simulated, frames_change, touches
from trajopt_cli.iiwa.report.page import AFTER, AXES, BEFORE, Chart, Curve, Tile, TimelineEntry, legs_table, run_page
from trajopt_cli.iiwa.task.equilibrium import Piece
from trajopt_cli.iiwa.task.joint_rows import joints_along
from trajopt_cli.iiwa.task.joints import Followed
from trajopt_cli.limits import JointLimits
from trajopt_cli.page.document import Section
from trajopt_cli.page.scene import robot_scene
from trajopt_cli.page.tables import points, table
from trajopt_cli.robot.srs_inverse import arm_angle, configuration
from trajopt_cli.scene import Cycle, ScenePoint
from trajopt_cli.shapes import Capsule
from trajopt_cli.units import DEG, MM

ASKED, FORETOLD = "asked", "foretold"
_STEP, _ROWS = 4e-3, 10_000  # s between rows of the arm in space, and how many there are at most
_LEGS = 400  # in the table
_NOT_BOTH = "The arm cannot follow one of the two runs: there is nothing to show in space."
_MOVES = 1e-6  # m, rad, N, Nm: less is rounding
_SEEN = (1e-4,) * 3 + (1e-3,) * 3  # m, rad: coordinates that move less have no chart
_NAMES = ("x", "y", "z", "alpha", "beta", "gamma")
_UNITS = ((MM, "mm"),) * 3 + ((DEG, "°"),) * 3


def simulation_page(run: Simulated) -> bytes:
    """What was asked and what the controller makes of it: in space, lag, forces, contact, joints."""
    target, q = run.target[: len(run.x)], joints_of(run)
    asked = None if frames_change(run.opened.task) else asked_joints(run)
    charts: dict[str, tuple[str, Sequence[Chart]]] = {
        "Lag": (_lag_lead(run), list(_lag_charts([(FORETOLD, run)], None, None))),
        "Pose": ("", list(_pose_charts([(ASKED, run.t, target, BEFORE), (FORETOLD, run.t, run.x, AFTER)]))),
    }
    forces = list(_force_charts(run))
    if forces:
        charts["Forces"] = ("World axes, on the tool.", forces)
    shown = [(name, rows) for name, rows in ((ASKED, asked), (FORETOLD, q)) if rows is not None]
    limits = run.opened.robot.profile(run.opened.task.limits)
    if shown:
        looks = {ASKED: BEFORE, FORETOLD: AFTER}
        charts["Joints"] = ("", _joint_charts([(name, run.t, rows, looks[name]) for name, rows in shown], limits))
    told = [
        Section("legs", "Legs", _legs(run), "Where the arm lags most within each."),
        Section("law", "Controller", _law(run) + points(_world(run))),
    ]
    return run_page(
        Path(run.opened.task.file).stem,
        _about(run),
        list(_tiles(run)),
        [(name, float(run.t[-1])) for name, _ in shown] or [(FORETOLD, float(run.t[-1]))],
        _scene(run, shown),
        charts,
        told,
    )


def dose_page(job: DosedJob) -> bytes:
    """The sequence as it was and as it is dosed: times, lag against its bound, feed, push, joints."""
    before, after, allowed = job.ways[0], job.run, job.dosed.allowed
    name = DOSED[job.dosed.feed]
    others = [(way.name, way.run) for way in job.ways[1:]]
    runs = [(before.name, before.run), *others, (name, after)]
    limits = after.opened.robot.profile(after.opened.task.limits)
    pushes = [
        Chart(
            "push",
            "Push, if the tool were held",
            "N",
            [
                Curve(who, run.t, np.linalg.norm(run.push, axis=1), look)
                for (who, run), look in zip(runs, _looks(len(runs)), strict=True)
            ],
            peak=True,
            zero=True,
        )
    ]
    pair = ((before.name, before.run, BEFORE), (name, after, AFTER))
    speeds = [
        Curve(who, run.t[1:], np.linalg.norm(np.diff(run.x[:, :3], axis=0), axis=1) / run.opened.equilibrium.h, look)
        for who, run, look in pair
    ]
    leads = [Curve(who, run.t, deviation(run.x, run.x_e[: len(run.x)]) / MM, look) for who, run, look in pair]
    charts: dict[str, tuple[str, Sequence[Chart]]] = {
        "Lag": ("", list(_lag_charts(runs, allowed.lag, allowed.turn_lag))),
        "Feed": (
            "",
            [
                Chart("speed", "Speed of the tool", "m/s", speeds, zero=True, digits=3),
                Chart("lead", "What is fed, away from the tool", "mm", leads, zero=True),
            ],
        ),
        "Push": ("What the spring, and the damper where speed is fed, would begin to push with.", pushes),
    }
    charts["Pose"] = ("", list(_pose_charts([(who, run.t, run.x, look) for who, run, look in pair])))
    arms = [(who, run.t, joints_of(run), look) for who, run, look in pair]
    joints = [(who, t, rows, look) for who, t, rows, look in arms if rows is not None]
    shown = [(who, rows) for who, _, rows, _ in joints]
    charts["Joints"] = ("", _joint_charts(joints, limits))
    return run_page(
        f"{Path(job.before.task.file).stem}, dosed",
        f"lag of at most {allowed.lag / MM:g} mm; {name}",
        list(_dose_tiles(job)),
        [(before.name, float(before.run.t[-1])), (name, float(after.t[-1]))],
        _scene(after, shown, [before.run.t, after.t])
        if len(shown) == 2
        else "The arm cannot follow one of the two runs.",
        charts,
        [Section("feeds", "Feeds", _feeds(job)), Section("legs", "Legs", _legs(after), "Of the dosed sequence.")],
    )


def joints_of(run: Simulated) -> Array | None:
    """The arm's joints (n, 7) [rad] in a run, None where it cannot follow."""
    if run.loop is not None:
        return run.loop.q
    return run.joints.trajectory.q if isinstance(run.joints, Followed) else None


def asked_joints(run: Simulated) -> Array | None:
    """Joints (n, 7) [rad] of an arm that is where it should be at every row, None where that is out of reach."""
    task, robot = run.opened.task, run.opened.robot
    sequence = run.opened.plan or run.opened.equilibrium
    rows = np.minimum(np.arange(len(run.x)), len(sequence.pose) - 1)
    used = rows[_rows(run.t)]
    X_WT = pose(sequence.rotations(run.opened.X_start[:3, :3])[used], sequence.pose[used, :3])
    start = task.start_joints
    angle = float(arm_angle(robot, start, task.definition)) if task.arm_angle is None else task.arm_angle
    q = joints_along(robot, X_WT @ inverse_pose(task.X_FT), angle, task.definition, int(configuration(start)), start)
    if np.isnan(q).any():
        return None
    out = np.empty((len(run.t), q.shape[1]))
    for j in range(q.shape[1]):
        out[:, j] = np.interp(run.t, run.t[_rows(run.t)], q[:, j])
    return out


def _rows(t: Array) -> IndexArray:
    """Rows of times t (n,) that the arm in space is drawn at."""
    step = max(1, round(_STEP / (t[1] - t[0])), -(-len(t) // _ROWS)) if len(t) > 1 else 1
    return np.unique(np.r_[0 : len(t) : step, len(t) - 1])


def _scene(run: Simulated, shown: Sequence[tuple[str, Array]], times: Sequence[Array] = ()) -> dict[str, Any] | str:
    """The arm in space, a cycle for each (name, joints); all at the run's times unless others are given."""
    if not shown:
        return "The arm cannot follow: there is nothing to show in space."
    task, robot, sequence = run.opened.task, run.opened.robot, run.opened.equilibrium
    tools = ((0.0, task.X_FT), *((change.t, change.X_FT) for change in task.changes if change.X_FT is not None))
    cycles = []
    for (name, q), t in zip(shown, times or [run.t] * len(shown), strict=True):
        rows = _rows(t)
        cycles.append(Cycle(name, t[rows], q[rows], tools, ((0.0, float(t[-1])),)))
    target = (run.opened.plan or sequence).pose
    named = {sequence.pieces[0].origin: target[0, :3]}
    named |= {piece.goal: target[piece.last, :3] for piece in sequence.pieces[:_LEGS]}
    marks = [ScenePoint(name, (float(p[0]), float(p[1]), float(p[2]))) for name, p in named.items()]
    obstacles, carried = [], []
    if run.contact is not None:
        obstacles = [one.box for one in run.contact.obstacles]
        carried = [Capsule("tip", task.X_FT[:3, 3], task.X_FT[:3, 3], run.contact.tip)]
    return robot_scene(robot, marks, cycles, obstacles, carried)


def _looks(count: int) -> list[str]:
    """Of runs beside each other: the first is the one before, the last the one after."""
    return [BEFORE, *AXES[1 : count - 1], AFTER] if count > 1 else [AFTER]


def _lag_lead(run: Simulated) -> str:
    where = f" between {run.lag.piece.origin} and {run.lag.piece.goal}" if run.lag.piece else ""
    against = "its plan" if run.opened.plan is not None and not frames_change(run.opened.task) else "the equilibrium"
    return f"Distance from {against}: at most {run.lag.maximum / MM:.2f} mm at {run.lag.time:.3f} s{where}."


def _lag_charts(runs: Sequence[tuple[str, Simulated]], lag: float | None, turn: float | None) -> Iterator[Chart]:
    looks = _looks(len(runs))
    for name, title, unit, measure, size, bound in (
        ("lag", "Lag", "mm", deviation, MM, lag),
        ("turn-lag", "Turn lag", "°", turn_deviation, DEG, turn),
    ):
        curves = [
            Curve(who, run.t, measure(run.x, run.target[: len(run.x)]) / size, look)
            for (who, run), look in zip(runs, looks, strict=True)
        ]
        if name == "lag" or max(float(curve.y.max()) for curve in curves) * size > _MOVES:
            limits = [] if bound is None else [(bound / size, "allowed")]
            yield Chart(name, title, unit, curves, limits, peak=True, zero=True)


def _pose_charts(ways: Sequence[tuple[str, Array, Array, str]]) -> Iterator[Chart]:
    """Name, times (n,), poses (n, 6) and looks of each: the coordinates that move."""
    for i, (name, (size, unit)) in enumerate(zip(_NAMES, _UNITS, strict=True)):
        if max(float(np.ptp(x[:, i])) for _, _, x, _ in ways) > _SEEN[i]:
            yield Chart(f"pose-{name}", name, unit, [Curve(who, t, x[:, i] / size, look) for who, t, x, look in ways])


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
                curves = [Curve(axis, t, column, look) for axis, look, column in axes]
                yield Chart(f"{name}-{part.lower()}", f"{part}, {title}", unit, curves, peak=True)
    if loop is not None and np.any(loop.depth > 0):
        yield Chart(
            "depth", "Depth of the tip", "mm", [Curve("depth", t, loop.depth / MM, AFTER)], peak=True, zero=True
        )
    push = Curve("push", t, np.linalg.norm(run.push, axis=1), AFTER)
    yield Chart("push", "Push, if the tool were held", "N", [push], peak=True, zero=True)


def _joint_charts(ways: Sequence[tuple[str, Array, Array, str]], limits: JointLimits) -> list[Chart]:
    """Name, times (n,), joints (n, 7) and looks of each; every joint between its limits."""
    return [
        Chart(
            f"joint-{j}",
            name.replace("_", " "),
            "°",
            [Curve(who, t, q[:, j] / DEG, look) for who, t, q, look in ways],
            [(float(limits.lower[j]) / DEG, "lower"), (float(limits.upper[j]) / DEG, "upper")],
            digits=1,
        )
        for j, name in enumerate(limits.names)
    ]


def _tiles(run: Simulated) -> Iterator[Tile]:
    lag, touch = run.lag, touches(run)
    yield Tile(
        "largest lag", f"{lag.maximum / MM:.2f} mm", f"at {lag.time:.3f} s, {lag.mean / MM:.2f} mm on average", AFTER
    )
    if touch is not None:
        deep = f"at {touch.force_time:.3f} s; tip {touch.depth / MM:.3f} mm deep, {touch.seconds:.3f} s in contact"
        yield Tile("largest force on the tool", f"{touch.force:.2f} N", deep, AFTER)
    elif run.contact is not None:
        yield Tile("largest force on the tool", "0 N", "it touches nothing", AFTER)
    else:
        push = float(np.linalg.norm(run.push, axis=1).max())
        yield Tile("push, if held", f"{push:.1f} N", "the most, anywhere on the way", AFTER)
    yield Tile("duration", f"{run.t[-1]:.3f} s", f"the last pose held for {run.settle:.3g} s", BEFORE)
    broken = run.broken
    kept = "joints keep position, speed and acceleration limits" if run.loop is None else "no limit stops the loop"
    told = "; ".join(broken) if broken else kept
    yield Tile("the arm", "cannot" if broken else "follows", told, "" if broken else "bound")


def _dose_tiles(job: DosedJob) -> Iterator[Tile]:
    before, made = job.ways[0], job.dosed
    arrived = "not arrived" if before.arrived is None else f"arrived at {before.arrived:.3f} s"
    lag = before.run.lag.maximum / MM
    yield Tile(before.name, f"{before.run.opened.equilibrium.duration:.3f} s", f"lag {lag:.2f} mm, {arrived}", BEFORE)
    arrived = "" if made.arrived is None else f", arrived at {made.arrived:.3f} s"
    yield Tile(DOSED[made.feed], f"{made.duration:.3f} s", f"lag {made.lag.maximum / MM:.2f} mm{arrived}", AFTER)
    if made.least is not None:
        yield Tile(
            "lower bound", f"{made.least:.3f} s", "no sequence fed so and within these bounds is faster", "bound"
        )
    lead = made.allowed.lead
    asked = "no bound was asked for"
    if lead is not None:
        asked = (
            f"the spring stretched by at most {lead.most / MM:g} mm"
            if lead.stretch
            else f"at most {lead.most:g} N allowed"
        )
    yield Tile("push, if held", f"{made.push:.1f} N", asked)


def _legs(run: Simulated) -> str:
    t, away = run.t, deviation(run.x, run.target[: len(run.x)])
    turned = turn_deviation(run.x, run.target[: len(run.x)])
    made = []
    for one in run.opened.equilibrium.pieces[:_LEGS]:
        rows = slice(one.first, one.last + 1)
        if one.first >= len(t):
            break
        more = (f"{away[rows].max() / MM:.2f}", f"{turned[rows].max() / DEG:.2f}")
        made.append(TimelineEntry(_leg_name(one), float(t[one.first]), float(t[min(one.last, len(t) - 1)]), more))
    left = len(run.opened.equilibrium.pieces) - len(made)
    cut = points([f"{left} more legs are not in this table."]) if left > 0 else ""
    return legs_table((">largest lag [mm]", ">largest turn lag [°]"), made) + cut


def _leg_name(piece: Piece) -> str:
    return f"dwell at {piece.goal}" if piece.dwell else f"{piece.origin} → {piece.goal}"


def _law(run: Simulated) -> str:
    heads = ("axis", ">K", ">D", ">M", "verdict", ">stable up to [ms]", ">damping ratio", ">time constant [s]")
    rows = [
        (
            axis.axis,
            *(f"{value:g}" for value in (axis.k, axis.d, axis.m)),
            axis.verdict.name.lower(),
            _finite(axis.h_max / MM),
            _finite(axis.damping_ratio),
            _finite(axis.slowest),
        )
        for axis in run.axes
    ]
    return table(f"The law at {run.opened.equilibrium.h / MM:g} ms", heads, rows)


def _finite(value: float) -> str:
    return f"{value:.3g}" if np.isfinite(value) else "any"


def _about(run: Simulated) -> str:
    world = "the controller's law alone" if run.loop is None else run.loop.world
    return f"{run.opened.robot.name}, {world}, feed {run.feed.value}, {run.opened.task.integration.value} steps"


def _world(run: Simulated) -> list[str]:
    """What the world tells of links and motors."""
    told = [f"The whole loop was run because of {', '.join(run.why)}."] if run.why else []
    told += ["MuJoCo is not installed: obstacles are springs, and links pass through them."] if run.fallback else []
    for one in run.links:
        force = "" if one.force is None else f", up to {one.force:.1f} N"
        told.append(
            f"{one.link} in {one.obstacle} from {one.first:.3f} s to {one.last:.3f} s, {one.depth / MM:.2f} mm{force}."
        )
    for motor in run.motors:
        told.append(f"{motor.joint}: at most {motor.torque:.1f} Nm of {motor.limit:g} Nm.")
    return told


def _feeds(job: DosedJob) -> str:
    from trajopt_cli.iiwa.controller.feed_schedule import CannotDose

    rows = [
        (
            way.name,
            f"{way.run.opened.equilibrium.duration:.3f}",
            f"{way.run.lag.maximum / MM:.2f}",
            f"{way.push:.1f}",
            "",
        )
        for way in job.ways
    ]
    for feed, made in job.tried.items():
        if isinstance(made, CannotDose):
            rows.append((DOSED[feed], "–", "–", "–", made.message))
        else:
            least = "" if made.least is None else f"at least {made.least:.3f} s"
            lag = f"{made.lag.maximum / MM:.2f}"
            rows.append((DOSED[feed], f"{made.duration:.3f}", lag, f"{made.push:.1f}", least))
    heads = ("feed", ">duration [s]", ">largest lag [mm]", ">largest push [N]", "")
    told = [*job.dosed.notes, *job.passed_over]
    if job.left_out:
        told.append(f"Dosing does not look at {', '.join(job.left_out)} of the task.")
    return table("Every feed that was tried", heads, rows) + points(told)
