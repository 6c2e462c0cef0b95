"""Folders of `trajopt iiwa` for the judge, and their files as tables that a test may spoil."""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.job.joints import follow_joints
from trajopt_cli.iiwa.job.segments import make_segments
from trajopt_cli.iiwa.task.model import AngleMeaning

H = 1e-3
PLATE = """
tool: {position: [0, 0, 0.1]}
v_max: 0.1
omega_max: 1
a_max: 1
epsilon_max: 5
poses:
  - {name: start, at: start}
  - {name: on it, by: [0, 0, -0.03, 0, 0, 0], dwell: 0.4}
  - {name: along, by: [0.04, 0, 0, 0, 0.05, 0]}
  - {name: off, by: [0, 0, 0.03, 0, 0, 0]}
"""
CONTACT = """
contact:
  tip: 0.02
  obstacles:
    plate: {box: {size: [0.3, 0.3, 0.02], position: [0.5, 0, 0.1533]}, stiffness: 20 N/mm, damping: 40, friction: 0.2}
"""
HOME = 'start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}\n'
CONTROLLER = "K: [1000, 1000, 1000, 30, 30, 30]\nD: [500, 500, 500, 20, 20, 20]\nM: [25, 25, 25, 3, 3, 3]\n"
POSES = """
tool: {position: [0, 0, 0.05]}
v_max: 0.2
omega_max: 1
a_max: 2
epsilon_max: 6
jerk: 40
angular_jerk: 100
poses:
  - {name: start, at: start, dwell: 0.02}
  - {name: a, by: [0.03, 0, 0, 0, 0, 0]}
  - {name: b, by: [0, 0.02, -0.01, 0.1, 0.05, -0.1], dwell: 50 ms}
  - {name: c, by: [0, 0, 0, 0, 0, 8 deg]}
  - {name: d, by: [-0.02, 0, 0.01, 0, 0, 0], dwell: 0.02}
"""


def task_text(profile: str = "trapezoid", rotation: str = "tait-bryan", poses: str = POSES, more: str = "") -> str:
    return f"{HOME}profile: {profile}\nrotation: {rotation}\n{more}{poses}{CONTROLLER}"


def make_folder(
    folder: Path, text: str, *, joints: bool = True, free: bool = False, angles: AngleMeaning | None = None
) -> Path:
    """A task's text as a results folder."""
    task = folder.parent / f"{folder.name}.yaml"
    task.write_text(text, encoding="utf-8")
    make_segments(task, folder, None, angles)
    if joints:
        follow_joints(folder, free)
    return folder


@dataclass
class Table:
    """A CSV file: heads and rows (n, k), first the time."""

    heads: list[str]
    rows: Array

    @classmethod
    def read(cls, path: Path) -> Table:
        head, *rows = path.read_text().splitlines()
        return cls(head.split(","), np.loadtxt(rows, delimiter=",", ndmin=2))

    def write(self, path: Path) -> None:
        line = ",".join(["%.17g"] * self.rows.shape[1])
        path.write_text("\n".join([",".join(self.heads), *(line % tuple(row) for row in self.rows.tolist())]) + "\n")


@dataclass
class Sequence:
    """Position (n, 3) and angles (n, 3) of a sequence, to be written into both of its files."""

    p: Array
    angles: Array
    R_start: Rotation

    def leg(self, folder: Path, i: int) -> slice:
        """The rows of piece i, its ends included."""
        piece = json.loads((folder / "summary.json").read_text())["sequence"]["pieces"][i]
        return slice(piece["first"], piece["last"] + 1)

    @property
    def t(self) -> Array:
        return np.arange(len(self.p)) * H

    @classmethod
    def read(cls, folder: Path) -> Sequence:
        table = Table.read(folder / "equilibrium.csv").rows
        q = Table.read(folder / "equilibrium_quaternion.csv").rows[0, 4:]
        first = Rotation.from_euler("xyz", table[0, 4:])
        return cls(table[:, 1:4], table[:, 4:], first.inv() * Rotation.from_quat(q, scalar_first=True))

    def write(self, folder: Path) -> None:
        q = (Rotation.from_euler("xyz", self.angles) * self.R_start).as_quat(scalar_first=True)
        angles, quaternions = (Table.read(folder / f"equilibrium{end}.csv").heads for end in ("", "_quaternion"))
        Table(angles, np.column_stack([self.t, self.p, self.angles])).write(folder / "equilibrium.csv")
        Table(quaternions, np.column_stack([self.t, self.p, q])).write(folder / "equilibrium_quaternion.csv")
        tell_rows(folder, len(self.p))


def tell_rows(folder: Path, count: int) -> None:
    """summary.json as if the sequence had been made with so many rows."""
    summary = json.loads((folder / "summary.json").read_text())
    summary["sequence"]["rows"] = count
    tell_summary(folder, summary)


def tell_summary(folder: Path, summary: dict[str, Any]) -> None:
    """Another summary.json, as if the folder had been made with it."""
    text, run = json.dumps(summary), json.loads((folder / "run.json").read_text())
    (folder / "summary.json").write_text(text)
    run["files"]["summary.json"] = hashlib.sha256(text.encode()).hexdigest()
    (folder / "run.json").write_text(json.dumps(run))


def list_files(folder: Path, *names: str) -> None:
    """run.json as if the folder had been made with these files."""
    run = json.loads((folder / "run.json").read_text())
    for name in names:
        run["files"][name] = hashlib.sha256((folder / name).read_bytes()).hexdigest()
    (folder / "run.json").write_text(json.dumps(run))


def edit_sequence(folder: Path, edit: Callable[[Sequence, Path], None]) -> None:
    sequence = Sequence.read(folder)
    edit(sequence, folder)
    sequence.write(folder)


def edit_table(folder: Path, name: str, edit: Callable[[Array], Array | None]) -> None:
    table = Table.read(folder / name)
    changed = edit(table.rows)
    Table(table.heads, table.rows if changed is None else changed).write(folder / name)


def copied(folder: Path, to: Path) -> Path:
    shutil.copytree(folder, to)
    return to


def bump(n: int) -> Array:
    """From 0 to 1 and back over n rows, with speed and acceleration from rest to rest."""
    return np.sin(np.linspace(0, np.pi, n)) ** 4
