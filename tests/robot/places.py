"""Where the truth lies, and where a robot or a tool may stand."""

from pathlib import Path

import numpy as np

from trajopt_cli.geometry import rotation_about
from trajopt_cli.robot.model import Structure, robot_names

TRUTH = Path(__file__).parents[1] / "data" / "truth"


def crooked_pose(seed):
    rng = np.random.default_rng(seed)
    axis = rng.normal(size=3)
    X = np.eye(4)
    X[:3, :3] = rotation_about(axis / np.linalg.norm(axis), rng.uniform(0.5, 3.0))
    X[:3, 3] = rng.uniform(-0.5, 0.5, 3)
    return X


# A track adds the same axis to all of them (test_shipped_robots.py): three stand for the rest.
TRACKS = ("irb140_rail", "kr6_r900_rail", "ur5e_rail")
ARMS = [name for name in robot_names(Structure.SIX_AXIS) if not name.endswith("_rail") or name in TRACKS]
