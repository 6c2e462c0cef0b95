"""Files of a rail under an arm that never moves: rests and rides, row by row, and what the judge makes of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from legal_motion import Case, move_j, plant_with_rail, program

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge.program_points import points_of
from trajopt_cli.judge.samples import judged_rows
from trajopt_cli.judge.stops import check_stops
from trajopt_cli.judge.timeline import Timeline, build_timeline
from trajopt_cli.judge.tool_kinematics import ToolKinematics
from trajopt_cli.judge.waypoint_matching import match
from trajopt_cli.motion import Motion
from trajopt_cli.problem.plant import Plant
from trajopt_cli.trajectory import Trajectory

H = 0.008  # s between rows


def at(d: float, plant: Plant | None = None) -> Array:
    """Where the tool is when the rail is at d [m]."""
    plant = plant or plant_with_rail()
    return np.asarray(plant.robot.forward(np.r_[d, plant.start[1:]][None])[0])


def seen(
    case: Case, trajectory: Trajectory, steps: Resolution | None, rapid: bool = False, marked: bool | None = None
) -> tuple[Timeline, dict[bytes, ToolKinematics]]:
    """Its points with their rows, as verify finds them. marked: whether to take it for a file with marks."""
    points = points_of(case.program, case.plant)
    rows = judged_rows(case.plant, trajectory, steps, marks=len(points) - 1)
    rows = rows if marked is None else replace(rows, marked=marked)
    frames = {np.asarray(p.X_FT).tobytes(): ToolKinematics(rows, p.X_FT) for p in points}
    return build_timeline(rows, frames, points[0], match(rows, frames, points, rapid), rapid), frames


@dataclass
class Ride:
    """Rows of rests, (position, rows) in turn, with so many rows on the way between them."""

    rests: Sequence[tuple[float, int]]
    between: int = 6
    step: float = H

    def __post_init__(self) -> None:
        d, v = [], []
        for k, (place, n) in enumerate(self.rests):
            if k:
                way = (place - d[-1]) / (self.between + 1)
                d += [d[-1] + way * (i + 1) for i in range(self.between)]
                v += [way / self.step] * self.between
            d += [place] * n
            v += [0.0] * n
        self.d, self.v = np.array(d), np.array(v)
        self.t = np.arange(len(d)) * self.step
        lengths = np.cumsum([n for _, n in self.rests]) + self.between * np.arange(len(self.rests))
        self.last = lengths - 1  # row of each rest
        self.first = lengths - [n for _, n in self.rests]

    def rows(self, speeds: bool = True) -> Trajectory:
        plant = plant_with_rail()
        q, qd = np.tile(plant.start, (len(self.t), 1)), np.zeros((len(self.t), 7))
        q[:, 0], qd[:, 0] = self.d, self.v
        return Trajectory(plant.limits.names, self.t, q, qd if speeds else None)


def stops_of(
    motions: Sequence[Motion],
    trajectory: Trajectory,
    marked: bool = False,
    steps: Resolution | None = None,
    rapid: bool = False,
    plant: Plant | None = None,
) -> list[Finding]:
    """All that is said of points; the program ends with the rail at 0.2 m, unless it says so itself."""
    ends = getattr(motions[-1], "target", "") in ("j_home", "p_99")
    asked = program(*motions, *([] if ends else [move_j(99, "p_99", at(0.2))]))
    case = Case(plant or plant_with_rail(), asked, ())
    line, frames = seen(case, trajectory, steps, rapid, marked)
    return [finding for _, found in check_stops(line, frames, rapid) for finding in found]


def one_of(found: Sequence[Finding], check: str, line: int | None = None) -> Finding:
    """The only finding of a check, at a line of the program."""
    (one,) = (f for f in found if f.check == check and (line is None or (f.source and f.source.line == line)))
    return one
