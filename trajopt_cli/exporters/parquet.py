"""A joint motion as a Parquet file, the columns those of the joint CSV."""

from __future__ import annotations

from io import BytesIO

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.joint_csv import header
from trajopt_cli.trajectory import Trajectory


def parquet(trajectory: Trajectory) -> bytes:
    """The file: a column of doubles for time, every axis and, where there are speeds, every axis' speed.

    Raises InputError where pyarrow, the extra parquet, cannot be imported.
    """
    try:
        import pyarrow
        from pyarrow.parquet import write_table
    except ImportError as error:
        message = "pyarrow is not installed: pip install 'trajopt-cli[parquet]'"
        if error.name is None or error.name.split(".")[0] != "pyarrow":
            message = f"pyarrow cannot be imported: {error}; pip install --force-reinstall 'trajopt-cli[parquet]'"
        raise InputError(message) from error
    trajectory = trajectory.whole
    columns = [trajectory.t, *trajectory.q.T, *([] if trajectory.qd is None else trajectory.qd.T)]
    heads = header(trajectory.names, trajectory.qd is not None)
    out = BytesIO()
    write_table(pyarrow.table([np.ascontiguousarray(column) for column in columns], names=heads), out)
    return out.getvalue()
