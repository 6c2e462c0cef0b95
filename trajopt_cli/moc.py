"""MOC.cfg: what a controller's backup says in SYSPAR of its mechanics, as far as a cell file has words for it.

A file of system parameters has sections (`ARM:`), in them entries `-name "rob1_1" -upper_joint_bound 2.7`, which go on
behind a backslash at a line's end; a line that begins with # is a comment (ABB, Technical reference manual - System
parameters, 3HAC050948, topic Motion). Angles are rad, lengths m, with their rates per second. What has its default is
left out: positions 0, orientations 1 0 0 0; so is what belongs to a mechanical unit of ABB's own.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from trajopt_cli.errors import printable
from trajopt_cli.geometry import Array, pose, rotation_from_wxyz
from trajopt_cli.units import decimal
from trajopt_cli.warnings import ProgramWarning, WarningKind

_SECTION = re.compile(r"([A-Z][A-Z0-9_]*):")
_TOKEN = re.compile(r'"[^"]*"|[^\s"]+')
_KEY = re.compile(r"-[A-Za-z_]\w*")
# rad of a joint, rad of a table, m: beyond, a bound is in degrees or mm, or is none
_MOST_TURNED, _MOST_ROUND, _LONGEST = 4 * math.pi + 1e-3, 1e4, 100.0
_FIRST_EXTERNAL = 7  # the logical axis that is eax_a
_MOST_SHOWN = 8  # places of what is broken


class Given(NamedTuple):
    """A value as text, "" for a switch, and its line."""

    text: str
    line: int


class Range(NamedTuple):
    """Lowest and highest position [m, rad], and the line that says so."""

    lower: float
    upper: float
    line: int


@dataclass(frozen=True)
class Entry:
    """One entry of a section: its line, its name, and what it says by key."""

    line: int
    values: dict[str, Given] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """Empty for an entry without."""
        return self.text("name")

    def text(self, key: str) -> str:
        """What stands behind a key; empty where it is missing or a switch."""
        return self.values[key].text if key in self.values else ""


@dataclass(frozen=True)
class External:
    """An external axis: a single of a mechanical unit. line: of its SINGLE.

    eax: 0 for eax_a, None where no JOINT says it, and the line that says it. moved_by: what moves its base frame.
    slides: None where nothing tells. X (4, 4): its base frame in the world; a track runs along x of it, a positioner
    turns about z. velocity, acceleration: None where they are not given. active: from start-up; fixed: it cannot be
    deactivated.
    """

    name: str
    line: int
    eax: int | None
    eax_line: int
    range: Range | None
    moved_by: str
    slides: bool | None
    X: Array
    velocity: float | None
    acceleration: float | None
    active: bool
    fixed: bool


@dataclass(frozen=True)
class ConfiguredRobot:
    """A robot: its line, its type, its base frame X (4, 4) in the world, with what moves that at 0, its joints' ranges
    (None where not given), and what moves its base frame: the name, and the axis where there is one."""

    name: str
    line: int
    type: str
    X: Array
    ranges: tuple[Range | None, ...]
    moved_by: str
    track: External | None


@dataclass(frozen=True)
class Mechanics:
    """The robots and external axes of a MOC.cfg, and what was not understood in it."""

    file: str
    robots: tuple[ConfiguredRobot, ...]
    externals: tuple[External, ...]
    notices: tuple[ProgramWarning, ...]

    def robot_of(self, places: str) -> ConfiguredRobot | None:
        """The robot that a program at these places belongs to: the only one, or that of its task, ROB_2 of T_ROB2; else
        the first."""
        tasks = set(re.findall(r"\bT_ROB_?(\w+?)\b", places.upper()))
        own = [one for one in self.robots if one.name.upper().removeprefix("ROB").lstrip("_") in tasks]
        return own[0] if len(own) == 1 else next(iter(self.robots), None)

    def place(self, line: int) -> str:
        """A line of the file."""
        return f"{self.file}:{line}"


def read_moc(text: str, file: str) -> Mechanics:
    """What a MOC.cfg says. What is broken in it is a notice by its line, and the rest is read."""
    return _Reader(text, file).mechanics()


class _Reader:
    def __init__(self, text: str, file: str):
        self.file = file
        self.notices: list[ProgramWarning] = []
        self.sections: dict[str, list[Entry]] = {}
        self._read(text)

    def _say(self, line: int, text: str) -> None:
        self.notices.append(ProgramWarning(WarningKind.NOT_READ, text, f"{self.file}:{line}"))

    def _read(self, text: str) -> None:
        entries: list[Entry] | None = None
        entry: Entry | None = None
        open_, odd, number = False, [], 0
        for number, raw in enumerate(text.splitlines(), start=1):
            line = raw.strip()
            if not line or line.startswith("#") or (number == 1 and ":CFG" in line):
                continue
            if section := _SECTION.fullmatch(line):
                entries, entry, open_ = self.sections.setdefault(section[1], []), None, False
                continue
            tokens = _TOKEN.findall(line.removesuffix("\\"))
            if not open_:
                entry = Entry(number) if entries is not None and tokens and tokens[0] == "-name" else None
                if entry is None or entries is None:
                    odd.append(number)
                    continue
                entries.append(entry)
            assert entry is not None
            open_, key = line.endswith("\\"), ""
            for token in tokens:
                if _KEY.fullmatch(token):
                    key = token[1:]
                    entry.values[key] = Given("", number)
                elif key and not entry.values[key].text:
                    entry.values[key] = Given(printable(token.strip('"')), number)
                else:
                    odd.append(number)
        if odd:
            more = f" and {len(odd) - 1} more lines" if len(odd) > 1 else ""
            self._say(odd[0], f"is not understood{more}; the entries around are read")
        if open_:
            self._say(number, "the file ends within an entry; save the backup again if it was cut off")
        if not self.sections:
            self._say(1, "holds no sections like ARM: or ROBOT:, so nothing is read from it")

    def _number(self, entry: Entry, key: str, default: float | None = None) -> float | None:
        if key not in entry.values:
            return default
        given = entry.values[key]
        try:
            value = decimal(given.text)
            if math.isfinite(value):
                return value
        except ValueError:
            pass
        self._say(given.line, f"-{key} of {entry.name} is '{given.text}', no number; it is left out")
        return default

    def _find(self, section: str, name: str) -> Entry | None:
        return next((one for one in self.sections.get(section, ()) if name and one.name == name), None)

    def _frame(self, entry: Entry) -> Array:
        p = [self._number(entry, f"base_frame_pos_{axis}", 0.0) for axis in "xyz"]
        q = np.array([self._number(entry, f"base_frame_orient_u{i}", float(i == 0)) for i in range(4)], dtype=float)
        norm = math.hypot(*q.tolist())
        if abs(norm - 1) > 0.01:
            what = f"the base frame of {entry.name} has an orientation of length {norm:.4g}"
            self._say(entry.line, f"{what}; taken as 1 0 0 0")
            q, norm = np.array([1.0, 0.0, 0.0, 0.0]), 1.0
        return pose(rotation_from_wxyz(q / norm), np.array(p, dtype=float))

    def _range(self, arm: Entry | None, most: float, unit: str) -> Range | None:
        """The working range of a joint; upper_joint_bound_max and the like are what it could be set to."""
        if arm is None:
            return None
        lower, upper = (self._number(arm, f"{end}_joint_bound") for end in ("lower", "upper"))
        if lower is None or upper is None:
            return None
        line = arm.values["lower_joint_bound"].line
        if max(-lower, upper) > most or not lower < upper:
            what = f"{lower:g} to {upper:g} {unit} is no range of {arm.name} (m and rad stand here, {most:.4g} at most)"
            self._say(line, f"{what}; it is left out")
            return None
        return Range(lower, upper, line)

    def _arm_of(self, joint: str) -> Entry | None:
        """The ARM of a joint: that which its JOINT names, or with ABB's own units that of its name or type."""
        entry = self._find("JOINT", joint)
        found = self._find("ARM", entry.text("use_arm") if entry else "") or self._find("ARM", joint)
        typed = [one for one in self.sections.get("ARM", ()) if joint and one.text("use_arm_type") == joint]
        return found or (typed[0] if len(typed) == 1 else None)

    def _slides(self, single: Entry, joint: Entry | None) -> bool | None:
        transmission = self._find("TRANSMISSION", joint.text("use_transmission") if joint else "")
        if transmission is not None:
            return "rotating_move" not in transmission.values
        kind = self._find("SINGLE_TYPE", single.text("use_single_type"))
        words = f"{'' if kind is None else kind.text('mechanics')} {single.text('use_single_type')}".upper()
        if any(word in words for word in ("TRACK", "IRBT", "LINEAR")):
            return True
        if any(one.text("base_frame_coordinated") == single.name for one in self.sections.get("ROBOT", ())):
            return True
        return False if any(word in words for word in ("ROT", "IRBP", "POS")) else None

    def _external(self, single: Entry, unit: Entry | None) -> External:
        joint = self._find("JOINT", single.text("use_joint"))
        slides = self._slides(single, joint)
        eax = None
        if joint is not None and (axis := self._number(joint, "logical_axis")) is not None:
            eax = int(axis) - _FIRST_EXTERNAL
            if axis != int(axis) or eax not in range(6):
                what = f"-logical_axis {axis:g} of {joint.name} is none of 7 to 12 (eax_a to eax_f)"
                self._say(joint.values["logical_axis"].line, f"{what}; it is left out")
                eax = None
        arm = self._arm_of(single.text("use_joint"))
        drives = self._find("DRIVE_SYSTEM", joint.text("use_drive_system") if joint else "")
        stress = self._find("STRESS_DUTY_CYCLE", drives.text("use_stress_duty_cycle") if drives else "")
        gear = self._find("TRANSMISSION", joint.text("use_transmission") if joint else "")
        motor = None if stress is None else self._number(stress, "speed_absolute_max")
        ratio = None if gear is None else self._number(gear, "transm_joint")
        acc = self._find("ACC_DATA", "" if arm is None else arm.text("use_acc_data"))
        rates = [] if acc is None else [self._number(acc, key) for key in ("wc_acc", "wc_dec")]
        known = [rate for rate in rates if rate]
        values: Mapping[str, Given] = {} if unit is None else unit.values
        return External(
            name=single.name if unit is None or "use_single_1" in values else unit.name,
            line=single.line,
            eax=eax,
            eax_line=joint.values["logical_axis"].line if joint is not None and eax is not None else single.line,
            moved_by=single.text("base_frame_coordinated"),
            range=self._range(arm, _MOST_ROUND, "rad") if slides is False else self._range(arm, _LONGEST, "m"),
            slides=slides,
            X=self._frame(single),
            velocity=abs(motor / ratio) if motor and ratio else None,
            acceleration=min(known) if known else None,
            active="activate_at_start_up" in values,
            fixed="deactivation_forbidden" in values,
        )

    def mechanics(self) -> Mechanics:
        externals: dict[str, External] = {}
        units = {
            given.text: unit
            for unit in self.sections.get("MECHANICAL_UNIT", ())
            for key, given in unit.values.items()
            if key.startswith("use_single_")
        }
        for single in self.sections.get("SINGLE", ()):
            externals[single.name] = self._external(single, units.get(single.name))
        robots, shown = tuple(self._robots(externals)), self.notices[:_MOST_SHOWN]
        if more := len(self.notices) - len(shown):
            shown.append(ProgramWarning(WarningKind.NOT_READ, f"and {more} more like these", self.file))
        return Mechanics(self.file, robots, tuple(externals.values()), tuple(shown))

    def _robots(self, externals: Mapping[str, External]) -> Iterator[ConfiguredRobot]:
        for robot in self.sections.get("ROBOT", ()):
            number = robot.name.upper().removeprefix("ROB").lstrip("_").lower()
            joints = [robot.text(f"use_joint_{i}") or f"rob{number}_{i + 1}" for i in range(6)]
            ranges = tuple(self._range(self._arm_of(joint), _MOST_TURNED, "rad") for joint in joints)
            mover = robot.text("base_frame_coordinated")
            carries = next((one for name, one in externals.items() if mover in (name, one.name) and mover), None)
            yield ConfiguredRobot(
                robot.name, robot.line, robot.text("use_robot_type"), self._frame(robot), ranges, mover, carries
            )
