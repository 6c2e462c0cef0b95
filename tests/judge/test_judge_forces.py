"""The judge's torques: their derivatives are their differences, and the mass matrix is what acceleration costs."""

from __future__ import annotations

import numpy as np
import pytest
from heavy_cells import heavy

from trajopt_cli.geometry import Array
from trajopt_cli.judge.mechanism import Forces, mechanism_of

STEP = 1e-6


@pytest.fixture
def forces() -> Forces:
    plant = heavy()
    load = (4.0, np.array([0.03, -0.05, 0.12]), np.diag([0.02, 0.03, 0.04]))
    return Forces(mechanism_of(plant), plant.robot.rotor, [load])


@pytest.fixture
def states() -> tuple[Array, Array, Array]:
    rng = np.random.default_rng(8)
    return rng.uniform(-2, 2, (20, 6)), rng.uniform(-3, 3, (20, 6)), rng.uniform(-9, 9, (20, 6))


@pytest.mark.parametrize("which", range(3))
def test_changes_are_differences(forces: Forces, states: tuple[Array, Array, Array], which: int) -> None:
    found = forces.changes(*states)[which]
    for j in range(6):
        steps = np.zeros((3, 1, 6))
        steps[which, 0, j] = STEP
        ahead, behind = (
            forces.torques(*(x + sign * h for x, h in zip(states, steps, strict=True))) for sign in (1, -1)
        )
        np.testing.assert_allclose(found[:, :, j], (ahead - behind) / (2 * STEP), rtol=1e-5, atol=1e-4)


def test_the_mass_matrix_is_the_torques_of_unit_accelerations(
    forces: Forces, states: tuple[Array, Array, Array]
) -> None:
    q, still = states[0], np.zeros((20, 6))
    masses = forces.masses(q)
    for j in range(6):
        more = forces.torques(q, still, still + np.eye(6)[j]) - forces.torques(q, still, still)
        np.testing.assert_allclose(masses[:, :, j], more, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(masses, forces.changes(q, still, still)[2], rtol=1e-9, atol=1e-12)
