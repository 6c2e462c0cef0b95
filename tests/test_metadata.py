"""What `pip install` and a package index show of this distribution is there, true, and valid."""

from __future__ import annotations

import re
import tomllib
import zipfile
from pathlib import Path

import pytest
from hatchling.build import build_wheel
from packaging.metadata import Metadata

import trajopt_cli
from trajopt_cli.iiwa.experiments.catalogue import ExperimentsRecord
from trajopt_cli.iiwa.job.folder import TaskRecord
from trajopt_cli.runs.results import PlanRecord

REPOSITORY = Path(__file__).parents[1]
PROJECT = tomllib.loads((REPOSITORY / "pyproject.toml").read_text(encoding="utf-8"))["project"]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> zipfile.ZipFile:
    """The wheel that pip builds from this checkout."""
    folder = tmp_path_factory.mktemp("wheel")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(REPOSITORY)
        return zipfile.ZipFile(folder / build_wheel(str(folder)))


def read(wheel: zipfile.ZipFile, name: str) -> str:
    return wheel.read(f"trajopt_cli-{trajopt_cli.__version__}.dist-info/{name}").decode()


def test_the_built_metadata_is_complete(wheel: zipfile.ZipFile) -> None:
    found = Metadata.from_email(read(wheel, "METADATA"))  # raises for what an index would refuse
    assert (found.name, str(found.version)) == ("trajopt-cli", trajopt_cli.__version__)
    assert (found.license_expression, found.license_files) == ("MIT", ["LICENSE"])
    assert found.author == "trajopt contributors"
    assert found.summary == PROJECT["description"]
    assert found.description == (REPOSITORY / "README.md").read_text(encoding="utf-8")
    assert found.classifiers == PROJECT["classifiers"]
    assert sorted(found.keywords or []) == sorted(PROJECT["keywords"])
    assert str(found.requires_python) == ">=3.11"
    assert sorted(found.provides_extra or []) == ["docs", "mcap", "parquet", "sim", "step", "study", "test"]
    assert not found.project_urls, "name no address that nobody has looked at"


def test_the_licence_goes_with_it(wheel: zipfile.ZipFile) -> None:
    text = read(wheel, "licenses/LICENSE")
    assert text == (REPOSITORY / "LICENSE").read_text()
    assert text.startswith("MIT License\n")


def test_command_and_package_keep_their_names(wheel: zipfile.ZipFile) -> None:
    assert read(wheel, "entry_points.txt").split("\n")[:2] == ["[console_scripts]", "trajopt = trajopt_cli.cli:main"]
    assert {name.split("/")[0] for name in wheel.namelist()} == {
        "trajopt_cli",
        f"trajopt_cli-{trajopt_cli.__version__}.dist-info",
    }
    for name in (
        "py.typed",
        "robots/irb140.urdf",
        "programs/iiwa_cube.yaml",
        "runs/record.py",
        "cell/keys.md",
        "timing/topp_loops.ll",
    ):
        assert f"trajopt_cli/{name}" in wheel.namelist()


def test_no_text_names_a_strangers_package() -> None:
    """`pip install trajopt` is somebody else's; ours is trajopt-cli or a checkout's dot."""
    texts = [
        *REPOSITORY.glob("*.md"),
        *(REPOSITORY / "trajopt_cli").rglob("*.py"),
        *(REPOSITORY / "results").glob("*.md"),
        *(REPOSITORY / "docs").glob("*.md"),
    ]
    for path in texts:
        if path.name == "CHANGELOG.md":  # tells of the old name
            continue
        for command in re.findall(r"pip install[^`\n|&]*", path.read_text(encoding="utf-8")):
            for word in re.findall(r"'?(?<![\w./-])trajopt(?![\w/-])[^\s]*", command):
                raise AssertionError(f"{path}: {command!r} installs {word}")


def test_records_keep_the_versions_of_what_is_required() -> None:
    """What run.json names is a dependency of ours, by the name it is installed under."""
    required = {re.split(r"[<>=!\[]", one)[0] for one in PROJECT["dependencies"]}
    for kind in (PlanRecord, TaskRecord, ExperimentsRecord):
        assert kind.LIBRARIES
        assert set(kind.LIBRARIES) <= required


def test_the_newest_release_notes_are_those_of_this_version() -> None:
    text = (REPOSITORY / "CHANGELOG.md").read_text(encoding="utf-8")
    released = re.findall(r"^## (\S+) – (\d{4}-\d\d-\d\d)$", text, re.MULTILINE)
    assert released[0][0] == trajopt_cli.__version__
    assert "### What breaks silently\n" in text.split(f"## {trajopt_cli.__version__}")[1].split("\n## ")[0]
