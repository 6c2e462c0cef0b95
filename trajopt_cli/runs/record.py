"""run.json, the record of a run: one model for every kind of folder, its bytes, and one line for a damaged one."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from io import BufferedRandom
from pathlib import Path, PurePosixPath
from typing import Annotated, Any, ClassVar, Generic, TypeVar

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError, model_validator
from pydantic_core import ErrorDetails

from trajopt_cli.errors import InputError
from trajopt_cli.quantity import complain
from trajopt_cli.validation import in_words, short

INPUT = "input/"
"""Where a folder keeps the copies of what it was made from."""
Model = TypeVar("Model", bound=BaseModel)
Options = TypeVar("Options")


class Section(BaseModel):
    """A part of a record. Every value has its own JSON type ("3" is no number); keys of later versions are left out."""

    model_config = ConfigDict(strict=True, frozen=True)


def _listed(files: dict[str, str]) -> dict[str, str]:
    for name in files:
        if not _stays_inside(name):
            raise complain(f"{quoted(name)} is not a name inside the folder")
    return files


def _usable(path: str) -> str:
    try:
        usable = bool(Path(path).name) and b"\0" not in os.fsencode(path)
    except UnicodeEncodeError:
        usable = False
    if not usable:
        raise complain(f"{quoted(path)} is not the path of a file")
    return path


UserPath = Annotated[str, AfterValidator(_usable)]
"""A path as the user gave it: whatever the system takes as one."""


class InputRecord(Section):
    """A file the run was made from. path: as the user gave it; place: of its copy in the folder; module: whether it is
    a RAPID module; rapid: the place of its optimised version, None where there is none."""

    path: UserPath
    place: str = Field(alias="copy")
    sha256: str
    rapid: str | None = None
    module: bool = False


class Inputs(Section):
    """The places of the files that a command starts from, of several modules the first, and all files of the run.
    robot: of a robot's own YAML file, its URDF beside it; None for a robot that ships."""

    program: str | None = None
    cell: str | None = None
    task: str | None = None
    robot: str | None = None
    files: list[InputRecord] = Field(default_factory=list)


class RunRecord(Section, Generic[Options]):
    """What made a folder, and the hash of every other file in it. Kinds of folders derive from this.

    KIND: its name in the record; LIBRARIES: whose versions it keeps; REMEDY: what to do about a file that was changed.
    """

    KIND: ClassVar[str] = ""
    LIBRARIES: ClassVar[tuple[str, ...]] = ()
    REMEDY: ClassVar[str] = "make the folder again"

    trajopt: str
    format: Annotated[int, Field(gt=0)]
    kind: str = "plan"
    command: str = ""
    versions: dict[str, str] = Field(default_factory=dict)
    options: Options
    inputs: Inputs
    files: Annotated[dict[str, str], AfterValidator(_listed)]
    finished: str = ""

    @model_validator(mode="after")
    def _inputs_are_listed(self) -> RunRecord[Options]:
        """Every input is a listed copy with that hash, and no two places are one."""
        seen = set[str]()
        for key in ("program", "cell", "task", "robot"):
            place = getattr(self.inputs, key)
            self.listed(f"inputs.{key}", place, copy=True)
        for i, one in enumerate(self.inputs.files):
            for key, place in (("copy", one.place), ("rapid", one.rapid)):
                self.listed(f"inputs.files[{i}].{key}", place, copy=key == "copy")
                if place in seen:
                    raise complain(f"inputs.files[{i}].{key}: {quoted(place)} is the place of another file, too")
            seen |= {place for place in (one.place, one.rapid) if place is not None}
            if one.sha256 != self.files[one.place]:
                raise complain(f"inputs.files[{i}].sha256: {quoted(one.sha256)} is not the one that files lists")
        return self

    def listed(self, key: str, place: str | None, copy: bool = False) -> None:
        """Raise a validation error about key unless place is None or one of files (copy: of what the run was given)."""
        if place is not None and (place not in self.files or (copy and not place.startswith(INPUT))):
            raise complain(f"{key}: {quoted(place)} is not {'an input' if copy else 'a file'} that files lists")


@dataclass(frozen=True)
class InputFile:
    """A file a run is made from, with its content; the rest as in InputRecord."""

    path: str
    place: str
    content: bytes
    rapid: str | None = None

    def record(self, rapid: bool = True) -> InputRecord:
        """Its entry in run.json; rapid: whether the folder holds the optimised version."""
        module = self.rapid is not None
        place = self.rapid if rapid else None
        return InputRecord(path=self.path, copy=self.place, sha256=sha256(self.content), rapid=place, module=module)


def checked(model: type[Model], content: Any, file: str, said: str, remedy: str) -> Model:
    """content as a model. Raises InputError with the first thing that is wrong: file, said, key, value, remedy."""
    try:
        return model.model_validate(content)
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        raise InputError(f"{said}: {_finding(model, first)}; {remedy}", file=file) from error


def _finding(model: type[BaseModel], detail: ErrorDetails) -> str:
    key = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in detail["loc"]).removeprefix(".")
    match detail["type"]:
        case "missing":
            text = "is missing"
        case "model_type" | "dict_type":
            text = f"needs an object, not {quoted(detail['input'])}"
        case _:
            text = in_words(model, detail, {})
    return f"{short(key)}: {text}" if key else text


def parse_record(text: bytes, file: str) -> dict[str, Any]:
    """The JSON object in text; file is its name in messages. Raises InputError for anything else."""
    try:
        content = json.loads(text)
    except ValueError as error:
        raise InputError(f"is not JSON: {error}", file=file) from error
    except RecursionError as error:
        raise InputError("is not JSON that trajopt wrote: nested too deep", file=file) from error
    if not isinstance(content, dict):
        raise InputError("is not a JSON object", file=file)
    return content


def as_json(content: Mapping[str, Any] | BaseModel) -> bytes:
    """JSON for people and programs; of a model, the fields given. Raises ValueError for numbers that are not finite."""
    if isinstance(content, BaseModel):
        content = content.model_dump(by_alias=True, exclude_unset=True)
    text = json.dumps(content, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
    return text.encode(errors="backslashreplace")  # a lone surrogate, \udc80, is written as JSON's own escape


def sha256(content: bytes | BufferedRandom) -> str:
    """Of the exact bytes, or of those of an open file, in hexadecimal."""
    if isinstance(content, bytes):
        return hashlib.sha256(content).hexdigest()
    content.seek(0)
    return hashlib.file_digest(content, "sha256").hexdigest()


def quoted(value: object) -> str:
    """For a message: JSON, of bounded length."""
    plain = not isinstance(value, int) or value.bit_length() < 64
    return short(json.dumps(value)) if plain else "a very large number"


def _stays_inside(name: str) -> bool:
    """Whether a folder may have a file of this name: relative, as write_run spells it, nothing above the folder."""
    try:
        os.fsencode(name)
    except UnicodeEncodeError:
        return False
    path = PurePosixPath(name)
    spelled = name == str(path) and bool(path.name) and not any(sign < " " for sign in name)
    return spelled and not path.is_absolute() and ".." not in path.parts
