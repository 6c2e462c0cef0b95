"""Frames in mm, as RAPID's data has them, to poses in m, as motions have them, and back."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain
from struct import Struct

import numpy as np

from trajopt_cli.geometry import Array, readonly, wxyz_from_rotation
from trajopt_cli.rapid.data.frames import Frame
from trajopt_cli.units import MM

X_IDENTITY = readonly(np.eye(4))


def matrix(frame: Frame) -> Array:
    """A frame [mm] as a pose [m], read-only."""
    (x, y, z), (w, i, j, k) = frame
    # One packing of sixteen numbers: half the time of an array from rows, and nobody can write to it.
    return np.frombuffer(
        _pack(
            *(1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j), x * MM),
            *(2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i), y * MM),
            *(2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j), z * MM),
            *(0.0, 0.0, 0.0, 1.0),
        )
    ).reshape(4, 4)


_pack = Struct("16d").pack


def matrices(given: Iterable[Frame], count: int) -> Array:
    """So many frames [mm] as poses [m] (count, 4, 4), read-only: as matrix, in a tenth of its time."""
    numbers = chain.from_iterable(chain.from_iterable(given))
    x, y, z, w, i, j, k = np.fromiter(numbers, float, 7 * count).reshape(count, 7).T
    X = np.zeros((count, 4, 4))
    X[:, 0] = np.stack((1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j), x * MM), axis=1)
    X[:, 1] = np.stack((2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i), y * MM), axis=1)
    X[:, 2] = np.stack((2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j), z * MM), axis=1)
    X[:, 3, 3] = 1.0
    X.flags.writeable = False
    return X


def frame(X: Array) -> Frame:
    """A pose [m] as a frame [mm]."""
    x, y, z = (float(value) / MM for value in X[:3, 3])
    w, i, j, k = (float(value) for value in wxyz_from_rotation(X[:3, :3]))
    return (x, y, z), (w, i, j, k)
