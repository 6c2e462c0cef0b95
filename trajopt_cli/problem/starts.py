"""What only the start of a motion tells: paths that it leaves open, and speeds of 0 that it needs.

The reader refuses points that are too near each other where it knows all three; the start behind a move to joints is
known only here. Of `speeddata` a part may be 0 where nothing moves by it, as in vrot10 and vlin10.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from itertools import combinations
from math import degrees, dist, radians

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, axis_angle, inverse_pose
from trajopt_cli.motion import Move, MoveAbsJ, MoveC, MoveExtJ, MoveJ, PathMove, PoseMove
from trajopt_cli.path.circle import Point, circle_through
from trajopt_cli.path.of_motion import segment_of, turns_of
from trajopt_cli.path.turning import turned_back
from trajopt_cli.problem.plant import Plant
from trajopt_cli.units import MM

NEAR = 0.1 * MM  # m; a controller refuses circles with points nearer than this
_TURNS = radians(0.01)  # rad between the orientations at both ends; less is the rounding of quaternions
_MOVES = 1e-3 * MM  # m of rail


class Starts:
    """Where the robot stands along a program, for the motions that begin there."""

    def __init__(self, plant: Plant):
        self._free_speed = plant.free_speed
        self._robot, self._layout, self._rail_after = plant.robot, plant.layout, plant.rail_after
        self._rail = plant.start[plant.layout.rail]
        self._at: Array = plant.start  # all axes (k,), or the flange (4, 4): made only where a path asks
        self._carried = 0.0 * self._rail  # m that the rails have gone since, alone

    def wrong(self, motion: Move) -> Iterator[tuple[str, str, str]]:
        """Kind, demand and advice, in words, where a motion is an arc that no circle makes or needs a speed that is 0;
        then it is over."""
        before = self._rail
        self._rail = self._rail_after(motion.extax, before)
        if motion.duration is None and not (self._free_speed and isinstance(motion, MoveJ | MoveAbsJ)):
            yield from self._without_speed(motion, float(np.abs(self._rail - before).max(initial=0.0)))
        if isinstance(motion, MoveExtJ):
            self._carried += self._rail - before
            return
        if isinstance(motion, PathMove) and (found := self._unclear(motion)):
            yield "no circle", *found
        if isinstance(motion, MoveAbsJ):
            self._at = self._layout.merge(self._rail, motion.q)
        else:
            self._at = motion.X_WT @ inverse_pose(motion.tool.X_FT)
        self._carried = 0.0 * self._rail

    def _without_speed(self, motion: Move, way: float) -> Iterator[tuple[str, str, str]]:
        """What a motion moves at a speed of 0; way: the longest of the rails' [m]."""
        speed = motion.speed
        if speed.v_leax == 0 and way > _MOVES:
            what = f"moves the rail by {way / MM:.6g} mm at {speed.name}, whose v_leax is 0"
            yield "v_leax of 0", what, "give it a speed of linear external axes above 0, or leave the rail where it is"
        if speed.v_ori > 0 or isinstance(motion, MoveExtJ):
            return
        if (angle := self._turn(motion)) > _TURNS:
            what = f"turns the tool by {degrees(angle):.3g} deg at {speed.name}, whose v_ori is 0"
            yield "v_ori of 0", what, "give it a speed of reorientation above 0, or keep the orientation"

    def _turn(self, motion: PoseMove | MoveAbsJ) -> float:
        """How far a motion turns the tool [rad]."""
        X_WT = self._flange() @ motion.tool.X_FT
        if isinstance(motion, PathMove) and not motion.tool.stationary:
            with suppress(InputError):  # no circle, which is told as such
                return segment_of(motion, X_WT).angle
        if isinstance(motion, MoveAbsJ):
            there = self._robot.forward(self._layout.merge(self._rail, motion.q)) @ motion.tool.X_FT
        else:
            there = turned_back(turns_of(motion), motion.X_WT)
        return axis_angle(X_WT[:3, :3].T @ there[:3, :3])[1]

    def _unclear(self, motion: PathMove) -> tuple[str, str] | None:
        """What the program leaves open of a path."""
        X_WF = self._flange()
        if isinstance(motion, MoveC) and (found := _wrong(_points(motion, X_WF))):
            return found
        if motion.tool.stationary or motion.settings.circle.wrist_alone:  # refused as such
            return None
        return segment_of(motion, X_WF @ motion.tool.X_FT).unclear

    def _flange(self) -> Array:
        X_WF = np.array(self._at if self._at.ndim == 2 else self._robot.forward(self._at))
        X_WF[:3, 3] += self._robot.way(self._carried)
        return X_WF


def _points(motion: MoveC, X_WF: Array) -> dict[str, Point]:
    """The three points by name, where the circle is: in the world, on a table as it stands at the start, or on
    the work that is carried to the tool."""
    X_FT = motion.tool.X_FT
    poses = X_WF @ X_FT, motion.X_WV, motion.X_WT
    if turns := turns_of(motion):
        poses = poses[0], turned_back(turns, motion.X_WV), turned_back(turns, motion.X_WT)
    if motion.tool.stationary:
        poses = inverse_pose(X_WF) @ motion.X_WT, X_FT @ inverse_pose(motion.X_WV) @ motion.X_WT, X_FT
    return {
        name: (float(x), float(y), float(z))
        for name, (x, y, z) in zip(("start", "point on the way", "end"), (X[:3, 3] for X in poses), strict=True)
    }


def _wrong(points: dict[str, Point]) -> tuple[str, str] | None:
    for (one, p), (other, q) in combinations(points.items(), 2):
        if (apart := dist(p, q)) < NEAR:
            return (
                f"has no circle: {one} and {other} are {apart / MM:.3g} mm apart, least {NEAR / MM:g} mm",
                "move one of them, or use MoveL",
            )
    if circle_through(*points.values()) is None:
        places = ", ".join("[" + ", ".join(f"{x / MM:.3f}" for x in p) + "]" for p in points.values())
        return (
            f"has no circle: start, point on the way and end {places} mm lie on one line",
            "move the point on the way, or use MoveL",
        )
    return None
