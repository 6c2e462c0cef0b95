"""Rows of a sequence and of an arm's joints as the judge reads them, and what their digits leave open."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.task_order import FramePose, JudgedArm
from trajopt_cli.iiwa.judge.tolerances import PERIOD, ROUNDING
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge.findings import finding
from trajopt_cli.trajectory import Trajectory

PLACE = ("x [m]", "y [m]", "z [m]")
ANGLES = ("alpha [rad]", "beta [rad]", "gamma [rad]")
"""Heads of a pose."""
_LOOKED_AT, _FEWEST, _ALL = 500, 9, 15  # rows; digits
_UNIT = 1e-6  # by which the norm of a printed quaternion may differ from 1


def worst(
    check: str, subject: str, off: Array, limit: float, unit: str, t: Array, doubt: ArrayLike = 0.0, **more: Any
) -> Finding:
    """The row (n,) that is farthest off, what its digits leave in doubt taken off, against limit plus that doubt.

    t (n,) [s]: times of the rows. more: as of finding.
    """
    doubt = np.broadcast_to(np.asarray(doubt), off.shape)
    row = int(np.argmax(off - doubt))
    most = limit + float(doubt[row])
    return finding(check, subject, off[row], most, unit, bool(off[row] <= most), time=float(t[row]), **more)


def worst_row(check: str, off: Array, limit: float, unit: str, t: Array, words: str) -> Finding:
    """The same, named by its number."""
    return worst(check, f"row {int(np.argmax(off))}", off, limit, unit, t, words=words)


def check_times(t: Array, h: float) -> Finding:
    """A row every period h [s] from 0 on."""
    return worst_row("period", np.abs(t - np.arange(len(t)) * h), PERIOD, "s", t, "is off its place in time by")


@dataclass(frozen=True, eq=False)
class Poses:
    """The tool in the world at times t (n,) [s]: positions p (n, 3) [m], rotations q (n, 4).

    off_p, off_q (n,): how far digits leave a row's position [m] and orientation [rad] uncertain. period [s]: of the
    grid that the rows should stand on; every pose of the task has a row where they do.
    """

    t: Array
    p: Array
    q: Array
    off_p: Array
    off_q: Array
    period: float

    @cached_property
    def gaps(self) -> Array:
        """Times (n-1,) between rows [s]."""
        return np.asarray(np.diff(self.t))

    @cached_property
    def step_p(self) -> Array:
        """Steps (n-1,) of the position [m]."""
        return np.asarray(np.linalg.norm(np.diff(self.p, axis=0), axis=1))

    @cached_property
    def step_q(self) -> Array:
        """Turns (n-1,) from row to row [rad]."""
        return turns.angle_between(self.q[:-1], self.q[1:])

    @cached_property
    def gridded(self) -> bool:
        """Whether the rows stand on the grid of the period."""
        return bool(np.all(np.abs(self.t - self.t[0] - np.arange(len(self.t)) * self.period) <= PERIOD))

    @cached_property
    def open(self) -> Array:
        """How far (n,) from the nearest row a pose of the task may lie, m plus rad: 0 where every pose has its row."""
        if self.gridded:
            return np.zeros(len(self.t))
        steps = self.step_p + self.step_q
        return np.asarray(np.maximum(np.r_[steps[0], steps], np.r_[steps, steps[-1]]))


def poses_of_joints(
    arm: JudgedArm, X_FT: FramePose, rows: Trajectory, resolution: Resolution | None, period: float
) -> Poses:
    """Where the tool is at joints, by pin; half a printed step of every joint is doubted."""
    X, J = arm.mechanism.flange(rows.q)
    q_WF = turns.from_matrix(X[:, :3, :3])
    lever = turns.turned(q_WF, X_FT.p)
    p, q = X[:, :3, 3] + lever, turns.product(q_WF, X_FT.q)
    off_p, off_q = ROUNDING * (1 + np.linalg.norm(p, axis=1)), np.full(len(p), ROUNDING)
    if resolution is not None:
        half = resolution.q / 2
        linear = J[:, :3] + np.cross(J[:, 3:], lever[:, :, None], axis=1)
        off_p, off_q = off_p + (np.linalg.norm(linear, axis=1) * half).sum(axis=1), off_q + half.sum(axis=1)
    return Poses(rows.t, p, q, off_p, off_q, period)


@of_kind(ErrorKind.RESULTS)
def read_table(text: str, file: str, needed: tuple[str, ...]) -> dict[str, Array]:
    """The columns of a CSV file by their heads. Raises InputError with file and line for a head of needed that is
    missing, a row of another length, what is no finite number, fewer than two rows, and times that do not increase."""
    lines = text.rstrip("\r\n").split("\n")
    heads = lines[0].rstrip("\r").split(",")
    for head in needed:
        if heads.count(head) != 1:
            raise InputError(f"needs one column '{head}', has {','.join(heads)}", file=file, line=1)
    if len(lines) < 3:
        raise InputError(f"{len(lines) - 1} rows; a sequence needs at least 2", file=file, line=len(lines))
    rows, width = lines[1:], len(heads)
    for i, row in enumerate(rows, start=2):
        if row.count(",") != width - 1:
            raise InputError(f"{row.count(',') + 1} values, the header has {width} columns", file=file, line=i)
    try:
        if "_" in text.partition("\n")[2] or not text.isascii():  # which float() takes for digits
            raise ValueError("a letter that no number has")
        table = np.loadtxt(rows, delimiter=",", comments=None, ndmin=2)
    except ValueError as error:
        line = next(i for i, row in enumerate(rows, start=2) if not all(map(_is_number, row.split(","))))
        raise InputError(f"holds what is no number: {error}", file=file, line=line) from error
    if (odd := np.flatnonzero(~np.isfinite(table).all(axis=1))).size:
        raise InputError("holds a number that is not finite", file=file, line=int(odd[0]) + 2)
    late = np.flatnonzero(np.diff(table[:, 0]) <= 0)
    if late.size:
        raise InputError("its time does not follow the one before", file=file, line=int(late[0]) + 3)
    return dict(zip(heads, table.T, strict=True))


def printed(text: str) -> float:
    """What the digits of a CSV file leave open, as a share of its numbers: 0 where they are all that a number has.

    The longest number of some hundred rows counts; less than nine digits are taken for nine.
    """
    rows = text.rstrip("\r\n").split("\n")[1:]
    fields = (field for row in rows[:: 1 + len(rows) // _LOOKED_AT] for field in row.strip().split(",")[1:])
    digits = max(len(one.lstrip("-").partition("e")[0].replace(".", "").lstrip("0")) for one in fields)
    return 0.0 if digits > _ALL else 0.5 * 10.0 ** (1 - max(digits, _FEWEST))


def _is_number(field: str) -> bool:
    with suppress(ValueError):
        float(field)
        return field.isascii() and "_" not in field
    return False


def columns(table: Mapping[str, Array], heads: tuple[str, ...]) -> Array:
    """Some columns side by side (n, k)."""
    return np.column_stack([table[head] for head in heads])


@of_kind(ErrorKind.RESULTS)
def unit(q: Array, file: str) -> Array:
    """Quaternions (n, 4) of norm 1. Raises InputError with file and line for any that is not of norm 1."""
    with np.errstate(over="ignore"):  # too large a number makes an infinite norm, which is refused
        norms = np.linalg.norm(q, axis=1)
    wrong = np.flatnonzero(np.abs(norms - 1) > _UNIT)
    if wrong.size:
        row = int(wrong[0])
        raise InputError(f"the quaternion's norm is {norms[row]:.9g}, wanted 1", file=file, line=row + 2)
    return np.asarray(q / norms[:, None])
