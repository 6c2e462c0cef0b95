"""The closed-form inverse of an arm with a spherical wrist and of one with three parallel axes, pose by pose.

arm (36,): robot.arm.Arm.numbers, the lengths a1, b, c1, c2, c3, upper, bend, c4 and the wrist's x and z, whether axes 2
to 4 are parallel, whether a linkage couples joint 3; then by joint the sign, the offset, the middle, and whether it is
not the angle as it stands. All else is in canonical angles, see robot.arm. NaN: out of reach.
"""
# mypy: disable-error-code="no-untyped-def, untyped-decorator"

from __future__ import annotations

from math import acos, atan2, copysign, cos, pi, sin, sqrt

import numpy as np
from numba import njit

_SINGULAR = 1e-12  # sin q5, or m of the wrist centre from axis 1: below, the angle is a convention
_WEAK = 1e-3  # sin q5: above, q4 and q6 found each for itself are right to 1e-13
_STRETCH = 1e-12  # how far |sin q3| may exceed 1 by rounding at the stretched or folded elbow
_PART = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


@njit(**_PART)
def _angle(y, x):
    """atan2 in (-pi, pi]: -pi, which it gives for a negative zero, is pi."""
    t = atan2(y, x)
    return pi if t <= -pi else t


@njit(**_PART)
def _half_turn(t):
    """An angle in (-pi, pi] turned by half a turn, in (-pi, pi] again; 0 turns to pi."""
    t = t - pi if t > 0 else t + pi
    return pi if t <= -pi else t


@njit(**_PART)
def _shoulder(arm, x, y, behind):
    """t1, its cosine and sine, and how far before axis 1 in the arm's plane a wrist centre at x, y is."""
    b, reach = arm[1], sqrt(x * x + y * y)
    if b != 0:  # the arm's plane passes axis 1 at b; the wrist centre lies in it, before axis 1 or behind it
        over = reach - abs(b)
        radius = sqrt(max(over, 0.0) * (reach + abs(b))) * (-1 if behind else 1) if over >= -_SINGULAR else np.nan
        c, s = (radius * x + b * y) / (reach * reach), (radius * y - b * x) / (reach * reach)
        return _angle(s, c), c, s, radius
    c, s = (x / reach, y / reach) if reach >= _SINGULAR else (1.0, 0.0)
    t = _angle(s, c)
    return (_half_turn(t), -c, -s, -reach) if behind else (t, c, s, reach)


@njit(**_PART)
def _elbow(arm, ahead, up, below):
    """t2, t3 and cosine and sine of t2 + t3 of a wrist centre ahead and up of axis 2; NaN out of reach."""
    c2, upper, bend = arm[3], arm[5], arm[6]
    square = ahead * ahead + up * up
    s3 = (c2 * c2 + upper * upper - square) / (2 * c2 * upper)
    if not abs(s3) <= 1 + _STRETCH:
        return np.nan, np.nan, np.nan, np.nan
    s3 = max(min(s3, 1.0), -1.0)
    c3 = sqrt((1 - s3) * (1 + s3))
    e = atan2(s3, c3)
    if below:
        c3, e = -c3, -pi - e
        if e <= -1.5 * pi:
            e = 0.5 * pi  # -270 deg is +90 deg
    along, across = c2 - upper * s3, upper * c3
    y, x = along * ahead - across * up, along * up + across * ahead
    t2 = atan2(y, x)
    y, x = y / square, x / square
    if bend != 0:
        c, s = cos(bend), sin(bend)
        c3, s3 = c3 * c + s3 * s, s3 * c - c3 * s  # of t3
    return t2, e - bend, x * c3 - y * s3, y * c3 + x * s3


@njit(**_PART)
def _wrist(R, c1, s1, c23, s23):
    """t4, t5, t6, axis 5 above zero. R_36 = (Rz(t1) Ry(t2 + t3))^T [z, y, -x] of the flange, which adds Ry(90 deg)."""
    # the flange's axes x, y, z in the frame axis 1 carries: ahead and up; z aside
    x, y, z = c1 * R[0, 0] + s1 * R[1, 0], c1 * R[0, 1] + s1 * R[1, 1], c1 * R[0, 2] + s1 * R[1, 2]
    aside, over = c1 * R[1, 2] - s1 * R[0, 2], s23 * z + c23 * R[2, 2]
    bend = sqrt(over * over + aside * aside)
    t4, t5 = _angle(aside, -over), atan2(bend, c23 * z - s23 * R[2, 2])
    if not bend < _WEAK:
        return t4, t5, _angle(c23 * y - s23 * R[2, 1], s23 * R[2, 0] - c23 * x)
    # t4 and t6 are rounding here, each for itself, but exact in sum: take t6 from the turn that t4 leaves
    if bend < _SINGULAR:
        t4, t5 = 0.0, 0.0 if t5 < 1 else pi
    c4, s4 = cos(t4), sin(t4)
    sine = c4 * (c1 * R[1, 0] - s1 * R[0, 0]) + s4 * (s23 * x + c23 * R[2, 0])
    cosine = c4 * (c1 * R[1, 1] - s1 * R[0, 1]) + s4 * (s23 * y + c23 * R[2, 1])
    return t4, t5, _angle(sine, cosine)


@njit(**_PART)
def _bent(arm, R, ahead, up, side, out):
    """Of three parallel axes, on one side of axis 5 (1 or -1): put where axis 4 is, ahead and up of axis 2, the sum of
    t2, t3 and t4, t5 and t6. R: the flange in the frame that axis 1 carries, the wrist centre ahead and up of axis 2.

    Where axis 6 is parallel to axis 4, t6 is 0 if axes 2 and 3 reach axis 4 so; else axis 4 stands where they just
    reach it.
    """
    along, over = arm[8], arm[9]
    bend, facing = sqrt(R[0, 2] * R[0, 2] + R[2, 2] * R[2, 2]), copysign(1.0, R[1, 2])
    if bend < _SINGULAR:
        c, s = side * facing * R[0, 0], -side * facing * R[2, 0]
        x, y = ahead - (c * along + s * over), up - (c * over - s * along)
        away = sqrt(x * x + y * y)
        wanted = min(max(away, abs(arm[3] - arm[4])), arm[3] + arm[4])
        far, length = sqrt(ahead * ahead + up * up), sqrt(along * along + over * over)
        cosine = min(max((far * far + length * length - wanted * wanted) / (2 * far * length), -1.0), 1.0)
        if away != wanted and far * length > 0:
            turn = atan2(over, along) - (atan2(up, ahead) - acos(cosine))
            c, s = cos(turn), sin(turn)
        t5 = 0.0 if facing > 0 else pi
    else:
        c, s, t5 = -side * R[0, 2] / bend, side * R[2, 2] / bend, atan2(bend, R[1, 2])
    t6 = _angle(-(s * R[0, 0] + c * R[2, 0]), -(s * R[0, 1] + c * R[2, 1]))
    out[0], out[1] = ahead - (c * along + s * over), up - (c * over - s * along)
    out[2], out[3], out[4] = atan2(s, c), side * t5, t6


@njit(**_PART)
def _put(arm, t, q):
    """Put joints of canonical angles, each within half a turn of its middle; none where one is NaN."""
    for i in range(6):
        if not abs(t[i]) < np.inf:
            q[:] = np.nan
            return
    t[2] += arm[11] * (t[1] - arm[17])
    for i in range(6):
        q[i] = t[i]
        sign, offset, middle, converted = arm[12 + 4 * i], arm[13 + 4 * i], arm[14 + 4 * i], arm[15 + 4 * i]
        if converted != 0:
            q[i] = sign * (t[i] - offset)
            while q[i] > middle + pi:
                q[i] -= 2 * pi
            while q[i] <= middle - pi:
                q[i] += 2 * pi


@njit(**_PART)
def _canonical(arm, X_WC, way, X_FK, X, R, w):
    """Put the canonical flange's rotation and the wrist centre, seen from the canonical base, of a flange pose."""
    for i in range(3):
        for k in range(4):
            of = 0.0
            for j in range(3):
                world = X[j, 0] * X_FK[0, k] + X[j, 1] * X_FK[1, k] + X[j, 2] * X_FK[2, k]
                if k == 3:
                    world += X[j, 3] - X_WC[j, 3] - way[j]
                of += X_WC[j, i] * world
            if k < 3:
                R[i, k] = of
            else:
                w[i] = of - arm[7] * R[i, 2]


@njit(**_PART)
def _spherical(arm, R, w, only, t, q):
    for behind in range(2):
        if only >= 0 and only // 4 != behind:
            continue
        t1, c1, s1, radius = _shoulder(arm, w[0], w[1], behind)
        for below in range(2):
            if only >= 0 and only // 2 % 2 != below:
                continue
            t2, t3, c23, s23 = _elbow(arm, radius - arm[0], w[2] - arm[2], below)
            t4, t5, t6 = _wrist(R, c1, s1, c23, s23)
            for turned in range(2):
                if only >= 0 and only % 2 != turned:
                    continue
                t[0], t[1], t[2], t[3], t[4], t[5] = t1, t2, t3, t4, t5, t6
                if turned:
                    t[3], t[4], t[5] = _half_turn(t4), -t5, _half_turn(t6)
                _put(arm, t, q[0 if only >= 0 else 4 * behind + 2 * below + turned])


@njit(**_PART)
def _parallel(arm, R, w, only, t, q, R_1, bent):
    for behind in range(2):
        if only >= 0 and only // 4 != behind:
            continue
        t1, c1, s1, radius = _shoulder(arm, w[0], w[1], behind)
        for j in range(3):
            R_1[0, j], R_1[1, j], R_1[2, j] = c1 * R[0, j] + s1 * R[1, j], c1 * R[1, j] - s1 * R[0, j], R[2, j]
        for turned in range(2):
            if only >= 0 and only % 2 != turned:
                continue
            _bent(arm, R_1, radius - arm[0], w[2] - arm[2], -1 if turned else 1, bent)
            for below in range(2):
                if only >= 0 and only // 2 % 2 != below:
                    continue
                t2, t3, _, _ = _elbow(arm, bent[0], bent[1], below)
                t4 = bent[2] - t2 - t3
                while t4 > pi:
                    t4 -= 2 * pi
                while t4 <= -pi:
                    t4 += 2 * pi
                t[0], t[1], t[2], t[3], t[4], t[5] = t1, t2, t3, t4, bent[3], bent[4]
                _put(arm, t, q[0 if only >= 0 else 4 * behind + 2 * below + turned])


@njit(
    [
        "void(float64[::1], float64[:,:], float64[:,:], float64[:,:], float64[:,:,:], int64[:],"
        " float64[:,::1], float64[:,:,::1])"
    ],
    **_PART,
)
def fill_joints(arm, X_WC, way, X_FK, X_WF, cfx, room, q):
    """Joints (n, 8, 6) of flange poses X_WF (n, 4, 4) by branch; (n, 1, 6) of branch cfx (n,) where it is not negative.

    X_WC: as chain_loops has it; way (n, 3): how far its rails have taken it [m]. X_FK: the canonical flange seen from
    the flange. room (6, 6): for what is between.
    """
    R, w, t, R_1, bent = room[:3, :3], room[3, :3], room[4], room[:3, 3:], room[5, :5]
    for n in range(len(X_WF)):
        _canonical(arm, X_WC, way[n], X_FK, X_WF[n], R, w)
        if arm[10] != 0:
            _parallel(arm, R, w, cfx[n], t, q[n], R_1, bent)
        else:
            _spherical(arm, R, w, cfx[n], t, q[n])


@njit(["void(float64[::1], float64[:,:,::1], float64[:,:], float64[:], float64[:,::1])"], **_PART)
def fill_bent(arm, R, centre, side, out):
    """What _bent finds (n, 5) of flanges R (n, 3, 3), wrist centres (n, 2) and sides (n,)."""
    for n in range(len(R)):
        _bent(arm, R[n], centre[n, 0], centre[n, 1], side[n], out[n])
