"""What the user asked for, read and checked: the program in its files, its cell, and both together."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import floor
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

from trajopt_cli.errors import ErrorKind, InputError, of_kind, printable
from trajopt_cli.file_kinds import kind_of, refuse_other
from trajopt_cli.motion import Move, Program, TextFile
from trajopt_cli.runs import RUN
from trajopt_cli.warnings import ProgramWarning, WarningKind

if TYPE_CHECKING:
    from trajopt_cli.cell.model import Cell
    from trajopt_cli.problem.editable import Loops
    from trajopt_cli.problem.plant import Plant
    from trajopt_cli.runs.results import Results
    from trajopt_cli.scenario import Scenario

MAIN = "main"
_WHOLE = 1e-6  # s: times as written are cut to whole ones
_INSIDE = "cell.yaml"  # a cell file in the program's folder


@dataclass(frozen=True, eq=False)
class Job:
    """A program on its cell, read and checked, where both came from, and how long that took [s].

    scenario: the cell's, with what the user said besides. paths: as the user gave them. assume_identity: the names
    that the user, not the cell file, lets stand for the identity.
    """

    program: Program
    cell: Cell
    plant: Plant
    scenario: Scenario
    paths: tuple[Path, ...]
    cell_path: Path
    assume_identity: tuple[str, ...]
    read_seconds: float

    @property
    def program_path(self) -> Path:
        """The first of the paths."""
        return self.paths[0]

    @property
    def title(self) -> str:
        """The name of the first file or of the folder, for titles."""
        return self.paths[0].name or self.paths[0].resolve().name


def cell_path_for(programs: Sequence[Path]) -> Path:
    """Where a program's cell file stands unless the user says otherwise.

    Beside the first file or folder, same name, .yaml; for a folder also cell.yaml or the only cell file inside it.
    Raises InputError where both exist.
    """
    first = programs[0]
    if not first.is_dir():
        refuse_other(first, "program")
        return first.with_suffix(".yaml")
    if first.name in ("", ".."):  # ".", "..": only the real path knows the name
        beside = first / ".." / f"{first.resolve().name}.yaml"
    else:
        beside = first.with_name(f"{first.name}.yaml")
    inside = first / _INSIDE
    if not inside.exists() and not beside.exists():
        cells = [path for path in sorted(first.glob("*.y*ml")) if kind_of(path) == "cell file"]
        inside = cells[0] if len(cells) == 1 else inside
    if inside.exists() and beside.exists():
        raise InputError(
            f"has two cell files, {beside} and {inside}; say which by --cell", file=str(first), kind=ErrorKind.CELL
        )
    return inside if inside.exists() else beside


def from_backup(programs: Sequence[Path]) -> str:
    """The command that makes a cell file of the backup that a program lies in; empty where there is none."""
    from trajopt_cli.rapid.sources import syspar_of

    folder = next((found for path in programs if (found := syspar_of(path)) is not None), None)
    return "" if folder is None else f"'trajopt new {cell_path_for(programs)} --from {folder.parent}'"


def cell_for(programs: Sequence[Path], cell: Path | None) -> Cell | None:
    """The program's cell; None where it has no cell file and none was asked for."""
    path = cell or cell_path_for(programs)
    if cell is None and not path.exists():
        return None
    from trajopt_cli.cell.loader import load_cell  # half of what `trajopt parse` without a cell file takes

    return load_cell(path)


def cell_of_results(folder: Path) -> Cell:
    """The cell that a results folder keeps, with the robot that it keeps."""
    from trajopt_cli.runs.results import read_results

    return _cell_kept(read_results(folder))


def _cell_kept(results: Results) -> Cell:
    """The cell of a results folder. Raises InputError where it names a robot's file that the folder does not hold."""
    cell = _with_robot(results.cell, results.robot)
    if results.robot is None and cell.robot_files():
        message = "robot: names a file that the results folder does not hold; run trajopt optimize again"
        raise InputError(message, file=str(results.cell), kind=ErrorKind.RESULTS)
    return cell


def _with_robot(path: Path, robot: Path | None) -> Cell:
    """The cell in a file, with another place for its robot's file where one is given."""
    from trajopt_cli.cell.loader import load_cell

    cell = load_cell(path)
    return cell if robot is None else replace(cell, robot=str(robot))


def scenario_of(cell: Cell | None, assume_identity: Iterable[str] = ()) -> Scenario:
    """The cell's scenario with the names that the user lets stand for the identity; an empty one without a cell."""
    from trajopt_cli.scenario import Scenario

    scenario = cell.scenario if cell is not None else Scenario()
    names = {name.strip().lower() for name in assume_identity}
    return replace(scenario, assume_identity=scenario.assume_identity | names)


def read_job(
    programs: Path | Sequence[Path],
    cell: Path | None = None,
    entry: str = MAIN,
    assume_identity: Sequence[str] = (),
    robot: Path | None = None,
) -> Job:
    """Read a program (a file, several, a program list or a folder) and its cell file.

    robot: the robot's file instead of that which the cell names: a results folder has its own copy.
    Raises InputError for a mistake in either, for a program that never moves, and for motions that no plan can keep;
    where there is no cell file, the message holds the shortest useful one.
    """
    start = perf_counter()
    from trajopt_cli.cell.model import minimal_cell
    from trajopt_cli.rapid.language.text import read_text
    from trajopt_cli.rapid.sources import is_module, modules_at, refuse_results
    from trajopt_cli.robot.model import robot_names

    paths = (programs,) if isinstance(programs, Path) else tuple(programs)
    for path in paths:
        if not path.exists():
            raise InputError("no such program", file=str(path))
        refuse_results(path)
    path = cell or cell_path_for(paths)
    if cell is None and not path.exists():
        written = "".join(read_text(module).text for module in modules_at(paths) if is_module(module))
        text = minimal_cell(printable(paths[0].name or paths[0].resolve().name), written, robot_names())
        made = f"{command} makes one of the backup's MOC.cfg; or " if (command := from_backup(paths)) else ""
        message = f"{paths[0]} has no cell file; {made}save these lines there and adapt them:"
        raise InputError(message, file=str(path), excerpt=text, kind=ErrorKind.CELL)
    return job_on(_with_robot(path, robot), paths, path, entry, assume_identity, start=start)


def job_on(
    loaded: Cell,
    paths: tuple[Path, ...],
    cell_path: Path,
    entry: str = MAIN,
    assume_identity: Sequence[str] = (),
    files: Sequence[TextFile] | None = None,
    start: float | None = None,
) -> Job:
    """A program on a cell that is read already.

    files: the program's texts where they are at hand, too; paths: where they are from. start: when the reading began.
    Raises InputError as read_job does.
    """
    start = perf_counter() if start is None else start
    from trajopt_cli.problem.collision_objects import bodies_on, never
    from trajopt_cli.problem.configurations import at_cycle
    from trajopt_cli.problem.controller import differences
    from trajopt_cli.problem.plannable import check_plannable, target_doubts
    from trajopt_cli.problem.plant import build_plant, unwatched
    from trajopt_cli.problem.programmed import PlantKinematics
    from trajopt_cli.rapid.reader import read_program, run_program

    scenario = scenario_of(loaded, assume_identity)
    plant = build_plant(loaded)
    scenario = replace(scenario, settle=loaded.settling(plant.robot.settle))
    kinematics = PlantKinematics(plant)
    run = scenario, entry, kinematics
    flat = read_program(paths, *run) if files is None else run_program(files, *run)
    plant = at_cycle(flat, plant)
    if not any(isinstance(motion, Move) for motion in flat.motions):
        from trajopt_cli.rapid.entry import moves_nothing

        message = f"{moves_nothing(flat)}; signal values in the cell file decide branches"
        raise InputError(message, file=str(paths[0]), kind=ErrorKind.UNPLANNABLE)
    with of_kind(ErrorKind.UNPLANNABLE):
        check_plannable(flat, plant)
        for i, cue in never(plant, flat):
            which = "at" if cue == plant.grips[i].at else "detach"
            message = f"nothing happens at {cue}; give the line of a move, a wait or an output, or an output's value"
            raise loaded.error(f"attach.{i}.{which}", message)
        bodies_on(plant, flat, -1)
    flat = _with_partners(flat, plant)
    doubts = [ProgramWarning(WarningKind.DOUBTFUL, text) for text in target_doubts(flat, plant)]
    doubts += differences(paths, loaded, plant, flat.files)
    return Job(
        program=replace(flat, warnings=(*unwatched(loaded, plant.robot), *flat.warnings, *loaded.doubts, *doubts)),
        cell=loaded,
        plant=plant,
        scenario=scenario,
        paths=paths,
        cell_path=cell_path,
        assume_identity=tuple(sorted({name.strip().lower() for name in assume_identity})),
        read_seconds=perf_counter() - start,
    )


def _with_partners(program: Program, plant: Plant) -> Program:
    r"""The program in which each synchronised move (\ID) lasts at least what the program as written takes for it, where
    the cell file does not say what the other robots take: whether they need less, nobody knows here."""
    moves = {i: one for i, one in enumerate(program.motions) if isinstance(one, Move) and one.identity is not None}
    moves = {i: one for i, one in moves.items() if one.partner is None}
    if not moves:
        return program
    from trajopt_cli.plan import NoCleanPlan, optimize
    from trajopt_cli.problem.decision_scope import AS_WRITTEN
    from trajopt_cli.problem.plan import Infeasible, Plan, Target
    from trajopt_cli.problem.plannable import unpartnered

    try:
        plan: Plan | Infeasible | None = optimize(program, plant, Target.RAPID, AS_WRITTEN, bounded=False)
    except NoCleanPlan:
        plan = None
    known = {one.index: one.t_1 - one.t_0 for one in plan.motions} if isinstance(plan, Plan) else {}
    motions = list(program.motions)
    for index, move in moves.items():
        time = floor(known.get(index, 0.0) / _WHOLE) * _WHOLE
        motions[index] = replace(move, partner=time, as_written=True)
    so = "they keep at least the time as written, so nothing is saved in them, and they may take longer"
    if not known:
        so = "they may take longer, and no time as written is kept, because the program cannot be driven as written"
    told = ProgramWarning(WarningKind.ASSUMED, unpartnered(list(moves.values()), so))
    return replace(program, motions=tuple(motions), warnings=(*program.warnings, told))


def read_results_job(folder: Path, judged: bool = False) -> Job:
    """The job of a results folder: the copies it holds, with the entry and the assumptions of its run.

    judged: as in read_results.
    """
    return _of_results(folder, judged)[0]


def _of_results(folder: Path, judged: bool = False) -> tuple[Job, Loops]:
    from trajopt_cli.runs.results import read_results

    with of_kind(ErrorKind.RESULTS):
        results = read_results(folder, judged)
    _cell_kept(results)
    job = read_job(results.modules, results.cell, results.entry, results.assume_identity, results.robot)
    return job, results.loops


def read_program_or_results(
    programs: Sequence[Path],
    cell: Path | None = None,
    entry: str | None = None,
    assume_identity: Sequence[str] = (),
    loops: Loops | None = None,
) -> tuple[Job, Loops]:
    """The job of a program, or of a results folder: the inputs it was made from; and what its plan makes of loops.

    loops: of a program, KEEP for None; a results folder brings its run's. Raises InputError as read_job.
    """
    from trajopt_cli.problem.editable import Loops

    results = [path for path in programs if is_results(path)]
    if not results:
        return read_job(programs, cell, entry or MAIN, assume_identity), loops or Loops.KEEP
    if len(programs) > 1:
        raise InputError("is a results folder; give it alone", file=str(results[0]))
    for given, its, options in (
        (cell is not None, "cell file", "--cell"),
        (entry is not None or assume_identity, "entry and assumptions", "--entry and --assume-identity"),
        (loops is not None, "answer to what loops become", "--loops"),
    ):
        if given:
            raise InputError(f"a results folder brings its own {its}; leave {options} out", file=str(results[0]))
    return _of_results(results[0])


def is_results(path: Path) -> bool:
    """Whether a path is a folder that trajopt wrote."""
    return (path / RUN).is_file()
