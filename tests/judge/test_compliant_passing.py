"""Poses that are passed without a stop: rows within the tolerances, in order, are legal, and nothing else is."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from iiwa_folders import CONTROLLER, HOME
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge.samples import Poses
from trajopt_cli.iiwa.judge.sequence import check_sequence
from trajopt_cli.iiwa.judge.task_order import FramePose, Order, read_order

H = 4e-3
CAPS = "profile: trapezoid\nv_max: 0.1\nomega_max: 1\na_max: 3\nepsilon_max: 30\n"
CORNERS = np.array(
    [[0.5, 0, 0.3, 0, 0, 0], [0.55, 0, 0.3, 0.1, 0, 0], [0.55, 0.05, 0.3, 0.1, 0.1, 0], [0.5, 0.05, 0.3, 0, 0.1, 0.2],
     [0.5, 0, 0.3, 0, 0, 0]]
)  # fmt: skip
"""A way that ends where it begins."""
TOLERANCE, TURN_TOLERANCE = 1e-3, 0.05


def task(tmp_path: Path, rotation: str, csv: bool, more: str = "", v_max: str = CAPS) -> Order:
    poses = "poses: way.csv\n" if csv else "".join(["poses:\n", *(f"  - {row.tolist()}\n" for row in CORNERS)])
    if csv:
        heads = "x [mm];y [mm];z [m];alpha [deg];beta [deg];gamma [rad]"
        units = np.array([1e3, 1e3, 1, 180 / np.pi, 180 / np.pi, 1])
        rows = [";".join(repr(value) for value in row.tolist()) for row in CORNERS * units]
        (tmp_path / "way.csv").write_text("\ufeff" + "\r\n".join([heads, *rows]) + "\r\n")
    passing = f"approach: none\npassing: {{tolerance: {TOLERANCE}, turn_tolerance: {TURN_TOLERANCE}}}\n"
    path = tmp_path / "task.yaml"
    path.write_text(f"{HOME}h: 4 ms\nrotation: {rotation}\n{passing}{v_max}{more}{poses}{CONTROLLER}")
    return read_order(str(path))


def walked(order: Order, corners: Array = CORNERS, radius: float = 2e-3, seconds: float = 6.0) -> Poses:
    """Along the corners, each passed on a parabola that begins and ends radius before and behind it: a quarter of the
    radius off a right corner, over the root of two. The law of motion is a quintic."""
    ways = np.linalg.norm(np.diff(corners[:, :3], axis=0), axis=1)
    at = np.r_[0.0, np.cumsum(ways)]
    share = np.linspace(0, 1, round(seconds / H) + 1)
    s = at[-1] * share**3 * (10 - share * (15 - 6 * share))
    pose = np.column_stack([np.interp(s, at, column) for column in corners.T])
    for i in range(1, len(corners) - 1):
        near = np.abs(s - at[i]) < radius
        before, behind = ((corners[i] - corners[i - 1]) / ways[i - 1], (corners[i + 1] - corners[i]) / ways[i])
        ends = np.array([corners[i] - radius * before, corners[i] + radius * behind])
        curve = CubicHermiteSpline([at[i] - radius, at[i] + radius], ends, np.array([before, behind]))
        pose[near] = curve(s[near])
    return rows_of(order, pose)


def rows_of(order: Order, pose: Array) -> Poses:
    assert order.start is not None
    zero = Rotation.from_quat(order.start.q, scalar_first=True)
    q = (Rotation.from_euler("xyz", pose[:, 3:]) * zero).as_quat(scalar_first=True)
    rounding = np.full(len(pose), 1e-15)
    return Poses(np.arange(len(pose)) * H, pose[:, :3], q, rounding, rounding, H)


def broken(order: Order, rows: Poses, exact: bool = True) -> set[str]:
    return {found.check for found in check_sequence(order, rows, exact=exact) if not found.passed}


@pytest.mark.parametrize("csv", [False, True])
@pytest.mark.parametrize("rotation", ["tait-bryan", "slerp"])
def test_a_way_within_the_tolerances_is_legal(rotation: str, csv: bool, tmp_path: Path) -> None:
    order = task(tmp_path, rotation, csv)
    found = [*check_sequence(order, walked(order))]
    assert [one.message for one in found if not one.passed] == []
    by_check = {one.check: one for one in found}
    assert {"order of poses", "path", "orientation", "poses passed", "v_max", "a_max"} <= by_check.keys()
    # a parabola about a right corner is a quarter of its reach times the root of two away from it
    assert by_check["poses passed"].value == pytest.approx(2e-3 * np.sqrt(2) / 4, rel=1e-3)
    assert by_check["path"].value == pytest.approx(2e-3 / 4, rel=0.02)
    if csv:
        assert str(by_check["path"].source).startswith(str(tmp_path / "way.csv"))


Spoil = Callable[[Order], Iterator[Poses]]
SPOILED: list[tuple[str, Callable[[Order], Poses], set[str], set[str]]] = []


def spoiled(*checks: str, besides: tuple[str, ...] = ()) -> Callable[..., None]:
    def add(make: Callable[[Order], Poses]) -> None:
        SPOILED.append((make.__name__, make, set(checks), set(besides)))

    return add


def pose_of(order: Order, rows: Poses) -> Array:
    assert order.start is not None
    zero = Rotation.from_quat(order.start.q, scalar_first=True)
    angles = (Rotation.from_quat(rows.q, scalar_first=True) * zero.inv()).as_euler("xyz")
    return np.column_stack([rows.p, np.unwrap(angles, axis=0)])


@spoiled("order of poses", "pose reached", "poses missing")
def a_corner_cut_too_wide(order: Order) -> Poses:
    return walked(order, radius=6.5e-3)


@spoiled("order of poses", "pose reached", "poses missing")
def a_pose_left_out(order: Order) -> Poses:
    return walked(order, np.delete(CORNERS, 2, axis=0))


@spoiled("order of poses", "pose reached", "poses missing")
def the_other_way_round(order: Order) -> Poses:
    return walked(order, CORNERS[::-1].copy())


@spoiled("order of poses", "pose reached", "poses missing", besides=("standing",))
def standing_where_it_ends(order: Order) -> Poses:
    return rows_of(order, np.tile(CORNERS[0], (50, 1)))


@spoiled("order of poses", "pose reached", "poses missing", besides=("poses passed",))
def beside_the_way(order: Order) -> Poses:
    pose = pose_of(order, walked(order))
    pose[:, 2] += 1.1 * TOLERANCE * np.sin(np.linspace(0, np.pi, len(pose))) ** 4
    return rows_of(order, pose)


@spoiled("order of poses", "pose reached", "poses missing")
def turned_off_the_way(order: Order) -> Poses:
    pose = pose_of(order, walked(order))
    pose[:, 5] += 1.3 * TURN_TOLERANCE * np.sin(np.linspace(0, np.pi, len(pose))) ** 4
    return rows_of(order, pose)


@spoiled("order of poses", "pose reached", "poses missing")
def back_for_more_than_the_tolerance(order: Order) -> Poses:
    pose = pose_of(order, walked(order))
    row = int(np.searchsorted(pose[:, 0], 0.53))
    return rows_of(order, np.concatenate([pose[:row], pose[row - 30 : row][::-1], pose[row - 30 :]]))


@spoiled("v_max", besides=("omega_max", "a_max", "epsilon_max"))
def too_fast(order: Order) -> Poses:
    return walked(order, seconds=3.7)


@spoiled("a_max")
def a_jolt(order: Order) -> Poses:
    pose = pose_of(order, walked(order))
    pose[len(pose) // 3, 1] += 1.5 * H * H
    return rows_of(order, pose)


@spoiled("last pose", besides=("rows behind the end",))
def beside_the_end(order: Order) -> Poses:
    pose = pose_of(order, walked(order))
    pose[-1, 2] += 1e-10
    return rows_of(order, pose)


@pytest.mark.parametrize("rotation", ["tait-bryan", "slerp"])
@pytest.mark.parametrize("name", [name for name, *_ in SPOILED])
def test_what_leaves_the_way_is_caught(name: str, rotation: str, tmp_path: Path) -> None:
    make, checks, besides = next((make, checks, besides) for one, make, checks, besides in SPOILED if one == name)
    order = task(tmp_path, rotation, csv=False)
    found = broken(order, make(order))
    assert checks <= found <= checks | besides, found


def test_the_pose_at_a_tip_is_passed_within_the_tolerance(tmp_path: Path) -> None:
    """Every row is on the way, and in order: it is the pose where the way turns back that nobody comes near."""
    order = task(tmp_path, "tait-bryan", csv=False)
    tip = CORNERS[[0, 1, 0]]
    text = (tmp_path / "task.yaml").read_text()
    listed = "".join(f"  - {row.tolist()}\n" for row in CORNERS)
    (tmp_path / "task.yaml").write_text(text.replace(listed, "".join(f"  - {row.tolist()}\n" for row in tip)))
    order = read_order(str(tmp_path / "task.yaml"))

    def back_at(share: float) -> Poses:
        s = share * np.sin(np.linspace(0, np.pi, 751)) ** 2
        return rows_of(order, tip[0] + s[:, None] * (tip[1] - tip[0]))

    assert broken(order, back_at(0.99)) == set()
    assert broken(order, back_at(0.97)) == {"poses passed"}


def test_caps_are_those_of_the_leg(tmp_path: Path) -> None:
    order = task(tmp_path, "tait-bryan", csv=False, v_max=CAPS.replace("v_max: 0.1", "v_max: [0.1, 0.1, 0.03, 0.1]"))
    slow = [one for one in check_sequence(order, walked(order)) if not one.passed]
    assert {one.check for one in slow} == {"v_max"}
    assert slow[0].limit == 0.03
    order = task(tmp_path, "tait-bryan", csv=False, v_max=CAPS.replace("v_max: 0.1", "v_max: [0.03, 0.1, 0.1, 0.03]"))
    assert broken(order, walked(order, seconds=12.0)) == set()


def test_a_stop_among_poses_that_are_passed(tmp_path: Path) -> None:
    order = task(tmp_path, "tait-bryan", csv=False)
    text = (tmp_path / "task.yaml").read_text()
    row = f"  - {CORNERS[2].tolist()}\n"
    (tmp_path / "task.yaml").write_text(text.replace(row, f"  - {{at: {CORNERS[2].tolist()}, dwell: 50 ms}}\n"))
    halves = [walked(order, corners, seconds=3.5) for corners in (CORNERS[:3], CORNERS[2:])]
    first, second = (pose_of(order, half) for half in halves)
    stopping = read_order(str(tmp_path / "task.yaml"))
    whole = np.concatenate([first, np.tile(first[-1], (13, 1)), second[1:]])
    assert broken(stopping, rows_of(order, whole)) == set()
    assert broken(stopping, rows_of(order, np.concatenate([first, second[1:]]))) == {"dwell"}
    assert broken(stopping, walked(order)) == {"pose reached", "poses missing", "order of poses"}


@pytest.mark.parametrize(("approach", "legs"), [("line", 5), ("none", 4), ("joint", 4), ("", 5)])
def test_the_way_from_the_start_to_the_first_pose(approach: str, legs: int, tmp_path: Path) -> None:
    order = task(tmp_path, "tait-bryan", csv=False)
    text = (tmp_path / "task.yaml").read_text().replace("approach: none", f"approach: {approach}" if approach else "")
    (tmp_path / "task.yaml").write_text(text.replace("v_max: 0.1", "v_max: [1, 2, 3, 4]"))
    assert order.start is not None
    start = order.start
    begin = start if approach in ("line", "") else FramePose(CORNERS[0, :3], start.q)
    found = read_order(str(tmp_path / "task.yaml"), first=lambda *_: begin)
    assert found.stops is not None
    assert len(found.stops) == legs + 1
    assert found.driven == (approach == "joint")
    assert found.caps["v_max"] == ([1, 1, 2, 3, 4] if legs == 5 else [1, 2, 3, 4])
    if legs == 5:
        np.testing.assert_array_equal(found.stops[0].pose, np.r_[start.p, 0, 0, 0])
        assert (found.stops[0].dwell, found.stops[1].rests) == (0, True)
    if approach == "joint":
        # relative angles count from where the controller is switched on; orientations stay those of the task
        assert found.start is not None
        np.testing.assert_array_equal(found.start.p, CORNERS[0, :3])
        now = np.array([stop.pose[3:] for stop in found.stops])
        was_R, now_R = (
            Rotation.from_euler("xyz", angles) * Rotation.from_quat(zero.q, scalar_first=True)
            for angles, zero in ((CORNERS[:, 3:], start), (now, found.start))
        )
        np.testing.assert_allclose((was_R.inv() * now_R).magnitude(), 0, atol=1e-14)
