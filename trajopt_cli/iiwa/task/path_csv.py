"""Paths and recorded forces as CSV: one pose per row, x, y, z and three angles or a quaternion, units in the header.

`x [mm],y [mm],z [mm],alpha [deg],beta [deg],gamma [deg]` or `x [m],y [m],z [m],qw,qx,qy,qz`, in any order; a comma, a
semicolon or a tab between columns, the point in numbers, UTF-8 with or without a byte-order mark, any line ends.
Quaternions are the tool in the world, of norm 1 but for the digits they are printed with. A simulation.csv is a path,
too: what the controller was led along, thinned. Forces: `t,Fx,Fy,Fz,Mx,My,Mz`. Text in, poses out.
"""

from __future__ import annotations

import os
import re

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array, BoolArray, IndexArray, rotation_from_wxyz
from trajopt_cli.iiwa.task.angles import angles_of, rotation
from trajopt_cli.iiwa.task.equilibrium import read_numbers
from trajopt_cli.iiwa.task.model import AngleMeaning, Passing, PathPoints, PushLog
from trajopt_cli.quantity import ANGLE, FORCE, LENGTH, MOMENT, TIME

MOST_POINTS, MOST_BYTES = 2_000_000, 400_000_000
_POSITION, _ANGLES, _QUATERNION = ("x", "y", "z"), ("alpha", "beta", "gamma"), ("qw", "qx", "qy", "qz")
_UNITS: dict[str, dict[str, float]] = {
    **dict.fromkeys(_POSITION, LENGTH),
    **dict.fromkeys(_ANGLES, ANGLE),
    **{name: {"1": 1.0} for name in _QUATERNION},
}
_FORCES: dict[str, dict[str, float]] = {
    "t": {"": 1.0, **TIME},
    **{name: {"": 1.0, **(FORCE if name[0] == "f" else MOMENT)} for name in ("fx", "fy", "fz", "mx", "my", "mz")},
}
_SIMULATED = re.compile(r"t \[s\],x_e \[m\],")
_HEAD = re.compile(r"(?P<name>\w+)\s*(?:\[(?P<unit>[^\]]*)\])?")
_EXAMPLE = "for example 'x [mm],y [mm],z [mm],alpha [deg],beta [deg],gamma [deg]' or 'x [m],y [m],z [m],qw,qx,qy,qz'"
_SAME = 1e-12  # m, rad: nearer poses are one
_FARTHEST, _LONGEST = 1e3, 10.0  # m: from the origin, and between neighbours
_MOST_TURN = 1e3  # rad
_UNIT = 1e-4  # by which a quaternion's norm may differ from 1: four digits


def read_text(file: str) -> str:
    """The file's text, without a byte-order mark. Raises InputError where it cannot be read as UTF-8."""
    try:
        if (size := os.stat(file).st_size) > MOST_BYTES:
            raise InputError(f"has {size / 1e6:.0f} MB, at most {MOST_BYTES // 10**6} MB are read", file=file)
        with open(file, encoding="utf-8-sig") as stream:
            return stream.read()
    except OSError as error:
        raise InputError(f"cannot read the path: {error.strerror}", file=file) from error
    except UnicodeDecodeError as error:
        raise InputError(f"byte {error.start} is not UTF-8; save the path as UTF-8", file=file) from error


@of_kind(ErrorKind.PROGRAM)
def read_forces(text: str, file: str) -> PushLog:
    """A recorded force, world axes, at the TCP; units may be left out. Raises InputError as read_path does, and for
    times that do not grow."""
    columns = _columns(text, file, _FORCES, "for example 't,Fx,Fy,Fz,Mx,My,Mz'")
    t, *force = (columns[name] for name in _FORCES)
    if (i := _first(np.diff(t) <= 0)) is not None:
        raise _wrong(f"time {t[i + 1]:g} s follows {t[i]:g} s; times must grow", i + 1, file)
    return PushLog(t, np.column_stack(force))


def guided_path(text: str, file: str, meaning: AngleMeaning, R_start: Array, near: Passing) -> PathPoints | None:
    """The controller's poses of a simulation.csv, thinned to chords that stay within near of all; None for any other
    text. R_start as of read_path: the start's, that of the run."""
    lines = text.rstrip().split("\n")
    if not _SIMULATED.match(lines[0]):
        return None
    poses = read_numbers(lines[1:], lines[0].count(",") + 1, file)[:, 7:13]
    kept = _chords(poses / np.repeat([near.tolerance, near.turn_tolerance], 3))
    poses = poses[kept]
    if meaning is AngleMeaning.ABSOLUTE:
        poses[:, 3:] = angles_of(rotation(poses[:, 3:]) @ R_start)
    if len(poses) < 2:
        raise InputError("the run stays where it is; it gives no path", file=file)
    return PathPoints(poses, file, kept + 2)


def _chords(x: Array) -> IndexArray:
    """Rows of x (n, k) between which chords come within 1 of all others (Douglas and Peucker)."""
    kept, parts = {0, len(x) - 1}, [(0, len(x) - 1)]
    while parts:
        i, j = parts.pop()
        if j - i < 2:
            continue
        way, off = x[j] - x[i], x[i + 1 : j] - x[i]
        share = np.clip(off @ way / max(float(way @ way), 1e-300), 0.0, 1.0)
        far = np.linalg.norm(off - share[:, None] * way, axis=1)
        k = int(np.argmax(far))
        if far[k] > 1.0:
            kept.add(i + 1 + k)
            parts += [(i, i + 1 + k), (i + 1 + k, j)]
    rows = np.array(sorted(kept))
    apart = np.linalg.norm(np.diff(x[rows], axis=0), axis=1) > _SAME
    return rows[np.r_[True, apart]]


@of_kind(ErrorKind.PROGRAM)
def read_path(text: str, file: str, meaning: AngleMeaning, R_start: Array) -> PathPoints:
    """The poses of a text, in SI, angles as meaning says; R_start (3, 3): the tool where the controller is switched on.

    Raises InputError with the row for another header, a missing unit, a field that is no finite number, a row of
    another length, fewer than two rows, more than MOST_POINTS, a quaternion that is none, a pose that repeats the one
    before, and places no cell has.
    """
    value = _columns(text, file, _UNITS, _EXAMPLE)
    p = np.column_stack([value[name] for name in _POSITION])
    far = np.abs(p).max(axis=1)
    if (i := _first(far > _FARTHEST)) is not None:
        raise _wrong(f"{far[i]:g} m from the origin, at most {_FARTHEST:g} m; check the unit", i, file)
    way = np.linalg.norm(np.diff(p, axis=0), axis=1)
    if (i := _first(way > _LONGEST)) is not None:
        message = f"{way[i]:.6g} m from the row before, at most {_LONGEST:g} m; check the row and the unit"
        raise _wrong(message, i + 1, file)
    if _QUATERNION[0] in value:
        q = np.column_stack([value[name] for name in _QUATERNION])
        norm = np.linalg.norm(q, axis=1)
        if (i := _first(np.abs(norm - 1) > _UNIT)) is not None:
            raise _wrong(f"the quaternion's norm is {norm[i]:.6g}; it must be 1 within {_UNIT:g}", i, file)
        R = rotation_from_wxyz(q)
        angles = angles_of(R @ R_start.T if meaning is AngleMeaning.RELATIVE else R)
    else:
        angles = np.column_stack([value[name] for name in _ANGLES])
        most = np.abs(angles).max(axis=1)
        if (i := _first(most > _MOST_TURN)) is not None:
            raise _wrong(f"an angle of {most[i]:g} rad, at most {_MOST_TURN:g} rad; check the unit", i, file)
    same = (way <= _SAME) & (np.abs(np.diff(angles, axis=0)).max(axis=1) <= _SAME)
    if (i := _first(same)) is not None:
        more = f", as do {same.sum() - 1} more rows" if same.sum() > 1 else ""
        raise _wrong(f"repeats the row before{more}; take repeated rows out", i + 1, file)
    return PathPoints(np.hstack([p, angles]), file, np.arange(2, len(p) + 2))


def _columns(text: str, file: str, known: dict[str, dict[str, float]], example: str) -> dict[str, Array]:
    """The columns by name (n,), in SI."""
    lines = text.rstrip().split("\n")
    if not lines[0].strip():
        raise InputError(f"the first line must be a header, {example}", file=file, line=1)
    separator = next((one for one in (";", "\t") if one in lines[0]), ",")
    factors = _factors(lines[0].split(separator), file, known, example)
    body = lines[1:]
    if not 2 <= len(body) <= MOST_POINTS:
        bound = "at least 2" if len(body) < 2 else f"at most {MOST_POINTS}"
        raise InputError(f"{len(body)} rows under the header; a path needs {bound}", file=file, line=len(lines))
    table = read_numbers(body, len(factors), file, separator)
    return {name: factor * table[:, i] for i, (name, factor) in enumerate(factors.items())}


def _factors(heads: list[str], file: str, known: dict[str, dict[str, float]], example: str) -> dict[str, float]:
    """Names of the columns in their order, each with its unit's factor."""
    out: dict[str, float] = {}
    for field in heads:
        found = _HEAD.fullmatch(field.strip().strip('"'))
        name = found["name"].lower() if found else ""
        if found is None or name not in known:
            message = f"the column is '{field.strip()[:40]}'; wanted are {', '.join(known)}, {example}"
            raise InputError(message, file=file, line=1)
        if name in out:
            raise InputError(f"column '{name}' stands twice", file=file, line=1)
        units = known[name]
        unit = (found["unit"] or ("1" if "1" in units else "")).strip()
        if unit not in units:
            given = f"has the unit '{unit}'" if unit else "has no unit"
            ways = " or ".join(f"'{name} [{one}]'" for one in units)
            raise InputError(f"column '{name}' {given}; write {ways}", file=file, line=1)
        out[name] = units[unit]
    turned = [kind for kind in (_ANGLES, _QUATERNION) if any(name in out for name in kind)]
    wanted = _POSITION + (turned[0] if len(turned) == 1 else ()) if known is _UNITS else tuple(known)
    missing = [name for name in wanted if name not in out]
    if missing or (known is _UNITS and len(turned) != 1):
        fault = f"lacks {', '.join(missing)}" if missing else "needs either angles or a quaternion"
        raise InputError(f"the header {fault}; write it {example}", file=file, line=1)
    return out


def _first(wrong: BoolArray) -> int | None:
    return int(np.argmax(wrong)) if wrong.any() else None


def _wrong(message: str, row: int, file: str) -> InputError:
    """row: under the header, from 0."""
    return InputError(f"row {row + 1}: {message}", file=file, line=row + 2)
