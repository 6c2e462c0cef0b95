"""Every command as a person uses it: what it prints, what it writes, how it ends."""

from __future__ import annotations

import csv
import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, get_args, get_type_hints

import numpy as np
import pytest
from fake_planner import ACCELERATION, CELL, TEXT, Planner

from trajopt_cli import cli
from trajopt_cli.cli import run
from trajopt_cli.cli.optimize import optimize
from trajopt_cli.errors import InputError
from trajopt_cli.job import read_job
from trajopt_cli.joint_csv import read_csv_text
from trajopt_cli.motion import Source
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.study.case import Case
from trajopt_cli.study.table import BASELINES, SAMPLED

REPOSITORY = Path(__file__).parents[2]
FILES = {
    "run.json",
    "summary.json",
    "report.html",
    "trajectory.csv",
    "stream.csv",
    "rapid.csv",
    "program.mod",
    "input/tiny.mod",
    "input/tiny.yaml",
}
CYCLE = {one: 4 * np.sqrt(np.radians(20) / a) + 0.5 for one, a in ACCELERATION.items()}


def content(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def without_clock(files: dict[str, bytes]) -> dict[str, bytes]:
    record = json.loads(files["run.json"])
    for key in ("started", "finished", "seconds"):
        del record[key]
    return files | {"run.json": json.dumps(record).encode()}


def test_optimize_writes_both_targets_and_says_so(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program)]) == 0
    files = content(Path("results/tiny"))
    assert set(files) == FILES
    assert files["trajectory.csv"] == files["stream.csv"] != files["rapid.csv"]
    assert files["input/tiny.mod"].decode() == TEXT
    summary = json.loads(files["summary.json"])
    for one in Target:
        assert summary["plans"][one]["cycle_time_s"] == pytest.approx(CYCLE[one], abs=1e-9)
        assert summary["plans"][one]["judge"]["legal"] is True
        times = [motion["time_s"] for motion in summary["plans"][one]["motions"]]
        assert sum(times) == pytest.approx(CYCLE[one], abs=1e-9)
    out = capsys.readouterr().out
    for line in (5, 6, 7):
        assert re.search(rf"^ *tiny\.mod:{line + 1} +\w+", out, re.MULTILINE), out
    assert (
        f"stream: T = {CYCLE[Target.STREAM]:.3f} s (lower bound {0.9 * CYCLE[Target.STREAM]:.3f} s, gap 11.1 %)" in out
    )
    assert f"rapid: T = {CYCLE[Target.RAPID]:.3f} s" in out
    assert "limits: accelerations of joint_1, joint_2" in out
    assert "written to results/tiny: program.mod (the rapid plan), report.html (open it in a browser), " in out
    assert "trajectory.csv (the stream plan)" in out
    assert out.splitlines()[1] == "legal; obstacles not checked: the cell file gives none"


def test_target_chooses_whose_plan_trajectory_csv_carries(program: Path, planner: Planner) -> None:
    assert run(["optimize", str(program), "--target", "rapid", "--output", "out"]) == 0
    files = content(Path("out"))
    assert files["trajectory.csv"] == files["rapid.csv"] != files["stream.csv"]
    assert json.loads(files["summary.json"])["target"] == "rapid"


def test_the_same_inputs_give_the_same_bytes(program: Path, planner: Planner) -> None:
    """Whether one process plans or two."""
    assert run(["optimize", str(program), "--output", "one", "--jobs", "1"]) == 0
    assert run(["optimize", str(program), "--output", "two", "--jobs", "2"]) == 0
    one, two = content(Path("one")), content(Path("two"))
    assert without_clock(one) == without_clock(two)


def test_run_json_names_versions_inputs_and_files(program: Path, results: Path) -> None:
    record = json.loads(Path("results/tiny/run.json").read_text())
    assert set(record["versions"]) == {"python", "casadi", "numpy", "pin", "ruckig", "scipy", "toppra"}
    assert set(record["files"]) == FILES - {"run.json"}
    assert [one["path"] for one in record["inputs"]["files"]] == ["tiny.mod", "tiny.yaml"]
    assert record["options"] == {
        "program": ["tiny.mod"],
        "cell": "tiny.yaml",
        "entry": "main",
        "assume_identity": [],
        "target": "stream",
        "loops": "keep",
        "cycle_time": None,
    }


def test_progress_in_a_log_is_a_line_when_something_changed(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert run(["optimize", str(program)]) == 0
    assert len(capsys.readouterr().err.splitlines()) < 4  # it took a second or two
    monkeypatch.setattr("trajopt_cli.cli.progress.log_pause", lambda spent: 0.0)
    assert run(["optimize", str(program), "--jobs", "1"]) == 0
    lines = [re.sub(r"^\d+ s: ", "", line) for line in capsys.readouterr().err.splitlines()]
    assert lines[:4] == [
        "checking what can be reached",
        "stream: searching rail and configurations, best 2.000 s, bound 1.600 s, gap 25.0 %",
        f"stream: proving the bound, best {CYCLE[Target.STREAM]:.3f} s",
        f"stream: judging the plan, best {CYCLE[Target.STREAM]:.3f} s, bound {0.9 * CYCLE[Target.STREAM]:.3f} s, "
        "gap 11.1 %",
    ]
    assert lines[-2:] == ["estimating what writing loops out would save", "writing the files"]


def test_without_a_cell_file_the_five_lines_are_printed_and_work(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("tiny.yaml").unlink()
    assert run(["optimize", str(program)]) == 2
    first, *text = capsys.readouterr().err.splitlines()
    assert first == "tiny.yaml: tiny.mod has no cell file; save these lines there and adapt them:"
    kept = [line for line in text if not line.startswith("rail:")]
    Path("tiny.yaml").write_text("\n".join(kept).replace("irb140_rail", "irb140", 1).replace(", rail: 0", ""))
    assert run(["optimize", str(program)]) == 0


def test_an_infeasible_program_is_told_and_nothing_is_written(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    source = Source("tiny.mod", 6, 9)
    planner.answer = Infeasible(0, source, "MoveAbsJ j_side needs joint_1 = 200 deg, limit 180 deg")
    assert run(["optimize", str(program)]) == 1
    captured = capsys.readouterr()
    assert captured.err.splitlines()[-1] == "tiny.mod:6:9: MoveAbsJ j_side needs joint_1 = 200 deg, limit 180 deg"
    assert captured.out == ""
    assert not Path("results").exists()


def test_what_only_the_written_program_cannot_do_is_told_before_any_solving(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    """A statement that runs again with another confdata keeps both in the RAPID plan; the stream could choose."""
    point = "[[500,100,400],[0,0,1,0],[{},0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
    points = f"CONST robtarget ps{{2}}:=[{point.format('1,1,1')},{point.format('0,0,0')}];"
    loop = "again: MoveJ Offs(ps{n},0,0,n), v1000, fine, tool0; n:=n+1; IF n<3 GOTO again;"
    text = program.read_text().replace("WaitTime 0.5;", loop)
    program.write_text(text.replace("    PROC", f"    VAR num n:=1; {points}\n    PROC"))
    assert run(["optimize", str(program)]) == 1
    last = capsys.readouterr().err.splitlines()[-1]
    assert last.startswith("tiny.mod:8:16: MoveJ Offs(")
    assert "in confdata [1,1,1,0]" in last
    assert planner.asked == []
    assert not Path("results").exists()


def test_an_illegal_plan_is_never_a_result(
    program: Path, planner: Planner, results: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = content(Path("results/tiny"))
    planner.speed = 2.0
    assert run(["optimize", str(program)]) == 1
    assert "NOTHING WRITTEN: the judge rejects the stream plan:" in capsys.readouterr().err
    assert content(Path("results/tiny")) == before


def test_a_folder_that_is_no_results_folder_is_not_replaced(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program)]) == 0
    Path("results/tiny/notes.txt").write_text("precious")
    capsys.readouterr()
    assert run(["optimize", str(program)]) == 2
    assert capsys.readouterr().err.startswith("results/tiny: holds notes.txt")
    assert Path("results/tiny/notes.txt").read_text() == "precious"


def test_results_are_judged_again_alone_and_spoiled_ones_are_caught(
    results: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (tmp_path / "results" / "tiny").rename(elsewhere / "moved")
    monkeypatch.chdir(elsewhere)
    capsys.readouterr()
    assert run(["verify", "moved"]) == 0
    assert re.search(
        r"^stream\.csv: legal \(\d+ checks\); obstacles not checked: ", capsys.readouterr().out, re.MULTILINE
    )
    spoiled = Path("moved/rapid.csv")
    header, *rows = spoiled.read_text().splitlines()
    spoiled.write_text("\n".join([header, *rows[: len(rows) // 2]]) + "\n")
    assert run(["verify", "moved"]) == 1  # the judge looks at the file as it stands
    out = capsys.readouterr().out
    assert re.search(r"^rapid\.csv: ILLEGAL", out, re.MULTILINE)
    assert re.search(r"^stream\.csv: legal", out, re.MULTILINE)
    assert run(["export", "joint", "moved", "--output", "joints.csv"]) == 2
    assert capsys.readouterr().err == "moved/rapid.csv: was changed since the run; run trajopt optimize again\n"


def test_a_verdict_in_a_line_asks_for_no_advice(
    program: Path, results: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[bool] = []
    monkeypatch.setattr("trajopt_cli.judge.verify.advise", lambda *_: asked.append(True) or [])
    for file in ([], ["--program", str(program)]):
        where = "results/tiny/stream.csv" if file else "results/tiny"
        capsys.readouterr()
        assert run(["verify", where, *file]) == 0
        verdicts = re.findall(r"^\w+\.csv: legal .*$", capsys.readouterr().out, re.MULTILINE)
        assert asked
        asked.clear()
        assert run(["verify", where, *file, "--quiet"]) == 0
        assert capsys.readouterr().out.splitlines() == verdicts
        assert not asked
        assert run(["verify", where, *file, "--quiet", "--json"]) == 0
        assert asked
        asked.clear()


def test_changed_inputs_of_a_results_folder_are_noticed(results: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("results/tiny/input/tiny.yaml").write_text(CELL + "free_speed: true\n")
    capsys.readouterr()
    assert run(["verify", "results/tiny"]) == 2
    assert capsys.readouterr().err == (
        "results/tiny/input/tiny.yaml: was changed since the run; run trajopt optimize again\n"
    )


def test_a_csv_file_of_anybody_is_judged_against_a_program(
    program: Path, results: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["export", "joint", "results/tiny", "--rate", "500", "--output", "joints.csv"]) == 0
    capsys.readouterr()
    assert run(["verify", "joints.csv", "--program", str(program)]) == 0
    Path("fast.csv").write_text(Path("joints.csv").read_text().replace("joint_1 [rad]", "joint_1 [deg]"))
    assert run(["verify", "fast.csv", "--program", str(program)]) == 1


def test_export_joint_carries_the_chosen_target_to_its_exact_end(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program), "--target", "rapid"]) == 0
    capsys.readouterr()
    assert run(["export", "joint", "results/tiny", "--rate", "250", "--output", "joints.csv"]) == 0
    said = capsys.readouterr().out
    trajectory, _ = read_csv_text(Path("joints.csv").read_text(), "joints.csv")
    assert trajectory.duration == pytest.approx(CYCLE[Target.RAPID], abs=1e-12)
    rows = len(trajectory.t)
    line, begins = said.splitlines()
    assert line == f"joints.csv: the rapid plan, {rows} rows at 250 Hz, T = {CYCLE[Target.RAPID]:.4f} s"
    assert begins.startswith("begins at joints 0.00 0.00 0.00 0.00 30.00 0.00 deg")


def test_export_rapid_gives_the_module_and_its_difference(
    program: Path, results: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["export", "rapid", "results/tiny", "--output", "new.mod", "--diff"]) == 0
    assert Path("new.mod").read_bytes() == Path("results/tiny/program.mod").read_bytes()
    captured = capsys.readouterr()
    changed = {line[1:] for line in captured.out.splitlines() if re.match(r"\+(?!\+\+)", line)}
    assert changed == set(Path("new.mod").read_text().splitlines()) - set(TEXT.splitlines())
    assert "wrote new.mod (RAPID plan, " in captured.out + captured.err


def test_parse_needs_no_cell_and_gives_places(program: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("tiny.yaml").unlink()
    assert run(["parse", str(program)]) == 0
    lines = capsys.readouterr().out.splitlines()
    for line, word in ((6, "j_side"), (7, "0.5"), (8, "j_home")):
        assert any(f"tiny.mod:{line}" in text and word in text for text in lines), lines
    assert run(["parse", str(program), "--json"]) == 0
    motions = json.loads(capsys.readouterr().out)["motions"]
    assert [motion["source"] for motion in motions] == ["tiny.mod:6:9", "tiny.mod:7:9", "tiny.mod:8:9"]


@pytest.mark.usefixtures("compared_once")
def test_compare_counts_savings_against_the_first_legal_row(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["compare", "baseline", str(program), "--json", "--csv", "rows.csv"]) == 0
    answer = json.loads(capsys.readouterr().out)
    records = {record["name"]: record for record in answer["rows"]}
    assert list(records) == [name for name in BASELINES if name != SAMPLED]
    assert answer["programmed_waits_s"] == 0.5
    assert records["as-written"]["saving"] == 0.0
    optimum = records["optimum stream"]
    assert optimum["saving"] == pytest.approx(1 - CYCLE[Target.STREAM] / CYCLE[Target.RAPID], abs=1e-9)
    without = 1 - (CYCLE[Target.STREAM] - 0.5) / (CYCLE[Target.RAPID] - 0.5)
    assert optimum["saving_without_waits"] == pytest.approx(without, abs=1e-9)
    assert {name for name in records if records[name].get("lower_bound_s")} == {"optimum rapid", "optimum stream"}
    assert {name for name in records if "n/a" in records[name].get("why", "")} >= {"practice", "thesis"}
    rows = list(csv.DictReader(Path("rows.csv").read_text().splitlines()))
    assert [row["name"] for row in rows] == [name for name in BASELINES if name != SAMPLED]
    assert float(rows[-1]["cycle_time_s"]) == pytest.approx(CYCLE[Target.STREAM])
    assert run(["compare", "baseline", str(program)]) == 0
    out = capsys.readouterr().out
    assert "optimum stream" in out
    assert "saving by cause" in out


@pytest.mark.usefixtures("compared_once")
def test_the_saving_by_cause_adds_up_and_a_slower_plan_never_replaces_a_faster(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    run(["compare", "baseline", str(program), "--json"])
    steps = json.loads(capsys.readouterr().out)["saving_by_cause"]["steps"]
    assert sum(step["saved_s"] for step in steps) == pytest.approx(CYCLE[Target.RAPID] - CYCLE[Target.STREAM], abs=1e-9)
    assert [step["why_not"] for step in steps] == [None, None, "nothing gained"]
    planner.freest = 0.9
    run(["compare", "baseline", str(program), "--json"])
    steps = json.loads(capsys.readouterr().out)["saving_by_cause"]["steps"]
    assert steps[-1]["cycle_time_s"] == steps[-2]["cycle_time_s"] == pytest.approx(CYCLE[Target.STREAM])


def test_rows_that_break_limits_save_nothing(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    planner.speed = 2.0
    run(["compare", "baseline", str(program), "--json"])
    answer = json.loads(capsys.readouterr().out)
    records = {record["name"]: record for record in answer["rows"]}
    for name in ("as-written", "fixed-rail", "optimum rapid", "optimum stream"):
        assert records[name]["saving"] is None
        assert records[name]["failed"]
        assert records[name]["worst_ratio"] > 1.5
    assert "as written" in answer["saving_by_cause"]["why_not"]


def test_a_results_folder_is_compared_like_its_program(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program), "--output", "out"]) == 0
    program.unlink()
    capsys.readouterr()
    assert run(["compare", "baseline", "out", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["rows"][-1]["cycle_time_s"] == pytest.approx(CYCLE[Target.STREAM])


def test_a_case_knows_whether_the_program_gives_the_rail_a_position(planner: Planner, program: Path) -> None:
    def gives_rail() -> bool:
        job = read_job(program)
        return Case(job.program, job.plant, planner).gives_rail  # type: ignore[arg-type]

    Path("tiny.yaml").write_text(
        "robot: irb140_rail\nrail: {eax: a, stroke: [-1, 1]}\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg', rail: 0}\n"
    )
    Path("tiny.mod").write_text(TEXT.replace("MoveAbsJ", "MoveExtJ").replace(", tool0", ""))
    assert not gives_rail()
    Path("tiny.mod").write_text(TEXT.replace("[9E9,", "[100,"))
    assert gives_rail()


def test_the_help_loads_nothing_heavy() -> None:
    """What parse loads: see test_parse."""
    heavy = "numpy casadi pinocchio lark rich pydantic ruamel scipy toppra ruckig"
    code = "import sys; from trajopt_cli.cli import run; run(['--help']); print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONPATH": str(REPOSITORY)},
    )
    assert not set(heavy.split()) & set(done.stdout.splitlines()[-1].split())


def test_optimize_leaves_advice_to_verify(program: Path, planner: Planner, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its libraries take longer to load than a short program to judge."""
    asked: list[object] = []
    monkeypatch.setattr("trajopt_cli.judge.verify.advise", lambda *given: asked.append(given) or [])
    assert run(["optimize", str(program), "--jobs", "1"]) == 0
    assert not asked
    assert run(["verify", "results/tiny"]) == 0
    assert len(asked) == len(Target)


def test_the_option_offers_every_target() -> None:
    asked = get_args(get_args(get_type_hints(optimize, include_extras=True)["target"])[0])
    assert set(get_args(asked[0])) == {*Target}


def test_an_interruption_while_modules_are_imported_is_one_line(tmp_path: Path) -> None:
    (tmp_path / "typer.py").write_text("import os, time\nos.kill(os.getpid(), 2)\ntime.sleep(9)\n")
    command = [sys.executable, "-c", HEARD, "parse", "programs/hinge_cell.mod"]
    path = os.pathsep.join([str(tmp_path), str(REPOSITORY)])
    ended = subprocess.run(
        command, cwd=REPOSITORY, env=os.environ | {"PYTHONPATH": path}, capture_output=True, text=True
    )
    assert (ended.returncode, ended.stdout) == (130, "")
    assert ended.stderr == "interrupted: nothing written, earlier results stand\n"


@pytest.mark.parametrize("named", [RuntimeError("Error calling __set_name__"), InputError("mujoco is not installed")])
def test_an_interruption_that_a_library_gave_another_name_is_one(
    named: Exception, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object, **__: object) -> int:
        raise named from KeyboardInterrupt()

    monkeypatch.setattr(cli, "_commands", lambda: interrupted)
    assert run(["verify", "results"]) == 130
    assert capsys.readouterr().err == "interrupted: nothing written, earlier results stand\n"


def test_an_error_that_is_its_own_cause_is_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def refused(*_: object, **__: object) -> int:
        error = InputError("wrong")
        raise error from error

    monkeypatch.setattr(cli, "_commands", lambda: refused)
    assert run(["verify", "results"]) == 2
    assert capsys.readouterr().err == "wrong\n"


# Tests in the background of a shell hear no Ctrl-C.
HEARD = (
    "import signal; signal.signal(signal.SIGINT, signal.default_int_handler); from trajopt_cli.cli import main; main()"
)


# Planners that are interrupted: one sleeps, one does as CasADi does and takes the interrupt for a solver's stop.
INTERRUPTED = """
import os, sys, time
import trajopt_cli.plan
from trajopt_cli.cli import main
from trajopt_cli.problem.progress import Progress

def sleeping(*arguments, **more):
    os.write(1, b"planning\\n")  # one write, so that two processes do not mix
    time.sleep(60)

def swallowing(program, plant, target, progress, **more):
    try:
        sleeping()
    except KeyboardInterrupt:
        progress(Progress("solve"))
        os.write(1, b"went on\\n")

trajopt_cli.plan.optimize = {planner}
sys.argv = ["trajopt", "optimize", "tiny.mod"]
main()
"""


@pytest.mark.parametrize("planner", ["sleeping", "swallowing"])
def test_ctrl_c_ends_in_one_line_and_writes_nothing(program: Path, planner: str) -> None:
    process = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED.replace("{planner}", planner)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": str(REPOSITORY)},
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "planning\n"
    time.sleep(0.1)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=20)
    assert "went on" not in out
    assert process.returncode == 130
    said = r"\d+ s: checking what can be reached\ninterrupted: nothing written, earlier results stand\n"
    assert re.fullmatch(said, err)
    assert not Path("results").exists()


@pytest.mark.parametrize("more", [[], ["--quiet"], ["--json"]])
def test_ctrl_c_with_a_plan_at_hand_says_what_it_kept(
    program: Path,
    planner: Planner,
    more: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def interrupted(*given: Any, patience: Patience, **named: Any) -> object:
        patience.answer()
        if not patience.interrupted:
            signal.raise_signal(signal.SIGINT)
        return planner(*given, **named)

    monkeypatch.setattr(
        "trajopt_cli.plan.optimize",
        lambda *given, **named: interrupted(*given, **named) if "patience" in named else planner(*given, **named),
    )
    assert run(["optimize", str(program), "--jobs", "1", *more]) == 0
    captured = capsys.readouterr()
    assert "stopping: the best plan so far is being completed (Ctrl-C again to give it up)\n" in captured.err
    assert captured.err.splitlines()[-1] == (
        f"interrupted: the best plan so far, {CYCLE[Target.RAPID]:.3f} s, was completed, judged and written to "
        "results/tiny"
    )
    assert Path("results/tiny/summary.json").exists()
    if more == ["--json"]:
        assert json.loads(captured.out)["interrupted"] is True


@pytest.mark.usefixtures("compared_once")
def test_ctrl_c_after_something_was_written_names_it(
    program: Path, planner: Planner, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("trajopt_cli.study.comparison.comparison_pictures", interrupted)
    assert run(["compare", "baseline", str(program), "--csv", "rows.csv", "--plots", "plots", "--quiet"]) == 130
    assert capsys.readouterr().err == "interrupted: rows.csv written before that, nothing half-written\n"
    assert run(["parse", str(program)]) == 0


def test_the_real_optimiser_gives_the_closed_form_of_a_single_joint_there_and_back(
    program: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Only joint_1 turns, 20 degrees each way at its 15 rad/s2, the tool under v2500 all the time."""
    program.write_text(TEXT.replace("v1000", "v2500"))
    assert run(["optimize", str(program)]) == 0
    plans = json.loads(Path("results/tiny/summary.json").read_text())["plans"]
    shortest = 4 * np.sqrt(np.radians(20) / 15.0) + 0.5
    for one in Target:
        assert plans[one]["cycle_time_s"] == pytest.approx(shortest, rel=1e-6)
        assert plans[one]["lower_bound_s"] <= plans[one]["cycle_time_s"]
        assert [motion["binding"] for motion in plans[one]["motions"]][::2] == ["joint_1 acceleration"] * 2
    assert run(["verify", "results/tiny"]) == 0
    assert Path("results/tiny/program.mod").read_bytes() == program.read_bytes()  # nothing to change, nothing changed


def test_a_plan_that_collides_is_an_answer_that_names_motion_time_and_pair(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    # the flange of the tiny cycle swings 20 degrees to the left; a post stands on its way
    Path("tiny.yaml").write_text(
        CELL + "obstacles:\n  post: {capsule: {from: [0.49, 0.1, 0], to: [0.49, 0.1, 1.2], radius: 0.02}}\n"
    )
    assert run(["optimize", str(program), "--output", "out"]) == 1
    said = capsys.readouterr().err.splitlines()
    assert re.fullmatch(r"tiny\.mod:6:9: MoveAbsJ j_side hits 'post' with link_\d at \d\.\d+ s, deep.*", said[-2]), said
    assert said[-1].startswith("NOTHING WRITTEN: the stream plan collides.")
    assert not Path("out").exists()
    Path("tiny.yaml").write_text(CELL + "obstacles:\n  post: {box: {size: [0.1, 0.1, 0.1], position: [2, 0, 0.5]}}\n")
    assert run(["optimize", str(program), "--output", "out"]) == 0
    out = capsys.readouterr().out
    assert "post" in out
    assert "obstacles not checked" not in out
    assert json.loads(Path("out/summary.json").read_text())["unchecked"] == []


def test_without_obstacles_it_is_said(program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["optimize", str(program), "--output", "out"]) == 0
    assert "obstacles not checked: the cell file gives none" in capsys.readouterr().out
    assert json.loads(Path("out/summary.json").read_text())["unchecked"]


def test_obstacles_that_nothing_is_held_against_are_told_first(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    robots = Path(__file__).parents[2] / "robots"
    Path("bare.yaml").write_text((robots / "irb140.yaml").read_text().split("collision:\n")[0])
    Path("irb140.urdf").write_text((robots / "irb140.urdf").read_text())
    post = "obstacles:\n  post: {box: {size: [0.1, 0.1, 0.1], position: [2, 0, 0.5]}}\n"
    Path("tiny.yaml").write_text(CELL.replace("irb140", "bare.yaml") + post)
    wanted = (
        "WARNING: tiny.yaml: collisions of the robot are not checked: irb140 has no collision shapes, and the cell "
        "gives 1 obstacle; give the robot's links bodies in its file (collision.links)"
    )
    for command in (["optimize", str(program), "--output", "out"], ["verify", "out"], ["parse", str(program)]):
        assert run(command) == 0, capsys.readouterr().err
        told = " ".join(capsys.readouterr().out.split())
        assert told.replace("out/input/tiny.yaml", "tiny.yaml").startswith(wanted), told[:400]
        assert told.count("collisions of the robot are not checked") == 1
    assert run(["verify", "out", "--quiet"]) == 0
    assert capsys.readouterr().err.startswith("WARNING: ")
    for command in (["optimize", str(program), "--output", "out"], ["check", str(program)]):
        assert run([*command, "--quiet"]) == 0
        out, err = capsys.readouterr()
        assert out.count("\n") == 1
        assert (
            "; collisions not checked: robot irb140 has no bodies; WARNING: tiny.yaml: collisions of the robot" in out
        )
        assert err == ""


def test_a_mesh_travels_with_the_results(program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]) -> None:
    Path("parts").mkdir()
    corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    facets = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
    rows = ["solid t"]
    for facet in facets:
        rows += [
            "facet normal 0 0 0",
            "outer loop",
            *("vertex {} {} {}".format(*corners[i]) for i in facet),
            "endloop",
            "endfacet",
        ]
    Path("parts/wedge.stl").write_text("\n".join([*rows, "endsolid t"]) + "\n")
    Path("tiny.yaml").write_text(CELL + "obstacles:\n  wedge: {mesh: {file: parts/wedge.stl, position: [2, 0, 0]}}\n")
    assert run(["optimize", str(program), "--output", "out"]) == 0
    assert Path("out/input/parts/wedge.stl").read_bytes() == Path("parts/wedge.stl").read_bytes()
    for path in ("parts/wedge.stl", "tiny.yaml", "tiny.mod"):
        Path(path).unlink()
    assert run(["verify", "out"]) == 0
    assert "clearance" in capsys.readouterr().out


@pytest.mark.usefixtures("compared_once")
def test_pictures_are_drawn_on_request_and_belong_to_the_folder(
    program: Path, planner: Planner, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn = {"joints.svg": b"<svg/>", "joints.png": b"png"}
    monkeypatch.setattr("trajopt_cli.report.pictures.draw", lambda *given: drawn)
    monkeypatch.setattr("trajopt_cli.report.pictures.stepwise", lambda *given: {"steps.svg": b"<svg/>"})
    assert run(["optimize", str(program), "--output", "out", "--plots"]) == 0
    assert sorted(path.name for path in Path("out/plots").iterdir()) == ["joints.png", "joints.svg", "steps.svg"]
    assert run(["optimize", str(program), "--output", "out"]) == 0  # what trajopt wrote, trajopt replaces
    assert not Path("out/plots").exists()
    assert run(["compare", "baseline", str(program), "--plots", "pictures"]) == 0
    names = {path.name for path in Path("pictures").iterdir()}
    assert names == {
        "joints.png",
        "joints.svg",
        "steps.svg",
        "comparison.svg",
        "comparison.png",
        "savings.svg",
        "savings.png",
    }


def test_a_program_whose_moves_end_where_the_robot_stands_is_a_wrong_request(
    program: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    body = "        MoveAbsJ j_home, v1000, fine, tool0;\n"
    program.write_text(TEXT[: TEXT.index("        MoveAbsJ")] + body + "    ENDPROC\nENDMODULE\n")
    assert run(["optimize", str(program)]) == 2
    assert capsys.readouterr().err.splitlines()[-1] == (
        "tiny.mod: main moves nothing: every move ends where the robot stands at the start"
    )
