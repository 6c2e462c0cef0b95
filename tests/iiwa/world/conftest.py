import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.geometry import pose, rotation_about
from trajopt_cli.iiwa.task.model import Contact, Obstacle
from trajopt_cli.robot.dynamics import ToolLoad
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.shapes import Box

TRUTH = Path(__file__).parents[2] / "data" / "truth"
H = 1e-3
TIP = 0.02
START = (0.0, *np.radians([30.0, 0.0, -100.0, 0.0, 50.0, 0.0]).tolist())


@pytest.fixture(scope="session")
def truth():
    def read(name):
        path = TRUTH / name
        return json.loads(path.read_text())["cases"]

    return read


@pytest.fixture(scope="session")
def iiwa7():
    return load_srs("iiwa7")


@pytest.fixture(scope="session")
def smooth(iiwa7):
    """The arm without friction, which else creeps for long before it rests."""
    return replace(iiwa7, damping=np.zeros(7), friction=np.zeros(7))


@pytest.fixture(scope="session")
def crooked(iiwa7):
    """The arm hanging askew in the world."""
    return iiwa7.mounted(pose(rotation_about([0.6, 0.0, 0.8], 2.0), [0.3, -0.2, 1.1]))


@pytest.fixture(scope="session")
def X_FT():
    return pose(rotation_about([0.0, 0.6, 0.8], 0.7), [0.02, -0.03, 0.15])


@pytest.fixture(scope="session")
def load():
    R = rotation_about([0.0, 0.6, 0.8], 0.4)
    return ToolLoad(0.8, np.array([0.01, -0.02, 0.07]), R @ np.diag([2e-3, 3e-3, 1.5e-3]) @ R.T)


@pytest.fixture
def floor(iiwa7, X_FT):
    """Makes a contact with a big box under the tip at START, this far into it [m]."""

    def make(depth, stiffness=2e4, damping=100.0, friction=0.3, robot=iiwa7):
        x, y, z = (robot.forward(np.array(START)) @ X_FT)[:3, 3]
        box = Box("floor", np.array([0.6, 0.8, 0.2]), pose(np.eye(3), [x, y, z - TIP + depth - 0.1]))
        return Contact((Obstacle(box, stiffness, damping, friction),), TIP)

    return make


@pytest.fixture
def ball_at(iiwa7, X_FT):
    """Joints near q that put the TCP at p (3,) [m] with the orientation it has at q: Newton's steps."""

    def solve(p, q, steps):
        q = np.array(q)
        R = (iiwa7.forward(q) @ X_FT)[:3, :3]
        for _ in range(steps):
            X = iiwa7.forward(q) @ X_FT
            off = 0.5 * sum(np.cross(X[:3, i], R[:, i]) for i in range(3))
            q = q + np.linalg.pinv(iiwa7.jacobian(q, X_FT)) @ np.concatenate([p - X[:3, 3], off])
        return tuple(q.tolist())

    return solve
