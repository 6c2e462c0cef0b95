"""`trajopt robot list|show NAME|add URDF`: the robots that ship, where their numbers come from, and new ones."""

from __future__ import annotations

from typing import Annotated

import typer

from trajopt_cli.cli import robot_add
from trajopt_cli.cli.options import AsJson, Quiet, robots

app = typer.Typer(help="The robots that ship, and your own.", rich_markup_mode=None)
app.command("add", short_help="MODEL.urdf in, a robot's two files out.")(robot_add.add)


@app.command("list", short_help="Names, titles, reach, payload.")
def list_robots(as_json: AsJson = False, quiet: Quiet = False) -> None:
    """Names and titles of the robots that ship, how far they reach, and what they carry.

    \b
    Example:
      trajopt robot list
    """
    from trajopt_cli.robot.description import shipped

    robots = shipped()
    if as_json:
        from trajopt_cli.cli.console import print_json

        print_json(
            [{"name": r.name, "title": r.title, "reach_m": r.reach, "payload_kg": r.payload} for r in robots],
        )
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
            metavar="NAME", help="A name of 'trajopt robot list', or a robot's YAML file.", autocompletion=robots
        ),
    ],
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Dimensions, ranges, speeds, torques, and every acceleration profile with its grades and sources.

    \b
    Example:
      trajopt robot show irb140_rail
    """
    from trajopt_cli.cli import console
    from trajopt_cli.cli.robot_tables import robot_record, robot_tables
    from trajopt_cli.robot.description import read
    from trajopt_cli.robot.model import Structure, load_robot
    from trajopt_cli.robot.srs import load_srs

    data, _, _ = read(name)
    robot = load_srs(name) if data.structure is Structure.SRS else load_robot(name)
    if as_json:
        console.print_json(robot_record(robot))
        return
    if quiet:
        console.result(f"{robot.name}: {robot.title}")
        return
    out = console.stdout()
    for part in robot_tables(robot):
        if isinstance(part, str):
            console.tell(out, part.split("\n"))
        else:
            console.show(out, part)
