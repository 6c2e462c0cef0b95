"""Logs as people have them: heads, delimiters, units; and what is refused, in one line."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.limits import JointLimits
from trajopt_cli.measured.log_csv import lost_rows, read_log

NAMES = ("rail", "joint_1", "joint_2")
LIMITS = JointLimits(NAMES, np.array([0.0, -3, -3]), np.array([2.0, 3, 3]), np.ones(3), np.ones(3))
HEADS = "t [s],rail [m],joint_1 [rad],joint_2 [rad]"
T = 0.01 * np.arange(30)


def rows(
    factors: tuple[float, float, float, float] = (1, 1, 1, 1), delimiter: str = ",", point: str = "."
) -> list[str]:
    table = np.column_stack([T, 0.5 + T, T, 0.1 - T]) * factors
    return [delimiter.join(f"{value:.9g}".replace(".", point) for value in row) for row in table]


def written(path: Path, heads: str, lines: list[str]) -> Path:
    file = path / "log.csv"
    file.write_text("\n".join([heads, *lines]) + "\n", encoding="utf-8")
    return file


SECOND_HEADS = "t;ROB_1_J1 [deg];ROB_1_J2 [deg];ROB_2_J1 [rad];ROB_2_J2 [rad];rail [m]"
SECOND = [";".join([f"{t:.9g}", "77", "-7", f"{t:.9g}", f"{0.1 - t:.9g}", f"{0.5 + t:.9g}"]) for t in T]
DEGREES = (1e3, 1e3, 180 / np.pi, 180 / np.pi)


@pytest.mark.parametrize(
    ("heads", "lines", "units", "columns"),
    [
        (HEADS, rows(), None, None),
        ("\ufeff" + HEADS, [*rows(), ""], None, None),
        ("Time [ms];Rail [mm];J1 [deg];J2 [deg]", rows(DEGREES, ";", ","), None, None),
        ("Timestamp_ms\trail_mm\tAxis 1 (deg)\tRobot axis 2 [°]", rows(DEGREES, "\t"), None, None),
        ("time;rail;rax_1;rax_2", rows(DEGREES, ";"), "ms,deg,mm", None),
        ("A,B,C,D", rows(DEGREES), "ms,mm,deg", "time=A,rail=B,joint_1=C,joint_2=#4"),
        ("Time [s],E1 [mm],J1 [rad],Joint 2 [rad]", rows((1, 1e3, 1, 1)), None, None),
        ("# of cell 3\ntime,rail [m],joint_1 [rad],joint_2 [rad]", ["", *rows(), "# end"], None, None),
        (
            "% cell 3\n! x\nTime [\u00b5s],rail [m],J1 [rad],J2 [rad]",
            ["// on", *rows((1e6, 1, 1, 1)), " # off"],
            None,
            None,
        ),
        ("Time [\u03bcs],rail [m],J1 [rad],J2 [rad]", rows((1e6, 1, 1, 1)), None, None),
        (HEADS, [f"1764237000{row.partition(',')[0][1:]},{row.partition(',')[2]}" for row in rows()], None, None),
        (SECOND_HEADS, SECOND, None, "ROB_2"),
        ("ROB_2.t [s];J1 (ROB_1) [deg];J2;J1 ROB_2 [rad];J2 ROB_2 [rad];ROB_2/E1 [m]", SECOND, None, "rob_2"),
        ("t;J1 [deg];J2 [deg];J1 [rad];J2 [rad];rail [m]", SECOND, None, "joint_1=#4,joint_2=J2 [rad]"),
        (
            "time;rail [m];J1 [rad];J2 [rad]",
            [f"2026-01-01T10:00:0{row}" for row in rows((1, 1, 1, 1), ";", ",")],
            None,
            None,
        ),
    ],
)
def test_all_of_these_are_the_same_log(
    tmp_path: Path, heads: str, lines: list[str], units: str | None, columns: str | None
) -> None:
    log, _ = read_log(written(tmp_path, heads, lines), LIMITS, units, columns)
    assert log.names == NAMES
    assert log.t == pytest.approx(T, abs=1e-9)
    assert log.q == pytest.approx(np.column_stack([0.5 + T, T, 0.1 - T]), abs=1e-8)


def test_columns_in_any_order_and_others_between_are_told(tmp_path: Path) -> None:
    order = [3, 1, 0, 2]
    heads = np.array([*HEADS.split(",")])[order]
    lines = [",".join([*np.array(line.split(","))[order], "7"]) for line in rows()]
    log, unused = read_log(written(tmp_path, ",".join([*heads, "joint_1 speed [rad/s]"]), lines), LIMITS)
    assert unused == ("joint_1 speed [rad/s]",)
    assert log.q[:, 1] == pytest.approx(T, abs=1e-9)


def test_a_divider_may_end_lines_and_lines_end_in_cr(tmp_path: Path) -> None:
    file = written(tmp_path, "time;rail [m];J1 [rad];J2 [rad];", [f"{row};" for row in rows(delimiter=";")])
    file.write_bytes(file.read_bytes().replace(b"\n", b"\r"))
    log, unused = read_log(file, LIMITS)
    assert log.q == pytest.approx(np.column_stack([0.5 + T, T, 0.1 - T]), abs=1e-8)
    assert unused == ()


def changed(number: int, line: str) -> list[str]:
    return [*rows()[:number], line, *rows()[number + 1 :]]


@pytest.mark.parametrize(
    ("heads", "lines", "message"),
    [
        (HEADS, rows()[:1], "log.csv:2: 1 rows; a log needs at least 20"),
        (HEADS, [], "log.csv:1: 0 rows; a log needs at least 20"),
        (HEADS, changed(7, "0.07,0.5,nan,0"), "log.csv:9:10: 'nan' is not a finite number"),
        (HEADS, changed(7, "0.07,0.5,x,0"), "log.csv:9:10: 'x' is not a finite number"),
        (HEADS, changed(7, "0.07,0.5"), "log.csv:9: 2 values, the header has 4 columns"),
        (HEADS, changed(7, "0.07,0.5,0,0,1"), "log.csv:9: 5 values, the header has 4 columns"),
        (HEADS, ["\0"], "holds NUL bytes"),
        (HEADS, changed(7, "0.01,0.5,0,0"), "log.csv:9:1: time 0.01 s follows 0.06 s; times must increase"),
        (HEADS, changed(7, "0.06,0.5,0,0"), "log.csv:9:1: time 0.06 s follows"),
        (
            HEADS.replace("[rad]", "[furlong]"),
            rows(),
            "column 'joint_1 [furlong]' is joint_1 in 'furlong'; wanted one of rad",
        ),
        (HEADS.replace("[m]", "[deg]"), rows(), "column 'rail [deg]' is rail in 'deg'; wanted one of m, mm"),
        (
            HEADS.replace(" [m]", ""),
            rows(),
            "column 'rail' names no unit; write it into the head, or say it by --units mm",
        ),
        (HEADS.replace("rail", "gauge"), rows(), "no column is rail; the heads are"),
        (HEADS.replace("joint_2", "J1"), rows(), "'joint_1 [rad]' and 'J1 [rad]' could both be joint_1"),
        (HEADS, rows((1e3, 1, 1, 1)), "column 't [s]': a row every 10 s (the head says s)"),
        (HEADS, rows((1, 1, 1e3, 1)), "column 'joint_1 [rad]': joint_1 reaches 290 rad, its range is -3 to 3"),
        (HEADS, changed(7, "0.07,0.5,\uff11,0"), "log.csv:9:10: '\uff11' is not a finite number"),
        (HEADS, changed(7, "\u0660.07,0.5,1,0"), "log.csv:9:1: '\u0660.07' is not a finite number"),
        (HEADS, changed(7, "0.07,0.5,1_0,0"), "log.csv:9:10: '1_0' is not a finite number"),
        (HEADS, [f"17642370\u0660{i}.5,0.5,0,0" for i in range(30)], "log.csv:2:1: '17642370\u06600.5' is not"),
        (
            HEADS,
            [*rows()[:15], *(f"{t:.9g},0.5,0,{3 - 6 * (t < 0.2)}" for t in T[15:])],
            "log.csv:22: joint_2 jumps by 343.8",
        ),
        (SECOND_HEADS, SECOND, "no column is joint_1; the heads are 't', 'ROB_1_J1 [deg]', "),
        (SECOND_HEADS.replace("ROB_2_J1", "J1").replace("ROB_1_J1", "J1"), SECOND, "columns 'joint_1=J1 [deg]'"),
        (SECOND_HEADS.replace("ROB_2_J1 [rad]", "J1 [deg]").replace("ROB_1_J1", "J1"), SECOND, "columns 'joint_1=#2'"),
        (rows()[0], rows()[1:], "the first line holds numbers; say which column is which by --columns"),
        ("nothing", rows(), "the first line is 'nothing'; wanted heads"),
        ("", [], "the file is empty"),
    ],
)
def test_what_is_wrong_is_one_line_with_its_place(tmp_path: Path, heads: str, lines: list[str], message: str) -> None:
    with pytest.raises(InputError) as error:
        read_log(written(tmp_path, heads, lines), LIMITS)
    assert message in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("units", "columns", "message"),
    [
        ("furlong", None, "--units has 'furlong'; wanted one each of s|ms|us, rad|deg, m|mm"),
        (None, "ROB_1", "--columns has 'ROB_1'; wanted NAME=HEAD"),
        (None, "joint_9=A", "--columns has 'joint_9=A'; wanted NAME=HEAD"),
        (None, "joint_1=nowhere", "--columns: no columns are 'nowhere'"),
    ],
)
def test_options_that_say_nothing_are_refused(
    tmp_path: Path, units: str | None, columns: str | None, message: str
) -> None:
    with pytest.raises(InputError, match="^.*" + message.split("'")[0].replace("|", r"\|")):
        read_log(written(tmp_path, HEADS, rows()), LIMITS, units, columns)


def test_where_rows_were_lost_is_told_whether_they_are_even_or_not() -> None:
    even = 0.008 * np.arange(200)
    uneven = even + np.random.default_rng(3).uniform(-0.003, 0.003, 200)
    assert lost_rows(even) == lost_rows(uneven) == ""
    for t in (even, uneven):
        told = lost_rows(np.delete(t, slice(90, 105)))
        assert f"between t = {t[89]:.6g} and {t[105]:.6g} s" in told
