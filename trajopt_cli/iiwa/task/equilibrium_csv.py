"""Equilibrium sequences as CSV: one pose per period, the unit in every column's head, 17 digits. Text in, nouns out.

Times are printed in 15 digits where that reads back to 1e-15 of the time (0.003, not 0.0030000000000000001), else 17.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array, rotation_from_wxyz, wxyz_from_rotation
from trajopt_cli.iiwa.task.equilibrium import Equilibrium
from trajopt_cli.units import decimal


def read_numbers(rows: list[str], width: int, file: str, separator: str = ",") -> Array:
    """The finite numbers (n, width) of rows under a header line.

    Raises InputError with file and line for a row of another length, and with its column for what is no finite number.
    """
    for line, row in enumerate(rows, start=2):
        count = row.count(separator) + 1
        if count != width:
            found = f"{count if row.strip() else 'no'} values"
            raise InputError(f"{found}, the header has {width} columns", file=file, line=line)
    try:
        table = np.loadtxt(rows, delimiter=separator, comments=None, ndmin=2)
    except ValueError:
        table = np.full((1, 1), np.nan)
    if np.isfinite(table).all():
        return np.asarray(table, dtype=np.float64)
    for line, row in enumerate(rows, start=2):
        column = 1
        for field in row.rstrip("\r").split(separator):
            if not _is_finite(field):
                advice = "; write numbers with a decimal point" if "," in field else ""
                message = f"'{field.strip()[:40]}' is not a finite number{advice}"
                raise InputError(message, file=file, line=line, column=column)
            column += len(field) + 1
    raise InputError("the table holds a number that cannot be read", file=file)


def _is_finite(field: str) -> bool:
    try:
        return bool(np.isfinite(decimal(field)))
    except ValueError:
        return False


ANGLES_HEAD = "t [s],x [m],y [m],z [m],alpha [rad],beta [rad],gamma [rad]"
QUATERNION_HEAD = "t [s],x [m],y [m],z [m],qw [1],qx [1],qy [1],qz [1]"

_TIME_DIGITS = 15
_UNIT = 1e-6  # by which a quaternion's norm may differ from 1


def write_angles_csv(equilibrium: Equilibrium) -> str:
    """The file's text: time, position and angles of every row."""
    return _write(ANGLES_HEAD, equilibrium.t, equilibrium.pose)


def write_quaternion_csv(t: Array, p: Array, R: Array) -> str:
    """The file's text: times t (n,) [s], positions p (n, 3) [m], orientations R (n, 3, 3) as quaternions.

    The first quaternion has qw >= 0; no quaternion changes its sign from one row to the next.
    """
    q = wxyz_from_rotation(R)
    flips = np.sum(q[1:] * q[:-1], axis=1) < 0
    signs = np.r_[1.0, 1.0 - 2.0 * (np.cumsum(flips) % 2)]
    return _write(QUATERNION_HEAD, t, np.column_stack([p, q * signs[:, None]]))


@of_kind(ErrorKind.RESULTS)
def read_angles_csv(text: str, file: str) -> tuple[float, Array]:
    """Period h [s] and poses (n, 6) [m, rad] of a text as write_angles_csv gives it. file is for messages.

    Raises InputError with file, line and column for another header, a row of another length, and what is no number.
    """
    table = _read(text, file, ANGLES_HEAD)
    return float(table[1, 0]), table[:, 1:]


@of_kind(ErrorKind.RESULTS)
def read_quaternion_csv(text: str, file: str) -> tuple[Array, Array, Array]:
    """Times (n,) [s], positions (n, 3) [m] and orientations (n, 3, 3) of a text as write_quaternion_csv gives it.

    Raises InputError as read_angles_csv does, and for a quaternion that is not of norm 1.
    """
    table = _read(text, file, QUATERNION_HEAD)
    with np.errstate(over="ignore"):  # too large a number makes an infinite norm, which is refused
        norms = np.linalg.norm(table[:, 4:], axis=1)
    wrong = np.flatnonzero(np.abs(norms - 1) > _UNIT)
    if wrong.size:
        told = f"the quaternion's norm is {norms[wrong[0]]:.9g}; it must be 1 within 1e-6"
        raise InputError(told, file=file, line=int(wrong[0]) + 2)
    return table[:, 0], table[:, 1:4], rotation_from_wxyz(table[:, 4:])


def _write(head: str, t: Array, values: Array) -> str:
    form = ",".join(["%s", *["%.17g"] * values.shape[1]])
    rows = (form % (_time(at), *row) for at, row in zip(t.tolist(), values.tolist(), strict=True))
    return "\n".join([head, *rows, ""])


def _time(t: float) -> str:
    """In few digits where they say the same."""
    short = f"{t:.{_TIME_DIGITS}g}"
    return short if abs(float(short) - t) <= 1e-15 * abs(t) else f"{t:.17g}"


def _read(text: str, file: str, head: str) -> Array:
    """The table under a header; more is not asked of files that their folder holds against hashes."""
    first, *rows = text.rstrip("\n").split("\n")
    if first != head or len(rows) < 2:
        raise InputError(f"wanted the header {head} and two rows at least; make the folder again", file=file, line=1)
    return read_numbers(rows, head.count(",") + 1, file)
