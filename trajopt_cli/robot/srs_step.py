"""SrsRobot's kinematics for one sample in plain floats: what a control loop at 1 ms calls.

The inverse is the algebra of robot.srs_inverse, written once more because NumPy costs a microsecond per operation,
however short the array; the force on the tool is compiled (robot.srs_loops); forward kinematics and Jacobian are
pinocchio's. Tests hold all against the vectorised ones.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from math import atan2, cos, hypot, pi, sin, sqrt

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.robot.chain import checked_pose
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.robot.srs_inverse import NEAR, STRETCH, ArmAngle, elbow_side, flips
from trajopt_cli.robot.urdf import FLANGE

Floats3 = tuple[float, float, float]
Floats7 = tuple[float, float, float, float, float, float, float]
Floats9 = tuple[float, float, float, float, float, float, float, float, float]
Jacobian = tuple[tuple[float, ...], ...]  # (6, 7)


class SrsStep:
    """One configuration of an arm at one arm angle [rad], with the TCP at X_FT (4, 4) in the flange frame.

    Rotations are nine floats row by row, positions three floats [m], all in the world.
    """

    def __init__(
        self,
        robot: SrsRobot,
        definition: ArmAngle,
        configuration: int,
        arm_angle: float,
        X_FT: Array | None = None,
    ) -> None:
        """Raises ValueError for a configuration outside 0..7, an arm angle that is not finite, and an X_FT no pose."""
        if not np.isfinite(arm_angle):
            raise ValueError(f"arm_angle is {arm_angle}, wanted a finite angle [rad]")
        X_FT = checked_pose(X_FT, "X_FT")
        (b2, b3, b5, b7), (n2, n4, n6) = flips(configuration)
        self.robot, self.definition, self.configuration = robot, definition, configuration
        self._half = (b2, b3, b5, b7)
        self._sign = (-1.0 if n2 else 1.0, -1.0 if n4 else 1.0, -1.0 if n6 else 1.0)
        self._se, self._ew = robot.lengths.se, robot.lengths.ew
        self._bs = robot.lengths.bs
        side = elbow_side(definition, configuration)
        self._swivel = side * cos(arm_angle), side * sin(arm_angle)
        self._R_BW, self._p_WB = _nine(robot.X_WB[:3, :3].T), _three(robot.X_WB[:3, 3])
        self._R_TF = _nine(X_FT[:3, :3].T)
        self._base_straight = bool(np.array_equal(robot.X_WB[:3, :3], np.eye(3)))
        self._tool_straight = bool(np.array_equal(X_FT[:3, :3], np.eye(3)))
        self.X_FT = X_FT
        from_wrist = X_FT[:3, 3] + [0.0, 0.0, robot.lengths.wf]
        self._tcp_to_wrist = _three(-(X_FT[:3, :3].T @ from_wrist))  # the TCP's axes
        import pinocchio as pin

        self._pin, self._model = pin, pin.Model(robot.pin_model)  # a copy: the TCP must not stay in the robot's model
        flange = self._model.frames[self._model.getFrameId(FLANGE)]
        tcp = pin.Frame("trajopt tcp", flange.parentJoint, flange.placement * pin.SE3(np.array(X_FT)), pin.OP_FRAME)
        self._tcp = self._model.addFrame(tcp)
        self._data = self._model.createData()

    def joints(self, R: Floats9, p: Floats3) -> Floats7 | None:
        """Joints [rad] that put the TCP at R, p; None where the wrist centre is out of reach. No limits are applied.

        Angles and singular cases as robot.srs_inverse.inverse has them.
        """
        u0, u1, u2 = turned(R, self._tcp_to_wrist)
        w0, w1, w2 = self._p_WB
        u0, u1, u2 = u0 + p[0] - w0, u1 + p[1] - w1, u2 + p[2] - w2
        if not self._tool_straight:
            R = product(R, self._R_TF)
        if not self._base_straight:
            u0, u1, u2 = turned(self._R_BW, (u0, u1, u2))
            R = product(self._R_BW, R)
        u2 -= self._bs
        ahead = hypot(u0, u1)
        d = hypot(ahead, u2)
        se, ew = self._se, self._ew
        far, near = se + ew, abs(se - ew)
        if not near - STRETCH <= d <= far + STRETCH:
            return None
        if ahead >= NEAR:
            ca, sa = u0 / ahead, u1 / ahead
            rise, out = u2 / d, ahead / d
        elif d >= NEAR:
            ca, sa, rise, out = 1.0, 0.0, u2 / d, ahead / d
        else:
            ca, sa, rise, out = 1.0, 0.0, 1.0, 0.0
        d = max(d, 1e-150)
        double = 2.0 * se * ew
        less, more = sqrt(max((far - d) * (far + d), 0.0) / double), sqrt(max((d - near) * (d + near), 0.0) / double)
        q4 = 2.0 * atan2(less, more)
        sine = less * more / d
        skew = (se - ew) * (se + ew) / d
        c_s, s_s, c_w, s_w = (d + skew) / (2.0 * se), ew * sine, (d - skew) / (2.0 * ew), se * sine
        # n along the line, b towards the elbow, t = n x b
        n0, n1, n2 = out * ca, out * sa, rise
        c, s = self._swivel
        b0, b1, b2 = s * sa - c * rise * ca, -s * ca - c * rise * sa, c * out
        t0, t1, t2 = c * sa + s * rise * ca, s * rise * sa - c * ca, -s * out
        z0, z1, z2 = c_s * n0 + s_s * b0, c_s * n1 + s_s * b1, c_s * n2 + s_s * b2
        r = hypot(z0, z1)
        c, s = (z0 / r, z1 / r) if r >= NEAR else (1.0, 0.0)
        q1, q2 = atan2(s, c), atan2(r, z2)
        q3 = atan2(c * (c_s * b1 - s_s * n1) - s * (c_s * b0 - s_s * n0), c * t1 - s * t0)
        R0, R1, R2, R3, R4, R5, R6, R7, R8 = R
        # axis 4's frame: x, y = t, z; the flange's axes in it
        x0, x1, x2 = c_w * b0 + s_w * n0, c_w * b1 + s_w * n1, c_w * b2 + s_w * n2
        z0, z1, z2 = c_w * n0 - s_w * b0, c_w * n1 - s_w * b1, c_w * n2 - s_w * b2
        x, y = x0 * R2 + x1 * R5 + x2 * R8, t0 * R2 + t1 * R5 + t2 * R8
        r = hypot(x, y)
        c, s = (x / r, y / r) if r >= NEAR else (1.0, 0.0)
        q5, q6 = atan2(s, c), atan2(r, z0 * R2 + z1 * R5 + z2 * R8)
        y0, y1, y2 = c * t0 - s * x0, c * t1 - s * x1, c * t2 - s * x2
        q7 = atan2(y0 * R0 + y1 * R3 + y2 * R6, y0 * R1 + y1 * R4 + y2 * R7)
        h1, h3, h5, h7 = self._half
        s2, s4, s6 = self._sign
        return (
            _placed(q1, h1), s2 * q2, _placed(q3, h3), s4 * q4, _placed(q5, h5), s6 * q6, _placed(q7, h7),
        )  # fmt: skip

    def forward(self, q: Floats7) -> tuple[Floats9, Floats3]:
        """The TCP's rotation and position of joints q."""
        self._pin.forwardKinematics(self._model, self._data, np.array(q))
        X = self._pin.updateFramePlacement(self._model, self._data, self._tcp)
        return _nine(X.rotation), _three(X.translation)

    def jacobian(self, q: Floats7) -> Jacobian:
        """Geometric Jacobian at the TCP in world axes, linear rows first."""
        frame = self._pin.LOCAL_WORLD_ALIGNED
        rows = self._pin.computeFrameJacobian(self._model, self._data, np.array(q), self._tcp, frame).tolist()
        return tuple(map(tuple, rows))

    @cached_property
    def _force(self) -> tuple[Array, Callable[[], None], Array]:
        """Joints and torques (2, 7), what makes a force of them, and where it puts it."""
        from trajopt_cli.native.loops import loops

        lengths, X_WB = self.robot.lengths, self.robot.X_WB
        at = self.X_FT[:3, 3] + [0.0, 0.0, lengths.wf]
        arm = np.array([lengths.bs, lengths.se, lengths.ew, *at, *X_WB[:3, :3].ravel()])
        given, out = np.zeros((2, 7)), np.zeros(7)
        room = np.zeros((4, 3)), np.zeros((6, 7)), np.zeros((6, 6))
        fill = loops("trajopt_cli.robot.srs_loops")["fill_force"]
        return given, fill.on(arm, given[0], given[1], *room, out), out

    def force(self, q: Floats7, tau: Sequence[float]) -> tuple[list[float], float]:
        """F = (J J^T)^-1 J tau (6,) [N, Nm] of torques tau (7,) [Nm] at joints q, at the TCP in world axes; and the
        trace of (J J^T)^-1, the sum of 1/sigma^2 over the Jacobian's singular values, inf where one is 0."""
        given, run, out = self._force
        given[0], given[1] = q, tau
        run()
        *F, trace = out.tolist()
        return F, trace


def _placed(angle: float, half: bool) -> float:
    """An angle of atan2 in (-pi, pi], turned by half a turn where asked for; 0 turns to pi."""
    if half:
        angle = angle - pi if angle > 0.0 else angle + pi
    return angle if angle > -pi else pi


def turned(A: Floats9, v: Floats3) -> Floats3:
    """A v."""
    a, b, c = v
    return A[0] * a + A[1] * b + A[2] * c, A[3] * a + A[4] * b + A[5] * c, A[6] * a + A[7] * b + A[8] * c


def product(A: Floats9, B: Floats9) -> Floats9:
    """A B."""
    a, b, c, d, e, f, g, h, i = A
    j, k, m, n, o, p, q, r, s = B
    return (
        a * j + b * n + c * q, a * k + b * o + c * r, a * m + b * p + c * s,
        d * j + e * n + f * q, d * k + e * o + f * r, d * m + e * p + f * s,
        g * j + h * n + i * q, g * k + h * o + i * r, g * m + h * p + i * s,
    )  # fmt: skip


def _nine(R: Array) -> Floats9:
    a, b, c, d, e, f, g, h, i = (float(v) for v in R.reshape(9))
    return a, b, c, d, e, f, g, h, i


def _three(v: Array) -> Floats3:
    a, b, c = (float(x) for x in v)
    return a, b, c
