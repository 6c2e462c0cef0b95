"""Tables of numbers in CSV text, read at once; the first mistake is named with its line and column."""

from __future__ import annotations

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array


def read_numbers(rows: list[str], width: int, file: str, separator: str = ",") -> Array:
    """The finite numbers (n, width) of rows under a header line.

    Raises InputError with file and line for a row of another length, and with its column for what is no finite number.
    """
    for line, row in enumerate(rows, start=2):
        count = row.count(separator) + 1
        if count != width:
            found = f"{count if row.strip() else 'no'} values"
            raise InputError(f"{found}, the header has {width} columns", file=file, line=line)
    try:
        table = np.loadtxt(rows, delimiter=separator, comments=None, ndmin=2)
    except ValueError:
        table = np.full((1, 1), np.nan)
    if np.isfinite(table).all():
        return np.asarray(table, dtype=np.float64)
    for line, row in enumerate(rows, start=2):
        column = 1
        for field in row.rstrip("\r").split(separator):
            if not _is_finite(field):
                advice = "; write numbers with a decimal point" if "," in field else ""
                message = f"'{field.strip()[:40]}' is not a finite number{advice}"
                raise InputError(message, file=file, line=line, column=column)
            column += len(field) + 1
    raise InputError("the table holds a number that cannot be read", file=file)


def _is_finite(field: str) -> bool:
    try:
        return bool(np.isfinite(float(field)))
    except ValueError:
        return False
