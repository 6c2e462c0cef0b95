"""`trajopt export FORMAT RESULTS`: motions as files for whoever takes them."""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import tidied
from trajopt_cli.errors import InputError, placed
from trajopt_cli.units import slides

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from trajopt_cli.exporters.egm import Stream
    from trajopt_cli.exporters.recorded import Recorded
    from trajopt_cli.pipeline.folder import RapidFiles
    from trajopt_cli.trajectory import Trajectory

    _Rows = Callable[[Path, Recorded, float | None], tuple[Trajectory, str]]
    _Make = Callable[[Trajectory, str], bytes | Iterable[bytes]]

app = typer.Typer(
    help="Write a motion for the machine or the program that takes it.",
    rich_markup_mode=None,
    invoke_without_command=True,
)

AnyResults = Annotated[
    Path, typer.Argument(metavar="RESULTS", help="Results folder of trajopt optimize, or of trajopt iiwa with joints.")
]
Rate = Annotated[float, typer.Option(metavar="HZ", help="Rows per second.")]
_OF_JOINTS = ("command", "joints")  # what only a folder with joints gives

RosNames = Annotated[
    str | None, opt.given("--joints", "NAME,...", "The joints' names in ROS, in order; default: our own.")
]


@app.callback()
def _formats(context: typer.Context) -> None:
    """Write a motion for the machine or the program that takes it; without a format, list them all."""
    if context.invoked_subcommand is None:
        typer.echo("trajopt export FORMAT RESULTS; --help of a format shows an example")
        for command in app.registered_commands:
            typer.echo(f"  {command.name:<9}{command.short_help}")


@app.command("joint", short_help="Joint CSV at a fixed rate, for machines that follow a stream.")
def joint(
    results: AnyResults,
    output: Annotated[Path | None, opt.file_of_results("CSV file", "joint.csv")] = None,
    rate: Rate = 1000.0,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Joint positions and speeds at a fixed rate, also in rests, the exact end as last row: of trajectory.csv,
    by default the stream plan, whose rests of a minute or more are two rows; or of an iiwa's joints.csv.

    \b
    Example:
      trajopt export joint results/hinge_cell --output joints.csv
    """
    from trajopt_cli.joint_csv import csv_parts

    make: _Make = lambda rows, _: map(str.encode, csv_parts(rows))  # noqa: E731
    _export(_output(output, results, "joint.csv"), results, rate, _as_it_is, make, as_json, quiet)


@app.command("ros2", short_help="ROS 2 JointTrajectory as YAML, for ros2 topic pub.")
def ros2(
    results: AnyResults,
    output: Annotated[Path | None, opt.file_of_results("YAML file", "ros2.yaml")] = None,
    rate: Rate = 100.0,
    joints: RosNames = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """A trajectory_msgs/msg/JointTrajectory: positions, velocities, accelerations and times of all joints.

    \b
    Example:
      trajopt export ros2 results/hinge_cell --output trajectory.yaml
    """
    from trajopt_cli.exporters.ros2 import trajectory_parts

    make: _Make = lambda rows, _: map(str.encode, trajectory_parts(rows, _split(joints)))  # noqa: E731
    _export(_output(output, results, "ros2.yaml"), results, rate, _of_the_urdf, make, as_json, quiet)


@app.command("mcap", short_help="The same with joint states in an MCAP file, for bag tools.")
def mcap(
    results: AnyResults,
    output: Annotated[Path | None, opt.file_of_results("MCAP file", "joint.mcap")] = None,
    rate: Rate = 100.0,
    joints: RosNames = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """ROS 2 messages for bag tools: /joint_trajectory once, /joint_states at the rate, times from 0; needs the extra
    mcap.

    \b
    Example:
      trajopt export mcap results/hinge_cell --output motion.mcap
    """
    from trajopt_cli.exporters.ros2 import mcap as mcap_of

    make: _Make = lambda rows, _: mcap_of(rows, _split(joints))  # noqa: E731
    _export(_output(output, results, "joint.mcap"), results, rate, _of_the_urdf, make, as_json, quiet)


@app.command("parquet", short_help="The joint CSV's columns as Parquet, for pandas, polars, DuckDB.")
def parquet(
    results: AnyResults,
    output: Annotated[Path | None, opt.file_of_results("Parquet file", "joint.parquet")] = None,
    rate: Annotated[
        float | None, typer.Option(metavar="HZ", help="Rows per second; default: the rows as they are.")
    ] = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Time, positions and speeds of all joints as columns of doubles; needs pyarrow, the extra parquet.

    \b
    Example:
      trajopt export parquet results/hinge_cell --output joints.parquet
    """
    from trajopt_cli.exporters.parquet import parquet as parquet_of

    make: _Make = lambda rows, _: parquet_of(rows)  # noqa: E731
    _export(_output(output, results, "joint.parquet"), results, rate, _as_it_is, make, as_json, quiet)


@app.command("fri", short_help="Joint positions per millisecond, for a client of KUKA's FRI.")
def fri(
    results: Annotated[Path, typer.Argument(metavar="RESULTS", help="Results folder of trajopt iiwa with joints.")],
    output: Annotated[Path | None, opt.file_of_results("CSV file", "fri.csv")] = None,
    between: Annotated[
        bool, typer.Option("--resample", help="Make rows every 1 ms of a sequence with another period.")
    ] = False,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """What a client of the fast robot interface commands: A1 to A7 in rad, one line for every millisecond.

    \b
    Example:
      trajopt export fri results/iiwa_cube --output fri.csv
    """
    from trajopt_cli.exporters.recorded import fri_rows, recorded
    from trajopt_cli.runs.files import write_file

    output = _output(output, results, "fri.csv")
    motion = recorded(results)
    with placed(str(results)):
        text, rows, note = fri_rows(motion, between)
    write_file(output, text.encode("ascii"))
    line = f"{output}: the arm's joints, {rows} rows of 1 ms{f'; {note}' if note else ''}"
    _tell(line, (), {"file": str(output), "rows": rows, "rate_hz": 1000.0, "note": note or None}, as_json, quiet)


@app.command("poses", short_help="Poses with wrench and stiffness, for controllers that take a Cartesian target.")
def poses(
    results: Annotated[Path, typer.Argument(metavar="RESULTS", help="Results folder of trajopt iiwa.")],
    output: Annotated[
        Path | None, typer.Option(metavar="FILE.csv|mcap", help="The CSV or MCAP file; default: poses.csv in RESULTS.")
    ] = None,
    rate: Rate = 100.0,
    stack: Annotated[
        Literal["ros", "lbr", "cartesian", "crisp", "impedance"],
        typer.Option(
            "--for",
            help="Whose topics, frame and joint names: lbr_fri_ros2_stack, cartesian_controllers,"
            " crisp_controllers, Cartesian-Impedance-Controller; ros: plain ones.",
        ),
    ] = "ros",
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """PoseStamped, twist, wrench and stiffness of the tool, as the controller that takes them names them; with joints
    where RESULTS have any.

    \b
    Example:
      trajopt export poses results/iiwa_cube --for crisp --output poses.mcap
    """
    from trajopt_cli import iiwa
    from trajopt_cli.exporters.poses import STACKS, ToolPoses, csv
    from trajopt_cli.exporters.poses import mcap as mcap_of
    from trajopt_cli.exporters.recorded import recorded
    from trajopt_cli.runs.files import write_file

    output, taker = _output(output, results, "poses.csv"), STACKS[stack]
    if output.suffix.lower() not in (".csv", ".mcap"):
        raise InputError("--output: needs a name that ends in .csv or .mcap", file=str(output))
    t, p, R, wrench, K, X_WB = iiwa.commanded(results)
    q = recorded(results).trajectory.q if (results / "joints.csv").is_file() else None
    made = ToolPoses(t, p, R, wrench, K, q).at(rate)
    made = made.seen_from(X_WB) if taker.based else made
    write_file(output, (csv if output.suffix.lower() == ".csv" else mcap_of)(made, taker))
    topics = {what: topic for what, (topic, _) in taker.topics.items() if q is not None or what not in _OF_JOINTS}
    more = [f"{what}: {topic}" for what, topic in topics.items()] if output.suffix.lower() == ".mcap" else []
    if taker.parameter:
        values = ", ".join(f"{value:g}" for value in made.K)
        more.append(f"set the stiffness there: {taker.parameter} = {values}")
    frame = f"of the tool centre point in {taker.frame}"
    line = f"{output}: {len(made.t)} poses {frame} at {rate:g} Hz, T = {made.t[-1]:.4f} s, for {stack}"
    record = {"file": str(output), "for": stack, "rows": len(made.t), "rate_hz": rate, "frame": taker.frame}
    _tell(line, more, {**record, "topics": topics, "stiffness": made.K.tolist()}, as_json, quiet)


@app.command("egm", short_help="EgmSensor messages every 4 ms, for ABB's Externally Guided Motion.")
def egm(
    results: opt.ResultsFolder,
    output: Annotated[Path | None, opt.file_of_results("file of messages", "stream.egm")] = None,
    rate: Annotated[float, typer.Option(metavar="HZ", help="Messages per second, at most 250.")] = 250.0,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Set points and speed references: joints in degrees, the rail in mm and positioners that turn in degrees in the
    places of their external axes. Each message stands behind its length; trajopt play egm tries them.

    \b
    Example:
      trajopt export egm results/hinge_cell --output stream.egm
    """
    from trajopt_cli.exporters.egm import stream_parts
    from trajopt_cli.runs.files import write_file

    output = _output(output, results, "stream.egm")
    motion, stream = egm_stream(results, rate)
    write_file(output, stream_parts(stream))
    beside = [*zip(stream.names, stream.units, strict=True)][stream.joints :]
    line = (
        f"{output}: {motion.name}, {len(stream.q)} set points at {rate:g} Hz, T = {stream.duration:.4f} s:"
        f" {stream.joints} joints in deg{''.join(f', {name} in {unit}' for name, unit in beside)}"
    )
    record = {**_record(output, motion, len(stream.q), stream.duration, rate), "axes": list(stream.names)}
    unused = [name for name in stream.names[stream.joints :] if name not in stream.driven]
    said = [f"{', '.join(unused)}: 0 in every message; driven: {', '.join(sorted(stream.driven))}"] if unused else []
    _tell(line, (*said, *_holds(motion)), record, as_json, quiet)


@app.command("gltf", short_help="The cell in motion as glTF, for 3D viewers and browsers.")
def gltf(
    results: opt.ResultsFolder,
    output: Annotated[Path | None, opt.file_of_results("binary glTF file", "cell.glb")] = None,
    rate: Annotated[float, typer.Option(metavar="HZ", help="Key frames per second.")] = 60.0,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """An animation of the arm's bodies, of what it carries, and of the cell's obstacles.

    \b
    Example:
      trajopt export gltf results/hinge_cell --output cell.glb
    """
    from trajopt_cli.exporters.gltf import gltf as gltf_of
    from trajopt_cli.job import cell_of_results
    from trajopt_cli.problem.plant import build_plant

    def of_plan(results: Path, motion: Recorded, rate: float | None) -> tuple[Trajectory, str]:
        if motion.period is not None:
            raise InputError("holds no plan in a cell; give a folder of trajopt optimize", file=str(results))
        return motion.at(rate, rests=False)

    make: _Make = lambda rows, title: gltf_of(rows, build_plant(cell_of_results(results)), title)  # noqa: E731
    _export(_output(output, results, "cell.glb"), results, rate, of_plan, make, as_json, quiet)


@app.command("rapid", short_help="The program with the rapid plan in it, for the RAPID controller.")
def rapid(
    results: opt.ResultsFolder,
    output: Annotated[
        Path | None, typer.Option(metavar="FILE.mod", help="The module to write; a folder for several modules.")
    ] = None,
    diff: Annotated[
        bool, typer.Option("--diff", help="Print what differs from the program as given; patch -p1 takes it.")
    ] = False,
    in_place: Annotated[
        bool, typer.Option("--in-place", help="Write over the program's own files; the old ones stay as NAME.bak.")
    ] = False,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """The program with the rapid plan in it; everything else is byte for byte as given.

    \b
    Example:
      trajopt export rapid results/hinge_cell --output new.mod
    """
    from trajopt_cli.cli.console import print_json
    from trajopt_cli.pipeline.folder import rapid_export
    from trajopt_cli.runs.results import beside_results, write_in_place

    if output is None and not diff and not in_place:
        raise typer.BadParameter("give --output, --diff, --in-place or several of them")
    files = rapid_export(results)
    written = [] if output is None else write_rapid(files, output, results)
    kept = (files.kept or ("the plan needs no change to the program",)) if diff and not files.patch else ()
    if diff and not as_json:
        for why in () if quiet else kept:
            typer.echo(f"no change: {why}", err=True)
        if sys.stdout.isatty():
            typer.echo(files.difference, nl=False)
        else:
            sys.stdout.flush()
            sys.stdout.buffer.write(files.patch)  # in the files' own encodings and line ends
    what = f"RAPID plan, {files.cycle:.3f} s"
    said = [f"wrote {path} ({what})" for path in written]
    if in_place:
        modules = beside_results(files.modules, results)
        tidied(one.path for one in modules)
        backups = write_in_place(modules)
        for one in modules:
            new = f"wrote {one.path} ({what}); original in {backups[one.path].name}" if one.path in backups else ""
            said.append(new or f"{one.path}: unchanged")
            written += [str(one.path)] if new else []
    said += files.ways
    difference = files.difference if diff else None
    record = {"written": written, "difference": difference, "kept": list(files.kept), "ways_around": list(files.ways)}
    if as_json:
        print_json(record)
    for line in () if as_json else said[:1] if quiet else said:
        typer.echo(line, err=diff)


def write_rapid(files: RapidFiles, output: Path, results: Path, option: str = "--output") -> list[str]:
    """Write the optimised modules to where output says, all or none; their places."""
    from trajopt_cli.runs.results import beside_results
    from trajopt_cli.runs.transaction import write_together

    own = [one.path for one in beside_results(files.modules, results)]
    places = rapid_places(output, results, [Path(one.place) for one in files.modules], own, option)
    write_together({path: one.content for path, one in zip(places, files.modules, strict=True)})
    return [str(path) for path in places]


def egm_stream(results: Path, rate: float = 250.0) -> tuple[Recorded, Stream]:
    """The motion of a results folder, and its EGM stream with the rail in the place of its external axis."""
    from trajopt_cli.exporters.egm import stream_of
    from trajopt_cli.exporters.recorded import recorded
    from trajopt_cli.job import cell_of_results

    motion = recorded(results)
    rail = cell_of_results(results).rail if motion.period is None else None
    with placed(str(results)):
        return motion, stream_of(motion, rate, None if rail is None else rail.eax)


def _as_it_is(_: Path, motion: Recorded, rate: float | None) -> tuple[Trajectory, str]:
    return motion.at(rate)


def _of_the_urdf(results: Path, motion: Recorded, rate: float | None) -> tuple[Trajectory, str]:
    """The motion at a rate as ROS has it, of the URDF's joints, which a parallel linkage makes others than the
    controller's axes; and what to say of it."""
    from trajopt_cli.job import cell_of_results
    from trajopt_cli.robot.model import load_robot

    trajectory, note = motion.at(rate, rests=False)
    robot = load_robot(cell_of_results(results).robot) if motion.period is None else None
    if robot is None or not robot.linkage or trajectory.qd is None:
        return trajectory, note
    _, lower, upper, *_ = robot.axis_names[robot.layout.arm]
    said = f"{upper} is the URDF's, axis 3 {'-' if robot.linkage > 0 else '+'} {lower}"
    own = [trajectory.names.index(name) for name in robot.axis_names]  # beside axes under the base
    q, qd = trajectory.q.copy(), trajectory.qd.copy()
    q[:, own], qd[:, own] = robot.chain_axes(q[:, own]), robot.chain_axes(qd[:, own])
    return replace(trajectory, q=q, qd=qd), "; ".join(part for part in (note, said) if part)


def _split(names: str | None) -> list[str] | None:
    return None if names is None else [name.strip() for name in names.split(",")]


def _export(
    output: Path, results: Path, rate: float | None, rows_of: _Rows, make: _Make, as_json: bool, quiet: bool
) -> None:
    """Write a motion's rows, and say what is in the file. rate: of the rows, None where they are as recorded."""
    from trajopt_cli.exporters.recorded import recorded
    from trajopt_cli.runs.files import write_file

    motion = recorded(results)
    trajectory, note = rows_of(results, motion, rate)
    write_file(output, make(trajectory, motion.name))
    rows, at = len(trajectory.t), "as recorded" if rate is None else f"at {rate:g} Hz"
    line = f"{output}: {motion.name}, {rows} rows {at}, T = {trajectory.duration:.4f} s{f'; {note}' if note else ''}"
    record = {**_record(output, motion, rows, trajectory.duration, rate), "note": note or None}
    _tell(line, [_begins(trajectory), *_holds(motion)], record, as_json, quiet)


def _record(output: Path, motion: Recorded, rows: int, duration: float, rate: float | None) -> dict[str, Any]:
    holds = [{"t": when, "until": condition} for when, condition in motion.holds]
    return {"file": str(output), "motion": motion.name, "rows": rows, "rate_hz": rate, "cycle_time_s": duration,
            "holds": holds}  # fmt: skip


def _begins(trajectory: Trajectory) -> str:
    """Where the machine has to be before the first row."""
    at = dict(zip(trajectory.names, map(float, trajectory.q[0]), strict=True))
    rails = "".join(f"{name} {value:.4f} m, " for name, value in at.items() if slides(name))
    joints = " ".join(f"{math.degrees(value):.2f}" for name, value in at.items() if not slides(name))
    return f"begins at {rails}joints {joints} deg: drive there first"


def _holds(motion: Recorded) -> list[str]:
    return [f"hold at t = {when:.4f} s until {condition}" for when, condition in motion.holds]


def _tell(line: str, more: Iterable[str], record: dict[str, Any], as_json: bool, quiet: bool) -> None:
    """Say what was written: a line and what belongs to it, of which --quiet leaves the line; or all of it as JSON."""
    from trajopt_cli.cli.console import print_json

    if as_json:
        print_json(record)
    else:
        for one in (line,) if quiet else (line, *more):
            typer.echo(one)


def _output(output: Path | None, results: Path, name: str) -> Path:
    """Where to write: as asked, else under a name in the results folder."""
    if output is None and results.is_dir():  # whoever reads results says what else is wrong with them
        output = results / name
    check_output(output or Path(name), results)
    return output or Path(name)


def check_output(output: Path, results: Path, option: str = "--output") -> None:
    """Refuse a place that cannot be written, and what a results folder holds: its files are held against their
    hashes."""
    from trajopt_cli.runs.files import check_file

    check_file(output, option)
    if output.exists() and output.resolve() == results.resolve():
        raise InputError(f"is what is played; {option} names another file", file=str(output))


def rapid_places(
    output: Path, results: Path, names: Sequence[Path], own: Iterable[Path], option: str = "--output"
) -> list[Path]:
    """Where the modules of a program go: one to the file output, several by their names into the folder output.

    own: the program's files. Raises InputError where that cannot be, and for a place that is one of them.
    """
    from trajopt_cli.runs.results import MODULES

    several = len(names) > 1
    if several and not output.is_dir() and (output.exists() or output.suffix.lower() in MODULES):
        what = "is a file" if output.exists() else "is a file's name"
        message = f"{what}; the program has {len(names)} modules, {option} names a folder for them"
        raise InputError(message, file=str(output))
    if several and not output.parent.is_dir():
        raise InputError(f"is not a folder to write to; make it or correct {option}", file=str(output.parent))
    places = [output / name for name in names] if several else [output]
    for place in places:
        if not several or place.parent.is_dir():
            check_output(place, results, option)
    for place in places:
        if any(place.exists() and one.exists() and place.samefile(one) for one in own):
            text = "is the program itself; 'trajopt export rapid RESULTS --in-place' writes over it and keeps NAME.bak"
            raise InputError(text, file=str(place))
    return places
