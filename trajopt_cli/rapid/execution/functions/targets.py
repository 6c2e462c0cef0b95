r"""Functions that compute targets, and those that ask where the robot is.

CRobT, CPos and CalcRobT give targets in the work object, the active program displacement and offsets of external axes
taken out, so that a move to one of them changes nothing; CJointT, CalcJointT and the argument of CalcRobT are plain
axis positions, offsets included (a MoveAbsJ to one of them under an active offset needs \NoEOffs).
"""

from __future__ import annotations

from math import degrees

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import ConfData, ExternalAxes
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import (
    JOINTTARGET,
    NUM,
    POS,
    ROBTARGET,
    TOOLDATA,
    WOBJDATA,
    Data,
    Value,
)
from trajopt_cli.rapid.data.errors import Fault
from trajopt_cli.rapid.data.frames import IDENTITY
from trajopt_cli.rapid.data.poses import frame
from trajopt_cli.rapid.execution.arguments import Arguments, Function, bind
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
from trajopt_cli.rapid.execution.instructions.moves import NO_POSITION, external, robtarget
from trajopt_cli.rapid.execution.position import Setup
from trajopt_cli.rapid.execution.positioners import kept_axes
from trajopt_cli.rapid.language.syntax import Call, Expression
from trajopt_cli.units import DEG

_NOWHERE = 9e9  # what RAPID writes for an axis without a position
_CURRENT = ("TaskRef", "TaskName", "Tool", "WObj")


def _offs(run: Context, node: Call) -> Value:
    """The target shifted along the axes of the work object; orientation, configuration, external axes kept."""
    point, *shifts = bind(run, node, ("Point", "XOffset", "YOffset", "ZOffset")).required
    (x, y, z), *rest = run.evaluate(point, ROBTARGET).data
    dx, dy, dz = (run.number(shift) for shift in shifts)
    return Value(ROBTARGET, ((x + dx, y + dy, z + dz), *rest))


def _rel_tool(run: Context, node: Call) -> Value:
    """The target shifted along its own tool axes, then turned about the new x, the new y and the new z."""
    args = bind(run, node, ("Point", "Dx", "Dy", "Dz"), ("Rx", "Ry", "Rz"))
    point, *shifts = args.required
    target = run.evaluate(point, ROBTARGET)
    p, q, *rest = target.data
    if frames.norm(q) == 0:
        raise run.error(point, unoriented(run, point, target))
    dx, dy, dz = (run.number(shift) for shift in shifts)
    moved = frames.compose((p, frames.normalised(q)), ((dx, dy, dz), (1.0, 0.0, 0.0, 0.0)))[0]
    for axis, name in enumerate(("rx", "ry", "rz")):
        turn = args.value(name)
        if turn is not None:
            q = frames.product(q, frames.about(axis, run.number(turn) * DEG))
    return Value(ROBTARGET, (moved, q, *rest))


def _mir_pos(run: Context, node: Call) -> Value:
    r"""MirPos(Point, MirPlane [\WObj] [\MirY]): mirrored in the xy plane of the object frame of MirPlane.

    The tool's x and z are mirrored, or y and z with \MirY; the third follows, for a mirrored frame is no rotation.
    """
    args = bind(run, node, ("Point", "MirPlane"), ("WObj", "MirY"))
    target = robtarget(run, args.required[0])
    plane = _object(run, args.required[1])
    wobj = args.value("wobj")
    base = _object(run, wobj) if wobj is not None else IDENTITY
    into = frames.compose(frames.inverse(plane), base)  # the target's frame seen from the plane
    (x, y, z), q = frames.compose(into, target.frame)
    # Mirror at z = 0 and reverse the tool's third axis: diag(1,1,-1) R diag(1,-1,1) = Rz(180) R Ry(180), for \MirY Rx.
    third = (0.0, 1.0, 0.0, 0.0) if "miry" in args.optional else (0.0, 0.0, 1.0, 0.0)
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


def _o_rob_t(run: Context, node: Call) -> Value:
    r"""ORobT(OrgPoint [\InPDisp] | [\InEOffs]): the target without program displacement and offsets."""
    args = bind(run, node, ("OrgPoint",), ("InPDisp", "InEOffs"))
    target = robtarget(run, args.required[0])
    place, extax = target.frame, target.value.data[3]
    displacement = run.position.displacement
    if displacement is not None and "inpdisp" not in args.optional:
        place = frames.compose(displacement, place)
    if "ineoffs" not in args.optional:
        extax = _axes(external(run, extax))
    return Value(ROBTARGET, (*place, target.value.data[2], extax))


# ------------------------------------------------------------------------------------------------ where the robot is


def _current(run: Context, node: Call, args: Arguments) -> Setup:
    position = run.position
    return current_setup(run, node, position.setup, args.value("tool"), args.value("wobj"))


def _rob_target(place: frames.Frame, conf: ConfData, extax: Data) -> Value:
    return Value(ROBTARGET, (*place, tuple(float(part) for part in (conf.cf1, conf.cf4, conf.cf6, conf.cfx)), extax))


def _axes(extax: ExternalAxes) -> Data:
    return tuple(_NOWHERE if value is None else value for value in extax)


def _without_offsets(run: Context, extax: ExternalAxes) -> Data:
    offsets = run.settings.eax_offset
    return tuple(_NOWHERE if v is None else v - more for v, more in zip(extax, offsets, strict=True))


def _c_rob_t(run: Context, node: Call) -> Value:
    r"""CRobT([\Tool] [\WObj]): where the robot is, as a target."""
    args = bind(run, node, (), _CURRENT)
    position = run.position
    read_at_rest(run, node, "CRobT reads where the robot is")
    place = current_target(run, node, node.name, _current(run, node, args))
    extax = _without_offsets(run, run.units.driven(position.extax))
    return _rob_target(place, current_conf(run, node, node.name), extax)


def _c_pos(run: Context, node: Call) -> Value:
    r"""CPos([\Tool] [\WObj])."""
    args = bind(run, node, (), _CURRENT)
    read_at_rest(run, node, "CPos reads where the robot is")
    return Value(POS, current_target(run, node, node.name, _current(run, node, args))[0])


def _c_joint_t(run: Context, node: Call) -> Value:
    """CJointT(): joints and external axes as they are, offsets included."""
    bind(run, node, (), ("TaskRef", "TaskName"))
    read_at_rest(run, node, "CJointT reads where the robot is")
    q = current_joints(run, node, node.name)
    return _joint_target(q, run.units.driven(run.position.extax))


def _joint_target(q: Array, extax: ExternalAxes) -> Value:
    return Value(JOINTTARGET, (tuple(degrees(float(value)) for value in q), _axes(extax)))


def _calc_rob_t(run: Context, node: Call) -> Value:
    r"""CalcRobT(JointTarget, Tool [\WObj])."""
    args = bind(run, node, ("Joint_target", "Tool"), ("WObj",))
    joints, tool = args.required
    robax, axes = run.evaluate(joints, JOINTTARGET).data
    setup = setup_of(run, tool, args.value("wobj"))
    for axis, value in enumerate(robax, 1):
        if abs(value) > NO_POSITION:
            raise run.error(joints, f"jointtarget {run.text(joints)} gives no position for axis {axis} (9E9)")
    robot = the_robot(run, node, node.name)
    q, extax = np.array(robax) * DEG, external(run, axes, offset=False)
    place = setup.target(frame(robot.forward(q, kept_axes(run, extax))))
    return _rob_target(place, robot.confdata(q), _without_offsets(run, extax))


def _calc_joint_t(run: Context, node: Call) -> Value:
    r"""CalcJointT(RobTarget, Tool [\WObj] [\ErrorNumber]). Raises Fault ERR_ROBLIMIT for a target out of reach."""
    args = bind(run, node, ("Rob_target", "Tool"), ("UseCurWObjPos", "WObj", "ErrorNumber"))
    point, tool = args.required
    target = robtarget(run, point)
    setup = setup_of(run, tool, args.value("wobj"))
    robot = the_robot(run, node, node.name)
    extax, number_of_error = target.extax, args.value("errornumber")
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


def _c_tool(run: Context, node: Call) -> Value:
    """CTool(): the tool of the last move."""
    bind(run, node, (), ("TaskRef", "TaskName"))
    return Value(TOOLDATA, run.position.setup.tool_data)


def _c_wobj(run: Context, node: Call) -> Value:
    """CWObj(): the work object of the last move."""
    bind(run, node, (), ("TaskRef", "TaskName"))
    return Value(WOBJDATA, run.position.setup.wobj_data)


FUNCTIONS: dict[str, Function] = {
    "Offs": _offs,
    "RelTool": _rel_tool,
    "MirPos": _mir_pos,
    "ORobT": _o_rob_t,
    "CRobT": _c_rob_t,
    "CPos": _c_pos,
    "CJointT": _c_joint_t,
    "CalcRobT": _calc_rob_t,
    "CalcJointT": _calc_joint_t,
    "CTool": _c_tool,
    "CWObj": _c_wobj,
}
