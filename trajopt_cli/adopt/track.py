"""A robot on a linear track: its two files, with a sliding axis before the arm."""

from __future__ import annotations

import re
from collections.abc import Mapping

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
