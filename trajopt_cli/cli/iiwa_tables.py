"""What the compliant job's answers look like in a terminal: mm, degrees, and every figure with its unit."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from rich.table import Table

from trajopt_cli.cli.layout import plain_table
from trajopt_cli.findings import Finding
from trajopt_cli.iiwa.task.equilibrium import Equilibrium
from trajopt_cli.units import MM

if TYPE_CHECKING:
    from trajopt_cli.iiwa.controller.feed_limits import Allowed
    from trajopt_cli.iiwa.controller.lag import Lag
    from trajopt_cli.iiwa.controller.stability import AxisStability
    from trajopt_cli.iiwa.job.feed_scheduling import DosedJob
    from trajopt_cli.iiwa.job.folder import Opened
    from trajopt_cli.iiwa.job.simulation import Simulated
    from trajopt_cli.iiwa.task.arm_plan import ArmFigures, ArmPlan
    from trajopt_cli.iiwa.task.joints import Followed
    from trajopt_cli.iiwa.task.model import Route
    from trajopt_cli.iiwa.task.segments import SegmentFacts

_LINES = 40  # segments that are listed one by one
_SEEN = 1e-9  # rad: a smaller turn is rounding
_FELT = 0.005  # Nm: a smaller moment is printed as none
_TURNING = {"rad": "°", "rad/s": "°/s", "rad/s2": "°/s²"}


def segments_table(task: str, facts: Sequence[SegmentFacts]) -> Table:
    """One line per segment; of more than _LINES the least, the mean and the greatest, and what they add up to."""
    if len(facts) > _LINES:
        return _many_segments(task, facts)
    table = plain_table(
        f"{task}: segments",
        *(
            "~from",
            "~to",
            ">length [mm]",
            ">turn [°]",
            ">time [s]",
            ">top speed [m/s]",
            ">top turn rate [°/s]",
            "bound by",
        ),
    )
    for fact in facts:
        table.add_row(
            fact.origin,
            fact.goal,
            f"{fact.L_p / MM:.2f}",
            f"{np.degrees(fact.L_theta):.2f}",
            f"{fact.duration:.3f}",
            f"{fact.v_top:.4f}",
            f"{np.degrees(fact.omega_top):.2f}",
            fact.binds,
        )
    return table


def _many_segments(task: str, facts: Sequence[SegmentFacts]) -> Table:
    table = plain_table(f"{task}: {len(facts)} segments", "", ">least", ">mean", ">greatest", ">all")
    columns = (
        ("length [mm]", [fact.L_p / MM for fact in facts], 2, True),
        ("turn [°]", [np.degrees(fact.L_theta) for fact in facts], 2, True),
        ("time [s]", [fact.duration for fact in facts], 3, True),
        ("dwell [s]", [fact.dwell for fact in facts], 3, True),
        ("top speed [m/s]", [fact.v_top for fact in facts], 4, False),
        ("top turn rate [°/s]", [np.degrees(fact.omega_top) for fact in facts], 2, False),
    )
    for name, values, digits, adds in columns:
        shown = [min(values), sum(values) / len(values), max(values), *([sum(values)] if adds else [])]
        table.add_row(name, *(f"{value:.{digits}f}" for value in shown))
    for name, count in Counter(fact.binds for fact in facts if fact.binds).most_common():
        table.add_row(f"bound by {name}", "", "", "", str(count))
    return table


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
    meaning = {"relative": "from the orientation at the start", "absolute": "from the world's axes"}
    return (
        f"T = {sequence.duration:.3f} s, {len(sequence.pose)} poses, one every {sequence.h / MM:g} ms;"
        f" angles count {meaning[sequence.meaning.value]}; rotation {sequence.rotation.value}"
    )


def joints_table(robot: str, followed: Followed) -> Table:
    """Per joint the worst case of position, speed and acceleration, in degrees."""
    table = plain_table(
        f"{robot}: joints along the sequence, worst case of each check",
        *("check", "joint", ">value", ">limit", ">time [s]", "unit", ""),
    )
    before = None
    for finding in followed.findings:
        if before not in (None, finding.check):
            table.add_section()
        before = finding.check
        table.add_row(
            finding.check,
            finding.subject,
            f"{np.degrees(finding.value):.2f}",
            f"{np.degrees(finding.limit):.2f}",
            "" if finding.time is None else f"{finding.time:.3f}",
            _TURNING.get(finding.unit, finding.unit),
            _verdict(finding),
        )
    return table


def arm_line(followed: Followed) -> str:
    """Which of the arm's ways to reach the poses is taken."""
    # + 0.0 takes the sign off a zero
    least, greatest = (round(np.degrees(end), 2) + 0.0 for end in (followed.arm_angle.min(), followed.arm_angle.max()))
    angle = f"{least:.2f}°" if greatest == least else f"{least:.2f}° to {greatest:.2f}°"
    signs = ", ".join(
        f"joint_{joint} {'< 0' if followed.configuration >> bit & 1 else '>= 0'}" for bit, joint in enumerate((2, 4, 6))
    )
    return f"arm angle {angle} ({followed.definition.value}), configuration {followed.configuration}: {signs}"


def chosen_table(plan: ArmPlan) -> Table:
    """A chosen course of the arm angle beside the fixed one."""
    table = plain_table(f"arm angle chosen for {plan.goal.value}", "over all rows", ">fixed", "", ">chosen", "")
    for row in zip(*(_figures(one) for one in (plan.fixed, plan.best)), strict=True):
        (name, fixed, first), (_, chosen, second) = row
        table.add_row(name, fixed, first, chosen, second)
    return table


def _figures(one: ArmFigures) -> list[tuple[str, str, str]]:
    """What is told of a course: name, value, joint."""

    def joint(index: int) -> str:
        return f"joint_{index + 1}"

    return [
        ("least distance from a limit [°]", f"{np.degrees(one.margin):.2f}", joint(one.near)),
        ("top speed [% of limit]", f"{100 * one.speed:.1f}", joint(one.fast)),
        ("speeds, rms [% of limit]", f"{100 * one.steady:.2f}", ""),
        ("top acceleration [% of limit]", f"{100 * one.acceleration:.1f}", joint(one.abrupt)),
        ("top holding torque [% of range]", f"{100 * one.gravity:.2f}", joint(one.loaded)),
        ("holding torques, rms [% of range]", f"{100 * one.effort:.2f}", ""),
        ("top torque with inertia [% of range]", f"{100 * one.torque:.2f}", joint(one.strained)),
        ("way of the elbow [m]", f"{one.elbow:.3f}", ""),
        ("arm angle turned by [°]", f"{np.degrees(one.turned):.1f}", ""),
        ("positions and speeds", "kept" if one.passes else "BROKEN", ""),
    ]


def chosen_lines(plan: ArmPlan) -> list[str]:
    """How near a chosen course is to the best, and what it was looked for on."""
    grid = f"{len(plan.map.rows)} stages and {len(plan.map.delta)} arm angles {np.degrees(plan.map.cell):.2g}° apart"
    lines = ["distance, top speed and acceleration are without joint_4: the pose alone decides it"]
    if plan.held:
        return [*lines, f"looked for on {grid}"]
    loss = 100 * (plan.cost / plan.grid_cost - 1)
    smoothed = f"{abs(loss):.2f} % {'more' if loss > 0 else 'less'}"
    fixed = f", the fixed arm angle {plan.fixed_cost:.5g}" if plan.fixed.passes else ""
    lines.append(f"cost {plan.cost:.5g}{fixed}; the best course on {grid} {plan.grid_cost:.5g}: smooth is {smoothed}")
    if plan.goal.value == "limits":
        lines.append(f"the best course on the grid stays {np.degrees(plan.grid_margin):.2f}° from limits")
    return lines


def _verdict(finding: Finding) -> str:
    return "ok" if finding.passed else "FAILED"


def stability_table(axes: Iterable[AxisStability], h: float) -> Table:
    """The law per axis; axes of the same numbers share a line."""
    table = plain_table(
        f"the controller's law at {h / MM:g} ms",
        *("~axis", ">K", ">D", ">M", "verdict", ">stable up to", ">damping ratio", ">time constant [s]"),
    )
    groups: dict[tuple[float, float, float], list[AxisStability]] = {}
    for axis in axes:
        groups.setdefault((axis.k, axis.d, axis.m), []).append(axis)
    for (k, d, m), group in groups.items():
        one = group[0]
        table.add_row(
            ", ".join(dict.fromkeys(axis.axis for axis in group)),
            *(f"{value:g}" for value in (k, d, m)),
            one.verdict.name.lower(),
            "any period" if np.isinf(one.h_max) else f"{one.h_max / MM:.3g} ms",
            "" if np.isinf(one.damping_ratio) else f"{one.damping_ratio:.3g}",
            "" if np.isinf(one.slowest) else f"{one.slowest:.3g}",
        )
    return table


def lag_lines(run: Simulated) -> list[str]:
    """How far the controller stays behind, and what its spring pulls with."""
    from trajopt_cli.iiwa.job.simulation import frames_change

    lag = run.lag
    where = f" between {lag.piece.origin} and {lag.piece.goal}" if lag.piece else ""
    lines = [
        f"T = {run.t[-1]:.3f} s (the last pose held for {run.settle:.3g} s), feed {run.feed.value}:"
        f" lag at most {lag.maximum / MM:.2f} mm at {lag.time:.3f} s{where}, {lag.mean / MM:.2f} mm on average"
        + (", counted from plan.csv" if run.opened.plan is not None and not frames_change(run.opened.task) else "")
    ]
    if lag.turn_maximum > _SEEN:
        lines.append(f"turn lag at most {np.degrees(lag.turn_maximum):.2f}° at {lag.turn_time:.3f} s")
    push = float(np.linalg.norm(run.push, axis=1).max())
    law = "K times its way to the equilibrium"
    law += ", and D times the speed that is fed" if run.feed.value == "velocity" else ""
    lines.append(f"held fast there, the tool would push with up to {push:.1f} N ({law})")
    return lines


def contact_lines(run: Simulated) -> list[str]:
    """What the tool ran into."""
    from trajopt_cli.iiwa.job.simulation import touches

    if run.loop is None:
        return ["contact not simulated: the task names no obstacles"] if run.contact is None else []
    fallback = " (MuJoCo is not installed)" if run.fallback else ""
    lines = [f"world: {run.loop.world}{fallback}, the whole loop because of {', '.join(run.why)}"]
    lines += motor_lines(run)
    touch = touches(run)
    if touch is None:
        return [*lines, "the tool touches nothing", *link_lines(run)] if run.contact is not None else lines
    x, y, z = touch.per_axis
    away, own = ([value / MM for value in pose] for pose in (touch.excursion, touch.controller))
    return [
        *lines,
        f"first touch at {touch.first:.3f} s, last at {touch.last:.3f} s, {touch.seconds:.3f} s in contact",
        f"force on the tool up to {touch.force:.2f} N at {touch.force_time:.3f} s"
        f" (x {x:.2f}, y {y:.2f}, z {z:.2f} N), tip up to {touch.depth / MM:.3f} mm deep",
        "tool, as the arm stands, away from the equilibrium while touching, its lag included:"
        f" up to x {away[0]:.2f}, y {away[1]:.2f}, z {away[2]:.2f} mm"
        f" (the controller's own pose: x {own[0]:.2f}, y {own[1]:.2f}, z {own[2]:.2f} mm)",
        *link_lines(run),
    ]


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
    return [
        f"motors: {most.joint} gives up to {most.torque:.1f} Nm, {100 * most.torque / most.limit:.0f} % of its limit;"
        " the others less"
    ]


def loop_time_line(run: Simulated) -> list[str]:
    """What one period of the controller cost here, beside the thesis'."""
    if run.loop is None or not len(run.loop.step_times):
        return []
    from trajopt_cli.iiwa.controller.loop import PARTS

    means = ", ".join(
        f"{name} {1e6 * value:.0f}" for name, value in zip(PARTS, run.loop.step_times.mean(axis=0), strict=True)
    )
    nearly = 1e6 * np.percentile(run.loop.step_times[:, -1], 99.9)
    return [
        f"one period on average [µs]: {means}; 99.9 % within {nearly:.0f} µs here in Python"
        " (the thesis' C++: 148 µs at worst, without a torque model)"
    ]


def dose_table(name: str, job: DosedJob) -> Table:
    """The ways to feed one path, beside each other: as programmed, then timed anew for every feed that was tried."""
    from trajopt_cli.iiwa.controller.feed_schedule import CannotDose
    from trajopt_cli.iiwa.job.feed_scheduling import DOSED

    tried = sorted(job.tried.items(), key=lambda item: list(DOSED).index(item[0]))
    made = [(DOSED[feed], one) for feed, one in tried if not isinstance(one, CannotDose)]
    lags = [*(way.run.lag for way in job.ways), *(one.lag for _, one in made)]
    turns = any(lag.turn_maximum > _SEEN for lag in lags)
    allowed = job.dosed.allowed
    table = plain_table(
        f"{name}: {_allowed(allowed)}",
        *("~fed", ">time [s]", ">least [s]", ">there [s]", ">lag [mm]", ">push [N]"),
        *([">turn lag [°]"] if turns else []),
    )
    rows: list[tuple[str, float, float | None, float | None, Lag, float]] = [
        (way.name, way.run.opened.equilibrium.duration, None, way.arrived, way.run.lag, way.push) for way in job.ways
    ]
    rows += [(label, one.duration, one.least, one.arrived, one.lag, one.push) for label, one in made]
    for label, duration, least, arrived, lag, push in rows:
        table.add_row(
            label,
            f"{duration:.3f}",
            "" if least is None else f"{least:.3f}",
            "not yet" if arrived is None else f"{arrived:.3f}",
            f"{lag.maximum / MM:.3f}",
            f"{push:.1f}",
            *([f"{np.degrees(lag.turn_maximum):.3f}"] if turns else []),
        )
    return table


def front_table(job: DosedJob) -> Table:
    """The least time of every feed by the lead that is allowed."""
    from trajopt_cli.iiwa.job.feed_scheduling import DOSED

    feeds = list(job.front[0].durations)
    stretch = job.front[0].lead.stretch
    heads = (">lead [mm]" if stretch else ">lead [N]", *(f">{DOSED[feed]} [s]" for feed in feeds))
    table = plain_table("least time by what the lead may be, the joints' accelerations not looked at", *heads)
    for point in job.front:
        lead = point.lead.most / MM if stretch else point.lead.most
        times = ("none" if (s := point.durations[feed]) is None else f"{s:.3f}" for feed in feeds)
        table.add_row(f"{lead:.4g}", *times)
    return table


def dose_lines(job: DosedJob) -> list[str]:
    """The dosed sequence's time with its bound, why it is what it is, and what is not in it."""
    from trajopt_cli.iiwa.controller.feed_limits import DoseFeed
    from trajopt_cli.iiwa.controller.feed_schedule import CannotDose
    from trajopt_cli.iiwa.job.feed_scheduling import DOSED

    dosed = job.dosed
    bound = "no lower bound that says anything"
    if dosed.least is not None and dosed.gap is not None:
        bound = f"lower bound of this feed {dosed.least:.3f} s, gap {100 * dosed.gap:.1f} %"
    lines = [
        f"written: {DOSED[dosed.feed]}, T = {dosed.duration:.3f} s ({bound}), one pose every {dosed.h / MM:g} ms",
        f"held by somebody, the tool would begin to push with up to {dosed.push:.1f} N"
        + (f" and {dosed.turn_push:.2f} Nm" if dosed.turn_push > _FELT else ""),
    ]
    if dosed.feed is DoseFeed.POSITION and np.isfinite(job.steady):
        lines.append(
            f"on a long line that lag allows {job.steady / MM:.3g} mm/s, fed positions alone (lag = D v / K);"
            " a larger --max-lead, more stiffness, less damping or more lag buy speed"
        )
    lines += [f"not taken: {reason}" for reason in job.passed_over]
    lines += [
        f"left out: {DOSED[feed]}: {one.message}" for feed, one in job.tried.items() if isinstance(one, CannotDose)
    ]
    if job.left_out:
        lines.append(f"note: dosing does not look at the task's {', '.join(job.left_out)}; simulate does")
    return lines + [f"note: {note}" for note in dosed.notes]


def _allowed(allowed: Allowed) -> str:
    out = f"lag of at most {allowed.lag / MM:g} mm"
    if allowed.turn_lag is not None:
        out += f" and {np.degrees(allowed.turn_lag):g}°"
    if allowed.lead is not None:
        out += (
            f", lead of at most {allowed.lead.most / MM:g} mm"
            if allowed.lead.stretch
            else (f", push of at most {allowed.lead.most:g} N")
        )
    if allowed.turn_lead is not None:
        most = allowed.turn_lead.most
        out += ", push of at most" if allowed.lead is None else " and"
        out += f" {np.degrees(most):g}°" if allowed.turn_lead.stretch else f" {most:g} Nm"
    return out


def ahead_line(opened: Opened) -> str:
    """What to say of a dosed sequence whose own joints break limits, or are out of reach."""
    away = ""
    if opened.plan is not None:
        most = float(np.max(np.linalg.norm((opened.equilibrium.pose - opened.plan.pose)[:, :3], axis=1)))
        away = f", here up to {most / MM:.3g} mm from plan.csv"
    return (
        f"these are no joints of the arm: a dosed equilibrium runs ahead of it{away}; trajopt iiwa simulate checks the"
        " arm's own"
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
