"""What `trajopt iiwa segments` costs on long paths: seconds and memory of the whole command, per number of poses.

python benchmarks/bench_paths.py [POSES ...]; default 2000 and 100000. With --topp REVISION: what an interval of a path
takes in timing/topp.py of a revision, such as 8545f75f, and here, in one run, on random paths of sinusoidal axes.
"""

from __future__ import annotations

import resource
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))  # run from a checkout without installing

from trajopt_cli.timing.topp import fastest_laws

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


def of_revision(revision: str) -> ModuleType:
    """timing/topp.py as it was."""
    text = subprocess.run(
        ["git", "show", f"{revision}:trajopt_cli/timing/topp.py"], capture_output=True, text=True, check=True
    ).stdout
    sys.modules["topp_before"] = module = ModuleType("topp_before")
    exec(text, module.__dict__)
    return module


def compare(revision: str) -> None:
    """Nanoseconds of processor an interval, the least of five rounds in turns; and by how much rates differ at most."""
    before = of_revision(revision).fastest_laws
    print(f"{'paths':>6} {'points':>6} {'axes':>5} {revision[:8]:>9} {'here':>6} {'ratio':>6} {'differ':>8}")
    for B, n, m in ((500, 97, 7), (500, 97, 15), (50, 289, 15), (2000, 21, 15), (1, 10_001, 15)):
        rng, s = np.random.default_rng(0), np.linspace(0, 1, n)
        turns, phase, size = (rng.uniform(*span, (B, 1, m)) for span in ((1, 6), (0, 6.28), (0.2, 1.5)))
        angle = turns * s[:, None] + phase
        slope, bend = size * turns * np.cos(angle) / 10, -size * turns**2 * np.sin(angle) / 10
        top = (0.3 / np.maximum(np.abs(slope), 1e-7)).min(axis=2)
        rows = (slope[:, :-1], bend[:, :-1]), (slope[:, 1:], bend[:, 1:])
        least, rates = [np.inf, np.inf], [None, None]
        for _ in range(5):
            for i, laws in enumerate((before, fastest_laws)):
                begin = time.process_time()
                rates[i] = laws(s, top, *rows, 0.0, 0.0).rates
                least[i] = min(least[i], (time.process_time() - begin) / (B * (n - 1)) * 1e9)
        differ = np.abs(rates[0] - rates[1]).max() / rates[0].max()
        print(f"{B:>6} {n:>6} {m:>5} {least[0]:>9.0f} {least[1]:>6.0f} {least[0] / least[1]:>6.1f} {differ:>8.0e}")


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
    if sys.argv[1:2] == ["--topp"]:
        compare(sys.argv[2])
    else:
        main([int(value) for value in sys.argv[1:]] or [2_000, 100_000])
