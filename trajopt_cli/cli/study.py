"""`trajopt study STUDY.yaml`: a cell's keys varied, every point planned, on this computer or a Dask cluster."""

from __future__ import annotations

from contextlib import contextmanager, nullcontext
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperGroup

from trajopt_cli.cli.options import Jobs, Quiet
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

Output = Annotated[
    Path | None, typer.Option("--output", metavar="FOLDER", help="Results folder; default: results/STUDY.")
]
StudyFile = Annotated[Path, typer.Argument(metavar="STUDY.yaml", help="What varies, and what is asked.")]
Scheduler = Annotated[
    str | None,
    typer.Option("--scheduler", metavar="tcp://HOST:PORT", help="A Dask cluster's scheduler; default: this computer."),
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
    jobs: Jobs = None,
    dry_run: Annotated[
        bool,
        typer.Option("--dry-run", help="Say how many points there are and, from three of them, how long it takes."),
    ] = False,
    output: Output = None,
    quiet: Quiet = False,
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
