"""Six-axis arm whose axes 2, 3 and 4 are parallel and whose axes 5 and 6 meet, as Universal Robots build them.

Lengths, canonical pose and the rest are robot.arm's as far as axis 3. From there on X_CK = ... Ry(t3) T(c3, 0, 0)
Ry(t4) T(wrist) Rz(t5) Ry(t6) T(0, c4, 0) Rx(-90 deg): axis 4 stands c3 before axis 3, `wrist` (x, 0, z) leads from it,
in the link behind it, to where axes 5 and 6 meet (the wrist centre; z runs along axis 5), and c4 along axis 6 to the
flange. The wrist centre lies in the arm's plane as a spherical one does, so joint 1 is found alike; axis 6 seen from
that plane gives axis 5 and the sum of t2, t3, t4, and with it axis 4's place, which axes 2 and 3 reach as they reach a
wrist centre.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array, pose, readonly
from trajopt_cli.robot.arm import Arm, reach_section, wrist_section


class ParallelArm(Arm):
    """The same lengths; a2 is 0, c3 leads from axis 3 to axis 4, `wrist` as above."""

    @property
    def lengths(self) -> dict[str, float]:
        """The lengths [m] by name."""
        lengths = {name: float(getattr(self, name)) for name in ("a1", "b", "c1", "c2", "c3", "c4")}
        return lengths | {"axis 5 off axis 4": float(self.wrist[0]), "wrist along axis 5": float(self.wrist[2])}

    @cached_property
    def closed_form(self) -> bool:
        """It has one."""
        return True

    @property
    def _turns_about(self) -> tuple[int, ...]:
        return (2, 1, 1, 1, 2, 1)

    @property
    def _wrist_joint(self) -> int:
        return 4

    @cached_property
    def X_6F(self) -> Array:
        """The flange (4, 4) in the canonical frame behind axis 6."""
        return readonly(pose([[1, 0, 0], [0, 0, 1], [0, -1, 0]], [0, self.c4, 0]) @ self.X_KF)


@wrist_section.register
def _(arm: ParallelArm, q: Array) -> tuple[Array, Array]:
    ahead, up = reach_section(arm, q)
    t = arm.angles(q)
    t234 = t[..., 1] + t[..., 2] + t[..., 3]
    along, over = _turned(arm, np.cos(t234), np.sin(t234))
    return ahead + along, up + over


def _turned(arm: Arm, c: Array, s: Array) -> tuple[Array, Array]:
    """From axis 4 to the wrist centre, ahead and up, where the link between them is turned by an angle (c, s)."""
    return c * arm.wrist[0] + s * arm.wrist[2], c * arm.wrist[2] - s * arm.wrist[0]


def bent(arm: Arm, R_1K: Array, centre: Array, side: Array) -> Array:
    """On sides (n,) of axis 5, 1 or -1: where axis 4 is, ahead and up of axis 2, the sum t2 + t3 + t4, t5 and t6, (n,
    5).

    R_1K (n, 3, 3): the canonical flange in the frame that axis 1 carries. centre (n, 2): of the wrist, ahead and up of
    axis 2. Where axis 6 is parallel to axis 4, t6 is 0 if axes 2 and 3 reach axis 4 so; else axis 4 stands where they
    just reach it. Compiled: robot.inverse_loops.
    """
    from trajopt_cli.native.loops import loops

    out = np.empty((len(R_1K), 5))
    loops("trajopt_cli.robot.inverse_loops")["fill_bent"](arm.numbers, R_1K, centre, side, out)
    return out
