"""`trajopt doctor`: what is missing is named with the way to get it, and a plan that is wrong is noticed."""

from __future__ import annotations

import fcntl
import importlib.metadata
import json
from pathlib import Path

import pytest
from fake_planner import Planner

from trajopt_cli.cli import health, run

ASKED = ["casadi>=3.8,<4", "numpy>=2.2", 'pyarrow>=22; extra == "parquet"', "pytest>=9; extra == 'test'"]


@pytest.fixture
def installed(monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    """Packages and their versions, as the installation tells."""
    there = {"casadi": "3.8.2", "numpy": "2.4.6", "pyarrow": "26.0.1"}

    def version(name: str) -> str:
        if name not in there:
            raise importlib.metadata.PackageNotFoundError(name)
        return there[name]

    monkeypatch.setattr(health, "requires", lambda _: ASKED)
    monkeypatch.setattr(health, "version", version)
    return there


def asked(capsys: pytest.CaptureFixture[str]) -> tuple[int, dict[str, dict[str, str]]]:
    code = run(["doctor", "--json"])
    answer = json.loads(capsys.readouterr().out)
    assert answer["healthy"] is (code == 0)
    return code, {one["what"]: one for one in answer["checks"]}


def test_a_sound_installation_solves_its_problem(installed: dict[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    code, found = asked(capsys)
    assert code == 0
    assert found["package casadi"]["found"] == "3.8.2"
    assert found["extra parquet: pyarrow"]["state"] == "ok"
    assert not any("pytest" in what for what in found)
    assert found["self-test"]["found"].startswith("a problem of 0.6102 s solved")  # 4 sqrt(20 deg / 15 rad/s2)


def test_what_killed_runs_left_is_named(
    installed: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(health, "_solved", health._machine)
    names = [".a.csv.trajopt-01234567", "results/.cell.trajopt-89abcdef", "results/.cell.trajopt-00000000.old"]
    strangers = [".a.csv.trajopt-mine", ".trajopt-01234567", "results/cell.trajopt-01234567"]
    (tmp_path / "results").mkdir()
    assert asked(capsys)[1]["leftovers"]["state"] == "ok"
    for name in [*names, *strangers]:
        (tmp_path / name).write_bytes(b"")
    with open(tmp_path / ".living.csv.trajopt-01234567", "xb") as living:
        fcntl.flock(living, fcntl.LOCK_EX)
        code, found = asked(capsys)
    assert (code, found["leftovers"]["state"]) == (0, "absent")
    assert sorted(found["leftovers"]["found"].split(": ")[1].split(", ")) == sorted(names)


def test_what_is_missing_or_old_is_named_with_the_way_to_get_it(
    installed: dict[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    del installed["pyarrow"]
    code, found = asked(capsys)
    assert code == 0  # nobody needs it
    assert found["extra parquet: pyarrow"]["state"] == "absent"
    assert found["extra parquet: pyarrow"]["remedy"] == "pip install 'trajopt-cli[parquet]'"
    installed["casadi"] = "4.0.1"
    installed["numpy"] = "2.10.0"
    code, found = asked(capsys)
    assert code == 1
    assert found["package casadi"]["found"] == "4.0.1, needed is >=3.8,<4"
    assert found["package numpy"]["state"] == "ok"
    assert "self-test" not in found
    del installed["numpy"]
    code, found = asked(capsys)
    assert (code, found["package numpy"]["remedy"]) == (1, "pip install 'numpy>=2.2'")
    assert run(["doctor", "--quiet"]) == 1
    assert capsys.readouterr().out.startswith("something is missing: package casadi: 4.0.1")


def test_a_plan_that_is_not_the_known_one_is_noticed(
    installed: dict[str, str], planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    code, found = asked(capsys)  # the stand-in is slower than it could be
    assert code == 1
    assert "0.6102 s is known" in found["self-test"]["found"]


def test_a_cache_that_cannot_be_written_is_told(
    installed: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    code, found = asked(capsys)
    assert code == 0
    assert found["cache"]["state"] == "absent"
    assert str(tmp_path / "file" / "trajopt") in found["cache"]["found"]
