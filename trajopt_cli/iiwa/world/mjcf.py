"""An arm, its tool and its surroundings as MJCF text, MuJoCo's own language: written from our robot, kept nowhere."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from trajopt_cli.geometry import Array, wxyz_from_rotation
from trajopt_cli.iiwa.task.model import Contact
from trajopt_cli.iiwa.world.contact import bodies
from trajopt_cli.robot.dynamics import ToolLoad
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.shapes import Capsule

TIP, TCP, HULL = "tip", "tcp", "hull of "
SOFTEST = 1e-4
"""MuJoCo's smallest impedance (mjMINIMP): the share of a contact's force that resists acceleration instead of depth."""
SLIP_RATIO = 1000.0
"""How much harder MuJoCo's contacts are along the surface than across it (impratio).

MuJoCo's convex friction lifts a sliding body: here by friction * FRICTION_RISE * speed / SLIP_RATIO, 0.06 N at 0.3 and
0.1 m/s. In return a sticking contact resists acceleration like SLIP_RATIO * SOFTEST = 0.1 of the tool's mass.
"""

_Body = tuple[float, Array, Array]  # mass [kg], its centre [m], inertia about that [kg m2]


def mjcf(
    robot: SrsRobot, X_FT: Array, load: ToolLoad | None, contact: Contact | None, gains: Sequence[tuple[float, float]]
) -> str:
    """The model: links with the inertias of pin's model of the robot, one motor per joint, the tip's ball, the boxes.

    The load is part of the last link that moves: MuJoCo takes no body without inertia, such as a point mass.
    gains: each motor's stiffness [Nm/rad] and damping [Nm s/rad]; its torque is ctrl - stiffness q - damping qd, not
    above the robot's. The ball and the capsules of the links that move collide with the boxes, in pairs named box_i and
    LINK_box_i, not with one another. A joint's range is an end stop.
    """
    lines = [
        f'<mujoco model="{robot.name}">',
        '<compiler angle="radian" autolimits="false"/>',
        f'<option gravity="{_row(robot.pin_model.gravity.linear)}" integrator="RK4" cone="elliptic" '
        f'impratio="{SLIP_RATIO:g}"/>',
        '<default><geom contype="0" conaffinity="0"/></default>',
        "<worldbody>",
    ]
    contact = contact or Contact((), 0.0)
    obstacles = contact.obstacles
    for i, obstacle in enumerate(obstacles):
        if isinstance(shape := obstacle.shape, Capsule):
            lines.append(_capsule(shape, f"box_{i}", ""))
        else:
            lines.append(f'<geom name="box_{i}" type="box" size="{_row(shape.size / 2)}" {_place(shape.X)}/>')
    *moving, last = robot.chain
    losses = zip(robot.damping.tolist(), robot.friction.tolist(), strict=True)
    for i, (joint, (damping, friction)) in enumerate(zip(moving, losses, strict=True)):
        lines.append(f'<body name="{joint.child}" {_place(robot.X_WB @ joint.X if i == 0 else joint.X)}>')
        inertia = robot.pin_model.inertias[i + 1]
        body = inertia.mass, inertia.lever, inertia.inertia
        if load is not None and joint is moving[-1]:
            R, p = last.X[:3, :3], last.X[:3, 3]
            body = _joined(body, (load.mass, R @ load.com + p, R @ load.inertia @ R.T))
        mass, com, tensor = body
        upper = tensor[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
        lines.append(f'<inertial mass="{_number(mass)}" pos="{_row(com)}" fullinertia="{_row(upper)}"/>')
        lines.append(
            f'<joint name="{joint.name}" type="hinge" axis="{_row(joint.axis)}" limited="true" '
            f'range="{_row((joint.lower, joint.upper))}" damping="{_number(damping)}" '
            f'frictionloss="{_number(friction)}"/>'
        )
        if obstacles and joint.child in robot.capsules:
            lines.append(_capsule(robot.capsules[joint.child], f"{HULL}{joint.child}"))
    lines.append(f'<body name="{last.child}" {_place(last.X)}>')
    lines.append(f'<site name="{TCP}" {_place(X_FT)}/>')
    if obstacles and contact.body is not None:
        lines.append(_capsule(contact.body, f"{HULL}{contact.body.name}"))
    if contact.tip:
        lines.append(f'<geom name="{TIP}" type="sphere" size="{_number(contact.tip)}" {_place(X_FT)} mass="0"/>')
    lines += ["</body>"] * len(robot.chain)
    lines += ["</worldbody>", "<actuator>"]
    for joint, (stiffness, damping), most in zip(moving, gains, robot.torque.tolist(), strict=True):
        lines.append(
            f'<general name="{joint.name}" joint="{joint.name}" gainprm="1" biastype="affine" '
            f'biasprm="{_row((0.0, -stiffness, -damping))}" forcelimited="true" forcerange="{_row((-most, most))}"/>'
        )
    lines += ["</actuator>", "<contact>"]
    for i, obstacle in enumerate(obstacles):
        rub = f'condim="3" friction="{_row((obstacle.friction,) * 2)} 0 0 0"' if obstacle.friction else 'condim="1"'
        solimp = f"{SOFTEST:g} {SOFTEST:g} 0.001 0.5 1"
        lines.append(f'<pair name="box_{i}" geom1="{TIP}" geom2="box_{i}" {rub} solimp="{solimp}"/>')
        lines += [
            f'<pair name="{name}_box_{i}" geom1="{HULL}{name}" geom2="box_{i}" {rub} solimp="{solimp}"/>'
            for name, *_ in bodies(robot, contact)
        ]
    lines += ["</contact>", "</mujoco>"]
    return "\n".join(lines)


def _capsule(capsule: Capsule, name: str, mass: str = 'mass="0" ') -> str:
    size = f'name="{name}" {mass}size="{_number(capsule.radius)}"'
    if np.array_equal(capsule.a, capsule.b):
        return f'<geom {size} type="sphere" pos="{_row(capsule.a)}"/>'
    return f'<geom {size} type="capsule" fromto="{_row((*capsule.a, *capsule.b))}"/>'


def _joined(one: _Body, other: _Body) -> _Body:
    """Two bodies as one, all about the same frame and axes: Steiner's share is the reduced mass times the distance."""
    (m, c, A), (n, d, B) = one, other
    mass, apart = m + n, d - c
    steiner = m * n / mass * (apart @ apart * np.eye(3) - np.outer(apart, apart))
    return mass, (m * c + n * d) / mass, A + B + steiner


def _place(X: Array) -> str:
    return f'pos="{_row(X[:3, 3])}" quat="{_row(wxyz_from_rotation(np.asarray(X)[:3, :3]))}"'


def _row(values: Iterable[float]) -> str:
    return " ".join(_number(value) for value in values)


def _number(value: float) -> str:
    return repr(float(value))
