"""What the tool's caps ask for along a path, place by place. See ToolLimit.path_rows."""
# mypy: disable-error-code="no-untyped-def, untyped-decorator"

from __future__ import annotations

from math import sqrt

from numba import njit

_STILL = 1e-12  # m of the tool by the path parameter: below it has no direction


@njit(
    [f"void({'float64[:,:], ' * 3}{'float64[:], ' * 3}{'float64[:,:], ' * 2}{'float64[:,::1], ' * 3}float64[:,:])"],
    error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True,
)  # fmt: skip
def fill_rows(v, w, bend, v_tcp, a_tcp, v_ori, ramps, sides, top, slopes, bends, rests):
    """top (m, 2) of v_tcp and v_ori; slopes and bends (m, k) by the k sides (k, 2) of a polygon about the circle of
    a_tcp in the plane of path and bend, its normals' cosines and sines; then, where there is a column more, of the
    ramps (m, 2) along the path, which alone have rests."""
    k = len(sides)
    for i in range(len(v)):
        size = sqrt(v[i, 0] * v[i, 0] + v[i, 1] * v[i, 1] + v[i, 2] * v[i, 2])
        top[i, 0], top[i, 1] = v_tcp[i] / size, v_ori[i] / sqrt(w[i, 0] ** 2 + w[i, 1] ** 2 + w[i, 2] ** 2)
        long = max(size, _STILL)
        x, y, z = v[i, 0] / long, v[i, 1] / long, v[i, 2] / long
        forward = bend[i, 0] * x + bend[i, 1] * y + bend[i, 2] * z
        x, y, z = bend[i, 0] - forward * x, bend[i, 1] - forward * y, bend[i, 2] - forward * z
        along, bent, aside = size / a_tcp[i], forward / a_tcp[i], sqrt(x * x + y * y + z * z) / a_tcp[i]
        for j in range(k):
            slopes[i, j], bends[i, j] = along * sides[j, 0], bent * sides[j, 0] + aside * sides[j, 1]
        if slopes.shape[1] > k:
            half = (ramps[i, 0] + ramps[i, 1]) / 2
            slopes[i, k], bends[i, k], rests[i, k] = size / half, forward / half, (ramps[i, 1] - ramps[i, 0]) / 2 / half
