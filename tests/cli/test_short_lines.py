"""Whatever is in a file or an argument, a line of an error message stays one that can be read."""

from __future__ import annotations

from pathlib import Path

import pytest

from trajopt_cli.cli import run

LONG = "a" * 10_000


@pytest.mark.parametrize(
    "arguments",
    [
        ["parse", "long.mod"],
        ["parse", "long.mod", "--entry", LONG],
        ["verify", "head.csv", "--robot", "iiwa7"],
        ["verify", "cell.csv", "--robot", "iiwa7"],
        ["parse", f"--{LONG}"],
        [LONG],
    ],
)
def test_no_line_is_longer_than_600_characters(
    arguments: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("long.mod").write_text(f"MODULE M\nPROC main()\n{LONG} 1;\nENDPROC\nENDMODULE\n", encoding="utf-8")
    Path("long.yaml").write_text("robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\n", encoding="utf-8")
    Path("head.csv").write_text(f"t [s],{LONG}\n0,1\n", encoding="utf-8")
    axes, zeros = ",".join(f"joint_{i} [rad]" for i in range(1, 8)), ",0" * 6
    Path("cell.csv").write_text(f"t [s],{axes}\n0,{LONG}{zeros}\n1,1{zeros}\n", encoding="utf-8")
    assert run(arguments) == 2
    lines = capsys.readouterr().err.splitlines()
    assert max(map(len, lines)) <= 700
    assert any("…" in line for line in lines)
    assert any(line.rstrip("a'").rstrip() for line in lines)


@pytest.mark.parametrize(
    "arguments", [["parse"], ["parse", "one.mod", "--entry"], ["robot", "show"], ["new"], ["verify"], ["optimize"]]
)
def test_a_newline_in_an_argument_is_written_as_one(
    arguments: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("one.mod").write_text("MODULE M\nPROC main()\nENDPROC\nENDMODULE\n", encoding="utf-8")
    assert run([*arguments, "a\nb"]) == 2
    said = capsys.readouterr().err
    assert "a\\nb" in said
    assert said.count("\n") == 1
