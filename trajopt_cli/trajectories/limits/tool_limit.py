"""Speed, acceleration and reorientation of the tool centre point, by the program and by the cell's caps."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.native.loops import loops
from trajopt_cli.problem.problem import Leg, LegKind
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.limits.limit import INF, Limit, MotionSamples, NodeMotion, PathRows, PathSamples, Row

# of the tool's acceleration on a half circle; the polygon passes the limit by 2 % at its corners, which the dense check
# takes back where it is used.
_TOOL_DIRECTIONS = 8
_STILL_TOOL = 1e-09  # m/s: of a tool as slow nothing is along its path.
_NO_RAMP = 1e6  # m/s2, of moves without a limit of the tool beside others that have one
_STILL_NODE = 0.001  # m/s of a tool at a node of a joint move, as above but smoothly.

_ANGLES = (np.arange(_TOOL_DIRECTIONS) + 0.5) * np.pi / _TOOL_DIRECTIONS - np.pi / 2


class ToolCap(IntEnum):
    """The columns of the limit."""

    SPEED = 0
    ACCELERATION = 1
    REORIENTATION = 2


class ToolKind(NamedTuple):
    """Which caps a leg has, whether speeding up and slowing down along the path are limited by themselves, whether it
    is a corner, and whether the tool may turn beyond its way."""

    caps: tuple[ToolCap, ...]
    along: bool
    corner: bool = False
    turning: bool = False


class ToolLimit(Limit):
    """|p'| <= v_tcp, |p''| <= a_tcp, |omega| <= v_ori; PathAccLim: -down <= p' . p'' / |p'| <= up."""

    name = "tool"
    apart = True

    def __init__(self, axes: Axes, angles: Array = _ANGLES):
        """angles: of the polygon's sides that path_rows draws about the circle of the acceleration [rad]."""
        super().__init__(axes)
        self._sides = np.column_stack([np.cos(angles), np.sin(angles)])

    @property
    def orders(self) -> Array:
        """See Limit."""
        return np.array([1.0, 2.0, 1.0])

    def numbers(self, leg: Leg) -> Array:
        """See Limit."""
        return np.array([[leg.v_tcp, 0.0, 0.0], [leg.a_tcp, *leg.ramps], [leg.v_ori, 0.0, 0.0]])

    def labels(self, leg: Leg) -> list[str]:
        """See Limit."""
        capped = leg.v_tcp < self.axes.plant.tcp.speed
        return ["programmed TCP speed" if capped else "TCP speed", "TCP acceleration", "TCP turning"]

    def ratios(self, motion: MotionSamples) -> Array:
        """See Limit; of the acceleration the whole, or along the path where that is the larger ratio."""
        tool, caps = motion.tool, motion.caps
        speed, acceleration, turning = (
            np.linalg.norm(x, axis=1) for x in (tool[:, 0, :3], tool[:, 1, :3], tool[:, 0, 3:])
        )
        used = acceleration / caps.a_tcp
        if caps.along:
            along = np.sum(tool[:, 0, :3] * tool[:, 1, :3], axis=1) / np.maximum(speed, _STILL_TOOL)
            used = np.maximum(used, np.max(along[:, None] * [1, -1] / caps.ramps, axis=1))
        return np.column_stack([speed / caps.v_tcp, used, turning / caps.v_ori])

    # ---- path timing

    def path_rows(self, path: PathSamples) -> PathRows:
        """See Limit. The acceleration's limit is a circle in the plane of path and bend, with a polygon drawn about it;
        then, where limited by itself, the acceleration along the path: the only column with a rest."""
        caps, m, along = path.caps, len(path.v), path.caps.along
        top, slopes, bends = (np.empty((m, k)) for k in (2, *[len(self._sides) + along] * 2))
        rests = np.zeros(slopes.shape) if along else PathRows.no_rests(slopes)
        fill = loops("trajopt_cli.trajectories.limits.tool_loops")["fill_rows"]
        ramps = np.minimum(caps.ramps, _NO_RAMP)
        fill(
            path.v, path.w, path.bend, caps.v_tcp, caps.a_tcp, caps.v_ori, ramps, self._sides, top, slopes, bends, rests
        )
        return PathRows(top, slopes, bends, rests)

    # ---- nonlinear program

    def node_kind(self, leg: Leg) -> Hashable:
        """See Limit."""
        if leg.kind is LegKind.DWELL:
            return None
        caps = tuple(cap for cap, x in zip(ToolCap, (leg.v_tcp, leg.a_tcp, leg.v_ori), strict=True) if np.isfinite(x))
        corner = leg.segment is not None and leg.segment.is_corner
        turning = leg.turn is not None and ToolCap.REORIENTATION in caps
        return ToolKind(caps, leg.along is not None, corner, turning) if caps else None

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        """Caps, of the share of a path or in metres; ramps: speeding up and slowing down along the path, of a path as
        half their range and how far its middle is off; tcp (3,): the tool centre point in the flange's frame; fastest:
        rate of the tool's turn beyond its way."""
        assert isinstance(kind, ToolKind)
        ramps = {"ramps": (2,)} if kind.along else {}
        turn: dict[str, tuple[int, ...]] = {"fastest": ()} if kind.turning else {}
        return {"caps": (3,), **ramps, **turn, **({} if on_path else {"tcp": (3,)})}

    def node_values(self, leg: Leg, margin: Array, on_path: bool, q: Array) -> Mapping[str, Array]:
        """See Limit."""
        caps = np.array([leg.v_tcp, leg.a_tcp, leg.v_ori])
        share = margin[:, ToolCap.ACCELERATION]
        out = {} if on_path else {"tcp": np.tile(leg.X_FT[:3, 3], (len(margin), 1))}
        if on_path:
            corner = leg.segment is not None and leg.segment.is_corner
            ways = [1.0, 1.0, 1.0] if corner else [leg.chord, leg.chord, leg.fastest_turn]
            out["caps"] = np.array(ways) / caps / margin
            if leg.turn is not None and np.isfinite(leg.v_ori):
                out["fastest"] = leg.v_ori * margin[:, ToolCap.REORIENTATION]
        else:
            out["caps"] = np.where(np.isfinite(caps), caps, 1.0) * margin
        if leg.along is not None and on_path:
            half, middle = (leg.along[0] + leg.along[1]) / 2, (leg.along[0] - leg.along[1]) / 2
            out["ramps"] = np.column_stack([leg.chord / half / share, np.full(len(share), middle / half)])
        elif leg.along is not None:
            out["ramps"] = np.outer(share, leg.along)
        return out

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        """See Limit; of a dwell none: the tool rests."""
        assert isinstance(kind, ToolKind)
        if node.share is not None:
            return _path_rows(kind, node, p)
        return [] if node.dependent != slice(0) else self._joint_rows(kind, node, p)

    def _joint_rows(self, kind: ToolKind, node: NodeMotion, p: Any) -> list[Row]:
        """Of a joint move, squared so that they stay smooth where the tool rests."""
        import casadi as ca

        T, out = node.T, list[Row]()
        rate, accelerations, spin = self._tool(p.tcp, node)
        if ToolCap.SPEED in kind.caps:
            out.append((ca.sumsqr(rate) / (p.caps[0] * T) ** 2, -INF, 1.0))
        if ToolCap.ACCELERATION in kind.caps:
            out += [(ca.sumsqr(acc) / (p.caps[1] * T * T) ** 2, -INF, 1.0) for acc in accelerations]
        if ToolCap.REORIENTATION in kind.caps:
            out.append((ca.sumsqr(spin) / (p.caps[2] * T) ** 2, -INF, 1.0))
        for acc in accelerations if kind.along and not node.ends else []:
            # below _STILL_NODE [m/s] it fades, so that it is smooth where the tool comes to rest
            squared = ca.sumsqr(rate) / T**2
            size = squared + _STILL_NODE**2
            along, share = ca.dot(rate, acc) / T**3 / ca.sqrt(size), squared / size
            out += [(along / p.ramps[0] - share, -INF, 0.0), (-along / p.ramps[1] - share, -INF, 0.0)]
        return out

    def _tool(self, p_FT: Any, node: NodeMotion) -> tuple[Any, list[Any], Any]:
        """The tool centre point's first and second derivatives by tau, and its rate of turning."""
        import casadi as ca

        n = self.axes.n
        Q, dQ = ca.SX.sym("Q", n), ca.SX.sym("dQ", n)
        pos, R = self.axes.robot.expressions.flange(Q)
        tcp = pos + R @ p_FT
        rate = ca.jtimes(tcp, Q, dQ)
        bend = ca.jtimes(rate, Q, dQ)
        turn = R.T @ ca.reshape(ca.jtimes(ca.vec(R), Q, dQ), 3, 3)
        spin = ca.vertcat(turn[2, 1], turn[0, 2], turn[1, 0])
        accelerations = [bend + ca.jtimes(tcp, Q, qdd) for qdd in node.qdds]
        found = ca.substitute([rate, spin, *accelerations], [Q, dQ], [node.q, node.qd])
        return found[0], found[2:], found[1]


def _path_rows(kind: ToolKind, node: NodeMotion, p: Any) -> list[Row]:
    """Of a line or an arc, by its share: L |a| <= a_tcp T^2, on an arc with the part towards the centre, squared. Of a
    corner by its curve p(s): |p' a + p'' v^2| <= a_tcp T^2, squared."""
    assert node.share is not None
    v, T, inward = node.share.v, node.T, node.share.inward
    if (curve := node.share.curve) is not None:
        import casadi as ca

        return [
            ((p.caps[0] * v / T) ** 2 * ca.sumsqr(curve.tangent), -INF, 1.0),
            *([((p.caps[2] / T) ** 2 * ca.sumsqr(v * curve.turn + p.axis * node.share.turn), -INF, 1.0)] if kind.turning
              else [((p.caps[2] * v / T) ** 2 * ca.sumsqr(curve.turn), -INF, 1.0)]),
            *(((p.caps[1] / T**2) ** 2 * ca.sumsqr(curve.tangent * a + curve.bend * v**2), -INF, 1.0)
              for a in node.share.a),
        ]  # fmt: skip
    out: list[Row] = [(p.caps[0] * v / T, -1.0, 1.0), (p.caps[2] * v / T, -1.0, 1.0)]
    if kind.turning:  # about one axis; about two both turns together are less than their sum
        turn = node.share.turn / (p.fastest * T)
        out += [(p.caps[2] * v / T + turn, -INF, 1.0), (p.caps[2] * v / T - turn, -INF, 1.0)]
    for a in node.share.a:
        if isinstance(inward, float):
            out.append((p.caps[1] * a / (T * T), -1.0, 1.0))
        else:
            out.append(((p.caps[1] / T**2) ** 2 * (a**2 + (inward * v**2) ** 2), -INF, 1.0))
        if kind.along:
            out.append((p.ramps[0] * a / (T * T) - p.ramps[1], -1.0, 1.0))
    return out
