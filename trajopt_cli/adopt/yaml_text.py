"""The YAML file of a new robot: what a URDF cannot say, as far as it can be guessed, and what is to be filled in."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from math import floor, log10

import numpy as np

from trajopt_cli.adopt.chain import Body, NormalChain, exact
from trajopt_cli.adopt.polytopes import reach
from trajopt_cli.adopt.solids import POSTURES
from trajopt_cli.adopt.tree import FIXED, CollisionShape, Inertial
from trajopt_cli.errors import printable
from trajopt_cli.geometry import Array
from trajopt_cli.robot.srs import lengths_from_chain
from trajopt_cli.robot.urdf import RAIL, UrdfJoint
from trajopt_cli.shapes import Capsule, LinkShape

TO_FULL_SPEED = 0.2  # s, a rule of thumb of industrial robots
TO_FULL_ACCELERATION = 0.1  # s
_TCP_SPEED, _TCP_ACCELERATION = 2.0, 10.0  # m/s, m/s2: on the careful side for robots of this kind
_REPLACE = "REPLACE: "

_HEAD = """\
# What the URDF cannot say about this robot. SI units: m, rad, s. Every number has a source and a grade:
#   A  two or more independent sources agree     C  one weak source, or inferred
#   B  one good source                           D  an estimate that no source at hand confirms
# Lines with REPLACE are guesses of 'trajopt robot add'. Put in your own numbers, their source and their grade; a value
# that holds for one cell alone belongs in its cell file, under limits.
"""
_CONFDATA = {
    "abb_six_axis": (
        "# How RAPID confdata follows from the joints. abb_six_axis: cf1, cf4, cf6 = floor(angle / 90 deg);\n"
        "# cfx = 4 (wrist centre behind axis 1) + 2 (wrist centre behind the lower arm) + 1 (joint_5 < 0).\n",
        "the structure's: ABB's rule for six axes with a spherical wrist; check it with targets of your own programs",
        "C",
    ),
    "none": (
        "# How RAPID confdata follows from the joints. none: this robot has no such rule, so the confdata of targets\n"
        "# is not looked at; the plan takes any of the arm's configurations.\n",
        "no ABB robot",
        "B",
    ),
}


def yaml_text(
    name: str,
    title: str,
    chain: NormalChain,
    confdata: str,
    bodies: Mapping[str, tuple[LinkShape, ...]],
    pairs: Sequence[tuple[str, str]],
    missing: Sequence[str],
) -> str:
    """The whole file."""
    about, source, grade = _CONFDATA[confdata]
    of = chain.tree.path.name
    lines = [
        *head_lines(name, title),
        "",
        about.rstrip("\n"),
        *(
            ["# Of a parallel linkage cfx is the quadrant of axis 2, not looked at in targets."]
            if chain.linkage
            else []
        ),
        "confdata:",
        f"  rule: {confdata}",
        f"  source: {quoted(source)}",
        f"  grade: {grade}",
        "",
        "# Caps on the tool centre point, from the maker's data sheet [m/s, m/s2].",
        "tcp:",
        f"  speed: {number(_TCP_SPEED, 'a careful guess; the data sheet has it')}",
        f"  acceleration: {number(_TCP_ACCELERATION, 'a careful guess; the data sheet has it')}",
        "",
        "# Where the numbers in the URDF come from: origins and axes, then ranges and speeds of the axes.",
        "geometry:",
        f"  source: {quoted(f'{_REPLACE}{of}, as it was given')}",
        "  grade: C",
        "axes:",
        *_axes(chain.axes, of),
        "",
        *(_coupled(chain) if chain.linkage else ()),
        *profile_lines(chain),
        "",
        *collision_lines(chain, bodies, pairs, missing),
    ]
    return "\n".join([*lines, ""])


def head_lines(name: str, title: str) -> list[str]:
    """How a file begins."""
    return [_HEAD.rstrip("\n"), f"name: {name}", f"title: {quoted(title)}", f"urdf: {name}.urdf"]


def quoted(text: str) -> str:
    """A YAML text in double quotes, which JSON's are."""
    return json.dumps(printable(text), ensure_ascii=False)


def number(value: float, why: str) -> str:
    """A guessed number with its source and grade."""
    return f"{{value: {float(value)!r}, source: {quoted(_REPLACE + why)}, grade: D}}"


def rounded(value: float) -> float:
    """Two digits are enough for a guess."""
    return round(value, 1 - floor(log10(abs(value))))


def guessed(joint: UrdfJoint) -> tuple[float, float]:
    """Acceleration and jerk of an axis by the rule of thumb."""
    acceleration = rounded(joint.velocity / TO_FULL_SPEED)
    return acceleration, rounded(acceleration / TO_FULL_ACCELERATION)


def _axes(axes: Sequence[UrdfJoint], of: str) -> Iterator[str]:
    source = f"{{source: {quoted(f'{of}, as it was given')}, grade: C}}"
    for i, joint in enumerate(axes):
        if joint.name == RAIL:
            placeholder = quoted("placeholder stroke, the cell file gives the real one")
            yield f"  {joint.name}:"
            yield f"    position: {{source: {placeholder}, grade: D}}"
            yield f"    velocity: {source}"
            continue
        if i == len(axes) - 6:
            yield f"  {joint.name}:"
            yield f"    position: &range {source}"
            yield f"    velocity: &speed {source}"
        else:
            yield f"  {joint.name}: {{position: *range, velocity: *speed}}"


def _coupled(chain: NormalChain) -> Iterator[str]:
    sign, levers = "-" if chain.linkage > 0 else "+", ", ".join(chain.levers)
    yield "# A parallel linkage drives the upper arm: joint_3 of programs, logs, limits and motions is the controller's"
    yield f"# axis 3, its angle against the base; the URDF's joint_3 is joint_3 {sign} joint_2. Take the entry out"
    yield "# where the controller's axes are the URDF's joints. The range of the angle between the arms is another, as"
    yield f"# {{axes: [joint_2, joint_3], factors: [{-chain.linkage:g}, 1], lower: -1.2, upper: 1.2, source: ...}}."
    yield "coupled:"
    yield "  - axis: joint_3"
    yield "    axes: [joint_2, joint_3]"
    yield f"    factors: [{chain.linkage:g}, 1]"
    yield f"    source: {quoted(f'<mimic> of {levers} in {chain.tree.path.name}')}"
    yield "    grade: C"
    yield ""


def profile_lines(chain: NormalChain) -> Iterator[str]:
    """Guessed accelerations and jerks."""
    yield "# Accelerations and jerks: makers publish none. A rule of thumb stands here: full speed in 0.2 s, full"
    yield "# acceleration in 0.1 s. Better ones come from a controller's log ('trajopt identify')."
    yield "profiles:"
    yield "  default:"
    yield f"    about: {_REPLACE.lower().rstrip(': ')} these, guesses by a rule of thumb; full speed in 0.2 s"
    for key, column, why in (
        ("acceleration", 0, "full speed in 0.2 s, a rule of thumb"),
        ("jerk", 1, "full acceleration in 0.1 s, a rule of thumb"),
    ):
        yield f"    {key}:"
        for joint in chain.axes:
            yield f"      {joint.name}: {number(guessed(joint)[column], why)}"


def collision_lines(
    chain: NormalChain,
    bodies: Mapping[str, tuple[LinkShape, ...]],
    pairs: Sequence[tuple[str, str]],
    missing: Sequence[str],
) -> Iterator[str]:
    """The collision section, or why there is none."""
    bare = [body.name for body in chain.arm if body.name not in bodies]
    if not bodies:
        yield "# No collision section: the URDF gives no collision geometry that can be read, so self-collision and"
        yield "# obstacles are not looked at. A capsule is  link_1: {a: [0, 0, 0], b: [0, 0, 0.3], radius: 0.1}  under"
        yield "# collision: links:, with source, grade and self_pairs."
        yield from (f"#   {printable(line)}" for line in missing)
        return
    yield "# Bodies around the links, each in its link's frame (the URDF's): a capsule, or how far the link or a part"
    yield "# reaches in 26 directions [m], to faces, edges and corners of a cube: (-1,-1,-1), (-1,-1,0) ... (1,1,1)."
    yield "# And the pairs of links held against each other: neighbours are not, nor are pairs that touch in none of"
    yield f"# {POSTURES:,} postures within the ranges, or with all axes at 0, or in more than nine tenths of them, or"
    yield "# with one link between them in more than a tenth: those bodies are larger than the links. attached: what a"
    yield "# cell fixes to the flange."
    if bare:
        yield f"# Without a body, and so not looked at: {', '.join(bare)}."
    yield from (f"#   {printable(line)}" for line in missing)
    yield "collision:"
    yield f"  source: {quoted(f'bodies around the collision geometry of {chain.tree.path.name}')}"
    yield "  grade: C"
    yield "  links:"
    for name, parts in bodies.items():
        if len(parts) == 1:
            yield f"    {name}: {_body(parts[0])}"
        else:
            yield f"    {name}:"
            yield "      parts:"
            yield from (f"        - {_body(part)}" for part in parts)
    if not pairs:
        yield "  self_pairs: []"
        return
    yield "  self_pairs:"
    for first, second in pairs:
        yield f"    - [{first}, {second}]"


def _body(shape: LinkShape) -> str:
    if isinstance(shape, Capsule):
        return f"{{a: {_point(shape.a)}, b: {_point(shape.b)}, radius: {shape.radius:.6g}}}"
    return f"{{polytope: {_point(np.array(reach(shape)))}}}"


def _point(values: Array) -> str:
    return f"[{', '.join(f'{value:.6g}' for value in values.tolist())}]"


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
