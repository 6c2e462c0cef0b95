"""What `robot show` and `robot add` tell of a robot: tables for people, plain data for programs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from trajopt_cli.errors import printable
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.table import TextTable
from trajopt_cli.units import DEG, MM, slides, unit_of

if TYPE_CHECKING:
    from trajopt_cli.adopt.add import NewRobot

_LENGTHS = {
    "a1": "axis 2 in front of axis 1",
    "a2": "axis 3 above axis 4, upper arm forward",
    "b": "arm's plane left of axis 1",
    "c1": "axis 2 above the base",
    "c2": "axis 2 to axis 3",
    "c3": "axis 3 to the wrist centre, along axis 4; to axis 4 where it is parallel to axis 3",
    "c4": "wrist centre to the flange",
    "wrist along": "axis 6 beside axis 4, along axis 5",
    "wrist across": "axis 6 above axis 4, at right angles to axis 5",
    "axis 5 off axis 4": "axis 5 beside axis 4",
    "wrist along axis 5": "axis 4 to where axes 5 and 6 meet, along axis 5",
    "bs": "base to shoulder",
    "se": "shoulder to elbow",
    "ew": "elbow to wrist centre",
    "wf": "wrist centre to the flange",
}


def robot_record(robot: RobotModel | SrsRobot) -> dict[str, Any]:
    """A robot as plain data, SI, with the source of every number."""
    record: dict[str, Any] = {
        "name": robot.name,
        "title": robot.title,
        "axes": list(robot.axis_names),
        "lengths_m": _lengths(robot),
        "profiles": {name: _limits_record(limits) for name, limits in robot.profiles.items()},
        "notes": dict(robot.notes),
    }
    if isinstance(robot, SrsRobot):
        joints = ("torque_nm", robot.torque), ("damping_nm_s_rad", robot.damping), ("friction_nm", robot.friction)
        return record | {name: [float(value) for value in values] for name, values in joints}
    record["coupled"] = [asdict(one) for one in robot.profile().coupled]
    record["linkage"] = robot.linkage
    record["settle"] = None if robot.settle is None else robot.settle._asdict()
    return record | {"tcp": {"speed_m_s": robot.tcp.speed, "acceleration_m_s2": robot.tcp.acceleration}}


def _lengths(robot: RobotModel | SrsRobot) -> dict[str, float]:
    """An arm's lengths [m] by name."""
    return asdict(robot.lengths) if isinstance(robot, SrsRobot) else robot.arm.lengths


def _limits_record(limits: JointLimits) -> dict[str, Any]:
    columns = {name: getattr(limits, name) for name in ("lower", "upper", "velocity", "acceleration")}
    columns |= {"acceleration_most": limits.most_acceleration, "jerk": limits.jerk}
    rows = {
        axis: {name: None if values is None else float(values[i]) for name, values in columns.items()}
        for i, axis in enumerate(limits.names)
    }
    record: dict[str, Any] = {"axes": rows, "sources": dict(limits.sources)}
    record["acceleration_by_posture_of"] = [] if limits.table is None else list(limits.table.over)
    return record | ({"coupled": [asdict(one) for one in limits.coupled]} if limits.coupled else {})


def robot_tables(robot: RobotModel | SrsRobot) -> Iterator[TextTable | str]:
    """Everything trajopt knows of a robot: dimensions, ranges, speeds, every profile's accelerations and jerks."""
    notes = _Footnotes()
    yield f"{robot.name}: {robot.title}"
    yield ""
    mark = notes.mark(robot.notes["geometry"])
    lengths = ((name, f"{value / MM:.6g}", mark) for name, value in _lengths(robot).items())
    yield TextTable("dimensions", ("length", ">mm", "source"), tuple(lengths))
    yield _ranges(robot.profile(), notes)
    if robot.profile().coupled:
        rows = tuple(_sums(robot.profile(), notes))
        yield TextTable("ranges of axes together", ("sum", ">from", ">to", "unit", "source"), rows)
    if isinstance(robot, RobotModel) and robot.linkage:
        _, lower, upper, *_ = robot.axis_names[robot.layout.arm]
        mark, sign = notes.mark(robot.notes[f"{upper}.linkage"]), "-" if robot.linkage > 0 else "+"
        yield f"parallel linkage {mark}: {upper} is the controller's axis 3, the upper arm's angle against the base, in"
        yield f"programs, logs and joint CSV; the URDF's {upper} is {upper} {sign} {lower}"
        yield ""
    yield _by_profile("acceleration", "²", robot.profiles, notes)
    with_jerk = {name: limits for name, limits in robot.profiles.items() if limits.jerk is not None}
    if with_jerk:
        yield _by_profile("jerk", "³", with_jerk, notes)
    if isinstance(robot, SrsRobot):
        yield from _bodies(robot, notes)
    else:
        yield from _drives(robot, notes)
        yield from _caps(robot, notes)
        if robot.settle is not None:
            fine, inpos, source, _ = robot.settle
            yield f"settling before waits and signals {notes.mark(source)}: fine {fine:g} s, inpos {inpos:g} s"
            yield ""
    for name in robot.profiles:
        load = robot.notes.get(f"profiles.{name}.load")
        yield f"profile {name}: {robot.notes[f'profiles.{name}']}{f'; found with {load}' if load else ''}"
    yield from notes.lines()


def _drives(robot: RobotModel, notes: _Footnotes) -> Iterator[TextTable]:
    """What the drives give and how heavy they are, and the links' masses, where the robot's files say it."""
    limits = robot.profile()
    if limits.torque is None:
        return
    rows = []
    for name, torque, rotor in zip(robot.axis_names, limits.torque, robot.rotor, strict=True):
        units = ("N", "kg") if slides(name) else ("Nm", "kg m²")
        given = [""] * 3
        if np.isfinite(torque):
            given = [f"±{torque:g}", units[0], notes.mark(limits.sources[f"{name}.torque"])]
        has = [f"{rotor:g}", units[1], notes.mark(robot.notes[f"{name}.rotor"])] if rotor else [""] * 3
        rows.append((name, *given, *has))
    yield TextTable("drives", ("axis", ">torque", "unit", "source", ">rotor", "unit", "source"), tuple(rows))
    if "inertia" in robot.notes:
        yield _masses(robot, list(robot.pin_model.inertias)[1:][robot.layout.arm], notes)


def _caps(robot: RobotModel, notes: _Footnotes) -> Iterator[TextTable]:
    """What the data sheet grants the tool centre point."""
    given = (("speed", robot.tcp.speed, "m/s"), ("acceleration", robot.tcp.acceleration, "m/s²"))
    rows = ((name, f"{value:g}", unit, notes.mark(robot.notes[f"tcp.{name}"])) for name, value, unit in given)
    yield TextTable("tool centre point", ("cap", ">value", "unit", "source"), tuple(rows))


def _bodies(robot: SrsRobot, notes: _Footnotes) -> Iterator[TextTable]:
    """What joints give and lose; masses and centres of mass of the links, in the links' frames."""
    heads = (">torque, sensor's range [Nm]", "source", ">damping [Nm s/rad]", "source", ">friction [Nm]", "source")
    rows = []
    for axis, torque, *losses in zip(robot.axis_names, robot.torque, robot.damping, robot.friction, strict=True):
        row = [f"±{torque:g}", notes.mark(robot.notes[f"{axis}.torque"])]
        for name, value in zip(("damping", "friction"), losses, strict=True):
            source = robot.notes.get(f"{axis}.{name}")
            row += [f"{value:g}", notes.mark(source)] if source else ["", ""]
        rows.append((axis, *row))
    yield TextTable("torques of motors and joints", ("axis", *heads), tuple(rows))
    yield _masses(robot, list(robot.pin_model.inertias)[1:], notes)


def _masses(robot: RobotModel | SrsRobot, bodies: Sequence[Any], notes: _Footnotes) -> TextTable:
    """Masses and centres of mass of the links, in the links' frames."""
    mark = notes.mark(robot.notes["inertia"])
    rows = (
        (link, f"{body.mass:.4g}", *(f"{value / MM:.4g}" for value in body.lever), mark)
        for link, body in zip(robot.link_names[1:], bodies, strict=True)
    )
    return TextTable("links", ("link", ">mass [kg]", ">centre x [mm]", ">y", ">z", "source"), tuple(rows))


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
        yield ""
        yield "grades: A several sources agree, B one good source, C a weak one or inferred, D an estimate"
        for source, number in self._numbers.items():
            yield f"[{number}] {source}"


def _ranges(limits: JointLimits, notes: _Footnotes) -> TextTable:
    rows: list[tuple[str, ...]] = []
    for i, axis in enumerate(limits.names):
        factor, unit = unit_of(axis)
        low, high, speed = (f"{values[i] / factor:.6g}" for values in (limits.lower, limits.upper, limits.velocity))
        marks = [notes.mark(limits.sources[f"{axis}.{kind}"]) for kind in ("position", "velocity")]
        rows.append((axis, low, high, unit, marks[0], speed, f"{unit}/s", marks[1]))
    rows += [(*row, "", "", "") for row in _sums(limits, notes)]
    heads = ("axis", ">from", ">to", "unit", "source", ">speed", "unit", "source")
    return TextTable("ranges and speeds", heads, tuple(rows))


def _sums(limits: JointLimits, notes: _Footnotes) -> Iterator[tuple[str, ...]]:
    for one in limits.coupled:
        low, high = (f"{value / DEG:.6g}" for value in (one.lower, one.upper))
        yield one.name, low, high, "deg", notes.mark(one.source)


def _by_profile(kind: str, power: str, profiles: Mapping[str, JointLimits], notes: _Footnotes) -> TextTable:
    columns = [column for name in profiles for column in (f">{name}", "source")]
    rows = []
    for i, axis in enumerate(next(iter(profiles.values())).names):
        cells = []
        for limits in profiles.values():
            low = high = getattr(limits, kind)[i]
            if kind == "acceleration":  # depends on posture
                high = limits.most_acceleration[i]
            value = f"{low:g}" if low == high else f"{low:g} to {high:g}"
            cells += [value, notes.mark(limits.sources[f"{axis}.{kind}"])]
        rows.append((axis, f"m/s{power}" if slides(axis) else f"rad/s{power}", *cells))
    return TextTable(f"{kind}s by profile", ("axis", "unit", *columns), tuple(rows))


def new_robot_record(made: NewRobot, robot: RobotModel | SrsRobot) -> dict[str, Any]:
    """What was read of a URDF, SI."""
    X = robot.forward(np.zeros(len(robot.axis_names)))
    axes = [
        {"name": one.name, "in_urdf": made.chain.named[one.name], "lower": one.lower, "upper": one.upper,
         "velocity": one.velocity}
        for one in made.chain.axes
    ]  # fmt: skip
    return {
        "name": made.name,
        "base": made.chain.base,
        "tip": made.chain.tip,
        "confdata": made.confdata,
        "axes": axes,
        "lengths_m": _lengths(robot),
        "flange_at_zero_m": X[:3, 3].tolist(),
        "flange_z_at_zero": X[:3, 2].tolist(),
        "bodies": {link: len(parts) for link, parts in made.bodies.items()},
        "self_pairs": [list(pair) for pair in made.pairs],
        "meshes_missing": list(made.missing),
        "notes": list(made.chain.notes),
    }


def new_robot_tables(made: NewRobot, robot: RobotModel | SrsRobot) -> Iterator[TextTable | str]:
    """What was read of a URDF, and what is guessed, for people."""
    chain = made.chain
    yield f"{made.name}: from {chain.base} to {chain.tip} of {chain.tree.path}"
    yield ""
    rows = []
    for joint in chain.axes:
        factor, unit = (MM, "mm") if joint.kind == "prismatic" else (DEG, "deg")
        figures = [f"{value / factor:.6g}" for value in (joint.lower, joint.upper, joint.velocity)]
        rows.append((joint.name, chain.named[joint.name], *figures[:2], unit, figures[2], f"{unit}/s"))
    yield TextTable("axes", ("axis", "in the URDF", ">from", ">to", "unit", ">speed", "unit"), tuple(rows))
    lengths = ((what, f"{value / MM:.6g}", _LENGTHS[what]) for what, value in _lengths(robot).items())
    yield TextTable("dimensions", ("length", ">mm", "what it is"), tuple(lengths))
    six = chain.turning == 6
    if not getattr(robot, "closed_form", True):
        yield "axes 4, 5 and 6 do not meet in one point: configurations are sought step by step, so planning takes"
        yield "minutes, and no nonlinear program improves the plan"
        yield ""
    X = robot.forward(np.zeros(len(robot.axis_names)))
    X = np.where(np.abs(X) < 1e-9, 0.0, X)
    place, out, ahead = (" ".join(f"{v + 0.0:.6g}" for v in row) for row in (X[:3, 3] / MM, X[:3, 2], X[:3, 0]))
    yield f"with all axes at 0 the flange is at {place} mm, its z along {out}, its x along {ahead}: hold that against"
    yield "the robot or its data sheet"
    yield ""
    if six:
        yield f"confdata: {made.confdata}" + (
            ", so the confdata of targets is not looked at"
            if made.confdata == "none"
            else "; --confdata none where it is not ABB's"
        )
    yield f"bodies: {', '.join(made.bodies) or 'none, so self-collision and obstacles are not looked at'}"
    if made.bodies and (bare := [name for name in robot.link_names if name not in made.bodies]):
        yield f"no bodies: {', '.join(bare)}, which may touch anything unseen"
    for line in (*made.missing, *chain.notes):
        yield f"note: {printable(line)}"
    guesses = "accelerations, jerks" + (", tcp caps" if six else "")
    yield f"guessed, marked REPLACE in {made.name}.yaml: {guesses}"
