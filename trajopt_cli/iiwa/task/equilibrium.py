"""The equilibrium sequence: one pose every period, what the compliant controller is fed; and its form as CSV.

In CSV the unit is in every column's head, numbers have 17 digits. Times are printed in 15 digits where that reads back
to 1e-15 of the time (0.003, not 0.0030000000000000001), else 17.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array, rotation_from_wxyz, wxyz_from_rotation
from trajopt_cli.iiwa.task.angles import angles_of, continuous
from trajopt_cli.iiwa.task.model import BETA_LIMIT, AngleMeaning, Change, RotationLaw
from trajopt_cli.units import decimal


@dataclass(frozen=True)
class Piece:
    """Rows first..last (both included) from one waypoint to the next, or standing at one (dwell)."""

    first: int
    last: int
    origin: str
    goal: str
    dwell: bool = False


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """Poses (n, 6) at times 0, h, 2 h, ...: position [m] in W and Tait-Bryan angles [rad] that never jump.

    meaning: whether the angles count from R_start. R (n, 3, 3): the same orientations as matrices, R_WT = R R_start or
    R_WT = R after meaning; the angles follow from them where rotation is slerp, they from the angles elsewhere.
    pieces: which rows belong to which segment; neighbours share a row. notes: what the user should know.
    """

    h: float
    pose: Array
    R: Array
    rotation: RotationLaw
    meaning: AngleMeaning
    pieces: tuple[Piece, ...]
    notes: tuple[str, ...] = ()

    @property
    def t(self) -> Array:
        """Times (n,) [s]."""
        return np.asarray(np.arange(len(self.pose)) * self.h, dtype=np.float64)

    @property
    def duration(self) -> float:
        """Time of the last row [s]."""
        return (len(self.pose) - 1) * self.h

    def timed(self, changes: Sequence[Change]) -> tuple[Change, ...]:
        """Changes with the times at which the sequence arrives at their poses; others as they are."""
        arrived = {piece.goal: piece.last * self.h for piece in self.pieces if not piece.dwell}
        arrived[self.pieces[0].origin] = 0.0
        return tuple(one if one.pose is None else replace(one, t=arrived[one.pose]) for one in changes)

    def rotations(self, R_start: Array) -> Array:
        """Orientations R_WT (n, 3, 3) of the tool in the world, of a controller switched on at R_start (3, 3)."""
        return self.R @ R_start if self.meaning is AngleMeaning.RELATIVE else self.R


@of_kind(ErrorKind.PROGRAM)
def counted(equilibrium: Equilibrium, meaning: AngleMeaning, R_start: Array) -> Equilibrium:
    """equilibrium with its angles in this meaning; R_start (3, 3): the tool's orientation where it is switched on.

    Raises InputError where an angle beta then passes its limit (but for slerp, which has none).
    """
    if meaning is equilibrium.meaning:
        return equilibrium
    R = equilibrium.rotations(R_start)
    if meaning is AngleMeaning.RELATIVE:
        R = R @ R_start.T
    angles = continuous(angles_of(R))
    if equilibrium.rotation is RotationLaw.TAIT_BRYAN:
        worst = int(np.argmax(np.abs(angles[:, 1])))
        if abs(angles[worst, 1]) > BETA_LIMIT:
            piece = next(piece for piece in equilibrium.pieces if piece.first <= worst <= piece.last)
            raise InputError(
                f"angles: counted {meaning.value}, beta is {np.degrees(angles[worst, 1]):.4g}° at"
                f" {worst * equilibrium.h:.3f} s between {piece.origin} and {piece.goal}, limit"
                f" {np.degrees(BETA_LIMIT):g}°; turn the start or use 'rotation: slerp'"
            )
    return replace(equilibrium, pose=np.column_stack([equilibrium.pose[:, :3], angles]), R=R, meaning=meaning)


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
