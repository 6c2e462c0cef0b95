"""`trajopt estimate` and `trajopt identify` as people type them: a cycle beside its log, and beside another one."""

from __future__ import annotations

import json
import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from small_cells import plant_without_rail

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.cli import run
from trajopt_cli.motion import Source
from trajopt_cli.study.estimate import EstimatedMotion, _rests_on

TEXT = """MODULE Tiny
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_side:=[[40,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_up:=[[40,-20,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveAbsJ j_side, vmax, fine, tool0;
        WaitTime 0.5;
        MoveAbsJ j_up, vmax, fine, tool0;
        MoveAbsJ j_home, vmax, fine, tool0;
    ENDPROC
ENDMODULE
"""
SIDE, UP = np.radians(40), np.radians(20)


@pytest.fixture
def tiny(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("tiny.mod").write_text(TEXT)
    Path("tiny.yaml").write_text(
        'robot: irb140\nfree_speed: true\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\n'
        "tcp: {speed: 9, acceleration: 90, source: a test}\nsettle: 0\n"
        'limits: {joint_1: {acceleration: 10, source: "measured in spring"}}\n'
    )
    return Path("tiny.mod")


def trapezoid(t: np.ndarray, way: float, v: float, a: float) -> np.ndarray:
    v = min(v, np.sqrt(way * a))
    T, ramp = way / v + v / a, v / a
    t = np.clip(t, 0, T)
    return np.where(t < ramp, a * t**2 / 2, np.where(t < T - ramp, v * (t - ramp / 2), way - a * (T - t) ** 2 / 2))


def times(way: float, v: float, a: float) -> float:
    v = min(v, np.sqrt(way * a))
    return way / v + v / a


def log(
    a_1: float, wait: float, period: float = 0.02, lag: float = 0.03, part: tuple[float, float] | None = None
) -> tuple[str, list[float]]:
    """A log of the program: joint 1 at a_1 [rad/s2], another wait; and how long each motion takes. It rests before and
    after; with part it is the part of a production without rests at home, in cycles."""
    v, a_2 = np.radians(200), 15.0
    T = [times(SIDE, v, a_1), wait, times(UP, v, a_2), times(SIDE, v, a_1)]
    ends = (0 if part else 1 + lag) + np.cumsum([0, *T])
    t = np.arange(0, ends[-1] + 1, period) if part is None else np.arange(part[0] * sum(T), part[1] * sum(T), period)
    now = t if part is None else np.mod(t, sum(T))
    q = np.zeros((len(t), 6))
    q[:, 4] = np.radians(30)
    q[:, 0] = trapezoid(now - ends[0], SIDE, v, a_1) - trapezoid(now - ends[3], SIDE, v, a_1)
    back = UP / SIDE  # coordinated: joint 2 shares joint 1's progress on the way home
    q[:, 1] = -trapezoid(now - ends[2], UP, v, a_2) + back * trapezoid(now - ends[3], SIDE, v, a_1)
    rows = [
        ";".join([f"{1e3 * now:.0f}", *(f"{x:.3f}" for x in np.degrees(row))]) for now, row in zip(t, q, strict=True)
    ]
    return "\n".join(["Time [ms];" + ";".join(f"J{i} [deg]" for i in range(1, 7)), *rows]) + "\n", T


def answer(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict:
    capsys.readouterr()
    assert run([*arguments, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_cycle_naive_figure_waits_and_guesses(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    told = answer(capsys, "estimate", str(tiny))
    v = np.radians(200)
    wanted = [times(SIDE, v, 10), 0.5, times(UP, v, 15), times(SIDE, v, 10)]
    assert [one["predicted_s"] for one in told["motions"]] == pytest.approx(wanted, abs=2e-3)
    assert told["cycle_time_s"] == pytest.approx(sum(wanted), abs=5e-3)
    ends = [sum(wanted) - wanted[2] + times(UP, v, share * 15) for share in (2.5, 0.6)]
    assert told["uncertainty"]["cycle_time_range_s"]["as_written"] == pytest.approx(
        ends, abs=5e-3
    )  # joint_1 was measured, joint_2 is of grade D
    assert [one["shares"]["joint_2"] for one in told["uncertainty"]["guesses"]] == [[0.6, 2.5]]
    assert told["waits_s"] == pytest.approx(0.5)
    assert told["length_over_speed_s"] < told["motion_s"]
    assert told["calibrated"] is False
    assert told["calibration"].startswith("uncalibrated")
    rests = {one["limit"]: one for one in told["rests_on"]}
    assert rests["joint_2 acceleration"]["guess"]  # grade D of the robot's profile
    assert not rests["joint_1 acceleration"]["guess"]
    assert rests["joint_1 acceleration"]["source"] == "measured in spring"
    assert run(["estimate", str(tiny)]) == 0
    out = capsys.readouterr().out
    assert "guesses: joint_2 acceleration 15 rad/s²" in out
    assert "uncalibrated" in out


def test_a_move_whose_tool_rests_for_a_time_is_a_wait(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    r"""As an exported program has it where the rail moves in a wait: to where the tool stands, in \T."""
    before = answer(capsys, "estimate", str(tiny))
    home = "MoveAbsJ j_home, vmax, fine, tool0;"
    tiny.write_text(tiny.read_text().replace(home, home + home.replace(", vmax", r"\NoEOffs, vmax\T:=0.25")))
    told = answer(capsys, "estimate", str(tiny))
    assert told["waits_s"] == pytest.approx(before["waits_s"] + 0.25)
    assert told["motion_s"] == pytest.approx(before["motion_s"])


def test_no_limit_holds_a_wait_back() -> None:
    motions = [EstimatedMotion(i, Source("a.mod", i, 1), wait, 0.1, 0.5, "joint_1 acceleration")
               for i, wait in enumerate([False, True])]  # fmt: skip
    (one,) = _rests_on(SimpleNamespace(plant=plant_without_rail()), motions)  # type: ignore[arg-type]
    assert one.seconds == 0.5


def test_waits_are_told_by_their_instruction_and_what_they_wait_for(
    tiny: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    waits = ["WaitDI di1, 1;", "Stop;", "SyncMoveOn s1, both;", "SyncMoveOff s2;", "waitsynctask\\InPos, s3, both;"]
    data = "".join(f"VAR syncident s{i};" for i in (1, 2, 3)) + 'PERS tasks both{2}:=[["T_1"],["T_2"]];'
    text = tiny.read_text().replace("WaitTime 0.5;", "".join(waits)).replace("MODULE Tiny", f"MODULE Tiny\n{data}")
    tiny.write_text(text)
    named = [("WaitDI", "di1 = 1"), ("Stop", ""), ("SyncMoveOn", "s1"), ("SyncMoveOff", "s2"), ("waitsynctask", "s3")]
    told = [one for one in answer(capsys, "estimate", str(tiny))["motions"] if one["wait"]]
    assert [(one["instruction"], one["target"]) for one in told] == named
    assert run(["parse", str(tiny)]) == 0
    lines = [line.split("at least")[0].split() for line in capsys.readouterr().out.splitlines() if "at least" in line]
    assert [(line[1], " ".join(line[2:])) for line in lines] == named


@pytest.mark.parametrize("period", [0.004, 0.02, 0.1])
def test_a_log_gives_every_motion_its_measured_time(
    tiny: Path, capsys: pytest.CaptureFixture[str], period: float
) -> None:
    text, T = log(7.0, 0.8, period)
    Path("log.csv").write_text(text)
    told = answer(capsys, "estimate", str(tiny), "--log", "log.csv")
    near = 0.01 if period < 0.05 else 0.05
    assert [one["measured_s"] for one in told["motions"]] == pytest.approx(T, abs=near)
    assert told["log"]["cycle_s"] == pytest.approx(sum(T), abs=near)
    assert told["calibrated"] is True
    assert told["calibration"].startswith("compared with log.csv")


def test_what_axes_stand_longer_than_a_programmed_wait_is_settling(
    tiny: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cell, program = Path("tiny.yaml"), tiny.read_text()
    cell.write_text(cell.read_text().replace("settle: 0", "settle: {fine: 0.2, inpos: 0.1}"))
    Path("log.csv").write_text(log(10.0, 0.8, 0.004)[0])  # stands 0.3 s longer than the 0.5 s of WaitTime
    told = answer(capsys, "estimate", str(tiny), "--log", "log.csv")
    assert told["settling"] == {"stops": 1, "each_s": [0.2], "seconds": 0.2, "source": "settle of tiny.yaml"}
    assert told["waits_s"] == pytest.approx(0.5)
    assert told["log"]["predicted_s"] == pytest.approx(told["cycle_time_s"])
    (seen,) = told["settling_seen"]
    assert (seen["kind"], seen["stops"], seen["predicted"]) == ("fine", 1, pytest.approx(0.2))
    assert seen["seconds"] == pytest.approx(0.3, abs=0.01)
    wait = next(one for one in told["motions"] if one["wait"])
    assert wait["measured_s"] == pytest.approx(0.5)  # the rest is settling
    assert run(["estimate", str(tiny), "--log", "log.csv"]) == 0
    out = capsys.readouterr().out
    row = next(line.split() for line in out.splitlines() if line.startswith("settling"))
    assert [float(cell) for cell in row[-3:]] == pytest.approx([0.2, 0.3, 0.1], abs=0.01)
    (key,) = re.findall(r"for the cell file: '(settle: .*)'", out)
    found = parse_cell(f"{cell.read_text().split('settle')[0]}{key}\n", "tiny.yaml")
    assert found.settle[0] == pytest.approx(seen["seconds"], abs=6e-4)
    # what a signal lets wait is not known, and tells nothing
    tiny.write_text(program.replace("WaitTime 0.5", "WaitDI di1, 1"))
    assert answer(capsys, "estimate", str(tiny), "--log", "log.csv")["settling_seen"] == []
    tiny.write_text(program.replace("vmax, fine, tool0;", r"vmax, fine\Inpos:=inpos20, tool0;", 1))
    (seen,) = answer(capsys, "estimate", str(tiny), "--log", "log.csv")["settling_seen"]
    assert (seen["kind"], seen["predicted"]) == ("inpos", pytest.approx(0.1))


ENDLESS = ("PROC main()", "PROC main()\nWHILE TRUE DO"), ("ENDPROC", "ENDWHILE\nENDPROC")


@pytest.mark.parametrize("endless", [False, True])
@pytest.mark.parametrize(
    ("part", "passes", "held"),
    [
        ((0.0, 1.0), 1, 4),
        ((0.0, 4.0), 4, 4),
        ((0.6, 3.4), 2, 4),  # what is before and behind whole ones does not count
        ((0.6, 1.4), 0, 3),  # the end of one cycle and the begin of the next: all but the wait
        ((0.3, 0.95), 0, 1),  # from the wait on, not to the end
    ],
)
def test_a_log_of_production_holds_passes_and_parts(
    tiny: Path, capsys: pytest.CaptureFixture[str], endless: bool, part: tuple[float, float], passes: int, held: int
) -> None:
    text, T = log(7.0, 0.8, 0.008, part=part)
    Path("log.csv").write_text(text)
    if endless:
        tiny.write_text(TEXT.replace(*ENDLESS[0]).replace(*ENDLESS[1]))
    told = answer(capsys, "estimate", str(tiny), "--log", "log.csv")
    measured = {i: one["measured_s"] for i, one in enumerate(told["motions"]) if "measured_s" in one}
    assert len(measured) == held
    assert [*measured.values()] == pytest.approx([T[i] for i in measured], abs=0.01)
    assert sum(one["whole"] for one in told["log"]["passes"]) == passes
    assert told["log"]["whole"] is (passes > 0)
    assert told["log"]["cycle_s"] == pytest.approx(sum(T[i] for i in measured), abs=0.01)
    assert told["log"]["period_s"] == (pytest.approx(sum(T), abs=0.01) if passes > 1 else None)


def test_the_start_of_the_cell_file_may_be_none_of_the_log(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cell = Path("tiny.yaml")
    cell.write_text(cell.read_text().replace("[0, 0, 0, 0, 30, 0]", "[0, 20, 0, 0, 30, 0]"))
    text, T = log(7.0, 0.8, part=(0.0, 3.0))
    Path("log.csv").write_text(text)
    told = answer(capsys, "estimate", str(tiny), "--log", "log.csv")
    assert len(told["log"]["passes"]) == 3
    wanted = [None, None, *(pytest.approx(one, abs=0.01) for one in T[2:])]
    assert [one.get("measured_s") for one in told["motions"]] == wanted


def test_all_logs_of_a_folder_are_one_table(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With what is wrong with the others, and exit code 2 for those."""
    Path("logs").mkdir()
    for name, slow in (("a", 1.0), ("b", 1.3)):
        heads, *lines = log(10.0, 0.8)[0].splitlines()
        rows = [f"{float(line.partition(';')[0]) * slow:.1f};{line.partition(';')[2]}" for line in lines]
        Path("logs", f"{name}.csv").write_text("\n".join([heads, *rows]))
    told = answer(capsys, "estimate", str(tiny), "--log", "logs")
    T = sum(log(10.0, 0.8)[1])
    assert [one["cycle_s"] for one in told["logs"]] == pytest.approx([T, 1.3 * T], abs=0.02)
    assert told["refused"] == []
    assert [one.split(":")[0] for one in told["contradictions"]] == ["logs/b.csv"]  # all alike slower
    Path("logs", "C.CSV").write_text("nothing\n1\n")
    Path("logs", "notes.txt").write_text("no log")
    Path("logs", ".a.csv").write_text("no log")
    assert "--columns" in refusal(capsys, "estimate", str(tiny), "--log", "logs", "--columns", "ROB_1")  # once for all
    assert run(["estimate", str(tiny), "--log", "logs"]) == 2
    captured = capsys.readouterr()
    assert captured.err.startswith("logs/C.CSV:1:")
    assert captured.err.count("\n") == 1
    cells = [line.split() for line in captured.out.splitlines() if line.split()[:1] in (["a.csv"], ["b.csv"])]
    assert [(name, passes) for name, passes, *_ in cells] == [("a.csv", "1"), ("b.csv", "1")]
    assert run(["identify", "logs", "--cell", "tiny.yaml"]) == 2
    Path("logs", "C.CSV").unlink()
    capsys.readouterr()
    assert run(["identify", "logs", "--cell", "tiny.yaml"]) == 0
    assert "b.csv: " in capsys.readouterr().out
    Path("none").mkdir()
    assert "none: " in refusal(capsys, "estimate", str(tiny), "--log", "none")
    assert "nowhere: " in refusal(capsys, "estimate", str(tiny), "--log", "nowhere")


def test_a_log_beyond_the_limits_in_force_is_told(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("log.csv").write_text(log(13.0, 0.8, 0.004)[0])
    told = answer(capsys, "estimate", str(tiny), "--log", "log.csv")
    (said,) = told["contradictions"]
    assert said.startswith("joint_1 reached")
    reached = {(one["axis"], one["kind"]): one["value"] for one in told["reached"]}
    assert reached["joint_1", "acceleration"] == pytest.approx(13.0, rel=0.05)
    cell = Path("tiny.yaml")
    cell.write_text(cell.read_text().replace("speed: 9,", "speed: 0.6,"))  # the flange goes around at more than 1 m/s
    run(["estimate", str(tiny), "--log", "log.csv"])
    out = capsys.readouterr().out
    assert said in out
    assert "the tool centre point reached" in out


def refusal(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    capsys.readouterr()
    assert run([*arguments]) == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 1
    return err


def test_a_log_of_something_else_is_told_with_where_it_departs(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text, _ = log(7.0, 0.8)
    heads, *lines = text.splitlines()
    swapped = heads.replace("J2", "J9").replace("J3", "J2").replace("J9", "J3")
    Path("log.csv").write_text("\n".join([swapped, *lines]) + "\n")
    err = refusal(capsys, "estimate", str(tiny), "--log", "log.csv")
    assert "departs from the program at MoveAbsJ j_up (tiny.mod:9" in err
    assert "joint_2 stays 20.00° away" in err
    shifted = [";".join([t, f"{float(q) + 10:.3f}", *rest]) for t, q, *rest in (line.split(";") for line in lines)]
    Path("log.csv").write_text("\n".join([heads, *shifted]) + "\n")
    assert "the log never is where the program starts: joint_1" in refusal(
        capsys, "estimate", str(tiny), "--log", "log.csv"
    )
    back = [f"{20 * i};{one.partition(';')[2]}" for i, one in enumerate([*lines[:100], *lines[100::-1], *lines[:9]])]
    Path("log.csv").write_text("\n".join([heads, *back]) + "\n")  # turns back on the way
    assert "tiny.mod:9" in refusal(capsys, "estimate", str(tiny), "--log", "log.csv")


def test_rows_that_a_log_lost_are_told(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    heads, *lines = log(7.0, 0.8)[0].splitlines()
    t = [float(line.split(";")[0]) / 1000 for line in lines[9:12]]
    Path("log.csv").write_text("\n".join([heads, *lines[:10], *lines[11:]]) + "\n")
    for command in (["estimate", str(tiny), "--log", "log.csv"], ["identify", "log.csv", "--cell", "tiny.yaml"]):
        run(command)
        said = " ".join(capsys.readouterr().out.split())
        assert f"log.csv: 1 of {len(lines)} rows are missing, between t = {t[0]:.6g} and {t[2]:.6g} s" in said


def test_a_log_at_rest_shows_no_limit_and_nothing_is_written(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text, _ = log(7.0, 0.8)
    heads, first, *lines = text.splitlines()
    still = [f"{line.partition(';')[0]};{first.partition(';')[2]}" for line in lines]
    Path("log.csv").write_text("\n".join([heads, *still]) + "\n")
    assert run(["identify", "log.csv", "--cell", "tiny.yaml", "--output", "limits.yaml"]) == 1
    captured = capsys.readouterr()
    assert "NOTHING WRITTEN" in captured.err
    assert captured.out.count("it does not move in a motion that could be fitted") == 18  # three limits of six axes
    assert not Path("limits.yaml").exists()
