"""`trajopt schema cell|task|robot`: what the files people write may hold, for their editors."""

from __future__ import annotations

import json
from typing import Annotated, Literal

import typer


def schema(
    kind: Annotated[
        Literal["cell", "task", "robot"],
        typer.Argument(metavar="cell|task|robot", help="Which file.", show_default=False),
    ],
) -> None:
    """Print the JSON schema of cell files, of the compliant job's task files, or of robot files.

    Editors complete keys and mark mistakes with it. In VS Code with the YAML extension: save it as cell.schema.json
    and begin the cell file with the line '# yaml-language-server: $schema=cell.schema.json'.

    \b
    Example:
      trajopt schema cell
    """
    from trajopt_cli.cell.schema import cell_schema
    from trajopt_cli.iiwa import task_schema
    from trajopt_cli.robot.catalogue import robot_schema

    make = {"cell": cell_schema, "task": task_schema, "robot": robot_schema}[kind]
    typer.echo(json.dumps(make(), indent=2, ensure_ascii=False))
