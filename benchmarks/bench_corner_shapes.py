"""How a real robot cuts corners, beside the model:

    python benchmarks/bench_corner_shapes.py FOLDER [--corners] [--speeds]

FOLDER holds X.mod, X.yaml and X_log.csv, joints over time (--units where the heads name none). Of every corner between
two lines or arcs the logged path, by the robot's kinematics, is held against the programmed point: how far it passes
from it towards the inner side, and how far it is from the ways half a zone and a whole zone away. All three are told in
parts of r |e2 - e1|, of the radius in force and the directions in and out: a parabola has 0.25, 0.0625 and 0, a circle
the same where the angle is small, a quintic without curvature at its ends 0.1875, 0.0273 and 0. sideways: out of the
plane of both ways, which no shape explains: what a servo does, and the robot's accuracy. --corners: a line for every
corner. --speeds: where the logged tool is slower than 0.93 of its programmed speed for 0.05 s between its ramps, and
the accelerations that the logged path asks there at the programmed one, in parts of the limits in force.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.interpolate import make_smoothing_spline

sys.path[:0] = [str(Path(__file__).parents[1])]  # run from a checkout without installing

from trajopt_cli.geometry import Array  # noqa: E402
from trajopt_cli.job import Job, read_job  # noqa: E402
from trajopt_cli.measured.log_csv import read_log  # noqa: E402
from trajopt_cli.motion import PathMove  # noqa: E402
from trajopt_cli.path.corner import Corner  # noqa: E402
from trajopt_cli.path.of_motion import segment_of  # noqa: E402
from trajopt_cli.path.segment import Segment  # noqa: E402
from trajopt_cli.problem.programmed import PlantKinematics  # noqa: E402
from trajopt_cli.rapid.zones import fly_bys, moves_with_places  # noqa: E402
from trajopt_cli.units import MM  # noqa: E402

STEP = 0.02e-3  # m between two looks at the logged path
GAP = 5e-3  # m between two rows between which nothing is known
NEAR = 3  # radii around a point in which its passing is looked for
SLOW, AVERAGE, LONG = 0.93, 0.1, 0.05  # of the programmed speed; s over which a logged speed is a mean; s it lasts
RESTS, STOOD, RAMP = 0.02e-3, 0.3, 0.25  # m between two rows at rest; s of a rest that is one; s of the last ramp
CLOSE, STIFF = 0.05, 20.0  # mm between two rows that are one; of the spline through the axes over mm of the way


@dataclass(frozen=True, eq=False)
class CornerAt:
    """A corner: where, the tool's programmed speed [m/s], its curve, radius [m], directions in and out (3,)."""

    place: str
    speed: float
    curve: Corner
    radius: float
    e: tuple[Array, Array]

    @property
    def size(self) -> float:
        """What the numbers are parts of [m]."""
        return self.radius * float(np.linalg.norm(self.e[1] - self.e[0]))


def corners(job: Job) -> Iterator[CornerAt]:
    """The corners between lines and arcs, in order."""
    kinematics = PlantKinematics(job.plant)
    zones = fly_bys(job.program, kinematics)
    before: tuple[int, Segment] | None = None
    for index, motion, start, _, _ in moves_with_places(job.program, kinematics):
        if not isinstance(motion, PathMove) or start is None:
            before = None
            continue
        segment = segment_of(motion, start.seen_by(motion.tool))
        if before is not None and before[0] in zones:
            zone, one = zones[before[0]], before[1]
            ways = one.twist(np.ones(1))[0, :3], segment.twist(np.zeros(1))[0, :3]
            e_0, e_1 = (way / np.linalg.norm(way) for way in ways)
            curve = Corner.of_zone(one, segment, zone.radius, zone.turning)
            move = job.program.motions[before[0]]
            yield CornerAt(f"{move.source.file}:{move.source.line}", move.speed.v_tcp, curve, zone.radius, (e_0, e_1))
        before = index, segment


def cut(path: Array, corner: CornerAt) -> tuple[float, float, float, float] | None:
    """How far a path (m, 3) passes the point towards the inner side, how far it is from the ways half a zone and a
    zone away (means of both sides), and how far sideways it passes the point [m]; None where it is never near."""
    P, (e_0, e_1) = corner.curve.after.pose(np.zeros(1))[0, :3, 3], corner.e
    off = path - P
    near = off[np.linalg.norm(off, axis=1) < NEAR * corner.radius]
    if len(near) < 2 or corner.size == 0:
        return None
    inner = (e_1 - e_0) / np.linalg.norm(e_1 - e_0)
    middle = (e_0 + e_1) / np.linalg.norm(e_0 + e_1)
    at = near[np.argmin(np.abs(near @ middle))]
    if abs(at @ middle) > 2 * STEP:
        return None  # the log has a gap there
    aside = []
    for share in (0.5, 1.0):
        places = [near[np.argmin(np.abs((near - d) @ e))] - d for e, d in (
            (e_0, -share * corner.radius * e_0), (e_1, share * corner.radius * e_1))]  # fmt: skip
        aside.append(float(np.mean([place @ inner for place in places])))
    return float(at @ inner), aside[0], aside[1], float(at @ np.cross(middle, inner))


def logged_path(job: Job, log: Path, units: str | None) -> tuple[Array, Array, Array]:
    """Times (m,), axes (m, n) and the tool of the last move (m, 4, 4) by a log."""
    trajectory, _ = read_log(log, job.plant.limits, units, None)
    tool = next(motion.tool for motion in reversed(job.program.motions) if isinstance(motion, PathMove))
    return trajectory.t, trajectory.q, job.plant.robot.forward(trajectory.q) @ tool.X_FT


def drawn(p: Array) -> Array:
    """A path (m, 3) straight from row to row, rests once, every STEP: off by 0.004 mm at 0.4 m/s in the bends here."""
    p = p[np.r_[True, np.linalg.norm(np.diff(p, axis=0), axis=1) > STEP]]
    s = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1))]
    places = np.arange(0.0, s[-1], STEP)
    k = np.searchsorted(s, places, side="right")
    known = places[s[k] - s[k - 1] < GAP]
    return np.column_stack([np.interp(known, s, x) for x in p.T])


def compared(module: Path, units: str | None, every: bool) -> str:
    """The line of one log."""
    job = read_job([module], None)
    _, _, X = logged_path(job, module.with_name(f"{module.stem}_log.csv"), units)
    path, found, rows = drawn(X[:, :3, 3]), [*corners(job)], []
    for one in found:
        if (seen := cut(path, one)) is None:
            continue
        curve = one.curve.pose(np.linspace(0, 1, 201))[:, :3, 3]
        P = one.curve.after.pose(np.zeros(1))[0, :3, 3]
        model = float(np.linalg.norm(curve - P, axis=1).min())
        rows.append((one.size, model, *seen))
        if every:
            angle = np.degrees(angle_of(*one.e))
            told = "".join(f"{x / MM:9.3f}" for x in seen)
            print(f"{Path(one.place).name:32}{angle:7.2f}{one.radius / MM:8.2f}{model / MM:9.3f}{told}")
    size, model, at, half, edge, aside = np.array(rows).T
    parts = [float(size @ x / (size @ size)) for x in (at, half, edge)]
    doubt = float(np.std(at - parts[0] * size) / np.sqrt(size @ size))
    angles = np.degrees([angle_of(*one.e) for one in found])
    rms = [float(np.sqrt(np.mean(x**2))) / MM for x in (model, at, at - model, aside)]
    return (
        f"{module.stem:24}{found[0].speed / MM:6.0f}{len(rows):8}{np.median(angles):7.1f}{angles.max():6.1f}"
        f"{rms[0]:9.3f}{rms[1]:8.3f}{rms[2]:8.3f}{rms[3]:10.3f}"
        f"   {parts[0]:6.3f} ± {doubt:.3f}{parts[1]:8.3f}{parts[2]:8.3f}"
    )


def angle_of(e_0: Array, e_1: Array) -> float:
    """Angle [rad] between two directions."""
    return float(np.arctan2(np.linalg.norm(np.cross(e_0, e_1)), e_0 @ e_1))


def dips(module: Path, units: str | None) -> Iterator[str]:
    """Where the logged tool is slow between the ramps of the last motion that has corners."""
    job = read_job([module], None)
    t, q, X = logged_path(job, module.with_name(f"{module.stem}_log.csv"), units)
    found, p = [*corners(job)], X[:, :3, 3]
    v, begin = found[0].speed, found[0].curve.before.pose(np.ones(1))[0, :3, 3]
    end = found[-1].curve.after.pose(np.ones(1))[0, :3, 3]
    at_rest = np.flatnonzero(np.linalg.norm(np.diff(p, axis=0), axis=1) < RESTS)
    rests = np.split(at_rest, np.flatnonzero(np.diff(at_rest) > 3) + 1)
    since = max(int(rest[-1]) for rest in rests if t[rest[-1]] - t[rest[0]] > STOOD and t[rest[-1]] < t[-1] - 1)
    b = since + int(np.argmin(np.linalg.norm(p[since:] - end, axis=1)))
    a = since + int(np.argmin(np.linalg.norm(p[since:b] - begin, axis=1)))
    s = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1))] / MM
    times = np.arange(t[a], t[b] - RAMP, 0.004)
    way = [np.interp(times + side * AVERAGE / 2, t, s) for side in (-1, 1)]
    share, here = (way[1] - way[0]) / AVERAGE / (v / MM), (way[0] + way[1]) / 2
    rows = [a]
    for k in range(a + 1, b):
        if s[k] > s[rows[-1]] + CLOSE:
            rows.append(k)
    bends = [make_smoothing_spline(s[rows], q[rows, j], lam=STIFF).derivative(2) for j in range(q.shape[1])]
    slow = np.flatnonzero(share < SLOW)
    for group in np.split(slow, np.flatnonzero(np.diff(slow) > 8) + 1):
        if len(group) * 0.004 >= LONG and group[-1] < len(times) - 15:  # the last ramp begins within
            i = group[np.argmin(share[group])]
            place = np.linspace(here[i] - 15, here[i] + 15, 31)
            asked = np.array([np.abs(bend(place)).max() for bend in bends]) * (v / MM) ** 2
            parts = "".join(f"{x:7.2f}" for x in asked / job.plant.limits.acceleration)
            done = 100 * (here[i] - s[a]) / (s[b] - s[a])
            yield f"{module.stem:24}{done:6.0f} %{share[i]:7.2f}{len(group) * 0.004:7.2f} s{parts}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--units", default="s,deg")
    parser.add_argument("--corners", action="store_true")
    parser.add_argument("--speeds", action="store_true")
    options = parser.parse_args()
    logs = [one for one in sorted(options.folder.glob("*.mod")) if one.with_name(f"{one.stem}_log.csv").exists()]
    if options.speeds:
        print(
            "log                     of way  speed  lasts   asked of joint_1 to joint_6, parts of their limits in force"
        )
        for line in (line for module in logs for line in dips(module, options.units)):
            print(line)
        return
    if options.corners:
        print(f"{'corner':32}{'deg':>7}{'r mm':>8}{'model':>9}{'point':>9}{'half':>9}{'edge':>9}{'sideways':>9}  mm")
    lines = [compared(module, options.units, options.corners) for module in logs]
    print(
        "                         mm/s corners  angle, deg    point passed by, mm rms            parts of r |e2 - e1|"
    )
    print(f"{'log':43}median   max    model  logged     off  sideways{'at the point':>17}{'half':>8}{'edge':>8}")
    print(*lines, sep="\n")


if __name__ == "__main__":
    main()
