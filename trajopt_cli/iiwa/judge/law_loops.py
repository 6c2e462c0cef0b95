"""The controller's law row by row: masses on springs and dampers towards an equilibrium, and a ball that meets shapes.

shapes (b, 19), a row each: 0 a box, 1 a capsule; stiffness, damping, friction; of a box its axes (9, row by row), its
centre (3) and half its sizes (3), of a capsule one end (3), the way to the other (3) and its radius. p (3,) a place
[m], q (4,) a rotation, scalar first.
"""
# mypy: disable-error-code="no-untyped-def, untyped-decorator"

from __future__ import annotations

from math import atan2, copysign, cos, sin, sqrt

from numba import njit

_PART = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
_RISE = 2000.0  # N s/m: friction grows so with the sliding until Coulomb's bound


@njit(**_PART)
def _product(a, b):
    """First b, then a."""
    w, x, y, z = a
    t, i, j, k = b
    return (
        w * t - x * i - y * j - z * k,
        w * i + t * x + y * k - z * j,
        w * j + t * y + z * i - x * k,
        w * k + t * z + x * j - y * i,
    )


@njit(**_PART)
def _between(a, b):
    """The turn vector in the world that leads from rotation b to a, of at most half a turn."""
    w, x, y, z = _product(a, (b[0], -b[1], -b[2], -b[3]))
    if w < 0:
        w, x, y, z = -w, -x, -y, -z
    sine = sqrt(x * x + y * y + z * z)
    factor = 2 * atan2(sine, w) / sine if sine > 0 else 0.0
    return factor * x, factor * y, factor * z


@njit(**_PART)
def _turned(q, x, y, z):
    """q turned on by a turn vector in the world."""
    angle = sqrt(x * x + y * y + z * z)
    factor = sin(angle / 2) / angle if angle > 0 else 0.5
    return _product((cos(angle / 2), factor * x, factor * y, factor * z), q)


@njit(**_PART)
def _rotation(a, b, c):
    """About x by a, then about the fixed y by b, then about the fixed z by c."""
    about_y = (cos(b / 2), 0.0, sin(b / 2), 0.0)
    about_x = (cos(a / 2), sin(a / 2), 0.0, 0.0)
    return _product((cos(c / 2), 0.0, 0.0, sin(c / 2)), _product(about_y, about_x))


@njit(**_PART)
def _nearest(s, p):
    """Distance of p from a shape, negative inside, and the outward normal there."""
    if s[0] == 1:
        way2 = s[7] * s[7] + s[8] * s[8] + s[9] * s[9]
        x, y, z = p[0] - s[4], p[1] - s[5], p[2] - s[6]
        share = (x * s[7] + y * s[8] + z * s[9]) / way2 if way2 > 0 else 0.0
        share = min(1.0, max(0.0, share))
        x, y, z = x - share * s[7], y - share * s[8], z - share * s[9]
        far = max(sqrt(x * x + y * y + z * z), 1e-300)
        return far - s[10], x / far, y / far, z / far
    x, y, z = p[0] - s[13], p[1] - s[14], p[2] - s[15]
    u, v, w = s[4] * x + s[7] * y + s[10] * z, s[5] * x + s[8] * y + s[11] * z, s[6] * x + s[9] * y + s[12] * z
    a, b, c = abs(u) - s[16], abs(v) - s[17], abs(w) - s[18]
    far = max(a, b, c)
    if far <= 0:
        a, b, c = (1.0, 0.0, 0.0) if a == far else (0.0, 1.0, 0.0) if b == far else (0.0, 0.0, 1.0)
    else:
        a, b, c = max(a, 0.0), max(b, 0.0), max(c, 0.0)
        far = sqrt(a * a + b * b + c * c)
        a, b, c = a / far, b / far, c / far
    u, v, w = copysign(a, u), copysign(b, v), copysign(c, w)
    return far, s[4] * u + s[5] * v + s[6] * w, s[7] * u + s[8] * v + s[9] * w, s[10] * u + s[11] * v + s[12] * w


@njit(**_PART)
def _touch(shapes, tip, p, v, w, out):
    """Put what shapes do to a ball that moves at v and turns at w (tuples) into out (6,); how deep it is."""
    deepest = 0.0
    for i in range(6):
        out[i] = 0.0
    for i in range(len(shapes)):
        s = shapes[i]
        far, nx, ny, nz = _nearest(s, p)
        depth = tip - far
        if depth <= 0:
            continue
        deepest = max(deepest, depth)
        lever = depth / 2 - tip
        x, y, z = lever * nx, lever * ny, lever * nz
        vx, vy, vz = v[0] + w[1] * z - w[2] * y, v[1] + w[2] * x - w[0] * z, v[2] + w[0] * y - w[1] * x
        away = vx * nx + vy * ny + vz * nz
        push = max(0.0, s[1] * depth - s[2] * away)
        vx, vy, vz = vx - away * nx, vy - away * ny, vz - away * nz
        sliding = sqrt(vx * vx + vy * vy + vz * vz)
        rub = _RISE if _RISE * sliding <= s[3] * push else s[3] * push / sliding
        fx, fy, fz = push * nx - rub * vx, push * ny - rub * vy, push * nz - rub * vz
        out[0], out[1], out[2] = out[0] + fx, out[1] + fy, out[2] + fz
        out[3], out[4], out[5] = out[3] + y * fz - z * fy, out[4] + z * fx - x * fz, out[5] + x * fy - y * fx
    return deepest


@njit(
    ["void(float64, float64[:,:], float64, float64[:,:], float64[:,:], float64[:,:], float64[:])"], error_model="numpy"
)
def touched(h, shapes, tip, p, q, force, depth):
    """force (n, 6) and depth (n,) of a ball at rows p (n, 3), q (n, 4), h apart; it stands before the first."""
    for k in range(len(p)):
        j = max(k - 1, 0)
        v = (p[k, 0] - p[j, 0]) / h, (p[k, 1] - p[j, 1]) / h, (p[k, 2] - p[j, 2]) / h
        x, y, z = _between((q[k, 0], q[k, 1], q[k, 2], q[k, 3]), (q[j, 0], q[j, 1], q[j, 2], q[j, 3]))
        depth[k] = _touch(shapes, tip, p[k], v, (x / h, y / h, z / h), force[k])


@njit(["void(float64[:,:], float64, float64[:,:], float64[:,:], float64[:,:])"], error_model="numpy")
def at_rest(shapes, tip, p, K, out):
    """out (n, 5) of rows p, K (n, 3): how deep a ball there is in the shape it is deepest in or nearest to, the normal,
    and the force on it of springs K that pull the ball there, at rest and free to slide."""
    for k in range(len(p)):
        out[k, 0] = -1e300
        for i in range(len(shapes)):
            s = shapes[i]
            far, nx, ny, nz = _nearest(s, p[k])
            if tip - far > out[k, 0]:
                soft = 1 / s[1] + nx * nx / K[k, 0] + ny * ny / K[k, 1] + nz * nz / K[k, 2]
                out[k, 0], out[k, 1], out[k, 2], out[k, 3] = tip - far, nx, ny, nz
                out[k, 4] = max(0.0, tip - far) / soft


_ROWS = "float64[:,:], float64[:,:]"
_LAWS = "int64[:], float64[:,:,:], float64[:,:,:], float64[:,:]"


@njit(
    [
        f"void(float64, int64, int64, {_ROWS}, {_LAWS}, float64[:,:], float64[:,:], float64, float64[:], float64[:],"
        f" {_ROWS}, float64[:,:], float64[:], float64[:,:])"
    ],
    error_model="numpy",
)
def replay(h, slerp, speed, u, q_e, starts, laws, kept, bounds, told, shapes, tip, p_0, q_0, x, q, force, depth, room):
    """x (n, 6), q (n, 4): where the law leads from rest at p_0, q_0, along the equilibrium u (n, 6), q_e (n, 4); force
    (n, 6), depth (n,): what it touches on the way. Angles count from q_0; q_e goes by where slerp is 1, which knows x
    only as positions. speed: 1 where the equilibrium's speed is fed.

    starts (m,): rows from which on laws (m, 6, 6) hold, per axis a, b, c, p, q, r of v' = v_e + a (v - v_e) + b e + c F
    and x' = x + h v_e + p (v - v_e) + q e + r F; kept (m, 6, 6): of a force what is felt, bounds (m, 6): to which it is
    clamped before. told (n, 6): forces besides. room (2, 6): for what is between.
    """
    at = (q_0[0], q_0[1], q_0[2], q_0[3])
    last = at
    law = 0
    rate, F = room[0], room[1]
    for i in range(6):
        rate[i] = 0.0
        x[0, i] = p_0[i] if i < 3 else 0.0
    for k in range(len(u)):
        while law + 1 < len(starts) and starts[law + 1] <= k:
            law += 1
        if slerp == 0:
            at = _product(_rotation(x[k, 3], x[k, 4], x[k, 5]), (q_0[0], q_0[1], q_0[2], q_0[3]))
        q[k, 0], q[k, 1], q[k, 2], q[k, 3] = at
        if len(shapes):
            j = max(k - 1, 0)
            v = (x[k, 0] - x[j, 0]) / h, (x[k, 1] - x[j, 1]) / h, (x[k, 2] - x[j, 2]) / h
            wx, wy, wz = _between(at, last)
            depth[k] = _touch(shapes, tip, x[k, :3], v, (wx / h, wy / h, wz / h), force[k])
        last = at
        for i in range(6):
            F[i] = 0.0
            for j in range(6):
                felt = min(max(force[k, j], -bounds[law, j]), bounds[law, j]) + told[k, j]
                F[i] += kept[law, i, j] * felt
        if k + 1 == len(u):
            break
        here = (q_e[k, 0], q_e[k, 1], q_e[k, 2], q_e[k, 3])
        off = _between(at, here)
        goes = _between((q_e[k + 1, 0], q_e[k + 1, 1], q_e[k + 1, 2], q_e[k + 1, 3]), here)
        for i in range(6):
            to = laws[law, i]
            a, b, c, d, f, g = to[0], to[1], to[2], to[3], to[4], to[5]
            turns = slerp == 1 and i > 2
            e = off[i - 3] if turns else x[k, i] - u[k, i]
            v_e = 0.0
            if speed == 1:
                v_e = (goes[i - 3] if turns else u[k + 1, i] - u[k, i]) / h
            w = rate[i] - v_e
            moved = h * v_e + d * w + f * e + g * F[i]
            rate[i] = v_e + a * w + b * e + c * F[i]
            x[k + 1, i] = moved if turns else x[k, i] + moved
        if slerp == 1:
            at = _turned(at, x[k + 1, 3], x[k + 1, 4], x[k + 1, 5])
