"""The rows of every relation against numbers from the numeric kinematics, with a rail and without."""

from __future__ import annotations

import numpy as np
import pytest
from heavy_cells import heavy_on_rail
from small_cells import MOUNTS, mounted, plant_without_rail, safe_arm
from tcp_motion import forward_acceleration, forward_velocity, inverse_acceleration, inverse_velocity

from trajopt_cli.geometry import Array, axis_angle, inverse_pose, pose, rotation_about
from trajopt_cli.nlp.block_cache import Maps
from trajopt_cli.nlp.constraint import Relation
from trajopt_cli.nlp.formulation import DWELL, JOINTS, Formulation
from trajopt_cli.nlp.nlp_assembly import BlockNlp
from trajopt_cli.path.arc import Arc, ArcSymbols
from trajopt_cli.path.line import Line, LineSymbols
from trajopt_cli.robot.dynamics import Dynamics, ToolLoad
from trajopt_cli.robot.symbolic_dynamics import load_parameters
from trajopt_cli.robot.symbolic_inverse import branch_signs
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.limits.joint_torque import JointTorque
from trajopt_cli.trajectories.limits.tool_limit import ToolCap, ToolKind, ToolLimit

X_FT = pose(rotation_about([0.6, 0, 0.8], 0.7), [0.05, -0.03, 0.12])


@pytest.fixture(scope="module", params=[*MOUNTS[1:], "no rail"])
def axes(request: pytest.FixtureRequest) -> Axes:
    return Axes.of(plant_without_rail()) if request.param == "no rail" else mounted(request.param)


@pytest.fixture(scope="module")
def formulation(axes: Axes) -> Formulation:
    return Formulation(axes, Maps())


def rails(axes: Axes, value: float) -> Array:
    """A rail value (r,): nothing without a rail."""
    return np.full(axes.layout.r, value)


def lines(axes: Axes, rng: np.random.Generator, turning: bool, n: int = 12) -> list[tuple[Array, Array, float, int]]:
    """Lines of the tool (X_0, X_1 in the world), a rail position and a branch that serve their middle."""
    out = []
    for q in safe_arm(rng, axes, n, 0.35):
        d = rng.uniform(0.2, 0.8)
        middle = axes.forward(axes.layout.join(d, q)) @ X_FT
        way, axis = rng.normal(size=3) * 0.04, rng.normal(size=3)
        half = rotation_about(axis / np.linalg.norm(axis), 0.25 if turning else 0.0)
        X_0, X_1 = pose(middle[:3, :3] @ half.T, middle[:3, 3] - way), pose(middle[:3, :3] @ half, middle[:3, 3] + way)
        numeric = axes.inverse(axes.forward(axes.layout.join(d, q))[None], np.array([d]))[0]
        out.append((X_0, X_1, d, int(np.nanargmin(np.abs(np.sin((numeric - q) / 2)).sum(axis=1)))))
    return out


def poses(axes: Axes, rng: np.random.Generator, n: int) -> list[tuple[Array, float, int]]:
    """Poses of the tool in reach: the middles of lines."""
    return [(Line(a, b).pose(np.array([0.5]))[0], d, cfx) for a, b, d, cfx in lines(axes, rng, True, n)]


def parameters(axes: Axes, X_0: Array, X_1: Array, cfx: int, near: Array) -> dict[str, object]:
    """A path put together from the two world poses, its branch, and joints near it."""
    T_0, T_1 = axes.in_base(X_0), axes.in_base(X_1)
    axis, angle = axis_angle(T_0[:3, :3].T @ T_1[:3, :3])
    R = (T_0 @ inverse_pose(X_FT))[:3, :3]
    chord = T_1[:3, 3] - T_0[:3, 3]
    path = np.concatenate([T_0[:3, 3], chord, R.T.ravel(), X_FT[:3, :3] @ axis, [angle], X_FT[:3, 3]])
    return {"path": path, "branch": branch_signs(cfx), "near": near}


def at_node(V: Array, A: Array, room: Array) -> dict[str, object]:
    return {"V": V, "A": A, "room": room}


def motion_at(axes: Axes, X_0: Array, X_1: Array, cfx: int, s: float, d: float, v: float, w: float, a: float, b: float):
    """q, qd, qdd in scaled time from poses, Jacobian and its rate: no expression involved."""
    X_WT = Line(X_0, X_1).pose(np.array([s]))
    arm = axes.inverse(X_WT @ inverse_pose(X_FT), np.array([d]))[0, cfx]
    q = axes.layout.join(d, arm)
    axis, angle = axis_angle(X_0[:3, :3].T @ X_1[:3, :3])
    twist = np.r_[X_1[:3, 3] - X_0[:3, 3], X_0[:3, :3] @ axis * angle]
    qd = inverse_velocity(axes.robot, q, twist * v, w, X_FT)
    qdd = inverse_acceleration(axes.robot, q, qd, twist * a, b, X_FT)
    return q, qd, qdd


def node_rows(axes: Axes, cfx: int, q: Array, qd: Array, qdds: list[Array], T: float, V: Array, A: Array, room: Array):
    arm = axes.layout.arm
    middle, half = (axes.upper + axes.lower)[arm] / 2, (axes.upper - axes.lower)[arm] / 2
    wrist = -1.0 if cfx & 1 else 1.0
    wanted = [np.sin(q[arm][2]), wrist * np.sin(q[arm][4]), qd / (V * T), *(qdd / (A * T**2) for qdd in qdds)]
    return np.hstack([*wanted, (q[arm] - middle) / (half * room[arm])])


def test_rows_of_a_tool_that_turns_beyond_its_line(axes: Axes, formulation: Formulation) -> None:
    """The tool goes along its line and turns about an axis of its own besides: pose, twist and its rate by hand."""
    rng, k, u = np.random.default_rng(12), axes.n, np.array([0.36, 0.48, 0.8])
    node = formulation.with_turns.node(LineSymbols(True), "l")
    kind = ToolKind((*ToolCap,), along=False, turning=True)
    tool = formulation.with_turns.limit_node(ToolLimit(axes), kind, LineSymbols(True), "l")
    for X_0, X_1, d, cfx in lines(axes, rng, True):
        s, v, a, w, b, T = rng.uniform(0.2, 0.8), *rng.normal(size=4), rng.uniform(0.3, 2)
        f, df, ddf = rng.normal(size=3) * [0.3, 1.0, 1.0]
        X = Line(X_0, X_1).pose(np.array([s]))
        X[0, :3, :3] = X[0, :3, :3] @ rotation_about(u, f)
        q = axes.layout.join(d, axes.inverse(X @ inverse_pose(X_FT), np.array([d]))[0, cfx])
        if not np.isfinite(q).all():
            continue
        twist, u_W = Line(X_0, X_1).twist(np.array([s]))[0], np.r_[0, 0, 0, X[0, :3, :3] @ u]
        carried = np.r_[0, 0, 0, np.cross(twist[3:], u_W[3:])] * v * df
        qd = inverse_velocity(axes.robot, q, twist * v + u_W * df, w, X_FT)
        qdd = inverse_acceleration(axes.robot, q, qd, twist * a + u_W * ddf + carried, b, X_FT)
        z = {"s": s, "v": v, "a_l": a, "T": T, "d": np.r_[rails(axes, d), f], "w": np.r_[rails(axes, w), df],
             "b_l": np.r_[rails(axes, b), ddf]}  # fmt: skip
        near = q[axes.layout.arm] + rng.normal(size=axes.layout.joints) * 0.1
        p = {**parameters(axes, X_0, X_1, cfx, near), "axis": X_FT[:3, :3] @ u, "tcp": X_FT[:3, 3]}
        V, A, room = axes.velocity * 0.9, axes.acceleration * 0.8, rng.uniform(0.7, 1, k)
        rows = node.value(z, {**p, **at_node(V, A, room)})
        np.testing.assert_allclose(rows, node_rows(axes, cfx, q, qd, [qdd], T, V, A, room), rtol=1e-7, atol=1e-7)
        most, angle = rng.uniform(0.5, 2), float(np.linalg.norm(twist[3:]))
        caps = {"caps": np.array([1.0, 1.0, angle / most]), "fastest": most}
        turns = tool.value(z, {**p, **caps})
        assert {round(x, 9) for x in turns} >= {round((angle * v + sign * df) / (most * T), 9) for sign in (1, -1)}
        assert np.linalg.norm((twist * v + u_W * df)[3:]) / (most * T) <= np.abs(turns).max() + 1e-9


@pytest.mark.parametrize("smooth", [False, True])
def test_what_the_sector_allows_at_nodes_it_allows_between(axes: Axes, smooth: bool) -> None:
    """Any piece whose inner control points are at the sector's edge, as it lies there, stays inside; evaluated by its
    own polynomial. A parabola that begins and ends at the edge, outwards, is refused."""
    formulation = Formulation(axes, Maps())
    formulation.smooth = smooth
    rng, relation, h = np.random.default_rng(3), formulation.sector(), 0.2
    low, high, slope = -0.4, 0.3, 0.25
    room = np.array([(high - low) / 2, (high + low) / 2, -slope])
    u = np.linspace(0, 1, 101)
    powers = np.array([(1 - u) ** 3, 3 * (1 - u) ** 2 * u, 3 * (1 - u) * u**2, u**3])
    refused = 0
    for _ in range(300):
        points = rng.uniform(low - 0.1, high + 0.1, 4)  # Bezier's, beyond the middle's way
        points[[0, 3]] = np.clip(points[[0, 3]], low, high)
        share = np.sort(rng.uniform(0, 1, 4))
        if not smooth:  # parabolas, raised to cubics
            points, share = (x[[0, 1, 3]] @ np.array([[1, 1 / 3, 0, 0], [0, 2 / 3, 2 / 3, 0], [0, 0, 1 / 3, 1]])
                             for x in (points, share))  # fmt: skip
        f, s = points - slope * share, share
        z = {"f_0": f[0], "f_1": f[3], "w_0": 3 * (f[1] - f[0]) / h, "w_1": 3 * (f[3] - f[2]) / h,
             "s_0": s[0], "s_1": s[3], "v_0": 3 * (s[1] - s[0]) / h, "v_1": 3 * (s[3] - s[2]) / h, "h": h}  # fmt: skip
        rows = relation.value(z, {"room": room})
        kept = bool(np.all((rows >= relation.block.shape.lower) & (rows <= relation.block.shape.upper)))
        inside = powers.T @ f + slope * (powers.T @ s)
        assert not kept or (low - 1e-9 <= inside.min() and inside.max() <= high + 1e-9)
        refused += not kept
    assert 30 < refused < 270


@pytest.mark.parametrize("sides", ["l", "lr"])
@pytest.mark.parametrize("turning", [False, True], ids=["straight", "turning"])
def test_path_rows_are_the_motion_over_its_limits(
    axes: Axes, formulation: Formulation, sides: str, turning: bool
) -> None:
    rng, track, n, k = np.random.default_rng(11), LineSymbols(turning), len(sides), axes.n
    node = formulation.node(track, sides)
    tool = formulation.limit_node(ToolLimit(axes), ToolKind((*ToolCap,), along=False), track, sides)
    assert len(node.block.shape.lower) == 2 + k + k * n + 6
    for X_0, X_1, d, cfx in lines(axes, rng, turning):
        s, v, w, T = rng.uniform(0.2, 0.8), rng.normal(), rng.normal() * 0.5, rng.uniform(0.3, 2)
        acc, rail_acc = rng.normal(size=n) * 3, rng.normal(size=n)
        V, A, room = axes.velocity * 0.9, axes.acceleration * 0.8, rng.uniform(0.7, 1, k)
        caps = rng.uniform(0.1, 1, 3)
        z = {"s": s, "v": v, "T": T, **{f"a_{side}": a for side, a in zip(sides, acc, strict=True)}}
        z |= {"d": rails(axes, d), "w": rails(axes, w)}
        z |= {f"b_{side}": rails(axes, b) for side, b in zip(sides, rail_acc, strict=True)}
        q, qd, _ = motion_at(axes, X_0, X_1, cfx, s, d, v, w, 0.0, 0.0)
        qdds = [motion_at(axes, X_0, X_1, cfx, s, d, v, w, a, b)[2] for a, b in zip(acc, rail_acc, strict=True)]
        path = parameters(axes, X_0, X_1, cfx, q[axes.layout.arm] + rng.uniform(-1, 1, 6))
        got = node.value(z, {**path, **at_node(V, A, room)})
        np.testing.assert_allclose(got, node_rows(axes, cfx, q, qd, qdds, T, V, A, room), rtol=1e-9, atol=1e-9)
        wanted = [caps[0] * v / T, caps[2] * v / T, *(caps[1] * a / T**2 for a in acc)]
        np.testing.assert_allclose(tool.value(z, {**path, "caps": caps}), wanted, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("turning", [False, True], ids=["even", "turning"])
def test_rows_of_an_arc_hold_the_acceleration_towards_its_centre(
    axes: Axes, formulation: Formulation, turning: bool
) -> None:
    """The tool's acceleration from the axes' by the numeric Jacobian is what the row says."""
    rng, k = np.random.default_rng(17), axes.n
    symbols = ArcSymbols(turning)
    node = formulation.node(symbols, "l")
    tool = formulation.limit_node(ToolLimit(axes), ToolKind((*ToolCap,), along=False), symbols, "l")
    for X_0, X_1, d, cfx in lines(axes, rng, turning, 6):
        aside = np.cross(X_1[:3, 3] - X_0[:3, 3], rng.normal(size=3))
        arc = Arc.through(X_0, (X_0 + X_1)[:3, 3] / 2 + 0.01 * aside / np.linalg.norm(aside), X_1)
        s, v, w, T, a, b = 0.55, rng.normal(), rng.normal() * 0.5, rng.uniform(0.3, 2), rng.normal() * 3, rng.normal()
        X_WF = arc.pose(np.array([s])) @ inverse_pose(X_FT)
        q = axes.layout.join(d, axes.inverse(X_WF, np.array([d]))[0, cfx])
        twist, bend = arc.twist(np.array([s]))[0], arc.twist_rate(np.array([s]))[0]
        qd = inverse_velocity(axes.robot, q, twist * v / T, w / T, X_FT)
        qdd = inverse_acceleration(axes.robot, q, qd, (twist * a + bend * v**2) / T**2, b / T**2, X_FT)
        A = forward_acceleration(axes.robot, q, qd, qdd, X_FT)[:3]
        p = {"path": arc.parameters(inverse_pose(axes.X_WB0), X_FT), "branch": branch_signs(cfx)}
        p |= {"near": q[axes.layout.arm]}
        z = {"s": s, "v": v, "d": rails(axes, d), "w": rails(axes, w), "a_l": a, "b_l": rails(axes, b), "T": T}
        got = node.value(z, {**p, **at_node(axes.velocity, axes.acceleration, np.ones(k))})
        wanted = node_rows(axes, cfx, q, qd * T, [qdd * T**2], T, axes.velocity, axes.acceleration, np.ones(k))
        np.testing.assert_allclose(got, wanted, rtol=1e-9, atol=1e-9)
        got = tool.value(z, {**p, "caps": [1, arc.length / 3, 1]})
        assert got[2] == pytest.approx(np.sum(A**2) / 3**2, rel=1e-9)
        assert tool.block.shape.upper[2] == 1.0


@pytest.mark.parametrize("sides", ["l", "lr"])
@pytest.mark.parametrize("mount", MOUNTS[1:])  # without a rail nothing moves in a dwell
def test_dwell_rows_are_the_self_motion_over_its_limits(mount: str, sides: str) -> None:
    rng, axes = np.random.default_rng(12), mounted(mount)
    formulation = Formulation(axes, Maps())
    node = formulation.node(DWELL, sides)
    for X_0, d, cfx in poses(axes, rng, 6):
        w, T, acc = rng.normal(), rng.uniform(0.3, 2), rng.normal(size=len(sides))
        q, qd, _ = motion_at(axes, X_0, X_0, cfx, 0.0, d, 0.0, w, 0.0, 0.0)
        qdds = [motion_at(axes, X_0, X_0, cfx, 0.0, d, 0.0, w, 0.0, b)[2] for b in acc]
        V, A = axes.velocity, axes.acceleration
        p = {**parameters(axes, X_0, X_0, cfx, q[axes.layout.arm]), **at_node(V, A, np.ones(axes.n))}
        z = {f"b_{side}": rails(axes, b) for side, b in zip(sides, acc, strict=True)}
        got = node.value({"d": rails(axes, d), "w": rails(axes, w), "T": T, **z}, p)
        wanted = node_rows(axes, cfx, q, qd, qdds, T, V, A, np.ones(axes.n))
        np.testing.assert_allclose(got, wanted, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("way", ["line", "tied", "dwell"])
def test_torque_rows_are_pins_forces_and_torques(way: str) -> None:
    """On a rail at a slant, whose force has a row, too: what is beyond gravity by the share of what gravity leaves."""
    slant = rotation_about([0.6, 0, 0.8], 0.4)
    axes, rng = Axes.of(heavy_on_rail(pose(slant, [0.1, 0.2, 0.3]))), np.random.default_rng(21)
    torque = JointTorque(axes)
    load = ToolLoad(3.0, np.array([0.1, 0.02, 0.05]), np.diag([0.02, 0.03, 0.04]))
    standing = Dynamics(axes.robot, load, rotor=axes.plant.robot.rotor)
    formulation, track = Formulation(axes, Maps()), LineSymbols(True)
    place = DWELL if way == "dwell" else track
    rows = formulation.limit_node(torque, torque.limited, place, "lr", way == "tied")
    for X_0, X_1, d, cfx in lines(axes, rng, True, 4):
        s, v, w, T = rng.uniform(0.3, 0.7), rng.normal(), rng.normal() * 0.5, rng.uniform(0.3, 2)
        acc, rail_acc = rng.normal(size=2) * 3, rng.normal(size=2)
        if way == "dwell":
            X_1, s, v, acc = X_0, 0.0, 0.0, np.zeros(2)
        tie = {"d_0": np.array([d - s * 0.3]), "span": np.array([0.3])} if way == "tied" else {}
        if tie:
            w, rail_acc = 0.3 * v, 0.3 * acc
        share, limit = rng.uniform(0.5, 1, 7), torque.limit
        wanted = []
        for a, b in zip(acc, rail_acc, strict=True):
            q, qd, qdd = motion_at(axes, X_0, X_1, cfx, s, d, v, w, a, b)
            rest = standing.gravity_torque(q)
            wanted.append((standing.torque(q, qd / T, qdd / T**2) - rest) / (share * limit) + rest / limit)
        near = q[axes.layout.arm] + rng.uniform(-1, 1, 6)
        p = {**parameters(axes, X_0, X_1, cfx, near), **tie}
        p |= {"load": load_parameters(load), "limit": limit, "share": share}
        values = {"s": s, "v": v, "d": rails(axes, d), "w": rails(axes, w), "T": T}
        for i, side in enumerate("lr"):
            values |= {f"a_{side}": acc[i], f"b_{side}": rails(axes, rail_acc[i])}
        got = rows.value({name: values[name] for name in rows.z.shapes}, p)
        np.testing.assert_allclose(got, np.ravel(wanted), rtol=1e-8, atol=1e-9)


def test_waypoint_rows_vanish_at_the_self_motion_and_nowhere_else(axes: Axes, formulation: Formulation) -> None:
    rng = np.random.default_rng(13)
    arm = axes.layout.arm
    for X_0, d, cfx in poses(axes, rng, 6):
        w = rng.normal()
        q, qd, _ = motion_at(axes, X_0, X_0, cfx, 0.0, d, 0.0, w, 0.0, 0.0)
        p = parameters(axes, X_0, X_0, cfx, q[arm])
        off = rng.normal(size=12) * 0.01
        z = {"d": rails(axes, d), "q": q[arm] + off[:6]}
        moving = {"w": rails(axes, w), "qd": qd[arm] + off[6:]}
        got = formulation.waypoint().value({**z, **moving}, p)
        np.testing.assert_allclose(got[:12], off, rtol=0, atol=1e-9)
        walls = [np.sin(q[arm][2]), abs(np.sin(q[arm][4]))]
        np.testing.assert_allclose(got[12:], walls, atol=1e-9)
        got = formulation.resting_waypoint().value(z, p)
        np.testing.assert_allclose(got, [*off[:6], *walls], rtol=0, atol=1e-9)


@pytest.mark.parametrize("cap", ToolCap)
@pytest.mark.parametrize("name", ["turned", "no rail"])  # expressions follow the URDF, which knows no slanted rail
def test_tool_rows_are_squared_shares_of_the_caps(name: str, cap: ToolCap) -> None:
    axes = Axes.of(plant_without_rail()) if name == "no rail" else mounted(name)
    rng, n, formulation = np.random.default_rng(14), axes.n, Formulation(axes, Maps())
    row = formulation.limit_node(ToolLimit(axes), ToolKind((cap,), along=False), JOINTS, "l")

    def share(q: Array, v: Array, a: Array, T: float, limit: float) -> float:
        V, A = forward_velocity(axes.robot, q, v / T, X_FT), forward_acceleration(axes.robot, q, v / T, a / T**2, X_FT)
        value = {ToolCap.SPEED: V[:3], ToolCap.ACCELERATION: A[:3], ToolCap.REORIENTATION: V[3:]}[cap]
        return float(np.sum((value / limit) ** 2))

    for arm in safe_arm(rng, axes, 10):
        q, v, a = axes.layout.join(rng.uniform(0, 1), arm), rng.normal(size=n), rng.normal(size=n) * 5
        T, limit = rng.uniform(0.3, 2), rng.uniform(0.5, 5)
        got = row.value({"q": q, "v": v, "a_l": a, "T": T}, {"tcp": X_FT[:3, 3], "caps": np.full(3, limit)})
        assert got == pytest.approx([share(q, v, a, T, limit)], rel=1e-9)
    assert row.block.shape.upper.tolist() == [1.0]


@pytest.mark.parametrize("name", ["turned", "no rail"])
def test_rows_along_the_tools_path_are_shares_of_speeding_up_and_slowing_down(name: str) -> None:
    """With s of the squared speed over itself and 1 mm/s squared, which is nearly 1: both rows are below 0 as long as
    v a / |v| is within its caps."""
    axes = Axes.of(plant_without_rail()) if name == "no rail" else mounted(name)
    rng, n, kind = np.random.default_rng(15), axes.n, ToolKind((ToolCap.ACCELERATION,), along=True)
    row = Formulation(axes, Maps()).limit_node(ToolLimit(axes), kind, JOINTS, "lr")
    for arm in safe_arm(rng, axes, 10):
        q, v, a = axes.layout.join(rng.uniform(0, 1), arm), rng.normal(size=n), rng.normal(size=n) * 5
        T, ramps = rng.uniform(0.3, 2), rng.uniform(0.5, 5, 2)
        V = forward_velocity(axes.robot, q, v / T, X_FT)[:3]
        A = forward_acceleration(axes.robot, q, v / T, a / T**2, X_FT)[:3]
        along, s = V @ A / np.linalg.norm(V), V @ V / (V @ V + 1e-6)
        z, p = {"q": q, "v": v, "a_l": a, "a_r": a, "T": T}, {"tcp": X_FT[:3, 3], "ramps": ramps, "caps": np.ones(3)}
        got = row.value(z, p)[2:]
        wanted = [np.sqrt(s) * along / ramps[0] - s, -np.sqrt(s) * along / ramps[1] - s] * 2
        assert got == pytest.approx(wanted, rel=1e-9)
    assert row.block.shape.upper.tolist() == [1.0, 1.0, 0.0, 0.0, 0.0, 0.0]


def test_small_relations_say_what_their_names_say(formulation: Formulation) -> None:
    rng = np.random.default_rng(15)
    x, v, a, h = rng.normal(size=4)
    exact = {"x_0": x, "v_0": v, "a": a, "x_1": x + h * v + a * h * h / 2, "v_1": v + a * h}
    np.testing.assert_allclose(formulation.integration().value(exact, {"h": h}), 0, atol=1e-15)
    np.testing.assert_allclose(formulation.zoned_integration().value({**exact, "h": h}), 0, atol=1e-15)
    off = {**exact, "x_1": exact["x_1"] + 1, "v_1": exact["v_1"] + 2}
    np.testing.assert_allclose(formulation.integration().value(off, {"h": h}), [1, 2])
    assert formulation.zones().value({"h": [0.1, 0.05, 0.1]}, {"n": 4}) == pytest.approx([0.0], abs=1e-15)
    assert formulation.velocity_link().value({"xd": 0.5, "v": 0.75, "T": 1.5}) == [0.0]
    assert formulation.equal().value({"x": 0.5, "y": 0.75}) == [-0.25]
    n = formulation.axes.n
    q, v, left, right = rng.normal(size=(4, n))
    z = {"q": q, "v": v, "a_l": left, "a_r": right, "T": 0.5}
    got = formulation.node(JOINTS, "lr").value(z, {"V": np.full(n, 2.0), "A": np.full(n, 10.0)})
    np.testing.assert_allclose(got, [*v, *(left / 2.5), *(right / 2.5)])


def test_axis_reach_rows_are_distances_to_the_reachable_interval(formulation: Formulation) -> None:
    """From rest, T = 2, V = 1, A = 2: 1.5 m either way; and |v1 - v0| <= A T."""
    limits = {"V": 1.0, "A": 2.0}
    got = formulation.axis_reach().value({"q_0": 0.0, "qd_0": 0.0, "q_1": 1.4, "qd_1": 0.0, "T": 2.0}, limits)
    np.testing.assert_allclose(got, [0.1, 2.9, 4.0, 4.0])
    got = formulation.axis_reach().value({"q_0": 1.0, "qd_0": -0.5, "q_1": 0.2, "qd_1": 0.75, "T": 2.0}, limits)
    np.testing.assert_allclose(got[2:], [2.75, 5.25])
    # -0.5 up to 1 in 0.75 s (0.1875 m), 1.125 s at 1, down to 0.75 in 0.125 s (0.109375 m); 0.8 m less is wanted
    assert got[0] == pytest.approx(0.1875 + 1.125 + 0.109375 + 0.8)


def test_a_relation_is_built_once_per_kind(formulation: Formulation) -> None:
    free = formulation.node(LineSymbols(True), "lr")
    assert formulation.node(LineSymbols(True), "lr") is free
    assert formulation.node(LineSymbols(False), "lr") is not free
    assert len({id(formulation.node(JOINTS, sides)) for sides in ("l", "r", "lr")}) == 3
    left, right = (formulation.node(JOINTS, side) for side in "lr")
    assert left.block is right.block  # names are the relation's, the functions are the same


def test_a_relation_refuses_a_name_it_does_not_have(formulation: Formulation) -> None:
    with pytest.raises(ValueError, match="the parts are xd, v, T; found xd, w, T"):
        formulation.velocity_link().value({"xd": 0.5, "w": 0.75, "T": 1.5})


def test_without_a_rail_no_relation_has_a_variable_of_one(axes: Axes, formulation: Formulation) -> None:
    """Two per node less for position and velocity, one less per acceleration; a row less for each."""
    r = axes.layout.r
    assert formulation.node(LineSymbols(True), "lr").z.size == 5 + 4 * r
    assert formulation.waypoint().z.size == 12 + 2 * r
    assert formulation.node(JOINTS, "l").z.size == 3 * (6 + r) + 1


def test_a_relation_holds_at_many_nodes_at_once(formulation: Formulation) -> None:
    """Parts with an axis more differ from node to node, the others are the same at all; matrices column by column."""
    relation = formulation.zoned_integration()
    x, v, a = np.arange(4), np.arange(4, 8), np.arange(8, 11)
    nlp = BlockNlp()
    nlp.variables(np.zeros(12), -1.0, 1.0)
    relation.holds(nlp, {"x_0": x[:-1], "v_0": v[:-1], "a": a, "x_1": x[1:], "v_1": v[1:], "h": 11})
    (held,) = nlp._held.values()
    assert held.all_z.tolist() == [[k, k + 4, k + 8, k + 1, k + 5, 11] for k in range(3)]
    with pytest.raises(ValueError, match=r"a has shape \(2,\), wanted \(\) or \(3,\)"):
        relation.holds(nlp, {"x_0": x[:-1], "v_0": v[:-1], "a": a[:2], "x_1": x[1:], "v_1": v[1:], "h": 11})


def test_rows_of_parts_are_the_vectors_of_each() -> None:
    """Matrices column by column, as an expression is split."""
    relation = Relation.of(
        Maps(), "m", "m", {"x": ()}, {"M": (2, 3), "b": (2,)}, lambda z, p: [(p.M[1, 2] + z.x, 0, 0)]
    )
    M = np.arange(12.0).reshape(2, 2, 3)
    nlp = BlockNlp()
    nlp.variables(np.zeros(2), -1.0, 1.0)
    relation.holds(nlp, {"x": [0, 1]}, {"M": M, "b": [7.0, 8.0]})
    (held,) = nlp._held.values()
    assert held.all_p.tolist() == [relation.p.vector({"M": one, "b": [7.0, 8.0]}).tolist() for one in M]
    assert relation.value({"x": 0.5}, {"M": M[0], "b": [7.0, 8.0]}) == [5.5]
