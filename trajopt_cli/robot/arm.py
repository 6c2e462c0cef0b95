"""Six-axis arm with a spherical wrist, axes 2 and 3 parallel and at right angles to axis 1: closed-form products.

Any such arm is seven lengths, as Brandstötter, Angerer and Hofbaur name them ("An analytical solution of the inverse
kinematics problem of industrial serial manipulators with an ortho-parallel basis and a spherical wrist", 2014), in a
canonical pose of all joints: X_OK = Rz(t1) T(a1, b, c1) Ry(t2) T(0, 0, c2) Ry(t3) T(c3, 0, -a2) Rx(t4) Ry(t5) Rx(t6)
T(c4, 0, 0) Ry(90 deg). All t = 0 stands the lower arm up and stretches the upper arm forward, as ABB's zero does; the
paper's third angle is t3 + 90 deg. The arm's own joints are t = sign q + offset; its base link B and its flange F stand
anywhere fixed to O and K. Frames: O on axis 1 with z along it, K with z along axis 6, away from the wrist centre. Where
axis 4 is parallel to axes 2 and 3 it is another kind of arm, whose products robot.parallel_arm has under these names.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property, singledispatch
from math import atan2, hypot

import numpy as np

from trajopt_cli.geometry import Array, readonly


@dataclass(frozen=True, eq=False)
class Arm:
    """Lengths [m]: a1, b, c1 from the base to axis 2 and the arm's plane (forward, left, up); c2 to axis 3, positive;
    c3 along axis 4 and -a2 across it to the wrist centre; c4 to the flange.

    signs, offsets (6,): the canonical angle of a joint is sign * q + offset. middles (6,) [rad]: the inverse gives
    joints within half a turn of them. X_BO, X_KF (4, 4): the canonical base in the base link, the flange (tool0) in the
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
    X_BO: Array
    X_KF: Array
    wrist: Array = field(default_factory=lambda: np.zeros(3))
    coupled: bool = False

    def __post_init__(self) -> None:
        for name in ("signs", "offsets", "middles", "X_BO", "X_KF", "wrist"):
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


def _sines(arm: Arm, q: Array) -> tuple[list[Array], list[Array]]:
    """Cosines and sines of t1, t2, t2 + t3, t4, t5, t6, each (...)."""
    t = arm.angles(q)
    angles = np.stack([t[..., 0], t[..., 1], t[..., 1] + t[..., 2], t[..., 3], t[..., 4], t[..., 5]])
    return list(np.cos(angles)), list(np.sin(angles))


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


@singledispatch
def forward(arm: Arm, q: Array) -> Array:
    """Flange poses X_OF (..., 4, 4) of joints q (..., 6) in rad."""
    sines = (c1, c2, c23, c4, _, _), (s1, s2, s23, s4, _, _) = _sines(arm, q)
    X = np.zeros((*q.shape[:-1], 4, 4))
    X[..., 3, 3] = 1.0
    _turn(*sines, X)
    radius, up = arm.a1 + arm.c2 * s2 + arm.c3 * c23, arm.c1 + arm.c2 * c2 - arm.c3 * s23
    if arm.a2:
        radius, up = radius - arm.a2 * s23, up - arm.a2 * c23
    x, y = c1 * radius, s1 * radius
    if arm.b:
        x, y = x - arm.b * s1, y + arm.b * c1
    X[..., 0, 3] = x + arm.c4 * X[..., 0, 2]
    X[..., 1, 3] = y + arm.c4 * X[..., 1, 2]
    X[..., 2, 3] = up + arm.c4 * X[..., 2, 2]
    if not arm.closed_form:
        ahead = s23 * s4
        axis_5 = np.stack([c1 * ahead - s1 * c4, s1 * ahead + c1 * c4, c23 * s4], axis=-1)
        X[..., :3, 3] += arm.wrist[1] * axis_5 + arm.wrist[2] * np.cross(X[..., :3, 2], axis_5)
    return X if arm.canonical_flange else X @ arm.X_KF


def _turn(cosines: list[Array], sines: list[Array], X: Array) -> None:
    """Put the canonical flange's rotation into X (..., 3 or 4, 3 or 4)."""
    (c1, _, c23, c4, c5, c6), (s1, _, s23, s4, s5, s6) = cosines, sines
    # Columns of Rx(t4) Ry(t5) Rx(t6) Ry(90 deg), then turned by Ry(t2 + t3) and Rz(t1).
    xx, xy, xz = s5 * c6, -(c4 * s6 + s4 * c5 * c6), c4 * c5 * c6 - s4 * s6
    yx, yy, yz = s5 * s6, c4 * c6 - s4 * c5 * s6, s4 * c6 + c4 * c5 * s6
    zx, zy, zz = c5, s4 * s5, -c4 * s5
    for column, (x, y, z) in enumerate(((-xx, -xy, -xz), (yx, yy, yz), (zx, zy, zz))):
        ahead = c23 * x + s23 * z
        X[..., 0, column] = c1 * ahead - s1 * y
        X[..., 1, column] = s1 * ahead + c1 * y
        X[..., 2, column] = c23 * z - s23 * x


@singledispatch
def axes_points_and_turn(arm: Arm, q: Array) -> tuple[Array, Array, Array]:
    """axes_and_points, and the flange's rotation R_OF (..., 3, 3): cheaper together."""
    sines = _sines(arm, q)
    R = np.empty((*q.shape[:-1], 3, 3))
    _turn(*sines, R)
    return *_axes_and_points(arm, *sines), R if arm.canonical_flange else R @ arm.X_KF[:3, :3]


@singledispatch
def axes_and_points(arm: Arm, q: Array) -> tuple[Array, Array]:
    """Unit axes (3, 6, ...) of the canonical joints and a point (3, 6, ...) on each [m], frame O, of q (..., 6): the
    canonical base, axes 2 and 3 in the arm's plane, and the wrist centre three times, for axis 6 with its offset.

    Components lead, so that each is one contiguous block: four times faster than (..., 3) on long batches.
    """
    return _axes_and_points(arm, *_sines(arm, q))


def _axes_and_points(arm: Arm, cosines: list[Array], sines: list[Array]) -> tuple[Array, Array]:
    (c1, c2, c23, c4, c5, _), (s1, s2, s23, s4, s5, _) = cosines, sines
    radius = arm.a1 + arm.c2 * s2
    a, o = np.zeros((3, 6, *c1.shape)), np.zeros((3, 6, *c1.shape))
    a[2, 0] = 1.0
    a[0, 1:3], a[1, 1:3] = -s1, c1
    a[0, 3], a[1, 3], a[2, 3] = c1 * c23, s1 * c23, -s23
    ahead = s23 * s4  # of Ry(t2 + t3) Rx(t4) e_y
    a[0, 4], a[1, 4], a[2, 4] = c1 * ahead - s1 * c4, s1 * ahead + c1 * c4, c23 * s4
    y, z = s4 * s5, -c4 * s5
    ahead = c23 * c5 + s23 * z  # of Ry(t2 + t3) Rx(t4) Ry(t5) e_x
    a[0, 5], a[1, 5], a[2, 5] = c1 * ahead - s1 * y, s1 * ahead + c1 * y, c23 * z - s23 * c5
    o[0, 1], o[1, 1], o[2, 1] = arm.a1 * c1, arm.a1 * s1, arm.c1
    o[0, 2], o[1, 2], o[2, 2] = radius * c1, radius * s1, arm.c1 + arm.c2 * c2
    if arm.b:
        o[:, 1:3] += arm.b * a[:, 1:3]
    o[:, 3:] = (o[:, 2] + arm.c3 * a[:, 3])[:, None]
    if arm.a2:
        o[:, 3:] -= arm.a2 * np.stack([c1 * s23, s1 * s23, c23])[:, None]
    if not arm.closed_form:
        o[:, 5] += arm.wrist[1] * a[:, 4] + arm.wrist[2] * np.cross(a[:, 5], a[:, 4], axis=0)
    return a, o
