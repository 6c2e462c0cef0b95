"""The manual as web pages: built without a warning, whole, and without an address outside."""

from __future__ import annotations

import html
import io
import os
import re
import subprocess
import sys
import warnings
from contextlib import redirect_stderr
from pathlib import Path

import pytest

from trajopt_cli.rapid.execution.table import FUNCTIONS, INSTRUCTIONS

REPOSITORY = Path(__file__).parents[1]
IMAGES = REPOSITORY / "docs" / "images"


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The pages by name, built as .ci/run does. A proxy that is not there stands for the network."""
    from sphinx.cmd.build import build_main

    out, said = tmp_path_factory.mktemp("site"), io.StringIO()
    with pytest.MonkeyPatch.context() as patch, redirect_stderr(said), warnings.catch_warnings():
        warnings.simplefilter("error")
        for kind in (DeprecationWarning, PendingDeprecationWarning, ResourceWarning):  # as where no test runs
            warnings.simplefilter("ignore", kind)
        patch.setattr(sys, "path", [*sys.path])
        patch.setenv("COLUMNS", "92")  # as what is generated sets it, so that it is put back
        for name in ("http_proxy", "https_proxy", "all_proxy"):
            patch.setenv(name, "http://127.0.0.1:9")
        patch.setattr("sphinx.search.en.SearchEnglish.stem", lambda _, word: word)  # of an index that nobody searches
        places = [f"{out / 'trees'}", f"{REPOSITORY / 'docs'}", f"{out / 'site'}"]
        built = build_main(["-W", "--keep-going", "-q", "-d", *places])
    assert (built, said.getvalue()) == (0, "")
    return {page.name: page.read_text(encoding="utf-8") for page in (out / "site").glob("*.html")}


def shown(page: str) -> str:
    return html.unescape(re.sub(r"<[^>]+>", "", page))


@pytest.mark.long
def test_nothing_is_fetched(site: dict[str, str]) -> None:
    for name, page in site.items():
        loaded = re.findall(r"<(?:script|img|iframe|source)[^>]*\ssrc=\"([^\"]*)", page)
        loaded += re.findall(r"<link[^>]*\shref=\"([^\"]*)", page)
        assert loaded
        assert [address for address in loaded if re.match(r"(https?:)?//", address)] == [], name


def test_no_part_was_left_unmade(site: dict[str, str]) -> None:
    assert not [name for name, page in site.items() if "at build -->" in page]


def test_what_is_generated_stands_in_the_checkout() -> None:
    """Else `python docs/generated.py` writes it anew."""
    ask = "import generated; print([p.name for p, t in generated.pages().items() if p.read_text('utf-8') != t])"
    world = {**os.environ, "PYTHONPATH": str(REPOSITORY)}
    command = [sys.executable, "-c", ask]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=REPOSITORY / "docs", env=world)
    assert done.stdout.strip() == "[]"


def test_every_command_has_its_help(site: dict[str, str]) -> None:
    text = shown(site["cli.html"])
    usage = re.search(r"```text\n(trajopt .+?)```", (REPOSITORY / "docs" / "commands.md").read_text(), re.DOTALL)
    assert usage
    for line in usage[1].splitlines():
        words = re.match(r"trajopt(?: [a-z]+\d?(?![\w|.]))+", line)
        assert words
        assert f"Usage: {words[0]} [" in text, line


def test_every_instruction_and_function_is_listed_once(site: dict[str, str]) -> None:
    cells = re.findall(r'<span class="pre">(\w+)</span>', site["rapid.html"])
    for name in (*INSTRUCTIONS, *FUNCTIONS):
        assert cells.count(name) == 1, name


def test_the_keys_of_all_sections_are_listed(site: dict[str, str]) -> None:
    wanted = {
        "cell-file.html": ("rail.frame.wxyz", "limits.NAME.jerk", "obstacles.NAME.capsule.from", "hold_rail.gripper"),
        "task-file.html": ("poses[].by", "changes[].clamps.torque", "contact.obstacles.NAME.box.size"),
        "robot-file.html": ("profiles.NAME.acceleration.NAME.grade", "confdata.rule"),
    }
    for page, keys in wanted.items():
        for key in keys:
            assert f'<span class="pre">{key}</span>' in site[page], key


def test_the_functions_of_the_door_are_documented(site: dict[str, str]) -> None:
    page = site["python.html"]
    for name in ("read_program", "load_cell", "build_plant", "build_problem", "optimize", "verify", "export"):
        assert re.search(rf'id="trajopt_cli\.[\w.]+\.{name}"', page), name
    assert "Raises InputError" in shown(page)


def test_formulas_have_their_subscripts(site: dict[str, str]) -> None:
    page = site["mathematics.html"]
    assert "q<sub>arm</sub> = IK(X(s)" in page
    assert re.findall(r"\b[A-Za-z]_\w+|_\{", shown(re.sub(r"<code.*?</code>", "", page, flags=re.DOTALL))) == []


def test_pictures_are_small_and_have_what_makes_them() -> None:
    made = (IMAGES / "make").read_text(encoding="utf-8")
    pictures = sorted(path.name for path in IMAGES.glob("*.png"))
    assert pictures
    for name in pictures:
        assert (IMAGES / name).stat().st_size <= 200_000, name
        assert name in made, name
