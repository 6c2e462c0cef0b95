"""Ways of a stationary tool: it stands in the world, and the robot carries the work past it.

What is straight or round then is the tool's way over the work, seen from the flange. Numbers only.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.line import Line
from trajopt_cli.path.segment import Segment


@dataclass(frozen=True, eq=False)
class Carried:
    """A tool at X_WS (4, 4) passed by the work: way is its way seen from the flange, X_FS(s).

    X_FT (4, 4): a point of the work that is followed in place of the tool, the target as a rule. Its poses X_WT(s) =
    X_WS inv(X_FS(s)) X_FT make X_WF(s) = X_WT(s) inv(X_FT), as for a tool on the flange; where the way ends in the
    target, X_WT = X_WS. length and angle are those of the tool over the work, for which speeds are programmed.
    """

    way: Segment
    X_WS: Array
    X_FT: Array

    @classmethod
    def to(cls, X_WF: Array, X_WS: Array, X_FT: Array, X_WV: Array | None = None) -> Carried:
        """From the flange at X_WF (4, 4) to a target X_FT of the work, which then stands at the tool: a line, or the
        arc on which the target passes X_WV (4, 4).

        Raises:
            InputError: three points that make no circle.
        """
        X_FS = inverse_pose(X_WF) @ X_WS
        if X_WV is None:
            return cls(Line(X_FS, X_FT), X_WS, X_FT)
        via = X_FT @ inverse_pose(X_WV) @ X_WS
        return cls(Arc.through(X_FS, via[:3, 3], X_FT), X_WS, X_FT)

    @property
    def length(self) -> float:
        """The tool's way over the work [m]."""
        return self.way.length

    @property
    def angle(self) -> float:
        """The work's reorientation [rad]."""
        return self.way.angle

    @property
    def breaks(self) -> Array:
        """Those of the way."""
        return self.way.breaks

    def pose(self, s: Array) -> Array:
        """X_WT (n, 4, 4) at shares s (n,)."""
        return np.asarray(self.X_WS @ inverse_pose(self.way.pose(s)) @ self.X_FT)

    def twist(self, s: Array) -> Array:
        """First derivative (n, 6) by s."""
        R_WF, e = self._seen(s)
        v, omega = np.split(self.way.twist(s), 2, axis=1)
        return _turned(R_WF, -(np.cross(omega, e) + v), -omega)

    def twist_rate(self, s: Array) -> Array:
        """Second derivative (n, 6) by s."""
        R_WF, e = self._seen(s)
        v, omega = np.split(self.way.twist(s), 2, axis=1)
        a, alpha = np.split(self.way.twist_rate(s), 2, axis=1)
        linear = np.cross(omega, np.cross(omega, e) + 2 * v) - np.cross(alpha, e) - a
        return _turned(R_WF, linear, -alpha)

    def _seen(self, s: Array) -> tuple[Array, Array]:
        """The flange's rotation (n, 3, 3), and from the tool to the followed point (n, 3) in the flange's axes."""
        X_FS = self.way.pose(s)
        R_WF = self.X_WS[:3, :3] @ np.swapaxes(X_FS[:, :3, :3], 1, 2)
        return R_WF, self.X_FT[:3, 3] - X_FS[:, :3, 3]


def over_work(X_WF: Array, V: Array, A: Array, p_WS: Array) -> tuple[Array, Array]:
    """Velocity and acceleration (n, 6) of a tool that stands at p_WS (3,), over the work on the flange, in its axes.

    X_WF (n, 4, 4), V, A (n, 6): pose, velocity and acceleration of the flange in the world, linear part first.
    """
    R_FW = np.swapaxes(X_WF[:, :3, :3], 1, 2)
    r, (v, omega), (a, alpha) = p_WS - X_WF[:, :3, 3], np.split(V, 2, axis=1), np.split(A, 2, axis=1)
    u = v + np.cross(omega, r)  # of the work where the tool touches it
    change = a + np.cross(alpha, r) - np.cross(omega, v) - np.cross(omega, u)
    return _turned(R_FW, -u, -omega), _turned(R_FW, -change, -alpha)


def _turned(R: Array, linear: Array, angular: Array) -> Array:
    """Both (n, 3) in the axes that R (n, 3, 3) leads to: (n, 6)."""
    return np.hstack([(R @ linear[..., None])[..., 0], (R @ angular[..., None])[..., 0]])
