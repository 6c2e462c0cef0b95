"""Spoiled folders of `trajopt iiwa`: each breaks one thing, by 1.1 times what the judge promises to see."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
from iiwa_folders import H, Sequence, Table, bump, edit_sequence, edit_table, make_folder, tell_summary
from scipy.spatial.transform import Rotation, Slerp

from trajopt_cli.geometry import Array, inverse_pose, pose
from trajopt_cli.iiwa.job.folder import open_folder
from trajopt_cli.iiwa.judge import tolerances
from trajopt_cli.robot.srs_inverse import ArmAngle, inverse_branch

OVER = 1.1
JOINTS = slice(1, 8)
# by name: how to spoil a folder, the base it spoils, the checks that fail, and those that may fail besides
SPOILED: dict[str, tuple[Callable[[Path], None], str, frozenset[str], frozenset[str]]] = {}
AT_START, TO_A, TO_B, AT_B, TO_C, TO_D, AT_D = range(7)  # pieces of the base


def spoiled(base: str, *checks: str, besides: tuple[str, ...] = ()) -> Callable[..., Callable[[Path], None]]:
    def add(spoil: Callable[[Path], None]) -> Callable[[Path], None]:
        SPOILED[spoil.__name__] = spoil, base, frozenset(checks), frozenset(besides)
        return spoil

    return add


def sequence(base: str, *checks: str, besides: tuple[str, ...] = ()) -> Callable[..., None]:
    """Register an edit of a sequence, written into both files."""

    def add(edit: Callable[[Sequence, Path], None]) -> None:
        def spoil(folder: Path) -> None:
            edit_sequence(folder, edit)

        spoil.__name__ = edit.__name__
        spoiled(base, *checks, besides=besides)(spoil)

    return add


def table(name: str, base: str, *checks: str, besides: tuple[str, ...] = ()) -> Callable[..., None]:
    """Register an edit of one file's rows."""

    def add(edit: Callable[[Array], Array | None]) -> None:
        def spoil(folder: Path) -> None:
            edit_table(folder, name, edit)

        spoil.__name__ = edit.__name__
        spoiled(base, *checks, besides=besides)(spoil)

    return add


def middle(part: slice) -> int:
    return (part.start + part.stop) // 2


# ------------------------------------------------------------------------------------------------------------ the way


@sequence("trapezoid", "path", besides=("v_max",))
def beside_the_way(rows: Sequence, folder: Path) -> None:
    part = rows.leg(folder, TO_A)
    rows.p[part, 2] += OVER * tolerances.PATH * bump(len(rows.p[part]))


@sequence("trapezoid", "orientation")
def turned_off_the_way(rows: Sequence, folder: Path) -> None:
    part = rows.leg(folder, TO_A)
    rows.angles[part, 0] += OVER * tolerances.PATH * bump(len(rows.p[part]))


@sequence("trapezoid", "path", besides=("orientation", "v_max", "a_max", "epsilon_max"))
def turning_ahead_of_moving(rows: Sequence, folder: Path) -> None:
    part = rows.leg(folder, TO_B)
    way = rows.angles[part][-1] - rows.angles[part][0]
    rows.angles[part] += 2e-4 * bump(len(rows.p[part]))[:, None] * way


@sequence("trapezoid", "path", besides=("a_max", "v_max"))
def cutting_a_corner(rows: Sequence, folder: Path) -> None:
    corner = rows.leg(folder, TO_A).stop - 1
    part = slice(corner - 20, corner + 21)
    shift = bump(41)[:, None] * 4e-6
    rows.p[part] += np.where(np.arange(41)[:, None] != 20, shift, 0.0) * np.array([-1, 1, 0])


@sequence("trapezoid", "orientation", besides=("path", "epsilon_max", "omega_max"))
def another_law_of_turning(rows: Sequence, folder: Path) -> None:
    part = rows.leg(folder, TO_B)
    p, angles = rows.p[part], rows.angles[part]
    share = (p - p[0]) @ (p[-1] - p[0]) / np.sum((p[-1] - p[0]) ** 2)
    ends = Rotation.from_euler("xyz", angles[[0, -1]])
    rows.angles[part.start + 1 : part.stop - 1] = Slerp([0, 1], ends)(share[1:-1]).as_euler("xyz")


@sequence("thesis", "backward")
def back_on_the_way(rows: Sequence, folder: Path) -> None:
    row = middle(rows.leg(folder, TO_A))
    back = rows.p[row] - OVER * tolerances.BACKWARD * np.array([1.0, 0, 0])
    half = (rows.p[row] + rows.p[row + 1]) / 2
    rows.p = np.insert(rows.p, [row + 1, row + 1], [back, half], axis=0)
    rows.angles = np.insert(rows.angles, [row + 1, row + 1], rows.angles[row], axis=0)


@sequence("thesis", "pose reached", "poses missing")
def short_of_a_pose(rows: Sequence, folder: Path) -> None:
    corner = rows.leg(folder, TO_A).stop - 1
    rows.p[corner, 0] -= 2 * OVER * tolerances.PATH


@sequence("trapezoid", "pose reached", "poses missing")
def a_pose_left_out(rows: Sequence, folder: Path) -> None:
    begin, end = rows.leg(folder, TO_C).start, rows.leg(folder, TO_D).stop
    rows.p, rows.angles = (np.concatenate([x[: begin + 1], x[end:]]) for x in (rows.p, rows.angles))


@sequence("trapezoid", "pose reached", "poses missing", besides=("first pose",))
def the_other_way_round(rows: Sequence, folder: Path) -> None:
    rows.p, rows.angles = rows.p[::-1].copy(), rows.angles[::-1].copy()


@sequence("trapezoid", "first pose")
def beginning_beside_the_start(rows: Sequence, folder: Path) -> None:
    rows.p[0, 2] += OVER * tolerances.EXACT


@sequence("trapezoid", "last pose")
def ending_beside_the_end(rows: Sequence, folder: Path) -> None:
    rows.p[rows.leg(folder, AT_D).start :, 2] += OVER * tolerances.EXACT


@sequence("trapezoid", "rows behind the end", besides=("dwell",))
def on_behind_the_end(rows: Sequence, folder: Path) -> None:
    rows.p[-1, 2] += 1e-9


# ------------------------------------------------------------------------------------------------------ caps and dwells


def nudged(rows: Array, row: int, share: float) -> None:
    """Move a row along the way by a share of the step to it."""
    rows[row] += share * (rows[row] - rows[row - 1])


@sequence("thesis", "v_max")
def too_fast(rows: Sequence, folder: Path) -> None:
    nudged(rows.p, middle(rows.leg(folder, TO_A)), OVER * tolerances.CAP)


@sequence("thesis", "omega_max")
def turning_too_fast(rows: Sequence, folder: Path) -> None:
    nudged(rows.angles, middle(rows.leg(folder, TO_C)), OVER * tolerances.CAP)


def pushed(rows: Array, row: int, order: int, cap: float) -> None:
    """Move a row so that a difference of order 2 or 3 around it, which is positive, exceeds its cap."""
    around = rows[row - 1 : row + 2] if order == 2 else rows[row - 2 : row + 2]
    rounding = 2**order * 2.1 * tolerances.ROUNDING
    short = cap * H**order + OVER * (tolerances.RAMP * cap * H**order + rounding) - np.diff(around, n=order)[0]
    rows[row] -= short / order  # the middle row counts -2 times, the one before the last -3 times


@sequence("trapezoid", "a_max")
def speeding_up_too_fast(rows: Sequence, folder: Path) -> None:
    pushed(rows.p[:, 0], rows.leg(folder, TO_A).start + 5, 2, 2.0)


@sequence("trapezoid", "a_max")
def off_like_a_shot(rows: Sequence, folder: Path) -> None:
    """Who rests needs 2 x / h^2 to be at x a row later: the first step breaks the cap, no change of steps does."""
    part = rows.leg(folder, TO_A)
    share = np.linspace(0, 1, 1001)
    slow = share**3 * (10 - share * (15 - 6 * share))
    jump = np.minimum(np.arange(1001) * 0.8, 1.2) * 2.0 * H**2 * (1 - share)
    begin, way = rows.p[part.start], rows.p[part.stop - 1] - rows.p[part.start]
    leg = begin + slow[:, None] * way + jump[:, None] * np.array([1.0, 0, 0])
    rows.p = np.concatenate([rows.p[: part.start], leg[:-1], rows.p[part.stop - 1 :]])
    angles = np.tile(rows.angles[part.start], (1000, 1))
    rows.angles = np.concatenate([rows.angles[: part.start], angles, rows.angles[part.stop - 1 :]])


@sequence("trapezoid", "epsilon_max")
def speeding_up_the_turn_too_fast(rows: Sequence, folder: Path) -> None:
    pushed(rows.angles[:, 2], rows.leg(folder, TO_C).start + 5, 2, 6.0)


@sequence("s-curve", "jerk")
def jerking(rows: Sequence, folder: Path) -> None:
    pushed(rows.p[:, 0], rows.leg(folder, TO_A).start + 5, 3, 40.0)


@sequence("s-curve", "angular_jerk")
def jerking_the_turn(rows: Sequence, folder: Path) -> None:
    pushed(rows.angles[:, 2], rows.leg(folder, TO_C).start + 5, 3, 100.0)


@sequence("trapezoid", "dwell")
def leaving_a_row_too_early(rows: Sequence, folder: Path) -> None:
    row = middle(rows.leg(folder, AT_B))
    rows.p, rows.angles = np.delete(rows.p, row, axis=0), np.delete(rows.angles, row, axis=0)


@sequence("trapezoid", "standing")
def standing_longer_than_told(rows: Sequence, folder: Path) -> None:
    row = middle(rows.leg(folder, AT_B))
    rows.p, rows.angles = (np.insert(x, [row] * 3, x[row], axis=0) for x in (rows.p, rows.angles))


# ------------------------------------------------------------------------------------------------------------ the files


@table("equilibrium_quaternion.csv", "trapezoid", "period", besides=("a_max", "v_max"))
def a_row_late(rows: Array) -> None:
    rows[len(rows) // 2, 0] += OVER * tolerances.PERIOD


@table("equilibrium.csv", "trapezoid", "position")
def another_position_with_the_angles(rows: Array) -> None:
    rows[40, 3] += OVER * tolerances.EXACT


@table("equilibrium.csv", "trapezoid", "angles")
def other_angles(rows: Array) -> None:
    rows[40, 5] += OVER * 10 * tolerances.EXACT


@table("equilibrium.csv", "trapezoid", "angle jump")
def angles_by_a_whole_turn(rows: Array) -> None:
    rows[300:, 6] += 2 * np.pi


@table("equilibrium.csv", "trapezoid", "rows")
def a_row_less(rows: Array) -> Array:
    return rows[:-1]


@spoiled("trapezoid", "rows", "rows behind the end")
def rows_that_nobody_told_of(folder: Path) -> None:
    before = {name: (folder / name).read_bytes() for name in ("summary.json", "run.json")}

    def more(rows: Sequence, _: Path) -> None:
        rows.p = np.concatenate([rows.p, rows.p[-1:] + np.array([0, 0, 1e-5])])
        rows.angles = np.concatenate([rows.angles, rows.angles[-1:]])

    edit_sequence(folder, more)
    for name, content in before.items():
        (folder / name).write_bytes(content)


# ----------------------------------------------------------------------------------------------------------- the joints


def central(rows: Array) -> None:
    rows[1:-1, 8:] = (rows[2:, JOINTS] - rows[:-2, JOINTS]) / (2 * H)


@table("joints.csv", "joints", "tool orientation")
def the_tool_turned(rows: Array) -> None:
    rows[:, 7] += OVER * tolerances.FOLLOW * bump(len(rows))
    central(rows)


@table("joints.csv", "joints", "tool position", besides=("tool orientation",))
def the_tool_elsewhere(rows: Array) -> None:
    rows[:, 1] += 3 * OVER * tolerances.FOLLOW * bump(len(rows))
    central(rows)


@table("joints.csv", "joints", "joint position", "start joints")
def a_joint_by_a_whole_turn(rows: Array) -> None:
    rows[:, 7] += 2 * np.pi


@table(
    "joints.csv", "joints", "jump", "joint speed", "joint acceleration", "joint position", "orientation between rows"
)
def a_whole_turn_within_a_row(rows: Array) -> None:
    rows[300:, 7] += 2 * np.pi
    central(rows)


@table("joints.csv", "joints", "last row")
def no_rest_at_the_end(rows: Array) -> None:
    rows[-1, 8] = 2 * OVER * tolerances.REST


@table("joints.csv", "joints", "first row")
def no_rest_at_the_beginning(rows: Array) -> None:
    rows[0, 8] = -2 * OVER * tolerances.REST


@table("joints.csv", "joints", "speed column")
def speeds_of_another_motion(rows: Array) -> None:
    rows[:, 9] += 0.02 * bump(len(rows))


@table("joints.csv", "joints", "rows")
def a_row_of_joints_less(rows: Array) -> Array:
    return np.delete(rows, -2, axis=0)


@table("joints.csv", "joints", "period")
def joints_late(rows: Array) -> None:
    rows[5, 0] += 3 * OVER * tolerances.PERIOD


def other_joints(folder: Path, arm_angle: Callable[[int], Array], configuration: int, part: slice) -> None:
    """The joints that reach the same poses at other arm angles, or in another configuration."""
    opened = open_folder(folder)
    sequence = opened.equilibrium
    X = pose(sequence.rotations(opened.X_start[:3, :3]), sequence.pose[:, :3]) @ inverse_pose(opened.task.X_FT)
    q = inverse_branch(opened.robot, X, arm_angle(len(X)), ArmAngle.FARIA, configuration)

    def edit(rows: Array) -> None:
        rows[part, JOINTS] = np.unwrap(q, axis=0)[part]
        central(rows)

    edit_table(folder, "joints.csv", edit)


@spoiled("joints", "arm angle")
def the_elbow_wanders(folder: Path) -> None:
    other_joints(folder, lambda n: OVER * tolerances.ARM_ANGLE * bump(n), 2, slice(None))


@spoiled("joints", "configuration", "start joints", besides=("joint position",))
def in_another_configuration(folder: Path) -> None:
    other_joints(folder, lambda n: np.zeros(n), 0, slice(None))


@spoiled(
    "joints", "configuration", "joint speed", "joint acceleration", "position between rows",
    besides=("jump", "orientation between rows", "joint position"),
)  # fmt: skip
def to_another_configuration_within_a_row(folder: Path) -> None:
    other_joints(folder, lambda n: np.zeros(n), 0, slice(200, None))


@spoiled("free", "arm angle range")
def the_elbow_leaves_what_is_told(folder: Path) -> None:
    said = json.loads((folder / "summary.json").read_text())["joints"]["arm_angle"]
    least, greatest = said["least_rad"], said["greatest_rad"]

    def beyond(n: int) -> Array:
        angles = own_arm_angles(folder)
        return np.where(angles > (least + greatest) / 2, angles + OVER * tolerances.ARM_ANGLE, angles)

    other_joints(folder, beyond, 2, slice(None))


def own_arm_angles(folder: Path) -> Array:
    from trajopt_cli.robot.srs_inverse import arm_angle

    rows = Table.read(folder / "joints.csv").rows
    return arm_angle(open_folder(folder).robot, rows[:, JOINTS], ArmAngle.FARIA)


# ------------------------------------------------------------------------------------------------------- the simulation


@table("simulation.csv", "simulated", "deviation")
def a_deviation_made_up(rows: Array) -> None:
    rows[100, 13] += 2 * OVER * tolerances.SIMULATED


@table("simulation.csv", "simulated", "position fed", besides=("deviation",))
def fed_another_position(rows: Array) -> None:
    rows[100, 1] += OVER * tolerances.SIMULATED


@table("simulation.csv", "simulated", "orientation fed")
def fed_another_turn(rows: Array) -> None:
    rows[100, 4] += 2 * OVER * tolerances.SIMULATED


SHIFT = 1e-6  # m, rad: seen in a simulation
FORCE = slice(14, 20)  # believed; a world's columns of joints, true forces and depth come behind
TRUE, DEPTH = slice(34, 40), 40


@table("simulation.csv", "simulated", "law", "deviation", "joints", besides=("believed force",))
def a_position_shifted(rows: Array) -> None:
    rows[:, 8] += SHIFT


@table("simulation.csv", "simulated", "law", "joints")
def an_angle_shifted(rows: Array) -> None:
    rows[:, 12] += SHIFT


@table("simulation.csv", "simulated", "law", "deviation", "joints")
def an_answer_a_row_late(rows: Array) -> None:
    rows[1:, 7:13] = rows[:-1, 7:13].copy()


@table("simulation.csv", "simulated", "law", "deviation", "joints")
def an_answer_mirrored(rows: Array) -> None:
    rows[:, 8] *= -1


@table("simulation.csv", "simulated", "law", "believed force")
def a_force_made_up(rows: Array) -> None:
    rows[100:200, 14] += 0.5


@table("simulation.csv", "simulated", "duration")
def the_end_left_out(rows: Array) -> Array:
    return rows[:-5]


@table("simulation.csv", "simulated", "joints")
def a_joint_of_a_simulation_shifted(rows: Array) -> None:
    rows[:, 20] += SHIFT


def other_run(folder: Path, change: Callable[[str], str], keep: slice) -> None:
    """The answer, and what stands behind it, of a run with another task; what was fed stays."""
    from trajopt_cli.iiwa.job.pages import simulation_page
    from trajopt_cli.iiwa.job.simulation import simulate

    other = make_folder(folder.parent / "other", change(next(folder.glob("input/*.yaml")).read_text()), joints=False)
    simulate(other, simulation_page, settle=0.1)
    rows = Table.read(other / "simulation.csv").rows

    def replaced(own: Array) -> None:
        own[:, keep] = rows[: len(own), keep][:, : own.shape[1]]

    edit_table(folder, "simulation.csv", replaced)


@spoiled("simulated", "law")
def rows_of_another_damping(folder: Path) -> None:
    other_run(folder, lambda text: text.replace("D: [500", "D: [510"), slice(7, None))


@spoiled("simulated", "law")
def rows_of_a_run_fed_with_speed(folder: Path) -> None:
    from trajopt_cli.iiwa.job.pages import simulation_page
    from trajopt_cli.iiwa.job.simulation import simulate
    from trajopt_cli.iiwa.task.model import Feed

    before = {name: (folder / name).read_bytes() for name in ("summary.json", "run.json", "report.html")}
    simulate(folder, simulation_page, feed=Feed.VELOCITY, settle=0.1)
    for name, content in before.items():
        (folder / name).write_bytes(content)


@table("simulation.csv", "touching", "law", "true force", "believed force")
def forces_scaled(rows: Array) -> None:
    rows[:, FORCE] *= 1.05
    rows[:, TRUE] *= 1.05


@table("simulation.csv", "touching", "true force")
def true_forces_scaled(rows: Array) -> None:
    rows[:, TRUE] *= 1.05


@table("simulation.csv", "touching", "law", "true force", "believed force", "depth")
def nothing_touched(rows: Array) -> None:
    rows[:, FORCE] = rows[:, TRUE] = 0.0
    rows[:, DEPTH] = 0.0


@table("simulation.csv", "touching", "depth")
def half_as_deep(rows: Array) -> None:
    rows[:, DEPTH] /= 2


@table("simulation.csv", "touching", "joints")
def a_command_shifted(rows: Array) -> None:
    rows[:, 22] += SHIFT


@table("simulation.csv", "touching", "law", "deviation", "joints", "true force", "believed force", "depth")
def an_arm_that_is_not_held(rows: Array) -> None:
    touches = rows[:, DEPTH] > 0
    rows[touches, 9] -= 1e-3


# -------------------------------------------------------------------------------------------------------------- dosing


def fed(name: str, base: str, *checks: str, besides: tuple[str, ...] = ()) -> Callable[..., None]:
    """Register an edit of what a dosed folder feeds, given the positions (n, 3) of its plan."""

    def add(edit: Callable[[Sequence, Array], None]) -> None:
        def spoil(folder: Path) -> None:
            plan = Table.read(folder / "plan.csv").rows
            edit_sequence(folder, lambda rows, _: edit(rows, plan[:, 1:4]))

        spoil.__name__ = name
        spoiled(base, *checks, besides=("lag", "push", "arrival", "arm speed", *besides))(spoil)

    return add


@fed("shifted_by_20_mm", "dosed", "lag")
def _shifted(rows: Sequence, plan: Array) -> None:
    rows.p += [0.0, 0.02, 0.0]


@fed("the_plan_itself", "dosed", "lag")
def _planned(rows: Sequence, plan: Array) -> None:
    rows.p[:] = plan


@fed("a_tenth_more_ahead", "dosed", "push")
def _ahead(rows: Sequence, plan: Array) -> None:
    rows.p[:] = plan + 1.1 * (rows.p - plan)


@fed("one_row_far_ahead", "dosed", "push")
def _jumping(rows: Sequence, plan: Array) -> None:
    rows.p[len(plan) // 2] += [0.0, 0.0, 0.08]


@fed("fed_20_rows_late", "dosed", "lag")
def _late(rows: Sequence, plan: Array) -> None:
    rows.p[20:] = rows.p[:-20].copy()


@fed("ahead_the_wrong_way", "dosed", "lag")
def _backwards(rows: Sequence, plan: Array) -> None:
    rows.p[:] = 2 * plan - rows.p


@fed("turned_too_late", "dosed", "turn lag", besides=("turn lag",))
def _turned_late(rows: Sequence, plan: Array) -> None:
    rows.angles[150:] = rows.angles[:-150].copy()


@fed("never_quite_there", "dosed", "arrival")
def _short(rows: Sequence, plan: Array) -> None:
    rows.p[-1] += [1.2e-3, 0.0, 0.0]


@spoiled("dosed", "lag", besides=("push", "arrival", "turn lag"))
def rows_as_programmed(folder: Path) -> None:
    """All files those of the folder that was dosed, but for what dosing says."""
    before = folder.parent / "before"
    make_folder(before, next(folder.glob("input/*.yaml")).read_text(), joints=False)
    take_over(folder, before, ("equilibrium", "equilibrium_quaternion"), ("plan", "plan_quaternion"))


def take_over(folder: Path, other: Path, *names: tuple[str, str]) -> None:
    """Files of another folder under both names, and what summary.json says of its sequence."""
    for pair in names:
        for name in pair:
            source = name if (other / f"{name}.csv").is_file() else name.replace("plan", "equilibrium")
            (folder / f"{name}.csv").write_bytes((other / f"{source}.csv").read_bytes())
    said, theirs = (json.loads((one / "summary.json").read_text()) for one in (folder, other))
    said["sequence"] = theirs["sequence"]
    tell_summary(folder, said)


@fed("pressed_5_mm_deeper", "pressing", "pressing", besides=("force", "lag off what it touches"))
def _deeper(rows: Sequence, plan: Array) -> None:
    rows.p[:, 2] -= 5e-3 * (plan[:, 2] < plan[:, 2].max() - 0.025)


@fed("lifted_by_5_mm", "pressing", "pressing", besides=("force", "lag off what it touches"))
def _lifted(rows: Sequence, plan: Array) -> None:
    rows.p[:, 2] += 5e-3 * (plan[:, 2] < plan[:, 2].max() - 0.025)


@fed("beside_the_plan_in_the_air", "pressing", "lag", "lag off what it touches", besides=("force", "pressing"))
def _aside(rows: Sequence, plan: Array) -> None:
    rows.p[: np.argmax(plan[:, 2] < plan[0, 2] - 0.015), 1] += 0.02


@fed("a_blow", "pressing", "force", "arm speed", besides=("pressing", "lag off what it touches"))
def _blow(rows: Sequence, plan: Array) -> None:
    row = int(np.argmin(plan[:, 2])) + 300
    rows.p[row : row + 120, 2] -= 0.03


@spoiled("pressing", "force", besides=("pressing", "arrival"))
def scheduled_as_if_nothing_were_there(folder: Path) -> None:
    from trajopt_cli.iiwa.controller.feed_path import Allowed, Lead
    from trajopt_cli.iiwa.job.feed_scheduling import schedule_feed
    from trajopt_cli.iiwa.job.pages import feed_page

    text = next(folder.glob("input/*.yaml")).read_text()
    free = make_folder(folder.parent / "free", text[: text.index("contact:")], joints=False)
    schedule_feed(free, folder.parent / "dosed", Allowed(2e-3, lead=Lead(60.0)), feed_page)
    take_over(folder, folder.parent / "dosed", ("equilibrium", "equilibrium_quaternion"), ("plan", "plan_quaternion"))
