"""The judge by itself: its own interpolation and lines against SciPy's, and a machine that is nothing but data."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from types import SimpleNamespace

import numpy as np
import pytest
from legal_motion import Case, plant_with_rail, rapid_case, stream_case
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation, Slerp

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.judge.geometry import Line, inverse_pose
from trajopt_cli.judge.samples import judged_rows
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import MoveL, PoseMove
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.shapes import Box, Capsule, Solid
from trajopt_cli.trajectory import Trajectory

AXIS = np.array([2.0, -1.0, 2.0]) / 3


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(1140)


def data_of(plant: Plant) -> SimpleNamespace:
    """Everything of a plant that the judge may know, without a function on it."""
    names = ("urdf", "X_WR", "X_RB", "X_UB", "rail_axes", "axis_names", "bodies", "linkage")
    robot = SimpleNamespace(**{name: getattr(plant.robot, name) for name in names})
    return SimpleNamespace(
        **{f.name: getattr(plant, f.name) for f in fields(plant)} | {"robot": robot, "self_pairs": plant.self_pairs}
    )


@pytest.mark.parametrize(("make", "target"), [(rapid_case, Target.RAPID), (stream_case, None)])
def test_all_the_judge_takes_of_a_machine_is_data(make: Callable[[], Case], target: Target | None) -> None:
    case = make()
    wall = Solid(Box("wall", np.array([0.1, 2.0, 0.5]), pose(np.eye(3), [0.9, 0.3, 0.3])), frozenset({"link_1"}))
    pin = Solid(Capsule("pin", np.zeros(3), np.array([0, 0, 0.03]), 0.01))
    plant = replace(case.plant, obstacles=(wall,), attached=(pin,))
    wanted, found = (verify(case.program, machine, case.rows(), target=target) for machine in (plant, data_of(plant)))
    assert found == wanted
    assert {f.check for f in found.findings} >= {"clearance", "self clearance", "rail target"}


def test_the_motion_between_rows_is_the_hermite(rng: np.random.Generator) -> None:
    plant = plant_with_rail()
    t = np.cumsum(rng.uniform(1e-3, 0.2, 30))
    q, qd = rng.normal(size=(30, 7)), 3 * rng.normal(size=(30, 7))
    rows = judged_rows(plant, Trajectory(plant.limits.names, t, q, qd), None)
    times, *found = (places[:] for places in rows.hermite_places)
    spline = CubicHermiteSpline(t, q, qd)
    np.testing.assert_allclose(times[:4], t[0] + np.array([0.2, 0.4, 0.6, 0.8]) * (t[1] - t[0]), rtol=1e-15)
    for order, values in enumerate(found):
        wanted = spline(times, nu=order)
        np.testing.assert_allclose(values, wanted, rtol=1e-9, atol=1e-9 * np.abs(wanted).max())


@pytest.mark.parametrize("angle", [0.0, 1e-9, 0.4, 3.1, np.pi - 1e-5])
def test_a_line_is_chord_and_slerp(angle: float, rng: np.random.Generator) -> None:
    X_0 = pose(rotation_about([0.6, 0, 0.8], 2.0), [0.3, 0.2, 0.5])
    X_1 = pose(X_0[:3, :3] @ rotation_about(AXIS, angle), [0.1, -0.4, 0.9])
    s = np.r_[0.0, np.sort(rng.uniform(0, 1, 20)), 1.0]
    R = Slerp([0, 1], Rotation.from_matrix([X_0[:3, :3], X_1[:3, :3]]))(s).as_matrix()
    line = Line.between(X_0, X_1, R)
    p_found, R_found = line.at(s)
    np.testing.assert_allclose(p_found, X_0[:3, 3] + s[:, None] * (X_1 - X_0)[:3, 3], rtol=0, atol=1e-15)
    np.testing.assert_allclose(R_found, R, rtol=0, atol=1e-11)
    np.testing.assert_allclose(line.progress(p_found, R_found), s, rtol=0, atol=1e-14)
    assert (line.extent, line.only_turns) == (pytest.approx(np.sqrt(0.2**2 + 0.6**2 + 0.4**2)), False)


@pytest.mark.parametrize("angle", [1e-3, 0.4, 3.1])
def test_a_reorientation_is_counted_in_its_angle(angle: float) -> None:
    X_0 = pose(rotation_about([0.6, 0, 0.8], 2.0), [0.3, 0.2, 0.5])
    X_1 = pose(X_0[:3, :3] @ rotation_about(AXIS, angle), X_0[:3, 3])
    s = np.linspace(0, 1, 11)
    line = Line.between(X_0, X_1, X_0[None, :3, :3])
    p, R = line.at(s)
    np.testing.assert_allclose(line.progress(p, R), s, rtol=0, atol=1e-12)
    assert (line.extent, line.only_turns) == (pytest.approx(angle, abs=1e-12), True)


def test_the_shortest_line_is_no_reorientation() -> None:
    X_0, X_1 = np.eye(4), pose(np.eye(3), [0, 0, 5e-7])
    line = Line.between(X_0, X_1, X_0[None, :3, :3])
    s = np.linspace(0, 1, 5)
    np.testing.assert_allclose(line.progress(*line.at(s)), s, rtol=0, atol=1e-9)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("short_of", [0.0, 1e-8, -1e-8])
def test_half_a_turn_may_go_either_way(side: int, short_of: float) -> None:
    X_0 = pose(rotation_about([0.6, 0, 0.8], 2.0), [0.3, 0.2, 0.5])
    X_1 = pose(X_0[:3, :3] @ rotation_about(AXIS, np.pi - short_of), [0.1, -0.4, 0.9])
    s = np.linspace(0, 1, 9)
    went = X_0[:3, :3] @ rotation_about(side * AXIS, s * np.pi)
    found = Line.between(X_0, X_1, went).at(s)[1]
    np.testing.assert_allclose(found, went, rtol=0, atol=1e-7)


def test_poses_are_inverted() -> None:
    X: Array = pose(rotation_about(AXIS, np.array([0.3, 2.0])), np.array([[1.0, 2, 3], [-1, 0, 4]]))
    np.testing.assert_allclose(inverse_pose(X), np.linalg.inv(X), rtol=0, atol=1e-15)


class MoveS(PoseMove):
    """A spline, say."""


def test_a_kind_of_move_without_a_check_of_its_shape_is_never_legal() -> None:
    case = rapid_case()
    lines = [i for i, motion in enumerate(case.program.motions) if isinstance(motion, MoveL)]
    given = case.program.motions[lines[0]]
    assert isinstance(given, MoveL)
    spline = MoveS(**{field.name: getattr(given, field.name) for field in fields(MoveL)})
    motions = [spline if i == lines[0] else motion for i, motion in enumerate(case.program.motions)]
    report = verify(replace(case.program, motions=tuple(motions)), case.plant, case.rows(), advice=False)
    (bad,) = (found for found in report.findings if not found.passed)
    assert (bad.check, bad.source) == ("known shape", given.source)
    assert (bad.value, bad.limit, bad.unit, bad.subject) == (1.0, 0.0, "unknown", f"MoveS {given.target}")
    assert "the judge has no check for the shape of such a motion" in bad.message
