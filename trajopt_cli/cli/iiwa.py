"""`trajopt iiwa segments|joints|simulate|dose|experiments`: what a compliant controller is fed, and how it follows."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from trajopt_cli.cli.options import AsJson, Quiet
from trajopt_cli.cli.process import wrote

if TYPE_CHECKING:
    from collections.abc import Callable

    from trajopt_cli.iiwa import Answer, Refused

app = typer.Typer(help="Cartesian segments for a compliant KUKA LBR iiwa 7.", rich_markup_mode=None)

TaskResults = Annotated[Path, typer.Argument(metavar="RESULTS", help="Results folder of trajopt iiwa segments.")]


def _given(name: str, metavar: str | None, about: str) -> Any:
    """An option that takes a value of this kind; None where its choices say so."""
    return typer.Option(name, metavar=metavar, help=about)


@app.callback()
def _group() -> None:
    """Cartesian segments for a compliant KUKA LBR iiwa 7, its joints, and how the controller will follow them."""


@app.command("segments", short_help="TASK's poses in, one pose per period out.")
def segments(
    task: Annotated[
        Path,
        typer.Argument(metavar="TASK", help="Task file (YAML), or a RAPID program or CSV path that gives the poses."),
    ],
    output: Annotated[Path | None, _given("--output", "FOLDER", "Results folder; default: results/TASK.")] = None,
    task_file: Annotated[
        Path | None, _given("--task", "FILE.yaml", "Task file of a program or path; default: beside it.")
    ] = None,
    angles: Annotated[
        Literal["relative", "absolute"] | None,
        _given("--angles", None, "Count angles from the start's orientation or from the world's axes."),
    ] = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Interpolate TASK: what the controller is fed every period, as CSV with angles and with quaternions.

    \b
    Example:
      trajopt iiwa segments programs/iiwa_cube.yaml
    """
    from trajopt_cli import iiwa

    _report(iiwa.segments(task, output, task_file, angles, said(quiet)), as_json, quiet)


@app.command("joints", short_help="RESULTS' joints in one configuration, the arm angle fixed or chosen.")
def joints(
    results: TaskResults,
    arm_angle: Annotated[
        Literal["fixed", "free", "optimal"],
        _given("--arm-angle", None, "Keep it, let it change where the fixed one fails, or choose the best course."),
    ] = "fixed",
    goal: Annotated[
        Literal["limits", "speed", "torque"] | None,
        _given("--for", None, "What is best: far from limits (default), slow joints, or little torque."),
    ] = None,
    plots: Annotated[Path | None, _given("--plots", "FOLDER", "Draw the map of path and arm angle, too.")] = None,
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
    from trajopt_cli import iiwa
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.problem.progress import Progress

    with ProgressView(quiet=quiet) as view:
        answer = iiwa.joints(results, arm_angle, goal, plots, lambda phase: view.show("joints", Progress(phase)))
    _report(answer, as_json, quiet, plots)


@app.command("simulate", short_help="What the compliant controller makes of RESULTS.")
def simulate(
    results: TaskResults,
    contact: Annotated[
        Path | None, _given("--contact", "FILE.yaml", "What the tool may run into; default: the task's own.")
    ] = None,
    engine: Annotated[
        Literal["spring", "mujoco"] | None,
        _given("--engine", None, "What answers the tool; default: MuJoCo where it is installed."),
    ] = None,
    feed: Annotated[
        Literal["position", "velocity"] | None,
        _given("--feed", None, "Feed the equilibrium's speed, too; default: what RESULTS were made for."),
    ] = None,
    integration: Annotated[
        Literal["euler", "exact"] | None, _given("--integration", None, "How the law is stepped.")
    ] = None,
    settle: Annotated[
        float | None, typer.Option("--settle", min=0, max=600, metavar="S", help="How long the last pose is held.")
    ] = None,
    plots: Annotated[
        Path | None, _given("--plots", "FOLDER", "Draw equilibrium, answer, lag and contact, too.")
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
    from trajopt_cli import iiwa

    answer = iiwa.simulate(results, contact, engine, feed, integration, settle, plots)
    _report(answer, as_json, quiet, plots)


@app.command("dose", short_help="RESULTS retimed so that the controller follows.")
def dose(
    results: TaskResults,
    max_lag: Annotated[str, _given("--max-lag", "5mm", "How far the arm may be from its plan.")],
    max_lead: Annotated[
        str | None,
        _given(
            *("--max-lead", "50N|40mm"),
            "How hard the tool may begin to push if somebody holds it, or how far a spring that pushes as much is"
            " stretched; default: the lag.",
        ),
    ] = None,
    max_turn_lag: Annotated[str | None, _given("--max-turn-lag", "2deg", "How far its orientation may.")] = None,
    max_turn_lead: Annotated[str | None, _given("--max-turn-lead", "5Nm|8deg", "The same of the moment.")] = None,
    feed: Annotated[
        Literal["position", "velocity", "inverse"] | None,
        _given(
            *("--feed", None),
            "Without --max-lead: position (default) pushes no harder than a spring stretched by the lag, inverse"
            " as hard as the programmed speed asks. Fed is what moves the arm on its plan: u = x + D/K x' + M/K x''.",
        ),
    ] = None,
    front: Annotated[
        bool, typer.Option("--front", help="Show the least times for other leads, too; needs --max-lead.")
    ] = False,
    output: Annotated[Path | None, _given("--output", "FOLDER", "Results folder; default: RESULTS-dosed.")] = None,
    plots: Annotated[Path | None, _given("--plots", "FOLDER", "Draw the lag before and after, too.")] = None,
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
    from trajopt_cli import iiwa
    from trajopt_cli.cli.console import warn

    if feed in ("position", "velocity"):
        warn(f"warning: --feed {feed}: the inverse law is fed all the same; the value goes with the next version")
    bounds = (max_lag, max_turn_lag, max_lead, max_turn_lead)
    _report(
        iiwa.schedule_feed(results, *bounds, feed in ("velocity", "inverse"), front, output, plots),
        as_json,
        quiet,
        plots,
    )


@app.command("experiments", short_help="Chapter 6 of the second thesis, its numbers beside ours.")
def experiments(
    output: Annotated[Path, _given("--output", "FOLDER", "Folder for numbers and pictures.")] = Path(
        "results/iiwa_experiments"
    ),
    engine: Annotated[
        Literal["auto", "spring", "mujoco"], _given("--engine", None, "What moves the arm and answers the tool.")
    ] = "auto",
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Force steps, orientation, hand guiding, zeroing, stability, following, collision and loop time.

    \b
    Example:
      trajopt iiwa experiments --engine spring
    """
    from trajopt_cli import iiwa

    _report(iiwa.run_experiments(output, engine, lambda name: said(quiet)(f"experiment {name}")), as_json, quiet)


def _report(answer: Answer | Refused, as_json: bool, quiet: bool, plots: Path | None = None) -> None:
    """Print an answer and draw its pictures; stop with exit code 1 where there is none, or where limits are broken."""
    from trajopt_cli.cli.console import no, print_json, result, show, stdout, tell
    from trajopt_cli.iiwa import Refused
    from trajopt_cli.runs.transaction import write_files
    from trajopt_cli.table import TextTable

    if isinstance(answer, Refused):
        no(answer.sentences, as_json, answer=answer.answer)
    if answer.written is not None:
        wrote(answer.written)
    if as_json:
        print_json(answer.record)
    elif quiet:
        result(answer.line)
    else:
        console = stdout()
        for part in answer.parts:
            if isinstance(part, TextTable):
                show(console, part)
            else:
                tell(console, part)
        tell(console, [answer.where] if answer.where else [])
    if plots is not None:
        pictures = answer.draw()
        write_files(plots, pictures)
        said(quiet)(f"drawn in {plots}: {len(pictures)} files")
    if answer.broken:
        for line in answer.broken:
            typer.echo(line, err=True)
        raise typer.Exit(1)


def said(quiet: bool) -> Callable[[str], None]:
    """What prints a line of progress."""
    return (lambda text: None) if quiet else lambda text: typer.echo(text, err=True)
