"""A module for numba, as small as can be."""

from math import sin

from numba import njit


@njit(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)
def _wave(x, k):  # type: ignore[no-untyped-def]
    row = x[k]
    return sin(row[0]) / row[1]


@njit(["void(float64[:,:], float64, int64[::1], float64[::1])"], error_model="numpy")
def fill(x, scale, at, out):  # type: ignore[no-untyped-def]
    for i in range(len(at)):
        out[i] = scale * _wave(x, at[i])
