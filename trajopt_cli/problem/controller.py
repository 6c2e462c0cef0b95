"""A cell file held against what the controller's backup says of its mechanics (SYSPAR/MOC.cfg). The cell file counts;
where both differ is told."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import numpy as np

from trajopt_cli.cell.model import Cell
from trajopt_cli.geometry import Array, axis_angle, pose, rotation_from_wxyz
from trajopt_cli.moc import ConfiguredRobot, External, Mechanics, Range, read_moc
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.language.text import decode
from trajopt_cli.rapid.sources import leads_out, syspar_of
from trajopt_cli.robot.model import robot_names
from trajopt_cli.units import DEG
from trajopt_cli.warnings import ProgramWarning, WarningKind
from trajopt_cli.yaml_file import line_of

LETTERS = "abcdef"
_FULL_TYPE = re.compile(r"[A-Z]+\d*_\d\w*_[\d.]+_[\d.]+", re.IGNORECASE)  # with model, reach and payload
_FILE = "moc.cfg"
_LARGEST = 10_000_000  # bytes; a controller's has some ten thousand
_NEAR, _TURNED = 1e-3, 1e-3  # m, rad: frames that are measured and printed differ by that, and ranges by less


def read_mechanics(paths: Sequence[Path]) -> tuple[Mechanics | None, tuple[ProgramWarning, ...]]:
    """What the MOC.cfg of the backup says that a program at these paths lies in, and what of SYSPAR is not read."""
    folder = next((found for path in paths if (found := syspar_of(path)) is not None), None)
    if folder is None:
        return None, ()
    files = sorted(folder.iterdir()) if os.access(folder, os.R_OK) else []
    moc = next((path for path in files if path.name.lower() == _FILE and path.is_file()), None)
    if moc is not None and leads_out(moc, folder.parent):
        return None, (ProgramWarning(WarningKind.NOT_READ, "is a link that leads out of the backup", str(moc)),)
    others = ", ".join(path.name for path in files if path != moc and path.suffix.lower() == ".cfg")
    told: list[ProgramWarning] = []
    if others or moc is None:
        what = "of the controller's parameters only MOC.cfg is read" + ("" if moc else ", which is not there")
        told.append(ProgramWarning(WarningKind.NOT_READ, what + (f"; not: {others}" if others else ""), str(folder)))
    if moc is None:
        return None, tuple(told)
    try:
        if moc.stat().st_size > _LARGEST:
            raise OSError(0, f"larger than {_LARGEST / 1e6:g} MB")
        mechanics = read_moc(decode(moc.read_bytes())[0], str(moc))
    except OSError as error:
        return None, (*told, ProgramWarning(WarningKind.NOT_READ, f"cannot be read: {error.strerror}", str(moc)))
    return mechanics, (*told, *mechanics.notices)


def shipped_robot(kind: str) -> str | None:
    """The robot that ships for a robot type as ABB writes it, irb4600_40_255 for ROB1_4600_2.55_40."""
    _, *parts = kind.lower().split("_")
    if len(parts) < 3 or not parts[1].replace(".", "", 1).isdigit():
        return None
    model, reach, payload = parts[:3]
    size = f"{model}_{payload}_{round(float(reach) * 100)}"
    names = (f"irb{size}", f"irb{model}", f"crb{size}")
    return next((name for name in names if name in robot_names()), None)


def differences(paths: Sequence[Path], cell: Cell, plant: Plant, files: Iterable[str]) -> tuple[ProgramWarning, ...]:
    """Where a cell file differs from the controller's MOC.cfg, by its lines, and what of that was not understood.

    paths: of the program; files: its modules, whose folders tell the task. Empty without a backup.
    """
    mechanics, told = read_mechanics(paths)
    places = " ".join(str(Path(file).resolve()) for file in files)
    if mechanics is None:
        return told
    if (arm := mechanics.robot_of(places)) is None:
        what = "names no robot in a section ROBOT, so the cell file is not held against it"
        return (*told, ProgramWarning(WarningKind.NOT_READ, what, mechanics.file))
    out = [*told]
    if len(mechanics.robots) > 1:
        names = ", ".join(one.name for one in mechanics.robots)
        text = (
            f"the backup has {names}; the cell file is held against {arm.name}, by the task's folder (T_ROB2 for ROB_2)"
        )
        out.append(ProgramWarning(WarningKind.NOT_READ, text, mechanics.place(arm.line)))
    for key, text in (
        *_of_robot(mechanics, arm, cell, plant),
        *_of_rail(mechanics, arm, cell, plant),
        *_of_positioners(mechanics, cell),
    ):
        out.append(ProgramWarning(WarningKind.DOUBTFUL, f"{key}: {text}", f"{cell.file}:{line_of(key, cell.lines)}"))
    return tuple(out)


def wider(lower: float, upper: float, there: Range, slack: float) -> bool:
    """Whether a range goes beyond the controller's."""
    return lower < there.lower - slack or upper > there.upper + slack


def shown(values: Array, digits: int) -> str:
    """Numbers with so many decimals at most, without a sign of zeros."""
    return ", ".join(f"{round(float(x), digits) + 0.0:.9g}" for x in values)


def travel(track: External) -> Array:
    """The direction (3,) in the world in which a track's position grows: x of its base frame."""
    return np.asarray(track.X[:3, 0])


def _of_robot(mechanics: Mechanics, arm: ConfiguredRobot, cell: Cell, plant: Plant) -> Iterator[tuple[str, str]]:
    robot = plant.robot
    kind, own = shipped_robot(arm.type), robot.name.removesuffix("_rail")
    if robot.name in robot_names() and own != kind and (kind is not None or _FULL_TYPE.match(arm.type)):
        its = f"{arm.type}, {kind or 'which does not ship'} ({mechanics.place(arm.line)})"
        yield "robot", f"{robot.name}, the controller's {arm.name} is {its}"
    joints = zip(robot.axis_names[-6:], plant.limits.lower[-6:], plant.limits.upper[-6:], arm.ranges, strict=True)
    beyond: dict[str, list[str]] = {}
    for name, lower, upper, there in joints:
        if there is not None and wider(lower, upper, there, _TURNED):
            own, its = (f"{low / DEG:.6g}..{high / DEG:.6g}" for low, high in ((lower, upper), there[:2]))
            key = f"limits.{name}" if f"limits.{name}" in cell.lines else "limits" if cell.overrides else "robot"
            beyond.setdefault(key, []).append(f"{name} {own} deg, there {its} deg ({mechanics.place(there.line)})")
    for key, parts in beyond.items():
        yield key, f"joints may go beyond the controller's ranges: {'; '.join(parts)}; set lower and upper under limits"
    key = "rail.frame" if cell.rail is not None else "base"
    at = " with the rail at 0" if cell.rail is not None else ""
    its = f"of {arm.name} ({mechanics.place(arm.line)})"
    yield from _of_frame(key, f"the arm's base{at}", robot.X_WB0, arm.X, its)


def _of_frame(key: str, name: str, X: Array, there: Array, its: str) -> Iterator[tuple[str, str]]:
    """Where a frame X (4, 4) differs from the controller's; its: whose that is."""
    if np.linalg.norm(there[:3, 3] - X[:3, 3]) > _NEAR:
        own, other = shown(X[:3, 3], 6), shown(there[:3, 3], 6)
        yield key, f"{name} stands at [{own}] m, that {its} at [{other}] m"
    _, angle = axis_angle(X[:3, :3].T @ there[:3, :3])
    if abs(angle) > _TURNED:
        yield key, f"{name} is turned by {abs(angle) / DEG:.4g} deg from that {its}"


def _of_rail(mechanics: Mechanics, arm: ConfiguredRobot, cell: Cell, plant: Plant) -> Iterator[tuple[str, str]]:
    track, robot, rail = arm.track, plant.robot, cell.rail
    slides = [one for one in mechanics.externals if one.slides]
    if cell.axes:  # which of its units carry which is not read
        return
    if rail is None:
        if track is not None:
            yield "robot", f"there is no rail, {arm.name} stands on {track.name} ({mechanics.place(track.line)})"
        return
    if track is None:
        names = ", ".join(f"{one.name} ({mechanics.place(one.line)})" for one in slides)
        what = f"{names} does not move it" if slides else "no unit slides"
        moved = f"its base frame is moved by {arm.moved_by}" if arm.moved_by else "nothing moves its base frame"
        yield "rail", f"{arm.name} stands on no track: {moved}, {what} ({mechanics.place(arm.line)})"
        return
    place = mechanics.place(track.line)
    if track.eax is not None and track.eax != rail.eax:
        its = f"eax_{LETTERS[track.eax]} ({mechanics.place(track.eax_line)})"
        yield "rail.eax", f"{LETTERS[rail.eax]}, {track.name} is driven by {its}"
    if (there := track.range) is not None and wider(*rail.stroke, there, 1e-6):
        (low, high), at = rail.stroke, mechanics.place(there.line)
        beyond = f"{low:g}..{high:g} m goes beyond what the controller allows {track.name}"
        yield "rail.stroke", f"{beyond}, {there.lower:g}..{there.upper:g} m ({at}); set the stroke to that"
    if np.linalg.norm(robot.rail_axes_W[0] - travel(track)) > _TURNED * 10:
        own, its = shown(robot.rail_axes_W[0], 4), shown(travel(track), 4)
        yield "rail.frame", f"the rail runs along [{own}] of the world, {track.name} along [{its}] ({place})"
    for kind, its_limit in (("velocity", track.velocity), ("acceleration", track.acceleration)):
        value = float(getattr(plant.limits, kind)[0])
        if its_limit is not None and value > its_limit * (1 + 1e-3):
            text = f"{kind} {value:.4g}, the controller has {its_limit:.4g} for {track.name} ({place})"
            yield ("limits.rail" if "limits.rail" in cell.lines else "rail"), text


def _of_positioners(mechanics: Mechanics, cell: Cell) -> Iterator[tuple[str, str]]:
    own = {one.name.lower(): one for one in mechanics.externals}
    for name, axes in cell.scenario.positioners.items():
        there = own.get(name)
        if there is None or len(axes) != 1:
            continue
        (axis,), place = axes, mechanics.place(there.line)
        key = f"positioners.{name}"
        if there.eax is not None and there.eax != axis.eax:
            its = f"the controller has eax_{LETTERS[there.eax]} ({mechanics.place(there.eax_line)})"
            yield key, f"eax {LETTERS[axis.eax]}, {its}"
        if not there.moved_by:
            X = pose(rotation_from_wxyz(axis.q), axis.p)
            yield from _of_frame(key, "its frame", X, there.X, f"of {there.name} ({place})")
        if there.range is not None and there.slides is False and wider(*axis.range, there.range, _TURNED):
            its = f"{there.range.lower:g}..{there.range.upper:g} rad ({mechanics.place(there.range.line)})"
            yield key, f"range {axis.range[0]:g}..{axis.range[1]:g} rad goes beyond the controller's {its}"
