"""Functions of frames, orientations and vectors. Angles in degrees, lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from trajopt_cli.geometry import wxyz_from_rotation
from trajopt_cli.path.circle import cross, minus
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import NUM, ORIENT, POS, POSE, ROBTARGET, Value
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.equipment import unoriented
from trajopt_cli.rapid.language.syntax import Call, Expression
from trajopt_cli.units import DEG


def _frame(run: Context, node: Expression) -> frames.Frame:
    pose = run.evaluate(node, POSE)
    p, q = pose.data
    if frames.norm(q) == 0:
        raise run.error(node, unoriented(run, node, pose))
    return p, frames.normalised(q)


def _pose_mult(run: Context, node: Call) -> Value:
    a, b = bind(run, node, ("Pose1", "Pose2")).required
    return Value(POSE, frames.compose(_frame(run, a), _frame(run, b)))


def _pose_inv(run: Context, node: Call) -> Value:
    (a,) = bind(run, node, ("Pose",)).required
    return Value(POSE, frames.inverse(_frame(run, a)))


def _pose_vect(run: Context, node: Call) -> Value:
    a, b = bind(run, node, ("Pose", "Pos")).required
    point: frames.Vector = run.evaluate(b, POS).data
    return Value(POS, frames.compose(_frame(run, a), (point, (1.0, 0.0, 0.0, 0.0)))[0])


def _orient_zyx(run: Context, node: Call) -> Value:
    z, y, x = (run.number(a) * DEG for a in bind(run, node, ("ZAngle", "YAngle", "XAngle")).required)
    return Value(ORIENT, frames.product(frames.product(frames.about(2, z), frames.about(1, y)), frames.about(0, x)))


def _n_orient(run: Context, node: Call) -> Value:
    (argument,) = bind(run, node, ("Rotation",)).required
    q: frames.Quaternion = run.evaluate(argument, ORIENT).data
    if frames.norm(q) == 0:
        raise run.error(argument, f"{run.text(argument)} is [0,0,0,0], which is not a rotation")
    return Value(ORIENT, frames.normalised(q))


def _euler_zyx(run: Context, node: Call) -> Value:
    args = bind(run, node, ("Rotation",), ("X", "Y", "Z"))
    if len(args.optional) != 1:
        raise run.error(node, "EulerZYX takes exactly one of \\X, \\Y, \\Z")
    q: frames.Quaternion = run.evaluate(args.required[0], ORIENT).data
    R = frames.matrix(frames.normalised(q)) if frames.norm(q) else None
    if R is None:
        raise run.error(args.required[0], "EulerZYX of [0,0,0,0], which is not a rotation")
    angles = {
        "x": math.atan2(R[2][1], R[2][2]),
        "y": math.atan2(-R[2][0], math.hypot(R[0][0], R[1][0])),
        "z": math.atan2(R[1][0], R[0][0]),
    }
    return Value(NUM, angles[next(iter(args.optional))] / DEG)


# ------------------------------------------------------------------------------------------- frames from points


def _three_points(run: Context, nodes: Sequence[Expression], origin: int, call: Call) -> frames.Frame:
    """The frame whose x axis points from the first to the second point and whose xy plane holds the third.

    origin: 1 in the first point, 2 in the second, 3 on the line through both, opposite the third.
    """
    points: list[frames.Vector] = [run.evaluate(node, ROBTARGET).data[0] for node in nodes]
    first, second, third = points
    x = _unit(minus(second, first))
    across = minus(third, first)
    z = None if x is None else _unit(cross(x, across))
    if x is None or z is None:
        names = ", ".join(run.text(node) for node in nodes)
        raise run.fault(call, "ERR_FRAME", f"{call.name}: the points {names} lie on one line, so they give no frame")
    y = cross(z, x)
    along = sum(a * b for a, b in zip(across, x, strict=True))
    start = {
        1: first,
        2: second,
        3: (first[0] + along * x[0], first[1] + along * x[1], first[2] + along * x[2]),
    }
    if origin not in start:
        raise run.error(call, f"\\Origin:={origin} of {call.name} must be 1, 2 or 3")
    R = np.array([x, y, z]).T
    w, i, j, k = (float(part) for part in wxyz_from_rotation(R))
    return start[origin], (w, i, j, k)


def _unit(v: frames.Vector) -> frames.Vector | None:
    """v at length 1, None where it has no direction to speak of."""
    length = frames.length(v)
    return None if length < _NO_LENGTH else (v[0] / length, v[1] / length, v[2] / length)


_NO_LENGTH = 1e-3  # mm: nobody teaches a frame by points that close


def _def_frame(run: Context, node: Call) -> Value:
    """Where a work object lies, by three points on it."""
    args = bind(run, node, ("NewP1", "NewP2", "NewP3"), ("Origin",))
    chosen = args.value("origin")
    origin = run.integer(chosen, "\\Origin") if chosen is not None else 1
    return Value(POSE, _three_points(run, args.required, origin, node))


def _def_d_frame(run: Context, node: Call) -> Value:
    """The displacement that brings three points from where they were to where they are."""
    points = bind(run, node, ("OldP1", "OldP2", "OldP3", "NewP1", "NewP2", "NewP3")).required
    old, new = (_three_points(run, part, 1, node) for part in (points[:3], points[3:]))
    return Value(POSE, frames.compose(new, frames.inverse(old)))


def _pos(run: Context, node: Expression) -> frames.Vector:
    x, y, z = run.evaluate(node, POS).data
    return x, y, z


def _distance(run: Context, node: Call) -> Value:
    a, b = (_pos(run, argument) for argument in bind(run, node, ("Point1", "Point2")).required)
    return Value(NUM, math.dist(a, b))


def _dot_prod(run: Context, node: Call) -> Value:
    a, b = (_pos(run, argument) for argument in bind(run, node, ("Vector1", "Vector2")).required)
    return Value(NUM, a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


def _vect_magn(run: Context, node: Call) -> Value:
    (a,) = bind(run, node, ("Vector",)).required
    return Value(NUM, frames.length(_pos(run, a)))


FUNCTIONS: dict[str, Function] = {
    "PoseMult": _pose_mult,
    "PoseInv": _pose_inv,
    "PoseVect": _pose_vect,
    "OrientZYX": _orient_zyx,
    "EulerZYX": _euler_zyx,
    "NOrient": _n_orient,
    "DefFrame": _def_frame,
    "DefDFrame": _def_d_frame,
    "Distance": _distance,
    "DotProd": _dot_prod,
    "VectMagn": _vect_magn,
}
