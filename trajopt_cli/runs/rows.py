"""A plan's rows outside of memory: those of an hour are half a gigabyte, and their text is more than twice that."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from io import BufferedRandom, TextIOWrapper
from pathlib import Path
from tempfile import TemporaryFile, gettempdir
from typing import TextIO

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import csv_parts
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.trajectory import Trajectory


class RowsFile:
    """The rows of one plan, as numbers and as the text of their CSV file, in files without a name.

    They are gone with the last process that has them. Made before a process is forked, they are filled by one of both
    and read by the other, never by both at once.
    """

    def __init__(self, beside: Path | None = None, plant: Plant | None = None):
        """beside: a path, that need not exist, on the disk that shall hold the files; None: where the system keeps
        such files. plant: whose axes that others lead have columns in the text, too. Raises InputError where nothing
        can be written there."""
        self._plant = plant
        folder = None if beside is None else Path(os.path.realpath(beside)).parent
        while folder is not None and not folder.is_dir():
            folder = folder.parent
        self._folder = Path(gettempdir()) if folder is None else folder
        with self._written():
            self._numbers, self._bytes = (TemporaryFile(dir=self._folder) for _ in range(2))  # noqa: SIM115
        self._text = TextIOWrapper(self._bytes, encoding="ascii", newline="\n")

    def __del__(self) -> None:
        for name in ("_text", "_numbers"):  # rows that were read stay
            with suppress(AttributeError, OSError):  # never made; on a full disk: what is left has no reader any more
                getattr(self, name).close()

    @property
    def text(self) -> TextIO:
        """The CSV file's text, to be read from its beginning."""
        return self._text

    @property
    def content(self) -> BufferedRandom:
        """The CSV file's bytes, to be read from their beginning."""
        return self._bytes

    def keep(self, plan: Plan) -> Plan:
        """Write a plan's rows, in the place of what was there; the plan with them here and no more in memory. Raises
        InputError where they cannot be written."""
        rows = plan.trajectory
        with self._written():
            for file in (self._numbers, self._text):
                file.seek(0)
                file.truncate()
            for array in _arrays(rows):
                self._numbers.write(np.ascontiguousarray(array).data)
            self._numbers.flush()
            self._text.writelines(csv_parts(rows if self._plant is None else self._plant.with_followers(rows)))
            self._text.flush()
        return self.kept(plan)

    def kept(self, plan: Plan) -> Plan:
        """A plan, of whose rows the first and the last are known, with all of those that were written."""
        names, speeds = plan.trajectory.whole.names, plan.trajectory.qd is not None
        k = len(names)
        row = np.dtype(np.float64).itemsize * (1 + k * (2 if speeds else 1))
        n = os.fstat(self._numbers.fileno()).st_size // row
        numbers = np.memmap(self._numbers, np.float64, mode="r").view(np.ndarray)
        t, *rest = np.split(numbers, np.cumsum([n, n * k]))
        q, qd = (x.reshape(n, k) if x.size else None for x in rest)
        assert q is not None
        return replace(plan, trajectory=Trajectory(names, t, q, qd).apart)

    @contextmanager
    def _written(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            raise InputError(f"cannot write: {error.strerror}", file=str(self._folder)) from error


def without_rows(plan: Plan) -> Plan:
    """A plan with the first and the last of its rows alone: for who asks how long it takes, and for another process."""
    rows = plan.trajectory
    t, q, *qd = (array[[0, -1]] for array in _arrays(rows))
    return replace(plan, trajectory=Trajectory(rows.whole.names, t, q, qd[0] if qd else None).apart)


def _arrays(rows: Trajectory) -> list[Array]:
    rows = rows.whole
    return [rows.t, rows.q] + ([] if rows.qd is None else [rows.qd])
