"""verify(): a program, a plant and rows of joint positions in; findings about their legality, and advice, out."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.findings import Finding, Report
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge.advice import advise
from trajopt_cli.judge.caps import check_caps
from trajopt_cli.judge.clearance import check_clearance
from trajopt_cli.judge.demands import check_demands
from trajopt_cli.judge.findings import finding, in_step
from trajopt_cli.judge.followers import check_targets, without_followers
from trajopt_cli.judge.joints import check_joints
from trajopt_cli.judge.lines import check_shapes
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.mechanism import mechanism_of
from trajopt_cli.judge.nearest import check_nearest
from trajopt_cli.judge.positioners import check_columns, check_tables, turned_frames
from trajopt_cli.judge.program_points import may_drop, points_of
from trajopt_cli.judge.rail_hold import check_held
from trajopt_cli.judge.resolution import check_resolution, granted_clearance, grid_resolution
from trajopt_cli.judge.samples import PIECE, judged_rows
from trajopt_cli.judge.scene import legs_of, shape_of
from trajopt_cli.judge.stops import check_stops
from trajopt_cli.judge.timeline import build_timeline
from trajopt_cli.judge.tool_kinematics import ToolKinematics
from trajopt_cli.judge.torques import check_torques
from trajopt_cli.judge.waypoint_matching import match, never_near
from trajopt_cli.motion import Program
from trajopt_cli.problem.plan import Target
from trajopt_cli.sheet import missing_rows
from trajopt_cli.trajectory import Trajectory


def verify(
    program: Program,
    plant: Machine,
    trajectory: Trajectory,
    resolution: Resolution | None = None,
    dropped: Collection[int] | None = None,
    target: Target | None = None,
    advice: bool = True,
    as_written: bool = False,
) -> Report:
    """Judge a joint motion of the whole program. Report.legal decides; advice says what a line could still gain.

    resolution: printed step of the file, None when every digit is there. dropped: indices of motions the plan left
    out; None: unknown, optional motions may be missing. target rapid: also what a RAPID controller makes of it, every
    axis at rest at every stop, MoveJ straight in the joints, the rail in proportion to the path of a line.
    as_written: nothing of the program was changed, so confdata that is switched off has the nearest posture.
    advice False leaves the libraries out, for those who only ask for legality.

    Raises InputError when the file's axes are not the robot's, or its rows are no motion: fewer than two, a time that
    does not follow the one before, a number that is not finite.
    """
    names, given = mechanism_of(plant).names, trajectory
    trajectory, resolution, led = without_followers(plant, given, resolution)
    if trajectory.names != names:
        raise InputError(f"the file's axes are {', '.join(trajectory.names)}; the robot's are {', '.join(names)}")
    _check_rows(given.whole)
    check_columns(program, trajectory, dropped or (), plant)
    points = points_of(program, plant, dropped or (), optional=dropped is None)
    rows = judged_rows(plant, trajectory, resolution, marks=len(points) - 1)
    rapid = target is Target.RAPID
    frames = {
        key: ToolKinematics(rows, X_FT) for key, X_FT in {np.asarray(p.X_FT).tobytes(): p.X_FT for p in points}.items()
    }
    if dropped is None and (absent := never_near(rows, frames, points)):  # zones reach from point to point
        points = points_of(program, plant, absent, optional=True)
    line = build_timeline(rows, frames, points[0], match(rows, frames, points, rapid), rapid)
    line = replace(line, turned=turned_frames(frames, line))
    stops, shapes, caps, demands = in_step(
        check_stops(line, frames, rapid, None if program.before is None else trajectory.q[-1]),
        check_shapes(line, frames, rapid),
        check_caps(line, frames, rapid),
        check_demands(line, frames),
    )
    legs = legs_of(program, plant, line.visits, len(trajectory.t) - 1)
    carried = {shape_of(solid) for leg in legs for solid in leg.carried}
    findings = [
        *check_resolution(line, frames, frames[np.asarray(points[0].X_FT).tobytes()]),
        *_dropped(program, plant, dropped or ()),
        *stops,
        *shapes,
        *(check_nearest(line) if as_written else ()),
        *check_held(line, frames),
        *led,
        *check_targets(program, plant),
        *check_joints(rows, line.source_at),
        *check_torques(program, line),
        *check_tables(program, line),
        *caps,
        *demands,
        *check_clearance(program, plant, trajectory, line.source_at, legs, open_=granted_clearance(rows, carried)),
    ]
    return Report(
        tuple(findings),
        tuple(advise(line, frames, rapid)) if advice else (),
        grid_resolution(line, frames),
        missing_rows(rows.t, rows.gaps),
    )


def _check_rows(trajectory: Trajectory) -> None:
    t = trajectory.t
    if len(t) < 2:
        raise InputError(f"the motion has {len(t)} rows; at least 2 are needed")
    for a in range(0, len(t), PIECE):
        part = slice(a, a + PIECE)
        table = np.column_stack(
            [t[part], trajectory.q[part]] + ([] if trajectory.qd is None else [trajectory.qd[part]])
        )
        if not np.isfinite(table).all():
            row, column = (int(i) for i in np.argwhere(~np.isfinite(table))[0])
            name = ("t", *trajectory.names, *(f"{axis} speed" for axis in trajectory.names))[column]
            raise InputError(f"row {a + row}: {name} is {table[row, column]}, wanted a finite number")
    late = np.flatnonzero(np.diff(t) <= 0)
    if late.size:
        row = int(late[0]) + 1
        raise InputError(f"row {row}: time {t[row]:.9g} s follows {t[row - 1]:.9g} s; times must increase")


def _dropped(program: Program, plant: Machine, dropped: Collection[int]) -> list[Finding]:
    """Every motion the plan left out must be one that the user marked."""
    out = []
    for index in sorted(dropped):
        motion = program.motions[index] if 0 <= index < len(program.motions) else None
        name = (
            f"motion {index}" if motion is None else f"{type(motion).__name__} {getattr(motion, 'target', '')}".strip()
        )
        source = None if motion is None else motion.source
        allowed = may_drop(program, plant, index)
        out.append(
            finding("dropped motion", name, 1.0, 0.0, "dropped", allowed, source=source,
                    note=": only a target marked optional may be left out")
        )  # fmt: skip
    return out
