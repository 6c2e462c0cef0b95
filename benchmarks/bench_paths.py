"""What `trajopt iiwa segments` costs on long paths: seconds and memory of the whole command, per number of poses.

python benchmarks/bench_paths.py [POSES ...]; default 2000 and 100000.
"""

from __future__ import annotations

import resource
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
v_max: 0.1
omega_max: 30 deg/s
a_max: 1
epsilon_max: 3
jerk: 20
angular_jerk: 60
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""
HEAD = "x [mm],y [mm],z [mm],alpha [deg],beta [deg],gamma [deg]"


def write_path(file: Path, count: int) -> None:
    """Turns of 50 mm radius that rise and sink, a pose every 0.4 mm, the tool tilting by a few degrees."""
    turn = np.arange(count) * 0.4e-3 / 0.05
    place = [500 + 50 * np.cos(turn), 50 * np.sin(turn), 300 + 20 * np.sin(turn / 50)]
    tilt = [5 * np.sin(turn / 3), 5 * np.cos(turn / 3) - 5, 0 * turn]
    np.savetxt(file, np.column_stack([*place, *tilt]), delimiter=",", header=HEAD, comments="", fmt="%.6f")
    file.with_suffix(".yaml").write_text(TASK)


def main(counts: list[int]) -> None:
    print(f"{'poses':>9} {'seconds':>8} {'peak MB':>8}  output")
    for count in counts:
        with TemporaryDirectory() as folder:
            file = Path(folder) / "path.csv"
            write_path(file, count)
            command = [
                sys.executable,
                "-m",
                "trajopt_cli.cli",
                "iiwa",
                "segments",
                str(file),
                "--output",
                f"{folder}/out",
            ]
            begin = time.perf_counter()
            said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
            seconds = time.perf_counter() - begin
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1e3
        (line,) = (line for line in said.splitlines() if line.startswith("T = "))
        print(f"{count:>9} {seconds:>8.2f} {peak:>8.0f}  {line.split(';')[0]}")


if __name__ == "__main__":
    main([int(value) for value in sys.argv[1:]] or [2_000, 100_000])
