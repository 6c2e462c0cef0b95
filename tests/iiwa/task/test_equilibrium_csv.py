"""Equilibrium CSV: written rows come back bit for bit, times read well, and where a malformed file is wrong."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.task.angles import rotation
from trajopt_cli.iiwa.task.equilibrium import (
    ANGLES_HEAD,
    Equilibrium,
    read_angles_csv,
    read_quaternion_csv,
    write_angles_csv,
    write_quaternion_csv,
)
from trajopt_cli.iiwa.task.model import AngleMeaning, RotationLaw

POSE = np.random.default_rng(3).normal(size=(200, 6))


def sequence(h: float) -> Equilibrium:
    return Equilibrium(h, POSE, rotation(POSE[:, 3:]), RotationLaw.TAIT_BRYAN, AngleMeaning.ABSOLUTE, ())


@pytest.mark.parametrize("h", [0.001, 0.004, 0.01, 1 / 300, 0.1, 1.7e-5])
def test_poses_and_period_come_back_bit_for_bit(h: float) -> None:
    text = write_angles_csv(sequence(h))
    assert text.split("\n")[0] == "t [s],x [m],y [m],z [m],alpha [rad],beta [rad],gamma [rad]"
    period, pose = read_angles_csv(text, "a.csv")
    assert period == h
    assert np.array_equal(pose, POSE)
    times = np.array([float(line.split(",")[0]) for line in text.split("\n")[1:-1]])
    assert np.all(np.abs(times - np.arange(200) * h) <= 1e-15 * np.arange(200) * h)


def test_times_are_short_where_they_can_be() -> None:
    column = [line.split(",")[0] for line in write_angles_csv(sequence(0.001)).split("\n")[1:-1]]
    assert column == ["0", *(f"{k / 1000:g}" for k in range(1, 200))]


def test_quaternions_are_scipys_and_never_flip() -> None:
    turn = np.linspace(0, 13, 400)
    R = Rotation.from_rotvec(turn[:, None] * [0.6, 0.0, 0.8])
    t = np.arange(400) * 0.01
    p = np.column_stack([np.sin(t), t, -t])
    text = write_quaternion_csv(t, p, R.as_matrix())
    assert text.split("\n")[0] == "t [s],x [m],y [m],z [m],qw [1],qx [1],qy [1],qz [1]"
    q = np.loadtxt(text.split("\n")[1:-1], delimiter=",")[:, 4:]
    wanted = np.column_stack([np.cos(turn / 2), np.sin(turn / 2)[:, None] * [0.6, 0.0, 0.8]])
    assert np.abs(q - wanted).max() < 1e-14
    found_t, found_p, found_R = read_quaternion_csv(text, "q.csv")
    assert np.abs(found_t - t).max() < 1e-14
    assert np.array_equal(found_p, p)
    assert np.abs(found_R - R.as_matrix()).max() < 1e-14


ROW = ",0,0,0,0,0,0"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "a.csv:1:"),
        (ANGLES_HEAD.replace("y [m]", "y [mm]"), "a.csv:1:"),
        (f"{ANGLES_HEAD}\n0{ROW}\n", "a.csv:1:"),
        (f"{ANGLES_HEAD}\n0{ROW}\n0.1,0,0\n", "a.csv:3:"),
        (f"{ANGLES_HEAD}\n0{ROW}\n0.1,0,nan,0,0,0,0\n", "a.csv:3:7:"),
        (f"{ANGLES_HEAD}\n0{ROW}\n0.1,0,0,0,0,0,x\n", "a.csv:3:15:"),
        (f"{ANGLES_HEAD}\n0{ROW}\n0.1,0,0,0,0,0,\n", "a.csv:3:15:"),
        (f"{ANGLES_HEAD}\n0{ROW}\n0.1,0,0 0,0,0,0,0\n", "a.csv:3:7:"),
    ],
)
def test_a_malformed_file_is_one_line_with_its_place(text: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        read_angles_csv(text, "a.csv")
    assert str(caught.value).startswith(message)
