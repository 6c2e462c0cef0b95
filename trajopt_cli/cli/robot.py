"""`trajopt robot list|show NAME|add URDF`: the robots that ship, where their numbers come from, and new ones."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import tidied
from trajopt_cli.errors import InputError

app = typer.Typer(help="The robots that ship, and your own.", rich_markup_mode=None)


@app.command("add", short_help="MODEL.urdf in, a robot's two files out.")
def add(
    model: Annotated[Path, typer.Argument(metavar="MODEL.urdf", help="The robot's URDF, as its maker or ROS has it.")],
    name: Annotated[str, opt.given("--name", "NAME", "What to call it: NAME.urdf and NAME.yaml.")],
    tip: Annotated[
        str | None, opt.given("--tip", "LINK", "The flange's link; default: tool0, flange, or the last one.")
    ] = None,
    base: Annotated[str | None, opt.given("--base", "LINK", "The chain's first link; default: the root.")] = None,
    confdata: Annotated[
        Literal["abb_six_axis", "none"] | None,
        typer.Option(
            "--confdata",
            help="What RAPID's confdata means on it; default: ABB's rule if the URDF speaks of ABB, else none.",
            show_default=False,
        ),
    ] = None,
    rail: Annotated[bool, typer.Option("--rail", help="Write NAME_rail too: the same on a linear track.")] = False,
    output: Annotated[Path, opt.given("--output", "FOLDER", "Where the two files go.")] = Path("."),
    force: Annotated[
        bool, typer.Option("--force", help="Replace files of that name; the old ones stay as .bak.")
    ] = False,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Make a robot of the URDF of nearly any six-axis arm, alone or on a sliding axis, or of a seven-axis arm with
    spherical shoulder and wrist, as a KUKA LBR iiwa.

    Writes a clean URDF of the chain, and a YAML file with what a URDF cannot say, guessed and marked.

    \b
    Example:
      trajopt robot add welder_arm.urdf --name welder
    """
    from trajopt_cli.adopt.add import new_robot
    from trajopt_cli.cli.console import print_answer
    from trajopt_cli.cli.robot_tables import new_robot_record, new_robot_tables
    from trajopt_cli.robot.model import load_robot
    from trajopt_cli.robot.srs import load_srs
    from trajopt_cli.runs.transaction import replace_files

    made = new_robot(model, name, tip, base, confdata, rail)
    if output.exists() and not output.is_dir():
        raise InputError("is a file; --output names a folder", file=str(output))
    places = {output / file: content for file, content in made.files.items()}
    tidied(places)
    there = [path for path in places if path.exists() or path.is_symlink()]
    if there and not force:
        raise InputError("exists; choose another --name or --output, or --force to replace it", file=str(there[0]))
    for path in there:
        if path.resolve() == model.resolve():
            raise InputError("is the URDF to read; choose another --name or --output", file=str(path))
    old = {path: (path.read_bytes(), places[path]) for path in there}
    kept = replace_files(old, {path: content for path, content in places.items() if path not in old})
    load: Any = load_srs if made.chain.turning == 7 else load_robot
    robot = load(str(output / f"{name}.yaml"))
    files = [str(path) for path in places]
    record = {"files": files, "kept": [str(path) for path in kept.values()]}
    written, shown = f"written: {', '.join(files)}", output / f"{name}.yaml"
    then = f"next: trajopt robot show {shown if shown.parent != Path('.') else f'./{shown}'}"
    parts = [*new_robot_tables(made, robot), written, *(f"kept: {path}" for path in kept.values()), then]
    print_answer(as_json, quiet, lambda: record | new_robot_record(made, robot), written, parts)


@app.command("list", short_help="Names, titles, reach, payload.")
def list_robots(as_json: opt.AsJson = False, quiet: opt.Quiet = False) -> None:
    """Names and titles of the robots that ship, how far they reach, and what they carry.

    \b
    Example:
      trajopt robot list
    """
    from trajopt_cli.robot.description import shipped

    robots = shipped()
    if as_json:
        from trajopt_cli.cli.console import print_json

        print_json([{"name": r.name, "title": r.title, "reach_m": r.reach, "payload_kg": r.payload} for r in robots])
        return
    wide = max(len(robot.name) for robot in robots)
    title = max(len(robot.title) for robot in robots)
    for robot in robots:
        payload = "" if robot.payload is None else f"{robot.payload:g} kg"
        line = f"{robot.name:<{wide}}  {robot.title:<{title}}  {robot.reach:.2f} m  {payload:>7}"
        typer.echo(robot.name if quiet else line.rstrip())


@app.command("show", short_help="Dimensions, limits, grades, sources.")
def show(
    name: Annotated[
        str,
        typer.Argument(
            metavar="NAME", help="A name of 'trajopt robot list', or a robot's YAML file.", autocompletion=opt.robots
        ),
    ],
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Dimensions, ranges, speeds, torques, and every acceleration profile with its grades and sources.

    \b
    Example:
      trajopt robot show irb140_rail
    """
    from trajopt_cli.cli.console import print_answer
    from trajopt_cli.cli.robot_tables import robot_record, robot_tables
    from trajopt_cli.robot.description import read
    from trajopt_cli.robot.model import Structure, load_robot
    from trajopt_cli.robot.srs import load_srs

    data, _, _ = read(name)
    robot = load_srs(name) if data.structure is Structure.SRS else load_robot(name)
    title = f"{robot.name}: {robot.title}"
    print_answer(as_json, quiet, lambda: robot_record(robot), title, robot_tables(robot))
