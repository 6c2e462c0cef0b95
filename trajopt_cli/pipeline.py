"""From a program and its cell to answers and files: composes the engines, no mathematics of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any

from trajopt_cli.beside import Beside, cores
from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.job import Job, read_results_job
from trajopt_cli.motion import Program, TextFile, Wait
from trajopt_cli.notices import NoticeKind
from trajopt_cli.problem.changes import Changes, Loops, everything
from trajopt_cli.problem.freedom import AS_WRITTEN
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.progress import Progress
from trajopt_cli.runs import SUMMARY
from trajopt_cli.runs.folder import check_replaceable, write_run
from trajopt_cli.runs.record import INPUT, InputFile, Inputs
from trajopt_cli.runs.results import (
    CHOSEN,
    CSV,
    AddedModule,
    Judged,
    PlanOptions,
    PlanRecord,
    RapidModule,
    Results,
    distinct_names,
    read_results,
    summary,
    zones_as_stops,
)

if TYPE_CHECKING:
    from trajopt_cli.export.rapid_write import RapidExport
    from trajopt_cli.findings import Finding, Report
    from trajopt_cli.optimize import Memory
    from trajopt_cli.problem.plant import Plant
    from trajopt_cli.trajectory import Trajectory

_WRITTEN_OUT = "loops and routines are written out as with --loops unroll, as none of their plans could be driven"
_WORTH = 5e-3  # s of an estimate that are worth a word

# What is being solved ("stream", "rapid", a baseline's name) and how far it is.
Listener = Callable[[str, Progress], None]


@dataclass(frozen=True)
class NoPlan:
    """The solver failed on a program that can be done: neither an answer nor the user's mistake."""

    label: str
    message: str


@dataclass(frozen=True)
class Illegal:
    """The judge forbids a plan: an error in trajopt itself, never a result. label: what was being solved."""

    label: str
    finding: Finding


@dataclass(frozen=True)
class Collides:
    """A plan that keeps every limit but touches something: the planner looks at no obstacles. hits: in time order."""

    label: str
    hits: tuple[Finding, ...]


@dataclass(frozen=True, eq=False)
class Optimised:
    """The answer of optimize: both targets' judged plans, what the user should know, and where the files are.

    written: the program as it stands, driven under the same limits, or why it cannot be.
    no_rapid: why the RAPID plan could not be written as RAPID; then rapid_files is empty.
    """

    job: Job
    target: Target
    judged: Mapping[Target, Judged]
    written: Plan | str
    warnings: tuple[str, ...]
    notes: tuple[str, ...]
    folder: Path
    rapid_files: tuple[str, ...]
    no_rapid: str | None
    seconds: Mapping[str, float]


@dataclass(frozen=True)
class RapidFiles:
    """The optimised modules of a results folder. patch: their difference from the program as given, for patch -p1;
    difference: the same to read. kept: what the plan had to leave as programmed, and why.
    """

    modules: tuple[RapidModule, ...]
    patch: bytes
    difference: str
    kept: tuple[str, ...]


@dataclass
class _Clock:
    """Seconds per phase, added up by name."""

    seconds: dict[str, float] = field(default_factory=dict)

    @contextmanager
    def phase(self, name: str) -> Iterator[None]:
        start = perf_counter()
        try:
            yield
        finally:
            self.seconds[name] = self.seconds.get(name, 0.0) + perf_counter() - start


def optimise(
    job: Job, target: Target, folder: Path, listen: Listener, plots: bool = False, loops: Loops = Loops.KEEP
) -> Optimised | Infeasible | NoPlan | Illegal | Collides:
    """Solve both targets, judge both, and write the results folder; nothing is written unless both are legal.

    target: which plan trajectory.csv carries. plots: its pictures, too. loops: what the RAPID plan makes of them.
    Raises InputError where folder may not be replaced.
    """
    from trajopt_cli.verify.clearance import check_start, collisions

    check_replaceable(folder)
    start = f"{job.cell.file}: the start pose"
    if hits := collisions(check_start(job.program, job.plant, start)):
        return Collides("", hits)
    clock, started = _Clock({"read": job.read_seconds}), datetime.now(UTC)
    with clock.phase("reach"):
        agreed = may_change(job, loops)
    if agreed.infeasible is not None:
        return agreed.infeasible
    changes, loops = agreed.changes, agreed.loops
    inputs = _inputs(job)
    judged: dict[Target, Judged] = {}
    answers, written = _all_three(job, listen, clock, changes)
    for one, answer in answers.items():
        if not isinstance(answer, Judged):
            return answer
        if not answer.report.legal:
            hits = collisions(answer.report.findings)
            touches_only = len(hits) == sum(not finding.passed for finding in answer.report.findings)
            return Collides(one.value, hits) if touches_only else Illegal(one.value, _worst(answer.report))
        judged[one] = answer
    with clock.phase("loops"):
        unrolled = tuple(_unrolled(job, changes[Target.RAPID], loops))
    listen("results", Progress("write"))
    with clock.phase("export"):
        export, no_rapid = _export(job, judged[Target.RAPID].plan, loops)
        notices = (*_notices(job), *agreed.notices, *_one_way(job, export))
        if no_rapid is not None:
            notices = (*notices, f"no RAPID text: {no_rapid}")
        placed = _placed(export, folder) if export is not None else ()
        notes = (*_configurations(job, judged), *placed, *changes[Target.RAPID].kept, *unrolled)
        files = _files(job, target, judged, inputs, export, notices, notes, changes[Target.RAPID].kept, written)
    if plots:
        listen("results", Progress("plots"))
        with clock.phase("plots"):
            files |= plan_pictures(job, judged[target].plan)
    added = {path: _place_of_new(path) for path in export.new} if export is not None else {}
    first, cell = inputs[next(iter(job.program.files))], inputs[str(job.cell_path)]
    write_run(
        folder,
        PlanRecord,
        files,
        command="optimize",
        options=PlanOptions(
            program=[str(path) for path in job.paths],
            cell=str(job.cell_path),
            entry=job.program.entry,
            assume_identity=list(job.assume_identity),
            target=target.value,
            loops=loops,
        ),
        inputs=Inputs(
            program=first.place,
            cell=cell.place,
            files=[one.record(rapid=export is not None) for one in dict.fromkeys((first, cell, *inputs.values()))],
        ),
        no_rapid=no_rapid,
        added=[AddedModule(path=path, rapid=place) for path, place in added.items()],
        started=started.isoformat(),
        seconds={name: round(value, 3) for name, value in clock.seconds.items()},
    )
    modules = (*(given.rapid for given in inputs.values() if given.rapid in files), *added.values())
    return Optimised(job, target, judged, written, notices, notes, folder, modules, no_rapid, clock.seconds)


def _export(job: Job, rapid: Plan, loops: Loops) -> tuple[RapidExport | None, str | None]:
    """The RAPID export; None, and why, where the program's text cannot carry the plan, which is as good without."""
    from trajopt_cli.export.faster import faster_than_programmed
    from trajopt_cli.export.rapid import export_rapid

    faster = faster_than_programmed(job.program, rapid, job.plant)
    try:
        return export_rapid(job.program, rapid, job.plant, faster, job.scenario, job.program.entry, loops), None
    except InputError as error:
        return None, str(error)


def _files(
    job: Job,
    target: Target,
    judged: Mapping[Target, Judged],
    inputs: Mapping[str, InputFile],
    export: RapidExport | None,
    notices: tuple[str, ...],
    notes: tuple[str, ...],
    kept: tuple[str, ...],
    written: Plan | str,
) -> dict[str, bytes]:
    """The results folder's files but run.json."""
    plant = job.plant
    files = {
        SUMMARY: summary(job.program, target, judged, written, notices, plant.notes, plant.unchecked, notes, kept),
        CHOSEN: judged[target].csv.encode("ascii"),
        **{CSV[one]: judged[one].csv.encode("ascii") for one in Target},
    }
    for given in inputs.values():
        files[given.place] = given.content
        if given.rapid is not None and export is not None:
            files[given.rapid] = export.texts[given.path].encode(job.program.files[given.path].encoding)
    for path, new in export.new.items() if export is not None else ():
        files[_place_of_new(path)] = new.text.encode(new.encoding)
    return files


def _one_way(job: Job, export: RapidExport | None) -> Iterator[str]:
    """A word on an endless loop that was run once, where the plan changes the program."""
    ended = any(warning.kind is NoticeKind.ENDLESS for warning in job.program.warnings)
    once = ended and job.scenario.endless_passes == 1
    changed = export is None or any(text != job.program.files[path].text for path, text in export.texts.items())
    if once and changed:
        yield "the way from the end of the loop back to its beginning is planned only with endless_passes: 2 or more"


def _unrolled(job: Job, kept: Changes, loops: Loops) -> Iterator[str]:
    """What it would save to let every pass of a loop or routine have its own answer, by the search's estimates."""
    from trajopt_cli.optimize import search_estimate

    often = len({motion.written.statement for motion in job.program.motions}) < len(job.program.motions)
    if loops is Loops.UNROLL or not (often or kept.kept):
        return
    free = changes_of(job, Target.RAPID, Loops.UNROLL)
    if free.values == kept.values and not kept.ties:
        return
    now, then = (search_estimate(job.program, job.plant, Target.RAPID, changes) for changes in (kept, free))
    if now is None or then is None:
        return
    if now - then < _WORTH:
        yield "--loops unroll would save nothing, by an estimate of the search"
    else:
        saved = f"{now - then:.2f} s ({(now - then) / now:.1%})"
        yield f"--loops unroll would save about {saved} more, by an estimate of the search"


def _configurations(job: Job, judged: Mapping[Target, Judged]) -> Iterator[str]:
    """Which moves end in another configuration than programmed, by target."""
    from trajopt_cli.problem.configurations import changed_configurations

    for target, one in judged.items():
        for line in changed_configurations(job.program, job.plant, one.plan):
            yield f"{target.value}: {line}"


def _placed(export: RapidExport, folder: Path) -> Iterator[str]:
    """The notes of an export, with each new module called by the place where it is now."""
    for note in export.notes:
        new = note.kind is NoticeKind.NEW_MODULE
        yield str(replace(note, place=f"{folder / _place_of_new(str(note.place))}") if new else note)


def _place_of_new(path: str) -> str:
    """Where the results folder keeps a module that the export added."""
    return f"program/{Path(path).name}"


def plan_pictures(job: Job, plan: Plan) -> dict[str, bytes]:
    """The pictures of one plan and of the program in steps of speed, by their place in a results folder."""
    from trajopt_cli.problem.stepwise import analyse
    from trajopt_cli.report.pictures import draw, stepwise

    name = job.title
    pictures = draw(job.program, job.plant, plan, name)
    pictures |= stepwise(job.program, analyse(job.program, job.plant), name)
    return {f"plots/{place}": content for place, content in pictures.items()}


def _all_three(
    job: Job, listen: Listener, clock: _Clock, changes: Mapping[Target, Changes]
) -> tuple[dict[Target, Judged | Infeasible | NoPlan], Plan | str]:
    """Both targets, and the program as written; beside each other where there are two cores. A stream that cannot be
    done ends the run at once."""
    stream, rapid = Target.STREAM, Target.RAPID

    def second(
        tell: Callable[[Progress], None],
    ) -> tuple[Judged | Infeasible | NoPlan, Plan | str, dict[str, float]]:
        own, memory = _Clock(), dict[bytes, Any]()
        answer = solve(job, rapid, changes[rapid], lambda _, progress: tell(progress), own, memory)
        written = as_written(job, changes[rapid], own, memory) if isinstance(answer, Judged) else ""
        return answer, written, own.seconds

    def hear(progress: Progress) -> None:
        listen(rapid.value, progress)

    if cores() == 1:
        first = solve(job, stream, changes[stream], listen, clock)
        if not isinstance(first, Judged):
            return {stream: first}, ""
        answer, written, seconds = second(hear)
    else:
        with Beside(second, hear) as beside:

            def listen_to_both(label: str, progress: Progress) -> None:
                listen(label, progress)
                beside.listen()

            first = solve(job, stream, changes[stream], listen_to_both, clock)
            if not isinstance(first, Judged):
                return {stream: first}, ""
            answer, written, seconds = beside.answer()
    clock.seconds |= seconds
    return {stream: first, rapid: answer}, written


def solve(
    job: Job, target: Target, changes: Changes, listen: Listener, clock: _Clock, memory: Memory | None = None
) -> Judged | Infeasible | NoPlan:
    """Plan one target, write its trajectory as CSV text, and let the judge read that text."""
    from trajopt_cli.joint_csv import write_csv_text
    from trajopt_cli.optimize import NoCleanPlan, optimize

    label = target.value

    def tell(progress: Progress) -> None:
        listen(label, progress)

    with clock.phase(f"{label}: plan"):
        try:
            plan = optimize(job.program, job.plant, target, progress=tell, changes=changes, memory=memory)
        except NoCleanPlan as failure:
            return NoPlan(label, str(failure))
    if isinstance(plan, Infeasible):
        return plan
    for phase, spent in plan.seconds.items():
        clock.seconds[f"{label}: {phase}"] = spent
    listen(label, Progress("judge", plan.duration, plan.lower_bound))
    with clock.phase(f"{label}: judge"):
        text = write_csv_text(plan.trajectory)
        dropped = tuple(motion.index for motion in plan.motions if motion.dropped)
        report = judge(job.plant, job.program, text, CSV[target], dropped, target)
    return Judged(plan, text, report)


def as_written(job: Job, changes: Changes, clock: _Clock, memory: Memory) -> Plan | str:
    """The program as it stands, driven by the RAPID controller under the same limits; or why it cannot be, one line.

    The same question as that of the first row of `compare`. memory: pieces that the rapid plan has solved.
    """
    from trajopt_cli.joint_csv import write_csv_text
    from trajopt_cli.optimize import NoCleanPlan, optimize

    with clock.phase("as written"):
        try:
            plan = optimize(
                job.program, job.plant, Target.RAPID, AS_WRITTEN, bounded=False, changes=changes, memory=memory
            )
        except NoCleanPlan as failure:
            return f"no plan found: {failure}"
        if isinstance(plan, Infeasible):
            return str(plan)
        text = write_csv_text(plan.trajectory)
        report = judge(job.plant, job.program, text, "as written", (), Target.RAPID, advice=False)
    return plan if report.legal else f"not legal: {_worst(report).message}"


@dataclass(frozen=True)
class MayChange:
    """What plans may change, by target, and what that makes of loops. notices: what a user should know of that.
    infeasible: what cannot be done on one of the targets whatever changes, known before either is solved."""

    changes: Mapping[Target, Changes]
    loops: Loops
    notices: tuple[str, ...] = ()
    infeasible: Infeasible | None = None


def may_change(job: Job, loops: Loops) -> MayChange:
    """What plans of this job may change: for all commands that plan, so that they answer one question alike.

    Loops that are to be kept, but that no plan could drive, are written out, and that is said.
    """
    from trajopt_cli.optimize import check_feasible

    def held_against_reach(loops: Loops) -> MayChange:
        changes = {one: changes_of(job, one, loops) for one in Target}
        found = (check_feasible(job.program, job.plant, one, changes=changes[one]) for one in Target)
        return MayChange(changes, loops, infeasible=next((one for one in found if one is not None), None))

    asked = held_against_reach(loops)
    if asked.infeasible is None or loops is Loops.UNROLL:
        return asked
    freer = held_against_reach(Loops.UNROLL)
    if freer.infeasible is not None:
        return asked
    return replace(freer, notices=(f"{_WRITTEN_OUT}: {asked.infeasible}",))


def changes_of(job: Job, target: Target, loops: Loops = Loops.KEEP) -> Changes:
    """What a plan may change on one target.

    loops: what a plan for the RAPID controller makes of them; a stream has none.
    """
    from trajopt_cli.export.rapid_reading import Reading
    from trajopt_cli.export.rapid_writable import text_changes

    if target is Target.STREAM:
        return everything(job.program, job.plant)
    reading = Reading(job.program, job.plant, job.scenario, job.program.entry)
    return text_changes(job.program, job.plant, reading, loops)


@of_kind(ErrorKind.RESULTS)
def verify_results(folder: Path) -> tuple[Job, dict[str, Report]]:
    """Judge the CSV files of a results folder against the program and cell inside it; reports by file name."""
    results = read_results(folder, judged=True)
    job = read_results_job(folder, judged=True)
    texts = {CSV[target]: (target, results.texts[CSV[target]]) for target in Target}
    if results.texts[CHOSEN] != results.texts[CSV[results.target]]:
        texts[CHOSEN] = (results.target, results.texts[CHOSEN])
    reports = {}
    for name, (target, text) in texts.items():
        reports[name] = judge(job.plant, job.program, text, str(folder / name), results.dropped[target], target)
    return job, reports


def verify_file(path: Path, job: Job) -> Report:
    """Judge a CSV file that anybody wrote against a program and its cell."""
    return judge(job.plant, job.program, _text(path), str(path))


@of_kind(ErrorKind.RESULTS)
def joint_export(folder: Path, rate: float) -> tuple[Results, Trajectory, str]:
    """The chosen target's motion of a results folder at rate [Hz], as trajectory and as CSV text."""
    from trajopt_cli.export.joint import resample
    from trajopt_cli.joint_csv import read_csv_text, write_csv_text

    results = read_results(folder)
    recorded, _ = read_csv_text(results.texts[CHOSEN], str(folder / CHOSEN))
    trajectory = resample(recorded, rate)
    return results, trajectory, write_csv_text(trajectory)


@of_kind(ErrorKind.RESULTS)
def rapid_export(folder: Path) -> RapidFiles:
    """The optimised modules of a results folder. Raises InputError where the plan could not be written as RAPID."""
    from trajopt_cli.export.rapid_diff import patch, unified_diff
    from trajopt_cli.rapid.language.text import decode

    results = read_results(folder)
    if results.no_rapid is not None:
        raise InputError(f"holds no RAPID text: {results.no_rapid}", file=str(folder))
    given, texts, new = dict[str, TextFile](), dict[str, str](), dict[str, TextFile]()
    for one in results.rapid:
        path = str(one.path)
        if one.given is None:
            new[path] = TextFile(path, *decode(one.content))
        else:
            given[path] = TextFile(path, *decode(one.given))
            texts[path] = one.content.decode(given[path].encoding)
    return RapidFiles(results.rapid, patch(given, texts, new), unified_diff(given, texts, new), results.kept)


def _notices(job: Job) -> tuple[str, ...]:
    """What a reader of the cycle times must know: the program's oddities, what is planned otherwise than it asks."""
    from trajopt_cli.problem.plannable import planned_otherwise

    zones = zones_as_stops(job.program)
    out = [f"{zones} fly-by zones are planned as stops: the cycle times are upper bounds"] if zones else []
    waits = [m for m in job.program.motions if isinstance(m, Wait) and m.condition is not None]
    if waits:
        least = sum(wait.duration for wait in waits)
        out.append(
            f"{len(waits)} waits for signals are counted with the least time the cell gives them, {least:g} s in all: "
            "the cycle times are plus waiting"
        )
    return (*map(str, job.program.warnings), *out, *planned_otherwise(job.program), *held_unasked(job))


def held_unasked(job: Job) -> Iterator[str]:
    """A word on the waits that hold the rail because an output was set just before; none where there is no rail."""
    from trajopt_cli.rapid.execution.holding import held_after_outputs

    if job.plant.rail_eax is not None and (held := held_after_outputs(job.program)):
        yield held


def judge(
    plant: Plant,
    program: Program,
    text: str,
    file: str,
    dropped: tuple[int, ...] | None = None,
    target: Target | None = None,
    advice: bool = True,
) -> Report:
    """What the judge says of a CSV file's text; file is its name in messages, the rest as in verify."""
    from trajopt_cli.joint_csv import read_csv_text
    from trajopt_cli.verify.judge import verify

    trajectory, resolution = read_csv_text(text, file)
    return verify(program, plant, trajectory, resolution, dropped, target, advice)


def _worst(report: Report) -> Finding:
    return min((finding for finding in report.findings if not finding.passed), key=lambda finding: finding.margin)


def _inputs(job: Job) -> dict[str, InputFile]:
    """Every file the job was read from, by the path it was read under, with its exact bytes."""
    inputs = {}
    for path, name in distinct_names(list(job.program.files)).items():
        place = "program.mod" if len(job.program.files) == 1 else f"program/{name}"
        inputs[path] = InputFile(path, f"{INPUT}{name}", Path(path).read_bytes(), place)
    for mesh in job.cell.mesh_files:
        copy = mesh.relative_to(job.cell_path.parent).as_posix()
        inputs[str(mesh)] = InputFile(str(mesh), f"{INPUT}{copy}", mesh.read_bytes())
    cell = str(job.cell_path)
    inputs[cell] = InputFile(cell, f"{INPUT}{job.cell_path.name}", job.cell_path.read_bytes())
    return inputs


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(f"cannot read: {error.strerror}", file=str(path)) from error
    except UnicodeDecodeError as error:
        raise InputError(f"byte {error.start} is not UTF-8 text", file=str(path)) from error
