"""`trajopt study`: a cell's keys varied, every point planned, here or on a Dask cluster; what they say together."""

from __future__ import annotations

from contextlib import contextmanager, nullcontext
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperGroup

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import wrote
from trajopt_cli.errors import InputError
from trajopt_cli.workers import handed_to

if TYPE_CHECKING:
    from collections.abc import Iterator
    from contextlib import AbstractContextManager

    from distributed import Client

    from trajopt_cli.problem.stop_condition import Patience


class _RunUnlessNamed(TyperGroup):
    """`trajopt study STUDY.yaml` is `trajopt study run STUDY.yaml`."""

    def parse_args(self, ctx: Any, args: list[str]) -> Any:
        """Of the base class, with run before a study file and before options of run."""
        if args and args[0] != "--help" and (args[0].startswith("--") or args[0].endswith((".yaml", ".yml"))):
            args = ["run", *args]
        return super().parse_args(ctx, args)


app = typer.Typer(cls=_RunUnlessNamed, help="Vary a cell and plan every point.", rich_markup_mode=None)

Output = Annotated[Path | None, opt.results_at("results/STUDY")]
StudyFile = Annotated[Path, typer.Argument(metavar="STUDY.yaml", help="What varies, and what is asked.")]
Scheduler = Annotated[
    str | None, opt.given("--scheduler", "tcp://HOST:PORT", "A Dask cluster's scheduler; default: this computer.")
]


def client_for(scheduler: str | None, jobs: int | None, memory: float | None) -> AbstractContextManager[Client]:
    """A Dask client: of the cluster at an address, or of one on this computer. Raises InputError where Dask is not
    installed, and for a scheduler that does not answer."""
    with study_extra():
        from trajopt_cli.parameter_study.cluster import client_at, local_client
    if scheduler is not None and jobs is not None:
        raise InputError("--jobs: the cluster of --scheduler has its own workers; leave one of them out")
    return local_client(jobs, memory) if scheduler is None else client_at(scheduler)


def tasks_on(scheduler: str | None, patience: Patience) -> AbstractContextManager[None]:
    """What a study shares out inside is done by the cluster at an address, if one is given. Raises InputError where
    Dask is not installed."""
    if scheduler is None:
        return nullcontext()
    with study_extra():
        from trajopt_cli.parameter_study.cluster import tasks_at
    return handed_to(partial(tasks_at, scheduler, patience))


@contextmanager
def study_extra() -> Iterator[None]:
    """Around imports from the extra `study`. Raises InputError where one of its libraries is not installed."""
    try:
        yield
    except ImportError as error:
        if (error.name or "").split(".")[0] not in ("dask", "distributed", "pyarrow", "optuna"):
            raise
        raise InputError(f"{error.name} is not installed: pip install 'trajopt-cli[study]'") from error


@app.callback()
def _group() -> None:
    """Vary a cell and plan every point: STUDY.yaml alone runs the study."""


@app.command("run", short_help="Plan every point of a study; goes on where it was stopped.")
def run(
    study: StudyFile,
    scheduler: Scheduler = None,
    jobs: opt.Jobs = None,
    dry_run: Annotated[
        bool,
        typer.Option("--dry-run", help="Say how many points there are and, from three of them, how long it takes."),
    ] = False,
    output: Output = None,
    quiet: opt.Quiet = False,
) -> None:
    """Plan every point of a study and write a row for each; `run` may be left out.

    A study that was stopped goes on where it was. Exit code 1: no point can be done.

    \b
    Example:
      trajopt study run programs/studies/which_rail.yaml --dry-run --jobs 1
    """
    from trajopt_cli.cli.console import no, result, stdout, tell, warn
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.parameter_study.study_file import read_study

    asked = read_study(study)
    with study_extra():
        from trajopt_cli.parameter_study import results
        from trajopt_cli.parameter_study import run as study_run
    folder = output or Path("results") / study.stem
    if not dry_run:
        results.new_or_same(folder, asked)
        wrote(folder)
    with client_for(scheduler, jobs, asked.inputs.memory) as client:
        if not quiet:
            warn(f"Dask's dashboard: {client.dashboard_link}")
        try:
            with ProgressView(quiet=quiet) as view:
                if dry_run:
                    said = study_run.dry_run(asked, client, view.show)
                else:
                    _, tally = study_run.run_study(asked, folder, client, view.show)
        except KeyboardInterrupt:
            warn(f"{folder} holds what had come back; the same command goes on from there")
            raise
    if dry_run:
        result(said)
        return
    counts = ", ".join(f"{count} {status}" for status, count in sorted(tally.counts.items()))
    line = f"{tally.points} points: {counts}"
    if tally.best is None:
        no([line], False)
    line = f"{line}; fastest: {tally.best[0]:.3f} s, point {tally.best[1]}"
    result(line) if quiet else tell(stdout(), [line, f"written to {folder}: points.parquet and its parts"])


@app.command("show", short_help="The best points of a study, what matters most, and its page.")
def show(
    folder: Annotated[Path, typer.Argument(metavar="FOLDER", help="Results folder of trajopt study.")],
    by: Annotated[
        str | None, opt.given("--by", "COLUMN", "The answer that counts; default: the first of them, as rapid_s.")
    ] = None,
    against: Annotated[
        str | None, opt.given("--against", "COLUMN", "The Pareto front of both; default: price, where it is known.")
    ] = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Show the best points of a study, what matters most, and the front of two answers; and draw its page.

    A study that is not done yet is shown as far as it is. Exit code 1: no point has an answer, and why.

    \b
    Example:
      trajopt study show results/which_rail --by saved_s
    """
    from dataclasses import asdict

    from trajopt_cli.cli.console import no, print_answer, told
    from trajopt_cli.parameter_study.analysis import StudyRows, variance_shares
    from trajopt_cli.parameter_study.backups import PLANS
    from trajopt_cli.parameter_study.study_page import BEST, front, reasons, study_page, summary_lines, tables
    from trajopt_cli.runs import REPORT
    from trajopt_cli.runs.files import write_file

    with study_extra():
        from trajopt_cli.parameter_study.results import open_study
    study = open_study(folder)
    rows = StudyRows(study.rows().to_pydict(), {one.name: one.unit for one in study.columns})
    if not rows.answers:
        no(["no point of the study has an answer", *reasons(rows)], as_json)
    name = rows.chosen(by)
    other = rows.chosen(against) if against else "price" if "price" in rows.answers and name != "price" else None
    shares = variance_shares(rows, name)
    plans = {int(page.parts[-2]): page.relative_to(folder).as_posix() for page in folder.glob(f"{PLANS}/*/{REPORT}")}
    lines = summary_lines(rows, name, study.points)
    record = {"by": name, "points": study.points, "summary": lines, "best": rows.records(rows.best(name)[:BEST])}
    record |= {"front": rows.records(front(rows, name, other)) if other else None, "against": other}
    record |= {"shares": None if shares is None else asdict(shares)}
    parts = [part for made in tables(rows, name, other, shares).values() for part in (made, "")]
    parts += [*([] if shares is None else [shares.in_words]), "", *lines]
    print_answer(as_json, quiet, lambda: record, "; ".join(lines[:2]), parts)
    write_file(folder / REPORT, study_page(folder.resolve().name, rows, name, other, study.points, shares, plans))
    wrote(folder / REPORT)
    told([f"written to {folder / REPORT}: open it in a browser"], as_json, quiet)


@app.command("plan", short_help="Plan points of a study wholly, and keep the plans with their pages.")
def plan(
    study: StudyFile,
    points: Annotated[list[int], typer.Argument(metavar="POINT...", help="Their numbers, as 'study show' has them.")],
    time_limit: opt.TimeLimit = None,
    output: Output = None,
    quiet: opt.Quiet = False,
) -> None:
    """Plan points of a study as trajopt optimize does, into plans/POINT of its results; 'study show' links to them.

    Exit code 1: one of them cannot be done, and why.

    \b
    Example:
      trajopt study plan programs/studies/which_rail.yaml 21 --time-limit 60
    """
    from trajopt_cli.cli.console import no, stdout, tell
    from trajopt_cli.parameter_study.backups import PLANS, keep_plan
    from trajopt_cli.parameter_study.study_file import read_study
    from trajopt_cli.table import seconds

    options = opt.passed_on(time_limit)
    asked, folder, bad = read_study(study), output or Path("results") / study.stem, list[str]()
    for point in points:
        row = keep_plan(asked, point, folder, options)
        if row["status"] != "ok":
            bad.append(f"point {point}: {row['reason']}")
            continue
        wrote(folder / PLANS / str(point))
        line = f"point {point}: {seconds(row['as_written_s'], 'not known')} s → {seconds(row['rapid_s'])} s"
        tell(stdout(quiet), [f"{line}, in {folder / PLANS / str(point)}"])
    if bad:
        no(bad, False)


@app.command("optimize", short_help="Search for the best point of what a study varies.")
def optimize(
    study: StudyFile,
    by: Annotated[str, opt.given("--by", "COLUMN", "The answer to make best.")] = "rapid_s",
    constraint: Annotated[
        list[str] | None,
        opt.given(
            "--constraint",
            "TEXT",
            "What the best point keeps, as 'price <= 20000' or 'limits.rail.velocity <= 2', SI; may be repeated.",
        ),
    ] = None,
    points: Annotated[int, opt.given("--points", "N", "Points that are tried.", min=1)] = 100,
    seed: Annotated[int, opt.given("--seed", "N", "Of the search's random numbers.", min=0)] = 0,
    at_once: Annotated[int, opt.given("--at-once", "N", "Points tried before the search learns from them.", min=1)] = 8,
    scheduler: Scheduler = None,
    jobs: opt.Jobs = None,
    output: Annotated[Path | None, opt.results_at("results/STUDY_best")] = None,
    quiet: opt.Quiet = False,
) -> None:
    """Search for the best point of what a study varies, within constraints, instead of trying all of them.

    The answer depends on --seed, --points and --at-once, not on the cluster. A search that was stopped goes on. Exit
    code 1: no point that was tried can be done and keeps the constraints.

    \b
    Example:
      trajopt study optimize programs/studies/which_rail.yaml --points 12
    """
    from trajopt_cli.cli.console import no, result, stdout, tell
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.parameter_study.study_file import read_study

    asked = read_study(study)
    with study_extra():
        from trajopt_cli.parameter_study.search import Goal, search
    answers = [f"{one}_s" for one in (*asked.inputs.answers, "saved")] + ["price"] * (asked.inputs.price is not None)
    if by not in answers:
        raise InputError(f"--by {by}: this study's answers are {', '.join(answers)}", file=str(study))
    goal = Goal(by, tuple(constraint or ()), points, seed, at_once)
    folder = output or Path("results") / f"{study.stem}_best"
    with client_for(scheduler, jobs, asked.inputs.memory) as client, ProgressView(quiet=quiet) as view:
        best = search(asked, goal, folder, client, view.show)
    wrote(folder)
    if best is None:
        said = f"none of {points} points can be done and keeps the constraints; column reason in {folder} says more"
        no([said], False)
    names = [one.name for one in asked.inputs.columns if one.meaning.startswith(("offset: ", "cell file: "))]
    varied = (f"{name} {f'{best[name]:.6g}' if isinstance(best[name], float) else best[name]}" for name in names)
    line = f"best of {points} points: {by} {best[by]:.3f} at {', '.join(varied)}"
    result(line) if quiet else tell(stdout(), [line, f"written to {folder}; 'trajopt study show {folder}' shows all"])
