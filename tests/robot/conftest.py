import json

import numpy as np
import pytest
from places import ARMS, TRUTH, crooked_pose

from trajopt_cli.robot.model import load_robot


@pytest.fixture(scope="session")
def truth():
    def read(name):
        path = TRUTH / name
        return json.loads(path.read_text())["cases"]

    return read


@pytest.fixture(scope="session")
def irb140():
    return load_robot("irb140")


@pytest.fixture(scope="session", params=ARMS)
def mounted(request):
    """Every six-axis robot that ships, three of them on a track, mounted at a crooked pose in the world."""
    return load_robot(request.param, X_WR=crooked_pose(7))


@pytest.fixture(scope="session")
def X_FT():
    """A tool that is neither straight nor on the flange axis."""
    return crooked_pose(8)


@pytest.fixture
def rng():
    return np.random.default_rng(20140)
