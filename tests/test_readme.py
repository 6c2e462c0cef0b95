"""README.md and the pages that it leads to are true: commands exist, what .ci/run runs, keys and links."""

from __future__ import annotations

import os
import pkgutil
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from typer.testing import CliRunner

from trajopt_cli.cell.document import CellDocument
from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.cli import app
from trajopt_cli.iiwa.task.document import TaskDocument
from trajopt_cli.problem.plant import build_plant

REPOSITORY = Path(__file__).parents[1]
README = (REPOSITORY / "README.md").read_text(encoding="utf-8")
DOCS = {page.name: page.read_text(encoding="utf-8") for page in (REPOSITORY / "docs").glob("*.md")}
KEYS = {
    "cell": (REPOSITORY / "trajopt_cli/cell/keys.md").read_text(encoding="utf-8"),
    "task": (REPOSITORY / "trajopt_cli/iiwa/task/keys.md").read_text(encoding="utf-8"),
}
CI = (REPOSITORY / ".ci" / "run").read_text(encoding="utf-8")


def block(name: str) -> str:
    match = re.search(rf"<!-- command: {name} -->\n```bash\n(.+)\n```\n", README)
    assert match, f"README.md has no one-line block for {name}"
    return match[1]


@pytest.mark.parametrize(
    ("name", "parts"),
    [
        ("run", ["pip install .", "trajopt optimize programs/hinge_cell.mod"]),
        ("test", ["pip install -e '.[test]'", "pytest -n auto"]),
    ],
)
def test_one_command_makes_its_environment_installs_and_runs(name: str, parts: list[str]) -> None:
    environment, *steps = block(name).split(" && ")
    assert environment == "python3.11 -m venv .venv"
    assert steps == [f".venv/bin/{part}" for part in parts]


@pytest.mark.parametrize("browser", [True, False])
def test_ci_runs_the_readme_commands_word_for_word(tmp_path: Path, browser: bool) -> None:
    """.ci/run itself, with stand-ins on the PATH that write down what they are called with, and little else there."""
    log = tmp_path / "log"
    fake = tmp_path / "bin"
    fake.mkdir()
    # The stand-in for python3.11 makes a "virtual environment" whose programs log their name and arguments.
    (fake / "python3.11").write_text(
        "#!/bin/bash\n"
        f'echo "python3.11 $*" >> {log}\n'
        'mkdir -p "$3/bin"\n'
        "for name in pip trajopt pytest ruff mypy sphinx-build; do\n"
        f'  printf \'#!/bin/bash\\necho "$0 $*" >> {log}\\n\' > "$3/bin/$name"\n'
        '  chmod +x "$3/bin/$name"\n'
        "done\n"
    )
    for name in ("apt-get", *(("chromium", "chromedriver") if browser else ())):
        (fake / name).write_text(f'#!/bin/bash\necho "{name} $*" >> {log}\n')
    for path in fake.iterdir():
        path.chmod(0o755)
    for name in ("awk", "bash", "chmod", "dirname", "env", "id", "mkdir", "mktemp", "rm", "sed"):
        (fake / name).symlink_to(str(shutil.which(name)))
    env = {**os.environ, "PATH": str(fake), "TMPDIR": str(tmp_path)}
    subprocess.run([REPOSITORY / ".ci" / "run"], env=env, check=True, capture_output=True)
    called = [line.rstrip() for line in log.read_text().splitlines()]
    if not browser:
        assert called[:2] == ["apt-get update", "apt-get install -y chromium chromium-driver"]
        called = called[2:]
    venv = called[0].split()[-1]
    assert venv.startswith(str(tmp_path))
    assert not Path(venv).exists(), ".ci/run leaves its environment behind"
    wanted = []
    for name in ("run", "test"):
        wanted += [step.replace("'", "").replace(".venv", venv) for step in block(name).split(" && ")]
    after = [
        "pytest -n auto -m long",
        "ruff check .",
        "ruff format --check .",
        "mypy",
        f"sphinx-build -W --keep-going -q docs {venv[:-5]}/site",
    ]
    assert called == [*wanted, *(f"{venv}/bin/{step}" for step in after)]


def test_ci_stops_at_the_first_failure() -> None:
    assert "set -euo pipefail" in CI
    assert os.access(REPOSITORY / ".ci" / "run", os.X_OK)


def usage_lines() -> list[str]:
    match = re.search(r"```text\n(trajopt .+?)```", DOCS["commands.md"], re.DOTALL)
    assert match
    return match[1].splitlines()


@pytest.mark.parametrize("line", usage_lines())
def test_every_command_and_option_of_the_list_exists(line: str) -> None:
    words = re.findall(r"[\w.-]+|--\w+", line)
    command = [w for w in words[1:3] if re.fullmatch(r"[a-z]+\d?", w)]
    shown = CliRunner().invoke(app, [*command, "--help"])
    assert shown.exit_code == 0, shown.output
    for option in re.findall(r"--[a-z]+", line):
        assert option in shown.output, f"{' '.join(command)} has no {option}"


def test_the_example_cell_file_loads() -> None:
    match = re.search(r"```yaml\n(.+?)```", DOCS["cell-file.md"], re.DOTALL)
    assert match
    assert build_plant(parse_cell(match[1], "cell-file.yaml")).rail_eaxes == (0,)


def test_the_table_of_keys_is_the_documents() -> None:
    keys = re.findall(r"^\| `(\w+)` \|", KEYS["cell"], re.MULTILINE)
    assert keys == list(CellDocument.model_fields)


def test_the_functions_named_for_python_exist() -> None:
    sections = [DOCS["python.md"], DOCS["iiwa.md"].split("## From Python")[1]]
    for name in re.findall(r"`(trajopt_cli\.[\w.]+)`", "".join(sections)):
        assert pkgutil.resolve_name(name) is not None


def test_links_point_at_files() -> None:
    for target in re.findall(r"\]\(([^)#]+)[^)]*\)", README):
        assert target.startswith("http") or (REPOSITORY / target).exists(), target


def test_the_task_files_keys_are_all_told() -> None:
    told = [
        key for row in re.findall(r"^\| (`.+?`) \|", KEYS["task"], re.MULTILINE) for key in re.findall(r"`(\w+)`", row)
    ]
    assert sorted(told) == sorted(TaskDocument.model_fields)


@pytest.mark.parametrize("line", re.findall(r"^trajopt iiwa .+", DOCS["iiwa.md"], re.MULTILINE))
def test_the_commands_of_the_compliant_job_exist(line: str) -> None:
    command, *rest = line.split("#")[0].split()[2:]
    shown = CliRunner().invoke(app, ["iiwa", command, "--help"])
    assert shown.exit_code == 0, shown.output
    for word in rest:
        if word.startswith("--"):
            assert word in shown.output
        if word.startswith("programs/"):
            assert (REPOSITORY / word).is_file()
