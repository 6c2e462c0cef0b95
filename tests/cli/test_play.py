"""`trajopt export egm` and `trajopt play egm`."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from fake_planner import ACCELERATION, CELL

from trajopt_cli.cli import run
from trajopt_cli.cli.export import egm_stream
from trajopt_cli.exporters.recorded import Recorded
from trajopt_cli.problem.plan import Target
from trajopt_cli.trajectory import Trajectory

CYCLE = 4 * np.sqrt(np.radians(20) / ACCELERATION[Target.STREAM]) + 0.5  # s
HERE = ["--to", "127.0.0.1:0"]


def test_a_stream_is_played_to_a_follower_and_what_comes_back_is_kept(
    results: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    count = int(np.ceil(CYCLE * 250)) + 1
    assert run(["export", "egm", str(results), "--output", "s.egm"]) == 0
    said = capsys.readouterr().out
    assert said.startswith(f"s.egm: the stream plan, {count} set points at 250 Hz, T = ")
    assert said.endswith(" s: 6 joints in deg\n")
    for source in ("s.egm", str(results)):
        assert run(["play", "egm", source, "--echo", *HERE, "--log", "back.csv"]) == 0
        shown = capsys.readouterr()
        assert shown.err.startswith(
            f"{source}: {count} set points in {4e-3 * (count - 1):.3f} s, answered on 127.0.0.1:"
        )
        (row,) = [line.split() for line in shown.out.splitlines() if "joint_1" in line]
        assert row[-3:] == ["deg", "50.0", "ms"]
        assert row[-4] == row[-5], "as foretold"
        assert row[3] == f"{0.05 * float(row[1]):.3f}"
        rows = np.loadtxt("back.csv", delimiter=",", skiprows=1)
        assert f"{len(rows)} messages of the controller answered, 0 lost" in shown.out
        assert rows[:, 1].max() == pytest.approx(20, abs=0.1)
        assert np.abs(rows[-1, 1:7] - rows[-1, 7:]).max() < 1e-3


def test_a_log_is_looked_at_first_and_nobody_who_asks_is_an_answer(
    results: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for more, said in (
        (["--log", "nowhere/b.csv"], "nowhere: is not a folder to write to; make it or correct --log"),
        (["--log", f"{results}/rapid.csv"], f"{results}/rapid.csv: is a file of a results folder, "),
        (["--to", "192.168.125.1:6510"], "--to 192.168.125.1:6510: is not the loopback, and this player moves no mach"),
        (["--follower-time-constant", "0"], "--follower-time-constant 0: wanted seconds above 0"),
    ):
        assert run(["play", "egm", str(results), *more]) == 2
        assert capsys.readouterr().err.startswith(said)
    assert run(["play", "egm", "nothing.egm", *HERE]) == 2
    assert capsys.readouterr().err == "nothing.egm: cannot read: No such file or directory\n"
    assert run(["play", "egm", str(results), *HERE, "--silence", "0.05"]) == 1
    shown = capsys.readouterr()
    assert shown.err.endswith("\nno EgmRobot message came for 0.05 s\n")
    (row,) = [line.split() for line in shown.out.splitlines() if "joint_1" in line]
    assert row[-1] == "deg", "foretold all the same, and nothing came back"


def test_the_rail_stands_in_the_place_of_its_external_axis(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "cell.yaml").write_text(CELL.replace("irb140", "irb140_rail").replace("deg'}", "deg', rail: 0}")
                                        + "rail: {eax: c, stroke: [-0.2, 2.2]}\n")  # fmt: skip
    names = ("rail", *(f"joint_{i}" for i in range(1, 7)))
    moved = np.zeros((2, 7))
    moved[1, 0] = 0.004
    motion = Recorded("a plan", Trajectory(names, np.array([0.0, 0.5]), moved, np.zeros((2, 7))))
    monkeypatch.setattr("trajopt_cli.exporters.recorded.recorded", lambda _: motion)
    monkeypatch.setattr(
        "trajopt_cli.runs.results.read_results", lambda _: SimpleNamespace(cell=tmp_path / "cell.yaml", robot=None)
    )
    _, stream = egm_stream(tmp_path)
    assert stream.names[6:] == ("eax_a", "eax_b", "eax_c")
    assert stream.q[-1, 6:].tolist() == [0, 0, 4]
