"""What studies that search over plans share: the judge's word on a plan, and a results folder for an answer."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trajopt_cli.job import Job
from trajopt_cli.motion import Program, Source
from trajopt_cli.pipeline.optimize import inputs_of
from trajopt_cli.pipeline.planning import judge
from trajopt_cli.problem.decision_scope import EVERYTHING, Freedom
from trajopt_cli.problem.detours import held_against
from trajopt_cli.problem.editable import Changes
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.runs.folder import write_run
from trajopt_cli.runs.record import Inputs, RunRecord
from trajopt_cli.runs.rows import RowsFile

if TYPE_CHECKING:
    from trajopt_cli.plan import PlanCache


def plan_of(
    job: Job,
    target: Target,
    changes: Changes,
    patience: Patience | None,
    freedom: Freedom = EVERYTHING,
    memory: PlanCache | None = None,
) -> Plan | Infeasible:
    """The plan of a target, without a bound; without patience its first legal motion, which nothing refines. memory: as
    in optimize. Raises NoCleanPlan where the planner fails."""
    from trajopt_cli.plan import optimize

    if patience is None:
        patience = Patience()
        patience.interrupt()
    return optimize(
        job.program, job.plant, target, freedom, bounded=False, changes=changes, memory=memory, patience=patience
    )


def why_illegal(plant: Plant, program: Program, plan: Plan, target: Target) -> tuple[str, Source | None] | None:
    """What the judge holds against a plan of a program, first of all, and on which line; None for a legal one."""
    rows = RowsFile()
    rows.keep(plan)
    dropped = tuple(motion.index for motion in plan.motions if motion.dropped)
    driven, left_out = held_against(program, plant, target, plan.detours, dropped)
    report = judge(plant, driven, rows.text, target.value, left_out, target, advice=False)
    if report.legal:
        return None
    hits = report.collisions
    found = hits[0] if hits else report.worst
    return f"collides: {found.message}" if hits else found.message, found.source


def study_record(kind: str) -> type[RunRecord[dict[str, Any]]]:
    """run.json of a study that searches over plans: the model for folders of this kind."""
    libraries = ("casadi", "numpy", "pin", "scipy")
    return type(f"{kind.title()}Record", (RunRecord[dict[str, Any]],), {"KIND": kind, "LIBRARIES": libraries})


def write_answer(
    folder: Path, model: type[RunRecord[Any]], job: Job, files: Mapping[str, bytes], options: Any, command: str = ""
) -> int:
    """Write the files of an answer and the inputs of its job; how many that are.

    model: of run.json. options: as the user gave them. command: that made it, by default the folder's kind. Raises
    InputError where folder may not be replaced.
    """
    inputs = inputs_of(job)
    every = {**files, **{given.place: given.content for given in inputs.values()}}
    first, cell = inputs[next(iter(job.program.files))], inputs[str(job.cell_path)]
    listed = Inputs(program=first.place, cell=cell.place, files=[one.record(rapid=False) for one in inputs.values()])
    write_run(folder, model, every, command or model.KIND, options=options, inputs=listed)
    return len(every)
