"""`trajopt iiwa joints` on a long sequence: seconds of each of its parts, and of the whole command.

python benchmarks/bench_joints.py [--rows N] [--task NAME]
"""

from __future__ import annotations

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before NumPy starts its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import re
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

sys.path.insert(0, str(Path(__file__).parents[1]))  # run from a checkout without installing

from trajopt_cli.iiwa.job.folder import open_folder, read_task_run
from trajopt_cli.iiwa.job.segments import make_segments
from trajopt_cli.iiwa.task.arm_plan import ArmAngleObjective, Goal
from trajopt_cli.iiwa.task.joint_checks import check_joints, remarks
from trajopt_cli.iiwa.task.joints import follow
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.robot.srs_inverse import inverse_branch

ROOT = Path(__file__).parents[1]


def timed(label, call):
    """Least processor time of three calls, that of child processes included."""
    spent = []
    for _ in range(3):
        before = sum(os.times()[:4])
        answer = call()
        spent.append(sum(os.times()[:4]) - before)
    print(f"{label:44}{min(spent):8.2f} s")
    return answer


def slowed(text, factor):
    """The task with speeds divided by factor."""
    for key in ("v_max", "omega_max"):
        value, unit = re.search(rf"(?m)^{key}: (\S+) (\S+)", text).groups()
        text = text.replace(f"{key}: {value} {unit}", f"{key}: {float(value) / factor:.9g} {unit}", 1)
    return text


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", type=int, default=100_000)
    parser.add_argument("--task", default="iiwa_polish")
    options = parser.parse_args()
    with TemporaryDirectory() as place:
        text = (ROOT / "programs" / f"{options.task}.yaml").read_text(encoding="utf-8")
        file, folder = Path(place, "task.yaml"), Path(place, "results")
        factor = 1.0
        for _ in range(4):  # ramps take their time whatever the speed
            file.write_text(slowed(text, factor), encoding="utf-8")
            factor *= options.rows / len(make_segments(file, folder, None, None).opened.equilibrium.pose)
        timed("files read, hashes compared", lambda: read_task_run(folder))
        opened = timed("the folder opened, its texts as numbers", lambda: open_folder(folder))
        task, robot, h = opened.task, opened.robot, opened.equilibrium.h
        limits = robot.profile(task.limits)
        given = (opened.equilibrium, opened.arm)
        answer = timed(f"joints and checks, {len(opened.equilibrium.pose)} rows", lambda: follow(*given))
        q, X, branch = answer.trajectory.q, answer.X_WF, answer.configuration
        timed("  of it inverse kinematics", lambda: inverse_branch(robot, X, 0.0, task.definition, branch))
        timed("  of it limits", lambda: check_joints(q, h, limits, str, False))
        timed("  of it notes", lambda: list(remarks(robot, q, h, limits, str)))
        for goal in Goal:
            label = f"arm angle chosen for {goal.value}"
            timed(label, lambda goal=goal: follow(*given, objective=ArmAngleObjective(goal, task.load)))
        timed("joints.csv as text", lambda: write_csv_text(answer.trajectory))
        command = [sys.executable, "-m", "trajopt_cli.cli", "iiwa", "joints", str(folder)]
        timed("the whole command", lambda: subprocess.run(command, cwd=ROOT, capture_output=True, check=False))


if __name__ == "__main__":
    main()
