"""Branches of an arm whose axis 6 passes the point where axes 4 and 5 meet, as cobots have it (ABB GoFa, FANUC CRX).

Such an arm has no closed form, but with t6 given it has that of a spherical wrist: the offset only shifts the wrist
centre. So t6 is tried all around, a posture lies where the closed form gives back the t6 that was tried, and Newton's
method on the whole arm makes it exact. Postures that appear and vanish between two tries are not found.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.robot.arm import Arm, elbow_angle, wrist_section
from trajopt_cli.robot.differential import Differential

TRIES = 64  # values of t6 around. Measured with GoFa's lengths on random configurations in range: 94 % of them are
# among the branches (48: 93 %, 256: 96 %), and 99.5 % of their poses have one; twice the tries take twice the time
STEPS = 12  # Newton steps
_LARGEST = 0.3  # rad of one step of a joint
_EXACT = 1e-11  # m and rad of the pose: farther off is no answer
_DAMPED = 1e-14  # added to the squares of the Jacobian, so that a singular one has an inverse

ClosedForm = Callable[[Arm, Array, Array], Array]


def plain(arm: Arm) -> Arm:
    """The arm in canonical angles, with a spherical wrist."""
    return replace(
        arm, wrist=np.zeros(3), signs=np.ones(6), offsets=np.zeros(6), middles=arm.natural_middles,
        X_BC=np.eye(4), X_KF=np.eye(4), coupled=False,
    )  # fmt: skip


def angles(arm: Arm, X_CK: Array, closed_form: ClosedForm) -> Array:
    """Canonical angles (n, 16, 6) of canonical flange poses (n, 4, 4), frame C; NaN where there are none.

    closed_form: robot.inverse's. Branch cfx is that whose Jacobian's determinant has the sign that a spherical wrist's
    has, branch 8 + cfx the other one with the same cfx.
    """
    spherical, n = plain(arm), len(X_CK)
    tried = np.arange(TRIES) * (2 * np.pi / TRIES)
    c, s = np.cos(tried)[:, None], np.sin(tried)[:, None]
    along_y, along_x = c * arm.wrist[1] + s * arm.wrist[2], s * arm.wrist[1] - c * arm.wrist[2]
    X = np.repeat(X_CK[:, None], TRIES, axis=1)
    X[..., :3, 3] -= X[..., :3, 1] * along_y + X[..., :3, 0] * along_x
    seeds = closed_form(spherical, X.reshape(-1, 4, 4), np.eye(4)).reshape(n, TRIES, 8, 6)
    off = _wrapped(seeds[..., 5] - tried[:, None])
    after = np.roll(off, -1, axis=1)
    with np.errstate(invalid="ignore"):
        crossed = (off * after <= 0) & (np.abs(off) + np.abs(after) < np.pi)
    pose, at, branch = np.nonzero(crossed)
    here = np.abs(off[crossed]) <= np.abs(after[crossed])
    t = seeds[pose, np.where(here, at, (at + 1) % TRIES), branch]
    return _by_branch(arm, spherical, *_exact(replace(spherical, wrist=arm.wrist), t, pose, X_CK), n)


def _wrapped(angle: Array) -> Array:
    return np.asarray((angle + np.pi) % (2 * np.pi) - np.pi)


def _exact(arm: Arm, t: Array, pose: IndexArray, X_CK: Array) -> tuple[Array, IndexArray]:
    """Angles (m, 6) near those given that have their poses exactly, and these poses' numbers (m,)."""
    p, R = X_CK[pose, :3, 3], X_CK[pose, :3, :3]
    off = np.full(len(t), np.inf)
    for _ in range(STEPS):
        move, off = _step(arm, t, p, R)
        if not (off > _EXACT / 10).any():
            break
        t = t + move
    ok = off <= _EXACT
    return t[ok], pose[ok]


def _step(arm: Arm, t: Array, p: Array, R: Array) -> tuple[Array, Array]:
    """A Newton step (m, 6) from angles (m, 6) towards flange poses p (m, 3), R (m, 3, 3); how far they are off (m,)."""
    at = Differential.of(arm, t)
    X_CK = at.pose()
    turn = R @ X_CK[:, :3, :3].transpose(0, 2, 1)
    skew = [turn[:, i, j] - turn[:, j, i] for i, j in ((2, 1), (0, 2), (1, 0))]
    off = np.concatenate([p - X_CK[:, :3, 3], np.stack(skew, axis=1) / 2], axis=1)
    J = at.jacobian()
    square = J.transpose(0, 2, 1) @ J + _DAMPED * np.eye(6)
    step = np.linalg.solve(square, J.transpose(0, 2, 1) @ off[..., None])[..., 0]
    size = np.abs(step).max(axis=1, keepdims=True)
    return step * np.minimum(1.0, _LARGEST / np.maximum(size, 1e-300)), np.abs(off).max(axis=1)


def _by_branch(arm: Arm, spherical: Arm, t: Array, pose: IndexArray, n: int) -> Array:
    """Angles (m, 6) of poses put where their branches are: (n, 16, 6)."""
    before, lower, t5 = wrist_section(spherical, t)[0], np.cos(elbow_angle(spherical, t)), np.sin(t[:, 4])
    determinant = np.linalg.det(Differential.of(replace(spherical, wrist=arm.wrist), t).jacobian())
    usual = determinant * before * lower * t5 <= 0  # a spherical wrist's is minus c2 upper times these three
    out = np.full((n, 16, 6), np.nan)
    out[pose, 8 * ~usual + 4 * (before < 0) + 2 * (lower < 0) + 1 * (t5 < 0)] = t
    return np.asarray(out - 2 * np.pi * np.ceil((out - arm.natural_middles - np.pi) / (2 * np.pi)))
