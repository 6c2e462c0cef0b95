"""A chain in normal form as URDF text, which both readers of robot files take: the program's own and pin."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from math import degrees
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from trajopt_cli.adopt.chain import Body, NormalChain, rpy
from trajopt_cli.adopt.tree import FIXED, SLIDING
from trajopt_cli.errors import printable
from trajopt_cli.geometry import Array
from trajopt_cli.robot.urdf import UrdfJoint

SPEED, ACCELERATION, JERK = 1.0, 2.0, 20.0
"""Of the track, guesses: tracks that are sold do 1 to 4 m/s. m/s, m/s2, m/s3."""
STROKE = 2.0  # m; the cell file gives the real one
_GUESS = "estimate for a custom track"
_JOINT = f"""\
  <joint name="rail" type="prismatic">
    <parent link="rail_base"/>
    <child link="BASE"/>
    <origin xyz="0 0 0" rpy="0 0 0"/>
    <axis xyz="0 1 0"/>
    <limit lower="0" upper="{STROKE}" velocity="{SPEED}" effort="0"/>
  </joint>
"""


def urdf_text(name: str, chain: NormalChain) -> str:
    """The whole file."""
    source, tree = chain.tree.path.name, chain.tree
    lines = [
        '<?xml version="1.0"?>',
        f"<!-- Made by 'trajopt robot add' from {_comment(source)} (robot {_comment(tree.name)}): the chain from",
        f"     {_comment(chain.base)} to {_comment(chain.tip)} alone, without pictures. The YAML beside this file says",
        "     what a URDF cannot. Above an axis stands what it is called there, its range and its speed. -->",
        f"<robot name={quoteattr(name)}>",
    ]
    for i, body in enumerate(chain.bodies):
        if i:
            lines.append("")
        lines += _link(body)
        if i:
            lines += _joint(chain.joints[i - 1], chain.named.get(chain.joints[i - 1].name, ""))
    return "\n".join([*lines, "</robot>", ""])


def number(value: float) -> str:
    """The shortest decimals that are read back as the same number; 0 without a sign."""
    text = repr(float(value) + 0.0)
    return text.removesuffix(".0")


def _comment(text: str) -> str:
    return escape(printable(text)).replace("--", "- -").rstrip("-")


def _row(values: Array | tuple[float, ...]) -> str:
    return " ".join(number(value) for value in np.asarray(values).tolist())


def _link(body: Body) -> Iterator[str]:
    name = quoteattr(body.name)
    if body.inertial is None:
        yield f"  <link name={name}/>"
        return
    one = body.inertial
    keys = (("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2))
    tensor = " ".join(f'{key}="{number(one.inertia[i, j])}"' for key, i, j in keys)
    yield f"  <link name={name}>"
    yield "    <inertial>"
    yield f'      <origin xyz="{_row(one.centre)}" rpy="0 0 0"/>'
    yield f'      <mass value="{number(one.mass)}"/>'
    yield f"      <inertia {tensor}/>"
    yield "    </inertial>"
    yield "  </link>"


def _joint(joint: UrdfJoint, named: str) -> Iterator[str]:
    if joint.kind != FIXED:
        yield f"  <!-- {_comment(named)}: {axis_words(joint)} -->"
    yield f"  <joint name={quoteattr(joint.name)} type={quoteattr(joint.kind)}>"
    yield f"    <parent link={quoteattr(joint.parent)}/>"
    yield f"    <child link={quoteattr(joint.child)}/>"
    yield f'    <origin xyz="{_row(joint.X[:3, 3])}" rpy="{_row(rpy(joint.X[:3, :3]))}"/>'
    if joint.kind != FIXED:
        limits = (
            ("lower", joint.lower),
            ("upper", joint.upper),
            ("velocity", joint.velocity),
            ("effort", joint.effort),
        )
        yield f'    <axis xyz="{_row(joint.axis)}"/>'
        given = " ".join(f'{key}="{number(value)}"' for key, value in limits)
        yield f"    <limit {given}/>"
    yield "  </joint>"


def axis_words(joint: UrdfJoint) -> str:
    """Range and speed of an axis for people."""
    if joint.kind == SLIDING:
        return f"{joint.lower:g}..{joint.upper:g} m, {joint.velocity:g} m/s"
    low, high, speed = (f"{degrees(value):.6g}" for value in (joint.lower, joint.upper, joint.velocity))
    return f"{low}..{high} deg, {speed} deg/s"


def on_track(name: str, files: Mapping[str, bytes]) -> dict[str, bytes]:
    """The files of robot NAME as those of NAME_rail, which rides along y of its root. files: NAME.urdf and NAME.yaml,
    as those of robots that ship or of new_robot; without a rail."""
    urdf, yaml = (files[f"{name}.{suffix}"].decode("utf-8") for suffix in ("urdf", "yaml"))
    texts = {f"{name}_rail.urdf": _urdf(name, urdf), f"{name}_rail.yaml": _yaml(name, yaml)}
    return {place: text.encode("utf-8") for place, text in texts.items()}


def _urdf(name: str, text: str) -> str:
    text = text.replace(", standing on its base.", " on a linear track that carries its base along +y of the root.", 1)
    head, opened, body = text.partition(f'<robot name="{name}">\n')
    assert opened, f"the URDF of {name} does not open with its name"
    base = re.match(r'  <link name="([^"]+)"(?:/>\n|>\n(?:    .*\n)*  </link>\n)', body)
    assert base is not None, f"the URDF of {name} does not begin with a link"
    return (
        f'{head}<robot name="{name}_rail">\n  <link name="rail_base"/>\n\n'
        "  <!-- The track is the cell's: its stroke here is a placeholder that the cell file overrides. -->\n"
        f"{base[0]}{_JOINT.replace('BASE', base[1])}{body[base.end() :]}"
    )


def _yaml(name: str, text: str) -> str:
    rail = (
        "  rail:\n"
        '    position: {source: "placeholder stroke, the cell file gives the real one", grade: D}\n'
        f'    velocity: {{source: "{_GUESS} (public data sheets say 1 to 4 m/s)", grade: D}}\n'
    )
    edits = [
        (rf"^name: {name}$", f"name: {name}_rail"),
        (r"^title: (\"?)(.*?)(\"?)$", r"title: \1\2 on a linear track\3"),
        (rf"^urdf: {name}\.urdf$", f"urdf: {name}_rail.urdf"),
        (r"^axes:\n", f"axes:\n{rail}"),
    ]
    for what, value in (("acceleration", ACCELERATION), ("jerk", JERK)):
        number = f'      rail: {{value: {value}, source: "{_GUESS}", grade: D}}\n'
        edits.append((rf"^    {what}:\n", f"    {what}:\n{number}"))
    for pattern, new in edits:
        text, count = re.subn(pattern, new, text, flags=re.MULTILINE)
        assert count, f"the YAML file of {name} has no line like {pattern}"
    return text
