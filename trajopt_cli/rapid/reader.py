"""A program file to the motions it asks for."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import fields, is_dataclass
from pathlib import Path

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import MoveAbsJ, MoveExtJ, MoveJ, MoveL, Program, TextFile
from trajopt_cli.rapid.execution.interpreter import Run
from trajopt_cli.rapid.execution.loading import load
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.syntax import ModuleFile, Node, ProcedureCall
from trajopt_cli.rapid.language.text import Places, read_text
from trajopt_cli.scenario import Lack, Scenario, lacking

_MARK = re.compile(r"!\s*trajopt\s*:\s*(.*?)\s*$", re.IGNORECASE)
DROPPED = "! dropped by trajopt: "  # how an export begins the comment that a dropped move becomes


def read_program(
    path: str | Path,
    scenario: Scenario | None = None,
    entry: str = "main",
    kinematics: Kinematics | None = None,
) -> Program:
    """Read one module file, run its entry procedure once, and return the motions in order.

    scenario: what the program cannot know. kinematics: the robot, for programs that ask where it is. Raises InputError
    with file, line and column, and one for everything that the scenario lacks.
    """
    return run_program([read_text(path)], scenario, entry, kinematics)


def run_program(
    files: Sequence[TextFile],
    scenario: Scenario | None = None,
    entry: str = "main",
    kinematics: Kinematics | None = None,
) -> Program:
    """As read_program, from texts that are already read; the first one gives the program its name."""
    program, lacks = try_program(files, scenario, entry, kinematics)
    if lacks:
        raise lacking(lacks)
    return program


def try_program(
    files: Sequence[TextFile],
    scenario: Scenario | None = None,
    entry: str = "main",
    kinematics: Kinematics | None = None,
) -> tuple[Program, tuple[Lack, ...]]:
    """As run_program, with what the scenario lacks beside the motions that 0 in its place leads to."""
    run = Run(scenario or Scenario(), kinematics)
    modules = []
    for file in files:
        places = Places(file.text, file.path)
        tree = parse_module(file.text, file.path)
        if not tree.modules:
            raise InputError("holds no RAPID module", file=file.path)
        modules += [(module, places) for module in tree.modules]
        for start, _ in tree.leftovers:
            run.warn(f"{places.source(start)}: text after ENDMODULE is not part of the program and does not run")
        if "\x00" in file.text:
            run.warn(f"{file.path}: NUL bytes between the tokens are read as blanks")
        run.optional |= {(file.path, start) for start in _marked(tree, places)}
    try:
        load(run, modules)
        run.start(entry)
    except InputError as error:
        if not run.world.lacks:
            raise
        raise InputErrorGroup([*lacking([*run.world.lacks.values()]).errors, error]) from error
    except RecursionError:
        raise InputError("is nested too deeply to be run", file=files[0].path) from None
    program = Program(
        name=Path(files[0].path).stem,
        motions=tuple(run.motions),
        files={file.path: file for file in files},
        warnings=(*run.warnings, *_unused_marks(run)),
        entry=entry,
        ignored=dict(run.ignored),
    )
    return program, tuple(run.world.lacks.values())


def _marked(tree: ModuleFile, places: Places) -> list[int]:
    """Starts of the statements that a `! trajopt: optional` comment marks.

    The comment stands behind the statement on its last line, or alone on the line above it.
    """
    marks = []
    for start, end in tree.comments:
        match = _MARK.match(places.text[start:end])
        if match is None:
            continue
        if match[1].lower() != "optional":
            raise places.error(start, f"trajopt knows no mark '{match[1]}'; it knows 'optional'")
        marks.append(start)
    if not marks:
        return []
    calls = sorted((node.start, node.end) for node in walk(tree) if isinstance(node, ProcedureCall))
    marked = []
    for mark in marks:
        line = places.line(mark)
        here = [start for start, end in calls if end <= mark and places.line(end - 1) == line]
        below = [start for start, _ in calls if start > mark and places.line(start) == line + 1]
        alone = not places.text[:mark].rpartition("\n")[2].strip()
        found = below[:1] if alone else here[-1:]
        if not found and not _already_dropped(places.text, mark):
            raise places.error(mark, "'! trajopt: optional' marks no instruction; put it behind a move or above it")
        marked += found
    return marked


def _already_dropped(text: str, mark: int) -> bool:
    below = text[mark:].splitlines()[1:2]
    return DROPPED in text[:mark].splitlines()[-1] or bool(below and DROPPED in below[0])


def _unused_marks(run: Run) -> list[str]:
    moves = (MoveJ, MoveL, MoveAbsJ, MoveExtJ)
    seen = {(m.written.statement.file, m.written.statement.start) for m in run.motions if isinstance(m, moves)}
    unused = sorted(run.optional - seen)
    return [
        f"{run.files[file].source(start)}: marked as optional, but it is no move that ran" for file, start in unused
    ]


def walk(node: object) -> list[Node]:
    """A node of a syntax tree and all nodes under it, in no particular order."""
    stack, found = [node], []
    while stack:
        thing = stack.pop()
        if isinstance(thing, tuple):
            stack += thing
        elif isinstance(thing, Node):
            found.append(thing)
            if is_dataclass(thing):
                stack += [getattr(thing, part.name) for part in fields(thing)]
    return found
