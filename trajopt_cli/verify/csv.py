"""Trajectory files as the judge reads them."""

from __future__ import annotations

from pathlib import Path

from trajopt_cli.errors import InputError
from trajopt_cli.joint_csv import Resolution, read_csv_text
from trajopt_cli.trajectory import Trajectory


def read_trajectory(path: str | Path) -> tuple[Trajectory, Resolution]:
    """A joint CSV from disk, in SI, with its printed resolution. A file with NaN is malformed, not illegal.

    Raises InputError naming file, line and column for what is missing or malformed; see joint_csv.read_csv_text.
    """
    try:
        text = Path(path).read_text(encoding="utf-8-sig")
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}", file=str(path)) from error
    except UnicodeDecodeError as error:
        raise InputError(f"is not UTF-8 text (byte {error.start}); give a CSV file", file=str(path)) from error
    return read_csv_text(text, str(path))
