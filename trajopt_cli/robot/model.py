"""RobotModel: where a robot's flange is, how it moves with the joints, and what its axes may do.

Axis order: the rails first (where there are some), then joint_1..joint_6. Frames: W world, R the URDF's root, B the
arm's base, F the flange (tool0), T the tool centre point.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from trajopt_cli.errors import ErrorKind, of_kind
from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose, moved_by, readonly
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.motion import ConfData
from trajopt_cli.robot import arm as arm_products
from trajopt_cli.robot import inverse as closed_form
from trajopt_cli.robot.arm import Arm, elbow_angle
from trajopt_cli.robot.arm_chain import arm_from_chain
from trajopt_cli.robot.chain import checked_pose, named_profile, pin_model, pin_model_on_axes
from trajopt_cli.robot.differential import Differential
from trajopt_cli.robot.enclosure import Enclosure, enclose
from trajopt_cli.robot.layout import AxisLayout
from trajopt_cli.robot.structure import NO_CONFDATA, Structure
from trajopt_cli.robot.turns import ON_LIMIT
from trajopt_cli.robot.urdf import UrdfJoint, split_chain
from trajopt_cli.scenario import Settling
from trajopt_cli.shapes import LinkShape

if TYPE_CHECKING:
    from trajopt_cli.robot.symbolic_inverse import ArmExpressions

__all__ = ["Arm", "RobotModel", "Structure", "load_robot", "robot_names"]

_WINDING = [0, 3, 5]  # joints that nothing keeps from coming round as their branch goes on


@dataclass(frozen=True, eq=False)
class RobotModel:
    """A six-axis arm, on up to three rails or none, mounted at X_WR.

    arm: lengths, read from the URDF. X_RB: the arm's base in the root frame with the rails at 0. rail_axes
    (r, 3): directions of their travel in the root frame. tcp: the documented caps. profiles: limits of all
    axes by profile name, each number with its source; the rail's range there is a placeholder for the cell's stroke.
    notes: sources of what is not a limit, by name. chain: the arm's six joints and the fixed one to the flange, as the
    URDF has them. bodies: around the links that have some, by link name, in the link's frame. self_pairs: the links
    that are held against each other, the one nearer the base first; "attached" stands for what the flange carries.
    rotor (n,): inertias of the drives as the axes feel them [kg m2, kg for a rail], 0 where nobody says.
    confdata_rule: "none" where RAPID's confdata does not describe the joints; it is then not looked at. linkage: of an
    arm with a parallel linkage 1 or -1: the URDF's joint_3 is axis 3 - linkage * axis 2; 0 for others. All axes, their
    limits and motions are the controller's; chain_axes makes joints of the URDF of them. settle: how long they settle
    at stops, None where nobody says. colour: of its paint as "#rrggbb", None where nobody says. X_UB: the arm's base in
    the root of its URDF, where the rails are not the URDF's.
    """

    name: str
    title: str
    axis_names: tuple[str, ...]
    arm: Arm
    X_WR: Array
    X_RB: Array
    rail_axes: Array
    tcp: TcpCaps
    profiles: Mapping[str, JointLimits]
    notes: Mapping[str, str]
    urdf: Path
    chain: tuple[UrdfJoint, ...]
    bodies: Mapping[str, tuple[LinkShape, ...]]
    self_pairs: tuple[tuple[str, str], ...]
    rotor: Array
    confdata_rule: str = "abb_six_axis"
    linkage: float = 0.0
    tcp_spread: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    default_profile: str = "default"
    settle: Settling | None = None
    colour: str | None = None
    X_UB: Array | None = None

    def lacks_for_torques(self, torque: Array | None) -> tuple[str, ...]:
        """What somebody would have to say before torques can be kept to limits torque (n,): "effort of joint_2" for a
        joint of the arm without one, "mass of link_2" for a body without an inertial in the URDF. A rail may have no
        limit; then what stands on it may have no mass."""
        known = np.isfinite(np.full(self.layout.n, np.inf) if torque is None else torque)
        links = (*(self.link_names[:1] * self.layout.r), *self.link_names[1:])
        bodies = list(self.pin_model.inertias)[1:]
        arm = [False] * self.layout.r + [True] * self.layout.joints
        efforts = [f"effort of {n}" for n, has, of in zip(self.axis_names, known, arm, strict=True) if of and not has]
        # a first joint that only turns about the vertical need not know how heavy its link is
        masses = [
            f"mass of {link}"
            for link, body, has, of in zip(links, bodies, known, arm, strict=True)
            if (of or has) and not (body.mass > 0 or np.any(body.inertia))
        ]
        return *efforts, *masses

    @property
    def has_rail(self) -> bool:
        """Whether the first axes are rails."""
        return self.layout.has_rail

    @cached_property
    def layout(self) -> AxisLayout:
        """Which axes are the rail's and the arm's."""
        return AxisLayout.rail_first(6, len(self.rail_axes))

    def chain_axes(self, q: Any) -> Any:
        """Positions, speeds or accelerations (..., n) of the URDF's joints, of those of the controller's axes (..., n),
        which for all but a parallel linkage are the same; or of an expression (n,)."""
        if not self.linkage:
            return q
        out, lower = q + 0.0, self.layout.arm.start + 1
        if isinstance(q, np.ndarray):
            out[..., lower + 1] -= self.linkage * q[..., lower]
        else:
            out[lower + 1] -= self.linkage * q[lower]
        return out

    @property
    def closed_form(self) -> bool:
        """Whether branches have closed forms; else they are found step by step, and the inverse has no expression."""
        return self.arm.closed_form

    @cached_property
    def turns(self) -> Array:
        """Whole turns (t, 6) [rad] that take joints as the inverse gives them into their ranges, none first; one either
        way at least of joints 1, 4 and 6, which come round where the rail takes the arm past a pose."""
        limits, joints = self.profile(), self.layout.arm
        low = np.ceil((limits.lower[joints] - self.arm.middles - np.pi - ON_LIMIT) / (2 * np.pi))
        high = np.floor((limits.upper[joints] - self.arm.middles + np.pi + ON_LIMIT) / (2 * np.pi))
        low[_WINDING], high[_WINDING] = np.minimum(low[_WINDING], -1), np.maximum(high[_WINDING], 1)
        each = [sorted(range(int(a), int(b) + 1), key=lambda k: (abs(k), k)) for a, b in zip(low, high, strict=True)]
        return readonly(2 * np.pi * np.array([*product(*each)]))

    @property
    def middles(self) -> Array:
        """Joints (6,) [rad] that those of the inverse lie within half a turn of."""
        return self.arm.middles

    def branches(self, X_WF: Array, rail: Array | None) -> Array:
        """Joints (k, 8, 6) by cfx of flange poses (k, 4, 4): see robot.inverse."""
        return closed_form.inverse(self, X_WF, rail)

    def branch(self, X_WF: Array, rail: Array | None, cfx: IndexArray | int) -> Array:
        """Joints (k, 6) of one branch each, cfx (k,), or of the same one."""
        return closed_form.inverse(self, X_WF, rail, cfx)

    def singularity_margins(self, arm: Array) -> tuple[Array, Array]:
        """|sin| of the elbow, 1 when it is stretched and folded, and of axis 5, 0 at the stretched wrist.

        With an offset b the first is also 1 where the wrist centre is as near to axis 1 as it can be.
        """
        bent, reach = arm[..., 4] + self.arm.signs[4] * self.arm.offsets[4], np.abs(np.sin(elbow_angle(self.arm, arm)))
        if self.arm.b:
            before = arm_products.wrist_section(self.arm, arm)[0]
            reach = np.maximum(reach, self.arm.b**2 / (self.arm.b**2 + before**2))
        return reach, np.abs(np.sin(bent))

    def solutions(self, X_WF: Array, rail: Array | float | None, limits: JointLimits) -> list[tuple[int, Array]]:
        """Every (cfx, joints (6,)) within limits of one flange pose (4, 4), turns included."""
        return closed_form.solutions(self, X_WF, rail, limits)

    def why_unreachable(self, X_WF: Array, rail: Array | float | None, limits: JointLimits) -> str:
        """The reason, in one clause, why there are none. Raises ValueError for a pose that has some."""
        return closed_form.why_unreachable(self, X_WF, rail, limits)

    def confdata(self, arm: Array) -> ConfData:
        """RAPID confdata of joints (6,)."""
        return closed_form.confdata(self, arm)

    def confdata_rows(self, arm: Array) -> Array:
        """RAPID confdata of joints (n, 6) as numbers (n, 4); (n, 0) for a robot without a rule for it."""
        rows = closed_form.confdata_numbers(self, arm)
        return np.asarray(rows[:, :0] if self.confdata_rule == NO_CONFDATA else rows, dtype=np.float64)

    def branch_of(self, arm: Array) -> int:
        """The number of the branch that joints (6,) are on."""
        return closed_form.branch_of(self.arm, arm)

    def admits(self, conf: ConfData, arm: Array) -> BoolArray:
        """Whether a target with this confdata may be reached with joints (..., 6)."""
        return closed_form.confdata_admits(self, conf, arm)

    def enclose(self, X_WF: Array, rail: Array, limits: JointLimits, twist: Array | None = None) -> Enclosure:
        """The first three joints and their rates over the intervals between positions (k + 1,) of one rail at most;
        twist (6,): of the flange on its way through the pose, world axes."""
        X_CW = inverse_pose(self.X_WC0)
        e = X_CW[:3, :3] @ self.rail_axes_W[0] if self.has_rail else np.zeros(3)
        lower, upper = (x[self.layout.arm][:3] for x in (limits.lower, limits.upper))
        R_CW = X_CW[:3, :3]
        twist_C = None if twist is None else np.concatenate([R_CW @ twist[:3], R_CW @ twist[3:]])
        return enclose(self.arm, X_CW @ X_WF, e, rail, lower, upper, twist_C)

    @cached_property
    def expressions(self) -> ArmExpressions:
        """Forward kinematics and the inverse on one branch as CasADi expressions."""
        from trajopt_cli.robot.symbolic_inverse import ArmExpressions

        return ArmExpressions(self.arm, self.pin_model, self.chain_axes)

    def profile(self, name: str | None = None) -> JointLimits:
        """Limits of all axes under a named profile; the robot's default for None and "default". Raises InputError
        listing the profiles."""
        return named_profile(self.name, self.profiles, self.profile_name(name))

    def profile_name(self, name: str | None = None) -> str:
        """What a profile is called that cells ask for by a name, or by none."""
        return self.default_profile if name in (None, "default") else str(name)

    @property
    def files(self) -> tuple[Path, ...]:
        """What its own YAML file names: the URDF, and tables of accelerations."""
        tables = [limits.table.file for limits in self.profiles.values() if limits.table is not None]
        return (self.urdf, *dict.fromkeys(file for file in tables if file is not None))

    @cached_property
    def X_WB0(self) -> Array:
        """The arm's base X_WB (4, 4) with the rail at 0."""
        return readonly(self.X_WR @ self.X_RB)

    @cached_property
    def X_WC0(self) -> Array:
        """The arm's canonical base X_WC (4, 4) with the rail at 0: see robot.arm."""
        return readonly(self.X_WB0 @ self.arm.X_BC)

    @cached_property
    def rail_axes_W(self) -> Array:
        """Unit directions (r, 3) of the rails' travel in the world."""
        return readonly(np.array([self.X_WR[:3, :3] @ axis for axis in self.rail_axes]).reshape(-1, 3))

    def way(self, rail: Array | float | None) -> Array:
        """How far (..., 3) [m] rails at positions (..., r) have taken the base in the world; those of one rail may be
        plain, (n,) or a number. 0 without a rail, whatever is given."""
        d, r = np.asarray(0.0 if rail is None else rail, dtype=np.float64), self.layout.r
        plain = d.ndim == 0 or (r < 2 and d.ndim == 1 and len(d) != r)
        return self.way_at(d[..., None] if plain else d)

    def way_at(self, q: Array) -> Array:
        """The same at axes q (..., k), of speeds how fast [m/s]."""
        out = np.zeros((*q.shape[:-1], 3))
        for i, axis in enumerate(self.rail_axes_W):
            out += q[..., i, None] * axis
        return out

    def base(self, rail: Array | float = 0.0) -> Array:
        """The arm's base X_WB (..., 4, 4) at rail positions as in `way`."""
        return moved_by(self.X_WB0, self.way(rail))

    def base_at(self, q: Array) -> Array:
        """The same at axes q (..., k)."""
        return moved_by(self.X_WB0, self.way_at(q))

    def canonical_base_at(self, q: Array) -> Array:
        """The arm's canonical base X_WC (..., 4, 4) at axes q (..., k)."""
        return moved_by(self.X_WC0, self.way_at(q))

    def forward(self, q: Array) -> Array:
        """Flange poses X_WF (..., 4, 4) of axis positions q (..., k)."""
        return self.differential(q).pose()

    def rail_within(self, X_WF: Array, i: int = 0) -> Array:
        """Positions (k, 2) [m] of rail i, the others at 0, outside which the arm is too short for flange poses (k, 4,
        4), whatever its joints; both where the base is abreast of a pose that is out of reach everywhere. Without a
        rail they do not matter."""
        if not self.has_rail:
            return np.zeros((len(X_WF), 2))
        arm = self.arm
        away = X_WF[:, :3, 3] - self.X_WC0[:3] @ np.array([0.0, 0.0, arm.c1, 1.0])
        along = away @ self.rail_axes_W[i]
        aside = np.sum(away**2, axis=1) - along**2
        flange = float(np.linalg.norm(arm.X_KF[:3, 3] + [0.0, 0.0, arm.c4]))  # from the wrist centre
        longest = float(np.hypot(abs(arm.a1) + arm.c2 + arm.upper, arm.b) + np.linalg.norm(arm.wrist)) + flange
        half = np.sqrt(np.maximum(longest**2 - aside, 0.0))
        return np.stack([along - half, along + half], axis=1)

    @cached_property
    def link_names(self) -> tuple[str, ...]:
        """The arm's links from the base on: the base, then the link behind each of the six joints."""
        return (self.chain[0].parent, *(joint.child for joint in self.chain[:6]))

    def jacobian(self, q: Array, X_FT: Array | None = None) -> Array:
        """Geometric Jacobian (..., 6, k) at the TCP in world axes, linear rows first: [v; omega] = J qd.

        q (..., k). X_FT (4, 4): the TCP in the flange frame, the flange itself for None.
        """
        return self.differential(q, X_FT).jacobian()

    def differential(self, q: Array, X_FT: Array | None = None) -> Differential:
        """How the TCP moves with the axes at q (..., k). X_FT (4, 4): the TCP in the flange frame, None: the flange."""
        q, k = np.asarray(q, dtype=np.float64), len(self.axis_names)
        if q.ndim == 0 or q.shape[-1] != k:
            raise ValueError(f"q has shape {q.shape}, wanted (..., {k}) for {', '.join(self.axis_names)}")
        return Differential.of(self.arm, q, X_FT, self.X_WC0, self.rail_axes_W)

    @cached_property
    def pin_model(self) -> Any:
        """pin.Model of the URDF, mounted at X_WR; built once, on first use."""
        if self.X_UB is None:
            return pin_model(self.urdf, self.X_WR)
        return pin_model_on_axes(self.urdf, self.X_WB0 @ inverse_pose(self.X_UB), self.axis_names, self.rail_axes_W)


def robot_names(structure: Structure | None = None) -> tuple[str, ...]:
    """The robots that ship, sorted; those of one structure where it is given."""
    from trajopt_cli.robot import catalogue

    return catalogue.robot_names(structure)


@of_kind(ErrorKind.ROBOT)
def load_robot(name_or_path: str, X_WR: Array | None = None) -> RobotModel:
    """A shipped robot by name or any robot by the path of its YAML file, its URDF root mounted at X_WR in the world.

    X_WR (4, 4), identity for None. Raises InputError for an unknown name, for a file with a mistake, and for an arm
    that has not six axes.
    """
    from trajopt_cli.robot import description

    data, path, raw = description.read_six_axis(name_or_path)
    urdf, whole = description.urdf_chain(data, path, raw)
    mount, arm_chain = split_chain(whole, str(urdf))
    X_RB, rail_axes = np.eye(4), np.zeros((0, 3))
    for joint in mount:
        X_RB = X_RB @ joint.X
        if joint.kind == "prismatic":
            rail_axes = readonly(X_RB[:3, :3] @ joint.axis)[None]
    axes = [joint for joint in mount + arm_chain if joint.kind != "fixed"]
    tables = description.acceleration_tables(data, path, raw, axes)
    description.check(data, path, raw, axes, arm_chain, tables)
    linkage = description.linkage(data)
    return RobotModel(
        name=data.name,
        title=data.title,
        axis_names=tuple(joint.name for joint in axes),
        arm=arm_from_chain(arm_chain, str(urdf), coupled=linkage != 0),
        X_WR=checked_pose(X_WR, "X_WR"),
        X_RB=readonly(X_RB),
        rail_axes=rail_axes,
        tcp=TcpCaps(data.tcp.speed.value, data.tcp.acceleration.value),
        tcp_spread={
            "speed": data.tcp.speed.spread("velocity"),
            "acceleration": data.tcp.acceleration.spread("acceleration"),
        },
        profiles=description.profiles(data, axes, tables),
        notes=description.notes(data)
        | ({"inertia": str(data.inertia)} if data.inertia else {})
        | {f"{name}.rotor": str(one.rotor_inertia) for name, one in data.axes.items() if one.rotor_inertia}
        | {
            "confdata": str(data.confdata),
            "tcp.speed": str(data.tcp.speed),
            "tcp.acceleration": str(data.tcp.acceleration),
        },
        urdf=urdf,
        chain=tuple(arm_chain),
        bodies=description.bodies(data, path, raw),
        colour=data.colour,
        self_pairs=data.collision.self_pairs if data.collision else (),
        rotor=description.rotors(data, axes),
        confdata_rule=data.confdata.rule,
        linkage=linkage,
        default_profile=data.profile,
        settle=description.settling(data),
    )
