"""Where a program's text comes from: files, folders and backups as controllers and people leave them."""

from __future__ import annotations

import os
import resource
from collections.abc import Mapping
from pathlib import Path

import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.motion import MoveL, Program, Wait
from trajopt_cli.rapid import sources
from trajopt_cli.rapid.reader import read_program
from trajopt_cli.rapid.sources import read_sources

P = "CONST robtarget p:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
TOOL = "PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,60],[1,0,0,0],0,0,0]];\n"
MOVE = "MoveL p,v100,fine,tGun;\n"


def module(name: str, *body: str, main: str | None = None) -> str:
    """A module; main: the body of its PROC main."""
    procedure = "" if main is None else f"PROC main()\n{main}ENDPROC\n"
    return f"MODULE {name}\n{''.join(body)}{procedure}ENDMODULE\n"


def pgf(*names: str) -> str:
    lines = "".join(f"\t<Module>{name}</Module>\r\n" for name in names)
    return f'<?xml version="1.0" encoding="ISO-8859-1" ?>\r\n<Program>\r\n{lines}</Program>\r\n'


def tree(folder: Path, files: Mapping[str, str | bytes]) -> Path:
    for name, content in files.items():
        place = folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(content if isinstance(content, bytes) else content.encode())
    return folder


def names(*paths: Path, entry: str = "main") -> list[str]:
    return [Path(file.path).name for file in read_sources(paths, entry).files]


def waits(program: Program) -> list[float]:
    return [motion.duration for motion in program.motions if isinstance(motion, Wait)]


def error(*paths: Path, entry: str = "main") -> str:
    """What is said of paths, without the folder that the test lives in."""
    with pytest.raises(InputError) as caught:
        read_program(paths, entry=entry)
    folder = os.path.commonpath([str(path.parent) for path in paths])
    return str(caught.value).replace(f"{folder}/", "")


BACKUP = {
    "RAPID/TASK1/PROGMOD/Main.mod": module("Main", P, main=MOVE),
    "RAPID/TASK1/PROGMOD/Calib.MOD": module("Calib", TOOL),
    "RAPID/TASK1/SYSMOD/user.sys": "MODULE user(SYSMODULE)\nENDMODULE\n",
    "RAPID/TASK1/SYSMOD/BASE.SYS": "MODULE BASE(SYSMODULE)\nENDMODULE\n",
    "HOME/Main.mod": "never a module",
    "SYSPAR/MOC.cfg": b"\x00\x01\x02",
    "SYSPAR/SIO.mod": "nor this",
    "BACKINFO/backinfo.txt": "x",
    "BACKINFO/version.sys": "x",
    "system.xml": "<x/>",
}


# -------------------------------------------------------------------------------------------------- folders, layouts


def test_a_backup_gives_the_modules_of_its_task_program_first(tmp_path: Path) -> None:
    folder = tree(tmp_path / "Cell_2024", BACKUP)
    assert names(folder) == ["Calib.MOD", "Main.mod", "BASE.SYS", "user.sys"]
    for part in ("RAPID", "RAPID/TASK1"):
        assert names(folder / part) == names(folder)
    program = read_program(folder)
    assert (program.name, len(program.motions), tuple(map(str, program.warnings))) == ("Cell_2024", 1, ())
    [motion] = program.motions
    assert isinstance(motion, MoveL)
    assert motion.tool.X_FT[2, 3] == pytest.approx(0.12)
    assert motion.source.file == str(folder / "RAPID/TASK1/PROGMOD/Main.mod")


@pytest.mark.parametrize(
    "places",
    [
        ("Main.mod", "Calib.mod"),
        ("Main.modx", "user.sysx"),
        ("OLD.PRG", "Calib.Sys"),
        ("RAPID/TASK1/Main.mod", "RAPID/TASK1/user.sys"),
        ("RAPID/PROGMOD/Main.mod", "RAPID/SYSMOD/user.sys"),
        ("rapid/t_rob1/progmod/main.mod", "rapid/t_rob1/sysmod/user.sys"),
        ("T_ROB1/main.mod", "T_ROB1/user.sys"),
        ("station/modules/main.mod", "station/data/user.mod"),
    ],
)
def test_every_layout_is_one_program(tmp_path: Path, places: tuple[str, str]) -> None:
    folder = tree(tmp_path / "f", {places[0]: module("Main", P, main=MOVE), places[1]: module("Calib", TOOL)})
    assert len(read_program(folder).motions) == 1
    assert sorted(names(folder)) == sorted(Path(place).name for place in places)


def test_the_order_is_the_same_whatever_the_file_system_says(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    places = ("b.mod", "C.mod", "a.mod", "sub/d.mod", "a_user.sys")
    folder = tree(tmp_path / "f", {place: module(place[0]) for place in places})
    before = names(folder)
    assert before == ["a.mod", "b.mod", "C.mod", "d.mod", "a_user.sys"]
    listed = Path.iterdir
    monkeypatch.setattr(Path, "iterdir", lambda self: iter([*listed(self)][::-1]))
    assert names(folder) == before


def test_files_keep_the_order_they_are_given_in_and_are_read_once(tmp_path: Path) -> None:
    folder = tree(tmp_path / "f", {"b.mod": module("b"), "a.mod": module("a"), "c.txt": module("c")})
    assert names(folder / "b.mod", folder / "a.mod", folder / "c.txt") == ["b.mod", "a.mod", "c.txt"]
    assert names(folder / "b.mod", folder, folder / ".." / "f" / "b.mod") == ["b.mod", "a.mod"]


def test_one_file_is_one_file(tmp_path: Path) -> None:
    folder = tree(tmp_path / "f", {"a.mod": module("a", main="WaitTime 1;\n"), "b.mod": "broken"})
    assert waits(read_program(folder / "a.mod")) == [1]
    assert waits(read_program(str(folder / "a.mod"))) == [1]


def test_encodings_and_line_ends_of_each_file_are_its_own(tmp_path: Path) -> None:
    text = module("Main", "VAR num länge:=2; ! Türband\n", main="WaitTime länge;\n")
    more = module("Mehr", "VAR num größe:=2;\n")
    folder = tree(
        tmp_path / "f",
        {"a.mod": text.replace("\n", "\r\n").encode("cp1252"), "b.mod": b"\xef\xbb\xbf" + more.encode()},
    )
    program = read_program(folder)
    assert [(file.encoding, "\r\n" in file.text) for file in program.files.values()] == [
        ("cp1252", True),
        ("utf-8-sig", False),
    ]
    assert waits(program) == [2]
    for path, file in program.files.items():
        assert file.text.encode(file.encoding) == Path(path).read_bytes()


def test_links_in_circles_end_and_results_are_not_read_again(tmp_path: Path) -> None:
    folder = tree(
        tmp_path / "f",
        {
            "a.mod": module("a", main="WaitTime 1;\n"),
            "results/f/run.json": "{}",
            "results/f/input/a.mod": module("a"),
            ".git/a.mod": module("a"),
        },
    )
    for name in ("again", "results/back", "once_more"):  # each round doubles the paths
        (folder / name).symlink_to(folder, target_is_directory=True)
    (folder / "also.mod").symlink_to(folder / "a.mod")
    (folder / "broken.mod").symlink_to(folder / "nowhere")
    (folder / "me").symlink_to(folder / "me")
    assert names(folder) == ["a.mod"]
    said = "f: is a results folder; the program it was made from lies in its folder input"
    assert error(folder / "results" / "f") == said


@pytest.mark.parametrize("listed", [False, True])
def test_links_out_of_a_folder_are_not_followed_and_told(listed: bool, tmp_path: Path) -> None:
    """A module, a folder of modules and a module of the system; links inside the folder are followed."""
    content = {"T/PROGMOD/a.mod": module("a", main="WaitTime 1;\n"), "T/SYSMOD/base.sys": module("base")}
    folder = tree(tmp_path / "f", content | {"T/PROGMOD/m.pgf": pgf("a.mod")} if listed else content)
    away = tree(tmp_path / "away", {"secret.mod": module("secret"), "more/b.mod": module("b"), "s.sys": module("s")})
    for name, to in (("PROGMOD/x.mod", "secret.mod"), ("PROGMOD/more", "more"), ("SYSMOD/s.sys", "s.sys")):
        (folder / "T" / name).symlink_to(away / to)
    (folder / "T/SYSMOD/again.sys").symlink_to(folder / "T/SYSMOD/base.sys")
    read = read_sources([folder])
    assert [Path(file.path).name for file in read.files] == ["a.mod", "again.sys"]
    (told,) = [str(one) for one in read.warnings if " by a link" in str(one)]
    assert all(name in told for name in ("x.mod", "PROGMOD/more", "s.sys"))
    if listed:
        read = read_sources([folder / "T/PROGMOD/m.pgf"])
        assert [Path(file.path).name for file in read.files] == ["a.mod", "again.sys"]
        assert ["s.sys" in str(one) for one in read.warnings] == [True]
        (folder / "T/PROGMOD/m.pgf").write_text(pgf("a.mod", "x.mod"))
        with pytest.raises(InputError) as caught:
            read_sources([folder / "T/PROGMOD/m.pgf"])
        assert caught.value.line == 4


def test_bounds_are_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tree(tmp_path / "f", {f"{name}.mod": module(name) for name in "abc"})
    monkeypatch.setattr(sources, "MAX_BYTES", 40)
    assert error(folder).startswith("f: 0 MB of modules; at most 0 MB")
    monkeypatch.setattr(sources, "MAX_FILES", 2)
    assert error(folder) == "f: 3 modules; at most 2 are supported"
    monkeypatch.setattr(sources, "MAX_ENTRIES", 2)
    assert error(folder) == "f: holds more than 2 files and folders; give the folder of the program alone"


def test_what_may_not_fit_into_the_memory_that_the_process_may_have_is_not_begun(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tree(tmp_path / "f", {"a.mod": module("a")})
    (folder / "a.mod").write_bytes((folder / "a.mod").read_bytes() + b"\n" * 2_000_000)
    for limit, fits in ((10**9, True), (resource.RLIM_INFINITY, True), (400_000_000, False)):
        monkeypatch.setattr(resource, "getrlimit", lambda _, limit=limit: (limit, limit))
        if fits:
            assert names(folder) == ["a.mod"]
        else:
            assert error(folder).startswith("f: 2 MB of modules may take 540 MB to read")


# ----------------------------------------------------------------------------------------------------- several tasks


def test_of_several_tasks_the_one_with_the_entry_is_read(tmp_path: Path) -> None:
    second = {
        "RAPID/TASK2/PROGMOD/Watch.mod": "MODULE Watch\n! PROC main()\nPROC watch()\nWaitTime 3;\nENDPROC\nENDMODULE\n"
    }
    folder = tree(tmp_path / "b", BACKUP | second)
    program = read_program(folder)
    assert len(program.motions) == 1
    assert tuple(map(str, program.warnings)) == (
        f"{folder}: of its tasks RAPID/TASK1 is read; RAPID/TASK2 hold no PROC main",
    )
    assert waits(read_program(folder, entry="WATCH")) == [3]
    assert waits(read_program(folder / "RAPID" / "TASK2", entry="watch")) == [3]


def test_several_tasks_with_the_entry_are_named(tmp_path: Path) -> None:
    second = {"RAPID/T_ROB2/PROGMOD/Main.mod": module("Main", main="WaitTime 3;\n")}
    folder = tree(tmp_path / "b", BACKUP | second)
    tasks = "b: holds 2 tasks (RAPID/TASK1, RAPID/T_ROB2), and "
    assert error(folder) == f"{tasks}2 of them hold a PROC main; give the folder of one of them"
    assert error(folder, entry="go") == f"{tasks}none of them holds a PROC go; give the folder of one of them"
    assert waits(read_program(folder / "RAPID" / "T_ROB2")) == [3]


def test_the_folders_of_rapid_are_tasks_whatever_their_names(tmp_path: Path) -> None:
    folder = tree(
        tmp_path / "b",
        {f"RAPID/{name}/Main.mod": module("Main", main="WaitTime 3;\n") for name in ("Left", "Right")},
    )
    assert error(folder).startswith("b: holds 2 tasks (RAPID/Left, RAPID/Right), and 2 of them hold a PROC main")


def test_modules_outside_the_task_are_not_read_and_said(tmp_path: Path) -> None:
    folder = tree(tmp_path / "b", BACKUP | {"extra/Old.mod": module("Main"), "Alone.mod": "x"})
    said = f"{folder}: Alone.mod, extra/Old.mod stand outside the task's folder and are not read"
    assert tuple(map(str, read_program(folder).warnings)) == (said,)


# ----------------------------------------------------------------------------------------------------- program lists


LISTED = {
    "PROGMOD/Line.pgf": pgf("MAIN.MOD", "Calib.mod"),
    "PROGMOD/Main.mod": module("Main", P, main=MOVE),
    "PROGMOD/Calib.mod": module("Calib", TOOL),
    "PROGMOD/Old.mod": module("Main", main="WaitTime 9;\n"),
    "SYSMOD/user.sys": module("user"),
}


def test_a_program_list_says_which_modules_are_the_program(tmp_path: Path) -> None:
    folder = tree(tmp_path / "TASK1", LISTED)
    assert names(folder) == ["Main.mod", "Calib.mod", "user.sys"]
    said = f"{folder}/PROGMOD/Line.pgf: does not list PROGMOD/Old.mod, which are not read"
    assert tuple(map(str, read_program(folder).warnings)) == (said,)
    assert names(folder / "PROGMOD" / "Line.pgf") == ["Main.mod", "Calib.mod", "user.sys"]
    program = read_program(folder / "PROGMOD" / "Line.pgf")
    assert (program.name, len(program.motions)) == ("Line", 1)


def test_a_module_that_is_listed_and_missing_is_named_with_its_line(tmp_path: Path) -> None:
    folder = tree(tmp_path / "TASK1", LISTED | {"PROGMOD/Line.pgf": pgf("Main.mod", "Gone.mod", "Far.mod")})
    told = "TASK1/PROGMOD/Line.pgf:{}: lists {}, which is not in TASK1/PROGMOD; put it there or remove the line"
    assert error(folder) == f"{told.format(4, 'Gone.mod')}\n{told.format(5, 'Far.mod')}"


def test_two_program_lists_are_a_question(tmp_path: Path) -> None:
    folder = tree(tmp_path / "TASK1", LISTED | {"PROGMOD/A.pgf": pgf("Main.mod")})
    assert error(folder) == "TASK1: holds 2 program lists (PROGMOD/A.pgf, PROGMOD/Line.pgf); give one of them"


BOMB = '<?xml version="1.0"?>\n<!DOCTYPE x [<!ENTITY a "ha"><!ENTITY b "&a;&a;">]>\n<Program>&b;</Program>'


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            '<!DOCTYPE Program SYSTEM "http://x/y.dtd">\n<Program><Module>Main.mod</Module></Program>',
            ":1: declares a document type or an entity, which controllers never write; remove the declaration",
        ),
        (BOMB, ":2: declares a document type or an entity, which controllers never write; remove the declaration"),
        ("<Program>\n<Module>Main.mod</Modul></Program>", ":2:19: is not a readable program list: mismatched tag"),
        ("<Page>\n</Page>", ":1: is not a program list: it begins with <Page>, a list begins with <Program>"),
        ("<Program>\n</Program>", ": lists no modules: a list holds <Program><Module>Name.mod</Module></Program>"),
        (
            "<Program>\n<Module>../../Main.mod</Module></Program>",
            ":2: '../../Main.mod' is not the name of a module file; a list names files beside it",
        ),
        ("", ":1:1: is not a readable program list: no element found"),
        ("<Program><Module>&other;</Module></Program>", ":1:18: is not a readable program list: undefined entity"),
    ],
)
def test_a_program_list_that_is_none(tmp_path: Path, text: str, message: str) -> None:
    folder = tree(tmp_path / "f", {"a.pgf": text, "Main.mod": module("Main", main="WaitTime 1;\n")})
    assert error(folder / "a.pgf") == f"a.pgf{message}"


@pytest.mark.parametrize("encoding", ["cp1252", "utf-8", "utf-8-sig", "utf-16"])
def test_a_program_list_is_read_in_the_encoding_it_has_not_the_one_it_claims(tmp_path: Path, encoding: str) -> None:
    text = pgf("Türe.mod", "türe.mod").replace("ISO-8859-1", "UTF-8" if encoding == "cp1252" else "ISO-8859-1")
    folder = tree(tmp_path / "f", {"a.pgf": text.encode(encoding), "Türe.mod": module("Main", main="WaitTime 1;\n")})
    assert names(folder / "a.pgf") == ["Türe.mod"]


# --------------------------------------------------------------------------------------------------- what is no RAPID


@pytest.mark.parametrize(
    ("content", "what"),
    [
        (b"", "is empty"),
        (b"\xef\xbb\xbf \r\n\x00\x1a", "is empty"),
        (b"IMPLEMENTATION MODULE Stacks;\nEND Stacks.\n", "looks like Modula-2 or Oberon"),
        (b"(* a *)\nMODULE Hello;\nIMPORT Out;\nBEGIN\n  Out.Ln\nEND Hello.\n", "looks like Modula-2 or Oberon"),
        (b"module physics\n  implicit none\n  real :: g\nend module physics\n", "looks like Fortran"),
        (b"GFORTRAN module version '0' created from x.f90\nMD5:1\n", "looks like Fortran"),
        (b"\x1f\x8b\x08\x00\x00\x00\x00\x00GFO", "is compressed (Fortran compilers write such .mod files)"),
        (b"set I;\nparam c{I};\nvar x{I} >= 0;\nminimize cost: sum{i in I} c[i]*x[i];\nend;\n", "looks like a GNU"),
        (b"module example.com/tool\n\ngo 1.22\n", "looks like a Go module file"),
        (b'<?xml version="1.0"?><Program/>', "is XML or HTML"),
        (bytes(range(256)) * 20, "is binary"),
    ],
)
def test_files_of_other_languages_get_one_sentence(tmp_path: Path, content: bytes, what: str) -> None:
    folder = tree(tmp_path / "f", {"x.mod": content, "a.mod": module("a", main="WaitTime 1;\n")})
    said = error(folder / "x.mod")
    assert said.startswith(f"x.mod: is not a RAPID module: it {what}")
    assert "\n" not in said
    program = read_program(folder)
    assert waits(program) == [1]
    assert str(program.warnings[0]).startswith(f"{folder}/x.mod: is left out: it is not a RAPID module, it {what}")


@pytest.mark.parametrize(
    "text",
    [
        "%%%\n  VERSION:1\n  LANGUAGE:ENGLISH\n%%%\n\nMODULE a\nPROC main()\nWaitTime 1;\nENDPROC\nENDMODULE\n",
        "module a\nproc main()\nset do1;\nWaitTime 1;\nendproc\nendmodule\n",
        "PROC main()\nWaitTime 1;\nENDPROC\n",
        "MODULE\x00 a\x00\nPROC main()\x00\nWaitTime 1;\nENDPROC\nENDMODULE\n",
    ],
)
def test_rapid_is_not_taken_for_another_language(tmp_path: Path, text: str) -> None:
    folder = tree(tmp_path / "f", {"a.mod": text})
    assert waits(read_program(folder / "a.mod")) == [1]


def test_folders_without_a_program_say_what_was_looked_for(tmp_path: Path) -> None:
    looked = "looked for .mod, .prg, .sys, .modx, .sysx in it and below, but not in HOME, SYSPAR and BACKINFO"
    folder = tree(tmp_path / "f", {"a.txt": module("a"), "HOME/b.mod": module("b")})
    assert error(folder) == f"f: holds no RAPID module: {looked}"
    folder = tree(tmp_path / "g", {"x.mod": b""})
    assert error(folder).startswith("g: none of its files is a RAPID module: ")


def test_what_is_no_file_is_not_read(tmp_path: Path) -> None:
    assert error(tmp_path / "none.mod") == "none.mod: cannot be read: No such file or directory"
    os.mkfifo(tmp_path / "pipe.mod")
    assert error(tmp_path / "pipe.mod") == "pipe.mod: is not a regular file; save the program in one"
    tree(tmp_path, {"a.mod": module("a")})
    assert names(tmp_path) == ["a.mod"]
    with pytest.raises(InputError, match="give a RAPID module, several, or the folder that holds them"):
        read_program([])


# ------------------------------------------------------------------------------------------- names over all modules


def test_a_module_in_two_files_names_both(tmp_path: Path) -> None:
    folder = tree(tmp_path / "f", {"a.mod": module("One", main=""), "b.mod": "\n" + module("ONE")})
    assert error(folder) == "f/b.mod:2:1: module ONE is also in f/a.mod:1; leave one of them out"


def test_the_errors_of_all_files_are_told_in_one_run(tmp_path: Path) -> None:
    broken = "MODULE b\nPROC f()\nWaitTime ;;;(\nENDPROC\nENDMODULE\n"
    folder = tree(tmp_path / "f", {"a.mod": broken, "b.mod": broken.replace("b\n", "c\n", 1)})
    places = {line.split(": ")[0] for line in error(folder).splitlines()}
    assert {"f/a.mod", "f/b.mod"} == {place.split(":")[0] for place in places}


def test_the_entry_may_be_any_procedure(tmp_path: Path) -> None:
    a = "MODULE a\nPROC go()\nWaitTime 1;\nENDPROC\nPROC takes(num x)\nENDPROC\nPROC may(\\num x)\nENDPROC\n"
    b = "MODULE b\nLOCAL PROC Inner()\nWaitTime 2;\nENDPROC\nLOCAL PROC twice()\nWaitTime 5;\nENDPROC\nENDMODULE\n"
    c = "LOCAL PROC twice()\nWaitTime 6;\nENDPROC\nLOCAL PROC go()\nWaitTime 7;\nENDPROC\nENDMODULE\n"
    folder = tree(tmp_path / "f", {"a.mod": f"{a}ENDMODULE\n", "b.mod": b, "c.mod": f"MODULE c\n{c}"})
    assert waits(read_program(folder, entry="GO")) == [1]
    assert read_program(folder, entry="GO").entry == "go"
    assert waits(read_program(folder, entry="inner")) == [2]
    said = "f: there are 2 LOCAL PROC twice (f/b.mod:5, f/c.mod:2); rename all but one"
    assert error(folder, entry="twice") == said
    assert (
        error(folder, entry="takes") == "f/a.mod:5:1: PROC takes needs arguments, so the program cannot start with it"
    )
    assert error(folder) == (
        "f: there is no PROC main(); start with another by --entry: go (f/a.mod:2), may (f/a.mod:7), "
        "Inner (f/b.mod:2), twice (f/b.mod:5), twice (f/c.mod:2), go (f/c.mod:5)"
    )


def test_of_many_procedures_ten_are_shown(tmp_path: Path) -> None:
    body = "".join(f"PROC p{i}()\nENDPROC\n" for i in range(12))
    folder = tree(tmp_path / "f", {"a.mod": module("a", body)})
    assert error(folder / "a.mod").endswith("p8 (a.mod:18), p9 (a.mod:20) and 2 more")


# ------------------------------------------------------------------------------------------------------------- hints


def test_a_name_that_a_module_beside_declares_is_hinted_at(tmp_path: Path) -> None:
    folder = tree(
        tmp_path / "f",
        {
            "Main.mod": module("Main", P, main=f"{MOVE}"),
            "Second.mod": module("Second", main="Helper;\n"),
            "Calib.mod": module("Calib", TOOL, "PROC Helper()\nENDPROC\n"),
        },
    )
    hint = f"; {folder}/Calib.mod declares {{}}: give the folder {folder} instead"
    assert error(folder / "Main.mod").endswith(hint.format("tGun").replace(f"{folder}/", ""))
    assert error(folder / "Second.mod").endswith(hint.format("Helper").replace(f"{folder}/", ""))


def test_the_task_is_hinted_at_where_the_name_is_in_its_sysmod(tmp_path: Path) -> None:
    folder = tree(
        tmp_path / "TASK1",
        {"PROGMOD/Main.mod": module("Main", P, main=MOVE), "SYSMOD/user.sys": module("user", TOOL)},
    )
    hint = f"; {folder}/SYSMOD/user.sys declares tGun: give the folder {folder} instead"
    assert error(folder / "PROGMOD").endswith(hint.replace(f"{folder}/", ""))
    assert error(folder / "PROGMOD" / "Main.mod").endswith(hint)


def test_no_hint_where_nobody_declares_the_name_or_two_do(tmp_path: Path) -> None:
    folder = tree(tmp_path / "f", {"Main.mod": module("Main", P, main=MOVE), "x.mod": "! PERS tooldata other;\n"})
    assert "give the folder" not in error(folder / "Main.mod")
    tree(folder, {"a.mod": module("a", TOOL), "b.mod": module("b", TOOL)})
    assert "give the folder" not in error(folder / "Main.mod")
    folder = tree(tmp_path / "g", {"x.mod": module("x", P), "own.mod": module("own", "VAR num p;\n", TOOL, main=MOVE)})
    assert error(folder / "own.mod") == "own.mod:5:7: ToPoint of MoveL needs a robtarget, found num p"


@pytest.mark.parametrize(
    "beside",
    [
        "LOCAL PERS tooldata tGun:=[TRUE,[[0,0,0],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\n",
        "PROC p()\nVAR tooldata tGun;\nENDPROC\n",
        "PROC p(PERS tooldata tGun)\nENDPROC\n",
        "LOCAL PROC p()\nVAR tooldata tGun;\nENDPROC\n",
        "FUNC num f()\nVAR tooldata tGun;\nRETURN 1;\nENDFUNC\nTRAP t\nVAR tooldata tGun;\nENDTRAP\n",
        "! PERS tooldata tGun;\n",
        'CONST string s:="PERS tooldata tGun";\n',
    ],
)
def test_only_what_a_module_shares_is_hinted_at(tmp_path: Path, beside: str) -> None:
    folder = tree(tmp_path / "f", {"Main.mod": module("Main", P, main=MOVE), "Calib.mod": module("Calib", beside)})
    assert "give the folder" not in error(folder / "Main.mod")
    tree(folder, {"Calib.mod": module("Calib", beside, f"TASK {TOOL}")})
    assert f"Calib.mod declares tGun: give the folder {folder} instead" in error(folder / "Main.mod")


@pytest.mark.parametrize(
    ("text", "mistake"),
    [
        ("VAR string s;\nFOR i FROM 1 TO 2 DO\ns:=i;\nENDFOR\n", "string"),
        ("VAR num n;\nFOR i FROM 1 TO 2 DO\ni:=3;\nENDFOR\n", "i"),
        ("VAR num n;\nn:=1+i;\n", "signal"),
    ],
)
def test_only_undeclared_names_are_hinted_at(tmp_path: Path, text: str, mistake: str) -> None:
    files = {"Main.mod": module("Main", main=text), "x.mod": module("x", "VAR num i;\nVAR num n;\n")}
    told = error(tree(tmp_path / "f", files) / "Main.mod")
    assert mistake in told
    assert ("x.mod declares i" in told) == (mistake == "signal")


def test_the_entry_beside_is_hinted_at(tmp_path: Path) -> None:
    folder = tree(tmp_path / "f", {"Main.mod": module("Main", main=""), "Calib.mod": module("Calib", TOOL)})
    message = "Calib.mod: there is no PROC main(), nor another procedure without arguments to start with"
    assert error(folder / "Calib.mod") == f"{message}; Main.mod declares main: give the folder {folder} instead"
