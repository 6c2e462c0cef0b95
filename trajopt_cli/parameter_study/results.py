"""A study's results folder: what it was made from, rows part by part, and all of them in one file at the end."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from hashlib import sha256
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
from pyarrow import parquet

from trajopt_cli import __version__
from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.geometry import BoolArray
from trajopt_cli.parameter_study.point import Column, Row
from trajopt_cli.parameter_study.study_file import Study
from trajopt_cli.runs.files import check_writable, write_file

STUDY, RECORD, POINTS = "study.yaml", "study.json", "points.parquet"
PARTS, TIMINGS = "parts", "timings"
_TYPES = {"int64": pa.int64(), "double": pa.float64(), "string": pa.string()}
_TIMING = pa.schema([("point", pa.int64()), ("seconds", pa.float64()), ("worker", pa.string())])
_FORMAT = 1


@dataclass(frozen=True, eq=False)
class StudyFolder:
    """A folder of results. columns: of its rows. points: how many there are in all."""

    path: Path
    columns: tuple[Column, ...]
    points: int

    @property
    def _schema(self) -> pa.Schema:
        return pa.schema([(one.name, _TYPES[one.kind]) for one in self.columns])

    def parts(self) -> list[Path]:
        """The parts that are written, in order."""
        return sorted((self.path / PARTS).glob("part-*.parquet"))

    def known(self) -> BoolArray:
        """Which points (n,) have a row. Raises InputError for a part that cannot be read or has a point twice."""
        out = np.zeros(self.points, dtype=bool)
        for part in self.parts():
            try:
                found = parquet.read_table(part, columns=["point"])["point"].to_numpy()
            except (OSError, pa.ArrowException) as error:
                raise InputError(
                    f"cannot be read: {error}; remove it, and its points are done again", file=str(part)
                ) from error
            if out[found].any():
                raise InputError("has a point that another part has, too; remove it", file=str(part))
            out[found] = True
        return out

    def write_part(self, rows: Sequence[Row], timings: Sequence[tuple[int, float, str]]) -> None:
        """Write rows as the next part, in order of their points, and what they took."""
        parts = self.parts()
        name = f"part-{int(parts[-1].stem[5:]) + 1 if parts else 0:06}.parquet"
        took = sorted(timings)
        table = pa.table({field.name: [one[i] for one in took] for i, field in enumerate(_TIMING)}, schema=_TIMING)
        _write(self.path / TIMINGS / name, table)
        ordered = sorted(rows, key=lambda row: row["point"])
        _write(self.path / PARTS / name, pa.Table.from_pylist(ordered, schema=self._schema))

    def finish(self) -> None:
        """Write all rows in order as one file."""
        table = pa.concat_tables(parquet.read_table(part) for part in self.parts())
        assert table.num_rows == self.points, "a point was lost: an error in trajopt"
        _write(self.path / POINTS, table.sort_by("point").combine_chunks())

    def rows(self) -> pa.Table:
        """The rows so far, in order of their points."""
        if (self.path / POINTS).is_file():
            return parquet.read_table(self.path / POINTS)
        parts = [parquet.read_table(part) for part in self.parts()]
        return pa.concat_tables(parts).sort_by("point") if parts else self._schema.empty_table()


def _write(path: Path, table: pa.Table) -> None:
    out = BytesIO()
    parquet.write_table(table, out)
    write_file(path, out.getvalue())


def new_or_same(folder: Path, study: Study) -> StudyFolder:
    """The results folder of a study: a new one, or the one that it was stopped in.

    Raises InputError where the folder is of another study, or of inputs that have changed since, and what changed.
    """
    check_writable(folder)
    record = _record(study)
    if not (folder / RECORD).is_file():
        if folder.is_dir() and any(folder.iterdir()):
            raise InputError("is a folder with something else in it; name another one by --output", file=str(folder))
        write_file(folder / STUDY, study.text.encode())
        write_file(folder / RECORD, (json.dumps(record, indent=1, ensure_ascii=False) + "\n").encode())
    before = _read_record(folder)
    if before != json.loads(json.dumps(record)):
        changed = ", ".join(_changed(before, record))
        said = f"holds results of other inputs: {changed} changed since; take that back, or name another --output"
        raise InputError(said, file=str(folder))
    return StudyFolder(folder, study.inputs.columns, len(study.design))


def open_study(folder: Path) -> StudyFolder:
    """The results folder of a study, as it stands. Raises InputError for one that is none."""
    record = _read_record(folder)
    return StudyFolder(folder, tuple(Column(**one) for one in record["columns"]), record["points"])


def _read_record(folder: Path) -> dict[str, Any]:
    try:
        record: dict[str, Any] = json.loads((folder / RECORD).read_text("utf-8"))
    except (OSError, ValueError) as error:
        raise InputError(f"is no study's results folder: {error}", file=str(folder), kind=ErrorKind.RESULTS) from error
    return record


def _record(study: Study) -> dict[str, Any]:
    digests = {name: sha256(content).hexdigest() for name, content in study.files.items()}
    return {
        "format": _FORMAT,
        "trajopt": __version__,
        "points": len(study.design),
        "study": sha256(study.text.encode()).hexdigest(),
        "inputs": digests,
        "columns": [asdict(one) for one in study.inputs.columns],
    }


def _changed(before: Mapping[str, Any], now: Mapping[str, Any]) -> list[str]:
    """What differs between two records, by name."""
    was, is_ = before.get("inputs", {}), now["inputs"]
    files = [name for name in {**was, **is_} if was.get(name) != is_.get(name)]
    names = {"study": "the study file", "trajopt": f"trajopt ({before.get('trajopt')})", "format": "the format"}
    return [*files, *(said for key, said in names.items() if before.get(key) != now[key])] or ["the columns"]
