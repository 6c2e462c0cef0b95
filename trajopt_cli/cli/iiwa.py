"""`trajopt iiwa segments|joints|simulate|dose|experiments`: what a compliant controller is fed, and makes of it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, NoReturn

import typer

from trajopt_cli.cli.options import AsJson, Quiet
from trajopt_cli.cli.process import wrote
from trajopt_cli.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from trajopt_cli.iiwa.controller.feed_limits import Lead
    from trajopt_cli.iiwa.job.simulation import NoRun

app = typer.Typer(help="Cartesian segments for a compliant KUKA LBR iiwa 7.", rich_markup_mode=None)

TaskResults = Annotated[Path, typer.Argument(metavar="RESULTS", help="Results folder of trajopt iiwa segments.")]


@app.callback()
def _group() -> None:
    """Cartesian segments for a compliant KUKA LBR iiwa 7, its joints, and what the controller will make of them."""


@app.command("segments", short_help="TASK's poses in, one pose per period out.")
def segments(
    task: Annotated[
        Path,
        typer.Argument(metavar="TASK", help="Task file (YAML), or a RAPID program or CSV path that gives the poses."),
    ],
    output: Annotated[
        Path | None, typer.Option("--output", metavar="FOLDER", help="Results folder; default: results/TASK.")
    ] = None,
    task_file: Annotated[
        Path | None,
        typer.Option("--task", metavar="FILE.yaml", help="Task file of a program or path; default: beside it."),
    ] = None,
    angles: Annotated[
        Literal["relative", "absolute"] | None,
        typer.Option("--angles", help="Count angles from the start's orientation or from the world's axes."),
    ] = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Interpolate TASK: what the controller is fed every period, as CSV with angles and with quaternions.

    \b
    Example:
      trajopt iiwa segments programs/iiwa_cube.yaml
    """
    from trajopt_cli.cli.console import print_json, result, show, stdout, tell
    from trajopt_cli.cli.iiwa_tables import passing_lines, segments_table, sequence_line
    from trajopt_cli.iiwa.job.folder import read_summary
    from trajopt_cli.iiwa.job.segments import make_segments
    from trajopt_cli.iiwa.task.model import AngleMeaning

    folder = output or Path("results") / task.stem
    meaning = AngleMeaning(angles) if angles else None
    made = make_segments(task, folder, task_file, meaning, said(quiet))
    if as_json:
        print_json(read_summary(folder)["sequence"])
        return
    if quiet:
        result(sequence_line(made.opened.equilibrium))
        return
    console = stdout()
    show(console, segments_table(task.name, made.facts))
    tell(console, passing_lines(made.facts, made.opened.task.route))
    tell(console, [sequence_line(made.opened.equilibrium), *(f"note: {note}" for note in made.notes)])
    tell(console, [f"written to {folder}"])


@app.command("joints", short_help="RESULTS' joints in one configuration, the arm angle fixed or chosen.")
def joints(
    results: TaskResults,
    arm_angle: Annotated[
        Literal["fixed", "free", "optimal"],
        typer.Option(
            "--arm-angle", help="Keep it, let it change where the fixed one fails, or choose the best course."
        ),
    ] = "fixed",
    goal: Annotated[
        Literal["limits", "speed", "torque"] | None,
        typer.Option("--for", help="What is best: far from limits (default), slow joints, or little torque."),
    ] = None,
    plots: Annotated[
        Path | None, typer.Option("--plots", metavar="FOLDER", help="Draw the map of path and arm angle, too.")
    ] = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Inverse kinematics along the sequence, every sample held against position, speed and acceleration limits.

    Exit code 1 when a limit is broken or a pose is out of reach. joints.csv is written unless a joint passes its range
    or its speed, which would stop the controller.

    \b
    Example:
      trajopt iiwa segments programs/iiwa_cube.yaml
      trajopt iiwa joints results/iiwa_cube
    """
    from trajopt_cli.cli.console import no, print_json, result, show, stdout, tell
    from trajopt_cli.cli.iiwa_tables import (
        ahead_line,
        arm_line,
        chosen_lines,
        chosen_table,
        failure_lines,
        joints_table,
    )
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.iiwa.job.folder import check_place, read_summary
    from trajopt_cli.iiwa.job.joints import follow_joints, stops_nothing
    from trajopt_cli.iiwa.task.joints import Unfollowable
    from trajopt_cli.problem.progress import Progress
    from trajopt_cli.runs.transaction import write_files

    check_place(plots, "--plots")
    _check_results(results)
    if goal is not None and arm_angle != "optimal":
        raise InputError(f"--for {goal}: says what --arm-angle optimal is best for; the arm angle is {arm_angle} here")
    wanted = None
    if arm_angle == "optimal":
        from trajopt_cli.iiwa.task.arm_plan import Goal

        wanted = Goal(goal or "limits")
    with ProgressView(quiet=quiet) as view:
        opened, answer = follow_joints(
            results, arm_angle == "free", wanted, lambda phase: view.show("joints", Progress(phase))
        )
    assert opened.folder is not None
    ahead = [ahead_line(opened)] if "dosing" in opened.folder.sections() else []
    if isinstance(answer, Unfollowable):
        no((f"{opened.task.file}: {answer.message}", *ahead), as_json, answer="out of reach")
    failed = [finding for finding in answer.findings if not finding.passed]
    written = stops_nothing(answer)
    if written:
        wrote(results / "joints.csv")
    if as_json and written:
        print_json(read_summary(results)["joints"])
    elif as_json:
        print_json({"feasible": False, "answer": "limits broken", "why": [one.message for one in failed]})
    elif quiet:
        result(arm_line(answer))
    else:
        console = stdout()
        show(console, joints_table(opened.robot.name, answer))
        tell(console, [arm_line(answer)])
        if answer.plan is not None:
            show(console, chosen_table(answer.plan))
            tell(console, chosen_lines(answer.plan))
        tell(console, (f"note: {note}" for note in answer.notes))
        if written:
            tell(console, [f"written to {results / 'joints.csv'}"])
    if failed:
        for line in ahead or failure_lines(answer.findings):
            typer.echo(line, err=True)
    if not written:
        typer.echo("NOTHING WRITTEN" if ahead else "NOTHING WRITTEN: the controller's loop would stop there", err=True)
    if plots is not None:
        from trajopt_cli.iiwa.job.drawing import joint_pictures

        pictures = joint_pictures(opened, answer)
        write_files(plots, pictures)
        said(quiet)(f"drawn in {plots}: {len(pictures)} files")
    if failed:
        raise typer.Exit(1)


@app.command("simulate", short_help="What the compliant controller makes of RESULTS.")
def simulate(
    results: TaskResults,
    contact: Annotated[
        Path | None,
        typer.Option("--contact", metavar="FILE.yaml", help="What the tool may run into; default: the task's own."),
    ] = None,
    engine: Annotated[
        Literal["spring", "mujoco"] | None,
        typer.Option("--engine", help="What answers the tool; default: MuJoCo where it is installed."),
    ] = None,
    feed: Annotated[
        Literal["position", "velocity"] | None,
        typer.Option("--feed", help="Feed the equilibrium's speed, too; default: what RESULTS were made for."),
    ] = None,
    integration: Annotated[
        Literal["euler", "exact"] | None, typer.Option("--integration", help="How the law is stepped.")
    ] = None,
    settle: Annotated[
        float | None, typer.Option("--settle", min=0, max=600, metavar="S", help="How long the last pose is held.")
    ] = None,
    plots: Annotated[
        Path | None,
        typer.Option("--plots", metavar="FOLDER", help="Draw equilibrium, answer, lag, forces and the arm, too."),
    ] = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Run the admittance controller on the sequence: how far the arm lags, where, and with which force it would push.

    Writes simulation.csv and report.html into RESULTS. Exit code 1 when the controller is unstable, or a joint limit
    stops its loop.

    \b
    Example:
      trajopt iiwa segments programs/iiwa_cube.yaml
      trajopt iiwa simulate results/iiwa_cube --engine spring
    """
    from trajopt_cli.cli.console import print_json, result, show, stdout, tell
    from trajopt_cli.cli.iiwa_tables import contact_lines, lag_lines, loop_time_line, stability_table
    from trajopt_cli.iiwa.job.folder import check_place, read_summary
    from trajopt_cli.iiwa.job.simulation import NoRun
    from trajopt_cli.iiwa.job.simulation import simulate as run
    from trajopt_cli.iiwa.task.model import Feed, Integration
    from trajopt_cli.runs.transaction import write_files

    check_place(plots, "--plots")
    _check_results(results)
    if settle is not None and not settle < float("inf"):
        raise InputError(f"--settle: needs a time of 0 to 600 s, not {settle}")
    how = Integration(integration) if integration else None
    answer = run(results, contact, engine, Feed(feed) if feed else None, how, settle)
    if isinstance(answer, NoRun):
        no_run(answer, as_json)
    wrote(results / "simulation.csv")
    if as_json:
        print_json(read_summary(results)["simulation"])
    elif quiet:
        result(lag_lines(answer)[0])
    else:
        console = stdout()
        show(console, stability_table(answer.axes, answer.opened.equilibrium.h))
        tell(console, (*lag_lines(answer), *contact_lines(answer), *loop_time_line(answer)))
        tell(console, [f"written to {results}: report.html (open it in a browser), simulation.csv"])
    if plots is not None:
        from trajopt_cli.iiwa.job.drawing import simulation_pictures

        pictures = simulation_pictures(answer)
        write_files(plots, pictures)
        said(quiet)(f"drawn in {plots}: {len(pictures)} files")
    if broken := answer.broken:
        for line in broken:
            typer.echo(line, err=True)
        raise typer.Exit(1)


@app.command("dose", short_help="RESULTS retimed so that the controller follows.")
def dose(
    results: TaskResults,
    max_lag: Annotated[str, typer.Option("--max-lag", metavar="5mm", help="How far the arm may be from its plan.")],
    max_lead: Annotated[
        str | None,
        typer.Option(
            "--max-lead",
            metavar="50N|40mm",
            help="How hard the tool may begin to push if somebody holds it, or how far a spring that pushes as much is"
            " stretched; then every feed is tried.",
        ),
    ] = None,
    max_turn_lag: Annotated[
        str | None, typer.Option("--max-turn-lag", metavar="2deg", help="How far its orientation may.")
    ] = None,
    max_turn_lead: Annotated[
        str | None, typer.Option("--max-turn-lead", metavar="5Nm|8deg", help="The same of the moment.")
    ] = None,
    feed: Annotated[
        Literal["position", "velocity", "inverse"] | None,
        typer.Option(
            "--feed",
            help="What is fed: the plan, its speed too, or what moves the arm along it (u = x + D/K x' + M/K x'');"
            " default: positions, with a lead the fastest.",
        ),
    ] = None,
    front: Annotated[
        bool, typer.Option("--front", help="Show the least times for other leads, too; needs --max-lead.")
    ] = False,
    output: Annotated[
        Path | None, typer.Option("--output", metavar="FOLDER", help="Results folder; default: RESULTS-dosed.")
    ] = None,
    plots: Annotated[
        Path | None, typer.Option("--plots", metavar="FOLDER", help="Draw lag, speed and path before and after, too.")
    ] = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Retime the sequence: least time within the lag, and within the push that you allow, beside the run as it was.

    Exit code 1 when no such sequence is found or the arm cannot follow it; nothing is written then.

    \b
    Example:
      trajopt iiwa segments programs/iiwa_cube.yaml
      trajopt iiwa dose results/iiwa_cube --max-lag 5mm --max-lead 100N
    """
    from trajopt_cli.cli.console import no, print_json, result, show, stdout, tell
    from trajopt_cli.cli.iiwa_tables import dose_lines, dose_table, front_table
    from trajopt_cli.iiwa.controller.feed_limits import Allowed, DoseFeed
    from trajopt_cli.iiwa.controller.feed_schedule import CannotDose
    from trajopt_cli.iiwa.job.feed_scheduling import NotFollowed, dose_folder
    from trajopt_cli.iiwa.job.folder import check_place, read_summary
    from trajopt_cli.iiwa.job.simulation import NoRun
    from trajopt_cli.iiwa.task.joints import Unfollowable
    from trajopt_cli.quantity import ANGLE, FORCE, LENGTH, MOMENT, option_value
    from trajopt_cli.runs.transaction import write_files

    # '.' and '..' have no name of their own
    beside = results if results.name not in ("", "..") else results.resolve()
    folder = output or beside.with_name(f"{beside.name}-dosed")
    check_place(plots, "--plots")
    if plots is not None and folder.absolute() in (plots.absolute(), *plots.absolute().parents):
        raise InputError("--plots: is the folder of the results or lies in it; choose another", file=str(plots))
    lead = _lead(max_lead, FORCE, LENGTH, "--max-lead")
    if front and lead is None:
        raise InputError("--front: needs a bound on the lead; give --max-lead")
    allowed = Allowed(
        option_value(max_lag, LENGTH, "--max-lag"),
        None if max_turn_lag is None else option_value(max_turn_lag, ANGLE, "--max-turn-lag"),
        lead,
        _lead(max_turn_lead, MOMENT, ANGLE, "--max-turn-lead"),
    )
    answer = dose_folder(results, folder, allowed, DoseFeed(feed) if feed else None, front)
    if isinstance(answer, NoRun):
        no_run(answer, as_json)
    if isinstance(answer, CannotDose | Unfollowable):
        no([f"{results}: {answer.message}"], as_json, answer="no sequence")
    if isinstance(answer, NotFollowed):
        remedy = "allow less lead or lag, lower v_max, or move the path"
        last = f"NOTHING WRITTEN: the arm cannot follow; {remedy}"
        no([*answer.sentences, last], as_json, answer="not followed")
    wrote(folder)
    if as_json:
        print_json(read_summary(folder)["dosing"])
    elif quiet:
        result(dose_lines(answer)[0])
    else:
        console = stdout()
        show(console, dose_table(results.name, answer))
        tell(console, dose_lines(answer))
        if answer.front:
            show(console, front_table(answer))
        tell(console, [f"written to {folder}: report.html (open it in a browser) and the sequence"])
    if plots is not None:
        from trajopt_cli.iiwa.job.drawing import dose_pictures

        pictures = dose_pictures(answer)
        write_files(plots, pictures)
        said(quiet)(f"drawn in {plots}: {len(pictures)} files")


@app.command("experiments", short_help="Chapter 6 of the second thesis, its numbers beside ours.")
def experiments(
    output: Annotated[Path, typer.Option("--output", metavar="FOLDER", help="Folder for numbers and pictures.")] = Path(
        "results/iiwa_experiments"
    ),
    engine: Annotated[
        Literal["auto", "spring", "mujoco"], typer.Option("--engine", help="What moves the arm and answers the tool.")
    ] = "auto",
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Force steps, orientation, hand guiding, zeroing, stability, following, collision, loop time and dosing.

    \b
    Example:
      trajopt iiwa experiments --engine spring
    """
    from trajopt_cli.cli.console import print_json, result, show, stdout, tell
    from trajopt_cli.cli.experiments_tables import tables
    from trajopt_cli.iiwa.experiments.catalogue import run_experiments
    from trajopt_cli.iiwa.experiments.folder import write_experiments
    from trajopt_cli.iiwa.experiments.record import record
    from trajopt_cli.iiwa.job.folder import check_place
    from trajopt_cli.runs.folder import check_replaceable

    check_place(output, "--output")
    check_replaceable(output)
    answer = run_experiments(lambda name: said(quiet)(f"experiment {name}"), engine)
    if as_json:
        print_json(record(answer))
    elif not quiet:
        console = stdout()
        for part in tables(answer):
            if isinstance(part, str):
                tell(console, part.split("\n"))
            else:
                show(console, part)
    count = write_experiments(output, answer)
    if quiet and not as_json:
        result(f"written to {output}: {count} files")
    else:
        said(quiet)(f"written to {output}: report.html (open it in a browser) and {count - 1} files more")


def _check_results(results: Path) -> None:
    """Before the work: what the command finds can be written into RESULTS."""
    from trajopt_cli.runs.files import check_writable

    if results.is_dir():
        check_writable(results, into=True)


def _lead(text: str | None, pushes: Mapping[str, float], stretches: Mapping[str, float], option: str) -> Lead | None:
    """A bound on the lead: a force or moment, or what a spring that pushes as much is stretched by."""
    from trajopt_cli.iiwa.controller.feed_limits import Lead
    from trajopt_cli.quantity import option_value

    if text is None:
        return None
    stretch = any(text.strip().endswith(unit) for unit in stretches) and not text.strip().endswith(tuple(pushes))
    return Lead(option_value(text, {**pushes, **stretches}, option), stretch)


def no_run(answer: NoRun, as_json: bool) -> NoReturn:
    """Say why there is nothing to show, and stop with exit code 1."""
    from trajopt_cli.cli.console import no

    no([*answer.sentences, "NOTHING WRITTEN: the controller cannot run"], as_json, answer="no run")


def said(quiet: bool) -> Callable[[str], None]:
    """What takes a word on how far things are."""
    return (lambda text: None) if quiet else lambda text: typer.echo(text, err=True)
