"""A chain of seven turning joints in the form that robot files of seven-axis arms have: frames parallel to the base."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from trajopt_cli.adopt.chain import Body, NormalChain, exact
from trajopt_cli.adopt.tree import FIXED, CollisionShape, Inertial
from trajopt_cli.adopt.yaml_text import collision_lines, head_lines, profile_lines, quoted
from trajopt_cli.geometry import Array
from trajopt_cli.robot.srs import lengths_from_chain
from trajopt_cli.shapes import LinkShape


def parallel(chain: NormalChain) -> NormalChain:
    """The same arm with the frame of every link parallel to the first one's while all joints are at 0.

    Raises InputError for an arm whose axes are not those of a spherical shoulder, an elbow without offset and a
    spherical wrist, stretched up at 0, and for a joint without a torque range.
    """
    R, joints, bodies, notes = np.eye(3), [], [chain.bodies[0]], list(chain.notes)
    for joint, body in zip(chain.joints, chain.bodies[1:], strict=True):
        X = np.eye(4)
        X[:3, 3] = R @ joint.X[:3, 3]
        R = R @ joint.X[:3, :3]
        joints.append(replace(joint, X=exact(X), axis=exact(R @ joint.axis) if joint.kind != FIXED else joint.axis))
        bodies.append(_turned(body, R))
    if np.abs(R - np.eye(3)).max() > 1e-9:
        notes.append(f"the flange's frame is parallel to the base at 0, unlike '{chain.tip}' of the URDF")
    lengths_from_chain(joints, str(chain.tree.path))
    return replace(chain, joints=tuple(joints), bodies=tuple(bodies), notes=tuple(notes))


def _turned(body: Body, R: Array) -> Body:
    """A body in a frame that the given one is turned by R (3, 3) in."""
    X = np.eye(4)
    X[:3, :3] = R
    one = body.inertial
    inertial = None if one is None else Inertial(one.mass, exact(R @ one.centre), R @ one.inertia @ R.T)
    shapes = tuple(CollisionShape(shape.kind, X @ shape.X, shape.sizes, shape.file) for shape in body.shapes)
    return Body(body.name, body.links, inertial, shapes)


def srs_yaml(
    name: str,
    title: str,
    chain: NormalChain,
    bodies: Mapping[str, tuple[LinkShape, ...]],
    pairs: Sequence[tuple[str, str]],
    missing: Sequence[str],
) -> str:
    """The robot's YAML file."""
    of = chain.tree.path.name
    given = f"{{source: {quoted(f'{of}, as it was given')}, grade: C}}"

    def axes() -> Iterator[str]:
        for i, joint in enumerate(chain.axes):
            keys = ("position", "velocity", "torque")
            said = (f"{key}: {f'&{key} {given}' if i == 0 else f'*{key}'}" for key in keys)
            yield f"  {joint.name}: {{{', '.join(said)}}}"

    lines = [
        *head_lines(name, title),
        "",
        "# srs: seven revolute joints, spherical shoulder, elbow, spherical wrist.",
        "structure: srs",
        "",
        "# Where the numbers in the URDF come from: origins, masses, inertias; ranges, speeds, torques.",
        "geometry:",
        f"  source: {quoted(f'REPLACE: {of}, as it was given')}",
        "  grade: C",
        "inertia:",
        f"  source: {quoted(f'REPLACE: {of}, as it was given')}",
        "  grade: C",
        "axes:",
        *axes(),
        "",
        *profile_lines(chain),
        "",
        *collision_lines(chain, bodies, pairs, missing),
    ]
    return "\n".join([*lines, ""])
