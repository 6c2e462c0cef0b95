"""`trajopt robot list|show NAME`: the robots that ship, and where their numbers come from."""

from __future__ import annotations

from typing import Annotated

import typer

app = typer.Typer(help="The robots that ship.", rich_markup_mode=None)


@app.command("list")
def list_robots() -> None:
    """Names and titles of the robots that ship."""
    from trajopt_cli.robot.description import read
    from trajopt_cli.robot.model import robot_names

    names = robot_names()
    for name in names:
        data, _, _ = read(name)
        typer.echo(f"{name:<{max(map(len, names))}}  {data.title}")


@app.command("show", short_help="Dimensions, limits, grades, sources.")
def show(name: Annotated[str, typer.Argument(metavar="NAME", help="A name of 'trajopt robot list'.")]) -> None:
    """Dimensions, ranges, speeds, torques, and every acceleration profile with its grades and sources."""
    from trajopt_cli.cli.console import stdout
    from trajopt_cli.cli.tables import robot_tables
    from trajopt_cli.robot.description import read
    from trajopt_cli.robot.model import Structure, load_robot
    from trajopt_cli.robot.srs import load_srs

    data, _, _ = read(name)
    robot = load_srs(name) if data.structure is Structure.SRS else load_robot(name)
    console = stdout()
    for part in robot_tables(robot):
        console.print(part)
