"""`optimize` from a job to its results folder: both plans, what a reader must know of them, the files."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from functools import partial
from io import BufferedRandom
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trajopt_cli import __version__
from trajopt_cli.errors import InputError
from trajopt_cli.findings import Finding, Report, collisions
from trajopt_cli.job import Job
from trajopt_cli.motion import Wait
from trajopt_cli.pipeline.planning import Clock, Listener, changes_of, may_change, plan_all, undriven
from trajopt_cli.problem.constant_speed import Stretch, constant_speed
from trajopt_cli.problem.corners import PARABOLIC, Corners, corners_of, passed_in
from trajopt_cli.problem.editable import Changes, Loops
from trajopt_cli.problem.objective import LEAST_TIME, LeastEffort, Objective, for_the_other
from trajopt_cli.problem.plan import Infeasible, NoPlan, Plan, Target
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.problem.tool_turns import turned
from trajopt_cli.runs import REPORT, SUMMARY
from trajopt_cli.runs.folder import check_replaceable, library_versions, write_run
from trajopt_cli.runs.record import INPUT, InputFile, Inputs, RunRecord, Section, as_json, sha256
from trajopt_cli.runs.results import CHOSEN, CSV, PlanOptions, PlanRecord, distinct_names
from trajopt_cli.runs.rows import RowsFile
from trajopt_cli.runs.summary import Judged, Summary, settled, summary
from trajopt_cli.runs.uncertainty import WRITTEN
from trajopt_cli.workers import cores

if TYPE_CHECKING:
    from trajopt_cli.exporters.rapid_write import RapidExport

_ROBOT = f"{INPUT}robot/"
_ROUNDING = 1e-6  # s
_WORTH = 5e-3  # s of an estimate that are worth a word


@dataclass(frozen=True)
class Illegal:
    """The judge forbids a plan: an error in trajopt itself, never a result. label: what was being solved."""

    label: str
    finding: Finding


@dataclass(frozen=True)
class Collides:
    """A plan that keeps every limit but touches something, as the judge finds. hits: in time order."""

    label: str
    hits: tuple[Finding, ...]


def refused(target: Target, report: Report) -> Illegal | Collides:
    """The answer where the judge forbids the plan of a target."""
    hits = report.collisions
    return Collides(target.value, hits) if hits else Illegal(target.value, report.worst)


@dataclass(frozen=True, eq=False)
class OptimizedJob:
    """The answer of optimize: what summary.json says, the motions behind it, and where the files are.

    lead: whose plan is told first. judged: both targets' plans. written: the program as it stands, driven under the
    same limits, or why it cannot be.
    kept_speed: the stretches that should keep their programmed speed, with the dips of each target's plan.
    no_rapid: why the RAPID plan could not be written as RAPID; then rapid_files is empty.
    """

    job: Job
    lead: Target
    summary: Summary
    judged: Mapping[Target, Judged]
    written: Plan | str
    kept_speed: Mapping[Target, tuple[Stretch, ...]]
    folder: Path
    rapid_files: tuple[str, ...]
    no_rapid: str | None
    seconds: Mapping[str, float]


def optimize_job(
    job: Job,
    target: Target | None,
    folder: Path,
    listen: Listener,
    plots: bool = False,
    loops: Loops = Loops.KEEP,
    patience: Patience | None = None,
    jobs: int | None = None,
    objective: Objective = LEAST_TIME,
) -> OptimizedJob | Infeasible | NoPlan | Illegal | Collides:
    """Solve both targets, judge both, and write the results folder; nothing is written unless both are legal.

    target: which plan leads, and trajectory.csv carries; None: that for the RAPID controller leads, where its text can
    carry it, and the file has the stream's. plots: pictures of the file's plan. loops: what the RAPID plan makes of
    them.
    patience: how long a faster plan is looked for. jobs: processes, by default one for every core. objective: of
    that plan; where the other one takes longer than a given time, it takes its least.
    Raises InputError where folder may not be replaced.
    """
    from trajopt_cli.exporters.rapid_diff import unified_diff
    from trajopt_cli.judge.clearance import check_start
    from trajopt_cli.nlp.block_cache import evaluation_notices
    from trajopt_cli.plan.uncertainty import uncertainty

    check_replaceable(folder)
    start = f"{job.cell.file}: the start pose"
    if hits := collisions(check_start(job.program.from_start, job.plant.at_home, start)):
        return Collides("", hits)
    clock, started = Clock({"read": job.read_seconds}), datetime.now(UTC)
    patience = patience or Patience()
    listen("program", Progress("reach"))
    with clock.phase("reach"):
        agreed = may_change(job, loops)
    if agreed.infeasible is not None:
        return agreed.infeasible
    changes, loops = agreed.changes, agreed.loops
    inputs = inputs_of(job)
    found: dict[Target, Judged] = {}
    chosen = target or Target.STREAM
    asked = {one: objective if one is chosen else for_the_other(objective) for one in Target}
    kept, kept_written = {one: RowsFile(folder, job.plant) for one in Target}, RowsFile(folder)
    jobs = jobs or cores()
    answers, written, estimate = plan_all(job, listen, clock, changes, patience, jobs, asked, kept, kept_written)
    for one, answer in answers.items():
        if not isinstance(answer, Judged):
            return answer
        if not answer.report.legal:
            return refused(one, answer.report)
        found[one] = answer
    judged = {one: found[one] for one in Target}
    timed = {one.value: judged[one].plan for one in Target} | ({} if isinstance(written, str) else {WRITTEN: written})
    with clock.phase("uncertainty"):
        unsure = uncertainty(job.program, job.plant, job.scenario.settle, timed)
    listen("results", Progress("loops"))
    with clock.phase("loops"), patience.cutting():
        unrolled = tuple(_unrolled(job, changes[Target.RAPID], loops, estimate))
        held = tuple(held_by_default(job, partial(_freed, job, loops, estimate)))
    listen("results", Progress("write"))
    with clock.phase("export"):
        export, no_rapid = _export(job, judged[Target.RAPID].plan, loops)
        notices = (*_notices(job, judged), *held, *agreed.notices, *evaluation_notices())
        if no_rapid is not None:
            notices = (*notices, f"no RAPID text: {no_rapid}")
        notices = (*notices, *_of_given_time(asked, judged), *_suspicious(judged), *late_first(patience))
        placed = map(str, export.notes) if export is not None else ()
        draw = plots and (patience.limit is None or patience.spent < patience.limit)
        notices = (*notices, *(["no pictures were drawn: the time limit was over"] if plots and not draw else []))
        ways = tuple(_said_once({one: judged[one].plan.notes for one in Target}))
        notes = (*ways, *_configurations(job, judged), *placed, *changes[Target.RAPID].kept, *unrolled)
        lead = target or (Target.RAPID if export is not None else Target.STREAM)
        kept_speed = {one: constant_speed(job.program, judged[one].plan, job.plant) for one in Target}
        told = summary(
            job.program,
            job.plant,
            chosen,
            judged,
            written,
            kept_speed,
            corners_of(job.program, job.plant),
            {one: len(passed_in(job.program, job.plant, judged[one].plan)) for one in Target},
            notices,
            notes,
            changes[Target.RAPID].kept,
            undriven(job),
            unsure,
            settled(job.program, job.scenario.settle),
        )
        files = _files(job, told, judged, inputs, export)
        changed = no_rapid or ""
        if export is not None:
            changed = unified_diff(job.program.files, export.texts)
    options = PlanOptions(
        program=[str(path) for path in job.paths],
        cell=str(job.cell_path),
        entry=job.program.entry,
        assume_identity=list(job.assume_identity),
        target=chosen.value,
        loops=loops,
        cycle_time=objective.seconds if isinstance(objective, LeastEffort) else None,
    )
    with clock.phase("page"):
        files[REPORT] = _page(job, lead, told, judged, written, inputs, options, kept_speed, changed)
    if draw:
        listen("results", Progress("plots"))
        with clock.phase("plots"):
            files |= plan_pictures(job, judged[chosen].plan)
    first, cell = inputs[next(iter(job.program.files))], inputs[str(job.cell_path)]
    write_run(
        folder,
        PlanRecord,
        files,
        command="optimize",
        options=options,
        inputs=Inputs(
            program=first.place,
            cell=cell.place,
            robot=robot_place(job),
            files=[one.record(rapid=export is not None) for one in dict.fromkeys((first, cell, *inputs.values()))],
        ),
        no_rapid=no_rapid,
        added=[],
        started=started.isoformat(),
        seconds={name: round(value, 3) for name, value in clock.seconds.items()},
    )
    modules = tuple(given.rapid for given in inputs.values() if given.rapid in files)
    return OptimizedJob(job, lead, told, judged, written, kept_speed, folder, modules, no_rapid, clock.seconds)


def _export(job: Job, rapid: Plan, loops: Loops) -> tuple[RapidExport | None, str | None]:
    """The RAPID export; None, and why, where the program's text cannot carry the plan, which is as good without."""
    from trajopt_cli.exporters.files import faster_than_programmed
    from trajopt_cli.exporters.rapid import export_rapid

    faster = faster_than_programmed(job.program, rapid, job.plant)
    try:
        return export_rapid(job.program, rapid, job.plant, faster, job.scenario, loops), None
    except InputError as error:
        return None, str(error)


def _files(
    job: Job,
    told: Summary,
    judged: Mapping[Target, Judged],
    inputs: Mapping[str, InputFile],
    export: RapidExport | None,
) -> dict[str, bytes | BufferedRandom]:
    """The results folder's files but run.json and the page."""
    rows = {one: judged[one].rows.content for one in Target}
    files: dict[str, bytes | BufferedRandom] = {
        SUMMARY: as_json(told),
        CHOSEN: rows[told.target],
        **{CSV[one]: rows[one] for one in Target},
    }
    for given in inputs.values():
        files[given.place] = given.content
        if given.rapid is not None and export is not None:
            files[given.rapid] = export.texts[given.path].encode(job.program.files[given.path].encoding)
    return files


def _page(
    job: Job,
    lead: Target,
    told: Summary,
    judged: Mapping[Target, Judged],
    written: Plan | str,
    inputs: Mapping[str, InputFile],
    options: PlanOptions,
    kept_speed: Mapping[Target, tuple[Stretch, ...]],
    changed: str,
) -> bytes:
    """report.html, which shows all of this. changed: the RAPID text as a diff, or why there is none."""
    from trajopt_cli.page.optimized import Provenance, optimized_page

    given = Provenance(
        made_by("optimize", PlanRecord, options), {path: sha256(one.content) for path, one in inputs.items()}
    )
    return optimized_page(job.title, job.program, job.plant, lead, told, judged, written, given, kept_speed, changed)


def made_by(command: str, model: type[RunRecord[Any]], options: Section) -> list[tuple[str, str]]:
    """What a page says of its making, by name: command, options that were given, versions."""
    given = options.model_dump(mode="json", exclude_defaults=True)
    said = {
        name.replace("_", " "): ", ".join(map(str, one)) if isinstance(one, list) else str(one)
        for name, one in given.items()
    }
    versions = ", ".join(f"{name} {number}" for name, number in library_versions(model).items())
    return [
        ("made by", f"trajopt {__version__} {command}"),
        *said.items(),
        ("libraries", versions),
        ("when, and how long it took", "in run.json beside this page, so that the same input gives the same page"),
    ]


def _unrolled(job: Job, kept: Changes, loops: Loops, now: float | None) -> Iterator[str]:
    """What it would save to let every pass of a loop or routine have its own answer, by the search's estimates. now:
    that of the rapid plan [s]."""
    from trajopt_cli.plan import search_estimate

    often = len({motion.written.statement for motion in job.program.motions}) < len(job.program.motions)
    if loops is Loops.UNROLL or not (often or kept.kept):
        return
    free = changes_of(job, Target.RAPID, Loops.UNROLL)
    if now is None or (free.values, free.ties) == (kept.values, kept.ties):
        return
    try:
        then = search_estimate(job.program, job.plant, Target.RAPID, free)
    except Stopped:
        yield "what --loops unroll would save was not estimated: the time was over"
        return
    if then is None:
        return
    yield f"--loops unroll would save {_saved(now, then)}"


def _freed(job: Job, loops: Loops, now: float | None) -> str:
    """What it would save to let the rail move in the waits that hold it unasked, likewise; empty where nobody knows."""
    from trajopt_cli.plan import search_estimate
    from trajopt_cli.rapid.execution.rail import freed_by_default

    if now is None:
        return ""
    free = replace(job, program=freed_by_default(job.program))
    try:
        then = search_estimate(free.program, job.plant, Target.RAPID, changes_of(free, Target.RAPID, loops))
    except Stopped:
        return "; what that would save was not estimated: the time was over"
    return "" if then is None else f", which would save the rapid plan {_saved(now, then)}"


def _saved(now: float, then: float) -> str:
    """What a change is worth, by the search's estimates [s]."""
    saved = f"about {now - then:.2f} s ({(now - then) / now:.1%}) more" if now - then >= _WORTH else "nothing"
    return f"{saved}, by an estimate of the search"


def _said_once(notes: Mapping[Target, Sequence[str]]) -> Iterator[str]:
    """The notes of both plans, with whose they are. A way around that both go is told in one line; only the RAPID plan
    may go it by points."""
    rapid, stream = list(notes[Target.RAPID]), list[str]()
    for note in notes[Target.STREAM]:
        more = next((other for other in rapid if other == note or other.startswith(f"{note} by ")), None)
        if more is None:
            stream.append(note)
            continue
        rapid.remove(more)
        points = more.removeprefix(note)
        yield f"stream and rapid: {note}{f', rapid{points}' if points else ''}"
    yield from (f"rapid: {note}" for note in rapid)
    yield from (f"stream: {note}" for note in stream)


def _configurations(job: Job, judged: Mapping[Target, Judged]) -> Iterator[str]:
    """Which moves end in another configuration than programmed, by target; and where nobody can be sure."""
    from trajopt_cli.problem.configurations import changed_configurations, unsure_nearest

    for target, one in judged.items():
        for line in changed_configurations(job.program, job.plant, one.plan):
            yield f"{target.value}: {line}"
    rapid = judged[Target.RAPID].plan
    for line in unsure_nearest(turned(job.program, rapid.turns), job.plant, rapid):
        yield f"{Target.RAPID.value}: {line}"


def plan_pictures(job: Job, plan: Plan) -> dict[str, bytes]:
    """The pictures of one plan and of the program in steps of speed, by their place in a results folder."""
    from trajopt_cli.report.pictures import draw, stepwise
    from trajopt_cli.report.stepwise import analyse

    name = job.title
    pictures = draw(job.program, job.plant, plan, name)
    pictures |= stepwise(job.program, job.plant, analyse(job.program, job.plant), name)
    return {f"plots/{place}": content for place, content in pictures.items()}


def _notices(job: Job, judged: Mapping[Target, Judged]) -> tuple[str, ...]:
    """What a reader of the cycle times must know: the program's oddities, what is planned otherwise than it asks."""
    from trajopt_cli.problem.loads import load_notes
    from trajopt_cli.problem.plannable import planned_otherwise

    no_stops = {target: _no_stops(job, one.plan) for target, one in judged.items()}
    out = [*fly_bys_told(corners_of(job.program, job.plant), no_stops)]
    waits = [m for m in job.program.motions if isinstance(m, Wait) and m.condition is not None]
    if waits:
        least = sum(wait.programmed for wait in waits)
        out.append(
            f"{len(waits)} wait{'s' if len(waits) > 1 else ''} for signals or operators: counted with the least time "
            f"that the cell file gives, {least:g} s in all; real waiting comes on top"
        )
    counted = load_notes(job.program, job.plant)
    otherwise = planned_otherwise(job.program, bool(counted))
    return (*map(str, job.program.warnings), *out, *otherwise, *counted)


def _of_given_time(asked: Mapping[Target, Objective], judged: Mapping[Target, Judged]) -> Iterator[str]:
    """What plans of least effort do not do."""
    for target, objective in asked.items():
        plan = judged[target].plan
        if isinstance(objective, LeastEffort) and objective.seconds and plan.duration > objective.seconds + _ROUNDING:
            yield (
                f"the {target} plan takes {plan.duration:.3f} s: {objective.seconds:g} s is below the least time found "
                "for it"
            )
    if any(isinstance(objective, LeastEffort) for objective in asked.values()):
        yield (
            "the RAPID text does not say how gently its moves are driven: a controller drives them as fast as their "
            "speeds allow; rapid.csv is the motion meant"
        )


def _suspicious(judged: Mapping[Target, Judged]) -> Iterator[str]:
    """A word on plans that are far slower than can be expected, and what to do about it."""
    for target, one in judged.items():
        if (why := one.plan.suspicion) is not None:
            yield (
                f"the {target.value} plan is suspicious: {why}; it is legal, but far from what can be expected: see "
                "which motions take longest, give it more time where --time-limit or Ctrl-C ended the search, and "
                "report the program if that does not help"
            )


def late_first(patience: Patience) -> Iterator[str]:
    """A word where the first legal motion came behind the time limit."""
    if (first := patience.late) is not None:
        yield (
            f"the first legal motion was there after {first:.0f} s: the time limit of {patience.limit:g} s was too "
            "short for any"
        )


def _no_stops(job: Job, plan: Plan) -> frozenset[int]:
    """The fly-bys that a plan passes, or leaves out."""
    dropped = (motion.index for motion in plan.motions if motion.dropped)
    return passed_in(job.program, job.plant, plan).union(dropped)


def fly_bys_told(corners: Corners, plans: Mapping[Target, Collection[int]] | None = None) -> Iterator[str]:
    """How many fly-by points are passed, and how many are stops, and why. plans: the motions at whose end a plan stops
    not; of the others it stops at what could be passed."""
    if passed := len(corners.passed):
        points = "fly-by points are passed in corners" if passed > 1 else "fly-by point is passed in a corner"
        yield f"{passed} {points}: {PARABOLIC}"
        for target, moving in (plans or {}).items():
            if stops := sum(index not in moving for index in corners.passed):
                why = "joint moves between stops may bend"
                yield f"the {target.value} plan stops at {stops} of them: {why}"
        if joint := sum(zone.joint for zone in corners.passed.values()):
            yield f"joint interpolated, as tool or work object change: {joint} of {passed} corners"
    if stopped := len(corners.stopped):
        points = "fly-by points are stops" if stopped > 1 else "fly-by point is a stop"
        whys = ", ".join(f"{why} ({count})" for why, count in Counter(corners.stopped.values()).items())
        yield f"{stopped} {points}: {whys}"


def held_by_default(job: Job, worth: Callable[[], str] = str) -> Iterator[str]:
    """A word on the waits that hold the rail though nobody asked for it, and what it is worth; none without a rail."""
    from trajopt_cli.rapid.execution import rail

    if job.plant.rail_eaxes and (held := rail.held_by_default(job.program)):
        yield f"{held}{worth()}"


def robot_place(job: Job) -> str | None:
    """Where the folder keeps the robot's own YAML file; None for a robot that ships."""
    files = job.cell.robot_files(job.plant.robot.files)
    return f"{_ROBOT}{files[0].name}" if files else None


def inputs_of(job: Job) -> dict[str, InputFile]:
    """Every file the job was read from, by the path it was read under, with its exact bytes."""
    inputs = {}
    for path, name in distinct_names(list(job.program.files)).items():
        place = "program.mod" if len(job.program.files) == 1 else f"program/{name}"
        inputs[path] = InputFile(path, f"{INPUT}{name}", Path(path).read_bytes(), place)
    for mesh in job.cell.mesh_files:
        copy = mesh.relative_to(job.cell_path.parent).as_posix()
        inputs[str(mesh)] = InputFile(str(mesh), f"{INPUT}{copy}", mesh.read_bytes())
    for file in (own := job.cell.robot_files(job.plant.robot.files)):
        copy = file.relative_to(own[0].parent).as_posix()
        inputs[str(file)] = InputFile(str(file), f"{_ROBOT}{copy}", file.read_bytes())
    cell = str(job.cell_path)
    inputs[cell] = InputFile(cell, f"{INPUT}{job.cell_path.name}", job.cell_path.read_bytes())
    return inputs
