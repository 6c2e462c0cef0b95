"""The EGM stream, read back by Google's library, and what a controller of that library's messages makes of it."""

from __future__ import annotations

import socket
import time
from collections.abc import Iterator
from io import BytesIO
from threading import Event, Thread
from typing import Any

import numpy as np
import pytest
from egm_messages import EgmRobot, EgmSensor
from google.protobuf.proto import parse_length_prefixed
from google.protobuf.unknown_fields import UnknownFieldSet
from hypothesis import given, settings
from hypothesis import strategies as st

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.egm import Stream, read_stream, robot_state, stream_of, stream_parts
from trajopt_cli.exporters.egm_player import Played, address, bound, follower, lags, log_text, play
from trajopt_cli.exporters.recorded import Recorded
from trajopt_cli.trajectory import Trajectory

ARM = tuple(f"joint_{i}" for i in range(1, 7))
T = 0.3301  # s, between two cycles


def on_a_rail() -> Recorded:
    """Two parabolas for the rail, 0.05 m, and joints that go with it, 0.02 degrees a mm times their number."""
    t = np.array([0.0, T / 2, T])
    rail, speed = 0.05 * np.array([0, 0.5, 1]), np.array([0, 0.05 * 2 / T, 0])
    share = np.r_[1.0, np.deg2rad(20.0 * np.arange(1, 7))]
    return Recorded("a plan", Trajectory(("rail", *ARM), t, np.outer(rail, share), np.outer(speed, share)))


def messages(content: bytes) -> Iterator[Any]:
    file = BytesIO(content)
    while (message := parse_length_prefixed(EgmSensor, file)) is not None:
        yield message


def test_googles_library_reads_every_message_with_nothing_left_over() -> None:
    found = [*messages(b"".join(stream_parts(stream_of(on_a_rail(), eax=2))))]
    assert len(found) == int(np.ceil(T * 250)) + 1
    for i, one in enumerate(found):
        parts = [one, one.header, one.planned, one.planned.joints, one.planned.externalJoints, one.planned.time]
        assert not any(len(UnknownFieldSet(part)) for part in (*parts, one.speedRef, one.speedRef.externalJoints))
        assert (one.header.seqno, one.header.tm, one.header.mtype) == (i, 4 * i, 3)
        assert one.planned.time.sec + 1e-6 * one.planned.time.usec == pytest.approx(4e-3 * i, abs=1e-9)
        t = min(4e-3 * i, T)
        u = t / T
        rail = 50 * (2 * u * u if u < 0.5 else 1 - 2 * (1 - u) ** 2)  # mm; two parabolas, rest to rest
        speed = 50 * 4 * (min(u, 1 - u)) / T
        np.testing.assert_allclose(one.planned.externalJoints.joints, [0, 0, rail], rtol=0, atol=1e-9)
        np.testing.assert_allclose(one.speedRef.externalJoints.joints, [0, 0, speed], rtol=0, atol=1e-7)
        np.testing.assert_allclose(one.planned.joints.joints, rail * 0.02 * np.arange(1, 7), rtol=0, atol=1e-6)
        np.testing.assert_allclose(one.speedRef.joints.joints, speed * 0.02 * np.arange(1, 7), rtol=0, atol=1e-6)
    assert found[-1].planned.externalJoints.joints[2] == 50.0
    assert not any(found[-1].speedRef.joints.joints)


def test_a_file_is_read_back_to_the_last_bit() -> None:
    given = stream_of(on_a_rail(), eax=0)
    back = read_stream(b"".join(stream_parts(given)), "s.egm")
    assert (back.period, back.joints, back.names) == (pytest.approx(4e-3, abs=1e-12), 6, (*ARM, "eax_a"))
    np.testing.assert_array_equal(back.q, given.q)
    np.testing.assert_array_equal(back.qd, given.qd)
    without = Recorded("a plan", Trajectory(ARM, on_a_rail().trajectory.t, np.zeros((3, 6)), np.zeros((3, 6))))
    assert read_stream(b"".join(stream_parts(stream_of(without))), "s.egm").names == ARM


def test_what_is_no_stream_is_one_line() -> None:
    whole = b"".join(stream_parts(stream_of(on_a_rail(), eax=0)))
    for content, said in (
        (b"", "is no EGM stream: two set points or more"),
        (b"t [s],joint_1 [rad]\n", "message 1 is no EgmSensor of trajopt"),
        (whole[:-3], "message 84 is no EgmSensor of trajopt: it ends in the middle of a message"),
        (b"\x02\x0a\x00" * 3, "is no EGM stream"),
    ):
        with pytest.raises(InputError, match=f"s.egm: {said}"):
            read_stream(content, "s.egm")
    five = Trajectory(ARM[:5], np.arange(2.0), np.zeros((2, 5)), np.zeros((2, 5)))
    for motion in (Recorded("the arm's joints", on_a_rail().trajectory, period=1e-3), Recorded("a plan", five)):
        with pytest.raises(InputError, match="EGM is ABB's"):
            stream_of(motion)
    with pytest.raises(InputError, match=r"rate 500 Hz lies outside \(0, 250\] Hz; EGM's cycle is 4 ms"):
        stream_of(on_a_rail(), 500)


def robot(seqno: int, tm: int, joints: Any, external: Any = ()) -> Any:
    """A message with more in it than the player needs."""
    out = EgmRobot()
    out.header.seqno, out.header.tm, out.header.mtype = seqno, tm, 2
    out.feedBack.joints.joints.extend(joints)
    out.feedBack.externalJoints.joints.extend(external)
    out.feedBack.cartesian.pos.x, out.planned.time.sec = 500.0, 7
    out.motorState.state, out.mciConvergenceMet, out.utilizationRate = 1, True, 3.5
    return out


def test_a_controllers_message_is_read_whatever_else_it_says() -> None:
    state = robot_state(robot(2**32 - 1, 123456, [1.5, -2, 3, 4, 5, 1e-300], [1350.0]).SerializeToString())
    assert state is not None
    assert (state.seqno, state.tm) == (2**32 - 1, 123456)
    assert (state.joints.tolist(), state.external.tolist()) == ([1.5, -2, 3, 4, 5, 1e-300], [1350.0])
    packed = b"\x0a\x04\x08\x05\x10\x08" + b"\x12\x14\x0a\x12\x0a\x10" + np.array([1.0, 2.0]).tobytes()
    state = robot_state(packed)  # a repeated number may also come packed
    assert state is not None
    assert state.joints.tolist() == [1.0, 2.0]
    assert robot_state(robot(1, 4, []).SerializeToString()) is None
    assert robot_state(robot(1, 4, [np.nan]).SerializeToString()) is None


@settings(max_examples=300, deadline=None)
@given(st.binary(max_size=60))
def test_any_datagram_is_read_or_is_none(datagram: bytes) -> None:
    state = robot_state(datagram)
    assert state is None or np.isfinite([*state.joints, *state.external]).all()


# --------------------------------------------------------------------------------------------------------- the player


def ramp(speed: float = 20.0, n: int = 251) -> Stream:
    """joint_1 at a steady speed [deg/s] for a second, everything else at rest."""
    q, qd = np.zeros((n, 7)), np.zeros((n, 7))
    q[:, 0], qd[:, 0] = speed * 4e-3 * np.arange(n), speed
    return Stream(4e-3, 6, q, qd)


class Controller(Thread):
    """A first-order follower that speaks EGM by Google's library; it leaves out the messages that are skipped, and
    sends others twice, with noise before them."""

    def __init__(self, port: int, constant: float, cycles: int, skipped: frozenset[int] = frozenset(), x: float = 0.0):
        super().__init__(daemon=True)
        self.port, self.share, self.cycles, self.skipped = port, 1 - np.exp(-4e-3 / constant), cycles, skipped
        self.x, self.answers = np.r_[x, np.zeros(6)], list[Any]()

    def run(self) -> None:
        to, u = ("127.0.0.1", self.port), self.x
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as here:
            here.settimeout(0.3)
            for i in range(self.cycles):
                if i not in self.skipped:
                    message = robot(100 + i, (2**32 - 8 + 4 * i) % 2**32, self.x[:6], self.x[6:]).SerializeToString()
                    noisy = i in (3, 8)
                    if noisy:
                        here.sendto(b"nothing of EGM", to)
                    here.sendto(message, to)
                    try:
                        self.answers.append(EgmSensor.FromString(here.recv(4096)))
                    except TimeoutError:
                        return
                    if noisy:
                        here.sendto(message, to)  # again, and old by now
                    planned = self.answers[-1].planned
                    u = np.r_[planned.joints.joints, planned.externalJoints.joints]
                self.x = self.x + self.share * (u - self.x)


def played_by(
    controller: Controller, stream: Stream, here: socket.socket, settle: float = 0.2, silence: float = 1.0
) -> Played:
    controller.start()
    found = play(stream, here, settle, silence)
    controller.join(3.0)
    return found


@pytest.fixture
def here() -> Iterator[socket.socket]:
    with bound("127.0.0.1", 0) as out:
        yield out


def test_a_follower_lags_as_foretold(here: socket.socket) -> None:
    """On a ramp of held set points a follower is behind by v h / (1 - exp(-h / T)) in the end."""
    stream, constant = ramp(), 0.03
    controller = Controller(here.getsockname()[1], constant, 302)
    found = played_by(controller, stream, here)
    assert (found.why_not, found.lost, found.strangers) == ("", 0, 4)  # twice the noise and the copy
    assert [one.header.seqno for one in controller.answers][:3] == [0, 1, 2]
    (first, *others) = lags(stream, constant, found)
    assert first.ramp == pytest.approx(20 * constant)
    assert first.foretold == pytest.approx(20 * 4e-3 / (1 - np.exp(-4e-3 / constant)), rel=1e-6)
    assert first.measured == pytest.approx(first.foretold, rel=1e-9)
    assert first.constant == pytest.approx(constant, rel=1e-6)
    assert all((lag.foretold, lag.measured, lag.constant) == (0, 0, None) for lag in others)
    np.testing.assert_allclose(np.diff(found.t), 4e-3, atol=1e-12)  # though the clock of 32 bits ran over
    np.testing.assert_array_equal(found.u[:251], stream.q)
    assert found.x[-1, 0] == pytest.approx(stream.q[-1, 0], abs=0.02)
    rows = np.loadtxt(log_text(stream, found).splitlines(), delimiter=",", skiprows=1)
    np.testing.assert_allclose(rows, np.c_[found.t, found.x, found.u], rtol=1e-8, atol=1e-12)


def test_what_is_lost_is_counted_and_the_clock_goes_on(here: socket.socket) -> None:
    found = played_by(Controller(here.getsockname()[1], 0.03, 302, frozenset({50, 51, 200})), ramp(), here)
    assert (found.why_not, found.lost) == ("", 3)
    i = int(np.flatnonzero(found.t == 0.208)[0])
    assert found.t[i] - found.t[i - 1] == pytest.approx(0.012)
    assert found.u[i, 0] == pytest.approx(20 * 0.208)  # the set point of that time, not the next one in the row


def test_a_controller_that_stands_elsewhere_gets_no_answer(here: socket.socket) -> None:
    controller = Controller(here.getsockname()[1], 0.03, 1, x=12.0)
    found = played_by(controller, ramp(), here)
    assert found.why_not == "the controller's joint_1 is at 12 deg, the stream begins at 0"
    assert not len(found.t)
    assert controller.answers == []


def test_a_controller_that_stops_is_told(here: socket.socket) -> None:
    found = played_by(Controller(here.getsockname()[1], 0.03, 100), ramp(), here, silence=0.5)
    assert found.why_not == "no EgmRobot message came for 0.5 s, after 0.396 s of 1.000"
    assert len(found.t) == 100


def test_strangers_do_not_keep_it_waiting(here: socket.socket) -> None:
    until, to, over = time.monotonic() + 1.5, here.getsockname(), Event()

    def garbage() -> None:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as there:
            while time.monotonic() < until and not over.is_set():
                there.sendto(b"nothing of EGM", to)
                time.sleep(0.01)

    thread = Thread(target=garbage, daemon=True)
    thread.start()
    found = play(ramp(), here, 0.1, 0.3)
    assert time.monotonic() < until
    assert found.why_not == "no EgmRobot message came for 0.3 s"
    assert found.strangers > 0
    over.set()
    thread.join()


def test_fewer_axes_than_the_stream_has_are_refused(here: socket.socket) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as there:
        there.sendto(robot(1, 0, np.zeros(6)).SerializeToString(), here.getsockname())
        with pytest.raises(InputError, match="has 6 joints and 0 external axes, the stream 6 and 1"):
            play(ramp(), here, 0.1, 1.0)


def test_a_follower_is_the_exact_solution() -> None:
    """A step: x = 1 - exp(-t / T), whatever the steps."""
    t = np.cumsum(np.random.default_rng(3).uniform(1e-3, 2e-2, 60))
    u = np.ones((60, 1))
    u[0] = 0
    np.testing.assert_allclose(follower(t, u, 0.07)[1:, 0], 1 - np.exp(-(t[1:] - t[1]) / 0.07), atol=1e-12)


@pytest.mark.parametrize("text", ["192.168.125.1:6510", "0.0.0.0:6510", "robot:6510", "10.0.0.1:1", "[fe80::1]:6510"])
def test_only_the_loopback_is_answered(text: str) -> None:
    with pytest.raises(InputError, match=r"is not the loopback, and this player moves no machine"):
        address(text)


def test_addresses() -> None:
    assert address("localhost:6510") == address("127.0.0.1:6510") == ("127.0.0.1", 6510)
    assert address("127.1.2.3:0") == ("127.1.2.3", 0)
    assert address("[::1]:7") == ("::1", 7)
    for text in ("127.0.0.1", "127.0.0.1:x", "127.0.0.1:65536", "::1", ":", "127.0.0.1:²"):
        with pytest.raises(InputError, match="wanted HOST:PORT"):
            address(text)
