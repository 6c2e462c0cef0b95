"""Functions of frames, orientations and vectors. Angles in degrees, lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from trajopt_cli.geometry import wxyz_from_rotation
from trajopt_cli.path.circle import cross, minus
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import NUM, ORIENT, POS, POSE, ROBTARGET, Value
from trajopt_cli.rapid.data.frames import Frame, Quaternion, Vector
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.equipment import unoriented
from trajopt_cli.rapid.execution.registry import Refused, Topic
from trajopt_cli.rapid.language.syntax import Call, Expression
from trajopt_cli.units import DEG

_NO_LENGTH = 1e-3  # mm: nobody teaches a frame by points that close


def _frame(run: Context, node: Expression) -> Frame:
    pose = run.evaluate(node, POSE)
    p, q = pose.data
    if frames.norm(q) == 0:
        raise run.error(node, unoriented(run, node, pose))
    return p, frames.normalised(q)


_TOPIC = Topic(__doc__, frame=_frame)
_TOPIC.values("PoseMult Pose1:frame Pose2:frame", POSE)(frames.compose)
_TOPIC.values("PoseInv Pose:frame", POSE)(frames.inverse)
_TOPIC.values("PoseVect Pose:frame Pos:pos", POS)(lambda a, p: frames.compose(a, (p, (1.0, 0.0, 0.0, 0.0)))[0])
_TOPIC.values("Distance Point1:pos Point2:pos", NUM)(math.dist)
_TOPIC.values("DotProd Vector1:pos Vector2:pos", NUM)(lambda a, b: a[0] * b[0] + a[1] * b[1] + a[2] * b[2])
_TOPIC.values("VectMagn Vector:pos", NUM)(frames.length)


@_TOPIC.values("OrientZYX ZAngle:num YAngle:num XAngle:num", ORIENT)
def _orient_zyx(z: float, y: float, x: float) -> Quaternion:
    turned = frames.product(frames.about(2, z * DEG), frames.about(1, y * DEG))
    return frames.product(turned, frames.about(0, x * DEG))


@_TOPIC.function("NOrient Rotation")
def _n_orient(run: Context, node: Call, argument: Expression) -> Value:
    q: Quaternion = run.evaluate(argument, ORIENT).data
    if frames.norm(q) == 0:
        raise Refused(f"{run.text(argument)} is [0,0,0,0], which is not a rotation", "Rotation")
    return Value(ORIENT, frames.normalised(q))


@_TOPIC.values(r"EulerZYX Rotation:orient \X \Y \Z", NUM)
def _euler_zyx(q: Quaternion, **axes: bool) -> float:
    if len(axes) != 1:
        raise Refused("EulerZYX takes exactly one of \\X, \\Y, \\Z")
    if frames.norm(q) == 0:
        raise Refused("EulerZYX of [0,0,0,0], which is not a rotation", "Rotation")
    R = frames.matrix(frames.normalised(q))
    angles = {
        "x": math.atan2(R[2][1], R[2][2]),
        "y": math.atan2(-R[2][0], math.hypot(R[0][0], R[1][0])),
        "z": math.atan2(R[1][0], R[0][0]),
    }
    return angles[next(iter(axes))] / DEG


# ------------------------------------------------------------------------------------------- frames from points


def _three_points(run: Context, nodes: Sequence[Expression], origin: int, call: Call) -> Frame:
    """The frame whose x axis points from the first to the second point and whose xy plane holds the third.

    origin: 1 in the first point, 2 in the second, 3 on the line through both, opposite the third.
    """
    points: list[Vector] = [run.evaluate(node, ROBTARGET).data[0] for node in nodes]
    first, second, third = points
    x = _unit(minus(second, first))
    across = minus(third, first)
    z = None if x is None else _unit(cross(x, across))
    if x is None or z is None:
        names = ", ".join(run.text(node) for node in nodes)
        raise Refused(f"{call.name}: the points {names} lie on one line, so they give no frame", error="ERR_FRAME")
    along = sum(a * b for a, b in zip(across, x, strict=True))
    start = {
        1: first,
        2: second,
        3: (first[0] + along * x[0], first[1] + along * x[1], first[2] + along * x[2]),
    }
    if origin not in start:
        raise Refused(f"\\Origin:={origin} of {call.name} must be 1, 2 or 3")
    w, i, j, k = (float(part) for part in wxyz_from_rotation(np.array([x, cross(z, x), z]).T))
    return start[origin], (w, i, j, k)


def _unit(v: Vector) -> Vector | None:
    """v at length 1, None where it has no direction to speak of."""
    length = frames.length(v)
    return None if length < _NO_LENGTH else (v[0] / length, v[1] / length, v[2] / length)


@_TOPIC.function(r"DefFrame NewP1 NewP2 NewP3 \Origin:int")
def _def_frame(run: Context, node: Call, *points: Expression, origin: int = 1) -> Value:
    """Where a work object lies, by three points on it."""
    return Value(POSE, _three_points(run, points, origin, node))


@_TOPIC.function("DefDFrame OldP1 OldP2 OldP3 NewP1 NewP2 NewP3")
def _def_d_frame(run: Context, node: Call, *points: Expression) -> Value:
    """The displacement that brings three points from where they were to where they are."""
    old, new = (_three_points(run, part, 1, node) for part in (points[:3], points[3:]))
    return Value(POSE, frames.compose(new, frames.inverse(old)))
