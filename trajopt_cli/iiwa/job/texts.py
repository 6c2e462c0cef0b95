"""What the iiwa job's answers look like for people: mm, degrees, and every figure with its unit."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.table import TextTable, seconds, tabulate
from trajopt_cli.units import MM

if TYPE_CHECKING:
    from trajopt_cli.iiwa.controller.lag import Lag
    from trajopt_cli.iiwa.controller.stability import AxisStability
    from trajopt_cli.iiwa.job.feed_scheduling import ScheduledJob
    from trajopt_cli.iiwa.job.folder import Opened
    from trajopt_cli.iiwa.job.simulation import Simulated
    from trajopt_cli.iiwa.task.arm_plan import ArmFigures, ArmPlan
    from trajopt_cli.iiwa.task.equilibrium import Equilibrium
    from trajopt_cli.iiwa.task.joints import Followed
    from trajopt_cli.iiwa.task.model import Route
    from trajopt_cli.iiwa.task.segments import SegmentFacts
    from trajopt_cli.robot.srs import SrsRobot

_LINES = 40  # segments that are listed one by one
_TURN = 1e-9  # rad: a smaller turn is rounding
_MOMENT = 0.005  # Nm: a smaller moment is printed as none
_TURNING = {"rad": "°", "rad/s": "°/s", "rad/s2": "°/s²"}


def segments_table(task: str, facts: Sequence[SegmentFacts]) -> TextTable:
    """One line per segment; of more than _LINES the least, the mean and the greatest, and what they add up to."""
    columns: dict[str, tuple[int, Callable[[SegmentFacts], float]]] = {
        "length [mm]": (2, lambda fact: fact.L_p / MM),
        "turn [°]": (2, lambda fact: float(np.degrees(fact.L_theta))),
        "time [s]": (3, lambda fact: fact.duration),
        "dwell [s]": (3, lambda fact: fact.dwell),
        "top speed [m/s]": (4, lambda fact: fact.v_top),
        "top turn rate [°/s]": (2, lambda fact: float(np.degrees(fact.omega_top))),
    }
    if len(facts) <= _LINES:
        rows = [
            (
                fact.origin,
                fact.goal,
                *(f"{of(fact):.{digits}f}" for name, (digits, of) in columns.items() if name != "dwell [s]"),
                fact.binds,
            )
            for fact in facts
        ]
        heads = (f">{name}" for name in columns if name != "dwell [s]")
        return TextTable(f"{task}: segments", ("~from", "~to", *heads, "bound by"), tuple(rows))
    summed: list[tuple[str, ...]] = []
    for name, (digits, of) in columns.items():
        values = [of(fact) for fact in facts]
        shown = [min(values), sum(values) / len(values), max(values)]
        total = "" if name.startswith("top") else f"{sum(values):.{digits}f}"
        summed.append((name, *(f"{value:.{digits}f}" for value in shown), total))
    for name, count in Counter(fact.binds for fact in facts if fact.binds).most_common():
        summed.append((f"bound by {name}", "", "", "", str(count)))
    heads_of = ("", ">least", ">mean", ">greatest", ">all")
    return TextTable(f"{task}: {len(facts)} segments", heads_of, tuple(summed))


def passing_lines(facts: Sequence[SegmentFacts], route: Route) -> list[str]:
    """How near the poses are passed that are no stops, and what the tool is asked to do there."""
    found = [fact.passed for fact in facts if fact.passed is not None]
    if not any(one.poses for one in found) or route.passing is None:
        return []
    away, turned = max(one.away for one in found), max(one.turned for one in found)
    return [
        f"{sum(one.poses for one in found)} poses are passed without a stop, at most {round(away / MM, 6):.3g} mm and"
        f" {np.degrees(turned):.2g}° off (allowed {route.passing.tolerance / MM:g} mm,"
        f" {np.degrees(route.passing.turn_tolerance):g}°)",
        f"the tool's acceleration is at most {max(one.a_top for one in found):.3g} m/s² and"
        f" {max(one.epsilon_top for one in found):.3g} rad/s², its jerk"
        f" {max(one.jerk_top for one in found):.3g} m/s³ and {max(one.angular_jerk_top for one in found):.3g} rad/s³",
    ]


def sequence_line(sequence: Equilibrium) -> str:
    """How long the sequence is, and what its numbers mean."""
    counted = {"relative": "from the orientation at the start", "absolute": "from the world's axes"}
    return (
        f"T = {sequence.duration:.3f} s, {len(sequence.pose)} poses, one every {sequence.h / MM:g} ms;"
        f" angles count {counted[sequence.meaning.value]}; rotation {sequence.rotation.value}"
    )


def joints_table(robot: str, findings: Sequence[Finding]) -> TextTable:
    """Per joint the worst case of position, speed and acceleration, in degrees."""
    return tabulate(
        f"{robot}: joints along the sequence, worst case of each check",
        findings,
        {
            "check": lambda one: one.check,
            "joint": lambda one: one.subject,
            ">value": lambda one: f"{np.degrees(one.value):.2f}",
            ">limit": lambda one: f"{np.degrees(one.limit):.2f}",
            ">time [s]": lambda one: seconds(one.time),
            "unit": lambda one: _TURNING.get(one.unit, one.unit),
            "": lambda one: "ok" if one.passed else "FAILED",
        },
    )


def arm_line(followed: Followed) -> str:
    """Arm angle and configuration."""
    # + 0.0 takes the sign off a zero
    least, greatest = (round(np.degrees(end), 2) + 0.0 for end in (followed.arm_angle.min(), followed.arm_angle.max()))
    angle = f"{least:.2f}°" if greatest == least else f"{least:.2f}° to {greatest:.2f}°"
    signs = ", ".join(
        f"joint_{joint} {'< 0' if followed.configuration >> bit & 1 else '>= 0'}" for bit, joint in enumerate((2, 4, 6))
    )
    return f"arm angle {angle} ({followed.definition.value}), configuration {followed.configuration}: {signs}"


def ease_line(robot: SrsRobot, followed: Followed) -> str:
    """How far the arm is from singular postures."""
    ease = robot.manipulability(followed.trajectory.q)
    least = float(followed.trajectory.t[int(np.argmin(ease))])
    return (
        f"manipulability {ease.min():.3g} to {ease.max():.3g} m³, least at {least:.3f} s (0 where the arm is singular)"
    )


def chosen_table(plan: ArmPlan) -> TextTable:
    """A chosen course of the arm angle beside the fixed one."""
    figures: dict[str, Callable[[ArmFigures], tuple[str, int | None]]] = {
        "least distance from a limit [°]": lambda one: (f"{np.degrees(one.margin):.2f}", one.near),
        "top speed [% of limit]": lambda one: (f"{100 * one.speed:.1f}", one.fast),
        "speeds, rms [% of limit]": lambda one: (f"{100 * one.steady:.2f}", None),
        "top acceleration [% of limit]": lambda one: (f"{100 * one.acceleration:.1f}", one.abrupt),
        "top holding torque [% of range]": lambda one: (f"{100 * one.gravity:.2f}", one.loaded),
        "holding torques, rms [% of range]": lambda one: (f"{100 * one.effort:.2f}", None),
        "top torque with inertia [% of range]": lambda one: (f"{100 * one.torque:.2f}", one.strained),
        "way of the elbow [m]": lambda one: (f"{one.elbow:.3f}", None),
        "arm angle turned by [°]": lambda one: (f"{np.degrees(one.turned):.1f}", None),
        "positions and speeds": lambda one: ("kept" if one.passes else "BROKEN", None),
    }
    rows = []
    for name, of in figures.items():
        cells = [of(one) for one in (plan.fixed, plan.best)]
        joints = ["" if joint is None else f"joint_{joint + 1}" for _, joint in cells]
        rows.append((name, cells[0][0], joints[0], cells[1][0], joints[1]))
    heads = ("over all rows", ">fixed", "", ">chosen", "")
    return TextTable(f"arm angle chosen for {plan.goal.value}", heads, tuple(rows))


def chosen_lines(plan: ArmPlan) -> list[str]:
    """How near a chosen course is to the best, and the grid of the search."""
    grid = f"{len(plan.map.rows)} stages and {len(plan.map.delta)} arm angles {np.degrees(plan.map.cell):.2g}° apart"
    lines = ["distance, top speed and acceleration are without joint_4: the pose alone decides it"]
    if plan.held:
        return [*lines, f"searched on {grid}"]
    loss = 100 * (plan.cost / plan.grid_cost - 1)
    smoothed = f"{abs(loss):.2f} % {'more' if loss > 0 else 'less'}"
    fixed = f", the fixed arm angle {plan.fixed_cost:.5g}" if plan.fixed.passes else ""
    lines.append(f"cost {plan.cost:.5g}{fixed}; the best course on {grid} {plan.grid_cost:.5g}: smooth is {smoothed}")
    if plan.goal.value == "limits":
        lines.append(f"the best course on the grid stays {np.degrees(plan.grid_margin):.2f}° from limits")
    return lines


def law_table(axes: Iterable[AxisStability], h: float) -> TextTable:
    """The law per axis, with changes when each holds; axes of the same numbers share a line."""
    groups: dict[tuple[float, float, float, float], list[AxisStability]] = {}
    for axis in axes:
        groups.setdefault((axis.since, axis.k, axis.d, axis.m), []).append(axis)
    begins = sorted({since for since, *_ in groups})
    until = dict(zip(begins, (f"to {t:g}" for t in begins[1:]), strict=False))
    when: dict[str, Callable[[list[AxisStability]], str]] = {
        "holds [s]": lambda group: f"{group[0].since:g} {until.get(group[0].since, 'on')}"
    }
    return tabulate(
        f"the controller's law at {h / MM:g} ms",
        groups.values(),
        {
            **(when if until else {}),
            "~axis": lambda group: ", ".join(dict.fromkeys(axis.axis for axis in group)),
            ">K": lambda group: f"{group[0].k:g}",
            ">D": lambda group: f"{group[0].d:g}",
            ">M": lambda group: f"{group[0].m:g}",
            "verdict": lambda group: group[0].verdict.name.lower(),
            ">stable up to": lambda group: (
                "any period" if np.isinf(group[0].h_max) else f"{group[0].h_max / MM:.3g} ms"
            ),
            ">damping ratio": lambda group: _finite(group[0].damping_ratio),
            ">time constant [s]": lambda group: _finite(group[0].slowest),
        },
    )


def _finite(value: float) -> str:
    return "" if np.isinf(value) else f"{value:.3g}"


def where_line(lag: Lag) -> str:
    """Where the arm lags most."""
    between = f" between {lag.piece.origin} and {lag.piece.goal}" if lag.piece else ""
    return f"at most {lag.maximum / MM:.2f} mm at {lag.time:.3f} s{between}"


def lag_lines(run: Simulated) -> list[str]:
    """How far the controller stays behind, and what its spring pulls with."""
    lag, velocity = run.lag, run.feed.value == "velocity"
    lines = [
        f"T = {run.t[-1]:.3f} s (the last pose held for {run.settle:.3g} s), feed {run.feed.value}: lag"
        f" {where_line(lag)}, {lag.mean / MM:.2f} mm on average" + (", counted from plan.csv" if run.on_plan else "")
    ]
    if lag.turn_maximum > _TURN:
        lines.append(f"turn lag at most {np.degrees(lag.turn_maximum):.2f}° at {lag.turn_time:.3f} s")
    law = "K times its distance from the equilibrium"
    law += ", and D times the speed that is fed" if velocity else ""
    return [*lines, f"force if blocked: up to {run.most_push:.1f} N ({law})"]


def contact_lines(run: Simulated) -> list[str]:
    """What the tool ran into."""
    if run.loop is None:
        unseen = " to press on" if run.pressing is not None else ""
        advice = ": 'contact: {tip: 0.02, obstacles: {plate: {box: ..., stiffness: 20 N/mm}}}'" if unseen else ""
        return [] if run.contact else [f"contact not simulated: the task names no obstacles{unseen}{advice}"]
    fallback = " (MuJoCo is not installed)" if run.fallback else ""
    lines = [f"world: {run.loop.world}{fallback}, the whole loop because of {', '.join(run.why)}", *motor_lines(run)]
    if run.contact is None:
        return lines
    touch = run.touch
    if touch is None:
        return [*lines, "the tool touches nothing", *link_lines(run)]
    x, y, z = touch["largest_per_axis_N"]
    away, own = (
        [value / MM for value in touch[name]]
        for name in ("largest_excursion_per_axis_m", "controllers_excursion_per_axis_m")
    )
    return [
        *lines,
        f"first touch at {touch['first_s']:.3f} s, last at {touch['last_s']:.3f} s, {touch['in_contact_s']:.3f} s in"
        " contact",
        f"force on the tool up to {touch['largest_force_N']:.2f} N at {touch['largest_force_at_s']:.3f} s"
        f" (x {x:.2f}, y {y:.2f}, z {z:.2f} N), tip up to {touch['deepest_m'] / MM:.3f} mm deep",
        "tool, where the arm is, away from the equilibrium while touching, its lag included:"
        f" up to x {away[0]:.2f}, y {away[1]:.2f}, z {away[2]:.2f} mm"
        f" (the controller's own pose: x {own[0]:.2f}, y {own[1]:.2f}, z {own[2]:.2f} mm)",
        *link_lines(run),
    ]


def force_table(run: Simulated) -> TextTable:
    """How hard the tool presses in every piece that the task gives a force."""
    columns: dict[str, Callable[[dict[str, Any]], str]] = {
        "~segment": lambda row: row["to"] if row["from"] == row["to"] else f"{row['from']} -> {row['to']}",
        ">wish [N]": lambda row: f"{row['wish_N']:.2f}",
        ">min": lambda row: f"{row['least_N']:.2f}",
        ">mean": lambda row: f"{row['mean_N']:.2f}",
        ">max": lambda row: f"{row['most_N']:.2f}",
        ">mean off by": lambda row: f"{100 * (row['mean_N'] / row['wish_N'] - 1):+.1f} %",
        ">at worst": lambda row: f"{100 * row['largest_error']:.1f} %",
    }
    return tabulate("force that the tool presses with", run.forces, columns)


def link_lines(run: Simulated) -> list[str]:
    """Which links were in obstacles, a line each."""
    if not run.links:
        return ["no link of the arm touches an obstacle; the links do not meet one another"]
    return [
        f"{one.link} is in {one.obstacle} from {one.first:.3f} to {one.last:.3f} s, {one.depth / MM:.2f} mm at most, "
        + ("not pushed back: only MuJoCo does" if one.force is None else f"with up to {one.force:.1f} N")
        for one in run.links
    ]


def motor_lines(run: Simulated) -> list[str]:
    """How near the motors came to their torque, or which stood at it."""
    if not run.motors:
        return []
    full = [f"{one.joint} at {one.saturated:.3f} s" for one in run.motors if one.saturated is not None]
    if full:
        return [f"motors reach their torque limit, so that the arm leaves its command: first {', '.join(full)}"]
    most = max(run.motors, key=lambda one: one.torque / one.limit)
    used = 100 * most.torque / most.limit
    return [f"motors: {most.joint} gives up to {most.torque:.1f} Nm, {used:.0f} % of its limit; the others less"]


def loop_time_line(run: Simulated) -> list[str]:
    """What one period of the controller cost here, beside the thesis'."""
    if run.loop is None or not run.loop.step_times.any():
        return []
    from trajopt_cli.iiwa.controller.loop import PARTS

    mean = 1e6 * run.loop.step_times.mean(axis=0)
    means = ", ".join(f"{name} {value:.0f}" for name, value in zip(PARTS, mean, strict=True))
    nearly = 1e6 * np.percentile(run.loop.step_times[:, -1], 99.9)
    return [
        f"one period on average [µs]: {means}; 99.9 % within {nearly:.0f} µs here in Python"
        " (the thesis' C++: 148 µs at worst, without a torque model)"
    ]


def feeds_table(title: str, job: ScheduledJob) -> TextTable:
    """The sequence as it was and as it is scheduled, with time, bound, lag and force if blocked."""
    from trajopt_cli.iiwa.job.feed_scheduling import AS_PROGRAMMED, SCHEDULED

    one, made = job.programmed, job.scheduled
    rows: list[tuple[str, float, float | None, float | None, Lag, float]] = [
        (AS_PROGRAMMED, one.opened.equilibrium.duration, None, job.arrived, one.lag, one.most_push),
        (SCHEDULED, made.duration, made.least, made.arrived, made.lag, made.push),
    ]
    columns: dict[str, Callable[[tuple[str, float, float | None, float | None, Lag, float]], str]] = {
        "~feed": lambda row: row[0],
        ">time [s]": lambda row: seconds(row[1]),
        ">least [s]": lambda row: seconds(row[2]),
        ">there [s]": lambda row: seconds(row[3], "not yet"),
        ">lag [mm]": lambda row: f"{row[4].maximum / MM:.3f}",
        ">force if blocked [N]": lambda row: f"{row[5]:.1f}",
    }
    if any(lag.turn_maximum > _TURN for *_, lag, _ in rows):
        columns[">turn lag [°]"] = lambda row: f"{np.degrees(row[4].turn_maximum):.3f}"
    return tabulate(title, rows, columns)


def front_table(job: ScheduledJob) -> TextTable:
    """The least time by the lead that is allowed."""
    stretch = job.front[0].lead.stretch
    rows = [
        (f"{one.lead.most / MM if stretch else one.lead.most:.4g}", seconds(one.duration, "none")) for one in job.front
    ]
    heads = (">lead [mm]" if stretch else ">lead [N]", ">time [s]")
    return TextTable("least time by the allowed lead, without the joints' accelerations", heads, tuple(rows))


def feed_lines(job: ScheduledJob) -> list[str]:
    """The scheduled sequence's time with its bound, why it is what it is, and what is not in it."""
    from trajopt_cli.iiwa.job.feed_scheduling import SCHEDULED

    made = job.scheduled
    bound = "no lower bound that says anything"
    if made.least is not None and made.gap is not None:
        bound = f"lower bound {made.least:.3f} s, gap {100 * made.gap:.1f} %"
    lines = [
        f"written: {SCHEDULED}, T = {made.duration:.3f} s ({bound}), one pose every {made.h / MM:g} ms",
        f"force if blocked: up to {made.push:.1f} N"
        + (f" and {made.turn_push:.2f} Nm" if made.turn_push > _MOMENT else ""),
    ]
    if job.steady is not None and np.isfinite(job.steady):
        lines.append(
            f"pushing no harder than a spring stretched by the lag: {job.steady / MM:.3g} mm/s on a long line (D v = K"
            " lag); a larger --max-lead, more stiffness, less damping or more lag allow more speed"
        )
    if job.push is not None:
        lines.append(
            f"force on what it touches (springs): up to {job.push.largest:.1f} N, {job.push.programmed:.1f} N as"
            " programmed"
        )
    return [*lines, *job.remarks()]


def ahead_line(opened: Opened) -> str:
    """What to say of a scheduled sequence whose own joints break limits, or are out of reach."""
    away = ""
    if opened.plan is not None:
        most = float(np.max(np.linalg.norm((opened.equilibrium.pose - opened.plan.pose)[:, :3], axis=1)))
        away = f", here up to {most / MM:.3g} mm from plan.csv"
    return (
        f"these are no joints of the arm: an equilibrium that presses or is scheduled lies off it{away}; trajopt iiwa"
        " simulate checks the arm's own"
    )


def failure_lines(findings: Iterable[Finding]) -> list[str]:
    """What failed, one line each; accelerations, which stop no loop, in one line for all joints."""
    failed = [finding for finding in findings if not finding.passed]
    lines = [finding.message for finding in failed if finding.check != "acceleration"]
    quick = [finding for finding in failed if finding.check == "acceleration"]
    if quick:
        worst = max(quick, key=lambda finding: finding.value / finding.limit)
        lines.append(
            f"acceleration limits of {', '.join(one.subject for one in quick)} are broken, worst {worst.subject}"
            f" with {np.degrees(worst.value):.0f}°/s² at t = {worst.time or 0.0:.3f} s, limit"
            f" {np.degrees(worst.limit):.0f}°/s²; profile trapezoid or s-curve with a lower a_max keeps them"
        )
    return lines
