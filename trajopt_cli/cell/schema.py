"""The cell file as JSON schema, for editors."""

from __future__ import annotations

from importlib.resources import files
from typing import Any

from trajopt_cli.cell.document import CellDocument
from trajopt_cli.validation import json_schema


def cell_schema() -> dict[str, Any]:
    """What a cell file may hold, with a description of every key."""
    keys = files("trajopt_cli.cell").joinpath("keys.md").read_text(encoding="utf-8")
    return json_schema(CellDocument, "trajopt cell file", keys)
