"""`trajopt cell show CELL.yaml`: what stands in a cell, before anything is planned."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli.options import AsJson, Quiet

app = typer.Typer(help="What a cell file says.", rich_markup_mode=None)


@app.callback()
def _commands() -> None:
    """What a cell file says."""


@app.command("show", short_help="List the bodies of a cell.")
def show(
    cell: Annotated[Path, typer.Argument(metavar="CELL.yaml", help="Cell file.")],
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """List every body of CELL, those of its URDFs, folders and lists by name: kind, size, place, what carries it.

    A mesh that is no whole convex surface is held as its surface. 'trajopt view CELL.yaml' draws them.

    \b
    Example:
      trajopt cell show programs/hinge_cell_fenced.yaml
    """
    from trajopt_cli.cell.loader import load_cell
    from trajopt_cli.cli.console import print_answer
    from trajopt_cli.page.standing import bodies_record, bodies_table
    from trajopt_cli.problem.plant import build_plant

    given = load_cell(cell)
    plant = build_plant(given)
    notes = [*(str(doubt) for doubt in given.doubts), *plant.unchecked]
    many = len(plant.obstacles) + len(plant.attached)
    line = f"{cell}: {many} bod{'y' if many == 1 else 'ies'} around {plant.robot.name}"
    record = {"cell": str(cell), "robot": plant.robot.name, "bodies": bodies_record(plant), "notes": notes}
    print_answer(as_json, quiet, lambda: record, line, [bodies_table(plant), *notes])
