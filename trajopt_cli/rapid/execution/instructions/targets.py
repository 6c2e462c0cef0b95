r"""Functions of frames and of targets, and those that ask where the robot is. Angles in degrees, lengths in mm.

CRobT, CPos and CalcRobT give targets in the work object, the active program displacement and offsets of external axes
taken out, so that a move to one of them changes nothing; CJointT, CalcJointT and the argument of CalcRobT are plain
axis positions, offsets included (a MoveAbsJ to one of them under an active offset needs \NoEOffs).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from math import degrees

import numpy as np

from trajopt_cli.geometry import Array, wxyz_from_rotation
from trajopt_cli.motion import ConfData, ExternalAxes
from trajopt_cli.path.circle import cross, minus
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import (
    JOINTTARGET,
    NUM,
    ORIENT,
    POS,
    POSE,
    ROBTARGET,
    TOOLDATA,
    WOBJDATA,
    Data,
    Value,
)
from trajopt_cli.rapid.data.frames import IDENTITY, Frame, Quaternion, Vector, frame
from trajopt_cli.rapid.data.scope import Fault
from trajopt_cli.rapid.execution.arguments import Refused, Topic
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.current_position import (
    current_conf,
    current_joints,
    current_target,
    reach,
    read_at_rest,
    the_robot,
)
from trajopt_cli.rapid.execution.equipment import current_setup, orientation, setup_of, unoriented
from trajopt_cli.rapid.execution.instructions.moves import check_joints, external, robtarget
from trajopt_cli.rapid.execution.positioners import kept_axes
from trajopt_cli.rapid.language.syntax import Call, Expression
from trajopt_cli.units import DEG

_NO_LENGTH = 1e-3  # mm: nobody teaches a frame by points that close


def _frame(run: Context, node: Expression) -> Frame:
    pose = run.evaluate(node, POSE)
    p, q = pose.data
    if frames.norm(q) == 0:
        raise run.error(node, unoriented(run, node, pose))
    return p, frames.normalised(q)


_POSES = Topic("Functions of frames, orientations and vectors. Angles in degrees, lengths in mm", frame=_frame)
_POSES.values("PoseMult Pose1:frame Pose2:frame", POSE)(frames.compose)
_POSES.values("PoseInv Pose:frame", POSE)(frames.inverse)
_POSES.values("PoseVect Pose:frame Pos:pos", POS)(lambda a, p: frames.compose(a, (p, (1.0, 0.0, 0.0, 0.0)))[0])
_POSES.values("Distance Point1:pos Point2:pos", NUM)(math.dist)
_POSES.values("DotProd Vector1:pos Vector2:pos", NUM)(lambda a, b: a[0] * b[0] + a[1] * b[1] + a[2] * b[2])
_POSES.values("VectMagn Vector:pos", NUM)(frames.length)


@_POSES.values("OrientZYX ZAngle:num YAngle:num XAngle:num", ORIENT)
def _orient_zyx(z: float, y: float, x: float) -> Quaternion:
    turned = frames.product(frames.about(2, z * DEG), frames.about(1, y * DEG))
    return frames.product(turned, frames.about(0, x * DEG))


@_POSES.function("NOrient Rotation")
def _n_orient(run: Context, node: Call, argument: Expression) -> Value:
    q: Quaternion = run.evaluate(argument, ORIENT).data
    if frames.norm(q) == 0:
        raise Refused(f"{run.text(argument)} is [0,0,0,0], which is not a rotation", "Rotation")
    return Value(ORIENT, frames.normalised(q))


@_POSES.values(r"EulerZYX Rotation:orient \X \Y \Z", NUM)
def _euler_zyx(q: Quaternion, **axes: bool) -> float:
    if len(axes) != 1:
        raise Refused("EulerZYX takes exactly one of \\X, \\Y, \\Z")
    if frames.norm(q) == 0:
        raise Refused("EulerZYX of [0,0,0,0], which is not a rotation", "Rotation")
    R = frames.matrix(((0.0, 0.0, 0.0), frames.normalised(q)))
    angles = {
        "x": math.atan2(R[2, 1], R[2, 2]),
        "y": math.atan2(-R[2, 0], math.hypot(R[0, 0], R[1, 0])),
        "z": math.atan2(R[1, 0], R[0, 0]),
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
    start = {1: first, 2: second, 3: (first[0] + along * x[0], first[1] + along * x[1], first[2] + along * x[2])}
    if origin not in start:
        raise Refused(f"\\Origin:={origin} of {call.name} must be 1, 2 or 3")
    w, i, j, k = (float(part) for part in wxyz_from_rotation(np.array([x, cross(z, x), z]).T))
    return start[origin], (w, i, j, k)


def _unit(v: Vector) -> Vector | None:
    """v at length 1, None where it has no direction to speak of."""
    length = frames.length(v)
    return None if length < _NO_LENGTH else (v[0] / length, v[1] / length, v[2] / length)


@_POSES.function(r"DefFrame NewP1 NewP2 NewP3 \Origin:int")
def _def_frame(run: Context, node: Call, *points: Expression, origin: int = 1) -> Value:
    """Where a work object lies, by three points on it."""
    return Value(POSE, _three_points(run, points, origin, node))


@_POSES.function("DefDFrame OldP1 OldP2 OldP3 NewP1 NewP2 NewP3")
def _def_d_frame(run: Context, node: Call, *points: Expression) -> Value:
    """The displacement that brings three points from where they were to where they are."""
    old, new = (_three_points(run, part, 1, node) for part in (points[:3], points[3:]))
    return Value(POSE, frames.compose(new, frames.inverse(old)))


_NOWHERE = 9e9  # what RAPID writes for an axis without a position
_TARGETS = Topic("Functions that compute targets, and those that ask where the robot is")


@_TARGETS.values("Offs Point:robtarget XOffset:num YOffset:num ZOffset:num", ROBTARGET)
def _offs(target: Data, dx: float, dy: float, dz: float) -> Data:
    """The target shifted along the axes of the work object; orientation, configuration, external axes kept."""
    (x, y, z), *rest = target
    return (x + dx, y + dy, z + dz), *rest


@_TARGETS.function(r"RelTool Point Dx:num Dy:num Dz:num \Rx:num \Ry:num \Rz:num")
def _rel_tool(run: Context, node: Call, point: Expression, dx: float, dy: float, dz: float, **turns: float) -> Value:
    """The target shifted along its own tool axes, then turned about the new x, the new y and the new z."""
    target = run.evaluate(point, ROBTARGET)
    p, q, *rest = target.data
    if frames.norm(q) == 0:
        raise Refused(unoriented(run, point, target), "Point")
    moved = frames.compose((p, frames.normalised(q)), ((dx, dy, dz), (1.0, 0.0, 0.0, 0.0)))[0]
    for axis, name in enumerate(("rx", "ry", "rz")):
        if name in turns:
            q = frames.product(q, frames.about(axis, turns[name] * DEG))
    return Value(ROBTARGET, (moved, q, *rest))


@_TARGETS.function(r"MirPos Point MirPlane \WObj:expr \MirY")
def _mir_pos(
    run: Context, node: Call, point: Expression, mirror: Expression, wobj: Expression | None = None, miry: bool = False
) -> Value:
    r"""MirPos(Point, MirPlane [\WObj] [\MirY]): mirrored in the xy plane of the object frame of MirPlane.

    The tool's x and z are mirrored, or y and z with \MirY; the third follows, for a mirrored frame is no rotation.
    """
    target, plane = robtarget(run, point), _object(run, mirror)
    base = _object(run, wobj) if wobj is not None else IDENTITY
    into = frames.compose(frames.inverse(plane), base)  # the target's frame seen from the plane
    (x, y, z), q = frames.compose(into, target.frame)
    # Mirror at z = 0 and reverse the tool's third axis: diag(1,1,-1) R diag(1,-1,1) = Rz(180) R Ry(180), for \MirY Rx.
    third = (0.0, 1.0, 0.0, 0.0) if miry else (0.0, 0.0, 1.0, 0.0)
    mirrored = frames.product(frames.product((0.0, 0.0, 0.0, 1.0), q), third)
    image = frames.compose(frames.inverse(into), ((x, y, -z), mirrored))
    return Value(ROBTARGET, (*image, *target.value.data[2:]))


def _object(run: Context, node: Expression) -> frames.Frame:
    """U O of a work object, without the program displacement."""
    data = run.evaluate(node, WOBJDATA).data
    _, _, _, (up, uq), (op, oq) = data
    name, written = run.text(node), data != WOBJDATA.default
    user = (up, orientation(run, uq, f"uframe of {name}", node, run.file, written))
    return frames.compose(user, (op, orientation(run, oq, f"oframe of {name}", node, run.file, written)))


@_TARGETS.function(r"ORobT OrgPoint \InPDisp \InEOffs")
def _o_rob_t(run: Context, node: Call, point: Expression, **without: bool) -> Value:
    r"""ORobT(OrgPoint [\InPDisp] | [\InEOffs]): the target without program displacement and offsets."""
    target = robtarget(run, point)
    place, extax = target.frame, target.value.data[3]
    displacement = run.position.displacement
    if displacement is not None and "inpdisp" not in without:
        place = frames.compose(displacement, place)
    if "ineoffs" not in without:
        extax = _axes(external(run, extax))
    return Value(ROBTARGET, (*place, target.value.data[2], extax))


# ------------------------------------------------------------------------------------------------ where the robot is


def _current(run: Context, node: Call, options: dict[str, Expression]) -> frames.Frame:
    setup = current_setup(run, node, run.position.setup, options.get("tool"), options.get("wobj"))
    return current_target(run, node, node.name, setup)


def _rob_target(place: frames.Frame, conf: ConfData, extax: Data) -> Value:
    return Value(ROBTARGET, (*place, tuple(float(part) for part in (conf.cf1, conf.cf4, conf.cf6, conf.cfx)), extax))


def _axes(extax: ExternalAxes) -> Data:
    return tuple(_NOWHERE if value is None else value for value in extax)


def _without_offsets(run: Context, extax: ExternalAxes) -> Data:
    offsets = run.settings.eax_offset
    return tuple(_NOWHERE if v is None else v - more for v, more in zip(extax, offsets, strict=True))


@_TARGETS.function(r"CRobT \TaskRef \TaskName \Tool:expr \WObj:expr")
def _c_rob_t(run: Context, node: Call, **options: Expression) -> Value:
    r"""CRobT([\Tool] [\WObj]): where the robot is, as a target."""
    read_at_rest(run, node, "CRobT reads where the robot is")
    place = _current(run, node, options)
    extax = _without_offsets(run, run.units.driven(run.position.extax))
    return _rob_target(place, current_conf(run, node, node.name), extax)


@_TARGETS.function(r"CPos \TaskRef \TaskName \Tool:expr \WObj:expr")
def _c_pos(run: Context, node: Call, **options: Expression) -> Value:
    r"""CPos([\Tool] [\WObj])."""
    read_at_rest(run, node, "CPos reads where the robot is")
    return Value(POS, _current(run, node, options)[0])


@_TARGETS.function(r"CJointT \TaskRef \TaskName")
def _c_joint_t(run: Context, node: Call, **_: Expression) -> Value:
    """CJointT(): joints and external axes as they are, offsets included."""
    read_at_rest(run, node, "CJointT reads where the robot is")
    q = current_joints(run, node, node.name)
    return _joint_target(q, run.units.driven(run.position.extax))


def _joint_target(q: Array, extax: ExternalAxes) -> Value:
    return Value(JOINTTARGET, (tuple(degrees(float(value)) for value in q), _axes(extax)))


@_TARGETS.function(r"CalcRobT Joint_target Tool \WObj:expr")
def _calc_rob_t(
    run: Context, node: Call, joints: Expression, tool: Expression, wobj: Expression | None = None
) -> Value:
    r"""CalcRobT(JointTarget, Tool [\WObj])."""
    robax, axes = run.evaluate(joints, JOINTTARGET).data
    setup = setup_of(run, tool, wobj)
    check_joints(run, joints, robax)
    robot = the_robot(run, node, node.name)
    q, extax = np.array(robax) * DEG, external(run, axes, offset=False)
    place = setup.target(frame(robot.forward(q, kept_axes(run, extax))))
    return _rob_target(place, robot.confdata(q), _without_offsets(run, extax))


@_TARGETS.function(r"CalcJointT Rob_target Tool \UseCurWObjPos \WObj:expr \ErrorNumber:expr")
def _calc_joint_t(run: Context, node: Call, point: Expression, tool: Expression, **options: Expression) -> Value:
    r"""CalcJointT(RobTarget, Tool [\WObj] [\ErrorNumber]). Raises Fault ERR_ROBLIMIT for a target out of reach."""
    target = robtarget(run, point)
    setup = setup_of(run, tool, options.get("wobj"))
    robot = the_robot(run, node, node.name)
    extax, number_of_error = target.extax, options.get("errornumber")
    flange = setup.flange(target.frame)
    what = f"{run.text(point)} in {node.name}"
    try:
        q = reach(run, node, what, robot, flange, target.conf, True, kept_axes(run, extax), run.position.near())
    except Fault as fault:
        if number_of_error is None:
            raise
        run.assign(number_of_error, Value(NUM, fault.number))
        return Value(JOINTTARGET, JOINTTARGET.default)
    if number_of_error is not None:
        run.assign(number_of_error, Value(NUM, 0.0))
    return _joint_target(q, extax)


@_TARGETS.function(r"CTool \TaskRef \TaskName", r"CWObj \TaskRef \TaskName")
def _c_tool(run: Context, node: Call, **_: Expression) -> Value:
    """CTool(), CWObj(): the tool and the work object of the last move."""
    setup = run.position.setup
    return Value(TOOLDATA, setup.tool_data) if node.name.lower() == "ctool" else Value(WOBJDATA, setup.wobj_data)
