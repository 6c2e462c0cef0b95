import json
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.geometry import rotation_about
from trajopt_cli.robot.model import Structure, load_robot, robot_names

TRUTH = Path(__file__).parents[2].parent / "shared" / "truth"


@pytest.fixture(scope="session")
def truth():
    def read(name):
        path = TRUTH / name
        if not path.is_file():
            pytest.skip(f"{name} stands in shared/truth beside the repository, and is not there")
        return json.loads(path.read_text())["cases"]

    return read


@pytest.fixture(scope="session")
def irb140():
    return load_robot("irb140")


def crooked_pose(seed):
    rng = np.random.default_rng(seed)
    axis = rng.normal(size=3)
    X = np.eye(4)
    X[:3, :3] = rotation_about(axis / np.linalg.norm(axis), rng.uniform(0.5, 3.0))
    X[:3, 3] = rng.uniform(-0.5, 0.5, 3)
    return X


@pytest.fixture(scope="session", params=robot_names(Structure.SIX_AXIS))
def mounted(request):
    """Every six-axis robot that ships, mounted at a crooked pose in the world."""
    return load_robot(request.param, X_WR=crooked_pose(7))


@pytest.fixture(scope="session")
def X_FT():
    """A tool that is neither straight nor on the flange axis."""
    return crooked_pose(8)


@pytest.fixture
def rng():
    return np.random.default_rng(20140)
