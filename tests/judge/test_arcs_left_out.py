"""An arc that ends near where it begins, within the zone of the point before it: it has to be driven all the same."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import pytest
from legal_motion import (
    Case,
    Piece,
    arm_at,
    down,
    home,
    joint_move,
    line_move,
    move_j,
    move_l,
    plant_without_rail,
    program,
    trapezoid,
)
from legal_runs import P0, Z10, move_c

from trajopt_cli.geometry import Array
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Move

PLANT = plant_without_rail()
CORNER, AWAY, OVER = down(0.5, 0.0, 0.4), down(0.42, 0.06, 0.4), down(0.56, 0.0, 0.4)


def on_circle(a: float) -> Array:
    """20 mm in radius, from the corner on."""
    return down(0.5 + 0.02 * np.sin(a), 0.02 - 0.02 * np.cos(a), 0.4)


STOP = on_circle(2 * np.pi - 0.2)  # 4 mm from the corner, after 122 mm


def way(places: Sequence[Array]) -> Piece:
    return line_move(PLANT, *places, None, 0, 0, profile=trapezoid(1e9, 16.0))


def said(stops: Sequence[Array], behind: Sequence[Move], **rows: object) -> list[str]:
    """What is wrong with a motion through these places, straight from one to the next."""
    asked = program(
        move_j(11, "p0", P0), move_l(12, "p1", CORNER, zone=Z10), move_c(13, "s", on_circle(np.pi)[:3, 3], STOP),
        *behind, home(19, None),
    )  # fmt: skip
    first, last = (arm_at(PLANT, X[None], None)[0] for X in (stops[0], stops[-1]))
    paths = [way(pair) for pair in pairwise(stops)]
    pieces = (joint_move(PLANT, PLANT.start, first, 0.5), *paths, joint_move(PLANT, last, PLANT.start, 0.5))
    found = verify(asked, PLANT, Case(PLANT, asked, pieces).rows(**rows), advice=False).findings
    return [one.check for one in found if not one.passed]


@pytest.mark.parametrize(
    "rows", [{"step": 0.004}, {"step": 0.001, "grid_only": True}, {"step": 0.0037, "grid_only": True}]
)
def test_an_arc_is_not_left_out_within_a_zone(rows: dict[str, object]) -> None:
    """Straight to its end, over the corner's zone; what follows leads over that point, or away from it."""
    beside = down(0.492, 0.0, 0.4)
    for behind, then in (([], []), ([move_l(14, "n", OVER)], [OVER]), ([move_l(14, "w", AWAY)], [AWAY])):
        found = said([P0, beside, STOP, *then], behind, **rows)
        assert set(found) & {"stop reached", "arc position"}, then
