"""Six-axis arms of every kind, written as robot files: random ones in random frames, and some that are known."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cache, partial
from io import StringIO
from math import pi
from pathlib import Path

import numpy as np
from ruamel.yaml import YAML

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.robot.model import RobotModel, load_robot

ROBOTS = Path(__file__).parents[1] / "robots"
X, Y, Z = np.eye(3)
QUARTER = pose(rotation_about(Y, pi / 2), [0, 0, 0])


@dataclass
class Chain:
    """Joints as a URDF has them: origins (4, 4), unit axes (3,), ranges [rad]; flange (4, 4); rail: its joint's origin,
    its axis, the arm's base on its carriage. linked: a parallel linkage drives the upper arm."""

    origins: list[Array]
    axes: list[Array]
    flange: Array
    ranges: list[tuple[float, float]] = field(default_factory=lambda: [(-pi, pi)] * 6)
    rail: tuple[Array, Array, Array] | None = None
    linked: bool = False

    def urdf(self) -> str:
        """The file's text."""
        parts, parent = [], "base_link"
        if self.rail is not None:
            origin, axis, base = self.rail
            limit = 'lower="0" upper="2" velocity="1" effort="0"'
            parts += [_joint("rail", "prismatic", "root", "carriage", origin, axis, limit)]
            parts += [_joint("base", "fixed", "carriage", "base_link", base)]
        for i, (origin, axis, (low, high)) in enumerate(zip(self.origins, self.axes, self.ranges, strict=True), 1):
            limit = f'lower="{low!r}" upper="{high!r}" velocity="3.5" effort="0"'
            parts.append(_joint(f"joint_{i}", "revolute", parent, f"link_{i}", origin, axis, limit))
            parent = f"link_{i}"
        parts.append(_joint("flange", "fixed", parent, "tool0", self.flange))
        root = "" if self.rail is None else '<link name="root"/><link name="carriage"/>'
        links = "".join(f'<link name="link_{i}"/>' for i in range(1, 7))
        body = "\n".join(parts)
        return f'<robot name="arm">{root}<link name="base_link"/>{links}<link name="tool0"/>\n{body}\n</robot>'

    def load(self, folder: Path, X_WR: Array | None = None, name: str = "arm") -> RobotModel:
        """The robot of this chain, its files written to a folder. What is no geometry is the IRB 140's."""
        (folder / f"{name}.urdf").write_text(self.urdf())
        text = _robot_file("irb140" if self.rail is None else "irb140_rail", name)
        if self.linked:
            alike = round(float(self.axes[1] @ self.origins[2][:3, :3] @ self.axes[2]))
            text += f"coupled: [{{axis: joint_3, axes: [joint_2, joint_3], factors: [{alike}, 1], {MADE_UP}}}]\n"
        (folder / f"{name}.yaml").write_text(text)
        return load_robot(str(folder / f"{name}.yaml"), X_WR)


MADE_UP = "source: made up, grade: D"


def urdf_joints(robot: RobotModel, q: Array) -> Array:
    """The URDF's joints (..., k) of a robot's axes (..., k)."""
    q = np.array(q)
    q[..., -4] -= robot.linkage * q[..., -5]
    return q


def _robot_file(source: str, name: str) -> str:
    """A shipped robot's file with another name and URDF, one profile, and nothing of its shape."""
    return _file_of_anybody(source).replace("NAME", name)


@cache
def _file_of_anybody(source: str) -> str:
    raw = YAML().load((ROBOTS / f"{source}.yaml").read_text())
    raw.update(name="NAME", title="NAME", urdf="NAME.urdf")
    raw.pop("collision")
    raw["profiles"] = {"default": raw["profiles"]["default"]}
    text = StringIO()
    YAML().dump(raw, text)
    return text.getvalue()


def _joint(
    name: str, kind: str, parent: str, child: str, X_PJ: Array, axis: Array | None = None, limit: str = ""
) -> str:
    R = X_PJ[:3, :3]
    rpy = np.arctan2(R[2, 1], R[2, 2]), np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0])), np.arctan2(R[1, 0], R[0, 0])
    more = "" if axis is None else f'<axis xyz="{_row(axis)}"/><limit {limit}/>'
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{_row(X_PJ[:3, 3])}" rpy="{_row(rpy)}"/>{more}</joint>'
    )


def _row(values: object) -> str:
    return " ".join(repr(float(v)) for v in np.asarray(values))


def random_pose(rng: np.random.Generator, far: float = 0.5) -> Array:
    axis = rng.normal(size=3)
    return pose(rotation_about(axis / np.linalg.norm(axis), rng.uniform(0.1, 3.0)), rng.uniform(-far, far, 3))


def random_chain(seed: int, wrist: float = 0.0) -> Chain:
    """An arm with any lengths, signs and offsets, its links' frames anywhere on the axes, base and flange anywhere, and
    axis 6 up to so far [m] aside and above the point where axes 4 and 5 meet.

    It is built forward from the axes it shall have; nothing of what reads it is used.
    """
    rng = np.random.default_rng(seed)
    a1, b = rng.choice([0.0, 1.0], 2) * rng.uniform(-0.3, 0.3, 2)
    a2 = rng.choice([0.0, 1.0]) * rng.uniform(-0.2, 0.2)
    c1, c2, c3, c4 = rng.uniform([0.1, 0.2, 0.15, -0.1], [0.6, 0.7, 0.8, 0.3])
    elbow_b = rng.uniform(-0.2, 0.2) if b else 0.0  # part of b may stand at the elbow
    steps = [(0, 0, c1), (a1, b - elbow_b, 0), (0, elbow_b, c2), (c3 / 3, 0, -a2), (2 * c3 / 3, 0, 0)]
    steps.append((0, *rng.uniform(-wrist, wrist, 2)) if wrist else (0, 0, 0))
    frame = random_pose(rng)  # of the link's frame in the canonical one: its inverse stands before the next joint
    origins, axes = [], []
    for step, axis in zip(steps, (Z, Y, Y, X, Y, X), strict=True):
        turn = pose(rotation_about(axis, rng.choice([0.0, rng.uniform(-3, 3)])), np.zeros(3))
        placed = random_pose(rng, 0.0)
        placed[:3, 3] = axis * rng.uniform(-0.3, 0.3)
        origins.append(np.linalg.inv(frame) @ pose(np.eye(3), step) @ turn @ placed)
        axes.append(rng.choice([-1.0, 1.0]) * placed[:3, :3].T @ axis)
        frame = placed
    flange = np.linalg.inv(frame) @ pose(np.eye(3), [c4, 0, 0]) @ random_pose(rng, 0.1)
    middles, halves = rng.uniform(-1, 1, 6), rng.uniform(1.6, 3.0, 6) * rng.choice([1.0, 2.0], 6)
    ranges = [(float(m - h), float(m + h)) for m, h in zip(middles, halves, strict=True)]
    return Chain(origins, axes, flange, ranges)


def abb_like(
    a1: float, c1: float, c2: float, a2: float, c3: float, c4: float, b: float = 0.0,
    wrist: tuple[float, float] = (0.0, 0.0),
) -> Chain:  # fmt: skip
    """An arm in ABB's axis directions, with its ranges; a2 is negative where the upper arm stands above axis 3. wrist:
    how far axis 6 stands aside and above the point where axes 4 and 5 meet."""
    places = [(0, 0, 0), (a1, b, c1), (0, 0, c2), (0, 0, -a2), (c3, 0, 0), (0, *wrist)]
    degrees = [(-180, 180), (-90, 110), (-230, 50), (-200, 200), (-115, 115), (-400, 400)]
    return Chain(
        [pose(np.eye(3), place) for place in places],
        [Z, Y, Y, X, Y, X],
        pose(rotation_about(Y, pi / 2), [c4, 0, 0]),
        [(float(low), float(high)) for low, high in np.radians(degrees)],
    )


def irb1200() -> Chain:
    """ABB IRB 1200-5/0.9: no offset at axis 1, 42 mm at the elbow (data sheet: 399.1, 448, 42, 451, 82 mm)."""
    return abb_like(0.0, 0.3991, 0.448, -0.042, 0.451, 0.082)


def irb4600() -> Chain:
    """ABB IRB 4600-40/2.55: 175 mm at axis 1 and at the elbow (data sheet: 495, 175, 1095, 175, 1270, 135 mm)."""
    return abb_like(0.175, 0.495, 1.095, -0.175, 1.27, 0.135)


def gofa() -> Chain:
    """ABB CRB 15000-5/0.95: 80 mm from axis 4 to axis 6 (data sheet: 265, 444, 110, 470, 80, 101 mm)."""
    return abb_like(0.0, 0.265, 0.444, -0.110, 0.470, 0.101, wrist=(0.0, 0.080))


def crx() -> Chain:
    """FANUC CRX-10iA: axis 6 stands 150 mm beside axis 4 (data sheet: 245, 710, 540, 150, 160 mm)."""
    return abb_like(0.0, 0.245, 0.710, 0.0, 0.540, 0.160, wrist=(-0.150, 0.0))


OFFSET_WRISTS = {"gofa": gofa, "crx": crx}


def puma560() -> Chain:
    """Unimation PUMA 560 by its modified Denavit-Hartenberg table (Craig, Introduction to Robotics: a2 = 0.4318,
    a3 = 0.0203, d3 = 0.1501, d4 = 0.4318 m), every axis the z of its link's frame."""
    table = [  # alpha, a, d before each joint
        (0, 0, 0), (-pi / 2, 0, 0), (0, 0.4318, 0.1501), (-pi / 2, 0.0203, 0.4318), (pi / 2, 0, 0), (-pi / 2, 0, 0),
    ]  # fmt: skip
    origins = []
    for alpha, a, d in table:
        R = rotation_about(X, alpha)
        origins.append(pose(R, np.array([a, 0, 0]) + R @ [0, 0, d]))
    degrees = [(-160, 160), (-225, 45), (-225, 45), (-110, 170), (-100, 100), (-266, 266)]
    ranges = [(float(low), float(high)) for low, high in np.radians(degrees)]
    return Chain(origins, [Z] * 6, pose(np.eye(3), [0, 0, 0.056]), ranges)


KNOWN = {"irb1200": irb1200, "irb4600": irb4600, "puma560": puma560}


def on_rail(chain: Chain, kind: str) -> Chain:
    """The arm on a rail: on the floor, hanging from one overhead, on its side on one that goes up, or anyhow."""
    slant = np.array([0.3, 0.8, 0.5]) / np.linalg.norm([0.3, 0.8, 0.5])
    rails = {
        "floor": (pose(np.eye(3), [0, 0, 0]), Y, np.eye(4)),
        "overhead": (pose(np.eye(3), [0, 0, 2.0]), Y, pose(rotation_about(X, pi), [0, 0, 0])),
        "vertical": (pose(rotation_about(X, -pi / 2), [0, 0, 0]), np.array([0.0, -1, 0]), np.eye(4)),
        "oblique": (pose(rotation_about(Z, 0.4), [0.1, 0.2, 0.3]), slant, random_pose(np.random.default_rng(9))),
    }
    return replace(chain, rail=rails[kind])


RAILS = ("floor", "overhead", "vertical", "oblique")


def pin_flange(robot: RobotModel, q: Array) -> Array:
    """Flange poses (n, 4, 4) of axes (n, k) by pin."""
    q = urdf_joints(robot, q)
    import pinocchio as pin

    model = robot.pin_model
    data, frame, out = model.createData(), model.getFrameId("tool0", pin.FrameType.BODY), np.empty((len(q), 4, 4))
    for i, row in enumerate(q):
        pin.forwardKinematics(model, data, row)
        out[i] = pin.updateFramePlacement(model, data, frame).homogeneous
    return out


def random_parallel_chain(seed: int) -> Chain:
    """An arm whose axes 2, 3 and 4 are parallel and whose axes 5 and 6 meet, with any lengths, signs and offsets, its
    links' frames anywhere on the axes, base and flange anywhere; axis 5 may pass axis 4.

    It is built forward from the axes it shall have; nothing of what reads it is used.
    """
    rng = np.random.default_rng(seed)
    a1 = rng.choice([0.0, 1.0]) * rng.uniform(-0.2, 0.2)
    offsets = rng.uniform(-0.1, 0.1, 4) * (1.0 if seed else 0.0)  # along axes 2 to 4; none with seed 0
    c1, c2, c3, d5, c4 = rng.uniform([0.1, 0.3, 0.3, -0.12, -0.1], [0.3, 0.7, 0.6, 0.12, 0.2])
    a5 = rng.choice([0.0, 1.0]) * rng.uniform(-0.1, 0.1)
    steps = [(0, 0, c1), (a1, offsets[0], 0), (0, offsets[1], c2), (c3, offsets[2], 0), (a5, offsets[3], 0), (0, 0, d5)]
    frame = random_pose(rng)  # of the link's frame in the canonical one: its inverse stands before the next joint
    origins, axes = [], []
    for step, axis in zip(steps, (Z, Y, Y, Y, Z, Y), strict=True):
        turn = pose(rotation_about(axis, rng.choice([0.0, rng.uniform(-3, 3)])), np.zeros(3))
        placed = random_pose(rng, 0.0)
        placed[:3, 3] = axis * rng.uniform(-0.3, 0.3)
        origins.append(np.linalg.inv(frame) @ pose(np.eye(3), step) @ turn @ placed)
        axes.append(rng.choice([-1.0, 1.0]) * placed[:3, :3].T @ axis)
        frame = placed
    flange = np.linalg.inv(frame) @ pose(np.eye(3), [0, c4, 0]) @ random_pose(rng, 0.1)
    middles, halves = rng.uniform(-1, 1, 6), rng.uniform(1.6, 3.0, 6) * rng.choice([1.0, 2.0], 6)
    ranges = [(float(m - h), float(m + h)) for m, h in zip(middles, halves, strict=True)]
    return Chain(origins, axes, flange, ranges)


UR5E = (0.1625, -0.425, -0.3922, 0.1333, 0.0997, 0.0996)
UR10E = (0.1807, -0.6127, -0.57155, 0.17415, 0.11985, 0.11655)


def universal_robot(d1: float, a2: float, a3: float, d4: float, d5: float, d6: float) -> Chain:
    """A Universal Robots arm by its maker's Denavit-Hartenberg table, every axis the z of its link's frame."""
    rows = [(d1, 0, pi / 2), (0, a2, 0), (0, a3, 0), (d4, 0, pi / 2), (d5, 0, -pi / 2), (d6, 0, 0)]
    links = [pose(np.eye(3), [0, 0, d]) @ pose(rotation_about(X, alpha), [a, 0, 0]) for d, a, alpha in rows]
    return Chain([np.eye(4), *links[:5]], [Z] * 6, links[5], [(-2 * pi, 2 * pi)] * 6)


PARALLEL = {"ur5e": partial(universal_robot, *UR5E), "ur10e": partial(universal_robot, *UR10E)}


def some_arm(name: str | int) -> Chain:
    """Of KNOWN or PARALLEL by its name, "parallel 3", or of a spherical wrist by its seed, "linked 3" by a linkage."""
    if isinstance(name, int):
        return random_chain(name)
    if name.startswith("linked"):
        return replace(random_chain(int(name.split()[1])), linked=True)
    return (KNOWN | PARALLEL)[name]() if name in KNOWN | PARALLEL else random_parallel_chain(int(name.split()[1]))
