"""Where the truth lies, and where a robot or a tool may stand."""

from pathlib import Path

import numpy as np

from trajopt_cli.geometry import rotation_about

TRUTH = Path(__file__).parents[1] / "data" / "truth"


def crooked_pose(seed):
    rng = np.random.default_rng(seed)
    axis = rng.normal(size=3)
    X = np.eye(4)
    X[:3, :3] = rotation_about(axis / np.linalg.norm(axis), rng.uniform(0.5, 3.0))
    X[:3, 3] = rng.uniform(-0.5, 0.5, 3)
    return X
