"""A program's files to the motions it asks for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from trajopt_cli.errors import ErrorKind, InputError, InputErrorGroup, of_kind
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import Move, Program, Source, Span, TextFile
from trajopt_cli.rapid.concurrent import laid_beside
from trajopt_cli.rapid.entry import find_entry
from trajopt_cli.rapid.execution.interpreter import Execution
from trajopt_cli.rapid.execution.loading import load
from trajopt_cli.rapid.execution.named import fill_constant_speed, fill_free
from trajopt_cli.rapid.execution.rail import CellRailPlaces, fill_holds
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.syntax import Module, Routine
from trajopt_cli.rapid.language.text import Places
from trajopt_cli.rapid.marks import find_marks
from trajopt_cli.rapid.missing_modules import with_hints
from trajopt_cli.rapid.sources import read_sources
from trajopt_cli.scenario import Missing, Scenario, missing_error
from trajopt_cli.warnings import ProgramWarning, WarningKind


@of_kind(ErrorKind.PROGRAM)
def read_program(
    paths: str | Path | Sequence[str | Path],
    scenario: Scenario | None = None,
    entry: str = "main",
    kinematics: Kinematics | None = None,
) -> Program:
    """Read a module, several, a program list or a folder, run its entry once, and return the motions in order.

    scenario: what the program cannot know. kinematics: the robot, for programs that ask where it is. Raises InputError
    with file, line and column, and one for all that the scenario does not say. Leaves the process as it was; with
    thousands of targets, half of the time is the garbage collector's (see cli/process.py).
    """
    program, missing = try_paths(paths, scenario, entry, kinematics)
    if missing:
        raise with_hints(missing_error(missing), [*program.files.values()], entry)
    return program


@of_kind(ErrorKind.PROGRAM)
def try_paths(
    paths: str | Path | Sequence[str | Path],
    scenario: Scenario | None = None,
    entry: str = "main",
    kinematics: Kinematics | None = None,
) -> tuple[Program, tuple[Missing, ...]]:
    """As read_program, with what the scenario does not say beside the motions that 0 in its place leads to."""
    given = [paths] if isinstance(paths, (str, Path)) else paths
    sources = read_sources([Path(path) for path in given], entry)
    try:
        program, missing = try_program(sources.files, scenario, entry, kinematics, sources.name)
    except InputError as error:
        hinted = with_hints(error, sources.files, entry)
        if hinted is error:
            raise
        raise hinted from error
    return replace(program, warnings=(*sources.warnings, *program.warnings)), missing


@of_kind(ErrorKind.PROGRAM)
def run_program(
    files: Sequence[TextFile],
    scenario: Scenario | None = None,
    entry: str = "main",
    kinematics: Kinematics | None = None,
) -> Program:
    """As read_program, from texts that are already read; the first one gives the program its name."""
    program, missing = try_program(files, scenario, entry, kinematics)
    if missing:
        raise missing_error(missing)
    return program


@of_kind(ErrorKind.PROGRAM)
def try_program(
    files: Sequence[TextFile],
    scenario: Scenario | None = None,
    entry: str = "main",
    kinematics: Kinematics | None = None,
    name: str | None = None,
) -> tuple[Program, tuple[Missing, ...]]:
    """As run_program, with what the scenario does not say beside the motions that 0 in its place leads to.

    name: of the program; the first file's where None.
    """
    name = name or Path(files[0].path).stem
    subject = files[0].path if len(files) == 1 else name  # what messages about the whole program begin with
    run = Execution(scenario or Scenario(), kinematics)
    modules = _modules(run, files)
    try:
        scopes = load(run, modules)
        trees = [module for module, _ in modules]
        routine, scope = find_entry([*zip(trees, scopes, strict=True)], entry, subject)
        if run.scenario.rail_at:
            run.rail_places = CellRailPlaces(run, modules)
        run.start(routine, scope)
        run.rail_places.warn_unused()
        fill_holds(run, modules)
        fill_constant_speed(run, modules)
        fill_free(run, modules)
    except InputError as error:
        _show(run, error)
        if not run.external.missing:
            raise
        raise missing_error([*run.external.missing.values()], error) from error
    except RecursionError:
        raise InputError("is nested too deeply to be run", file=subject) from None
    program = Program(
        name=name,
        motions=tuple(run.motions),
        files={file.path: file for file in files},
        warnings=(*run.warnings, *_unused_marks(run)),
        entry=routine.name,
        ignored=dict(run.ignored),
        refusals=tuple(run.refusals.values()),
        uncalled=tuple(
            f"{item.kind} {item.name}"
            for tree in trees
            for item in tree.items
            if isinstance(item, Routine) and id(item) not in run.heads
        ),
    )
    program = laid_beside(program, run.scenario, kinematics)
    if run.cycle is not None:
        program = replace(program, passes=run.cycle.passes)
        if run.cycle.closed:
            first, last = run.cycle.first, run.cycle.last
            before, motions, beyond = program.motions[:first], program.motions[first:last], program.motions[last:]
            program = replace(program, motions=motions, before=before, beyond=beyond)
    run.external.data.clear()  # as below
    for scope in scopes:  # a scope knows itself by its routines: without that, all goes before the collector comes back
        scope.routines.clear()
        scope.types.clear()
    return program, tuple(run.external.missing.values())


def _show(run: Execution, error: InputError) -> None:
    """Give an error the line it is about. Those that a program may handle come without: most are never shown."""
    if error.excerpt is None and error.file in run.files and error.line and error.column:
        places = run.files[error.file]
        error.excerpt = places.excerpt(places.offset(error.line, error.column))


def _modules(run: Execution, files: Sequence[TextFile]) -> list[tuple[Module, Places]]:
    """The modules of all files, with the warnings that their texts give rise to; the errors of all files at once."""
    modules: list[tuple[Module, Places]] = []
    known: dict[str, Source] = {}
    errors: list[InputError] = []
    for file in files:
        places = Places(file.text, file.path)
        try:
            tree = parse_module(file.text, file.path)
            if not tree.modules:
                raise InputError("holds no RAPID module", file=file.path)
            marks = find_marks(tree, places)
            run.optional |= {(file.path, start) for start in marks.optional}
            run.ways |= {(file.path, start): names for start, names in marks.ways.items()}
            run.held += [Span(file.path, *stretch) for stretch in marks.held]
            for module in tree.modules:
                _name_once(module, places, known)
        except InputError as error:
            errors += error.errors if isinstance(error, InputErrorGroup) else [error]
            continue
        modules += [(module, places) for module in tree.modules]
        for offset, sentence in tree.warnings:
            run.warn(WarningKind.UNUSUAL, sentence, places.source(offset))
    if errors:
        raise errors[0] if len(errors) == 1 else InputErrorGroup(errors)
    return modules


def _name_once(module: Module, places: Places, known: dict[str, Source]) -> None:
    """A controller holds one module of a name; declarations outside modules have no name to share."""
    here = places.source(module.start)
    before = known.setdefault(module.name.lower(), here) if module.name else here
    if before is not here:
        message = f"module {module.name} is also in {before.file}:{before.line}; leave one of them out"
        raise places.error(module.start, message)


def _unused_marks(run: Execution) -> list[ProgramWarning]:
    moves = (one for one in run.motions if isinstance(one, Move)) if run.optional else ()
    unused = sorted(run.optional - {(one.written.statement.file, one.written.statement.start) for one in moves})
    text = "marked as optional, but no move ran there"
    return [ProgramWarning(WarningKind.UNUSED, text, run.files[file].source(start)) for file, start in unused]
