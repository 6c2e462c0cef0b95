"""The forge's workflow and the hooks before a commit: valid, and the same steps as .ci/run."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
from ruamel.yaml import YAML

REPOSITORY = Path(__file__).parents[1]
PROJECT = tomllib.loads((REPOSITORY / "pyproject.toml").read_text(encoding="utf-8"))["project"]
RUN = (REPOSITORY / ".ci" / "run").read_text(encoding="utf-8")


def read(name: str) -> Any:
    return YAML(typ="safe").load((REPOSITORY / name).read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def jobs() -> dict[str, Any]:
    return dict(read(".github/workflows/ci.yml")["jobs"])


def commands(job: dict[str, Any]) -> str:
    return "\n".join(step.get("run", "") for step in job["steps"])


def test_every_job_can_start(jobs: dict[str, Any]) -> None:
    assert set(jobs) == {"test", "wheel", "manual"}
    for job in jobs.values():
        assert job["runs-on"]
        assert job["timeout-minutes"] <= 120
        first, second, *rest = job["steps"]
        assert first["uses"].startswith("actions/checkout@")
        assert second["uses"].startswith("actions/setup-python@")
        assert rest
        assert all(("uses" in step) != ("run" in step) for step in job["steps"])


def test_pythons_and_systems_are_those_that_the_package_names(jobs: dict[str, Any]) -> None:
    named = [text.rsplit(" :: ")[-1] for text in PROJECT["classifiers"]]
    for name in ("test", "wheel"):
        matrix = jobs[name]["strategy"]["matrix"]
        assert matrix["os"] == ["ubuntu-latest", "macos-latest"]
        assert matrix["python"] == [version for version in named if re.fullmatch(r"3\.\d+", version)]
    assert PROJECT["requires-python"] == f">={jobs['test']['strategy']['matrix']['python'][0]}"


def test_the_steps_are_those_of_the_ci(jobs: dict[str, Any]) -> None:
    """Lint, format, types, tests, manual: what .ci/run calls, with the same arguments."""
    steps = re.findall(r'^"\$work/venv/bin/([\w-]+)"(.*)$', RUN, re.MULTILINE)
    assert [name for name, _ in steps] == ["pytest", "ruff", "ruff", "mypy", "sphinx-build"]
    lines = commands(jobs["test"]).splitlines()
    for name, arguments in steps[:4]:
        assert f"{name}{arguments}" in lines
    assert lines[-2:] == ["pytest -n auto", "pytest -n auto -m long"]
    assert "sphinx-build -W --keep-going docs" in commands(jobs["manual"])


def test_the_wheel_is_tried_outside_the_checkout(jobs: dict[str, Any]) -> None:
    tried = commands(jobs["wheel"])
    order = ["python -m build", 'pip" install dist/*.whl', 'cd "$RUNNER_TEMP"', "trajopt --version", "trajopt optimize"]
    places = [tried.index(part) for part in order]
    assert places == sorted(places)
    for program in re.findall(r"trajopt optimize (\S+)", tried):
        assert (REPOSITORY / program).is_file()


def test_the_hooks_take_what_the_environment_has() -> None:
    (repository,) = read(".pre-commit-config.yaml")["repos"]
    assert repository["repo"] == "local"
    assert [hook["entry"] for hook in repository["hooks"]] == ["ruff check", "ruff format", "mypy"]
    assert all(hook["language"] == "system" for hook in repository["hooks"])


def test_a_quarter_of_an_hour_of_fuzzing_is_scheduled() -> None:
    document = read(".github/workflows/fuzz.yml")
    assert set(document) == {"name", "on", "permissions", "jobs"}
    (time,) = document["on"]["schedule"]
    assert re.fullmatch(r"\d+ \d+ \* \* \d", time["cron"])
    (job,) = document["jobs"].values()
    first, second, install, *rest = job["steps"]
    assert first["uses"].startswith("actions/checkout@")
    assert second["uses"].startswith("actions/setup-python@")
    assert install["run"] == "python -m pip install -e '.[test]'"
    assert all(("uses" in step) != ("run" in step) for step in job["steps"])
    runs = [step["run"].split() for step in rest if "run" in step]
    assert sum(float(words[words.index("--minutes") + 1]) for words in runs) == 15 < job["timeout-minutes"]
    for words in runs:
        assert words[0] == "python"
        described = (REPOSITORY / words[1]).read_text(encoding="utf-8")
        for option in (word for word in words if word.startswith("--")):
            assert f'parser.add_argument("{option}"' in described
    assert rest[-1]["with"]["path"] in commands(job)


@pytest.mark.parametrize("name", [".github/workflows/ci.yml", ".github/workflows/fuzz.yml", ".pre-commit-config.yaml"])
def test_no_address_outside(name: str) -> None:
    assert "://" not in (REPOSITORY / name).read_text(encoding="utf-8")
