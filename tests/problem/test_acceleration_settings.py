"""AccSet is a share of every acceleration, WorldAccLim a cap on the whole one, PathAccLim on what is along the path."""

from __future__ import annotations

import pytest
from some_motions import move_abs_j, move_ext_j, move_j, move_l

from trajopt_cli.limits import TcpCaps
from trajopt_cli.motion import Settings
from trajopt_cli.problem.acceleration_settings import acceleration_share, path_acceleration, tcp_acceleration

CAPS = TcpCaps(2.5, 20.0)


@pytest.mark.parametrize(
    ("settings", "share", "cap", "along"),
    [
        (Settings(), 1.0, 20.0, None),
        (Settings(acceleration=0.3, ramp=0.1), 0.3, 6.0, None),
        (Settings(path_acceleration=5.0), 1.0, 20.0, (5.0, 20.0)),
        (Settings(path_deceleration=4.0), 1.0, 20.0, (20.0, 4.0)),
        (Settings(path_acceleration=5.0, path_deceleration=4.0, world_acceleration=3.0), 1.0, 3.0, None),
        (Settings(path_acceleration=5.0, path_deceleration=2.0, world_acceleration=3.0), 1.0, 3.0, (3.0, 2.0)),
        (Settings(path_acceleration=30.0), 1.0, 20.0, None),
        (Settings(acceleration=0.5, path_acceleration=8.0), 0.5, 10.0, (8.0, 10.0)),  # not 4: PathAccLim as it is
        (Settings(acceleration=0.2, path_acceleration=8.0), 0.2, 4.0, None),
    ],
)
def test_the_smallest_counts(settings: Settings, share: float, cap: float, along: tuple[float, float] | None) -> None:
    for move in (move_j(settings=settings), move_l(settings=settings), move_abs_j(settings=settings)):
        assert acceleration_share(move) == share
        assert tcp_acceleration(move, CAPS) == pytest.approx(cap, rel=1e-15)
        assert path_acceleration(move, CAPS) == (None if along is None else pytest.approx(along, rel=1e-15))


def test_external_axes_alone_know_only_the_share() -> None:
    move = move_ext_j(settings=Settings(acceleration=0.5, path_acceleration=1.0, world_acceleration=1.0))
    assert acceleration_share(move) == 0.5
    assert tcp_acceleration(move, CAPS) == 10.0
    assert path_acceleration(move, CAPS) is None
