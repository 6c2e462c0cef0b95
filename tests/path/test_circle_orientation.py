"""How MoveC turns the tool, against the rule of the manual (MoveC, CirPathMode) written down here with SciPy alone, on
programs that are drawn from the rule; planner's and judge's geometry, each by itself."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest
from path_checks import check_expression, check_slopes
from scipy.spatial.transform import Rotation, Slerp
from small_cells import plant_without_rail, rapid

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.geometry import Array, pose
from trajopt_cli.judge.geometry import Arc as JudgesArc
from trajopt_cli.judge.geometry import Line as JudgesLine
from trajopt_cli.motion import CirPathMode, MoveC, MoveL, Program
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.corner import Corner
from trajopt_cli.path.line import Line
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.problem.plannable import check_plannable, planned_otherwise

S = np.linspace(0.0, 1.0, 33)
N = "[9E9,9E9,9E9,9E9,9E9,9E9]"
DOWN = Rotation.from_quat([0, 1, 0, 0])


class Circle(NamedTuple):
    """A circle's frame as a rotation, its centre and radius [m], the sweep [rad] and the circle point's share of it."""

    frame: Rotation
    centre: Array
    radius: float
    sweep: float
    share: float = 0.5

    def path(self, s: float) -> Rotation:
        """The frame of the path at a share of the way: x radial, y tangent, z normal."""
        return self.frame * Rotation.from_rotvec([0, 0, s * self.sweep])

    def point(self, s: float) -> Array:
        return np.asarray(self.centre + self.radius * self.path(s).as_matrix()[:, 0])


def relative(circle: Circle, first: Rotation, by: Array, s: float) -> Rotation:
    """The tool at a share of the way that begins as first against the path's frame and turns evenly by a vector."""
    return circle.path(s) * first * Rotation.from_rotvec(s * by)


def written(p: Array, R: Rotation) -> str:
    x, y, z, w = R.as_quat()
    values = ",".join(f"{v:.12f}" for v in (w, x, y, z))
    return f"[[{','.join(f'{1e3 * v:.9f}' for v in p)}],[{values}],[0,0,0,0],{N}]"


def program_of(circle: Circle, first: Rotation, via: Rotation, last: Rotation, mode: str = "") -> Program:
    points = [written(circle.point(s), R) for s, R in ((0, first), (circle.share, via), (1, last))]
    body = f"{mode} MoveL {points[0]},v100,fine,tool0;\nMoveC {points[1]},{points[2]},v100,fine,tool0;"
    return rapid(body)


def both(program: Program) -> tuple[Arc, JudgesArc]:
    """The last motion, a MoveC, as planner and judge draw it."""
    line, arc = program.motions[-2:]
    assert isinstance(line, MoveL)
    assert isinstance(arc, MoveC)
    way = segment_of(arc, line.X_WT)
    ends = JudgesLine.between(line.X_WT, arc.X_WT, line.X_WT[None, :3, :3])
    judged = JudgesArc.through(ends, arc.X_WV, arc.settings.circle)
    assert isinstance(way, Arc)
    assert judged is not None
    return way, judged


def check(program: Program, wanted: list[Rotation], tolerance: float = 3e-6) -> None:
    """At the shares S; a num has 24 bits."""
    way, judged = both(program)
    R = Rotation.concatenate(wanted)
    for found in (way.pose(S)[:, :3, :3], judged.at(S)[1]):
        assert (R.inv() * Rotation.from_matrix(found)).magnitude().max() < tolerance


def some_circle(rng: np.random.Generator) -> Circle:
    return Circle(
        Rotation.random(rng=rng), np.array([0.45, 0.0, 0.4]) + rng.uniform(-0.05, 0.05, 3),
        float(rng.uniform(0.03, 0.15)), float(np.radians(rng.uniform(20, 235))), float(rng.uniform(0.3, 0.7)),
    )  # fmt: skip


@pytest.mark.parametrize("seed", range(20))
def test_by_default_the_tool_turns_against_the_path(seed: int) -> None:
    """By anything up to nearly a whole turn: the circle point, taught to 20 deg, tells which way."""
    rng = np.random.default_rng(seed)
    circle, first = some_circle(rng), Rotation.random(rng=rng)
    axis = rng.normal(size=3)
    by = axis / np.linalg.norm(axis) * np.radians(0 if seed == 0 else rng.uniform(0, 300))
    taught = Rotation.from_rotvec(rng.uniform(-1, 1, 3) / 2 * np.radians(20))
    via, last = relative(circle, first, by, circle.share) * taught, relative(circle, first, by, 1)
    mode = ("", "CirPathMode \\PathFrame;", "CirPathMode;")[seed % 3]
    program = program_of(circle, circle.path(0) * first, via, last, mode)
    check(program, [relative(circle, first, by, s) for s in S])


@pytest.mark.parametrize("seed", range(20))
def test_in_the_object_frame_it_turns_as_on_a_line(seed: int) -> None:
    """Whatever the circle point says."""
    rng = np.random.default_rng(100 + seed)
    circle, first = some_circle(rng), Rotation.random(rng=rng)
    last = first * Rotation.from_rotvec(rng.uniform(-1.7, 1.7, 3))
    program = program_of(circle, first, Rotation.random(rng=rng), last, "CirPathMode \\ObjectFrame;")
    check(program, list(Slerp([0, 1], Rotation.concatenate([first, last]))(S)))


@pytest.mark.parametrize("seed", range(20))
def test_through_the_circle_points_orientation(seed: int) -> None:
    """At the circle point it is the circle point's, smooth there, and even where the three lie on one even turn."""
    rng = np.random.default_rng(200 + seed)
    circle, first = some_circle(rng), Rotation.random(rng=rng)
    via = first * Rotation.from_rotvec(rng.uniform(-1, 1, 3))
    last = via * Rotation.from_rotvec(rng.uniform(-1, 1, 3))
    program = program_of(circle, first, via, last, "CirPathMode \\CirPointOri;")
    way, judged = both(program)
    shares = np.array([0.0, circle.share, 1.0])
    wanted = Rotation.concatenate([first, via, last])
    for found in (way.pose(shares)[:, :3, :3], judged.at(shares)[1]):
        assert (wanted.inv() * Rotation.from_matrix(found)).magnitude().max() < 3e-6
    np.testing.assert_allclose(judged.at(S)[1], way.pose(S)[:, :3, :3], atol=1e-9)
    assert way.angle == pytest.approx(judged.angle, rel=1e-3)
    steps = Rotation.from_matrix(way.pose(S)[:, :3, :3])
    assert way.fastest_turn >= (steps[:-1].inv() * steps[1:]).magnitude().max() * (len(S) - 1) * 0.999
    turn = rng.uniform(-2, 2, 3)
    even = [first * Rotation.from_rotvec(s * turn) for s in S]
    via, last = first * Rotation.from_rotvec(circle.share * turn), even[-1]
    check(program_of(circle, first, via, last, "CirPathMode \\CirPointOri;"), even)


@pytest.mark.parametrize("degrees", [60, 170, 180, 200, 235])
@pytest.mark.parametrize("nudge", [-1e-6, 0.0, 1e-6])
def test_nothing_hangs_on_the_last_digit(degrees: int, nudge: float) -> None:
    """A torch that leans inwards goes around with the tube; one whose three orientations are the same does not turn at
    all: at 180 deg and beside it, too, where the shorter turn changes sides."""
    circle = Circle(Rotation.identity(), np.array([0.45, 0, 0.4]), 0.1, np.radians(degrees))
    lean = Rotation.from_euler("y", 210 + nudge, degrees=True)
    inwards = [circle.path(s) * lean for s in S]
    check(program_of(circle, inwards[0], inwards[16], inwards[-1]), inwards)
    tilt = Rotation.from_euler("x", nudge)
    check(program_of(circle, DOWN, DOWN * tilt, DOWN), [DOWN] * len(S), tolerance=1e-5)


def test_half_a_turn_to_nowhere_is_refused_by_line() -> None:
    """Against the path the tool turns by half a turn, and its circle point still has the orientation of the start."""
    circle = Circle(Rotation.identity(), np.array([0.45, 0, 0.4]), 0.1, 2.0)
    half = np.array([0, np.pi, 0])
    via, last = circle.path(0.5) * DOWN, relative(circle, DOWN, half, 1)
    program = program_of(circle, DOWN, via, last)
    with pytest.raises(InputErrorGroup) as caught:
        check_plannable(program, plant_without_rail())
    (error,) = caught.value.errors
    assert (error.file, error.line) == ("t.mod", 6)
    check_plannable(program_of(circle, DOWN, relative(circle, DOWN, half, 0.4), last), plant_without_rail())


@pytest.mark.parametrize("mode", ["Wrist45", "Wrist46", "Wrist56"])
def test_arcs_of_the_wrist_alone_are_refused_by_line(mode: str) -> None:
    circle = Circle(Rotation.identity(), np.array([0.45, 0, 0.4]), 0.1, 2.0)
    program = program_of(circle, DOWN, DOWN, DOWN, f"CirPathMode \\{mode};")
    with pytest.raises(InputErrorGroup) as caught:
        check_plannable(program, plant_without_rail())
    (error,) = caught.value.errors
    assert (error.file, error.line) == ("t.mod", 6)
    assert mode in str(error)


@pytest.mark.parametrize(("share", "allowed"), [(0.2, False), (0.26, True), (0.74, True), (0.8, False)])
def test_the_circle_point_of_cirpointori_lies_in_the_middle_half(share: float, allowed: bool) -> None:
    circle = Circle(Rotation.identity(), np.array([0.45, 0, 0.4]), 0.1, 2.0, share)
    program = program_of(circle, DOWN, DOWN, DOWN, "CirPathMode \\CirPointOri;")
    if allowed:
        check_plannable(program, plant_without_rail())
    else:
        with pytest.raises(InputErrorGroup):
            check_plannable(program, plant_without_rail())
    assert any("CirPointOri" in line for line in planned_otherwise(program))


def test_one_mode_at_a_time() -> None:
    with pytest.raises(InputError) as caught:
        rapid("CirPathMode \\PathFrame \\ObjectFrame;")
    assert (caught.value.file, caught.value.line) == ("t.mod", 5)


MODES = (CirPathMode.PATH_FRAME, CirPathMode.OBJECT_FRAME, CirPathMode.CIR_POINT_ORI)


def some_arc(rng: np.random.Generator, mode: CirPathMode) -> Arc:
    circle, first = some_circle(rng), Rotation.random(rng=rng)
    turns = [Rotation.identity(), *(Rotation.from_rotvec(rng.uniform(-1, 1, 3)) for _ in range(2))]
    X_0, X_V, X_1 = (
        pose((first * turn).as_matrix(), circle.point(s)) for s, turn in zip((0, circle.share, 1), turns, strict=True)
    )
    return Arc.through(X_0, X_V, X_1, mode)


@pytest.mark.parametrize("mode", MODES)
def test_slopes_and_expressions_in_every_mode(mode: CirPathMode) -> None:
    rng = np.random.default_rng(3)
    for _ in range(4):
        arc = some_arc(rng, mode)
        check_slopes(arc, rng, bound=60.0)
        rates = np.linalg.norm(arc.twist(np.linspace(0, 1, 2001))[:, 3:], axis=1)
        assert arc.angle == pytest.approx(np.trapezoid(rates, dx=1 / 2000), rel=1e-3)
        assert arc.fastest_turn == pytest.approx(rates.max(), rel=1e-4)
        assert (arc.symbols.spins, arc.symbols.turns == 2) == (mode is MODES[0], mode is MODES[2])
        check_expression(arc, rng)


@pytest.mark.parametrize("mode", MODES)
def test_corners_of_such_arcs_are_smooth(mode: CirPathMode) -> None:
    """Slopes inside, and at both ends those of the arc and of the line, twice as fast by their own shares."""
    rng = np.random.default_rng(4)
    for _ in range(3):
        arc = some_arc(rng, mode)
        line = Line(arc.X_1, pose(Rotation.random(rng=rng).as_matrix(), arc.X_1[:3, 3] + rng.uniform(0.05, 0.2, 3)))
        size = 0.3 * min(arc.length, line.length)
        corner = Corner.of_zone(arc, line, size, 1.5 * size)
        check_slopes(corner, rng, bound=400.0)
        ends = corner.twist(np.array([0.0, 1.0]))
        np.testing.assert_allclose(
            ends[0], 2 * corner.fraction_before * arc.twist(np.array([1 - corner.fraction_before]))[0]
        )
        np.testing.assert_allclose(
            ends[1], 2 * corner.fraction_after * line.twist(np.array([corner.fraction_after]))[0]
        )
        X = corner.pose(np.array([0.0, 1.0]))
        np.testing.assert_allclose(X[0], arc.pose(np.array([1 - corner.fraction_before]))[0], atol=1e-12)
        np.testing.assert_allclose(X[1], line.pose(np.array([corner.fraction_after]))[0], atol=1e-12)


@pytest.mark.parametrize("about", [0.0, 0.7])
def test_a_tool_that_turns_about_the_normal_alone_has_one_turn(about: float) -> None:
    """As one that stands in the world: against the path's frame it turns, and with that about the same axis."""
    X_0, X_1 = (pose((Rotation.from_rotvec([0, 0, a]) * DOWN).as_matrix(), [a - 1, 0, 0]) for a in (0.0, about))
    X_1[:3, 3] = [1, 0, 0]
    via = pose((Rotation.from_rotvec([0, 0, about / 2]) * DOWN).as_matrix(), [0, 1, 0])
    arc = Arc.through(X_0, via, X_1, CirPathMode.PATH_FRAME)
    assert (arc.spin, arc.angle) == (0.0, pytest.approx(about, abs=1e-12))
    expected = [(Rotation.from_rotvec([0, 0, s * about]) * DOWN).as_matrix() for s in S]
    np.testing.assert_allclose(arc.pose(S)[:, :3, :3], expected, atol=1e-12)
