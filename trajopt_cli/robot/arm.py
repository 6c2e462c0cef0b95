"""Six-axis arm with a spherical wrist, axes 2 and 3 parallel and at right angles to axis 1: closed-form products.

Any such arm is seven lengths, as Brandstötter, Angerer and Hofbaur name them ("An analytical solution of the inverse
kinematics problem of industrial serial manipulators with an ortho-parallel basis and a spherical wrist", 2014), in a
canonical pose of all joints: X_CK = Rz(t1) T(a1, b, c1) Ry(t2) T(0, 0, c2) Ry(t3) T(c3, 0, -a2) Rx(t4) Ry(t5) Rx(t6)
T(c4, 0, 0) Ry(90 deg). All t = 0 stands the lower arm up and stretches the upper arm forward, as ABB's zero does; the
paper's third angle is t3 + 90 deg. The arm's own joints are t = sign q + offset; its base link B and its flange F stand
anywhere fixed to C and K. Frames: C on axis 1 with z along it, K with z along axis 6, away from the wrist centre. Where
axis 4 is parallel to axes 2 and 3 it is another kind of arm, whose products robot.parallel_arm has under these names.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property, singledispatch
from math import atan2, hypot

import numpy as np

from trajopt_cli.geometry import Array, pose, readonly


@dataclass(frozen=True, eq=False)
class Arm:
    """Lengths [m]: a1, b, c1 from the base to axis 2 and the arm's plane (forward, left, up); c2 to axis 3, positive;
    c3 along axis 4 and -a2 across it to the wrist centre; c4 to the flange.

    signs, offsets (6,): the canonical angle of a joint is sign * q + offset. middles (6,) [rad]: the inverse gives
    joints within half a turn of them. X_BC, X_KF (4, 4): the canonical base in the base link, the flange (tool0) in the
    canonical one. For ABB's axis directions signs are 1, offsets 0 and both poses the identity. wrist (3,): from where
    axes 4 and 5 meet to axis 6, in the link before it (x along axis 6, y along axis 5); zero for a spherical wrist.
    coupled: a parallel linkage drives the upper arm, so joint 3 is its angle against the base: t2 + t3 stays as joint 2
    turns.
    """

    a1: float
    a2: float
    b: float
    c1: float
    c2: float
    c3: float
    c4: float
    signs: Array
    offsets: Array
    middles: Array
    X_BC: Array
    X_KF: Array
    wrist: Array = field(default_factory=lambda: np.zeros(3))
    coupled: bool = False

    def __post_init__(self) -> None:
        for name in ("signs", "offsets", "middles", "X_BC", "X_KF", "wrist"):
            object.__setattr__(self, name, readonly(getattr(self, name)))

    @property
    def lengths(self) -> dict[str, float]:
        """The seven lengths [m] by name; where axis 6 stands off axis 4 also how far, along axis 5 and across."""
        lengths = {name: float(getattr(self, name)) for name in ("a1", "a2", "b", "c1", "c2", "c3", "c4")}
        if self.closed_form:
            return lengths
        return lengths | {"wrist along": float(self.wrist[1]), "wrist across": float(self.wrist[2])}

    @cached_property
    def closed_form(self) -> bool:
        """Whether axes 4, 5 and 6 meet in one point, so that the inverse has a closed form."""
        return not np.any(self.wrist)

    @cached_property
    def upper(self) -> float:
        """The upper arm's length [m]: from axis 3 to the wrist centre."""
        return hypot(self.a2, self.c3)

    @cached_property
    def bend(self) -> float:
        """Angle [rad] at axis 3 from axis 4's direction to the wrist centre: t3 + bend is the angle of the elbow that
        the line from axis 3 to the wrist centre makes. 0 without an elbow offset."""
        return atan2(self.a2, self.c3)

    @cached_property
    def canonical_joints(self) -> bool:
        """Whether the joints are the canonical angles."""
        return bool(np.all(self.signs == 1) and not np.any(self.offsets) and not self.coupled)

    @cached_property
    def canonical_flange(self) -> bool:
        """Whether the flange is the canonical one."""
        return bool(np.array_equal(self.X_KF, np.eye(4)))

    @cached_property
    def natural_middles(self) -> Array:
        """Canonical angles (6,) that those of the closed form lie within half a turn of."""
        return readonly([0, 0, -np.pi / 2 - self.bend, 0, 0, 0])

    @cached_property
    def converted(self) -> tuple[int, ...]:
        """The joints that are not what the closed form gives as they stand."""
        own = (self.signs == 1) & (self.offsets == 0) & (self.middles == self.natural_middles)
        own[2] &= not self.coupled
        return tuple(np.flatnonzero(~own).tolist())

    @cached_property
    def chain(self) -> Array:
        """The joints as robot.chain_loops takes them (6, 7): the coordinate axis each turns about, its sign and offset,
        the way from the joint before [m], what its canonical angle loses by the joint before."""
        out = np.zeros((6, 7))
        out[:, 0], out[:, 1], out[:, 2] = self._turns_about, self.signs, self.offsets
        out[1:4, 3:6] = (self.a1, self.b, self.c1), (0.0, 0.0, self.c2), (self.c3, 0.0, -self.a2)
        out[self._wrist_joint, 3:6] = self.wrist
        out[2, 6] = self.signs[1] * self.coupled
        return readonly(out)

    @cached_property
    def numbers(self) -> Array:
        """The arm as robot.inverse_loops takes it (36,)."""
        lengths = self.a1, self.b, self.c1, self.c2, self.c3, self.upper, self.bend, self.c4, *self.wrist[[0, 2]]
        converted = np.isin(np.arange(6), self.converted)
        joints = np.column_stack([self.signs, self.offsets, self.middles, converted])
        return readonly([*lengths, self._turns_about[3] == 1, self.coupled, *joints.ravel()])

    @property
    def _turns_about(self) -> tuple[int, ...]:
        return (2, 1, 1, 0, 1, 0)

    @property
    def _wrist_joint(self) -> int:
        """The joint, from 0, that `wrist` leads to."""
        return 5

    @cached_property
    def X_6F(self) -> Array:
        """The flange (4, 4) in the canonical frame behind axis 6."""
        return readonly(pose([[0, 0, 1], [0, 1, 0], [-1, 0, 0]], [self.c4, 0, 0]) @ self.X_KF)

    def angles(self, q: Array) -> Array:
        """Canonical angles (..., 6) of joints (..., 6)."""
        if self.canonical_joints:
            return q
        t = self.signs * q + self.offsets
        if self.coupled:
            t[..., 2] -= self.signs[1] * q[..., 1]
        return np.asarray(t)

    def joints(self, t: Array) -> Array:
        """Joints (..., 6) of canonical angles (..., 6)."""
        q = self.signs * (t - self.offsets)
        if self.coupled:
            q[..., 2] += self.signs[1] * self.signs[2] * q[..., 1]
        return np.asarray(q)


@singledispatch
def wrist_section(arm: Arm, q: Array) -> tuple[Array, Array]:
    """The wrist centre in the arm's own plane [m]: how far before axis 1 and how high above the canonical base, both
    (...), of joints (..., 6)."""
    return reach_section(arm, q)


def reach_section(arm: Arm, q: Array) -> tuple[Array, Array]:
    """Where axes 2 and 3 carry the upper arm's end, likewise: the wrist centre, or of three parallel axes axis 4."""
    t = arm.angles(q)
    t2, t23 = t[..., 1], t[..., 1] + t[..., 2]
    c23, s23 = np.cos(t23), np.sin(t23)
    return (
        arm.a1 + arm.c2 * np.sin(t2) + arm.c3 * c23 - arm.a2 * s23,
        arm.c1 + arm.c2 * np.cos(t2) - arm.c3 * s23 - arm.a2 * c23,
    )


def elbow_angle(arm: Arm, q: Array) -> Array:
    """Angle (...) of the elbow of joints (..., 6): the wrist centre's line from axis 3 is square to the lower arm at 0,
    stretched at -90 and folded at 90 degrees, and behind the lower arm where its cosine is negative."""
    t3: Array = arm.angles(q)[..., 2]
    return t3 + arm.bend if arm.bend else t3
