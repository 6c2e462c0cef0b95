"""From a URDF to the two files of a robot."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from trajopt_cli.adopt.chain import NormalChain, normal_chain
from trajopt_cli.adopt.solids import link_bodies, self_pairs
from trajopt_cli.adopt.tree import read_tree
from trajopt_cli.adopt.urdf_text import on_track, urdf_text
from trajopt_cli.adopt.yaml_text import parallel, srs_yaml, yaml_text
from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.robot.arm_chain import arm_from_chain
from trajopt_cli.robot.urdf import RAIL
from trajopt_cli.shapes import LinkShape

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")
_YAML_WORDS = {"null", "true", "false", "yes", "no", "on", "off", "y", "n"}
_ABB = re.compile(r"(?<![a-z])(abb(?![a-z])|irb[ _-]?\d)", re.IGNORECASE)


@dataclass(frozen=True, eq=False)
class NewRobot:
    """A robot's two files and what they were made from. files: name in the folder to content; bodies: by link;
    missing: meshes that were not found or not readable."""

    name: str
    chain: NormalChain
    confdata: str
    files: Mapping[str, bytes]
    bodies: Mapping[str, tuple[LinkShape, ...]]
    pairs: Sequence[tuple[str, str]]
    missing: Sequence[str]


@of_kind(ErrorKind.ROBOT)
def new_robot(
    urdf: Path,
    name: str,
    tip: str | None = None,
    base: str | None = None,
    confdata: str | None = None,
    track: bool = False,
) -> NewRobot:
    """A robot of this program from the URDF of a six-axis arm that robot.arm_chain reads, on a sliding axis or not, or
    of a seven-axis arm with spherical shoulder and wrist.

    tip: the flange's link, base: the chain's first link, both found where None. confdata: the rule of RAPID's confdata,
    "abb_six_axis" or "none"; for None the first where the URDF speaks of ABB. track: NAME_rail too, the same on a
    linear track. Raises InputError for what is no URDF, no such arm, and no name.
    """
    check_name(name)
    tree = read_tree(urdf)
    chain = normal_chain(tree, tip, base)
    seven = chain.turning == 7
    if seven and (confdata or track):
        option = f"--confdata {confdata}" if confdata else "--rail"
        raise InputError(f"{option}: is for arms of six axes; this one has seven, for 'trajopt iiwa'", file=str(urdf))
    if seven:
        chain = parallel(chain)
    else:
        arm_from_chain(chain.joints[-7:], str(urdf))
    rule = confdata or ("abb_six_axis" if _ABB.search(f"{tree.name} {urdf.name}") else "none")
    solids = link_bodies(chain, capsules=seven)
    pairs = self_pairs(chain.joints[-1 - chain.turning :], solids.bodies, linkage=chain.linkage)
    title = f"{tree.name} (from {urdf.name})"
    made = solids.bodies, pairs, solids.missing
    texts = {
        f"{name}.urdf": urdf_text(name, chain),
        f"{name}.yaml": srs_yaml(name, title, chain, *made) if seven else yaml_text(name, title, chain, rule, *made),
    }
    files = {place: text.encode("utf-8") for place, text in texts.items()}
    if track:
        if RAIL in chain.named:
            raise InputError(f"--rail: the chain has one already, '{chain.named[RAIL]}'; leave it out", file=str(urdf))
        files |= on_track(name, files)
    return NewRobot(name, chain, rule, files, solids.bodies, pairs, solids.missing)


def check_name(name: str) -> None:
    """Raise InputError unless files can be called so in every system, and a YAML key needs no quotes."""
    if not _NAME.fullmatch(name):
        raise InputError(f"--name {name}: wanted a letter first, then letters, digits, _ and -")
    if name.lower() in _YAML_WORDS:
        raise InputError(f"--name {name}: is a word of YAML's own; choose another name")
