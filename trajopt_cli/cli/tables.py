"""The tables a person reads, and the records behind them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict

from rich.table import Table

from trajopt_cli.cli.layout import place, plain_table
from trajopt_cli.cli.listing import shortened
from trajopt_cli.findings import Finding, Report, good_side, nearest
from trajopt_cli.limits import JointLimits
from trajopt_cli.pipeline.optimise import Optimised
from trajopt_cli.problem.constant_speed import DIP, Dip, Stretch, Why
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.runs.results import motion_label
from trajopt_cli.units import DEG, MM

_NAME = 50  # characters of a motion's name: many targets are written in numbers
_DIPS = 10  # of constant speed, in text; summary.json has them all


def cycle_line(label: str, plan: Plan) -> str:
    """A duration with its bound, gap and grid; of a gentle plan its strain beside that of the fastest."""
    bound = "" if plan.gap is None else f" (lower bound {plan.lower_bound:.3f} s, gap {100 * plan.gap:.1f} %)"
    if plan.eased is None:
        return f"{label}: T = {plan.duration:.3f} s{bound}, grid {plan.grid}"
    now, fast = plan.eased.planned, plan.eased.fastest
    rail = f", rail {now.rail_way:.3f} m" if fast.rail_way else ""
    before = f", rail {fast.rail_way:.3f} m" if fast.rail_way else ""
    return (
        f"{label}: T = {plan.duration:.3f} s, effort {now.effort:.3f} s{rail}; fastest found T = "
        f"{plan.eased.least_time:.3f} s{bound}, effort {fast.effort:.3f} s{before}; grid {plan.grid}"
    )


def saving_line(answer: Optimised) -> str:
    """The answer in one line: as written, and what the plans make of it."""
    plans = [answer.judged[one].plan for one in (Target.STREAM, Target.RAPID)]
    names = ("as a joint stream", "by the RAPID controller")
    before = answer.written
    if isinstance(before, str):
        told = ", ".join(f"{plan.duration:.3f} s {name}" for plan, name in zip(plans, names, strict=True))
        return f"as written it cannot be driven ({before}) → {told}"
    told = ", ".join(
        f"{plan.duration:.3f} s ({change(before.duration, plan.duration)}) {name}"
        for plan, name in zip(plans, names, strict=True)
    )
    return f"as written {before.duration:.3f} s → {told}"


def speed_lines(label: str, stretches: Sequence[Stretch]) -> Iterator[str]:
    """How well a plan keeps the programmed speed where it should: one line in all, and one for each place where it does
    not, the same in several passes said once."""
    if not stretches:
        return
    dips = [dip for stretch in stretches for dip in stretch.dips]
    far = f"{sum(stretch.length for stretch in stretches) / MM:.1f} mm"
    found = f"constant speed ({label}): {far} in {_count(len(stretches), 'stretch', 'es')}"
    if not dips:
        yield f"{found}, kept within {100 * DIP:g} %"
        return
    short = f"{sum(dip.length for dip in dips) / MM:.1f} mm and {sum(dip.duration for dip in dips):.3f} s"
    yield f"{found}, kept within {100 * DIP:g} % but for {_count(len(dips), 'dip')} of {short}"
    groups: dict[tuple[object, ...], list[Dip]] = {}
    for dip in dips:
        groups.setdefault((dip.source, dip.why, dip.detail), []).append(dip)
    for group in list(groups.values())[:_DIPS]:
        yield f"  {_dip(max(group, key=lambda dip: dip.duration), len(group) - 1)}"
    if more := len(dips) - sum(len(group) for group in list(groups.values())[:_DIPS]):
        yield f"  and {more} more, all in summary.json"


def _dip(dip: Dip, others: int) -> str:
    low = f"reaches {dip.highest / MM:.4g}" if dip.why is Why.SHORT else f"{dip.lowest / MM:.4g}"
    speed = f"{low} of {dip.programmed / MM:.4g} mm/s"
    depth = "" if dip.why is Why.SHORT else f" (−{dip.depth:.0%})".replace("%", " %")
    more = f" ({others} more times)" if others > 1 else " (once more)" if others else ""
    where = f"{place(dip.source)} {shortened(dip.name, _NAME)} at {dip.along / MM:.1f} mm"
    return f"{where}: {speed}{depth}, for {dip.duration:.3f} s and {dip.length / MM:.1f} mm: {dip.cause}{more}"


def _count(number: int, what: str, plural: str = "s") -> str:
    return f"{number} {what}{plural if number > 1 else ''}"


def change(before: float, after: float) -> str:
    """What becomes of a time, in per cent: "−26.5 %"."""
    percent = f"{100 * (after / before - 1):+.1f}" if before > 0 else "+0.0"
    return f"{percent.replace('-', '−')} %"


def motions_table(answer: Optimised) -> Table:
    """Every motion as written and on both targets; binding limits are those of the target in trajectory.csv."""
    program, chosen, before = answer.job.program, answer.target, answer.written
    table = plain_table(
        f"{answer.job.program_path} on {answer.job.plant.robot.name}",
        *(
            "place",
            "instruction",
            "target",
            ">written [s]",
            ">stream [s]",
            ">rapid [s]",
            f"what limits the {chosen.value} plan",
        ),
    )
    plans = {one: answer.judged[one].plan for one in Target}
    for i, motion in enumerate(plans[chosen].motions):
        instruction, name = motion_label(program, motion.index)
        times = ["-" if isinstance(before, str) else f"{before.motions[i].t_1 - before.motions[i].t_0:.3f}"]
        for one in (Target.STREAM, Target.RAPID):
            planned = plans[one].motions[i]
            times.append("dropped" if planned.dropped else f"{planned.t_1 - planned.t_0:.3f}")
        table.add_row(place(motion.source), instruction, name, *times, motion.binding)
    table.add_section()
    totals = ["-" if isinstance(before, str) else f"{before.duration:.3f}"]
    totals += [f"{plans[one].duration:.3f}" for one in (Target.STREAM, Target.RAPID)]
    table.add_row("cycle", "", "", *totals, "")
    return table


def findings_table(name: str, report: Report, everything: bool) -> Table:
    """The judge's legality checks: of every check the case nearest to its limit, or all cases."""
    return _findings(f"{name}: legality", report.findings, everything)


def advice_table(name: str, report: Report, everything: bool) -> Table:
    """What else the judge noticed; it decides nothing."""
    return _findings(f"{name}: advice, which does not affect the verdict", report.advice, everything)


def _findings(title: str, findings: tuple[Finding, ...], everything: bool) -> Table:
    table = plain_table(
        title, "check", ">cases", "of", ">worst value", ">limit", ">margin", "unit", ">time [s]", "place", ""
    )
    shown = [(one, 1) for one in findings] if everything else nearest(findings)
    for worst, count in shown:
        table.add_row(
            worst.check,
            str(count),
            worst.subject,
            _figure(worst.value, 6),
            _figure(worst.limit, 6),
            _figure(good_side(worst), 3),
            worst.unit,
            "" if worst.time is None else f"{worst.time:.4f}",
            place(worst.source),
            "ok" if worst.passed else "NO",
        )
    return table


def _figure(value: float, digits: int) -> str:
    return f"{value:.{digits}g}" if math.isfinite(value) else "-"


def verdict(name: str, report: Report) -> str:
    """One line: legal or not, and by how many findings."""
    bad = sum(not finding.passed for finding in report.findings)
    return f"{name}: legal ({len(report.findings)} checks)" if not bad else f"{name}: ILLEGAL ({bad} checks failed)"


def robot_tables(robot: RobotModel | SrsRobot) -> Iterator[Table | str]:
    """Everything trajopt knows of a robot: dimensions, ranges, speeds, every profile's accelerations and jerks."""
    notes = _Footnotes()
    yield f"{robot.name}: {robot.title}\n"
    lengths = plain_table("dimensions", "length", ">mm", "source")
    for name, value in asdict(robot.lengths if isinstance(robot, SrsRobot) else robot.arm).items():
        lengths.add_row(name, f"{value / MM:.6g}", notes.mark(robot.notes["geometry"]))
    yield lengths
    yield _ranges(robot.profile("default"), notes)
    yield _by_profile("acceleration", "²", robot.profiles, notes)
    with_jerk = {name: limits for name, limits in robot.profiles.items() if limits.jerk is not None}
    if with_jerk:
        yield _by_profile("jerk", "³", with_jerk, notes)
    yield from _bodies(robot, notes) if isinstance(robot, SrsRobot) else _caps(robot, notes)
    for name in robot.profiles:
        yield f"profile {name}: {robot.notes[f'profiles.{name}']}"
    yield from notes.lines()


def _caps(robot: RobotModel, notes: _Footnotes) -> Iterator[Table]:
    """What the data sheet grants the tool centre point."""
    caps = plain_table("tool centre point", "cap", ">value", "unit", "source")
    caps.add_row("speed", f"{robot.tcp.speed:g}", "m/s", notes.mark(robot.notes["tcp.speed"]))
    caps.add_row("acceleration", f"{robot.tcp.acceleration:g}", "m/s²", notes.mark(robot.notes["tcp.acceleration"]))
    yield caps


def _bodies(robot: SrsRobot, notes: _Footnotes) -> Iterator[Table]:
    """What joints give and lose; masses and centres of mass of the links, in the links' frames."""
    heads = (">torque, sensor's range [Nm]", "source", ">damping [Nm s/rad]", "source", ">friction [Nm]", "source")
    torques = plain_table("torques of motors and joints", "axis", *heads)
    for axis, torque, *losses in zip(robot.axis_names, robot.torque, robot.damping, robot.friction, strict=True):
        row = [f"±{torque:g}", notes.mark(robot.notes[f"{axis}.torque"])]
        for name, value in zip(("damping", "friction"), losses, strict=True):
            source = robot.notes.get(f"{axis}.{name}")
            row += [f"{value:g}", notes.mark(source)] if source else ["", ""]
        torques.add_row(axis, *row)
    yield torques
    masses = plain_table("links", "link", ">mass [kg]", ">centre x [mm]", ">y", ">z", "source")
    model = robot.pin_model
    for link, body in zip(robot.link_names[1:], list(model.inertias)[1:], strict=True):
        centre = (f"{value / MM:.4g}" for value in body.lever)
        masses.add_row(link, f"{body.mass:.4g}", *centre, notes.mark(robot.notes["inertia"]))
    yield masses


class _Footnotes:
    """Sources by number, each once."""

    def __init__(self) -> None:
        self._numbers: dict[str, int] = {}

    def mark(self, source: str) -> str:
        """The number of a source, with its grade: "A [2]"."""
        number = self._numbers.setdefault(source, len(self._numbers) + 1)
        grade = source[-2] if source.endswith(")") and "(grade " in source else "?"
        return f"{grade} [{number}]"

    def lines(self) -> Iterator[str]:
        """A line per source."""
        yield "\ngrades: A several sources agree, B one good source, C a weak one or inferred, D an estimate"
        for source, number in self._numbers.items():
            yield f"[{number}] {source}"


def _unit(axis: str) -> tuple[float, str]:
    """How many SI units one shown unit has, and its name."""
    return (MM, "mm") if axis == "rail" else (DEG, "deg")


def _ranges(limits: JointLimits, notes: _Footnotes) -> Table:
    table = plain_table("ranges and speeds", "axis", ">from", ">to", "unit", "source", ">speed", "unit", "source")
    for i, axis in enumerate(limits.names):
        factor, unit = _unit(axis)
        low, high, speed = (f"{values[i] / factor:.6g}" for values in (limits.lower, limits.upper, limits.velocity))
        marks = [notes.mark(limits.sources[f"{axis}.{kind}"]) for kind in ("position", "velocity")]
        table.add_row(axis, low, high, unit, marks[0], speed, f"{unit}/s", marks[1])
    return table


def _by_profile(kind: str, power: str, profiles: Mapping[str, JointLimits], notes: _Footnotes) -> Table:
    columns = [column for name in profiles for column in (f">{name}", "source")]
    table = plain_table(f"{kind}s by profile", "axis", "unit", *columns)
    for i, axis in enumerate(next(iter(profiles.values())).names):
        cells = []
        for limits in profiles.values():
            cells += [f"{getattr(limits, kind)[i]:g}", notes.mark(limits.sources[f"{axis}.{kind}"])]
        table.add_row(axis, f"m/s{power}" if axis == "rail" else f"rad/s{power}", *cells)
    return table
