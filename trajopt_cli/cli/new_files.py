"""The texts that `trajopt new` writes. Places come from the robot's kinematics, so that every robot reaches them."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array, wxyz_from_rotation
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.parallel_arm import ParallelArm
from trajopt_cli.units import MM

# Canonical angles of robot.arm [deg], which of ABB's robots are the joints:
_HOME = (0, 0, 0, 0, 30, 0)
_OVER = (0, 20, 20, 0, 50, 0)  # the tool points straight down, well inside the reach
# and those of an arm with three parallel axes:
_PARALLEL_HOME = (0, 0, 0, 90, -90, 0)
_PARALLEL_OVER = (0, 20, 20, 50, -90, 0)
_TURNS = (10, 60)  # of joint 1 at the two places of a robot that stands still
_RIDE = 800  # mm of rail between the two places

_MODULE = """\
MODULE {name}
    ! Made by 'trajopt new'. It runs as it is: trajopt optimize {name}.mod
    ! The cell around it (robot, rail, limits, start) is in {name}.yaml.
    !
    ! A part is taken at one place and put down at another. Replace the places by your own.

    ! Where the cycle begins and ends: the six joints in degrees{rail_home}.
    CONST jointtarget j_home:=[[{home}],[{eax_home},9E9,9E9,9E9,9E9,9E9]];

    ! A place is: x, y, z of the tool in mm; its orientation as a quaternion (here it points straight down);
    ! the arm's configuration (which way shoulder, elbow and wrist are bent); the external axes{rail_place}.
    CONST robtarget p_take:=[[{take}],[{take_q}],[{take_conf}],[{eax_take},9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_put:=[[{put}],[{put_q}],[{put_conf}],[{eax_put},9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        ! MoveJ lets every joint run freely; MoveL draws a straight line. v1000: 1000 mm/s at most.
        ! fine: the tool stops there. A zone like z20 would pass the point in a curve instead.
        MoveJ Offs(p_take,0,0,80), v1000, fine, tool0;
        MoveL p_take, v300, fine, tool0;
        WaitTime 0.3; ! the gripper closes
        MoveL Offs(p_take,0,0,80), v300, fine, tool0;

        MoveJ Offs(p_put,0,0,80), v1000, fine, tool0;
        MoveL p_put, v300, fine, tool0;
        WaitTime 0.3; ! the gripper opens
        MoveL Offs(p_put,0,0,80), v300, fine, tool0;

        MoveAbsJ j_home, v1000, fine, tool0;
    ENDPROC
ENDMODULE
"""

_CELL = """\
# The cell of {name}.mod. Numbers are SI (m, rad, s); a text may carry a unit: "30 deg", "800 mm", "1.5 m/s".

robot: {robot}  # 'trajopt robot show {robot}' tells its limits and their sources
profile: default  # acceleration limits; robots publish none, so these are estimates and say so

{rail}start:  # where the cycle begins, at rest
  joints: "[{home}] deg"
{start_rail}
# What else can be said; take the '#' away and adapt it.
#
# Measured limits instead of the estimates, each with its source:
# limits:
#   joint_1: {{acceleration: 12.5, source: "measured on our cell"}}
#
# What stands around the robot; plans that touch it are refused:
# obstacles:
#   table: {{box: {{size: [1, 1, 0.1], position: [0.6, 0, -0.05]}}}}
#
# What inputs say, where the program asks for them:
# signals:
#   di_part_ready: 1
"""

_RAIL = """\
rail:
  eax: a  # the external axis that drives the rail: the first number after the configuration
  stroke: [-0.2, {end}]  # m from end to end
# waits: {{rail: free}}  # lets the rail move while the tool waits; without it it holds, for a gripper may work then

"""

_TASK = """\
# Made by 'trajopt new'. It runs as it is: trajopt iiwa segments {name}.yaml
# A square of 20 cm in front of a KUKA LBR iiwa 7, for its compliant controller.
# Numbers are SI (m, rad, s, N); a text may carry a unit: "30 deg", "400 mm/s".
robot: {robot}
start: {{joints: "[0, 30, 0, -100, 0, 50, 0] deg"}}  # where the controller is switched on
h: 1 ms  # how often it is fed

profile: trapezoid  # how speed begins and ends: thesis (at once), trapezoid (ramps), s-curve (limited jerk)
rotation: tait-bryan  # how orientations are interpolated: tait-bryan or slerp
angles: relative  # counted from the tool's orientation at the start; or absolute
v_max: 0.2 m/s
omega_max: 1 rad/s
a_max: 1 m/s2
epsilon_max: 5 rad/s2

# Poses are [x, y, z, alpha, beta, gamma] of the tool; 'by' is added to the pose before.
poses:
  - {{name: start, at: start}}
  - {{name: a, by: [-0.05, -0.1, 0, 0, 0, 0]}}
  - {{name: b, by: [0.2, 0, 0, 0, 0, 0]}}
  - {{name: c, by: [0, 0.2, 0, 0, 0, 0]}}
  - {{name: d, by: [-0.2, 0, 0, 0, 0, 0]}}
  - {{name: a, by: [0, -0.2, 0, 0, 0, 0]}}

# The controller: stiffness [N/m, Nm/rad], damping [N s/m, N m s/rad], inertia [kg, kg m2] of x, y, z and the angles.
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""


def task(name: str, robot: str) -> str:
    """A task file for `trajopt iiwa`."""
    return _TASK.format(name=name, robot=robot)


def program_and_cell(name: str, robot: RobotModel, said: str | None = None) -> tuple[str, str]:
    """A RAPID module and its cell file; on a rail if the robot has one. said: the robot in the cell file, its name for
    None."""
    on_rail = robot.has_rail
    turns = (0, 0) if on_rail else _TURNS
    rides = (0, _RIDE) if on_rail else (None, None)
    fields: dict[str, str] = {}
    home = _joints(robot, _PARALLEL_HOME if isinstance(robot.arm, ParallelArm) else _HOME)
    for place, turn, ride in zip(("take", "put"), turns, rides, strict=True):
        X, q = _pointing_down(robot, turn, ride)
        conf = [*(int(q[joint] // 90) for joint in (0, 3, 5)), robot.confdata(np.radians(q)).cfx]
        fields |= {
            place: _figures(X[:3, 3] / MM, 1),
            f"{place}_q": _figures(wxyz_from_rotation(X[:3, :3]), 7),
            f"{place}_conf": ",".join(map(str, conf)),
            f"eax_{place}": "9E9" if ride is None else f"{ride}",
        }
    module = _MODULE.format(
        name=name,
        home=_numbers(home),
        eax_home="0" if on_rail else "9E9",
        rail_home=", then the rail in mm" if on_rail else "",
        rail_place=", the rail in mm first;\n    ! 9E9 is an axis that is not there" if on_rail else ", 9E9 for none",
        **fields,
    )
    cell = _CELL.format(
        name=name,
        robot=said or robot.name,
        home=_numbers(home, ", "),
        rail=_RAIL.format(end=(_RIDE + 400) / 1000) if on_rail else "",
        start_rail="  rail: 0  # m\n" if on_rail else "",
    )
    return module, cell


def _pointing_down(robot: RobotModel, turn: float, ride: float | None) -> tuple[Array, tuple[float, ...]]:
    """The pose with joint 1 turned [deg] and the tool's orientation kept by joint 6, and the joints [deg]."""
    over = _PARALLEL_OVER if isinstance(robot.arm, ParallelArm) else _OVER
    straight = robot.forward(_axes(_joints(robot, over), ride))[:3, :3]
    for last in (turn, -turn):
        q = _joints(robot, (turn, *over[1:5], last))
        X = robot.forward(_axes(q, ride))
        if np.allclose(X[:3, :3], straight, atol=1e-9):
            return X, q
    raise AssertionError(f"joints 1 and 6 of {robot.name} are not parallel over {over}")


def _joints(robot: RobotModel, canonical: tuple[float, ...]) -> tuple[float, ...]:
    """Joints [deg] of canonical angles [deg], each in the turn that its range holds."""
    limits = robot.profile()
    q = np.degrees(robot.arm.joints(np.radians(canonical)))
    lower, upper = (np.degrees(end[-6:]) for end in (limits.lower, limits.upper))
    turns = np.where(q < lower, np.ceil((lower - q) / 360), -np.ceil(np.maximum(q - upper, 0) / 360))
    return tuple(_plain(value) for value in np.round(q + 360 * turns, 6).tolist())


def _plain(value: float) -> float:
    return int(value) if value == int(value) else value


def _axes(q: tuple[float, ...], ride: float | None) -> Array:
    """Joints [deg] and rail [mm] as the robot has its axes."""
    return np.array([*([] if ride is None else [ride * MM]), *np.radians(q)])


def _numbers(values: tuple[float, ...], gap: str = ",") -> str:
    return gap.join(map(str, values))


def _figures(values: Array, digits: int) -> str:
    # + 0.0 takes the sign off a zero
    return ",".join(f"{round(float(value), digits) + 0.0:.10g}" for value in values)
