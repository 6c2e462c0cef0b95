"""A results folder is somebody else's input: whoever made it knows the format and the hashes. Whatever stands in it,
nothing outside is read as its own or written, nothing has no end, and the answer is one line and exit code 2."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import signal
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from fake_planner import CELL, TEXT

from trajopt_cli.cli import run

SECRET = b"nobody's business\n"
CORNERS = ("5 0 5", "5.1 0 5", "5 0.1 5", "5 0 5.1")  # of a small body far away
BODY = "solid nobody's business\n" + "".join(
    "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {CORNERS[i]}\n" for i in face) + "endloop\nendfacet\n"
    for face in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
) + "endsolid\n"  # fmt: skip
COMMANDS = (
    ["verify", "given"],
    ["export", "joint", "given", "--output", "out.csv"],
    ["export", "gltf", "given", "--output", "out.glb"],
    ["export", "rapid", "given", "--output", "out.mod"],
    ["export", "rapid", "given", "--in-place"],
    ["compare", "runs", "given", "given"],
    ["compare", "baseline", "given"],
    ["sensitivity", "given"],
    ["view", "given", "--print"],
    ["optimize", "tiny.mod", "--output", "given"],
)


@pytest.fixture
def given(results: Path) -> Path:
    """Results of the tiny program as somebody sends them, and a secret beside them. Nothing takes longer than 60 s."""
    results.rename("given")
    Path("secret").write_bytes(SECRET)
    Path("secret.stl").write_text(BODY)
    Path("secrets").mkdir()
    Path("secrets/box.stl").write_text(BODY)
    return Path("given")


@pytest.fixture(autouse=True)
def limited_time() -> Iterator[None]:
    def too_long(*_: object) -> None:
        raise TimeoutError("it has no end")

    signal.signal(signal.SIGALRM, too_long)
    signal.alarm(120)
    yield
    signal.alarm(0)


def record_of(folder: Path) -> dict[str, Any]:
    return dict(json.loads((folder / "run.json").read_text()))


def forged(folder: Path, change: Callable[[dict[str, Any]], None]) -> None:
    record = record_of(folder)
    change(record)
    (folder / "run.json").write_text(json.dumps(record))


def put(folder: Path, name: str, content: bytes | None) -> None:
    """Another content of a file, with its right hash; None: what stands there already."""
    if content is not None:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    digits = hashlib.sha256((folder / name).read_bytes()).hexdigest()

    def change(record: dict[str, Any]) -> None:
        record["files"][name] = digits
        for one in record["inputs"]["files"]:
            if one["copy"] == name:
                one["sha256"] = digits

    forged(folder, change)


def cell_with(text: str) -> Callable[[Path], None]:
    return lambda folder: put(folder, "input/tiny.yaml", (CELL + text).encode())


def listed(name: str) -> Callable[[Path], None]:
    """A name in files that leads to the secret, with its hash."""
    return lambda folder: forged(
        folder, lambda record: record["files"].update({name: hashlib.sha256(SECRET).hexdigest()})
    )


def input_at(key: str, value: str) -> Callable[[Path], None]:
    return lambda folder: forged(folder, lambda record: record["inputs"]["files"][0].update({key: value}))


def instead(name: str, make: Callable[[Path], object]) -> Callable[[Path], None]:
    """Something else under the name of a file of the folder."""

    def change(folder: Path) -> None:
        path = folder / name
        shutil.rmtree(path) if path.is_dir() else path.unlink()
        make(path)

    return change


def sparse(size: int) -> Callable[[Path], None]:
    def make(path: Path) -> None:
        with open(path, "wb") as file:
            file.truncate(size)

    return make


def linked_folder(folder: Path) -> None:
    """input/ itself is a link to a folder elsewhere with the very same files."""
    shutil.move(folder / "input", "elsewhere")
    (folder / "input").symlink_to(Path("elsewhere").absolute())


def mesh_through_a_link(folder: Path) -> None:
    (folder / "input/sub").symlink_to(Path("secrets").absolute())
    cell_with("obstacles: {box: {mesh: {file: sub/box.stl}}}\n")(folder)


def mesh_without_end(folder: Path) -> None:
    os.mkfifo(folder / "input/box.stl")
    cell_with("obstacles: {box: {mesh: {file: box.stl}}}\n")(folder)


def large_mesh(folder: Path) -> None:
    sparse(300_000_000)(folder / "input/box.stl")
    cell_with("obstacles: {box: {mesh: {file: box.stl}}}\n")(folder)


def robot_outside(name: str) -> Callable[[Path], None]:
    return lambda folder: put(folder, "input/tiny.yaml", CELL.replace("irb140", name).encode())


def urdf_outside(folder: Path) -> None:
    """The robot's own file is in the folder, the URDF that it names is not."""
    robots = Path(__file__).parents[2] / "robots"
    text = (robots / "irb140.yaml").read_text().replace("irb140.urdf", "../../../irb140.urdf")
    assert "../../../" in text
    shutil.copy(robots / "irb140.urdf", "irb140.urdf")
    put(folder, "input/robot/mine.yaml", text.encode())
    put(folder, "input/tiny.yaml", CELL.replace("irb140", "mine.yaml").encode())
    digits = record_of(folder)["files"]["input/robot/mine.yaml"]

    def change(record: dict[str, Any]) -> None:
        record["inputs"]["robot"] = "input/robot/mine.yaml"
        own = {"path": "mine.yaml", "copy": "input/robot/mine.yaml", "sha256": digits, "rapid": None, "module": False}
        record["inputs"]["files"].append(own)

    forged(folder, change)


ALIASES = "a: &a [x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{name}: &{name} [{', '.join([f'*{before}'] * 9)}]\n" for before, name in zip("abcdefgh", "bcdefghi", strict=True)
)
ATTACKS: dict[str, Callable[[Path], None]] = {
    "files: above": listed("../secret"),
    "files: absolute": lambda folder: listed(str(Path("secret").absolute()))(folder),
    "files: through above": listed("input/../../secret"),
    "files: not as written": listed("./stream.csv"),
    "files: half a character": listed("\ud800"),
    "copy: above": input_at("copy", "../secret"),
    "copy: not an input": input_at("copy", "stream.csv"),
    "rapid: above": input_at("rapid", "../tiny.mod"),
    "path: of no file": input_at("path", "/"),
    "run.json: a link": instead("run.json", lambda path: path.symlink_to(Path("secret").absolute())),
    "run.json: a pipe": instead("run.json", os.mkfifo),
    "run.json: a folder": instead("run.json", Path.mkdir),
    "run.json: large": instead("run.json", sparse(3_000_000_000)),
    "run.json: deep": instead("run.json", lambda path: path.write_text("[" * 1_000_000)),
    "run.json: a long number": instead(
        "run.json", lambda path: path.write_text('{"format": 1' + "0" * 1_000_000 + "}")
    ),
    "a link": instead("stream.csv", lambda path: path.symlink_to(Path("secret").absolute())),
    "a link to itself": instead("stream.csv", lambda path: path.symlink_to(path.name)),
    "a link to a device": instead("stream.csv", lambda path: path.symlink_to("/dev/zero")),
    "a pipe": instead("stream.csv", os.mkfifo),
    "a large file": instead("stream.csv", sparse(3_000_000_000)),
    "a folder": instead("stream.csv", Path.mkdir),
    "input: a link": linked_folder,
    "mesh: above": cell_with("obstacles: {box: {mesh: {file: ../../secret.stl}}}\n"),
    "mesh: absolute": lambda folder: cell_with(
        f"obstacles: {{box: {{mesh: {{file: {Path('secret.stl').absolute()}}}}}}}\n"
    )(folder),
    "mesh: through a link": mesh_through_a_link,
    "mesh: a pipe": mesh_without_end,
    "mesh: large": large_mesh,
    "robot: above": robot_outside("../../mine.yaml"),
    "robot: absolute": lambda folder: robot_outside(str(Path("mine.yaml").absolute()))(folder),
    "robot: its URDF above": urdf_outside,
    "cell: aliases": cell_with(ALIASES),
    "cell: deep": cell_with("attach: " + "[" * 500 + "\n"),
    "cell: a tag": cell_with("signals: !!python/object/apply:os.system [touch owned]\n"),
    "summary.json: deep": lambda folder: put(folder, "summary.json", b"[" * 1_000_000),
}


@pytest.mark.parametrize("name", ATTACKS)
def test_what_a_folder_may_not_do(
    name: str, given: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trajopt_cli.yaml_file.MAX_NODES", 10_000)  # as many are soon counted
    robots = Path(__file__).parents[2] / "robots"
    for file in ("irb140.yaml", "irb140.urdf"):
        shutil.copy(robots / file, file)
    shutil.copy("irb140.yaml", "mine.yaml")
    ATTACKS[name](given)
    outside = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file() and given not in path.parents}
    capsys.readouterr()
    refused = 0
    for command in COMMANDS[:-1]:
        code = run([*command, "--quiet"] if command[0] != "view" else command)
        said = capsys.readouterr()
        assert "nobody's business" not in said.out + said.err
        assert "Traceback" not in said.err
        if code == 2:
            refused += 1
            assert 1 <= len(said.err.splitlines()) <= 21, (command, said.err)
            assert max(map(len, said.err.splitlines())) < 1000
    # what reads only a part of the folder may not meet it
    assert refused >= 3, name
    found = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file() and given not in path.parents}
    assert {path: text for path, text in found.items() if path in outside} == outside
    new = {path.parts[0] for path in found if path not in outside}
    assert new <= {"out.csv", "out.glb", "out.mod", "results", "tiny.mod.bak"}


def test_the_body_outside_is_one_that_would_be_read(given: Path) -> None:
    """So that it is the link, not the file, for which the folder is refused."""
    shutil.copy("secrets/box.stl", given / "input/box.stl")
    cell_with("obstacles: {box: {mesh: {file: box.stl}}}\n")(given)
    assert run(["verify", "given", "--quiet"]) == 0


def test_a_large_mesh_is_not_read(given: Path, capsys: pytest.CaptureFixture[str]) -> None:
    large_mesh(given)
    assert run(["verify", "given"]) == 2
    assert "has 300 MB, at most 200 MB are read; give a coarser one" in capsys.readouterr().err


def test_a_hard_link_is_read_and_never_written(given: Path) -> None:
    """The folder is replaced as a whole; what its files share with others stays theirs."""
    target = Path("elsewhere.csv")
    target.write_bytes((given / "stream.csv").read_bytes())
    (given / "stream.csv").unlink()
    os.link(target, given / "stream.csv")
    before = target.read_bytes()
    assert run(["verify", "given", "--quiet"]) == 0
    assert run(["optimize", "tiny.mod", "--output", "given", "--quiet"]) == 0
    assert target.read_bytes() == before
    assert not os.path.samefile(target, given / "stream.csv")


def test_a_link_in_the_folder_is_not_followed_when_it_is_replaced(
    given: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("more", "input/more"):
        (given / name).symlink_to(Path("secrets").absolute())
        assert run(["optimize", "tiny.mod", "--output", "given", "--quiet"]) == 2
        assert f"given: holds {name}, which trajopt did not write" in capsys.readouterr().err
        (given / name).unlink()
    assert Path("secrets/box.stl").read_text() == BODY


@pytest.mark.parametrize("place", [".bashrc", "authorized_keys", "tiny.yaml", "job.desktop"])
def test_in_place_writes_over_rapid_modules_alone(
    place: str, given: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A folder that says that its module was read from a file whose content anybody can guess."""
    victim = tmp_path / place
    victim.write_text(TEXT)
    put(given, "program.mod", TEXT.encode() + b"! echo owned\n")
    input_at("path", str(victim))(given)
    assert run(["export", "rapid", "given", "--in-place"]) == 2
    said = capsys.readouterr().err
    assert f"{victim}: is no RAPID module by its name (.mod, .prg, .sys, .modx, .sysx), and is not written over" in said
    assert victim.read_text() == TEXT


LISTS = {
    "above": "<Program><Module>../secret.mod</Module></Program>",
    "absolute": "<Program><Module>/etc/passwd</Module></Program>",
    "entities": '<!DOCTYPE a [<!ENTITY b "cc"><!ENTITY d "&b;&b;">]><Program><Module>&d;</Module></Program>',
    "outside": '<!DOCTYPE a SYSTEM "file:///etc/passwd"><Program><Module>a.mod</Module></Program>',
    "a pipe": "<Program><Module>pipe.mod</Module></Program>",
    "deep": "<a>" * 100_000,
}


@pytest.mark.parametrize("name", LISTS)
def test_a_program_list(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "backup"
    folder.mkdir()
    os.mkfifo(folder / "pipe.mod")
    (tmp_path / "secret.mod").write_bytes(SECRET)
    (folder / "p.pgf").write_text(LISTS[name])
    assert run(["parse", str(folder / "p.pgf")]) == 2
    said = capsys.readouterr().err
    assert len(said.splitlines()) == 1
    assert "nobody's business" not in said
