import json

import numpy as np
import pytest
from places import TRUTH, crooked_pose

from trajopt_cli.robot.model import Structure, load_robot, robot_names


@pytest.fixture(scope="session")
def truth():
    def read(name):
        path = TRUTH / name
        return json.loads(path.read_text())["cases"]

    return read


@pytest.fixture(scope="session")
def irb140():
    return load_robot("irb140")


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
