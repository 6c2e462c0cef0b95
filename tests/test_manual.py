r"""The manual is true: what its pages tell to run is run, what they show is held against what is printed.

Each page has a folder of its own, with the repository's programs and robots, in which its blocks run in order:
bash: every line, streams unrefined. console: lines after "$ ", their output as shown, streams unrefined where no
figure of it is shown; a line "..." stands for any lines, "..." within one for any characters. python: run. yaml: read
as cell or task, or as a part of one. rapid: parsed. xml: parsed.
Comments before a block: <!-- file: NAME --> writes it there first, <!-- after: COMMAND && COMMAND --> runs these
first, <!-- not run: REASON -->.
"""

from __future__ import annotations

import io
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import pytest
from ruamel.yaml import YAML
from typer.main import get_command
from unrefined import IMPROVED, as_it_comes, set_defaults

from trajopt_cli.cell.document import CellDocument
from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.cli import app, run
from trajopt_cli.graph_search.sequence import best_order
from trajopt_cli.iiwa.task.document import TaskDocument
from trajopt_cli.iiwa.task.loader import parse_task
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.robot.catalogue import SixAxisFile

REPOSITORY = Path(__file__).parents[1]
PAGES = [REPOSITORY / "README.md", *sorted((REPOSITORY / "docs").glob("*.md"))]
BLOCK = re.compile(r"((?:<!--[^\n]*-->\n)*)```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LONG = ("backup", "bound", "exports", "iiwa", "order", "rail", "terminal", "your-robot")
RUN = ("bash", "console", "python", "yaml", "rapid", "xml")
CELL = 'robot: irb140_rail\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}\nrail: {eax: a, stroke: [0, 2]}\n'
COMMANDS = get_command(app)
SHELL = re.compile(r"[|>&]|^(?!trajopt )|--install-completion")


@dataclass(frozen=True)
class Block:
    """A fenced block with the comments before it, by name."""

    page: str
    language: str
    text: str
    notes: dict[str, str]


def blocks(page: Path) -> Iterator[Block]:
    for comments, language, text in BLOCK.findall(page.read_text(encoding="utf-8")):
        notes = dict(re.findall(r"<!-- ([a-z ]+): (.*?) -->", comments))
        if (language in RUN or "file" in notes) and not {"not run", "command"} & set(notes):
            yield Block(page.name, language, text, notes)


class Folder:
    """Where one page's blocks run. Plans of programs that ship are made once for all pages."""

    def __init__(self, root: Path, plans: dict[str, tuple[Path, str]]):
        self.root, self.plans = root, plans
        for name in ("programs", "robots"):
            shutil.copytree(REPOSITORY / name, root / name)
        tools = root / ".bin"
        tools.mkdir()
        (tools / "trajopt").write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m trajopt_cli.cli "$@"\n')
        (tools / "trajopt").chmod(0o755)
        self.environment = {
            **os.environ,
            "PATH": f"{tools}:{os.environ['PATH']}",
            "PYTHONPATH": str(REPOSITORY),
            "HOME": str(root),
        }

    def command(self, line: str) -> str:
        """Run one line and give what it prints. It has to end well."""
        line = line.split("  #")[0].strip()
        if SHELL.search(line):
            # a last command of bash's own: the parent of the one before it is a shell, whoever runs the tests
            asked = ["bash", "-euo", "pipefail", "-c", f"{line}\n:"]
            done = subprocess.run(asked, cwd=self.root, env=self.environment, capture_output=True)
            assert done.returncode == 0, f"{line}\n{done.stderr.decode()}"
            return done.stdout.decode()
        if line in self.plans and not (self.root / "results").exists():
            folder, printed = self.plans[line]
            shutil.copytree(folder, self.root / "results")
            return printed
        out, err = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", write_through=True), io.StringIO()
        try:
            with redirect_stdout(out), redirect_stderr(err):
                code = run(shlex.split(line)[1:])
        except SystemExit as stopped:
            code = int(stopped.code or 0)
        assert code == 0, f"{line}\n{err.getvalue()}"
        printed = out.buffer.getvalue().decode()
        if line.startswith("trajopt optimize programs/"):
            kept = self.root.parent / f"plans-{len(self.plans)}"
            shutil.copytree(self.root / "results", kept)
            self.plans[line] = kept, printed
        return printed


def alike(shown: str, printed: str) -> bool:
    """Whether what is printed is what is shown, where it says something."""
    wanted = [
        r"(?:.*\n)*?" if line == "..." else ".*?".join(re.escape(part) for part in line.rstrip().split("...")) + r" *\n"
        for line in shown.splitlines()
    ]
    return re.fullmatch("".join(wanted) + r"\n*", printed) is not None


def dialogue(text: str) -> list[tuple[str, str]]:
    """The commands of a console block with the output that is shown."""
    parts = re.split(r"^\$ (.*)\n", text, flags=re.MULTILINE)
    assert not parts[0], "output without a command"
    return list(zip(parts[1::2], parts[2::2], strict=True))


def read_yaml(text: str) -> None:
    """A cell, a task or a robot's file, or keys of one put into one that ships."""
    content = YAML(typ="safe").load(text)
    if "profiles" in content:
        base = YAML(typ="safe").load((REPOSITORY / "robots/irb140.yaml").read_text(encoding="utf-8"))
        SixAxisFile.model_validate(base | content)
        return
    if set(content) <= set(CellDocument.model_fields):
        kept = "".join(line for line in CELL.splitlines(True) if line.split(":")[0] not in content)
        parse_cell(text if {"robot", "start"} <= set(content) else kept + text, "manual.yaml")
        return
    assert set(content) <= set(TaskDocument.model_fields), sorted(content)
    base = (REPOSITORY / "programs/iiwa_cube.yaml").read_text(encoding="utf-8")
    kept = re.sub(rf"^({'|'.join(content)}):.*\n(?:[ #].*\n|\n)*", "", base, flags=re.MULTILINE)
    parse_task(text if "K" in content else f"{kept}\n{text}", "manual.yaml")


def read_rapid(text: str) -> None:
    wrapped = text if text.lstrip().upper().startswith("MODULE") else f"MODULE m\nPROC main()\n{text}ENDPROC\nENDMODULE"
    parse_module(wrapped, "manual.mod")


@contextmanager
def in_short() -> Iterator[None]:
    """For what prints nothing that is shown: streams unrefined, of many places that may be good one planned whole."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(IMPROVED, as_it_comes)
        patch.setattr("trajopt_cli.study.place.FEW", 1)
        yield


@pytest.fixture(scope="session")
def plans() -> dict[str, tuple[Path, str]]:
    return {}


@pytest.mark.parametrize(
    "page",
    [
        pytest.param(page, id=page.name, marks=[pytest.mark.long] if page.stem in LONG else [])
        for page in PAGES
        if any(blocks(page))
    ],
)
def test_what_a_page_tells_to_do_can_be_done_and_says_what_is_shown(
    page: Path, tmp_path: Path, plans: dict[str, tuple[Path, str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    from trajopt_cli.report import pictures

    root = tmp_path / "page"
    root.mkdir()
    folder = Folder(root, plans)
    monkeypatch.chdir(root)
    for name in ("PLANNED", "_NEAR"):  # orders of which no page shows a figure
        monkeypatch.setattr(f"trajopt_cli.study.order.{name}", 0)
    set_defaults(monkeypatch, coarse_spacing=0.4)  # nor of their model
    # nor of the nearest neighbour's plan: its order is the model's best, which is planned anyway
    monkeypatch.setattr("trajopt_cli.graph_search.sequence.nearest_order", lambda steps: best_order(steps)[1])
    for name, shown in (("PICTURES", ("rail",)), ("STEP_PICTURES", ())):  # pictures that no page calls by their file
        table = getattr(pictures, name)
        monkeypatch.setattr(pictures, name, {picture: table[picture] for picture in shown})
    names: dict[str, object] = {}
    for block in blocks(page):
        if "file" in block.notes:
            (root / block.notes["file"]).parent.mkdir(parents=True, exist_ok=True)
            (root / block.notes["file"]).write_text(block.text, encoding="utf-8")
        if "after" in block.notes:
            for line in block.notes["after"].split(" && "):
                folder.command(line)
        match block.language:
            case "bash":
                with in_short():
                    for line in block.text.splitlines():
                        folder.command(line)
            case "console":
                for line, shown in dialogue(block.text):
                    with nullcontext() if re.search(r"\d", shown) else in_short():
                        printed = folder.command(line)
                    assert alike(shown, printed), f"{line} prints\n{printed}"
            case "python":
                exec(compile(block.text, page.name, "exec"), names)
            case "yaml":
                read_yaml(block.text)
            case "rapid":
                read_rapid(block.text)
            case "xml":
                ElementTree.fromstring(block.text)


def spoken_of() -> list[tuple[str, str]]:
    """Page and command of every command line that stands in a sentence, a table, or a block that is not run."""
    found = []
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        lines = [" ".join(code.split()) for code in re.findall(r"`(trajopt [^`]+)`", text)]
        fenced = "".join(re.findall(r"^```\w+\n(.*?)^```$", text, re.MULTILINE | re.DOTALL))
        lines += re.findall(r"^(?:\$ )?(trajopt [a-z].*)$", fenced, re.MULTILINE)
        found += [(page.name, line.split("  #")[0]) for line in lines]
    return sorted(set(found))


@pytest.mark.parametrize(("page", "line"), spoken_of())
def test_commands_that_are_spoken_of_exist(page: str, line: str) -> None:
    command = COMMANDS
    words = [word for part in line.split() for word in part.strip("[]").split("|")]
    options = {name for name in words if re.fullmatch(r"--[a-z-]+", name)}
    for word in words[1:]:
        inner = getattr(command, "commands", None)
        if inner is None or word.startswith("-"):
            break
        if word.isupper():  # COMMAND or FORMAT: any of them
            return
        assert word in inner, f"there is no 'trajopt {word}'"
        command = inner[word]
        if f" {word}|" in line:  # `export joint|ros2`: the others are its neighbours
            break
    known = {name for parameter in command.params for name in parameter.opts} | {"--help"}
    assert options <= known, options - known


def test_what_is_not_run_says_why() -> None:
    found = [note for page in PAGES for note in re.findall(r"<!-- not run:(.*?)-->", page.read_text(encoding="utf-8"))]
    assert all(len(note.strip()) > 10 for note in found)
    assert len(found) < 10


@pytest.mark.parametrize(
    ("shown", "printed", "same"),
    [
        ("a\n...\nc 1...\n", "a\nb\nb\nc 1.5\n", True),
        ("a\n", "a   \n\n", True),
        ("...\nc\n", "c\n", True),
        ("a\nc\n", "a\nb\nc\n", False),
        ("T = 1.5 s\n", "T = 1.6 s\n", False),
        ("...\nc\n", "c\nd\n", False),
    ],
)
def test_what_counts_as_shown(shown: str, printed: str, same: bool) -> None:
    assert alike(shown, printed) is same
