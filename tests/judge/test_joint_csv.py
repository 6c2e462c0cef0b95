"""Joint CSV: what is written is read back bit for bit; foreign units; and where a malformed file is wrong."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from io import StringIO

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from trajopt_cli import sheet
from trajopt_cli.errors import InputError
from trajopt_cli.joint_csv import header, read_csv_text, write_csv_text
from trajopt_cli.print_resolution import Digits
from trajopt_cli.sheet import missing_rows
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


@pytest.mark.parametrize("at_once", [1, 20, 10**6])
def test_digits_of_a_column_at_rest_are_told_of_all_its_rows(at_once: int) -> None:
    digits = Digits(30, 2)
    shown = [f"0.{201 + k}" if k < 10 or k >= 20 else "0.123456" for k in range(30)]
    for first in range(0, 30, at_once):
        rows = [f"{k}.5,{shown[k]}" for k in range(30)][first : first + at_once]
        digits.add(rows, np.array([row.split(",") for row in rows], dtype=float), first)
    times, column = digits.last()
    assert set(times.tolist()) == {1}
    assert column.tolist() == [3] * 10 + [6] * 10 + [3] * 10


@pytest.mark.parametrize("finer", ["0.50", "٠.٥٠"])
def test_digits_of_a_number_that_is_written_in_another_way_are_told(finer: str) -> None:
    digits = Digits(3, 2)
    digits.add(["1.5,+0.5", f"2.5,{finer}", f"3.5,{finer}"], np.array([[1.5, 0.5], [2.5, 0.5], [3.5, 0.5]]), 0)
    assert digits.last()[1].tolist() == [2, 2, 2]


def test_foreign_units_are_converted() -> None:
    head = "t [s],rail [mm],joint_1 [deg],rail speed [mm/s],joint_1 speed [deg/s]"
    text = head + "\r\n0,100.0,90.00,0,0\r\n0.5,50.0,-9.00,5,180\r\n"
    rows, resolution = read_csv_text(text, "a.csv")
    assert rows.q == pytest.approx(np.array([[0.1, np.pi / 2], [0.05, -np.pi / 20]]), abs=1e-15)
    assert rows.qd is not None
    assert rows.qd == pytest.approx(np.array([[0, 0], [0.005, np.pi]]), abs=1e-15)
    assert resolution.q == pytest.approx(np.array([[1e-4, np.radians(0.01)]]), rel=1e-12)
    assert resolution.qd == pytest.approx(np.array([[1e-3, np.radians(1)]]), rel=1e-12)


def test_a_file_that_is_read_in_parts_is_read_as_a_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(7)
    text = write_csv_text(Trajectory(NAMES, np.arange(9.0), rng.normal(size=(9, 3)).round(3)))
    whole, resolution = read_csv_text(text, "a.csv")
    for at_once in (1, 40, 100):
        monkeypatch.setattr(sheet, "_CHARACTERS", at_once)
        monkeypatch.setattr(sheet, "_ROWS", at_once // 20 + 1)
        assert write_csv_text(whole) == text
        for end in ("", "\n", " \n\r\n", "\n \n"):
            again = text.rstrip("\n") + end
            for source in (again, StringIO(again, newline="\n")):
                parts, fineness = read_csv_text(source, "a.csv")
                assert np.array_equal(parts.q, whole.q)
                assert np.array_equal(parts.t, whole.t)
                assert np.array_equal(fineness.t, resolution.t)
                assert np.array_equal(fineness.q, resolution.q)


def test_a_byte_order_mark_is_no_part_of_the_header() -> None:
    assert read_csv_text("\ufeff" + GOOD, "a.csv")[0].names == ("rail", "joint_1")


def steps(text: str) -> tuple[list[float], list[list[float]]]:
    """Printed steps of the times, and of every column of positions."""
    rows, resolution = read_csv_text(text, "a.csv")
    q = np.broadcast_to(resolution.q, rows.q.shape)
    return np.broadcast_to(resolution.t, rows.t.shape).tolist(), np.float64(q).T.tolist()


def column(spell: str, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Values as they are read back from one spelling, and their steps."""
    text = "t [s],joint_1 [rad]\n" + "".join(f"{i},{spell % x}\n" for i, x in enumerate(values))
    rows, resolution = read_csv_text(text, "a.csv")
    return rows.q[:, 0], np.broadcast_to(resolution.q, rows.q.shape)[:, 0]


@pytest.mark.parametrize("digits", [4, 5, 6, 9])
@pytest.mark.parametrize("style", ["g", "f", "e"])
@pytest.mark.parametrize("seed", range(4))
def test_every_value_is_within_half_its_step_and_no_step_is_wider_than_its_format(
    digits: int, style: str, seed: int
) -> None:
    """%.6g keeps six digits of any number, %.4f four decimals: known from the format, not from the reader."""
    rng = np.random.default_rng(seed)
    values = np.cumsum(rng.normal(size=400)) * 10.0 ** rng.uniform(-3, 1)
    found, step = column(f"%.{digits}{style}", values)
    assert (np.abs(found - values) <= step / 2 * (1 + 1e-6)).all()
    size = np.floor(np.log10(np.abs(values)))
    kept = digits - 1 if style == "g" else digits
    wanted = np.full(len(values), 10.0**-digits) if style == "f" else 10.0 ** (size - kept)
    # a rare power of ten with a handful of values may show fewer digits than its format has
    often = np.array([np.sum(size == one) >= 20 for one in size])
    assert (step[often] <= 1.001 * np.maximum(wanted[often], 1e-15)).all()


def test_one_fine_row_says_nothing_about_the_others() -> None:
    """A first row with all digits, as copied from a cell file, and a recorder's rows behind it."""
    rng = np.random.default_rng(5)
    values = np.round(0.5 + np.cumsum(rng.normal(size=100)) * 1e-3, 4)
    text = "t [s],joint_1 [rad]\n" + "".join(f"{i},{x:.4f}\n" for i, x in enumerate(values))
    exact = text.replace(f"\n0,{values[0]:.4f}", "\n0,0.52359877559829882")
    assert steps(exact)[1] == [pytest.approx([1e-15, *[1e-4] * 99], rel=1e-6)]


def test_a_value_that_ends_in_zeros_is_as_fine_as_its_neighbours() -> None:
    text = "t [s],joint_1 [rad]\n0,0.5\n1,0.51\n2,0.512\n3,0.5124\n4,0.51\n5,0\n"
    assert steps(text)[1] == [[pytest.approx(1e-4)] * 6]


def test_an_axis_at_rest_is_printed_like_the_others() -> None:
    """Its one zero, or its 0.5, says nothing about how finely it is printed; where it rests long, neither does that."""
    moving = [f"{0.1 + 0.0123 * i:.4f}" for i in range(20)]
    text = "t [s],rail [m],joint_1 [rad],joint_2 [rad]\n"
    text += "".join(f"{i},0.0,{x},0.5\n" for i, x in enumerate(moving))
    assert steps(text)[1] == [[pytest.approx(1e-4)] * 20] * 3
    resting = text + "".join(f"{i},0.0,0.3,0.5\n" for i in range(20, 200))
    assert steps(resting)[1] == [[pytest.approx(1e-4)] * 200] * 3


def test_times_on_a_grid_are_not_rounded() -> None:
    rows = "t [s],joint_1 [rad]\n" + "".join(f"{0.004 * i:.3f},{i}\n" for i in range(5))
    # where it begins and where it ends, a grid may be cut, also by less than is printed
    assert steps(rows)[0] == [1e-3, 0.0, 0.0, 0.0, 1e-3]
    assert steps(rows.replace("0.008", "0.009"))[0] == [1e-3] * 5
    assert steps(rows + "0.0171,5\n")[0] == [1e-4, *[0.0] * 4, 1e-4]
    assert steps(rows.replace("\n0.000,", "\n0.001,"))[0] == [1e-3, *[0.0] * 3, 1e-3]


def test_times_that_are_multiples_of_one_step_are_exact_also_where_rows_are_missing() -> None:
    lines = [f"{0.004 * i:.3f},{i}" for i in range(30)]
    head, ends = "t [s],joint_1 [rad]", (1e-3, *[0.0] * 26, 1e-3)
    assert steps("\n".join([head, *lines[:7], *lines[8:20], *lines[21:]]))[0] == list(ends)
    in_ms = "\n".join(["t [ms],joint_1 [rad]", *(f"{4 * i},{i}" for i in range(30) if i not in (7, 20))])
    assert steps(in_ms)[0] == list(ends)
    # rows every 1.06 ms, rounded to 1 ms, look the same: so these are not
    rounded = "\n".join([head, *(f"{0.00106 * i:.3f},{i}" for i in range(30))])
    assert steps(rounded)[0] == [1e-3] * 30
    # as is a row between those of a grid, wherever it stood
    between = "\n".join([head, *lines[:9], "0.034,8.5", *lines[9:]])
    assert steps(between)[0] == [1e-3] * 31


@pytest.mark.parametrize("digits", [7, 9, 12, 15])
def test_rows_between_those_of_a_grid_tell_the_digits_of_its_times(digits: int) -> None:
    """Rows every millisecond, which need three decimals, and at a few boundaries; one of them falls on the grid's
    digits. No time is off by more than half its step, and no step is wider than the format's."""
    rng = np.random.default_rng(digits)
    t = np.sort(np.r_[0.001 * np.arange(2, 12_000), rng.uniform(0.002, 12, 150), 3.0025000004, 10.123])
    t = np.delete(t, np.flatnonzero(np.diff(t) < 2e-5) + 1)
    text = "t [s],joint_1 [rad]\n" + "".join(f"{x:.{digits}g},{i}\n" for i, x in enumerate(t))
    rows, resolution = read_csv_text(text, "a.csv")
    step = np.broadcast_to(resolution.t, t.shape)
    assert (np.abs(rows.t - t) <= step / 2 * (1 + 1e-6) + 1e-15).all()
    size = np.floor(np.log10(t[1:-1]))
    assert (step[1:-1] <= 1.001 * np.maximum(10.0 ** (np.maximum(size, -1) - digits + 1), 1e-15)).all()


@pytest.mark.parametrize(("period", "spell"), [(0.00106, "{:.3f}"), (0.00137, "{:.5g}")])
def test_rows_that_were_rounded_are_no_grid_because_a_few_others_are_finer(period: float, spell: str) -> None:
    t = period * np.arange(9000)
    lines = [f"{spell.format(x)},{i}" for i, x in enumerate(t)]
    for i in (4000, 4001, 8500):
        lines[i] = f"{t[i]:.15g},{i}"
    rows, resolution = read_csv_text("t [s],joint_1 [rad]\n" + "\n".join(lines), "a.csv")
    assert (np.abs(rows.t - t) <= np.broadcast_to(resolution.t, t.shape) / 2 * (1 + 1e-6)).all()


def test_rows_that_an_even_file_lost_are_told_and_no_others() -> None:
    t = 0.012 * np.arange(40)
    assert missing_rows(t) == ""
    assert missing_rows(np.delete(t, 10)) == "1 of 40 rows are missing, between t = 0.108 and 0.132 s"
    two = missing_rows(np.delete(t, [10, 20, 21]))
    assert two == "3 of 40 rows are missing, between t = 0.108 and 0.132 s, t = 0.228 and 0.264 s"
    assert missing_rows(np.sort(np.r_[np.delete(t, 30), 0.1, 0.2, 0.3])) == ""  # a grid with rows in it
    assert missing_rows(np.cumsum(np.r_[t, 3 * t])) == ""
    rest = np.where(np.arange(38) == 9, 0.012, np.diff(np.delete(t, 10)))
    assert missing_rows(np.delete(t, 10), rest) == ""  # where nothing moves, no row is missed


PLAIN = ["t [s],rail [m],joint_1 [rad]", *(f"{0.004 * i:.3f},{0.5 + 0.01 * i:.2f},{-0.1 * i:.1f}" for i in range(30))]


def respelled(heads: str, time: Callable[[Decimal], str], divider: str = ",", point: str = ".") -> str:
    rows = [[time(Decimal(line.split(",")[0])), *line.split(",")[1:]] for line in PLAIN[1:]]
    return "\n".join([heads, *(divider.join(one.replace(".", point) for one in row) for row in rows)]) + "\n"


def iso(t: Decimal, zone: str = "") -> str:
    return (
        f"2026-12-31T23:59:59.{int(t * 1000) + 950:03}{zone}"
        if t < Decimal("0.05")
        else (f"2027-01-01T00:00:00.{int(t * 1000) - 50:03}{zone}")
    )


@pytest.mark.parametrize(
    "text",
    [
        "\ufeff" + "\r\n".join(PLAIN) + "\r\n\r\n",
        "# a log\n\n" + "\n".join([*PLAIN[:9], "", "# half", *PLAIN[9:], "# end"]),
        '"t [s]","rail [m]","joint_1 [rad]"\n' + "\n".join(PLAIN[1:]),
        respelled("time,rail [m],joint_1 [rad]", str),
        respelled("Time (s);E1 [m];J1 [rad]", str, ";", ","),
        respelled("t_ms\ttrack_m\tAxis 1 rad", lambda t: f"{t * 1000:.0f}", "\t"),
        respelled("timestamp [us],rail [m],joint_1 [rad]", lambda t: f"{t * 1000000:.0f}"),
        respelled("time,rail [m],joint_1 [rad]", lambda t: str(t + 1_700_000_000)),
        respelled("timestamp_ns,rail [m],joint_1 [rad]", lambda t: f"{(t + 1_700_000_000) * 10**9:.0f}"),
        respelled("time;rail [m];joint_1 [rad]", iso, ";", ","),
        respelled("time,rail [m],joint_1 [rad]", lambda t: iso(t, "+01:00")),
        respelled("timestamp [ms],rail [m],joint_1 [rad]", lambda t: iso(t).replace("T", " ")),
        respelled("clock;rail [m];joint_1 [rad]", lambda t: f"23:59:59.{int(t * 1000):03}", ";", ","),
    ],
)
def test_all_of_these_are_the_same_table(text: str) -> None:
    rows, resolution = read_csv_text(text, "a.csv")
    plain, its = read_csv_text("\n".join(PLAIN), "a.csv")
    assert rows.names == plain.names
    assert rows.t - rows.t[0] == pytest.approx(plain.t, abs=1e-15)
    assert np.array_equal(rows.q, plain.q)
    assert not np.asarray(resolution.t)[1:-1].any()
    assert np.broadcast_to(resolution.q, rows.q.shape) == pytest.approx(np.broadcast_to(its.q, rows.q.shape))


@pytest.mark.parametrize(
    ("text", "place", "said"),
    [
        (respelled("when;rail [m];joint_1 [rad]", str, ";", ","), (1, 1), "semicolons"),
        (respelled("t [s];rail [m];joint_1", str, ";", ","), (1, 16), "semicolons"),
        (respelled("t [min],rail [m],joint_1 [rad]", str), (1, 1), "'min'"),
        (respelled("t [s],time [ms],joint_1 [rad]", str), (1, 1), "'t [s]' and 'time [ms]'"),
        (respelled("time,rail [m],joint_1 [rad]", lambda t: f"{t * 1000:.0f}"), (1, None), "every 4 s"),
        ("# x\n" + "\n".join([*PLAIN[:9], *PLAIN[8:]]), (11, 1), "line 10"),
        ("# x\n\n" + "\n".join([*PLAIN[:9], PLAIN[4], *PLAIN[9:]]), (12, 1), "must increase"),
        (respelled("t [s];rail [m];joint_1 [rad]", str, ";", ",").replace("0,53", "O,53"), (5, 7), "'O.53'"),
        (respelled("time,rail [m],joint_1 [rad]", iso).replace("23:59:59.962", "23:59:69.962"), (5, 1), "23:59:69"),
        (respelled("t [s];rail;joint_1 [rad]", str, ";", ","), (1, 7), "'rail [mm]'"),
        ("\n".join(PLAIN[1:]), (1, None), "holds numbers"),
        (respelled("Zeit,rail [m],joint_1 [rad]", lambda t: f"04.03.2026 11:00:0{t:.3f}"), (2, 1), "2026-03-04 11"),
    ],
)
def test_what_is_not_understood_is_told_by_its_line(text: str, place: tuple[int, int | None], said: str) -> None:
    with pytest.raises(InputError) as caught:
        read_csv_text(text, "a.csv")
    assert (caught.value.line, caught.value.column) == place
    assert said in str(caught.value)


def test_a_divider_may_end_the_heads_and_the_rows() -> None:
    ended = read_csv_text("\n".join(f"{line}," for line in PLAIN), "a.csv")[0]
    assert np.array_equal(ended.q, read_csv_text("\n".join(PLAIN), "a.csv")[0].q)


def test_a_column_of_zeros_of_both_signs_is_printed_like_the_others() -> None:
    """As axes are that stand while others move: -0 and 0 say nothing of digits."""
    text = "t [s],joint_1 [rad],joint_2 [rad]\n"
    text += "".join(f"{0.004 * i:.17g},{-0.0 if i % 2 else 0.0:.17g},{i / 3:.17g}\n" for i in range(40))
    assert max(one.max() for one in (read_csv_text(text, "a.csv")[1].q,)) <= 1e-14


def test_times_that_are_printed_alike_ask_for_more_digits() -> None:
    text = "t [s],joint_1 [rad]\n" + "".join(f"{99.95 + 0.02 * i:.4g},{i}\n" for i in range(9))
    with pytest.raises(InputError, match=r"^a.csv:6:1: time 100.0 s follows 100.0 s; .* print more digits of them$"):
        read_csv_text(text, "a.csv")


GOOD = "t [s],rail [m],joint_1 [rad]\n0,0,0\n0.1,0.5,1\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "a.csv: the file is empty; its first line must be the header t [s],<axis> [unit],..."),
        (
            GOOD.replace("t [s]", "when"),
            "a.csv:1:1: no column is the time, 't [s]'; the first column is 'when'",
        ),
        (
            GOOD.replace("joint_1 [rad]", "joint_1 [grad]"),
            "a.csv:1:16: unknown column 'joint_1 [grad]'; wanted '<axis> [m|mm|rad|deg]' for every axis, then all or "
            "none of '<axis> speed [unit/s]' in that order",
        ),
        (
            GOOD.replace("joint_1 [rad]", "eax_b [mm]"),
            "a.csv:1:16: column 'eax_b [mm]' is of an axis that turns; wanted its values in rad or deg",
        ),
        (GOOD.replace("joint_1", "rail"), "a.csv:1: axes are 'rail, rail'; wanted each axis once"),
        (
            "t [s],rail [m],joint_1 [rad],rail speed [m/s]\n0,0,0,0\n1,0,0,0\n",
            "a.csv:1: the speed of joint_1 is missing: give speeds of all axes or of none",
        ),
        (GOOD + "0.2,0.5\n", "a.csv:4: 2 values, the header has 3 columns"),
        (GOOD + "0.2,0.5,inf\n", "a.csv:4:9: 'inf' is not a finite number"),
        (GOOD + "0.2,x,1\n", "a.csv:4:5: 'x' is not a finite number"),
        (GOOD + "0.2,1e10,1\n",
         "a.csv:4:5: '1e10' is no time, position or speed of a robot: at most 1e+09 in s, m or rad"),
        (GOOD + "0.1000000000001,0,1\n",
         "a.csv:4:1: times 1e-13 s apart, at 0.1 s; rows are 1e-09 s apart at least: see their unit"),
        (GOOD + "0.0625,0.5,1\n", "a.csv:4:1: time 0.0625 s follows 0.1 s; times must increase"),
        (GOOD[:35], "a.csv:2: 1 rows; a motion needs at least 2"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("at_once", [1, 20, 10**6])
def test_a_malformed_file_is_one_line_with_its_place(
    text: str, message: str, at_once: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sheet, "_CHARACTERS", at_once)
    with pytest.raises(InputError) as caught:
        read_csv_text(text, "a.csv")
    assert str(caught.value) == message
