"""Everything that trajopt reads, each as a function of one file's bytes, and the same as a command line.

A reader has seeds, words of its format, `read`, which calls the library on a file in an empty folder, and `command`,
which has the same file read by a command. `workspace` makes what they need besides: a program with its cell, a small
results folder of either job.
"""

from __future__ import annotations

import hashlib
import json
import os
import random
import re
import shutil
from collections.abc import Callable, Sequence
from copy import deepcopy
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path

import numpy as np
from fuzz_mutate import mutated, words
from invented_rapid import NUMBERS, WORDS, Inventor
from rapid_printer import print_file

from trajopt_cli.errors import InputError
from trajopt_cli.motion import TextFile
from trajopt_cli.scenario import Scenario

REPOSITORY = Path(__file__).parents[2]
CORPUS = Path(__file__).parent / "corpus"
GOLDEN = REPOSITORY / "tests" / "rapid" / "golden"
SMALL = 12_000  # bytes of a shipped file that is a seed

PROGRAM = """MODULE Tiny
    CONST jointtarget j_side:=[[5,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveAbsJ j_side, v1000, fine, tool0;
        WaitTime 0.1;
        MoveL Offs(CRobT(\\Tool:=tool0),0,0,20), v200, fine, tool0;
    ENDPROC
ENDMODULE
"""
CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n"
TASK = """robot: iiwa7
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
h: 10 ms
tool: {position: [0, 0, 0.05]}
poses:
  - {name: start, at: start}
  - [0.52, 0.0, 0.24, 0, 0, 0]
  - {by: [0, 0.02, 0, 0, 0, 0.1]}
v_max: 0.1 m/s
omega_max: 30 deg/s
a_max: 0.8 m/s2
epsilon_max: 3 rad/s2
K: [1000, 1000, 1000, 60, 60, 60]
D: [400, 400, 400, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""
POSES = """x [mm],y [mm],z [mm],alpha [deg],beta [deg],gamma [deg]
520,0,240,0,0,0
521,1,240,0,0,1
522,2,240,0,0,2
"""
CUBE = """solid cube
facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet
facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet
facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet
facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet
endsolid cube
"""
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
LIST = '<?xml version="1.0" encoding="ISO-8859-1" ?>\n<Program>\n\t<Module>tiny.mod</Module>\n</Program>\n'
YAML_WORDS = (
    *words("robot start joints rail eax stroke limits velocity acceleration source deg mm rad/s scenario signals"),
    *words("obstacles box capsule mesh fence file scale attach tcp profile jerk grade poses by at name null ~"),
    *words("!!binary &a *a << { } [[ ]] | > irb140_rail iiwa7 ' \""),
    *("? ", "- "),
)
URDF_WORDS = (
    *words("link joint origin xyz rpy axis limit lower upper velocity effort revolute continuous prismatic fixed"),
    *words("parent child mesh filename mimic multiplier floating scale xacro:macro &amp; &a; <!-- --> <![CDATA[ ]]>"),
    *("<?x?>", "<!DOCTYPE a>"),
)
JSON_WORDS = (
    *words('null true false {} [] "" 1e999 NaN -Infinity "\\ud800" "../x" "/etc/passwd" "a\\u0000b"'),
    *words('"format" "kind" "files" "inputs" "options" "motions" "index"'),
)
STL_WORDS = ("solid", "facet", "normal", "outer", "loop", "vertex", "endloop", "endfacet", "endsolid")


@dataclass(frozen=True)
class Reader:
    """How one kind of file is read. name: of the reader; file: how the case is called in its folder.

    read(path) calls the library, command(path) gives the command line that reads the same; without read, every case
    is a command. make(rng, seeds) gives a case. deep(path): what is done with a file that could be read.
    """

    name: str
    file: str
    seeds: Sequence[bytes]
    words: Sequence[str]
    read: Callable[[Path], object] | None
    command: Callable[[Path], list[str]]
    deep: Callable[[Path], object] | None = None
    make: Callable[[random.Random, Sequence[bytes]], bytes] | None = None
    place: Callable[[Path, bytes], Path] | None = None

    def case(self, rng: random.Random, seeds: Sequence[bytes]) -> bytes:
        return self.make(rng, seeds) if self.make else mutated(rng, seeds, self.words)

    def write(self, folder: Path, data: bytes) -> Path:
        """The case as a file of an otherwise empty folder."""
        if self.place is not None:
            return self.place(folder, data)
        path = folder / self.file
        path.write_bytes(data)
        return path


@dataclass(frozen=True)
class Workspace:
    """A folder with a program and its cell, small results folders of either job, and a robot's own files."""

    folder: Path

    @property
    def program(self) -> Path:
        return self.folder / "tiny.mod"

    @property
    def results(self) -> Path:
        return self.folder / "results"

    @property
    def task_results(self) -> Path:
        return self.folder / "task_results"


def workspace(folder: Path) -> Workspace:
    """Make it, in a second of processor."""
    from trajopt_cli.iiwa.job.segments import make_segments
    from trajopt_cli.job import read_job
    from trajopt_cli.pipeline.optimize import OptimizedJob, optimize_job
    from trajopt_cli.problem.plan import Target

    here = Workspace(folder)
    here.program.write_text(PROGRAM)
    (folder / "tiny.yaml").write_text(CELL)
    (folder / "task.yaml").write_text(TASK)
    (folder / "cube.stl").write_text(CUBE)
    (folder / "poses.csv").write_text(POSES)
    (folder / "tiny.pgf").write_text(LIST)
    answer = optimize_job(read_job(here.program), Target.STREAM, here.results, lambda *_: None, jobs=1)
    assert isinstance(answer, OptimizedJob), answer
    make_segments(folder / "task.yaml", here.task_results, None, None)
    (folder / "log.csv").write_text(_log())
    for one in ("irb140.yaml", "irb140.urdf"):
        shutil.copy(REPOSITORY / "robots" / one, folder / f"own{Path(one).suffix}")
    (here.results / "report.html").write_text("<!DOCTYPE html><html></html>")
    for name in ("trajectory.csv", "stream.csv", "rapid.csv"):
        file = here.results / name
        lines = file.read_text().splitlines(keepends=True)
        file.write_text("".join([lines[0], *lines[1:-1:12], lines[-1]]))
    rehash(here.results)
    return here


def rehash(folder: Path) -> None:
    """Let run.json say the hashes of the files as they are, as somebody would who damages a folder with care."""
    place = folder / "run.json"
    try:
        record = json.loads(place.read_bytes())
        for name in record["files"]:
            content = (folder / name).read_bytes()
            record["files"][name] = hashlib.sha256(content).hexdigest()
        for one in record["inputs"]["files"]:
            one["sha256"] = record["files"][one["copy"]]
        text = json.dumps(record)
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return  # too much damaged for that
    place.unlink()  # it may be a hard link
    place.write_text(text)


def _log() -> str:
    """Ten seconds of joints between two places, every 10 ms, as a controller logs them."""
    t = np.arange(0, 10, 0.02)
    way = np.clip(np.abs((t % 4) - 2) - 0.5, 0, 1) * 20
    rows = ["time [s]," + ",".join(f"joint_{i} [deg]" for i in range(1, 7))]
    rows += [f"{a:.3f}," + ",".join(f"{b * i / 6:.4f}" for i in range(1, 7)) for a, b in zip(t, way, strict=True)]
    return "\n".join(rows[:260]) + "\n"


def corpus(name: str) -> list[bytes]:
    """The cases of a reader that are kept in the repository."""
    folder = CORPUS / name
    return [file.read_bytes() for file in sorted(folder.iterdir())] if folder.is_dir() else []


def _files(*places: Path | str) -> list[bytes]:
    paths = [Path(place) for place in places]
    return [data for path in paths if len(data := path.read_bytes()) <= SMALL]


# ------------------------------------------------------------------------------------------------------- the readers

_SCENARIO = Scenario(endless_passes=2, pass_limit=300, statement_limit=20_000)


def _read_rapid(path: Path) -> str:
    """Read, printed and read again, and run; what the scenario lacks is given a few times."""
    from trajopt_cli.rapid.language.parser import parse_module
    from trajopt_cli.rapid.language.text import decode
    from trajopt_cli.rapid.listing import describe
    from trajopt_cli.rapid.reader import try_program

    text, encoding = decode(path.read_bytes())
    file = TextFile(path.name, text, encoding)
    tree = parse_module(text, file.path)
    try:
        assert parse_module(print_file(tree), file.path) == tree, "printed, it reads as another tree"
    except InputError as error:
        if "nested deeper" not in str(error):  # the print has parentheses of its own, each a level
            raise
    scenario = _SCENARIO
    for _ in range(3):
        program, lacks = try_program([file], scenario)
        if not lacks:
            describe(program)
            return "run"
        given: dict[str, dict[str, float]] = {lack.section: {} for lack in lacks}
        for lack in lacks:
            given[lack.section][lack.name.lower()] = 1.0 if lack.section != "searches" else 0.5
        scenario = replace(
            scenario,
            signals={**scenario.signals, **given.get("signals", {})},
            answers={**scenario.answers, **given.get("answers", {})},
            searches={**scenario.searches, **given.get("searches", {})},
            assume_identity=scenario.assume_identity | set(given.get("assume_identity", {})),
        )
    return "lacking"


def _make_rapid(rng: random.Random, seeds: Sequence[bytes]) -> bytes:
    return mutated(rng, seeds, [*WORDS, *NUMBERS]) if rng.random() < 0.8 else Inventor(rng).program()


def _read_cell(path: Path) -> object:
    from trajopt_cli.cell.loader import load_cell

    return load_cell(path)


def _build_cell(path: Path) -> object:
    from trajopt_cli.cell.loader import load_cell
    from trajopt_cli.problem.plant import build_plant

    return build_plant(load_cell(path))


def _beside(here: Workspace, *names: str) -> Callable[[Path, bytes], Path]:
    """The case beside files of the workspace, by links: names[0] is its own."""

    def place(folder: Path, data: bytes) -> Path:
        for name in names[1:]:
            os.link(here.folder / name, folder / name)  # a symbolic one leads out
        path = folder / names[0]
        path.write_bytes(data)
        return path

    return place


MOC = """MOC:CFG_1.0:6:0::
#
MECHANICAL_UNIT:

      -name "TRACK" -use_single_0 "TRACK" -activate_at_start_up \\
      -deactivation_forbidden
#
ROBOT:

      -name "ROB_1" -use_robot_type "ROB1_140_0.81_5" -base_frame_pos_x 0.5 -base_frame_coordinated "TRACK"
#
SINGLE:

      -name "TRACK" -use_single_type "TRACK" -use_joint "track1" -base_frame_orient_u0 0.707107\\
      -base_frame_orient_u3 0.707107

      -name "STN1" -use_single_type "IRBP_L" -use_joint "stn1"
#
JOINT:

      -name "track1" -use_arm "track1" -logical_axis 7

      -name "stn1" -use_arm "stn1" -logical_axis 8
#
ARM:

      -name "rob1_1" -upper_joint_bound 2.7 -lower_joint_bound -2.7

      -name "track1" -upper_joint_bound 0.8 -lower_joint_bound 0.1
"""


def _read_moc(path: Path) -> object:
    """The cell file that is made of it can be read."""
    from trajopt_cli.adopt.backup import cell_from_backup
    from trajopt_cli.cell.loader import parse_cell

    text, _, _ = cell_from_backup(path.parents[1], path.parents[2] / "fuzz", None)
    return parse_cell(text, "fuzz.yaml")


def _moc_place(folder: Path, data: bytes) -> Path:
    path = folder / "backup" / "SYSPAR" / "MOC.cfg"
    path.parent.mkdir(parents=True)
    path.write_bytes(data)
    return path


def _results_place(source: Path, folder: Path, data: bytes) -> Path:
    """A results folder in which one file is the case: `NAME`, or `NAME=` where run.json keeps the old hash, and a line
    feed before it; the others are hard links."""
    head, _, content = data.partition(b"\n")
    name = head.decode("utf-8", "replace")
    keep, name = name.endswith("="), name.removesuffix("=")
    out = folder / "run"
    for file in sorted(source.rglob("*")):
        place = out / file.relative_to(source)
        if file.is_dir():
            place.mkdir(parents=True, exist_ok=True)
        else:
            place.parent.mkdir(parents=True, exist_ok=True)
            os.link(file, place)  # a symbolic link would be refused
    known = {str(file.relative_to(source)) for file in source.rglob("*") if file.is_file()}
    if name in known:
        (out / name).unlink()
        (out / name).write_bytes(content)
        if not keep and name != "run.json":
            rehash(out)
    return out


def _make_results(rng: random.Random, seeds: Sequence[bytes]) -> bytes:
    seed = rng.choice(seeds)
    head, _, content = seed.partition(b"\n")
    bodies = [one.partition(b"\n")[2] for one in seeds]
    others = [content] * 9 + bodies[:3]
    keep = b"=" if rng.random() < 0.05 else b""
    if rng.random() < 0.5 and content[:1] == b"{":
        return head.removesuffix(b"=") + keep + b"\n" + _json_changed(rng, content)
    return head.removesuffix(b"=") + keep + b"\n" + mutated(rng, [rng.choice(others)], JSON_WORDS)


def _json_changed(rng: random.Random, content: bytes) -> bytes:
    """A JSON text with a value of another kind somewhere in it, or a key missing or more."""
    try:
        record = json.loads(content)
    except ValueError:
        return content
    strange = (
        None,
        True,
        0,
        -1,
        1e308,
        2**70,
        "",
        "../x",
        "/",
        "a\0b",
        "\ud800",
        [],
        {},
        [[]],
        "x" * 3000,
        -0.5,
        [None],
        {"a": 1},
    )
    for _ in range(rng.choice((1, 1, 2, 4))):
        node = record
        while True:
            keys = list(node) if isinstance(node, dict) else list(range(len(node)))
            if not keys:
                break
            key = rng.choice(keys)
            if isinstance(node[key], dict | list) and rng.random() < 0.8:
                node = node[key]
                continue
            kind = rng.randrange(5)
            if kind == 0:
                del node[key]
            elif kind == 1 and isinstance(node, dict):
                node[rng.choice(("", "x", "../y", "format"))] = deepcopy(node[key])  # twice itself may hold itself
            elif kind == 2 and isinstance(node, list):
                node.append(deepcopy(node[key]))
            elif kind == 3 and isinstance(node[key], int | float):
                node[key] = rng.choice((-node[key], node[key] + 1, node[key] * 1e9))
            else:
                node[key] = deepcopy(rng.choice(strange))
            break
    return json.dumps(record).encode()


def _read_plan_folder(path: Path) -> object:
    from trajopt_cli.job import read_results_job
    from trajopt_cli.pipeline.folder import rapid_export
    from trajopt_cli.runs.compared import compare_runs
    from trajopt_cli.runs.results import read_results

    read_results(path)
    rapid_export(path)
    compare_runs([path, path])
    return read_results_job(path)


def _judge_plan_folder(path: Path) -> object:
    from trajopt_cli.pipeline.folder import plans_of_results, verify_results

    job, reports = verify_results(path)
    plans_of_results(path, job)
    return reports


def _read_task_folder(path: Path) -> object:
    from trajopt_cli.iiwa.job.folder import open_folder

    return open_folder(path)


def _judge_task_folder(path: Path) -> object:
    from trajopt_cli.iiwa.judge.verify import verify_folder

    return verify_folder(path)


def _read_csv(path: Path) -> object:
    from trajopt_cli.joint_csv import read_csv_text
    from trajopt_cli.pipeline.folder import _text

    return read_csv_text(_text(path), path.name)


def _judge_csv(program: Path, path: Path) -> object:
    from trajopt_cli.pipeline.folder import verify_file

    return verify_file(path, _job(program))


@cache
def _job(program: Path) -> object:
    from trajopt_cli.job import read_job

    return read_job(program)


def _read_iiwa_csv(path: Path) -> object:
    from trajopt_cli.joint_csv import read_csv_text

    return read_csv_text(path.read_bytes().decode("ascii", "replace"), path.name)


def _judge_iiwa_csv(path: Path) -> object:
    from trajopt_cli.iiwa.judge.verify import verify_joints

    return verify_joints(path, None)


def _read_task(path: Path) -> object:
    from trajopt_cli.iiwa.task.loader import load_task

    return load_task(path)


def _read_poses(path: Path) -> object:
    from trajopt_cli.iiwa.task.model import AngleMeaning
    from trajopt_cli.iiwa.task.path_csv import read_path, read_text

    return read_path(read_text(str(path)), path.name, AngleMeaning.RELATIVE, np.eye(3))


def _read_urdf(path: Path) -> object:
    from trajopt_cli.adopt.add import new_robot

    made = new_robot(path, "made", track=True)
    assert set(made.files) == {f"made{rail}.{kind}" for rail in ("", "_rail") for kind in ("urdf", "yaml")}
    return made


def _read_robot(path: Path) -> object:
    from trajopt_cli.robot.description import read
    from trajopt_cli.robot.model import Structure, load_robot
    from trajopt_cli.robot.srs import load_srs

    data, _, _ = read(str(path))
    return load_srs(str(path)) if data.structure is Structure.SRS else load_robot(str(path))


@cache
def _limits() -> object:
    from trajopt_cli.measured.limits_file import limits_in_force

    return limits_in_force("irb140", None)[0]


def _read_log(path: Path) -> object:
    from trajopt_cli.measured.log_csv import read_log

    return read_log(path, _limits())  # type: ignore[arg-type]


def _fit_log(path: Path) -> object:
    from trajopt_cli.measured.identify import identify
    from trajopt_cli.measured.log_csv import read_log

    return identify([read_log(path, _limits())[0]], _limits())  # type: ignore[arg-type]


def _read_mesh(path: Path) -> object:
    from trajopt_cli.proximity.meshes import convex, load_mesh
    from trajopt_cli.shapes import MeshFile

    mesh = load_mesh(MeshFile("part", path, np.eye(4), 1.0))
    return convex(mesh)


def _read_list(path: Path) -> object:
    from trajopt_cli.rapid.sources import read_sources

    return read_sources([path])


def _estimate_with(path: Path) -> list[str]:
    """A mesh as an obstacle far away, in a command that looks at obstacles and plans nothing."""
    (path.parent / "near.mod").write_text(PROGRAM)
    (path.parent / "near.yaml").write_text(
        f"{CELL}obstacles:\n  part: {{mesh: {{file: {path.name}, position: [9, 9, 9]}}}}\n"
    )
    return ["analyse", str(path.with_name("near.mod")), "--quiet"]


def binary_stl() -> bytes:
    """A binary STL of two triangles."""
    rows = np.array([[0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0]], dtype="<f4")
    return b"\0" * 80 + (2).to_bytes(4, "little") + b"".join(row.tobytes() + b"\0\0" for row in rows)


def _own_robot(here: Workspace) -> bytes:
    """The shortest robot file that trajopt writes itself."""
    from trajopt_cli.adopt.add import new_robot

    made = new_robot(REPOSITORY / "robots" / "irb140.urdf", "own")
    (here.folder / "own.urdf").write_bytes(made.files["own.urdf"])
    return re.sub(rb"(?m)^ *#.*\n", b"", made.files["own.yaml"])


def _thinned(path: Path, step: int) -> bytes:
    lines = path.read_bytes().splitlines(keepends=True)
    return b"".join([lines[0], *lines[1:-1:step], lines[-1]])


def _parts(folder: Path) -> list[bytes]:
    """The files of a results folder as cases of their reader, run.json and summary.json most often."""
    names = [str(file.relative_to(folder)) for file in sorted(folder.rglob("*")) if file.is_file()]
    names += ["run.json"] * 4 + ["summary.json"] * 4
    return [name.encode() + b"\n" + (folder / name).read_bytes() for name in names]


def readers(here: Workspace) -> dict[str, Reader]:
    """All of them, by name."""
    programs, robots = REPOSITORY / "programs", REPOSITORY / "robots"
    csv = _thinned(here.results / "stream.csv", 4)
    seven = b"t [s]," + b",".join(b"joint_%d [rad]" % i for i in range(1, 8))
    rows = [
        b"%.3f," % (0.001 * k) + b",".join(b"%.9f" % (0.1 * i + 1e-7 * k * k) for i in range(1, 8)) for k in range(30)
    ]
    log = (here.folder / "log.csv").read_bytes()
    own = _own_robot(here)
    verify = ["verify"]
    found = [
        Reader(
            "rapid",
            "fuzz.mod",
            _files(*sorted(GOLDEN.glob("*.mod")), *sorted(programs.glob("*.mod"))),
            WORDS,
            _read_rapid,
            lambda path: ["parse", str(path)],
            make=_make_rapid,
        ),
        Reader(
            "list",
            "fuzz.pgf",
            [LIST.encode()],
            ("<Module>", "</Module>", "<Program>", "<!DOCTYPE a>", "&lt;", "tiny.mod"),
            _read_list,
            lambda path: ["parse", str(path)],
            place=_beside(here, "fuzz.pgf", "tiny.mod"),
        ),
        Reader(
            "cell",
            "tiny.yaml",
            [CELL.encode(), *_files(*sorted(programs.glob("[!i]*.yaml")))],
            YAML_WORDS,
            _read_cell,
            lambda path: ["parse", str(path.with_name("tiny.mod"))],
            _build_cell,
            place=_beside(here, "tiny.yaml", "tiny.mod", "cube.stl"),
        ),
        Reader(
            "moc",
            "MOC.cfg",
            [MOC.encode()],
            ("-name", "ARM:", "ROBOT:", "-logical_axis 9", "\\", '"', "-base_frame_orient_u1 1", "-rotating_move"),
            _read_moc,
            lambda path: ["new", str(path.parents[2] / "fuzz"), "--from", str(path.parents[1])],
            place=_moc_place,
        ),
        Reader(
            "task",
            "fuzz.yaml",
            [TASK.encode(), *_files(*sorted(programs.glob("iiwa_*[!t].yaml")))],
            YAML_WORDS,
            _read_task,
            lambda path: ["iiwa", "segments", str(path), "--output", str(path.parent / "out")],
            place=_beside(here, "fuzz.yaml", "poses.csv", "tiny.mod"),
        ),
        Reader(
            "poses",
            "poses.csv",
            [POSES.encode()],
            ("qw", "qx", "x [m]", "alpha [rad]", ";", "\t"),
            _read_poses,
            lambda path: ["iiwa", "segments", str(path.with_name("task.yaml")), "--output", str(path.parent / "out")],
            place=_beside(here, "poses.csv", "task.yaml"),
        ),
        Reader(
            "joint csv",
            "fuzz.csv",
            [csv, b"\n".join(csv.split(b"\n")[:6]) + b"\n"],
            ("t [ms]", "[deg]", "[m]"),
            _read_csv,
            lambda path: [*verify, str(path), "--program", str(here.program), "--quiet"],
            partial(_judge_csv, here.program),
        ),
        Reader(
            "iiwa csv",
            "fuzz.csv",
            [b"\n".join([seven, *rows]) + b"\n"],
            ("t [ms]", "[deg]", "[m]"),
            _read_iiwa_csv,
            lambda path: [*verify, str(path), "--robot", "iiwa7", "--quiet"],
            _judge_iiwa_csv,
        ),
        Reader(
            "urdf",
            "fuzz.urdf",
            _files(robots / "irb140.urdf", robots / "irb120.urdf", robots / "kr6_r900.urdf"),
            URDF_WORDS,
            _read_urdf,
            lambda path: ["robot", "add", str(path), "--name", "made", "--output", str(path.parent)],
        ),
        Reader(
            "robot",
            "own.yaml",
            [own],
            YAML_WORDS,
            _read_robot,
            lambda path: ["robot", "show", str(path)],
            place=_beside(here, "own.yaml", "own.urdf"),
        ),
        Reader(
            "plan folder",
            "run",
            _parts(here.results),
            JSON_WORDS,
            _read_plan_folder,
            lambda path: [*verify, str(path), "--quiet"],
            _judge_plan_folder,
            _make_results,
            partial(_results_place, here.results),
        ),
        Reader(
            "task folder",
            "run",
            _parts(here.task_results),
            JSON_WORDS,
            _read_task_folder,
            lambda path: [*verify, str(path), "--quiet"],
            _judge_task_folder,
            _make_results,
            partial(_results_place, here.task_results),
        ),
        Reader(
            "log",
            "fuzz.csv",
            [log, b"\n".join(log.split(b"\n")[:40]) + b"\n"],
            ("[deg]", "[rad]", "Time [ms]", "J1", ";", "\t"),
            _read_log,
            lambda path: ["identify", str(path), "--robot", "irb140", "--quiet"],
            _fit_log,
        ),
        Reader("stl", "fuzz.stl", [CUBE.encode(), binary_stl()], STL_WORDS, _read_mesh, _estimate_with),
        Reader(
            "obj",
            "fuzz.obj",
            [OBJ.encode()],
            ("v", "vn", "vt", "f", "1/1/1", "usemtl", "mtllib", "o", "g"),
            _read_mesh,
            _estimate_with,
        ),
    ]
    return {one.name: replace(one, seeds=[*one.seeds, *corpus(one.name.replace(" ", "_"))]) for one in found}
