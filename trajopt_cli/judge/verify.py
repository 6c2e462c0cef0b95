"""verify(): a program, a plant and rows of joint positions in; findings about their legality, and advice, out."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import replace

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.findings import Finding, Promise, Report
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge.advice import advise
from trajopt_cli.judge.caps import check_caps
from trajopt_cli.judge.clearance import check_clearance
from trajopt_cli.judge.demands import check_demands
from trajopt_cli.judge.findings import finding, in_step
from trajopt_cli.judge.joints import check_joints
from trajopt_cli.judge.lines import check_shapes
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.mechanism import mechanism_of
from trajopt_cli.judge.positioners import check_columns, check_tables, turned_frames
from trajopt_cli.judge.program_points import may_drop, points_of
from trajopt_cli.judge.promises import Promises, levers
from trajopt_cli.judge.rail_hold import check_held
from trajopt_cli.judge.samples import PIECE, Rows, look
from trajopt_cli.judge.scene import legs_of, shape_of
from trajopt_cli.judge.stops import check_stops
from trajopt_cli.judge.tcp_motion import TcpMotion
from trajopt_cli.judge.timeline import build_timeline
from trajopt_cli.judge.tolerances import COARSEST_PRINT, LARGEST_GAP
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
    promises: bool = False,
) -> Report:
    """Judge a joint motion of the whole program. Report.legal decides; advice says what a line could still gain.

    resolution: printed step of the file, None when every digit is there. dropped: indices of motions the plan left
    out; None: unknown, optional motions may be missing. target rapid: also what a RAPID controller makes of it, every
    axis at rest at every stop, MoveJ straight in the joints, the rail in proportion to the path of a line.
    advice False leaves the libraries out, for those who only ask for legality. promises: also tell what every check is
    sure to see at this file's rate and digits.

    Raises InputError when the file's axes are not the robot's, or its rows are no motion: fewer than two, a time that
    does not follow the one before, a number that is not finite.
    """
    names = mechanism_of(plant).names
    if trajectory.names != names:
        raise InputError(f"the file's axes are {', '.join(trajectory.names)}; the robot's are {', '.join(names)}")
    _check_rows(trajectory.whole)
    check_columns(program, trajectory, dropped or ())
    points = points_of(program, plant, dropped or (), optional=dropped is None)
    rows = look(plant, trajectory, resolution, marks=len(points) - 1)
    rapid = target is Target.RAPID
    frames = {
        key: TcpMotion(rows, X_FT) for key, X_FT in {np.asarray(p.X_FT).tobytes(): p.X_FT for p in points}.items()
    }
    if dropped is None and (absent := never_near(rows, frames, points)):  # zones reach from point to point
        points = points_of(program, plant, absent, optional=True)
    line = build_timeline(rows, frames, points[0], match(rows, frames, points, rapid), rapid)
    line = replace(line, turned=turned_frames(program, frames, line))
    stops, shapes, caps, demands = in_step(
        check_stops(line, frames, rapid),
        check_shapes(line, frames, rapid),
        check_caps(line, frames, rapid),
        check_demands(line, frames),
    )
    legs = legs_of(program, plant, line.visits, len(trajectory.t) - 1)
    torques, granted = check_torques(program, line)
    carried = {shape_of(solid) for leg in legs for solid in leg.carried}
    promised = Promises(line, frames, granted, levers(plant, rows.mechanism, carried), promises)
    findings = [
        *_file(rows, frames[np.asarray(points[0].X_FT).tobytes()], promised.measured),
        *_dropped(program, plant, dropped or ()),
        *stops,
        *shapes,
        *check_held(line, frames),
        *check_joints(rows, line.source_at),
        *torques,
        *check_tables(program, line),
        *caps,
        *demands,
        *check_clearance(program, plant, trajectory, line.source_at, legs, open_=promised.granted_clearance()),
    ]
    return Report(
        tuple(findings),
        tuple(advise(line, frames, rapid)) if advice else (),
        promised.told(program) if promises else (),
        promised.rate,
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


def _file(rows: Rows, frame: TcpMotion, promises: Iterable[Promise]) -> list[Finding]:
    """Whether the rows are close and fine enough to show stops and lines at all, and every limit."""
    judged = {(one.check, one.unit, one.subject): one for one in promises if one.most is not None}
    stop = judged.pop(("stop reached", "m", "TCP"))
    judged = {key: one for key, one in judged.items() if not one.check.startswith("path")}  # as good as stops
    i, k = int(np.argmax(rows.gaps)), int(np.argmax(frame.doubt_p))
    far, coarse = float(rows.gaps[i]), float(frame.doubt_p[k])
    note = ": rows this far apart do not show whether the TCP stops; sample the motion at 50 Hz or more"
    if lost := missing_rows(rows.t, rows.gaps):
        note = f"{note} and lose no row; {lost}"
    digits = f": printed digits leave the TCP this uncertain; {_finer(stop)}"
    return [
        finding("row spacing", "file", far, LARGEST_GAP, "s", far <= LARGEST_GAP * (1 + 1e-9) + rows.doubt_t,
                time=float(rows.t[i]), note=note),
        finding("printed resolution", "file", coarse, COARSEST_PRINT, "m", coarse <= COARSEST_PRINT,
                time=float(rows.t[k]), note=digits),
        *(
            finding("printed resolution", one.subject, one.least, one.most or 0.0, one.unit, False,
                    words="may be off unseen by", note=f" of {one.check}: {_finer(one)}")
            for one in judged.values() if one.needs and one.least > (one.most or 0.0)
        ),
    ]  # fmt: skip


def _finer(promise: Promise) -> str:
    """How finely to print so that a check can be made."""
    if not promise.needs:
        return "give more rows"
    return f"print {' and '.join(f'{name} in steps of {step:g}' for name, step in promise.needs)} (SI) or finer"


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
