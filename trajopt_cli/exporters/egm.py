"""A joint motion as a stream for ABB's Externally Guided Motion (EGM): an EgmSensor message every controller cycle.

Messages are Protocol Buffers of the 2nd syntax, as the controller's own egm.proto defines them. Field numbers and units
from what is public of it: docs.rs/abbegm (abb.egm.rs: numbers; distances in mm, angles in degrees) and
ros-industrial/abb_libegm (the same numbers in its wrappers, external axes beside the robot's joints).

EgmSensor: header 1, planned 2, speedRef 3. EgmRobot: header 1, feedBack 2. EgmHeader: seqno 1, tm 2 [ms], mtype 3 (2
from the controller, 3 from the sensor). planned and feedBack: joints 1, externalJoints 3, time 4; speedRef: joints 1,
externalJoints 3. EgmJoints: joints 1, doubles. EgmClock: sec 1, usec 2.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from struct import pack, unpack_from

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.joint import between_rows, check_rate
from trajopt_cli.exporters.recorded import Recorded
from trajopt_cli.geometry import Array, readonly
from trajopt_cli.trajectory import TABLE, Trajectory
from trajopt_cli.units import DEG, MM, slides, unit_of

HIGHEST_RATE = 250.0  # Hz: EGM takes a message every 4 ms at most
_JOINTS, _RAIL = 6, "rail"
_DATA, _CORRECTION = 2, 3  # message types of controller and sensor
_LETTERS = "abcdef"


@dataclass(frozen=True, eq=False)
class Stream:
    """Set points a period [s] apart: positions q and speeds qd (n, k) of so many joints [deg], then external axes a, b,
    ... [mm] as far as any is driven, those of turns in deg. driven: the external axes that are, the rail last; a stream
    that was read says neither."""

    period: float
    joints: int
    q: Array
    qd: Array
    turns: tuple[int, ...] = ()
    driven: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "q", readonly(self.q))
        object.__setattr__(self, "qd", readonly(self.qd))

    @property
    def names(self) -> tuple[str, ...]:
        """joint_1 and so on, then eax_a and so on."""
        names = [*(f"joint_{i + 1}" for i in range(self.joints)), *(f"eax_{letter}" for letter in _LETTERS)]
        return tuple(names[: len(self.units)])

    @property
    def units(self) -> tuple[str, ...]:
        """Of every axis."""
        beside: int = self.q.shape[1] - self.joints
        return ("deg",) * self.joints + tuple("deg" if i in self.turns else "mm" for i in range(beside))

    @property
    def t(self) -> Array:
        """(n,) [s]"""
        return np.arange(len(self.q)) * np.float64(self.period)

    @property
    def duration(self) -> float:
        """s"""
        return self.period * (len(self.q) - 1)


@dataclass(frozen=True, eq=False)
class RobotState:
    """What a controller says of itself: number, its clock tm [ms], positions of joints [deg] and external axes [mm]."""

    seqno: int
    tm: int
    joints: Array
    external: Array


def stream_of(motion: Recorded, rate: float = HIGHEST_RATE, eax: int | None = None) -> Stream:
    """Set points at k / rate, the last one at rest at the exact end. eax: index of the rail's external axis.

    Positioners that turn have their own letters; axes before the last one that have none are 0. Raises InputError for
    a motion of another kind of robot, or without speeds, and for a rate above 250 Hz.
    """
    trajectory, layout = motion.trajectory, _layout(motion.trajectory)
    if motion.period is not None or layout is None:
        raise InputError("is no motion of a six-axis robot; EGM is ABB's, give a folder of trajopt optimize")
    if not 0 < rate <= HIGHEST_RATE:
        raise InputError(f"rate {rate:g} Hz lies outside (0, {HIGHEST_RATE:g}] Hz; EGM's cycle is 4 ms")
    if trajectory.qd is None:
        raise InputError("the trajectory has no speed columns; resampling needs them")
    check_rate(trajectory, rate)
    steps = int(np.ceil(trajectory.duration * rate - 1e-9))
    t = np.minimum(trajectory.t[0] + np.arange(steps + 1) / rate, trajectory.t[-1])
    q, qd = between_rows(trajectory, t)
    q[-1], qd[-1] = trajectory.q[-1], 0.0
    arm, rails = layout
    tables = trajectory.tables
    turns = () if tables is None else tuple(_LETTERS.index(name[len(TABLE)]) for name in tables.names)
    if len({*turns}) < len(turns):
        raise InputError("has two units on one external axis, and EGM has one place for it; export a CSV file")
    own = [trajectory.names[i] for i in rails]
    letters = [*turns, *(eax or 0 if name == _RAIL else _LETTERS.index(name[-1]) for name in own)]
    beside = np.zeros((2, len(t), max(letters, default=-1) + 1))
    beside[:, :, letters[len(turns) :]] = np.stack([q[:, rails], qd[:, rails]]) / MM
    if tables is not None:
        beside[:, :, [*turns]] = np.array(between_rows(tables, t)) / [unit_of(name)[0] for name in tables.names]
    places, speeds = (np.hstack([x[:, arm] / DEG, more]) for x, more in zip((q, qd), beside, strict=True))
    turning = tuple(
        i for i, name in zip(turns, () if tables is None else tables.names, strict=True) if not slides(name)
    )
    return Stream(1 / rate, _JOINTS, places, speeds, turning, tuple(f"eax_{_LETTERS[i]}" for i in letters))


def _layout(trajectory: Trajectory) -> tuple[list[int], list[int]] | None:
    """Columns of six joints and of the rails; None for another robot's."""
    rails = [i for i, name in enumerate(trajectory.names) if slides(name)]
    arm = [i for i in range(len(trajectory.names)) if i not in rails]
    return (arm, rails) if len(arm) == _JOINTS else None


def stream_parts(stream: Stream) -> Iterator[bytes]:
    """The file, message by message, each behind its length as a varint, as Protocol Buffers delimit them."""
    for i in range(len(stream.q)):
        message = sensor_message(stream, i, i, round(1000 * stream.period * i))
        yield _varint(len(message)) + message


def read_stream(content: bytes, file: str) -> Stream:
    """The set points of a file. Raises InputError with the message's number for what is no stream of EgmSensor."""
    rows: list[tuple[float, Array, Array, Array, Array]] = []
    at = 0
    while at < len(content):
        try:
            size, begin = _read_varint(content, at)
            at = begin + size
            if at > len(content):
                raise ValueError("it ends in the middle of a message")
            message = _fields(content[begin:at])
            planned, speed = (_fields(_last(message, number)) for number in (2, 3))
            clock = _fields(_last(planned, 4))
            time = _whole(clock, 1) + 1e-6 * _whole(clock, 2)
            q, qd = ((_numbers(part, 1), _numbers(part, 3)) for part in (planned, speed))
            rows.append((time, *q, *qd))
        except ValueError as error:
            raise InputError(f"message {len(rows) + 1} is no EgmSensor of trajopt: {error}", file=file) from error
    shapes = {tuple(len(part) for part in row[1:]) for row in rows}
    if len(rows) < 2 or len(shapes) != 1 or (shape := shapes.pop())[:2] != shape[2:]:
        raise InputError("is no EGM stream: two set points or more, each with speeds, of the same axes", file=file)
    period = (rows[-1][0] - rows[0][0]) / (len(rows) - 1)
    if period <= 0:
        raise InputError("is no EGM stream: its times do not increase", file=file)
    places, speeds = (np.array([np.concatenate(row[i : i + 2]) for row in rows]) for i in (1, 3))
    return Stream(period, shape[0], places, speeds)


def sensor_message(stream: Stream, row: int, seqno: int, tm: int) -> bytes:
    """The EgmSensor message with a row's set point and speed reference. tm [ms]: for its header."""
    micros = round(1e6 * stream.period * row)
    clock = _number(1, micros // 10**6) + _number(2, micros % 10**6)
    planned, speed = (_axes(values[row], stream.joints) for values in (stream.q, stream.qd))
    header = _number(1, seqno) + _number(2, tm) + _number(3, _CORRECTION)
    return _nested(1, header) + _nested(2, planned + _nested(4, clock)) + _nested(3, speed)


def read_reference(message: bytes) -> Array:
    """The set point of an EgmSensor message: joints, then external axes. Raises ValueError for what is none."""
    planned = _fields(_last(_fields(message), 2))
    return np.concatenate([_numbers(planned, 1), _numbers(planned, 3)])


def robot_message(state: RobotState) -> bytes:
    """An EgmRobot message, as a controller sends it."""
    header = _number(1, state.seqno) + _number(2, state.tm) + _number(3, _DATA)
    values = np.r_[state.joints, state.external]
    return _nested(1, header) + _nested(2, _axes(values, len(state.joints)))


def robot_state(message: bytes) -> RobotState | None:
    """What an EgmRobot message says; None for what is none, or says neither number, clock nor joints."""
    try:
        fields = _fields(message)
        header, back = _fields(_last(fields, 1)), _fields(_last(fields, 2))
        joints, external = _numbers(back, 1), _numbers(back, 3)
    except ValueError:
        return None
    if not (1 in header and 2 in header and len(joints) and np.isfinite(np.r_[joints, external]).all()):
        return None
    return RobotState(_whole(header, 1), _whole(header, 2), joints, external)


# ---------------------------------------------------------------------------------------------------- Protocol Buffers

_LENGTH, _DOUBLE = 2, 1  # wire types; 0 is a varint, 5 has four bytes


def _varint(number: int) -> bytes:
    out = bytearray()
    while number > 0x7F:
        out.append(number & 0x7F | 0x80)
        number >>= 7
    return bytes([*out, number])


def _number(field: int, value: int) -> bytes:
    return _varint(field << 3) + _varint(value)


def _nested(field: int, content: bytes) -> bytes:
    return _varint(field << 3 | _LENGTH) + _varint(len(content)) + content


def _axes(values: Array, joints: int) -> bytes:
    """joints and, where there are any, externalJoints."""
    parts = [(1, values[:joints]), (3, values[joints:])]
    tag = _varint(1 << 3 | _DOUBLE)
    return b"".join(_nested(field, b"".join(tag + pack("<d", x) for x in part)) for field, part in parts if len(part))


def _read_varint(data: bytes, at: int) -> tuple[int, int]:
    """A number and where it ends."""
    number = 0
    for shift in range(0, 70, 7):
        if at >= len(data):
            raise ValueError("it ends in the middle of a number")
        byte, at = data[at], at + 1
        number |= (byte & 0x7F) << shift
        if byte < 0x80:
            return number, at
    raise ValueError("a number is too long")


def _fields(data: bytes) -> dict[int, list[int | bytes]]:
    """All values of a message by field number: whole numbers, and all else as bytes."""
    found, at = defaultdict[int, list[int | bytes]](list), 0
    while at < len(data):
        tag, at = _read_varint(data, at)
        size = {_DOUBLE: 8, 5: 4}.get(tag & 7)
        if tag & 7 in (0, _LENGTH):
            size, at = _read_varint(data, at)
        if tag & 7 == 0 and size is not None:  # the number itself
            found[tag >> 3].append(size)
            continue
        if size is None or at + size > len(data):
            raise ValueError("it is no message of Protocol Buffers")
        found[tag >> 3].append(data[at : at + size])
        at += size
    return found


def _last(fields: dict[int, list[int | bytes]], number: int) -> bytes:
    value = fields.get(number, [b""])[-1]
    if not isinstance(value, bytes):
        raise ValueError(f"field {number} is a number")
    return value


def _whole(fields: dict[int, list[int | bytes]], number: int) -> int:
    value = fields.get(number, [0])[-1]
    if not isinstance(value, int):
        raise ValueError(f"field {number} is no whole number")
    return value


def _numbers(fields: dict[int, list[int | bytes]], number: int) -> Array:
    """The doubles of an EgmJoints message in a field, packed or one by one."""
    joints = b"".join(value for value in _fields(_last(fields, number)).get(1, []) if isinstance(value, bytes))
    if len(joints) % 8:
        raise ValueError("joints are no doubles")
    return np.array(unpack_from(f"<{len(joints) // 8}d", joints))
