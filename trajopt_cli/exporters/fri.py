"""Joint positions for a client of KUKA's fast robot interface (FRI): one line per millisecond."""

from __future__ import annotations

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.recorded import Recorded

PERIOD = 1e-3  # s
_AXES = 7
_OFF = 1e-9  # s


def fri_rows(motion: Recorded, between: bool = False) -> tuple[str, int, str]:
    """A text with a header and one line per millisecond, joints A1 to A7 [rad]; how many; what to know of them.

    between: rows of another period are resampled to 1 ms. Raises InputError for a motion that is no seven-axis arm's,
    and for another period where between is False.
    """
    trajectory = motion.trajectory
    if motion.period is None or len(trajectory.names) != _AXES:
        raise InputError("is no motion of an LBR iiwa; FRI is KUKA's, give a folder of trajopt iiwa")
    note = ""
    if abs(motion.period - PERIOD) > _OFF:
        if not between:
            raise InputError(
                f"its rows stand {1e3 * motion.period:g} ms apart, FRI's here 1 ms; give --resample, or make the folder"
                " with h: 1 ms"
            )
        trajectory, note = motion.at(1 / PERIOD)
    head = ",".join(f"A{i} [rad]" for i in range(1, _AXES + 1))
    lines = [",".join([f"{value:.17g}" for value in row]) for row in trajectory.q.tolist()]
    return "\n".join([head, *lines]) + "\n", len(lines), note
