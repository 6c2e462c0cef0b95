"""Joint CSV: what is written is read back bit for bit; foreign units; and where a malformed file is wrong."""

from __future__ import annotations

from io import StringIO

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from trajopt_cli import joint_csv
from trajopt_cli.errors import InputError
from trajopt_cli.joint_csv import header, read_csv_text, write_csv_text
from trajopt_cli.trajectory import Trajectory

NAMES = ("rail", "joint_1", "joint_2")


def test_the_header_carries_the_units() -> None:
    assert ",".join(header(NAMES, True)) == (
        "t [s],rail [m],joint_1 [rad],joint_2 [rad],rail speed [m/s],joint_1 speed [rad/s],joint_2 speed [rad/s]"
    )
    assert header(("joint_1",), False) == ["t [s]", "joint_1 [rad]"]


@given(arrays(np.float64, (4, 6), elements=st.floats(-1e3, 1e3)), st.booleans())
def test_written_numbers_come_back_bit_for_bit(values: np.ndarray, speeds: bool) -> None:
    written = Trajectory(NAMES, np.array([0, 0.1, 1 / 3, 7.0]), values[:, :3], values[:, 3:] if speeds else None)
    read, _ = read_csv_text(write_csv_text(written), "a.csv")
    assert read.names == NAMES
    assert np.array_equal(read.t, written.t)
    assert np.array_equal(read.q, written.q)
    assert (read.qd is None) == (not speeds)
    if read.qd is not None:
        assert np.array_equal(read.qd, values[:, 3:])


def test_foreign_units_are_converted() -> None:
    head = "t [s],rail [mm],joint_1 [deg],rail speed [mm/s],joint_1 speed [deg/s]"
    text = head + "\r\n0,100.0,90.00,0,0\r\n0.5,50.0,-9.00,5,180\r\n"
    rows, resolution = read_csv_text(text, "a.csv")
    assert rows.q == pytest.approx(np.array([[0.1, np.pi / 2], [0.05, -np.pi / 20]]), abs=1e-15)
    assert rows.qd is not None
    assert rows.qd == pytest.approx(np.array([[0, 0], [0.005, np.pi]]), abs=1e-15)
    assert resolution.q == pytest.approx([1e-4, np.radians(0.01)], rel=1e-12)
    assert resolution.qd == pytest.approx([1e-3, np.radians(1)], rel=1e-12)


def test_a_file_that_is_read_in_parts_is_read_as_a_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(7)
    text = write_csv_text(Trajectory(NAMES, np.arange(9.0), rng.normal(size=(9, 3)).round(3)))
    whole, resolution = read_csv_text(text, "a.csv")
    for at_once in (1, 40, 100):
        monkeypatch.setattr(joint_csv, "_CHARACTERS", at_once)
        monkeypatch.setattr(joint_csv, "_ROWS", at_once // 20 + 1)
        assert write_csv_text(whole) == text
        for end in ("", "\n", " \n\r\n", "\n \n"):
            again = text.rstrip("\n") + end
            for source in (again, StringIO(again, newline="\n")):
                parts, fineness = read_csv_text(source, "a.csv")
                assert np.array_equal(parts.q, whole.q)
                assert np.array_equal(parts.t, whole.t)
                assert (fineness.t, *fineness.q) == (resolution.t, *resolution.q)


def test_a_byte_order_mark_is_no_part_of_the_header() -> None:
    assert read_csv_text("\ufeff" + GOOD, "a.csv")[0].names == ("rail", "joint_1")


def test_resolution_is_that_of_the_finest_digit() -> None:
    text = "t [s],rail [m],joint_1 [rad],joint_2 [rad]\n"
    text += "0.0,0.0,0.12,1e-3\n0.013,0.0,0.125,2.5e-4\n0.02,0.0,0.2,1\n0.03,0.0,0.2,1\n"
    _, resolution = read_csv_text(text, "a.csv")
    assert resolution.t == 1e-3
    # the rail stands still: its one zero says nothing about how finely it is printed
    assert resolution.q == pytest.approx([1e-5, 1e-3, 1e-5])


def test_times_on_a_grid_are_not_rounded() -> None:
    rows = "t [s],joint_1 [rad]\n" + "".join(f"{0.004 * i:.3f},{i}\n" for i in range(5))
    assert read_csv_text(rows, "a.csv")[1].t == 0.0
    assert read_csv_text(rows.replace("0.008", "0.009"), "a.csv")[1].t == 1e-3
    assert read_csv_text(rows + "0.0171,5\n", "a.csv")[1].t == 1e-4


GOOD = "t [s],rail [m],joint_1 [rad]\n0,0,0\n0.1,0.5,1\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "a.csv: the file is empty; its first line must be the header t [s],<axis> [unit],..."),
        (GOOD.replace("t [s]", "time"), "a.csv:1:1: the first column is 'time', wanted 't [s]'"),
        (
            GOOD.replace("joint_1 [rad]", "joint_1 [grad]"),
            "a.csv:1:16: unknown column 'joint_1 [grad]'; wanted '<axis> [m|mm|rad|deg]' for every axis, then all or "
            "none of '<axis> speed [unit/s]' in that order",
        ),
        (GOOD.replace("joint_1", "rail"), "a.csv:1: axes are 'rail, rail'; wanted each axis once"),
        (
            "t [s],rail [m],joint_1 [rad],rail speed [m/s]\n0,0,0,0\n1,0,0,0\n",
            "a.csv:1: the speed of joint_1 is missing: give speeds of all axes or of none",
        ),
        (GOOD + "0.2,0.5\n", "a.csv:4: 2 values, the header has 3 columns"),
        (GOOD + "0.2,0.5,inf\n", "a.csv:4:9: 'inf' is not a finite number"),
        (GOOD + "0.2,x,1\n", "a.csv:4:5: 'x' is not a finite number"),
        (GOOD + "0.0625,0.5,1\n", "a.csv:4:1: time 0.0625 s follows 0.10000000000000001 s; times must increase"),
        (GOOD[:35], "a.csv:2: 1 rows; a motion needs at least 2"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("at_once", [1, 20, 10**6])
def test_a_malformed_file_is_one_line_with_its_place(
    text: str, message: str, at_once: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(joint_csv, "_CHARACTERS", at_once)
    with pytest.raises(InputError) as caught:
        read_csv_text(text, "a.csv")
    assert str(caught.value) == message
