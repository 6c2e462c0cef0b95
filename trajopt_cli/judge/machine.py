"""What the judge is told of the machine: limits, wishes, shapes, and where the URDF and its root stand.

Data alone: a Plant answers to this, and so does anything else that has the fields.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Protocol

from trajopt_cli.geometry import Array
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.scenario import Follower, PositionerAxis
from trajopt_cli.shapes import Grip, LinkShape, Solid


class JudgedRobot(Protocol):
    """A robot by its URDF. How it moves is the mechanism's business."""

    @property
    def urdf(self) -> Path:
        """The URDF's file."""

    @property
    def X_WR(self) -> Array:
        """Where the URDF's root stands in the world (4, 4)."""

    @property
    def X_RB(self) -> Array:
        """The arm's base in the root (4, 4) where all rails are at 0."""

    @property
    def X_UB(self) -> Array | None:
        """The arm's base in the root of its URDF (4, 4), where the cell's own axes carry it; None where the URDF's
        do."""

    @property
    def rail_axes(self) -> Array:
        """Directions (r, 3) of the rails in the root, which then is the frame of the arm's base where all are at 0."""

    @property
    def axis_names(self) -> tuple[str, ...]:
        """Of all axes, the rails' first."""

    @property
    def linkage(self) -> float:
        """Of a parallel linkage: the URDF's joint 3 is axis 3 - linkage * axis 2; 0 where joints are axes."""

    @property
    def bodies(self) -> Mapping[str, tuple[LinkShape, ...]]:
        """Around the links that have some, by link name, in the link's frame."""

    @property
    def rotor(self) -> Array:
        """Inertias of the drives as the axes feel them (k,) [kg m2, kg for a rail], 0 where nobody says."""


class Machine(Protocol):
    """A robot in its cell: limits in force, and what the user lets change."""

    @property
    def robot(self) -> JudgedRobot:
        """What stands in the cell."""

    @property
    def limits(self) -> JointLimits:
        """Of all axes, in the URDF's order."""

    @property
    def tcp(self) -> TcpCaps:
        """Caps on the tool centre point."""

    @property
    def start(self) -> Array:
        """Where the cycle begins (k,), at rest."""

    @property
    def rail_eaxes(self) -> tuple[int, ...]:
        """Which eax_x drive the rails, 0 for eax_a."""

    @property
    def followers(self) -> tuple[Follower, ...]:
        """External axes that the rails lead."""

    @property
    def rail_fixed(self) -> bool:
        """Robtargets keep their programmed rail value."""

    @property
    def free_speed(self) -> bool:
        """MoveJ and MoveAbsJ may ignore the programmed speed."""

    @property
    def droppable(self) -> frozenset[str]:
        """Target names in lower case that a plan may leave out."""

    @property
    def obstacles(self) -> tuple[Solid, ...]:
        """Bodies in the world; those that ride on a positioner as they stand with its axes at start."""

    @property
    def units(self) -> Mapping[str, tuple[PositionerAxis, ...]]:
        """Positioners by name, in lower case."""

    @property
    def attached(self) -> tuple[Solid, ...]:
        """Bodies in the flange's frame."""

    @property
    def self_pairs(self) -> tuple[tuple[str, str], ...]:
        """Links and attached bodies held against each other, the one nearer the base first."""

    @property
    def clearance(self) -> float:
        """Least distance wanted between the robot and an obstacle, m."""

    @property
    def tool_radius(self) -> float:
        """Of the capsule from flange to TCP that stands for the tool, m; 0 for none."""

    @property
    def grips(self) -> tuple[Grip, ...]:
        """Which obstacles the flange takes and leaves, and when."""
