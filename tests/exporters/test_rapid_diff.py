from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trajopt_cli.exporters.rapid_diff import patch, relative_names, unified_diff
from trajopt_cli.motion import TextFile

needs_patch = pytest.mark.skipif(shutil.which("patch") is None, reason="the patch command is not there")


def apply(folder: Path, difference: bytes) -> None:
    """Run patch -p1 in folder, which must take every hunk as it is."""
    done = subprocess.run(["patch", "-p1", "--fuzz=0"], cwd=folder, input=difference, capture_output=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert b"offset" not in done.stdout
    assert not [*folder.rglob("*.rej"), *folder.rglob("*.orig")]


LINES = "MODULE m\n    ! Türband\x0c \u2028\n    VAR num n;\n    PROC main()\n        go;\n    ENDPROC\nENDMODULE"


@needs_patch
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16-le"])
@pytest.mark.parametrize("last", [True, False])
def test_patch_gives_the_edited_bytes(tmp_path: Path, end: str, encoding: str, last: bool) -> None:
    text = LINES.replace("\n", end) + (end if last else "")
    new = text.replace("go;", f"go 1;{end}        go 2;").replace("n;", "k;")
    files = {"in/my robot.mod": TextFile("in/my robot.mod", text, encoding), "b.mod": TextFile("b.mod", text, "utf-8")}
    (tmp_path / "in").mkdir()
    for path, file in files.items():
        (tmp_path / path).write_bytes(file.text.encode(file.encoding))
    apply(tmp_path, patch(files, {"in/my robot.mod": new, "b.mod": text}))
    assert (tmp_path / "in/my robot.mod").read_bytes() == new.encode(encoding)
    assert (tmp_path / "b.mod").read_bytes() == text.encode()


SOME_LINES = ["a\r\n", "a\n", "b\r", "é\n", " \n", "-\n", "\\ No newline\n", "--- a/x\n", "+++ b/x\n", "c"]


@needs_patch
@given(
    st.lists(
        st.sampled_from(["a\r\n", "a\n", "b\r", "é\n", " \n", "\\ No newline\n", "--- a/x\n", "+++ b/x\n", "c"]),
        max_size=8,
    ),
    st.lists(st.sampled_from(["a\r\n", "a\n", "b\r", "é\n", " \n", "-\n", "--- a/x\n", "c"]), min_size=1, max_size=8),
)
@settings(max_examples=40, deadline=None)
def test_patch_takes_any_lines(tmp_path_factory: pytest.TempPathFactory, old: list[str], new: list[str]) -> None:
    before, after = "x\n" + "".join(old), "".join(new)
    folder = tmp_path_factory.mktemp("patched")
    (folder / "m.mod").write_bytes(before.encode("cp1252"))
    difference = patch({"m.mod": TextFile("m.mod", before, "cp1252")}, {"m.mod": after})
    if difference:
        apply(folder, difference)
    assert (folder / "m.mod").read_bytes() == after.encode("cp1252")


def test_a_diff_to_read_is_text_whatever_the_encoding() -> None:
    file = TextFile("m.mod", "\ufeff! Tür\r\nx\r\n", "utf-16-le")
    assert unified_diff({"m.mod": file}, {"m.mod": "\ufeff! Tür\r\ny\r\n"}) == (
        "--- a/m.mod\n+++ b/m.mod\n@@ -1,2 +1,2 @@\n \ufeff! Tür\r\n-x\r\n+y\r\n"
    )


@pytest.mark.parametrize(
    ("paths", "names"),
    [
        (["p/a.mod", "./b.mod"], ["p/a.mod", "b.mod"]),
        (["/cell/p/a.mod", "/cell/q/b.mod"], ["p/a.mod", "q/b.mod"]),
        (["../p/a.mod"], ["a.mod"]),
    ],
)
def test_a_patch_names_no_file_outside_the_folder_it_is_applied_in(paths: list[str], names: list[str]) -> None:
    assert [*relative_names(paths).values()] == names


def test_texts_too_different_to_be_compared_line_by_line_are_replaced() -> None:
    """600 equal lines against 1200: a search for what they share would look at every pair."""
    old, new = "a\n" * 600, "b\na\n" * 600
    lines = unified_diff({"m": TextFile("m", old, "utf-8")}, {"m": new}).splitlines()
    assert (lines.count("-a"), lines.count("+b"), lines.count(" a")) == (599, 600, 1)
