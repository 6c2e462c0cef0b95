"""What pydantic finds wrong in a file, in words for the person who has it; and what a file takes, as JSON schema."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from typing import Any, get_type_hints

from pydantic import BaseModel, TypeAdapter
from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import ErrorDetails, core_schema

from trajopt_cli.quantity import Reader, shown


def in_words(model: type[BaseModel], detail: ErrorDetails, wanted: Mapping[str, str]) -> str:
    """One finding of pydantic's, without its place. wanted: as in yaml_file.validated."""
    value, location, bounds = detail["input"], detail["loc"], detail.get("ctx", {})
    match detail["type"]:
        case "extra_forbidden":
            known = _keys(model, location)
            return f"unknown key; {hint('' if len(known) < 6 else str(location[-1]), known)}"
        case "missing":
            path = ".".join(str(part) for part in location)
            return f"is missing; {wanted.get(path) or wanted.get(str(location[-1]), 'add it')}"
        case "model_type" | "dict_type":
            return f"needs a section of 'key: value' lines, not {spelled(value)}"
        case "tuple_type" | "list_type":
            if isinstance(value, str) and value.strip().startswith("["):
                return f"needs a list, not the text {json.dumps(short(value))}; remove the quotes"
            return f"needs a list, not {spelled(value)}"
        case "too_short":
            return f"needs at least {bounds['min_length']}, not {bounds['actual_length']}"
        case "string_type":
            return f"needs text, not {spelled(value)}"
        case "bool_type":
            return f"needs true or false, not {spelled(value)}"
        case "int_type" | "int_parsing" | "int_from_float" | "int_parsing_size":
            return f"needs a whole number, not {spelled(value)}"
        case "float_type" | "finite_number":
            return f"needs a finite number, not {spelled(value)}"
        case "greater_than":
            return f"needs a {_kind(bounds['gt'])} above {_bound(bounds['gt'])}, not {spelled(value)}"
        case "greater_than_equal":
            return f"needs a {_kind(bounds['ge'])}, {_bound(bounds['ge'])} or more, not {spelled(value)}"
        case "less_than":
            return f"needs a {_kind(bounds['lt'])} below {_bound(bounds['lt'])}, not {spelled(value)}"
        case "less_than_equal":
            return f"needs a {_kind(bounds['le'])}, {_bound(bounds['le'])} or less, not {spelled(value)}"
        case "literal_error" | "enum":
            return f"{spelled(value)} is not one of {bounds['expected']}"
    return detail["msg"]


def _kind(bound: object) -> str:
    return "number" if isinstance(bound, float) else "whole number"


def _bound(value: float) -> str:
    return f"{value:g}" if value else "zero"


def spelled(value: object) -> str:
    """What a file gave, in words or as YAML writes it; short lists of numbers and plain text as they stand."""
    match value:
        case list() if 0 < len(value) <= 7 and all(type(item) in (int, float) for item in value):
            return f"[{', '.join(spelled(item) for item in value)}]"
        case str():
            return short(value) if value.isprintable() and value.strip() else json.dumps(short(value))
    return shown(value)


def short(text: str) -> str:
    """At most 80 characters of a text."""
    return text if len(text) <= 80 else f"{text[:77]}..."


def hint(name: str, known: Sequence[str]) -> str:
    """What to do about an unknown name: the one that begins so, else the closest known one, else all of them."""
    longer = [one for one in known if len(name) > 3 and one.lower().startswith(name.lower())]
    close = longer or get_close_matches(name, known, n=1)
    return f"did you mean '{close[0]}'?" if close else f"known: {', '.join(known) or 'none'}"


def _keys(model: type[BaseModel], location: Sequence[str | int]) -> list[str]:
    """The keys of the section that holds location."""
    for part in location[:-1]:
        field = model.model_fields.get(str(part))
        # else a name of the user's own: a key that the section admits, or one of a field that maps names
        annotation = field.annotation if field is not None else get_type_hints(model).get("__pydantic_extra__")
        for choice in _models(annotation):
            model = choice
    return [field.alias or name for name, field in model.model_fields.items()]


def _models(annotation: Any) -> Iterator[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for inner in getattr(annotation, "__args__", ()):
        yield from _models(inner)


class _AsWritten(GenerateJsonSchema):
    """JSON schema of what a file may hold, units as text included, not of what it is read into."""

    def function_before_schema(self, schema: core_schema.BeforeValidatorFunctionSchema) -> JsonSchemaValue:
        read = schema["function"]["function"]
        return dict(read.takes) if isinstance(read, Reader) else super().function_before_schema(schema)

    def field_title_should_be_set(self, schema: object) -> bool:
        return False


def json_schema(kind: Any, title: str, keys: str = "") -> dict[str, Any]:
    """JSON schema (draft 2020-12) of the files that a model, or a union of models, reads.

    keys: a table in Markdown whose rows begin with the names of top-level keys in backticks; what the second column
    says of them is their description. Rules across keys (one of two, ranges in order) are no part of it.
    """
    schema = TypeAdapter(kind).json_schema(schema_generator=_AsWritten)
    for names, text in told(keys.splitlines()):
        for name in names:
            schema["properties"][name]["description"] = text
    return {"$schema": GenerateJsonSchema.schema_dialect} | schema | {"title": title}


def told(table: Iterable[str]) -> Iterator[tuple[list[str], str]]:
    """The keys that a row of a table in Markdown names in its first column, and what its second one says."""
    for line in table:
        cells = [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        names = re.findall(r"`(\w+)`", cells[0]) if cells else []
        if names:
            yield names, re.sub(r"\[([^\]]+)\]\([^)]*\)", r"\1", cells[1])
