"""`trajopt analyse`: what it prints for the shipped line, the record behind it, and its complaints."""

from __future__ import annotations

import json
import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run

LINE = Path(__file__).parents[2] / "programs" / "hinge_line.mod"


def test_the_table_of_the_hinge_line_ends_in_the_published_sums(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "300")
    assert run(["analyse", str(LINE)]) == 0
    out = capsys.readouterr().out
    lines = [" ".join(line.split()) for line in out.splitlines()]
    assert lines[-5:-1] == ["arm 5.557 s", "rail 4.000 s", "cycle 9.557 s", "waits 4.800 s, apart"]
    for said in ("steps of speed", "carriage-relative", "waits excluded", "not a motion a robot can do"):
        assert said in lines[-1]
    rows = [line for line in lines if re.match(r"hinge_line\.mod:\d+ ", line)]
    assert len(rows) == 23
    # 60 mm straight down at 200 mm/s; the rail alone over 1500 mm; a wait in its own column
    assert re.fullmatch(r"hinge_line\.mod:\d+ MoveL p_n1 0\.300 60\.0 200\.0 -200\.0", rows[2])
    assert re.fullmatch(r"hinge_line\.mod:\d+ WaitTime 0\.8 s 0\.800", rows[3])
    assert re.fullmatch(r"hinge_line\.mod:\d+ MoveAbsJ j_home_n2 2\.000 1500\.0", rows[7])
    # all three axis speeds, from N2 out of the station: (-80, 60, 40) mm at 500 mm/s
    x, y, z = 500 * np.array([-80, 60, 40]) / np.linalg.norm([80, 60, 40])
    assert rows[14].endswith(f"MoveL p_n2_out 0.215 107.7 500.0 {x:.1f} {y:.1f} {z:.1f}")


def test_the_record_adds_up(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["analyse", str(LINE), "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    moves = record["moves"]
    assert len(moves) == 20
    assert [wait["duration_s"] for wait in record["waits"]] == [0.8, 2.0, 2.0]
    assert "waits excluded" in record["model"]
    for name in ("arm", "rail"):
        assert sum(move[f"{name}_s"] for move in moves) == pytest.approx(record[f"{name}_s"], abs=1e-12)
    assert sum(move["duration_s"] for move in moves) == pytest.approx(record["cycle_s"], abs=1e-12)
    assert record["cycle_s"] == pytest.approx(9.557, abs=1e-3)
    for before, after in pairwise(moves):
        for frame in ("carriage", "world"):
            assert before[f"{frame}_to_mm"] == pytest.approx(after[f"{frame}_from_mm"], abs=1e-9)
    for move in moves:
        step = np.subtract(move["carriage_to_mm"], move["carriage_from_mm"])
        np.testing.assert_allclose(np.multiply(move["velocity_mm_s"], move["arm_s"]), step, atol=1e-6)
        ride = [0, move["rail_to_mm"] - move["rail_from_mm"], 0]
        world = np.subtract(move["world_to_mm"], move["world_from_mm"])
        np.testing.assert_allclose(world, step + ride, atol=1e-6)
    assert moves[0]["source"] == f"{LINE}:{moves[0]['source'].split(':')[1]}:9"
    assert (moves[0]["instruction"], moves[0]["target"]) == ("MoveJ", "p_n1_in")


def test_arm_and_rail_at_once_are_said_to_be_counted_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without the folding the arm travels while the rail rides."""
    monkeypatch.chdir(tmp_path)
    text = LINE.read_text(encoding="utf-8")
    Path("short.mod").write_text(text.replace("RideToN2;", "", 1), encoding="utf-8")
    cell = LINE.with_suffix(".yaml")
    assert run(["analyse", "short.mod", "--cell", str(cell)]) == 0
    out = capsys.readouterr().out
    assert "rail 4.000 s" in out
    found = dict(re.findall(r"^(arm|cycle) (\d+\.\d+) s", out, re.MULTILINE))
    # 40 mm at 2500 mm/s are sooner done than the turn by 30 degrees at 500 deg/s, and that inside the 2 s of the rail
    assert float(found["cycle"]) == pytest.approx(float(found["arm"]) + 4.0 - 30 / 500, abs=1.1e-3)
    assert ", arm + rail - both at once 0.060 s" in out


def test_a_program_without_a_cell_file_is_told_what_to_write(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("alone.mod").write_text(LINE.read_text(encoding="utf-8"), encoding="utf-8")
    assert run(["analyse", "alone.mod"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("alone.yaml: alone.mod has no cell file; save these lines there and adapt them:\n")
