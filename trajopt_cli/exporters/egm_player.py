"""An EGM stream played to whoever asks on the loopback: what comes back is kept, and held against what a first-order
follower would lag by.

In EGM the controller is the client: it sends EgmRobot to the sensor's port every cycle, and the sensor answers to where
that came from. So the controller's clock is the player's, and a simulated one may run as fast as it likes.
"""

from __future__ import annotations

import socket
from collections.abc import Iterator
from dataclasses import dataclass
from ipaddress import ip_address
from time import monotonic

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.egm import RobotState, Stream, read_reference, robot_message, robot_state, sensor_message
from trajopt_cli.geometry import Array

_NEAR = {"deg": 0.5, "mm": 5.0}  # from the first set point, where a stream may begin
_CLOCK = 2**32  # ms and numbers are of 32 bits
_DATAGRAM = 65536


@dataclass(frozen=True, eq=False)
class Played:
    """What came back at times t (m,) [s of the controller]: its positions x and the set points u it was answered with
    (m, k), in the stream's units. lost: numbers that never came. strangers: datagrams that were not the controller's
    next EgmRobot. why_not: why it ended before the stream did."""

    t: Array
    u: Array
    x: Array
    lost: int
    strangers: int
    why_not: str = ""


@dataclass(frozen=True)
class Lag:
    """How far an axis is behind its set points, at most: as foretold and as it came back.

    fastest: of the set points, 1/s. ramp: lag on a ramp of that speed, speed times time constant. measured and constant
    (of the first-order follower that fits best [s]): None where nothing came back, or did not move.
    """

    name: str
    unit: str
    fastest: float
    ramp: float
    foretold: float
    measured: float | None = None
    constant: float | None = None


def address(text: str) -> tuple[str, int]:
    """Host and port of HOST:PORT. Raises InputError for what is none, and for a host that is not the loopback."""
    host, _, port = text.rpartition(":")
    bracketed = host.startswith("[") and host.endswith("]")
    host = "127.0.0.1" if host == "localhost" else host.strip("[]")
    if (":" in host) != bracketed or not (port.isascii() and port.isdigit() and int(port) < 65536):
        raise InputError(f"--to {text}: wanted HOST:PORT, as 127.0.0.1:6510 or [::1]:6510")
    try:
        loopback = ip_address(host).is_loopback
    except ValueError:
        loopback = False
    if not loopback:
        raise InputError(
            f"--to {text}: is not the loopback, and this player moves no machine: it shows what a stream would do; give"
            " 127.0.0.1:PORT and let a simulated controller ask there"
        )
    return host, int(port)


def bound(host: str, port: int) -> socket.socket:
    """A UDP socket that hears on a loopback address. Raises InputError where the system refuses it."""
    out = socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, socket.SOCK_DGRAM)
    try:
        out.bind((host, port))
    except OSError as error:
        out.close()
        raise InputError(f"--to {host}:{port}: cannot listen: {error.strerror}") from error
    return out


def play(stream: Stream, here: socket.socket, settle: float, silence: float) -> Played:
    """Answer every EgmRobot with the set point due, until settle [s] behind the last one, on the controller's clock.

    It ends early where nothing comes for so long a silence [s], and where the controller stands elsewhere than the
    stream begins. Raises InputError for a controller with fewer axes than the stream.
    """
    heard = monotonic()
    rows: list[tuple[float, int, Array]] = []
    peer, begin, before, lost, strangers, why_not = None, 0, 0, 0, 0, ""
    while True:
        try:
            left = heard + silence - monotonic()
            if left <= 0:  # strangers do not make it longer
                raise TimeoutError
            here.settimeout(left)
            message, sender = here.recvfrom(_DATAGRAM)
        except TimeoutError:
            why_not = f"no EgmRobot message came for {silence:g} s"
            why_not += f", after {rows[-1][0]:.3f} s of {stream.duration:.3f}" if rows else ""
            break
        state = robot_state(message)
        step = 0 if state is None else (state.seqno - before) % _CLOCK
        if state is None or (peer is not None and (sender != peer or not 0 < step < _CLOCK // 2)):
            strangers += 1
            continue
        heard = monotonic()
        x = _axes_of(state, stream)
        if peer is None:
            peer, begin = sender, state.tm
            off = np.abs(x - stream.q[0]) / [_NEAR[unit] for unit in stream.units]
            if off.max() > 1:
                i = int(np.argmax(off))
                there, first, unit = x[i], stream.q[0, i], stream.units[i]
                why_not = f"the controller's {stream.names[i]} is at {there:g} {unit}, the stream begins at {first:g}"
                break
        else:
            lost += step - 1
        before = state.seqno
        t = ((state.tm - begin) % _CLOCK) / 1000
        if t > stream.duration + settle:
            break
        row = min(round(t / stream.period), len(stream.q) - 1)
        here.sendto(sensor_message(stream, row, len(rows), (state.tm - begin) % _CLOCK), sender)
        rows.append((t, row, x))
    times, due = np.array([t for t, _, _ in rows]), stream.q[[row for _, row, _ in rows]]
    back = np.array([x for *_, x in rows]).reshape(-1, stream.q.shape[1])
    return Played(times, due, back, lost, strangers, why_not)


def _axes_of(state: RobotState, stream: Stream) -> Array:
    beside = stream.q.shape[1] - stream.joints
    if len(state.joints) < stream.joints or len(state.external) < beside:
        raise InputError(
            f"the controller has {len(state.joints)} joints and {len(state.external)} external axes, the stream"
            f" {stream.joints} and {beside}"
        )
    return np.concatenate([state.joints[: stream.joints], state.external[:beside]])


def log_text(stream: Stream, played: Played) -> str:
    """The CSV: time, every axis as it came back, every axis as it was set."""
    axes = list(zip(stream.names, stream.units, strict=True))
    heads = ["t [s]", *(f"{n} [{u}]" for n, u in axes), *(f"{n} set [{u}]" for n, u in axes)]
    rows = np.hstack([played.t[:, None], played.x, played.u]).tolist()
    return "\n".join([",".join(heads), *(",".join(f"{value:.9g}" for value in row) for row in rows)]) + "\n"


def follower(t: Array, u: Array, constant: float) -> Array:
    """Where axes are that follow set points u (m, k), each held from its time on, by x' = (u - x) / constant, x = u at
    first: exact, whatever the steps."""
    share = -np.expm1(-np.diff(t) / constant)
    x = np.empty_like(u)
    x[0] = u[0]
    for i, a in enumerate(share):
        x[i + 1] = x[i] + a * (u[i] - x[i])
    return x


def lags(stream: Stream, constant: float, played: Played | None = None) -> Iterator[Lag]:
    """Every axis' lag behind the set points: of a follower with a time constant [s], and in what came back."""
    behind = stream.q - follower(stream.t, stream.q, constant)
    fastest, foretold = np.abs(stream.qd).max(axis=0), np.abs(behind).max(axis=0)
    for i, (name, unit) in enumerate(zip(stream.names, stream.units, strict=True)):
        measured = fit = None
        if played is not None and len(played.t) > 1:
            e = played.u[:, i] - played.x[:, i]
            measured = float(np.abs(e).max())
            fit = _constant(played.t, e, played.x[:, i])
        yield Lag(name, unit, float(fastest[i]), float(fastest[i]) * constant, float(foretold[i]), measured, fit)


def _constant(t: Array, e: Array, x: Array) -> float | None:
    """The time constant [s] of the first-order follower that fits a lag e best: a step goes the share 1 - exp(-h / T)
    of it. None for one that does not move, or does not follow."""
    squares = float(e[:-1] @ e[:-1])
    share = float(np.diff(x) @ e[:-1]) / squares if squares > 0 else 0.0
    return float(-np.median(np.diff(t)) / np.log1p(-share)) if 0 < share < 1 else None


def simulated_controller(stream: Stream, to: tuple[str, int], constant: float, settle: float) -> None:
    """A controller that asks there: a first-order follower that begins at the stream's first set point, on a clock of
    its own, as fast as answers come. It ends where there is none."""
    h = max(round(1000 * stream.period), 1)
    cycles = int((stream.duration + settle) * 1000 / h) + 3
    x, share = np.array(stream.q[0]), -np.expm1(-h / 1000 / constant)
    with socket.socket(socket.AF_INET6 if ":" in to[0] else socket.AF_INET, socket.SOCK_DGRAM) as there:
        there.settimeout(1.0)
        for i in range(cycles):
            there.sendto(robot_message(RobotState(i + 1, i * h, x[: stream.joints], x[stream.joints :])), to)
            try:
                u = read_reference(there.recv(_DATAGRAM))
            except (TimeoutError, ConnectionError):
                return
            x = x + share * (u - x)
