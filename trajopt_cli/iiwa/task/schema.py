"""The task file of the compliant job as JSON schema, for editors."""

from __future__ import annotations

from importlib.resources import files
from typing import Any

from trajopt_cli.iiwa.task.document import TaskDocument
from trajopt_cli.validation import json_schema


def task_schema() -> dict[str, Any]:
    """What a task file may hold, with a description of every key."""
    keys = files("trajopt_cli.iiwa.task").joinpath("keys.md").read_text(encoding="utf-8")
    schema = json_schema(TaskDocument, "trajopt iiwa task file", keys)
    # a path in a file of its own stands where the loader looks before the document does
    schema["properties"]["poses"]["anyOf"].append({"type": "string", "pattern": r"\.[cC][sS][vV]\s*$"})
    return schema
