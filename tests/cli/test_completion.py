"""Completion by the shell: commands, options and choices from trajopt, files from the shell itself."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from trajopt_cli.cli import run

REPOSITORY = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """trajopt on the PATH."""
    folder = tmp_path_factory.mktemp("bin")
    script = folder / "trajopt"
    script.write_text(f'#!/bin/sh\nexec {sys.executable} -m trajopt_cli.cli "$@"\n')
    script.chmod(0o755)
    return {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "PYTHONPATH": str(REPOSITORY), "HOME": str(folder)}


@pytest.fixture(scope="module")
def script(environment: dict[str, str]) -> str:
    around = {**environment, "_TRAJOPT_COMPLETE": "source_bash"}
    return subprocess.run(["trajopt"], env=around, capture_output=True, text=True, check=False, timeout=60).stdout


@pytest.mark.skipif(shutil.which("bash") is None, reason="there is no bash")
@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["opt"], {"optimize"}),
        (["optimize", "tiny.mod", "--target", ""], {"stream", "rapid"}),
        (["robot", "show", "irb14"], {"irb140", "irb140_rail"}),
        (["optimize", "ti"], set()),  # then bash itself completes files: -o default
    ],
)
def test_bash_completes(words: list[str], expected: set[str], environment: dict[str, str], script: str) -> None:
    assert "complete -o default -F _trajopt_completion trajopt" in script
    line = " ".join(f"'{word}'" for word in ("trajopt", *words))
    ask = f'COMP_WORDS=({line}); COMP_CWORD={len(words)}; _trajopt_completion trajopt; echo "${{COMPREPLY[@]}}"'
    done = subprocess.run(
        ["bash", "-c", f"{script}\n{ask}"], env=environment, capture_output=True, text=True, check=True, timeout=60
    )
    assert set(done.stdout.split()) == expected
    assert done.stderr == ""


def test_zsh_and_fish_get_choices_or_files(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    def completed(shell: str, words: str, action: str = "") -> tuple[int, str]:
        monkeypatch.setenv("_TRAJOPT_COMPLETE", f"complete_{shell}")
        monkeypatch.setenv("_TYPER_COMPLETE_ARGS", words)
        monkeypatch.setenv("_TYPER_COMPLETE_FISH_ACTION", action)
        with pytest.raises(SystemExit) as left:
            run([])
        return int(left.value.code or 0), capsys.readouterr().out.strip()

    assert completed("zsh", "trajopt optimize ti") == (0, "_files")
    assert '"stream"' in completed("zsh", "trajopt optimize a.mod --target ")[1]
    assert completed("fish", "trajopt optimize ti", "is-args")[0] == 1  # then fish itself completes files
    assert completed("fish", "trajopt robot show ii", "get-args")[1].split() == ["iiwa14", "iiwa7"]


@pytest.mark.skipif(shutil.which("bash") is None, reason="there is no bash")
def test_completion_is_installed_for_the_shell_at_hand(environment: dict[str, str], tmp_path: Path) -> None:
    home = {**environment, "HOME": str(tmp_path)}
    # a last command of bash's own, so that bash stays the parent
    done = subprocess.run(
        ["bash", "-c", "trajopt --install-completion; :"], env=home, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert "bash completion installed" in done.stdout
    assert "trajopt" in (tmp_path / ".bashrc").read_text()
