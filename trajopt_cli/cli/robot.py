"""`trajopt robot list|show NAME`: the robots that ship, and where their numbers come from."""

from __future__ import annotations

from typing import Annotated

import typer

from trajopt_cli.cli.options import AsJson, Quiet, robots

app = typer.Typer(help="The robots that ship.", rich_markup_mode=None)


@app.command("list", short_help="Names and titles.")
def list_robots(as_json: AsJson = False, quiet: Quiet = False) -> None:
    """Names and titles of the robots that ship.

    \b
    Example:
      trajopt robot list
    """
    from trajopt_cli.robot.description import read
    from trajopt_cli.robot.model import robot_names

    titles = {name: read(name)[0].title for name in robot_names()}
    if as_json:
        from trajopt_cli.cli.console import print_json

        print_json([{"name": name, "title": title} for name, title in titles.items()])
        return
    for name, title in titles.items():
        typer.echo(name if quiet else f"{name:<{max(map(len, titles))}}  {title}")


@app.command("show", short_help="Dimensions, limits, grades, sources.")
def show(
    name: Annotated[
        str,
        typer.Argument(metavar="NAME", help="A name of 'trajopt robot list'.", autocompletion=robots),
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
